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
    /// 61 additions, 59 multiplications, 3 divisions, 3 negations and 2 trigonometric functions: 128 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleLeaningMatrices<T> {
        let t5 = self.zU - self.zP;
        let Sz_theta = t5 * self.mU;
        let Jxx_theta = self.IUxx + (t5 * Sz_theta);
        let t14 = self.zH * self.mH;
        let t18 = self.rF * self.mF;
        let Jxx_delta = ((self.IHxx + self.IFxx) + (self.zH * t14)) + (self.rF * t18);
        let t25 = self.rR * self.mR;
        let t29 = self.zB * self.mB;
        let t32 = Sz_theta + (self.zP * self.mU);
        let t40 = (((((self.IRxx + self.IBxx) + Jxx_theta) + Jxx_delta)
            + (self.rR * t25)) + (self.zB * t29)) + (self.zP * (Sz_theta + t32));
        let (t42, t54) = ::carvallo::Number::sin_cos(self.lam);
        let t49 = self.c + self.w;
        let t50 = t49 - self.xH;
        let Jxz_delta = (self.IHxz + (t14 * t50)) - (t18 * self.c);
        let hx_delta = (Jxx_delta * t42) + (Jxz_delta * t54);
        let yaw_per_v_delta = t54 / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let Sx_theta = self.mU * self.xU;
        let Jxz_theta = self.IUxz - (t5 * Sx_theta);
        let Sz_delta = t14 - t18;
        let Jxz_all = ((((Jxz_delta + self.IBxz) + Jxz_theta) - (t29 * self.xB))
            - (self.zP * Sx_theta)) - (t49 * Sz_delta);
        let t76 = hx_delta + (yaw_by_delta * Jxz_all);
        let M_phi_theta = Jxx_theta + (self.zP * Sz_theta);
        let t80 = self.mH * t50;
        let t82 = self.mF * self.c;
        let t85 = self.IFxx + self.IHzz;
        let hz_delta = (t42 * Jxz_delta)
            + (t54 * (((t50 * t80) + (self.c * t82)) + t85));
        let t93 = (t42 * Sz_delta) + (t54 * (t80 + t82));
        let M_yaw_delta = hz_delta - (t49 * t93);
        let t98 = self.mB * self.xB;
        let t100 = self.mH * self.xH;
        let t102 = self.mF * self.w;
        let t110 = (((((self.IRxx + t85) + self.IBzz) + self.IUzz) + (self.xB * t98))
            + (self.xH * t100)) + (self.w * t102);
        let P_delta_yaw = M_yaw_delta + (yaw_by_delta * (t110 + (self.xU * Sx_theta)));
        let t119 = ((yaw_by_delta * (M_yaw_delta + P_delta_yaw)) + (t42 * hx_delta))
            + (t54 * hz_delta);
        let P_delta_theta = yaw_by_delta * Jxz_theta;
        let h_spin_F = self.IFyy / self.rF;
        let h_wheels_all = h_spin_F + (self.IRyy / self.rR);
        let Sz_all = ((t29 + t32) + Sz_delta) - t25;
        let t131 = h_wheels_all - Sz_all;
        let t134 = t54 * h_spin_F;
        let t136 = ((yaw_by_delta * t131) + (yaw_per_v_delta * Jxz_all)) + t134;
        let Sx_all = ((Sx_theta + t98) + t100) + t102;
        let t142 = yaw_by_delta * Sx_all;
        let P_delta_lateral = t142 - t93;
        let t146 = (yaw_by_delta * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
        let t149 = (yaw_per_v_delta * Jxz_theta) - (Sz_theta * yaw_by_delta);
        let t152 = yaw_per_v_delta * t131;
        let t155 = yaw_per_v_delta * (P_delta_lateral + (t42 * h_spin_F));
        let t157 = -(t134 + (yaw_by_delta * h_wheels_all));
        let t158 = t93 - t142;
        let t159 = -(t42 * P_delta_lateral);
        let t160 = -(Sz_theta * yaw_per_v_delta);
        {
            #[inline(always)]
            fn matrix<T: ::core::marker::Copy>(
                entries: &[T; 54],
                first: ::core::primitive::usize,
            ) -> [[T; 3]; 3] {
                [
                    [entries[first], entries[first + 1], entries[first + 2]],
                    [entries[first + 3], entries[first + 4], entries[first + 5]],
                    [entries[first + 6], entries[first + 7], entries[first + 8]],
                ]
            }
            let entries = [
                t40,
                t76,
                M_phi_theta,
                t76,
                t119,
                P_delta_theta,
                M_phi_theta,
                P_delta_theta,
                Jxx_theta,
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                self.dU,
                ::carvallo::Number::like(self.w, 0.0),
                t136,
                ::carvallo::Number::like(self.w, 0.0),
                t157,
                t146,
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                t149,
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                self.kU,
                Sz_all,
                t158,
                Sz_theta,
                t158,
                t159,
                ::carvallo::Number::like(self.w, 0.0),
                Sz_theta,
                ::carvallo::Number::like(self.w, 0.0),
                Sz_theta,
                ::carvallo::Number::like(self.w, 0.0),
                t152,
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                t155,
                ::carvallo::Number::like(self.w, 0.0),
                ::carvallo::Number::like(self.w, 0.0),
                t160,
                ::carvallo::Number::like(self.w, 0.0),
            ];
            WhippleLeaningMatrices {
                m: matrix(&entries, 0),
                c0: matrix(&entries, 9),
                c1: matrix(&entries, 18),
                kc: matrix(&entries, 27),
                k0: matrix(&entries, 36),
                k2: matrix(&entries, 45),
            }
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
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 164],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl WhippleLeaningDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [::carvallo::Partial; 243] = &[
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 0, 2).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 0, 2).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 0, 3),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 0, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 0, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 0, 6).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 0, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 0, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 0, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 0, 9).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 0, 10).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 2, 1, 0, 11),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 1, 12),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 1, 12),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 1, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 1, 14),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 1, 14),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 1, 16).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 1, 18).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 1, 19),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 1, 19),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 1, 20).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 1, 21),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 2, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 2, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 2, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 2, 24).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 2, 24).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 2, 25).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 2, 26),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 2, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 2, 28).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 2, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 2, 29),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 2, 30),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 2, 31).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 2, 32),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 2, 1, 2, 33),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 4, 34),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 4, 35),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 4, 36),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 4, 37).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 4, 38),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 5, 39),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 5, 40),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 5, 41).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 5, 42),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 6, 43),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 6, 44),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 6, 45),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 7, 46),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 7, 46).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 7, 47),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 8, 48).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 8, 48).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 8, 49),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 8, 50).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 8, 51),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 8, 52).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 8, 52).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 8, 53).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 8, 54),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 9, 55),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 9, 56).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 9, 56).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 9, 57).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 9, 58),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 9, 59).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 10, 60),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 10, 61).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 10, 61).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 10, 62),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 10, 63).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 10, 64),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 10, 65),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 10, 66).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 10, 66).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 10, 67).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 10, 68).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 10, 69),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 11, 43),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 13, 44),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 13, 45),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 14, 70),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 14, 70),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 14, 71),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 15, 72).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 15, 72).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 15, 73),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 15, 74).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 15, 75),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 15, 76).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 15, 76).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 15, 77).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 15, 78),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 16, 79),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 16, 80),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 16, 80),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 16, 81),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 16, 82),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 16, 83),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 16, 84),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 16, 85),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 16, 85),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 16, 86),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 16, 87).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 16, 88).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 17, 89),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 17, 90),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 17, 90),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 17, 91),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 17, 92),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 17, 93),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 17, 94),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 17, 95),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 17, 95),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 17, 96),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 17, 97).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 17, 98).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 18, 43),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 18, 99),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 18, 99),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 18, 100),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 20, 101),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 20, 102),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 21, 103),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 21, 103),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 21, 104),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 21, 71),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 21, 105),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 22, 106),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 22, 107),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 22, 107),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 22, 108),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 22, 109),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 22, 110),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 22, 111),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 22, 112).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 22, 113).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 22, 113).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 22, 114).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 22, 115),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 22, 116),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 23, 117),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 23, 118),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 23, 118),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 23, 119),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 23, 120),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 23, 121),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 23, 122).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 23, 123),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 23, 123),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 23, 124).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 23, 125),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 23, 126),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 24, 43),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 24, 99),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 24, 99),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 24, 127),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 24, 102),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 25, 128),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 25, 128).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 25, 129),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 25, 130),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 2, 26, 131),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 26, 132),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 0, 26, 131),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 26, 132),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 2, 26, 133).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 26, 134),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 2, 26, 135).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 0, 26, 135).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 2, 26, 135).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 2, 1, 26, 136),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 27, 137),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 27, 138).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 2, 27, 139),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 27, 138).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 27, 140),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 27, 141).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 0, 27, 139),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 27, 141).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 2, 27, 142),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 27, 143).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 27, 144),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 27, 145).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 27, 146),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 27, 147).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 2, 27, 148),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 27, 147).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 27, 149).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 0, 27, 148),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 2, 27, 148),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 27, 150).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 27, 151),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 2, 1, 27, 152).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 28, 153).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 28, 153).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 28, 154),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 28, 155).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 28, 155).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 28, 156).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 28, 157),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 28, 158).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 28, 159).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 28, 159).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 28, 160).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 28, 161),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 29, 162),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 29, 132).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 2, 29, 163),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 29, 132).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 29, 132).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 0, 29, 163),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 29, 132).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 2, 29, 133),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 29, 134).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 29, 134).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 29, 135),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 2, 29, 135),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 0, 29, 135),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 2, 2, 29, 135),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 29, 136).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 2, 1, 29, 136).negative(),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 30, 43),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 2, 30, 43),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 0, 30, 43),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 2, 30, 43),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 32, 44),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 32, 45),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 33, 70),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 33, 70),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 2, 33, 70),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 2, 1, 33, 70),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 33, 71),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 2, 1, 33, 71),
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 2, 2, 34, 43),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 2, 2, 35, 43),
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
            matrix[partial.row][partial.column] = ::carvallo::Partial::of(
                &partial,
                &self.values,
            );
        }
        ::core::option::Option::Some(matrices)
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> WhippleLeaning<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 195 additions, 315 multiplications, 3 divisions, 4 negations and 2 trigonometric functions: 519 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(
        &self,
    ) -> (WhippleLeaningMatrices<T>, WhippleLeaningDerivatives<T>) {
        let (
            t5,
            Sz_theta,
            Jxx_theta,
            t14,
            t18,
            Jxx_delta,
            t25,
            t29,
            t31,
            t32,
            t40,
            t42,
            t54,
            t48,
            t50,
            Jxz_delta,
            t55,
            hx_delta,
            t57,
            yaw_per_v_delta,
            yaw_by_delta,
            Sx_theta,
            Jxz_theta,
            Sz_delta,
            Jxz_all,
            t77,
            M_phi_theta,
            t81,
            t83,
            t84,
            t86,
            t89,
            hz_delta,
            t94,
            t96,
            M_yaw_delta,
            t101,
            t103,
            t105,
            t113,
            P_delta_yaw_yaw_by_delta,
            t115,
            P_delta_yaw,
            t117,
            t120,
            P_delta_theta,
            t125,
            h_spin_F,
            t127,
            t129,
            t130,
            h_wheels_all,
            Sz_all,
            t135,
            t137,
            t139,
            Sx_all,
            t147,
            t149,
            t151,
            t152,
            t154,
            t155,
            t156,
            K222_yaw_per_v_delta,
            t158,
            t159,
            C112_h_spin_F,
            t161,
            t163,
            t164,
            t165,
            t167,
            t168,
            M22_hz_delta,
            M22_Jxz_delta,
            t173,
            t174,
            t176,
            t179,
            t182,
            t184,
            t185,
            P_delta_yaw_w,
            M22_yaw_by_delta,
            M22_yaw_per_v_delta,
            t194,
            P_delta_theta_yaw_per_v_delta,
            t196,
            t197,
            t199,
            C112_yaw_per_v_delta,
            t203,
            t204,
            t205,
            K222_h_spin_F,
            t209,
            t212,
            t214,
            t217,
            t220,
            C122_yaw_by_delta,
            C122_yaw_per_v_delta,
            t229,
            C132_yaw_per_v_delta,
            t232,
            t233,
            t234,
            t237,
            t238,
            t241,
            t244,
            t246,
            hz_delta_c,
            t254,
            t257,
            t258,
            t262,
            t263,
            P_delta_lateral_c,
            t270,
            t271,
            t272,
            hx_delta_lam,
            t275,
            t277,
            t283,
            hz_delta_lam,
            t293,
            t294,
            t296,
            t298,
            t301,
            t307,
            t308,
            t311,
            t312,
            t316,
            t317,
            t318,
            t319,
            t320,
            t321,
            t322,
            t323,
            t324,
            t325,
            t326,
            t328,
            t329,
            t330,
            t331,
            t332,
            t333,
            t334,
            P_delta_yaw_xB,
            t337,
            t338,
            t340,
            t342,
            t343,
            t344,
            t345,
            t347,
            t348,
            t349,
            t350,
            t351,
            P_delta_yaw_mB,
            t353,
            t354,
            t357,
            t358,
            t359,
            t360,
            t361,
            t362,
            P_delta_yaw_xH,
            t367,
            t368,
            P_delta_lateral_xH,
            t376,
            t377,
            t378,
            t379,
            t380,
            t381,
            t384,
            t387,
            t388,
            M22_Jxx_delta,
            t393,
            t396,
            t398,
            t399,
            t400,
            t401,
            t403,
            t405,
            t407,
            t408,
            t409,
            t410,
            t411,
            t412,
            hz_delta_mH,
            t420,
            t421,
            t426,
            t432,
            t433,
            t434,
            t435,
            t437,
            t438,
            t439,
            t441,
            t443,
            t446,
            t450,
            t453,
            t454,
            t456,
            t457,
            t458,
            t460,
            P_delta_lateral_rF,
            t464,
            t465,
            t467,
            t470,
            t471,
            t472,
            P_delta_yaw_mF,
            hz_delta_mF,
            t481,
            t482,
            t487,
            t492,
            t494,
            t496,
            t497,
            t498,
            t499,
            t500,
            t501,
            t502,
            t503,
            t505,
            t506,
            t507,
        );
        t5 = self.zU - self.zP;
        Sz_theta = t5 * self.mU;
        Jxx_theta = self.IUxx + (t5 * Sz_theta);
        t14 = self.zH * self.mH;
        t18 = self.rF * self.mF;
        Jxx_delta = ((self.IHxx + self.IFxx) + (self.zH * t14)) + (self.rF * t18);
        t25 = self.rR * self.mR;
        t29 = self.zB * self.mB;
        t31 = self.zP * self.mU;
        t32 = Sz_theta + t31;
        t40 = (((((self.IRxx + self.IBxx) + Jxx_theta) + Jxx_delta) + (self.rR * t25))
            + (self.zB * t29)) + (self.zP * (Sz_theta + t32));
        (t42, t54) = ::carvallo::Number::sin_cos(self.lam);
        t48 = self.c + self.w;
        t50 = t48 - self.xH;
        Jxz_delta = (self.IHxz + (t14 * t50)) - (t18 * self.c);
        t55 = Jxz_delta * t54;
        hx_delta = (Jxx_delta * t42) + t55;
        t57 = ::carvallo::Number::like(self.w, 1.0) / self.w;
        yaw_per_v_delta = t54 * t57;
        yaw_by_delta = self.c * yaw_per_v_delta;
        Sx_theta = self.mU * self.xU;
        Jxz_theta = self.IUxz - (t5 * Sx_theta);
        Sz_delta = t14 - t18;
        Jxz_all = ((((Jxz_delta + self.IBxz) + Jxz_theta) - (t29 * self.xB))
            - (self.zP * Sx_theta)) - (t48 * Sz_delta);
        t77 = hx_delta + (yaw_by_delta * Jxz_all);
        M_phi_theta = Jxx_theta + (self.zP * Sz_theta);
        t81 = t42 * Jxz_delta;
        t83 = self.IFxx + self.IHzz;
        t84 = self.mF * self.c;
        t86 = self.mH * t50;
        t89 = (t83 + (self.c * t84)) + (t50 * t86);
        hz_delta = t81 + (t54 * t89);
        t94 = t84 + t86;
        t96 = (t42 * Sz_delta) + (t54 * t94);
        M_yaw_delta = hz_delta - (t48 * t96);
        t101 = self.mF * self.w;
        t103 = self.mB * self.xB;
        t105 = self.mH * self.xH;
        t113 = (((((self.IRxx + t83) + self.IBzz) + self.IUzz) + (self.w * t101))
            + (self.xB * t103)) + (self.xH * t105);
        P_delta_yaw_yaw_by_delta = t113 + (self.xU * Sx_theta);
        t115 = yaw_by_delta * P_delta_yaw_yaw_by_delta;
        P_delta_yaw = M_yaw_delta + t115;
        t117 = M_yaw_delta + P_delta_yaw;
        t120 = ((t42 * hx_delta) + (t54 * hz_delta)) + (yaw_by_delta * t117);
        P_delta_theta = yaw_by_delta * Jxz_theta;
        t125 = ::carvallo::Number::like(self.w, 1.0) / self.rF;
        h_spin_F = self.IFyy * t125;
        t127 = t54 * h_spin_F;
        t129 = ::carvallo::Number::like(self.w, 1.0) / self.rR;
        t130 = self.IRyy * t129;
        h_wheels_all = h_spin_F + t130;
        Sz_all = ((t29 + t32) + Sz_delta) - t25;
        t135 = h_wheels_all - Sz_all;
        t137 = yaw_per_v_delta * Jxz_all;
        t139 = (t127 + (yaw_by_delta * t135)) + t137;
        Sx_all = ((Sx_theta + t101) + t103) + t105;
        t147 = t96 - (yaw_by_delta * Sx_all);
        t149 = (yaw_per_v_delta * P_delta_yaw) - (yaw_by_delta * t147);
        t151 = yaw_per_v_delta * Jxz_theta;
        t152 = t151 - (Sz_theta * yaw_by_delta);
        t154 = t42 * t147;
        t155 = yaw_per_v_delta * t135;
        t156 = t42 * h_spin_F;
        K222_yaw_per_v_delta = t156 - t147;
        t158 = yaw_per_v_delta * K222_yaw_per_v_delta;
        t159 = Sz_theta * yaw_per_v_delta;
        C112_h_spin_F = t54 + yaw_by_delta;
        t161 = t14 * C112_h_spin_F;
        t163 = t161 - (yaw_by_delta * Sz_delta);
        t164 = t57 * yaw_per_v_delta;
        t165 = self.c * Jxz_all;
        t167 = t163 - (t164 * t165);
        t168 = yaw_by_delta + yaw_by_delta;
        M22_hz_delta = t54 + t168;
        M22_Jxz_delta = t42 * (t54 + M22_hz_delta);
        t173 = self.mH * t54;
        t174 = t48 * t168;
        t176 = t50 * t54;
        t179 = (self.mH * t176) + (t54 * t86);
        t182 = ((t14 * M22_Jxz_delta) + (M22_hz_delta * t179)) - (t173 * t174);
        t184 = t182 - (t96 * t168);
        t185 = self.w * yaw_by_delta;
        P_delta_yaw_w = (self.mF * t185) + (yaw_by_delta * t101);
        M22_yaw_by_delta = t115 + t117;
        M22_yaw_per_v_delta = self.c * M22_yaw_by_delta;
        t194 = (t184 + (yaw_by_delta * P_delta_yaw_w)) - (t164 * M22_yaw_per_v_delta);
        P_delta_theta_yaw_per_v_delta = self.c * Jxz_theta;
        t196 = t164 * P_delta_theta_yaw_per_v_delta;
        t197 = t14 * yaw_per_v_delta;
        t199 = t197 - (yaw_per_v_delta * Sz_delta);
        C112_yaw_per_v_delta = Jxz_all + (self.c * t135);
        t203 = t199 - (t164 * C112_yaw_per_v_delta);
        t204 = self.c * h_wheels_all;
        t205 = t164 * t204;
        K222_h_spin_F = t42 * yaw_per_v_delta;
        t209 = t48 * yaw_per_v_delta;
        t212 = ((t14 * K222_h_spin_F) + (yaw_per_v_delta * t179)) - (t173 * t209);
        t214 = t212 - (yaw_per_v_delta * t96);
        t217 = self.c * Sx_all;
        t220 = (t173 + (t164 * t217)) - (self.mF * yaw_by_delta);
        C122_yaw_by_delta = (yaw_per_v_delta * P_delta_yaw_yaw_by_delta) - t147;
        C122_yaw_per_v_delta = P_delta_yaw + (self.c * C122_yaw_by_delta);
        t229 = ((t214 + (yaw_per_v_delta * P_delta_yaw_w)) - (yaw_by_delta * t220))
            - (t164 * C122_yaw_per_v_delta);
        C132_yaw_per_v_delta = Jxz_theta - (Sz_theta * self.c);
        t232 = t164 * C132_yaw_per_v_delta;
        t233 = t42 * t220;
        t234 = t135 * t164;
        t237 = (yaw_per_v_delta * t220) + (K222_yaw_per_v_delta * t164);
        t238 = Sz_theta * t164;
        t241 = (t137 + t163) - (t18 * C112_h_spin_F);
        t244 = self.mF * t54;
        t246 = self.c * t54;
        hz_delta_c = (self.mF * t246) + (t54 * t84);
        t254 = (((t184 + (yaw_per_v_delta * M22_yaw_by_delta))
            + (M22_hz_delta * hz_delta_c)) - (t18 * M22_Jxz_delta)) - (t174 * t244);
        t257 = t199 + (yaw_per_v_delta * (t135 - t18));
        t258 = yaw_per_v_delta * h_wheels_all;
        t262 = yaw_per_v_delta * Sx_all;
        t263 = t173 + t244;
        P_delta_lateral_c = t262 - t263;
        t270 = (((t214 + (yaw_per_v_delta * (C122_yaw_by_delta + hz_delta_c)))
            + (yaw_by_delta * P_delta_lateral_c)) - (t18 * K222_h_spin_F))
            - (t209 * t244);
        t271 = t42 * P_delta_lateral_c;
        t272 = yaw_per_v_delta * P_delta_lateral_c;
        hx_delta_lam = (Jxx_delta * t54) - t81;
        t275 = t42 * t57;
        t277 = hx_delta_lam - (t165 * t275);
        t283 = (t54 * Sz_delta) - (t42 * t94);
        hz_delta_lam = t55 - (t42 * t89);
        t293 = (((((t42 * hx_delta_lam) + (t54 * hx_delta))
            + (M22_hz_delta * hz_delta_lam)) - (t42 * hz_delta)) - (t174 * t283))
            - (M22_yaw_per_v_delta * t275);
        t294 = P_delta_theta_yaw_per_v_delta * t275;
        t296 = t156 + (C112_yaw_per_v_delta * t275);
        t298 = t156 + (t204 * t275);
        t301 = t283 + (t217 * t275);
        t307 = (((yaw_per_v_delta * hz_delta_lam) - (yaw_by_delta * t301))
            - (t209 * t283)) - (C122_yaw_per_v_delta * t275);
        t308 = C132_yaw_per_v_delta * t275;
        t311 = (t42 * t301) + (t54 * t147);
        t312 = t135 * t275;
        t316 = (yaw_per_v_delta * (t127 - t301)) - (K222_yaw_per_v_delta * t275);
        t317 = Sz_theta * t275;
        t318 = t25 + t25;
        t319 = t129 * t130;
        t320 = self.mR - t319;
        t321 = yaw_by_delta * t320;
        t322 = yaw_by_delta * t319;
        t323 = yaw_per_v_delta * t320;
        t324 = self.rR * self.rR;
        t325 = self.rR * yaw_by_delta;
        t326 = self.rR * yaw_per_v_delta;
        t328 = yaw_by_delta * yaw_by_delta;
        t329 = yaw_per_v_delta * yaw_by_delta;
        t330 = yaw_by_delta * t129;
        t331 = yaw_per_v_delta * t129;
        t332 = t29 * yaw_by_delta;
        t333 = yaw_by_delta * self.xB;
        t334 = self.mB * t333;
        P_delta_yaw_xB = t334 + (yaw_by_delta * t103);
        t337 = yaw_by_delta * P_delta_yaw_xB;
        t338 = t29 * yaw_per_v_delta;
        t340 = self.mB * yaw_by_delta;
        t342 = (yaw_per_v_delta * P_delta_yaw_xB) + (yaw_by_delta * t340);
        t343 = t42 * t340;
        t344 = yaw_per_v_delta * t340;
        t345 = t29 + t29;
        t347 = yaw_by_delta + (yaw_per_v_delta * self.xB);
        t348 = self.mB * t347;
        t349 = self.mB * yaw_per_v_delta;
        t350 = self.zB * self.zB;
        t351 = self.zB * t333;
        P_delta_yaw_mB = self.xB * t333;
        t353 = yaw_by_delta * P_delta_yaw_mB;
        t354 = self.zB * t347;
        t357 = (yaw_per_v_delta * P_delta_yaw_mB) + (yaw_by_delta * t333);
        t358 = t42 * t333;
        t359 = self.zB * yaw_per_v_delta;
        t360 = yaw_per_v_delta * t333;
        t361 = self.xH * yaw_by_delta;
        t362 = yaw_by_delta * t361;
        P_delta_yaw_xH = yaw_by_delta * t105;
        t367 = ((self.mH * t362) + (yaw_by_delta * P_delta_yaw_xH)) - t182;
        t368 = yaw_per_v_delta * t361;
        P_delta_lateral_xH = t173 + (self.mH * yaw_by_delta);
        t376 = (((self.mH * t368) + (yaw_per_v_delta * P_delta_yaw_xH))
            + (yaw_by_delta * P_delta_lateral_xH)) - t212;
        t377 = t42 * P_delta_lateral_xH;
        t378 = yaw_per_v_delta * P_delta_lateral_xH;
        t379 = t14 + t14;
        t380 = t48 * yaw_by_delta;
        t381 = self.zH * t42;
        t384 = (t381 + (t50 * C112_h_spin_F)) - t380;
        t387 = (self.mH * t384) + (t14 * t42);
        t388 = t42 * t174;
        M22_Jxx_delta = t42 * t42;
        t393 = ((self.zH * M22_Jxx_delta) + (t50 * M22_Jxz_delta)) - t388;
        t396 = (self.mH * t393) + (t14 * M22_Jxx_delta);
        t398 = yaw_by_delta + t209;
        t399 = (t50 * yaw_per_v_delta) - t398;
        t400 = self.mH * t399;
        t401 = t42 * t209;
        t403 = (t50 * K222_h_spin_F) - t401;
        t405 = self.mH * t42;
        t407 = (self.mH * t403) - (yaw_by_delta * t405);
        t408 = t42 * t405;
        t409 = self.mH * yaw_per_v_delta;
        t410 = yaw_per_v_delta * t405;
        t411 = self.zH * self.zH;
        t412 = self.zH * t384;
        hz_delta_mH = t50 * t176;
        t420 = (((self.xH * t362) + (self.zH * t393)) + (M22_hz_delta * hz_delta_mH))
            - (t174 * t176);
        t421 = self.zH * t399;
        t426 = (t176 + t381) - t361;
        t432 = ((((self.xH * t368) + (self.zH * t403)) + (yaw_per_v_delta * hz_delta_mH))
            - (yaw_by_delta * t426)) - (t176 * t209);
        t433 = t42 * t426;
        t434 = self.zH * yaw_per_v_delta;
        t435 = yaw_per_v_delta * t426;
        t437 = t328 + (t54 * M22_hz_delta);
        t438 = yaw_per_v_delta * C112_h_spin_F;
        t439 = t18 + t18;
        t441 = self.rF * t42;
        t443 = (t380 + t441) - (self.c * C112_h_spin_F);
        t446 = (self.mF * t443) + (t18 * t42);
        t450 = (t388 + (self.rF * M22_Jxx_delta)) - (self.c * M22_Jxz_delta);
        t453 = (self.mF * t450) + (t18 * M22_Jxx_delta);
        t454 = t398 - yaw_by_delta;
        t456 = t125 * h_spin_F;
        t457 = C112_h_spin_F * t456;
        t458 = (self.mF * t454) - t457;
        t460 = (self.c * K222_h_spin_F) - t401;
        P_delta_lateral_rF = self.mF * t42;
        t464 = (yaw_by_delta * P_delta_lateral_rF) - (self.mF * t460);
        t465 = t42 * P_delta_lateral_rF;
        t467 = yaw_per_v_delta * (self.mF - t456);
        t470 = (yaw_per_v_delta * P_delta_lateral_rF) - (K222_h_spin_F * t456);
        t471 = self.rF * self.rF;
        t472 = self.rF * t443;
        P_delta_yaw_mF = self.w * t185;
        hz_delta_mF = self.c * t246;
        t481 = (((self.rF * t450) + (yaw_by_delta * P_delta_yaw_mF))
            + (M22_hz_delta * hz_delta_mF)) - (t174 * t246);
        t482 = self.rF * t454;
        t487 = (t246 - t185) - t441;
        t492 = (((yaw_per_v_delta * (P_delta_yaw_mF + hz_delta_mF)) - (self.rF * t460))
            - (yaw_by_delta * t487)) - (t209 * t246);
        t494 = self.rF * yaw_per_v_delta;
        t496 = M22_Jxx_delta + t437;
        t497 = t125 * C112_h_spin_F;
        t498 = yaw_per_v_delta * t125;
        t499 = t125 * K222_h_spin_F;
        t500 = Sz_theta + Sz_theta;
        t501 = t31 + t500;
        t502 = Sz_theta - t501;
        t503 = yaw_by_delta * Sx_theta;
        t505 = self.mU * yaw_by_delta;
        t506 = (yaw_per_v_delta * Sx_theta) + t505;
        t507 = self.mU * yaw_per_v_delta;
        let (
            Jxx_theta_mU,
            t509,
            t512,
            t513,
            t514,
            t516,
            P_delta_yaw_Sx_theta,
            P_delta_yaw_mU,
            t519,
            t520,
            t521,
            t524,
            t527,
            t528,
            t530,
            t531,
            t532,
            t533,
            t534,
            t535,
            P_delta_yaw_xU,
            t538,
            t539,
            t540,
            t543,
            t544,
            t545,
            t546,
            t547,
            t548,
            t549,
            t550,
            t551,
            t552,
        );
        Jxx_theta_mU = t5 * t5;
        t509 = self.zP + t5;
        t512 = Jxx_theta_mU + (self.zP * (t5 + t509));
        t513 = self.xU * t509;
        t514 = yaw_by_delta * t513;
        t516 = Jxx_theta_mU + (self.zP * t5);
        P_delta_yaw_Sx_theta = yaw_by_delta * self.xU;
        P_delta_yaw_mU = self.xU * P_delta_yaw_Sx_theta;
        t519 = yaw_by_delta * P_delta_yaw_mU;
        t520 = t5 * yaw_by_delta;
        t521 = self.xU * t520;
        t524 = (yaw_by_delta * t509) + (yaw_per_v_delta * t513);
        t527 = (yaw_per_v_delta * P_delta_yaw_mU)
            + (yaw_by_delta * P_delta_yaw_Sx_theta);
        t528 = t5 * yaw_per_v_delta;
        t530 = t520 + (self.xU * t528);
        t531 = t42 * P_delta_yaw_Sx_theta;
        t532 = yaw_per_v_delta * t509;
        t533 = yaw_per_v_delta * P_delta_yaw_Sx_theta;
        t534 = self.mU * t509;
        t535 = yaw_by_delta * t534;
        P_delta_yaw_xU = t503 + (self.mU * P_delta_yaw_Sx_theta);
        t538 = yaw_by_delta * P_delta_yaw_xU;
        t539 = self.mU * t520;
        t540 = yaw_per_v_delta * t534;
        t543 = (yaw_per_v_delta * P_delta_yaw_xU) + (yaw_by_delta * t505);
        t544 = self.mU * t528;
        t545 = t42 * t505;
        t546 = yaw_per_v_delta * t505;
        t547 = t31 + t501;
        t548 = -(t127 + (yaw_by_delta * h_wheels_all));
        t549 = -t159;
        t550 = t263 - t262;
        t551 = -(t42 * t487);
        t552 = -(yaw_per_v_delta * t487);
        (
            {
                #[inline(always)]
                fn matrix<T: ::core::marker::Copy>(
                    entries: &[T; 54],
                    first: ::core::primitive::usize,
                ) -> [[T; 3]; 3] {
                    [
                        [entries[first], entries[first + 1], entries[first + 2]],
                        [entries[first + 3], entries[first + 4], entries[first + 5]],
                        [entries[first + 6], entries[first + 7], entries[first + 8]],
                    ]
                }
                let entries = [
                    t40,
                    t77,
                    M_phi_theta,
                    t77,
                    t120,
                    P_delta_theta,
                    M_phi_theta,
                    P_delta_theta,
                    Jxx_theta,
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    self.dU,
                    ::carvallo::Number::like(self.w, 0.0),
                    t139,
                    ::carvallo::Number::like(self.w, 0.0),
                    t548,
                    t149,
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    t152,
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    self.kU,
                    Sz_all,
                    t147,
                    Sz_theta,
                    t147,
                    t154,
                    ::carvallo::Number::like(self.w, 0.0),
                    Sz_theta,
                    ::carvallo::Number::like(self.w, 0.0),
                    Sz_theta,
                    ::carvallo::Number::like(self.w, 0.0),
                    t155,
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    t158,
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                    t549,
                    ::carvallo::Number::like(self.w, 0.0),
                ];
                WhippleLeaningMatrices {
                    m: matrix(&entries, 0),
                    c0: matrix(&entries, 9),
                    c1: matrix(&entries, 18),
                    kc: matrix(&entries, 27),
                    k0: matrix(&entries, 36),
                    k2: matrix(&entries, 45),
                }
            },
            WhippleLeaningDerivatives {
                values: [
                    t167,
                    t194,
                    t196,
                    t203,
                    t205,
                    t229,
                    t232,
                    t220,
                    t233,
                    t234,
                    t237,
                    t238,
                    t241,
                    t254,
                    t151,
                    t257,
                    t258,
                    t270,
                    t159,
                    t550,
                    t271,
                    t272,
                    t277,
                    t293,
                    t294,
                    t296,
                    t298,
                    t307,
                    t308,
                    t301,
                    t311,
                    t312,
                    t316,
                    t317,
                    t318,
                    t321,
                    t322,
                    self.mR,
                    t323,
                    t324,
                    t325,
                    self.rR,
                    t326,
                    ::carvallo::Number::like(self.w, 1.0),
                    t328,
                    t329,
                    t330,
                    t331,
                    t332,
                    t337,
                    t338,
                    t342,
                    t340,
                    t343,
                    t344,
                    t345,
                    t334,
                    t348,
                    self.mB,
                    t349,
                    t350,
                    t351,
                    t353,
                    t354,
                    t357,
                    self.zB,
                    t333,
                    t358,
                    t359,
                    t360,
                    yaw_by_delta,
                    yaw_per_v_delta,
                    t161,
                    t367,
                    t197,
                    t376,
                    P_delta_lateral_xH,
                    t377,
                    t378,
                    t379,
                    t387,
                    t396,
                    t400,
                    t407,
                    self.mH,
                    t405,
                    t408,
                    t409,
                    t410,
                    t411,
                    t412,
                    t420,
                    t421,
                    t432,
                    self.zH,
                    t426,
                    t433,
                    t434,
                    t435,
                    t42,
                    M22_Jxx_delta,
                    t437,
                    t438,
                    C112_h_spin_F,
                    M22_Jxz_delta,
                    K222_h_spin_F,
                    t439,
                    t446,
                    t453,
                    t458,
                    t457,
                    t464,
                    self.mF,
                    P_delta_lateral_rF,
                    t465,
                    t467,
                    t470,
                    t471,
                    t472,
                    t481,
                    t482,
                    t492,
                    self.rF,
                    t487,
                    t551,
                    t494,
                    t552,
                    t496,
                    t497,
                    t498,
                    t499,
                    t502,
                    t503,
                    t500,
                    t506,
                    self.mU,
                    t507,
                    t512,
                    t514,
                    t516,
                    t519,
                    t521,
                    Jxx_theta_mU,
                    t524,
                    t527,
                    t530,
                    t509,
                    P_delta_yaw_Sx_theta,
                    t5,
                    t531,
                    t532,
                    t533,
                    t528,
                    t535,
                    t538,
                    t539,
                    t540,
                    t543,
                    t544,
                    t505,
                    t545,
                    t546,
                    t547,
                    t501,
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
            ::carvallo::Partial::write(
                &<WhippleLeaningDerivatives>::PARTIALS[position],
                &derivatives.values,
                &mut all,
            );
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
