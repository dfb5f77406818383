// @generated from generated/models/rolling_disc.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: e7913b7415a9f3b4

/// A disc that rolls without slip on level ground, upright and straight but for small lean and yaw.
///
/// Its spin balances it: it falls over, slowly, unless v^2 > g r It m r^2/(Ia (Ia + m r^2)), which is g r/3 for a
/// uniform disc and g r/4 for a hoop. Axes: origin at the contact point, x forward, y to the right, z down.
///
/// Source: Mechanism: Neimark & Fufaev (1972), Dynamics of Nonholonomic Systems
///
/// Derived from a mechanism: wheel `D` (disc).
///
/// The fields are the parameters. The coordinates are `phi` (lean) in rad, `psi` (yaw) in rad.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RollingDisc<T = ::core::primitive::f64> {
    /// Radius.
    ///
    /// `r` in m: > 0.
    pub r: T,
    /// Mass.
    ///
    /// `m` in kg: > 0.
    pub m: T,
    /// Axial moment of inertia, about the axle.
    ///
    /// `Ia` in kg*m^2: >= 0.
    pub Ia: T,
    /// Transverse moment of inertia, about a diameter.
    ///
    /// `It` in kg*m^2: > 0.
    pub It: T,
    /// Gravitational field strength.
    ///
    /// `g` in N/kg: >= 0.
    pub g: T,
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl RollingDisc<::core::primitive::f64> {
    /// The parameter set `uniform`.
    ///
    /// Source: A uniform disc of 1 kg: Ia = m r^2/2, It = m r^2/4
    pub const UNIFORM: Self = Self {
        r: 0.3,
        m: 1.0,
        Ia: 0.045,
        It: 0.0225,
        g: 9.81,
    };
    /// The parameter set `hoop`.
    ///
    /// Source: A hoop of 1 kg: Ia = m r^2, It = m r^2/2
    pub const HOOP: Self = Self {
        r: 0.3,
        m: 1.0,
        Ia: 0.09,
        It: 0.045,
        g: 9.81,
    };
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> RollingDisc<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 5]) -> Self {
        Self {
            r: values[0],
            m: values[1],
            Ia: values[2],
            It: values[3],
            g: values[4],
        }
    }
    /// The parameters as an array in declared order.
    #[must_use]
    pub const fn to_array(&self) -> [T; 5] {
        [self.r, self.m, self.Ia, self.It, self.g]
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> RollingDisc<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: ::carvallo::Scalar>(&self) -> RollingDisc<U> {
        RollingDisc {
            r: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.r)),
            m: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.m)),
            Ia: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.Ia)),
            It: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.It)),
            g: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.g)),
        }
    }
}
/// The coefficient matrices of [`RollingDisc`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RollingDiscMatrices<T = ::core::primitive::f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: [[T; 2]; 2],
    /// Damping C1, a coefficient of v q'.
    pub c1: [[T; 2]; 2],
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: [[T; 2]; 2],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> RollingDisc<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 2 additions, 2 multiplications, 1 division and 2 negations: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> RollingDiscMatrices<T> {
        let t3 = self.r * self.m;
        let Jxx_all = self.It + (self.r * t3);
        let h_spin_D = self.Ia / self.r;
        let t9 = t3 + h_spin_D;
        let t10 = -h_spin_D;
        let t11 = -t3;
        {
            #[inline(always)]
            fn matrix<T: ::core::marker::Copy>(
                entries: &[T; 12],
                first: ::core::primitive::usize,
            ) -> [[T; 2]; 2] {
                [
                    [entries[first], entries[first + 1]],
                    [entries[first + 2], entries[first + 3]],
                ]
            }
            let entries = [
                Jxx_all,
                ::carvallo::Number::like(self.r, 0.0),
                ::carvallo::Number::like(self.r, 0.0),
                self.It,
                ::carvallo::Number::like(self.r, 0.0),
                t9,
                t10,
                ::carvallo::Number::like(self.r, 0.0),
                t11,
                ::carvallo::Number::like(self.r, 0.0),
                ::carvallo::Number::like(self.r, 0.0),
                ::carvallo::Number::like(self.r, 0.0),
            ];
            RollingDiscMatrices {
                m: matrix(&entries, 0),
                c1: matrix(&entries, 4),
                k0: matrix(&entries, 8),
            }
        }
    }
}
/// Rates and forces of [`RollingDisc`] that follow from its coordinates q = (`phi`, `psi`), to first order and in SI units.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RollingDiscKinematics<T = ::core::primitive::f64> {
    /// Lateral velocity, to the right, in m/s: of the point of `D` that is at the origin.
    pub lateral: ::carvallo::Rate<T, 2>,
    /// Spin of the wheel `D`, disc: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_D: ::carvallo::Rate<T, 2>,
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> RollingDisc<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 division and 1 negation: 2 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> RollingDiscKinematics<T> {
        let t4 = -(::carvallo::Number::like(self.r, 1.0) / self.r);
        RollingDiscKinematics {
            lateral: ::carvallo::Rate {
                speed: ::carvallo::Number::like(self.r, 0.0),
                rates: [
                    ::carvallo::Number::like(self.r, 0.0),
                    ::carvallo::Number::like(self.r, 0.0),
                ],
                coordinates: [
                    ::carvallo::Number::like(self.r, 0.0),
                    ::carvallo::Number::like(self.r, 1.0),
                ],
                heading: ::carvallo::Number::like(self.r, 0.0),
            },
            wheel_D: ::carvallo::Rate {
                speed: t4,
                rates: [
                    ::carvallo::Number::like(self.r, 0.0),
                    ::carvallo::Number::like(self.r, 0.0),
                ],
                coordinates: [
                    ::carvallo::Number::like(self.r, 0.0),
                    ::carvallo::Number::like(self.r, 0.0),
                ],
                heading: ::carvallo::Number::like(self.r, 0.0),
            },
        }
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Model<2> for RollingDisc<T> {
    type Scalar = T;
    type Array<U: ::core::marker::Copy> = [U; 5];
    type Over<U: ::carvallo::Number> = RollingDisc<U>;
    const INFO: &'static ::carvallo::ModelInfo = &::carvallo::ModelInfo {
        name: "RollingDisc",
        docs: "A disc that rolls without slip on level ground, upright and straight but for small lean and yaw.\n\nIts spin balances it: it falls over, slowly, unless v^2 > g r It m r^2/(Ia (Ia + m r^2)), which is g r/3 for a\nuniform disc and g r/4 for a hoop. Axes: origin at the contact point, x forward, y to the right, z down.",
        source: "Mechanism: Neimark & Fufaev (1972), Dynamics of Nonholonomic Systems",
        parameters: &[
            ::carvallo::ParameterInfo {
                name: "r",
                symbol: "r",
                docs: "Radius.",
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
                docs: "Mass.",
                unit: "kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "Ia",
                symbol: "Ia",
                docs: "Axial moment of inertia, about the axle.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "It",
                symbol: "It",
                docs: "Transverse moment of inertia, about a diameter.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
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
                name: "phi",
                label: "lean",
                docs: "Lean, positive to the right.",
                unit: "rad",
            },
            ::carvallo::CoordinateInfo {
                name: "psi",
                label: "yaw",
                docs: "Yaw, positive to the right.",
                unit: "rad",
            },
        ],
        matrices: &[
            ::carvallo::MatrixName::M,
            ::carvallo::MatrixName::C1,
            ::carvallo::MatrixName::K0,
        ],
        entries: &[
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::M, 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::M, 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::C1, 0, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::C1, 1, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::K0, 0, 0)],
            },
        ],
        sets: &[
            ::carvallo::SetInfo {
                name: "uniform",
                docs: "",
                source: "A uniform disc of 1 kg: Ia = m r^2/2, It = m r^2/4",
                values: &[0.3, 1.0, 0.045, 0.0225, 9.81],
            },
            ::carvallo::SetInfo {
                name: "hoop",
                docs: "",
                source: "A hoop of 1 kg: Ia = m r^2, It = m r^2/2",
                values: &[0.3, 1.0, 0.09, 0.045, 9.81],
            },
        ],
        gravity: ::core::option::Option::Some(4),
    };
    fn from_slice(
        values: &[T],
    ) -> ::core::result::Result<Self, ::carvallo::LengthError> {
        if values.len() != 5 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "RollingDisc",
                expected: 5,
                found: values.len(),
            });
        }
        ::core::result::Result::Ok(Self {
            r: values[0],
            m: values[1],
            Ia: values[2],
            It: values[3],
            g: values[4],
        })
    }
    fn write_to(
        &self,
        values: &mut [T],
    ) -> ::core::result::Result<(), ::carvallo::LengthError> {
        if values.len() != 5 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "RollingDisc",
                expected: 5,
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
                ::carvallo::Scalar::to_f64(self.r),
                ::carvallo::Scalar::to_f64(self.m),
                ::carvallo::Scalar::to_f64(self.Ia),
                ::carvallo::Scalar::to_f64(self.It),
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
            [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
            matrices.c1,
            [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
            matrices.k0,
            [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
        ])
    }
    fn gravity(&self) -> ::core::option::Option<T> {
        ::core::option::Option::Some(self.g)
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> ::carvallo::Evaluator<T, 2> for RollingDisc<T> {
    type Entries = [T; 5];
    #[inline(always)]
    fn from_parameters(
        mut parameter: impl ::core::ops::FnMut(::core::primitive::usize) -> T,
    ) -> Self {
        Self {
            r: parameter(0),
            m: parameter(1),
            Ia: parameter(2),
            It: parameter(3),
            g: parameter(4),
        }
    }
    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        let matrices = self.matrices();
        [
            matrices.m[0][0],
            matrices.m[1][1],
            matrices.c1[0][1],
            matrices.c1[1][0],
            matrices.k0[0][0],
        ]
    }
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 6] {
        let matrices = self.matrices();
        [
            matrices.m,
            [[::carvallo::Number::like(self.r, 0.0); 2]; 2],
            matrices.c1,
            [[::carvallo::Number::like(self.r, 0.0); 2]; 2],
            matrices.k0,
            [[::carvallo::Number::like(self.r, 0.0); 2]; 2],
        ]
    }
}
/// The derivatives of the matrices of [`RollingDisc`] with respect to its parameters, in SI units: those that are not zero for all parameters.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RollingDiscDerivatives<T = ::core::primitive::f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 8],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl RollingDiscDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [::carvallo::Partial; 11] = &[
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 0, 3).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 1, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 1, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 1, 5).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 2, 6),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 2, 6).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 3, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 3, 7),
    ];
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> RollingDiscDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(
        &self,
        parameter: ::core::primitive::usize,
    ) -> ::core::option::Option<RollingDiscMatrices<T>> {
        if parameter >= 5 {
            return ::core::option::Option::None;
        }
        let zero = <T as ::carvallo::Scalar>::from_f64(0.0);
        let mut matrices = RollingDiscMatrices {
            m: [[zero; 2]; 2],
            c1: [[zero; 2]; 2],
            k0: [[zero; 2]; 2],
        };
        for position in 0..11 {
            let partial = <RollingDiscDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                ::carvallo::MatrixName::M => &mut matrices.m,
                ::carvallo::MatrixName::C1 => &mut matrices.c1,
                ::carvallo::MatrixName::K0 => &mut matrices.k0,
                _ => continue,
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
impl<T: ::carvallo::Number> RollingDisc<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 4 additions, 5 multiplications, 1 division and 2 negations: 12 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(
        &self,
    ) -> (RollingDiscMatrices<T>, RollingDiscDerivatives<T>) {
        let t3 = self.r * self.m;
        let Jxx_all = self.It + (self.r * t3);
        let t8 = ::carvallo::Number::like(self.r, 1.0) / self.r;
        let h_spin_D = self.Ia * t8;
        let t10 = t3 + h_spin_D;
        let t11 = t3 + t3;
        let t12 = t8 * h_spin_D;
        let t13 = self.m - t12;
        let t14 = self.r * self.r;
        let t16 = -h_spin_D;
        let t17 = -t3;
        (
            {
                #[inline(always)]
                fn matrix<T: ::core::marker::Copy>(
                    entries: &[T; 12],
                    first: ::core::primitive::usize,
                ) -> [[T; 2]; 2] {
                    [
                        [entries[first], entries[first + 1]],
                        [entries[first + 2], entries[first + 3]],
                    ]
                }
                let entries = [
                    Jxx_all,
                    ::carvallo::Number::like(self.r, 0.0),
                    ::carvallo::Number::like(self.r, 0.0),
                    self.It,
                    ::carvallo::Number::like(self.r, 0.0),
                    t10,
                    t16,
                    ::carvallo::Number::like(self.r, 0.0),
                    t17,
                    ::carvallo::Number::like(self.r, 0.0),
                    ::carvallo::Number::like(self.r, 0.0),
                    ::carvallo::Number::like(self.r, 0.0),
                ];
                RollingDiscMatrices {
                    m: matrix(&entries, 0),
                    c1: matrix(&entries, 4),
                    k0: matrix(&entries, 8),
                }
            },
            RollingDiscDerivatives {
                values: [
                    t11,
                    t13,
                    t12,
                    self.m,
                    t14,
                    self.r,
                    t8,
                    ::carvallo::Number::like(self.r, 1.0),
                ],
            },
        )
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Differentiable<2> for RollingDisc<T> {
    type Derivatives = [::carvallo::Coefficients<T, 2>; 5];
    fn coefficients_and_derivatives(
        &self,
    ) -> (::carvallo::Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let mut all = [::carvallo::Coefficients::from_rows(
            [[[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2]; 6],
        ); 5];
        for position in 0..11 {
            ::carvallo::Partial::write(
                &<RollingDiscDerivatives>::PARTIALS[position],
                &derivatives.values,
                &mut all,
            );
        }
        (
            ::carvallo::Coefficients::from_rows([
                matrices.m,
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
                matrices.c1,
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
                matrices.k0,
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
            ]),
            all,
        )
    }
}
