// @generated from generated/models/whipple_leaning.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 40e1047ae9981d57

/// The Whipple-Carvallo bicycle with a rider whose upper body leans on a sprung and damped hip.
///
/// Five rigid bodies (rear wheel R, rear frame with the rider's legs B, upper body U, front frame H, front wheel F),
/// laterally symmetric, on knife-edged wheels that roll without slip on level ground. The hip axis lies along x. Axes:
/// origin at the rear contact point, x forward, y to the right, z down.
///
/// Source: Mechanism: Moore (2012), Human Control of a Bicycle, dissertation, University of California, Davis, leaning rider
///
/// Derived from a mechanism: body `B` (rear frame and legs), body `H` (front frame), body `U` (upper body), wheel `R` (rear wheel), wheel `F` (front wheel).
///
/// The fields are the parameters. The coordinates are `phi` (lean) in rad, `delta` (steer) in rad, `theta` (upper body) in rad.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleLeaning<T = ::core::primitive::f64> {
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
    /// Height of the rider's hip axis, downward from the ground, so negative.
    ///
    /// `zP` in m: any finite value.
    pub zP: T,
    /// Mass of the rider's upper body.
    ///
    /// `mU` in kg: >= 0.
    pub mU: T,
    /// Centre of mass of the upper body, forward of the rear contact.
    ///
    /// `xU` in m: any finite value.
    pub xU: T,
    /// Centre of mass of the upper body, downward.
    ///
    /// `zU` in m: any finite value.
    pub zU: T,
    /// Moment of inertia of the upper body about its centre of mass, in roll.
    ///
    /// `IUxx` in kg*m^2: >= 0.
    pub IUxx: T,
    /// Moment of inertia of the upper body about its centre of mass, in pitch.
    ///
    /// `IUyy` in kg*m^2: >= 0. No matrix depends on it.
    pub IUyy: T,
    /// Moment of inertia of the upper body about its centre of mass, in yaw.
    ///
    /// `IUzz` in kg*m^2: >= 0.
    pub IUzz: T,
    /// Product of inertia of the upper body about its centre of mass.
    ///
    /// `IUxz` in kg*m^2: any finite value.
    pub IUxz: T,
    /// Stiffness of the hip.
    ///
    /// `kU` in N*m: >= 0.
    pub kU: T,
    /// Damping of the hip.
    ///
    /// `dU` in N*m*s: >= 0.
    pub dU: T,
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl WhippleLeaning<::core::primitive::f64> {
    /// The parameter set `example`.
    ///
    /// Source: The benchmark of Meijaard et al. (2007), Table 1, with 40 kg of rear frame and rider as an upper body
    pub const EXAMPLE: Self = Self {
        w: 1.02,
        c: 0.08,
        lam: 0.3141592653589793,
        g: 9.81,
        rR: 0.3,
        mR: 2.0,
        IRxx: 0.0603,
        IRyy: 0.12,
        xB: 0.3,
        zB: -0.7,
        mB: 45.0,
        IBxx: 4.0,
        IByy: 5.5,
        IBzz: 1.8,
        IBxz: 1.2,
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
        zP: -0.85,
        mU: 40.0,
        xU: 0.3,
        zU: -1.125,
        IUxx: 1.6,
        IUyy: 1.6,
        IUzz: 0.6,
        IUxz: 0.0,
        kU: 600.0,
        dU: 60.0,
    };
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> WhippleLeaning<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 36]) -> Self {
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
            zP: values[26],
            mU: values[27],
            xU: values[28],
            zU: values[29],
            IUxx: values[30],
            IUyy: values[31],
            IUzz: values[32],
            IUxz: values[33],
            kU: values[34],
            dU: values[35],
        }
    }
    /// The parameters as an array in declared order.
    #[must_use]
    pub const fn to_array(&self) -> [T; 36] {
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
            self.zP,
            self.mU,
            self.xU,
            self.zU,
            self.IUxx,
            self.IUyy,
            self.IUzz,
            self.IUxz,
            self.kU,
            self.dU,
        ]
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> WhippleLeaning<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: ::carvallo::Scalar>(&self) -> WhippleLeaning<U> {
        WhippleLeaning {
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
            zP: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.zP)),
            mU: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.mU)),
            xU: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.xU)),
            zU: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.zU)),
            IUxx: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IUxx)),
            IUyy: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IUyy)),
            IUzz: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IUzz)),
            IUxz: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IUxz)),
            kU: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.kU)),
            dU: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.dU)),
        }
    }
}
/// The coefficient matrices of [`WhippleLeaning`], each 3 x 3 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleLeaningMatrices<T = ::core::primitive::f64> {
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
impl<T: ::carvallo::Number> WhippleLeaning<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 61 additions, 71 multiplications, 3 divisions, 4 negations and 2 trigonometric functions: 141 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleLeaningMatrices<T> {
        let t7 = self.zU - self.zP;
        let Jxx_theta = self.IUxx + (self.mU * (t7 * t7));
        let Jxx_delta = ((self.IHxx + self.IFxx) + (self.mH * (self.zH * self.zH)))
            + (self.mF * (self.rF * self.rF));
        let Sz_theta = self.mU * t7;
        let t30 = self.zP * self.mU;
        let t44 = (((((self.IRxx + self.IBxx) + Jxx_theta) + Jxx_delta)
            + ((self.zP * ::carvallo::Number::like(self.w, 2.0))
                * (Sz_theta + (::carvallo::Number::like(self.w, 0.5) * t30))))
            + (self.mR * (self.rR * self.rR))) + (self.mB * (self.zB * self.zB));
        let (t46, t60) = ::carvallo::Number::sin_cos(self.lam);
        let t50 = self.rF * self.mF;
        let t55 = self.w + self.c;
        let t56 = self.xH - t55;
        let t57 = self.mH * t56;
        let Jxz_delta = (self.IHxz - (self.c * t50)) - (self.zH * t57);
        let hx_delta = (Jxx_delta * t46) + (Jxz_delta * t60);
        let yaw_per_v_delta = t60 / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let Jxz_theta = self.IUxz - (self.xU * Sz_theta);
        let t73 = self.zB * self.mB;
        let Sx_theta = self.mU * self.xU;
        let Sz_delta = (self.zH * self.mH) - t50;
        let Jxz_all = ((((self.IBxz + Jxz_theta) + Jxz_delta) - (self.xB * t73))
            - (Sx_theta * self.zP)) - (Sz_delta * t55);
        let t84 = hx_delta + (yaw_by_delta * Jxz_all);
        let M_phi_theta = Jxx_theta + (self.zP * Sz_theta);
        let t94 = self.IHzz + self.IFxx;
        let hz_delta = (Jxz_delta * t46)
            + (t60 * (((self.mH * (t56 * t56)) + (self.mF * (self.c * self.c))) + t94));
        let Sx_delta = t57 - (self.c * self.mF);
        let py_delta = (Sx_delta * t60) - (Sz_delta * t46);
        let M_yaw_delta = hz_delta + (py_delta * t55);
        let t118 = (((((self.IRxx + self.IBzz) + self.IUzz) + t94)
            + (self.mB * (self.xB * self.xB))) + (self.mH * (self.xH * self.xH)))
            + (self.mF * (self.w * self.w));
        let P_delta_yaw = M_yaw_delta
            + (yaw_by_delta * (t118 + (self.mU * (self.xU * self.xU))));
        let t129 = ((yaw_by_delta * (M_yaw_delta + P_delta_yaw)) + (hx_delta * t46))
            + (hz_delta * t60);
        let P_delta_theta = yaw_by_delta * Jxz_theta;
        let h_spin_F = self.IFyy / self.rF;
        let h_wheels_all = h_spin_F + (self.IRyy / self.rR);
        let Sz_all = (((Sz_theta + Sz_delta) + t73) - (self.rR * self.mR)) + t30;
        let t143 = h_wheels_all - Sz_all;
        let t147 = h_spin_F * t60;
        let t148 = ((yaw_by_delta * t143) + (yaw_per_v_delta * Jxz_all)) + t147;
        let Sx_all = ((Sx_theta + Sx_delta) + (self.xB * self.mB))
            + (t55 * (self.mH + self.mF));
        let P_delta_lateral = py_delta + (yaw_by_delta * Sx_all);
        let t161 = (yaw_by_delta * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
        let t164 = (yaw_per_v_delta * Jxz_theta) - (yaw_by_delta * Sz_theta);
        let t167 = yaw_per_v_delta * t143;
        let t170 = yaw_per_v_delta * (P_delta_lateral + (h_spin_F * t46));
        let t172 = -(t147 + (yaw_by_delta * h_wheels_all));
        let t173 = -P_delta_lateral;
        let t174 = -(t46 * P_delta_lateral);
        let t175 = -(yaw_per_v_delta * Sz_theta);
        WhippleLeaningMatrices {
            m: [
                [t44, t84, M_phi_theta],
                [t84, t129, P_delta_theta],
                [M_phi_theta, P_delta_theta, Jxx_theta],
            ],
            c0: [
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    self.dU,
                ],
            ],
            c1: [
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    t148,
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                [t172, t161, ::carvallo::Number::like(self.w, 0.0)],
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    t164,
                    ::carvallo::Number::like(self.w, 0.0),
                ],
            ],
            kc: [
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    self.kU,
                ],
            ],
            k0: [
                [Sz_all, t173, Sz_theta],
                [t173, t174, ::carvallo::Number::like(self.w, 0.0)],
                [Sz_theta, ::carvallo::Number::like(self.w, 0.0), Sz_theta],
            ],
            k2: [
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    t167,
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    t170,
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    t175,
                    ::carvallo::Number::like(self.w, 0.0),
                ],
            ],
        }
    }
}
/// Rates and forces of [`WhippleLeaning`] that follow from its coordinates q = (`phi`, `delta`, `theta`), to first order and in SI units.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleLeaningKinematics<T = ::core::primitive::f64> {
    /// Lateral velocity, to the right, in m/s: of the point of `B` that is at the origin.
    pub lateral: ::carvallo::Rate<T, 3>,
    /// Yaw rate, to the right, in rad/s: of `B`.
    pub yaw: ::carvallo::Rate<T, 3>,
    /// Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_R: ::carvallo::Rate<T, 3>,
    /// Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_F: ::carvallo::Rate<T, 3>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of `Tphi` (lean torque) in N*m, `Tdelta` (steer torque) in N*m, `Ttheta` (hip torque) in N*m.
    pub forces: [[T; 3]; 3],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> WhippleLeaning<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> WhippleLeaningKinematics<T> {
        let yaw_per_v_delta = (::carvallo::Number::cos(self.lam)) / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let t12 = -(::carvallo::Number::like(self.w, 1.0) / self.rR);
        let t13 = -(::carvallo::Number::like(self.w, 1.0) / self.rF);
        WhippleLeaningKinematics {
            lateral: ::carvallo::Rate {
                speed: ::carvallo::Number::like(self.w, 0.0),
                rates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                coordinates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                heading: ::carvallo::Number::like(self.w, 1.0),
            },
            yaw: ::carvallo::Rate {
                speed: ::carvallo::Number::like(self.w, 0.0),
                rates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    yaw_by_delta,
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                coordinates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    yaw_per_v_delta,
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                heading: ::carvallo::Number::like(self.w, 0.0),
            },
            wheel_R: ::carvallo::Rate {
                speed: t12,
                rates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                coordinates: [
                    ::carvallo::Number::like(self.w, 0.0),
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
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                coordinates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                heading: ::carvallo::Number::like(self.w, 0.0),
            },
            forces: [
                [
                    ::carvallo::Number::like(self.w, 1.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 1.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 1.0),
                ],
            ],
        }
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Model<3> for WhippleLeaning<T> {
    type Scalar = T;
    type Array<U: ::core::marker::Copy> = [U; 36];
    type Over<U: ::carvallo::Number> = WhippleLeaning<U>;
    const INFO: &'static ::carvallo::ModelInfo = &::carvallo::ModelInfo {
        name: "WhippleLeaning",
        docs: "The Whipple-Carvallo bicycle with a rider whose upper body leans on a sprung and damped hip.\n\nFive rigid bodies (rear wheel R, rear frame with the rider's legs B, upper body U, front frame H, front wheel F),\nlaterally symmetric, on knife-edged wheels that roll without slip on level ground. The hip axis lies along x. Axes:\norigin at the rear contact point, x forward, y to the right, z down.",
        source: "Mechanism: Moore (2012), Human Control of a Bicycle, dissertation, University of California, Davis, leaning rider",
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
            ::carvallo::ParameterInfo {
                name: "zP",
                symbol: "zP",
                docs: "Height of the rider's hip axis, downward from the ground, so negative.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "mU",
                symbol: "mU",
                docs: "Mass of the rider's upper body.",
                unit: "kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "xU",
                symbol: "xU",
                docs: "Centre of mass of the upper body, forward of the rear contact.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "zU",
                symbol: "zU",
                docs: "Centre of mass of the upper body, downward.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IUxx",
                symbol: "IUxx",
                docs: "Moment of inertia of the upper body about its centre of mass, in roll.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IUyy",
                symbol: "IUyy",
                docs: "Moment of inertia of the upper body about its centre of mass, in pitch.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: false,
            },
            ::carvallo::ParameterInfo {
                name: "IUzz",
                symbol: "IUzz",
                docs: "Moment of inertia of the upper body about its centre of mass, in yaw.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IUxz",
                symbol: "IUxz",
                docs: "Product of inertia of the upper body about its centre of mass.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "kU",
                symbol: "kU",
                docs: "Stiffness of the hip.",
                unit: "N*m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "dU",
                symbol: "dU",
                docs: "Damping of the hip.",
                unit: "N*m*s",
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
            ::carvallo::CoordinateInfo {
                name: "theta",
                label: "upper body",
                docs: "Lean of the upper body relative to the rear frame, positive to the right.",
                unit: "rad",
            },
        ],
        matrices: &["M", "C0", "C1", "Kc", "K0", "K2"],
        entries: &[
            ::carvallo::EntryInfo {
                places: &[("M", 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("M", 0, 1), ("M", 1, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("M", 0, 2), ("M", 2, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("M", 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("M", 1, 2), ("M", 2, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("M", 2, 2)],
            },
            ::carvallo::EntryInfo {
                places: &[("C0", 2, 2)],
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
                places: &[("C1", 2, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("Kc", 2, 2)],
            },
            ::carvallo::EntryInfo {
                places: &[("K0", 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("K0", 0, 1), ("K0", 1, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("K0", 0, 2), ("K0", 2, 0), ("K0", 2, 2)],
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
            ::carvallo::EntryInfo {
                places: &[("K2", 2, 1)],
            },
        ],
        sets: &[
            ::carvallo::SetInfo {
                name: "example",
                docs: "",
                source: "The benchmark of Meijaard et al. (2007), Table 1, with 40 kg of rear frame and rider as an upper body",
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
                    -0.7,
                    45.0,
                    4.0,
                    5.5,
                    1.8,
                    1.2,
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
                    -0.85,
                    40.0,
                    0.3,
                    -1.125,
                    1.6,
                    1.6,
                    0.6,
                    0.0,
                    600.0,
                    60.0,
                ],
            },
        ],
        gravity: ::core::option::Option::Some(3),
    };
    fn from_slice(
        values: &[T],
    ) -> ::core::result::Result<Self, ::carvallo::LengthError> {
        if values.len() != 36 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "WhippleLeaning",
                expected: 36,
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
            zP: values[26],
            mU: values[27],
            xU: values[28],
            zU: values[29],
            IUxx: values[30],
            IUyy: values[31],
            IUzz: values[32],
            IUxz: values[33],
            kU: values[34],
            dU: values[35],
        })
    }
    fn write_to(
        &self,
        values: &mut [T],
    ) -> ::core::result::Result<(), ::carvallo::LengthError> {
        if values.len() != 36 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "WhippleLeaning",
                expected: 36,
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
                ::carvallo::Scalar::to_f64(self.zP),
                ::carvallo::Scalar::to_f64(self.mU),
                ::carvallo::Scalar::to_f64(self.xU),
                ::carvallo::Scalar::to_f64(self.zU),
                ::carvallo::Scalar::to_f64(self.IUxx),
                ::carvallo::Scalar::to_f64(self.IUyy),
                ::carvallo::Scalar::to_f64(self.IUzz),
                ::carvallo::Scalar::to_f64(self.IUxz),
                ::carvallo::Scalar::to_f64(self.kU),
                ::carvallo::Scalar::to_f64(self.dU),
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
impl<T: ::carvallo::Number> ::carvallo::Evaluator<T, 3> for WhippleLeaning<T> {
    type Entries = [T; 19];
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
            zP: parameter(26),
            mU: parameter(27),
            xU: parameter(28),
            zU: parameter(29),
            IUxx: parameter(30),
            IUyy: parameter(31),
            IUzz: parameter(32),
            IUxz: parameter(33),
            kU: parameter(34),
            dU: parameter(35),
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
            matrices.m[1][2],
            matrices.m[2][2],
            matrices.c0[2][2],
            matrices.c1[0][1],
            matrices.c1[1][0],
            matrices.c1[1][1],
            matrices.c1[2][1],
            matrices.kc[2][2],
            matrices.k0[0][0],
            matrices.k0[0][1],
            matrices.k0[0][2],
            matrices.k0[1][1],
            matrices.k2[0][1],
            matrices.k2[1][1],
            matrices.k2[2][1],
        ]
    }
    #[inline(always)]
    fn rows(&self) -> [[[T; 3]; 3]; 6] {
        let matrices = self.matrices();
        [matrices.m, matrices.c0, matrices.c1, matrices.kc, matrices.k0, matrices.k2]
    }
}
/// The derivatives of the matrices of [`WhippleLeaning`] with respect to its parameters, in SI units: those that are not zero for all parameters.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleLeaningDerivatives<T = ::core::primitive::f64> {
    /// The value of each derivative in [`Self::PARTIALS`].
    pub values: [T; 243],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl WhippleLeaningDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [::carvallo::Partial; 243] = &[
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 2, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 2, 1, 2),
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
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 2, 26),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 26),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 0, 26),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 26),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 2, 26),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 26),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 2, 26),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 0, 26),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 2, 26),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 2, 1, 26),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 2, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 0, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 2, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 2, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 0, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 2, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 2, 1, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 28),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 28),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 28),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 28),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 28),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 28),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 28),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 28),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 28),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 28),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 28),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 28),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 2, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 0, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 2, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 2, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 0, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 2, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 2, 1, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 30),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 2, 30),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 0, 30),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 2, 30),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 32),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 32),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 33),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 33),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 33),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 33),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 33),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 33),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 2, 2, 34),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 2, 2, 35),
    ];
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> WhippleLeaningDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(
        &self,
        parameter: ::core::primitive::usize,
    ) -> ::core::option::Option<WhippleLeaningMatrices<T>> {
        if parameter >= 36 {
            return ::core::option::Option::None;
        }
        let zero = <T as ::carvallo::Scalar>::from_f64(0.0);
        let mut matrices = WhippleLeaningMatrices {
            m: [[zero; 3]; 3],
            c0: [[zero; 3]; 3],
            c1: [[zero; 3]; 3],
            kc: [[zero; 3]; 3],
            k0: [[zero; 3]; 3],
            k2: [[zero; 3]; 3],
        };
        for position in 0..243 {
            let partial = <WhippleLeaningDerivatives>::PARTIALS[position];
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
            matrix[partial.row][partial.column] = self.values[position];
        }
        ::core::option::Option::Some(matrices)
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> WhippleLeaning<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 184 additions, 330 multiplications, 3 divisions, 71 negations and 2 trigonometric functions: 590 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(
        &self,
    ) -> (WhippleLeaningMatrices<T>, WhippleLeaningDerivatives<T>) {
        let (
            t8,
            Jxx_theta_mU,
            Jxx_theta,
            Jxx_delta_mH,
            Jxx_delta_mF,
            Jxx_delta,
            Sz_theta,
            t30,
            t38,
            t43,
            t45,
            t47,
            t61,
            t50,
            t56,
            t57,
            t58,
            Jxz_delta,
            t62,
            hx_delta,
            t64,
            yaw_per_v_delta,
            yaw_by_delta,
            Jxz_theta,
            t75,
            Sx_theta,
            t81,
            Sz_delta,
            Jxz_all,
            t86,
            M_phi_theta,
            t90,
            t92,
            t93,
            t96,
            t98,
            hz_delta,
            Sx_delta,
            py_delta,
            M_yaw_delta,
            t115,
            t118,
            t121,
            t123,
            t124,
            P_delta_yaw_yaw_by_delta,
            t127,
            P_delta_yaw,
            t129,
            t131,
            P_delta_theta,
            t136,
            h_spin_F,
            t138,
            t140,
            h_wheels_all,
            t143,
            t146,
            Sz_all,
            t148,
            t151,
            t152,
            t157,
            t159,
            Sx_all,
            P_delta_lateral,
            t165,
            t166,
            t167,
            t168,
            t171,
            t172,
            K222_yaw_per_v_delta,
            t174,
            C112_h_spin_F,
            t177,
            t179,
            t181,
            M12_yaw_per_v_delta,
            t185,
            t186,
            t187,
            t188,
            M22_hz_delta,
            t191,
            M22_py_delta,
            M22_Jxz_delta,
            t198,
            t200,
            P_delta_yaw_w,
            M22_yaw_by_delta,
            M22_yaw_per_v_delta,
            t208,
            M23_yaw_per_v_delta,
            t211,
            t213,
            C112_yaw_per_v_delta,
            t218,
            t219,
            C122_py_delta,
            C122_Jxz_delta,
            t226,
            t228,
            t231,
            t232,
            t234,
            P_delta_lateral_yaw_per_v_delta,
            t236,
            P_delta_lateral_w,
            C122_yaw_by_delta,
            C122_yaw_per_v_delta,
            t245,
            C132_yaw_per_v_delta,
            t253,
            t254,
            t259,
            t264,
            t265,
            hz_delta_c,
            t269,
            t271,
            t274,
            P_delta_lateral_c,
            t289,
            t291,
            hx_delta_lam,
            t294,
            t296,
            hz_delta_lam,
            t308,
            t312,
            t317,
            t320,
            t326,
            t334,
            t335,
            t336,
            t338,
            t339,
            t340,
            t341,
            t342,
            t343,
            t344,
            t345,
            t346,
            t347,
            t348,
            P_delta_yaw_xB,
            t351,
            P_delta_lateral_xB,
            t356,
            t358,
            t359,
            P_delta_lateral_mB,
            t363,
            P_delta_yaw_mB,
            t368,
            t372,
            t375,
            P_delta_yaw_xH,
            t379,
            t383,
            t385,
            Jxx_delta_zH,
            t391,
            t393,
            M22_Jxx_delta,
            t398,
            t400,
            t408,
            t412,
            t416,
            t418,
            P_delta_yaw_mH,
            hz_delta_mH,
            py_delta_mH,
            t431,
            P_delta_lateral_mH,
            t445,
            t448,
            t450,
            t451,
            Jxx_delta_rF,
            t453,
            t454,
            t455,
            t457,
            t460,
            t461,
            t462,
            t465,
            P_delta_lateral_rF,
            t469,
            t472,
            t475,
            t476,
            P_delta_yaw_mF,
            hz_delta_mF,
            t485,
            t486,
            P_delta_lateral_mF,
            t498,
            t500,
            t501,
            t502,
            t503,
            t504,
            t505,
            t506,
            t507,
            t508,
            P_delta_lateral_mU,
            t510,
            t512,
            t513,
            t514,
            t518,
            Sz_all_mU,
            t520,
            t523,
            P_delta_yaw_mU,
            t525,
            t532,
            t536,
            P_delta_yaw_xU,
            t540,
            P_delta_lateral_xU,
            t545,
            t547,
            t549,
            t553,
            t554,
            t555,
            t556,
            t557,
            t558,
            t559,
            t560,
            t561,
            t562,
            t563,
            t564,
            t565,
            t566,
            t567,
            t568,
            t569,
            t570,
            t571,
            t572,
        );
        t8 = self.zU - self.zP;
        Jxx_theta_mU = t8 * t8;
        Jxx_theta = self.IUxx + (self.mU * Jxx_theta_mU);
        Jxx_delta_mH = self.zH * self.zH;
        Jxx_delta_mF = self.rF * self.rF;
        Jxx_delta = ((self.IHxx + self.IFxx) + (self.mH * Jxx_delta_mH))
            + (self.mF * Jxx_delta_mF);
        Sz_theta = self.mU * t8;
        t30 = self.zP * self.mU;
        t38 = self.rR * self.rR;
        t43 = self.zB * self.zB;
        t45 = (((((self.IRxx + self.IBxx) + Jxx_theta) + Jxx_delta)
            + ((self.zP * ::carvallo::Number::like(self.w, 2.0))
                * (Sz_theta + (t30 * ::carvallo::Number::like(self.w, 0.5)))))
            + (self.mR * t38)) + (self.mB * t43);
        (t47, t61) = ::carvallo::Number::sin_cos(self.lam);
        t50 = self.rF * self.mF;
        t56 = self.w + self.c;
        t57 = self.xH - t56;
        t58 = self.mH * t57;
        Jxz_delta = (self.IHxz - (t50 * self.c)) - (t58 * self.zH);
        t62 = Jxz_delta * t61;
        hx_delta = (Jxx_delta * t47) + t62;
        t64 = ::carvallo::Number::like(self.w, 1.0) / self.w;
        yaw_per_v_delta = t61 * t64;
        yaw_by_delta = self.c * yaw_per_v_delta;
        Jxz_theta = self.IUxz - (self.xU * Sz_theta);
        t75 = self.zB * self.mB;
        Sx_theta = self.mU * self.xU;
        t81 = self.zH * self.mH;
        Sz_delta = t81 - t50;
        Jxz_all = ((((self.IBxz + Jxz_delta) + Jxz_theta) - (self.xB * t75))
            - (Sx_theta * self.zP)) - (t56 * Sz_delta);
        t86 = hx_delta + (yaw_by_delta * Jxz_all);
        M_phi_theta = Jxx_theta + (self.zP * Sz_theta);
        t90 = t47 * Jxz_delta;
        t92 = self.IHzz + self.IFxx;
        t93 = t57 * t57;
        t96 = self.c * self.c;
        t98 = (t92 + (self.mH * t93)) + (self.mF * t96);
        hz_delta = t90 + (t61 * t98);
        Sx_delta = t58 - (self.mF * self.c);
        py_delta = (t61 * Sx_delta) - (Sz_delta * t47);
        M_yaw_delta = hz_delta + (t56 * py_delta);
        t115 = self.xB * self.xB;
        t118 = self.xH * self.xH;
        t121 = self.w * self.w;
        t123 = (((((self.IRxx + self.IBzz) + self.IUzz) + t92) + (self.mB * t115))
            + (self.mH * t118)) + (self.mF * t121);
        t124 = self.xU * self.xU;
        P_delta_yaw_yaw_by_delta = t123 + (self.mU * t124);
        t127 = yaw_by_delta * P_delta_yaw_yaw_by_delta;
        P_delta_yaw = M_yaw_delta + t127;
        t129 = M_yaw_delta + P_delta_yaw;
        t131 = ((t47 * hx_delta) + (t61 * hz_delta)) + (yaw_by_delta * t129);
        P_delta_theta = yaw_by_delta * Jxz_theta;
        t136 = ::carvallo::Number::like(self.w, 1.0) / self.rF;
        h_spin_F = self.IFyy * t136;
        t138 = t61 * h_spin_F;
        t140 = ::carvallo::Number::like(self.w, 1.0) / self.rR;
        h_wheels_all = h_spin_F + (self.IRyy * t140);
        t143 = Sz_theta + t30;
        t146 = self.rR * self.mR;
        Sz_all = ((t143 + t75) + Sz_delta) - t146;
        t148 = h_wheels_all - Sz_all;
        t151 = yaw_per_v_delta * Jxz_all;
        t152 = (t138 + (yaw_by_delta * t148)) + t151;
        t157 = self.xB * self.mB;
        t159 = self.mH + self.mF;
        Sx_all = ((Sx_theta + Sx_delta) + t157) + (t56 * t159);
        P_delta_lateral = py_delta + (yaw_by_delta * Sx_all);
        t165 = (yaw_per_v_delta * P_delta_yaw) + (yaw_by_delta * P_delta_lateral);
        t166 = Sz_theta * yaw_by_delta;
        t167 = yaw_per_v_delta * Jxz_theta;
        t168 = t167 - t166;
        t171 = yaw_per_v_delta * t148;
        t172 = t47 * h_spin_F;
        K222_yaw_per_v_delta = P_delta_lateral + t172;
        t174 = yaw_per_v_delta * K222_yaw_per_v_delta;
        C112_h_spin_F = t61 + yaw_by_delta;
        t177 = t81 * C112_h_spin_F;
        t179 = (yaw_by_delta * Sz_delta) - t177;
        t181 = t61 * (t64 * t64);
        M12_yaw_per_v_delta = self.c * Jxz_all;
        t185 = self.mH * ::carvallo::Number::like(self.w, 2.0);
        t186 = t57 * t61;
        t187 = t185 * t186;
        t188 = yaw_by_delta * ::carvallo::Number::like(self.w, 2.0);
        M22_hz_delta = t61 + t188;
        t191 = self.mH * t61;
        M22_py_delta = t56 * t188;
        M22_Jxz_delta = t47 * (t61 + M22_hz_delta);
        t198 = ((t187 * M22_hz_delta) + (t191 * M22_py_delta)) - (t81 * M22_Jxz_delta);
        t200 = (py_delta * t188) - t198;
        P_delta_yaw_w = (self.w * self.mF) * t188;
        M22_yaw_by_delta = t127 + t129;
        M22_yaw_per_v_delta = self.c * M22_yaw_by_delta;
        t208 = (t200 + (yaw_by_delta * P_delta_yaw_w)) - (t181 * M22_yaw_per_v_delta);
        M23_yaw_per_v_delta = self.c * Jxz_theta;
        t211 = yaw_per_v_delta * t81;
        t213 = (yaw_per_v_delta * Sz_delta) - t211;
        C112_yaw_per_v_delta = Jxz_all + (self.c * t148);
        t218 = h_wheels_all * self.c;
        t219 = t181 * t218;
        C122_py_delta = t56 * yaw_per_v_delta;
        C122_Jxz_delta = t47 * yaw_per_v_delta;
        t226 = ((yaw_per_v_delta * t187) + (t191 * C122_py_delta))
            - (t81 * C122_Jxz_delta);
        t228 = (yaw_per_v_delta * py_delta) - t226;
        t231 = self.mH * yaw_by_delta;
        t232 = t191 + t231;
        t234 = (yaw_by_delta * t159) - t232;
        P_delta_lateral_yaw_per_v_delta = self.c * Sx_all;
        t236 = t181 * P_delta_lateral_yaw_per_v_delta;
        P_delta_lateral_w = t234 - t236;
        C122_yaw_by_delta = P_delta_lateral
            + (yaw_per_v_delta * P_delta_yaw_yaw_by_delta);
        C122_yaw_per_v_delta = P_delta_yaw + (self.c * C122_yaw_by_delta);
        t245 = ((t228 + (yaw_per_v_delta * P_delta_yaw_w))
            + (yaw_by_delta * P_delta_lateral_w)) - (t181 * C122_yaw_per_v_delta);
        C132_yaw_per_v_delta = Jxz_theta - (Sz_theta * self.c);
        t253 = (yaw_per_v_delta * P_delta_lateral_w) - (t181 * K222_yaw_per_v_delta);
        t254 = t181 * Sz_theta;
        t259 = ((t151 - t179) - (t61 * t50)) - (t50 * yaw_by_delta);
        t264 = self.c * t61;
        t265 = self.mF * ::carvallo::Number::like(self.w, 2.0);
        hz_delta_c = t264 * t265;
        t269 = self.mF * t61;
        t271 = (((t200 - (M22_Jxz_delta * t50)) + (yaw_per_v_delta * M22_yaw_by_delta))
            + (hz_delta_c * M22_hz_delta)) - (t269 * M22_py_delta);
        t274 = (yaw_per_v_delta * (t148 - t50)) - t213;
        P_delta_lateral_c = ((t234 - t269) - (self.mF * yaw_by_delta))
            + (yaw_per_v_delta * Sx_all);
        t289 = (((t228 - (C122_Jxz_delta * t50))
            + (yaw_per_v_delta * (hz_delta_c + C122_yaw_by_delta)))
            + (yaw_by_delta * P_delta_lateral_c)) - (t269 * C122_py_delta);
        t291 = yaw_per_v_delta * P_delta_lateral_c;
        hx_delta_lam = (Jxx_delta * t61) - t90;
        t294 = t64 * t47;
        t296 = hx_delta_lam - (t294 * M12_yaw_per_v_delta);
        hz_delta_lam = t62 - (t47 * t98);
        t308 = (t61 * Sz_delta) + (Sx_delta * t47);
        t312 = (((((t47 * hx_delta_lam) + (hx_delta * t61)) - (hz_delta * t47))
            + (hz_delta_lam * M22_hz_delta)) - (t308 * M22_py_delta))
            - (t294 * M22_yaw_per_v_delta);
        t317 = t172 + (t294 * t218);
        t320 = t308 + (t294 * P_delta_lateral_yaw_per_v_delta);
        t326 = (((yaw_per_v_delta * hz_delta_lam) - (yaw_by_delta * t320))
            - (t308 * C122_py_delta)) - (t294 * C122_yaw_per_v_delta);
        t334 = (yaw_per_v_delta * (t138 - t320)) - (t294 * K222_yaw_per_v_delta);
        t335 = t294 * Sz_theta;
        t336 = t146 * ::carvallo::Number::like(self.w, 2.0);
        t338 = self.IRyy * (t140 * t140);
        t339 = self.mR - t338;
        t340 = yaw_by_delta * t339;
        t341 = t338 * yaw_by_delta;
        t342 = yaw_per_v_delta * t339;
        t343 = self.rR * yaw_by_delta;
        t344 = self.rR * yaw_per_v_delta;
        t345 = yaw_by_delta * yaw_by_delta;
        t346 = yaw_per_v_delta * yaw_by_delta;
        t347 = yaw_by_delta * t140;
        t348 = yaw_per_v_delta * t140;
        P_delta_yaw_xB = t157 * t188;
        t351 = yaw_by_delta * P_delta_yaw_xB;
        P_delta_lateral_xB = self.mB * yaw_by_delta;
        t356 = (yaw_per_v_delta * P_delta_yaw_xB) + (yaw_by_delta * P_delta_lateral_xB);
        t358 = yaw_per_v_delta * P_delta_lateral_xB;
        t359 = t75 * ::carvallo::Number::like(self.w, 2.0);
        P_delta_lateral_mB = self.xB * yaw_by_delta;
        t363 = yaw_by_delta + (self.xB * yaw_per_v_delta);
        P_delta_yaw_mB = yaw_by_delta * t115;
        t368 = yaw_by_delta * P_delta_yaw_mB;
        t372 = (yaw_per_v_delta * P_delta_yaw_mB) + (yaw_by_delta * P_delta_lateral_mB);
        t375 = yaw_per_v_delta * P_delta_lateral_mB;
        P_delta_yaw_xH = (self.xH * self.mH) * t188;
        t379 = t198 + (yaw_by_delta * P_delta_yaw_xH);
        t383 = (t226 + (yaw_per_v_delta * P_delta_yaw_xH)) + (yaw_by_delta * t232);
        t385 = yaw_per_v_delta * t232;
        Jxx_delta_zH = self.zH * t185;
        t391 = t58 + (self.mH * t56);
        t393 = ((t47 * Jxx_delta_zH) - (t61 * t58)) - (yaw_by_delta * t391);
        M22_Jxx_delta = t47 * t47;
        t398 = self.mH * t47;
        t400 = ((Jxx_delta_zH * M22_Jxx_delta) - (M22_Jxz_delta * t58))
            - (t398 * M22_py_delta);
        t408 = t398 * t47;
        t412 = t57 * self.zH;
        t416 = t412 + (t56 * self.zH);
        t418 = ((t47 * Jxx_delta_mH) - (t61 * t412)) - (yaw_by_delta * t416);
        P_delta_yaw_mH = yaw_by_delta * t118;
        hz_delta_mH = t61 * t93;
        py_delta_mH = t186 - (self.zH * t47);
        t431 = ((((yaw_by_delta * P_delta_yaw_mH) + (Jxx_delta_mH * M22_Jxx_delta))
            + (hz_delta_mH * M22_hz_delta)) + (py_delta_mH * M22_py_delta))
            - (t412 * M22_Jxz_delta);
        P_delta_lateral_mH = py_delta_mH + (yaw_by_delta * (t56 + t57));
        t445 = (((yaw_per_v_delta * (P_delta_yaw_mH + hz_delta_mH))
            + (yaw_by_delta * P_delta_lateral_mH)) + (py_delta_mH * C122_py_delta))
            - (t412 * C122_Jxz_delta);
        t448 = yaw_per_v_delta * P_delta_lateral_mH;
        t450 = (t61 * M22_hz_delta) + t345;
        t451 = yaw_per_v_delta * C112_h_spin_F;
        Jxx_delta_rF = self.rF * t265;
        t453 = t47 * Jxx_delta_rF;
        t454 = Jxx_delta_rF * M22_Jxx_delta;
        t455 = t56 - self.c;
        t457 = yaw_by_delta + (yaw_per_v_delta * t455);
        t460 = self.IFyy * (t136 * t136);
        t461 = t460 * C112_h_spin_F;
        t462 = (self.mF * t457) - t461;
        t465 = (t47 * C122_py_delta) - (C122_Jxz_delta * self.c);
        P_delta_lateral_rF = self.mF * t47;
        t469 = (self.mF * t465) + (yaw_by_delta * P_delta_lateral_rF);
        t472 = yaw_per_v_delta * (self.mF - t460);
        t475 = (yaw_per_v_delta * P_delta_lateral_rF) - (t460 * C122_Jxz_delta);
        t476 = t47 * Jxx_delta_mF;
        P_delta_yaw_mF = yaw_by_delta * t121;
        hz_delta_mF = t61 * t96;
        t485 = (((yaw_by_delta * P_delta_yaw_mF) + (Jxx_delta_mF * M22_Jxx_delta))
            + (hz_delta_mF * M22_hz_delta)) - (t264 * M22_py_delta);
        t486 = self.rF * t457;
        P_delta_lateral_mF = ((self.rF * t47) - t264) + (yaw_by_delta * t455);
        t498 = (((self.rF * t465) + (yaw_per_v_delta * (P_delta_yaw_mF + hz_delta_mF)))
            + (yaw_by_delta * P_delta_lateral_mF)) - (t264 * C122_py_delta);
        t500 = self.rF * yaw_per_v_delta;
        t501 = yaw_per_v_delta * P_delta_lateral_mF;
        t502 = M22_Jxx_delta + t450;
        t503 = t136 * C112_h_spin_F;
        t504 = yaw_per_v_delta * t136;
        t505 = t136 * C122_Jxz_delta;
        t506 = ::carvallo::Number::like(self.w, 2.0) * Sz_theta;
        t507 = t506 + t30;
        t508 = Sz_theta - t507;
        P_delta_lateral_mU = self.xU * yaw_by_delta;
        t510 = self.mU * P_delta_lateral_mU;
        t512 = yaw_by_delta + (self.xU * yaw_per_v_delta);
        t513 = self.mU * t512;
        t514 = self.mU * yaw_per_v_delta;
        t518 = Jxx_theta_mU
            + (self.zP * (self.zP + (t8 * ::carvallo::Number::like(self.w, 2.0))));
        Sz_all_mU = self.zP + t8;
        t520 = Sz_all_mU * self.xU;
        t523 = Jxx_theta_mU + (self.zP * t8);
        P_delta_yaw_mU = yaw_by_delta * t124;
        t525 = yaw_by_delta * P_delta_yaw_mU;
        t532 = (yaw_per_v_delta * P_delta_yaw_mU) + (yaw_by_delta * P_delta_lateral_mU);
        t536 = yaw_per_v_delta * P_delta_lateral_mU;
        P_delta_yaw_xU = Sx_theta * t188;
        t540 = yaw_by_delta * P_delta_yaw_xU;
        P_delta_lateral_xU = self.mU * yaw_by_delta;
        t545 = (yaw_per_v_delta * P_delta_yaw_xU) + (yaw_by_delta * P_delta_lateral_xU);
        t547 = yaw_per_v_delta * P_delta_lateral_xU;
        t549 = t506 + (t30 * ::carvallo::Number::like(self.w, 2.0));
        t553 = -(t138 + (yaw_by_delta * h_wheels_all));
        t554 = -P_delta_lateral;
        t555 = -(P_delta_lateral * t47);
        t556 = -(yaw_per_v_delta * Sz_theta);
        t557 = -(t179 + (t181 * M12_yaw_per_v_delta));
        t558 = -(t181 * M23_yaw_per_v_delta);
        t559 = -(t213 + (t181 * C112_yaw_per_v_delta));
        t560 = -(t181 * C132_yaw_per_v_delta);
        t561 = t236 - t234;
        t562 = -(P_delta_lateral_w * t47);
        t563 = -(t148 * t181);
        t564 = -(h_wheels_all * yaw_per_v_delta);
        t565 = -P_delta_lateral_c;
        t566 = -(P_delta_lateral_c * t47);
        t567 = -(t294 * M23_yaw_per_v_delta);
        t568 = -(t172 + (t294 * C112_yaw_per_v_delta));
        t569 = -(t294 * C132_yaw_per_v_delta);
        t570 = (t47 * t320) - (P_delta_lateral * t61);
        t571 = -(t148 * t294);
        t572 = -self.mR;
        let (
            t573,
            t574,
            t575,
            t576,
            t577,
            t578,
            t579,
            t580,
            t581,
            t582,
            t583,
            t584,
            t585,
            t586,
            t587,
            t588,
            t589,
            t590,
            t591,
            t592,
            t593,
            t594,
            t595,
            t596,
            t597,
            t598,
            t599,
            t600,
            t601,
            t602,
            t603,
            t604,
            t605,
            t606,
            t607,
            t608,
            t609,
            t610,
            t611,
            t612,
            t613,
            t614,
            t615,
            t616,
            t617,
            t618,
            t619,
            t620,
            t621,
            t622,
            t623,
            t624,
            t625,
        );
        t573 = -self.rR;
        t574 = -t347;
        t575 = -(t75 * yaw_by_delta);
        t576 = -(t75 * yaw_per_v_delta);
        t577 = -P_delta_lateral_xB;
        t578 = -(P_delta_lateral_xB * t47);
        t579 = -(self.mB * P_delta_lateral_mB);
        t580 = -(self.mB * t363);
        t581 = -(self.mB * yaw_per_v_delta);
        t582 = -(self.zB * P_delta_lateral_mB);
        t583 = -(self.zB * t363);
        t584 = -P_delta_lateral_mB;
        t585 = -(P_delta_lateral_mB * t47);
        t586 = -(self.zB * yaw_per_v_delta);
        t587 = -t177;
        t588 = -t211;
        t589 = -t232;
        t590 = -(t232 * t47);
        t591 = -(t231 + (yaw_per_v_delta * t391));
        t592 = -(((C122_Jxz_delta * t58) + (yaw_by_delta * t398))
            + (t398 * C122_py_delta));
        t593 = -(self.mH * yaw_per_v_delta);
        t594 = -(yaw_per_v_delta * t398);
        t595 = -((self.zH * yaw_by_delta) + (yaw_per_v_delta * t416));
        t596 = -P_delta_lateral_mH;
        t597 = -(P_delta_lateral_mH * t47);
        t598 = -(self.zH * yaw_per_v_delta);
        t599 = -self.mF;
        t600 = -P_delta_lateral_rF;
        t601 = -(P_delta_lateral_rF * t47);
        t602 = -self.rF;
        t603 = -P_delta_lateral_mF;
        t604 = -(P_delta_lateral_mF * t47);
        t605 = -t503;
        t606 = -t506;
        t607 = -self.mU;
        t608 = -(yaw_by_delta * t520);
        t609 = -(t8 * P_delta_lateral_mU);
        t610 = -((Sz_all_mU * yaw_by_delta) + (yaw_per_v_delta * t520));
        t611 = -(t8 * t512);
        t612 = -P_delta_lateral_mU;
        t613 = -(P_delta_lateral_mU * t47);
        t614 = -(Sz_all_mU * yaw_per_v_delta);
        t615 = -(t8 * yaw_per_v_delta);
        t616 = -(yaw_by_delta * t143);
        t617 = -t166;
        t618 = -(yaw_per_v_delta * t143);
        t619 = -P_delta_lateral_xU;
        t620 = -(P_delta_lateral_xU * t47);
        t621 = -(yaw_by_delta * Sx_theta);
        t622 = -t510;
        t623 = -(P_delta_lateral_xU + (yaw_per_v_delta * Sx_theta));
        t624 = -t513;
        t625 = -t514;
        (
            WhippleLeaningMatrices {
                m: [
                    [t45, t86, M_phi_theta],
                    [t86, t131, P_delta_theta],
                    [M_phi_theta, P_delta_theta, Jxx_theta],
                ],
                c0: [
                    [
                        ::carvallo::Number::like(self.w, 0.0),
                        ::carvallo::Number::like(self.w, 0.0),
                        ::carvallo::Number::like(self.w, 0.0),
                    ],
                    [
                        ::carvallo::Number::like(self.w, 0.0),
                        ::carvallo::Number::like(self.w, 0.0),
                        ::carvallo::Number::like(self.w, 0.0),
                    ],
                    [
                        ::carvallo::Number::like(self.w, 0.0),
                        ::carvallo::Number::like(self.w, 0.0),
                        self.dU,
                    ],
                ],
                c1: [
                    [
                        ::carvallo::Number::like(self.w, 0.0),
                        t152,
                        ::carvallo::Number::like(self.w, 0.0),
                    ],
                    [t553, t165, ::carvallo::Number::like(self.w, 0.0)],
                    [
                        ::carvallo::Number::like(self.w, 0.0),
                        t168,
                        ::carvallo::Number::like(self.w, 0.0),
                    ],
                ],
                kc: [
                    [
                        ::carvallo::Number::like(self.w, 0.0),
                        ::carvallo::Number::like(self.w, 0.0),
                        ::carvallo::Number::like(self.w, 0.0),
                    ],
                    [
                        ::carvallo::Number::like(self.w, 0.0),
                        ::carvallo::Number::like(self.w, 0.0),
                        ::carvallo::Number::like(self.w, 0.0),
                    ],
                    [
                        ::carvallo::Number::like(self.w, 0.0),
                        ::carvallo::Number::like(self.w, 0.0),
                        self.kU,
                    ],
                ],
                k0: [
                    [Sz_all, t554, Sz_theta],
                    [t554, t555, ::carvallo::Number::like(self.w, 0.0)],
                    [Sz_theta, ::carvallo::Number::like(self.w, 0.0), Sz_theta],
                ],
                k2: [
                    [
                        ::carvallo::Number::like(self.w, 0.0),
                        t171,
                        ::carvallo::Number::like(self.w, 0.0),
                    ],
                    [
                        ::carvallo::Number::like(self.w, 0.0),
                        t174,
                        ::carvallo::Number::like(self.w, 0.0),
                    ],
                    [
                        ::carvallo::Number::like(self.w, 0.0),
                        t556,
                        ::carvallo::Number::like(self.w, 0.0),
                    ],
                ],
            },
            WhippleLeaningDerivatives {
                values: [
                    t557,
                    t557,
                    t208,
                    t558,
                    t558,
                    t559,
                    t219,
                    t245,
                    t560,
                    t561,
                    t561,
                    t562,
                    t563,
                    t253,
                    t254,
                    t259,
                    t259,
                    t271,
                    t167,
                    t167,
                    t274,
                    t564,
                    t289,
                    t556,
                    t565,
                    t565,
                    t566,
                    t291,
                    t296,
                    t296,
                    t312,
                    t567,
                    t567,
                    t568,
                    t317,
                    t326,
                    t569,
                    t320,
                    t320,
                    t570,
                    t571,
                    t334,
                    t335,
                    t336,
                    t340,
                    t341,
                    t572,
                    t342,
                    t38,
                    t343,
                    t573,
                    t344,
                    ::carvallo::Number::like(self.w, 1.0),
                    t345,
                    t346,
                    t347,
                    t574,
                    t348,
                    t575,
                    t575,
                    t351,
                    t576,
                    t356,
                    t577,
                    t577,
                    t578,
                    t358,
                    t359,
                    t579,
                    t579,
                    t580,
                    self.mB,
                    t581,
                    t43,
                    t582,
                    t582,
                    t368,
                    t583,
                    t372,
                    self.zB,
                    t584,
                    t584,
                    t585,
                    t586,
                    t375,
                    ::carvallo::Number::like(self.w, 1.0),
                    t345,
                    t346,
                    yaw_by_delta,
                    yaw_by_delta,
                    yaw_per_v_delta,
                    t587,
                    t587,
                    t379,
                    t588,
                    t383,
                    t589,
                    t589,
                    t590,
                    t385,
                    Jxx_delta_zH,
                    t393,
                    t393,
                    t400,
                    t591,
                    t592,
                    self.mH,
                    t398,
                    t398,
                    t408,
                    t593,
                    t594,
                    Jxx_delta_mH,
                    t418,
                    t418,
                    t431,
                    t595,
                    t445,
                    self.zH,
                    t596,
                    t596,
                    t597,
                    t598,
                    t448,
                    ::carvallo::Number::like(self.w, 1.0),
                    t47,
                    t47,
                    M22_Jxx_delta,
                    t450,
                    t451,
                    C112_h_spin_F,
                    C112_h_spin_F,
                    M22_Jxz_delta,
                    yaw_per_v_delta,
                    C122_Jxz_delta,
                    Jxx_delta_rF,
                    t453,
                    t453,
                    t454,
                    t462,
                    t461,
                    t469,
                    t599,
                    t600,
                    t600,
                    t601,
                    t472,
                    t475,
                    Jxx_delta_mF,
                    t476,
                    t476,
                    t485,
                    t486,
                    t498,
                    t602,
                    t603,
                    t603,
                    t604,
                    t500,
                    t501,
                    ::carvallo::Number::like(self.w, 1.0),
                    t47,
                    t47,
                    t502,
                    t451,
                    t503,
                    t605,
                    t504,
                    t505,
                    t508,
                    t510,
                    t508,
                    t510,
                    t606,
                    t513,
                    t607,
                    t607,
                    t607,
                    t514,
                    t518,
                    t608,
                    t523,
                    t608,
                    t525,
                    t609,
                    t523,
                    t609,
                    Jxx_theta_mU,
                    t610,
                    t532,
                    t611,
                    Sz_all_mU,
                    t612,
                    t8,
                    t612,
                    t613,
                    t8,
                    t8,
                    t614,
                    t536,
                    t615,
                    t616,
                    t616,
                    t540,
                    t617,
                    t617,
                    t618,
                    t545,
                    t556,
                    t619,
                    t619,
                    t620,
                    t547,
                    t549,
                    t621,
                    t507,
                    t621,
                    t622,
                    t507,
                    t622,
                    t506,
                    t623,
                    t624,
                    self.mU,
                    self.mU,
                    self.mU,
                    self.mU,
                    t625,
                    t625,
                    ::carvallo::Number::like(self.w, 1.0),
                    ::carvallo::Number::like(self.w, 1.0),
                    ::carvallo::Number::like(self.w, 1.0),
                    ::carvallo::Number::like(self.w, 1.0),
                    t345,
                    t346,
                    yaw_by_delta,
                    yaw_by_delta,
                    yaw_by_delta,
                    yaw_by_delta,
                    yaw_per_v_delta,
                    yaw_per_v_delta,
                    ::carvallo::Number::like(self.w, 1.0),
                    ::carvallo::Number::like(self.w, 1.0),
                ],
            },
        )
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Differentiable<3> for WhippleLeaning<T> {
    type Derivatives = [::carvallo::Coefficients<T, 3>; 36];
    fn coefficients_and_derivatives(
        &self,
    ) -> (::carvallo::Coefficients<T, 3>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let mut all = [::carvallo::Coefficients::from_rows(
            [[[<T as ::carvallo::Scalar>::from_f64(0.0); 3]; 3]; 6],
        ); 36];
        for position in 0..243 {
            <WhippleLeaningDerivatives>::PARTIALS[position]
                .write(derivatives.values[position], &mut all);
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
