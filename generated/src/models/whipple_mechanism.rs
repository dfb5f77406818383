// @generated from generated/models/whipple_mechanism.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: dc474ea890db6fad

#![allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    LengthError, MatrixName, Model, ModelInfo, Number, ParameterError, ParameterInfo,
    Partial, Rate, Scalar, SetInfo,
};

// --- The parameters ------------------------------------------------------------------------------

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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleMechanism<T = f64> {
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

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`WhippleMechanism`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleMechanismMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: [[T; 2]; 2],
    /// Damping C1, a coefficient of v q'.
    pub c1: [[T; 2]; 2],
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: [[T; 2]; 2],
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: [[T; 2]; 2],
}

impl<T: Number> WhippleMechanism<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 47 additions, 44 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 98 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleMechanismMatrices<T> {
        let t6 = self.zH * self.mH;
        let t10 = self.rF * self.mF;
        let Jxx_delta = self.IHxx + self.IFxx + self.zH * t6 + self.rF * t10;
        let t17 = self.rR * self.mR;
        let t21 = self.zB * self.mB;
        let t26 = self.IRxx + self.IBxx + Jxx_delta + self.rR * t17 + self.zB * t21;
        let (t28, t40) = self.lam.sin_cos();
        let t35 = self.c + self.w;
        let t36 = t35 - self.xH;
        let Jxz_delta = self.IHxz + t6 * t36 - t10 * self.c;
        let hx_delta = Jxx_delta * t28 + Jxz_delta * t40;
        let yaw_per_v_delta = t40 / self.w;
        let mu = self.c * yaw_per_v_delta;
        let Sz_delta = t6 - t10;
        let Jxz_all = Jxz_delta + self.IBxz - t21 * self.xB - t35 * Sz_delta;
        let t54 = hx_delta + mu * Jxz_all;
        let t57 = self.mH * t36;
        let t59 = self.mF * self.c;
        let Jzz_delta = self.IFxx + self.IHzz + t36 * t57 + self.c * t59;
        let hz_delta = t28 * Jxz_delta + t40 * Jzz_delta;
        let t67 = t57 + t59;
        let t69 = t28 * Sz_delta + t40 * t67;
        let M_yaw_delta = hz_delta - t35 * t69;
        let t73 = self.mB * self.xB;
        let mA = self.mH + self.mF;
        let t77 = t67 - t35 * mA;
        let P_delta_yaw = M_yaw_delta
            + mu
                * (self.IRxx + Jzz_delta + self.IBzz + self.xB * t73
                    - t35 * (t67 + t77));
        let t91 = mu * (M_yaw_delta + P_delta_yaw) + t28 * hx_delta + t40 * hz_delta;
        let SF = self.IFyy / self.rF;
        let ST = SF + self.IRyy / self.rR;
        let Sz_all = t21 + Sz_delta - t17;
        let t100 = ST - Sz_all;
        let t103 = t40 * SF;
        let t105 = mu * t100 + yaw_per_v_delta * Jxz_all + t103;
        let Sx_all = t73 - t77;
        let t109 = mu * Sx_all;
        let P_delta_lateral = t109 - t69;
        let t113 = mu * P_delta_lateral + yaw_per_v_delta * P_delta_yaw;
        let t115 = yaw_per_v_delta * t100;
        let t118 = yaw_per_v_delta * (P_delta_lateral + t28 * SF);
        let t119 = -(t103 + mu * ST);
        let t120 = t69 - t109;
        let t121 = -(t28 * P_delta_lateral);
        WhippleMechanismMatrices::from_entries([
            t26, t54, t54, t91, self.w.like(0.0), t105, t119, t113, Sz_all, t120, t120, t121,
            self.w.like(0.0), t115, self.w.like(0.0), t118,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`WhippleMechanism`] that follow from its coordinates q = (`phi`, `delta`), to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleMechanismKinematics<T = f64> {
    /// Lateral velocity, to the right, in m/s: of the point of `B` that is at the origin.
    pub lateral: Rate<T, 2>,
    /// Yaw rate, to the right, in rad/s: of `B`.
    pub yaw: Rate<T, 2>,
    /// Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_R: Rate<T, 2>,
    /// Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_F: Rate<T, 2>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of `Tphi` (lean torque) in N*m, `Tdelta` (steer torque) in N*m.
    pub forces: [[T; 2]; 2],
}

impl<T: Scalar> WhippleMechanism<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> WhippleMechanismKinematics<T> {
        let yaw_per_v_delta = self.lam.cos() / self.w;
        let mu = self.c * yaw_per_v_delta;
        let t12 = -(self.w.like(1.0) / self.rR);
        let t13 = -(self.w.like(1.0) / self.rF);
        WhippleMechanismKinematics {
            lateral: Rate {
                speed: self.w.like(0.0),
                rates: [self.w.like(0.0), self.w.like(0.0)],
                coordinates: [self.w.like(0.0), self.w.like(0.0)],
                heading: self.w.like(1.0),
            },
            yaw: Rate {
                speed: self.w.like(0.0),
                rates: [self.w.like(0.0), mu],
                coordinates: [self.w.like(0.0), yaw_per_v_delta],
                heading: self.w.like(0.0),
            },
            wheel_R: Rate {
                speed: t12,
                rates: [self.w.like(0.0), self.w.like(0.0)],
                coordinates: [self.w.like(0.0), self.w.like(0.0)],
                heading: self.w.like(0.0),
            },
            wheel_F: Rate {
                speed: t13,
                rates: [self.w.like(0.0), self.w.like(0.0)],
                coordinates: [self.w.like(0.0), self.w.like(0.0)],
                heading: self.w.like(0.0),
            },
            forces: [
                [self.w.like(1.0), self.w.like(0.0)],
                [self.w.like(0.0), self.w.like(1.0)],
            ],
        }
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`WhippleMechanism`] with respect to its parameters, in SI units: those that are not
/// zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleMechanismDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 123],
}

impl<T: Number> WhippleMechanism<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 160 additions, 242 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 408 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WhippleMechanismMatrices<T>, WhippleMechanismDerivatives<T>) {
        let t6 = self.zH * self.mH;
        let t10 = self.rF * self.mF;
        let Jxx_delta = self.IHxx + self.IFxx + self.zH * t6 + self.rF * t10;
        let t17 = self.rR * self.mR;
        let t21 = self.zB * self.mB;
        let t26 = self.IRxx + self.IBxx + Jxx_delta + self.rR * t17 + self.zB * t21;
        let (t28, t40) = self.lam.sin_cos();
        let t34 = self.c + self.w;
        let t36 = t34 - self.xH;
        let Jxz_delta = self.IHxz + t6 * t36 - t10 * self.c;
        let t41 = Jxz_delta * t40;
        let hx_delta = Jxx_delta * t28 + t41;
        let t43 = self.w.like(1.0) / self.w;
        let yaw_per_v_delta = t40 * t43;
        let mu = self.c * yaw_per_v_delta;
        let Sz_delta = t6 - t10;
        let Jxz_all = Jxz_delta + self.IBxz - t21 * self.xB - t34 * Sz_delta;
        let t55 = hx_delta + mu * Jxz_all;
        let t57 = t28 * Jxz_delta;
        let t59 = self.mF * self.c;
        let t61 = self.mH * t36;
        let Jzz_delta = self.IFxx + self.IHzz + self.c * t59 + t36 * t61;
        let hz_delta = t57 + t40 * Jzz_delta;
        let t70 = t59 + t61;
        let t72 = t28 * Sz_delta + t40 * t70;
        let M_yaw_delta = hz_delta - t34 * t72;
        let mA = self.mH + self.mF;
        let t78 = t70 - t34 * mA;
        let t79 = t70 + t78;
        let t81 = self.mB * self.xB;
        let P_delta_yaw_mu = self.IRxx + Jzz_delta + self.IBzz + self.xB * t81
            - t34 * t79;
        let t87 = mu * P_delta_yaw_mu;
        let P_delta_yaw = M_yaw_delta + t87;
        let t89 = M_yaw_delta + P_delta_yaw;
        let t92 = t28 * hx_delta + t40 * hz_delta + mu * t89;
        let t95 = self.w.like(1.0) / self.rF;
        let SF = self.IFyy * t95;
        let t97 = t40 * SF;
        let t99 = self.w.like(1.0) / self.rR;
        let t100 = self.IRyy * t99;
        let ST = SF + t100;
        let Sz_all = t21 + Sz_delta - t17;
        let t104 = ST - Sz_all;
        let t106 = yaw_per_v_delta * Jxz_all;
        let t108 = t97 + mu * t104 + t106;
        let Sx_all = t81 - t78;
        let t114 = t72 - mu * Sx_all;
        let t116 = yaw_per_v_delta * P_delta_yaw - mu * t114;
        let t117 = t28 * t114;
        let t118 = yaw_per_v_delta * t104;
        let t119 = t28 * SF;
        let K222_yaw_per_v_delta = t119 - t114;
        let t121 = yaw_per_v_delta * K222_yaw_per_v_delta;
        let t122 = t43 * yaw_per_v_delta;
        let t123 = self.c * Jxz_all;
        let M12_Jxz_delta = t40 + mu;
        let t127 = t6 * M12_Jxz_delta;
        let t128 = t127 - mu * Sz_delta;
        let t129 = t128 - t122 * t123;
        let M22_mu = t87 + t89;
        let M22_yaw_per_v_delta = self.c * M22_mu;
        let t134 = t34 * mu;
        let t137 = mA * t134 - t72 - mu * t79;
        let t140 = t134 + t134;
        let t143 = t40 * t140 + mu * t140;
        let M22_hz_delta = mu + M12_Jxz_delta;
        let t146 = mu * mu;
        let M22_Jzz_delta = t40 * M22_hz_delta + t146;
        let t149 = t36 * M22_Jzz_delta - t143;
        let M22_Jxz_delta = t28 * (t40 + M22_hz_delta);
        let t156 = self.mH * t149 + t6 * M22_Jxz_delta + t61 * M22_Jzz_delta;
        let t157 = mu * (t137 - t72) + t156;
        let t158 = t157 - t122 * M22_yaw_per_v_delta;
        let C112_yaw_per_v_delta = Jxz_all + self.c * t104;
        let t163 = t6 * yaw_per_v_delta;
        let t164 = t163 - yaw_per_v_delta * Sz_delta;
        let t165 = t164 - t122 * C112_yaw_per_v_delta;
        let t166 = self.c * ST;
        let t167 = t122 * t166;
        let t168 = mu * mA;
        let t169 = self.c * Sx_all;
        let t171 = t168 - t122 * t169;
        let t172 = self.mH * M12_Jxz_delta;
        let P_delta_lateral_w = t171 - t172;
        let C122_mu = yaw_per_v_delta * P_delta_yaw_mu - t114;
        let C122_yaw_per_v_delta = P_delta_yaw + self.c * C122_mu;
        let t181 = t34 * yaw_per_v_delta;
        let t184 = t40 * t181 + yaw_per_v_delta * t140;
        let t186 = yaw_per_v_delta * mu;
        let C122_Jzz_delta = t40 * yaw_per_v_delta + t186;
        let t189 = t36 * C122_Jzz_delta - t184;
        let C122_Jxz_delta = t28 * yaw_per_v_delta;
        let t195 = self.mH * t189 + t6 * C122_Jxz_delta + t61 * C122_Jzz_delta;
        let t196 = yaw_per_v_delta * t137 + t195;
        let t198 = mu * P_delta_lateral_w + t196 - t122 * C122_yaw_per_v_delta;
        let t199 = t28 * P_delta_lateral_w;
        let t200 = t104 * t122;
        let t203 = yaw_per_v_delta * P_delta_lateral_w - K222_yaw_per_v_delta * t122;
        let t206 = t106 + t128 - t10 * M12_Jxz_delta;
        let t209 = self.c * M22_Jzz_delta - t143;
        let t216 = t157 + self.mF * t209 + yaw_per_v_delta * M22_mu + t59 * M22_Jzz_delta
            - t10 * M22_Jxz_delta;
        let t219 = t164 + yaw_per_v_delta * (t104 - t10);
        let t220 = yaw_per_v_delta * ST;
        let t223 = self.c * C122_Jzz_delta - t184;
        let t228 = t168 + yaw_per_v_delta * Sx_all - t172;
        let t229 = self.mF * M12_Jxz_delta;
        let P_delta_lateral_c = t228 - t229;
        let t237 = t196 + self.mF * t223 + yaw_per_v_delta * C122_mu
            + mu * P_delta_lateral_c + t59 * C122_Jzz_delta - t10 * C122_Jxz_delta;
        let t238 = t28 * P_delta_lateral_c;
        let t239 = yaw_per_v_delta * P_delta_lateral_c;
        let hx_delta_lam = Jxx_delta * t40 - t57;
        let t242 = t28 * t43;
        let t244 = hx_delta_lam - t123 * t242;
        let hz_delta_lam = t41 - t28 * Jzz_delta;
        let t254 = t40 * Sz_delta - t28 * t70;
        let t260 = t28 * hx_delta_lam + t40 * hx_delta + M22_hz_delta * hz_delta_lam
            - t28 * hz_delta - M22_yaw_per_v_delta * t242 - t140 * t254;
        let t262 = t119 + C112_yaw_per_v_delta * t242;
        let t264 = t119 + t166 * t242;
        let t267 = t254 + t169 * t242;
        let t273 = yaw_per_v_delta * hz_delta_lam - mu * t267
            - C122_yaw_per_v_delta * t242 - t181 * t254;
        let t276 = t28 * t267 + t40 * t114;
        let t277 = t104 * t242;
        let t281 = yaw_per_v_delta * (t97 - t267) - K222_yaw_per_v_delta * t242;
        let t282 = t17 + t17;
        let t283 = t99 * t100;
        let t284 = self.mR - t283;
        let t285 = mu * t284;
        let t286 = mu * t283;
        let t287 = yaw_per_v_delta * t284;
        let t288 = self.rR * self.rR;
        let t289 = self.rR * mu;
        let t290 = self.rR * yaw_per_v_delta;
        let t292 = mu * t99;
        let t293 = yaw_per_v_delta * t99;
        let t294 = t21 * mu;
        let t295 = mu * self.xB;
        let t296 = self.mB * t295;
        let P_delta_yaw_xB = t296 + mu * t81;
        let t299 = mu * P_delta_yaw_xB;
        let t300 = t21 * yaw_per_v_delta;
        let t302 = self.mB * mu;
        let t304 = yaw_per_v_delta * P_delta_yaw_xB + mu * t302;
        let t305 = t28 * t302;
        let t306 = yaw_per_v_delta * t302;
        let t307 = t21 + t21;
        let t309 = mu + yaw_per_v_delta * self.xB;
        let t310 = self.mB * t309;
        let t311 = self.mB * yaw_per_v_delta;
        let t312 = self.zB * self.zB;
        let t313 = self.zB * t295;
        let P_delta_yaw_mB = self.xB * t295;
        let t315 = mu * P_delta_yaw_mB;
        let t316 = self.zB * t309;
        let t319 = yaw_per_v_delta * P_delta_yaw_mB + mu * t295;
        let t320 = t28 * t295;
        let t321 = self.zB * yaw_per_v_delta;
        let t322 = yaw_per_v_delta * t295;
        let t324 = mu * t172 - t195;
        let t325 = t28 * t172;
        let t326 = yaw_per_v_delta * t172;
        let t327 = t6 + t6;
        let t331 = self.zH * t28 + t36 * M12_Jxz_delta - t134;
        let t334 = self.mH * t331 + t6 * t28;
        let t335 = t28 * t140;
        let M22_Jxx_delta = t28 * t28;
        let t340 = self.zH * M22_Jxx_delta + t36 * M22_Jxz_delta - t335;
        let t343 = self.mH * t340 + t6 * M22_Jxx_delta;
        let t344 = mu + t181;
        let t346 = t36 * yaw_per_v_delta - t344;
        let t347 = self.mH * t346;
        let t348 = t28 * t181;
        let t350 = t36 * C122_Jxz_delta - t348;
        let t352 = self.mH * t28;
        let t354 = self.mH * t350 - mu * t352;
        let t355 = t28 * t352;
        let t356 = self.mH * yaw_per_v_delta;
        let t357 = yaw_per_v_delta * t352;
        let t358 = self.zH * self.zH;
        let t359 = self.zH * t331;
        let P_delta_yaw_mA = t34 * t134;
        let M22_mA = mu * P_delta_yaw_mA;
        let t365 = M22_mA + self.zH * t340 + t36 * t149;
        let t366 = self.zH * t346;
        let C122_mA = yaw_per_v_delta * P_delta_yaw_mA;
        let t373 = C122_mA + self.zH * t350 + t36 * t189 - mu * t331;
        let t374 = t28 * t331;
        let t375 = self.zH * yaw_per_v_delta;
        let t376 = yaw_per_v_delta * t331;
        let t377 = t10 + t10;
        let t381 = self.c * M12_Jxz_delta - t134 - self.rF * t28;
        let t384 = t10 * t28 - self.mF * t381;
        let t388 = t335 + self.rF * M22_Jxx_delta - self.c * M22_Jxz_delta;
        let t391 = self.mF * t388 + t10 * M22_Jxx_delta;
        let t392 = t344 - mu;
        let t394 = t95 * SF;
        let t395 = M12_Jxz_delta * t394;
        let t396 = self.mF * t392 - t395;
        let t398 = t348 - self.c * C122_Jxz_delta;
        let P_delta_lateral_rF = self.mF * t28;
        let t402 = self.mF * t398 + mu * P_delta_lateral_rF;
        let t403 = t28 * P_delta_lateral_rF;
        let t406 = self.mF * yaw_per_v_delta - yaw_per_v_delta * t394;
        let t409 = yaw_per_v_delta * P_delta_lateral_rF - C122_Jxz_delta * t394;
        let t410 = self.rF * self.rF;
        let t411 = self.rF * t381;
        let t415 = M22_mA + self.c * t209 + self.rF * t388;
        let t416 = self.rF * t392;
        let t422 = C122_mA + self.c * t223 + self.rF * t398 - mu * t381;
        let t423 = t28 * t381;
        let t424 = self.rF * yaw_per_v_delta;
        let t425 = yaw_per_v_delta * t381;
        let t426 = M22_Jzz_delta + M22_Jxx_delta;
        let t427 = t95 * M12_Jxz_delta;
        let t428 = yaw_per_v_delta * t95;
        let t429 = t95 * C122_Jxz_delta;
        let t430 = -(t97 + mu * ST);
        let t431 = t172 - t171;
        let t432 = t229 - t228;
        (
            WhippleMechanismMatrices::from_entries([
                t26, t55, t55, t92, self.w.like(0.0), t108, t430, t116, Sz_all, t114, t114, t117,
                self.w.like(0.0), t118, self.w.like(0.0), t121,
            ]),
            WhippleMechanismDerivatives {
                values: [
                    t129, t158, t165, t167, t198, t431, t199, t200, t203, t206, t216, t219, t220,
                    t237, t432, t238, t239, t244, t260, t262, t264, t273, t267, t276, t277, t281,
                    t282, t285, t286, self.mR, t287, t288, t289, self.rR, t290, self.w.like(1.0),
                    t146, t186, t292, t293, t294, t299, t300, t304, t302, t305, t306, t307, t296,
                    t310, self.mB, t311, t312, t313, t315, t316, t319, self.zB, t295, t320, t321,
                    t322, mu, yaw_per_v_delta, t127, t156, t163, t324, t172, t325, t326, t327, t334,
                    t343, t347, t354, self.mH, t352, t355, t356, t357, t358, t359, t365, t366, t373,
                    self.zH, t331, t374, t375, t376, t28, M22_Jxx_delta, M22_Jzz_delta,
                    C122_Jzz_delta, M12_Jxz_delta, M22_Jxz_delta, C122_Jxz_delta, t377, t384, t391,
                    t396, t395, t402, self.mF, P_delta_lateral_rF, t403, t406, t409, t410, t411,
                    t415, t416, t422, self.rF, t381, t423, t424, t425, t426, t427, t428, t429,
                ],
            },
        )
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl WhippleMechanism<f64> {
    /// The parameter set `benchmark`.
    ///
    /// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1
    pub const BENCHMARK: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3141592653589793, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.0603,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.05892, IHyy: 0.06, IHzz: 0.00708, IHxz: -0.00756,
        rF: 0.35, mF: 3.0, IFxx: 0.1405, IFyy: 0.28,
    };

    /// The parameter set `benchmark_2005`.
    ///
    /// Source: Schwab, Meijaard & Papadopoulos (2005), ENOC 2005
    pub const BENCHMARK_2005: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3217505543966422, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.06,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.0546, IHyy: 0.06, IHzz: 0.0114, IHxz: -0.0162, rF: 0.35,
        mF: 3.0, IFxx: 0.14, IFyy: 0.28,
    };

    /// A bicycle that balances itself without gyroscopic effects and without trail: two points of mass on skates.
    ///
    /// Source: Kooijman, Meijaard, Papadopoulos, Ruina & Schwab (2011), Science 332, 339-342
    pub const TWO_MASS_SKATE: Self = Self {
        w: 1.0, c: 0.0, lam: 0.08726646259971647, g: 9.81, rR: 0.1, mR: 0.0, IRxx: 0.0, IRyy: 0.0,
        xB: 1.2, zB: -0.4, mB: 10.0, IBxx: 0.0, IByy: 0.0, IBzz: 0.0, IBxz: 0.0, xH: 1.02, zH: -0.2,
        mH: 1.0, IHxx: 0.0, IHyy: 0.0, IHzz: 0.0, IHxz: 0.0, rF: 0.1, mF: 0.0, IFxx: 0.0, IFyy: 0.0,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> WhippleMechanism<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 26]) -> Self {
        Self {
            w: values[0], c: values[1], lam: values[2], g: values[3], rR: values[4], mR: values[5],
            IRxx: values[6], IRyy: values[7], xB: values[8], zB: values[9], mB: values[10],
            IBxx: values[11], IByy: values[12], IBzz: values[13], IBxz: values[14], xH: values[15],
            zH: values[16], mH: values[17], IHxx: values[18], IHyy: values[19], IHzz: values[20],
            IHxz: values[21], rF: values[22], mF: values[23], IFxx: values[24], IFyy: values[25],
        }
    }

    /// The parameters as an array in declared order.
    #[must_use]
    pub const fn to_array(&self) -> [T; 26] {
        [
            self.w, self.c, self.lam, self.g, self.rR, self.mR, self.IRxx, self.IRyy, self.xB,
            self.zB, self.mB, self.IBxx, self.IByy, self.IBzz, self.IBxz, self.xH, self.zH, self.mH,
            self.IHxx, self.IHyy, self.IHzz, self.IHxz, self.rF, self.mF, self.IFxx, self.IFyy,
        ]
    }
}

impl<T: Scalar> WhippleMechanism<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> WhippleMechanism<U> {
        let values = self.to_array();
        WhippleMechanism::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl<T: Number> WhippleMechanismMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 16]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c1: carvallo::rows(&entries, 4),
            k0: carvallo::rows(&entries, 8),
            k2: carvallo::rows(&entries, 12),
        }
    }

    /// The rows of M, C0, C1, Kc, K0 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 6] {
        let zeros = [[self.m[0][0].like(0.0); 2]; 2];
        [self.m, zeros, self.c1, zeros, self.k0, self.k2]
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for WhippleMechanism<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 26];

    type Over<U: Number> = WhippleMechanism<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "WhippleMechanism",
        docs: "The Whipple-Carvallo bicycle, derived from its bodies, joints and wheels.\n\nFour rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally\nsymmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,\nx forward, y to the right, z down, so that a centre of mass above the ground has z < 0.\n\nThe declaration asserts that the matrices are those of Appendix A of the paper, which is proved when it is compiled.\n[`Whipple`](crate::Whipple) computes them from these formulas.",
        source: "Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3",
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
        ],
        coordinates: &[
            CoordinateInfo::new("phi", "rad")
                .label("lean")
                .docs("Lean of the rear frame, positive to the right."),
            CoordinateInfo::new("delta", "rad")
                .label("steer")
                .docs("Steer of the front frame relative to the rear frame, positive to the right."),
        ],
        matrices: &["M", "C1", "K0", "K2"],
        entries: &[
            EntryInfo::at(&[("M", 0, 0)]), EntryInfo::at(&[("M", 0, 1), ("M", 1, 0)]),
            EntryInfo::at(&[("M", 1, 1)]), EntryInfo::at(&[("C1", 0, 1)]),
            EntryInfo::at(&[("C1", 1, 0)]), EntryInfo::at(&[("C1", 1, 1)]),
            EntryInfo::at(&[("K0", 0, 0)]), EntryInfo::at(&[("K0", 0, 1), ("K0", 1, 0)]),
            EntryInfo::at(&[("K0", 1, 1)]), EntryInfo::at(&[("K2", 0, 1)]),
            EntryInfo::at(&[("K2", 1, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "benchmark",
                docs: "",
                source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1",
                values: &WhippleMechanism::<f64>::BENCHMARK.to_array(),
            },
            SetInfo {
                name: "benchmark_2005",
                docs: "",
                source: "Schwab, Meijaard & Papadopoulos (2005), ENOC 2005",
                values: &WhippleMechanism::<f64>::BENCHMARK_2005.to_array(),
            },
            SetInfo {
                name: "two_mass_skate",
                docs: "A bicycle that balances itself without gyroscopic effects and without trail: two points of mass on skates.",
                source: "Kooijman, Meijaard, Papadopoulos, Ruina & Schwab (2011), Science 332, 339-342",
                values: &WhippleMechanism::<f64>::TWO_MASS_SKATE.to_array(),
            },
        ],
        gravity: Some(3),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("WhippleMechanism", 26, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("WhippleMechanism", 26, values)?;
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
        let info = <Self as Model<2>>::INFO;
        info.validate(&self.to_array().map(Scalar::to_f64))?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 2> {
        Coefficients::from_rows(WhippleMechanismMatrices::rows(&self.matrices()))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl<T: Number> Evaluator<T, 2> for WhippleMechanism<T> {
    type Entries = [T; 11];

    #[inline(always)]
    fn from_parameters(parameter: impl FnMut(usize) -> T) -> Self {
        Self::from_array(core::array::from_fn(parameter))
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        let matrices = self.matrices();
        [
            matrices.m[0][0], matrices.m[0][1], matrices.m[1][1], matrices.c1[0][1],
            matrices.c1[1][0], matrices.c1[1][1], matrices.k0[0][0], matrices.k0[0][1],
            matrices.k0[1][1], matrices.k2[0][1], matrices.k2[1][1],
        ]
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 6] {
        WhippleMechanismMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> WhippleMechanismDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<WhippleMechanismMatrices<T>> {
        if parameter >= 26 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = WhippleMechanismMatrices {
            m: [[zero; 2]; 2], c1: [[zero; 2]; 2], k0: [[zero; 2]; 2], k2: [[zero; 2]; 2],
        };
        for position in 0..158 {
            let partial = <WhippleMechanismDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C1 => &mut matrices.c1,
                MatrixName::K0 => &mut matrices.k0,
                MatrixName::K2 => &mut matrices.k2,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<2> for WhippleMechanism<T> {
    type Derivatives = [Coefficients<T, 2>; 26];

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 6]); 26];
        for position in 0..158 {
            Partial::write(&<WhippleMechanismDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(WhippleMechanismMatrices::rows(&matrices)), all)
    }
}

impl WhippleMechanismDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 158] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 0), Partial::new(MatrixName::M, 1, 0, 0, 0),
        Partial::new(MatrixName::M, 1, 1, 0, 1), Partial::new(MatrixName::C1, 0, 1, 0, 2),
        Partial::new(MatrixName::C1, 1, 0, 0, 3), Partial::new(MatrixName::C1, 1, 1, 0, 4),
        Partial::new(MatrixName::K0, 0, 1, 0, 5), Partial::new(MatrixName::K0, 1, 0, 0, 5),
        Partial::new(MatrixName::K0, 1, 1, 0, 6).negative(),
        Partial::new(MatrixName::K2, 0, 1, 0, 7).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 8), Partial::new(MatrixName::M, 0, 1, 1, 9),
        Partial::new(MatrixName::M, 1, 0, 1, 9), Partial::new(MatrixName::M, 1, 1, 1, 10),
        Partial::new(MatrixName::C1, 0, 1, 1, 11),
        Partial::new(MatrixName::C1, 1, 0, 1, 12).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 13),
        Partial::new(MatrixName::K0, 0, 1, 1, 14),
        Partial::new(MatrixName::K0, 1, 0, 1, 14),
        Partial::new(MatrixName::K0, 1, 1, 1, 15).negative(),
        Partial::new(MatrixName::K2, 1, 1, 1, 16), Partial::new(MatrixName::M, 0, 1, 2, 17),
        Partial::new(MatrixName::M, 1, 0, 2, 17), Partial::new(MatrixName::M, 1, 1, 2, 18),
        Partial::new(MatrixName::C1, 0, 1, 2, 19).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 20), Partial::new(MatrixName::C1, 1, 1, 2, 21),
        Partial::new(MatrixName::K0, 0, 1, 2, 22), Partial::new(MatrixName::K0, 1, 0, 2, 22),
        Partial::new(MatrixName::K0, 1, 1, 2, 23),
        Partial::new(MatrixName::K2, 0, 1, 2, 24).negative(),
        Partial::new(MatrixName::K2, 1, 1, 2, 25), Partial::new(MatrixName::M, 0, 0, 4, 26),
        Partial::new(MatrixName::C1, 0, 1, 4, 27), Partial::new(MatrixName::C1, 1, 0, 4, 28),
        Partial::new(MatrixName::K0, 0, 0, 4, 29).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 30),
        Partial::new(MatrixName::M, 0, 0, 5, 31),
        Partial::new(MatrixName::C1, 0, 1, 5, 32),
        Partial::new(MatrixName::K0, 0, 0, 5, 33).negative(),
        Partial::new(MatrixName::K2, 0, 1, 5, 34), Partial::new(MatrixName::M, 0, 0, 6, 35),
        Partial::new(MatrixName::M, 1, 1, 6, 36), Partial::new(MatrixName::C1, 1, 1, 6, 37),
        Partial::new(MatrixName::C1, 0, 1, 7, 38),
        Partial::new(MatrixName::C1, 1, 0, 7, 38).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 39),
        Partial::new(MatrixName::M, 0, 1, 8, 40).negative(),
        Partial::new(MatrixName::M, 1, 0, 8, 40).negative(),
        Partial::new(MatrixName::M, 1, 1, 8, 41),
        Partial::new(MatrixName::C1, 0, 1, 8, 42).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 43),
        Partial::new(MatrixName::K0, 0, 1, 8, 44).negative(),
        Partial::new(MatrixName::K0, 1, 0, 8, 44).negative(),
        Partial::new(MatrixName::K0, 1, 1, 8, 45).negative(),
        Partial::new(MatrixName::K2, 1, 1, 8, 46), Partial::new(MatrixName::M, 0, 0, 9, 47),
        Partial::new(MatrixName::M, 0, 1, 9, 48).negative(),
        Partial::new(MatrixName::M, 1, 0, 9, 48).negative(),
        Partial::new(MatrixName::C1, 0, 1, 9, 49).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 50),
        Partial::new(MatrixName::K2, 0, 1, 9, 51).negative(),
        Partial::new(MatrixName::M, 0, 0, 10, 52),
        Partial::new(MatrixName::M, 0, 1, 10, 53).negative(),
        Partial::new(MatrixName::M, 1, 0, 10, 53).negative(),
        Partial::new(MatrixName::M, 1, 1, 10, 54),
        Partial::new(MatrixName::C1, 0, 1, 10, 55).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 56),
        Partial::new(MatrixName::K0, 0, 0, 10, 57),
        Partial::new(MatrixName::K0, 0, 1, 10, 58).negative(),
        Partial::new(MatrixName::K0, 1, 0, 10, 58).negative(),
        Partial::new(MatrixName::K0, 1, 1, 10, 59).negative(),
        Partial::new(MatrixName::K2, 0, 1, 10, 60).negative(),
        Partial::new(MatrixName::K2, 1, 1, 10, 61), Partial::new(MatrixName::M, 0, 0, 11, 35),
        Partial::new(MatrixName::M, 1, 1, 13, 36), Partial::new(MatrixName::C1, 1, 1, 13, 37),
        Partial::new(MatrixName::M, 0, 1, 14, 62), Partial::new(MatrixName::M, 1, 0, 14, 62),
        Partial::new(MatrixName::C1, 0, 1, 14, 63),
        Partial::new(MatrixName::M, 0, 1, 15, 64).negative(),
        Partial::new(MatrixName::M, 1, 0, 15, 64).negative(),
        Partial::new(MatrixName::M, 1, 1, 15, 65).negative(),
        Partial::new(MatrixName::C1, 0, 1, 15, 66).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 67),
        Partial::new(MatrixName::K0, 0, 1, 15, 68).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 68).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 69).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 70), Partial::new(MatrixName::M, 0, 0, 16, 71),
        Partial::new(MatrixName::M, 0, 1, 16, 72), Partial::new(MatrixName::M, 1, 0, 16, 72),
        Partial::new(MatrixName::M, 1, 1, 16, 73), Partial::new(MatrixName::C1, 0, 1, 16, 74),
        Partial::new(MatrixName::C1, 1, 1, 16, 75), Partial::new(MatrixName::K0, 0, 0, 16, 76),
        Partial::new(MatrixName::K0, 0, 1, 16, 77), Partial::new(MatrixName::K0, 1, 0, 16, 77),
        Partial::new(MatrixName::K0, 1, 1, 16, 78),
        Partial::new(MatrixName::K2, 0, 1, 16, 79).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 80).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 81), Partial::new(MatrixName::M, 0, 1, 17, 82),
        Partial::new(MatrixName::M, 1, 0, 17, 82), Partial::new(MatrixName::M, 1, 1, 17, 83),
        Partial::new(MatrixName::C1, 0, 1, 17, 84), Partial::new(MatrixName::C1, 1, 1, 17, 85),
        Partial::new(MatrixName::K0, 0, 0, 17, 86), Partial::new(MatrixName::K0, 0, 1, 17, 87),
        Partial::new(MatrixName::K0, 1, 0, 17, 87), Partial::new(MatrixName::K0, 1, 1, 17, 88),
        Partial::new(MatrixName::K2, 0, 1, 17, 89).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 90).negative(),
        Partial::new(MatrixName::M, 0, 0, 18, 35), Partial::new(MatrixName::M, 0, 1, 18, 91),
        Partial::new(MatrixName::M, 1, 0, 18, 91), Partial::new(MatrixName::M, 1, 1, 18, 92),
        Partial::new(MatrixName::M, 1, 1, 20, 93), Partial::new(MatrixName::C1, 1, 1, 20, 94),
        Partial::new(MatrixName::M, 0, 1, 21, 95), Partial::new(MatrixName::M, 1, 0, 21, 95),
        Partial::new(MatrixName::M, 1, 1, 21, 96), Partial::new(MatrixName::C1, 0, 1, 21, 63),
        Partial::new(MatrixName::C1, 1, 1, 21, 97), Partial::new(MatrixName::M, 0, 0, 22, 98),
        Partial::new(MatrixName::M, 0, 1, 22, 99), Partial::new(MatrixName::M, 1, 0, 22, 99),
        Partial::new(MatrixName::M, 1, 1, 22, 100), Partial::new(MatrixName::C1, 0, 1, 22, 101),
        Partial::new(MatrixName::C1, 1, 0, 22, 102), Partial::new(MatrixName::C1, 1, 1, 22, 103),
        Partial::new(MatrixName::K0, 0, 0, 22, 104).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 105).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 105).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 106).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 107),
        Partial::new(MatrixName::K2, 1, 1, 22, 108),
        Partial::new(MatrixName::M, 0, 0, 23, 109),
        Partial::new(MatrixName::M, 0, 1, 23, 110).negative(),
        Partial::new(MatrixName::M, 1, 0, 23, 110).negative(),
        Partial::new(MatrixName::M, 1, 1, 23, 111),
        Partial::new(MatrixName::C1, 0, 1, 23, 112),
        Partial::new(MatrixName::C1, 1, 1, 23, 113),
        Partial::new(MatrixName::K0, 0, 0, 23, 114).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 115), Partial::new(MatrixName::K0, 1, 0, 23, 115),
        Partial::new(MatrixName::K0, 1, 1, 23, 116), Partial::new(MatrixName::K2, 0, 1, 23, 117),
        Partial::new(MatrixName::K2, 1, 1, 23, 118).negative(),
        Partial::new(MatrixName::M, 0, 0, 24, 35), Partial::new(MatrixName::M, 0, 1, 24, 91),
        Partial::new(MatrixName::M, 1, 0, 24, 91), Partial::new(MatrixName::M, 1, 1, 24, 119),
        Partial::new(MatrixName::C1, 1, 1, 24, 94), Partial::new(MatrixName::C1, 0, 1, 25, 120),
        Partial::new(MatrixName::C1, 1, 0, 25, 120).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 121),
        Partial::new(MatrixName::K2, 1, 1, 25, 122),
    ];
}
