// @generated from generated/models/skateboard.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 0f4f8539b65fdea9

/// A skateboard with a rider who stands still on it: one degree of freedom, the tilt of the board.
///
/// Each truck turns about its king pin, which passes through the middle of its axle, with a wheel at either end. All
/// four wheels stay on the ground and do not slip, so that tilting steers both axles. Trucks and wheels have no mass;
/// board and rider are one rigid body. Axes: origin on the ground below the rear axle, x forward, y to the right, z
/// down.
///
/// Source: Mechanism: Hubbard (1979), J. Appl. Mech. 46, 931-936; Kremnev & Kuleshov (2010), DCDS-S 3, 85-103
///
/// Derived from a mechanism: body `B` (board and rider), body `TF` (front truck), body `TR` (rear truck), wheel `FL` (front left), wheel `FR` (front right), wheel `RL` (rear left), wheel `RR` (rear right).
///
/// The fields are the parameters. The coordinates are `gamma` (tilt) in rad.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Skateboard<T = ::core::primitive::f64> {
    /// Wheel base, from axle to axle.
    ///
    /// `L` in m: > 0.
    pub L: T,
    /// Half of the track, from the middle of an axle to a wheel.
    ///
    /// `b` in m: > 0.
    pub b: T,
    /// Radius of the wheels.
    ///
    /// `r` in m: > 0.
    pub r: T,
    /// Angle of the front king pin above the horizontal, rising forward.
    ///
    /// `lamF`, λF, in rad: > 0 and < 1.5707963267948966.
    pub lamF: T,
    /// Angle of the rear king pin above the horizontal, rising backward.
    ///
    /// `lamR`, λR, in rad: > 0 and < 1.5707963267948966.
    pub lamR: T,
    /// Stiffness of the front truck about its king pin.
    ///
    /// `kF` in N*m: >= 0.
    pub kF: T,
    /// Stiffness of the rear truck about its king pin.
    ///
    /// `kR` in N*m: >= 0.
    pub kR: T,
    /// Mass of board and rider.
    ///
    /// `m` in kg: > 0.
    pub m: T,
    /// Centre of mass, forward of the rear axle.
    ///
    /// `x` in m: any finite value.
    pub x: T,
    /// Centre of mass, above the axles.
    ///
    /// `h` in m: any finite value.
    pub h: T,
    /// Moment of inertia of board and rider about their centre of mass, in roll.
    ///
    /// `Ixx` in kg*m^2: >= 0.
    pub Ixx: T,
    /// Moment of inertia of board and rider about their centre of mass, in pitch.
    ///
    /// `Iyy` in kg*m^2: >= 0. No matrix depends on it.
    pub Iyy: T,
    /// Moment of inertia of board and rider about their centre of mass, in yaw.
    ///
    /// `Izz` in kg*m^2: >= 0. No matrix depends on it.
    pub Izz: T,
    /// Product of inertia of board and rider about their centre of mass.
    ///
    /// `Ixz` in kg*m^2: any finite value.
    pub Ixz: T,
    /// Gravitational field strength.
    ///
    /// `g` in N/kg: >= 0.
    pub g: T,
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl Skateboard<::core::primitive::f64> {
    /// The parameter set `example`.
    ///
    /// Source: An adult on a board; the figures are an example
    pub const EXAMPLE: Self = Self {
        L: 0.8,
        b: 0.1,
        r: 0.03,
        lamF: 0.7853981633974483,
        lamR: 0.7853981633974483,
        kF: 50.0,
        kR: 50.0,
        m: 75.0,
        x: 0.42,
        h: 0.9,
        Ixx: 9.0,
        Iyy: 9.0,
        Izz: 1.0,
        Ixz: 0.0,
        g: 9.81,
    };
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> Skateboard<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 15]) -> Self {
        Self {
            L: values[0],
            b: values[1],
            r: values[2],
            lamF: values[3],
            lamR: values[4],
            kF: values[5],
            kR: values[6],
            m: values[7],
            x: values[8],
            h: values[9],
            Ixx: values[10],
            Iyy: values[11],
            Izz: values[12],
            Ixz: values[13],
            g: values[14],
        }
    }
    /// The parameters as an array in declared order.
    #[must_use]
    pub const fn to_array(&self) -> [T; 15] {
        [
            self.L,
            self.b,
            self.r,
            self.lamF,
            self.lamR,
            self.kF,
            self.kR,
            self.m,
            self.x,
            self.h,
            self.Ixx,
            self.Iyy,
            self.Izz,
            self.Ixz,
            self.g,
        ]
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> Skateboard<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: ::carvallo::Scalar>(&self) -> Skateboard<U> {
        Skateboard {
            L: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.L)),
            b: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.b)),
            r: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.r)),
            lamF: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.lamF)),
            lamR: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.lamR)),
            kF: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.kF)),
            kR: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.kR)),
            m: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.m)),
            x: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.x)),
            h: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.h)),
            Ixx: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.Ixx)),
            Iyy: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.Iyy)),
            Izz: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.Izz)),
            Ixz: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.Ixz)),
            g: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.g)),
        }
    }
}
/// The coefficient matrices of [`Skateboard`], each 1 x 1 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SkateboardMatrices<T = ::core::primitive::f64> {
    /// Mass matrix M, the coefficient of q''.
    pub m: [[T; 1]; 1],
    /// Damping C1, a coefficient of v q'.
    pub c1: [[T; 1]; 1],
    /// Stiffness Kc, a coefficient of q.
    pub kc: [[T; 1]; 1],
    /// Stiffness K0, a coefficient of g q.
    pub k0: [[T; 1]; 1],
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: [[T; 1]; 1],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> Skateboard<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 5 additions, 14 multiplications, 3 divisions, 1 negation and 4 trigonometric functions: 27 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> SkateboardMatrices<T> {
        let P_gamma_lateral = self.h * self.m;
        let t5 = self.Ixx + (self.h * P_gamma_lateral);
        let (lateral_per_v_deltaR, t7) = ::carvallo::Number::sin_cos(self.lamR);
        let t8 = ::carvallo::Number::like(self.L, 1.0) / t7;
        let t10 = t8 * lateral_per_v_deltaR;
        let P_gamma_yaw = self.Ixz + (P_gamma_lateral * self.x);
        let (t19, t17) = ::carvallo::Number::sin_cos(self.lamF);
        let t18 = ::carvallo::Number::like(self.L, 1.0) / t17;
        let t21 = ::carvallo::Number::like(self.L, 1.0) / self.L;
        let t25 = ((t18 * t19) * t21) + (t10 * t21);
        let t27 = (P_gamma_yaw * t25) - (P_gamma_lateral * t10);
        let t34 = ((t18 * t18) * self.kF) + ((t8 * t8) * self.kR);
        let t35 = P_gamma_lateral * t25;
        let t36 = -P_gamma_lateral;
        {
            #[inline(always)]
            fn matrix<T: ::core::marker::Copy>(
                entries: &[T; 5],
                first: ::core::primitive::usize,
            ) -> [[T; 1]; 1] {
                [[entries[first]]]
            }
            let entries = [t5, t27, t34, t36, t35];
            SkateboardMatrices {
                m: matrix(&entries, 0),
                c1: matrix(&entries, 1),
                kc: matrix(&entries, 2),
                k0: matrix(&entries, 3),
                k2: matrix(&entries, 4),
            }
        }
    }
}
/// Rates and forces of [`Skateboard`] that follow from its coordinates q = (`gamma`), to first order and in SI units.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SkateboardKinematics<T = ::core::primitive::f64> {
    /// Lateral velocity, to the right, in m/s: of the point of `B` that is at the origin.
    pub lateral: ::carvallo::Rate<T, 1>,
    /// Yaw rate, to the right, in rad/s: of `B`.
    pub yaw: ::carvallo::Rate<T, 1>,
    /// Rate of `deltaF`, in rad/s.
    pub deltaF: ::carvallo::Rate<T, 1>,
    /// Rate of `deltaR`, in rad/s.
    pub deltaR: ::carvallo::Rate<T, 1>,
    /// Spin of the wheel `FL`, front left: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_FL: ::carvallo::Rate<T, 1>,
    /// Spin of the wheel `FR`, front right: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_FR: ::carvallo::Rate<T, 1>,
    /// Spin of the wheel `RL`, rear left: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_RL: ::carvallo::Rate<T, 1>,
    /// Spin of the wheel `RR`, rear right: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_RR: ::carvallo::Rate<T, 1>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of `T` (tilt torque) in N*m.
    pub forces: [[T; 1]; 1],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> Skateboard<T> {
    /// Rates and forces that follow from the coordinates:
    /// 2 additions, 9 multiplications, 4 divisions, 8 negations and 4 trigonometric functions: 27 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> SkateboardKinematics<T> {
        let (lateral_per_v_deltaR, t3) = ::carvallo::Number::sin_cos(self.lamR);
        let t4 = ::carvallo::Number::like(self.L, 1.0) / t3;
        let t6 = t4 * lateral_per_v_deltaR;
        let pitch_by_vertical = ::carvallo::Number::like(self.L, 1.0) / self.L;
        let (t13, t11) = ::carvallo::Number::sin_cos(self.lamF);
        let t12 = ::carvallo::Number::like(self.L, 1.0) / t11;
        let t14 = t12 * t13;
        let t15 = pitch_by_vertical * t14;
        let t16 = pitch_by_vertical * t6;
        let t17 = t15 + t16;
        let t18 = ::carvallo::Number::like(self.L, 1.0) / self.r;
        let t20 = t18 * self.b;
        let t21 = t20 * t14;
        let t24 = (t15 * t20) + (t16 * t20);
        let spin_RL_by_gamma = t6 * t20;
        let t26 = -self.r;
        let t27 = -t6;
        let t28 = -t12;
        let t29 = -t4;
        let t30 = -t18;
        let t31 = -t21;
        let t32 = -t24;
        let t33 = -spin_RL_by_gamma;
        SkateboardKinematics {
            lateral: ::carvallo::Rate {
                speed: ::carvallo::Number::like(self.L, 0.0),
                rates: [t26],
                coordinates: [t27],
                heading: ::carvallo::Number::like(self.L, 1.0),
            },
            yaw: ::carvallo::Rate {
                speed: ::carvallo::Number::like(self.L, 0.0),
                rates: [::carvallo::Number::like(self.L, 0.0)],
                coordinates: [t17],
                heading: ::carvallo::Number::like(self.L, 0.0),
            },
            deltaF: ::carvallo::Rate {
                speed: ::carvallo::Number::like(self.L, 0.0),
                rates: [t28],
                coordinates: [::carvallo::Number::like(self.L, 0.0)],
                heading: ::carvallo::Number::like(self.L, 0.0),
            },
            deltaR: ::carvallo::Rate {
                speed: ::carvallo::Number::like(self.L, 0.0),
                rates: [t29],
                coordinates: [::carvallo::Number::like(self.L, 0.0)],
                heading: ::carvallo::Number::like(self.L, 0.0),
            },
            wheel_FL: ::carvallo::Rate {
                speed: t30,
                rates: [t31],
                coordinates: [t32],
                heading: ::carvallo::Number::like(self.L, 0.0),
            },
            wheel_FR: ::carvallo::Rate {
                speed: t30,
                rates: [t21],
                coordinates: [t24],
                heading: ::carvallo::Number::like(self.L, 0.0),
            },
            wheel_RL: ::carvallo::Rate {
                speed: t30,
                rates: [spin_RL_by_gamma],
                coordinates: [t32],
                heading: ::carvallo::Number::like(self.L, 0.0),
            },
            wheel_RR: ::carvallo::Rate {
                speed: t30,
                rates: [t33],
                coordinates: [t24],
                heading: ::carvallo::Number::like(self.L, 0.0),
            },
            forces: [[::carvallo::Number::like(self.L, 1.0)]],
        }
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Model<1> for Skateboard<T> {
    type Scalar = T;
    type Array<U: ::core::marker::Copy> = [U; 15];
    type Over<U: ::carvallo::Number> = Skateboard<U>;
    const INFO: &'static ::carvallo::ModelInfo = &::carvallo::ModelInfo {
        name: "Skateboard",
        docs: "A skateboard with a rider who stands still on it: one degree of freedom, the tilt of the board.\n\nEach truck turns about its king pin, which passes through the middle of its axle, with a wheel at either end. All\nfour wheels stay on the ground and do not slip, so that tilting steers both axles. Trucks and wheels have no mass;\nboard and rider are one rigid body. Axes: origin on the ground below the rear axle, x forward, y to the right, z\ndown.",
        source: "Mechanism: Hubbard (1979), J. Appl. Mech. 46, 931-936; Kremnev & Kuleshov (2010), DCDS-S 3, 85-103",
        parameters: &[
            ::carvallo::ParameterInfo {
                name: "L",
                symbol: "L",
                docs: "Wheel base, from axle to axle.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "b",
                symbol: "b",
                docs: "Half of the track, from the middle of an axle to a wheel.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "r",
                symbol: "r",
                docs: "Radius of the wheels.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "lamF",
                symbol: "λF",
                docs: "Angle of the front king pin above the horizontal, rising forward.",
                unit: "rad",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Open(1.5707963267948966),
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "lamR",
                symbol: "λR",
                docs: "Angle of the rear king pin above the horizontal, rising backward.",
                unit: "rad",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Open(1.5707963267948966),
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "kF",
                symbol: "kF",
                docs: "Stiffness of the front truck about its king pin.",
                unit: "N*m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "kR",
                symbol: "kR",
                docs: "Stiffness of the rear truck about its king pin.",
                unit: "N*m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "m",
                symbol: "m",
                docs: "Mass of board and rider.",
                unit: "kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "x",
                symbol: "x",
                docs: "Centre of mass, forward of the rear axle.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "h",
                symbol: "h",
                docs: "Centre of mass, above the axles.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "Ixx",
                symbol: "Ixx",
                docs: "Moment of inertia of board and rider about their centre of mass, in roll.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "Iyy",
                symbol: "Iyy",
                docs: "Moment of inertia of board and rider about their centre of mass, in pitch.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: false,
            },
            ::carvallo::ParameterInfo {
                name: "Izz",
                symbol: "Izz",
                docs: "Moment of inertia of board and rider about their centre of mass, in yaw.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: false,
            },
            ::carvallo::ParameterInfo {
                name: "Ixz",
                symbol: "Ixz",
                docs: "Product of inertia of board and rider about their centre of mass.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
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
                name: "gamma",
                label: "tilt",
                docs: "Tilt of the board, to the right.",
                unit: "rad",
            },
        ],
        matrices: &[
            ::carvallo::MatrixName::M,
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
                places: &[(::carvallo::MatrixName::C1, 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::Kc, 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::K0, 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[(::carvallo::MatrixName::K2, 0, 0)],
            },
        ],
        sets: &[
            ::carvallo::SetInfo {
                name: "example",
                docs: "",
                source: "An adult on a board; the figures are an example",
                values: &[
                    0.8,
                    0.1,
                    0.03,
                    0.7853981633974483,
                    0.7853981633974483,
                    50.0,
                    50.0,
                    75.0,
                    0.42,
                    0.9,
                    9.0,
                    9.0,
                    1.0,
                    0.0,
                    9.81,
                ],
            },
        ],
        gravity: ::core::option::Option::Some(14),
    };
    fn from_slice(
        values: &[T],
    ) -> ::core::result::Result<Self, ::carvallo::LengthError> {
        if values.len() != 15 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "Skateboard",
                expected: 15,
                found: values.len(),
            });
        }
        ::core::result::Result::Ok(Self {
            L: values[0],
            b: values[1],
            r: values[2],
            lamF: values[3],
            lamR: values[4],
            kF: values[5],
            kR: values[6],
            m: values[7],
            x: values[8],
            h: values[9],
            Ixx: values[10],
            Iyy: values[11],
            Izz: values[12],
            Ixz: values[13],
            g: values[14],
        })
    }
    fn write_to(
        &self,
        values: &mut [T],
    ) -> ::core::result::Result<(), ::carvallo::LengthError> {
        if values.len() != 15 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "Skateboard",
                expected: 15,
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
                ::carvallo::Scalar::to_f64(self.L),
                ::carvallo::Scalar::to_f64(self.b),
                ::carvallo::Scalar::to_f64(self.r),
                ::carvallo::Scalar::to_f64(self.lamF),
                ::carvallo::Scalar::to_f64(self.lamR),
                ::carvallo::Scalar::to_f64(self.kF),
                ::carvallo::Scalar::to_f64(self.kR),
                ::carvallo::Scalar::to_f64(self.m),
                ::carvallo::Scalar::to_f64(self.x),
                ::carvallo::Scalar::to_f64(self.h),
                ::carvallo::Scalar::to_f64(self.Ixx),
                ::carvallo::Scalar::to_f64(self.Iyy),
                ::carvallo::Scalar::to_f64(self.Izz),
                ::carvallo::Scalar::to_f64(self.Ixz),
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
            [[<T as ::carvallo::Scalar>::from_f64(0.0); 1]; 1],
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
impl<T: ::carvallo::Number> ::carvallo::Evaluator<T, 1> for Skateboard<T> {
    type Entries = [T; 5];
    #[inline(always)]
    fn from_parameters(
        mut parameter: impl ::core::ops::FnMut(::core::primitive::usize) -> T,
    ) -> Self {
        Self {
            L: parameter(0),
            b: parameter(1),
            r: parameter(2),
            lamF: parameter(3),
            lamR: parameter(4),
            kF: parameter(5),
            kR: parameter(6),
            m: parameter(7),
            x: parameter(8),
            h: parameter(9),
            Ixx: parameter(10),
            Iyy: parameter(11),
            Izz: parameter(12),
            Ixz: parameter(13),
            g: parameter(14),
        }
    }
    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        let matrices = self.matrices();
        [
            matrices.m[0][0],
            matrices.c1[0][0],
            matrices.kc[0][0],
            matrices.k0[0][0],
            matrices.k2[0][0],
        ]
    }
    #[inline(always)]
    fn rows(&self) -> [[[T; 1]; 1]; 6] {
        let matrices = self.matrices();
        [
            matrices.m,
            [[::carvallo::Number::like(self.L, 0.0); 1]; 1],
            matrices.c1,
            matrices.kc,
            matrices.k0,
            matrices.k2,
        ]
    }
}
/// The derivatives of the matrices of [`Skateboard`] with respect to its parameters, in SI units: those that are not zero for all parameters.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SkateboardDerivatives<T = ::core::primitive::f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 21],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl SkateboardDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [::carvallo::Partial; 21] = &[
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 0, 0, 0).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 0, 0, 1).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 0, 3, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 0, 0, 3, 3),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 0, 3, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 0, 4, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 0, 0, 4, 6),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 0, 4, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 0, 0, 5, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 0, 0, 6, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 7, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 0, 7, 11),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 7, 12).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 0, 7, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 0, 8, 14),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 9, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 0, 9, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 9, 17).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 0, 9, 18),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 10, 19),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 0, 13, 20),
    ];
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> SkateboardDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(
        &self,
        parameter: ::core::primitive::usize,
    ) -> ::core::option::Option<SkateboardMatrices<T>> {
        if parameter >= 15 {
            return ::core::option::Option::None;
        }
        let zero = <T as ::carvallo::Scalar>::from_f64(0.0);
        let mut matrices = SkateboardMatrices {
            m: [[zero; 1]; 1],
            c1: [[zero; 1]; 1],
            kc: [[zero; 1]; 1],
            k0: [[zero; 1]; 1],
            k2: [[zero; 1]; 1],
        };
        for position in 0..21 {
            let partial = <SkateboardDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                ::carvallo::MatrixName::M => &mut matrices.m,
                ::carvallo::MatrixName::C1 => &mut matrices.c1,
                ::carvallo::MatrixName::Kc => &mut matrices.kc,
                ::carvallo::MatrixName::K0 => &mut matrices.k0,
                ::carvallo::MatrixName::K2 => &mut matrices.k2,
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
impl<T: ::carvallo::Number> Skateboard<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 12 additions, 36 multiplications, 3 divisions, 1 negation and 4 trigonometric functions: 56 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(
        &self,
    ) -> (SkateboardMatrices<T>, SkateboardDerivatives<T>) {
        let P_gamma_lateral = self.h * self.m;
        let t5 = self.Ixx + (self.h * P_gamma_lateral);
        let (lateral_per_v_deltaR, t7) = ::carvallo::Number::sin_cos(self.lamR);
        let t8 = ::carvallo::Number::like(self.L, 1.0) / t7;
        let t10 = t8 * lateral_per_v_deltaR;
        let P_gamma_yaw = self.Ixz + (P_gamma_lateral * self.x);
        let t17 = ::carvallo::Number::like(self.L, 1.0) / self.L;
        let (t21, t19) = ::carvallo::Number::sin_cos(self.lamF);
        let t20 = ::carvallo::Number::like(self.L, 1.0) / t19;
        let t22 = t20 * t21;
        let t24 = t17 * (t10 + t22);
        let t26 = (P_gamma_yaw * t24) - (P_gamma_lateral * t10);
        let t28 = t20 * t20;
        let t29 = self.kF * t28;
        let t31 = t8 * t8;
        let t33 = t29 + (self.kR * t31);
        let t34 = P_gamma_lateral * t24;
        let t35 = t17 * t24;
        let t36 = P_gamma_yaw * t35;
        let t37 = P_gamma_lateral * t35;
        let t41 = (t17 * t20) * (t19 + (t21 * t22));
        let t42 = P_gamma_yaw * t41;
        let t43 = t22 * t29;
        let t44 = t43 + t43;
        let t45 = P_gamma_lateral * t41;
        let t47 = lateral_per_v_deltaR * t31;
        let t49 = ::carvallo::Number::like(self.L, 1.0) + (lateral_per_v_deltaR * t47);
        let t51 = t17 * t49;
        let t53 = (P_gamma_yaw * t51) - (P_gamma_lateral * t49);
        let t55 = (t8 * self.kR) * t47;
        let t56 = t55 + t55;
        let t57 = P_gamma_lateral * t51;
        let t58 = self.h * self.h;
        let C111_P_gamma_lateral = (self.x * t24) - t10;
        let t61 = self.h * C111_P_gamma_lateral;
        let t62 = self.h * t24;
        let t63 = P_gamma_lateral + P_gamma_lateral;
        let t64 = self.m * C111_P_gamma_lateral;
        let t65 = self.m * t24;
        let t66 = -P_gamma_lateral;
        (
            {
                #[inline(always)]
                fn matrix<T: ::core::marker::Copy>(
                    entries: &[T; 5],
                    first: ::core::primitive::usize,
                ) -> [[T; 1]; 1] {
                    [[entries[first]]]
                }
                let entries = [t5, t26, t33, t66, t34];
                SkateboardMatrices {
                    m: matrix(&entries, 0),
                    c1: matrix(&entries, 1),
                    kc: matrix(&entries, 2),
                    k0: matrix(&entries, 3),
                    k2: matrix(&entries, 4),
                }
            },
            SkateboardDerivatives {
                values: [
                    t36,
                    t37,
                    t42,
                    t44,
                    t45,
                    t53,
                    t56,
                    t57,
                    t28,
                    t31,
                    t58,
                    t61,
                    self.h,
                    t62,
                    t34,
                    t63,
                    t64,
                    self.m,
                    t65,
                    ::carvallo::Number::like(self.L, 1.0),
                    t24,
                ],
            },
        )
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Differentiable<1> for Skateboard<T> {
    type Derivatives = [::carvallo::Coefficients<T, 1>; 15];
    fn coefficients_and_derivatives(
        &self,
    ) -> (::carvallo::Coefficients<T, 1>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let mut all = [::carvallo::Coefficients::from_rows(
            [[[<T as ::carvallo::Scalar>::from_f64(0.0); 1]; 1]; 6],
        ); 15];
        for position in 0..21 {
            ::carvallo::Partial::write(
                &<SkateboardDerivatives>::PARTIALS[position],
                &derivatives.values,
                &mut all,
            );
        }
        (
            ::carvallo::Coefficients::from_rows([
                matrices.m,
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 1]; 1],
                matrices.c1,
                matrices.kc,
                matrices.k0,
                matrices.k2,
            ]),
            all,
        )
    }
}
