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
impl<T: ::carvallo::Scalar> WhippleMechanism<T> {
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
impl<T: ::carvallo::Scalar> WhippleMechanism<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 46 additions, 53 multiplications, 3 divisions, 3 negations and 2 trigonometric functions: 107 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn matrices(&self) -> WhippleMechanismMatrices<T> {
        let Jxx_delta = ((self.IHxx + self.IFxx) + (self.mH * (self.zH * self.zH)))
            + (self.mF * (self.rF * self.rF));
        let t26 = (((self.IRxx + self.IBxx) + Jxx_delta)
            + (self.mR * (self.rR * self.rR))) + (self.mB * (self.zB * self.zB));
        let (t28, t42) = ::carvallo::Scalar::sin_cos(self.lam);
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
                + ((<T as ::carvallo::Scalar>::from_f64(2.0) * t37)
                    * (Sx_delta + (<T as ::carvallo::Scalar>::from_f64(0.5) * t84))))
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
            c1: [[<T as ::carvallo::Scalar>::from_f64(0.0), t114], [t130, t124]],
            k0: [[Sz_all, t131], [t131, t132]],
            k2: [
                [<T as ::carvallo::Scalar>::from_f64(0.0), t126],
                [<T as ::carvallo::Scalar>::from_f64(0.0), t129],
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
        let yaw_per_v_delta = (::carvallo::Scalar::cos(self.lam)) / self.w;
        let mu = self.c * yaw_per_v_delta;
        let t12 = -(<T as ::carvallo::Scalar>::from_f64(1.0) / self.rR);
        let t13 = -(<T as ::carvallo::Scalar>::from_f64(1.0) / self.rF);
        WhippleMechanismKinematics {
            lateral: ::carvallo::Rate {
                speed: <T as ::carvallo::Scalar>::from_f64(0.0),
                rates: [
                    <T as ::carvallo::Scalar>::from_f64(0.0),
                    <T as ::carvallo::Scalar>::from_f64(0.0),
                ],
                coordinates: [
                    <T as ::carvallo::Scalar>::from_f64(0.0),
                    <T as ::carvallo::Scalar>::from_f64(0.0),
                ],
                heading: <T as ::carvallo::Scalar>::from_f64(1.0),
            },
            yaw: ::carvallo::Rate {
                speed: <T as ::carvallo::Scalar>::from_f64(0.0),
                rates: [<T as ::carvallo::Scalar>::from_f64(0.0), mu],
                coordinates: [<T as ::carvallo::Scalar>::from_f64(0.0), yaw_per_v_delta],
                heading: <T as ::carvallo::Scalar>::from_f64(0.0),
            },
            wheel_R: ::carvallo::Rate {
                speed: t12,
                rates: [
                    <T as ::carvallo::Scalar>::from_f64(0.0),
                    <T as ::carvallo::Scalar>::from_f64(0.0),
                ],
                coordinates: [
                    <T as ::carvallo::Scalar>::from_f64(0.0),
                    <T as ::carvallo::Scalar>::from_f64(0.0),
                ],
                heading: <T as ::carvallo::Scalar>::from_f64(0.0),
            },
            wheel_F: ::carvallo::Rate {
                speed: t13,
                rates: [
                    <T as ::carvallo::Scalar>::from_f64(0.0),
                    <T as ::carvallo::Scalar>::from_f64(0.0),
                ],
                coordinates: [
                    <T as ::carvallo::Scalar>::from_f64(0.0),
                    <T as ::carvallo::Scalar>::from_f64(0.0),
                ],
                heading: <T as ::carvallo::Scalar>::from_f64(0.0),
            },
            forces: [
                [
                    <T as ::carvallo::Scalar>::from_f64(1.0),
                    <T as ::carvallo::Scalar>::from_f64(0.0),
                ],
                [
                    <T as ::carvallo::Scalar>::from_f64(0.0),
                    <T as ::carvallo::Scalar>::from_f64(1.0),
                ],
            ],
        }
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Model<2> for WhippleMechanism<T> {
    type Scalar = T;
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
impl<T: ::carvallo::Scalar> WhippleMechanism<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 182 additions, 276 multiplications, 6 divisions, 42 negations and 2 trigonometric functions: 508 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline]
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
        let t29 = self.rF * self.mF;
        let t35 = self.w + self.c;
        let t36 = self.xH - t35;
        let t37 = self.mH * t36;
        let Jxz_delta = (self.IHxz - (self.c * t29)) - (self.zH * t37);
        let (t43, t41) = ::carvallo::Scalar::sin_cos(self.lam);
        let t44 = Jxx_delta * t43;
        let hx_delta = (Jxz_delta * t41) + t44;
        let t46 = <T as ::carvallo::Scalar>::from_f64(1.0) / self.w;
        let yaw_per_v_delta = t41 * t46;
        let mu = self.c * yaw_per_v_delta;
        let t52 = self.zB * self.mB;
        let Sz_delta = (self.zH * self.mH) - t29;
        let Jxz_all = ((self.IBxz + Jxz_delta) - (self.xB * t52)) - (t35 * Sz_delta);
        let t60 = hx_delta + (mu * Jxz_all);
        let Jzz_delta_mH = t36 * t36;
        let Jzz_delta_mF = self.c * self.c;
        let Jzz_delta = ((self.IHzz + self.IFxx) + (self.mH * Jzz_delta_mH))
            + (self.mF * Jzz_delta_mF);
        let t71 = t43 * Jxz_delta;
        let hz_delta = (t41 * Jzz_delta) + t71;
        let t75 = Sz_delta * t43;
        let Sx_delta = t37 - (self.c * self.mF);
        let py_delta = (t41 * Sx_delta) - t75;
        let M_yaw_delta = hz_delta + (t35 * py_delta);
        let mA = self.mH + self.mF;
        let t88 = t35 * mA;
        let t94 = self.xB * self.xB;
        let P_delta_yaw_mu = (((self.IRxx + self.IBzz) + Jzz_delta)
            + ((t35 * <T as ::carvallo::Scalar>::from_f64(2.0))
                * (Sx_delta + (t88 * <T as ::carvallo::Scalar>::from_f64(0.5)))))
            + (self.mB * t94);
        let t97 = mu * P_delta_yaw_mu;
        let P_delta_yaw = M_yaw_delta + t97;
        let t99 = M_yaw_delta + P_delta_yaw;
        let t101 = ((t43 * hx_delta) + (t41 * hz_delta)) + (mu * t99);
        let SF_IFyy = <T as ::carvallo::Scalar>::from_f64(1.0) / self.rF;
        let SF = self.IFyy * SF_IFyy;
        let t106 = t41 * SF;
        let ST_IRyy = <T as ::carvallo::Scalar>::from_f64(1.0) / self.rR;
        let ST = SF + (self.IRyy * ST_IRyy);
        let t112 = self.rR * self.mR;
        let Sz_all = (t52 + Sz_delta) - t112;
        let t114 = ST - Sz_all;
        let t117 = yaw_per_v_delta * Jxz_all;
        let t118 = (t106 + (mu * t114)) + t117;
        let t123 = self.xB * self.mB;
        let Sx_all = (Sx_delta + t88) + t123;
        let t125 = mu * Sx_all;
        let P_delta_lateral = py_delta + t125;
        let t128 = (yaw_per_v_delta * P_delta_yaw) + (mu * P_delta_lateral);
        let t130 = yaw_per_v_delta * t114;
        let t132 = P_delta_lateral + (t43 * SF);
        let t133 = yaw_per_v_delta * t132;
        let C112_SF = t41 + mu;
        let t135 = C112_SF * self.zH;
        let t136 = self.mH * t135;
        let t138 = (mu * Sz_delta) - t136;
        let t140 = t41 / (self.w * self.w);
        let M12_yaw_per_v_delta = self.c * Jxz_all;
        let t144 = mu * <T as ::carvallo::Scalar>::from_f64(2.0);
        let P_delta_yaw_Sx_delta = t35 * t144;
        let M22_Sx_delta = (t41 * P_delta_yaw_Sx_delta) + (mu * P_delta_yaw_Sx_delta);
        let M22_hz_delta = t41 + t144;
        let M22_Jxz_delta = t43 * (t41 + M22_hz_delta);
        let t153 = M22_Sx_delta - (M22_Jxz_delta * self.zH);
        let t155 = self.mH * <T as ::carvallo::Scalar>::from_f64(2.0);
        let t156 = t36 * t155;
        let C122_Sx_all = mu * mu;
        let M22_Jzz_delta = C122_Sx_all + (t41 * M22_hz_delta);
        let t161 = (self.mH * t153) + (t156 * M22_Jzz_delta);
        let t164 = mu * (t88 + (Sx_delta * <T as ::carvallo::Scalar>::from_f64(2.0)));
        let t169 = t35 * mu;
        let t170 = mu * t169;
        let t172 = ((mu * (t164 + (py_delta * <T as ::carvallo::Scalar>::from_f64(2.0))))
            - t161) + (mA * t170);
        let M22_mu = t97 + t99;
        let M22_yaw_per_v_delta = self.c * M22_mu;
        let t176 = t172 - (t140 * M22_yaw_per_v_delta);
        let t177 = self.zH * yaw_per_v_delta;
        let t178 = self.mH * t177;
        let t180 = (yaw_per_v_delta * Sz_delta) - t178;
        let C112_yaw_per_v_delta = Jxz_all + (self.c * t114);
        let t185 = ST * self.c;
        let t186 = t140 * t185;
        let C122_py_delta = mu + (t35 * yaw_per_v_delta);
        let C122_Sx_delta = (C122_Sx_all + (t41 * C122_py_delta))
            + (yaw_per_v_delta * P_delta_yaw_Sx_delta);
        let K222_SF = t43 * yaw_per_v_delta;
        let t194 = K222_SF * self.zH;
        let t195 = C122_Sx_delta - t194;
        let C122_Jzz_delta = yaw_per_v_delta * C112_SF;
        let t199 = (self.mH * t195) + (t156 * C122_Jzz_delta);
        let t204 = C122_Sx_all + (yaw_per_v_delta * t169);
        let t206 = ((yaw_per_v_delta * (py_delta + t164)) - t199) + (mA * t204);
        let C122_mu = (P_delta_lateral + t125) + (yaw_per_v_delta * P_delta_yaw_mu);
        let C122_yaw_per_v_delta = P_delta_yaw + (self.c * C122_mu);
        let t213 = t206 - (t140 * C122_yaw_per_v_delta);
        let t214 = self.mH * C112_SF;
        let t216 = (mu * mA) - t214;
        let t217 = Sx_all * self.c;
        let t219 = (t140 * t217) - t216;
        let t220 = mu * t43;
        let t222 = t220 + (t41 * t43);
        let t223 = self.mH * t222;
        let t225 = t223 - (mA * t220);
        let t226 = Sx_all * t43;
        let t227 = self.c * t226;
        let t229 = t225 + (t140 * t227);
        let K222_Sx_all = yaw_per_v_delta * mu;
        let t232 = t41 * yaw_per_v_delta;
        let K222_Sx_delta = K222_Sx_all + t232;
        let t234 = self.mH * K222_Sx_delta;
        let t236 = (mA * K222_Sx_all) - t234;
        let K222_mu = yaw_per_v_delta * Sx_all;
        let K222_yaw_per_v_delta = (self.c * K222_mu) + t132;
        let t241 = t236 - (t140 * K222_yaw_per_v_delta);
        let t244 = (t117 - t138) - (C112_SF * t29);
        let t251 = self.mF * <T as ::carvallo::Scalar>::from_f64(2.0);
        let Jzz_delta_c = self.c * t251;
        let t254 = (((t172 - (M22_Sx_delta * self.mF)) - (M22_Jxz_delta * t29))
            + (yaw_per_v_delta * M22_mu)) + (Jzz_delta_c * M22_Jzz_delta);
        let t257 = (yaw_per_v_delta * (t114 - t29)) - t180;
        let t266 = (((t206 - (C122_Sx_delta * self.mF)) - (K222_SF * t29))
            + (yaw_per_v_delta * C122_mu)) + (Jzz_delta_c * C122_Jzz_delta);
        let t267 = C112_SF * self.mF;
        let t269 = (t267 - t216) - K222_mu;
        let t271 = t267 - (t216 + K222_mu);
        let t275 = (t225 + (t222 * self.mF)) - (yaw_per_v_delta * t226);
        let t279 = (t236 - (K222_Sx_delta * self.mF)) + (yaw_per_v_delta * K222_mu);
        let t284 = (Jxx_delta * t41) - (t43 * (Jxz_delta + (t46 * M12_yaw_per_v_delta)));
        let t299 = (t41
            * (((hx_delta + t44) - (P_delta_yaw_Sx_delta * Sz_delta))
                + (Jxz_delta * M22_hz_delta)))
            - (t43
                * ((((hz_delta + t71) + (Jzz_delta * M22_hz_delta))
                    + (Sx_delta * P_delta_yaw_Sx_delta)) + (t46 * M22_yaw_per_v_delta)));
        let t305 = t43 * (SF + (t46 * t185));
        let t316 = (t41 * ((Jxz_delta * yaw_per_v_delta) - (C122_py_delta * Sz_delta)))
            - (t43
                * (((yaw_per_v_delta * Jzz_delta) + (Sx_delta * C122_py_delta))
                    + (t46 * C122_yaw_per_v_delta)));
        let t321 = (t43 * ((t46 * t217) + Sx_delta)) + (Sz_delta * t41);
        let t328 = (t43 * ((Sx_delta * t43) + (t46 * t227)))
            + (t41 * (t75 - P_delta_lateral));
        let t337 = (t232 * (SF - Sz_delta))
            - (t43 * ((yaw_per_v_delta * Sx_delta) + (t46 * K222_yaw_per_v_delta)));
        let t338 = t112 * <T as ::carvallo::Scalar>::from_f64(2.0);
        let t339 = self.IRyy / t19;
        let t340 = self.mR - t339;
        let t341 = mu * t340;
        let t342 = t339 * mu;
        let t343 = yaw_per_v_delta * t340;
        let t344 = self.rR * mu;
        let t345 = self.rR * yaw_per_v_delta;
        let t346 = mu * ST_IRyy;
        let t347 = yaw_per_v_delta * ST_IRyy;
        let P_delta_yaw_xB = t123 * t144;
        let t350 = mu * P_delta_yaw_xB;
        let t354 = (self.mB * C122_Sx_all) + (yaw_per_v_delta * P_delta_yaw_xB);
        let t357 = self.mB * K222_Sx_all;
        let t358 = <T as ::carvallo::Scalar>::from_f64(2.0) * t52;
        let t359 = self.xB * mu;
        let t362 = mu + (self.xB * yaw_per_v_delta);
        let P_delta_yaw_mB = mu * t94;
        let t367 = mu * P_delta_yaw_mB;
        let t371 = (self.xB * C122_Sx_all) + (yaw_per_v_delta * P_delta_yaw_mB);
        let t374 = self.xB * K222_Sx_all;
        let Jxx_delta_zH = self.zH * t155;
        let t376 = C112_SF * t37;
        let t377 = self.mH * t169;
        let t379 = t43 * Jxx_delta_zH;
        let t380 = t379 - (t376 + t377);
        let t382 = (t379 - t376) - t377;
        let t384 = P_delta_yaw_Sx_delta * t43;
        let K022_Sz_delta = t43 * t43;
        let t389 = (Jxx_delta_zH * K022_Sz_delta)
            - ((M22_Jxz_delta * t37) + (self.mH * t384));
        let t394 = C122_py_delta * t43;
        let t397 = self.mH * t43;
        let t398 = self.mH * K022_Sz_delta;
        let t401 = self.zH * t169;
        let t402 = t36 * t135;
        let t404 = t43 * Jxx_delta_mH;
        let t405 = t404 - (t401 + t402);
        let t407 = (t404 - t401) - t402;
        let M22_mA = t35 * t170;
        let t416 = (((M22_mA - (self.zH * t384)) + (t36 * t153))
            + (Jzz_delta_mH * M22_Jzz_delta)) + (Jxx_delta_mH * K022_Sz_delta);
        let C122_mA = t35 * t204;
        let t426 = ((C122_mA - (self.zH * t394)) + (t36 * t195))
            + (Jzz_delta_mH * C122_Jzz_delta);
        let t427 = t36 * C112_SF;
        let t429 = self.zH * t43;
        let t430 = t429 - (t169 + t427);
        let t432 = (t429 - t169) - t427;
        let t433 = t35 * t220;
        let t437 = ((self.zH * K022_Sz_delta) - t433) - (t36 * t222);
        let K222_mA = t35 * K222_Sx_all;
        let t441 = (K222_mA - t194) + (t36 * K222_Sx_delta);
        let Jxx_delta_rF = self.rF * t251;
        let t443 = t43 * Jxx_delta_rF;
        let t444 = Jxx_delta_rF * K022_Sz_delta;
        let t445 = mu - C122_py_delta;
        let t447 = self.IFyy / Jxx_delta_mF;
        let t448 = t447 * C112_SF;
        let t451 = (self.c * K222_SF) - t394;
        let t456 = yaw_per_v_delta * (self.mF - t447);
        let t459 = (K222_SF * self.mF) - (t447 * K222_SF);
        let t460 = t43 * Jxx_delta_mF;
        let t466 = ((M22_mA - (M22_Sx_delta * self.c)) + (Jzz_delta_mF * M22_Jzz_delta))
            + (Jxx_delta_mF * K022_Sz_delta);
        let t473 = ((C122_mA - (C122_Sx_delta * self.c)) - (self.rF * t451))
            + (Jzz_delta_mF * C122_Jzz_delta);
        let t474 = C112_SF * self.c;
        let t476 = t43 * self.rF;
        let t477 = (t474 - t169) - t476;
        let t479 = t474 - (t169 + t476);
        let t483 = ((t222 * self.c) - t433) - (K022_Sz_delta * self.rF);
        let t484 = self.rF * yaw_per_v_delta;
        let t488 = (K222_mA - (K222_Sx_delta * self.c)) + (K222_SF * self.rF);
        let t489 = M22_Jzz_delta + K022_Sz_delta;
        let t490 = SF_IFyy * C112_SF;
        let t491 = yaw_per_v_delta * SF_IFyy;
        let t492 = SF_IFyy * K222_SF;
        let t493 = -(t106 + (mu * ST));
        let t494 = -P_delta_lateral;
        let t495 = -(P_delta_lateral * t43);
        let t496 = -(t138 + (t140 * M12_yaw_per_v_delta));
        let t497 = -(t180 + (t140 * C112_yaw_per_v_delta));
        let t498 = -(t114 * t140);
        let t499 = -(ST * yaw_per_v_delta);
        let t500 = -(t43 * (SF + (t46 * C112_yaw_per_v_delta)));
        let t501 = -((t114 * t46) * t43);
        let t502 = -self.mR;
        let t503 = -self.rR;
        let t504 = -t346;
        let t505 = -(t52 * mu);
        let t506 = -(t52 * yaw_per_v_delta);
        let t507 = -(self.mB * mu);
        let t508 = -(self.mB * t220);
        let t509 = -(self.mB * t359);
        let t510 = -(self.mB * t362);
        let t511 = -(self.mB * yaw_per_v_delta);
        let t512 = -(self.zB * t359);
        let t513 = -(self.zB * t362);
        let t514 = -t359;
        let t515 = -(self.xB * t220);
        let t516 = -(self.zB * yaw_per_v_delta);
        let t517 = -t136;
        let t518 = -t178;
        let t519 = -t214;
        let t520 = -t223;
        let t521 = -((t37 * yaw_per_v_delta) + (self.mH * C122_py_delta));
        let t522 = -((K222_SF * t37) + (self.mH * t394));
        let t523 = -(self.mH * yaw_per_v_delta);
        let t524 = -(self.mH * K222_SF);
        let t525 = -((self.zH * C122_py_delta) + (t36 * t177));
        let t526 = -t177;
        let t527 = -((self.mF * t445) + t448);
        let t528 = -(self.mF * t451);
        let t529 = -self.mF;
        let t530 = -(t43 * self.mF);
        let t531 = -(K022_Sz_delta * self.mF);
        let t532 = -(self.rF * t445);
        let t533 = -self.rF;
        let t534 = -t490;
        (
            WhippleMechanismMatrices {
                m: [[t26, t60], [t60, t101]],
                c1: [[<T as ::carvallo::Scalar>::from_f64(0.0), t118], [t493, t128]],
                k0: [[Sz_all, t494], [t494, t495]],
                k2: [
                    [<T as ::carvallo::Scalar>::from_f64(0.0), t130],
                    [<T as ::carvallo::Scalar>::from_f64(0.0), t133],
                ],
            },
            WhippleMechanismDerivatives {
                values: [
                    t496,
                    t496,
                    t176,
                    t497,
                    t186,
                    t213,
                    t219,
                    t219,
                    t229,
                    t498,
                    t241,
                    t244,
                    t244,
                    t254,
                    t257,
                    t499,
                    t266,
                    t269,
                    t271,
                    t275,
                    t279,
                    t284,
                    t284,
                    t299,
                    t500,
                    t305,
                    t316,
                    t321,
                    t321,
                    t328,
                    t501,
                    t337,
                    t338,
                    t341,
                    t342,
                    t502,
                    t343,
                    t19,
                    t344,
                    t503,
                    t345,
                    <T as ::carvallo::Scalar>::from_f64(1.0),
                    C122_Sx_all,
                    K222_Sx_all,
                    t346,
                    t504,
                    t347,
                    t505,
                    t505,
                    t350,
                    t506,
                    t354,
                    t507,
                    t507,
                    t508,
                    t357,
                    t358,
                    t509,
                    t509,
                    t510,
                    self.mB,
                    t511,
                    t24,
                    t512,
                    t512,
                    t367,
                    t513,
                    t371,
                    self.zB,
                    t514,
                    t514,
                    t515,
                    t516,
                    t374,
                    <T as ::carvallo::Scalar>::from_f64(1.0),
                    C122_Sx_all,
                    K222_Sx_all,
                    mu,
                    mu,
                    yaw_per_v_delta,
                    t517,
                    t517,
                    t161,
                    t518,
                    t199,
                    t519,
                    t519,
                    t520,
                    t234,
                    Jxx_delta_zH,
                    t380,
                    t382,
                    t389,
                    t521,
                    t522,
                    self.mH,
                    t397,
                    t397,
                    t398,
                    t523,
                    t524,
                    Jxx_delta_mH,
                    t405,
                    t407,
                    t416,
                    t525,
                    t426,
                    self.zH,
                    t430,
                    t432,
                    t437,
                    t526,
                    t441,
                    <T as ::carvallo::Scalar>::from_f64(1.0),
                    t43,
                    t43,
                    K022_Sz_delta,
                    M22_Jzz_delta,
                    C122_Jzz_delta,
                    C112_SF,
                    C112_SF,
                    M22_Jxz_delta,
                    yaw_per_v_delta,
                    K222_SF,
                    Jxx_delta_rF,
                    t443,
                    t443,
                    t444,
                    t527,
                    t448,
                    t528,
                    t529,
                    t530,
                    t530,
                    t531,
                    t456,
                    t459,
                    Jxx_delta_mF,
                    t460,
                    t460,
                    t466,
                    t532,
                    t473,
                    t533,
                    t477,
                    t479,
                    t483,
                    t484,
                    t488,
                    <T as ::carvallo::Scalar>::from_f64(1.0),
                    t43,
                    t43,
                    t489,
                    C122_Jzz_delta,
                    t490,
                    t534,
                    t491,
                    t492,
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
