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
    /// 42 additions, 44 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 92 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> RearSteeredMatrices<T> {
        let t2 = self.rR * self.mR;
        let t6 = self.rF * self.mF;
        let ay_all1_delta = self.rF * t6 + (self.IHxx + self.IFxx);
        let t15 = self.zB * self.mB;
        let t19 = self.zH * self.mH;
        let M_11 = self.rR * t2 + ay_all1_delta
            + (self.zB * t15 + (self.zH * t19 + (self.IRxx + self.IBxx)));
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t31 = self.w.like(1.0) / self.w;
        let t32 = cos_lam * t31;
        let yaw_by_delta = self.c * t32;
        let t39 = t15 * self.xB - (self.IBxz + self.IHxz);
        let wz_delta2_delta = cos_lam + yaw_by_delta;
        let t50 = cos_lam * (self.c + self.w) - self.xH * wz_delta2_delta;
        let t51 = self.zH * sin_lam + t50;
        let t54 = t19 * t51 + sin_lam * ay_all1_delta;
        let t55 = sin_lam * self.IHxz;
        let t59 = t55 + wz_delta2_delta * (self.IFxx + self.IHzz);
        let t63 = self.mB * self.xB;
        let t68 = yaw_by_delta * (self.xB * t63 + (self.IRxx + self.IBzz));
        let t71 = self.mH * t51;
        let M_22 = wz_delta2_delta * (t55 + t59)
            + (sin_lam * t54 + yaw_by_delta * t68 + t71 * t50);
        let zero = self.w.like(0.0);
        let K0_11 = t15 - (t2 + (t6 - t19));
        let t85 = cos_lam * (t31 * (t19 * self.xH + (self.c * K0_11 + t39)) - t6);
        let h_spin_R = self.IFyy / self.rF;
        let t90 = self.IRyy / self.rR;
        let t92 = wz_delta2_delta * h_spin_R + yaw_by_delta * t90;
        let C1_12 = t92 - t85;
        let t94 = t6 * sin_lam;
        let t96 = yaw_by_delta * t63 + t94;
        let t97 = t71 - t96;
        let t104 = t31 * (self.c * t97 + (self.xH * t71 - t68) - t59) - t94;
        let C1_22 = cos_lam * t104;
        let K0_22 = sin_lam * t97;
        let K2_12 = t32 * (K0_11 - t90 - h_spin_R);
        let K2_22 = t32 * (sin_lam * h_spin_R - t97);
        let M_12 = yaw_by_delta * t39 - cos_lam * self.IHxz - t54;
        let C1_21 = -t92;
        let K0_12 = t96 - t71;
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
    /// 103 additions, 184 multiplications, 3 divisions, 5 negations and 2 trigonometric functions: 297 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (RearSteeredMatrices<T>, RearSteeredDerivatives<T>) {
        let t3 = self.zH * self.mH;
        let t8 = self.rF * self.mF;
        let t12 = self.IFxx + self.zH * t3 + self.IHxx + self.rF * t8;
        let t17 = self.rR * self.mR;
        let t21 = self.zB * self.mB;
        let M_11 = t12 + self.IRxx + self.IBxx + self.rR * t17 + self.zB * t21;
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t31 = self.w.like(1.0) / self.w;
        let C1_12_IBxz = cos_lam * t31;
        let yaw_by_delta = self.c * C1_12_IBxz;
        let t39 = t21 * self.xB - self.IHxz - self.IBxz;
        let t43 = self.c + self.w - self.xH;
        let t45 = yaw_by_delta * self.xH;
        let t46 = t45 - cos_lam * t43;
        let t49 = t12 * sin_lam;
        let t50 = t3 * t46 - t49;
        let t51 = cos_lam * self.IHxz;
        let M_12 = yaw_by_delta * t39 + t50 - t51;
        let wz_delta2_delta = cos_lam + yaw_by_delta;
        let t55 = self.IHxz * sin_lam;
        let t57 = self.IFxx + self.IHzz;
        let t59 = t55 + wz_delta2_delta * t57;
        let t63 = self.mB * self.xB;
        let t66 = self.IRxx + self.IBzz + self.xB * t63;
        let t67 = yaw_by_delta * t66;
        let t69 = self.zH * sin_lam;
        let K0_12_mH = t46 - t69;
        let t71 = t69 - K0_12_mH;
        let t72 = self.mH * t71;
        let M_22 = wz_delta2_delta * (t55 + t59) + yaw_by_delta * t67 + sin_lam * t49
            - t46 * t72;
        let zero = self.w.like(0.0);
        let K0_11 = t3 + t21 - t8 - t17;
        let t85 = t39 + self.c * K0_11 + t3 * self.xH;
        let t86 = C1_12_IBxz * t85;
        let t88 = self.w.like(1.0) / self.rF;
        let h_spin_R = self.IFyy * t88;
        let t91 = self.w.like(1.0) / self.rR;
        let t92 = self.IRyy * t91;
        let t93 = h_spin_R + t92;
        let t94 = yaw_by_delta * t93;
        let t95 = cos_lam * h_spin_R;
        let t96 = t94 + t95;
        let t97 = t8 * cos_lam;
        let C1_12 = t96 + t97 - t86;
        let K0_12_mF = self.rF * sin_lam;
        let t101 = self.mF * K0_12_mF;
        let t102 = self.mH * K0_12_mH;
        let M_22_wz_delta2_delta = self.xH * t102;
        let t104 = C1_12_IBxz * t63;
        let M_12_zB = self.c * t104;
        let K0_12 = t101 + t102 + M_12_zB;
        let t109 = t59 + t67;
        let t112 = t31 * (M_22_wz_delta2_delta + self.c * K0_12 + t109);
        let t113 = t101 + t112;
        let t116 = K0_11 - t93;
        let K2_12 = C1_12_IBxz * t116;
        let t118 = sin_lam * h_spin_R;
        let t119 = K0_12 + t118;
        let K2_22 = C1_12_IBxz * t119;
        let t122 = cos_lam + t31 * t45;
        let t124 = t31 * yaw_by_delta;
        let t126 = t3 * t122 + t39 * t124;
        let M_22_yaw_by_delta = t109 + t109;
        let t129 = t102 + t102;
        let t131 = t124 * M_22_yaw_by_delta + t122 * t129;
        let C1_21_w = t31 * t94;
        let C1_12_w = t31 * t86 - C1_21_w;
        let t135 = self.mH * t122;
        let t136 = C1_12_IBxz * self.xH;
        let t137 = yaw_by_delta + t136;
        let t139 = t57 + t66;
        let t141 = M_12_zB + C1_12_IBxz * t139;
        let C1_22_w = t135 * t137 + t124 * t141 + C1_12_IBxz * t112;
        let t147 = t135 + t31 * M_12_zB;
        let K0_22_w = sin_lam * t147;
        let t149 = t31 * K2_12;
        let t152 = C1_12_IBxz * (t147 + t31 * t119);
        let t154 = cos_lam - t136;
        let M_12_c = C1_12_IBxz * t39 - t3 * t154;
        let M_22_c = C1_12_IBxz * M_22_yaw_by_delta - t129 * t154;
        let t160 = C1_12_IBxz * t93;
        let t161 = self.mH * t154;
        let t162 = self.c + self.xH;
        let t166 = C1_12_IBxz * (K0_12 + t141 - t161 * t162);
        let K0_12_c = t104 - t161;
        let t171 = t31 * sin_lam;
        let t172 = self.c * t171;
        let t174 = self.xH * t172 - t43 * sin_lam;
        let t177 = t12 * cos_lam;
        let M_12_lam = t55 - t3 * t174 - t39 * t172 - t177;
        let t181 = wz_delta2_delta + wz_delta2_delta;
        let t185 = self.mH * t174;
        let t188 = t185 + t3 * cos_lam;
        let t196 = t71 * t185 - cos_lam * (t50 - self.IHxz * t181) - t46 * t188
            - sin_lam * (t59 + t59 - t177);
        let M_22_lam = t196 - M_22_yaw_by_delta * t172;
        let C1_21_lam = t118 + t93 * t172;
        let t202 = t101 + C1_21_lam - t85 * t171;
        let ay_all1_delta = t139 * t171;
        let K0_12_lam = t97 - t188 - t63 * t172;
        let t215 = t97
            + t31
                * (t51 - self.xH * t188 - self.c * (ay_all1_delta - K0_12_lam)
                    - sin_lam * t57);
        let C1_22_lam = sin_lam * t113 - cos_lam * t215;
        let t221 = sin_lam * K0_12_lam + cos_lam * K0_12;
        let t222 = t116 * t171;
        let K2_22_lam = C1_12_IBxz * (t95 + K0_12_lam) - t119 * t171;
        let M_11_rR = t17 + t17;
        let t230 = C1_12_IBxz * (self.mR - t91 * t92);
        let C1_12_rR = self.c * t230;
        let C1_12_IRyy = yaw_by_delta * t91;
        let C1_21_rR = t92 * C1_12_IRyy;
        let M_11_mR = self.rR * self.rR;
        let C1_12_mR = self.rR * yaw_by_delta;
        let t236 = self.rR * C1_12_IBxz;
        let M_22_IRxx = yaw_by_delta * yaw_by_delta;
        let t239 = cos_lam * t124;
        let t240 = C1_12_IBxz * t91;
        let K2_12_mB = self.zB * C1_12_IBxz;
        let t242 = self.mB * K2_12_mB;
        let M_12_xB = self.c * t242;
        let M_22_xB = yaw_by_delta * (M_12_zB + M_12_zB);
        let t246 = self.c + self.xB;
        let K2_22_xB = self.mB * t239;
        let t249 = (self.xB + t246) * K2_22_xB;
        let K2_12_zB = self.mB * C1_12_IBxz;
        let K0_12_xB = self.c * K2_12_zB;
        let t252 = sin_lam * K0_12_xB;
        let M_11_zB = t21 + t21;
        let t254 = t104 + K0_12_xB;
        let M_11_mB = self.zB * self.zB;
        let K0_12_mB = yaw_by_delta * self.xB;
        let M_12_mB = self.zB * K0_12_mB;
        let M_22_mB = K0_12_mB * K0_12_mB;
        let t259 = K2_12_mB * t246;
        let K2_22_mB = C1_12_IBxz * K0_12_mB;
        let t261 = t246 * K2_22_mB;
        let t262 = sin_lam * K0_12_mB;
        let M_12_xH = t3 * wz_delta2_delta;
        let M_22_xH = t102 * t181;
        let K2_12_zH = self.mH * C1_12_IBxz;
        let t266 = self.zH * K2_12_zH;
        let K0_12_xH = self.mH * wz_delta2_delta;
        let t270 = t137 * K0_12_xH + K0_12_mH * K2_12_zH;
        let t271 = sin_lam * K0_12_xH;
        let K2_22_xH = wz_delta2_delta * K2_12_zH;
        let M_11_zH = t3 + t3;
        let t274 = sin_lam * t129;
        let t275 = self.mH * t137;
        let C1_22_zH = sin_lam * t275;
        let t277 = self.mH * sin_lam;
        let K0_22_zH = sin_lam * t277;
        let t279 = sin_lam * K2_12_zH;
        let M_11_mH = self.zH * self.zH;
        let M_12_mH = self.zH * K0_12_mH;
        let M_22_mH = K0_12_mH * K0_12_mH;
        let t283 = self.zH * t137;
        let K2_22_mH = C1_12_IBxz * K0_12_mH;
        let t285 = t162 * K2_22_mH;
        let t286 = sin_lam * K0_12_mH;
        let K2_12_mH = self.zH * C1_12_IBxz;
        let M_22_ay_all1_delta = sin_lam * sin_lam;
        let M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
        let t290 = C1_12_IBxz * wz_delta2_delta;
        let M_22_IHxz = sin_lam * t181;
        let K2_22_h_spin_R = C1_12_IBxz * sin_lam;
        let ay_all1_delta_rF = t8 + t8;
        let t294 = t101 + t101;
        let M_22_rF = sin_lam * t294;
        let t296 = t88 * h_spin_R;
        let t297 = self.mF - t296;
        let C1_12_rF = wz_delta2_delta * t297;
        let C1_21_rF = wz_delta2_delta * t296;
        let K0_12_rF = self.mF * sin_lam;
        let t301 = wz_delta2_delta * K0_12_rF;
        let t302 = sin_lam * K0_12_rF;
        let t303 = C1_12_IBxz * t297;
        let K2_22_rF = K2_22_h_spin_R * t297;
        let ay_all1_delta_mF = self.rF * self.rF;
        let t306 = sin_lam * ay_all1_delta_mF;
        let t307 = sin_lam * K0_12_mF;
        let M_22_mF = self.rF * t307;
        let C1_12_mF = self.rF * wz_delta2_delta;
        let t310 = wz_delta2_delta * K0_12_mF;
        let t311 = self.rF * C1_12_IBxz;
        let K2_22_mF = C1_12_IBxz * K0_12_mF;
        let M_22_IFxx = M_22_ay_all1_delta + M_22_IHzz;
        let C1_12_IFyy = wz_delta2_delta * t88;
        let t315 = C1_12_IBxz * t88;
        let K2_22_IFyy = sin_lam * t315;
        let C1_21 = -t96;
        let C1_22 = -(cos_lam * t113);
        let K0_22 = -(sin_lam * K0_12);
        let K0_22_c = -(sin_lam * K0_12_c);
        let t321 = -(C1_12_IBxz * K0_12_c);
        (
            RearSteeredMatrices::from_entries([
                M_11, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, K0_11, K0_12, K0_12, K0_22, zero,
                K2_12, zero, K2_22,
            ]),
            RearSteeredDerivatives {
                values: [
                    t126, t131, C1_12_w, C1_21_w, C1_22_w, t147, K0_22_w, t149, t152, M_12_c,
                    M_22_c, K2_12, t160, t166, K0_12_c, K0_22_c, t321, M_12_lam, M_22_lam, t202,
                    C1_21_lam, C1_22_lam, K0_12_lam, t221, t222, K2_22_lam, M_11_rR, C1_12_rR,
                    C1_21_rR, self.mR, t230, M_11_mR, C1_12_mR, self.rR, t236, self.w.like(1.0),
                    M_22_IRxx, t239, C1_12_IRyy, t240, M_12_xB, M_22_xB, t242, t249, K0_12_xB, t252,
                    K2_22_xB, M_11_zB, M_12_zB, t254, self.mB, K2_12_zB, M_11_mB, M_12_mB, M_22_mB,
                    t259, t261, self.zB, K0_12_mB, t262, K2_12_mB, K2_22_mB, yaw_by_delta,
                    C1_12_IBxz, M_12_xH, M_22_xH, t266, t270, K0_12_xH, t271, K2_22_xH, M_11_zH,
                    t72, t274, t275, C1_22_zH, self.mH, t277, K0_22_zH, K2_12_zH, t279, M_11_mH,
                    M_12_mH, M_22_mH, t283, t285, self.zH, K0_12_mH, t286, K2_12_mH, K2_22_mH,
                    sin_lam, M_22_ay_all1_delta, M_22_IHzz, t290, wz_delta2_delta, M_22_IHxz,
                    K2_22_h_spin_R, ay_all1_delta_rF, t294, M_22_rF, C1_12_rF, C1_21_rF, t301,
                    self.mF, K0_12_rF, t302, t303, K2_22_rF, ay_all1_delta_mF, t306, M_22_mF,
                    C1_12_mF, t310, self.rF, K0_12_mF, t307, t311, K2_22_mF, M_22_IFxx, C1_12_IFyy,
                    t315, K2_22_IFyy,
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
        attributes: &[
            FormulaInfo::attribute("B_mass", "the mass of the main frame and rider B", "kg", "mB"),
            FormulaInfo::attribute("B_x", "x of the centre of mass of the main frame and rider B", "m", "-xB"),
            FormulaInfo::attribute("B_z", "z of the centre of mass of the main frame and rider B", "m", "zB"),
            FormulaInfo::attribute("B_Ixx", "the inertia xx of the main frame and rider B", "kg*m^2", "IBxx"),
            FormulaInfo::attribute("B_Ixz", "the inertia xz of the main frame and rider B", "kg*m^2", "-IBxz"),
            FormulaInfo::attribute("B_Izz", "the inertia zz of the main frame and rider B", "kg*m^2", "IBzz"),
            FormulaInfo::attribute("H_mass", "the mass of the steered frame H", "kg", "mH"),
            FormulaInfo::attribute("H_x", "x of the centre of mass of the steered frame H", "m", "-xH"),
            FormulaInfo::attribute("H_z", "z of the centre of mass of the steered frame H", "m", "zH"),
            FormulaInfo::attribute("H_Ixx", "the inertia xx of the steered frame H", "kg*m^2", "IHxx"),
            FormulaInfo::attribute("H_Ixz", "the inertia xz of the steered frame H", "kg*m^2", "-IHxz"),
            FormulaInfo::attribute("H_Izz", "the inertia zz of the steered frame H", "kg*m^2", "IHzz"),
            FormulaInfo::attribute("F_mass", "the mass of the front wheel F", "kg", "mR"),
            FormulaInfo::attribute("F_radius", "the radius of the front wheel F", "m", "rR"),
            FormulaInfo::attribute("F_axial", "the axial inertia of the front wheel F", "kg*m^2", "IRyy"),
            FormulaInfo::attribute("F_radial", "the radial inertia of the front wheel F", "kg*m^2", "IRxx"),
            FormulaInfo::attribute("F_z", "z of the centre of the front wheel F", "m", "-rR"),
            FormulaInfo::attribute("R_mass", "the mass of the rear wheel R", "kg", "mF"),
            FormulaInfo::attribute("R_radius", "the radius of the rear wheel R", "m", "rF"),
            FormulaInfo::attribute("R_axial", "the axial inertia of the rear wheel R", "kg*m^2", "IFyy"),
            FormulaInfo::attribute("R_radial", "the radial inertia of the rear wheel R", "kg*m^2", "IFxx"),
            FormulaInfo::attribute("R_x", "x of the centre of the rear wheel R", "m", "-w"),
            FormulaInfo::attribute("R_z", "z of the centre of the rear wheel R", "m", "-rF"),
            FormulaInfo::attribute("delta_through_x", "x of the point of the joint delta", "m", "-w - c"),
            FormulaInfo::attribute("delta_along_x", "x of the axis of the joint delta", "1", "-sin(lam)"),
            FormulaInfo::attribute("delta_along_z", "z of the axis of the joint delta", "1", "cos(lam)"),
            FormulaInfo::definition("length_delta", "1", "sqrt(delta_along_x^2 + delta_along_z^2)"),
            FormulaInfo::definition("pitch_by_vertical", "1/m", "1/R_x"),
            FormulaInfo::definition("yaw_by_phi", "1", "(R_radius + R_z)/R_x"),
            FormulaInfo::definition(
                "yaw_by_delta",
                "1",
                "-(delta_along_z*(R_x - delta_through_x) - delta_along_x*(R_radius + R_z))/R_x/length_delta",
            ),
            FormulaInfo::definition("yaw_per_v_delta", "1/m", "delta_along_z/R_x/length_delta"),
            FormulaInfo::definition("lateral_by_phi", "m", "F_radius + F_z"),
            FormulaInfo::definition("yaw_by_phi_", "1", "yaw_by_phi - pitch_by_vertical*lateral_by_phi"),
            FormulaInfo::definition("Jxx_delta", "kg*m^2", "H_mass*H_z^2 + H_Ixx + R_mass*R_z^2 + R_radial"),
            FormulaInfo::definition(
                "Jxz_delta",
                "kg*m^2",
                "H_Ixz - H_mass*H_z*(H_x - delta_through_x) - R_mass*R_z*(R_x - delta_through_x)",
            ),
            FormulaInfo::definition(
                "Jzz_delta",
                "kg*m^2",
                "H_mass*(H_x - delta_through_x)^2 + H_Izz + R_mass*(R_x - delta_through_x)^2 + R_radial",
            ),
            FormulaInfo::definition(
                "Sx_delta",
                "kg*m",
                "H_mass*(H_x - delta_through_x) + R_mass*(R_x - delta_through_x)",
            ),
            FormulaInfo::definition("Sz_delta", "kg*m", "H_mass*H_z + R_mass*R_z"),
            FormulaInfo::definition("m_delta", "kg", "H_mass + R_mass"),
            FormulaInfo::definition(
                "py_delta",
                "kg*m",
                "(delta_along_z*Sx_delta - delta_along_x*Sz_delta)/length_delta",
            ),
            FormulaInfo::definition(
                "hx_delta",
                "kg*m^2",
                "(delta_along_x*Jxx_delta + delta_along_z*Jxz_delta)/length_delta",
            ),
            FormulaInfo::definition(
                "hz_delta",
                "kg*m^2",
                "(delta_along_x*Jxz_delta + delta_along_z*Jzz_delta)/length_delta",
            ),
            FormulaInfo::definition("Jxx_all", "kg*m^2", "B_mass*B_z^2 + B_Ixx + F_mass*F_z^2 + F_radial + Jxx_delta"),
            FormulaInfo::definition(
                "Jxz_all",
                "kg*m^2",
                "B_Ixz + Jxz_delta - B_mass*B_x*B_z - delta_through_x*Sz_delta",
            ),
            FormulaInfo::definition(
                "Jzz_all",
                "kg*m^2",
                "B_mass*B_x^2 + B_Izz + F_radial + 2*delta_through_x*((1/2)*delta_through_x*m_delta + Sx_delta) + Jzz_delta",
            ),
            FormulaInfo::definition("Sx_all", "kg*m", "B_mass*B_x + delta_through_x*m_delta + Sx_delta"),
            FormulaInfo::definition("Sz_all", "kg*m", "B_mass*B_z + F_mass*F_z + Sz_delta"),
            FormulaInfo::definition("m_all", "kg", "B_mass + F_mass + m_delta"),
            FormulaInfo::definition("load_spin_R", "kg", "-Sx_all/R_x"),
            FormulaInfo::definition("load_spin_F", "kg", "-(m_all + load_spin_R)"),
            FormulaInfo::definition("h_spin_F", "kg*m", "F_axial/F_radius"),
            FormulaInfo::definition("h_spin_R", "kg*m", "R_axial/R_radius"),
            FormulaInfo::definition("h_wheels_all", "kg*m", "h_spin_F + h_spin_R"),
            FormulaInfo::definition("M_yaw_delta", "kg*m^2", "delta_through_x*py_delta + hz_delta"),
            FormulaInfo::definition(
                "M_delta_delta",
                "kg*m^2",
                "(delta_along_x*hx_delta + delta_along_z*hz_delta)/length_delta",
            ),
            FormulaInfo::definition(
                "K_phi_phi",
                "kg*m",
                "Sz_all + load_spin_R*(R_radius + R_z) + load_spin_F*(F_radius + F_z)",
            ),
            FormulaInfo::definition(
                "K_phi_delta",
                "kg*m",
                "-py_delta - load_spin_R*(delta_along_z*(R_x - delta_through_x) - delta_along_x*(R_radius + R_z))/length_delta",
            ),
            FormulaInfo::definition(
                "K_delta_delta",
                "kg*m",
                "-delta_along_x*(length_delta*py_delta + load_spin_R*(delta_along_z*(R_x - delta_through_x) - delta_along_x*(R_radius + R_z)))/length_delta^2",
            ),
            FormulaInfo::definition("P_phi_lateral", "kg*m", "lateral_by_phi*m_all + yaw_by_phi_*Sx_all - Sz_all"),
            FormulaInfo::definition("P_phi_yaw", "kg*m^2", "lateral_by_phi*Sx_all + yaw_by_phi_*Jzz_all + Jxz_all"),
            FormulaInfo::definition("P_phi_phi", "kg*m^2", "yaw_by_phi_*Jxz_all + Jxx_all - lateral_by_phi*Sz_all"),
            FormulaInfo::definition(
                "P_phi_delta",
                "kg*m^2",
                "lateral_by_phi*py_delta + yaw_by_phi_*M_yaw_delta + hx_delta",
            ),
            FormulaInfo::definition("P_delta_lateral", "kg*m", "yaw_by_delta*Sx_all + py_delta"),
            FormulaInfo::definition("P_delta_yaw", "kg*m^2", "yaw_by_delta*Jzz_all + M_yaw_delta"),
            FormulaInfo::definition("P_delta_delta", "kg*m^2", "yaw_by_delta*M_yaw_delta + M_delta_delta"),
            FormulaInfo::entry(
                &[(MatrixName::M, 0, 0)],
                "kg*m^2",
                "lateral_by_phi*P_phi_lateral + yaw_by_phi_*P_phi_yaw + P_phi_phi",
            ),
            FormulaInfo::entry(
                &[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)],
                "kg*m^2",
                "yaw_by_delta*P_phi_yaw + P_phi_delta",
            ),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "yaw_by_delta*P_delta_yaw + P_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 0)], "kg*m", "yaw_by_phi_*P_phi_lateral"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 1)],
                "kg*m",
                "(delta_along_z*h_spin_R + length_delta*yaw_by_delta*(h_wheels_all + P_phi_lateral) + length_delta*yaw_per_v_delta*P_phi_yaw - delta_along_x*yaw_by_phi_*h_spin_R)/length_delta",
            ),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 0)],
                "kg*m",
                "(yaw_by_phi_*(delta_along_x*h_spin_R + length_delta*P_delta_lateral) - delta_along_z*h_spin_R - length_delta*yaw_by_delta*h_wheels_all)/length_delta",
            ),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 1)],
                "kg*m",
                "yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw",
            ),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "K_phi_phi"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)], "kg*m", "K_phi_delta"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "K_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg", "yaw_per_v_delta*(h_wheels_all + P_phi_lateral)"),
            FormulaInfo::entry(
                &[(MatrixName::K2, 1, 1)],
                "kg",
                "yaw_per_v_delta*(delta_along_x*h_spin_R/length_delta + P_delta_lateral)",
            ),
        ],
        motion: None,
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
        Partial::new(MatrixName::M, 0, 1, 0, 0).negative(),
        Partial::new(MatrixName::M, 1, 0, 0, 0).negative(),
        Partial::new(MatrixName::M, 1, 1, 0, 1).negative(),
        Partial::new(MatrixName::C1, 0, 1, 0, 2), Partial::new(MatrixName::C1, 1, 0, 0, 3),
        Partial::new(MatrixName::C1, 1, 1, 0, 4),
        Partial::new(MatrixName::K0, 0, 1, 0, 5).negative(),
        Partial::new(MatrixName::K0, 1, 0, 0, 5).negative(),
        Partial::new(MatrixName::K0, 1, 1, 0, 6),
        Partial::new(MatrixName::K2, 0, 1, 0, 7).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 8).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 9), Partial::new(MatrixName::M, 1, 0, 1, 9),
        Partial::new(MatrixName::M, 1, 1, 1, 10),
        Partial::new(MatrixName::C1, 0, 1, 1, 11).negative(),
        Partial::new(MatrixName::C1, 1, 0, 1, 12).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 13).negative(),
        Partial::new(MatrixName::K0, 0, 1, 1, 14),
        Partial::new(MatrixName::K0, 1, 0, 1, 14),
        Partial::new(MatrixName::K0, 1, 1, 1, 15),
        Partial::new(MatrixName::K2, 1, 1, 1, 16).negative(),
        Partial::new(MatrixName::M, 0, 1, 2, 17),
        Partial::new(MatrixName::M, 1, 0, 2, 17),
        Partial::new(MatrixName::M, 1, 1, 2, 18),
        Partial::new(MatrixName::C1, 0, 1, 2, 19).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 20), Partial::new(MatrixName::C1, 1, 1, 2, 21),
        Partial::new(MatrixName::K0, 0, 1, 2, 22), Partial::new(MatrixName::K0, 1, 0, 2, 22),
        Partial::new(MatrixName::K0, 1, 1, 2, 23).negative(),
        Partial::new(MatrixName::K2, 0, 1, 2, 24).negative(),
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
        Partial::new(MatrixName::K2, 1, 1, 15, 70),
        Partial::new(MatrixName::M, 0, 0, 16, 71),
        Partial::new(MatrixName::M, 0, 1, 16, 72).negative(),
        Partial::new(MatrixName::M, 1, 0, 16, 72).negative(),
        Partial::new(MatrixName::M, 1, 1, 16, 73).negative(),
        Partial::new(MatrixName::C1, 0, 1, 16, 74).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 75),
        Partial::new(MatrixName::K0, 0, 0, 16, 76),
        Partial::new(MatrixName::K0, 0, 1, 16, 77).negative(),
        Partial::new(MatrixName::K0, 1, 0, 16, 77).negative(),
        Partial::new(MatrixName::K0, 1, 1, 16, 78),
        Partial::new(MatrixName::K2, 0, 1, 16, 79),
        Partial::new(MatrixName::K2, 1, 1, 16, 80).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 81), Partial::new(MatrixName::M, 0, 1, 17, 82),
        Partial::new(MatrixName::M, 1, 0, 17, 82), Partial::new(MatrixName::M, 1, 1, 17, 83),
        Partial::new(MatrixName::C1, 0, 1, 17, 84).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 85).negative(),
        Partial::new(MatrixName::K0, 0, 0, 17, 86),
        Partial::new(MatrixName::K0, 0, 1, 17, 87),
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
