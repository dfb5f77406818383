// @generated from generated/models/balance_assist.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: a9fd1c383f4b46f9

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A bicycle with a motor that steers into the fall, so that it stays up at lower speeds.
///
/// The Whipple-Carvallo bicycle with a torque on its steer that follows from the lean rate and fades with the speed,
/// `kappa*(vo - v)` times the lean rate: up to the speed `vo`, beyond which such a motor is switched off and the bicycle is
/// [`Whipple`](crate::Whipple). Axes: origin at the rear contact point, x forward, y to the right, z down.
///
/// The declaration asserts that the matrices are those of Appendix A of the paper, less the torque in C0 and C1.
///
/// Source: Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3; torque: BicycleParameters, example plot_balanceassistv1.py
///
/// Derived from a mechanism: body `B` (rear frame and rider), body `H` (front frame), wheel `R` (rear wheel), wheel `F` (front wheel).
///
/// The fields are the parameters. The coordinates are `phi` (lean) in `rad`, `delta` (steer) in `rad`.
///
/// In the matrices is what follows from the motion:
///
/// - `Tmotor` (steer torque of the motor) in `N*m` on `delta`: `kappa*(vo - v)*rate(phi)`.
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
/// mA = mH + mF [kg]
/// mu = (c/w)*cos(lam) [1]
/// SR = IRyy/rR [kg*m]
/// SF = IFyy/rF [kg*m]
/// ST = SR + SF [kg*m]
/// yaw_per_v_delta = cos(lam)/w [1/m]
/// Jxx_delta = IHxx + IFxx + zH^2*mH + rF^2*mF [kg*m^2]
/// Jxz_delta = IHxz - c*rF*mF - zH*mH*(xH - (w + c)) [kg*m^2]
/// Jzz_delta = mH*(xH - (w + c))^2 + IHzz + IFxx + c^2*mF [kg*m^2]
/// Sx_delta = mH*(xH - (w + c)) - c*mF [kg*m]
/// Sz_delta = zH*mH - rF*mF [kg*m]
/// py_delta = Sx_delta*cos(lam) - Sz_delta*sin(lam) [kg*m]
/// hx_delta = Jxx_delta*sin(lam) + Jxz_delta*cos(lam) [kg*m^2]
/// hz_delta = Jxz_delta*sin(lam) + Jzz_delta*cos(lam) [kg*m^2]
/// Jxx_all = IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB [kg*m^2]
/// Jxz_all = IBxz + Jxz_delta - xB*zB*mB - Sz_delta*(w + c) [kg*m^2]
/// Jzz_all = IRxx + IBzz + Jzz_delta + 2*(w + c)*((1/2)*mA*(w + c) + Sx_delta) + xB^2*mB [kg*m^2]
/// Sx_all = xB*mB + mA*(w + c) + Sx_delta [kg*m]
/// Sz_all = zB*mB + Sz_delta - rR*mR [kg*m]
/// load_spin_F = -Sx_all/w [kg]
/// M_yaw_delta = py_delta*(w + c) + hz_delta [kg*m^2]
/// M_delta_delta = hx_delta*sin(lam) + hz_delta*cos(lam) [kg*m^2]
/// K_phi_delta = c*load_spin_F*cos(lam) - py_delta [kg*m]
/// K_delta_delta = (c*load_spin_F*cos(lam) - py_delta)*sin(lam) [kg*m]
/// P_delta_lateral = mu*Sx_all + py_delta [kg*m]
/// P_delta_yaw = mu*Jzz_all + M_yaw_delta [kg*m^2]
/// P_delta_delta = mu*M_yaw_delta + M_delta_delta [kg*m^2]
/// M_11 = Jxx_all [kg*m^2]
/// M_12 = M_21 = mu*Jxz_all + hx_delta [kg*m^2]
/// M_22 = mu*P_delta_yaw + P_delta_delta [kg*m^2]
/// C0_21 = -kappa*vo [kg*m^2/s]
/// C1_12 = mu*(ST - Sz_all) + SF*cos(lam) + yaw_per_v_delta*Jxz_all [kg*m]
/// C1_21 = kappa - mu*ST - SF*cos(lam) [kg*m]
/// C1_22 = mu*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
/// K0_11 = Sz_all [kg*m]
/// K0_12 = K0_21 = K_phi_delta [kg*m]
/// K0_22 = K_delta_delta [kg*m]
/// K2_12 = yaw_per_v_delta*(ST - Sz_all) [kg]
/// K2_22 = yaw_per_v_delta*(SF*sin(lam) + P_delta_lateral) [kg]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct BalanceAssist<T = f64> {
    /// Wheel base.
    ///
    /// `w` in `m`: `> 0`.
    pub w: T,
    /// Trail: positive when the front contact is behind the point where the steer axis meets the ground.
    ///
    /// `c` in `m`: any finite value.
    pub c: T,
    /// Steer axis tilt: 90 degrees minus the head angle.
    ///
    /// `lam`, λ, in `rad`: `> -1.5707963267948966 and < 1.5707963267948966`.
    pub lam: T,
    /// Gravitational field strength.
    ///
    /// `g` in `N/kg`: `>= 0`.
    pub g: T,
    /// Radius of the rear wheel.
    ///
    /// `rR` in `m`: `> 0`.
    pub rR: T,
    /// Mass of the rear wheel.
    ///
    /// `mR` in `kg`: `>= 0`.
    pub mR: T,
    /// Radial moment of inertia of the rear wheel; by symmetry also about the vertical.
    ///
    /// `IRxx` in `kg*m^2`: `>= 0`.
    pub IRxx: T,
    /// Axial moment of inertia of the rear wheel.
    ///
    /// `IRyy` in `kg*m^2`: `>= 0`.
    pub IRyy: T,
    /// Centre of mass of the rear frame and rider, forward of the rear contact.
    ///
    /// `xB` in `m`: any finite value.
    pub xB: T,
    /// Centre of mass of the rear frame and rider, downward.
    ///
    /// `zB` in `m`: any finite value.
    pub zB: T,
    /// Mass of the rear frame and rider.
    ///
    /// `mB` in `kg`: `>= 0`.
    pub mB: T,
    /// Moment of inertia of the rear frame and rider about its centre of mass, in roll.
    ///
    /// `IBxx` in `kg*m^2`: `>= 0`.
    pub IBxx: T,
    /// Moment of inertia of the rear frame and rider about its centre of mass, in pitch.
    ///
    /// `IByy` in `kg*m^2`: `>= 0`. No matrix depends on it.
    pub IByy: T,
    /// Moment of inertia of the rear frame and rider about its centre of mass, in yaw.
    ///
    /// `IBzz` in `kg*m^2`: `>= 0`.
    pub IBzz: T,
    /// Product of inertia of the rear frame and rider about its centre of mass.
    ///
    /// `IBxz` in `kg*m^2`: any finite value.
    pub IBxz: T,
    /// Centre of mass of the front frame, forward of the rear contact.
    ///
    /// `xH` in `m`: any finite value.
    pub xH: T,
    /// Centre of mass of the front frame, downward.
    ///
    /// `zH` in `m`: any finite value.
    pub zH: T,
    /// Mass of the front frame.
    ///
    /// `mH` in `kg`: `>= 0`.
    pub mH: T,
    /// Moment of inertia of the front frame about its centre of mass, in roll.
    ///
    /// `IHxx` in `kg*m^2`: `>= 0`.
    pub IHxx: T,
    /// Moment of inertia of the front frame about its centre of mass, in pitch.
    ///
    /// `IHyy` in `kg*m^2`: `>= 0`. No matrix depends on it.
    pub IHyy: T,
    /// Moment of inertia of the front frame about its centre of mass, in yaw.
    ///
    /// `IHzz` in `kg*m^2`: `>= 0`.
    pub IHzz: T,
    /// Product of inertia of the front frame about its centre of mass.
    ///
    /// `IHxz` in `kg*m^2`: any finite value.
    pub IHxz: T,
    /// Radius of the front wheel.
    ///
    /// `rF` in `m`: `> 0`.
    pub rF: T,
    /// Mass of the front wheel.
    ///
    /// `mF` in `kg`: `>= 0`.
    pub mF: T,
    /// Radial moment of inertia of the front wheel; by symmetry also about the vertical.
    ///
    /// `IFxx` in `kg*m^2`: `>= 0`.
    pub IFxx: T,
    /// Axial moment of inertia of the front wheel.
    ///
    /// `IFyy` in `kg*m^2`: `>= 0`.
    pub IFyy: T,
    /// Steer torque by lean rate, for each m/s that the bicycle is slower than `vo`.
    ///
    /// `kappa`, κ, in `N*s^2`: `>= 0`.
    pub kappa: T,
    /// The speed from which the motor leaves the bicycle alone.
    ///
    /// `vo` in `m/s`: `> 0`.
    pub vo: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`BalanceAssist`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BalanceAssistMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C0, a coefficient of q'.
    pub c0: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 2>,
}

impl<T: Number> BalanceAssist<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 48 additions, 45 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 100 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> BalanceAssistMatrices<T> {
        let t6 = self.zH * self.mH;
        let t10 = self.rF * self.mF;
        let Jxx_delta = self.IHxx + self.IFxx + self.zH * t6 + self.rF * t10;
        let t17 = self.rR * self.mR;
        let t21 = self.zB * self.mB;
        let M_11 = self.IRxx + self.IBxx + Jxx_delta + self.rR * t17 + self.zB * t21;
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t35 = self.c + self.w;
        let t36 = t35 - self.xH;
        let Jxz_delta = self.IHxz + t6 * t36 - t10 * self.c;
        let hx_delta = Jxx_delta * sin_lam + Jxz_delta * cos_lam;
        let yaw_per_v_delta = cos_lam / self.w;
        let mu = self.c * yaw_per_v_delta;
        let Sz_delta = t6 - t10;
        let Jxz_all = Jxz_delta + self.IBxz - t21 * self.xB - t35 * Sz_delta;
        let M_12 = hx_delta + mu * Jxz_all;
        let t57 = self.mH * t36;
        let t59 = self.mF * self.c;
        let Jzz_delta = self.IFxx + self.IHzz + t36 * t57 + self.c * t59;
        let hz_delta = sin_lam * Jxz_delta + cos_lam * Jzz_delta;
        let t67 = t57 + t59;
        let t69 = sin_lam * Sz_delta + cos_lam * t67;
        let M_yaw_delta = hz_delta - t35 * t69;
        let t73 = self.mB * self.xB;
        let mA = self.mH + self.mF;
        let t77 = t67 - t35 * mA;
        let P_delta_yaw = M_yaw_delta
            + mu
                * (self.IRxx + Jzz_delta + self.IBzz + self.xB * t73
                    - t35 * (t67 + t77));
        let M_22 = mu * (M_yaw_delta + P_delta_yaw) + sin_lam * hx_delta
            + cos_lam * hz_delta;
        let zero = self.w.like(0.0);
        let SF = self.IFyy / self.rF;
        let ST = SF + self.IRyy / self.rR;
        let Sz_all = t21 + Sz_delta - t17;
        let t103 = ST - Sz_all;
        let t105 = cos_lam * SF;
        let C1_12 = mu * t103 + t105 + yaw_per_v_delta * Jxz_all;
        let C1_21 = self.kappa - t105 - mu * ST;
        let Sx_all = t73 - t77;
        let t113 = mu * Sx_all;
        let P_delta_lateral = t113 - t69;
        let C1_22 = mu * P_delta_lateral + yaw_per_v_delta * P_delta_yaw;
        let K2_12 = yaw_per_v_delta * t103;
        let K2_22 = yaw_per_v_delta * (P_delta_lateral + sin_lam * SF);
        let C0_21 = -(self.kappa * self.vo);
        let K0_12 = t69 - t113;
        let K0_22 = -(sin_lam * P_delta_lateral);
        BalanceAssistMatrices::from_entries([
            M_11, M_12, M_12, M_22, zero, zero, C0_21, zero, zero, C1_12, C1_21, C1_22, Sz_all,
            K0_12, K0_12, K0_22, zero, K2_12, zero, K2_22,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`BalanceAssist`] that follow from its coordinates q = (`phi`, `delta`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BalanceAssistKinematics<T = f64> {
    /// Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin.
    pub lateral: Rate<T, 2>,
    /// Yaw rate, to the right, in `rad/s`: of `B`.
    pub yaw: Rate<T, 2>,
    /// Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_R: Rate<T, 2>,
    /// Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_F: Rate<T, 2>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate,
    /// a column for each of `Tphi` (lean torque) in `N*m`, `Tdelta` (steer torque) in `N*m`.
    pub forces: [[T; 2]; 2],
}

impl<T: Scalar> BalanceAssist<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> BalanceAssistKinematics<T> {
        let zero = self.w.like(0.0);
        let yaw_per_v_delta = self.lam.cos() / self.w;
        let mu = self.c * yaw_per_v_delta;
        let t12 = -(self.w.like(1.0) / self.rR);
        let t13 = -(self.w.like(1.0) / self.rF);
        BalanceAssistKinematics {
            lateral: Rate {
                speed: zero, rates: [zero, zero], coordinates: [zero, zero],
                heading: self.w.like(1.0),
            },
            yaw: Rate {
                speed: zero, rates: [zero, mu], coordinates: [zero, yaw_per_v_delta], heading: zero,
            },
            wheel_R: Rate {
                speed: t12, rates: [zero, zero], coordinates: [zero, zero], heading: zero,
            },
            wheel_F: Rate {
                speed: t13, rates: [zero, zero], coordinates: [zero, zero], heading: zero,
            },
            forces: [[self.w.like(1.0), zero], [zero, self.w.like(1.0)]],
        }
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`BalanceAssist`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BalanceAssistDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 125],
}

impl<T: Number> BalanceAssist<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 133 additions, 202 multiplications, 3 divisions, 5 negations and 2 trigonometric functions: 345 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (BalanceAssistMatrices<T>, BalanceAssistDerivatives<T>) {
        let M_11_mB = self.zB * self.zB;
        let t10 = self.rF * self.mF;
        let t14 = self.zH * self.mH;
        let Jxx_delta = self.IFxx + self.IHxx + self.rF * t10 + self.zH * t14;
        let M_11_mR = self.rR * self.rR;
        let M_11 = self.IBxx + self.IRxx + self.mB * M_11_mB + Jxx_delta
            + self.mR * M_11_mR;
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t32 = t10 - t14;
        let t36 = self.w - self.xH;
        let t39 = self.IHxz + t14 * t36 - self.c * t32;
        let t41 = t39 * cos_lam;
        let hx_delta = Jxx_delta * sin_lam + t41;
        let t44 = self.c + self.w;
        let M_22_hz_delta = t32 * t44;
        let t47 = self.mB * self.zB;
        let t51 = t39 + self.IBxz + M_22_hz_delta - self.xB * t47;
        let t52 = self.w.like(1.0) / self.w;
        let yaw_per_v_delta = cos_lam * t52;
        let mu = self.c * yaw_per_v_delta;
        let M_12 = hx_delta + t51 * mu;
        let t59 = self.mF * self.c;
        let t60 = t44 - self.xH;
        let t61 = self.mH * t60;
        let t62 = t59 + t61;
        let t64 = sin_lam * t32 - cos_lam * t62;
        let t65 = t44 * t64;
        let t66 = sin_lam * t39;
        let Jzz_delta = self.IFxx + self.IHzz + self.c * t59 + t60 * t61;
        let t74 = t66 + cos_lam * Jzz_delta;
        let t75 = self.mB * self.xB;
        let mA = self.mF + self.mH;
        let t80 = t62 - t44 * mA;
        let t86 = self.IRxx + Jzz_delta + self.xB * t75 + self.IBzz - t44 * (t62 + t80);
        let t87 = mu * t86;
        let t89 = t65 + t74 + t87;
        let M_12_Jxz_delta = cos_lam + mu;
        let M_22 = sin_lam * hx_delta + mu * (t65 + t89) + t74 * M_12_Jxz_delta;
        let zero = self.w.like(0.0);
        let t101 = self.w.like(1.0) / self.rF;
        let SF = self.IFyy * t101;
        let t104 = self.w.like(1.0) / self.rR;
        let t105 = self.IRyy * t104;
        let ST = SF + t105;
        let t107 = self.mR * self.rR;
        let K0_11 = t47 - (t32 + t107);
        let t111 = t52 * (ST - K0_11);
        let t113 = t51 * t52;
        let t114 = self.c * t111 + t113;
        let t115 = SF + t114;
        let C1_12 = cos_lam * t115;
        let t117 = cos_lam * SF;
        let t118 = mu * ST;
        let C1_21 = self.kappa - t117 - t118;
        let t121 = mu * t75;
        let t122 = mu * t80;
        let t123 = t121 - t122;
        let t124 = t64 + t123;
        let t126 = t89 + self.c * t124;
        let C1_22 = yaw_per_v_delta * t126;
        let K2_12 = cos_lam * t111;
        let t130 = sin_lam * SF;
        let t131 = t124 + t130;
        let K2_22 = yaw_per_v_delta * t131;
        let t133 = t32 - t113;
        let t135 = t14 * M_12_Jxz_delta;
        let M_12_w = mu * t133 + t135;
        let t137 = t52 * t89;
        let t138 = t137 + t137;
        let t140 = t60 * M_12_Jxz_delta;
        let t141 = M_12_Jxz_delta * t140;
        let t142 = t44 * mu;
        let t143 = M_12_Jxz_delta + M_12_Jxz_delta;
        let t144 = t142 * t143;
        let t145 = t141 - t144;
        let t146 = self.zH * sin_lam;
        let t150 = self.mH * (t141 + t145 + t143 * t146);
        let t151 = mu + mu;
        let t152 = t64 - t122;
        let P_delta_yaw_xB = t151 * t152;
        let t154 = t150 + P_delta_yaw_xB;
        let M_22_w = t154 - mu * t138;
        let C1_12_w = yaw_per_v_delta * (t10 - t114);
        let C1_21_w = t52 * t118;
        let t161 = self.mF * mu - self.mH * cos_lam;
        let t162 = t52 * t123;
        let P_delta_lateral_w = t161 - t162;
        let t165 = t142 - t140;
        let K0_12_mH = t146 - t165;
        let t167 = t165 - K0_12_mH;
        let t168 = cos_lam * t44;
        let t169 = t167 + t168;
        let t172 = t122 + self.mH * t169 - t152;
        let t174 = t52 * (t87 + t126);
        let C1_22_w = yaw_per_v_delta * (self.c * P_delta_lateral_w - t172 - t174);
        let t178 = sin_lam * P_delta_lateral_w;
        let t179 = yaw_per_v_delta * t111;
        let t180 = t52 * t131;
        let K2_22_w = yaw_per_v_delta * (P_delta_lateral_w - t180);
        let t183 = cos_lam * t133;
        let M_22_Jzz_delta = M_12_Jxz_delta * M_12_Jxz_delta;
        let t185 = self.c * M_22_Jzz_delta;
        let t186 = t185 - t144;
        let t190 = self.mF * M_12_Jxz_delta;
        let t191 = self.rF * sin_lam;
        let t193 = cos_lam * t137 - t190 * t191;
        let M_22_c = t154 + self.mF * (t185 + t186) + t193 + t193;
        let t197 = yaw_per_v_delta * ST;
        let t198 = self.c * M_12_Jxz_delta;
        let t200 = t142 + t191 - t198;
        let t201 = t142 + t200;
        let t205 = t75 - t80;
        let t207 = t161 + yaw_per_v_delta * t205;
        let t212 = t172 + self.mF * (t168 + t201) - t124 - yaw_per_v_delta * t86
            - self.c * t207;
        let t213 = yaw_per_v_delta * t212;
        let K0_12_c = t190 - t207;
        let t218 = t66 - Jxx_delta * cos_lam;
        let t220 = sin_lam * self.c * t52;
        let t222 = t218 + t51 * t220;
        let t229 = t32 * cos_lam + sin_lam * t62;
        let t232 = t41 - sin_lam * Jzz_delta;
        let t233 = t44 * t229 + t232;
        let M_22_lam = t151 * t233 + cos_lam * (hx_delta + t232)
            - sin_lam * (t74 + t218 + self.c * t138);
        let t239 = sin_lam * t115;
        let C1_21_lam = t130 + ST * t220;
        let t242 = t205 * t220;
        let t243 = t229 - t242;
        let C1_22_lam = yaw_per_v_delta * (t233 + self.c * t243) - sin_lam * t174;
        let t251 = sin_lam * t243 + cos_lam * t124;
        let t252 = sin_lam * t111;
        let K2_22_lam = yaw_per_v_delta * (t117 + t243) - sin_lam * t180;
        let M_11_rR = t107 + t107;
        let K2_12_IRyy = yaw_per_v_delta * t104;
        let K2_12_rR = self.mR * yaw_per_v_delta - t105 * K2_12_IRyy;
        let C1_12_rR = self.c * K2_12_rR;
        let C1_12_IRyy = mu * t104;
        let C1_21_rR = t105 * C1_12_IRyy;
        let K2_12_mR = self.rR * yaw_per_v_delta;
        let C1_12_mR = self.c * K2_12_mR;
        let C1_22_IRxx = yaw_per_v_delta * mu;
        let M_22_IRxx = self.c * C1_22_IRxx;
        let t270 = self.mB * self.c;
        let t271 = self.zB * yaw_per_v_delta;
        let t272 = t270 * t271;
        let M_22_xB = t121 * t151;
        let t274 = self.mB * yaw_per_v_delta;
        let t275 = self.zB * t274;
        let t276 = self.c + self.xB;
        let t277 = self.c * t274;
        let K2_22_xB = yaw_per_v_delta * t277;
        let t280 = self.xB * mu;
        let C1_22_xB = t276 * K2_22_xB + t274 * t280;
        let C1_22_Jxz_delta = sin_lam * yaw_per_v_delta;
        let t284 = t270 * C1_22_Jxz_delta;
        let M_11_zB = t47 + t47;
        let t286 = t274 * t276;
        let t287 = self.zB * t280;
        let M_22_mB = t280 * t280;
        let t289 = t271 * t276;
        let K2_22_mB = self.xB * C1_22_IRxx;
        let C1_22_mB = t276 * K2_22_mB;
        let t292 = sin_lam * t280;
        let t293 = self.mH * yaw_per_v_delta;
        let t294 = self.zH * t293;
        let C1_22_xH = t293 * (t169 + t198);
        let t297 = self.mH * M_12_Jxz_delta;
        let t298 = sin_lam * t297;
        let K2_22_xH = M_12_Jxz_delta * t293;
        let M_11_zH = t14 + t14;
        let t301 = t146 + K0_12_mH;
        let M_12_zH = self.mH * t301;
        let K0_12_zH = self.mH * sin_lam;
        let t305 = (t165 - t301) * K0_12_zH;
        let t306 = self.c + self.xH;
        let t307 = t293 * t306;
        let t308 = sin_lam * t307;
        let K0_22_zH = sin_lam * K0_12_zH;
        let t310 = yaw_per_v_delta * K0_12_zH;
        let M_11_mH = self.zH * self.zH;
        let M_12_mH = self.zH * K0_12_mH;
        let t313 = t44 * yaw_per_v_delta;
        let C1_22_mA = t142 * t313;
        let M_22_mH = self.c * C1_22_mA + t60 * t145 - t146 * t167;
        let t320 = self.zH * yaw_per_v_delta;
        let t321 = t306 * t320;
        let C1_22_mH = C1_22_mA
            - yaw_per_v_delta * (t44 * t140 + t36 * t165 + t146 * t306);
        let K0_22_mH = sin_lam * K0_12_mH;
        let t330 = yaw_per_v_delta * K0_12_mH;
        let M_22_Jxx_delta = sin_lam * sin_lam;
        let C1_22_Jzz_delta = yaw_per_v_delta * M_12_Jxz_delta;
        let M_22_Jxz_delta = sin_lam * t143;
        let M_11_rF = t10 + t10;
        let M_12_rF = self.mF * (t191 + t200);
        let P_delta_lateral_rF = self.mF * sin_lam;
        let t338 = t200 * P_delta_lateral_rF;
        let M_22_rF = t338 + t338;
        let t340 = self.mF * t313;
        let t341 = t101 * SF;
        let C1_21_rF = M_12_Jxz_delta * t341;
        let C1_12_rF = t340 - C1_21_rF;
        let C1_22_rF = sin_lam * t340;
        let t345 = sin_lam * P_delta_lateral_rF;
        let K2_12_rF = yaw_per_v_delta * (self.mF - t341);
        let K2_22_rF = sin_lam * K2_12_rF;
        let M_11_mF = self.rF * self.rF;
        let M_12_mF = self.rF * t200;
        let M_22_mF = self.c * (t186 + C1_22_mA) - t191 * (t198 - t201);
        let C1_12_mF = self.rF * t313;
        let C1_22_mF = t200 * t313;
        let t358 = sin_lam * t200;
        let K2_12_mF = self.rF * yaw_per_v_delta;
        let K2_22_mF = yaw_per_v_delta * t200;
        let M_22_IFxx = M_22_Jzz_delta + M_22_Jxx_delta;
        let C1_12_IFyy = M_12_Jxz_delta * t101;
        let K2_12_IFyy = yaw_per_v_delta * t101;
        let K2_22_IFyy = t101 * C1_22_Jxz_delta;
        let C0_21 = -(self.kappa * self.vo);
        let K0_12 = -t124;
        let K0_22 = -(sin_lam * t124);
        let K0_12_w = t162 - t161;
        let t369 = -(sin_lam * K0_12_c);
        let K2_22_c = -(yaw_per_v_delta * K0_12_c);
        let K0_12_lam = t242 - t229;
        (
            BalanceAssistMatrices::from_entries([
                M_11, M_12, M_12, M_22, zero, zero, C0_21, zero, zero, C1_12, C1_21, C1_22, K0_11,
                K0_12, K0_12, K0_22, zero, K2_12, zero, K2_22,
            ]),
            BalanceAssistDerivatives {
                values: [
                    M_12_w, M_22_w, C1_12_w, C1_21_w, C1_22_w, K0_12_w, t178, t179, K2_22_w, t183,
                    M_22_c, K2_12, t197, t213, K0_12_c, t369, K2_22_c, t222, M_22_lam, t239,
                    C1_21_lam, C1_22_lam, K0_12_lam, t251, t252, K2_22_lam, M_11_rR, C1_12_rR,
                    C1_21_rR, self.mR, K2_12_rR, M_11_mR, C1_12_mR, self.rR, K2_12_mR,
                    self.w.like(1.0), M_22_IRxx, C1_22_IRxx, C1_12_IRyy, K2_12_IRyy, t272, M_22_xB,
                    t275, C1_22_xB, t277, t284, K2_22_xB, M_11_zB, t121, t286, self.mB, t274,
                    M_11_mB, t287, M_22_mB, t289, C1_22_mB, self.zB, t280, t292, t271, K2_22_mB, mu,
                    yaw_per_v_delta, t135, t150, t294, C1_22_xH, t297, t298, K2_22_xH, M_11_zH,
                    M_12_zH, t305, t307, t308, self.mH, K0_12_zH, K0_22_zH, t293, t310, M_11_mH,
                    M_12_mH, M_22_mH, t321, C1_22_mH, self.zH, K0_12_mH, K0_22_mH, t320, t330,
                    sin_lam, M_22_Jxx_delta, M_22_Jzz_delta, C1_22_Jzz_delta, M_12_Jxz_delta,
                    M_22_Jxz_delta, C1_22_Jxz_delta, M_11_rF, M_12_rF, M_22_rF, C1_12_rF, C1_21_rF,
                    C1_22_rF, self.mF, P_delta_lateral_rF, t345, K2_12_rF, K2_22_rF, M_11_mF,
                    M_12_mF, M_22_mF, C1_12_mF, C1_22_mF, self.rF, t200, t358, K2_12_mF, K2_22_mF,
                    M_22_IFxx, C1_12_IFyy, K2_12_IFyy, K2_22_IFyy, self.vo, self.kappa,
                ],
            },
        )
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl BalanceAssist<f64> {
    /// The parameter set `benchmark`.
    ///
    /// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; motor: an example of BicycleParameters, plot_balanceassistv1.py
    ///
    /// It is the default.
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
    /// | `kappa` | 10 | `N*s^2` |
    /// | `vo` | 4.7 | `m/s` |
    pub const BENCHMARK: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3141592653589793, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.0603,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.05892, IHyy: 0.06, IHzz: 0.00708, IHxz: -0.00756,
        rF: 0.35, mF: 3.0, IFxx: 0.1405, IFyy: 0.28, kappa: 10.0, vo: 4.7,
    };

    /// The parameter set `balanceassistv1`.
    ///
    /// Source: BicycleParameters 1.5.2 (BSD), Balanceassistv1Benchmark.txt, an electric bicycle without a rider; motor: an example of BicycleParameters, plot_balanceassistv1.py
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `w` | 1.113 | `m` |
    /// | `c` | 0.042 | `m` |
    /// | `lam` | 0.255 | `rad` |
    /// | `g` | 9.80665 | `N/kg` |
    /// | `rR` | 0.34895 | `m` |
    /// | `mR` | 4.085 | `kg` |
    /// | `IRxx` | 0.1023 | `kg*m^2` |
    /// | `IRyy` | 0.1887 | `kg*m^2` |
    /// | `xB` | 0.519 | `m` |
    /// | `zB` | -0.521 | `m` |
    /// | `mB` | 22.5 | `kg` |
    /// | `IBxx` | 1.12 | `kg*m^2` |
    /// | `IByy` | 3.16 | `kg*m^2` |
    /// | `IBzz` | 2.119 | `kg*m^2` |
    /// | `IBxz` | 0.047 | `kg*m^2` |
    /// | `xH` | 0.921 | `m` |
    /// | `zH` | -0.86 | `m` |
    /// | `mH` | 4.3 | `kg` |
    /// | `IHxx` | 0.2984 | `kg*m^2` |
    /// | `IHyy` | 0.257 | `kg*m^2` |
    /// | `IHzz` | 0.0566 | `kg*m^2` |
    /// | `IHxz` | -0.038 | `kg*m^2` |
    /// | `rF` | 0.35231 | `m` |
    /// | `mF` | 2.235 | `kg` |
    /// | `IFxx` | 0.0995 | `kg*m^2` |
    /// | `IFyy` | 0.1902 | `kg*m^2` |
    /// | `kappa` | 10 | `N*s^2` |
    /// | `vo` | 4.7 | `m/s` |
    pub const BALANCEASSISTV1: Self = Self {
        w: 1.113, c: 0.042, lam: 0.255, g: 9.80665, rR: 0.34895, mR: 4.085, IRxx: 0.1023,
        IRyy: 0.1887, xB: 0.519, zB: -0.521, mB: 22.5, IBxx: 1.12, IByy: 3.16, IBzz: 2.119,
        IBxz: 0.047, xH: 0.921, zH: -0.86, mH: 4.3, IHxx: 0.2984, IHyy: 0.257, IHzz: 0.0566,
        IHxz: -0.038, rF: 0.35231, mF: 2.235, IFxx: 0.0995, IFyy: 0.1902, kappa: 10.0, vo: 4.7,
    };
}

impl BalanceAssist<f64> {
    /// The parameter set `benchmark`.
    #[must_use]
    pub const fn default() -> Self {
        Self::BENCHMARK
    }
}

/// The parameter set `benchmark`.
impl<T: Scalar> Default for BalanceAssist<T> {
    fn default() -> Self {
        BalanceAssist::cast(&BalanceAssist::<f64>::BENCHMARK)
    }
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> BalanceAssist<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 28]) -> Self {
        Self {
            w: values[0], c: values[1], lam: values[2], g: values[3], rR: values[4], mR: values[5],
            IRxx: values[6], IRyy: values[7], xB: values[8], zB: values[9], mB: values[10],
            IBxx: values[11], IByy: values[12], IBzz: values[13], IBxz: values[14], xH: values[15],
            zH: values[16], mH: values[17], IHxx: values[18], IHyy: values[19], IHzz: values[20],
            IHxz: values[21], rF: values[22], mF: values[23], IFxx: values[24], IFyy: values[25],
            kappa: values[26], vo: values[27],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 28] {
        [
            self.w, self.c, self.lam, self.g, self.rR, self.mR, self.IRxx, self.IRyy, self.xB,
            self.zB, self.mB, self.IBxx, self.IByy, self.IBzz, self.IBxz, self.xH, self.zH, self.mH,
            self.IHxx, self.IHyy, self.IHzz, self.IHxz, self.rF, self.mF, self.IFxx, self.IFyy,
            self.kappa, self.vo,
        ]
    }
}

impl<T: Scalar> BalanceAssist<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> BalanceAssist<U> {
        let values = self.to_array();
        BalanceAssist::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl BalanceAssist<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> BalanceAssist<f32> {
        BalanceAssist::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<BalanceAssist<f32>> for BalanceAssist<f64> {
    fn from(parameters: BalanceAssist<f32>) -> Self {
        BalanceAssist::cast(&parameters)
    }
}

impl<T: Number> BalanceAssistMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 20]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c0: carvallo::rows(&entries, 4),
            c1: carvallo::rows(&entries, 8),
            k0: carvallo::rows(&entries, 12),
            k2: carvallo::rows(&entries, 16),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 12] {
        [
            self.m[0][0], self.m[0][1], self.m[1][1], self.c0[1][0], self.c1[0][1], self.c1[1][0],
            self.c1[1][1], self.k0[0][0], self.k0[0][1], self.k0[1][1], self.k2[0][1],
            self.k2[1][1],
        ]
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, self.c0.0, self.c1.0, zeros, self.k0.0, zeros, self.k2.0]
    }
}

impl<T: Scalar> From<BalanceAssistMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: BalanceAssistMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for BalanceAssist<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 28];

    type Over<U: Number> = BalanceAssist<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "BalanceAssist",
        docs: "A bicycle with a motor that steers into the fall, so that it stays up at lower speeds.\n\nThe Whipple-Carvallo bicycle with a torque on its steer that follows from the lean rate and fades with the speed,\n`kappa*(vo - v)` times the lean rate: up to the speed `vo`, beyond which such a motor is switched off and the bicycle is\n[`Whipple`](crate::Whipple). Axes: origin at the rear contact point, x forward, y to the right, z down.\n\nThe declaration asserts that the matrices are those of Appendix A of the paper, less the torque in C0 and C1.",
        source: "Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3; torque: BicycleParameters, example plot_balanceassistv1.py",
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
            ParameterInfo::new("kappa", "N*s^2", Domain::NONNEGATIVE)
                .symbol("κ")
                .docs("Steer torque by lean rate, for each m/s that the bicycle is slower than `vo`."),
            ParameterInfo::new("vo", "m/s", Domain::POSITIVE)
                .docs("The speed from which the motor leaves the bicycle alone."),
        ],
        coordinates: &[
            CoordinateInfo::new("phi", "rad")
                .label("lean")
                .docs("Lean of the rear frame, positive to the right."),
            CoordinateInfo::new("delta", "rad")
                .label("steer")
                .docs("Steer of the front frame relative to the rear frame, positive to the right."),
        ],
        forces: &[
            carvallo::motion::AppliedInfo {
                name: "Tphi", label: "lean torque", unit: "N*m", position: "phi",
            },
            carvallo::motion::AppliedInfo {
                name: "Tdelta", label: "steer torque", unit: "N*m", position: "delta",
            },
        ],
        matrices: &[
            MatrixName::M, MatrixName::C0, MatrixName::C1, MatrixName::K0, MatrixName::K2,
        ],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]), EntryInfo::at(&[(MatrixName::C0, 1, 0)]),
            EntryInfo::at(&[(MatrixName::C1, 0, 1)]), EntryInfo::at(&[(MatrixName::C1, 1, 0)]),
            EntryInfo::at(&[(MatrixName::C1, 1, 1)]), EntryInfo::at(&[(MatrixName::K0, 0, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 1, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 0, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 1, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "benchmark",
                docs: "",
                source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; motor: an example of BicycleParameters, plot_balanceassistv1.py",
                values: &BalanceAssist::to_array(&BalanceAssist::<f64>::BENCHMARK),
            },
            SetInfo {
                name: "balanceassistv1",
                docs: "",
                source: "BicycleParameters 1.5.2 (BSD), Balanceassistv1Benchmark.txt, an electric bicycle without a rider; motor: an example of BicycleParameters, plot_balanceassistv1.py",
                values: &BalanceAssist::to_array(&BalanceAssist::<f64>::BALANCEASSISTV1),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("mA", "kg", "mH + mF"),
            FormulaInfo::definition("mu", "1", "(c/w)*cos(lam)"),
            FormulaInfo::definition("SR", "kg*m", "IRyy/rR"),
            FormulaInfo::definition("SF", "kg*m", "IFyy/rF"),
            FormulaInfo::definition("ST", "kg*m", "SR + SF"),
            FormulaInfo::definition("yaw_per_v_delta", "1/m", "cos(lam)/w"),
            FormulaInfo::definition("Jxx_delta", "kg*m^2", "IHxx + IFxx + zH^2*mH + rF^2*mF"),
            FormulaInfo::definition("Jxz_delta", "kg*m^2", "IHxz - c*rF*mF - zH*mH*(xH - (w + c))"),
            FormulaInfo::definition("Jzz_delta", "kg*m^2", "mH*(xH - (w + c))^2 + IHzz + IFxx + c^2*mF"),
            FormulaInfo::definition("Sx_delta", "kg*m", "mH*(xH - (w + c)) - c*mF"),
            FormulaInfo::definition("Sz_delta", "kg*m", "zH*mH - rF*mF"),
            FormulaInfo::definition("py_delta", "kg*m", "Sx_delta*cos(lam) - Sz_delta*sin(lam)"),
            FormulaInfo::definition("hx_delta", "kg*m^2", "Jxx_delta*sin(lam) + Jxz_delta*cos(lam)"),
            FormulaInfo::definition("hz_delta", "kg*m^2", "Jxz_delta*sin(lam) + Jzz_delta*cos(lam)"),
            FormulaInfo::definition("Jxx_all", "kg*m^2", "IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB"),
            FormulaInfo::definition("Jxz_all", "kg*m^2", "IBxz + Jxz_delta - xB*zB*mB - Sz_delta*(w + c)"),
            FormulaInfo::definition(
                "Jzz_all",
                "kg*m^2",
                "IRxx + IBzz + Jzz_delta + 2*(w + c)*((1/2)*mA*(w + c) + Sx_delta) + xB^2*mB",
            ),
            FormulaInfo::definition("Sx_all", "kg*m", "xB*mB + mA*(w + c) + Sx_delta"),
            FormulaInfo::definition("Sz_all", "kg*m", "zB*mB + Sz_delta - rR*mR"),
            FormulaInfo::definition("load_spin_F", "kg", "-Sx_all/w"),
            FormulaInfo::definition("M_yaw_delta", "kg*m^2", "py_delta*(w + c) + hz_delta"),
            FormulaInfo::definition("M_delta_delta", "kg*m^2", "hx_delta*sin(lam) + hz_delta*cos(lam)"),
            FormulaInfo::definition("K_phi_delta", "kg*m", "c*load_spin_F*cos(lam) - py_delta"),
            FormulaInfo::definition("K_delta_delta", "kg*m", "(c*load_spin_F*cos(lam) - py_delta)*sin(lam)"),
            FormulaInfo::definition("P_delta_lateral", "kg*m", "mu*Sx_all + py_delta"),
            FormulaInfo::definition("P_delta_yaw", "kg*m^2", "mu*Jzz_all + M_yaw_delta"),
            FormulaInfo::definition("P_delta_delta", "kg*m^2", "mu*M_yaw_delta + M_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "Jxx_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)], "kg*m^2", "mu*Jxz_all + hx_delta"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "mu*P_delta_yaw + P_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::C0, 1, 0)], "kg*m^2/s", "-kappa*vo"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 1)],
                "kg*m",
                "mu*(ST - Sz_all) + SF*cos(lam) + yaw_per_v_delta*Jxz_all",
            ),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 0)], "kg*m", "kappa - mu*ST - SF*cos(lam)"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 1)], "kg*m", "mu*P_delta_lateral + yaw_per_v_delta*P_delta_yaw"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "Sz_all"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)], "kg*m", "K_phi_delta"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "K_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg", "yaw_per_v_delta*(ST - Sz_all)"),
            FormulaInfo::entry(&[(MatrixName::K2, 1, 1)], "kg", "yaw_per_v_delta*(SF*sin(lam) + P_delta_lateral)"),
        ],
        attributes: &[
            FormulaInfo::attribute("B_mass", "the mass of the rear frame and rider B", "kg", "mB"),
            FormulaInfo::attribute("B_x", "x of the centre of mass of the rear frame and rider B", "m", "xB"),
            FormulaInfo::attribute("B_z", "z of the centre of mass of the rear frame and rider B", "m", "zB"),
            FormulaInfo::attribute("B_Ixx", "the inertia xx of the rear frame and rider B", "kg*m^2", "IBxx"),
            FormulaInfo::attribute("B_Ixz", "the inertia xz of the rear frame and rider B", "kg*m^2", "IBxz"),
            FormulaInfo::attribute("B_Izz", "the inertia zz of the rear frame and rider B", "kg*m^2", "IBzz"),
            FormulaInfo::attribute("H_mass", "the mass of the front frame H", "kg", "mH"),
            FormulaInfo::attribute("H_x", "x of the centre of mass of the front frame H", "m", "xH"),
            FormulaInfo::attribute("H_z", "z of the centre of mass of the front frame H", "m", "zH"),
            FormulaInfo::attribute("H_Ixx", "the inertia xx of the front frame H", "kg*m^2", "IHxx"),
            FormulaInfo::attribute("H_Ixz", "the inertia xz of the front frame H", "kg*m^2", "IHxz"),
            FormulaInfo::attribute("H_Izz", "the inertia zz of the front frame H", "kg*m^2", "IHzz"),
            FormulaInfo::attribute("R_mass", "the mass of the rear wheel R", "kg", "mR"),
            FormulaInfo::attribute("R_radius", "the radius of the rear wheel R", "m", "rR"),
            FormulaInfo::attribute("R_axial", "the axial inertia of the rear wheel R", "kg*m^2", "IRyy"),
            FormulaInfo::attribute("R_radial", "the radial inertia of the rear wheel R", "kg*m^2", "IRxx"),
            FormulaInfo::attribute("R_z", "z of the centre of the rear wheel R", "m", "-rR"),
            FormulaInfo::attribute("F_mass", "the mass of the front wheel F", "kg", "mF"),
            FormulaInfo::attribute("F_radius", "the radius of the front wheel F", "m", "rF"),
            FormulaInfo::attribute("F_axial", "the axial inertia of the front wheel F", "kg*m^2", "IFyy"),
            FormulaInfo::attribute("F_radial", "the radial inertia of the front wheel F", "kg*m^2", "IFxx"),
            FormulaInfo::attribute("F_x", "x of the centre of the front wheel F", "m", "w"),
            FormulaInfo::attribute("F_z", "z of the centre of the front wheel F", "m", "-rF"),
            FormulaInfo::attribute("delta_through_x", "x of the point of the joint delta", "m", "w + c"),
            FormulaInfo::attribute("delta_along_x", "x of the axis of the joint delta", "1", "sin(lam)"),
            FormulaInfo::attribute("delta_along_z", "z of the axis of the joint delta", "1", "cos(lam)"),
            FormulaInfo::definition("length_delta", "1", "sqrt(delta_along_x^2 + delta_along_z^2)"),
            FormulaInfo::definition("pitch_by_vertical", "1/m", "1/F_x"),
            FormulaInfo::definition("yaw_by_phi", "1", "(F_radius + F_z)/F_x"),
            FormulaInfo::definition(
                "yaw_by_delta",
                "1",
                "-(delta_along_z*(F_x - delta_through_x) - delta_along_x*(F_radius + F_z))/F_x/length_delta",
            ),
            FormulaInfo::definition("yaw_per_v_delta", "1/m", "delta_along_z/F_x/length_delta"),
            FormulaInfo::definition("lateral_by_phi", "m", "R_radius + R_z"),
            FormulaInfo::definition("yaw_by_phi_", "1", "yaw_by_phi - pitch_by_vertical*lateral_by_phi"),
            FormulaInfo::definition("Jxx_delta", "kg*m^2", "H_mass*H_z^2 + H_Ixx + F_mass*F_z^2 + F_radial"),
            FormulaInfo::definition(
                "Jxz_delta",
                "kg*m^2",
                "H_Ixz - H_mass*H_z*(H_x - delta_through_x) - F_mass*F_z*(F_x - delta_through_x)",
            ),
            FormulaInfo::definition(
                "Jzz_delta",
                "kg*m^2",
                "H_mass*(H_x - delta_through_x)^2 + H_Izz + F_mass*(F_x - delta_through_x)^2 + F_radial",
            ),
            FormulaInfo::definition(
                "Sx_delta",
                "kg*m",
                "H_mass*(H_x - delta_through_x) + F_mass*(F_x - delta_through_x)",
            ),
            FormulaInfo::definition("Sz_delta", "kg*m", "H_mass*H_z + F_mass*F_z"),
            FormulaInfo::definition("m_delta", "kg", "H_mass + F_mass"),
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
            FormulaInfo::definition("Jxx_all", "kg*m^2", "B_mass*B_z^2 + B_Ixx + R_mass*R_z^2 + R_radial + Jxx_delta"),
            FormulaInfo::definition(
                "Jxz_all",
                "kg*m^2",
                "B_Ixz + Jxz_delta - B_mass*B_x*B_z - delta_through_x*Sz_delta",
            ),
            FormulaInfo::definition(
                "Jzz_all",
                "kg*m^2",
                "B_mass*B_x^2 + B_Izz + R_radial + 2*delta_through_x*((1/2)*delta_through_x*m_delta + Sx_delta) + Jzz_delta",
            ),
            FormulaInfo::definition("Sx_all", "kg*m", "B_mass*B_x + delta_through_x*m_delta + Sx_delta"),
            FormulaInfo::definition("Sz_all", "kg*m", "B_mass*B_z + R_mass*R_z + Sz_delta"),
            FormulaInfo::definition("m_all", "kg", "B_mass + R_mass + m_delta"),
            FormulaInfo::definition("load_spin_F", "kg", "-Sx_all/F_x"),
            FormulaInfo::definition("load_spin_R", "kg", "-(m_all + load_spin_F)"),
            FormulaInfo::definition("h_spin_R", "kg*m", "R_axial/R_radius"),
            FormulaInfo::definition("h_spin_F", "kg*m", "F_axial/F_radius"),
            FormulaInfo::definition("h_wheels_all", "kg*m", "h_spin_R + h_spin_F"),
            FormulaInfo::definition("M_yaw_delta", "kg*m^2", "delta_through_x*py_delta + hz_delta"),
            FormulaInfo::definition(
                "M_delta_delta",
                "kg*m^2",
                "(delta_along_x*hx_delta + delta_along_z*hz_delta)/length_delta",
            ),
            FormulaInfo::definition(
                "K_phi_phi",
                "kg*m",
                "Sz_all + load_spin_F*(F_radius + F_z) + load_spin_R*(R_radius + R_z)",
            ),
            FormulaInfo::definition(
                "K_phi_delta",
                "kg*m",
                "-py_delta - load_spin_F*(delta_along_z*(F_x - delta_through_x) - delta_along_x*(F_radius + F_z))/length_delta",
            ),
            FormulaInfo::definition(
                "K_delta_delta",
                "kg*m",
                "-delta_along_x*(length_delta*py_delta + load_spin_F*(delta_along_z*(F_x - delta_through_x) - delta_along_x*(F_radius + F_z)))/length_delta^2",
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
            FormulaInfo::entry(&[(MatrixName::C0, 1, 0)], "kg*m^2/s", "-kappa*vo"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 0)], "kg*m", "yaw_by_phi_*P_phi_lateral"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 1)],
                "kg*m",
                "(delta_along_z*h_spin_F + length_delta*yaw_by_delta*(h_wheels_all + P_phi_lateral) + length_delta*yaw_per_v_delta*P_phi_yaw - delta_along_x*yaw_by_phi_*h_spin_F)/length_delta",
            ),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 0)],
                "kg*m",
                "(kappa*length_delta + yaw_by_phi_*(delta_along_x*h_spin_F + length_delta*P_delta_lateral) - delta_along_z*h_spin_F - length_delta*yaw_by_delta*h_wheels_all)/length_delta",
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
                "yaw_per_v_delta*(delta_along_x*h_spin_F/length_delta + P_delta_lateral)",
            ),
        ],
        motion: None,
        gravity: Some(3),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("BalanceAssist", 28, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("BalanceAssist", 28, values)?;
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
        Coefficients::from_rows(BalanceAssistMatrices::rows(&self.matrices()))
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

impl BalanceAssist<f64> {
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
impl<T: Scalar> core::fmt::Display for BalanceAssist<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for BalanceAssist<T> {
    type Entries = [T; 12];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            w: parameter(0), c: parameter(1), lam: parameter(2), g: parameter(3), rR: parameter(4),
            mR: parameter(5), IRxx: parameter(6), IRyy: parameter(7), xB: parameter(8),
            zB: parameter(9), mB: parameter(10), IBxx: parameter(11), IByy: parameter(12),
            IBzz: parameter(13), IBxz: parameter(14), xH: parameter(15), zH: parameter(16),
            mH: parameter(17), IHxx: parameter(18), IHyy: parameter(19), IHzz: parameter(20),
            IHxz: parameter(21), rF: parameter(22), mF: parameter(23), IFxx: parameter(24),
            IFyy: parameter(25), kappa: parameter(26), vo: parameter(27),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        BalanceAssistMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        BalanceAssistMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> BalanceAssistDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<BalanceAssistMatrices<T>> {
        if parameter >= 28 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = BalanceAssistMatrices {
            m: Rows([[zero; 2]; 2]), c0: Rows([[zero; 2]; 2]), c1: Rows([[zero; 2]; 2]),
            k0: Rows([[zero; 2]; 2]), k2: Rows([[zero; 2]; 2]),
        };
        for position in 0..161 {
            let partial = <BalanceAssistDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C0 => &mut matrices.c0,
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

impl<T: Scalar> Differentiable<2> for BalanceAssist<T> {
    type Derivatives = [Coefficients<T, 2>; 28];

    type WithDerivativesOver<U: Number> = BalanceAssist<U>;

    const PARTIALS: &'static [Partial] = <BalanceAssistDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 28];
        for position in 0..161 {
            Partial::write(&<BalanceAssistDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(BalanceAssistMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for BalanceAssist<T> {
    type Derivatives = [T; 125];

    #[inline(always)]
    fn entries_and_derivatives(&self) -> ([T; 12], [T; 125]) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        (BalanceAssistMatrices::distinct_entries(&matrices), derivatives.values)
    }
}

impl BalanceAssistDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 161] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 0), Partial::new(MatrixName::M, 1, 0, 0, 0),
        Partial::new(MatrixName::M, 1, 1, 0, 1), Partial::new(MatrixName::C1, 0, 1, 0, 2),
        Partial::new(MatrixName::C1, 1, 0, 0, 3), Partial::new(MatrixName::C1, 1, 1, 0, 4),
        Partial::new(MatrixName::K0, 0, 1, 0, 5), Partial::new(MatrixName::K0, 1, 0, 0, 5),
        Partial::new(MatrixName::K0, 1, 1, 0, 6).negative(),
        Partial::new(MatrixName::K2, 0, 1, 0, 7).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 8),
        Partial::new(MatrixName::M, 0, 1, 1, 9).negative(),
        Partial::new(MatrixName::M, 1, 0, 1, 9).negative(),
        Partial::new(MatrixName::M, 1, 1, 1, 10), Partial::new(MatrixName::C1, 0, 1, 1, 11),
        Partial::new(MatrixName::C1, 1, 0, 1, 12).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 13).negative(),
        Partial::new(MatrixName::K0, 0, 1, 1, 14),
        Partial::new(MatrixName::K0, 1, 0, 1, 14),
        Partial::new(MatrixName::K0, 1, 1, 1, 15).negative(),
        Partial::new(MatrixName::K2, 1, 1, 1, 16),
        Partial::new(MatrixName::M, 0, 1, 2, 17).negative(),
        Partial::new(MatrixName::M, 1, 0, 2, 17).negative(),
        Partial::new(MatrixName::M, 1, 1, 2, 18),
        Partial::new(MatrixName::C1, 0, 1, 2, 19).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 20), Partial::new(MatrixName::C1, 1, 1, 2, 21),
        Partial::new(MatrixName::K0, 0, 1, 2, 22), Partial::new(MatrixName::K0, 1, 0, 2, 22),
        Partial::new(MatrixName::K0, 1, 1, 2, 23).negative(),
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
        Partial::new(MatrixName::M, 1, 1, 16, 73).negative(),
        Partial::new(MatrixName::C1, 0, 1, 16, 74).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 75).negative(),
        Partial::new(MatrixName::K0, 0, 0, 16, 76), Partial::new(MatrixName::K0, 0, 1, 16, 77),
        Partial::new(MatrixName::K0, 1, 0, 16, 77), Partial::new(MatrixName::K0, 1, 1, 16, 78),
        Partial::new(MatrixName::K2, 0, 1, 16, 79).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 80).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 81), Partial::new(MatrixName::M, 0, 1, 17, 82),
        Partial::new(MatrixName::M, 1, 0, 17, 82), Partial::new(MatrixName::M, 1, 1, 17, 83),
        Partial::new(MatrixName::C1, 0, 1, 17, 84).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 85), Partial::new(MatrixName::K0, 0, 0, 17, 86),
        Partial::new(MatrixName::K0, 0, 1, 17, 87), Partial::new(MatrixName::K0, 1, 0, 17, 87),
        Partial::new(MatrixName::K0, 1, 1, 17, 88),
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
        Partial::new(MatrixName::K2, 0, 1, 22, 107), Partial::new(MatrixName::K2, 1, 1, 22, 108),
        Partial::new(MatrixName::M, 0, 0, 23, 109), Partial::new(MatrixName::M, 0, 1, 23, 110),
        Partial::new(MatrixName::M, 1, 0, 23, 110), Partial::new(MatrixName::M, 1, 1, 23, 111),
        Partial::new(MatrixName::C1, 0, 1, 23, 112), Partial::new(MatrixName::C1, 1, 1, 23, 113),
        Partial::new(MatrixName::K0, 0, 0, 23, 114).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 115).negative(),
        Partial::new(MatrixName::K0, 1, 0, 23, 115).negative(),
        Partial::new(MatrixName::K0, 1, 1, 23, 116).negative(),
        Partial::new(MatrixName::K2, 0, 1, 23, 117), Partial::new(MatrixName::K2, 1, 1, 23, 118),
        Partial::new(MatrixName::M, 0, 0, 24, 35), Partial::new(MatrixName::M, 0, 1, 24, 91),
        Partial::new(MatrixName::M, 1, 0, 24, 91), Partial::new(MatrixName::M, 1, 1, 24, 119),
        Partial::new(MatrixName::C1, 1, 1, 24, 94), Partial::new(MatrixName::C1, 0, 1, 25, 120),
        Partial::new(MatrixName::C1, 1, 0, 25, 120).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 121),
        Partial::new(MatrixName::K2, 1, 1, 25, 122),
        Partial::new(MatrixName::C0, 1, 0, 26, 123).negative(),
        Partial::new(MatrixName::C1, 1, 0, 26, 35),
        Partial::new(MatrixName::C0, 1, 0, 27, 124).negative(),
    ];
}
