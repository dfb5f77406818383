// @generated from generated/models/three_pipes.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 92f4761ae2f6100e

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rows, Scalar, SetInfo,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// Three pipes in a row that carry a fluid, hanging: a garden hose with three hinges.
///
/// Rigid pipes of equal length, the first hinged to a wall and each other one to the one before it, each hinge with a
/// spring and a damper. The speed v is that of the fluid, which leaves at the free end along the last pipe; above a
/// critical speed the pipes buckle or flutter.
///
/// Source: Hamilton's principle for a fluid that leaves the system, as Benjamin (1961) has it: Proc. R. Soc. A 261, 457-486
///
/// The fields are the parameters. The coordinates are `first` in `rad`, `second` in `rad`, `third` in `rad`.
///
/// <details><summary>The formulas of its matrices</summary>
///
/// ```text
/// inertia = (m + f)*l^3 [kg*m^2]
/// weight = (m + f)*l^2 [kg*m]
/// M_11 = 7/3*inertia [kg*m^2]
/// M_12 = M_21 = 3/2*inertia [kg*m^2]
/// M_13 = M_23 = M_31 = M_32 = 1/2*inertia [kg*m^2]
/// M_22 = 4/3*inertia [kg*m^2]
/// M_33 = 1/3*inertia [kg*m^2]
/// C0_11 = C0_22 = 2*c [kg*m^2/s]
/// C0_12 = C0_21 = C0_23 = C0_32 = -c [kg*m^2/s]
/// C0_33 = c [kg*m^2/s]
/// C1_11 = C1_22 = C1_33 = f*l^2 [kg*m]
/// C1_12 = C1_13 = C1_23 = 2*f*l^2 [kg*m]
/// Kc_11 = Kc_22 = 2*k [kg*m^2/s^2]
/// Kc_12 = Kc_21 = Kc_23 = Kc_32 = -k [kg*m^2/s^2]
/// Kc_33 = k [kg*m^2/s^2]
/// K0_11 = 5/2*weight [kg*m]
/// K0_22 = 3/2*weight [kg*m]
/// K0_33 = 1/2*weight [kg*m]
/// K2_11 = K2_22 = -f*l [kg]
/// K2_13 = K2_23 = f*l [kg]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct ThreePipes<T = f64> {
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

/// The coefficient matrices of [`ThreePipes`], each 3 x 3 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreePipesMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 3>,
    /// Damping C0, a coefficient of q'. Symmetric, proved.
    pub c0: Rows<T, 3>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 3>,
    /// Stiffness Kc, a coefficient of q. Symmetric, proved.
    pub kc: Rows<T, 3>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 3>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 3>,
}

impl<T: Number> ThreePipes<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 4 additions, 13 multiplications and 3 negations: 20 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> ThreePipesMatrices<T> {
        let t1 = self.l * self.l;
        let weight = t1 * (self.m + self.f);
        let inertia = self.l * weight;
        let M_11 = inertia * self.l.like(2.3333333333333335);
        let M_12 = inertia * self.l.like(1.5);
        let M_13 = inertia * self.l.like(0.5);
        let M_22 = inertia * self.l.like(1.3333333333333333);
        let M_33 = inertia * self.l.like(0.3333333333333333);
        let C0_11 = self.c + self.c;
        let zero = self.l.like(0.0);
        let C1_11 = t1 * self.f;
        let C1_12 = C1_11 + C1_11;
        let Kc_11 = self.k + self.k;
        let K0_11 = weight * self.l.like(2.5);
        let K0_22 = weight * self.l.like(1.5);
        let K0_33 = weight * self.l.like(0.5);
        let K2_13 = self.l * self.f;
        let C0_12 = -self.c;
        let Kc_12 = -self.k;
        let K2_11 = -K2_13;
        ThreePipesMatrices::from_entries([
            M_11, M_12, M_13, M_12, M_22, M_13, M_13, M_13, M_33, C0_11, C0_12, zero, C0_12, C0_11,
            C0_12, zero, C0_12, self.c, C1_11, C1_12, C1_12, zero, C1_11, C1_12, zero, zero, C1_11,
            Kc_11, Kc_12, zero, Kc_12, Kc_11, Kc_12, zero, Kc_12, self.k, K0_11, zero, zero, zero,
            K0_22, zero, zero, zero, K0_33, K2_11, zero, K2_13, zero, K2_11, K2_13, zero, zero,
            zero,
        ])
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`ThreePipes`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreePipesDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 25],
}

impl<T: Number> ThreePipes<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 7 additions, 30 multiplications and 3 negations: 40 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (ThreePipesMatrices<T>, ThreePipesDerivatives<T>) {
        let zero = self.l.like(0.0);
        let mut matrices = ThreePipesMatrices::from_entries([zero; 54]);
        let mut derivatives = ThreePipesDerivatives {
            values: [zero; 25],
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
        matrices: &mut ThreePipesMatrices<T>,
        derivatives: &mut ThreePipesDerivatives<T>,
    ) {
        *matrices = ThreePipesMatrices::from_entries([self.l.like(0.0); 54]);
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
        put_entry(7, self.c);
        put_entry(12, self.k);
        put_derivative(0, self.l);
        put_derivative(1, self.f);
        put_derivative(2, self.l.like(2.0));
        put_derivative(3, self.l.like(1.0));
        put_derivative(4, self.l.like(-1.0));
        let t17 = self.m + self.f;
        let weight_m = self.l * self.l;
        put_derivative(5, weight_m);
        let inertia_m = self.l * weight_m;
        let M_11_m = inertia_m * self.l.like(2.3333333333333335);
        put_derivative(6, M_11_m);
        let K0_33_l = t17 * self.l;
        put_derivative(7, K0_33_l);
        let K0_22_m = weight_m * self.l.like(1.5);
        put_derivative(8, K0_22_m);
        let M_12 = K0_33_l * K0_22_m;
        put_entry(1, M_12);
        let K0_22 = t17 * K0_22_m;
        put_entry(14, K0_22);
        let weight = self.l * K0_33_l;
        put_derivative(9, weight);
        let M_11 = t17 * M_11_m;
        put_entry(0, M_11);
        let K0_33 = self.l.like(0.5) * weight;
        put_entry(15, K0_33);
        let C0_11 = self.c + self.c;
        put_entry(5, C0_11);
        let Kc_11 = self.k + self.k;
        put_entry(10, Kc_11);
        let K0_11 = weight * self.l.like(2.5);
        put_entry(13, K0_11);
        let inertia_l = weight * self.l.like(3.0);
        let weight_l = K0_33_l + K0_33_l;
        let K0_11_l = self.l.like(2.5) * weight_l;
        put_derivative(10, K0_11_l);
        let K0_22_l = self.l.like(1.5) * weight_l;
        put_derivative(11, K0_22_l);
        let M_13 = self.l * K0_33;
        put_entry(2, M_13);
        let M_22_m = inertia_m * self.l.like(1.3333333333333333);
        put_derivative(12, M_22_m);
        let M_22 = t17 * M_22_m;
        put_entry(3, M_22);
        let M_33_m = inertia_m * self.l.like(0.3333333333333333);
        put_derivative(13, M_33_m);
        let M_33 = t17 * M_33_m;
        put_entry(4, M_33);
        let C1_11 = self.f * weight_m;
        put_entry(8, C1_11);
        let C1_12 = C1_11 + C1_11;
        put_entry(9, C1_12);
        let K2_13 = self.f * self.l;
        put_entry(17, K2_13);
        let M_11_l = self.l.like(2.3333333333333335) * inertia_l;
        put_derivative(14, M_11_l);
        let M_12_l = self.l.like(1.5) * inertia_l;
        put_derivative(15, M_12_l);
        let M_13_l = self.l.like(0.5) * inertia_l;
        put_derivative(16, M_13_l);
        let M_22_l = self.l.like(1.3333333333333333) * inertia_l;
        put_derivative(17, M_22_l);
        let C1_11_l = K2_13 + K2_13;
        put_derivative(18, C1_11_l);
        let C1_12_l = K2_13 * self.l.like(4.0);
        put_derivative(19, C1_12_l);
        let M_12_m = inertia_m * self.l.like(1.5);
        put_derivative(20, M_12_m);
        let K0_33_m = weight_m * self.l.like(0.5);
        put_derivative(21, K0_33_m);
        let M_13_m = self.l * K0_33_m;
        put_derivative(22, M_13_m);
        let K0_11_m = weight_m * self.l.like(2.5);
        put_derivative(23, K0_11_m);
        let C1_12_f = weight_m + weight_m;
        put_derivative(24, C1_12_f);
        let C0_12 = -self.c;
        put_entry(6, C0_12);
        let Kc_12 = -self.k;
        put_entry(11, Kc_12);
        let K2_11 = -K2_13;
        put_entry(16, K2_11);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl ThreePipes<f64> {
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

impl<T: Number> ThreePipes<T> {
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

impl<T: Scalar> ThreePipes<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> ThreePipes<U> {
        let values = self.to_array();
        ThreePipes::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl ThreePipes<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> ThreePipes<f32> {
        ThreePipes::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<ThreePipes<f32>> for ThreePipes<f64> {
    fn from(parameters: ThreePipes<f32>) -> Self {
        ThreePipes::cast(&parameters)
    }
}

impl<T: Number> ThreePipesMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 54]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c0: carvallo::rows(&entries, 9),
            c1: carvallo::rows(&entries, 18),
            kc: carvallo::rows(&entries, 27),
            k0: carvallo::rows(&entries, 36),
            k2: carvallo::rows(&entries, 45),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 18] {
        [
            self.m[0][0], self.m[0][1], self.m[0][2], self.m[1][1], self.m[2][2], self.c0[0][0],
            self.c0[0][1], self.c0[2][2], self.c1[0][0], self.c1[0][1], self.kc[0][0],
            self.kc[0][1], self.kc[2][2], self.k0[0][0], self.k0[1][1], self.k0[2][2],
            self.k2[0][0], self.k2[0][2],
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
                self.m[0][2] = entry;
                self.m[1][2] = entry;
                self.m[2][0] = entry;
                self.m[2][1] = entry;
            }
            3 => {
                self.m[1][1] = entry;
            }
            4 => {
                self.m[2][2] = entry;
            }
            5 => {
                self.c0[0][0] = entry;
                self.c0[1][1] = entry;
            }
            6 => {
                self.c0[0][1] = entry;
                self.c0[1][0] = entry;
                self.c0[1][2] = entry;
                self.c0[2][1] = entry;
            }
            7 => {
                self.c0[2][2] = entry;
            }
            8 => {
                self.c1[0][0] = entry;
                self.c1[1][1] = entry;
                self.c1[2][2] = entry;
            }
            9 => {
                self.c1[0][1] = entry;
                self.c1[0][2] = entry;
                self.c1[1][2] = entry;
            }
            10 => {
                self.kc[0][0] = entry;
                self.kc[1][1] = entry;
            }
            11 => {
                self.kc[0][1] = entry;
                self.kc[1][0] = entry;
                self.kc[1][2] = entry;
                self.kc[2][1] = entry;
            }
            12 => {
                self.kc[2][2] = entry;
            }
            13 => {
                self.k0[0][0] = entry;
            }
            14 => {
                self.k0[1][1] = entry;
            }
            15 => {
                self.k0[2][2] = entry;
            }
            16 => {
                self.k2[0][0] = entry;
                self.k2[1][1] = entry;
            }
            17 => {
                self.k2[0][2] = entry;
                self.k2[1][2] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 3]; 3]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 3]; 3];
        [self.m.0, zeros, self.c0.0, self.c1.0, self.kc.0, self.k0.0, zeros, self.k2.0]
    }
}

impl<T: Scalar> From<ThreePipesMatrices<T>> for Coefficients<T, 3> {
    fn from(matrices: ThreePipesMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<3> for ThreePipes<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 6];

    type Over<U: Number> = ThreePipes<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "ThreePipes",
        docs: "Three pipes in a row that carry a fluid, hanging: a garden hose with three hinges.\n\nRigid pipes of equal length, the first hinged to a wall and each other one to the one before it, each hinge with a\nspring and a damper. The speed v is that of the fluid, which leaves at the free end along the last pipe; above a\ncritical speed the pipes buckle or flutter.",
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
            CoordinateInfo::new("third", "rad")
                .docs("Angle of the third pipe from the vertical."),
        ],
        forces: &[],
        matrices: &[
            MatrixName::M, MatrixName::C0, MatrixName::C1, MatrixName::Kc, MatrixName::K0,
            MatrixName::K2,
        ],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)]),
            EntryInfo::at(
                &[
                    (MatrixName::M, 0, 2), (MatrixName::M, 1, 2), (MatrixName::M, 2, 0),
                    (MatrixName::M, 2, 1),
                ],
            ),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]),
            EntryInfo::at(&[(MatrixName::M, 2, 2)]),
            EntryInfo::at(&[(MatrixName::C0, 0, 0), (MatrixName::C0, 1, 1)]),
            EntryInfo::at(
                &[
                    (MatrixName::C0, 0, 1), (MatrixName::C0, 1, 0), (MatrixName::C0, 1, 2),
                    (MatrixName::C0, 2, 1),
                ],
            ),
            EntryInfo::at(&[(MatrixName::C0, 2, 2)]),
            EntryInfo::at(&[(MatrixName::C1, 0, 0), (MatrixName::C1, 1, 1), (MatrixName::C1, 2, 2)]),
            EntryInfo::at(&[(MatrixName::C1, 0, 1), (MatrixName::C1, 0, 2), (MatrixName::C1, 1, 2)]),
            EntryInfo::at(&[(MatrixName::Kc, 0, 0), (MatrixName::Kc, 1, 1)]),
            EntryInfo::at(
                &[
                    (MatrixName::Kc, 0, 1), (MatrixName::Kc, 1, 0), (MatrixName::Kc, 1, 2),
                    (MatrixName::Kc, 2, 1),
                ],
            ),
            EntryInfo::at(&[(MatrixName::Kc, 2, 2)]), EntryInfo::at(&[(MatrixName::K0, 0, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 1, 1)]), EntryInfo::at(&[(MatrixName::K0, 2, 2)]),
            EntryInfo::at(&[(MatrixName::K2, 0, 0), (MatrixName::K2, 1, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 0, 2), (MatrixName::K2, 1, 2)]),
        ],
        sets: &[
            SetInfo {
                name: "hose",
                docs: "",
                source: "a hose of rubber, by estimate",
                values: &ThreePipes::to_array(&ThreePipes::<f64>::HOSE),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("inertia", "kg*m^2", "(m + f)*l^3"),
            FormulaInfo::definition("weight", "kg*m", "(m + f)*l^2"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "7/3*inertia"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)], "kg*m^2", "3/2*inertia"),
            FormulaInfo::entry(
                &[
                    (MatrixName::M, 0, 2), (MatrixName::M, 1, 2), (MatrixName::M, 2, 0),
                    (MatrixName::M, 2, 1),
                ],
                "kg*m^2",
                "1/2*inertia",
            ),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "4/3*inertia"),
            FormulaInfo::entry(&[(MatrixName::M, 2, 2)], "kg*m^2", "1/3*inertia"),
            FormulaInfo::entry(&[(MatrixName::C0, 0, 0), (MatrixName::C0, 1, 1)], "kg*m^2/s", "2*c"),
            FormulaInfo::entry(
                &[
                    (MatrixName::C0, 0, 1), (MatrixName::C0, 1, 0), (MatrixName::C0, 1, 2),
                    (MatrixName::C0, 2, 1),
                ],
                "kg*m^2/s",
                "-c",
            ),
            FormulaInfo::entry(&[(MatrixName::C0, 2, 2)], "kg*m^2/s", "c"),
            FormulaInfo::entry(
                &[
                    (MatrixName::C1, 0, 0),
                    (MatrixName::C1, 1, 1),
                    (MatrixName::C1, 2, 2),
                ],
                "kg*m",
                "f*l^2",
            ),
            FormulaInfo::entry(
                &[
                    (MatrixName::C1, 0, 1),
                    (MatrixName::C1, 0, 2),
                    (MatrixName::C1, 1, 2),
                ],
                "kg*m",
                "2*f*l^2",
            ),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 0), (MatrixName::Kc, 1, 1)], "kg*m^2/s^2", "2*k"),
            FormulaInfo::entry(
                &[
                    (MatrixName::Kc, 0, 1), (MatrixName::Kc, 1, 0), (MatrixName::Kc, 1, 2),
                    (MatrixName::Kc, 2, 1),
                ],
                "kg*m^2/s^2",
                "-k",
            ),
            FormulaInfo::entry(&[(MatrixName::Kc, 2, 2)], "kg*m^2/s^2", "k"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "5/2*weight"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "3/2*weight"),
            FormulaInfo::entry(&[(MatrixName::K0, 2, 2)], "kg*m", "1/2*weight"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 0), (MatrixName::K2, 1, 1)], "kg", "-f*l"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 2), (MatrixName::K2, 1, 2)], "kg", "f*l"),
        ],
        attributes: &[],
        motion: None,
        gravity: Some(5),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("ThreePipes", 6, values)?;
        Ok(<Self as Evaluator<T, 3>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("ThreePipes", 6, values)?;
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
        let info = const { &<Self as Model<3>>::INFO.without_formulas() };
        info.validate(&self.to_array().map(Scalar::to_f64))?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 3> {
        Coefficients::from_rows(ThreePipesMatrices::rows(&self.matrices()))
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 3>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl ThreePipes<f64> {
    /// What the model tells about itself, the same for every number type.
    pub const INFO: &'static ModelInfo = <Self as Model<3>>::INFO;

    /// The parameter set of this name, however it is spelt: upper and lower case, `_`, `-` and spaces make no
    /// difference. In `f32` it is had by the trait `Model`.
    #[must_use]
    pub fn set(name: &str) -> Option<Self> {
        <Self as Model<3>>::set(name)
    }
}

/// The parameters, one a line with its unit, in the precision that is asked for; `{:#}` says what they are.
impl<T: Scalar> core::fmt::Display for ThreePipes<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<3>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 3> for ThreePipes<T> {
    type Entries = [T; 18];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            l: parameter(0), m: parameter(1), f: parameter(2), k: parameter(3), c: parameter(4),
            g: parameter(5),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        ThreePipesMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 3]; 3]; 8] {
        ThreePipesMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> ThreePipesDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<ThreePipesMatrices<T>> {
        if parameter >= 6 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = ThreePipesMatrices {
            m: Rows([[zero; 3]; 3]), c0: Rows([[zero; 3]; 3]), c1: Rows([[zero; 3]; 3]),
            kc: Rows([[zero; 3]; 3]), k0: Rows([[zero; 3]; 3]), k2: Rows([[zero; 3]; 3]),
        };
        for position in 0..70 {
            let partial = <ThreePipesDerivatives>::PARTIALS[position];
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

impl<T: Scalar> Differentiable<3> for ThreePipes<T> {
    type Derivatives = [Coefficients<T, 3>; 6];

    type WithDerivativesOver<U: Number> = ThreePipes<U>;

    const PARTIALS: &'static [Partial] = <ThreePipesDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 3>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 3]; 3]; 8]); 6];
        for position in 0..70 {
            Partial::write(&<ThreePipesDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(ThreePipesMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 3> for ThreePipes<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl ThreePipesDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 70] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 14), Partial::new(MatrixName::M, 0, 1, 0, 15),
        Partial::new(MatrixName::M, 0, 2, 0, 16), Partial::new(MatrixName::M, 1, 0, 0, 15),
        Partial::new(MatrixName::M, 1, 1, 0, 17), Partial::new(MatrixName::M, 1, 2, 0, 16),
        Partial::new(MatrixName::M, 2, 0, 0, 16), Partial::new(MatrixName::M, 2, 1, 0, 16),
        Partial::new(MatrixName::M, 2, 2, 0, 9), Partial::new(MatrixName::C1, 0, 0, 0, 18),
        Partial::new(MatrixName::C1, 0, 1, 0, 19), Partial::new(MatrixName::C1, 0, 2, 0, 19),
        Partial::new(MatrixName::C1, 1, 1, 0, 18), Partial::new(MatrixName::C1, 1, 2, 0, 19),
        Partial::new(MatrixName::C1, 2, 2, 0, 18), Partial::new(MatrixName::K0, 0, 0, 0, 10),
        Partial::new(MatrixName::K0, 1, 1, 0, 11), Partial::new(MatrixName::K0, 2, 2, 0, 7),
        Partial::new(MatrixName::K2, 0, 0, 0, 1).negative(),
        Partial::new(MatrixName::K2, 0, 2, 0, 1),
        Partial::new(MatrixName::K2, 1, 1, 0, 1).negative(),
        Partial::new(MatrixName::K2, 1, 2, 0, 1), Partial::new(MatrixName::M, 0, 0, 1, 6),
        Partial::new(MatrixName::M, 0, 1, 1, 20), Partial::new(MatrixName::M, 0, 2, 1, 22),
        Partial::new(MatrixName::M, 1, 0, 1, 20), Partial::new(MatrixName::M, 1, 1, 1, 12),
        Partial::new(MatrixName::M, 1, 2, 1, 22), Partial::new(MatrixName::M, 2, 0, 1, 22),
        Partial::new(MatrixName::M, 2, 1, 1, 22), Partial::new(MatrixName::M, 2, 2, 1, 13),
        Partial::new(MatrixName::K0, 0, 0, 1, 23), Partial::new(MatrixName::K0, 1, 1, 1, 8),
        Partial::new(MatrixName::K0, 2, 2, 1, 21), Partial::new(MatrixName::M, 0, 0, 2, 6),
        Partial::new(MatrixName::M, 0, 1, 2, 20), Partial::new(MatrixName::M, 0, 2, 2, 22),
        Partial::new(MatrixName::M, 1, 0, 2, 20), Partial::new(MatrixName::M, 1, 1, 2, 12),
        Partial::new(MatrixName::M, 1, 2, 2, 22), Partial::new(MatrixName::M, 2, 0, 2, 22),
        Partial::new(MatrixName::M, 2, 1, 2, 22), Partial::new(MatrixName::M, 2, 2, 2, 13),
        Partial::new(MatrixName::C1, 0, 0, 2, 5), Partial::new(MatrixName::C1, 0, 1, 2, 24),
        Partial::new(MatrixName::C1, 0, 2, 2, 24), Partial::new(MatrixName::C1, 1, 1, 2, 5),
        Partial::new(MatrixName::C1, 1, 2, 2, 24), Partial::new(MatrixName::C1, 2, 2, 2, 5),
        Partial::new(MatrixName::K0, 0, 0, 2, 23), Partial::new(MatrixName::K0, 1, 1, 2, 8),
        Partial::new(MatrixName::K0, 2, 2, 2, 21),
        Partial::new(MatrixName::K2, 0, 0, 2, 0).negative(),
        Partial::new(MatrixName::K2, 0, 2, 2, 0),
        Partial::new(MatrixName::K2, 1, 1, 2, 0).negative(),
        Partial::new(MatrixName::K2, 1, 2, 2, 0), Partial::new(MatrixName::Kc, 0, 0, 3, 2),
        Partial::new(MatrixName::Kc, 0, 1, 3, 4), Partial::new(MatrixName::Kc, 1, 0, 3, 4),
        Partial::new(MatrixName::Kc, 1, 1, 3, 2), Partial::new(MatrixName::Kc, 1, 2, 3, 4),
        Partial::new(MatrixName::Kc, 2, 1, 3, 4), Partial::new(MatrixName::Kc, 2, 2, 3, 3),
        Partial::new(MatrixName::C0, 0, 0, 4, 2), Partial::new(MatrixName::C0, 0, 1, 4, 4),
        Partial::new(MatrixName::C0, 1, 0, 4, 4), Partial::new(MatrixName::C0, 1, 1, 4, 2),
        Partial::new(MatrixName::C0, 1, 2, 4, 4), Partial::new(MatrixName::C0, 2, 1, 4, 4),
        Partial::new(MatrixName::C0, 2, 2, 4, 3),
    ];
}
