// @generated from generated/models/jeffcott_rotor.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: d9449eedbd9a5f5e

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rows, Scalar, SetInfo,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A disc in the middle of an elastic shaft whose own damping turns with it: a Jeffcott rotor.
///
/// Two coordinates, the displacements of the disc in axes that do not turn; the shaft turns from the first to the second.
/// Damping of the surroundings always calms it, that of the shaft and of its fits drives the forward whirl above the
/// spin rate sqrt(k/m) (1 + ce/ci), whatever the balance of the disc. The speed v is the circumferential speed at the
/// radius R, so that the spin rate is v/R.
///
/// Source: Force balance of the Jeffcott rotor with rotating and non-rotating damping, as in textbooks of rotor dynamics
///
/// The fields are the parameters. The coordinates are `y` in `m`, `z` in `m`.
///
/// <details><summary>The formulas of its matrices</summary>
///
/// ```text
/// c = ce + ci [kg/s]
/// circulation = ci/R [kg/m/s]
/// M_11 = M_22 = m [kg]
/// C0_11 = C0_22 = c [kg/s]
/// Kc_11 = Kc_22 = k [kg/s^2]
/// K1_12 = circulation [kg/m/s]
/// K1_21 = -circulation [kg/m/s]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct JeffcottRotor<T = f64> {
    /// Mass of the disc.
    ///
    /// `m` in `kg`: `> 0`.
    pub m: T,
    /// Stiffness of the shaft at the disc.
    ///
    /// `k` in `N/m`: `> 0`.
    pub k: T,
    /// Damping of the surroundings, external or non-rotating.
    ///
    /// `ce` in `N*s/m`: `>= 0`.
    pub ce: T,
    /// Damping of the shaft, internal or rotating.
    ///
    /// `ci` in `N*s/m`: `>= 0`.
    pub ci: T,
    /// Radius at which the speed is that of the circumference.
    ///
    /// `R` in `m`: `> 0`.
    pub R: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`JeffcottRotor`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JeffcottRotorMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C0, a coefficient of q'. Symmetric, proved.
    pub c0: Rows<T, 2>,
    /// Stiffness Kc, a coefficient of q. Symmetric, proved.
    pub kc: Rows<T, 2>,
    /// Stiffness K1, a coefficient of v q.
    pub k1: Rows<T, 2>,
}

impl<T: Number> JeffcottRotor<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 1 addition, 1 division and 1 negation: 3 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> JeffcottRotorMatrices<T> {
        let zero = self.m.like(0.0);
        let c = self.ce + self.ci;
        let circulation = self.ci / self.R;
        let K1_21 = -circulation;
        JeffcottRotorMatrices::from_entries([
            self.m, zero, zero, self.m, c, zero, zero, c, self.k, zero, zero, self.k, zero,
            circulation, K1_21, zero,
        ])
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`JeffcottRotor`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JeffcottRotorDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 3],
}

impl<T: Number> JeffcottRotor<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 1 addition, 2 multiplications, 1 division and 1 negation: 5 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (JeffcottRotorMatrices<T>, JeffcottRotorDerivatives<T>) {
        let zero = self.m.like(0.0);
        let mut matrices = JeffcottRotorMatrices::from_entries([zero; 16]);
        let mut derivatives = JeffcottRotorDerivatives {
            values: [zero; 3],
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
        matrices: &mut JeffcottRotorMatrices<T>,
        derivatives: &mut JeffcottRotorDerivatives<T>,
    ) {
        *matrices = JeffcottRotorMatrices::from_entries([self.m.like(0.0); 16]);
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
        put_entry(2, self.k);
        put_derivative(0, self.m.like(1.0));
        let c = self.ce + self.ci;
        put_entry(1, c);
        let K1_12_ci = self.m.like(1.0) / self.R;
        put_derivative(1, K1_12_ci);
        let circulation = self.ci * K1_12_ci;
        put_entry(3, circulation);
        let K1_21_R = K1_12_ci * circulation;
        put_derivative(2, K1_21_R);
        let K1_21 = -circulation;
        put_entry(4, K1_21);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl JeffcottRotor<f64> {
    /// The parameter set `example`.
    ///
    /// Source: An example in round figures, with the threshold at 250 rad/s, which is 7.5 m/s at the surface of the shaft
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `m` | 1 | `kg` |
    /// | `k` | 10000 | `N/m` |
    /// | `ce` | 3 | `N*s/m` |
    /// | `ci` | 2 | `N*s/m` |
    /// | `R` | 0.03 | `m` |
    pub const EXAMPLE: Self = Self {
        m: 1.0, k: 10000.0, ce: 3.0, ci: 2.0, R: 0.03,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> JeffcottRotor<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 5]) -> Self {
        Self {
            m: values[0], k: values[1], ce: values[2], ci: values[3], R: values[4],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 5] {
        [self.m, self.k, self.ce, self.ci, self.R]
    }
}

impl<T: Scalar> JeffcottRotor<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> JeffcottRotor<U> {
        let values = self.to_array();
        JeffcottRotor::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl JeffcottRotor<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> JeffcottRotor<f32> {
        JeffcottRotor::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<JeffcottRotor<f32>> for JeffcottRotor<f64> {
    fn from(parameters: JeffcottRotor<f32>) -> Self {
        JeffcottRotor::cast(&parameters)
    }
}

impl<T: Number> JeffcottRotorMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 16]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c0: carvallo::rows(&entries, 4),
            kc: carvallo::rows(&entries, 8),
            k1: carvallo::rows(&entries, 12),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 5] {
        [self.m[0][0], self.c0[0][0], self.kc[0][0], self.k1[0][1], self.k1[1][0]]
    }

    /// Sets the entry at a position among those that differ, wherever it stands.
    #[inline(always)]
    fn set_entry(&mut self, position: usize, entry: T) {
        match position {
            0 => {
                self.m[0][0] = entry;
                self.m[1][1] = entry;
            }
            1 => {
                self.c0[0][0] = entry;
                self.c0[1][1] = entry;
            }
            2 => {
                self.kc[0][0] = entry;
                self.kc[1][1] = entry;
            }
            3 => {
                self.k1[0][1] = entry;
            }
            4 => {
                self.k1[1][0] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, self.c0.0, zeros, self.kc.0, zeros, self.k1.0, zeros]
    }
}

impl<T: Scalar> From<JeffcottRotorMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: JeffcottRotorMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for JeffcottRotor<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 5];

    type Over<U: Number> = JeffcottRotor<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "JeffcottRotor",
        docs: "A disc in the middle of an elastic shaft whose own damping turns with it: a Jeffcott rotor.\n\nTwo coordinates, the displacements of the disc in axes that do not turn; the shaft turns from the first to the second.\nDamping of the surroundings always calms it, that of the shaft and of its fits drives the forward whirl above the\nspin rate sqrt(k/m) (1 + ce/ci), whatever the balance of the disc. The speed v is the circumferential speed at the\nradius R, so that the spin rate is v/R.",
        source: "Force balance of the Jeffcott rotor with rotating and non-rotating damping, as in textbooks of rotor dynamics",
        parameters: &[
            ParameterInfo::new("m", "kg", Domain::POSITIVE).docs("Mass of the disc."),
            ParameterInfo::new("k", "N/m", Domain::POSITIVE)
                .docs("Stiffness of the shaft at the disc."),
            ParameterInfo::new("ce", "N*s/m", Domain::NONNEGATIVE)
                .docs("Damping of the surroundings, external or non-rotating."),
            ParameterInfo::new("ci", "N*s/m", Domain::NONNEGATIVE)
                .docs("Damping of the shaft, internal or rotating."),
            ParameterInfo::new("R", "m", Domain::POSITIVE)
                .docs("Radius at which the speed is that of the circumference."),
        ],
        coordinates: &[
            CoordinateInfo::new("y", "m").docs("Displacement of the disc."),
            CoordinateInfo::new("z", "m")
                .docs("Displacement of the disc across, to where the shaft turns from y."),
        ],
        forces: &[],
        matrices: &[MatrixName::M, MatrixName::C0, MatrixName::Kc, MatrixName::K1],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0), (MatrixName::M, 1, 1)]),
            EntryInfo::at(&[(MatrixName::C0, 0, 0), (MatrixName::C0, 1, 1)]),
            EntryInfo::at(&[(MatrixName::Kc, 0, 0), (MatrixName::Kc, 1, 1)]),
            EntryInfo::at(&[(MatrixName::K1, 0, 1)]),
            EntryInfo::at(&[(MatrixName::K1, 1, 0)]),
        ],
        sets: &[
            SetInfo {
                name: "example",
                docs: "",
                source: "An example in round figures, with the threshold at 250 rad/s, which is 7.5 m/s at the surface of the shaft",
                values: &JeffcottRotor::to_array(&JeffcottRotor::<f64>::EXAMPLE),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("c", "kg/s", "ce + ci"),
            FormulaInfo::definition("circulation", "kg/m/s", "ci/R"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0), (MatrixName::M, 1, 1)], "kg", "m"),
            FormulaInfo::entry(&[(MatrixName::C0, 0, 0), (MatrixName::C0, 1, 1)], "kg/s", "c"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 0), (MatrixName::Kc, 1, 1)], "kg/s^2", "k"),
            FormulaInfo::entry(&[(MatrixName::K1, 0, 1)], "kg/m/s", "circulation"),
            FormulaInfo::entry(&[(MatrixName::K1, 1, 0)], "kg/m/s", "-circulation"),
        ],
        attributes: &[],
        motion: None,
        gravity: None,
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("JeffcottRotor", 5, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("JeffcottRotor", 5, values)?;
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
        Coefficients::from_rows(JeffcottRotorMatrices::rows(&self.matrices()))
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 2>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn gravity(&self) -> Option<T> {
        None
    }
}

impl JeffcottRotor<f64> {
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
impl<T: Scalar> core::fmt::Display for JeffcottRotor<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for JeffcottRotor<T> {
    type Entries = [T; 5];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            m: parameter(0), k: parameter(1), ce: parameter(2), ci: parameter(3), R: parameter(4),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        JeffcottRotorMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        JeffcottRotorMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> JeffcottRotorDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<JeffcottRotorMatrices<T>> {
        if parameter >= 5 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = JeffcottRotorMatrices {
            m: Rows([[zero; 2]; 2]), c0: Rows([[zero; 2]; 2]), kc: Rows([[zero; 2]; 2]),
            k1: Rows([[zero; 2]; 2]),
        };
        for position in 0..12 {
            let partial = <JeffcottRotorDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C0 => &mut matrices.c0,
                MatrixName::Kc => &mut matrices.kc,
                MatrixName::K1 => &mut matrices.k1,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<2> for JeffcottRotor<T> {
    type Derivatives = [Coefficients<T, 2>; 5];

    type WithDerivativesOver<U: Number> = JeffcottRotor<U>;

    const PARTIALS: &'static [Partial] = <JeffcottRotorDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 5];
        for position in 0..12 {
            Partial::write(&<JeffcottRotorDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(JeffcottRotorMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for JeffcottRotor<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl JeffcottRotorDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 12] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 0), Partial::new(MatrixName::M, 1, 1, 0, 0),
        Partial::new(MatrixName::Kc, 0, 0, 1, 0), Partial::new(MatrixName::Kc, 1, 1, 1, 0),
        Partial::new(MatrixName::C0, 0, 0, 2, 0), Partial::new(MatrixName::C0, 1, 1, 2, 0),
        Partial::new(MatrixName::C0, 0, 0, 3, 0), Partial::new(MatrixName::C0, 1, 1, 3, 0),
        Partial::new(MatrixName::K1, 0, 1, 3, 1),
        Partial::new(MatrixName::K1, 1, 0, 3, 1).negative(),
        Partial::new(MatrixName::K1, 0, 1, 4, 2).negative(),
        Partial::new(MatrixName::K1, 1, 0, 4, 2),
    ];
}
