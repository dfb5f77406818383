// @generated from generated/models/whipple_sprung.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 578b2dd2541ebae4

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// The Whipple-Carvallo bicycle with a spring and a damper between rear frame and front frame.
///
/// Four rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally
/// symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,
/// x forward, y to the right, z down, so that a centre of mass above the ground has z < 0.
///
/// Source: Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3
///
/// Derived from a mechanism: body `B` (rear frame and rider), body `H` (front frame), wheel `R` (rear wheel), wheel `F` (front wheel).
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
/// yaw_per_v_delta = cos(lam)/w [1/m]
/// Jxx_delta = IHxx + IFxx + zH^2*mH + rF^2*mF [kg*m^2]
/// Jxz_delta = IHxz - c*rF*mF - zH*mH*(xH - (w + c)) [kg*m^2]
/// Jzz_delta = mH*(xH - (w + c))^2 + IHzz + IFxx + c^2*mF [kg*m^2]
/// Sx_delta = mH*(xH - (w + c)) - c*mF [kg*m]
/// Sz_delta = zH*mH - rF*mF [kg*m]
/// m_delta = mH + mF [kg]
/// py_delta = Sx_delta*cos(lam) - Sz_delta*sin(lam) [kg*m]
/// hx_delta = Jxx_delta*sin(lam) + Jxz_delta*cos(lam) [kg*m^2]
/// hz_delta = Jxz_delta*sin(lam) + Jzz_delta*cos(lam) [kg*m^2]
/// Jxx_all = IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB [kg*m^2]
/// Jxz_all = IBxz + Jxz_delta - xB*zB*mB - Sz_delta*(w + c) [kg*m^2]
/// Jzz_all = IRxx + IBzz + IHzz + IFxx + w^2*mF + xB^2*mB + xH^2*mH [kg*m^2]
/// Sx_all = xB*mB + Sx_delta + m_delta*(w + c) [kg*m]
/// Sz_all = zB*mB + Sz_delta - rR*mR [kg*m]
/// load_spin_F = -Sx_all/w [kg]
/// h_spin_R = IRyy/rR [kg*m]
/// h_spin_F = IFyy/rF [kg*m]
/// h_wheels_all = h_spin_R + h_spin_F [kg*m]
/// M_yaw_delta = py_delta*(w + c) + hz_delta [kg*m^2]
/// M_delta_delta = hx_delta*sin(lam) + hz_delta*cos(lam) [kg*m^2]
/// K_phi_delta = c*load_spin_F*cos(lam) - py_delta [kg*m]
/// K_delta_delta = (c*load_spin_F*cos(lam) - py_delta)*sin(lam) [kg*m]
/// P_delta_lateral = yaw_by_delta*Sx_all + py_delta [kg*m]
/// P_delta_yaw = yaw_by_delta*Jzz_all + M_yaw_delta [kg*m^2]
/// P_delta_delta = yaw_by_delta*M_yaw_delta + M_delta_delta [kg*m^2]
/// M_11 = Jxx_all [kg*m^2]
/// M_12 = M_21 = yaw_by_delta*Jxz_all + hx_delta [kg*m^2]
/// M_22 = yaw_by_delta*P_delta_yaw + P_delta_delta [kg*m^2]
/// C0_22 = d [kg*m^2/s]
/// C1_12 = yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_F*cos(lam) [kg*m]
/// C1_21 = -(yaw_by_delta*h_wheels_all + h_spin_F*cos(lam)) [kg*m]
/// C1_22 = yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
/// Kc_22 = k [kg*m^2/s^2]
/// K0_11 = Sz_all [kg*m]
/// K0_12 = K0_21 = K_phi_delta [kg*m]
/// K0_22 = K_delta_delta [kg*m]
/// K2_12 = yaw_per_v_delta*(h_wheels_all - Sz_all) [kg]
/// K2_22 = yaw_per_v_delta*(h_spin_F*sin(lam) + P_delta_lateral) [kg]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct WhippleSprung<T = f64> {
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
    /// Stiffness of the steering spring.
    ///
    /// `k` in `N*m`: `>= 0`.
    pub k: T,
    /// Damping of the steering damper.
    ///
    /// `d` in `N*m*s`: `>= 0`.
    pub d: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`WhippleSprung`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleSprungMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C0, a coefficient of q'. Symmetric, proved.
    pub c0: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness Kc, a coefficient of q. Symmetric, proved.
    pub kc: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 2>,
}

impl<T: Number> WhippleSprung<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 40 additions, 43 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 89 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleSprungMatrices<T> {
        let t2 = self.zH * self.mH;
        let t7 = self.zB * self.mB;
        let t13 = self.rR * self.mR;
        let t18 = self.rF * self.mF;
        let ay_delta2_delta = self.IHxx + self.IFxx;
        let t23 = self.rF * t18 + ay_delta2_delta;
        let M_11 = self.zH * t2 + (self.IRxx + self.zB * t7)
            + (self.rR * t13 + (self.IBxx + t23));
        let (wx_delta2_delta, cos_lam) = self.lam.sin_cos();
        let yaw_per_v_delta = cos_lam / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let wz_delta2_delta = cos_lam + yaw_by_delta;
        let t35 = self.IHxz * wz_delta2_delta;
        let t38 = t35 + wx_delta2_delta * t23;
        let t42 = self.IBxz - t7 * self.xB;
        let vy_spin_F4_delta = cos_lam * (self.c + self.w);
        let t51 = vy_spin_F4_delta
            + (self.zH * wx_delta2_delta - self.xH * wz_delta2_delta);
        let t52 = self.mH * t51;
        let M_12 = t38 + yaw_by_delta * t42 + self.zH * t52;
        let t57 = wz_delta2_delta * (self.IFxx + self.IHzz);
        let t60 = self.mB * self.xB;
        let t64 = yaw_by_delta * (self.IRxx + (self.IBzz + self.xB * t60));
        let M_22 = wz_delta2_delta * t57 + yaw_by_delta * t64
            + (t51 * t52 + wx_delta2_delta * (t38 + t35));
        let zero = self.w.like(0.0);
        let vy_all1_delta = t18 * wz_delta2_delta + yaw_per_v_delta * self.IHxz;
        let t78 = t7 + t2 - t13;
        let h_spin_R = self.IRyy / self.rR;
        let h_spin_F = self.IFyy / self.rF;
        let t91 = yaw_by_delta * h_spin_R + wz_delta2_delta * h_spin_F;
        let C1_12 = vy_all1_delta - yaw_per_v_delta * (self.c * t78 + t2 * self.xH - t42)
            + t91;
        let t96 = t52 - yaw_by_delta * t60;
        let h_wheels_all = (self.xH * t52 - t64 + self.c * t96 - t57) * yaw_per_v_delta;
        let K0_11 = t78 - t18;
        let K0_12 = t96 - t18 * wx_delta2_delta;
        let K0_22 = wx_delta2_delta * K0_12;
        let K2_12 = yaw_per_v_delta * (h_spin_R + h_spin_F - K0_11);
        let K2_22 = yaw_per_v_delta * (wx_delta2_delta * h_spin_F - K0_12);
        let C1_21 = -t91;
        let C1_22 = vy_all1_delta * wx_delta2_delta - h_wheels_all;
        WhippleSprungMatrices::from_entries([
            M_11, M_12, M_12, M_22, zero, zero, zero, self.d, zero, C1_12, C1_21, C1_22, zero, zero,
            zero, self.k, K0_11, K0_12, K0_12, K0_22, zero, K2_12, zero, K2_22,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`WhippleSprung`] that follow from its coordinates q = (`phi`, `delta`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleSprungKinematics<T = f64> {
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

impl<T: Scalar> WhippleSprung<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> WhippleSprungKinematics<T> {
        let zero = self.w.like(0.0);
        let yaw_per_v_delta = self.lam.cos() / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let t12 = -(self.w.like(1.0) / self.rR);
        let t13 = -(self.w.like(1.0) / self.rF);
        WhippleSprungKinematics {
            lateral: Rate {
                speed: zero, rates: [zero, zero], coordinates: [zero, zero],
                heading: self.w.like(1.0),
            },
            yaw: Rate {
                speed: zero, rates: [zero, yaw_by_delta], coordinates: [zero, yaw_per_v_delta],
                heading: zero,
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

/// The derivatives of the matrices of [`WhippleSprung`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleSprungDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 123],
}

impl<T: Number> WhippleSprung<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 100 additions, 182 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 289 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WhippleSprungMatrices<T>, WhippleSprungDerivatives<T>) {
        let M_11_mF = self.rF * self.rF;
        let t7 = self.mF * M_11_mF + self.IHxx + self.IFxx;
        let t11 = self.zB * self.mB;
        let t15 = self.zH * self.mH;
        let M_11_mR = self.rR * self.rR;
        let M_11 = t7 + self.IRxx + self.zB * t11 + self.zH * t15 + self.IBxx
            + self.mR * M_11_mR;
        let (wx_delta2_delta, wx_delta2_delta_lam) = self.lam.sin_cos();
        let t32 = self.w.like(1.0) / self.w;
        let yaw_per_v_delta = wx_delta2_delta_lam * t32;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let wz_delta2_delta = wx_delta2_delta_lam + yaw_by_delta;
        let t39 = self.IHxz * wz_delta2_delta + t7 * wx_delta2_delta;
        let t42 = self.mB * self.xB;
        let t44 = self.IBxz - self.zB * t42;
        let t48 = self.c * t32;
        let t52 = self.c + self.w - self.xH - self.xH * t48;
        let K0_12_mH = self.zH * wx_delta2_delta + wx_delta2_delta_lam * t52;
        let M_12 = t39 + yaw_by_delta * t44 + t15 * K0_12_mH;
        let t61 = self.IRxx + self.IBzz + self.xB * t42;
        let t62 = yaw_by_delta * t61;
        let t65 = self.IFxx + self.IHzz;
        let t67 = self.IHxz * wx_delta2_delta;
        let t68 = wz_delta2_delta * t65 + t67;
        let t70 = self.mH * K0_12_mH;
        let M_22 = yaw_by_delta * t62 + wz_delta2_delta * t68 + K0_12_mH * t70
            + wx_delta2_delta * t39;
        let zero = self.w.like(0.0);
        let t78 = self.mR * self.rR;
        let t79 = self.mF * self.rF;
        let K0_11 = t11 + t15 - t78 - t79;
        let M_12_yaw_by_delta = self.IHxz + t44;
        let t87 = t32 * (M_12_yaw_by_delta - t15 * self.xH);
        let t88 = wx_delta2_delta_lam * t87;
        let t90 = self.w.like(1.0) / self.rF;
        let h_spin_F = self.IFyy * t90;
        let t92 = wx_delta2_delta_lam * h_spin_F;
        let t94 = self.w.like(1.0) / self.rR;
        let h_spin_R = self.IRyy * t94;
        let t96 = h_spin_F + h_spin_R;
        let t97 = yaw_per_v_delta * t96;
        let t99 = t92 + self.c * t97;
        let t100 = wx_delta2_delta_lam * t79;
        let C1_12 = t88 + t99 + t100 - yaw_by_delta * K0_11;
        let t104 = wx_delta2_delta * t48;
        let t106 = wx_delta2_delta_lam * (wx_delta2_delta + t104);
        let t109 = self.xH * t70 - t68;
        let t112 = yaw_by_delta * t42;
        let t113 = t70 - t112;
        let t114 = yaw_per_v_delta * t61 - t113;
        let C1_22 = t79 * t106 + yaw_by_delta * t114 - yaw_per_v_delta * t109;
        let t119 = wx_delta2_delta * t79;
        let K0_12 = t113 - t119;
        let K0_22 = wx_delta2_delta * K0_12;
        let t122 = t96 - K0_11;
        let K2_12 = yaw_per_v_delta * t122;
        let t124 = wx_delta2_delta * h_spin_F;
        let t125 = K0_12 - t124;
        let t129 = yaw_per_v_delta * self.xH;
        let t131 = wx_delta2_delta_lam + t48 * t129;
        let M_12_w = t15 * t131 - t32 * yaw_by_delta * M_12_yaw_by_delta;
        let M_22_wz_delta2_delta = t68 + t68;
        let M_22_yaw_by_delta = t62 + t62 + M_22_wz_delta2_delta;
        let t137 = t48 * M_22_yaw_by_delta;
        let t139 = K0_12_mH + K0_12_mH;
        let t140 = self.mH * t131;
        let M_22_w = t139 * t140 - yaw_per_v_delta * t137;
        let t143 = t32 * t122;
        let t145 = t87 + self.c * t143;
        let t146 = yaw_per_v_delta * t145;
        let C1_21_w = t48 * t97;
        let t148 = yaw_by_delta + t129;
        let t149 = self.mH * t148;
        let C1_22_wz_delta2_delta = t119 + yaw_per_v_delta * t65;
        let t154 = t112 + t114 + C1_22_wz_delta2_delta;
        let t158 = t32 * (t109 - t62 - self.c * t154);
        let C1_22_w = yaw_per_v_delta * t158 - t131 * t149;
        let t161 = yaw_per_v_delta * t42;
        let vy_all1_delta = t48 * t161;
        let K0_12_w = t140 + vy_all1_delta;
        let K0_22_w = wx_delta2_delta * K0_12_w;
        let t165 = t32 * K2_12;
        let t166 = t32 * t125;
        let K2_22_w = yaw_per_v_delta * (t166 - K0_12_w);
        let t169 = t15 * wx_delta2_delta_lam;
        let M_12_c = t88 + t169;
        let t171 = wx_delta2_delta_lam - t129;
        let t172 = self.mH * t171;
        let M_22_c = t139 * t172 + yaw_per_v_delta * M_22_yaw_by_delta;
        let C1_22_c = yaw_per_v_delta * t154 - t149 * t171;
        let K0_12_c = t172 - t161;
        let K0_22_c = wx_delta2_delta * K0_12_c;
        let t181 = yaw_per_v_delta * K0_12_c;
        let K0_12_zH = self.mH * wx_delta2_delta;
        let t184 = t52 * K0_12_zH - t169;
        let M_12_lam = t7 * wx_delta2_delta_lam - t67 - self.zH * t184
            - M_12_yaw_by_delta * t104;
        let t193 = wx_delta2_delta_lam * t39;
        let M_22_lam = t193 + t193 - wx_delta2_delta * (M_22_wz_delta2_delta + t137)
            - t139 * t184;
        let t200 = t119 + t124 + wx_delta2_delta * t145;
        let C1_21_lam = t124 + t96 * t104;
        let C1_12_mF = self.rF * wz_delta2_delta;
        let C1_22_lam = wx_delta2_delta * (t158 - C1_22_wz_delta2_delta) + t148 * t184
            + wx_delta2_delta_lam * (self.IHxz * yaw_per_v_delta + self.mF * C1_12_mF);
        let t215 = t100 + t184 - t42 * t104;
        let K0_22_lam = wx_delta2_delta_lam * K0_12 - wx_delta2_delta * t215;
        let t219 = wx_delta2_delta * t143;
        let K2_22_lam = wx_delta2_delta * t166 + yaw_per_v_delta * (t92 + t215);
        let M_11_rR = t78 + t78;
        let t226 = self.mR - t94 * h_spin_R;
        let C1_12_rR = yaw_by_delta * t226;
        let K2_12_IRyy = yaw_per_v_delta * t94;
        let C1_12_IRyy = self.c * K2_12_IRyy;
        let C1_21_rR = h_spin_R * C1_12_IRyy;
        let K2_12_rR = yaw_per_v_delta * t226;
        let C1_12_mR = self.rR * yaw_by_delta;
        let K2_12_mR = self.rR * yaw_per_v_delta;
        let M_22_IRxx = yaw_by_delta * yaw_by_delta;
        let C1_22_IRxx = yaw_per_v_delta * yaw_by_delta;
        let t237 = t11 * yaw_by_delta;
        let C1_22_yaw_by_delta = yaw_by_delta * t112;
        let M_22_xB = C1_22_yaw_by_delta + C1_22_yaw_by_delta;
        let t240 = t11 * yaw_per_v_delta;
        let t241 = self.mB * yaw_by_delta;
        let t242 = t161 + t241;
        let C1_22_xB = yaw_by_delta * (t161 + t242);
        let t245 = wx_delta2_delta * t241;
        let K2_22_xB = yaw_per_v_delta * t241;
        let M_11_zB = t11 + t11;
        let t248 = self.mB * yaw_per_v_delta;
        let M_11_mB = self.zB * self.zB;
        let t250 = self.c * self.xB;
        let t251 = self.zB * yaw_per_v_delta;
        let t252 = t250 * t251;
        let K2_22_mB = self.xB * C1_22_IRxx;
        let M_22_mB = t250 * K2_22_mB;
        let t255 = self.c + self.xB;
        let t256 = t251 * t255;
        let C1_22_mB = K2_22_mB * t255;
        let t258 = yaw_by_delta * self.xB;
        let K2_22_h_spin_F = yaw_per_v_delta * wx_delta2_delta;
        let t260 = t250 * K2_22_h_spin_F;
        let t261 = t15 * wz_delta2_delta;
        let t262 = self.mH * wz_delta2_delta;
        let t263 = t139 * t262;
        let t264 = self.zH * yaw_per_v_delta;
        let t265 = self.mH * t264;
        let t267 = self.mH * yaw_per_v_delta;
        let C1_22_xH = wz_delta2_delta * t149 - K0_12_mH * t267;
        let t270 = self.mH * t106;
        let C1_22_IHzz = yaw_per_v_delta * wz_delta2_delta;
        let K2_22_xH = self.mH * C1_22_IHzz;
        let M_11_zH = t15 + t15;
        let M_12_zH = t70 + self.zH * K0_12_zH;
        let t276 = wx_delta2_delta * t70;
        let M_22_zH = t276 + t276;
        let t278 = t148 * K0_12_zH;
        let K0_22_zH = wx_delta2_delta * K0_12_zH;
        let t280 = yaw_per_v_delta * K0_12_zH;
        let M_11_mH = self.zH * self.zH;
        let M_12_mH = self.zH * K0_12_mH;
        let M_22_mH = K0_12_mH * K0_12_mH;
        let t284 = self.zH * t148;
        let t285 = K0_12_mH * t148;
        let K0_22_mH = wx_delta2_delta * K0_12_mH;
        let t287 = yaw_per_v_delta * K0_12_mH;
        let M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
        let M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
        let M_22_IHxz = t106 + t106;
        let M_11_rF = t79 + t79;
        let M_12_rF = t119 + t119;
        let M_22_rF = wx_delta2_delta * M_12_rF;
        let t295 = self.mF - t90 * h_spin_F;
        let C1_12_rF = wz_delta2_delta * t295;
        let C1_12_IFyy = wz_delta2_delta * t90;
        let C1_21_rF = h_spin_F * C1_12_IFyy;
        let t299 = self.mF * wx_delta2_delta;
        let C1_22_rF = wz_delta2_delta * t299;
        let t301 = self.mF * M_22_IHxx;
        let K2_12_rF = yaw_per_v_delta * t295;
        let K2_22_rF = K2_22_h_spin_F * t295;
        let M_12_mF = M_11_mF * wx_delta2_delta;
        let M_22_mF = wx_delta2_delta * M_12_mF;
        let t306 = self.rF * wx_delta2_delta;
        let C1_22_mF = wz_delta2_delta * t306;
        let t308 = wx_delta2_delta * t306;
        let K2_12_mF = self.rF * yaw_per_v_delta;
        let K2_22_mF = wx_delta2_delta * K2_12_mF;
        let M_22_IFxx = M_22_IHxx + M_22_IHzz;
        let K2_12_IFyy = yaw_per_v_delta * t90;
        let K2_22_IFyy = t90 * K2_22_h_spin_F;
        let C1_21 = -t99;
        let K2_22 = -(yaw_per_v_delta * t125);
        (
            WhippleSprungMatrices::from_entries([
                M_11, M_12, M_12, M_22, zero, zero, zero, self.d, zero, C1_12, C1_21, C1_22, zero,
                zero, zero, self.k, K0_11, K0_12, K0_12, K0_22, zero, K2_12, zero, K2_22,
            ]),
            WhippleSprungDerivatives {
                values: [
                    M_12_w, M_22_w, t146, C1_21_w, C1_22_w, K0_12_w, K0_22_w, t165, K2_22_w, M_12_c,
                    M_22_c, K2_12, t97, C1_22_c, K0_12_c, K0_22_c, t181, M_12_lam, M_22_lam, t200,
                    C1_21_lam, C1_22_lam, t215, K0_22_lam, t219, K2_22_lam, M_11_rR, C1_12_rR,
                    C1_21_rR, self.mR, K2_12_rR, M_11_mR, C1_12_mR, self.rR, K2_12_mR,
                    self.w.like(1.0), M_22_IRxx, C1_22_IRxx, C1_12_IRyy, K2_12_IRyy, t237, M_22_xB,
                    t240, C1_22_xB, t241, t245, K2_22_xB, M_11_zB, t112, t242, self.mB, t248,
                    M_11_mB, t252, M_22_mB, t256, C1_22_mB, self.zB, t258, t260, t251, K2_22_mB,
                    yaw_by_delta, yaw_per_v_delta, t261, t263, t265, C1_22_xH, t262, t270, K2_22_xH,
                    M_11_zH, M_12_zH, M_22_zH, t149, t278, self.mH, K0_12_zH, K0_22_zH, t267, t280,
                    M_11_mH, M_12_mH, M_22_mH, t284, t285, self.zH, K0_12_mH, K0_22_mH, t264, t287,
                    wx_delta2_delta, M_22_IHxx, M_22_IHzz, C1_22_IHzz, wz_delta2_delta, M_22_IHxz,
                    K2_22_h_spin_F, M_11_rF, M_12_rF, M_22_rF, C1_12_rF, C1_21_rF, C1_22_rF,
                    self.mF, t299, t301, K2_12_rF, K2_22_rF, M_11_mF, M_12_mF, M_22_mF, C1_12_mF,
                    C1_22_mF, self.rF, t306, t308, K2_12_mF, K2_22_mF, M_22_IFxx, C1_12_IFyy,
                    K2_12_IFyy, K2_22_IFyy,
                ],
            },
        )
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl WhippleSprung<f64> {
    /// The parameter set `benchmark`.
    ///
    /// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; spring and damper are examples
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
    /// | `k` | 0.5 | `N*m` |
    /// | `d` | 0.25 | `N*m*s` |
    pub const BENCHMARK: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3141592653589793, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.0603,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.05892, IHyy: 0.06, IHzz: 0.00708, IHxz: -0.00756,
        rF: 0.35, mF: 3.0, IFxx: 0.1405, IFyy: 0.28, k: 0.5, d: 0.25,
    };

    /// The parameter set `benchmark_2005`.
    ///
    /// Source: Schwab, Meijaard & Papadopoulos (2005), ENOC 2005; spring and damper are examples
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `w` | 1.02 | `m` |
    /// | `c` | 0.08 | `m` |
    /// | `lam` | 0.3217505543966422 | `rad` |
    /// | `g` | 9.81 | `N/kg` |
    /// | `rR` | 0.3 | `m` |
    /// | `mR` | 2 | `kg` |
    /// | `IRxx` | 0.06 | `kg*m^2` |
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
    /// | `IHxx` | 0.0546 | `kg*m^2` |
    /// | `IHyy` | 0.06 | `kg*m^2` |
    /// | `IHzz` | 0.0114 | `kg*m^2` |
    /// | `IHxz` | -0.0162 | `kg*m^2` |
    /// | `rF` | 0.35 | `m` |
    /// | `mF` | 3 | `kg` |
    /// | `IFxx` | 0.14 | `kg*m^2` |
    /// | `IFyy` | 0.28 | `kg*m^2` |
    /// | `k` | 0.5 | `N*m` |
    /// | `d` | 0.25 | `N*m*s` |
    pub const BENCHMARK_2005: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3217505543966422, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.06,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.0546, IHyy: 0.06, IHzz: 0.0114, IHxz: -0.0162, rF: 0.35,
        mF: 3.0, IFxx: 0.14, IFyy: 0.28, k: 0.5, d: 0.25,
    };
}

impl WhippleSprung<f64> {
    /// The parameter set `benchmark`.
    #[must_use]
    pub const fn default() -> Self {
        Self::BENCHMARK
    }
}

/// The parameter set `benchmark`.
impl<T: Scalar> Default for WhippleSprung<T> {
    fn default() -> Self {
        WhippleSprung::cast(&WhippleSprung::<f64>::BENCHMARK)
    }
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> WhippleSprung<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 28]) -> Self {
        Self {
            w: values[0], c: values[1], lam: values[2], g: values[3], rR: values[4], mR: values[5],
            IRxx: values[6], IRyy: values[7], xB: values[8], zB: values[9], mB: values[10],
            IBxx: values[11], IByy: values[12], IBzz: values[13], IBxz: values[14], xH: values[15],
            zH: values[16], mH: values[17], IHxx: values[18], IHyy: values[19], IHzz: values[20],
            IHxz: values[21], rF: values[22], mF: values[23], IFxx: values[24], IFyy: values[25],
            k: values[26], d: values[27],
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
            self.k, self.d,
        ]
    }
}

impl<T: Scalar> WhippleSprung<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> WhippleSprung<U> {
        let values = self.to_array();
        WhippleSprung::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl WhippleSprung<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> WhippleSprung<f32> {
        WhippleSprung::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<WhippleSprung<f32>> for WhippleSprung<f64> {
    fn from(parameters: WhippleSprung<f32>) -> Self {
        WhippleSprung::cast(&parameters)
    }
}

impl<T: Number> WhippleSprungMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 24]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c0: carvallo::rows(&entries, 4),
            c1: carvallo::rows(&entries, 8),
            kc: carvallo::rows(&entries, 12),
            k0: carvallo::rows(&entries, 16),
            k2: carvallo::rows(&entries, 20),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 13] {
        [
            self.m[0][0], self.m[0][1], self.m[1][1], self.c0[1][1], self.c1[0][1], self.c1[1][0],
            self.c1[1][1], self.kc[1][1], self.k0[0][0], self.k0[0][1], self.k0[1][1],
            self.k2[0][1], self.k2[1][1],
        ]
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, self.c0.0, self.c1.0, self.kc.0, self.k0.0, zeros, self.k2.0]
    }
}

impl<T: Scalar> From<WhippleSprungMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: WhippleSprungMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for WhippleSprung<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 28];

    type Over<U: Number> = WhippleSprung<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "WhippleSprung",
        docs: "The Whipple-Carvallo bicycle with a spring and a damper between rear frame and front frame.\n\nFour rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally\nsymmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,\nx forward, y to the right, z down, so that a centre of mass above the ground has z < 0.",
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
            ParameterInfo::new("k", "N*m", Domain::NONNEGATIVE)
                .docs("Stiffness of the steering spring."),
            ParameterInfo::new("d", "N*m*s", Domain::NONNEGATIVE)
                .docs("Damping of the steering damper."),
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
            MatrixName::M, MatrixName::C0, MatrixName::C1, MatrixName::Kc, MatrixName::K0,
            MatrixName::K2,
        ],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]), EntryInfo::at(&[(MatrixName::C0, 1, 1)]),
            EntryInfo::at(&[(MatrixName::C1, 0, 1)]), EntryInfo::at(&[(MatrixName::C1, 1, 0)]),
            EntryInfo::at(&[(MatrixName::C1, 1, 1)]), EntryInfo::at(&[(MatrixName::Kc, 1, 1)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 1, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 0, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 1, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "benchmark",
                docs: "",
                source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; spring and damper are examples",
                values: &WhippleSprung::to_array(&WhippleSprung::<f64>::BENCHMARK),
            },
            SetInfo {
                name: "benchmark_2005",
                docs: "",
                source: "Schwab, Meijaard & Papadopoulos (2005), ENOC 2005; spring and damper are examples",
                values: &WhippleSprung::to_array(&WhippleSprung::<f64>::BENCHMARK_2005),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("yaw_by_delta", "1", "c*cos(lam)/w"),
            FormulaInfo::definition("yaw_per_v_delta", "1/m", "cos(lam)/w"),
            FormulaInfo::definition("Jxx_delta", "kg*m^2", "IHxx + IFxx + zH^2*mH + rF^2*mF"),
            FormulaInfo::definition("Jxz_delta", "kg*m^2", "IHxz - c*rF*mF - zH*mH*(xH - (w + c))"),
            FormulaInfo::definition("Jzz_delta", "kg*m^2", "mH*(xH - (w + c))^2 + IHzz + IFxx + c^2*mF"),
            FormulaInfo::definition("Sx_delta", "kg*m", "mH*(xH - (w + c)) - c*mF"),
            FormulaInfo::definition("Sz_delta", "kg*m", "zH*mH - rF*mF"),
            FormulaInfo::definition("m_delta", "kg", "mH + mF"),
            FormulaInfo::definition("py_delta", "kg*m", "Sx_delta*cos(lam) - Sz_delta*sin(lam)"),
            FormulaInfo::definition("hx_delta", "kg*m^2", "Jxx_delta*sin(lam) + Jxz_delta*cos(lam)"),
            FormulaInfo::definition("hz_delta", "kg*m^2", "Jxz_delta*sin(lam) + Jzz_delta*cos(lam)"),
            FormulaInfo::definition("Jxx_all", "kg*m^2", "IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB"),
            FormulaInfo::definition("Jxz_all", "kg*m^2", "IBxz + Jxz_delta - xB*zB*mB - Sz_delta*(w + c)"),
            FormulaInfo::definition("Jzz_all", "kg*m^2", "IRxx + IBzz + IHzz + IFxx + w^2*mF + xB^2*mB + xH^2*mH"),
            FormulaInfo::definition("Sx_all", "kg*m", "xB*mB + Sx_delta + m_delta*(w + c)"),
            FormulaInfo::definition("Sz_all", "kg*m", "zB*mB + Sz_delta - rR*mR"),
            FormulaInfo::definition("load_spin_F", "kg", "-Sx_all/w"),
            FormulaInfo::definition("h_spin_R", "kg*m", "IRyy/rR"),
            FormulaInfo::definition("h_spin_F", "kg*m", "IFyy/rF"),
            FormulaInfo::definition("h_wheels_all", "kg*m", "h_spin_R + h_spin_F"),
            FormulaInfo::definition("M_yaw_delta", "kg*m^2", "py_delta*(w + c) + hz_delta"),
            FormulaInfo::definition("M_delta_delta", "kg*m^2", "hx_delta*sin(lam) + hz_delta*cos(lam)"),
            FormulaInfo::definition("K_phi_delta", "kg*m", "c*load_spin_F*cos(lam) - py_delta"),
            FormulaInfo::definition("K_delta_delta", "kg*m", "(c*load_spin_F*cos(lam) - py_delta)*sin(lam)"),
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
            FormulaInfo::entry(&[(MatrixName::C0, 1, 1)], "kg*m^2/s", "d"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 1)],
                "kg*m",
                "yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_F*cos(lam)",
            ),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 0)], "kg*m", "-(yaw_by_delta*h_wheels_all + h_spin_F*cos(lam))"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 1)],
                "kg*m",
                "yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw",
            ),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 1)], "kg*m^2/s^2", "k"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "Sz_all"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)], "kg*m", "K_phi_delta"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "K_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg", "yaw_per_v_delta*(h_wheels_all - Sz_all)"),
            FormulaInfo::entry(
                &[(MatrixName::K2, 1, 1)],
                "kg",
                "yaw_per_v_delta*(h_spin_F*sin(lam) + P_delta_lateral)",
            ),
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
            FormulaInfo::attribute("delta_spring", "the spring of the joint delta", "kg*m^2/s^2", "k"),
            FormulaInfo::attribute("delta_damper", "the damper of the joint delta", "kg*m^2/s", "d"),
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
            FormulaInfo::entry(&[(MatrixName::C0, 1, 1)], "kg*m^2/s", "delta_damper"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 0)], "kg*m", "yaw_by_phi_*P_phi_lateral"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 1)],
                "kg*m",
                "(delta_along_z*h_spin_F + length_delta*yaw_by_delta*(h_wheels_all + P_phi_lateral) + length_delta*yaw_per_v_delta*P_phi_yaw - delta_along_x*yaw_by_phi_*h_spin_F)/length_delta",
            ),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 0)],
                "kg*m",
                "(yaw_by_phi_*(delta_along_x*h_spin_F + length_delta*P_delta_lateral) - delta_along_z*h_spin_F - length_delta*yaw_by_delta*h_wheels_all)/length_delta",
            ),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 1)],
                "kg*m",
                "yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw",
            ),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 1)], "kg*m^2/s^2", "delta_spring"),
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
        LengthError::check("WhippleSprung", 28, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("WhippleSprung", 28, values)?;
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
        Coefficients::from_rows(WhippleSprungMatrices::rows(&self.matrices()))
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

impl WhippleSprung<f64> {
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
impl<T: Scalar> core::fmt::Display for WhippleSprung<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for WhippleSprung<T> {
    type Entries = [T; 13];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            w: parameter(0), c: parameter(1), lam: parameter(2), g: parameter(3), rR: parameter(4),
            mR: parameter(5), IRxx: parameter(6), IRyy: parameter(7), xB: parameter(8),
            zB: parameter(9), mB: parameter(10), IBxx: parameter(11), IByy: parameter(12),
            IBzz: parameter(13), IBxz: parameter(14), xH: parameter(15), zH: parameter(16),
            mH: parameter(17), IHxx: parameter(18), IHyy: parameter(19), IHzz: parameter(20),
            IHxz: parameter(21), rF: parameter(22), mF: parameter(23), IFxx: parameter(24),
            IFyy: parameter(25), k: parameter(26), d: parameter(27),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        WhippleSprungMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        WhippleSprungMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> WhippleSprungDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<WhippleSprungMatrices<T>> {
        if parameter >= 28 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = WhippleSprungMatrices {
            m: Rows([[zero; 2]; 2]), c0: Rows([[zero; 2]; 2]), c1: Rows([[zero; 2]; 2]),
            kc: Rows([[zero; 2]; 2]), k0: Rows([[zero; 2]; 2]), k2: Rows([[zero; 2]; 2]),
        };
        for position in 0..160 {
            let partial = <WhippleSprungDerivatives>::PARTIALS[position];
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
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<2> for WhippleSprung<T> {
    type Derivatives = [Coefficients<T, 2>; 28];

    type WithDerivativesOver<U: Number> = WhippleSprung<U>;

    const PARTIALS: &'static [Partial] = <WhippleSprungDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 28];
        for position in 0..160 {
            Partial::write(&<WhippleSprungDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(WhippleSprungMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for WhippleSprung<T> {
    type Derivatives = [T; 123];

    #[inline(always)]
    fn entries_and_derivatives(&self) -> ([T; 13], [T; 123]) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        (WhippleSprungMatrices::distinct_entries(&matrices), derivatives.values)
    }
}

impl WhippleSprungDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 160] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 0), Partial::new(MatrixName::M, 1, 0, 0, 0),
        Partial::new(MatrixName::M, 1, 1, 0, 1),
        Partial::new(MatrixName::C1, 0, 1, 0, 2).negative(),
        Partial::new(MatrixName::C1, 1, 0, 0, 3), Partial::new(MatrixName::C1, 1, 1, 0, 4),
        Partial::new(MatrixName::K0, 0, 1, 0, 5), Partial::new(MatrixName::K0, 1, 0, 0, 5),
        Partial::new(MatrixName::K0, 1, 1, 0, 6),
        Partial::new(MatrixName::K2, 0, 1, 0, 7).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 8), Partial::new(MatrixName::M, 0, 1, 1, 9),
        Partial::new(MatrixName::M, 1, 0, 1, 9), Partial::new(MatrixName::M, 1, 1, 1, 10),
        Partial::new(MatrixName::C1, 0, 1, 1, 11),
        Partial::new(MatrixName::C1, 1, 0, 1, 12).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 13), Partial::new(MatrixName::K0, 0, 1, 1, 14),
        Partial::new(MatrixName::K0, 1, 0, 1, 14), Partial::new(MatrixName::K0, 1, 1, 1, 15),
        Partial::new(MatrixName::K2, 1, 1, 1, 16).negative(),
        Partial::new(MatrixName::M, 0, 1, 2, 17),
        Partial::new(MatrixName::M, 1, 0, 2, 17),
        Partial::new(MatrixName::M, 1, 1, 2, 18),
        Partial::new(MatrixName::C1, 0, 1, 2, 19).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 20),
        Partial::new(MatrixName::C1, 1, 1, 2, 21),
        Partial::new(MatrixName::K0, 0, 1, 2, 22).negative(),
        Partial::new(MatrixName::K0, 1, 0, 2, 22).negative(),
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
        Partial::new(MatrixName::M, 1, 1, 16, 73),
        Partial::new(MatrixName::C1, 0, 1, 16, 74).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 75).negative(),
        Partial::new(MatrixName::K0, 0, 0, 16, 76), Partial::new(MatrixName::K0, 0, 1, 16, 77),
        Partial::new(MatrixName::K0, 1, 0, 16, 77), Partial::new(MatrixName::K0, 1, 1, 16, 78),
        Partial::new(MatrixName::K2, 0, 1, 16, 79).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 80).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 81), Partial::new(MatrixName::M, 0, 1, 17, 82),
        Partial::new(MatrixName::M, 1, 0, 17, 82), Partial::new(MatrixName::M, 1, 1, 17, 83),
        Partial::new(MatrixName::C1, 0, 1, 17, 84).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 85).negative(),
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
        Partial::new(MatrixName::K2, 0, 1, 25, 121), Partial::new(MatrixName::K2, 1, 1, 25, 122),
        Partial::new(MatrixName::Kc, 1, 1, 26, 35), Partial::new(MatrixName::C0, 1, 1, 27, 35),
    ];
}
