// @generated from generated/models/pendulum.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 9f6bf78d3baf1a60

/// A pendulum with a damped joint, hanging at rest.
///
/// A point mass on a massless rod.
///
/// Source: Newton's second law about the joint
///
/// The fields are the parameters. The coordinates are `theta` (swing) in rad.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Pendulum<T = ::core::primitive::f64> {
    /// Mass of the bob.
    ///
    /// `m` in kg: > 0.
    pub m: T,
    /// Length of the rod.
    ///
    /// `l` in m: > 0.
    pub l: T,
    /// Damping of the joint.
    ///
    /// `c` in N*m*s: >= 0.
    pub c: T,
    /// Gravitational field strength.
    ///
    /// `g` in N/kg: >= 0.
    pub g: T,
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl Pendulum<::core::primitive::f64> {
    /// The parameter set `seconds`.
    ///
    /// Source: a bob of 2 kg that passes its lowest point once a second, nearly
    pub const SECONDS: Self = Self {
        m: 2.0,
        l: 0.994,
        c: 0.1,
        g: 9.81,
    };
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> Pendulum<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 4]) -> Self {
        Self {
            m: values[0],
            l: values[1],
            c: values[2],
            g: values[3],
        }
    }
    /// The parameters as an array in declared order.
    #[must_use]
    pub const fn to_array(&self) -> [T; 4] {
        [self.m, self.l, self.c, self.g]
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> Pendulum<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: ::carvallo::Scalar>(&self) -> Pendulum<U> {
        Pendulum {
            m: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.m)),
            l: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.l)),
            c: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.c)),
            g: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.g)),
        }
    }
}
/// The coefficient matrices of [`Pendulum`], each 1 x 1 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct PendulumMatrices<T = ::core::primitive::f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: [[T; 1]; 1],
    /// Damping C0, a coefficient of q'.
    pub c0: [[T; 1]; 1],
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: [[T; 1]; 1],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> Pendulum<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 2 multiplications.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> PendulumMatrices<T> {
        let t2 = self.l * self.m;
        let t3 = self.l * t2;
        {
            #[inline(always)]
            fn matrix<T: ::core::marker::Copy>(
                entries: &[T; 3],
                first: ::core::primitive::usize,
            ) -> [[T; 1]; 1] {
                [[entries[first]]]
            }
            let entries = [t3, self.c, t2];
            PendulumMatrices {
                m: matrix(&entries, 0),
                c0: matrix(&entries, 1),
                k0: matrix(&entries, 2),
            }
        }
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Model<1> for Pendulum<T> {
    type Scalar = T;
    type Array<U: ::core::marker::Copy> = [U; 4];
    type Over<U: ::carvallo::Number> = Pendulum<U>;
    const INFO: &'static ::carvallo::ModelInfo = &::carvallo::ModelInfo {
        name: "Pendulum",
        docs: "A pendulum with a damped joint, hanging at rest.\n\nA point mass on a massless rod.",
        source: "Newton's second law about the joint",
        parameters: &[
            ::carvallo::ParameterInfo {
                name: "m",
                symbol: "m",
                docs: "Mass of the bob.",
                unit: "kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "l",
                symbol: "l",
                docs: "Length of the rod.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "c",
                symbol: "c",
                docs: "Damping of the joint.",
                unit: "N*m*s",
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
                name: "theta",
                label: "swing",
                docs: "Angle of the rod from the vertical.",
                unit: "rad",
            },
        ],
        matrices: &[
            ::carvallo::MatrixName::M,
            ::carvallo::MatrixName::C0,
            ::carvallo::MatrixName::K0,
        ],
        entries: &[
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::M, 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::C0, 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::K0, 0, 0)],
            },
        ],
        sets: &[
            ::carvallo::SetInfo {
                name: "seconds",
                docs: "",
                source: "a bob of 2 kg that passes its lowest point once a second, nearly",
                values: &[2.0, 0.994, 0.1, 9.81],
            },
        ],
        gravity: ::core::option::Option::Some(3),
    };
    fn from_slice(
        values: &[T],
    ) -> ::core::result::Result<Self, ::carvallo::LengthError> {
        if values.len() != 4 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "Pendulum",
                expected: 4,
                found: values.len(),
            });
        }
        ::core::result::Result::Ok(Self {
            m: values[0],
            l: values[1],
            c: values[2],
            g: values[3],
        })
    }
    fn write_to(
        &self,
        values: &mut [T],
    ) -> ::core::result::Result<(), ::carvallo::LengthError> {
        if values.len() != 4 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "Pendulum",
                expected: 4,
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
        let info = <Self as ::carvallo::Model<1>>::INFO;
        info.validate(
            &[
                ::carvallo::Scalar::to_f64(self.m),
                ::carvallo::Scalar::to_f64(self.l),
                ::carvallo::Scalar::to_f64(self.c),
                ::carvallo::Scalar::to_f64(self.g),
            ],
        )?;
        ::core::result::Result::Ok(())
    }
    #[inline]
    fn coefficients(&self) -> ::carvallo::Coefficients<T, 1> {
        let matrices = self.matrices();
        ::carvallo::Coefficients::from_rows([
            matrices.m,
            matrices.c0,
            [[<T as ::carvallo::Scalar>::from_f64(0.0); 1]; 1],
            [[<T as ::carvallo::Scalar>::from_f64(0.0); 1]; 1],
            matrices.k0,
            [[<T as ::carvallo::Scalar>::from_f64(0.0); 1]; 1],
        ])
    }
    fn gravity(&self) -> ::core::option::Option<T> {
        ::core::option::Option::Some(self.g)
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> ::carvallo::Evaluator<T, 1> for Pendulum<T> {
    type Entries = [T; 3];
    #[inline(always)]
    fn from_parameters(
        mut parameter: impl ::core::ops::FnMut(::core::primitive::usize) -> T,
    ) -> Self {
        Self {
            m: parameter(0),
            l: parameter(1),
            c: parameter(2),
            g: parameter(3),
        }
    }
    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        let matrices = self.matrices();
        [matrices.m[0][0], matrices.c0[0][0], matrices.k0[0][0]]
    }
    #[inline(always)]
    fn rows(&self) -> [[[T; 1]; 1]; 6] {
        let matrices = self.matrices();
        [
            matrices.m,
            matrices.c0,
            [[::carvallo::Number::like(self.m, 0.0); 1]; 1],
            [[::carvallo::Number::like(self.m, 0.0); 1]; 1],
            matrices.k0,
            [[::carvallo::Number::like(self.m, 0.0); 1]; 1],
        ]
    }
}
/// The derivatives of the matrices of [`Pendulum`] with respect to its parameters, in SI units: those that are not zero for all parameters.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct PendulumDerivatives<T = ::core::primitive::f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 5],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl PendulumDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [::carvallo::Partial; 5] = &[
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 1, 3),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 0, 0, 2, 4),
    ];
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> PendulumDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(
        &self,
        parameter: ::core::primitive::usize,
    ) -> ::core::option::Option<PendulumMatrices<T>> {
        if parameter >= 4 {
            return ::core::option::Option::None;
        }
        let zero = <T as ::carvallo::Scalar>::from_f64(0.0);
        let mut matrices = PendulumMatrices {
            m: [[zero; 1]; 1],
            c0: [[zero; 1]; 1],
            k0: [[zero; 1]; 1],
        };
        for position in 0..5 {
            let partial = <PendulumDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                ::carvallo::MatrixName::M => &mut matrices.m,
                ::carvallo::MatrixName::C0 => &mut matrices.c0,
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
impl<T: ::carvallo::Number> Pendulum<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 1 addition and 3 multiplications: 4 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(
        &self,
    ) -> (PendulumMatrices<T>, PendulumDerivatives<T>) {
        let t2 = self.l * self.l;
        let t3 = self.m * t2;
        let t5 = self.m * self.l;
        let t6 = t5 + t5;
        (
            {
                #[inline(always)]
                fn matrix<T: ::core::marker::Copy>(
                    entries: &[T; 3],
                    first: ::core::primitive::usize,
                ) -> [[T; 1]; 1] {
                    [[entries[first]]]
                }
                let entries = [t3, self.c, t5];
                PendulumMatrices {
                    m: matrix(&entries, 0),
                    c0: matrix(&entries, 1),
                    k0: matrix(&entries, 2),
                }
            },
            PendulumDerivatives {
                values: [t2, self.l, t6, self.m, ::carvallo::Number::like(self.m, 1.0)],
            },
        )
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Differentiable<1> for Pendulum<T> {
    type Derivatives = [::carvallo::Coefficients<T, 1>; 4];
    fn coefficients_and_derivatives(
        &self,
    ) -> (::carvallo::Coefficients<T, 1>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let mut all = [::carvallo::Coefficients::from_rows(
            [[[<T as ::carvallo::Scalar>::from_f64(0.0); 1]; 1]; 6],
        ); 4];
        for position in 0..5 {
            ::carvallo::Partial::write(
                &<PendulumDerivatives>::PARTIALS[position],
                &derivatives.values,
                &mut all,
            );
        }
        (
            ::carvallo::Coefficients::from_rows([
                matrices.m,
                matrices.c0,
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 1]; 1],
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 1]; 1],
                matrices.k0,
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 1]; 1],
            ]),
            all,
        )
    }
}
