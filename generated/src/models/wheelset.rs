// @generated from generated/models/wheelset.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 37c3f8eae70bff1e

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rows, Scalar, SetInfo,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A railway wheelset on its suspension, which hunts above a critical speed.
///
/// Lateral displacement and yaw of a wheelset with conical wheels on straight track at the constant speed v, restrained
/// by springs to a vehicle that does not move. Forces of creep are linear; those of gravity and of spin are left out.
/// Axes: x forward, y to the right, z down. Forces of creep are divided by the speed, so there is no motion at rest to
/// speak of.
///
/// Source: Force balance of a wheelset on springs with linear creep, as in books on railway vehicles such as Wickens (2003), Fundamentals of Rail Vehicle Dynamics
///
/// The fields are the parameters. The coordinates are `y` (lateral) in `m`, `psi` (yaw) in `rad`.
///
/// <details><summary>The formulas of its matrices</summary>
///
/// ```text
/// M_11 = m [kg]
/// M_22 = I [kg*m^2]
/// C-1_11 = 2*f22 [kg*m/s^2]
/// C-1_22 = 2*f11*b^2 [kg*m^3/s^2]
/// Kc_11 = ky [kg/s^2]
/// Kc_12 = -2*f22 [kg*m/s^2]
/// Kc_21 = 2*f11*b*lam/r [kg*m/s^2]
/// Kc_22 = kpsi [kg*m^2/s^2]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Wheelset<T = f64> {
    /// Mass.
    ///
    /// `m` in `kg`: `> 0`.
    pub m: T,
    /// Moment of inertia in yaw.
    ///
    /// `I` in `kg*m^2`: `> 0`.
    pub I: T,
    /// Longitudinal creep coefficient of a wheel.
    ///
    /// `f11` in `N`: `> 0`.
    pub f11: T,
    /// Lateral creep coefficient of a wheel.
    ///
    /// `f22` in `N`: `> 0`.
    pub f22: T,
    /// Half of the distance of the contact points.
    ///
    /// `b` in `m`: `> 0`.
    pub b: T,
    /// Conicity of the wheels.
    ///
    /// `lam`, λ, a pure number: `> 0`.
    pub lam: T,
    /// Radius of the wheels.
    ///
    /// `r` in `m`: `> 0`.
    pub r: T,
    /// Lateral stiffness of the suspension.
    ///
    /// `ky` in `N/m`: `>= 0`.
    pub ky: T,
    /// Stiffness of the suspension in yaw.
    ///
    /// `kpsi`, kψ, in `N*m/rad`: `>= 0`.
    pub kpsi: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`Wheelset`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelsetMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C-1, a coefficient of q'/v.
    pub cm1: Rows<T, 2>,
    /// Stiffness Kc, a coefficient of q.
    pub kc: Rows<T, 2>,
}

impl<T: Number> Wheelset<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 2 additions, 3 multiplications, 1 division and 1 negation: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WheelsetMatrices<T> {
        let zero = self.m.like(0.0);
        let Cm1_11 = self.f22 + self.f22;
        let t8 = self.b * (self.f11 + self.f11);
        let Cm1_22 = self.b * t8;
        let Kc_21 = t8 * self.lam / self.r;
        let Kc_12 = -Cm1_11;
        WheelsetMatrices::from_entries([
            self.m, zero, zero, self.I, Cm1_11, zero, zero, Cm1_22, self.ky, Kc_12, Kc_21,
            self.kpsi,
        ])
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`Wheelset`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelsetDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 9],
}

impl<T: Number> Wheelset<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 4 additions, 9 multiplications, 1 division and 1 negation: 15 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WheelsetMatrices<T>, WheelsetDerivatives<T>) {
        let zero = self.m.like(0.0);
        let mut matrices = WheelsetMatrices::from_entries([zero; 12]);
        let mut derivatives = WheelsetDerivatives {
            values: [zero; 9],
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
        matrices: &mut WheelsetMatrices<T>,
        derivatives: &mut WheelsetDerivatives<T>,
    ) {
        *matrices = WheelsetMatrices::from_entries([self.m.like(0.0); 12]);
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
        put_entry(0, self.m);
        put_entry(1, self.I);
        put_entry(4, self.ky);
        put_entry(7, self.kpsi);
        put_derivative(0, self.m.like(1.0));
        put_derivative(1, self.m.like(2.0));
        put_derivative(2, self.m.like(-2.0));
        let Cm1_11 = self.f22 + self.f22;
        put_entry(2, Cm1_11);
        let t14 = self.b + self.b;
        let Cm1_22_f11 = self.b * t14;
        put_derivative(3, Cm1_22_f11);
        let Cm1_22 = self.f11 * Cm1_22_f11;
        put_entry(3, Cm1_22);
        let t17 = self.f11 * t14;
        let t18 = self.m.like(1.0) / self.r;
        let Cm1_22_b = t17 + t17;
        put_derivative(4, Cm1_22_b);
        let Kc_12 = -Cm1_11;
        put_entry(5, Kc_12);
        let Kc_21_lam = t17 * t18;
        put_derivative(5, Kc_21_lam);
        let t22 = self.lam * t18;
        let Kc_21 = self.lam * Kc_21_lam;
        put_entry(6, Kc_21);
        let Kc_21_f11 = t14 * t22;
        put_derivative(6, Kc_21_f11);
        let t25 = self.f11 * t22;
        let t26 = Kc_21_lam * t22;
        put_derivative(7, t26);
        let Kc_21_b = t25 + t25;
        put_derivative(8, Kc_21_b);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl Wheelset<f64> {
    /// The parameter set `example`.
    ///
    /// Source: An example in round figures, of the size of a freight wagon's, of no vehicle that is
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `m` | 1250 | `kg` |
    /// | `I` | 700 | `kg*m^2` |
    /// | `f11` | 1e7 | `N` |
    /// | `f22` | 1e7 | `N` |
    /// | `b` | 0.7 | `m` |
    /// | `lam` | 0.15 |  |
    /// | `r` | 0.45 | `m` |
    /// | `ky` | 200000 | `N/m` |
    /// | `kpsi` | 200000 | `N*m/rad` |
    pub const EXAMPLE: Self = Self {
        m: 1250.0, I: 700.0, f11: 10000000.0, f22: 10000000.0, b: 0.7, lam: 0.15, r: 0.45,
        ky: 200000.0, kpsi: 200000.0,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> Wheelset<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 9]) -> Self {
        Self {
            m: values[0], I: values[1], f11: values[2], f22: values[3], b: values[4],
            lam: values[5], r: values[6], ky: values[7], kpsi: values[8],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 9] {
        [
            self.m, self.I, self.f11, self.f22, self.b, self.lam, self.r, self.ky, self.kpsi,
        ]
    }
}

impl<T: Scalar> Wheelset<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> Wheelset<U> {
        let values = self.to_array();
        Wheelset::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl Wheelset<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> Wheelset<f32> {
        Wheelset::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<Wheelset<f32>> for Wheelset<f64> {
    fn from(parameters: Wheelset<f32>) -> Self {
        Wheelset::cast(&parameters)
    }
}

impl<T: Number> WheelsetMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 12]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            cm1: carvallo::rows(&entries, 4),
            kc: carvallo::rows(&entries, 8),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 8] {
        [
            self.m[0][0], self.m[1][1], self.cm1[0][0], self.cm1[1][1], self.kc[0][0],
            self.kc[0][1], self.kc[1][0], self.kc[1][1],
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
                self.m[1][1] = entry;
            }
            2 => {
                self.cm1[0][0] = entry;
            }
            3 => {
                self.cm1[1][1] = entry;
            }
            4 => {
                self.kc[0][0] = entry;
            }
            5 => {
                self.kc[0][1] = entry;
            }
            6 => {
                self.kc[1][0] = entry;
            }
            7 => {
                self.kc[1][1] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, self.cm1.0, zeros, zeros, self.kc.0, zeros, zeros, zeros]
    }
}

impl<T: Scalar> From<WheelsetMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: WheelsetMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for Wheelset<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 9];

    type Over<U: Number> = Wheelset<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "Wheelset",
        docs: "A railway wheelset on its suspension, which hunts above a critical speed.\n\nLateral displacement and yaw of a wheelset with conical wheels on straight track at the constant speed v, restrained\nby springs to a vehicle that does not move. Forces of creep are linear; those of gravity and of spin are left out.\nAxes: x forward, y to the right, z down. Forces of creep are divided by the speed, so there is no motion at rest to\nspeak of.",
        source: "Force balance of a wheelset on springs with linear creep, as in books on railway vehicles such as Wickens (2003), Fundamentals of Rail Vehicle Dynamics",
        parameters: &[
            ParameterInfo::new("m", "kg", Domain::POSITIVE).docs("Mass."),
            ParameterInfo::new("I", "kg*m^2", Domain::POSITIVE)
                .docs("Moment of inertia in yaw."),
            ParameterInfo::new("f11", "N", Domain::POSITIVE)
                .docs("Longitudinal creep coefficient of a wheel."),
            ParameterInfo::new("f22", "N", Domain::POSITIVE)
                .docs("Lateral creep coefficient of a wheel."),
            ParameterInfo::new("b", "m", Domain::POSITIVE)
                .docs("Half of the distance of the contact points."),
            ParameterInfo::new("lam", "1", Domain::POSITIVE)
                .symbol("λ")
                .docs("Conicity of the wheels."),
            ParameterInfo::new("r", "m", Domain::POSITIVE).docs("Radius of the wheels."),
            ParameterInfo::new("ky", "N/m", Domain::NONNEGATIVE)
                .docs("Lateral stiffness of the suspension."),
            ParameterInfo::new("kpsi", "N*m/rad", Domain::NONNEGATIVE)
                .symbol("kψ")
                .docs("Stiffness of the suspension in yaw."),
        ],
        coordinates: &[
            CoordinateInfo::new("y", "m")
                .label("lateral")
                .docs("Lateral displacement, positive to the right."),
            CoordinateInfo::new("psi", "rad")
                .label("yaw")
                .docs("Yaw, positive to the right."),
        ],
        forces: &[],
        matrices: &[MatrixName::M, MatrixName::Cm1, MatrixName::Kc],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]), EntryInfo::at(&[(MatrixName::M, 1, 1)]),
            EntryInfo::at(&[(MatrixName::Cm1, 0, 0)]), EntryInfo::at(&[(MatrixName::Cm1, 1, 1)]),
            EntryInfo::at(&[(MatrixName::Kc, 0, 0)]), EntryInfo::at(&[(MatrixName::Kc, 0, 1)]),
            EntryInfo::at(&[(MatrixName::Kc, 1, 0)]), EntryInfo::at(&[(MatrixName::Kc, 1, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "example",
                docs: "",
                source: "An example in round figures, of the size of a freight wagon's, of no vehicle that is",
                values: &Wheelset::to_array(&Wheelset::<f64>::EXAMPLE),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg", "m"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "I"),
            FormulaInfo::entry(&[(MatrixName::Cm1, 0, 0)], "kg*m/s^2", "2*f22"),
            FormulaInfo::entry(&[(MatrixName::Cm1, 1, 1)], "kg*m^3/s^2", "2*f11*b^2"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 0)], "kg/s^2", "ky"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 1)], "kg*m/s^2", "-2*f22"),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 0)], "kg*m/s^2", "2*f11*b*lam/r"),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 1)], "kg*m^2/s^2", "kpsi"),
        ],
        attributes: &[],
        motion: None,
        gravity: None,
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("Wheelset", 9, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("Wheelset", 9, values)?;
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
        Coefficients::from_rows(WheelsetMatrices::rows(&self.matrices()))
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 2>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn gravity(&self) -> Option<T> {
        None
    }
}

impl Wheelset<f64> {
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
impl<T: Scalar> core::fmt::Display for Wheelset<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for Wheelset<T> {
    type Entries = [T; 8];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            m: parameter(0), I: parameter(1), f11: parameter(2), f22: parameter(3), b: parameter(4),
            lam: parameter(5), r: parameter(6), ky: parameter(7), kpsi: parameter(8),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        WheelsetMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        WheelsetMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> WheelsetDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<WheelsetMatrices<T>> {
        if parameter >= 9 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = WheelsetMatrices {
            m: Rows([[zero; 2]; 2]),
            cm1: Rows([[zero; 2]; 2]),
            kc: Rows([[zero; 2]; 2]),
        };
        for position in 0..12 {
            let partial = <WheelsetDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::Cm1 => &mut matrices.cm1,
                MatrixName::Kc => &mut matrices.kc,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<2> for Wheelset<T> {
    type Derivatives = [Coefficients<T, 2>; 9];

    type WithDerivativesOver<U: Number> = Wheelset<U>;

    const PARTIALS: &'static [Partial] = <WheelsetDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 9];
        for position in 0..12 {
            Partial::write(&<WheelsetDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(WheelsetMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for Wheelset<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl WheelsetDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 12] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 0), Partial::new(MatrixName::M, 1, 1, 1, 0),
        Partial::new(MatrixName::Cm1, 1, 1, 2, 3), Partial::new(MatrixName::Kc, 1, 0, 2, 6),
        Partial::new(MatrixName::Cm1, 0, 0, 3, 1), Partial::new(MatrixName::Kc, 0, 1, 3, 2),
        Partial::new(MatrixName::Cm1, 1, 1, 4, 4), Partial::new(MatrixName::Kc, 1, 0, 4, 8),
        Partial::new(MatrixName::Kc, 1, 0, 5, 5),
        Partial::new(MatrixName::Kc, 1, 0, 6, 7).negative(),
        Partial::new(MatrixName::Kc, 0, 0, 7, 0), Partial::new(MatrixName::Kc, 1, 1, 8, 0),
    ];
}
