// @generated from generated/models/rear_steered.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: d2b8e67467ec0f83

/// A bicycle that is steered at the rear: a Whipple bicycle run backwards, with its geometry mirrored.
///
/// Four rigid bodies (front wheel F, main frame with a rigid rider B, steered frame H, steered rear wheel R),
/// laterally symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the front
/// contact point, x forward, y to the right, z down. Lengths along x are counted backward from the front contact, so
/// that the parameters of a bicycle are those of the same bicycle run backwards.
///
/// Source: Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3
///
/// Derived from a mechanism: body `B` (main frame and rider), body `H` (steered frame), wheel `F` (front wheel), wheel `R` (rear wheel).
///
/// The fields are the parameters. The coordinates are `phi` (lean) in rad, `delta` (steer) in rad.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RearSteered<T = ::core::primitive::f64> {
    /// Wheel base.
    ///
    /// `w` in m: > 0.
    pub w: T,
    /// Distance by which the steer axis meets the ground behind the contact of the steered wheel.
    ///
    /// `c` in m: any finite value.
    pub c: T,
    /// Steer axis tilt: from the ground upward the axis leans forward by this angle.
    ///
    /// `lam`, λ, in rad: > -1.5707963267948966 and < 1.5707963267948966.
    pub lam: T,
    /// Gravitational field strength.
    ///
    /// `g` in N/kg: >= 0.
    pub g: T,
    /// Radius of the front wheel.
    ///
    /// `rR` in m: > 0.
    pub rR: T,
    /// Mass of the front wheel.
    ///
    /// `mR` in kg: >= 0.
    pub mR: T,
    /// Radial moment of inertia of the front wheel; by symmetry also about the vertical.
    ///
    /// `IRxx` in kg*m^2: >= 0.
    pub IRxx: T,
    /// Axial moment of inertia of the front wheel.
    ///
    /// `IRyy` in kg*m^2: >= 0.
    pub IRyy: T,
    /// Centre of mass of the main frame and rider, behind the front contact.
    ///
    /// `xB` in m: any finite value.
    pub xB: T,
    /// Centre of mass of the main frame and rider, downward.
    ///
    /// `zB` in m: any finite value.
    pub zB: T,
    /// Mass of the main frame and rider.
    ///
    /// `mB` in kg: >= 0.
    pub mB: T,
    /// Moment of inertia of the main frame and rider about its centre of mass, in roll.
    ///
    /// `IBxx` in kg*m^2: >= 0.
    pub IBxx: T,
    /// Moment of inertia of the main frame and rider about its centre of mass, in pitch.
    ///
    /// `IByy` in kg*m^2: >= 0. No matrix depends on it.
    pub IByy: T,
    /// Moment of inertia of the main frame and rider about its centre of mass, in yaw.
    ///
    /// `IBzz` in kg*m^2: >= 0.
    pub IBzz: T,
    /// Product of inertia of the main frame and rider about its centre of mass.
    ///
    /// `IBxz` in kg*m^2: any finite value.
    pub IBxz: T,
    /// Centre of mass of the steered frame, behind the front contact.
    ///
    /// `xH` in m: any finite value.
    pub xH: T,
    /// Centre of mass of the steered frame, downward.
    ///
    /// `zH` in m: any finite value.
    pub zH: T,
    /// Mass of the steered frame.
    ///
    /// `mH` in kg: >= 0.
    pub mH: T,
    /// Moment of inertia of the steered frame about its centre of mass, in roll.
    ///
    /// `IHxx` in kg*m^2: >= 0.
    pub IHxx: T,
    /// Moment of inertia of the steered frame about its centre of mass, in pitch.
    ///
    /// `IHyy` in kg*m^2: >= 0. No matrix depends on it.
    pub IHyy: T,
    /// Moment of inertia of the steered frame about its centre of mass, in yaw.
    ///
    /// `IHzz` in kg*m^2: >= 0.
    pub IHzz: T,
    /// Product of inertia of the steered frame about its centre of mass.
    ///
    /// `IHxz` in kg*m^2: any finite value.
    pub IHxz: T,
    /// Radius of the rear wheel.
    ///
    /// `rF` in m: > 0.
    pub rF: T,
    /// Mass of the rear wheel.
    ///
    /// `mF` in kg: >= 0.
    pub mF: T,
    /// Radial moment of inertia of the rear wheel; by symmetry also about the vertical.
    ///
    /// `IFxx` in kg*m^2: >= 0.
    pub IFxx: T,
    /// Axial moment of inertia of the rear wheel.
    ///
    /// `IFyy` in kg*m^2: >= 0.
    pub IFyy: T,
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl RearSteered<::core::primitive::f64> {
    /// The parameter set `backwards`.
    ///
    /// Source: The benchmark of Meijaard et al. (2007), Table 1, run backwards
    pub const BACKWARDS: Self = Self {
        w: 1.02,
        c: 0.08,
        lam: 0.3141592653589793,
        g: 9.81,
        rR: 0.3,
        mR: 2.0,
        IRxx: 0.0603,
        IRyy: 0.12,
        xB: 0.3,
        zB: -0.9,
        mB: 85.0,
        IBxx: 9.2,
        IByy: 11.0,
        IBzz: 2.8,
        IBxz: 2.4,
        xH: 0.9,
        zH: -0.7,
        mH: 4.0,
        IHxx: 0.05892,
        IHyy: 0.06,
        IHzz: 0.00708,
        IHxz: -0.00756,
        rF: 0.35,
        mF: 3.0,
        IFxx: 0.1405,
        IFyy: 0.28,
    };
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> RearSteered<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 26]) -> Self {
        Self {
            w: values[0],
            c: values[1],
            lam: values[2],
            g: values[3],
            rR: values[4],
            mR: values[5],
            IRxx: values[6],
            IRyy: values[7],
            xB: values[8],
            zB: values[9],
            mB: values[10],
            IBxx: values[11],
            IByy: values[12],
            IBzz: values[13],
            IBxz: values[14],
            xH: values[15],
            zH: values[16],
            mH: values[17],
            IHxx: values[18],
            IHyy: values[19],
            IHzz: values[20],
            IHxz: values[21],
            rF: values[22],
            mF: values[23],
            IFxx: values[24],
            IFyy: values[25],
        }
    }
    /// The parameters as an array in declared order.
    #[must_use]
    pub const fn to_array(&self) -> [T; 26] {
        [
            self.w,
            self.c,
            self.lam,
            self.g,
            self.rR,
            self.mR,
            self.IRxx,
            self.IRyy,
            self.xB,
            self.zB,
            self.mB,
            self.IBxx,
            self.IByy,
            self.IBzz,
            self.IBxz,
            self.xH,
            self.zH,
            self.mH,
            self.IHxx,
            self.IHyy,
            self.IHzz,
            self.IHxz,
            self.rF,
            self.mF,
            self.IFxx,
            self.IFyy,
        ]
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> RearSteered<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: ::carvallo::Scalar>(&self) -> RearSteered<U> {
        RearSteered {
            w: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.w)),
            c: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.c)),
            lam: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.lam)),
            g: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.g)),
            rR: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.rR)),
            mR: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.mR)),
            IRxx: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IRxx)),
            IRyy: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IRyy)),
            xB: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.xB)),
            zB: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.zB)),
            mB: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.mB)),
            IBxx: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IBxx)),
            IByy: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IByy)),
            IBzz: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IBzz)),
            IBxz: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IBxz)),
            xH: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.xH)),
            zH: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.zH)),
            mH: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.mH)),
            IHxx: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IHxx)),
            IHyy: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IHyy)),
            IHzz: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IHzz)),
            IHxz: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IHxz)),
            rF: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.rF)),
            mF: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.mF)),
            IFxx: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IFxx)),
            IFyy: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IFyy)),
        }
    }
}
/// The coefficient matrices of [`RearSteered`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RearSteeredMatrices<T = ::core::primitive::f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: [[T; 2]; 2],
    /// Damping C1, a coefficient of v q'.
    pub c1: [[T; 2]; 2],
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: [[T; 2]; 2],
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: [[T; 2]; 2],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> RearSteered<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 46 additions, 55 multiplications, 3 divisions, 3 negations and 2 trigonometric functions: 109 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> RearSteeredMatrices<T> {
        let Jxx_delta = ((self.IHxx + self.IFxx) + (self.mH * (self.zH * self.zH)))
            + (self.mF * (self.rF * self.rF));
        let t26 = (((self.IRxx + self.IBxx) + Jxx_delta)
            + (self.mR * (self.rR * self.rR))) + (self.mB * (self.zB * self.zB));
        let (t28, t42) = ::carvallo::Number::sin_cos(self.lam);
        let t33 = self.w + self.c;
        let t34 = t33 - self.xH;
        let t35 = self.mH * t34;
        let t39 = self.rF * self.mF;
        let Jxz_delta = (self.c * t39) - ((self.zH * t35) + self.IHxz);
        let hx_delta = (Jxz_delta * t42) - (Jxx_delta * t28);
        let t45 = t42 / self.w;
        let yaw_by_delta = self.c * t45;
        let t50 = self.zB * self.mB;
        let Sz_delta = (self.zH * self.mH) - t39;
        let Jxz_all = ((Jxz_delta - self.IBxz) + (self.xB * t50)) + (Sz_delta * t33);
        let t58 = hx_delta + (yaw_by_delta * Jxz_all);
        let t67 = self.IHzz + self.IFxx;
        let hz_delta = (t42
            * (((self.mH * (t34 * t34)) + (self.mF * (self.c * self.c))) + t67))
            - (Jxz_delta * t28);
        let py_delta = (Sz_delta * t28) + (t42 * (t35 + (self.c * self.mF)));
        let M_yaw_delta = hz_delta - (py_delta * t33);
        let t90 = yaw_by_delta
            * (((((self.IRxx + self.IBzz) + t67) + (self.mB * (self.xB * self.xB)))
                + (self.mH * (self.xH * self.xH))) + (self.mF * (self.w * self.w)));
        let P_delta_yaw = M_yaw_delta + t90;
        let t96 = ((yaw_by_delta * (M_yaw_delta + P_delta_yaw)) - (hx_delta * t28))
            + (hz_delta * t42);
        let h_spin_R = self.IFyy / self.rF;
        let h_wheels_all = h_spin_R + (self.IRyy / self.rR);
        let Sz_all = (Sz_delta + t50) - (self.rR * self.mR);
        let t106 = h_wheels_all - Sz_all;
        let t110 = h_spin_R * t42;
        let t111 = ((yaw_by_delta * t106) - (t45 * Jxz_all)) + t110;
        let t119 = yaw_by_delta
            * (((self.w * self.mF) + (self.xB * self.mB)) + (self.xH * self.mH));
        let P_delta_lateral = py_delta - t119;
        let t123 = (yaw_by_delta * P_delta_lateral) - (t45 * P_delta_yaw);
        let t124 = t28 * P_delta_lateral;
        let t129 = -(t110 + (yaw_by_delta * h_wheels_all));
        let t130 = t119 - py_delta;
        let t131 = -(t45 * t106);
        let t132 = -(t45 * (P_delta_lateral - (h_spin_R * t28)));
        RearSteeredMatrices {
            m: [[t26, t58], [t58, t96]],
            c1: [[::carvallo::Number::like(self.w, 0.0), t111], [t129, t123]],
            k0: [[Sz_all, t130], [t130, t124]],
            k2: [
                [::carvallo::Number::like(self.w, 0.0), t131],
                [::carvallo::Number::like(self.w, 0.0), t132],
            ],
        }
    }
}
/// Rates and forces of [`RearSteered`] that follow from its coordinates q = (`phi`, `delta`), to first order and in SI units.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RearSteeredKinematics<T = ::core::primitive::f64> {
    /// Lateral velocity, to the right, in m/s: of the point of `B` that is at the origin.
    pub lateral: ::carvallo::Rate<T, 2>,
    /// Yaw rate, to the right, in rad/s: of `B`.
    pub yaw: ::carvallo::Rate<T, 2>,
    /// Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_F: ::carvallo::Rate<T, 2>,
    /// Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_R: ::carvallo::Rate<T, 2>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of `Tphi` (lean torque) in N*m, `Tdelta` (steer torque) in N*m.
    pub forces: [[T; 2]; 2],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> RearSteered<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 3 negations and 1 trigonometric function: 8 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> RearSteeredKinematics<T> {
        let t6 = (::carvallo::Number::cos(self.lam)) / self.w;
        let yaw_by_delta = self.c * t6;
        let t12 = -t6;
        let t13 = -(::carvallo::Number::like(self.w, 1.0) / self.rR);
        let t14 = -(::carvallo::Number::like(self.w, 1.0) / self.rF);
        RearSteeredKinematics {
            lateral: ::carvallo::Rate {
                speed: ::carvallo::Number::like(self.w, 0.0),
                rates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                coordinates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                heading: ::carvallo::Number::like(self.w, 1.0),
            },
            yaw: ::carvallo::Rate {
                speed: ::carvallo::Number::like(self.w, 0.0),
                rates: [::carvallo::Number::like(self.w, 0.0), yaw_by_delta],
                coordinates: [::carvallo::Number::like(self.w, 0.0), t12],
                heading: ::carvallo::Number::like(self.w, 0.0),
            },
            wheel_F: ::carvallo::Rate {
                speed: t13,
                rates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                coordinates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                heading: ::carvallo::Number::like(self.w, 0.0),
            },
            wheel_R: ::carvallo::Rate {
                speed: t14,
                rates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                coordinates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                heading: ::carvallo::Number::like(self.w, 0.0),
            },
            forces: [
                [
                    ::carvallo::Number::like(self.w, 1.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 1.0),
                ],
            ],
        }
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Model<2> for RearSteered<T> {
    type Scalar = T;
    type Parameters = [T; 26];
    type Over<U: ::carvallo::Number> = RearSteered<U>;
    const INFO: &'static ::carvallo::ModelInfo = &::carvallo::ModelInfo {
        name: "RearSteered",
        docs: "A bicycle that is steered at the rear: a Whipple bicycle run backwards, with its geometry mirrored.\n\nFour rigid bodies (front wheel F, main frame with a rigid rider B, steered frame H, steered rear wheel R),\nlaterally symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the front\ncontact point, x forward, y to the right, z down. Lengths along x are counted backward from the front contact, so\nthat the parameters of a bicycle are those of the same bicycle run backwards.",
        source: "Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3",
        parameters: &[
            ::carvallo::ParameterInfo {
                name: "w",
                symbol: "w",
                docs: "Wheel base.",
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
                docs: "Distance by which the steer axis meets the ground behind the contact of the steered wheel.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "lam",
                symbol: "λ",
                docs: "Steer axis tilt: from the ground upward the axis leans forward by this angle.",
                unit: "rad",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(-1.5707963267948966),
                    upper: ::carvallo::Bound::Open(1.5707963267948966),
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
            ::carvallo::ParameterInfo {
                name: "rR",
                symbol: "rR",
                docs: "Radius of the front wheel.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "mR",
                symbol: "mR",
                docs: "Mass of the front wheel.",
                unit: "kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IRxx",
                symbol: "IRxx",
                docs: "Radial moment of inertia of the front wheel; by symmetry also about the vertical.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IRyy",
                symbol: "IRyy",
                docs: "Axial moment of inertia of the front wheel.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "xB",
                symbol: "xB",
                docs: "Centre of mass of the main frame and rider, behind the front contact.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "zB",
                symbol: "zB",
                docs: "Centre of mass of the main frame and rider, downward.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "mB",
                symbol: "mB",
                docs: "Mass of the main frame and rider.",
                unit: "kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IBxx",
                symbol: "IBxx",
                docs: "Moment of inertia of the main frame and rider about its centre of mass, in roll.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IByy",
                symbol: "IByy",
                docs: "Moment of inertia of the main frame and rider about its centre of mass, in pitch.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: false,
            },
            ::carvallo::ParameterInfo {
                name: "IBzz",
                symbol: "IBzz",
                docs: "Moment of inertia of the main frame and rider about its centre of mass, in yaw.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IBxz",
                symbol: "IBxz",
                docs: "Product of inertia of the main frame and rider about its centre of mass.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "xH",
                symbol: "xH",
                docs: "Centre of mass of the steered frame, behind the front contact.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "zH",
                symbol: "zH",
                docs: "Centre of mass of the steered frame, downward.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "mH",
                symbol: "mH",
                docs: "Mass of the steered frame.",
                unit: "kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IHxx",
                symbol: "IHxx",
                docs: "Moment of inertia of the steered frame about its centre of mass, in roll.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IHyy",
                symbol: "IHyy",
                docs: "Moment of inertia of the steered frame about its centre of mass, in pitch.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: false,
            },
            ::carvallo::ParameterInfo {
                name: "IHzz",
                symbol: "IHzz",
                docs: "Moment of inertia of the steered frame about its centre of mass, in yaw.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IHxz",
                symbol: "IHxz",
                docs: "Product of inertia of the steered frame about its centre of mass.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "rF",
                symbol: "rF",
                docs: "Radius of the rear wheel.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "mF",
                symbol: "mF",
                docs: "Mass of the rear wheel.",
                unit: "kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IFxx",
                symbol: "IFxx",
                docs: "Radial moment of inertia of the rear wheel; by symmetry also about the vertical.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IFyy",
                symbol: "IFyy",
                docs: "Axial moment of inertia of the rear wheel.",
                unit: "kg*m^2",
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
                docs: "Lean of the main frame, positive to the right.",
                unit: "rad",
            },
            ::carvallo::CoordinateInfo {
                name: "delta",
                label: "steer",
                docs: "Steer of the steered frame relative to the main frame, positive to the right seen from above.",
                unit: "rad",
            },
        ],
        matrices: &["M", "C1", "K0", "K2"],
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
                places: &[("C1", 0, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("C1", 1, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("C1", 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("K0", 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("K0", 0, 1), ("K0", 1, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("K0", 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("K2", 0, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("K2", 1, 1)],
            },
        ],
        sets: &[
            ::carvallo::SetInfo {
                name: "backwards",
                docs: "",
                source: "The benchmark of Meijaard et al. (2007), Table 1, run backwards",
                values: &[
                    1.02,
                    0.08,
                    0.3141592653589793,
                    9.81,
                    0.3,
                    2.0,
                    0.0603,
                    0.12,
                    0.3,
                    -0.9,
                    85.0,
                    9.2,
                    11.0,
                    2.8,
                    2.4,
                    0.9,
                    -0.7,
                    4.0,
                    0.05892,
                    0.06,
                    0.00708,
                    -0.00756,
                    0.35,
                    3.0,
                    0.1405,
                    0.28,
                ],
            },
        ],
        gravity: ::core::option::Option::Some(3),
    };
    fn from_slice(
        values: &[T],
    ) -> ::core::result::Result<Self, ::carvallo::LengthError> {
        if values.len() != 26 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "RearSteered",
                expected: 26,
                found: values.len(),
            });
        }
        ::core::result::Result::Ok(Self {
            w: values[0],
            c: values[1],
            lam: values[2],
            g: values[3],
            rR: values[4],
            mR: values[5],
            IRxx: values[6],
            IRyy: values[7],
            xB: values[8],
            zB: values[9],
            mB: values[10],
            IBxx: values[11],
            IByy: values[12],
            IBzz: values[13],
            IBxz: values[14],
            xH: values[15],
            zH: values[16],
            mH: values[17],
            IHxx: values[18],
            IHyy: values[19],
            IHzz: values[20],
            IHxz: values[21],
            rF: values[22],
            mF: values[23],
            IFxx: values[24],
            IFyy: values[25],
        })
    }
    fn write_to(
        &self,
        values: &mut [T],
    ) -> ::core::result::Result<(), ::carvallo::LengthError> {
        if values.len() != 26 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "RearSteered",
                expected: 26,
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
                ::carvallo::Scalar::to_f64(self.w),
                ::carvallo::Scalar::to_f64(self.c),
                ::carvallo::Scalar::to_f64(self.lam),
                ::carvallo::Scalar::to_f64(self.g),
                ::carvallo::Scalar::to_f64(self.rR),
                ::carvallo::Scalar::to_f64(self.mR),
                ::carvallo::Scalar::to_f64(self.IRxx),
                ::carvallo::Scalar::to_f64(self.IRyy),
                ::carvallo::Scalar::to_f64(self.xB),
                ::carvallo::Scalar::to_f64(self.zB),
                ::carvallo::Scalar::to_f64(self.mB),
                ::carvallo::Scalar::to_f64(self.IBxx),
                ::carvallo::Scalar::to_f64(self.IByy),
                ::carvallo::Scalar::to_f64(self.IBzz),
                ::carvallo::Scalar::to_f64(self.IBxz),
                ::carvallo::Scalar::to_f64(self.xH),
                ::carvallo::Scalar::to_f64(self.zH),
                ::carvallo::Scalar::to_f64(self.mH),
                ::carvallo::Scalar::to_f64(self.IHxx),
                ::carvallo::Scalar::to_f64(self.IHyy),
                ::carvallo::Scalar::to_f64(self.IHzz),
                ::carvallo::Scalar::to_f64(self.IHxz),
                ::carvallo::Scalar::to_f64(self.rF),
                ::carvallo::Scalar::to_f64(self.mF),
                ::carvallo::Scalar::to_f64(self.IFxx),
                ::carvallo::Scalar::to_f64(self.IFyy),
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
            matrices.k2,
        ])
    }
    fn gravity(&self) -> ::core::option::Option<T> {
        ::core::option::Option::Some(self.g)
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> ::carvallo::Evaluator<T, 2> for RearSteered<T> {
    type Entries = [T; 11];
    #[inline(always)]
    fn from_parameters(
        mut parameter: impl ::core::ops::FnMut(::core::primitive::usize) -> T,
    ) -> Self {
        Self {
            w: parameter(0),
            c: parameter(1),
            lam: parameter(2),
            g: parameter(3),
            rR: parameter(4),
            mR: parameter(5),
            IRxx: parameter(6),
            IRyy: parameter(7),
            xB: parameter(8),
            zB: parameter(9),
            mB: parameter(10),
            IBxx: parameter(11),
            IByy: parameter(12),
            IBzz: parameter(13),
            IBxz: parameter(14),
            xH: parameter(15),
            zH: parameter(16),
            mH: parameter(17),
            IHxx: parameter(18),
            IHyy: parameter(19),
            IHzz: parameter(20),
            IHxz: parameter(21),
            rF: parameter(22),
            mF: parameter(23),
            IFxx: parameter(24),
            IFyy: parameter(25),
        }
    }
    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        let matrices = self.matrices();
        [
            matrices.m[0][0],
            matrices.m[0][1],
            matrices.m[1][1],
            matrices.c1[0][1],
            matrices.c1[1][0],
            matrices.c1[1][1],
            matrices.k0[0][0],
            matrices.k0[0][1],
            matrices.k0[1][1],
            matrices.k2[0][1],
            matrices.k2[1][1],
        ]
    }
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 6] {
        let matrices = self.matrices();
        [
            matrices.m,
            [[::carvallo::Number::like(self.w, 0.0); 2]; 2],
            matrices.c1,
            [[::carvallo::Number::like(self.w, 0.0); 2]; 2],
            matrices.k0,
            matrices.k2,
        ]
    }
}
