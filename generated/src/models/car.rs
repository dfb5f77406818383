// @generated from generated/models/car.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: bdb58fbb39c088e9

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rows, Scalar, SetInfo, States,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// The single-track car of the textbooks: two axles on tyres whose side force is proportional to slip, at a constant speed.
///
/// Axes: origin at the centre of mass, x forward, y to the right, z down. Only the rates of its coordinates are states: the
/// lateral velocity along the axes of the car, and the yaw rate.
///
/// Source: The single-track car of the textbooks, after Riekert & Schunck (1940), Zur Fahrmechanik des gummibereiften Kraftfahrzeugs, Ingenieur-Archiv 11, 210-224
///
/// The fields are the parameters. The coordinates are `y` (lateral) in `m`, of which only the rate is a state; `psi` (yaw) in `rad`, of which only the rate is a state.
///
/// <details><summary>The formulas of its matrices</summary>
///
/// ```text
/// M_11 = m [kg]
/// M_22 = I [kg*m^2]
/// C-1_11 = Cf + Cr [kg*m/s^2]
/// C-1_12 = C-1_21 = a*Cf - b*Cr [kg*m^2/s^2]
/// C-1_22 = a^2*Cf + b^2*Cr [kg*m^3/s^2]
/// C1_12 = m [kg]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Car<T = f64> {
    /// Mass.
    ///
    /// `m` in `kg`: `> 0`.
    pub m: T,
    /// Moment of inertia about the vertical axis.
    ///
    /// `I` in `kg*m^2`: `> 0`.
    pub I: T,
    /// Distance of the front axle ahead of the centre of mass.
    ///
    /// `a` in `m`: `> 0`.
    pub a: T,
    /// Distance of the rear axle behind the centre of mass.
    ///
    /// `b` in `m`: `> 0`.
    pub b: T,
    /// Cornering stiffness of the front axle, of both wheels together.
    ///
    /// `Cf` in `N`: `> 0`.
    pub Cf: T,
    /// Cornering stiffness of the rear axle, of both wheels together.
    ///
    /// `Cr` in `N`: `> 0`.
    pub Cr: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`Car`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C-1, a coefficient of q'/v.
    pub cm1: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
}

impl<T: Number> Car<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 3 additions and 4 multiplications: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> CarMatrices<T> {
        let zero = self.m.like(0.0);
        let Cm1_11 = self.Cf + self.Cr;
        let t7 = self.Cr * self.b;
        let t9 = self.Cf * self.a;
        let Cm1_12 = t9 - t7;
        let Cm1_22 = self.a * t9 + self.b * t7;
        CarMatrices::from_entries([
            self.m, zero, zero, self.I, Cm1_11, Cm1_12, Cm1_12, Cm1_22, zero, self.m, zero, zero,
        ])
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`Car`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 9],
}

impl<T: Number> Car<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 5 additions and 6 multiplications: 11 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (CarMatrices<T>, CarDerivatives<T>) {
        let zero = self.m.like(0.0);
        let mut matrices = CarMatrices::from_entries([zero; 12]);
        let mut derivatives = CarDerivatives {
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
    pub fn write_matrices_and_derivatives(&self, matrices: &mut CarMatrices<T>, derivatives: &mut CarDerivatives<T>) {
        *matrices = CarMatrices::from_entries([self.m.like(0.0); 12]);
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
        put_derivative(0, self.a);
        put_derivative(1, self.b);
        put_derivative(2, self.Cf);
        put_derivative(3, self.Cr);
        put_derivative(4, self.m.like(1.0));
        let Cm1_11 = self.Cf + self.Cr;
        put_entry(2, Cm1_11);
        let t9 = self.Cr * self.b;
        let t10 = self.Cf * self.a;
        let Cm1_12 = t10 - t9;
        put_entry(3, Cm1_12);
        let Cm1_22_Cf = self.a * self.a;
        put_derivative(5, Cm1_22_Cf);
        let Cm1_22_Cr = self.b * self.b;
        put_derivative(6, Cm1_22_Cr);
        let Cm1_22 = self.Cf * Cm1_22_Cf + self.Cr * Cm1_22_Cr;
        put_entry(4, Cm1_22);
        let Cm1_22_a = t10 + t10;
        put_derivative(7, Cm1_22_a);
        let Cm1_22_b = t9 + t9;
        put_derivative(8, Cm1_22_b);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl Car<f64> {
    /// The parameter set `oversteering`.
    ///
    /// Source: a public exercise: m = 1400, a = 1.14, b = 1.33, Cf = 25000, Cr = 21000, Iz = 2420
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `m` | 1400 | `kg` |
    /// | `I` | 2420 | `kg*m^2` |
    /// | `a` | 1.14 | `m` |
    /// | `b` | 1.33 | `m` |
    /// | `Cf` | 25000 | `N` |
    /// | `Cr` | 21000 | `N` |
    pub const OVERSTEERING: Self = Self {
        m: 1400.0, I: 2420.0, a: 1.14, b: 1.33, Cf: 25000.0, Cr: 21000.0,
    };

    /// The parameter set `understeering`.
    ///
    /// Source: the same with its axles exchanged
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `m` | 1400 | `kg` |
    /// | `I` | 2420 | `kg*m^2` |
    /// | `a` | 1.33 | `m` |
    /// | `b` | 1.14 | `m` |
    /// | `Cf` | 21000 | `N` |
    /// | `Cr` | 25000 | `N` |
    pub const UNDERSTEERING: Self = Self {
        m: 1400.0, I: 2420.0, a: 1.33, b: 1.14, Cf: 21000.0, Cr: 25000.0,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> Car<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 6]) -> Self {
        Self {
            m: values[0], I: values[1], a: values[2], b: values[3], Cf: values[4], Cr: values[5],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 6] {
        [self.m, self.I, self.a, self.b, self.Cf, self.Cr]
    }
}

impl<T: Scalar> Car<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> Car<U> {
        let values = self.to_array();
        Car::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl Car<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> Car<f32> {
        Car::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<Car<f32>> for Car<f64> {
    fn from(parameters: Car<f32>) -> Self {
        Car::cast(&parameters)
    }
}

impl<T: Number> CarMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 12]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            cm1: carvallo::rows(&entries, 4),
            c1: carvallo::rows(&entries, 8),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 5] {
        [self.m[0][0], self.m[1][1], self.cm1[0][0], self.cm1[0][1], self.cm1[1][1]]
    }

    /// Sets the entry at a position among those that differ, wherever it stands.
    #[inline(always)]
    fn set_entry(&mut self, position: usize, entry: T) {
        match position {
            0 => {
                self.m[0][0] = entry;
                self.c1[0][1] = entry;
            }
            1 => {
                self.m[1][1] = entry;
            }
            2 => {
                self.cm1[0][0] = entry;
            }
            3 => {
                self.cm1[0][1] = entry;
                self.cm1[1][0] = entry;
            }
            4 => {
                self.cm1[1][1] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, self.cm1.0, zeros, self.c1.0, zeros, zeros, zeros, zeros]
    }
}

impl<T: Scalar> From<CarMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: CarMatrices<T>) -> Self {
        Coefficients {
            states: [States::Rate, States::Rate],
            ..Coefficients::from_rows(matrices.rows())
        }
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for Car<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 6];

    type Over<U: Number> = Car<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "Car",
        docs: "The single-track car of the textbooks: two axles on tyres whose side force is proportional to slip, at a constant speed.\n\nAxes: origin at the centre of mass, x forward, y to the right, z down. Only the rates of its coordinates are states: the\nlateral velocity along the axes of the car, and the yaw rate.",
        source: "The single-track car of the textbooks, after Riekert & Schunck (1940), Zur Fahrmechanik des gummibereiften Kraftfahrzeugs, Ingenieur-Archiv 11, 210-224",
        parameters: &[
            ParameterInfo::new("m", "kg", Domain::POSITIVE).docs("Mass."),
            ParameterInfo::new("I", "kg*m^2", Domain::POSITIVE)
                .docs("Moment of inertia about the vertical axis."),
            ParameterInfo::new("a", "m", Domain::POSITIVE)
                .docs("Distance of the front axle ahead of the centre of mass."),
            ParameterInfo::new("b", "m", Domain::POSITIVE)
                .docs("Distance of the rear axle behind the centre of mass."),
            ParameterInfo::new("Cf", "N", Domain::POSITIVE)
                .docs("Cornering stiffness of the front axle, of both wheels together."),
            ParameterInfo::new("Cr", "N", Domain::POSITIVE)
                .docs("Cornering stiffness of the rear axle, of both wheels together."),
        ],
        coordinates: &[
            CoordinateInfo::new("y", "m")
                .label("lateral")
                .docs("Lateral motion, to the right.")
                .states(States::Rate),
            CoordinateInfo::new("psi", "rad")
                .label("yaw")
                .docs("Yaw, to the right.")
                .states(States::Rate),
        ],
        forces: &[],
        matrices: &[MatrixName::M, MatrixName::Cm1, MatrixName::C1],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0), (MatrixName::C1, 0, 1)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]),
            EntryInfo::at(&[(MatrixName::Cm1, 0, 0)]),
            EntryInfo::at(&[(MatrixName::Cm1, 0, 1), (MatrixName::Cm1, 1, 0)]),
            EntryInfo::at(&[(MatrixName::Cm1, 1, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "oversteering",
                docs: "",
                source: "a public exercise: m = 1400, a = 1.14, b = 1.33, Cf = 25000, Cr = 21000, Iz = 2420",
                values: &Car::to_array(&Car::<f64>::OVERSTEERING),
            },
            SetInfo {
                name: "understeering",
                docs: "",
                source: "the same with its axles exchanged",
                values: &Car::to_array(&Car::<f64>::UNDERSTEERING),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg", "m"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "I"),
            FormulaInfo::entry(&[(MatrixName::Cm1, 0, 0)], "kg*m/s^2", "Cf + Cr"),
            FormulaInfo::entry(&[(MatrixName::Cm1, 0, 1), (MatrixName::Cm1, 1, 0)], "kg*m^2/s^2", "a*Cf - b*Cr"),
            FormulaInfo::entry(&[(MatrixName::Cm1, 1, 1)], "kg*m^3/s^2", "a^2*Cf + b^2*Cr"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 1)], "kg", "m"),
        ],
        attributes: &[],
        motion: None,
        gravity: None,
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("Car", 6, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("Car", 6, values)?;
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
            states: [States::Rate, States::Rate],
            ..Coefficients::from_rows(CarMatrices::rows(&self.matrices()))
        }
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 2>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn gravity(&self) -> Option<T> {
        None
    }
}

impl Car<f64> {
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
impl<T: Scalar> core::fmt::Display for Car<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for Car<T> {
    type Entries = [T; 5];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            m: parameter(0), I: parameter(1), a: parameter(2), b: parameter(3), Cf: parameter(4),
            Cr: parameter(5),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        CarMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        CarMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> CarDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<CarMatrices<T>> {
        if parameter >= 6 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = CarMatrices {
            m: Rows([[zero; 2]; 2]),
            cm1: Rows([[zero; 2]; 2]),
            c1: Rows([[zero; 2]; 2]),
        };
        for position in 0..17 {
            let partial = <CarDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::Cm1 => &mut matrices.cm1,
                MatrixName::C1 => &mut matrices.c1,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<2> for Car<T> {
    type Derivatives = [Coefficients<T, 2>; 6];

    type WithDerivativesOver<U: Number> = Car<U>;

    const PARTIALS: &'static [Partial] = <CarDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 6];
        for position in 0..17 {
            Partial::write(&<CarDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (
            Coefficients {
                states: [States::Rate, States::Rate],
                ..Coefficients::from_rows(CarMatrices::rows(&matrices))
            },
            all,
        )
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for Car<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl CarDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 17] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 4), Partial::new(MatrixName::C1, 0, 1, 0, 4),
        Partial::new(MatrixName::M, 1, 1, 1, 4), Partial::new(MatrixName::Cm1, 0, 1, 2, 2),
        Partial::new(MatrixName::Cm1, 1, 0, 2, 2), Partial::new(MatrixName::Cm1, 1, 1, 2, 7),
        Partial::new(MatrixName::Cm1, 0, 1, 3, 3).negative(),
        Partial::new(MatrixName::Cm1, 1, 0, 3, 3).negative(),
        Partial::new(MatrixName::Cm1, 1, 1, 3, 8), Partial::new(MatrixName::Cm1, 0, 0, 4, 4),
        Partial::new(MatrixName::Cm1, 0, 1, 4, 0), Partial::new(MatrixName::Cm1, 1, 0, 4, 0),
        Partial::new(MatrixName::Cm1, 1, 1, 4, 5), Partial::new(MatrixName::Cm1, 0, 0, 5, 4),
        Partial::new(MatrixName::Cm1, 0, 1, 5, 1).negative(),
        Partial::new(MatrixName::Cm1, 1, 0, 5, 1).negative(),
        Partial::new(MatrixName::Cm1, 1, 1, 5, 6),
    ];
}
