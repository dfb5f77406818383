// @generated from generated/models/whipple_leaning.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 3110f099e4d2a018

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    FormulaInfo, LengthError, MatrixName, Model, ModelInfo, Nonlinear, Number,
    ParameterError, ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo, WithDerivatives,
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

// --- The nonlinear equations of motion -----------------------------------------------------------

/// The nonlinear equations of motion of [`WhippleLeaning`], with its parameters: what does not depend on the state is computed.
///
/// Positions: `x` (x of the contact point of the rear wheel) in `m`, `y` (y of the contact point of the rear wheel) in `m`, `psi` (yaw) in `rad`, `phi` (lean) in `rad`, `pitch` (pitch, by the heights of the wheels) in `rad`, `delta` (steer) in `rad`, `theta` (upper body) in `rad`, `thetaR` (angle of the rear wheel) in `rad`, `thetaF` (angle of the front wheel) in `rad`.
/// Speeds: the rates of `phi`, `delta`, `theta`, `thetaR`.
///
/// Each from one straight-line program:
/// - closure: 14 additions, 32 multiplications, 2 divisions, 1 square root and 6 trigonometric functions: 55 operations
/// - rates: 42 additions, 93 multiplications, 4 divisions, 3 negations, 1 square root and 8 trigonometric functions: 151 operations
/// - derivatives: 485 additions, 654 multiplications, 8 divisions, 3 negations, 1 square root and 10 trigonometric functions: 1161 operations
/// - accelerations: 496 additions, 666 multiplications, 8 divisions, 2 negations, 1 square root and 10 trigonometric functions: 1183 operations
/// - energy: 215 additions, 289 multiplications, 4 divisions, 1 square root and 8 trigonometric functions: 517 operations
/// - contact forces: 650 additions, 821 multiplications, 8 divisions, 1 negation, 1 square root and 10 trigonometric functions: 1491 operations
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleLeaningMotion<T = f64> {
    constants: [T; 59],
}

impl<T: Scalar> WhippleLeaning<T> {
    /// The nonlinear equations of motion, of what is computed once for these parameters:
    /// 74 additions, 103 multiplications and 2 trigonometric functions: 179 operations.
    ///
    /// The parameters are not validated.
    #[must_use]
    pub fn motion(&self) -> WhippleLeaningMotion<T> {
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t12 = self.w + self.c;
        let t15 = cos_lam * t12 - sin_lam * self.rR;
        let t18 = sin_lam * t12 + cos_lam * self.rR;
        let t20 = self.rR + self.zP;
        let t21 = sin_lam * t20;
        let t22 = cos_lam * t20;
        let t23 = cos_lam * cos_lam;
        let t24 = sin_lam * cos_lam;
        let t25 = sin_lam * sin_lam;
        let t26 = self.w - t12;
        let t29 = cos_lam * t26 + sin_lam * self.rF;
        let t32 = sin_lam * t26 - cos_lam * self.rF;
        let t33 = t18 + t32;
        let t38 = self.rR + self.zB;
        let t40 = cos_lam * self.xB - sin_lam * t38;
        let t41 = self.mB * t40;
        let t44 = sin_lam * self.xB + cos_lam * t38;
        let t45 = self.mB * t44;
        let t49 = cos_lam * self.IBxz;
        let t50 = sin_lam * self.IBxx + t49;
        let t52 = sin_lam * self.IBxz;
        let t55 = t52 + cos_lam * self.IBzz;
        let t59 = cos_lam * t50 - sin_lam * t55 - t41 * t44;
        let t61 = t44 * t45;
        let t62 = t40 * t41;
        let t64 = self.IByy + t61 + t62;
        let t66 = self.mB + self.mR;
        let t76 = t61 + self.IRxx + cos_lam * (cos_lam * self.IBxx - t52)
            - sin_lam * (t49 - sin_lam * self.IBzz);
        let t81 = t62 + self.IRxx + sin_lam * t50 + cos_lam * t55;
        let t84 = self.mH + self.mF;
        let t86 = self.xH - t12;
        let t90 = cos_lam * t86 - sin_lam * self.zH;
        let t91 = self.mH * t90;
        let t92 = t29 * self.mF;
        let t93 = t91 + t92;
        let t96 = sin_lam * t86 + cos_lam * self.zH;
        let t97 = self.mH * t96;
        let t98 = t32 * self.mF;
        let t99 = t97 + t98;
        let t104 = sin_lam * self.IHxz;
        let t107 = cos_lam * self.IHxz;
        let t114 = t96 * t97 + t32 * t98;
        let t117 = self.IFxx + cos_lam * (cos_lam * self.IHxx - t104) + t114
            - sin_lam * (t107 - sin_lam * self.IHzz);
        let t119 = t107 + sin_lam * self.IHxx;
        let t122 = t104 + cos_lam * self.IHzz;
        let t128 = cos_lam * t119 - sin_lam * t122 - t91 * t96 - t32 * t92;
        let t132 = t90 * t91 + t29 * t92;
        let t134 = t114 + self.IHyy + t132;
        let t139 = self.IFxx + t132 + sin_lam * t119 + cos_lam * t122;
        let t143 = self.zU - self.zP;
        let t145 = cos_lam * self.xU - sin_lam * t143;
        let t146 = self.mU * t145;
        let t149 = sin_lam * self.xU + cos_lam * t143;
        let t150 = self.mU * t149;
        let t154 = sin_lam * self.IUxz;
        let t157 = cos_lam * self.IUxz;
        let t162 = t149 * t150;
        let t164 = cos_lam * (cos_lam * self.IUxx - t154) + t162
            - sin_lam * (t157 - sin_lam * self.IUzz);
        let t166 = t157 + sin_lam * self.IUxx;
        let t169 = t154 + cos_lam * self.IUzz;
        let t173 = cos_lam * t166 - sin_lam * t169 - t146 * t149;
        let t175 = t145 * t146;
        let t177 = t162 + self.IUyy + t175;
        let t181 = t175 + sin_lam * t166 + cos_lam * t169;
        let t183 = self.mU * t21;
        let t184 = self.mU * t22;
        let t185 = t22 * t184;
        let t186 = t22 * t183;
        let t187 = t21 * t183;
        let t188 = t117 - t134;
        let t189 = t15 * t84;
        let t190 = t18 * t99;
        let t191 = t18 * t84;
        let t194 = t190 + t190 + t18 * t191;
        let t195 = t15 * t99;
        let t196 = t18 * t189;
        let t197 = t15 * t189;
        let t198 = t99 + t191;
        let t201 = self.rR * (self.mU + t66 + t84);
        let t202 = self.rR * t201;
        let t205 = sin_lam * t146 - cos_lam * t150;
        let t208 = cos_lam * t164 + sin_lam * t173;
        let t211 = cos_lam * t173 + sin_lam * t181;
        let t214 = cos_lam * t208 + sin_lam * t211;
        WhippleLeaningMotion {
            constants: [
                sin_lam, cos_lam, self.kU, self.dU, self.rR, self.rF, self.mU, self.IRyy, self.IFyy,
                t15, t18, t21, t22, t23, t24, t25, t29, t32, t33, t41, t45, t59, t64, t66, t76, t81,
                t84, t93, t99, t117, t128, t134, t139, t146, t150, t164, t173, t177, t181, self.g,
                t183, t184, t185, t186, t187, t188, t189, t194, t195, t196, t197, t198, t201, t202,
                t205, t208, t211, t214, t202,
            ],
        }
    }
}

impl<T: Scalar> Nonlinear<3> for WhippleLeaning<T> {
    type Motion = WhippleLeaningMotion<T>;

    fn motion(&self) -> WhippleLeaningMotion<T> {
        WhippleLeaning::motion(self)
    }
}

impl<T: Scalar> carvallo::motion::Motion for WhippleLeaningMotion<T> {
    const INFO: &'static carvallo::motion::MotionInfo = &carvallo::motion::MotionInfo {
        model: "WhippleLeaning",
        positions: &[
            carvallo::motion::PositionInfo {
                name: "x",
                label: "x of the contact point of the rear wheel",
                unit: "m",
                kind: carvallo::motion::PositionKind::Ignorable,
            },
            carvallo::motion::PositionInfo {
                name: "y",
                label: "y of the contact point of the rear wheel",
                unit: "m",
                kind: carvallo::motion::PositionKind::Ignorable,
            },
            carvallo::motion::PositionInfo {
                name: "psi",
                label: "yaw",
                unit: "rad",
                kind: carvallo::motion::PositionKind::Ignorable,
            },
            carvallo::motion::PositionInfo {
                name: "phi",
                label: "lean",
                unit: "rad",
                kind: carvallo::motion::PositionKind::Free,
            },
            carvallo::motion::PositionInfo {
                name: "pitch",
                label: "pitch",
                unit: "rad",
                kind: carvallo::motion::PositionKind::Dependent,
            },
            carvallo::motion::PositionInfo {
                name: "delta",
                label: "steer",
                unit: "rad",
                kind: carvallo::motion::PositionKind::Free,
            },
            carvallo::motion::PositionInfo {
                name: "theta",
                label: "upper body",
                unit: "rad",
                kind: carvallo::motion::PositionKind::Free,
            },
            carvallo::motion::PositionInfo {
                name: "thetaR",
                label: "angle of the rear wheel",
                unit: "rad",
                kind: carvallo::motion::PositionKind::Ignorable,
            },
            carvallo::motion::PositionInfo {
                name: "thetaF",
                label: "angle of the front wheel",
                unit: "rad",
                kind: carvallo::motion::PositionKind::Ignorable,
            },
        ],
        speeds: &[3, 5, 6, 7],
        dependent: &[4],
        forces: &[
            carvallo::motion::AppliedInfo {
                name: "Tphi",
                label: "lean torque",
                unit: "N*m",
            },
            carvallo::motion::AppliedInfo {
                name: "Tdelta",
                label: "steer torque",
                unit: "N*m",
            },
            carvallo::motion::AppliedInfo {
                name: "Ttheta",
                label: "hip torque",
                unit: "N*m",
            },
        ],
        wheels: &[
            carvallo::motion::WheelInfo {
                name: "R",
                label: "rear wheel",
            },
            carvallo::motion::WheelInfo {
                name: "F",
                label: "front wheel",
            },
        ],
    };
}

#[allow(unused_variables)]
impl<T: Scalar> carvallo::motion::Unchecked for WhippleLeaningMotion<T> {
    type Scalar = T;

    type Positions = [T; 9];

    type Speeds = [T; 4];

    type Dependent = [T; 1];

    type Forces = [T; 3];

    type ContactForces = [[T; 3]; 2];

    fn closure_unchecked(&self, positions: &[T; 9]) -> ([T; 1], [T; 1]) {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t14 = self.constants[1] * sin_pitch + self.constants[0] * cos_pitch;
        let t15 = cos_phi * t14;
        let t19 = sin_phi * sin_delta;
        let t20 = t19 - cos_delta * t15;
        let t24 = self.constants[1] * cos_pitch - sin_pitch * self.constants[0];
        let t25 = cos_phi * t24;
        let t28 = (t20 * t20 + t25 * t25).sqrt();
        let t36 = self.constants[9] + cos_delta * self.constants[16];
        let t42 = self.constants[5] * t28 + t19 * self.constants[16]
            + cos_phi * (t24 * self.constants[18] - t14 * t36)
            - self.constants[4] * cos_phi;
        let t46 = self.constants[0].like(1.0) / t28;
        let t47 = t25 * t46;
        let t58 = self.constants[5] * (cos_delta * sin_phi + t15 * sin_delta)
            * (cos_phi * sin_delta * t47
                + sin_phi * (t20 * t24 * t46 + cos_delta * t14 * t47));
        let t64 = t42 / (cos_phi * (t58 + t14 * self.constants[18] + t24 * t36));
        ([t42], [t64])
    }

    fn rates_unchecked(&self, positions: &[T; 9], speeds: &[T; 4]) -> [T; 9] {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t13 = self.constants[1] * sin_pitch + self.constants[0] * cos_pitch;
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t17 = t13 * cos_phi;
        let t21 = sin_phi * sin_delta - cos_delta * t17;
        let t25 = self.constants[1] * cos_pitch - sin_pitch * self.constants[0];
        let t26 = cos_phi * t25;
        let t29 = (t21 * t21 + t26 * t26).sqrt();
        let t30 = self.constants[0].like(1.0) / t29;
        let t31 = t21 * t30;
        let t33 = t26 * t30;
        let t34 = cos_delta * t33;
        let t36 = t25 * t34 - t13 * t31;
        let t41 = self.constants[5] * (sin_phi * cos_delta + t17 * sin_delta);
        let t44 = sin_delta * self.constants[16];
        let t50 = self.constants[9] + cos_delta * self.constants[16];
        let t52 = t25 * self.constants[18] - t13 * t50;
        let t55 = cos_phi * t44 - t36 * t41 - sin_phi * t52;
        let t56 = self.constants[4] * sin_phi + t55;
        let t63 = cos_phi * sin_delta * t33 + sin_phi * (t25 * t31 + t13 * t34);
        let t68 = t41 * t63 + t13 * self.constants[18] + t25 * t50;
        let t70 = self.constants[0].like(1.0) / (cos_phi * t68);
        let t71 = t56 * t70;
        let t77 = t25 * self.constants[10] - t13 * self.constants[9];
        let t79 = t55 + sin_phi * t77;
        let t81 = sin_phi * t25;
        let t85 = t68 - t13 * self.constants[10] - t25 * self.constants[9];
        let t88 = t70 * (t13 * t79 + t81 * t85);
        let t90 = speeds[0] * t71 + speeds[1] * t88;
        let t92 = self.constants[4] * (speeds[3] + t90);
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let t98 = sin_phi * t68;
        let t100 = sin_phi * t56;
        let t102 = t36 * t98 + t63 * t100;
        let t106 = self.constants[0].like(1.0) / (t36 * t68 + t56 * t63);
        let t108 = t71 * t102 * t106;
        let t117 = t29 * self.constants[5] + sin_phi * t44 + cos_phi * t52
            - cos_phi * t77;
        let t119 = t26 * t85 - t13 * t117;
        let t123 = t81 * t117 + t26 * t79;
        let t128 = t106 * (t36 * t119 + t63 * t123 + t88 * t102);
        let t131 = self.constants[4] * t63 * t106;
        let t138 = t63 * t98 - t36 * t100;
        let t142 = t63 * t68 - t36 * t56;
        let t145 = self.constants[0].like(1.0) / self.constants[5];
        let t162 = speeds[0] * (t108 * t142 - t71 * t138) * t145
            + speeds[1] * t145 * (t36 * t123 + t128 * t142 - t63 * t119 - t88 * t138);
        let t163 = t162 + speeds[3] * t145 * (self.constants[4] * t36 + t131 * t142);
        let t164 = -(t92 * cos_psi);
        let t165 = -(t92 * sin_psi);
        let t166 = -(speeds[0] * t108 + speeds[1] * t128 + speeds[3] * t131);
        [t164, t165, t166, speeds[0], t90, speeds[1], speeds[2], speeds[3], t163]
    }

    fn derivatives_unchecked(&self, positions: &[T; 9], speeds: &[T; 4], forces: &[T; 3]) -> ([T; 9], [T; 4]) {
        let (
            sin_phi, cos_phi, sin_pitch, cos_pitch, t13, sin_delta, cos_delta, t17, t21, t25, t26,
            t29, t30, t31, t33, t34, t36, t40, t41, t44, t50, t52, t55, t56, t63, t68, t70, t71,
            t77, t79, t81, t85, t88, t90, t91, t92, sin_psi, cos_psi, t98, t100, t102, t106, t108,
            t117, t119, t123, t128, t131, t134, t138, t142, t145, t146, t155, t160, t163, t166,
            t168, t169, t171, t174, t179, t180, t181, t182, t183, t187, t188, t190, t192, t193,
            t196, t200, t205, t207, t208, t211, t212, t213, t218, t222, t224, t228, t229, t233,
            t234, t239, t241, t243, t247, t255, t256, t258, t264, t268, t275, t279, t281, t284,
            t289, t295, t297, t301, t315, t319, t321, t326, t330, t332, t334, t338, t345, t350,
            t357, t361, t364, t367, t369, t371, t373, t379, t387, t392, t397, sin_theta, cos_theta,
            t401, t403, t406, t408, t413, t418, t420, t428, t430, t436, t439, t442, t449, t450,
            t454, t460, t463, t469, t473, t480, t487, t490, t493, t498, t504, t511, t522, t526,
            t532, t542, t547, t551, t555, t560, t566, t574, t577, t582, t588, t590, t594, t598,
            t603, t609, t611, t617, t622, t630, t642, t648, t653, t664, t665, t672, t679, t684,
            t685, t691, t693, t700, t703, t716, t722, t728, t736, t743, t751, t761, t764, t769,
            t774, t778, t780, t783, t790, t791, t793, t803, t804, t807, t808, t813, t817, t819,
            t822, t824, t827, t833, t835, t836, t837, t840, t845, t846, t847, t849, t860, t865,
            t869, t870, t872, t877, t884, t886, t887, t890, t896, t899, t901, t905, t909, t911,
            t915, t924, t926, t936, t946, t948, t953, t955, t961, t966, t970, t974, t975, t981,
            t984, t985, t987,
        );
        (sin_phi, cos_phi) = positions[3].sin_cos();
        (sin_pitch, cos_pitch) = positions[4].sin_cos();
        t13 = self.constants[1] * sin_pitch + self.constants[0] * cos_pitch;
        (sin_delta, cos_delta) = positions[5].sin_cos();
        t17 = t13 * cos_phi;
        t21 = sin_phi * sin_delta - cos_delta * t17;
        t25 = self.constants[1] * cos_pitch - sin_pitch * self.constants[0];
        t26 = cos_phi * t25;
        t29 = (t21 * t21 + t26 * t26).sqrt();
        t30 = self.constants[0].like(1.0) / t29;
        t31 = t21 * t30;
        t33 = t26 * t30;
        t34 = cos_delta * t33;
        t36 = t25 * t34 - t13 * t31;
        t40 = sin_phi * cos_delta + t17 * sin_delta;
        t41 = self.constants[5] * t40;
        t44 = sin_delta * self.constants[16];
        t50 = self.constants[9] + cos_delta * self.constants[16];
        t52 = t25 * self.constants[18] - t13 * t50;
        t55 = cos_phi * t44 - t36 * t41 - sin_phi * t52;
        t56 = self.constants[4] * sin_phi + t55;
        t63 = cos_phi * sin_delta * t33 + sin_phi * (t25 * t31 + t13 * t34);
        t68 = t41 * t63 + t13 * self.constants[18] + t25 * t50;
        t70 = self.constants[0].like(1.0) / (cos_phi * t68);
        t71 = t56 * t70;
        t77 = t25 * self.constants[10] - t13 * self.constants[9];
        t79 = t55 + sin_phi * t77;
        t81 = sin_phi * t25;
        t85 = t68 - t13 * self.constants[10] - t25 * self.constants[9];
        t88 = t70 * (t13 * t79 + t81 * t85);
        t90 = speeds[0] * t71 + speeds[1] * t88;
        t91 = speeds[3] + t90;
        t92 = self.constants[4] * t91;
        (sin_psi, cos_psi) = positions[2].sin_cos();
        t98 = sin_phi * t68;
        t100 = sin_phi * t56;
        t102 = t36 * t98 + t63 * t100;
        t106 = self.constants[0].like(1.0) / (t36 * t68 + t56 * t63);
        t108 = t71 * t102 * t106;
        t117 = t29 * self.constants[5] + sin_phi * t44 + cos_phi * t52 - cos_phi * t77;
        t119 = t26 * t85 - t13 * t117;
        t123 = t81 * t117 + t26 * t79;
        t128 = t106 * (t36 * t119 + t63 * t123 + t88 * t102);
        t131 = self.constants[4] * t63 * t106;
        t134 = speeds[0] * t108 + speeds[1] * t128 + speeds[3] * t131;
        t138 = t63 * t98 - t36 * t100;
        t142 = t63 * t68 - t36 * t56;
        t145 = self.constants[0].like(1.0) / self.constants[5];
        t146 = (t108 * t142 - t71 * t138) * t145;
        t155 = t145 * (t36 * t123 + t128 * t142 - t63 * t119 - t88 * t138);
        t160 = t145 * (self.constants[4] * t36 + t131 * t142);
        t163 = speeds[0] * t146 + speeds[1] * t155 + speeds[3] * t160;
        t166 = cos_phi * t134;
        t168 = sin_phi * t134;
        t169 = self.constants[4] * t168;
        t171 = t166 * t169 - t92 * t166;
        t174 = t171 + sin_phi * self.constants[39];
        t179 = speeds[0] * t13 - t25 * t166;
        t180 = t90 * t179;
        t181 = speeds[0] * t168;
        t182 = t90 - t168;
        t183 = self.constants[10] * t182;
        t187 = speeds[0] * t25 + t13 * t166;
        t188 = self.constants[9] * t182;
        t190 = t179 * t183 + t187 * t188;
        t192 = t90 * t187;
        t193 = t25 * t181 + t192;
        t196 = t180 + t13 * t181;
        t200 = t190 + self.constants[9] * t193 + self.constants[10] * t196 - t171;
        t205 = self.constants[9] * t179 - self.constants[10] * t187;
        t207 = t182 * t188 + t179 * t205;
        t208 = speeds[0] * t166;
        t211 = self.constants[4] * speeds[0];
        t212 = t166 * t211;
        t213 = self.constants[4] * t208 + t212;
        t218 = t169 * (t91 - t168) - speeds[0] * t211;
        t222 = t25 * t213 + t13 * t218 - t207 - self.constants[10] * t208;
        t224 = speeds[1] + t179;
        t228 = cos_delta * t182 - sin_delta * t187;
        t229 = self.constants[17] * t228;
        t233 = cos_delta * t187 + sin_delta * t182;
        t234 = self.constants[16] * t228;
        t239 = speeds[1] * t228;
        t241 = t239 - cos_delta * t196 - sin_delta * t208;
        t243 = t31 * self.constants[5];
        t247 = t33 * self.constants[5];
        t255 = t30 * t40 * (t31 * t233 + t33 * t224);
        t256 = t247 * t255;
        t258 = t243 * t255;
        t264 = cos_delta * t200 + t224 * t229 + t233 * t234 + self.constants[16] * t193
            + t243 * (t193 + t163 * t233) + t224 * t256;
        t268 = t264 + t233 * t258 - sin_delta * t222 - self.constants[17] * t241
            - t247 * (t241 - t163 * t224);
        t275 = self.constants[16] * t224 - self.constants[17] * t233;
        t279 = speeds[1] * t233;
        t281 = sin_delta * t196 - cos_delta * t208 - t279;
        t284 = t163 + t228;
        t289 = self.constants[5] * (t31 * t224 - t33 * t233);
        t295 = cos_delta * t222 + sin_delta * t200 + self.constants[17] * t281
            + t247 * t281 - t228 * t234 - t224 * t275;
        t297 = t295 - t258 * t284 - t224 * t289;
        t301 = t187 * t205 - t182 * t183;
        t315 = t301 + self.constants[9] * t208 + t13 * t213 + t233 * t275 + t233 * t289
            - t25 * t218;
        t319 = t315 - t228 * t229 - self.constants[16] * t281 - t243 * t281
            - t256 * t284;
        t321 = t31 * t297 + t33 * t319;
        t326 = t70 * (t40 * t268 + t29 * t321);
        t330 = t106 * (t29 * t268 + t102 * t326 - t40 * t321);
        t332 = t181 - cos_phi * t330;
        t334 = t180 + t13 * t332;
        t338 = t192 + t25 * t332;
        t345 = t182 * self.constants[22] + self.constants[7] * (speeds[3] + t182);
        t350 = t187 * self.constants[24] + self.constants[21] * t179;
        t357 = t190 + self.constants[9] * t338 + self.constants[10] * t334 - t174;
        t361 = t326 - t208 - sin_phi * t330;
        t364 = self.constants[4] * t361 - t212;
        t367 = t218 + cos_phi * self.constants[39];
        t369 = t13 * t367 - t25 * t364;
        t371 = self.constants[10] * t361 + t369 - t207;
        t373 = cos_delta * t357 - sin_delta * t371;
        t379 = t239 + sin_delta * t361 - cos_delta * t334;
        t387 = t228 * self.constants[31] + t284 * self.constants[8];
        t392 = t233 * self.constants[29] + t224 * self.constants[30];
        t397 = self.constants[27] * t373 + self.constants[30] * t379
            + t338 * self.constants[32] + t233 * t387 - t228 * t392;
        (sin_theta, cos_theta) = positions[6].sin_cos();
        t401 = self.constants[0].like(1.0) - cos_theta;
        t403 = t401 * self.constants[14];
        t406 = self.constants[0] * sin_theta;
        t408 = t182 * self.constants[11];
        t413 = t179 * self.constants[11] + t187 * self.constants[12];
        t418 = t369 + t182 * t408 + t179 * t413 + t361 * self.constants[12];
        t420 = t182 * self.constants[12];
        t428 = t179 * t420 + t334 * self.constants[12] - t174 - t187 * t408
            - t338 * self.constants[11];
        t430 = self.constants[1] * sin_theta;
        t436 = t25 * t367 + t13 * t364;
        t439 = t361 * self.constants[11] - t187 * t413 - t182 * t420 - t436;
        t442 = cos_theta * t428 + t430 * t439 - t406 * t418;
        t449 = t182 * cos_theta + t179 * t430 - t187 * t406;
        t450 = self.constants[0] * speeds[2];
        t454 = cos_theta + t401 * self.constants[13];
        t460 = t449 * t450 + t361 * t406 + t338 * t403 - t334 * t454;
        t463 = self.constants[1] * speeds[2];
        t469 = cos_theta + t401 * self.constants[15];
        t473 = t338 * t469 - t449 * t463 - t334 * t403 - t361 * t430;
        t480 = t463 + t187 * t454 + t182 * t406 + t179 * t403;
        t487 = t450 + t187 * t403 + t179 * t469 - t182 * t430;
        t490 = self.constants[36] * t480 + t487 * self.constants[38];
        t493 = t449 * self.constants[37];
        t498 = self.constants[35] * t460 + self.constants[36] * t473 + t449 * t490
            - self.constants[34] * t442 - t487 * t493;
        t504 = t418 * t454 + t406 * t428 + t403 * t439;
        t511 = t403 * t418 + t439 * t469 - t428 * t430;
        t522 = speeds[2] * (self.constants[1] * t487 - self.constants[0] * t480)
            + t334 * t406 + t361 * cos_theta + t338 * t430;
        t526 = self.constants[35] * t480 + self.constants[36] * t487;
        t532 = self.constants[34] * t504 + self.constants[37] * t522 + t487 * t526
            - self.constants[33] * t511 - t480 * t490;
        t542 = t442 * self.constants[33] + t460 * self.constants[36]
            + t473 * self.constants[38] + t480 * t493 - t449 * t526;
        t547 = t449 * self.constants[33];
        t551 = t487 * self.constants[33] - self.constants[34] * t480;
        t555 = t504 * self.constants[6] + self.constants[34] * t522 - t449 * t547
            - t487 * t551;
        t560 = self.constants[34] * t449;
        t566 = t442 * self.constants[6] + t473 * self.constants[33] + t487 * t560
            + t480 * t547 - self.constants[34] * t460;
        t574 = t511 * self.constants[6] + t480 * t551 - self.constants[33] * t522
            - t449 * t560;
        t577 = t406 * t555 + cos_theta * t566 - t430 * t574;
        t582 = cos_delta * t371 + sin_delta * t357;
        t588 = cos_delta * t361 + sin_delta * t334 - t279;
        t590 = t228 * self.constants[27];
        t594 = t224 * self.constants[27] - t233 * self.constants[28];
        t598 = self.constants[26] * t582 + self.constants[28] * t588 - t228 * t590
            - t224 * t594;
        t603 = t228 * self.constants[28];
        t609 = t373 * self.constants[26] + t338 * self.constants[27] + t224 * t603
            + t233 * t590 - t379 * self.constants[28];
        t611 = sin_delta * t598 + cos_delta * t609;
        t617 = self.constants[25] * t338 + t187 * t345 + t397 + t403 * t498 + t430 * t532
            + t469 * t542;
        t622 = t617 + self.constants[9] * t611 - self.constants[19] * t174
            - self.constants[21] * t334 - t182 * t350 - self.constants[11] * t577;
        t630 = self.constants[21] * t187 + t179 * self.constants[25];
        t642 = t233 * self.constants[30] + t224 * self.constants[32];
        t648 = t379 * self.constants[29] + t338 * self.constants[30] + t228 * t642
            - t373 * self.constants[28] - t224 * t387;
        t653 = t301 - t436 - self.constants[9] * t361;
        t664 = t588 + t145 * (t31 * t319 + t142 * t330 - t33 * t297 - t138 * t326);
        t665 = self.constants[8] * t664;
        t672 = t582 * self.constants[28] + self.constants[31] * t588 + t665 + t224 * t392
            - self.constants[27] * t653 - t233 * t642;
        t679 = t174 * self.constants[20] + self.constants[21] * t338 + t182 * t630
            + t454 * t498 + t403 * t542 + cos_delta * t648;
        t684 = t679 - t334 * self.constants[24] - t179 * t345 - t406 * t532
            - self.constants[12] * t577 - sin_delta * t672;
        t685 = t684 - self.constants[10] * t611;
        t691 = t182 * self.constants[20];
        t693 = self.constants[19] * t182;
        t700 = t577 + t611 + self.constants[19] * t338 + t334 * self.constants[20]
            + t179 * t691 + t187 * t693 - t174 * self.constants[23];
        t703 = t71 - sin_phi * t108;
        t716 = t454 * t555 + t403 * t574 - t406 * t566;
        t722 = t403 * t555 + t430 * t566 + t469 * t574;
        t728 = cos_delta * t598 - sin_delta * t609;
        t736 = self.constants[26] * t653 + t233 * t594 - self.constants[27] * t588
            - t228 * t603;
        t743 = self.constants[19] * t179 - t187 * self.constants[20];
        t751 = t13
            * (t722 + t736 + t187 * t743 - t436 * self.constants[23]
                - self.constants[19] * t361 - t182 * t691);
        t761 = t25
            * (t716 + t728 + t369 * self.constants[23] + t361 * self.constants[20]
                - t182 * t693 - t179 * t743);
        t764 = self.constants[7] * t361 - self.constants[4] * (t751 + t761);
        t769 = t369 * self.constants[20] + self.constants[19] * t436
            + self.constants[22] * t361 + t179 * t350 + t406 * t498 + cos_theta * t532;
        t774 = t769 + self.constants[12] * t716 + self.constants[11] * t722
            + sin_delta * t648 + cos_delta * t672 + self.constants[10] * t728;
        t778 = t774 + t764 - t187 * t630 - t430 * t542 - self.constants[9] * t736;
        t780 = cos_phi * t108;
        t783 = t25 * t622 - t13 * t685;
        t790 = forces[0] + t780 * t783 - t13 * t622 - t25 * t685
            - self.constants[4] * t700 - t703 * t778;
        t791 = t790 - t146 * t665;
        t793 = t403 * self.constants[36];
        t803 = sin_delta * self.constants[45];
        t804 = sin_delta * t803;
        t807 = t403 * self.constants[33] + self.constants[34] * t469;
        t808 = self.constants[12] * t807;
        t813 = t808 + t808 + self.constants[42] + self.constants[47];
        t817 = self.constants[24] + self.constants[29]
            + t454 * (self.constants[35] * t454 + t793)
            + t406 * t406 * self.constants[37]
            + t403 * (t454 * self.constants[36] + t403 * self.constants[38]);
        t819 = t817 + t813 - t804;
        t822 = t403 * self.constants[35] + self.constants[36] * t469;
        t824 = t430 * self.constants[37];
        t827 = t793 + t469 * self.constants[38];
        t833 = t454 * self.constants[33] + t403 * self.constants[34];
        t835 = cos_delta * self.constants[27];
        t836 = self.constants[9] * t835;
        t837 = self.constants[11] * t833 - t836;
        t840 = self.constants[44] + self.constants[50] - t837 - t837;
        t845 = self.constants[25] + self.constants[32] + t403 * t822 + t430 * t824
            + t469 * t827 + t840;
        t846 = t845 - t819;
        t847 = t13 * t13;
        t849 = t13 * t25;
        t860 = cos_delta * self.constants[30] - self.constants[10] * t835;
        t865 = self.constants[21] + t454 * t822 + t403 * t827 + self.constants[11] * t807
            + self.constants[43] + t860;
        t869 = t865 - t406 * t824 - self.constants[12] * t833 - self.constants[48]
            - self.constants[49];
        t870 = t869 + t869;
        t872 = t846 * t847 + t849 * t870;
        t877 = self.constants[20] + t807 + self.constants[41] + self.constants[51];
        t884 = self.constants[19] + t833 + t835 + self.constants[46]
            - self.constants[40];
        t886 = t25 * t877 - t13 * t884;
        t887 = self.constants[4] * t886;
        t890 = self.constants[53] - t887 - t887;
        t896 = t406 * self.constants[33] - self.constants[34] * t430;
        t899 = sin_delta * self.constants[27];
        t901 = sin_delta * self.constants[30] - self.constants[10] * t899;
        t905 = t406 * t822 + cos_theta * t824 + t901 - t430 * t827
            - self.constants[12] * t896;
        t909 = t406 * self.constants[35] - t430 * self.constants[36];
        t911 = cos_theta * self.constants[37];
        t915 = t406 * self.constants[36] - t430 * self.constants[38];
        t924 = t454 * t909 + t403 * t915 + self.constants[11] * t896 + cos_delta * t803
            - t406 * t911 - self.constants[9] * t899;
        t926 = t13 * t905 + t25 * t924;
        t936 = t869 + t846 * t849 + self.constants[4] * (t13 * t877 + t25 * t884)
            - t847 * t870;
        t946 = self.constants[22] + self.constants[31] + t804 + t813 + t840 + t890
            + t406 * t909;
        t948 = t946 + cos_theta * t911 - t430 * t915;
        t953 = self.constants[4] * (t896 + t899);
        t955 = t25 * t905 + t953 - t13 * t924;
        t961 = t845 - t872;
        t966 = self.constants[7] * t703;
        t970 = t13 * sin_delta;
        t974 = t146 + cos_delta * t703 - sin_delta * t25 - t780 * t970;
        t975 = self.constants[8] * t974;
        t981 = t819 + t872 + t890 + t703 * t926
            + t703 * (t926 + t703 * t948 - t780 * t955) + t703 * t966;
        t984 = t981 + t974 * t975 - t780 * t936
            - t780 * (t936 + t703 * t955 - t780 * t961);
        t985 = self.constants[0].like(1.0) / t984;
        t987 = self.constants[32] + t836;
        let (
            t992, t994, t997, t998, t1002, t1006, t1010, t1016, t1022, t1026, t1031, t1033, t1035,
            t1041, t1043, t1044, t1054, t1061, t1063, t1068, t1072, t1076, t1079, t1085, t1087,
            t1098, t1102, t1104, t1106, t1109, t1110, t1124, t1125, t1127, t1129, t1135, t1139,
            t1144, t1146, t1151, t1157, t1158, t1171, t1174, t1180, t1191, t1212, t1217, t1219,
            t1223, t1229, t1230, t1231, t1232,
        );
        t992 = t88 - sin_phi * t128;
        t994 = cos_phi * t128;
        t997 = self.constants[4] * t25 * t899;
        t998 = t901 + t997;
        t1002 = t998 + t948 * t992 - t955 * t994;
        t1006 = t25 * t987 - t13 * t860;
        t1010 = t1006 + t955 * t992 - t961 * t994;
        t1016 = t155 + cos_delta * t992 - t970 * t994;
        t1022 = t13 * t987 + t25 * t860 + self.constants[4] * t835 + t926 * t992
            + t703 * t1002 + t966 * t992;
        t1026 = t985 * (t1022 + t975 * t1016 - t936 * t994 - t780 * t1010);
        t1031 = self.constants[7] * t992;
        t1033 = self.constants[8] * t1016;
        t1035 = t984 * t1026;
        t1041 = self.constants[32] + t992 * t1002 + t992 * t998 + t992 * t1031
            + t1016 * t1033 - t994 * t1010;
        t1043 = t1041 - t994 * t1006 - t1026 * t1035;
        t1044 = self.constants[0].like(1.0) / t1043;
        t1054 = forces[1] + t783 * t994 - t397 - t778 * t992 - t155 * t665
            - t791 * t1026;
        t1061 = t406 * self.constants[54];
        t1063 = t430 * self.constants[54];
        t1068 = self.constants[4] * (t13 * t1063 - t25 * t1061);
        t1072 = t406 * self.constants[55] + self.constants[11] * t1063
            - t430 * self.constants[56] - self.constants[12] * t1061 - t1068;
        t1076 = cos_theta * self.constants[54];
        t1079 = t403 * self.constants[55] + t469 * self.constants[56]
            - self.constants[11] * t1076;
        t1085 = t454 * self.constants[55] + t403 * self.constants[56]
            - self.constants[12] * t1076;
        t1087 = t25 * t1079 - t13 * t1085;
        t1098 = t985
            * (t13 * t1079 + t25 * t1085 + self.constants[4] * t1076 + t703 * t1072
                - t780 * t1087);
        t1102 = t1044 * (t992 * t1072 - t994 * t1087 - t1035 * t1098);
        t1104 = t984 * t1098;
        t1106 = t1043 * t1102;
        t1109 = self.constants[57] - t1098 * t1104 - t1102 * t1106;
        t1110 = self.constants[0].like(1.0) / t1109;
        t1124 = forces[2] - self.constants[1] * t498 - self.constants[0] * t542
            - positions[6] * self.constants[2] - speeds[2] * self.constants[3]
            - t791 * t1098;
        t1125 = t1124 - t1054 * t1102;
        t1127 = sin_phi * t131;
        t1129 = cos_phi * t131;
        t1135 = self.constants[4] * (t886 - self.constants[52]);
        t1139 = t1135 + t948 * t1127 + t955 * t1129;
        t1144 = t953 - t955 * t1127 - t961 * t1129;
        t1146 = self.constants[0].like(1.0) - t1127;
        t1151 = t160 - cos_delta * t1127 - t970 * t1129;
        t1157 = t966 * t1146 + t975 * t1151 - t926 * t1127 - t936 * t1129 - t703 * t1139
            - t780 * t1144;
        t1158 = t985 * t1157;
        t1171 = t997 + t1031 * t1146 + t1033 * t1151 - t992 * t1139 - t994 * t1144
            - t998 * t1127;
        t1174 = t1044 * (t1171 - t1006 * t1129 - t1035 * t1158);
        t1180 = t1110
            * (t1068 + t1072 * t1127 + t1087 * t1129 + t1104 * t1158 + t1106 * t1174);
        t1191 = t778 * t1127 + t783 * t1129 + t1125 * t1180 - t764 - t160 * t665
            - t791 * t1158;
        t1212 = t1127 * t1139 + t1127 * t1135 + self.constants[58]
            + self.constants[7] * t1146 * t1146 + self.constants[8] * t1151 * t1151
            - t1129 * t1144;
        t1217 = (t1191 - t1054 * t1174)
            / (t1212 - t953 * t1129 - t984 * t1158 * t1158 - t1043 * t1174 * t1174
                - t1109 * t1180 * t1180);
        t1219 = t1110 * t1125 + t1180 * t1217;
        t1223 = t1044 * t1054 - t1102 * t1219 - t1174 * t1217;
        t1229 = t791 * t985 - t1026 * t1223 - t1098 * t1219 - t1158 * t1217;
        t1230 = -(t92 * cos_psi);
        t1231 = -(t92 * sin_psi);
        t1232 = -t134;
        (
            [t1230, t1231, t1232, speeds[0], t90, speeds[1], speeds[2], speeds[3], t163],
            [t1229, t1223, t1219, t1217],
        )
    }

    fn accelerations_unchecked(&self, positions: &[T; 9], speeds: &[T; 4], forces: &[T; 3]) -> [T; 9] {
        let (
            sin_psi, cos_psi, sin_phi, cos_phi, sin_pitch, cos_pitch, t13, sin_delta, cos_delta,
            t16, t21, t25, t26, t29, t30, t31, t33, t34, t36, t43, t47, t48, t55, t58, t62, t66,
            t69, t70, t73, t74, t76, t78, t80, t81, t83, t90, t97, t101, t103, t105, t108, t110,
            t115, t119, t122, t126, t127, t128, t131, t134, t135, t136, t137, t141, t142, t144,
            t145, t147, t148, t151, t152, t154, t155, t157, t159, t162, t167, t169, t171, t172,
            t174, t179, t183, t185, t189, t190, t194, t195, t200, t202, t204, t207, t211, t214,
            t215, t224, t229, t232, t236, t244, t245, t247, t253, t257, t264, t268, t270, t273,
            t278, t284, t286, t290, t304, t308, t310, t313, t319, t322, sin_theta, cos_theta, t328,
            t330, t332, t336, t338, t340, t345, t350, t353, t356, t357, t361, t363, t366, t369,
            t373, t377, t383, t386, t391, t393, t397, t401, t403, t409, t418, t424, t426, t430,
            t434, t440, t448, t456, t458, t464, t470, t477, t480, t483, t490, t495, t497, t501,
            t509, t511, t518, t523, t526, t532, t534, t537, t542, t546, t552, t559, t561, t564,
            t572, t575, t576, t585, t590, t600, t603, t608, t615, t621, t631, t643, t649, t654,
            t666, t668, t671, t678, t686, t691, t695, t697, t704, t715, t723, t727, t733, t738,
            t756, t761, t762, t764, t780, t783, t785, t792, t793, t796, t798, t800, t802, t806,
            t809, t811, t815, t819, t821, t825, t829, t836, t838, t845, t849, t855, t857, t862,
            t866, t876, t877, t882, t886, t888, t895, t896, t899, t904, t905, t906, t908, t909,
            t915, t922, t928, t932, t935, t939, t942, t948, t950, t955, t957, t960, t965, t966,
            t969, t971, t972, t975,
        );
        (sin_psi, cos_psi) = positions[2].sin_cos();
        (sin_phi, cos_phi) = positions[3].sin_cos();
        (sin_pitch, cos_pitch) = positions[4].sin_cos();
        t13 = self.constants[1] * sin_pitch + cos_pitch * self.constants[0];
        (sin_delta, cos_delta) = positions[5].sin_cos();
        t16 = cos_phi * t13;
        t21 = sin_phi * sin_delta - cos_delta * t16;
        t25 = self.constants[1] * cos_pitch - self.constants[0] * sin_pitch;
        t26 = cos_phi * t25;
        t29 = (t21 * t21 + t26 * t26).sqrt();
        t30 = self.constants[0].like(1.0) / t29;
        t31 = t21 * t30;
        t33 = t26 * t30;
        t34 = cos_delta * t33;
        t36 = t25 * t34 - t13 * t31;
        t43 = cos_phi * sin_delta * t33 + sin_phi * (t25 * t31 + t13 * t34);
        t47 = sin_phi * cos_delta + sin_delta * t16;
        t48 = self.constants[5] * t47;
        t55 = self.constants[9] + cos_delta * self.constants[16];
        t58 = t43 * t48 + t13 * self.constants[18] + t25 * t55;
        t62 = sin_delta * self.constants[16];
        t66 = t25 * self.constants[18] - t13 * t55;
        t69 = cos_phi * t62 - t36 * t48 - sin_phi * t66;
        t70 = self.constants[4] * sin_phi + t69;
        t73 = self.constants[0].like(1.0) / (t36 * t58 + t43 * t70);
        t74 = sin_phi * t58;
        t76 = sin_phi * t70;
        t78 = t36 * t74 + t43 * t76;
        t80 = self.constants[0].like(1.0) / (cos_phi * t58);
        t81 = t70 * t80;
        t83 = t73 * t78 * t81;
        t90 = t58 - t13 * self.constants[10] - t25 * self.constants[9];
        t97 = t25 * self.constants[10] - t13 * self.constants[9];
        t101 = t29 * self.constants[5] + sin_phi * t62 + cos_phi * t66 - cos_phi * t97;
        t103 = t26 * t90 - t13 * t101;
        t105 = sin_phi * t25;
        t108 = t69 + sin_phi * t97;
        t110 = t101 * t105 + t26 * t108;
        t115 = t80 * (t13 * t108 + t90 * t105);
        t119 = t73 * (t36 * t103 + t43 * t110 + t78 * t115);
        t122 = self.constants[4] * t43 * t73;
        t126 = speeds[0] * t83 + speeds[1] * t119 + t122 * speeds[3];
        t127 = cos_phi * t126;
        t128 = speeds[0] * t127;
        t131 = t13 * speeds[0] - t25 * t127;
        t134 = speeds[0] * t81 + speeds[1] * t115;
        t135 = sin_phi * t126;
        t136 = t134 - t135;
        t137 = self.constants[10] * t136;
        t141 = t25 * speeds[0] + t13 * t127;
        t142 = self.constants[9] * t136;
        t144 = t131 * t137 + t141 * t142;
        t145 = speeds[0] * t135;
        t147 = t134 * t141;
        t148 = t25 * t145 + t147;
        t151 = t131 * t134;
        t152 = t13 * t145 + t151;
        t154 = speeds[3] + t134;
        t155 = self.constants[4] * t154;
        t157 = self.constants[4] * t135;
        t159 = t127 * t157 - t127 * t155;
        t162 = t144 + self.constants[9] * t148 + self.constants[10] * t152 - t159;
        t167 = self.constants[9] * t131 - self.constants[10] * t141;
        t169 = t136 * t142 + t131 * t167;
        t171 = self.constants[4] * speeds[0];
        t172 = t127 * t171;
        t174 = t172 + self.constants[4] * t128;
        t179 = t157 * (t154 - t135) - speeds[0] * t171;
        t183 = t25 * t174 + t13 * t179 - t169 - self.constants[10] * t128;
        t185 = speeds[1] + t131;
        t189 = cos_delta * t136 - sin_delta * t141;
        t190 = self.constants[17] * t189;
        t194 = cos_delta * t141 + sin_delta * t136;
        t195 = self.constants[16] * t189;
        t200 = speeds[1] * t189;
        t202 = t200 - cos_delta * t152 - sin_delta * t128;
        t204 = t31 * self.constants[5];
        t207 = t43 * t74 - t36 * t76;
        t211 = t43 * t58 - t36 * t70;
        t214 = self.constants[0].like(1.0) / self.constants[5];
        t215 = (t83 * t211 - t81 * t207) * t214;
        t224 = t214 * (t36 * t110 + t119 * t211 - t43 * t103 - t115 * t207);
        t229 = t214 * (self.constants[4] * t36 + t122 * t211);
        t232 = speeds[0] * t215 + speeds[1] * t224 + speeds[3] * t229;
        t236 = t33 * self.constants[5];
        t244 = t30 * t47 * (t31 * t194 + t33 * t185);
        t245 = t236 * t244;
        t247 = t204 * t244;
        t253 = cos_delta * t162 + t185 * t190 + t194 * t195 + self.constants[16] * t148
            + t204 * (t148 + t194 * t232) + t185 * t245;
        t257 = t253 + t194 * t247 - sin_delta * t183 - self.constants[17] * t202
            - t236 * (t202 - t185 * t232);
        t264 = self.constants[16] * t185 - self.constants[17] * t194;
        t268 = speeds[1] * t194;
        t270 = sin_delta * t152 - cos_delta * t128 - t268;
        t273 = t189 + t232;
        t278 = self.constants[5] * (t31 * t185 - t33 * t194);
        t284 = cos_delta * t183 + sin_delta * t162 + self.constants[17] * t270
            + t236 * t270 - t189 * t195 - t185 * t264;
        t286 = t284 - t247 * t273 - t185 * t278;
        t290 = t141 * t167 - t136 * t137;
        t304 = t290 + self.constants[9] * t128 + t13 * t174 + t194 * t264 + t194 * t278
            - t25 * t179;
        t308 = t304 - t189 * t190 - self.constants[16] * t270 - t204 * t270
            - t245 * t273;
        t310 = t31 * t286 + t33 * t308;
        t313 = t80 * (t47 * t257 + t29 * t310);
        t319 = t73 * (t29 * t257 + t78 * t313 - t47 * t310);
        t322 = t313 - t128 - sin_phi * t319;
        (sin_theta, cos_theta) = positions[6].sin_cos();
        t328 = self.constants[0].like(1.0) - cos_theta;
        t330 = t328 * self.constants[14];
        t332 = self.constants[4] * t322 - t172;
        t336 = t179 + cos_phi * self.constants[39];
        t338 = t13 * t336 - t25 * t332;
        t340 = t136 * self.constants[11];
        t345 = t131 * self.constants[11] + t141 * self.constants[12];
        t350 = t338 + t136 * t340 + t131 * t345 + t322 * self.constants[12];
        t353 = cos_theta + t328 * self.constants[13];
        t356 = self.constants[0] * sin_theta;
        t357 = t136 * self.constants[12];
        t361 = t145 - cos_phi * t319;
        t363 = t147 + t25 * t361;
        t366 = t151 + t13 * t361;
        t369 = t159 + sin_phi * self.constants[39];
        t373 = t131 * t357 + self.constants[12] * t366 - t141 * t340
            - self.constants[11] * t363 - t369;
        t377 = t25 * t336 + t13 * t332;
        t383 = t322 * self.constants[11] - t377 - t141 * t345 - t136 * t357;
        t386 = t350 * t353 + t356 * t373 + t383 * t330;
        t391 = self.constants[0] * speeds[2];
        t393 = self.constants[1] * sin_theta;
        t397 = cos_theta + t328 * self.constants[15];
        t401 = t391 + t141 * t330 + t131 * t397 - t136 * t393;
        t403 = self.constants[1] * speeds[2];
        t409 = t403 + t141 * t353 + t136 * t356 + t131 * t330;
        t418 = speeds[2] * (self.constants[1] * t401 - self.constants[0] * t409)
            + t356 * t366 + t322 * cos_theta + t363 * t393;
        t424 = t136 * cos_theta + t131 * t393 - t141 * t356;
        t426 = t424 * self.constants[33];
        t430 = t401 * self.constants[33] - self.constants[34] * t409;
        t434 = t386 * self.constants[6] + self.constants[34] * t418 - t424 * t426
            - t401 * t430;
        t440 = cos_theta * t373 + t393 * t383 - t356 * t350;
        t448 = t363 * t397 - t424 * t403 - t366 * t330 - t322 * t393;
        t456 = t424 * t391 + t322 * t356 + t363 * t330 - t366 * t353;
        t458 = self.constants[34] * t424;
        t464 = t440 * self.constants[6] + t448 * self.constants[33] + t401 * t458
            + t409 * t426 - self.constants[34] * t456;
        t470 = t350 * t330 + t383 * t397 - t373 * t393;
        t477 = t470 * self.constants[6] + t409 * t430 - self.constants[33] * t418
            - t424 * t458;
        t480 = t330 * t434 + t393 * t464 + t397 * t477;
        t483 = t290 - t377 - self.constants[9] * t322;
        t490 = cos_delta * t322 + sin_delta * t366 - t268;
        t495 = t185 * self.constants[27] - t194 * self.constants[28];
        t497 = t189 * self.constants[28];
        t501 = t483 * self.constants[26] + t194 * t495 - self.constants[27] * t490
            - t189 * t497;
        t509 = t131 * self.constants[19] - self.constants[20] * t141;
        t511 = self.constants[20] * t136;
        t518 = t13
            * (t480 + t501 + t141 * t509 - t377 * self.constants[23]
                - t322 * self.constants[19] - t136 * t511);
        t523 = t353 * t434 + t330 * t477 - t356 * t464;
        t526 = t338 + self.constants[10] * t322 - t169;
        t532 = t144 + self.constants[9] * t363 + self.constants[10] * t366 - t369;
        t534 = cos_delta * t526 + sin_delta * t532;
        t537 = t189 * self.constants[27];
        t542 = t534 * self.constants[26] + self.constants[28] * t490 - t189 * t537
            - t185 * t495;
        t546 = cos_delta * t532 - sin_delta * t526;
        t552 = t200 + sin_delta * t322 - cos_delta * t366;
        t559 = t546 * self.constants[26] + t363 * self.constants[27] + t185 * t497
            + t194 * t537 - self.constants[28] * t552;
        t561 = cos_delta * t542 - sin_delta * t559;
        t564 = t136 * self.constants[19];
        t572 = t25
            * (t523 + t561 + t338 * self.constants[23] + self.constants[20] * t322
                - t136 * t564 - t131 * t509);
        t575 = t322 * self.constants[7] - self.constants[4] * (t518 + t572);
        t576 = sin_phi * t122;
        t585 = t141 * self.constants[24] + t131 * self.constants[21];
        t590 = t141 * self.constants[21] + t131 * self.constants[25];
        t600 = self.constants[36] * t409 + t401 * self.constants[38];
        t603 = t424 * self.constants[37];
        t608 = self.constants[35] * t456 + self.constants[36] * t448 + t424 * t600
            - self.constants[34] * t440 - t401 * t603;
        t615 = self.constants[35] * t409 + self.constants[36] * t401;
        t621 = self.constants[34] * t386 + self.constants[37] * t418 + t401 * t615
            - self.constants[33] * t470 - t409 * t600;
        t631 = t440 * self.constants[33] + t456 * self.constants[36]
            + t448 * self.constants[38] + t409 * t603 - t424 * t615;
        t643 = t194 * self.constants[30] + t185 * self.constants[32];
        t649 = t189 * self.constants[31] + t273 * self.constants[8];
        t654 = self.constants[29] * t552 + t363 * self.constants[30] + t189 * t643
            - self.constants[28] * t546 - t185 * t649;
        t666 = t214 * (t31 * t308 + t211 * t319 - t33 * t286 - t207 * t313);
        t668 = self.constants[8] * (t490 + t666);
        t671 = t194 * self.constants[29] + t185 * self.constants[30];
        t678 = self.constants[28] * t534 + self.constants[31] * t490 + t668 + t185 * t671
            - self.constants[27] * t483 - t194 * t643;
        t686 = self.constants[20] * t338 + self.constants[19] * t377
            + t322 * self.constants[22] + t131 * t585 + t356 * t608 + cos_theta * t621;
        t691 = t686 + self.constants[12] * t523 + self.constants[11] * t480
            + sin_delta * t654 + cos_delta * t678 + self.constants[10] * t561;
        t695 = t691 + t575 - t141 * t590 - t393 * t631 - self.constants[9] * t501;
        t697 = cos_phi * t122;
        t704 = t136 * self.constants[22] + self.constants[7] * (speeds[3] + t136);
        t715 = t546 * self.constants[27] + t552 * self.constants[30]
            + t363 * self.constants[32] + t194 * t649 - t189 * t671;
        t723 = t356 * t434 + cos_theta * t464 - t393 * t477;
        t727 = sin_delta * t542 + cos_delta * t559;
        t733 = self.constants[25] * t363 + t141 * t704 + t715 + t330 * t608 + t393 * t621
            + t397 * t631;
        t738 = t733 + self.constants[9] * t727 - self.constants[19] * t369
            - self.constants[21] * t366 - t136 * t585 - self.constants[11] * t723;
        t756 = self.constants[20] * t369 + self.constants[21] * t363 + t136 * t590
            + t353 * t608 + t330 * t631 + cos_delta * t654;
        t761 = t756 - self.constants[24] * t366 - t131 * t704 - t356 * t621
            - self.constants[12] * t723 - sin_delta * t678;
        t762 = t761 - self.constants[10] * t727;
        t764 = t25 * t738 - t13 * t762;
        t780 = t723 + t727 + self.constants[19] * t363 + self.constants[20] * t366
            + t131 * t511 + t141 * t564 - t369 * self.constants[23];
        t783 = t81 - sin_phi * t83;
        t785 = cos_phi * t83;
        t792 = forces[0] + t764 * t785 - t13 * t738 - t25 * t762
            - self.constants[4] * t780 - t695 * t783;
        t793 = t792 - t215 * t668;
        t796 = self.constants[35] * t330 + self.constants[36] * t397;
        t798 = t393 * self.constants[37];
        t800 = t330 * self.constants[36];
        t802 = t800 + t397 * self.constants[38];
        t806 = t356 * self.constants[33] - self.constants[34] * t393;
        t809 = sin_delta * self.constants[27];
        t811 = sin_delta * self.constants[30] - self.constants[10] * t809;
        t815 = t356 * t796 + cos_theta * t798 + t811 - t393 * t802
            - self.constants[12] * t806;
        t819 = t356 * self.constants[35] - t393 * self.constants[36];
        t821 = cos_theta * self.constants[37];
        t825 = t356 * self.constants[36] - t393 * self.constants[38];
        t829 = sin_delta * self.constants[45];
        t836 = t353 * t819 + t330 * t825 + self.constants[11] * t806 + cos_delta * t829
            - t356 * t821 - self.constants[9] * t809;
        t838 = t13 * t815 + t25 * t836;
        t845 = t330 * self.constants[33] + self.constants[34] * t397;
        t849 = t353 * self.constants[33] + self.constants[34] * t330;
        t855 = cos_delta * self.constants[27];
        t857 = cos_delta * self.constants[30] - self.constants[10] * t855;
        t862 = self.constants[21] + t353 * t796 + t330 * t802 + self.constants[11] * t845
            + self.constants[43] + t857;
        t866 = t862 - t356 * t798 - self.constants[12] * t849 - self.constants[48]
            - self.constants[49];
        t876 = sin_delta * t829;
        t877 = self.constants[12] * t845;
        t882 = t877 + t877 + self.constants[42] + self.constants[47];
        t886 = self.constants[24] + self.constants[29]
            + t353 * (t800 + self.constants[35] * t353)
            + t356 * t356 * self.constants[37]
            + t330 * (t353 * self.constants[36] + t330 * self.constants[38]);
        t888 = t886 + t882 - t876;
        t895 = self.constants[9] * t855;
        t896 = self.constants[11] * t849 - t895;
        t899 = self.constants[44] + self.constants[50] - t896 - t896;
        t904 = self.constants[25] + self.constants[32] + t330 * t796 + t393 * t798
            + t397 * t802 + t899;
        t905 = t904 - t888;
        t906 = t25 * t13;
        t908 = t13 * t13;
        t909 = t866 + t866;
        t915 = self.constants[20] + t845 + self.constants[41] + self.constants[51];
        t922 = self.constants[19] + t849 + t855 + self.constants[46]
            - self.constants[40];
        t928 = t866 + t905 * t906 + self.constants[4] * (t13 * t915 + t25 * t922)
            - t908 * t909;
        t932 = t25 * t915 - t13 * t922;
        t935 = self.constants[4] * (t932 - self.constants[52]);
        t939 = self.constants[4] * t932;
        t942 = self.constants[53] - t939 - t939;
        t948 = self.constants[22] + self.constants[31] + t876 + t882 + t899 + t356 * t819
            + cos_theta * t821;
        t950 = t948 + t942 - t393 * t825;
        t955 = self.constants[4] * (t806 + t809);
        t957 = t25 * t815 + t955 - t13 * t836;
        t960 = t935 + t576 * t950 + t697 * t957;
        t965 = t905 * t908 + t906 * t909;
        t966 = t904 - t965;
        t969 = t955 - t576 * t957 - t697 * t966;
        t971 = self.constants[0].like(1.0) - t576;
        t972 = self.constants[7] * t783;
        t975 = sin_delta * t13;
        let (
            t978, t984, t985, t991, t1010, t1013, t1014, t1015, t1018, t1020, t1021, t1023, t1026,
            t1028, t1031, t1035, t1039, t1044, t1045, t1060, t1064, t1065, t1071, t1073, t1074,
            t1086, t1089, t1099, t1102, t1104, t1107, t1117, t1121, t1124, t1130, t1132, t1143,
            t1144, t1151, t1152, t1162, t1163, t1164, t1178, t1179, t1185, t1206, t1211, t1216,
            t1220, t1226, t1230, t1232, t1235, t1240, t1252, t1253, t1254,
        );
        t978 = t229 - cos_delta * t576 - t697 * t975;
        t984 = t215 + cos_delta * t783 - sin_delta * t25 - t785 * t975;
        t985 = self.constants[8] * t984;
        t991 = t971 * t972 + t978 * t985 - t576 * t838 - t697 * t928 - t783 * t960
            - t785 * t969;
        t1010 = t888 + t942 + t965 + t783 * t838
            + t783 * (t838 + t783 * t950 - t785 * t957) + t783 * t972;
        t1013 = t1010 + t984 * t985 - t785 * t928
            - t785 * (t928 + t783 * t957 - t785 * t966);
        t1014 = self.constants[0].like(1.0) / t1013;
        t1015 = t991 * t1014;
        t1018 = t115 - sin_phi * t119;
        t1020 = self.constants[4] * t25 * t809;
        t1021 = t811 + t1020;
        t1023 = cos_phi * t119;
        t1026 = t1021 + t950 * t1018 - t957 * t1023;
        t1028 = self.constants[32] + t895;
        t1031 = t25 * t1028 - t13 * t857;
        t1035 = t1031 + t957 * t1018 - t966 * t1023;
        t1039 = self.constants[7] * t1018;
        t1044 = t224 + cos_delta * t1018 - t975 * t1023;
        t1045 = self.constants[8] * t1044;
        t1060 = t13 * t1028 + t25 * t857 + self.constants[4] * t855 + t838 * t1018
            + t783 * t1026 + t972 * t1018;
        t1064 = t1014 * (t1060 + t985 * t1044 - t928 * t1023 - t785 * t1035);
        t1065 = t1013 * t1064;
        t1071 = self.constants[32] + t1018 * t1026 + t1018 * t1021 + t1018 * t1039
            + t1044 * t1045 - t1023 * t1035;
        t1073 = t1071 - t1023 * t1031 - t1064 * t1065;
        t1074 = self.constants[0].like(1.0) / t1073;
        t1086 = t1020 + t971 * t1039 + t978 * t1045 - t960 * t1018 - t969 * t1023
            - t576 * t1021;
        t1089 = t1074 * (t1086 - t697 * t1031 - t1015 * t1065);
        t1099 = forces[1] + t764 * t1023 - t715 - t695 * t1018 - t224 * t668
            - t793 * t1064;
        t1102 = t393 * self.constants[54];
        t1104 = t356 * self.constants[54];
        t1107 = self.constants[4] * (t13 * t1102 - t25 * t1104);
        t1117 = t356 * self.constants[55] + self.constants[11] * t1102 - t1107
            - t393 * self.constants[56] - self.constants[12] * t1104;
        t1121 = cos_theta * self.constants[54];
        t1124 = t330 * self.constants[55] + t397 * self.constants[56]
            - self.constants[11] * t1121;
        t1130 = t353 * self.constants[55] + t330 * self.constants[56]
            - self.constants[12] * t1121;
        t1132 = t25 * t1124 - t13 * t1130;
        t1143 = t1014
            * (t13 * t1124 + t25 * t1130 + self.constants[4] * t1121 + t783 * t1117
                - t785 * t1132);
        t1144 = t1013 * t1143;
        t1151 = t1074 * (t1018 * t1117 - t1023 * t1132 - t1065 * t1143);
        t1152 = t1073 * t1151;
        t1162 = self.constants[57] - t1143 * t1144 - t1151 * t1152;
        t1163 = self.constants[0].like(1.0) / t1162;
        t1164 = (t1107 + t576 * t1117 + t697 * t1132 + t1015 * t1144 + t1089 * t1152)
            * t1163;
        t1178 = forces[2] - self.constants[1] * t608 - self.constants[0] * t631
            - positions[6] * self.constants[2] - speeds[2] * self.constants[3]
            - t793 * t1143;
        t1179 = t1178 - t1099 * t1151;
        t1185 = t576 * t695 + t697 * t764 + t1164 * t1179 - t575 - t229 * t668
            - t793 * t1015;
        t1206 = t576 * t960 + t576 * t935 + self.constants[58]
            + self.constants[7] * t971 * t971 + self.constants[8] * t978 * t978
            - t697 * t969;
        t1211 = (t1185 - t1089 * t1099)
            / (t1206 - t697 * t955 - t1013 * t1015 * t1015 - t1073 * t1089 * t1089
                - t1162 * t1164 * t1164);
        t1216 = t1163 * t1179 + t1164 * t1211;
        t1220 = t1074 * t1099 - t1151 * t1216 - t1089 * t1211;
        t1226 = t793 * t1014 - t1064 * t1220 - t1143 * t1216 - t1015 * t1211;
        t1230 = t313 + t81 * t1226 + t115 * t1220;
        t1232 = self.constants[4] * (t1211 + t1230);
        t1235 = t126 * t155;
        t1240 = cos_psi * t1235 - t1232 * sin_psi;
        t1252 = t666 + t215 * t1226 + t224 * t1220 + t229 * t1211;
        t1253 = -(cos_psi * t1232 + sin_psi * t1235);
        t1254 = -(t319 + t83 * t1226 + t119 * t1220 + t122 * t1211);
        [t1253, t1240, t1254, t1226, t1230, t1220, t1216, t1211, t1252]
    }

    fn energy_unchecked(&self, positions: &[T; 9], speeds: &[T; 4]) -> [T; 2] {
        let (sin_theta, cos_theta) = positions[6].sin_cos();
        let t6 = self.constants[0].like(1.0) - cos_theta;
        let t9 = cos_theta + t6 * self.constants[13];
        let t13 = t6 * self.constants[14];
        let t15 = t13 * self.constants[36];
        let t20 = self.constants[0] * sin_theta;
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t32 = sin_delta * self.constants[45];
        let t33 = sin_delta * t32;
        let t39 = cos_theta + t6 * self.constants[15];
        let t42 = t13 * self.constants[33] + t39 * self.constants[34];
        let t43 = self.constants[12] * t42;
        let t48 = t43 + t43 + self.constants[42] + self.constants[47];
        let t52 = self.constants[24] + self.constants[29]
            + t9 * (t9 * self.constants[35] + t15) + t20 * t20 * self.constants[37]
            + t13 * (t9 * self.constants[36] + t13 * self.constants[38]);
        let t54 = t52 + t48 - t33;
        let t59 = self.constants[35] * t13 + self.constants[36] * t39;
        let t62 = sin_theta * self.constants[1];
        let t63 = self.constants[37] * t62;
        let t66 = t15 + self.constants[38] * t39;
        let t73 = t9 * self.constants[33] + t13 * self.constants[34];
        let t78 = cos_delta * self.constants[27];
        let t79 = self.constants[9] * t78;
        let t80 = self.constants[11] * t73 - t79;
        let t83 = self.constants[44] + self.constants[50] - t80 - t80;
        let t88 = self.constants[25] + self.constants[32] + t13 * t59 + t62 * t63
            + t39 * t66 + t83;
        let t89 = t88 - t54;
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t95 = self.constants[1] * sin_pitch + self.constants[0] * cos_pitch;
        let t96 = t95 * t95;
        let t100 = self.constants[1] * cos_pitch - self.constants[0] * sin_pitch;
        let t101 = t95 * t100;
        let t115 = cos_delta * self.constants[30] - t78 * self.constants[10];
        let t120 = self.constants[21] + t9 * t59 + t13 * t66 + t42 * self.constants[11]
            + self.constants[43] + t115;
        let t124 = t120 - t20 * t63 - self.constants[12] * t73 - self.constants[48]
            - self.constants[49];
        let t125 = t124 + t124;
        let t127 = t89 * t96 + t101 * t125;
        let t134 = t42 + self.constants[20] + self.constants[41] + self.constants[51];
        let t142 = t73 + t78 + self.constants[19] + self.constants[46]
            - self.constants[40];
        let t144 = t100 * t134 - t95 * t142;
        let t145 = self.constants[4] * t144;
        let t148 = self.constants[53] - t145 - t145;
        let t154 = t20 * self.constants[33] - self.constants[34] * t62;
        let t157 = sin_delta * self.constants[27];
        let t159 = sin_delta * self.constants[30] - self.constants[10] * t157;
        let t163 = t20 * t59 + cos_theta * t63 + t159 - t62 * t66
            - self.constants[12] * t154;
        let t167 = self.constants[35] * t20 - self.constants[36] * t62;
        let t169 = cos_theta * self.constants[37];
        let t173 = self.constants[36] * t20 - self.constants[38] * t62;
        let t182 = t9 * t167 + t13 * t173 + self.constants[11] * t154 + t32 * cos_delta
            - t20 * t169 - self.constants[9] * t157;
        let t184 = t95 * t163 + t100 * t182;
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t189 = t95 * cos_phi;
        let t192 = sin_delta * sin_phi - cos_delta * t189;
        let t194 = t100 * cos_phi;
        let t197 = (t192 * t192 + t194 * t194).sqrt();
        let t198 = self.constants[0].like(1.0) / t197;
        let t199 = t192 * t198;
        let t201 = t194 * t198;
        let t202 = cos_delta * t201;
        let t204 = t100 * t202 - t95 * t199;
        let t209 = self.constants[5] * (cos_delta * sin_phi + sin_delta * t189);
        let t212 = sin_delta * self.constants[16];
        let t217 = self.constants[9] + cos_delta * self.constants[16];
        let t219 = t100 * self.constants[18] - t95 * t217;
        let t222 = cos_phi * t212 - t204 * t209 - sin_phi * t219;
        let t223 = self.constants[4] * sin_phi + t222;
        let t230 = sin_delta * cos_phi * t201 + sin_phi * (t100 * t199 + t95 * t202);
        let t235 = t209 * t230 + t95 * self.constants[18] + t100 * t217;
        let t237 = self.constants[0].like(1.0) / (cos_phi * t235);
        let t238 = t223 * t237;
        let t239 = sin_phi * t235;
        let t241 = sin_phi * t223;
        let t243 = t204 * t239 + t230 * t241;
        let t247 = self.constants[0].like(1.0) / (t204 * t235 + t223 * t230);
        let t249 = t238 * t243 * t247;
        let t251 = t238 - sin_phi * t249;
        let t261 = t124 + t89 * t101 + self.constants[4] * (t95 * t134 + t100 * t142)
            - t96 * t125;
        let t262 = cos_phi * t249;
        let t274 = t33 + t48 + t83 + t148 + self.constants[22] + self.constants[31]
            + t20 * t167;
        let t276 = t274 + cos_theta * t169 - t62 * t173;
        let t280 = t154 + t157;
        let t281 = self.constants[4] * t280;
        let t283 = t100 * t163 + t281 - t95 * t182;
        let t289 = t88 - t127;
        let t295 = t251 * self.constants[7];
        let t299 = t230 * t239 - t204 * t241;
        let t303 = t230 * t235 - t204 * t223;
        let t306 = self.constants[0].like(1.0) / self.constants[5];
        let t310 = sin_delta * t95;
        let t314 = (t249 * t303 - t238 * t299) * t306 + cos_delta * t251
            - sin_delta * t100 - t262 * t310;
        let t316 = t314 * self.constants[8];
        let t322 = t54 + t127 + t148 + t184 * t251
            + t251 * (t184 + t251 * t276 - t262 * t283) + t251 * t295;
        let t326 = speeds[0]
            * (t322 + t314 * t316 - t261 * t262
                - t262 * (t261 + t251 * t283 - t262 * t289));
        let t328 = self.constants[32] + t79;
        let t334 = t100 * self.constants[10] - self.constants[9] * t95;
        let t336 = t222 + sin_phi * t334;
        let t338 = t100 * sin_phi;
        let t342 = t235 - t95 * self.constants[10] - self.constants[9] * t100;
        let t345 = t237 * (t95 * t336 + t338 * t342);
        let t353 = t197 * self.constants[5] + sin_phi * t212 + cos_phi * t219
            - cos_phi * t334;
        let t355 = t194 * t342 - t95 * t353;
        let t359 = t338 * t353 + t194 * t336;
        let t364 = t247 * (t204 * t355 + t230 * t359 + t243 * t345);
        let t366 = t345 - sin_phi * t364;
        let t368 = cos_phi * t364;
        let t371 = t100 * self.constants[4] * t157;
        let t372 = t159 + t371;
        let t376 = t372 + t276 * t366 - t283 * t368;
        let t380 = t100 * t328 - t95 * t115;
        let t384 = t380 + t283 * t366 - t289 * t368;
        let t397 = t306 * (t204 * t359 + t303 * t364 - t230 * t355 - t299 * t345)
            + cos_delta * t366;
        let t398 = t397 - t310 * t368;
        let t404 = t95 * t328 + t100 * t115 + t78 * self.constants[4] + t184 * t366
            + t251 * t376 + t295 * t366;
        let t407 = t404 + t316 * t398 - t261 * t368 - t262 * t384;
        let t415 = cos_theta * self.constants[54];
        let t418 = t13 * self.constants[55] + t39 * self.constants[56]
            - self.constants[11] * t415;
        let t424 = t9 * self.constants[55] + t13 * self.constants[56]
            - self.constants[12] * t415;
        let t429 = t20 * self.constants[54];
        let t431 = t62 * self.constants[54];
        let t436 = self.constants[4] * (t95 * t431 - t100 * t429);
        let t440 = t20 * self.constants[55] + self.constants[11] * t431
            - t62 * self.constants[56] - self.constants[12] * t429 - t436;
        let t444 = t100 * t418 - t95 * t424;
        let t449 = t95 * t418 + t100 * t424 + self.constants[4] * t415 + t251 * t440
            - t262 * t444;
        let t453 = self.constants[4] * t230 * t247;
        let t454 = sin_phi * t453;
        let t456 = cos_phi * t453;
        let t459 = t144 - self.constants[52];
        let t460 = self.constants[4] * t459;
        let t464 = t460 + t276 * t454 + t283 * t456;
        let t469 = t281 - t283 * t454 - t289 * t456;
        let t471 = self.constants[0].like(1.0) - t454;
        let t480 = t306 * (self.constants[4] * t204 + t303 * t453) - cos_delta * t454
            - t310 * t456;
        let t486 = t295 * t471 + t316 * t480 - t184 * t454 - t261 * t456 - t251 * t464
            - t262 * t469;
        let t497 = self.constants[7] * t366;
        let t499 = self.constants[8] * t398;
        let t505 = self.constants[32] + t366 * t376 + t366 * t372 + t366 * t497
            + t398 * t499 - t368 * t384;
        let t510 = t366 * t440 - t368 * t444;
        let t522 = t371 + t471 * t497 + t480 * t499 - t366 * t464 - t368 * t469
            - t372 * t454;
        let t523 = t522 - t380 * t456;
        let t527 = speeds[0] * t407 + speeds[1] * (t505 - t368 * t380) + speeds[2] * t510
            + speeds[3] * t523;
        let t536 = t436 + t440 * t454 + t444 * t456;
        let t558 = t454 * t464 + t454 * t460 + self.constants[58]
            + self.constants[7] * t471 * t471 + self.constants[8] * t480 * t480
            - t456 * t469;
        let t564 = speeds[3]
            * (speeds[0] * t486 + speeds[1] * t523 + speeds[3] * (t558 - t281 * t456)
                - speeds[2] * t536);
        let t565 = speeds[0]
            * (t326 + speeds[1] * t407 + speeds[2] * t449 + speeds[3] * t486)
            + speeds[1] * t527;
        let t566 = t565
            + speeds[2]
                * (speeds[0] * t449 + speeds[1] * t510 + speeds[2] * self.constants[57]
                    - speeds[3] * t536);
        let t569 = (t566 + t564) * self.constants[0].like(0.5);
        let t579 = positions[6] * positions[6] * self.constants[0].like(0.5)
            * self.constants[2] - self.constants[39] * (sin_phi * t280 + cos_phi * t459);
        [t569, t579]
    }

    fn contact_forces_unchecked(&self, positions: &[T; 9], speeds: &[T; 4], forces: &[T; 3]) -> [[T; 3]; 2] {
        let (
            sin_psi, cos_psi, sin_pitch, cos_pitch, t9, t13, sin_phi, cos_phi, sin_delta, cos_delta,
            t19, t24, t26, t29, t30, t31, t33, t34, t36, t43, t47, t48, t55, t58, t59, t64, t68,
            t71, t72, t73, t75, t77, t78, t82, t84, t91, t98, t102, t104, t106, t109, t111, t116,
            t120, t124, t127, t128, t130, t133, t138, t142, t143, t144, t145, t147, t149, t151,
            t153, t155, t158, t159, t160, t161, t163, t165, t166, t168, t169, t172, t173, t175,
            t177, t178, t181, t186, t188, t189, t192, t197, t199, t203, t204, t208, t209, t214,
            t216, t218, t221, t225, t228, t229, t238, t243, t246, t250, t258, t259, t261, t267,
            t271, t278, t282, t284, t287, t292, t298, t300, t304, t318, t322, t324, t329, t333,
            t335, t336, sin_theta, cos_theta, t342, t344, t346, t348, t349, t351, t356, t358, t361,
            t364, t367, t368, t371, t373, t375, t378, t380, t381, t384, t387, t390, t393, t396,
            t401, t403, t407, t411, t413, t419, t422, t428, t434, t436, t440, t442, t444, t450,
            t452, t458, t460, t466, t468, t471, t474, t480, t485, t487, t490, t493, t500, t505,
            t507, t509, t511, t523, t526, t532, t534, t537, t540, t542, t546, t552, t556, t559,
            t561, t564, t567, t573, t575, t576, t585, t590, t592, t601, t604, t606, t609, t616,
            t619, t622, t629, t632, t644, t650, t652, t655, t667, t669, t672, t675, t679, t687,
            t692, t695, t697, t704, t707, t713, t716, t724, t728, t734, t738, t745, t757, t762,
            t764, t775, t781, t783, t785, t792, t793, t796, t798, t800, t802, t806, t809, t811,
            t815, t819, t821, t825, t829, t836, t838, t845, t849, t855, t857, t862, t866, t876,
            t877, t882, t886,
        );
        (sin_psi, cos_psi) = positions[2].sin_cos();
        (sin_pitch, cos_pitch) = positions[4].sin_cos();
        t9 = self.constants[1] * sin_pitch + self.constants[0] * cos_pitch;
        t13 = self.constants[1] * cos_pitch - sin_pitch * self.constants[0];
        (sin_phi, cos_phi) = positions[3].sin_cos();
        (sin_delta, cos_delta) = positions[5].sin_cos();
        t19 = t9 * cos_phi;
        t24 = sin_phi * sin_delta - cos_delta * t19;
        t26 = t13 * cos_phi;
        t29 = (t24 * t24 + t26 * t26).sqrt();
        t30 = self.constants[0].like(1.0) / t29;
        t31 = t24 * t30;
        t33 = t26 * t30;
        t34 = cos_delta * t33;
        t36 = t13 * t34 - t9 * t31;
        t43 = cos_phi * sin_delta * t33 + sin_phi * (t13 * t31 + t9 * t34);
        t47 = cos_delta * sin_phi + t19 * sin_delta;
        t48 = self.constants[5] * t47;
        t55 = self.constants[9] + cos_delta * self.constants[16];
        t58 = t43 * t48 + t9 * self.constants[18] + t13 * t55;
        t59 = sin_phi * t58;
        t64 = sin_delta * self.constants[16];
        t68 = t13 * self.constants[18] - t9 * t55;
        t71 = cos_phi * t64 - t36 * t48 - sin_phi * t68;
        t72 = sin_phi * self.constants[4] + t71;
        t73 = sin_phi * t72;
        t75 = t36 * t59 + t43 * t73;
        t77 = self.constants[0].like(1.0) / (cos_phi * t58);
        t78 = t72 * t77;
        t82 = self.constants[0].like(1.0) / (t36 * t58 + t43 * t72);
        t84 = t75 * t78 * t82;
        t91 = t58 - t9 * self.constants[10] - t13 * self.constants[9];
        t98 = t13 * self.constants[10] - t9 * self.constants[9];
        t102 = t29 * self.constants[5] + sin_phi * t64 + cos_phi * t68 - cos_phi * t98;
        t104 = t26 * t91 - t9 * t102;
        t106 = t13 * sin_phi;
        t109 = t71 + sin_phi * t98;
        t111 = t102 * t106 + t26 * t109;
        t116 = t77 * (t9 * t109 + t91 * t106);
        t120 = t82 * (t36 * t104 + t43 * t111 + t75 * t116);
        t124 = t43 * self.constants[4] * t82;
        t127 = speeds[0] * t84 + speeds[1] * t120 + speeds[3] * t124;
        t128 = cos_phi * t127;
        t130 = speeds[0] * t13 + t9 * t128;
        t133 = t9 * speeds[0] - t13 * t128;
        t138 = t133 * self.constants[19] - t130 * self.constants[20];
        t142 = speeds[0] * t78 + speeds[1] * t116;
        t143 = sin_phi * t127;
        t144 = t142 - t143;
        t145 = self.constants[20] * t144;
        t147 = t130 * t138 - t144 * t145;
        t149 = speeds[0] * self.constants[4];
        t151 = speeds[3] + t142;
        t153 = self.constants[4] * t143;
        t155 = (t151 - t143) * t153 - speeds[0] * t149;
        t158 = t155 + cos_phi * self.constants[39];
        t159 = t13 * t158;
        t160 = t128 * t149;
        t161 = self.constants[10] * t144;
        t163 = self.constants[9] * t144;
        t165 = t133 * t161 + t130 * t163;
        t166 = speeds[0] * t143;
        t168 = t130 * t142;
        t169 = t13 * t166 + t168;
        t172 = t133 * t142;
        t173 = t9 * t166 + t172;
        t175 = t128 * t151;
        t177 = t128 * t153;
        t178 = t177 - self.constants[4] * t175;
        t181 = t165 + self.constants[9] * t169 + self.constants[10] * t173 - t178;
        t186 = self.constants[9] * t133 - self.constants[10] * t130;
        t188 = t144 * t163 + t133 * t186;
        t189 = speeds[0] * t128;
        t192 = t160 + self.constants[4] * t189;
        t197 = t13 * t192 + t9 * t155 - t188 - self.constants[10] * t189;
        t199 = speeds[1] + t133;
        t203 = cos_delta * t144 - sin_delta * t130;
        t204 = self.constants[17] * t203;
        t208 = cos_delta * t130 + sin_delta * t144;
        t209 = self.constants[16] * t203;
        t214 = speeds[1] * t203;
        t216 = t214 - cos_delta * t173 - sin_delta * t189;
        t218 = t31 * self.constants[5];
        t221 = t43 * t59 - t36 * t73;
        t225 = t43 * t58 - t36 * t72;
        t228 = self.constants[0].like(1.0) / self.constants[5];
        t229 = (t84 * t225 - t78 * t221) * t228;
        t238 = t228 * (t36 * t111 + t120 * t225 - t43 * t104 - t116 * t221);
        t243 = t228 * (t36 * self.constants[4] + t124 * t225);
        t246 = speeds[0] * t229 + speeds[1] * t238 + speeds[3] * t243;
        t250 = t33 * self.constants[5];
        t258 = t30 * t47 * (t31 * t208 + t33 * t199);
        t259 = t250 * t258;
        t261 = t218 * t258;
        t267 = cos_delta * t181 + t199 * t204 + t208 * t209 + self.constants[16] * t169
            + t218 * (t169 + t208 * t246) + t199 * t259;
        t271 = t267 + t208 * t261 - sin_delta * t197 - self.constants[17] * t216
            - t250 * (t216 - t199 * t246);
        t278 = self.constants[16] * t199 - self.constants[17] * t208;
        t282 = speeds[1] * t208;
        t284 = sin_delta * t173 - cos_delta * t189 - t282;
        t287 = t203 + t246;
        t292 = self.constants[5] * (t31 * t199 - t33 * t208);
        t298 = cos_delta * t197 + sin_delta * t181 + self.constants[17] * t284
            + t250 * t284 - t203 * t209 - t199 * t278;
        t300 = t298 - t261 * t287 - t199 * t292;
        t304 = t130 * t186 - t144 * t161;
        t318 = t304 + self.constants[9] * t189 + t9 * t192 + t208 * t278 + t208 * t292
            - t13 * t155;
        t322 = t318 - t203 * t204 - self.constants[16] * t284 - t218 * t284
            - t259 * t287;
        t324 = t31 * t300 + t33 * t322;
        t329 = t77 * (t47 * t271 + t29 * t324);
        t333 = t82 * (t29 * t271 + t75 * t329 - t47 * t324);
        t335 = t189 - t329;
        t336 = sin_phi * t333 + t335;
        (sin_theta, cos_theta) = positions[6].sin_cos();
        t342 = self.constants[0].like(1.0) - cos_theta;
        t344 = t342 * self.constants[14];
        t346 = self.constants[4] * t336 + t160;
        t348 = t9 * t158;
        t349 = t348 + t13 * t346;
        t351 = t144 * self.constants[11];
        t356 = t133 * self.constants[11] + t130 * self.constants[12];
        t358 = t144 * t351 + t133 * t356;
        t361 = t349 + t358 - t336 * self.constants[12];
        t364 = cos_theta + t342 * self.constants[13];
        t367 = self.constants[0] * sin_theta;
        t368 = t144 * self.constants[12];
        t371 = t133 * t368 - t130 * t351;
        t373 = t166 - cos_phi * t333;
        t375 = t168 + t13 * t373;
        t378 = t172 + t9 * t373;
        t380 = sin_phi * self.constants[39];
        t381 = t178 + t380;
        t384 = t371 + self.constants[12] * t378 - self.constants[11] * t375 - t381;
        t387 = t159 - t9 * t346;
        t390 = t130 * t356 + t144 * t368;
        t393 = t336 * self.constants[11] + t387 + t390;
        t396 = t361 * t364 + t367 * t384 - t393 * t344;
        t401 = self.constants[0] * speeds[2];
        t403 = self.constants[1] * sin_theta;
        t407 = cos_theta + t342 * self.constants[15];
        t411 = t401 + t130 * t344 + t133 * t407 - t144 * t403;
        t413 = self.constants[1] * speeds[2];
        t419 = t413 + t130 * t364 + t144 * t367 + t133 * t344;
        t422 = speeds[2] * (self.constants[1] * t411 - self.constants[0] * t419);
        t428 = t422 + t367 * t378 - t336 * cos_theta + t375 * t403;
        t434 = t144 * cos_theta + t133 * t403 - t130 * t367;
        t436 = t434 * self.constants[33];
        t440 = t411 * self.constants[33] - self.constants[34] * t419;
        t442 = t434 * t436 + t411 * t440;
        t444 = t396 * self.constants[6] + self.constants[34] * t428 - t442;
        t450 = cos_theta * t384 - t403 * t393 - t367 * t361;
        t452 = t434 * t413;
        t458 = t375 * t407 - t452 - t378 * t344 + t336 * t403;
        t460 = t434 * t401;
        t466 = t460 - t336 * t367 + t375 * t344 - t378 * t364;
        t468 = self.constants[34] * t434;
        t471 = t411 * t468 + t419 * t436;
        t474 = t450 * self.constants[6] + t458 * self.constants[33] + t471
            - self.constants[34] * t466;
        t480 = t361 * t344 - t393 * t407 - t384 * t403;
        t485 = t419 * t440 - t434 * t468;
        t487 = t480 * self.constants[6] + t485 - self.constants[33] * t428;
        t490 = t344 * t444 + t403 * t474 + t407 * t487;
        t493 = t304 - t387 + self.constants[9] * t336;
        t500 = sin_delta * t378 - cos_delta * t336 - t282;
        t505 = t199 * self.constants[27] - t208 * self.constants[28];
        t507 = t203 * self.constants[28];
        t509 = t208 * t505 - t203 * t507;
        t511 = t493 * self.constants[26] + t509 - self.constants[27] * t500;
        t523 = t364 * t444 + t344 * t487 - t367 * t474;
        t526 = t349 - self.constants[10] * t336 - t188;
        t532 = t165 + self.constants[9] * t375 + self.constants[10] * t378 - t381;
        t534 = cos_delta * t526 + sin_delta * t532;
        t537 = t203 * self.constants[27];
        t540 = t203 * t537 + t199 * t505;
        t542 = t534 * self.constants[26] + self.constants[28] * t500 - t540;
        t546 = cos_delta * t532 - sin_delta * t526;
        t552 = t214 - sin_delta * t336 - cos_delta * t378;
        t556 = t199 * t507 + t208 * t537;
        t559 = t546 * self.constants[26] + t375 * self.constants[27] + t556
            - self.constants[28] * t552;
        t561 = cos_delta * t542 - sin_delta * t559;
        t564 = self.constants[19] * t144;
        t567 = t144 * t564 + t133 * t138;
        t573 = t9
            * (t147 + t490 + t511 - self.constants[23] * t387
                + self.constants[19] * t336)
            + t13
                * (t523 + t561 + self.constants[23] * t349 - self.constants[20] * t336
                    - t567);
        t575 = t336 * self.constants[7] + self.constants[4] * t573;
        t576 = sin_phi * t124;
        t585 = t130 * self.constants[24] + t133 * self.constants[21];
        t590 = t130 * self.constants[21] + t133 * self.constants[25];
        t592 = t133 * t585 - t130 * t590;
        t601 = self.constants[36] * t419 + t411 * self.constants[38];
        t604 = t434 * self.constants[37];
        t606 = t434 * t601 - t411 * t604;
        t609 = self.constants[35] * t466 + self.constants[36] * t458 + t606
            - self.constants[34] * t450;
        t616 = self.constants[35] * t419 + self.constants[36] * t411;
        t619 = t411 * t616 - t419 * t601;
        t622 = self.constants[34] * t396 + self.constants[37] * t428 + t619
            - self.constants[33] * t480;
        t629 = t419 * t604 - t434 * t616;
        t632 = t450 * self.constants[33] + t466 * self.constants[36]
            + t458 * self.constants[38] + t629;
        t644 = t208 * self.constants[30] + t199 * self.constants[32];
        t650 = t203 * self.constants[31] + t287 * self.constants[8];
        t652 = t203 * t644 - t199 * t650;
        t655 = self.constants[29] * t552 + t375 * self.constants[30] + t652
            - self.constants[28] * t546;
        t667 = t228 * (t31 * t322 + t225 * t333 - t33 * t300 - t221 * t329);
        t669 = self.constants[8] * (t500 + t667);
        t672 = t208 * self.constants[29] + t199 * self.constants[30];
        t675 = t199 * t672 - t208 * t644;
        t679 = self.constants[28] * t534 + self.constants[31] * t500 + t669 + t675
            - self.constants[27] * t493;
        t687 = self.constants[20] * t349 + self.constants[19] * t387
            - t336 * self.constants[22] + t592 + t367 * t609 + cos_theta * t622;
        t692 = t687 + self.constants[12] * t523 + self.constants[11] * t490
            + sin_delta * t655 + cos_delta * t679 + self.constants[10] * t561;
        t695 = t692 - t575 - t403 * t632 - self.constants[9] * t511;
        t697 = cos_phi * t124;
        t704 = t144 * self.constants[22] + self.constants[7] * (speeds[3] + t144);
        t707 = t130 * t704 - t144 * t585;
        t713 = t208 * t650 - t203 * t672;
        t716 = t546 * self.constants[27] + t552 * self.constants[30]
            + t375 * self.constants[32] + t713;
        t724 = t367 * t444 + cos_theta * t474 - t403 * t487;
        t728 = sin_delta * t542 + cos_delta * t559;
        t734 = self.constants[25] * t375 + t707 + t716 + t344 * t609 + t403 * t622
            + t407 * t632;
        t738 = t734 + self.constants[9] * t728 - self.constants[19] * t381
            - self.constants[21] * t378 - self.constants[11] * t724;
        t745 = t144 * t590 - t133 * t704;
        t757 = self.constants[20] * t381 + self.constants[21] * t375 + t745 + t364 * t609
            + t344 * t632 + cos_delta * t655;
        t762 = t757 - self.constants[24] * t378 - t367 * t622 - self.constants[12] * t724
            - sin_delta * t679 - self.constants[10] * t728;
        t764 = t13 * t738 - t9 * t762;
        t775 = t133 * t145 + t130 * t564;
        t781 = self.constants[4]
            * (t724 + t728 + self.constants[19] * t375 + self.constants[20] * t378 + t775
                - self.constants[23] * t381);
        t783 = t78 - sin_phi * t84;
        t785 = cos_phi * t84;
        t792 = forces[0] + t764 * t785 - t9 * t738 - t13 * t762 - t781 - t695 * t783;
        t793 = t792 - t229 * t669;
        t796 = self.constants[35] * t344 + self.constants[36] * t407;
        t798 = t403 * self.constants[37];
        t800 = t344 * self.constants[36];
        t802 = t800 + t407 * self.constants[38];
        t806 = t367 * self.constants[33] - self.constants[34] * t403;
        t809 = sin_delta * self.constants[27];
        t811 = sin_delta * self.constants[30] - self.constants[10] * t809;
        t815 = t367 * t796 + cos_theta * t798 + t811 - t403 * t802
            - self.constants[12] * t806;
        t819 = t367 * self.constants[35] - t403 * self.constants[36];
        t821 = cos_theta * self.constants[37];
        t825 = t367 * self.constants[36] - t403 * self.constants[38];
        t829 = sin_delta * self.constants[45];
        t836 = t364 * t819 + t344 * t825 + self.constants[11] * t806 + cos_delta * t829
            - t367 * t821 - self.constants[9] * t809;
        t838 = t9 * t815 + t13 * t836;
        t845 = t344 * self.constants[33] + self.constants[34] * t407;
        t849 = t364 * self.constants[33] + self.constants[34] * t344;
        t855 = cos_delta * self.constants[27];
        t857 = cos_delta * self.constants[30] - self.constants[10] * t855;
        t862 = self.constants[21] + t364 * t796 + t344 * t802 + self.constants[11] * t845
            + self.constants[43] + t857;
        t866 = t862 - t367 * t798 - self.constants[12] * t849 - self.constants[48]
            - self.constants[49];
        t876 = sin_delta * t829;
        t877 = self.constants[12] * t845;
        t882 = t877 + t877 + self.constants[42] + self.constants[47];
        t886 = self.constants[24] + self.constants[29]
            + t364 * (t800 + self.constants[35] * t364)
            + t367 * t367 * self.constants[37]
            + t344 * (t364 * self.constants[36] + t344 * self.constants[38]);
        let (
            t888, t895, t896, t899, t904, t905, t906, t908, t909, t915, t922, t928, t932, t935,
            t939, t942, t948, t950, t955, t957, t960, t965, t966, t969, t971, t972, t975, t978,
            t984, t985, t991, t1010, t1013, t1014, t1015, t1018, t1020, t1021, t1023, t1026, t1028,
            t1031, t1035, t1039, t1044, t1045, t1060, t1064, t1065, t1071, t1073, t1074, t1086,
            t1089, t1099, t1102, t1104, t1107, t1117, t1121, t1124, t1130, t1132, t1143, t1144,
            t1151, t1152, t1162, t1163, t1164, t1178, t1179, t1185, t1206, t1211, t1216, t1220,
            t1226, t1234, t1238, t1239, t1241, t1243, t1248, t1253, t1256, t1259, t1262, t1265,
            t1267, t1272, t1278, t1281, t1285, t1288, t1295, t1298, t1304, t1313, t1322, t1326,
            t1332, t1336, t1339, t1343, t1351, t1354, t1360, t1362, t1366, t1370, t1372, t1377,
            t1381, t1383, t1387, t1389, t1397, t1398, t1409, t1416, t1423, t1432, t1440, t1449,
            t1454, t1458, t1473, t1477, t1484, t1489, t1506, t1511, t1516, t1518, t1520, t1521,
            t1526, t1534, t1538, t1541, t1543, t1546, t1551, t1555, t1558, t1561, t1562,
        );
        t888 = t886 + t882 - t876;
        t895 = self.constants[9] * t855;
        t896 = self.constants[11] * t849 - t895;
        t899 = self.constants[44] + self.constants[50] - t896 - t896;
        t904 = self.constants[25] + self.constants[32] + t344 * t796 + t403 * t798
            + t407 * t802 + t899;
        t905 = t904 - t888;
        t906 = t9 * t13;
        t908 = t9 * t9;
        t909 = t866 + t866;
        t915 = self.constants[20] + t845 + self.constants[41] + self.constants[51];
        t922 = self.constants[19] + t849 + t855 + self.constants[46]
            - self.constants[40];
        t928 = t866 + t905 * t906 + self.constants[4] * (t9 * t915 + t13 * t922)
            - t908 * t909;
        t932 = t13 * t915 - t9 * t922;
        t935 = self.constants[4] * (t932 - self.constants[52]);
        t939 = self.constants[4] * t932;
        t942 = self.constants[53] - t939 - t939;
        t948 = self.constants[22] + self.constants[31] + t876 + t882 + t899 + t367 * t819
            + cos_theta * t821;
        t950 = t948 + t942 - t403 * t825;
        t955 = self.constants[4] * (t806 + t809);
        t957 = t13 * t815 + t955 - t9 * t836;
        t960 = t935 + t576 * t950 + t697 * t957;
        t965 = t905 * t908 + t906 * t909;
        t966 = t904 - t965;
        t969 = t955 - t576 * t957 - t697 * t966;
        t971 = self.constants[0].like(1.0) - t576;
        t972 = self.constants[7] * t783;
        t975 = t9 * sin_delta;
        t978 = t243 - cos_delta * t576 - t697 * t975;
        t984 = t229 + cos_delta * t783 - t13 * sin_delta - t785 * t975;
        t985 = self.constants[8] * t984;
        t991 = t971 * t972 + t978 * t985 - t576 * t838 - t697 * t928 - t783 * t960
            - t785 * t969;
        t1010 = t888 + t942 + t965 + t783 * t838
            + t783 * (t838 + t783 * t950 - t785 * t957) + t783 * t972;
        t1013 = t1010 + t984 * t985 - t785 * t928
            - t785 * (t928 + t783 * t957 - t785 * t966);
        t1014 = self.constants[0].like(1.0) / t1013;
        t1015 = t991 * t1014;
        t1018 = t116 - sin_phi * t120;
        t1020 = t13 * self.constants[4] * t809;
        t1021 = t811 + t1020;
        t1023 = cos_phi * t120;
        t1026 = t1021 + t950 * t1018 - t957 * t1023;
        t1028 = self.constants[32] + t895;
        t1031 = t13 * t1028 - t9 * t857;
        t1035 = t1031 + t957 * t1018 - t966 * t1023;
        t1039 = self.constants[7] * t1018;
        t1044 = t238 + cos_delta * t1018 - t975 * t1023;
        t1045 = self.constants[8] * t1044;
        t1060 = t9 * t1028 + t13 * t857 + self.constants[4] * t855 + t838 * t1018
            + t783 * t1026 + t972 * t1018;
        t1064 = t1014 * (t1060 + t985 * t1044 - t928 * t1023 - t785 * t1035);
        t1065 = t1013 * t1064;
        t1071 = self.constants[32] + t1018 * t1026 + t1018 * t1021 + t1018 * t1039
            + t1044 * t1045 - t1023 * t1035;
        t1073 = t1071 - t1023 * t1031 - t1064 * t1065;
        t1074 = self.constants[0].like(1.0) / t1073;
        t1086 = t1020 + t971 * t1039 + t978 * t1045 - t960 * t1018 - t969 * t1023
            - t576 * t1021;
        t1089 = t1074 * (t1086 - t697 * t1031 - t1015 * t1065);
        t1099 = forces[1] + t764 * t1023 - t716 - t695 * t1018 - t238 * t669
            - t793 * t1064;
        t1102 = t403 * self.constants[54];
        t1104 = t367 * self.constants[54];
        t1107 = self.constants[4] * (t9 * t1102 - t13 * t1104);
        t1117 = t367 * self.constants[55] + self.constants[11] * t1102 - t1107
            - t403 * self.constants[56] - self.constants[12] * t1104;
        t1121 = cos_theta * self.constants[54];
        t1124 = t344 * self.constants[55] + t407 * self.constants[56]
            - self.constants[11] * t1121;
        t1130 = t364 * self.constants[55] + t344 * self.constants[56]
            - self.constants[12] * t1121;
        t1132 = t13 * t1124 - t9 * t1130;
        t1143 = t1014
            * (t9 * t1124 + t13 * t1130 + self.constants[4] * t1121 + t783 * t1117
                - t785 * t1132);
        t1144 = t1013 * t1143;
        t1151 = t1074 * (t1018 * t1117 - t1023 * t1132 - t1065 * t1143);
        t1152 = t1073 * t1151;
        t1162 = self.constants[57] - t1143 * t1144 - t1151 * t1152;
        t1163 = self.constants[0].like(1.0) / t1162;
        t1164 = (t1107 + t576 * t1117 + t697 * t1132 + t1015 * t1144 + t1089 * t1152)
            * t1163;
        t1178 = forces[2] - self.constants[1] * t609 - self.constants[0] * t632
            - positions[6] * self.constants[2] - speeds[2] * self.constants[3]
            - t793 * t1143;
        t1179 = t1178 - t1099 * t1151;
        t1185 = t576 * t695 + t697 * t764 + t1164 * t1179 + t575 - t243 * t669
            - t793 * t1015;
        t1206 = t576 * t960 + t576 * t935 + self.constants[58]
            + self.constants[7] * t971 * t971 + self.constants[8] * t978 * t978
            - t697 * t969;
        t1211 = (t1185 - t1089 * t1099)
            / (t1206 - t697 * t955 - t1013 * t1015 * t1015 - t1073 * t1089 * t1089
                - t1162 * t1164 * t1164);
        t1216 = t1163 * t1179 + t1164 * t1211;
        t1220 = t1074 * t1099 - t1151 * t1216 - t1089 * t1211;
        t1226 = t793 * t1014 - t1064 * t1220 - t1143 * t1216 - t1015 * t1211;
        t1234 = t333 + t84 * t1226 + t120 * t1220 + t124 * t1211;
        t1238 = t78 * t1226 + t116 * t1220 - sin_phi * t1234 - t335;
        t1239 = t1211 + t1238;
        t1241 = self.constants[4] * t1239 - t160;
        t1243 = t159 + t9 * t1241;
        t1248 = t304 - t1243 - self.constants[9] * t1238;
        t1253 = t166 - cos_phi * t1234;
        t1256 = t13 * t1226 - t172 - t9 * t1253;
        t1259 = cos_delta * t1238 - t282 - sin_delta * t1256;
        t1262 = t509 + self.constants[26] * t1248 - self.constants[27] * t1259;
        t1265 = t348 - t13 * t1241;
        t1267 = t358 + self.constants[12] * t1238 + t1265;
        t1272 = t168 + t13 * t1253 + t9 * t1226;
        t1278 = t177 + t380 - self.constants[4] * (t175 + t1226);
        t1281 = t371 - self.constants[11] * t1272 - self.constants[12] * t1256 - t1278;
        t1285 = self.constants[11] * t1238 - t390 - t1243;
        t1288 = t364 * t1267 + t367 * t1281 + t344 * t1285;
        t1295 = t422 + cos_theta * t1238 + t403 * t1272 - t367 * t1256;
        t1298 = self.constants[6] * t1288 + self.constants[34] * t1295 - t442;
        t1304 = cos_theta * t1281 + t403 * t1285 - t367 * t1267;
        t1313 = t344 * t1256 + t407 * t1272 + self.constants[0] * t1216 - t452
            - t403 * t1238;
        t1322 = t460 + t364 * t1256 + t367 * t1238 + t344 * t1272
            + self.constants[1] * t1216;
        t1326 = t471 + self.constants[6] * t1304 + self.constants[33] * t1313
            - self.constants[34] * t1322;
        t1332 = t344 * t1267 + t407 * t1285 - t403 * t1281;
        t1336 = t485 + self.constants[6] * t1332 - self.constants[33] * t1295;
        t1339 = t344 * t1298 + t403 * t1326 + t407 * t1336;
        t1343 = t147 + t1262 + t1339 - self.constants[23] * t1243
            - self.constants[19] * t1238;
        t1351 = t364 * t1298 + t344 * t1336 - t367 * t1326;
        t1354 = t1265 + self.constants[10] * t1238 - t188;
        t1360 = t165 + self.constants[9] * t1272 - t1278 - self.constants[10] * t1256;
        t1362 = cos_delta * t1354 + sin_delta * t1360;
        t1366 = self.constants[26] * t1362 + self.constants[28] * t1259 - t540;
        t1370 = cos_delta * t1360 - sin_delta * t1354;
        t1372 = t1220 + t1272;
        t1377 = t214 + cos_delta * t1256 + sin_delta * t1238;
        t1381 = t556 + self.constants[26] * t1370 + self.constants[27] * t1372
            - self.constants[28] * t1377;
        t1383 = cos_delta * t1366 - sin_delta * t1381;
        t1387 = self.constants[23] * t1265 + self.constants[20] * t1238 + t1351 + t1383
            - t567;
        t1389 = t9 * t1343 + t13 * t1387;
        t1397 = self.constants[8]
            * (t667 + t1259 + t229 * t1226 + t238 * t1220 + t243 * t1211);
        t1398 = t228 * t1397;
        t1409 = t606 + self.constants[35] * t1322 + self.constants[36] * t1313
            - self.constants[34] * t1304;
        t1416 = t619 + self.constants[34] * t1288 + self.constants[37] * t1295
            - self.constants[33] * t1332;
        t1423 = t629 + self.constants[33] * t1304 + self.constants[36] * t1322
            + self.constants[38] * t1313;
        t1432 = t652 + self.constants[29] * t1377 + self.constants[30] * t1372
            - self.constants[28] * t1370;
        t1440 = t675 + t1397 + self.constants[28] * t1362 + self.constants[31] * t1259
            - self.constants[27] * t1248;
        t1449 = t592 + self.constants[20] * t1265 + self.constants[19] * t1243
            + self.constants[22] * t1238 + self.constants[7] * t1239 + t367 * t1409;
        t1454 = t1449 + cos_theta * t1416 + self.constants[12] * t1351
            + self.constants[11] * t1339 + sin_delta * t1432 + cos_delta * t1440;
        t1458 = t1454 + self.constants[10] * t1383 - t403 * t1423
            - self.constants[9] * t1262 - self.constants[4] * t1389;
        t1473 = t367 * t1298 + cos_theta * t1326 - t403 * t1336;
        t1477 = sin_delta * t1366 + cos_delta * t1381;
        t1484 = t707 + t713 + self.constants[21] * t1256 + self.constants[25] * t1272
            + self.constants[27] * t1370 + self.constants[30] * t1377
            + self.constants[32] * t1372;
        t1489 = t1484 + t344 * t1409 + t403 * t1416 + t407 * t1423
            + self.constants[9] * t1477 - self.constants[19] * t1278;
        t1506 = t745 + self.constants[20] * t1278 + self.constants[24] * t1256
            + self.constants[21] * t1272 + t364 * t1409 + t344 * t1423;
        t1511 = t1506 + cos_delta * t1432 - t367 * t1416 - self.constants[12] * t1473
            - sin_delta * t1440 - self.constants[10] * t1477;
        t1516 = sin_phi * t1458
            + cos_phi * (t13 * (t1489 - self.constants[11] * t1473) - t9 * t1511);
        t1518 = t82 * (t1516 - t225 * t1398);
        t1520 = t36 * t1398 - t43 * t1518;
        t1521 = t1389 - t1520;
        t1526 = t43 * t1398 + t36 * t1518;
        t1534 = t775 + t1473 + t1477 + self.constants[19] * t1272
            - self.constants[23] * t1278 - self.constants[20] * t1256;
        t1538 = t13 * t1343 - t9 * t1387;
        t1541 = cos_phi * t1534 - t1526 - sin_phi * t1538;
        t1543 = cos_psi * t1521 - sin_psi * t1541;
        t1546 = t1521 * sin_psi + cos_psi * t1541;
        t1551 = t77 * (t1458 - t75 * t1518 - t221 * t1398);
        t1555 = t1551 + sin_phi * t1534 + cos_phi * t1538;
        t1558 = cos_psi * t1520 - sin_psi * t1526;
        t1561 = t1520 * sin_psi + cos_psi * t1526;
        t1562 = -t1551;
        [[t1543, t1546, t1555], [t1558, t1561, t1562]]
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

    fn nonlinear(&self) -> Option<impl carvallo::motion::Motion<Scalar = Self::Scalar>> {
        Some(self.motion())
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
