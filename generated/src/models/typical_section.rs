// @generated from generated/models/typical_section.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 648bb7d66536ca12

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, RequirementInfo, Rows, Scalar,
    SetInfo, WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// The typical section: a rigid wing on two springs in a flow, which diverges or flutters above a critical airspeed.
///
/// Plunge and pitch of a wing of constant profile in a wind tunnel. The lift is that of a thin profile in a steady flow,
/// 2 pi times the angle of attack, at the quarter chord; what the motion itself does to the flow is left out, and with
/// it all damping, so that two pairs of imaginary eigenvalues meet where flutter begins. The speed v is that of the air.
///
/// Source: Equations of the typical section with steady lift, as in textbooks of aeroelasticity such as Hodges & Pierce, Introduction to Structural Dynamics and Aeroelasticity
///
/// The fields are the parameters. The coordinates are `h` (plunge) in `m`, `theta` (pitch) in `rad`.
///
/// Beside what is said of each field, `validate` requires of them:
///
/// - `I - m*b^2*(e - a)^2` in `kg*m^2`: `> 0`.
///
/// <details><summary>The formulas of its matrices</summary>
///
/// ```text
/// imbalance = m*b*(e - a) [kg*m]
/// lift = 2*pi*rho*b*s [kg/m]
/// arm = b*(1/2 + a) [m]
/// M_11 = m [kg]
/// M_12 = M_21 = imbalance [kg*m]
/// M_22 = I [kg*m^2]
/// Kc_11 = kh [kg/s^2]
/// Kc_22 = ktheta [kg*m^2/s^2]
/// K2_12 = lift [kg/m]
/// K2_22 = -lift*arm [kg]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct TypicalSection<T = f64> {
    /// Mass of the wing.
    ///
    /// `m` in `kg`: `> 0`.
    pub m: T,
    /// Moment of inertia about the elastic axis.
    ///
    /// `I` in `kg*m^2`: `> 0`.
    pub I: T,
    /// Semichord, half of the chord.
    ///
    /// `b` in `m`: `> 0`.
    pub b: T,
    /// Span of the wing.
    ///
    /// `s` in `m`: `> 0`.
    pub s: T,
    /// Elastic axis, behind the middle of the chord, in semichords.
    ///
    /// `a` a pure number: `>= -1 and <= 1`.
    pub a: T,
    /// Centre of mass, behind the middle of the chord, in semichords.
    ///
    /// `e` a pure number: `>= -1 and <= 1`.
    pub e: T,
    /// Stiffness of the spring in plunge.
    ///
    /// `kh` in `N/m`: `>= 0`.
    pub kh: T,
    /// Stiffness of the spring in pitch.
    ///
    /// `ktheta`, kθ, in `N*m/rad`: `>= 0`.
    pub ktheta: T,
    /// Density of the air.
    ///
    /// `rho`, ρ, in `kg/m^3`: `>= 0`.
    pub rho: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`TypicalSection`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TypicalSectionMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Stiffness Kc, a coefficient of q. Symmetric, proved.
    pub kc: Rows<T, 2>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 2>,
}

impl<T: Number> TypicalSection<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 3 additions, 7 multiplications and 1 negation: 11 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> TypicalSectionMatrices<T> {
        let imbalance = self.m * self.b * (self.e - self.a);
        let zero = self.m.like(0.0);
        let t16 = self.b * self.s * self.rho * self.m.like(3.141592653589793);
        let lift = t16 + t16;
        let K2_22 = -(self.b * lift * (self.a + self.m.like(0.5)));
        TypicalSectionMatrices::from_entries([
            self.m, imbalance, imbalance, self.I, self.kh, zero, zero, self.ktheta, zero, lift,
            zero, K2_22,
        ])
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`TypicalSection`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TypicalSectionDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 11],
}

impl<T: Number> TypicalSection<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 4 additions, 16 multiplications and 1 negation: 21 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (TypicalSectionMatrices<T>, TypicalSectionDerivatives<T>) {
        let zero = self.m.like(0.0);
        let mut matrices = TypicalSectionMatrices::from_entries([zero; 12]);
        let mut derivatives = TypicalSectionDerivatives {
            values: [zero; 11],
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
        matrices: &mut TypicalSectionMatrices<T>,
        derivatives: &mut TypicalSectionDerivatives<T>,
    ) {
        *matrices = TypicalSectionMatrices::from_entries([self.m.like(0.0); 12]);
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
        put_entry(2, self.I);
        put_entry(3, self.kh);
        put_entry(4, self.ktheta);
        put_derivative(0, self.m.like(1.0));
        let t13 = self.e - self.a;
        let M_12_m = t13 * self.b;
        put_derivative(1, M_12_m);
        let imbalance = self.m * M_12_m;
        put_entry(1, imbalance);
        let t16 = self.m.like(3.141592653589793) + self.m.like(3.141592653589793);
        let t17 = self.rho * t16;
        let lift_b = self.s * t17;
        put_derivative(2, lift_b);
        let t19 = self.a + self.m.like(0.5);
        let arm = self.b * t19;
        let M_12_b = self.m * t13;
        put_derivative(3, M_12_b);
        let lift_s = self.b * t17;
        put_derivative(4, lift_s);
        let M_12_e = self.m * self.b;
        put_derivative(5, M_12_e);
        let lift = self.b * lift_b;
        put_entry(5, lift);
        let t25 = arm * lift_s;
        put_derivative(6, t25);
        let lift_rho = self.b * self.s * t16;
        put_derivative(7, lift_rho);
        let t28 = arm * lift_rho;
        put_derivative(8, t28);
        let t30 = lift * (t19 + t19);
        put_derivative(9, t30);
        let t31 = self.b * lift;
        put_derivative(10, t31);
        let K2_22 = -(lift * arm);
        put_entry(6, K2_22);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl TypicalSection<f64> {
    /// The parameter set `dimensionless`.
    ///
    /// Source: mu = 20, r^2 = 6/25, sigma = 2/5, a = -1/5, e = -1/10; speeds are U/(b omega_theta)
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `m` | 1 | `kg` |
    /// | `I` | 0.24 | `kg*m^2` |
    /// | `b` | 1 | `m` |
    /// | `s` | 1 | `m` |
    /// | `a` | -0.2 |  |
    /// | `e` | -0.1 |  |
    /// | `kh` | 0.16 | `N/m` |
    /// | `ktheta` | 0.24 | `N*m/rad` |
    /// | `rho` | 0.015915494309189534 | `kg/m^3` |
    pub const DIMENSIONLESS: Self = Self {
        m: 1.0, I: 0.24, b: 1.0, s: 1.0, a: -0.2, e: -0.1, kh: 0.16, ktheta: 0.24,
        rho: 0.015915494309189534,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> TypicalSection<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 9]) -> Self {
        Self {
            m: values[0], I: values[1], b: values[2], s: values[3], a: values[4], e: values[5],
            kh: values[6], ktheta: values[7], rho: values[8],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 9] {
        [self.m, self.I, self.b, self.s, self.a, self.e, self.kh, self.ktheta, self.rho]
    }
}

impl<T: Scalar> TypicalSection<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> TypicalSection<U> {
        let values = self.to_array();
        TypicalSection::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl TypicalSection<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> TypicalSection<f32> {
        TypicalSection::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<TypicalSection<f32>> for TypicalSection<f64> {
    fn from(parameters: TypicalSection<f32>) -> Self {
        TypicalSection::cast(&parameters)
    }
}

impl<T: Number> TypicalSectionMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 12]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            kc: carvallo::rows(&entries, 4),
            k2: carvallo::rows(&entries, 8),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 7] {
        [
            self.m[0][0], self.m[0][1], self.m[1][1], self.kc[0][0], self.kc[1][1], self.k2[0][1],
            self.k2[1][1],
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
                self.kc[0][0] = entry;
            }
            4 => {
                self.kc[1][1] = entry;
            }
            5 => {
                self.k2[0][1] = entry;
            }
            6 => {
                self.k2[1][1] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, zeros, zeros, self.kc.0, zeros, zeros, self.k2.0]
    }
}

impl<T: Scalar> From<TypicalSectionMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: TypicalSectionMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for TypicalSection<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 9];

    type Over<U: Number> = TypicalSection<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "TypicalSection",
        docs: "The typical section: a rigid wing on two springs in a flow, which diverges or flutters above a critical airspeed.\n\nPlunge and pitch of a wing of constant profile in a wind tunnel. The lift is that of a thin profile in a steady flow,\n2 pi times the angle of attack, at the quarter chord; what the motion itself does to the flow is left out, and with\nit all damping, so that two pairs of imaginary eigenvalues meet where flutter begins. The speed v is that of the air.",
        source: "Equations of the typical section with steady lift, as in textbooks of aeroelasticity such as Hodges & Pierce, Introduction to Structural Dynamics and Aeroelasticity",
        parameters: &[
            ParameterInfo::new("m", "kg", Domain::POSITIVE).docs("Mass of the wing."),
            ParameterInfo::new("I", "kg*m^2", Domain::POSITIVE)
                .docs("Moment of inertia about the elastic axis."),
            ParameterInfo::new("b", "m", Domain::POSITIVE)
                .docs("Semichord, half of the chord."),
            ParameterInfo::new("s", "m", Domain::POSITIVE).docs("Span of the wing."),
            ParameterInfo::new(
                    "a",
                    "1",
                    Domain::between(Bound::Closed(-1.0), Bound::Closed(1.0)),
                )
                .docs("Elastic axis, behind the middle of the chord, in semichords."),
            ParameterInfo::new(
                    "e",
                    "1",
                    Domain::between(Bound::Closed(-1.0), Bound::Closed(1.0)),
                )
                .docs("Centre of mass, behind the middle of the chord, in semichords."),
            ParameterInfo::new("kh", "N/m", Domain::NONNEGATIVE)
                .docs("Stiffness of the spring in plunge."),
            ParameterInfo::new("ktheta", "N*m/rad", Domain::NONNEGATIVE)
                .symbol("kθ")
                .docs("Stiffness of the spring in pitch."),
            ParameterInfo::new("rho", "kg/m^3", Domain::NONNEGATIVE)
                .symbol("ρ")
                .docs("Density of the air."),
        ],
        coordinates: &[
            CoordinateInfo::new("h", "m")
                .label("plunge")
                .docs("Plunge of the elastic axis, positive down."),
            CoordinateInfo::new("theta", "rad")
                .label("pitch")
                .docs("Pitch, positive with the nose up."),
        ],
        forces: &[],
        matrices: &[MatrixName::M, MatrixName::Kc, MatrixName::K2],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]), EntryInfo::at(&[(MatrixName::Kc, 0, 0)]),
            EntryInfo::at(&[(MatrixName::Kc, 1, 1)]), EntryInfo::at(&[(MatrixName::K2, 0, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 1, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "dimensionless",
                docs: "",
                source: "mu = 20, r^2 = 6/25, sigma = 2/5, a = -1/5, e = -1/10; speeds are U/(b omega_theta)",
                values: &TypicalSection::to_array(&TypicalSection::<f64>::DIMENSIONLESS),
            },
        ],
        requirements: &[
            RequirementInfo::new("I - m*b^2*(e - a)^2", "kg*m^2", Domain::POSITIVE),
        ],
        formulas: &[
            FormulaInfo::definition("imbalance", "kg*m", "m*b*(e - a)"),
            FormulaInfo::definition("lift", "kg/m", "2*pi*rho*b*s"),
            FormulaInfo::definition("arm", "m", "b*(1/2 + a)"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg", "m"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)], "kg*m", "imbalance"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "I"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 0)], "kg/s^2", "kh"),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 1)], "kg*m^2/s^2", "ktheta"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg/m", "lift"),
            FormulaInfo::entry(&[(MatrixName::K2, 1, 1)], "kg", "-lift*arm"),
        ],
        attributes: &[],
        motion: None,
        gravity: None,
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("TypicalSection", 9, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("TypicalSection", 9, values)?;
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
        let t6 = self.b * (self.e - self.a);
        let t9 = self.I - self.m * t6 * t6;
        info.validate_requirements(&[Scalar::to_f64(t9)])?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 2> {
        Coefficients::from_rows(TypicalSectionMatrices::rows(&self.matrices()))
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 2>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn gravity(&self) -> Option<T> {
        None
    }
}

impl TypicalSection<f64> {
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
impl<T: Scalar> core::fmt::Display for TypicalSection<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for TypicalSection<T> {
    type Entries = [T; 7];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            m: parameter(0), I: parameter(1), b: parameter(2), s: parameter(3), a: parameter(4),
            e: parameter(5), kh: parameter(6), ktheta: parameter(7), rho: parameter(8),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        TypicalSectionMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        TypicalSectionMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> TypicalSectionDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<TypicalSectionMatrices<T>> {
        if parameter >= 9 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = TypicalSectionMatrices {
            m: Rows([[zero; 2]; 2]),
            kc: Rows([[zero; 2]; 2]),
            k2: Rows([[zero; 2]; 2]),
        };
        for position in 0..19 {
            let partial = <TypicalSectionDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::Kc => &mut matrices.kc,
                MatrixName::K2 => &mut matrices.k2,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<2> for TypicalSection<T> {
    type Derivatives = [Coefficients<T, 2>; 9];

    type WithDerivativesOver<U: Number> = TypicalSection<U>;

    const PARTIALS: &'static [Partial] = <TypicalSectionDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 9];
        for position in 0..19 {
            Partial::write(&<TypicalSectionDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(TypicalSectionMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for TypicalSection<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl TypicalSectionDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 19] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 0), Partial::new(MatrixName::M, 0, 1, 0, 1),
        Partial::new(MatrixName::M, 1, 0, 0, 1), Partial::new(MatrixName::M, 1, 1, 1, 0),
        Partial::new(MatrixName::M, 0, 1, 2, 3), Partial::new(MatrixName::M, 1, 0, 2, 3),
        Partial::new(MatrixName::K2, 0, 1, 2, 2),
        Partial::new(MatrixName::K2, 1, 1, 2, 9).negative(),
        Partial::new(MatrixName::K2, 0, 1, 3, 4),
        Partial::new(MatrixName::K2, 1, 1, 3, 6).negative(),
        Partial::new(MatrixName::M, 0, 1, 4, 5).negative(),
        Partial::new(MatrixName::M, 1, 0, 4, 5).negative(),
        Partial::new(MatrixName::K2, 1, 1, 4, 10).negative(),
        Partial::new(MatrixName::M, 0, 1, 5, 5), Partial::new(MatrixName::M, 1, 0, 5, 5),
        Partial::new(MatrixName::Kc, 0, 0, 6, 0), Partial::new(MatrixName::Kc, 1, 1, 7, 0),
        Partial::new(MatrixName::K2, 0, 1, 8, 7),
        Partial::new(MatrixName::K2, 1, 1, 8, 8).negative(),
    ];
}
