// @generated from generated/models/rear_steered.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 55b70df1229c7642

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    FormulaInfo, LengthError, MatrixName, Model, ModelInfo, Number, ParameterError,
    ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo, WithDerivatives,
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
    /// 42 additions, 43 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 91 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> RearSteeredMatrices<T> {
        let t3 = self.zB * self.mB;
        let t7 = self.zH * self.mH;
        let t12 = self.rR * self.mR;
        let t19 = self.rF * self.mF;
        let t22 = self.IHxx + (self.IFxx + self.rF * t19);
        let M_11 = self.IRxx
            + (self.zB * t3 + self.zH * t7 + (self.rR * t12 + (self.IBxx + t22)));
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t31 = cos_lam / self.w;
        let yaw_by_delta = self.c * t31;
        let t36 = t3 * self.xB - self.IBxz;
        let wz_delta2_delta = cos_lam + yaw_by_delta;
        let t46 = self.zH * sin_lam
            + (cos_lam * (self.c + self.w) - self.xH * wz_delta2_delta);
        let t52 = wz_delta2_delta * self.IHxz + sin_lam * t22;
        let t53 = self.mH * t46;
        let t59 = sin_lam * self.IHxz + (self.IFxx + self.IHzz) * wz_delta2_delta;
        let ay_all1_delta = self.mB * self.xB;
        let t68 = yaw_by_delta * (self.IBzz + (self.IRxx + self.xB * ay_all1_delta));
        let M_22 = t46 * t53 + wz_delta2_delta * t59
            + (sin_lam * t52 + yaw_by_delta * t68);
        let zero = self.w.like(0.0);
        let t74 = t7 + (t3 - t12);
        let h_spin_R = self.IFyy / self.rF;
        let h_wheels_all = h_spin_R + self.IRyy / self.rR;
        let t80 = t74 - h_wheels_all;
        let t87 = t19 * wz_delta2_delta;
        let t88 = t87 - t31 * (self.c * t80 + (t36 + (t7 * self.xH - self.IHxz)));
        let t89 = cos_lam * h_spin_R;
        let C1_12 = t88 + t89;
        let t97 = t53 - yaw_by_delta * ay_all1_delta;
        let C1_22 = (self.xH * t53 - t68 - t59 + self.c * t97) * t31 - sin_lam * t87;
        let K0_11 = t74 - t19;
        let t104 = t19 * sin_lam;
        let t105 = t97 - t104;
        let K0_22 = sin_lam * t105;
        let K2_12 = t31 * (t80 - t19);
        let K2_22 = t31 * (sin_lam * h_spin_R - t105);
        let M_12 = yaw_by_delta * t36 - t7 * t46 - t52;
        let C1_21 = -(t89 + yaw_by_delta * h_wheels_all);
        let K0_12 = t104 - t97;
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
    /// 105 additions, 183 multiplications, 3 divisions, 5 negations and 2 trigonometric functions: 298 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (RearSteeredMatrices<T>, RearSteeredDerivatives<T>) {
        let t2 = self.zH * self.mH;
        let M_11_mB = self.zB * self.zB;
        let M_11_mF = self.rF * self.rF;
        let t15 = self.IHxx + self.IFxx + self.mF * M_11_mF;
        let M_11_mR = self.rR * self.rR;
        let M_11 = self.zH * t2 + self.mB * M_11_mB + t15 + self.IRxx + self.IBxx
            + self.mR * M_11_mR;
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t33 = self.w.like(1.0) / self.w;
        let C1_12_IBxz = cos_lam * t33;
        let yaw_by_delta = self.c * C1_12_IBxz;
        let wz_delta2_delta = cos_lam + yaw_by_delta;
        let t39 = t15 * sin_lam + wz_delta2_delta * self.IHxz;
        let t41 = self.mB * self.zB;
        let t44 = self.IBxz - t41 * self.xB;
        let t46 = self.zH * sin_lam;
        let t49 = self.c + self.w - self.xH;
        let t51 = t46 + cos_lam * t49;
        let t52 = C1_12_IBxz * self.xH;
        let t53 = self.c * t52;
        let t54 = t51 - t53;
        let ay_all1_delta = self.mB * self.xB;
        let t62 = self.IRxx + self.xB * ay_all1_delta + self.IBzz;
        let t63 = yaw_by_delta * t62;
        let t66 = sin_lam * self.IHxz;
        let t68 = self.IFxx + self.IHzz;
        let t70 = t66 + wz_delta2_delta * t68;
        let t72 = self.mH * t54;
        let M_22 = yaw_by_delta * t63 + sin_lam * t39 + wz_delta2_delta * t70
            + t54 * t72;
        let zero = self.w.like(0.0);
        let t78 = self.mF * self.rF;
        let t79 = cos_lam * t78;
        let t81 = self.w.like(1.0) / self.rF;
        let h_spin_R = self.IFyy * t81;
        let t83 = cos_lam * h_spin_R;
        let t84 = self.mR * self.rR;
        let t86 = t2 + t41 - t84;
        let t88 = self.w.like(1.0) / self.rR;
        let t89 = self.IRyy * t88;
        let h_wheels_all = h_spin_R + t89;
        let t94 = self.IHxz + t44;
        let t95 = t2 * self.xH - t94;
        let t96 = self.c * (h_wheels_all - t86) - t95;
        let t98 = yaw_by_delta * t78;
        let t99 = C1_12_IBxz * t96 + t98;
        let C1_12 = t79 + t83 + t99;
        let t102 = C1_12_IBxz * h_wheels_all;
        let t103 = self.c * t102;
        let t105 = self.c + self.xH;
        let K2_12_zB = self.mB * C1_12_IBxz;
        let t109 = self.xB * K2_12_zB;
        let M_12_zB = self.c * t109;
        let t111 = C1_12_IBxz * t62 + M_12_zB;
        let t112 = self.c * t111;
        let t114 = t70 + t112 - t72 * t105;
        let t115 = C1_12_IBxz * t114;
        let t116 = sin_lam * wz_delta2_delta;
        let t120 = M_12_zB - t72;
        let K0_12_rF = self.mF * sin_lam;
        let t122 = self.rF * K0_12_rF;
        let K0_12 = t120 + t122;
        let t125 = h_wheels_all + (t78 - t86);
        let C1_12_c = C1_12_IBxz * t125;
        let t127 = sin_lam * h_spin_R;
        let t128 = K0_12 + t127;
        let K2_22 = C1_12_IBxz * t128;
        let t130 = t2 * cos_lam;
        let t131 = t33 * yaw_by_delta;
        let t133 = t130 + t95 * t131;
        let t135 = cos_lam + self.xH * t131;
        let t136 = t72 + t72;
        let t138 = t63 + t70;
        let M_22_yaw_by_delta = t138 + t138;
        let M_22_w = t135 * t136 - t131 * M_22_yaw_by_delta;
        let t142 = t33 * t99;
        let C1_21_w = t33 * t103;
        let t144 = yaw_by_delta + t52;
        let t145 = self.mH * t144;
        let t149 = t122 + C1_12_IBxz * t68;
        let t150 = t111 + t149;
        let C1_22_w = t135 * t145 + t33 * t115 + t131 * t150;
        let t156 = self.mH * t135 + t33 * M_12_zB;
        let K0_22_w = sin_lam * t156;
        let K2_12_w = t33 * C1_12_c;
        let t159 = t33 * t128;
        let t161 = C1_12_IBxz * (t156 + t159);
        let M_12_c = C1_12_IBxz * t95 - t130;
        let t164 = cos_lam - t52;
        let M_22_c = t136 * t164 + C1_12_IBxz * M_22_yaw_by_delta;
        let t168 = self.mH * t164;
        let t172 = C1_12_IBxz * (t120 + t150 - t105 * t168);
        let K0_12_c = t109 - t168;
        let t174 = sin_lam * K0_12_c;
        let K2_22_c = C1_12_IBxz * K0_12_c;
        let t177 = sin_lam * t33;
        let t178 = self.c * t177;
        let t182 = self.zH * cos_lam + self.xH * t178 - sin_lam * t49;
        let t183 = self.mH * t182;
        let M_12_lam = t66 + t94 * t178 - self.zH * t183 - t15 * cos_lam;
        let t192 = sin_lam + t178;
        let t197 = cos_lam * t39 + t72 * t182 - t63 * t178 - t70 * t192;
        let M_22_lam = t197 + t197;
        let t202 = t127 + t78 * t192 + t96 * t177;
        let C1_21_lam = t127 + h_wheels_all * t178;
        let C1_22_lam = t177 * (t112 + t114) + t149 * t192 + t145 * t182
            - cos_lam * (t79 + t98 + C1_12_IBxz * self.IHxz);
        let t216 = ay_all1_delta * t178;
        let t217 = t79 - t183;
        let t218 = t216 - t217;
        let K0_22_lam = sin_lam * t218 - cos_lam * K0_12;
        let K2_12_lam = t125 * t177;
        let K2_22_lam = C1_12_IBxz * (t83 - t218) - sin_lam * t159;
        let M_11_rR = t84 + t84;
        let t228 = t88 * t89;
        let t230 = C1_12_IBxz * (self.mR - t228);
        let C1_12_rR = self.c * t230;
        let C1_21_rR = yaw_by_delta * t228;
        let t233 = self.rR * C1_12_IBxz;
        let C1_12_mR = self.c * t233;
        let t236 = C1_12_IBxz * yaw_by_delta;
        let M_22_IRxx = self.c * t236;
        let t238 = C1_12_IBxz * t88;
        let C1_12_IRyy = self.c * t238;
        let t240 = C1_12_IBxz * t41;
        let M_12_xB = self.c * t240;
        let K0_12_mB = yaw_by_delta * self.xB;
        let K0_12_xB = self.mB * yaw_by_delta;
        let t244 = K0_12_mB * K0_12_xB;
        let M_22_xB = t244 + t244;
        let K2_22_mB = self.xB * t236;
        let t247 = self.c + self.xB;
        let t248 = t236 * t247;
        let t250 = self.mB * (K2_22_mB + t248);
        let t251 = sin_lam * K0_12_xB;
        let K2_22_xB = yaw_by_delta * K2_12_zB;
        let M_11_zB = t41 + t41;
        let t254 = t109 + K0_12_xB;
        let M_12_mB = self.zB * K0_12_mB;
        let M_22_mB = K0_12_mB * K0_12_mB;
        let K2_12_mB = self.zB * C1_12_IBxz;
        let t258 = t247 * K2_12_mB;
        let t259 = self.xB * t248;
        let t260 = sin_lam * K0_12_mB;
        let K0_12_xH = self.mH * wz_delta2_delta;
        let M_12_xH = self.zH * K0_12_xH;
        let t263 = wz_delta2_delta * t136;
        let K2_12_zH = self.mH * C1_12_IBxz;
        let t265 = self.zH * K2_12_zH;
        let t268 = C1_12_IBxz * (t105 * K0_12_xH - t72);
        let t269 = self.mH * t116;
        let K2_22_xH = C1_12_IBxz * K0_12_xH;
        let M_11_zH = t2 + t2;
        let t273 = t72 + self.mH * t46;
        let M_22_zH = sin_lam * t136;
        let t275 = self.mH * sin_lam;
        let C1_22_zH = t144 * t275;
        let K0_22_zH = sin_lam * t275;
        let t278 = C1_12_IBxz * t275;
        let M_11_mH = self.zH * self.zH;
        let t280 = self.zH * t54;
        let M_22_mH = t54 * t54;
        let t282 = self.zH * t144;
        let t283 = C1_12_IBxz * t54;
        let C1_22_mH = t105 * t283;
        let K0_22_mH = sin_lam * t54;
        let K2_12_mH = self.zH * C1_12_IBxz;
        let M_22_IHxx = sin_lam * sin_lam;
        let M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
        let t289 = C1_12_IBxz * wz_delta2_delta;
        let M_22_IHxz = t116 + t116;
        let K2_22_h_spin_R = cos_lam * t177;
        let M_11_rF = t78 + t78;
        let t293 = t122 + t122;
        let M_22_rF = sin_lam * t293;
        let t295 = t81 * h_spin_R;
        let t296 = self.mF - t295;
        let C1_12_rF = wz_delta2_delta * t296;
        let C1_21_rF = wz_delta2_delta * t295;
        let t299 = wz_delta2_delta * K0_12_rF;
        let t300 = self.mF * M_22_IHxx;
        let t301 = C1_12_IBxz * t296;
        let K2_22_rF = K2_22_h_spin_R * t296;
        let t303 = M_11_mF * sin_lam;
        let K0_12_mF = self.rF * sin_lam;
        let t305 = sin_lam * K0_12_mF;
        let M_22_mF = self.rF * t305;
        let C1_12_mF = self.rF * wz_delta2_delta;
        let t308 = wz_delta2_delta * K0_12_mF;
        let t309 = self.rF * C1_12_IBxz;
        let K2_22_mF = sin_lam * t309;
        let M_22_IFxx = M_22_IHxx + M_22_IHzz;
        let C1_12_IFyy = wz_delta2_delta * t81;
        let t313 = C1_12_IBxz * t81;
        let K2_22_IFyy = t81 * K2_22_h_spin_R;
        let M_12 = -(t39 + yaw_by_delta * t44 + t2 * t54);
        let C1_21 = -(t83 + t103);
        let C1_22 = -(t115 + t78 * t116);
        let K0_11 = t86 - t78;
        let K0_22 = -(sin_lam * K0_12);
        let K2_12 = -C1_12_c;
        let K0_12_lam = t217 - t216;
        let K0_12_mH = t53 - t51;
        (
            RearSteeredMatrices::from_entries([
                M_11, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, K0_11, K0_12, K0_12, K0_22, zero,
                K2_12, zero, K2_22,
            ]),
            RearSteeredDerivatives {
                values: [
                    t133, M_22_w, t142, C1_21_w, C1_22_w, t156, K0_22_w, K2_12_w, t161, M_12_c,
                    M_22_c, C1_12_c, t102, t172, K0_12_c, t174, K2_22_c, M_12_lam, M_22_lam, t202,
                    C1_21_lam, C1_22_lam, K0_12_lam, K0_22_lam, K2_12_lam, K2_22_lam, M_11_rR,
                    C1_12_rR, C1_21_rR, self.mR, t230, M_11_mR, C1_12_mR, self.rR, t233,
                    self.w.like(1.0), M_22_IRxx, t236, C1_12_IRyy, t238, M_12_xB, M_22_xB, t240,
                    t250, K0_12_xB, t251, K2_22_xB, M_11_zB, M_12_zB, t254, self.mB, K2_12_zB,
                    M_11_mB, M_12_mB, M_22_mB, t258, t259, self.zB, K0_12_mB, t260, K2_12_mB,
                    K2_22_mB, yaw_by_delta, C1_12_IBxz, M_12_xH, t263, t265, t268, K0_12_xH, t269,
                    K2_22_xH, M_11_zH, t273, M_22_zH, t145, C1_22_zH, self.mH, t275, K0_22_zH,
                    K2_12_zH, t278, M_11_mH, t280, M_22_mH, t282, C1_22_mH, self.zH, K0_12_mH,
                    K0_22_mH, K2_12_mH, t283, sin_lam, M_22_IHxx, M_22_IHzz, t289, wz_delta2_delta,
                    M_22_IHxz, K2_22_h_spin_R, M_11_rF, t293, M_22_rF, C1_12_rF, C1_21_rF, t299,
                    self.mF, K0_12_rF, t300, t301, K2_22_rF, M_11_mF, t303, M_22_mF, C1_12_mF, t308,
                    self.rF, K0_12_mF, t305, t309, K2_22_mF, M_22_IFxx, C1_12_IFyy, t313,
                    K2_22_IFyy,
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
        let matrices = self.matrices();
        [
            matrices.m[0][0], matrices.m[0][1], matrices.m[1][1], matrices.c1[0][1],
            matrices.c1[1][0], matrices.c1[1][1], matrices.k0[0][0], matrices.k0[0][1],
            matrices.k0[1][1], matrices.k2[0][1], matrices.k2[1][1],
        ]
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

impl RearSteeredDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 158] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 0).negative(),
        Partial::new(MatrixName::M, 1, 0, 0, 0).negative(), Partial::new(MatrixName::M, 1, 1, 0, 1),
        Partial::new(MatrixName::C1, 0, 1, 0, 2).negative(),
        Partial::new(MatrixName::C1, 1, 0, 0, 3), Partial::new(MatrixName::C1, 1, 1, 0, 4),
        Partial::new(MatrixName::K0, 0, 1, 0, 5).negative(),
        Partial::new(MatrixName::K0, 1, 0, 0, 5).negative(),
        Partial::new(MatrixName::K0, 1, 1, 0, 6), Partial::new(MatrixName::K2, 0, 1, 0, 7),
        Partial::new(MatrixName::K2, 1, 1, 0, 8).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 9), Partial::new(MatrixName::M, 1, 0, 1, 9),
        Partial::new(MatrixName::M, 1, 1, 1, 10), Partial::new(MatrixName::C1, 0, 1, 1, 11),
        Partial::new(MatrixName::C1, 1, 0, 1, 12).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 13).negative(),
        Partial::new(MatrixName::K0, 0, 1, 1, 14),
        Partial::new(MatrixName::K0, 1, 0, 1, 14),
        Partial::new(MatrixName::K0, 1, 1, 1, 15).negative(),
        Partial::new(MatrixName::K2, 1, 1, 1, 16), Partial::new(MatrixName::M, 0, 1, 2, 17),
        Partial::new(MatrixName::M, 1, 0, 2, 17), Partial::new(MatrixName::M, 1, 1, 2, 18),
        Partial::new(MatrixName::C1, 0, 1, 2, 19).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 20), Partial::new(MatrixName::C1, 1, 1, 2, 21),
        Partial::new(MatrixName::K0, 0, 1, 2, 22), Partial::new(MatrixName::K0, 1, 0, 2, 22),
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
        Partial::new(MatrixName::C1, 0, 1, 14, 63),
        Partial::new(MatrixName::M, 0, 1, 15, 64),
        Partial::new(MatrixName::M, 1, 0, 15, 64),
        Partial::new(MatrixName::M, 1, 1, 15, 65).negative(),
        Partial::new(MatrixName::C1, 0, 1, 15, 66).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 67).negative(),
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
