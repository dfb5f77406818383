// @generated from generated/models/rear_steered.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 55b70df1229c7642

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo,
    WithDerivatives,
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
/// The fields are the parameters. The coordinates are `phi` (lean) in `rad`, `delta` (steer) in `rad`.
///
/// <details><summary>The formulas of its matrices</summary>
///
/// A name has behind it the joint that it belongs to, or `all` for the whole machine. `m` is the mass that the
/// joint moves, `S` its static moment and `J` its inertia about the point of the joint; `p` and `h` are the
/// momentum and the angular momentum at unit rate, `h_spin` is the spin momentum of a wheel divided by the speed,
/// and `load` the steady force of the ground on it along z, divided by gravity. `M` and `K` are entries of the
/// matrices of all joints, `P` and `W` of those projected on the motions that the wheels leave free, `a_by_b` is
/// the rate of a for that of b, and `a_per_v_b` that for the position of b, divided by the speed.
///
/// ```text
/// yaw_by_delta = c*cos(lam)/w [1]
/// yaw_per_v_delta = -cos(lam)/w [1/m]
/// Jxx_delta = IHxx + IFxx + zH^2*mH + rF^2*mF [kg*m^2]
/// Jxz_delta = c*rF*mF - zH*mH*(w + c - xH) - IHxz [kg*m^2]
/// Jzz_delta = mH*(w + c - xH)^2 + IHzz + IFxx + c^2*mF [kg*m^2]
/// Sx_delta = c*mF + mH*(w + c - xH) [kg*m]
/// Sz_delta = zH*mH - rF*mF [kg*m]
/// py_delta = Sx_delta*cos(lam) + Sz_delta*sin(lam) [kg*m]
/// hx_delta = Jxz_delta*cos(lam) - Jxx_delta*sin(lam) [kg*m^2]
/// hz_delta = Jzz_delta*cos(lam) - Jxz_delta*sin(lam) [kg*m^2]
/// Jxx_all = IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB [kg*m^2]
/// Jxz_all = xB*zB*mB + Jxz_delta + Sz_delta*(w + c) - IBxz [kg*m^2]
/// Jzz_all = IRxx + IBzz + IHzz + IFxx + w^2*mF + xB^2*mB + xH^2*mH [kg*m^2]
/// Sx_all = -(w*mF + xB*mB + xH*mH) [kg*m]
/// Sz_all = zB*mB + Sz_delta - rR*mR [kg*m]
/// load_spin_R = Sx_all/w [kg]
/// h_spin_F = IRyy/rR [kg*m]
/// h_spin_R = IFyy/rF [kg*m]
/// h_wheels_all = h_spin_F + h_spin_R [kg*m]
/// M_yaw_delta = hz_delta - py_delta*(w + c) [kg*m^2]
/// M_delta_delta = hz_delta*cos(lam) - hx_delta*sin(lam) [kg*m^2]
/// K_phi_delta = -(c*load_spin_R*cos(lam) + py_delta) [kg*m]
/// K_delta_delta = (c*load_spin_R*cos(lam) + py_delta)*sin(lam) [kg*m]
/// P_delta_lateral = yaw_by_delta*Sx_all + py_delta [kg*m]
/// P_delta_yaw = yaw_by_delta*Jzz_all + M_yaw_delta [kg*m^2]
/// P_delta_delta = yaw_by_delta*M_yaw_delta + M_delta_delta [kg*m^2]
/// M_11 = Jxx_all [kg*m^2]
/// M_12 = M_21 = yaw_by_delta*Jxz_all + hx_delta [kg*m^2]
/// M_22 = yaw_by_delta*P_delta_yaw + P_delta_delta [kg*m^2]
/// C1_12 = yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_R*cos(lam) [kg*m]
/// C1_21 = -(yaw_by_delta*h_wheels_all + h_spin_R*cos(lam)) [kg*m]
/// C1_22 = yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
/// K0_11 = Sz_all [kg*m]
/// K0_12 = K0_21 = K_phi_delta [kg*m]
/// K0_22 = K_delta_delta [kg*m]
/// K2_12 = yaw_per_v_delta*(h_wheels_all - Sz_all) [kg]
/// K2_22 = yaw_per_v_delta*(P_delta_lateral - h_spin_R*sin(lam)) [kg]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct RearSteered<T = f64> {
    /// Wheel base.
    ///
    /// `w` in `m`: `> 0`.
    pub w: T,
    /// Distance by which the steer axis meets the ground behind the contact of the steered wheel.
    ///
    /// `c` in `m`: any finite value.
    pub c: T,
    /// Steer axis tilt: from the ground upward the axis leans forward by this angle.
    ///
    /// `lam`, λ, in `rad`: `> -1.5707963267948966 and < 1.5707963267948966`.
    pub lam: T,
    /// Gravitational field strength.
    ///
    /// `g` in `N/kg`: `>= 0`.
    pub g: T,
    /// Radius of the front wheel.
    ///
    /// `rR` in `m`: `> 0`.
    pub rR: T,
    /// Mass of the front wheel.
    ///
    /// `mR` in `kg`: `>= 0`.
    pub mR: T,
    /// Radial moment of inertia of the front wheel; by symmetry also about the vertical.
    ///
    /// `IRxx` in `kg*m^2`: `>= 0`.
    pub IRxx: T,
    /// Axial moment of inertia of the front wheel.
    ///
    /// `IRyy` in `kg*m^2`: `>= 0`.
    pub IRyy: T,
    /// Centre of mass of the main frame and rider, behind the front contact.
    ///
    /// `xB` in `m`: any finite value.
    pub xB: T,
    /// Centre of mass of the main frame and rider, downward.
    ///
    /// `zB` in `m`: any finite value.
    pub zB: T,
    /// Mass of the main frame and rider.
    ///
    /// `mB` in `kg`: `>= 0`.
    pub mB: T,
    /// Moment of inertia of the main frame and rider about its centre of mass, in roll.
    ///
    /// `IBxx` in `kg*m^2`: `>= 0`.
    pub IBxx: T,
    /// Moment of inertia of the main frame and rider about its centre of mass, in pitch.
    ///
    /// `IByy` in `kg*m^2`: `>= 0`. No matrix depends on it.
    pub IByy: T,
    /// Moment of inertia of the main frame and rider about its centre of mass, in yaw.
    ///
    /// `IBzz` in `kg*m^2`: `>= 0`.
    pub IBzz: T,
    /// Product of inertia of the main frame and rider about its centre of mass.
    ///
    /// `IBxz` in `kg*m^2`: any finite value.
    pub IBxz: T,
    /// Centre of mass of the steered frame, behind the front contact.
    ///
    /// `xH` in `m`: any finite value.
    pub xH: T,
    /// Centre of mass of the steered frame, downward.
    ///
    /// `zH` in `m`: any finite value.
    pub zH: T,
    /// Mass of the steered frame.
    ///
    /// `mH` in `kg`: `>= 0`.
    pub mH: T,
    /// Moment of inertia of the steered frame about its centre of mass, in roll.
    ///
    /// `IHxx` in `kg*m^2`: `>= 0`.
    pub IHxx: T,
    /// Moment of inertia of the steered frame about its centre of mass, in pitch.
    ///
    /// `IHyy` in `kg*m^2`: `>= 0`. No matrix depends on it.
    pub IHyy: T,
    /// Moment of inertia of the steered frame about its centre of mass, in yaw.
    ///
    /// `IHzz` in `kg*m^2`: `>= 0`.
    pub IHzz: T,
    /// Product of inertia of the steered frame about its centre of mass.
    ///
    /// `IHxz` in `kg*m^2`: any finite value.
    pub IHxz: T,
    /// Radius of the rear wheel.
    ///
    /// `rF` in `m`: `> 0`.
    pub rF: T,
    /// Mass of the rear wheel.
    ///
    /// `mF` in `kg`: `>= 0`.
    pub mF: T,
    /// Radial moment of inertia of the rear wheel; by symmetry also about the vertical.
    ///
    /// `IFxx` in `kg*m^2`: `>= 0`.
    pub IFxx: T,
    /// Axial moment of inertia of the rear wheel.
    ///
    /// `IFyy` in `kg*m^2`: `>= 0`.
    pub IFyy: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`RearSteered`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RearSteeredMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 2>,
}

impl<T: Number> RearSteered<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 41 additions, 44 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 91 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> RearSteeredMatrices<T> {
        let t2 = self.zH * self.mH;
        let t7 = self.rF * self.mF;
        let t11 = self.IHxx + (self.rF * t7 + self.IFxx);
        let t14 = self.rR * self.mR;
        let t18 = self.zB * self.mB;
        let M_11 = self.zH * t2
            + (t11 + (self.rR * t14 + (self.zB * t18 + self.IRxx + self.IBxx)));
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t31 = self.w.like(1.0) / self.w;
        let t32 = cos_lam * t31;
        let yaw_by_delta = self.c * t32;
        let wz_delta2_delta = cos_lam + yaw_by_delta;
        let t39 = wz_delta2_delta * self.IHxz + t11 * sin_lam;
        let t43 = t18 * self.xB - self.IBxz;
        let t52 = self.zH * sin_lam + cos_lam * (self.c + self.w)
            - wz_delta2_delta * self.xH;
        let t53 = self.mH * t52;
        let M_12 = yaw_by_delta * t43 - t39 - self.zH * t53;
        let t59 = self.mB * self.xB;
        let t62 = yaw_by_delta * (self.IRxx + self.IBzz + t59 * self.xB);
        let t69 = self.IHxz * sin_lam + wz_delta2_delta * (self.IFxx + self.IHzz);
        let M_22 = t53 * t52 + yaw_by_delta * t62
            + (wz_delta2_delta * t69 + sin_lam * t39);
        let zero = self.w.like(0.0);
        let h_spin_R = self.IFyy / self.rF;
        let K0_11 = t18 + t2 - (t7 + t14);
        let t84 = self.IRyy / self.rR;
        let t85 = K0_11 - h_spin_R - t84;
        let t91 = t7 + h_spin_R
            - t31 * (t2 * self.xH + (self.c * t85 + t43) - self.IHxz);
        let C1_12 = t91 * cos_lam;
        let t96 = t7 * sin_lam;
        let t101 = t96 + yaw_by_delta * t59;
        let t102 = t53 - t101;
        let C1_22 = cos_lam
            * (t31 * (self.xH * t53 - (t62 + t69) + self.c * t102) - t96);
        let K0_22 = sin_lam * t102;
        let K2_12 = t32 * t85;
        let K2_22 = t32 * (sin_lam * h_spin_R - t102);
        let C1_21 = -(yaw_by_delta * t84 + wz_delta2_delta * h_spin_R);
        let K0_12 = t101 - t53;
        RearSteeredMatrices::from_entries([
            M_11, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, K0_11, K0_12, K0_12, K0_22, zero,
            K2_12, zero, K2_22,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`RearSteered`] that follow from its coordinates q = (`phi`, `delta`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RearSteeredKinematics<T = f64> {
    /// Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin.
    pub lateral: Rate<T, 2>,
    /// Yaw rate, to the right, in `rad/s`: of `B`.
    pub yaw: Rate<T, 2>,
    /// Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_F: Rate<T, 2>,
    /// Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_R: Rate<T, 2>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate,
    /// a column for each of `Tphi` (lean torque) in `N*m`, `Tdelta` (steer torque) in `N*m`.
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
        let zero = self.w.like(0.0);
        let t6 = self.lam.cos() / self.w;
        let yaw_by_delta = self.c * t6;
        let t12 = -t6;
        let t13 = -(self.w.like(1.0) / self.rR);
        let t14 = -(self.w.like(1.0) / self.rF);
        RearSteeredKinematics {
            lateral: Rate {
                speed: zero, rates: [zero, zero], coordinates: [zero, zero],
                heading: self.w.like(1.0),
            },
            yaw: Rate {
                speed: zero, rates: [zero, yaw_by_delta], coordinates: [zero, t12], heading: zero,
            },
            wheel_F: Rate {
                speed: t13, rates: [zero, zero], coordinates: [zero, zero], heading: zero,
            },
            wheel_R: Rate {
                speed: t14, rates: [zero, zero], coordinates: [zero, zero], heading: zero,
            },
            forces: [[self.w.like(1.0), zero], [zero, self.w.like(1.0)]],
        }
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`RearSteered`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RearSteeredDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 123],
}

impl<T: Number> RearSteered<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 98 additions, 184 multiplications, 3 divisions, 5 negations and 2 trigonometric functions: 292 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (RearSteeredMatrices<T>, RearSteeredDerivatives<T>) {
        let t2 = self.zH * self.mH;
        let M_11_mB = self.zB * self.zB;
        let t11 = self.rR * self.mR;
        let t18 = self.rF * self.mF;
        let t21 = self.IFxx + self.IHxx + self.rF * t18;
        let M_11 = self.zH * t2 + self.IRxx + self.mB * M_11_mB + self.rR * t11
            + self.IBxx + t21;
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t29 = self.zH * sin_lam;
        let t35 = self.xH - self.c - self.w;
        let t37 = t29 - cos_lam * t35;
        let t38 = self.w.like(1.0) / self.w;
        let C1_12_IBxz = cos_lam * t38;
        let yaw_by_delta = self.c * C1_12_IBxz;
        let t41 = self.xH * yaw_by_delta;
        let t42 = t37 - t41;
        let wz_delta2_delta = cos_lam + yaw_by_delta;
        let t48 = t21 * sin_lam + wz_delta2_delta * self.IHxz;
        let t51 = self.mB * self.xB;
        let t53 = self.IBxz - self.zB * t51;
        let t58 = sin_lam * self.IHxz;
        let t60 = self.IFxx + self.IHzz;
        let t62 = t58 + wz_delta2_delta * t60;
        let t67 = self.IRxx + self.xB * t51 + self.IBzz;
        let t68 = C1_12_IBxz * yaw_by_delta;
        let M_22_IRxx = self.c * t68;
        let t71 = self.mH * t42;
        let M_22 = sin_lam * t48 + wz_delta2_delta * t62 + t67 * M_22_IRxx + t42 * t71;
        let zero = self.w.like(0.0);
        let t78 = self.w.like(1.0) / self.rF;
        let h_spin_R = self.IFyy * t78;
        let t80 = self.IHxz + t53;
        let t82 = self.w.like(1.0) / self.rR;
        let t83 = self.IRyy * t82;
        let t84 = h_spin_R + t83;
        let t85 = self.mB * self.zB;
        let t87 = t2 + t85 - t18;
        let t89 = t84 + (t11 - t87);
        let t94 = t38 * (t80 + self.c * t89 - t2 * self.xH);
        let t96 = t18 + h_spin_R + t94;
        let C1_12 = cos_lam * t96;
        let t98 = yaw_by_delta * t84;
        let t99 = cos_lam * h_spin_R;
        let K0_12_rF = self.mF * sin_lam;
        let t102 = self.rF * K0_12_rF;
        let K0_12_mB = yaw_by_delta * self.xB;
        let M_12_zB = self.mB * K0_12_mB;
        let K0_12 = t102 + M_12_zB - t71;
        let t110 = t62 + yaw_by_delta * t67;
        let t113 = t38 * (self.c * K0_12 + t110 - self.xH * t71);
        let t114 = t102 + t113;
        let C1_12_c = C1_12_IBxz * t89;
        let t118 = sin_lam * h_spin_R;
        let t119 = K0_12 + t118;
        let K2_22 = C1_12_IBxz * t119;
        let t122 = cos_lam + t38 * t41;
        let t124 = t38 * yaw_by_delta;
        let M_12_w = t80 * t124 - t2 * t122;
        let t129 = t110 * t124 - t71 * t122;
        let t130 = t129 + t129;
        let t131 = C1_12_IBxz * t94;
        let C1_21_w = t38 * t98;
        let t135 = M_12_zB + C1_12_IBxz * (t60 + t67);
        let t138 = self.mH * t122;
        let t139 = self.xH * C1_12_IBxz;
        let t140 = yaw_by_delta + t139;
        let C1_22_w = t124 * t135 + C1_12_IBxz * t113 + t138 * t140;
        let t145 = t138 + t51 * t124;
        let K0_22_w = sin_lam * t145;
        let K2_12_w = t38 * C1_12_c;
        let t151 = C1_12_IBxz * (t138 + t38 * (M_12_zB + t119));
        let t152 = cos_lam - t139;
        let t153 = self.mH * t152;
        let t156 = self.zH * t153 + C1_12_IBxz * t80;
        let t159 = t71 * t152 + C1_12_IBxz * t110;
        let M_22_c = t159 + t159;
        let t161 = C1_12_IBxz * t84;
        let C1_22_c = t140 * t153 - C1_12_IBxz * (K0_12 + t135);
        let K2_12_zB = self.mB * C1_12_IBxz;
        let K2_22_yaw_by_delta = self.xB * K2_12_zB;
        let t168 = t153 - K2_22_yaw_by_delta;
        let K0_22_c = sin_lam * t168;
        let t170 = C1_12_IBxz * t168;
        let t172 = sin_lam * t38;
        let t173 = self.c * t172;
        let t177 = self.zH * cos_lam;
        let t179 = sin_lam * t35 + self.xH * t173 + t177;
        let t183 = t21 * cos_lam + t2 * t179 - t58 - t80 * t173;
        let t185 = self.mH * t179;
        let t191 = sin_lam * t62 + t110 * t173 - t42 * t185 - cos_lam * t48;
        let t192 = t191 + t191;
        let t193 = sin_lam * t96;
        let C1_21_lam = t118 + t84 * t173;
        let C1_12_mF = self.rF * wz_delta2_delta;
        let t205 = self.mH * t140;
        let C1_22_lam = sin_lam * t114 + t135 * t173 + t179 * t205
            - cos_lam * (C1_12_IBxz * self.IHxz + self.mF * C1_12_mF - t60 * t172);
        let K0_12_lam = t18 * cos_lam - t185 - t51 * t173;
        let t216 = cos_lam * K0_12 + sin_lam * K0_12_lam;
        let K2_12_lam = t89 * t172;
        let K2_22_lam = C1_12_IBxz * (t99 + K0_12_lam) - t119 * t172;
        let M_11_rR = t11 + t11;
        let t223 = t82 * t83;
        let t225 = C1_12_IBxz * (self.mR - t223);
        let C1_12_rR = self.c * t225;
        let C1_21_rR = yaw_by_delta * t223;
        let M_11_mR = self.rR * self.rR;
        let t229 = self.rR * C1_12_IBxz;
        let C1_12_mR = self.c * t229;
        let t232 = C1_12_IBxz * t82;
        let C1_12_IRyy = self.c * t232;
        let t234 = C1_12_IBxz * t85;
        let M_12_xB = self.c * t234;
        let t236 = yaw_by_delta * M_12_zB;
        let M_22_xB = t236 + t236;
        let t238 = self.c + self.xB;
        let t239 = K2_12_zB * t238;
        let t241 = yaw_by_delta * (K2_22_yaw_by_delta + t239);
        let K0_12_xB = self.mB * yaw_by_delta;
        let t243 = sin_lam * K0_12_xB;
        let K2_22_xB = C1_12_IBxz * K0_12_xB;
        let M_11_zB = t85 + t85;
        let M_12_mB = self.zB * K0_12_mB;
        let M_22_mB = K0_12_mB * K0_12_mB;
        let K2_12_mB = self.zB * C1_12_IBxz;
        let t249 = t238 * K2_12_mB;
        let K2_22_mB = C1_12_IBxz * K0_12_mB;
        let t251 = t238 * K2_22_mB;
        let t252 = sin_lam * K0_12_mB;
        let K0_12_xH = self.mH * wz_delta2_delta;
        let M_12_xH = self.zH * K0_12_xH;
        let t255 = t71 + t71;
        let t256 = wz_delta2_delta * t255;
        let K2_12_zH = self.mH * C1_12_IBxz;
        let t258 = self.zH * K2_12_zH;
        let C1_22_xH = t42 * K2_12_zH - wz_delta2_delta * t205;
        let t262 = sin_lam * wz_delta2_delta;
        let t263 = self.mH * t262;
        let t264 = C1_12_IBxz * wz_delta2_delta;
        let K2_22_xH = self.mH * t264;
        let M_11_zH = t2 + t2;
        let t268 = self.mH * (t29 + t42);
        let M_22_zH = sin_lam * t255;
        let C1_22_zH = sin_lam * t205;
        let t271 = self.mH * sin_lam;
        let K0_22_zH = sin_lam * t271;
        let t273 = C1_12_IBxz * t271;
        let M_11_mH = self.zH * self.zH;
        let t275 = self.zH * t42;
        let M_22_mH = t42 * t42;
        let t277 = self.zH * t140;
        let C1_22_mH = t42 * t140;
        let K0_22_mH = sin_lam * t42;
        let K2_12_mH = t38 * t177;
        let t281 = C1_12_IBxz * t42;
        let M_22_IHxx = sin_lam * sin_lam;
        let M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
        let M_22_IHxz = t262 + t262;
        let K2_22_h_spin_R = cos_lam * t172;
        let M_11_rF = t18 + t18;
        let t287 = t102 + t102;
        let M_22_rF = sin_lam * t287;
        let t289 = t78 * h_spin_R;
        let t290 = self.mF - t289;
        let C1_12_rF = wz_delta2_delta * t290;
        let C1_21_rF = wz_delta2_delta * t289;
        let t293 = self.mF * t262;
        let t294 = sin_lam * K0_12_rF;
        let t295 = C1_12_IBxz * t290;
        let K2_22_rF = K2_22_h_spin_R * t290;
        let M_11_mF = self.rF * self.rF;
        let K0_12_mF = self.rF * sin_lam;
        let t299 = self.rF * K0_12_mF;
        let M_22_mF = sin_lam * t299;
        let t301 = wz_delta2_delta * K0_12_mF;
        let t302 = sin_lam * K0_12_mF;
        let t303 = self.rF * C1_12_IBxz;
        let K2_22_mF = self.rF * K2_22_h_spin_R;
        let M_22_IFxx = M_22_IHxx + M_22_IHzz;
        let C1_12_IFyy = wz_delta2_delta * t78;
        let t307 = C1_12_IBxz * t78;
        let K2_22_IFyy = t78 * K2_22_h_spin_R;
        let M_12 = -(t2 * t42 + t48 + yaw_by_delta * t53);
        let C1_21 = -(t98 + t99);
        let C1_22 = -(cos_lam * t114);
        let K0_11 = t87 - t11;
        let K0_22 = -(sin_lam * K0_12);
        let K2_12 = -C1_12_c;
        let K0_12_c = K2_22_yaw_by_delta - t153;
        let K0_12_mH = t41 - t37;
        (
            RearSteeredMatrices::from_entries([
                M_11, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, K0_11, K0_12, K0_12, K0_22, zero,
                K2_12, zero, K2_22,
            ]),
            RearSteeredDerivatives {
                values: [
                    M_12_w, t130, t131, C1_21_w, C1_22_w, t145, K0_22_w, K2_12_w, t151, t156,
                    M_22_c, C1_12_c, t161, C1_22_c, K0_12_c, K0_22_c, t170, t183, t192, t193,
                    C1_21_lam, C1_22_lam, K0_12_lam, t216, K2_12_lam, K2_22_lam, M_11_rR, C1_12_rR,
                    C1_21_rR, self.mR, t225, M_11_mR, C1_12_mR, self.rR, t229, self.w.like(1.0),
                    M_22_IRxx, t68, C1_12_IRyy, t232, M_12_xB, M_22_xB, t234, t241, K0_12_xB, t243,
                    K2_22_xB, M_11_zB, M_12_zB, t239, self.mB, K2_12_zB, M_11_mB, M_12_mB, M_22_mB,
                    t249, t251, self.zB, K0_12_mB, t252, K2_12_mB, K2_22_mB, yaw_by_delta,
                    C1_12_IBxz, M_12_xH, t256, t258, C1_22_xH, K0_12_xH, t263, K2_22_xH, M_11_zH,
                    t268, M_22_zH, t205, C1_22_zH, self.mH, t271, K0_22_zH, K2_12_zH, t273, M_11_mH,
                    t275, M_22_mH, t277, C1_22_mH, self.zH, K0_12_mH, K0_22_mH, K2_12_mH, t281,
                    sin_lam, M_22_IHxx, M_22_IHzz, t264, wz_delta2_delta, M_22_IHxz, K2_22_h_spin_R,
                    M_11_rF, t287, M_22_rF, C1_12_rF, C1_21_rF, t293, self.mF, K0_12_rF, t294, t295,
                    K2_22_rF, M_11_mF, t299, M_22_mF, C1_12_mF, t301, self.rF, K0_12_mF, t302, t303,
                    K2_22_mF, M_22_IFxx, C1_12_IFyy, t307, K2_22_IFyy,
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
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `w` | 1.02 | `m` |
    /// | `c` | 0.08 | `m` |
    /// | `lam` | 0.3141592653589793 | `rad` |
    /// | `g` | 9.81 | `N/kg` |
    /// | `rR` | 0.3 | `m` |
    /// | `mR` | 2 | `kg` |
    /// | `IRxx` | 0.0603 | `kg*m^2` |
    /// | `IRyy` | 0.12 | `kg*m^2` |
    /// | `xB` | 0.3 | `m` |
    /// | `zB` | -0.9 | `m` |
    /// | `mB` | 85 | `kg` |
    /// | `IBxx` | 9.2 | `kg*m^2` |
    /// | `IByy` | 11 | `kg*m^2` |
    /// | `IBzz` | 2.8 | `kg*m^2` |
    /// | `IBxz` | 2.4 | `kg*m^2` |
    /// | `xH` | 0.9 | `m` |
    /// | `zH` | -0.7 | `m` |
    /// | `mH` | 4 | `kg` |
    /// | `IHxx` | 0.05892 | `kg*m^2` |
    /// | `IHyy` | 0.06 | `kg*m^2` |
    /// | `IHzz` | 0.00708 | `kg*m^2` |
    /// | `IHxz` | -0.00756 | `kg*m^2` |
    /// | `rF` | 0.35 | `m` |
    /// | `mF` | 3 | `kg` |
    /// | `IFxx` | 0.1405 | `kg*m^2` |
    /// | `IFyy` | 0.28 | `kg*m^2` |
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
    #[inline(always)]
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

impl RearSteered<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> RearSteered<f32> {
        RearSteered::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<RearSteered<f32>> for RearSteered<f64> {
    fn from(parameters: RearSteered<f32>) -> Self {
        RearSteered::cast(&parameters)
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

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 11] {
        [
            self.m[0][0], self.m[0][1], self.m[1][1], self.c1[0][1], self.c1[1][0], self.c1[1][1],
            self.k0[0][0], self.k0[0][1], self.k0[1][1], self.k2[0][1], self.k2[1][1],
        ]
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, zeros, self.c1.0, zeros, self.k0.0, zeros, self.k2.0]
    }
}

impl<T: Scalar> From<RearSteeredMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: RearSteeredMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
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
        forces: &[
            carvallo::motion::AppliedInfo {
                name: "Tphi", label: "lean torque", unit: "N*m", position: "phi",
            },
            carvallo::motion::AppliedInfo {
                name: "Tdelta", label: "steer torque", unit: "N*m", position: "delta",
            },
        ],
        matrices: &[MatrixName::M, MatrixName::C1, MatrixName::K0, MatrixName::K2],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]), EntryInfo::at(&[(MatrixName::C1, 0, 1)]),
            EntryInfo::at(&[(MatrixName::C1, 1, 0)]), EntryInfo::at(&[(MatrixName::C1, 1, 1)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 1, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 0, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 1, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "backwards",
                docs: "",
                source: "The benchmark of Meijaard et al. (2007), Table 1, run backwards",
                values: &RearSteered::to_array(&RearSteered::<f64>::BACKWARDS),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("yaw_by_delta", "1", "c*cos(lam)/w"),
            FormulaInfo::definition("yaw_per_v_delta", "1/m", "-cos(lam)/w"),
            FormulaInfo::definition("Jxx_delta", "kg*m^2", "IHxx + IFxx + zH^2*mH + rF^2*mF"),
            FormulaInfo::definition("Jxz_delta", "kg*m^2", "c*rF*mF - zH*mH*(w + c - xH) - IHxz"),
            FormulaInfo::definition("Jzz_delta", "kg*m^2", "mH*(w + c - xH)^2 + IHzz + IFxx + c^2*mF"),
            FormulaInfo::definition("Sx_delta", "kg*m", "c*mF + mH*(w + c - xH)"),
            FormulaInfo::definition("Sz_delta", "kg*m", "zH*mH - rF*mF"),
            FormulaInfo::definition("py_delta", "kg*m", "Sx_delta*cos(lam) + Sz_delta*sin(lam)"),
            FormulaInfo::definition("hx_delta", "kg*m^2", "Jxz_delta*cos(lam) - Jxx_delta*sin(lam)"),
            FormulaInfo::definition("hz_delta", "kg*m^2", "Jzz_delta*cos(lam) - Jxz_delta*sin(lam)"),
            FormulaInfo::definition("Jxx_all", "kg*m^2", "IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB"),
            FormulaInfo::definition("Jxz_all", "kg*m^2", "xB*zB*mB + Jxz_delta + Sz_delta*(w + c) - IBxz"),
            FormulaInfo::definition("Jzz_all", "kg*m^2", "IRxx + IBzz + IHzz + IFxx + w^2*mF + xB^2*mB + xH^2*mH"),
            FormulaInfo::definition("Sx_all", "kg*m", "-(w*mF + xB*mB + xH*mH)"),
            FormulaInfo::definition("Sz_all", "kg*m", "zB*mB + Sz_delta - rR*mR"),
            FormulaInfo::definition("load_spin_R", "kg", "Sx_all/w"),
            FormulaInfo::definition("h_spin_F", "kg*m", "IRyy/rR"),
            FormulaInfo::definition("h_spin_R", "kg*m", "IFyy/rF"),
            FormulaInfo::definition("h_wheels_all", "kg*m", "h_spin_F + h_spin_R"),
            FormulaInfo::definition("M_yaw_delta", "kg*m^2", "hz_delta - py_delta*(w + c)"),
            FormulaInfo::definition("M_delta_delta", "kg*m^2", "hz_delta*cos(lam) - hx_delta*sin(lam)"),
            FormulaInfo::definition("K_phi_delta", "kg*m", "-(c*load_spin_R*cos(lam) + py_delta)"),
            FormulaInfo::definition("K_delta_delta", "kg*m", "(c*load_spin_R*cos(lam) + py_delta)*sin(lam)"),
            FormulaInfo::definition("P_delta_lateral", "kg*m", "yaw_by_delta*Sx_all + py_delta"),
            FormulaInfo::definition("P_delta_yaw", "kg*m^2", "yaw_by_delta*Jzz_all + M_yaw_delta"),
            FormulaInfo::definition("P_delta_delta", "kg*m^2", "yaw_by_delta*M_yaw_delta + M_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "Jxx_all"),
            FormulaInfo::entry(
                &[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)],
                "kg*m^2",
                "yaw_by_delta*Jxz_all + hx_delta",
            ),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "yaw_by_delta*P_delta_yaw + P_delta_delta"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 1)],
                "kg*m",
                "yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_R*cos(lam)",
            ),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 0)], "kg*m", "-(yaw_by_delta*h_wheels_all + h_spin_R*cos(lam))"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 1)],
                "kg*m",
                "yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw",
            ),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "Sz_all"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)], "kg*m", "K_phi_delta"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "K_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg", "yaw_per_v_delta*(h_wheels_all - Sz_all)"),
            FormulaInfo::entry(
                &[(MatrixName::K2, 1, 1)],
                "kg",
                "yaw_per_v_delta*(P_delta_lateral - h_spin_R*sin(lam))",
            ),
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
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.validate(&self.to_array().map(Scalar::to_f64))?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 2> {
        Coefficients::from_rows(RearSteeredMatrices::rows(&self.matrices()))
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 2>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn shares(&self, force: usize) -> Option<[T; 2]> {
        (force < 2).then(|| self.kinematics().forces.map(|row| row[force]))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl RearSteered<f64> {
    /// What the model tells about itself, the same for every number type.
    pub const INFO: &'static ModelInfo = <Self as Model<2>>::INFO;

    /// The parameter set of this name, however it is spelt: upper and lower case, `_`, `-` and spaces make no
    /// difference. In `f32` it is had by the trait `Model`.
    #[must_use]
    pub fn set(name: &str) -> Option<Self> {
        <Self as Model<2>>::set(name)
    }
}

/// The parameters, one a line with its unit, in the precision that is asked for; `{:#}` says what they are.
impl<T: Scalar> core::fmt::Display for RearSteered<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for RearSteered<T> {
    type Entries = [T; 11];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            w: parameter(0), c: parameter(1), lam: parameter(2), g: parameter(3), rR: parameter(4),
            mR: parameter(5), IRxx: parameter(6), IRyy: parameter(7), xB: parameter(8),
            zB: parameter(9), mB: parameter(10), IBxx: parameter(11), IByy: parameter(12),
            IBzz: parameter(13), IBxz: parameter(14), xH: parameter(15), zH: parameter(16),
            mH: parameter(17), IHxx: parameter(18), IHyy: parameter(19), IHzz: parameter(20),
            IHxz: parameter(21), rF: parameter(22), mF: parameter(23), IFxx: parameter(24),
            IFyy: parameter(25),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        RearSteeredMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
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
            m: Rows([[zero; 2]; 2]), c1: Rows([[zero; 2]; 2]), k0: Rows([[zero; 2]; 2]),
            k2: Rows([[zero; 2]; 2]),
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

    type WithDerivativesOver<U: Number> = RearSteered<U>;

    const PARTIALS: &'static [Partial] = <RearSteeredDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 26];
        for position in 0..158 {
            Partial::write(&<RearSteeredDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(RearSteeredMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for RearSteered<T> {
    type Derivatives = [T; 123];

    #[inline(always)]
    fn entries_and_derivatives(&self) -> ([T; 11], [T; 123]) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        (RearSteeredMatrices::distinct_entries(&matrices), derivatives.values)
    }
}

impl RearSteeredDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 158] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 0), Partial::new(MatrixName::M, 1, 0, 0, 0),
        Partial::new(MatrixName::M, 1, 1, 0, 1).negative(),
        Partial::new(MatrixName::C1, 0, 1, 0, 2).negative(),
        Partial::new(MatrixName::C1, 1, 0, 0, 3), Partial::new(MatrixName::C1, 1, 1, 0, 4),
        Partial::new(MatrixName::K0, 0, 1, 0, 5).negative(),
        Partial::new(MatrixName::K0, 1, 0, 0, 5).negative(),
        Partial::new(MatrixName::K0, 1, 1, 0, 6), Partial::new(MatrixName::K2, 0, 1, 0, 7),
        Partial::new(MatrixName::K2, 1, 1, 0, 8).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 9).negative(),
        Partial::new(MatrixName::M, 1, 0, 1, 9).negative(),
        Partial::new(MatrixName::M, 1, 1, 1, 10), Partial::new(MatrixName::C1, 0, 1, 1, 11),
        Partial::new(MatrixName::C1, 1, 0, 1, 12).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 13), Partial::new(MatrixName::K0, 0, 1, 1, 14),
        Partial::new(MatrixName::K0, 1, 0, 1, 14), Partial::new(MatrixName::K0, 1, 1, 1, 15),
        Partial::new(MatrixName::K2, 1, 1, 1, 16).negative(),
        Partial::new(MatrixName::M, 0, 1, 2, 17).negative(),
        Partial::new(MatrixName::M, 1, 0, 2, 17).negative(),
        Partial::new(MatrixName::M, 1, 1, 2, 18).negative(),
        Partial::new(MatrixName::C1, 0, 1, 2, 19).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 20), Partial::new(MatrixName::C1, 1, 1, 2, 21),
        Partial::new(MatrixName::K0, 0, 1, 2, 22), Partial::new(MatrixName::K0, 1, 0, 2, 22),
        Partial::new(MatrixName::K0, 1, 1, 2, 23).negative(),
        Partial::new(MatrixName::K2, 0, 1, 2, 24), Partial::new(MatrixName::K2, 1, 1, 2, 25),
        Partial::new(MatrixName::M, 0, 0, 4, 26), Partial::new(MatrixName::C1, 0, 1, 4, 27),
        Partial::new(MatrixName::C1, 1, 0, 4, 28),
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
        Partial::new(MatrixName::C1, 0, 1, 14, 63),
        Partial::new(MatrixName::M, 0, 1, 15, 64),
        Partial::new(MatrixName::M, 1, 0, 15, 64),
        Partial::new(MatrixName::M, 1, 1, 15, 65).negative(),
        Partial::new(MatrixName::C1, 0, 1, 15, 66).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 67),
        Partial::new(MatrixName::K0, 0, 1, 15, 68),
        Partial::new(MatrixName::K0, 1, 0, 15, 68),
        Partial::new(MatrixName::K0, 1, 1, 15, 69).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 70),
        Partial::new(MatrixName::M, 0, 0, 16, 71),
        Partial::new(MatrixName::M, 0, 1, 16, 72).negative(),
        Partial::new(MatrixName::M, 1, 0, 16, 72).negative(),
        Partial::new(MatrixName::M, 1, 1, 16, 73),
        Partial::new(MatrixName::C1, 0, 1, 16, 74).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 75),
        Partial::new(MatrixName::K0, 0, 0, 16, 76),
        Partial::new(MatrixName::K0, 0, 1, 16, 77).negative(),
        Partial::new(MatrixName::K0, 1, 0, 16, 77).negative(),
        Partial::new(MatrixName::K0, 1, 1, 16, 78),
        Partial::new(MatrixName::K2, 0, 1, 16, 79),
        Partial::new(MatrixName::K2, 1, 1, 16, 80).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 81),
        Partial::new(MatrixName::M, 0, 1, 17, 82).negative(),
        Partial::new(MatrixName::M, 1, 0, 17, 82).negative(),
        Partial::new(MatrixName::M, 1, 1, 17, 83),
        Partial::new(MatrixName::C1, 0, 1, 17, 84).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 85), Partial::new(MatrixName::K0, 0, 0, 17, 86),
        Partial::new(MatrixName::K0, 0, 1, 17, 87), Partial::new(MatrixName::K0, 1, 0, 17, 87),
        Partial::new(MatrixName::K0, 1, 1, 17, 88), Partial::new(MatrixName::K2, 0, 1, 17, 89),
        Partial::new(MatrixName::K2, 1, 1, 17, 90).negative(),
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
        Partial::new(MatrixName::M, 0, 0, 22, 98),
        Partial::new(MatrixName::M, 0, 1, 22, 99).negative(),
        Partial::new(MatrixName::M, 1, 0, 22, 99).negative(),
        Partial::new(MatrixName::M, 1, 1, 22, 100),
        Partial::new(MatrixName::C1, 0, 1, 22, 101),
        Partial::new(MatrixName::C1, 1, 0, 22, 102),
        Partial::new(MatrixName::C1, 1, 1, 22, 103).negative(),
        Partial::new(MatrixName::K0, 0, 0, 22, 104).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 105),
        Partial::new(MatrixName::K0, 1, 0, 22, 105),
        Partial::new(MatrixName::K0, 1, 1, 22, 106).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 107).negative(),
        Partial::new(MatrixName::K2, 1, 1, 22, 108),
        Partial::new(MatrixName::M, 0, 0, 23, 109),
        Partial::new(MatrixName::M, 0, 1, 23, 110).negative(),
        Partial::new(MatrixName::M, 1, 0, 23, 110).negative(),
        Partial::new(MatrixName::M, 1, 1, 23, 111),
        Partial::new(MatrixName::C1, 0, 1, 23, 112),
        Partial::new(MatrixName::C1, 1, 1, 23, 113).negative(),
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
