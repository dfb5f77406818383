// @generated from generated/models/whipple_leaning.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 40e1047ae9981d57

#![allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    LengthError, MatrixName, Model, ModelInfo, Number, ParameterError, ParameterInfo,
    Partial, Rate, Scalar, SetInfo,
};

// --- The parameters ------------------------------------------------------------------------------

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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleLeaning<T = f64> {
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

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`WhippleLeaning`], each 3 x 3 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleLeaningMatrices<T = f64> {
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

impl<T: Number> WhippleLeaning<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 62 additions, 60 multiplications, 3 divisions, 3 negations and 2 trigonometric functions: 130 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleLeaningMatrices<T> {
        let t5 = self.zU - self.zP;
        let Sz_theta = t5 * self.mU;
        let Jxx_theta = self.IUxx + t5 * Sz_theta;
        let t14 = self.zH * self.mH;
        let t18 = self.rF * self.mF;
        let Jxx_delta = self.IHxx + self.IFxx + self.zH * t14 + self.rF * t18;
        let t25 = self.rR * self.mR;
        let t29 = self.zB * self.mB;
        let t32 = Sz_theta + self.zP * self.mU;
        let t40 = self.IRxx + self.IBxx + Jxx_theta + Jxx_delta + self.rR * t25
            + self.zB * t29 + self.zP * (Sz_theta + t32);
        let (t42, t54) = self.lam.sin_cos();
        let t49 = self.c + self.w;
        let t50 = t49 - self.xH;
        let Jxz_delta = self.IHxz + t14 * t50 - t18 * self.c;
        let hx_delta = Jxx_delta * t42 + Jxz_delta * t54;
        let yaw_per_v_delta = t54 / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let Sx_theta = self.mU * self.xU;
        let Jxz_theta = self.IUxz - t5 * Sx_theta;
        let Sz_delta = t14 - t18;
        let Jxz_all = Jxz_delta + self.IBxz + Jxz_theta - t29 * self.xB
            - self.zP * Sx_theta - t49 * Sz_delta;
        let t76 = hx_delta + yaw_by_delta * Jxz_all;
        let M_phi_theta = Jxx_theta + self.zP * Sz_theta;
        let t80 = self.mH * t50;
        let t82 = self.mF * self.c;
        let t85 = self.IFxx + self.IHzz;
        let hz_delta = t42 * Jxz_delta + t54 * (t50 * t80 + self.c * t82 + t85);
        let t91 = t80 + t82;
        let t93 = t42 * Sz_delta + t54 * t91;
        let M_yaw_delta = hz_delta - t49 * t93;
        let t98 = self.mB * self.xB;
        let t110 = self.IRxx + t85 + self.IBzz + self.IUzz + self.xB * t98
            + self.mH * self.xH * self.xH + self.mF * self.w * self.w;
        let P_delta_yaw = M_yaw_delta + yaw_by_delta * (t110 + self.xU * Sx_theta);
        let t119 = yaw_by_delta * (M_yaw_delta + P_delta_yaw) + t42 * hx_delta
            + t54 * hz_delta;
        let P_delta_theta = yaw_by_delta * Jxz_theta;
        let h_spin_F = self.IFyy / self.rF;
        let h_wheels_all = h_spin_F + self.IRyy / self.rR;
        let Sz_all = t29 + t32 + Sz_delta - t25;
        let t131 = h_wheels_all - Sz_all;
        let t134 = t54 * h_spin_F;
        let t136 = yaw_by_delta * t131 + yaw_per_v_delta * Jxz_all + t134;
        let Sx_all = Sx_theta + t98 + t49 * (self.mH + self.mF) - t91;
        let t144 = yaw_by_delta * Sx_all;
        let P_delta_lateral = t144 - t93;
        let t148 = yaw_by_delta * P_delta_lateral + yaw_per_v_delta * P_delta_yaw;
        let t151 = yaw_per_v_delta * Jxz_theta - Sz_theta * yaw_by_delta;
        let t154 = yaw_per_v_delta * t131;
        let t157 = yaw_per_v_delta * (P_delta_lateral + t42 * h_spin_F);
        let t159 = -(t134 + yaw_by_delta * h_wheels_all);
        let t160 = t93 - t144;
        let t161 = -(t42 * P_delta_lateral);
        let t162 = -(Sz_theta * yaw_per_v_delta);
        WhippleLeaningMatrices::from_entries([
            t40, t76, M_phi_theta, t76, t119, P_delta_theta, M_phi_theta, P_delta_theta, Jxx_theta,
            self.w.like(0.0), self.w.like(0.0), self.w.like(0.0), self.w.like(0.0),
            self.w.like(0.0), self.w.like(0.0), self.w.like(0.0), self.w.like(0.0), self.dU,
            self.w.like(0.0), t136, self.w.like(0.0), t159, t148, self.w.like(0.0),
            self.w.like(0.0), t151, self.w.like(0.0), self.w.like(0.0), self.w.like(0.0),
            self.w.like(0.0), self.w.like(0.0), self.w.like(0.0), self.w.like(0.0),
            self.w.like(0.0), self.w.like(0.0), self.kU, Sz_all, t160, Sz_theta, t160, t161,
            self.w.like(0.0), Sz_theta, self.w.like(0.0), Sz_theta, self.w.like(0.0), t154,
            self.w.like(0.0), self.w.like(0.0), t157, self.w.like(0.0), self.w.like(0.0), t162,
            self.w.like(0.0),
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`WhippleLeaning`] that follow from its coordinates q = (`phi`, `delta`, `theta`), to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleLeaningKinematics<T = f64> {
    /// Lateral velocity, to the right, in m/s: of the point of `B` that is at the origin.
    pub lateral: Rate<T, 3>,
    /// Yaw rate, to the right, in rad/s: of `B`.
    pub yaw: Rate<T, 3>,
    /// Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_R: Rate<T, 3>,
    /// Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_F: Rate<T, 3>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of `Tphi` (lean torque) in N*m, `Tdelta` (steer torque) in N*m, `Ttheta` (hip torque) in N*m.
    pub forces: [[T; 3]; 3],
}

impl<T: Scalar> WhippleLeaning<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> WhippleLeaningKinematics<T> {
        let yaw_per_v_delta = self.lam.cos() / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let t12 = -(self.w.like(1.0) / self.rR);
        let t13 = -(self.w.like(1.0) / self.rF);
        WhippleLeaningKinematics {
            lateral: Rate {
                speed: self.w.like(0.0),
                rates: [self.w.like(0.0), self.w.like(0.0), self.w.like(0.0)],
                coordinates: [self.w.like(0.0), self.w.like(0.0), self.w.like(0.0)],
                heading: self.w.like(1.0),
            },
            yaw: Rate {
                speed: self.w.like(0.0),
                rates: [self.w.like(0.0), yaw_by_delta, self.w.like(0.0)],
                coordinates: [self.w.like(0.0), yaw_per_v_delta, self.w.like(0.0)],
                heading: self.w.like(0.0),
            },
            wheel_R: Rate {
                speed: t12,
                rates: [self.w.like(0.0), self.w.like(0.0), self.w.like(0.0)],
                coordinates: [self.w.like(0.0), self.w.like(0.0), self.w.like(0.0)],
                heading: self.w.like(0.0),
            },
            wheel_F: Rate {
                speed: t13,
                rates: [self.w.like(0.0), self.w.like(0.0), self.w.like(0.0)],
                coordinates: [self.w.like(0.0), self.w.like(0.0), self.w.like(0.0)],
                heading: self.w.like(0.0),
            },
            forces: [
                [self.w.like(1.0), self.w.like(0.0), self.w.like(0.0)],
                [self.w.like(0.0), self.w.like(1.0), self.w.like(0.0)],
                [self.w.like(0.0), self.w.like(0.0), self.w.like(1.0)],
            ],
        }
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`WhippleLeaning`] with respect to its parameters, in SI units: those that are not
/// zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleLeaningDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 164],
}

impl<T: Number> WhippleLeaning<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 196 additions, 308 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 511 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WhippleLeaningMatrices<T>, WhippleLeaningDerivatives<T>) {
        let (
            t5, Sz_theta, Jxx_theta, t14, t18, Jxx_delta, t25, t29, t31, t32, t40, t42, t54, t48,
            t50, Jxz_delta, t55, hx_delta, t57, yaw_per_v_delta, yaw_by_delta, Sx_theta, Jxz_theta,
            Sz_delta, Jxz_all, t77, M_phi_theta, t81, t83, t84, t86, t89, hz_delta, t94, t96,
            M_yaw_delta, t101, t103, t105, t113, P_delta_yaw_yaw_by_delta, t115, P_delta_yaw, t117,
            t120, P_delta_theta, t125, h_spin_F, t127, t129, t130, h_wheels_all, Sz_all, t135, t137,
            t139, Sx_all, t149, t151, t153, t154, t156, t157, t158, K222_yaw_per_v_delta, t160,
            t161, C112_h_spin_F, t163, t165, t166, M12_yaw_per_v_delta, t169, t170, M22_Jxz_delta,
            t173, t176, t178, t179, t180, t181, t182, t183, M_yaw_delta_w, t185, P_delta_yaw_w,
            t188, M22_yaw_by_delta, M22_yaw_per_v_delta, t195, P_delta_theta_yaw_per_v_delta, t197,
            t198, t200, C112_yaw_per_v_delta, t204, t205, t206, t209, t212, C122_yaw_by_delta,
            C122_yaw_per_v_delta, t220, C132_yaw_per_v_delta, t223, t224, t225, t228, t229, t232,
            t234, hz_delta_c, t238, t240, M_yaw_delta_c, t251, t254, t255, t259, t261, t262, t263,
            hx_delta_lam, t266, t268, hz_delta_lam, t273, M_yaw_delta_lam, t286, t287, t289, t291,
            t294, t298, t299, t302, t303, t307, t308, t309, t310, t311, t312, t313, t314, t315,
            t316, t317, t319, t320, t321, t322, t323, t324, t325, P_delta_yaw_xB, t328, t329, t331,
            t333, t334, t335, t336, t338, t339, t340, t341, t342, P_delta_yaw_mB, t344, t345, t348,
            t349, t350, t351, M_yaw_delta_xH, P_delta_yaw_xH, t355, t358, P_delta_lateral_xH, t363,
            t364, t365, t366, t367, t369, t371, t373, t374, t376, M_yaw_delta_zH, M22_Jxx_delta,
            t383, t387, t389, t391, t392, t395, t396, t397, t398, t399, t400, hz_delta_mH, t404,
            M_yaw_delta_mH, P_delta_yaw_mH, t410, t414, t415, t419, t421, t422, t423, t424, t428,
            t430, t432, K222_h_spin_F, t434, t436, t438, t440, t441, t443, M_yaw_delta_rF, t449,
            t453, t454, t456, t457, t458, t461, t462, t464, t467, t468, t469, hz_delta_mF, t473,
            M_yaw_delta_mF, P_delta_yaw_mF, t479, t483, t484, t488, t490, t491, t492, t493, t494,
        );
        t5 = self.zU - self.zP;
        Sz_theta = t5 * self.mU;
        Jxx_theta = self.IUxx + t5 * Sz_theta;
        t14 = self.zH * self.mH;
        t18 = self.rF * self.mF;
        Jxx_delta = self.IHxx + self.IFxx + self.zH * t14 + self.rF * t18;
        t25 = self.rR * self.mR;
        t29 = self.zB * self.mB;
        t31 = self.zP * self.mU;
        t32 = Sz_theta + t31;
        t40 = self.IRxx + self.IBxx + Jxx_theta + Jxx_delta + self.rR * t25
            + self.zB * t29 + self.zP * (Sz_theta + t32);
        (t42, t54) = self.lam.sin_cos();
        t48 = self.c + self.w;
        t50 = t48 - self.xH;
        Jxz_delta = self.IHxz + t14 * t50 - t18 * self.c;
        t55 = Jxz_delta * t54;
        hx_delta = Jxx_delta * t42 + t55;
        t57 = self.w.like(1.0) / self.w;
        yaw_per_v_delta = t54 * t57;
        yaw_by_delta = self.c * yaw_per_v_delta;
        Sx_theta = self.mU * self.xU;
        Jxz_theta = self.IUxz - t5 * Sx_theta;
        Sz_delta = t14 - t18;
        Jxz_all = Jxz_delta + self.IBxz + Jxz_theta - t29 * self.xB - self.zP * Sx_theta
            - t48 * Sz_delta;
        t77 = hx_delta + yaw_by_delta * Jxz_all;
        M_phi_theta = Jxx_theta + self.zP * Sz_theta;
        t81 = t42 * Jxz_delta;
        t83 = self.IFxx + self.IHzz;
        t84 = self.mF * self.c;
        t86 = self.mH * t50;
        t89 = t83 + self.c * t84 + t50 * t86;
        hz_delta = t81 + t54 * t89;
        t94 = t84 + t86;
        t96 = t42 * Sz_delta + t54 * t94;
        M_yaw_delta = hz_delta - t48 * t96;
        t101 = self.mB * self.xB;
        t103 = self.xH * self.xH;
        t105 = self.w * self.w;
        t113 = self.IRxx + t83 + self.IBzz + self.IUzz + self.xB * t101 + self.mH * t103
            + self.mF * t105;
        P_delta_yaw_yaw_by_delta = t113 + self.xU * Sx_theta;
        t115 = yaw_by_delta * P_delta_yaw_yaw_by_delta;
        P_delta_yaw = M_yaw_delta + t115;
        t117 = M_yaw_delta + P_delta_yaw;
        t120 = t42 * hx_delta + t54 * hz_delta + yaw_by_delta * t117;
        P_delta_theta = yaw_by_delta * Jxz_theta;
        t125 = self.w.like(1.0) / self.rF;
        h_spin_F = self.IFyy * t125;
        t127 = t54 * h_spin_F;
        t129 = self.w.like(1.0) / self.rR;
        t130 = self.IRyy * t129;
        h_wheels_all = h_spin_F + t130;
        Sz_all = t29 + t32 + Sz_delta - t25;
        t135 = h_wheels_all - Sz_all;
        t137 = yaw_per_v_delta * Jxz_all;
        t139 = t127 + yaw_by_delta * t135 + t137;
        Sx_all = Sx_theta + t101 + t48 * (self.mH + self.mF) - t94;
        t149 = t96 - yaw_by_delta * Sx_all;
        t151 = yaw_per_v_delta * P_delta_yaw - yaw_by_delta * t149;
        t153 = yaw_per_v_delta * Jxz_theta;
        t154 = t153 - Sz_theta * yaw_by_delta;
        t156 = t42 * t149;
        t157 = yaw_per_v_delta * t135;
        t158 = t42 * h_spin_F;
        K222_yaw_per_v_delta = t158 - t149;
        t160 = yaw_per_v_delta * K222_yaw_per_v_delta;
        t161 = Sz_theta * yaw_per_v_delta;
        C112_h_spin_F = t54 + yaw_by_delta;
        t163 = t14 * C112_h_spin_F;
        t165 = t163 - yaw_by_delta * Sz_delta;
        t166 = t57 * yaw_per_v_delta;
        M12_yaw_per_v_delta = self.c * Jxz_all;
        t169 = t165 - t166 * M12_yaw_per_v_delta;
        t170 = t42 * t54;
        M22_Jxz_delta = t170 + t170;
        t173 = t50 * t54;
        t176 = self.mH * t173 + t54 * t86;
        t178 = t14 * M22_Jxz_delta + t54 * t176;
        t179 = t14 * t42;
        t180 = t176 + t179;
        t181 = t180 - t96;
        t182 = self.mH * t54;
        t183 = t48 * t182;
        M_yaw_delta_w = t181 - t183;
        t185 = yaw_by_delta + yaw_by_delta;
        P_delta_yaw_w = self.mF * self.w * t185;
        t188 = M_yaw_delta_w + P_delta_yaw_w;
        M22_yaw_by_delta = t115 + t117;
        M22_yaw_per_v_delta = self.c * M22_yaw_by_delta;
        t195 = t178 + yaw_by_delta * (M_yaw_delta_w + t188) - t166 * M22_yaw_per_v_delta;
        P_delta_theta_yaw_per_v_delta = self.c * Jxz_theta;
        t197 = t166 * P_delta_theta_yaw_per_v_delta;
        t198 = t14 * yaw_per_v_delta;
        t200 = t198 - yaw_per_v_delta * Sz_delta;
        C112_yaw_per_v_delta = Jxz_all + self.c * t135;
        t204 = t200 - t166 * C112_yaw_per_v_delta;
        t205 = self.c * h_wheels_all;
        t206 = t166 * t205;
        t209 = self.c * Sx_all;
        t212 = t182 + t166 * t209 - self.mF * yaw_by_delta;
        C122_yaw_by_delta = yaw_per_v_delta * P_delta_yaw_yaw_by_delta - t149;
        C122_yaw_per_v_delta = P_delta_yaw + self.c * C122_yaw_by_delta;
        t220 = yaw_per_v_delta * t188 - yaw_by_delta * t212
            - t166 * C122_yaw_per_v_delta;
        C132_yaw_per_v_delta = Jxz_theta - Sz_theta * self.c;
        t223 = t166 * C132_yaw_per_v_delta;
        t224 = t42 * t212;
        t225 = t135 * t166;
        t228 = yaw_per_v_delta * t212 + K222_yaw_per_v_delta * t166;
        t229 = Sz_theta * t166;
        t232 = t137 + t165 - t18 * C112_h_spin_F;
        t234 = self.c * t54;
        hz_delta_c = self.mF * t234 + t54 * t84;
        t238 = t18 * t42;
        t240 = t182 + self.mF * t54;
        M_yaw_delta_c = t181 + hz_delta_c - t238 - t48 * t240;
        t251 = t178 + t185 * M_yaw_delta_c + t54 * hz_delta_c
            + yaw_per_v_delta * M22_yaw_by_delta - t18 * M22_Jxz_delta;
        t254 = t200 + yaw_per_v_delta * (t135 - t18);
        t255 = yaw_per_v_delta * h_wheels_all;
        t259 = t240 - yaw_per_v_delta * Sx_all;
        t261 = yaw_per_v_delta * (C122_yaw_by_delta + M_yaw_delta_c)
            - yaw_by_delta * t259;
        t262 = t42 * t259;
        t263 = yaw_per_v_delta * t259;
        hx_delta_lam = Jxx_delta * t54 - t81;
        t266 = t42 * t57;
        t268 = hx_delta_lam - M12_yaw_per_v_delta * t266;
        hz_delta_lam = t55 - t42 * t89;
        t273 = t54 * Sz_delta - t42 * t94;
        M_yaw_delta_lam = hz_delta_lam - t48 * t273;
        t286 = t185 * M_yaw_delta_lam + t42 * hx_delta_lam + t54 * hz_delta_lam
            + t54 * hx_delta - t42 * hz_delta - M22_yaw_per_v_delta * t266;
        t287 = P_delta_theta_yaw_per_v_delta * t266;
        t289 = t158 + C112_yaw_per_v_delta * t266;
        t291 = t158 + t205 * t266;
        t294 = t273 + t209 * t266;
        t298 = yaw_per_v_delta * M_yaw_delta_lam - yaw_by_delta * t294
            - C122_yaw_per_v_delta * t266;
        t299 = C132_yaw_per_v_delta * t266;
        t302 = t42 * t294 + t54 * t149;
        t303 = t135 * t266;
        t307 = yaw_per_v_delta * (t127 - t294) - K222_yaw_per_v_delta * t266;
        t308 = Sz_theta * t266;
        t309 = t25 + t25;
        t310 = t129 * t130;
        t311 = self.mR - t310;
        t312 = yaw_by_delta * t311;
        t313 = yaw_by_delta * t310;
        t314 = yaw_per_v_delta * t311;
        t315 = self.rR * self.rR;
        t316 = self.rR * yaw_by_delta;
        t317 = self.rR * yaw_per_v_delta;
        t319 = yaw_by_delta * yaw_by_delta;
        t320 = yaw_per_v_delta * yaw_by_delta;
        t321 = yaw_by_delta * t129;
        t322 = yaw_per_v_delta * t129;
        t323 = t29 * yaw_by_delta;
        t324 = yaw_by_delta * self.xB;
        t325 = self.mB * t324;
        P_delta_yaw_xB = t325 + yaw_by_delta * t101;
        t328 = yaw_by_delta * P_delta_yaw_xB;
        t329 = t29 * yaw_per_v_delta;
        t331 = self.mB * yaw_by_delta;
        t333 = yaw_per_v_delta * P_delta_yaw_xB + yaw_by_delta * t331;
        t334 = t42 * t331;
        t335 = yaw_per_v_delta * t331;
        t336 = t29 + t29;
        t338 = yaw_by_delta + yaw_per_v_delta * self.xB;
        t339 = self.mB * t338;
        t340 = self.mB * yaw_per_v_delta;
        t341 = self.zB * self.zB;
        t342 = self.zB * t324;
        P_delta_yaw_mB = self.xB * t324;
        t344 = yaw_by_delta * P_delta_yaw_mB;
        t345 = self.zB * t338;
        t348 = yaw_per_v_delta * P_delta_yaw_mB + yaw_by_delta * t324;
        t349 = t42 * t324;
        t350 = self.zB * yaw_per_v_delta;
        t351 = yaw_per_v_delta * t324;
        M_yaw_delta_xH = t183 - t180;
        P_delta_yaw_xH = self.mH * self.xH * t185;
        t355 = M_yaw_delta_xH + P_delta_yaw_xH;
        t358 = yaw_by_delta * (M_yaw_delta_xH + t355) - t178;
        P_delta_lateral_xH = t182 + self.mH * yaw_by_delta;
        t363 = yaw_per_v_delta * t355 + yaw_by_delta * P_delta_lateral_xH;
        t364 = t42 * P_delta_lateral_xH;
        t365 = yaw_per_v_delta * P_delta_lateral_xH;
        t366 = t14 + t14;
        t367 = t48 * yaw_by_delta;
        t369 = self.zH * t42;
        t371 = t50 * C112_h_spin_F + t369 - t367;
        t373 = t179 + self.mH * t371;
        t374 = self.mH * t42;
        t376 = t42 * t50;
        M_yaw_delta_zH = self.mH * t376 - t48 * t374;
        M22_Jxx_delta = t42 * t42;
        t383 = self.zH * M22_Jxx_delta + t50 * M22_Jxz_delta;
        t387 = t185 * M_yaw_delta_zH + self.mH * t383 + t14 * M22_Jxx_delta;
        t389 = yaw_by_delta + t48 * yaw_per_v_delta;
        t391 = t50 * yaw_per_v_delta - t389;
        t392 = self.mH * t391;
        t395 = yaw_per_v_delta * M_yaw_delta_zH - yaw_by_delta * t374;
        t396 = t42 * t374;
        t397 = self.mH * yaw_per_v_delta;
        t398 = yaw_per_v_delta * t374;
        t399 = self.zH * self.zH;
        t400 = self.zH * t371;
        hz_delta_mH = t50 * t173;
        t404 = t173 + t369;
        M_yaw_delta_mH = hz_delta_mH + self.zH * t376 - t48 * t404;
        P_delta_yaw_mH = yaw_by_delta * t103;
        t410 = M_yaw_delta_mH + P_delta_yaw_mH;
        t414 = self.zH * t383 + t54 * hz_delta_mH
            + yaw_by_delta * (M_yaw_delta_mH + t410);
        t415 = self.zH * t391;
        t419 = t404 - yaw_by_delta * (t48 - t50);
        t421 = yaw_per_v_delta * t410 - yaw_by_delta * t419;
        t422 = t42 * t419;
        t423 = self.zH * yaw_per_v_delta;
        t424 = yaw_per_v_delta * t419;
        t428 = t319 + t54 * t54 + t54 * t185;
        t430 = t320 + t54 * yaw_per_v_delta;
        t432 = M22_Jxz_delta + t42 * t185;
        K222_h_spin_F = t42 * yaw_per_v_delta;
        t434 = t18 + t18;
        t436 = self.rF * t42;
        t438 = t367 + t436 - self.c * C112_h_spin_F;
        t440 = t238 + self.mF * t438;
        t441 = self.mF * t42;
        t443 = t42 * self.c;
        M_yaw_delta_rF = t48 * t441 - self.mF * t443;
        t449 = self.rF * M22_Jxx_delta - self.c * M22_Jxz_delta;
        t453 = t185 * M_yaw_delta_rF + self.mF * t449 + t18 * M22_Jxx_delta;
        t454 = t389 - yaw_by_delta;
        t456 = t125 * h_spin_F;
        t457 = C112_h_spin_F * t456;
        t458 = self.mF * t454 - t457;
        t461 = yaw_by_delta * t441 + yaw_per_v_delta * M_yaw_delta_rF;
        t462 = t42 * t441;
        t464 = yaw_per_v_delta * (self.mF - t456);
        t467 = yaw_per_v_delta * t441 - K222_h_spin_F * t456;
        t468 = self.rF * self.rF;
        t469 = self.rF * t438;
        hz_delta_mF = self.c * t234;
        t473 = t234 - t436;
        M_yaw_delta_mF = hz_delta_mF - t48 * t473 - self.rF * t443;
        P_delta_yaw_mF = yaw_by_delta * t105;
        t479 = M_yaw_delta_mF + P_delta_yaw_mF;
        t483 = self.rF * t449 + t54 * hz_delta_mF
            + yaw_by_delta * (M_yaw_delta_mF + t479);
        t484 = self.rF * t454;
        t488 = t473 - yaw_by_delta * (t48 - self.c);
        t490 = yaw_per_v_delta * t479 - yaw_by_delta * t488;
        t491 = t42 * t488;
        t492 = self.rF * yaw_per_v_delta;
        t493 = yaw_per_v_delta * t488;
        t494 = M22_Jxx_delta + t428;
        let (
            t495, t496, t497, t498, t499, t500, t501, t502, t504, t505, t506, Jxx_theta_mU, t510,
            t511, t512, t513, P_delta_yaw_Sx_theta, P_delta_yaw_mU, t516, t517, t518, t519, t521,
            t524, t525, t527, t528, t529, t530, P_delta_yaw_xU, t533, t534, t535, t538, t539, t540,
            t541, t542, t543, t544,
        );
        t495 = t125 * C112_h_spin_F;
        t496 = yaw_per_v_delta * t125;
        t497 = t125 * K222_h_spin_F;
        t498 = Sz_theta + Sz_theta;
        t499 = t31 + t498;
        t500 = Sz_theta - t499;
        t501 = yaw_by_delta * Sx_theta;
        t502 = self.mU * yaw_by_delta;
        t504 = t502 + yaw_per_v_delta * Sx_theta;
        t505 = self.mU * yaw_per_v_delta;
        t506 = self.zP + t5;
        Jxx_theta_mU = t5 * t5;
        t510 = Jxx_theta_mU + self.zP * t5;
        t511 = self.zP * t506 + t510;
        t512 = yaw_by_delta * t506;
        t513 = self.xU * t512;
        P_delta_yaw_Sx_theta = yaw_by_delta * self.xU;
        P_delta_yaw_mU = self.xU * P_delta_yaw_Sx_theta;
        t516 = yaw_by_delta * P_delta_yaw_mU;
        t517 = t5 * yaw_by_delta;
        t518 = self.xU * t517;
        t519 = yaw_per_v_delta * t506;
        t521 = t512 + self.xU * t519;
        t524 = yaw_per_v_delta * P_delta_yaw_mU + yaw_by_delta * P_delta_yaw_Sx_theta;
        t525 = t5 * yaw_per_v_delta;
        t527 = t517 + self.xU * t525;
        t528 = t42 * P_delta_yaw_Sx_theta;
        t529 = yaw_per_v_delta * P_delta_yaw_Sx_theta;
        t530 = self.mU * t512;
        P_delta_yaw_xU = t501 + self.mU * P_delta_yaw_Sx_theta;
        t533 = yaw_by_delta * P_delta_yaw_xU;
        t534 = self.mU * t517;
        t535 = self.mU * t519;
        t538 = yaw_per_v_delta * P_delta_yaw_xU + yaw_by_delta * t502;
        t539 = self.mU * t525;
        t540 = t42 * t502;
        t541 = yaw_per_v_delta * t502;
        t542 = t31 + t499;
        t543 = -(t127 + yaw_by_delta * h_wheels_all);
        t544 = -t161;
        (
            WhippleLeaningMatrices::from_entries([
                t40, t77, M_phi_theta, t77, t120, P_delta_theta, M_phi_theta, P_delta_theta,
                Jxx_theta, self.w.like(0.0), self.w.like(0.0), self.w.like(0.0), self.w.like(0.0),
                self.w.like(0.0), self.w.like(0.0), self.w.like(0.0), self.w.like(0.0), self.dU,
                self.w.like(0.0), t139, self.w.like(0.0), t543, t151, self.w.like(0.0),
                self.w.like(0.0), t154, self.w.like(0.0), self.w.like(0.0), self.w.like(0.0),
                self.w.like(0.0), self.w.like(0.0), self.w.like(0.0), self.w.like(0.0),
                self.w.like(0.0), self.w.like(0.0), self.kU, Sz_all, t149, Sz_theta, t149, t156,
                self.w.like(0.0), Sz_theta, self.w.like(0.0), Sz_theta, self.w.like(0.0), t157,
                self.w.like(0.0), self.w.like(0.0), t160, self.w.like(0.0), self.w.like(0.0), t544,
                self.w.like(0.0),
            ]),
            WhippleLeaningDerivatives {
                values: [
                    t169, t195, t197, t204, t206, t220, t223, t212, t224, t225, t228, t229, t232,
                    t251, t153, t254, t255, t261, t161, t259, t262, t263, t268, t286, t287, t289,
                    t291, t298, t299, t294, t302, t303, t307, t308, t309, t312, t313, self.mR, t314,
                    t315, t316, self.rR, t317, self.w.like(1.0), t319, t320, t321, t322, t323, t328,
                    t329, t333, t331, t334, t335, t336, t325, t339, self.mB, t340, t341, t342, t344,
                    t345, t348, self.zB, t324, t349, t350, t351, yaw_by_delta, yaw_per_v_delta,
                    t163, t358, t198, t363, P_delta_lateral_xH, t364, t365, t366, t373, t387, t392,
                    t395, self.mH, t374, t396, t397, t398, t399, t400, t414, t415, t421, self.zH,
                    t419, t422, t423, t424, t42, M22_Jxx_delta, t428, t430, C112_h_spin_F, t432,
                    K222_h_spin_F, t434, t440, t453, t458, t457, t461, self.mF, t441, t462, t464,
                    t467, t468, t469, t483, t484, t490, self.rF, t488, t491, t492, t493, t494, t495,
                    t496, t497, t500, t501, t498, t504, self.mU, t505, t511, t513, t510, t516, t518,
                    Jxx_theta_mU, t521, t524, t527, t506, P_delta_yaw_Sx_theta, t5, t528, t519,
                    t529, t525, t530, t533, t534, t535, t538, t539, t502, t540, t541, t542, t499,
                ],
            },
        )
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl WhippleLeaning<f64> {
    /// The parameter set `example`.
    ///
    /// Source: The benchmark of Meijaard et al. (2007), Table 1, with 40 kg of rear frame and rider as an upper body
    pub const EXAMPLE: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3141592653589793, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.0603,
        IRyy: 0.12, xB: 0.3, zB: -0.7, mB: 45.0, IBxx: 4.0, IByy: 5.5, IBzz: 1.8, IBxz: 1.2,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.05892, IHyy: 0.06, IHzz: 0.00708, IHxz: -0.00756,
        rF: 0.35, mF: 3.0, IFxx: 0.1405, IFyy: 0.28, zP: -0.85, mU: 40.0, xU: 0.3, zU: -1.125,
        IUxx: 1.6, IUyy: 1.6, IUzz: 0.6, IUxz: 0.0, kU: 600.0, dU: 60.0,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> WhippleLeaning<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 36]) -> Self {
        Self {
            w: values[0], c: values[1], lam: values[2], g: values[3], rR: values[4], mR: values[5],
            IRxx: values[6], IRyy: values[7], xB: values[8], zB: values[9], mB: values[10],
            IBxx: values[11], IByy: values[12], IBzz: values[13], IBxz: values[14], xH: values[15],
            zH: values[16], mH: values[17], IHxx: values[18], IHyy: values[19], IHzz: values[20],
            IHxz: values[21], rF: values[22], mF: values[23], IFxx: values[24], IFyy: values[25],
            zP: values[26], mU: values[27], xU: values[28], zU: values[29], IUxx: values[30],
            IUyy: values[31], IUzz: values[32], IUxz: values[33], kU: values[34], dU: values[35],
        }
    }

    /// The parameters as an array in declared order.
    #[must_use]
    pub const fn to_array(&self) -> [T; 36] {
        [
            self.w, self.c, self.lam, self.g, self.rR, self.mR, self.IRxx, self.IRyy, self.xB,
            self.zB, self.mB, self.IBxx, self.IByy, self.IBzz, self.IBxz, self.xH, self.zH, self.mH,
            self.IHxx, self.IHyy, self.IHzz, self.IHxz, self.rF, self.mF, self.IFxx, self.IFyy,
            self.zP, self.mU, self.xU, self.zU, self.IUxx, self.IUyy, self.IUzz, self.IUxz, self.kU,
            self.dU,
        ]
    }
}

impl<T: Scalar> WhippleLeaning<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> WhippleLeaning<U> {
        let values = self.to_array();
        WhippleLeaning::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl<T: Number> WhippleLeaningMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 54]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c0: carvallo::rows(&entries, 9),
            c1: carvallo::rows(&entries, 18),
            kc: carvallo::rows(&entries, 27),
            k0: carvallo::rows(&entries, 36),
            k2: carvallo::rows(&entries, 45),
        }
    }

    /// The rows of M, C0, C1, Kc, K0 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 3]; 3]; 6] {
        [self.m, self.c0, self.c1, self.kc, self.k0, self.k2]
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<3> for WhippleLeaning<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 36];

    type Over<U: Number> = WhippleLeaning<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "WhippleLeaning",
        docs: "The Whipple-Carvallo bicycle with a rider whose upper body leans on a sprung and damped hip.\n\nFive rigid bodies (rear wheel R, rear frame with the rider's legs B, upper body U, front frame H, front wheel F),\nlaterally symmetric, on knife-edged wheels that roll without slip on level ground. The hip axis lies along x. Axes:\norigin at the rear contact point, x forward, y to the right, z down.",
        source: "Mechanism: Moore (2012), Human Control of a Bicycle, dissertation, University of California, Davis, leaning rider",
        parameters: &[
            ParameterInfo::new("w", "m", Domain::POSITIVE).docs("Wheel base."),
            ParameterInfo::new("c", "m", Domain::FINITE)
                .docs(
                    "Trail: positive when the front contact is behind the point where the steer axis meets the ground.",
                ),
            ParameterInfo::new(
                    "lam",
                    "rad",
                    Domain::between(Bound::Open(-1.5707963267948966), Bound::Open(1.5707963267948966)),
                )
                .symbol("λ")
                .docs("Steer axis tilt: 90 degrees minus the head angle."),
            ParameterInfo::new("g", "N/kg", Domain::NONNEGATIVE)
                .docs("Gravitational field strength."),
            ParameterInfo::new("rR", "m", Domain::POSITIVE)
                .docs("Radius of the rear wheel."),
            ParameterInfo::new("mR", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the rear wheel."),
            ParameterInfo::new("IRxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Radial moment of inertia of the rear wheel; by symmetry also about the vertical."),
            ParameterInfo::new("IRyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Axial moment of inertia of the rear wheel."),
            ParameterInfo::new("xB", "m", Domain::FINITE)
                .docs("Centre of mass of the rear frame and rider, forward of the rear contact."),
            ParameterInfo::new("zB", "m", Domain::FINITE)
                .docs("Centre of mass of the rear frame and rider, downward."),
            ParameterInfo::new("mB", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the rear frame and rider."),
            ParameterInfo::new("IBxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the rear frame and rider about its centre of mass, in roll."),
            ParameterInfo::new("IByy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the rear frame and rider about its centre of mass, in pitch.")
                .unused(),
            ParameterInfo::new("IBzz", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the rear frame and rider about its centre of mass, in yaw."),
            ParameterInfo::new("IBxz", "kg*m^2", Domain::FINITE)
                .docs("Product of inertia of the rear frame and rider about its centre of mass."),
            ParameterInfo::new("xH", "m", Domain::FINITE)
                .docs("Centre of mass of the front frame, forward of the rear contact."),
            ParameterInfo::new("zH", "m", Domain::FINITE)
                .docs("Centre of mass of the front frame, downward."),
            ParameterInfo::new("mH", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the front frame."),
            ParameterInfo::new("IHxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the front frame about its centre of mass, in roll."),
            ParameterInfo::new("IHyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the front frame about its centre of mass, in pitch.")
                .unused(),
            ParameterInfo::new("IHzz", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the front frame about its centre of mass, in yaw."),
            ParameterInfo::new("IHxz", "kg*m^2", Domain::FINITE)
                .docs("Product of inertia of the front frame about its centre of mass."),
            ParameterInfo::new("rF", "m", Domain::POSITIVE)
                .docs("Radius of the front wheel."),
            ParameterInfo::new("mF", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the front wheel."),
            ParameterInfo::new("IFxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Radial moment of inertia of the front wheel; by symmetry also about the vertical."),
            ParameterInfo::new("IFyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Axial moment of inertia of the front wheel."),
            ParameterInfo::new("zP", "m", Domain::FINITE)
                .docs("Height of the rider's hip axis, downward from the ground, so negative."),
            ParameterInfo::new("mU", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the rider's upper body."),
            ParameterInfo::new("xU", "m", Domain::FINITE)
                .docs("Centre of mass of the upper body, forward of the rear contact."),
            ParameterInfo::new("zU", "m", Domain::FINITE)
                .docs("Centre of mass of the upper body, downward."),
            ParameterInfo::new("IUxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the upper body about its centre of mass, in roll."),
            ParameterInfo::new("IUyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the upper body about its centre of mass, in pitch.")
                .unused(),
            ParameterInfo::new("IUzz", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the upper body about its centre of mass, in yaw."),
            ParameterInfo::new("IUxz", "kg*m^2", Domain::FINITE)
                .docs("Product of inertia of the upper body about its centre of mass."),
            ParameterInfo::new("kU", "N*m", Domain::NONNEGATIVE)
                .docs("Stiffness of the hip."),
            ParameterInfo::new("dU", "N*m*s", Domain::NONNEGATIVE)
                .docs("Damping of the hip."),
        ],
        coordinates: &[
            CoordinateInfo::new("phi", "rad")
                .label("lean")
                .docs("Lean of the rear frame, positive to the right."),
            CoordinateInfo::new("delta", "rad")
                .label("steer")
                .docs("Steer of the front frame relative to the rear frame, positive to the right."),
            CoordinateInfo::new("theta", "rad")
                .label("upper body")
                .docs("Lean of the upper body relative to the rear frame, positive to the right."),
        ],
        matrices: &["M", "C0", "C1", "Kc", "K0", "K2"],
        entries: &[
            EntryInfo::at(&[("M", 0, 0)]), EntryInfo::at(&[("M", 0, 1), ("M", 1, 0)]),
            EntryInfo::at(&[("M", 0, 2), ("M", 2, 0)]), EntryInfo::at(&[("M", 1, 1)]),
            EntryInfo::at(&[("M", 1, 2), ("M", 2, 1)]), EntryInfo::at(&[("M", 2, 2)]),
            EntryInfo::at(&[("C0", 2, 2)]), EntryInfo::at(&[("C1", 0, 1)]),
            EntryInfo::at(&[("C1", 1, 0)]), EntryInfo::at(&[("C1", 1, 1)]),
            EntryInfo::at(&[("C1", 2, 1)]), EntryInfo::at(&[("Kc", 2, 2)]),
            EntryInfo::at(&[("K0", 0, 0)]), EntryInfo::at(&[("K0", 0, 1), ("K0", 1, 0)]),
            EntryInfo::at(&[("K0", 0, 2), ("K0", 2, 0), ("K0", 2, 2)]),
            EntryInfo::at(&[("K0", 1, 1)]), EntryInfo::at(&[("K2", 0, 1)]),
            EntryInfo::at(&[("K2", 1, 1)]), EntryInfo::at(&[("K2", 2, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "example",
                docs: "",
                source: "The benchmark of Meijaard et al. (2007), Table 1, with 40 kg of rear frame and rider as an upper body",
                values: &WhippleLeaning::<f64>::EXAMPLE.to_array(),
            },
        ],
        gravity: Some(3),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("WhippleLeaning", 36, values)?;
        Ok(<Self as Evaluator<T, 3>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("WhippleLeaning", 36, values)?;
        values.copy_from_slice(&self.to_array());
        Ok(())
    }

    #[inline(always)]
    fn array<U: Copy>(element: impl FnMut(usize) -> U) -> Self::Array<U> {
        core::array::from_fn(element)
    }

    #[inline(always)]
    fn parameters(&self) -> Self::Array<T> {
        self.to_array()
    }

    fn validate(&self) -> Result<(), ParameterError> {
        let info = <Self as Model<3>>::INFO;
        info.validate(&self.to_array().map(Scalar::to_f64))?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 3> {
        Coefficients::from_rows(WhippleLeaningMatrices::rows(&self.matrices()))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl<T: Number> Evaluator<T, 3> for WhippleLeaning<T> {
    type Entries = [T; 19];

    #[inline(always)]
    fn from_parameters(parameter: impl FnMut(usize) -> T) -> Self {
        Self::from_array(core::array::from_fn(parameter))
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        let matrices = self.matrices();
        [
            matrices.m[0][0], matrices.m[0][1], matrices.m[0][2], matrices.m[1][1],
            matrices.m[1][2], matrices.m[2][2], matrices.c0[2][2], matrices.c1[0][1],
            matrices.c1[1][0], matrices.c1[1][1], matrices.c1[2][1], matrices.kc[2][2],
            matrices.k0[0][0], matrices.k0[0][1], matrices.k0[0][2], matrices.k0[1][1],
            matrices.k2[0][1], matrices.k2[1][1], matrices.k2[2][1],
        ]
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 3]; 3]; 6] {
        WhippleLeaningMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> WhippleLeaningDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<WhippleLeaningMatrices<T>> {
        if parameter >= 36 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = WhippleLeaningMatrices {
            m: [[zero; 3]; 3], c0: [[zero; 3]; 3], c1: [[zero; 3]; 3], kc: [[zero; 3]; 3],
            k0: [[zero; 3]; 3], k2: [[zero; 3]; 3],
        };
        for position in 0..243 {
            let partial = <WhippleLeaningDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C0 => &mut matrices.c0,
                MatrixName::C1 => &mut matrices.c1,
                MatrixName::Kc => &mut matrices.kc,
                MatrixName::K0 => &mut matrices.k0,
                MatrixName::K2 => &mut matrices.k2,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<3> for WhippleLeaning<T> {
    type Derivatives = [Coefficients<T, 3>; 36];

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 3>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 3]; 3]; 6]); 36];
        for position in 0..243 {
            Partial::write(&<WhippleLeaningDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(WhippleLeaningMatrices::rows(&matrices)), all)
    }
}

impl WhippleLeaningDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 243] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 0), Partial::new(MatrixName::M, 1, 0, 0, 0),
        Partial::new(MatrixName::M, 1, 1, 0, 1), Partial::new(MatrixName::M, 1, 2, 0, 2).negative(),
        Partial::new(MatrixName::M, 2, 1, 0, 2).negative(),
        Partial::new(MatrixName::C1, 0, 1, 0, 3), Partial::new(MatrixName::C1, 1, 0, 0, 4),
        Partial::new(MatrixName::C1, 1, 1, 0, 5),
        Partial::new(MatrixName::C1, 2, 1, 0, 6).negative(),
        Partial::new(MatrixName::K0, 0, 1, 0, 7), Partial::new(MatrixName::K0, 1, 0, 0, 7),
        Partial::new(MatrixName::K0, 1, 1, 0, 8),
        Partial::new(MatrixName::K2, 0, 1, 0, 9).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 10).negative(),
        Partial::new(MatrixName::K2, 2, 1, 0, 11), Partial::new(MatrixName::M, 0, 1, 1, 12),
        Partial::new(MatrixName::M, 1, 0, 1, 12), Partial::new(MatrixName::M, 1, 1, 1, 13),
        Partial::new(MatrixName::M, 1, 2, 1, 14), Partial::new(MatrixName::M, 2, 1, 1, 14),
        Partial::new(MatrixName::C1, 0, 1, 1, 15),
        Partial::new(MatrixName::C1, 1, 0, 1, 16).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 17),
        Partial::new(MatrixName::C1, 2, 1, 1, 18).negative(),
        Partial::new(MatrixName::K0, 0, 1, 1, 19),
        Partial::new(MatrixName::K0, 1, 0, 1, 19),
        Partial::new(MatrixName::K0, 1, 1, 1, 20),
        Partial::new(MatrixName::K2, 1, 1, 1, 21).negative(),
        Partial::new(MatrixName::M, 0, 1, 2, 22), Partial::new(MatrixName::M, 1, 0, 2, 22),
        Partial::new(MatrixName::M, 1, 1, 2, 23),
        Partial::new(MatrixName::M, 1, 2, 2, 24).negative(),
        Partial::new(MatrixName::M, 2, 1, 2, 24).negative(),
        Partial::new(MatrixName::C1, 0, 1, 2, 25).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 26),
        Partial::new(MatrixName::C1, 1, 1, 2, 27),
        Partial::new(MatrixName::C1, 2, 1, 2, 28).negative(),
        Partial::new(MatrixName::K0, 0, 1, 2, 29),
        Partial::new(MatrixName::K0, 1, 0, 2, 29),
        Partial::new(MatrixName::K0, 1, 1, 2, 30),
        Partial::new(MatrixName::K2, 0, 1, 2, 31).negative(),
        Partial::new(MatrixName::K2, 1, 1, 2, 32), Partial::new(MatrixName::K2, 2, 1, 2, 33),
        Partial::new(MatrixName::M, 0, 0, 4, 34), Partial::new(MatrixName::C1, 0, 1, 4, 35),
        Partial::new(MatrixName::C1, 1, 0, 4, 36),
        Partial::new(MatrixName::K0, 0, 0, 4, 37).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 38),
        Partial::new(MatrixName::M, 0, 0, 5, 39),
        Partial::new(MatrixName::C1, 0, 1, 5, 40),
        Partial::new(MatrixName::K0, 0, 0, 5, 41).negative(),
        Partial::new(MatrixName::K2, 0, 1, 5, 42), Partial::new(MatrixName::M, 0, 0, 6, 43),
        Partial::new(MatrixName::M, 1, 1, 6, 44), Partial::new(MatrixName::C1, 1, 1, 6, 45),
        Partial::new(MatrixName::C1, 0, 1, 7, 46),
        Partial::new(MatrixName::C1, 1, 0, 7, 46).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 47),
        Partial::new(MatrixName::M, 0, 1, 8, 48).negative(),
        Partial::new(MatrixName::M, 1, 0, 8, 48).negative(),
        Partial::new(MatrixName::M, 1, 1, 8, 49),
        Partial::new(MatrixName::C1, 0, 1, 8, 50).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 51),
        Partial::new(MatrixName::K0, 0, 1, 8, 52).negative(),
        Partial::new(MatrixName::K0, 1, 0, 8, 52).negative(),
        Partial::new(MatrixName::K0, 1, 1, 8, 53).negative(),
        Partial::new(MatrixName::K2, 1, 1, 8, 54), Partial::new(MatrixName::M, 0, 0, 9, 55),
        Partial::new(MatrixName::M, 0, 1, 9, 56).negative(),
        Partial::new(MatrixName::M, 1, 0, 9, 56).negative(),
        Partial::new(MatrixName::C1, 0, 1, 9, 57).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 58),
        Partial::new(MatrixName::K2, 0, 1, 9, 59).negative(),
        Partial::new(MatrixName::M, 0, 0, 10, 60),
        Partial::new(MatrixName::M, 0, 1, 10, 61).negative(),
        Partial::new(MatrixName::M, 1, 0, 10, 61).negative(),
        Partial::new(MatrixName::M, 1, 1, 10, 62),
        Partial::new(MatrixName::C1, 0, 1, 10, 63).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 64),
        Partial::new(MatrixName::K0, 0, 0, 10, 65),
        Partial::new(MatrixName::K0, 0, 1, 10, 66).negative(),
        Partial::new(MatrixName::K0, 1, 0, 10, 66).negative(),
        Partial::new(MatrixName::K0, 1, 1, 10, 67).negative(),
        Partial::new(MatrixName::K2, 0, 1, 10, 68).negative(),
        Partial::new(MatrixName::K2, 1, 1, 10, 69), Partial::new(MatrixName::M, 0, 0, 11, 43),
        Partial::new(MatrixName::M, 1, 1, 13, 44), Partial::new(MatrixName::C1, 1, 1, 13, 45),
        Partial::new(MatrixName::M, 0, 1, 14, 70), Partial::new(MatrixName::M, 1, 0, 14, 70),
        Partial::new(MatrixName::C1, 0, 1, 14, 71),
        Partial::new(MatrixName::M, 0, 1, 15, 72).negative(),
        Partial::new(MatrixName::M, 1, 0, 15, 72).negative(),
        Partial::new(MatrixName::M, 1, 1, 15, 73),
        Partial::new(MatrixName::C1, 0, 1, 15, 74).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 75),
        Partial::new(MatrixName::K0, 0, 1, 15, 76).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 76).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 77).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 78), Partial::new(MatrixName::M, 0, 0, 16, 79),
        Partial::new(MatrixName::M, 0, 1, 16, 80), Partial::new(MatrixName::M, 1, 0, 16, 80),
        Partial::new(MatrixName::M, 1, 1, 16, 81), Partial::new(MatrixName::C1, 0, 1, 16, 82),
        Partial::new(MatrixName::C1, 1, 1, 16, 83), Partial::new(MatrixName::K0, 0, 0, 16, 84),
        Partial::new(MatrixName::K0, 0, 1, 16, 85), Partial::new(MatrixName::K0, 1, 0, 16, 85),
        Partial::new(MatrixName::K0, 1, 1, 16, 86),
        Partial::new(MatrixName::K2, 0, 1, 16, 87).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 88).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 89), Partial::new(MatrixName::M, 0, 1, 17, 90),
        Partial::new(MatrixName::M, 1, 0, 17, 90), Partial::new(MatrixName::M, 1, 1, 17, 91),
        Partial::new(MatrixName::C1, 0, 1, 17, 92), Partial::new(MatrixName::C1, 1, 1, 17, 93),
        Partial::new(MatrixName::K0, 0, 0, 17, 94), Partial::new(MatrixName::K0, 0, 1, 17, 95),
        Partial::new(MatrixName::K0, 1, 0, 17, 95), Partial::new(MatrixName::K0, 1, 1, 17, 96),
        Partial::new(MatrixName::K2, 0, 1, 17, 97).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 98).negative(),
        Partial::new(MatrixName::M, 0, 0, 18, 43), Partial::new(MatrixName::M, 0, 1, 18, 99),
        Partial::new(MatrixName::M, 1, 0, 18, 99), Partial::new(MatrixName::M, 1, 1, 18, 100),
        Partial::new(MatrixName::M, 1, 1, 20, 101), Partial::new(MatrixName::C1, 1, 1, 20, 102),
        Partial::new(MatrixName::M, 0, 1, 21, 103), Partial::new(MatrixName::M, 1, 0, 21, 103),
        Partial::new(MatrixName::M, 1, 1, 21, 104), Partial::new(MatrixName::C1, 0, 1, 21, 71),
        Partial::new(MatrixName::C1, 1, 1, 21, 105), Partial::new(MatrixName::M, 0, 0, 22, 106),
        Partial::new(MatrixName::M, 0, 1, 22, 107), Partial::new(MatrixName::M, 1, 0, 22, 107),
        Partial::new(MatrixName::M, 1, 1, 22, 108), Partial::new(MatrixName::C1, 0, 1, 22, 109),
        Partial::new(MatrixName::C1, 1, 0, 22, 110), Partial::new(MatrixName::C1, 1, 1, 22, 111),
        Partial::new(MatrixName::K0, 0, 0, 22, 112).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 113).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 113).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 114).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 115), Partial::new(MatrixName::K2, 1, 1, 22, 116),
        Partial::new(MatrixName::M, 0, 0, 23, 117), Partial::new(MatrixName::M, 0, 1, 23, 118),
        Partial::new(MatrixName::M, 1, 0, 23, 118), Partial::new(MatrixName::M, 1, 1, 23, 119),
        Partial::new(MatrixName::C1, 0, 1, 23, 120), Partial::new(MatrixName::C1, 1, 1, 23, 121),
        Partial::new(MatrixName::K0, 0, 0, 23, 122).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 123), Partial::new(MatrixName::K0, 1, 0, 23, 123),
        Partial::new(MatrixName::K0, 1, 1, 23, 124), Partial::new(MatrixName::K2, 0, 1, 23, 125),
        Partial::new(MatrixName::K2, 1, 1, 23, 126).negative(),
        Partial::new(MatrixName::M, 0, 0, 24, 43), Partial::new(MatrixName::M, 0, 1, 24, 99),
        Partial::new(MatrixName::M, 1, 0, 24, 99), Partial::new(MatrixName::M, 1, 1, 24, 127),
        Partial::new(MatrixName::C1, 1, 1, 24, 102), Partial::new(MatrixName::C1, 0, 1, 25, 128),
        Partial::new(MatrixName::C1, 1, 0, 25, 128).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 129), Partial::new(MatrixName::K2, 1, 1, 25, 130),
        Partial::new(MatrixName::M, 0, 2, 26, 131), Partial::new(MatrixName::M, 1, 2, 26, 132),
        Partial::new(MatrixName::M, 2, 0, 26, 131), Partial::new(MatrixName::M, 2, 1, 26, 132),
        Partial::new(MatrixName::M, 2, 2, 26, 133).negative(),
        Partial::new(MatrixName::C1, 2, 1, 26, 134),
        Partial::new(MatrixName::K0, 0, 2, 26, 135).negative(),
        Partial::new(MatrixName::K0, 2, 0, 26, 135).negative(),
        Partial::new(MatrixName::K0, 2, 2, 26, 135).negative(),
        Partial::new(MatrixName::K2, 2, 1, 26, 136),
        Partial::new(MatrixName::M, 0, 0, 27, 137),
        Partial::new(MatrixName::M, 0, 1, 27, 138).negative(),
        Partial::new(MatrixName::M, 0, 2, 27, 139),
        Partial::new(MatrixName::M, 1, 0, 27, 138).negative(),
        Partial::new(MatrixName::M, 1, 1, 27, 140),
        Partial::new(MatrixName::M, 1, 2, 27, 141).negative(),
        Partial::new(MatrixName::M, 2, 0, 27, 139),
        Partial::new(MatrixName::M, 2, 1, 27, 141).negative(),
        Partial::new(MatrixName::M, 2, 2, 27, 142),
        Partial::new(MatrixName::C1, 0, 1, 27, 143).negative(),
        Partial::new(MatrixName::C1, 1, 1, 27, 144),
        Partial::new(MatrixName::C1, 2, 1, 27, 145).negative(),
        Partial::new(MatrixName::K0, 0, 0, 27, 146),
        Partial::new(MatrixName::K0, 0, 1, 27, 147).negative(),
        Partial::new(MatrixName::K0, 0, 2, 27, 148),
        Partial::new(MatrixName::K0, 1, 0, 27, 147).negative(),
        Partial::new(MatrixName::K0, 1, 1, 27, 149).negative(),
        Partial::new(MatrixName::K0, 2, 0, 27, 148),
        Partial::new(MatrixName::K0, 2, 2, 27, 148),
        Partial::new(MatrixName::K2, 0, 1, 27, 150).negative(),
        Partial::new(MatrixName::K2, 1, 1, 27, 151),
        Partial::new(MatrixName::K2, 2, 1, 27, 152).negative(),
        Partial::new(MatrixName::M, 0, 1, 28, 153).negative(),
        Partial::new(MatrixName::M, 1, 0, 28, 153).negative(),
        Partial::new(MatrixName::M, 1, 1, 28, 154),
        Partial::new(MatrixName::M, 1, 2, 28, 155).negative(),
        Partial::new(MatrixName::M, 2, 1, 28, 155).negative(),
        Partial::new(MatrixName::C1, 0, 1, 28, 156).negative(),
        Partial::new(MatrixName::C1, 1, 1, 28, 157),
        Partial::new(MatrixName::C1, 2, 1, 28, 158).negative(),
        Partial::new(MatrixName::K0, 0, 1, 28, 159).negative(),
        Partial::new(MatrixName::K0, 1, 0, 28, 159).negative(),
        Partial::new(MatrixName::K0, 1, 1, 28, 160).negative(),
        Partial::new(MatrixName::K2, 1, 1, 28, 161),
        Partial::new(MatrixName::M, 0, 0, 29, 162),
        Partial::new(MatrixName::M, 0, 1, 29, 132).negative(),
        Partial::new(MatrixName::M, 0, 2, 29, 163),
        Partial::new(MatrixName::M, 1, 0, 29, 132).negative(),
        Partial::new(MatrixName::M, 1, 2, 29, 132).negative(),
        Partial::new(MatrixName::M, 2, 0, 29, 163),
        Partial::new(MatrixName::M, 2, 1, 29, 132).negative(),
        Partial::new(MatrixName::M, 2, 2, 29, 133),
        Partial::new(MatrixName::C1, 0, 1, 29, 134).negative(),
        Partial::new(MatrixName::C1, 2, 1, 29, 134).negative(),
        Partial::new(MatrixName::K0, 0, 0, 29, 135), Partial::new(MatrixName::K0, 0, 2, 29, 135),
        Partial::new(MatrixName::K0, 2, 0, 29, 135), Partial::new(MatrixName::K0, 2, 2, 29, 135),
        Partial::new(MatrixName::K2, 0, 1, 29, 136).negative(),
        Partial::new(MatrixName::K2, 2, 1, 29, 136).negative(),
        Partial::new(MatrixName::M, 0, 0, 30, 43), Partial::new(MatrixName::M, 0, 2, 30, 43),
        Partial::new(MatrixName::M, 2, 0, 30, 43), Partial::new(MatrixName::M, 2, 2, 30, 43),
        Partial::new(MatrixName::M, 1, 1, 32, 44), Partial::new(MatrixName::C1, 1, 1, 32, 45),
        Partial::new(MatrixName::M, 0, 1, 33, 70), Partial::new(MatrixName::M, 1, 0, 33, 70),
        Partial::new(MatrixName::M, 1, 2, 33, 70), Partial::new(MatrixName::M, 2, 1, 33, 70),
        Partial::new(MatrixName::C1, 0, 1, 33, 71), Partial::new(MatrixName::C1, 2, 1, 33, 71),
        Partial::new(MatrixName::Kc, 2, 2, 34, 43), Partial::new(MatrixName::C0, 2, 2, 35, 43),
    ];
}
