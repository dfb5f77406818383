// @generated from generated/models/two_pipes.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: bde37c98167ee8c2

/// Two pipes in a row that carry a fluid, hanging: a garden hose with two hinges.
///
/// Rigid pipes of equal length, the first hinged to a wall and the second to the first, each hinge with a spring and
/// a damper. The speed v is that of the fluid, which leaves at the free end along the second pipe; above a critical
/// speed the pipes buckle or flutter.
///
/// Source: Hamilton's principle for a fluid that leaves the system, as Benjamin (1961) has it: Proc. R. Soc. A 261, 457-486
///
/// The fields are the parameters. The coordinates are `first` in rad, `second` in rad.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TwoPipes<T = ::core::primitive::f64> {
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
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl TwoPipes<::core::primitive::f64> {
    /// The parameter set `hose`.
    ///
    /// Source: a hose of rubber, by estimate
    pub const HOSE: Self = Self {
        l: 0.5,
        m: 0.2,
        f: 0.3,
        k: 0.5,
        c: 0.01,
        g: 9.81,
    };
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> TwoPipes<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 6]) -> Self {
        Self {
            l: values[0],
            m: values[1],
            f: values[2],
            k: values[3],
            c: values[4],
            g: values[5],
        }
    }
    /// The parameters as an array in declared order.
    #[must_use]
    pub const fn to_array(&self) -> [T; 6] {
        [self.l, self.m, self.f, self.k, self.c, self.g]
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> TwoPipes<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: ::carvallo::Scalar>(&self) -> TwoPipes<U> {
        TwoPipes {
            l: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.l)),
            m: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.m)),
            f: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.f)),
            k: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.k)),
            c: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.c)),
            g: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.g)),
        }
    }
}
/// The coefficient matrices of [`TwoPipes`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TwoPipesMatrices<T = ::core::primitive::f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: [[T; 2]; 2],
    /// Damping C0, a coefficient of q'. Symmetric, proved.
    pub c0: [[T; 2]; 2],
    /// Damping C1, a coefficient of v q'.
    pub c1: [[T; 2]; 2],
    /// Stiffness Kc, a coefficient of q. Symmetric, proved.
    pub kc: [[T; 2]; 2],
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: [[T; 2]; 2],
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: [[T; 2]; 2],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> TwoPipes<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 1 addition, 14 multiplications and 3 negations: 18 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> TwoPipesMatrices<T> {
        let t1 = self.l * self.l;
        let t5 = self.m + self.f;
        let inertia = (self.l * t1) * t5;
        let t8 = inertia * ::carvallo::Number::like(self.l, 1.3333333333333333);
        let t10 = inertia * ::carvallo::Number::like(self.l, 0.5);
        let t12 = inertia * ::carvallo::Number::like(self.l, 0.3333333333333333);
        let t15 = self.c * ::carvallo::Number::like(self.l, 2.0);
        let t16 = self.f * t1;
        let t17 = ::carvallo::Number::like(self.l, 2.0) * t16;
        let t20 = self.k * ::carvallo::Number::like(self.l, 2.0);
        let weight = t1 * t5;
        let t23 = weight * ::carvallo::Number::like(self.l, 1.5);
        let t24 = weight * ::carvallo::Number::like(self.l, 0.5);
        let t25 = self.l * self.f;
        let t26 = -self.c;
        let t27 = -self.k;
        let t28 = -t25;
        TwoPipesMatrices {
            m: [[t8, t10], [t10, t12]],
            c0: [[t15, t26], [t26, self.c]],
            c1: [[t16, t17], [::carvallo::Number::like(self.l, 0.0), t16]],
            kc: [[t20, t27], [t27, self.k]],
            k0: [
                [t23, ::carvallo::Number::like(self.l, 0.0)],
                [::carvallo::Number::like(self.l, 0.0), t24],
            ],
            k2: [
                [t28, t25],
                [
                    ::carvallo::Number::like(self.l, 0.0),
                    ::carvallo::Number::like(self.l, 0.0),
                ],
            ],
        }
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Model<2> for TwoPipes<T> {
    type Scalar = T;
    type Parameters = [T; 6];
    type Over<U: ::carvallo::Number> = TwoPipes<U>;
    const INFO: &'static ::carvallo::ModelInfo = &::carvallo::ModelInfo {
        name: "TwoPipes",
        docs: "Two pipes in a row that carry a fluid, hanging: a garden hose with two hinges.\n\nRigid pipes of equal length, the first hinged to a wall and the second to the first, each hinge with a spring and\na damper. The speed v is that of the fluid, which leaves at the free end along the second pipe; above a critical\nspeed the pipes buckle or flutter.",
        source: "Hamilton's principle for a fluid that leaves the system, as Benjamin (1961) has it: Proc. R. Soc. A 261, 457-486",
        parameters: &[
            ::carvallo::ParameterInfo {
                name: "l",
                symbol: "l",
                docs: "Length of each pipe.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "m",
                symbol: "m",
                docs: "Mass of a pipe for each metre.",
                unit: "kg/m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "f",
                symbol: "f",
                docs: "Mass of the fluid in it for each metre.",
                unit: "kg/m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "k",
                symbol: "k",
                docs: "Stiffness of each hinge.",
                unit: "N*m/rad",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "c",
                symbol: "c",
                docs: "Damping of each hinge.",
                unit: "N*m*s/rad",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "g",
                symbol: "g",
                docs: "Gravitational field strength.",
                unit: "N/kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
        ],
        coordinates: &[
            ::carvallo::CoordinateInfo {
                name: "first",
                label: "first",
                docs: "Angle of the first pipe from the vertical.",
                unit: "rad",
            },
            ::carvallo::CoordinateInfo {
                name: "second",
                label: "second",
                docs: "Angle of the second pipe from the vertical.",
                unit: "rad",
            },
        ],
        matrices: &["M", "C0", "C1", "Kc", "K0", "K2"],
        entries: &[
            ::carvallo::EntryInfo {
                places: &[("M", 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("M", 0, 1), ("M", 1, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("M", 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("C0", 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("C0", 0, 1), ("C0", 1, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("C0", 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("C1", 0, 0), ("C1", 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("C1", 0, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("Kc", 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("Kc", 0, 1), ("Kc", 1, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("Kc", 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("K0", 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("K0", 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("K2", 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("K2", 0, 1)],
            },
        ],
        sets: &[
            ::carvallo::SetInfo {
                name: "hose",
                docs: "",
                source: "a hose of rubber, by estimate",
                values: &[0.5, 0.2, 0.3, 0.5, 0.01, 9.81],
            },
        ],
        gravity: ::core::option::Option::Some(5),
    };
    fn from_slice(
        values: &[T],
    ) -> ::core::result::Result<Self, ::carvallo::LengthError> {
        if values.len() != 6 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "TwoPipes",
                expected: 6,
                found: values.len(),
            });
        }
        ::core::result::Result::Ok(Self {
            l: values[0],
            m: values[1],
            f: values[2],
            k: values[3],
            c: values[4],
            g: values[5],
        })
    }
    fn write_to(
        &self,
        values: &mut [T],
    ) -> ::core::result::Result<(), ::carvallo::LengthError> {
        if values.len() != 6 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "TwoPipes",
                expected: 6,
                found: values.len(),
            });
        }
        values.copy_from_slice(&self.to_array());
        ::core::result::Result::Ok(())
    }
    #[inline(always)]
    fn parameters(&self) -> Self::Parameters {
        self.to_array()
    }
    fn validate(&self) -> ::core::result::Result<(), ::carvallo::ParameterError> {
        let info = <Self as ::carvallo::Model<2>>::INFO;
        info.validate(
            &[
                ::carvallo::Scalar::to_f64(self.l),
                ::carvallo::Scalar::to_f64(self.m),
                ::carvallo::Scalar::to_f64(self.f),
                ::carvallo::Scalar::to_f64(self.k),
                ::carvallo::Scalar::to_f64(self.c),
                ::carvallo::Scalar::to_f64(self.g),
            ],
        )?;
        ::core::result::Result::Ok(())
    }
    #[inline]
    fn coefficients(&self) -> ::carvallo::Coefficients<T, 2> {
        let matrices = self.matrices();
        ::carvallo::Coefficients::from_rows([
            matrices.m,
            matrices.c0,
            matrices.c1,
            matrices.kc,
            matrices.k0,
            matrices.k2,
        ])
    }
    fn gravity(&self) -> ::core::option::Option<T> {
        ::core::option::Option::Some(self.g)
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> ::carvallo::Evaluator<T, 2> for TwoPipes<T> {
    type Entries = [T; 15];
    #[inline(always)]
    fn from_parameters(
        mut parameter: impl ::core::ops::FnMut(::core::primitive::usize) -> T,
    ) -> Self {
        Self {
            l: parameter(0),
            m: parameter(1),
            f: parameter(2),
            k: parameter(3),
            c: parameter(4),
            g: parameter(5),
        }
    }
    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        let matrices = self.matrices();
        [
            matrices.m[0][0],
            matrices.m[0][1],
            matrices.m[1][1],
            matrices.c0[0][0],
            matrices.c0[0][1],
            matrices.c0[1][1],
            matrices.c1[0][0],
            matrices.c1[0][1],
            matrices.kc[0][0],
            matrices.kc[0][1],
            matrices.kc[1][1],
            matrices.k0[0][0],
            matrices.k0[1][1],
            matrices.k2[0][0],
            matrices.k2[0][1],
        ]
    }
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 6] {
        let matrices = self.matrices();
        [matrices.m, matrices.c0, matrices.c1, matrices.kc, matrices.k0, matrices.k2]
    }
}
