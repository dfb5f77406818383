// @generated from generated/models/rear_steered.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 55b70df1229c7642

#![allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    LengthError, MatrixName, Model, ModelInfo, Number, ParameterError, ParameterInfo,
    Partial, Rate, Scalar, SetInfo,
};

// --- The parameters ------------------------------------------------------------------------------

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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RearSteered<T = f64> {
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

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`RearSteered`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RearSteeredMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: [[T; 2]; 2],
    /// Damping C1, a coefficient of v q'.
    pub c1: [[T; 2]; 2],
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: [[T; 2]; 2],
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: [[T; 2]; 2],
}

impl<T: Number> RearSteered<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 46 additions, 46 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 99 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> RearSteeredMatrices<T> {
        let t6 = self.zH * self.mH;
        let t10 = self.rF * self.mF;
        let Jxx_delta = self.IHxx + self.IFxx + self.zH * t6 + self.rF * t10;
        let t17 = self.rR * self.mR;
        let t21 = self.zB * self.mB;
        let t26 = self.IRxx + self.IBxx + Jxx_delta + self.rR * t17 + self.zB * t21;
        let (t28, t41) = self.lam.sin_cos();
        let t33 = self.w + self.c;
        let t34 = t33 - self.xH;
        let t35 = self.mH * t34;
        let Jxz_delta = t10 * self.c - self.zH * t35 - self.IHxz;
        let hx_delta = Jxz_delta * t41 - Jxx_delta * t28;
        let t44 = t41 / self.w;
        let yaw_by_delta = self.c * t44;
        let Sz_delta = t6 - t10;
        let Jxz_all = Jxz_delta + t21 * self.xB + t33 * Sz_delta - self.IBxz;
        let t55 = hx_delta + yaw_by_delta * Jxz_all;
        let t59 = self.mF * self.c;
        let t62 = self.IFxx + self.IHzz;
        let hz_delta = t41 * (t34 * t35 + self.c * t59 + t62) - t28 * Jxz_delta;
        let py_delta = t28 * Sz_delta + t41 * (t35 + t59);
        let M_yaw_delta = hz_delta - t33 * py_delta;
        let t74 = self.mB * self.xB;
        let t76 = self.mH * self.xH;
        let t78 = self.mF * self.w;
        let t85 = yaw_by_delta
            * (self.IRxx + t62 + self.IBzz + self.xB * t74 + self.xH * t76
                + self.w * t78);
        let P_delta_yaw = M_yaw_delta + t85;
        let t91 = yaw_by_delta * (M_yaw_delta + P_delta_yaw) + t41 * hz_delta
            - t28 * hx_delta;
        let h_spin_R = self.IFyy / self.rF;
        let h_wheels_all = h_spin_R + self.IRyy / self.rR;
        let Sz_all = t21 + Sz_delta - t17;
        let t100 = h_wheels_all - Sz_all;
        let t103 = t41 * h_spin_R;
        let t105 = yaw_by_delta * t100 + t103 - t44 * Jxz_all;
        let t110 = yaw_by_delta * (t74 + t76 + t78);
        let P_delta_lateral = py_delta - t110;
        let t114 = yaw_by_delta * P_delta_lateral - t44 * P_delta_yaw;
        let t115 = t28 * P_delta_lateral;
        let t119 = t44 * (t28 * h_spin_R - P_delta_lateral);
        let t120 = -(t103 + yaw_by_delta * h_wheels_all);
        let t121 = t110 - py_delta;
        let t122 = -(t44 * t100);
        RearSteeredMatrices::from_entries([
            t26, t55, t55, t91, self.w.like(0.0), t105, t120, t114, Sz_all, t121, t121, t115,
            self.w.like(0.0), t122, self.w.like(0.0), t119,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`RearSteered`] that follow from its coordinates q = (`phi`, `delta`), to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RearSteeredKinematics<T = f64> {
    /// Lateral velocity, to the right, in m/s: of the point of `B` that is at the origin.
    pub lateral: Rate<T, 2>,
    /// Yaw rate, to the right, in rad/s: of `B`.
    pub yaw: Rate<T, 2>,
    /// Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_F: Rate<T, 2>,
    /// Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_R: Rate<T, 2>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of `Tphi` (lean torque) in N*m, `Tdelta` (steer torque) in N*m.
    pub forces: [[T; 2]; 2],
}

impl<T: Scalar> RearSteered<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 3 negations and 1 trigonometric function: 8 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> RearSteeredKinematics<T> {
        let t6 = self.lam.cos() / self.w;
        let yaw_by_delta = self.c * t6;
        let t12 = -t6;
        let t13 = -(self.w.like(1.0) / self.rR);
        let t14 = -(self.w.like(1.0) / self.rF);
        RearSteeredKinematics {
            lateral: Rate {
                speed: self.w.like(0.0),
                rates: [self.w.like(0.0), self.w.like(0.0)],
                coordinates: [self.w.like(0.0), self.w.like(0.0)],
                heading: self.w.like(1.0),
            },
            yaw: Rate {
                speed: self.w.like(0.0),
                rates: [self.w.like(0.0), yaw_by_delta],
                coordinates: [self.w.like(0.0), t12],
                heading: self.w.like(0.0),
            },
            wheel_F: Rate {
                speed: t13,
                rates: [self.w.like(0.0), self.w.like(0.0)],
                coordinates: [self.w.like(0.0), self.w.like(0.0)],
                heading: self.w.like(0.0),
            },
            wheel_R: Rate {
                speed: t14,
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

/// The derivatives of the matrices of [`RearSteered`] with respect to its parameters, in SI units: those that are not
/// zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RearSteeredDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 123],
}

impl<T: Number> RearSteered<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 168 additions, 262 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 437 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (RearSteeredMatrices<T>, RearSteeredDerivatives<T>) {
        let t6 = self.zH * self.mH;
        let t10 = self.rF * self.mF;
        let Jxx_delta = self.IHxx + self.IFxx + self.zH * t6 + self.rF * t10;
        let t17 = self.rR * self.mR;
        let t21 = self.zB * self.mB;
        let t26 = self.IRxx + self.IBxx + Jxx_delta + self.rR * t17 + self.zB * t21;
        let (t28, t41) = self.lam.sin_cos();
        let t32 = self.w + self.c;
        let t34 = t32 - self.xH;
        let t35 = self.mH * t34;
        let Jxz_delta = t10 * self.c - self.zH * t35 - self.IHxz;
        let t42 = Jxz_delta * t41;
        let hx_delta = t42 - Jxx_delta * t28;
        let t44 = self.w.like(1.0) / self.w;
        let t45 = t41 * t44;
        let yaw_by_delta = self.c * t45;
        let Sz_delta = t6 - t10;
        let Jxz_all = Jxz_delta + t21 * self.xB + t32 * Sz_delta - self.IBxz;
        let t56 = hx_delta + yaw_by_delta * Jxz_all;
        let t58 = t28 * Jxz_delta;
        let t60 = self.IFxx + self.IHzz;
        let t61 = self.mF * self.c;
        let t65 = t60 + self.c * t61 + t34 * t35;
        let hz_delta = t41 * t65 - t58;
        let t70 = t35 + t61;
        let py_delta = t28 * Sz_delta + t41 * t70;
        let M_yaw_delta = hz_delta - t32 * py_delta;
        let t76 = self.mF * self.w;
        let t78 = self.mB * self.xB;
        let t80 = self.mH * self.xH;
        let P_delta_yaw_yaw_by_delta = self.IRxx + t60 + self.IBzz + self.w * t76
            + self.xB * t78 + self.xH * t80;
        let t87 = yaw_by_delta * P_delta_yaw_yaw_by_delta;
        let P_delta_yaw = M_yaw_delta + t87;
        let t89 = M_yaw_delta + P_delta_yaw;
        let t92 = t41 * hz_delta + yaw_by_delta * t89 - t28 * hx_delta;
        let t95 = self.w.like(1.0) / self.rF;
        let h_spin_R = self.IFyy * t95;
        let t97 = t41 * h_spin_R;
        let t98 = t45 * Jxz_all;
        let t100 = self.w.like(1.0) / self.rR;
        let t101 = self.IRyy * t100;
        let h_wheels_all = h_spin_R + t101;
        let Sz_all = t21 + Sz_delta - t17;
        let t105 = h_wheels_all - Sz_all;
        let t108 = t97 + yaw_by_delta * t105 - t98;
        let t113 = t76 + t78 + t80;
        let t114 = yaw_by_delta * t113;
        let P_delta_lateral = py_delta - t114;
        let t117 = yaw_by_delta * P_delta_lateral - t45 * P_delta_yaw;
        let t118 = t28 * P_delta_lateral;
        let t120 = t28 * h_spin_R;
        let t121 = t120 - P_delta_lateral;
        let t122 = t45 * t121;
        let M12_Jxz_delta = t41 + yaw_by_delta;
        let t124 = t6 * M12_Jxz_delta;
        let t126 = yaw_by_delta * Sz_delta - t124;
        let t127 = t44 * t45;
        let t128 = self.c * Jxz_all;
        let t130 = t126 - t127 * t128;
        let t131 = t34 * t41;
        let t134 = self.mH * t131 + t35 * t41;
        let t135 = yaw_by_delta + yaw_by_delta;
        let M22_hz_delta = t41 + t135;
        let t139 = t28 * (t41 + M22_hz_delta);
        let t141 = self.mH * t41;
        let t142 = t32 * t135;
        let t145 = t134 * M22_hz_delta + t6 * t139 - t141 * t142;
        let t147 = t145 - py_delta * t135;
        let t148 = self.w * yaw_by_delta;
        let P_delta_yaw_w = self.mF * t148 + yaw_by_delta * t76;
        let M22_yaw_by_delta = t87 + t89;
        let t154 = self.c * M22_yaw_by_delta;
        let t157 = t147 + yaw_by_delta * P_delta_yaw_w - t127 * t154;
        let t158 = t6 * t45;
        let t160 = t158 - t45 * Sz_delta;
        let t162 = self.c * t105 - Jxz_all;
        let t164 = t160 - t127 * t162;
        let t165 = self.c * h_wheels_all;
        let t166 = t127 * t165;
        let C122_Jxz_delta = t28 * t45;
        let C122_py_delta = t32 * t45;
        let t173 = t141 * C122_py_delta - t45 * t134 - t6 * C122_Jxz_delta;
        let t175 = t173 + t45 * py_delta;
        let t178 = self.c * t113;
        let t180 = self.mF * yaw_by_delta - t127 * t178;
        let P_delta_lateral_w = t141 - t180;
        let C122_yaw_by_delta = P_delta_lateral - t45 * P_delta_yaw_yaw_by_delta;
        let t186 = self.c * C122_yaw_by_delta - P_delta_yaw;
        let t190 = t175 + yaw_by_delta * P_delta_lateral_w - t45 * P_delta_yaw_w
            - t127 * t186;
        let t191 = t28 * P_delta_lateral_w;
        let t192 = t105 * t127;
        let t195 = t45 * P_delta_lateral_w + t121 * t127;
        let t198 = t98 + t126 + t10 * M12_Jxz_delta;
        let py_delta_mF = self.c * t41;
        let hz_delta_c = self.mF * py_delta_mF + t41 * t61;
        let py_delta_c = self.mF * t41;
        let t211 = t147 + t45 * M22_yaw_by_delta + M22_hz_delta * hz_delta_c - t10 * t139
            - t142 * py_delta_c;
        let t214 = t160 + t45 * (t105 - t10);
        let t215 = t45 * h_wheels_all;
        let t221 = t45 * t113 - t141 - py_delta_c;
        let t227 = t175 + t10 * C122_Jxz_delta + t45 * (C122_yaw_by_delta - hz_delta_c)
            + C122_py_delta * py_delta_c - yaw_by_delta * t221;
        let t228 = t28 * t221;
        let t229 = t45 * t221;
        let t231 = t58 + Jxx_delta * t41;
        let t232 = t28 * t44;
        let t234 = t231 + t128 * t232;
        let t239 = t42 + t28 * t65;
        let py_delta_lam = t41 * Sz_delta - t28 * t70;
        let t250 = t28 * t231 - t41 * hx_delta - t28 * hz_delta - M22_hz_delta * t239
            - t154 * t232 - t142 * py_delta_lam;
        let t252 = t120 + t162 * t232;
        let t254 = t120 + t165 * t232;
        let P_delta_lateral_lam = py_delta_lam + t178 * t232;
        let t263 = t45 * t239 + yaw_by_delta * P_delta_lateral_lam
            + C122_py_delta * py_delta_lam - t186 * t232;
        let t266 = t28 * P_delta_lateral_lam + t41 * P_delta_lateral;
        let t267 = t105 * t232;
        let t271 = t45 * (t97 - P_delta_lateral_lam) - t121 * t232;
        let t272 = t17 + t17;
        let t273 = t100 * t101;
        let t274 = self.mR - t273;
        let t275 = yaw_by_delta * t274;
        let t276 = yaw_by_delta * t273;
        let t277 = t45 * t274;
        let t278 = self.rR * self.rR;
        let t279 = self.rR * yaw_by_delta;
        let t280 = self.rR * t45;
        let t282 = yaw_by_delta * yaw_by_delta;
        let t283 = t45 * yaw_by_delta;
        let t284 = yaw_by_delta * t100;
        let t285 = t45 * t100;
        let t286 = t21 * yaw_by_delta;
        let t287 = yaw_by_delta * self.xB;
        let t288 = self.mB * t287;
        let P_delta_yaw_xB = t288 + yaw_by_delta * t78;
        let t291 = yaw_by_delta * P_delta_yaw_xB;
        let t292 = t21 * t45;
        let t294 = self.mB * yaw_by_delta;
        let t296 = t45 * P_delta_yaw_xB + yaw_by_delta * t294;
        let t297 = t28 * t294;
        let t298 = t45 * t294;
        let t299 = t21 + t21;
        let t301 = yaw_by_delta + t45 * self.xB;
        let t302 = self.mB * t301;
        let t303 = self.mB * t45;
        let t304 = self.zB * self.zB;
        let t305 = self.zB * t287;
        let P_delta_yaw_mB = self.xB * t287;
        let t307 = yaw_by_delta * P_delta_yaw_mB;
        let t308 = self.zB * t301;
        let t311 = t45 * P_delta_yaw_mB + yaw_by_delta * t287;
        let t312 = t28 * t287;
        let t313 = self.zB * t45;
        let t314 = t45 * t287;
        let t315 = self.xH * yaw_by_delta;
        let P_delta_yaw_xH = self.mH * t315 + yaw_by_delta * t80;
        let t320 = yaw_by_delta * P_delta_yaw_xH - t145;
        let t323 = t141 + self.mH * yaw_by_delta;
        let t326 = t173 + t45 * P_delta_yaw_xH + yaw_by_delta * t323;
        let t327 = t28 * t323;
        let t328 = t45 * t323;
        let Jxx_delta_zH = t6 + t6;
        let M12_Sz_delta = t32 * yaw_by_delta;
        let t335 = self.mH * M12_Sz_delta - t28 * Jxx_delta_zH - t35 * M12_Jxz_delta;
        let M22_Jxx_delta = t28 * t28;
        let py_delta_zH = self.mH * t28;
        let t342 = t35 * t139 + Jxx_delta_zH * M22_Jxx_delta - t142 * py_delta_zH;
        let t343 = yaw_by_delta + C122_py_delta;
        let t346 = t35 * t45 - self.mH * t343;
        let t351 = yaw_by_delta * py_delta_zH + C122_py_delta * py_delta_zH
            - t35 * C122_Jxz_delta;
        let t352 = t28 * py_delta_zH;
        let t353 = self.mH * t45;
        let t354 = t45 * py_delta_zH;
        let Jxx_delta_mH = self.zH * self.zH;
        let t358 = self.zH * t34;
        let t361 = self.zH * M12_Sz_delta - t28 * Jxx_delta_mH - M12_Jxz_delta * t358;
        let P_delta_yaw_mH = self.xH * t315;
        let hz_delta_mH = t34 * t131;
        let py_delta_mH = t131 + self.zH * t28;
        let t374 = yaw_by_delta * P_delta_yaw_mH + M22_hz_delta * hz_delta_mH
            + M22_Jxx_delta * Jxx_delta_mH + t139 * t358 - t142 * py_delta_mH;
        let t377 = t45 * t358 - self.zH * t343;
        let t380 = t315 - py_delta_mH;
        let t386 = C122_py_delta * py_delta_mH - t45 * (P_delta_yaw_mH + hz_delta_mH)
            - yaw_by_delta * t380 - C122_Jxz_delta * t358;
        let t387 = t28 * t380;
        let t388 = self.zH * t45;
        let t389 = t45 * t380;
        let t391 = t282 + t41 * M22_hz_delta;
        let t393 = t283 + t41 * t45;
        let t394 = t10 + t10;
        let t397 = self.rF * t28;
        let t399 = self.c * M12_Jxz_delta - M12_Sz_delta - t397;
        let t401 = self.mF * t399 - t10 * t28;
        let t406 = t28 * t142 + self.rF * M22_Jxx_delta - self.c * t139;
        let t409 = self.mF * t406 + t10 * M22_Jxx_delta;
        let t410 = t343 - yaw_by_delta;
        let t412 = t95 * h_spin_R;
        let t413 = M12_Jxz_delta * t412;
        let t414 = self.mF * t410 - t413;
        let t417 = self.c * C122_Jxz_delta - t28 * C122_py_delta;
        let t419 = self.mF * t28;
        let t421 = self.mF * t417 - yaw_by_delta * t419;
        let t422 = t28 * t419;
        let t425 = t45 * t412 - self.mF * t45;
        let t428 = t45 * t419 - C122_Jxz_delta * t412;
        let t429 = self.rF * self.rF;
        let t430 = self.rF * t399;
        let P_delta_yaw_mF = self.w * t148;
        let hz_delta_mF = self.c * py_delta_mF;
        let t439 = self.rF * t406 + yaw_by_delta * P_delta_yaw_mF
            + M22_hz_delta * hz_delta_mF - t142 * py_delta_mF;
        let t440 = self.rF * t410;
        let t445 = t148 + t397 - py_delta_mF;
        let t450 = self.rF * t417 + C122_py_delta * py_delta_mF
            - t45 * (P_delta_yaw_mF + hz_delta_mF) - yaw_by_delta * t445;
        let t451 = t28 * t445;
        let t452 = self.rF * t45;
        let t453 = t45 * t445;
        let t454 = M22_Jxx_delta + t391;
        let t455 = t95 * M12_Jxz_delta;
        let t456 = t45 * t95;
        let t457 = t95 * C122_Jxz_delta;
        let t458 = -(t97 + yaw_by_delta * h_wheels_all);
        let t459 = t114 - py_delta;
        let t460 = -(t45 * t105);
        let t461 = t180 - t141;
        (
            RearSteeredMatrices::from_entries([
                t26, t56, t56, t92, self.w.like(0.0), t108, t458, t117, Sz_all, t459, t459, t118,
                self.w.like(0.0), t460, self.w.like(0.0), t122,
            ]),
            RearSteeredDerivatives {
                values: [
                    t130, t157, t164, t166, t190, t461, t191, t192, t195, t198, t211, t214, t215,
                    t227, t221, t228, t229, t234, t250, t252, t254, t263, P_delta_lateral_lam, t266,
                    t267, t271, t272, t275, t276, self.mR, t277, t278, t279, self.rR, t280,
                    self.w.like(1.0), t282, t283, t284, t285, t286, t291, t292, t296, t294, t297,
                    t298, t299, t288, t302, self.mB, t303, t304, t305, t307, t308, t311, self.zB,
                    t287, t312, t313, t314, yaw_by_delta, t45, t124, t320, t158, t326, t323, t327,
                    t328, Jxx_delta_zH, t335, t342, t346, t351, self.mH, py_delta_zH, t352, t353,
                    t354, Jxx_delta_mH, t361, t374, t377, t386, self.zH, t380, t387, t388, t389,
                    t28, M22_Jxx_delta, t391, t393, M12_Jxz_delta, t139, C122_Jxz_delta, t394, t401,
                    t409, t414, t413, t421, self.mF, t419, t422, t425, t428, t429, t430, t439, t440,
                    t450, self.rF, t445, t451, t452, t453, t454, t455, t456, t457,
                ],
            },
        )
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl RearSteered<f64> {
    /// The parameter set `backwards`.
    ///
    /// Source: The benchmark of Meijaard et al. (2007), Table 1, run backwards
    pub const BACKWARDS: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3141592653589793, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.0603,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.05892, IHyy: 0.06, IHzz: 0.00708, IHxz: -0.00756,
        rF: 0.35, mF: 3.0, IFxx: 0.1405, IFyy: 0.28,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> RearSteered<T> {
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

impl<T: Scalar> RearSteered<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> RearSteered<U> {
        let values = self.to_array();
        RearSteered::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl<T: Number> RearSteeredMatrices<T> {
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

impl<T: Scalar> Model<2> for RearSteered<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 26];

    type Over<U: Number> = RearSteered<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "RearSteered",
        docs: "A bicycle that is steered at the rear: a Whipple bicycle run backwards, with its geometry mirrored.\n\nFour rigid bodies (front wheel F, main frame with a rigid rider B, steered frame H, steered rear wheel R),\nlaterally symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the front\ncontact point, x forward, y to the right, z down. Lengths along x are counted backward from the front contact, so\nthat the parameters of a bicycle are those of the same bicycle run backwards.",
        source: "Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3",
        parameters: &[
            ParameterInfo::new("w", "m", Domain::POSITIVE).docs("Wheel base."),
            ParameterInfo::new("c", "m", Domain::FINITE)
                .docs("Distance by which the steer axis meets the ground behind the contact of the steered wheel."),
            ParameterInfo::new(
                    "lam",
                    "rad",
                    Domain::between(Bound::Open(-1.5707963267948966), Bound::Open(1.5707963267948966)),
                )
                .symbol("λ")
                .docs("Steer axis tilt: from the ground upward the axis leans forward by this angle."),
            ParameterInfo::new("g", "N/kg", Domain::NONNEGATIVE)
                .docs("Gravitational field strength."),
            ParameterInfo::new("rR", "m", Domain::POSITIVE)
                .docs("Radius of the front wheel."),
            ParameterInfo::new("mR", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the front wheel."),
            ParameterInfo::new("IRxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Radial moment of inertia of the front wheel; by symmetry also about the vertical."),
            ParameterInfo::new("IRyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Axial moment of inertia of the front wheel."),
            ParameterInfo::new("xB", "m", Domain::FINITE)
                .docs("Centre of mass of the main frame and rider, behind the front contact."),
            ParameterInfo::new("zB", "m", Domain::FINITE)
                .docs("Centre of mass of the main frame and rider, downward."),
            ParameterInfo::new("mB", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the main frame and rider."),
            ParameterInfo::new("IBxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the main frame and rider about its centre of mass, in roll."),
            ParameterInfo::new("IByy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the main frame and rider about its centre of mass, in pitch.")
                .unused(),
            ParameterInfo::new("IBzz", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the main frame and rider about its centre of mass, in yaw."),
            ParameterInfo::new("IBxz", "kg*m^2", Domain::FINITE)
                .docs("Product of inertia of the main frame and rider about its centre of mass."),
            ParameterInfo::new("xH", "m", Domain::FINITE)
                .docs("Centre of mass of the steered frame, behind the front contact."),
            ParameterInfo::new("zH", "m", Domain::FINITE)
                .docs("Centre of mass of the steered frame, downward."),
            ParameterInfo::new("mH", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the steered frame."),
            ParameterInfo::new("IHxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the steered frame about its centre of mass, in roll."),
            ParameterInfo::new("IHyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the steered frame about its centre of mass, in pitch.")
                .unused(),
            ParameterInfo::new("IHzz", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the steered frame about its centre of mass, in yaw."),
            ParameterInfo::new("IHxz", "kg*m^2", Domain::FINITE)
                .docs("Product of inertia of the steered frame about its centre of mass."),
            ParameterInfo::new("rF", "m", Domain::POSITIVE)
                .docs("Radius of the rear wheel."),
            ParameterInfo::new("mF", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the rear wheel."),
            ParameterInfo::new("IFxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Radial moment of inertia of the rear wheel; by symmetry also about the vertical."),
            ParameterInfo::new("IFyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Axial moment of inertia of the rear wheel."),
        ],
        coordinates: &[
            CoordinateInfo::new("phi", "rad")
                .label("lean")
                .docs("Lean of the main frame, positive to the right."),
            CoordinateInfo::new("delta", "rad")
                .label("steer")
                .docs("Steer of the steered frame relative to the main frame, positive to the right seen from above."),
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
                name: "backwards",
                docs: "",
                source: "The benchmark of Meijaard et al. (2007), Table 1, run backwards",
                values: &RearSteered::<f64>::BACKWARDS.to_array(),
            },
        ],
        gravity: Some(3),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("RearSteered", 26, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("RearSteered", 26, values)?;
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
        Coefficients::from_rows(RearSteeredMatrices::rows(&self.matrices()))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl<T: Number> Evaluator<T, 2> for RearSteered<T> {
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
        RearSteeredMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> RearSteeredDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<RearSteeredMatrices<T>> {
        if parameter >= 26 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = RearSteeredMatrices {
            m: [[zero; 2]; 2], c1: [[zero; 2]; 2], k0: [[zero; 2]; 2], k2: [[zero; 2]; 2],
        };
        for position in 0..158 {
            let partial = <RearSteeredDerivatives>::PARTIALS[position];
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

impl<T: Scalar> Differentiable<2> for RearSteered<T> {
    type Derivatives = [Coefficients<T, 2>; 26];

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 6]); 26];
        for position in 0..158 {
            Partial::write(&<RearSteeredDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(RearSteeredMatrices::rows(&matrices)), all)
    }
}

impl RearSteeredDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 158] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 0), Partial::new(MatrixName::M, 1, 0, 0, 0),
        Partial::new(MatrixName::M, 1, 1, 0, 1), Partial::new(MatrixName::C1, 0, 1, 0, 2),
        Partial::new(MatrixName::C1, 1, 0, 0, 3), Partial::new(MatrixName::C1, 1, 1, 0, 4),
        Partial::new(MatrixName::K0, 0, 1, 0, 5), Partial::new(MatrixName::K0, 1, 0, 0, 5),
        Partial::new(MatrixName::K0, 1, 1, 0, 6), Partial::new(MatrixName::K2, 0, 1, 0, 7),
        Partial::new(MatrixName::K2, 1, 1, 0, 8).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 9), Partial::new(MatrixName::M, 1, 0, 1, 9),
        Partial::new(MatrixName::M, 1, 1, 1, 10), Partial::new(MatrixName::C1, 0, 1, 1, 11),
        Partial::new(MatrixName::C1, 1, 0, 1, 12).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 13),
        Partial::new(MatrixName::K0, 0, 1, 1, 14),
        Partial::new(MatrixName::K0, 1, 0, 1, 14),
        Partial::new(MatrixName::K0, 1, 1, 1, 15).negative(),
        Partial::new(MatrixName::K2, 1, 1, 1, 16),
        Partial::new(MatrixName::M, 0, 1, 2, 17).negative(),
        Partial::new(MatrixName::M, 1, 0, 2, 17).negative(),
        Partial::new(MatrixName::M, 1, 1, 2, 18),
        Partial::new(MatrixName::C1, 0, 1, 2, 19).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 20),
        Partial::new(MatrixName::C1, 1, 1, 2, 21),
        Partial::new(MatrixName::K0, 0, 1, 2, 22).negative(),
        Partial::new(MatrixName::K0, 1, 0, 2, 22).negative(),
        Partial::new(MatrixName::K0, 1, 1, 2, 23), Partial::new(MatrixName::K2, 0, 1, 2, 24),
        Partial::new(MatrixName::K2, 1, 1, 2, 25), Partial::new(MatrixName::M, 0, 0, 4, 26),
        Partial::new(MatrixName::C1, 0, 1, 4, 27), Partial::new(MatrixName::C1, 1, 0, 4, 28),
        Partial::new(MatrixName::K0, 0, 0, 4, 29).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 30).negative(),
        Partial::new(MatrixName::M, 0, 0, 5, 31),
        Partial::new(MatrixName::C1, 0, 1, 5, 32),
        Partial::new(MatrixName::K0, 0, 0, 5, 33).negative(),
        Partial::new(MatrixName::K2, 0, 1, 5, 34).negative(),
        Partial::new(MatrixName::M, 0, 0, 6, 35),
        Partial::new(MatrixName::M, 1, 1, 6, 36),
        Partial::new(MatrixName::C1, 1, 1, 6, 37).negative(),
        Partial::new(MatrixName::C1, 0, 1, 7, 38),
        Partial::new(MatrixName::C1, 1, 0, 7, 38).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 39).negative(),
        Partial::new(MatrixName::M, 0, 1, 8, 40),
        Partial::new(MatrixName::M, 1, 0, 8, 40),
        Partial::new(MatrixName::M, 1, 1, 8, 41),
        Partial::new(MatrixName::C1, 0, 1, 8, 42).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 43).negative(),
        Partial::new(MatrixName::K0, 0, 1, 8, 44),
        Partial::new(MatrixName::K0, 1, 0, 8, 44),
        Partial::new(MatrixName::K0, 1, 1, 8, 45).negative(),
        Partial::new(MatrixName::K2, 1, 1, 8, 46), Partial::new(MatrixName::M, 0, 0, 9, 47),
        Partial::new(MatrixName::M, 0, 1, 9, 48), Partial::new(MatrixName::M, 1, 0, 9, 48),
        Partial::new(MatrixName::C1, 0, 1, 9, 49).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 50), Partial::new(MatrixName::K2, 0, 1, 9, 51),
        Partial::new(MatrixName::M, 0, 0, 10, 52), Partial::new(MatrixName::M, 0, 1, 10, 53),
        Partial::new(MatrixName::M, 1, 0, 10, 53), Partial::new(MatrixName::M, 1, 1, 10, 54),
        Partial::new(MatrixName::C1, 0, 1, 10, 55).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 56).negative(),
        Partial::new(MatrixName::K0, 0, 0, 10, 57),
        Partial::new(MatrixName::K0, 0, 1, 10, 58),
        Partial::new(MatrixName::K0, 1, 0, 10, 58),
        Partial::new(MatrixName::K0, 1, 1, 10, 59).negative(),
        Partial::new(MatrixName::K2, 0, 1, 10, 60), Partial::new(MatrixName::K2, 1, 1, 10, 61),
        Partial::new(MatrixName::M, 0, 0, 11, 35), Partial::new(MatrixName::M, 1, 1, 13, 36),
        Partial::new(MatrixName::C1, 1, 1, 13, 37).negative(),
        Partial::new(MatrixName::M, 0, 1, 14, 62).negative(),
        Partial::new(MatrixName::M, 1, 0, 14, 62).negative(),
        Partial::new(MatrixName::C1, 0, 1, 14, 63), Partial::new(MatrixName::M, 0, 1, 15, 64),
        Partial::new(MatrixName::M, 1, 0, 15, 64), Partial::new(MatrixName::M, 1, 1, 15, 65),
        Partial::new(MatrixName::C1, 0, 1, 15, 66).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 67).negative(),
        Partial::new(MatrixName::K0, 0, 1, 15, 68),
        Partial::new(MatrixName::K0, 1, 0, 15, 68),
        Partial::new(MatrixName::K0, 1, 1, 15, 69).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 70), Partial::new(MatrixName::M, 0, 0, 16, 71),
        Partial::new(MatrixName::M, 0, 1, 16, 72), Partial::new(MatrixName::M, 1, 0, 16, 72),
        Partial::new(MatrixName::M, 1, 1, 16, 73), Partial::new(MatrixName::C1, 0, 1, 16, 74),
        Partial::new(MatrixName::C1, 1, 1, 16, 75), Partial::new(MatrixName::K0, 0, 0, 16, 76),
        Partial::new(MatrixName::K0, 0, 1, 16, 77).negative(),
        Partial::new(MatrixName::K0, 1, 0, 16, 77).negative(),
        Partial::new(MatrixName::K0, 1, 1, 16, 78),
        Partial::new(MatrixName::K2, 0, 1, 16, 79),
        Partial::new(MatrixName::K2, 1, 1, 16, 80).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 81), Partial::new(MatrixName::M, 0, 1, 17, 82),
        Partial::new(MatrixName::M, 1, 0, 17, 82), Partial::new(MatrixName::M, 1, 1, 17, 83),
        Partial::new(MatrixName::C1, 0, 1, 17, 84), Partial::new(MatrixName::C1, 1, 1, 17, 85),
        Partial::new(MatrixName::K0, 0, 0, 17, 86), Partial::new(MatrixName::K0, 0, 1, 17, 87),
        Partial::new(MatrixName::K0, 1, 0, 17, 87),
        Partial::new(MatrixName::K0, 1, 1, 17, 88).negative(),
        Partial::new(MatrixName::K2, 0, 1, 17, 89),
        Partial::new(MatrixName::K2, 1, 1, 17, 90),
        Partial::new(MatrixName::M, 0, 0, 18, 35),
        Partial::new(MatrixName::M, 0, 1, 18, 91).negative(),
        Partial::new(MatrixName::M, 1, 0, 18, 91).negative(),
        Partial::new(MatrixName::M, 1, 1, 18, 92),
        Partial::new(MatrixName::M, 1, 1, 20, 93),
        Partial::new(MatrixName::C1, 1, 1, 20, 94).negative(),
        Partial::new(MatrixName::M, 0, 1, 21, 95).negative(),
        Partial::new(MatrixName::M, 1, 0, 21, 95).negative(),
        Partial::new(MatrixName::M, 1, 1, 21, 96),
        Partial::new(MatrixName::C1, 0, 1, 21, 63),
        Partial::new(MatrixName::C1, 1, 1, 21, 97).negative(),
        Partial::new(MatrixName::M, 0, 0, 22, 98), Partial::new(MatrixName::M, 0, 1, 22, 99),
        Partial::new(MatrixName::M, 1, 0, 22, 99), Partial::new(MatrixName::M, 1, 1, 22, 100),
        Partial::new(MatrixName::C1, 0, 1, 22, 101), Partial::new(MatrixName::C1, 1, 0, 22, 102),
        Partial::new(MatrixName::C1, 1, 1, 22, 103),
        Partial::new(MatrixName::K0, 0, 0, 22, 104).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 105),
        Partial::new(MatrixName::K0, 1, 0, 22, 105),
        Partial::new(MatrixName::K0, 1, 1, 22, 106).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 107), Partial::new(MatrixName::K2, 1, 1, 22, 108),
        Partial::new(MatrixName::M, 0, 0, 23, 109), Partial::new(MatrixName::M, 0, 1, 23, 110),
        Partial::new(MatrixName::M, 1, 0, 23, 110), Partial::new(MatrixName::M, 1, 1, 23, 111),
        Partial::new(MatrixName::C1, 0, 1, 23, 112), Partial::new(MatrixName::C1, 1, 1, 23, 113),
        Partial::new(MatrixName::K0, 0, 0, 23, 114).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 115),
        Partial::new(MatrixName::K0, 1, 0, 23, 115),
        Partial::new(MatrixName::K0, 1, 1, 23, 116).negative(),
        Partial::new(MatrixName::K2, 0, 1, 23, 117).negative(),
        Partial::new(MatrixName::K2, 1, 1, 23, 118),
        Partial::new(MatrixName::M, 0, 0, 24, 35),
        Partial::new(MatrixName::M, 0, 1, 24, 91).negative(),
        Partial::new(MatrixName::M, 1, 0, 24, 91).negative(),
        Partial::new(MatrixName::M, 1, 1, 24, 119),
        Partial::new(MatrixName::C1, 1, 1, 24, 94).negative(),
        Partial::new(MatrixName::C1, 0, 1, 25, 120),
        Partial::new(MatrixName::C1, 1, 0, 25, 120).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 121).negative(),
        Partial::new(MatrixName::K2, 1, 1, 25, 122),
    ];
}
