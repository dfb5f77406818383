// @generated from generated/models/whipple_mechanism.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: dc474ea890db6fad

/// The Whipple-Carvallo bicycle, derived from its bodies, joints and wheels.
///
/// Four rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally
/// symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,
/// x forward, y to the right, z down, so that a centre of mass above the ground has z < 0.
///
/// The declaration asserts that the matrices are those of Appendix A of the paper, which is proved when it is compiled.
/// [`Whipple`](crate::Whipple) computes them from these formulas.
///
/// Source: Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3
///
/// Derived from a mechanism: body `B` (rear frame and rider), body `H` (front frame), wheel `R` (rear wheel), wheel `F` (front wheel).
///
/// The fields are the parameters. The coordinates are `phi` (lean) in rad, `delta` (steer) in rad.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleMechanism<T = ::core::primitive::f64> {
    /// Wheel base.
    ///
    /// `w` in m: > 0.
    pub w: T,
    /// Trail: positive when the front contact is behind the point where the steer axis meets the ground.
    ///
    /// `c` in m: any finite value.
    pub c: T,
    /// Steer axis tilt: 90 degrees minus the head angle.
    ///
    /// `lam`, λ, in rad: > -1.5707963267948966 and < 1.5707963267948966.
    pub lam: T,
    /// Gravitational field strength.
    ///
    /// `g` in N/kg: >= 0.
    pub g: T,
    /// Radius of the rear wheel.
    ///
    /// `rR` in m: > 0.
    pub rR: T,
    /// Mass of the rear wheel.
    ///
    /// `mR` in kg: >= 0.
    pub mR: T,
    /// Radial moment of inertia of the rear wheel; by symmetry also about the vertical.
    ///
    /// `IRxx` in kg*m^2: >= 0.
    pub IRxx: T,
    /// Axial moment of inertia of the rear wheel.
    ///
    /// `IRyy` in kg*m^2: >= 0.
    pub IRyy: T,
    /// Centre of mass of the rear frame and rider, forward of the rear contact.
    ///
    /// `xB` in m: any finite value.
    pub xB: T,
    /// Centre of mass of the rear frame and rider, downward.
    ///
    /// `zB` in m: any finite value.
    pub zB: T,
    /// Mass of the rear frame and rider.
    ///
    /// `mB` in kg: >= 0.
    pub mB: T,
    /// Moment of inertia of the rear frame and rider about its centre of mass, in roll.
    ///
    /// `IBxx` in kg*m^2: >= 0.
    pub IBxx: T,
    /// Moment of inertia of the rear frame and rider about its centre of mass, in pitch.
    ///
    /// `IByy` in kg*m^2: >= 0. No matrix depends on it.
    pub IByy: T,
    /// Moment of inertia of the rear frame and rider about its centre of mass, in yaw.
    ///
    /// `IBzz` in kg*m^2: >= 0.
    pub IBzz: T,
    /// Product of inertia of the rear frame and rider about its centre of mass.
    ///
    /// `IBxz` in kg*m^2: any finite value.
    pub IBxz: T,
    /// Centre of mass of the front frame, forward of the rear contact.
    ///
    /// `xH` in m: any finite value.
    pub xH: T,
    /// Centre of mass of the front frame, downward.
    ///
    /// `zH` in m: any finite value.
    pub zH: T,
    /// Mass of the front frame.
    ///
    /// `mH` in kg: >= 0.
    pub mH: T,
    /// Moment of inertia of the front frame about its centre of mass, in roll.
    ///
    /// `IHxx` in kg*m^2: >= 0.
    pub IHxx: T,
    /// Moment of inertia of the front frame about its centre of mass, in pitch.
    ///
    /// `IHyy` in kg*m^2: >= 0. No matrix depends on it.
    pub IHyy: T,
    /// Moment of inertia of the front frame about its centre of mass, in yaw.
    ///
    /// `IHzz` in kg*m^2: >= 0.
    pub IHzz: T,
    /// Product of inertia of the front frame about its centre of mass.
    ///
    /// `IHxz` in kg*m^2: any finite value.
    pub IHxz: T,
    /// Radius of the front wheel.
    ///
    /// `rF` in m: > 0.
    pub rF: T,
    /// Mass of the front wheel.
    ///
    /// `mF` in kg: >= 0.
    pub mF: T,
    /// Radial moment of inertia of the front wheel; by symmetry also about the vertical.
    ///
    /// `IFxx` in kg*m^2: >= 0.
    pub IFxx: T,
    /// Axial moment of inertia of the front wheel.
    ///
    /// `IFyy` in kg*m^2: >= 0.
    pub IFyy: T,
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl WhippleMechanism<::core::primitive::f64> {
    /// The parameter set `benchmark`.
    ///
    /// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1
    pub const BENCHMARK: Self = Self {
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
    /// The parameter set `benchmark_2005`.
    ///
    /// Source: Schwab, Meijaard & Papadopoulos (2005), ENOC 2005
    pub const BENCHMARK_2005: Self = Self {
        w: 1.02,
        c: 0.08,
        lam: 0.3217505543966422,
        g: 9.81,
        rR: 0.3,
        mR: 2.0,
        IRxx: 0.06,
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
        IHxx: 0.0546,
        IHyy: 0.06,
        IHzz: 0.0114,
        IHxz: -0.0162,
        rF: 0.35,
        mF: 3.0,
        IFxx: 0.14,
        IFyy: 0.28,
    };
    /// A bicycle that balances itself without gyroscopic effects and without trail: two points of mass on skates.
    ///
    /// Source: Kooijman, Meijaard, Papadopoulos, Ruina & Schwab (2011), Science 332, 339-342
    pub const TWO_MASS_SKATE: Self = Self {
        w: 1.0,
        c: 0.0,
        lam: 0.08726646259971647,
        g: 9.81,
        rR: 0.1,
        mR: 0.0,
        IRxx: 0.0,
        IRyy: 0.0,
        xB: 1.2,
        zB: -0.4,
        mB: 10.0,
        IBxx: 0.0,
        IByy: 0.0,
        IBzz: 0.0,
        IBxz: 0.0,
        xH: 1.02,
        zH: -0.2,
        mH: 1.0,
        IHxx: 0.0,
        IHyy: 0.0,
        IHzz: 0.0,
        IHxz: 0.0,
        rF: 0.1,
        mF: 0.0,
        IFxx: 0.0,
        IFyy: 0.0,
    };
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> WhippleMechanism<T> {
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
impl<T: ::carvallo::Scalar> WhippleMechanism<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: ::carvallo::Scalar>(&self) -> WhippleMechanism<U> {
        WhippleMechanism {
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
/// The coefficient matrices of [`WhippleMechanism`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleMechanismMatrices<T = ::core::primitive::f64> {
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
impl<T: ::carvallo::Number> WhippleMechanism<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 46 additions, 53 multiplications, 3 divisions, 3 negations and 2 trigonometric functions: 107 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleMechanismMatrices<T> {
        let Jxx_delta = ((self.IHxx + self.IFxx) + (self.mH * (self.zH * self.zH)))
            + (self.mF * (self.rF * self.rF));
        let t26 = (((self.IRxx + self.IBxx) + Jxx_delta)
            + (self.mR * (self.rR * self.rR))) + (self.mB * (self.zB * self.zB));
        let (t28, t42) = ::carvallo::Number::sin_cos(self.lam);
        let t32 = self.rF * self.mF;
        let t37 = self.w + self.c;
        let t38 = self.xH - t37;
        let t39 = self.mH * t38;
        let Jxz_delta = (self.IHxz - (self.c * t32)) - (self.zH * t39);
        let hx_delta = (Jxx_delta * t28) + (Jxz_delta * t42);
        let yaw_per_v_delta = t42 / self.w;
        let mu = self.c * yaw_per_v_delta;
        let t50 = self.zB * self.mB;
        let Sz_delta = (self.zH * self.mH) - t32;
        let Jxz_all = ((self.IBxz + Jxz_delta) - (self.xB * t50)) - (Sz_delta * t37);
        let t58 = hx_delta + (mu * Jxz_all);
        let Jzz_delta = ((self.IHzz + self.IFxx) + (self.mH * (t38 * t38)))
            + (self.mF * (self.c * self.c));
        let hz_delta = (Jxz_delta * t28) + (Jzz_delta * t42);
        let Sx_delta = t39 - (self.c * self.mF);
        let py_delta = (Sx_delta * t42) - (Sz_delta * t28);
        let M_yaw_delta = hz_delta + (py_delta * t37);
        let mA = self.mH + self.mF;
        let t84 = mA * t37;
        let t92 = mu
            * ((((self.IRxx + self.IBzz) + Jzz_delta)
                + ((::carvallo::Number::like(self.w, 2.0) * t37)
                    * (Sx_delta + (::carvallo::Number::like(self.w, 0.5) * t84))))
                + (self.mB * (self.xB * self.xB)));
        let P_delta_yaw = M_yaw_delta + t92;
        let t99 = ((mu * (M_yaw_delta + P_delta_yaw)) + (hx_delta * t28))
            + (hz_delta * t42);
        let SF = self.IFyy / self.rF;
        let ST = SF + (self.IRyy / self.rR);
        let Sz_all = (Sz_delta + t50) - (self.rR * self.mR);
        let t109 = ST - Sz_all;
        let t113 = SF * t42;
        let t114 = ((mu * t109) + (yaw_per_v_delta * Jxz_all)) + t113;
        let Sx_all = (Sx_delta + (self.xB * self.mB)) + t84;
        let P_delta_lateral = py_delta + (mu * Sx_all);
        let t124 = (mu * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
        let t126 = yaw_per_v_delta * t109;
        let t129 = yaw_per_v_delta * (P_delta_lateral + (SF * t28));
        let t130 = -(t113 + (mu * ST));
        let t131 = -P_delta_lateral;
        let t132 = -(t28 * P_delta_lateral);
        WhippleMechanismMatrices {
            m: [[t26, t58], [t58, t99]],
            c1: [[::carvallo::Number::like(self.w, 0.0), t114], [t130, t124]],
            k0: [[Sz_all, t131], [t131, t132]],
            k2: [
                [::carvallo::Number::like(self.w, 0.0), t126],
                [::carvallo::Number::like(self.w, 0.0), t129],
            ],
        }
    }
}
/// Rates and forces of [`WhippleMechanism`] that follow from its coordinates q = (`phi`, `delta`), to first order and in SI units.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleMechanismKinematics<T = ::core::primitive::f64> {
    /// Lateral velocity, to the right, in m/s: of the point of `B` that is at the origin.
    pub lateral: ::carvallo::Rate<T, 2>,
    /// Yaw rate, to the right, in rad/s: of `B`.
    pub yaw: ::carvallo::Rate<T, 2>,
    /// Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_R: ::carvallo::Rate<T, 2>,
    /// Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_F: ::carvallo::Rate<T, 2>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of `Tphi` (lean torque) in N*m, `Tdelta` (steer torque) in N*m.
    pub forces: [[T; 2]; 2],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> WhippleMechanism<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> WhippleMechanismKinematics<T> {
        let yaw_per_v_delta = (::carvallo::Number::cos(self.lam)) / self.w;
        let mu = self.c * yaw_per_v_delta;
        let t12 = -(::carvallo::Number::like(self.w, 1.0) / self.rR);
        let t13 = -(::carvallo::Number::like(self.w, 1.0) / self.rF);
        WhippleMechanismKinematics {
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
                rates: [::carvallo::Number::like(self.w, 0.0), mu],
                coordinates: [::carvallo::Number::like(self.w, 0.0), yaw_per_v_delta],
                heading: ::carvallo::Number::like(self.w, 0.0),
            },
            wheel_R: ::carvallo::Rate {
                speed: t12,
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
impl<T: ::carvallo::Scalar> ::carvallo::Model<2> for WhippleMechanism<T> {
    type Scalar = T;
    type Array<U: ::core::marker::Copy> = [U; 26];
    type Over<U: ::carvallo::Number> = WhippleMechanism<U>;
    const INFO: &'static ::carvallo::ModelInfo = &::carvallo::ModelInfo {
        name: "WhippleMechanism",
        docs: "The Whipple-Carvallo bicycle, derived from its bodies, joints and wheels.\n\nFour rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally\nsymmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,\nx forward, y to the right, z down, so that a centre of mass above the ground has z < 0.\n\nThe declaration asserts that the matrices are those of Appendix A of the paper, which is proved when it is compiled.\n[`Whipple`](crate::Whipple) computes them from these formulas.",
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
                docs: "Trail: positive when the front contact is behind the point where the steer axis meets the ground.",
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
                docs: "Steer axis tilt: 90 degrees minus the head angle.",
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
                name: "mR",
                symbol: "mR",
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
                name: "IRxx",
                symbol: "IRxx",
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
                name: "IRyy",
                symbol: "IRyy",
                docs: "Axial moment of inertia of the rear wheel.",
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
                docs: "Centre of mass of the rear frame and rider, forward of the rear contact.",
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
                docs: "Centre of mass of the rear frame and rider, downward.",
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
                docs: "Mass of the rear frame and rider.",
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
                docs: "Moment of inertia of the rear frame and rider about its centre of mass, in roll.",
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
                docs: "Moment of inertia of the rear frame and rider about its centre of mass, in pitch.",
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
                docs: "Moment of inertia of the rear frame and rider about its centre of mass, in yaw.",
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
                docs: "Product of inertia of the rear frame and rider about its centre of mass.",
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
                docs: "Centre of mass of the front frame, forward of the rear contact.",
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
                docs: "Centre of mass of the front frame, downward.",
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
                docs: "Mass of the front frame.",
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
                docs: "Moment of inertia of the front frame about its centre of mass, in roll.",
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
                docs: "Moment of inertia of the front frame about its centre of mass, in pitch.",
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
                docs: "Moment of inertia of the front frame about its centre of mass, in yaw.",
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
                docs: "Product of inertia of the front frame about its centre of mass.",
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
                name: "mF",
                symbol: "mF",
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
                name: "IFxx",
                symbol: "IFxx",
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
                name: "IFyy",
                symbol: "IFyy",
                docs: "Axial moment of inertia of the front wheel.",
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
                docs: "Lean of the rear frame, positive to the right.",
                unit: "rad",
            },
            ::carvallo::CoordinateInfo {
                name: "delta",
                label: "steer",
                docs: "Steer of the front frame relative to the rear frame, positive to the right.",
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
                name: "benchmark",
                docs: "",
                source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1",
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
            ::carvallo::SetInfo {
                name: "benchmark_2005",
                docs: "",
                source: "Schwab, Meijaard & Papadopoulos (2005), ENOC 2005",
                values: &[
                    1.02,
                    0.08,
                    0.3217505543966422,
                    9.81,
                    0.3,
                    2.0,
                    0.06,
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
                    0.0546,
                    0.06,
                    0.0114,
                    -0.0162,
                    0.35,
                    3.0,
                    0.14,
                    0.28,
                ],
            },
            ::carvallo::SetInfo {
                name: "two_mass_skate",
                docs: "A bicycle that balances itself without gyroscopic effects and without trail: two points of mass on skates.",
                source: "Kooijman, Meijaard, Papadopoulos, Ruina & Schwab (2011), Science 332, 339-342",
                values: &[
                    1.0,
                    0.0,
                    0.08726646259971647,
                    9.81,
                    0.1,
                    0.0,
                    0.0,
                    0.0,
                    1.2,
                    -0.4,
                    10.0,
                    0.0,
                    0.0,
                    0.0,
                    0.0,
                    1.02,
                    -0.2,
                    1.0,
                    0.0,
                    0.0,
                    0.0,
                    0.0,
                    0.1,
                    0.0,
                    0.0,
                    0.0,
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
                model: "WhippleMechanism",
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
                model: "WhippleMechanism",
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
impl<T: ::carvallo::Number> ::carvallo::Evaluator<T, 2> for WhippleMechanism<T> {
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
/// The derivatives of the matrices of [`WhippleMechanism`] with respect to its parameters, in SI units: those that are not zero for all parameters.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleMechanismDerivatives<T = ::core::primitive::f64> {
    /// The value of each derivative in [`Self::PARTIALS`].
    pub values: [T; 158],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl WhippleMechanismDerivatives {
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
impl<T: ::carvallo::Scalar> WhippleMechanismDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(
        &self,
        parameter: ::core::primitive::usize,
    ) -> ::core::option::Option<WhippleMechanismMatrices<T>> {
        if parameter >= 26 {
            return ::core::option::Option::None;
        }
        let zero = <T as ::carvallo::Scalar>::from_f64(0.0);
        let mut matrices = WhippleMechanismMatrices {
            m: [[zero; 2]; 2],
            c1: [[zero; 2]; 2],
            k0: [[zero; 2]; 2],
            k2: [[zero; 2]; 2],
        };
        for position in 0..158 {
            let partial = <WhippleMechanismDerivatives>::PARTIALS[position];
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
impl<T: ::carvallo::Number> WhippleMechanism<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 151 additions, 261 multiplications, 3 divisions, 48 negations and 2 trigonometric functions: 465 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(
        &self,
    ) -> (WhippleMechanismMatrices<T>, WhippleMechanismDerivatives<T>) {
        let Jxx_delta_mH = self.zH * self.zH;
        let Jxx_delta_mF = self.rF * self.rF;
        let Jxx_delta = ((self.IHxx + self.IFxx) + (self.mH * Jxx_delta_mH))
            + (self.mF * Jxx_delta_mF);
        let t19 = self.rR * self.rR;
        let t24 = self.zB * self.zB;
        let t26 = (((self.IRxx + self.IBxx) + Jxx_delta) + (self.mR * t19))
            + (self.mB * t24);
        let (t28, t43) = ::carvallo::Number::sin_cos(self.lam);
        let t32 = self.rF * self.mF;
        let t38 = self.w + self.c;
        let t39 = self.xH - t38;
        let t40 = self.mH * t39;
        let Jxz_delta = (self.IHxz - (self.c * t32)) - (t40 * self.zH);
        let t44 = Jxz_delta * t43;
        let hx_delta = (Jxx_delta * t28) + t44;
        let t46 = ::carvallo::Number::like(self.w, 1.0) / self.w;
        let yaw_per_v_delta = t43 * t46;
        let mu = self.c * yaw_per_v_delta;
        let t52 = self.zB * self.mB;
        let Sz_delta = (self.zH * self.mH) - t32;
        let Jxz_all = ((self.IBxz + Jxz_delta) - (self.xB * t52)) - (t38 * Sz_delta);
        let t60 = hx_delta + (mu * Jxz_all);
        let t62 = t28 * Jxz_delta;
        let Jzz_delta_mH = t39 * t39;
        let Jzz_delta_mF = self.c * self.c;
        let Jzz_delta = ((self.IHzz + self.IFxx) + (self.mH * Jzz_delta_mH))
            + (self.mF * Jzz_delta_mF);
        let hz_delta = t62 + (t43 * Jzz_delta);
        let Sx_delta = t40 - (self.c * self.mF);
        let py_delta = (t43 * Sx_delta) - (Sz_delta * t28);
        let M_yaw_delta = hz_delta + (t38 * py_delta);
        let mA = self.mH + self.mF;
        let t88 = t38 * mA;
        let t91 = Sx_delta + (t88 * ::carvallo::Number::like(self.w, 0.5));
        let t94 = self.xB * self.xB;
        let P_delta_yaw_mu = (((self.IRxx + self.IBzz) + Jzz_delta)
            + ((t38 * ::carvallo::Number::like(self.w, 2.0)) * t91)) + (self.mB * t94);
        let t97 = mu * P_delta_yaw_mu;
        let P_delta_yaw = M_yaw_delta + t97;
        let t99 = M_yaw_delta + P_delta_yaw;
        let t101 = ((t28 * hx_delta) + (t43 * hz_delta)) + (mu * t99);
        let t104 = ::carvallo::Number::like(self.w, 1.0) / self.rF;
        let SF = self.IFyy * t104;
        let t106 = t43 * SF;
        let t108 = ::carvallo::Number::like(self.w, 1.0) / self.rR;
        let ST = SF + (self.IRyy * t108);
        let t112 = self.rR * self.mR;
        let Sz_all = (t52 + Sz_delta) - t112;
        let t114 = ST - Sz_all;
        let t117 = yaw_per_v_delta * Jxz_all;
        let t118 = (t106 + (mu * t114)) + t117;
        let t123 = self.xB * self.mB;
        let Sx_all = (Sx_delta + t88) + t123;
        let P_delta_lateral = py_delta + (mu * Sx_all);
        let t128 = (yaw_per_v_delta * P_delta_yaw) + (mu * P_delta_lateral);
        let t130 = yaw_per_v_delta * t114;
        let t131 = t28 * SF;
        let K222_yaw_per_v_delta = P_delta_lateral + t131;
        let t133 = yaw_per_v_delta * K222_yaw_per_v_delta;
        let M12_Jxz_delta = t43 + mu;
        let t135 = M12_Jxz_delta * self.zH;
        let t136 = self.mH * t135;
        let t138 = (mu * Sz_delta) - t136;
        let t140 = t43 * (t46 * t46);
        let M12_yaw_per_v_delta = self.c * Jxz_all;
        let t144 = mu * ::carvallo::Number::like(self.w, 2.0);
        let P_delta_yaw_Sx_delta = t38 * t144;
        let M22_Sx_delta = (t43 * P_delta_yaw_Sx_delta) + (mu * P_delta_yaw_Sx_delta);
        let M22_hz_delta = t43 + t144;
        let M22_Jxz_delta = t28 * (t43 + M22_hz_delta);
        let t153 = M22_Sx_delta - (M22_Jxz_delta * self.zH);
        let t155 = self.mH * ::carvallo::Number::like(self.w, 2.0);
        let t156 = t39 * t155;
        let t158 = mu * mu;
        let M22_Jzz_delta = (t43 * M22_hz_delta) + t158;
        let t161 = (self.mH * t153) + (t156 * M22_Jzz_delta);
        let P_delta_lateral_mA = t38 * mu;
        let t165 = (t91 * t144) + (mA * P_delta_lateral_mA);
        let t169 = (mu * (t165 + (py_delta * ::carvallo::Number::like(self.w, 2.0))))
            - t161;
        let M22_mu = t97 + t99;
        let M22_yaw_per_v_delta = self.c * M22_mu;
        let t173 = t169 - (t140 * M22_yaw_per_v_delta);
        let t174 = self.zH * yaw_per_v_delta;
        let t175 = self.mH * t174;
        let t177 = (yaw_per_v_delta * Sz_delta) - t175;
        let C112_yaw_per_v_delta = Jxz_all + (self.c * t114);
        let t182 = ST * self.c;
        let t183 = t140 * t182;
        let C122_py_delta = t38 * yaw_per_v_delta;
        let C122_Sx_delta = (t43 * C122_py_delta)
            + (yaw_per_v_delta * P_delta_yaw_Sx_delta);
        let C122_Jxz_delta = t28 * yaw_per_v_delta;
        let t190 = C122_Sx_delta - (C122_Jxz_delta * self.zH);
        let C122_Jzz_delta = yaw_per_v_delta * M12_Jxz_delta;
        let t194 = (self.mH * t190) + (t156 * C122_Jzz_delta);
        let t197 = (yaw_per_v_delta * (py_delta + t165)) - t194;
        let t199 = self.mH * M12_Jxz_delta;
        let t200 = (mu * mA) - t199;
        let P_delta_lateral_yaw_per_v_delta = self.c * Sx_all;
        let t202 = t140 * P_delta_lateral_yaw_per_v_delta;
        let P_delta_lateral_w = t200 - t202;
        let C122_mu = P_delta_lateral + (yaw_per_v_delta * P_delta_yaw_mu);
        let C122_yaw_per_v_delta = P_delta_yaw + (self.c * C122_mu);
        let t211 = (t197 + (mu * P_delta_lateral_w)) - (t140 * C122_yaw_per_v_delta);
        let t216 = (yaw_per_v_delta * P_delta_lateral_w) - (t140 * K222_yaw_per_v_delta);
        let t219 = (t117 - t138) - (M12_Jxz_delta * t32);
        let t226 = self.mF * ::carvallo::Number::like(self.w, 2.0);
        let Jzz_delta_c = self.c * t226;
        let t229 = (((t169 - (M22_Sx_delta * self.mF)) - (M22_Jxz_delta * t32))
            + (yaw_per_v_delta * M22_mu)) + (Jzz_delta_c * M22_Jzz_delta);
        let t232 = (yaw_per_v_delta * (t114 - t32)) - t177;
        let P_delta_lateral_c = (t200 - (M12_Jxz_delta * self.mF))
            + (yaw_per_v_delta * Sx_all);
        let t247 = ((((t197 - (C122_Sx_delta * self.mF)) - (C122_Jxz_delta * t32))
            + (yaw_per_v_delta * C122_mu)) + (mu * P_delta_lateral_c))
            + (Jzz_delta_c * C122_Jzz_delta);
        let t249 = yaw_per_v_delta * P_delta_lateral_c;
        let hx_delta_lam = (Jxx_delta * t43) - t62;
        let t252 = t46 * t28;
        let t254 = hx_delta_lam - (t252 * M12_yaw_per_v_delta);
        let t262 = (t43 * Sz_delta) + (Sx_delta * t28);
        let hz_delta_lam = t44 - (Jzz_delta * t28);
        let t270 = (((((t28 * hx_delta_lam) + (hx_delta * t43)) - (hz_delta * t28))
            - (t262 * P_delta_yaw_Sx_delta)) + (hz_delta_lam * M22_hz_delta))
            - (t252 * M22_yaw_per_v_delta);
        let t274 = t131 + (t252 * t182);
        let t277 = t262 + (t252 * P_delta_lateral_yaw_per_v_delta);
        let t283 = (((yaw_per_v_delta * hz_delta_lam) - (mu * t277))
            - (t262 * C122_py_delta)) - (t252 * C122_yaw_per_v_delta);
        let t290 = (yaw_per_v_delta * (t106 - t277)) - (t252 * K222_yaw_per_v_delta);
        let t291 = t112 * ::carvallo::Number::like(self.w, 2.0);
        let t293 = self.IRyy * (t108 * t108);
        let t294 = self.mR - t293;
        let t295 = mu * t294;
        let t296 = t293 * mu;
        let t297 = yaw_per_v_delta * t294;
        let t298 = self.rR * mu;
        let t299 = self.rR * yaw_per_v_delta;
        let t300 = yaw_per_v_delta * mu;
        let t301 = mu * t108;
        let t302 = yaw_per_v_delta * t108;
        let P_delta_yaw_xB = t123 * t144;
        let t305 = mu * P_delta_yaw_xB;
        let P_delta_lateral_xB = self.mB * mu;
        let t310 = (yaw_per_v_delta * P_delta_yaw_xB) + (mu * P_delta_lateral_xB);
        let t312 = yaw_per_v_delta * P_delta_lateral_xB;
        let t313 = ::carvallo::Number::like(self.w, 2.0) * t52;
        let P_delta_lateral_mB = self.xB * mu;
        let t317 = mu + (self.xB * yaw_per_v_delta);
        let P_delta_yaw_mB = mu * t94;
        let t322 = mu * P_delta_yaw_mB;
        let t326 = (yaw_per_v_delta * P_delta_yaw_mB) + (mu * P_delta_lateral_mB);
        let t329 = yaw_per_v_delta * P_delta_lateral_mB;
        let t331 = t194 + (mu * t199);
        let t333 = yaw_per_v_delta * t199;
        let Jxx_delta_zH = self.zH * t155;
        let t339 = (t28 * Jxx_delta_zH)
            - ((M12_Jxz_delta * t40) + (self.mH * P_delta_lateral_mA));
        let t341 = P_delta_yaw_Sx_delta * t28;
        let M22_Jxx_delta = t28 * t28;
        let t346 = (Jxx_delta_zH * M22_Jxx_delta)
            - ((M22_Jxz_delta * t40) + (self.mH * t341));
        let t348 = mu + C122_py_delta;
        let t352 = C122_py_delta * t28;
        let t355 = self.mH * t28;
        let t358 = t355 * t28;
        let t365 = ((t28 * Jxx_delta_mH) - (self.zH * P_delta_lateral_mA))
            - (t39 * t135);
        let P_delta_yaw_mA = t38 * P_delta_lateral_mA;
        let M22_mA = mu * P_delta_yaw_mA;
        let t375 = (((M22_mA - (self.zH * t341)) + (t39 * t153))
            + (Jxx_delta_mH * M22_Jxx_delta)) + (Jzz_delta_mH * M22_Jzz_delta);
        let C122_mA = yaw_per_v_delta * P_delta_yaw_mA;
        let P_delta_lateral_mH = (P_delta_lateral_mA - (self.zH * t28))
            + (t39 * M12_Jxz_delta);
        let t391 = (((C122_mA - (self.zH * t352)) + (t39 * t190))
            + (mu * P_delta_lateral_mH)) + (Jzz_delta_mH * C122_Jzz_delta);
        let t393 = yaw_per_v_delta * P_delta_lateral_mH;
        let Jxx_delta_rF = self.rF * t226;
        let t395 = t28 * Jxx_delta_rF;
        let t396 = Jxx_delta_rF * M22_Jxx_delta;
        let t397 = mu - t348;
        let t400 = self.IFyy * (t104 * t104);
        let t401 = t400 * M12_Jxz_delta;
        let t404 = (self.c * C122_Jxz_delta) - t352;
        let P_delta_lateral_rF = self.mF * t28;
        let t408 = (mu * P_delta_lateral_rF) - (self.mF * t404);
        let t411 = yaw_per_v_delta * (self.mF - t400);
        let t414 = (yaw_per_v_delta * P_delta_lateral_rF) - (t400 * C122_Jxz_delta);
        let t415 = t28 * Jxx_delta_mF;
        let t421 = ((M22_mA - (M22_Sx_delta * self.c)) + (Jxx_delta_mF * M22_Jxx_delta))
            + (Jzz_delta_mF * M22_Jzz_delta);
        let P_delta_lateral_mF = (P_delta_lateral_mA - (M12_Jxz_delta * self.c))
            + (self.rF * t28);
        let t434 = (((C122_mA - (C122_Sx_delta * self.c)) - (self.rF * t404))
            + (mu * P_delta_lateral_mF)) + (Jzz_delta_mF * C122_Jzz_delta);
        let t436 = self.rF * yaw_per_v_delta;
        let t437 = yaw_per_v_delta * P_delta_lateral_mF;
        let t438 = M22_Jxx_delta + M22_Jzz_delta;
        let t439 = t104 * M12_Jxz_delta;
        let t440 = yaw_per_v_delta * t104;
        let t441 = t104 * C122_Jxz_delta;
        let t442 = -(t106 + (mu * ST));
        let t443 = -P_delta_lateral;
        let t444 = -(P_delta_lateral * t28);
        let t445 = -(t138 + (t140 * M12_yaw_per_v_delta));
        let t446 = -(t177 + (t140 * C112_yaw_per_v_delta));
        let t447 = t202 - t200;
        let t448 = -(P_delta_lateral_w * t28);
        let t449 = -(t114 * t140);
        let t450 = -(ST * yaw_per_v_delta);
        let t451 = -P_delta_lateral_c;
        let t452 = -(P_delta_lateral_c * t28);
        let t453 = -(t131 + (t252 * C112_yaw_per_v_delta));
        let t454 = (t28 * t277) - (P_delta_lateral * t43);
        let t455 = -(t114 * t252);
        let t456 = -self.mR;
        let t457 = -self.rR;
        let t458 = -t301;
        let t459 = -(t52 * mu);
        let t460 = -(t52 * yaw_per_v_delta);
        let t461 = -P_delta_lateral_xB;
        let t462 = -(P_delta_lateral_xB * t28);
        let t463 = -(self.mB * P_delta_lateral_mB);
        let t464 = -(self.mB * t317);
        let t465 = -(self.mB * yaw_per_v_delta);
        let t466 = -(self.zB * P_delta_lateral_mB);
        let t467 = -(self.zB * t317);
        let t468 = -P_delta_lateral_mB;
        let t469 = -(P_delta_lateral_mB * t28);
        let t470 = -(self.zB * yaw_per_v_delta);
        let t471 = -t136;
        let t472 = -t175;
        let t473 = -t199;
        let t474 = -(t199 * t28);
        let t475 = -((t40 * yaw_per_v_delta) + (self.mH * t348));
        let t476 = -(((C122_Jxz_delta * t40) + (self.mH * t352)) + (mu * t355));
        let t477 = -(self.mH * yaw_per_v_delta);
        let t478 = -(yaw_per_v_delta * t355);
        let t479 = -((self.zH * t348) + (t39 * t174));
        let t480 = -P_delta_lateral_mH;
        let t481 = -(P_delta_lateral_mH * t28);
        let t482 = -t174;
        let t483 = -((self.mF * t397) + t401);
        let t484 = -self.mF;
        let t485 = -P_delta_lateral_rF;
        let t486 = -(t28 * P_delta_lateral_rF);
        let t487 = -(self.rF * t397);
        let t488 = -self.rF;
        let t489 = -P_delta_lateral_mF;
        let t490 = -(t28 * P_delta_lateral_mF);
        let t491 = -t439;
        (
            WhippleMechanismMatrices {
                m: [[t26, t60], [t60, t101]],
                c1: [[::carvallo::Number::like(self.w, 0.0), t118], [t442, t128]],
                k0: [[Sz_all, t443], [t443, t444]],
                k2: [
                    [::carvallo::Number::like(self.w, 0.0), t130],
                    [::carvallo::Number::like(self.w, 0.0), t133],
                ],
            },
            WhippleMechanismDerivatives {
                values: [
                    t445,
                    t445,
                    t173,
                    t446,
                    t183,
                    t211,
                    t447,
                    t447,
                    t448,
                    t449,
                    t216,
                    t219,
                    t219,
                    t229,
                    t232,
                    t450,
                    t247,
                    t451,
                    t451,
                    t452,
                    t249,
                    t254,
                    t254,
                    t270,
                    t453,
                    t274,
                    t283,
                    t277,
                    t277,
                    t454,
                    t455,
                    t290,
                    t291,
                    t295,
                    t296,
                    t456,
                    t297,
                    t19,
                    t298,
                    t457,
                    t299,
                    ::carvallo::Number::like(self.w, 1.0),
                    t158,
                    t300,
                    t301,
                    t458,
                    t302,
                    t459,
                    t459,
                    t305,
                    t460,
                    t310,
                    t461,
                    t461,
                    t462,
                    t312,
                    t313,
                    t463,
                    t463,
                    t464,
                    self.mB,
                    t465,
                    t24,
                    t466,
                    t466,
                    t322,
                    t467,
                    t326,
                    self.zB,
                    t468,
                    t468,
                    t469,
                    t470,
                    t329,
                    ::carvallo::Number::like(self.w, 1.0),
                    t158,
                    t300,
                    mu,
                    mu,
                    yaw_per_v_delta,
                    t471,
                    t471,
                    t161,
                    t472,
                    t331,
                    t473,
                    t473,
                    t474,
                    t333,
                    Jxx_delta_zH,
                    t339,
                    t339,
                    t346,
                    t475,
                    t476,
                    self.mH,
                    t355,
                    t355,
                    t358,
                    t477,
                    t478,
                    Jxx_delta_mH,
                    t365,
                    t365,
                    t375,
                    t479,
                    t391,
                    self.zH,
                    t480,
                    t480,
                    t481,
                    t482,
                    t393,
                    ::carvallo::Number::like(self.w, 1.0),
                    t28,
                    t28,
                    M22_Jxx_delta,
                    M22_Jzz_delta,
                    C122_Jzz_delta,
                    M12_Jxz_delta,
                    M12_Jxz_delta,
                    M22_Jxz_delta,
                    yaw_per_v_delta,
                    C122_Jxz_delta,
                    Jxx_delta_rF,
                    t395,
                    t395,
                    t396,
                    t483,
                    t401,
                    t408,
                    t484,
                    t485,
                    t485,
                    t486,
                    t411,
                    t414,
                    Jxx_delta_mF,
                    t415,
                    t415,
                    t421,
                    t487,
                    t434,
                    t488,
                    t489,
                    t489,
                    t490,
                    t436,
                    t437,
                    ::carvallo::Number::like(self.w, 1.0),
                    t28,
                    t28,
                    t438,
                    C122_Jzz_delta,
                    t439,
                    t491,
                    t440,
                    t441,
                ],
            },
        )
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Differentiable<2> for WhippleMechanism<T> {
    type Derivatives = [::carvallo::Coefficients<T, 2>; 26];
    fn coefficients_and_derivatives(
        &self,
    ) -> (::carvallo::Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let mut all = [::carvallo::Coefficients::from_rows(
            [[[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2]; 6],
        ); 26];
        for position in 0..158 {
            <WhippleMechanismDerivatives>::PARTIALS[position]
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
