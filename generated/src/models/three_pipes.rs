// @generated from generated/models/three_pipes.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 92f4761ae2f6100e

#![allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    LengthError, MatrixName, Model, ModelInfo, Number, ParameterError, ParameterInfo,
    Partial, Scalar, SetInfo,
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
/// The fields are the parameters. The coordinates are `first` in rad, `second` in rad, `third` in rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreePipes<T = f64> {
    /// Length of each pipe.
    ///
    /// `l` in m: > 0.
    pub l: T,
    /// Mass of a pipe for each metre.
    ///
    /// `m` in kg/m: > 0.
    pub m: T,
    /// Mass of the fluid in it for each metre.
    ///
    /// `f` in kg/m: >= 0.
    pub f: T,
    /// Stiffness of each hinge.
    ///
    /// `k` in N*m/rad: >= 0.
    pub k: T,
    /// Damping of each hinge.
    ///
    /// `c` in N*m*s/rad: >= 0.
    pub c: T,
    /// Gravitational field strength.
    ///
    /// `g` in N/kg: >= 0.
    pub g: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`ThreePipes`], each 3 x 3 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreePipesMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: [[T; 3]; 3],
    /// Damping C0, a coefficient of q'. Symmetric, proved.
    pub c0: [[T; 3]; 3],
    /// Damping C1, a coefficient of v q'.
    pub c1: [[T; 3]; 3],
    /// Stiffness Kc, a coefficient of q. Symmetric, proved.
    pub kc: [[T; 3]; 3],
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: [[T; 3]; 3],
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: [[T; 3]; 3],
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
        let t8 = inertia * self.l.like(2.3333333333333335);
        let t10 = inertia * self.l.like(1.5);
        let t12 = inertia * self.l.like(0.5);
        let t14 = inertia * self.l.like(1.3333333333333333);
        let t16 = inertia * self.l.like(0.3333333333333333);
        let t18 = self.c + self.c;
        let t20 = t1 * self.f;
        let t21 = t20 + t20;
        let t23 = self.k + self.k;
        let t25 = weight * self.l.like(2.5);
        let t26 = weight * self.l.like(1.5);
        let t27 = weight * self.l.like(0.5);
        let t28 = self.l * self.f;
        let t29 = -self.c;
        let t30 = -self.k;
        let t31 = -t28;
        ThreePipesMatrices::from_entries([
            t8, t10, t12, t10, t14, t12, t12, t12, t16, t18, t29, self.l.like(0.0), t29, t18, t29,
            self.l.like(0.0), t29, self.c, t20, t21, t21, self.l.like(0.0), t20, t21,
            self.l.like(0.0), self.l.like(0.0), t20, t23, t30, self.l.like(0.0), t30, t23, t30,
            self.l.like(0.0), t30, self.k, t25, self.l.like(0.0), self.l.like(0.0),
            self.l.like(0.0), t26, self.l.like(0.0), self.l.like(0.0), self.l.like(0.0), t27, t31,
            self.l.like(0.0), t28, self.l.like(0.0), t31, t28, self.l.like(0.0), self.l.like(0.0),
            self.l.like(0.0),
        ])
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`ThreePipes`] with respect to its parameters, in SI units: those that are not
/// zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreePipesDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 25],
}

impl<T: Number> ThreePipes<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 6 additions, 32 multiplications and 3 negations: 41 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (ThreePipesMatrices<T>, ThreePipesDerivatives<T>) {
        let t2 = self.m + self.f;
        let weight_m = self.l * self.l;
        let inertia_m = self.l * weight_m;
        let inertia = t2 * inertia_m;
        let t8 = inertia * self.l.like(2.3333333333333335);
        let t10 = inertia * self.l.like(1.5);
        let t12 = inertia * self.l.like(0.5);
        let t14 = inertia * self.l.like(1.3333333333333333);
        let t16 = inertia * self.l.like(0.3333333333333333);
        let t18 = self.c + self.c;
        let t20 = self.f * weight_m;
        let t21 = weight_m + weight_m;
        let t22 = self.f * t21;
        let t24 = self.k + self.k;
        let weight = t2 * weight_m;
        let t27 = weight * self.l.like(2.5);
        let t28 = self.l.like(1.5) * weight;
        let t29 = self.l.like(0.5) * weight;
        let t30 = self.f * self.l;
        let inertia_l = weight * self.l.like(3.0);
        let t33 = self.l.like(2.3333333333333335) * inertia_l;
        let t34 = self.l.like(1.5) * inertia_l;
        let t35 = self.l.like(0.5) * inertia_l;
        let t36 = self.l.like(1.3333333333333333) * inertia_l;
        let t37 = t30 + t30;
        let t39 = t30 * self.l.like(4.0);
        let t40 = t2 * self.l;
        let weight_l = t40 + t40;
        let t42 = self.l.like(2.5) * weight_l;
        let t43 = self.l.like(1.5) * weight_l;
        let t44 = inertia_m * self.l.like(2.3333333333333335);
        let t45 = inertia_m * self.l.like(1.5);
        let t46 = inertia_m * self.l.like(0.5);
        let t47 = inertia_m * self.l.like(1.3333333333333333);
        let t48 = inertia_m * self.l.like(0.3333333333333333);
        let t49 = weight_m * self.l.like(2.5);
        let t50 = weight_m * self.l.like(1.5);
        let t51 = weight_m * self.l.like(0.5);
        let t54 = -self.c;
        let t55 = -self.k;
        let t56 = -t30;
        (
            ThreePipesMatrices::from_entries([
                t8, t10, t12, t10, t14, t12, t12, t12, t16, t18, t54, self.l.like(0.0), t54, t18,
                t54, self.l.like(0.0), t54, self.c, t20, t22, t22, self.l.like(0.0), t20, t22,
                self.l.like(0.0), self.l.like(0.0), t20, t24, t55, self.l.like(0.0), t55, t24, t55,
                self.l.like(0.0), t55, self.k, t27, self.l.like(0.0), self.l.like(0.0),
                self.l.like(0.0), t28, self.l.like(0.0), self.l.like(0.0), self.l.like(0.0), t29,
                t56, self.l.like(0.0), t30, self.l.like(0.0), t56, t30, self.l.like(0.0),
                self.l.like(0.0), self.l.like(0.0),
            ]),
            ThreePipesDerivatives {
                values: [
                    t33, t34, t35, t36, weight, t37, t39, t42, t43, t40, self.f, t44, t45, t46, t47,
                    t48, t49, t50, t51, weight_m, t21, self.l, self.l.like(2.0), self.l.like(-1.0),
                    self.l.like(1.0),
                ],
            },
        )
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl ThreePipes<f64> {
    /// The parameter set `hose`.
    ///
    /// Source: a hose of rubber, by estimate
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

    /// The rows of M, C0, C1, Kc, K0 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 3]; 3]; 6] {
        [self.m, self.c0, self.c1, self.kc, self.k0, self.k2]
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
        matrices: &["M", "C0", "C1", "Kc", "K0", "K2"],
        entries: &[
            EntryInfo::at(&[("M", 0, 0)]),
            EntryInfo::at(&[("M", 0, 1), ("M", 1, 0)]),
            EntryInfo::at(&[("M", 0, 2), ("M", 1, 2), ("M", 2, 0), ("M", 2, 1)]),
            EntryInfo::at(&[("M", 1, 1)]),
            EntryInfo::at(&[("M", 2, 2)]),
            EntryInfo::at(&[("C0", 0, 0), ("C0", 1, 1)]),
            EntryInfo::at(&[("C0", 0, 1), ("C0", 1, 0), ("C0", 1, 2), ("C0", 2, 1)]),
            EntryInfo::at(&[("C0", 2, 2)]),
            EntryInfo::at(&[("C1", 0, 0), ("C1", 1, 1), ("C1", 2, 2)]),
            EntryInfo::at(&[("C1", 0, 1), ("C1", 0, 2), ("C1", 1, 2)]),
            EntryInfo::at(&[("Kc", 0, 0), ("Kc", 1, 1)]),
            EntryInfo::at(&[("Kc", 0, 1), ("Kc", 1, 0), ("Kc", 1, 2), ("Kc", 2, 1)]),
            EntryInfo::at(&[("Kc", 2, 2)]), EntryInfo::at(&[("K0", 0, 0)]),
            EntryInfo::at(&[("K0", 1, 1)]), EntryInfo::at(&[("K0", 2, 2)]),
            EntryInfo::at(&[("K2", 0, 0), ("K2", 1, 1)]),
            EntryInfo::at(&[("K2", 0, 2), ("K2", 1, 2)]),
        ],
        sets: &[
            SetInfo {
                name: "hose",
                docs: "",
                source: "a hose of rubber, by estimate",
                values: &ThreePipes::<f64>::HOSE.to_array(),
            },
        ],
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
        let info = <Self as Model<3>>::INFO;
        info.validate(&self.to_array().map(Scalar::to_f64))?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 3> {
        Coefficients::from_rows(ThreePipesMatrices::rows(&self.matrices()))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl<T: Number> Evaluator<T, 3> for ThreePipes<T> {
    type Entries = [T; 18];

    #[inline(always)]
    fn from_parameters(parameter: impl FnMut(usize) -> T) -> Self {
        Self::from_array(core::array::from_fn(parameter))
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        let matrices = self.matrices();
        [
            matrices.m[0][0], matrices.m[0][1], matrices.m[0][2], matrices.m[1][1],
            matrices.m[2][2], matrices.c0[0][0], matrices.c0[0][1], matrices.c0[2][2],
            matrices.c1[0][0], matrices.c1[0][1], matrices.kc[0][0], matrices.kc[0][1],
            matrices.kc[2][2], matrices.k0[0][0], matrices.k0[1][1], matrices.k0[2][2],
            matrices.k2[0][0], matrices.k2[0][2],
        ]
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 3]; 3]; 6] {
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
            m: [[zero; 3]; 3], c0: [[zero; 3]; 3], c1: [[zero; 3]; 3], kc: [[zero; 3]; 3],
            k0: [[zero; 3]; 3], k2: [[zero; 3]; 3],
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
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<3> for ThreePipes<T> {
    type Derivatives = [Coefficients<T, 3>; 6];

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 3>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 3]; 3]; 6]); 6];
        for position in 0..70 {
            Partial::write(&<ThreePipesDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(ThreePipesMatrices::rows(&matrices)), all)
    }
}

impl ThreePipesDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 70] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 0), Partial::new(MatrixName::M, 0, 1, 0, 1),
        Partial::new(MatrixName::M, 0, 2, 0, 2), Partial::new(MatrixName::M, 1, 0, 0, 1),
        Partial::new(MatrixName::M, 1, 1, 0, 3), Partial::new(MatrixName::M, 1, 2, 0, 2),
        Partial::new(MatrixName::M, 2, 0, 0, 2), Partial::new(MatrixName::M, 2, 1, 0, 2),
        Partial::new(MatrixName::M, 2, 2, 0, 4), Partial::new(MatrixName::C1, 0, 0, 0, 5),
        Partial::new(MatrixName::C1, 0, 1, 0, 6), Partial::new(MatrixName::C1, 0, 2, 0, 6),
        Partial::new(MatrixName::C1, 1, 1, 0, 5), Partial::new(MatrixName::C1, 1, 2, 0, 6),
        Partial::new(MatrixName::C1, 2, 2, 0, 5), Partial::new(MatrixName::K0, 0, 0, 0, 7),
        Partial::new(MatrixName::K0, 1, 1, 0, 8), Partial::new(MatrixName::K0, 2, 2, 0, 9),
        Partial::new(MatrixName::K2, 0, 0, 0, 10).negative(),
        Partial::new(MatrixName::K2, 0, 2, 0, 10),
        Partial::new(MatrixName::K2, 1, 1, 0, 10).negative(),
        Partial::new(MatrixName::K2, 1, 2, 0, 10), Partial::new(MatrixName::M, 0, 0, 1, 11),
        Partial::new(MatrixName::M, 0, 1, 1, 12), Partial::new(MatrixName::M, 0, 2, 1, 13),
        Partial::new(MatrixName::M, 1, 0, 1, 12), Partial::new(MatrixName::M, 1, 1, 1, 14),
        Partial::new(MatrixName::M, 1, 2, 1, 13), Partial::new(MatrixName::M, 2, 0, 1, 13),
        Partial::new(MatrixName::M, 2, 1, 1, 13), Partial::new(MatrixName::M, 2, 2, 1, 15),
        Partial::new(MatrixName::K0, 0, 0, 1, 16), Partial::new(MatrixName::K0, 1, 1, 1, 17),
        Partial::new(MatrixName::K0, 2, 2, 1, 18), Partial::new(MatrixName::M, 0, 0, 2, 11),
        Partial::new(MatrixName::M, 0, 1, 2, 12), Partial::new(MatrixName::M, 0, 2, 2, 13),
        Partial::new(MatrixName::M, 1, 0, 2, 12), Partial::new(MatrixName::M, 1, 1, 2, 14),
        Partial::new(MatrixName::M, 1, 2, 2, 13), Partial::new(MatrixName::M, 2, 0, 2, 13),
        Partial::new(MatrixName::M, 2, 1, 2, 13), Partial::new(MatrixName::M, 2, 2, 2, 15),
        Partial::new(MatrixName::C1, 0, 0, 2, 19), Partial::new(MatrixName::C1, 0, 1, 2, 20),
        Partial::new(MatrixName::C1, 0, 2, 2, 20), Partial::new(MatrixName::C1, 1, 1, 2, 19),
        Partial::new(MatrixName::C1, 1, 2, 2, 20), Partial::new(MatrixName::C1, 2, 2, 2, 19),
        Partial::new(MatrixName::K0, 0, 0, 2, 16), Partial::new(MatrixName::K0, 1, 1, 2, 17),
        Partial::new(MatrixName::K0, 2, 2, 2, 18),
        Partial::new(MatrixName::K2, 0, 0, 2, 21).negative(),
        Partial::new(MatrixName::K2, 0, 2, 2, 21),
        Partial::new(MatrixName::K2, 1, 1, 2, 21).negative(),
        Partial::new(MatrixName::K2, 1, 2, 2, 21), Partial::new(MatrixName::Kc, 0, 0, 3, 22),
        Partial::new(MatrixName::Kc, 0, 1, 3, 23), Partial::new(MatrixName::Kc, 1, 0, 3, 23),
        Partial::new(MatrixName::Kc, 1, 1, 3, 22), Partial::new(MatrixName::Kc, 1, 2, 3, 23),
        Partial::new(MatrixName::Kc, 2, 1, 3, 23), Partial::new(MatrixName::Kc, 2, 2, 3, 24),
        Partial::new(MatrixName::C0, 0, 0, 4, 22), Partial::new(MatrixName::C0, 0, 1, 4, 23),
        Partial::new(MatrixName::C0, 1, 0, 4, 23), Partial::new(MatrixName::C0, 1, 1, 4, 22),
        Partial::new(MatrixName::C0, 1, 2, 4, 23), Partial::new(MatrixName::C0, 2, 1, 4, 23),
        Partial::new(MatrixName::C0, 2, 2, 4, 24),
    ];
}
