// @generated from generated/models/pendulum.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 9f6bf78d3baf1a60

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rows, Scalar, SetInfo,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A pendulum with a damped joint, hanging at rest.
///
/// A point mass on a massless rod.
///
/// Source: Newton's second law about the joint
///
/// The fields are the parameters. The coordinates are `theta` (swing) in `rad`.
///
/// <details><summary>The formulas of its matrices</summary>
///
/// ```text
/// M_11 = m*l^2 [kg*m^2]
/// C0_11 = c [kg*m^2/s]
/// K0_11 = m*l [kg*m]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Pendulum<T = f64> {
    /// Mass of the bob.
    ///
    /// `m` in `kg`: `> 0`.
    pub m: T,
    /// Length of the rod.
    ///
    /// `l` in `m`: `> 0`.
    pub l: T,
    /// Damping of the joint.
    ///
    /// `c` in `N*m*s`: `>= 0`.
    pub c: T,
    /// Gravitational field strength.
    ///
    /// `g` in `N/kg`: `>= 0`.
    pub g: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`Pendulum`], each 1 x 1 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PendulumMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 1>,
    /// Damping C0, a coefficient of q'.
    pub c0: Rows<T, 1>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 1>,
}

impl<T: Number> Pendulum<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 2 multiplications.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> PendulumMatrices<T> {
        let K0_11 = self.l * self.m;
        let M_11 = self.l * K0_11;
        PendulumMatrices::from_entries([M_11, self.c, K0_11])
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`Pendulum`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PendulumDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 5],
}

impl<T: Number> Pendulum<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 1 addition and 3 multiplications: 4 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (PendulumMatrices<T>, PendulumDerivatives<T>) {
        let zero = self.m.like(0.0);
        let mut matrices = PendulumMatrices::from_entries([zero; 3]);
        let mut derivatives = PendulumDerivatives {
            values: [zero; 5],
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
        matrices: &mut PendulumMatrices<T>,
        derivatives: &mut PendulumDerivatives<T>,
    ) {
        *matrices = PendulumMatrices::from_entries([self.m.like(0.0); 3]);
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
        put_entry(1, self.c);
        put_derivative(0, self.m);
        put_derivative(1, self.l);
        put_derivative(2, self.m.like(1.0));
        let M_11_m = self.l * self.l;
        put_derivative(3, M_11_m);
        let M_11 = self.m * M_11_m;
        put_entry(0, M_11);
        let K0_11 = self.m * self.l;
        put_entry(2, K0_11);
        let M_11_l = K0_11 + K0_11;
        put_derivative(4, M_11_l);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl Pendulum<f64> {
    /// The parameter set `seconds`.
    ///
    /// Source: a bob of 2 kg that passes its lowest point once a second, nearly
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `m` | 2 | `kg` |
    /// | `l` | 0.994 | `m` |
    /// | `c` | 0.1 | `N*m*s` |
    /// | `g` | 9.81 | `N/kg` |
    pub const SECONDS: Self = Self {
        m: 2.0, l: 0.994, c: 0.1, g: 9.81,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> Pendulum<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 4]) -> Self {
        Self {
            m: values[0], l: values[1], c: values[2], g: values[3],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 4] {
        [self.m, self.l, self.c, self.g]
    }
}

impl<T: Scalar> Pendulum<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> Pendulum<U> {
        let values = self.to_array();
        Pendulum::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl Pendulum<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> Pendulum<f32> {
        Pendulum::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<Pendulum<f32>> for Pendulum<f64> {
    fn from(parameters: Pendulum<f32>) -> Self {
        Pendulum::cast(&parameters)
    }
}

impl<T: Number> PendulumMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 3]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c0: carvallo::rows(&entries, 1),
            k0: carvallo::rows(&entries, 2),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 3] {
        [self.m[0][0], self.c0[0][0], self.k0[0][0]]
    }

    /// Sets the entry at a position among those that differ, wherever it stands.
    #[inline(always)]
    fn set_entry(&mut self, position: usize, entry: T) {
        match position {
            0 => {
                self.m[0][0] = entry;
            }
            1 => {
                self.c0[0][0] = entry;
            }
            2 => {
                self.k0[0][0] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 1]; 1]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 1]; 1];
        [self.m.0, zeros, self.c0.0, zeros, zeros, self.k0.0, zeros, zeros]
    }
}

impl<T: Scalar> From<PendulumMatrices<T>> for Coefficients<T, 1> {
    fn from(matrices: PendulumMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<1> for Pendulum<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 4];

    type Over<U: Number> = Pendulum<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "Pendulum",
        docs: "A pendulum with a damped joint, hanging at rest.\n\nA point mass on a massless rod.",
        source: "Newton's second law about the joint",
        parameters: &[
            ParameterInfo::new("m", "kg", Domain::POSITIVE).docs("Mass of the bob."),
            ParameterInfo::new("l", "m", Domain::POSITIVE).docs("Length of the rod."),
            ParameterInfo::new("c", "N*m*s", Domain::NONNEGATIVE)
                .docs("Damping of the joint."),
            ParameterInfo::new("g", "N/kg", Domain::NONNEGATIVE)
                .docs("Gravitational field strength."),
        ],
        coordinates: &[
            CoordinateInfo::new("theta", "rad")
                .label("swing")
                .docs("Angle of the rod from the vertical."),
        ],
        forces: &[],
        matrices: &[MatrixName::M, MatrixName::C0, MatrixName::K0],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]),
            EntryInfo::at(&[(MatrixName::C0, 0, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 0)]),
        ],
        sets: &[
            SetInfo {
                name: "seconds",
                docs: "",
                source: "a bob of 2 kg that passes its lowest point once a second, nearly",
                values: &Pendulum::to_array(&Pendulum::<f64>::SECONDS),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "m*l^2"),
            FormulaInfo::entry(&[(MatrixName::C0, 0, 0)], "kg*m^2/s", "c"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "m*l"),
        ],
        attributes: &[],
        motion: None,
        gravity: Some(3),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("Pendulum", 4, values)?;
        Ok(<Self as Evaluator<T, 1>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("Pendulum", 4, values)?;
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
        let info = const { &<Self as Model<1>>::INFO.without_formulas() };
        info.validate(&self.to_array().map(Scalar::to_f64))?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 1> {
        Coefficients::from_rows(PendulumMatrices::rows(&self.matrices()))
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 1>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl Pendulum<f64> {
    /// What the model tells about itself, the same for every number type.
    pub const INFO: &'static ModelInfo = <Self as Model<1>>::INFO;

    /// The parameter set of this name, however it is spelt: upper and lower case, `_`, `-` and spaces make no
    /// difference. In `f32` it is had by the trait `Model`.
    #[must_use]
    pub fn set(name: &str) -> Option<Self> {
        <Self as Model<1>>::set(name)
    }
}

/// The parameters, one a line with its unit, in the precision that is asked for; `{:#}` says what they are.
impl<T: Scalar> core::fmt::Display for Pendulum<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<1>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 1> for Pendulum<T> {
    type Entries = [T; 3];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            m: parameter(0), l: parameter(1), c: parameter(2), g: parameter(3),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        PendulumMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 1]; 1]; 8] {
        PendulumMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> PendulumDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<PendulumMatrices<T>> {
        if parameter >= 4 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = PendulumMatrices {
            m: Rows([[zero; 1]; 1]),
            c0: Rows([[zero; 1]; 1]),
            k0: Rows([[zero; 1]; 1]),
        };
        for position in 0..5 {
            let partial = <PendulumDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C0 => &mut matrices.c0,
                MatrixName::K0 => &mut matrices.k0,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<1> for Pendulum<T> {
    type Derivatives = [Coefficients<T, 1>; 4];

    type WithDerivativesOver<U: Number> = Pendulum<U>;

    const PARTIALS: &'static [Partial] = <PendulumDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 1>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 1]; 1]; 8]); 4];
        for position in 0..5 {
            Partial::write(&<PendulumDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(PendulumMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 1> for Pendulum<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl PendulumDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 5] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 3), Partial::new(MatrixName::K0, 0, 0, 0, 1),
        Partial::new(MatrixName::M, 0, 0, 1, 4), Partial::new(MatrixName::K0, 0, 0, 1, 0),
        Partial::new(MatrixName::C0, 0, 0, 2, 2),
    ];
}
