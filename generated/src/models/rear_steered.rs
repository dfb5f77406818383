// @generated from generated/models/rear_steered.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 55b70df1229c7642

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
    type Array<U: ::core::marker::Copy> = [U; 26];
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
/// The derivatives of the matrices of [`RearSteered`] with respect to its parameters, in SI units: those that are not zero for all parameters.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RearSteeredDerivatives<T = ::core::primitive::f64> {
    /// The value of each derivative in [`Self::PARTIALS`].
    pub values: [T; 158],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl RearSteeredDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [::carvallo::Partial; 158] = &[
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 6),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 6),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 6),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 11),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 14),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 14),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 14),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 18),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 18),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 18),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 18),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 20),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 20),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 21),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 21),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 21),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 21),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 21),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 24),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 24),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 24),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 24),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 24),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 25),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 25),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 25),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 25),
    ];
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> RearSteeredDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(
        &self,
        parameter: ::core::primitive::usize,
    ) -> ::core::option::Option<RearSteeredMatrices<T>> {
        if parameter >= 26 {
            return ::core::option::Option::None;
        }
        let zero = <T as ::carvallo::Scalar>::from_f64(0.0);
        let mut matrices = RearSteeredMatrices {
            m: [[zero; 2]; 2],
            c1: [[zero; 2]; 2],
            k0: [[zero; 2]; 2],
            k2: [[zero; 2]; 2],
        };
        for position in 0..158 {
            let partial = <RearSteeredDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                ::carvallo::MatrixName::M => &mut matrices.m,
                ::carvallo::MatrixName::C1 => &mut matrices.c1,
                ::carvallo::MatrixName::K0 => &mut matrices.k0,
                ::carvallo::MatrixName::K2 => &mut matrices.k2,
                _ => continue,
            };
            matrix[partial.row][partial.column] = self.values[position];
        }
        ::core::option::Option::Some(matrices)
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> RearSteered<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 162 additions, 274 multiplications, 3 divisions, 41 negations and 2 trigonometric functions: 482 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(
        &self,
    ) -> (RearSteeredMatrices<T>, RearSteeredDerivatives<T>) {
        let Jxx_delta_mH = self.zH * self.zH;
        let Jxx_delta_mF = self.rF * self.rF;
        let Jxx_delta = ((self.IHxx + self.IFxx) + (self.mH * Jxx_delta_mH))
            + (self.mF * Jxx_delta_mF);
        let t19 = self.rR * self.rR;
        let t24 = self.zB * self.zB;
        let t26 = (((self.IRxx + self.IBxx) + Jxx_delta) + (self.mR * t19))
            + (self.mB * t24);
        let (t28, t43) = ::carvallo::Number::sin_cos(self.lam);
        let t34 = self.w + self.c;
        let t36 = t34 - self.xH;
        let t37 = self.mH * t36;
        let t40 = self.rF * self.mF;
        let Jxz_delta = (self.c * t40) - (self.IHxz + (self.zH * t37));
        let t44 = Jxz_delta * t43;
        let hx_delta = t44 - (Jxx_delta * t28);
        let t46 = ::carvallo::Number::like(self.w, 1.0) / self.w;
        let t47 = t43 * t46;
        let yaw_by_delta = self.c * t47;
        let t52 = self.zB * self.mB;
        let t55 = self.zH * self.mH;
        let Sz_delta = t55 - t40;
        let Jxz_all = ((Jxz_delta - self.IBxz) + (self.xB * t52)) + (t34 * Sz_delta);
        let t60 = hx_delta + (yaw_by_delta * Jxz_all);
        let t62 = Jxz_delta * t28;
        let t64 = self.IHzz + self.IFxx;
        let t65 = t36 * t36;
        let t68 = self.c * self.c;
        let t70 = (t64 + (self.mH * t65)) + (self.mF * t68);
        let hz_delta = (t43 * t70) - t62;
        let Jxz_delta_rF = self.c * self.mF;
        let t77 = t37 + Jxz_delta_rF;
        let py_delta = (t28 * Sz_delta) + (t43 * t77);
        let M_yaw_delta = hz_delta - (t34 * py_delta);
        let t85 = self.xB * self.xB;
        let t88 = self.xH * self.xH;
        let t91 = self.w * self.w;
        let P_delta_yaw_yaw_by_delta = ((((self.IRxx + self.IBzz) + t64)
            + (self.mB * t85)) + (self.mH * t88)) + (self.mF * t91);
        let t94 = yaw_by_delta * P_delta_yaw_yaw_by_delta;
        let P_delta_yaw = M_yaw_delta + t94;
        let t96 = M_yaw_delta + P_delta_yaw;
        let t98 = ((t43 * hz_delta) - (hx_delta * t28)) + (yaw_by_delta * t96);
        let t101 = ::carvallo::Number::like(self.w, 1.0) / self.rF;
        let h_spin_R = self.IFyy * t101;
        let t103 = t43 * h_spin_R;
        let t104 = Jxz_all * t47;
        let t107 = ::carvallo::Number::like(self.w, 1.0) / self.rR;
        let h_wheels_all = h_spin_R + (self.IRyy * t107);
        let t111 = self.mR * self.rR;
        let Sz_all = (t52 + Sz_delta) - t111;
        let t113 = h_wheels_all - Sz_all;
        let t115 = (t103 - t104) + (yaw_by_delta * t113);
        let t119 = self.w * self.mF;
        let t120 = self.xB * self.mB;
        let t122 = self.xH * self.mH;
        let t123 = (t119 + t120) + t122;
        let t124 = yaw_by_delta * t123;
        let P_delta_lateral = py_delta - t124;
        let t127 = (yaw_by_delta * P_delta_lateral) - (P_delta_yaw * t47);
        let t128 = t28 * P_delta_lateral;
        let t130 = t28 * h_spin_R;
        let t131 = t130 - P_delta_lateral;
        let t132 = t47 * t131;
        let M12_Jxz_delta = t43 + yaw_by_delta;
        let t134 = t55 * M12_Jxz_delta;
        let t136 = (yaw_by_delta * Sz_delta) - t134;
        let t138 = t43 * (t46 * t46);
        let t139 = self.c * Jxz_all;
        let t141 = t136 - (t138 * t139);
        let t142 = self.mH * t43;
        let t144 = yaw_by_delta * ::carvallo::Number::like(self.w, 2.0);
        let t145 = t34 * t144;
        let t147 = t36 * t43;
        let t148 = self.mH * ::carvallo::Number::like(self.w, 2.0);
        let t149 = t147 * t148;
        let M22_hz_delta = t43 + t144;
        let t154 = t28 * (t43 + M22_hz_delta);
        let t156 = ((t149 * M22_hz_delta) - (t142 * t145)) + (t55 * t154);
        let t158 = t156 - (py_delta * t144);
        let P_delta_yaw_w = t119 * t144;
        let M22_yaw_by_delta = t94 + t96;
        let t163 = self.c * M22_yaw_by_delta;
        let t165 = (t158 + (yaw_by_delta * P_delta_yaw_w)) - (t138 * t163);
        let t166 = t55 * t47;
        let t168 = t166 - (Sz_delta * t47);
        let t170 = (self.c * t113) - Jxz_all;
        let t172 = t168 - (t138 * t170);
        let t173 = self.c * h_wheels_all;
        let t174 = t138 * t173;
        let C122_py_delta = t34 * t47;
        let C122_Jxz_delta = t28 * t47;
        let t181 = ((t142 * C122_py_delta) - (t149 * t47)) - (t55 * C122_Jxz_delta);
        let t183 = t181 + (t47 * py_delta);
        let t187 = self.c * t123;
        let t189 = (self.mF * yaw_by_delta) - (t138 * t187);
        let P_delta_lateral_w = t142 - t189;
        let C122_yaw_by_delta = P_delta_lateral - (P_delta_yaw_yaw_by_delta * t47);
        let t196 = (self.c * C122_yaw_by_delta) - P_delta_yaw;
        let t198 = ((t183 - (P_delta_yaw_w * t47)) + (yaw_by_delta * P_delta_lateral_w))
            - (t138 * t196);
        let t199 = t28 * P_delta_lateral_w;
        let t200 = t138 * t113;
        let t206 = (t136 + (t40 * M12_Jxz_delta)) + t104;
        let py_delta_c = self.mF * t43;
        let t214 = self.c * t43;
        let t215 = self.mF * ::carvallo::Number::like(self.w, 2.0);
        let hz_delta_c = t214 * t215;
        let t218 = (((t158 - (t40 * t154)) + (t47 * M22_yaw_by_delta))
            - (py_delta_c * t145)) + (hz_delta_c * M22_hz_delta);
        let t221 = t168 + (t47 * (t113 - t40));
        let t229 = t47 * t123;
        let P_delta_lateral_c = (py_delta_c + t142) - t229;
        let t234 = (((t183 + (t40 * C122_Jxz_delta))
            + (t47 * (C122_yaw_by_delta - hz_delta_c)))
            + (yaw_by_delta * P_delta_lateral_c)) + (py_delta_c * C122_py_delta);
        let t236 = (t229 - t142) - py_delta_c;
        let t237 = t28 * P_delta_lateral_c;
        let t240 = (Jxx_delta * t43) + t62;
        let t241 = t46 * t28;
        let py_delta_lam = (Sz_delta * t43) - (t28 * t77);
        let t255 = t44 + (t28 * t70);
        let t259 = (((((t240 * t28) - (hx_delta * t43)) - (hz_delta * t28))
            - (py_delta_lam * t145)) - (t255 * M22_hz_delta)) - (t241 * t163);
        let t263 = t130 + (t241 * t173);
        let P_delta_lateral_lam = py_delta_lam + (t241 * t187);
        let t272 = (((t255 * t47) + (yaw_by_delta * P_delta_lateral_lam))
            + (py_delta_lam * C122_py_delta)) - (t241 * t196);
        let t275 = (t28 * P_delta_lateral_lam) + (P_delta_lateral * t43);
        let t276 = t241 * t113;
        let t280 = (t47 * (t103 - P_delta_lateral_lam)) - (t241 * t131);
        let t281 = t111 * ::carvallo::Number::like(self.w, 2.0);
        let t283 = self.IRyy * (t107 * t107);
        let t284 = self.mR - t283;
        let t285 = yaw_by_delta * t284;
        let t286 = t283 * yaw_by_delta;
        let t288 = self.rR * yaw_by_delta;
        let t290 = yaw_by_delta * yaw_by_delta;
        let t292 = yaw_by_delta * t107;
        let t294 = yaw_by_delta * t52;
        let P_delta_yaw_xB = t120 * t144;
        let t296 = yaw_by_delta * P_delta_yaw_xB;
        let t299 = self.mB * yaw_by_delta;
        let t303 = t47 * t299;
        let t304 = ::carvallo::Number::like(self.w, 2.0) * t52;
        let t305 = self.xB * yaw_by_delta;
        let t306 = self.mB * t305;
        let t308 = yaw_by_delta + (self.xB * t47);
        let t310 = self.mB * t47;
        let t311 = self.zB * t305;
        let P_delta_yaw_mB = yaw_by_delta * t85;
        let t313 = yaw_by_delta * P_delta_yaw_mB;
        let t319 = self.zB * t47;
        let t320 = t47 * t305;
        let P_delta_yaw_xH = t122 * t144;
        let t323 = (yaw_by_delta * P_delta_yaw_xH) - t156;
        let t327 = t142 + (self.mH * yaw_by_delta);
        let t331 = t327 * t47;
        let Jxx_delta_zH = self.zH * t148;
        let t336 = t34 * yaw_by_delta;
        let t338 = (self.mH * t336) - ((Jxx_delta_zH * t28) + (M12_Jxz_delta * t37));
        let py_delta_zH = self.mH * t28;
        let M22_Jxx_delta = t28 * t28;
        let t345 = ((t154 * t37) - (py_delta_zH * t145))
            + (Jxx_delta_zH * M22_Jxx_delta);
        let t346 = yaw_by_delta + C122_py_delta;
        let t349 = (t37 * t47) - (self.mH * t346);
        let t354 = ((yaw_by_delta * py_delta_zH) - (C122_Jxz_delta * t37))
            + (py_delta_zH * C122_py_delta);
        let t355 = t28 * py_delta_zH;
        let t356 = self.mH * t47;
        let t361 = self.zH * t36;
        let t363 = ((self.zH * t336) - (Jxx_delta_mH * t28)) - (t361 * M12_Jxz_delta);
        let P_delta_yaw_mH = yaw_by_delta * t88;
        let py_delta_mH = (self.zH * t28) + t147;
        let hz_delta_mH = t43 * t65;
        let t376 = ((((yaw_by_delta * P_delta_yaw_mH) - (py_delta_mH * t145))
            + (hz_delta_mH * M22_hz_delta)) + (Jxx_delta_mH * M22_Jxx_delta))
            + (t361 * t154);
        let t379 = (t361 * t47) - (self.zH * t346);
        let t382 = self.xH * yaw_by_delta;
        let P_delta_lateral_mH = py_delta_mH - t382;
        let t389 = (((yaw_by_delta * P_delta_lateral_mH)
            - (t47 * (P_delta_yaw_mH + hz_delta_mH))) + (py_delta_mH * C122_py_delta))
            - (t361 * C122_Jxz_delta);
        let t390 = t28 * P_delta_lateral_mH;
        let t391 = self.zH * t47;
        let t394 = (t43 * M22_hz_delta) + t290;
        let Jxx_delta_rF = self.rF * t215;
        let t401 = (Jxz_delta_rF * M12_Jxz_delta)
            - ((t336 * self.mF) + (Jxx_delta_rF * t28));
        let t402 = self.mF * t28;
        let t407 = ((t402 * t145) + (Jxx_delta_rF * M22_Jxx_delta))
            - (Jxz_delta_rF * t154);
        let t412 = self.IFyy * (t101 * t101);
        let t413 = t412 * M12_Jxz_delta;
        let t414 = ((t346 * self.mF) - (Jxz_delta_rF * t47)) - t413;
        let t417 = (Jxz_delta_rF * C122_Jxz_delta) - (t402 * t346);
        let t423 = (t402 * t47) - (t412 * C122_Jxz_delta);
        let Jxz_delta_mF = self.c * self.rF;
        let t429 = (Jxz_delta_mF * M12_Jxz_delta)
            - ((t336 * self.rF) + (Jxx_delta_mF * t28));
        let P_delta_yaw_mF = yaw_by_delta * t91;
        let py_delta_mF = t214 - (self.rF * t28);
        let hz_delta_mF = t43 * t68;
        let t442 = ((((yaw_by_delta * P_delta_yaw_mF) - (py_delta_mF * t145))
            + (hz_delta_mF * M22_hz_delta)) + (Jxx_delta_mF * M22_Jxx_delta))
            - (Jxz_delta_mF * t154);
        let t447 = self.w * yaw_by_delta;
        let P_delta_lateral_mF = py_delta_mF - t447;
        let t454 = (((yaw_by_delta * P_delta_lateral_mF)
            - (t47 * (P_delta_yaw_mF + hz_delta_mF))) + (py_delta_mF * C122_py_delta))
            + (Jxz_delta_mF * C122_Jxz_delta);
        let t455 = t28 * P_delta_lateral_mF;
        let t458 = t394 + M22_Jxx_delta;
        let t459 = t101 * M12_Jxz_delta;
        let t461 = t101 * C122_Jxz_delta;
        let t462 = -(t103 + (yaw_by_delta * h_wheels_all));
        let t463 = t124 - py_delta;
        let t464 = -(t113 * t47);
        let t465 = t189 - t142;
        let t466 = -((P_delta_lateral_w * t47) + (t138 * t131));
        let t467 = -(h_wheels_all * t47);
        let t468 = -(P_delta_lateral_c * t47);
        let t469 = -(t240 + (t241 * t139));
        let t470 = -(t130 + (t241 * t170));
        let t471 = -P_delta_lateral_lam;
        let t472 = -self.mR;
        let t473 = -(t284 * t47);
        let t474 = -self.rR;
        let t475 = -(self.rR * t47);
        let t476 = -(yaw_by_delta * t47);
        let t477 = -t292;
        let t478 = -(t107 * t47);
        let t479 = -(t52 * t47);
        let t480 = -((t47 * P_delta_yaw_xB) + (yaw_by_delta * t299));
        let t481 = -(t299 * t28);
        let t482 = -(self.mB * t308);
        let t483 = -(self.zB * t308);
        let t484 = -((t47 * P_delta_yaw_mB) + (yaw_by_delta * t305));
        let t485 = -(t305 * t28);
        let t486 = -yaw_by_delta;
        let t487 = -t166;
        let t488 = -(((P_delta_yaw_xH * t47) + t181) + (yaw_by_delta * t327));
        let t489 = -(t28 * t327);
        let t490 = -py_delta_zH;
        let t491 = -(py_delta_zH * t47);
        let t492 = t382 - py_delta_mH;
        let t493 = -(P_delta_lateral_mH * t47);
        let t494 = -t28;
        let t495 = -(t47 * M12_Jxz_delta);
        let t496 = -M12_Jxz_delta;
        let t497 = -C122_Jxz_delta;
        let t498 = -self.mF;
        let t499 = -(t28 * t402);
        let t500 = -(t47 * (self.mF - t412));
        let t501 = (self.rF * t346) - (t47 * Jxz_delta_mF);
        let t502 = -self.rF;
        let t503 = t447 - py_delta_mF;
        let t504 = -(self.rF * t47);
        let t505 = -(P_delta_lateral_mF * t47);
        let t506 = -t459;
        let t507 = -(t101 * t47);
        (
            RearSteeredMatrices {
                m: [[t26, t60], [t60, t98]],
                c1: [[::carvallo::Number::like(self.w, 0.0), t115], [t462, t127]],
                k0: [[Sz_all, t463], [t463, t128]],
                k2: [
                    [::carvallo::Number::like(self.w, 0.0), t464],
                    [::carvallo::Number::like(self.w, 0.0), t132],
                ],
            },
            RearSteeredDerivatives {
                values: [
                    t141,
                    t141,
                    t165,
                    t172,
                    t174,
                    t198,
                    t465,
                    t465,
                    t199,
                    t200,
                    t466,
                    t206,
                    t206,
                    t218,
                    t221,
                    t467,
                    t234,
                    t236,
                    t236,
                    t237,
                    t468,
                    t469,
                    t469,
                    t259,
                    t470,
                    t263,
                    t272,
                    t471,
                    t471,
                    t275,
                    t276,
                    t280,
                    t281,
                    t285,
                    t286,
                    t472,
                    t473,
                    t19,
                    t288,
                    t474,
                    t475,
                    ::carvallo::Number::like(self.w, 1.0),
                    t290,
                    t476,
                    t292,
                    t477,
                    t478,
                    t294,
                    t294,
                    t296,
                    t479,
                    t480,
                    t299,
                    t299,
                    t481,
                    t303,
                    t304,
                    t306,
                    t306,
                    t482,
                    self.mB,
                    t310,
                    t24,
                    t311,
                    t311,
                    t313,
                    t483,
                    t484,
                    self.zB,
                    t305,
                    t305,
                    t485,
                    t319,
                    t320,
                    ::carvallo::Number::like(self.w, 1.0),
                    t290,
                    t476,
                    t486,
                    t486,
                    t47,
                    t134,
                    t134,
                    t323,
                    t487,
                    t488,
                    t327,
                    t327,
                    t489,
                    t331,
                    Jxx_delta_zH,
                    t338,
                    t338,
                    t345,
                    t349,
                    t354,
                    self.mH,
                    t490,
                    t490,
                    t355,
                    t356,
                    t491,
                    Jxx_delta_mH,
                    t363,
                    t363,
                    t376,
                    t379,
                    t389,
                    self.zH,
                    t492,
                    t492,
                    t390,
                    t391,
                    t493,
                    ::carvallo::Number::like(self.w, 1.0),
                    t494,
                    t494,
                    M22_Jxx_delta,
                    t394,
                    t495,
                    t496,
                    t496,
                    t154,
                    t47,
                    t497,
                    Jxx_delta_rF,
                    t401,
                    t401,
                    t407,
                    t414,
                    t413,
                    t417,
                    t498,
                    t402,
                    t402,
                    t499,
                    t500,
                    t423,
                    Jxx_delta_mF,
                    t429,
                    t429,
                    t442,
                    t501,
                    t454,
                    t502,
                    t503,
                    t503,
                    t455,
                    t504,
                    t505,
                    ::carvallo::Number::like(self.w, 1.0),
                    t494,
                    t494,
                    t458,
                    t495,
                    t459,
                    t506,
                    t507,
                    t461,
                ],
            },
        )
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Differentiable<2> for RearSteered<T> {
    type Derivatives = [::carvallo::Coefficients<T, 2>; 26];
    fn coefficients_and_derivatives(
        &self,
    ) -> (::carvallo::Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let mut all = [::carvallo::Coefficients::from_rows(
            [[[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2]; 6],
        ); 26];
        for position in 0..158 {
            <RearSteeredDerivatives>::PARTIALS[position]
                .write(derivatives.values[position], &mut all);
        }
        (
            ::carvallo::Coefficients::from_rows([
                matrices.m,
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
                matrices.c1,
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
                matrices.k0,
                matrices.k2,
            ]),
            all,
        )
    }
}
