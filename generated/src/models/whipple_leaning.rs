// @generated from generated/models/whipple_leaning.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 40e1047ae9981d57

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    FormulaInfo, LengthError, MatrixName, Model, ModelInfo, Number, ParameterError,
    ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo, WithDerivatives,
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
/// The fields are the parameters. The coordinates are `phi` (lean) in `rad`, `delta` (steer) in `rad`, `theta` (upper body) in `rad`.
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
/// Jxx_theta = mU*(zU - zP)^2 + IUxx [kg*m^2]
/// Jxz_theta = IUxz - mU*xU*(zU - zP) [kg*m^2]
/// Jzz_theta = mU*xU^2 + IUzz [kg*m^2]
/// Sx_theta = mU*xU [kg*m]
/// Sz_theta = mU*(zU - zP) [kg*m]
/// Jxx_delta = IHxx + IFxx + zH^2*mH + rF^2*mF [kg*m^2]
/// Jxz_delta = IHxz - c*rF*mF - zH*mH*(xH - (w + c)) [kg*m^2]
/// Jzz_delta = mH*(xH - (w + c))^2 + IHzz + IFxx + c^2*mF [kg*m^2]
/// Sx_delta = mH*(xH - (w + c)) - c*mF [kg*m]
/// Sz_delta = zH*mH - rF*mF [kg*m]
/// m_delta = mH + mF [kg]
/// py_delta = Sx_delta*cos(lam) - Sz_delta*sin(lam) [kg*m]
/// hx_delta = Jxx_delta*sin(lam) + Jxz_delta*cos(lam) [kg*m^2]
/// hz_delta = Jxz_delta*sin(lam) + Jzz_delta*cos(lam) [kg*m^2]
/// Jxx_all = IRxx + IBxx + 2*zP*((1/2)*zP*mU + Sz_theta) + Jxx_theta + Jxx_delta + rR^2*mR + zB^2*mB [kg*m^2]
/// Jxz_all = IBxz + Jxz_theta + Jxz_delta - xB*zB*mB - zP*Sx_theta - Sz_delta*(w + c) [kg*m^2]
/// Jzz_all = IRxx + IBzz + IHzz + IFxx + Jzz_theta + w^2*mF + xB^2*mB + xH^2*mH [kg*m^2]
/// Sx_all = xB*mB + Sx_theta + Sx_delta + m_delta*(w + c) [kg*m]
/// Sz_all = zB*mB + zP*mU + Sz_theta + Sz_delta - rR*mR [kg*m]
/// load_spin_F = -Sx_all/w [kg]
/// h_spin_R = IRyy/rR [kg*m]
/// h_spin_F = IFyy/rF [kg*m]
/// h_wheels_all = h_spin_R + h_spin_F [kg*m]
/// M_yaw_delta = py_delta*(w + c) + hz_delta [kg*m^2]
/// M_phi_theta = zP*Sz_theta + Jxx_theta [kg*m^2]
/// M_delta_delta = hx_delta*sin(lam) + hz_delta*cos(lam) [kg*m^2]
/// K_phi_delta = c*load_spin_F*cos(lam) - py_delta [kg*m]
/// K_delta_delta = (c*load_spin_F*cos(lam) - py_delta)*sin(lam) [kg*m]
/// P_delta_lateral = yaw_by_delta*Sx_all + py_delta [kg*m]
/// P_delta_yaw = yaw_by_delta*Jzz_all + M_yaw_delta [kg*m^2]
/// P_delta_delta = yaw_by_delta*M_yaw_delta + M_delta_delta [kg*m^2]
/// P_delta_theta = yaw_by_delta*Jxz_theta [kg*m^2]
/// M_11 = Jxx_all [kg*m^2]
/// M_12 = M_21 = yaw_by_delta*Jxz_all + hx_delta [kg*m^2]
/// M_13 = M_31 = M_phi_theta [kg*m^2]
/// M_22 = yaw_by_delta*P_delta_yaw + P_delta_delta [kg*m^2]
/// M_23 = M_32 = P_delta_theta [kg*m^2]
/// M_33 = Jxx_theta [kg*m^2]
/// C0_33 = dU [kg*m^2/s]
/// C1_12 = yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_F*cos(lam) [kg*m]
/// C1_21 = -(yaw_by_delta*h_wheels_all + h_spin_F*cos(lam)) [kg*m]
/// C1_22 = yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
/// C1_32 = yaw_per_v_delta*Jxz_theta - yaw_by_delta*Sz_theta [kg*m]
/// Kc_33 = kU [kg*m^2/s^2]
/// K0_11 = Sz_all [kg*m]
/// K0_12 = K0_21 = K_phi_delta [kg*m]
/// K0_13 = K0_31 = K0_33 = Sz_theta [kg*m]
/// K0_22 = K_delta_delta [kg*m]
/// K2_12 = yaw_per_v_delta*(h_wheels_all - Sz_all) [kg]
/// K2_22 = yaw_per_v_delta*(h_spin_F*sin(lam) + P_delta_lateral) [kg]
/// K2_32 = -yaw_per_v_delta*Sz_theta [kg]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct WhippleLeaning<T = f64> {
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
    /// Height of the rider's hip axis, downward from the ground, so negative.
    ///
    /// `zP` in `m`: any finite value.
    pub zP: T,
    /// Mass of the rider's upper body.
    ///
    /// `mU` in `kg`: `>= 0`.
    pub mU: T,
    /// Centre of mass of the upper body, forward of the rear contact.
    ///
    /// `xU` in `m`: any finite value.
    pub xU: T,
    /// Centre of mass of the upper body, downward.
    ///
    /// `zU` in `m`: any finite value.
    pub zU: T,
    /// Moment of inertia of the upper body about its centre of mass, in roll.
    ///
    /// `IUxx` in `kg*m^2`: `>= 0`.
    pub IUxx: T,
    /// Moment of inertia of the upper body about its centre of mass, in pitch.
    ///
    /// `IUyy` in `kg*m^2`: `>= 0`. No matrix depends on it.
    pub IUyy: T,
    /// Moment of inertia of the upper body about its centre of mass, in yaw.
    ///
    /// `IUzz` in `kg*m^2`: `>= 0`.
    pub IUzz: T,
    /// Product of inertia of the upper body about its centre of mass.
    ///
    /// `IUxz` in `kg*m^2`: any finite value.
    pub IUxz: T,
    /// Stiffness of the hip.
    ///
    /// `kU` in `N*m`: `>= 0`.
    pub kU: T,
    /// Damping of the hip.
    ///
    /// `dU` in `N*m*s`: `>= 0`.
    pub dU: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`WhippleLeaning`], each 3 x 3 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleLeaningMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 3>,
    /// Damping C0, a coefficient of q'. Symmetric, proved.
    pub c0: Rows<T, 3>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 3>,
    /// Stiffness Kc, a coefficient of q. Symmetric, proved.
    pub kc: Rows<T, 3>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 3>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 3>,
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
        let M_11 = self.IRxx + self.IBxx + Jxx_theta + Jxx_delta + self.rR * t25
            + self.zB * t29 + self.zP * (Sz_theta + t32);
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t49 = self.c + self.w;
        let t50 = t49 - self.xH;
        let Jxz_delta = self.IHxz + t14 * t50 - t18 * self.c;
        let hx_delta = Jxx_delta * sin_lam + Jxz_delta * cos_lam;
        let yaw_per_v_delta = cos_lam / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let Sx_theta = self.mU * self.xU;
        let Jxz_theta = self.IUxz - t5 * Sx_theta;
        let Sz_delta = t14 - t18;
        let Jxz_all = Jxz_delta + self.IBxz + Jxz_theta - t29 * self.xB
            - self.zP * Sx_theta - t49 * Sz_delta;
        let M_12 = hx_delta + yaw_by_delta * Jxz_all;
        let M_phi_theta = Jxx_theta + self.zP * Sz_theta;
        let t80 = self.mH * t50;
        let t82 = self.mF * self.c;
        let t85 = self.IFxx + self.IHzz;
        let hz_delta = sin_lam * Jxz_delta + cos_lam * (t50 * t80 + self.c * t82 + t85);
        let t91 = t80 + t82;
        let t93 = sin_lam * Sz_delta + cos_lam * t91;
        let M_yaw_delta = hz_delta - t49 * t93;
        let t98 = self.mB * self.xB;
        let t110 = self.IRxx + t85 + self.IBzz + self.IUzz + self.xB * t98
            + self.mH * self.xH * self.xH + self.mF * self.w * self.w;
        let P_delta_yaw = M_yaw_delta + yaw_by_delta * (t110 + self.xU * Sx_theta);
        let M_22 = yaw_by_delta * (M_yaw_delta + P_delta_yaw) + sin_lam * hx_delta
            + cos_lam * hz_delta;
        let P_delta_theta = yaw_by_delta * Jxz_theta;
        let zero = self.w.like(0.0);
        let h_spin_F = self.IFyy / self.rF;
        let h_wheels_all = h_spin_F + self.IRyy / self.rR;
        let Sz_all = t29 + t32 + Sz_delta - t25;
        let t131 = h_wheels_all - Sz_all;
        let t134 = cos_lam * h_spin_F;
        let C1_12 = yaw_by_delta * t131 + yaw_per_v_delta * Jxz_all + t134;
        let Sx_all = Sx_theta + t98 + t49 * (self.mH + self.mF) - t91;
        let t144 = yaw_by_delta * Sx_all;
        let P_delta_lateral = t144 - t93;
        let C1_22 = yaw_by_delta * P_delta_lateral + yaw_per_v_delta * P_delta_yaw;
        let C1_32 = yaw_per_v_delta * Jxz_theta - Sz_theta * yaw_by_delta;
        let K2_12 = yaw_per_v_delta * t131;
        let K2_22 = yaw_per_v_delta * (P_delta_lateral + sin_lam * h_spin_F);
        let C1_21 = -(t134 + yaw_by_delta * h_wheels_all);
        let K0_12 = t93 - t144;
        let K0_22 = -(sin_lam * P_delta_lateral);
        let K2_32 = -(Sz_theta * yaw_per_v_delta);
        WhippleLeaningMatrices::from_entries([
            M_11, M_12, M_phi_theta, M_12, M_22, P_delta_theta, M_phi_theta, P_delta_theta,
            Jxx_theta, zero, zero, zero, zero, zero, zero, zero, zero, self.dU, zero, C1_12, zero,
            C1_21, C1_22, zero, zero, C1_32, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            self.kU, Sz_all, K0_12, Sz_theta, K0_12, K0_22, zero, Sz_theta, zero, Sz_theta, zero,
            K2_12, zero, zero, K2_22, zero, zero, K2_32, zero,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`WhippleLeaning`] that follow from its coordinates q = (`phi`, `delta`, `theta`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleLeaningKinematics<T = f64> {
    /// Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin.
    pub lateral: Rate<T, 3>,
    /// Yaw rate, to the right, in `rad/s`: of `B`.
    pub yaw: Rate<T, 3>,
    /// Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_R: Rate<T, 3>,
    /// Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_F: Rate<T, 3>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate,
    /// a column for each of `Tphi` (lean torque) in `N*m`, `Tdelta` (steer torque) in `N*m`, `Ttheta` (hip torque) in `N*m`.
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
        let zero = self.w.like(0.0);
        let yaw_per_v_delta = self.lam.cos() / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let t12 = -(self.w.like(1.0) / self.rR);
        let t13 = -(self.w.like(1.0) / self.rF);
        WhippleLeaningKinematics {
            lateral: Rate {
                speed: zero, rates: [zero, zero, zero], coordinates: [zero, zero, zero],
                heading: self.w.like(1.0),
            },
            yaw: Rate {
                speed: zero, rates: [zero, yaw_by_delta, zero],
                coordinates: [zero, yaw_per_v_delta, zero], heading: zero,
            },
            wheel_R: Rate {
                speed: t12, rates: [zero, zero, zero], coordinates: [zero, zero, zero],
                heading: zero,
            },
            wheel_F: Rate {
                speed: t13, rates: [zero, zero, zero], coordinates: [zero, zero, zero],
                heading: zero,
            },
            forces: [
                [self.w.like(1.0), zero, zero],
                [zero, self.w.like(1.0), zero],
                [zero, zero, self.w.like(1.0)],
            ],
        }
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`WhippleLeaning`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
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
            K0_13_mU, Sz_theta, Jxx_theta, t14, t18, Jxx_delta, t25, t29, t31, t32, M_11, sin_lam,
            cos_lam, t48, t50, Jxz_delta, t55, hx_delta, t57, yaw_per_v_delta, yaw_by_delta,
            Sx_theta, Jxz_theta, Sz_delta, Jxz_all, M_12, M_phi_theta, t81, t83, t84, t86, t89,
            hz_delta, t94, t96, M_yaw_delta, t101, t103, t105, t113, P_delta_yaw_yaw_by_delta, t115,
            P_delta_yaw, t117, M_22, P_delta_theta, zero, t125, h_spin_F, t127, t129, t130,
            h_wheels_all, Sz_all, t135, t137, C1_12, Sx_all, K0_12, C1_22, M_23_c, C1_32, K0_22,
            K2_12, t158, K2_22_yaw_per_v_delta, K2_22, t161, C1_12_h_spin_F, t163, t165, t166,
            M_12_yaw_per_v_delta, M_12_w, t170, M_22_Jxz_delta, t173, t176, t178, t179, t180, t181,
            t182, t183, M_yaw_delta_w, t185, P_delta_yaw_w, t188, M_22_yaw_by_delta,
            M_22_yaw_per_v_delta, M_22_w, P_delta_theta_yaw_per_v_delta, t197, t198, t200,
            C1_12_yaw_per_v_delta, C1_12_w, t205, C1_21_w, t209, K0_12_w, C1_22_yaw_by_delta,
            C1_22_yaw_per_v_delta, C1_22_w, C1_32_yaw_per_v_delta, t223, K0_22_w, t225, t228,
            K2_32_w, M_12_c, t234, hz_delta_c, t238, t240, M_yaw_delta_c, M_22_c, C1_12_c, t255,
            K0_12_c, C1_22_c, K0_22_c, t263, hx_delta_lam, t266, M_12_lam, hz_delta_lam, t273,
            M_yaw_delta_lam, M_22_lam, t287, t289, C1_21_lam, K0_12_lam, C1_22_lam, t299, K0_22_lam,
            t303, K2_22_lam, K2_32_lam, M_11_rR, t310, t311, C1_12_rR, C1_21_rR, K2_12_rR, M_11_mR,
            C1_12_mR, K2_12_mR, M_22_IRxx, C1_22_IRxx, C1_12_IRyy, K2_12_IRyy, t323, t324, t325,
            P_delta_yaw_xB, M_22_xB, t329, t331, C1_22_xB, t334, K2_22_xB, M_11_zB, t338, t339,
            t340, M_11_mB, t342, P_delta_yaw_mB, M_22_mB, t345, C1_22_mB, t349, t350, K2_22_mB,
            M_yaw_delta_xH, P_delta_yaw_xH, t355, M_22_xH, P_delta_lateral_xH, C1_22_xH, t364,
            K2_22_xH, M_11_zH, t367, t369, t371, M_12_zH, K0_12_zH, t376, M_yaw_delta_zH,
            M_22_Jxx_delta, t383, M_22_zH, t389, t391, C1_12_zH, C1_22_zH, K0_22_zH, t397, t398,
            M_11_mH, M_12_mH, hz_delta_mH, t404, M_yaw_delta_mH, P_delta_yaw_mH, t410, M_22_mH,
            C1_12_mH, K0_12_mH, C1_22_mH, K0_22_mH, t423, t424, M_22_IHzz, C1_22_IHzz, M_22_IHxz,
            K2_22_h_spin_F, M_11_rF, t436, t438, M_12_rF, t441, t443, M_yaw_delta_rF, t449, M_22_rF,
            t454, t456, C1_21_rF, C1_12_rF, C1_22_rF, t462, K2_12_rF, K2_22_rF, M_11_mF, M_12_mF,
            hz_delta_mF, t473, M_yaw_delta_mF, P_delta_yaw_mF, t479, M_22_mF, C1_12_mF, K0_12_mF,
            C1_22_mF, K0_22_mF, K2_12_mF, t493,
        );
        K0_13_mU = self.zU - self.zP;
        Sz_theta = K0_13_mU * self.mU;
        Jxx_theta = self.IUxx + K0_13_mU * Sz_theta;
        t14 = self.zH * self.mH;
        t18 = self.rF * self.mF;
        Jxx_delta = self.IHxx + self.IFxx + self.zH * t14 + self.rF * t18;
        t25 = self.rR * self.mR;
        t29 = self.zB * self.mB;
        t31 = self.zP * self.mU;
        t32 = Sz_theta + t31;
        M_11 = self.IRxx + self.IBxx + Jxx_theta + Jxx_delta + self.rR * t25
            + self.zB * t29 + self.zP * (Sz_theta + t32);
        (sin_lam, cos_lam) = self.lam.sin_cos();
        t48 = self.c + self.w;
        t50 = t48 - self.xH;
        Jxz_delta = self.IHxz + t14 * t50 - t18 * self.c;
        t55 = Jxz_delta * cos_lam;
        hx_delta = Jxx_delta * sin_lam + t55;
        t57 = self.w.like(1.0) / self.w;
        yaw_per_v_delta = cos_lam * t57;
        yaw_by_delta = self.c * yaw_per_v_delta;
        Sx_theta = self.mU * self.xU;
        Jxz_theta = self.IUxz - K0_13_mU * Sx_theta;
        Sz_delta = t14 - t18;
        Jxz_all = Jxz_delta + self.IBxz + Jxz_theta - t29 * self.xB - self.zP * Sx_theta
            - t48 * Sz_delta;
        M_12 = hx_delta + yaw_by_delta * Jxz_all;
        M_phi_theta = Jxx_theta + self.zP * Sz_theta;
        t81 = sin_lam * Jxz_delta;
        t83 = self.IFxx + self.IHzz;
        t84 = self.mF * self.c;
        t86 = self.mH * t50;
        t89 = t83 + self.c * t84 + t50 * t86;
        hz_delta = t81 + cos_lam * t89;
        t94 = t84 + t86;
        t96 = sin_lam * Sz_delta + cos_lam * t94;
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
        M_22 = sin_lam * hx_delta + cos_lam * hz_delta + yaw_by_delta * t117;
        P_delta_theta = yaw_by_delta * Jxz_theta;
        zero = self.w.like(0.0);
        t125 = self.w.like(1.0) / self.rF;
        h_spin_F = self.IFyy * t125;
        t127 = cos_lam * h_spin_F;
        t129 = self.w.like(1.0) / self.rR;
        t130 = self.IRyy * t129;
        h_wheels_all = h_spin_F + t130;
        Sz_all = t29 + t32 + Sz_delta - t25;
        t135 = h_wheels_all - Sz_all;
        t137 = yaw_per_v_delta * Jxz_all;
        C1_12 = t127 + yaw_by_delta * t135 + t137;
        Sx_all = Sx_theta + t101 + t48 * (self.mH + self.mF) - t94;
        K0_12 = t96 - yaw_by_delta * Sx_all;
        C1_22 = yaw_per_v_delta * P_delta_yaw - yaw_by_delta * K0_12;
        M_23_c = yaw_per_v_delta * Jxz_theta;
        C1_32 = M_23_c - Sz_theta * yaw_by_delta;
        K0_22 = sin_lam * K0_12;
        K2_12 = yaw_per_v_delta * t135;
        t158 = sin_lam * h_spin_F;
        K2_22_yaw_per_v_delta = t158 - K0_12;
        K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
        t161 = Sz_theta * yaw_per_v_delta;
        C1_12_h_spin_F = cos_lam + yaw_by_delta;
        t163 = t14 * C1_12_h_spin_F;
        t165 = t163 - yaw_by_delta * Sz_delta;
        t166 = t57 * yaw_per_v_delta;
        M_12_yaw_per_v_delta = self.c * Jxz_all;
        M_12_w = t165 - t166 * M_12_yaw_per_v_delta;
        t170 = sin_lam * cos_lam;
        M_22_Jxz_delta = t170 + t170;
        t173 = t50 * cos_lam;
        t176 = self.mH * t173 + cos_lam * t86;
        t178 = t14 * M_22_Jxz_delta + cos_lam * t176;
        t179 = t14 * sin_lam;
        t180 = t176 + t179;
        t181 = t180 - t96;
        t182 = self.mH * cos_lam;
        t183 = t48 * t182;
        M_yaw_delta_w = t181 - t183;
        t185 = yaw_by_delta + yaw_by_delta;
        P_delta_yaw_w = self.mF * self.w * t185;
        t188 = M_yaw_delta_w + P_delta_yaw_w;
        M_22_yaw_by_delta = t115 + t117;
        M_22_yaw_per_v_delta = self.c * M_22_yaw_by_delta;
        M_22_w = t178 + yaw_by_delta * (M_yaw_delta_w + t188)
            - t166 * M_22_yaw_per_v_delta;
        P_delta_theta_yaw_per_v_delta = self.c * Jxz_theta;
        t197 = t166 * P_delta_theta_yaw_per_v_delta;
        t198 = t14 * yaw_per_v_delta;
        t200 = t198 - yaw_per_v_delta * Sz_delta;
        C1_12_yaw_per_v_delta = Jxz_all + self.c * t135;
        C1_12_w = t200 - t166 * C1_12_yaw_per_v_delta;
        t205 = self.c * h_wheels_all;
        C1_21_w = t166 * t205;
        t209 = self.c * Sx_all;
        K0_12_w = t182 + t166 * t209 - self.mF * yaw_by_delta;
        C1_22_yaw_by_delta = yaw_per_v_delta * P_delta_yaw_yaw_by_delta - K0_12;
        C1_22_yaw_per_v_delta = P_delta_yaw + self.c * C1_22_yaw_by_delta;
        C1_22_w = yaw_per_v_delta * t188 - yaw_by_delta * K0_12_w
            - t166 * C1_22_yaw_per_v_delta;
        C1_32_yaw_per_v_delta = Jxz_theta - Sz_theta * self.c;
        t223 = t166 * C1_32_yaw_per_v_delta;
        K0_22_w = sin_lam * K0_12_w;
        t225 = t135 * t166;
        t228 = yaw_per_v_delta * K0_12_w + K2_22_yaw_per_v_delta * t166;
        K2_32_w = Sz_theta * t166;
        M_12_c = t137 + t165 - t18 * C1_12_h_spin_F;
        t234 = self.c * cos_lam;
        hz_delta_c = self.mF * t234 + cos_lam * t84;
        t238 = t18 * sin_lam;
        t240 = t182 + self.mF * cos_lam;
        M_yaw_delta_c = t181 + hz_delta_c - t238 - t48 * t240;
        M_22_c = t178 + t185 * M_yaw_delta_c + cos_lam * hz_delta_c
            + yaw_per_v_delta * M_22_yaw_by_delta - t18 * M_22_Jxz_delta;
        C1_12_c = t200 + yaw_per_v_delta * (t135 - t18);
        t255 = yaw_per_v_delta * h_wheels_all;
        K0_12_c = t240 - yaw_per_v_delta * Sx_all;
        C1_22_c = yaw_per_v_delta * (C1_22_yaw_by_delta + M_yaw_delta_c)
            - yaw_by_delta * K0_12_c;
        K0_22_c = sin_lam * K0_12_c;
        t263 = yaw_per_v_delta * K0_12_c;
        hx_delta_lam = Jxx_delta * cos_lam - t81;
        t266 = sin_lam * t57;
        M_12_lam = hx_delta_lam - M_12_yaw_per_v_delta * t266;
        hz_delta_lam = t55 - sin_lam * t89;
        t273 = cos_lam * Sz_delta - sin_lam * t94;
        M_yaw_delta_lam = hz_delta_lam - t48 * t273;
        M_22_lam = t185 * M_yaw_delta_lam + sin_lam * hx_delta_lam
            + cos_lam * hz_delta_lam + cos_lam * hx_delta - sin_lam * hz_delta
            - M_22_yaw_per_v_delta * t266;
        t287 = P_delta_theta_yaw_per_v_delta * t266;
        t289 = t158 + C1_12_yaw_per_v_delta * t266;
        C1_21_lam = t158 + t205 * t266;
        K0_12_lam = t273 + t209 * t266;
        C1_22_lam = yaw_per_v_delta * M_yaw_delta_lam - yaw_by_delta * K0_12_lam
            - C1_22_yaw_per_v_delta * t266;
        t299 = C1_32_yaw_per_v_delta * t266;
        K0_22_lam = sin_lam * K0_12_lam + cos_lam * K0_12;
        t303 = t135 * t266;
        K2_22_lam = yaw_per_v_delta * (t127 - K0_12_lam) - K2_22_yaw_per_v_delta * t266;
        K2_32_lam = Sz_theta * t266;
        M_11_rR = t25 + t25;
        t310 = t129 * t130;
        t311 = self.mR - t310;
        C1_12_rR = yaw_by_delta * t311;
        C1_21_rR = yaw_by_delta * t310;
        K2_12_rR = yaw_per_v_delta * t311;
        M_11_mR = self.rR * self.rR;
        C1_12_mR = self.rR * yaw_by_delta;
        K2_12_mR = self.rR * yaw_per_v_delta;
        M_22_IRxx = yaw_by_delta * yaw_by_delta;
        C1_22_IRxx = yaw_per_v_delta * yaw_by_delta;
        C1_12_IRyy = yaw_by_delta * t129;
        K2_12_IRyy = yaw_per_v_delta * t129;
        t323 = t29 * yaw_by_delta;
        t324 = yaw_by_delta * self.xB;
        t325 = self.mB * t324;
        P_delta_yaw_xB = t325 + yaw_by_delta * t101;
        M_22_xB = yaw_by_delta * P_delta_yaw_xB;
        t329 = t29 * yaw_per_v_delta;
        t331 = self.mB * yaw_by_delta;
        C1_22_xB = yaw_per_v_delta * P_delta_yaw_xB + yaw_by_delta * t331;
        t334 = sin_lam * t331;
        K2_22_xB = yaw_per_v_delta * t331;
        M_11_zB = t29 + t29;
        t338 = yaw_by_delta + yaw_per_v_delta * self.xB;
        t339 = self.mB * t338;
        t340 = self.mB * yaw_per_v_delta;
        M_11_mB = self.zB * self.zB;
        t342 = self.zB * t324;
        P_delta_yaw_mB = self.xB * t324;
        M_22_mB = yaw_by_delta * P_delta_yaw_mB;
        t345 = self.zB * t338;
        C1_22_mB = yaw_per_v_delta * P_delta_yaw_mB + yaw_by_delta * t324;
        t349 = sin_lam * t324;
        t350 = self.zB * yaw_per_v_delta;
        K2_22_mB = yaw_per_v_delta * t324;
        M_yaw_delta_xH = t183 - t180;
        P_delta_yaw_xH = self.mH * self.xH * t185;
        t355 = M_yaw_delta_xH + P_delta_yaw_xH;
        M_22_xH = yaw_by_delta * (M_yaw_delta_xH + t355) - t178;
        P_delta_lateral_xH = t182 + self.mH * yaw_by_delta;
        C1_22_xH = yaw_per_v_delta * t355 + yaw_by_delta * P_delta_lateral_xH;
        t364 = sin_lam * P_delta_lateral_xH;
        K2_22_xH = yaw_per_v_delta * P_delta_lateral_xH;
        M_11_zH = t14 + t14;
        t367 = t48 * yaw_by_delta;
        t369 = self.zH * sin_lam;
        t371 = t50 * C1_12_h_spin_F + t369 - t367;
        M_12_zH = t179 + self.mH * t371;
        K0_12_zH = self.mH * sin_lam;
        t376 = sin_lam * t50;
        M_yaw_delta_zH = self.mH * t376 - t48 * K0_12_zH;
        M_22_Jxx_delta = sin_lam * sin_lam;
        t383 = self.zH * M_22_Jxx_delta + t50 * M_22_Jxz_delta;
        M_22_zH = t185 * M_yaw_delta_zH + self.mH * t383 + t14 * M_22_Jxx_delta;
        t389 = yaw_by_delta + t48 * yaw_per_v_delta;
        t391 = t50 * yaw_per_v_delta - t389;
        C1_12_zH = self.mH * t391;
        C1_22_zH = yaw_per_v_delta * M_yaw_delta_zH - yaw_by_delta * K0_12_zH;
        K0_22_zH = sin_lam * K0_12_zH;
        t397 = self.mH * yaw_per_v_delta;
        t398 = yaw_per_v_delta * K0_12_zH;
        M_11_mH = self.zH * self.zH;
        M_12_mH = self.zH * t371;
        hz_delta_mH = t50 * t173;
        t404 = t173 + t369;
        M_yaw_delta_mH = hz_delta_mH + self.zH * t376 - t48 * t404;
        P_delta_yaw_mH = yaw_by_delta * t103;
        t410 = M_yaw_delta_mH + P_delta_yaw_mH;
        M_22_mH = self.zH * t383 + cos_lam * hz_delta_mH
            + yaw_by_delta * (M_yaw_delta_mH + t410);
        C1_12_mH = self.zH * t391;
        K0_12_mH = t404 - yaw_by_delta * (t48 - t50);
        C1_22_mH = yaw_per_v_delta * t410 - yaw_by_delta * K0_12_mH;
        K0_22_mH = sin_lam * K0_12_mH;
        t423 = self.zH * yaw_per_v_delta;
        t424 = yaw_per_v_delta * K0_12_mH;
        M_22_IHzz = M_22_IRxx + cos_lam * cos_lam + cos_lam * t185;
        C1_22_IHzz = C1_22_IRxx + cos_lam * yaw_per_v_delta;
        M_22_IHxz = M_22_Jxz_delta + sin_lam * t185;
        K2_22_h_spin_F = sin_lam * yaw_per_v_delta;
        M_11_rF = t18 + t18;
        t436 = self.rF * sin_lam;
        t438 = t367 + t436 - self.c * C1_12_h_spin_F;
        M_12_rF = t238 + self.mF * t438;
        t441 = self.mF * sin_lam;
        t443 = sin_lam * self.c;
        M_yaw_delta_rF = t48 * t441 - self.mF * t443;
        t449 = self.rF * M_22_Jxx_delta - self.c * M_22_Jxz_delta;
        M_22_rF = t185 * M_yaw_delta_rF + self.mF * t449 + t18 * M_22_Jxx_delta;
        t454 = t389 - yaw_by_delta;
        t456 = t125 * h_spin_F;
        C1_21_rF = C1_12_h_spin_F * t456;
        C1_12_rF = self.mF * t454 - C1_21_rF;
        C1_22_rF = yaw_by_delta * t441 + yaw_per_v_delta * M_yaw_delta_rF;
        t462 = sin_lam * t441;
        K2_12_rF = yaw_per_v_delta * (self.mF - t456);
        K2_22_rF = yaw_per_v_delta * t441 - K2_22_h_spin_F * t456;
        M_11_mF = self.rF * self.rF;
        M_12_mF = self.rF * t438;
        hz_delta_mF = self.c * t234;
        t473 = t234 - t436;
        M_yaw_delta_mF = hz_delta_mF - t48 * t473 - self.rF * t443;
        P_delta_yaw_mF = yaw_by_delta * t105;
        t479 = M_yaw_delta_mF + P_delta_yaw_mF;
        M_22_mF = self.rF * t449 + cos_lam * hz_delta_mF
            + yaw_by_delta * (M_yaw_delta_mF + t479);
        C1_12_mF = self.rF * t454;
        K0_12_mF = t473 - yaw_by_delta * (t48 - self.c);
        C1_22_mF = yaw_per_v_delta * t479 - yaw_by_delta * K0_12_mF;
        K0_22_mF = sin_lam * K0_12_mF;
        K2_12_mF = self.rF * yaw_per_v_delta;
        t493 = yaw_per_v_delta * K0_12_mF;
        let (
            M_22_IFxx, C1_12_IFyy, K2_12_IFyy, K2_22_IFyy, M_33_zU, M_13_zU, M_13_zP, M_23_zP, t502,
            C1_32_zP, K2_32_zP, K0_11_mU, Jxx_theta_mU, M_13_mU, M_11_mU, t512, t513,
            P_delta_yaw_Sx_theta, P_delta_yaw_mU, M_22_mU, t517, t518, t519, t521, C1_22_mU, t525,
            t527, t528, K2_22_mU, t530, P_delta_yaw_xU, M_22_xU, t534, t535, C1_22_xU, t539, t540,
            K2_22_xU, M_11_zU, C1_21, K2_32,
        );
        M_22_IFxx = M_22_Jxx_delta + M_22_IHzz;
        C1_12_IFyy = t125 * C1_12_h_spin_F;
        K2_12_IFyy = yaw_per_v_delta * t125;
        K2_22_IFyy = t125 * K2_22_h_spin_F;
        M_33_zU = Sz_theta + Sz_theta;
        M_13_zU = t31 + M_33_zU;
        M_13_zP = Sz_theta - M_13_zU;
        M_23_zP = yaw_by_delta * Sx_theta;
        t502 = self.mU * yaw_by_delta;
        C1_32_zP = t502 + yaw_per_v_delta * Sx_theta;
        K2_32_zP = self.mU * yaw_per_v_delta;
        K0_11_mU = self.zP + K0_13_mU;
        Jxx_theta_mU = K0_13_mU * K0_13_mU;
        M_13_mU = Jxx_theta_mU + self.zP * K0_13_mU;
        M_11_mU = self.zP * K0_11_mU + M_13_mU;
        t512 = yaw_by_delta * K0_11_mU;
        t513 = self.xU * t512;
        P_delta_yaw_Sx_theta = yaw_by_delta * self.xU;
        P_delta_yaw_mU = self.xU * P_delta_yaw_Sx_theta;
        M_22_mU = yaw_by_delta * P_delta_yaw_mU;
        t517 = K0_13_mU * yaw_by_delta;
        t518 = self.xU * t517;
        t519 = yaw_per_v_delta * K0_11_mU;
        t521 = t512 + self.xU * t519;
        C1_22_mU = yaw_per_v_delta * P_delta_yaw_mU
            + yaw_by_delta * P_delta_yaw_Sx_theta;
        t525 = K0_13_mU * yaw_per_v_delta;
        t527 = t517 + self.xU * t525;
        t528 = sin_lam * P_delta_yaw_Sx_theta;
        K2_22_mU = yaw_per_v_delta * P_delta_yaw_Sx_theta;
        t530 = self.mU * t512;
        P_delta_yaw_xU = M_23_zP + self.mU * P_delta_yaw_Sx_theta;
        M_22_xU = yaw_by_delta * P_delta_yaw_xU;
        t534 = self.mU * t517;
        t535 = self.mU * t519;
        C1_22_xU = yaw_per_v_delta * P_delta_yaw_xU + yaw_by_delta * t502;
        t539 = self.mU * t525;
        t540 = sin_lam * t502;
        K2_22_xU = yaw_per_v_delta * t502;
        M_11_zU = t31 + M_13_zU;
        C1_21 = -(t127 + yaw_by_delta * h_wheels_all);
        K2_32 = -t161;
        (
            WhippleLeaningMatrices::from_entries([
                M_11, M_12, M_phi_theta, M_12, M_22, P_delta_theta, M_phi_theta, P_delta_theta,
                Jxx_theta, zero, zero, zero, zero, zero, zero, zero, zero, self.dU, zero, C1_12,
                zero, C1_21, C1_22, zero, zero, C1_32, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, self.kU, Sz_all, K0_12, Sz_theta, K0_12, K0_22, zero, Sz_theta, zero,
                Sz_theta, zero, K2_12, zero, zero, K2_22, zero, zero, K2_32, zero,
            ]),
            WhippleLeaningDerivatives {
                values: [
                    M_12_w, M_22_w, t197, C1_12_w, C1_21_w, C1_22_w, t223, K0_12_w, K0_22_w, t225,
                    t228, K2_32_w, M_12_c, M_22_c, M_23_c, C1_12_c, t255, C1_22_c, t161, K0_12_c,
                    K0_22_c, t263, M_12_lam, M_22_lam, t287, t289, C1_21_lam, C1_22_lam, t299,
                    K0_12_lam, K0_22_lam, t303, K2_22_lam, K2_32_lam, M_11_rR, C1_12_rR, C1_21_rR,
                    self.mR, K2_12_rR, M_11_mR, C1_12_mR, self.rR, K2_12_mR, self.w.like(1.0),
                    M_22_IRxx, C1_22_IRxx, C1_12_IRyy, K2_12_IRyy, t323, M_22_xB, t329, C1_22_xB,
                    t331, t334, K2_22_xB, M_11_zB, t325, t339, self.mB, t340, M_11_mB, t342,
                    M_22_mB, t345, C1_22_mB, self.zB, t324, t349, t350, K2_22_mB, yaw_by_delta,
                    yaw_per_v_delta, t163, M_22_xH, t198, C1_22_xH, P_delta_lateral_xH, t364,
                    K2_22_xH, M_11_zH, M_12_zH, M_22_zH, C1_12_zH, C1_22_zH, self.mH, K0_12_zH,
                    K0_22_zH, t397, t398, M_11_mH, M_12_mH, M_22_mH, C1_12_mH, C1_22_mH, self.zH,
                    K0_12_mH, K0_22_mH, t423, t424, sin_lam, M_22_Jxx_delta, M_22_IHzz, C1_22_IHzz,
                    C1_12_h_spin_F, M_22_IHxz, K2_22_h_spin_F, M_11_rF, M_12_rF, M_22_rF, C1_12_rF,
                    C1_21_rF, C1_22_rF, self.mF, t441, t462, K2_12_rF, K2_22_rF, M_11_mF, M_12_mF,
                    M_22_mF, C1_12_mF, C1_22_mF, self.rF, K0_12_mF, K0_22_mF, K2_12_mF, t493,
                    M_22_IFxx, C1_12_IFyy, K2_12_IFyy, K2_22_IFyy, M_13_zP, M_23_zP, M_33_zU,
                    C1_32_zP, self.mU, K2_32_zP, M_11_mU, t513, M_13_mU, M_22_mU, t518,
                    Jxx_theta_mU, t521, C1_22_mU, t527, K0_11_mU, P_delta_yaw_Sx_theta, K0_13_mU,
                    t528, t519, K2_22_mU, t525, t530, M_22_xU, t534, t535, C1_22_xU, t539, t502,
                    t540, K2_22_xU, M_11_zU, M_13_zU,
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
    /// | `zB` | -0.7 | `m` |
    /// | `mB` | 45 | `kg` |
    /// | `IBxx` | 4 | `kg*m^2` |
    /// | `IByy` | 5.5 | `kg*m^2` |
    /// | `IBzz` | 1.8 | `kg*m^2` |
    /// | `IBxz` | 1.2 | `kg*m^2` |
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
    /// | `zP` | -0.85 | `m` |
    /// | `mU` | 40 | `kg` |
    /// | `xU` | 0.3 | `m` |
    /// | `zU` | -1.125 | `m` |
    /// | `IUxx` | 1.6 | `kg*m^2` |
    /// | `IUyy` | 1.6 | `kg*m^2` |
    /// | `IUzz` | 0.6 | `kg*m^2` |
    /// | `IUxz` | 0 | `kg*m^2` |
    /// | `kU` | 600 | `N*m` |
    /// | `dU` | 60 | `N*m*s` |
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

impl WhippleLeaning<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> WhippleLeaning<f32> {
        WhippleLeaning::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<WhippleLeaning<f32>> for WhippleLeaning<f64> {
    fn from(parameters: WhippleLeaning<f32>) -> Self {
        WhippleLeaning::cast(&parameters)
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

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 3]; 3]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 3]; 3];
        [self.m.0, zeros, self.c0.0, self.c1.0, self.kc.0, self.k0.0, zeros, self.k2.0]
    }
}

impl<T: Scalar> From<WhippleLeaningMatrices<T>> for Coefficients<T, 3> {
    fn from(matrices: WhippleLeaningMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
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
        matrices: &[
            MatrixName::M, MatrixName::C0, MatrixName::C1, MatrixName::Kc, MatrixName::K0,
            MatrixName::K2,
        ],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 2), (MatrixName::M, 2, 0)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]),
            EntryInfo::at(&[(MatrixName::M, 1, 2), (MatrixName::M, 2, 1)]),
            EntryInfo::at(&[(MatrixName::M, 2, 2)]), EntryInfo::at(&[(MatrixName::C0, 2, 2)]),
            EntryInfo::at(&[(MatrixName::C1, 0, 1)]), EntryInfo::at(&[(MatrixName::C1, 1, 0)]),
            EntryInfo::at(&[(MatrixName::C1, 1, 1)]), EntryInfo::at(&[(MatrixName::C1, 2, 1)]),
            EntryInfo::at(&[(MatrixName::Kc, 2, 2)]), EntryInfo::at(&[(MatrixName::K0, 0, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 2), (MatrixName::K0, 2, 0), (MatrixName::K0, 2, 2)]),
            EntryInfo::at(&[(MatrixName::K0, 1, 1)]), EntryInfo::at(&[(MatrixName::K2, 0, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 1, 1)]), EntryInfo::at(&[(MatrixName::K2, 2, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "example",
                docs: "",
                source: "The benchmark of Meijaard et al. (2007), Table 1, with 40 kg of rear frame and rider as an upper body",
                values: &WhippleLeaning::to_array(&WhippleLeaning::<f64>::EXAMPLE),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("yaw_by_delta", "1", "c*cos(lam)/w"),
            FormulaInfo::definition("yaw_per_v_delta", "1/m", "cos(lam)/w"),
            FormulaInfo::definition("Jxx_theta", "kg*m^2", "mU*(zU - zP)^2 + IUxx"),
            FormulaInfo::definition("Jxz_theta", "kg*m^2", "IUxz - mU*xU*(zU - zP)"),
            FormulaInfo::definition("Jzz_theta", "kg*m^2", "mU*xU^2 + IUzz"),
            FormulaInfo::definition("Sx_theta", "kg*m", "mU*xU"),
            FormulaInfo::definition("Sz_theta", "kg*m", "mU*(zU - zP)"),
            FormulaInfo::definition("Jxx_delta", "kg*m^2", "IHxx + IFxx + zH^2*mH + rF^2*mF"),
            FormulaInfo::definition("Jxz_delta", "kg*m^2", "IHxz - c*rF*mF - zH*mH*(xH - (w + c))"),
            FormulaInfo::definition("Jzz_delta", "kg*m^2", "mH*(xH - (w + c))^2 + IHzz + IFxx + c^2*mF"),
            FormulaInfo::definition("Sx_delta", "kg*m", "mH*(xH - (w + c)) - c*mF"),
            FormulaInfo::definition("Sz_delta", "kg*m", "zH*mH - rF*mF"),
            FormulaInfo::definition("m_delta", "kg", "mH + mF"),
            FormulaInfo::definition("py_delta", "kg*m", "Sx_delta*cos(lam) - Sz_delta*sin(lam)"),
            FormulaInfo::definition("hx_delta", "kg*m^2", "Jxx_delta*sin(lam) + Jxz_delta*cos(lam)"),
            FormulaInfo::definition("hz_delta", "kg*m^2", "Jxz_delta*sin(lam) + Jzz_delta*cos(lam)"),
            FormulaInfo::definition(
                "Jxx_all",
                "kg*m^2",
                "IRxx + IBxx + 2*zP*((1/2)*zP*mU + Sz_theta) + Jxx_theta + Jxx_delta + rR^2*mR + zB^2*mB",
            ),
            FormulaInfo::definition(
                "Jxz_all",
                "kg*m^2",
                "IBxz + Jxz_theta + Jxz_delta - xB*zB*mB - zP*Sx_theta - Sz_delta*(w + c)",
            ),
            FormulaInfo::definition(
                "Jzz_all",
                "kg*m^2",
                "IRxx + IBzz + IHzz + IFxx + Jzz_theta + w^2*mF + xB^2*mB + xH^2*mH",
            ),
            FormulaInfo::definition("Sx_all", "kg*m", "xB*mB + Sx_theta + Sx_delta + m_delta*(w + c)"),
            FormulaInfo::definition("Sz_all", "kg*m", "zB*mB + zP*mU + Sz_theta + Sz_delta - rR*mR"),
            FormulaInfo::definition("load_spin_F", "kg", "-Sx_all/w"),
            FormulaInfo::definition("h_spin_R", "kg*m", "IRyy/rR"),
            FormulaInfo::definition("h_spin_F", "kg*m", "IFyy/rF"),
            FormulaInfo::definition("h_wheels_all", "kg*m", "h_spin_R + h_spin_F"),
            FormulaInfo::definition("M_yaw_delta", "kg*m^2", "py_delta*(w + c) + hz_delta"),
            FormulaInfo::definition("M_phi_theta", "kg*m^2", "zP*Sz_theta + Jxx_theta"),
            FormulaInfo::definition("M_delta_delta", "kg*m^2", "hx_delta*sin(lam) + hz_delta*cos(lam)"),
            FormulaInfo::definition("K_phi_delta", "kg*m", "c*load_spin_F*cos(lam) - py_delta"),
            FormulaInfo::definition("K_delta_delta", "kg*m", "(c*load_spin_F*cos(lam) - py_delta)*sin(lam)"),
            FormulaInfo::definition("P_delta_lateral", "kg*m", "yaw_by_delta*Sx_all + py_delta"),
            FormulaInfo::definition("P_delta_yaw", "kg*m^2", "yaw_by_delta*Jzz_all + M_yaw_delta"),
            FormulaInfo::definition("P_delta_delta", "kg*m^2", "yaw_by_delta*M_yaw_delta + M_delta_delta"),
            FormulaInfo::definition("P_delta_theta", "kg*m^2", "yaw_by_delta*Jxz_theta"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "Jxx_all"),
            FormulaInfo::entry(
                &[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)],
                "kg*m^2",
                "yaw_by_delta*Jxz_all + hx_delta",
            ),
            FormulaInfo::entry(&[(MatrixName::M, 0, 2), (MatrixName::M, 2, 0)], "kg*m^2", "M_phi_theta"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "yaw_by_delta*P_delta_yaw + P_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 2), (MatrixName::M, 2, 1)], "kg*m^2", "P_delta_theta"),
            FormulaInfo::entry(&[(MatrixName::M, 2, 2)], "kg*m^2", "Jxx_theta"),
            FormulaInfo::entry(&[(MatrixName::C0, 2, 2)], "kg*m^2/s", "dU"),
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
            FormulaInfo::entry(&[(MatrixName::C1, 2, 1)], "kg*m", "yaw_per_v_delta*Jxz_theta - yaw_by_delta*Sz_theta"),
            FormulaInfo::entry(&[(MatrixName::Kc, 2, 2)], "kg*m^2/s^2", "kU"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "Sz_all"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)], "kg*m", "K_phi_delta"),
            FormulaInfo::entry(
                &[
                    (MatrixName::K0, 0, 2),
                    (MatrixName::K0, 2, 0),
                    (MatrixName::K0, 2, 2),
                ],
                "kg*m",
                "Sz_theta",
            ),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "K_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg", "yaw_per_v_delta*(h_wheels_all - Sz_all)"),
            FormulaInfo::entry(
                &[(MatrixName::K2, 1, 1)],
                "kg",
                "yaw_per_v_delta*(h_spin_F*sin(lam) + P_delta_lateral)",
            ),
            FormulaInfo::entry(&[(MatrixName::K2, 2, 1)], "kg", "-yaw_per_v_delta*Sz_theta"),
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
        let info = const { &<Self as Model<3>>::INFO.without_formulas() };
        info.validate(&self.to_array().map(Scalar::to_f64))?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 3> {
        Coefficients::from_rows(WhippleLeaningMatrices::rows(&self.matrices()))
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 3>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl WhippleLeaning<f64> {
    /// What the model tells about itself, the same for every number type.
    pub const INFO: &'static ModelInfo = <Self as Model<3>>::INFO;

    /// The parameter set of this name, however it is spelt: upper and lower case, `_`, `-` and spaces make no
    /// difference. In `f32` it is had by the trait `Model`.
    #[must_use]
    pub fn set(name: &str) -> Option<Self> {
        <Self as Model<3>>::set(name)
    }
}

/// The parameters, one a line with its unit, in the precision that is asked for; `{:#}` says what they are.
impl<T: Scalar> core::fmt::Display for WhippleLeaning<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<3>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 3> for WhippleLeaning<T> {
    type Entries = [T; 19];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            w: parameter(0), c: parameter(1), lam: parameter(2), g: parameter(3), rR: parameter(4),
            mR: parameter(5), IRxx: parameter(6), IRyy: parameter(7), xB: parameter(8),
            zB: parameter(9), mB: parameter(10), IBxx: parameter(11), IByy: parameter(12),
            IBzz: parameter(13), IBxz: parameter(14), xH: parameter(15), zH: parameter(16),
            mH: parameter(17), IHxx: parameter(18), IHyy: parameter(19), IHzz: parameter(20),
            IHxz: parameter(21), rF: parameter(22), mF: parameter(23), IFxx: parameter(24),
            IFyy: parameter(25), zP: parameter(26), mU: parameter(27), xU: parameter(28),
            zU: parameter(29), IUxx: parameter(30), IUyy: parameter(31), IUzz: parameter(32),
            IUxz: parameter(33), kU: parameter(34), dU: parameter(35),
        }
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
    fn rows(&self) -> [[[T; 3]; 3]; 8] {
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
            m: Rows([[zero; 3]; 3]), c0: Rows([[zero; 3]; 3]), c1: Rows([[zero; 3]; 3]),
            kc: Rows([[zero; 3]; 3]), k0: Rows([[zero; 3]; 3]), k2: Rows([[zero; 3]; 3]),
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
                _ => continue,
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
        let mut all = [Coefficients::from_rows([[[zero; 3]; 3]; 8]); 36];
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
