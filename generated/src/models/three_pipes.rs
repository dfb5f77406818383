// @generated from generated/models/three_pipes.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 92f4761ae2f6100e

/// Three pipes in a row that carry a fluid, hanging: a garden hose with three hinges.
///
/// Rigid pipes of equal length, the first hinged to a wall and each other one to the one before it, each hinge with a
/// spring and a damper. The speed v is that of the fluid, which leaves at the free end along the last pipe; above a
/// critical speed the pipes buckle or flutter.
///
/// Source: Hamilton's principle for a fluid that leaves the system, as Benjamin (1961) has it: Proc. R. Soc. A 261, 457-486
///
/// The fields are the parameters. The coordinates are `first` in rad, `second` in rad, `third` in rad.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ThreePipes<T = ::core::primitive::f64> {
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
impl ThreePipes<::core::primitive::f64> {
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
impl<T: ::carvallo::Number> ThreePipes<T> {
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
impl<T: ::carvallo::Scalar> ThreePipes<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: ::carvallo::Scalar>(&self) -> ThreePipes<U> {
        ThreePipes {
            l: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.l)),
            m: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.m)),
            f: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.f)),
            k: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.k)),
            c: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.c)),
            g: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.g)),
        }
    }
}
/// The coefficient matrices of [`ThreePipes`], each 3 x 3 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ThreePipesMatrices<T = ::core::primitive::f64> {
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
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> ThreePipes<T> {
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
        let t8 = inertia * ::carvallo::Number::like(self.l, 2.3333333333333335);
        let t10 = inertia * ::carvallo::Number::like(self.l, 1.5);
        let t12 = inertia * ::carvallo::Number::like(self.l, 0.5);
        let t14 = inertia * ::carvallo::Number::like(self.l, 1.3333333333333333);
        let t16 = inertia * ::carvallo::Number::like(self.l, 0.3333333333333333);
        let t18 = self.c + self.c;
        let t20 = t1 * self.f;
        let t21 = t20 + t20;
        let t23 = self.k + self.k;
        let t25 = weight * ::carvallo::Number::like(self.l, 2.5);
        let t26 = weight * ::carvallo::Number::like(self.l, 1.5);
        let t27 = weight * ::carvallo::Number::like(self.l, 0.5);
        let t28 = self.l * self.f;
        let t29 = -self.c;
        let t30 = -self.k;
        let t31 = -t28;
        {
            #[inline(always)]
            fn matrix<T: ::core::marker::Copy>(
                entries: &[T; 54],
                first: ::core::primitive::usize,
            ) -> [[T; 3]; 3] {
                [
                    [entries[first], entries[first + 1], entries[first + 2]],
                    [entries[first + 3], entries[first + 4], entries[first + 5]],
                    [entries[first + 6], entries[first + 7], entries[first + 8]],
                ]
            }
            let entries = [
                t8,
                t10,
                t12,
                t10,
                t14,
                t12,
                t12,
                t12,
                t16,
                t18,
                t29,
                ::carvallo::Number::like(self.l, 0.0),
                t29,
                t18,
                t29,
                ::carvallo::Number::like(self.l, 0.0),
                t29,
                self.c,
                t20,
                t21,
                t21,
                ::carvallo::Number::like(self.l, 0.0),
                t20,
                t21,
                ::carvallo::Number::like(self.l, 0.0),
                ::carvallo::Number::like(self.l, 0.0),
                t20,
                t23,
                t30,
                ::carvallo::Number::like(self.l, 0.0),
                t30,
                t23,
                t30,
                ::carvallo::Number::like(self.l, 0.0),
                t30,
                self.k,
                t25,
                ::carvallo::Number::like(self.l, 0.0),
                ::carvallo::Number::like(self.l, 0.0),
                ::carvallo::Number::like(self.l, 0.0),
                t26,
                ::carvallo::Number::like(self.l, 0.0),
                ::carvallo::Number::like(self.l, 0.0),
                ::carvallo::Number::like(self.l, 0.0),
                t27,
                t31,
                ::carvallo::Number::like(self.l, 0.0),
                t28,
                ::carvallo::Number::like(self.l, 0.0),
                t31,
                t28,
                ::carvallo::Number::like(self.l, 0.0),
                ::carvallo::Number::like(self.l, 0.0),
                ::carvallo::Number::like(self.l, 0.0),
            ];
            ThreePipesMatrices {
                m: matrix(&entries, 0),
                c0: matrix(&entries, 9),
                c1: matrix(&entries, 18),
                kc: matrix(&entries, 27),
                k0: matrix(&entries, 36),
                k2: matrix(&entries, 45),
            }
        }
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Model<3> for ThreePipes<T> {
    type Scalar = T;
    type Array<U: ::core::marker::Copy> = [U; 6];
    type Over<U: ::carvallo::Number> = ThreePipes<U>;
    const INFO: &'static ::carvallo::ModelInfo = &::carvallo::ModelInfo {
        name: "ThreePipes",
        docs: "Three pipes in a row that carry a fluid, hanging: a garden hose with three hinges.\n\nRigid pipes of equal length, the first hinged to a wall and each other one to the one before it, each hinge with a\nspring and a damper. The speed v is that of the fluid, which leaves at the free end along the last pipe; above a\ncritical speed the pipes buckle or flutter.",
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
            ::carvallo::CoordinateInfo {
                name: "third",
                label: "third",
                docs: "Angle of the third pipe from the vertical.",
                unit: "rad",
            },
        ],
        matrices: &[
            ::carvallo::MatrixName::M,
            ::carvallo::MatrixName::C0,
            ::carvallo::MatrixName::C1,
            ::carvallo::MatrixName::Kc,
            ::carvallo::MatrixName::K0,
            ::carvallo::MatrixName::K2,
        ],
        entries: &[
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::M, 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[
                    (::carvallo::MatrixName::M, 0, 1),
                    (::carvallo::MatrixName::M, 1, 0),
                ],
            },
            ::carvallo::EntryInfo {
                places: &[
                    (::carvallo::MatrixName::M, 0, 2),
                    (::carvallo::MatrixName::M, 1, 2),
                    (::carvallo::MatrixName::M, 2, 0),
                    (::carvallo::MatrixName::M, 2, 1),
                ],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::M, 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::M, 2, 2)],
            },
            ::carvallo::EntryInfo {
                places: &[
                    (::carvallo::MatrixName::C0, 0, 0),
                    (::carvallo::MatrixName::C0, 1, 1),
                ],
            },
            ::carvallo::EntryInfo {
                places: &[
                    (::carvallo::MatrixName::C0, 0, 1),
                    (::carvallo::MatrixName::C0, 1, 0),
                    (::carvallo::MatrixName::C0, 1, 2),
                    (::carvallo::MatrixName::C0, 2, 1),
                ],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::C0, 2, 2)],
            },
            ::carvallo::EntryInfo {
                places: &[
                    (::carvallo::MatrixName::C1, 0, 0),
                    (::carvallo::MatrixName::C1, 1, 1),
                    (::carvallo::MatrixName::C1, 2, 2),
                ],
            },
            ::carvallo::EntryInfo {
                places: &[
                    (::carvallo::MatrixName::C1, 0, 1),
                    (::carvallo::MatrixName::C1, 0, 2),
                    (::carvallo::MatrixName::C1, 1, 2),
                ],
            },
            ::carvallo::EntryInfo {
                places: &[
                    (::carvallo::MatrixName::Kc, 0, 0),
                    (::carvallo::MatrixName::Kc, 1, 1),
                ],
            },
            ::carvallo::EntryInfo {
                places: &[
                    (::carvallo::MatrixName::Kc, 0, 1),
                    (::carvallo::MatrixName::Kc, 1, 0),
                    (::carvallo::MatrixName::Kc, 1, 2),
                    (::carvallo::MatrixName::Kc, 2, 1),
                ],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::Kc, 2, 2)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::K0, 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::K0, 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::K0, 2, 2)],
            },
            ::carvallo::EntryInfo {
                places: &[
                    (::carvallo::MatrixName::K2, 0, 0),
                    (::carvallo::MatrixName::K2, 1, 1),
                ],
            },
            ::carvallo::EntryInfo {
                places: &[
                    (::carvallo::MatrixName::K2, 0, 2),
                    (::carvallo::MatrixName::K2, 1, 2),
                ],
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
                model: "ThreePipes",
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
                model: "ThreePipes",
                expected: 6,
                found: values.len(),
            });
        }
        values.copy_from_slice(&self.to_array());
        ::core::result::Result::Ok(())
    }
    #[inline(always)]
    fn array<U: ::core::marker::Copy>(
        element: impl ::core::ops::FnMut(::core::primitive::usize) -> U,
    ) -> Self::Array<U> {
        ::core::array::from_fn(element)
    }
    #[inline(always)]
    fn parameters(&self) -> Self::Array<T> {
        self.to_array()
    }
    fn validate(&self) -> ::core::result::Result<(), ::carvallo::ParameterError> {
        let info = <Self as ::carvallo::Model<3>>::INFO;
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
    fn coefficients(&self) -> ::carvallo::Coefficients<T, 3> {
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
impl<T: ::carvallo::Number> ::carvallo::Evaluator<T, 3> for ThreePipes<T> {
    type Entries = [T; 18];
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
            matrices.m[0][2],
            matrices.m[1][1],
            matrices.m[2][2],
            matrices.c0[0][0],
            matrices.c0[0][1],
            matrices.c0[2][2],
            matrices.c1[0][0],
            matrices.c1[0][1],
            matrices.kc[0][0],
            matrices.kc[0][1],
            matrices.kc[2][2],
            matrices.k0[0][0],
            matrices.k0[1][1],
            matrices.k0[2][2],
            matrices.k2[0][0],
            matrices.k2[0][2],
        ]
    }
    #[inline(always)]
    fn rows(&self) -> [[[T; 3]; 3]; 6] {
        let matrices = self.matrices();
        [matrices.m, matrices.c0, matrices.c1, matrices.kc, matrices.k0, matrices.k2]
    }
}
/// The derivatives of the matrices of [`ThreePipes`] with respect to its parameters, in SI units: those that are not zero for all parameters.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ThreePipesDerivatives<T = ::core::primitive::f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 25],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl ThreePipesDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [::carvallo::Partial; 70] = &[
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 2, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 0, 3),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 0, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 2, 0, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 0, 0, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 0, 6),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 2, 0, 6),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 0, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 2, 0, 6),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 2, 0, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 0, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 0, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 2, 0, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 0, 0, 10).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 2, 0, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 0, 10).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 2, 0, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 1, 11),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 1, 12),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 2, 1, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 1, 12),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 1, 14),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 1, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 0, 1, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 1, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 2, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 2, 1, 18),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 2, 11),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 2, 12),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 2, 2, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 2, 12),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 2, 14),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 2, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 0, 2, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 2, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 2, 2, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 0, 2, 19),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 2, 20),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 2, 2, 20),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 2, 19),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 2, 2, 20),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 2, 2, 19),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 2, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 2, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 2, 2, 18),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 0, 2, 21).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 2, 2, 21),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 2, 21).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 2, 2, 21),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 0, 0, 3, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 0, 1, 3, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 1, 0, 3, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 1, 1, 3, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 1, 2, 3, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 2, 1, 3, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 2, 2, 3, 24),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 0, 0, 4, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 0, 1, 4, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 1, 0, 4, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 1, 1, 4, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 1, 2, 4, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 2, 1, 4, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 2, 2, 4, 24),
    ];
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ThreePipesDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(
        &self,
        parameter: ::core::primitive::usize,
    ) -> ::core::option::Option<ThreePipesMatrices<T>> {
        if parameter >= 6 {
            return ::core::option::Option::None;
        }
        let zero = <T as ::carvallo::Scalar>::from_f64(0.0);
        let mut matrices = ThreePipesMatrices {
            m: [[zero; 3]; 3],
            c0: [[zero; 3]; 3],
            c1: [[zero; 3]; 3],
            kc: [[zero; 3]; 3],
            k0: [[zero; 3]; 3],
            k2: [[zero; 3]; 3],
        };
        for position in 0..70 {
            let partial = <ThreePipesDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                ::carvallo::MatrixName::M => &mut matrices.m,
                ::carvallo::MatrixName::C0 => &mut matrices.c0,
                ::carvallo::MatrixName::C1 => &mut matrices.c1,
                ::carvallo::MatrixName::Kc => &mut matrices.kc,
                ::carvallo::MatrixName::K0 => &mut matrices.k0,
                ::carvallo::MatrixName::K2 => &mut matrices.k2,
            };
            matrix[partial.row][partial.column] = ::carvallo::Partial::of(
                &partial,
                &self.values,
            );
        }
        ::core::option::Option::Some(matrices)
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> ThreePipes<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 6 additions, 32 multiplications and 3 negations: 41 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(
        &self,
    ) -> (ThreePipesMatrices<T>, ThreePipesDerivatives<T>) {
        let t2 = self.m + self.f;
        let weight_m = self.l * self.l;
        let inertia_m = self.l * weight_m;
        let inertia = t2 * inertia_m;
        let t8 = inertia * ::carvallo::Number::like(self.l, 2.3333333333333335);
        let t10 = inertia * ::carvallo::Number::like(self.l, 1.5);
        let t12 = inertia * ::carvallo::Number::like(self.l, 0.5);
        let t14 = inertia * ::carvallo::Number::like(self.l, 1.3333333333333333);
        let t16 = inertia * ::carvallo::Number::like(self.l, 0.3333333333333333);
        let t18 = self.c + self.c;
        let t20 = self.f * weight_m;
        let t21 = weight_m + weight_m;
        let t22 = self.f * t21;
        let t24 = self.k + self.k;
        let weight = t2 * weight_m;
        let t27 = weight * ::carvallo::Number::like(self.l, 2.5);
        let t28 = ::carvallo::Number::like(self.l, 1.5) * weight;
        let t29 = ::carvallo::Number::like(self.l, 0.5) * weight;
        let t30 = self.f * self.l;
        let inertia_l = weight * ::carvallo::Number::like(self.l, 3.0);
        let t33 = ::carvallo::Number::like(self.l, 2.3333333333333335) * inertia_l;
        let t34 = ::carvallo::Number::like(self.l, 1.5) * inertia_l;
        let t35 = ::carvallo::Number::like(self.l, 0.5) * inertia_l;
        let t36 = ::carvallo::Number::like(self.l, 1.3333333333333333) * inertia_l;
        let t37 = t30 + t30;
        let t39 = t30 * ::carvallo::Number::like(self.l, 4.0);
        let t40 = t2 * self.l;
        let weight_l = t40 + t40;
        let t42 = ::carvallo::Number::like(self.l, 2.5) * weight_l;
        let t43 = ::carvallo::Number::like(self.l, 1.5) * weight_l;
        let t44 = inertia_m * ::carvallo::Number::like(self.l, 2.3333333333333335);
        let t45 = inertia_m * ::carvallo::Number::like(self.l, 1.5);
        let t46 = inertia_m * ::carvallo::Number::like(self.l, 0.5);
        let t47 = inertia_m * ::carvallo::Number::like(self.l, 1.3333333333333333);
        let t48 = inertia_m * ::carvallo::Number::like(self.l, 0.3333333333333333);
        let t49 = weight_m * ::carvallo::Number::like(self.l, 2.5);
        let t50 = weight_m * ::carvallo::Number::like(self.l, 1.5);
        let t51 = weight_m * ::carvallo::Number::like(self.l, 0.5);
        let t54 = -self.c;
        let t55 = -self.k;
        let t56 = -t30;
        (
            {
                #[inline(always)]
                fn matrix<T: ::core::marker::Copy>(
                    entries: &[T; 54],
                    first: ::core::primitive::usize,
                ) -> [[T; 3]; 3] {
                    [
                        [entries[first], entries[first + 1], entries[first + 2]],
                        [entries[first + 3], entries[first + 4], entries[first + 5]],
                        [entries[first + 6], entries[first + 7], entries[first + 8]],
                    ]
                }
                let entries = [
                    t8,
                    t10,
                    t12,
                    t10,
                    t14,
                    t12,
                    t12,
                    t12,
                    t16,
                    t18,
                    t54,
                    ::carvallo::Number::like(self.l, 0.0),
                    t54,
                    t18,
                    t54,
                    ::carvallo::Number::like(self.l, 0.0),
                    t54,
                    self.c,
                    t20,
                    t22,
                    t22,
                    ::carvallo::Number::like(self.l, 0.0),
                    t20,
                    t22,
                    ::carvallo::Number::like(self.l, 0.0),
                    ::carvallo::Number::like(self.l, 0.0),
                    t20,
                    t24,
                    t55,
                    ::carvallo::Number::like(self.l, 0.0),
                    t55,
                    t24,
                    t55,
                    ::carvallo::Number::like(self.l, 0.0),
                    t55,
                    self.k,
                    t27,
                    ::carvallo::Number::like(self.l, 0.0),
                    ::carvallo::Number::like(self.l, 0.0),
                    ::carvallo::Number::like(self.l, 0.0),
                    t28,
                    ::carvallo::Number::like(self.l, 0.0),
                    ::carvallo::Number::like(self.l, 0.0),
                    ::carvallo::Number::like(self.l, 0.0),
                    t29,
                    t56,
                    ::carvallo::Number::like(self.l, 0.0),
                    t30,
                    ::carvallo::Number::like(self.l, 0.0),
                    t56,
                    t30,
                    ::carvallo::Number::like(self.l, 0.0),
                    ::carvallo::Number::like(self.l, 0.0),
                    ::carvallo::Number::like(self.l, 0.0),
                ];
                ThreePipesMatrices {
                    m: matrix(&entries, 0),
                    c0: matrix(&entries, 9),
                    c1: matrix(&entries, 18),
                    kc: matrix(&entries, 27),
                    k0: matrix(&entries, 36),
                    k2: matrix(&entries, 45),
                }
            },
            ThreePipesDerivatives {
                values: [
                    t33,
                    t34,
                    t35,
                    t36,
                    weight,
                    t37,
                    t39,
                    t42,
                    t43,
                    t40,
                    self.f,
                    t44,
                    t45,
                    t46,
                    t47,
                    t48,
                    t49,
                    t50,
                    t51,
                    weight_m,
                    t21,
                    self.l,
                    ::carvallo::Number::like(self.l, 2.0),
                    ::carvallo::Number::like(self.l, -1.0),
                    ::carvallo::Number::like(self.l, 1.0),
                ],
            },
        )
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Differentiable<3> for ThreePipes<T> {
    type Derivatives = [::carvallo::Coefficients<T, 3>; 6];
    fn coefficients_and_derivatives(
        &self,
    ) -> (::carvallo::Coefficients<T, 3>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let mut all = [::carvallo::Coefficients::from_rows(
            [[[<T as ::carvallo::Scalar>::from_f64(0.0); 3]; 3]; 6],
        ); 6];
        for position in 0..70 {
            ::carvallo::Partial::write(
                &<ThreePipesDerivatives>::PARTIALS[position],
                &derivatives.values,
                &mut all,
            );
        }
        (
            ::carvallo::Coefficients::from_rows([
                matrices.m,
                matrices.c0,
                matrices.c1,
                matrices.kc,
                matrices.k0,
                matrices.k2,
            ]),
            all,
        )
    }
}
