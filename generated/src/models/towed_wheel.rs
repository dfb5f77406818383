// @generated from generated/models/towed_wheel.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 7f4879efbc67535d

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rows, Scalar, SetInfo, States,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A towed wheel that shimmies.
///
/// A caster whose king pin is held by a lateral spring to a vehicle that runs straight at the speed v. The wheel does not
/// slip sideways, so its lateral place moves as its yaw says: `y' = v psi`, a coordinate of first order. Whether it
/// shimmies depends on the geometry and not on the speed: it is stable for `a (l - a) > I/m`.
///
/// Source: Schwab & Meijaard (2003), Dynamics of flexible multibody systems with non-holonomic constraints, Multibody System Dynamics 10, 107-123
///
/// The fields are the parameters. The coordinates are `psi` (yaw) in `rad`; `y` (place) in `m`, of first order: only its position is a state.
///
/// <details><summary>The formulas of its matrices</summary>
///
/// ```text
/// M_11 = I + m*a^2 [kg*m^2]
/// C0_22 = 1 [1]
/// C1_11 = m*a [kg*m]
/// Kc_11 = l^2*k [kg*m^2/s^2]
/// Kc_12 = l*k [kg*m/s^2]
/// K1_21 = -1 [1]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct TowedWheel<T = f64> {
    /// Mass of wheel and fork.
    ///
    /// `m` in `kg`: `> 0`.
    pub m: T,
    /// Moment of inertia of wheel and fork about their centre of mass, in yaw.
    ///
    /// `I` in `kg*m^2`: `> 0`.
    pub I: T,
    /// From the contact point of the wheel forward to the king pin.
    ///
    /// `l` in `m`: `> 0`.
    pub l: T,
    /// From the contact point of the wheel forward to the centre of mass.
    ///
    /// `a` in `m`: any finite value.
    pub a: T,
    /// Lateral stiffness of the support of the king pin.
    ///
    /// `k` in `N/m`: `> 0`.
    pub k: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`TowedWheel`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TowedWheelMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''.
    pub m: Rows<T, 2>,
    /// Damping C0, a coefficient of q'.
    pub c0: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness Kc, a coefficient of q.
    pub kc: Rows<T, 2>,
    /// Stiffness K1, a coefficient of v q.
    pub k1: Rows<T, 2>,
}

impl<T: Number> TowedWheel<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 1 addition and 4 multiplications: 5 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> TowedWheelMatrices<T> {
        let C1_11 = self.a * self.m;
        let M_11 = self.I + self.a * C1_11;
        let zero = self.m.like(0.0);
        let Kc_12 = self.l * self.k;
        let Kc_11 = self.l * Kc_12;
        TowedWheelMatrices::from_entries([
            M_11, zero, zero, zero, zero, zero, zero, self.m.like(1.0), C1_11, zero, zero, zero,
            Kc_11, Kc_12, zero, zero, zero, zero, self.m.like(-1.0), zero,
        ])
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`TowedWheel`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TowedWheelDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 9],
}

impl<T: Number> TowedWheel<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 3 additions and 6 multiplications: 9 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (TowedWheelMatrices<T>, TowedWheelDerivatives<T>) {
        let zero = self.m.like(0.0);
        let mut matrices = TowedWheelMatrices::from_entries([zero; 20]);
        let mut derivatives = TowedWheelDerivatives {
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
        matrices: &mut TowedWheelMatrices<T>,
        derivatives: &mut TowedWheelDerivatives<T>,
    ) {
        *matrices = TowedWheelMatrices::from_entries([self.m.like(0.0); 20]);
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
        put_entry(1, self.m.like(1.0));
        put_entry(5, self.m.like(-1.0));
        put_derivative(0, self.m);
        put_derivative(1, self.l);
        put_derivative(2, self.a);
        put_derivative(3, self.k);
        put_derivative(4, self.m.like(1.0));
        let M_11_m = self.a * self.a;
        put_derivative(5, M_11_m);
        let M_11 = self.I + self.m * M_11_m;
        put_entry(0, M_11);
        let C1_11 = self.m * self.a;
        put_entry(2, C1_11);
        let Kc_11_k = self.l * self.l;
        put_derivative(6, Kc_11_k);
        let Kc_11 = self.k * Kc_11_k;
        put_entry(3, Kc_11);
        let Kc_12 = self.k * self.l;
        put_entry(4, Kc_12);
        let Kc_11_l = Kc_12 + Kc_12;
        put_derivative(7, Kc_11_l);
        let M_11_a = C1_11 + C1_11;
        put_derivative(8, M_11_a);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl TowedWheel<f64> {
    /// The parameter set `example`.
    ///
    /// Source: Schwab & Meijaard (2003): k = 0.3 m/s^2, I = 0.21 m l^2, with the centre of mass in the middle
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `m` | 5 | `kg` |
    /// | `I` | 1.05 | `kg*m^2` |
    /// | `l` | 1 | `m` |
    /// | `a` | 0.5 | `m` |
    /// | `k` | 1.5 | `N/m` |
    pub const EXAMPLE: Self = Self {
        m: 5.0, I: 1.05, l: 1.0, a: 0.5, k: 1.5,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> TowedWheel<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 5]) -> Self {
        Self {
            m: values[0], I: values[1], l: values[2], a: values[3], k: values[4],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 5] {
        [self.m, self.I, self.l, self.a, self.k]
    }
}

impl<T: Scalar> TowedWheel<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> TowedWheel<U> {
        let values = self.to_array();
        TowedWheel::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl TowedWheel<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> TowedWheel<f32> {
        TowedWheel::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<TowedWheel<f32>> for TowedWheel<f64> {
    fn from(parameters: TowedWheel<f32>) -> Self {
        TowedWheel::cast(&parameters)
    }
}

impl<T: Number> TowedWheelMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 20]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c0: carvallo::rows(&entries, 4),
            c1: carvallo::rows(&entries, 8),
            kc: carvallo::rows(&entries, 12),
            k1: carvallo::rows(&entries, 16),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 6] {
        [
            self.m[0][0], self.c0[1][1], self.c1[0][0], self.kc[0][0], self.kc[0][1], self.k1[1][0],
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
                self.c0[1][1] = entry;
            }
            2 => {
                self.c1[0][0] = entry;
            }
            3 => {
                self.kc[0][0] = entry;
            }
            4 => {
                self.kc[0][1] = entry;
            }
            5 => {
                self.k1[1][0] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, self.c0.0, self.c1.0, self.kc.0, zeros, self.k1.0, zeros]
    }
}

impl<T: Scalar> From<TowedWheelMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: TowedWheelMatrices<T>) -> Self {
        Coefficients {
            states: [States::Both, States::Position],
            ..Coefficients::from_rows(matrices.rows())
        }
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for TowedWheel<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 5];

    type Over<U: Number> = TowedWheel<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "TowedWheel",
        docs: "A towed wheel that shimmies.\n\nA caster whose king pin is held by a lateral spring to a vehicle that runs straight at the speed v. The wheel does not\nslip sideways, so its lateral place moves as its yaw says: `y' = v psi`, a coordinate of first order. Whether it\nshimmies depends on the geometry and not on the speed: it is stable for `a (l - a) > I/m`.",
        source: "Schwab & Meijaard (2003), Dynamics of flexible multibody systems with non-holonomic constraints, Multibody System Dynamics 10, 107-123",
        parameters: &[
            ParameterInfo::new("m", "kg", Domain::POSITIVE)
                .docs("Mass of wheel and fork."),
            ParameterInfo::new("I", "kg*m^2", Domain::POSITIVE)
                .docs("Moment of inertia of wheel and fork about their centre of mass, in yaw."),
            ParameterInfo::new("l", "m", Domain::POSITIVE)
                .docs("From the contact point of the wheel forward to the king pin."),
            ParameterInfo::new("a", "m", Domain::FINITE)
                .docs("From the contact point of the wheel forward to the centre of mass."),
            ParameterInfo::new("k", "N/m", Domain::POSITIVE)
                .docs("Lateral stiffness of the support of the king pin."),
        ],
        coordinates: &[
            CoordinateInfo::new("psi", "rad")
                .label("yaw")
                .docs("Yaw of the wheel, positive to the right."),
            CoordinateInfo::new("y", "m")
                .label("place")
                .docs("Lateral place of the contact point, positive to the right.")
                .states(States::Position),
        ],
        forces: &[],
        matrices: &[
            MatrixName::M, MatrixName::C0, MatrixName::C1, MatrixName::Kc, MatrixName::K1,
        ],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]), EntryInfo::at(&[(MatrixName::C0, 1, 1)]),
            EntryInfo::at(&[(MatrixName::C1, 0, 0)]), EntryInfo::at(&[(MatrixName::Kc, 0, 0)]),
            EntryInfo::at(&[(MatrixName::Kc, 0, 1)]), EntryInfo::at(&[(MatrixName::K1, 1, 0)]),
        ],
        sets: &[
            SetInfo {
                name: "example",
                docs: "",
                source: "Schwab & Meijaard (2003): k = 0.3 m/s^2, I = 0.21 m l^2, with the centre of mass in the middle",
                values: &TowedWheel::to_array(&TowedWheel::<f64>::EXAMPLE),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "I + m*a^2"),
            FormulaInfo::entry(&[(MatrixName::C0, 1, 1)], "1", "1"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 0)], "kg*m", "m*a"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 0)], "kg*m^2/s^2", "l^2*k"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 1)], "kg*m/s^2", "l*k"),
            FormulaInfo::entry(&[(MatrixName::K1, 1, 0)], "1", "-1"),
        ],
        attributes: &[],
        motion: None,
        gravity: None,
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("TowedWheel", 5, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("TowedWheel", 5, values)?;
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
        Coefficients {
            states: [States::Both, States::Position],
            ..Coefficients::from_rows(TowedWheelMatrices::rows(&self.matrices()))
        }
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 2>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn gravity(&self) -> Option<T> {
        None
    }
}

impl TowedWheel<f64> {
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
impl<T: Scalar> core::fmt::Display for TowedWheel<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for TowedWheel<T> {
    type Entries = [T; 6];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            m: parameter(0), I: parameter(1), l: parameter(2), a: parameter(3), k: parameter(4),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        TowedWheelMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        TowedWheelMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> TowedWheelDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<TowedWheelMatrices<T>> {
        if parameter >= 5 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = TowedWheelMatrices {
            m: Rows([[zero; 2]; 2]), c0: Rows([[zero; 2]; 2]), c1: Rows([[zero; 2]; 2]),
            kc: Rows([[zero; 2]; 2]), k1: Rows([[zero; 2]; 2]),
        };
        for position in 0..9 {
            let partial = <TowedWheelDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C0 => &mut matrices.c0,
                MatrixName::C1 => &mut matrices.c1,
                MatrixName::Kc => &mut matrices.kc,
                MatrixName::K1 => &mut matrices.k1,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<2> for TowedWheel<T> {
    type Derivatives = [Coefficients<T, 2>; 5];

    type WithDerivativesOver<U: Number> = TowedWheel<U>;

    const PARTIALS: &'static [Partial] = <TowedWheelDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 5];
        for position in 0..9 {
            Partial::write(&<TowedWheelDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (
            Coefficients {
                states: [States::Both, States::Position],
                ..Coefficients::from_rows(TowedWheelMatrices::rows(&matrices))
            },
            all,
        )
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for TowedWheel<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl TowedWheelDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 9] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 5), Partial::new(MatrixName::C1, 0, 0, 0, 2),
        Partial::new(MatrixName::M, 0, 0, 1, 4), Partial::new(MatrixName::Kc, 0, 0, 2, 7),
        Partial::new(MatrixName::Kc, 0, 1, 2, 3), Partial::new(MatrixName::M, 0, 0, 3, 8),
        Partial::new(MatrixName::C1, 0, 0, 3, 0), Partial::new(MatrixName::Kc, 0, 0, 4, 6),
        Partial::new(MatrixName::Kc, 0, 1, 4, 1),
    ];
}
