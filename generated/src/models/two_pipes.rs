// @generated from generated/models/two_pipes.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 9d0891a8e975b587

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rows, Scalar, SetInfo,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// Two pipes in a row that carry a fluid, hanging: a garden hose with two hinges.
///
/// Rigid pipes of equal length, the first hinged to a wall and the second to the first, each hinge with a spring and
/// a damper. The speed v is that of the fluid, which leaves at the free end along the second pipe; above a critical
/// speed the pipes buckle or flutter.
///
/// Source: Hamilton's principle for a fluid that leaves the system, as Benjamin (1961) has it: Proc. R. Soc. A 261, 457-486
///
/// The fields are the parameters. The coordinates are `first` in `rad`, `second` in `rad`.
///
/// <details><summary>The formulas of its matrices</summary>
///
/// ```text
/// inertia = (m + f)*l^3 [kg*m^2]
/// weight = (m + f)*l^2 [kg*m]
/// M_11 = 4/3*inertia [kg*m^2]
/// M_12 = M_21 = 1/2*inertia [kg*m^2]
/// M_22 = 1/3*inertia [kg*m^2]
/// C0_11 = 2*c [kg*m^2/s]
/// C0_12 = C0_21 = -c [kg*m^2/s]
/// C0_22 = c [kg*m^2/s]
/// C1_11 = C1_22 = f*l^2 [kg*m]
/// C1_12 = 2*f*l^2 [kg*m]
/// Kc_11 = 2*k [kg*m^2/s^2]
/// Kc_12 = Kc_21 = -k [kg*m^2/s^2]
/// Kc_22 = k [kg*m^2/s^2]
/// K0_11 = 3/2*weight [kg*m]
/// K0_22 = 1/2*weight [kg*m]
/// K2_11 = -f*l [kg]
/// K2_12 = f*l [kg]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct TwoPipes<T = f64> {
    /// Length of each pipe.
    ///
    /// `l` in `m`: `> 0`.
    pub l: T,
    /// Mass of a pipe for each metre.
    ///
    /// `m` in `kg/m`: `> 0`.
    pub m: T,
    /// Mass of the fluid in it for each metre.
    ///
    /// `f` in `kg/m`: `>= 0`.
    pub f: T,
    /// Stiffness of each hinge.
    ///
    /// `k` in `N*m/rad`: `>= 0`.
    pub k: T,
    /// Damping of each hinge.
    ///
    /// `c` in `N*m*s/rad`: `>= 0`.
    pub c: T,
    /// Gravitational field strength.
    ///
    /// `g` in `N/kg`: `>= 0`.
    pub g: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`TwoPipes`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoPipesMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C0, a coefficient of q'. Symmetric, proved.
    pub c0: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness Kc, a coefficient of q. Symmetric, proved.
    pub kc: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 2>,
}

impl<T: Number> TwoPipes<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 4 additions, 10 multiplications and 3 negations: 17 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> TwoPipesMatrices<T> {
        let t1 = self.l * self.l;
        let weight = t1 * (self.m + self.f);
        let inertia = self.l * weight;
        let M_11 = inertia * self.l.like(1.3333333333333333);
        let M_12 = inertia * self.l.like(0.5);
        let M_22 = inertia * self.l.like(0.3333333333333333);
        let C0_11 = self.c + self.c;
        let C1_11 = t1 * self.f;
        let C1_12 = C1_11 + C1_11;
        let zero = self.l.like(0.0);
        let Kc_11 = self.k + self.k;
        let K0_11 = weight * self.l.like(1.5);
        let K0_22 = weight * self.l.like(0.5);
        let K2_12 = self.l * self.f;
        let C0_12 = -self.c;
        let Kc_12 = -self.k;
        let K2_11 = -K2_12;
        TwoPipesMatrices::from_entries([
            M_11, M_12, M_12, M_22, C0_11, C0_12, C0_12, self.c, C1_11, C1_12, zero, C1_11, Kc_11,
            Kc_12, Kc_12, self.k, K0_11, zero, zero, K0_22, K2_11, K2_12, zero, zero,
        ])
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`TwoPipes`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoPipesDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 19],
}

impl<T: Number> TwoPipes<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 6 additions, 20 multiplications and 3 negations: 29 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (TwoPipesMatrices<T>, TwoPipesDerivatives<T>) {
        let zero = self.l.like(0.0);
        let mut matrices = TwoPipesMatrices::from_entries([zero; 24]);
        let mut derivatives = TwoPipesDerivatives {
            values: [zero; 19],
        };
        self.each_result(
            #[inline(always)]
            |position, value| matrices.set_entry(position, value),
            #[inline(always)]
            |position, value| derivatives.values[position] = value,
        );
        (matrices, derivatives)
    }

    /// Writes the coefficient matrices and their derivatives over others, each as soon as it is computed.
    ///
    /// They are those of [`Self::matrices_and_derivatives`], to the last bit. That function has more results than a
    /// processor has registers, and moves them twice.
    #[inline(always)]
    pub fn write_matrices_and_derivatives(
        &self,
        matrices: &mut TwoPipesMatrices<T>,
        derivatives: &mut TwoPipesDerivatives<T>,
    ) {
        *matrices = TwoPipesMatrices::from_entries([self.l.like(0.0); 24]);
        self.each_result(
            #[inline(always)]
            |position, value| {
                matrices.set_entry(position, value);
                carvallo::write_now();
            },
            #[inline(always)]
            |position, value| {
                derivatives.values[position] = value;
                carvallo::write_now();
            },
        );
    }

    /// The program: gives each entry that differs, and each value of the derivatives, to a function with its position.
    #[inline(always)]
    fn each_result(&self, mut put_entry: impl FnMut(usize, T), mut put_derivative: impl FnMut(usize, T)) {
        put_entry(5, self.c);
        put_entry(10, self.k);
        put_derivative(0, self.l);
        put_derivative(1, self.f);
        put_derivative(2, self.l.like(2.0));
        put_derivative(3, self.l.like(1.0));
        put_derivative(4, self.l.like(-1.0));
        let t15 = self.m + self.f;
        let weight_m = self.l * self.l;
        put_derivative(5, weight_m);
        let inertia_m = self.l * weight_m;
        let M_11_m = inertia_m * self.l.like(1.3333333333333333);
        put_derivative(6, M_11_m);
        let K0_22_m = weight_m * self.l.like(0.5);
        put_derivative(7, K0_22_m);
        let K0_22 = t15 * K0_22_m;
        put_entry(12, K0_22);
        let M_22_m = inertia_m * self.l.like(0.3333333333333333);
        put_derivative(8, M_22_m);
        let M_12_m = inertia_m * self.l.like(0.5);
        put_derivative(9, M_12_m);
        let C0_11 = self.c + self.c;
        put_entry(3, C0_11);
        let M_11 = t15 * M_11_m;
        put_entry(0, M_11);
        let M_12 = self.l * K0_22;
        put_entry(1, M_12);
        let M_22 = t15 * M_22_m;
        put_entry(2, M_22);
        let K2_12 = self.f * self.l;
        put_entry(14, K2_12);
        let C1_11 = self.l * K2_12;
        put_entry(6, C1_11);
        let C1_12 = C1_11 + C1_11;
        put_entry(7, C1_12);
        let Kc_11 = self.k + self.k;
        put_entry(8, Kc_11);
        let K0_22_l = t15 * self.l;
        put_derivative(10, K0_22_l);
        let weight = self.l * K0_22_l;
        put_derivative(11, weight);
        let K0_11 = weight * self.l.like(1.5);
        put_entry(11, K0_11);
        let M_11_l = weight * self.l.like(4.0);
        put_derivative(12, M_11_l);
        let M_12_l = K0_22 * self.l.like(3.0);
        put_derivative(13, M_12_l);
        let C1_11_l = K2_12 + K2_12;
        put_derivative(14, C1_11_l);
        let C1_12_l = K2_12 * self.l.like(4.0);
        put_derivative(15, C1_12_l);
        let K0_11_l = K0_22_l * self.l.like(3.0);
        put_derivative(16, K0_11_l);
        let K0_11_m = weight_m * self.l.like(1.5);
        put_derivative(17, K0_11_m);
        let C1_12_f = weight_m + weight_m;
        put_derivative(18, C1_12_f);
        let C0_12 = -self.c;
        put_entry(4, C0_12);
        let Kc_12 = -self.k;
        put_entry(9, Kc_12);
        let K2_11 = -K2_12;
        put_entry(13, K2_11);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl TwoPipes<f64> {
    /// The parameter set `hose`.
    ///
    /// Source: a hose of rubber, by estimate
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `l` | 0.5 | `m` |
    /// | `m` | 0.2 | `kg/m` |
    /// | `f` | 0.3 | `kg/m` |
    /// | `k` | 0.5 | `N*m/rad` |
    /// | `c` | 0.01 | `N*m*s/rad` |
    /// | `g` | 9.81 | `N/kg` |
    pub const HOSE: Self = Self {
        l: 0.5, m: 0.2, f: 0.3, k: 0.5, c: 0.01, g: 9.81,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> TwoPipes<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 6]) -> Self {
        Self {
            l: values[0], m: values[1], f: values[2], k: values[3], c: values[4], g: values[5],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 6] {
        [self.l, self.m, self.f, self.k, self.c, self.g]
    }
}

impl<T: Scalar> TwoPipes<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> TwoPipes<U> {
        let values = self.to_array();
        TwoPipes::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl TwoPipes<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> TwoPipes<f32> {
        TwoPipes::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<TwoPipes<f32>> for TwoPipes<f64> {
    fn from(parameters: TwoPipes<f32>) -> Self {
        TwoPipes::cast(&parameters)
    }
}

impl<T: Number> TwoPipesMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 24]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c0: carvallo::rows(&entries, 4),
            c1: carvallo::rows(&entries, 8),
            kc: carvallo::rows(&entries, 12),
            k0: carvallo::rows(&entries, 16),
            k2: carvallo::rows(&entries, 20),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 15] {
        [
            self.m[0][0], self.m[0][1], self.m[1][1], self.c0[0][0], self.c0[0][1], self.c0[1][1],
            self.c1[0][0], self.c1[0][1], self.kc[0][0], self.kc[0][1], self.kc[1][1],
            self.k0[0][0], self.k0[1][1], self.k2[0][0], self.k2[0][1],
        ]
    }

    /// Sets the entry at a position among those that differ, wherever it stands.
    #[inline(always)]
    fn set_entry(&mut self, position: usize, entry: T) {
        match position {
            0 => {
                self.m[0][0] = entry;
            }
            1 => {
                self.m[0][1] = entry;
                self.m[1][0] = entry;
            }
            2 => {
                self.m[1][1] = entry;
            }
            3 => {
                self.c0[0][0] = entry;
            }
            4 => {
                self.c0[0][1] = entry;
                self.c0[1][0] = entry;
            }
            5 => {
                self.c0[1][1] = entry;
            }
            6 => {
                self.c1[0][0] = entry;
                self.c1[1][1] = entry;
            }
            7 => {
                self.c1[0][1] = entry;
            }
            8 => {
                self.kc[0][0] = entry;
            }
            9 => {
                self.kc[0][1] = entry;
                self.kc[1][0] = entry;
            }
            10 => {
                self.kc[1][1] = entry;
            }
            11 => {
                self.k0[0][0] = entry;
            }
            12 => {
                self.k0[1][1] = entry;
            }
            13 => {
                self.k2[0][0] = entry;
            }
            14 => {
                self.k2[0][1] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, self.c0.0, self.c1.0, self.kc.0, self.k0.0, zeros, self.k2.0]
    }
}

impl<T: Scalar> From<TwoPipesMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: TwoPipesMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for TwoPipes<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 6];

    type Over<U: Number> = TwoPipes<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "TwoPipes",
        docs: "Two pipes in a row that carry a fluid, hanging: a garden hose with two hinges.\n\nRigid pipes of equal length, the first hinged to a wall and the second to the first, each hinge with a spring and\na damper. The speed v is that of the fluid, which leaves at the free end along the second pipe; above a critical\nspeed the pipes buckle or flutter.",
        source: "Hamilton's principle for a fluid that leaves the system, as Benjamin (1961) has it: Proc. R. Soc. A 261, 457-486",
        parameters: &[
            ParameterInfo::new("l", "m", Domain::POSITIVE).docs("Length of each pipe."),
            ParameterInfo::new("m", "kg/m", Domain::POSITIVE)
                .docs("Mass of a pipe for each metre."),
            ParameterInfo::new("f", "kg/m", Domain::NONNEGATIVE)
                .docs("Mass of the fluid in it for each metre."),
            ParameterInfo::new("k", "N*m/rad", Domain::NONNEGATIVE)
                .docs("Stiffness of each hinge."),
            ParameterInfo::new("c", "N*m*s/rad", Domain::NONNEGATIVE)
                .docs("Damping of each hinge."),
            ParameterInfo::new("g", "N/kg", Domain::NONNEGATIVE)
                .docs("Gravitational field strength."),
        ],
        coordinates: &[
            CoordinateInfo::new("first", "rad")
                .docs("Angle of the first pipe from the vertical."),
            CoordinateInfo::new("second", "rad")
                .docs("Angle of the second pipe from the vertical."),
        ],
        forces: &[],
        matrices: &[
            MatrixName::M, MatrixName::C0, MatrixName::C1, MatrixName::Kc, MatrixName::K0,
            MatrixName::K2,
        ],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]),
            EntryInfo::at(&[(MatrixName::C0, 0, 0)]),
            EntryInfo::at(&[(MatrixName::C0, 0, 1), (MatrixName::C0, 1, 0)]),
            EntryInfo::at(&[(MatrixName::C0, 1, 1)]),
            EntryInfo::at(&[(MatrixName::C1, 0, 0), (MatrixName::C1, 1, 1)]),
            EntryInfo::at(&[(MatrixName::C1, 0, 1)]),
            EntryInfo::at(&[(MatrixName::Kc, 0, 0)]),
            EntryInfo::at(&[(MatrixName::Kc, 0, 1), (MatrixName::Kc, 1, 0)]),
            EntryInfo::at(&[(MatrixName::Kc, 1, 1)]), EntryInfo::at(&[(MatrixName::K0, 0, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 1, 1)]), EntryInfo::at(&[(MatrixName::K2, 0, 0)]),
            EntryInfo::at(&[(MatrixName::K2, 0, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "hose",
                docs: "",
                source: "a hose of rubber, by estimate",
                values: &TwoPipes::to_array(&TwoPipes::<f64>::HOSE),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("inertia", "kg*m^2", "(m + f)*l^3"),
            FormulaInfo::definition("weight", "kg*m", "(m + f)*l^2"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "4/3*inertia"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)], "kg*m^2", "1/2*inertia"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "1/3*inertia"),
            FormulaInfo::entry(&[(MatrixName::C0, 0, 0)], "kg*m^2/s", "2*c"),
            FormulaInfo::entry(&[(MatrixName::C0, 0, 1), (MatrixName::C0, 1, 0)], "kg*m^2/s", "-c"),
            FormulaInfo::entry(&[(MatrixName::C0, 1, 1)], "kg*m^2/s", "c"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 0), (MatrixName::C1, 1, 1)], "kg*m", "f*l^2"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 1)], "kg*m", "2*f*l^2"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 0)], "kg*m^2/s^2", "2*k"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 1), (MatrixName::Kc, 1, 0)], "kg*m^2/s^2", "-k"),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 1)], "kg*m^2/s^2", "k"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "3/2*weight"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "1/2*weight"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 0)], "kg", "-f*l"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg", "f*l"),
        ],
        attributes: &[],
        motion: None,
        gravity: Some(5),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("TwoPipes", 6, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("TwoPipes", 6, values)?;
        values.copy_from_slice(&self.to_array());
        Ok(())
    }

    #[inline(always)]
    fn array<U: Copy>(element: impl FnMut(usize) -> U) -> Self::Array<U> {
        core::array::from_fn(element)
    }

    #[inline(always)]
    fn parameters(&self) -> Self::Array<T> {
        self.to_array()
    }

    fn validate(&self) -> Result<(), ParameterError> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.validate(&self.to_array().map(Scalar::to_f64))?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 2> {
        Coefficients::from_rows(TwoPipesMatrices::rows(&self.matrices()))
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 2>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl TwoPipes<f64> {
    /// What the model tells about itself, the same for every number type.
    pub const INFO: &'static ModelInfo = <Self as Model<2>>::INFO;

    /// The parameter set of this name, however it is spelt: upper and lower case, `_`, `-` and spaces make no
    /// difference. In `f32` it is had by the trait `Model`.
    #[must_use]
    pub fn set(name: &str) -> Option<Self> {
        <Self as Model<2>>::set(name)
    }
}

/// The parameters, one a line with its unit, in the precision that is asked for; `{:#}` says what they are.
impl<T: Scalar> core::fmt::Display for TwoPipes<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for TwoPipes<T> {
    type Entries = [T; 15];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            l: parameter(0), m: parameter(1), f: parameter(2), k: parameter(3), c: parameter(4),
            g: parameter(5),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        TwoPipesMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        TwoPipesMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> TwoPipesDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<TwoPipesMatrices<T>> {
        if parameter >= 6 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = TwoPipesMatrices {
            m: Rows([[zero; 2]; 2]), c0: Rows([[zero; 2]; 2]), c1: Rows([[zero; 2]; 2]),
            kc: Rows([[zero; 2]; 2]), k0: Rows([[zero; 2]; 2]), k2: Rows([[zero; 2]; 2]),
        };
        for position in 0..36 {
            let partial = <TwoPipesDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C0 => &mut matrices.c0,
                MatrixName::C1 => &mut matrices.c1,
                MatrixName::Kc => &mut matrices.kc,
                MatrixName::K0 => &mut matrices.k0,
                MatrixName::K2 => &mut matrices.k2,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<2> for TwoPipes<T> {
    type Derivatives = [Coefficients<T, 2>; 6];

    type WithDerivativesOver<U: Number> = TwoPipes<U>;

    const PARTIALS: &'static [Partial] = <TwoPipesDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 6];
        for position in 0..36 {
            Partial::write(&<TwoPipesDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(TwoPipesMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for TwoPipes<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl TwoPipesDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 36] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 12), Partial::new(MatrixName::M, 0, 1, 0, 13),
        Partial::new(MatrixName::M, 1, 0, 0, 13), Partial::new(MatrixName::M, 1, 1, 0, 11),
        Partial::new(MatrixName::C1, 0, 0, 0, 14), Partial::new(MatrixName::C1, 0, 1, 0, 15),
        Partial::new(MatrixName::C1, 1, 1, 0, 14), Partial::new(MatrixName::K0, 0, 0, 0, 16),
        Partial::new(MatrixName::K0, 1, 1, 0, 10),
        Partial::new(MatrixName::K2, 0, 0, 0, 1).negative(),
        Partial::new(MatrixName::K2, 0, 1, 0, 1), Partial::new(MatrixName::M, 0, 0, 1, 6),
        Partial::new(MatrixName::M, 0, 1, 1, 9), Partial::new(MatrixName::M, 1, 0, 1, 9),
        Partial::new(MatrixName::M, 1, 1, 1, 8), Partial::new(MatrixName::K0, 0, 0, 1, 17),
        Partial::new(MatrixName::K0, 1, 1, 1, 7), Partial::new(MatrixName::M, 0, 0, 2, 6),
        Partial::new(MatrixName::M, 0, 1, 2, 9), Partial::new(MatrixName::M, 1, 0, 2, 9),
        Partial::new(MatrixName::M, 1, 1, 2, 8), Partial::new(MatrixName::C1, 0, 0, 2, 5),
        Partial::new(MatrixName::C1, 0, 1, 2, 18), Partial::new(MatrixName::C1, 1, 1, 2, 5),
        Partial::new(MatrixName::K0, 0, 0, 2, 17), Partial::new(MatrixName::K0, 1, 1, 2, 7),
        Partial::new(MatrixName::K2, 0, 0, 2, 0).negative(),
        Partial::new(MatrixName::K2, 0, 1, 2, 0), Partial::new(MatrixName::Kc, 0, 0, 3, 2),
        Partial::new(MatrixName::Kc, 0, 1, 3, 4), Partial::new(MatrixName::Kc, 1, 0, 3, 4),
        Partial::new(MatrixName::Kc, 1, 1, 3, 3), Partial::new(MatrixName::C0, 0, 0, 4, 2),
        Partial::new(MatrixName::C0, 0, 1, 4, 4), Partial::new(MatrixName::C0, 1, 0, 4, 4),
        Partial::new(MatrixName::C0, 1, 1, 4, 3),
    ];
}
