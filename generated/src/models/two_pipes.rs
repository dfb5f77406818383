// @generated from generated/models/two_pipes.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 9d0891a8e975b587

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
    /// 4 additions, 10 multiplications and 3 negations: 17 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> TwoPipesMatrices<T> {
        let t1 = self.l * self.l;
        let weight = t1 * (self.m + self.f);
        let inertia = self.l * weight;
        let t8 = inertia * ::carvallo::Number::like(self.l, 1.3333333333333333);
        let t10 = inertia * ::carvallo::Number::like(self.l, 0.5);
        let t12 = inertia * ::carvallo::Number::like(self.l, 0.3333333333333333);
        let t14 = self.c + self.c;
        let t15 = t1 * self.f;
        let t16 = t15 + t15;
        let t19 = self.k + self.k;
        let t21 = weight * ::carvallo::Number::like(self.l, 1.5);
        let t22 = weight * ::carvallo::Number::like(self.l, 0.5);
        let t23 = self.l * self.f;
        let t24 = -self.c;
        let t25 = -self.k;
        let t26 = -t23;
        {
            #[inline(always)]
            fn matrix<T: ::core::marker::Copy>(
                entries: &[T; 24],
                first: ::core::primitive::usize,
            ) -> [[T; 2]; 2] {
                [
                    [entries[first], entries[first + 1]],
                    [entries[first + 2], entries[first + 3]],
                ]
            }
            let entries = [
                t8,
                t10,
                t10,
                t12,
                t14,
                t24,
                t24,
                self.c,
                t15,
                t16,
                ::carvallo::Number::like(self.l, 0.0),
                t15,
                t19,
                t25,
                t25,
                self.k,
                t21,
                ::carvallo::Number::like(self.l, 0.0),
                ::carvallo::Number::like(self.l, 0.0),
                t22,
                t26,
                t23,
                ::carvallo::Number::like(self.l, 0.0),
                ::carvallo::Number::like(self.l, 0.0),
            ];
            TwoPipesMatrices {
                m: matrix(&entries, 0),
                c0: matrix(&entries, 4),
                c1: matrix(&entries, 8),
                kc: matrix(&entries, 12),
                k0: matrix(&entries, 16),
                k2: matrix(&entries, 20),
            }
        }
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Model<2> for TwoPipes<T> {
    type Scalar = T;
    type Array<U: ::core::marker::Copy> = [U; 6];
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
                places: &[(::carvallo::MatrixName::M, 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::C0, 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[
                    (::carvallo::MatrixName::C0, 0, 1),
                    (::carvallo::MatrixName::C0, 1, 0),
                ],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::C0, 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[
                    (::carvallo::MatrixName::C1, 0, 0),
                    (::carvallo::MatrixName::C1, 1, 1),
                ],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::C1, 0, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::Kc, 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[
                    (::carvallo::MatrixName::Kc, 0, 1),
                    (::carvallo::MatrixName::Kc, 1, 0),
                ],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::Kc, 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::K0, 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::K0, 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::K2, 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::K2, 0, 1)],
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
/// The derivatives of the matrices of [`TwoPipes`] with respect to its parameters, in SI units: those that are not zero for all parameters.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TwoPipesDerivatives<T = ::core::primitive::f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 19],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl TwoPipesDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [::carvallo::Partial; 36] = &[
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 0, 0, 3),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 0, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 0, 3),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 0, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 0, 6),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 0, 0, 7).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 0, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 1, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 1, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 1, 11),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 1, 12),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 2, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 2, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 2, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 2, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 0, 2, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 2, 14),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 2, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 2, 11),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 2, 12),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 0, 2, 15).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 2, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 0, 0, 3, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 0, 1, 3, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 1, 0, 3, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 1, 1, 3, 18),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 0, 0, 4, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 0, 1, 4, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 1, 0, 4, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 1, 1, 4, 18),
    ];
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> TwoPipesDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(
        &self,
        parameter: ::core::primitive::usize,
    ) -> ::core::option::Option<TwoPipesMatrices<T>> {
        if parameter >= 6 {
            return ::core::option::Option::None;
        }
        let zero = <T as ::carvallo::Scalar>::from_f64(0.0);
        let mut matrices = TwoPipesMatrices {
            m: [[zero; 2]; 2],
            c0: [[zero; 2]; 2],
            c1: [[zero; 2]; 2],
            kc: [[zero; 2]; 2],
            k0: [[zero; 2]; 2],
            k2: [[zero; 2]; 2],
        };
        for position in 0..36 {
            let partial = <TwoPipesDerivatives>::PARTIALS[position];
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
impl<T: ::carvallo::Number> TwoPipes<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 5 additions, 22 multiplications and 3 negations: 30 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(
        &self,
    ) -> (TwoPipesMatrices<T>, TwoPipesDerivatives<T>) {
        let t2 = self.m + self.f;
        let weight_m = self.l * self.l;
        let inertia_m = self.l * weight_m;
        let inertia = t2 * inertia_m;
        let t8 = inertia * ::carvallo::Number::like(self.l, 1.3333333333333333);
        let t10 = inertia * ::carvallo::Number::like(self.l, 0.5);
        let t12 = inertia * ::carvallo::Number::like(self.l, 0.3333333333333333);
        let t14 = self.c + self.c;
        let t15 = self.f * weight_m;
        let t16 = weight_m + weight_m;
        let t17 = self.f * t16;
        let t20 = self.k + self.k;
        let weight = t2 * weight_m;
        let t23 = weight * ::carvallo::Number::like(self.l, 1.5);
        let t24 = ::carvallo::Number::like(self.l, 0.5) * weight;
        let t25 = self.f * self.l;
        let t27 = weight * ::carvallo::Number::like(self.l, 4.0);
        let t29 = t24 * ::carvallo::Number::like(self.l, 3.0);
        let t30 = t25 + t25;
        let t31 = t25 * ::carvallo::Number::like(self.l, 4.0);
        let t32 = t2 * self.l;
        let t33 = ::carvallo::Number::like(self.l, 3.0) * t32;
        let t34 = inertia_m * ::carvallo::Number::like(self.l, 1.3333333333333333);
        let t35 = inertia_m * ::carvallo::Number::like(self.l, 0.5);
        let t36 = inertia_m * ::carvallo::Number::like(self.l, 0.3333333333333333);
        let t37 = weight_m * ::carvallo::Number::like(self.l, 1.5);
        let t38 = weight_m * ::carvallo::Number::like(self.l, 0.5);
        let t41 = -self.c;
        let t42 = -self.k;
        let t43 = -t25;
        (
            {
                #[inline(always)]
                fn matrix<T: ::core::marker::Copy>(
                    entries: &[T; 24],
                    first: ::core::primitive::usize,
                ) -> [[T; 2]; 2] {
                    [
                        [entries[first], entries[first + 1]],
                        [entries[first + 2], entries[first + 3]],
                    ]
                }
                let entries = [
                    t8,
                    t10,
                    t10,
                    t12,
                    t14,
                    t41,
                    t41,
                    self.c,
                    t15,
                    t17,
                    ::carvallo::Number::like(self.l, 0.0),
                    t15,
                    t20,
                    t42,
                    t42,
                    self.k,
                    t23,
                    ::carvallo::Number::like(self.l, 0.0),
                    ::carvallo::Number::like(self.l, 0.0),
                    t24,
                    t43,
                    t25,
                    ::carvallo::Number::like(self.l, 0.0),
                    ::carvallo::Number::like(self.l, 0.0),
                ];
                TwoPipesMatrices {
                    m: matrix(&entries, 0),
                    c0: matrix(&entries, 4),
                    c1: matrix(&entries, 8),
                    kc: matrix(&entries, 12),
                    k0: matrix(&entries, 16),
                    k2: matrix(&entries, 20),
                }
            },
            TwoPipesDerivatives {
                values: [
                    t27,
                    t29,
                    weight,
                    t30,
                    t31,
                    t33,
                    t32,
                    self.f,
                    t34,
                    t35,
                    t36,
                    t37,
                    t38,
                    weight_m,
                    t16,
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
impl<T: ::carvallo::Scalar> ::carvallo::Differentiable<2> for TwoPipes<T> {
    type Derivatives = [::carvallo::Coefficients<T, 2>; 6];
    fn coefficients_and_derivatives(
        &self,
    ) -> (::carvallo::Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let mut all = [::carvallo::Coefficients::from_rows(
            [[[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2]; 6],
        ); 6];
        for position in 0..36 {
            ::carvallo::Partial::write(
                &<TwoPipesDerivatives>::PARTIALS[position],
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
