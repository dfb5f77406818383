// @generated from generated/models/whipple_leaning.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 3861e299e6929934

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
    type Parameters = [T; 36];
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
    fn parameters(&self) -> Self::Parameters {
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
