// @generated from generated/models/double_pendulum.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 0cf50b8e8c8bfd80

/// An inverted double pendulum: two links, one standing on the other, which lean to the right about axes along x.
///
/// Axes: origin at the lower hinge, x forward, y to the right, z down, so that what is above it has z < 0. The second
/// angle is that between the links.
///
/// Source: Mechanism: Kibble & Berkshire (2004), Classical Mechanics, section 11.3, turned upside down
///
/// Derived from a mechanism: body `lower`, body `upper`.
///
/// The fields are the parameters. The coordinates are `theta1` (lower link) in rad, `theta2` (upper link) in rad.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct DoublePendulum<T = ::core::primitive::f64> {
    /// Length of the lower link, from hinge to hinge.
    ///
    /// `l1` in m: > 0.
    pub l1: T,
    /// Centre of mass of the lower link, above its hinge.
    ///
    /// `a1` in m: any finite value.
    pub a1: T,
    /// Mass of the lower link.
    ///
    /// `m1` in kg: >= 0.
    pub m1: T,
    /// Moment of inertia of the lower link about its centre of mass.
    ///
    /// `I1` in kg*m^2: >= 0.
    pub I1: T,
    /// Centre of mass of the upper link, above its hinge.
    ///
    /// `a2` in m: any finite value.
    pub a2: T,
    /// Mass of the upper link.
    ///
    /// `m2` in kg: >= 0.
    pub m2: T,
    /// Moment of inertia of the upper link about its centre of mass.
    ///
    /// `I2` in kg*m^2: >= 0.
    pub I2: T,
    /// Gravitational field strength.
    ///
    /// `g` in N/kg: >= 0.
    pub g: T,
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl DoublePendulum<::core::primitive::f64> {
    /// The parameter set `rods`.
    ///
    /// Source: Two slender rods of 1 m and 1 kg
    pub const RODS: Self = Self {
        l1: 1.0,
        a1: 0.5,
        m1: 1.0,
        I1: 0.08333333333333333,
        a2: 0.5,
        m2: 1.0,
        I2: 0.08333333333333333,
        g: 9.81,
    };
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> DoublePendulum<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 8]) -> Self {
        Self {
            l1: values[0],
            a1: values[1],
            m1: values[2],
            I1: values[3],
            a2: values[4],
            m2: values[5],
            I2: values[6],
            g: values[7],
        }
    }
    /// The parameters as an array in declared order.
    #[must_use]
    pub const fn to_array(&self) -> [T; 8] {
        [self.l1, self.a1, self.m1, self.I1, self.a2, self.m2, self.I2, self.g]
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> DoublePendulum<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: ::carvallo::Scalar>(&self) -> DoublePendulum<U> {
        DoublePendulum {
            l1: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.l1)),
            a1: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.a1)),
            m1: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.m1)),
            I1: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.I1)),
            a2: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.a2)),
            m2: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.m2)),
            I2: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.I2)),
            g: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.g)),
        }
    }
}
/// The coefficient matrices of [`DoublePendulum`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct DoublePendulumMatrices<T = ::core::primitive::f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: [[T; 2]; 2],
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: [[T; 2]; 2],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> DoublePendulum<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 8 additions, 7 multiplications and 2 negations: 17 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> DoublePendulumMatrices<T> {
        let t4 = self.a2 * self.m2;
        let Jxx_theta2 = self.I2 + (self.a2 * t4);
        let t9 = t4 + (self.m2 * self.l1);
        let t14 = self.a1 * self.m1;
        let Jxx_theta1 = ((self.I1 + Jxx_theta2) + (self.l1 * (t4 + t9)))
            + (self.a1 * t14);
        let M_theta1_theta2 = Jxx_theta2 + (t4 * self.l1);
        let t22 = -(t9 + t14);
        let t23 = -t4;
        {
            #[inline(always)]
            fn matrix<T: ::core::marker::Copy>(
                entries: &[T; 8],
                first: ::core::primitive::usize,
            ) -> [[T; 2]; 2] {
                [
                    [entries[first], entries[first + 1]],
                    [entries[first + 2], entries[first + 3]],
                ]
            }
            let entries = [
                Jxx_theta1,
                M_theta1_theta2,
                M_theta1_theta2,
                Jxx_theta2,
                t22,
                t23,
                t23,
                t23,
            ];
            DoublePendulumMatrices {
                m: matrix(&entries, 0),
                k0: matrix(&entries, 4),
            }
        }
    }
}
/// Rates and forces of [`DoublePendulum`] that follow from its coordinates q = (`theta1`, `theta2`), to first order and in SI units.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct DoublePendulumKinematics<T = ::core::primitive::f64> {
    /// The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of `T1` (torque at the lower hinge) in N*m, `T2` (torque between the links) in N*m.
    pub forces: [[T; 2]; 2],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> DoublePendulum<T> {
    /// Rates and forces that follow from the coordinates:
    /// no operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> DoublePendulumKinematics<T> {
        DoublePendulumKinematics {
            forces: [
                [
                    ::carvallo::Number::like(self.l1, 1.0),
                    ::carvallo::Number::like(self.l1, 0.0),
                ],
                [
                    ::carvallo::Number::like(self.l1, 0.0),
                    ::carvallo::Number::like(self.l1, 1.0),
                ],
            ],
        }
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Model<2> for DoublePendulum<T> {
    type Scalar = T;
    type Array<U: ::core::marker::Copy> = [U; 8];
    type Over<U: ::carvallo::Number> = DoublePendulum<U>;
    const INFO: &'static ::carvallo::ModelInfo = &::carvallo::ModelInfo {
        name: "DoublePendulum",
        docs: "An inverted double pendulum: two links, one standing on the other, which lean to the right about axes along x.\n\nAxes: origin at the lower hinge, x forward, y to the right, z down, so that what is above it has z < 0. The second\nangle is that between the links.",
        source: "Mechanism: Kibble & Berkshire (2004), Classical Mechanics, section 11.3, turned upside down",
        parameters: &[
            ::carvallo::ParameterInfo {
                name: "l1",
                symbol: "l1",
                docs: "Length of the lower link, from hinge to hinge.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "a1",
                symbol: "a1",
                docs: "Centre of mass of the lower link, above its hinge.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "m1",
                symbol: "m1",
                docs: "Mass of the lower link.",
                unit: "kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "I1",
                symbol: "I1",
                docs: "Moment of inertia of the lower link about its centre of mass.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "a2",
                symbol: "a2",
                docs: "Centre of mass of the upper link, above its hinge.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "m2",
                symbol: "m2",
                docs: "Mass of the upper link.",
                unit: "kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "I2",
                symbol: "I2",
                docs: "Moment of inertia of the upper link about its centre of mass.",
                unit: "kg*m^2",
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
                name: "theta1",
                label: "lower link",
                docs: "Lean of the lower link, to the right.",
                unit: "rad",
            },
            ::carvallo::CoordinateInfo {
                name: "theta2",
                label: "upper link",
                docs: "Lean of the upper link relative to the lower one, to the right.",
                unit: "rad",
            },
        ],
        matrices: &[::carvallo::MatrixName::M, ::carvallo::MatrixName::K0],
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
                places: &[(::carvallo::MatrixName::K0, 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[
                    (::carvallo::MatrixName::K0, 0, 1),
                    (::carvallo::MatrixName::K0, 1, 0),
                    (::carvallo::MatrixName::K0, 1, 1),
                ],
            },
        ],
        sets: &[
            ::carvallo::SetInfo {
                name: "rods",
                docs: "",
                source: "Two slender rods of 1 m and 1 kg",
                values: &[
                    1.0,
                    0.5,
                    1.0,
                    0.08333333333333333,
                    0.5,
                    1.0,
                    0.08333333333333333,
                    9.81,
                ],
            },
        ],
        gravity: ::core::option::Option::Some(7),
    };
    fn from_slice(
        values: &[T],
    ) -> ::core::result::Result<Self, ::carvallo::LengthError> {
        if values.len() != 8 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "DoublePendulum",
                expected: 8,
                found: values.len(),
            });
        }
        ::core::result::Result::Ok(Self {
            l1: values[0],
            a1: values[1],
            m1: values[2],
            I1: values[3],
            a2: values[4],
            m2: values[5],
            I2: values[6],
            g: values[7],
        })
    }
    fn write_to(
        &self,
        values: &mut [T],
    ) -> ::core::result::Result<(), ::carvallo::LengthError> {
        if values.len() != 8 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "DoublePendulum",
                expected: 8,
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
                ::carvallo::Scalar::to_f64(self.l1),
                ::carvallo::Scalar::to_f64(self.a1),
                ::carvallo::Scalar::to_f64(self.m1),
                ::carvallo::Scalar::to_f64(self.I1),
                ::carvallo::Scalar::to_f64(self.a2),
                ::carvallo::Scalar::to_f64(self.m2),
                ::carvallo::Scalar::to_f64(self.I2),
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
            [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
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
impl<T: ::carvallo::Number> ::carvallo::Evaluator<T, 2> for DoublePendulum<T> {
    type Entries = [T; 5];
    #[inline(always)]
    fn from_parameters(
        mut parameter: impl ::core::ops::FnMut(::core::primitive::usize) -> T,
    ) -> Self {
        Self {
            l1: parameter(0),
            a1: parameter(1),
            m1: parameter(2),
            I1: parameter(3),
            a2: parameter(4),
            m2: parameter(5),
            I2: parameter(6),
            g: parameter(7),
        }
    }
    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        let matrices = self.matrices();
        [
            matrices.m[0][0],
            matrices.m[0][1],
            matrices.m[1][1],
            matrices.k0[0][0],
            matrices.k0[0][1],
        ]
    }
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 6] {
        let matrices = self.matrices();
        [
            matrices.m,
            [[::carvallo::Number::like(self.l1, 0.0); 2]; 2],
            [[::carvallo::Number::like(self.l1, 0.0); 2]; 2],
            [[::carvallo::Number::like(self.l1, 0.0); 2]; 2],
            matrices.k0,
            [[::carvallo::Number::like(self.l1, 0.0); 2]; 2],
        ]
    }
}
/// The derivatives of the matrices of [`DoublePendulum`] with respect to its parameters, in SI units: those that are not zero for all parameters.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct DoublePendulumDerivatives<T = ::core::primitive::f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 15],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl DoublePendulumDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [::carvallo::Partial; 29] = &[
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 0, 2).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 1, 3),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 1, 4).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 2, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 2, 6).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 3, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 4, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 4, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 4, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 4, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 4, 2).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 4, 2).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 4, 2).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 4, 2).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 5, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 5, 11),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 5, 11),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 5, 12),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 5, 13).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 5, 14).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 5, 14).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 5, 14).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 6, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 6, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 6, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 6, 7),
    ];
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> DoublePendulumDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(
        &self,
        parameter: ::core::primitive::usize,
    ) -> ::core::option::Option<DoublePendulumMatrices<T>> {
        if parameter >= 8 {
            return ::core::option::Option::None;
        }
        let zero = <T as ::carvallo::Scalar>::from_f64(0.0);
        let mut matrices = DoublePendulumMatrices {
            m: [[zero; 2]; 2],
            k0: [[zero; 2]; 2],
        };
        for position in 0..29 {
            let partial = <DoublePendulumDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                ::carvallo::MatrixName::M => &mut matrices.m,
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
impl<T: ::carvallo::Number> DoublePendulum<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 11 additions, 11 multiplications and 2 negations: 24 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(
        &self,
    ) -> (DoublePendulumMatrices<T>, DoublePendulumDerivatives<T>) {
        let t4 = self.a2 * self.m2;
        let Jxx_theta2 = self.I2 + (self.a2 * t4);
        let t8 = self.a2 + self.l1;
        let t9 = self.m2 * t8;
        let t10 = t4 + t9;
        let t14 = self.a1 * self.m1;
        let Jxx_theta1 = ((self.I1 + Jxx_theta2) + (self.l1 * t10)) + (self.a1 * t14);
        let M_theta1_theta2 = Jxx_theta2 + (t4 * self.l1);
        let t22 = t9 + t9;
        let t23 = t14 + t14;
        let t24 = self.a1 * self.a1;
        let t26 = t4 + t4;
        let t27 = t8 * t8;
        let t28 = self.a2 * t8;
        let t29 = self.a2 * self.a2;
        let t30 = -(t9 + t14);
        let t31 = -t4;
        (
            {
                #[inline(always)]
                fn matrix<T: ::core::marker::Copy>(
                    entries: &[T; 8],
                    first: ::core::primitive::usize,
                ) -> [[T; 2]; 2] {
                    [
                        [entries[first], entries[first + 1]],
                        [entries[first + 2], entries[first + 3]],
                    ]
                }
                let entries = [
                    Jxx_theta1,
                    M_theta1_theta2,
                    M_theta1_theta2,
                    Jxx_theta2,
                    t30,
                    t31,
                    t31,
                    t31,
                ];
                DoublePendulumMatrices {
                    m: matrix(&entries, 0),
                    k0: matrix(&entries, 4),
                }
            },
            DoublePendulumDerivatives {
                values: [
                    t22,
                    t4,
                    self.m2,
                    t23,
                    self.m1,
                    t24,
                    self.a1,
                    ::carvallo::Number::like(self.l1, 1.0),
                    t10,
                    t26,
                    t27,
                    t28,
                    t29,
                    t8,
                    self.a2,
                ],
            },
        )
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Differentiable<2> for DoublePendulum<T> {
    type Derivatives = [::carvallo::Coefficients<T, 2>; 8];
    fn coefficients_and_derivatives(
        &self,
    ) -> (::carvallo::Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let mut all = [::carvallo::Coefficients::from_rows(
            [[[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2]; 6],
        ); 8];
        for position in 0..29 {
            ::carvallo::Partial::write(
                &<DoublePendulumDerivatives>::PARTIALS[position],
                &derivatives.values,
                &mut all,
            );
        }
        (
            ::carvallo::Coefficients::from_rows([
                matrices.m,
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
                matrices.k0,
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
            ]),
            all,
        )
    }
}
