// @generated from generated/models/whipple_leaning.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 3110f099e4d2a018

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    MotionFormulas, Nonlinear, Number, ParameterError, ParameterInfo, Partial, Rate,
    Rows, Scalar, SetInfo, WithDerivatives,
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
    /// 53 additions, 55 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 115 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleLeaningMatrices<T> {
        let t2 = self.zB * self.mB;
        let t7 = self.zH * self.mH;
        let t15 = self.rR * self.mR;
        let ay_theta3_delta = self.IUxx + self.rR * t15;
        let t21 = self.rF * self.mF;
        let t25 = self.IFxx + (self.rF * t21 + self.IHxx);
        let t28 = self.zU * self.mU;
        let M_11 = self.zB * t2 + (self.IRxx + self.zH * t7)
            + (self.IBxx + (ay_theta3_delta + (t25 + self.zU * t28)));
        let (wx_delta2_delta, cos_lam) = self.lam.sin_cos();
        let yaw_per_v_delta = cos_lam / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let t48 = t28 * self.xU - (self.IUxz + self.IBxz - t2 * self.xB);
        let wz_delta2_delta = cos_lam + yaw_by_delta;
        let t58 = self.zH * wx_delta2_delta + cos_lam * (self.c + self.w)
            - self.xH * wz_delta2_delta;
        let t59 = self.mH * t58;
        let t63 = wz_delta2_delta * self.IHxz;
        let t65 = t63 + t25 * wx_delta2_delta;
        let t67 = self.zP - self.zU;
        let M_13 = self.IUxx - t28 * t67;
        let t72 = wz_delta2_delta * (self.IFxx + self.IHzz);
        let h_wheels_all = self.mU * self.xU;
        let t83 = self.mB * self.xB;
        let vy_theta3_delta = t83 * self.xB;
        let t88 = yaw_by_delta
            * (self.xU * h_wheels_all + self.IUzz
                + (self.IBzz + (self.IRxx + vy_theta3_delta)));
        let M_22 = wz_delta2_delta * t72 + wx_delta2_delta * (t63 + t65)
            + (t58 * t59 + yaw_by_delta * t88);
        let t93 = self.IUxz + h_wheels_all * t67;
        let M_23 = t93 * yaw_by_delta;
        let t95 = self.mU * t67;
        let M_33 = self.IUxx + t95 * t67;
        let zero = self.w.like(0.0);
        let t101 = self.IHxz + t21 * self.w;
        let t105 = self.IRyy / self.rR;
        let K0_11 = t2 + t28 + (t7 - t21) - t15;
        let t110 = t105 - K0_11;
        let vy_spin_F5_delta = self.c * t110;
        let h_spin_F = self.IFyy / self.rF;
        let t117 = wz_delta2_delta * h_spin_F;
        let C1_12 = (t101 - t7 * self.xH - (t48 - vy_spin_F5_delta)) * yaw_per_v_delta
            + t117;
        let ay_all1_delta = t83 + h_wheels_all;
        let K0_12 = t59 - yaw_by_delta * ay_all1_delta - t21 * wx_delta2_delta;
        let C1_22 = yaw_per_v_delta
            * (t101 * wx_delta2_delta - self.xH * t59 + (t72 + (t88 - self.c * K0_12)));
        let C1_32 = (t93 + self.c * t95) * yaw_per_v_delta;
        let K0_22 = wx_delta2_delta * K0_12;
        let K2_12 = yaw_per_v_delta * (h_spin_F + t110);
        let ay_delta2_delta = wx_delta2_delta * h_spin_F - K0_12;
        let K2_22 = yaw_per_v_delta * ay_delta2_delta;
        let K2_32 = yaw_per_v_delta * t95;
        let M_12 = t65 - (yaw_by_delta * t48 - self.zH * t59);
        let C1_21 = -(t117 + yaw_by_delta * t105);
        let K0_13 = -t95;
        WhippleLeaningMatrices::from_entries([
            M_11, M_12, M_13, M_12, M_22, M_23, M_13, M_23, M_33, zero, zero, zero, zero, zero,
            zero, zero, zero, self.dU, zero, C1_12, zero, C1_21, C1_22, zero, zero, C1_32, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, self.kU, K0_11, K0_12, K0_13, K0_12,
            K0_22, zero, K0_13, zero, K0_13, zero, K2_12, zero, zero, K2_22, zero, zero, K2_32,
            zero,
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
/// - linearization: 2462 additions, 3163 multiplications, 8 divisions, 18 negations, 1 square root and 10 trigonometric functions: 5662 operations
/// - by parameters: 3860 additions, 4869 multiplications, 8 divisions, 5 negations, 1 square root and 10 trigonometric functions: 8753 operations
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleLeaningMotion<T = f64> {
    constants: [T; 80],
}

impl<T: Number> WhippleLeaning<T> {
    /// The nonlinear equations of motion, of what is computed once for these parameters:
    /// 74 additions, 103 multiplications and 2 trigonometric functions: 179 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn motion(&self) -> WhippleLeaningMotion<T> {
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t31 = self.w + self.c;
        let t34 = cos_lam * t31 - sin_lam * self.rR;
        let t37 = sin_lam * t31 + cos_lam * self.rR;
        let t38 = self.zP + self.rR;
        let t39 = sin_lam * t38;
        let t40 = cos_lam * t38;
        let t41 = cos_lam * cos_lam;
        let t42 = sin_lam * cos_lam;
        let t43 = sin_lam * sin_lam;
        let t44 = self.w - t31;
        let t47 = cos_lam * t44 + sin_lam * self.rF;
        let t50 = sin_lam * t44 - cos_lam * self.rF;
        let t51 = t37 + t50;
        let t53 = self.rR + self.zB;
        let t55 = cos_lam * self.xB - sin_lam * t53;
        let t56 = self.mB * t55;
        let t59 = sin_lam * self.xB + cos_lam * t53;
        let t60 = self.mB * t59;
        let t62 = cos_lam * self.IBxz;
        let t63 = sin_lam * self.IBxx + t62;
        let t65 = sin_lam * self.IBxz;
        let t67 = t65 + cos_lam * self.IBzz;
        let t71 = cos_lam * t63 - sin_lam * t67 - t56 * t59;
        let t73 = t59 * t60;
        let t74 = t55 * t56;
        let t76 = self.IByy + t73 + t74;
        let t78 = self.mB + self.mR;
        let t88 = t73 + self.IRxx + cos_lam * (cos_lam * self.IBxx - t65)
            - sin_lam * (t62 - sin_lam * self.IBzz);
        let t93 = t74 + self.IRxx + sin_lam * t63 + cos_lam * t67;
        let t94 = self.mH + self.mF;
        let t95 = self.xH - t31;
        let t98 = cos_lam * t95 - sin_lam * self.zH;
        let t99 = self.mH * t98;
        let t100 = self.mF * t47;
        let t101 = t99 + t100;
        let t104 = sin_lam * t95 + cos_lam * self.zH;
        let t105 = self.mH * t104;
        let t106 = self.mF * t50;
        let t107 = t105 + t106;
        let t110 = sin_lam * self.IHxz;
        let t113 = cos_lam * self.IHxz;
        let t119 = t104 * t105 + t50 * t106;
        let t122 = self.IFxx + cos_lam * (cos_lam * self.IHxx - t110) + t119
            - sin_lam * (t113 - sin_lam * self.IHzz);
        let t124 = t113 + sin_lam * self.IHxx;
        let t127 = t110 + cos_lam * self.IHzz;
        let t133 = cos_lam * t124 - sin_lam * t127 - t99 * t104 - t50 * t100;
        let t137 = t98 * t99 + t47 * t100;
        let t139 = t119 + self.IHyy + t137;
        let t144 = self.IFxx + t137 + sin_lam * t124 + cos_lam * t127;
        let t146 = self.zU - self.zP;
        let t148 = cos_lam * self.xU - sin_lam * t146;
        let t149 = self.mU * t148;
        let t152 = sin_lam * self.xU + cos_lam * t146;
        let t153 = self.mU * t152;
        let t155 = sin_lam * self.IUxz;
        let t158 = cos_lam * self.IUxz;
        let t162 = t152 * t153;
        let t164 = cos_lam * (cos_lam * self.IUxx - t155) + t162
            - sin_lam * (t158 - sin_lam * self.IUzz);
        let t166 = t158 + sin_lam * self.IUxx;
        let t169 = t155 + cos_lam * self.IUzz;
        let t173 = cos_lam * t166 - sin_lam * t169 - t149 * t152;
        let t175 = t148 * t149;
        let t177 = t162 + self.IUyy + t175;
        let t181 = t175 + sin_lam * t166 + cos_lam * t169;
        let t183 = self.mU * t39;
        let t184 = self.mU * t40;
        let t185 = t40 * t184;
        let t186 = t40 * t183;
        let t187 = t39 * t183;
        let t188 = t122 - t139;
        let t189 = t34 * t94;
        let t190 = t37 * t107;
        let t191 = t37 * t94;
        let t194 = t190 + t190 + t37 * t191;
        let t195 = t34 * t107;
        let t196 = t37 * t189;
        let t197 = t34 * t189;
        let t198 = t107 + t191;
        let t201 = self.rR * (self.mU + t78 + t94);
        let t202 = self.rR * t201;
        let t205 = sin_lam * t149 - cos_lam * t153;
        let t208 = cos_lam * t164 + sin_lam * t173;
        let t211 = cos_lam * t173 + sin_lam * t181;
        let t214 = cos_lam * t208 + sin_lam * t211;
        WhippleLeaningMotion {
            constants: [
                self.w, self.c, sin_lam, cos_lam, self.zP, self.kU, self.dU, self.rR, self.rF,
                self.IBxx, self.IBxz, self.IBzz, self.mB, self.xB, self.zB, self.IHxx, self.IHxz,
                self.IHzz, self.mH, self.xH, self.zH, self.IUxx, self.IUxz, self.IUzz, self.mU,
                self.xU, self.zU, self.IRyy, self.IFyy, self.mF, t34, t37, t39, t40, t41, t42, t43,
                t47, t50, t51, t56, t60, t71, t76, t78, t88, t93, t94, t101, t107, t122, t133, t139,
                t144, t149, t153, t164, t173, t177, t181, self.g, t183, t184, t185, t186, t187,
                t188, t189, t194, t195, t196, t197, t198, t201, t202, t205, t208, t211, t214, t202,
            ],
        }
    }
}

impl<T: Scalar> Nonlinear<3> for WhippleLeaning<T> {
    type Motion = WhippleLeaningMotion<T>;

    type MotionOver<U: Number> = WhippleLeaningMotion<U>;

    fn motion(&self) -> WhippleLeaningMotion<T> {
        WhippleLeaning::motion(self)
    }

    #[inline(always)]
    fn motion_over<U: Number>(model: &WhippleLeaning<U>) -> WhippleLeaningMotion<U> {
        WhippleLeaning::motion(model)
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
                name: "Tphi", label: "lean torque", unit: "N*m", position: "phi",
            },
            carvallo::motion::AppliedInfo {
                name: "Tdelta", label: "steer torque", unit: "N*m", position: "delta",
            },
            carvallo::motion::AppliedInfo {
                name: "Ttheta", label: "hip torque", unit: "N*m", position: "theta",
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

    fn linearize_into(
        &self, positions: &[T; 9], speeds: &[T; 4], forces: &[T; 3], a: &mut [T], b: &mut [T],
    ) -> Option<Result<(), carvallo::motion::MotionError>> {
        let found = carvallo::motion::Linearizable::linearize(self, positions, speeds, forces);
        Some(found.map(|found| carvallo::motion::Linearization::copy_into(&found, a, b)))
    }
}

#[allow(unused_variables)]
impl<T: Number> carvallo::motion::Unchecked for WhippleLeaningMotion<T> {
    type Scalar = T;

    type Positions = [T; 9];

    type Speeds = [T; 4];

    type Dependent = [T; 1];

    type Forces = [T; 3];

    type ContactForces = [[T; 3]; 2];

    #[inline(always)]
    fn closure_unchecked(&self, positions: &[T; 9]) -> ([T; 1], [T; 1]) {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t14 = self.constants[3] * sin_pitch + self.constants[2] * cos_pitch;
        let t15 = cos_phi * t14;
        let t19 = sin_phi * sin_delta;
        let t20 = t19 - cos_delta * t15;
        let t24 = self.constants[3] * cos_pitch - sin_pitch * self.constants[2];
        let t25 = cos_phi * t24;
        let t28 = (t20 * t20 + t25 * t25).sqrt();
        let t36 = self.constants[30] + cos_delta * self.constants[37];
        let t42 = self.constants[8] * t28 + t19 * self.constants[37]
            + cos_phi * (t24 * self.constants[39] - t14 * t36)
            - self.constants[7] * cos_phi;
        let t46 = self.constants[0].like(1.0) / t28;
        let t47 = t25 * t46;
        let t58 = self.constants[8] * (cos_delta * sin_phi + t15 * sin_delta)
            * (cos_phi * sin_delta * t47
                + sin_phi * (t20 * t24 * t46 + cos_delta * t14 * t47));
        let t64 = t42 / (cos_phi * (t58 + t14 * self.constants[39] + t24 * t36));
        ([t42], [t64])
    }

    #[inline(always)]
    fn rates_unchecked(&self, positions: &[T; 9], speeds: &[T; 4]) -> [T; 9] {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t13 = self.constants[3] * sin_pitch + self.constants[2] * cos_pitch;
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t17 = t13 * cos_phi;
        let t21 = sin_phi * sin_delta - cos_delta * t17;
        let t25 = self.constants[3] * cos_pitch - sin_pitch * self.constants[2];
        let t26 = cos_phi * t25;
        let t29 = (t21 * t21 + t26 * t26).sqrt();
        let t30 = self.constants[0].like(1.0) / t29;
        let t31 = t21 * t30;
        let t33 = t26 * t30;
        let t34 = cos_delta * t33;
        let t36 = t25 * t34 - t13 * t31;
        let t41 = self.constants[8] * (sin_phi * cos_delta + t17 * sin_delta);
        let t44 = sin_delta * self.constants[37];
        let t50 = self.constants[30] + cos_delta * self.constants[37];
        let t52 = t25 * self.constants[39] - t13 * t50;
        let t55 = cos_phi * t44 - t36 * t41 - sin_phi * t52;
        let t56 = self.constants[7] * sin_phi + t55;
        let t63 = cos_phi * sin_delta * t33 + sin_phi * (t25 * t31 + t13 * t34);
        let t68 = t41 * t63 + t13 * self.constants[39] + t25 * t50;
        let t70 = self.constants[0].like(1.0) / (cos_phi * t68);
        let t71 = t56 * t70;
        let t77 = t25 * self.constants[31] - t13 * self.constants[30];
        let t79 = t55 + sin_phi * t77;
        let t81 = sin_phi * t25;
        let t85 = t68 - t13 * self.constants[31] - t25 * self.constants[30];
        let t88 = t70 * (t13 * t79 + t81 * t85);
        let t90 = speeds[0] * t71 + speeds[1] * t88;
        let t92 = self.constants[7] * (speeds[3] + t90);
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let t98 = sin_phi * t68;
        let t100 = sin_phi * t56;
        let t102 = t36 * t98 + t63 * t100;
        let t106 = self.constants[0].like(1.0) / (t36 * t68 + t56 * t63);
        let t108 = t71 * t102 * t106;
        let t117 = t29 * self.constants[8] + sin_phi * t44 + cos_phi * t52
            - cos_phi * t77;
        let t119 = t26 * t85 - t13 * t117;
        let t123 = t81 * t117 + t26 * t79;
        let t128 = t106 * (t36 * t119 + t63 * t123 + t88 * t102);
        let t131 = self.constants[7] * t63 * t106;
        let t138 = t63 * t98 - t36 * t100;
        let t142 = t63 * t68 - t36 * t56;
        let t145 = self.constants[0].like(1.0) / self.constants[8];
        let t162 = speeds[0] * (t108 * t142 - t71 * t138) * t145
            + speeds[1] * t145 * (t36 * t123 + t128 * t142 - t63 * t119 - t88 * t138);
        let t163 = t162 + speeds[3] * t145 * (self.constants[7] * t36 + t131 * t142);
        let t164 = -(t92 * cos_psi);
        let t165 = -(t92 * sin_psi);
        let t166 = -(speeds[0] * t108 + speeds[1] * t128 + speeds[3] * t131);
        [t164, t165, t166, speeds[0], t90, speeds[1], speeds[2], speeds[3], t163]
    }

    #[inline(always)]
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
        t13 = self.constants[3] * sin_pitch + self.constants[2] * cos_pitch;
        (sin_delta, cos_delta) = positions[5].sin_cos();
        t17 = t13 * cos_phi;
        t21 = sin_phi * sin_delta - cos_delta * t17;
        t25 = self.constants[3] * cos_pitch - sin_pitch * self.constants[2];
        t26 = cos_phi * t25;
        t29 = (t21 * t21 + t26 * t26).sqrt();
        t30 = self.constants[0].like(1.0) / t29;
        t31 = t21 * t30;
        t33 = t26 * t30;
        t34 = cos_delta * t33;
        t36 = t25 * t34 - t13 * t31;
        t40 = sin_phi * cos_delta + t17 * sin_delta;
        t41 = self.constants[8] * t40;
        t44 = sin_delta * self.constants[37];
        t50 = self.constants[30] + cos_delta * self.constants[37];
        t52 = t25 * self.constants[39] - t13 * t50;
        t55 = cos_phi * t44 - t36 * t41 - sin_phi * t52;
        t56 = self.constants[7] * sin_phi + t55;
        t63 = cos_phi * sin_delta * t33 + sin_phi * (t25 * t31 + t13 * t34);
        t68 = t41 * t63 + t13 * self.constants[39] + t25 * t50;
        t70 = self.constants[0].like(1.0) / (cos_phi * t68);
        t71 = t56 * t70;
        t77 = t25 * self.constants[31] - t13 * self.constants[30];
        t79 = t55 + sin_phi * t77;
        t81 = sin_phi * t25;
        t85 = t68 - t13 * self.constants[31] - t25 * self.constants[30];
        t88 = t70 * (t13 * t79 + t81 * t85);
        t90 = speeds[0] * t71 + speeds[1] * t88;
        t91 = speeds[3] + t90;
        t92 = self.constants[7] * t91;
        (sin_psi, cos_psi) = positions[2].sin_cos();
        t98 = sin_phi * t68;
        t100 = sin_phi * t56;
        t102 = t36 * t98 + t63 * t100;
        t106 = self.constants[0].like(1.0) / (t36 * t68 + t56 * t63);
        t108 = t71 * t102 * t106;
        t117 = t29 * self.constants[8] + sin_phi * t44 + cos_phi * t52 - cos_phi * t77;
        t119 = t26 * t85 - t13 * t117;
        t123 = t81 * t117 + t26 * t79;
        t128 = t106 * (t36 * t119 + t63 * t123 + t88 * t102);
        t131 = self.constants[7] * t63 * t106;
        t134 = speeds[0] * t108 + speeds[1] * t128 + speeds[3] * t131;
        t138 = t63 * t98 - t36 * t100;
        t142 = t63 * t68 - t36 * t56;
        t145 = self.constants[0].like(1.0) / self.constants[8];
        t146 = (t108 * t142 - t71 * t138) * t145;
        t155 = t145 * (t36 * t123 + t128 * t142 - t63 * t119 - t88 * t138);
        t160 = t145 * (self.constants[7] * t36 + t131 * t142);
        t163 = speeds[0] * t146 + speeds[1] * t155 + speeds[3] * t160;
        t166 = cos_phi * t134;
        t168 = sin_phi * t134;
        t169 = self.constants[7] * t168;
        t171 = t166 * t169 - t92 * t166;
        t174 = t171 + sin_phi * self.constants[60];
        t179 = speeds[0] * t13 - t25 * t166;
        t180 = t90 * t179;
        t181 = speeds[0] * t168;
        t182 = t90 - t168;
        t183 = self.constants[31] * t182;
        t187 = speeds[0] * t25 + t13 * t166;
        t188 = self.constants[30] * t182;
        t190 = t179 * t183 + t187 * t188;
        t192 = t90 * t187;
        t193 = t25 * t181 + t192;
        t196 = t180 + t13 * t181;
        t200 = t190 + self.constants[30] * t193 + self.constants[31] * t196 - t171;
        t205 = self.constants[30] * t179 - self.constants[31] * t187;
        t207 = t182 * t188 + t179 * t205;
        t208 = speeds[0] * t166;
        t211 = self.constants[7] * speeds[0];
        t212 = t166 * t211;
        t213 = self.constants[7] * t208 + t212;
        t218 = t169 * (t91 - t168) - speeds[0] * t211;
        t222 = t25 * t213 + t13 * t218 - t207 - self.constants[31] * t208;
        t224 = speeds[1] + t179;
        t228 = cos_delta * t182 - sin_delta * t187;
        t229 = self.constants[38] * t228;
        t233 = cos_delta * t187 + sin_delta * t182;
        t234 = self.constants[37] * t228;
        t239 = speeds[1] * t228;
        t241 = t239 - cos_delta * t196 - sin_delta * t208;
        t243 = t31 * self.constants[8];
        t247 = t33 * self.constants[8];
        t255 = t30 * t40 * (t31 * t233 + t33 * t224);
        t256 = t247 * t255;
        t258 = t243 * t255;
        t264 = cos_delta * t200 + t224 * t229 + t233 * t234 + self.constants[37] * t193
            + t243 * (t193 + t163 * t233) + t224 * t256;
        t268 = t264 + t233 * t258 - sin_delta * t222 - self.constants[38] * t241
            - t247 * (t241 - t163 * t224);
        t275 = self.constants[37] * t224 - self.constants[38] * t233;
        t279 = speeds[1] * t233;
        t281 = sin_delta * t196 - cos_delta * t208 - t279;
        t284 = t163 + t228;
        t289 = self.constants[8] * (t31 * t224 - t33 * t233);
        t295 = cos_delta * t222 + sin_delta * t200 + self.constants[38] * t281
            + t247 * t281 - t228 * t234 - t224 * t275;
        t297 = t295 - t258 * t284 - t224 * t289;
        t301 = t187 * t205 - t182 * t183;
        t315 = t301 + self.constants[30] * t208 + t13 * t213 + t233 * t275 + t233 * t289
            - t25 * t218;
        t319 = t315 - t228 * t229 - self.constants[37] * t281 - t243 * t281
            - t256 * t284;
        t321 = t31 * t297 + t33 * t319;
        t326 = t70 * (t40 * t268 + t29 * t321);
        t330 = t106 * (t29 * t268 + t102 * t326 - t40 * t321);
        t332 = t181 - cos_phi * t330;
        t334 = t180 + t13 * t332;
        t338 = t192 + t25 * t332;
        t345 = t182 * self.constants[43] + self.constants[27] * (speeds[3] + t182);
        t350 = t187 * self.constants[45] + self.constants[42] * t179;
        t357 = t190 + self.constants[30] * t338 + self.constants[31] * t334 - t174;
        t361 = t326 - t208 - sin_phi * t330;
        t364 = self.constants[7] * t361 - t212;
        t367 = t218 + cos_phi * self.constants[60];
        t369 = t13 * t367 - t25 * t364;
        t371 = self.constants[31] * t361 + t369 - t207;
        t373 = cos_delta * t357 - sin_delta * t371;
        t379 = t239 + sin_delta * t361 - cos_delta * t334;
        t387 = t228 * self.constants[52] + t284 * self.constants[28];
        t392 = t233 * self.constants[50] + t224 * self.constants[51];
        t397 = self.constants[48] * t373 + self.constants[51] * t379
            + t338 * self.constants[53] + t233 * t387 - t228 * t392;
        (sin_theta, cos_theta) = positions[6].sin_cos();
        t401 = self.constants[0].like(1.0) - cos_theta;
        t403 = t401 * self.constants[35];
        t406 = self.constants[2] * sin_theta;
        t408 = t182 * self.constants[32];
        t413 = t179 * self.constants[32] + t187 * self.constants[33];
        t418 = t369 + t182 * t408 + t179 * t413 + t361 * self.constants[33];
        t420 = t182 * self.constants[33];
        t428 = t179 * t420 + t334 * self.constants[33] - t174 - t187 * t408
            - t338 * self.constants[32];
        t430 = self.constants[3] * sin_theta;
        t436 = t25 * t367 + t13 * t364;
        t439 = t361 * self.constants[32] - t187 * t413 - t182 * t420 - t436;
        t442 = cos_theta * t428 + t430 * t439 - t406 * t418;
        t449 = t182 * cos_theta + t179 * t430 - t187 * t406;
        t450 = self.constants[2] * speeds[2];
        t454 = cos_theta + t401 * self.constants[34];
        t460 = t449 * t450 + t361 * t406 + t338 * t403 - t334 * t454;
        t463 = self.constants[3] * speeds[2];
        t469 = cos_theta + t401 * self.constants[36];
        t473 = t338 * t469 - t449 * t463 - t334 * t403 - t361 * t430;
        t480 = t463 + t187 * t454 + t182 * t406 + t179 * t403;
        t487 = t450 + t187 * t403 + t179 * t469 - t182 * t430;
        t490 = self.constants[57] * t480 + t487 * self.constants[59];
        t493 = t449 * self.constants[58];
        t498 = self.constants[56] * t460 + self.constants[57] * t473 + t449 * t490
            - self.constants[55] * t442 - t487 * t493;
        t504 = t418 * t454 + t406 * t428 + t403 * t439;
        t511 = t403 * t418 + t439 * t469 - t428 * t430;
        t522 = speeds[2] * (self.constants[3] * t487 - self.constants[2] * t480)
            + t334 * t406 + t361 * cos_theta + t338 * t430;
        t526 = self.constants[56] * t480 + self.constants[57] * t487;
        t532 = self.constants[55] * t504 + self.constants[58] * t522 + t487 * t526
            - self.constants[54] * t511 - t480 * t490;
        t542 = t442 * self.constants[54] + t460 * self.constants[57]
            + t473 * self.constants[59] + t480 * t493 - t449 * t526;
        t547 = t449 * self.constants[54];
        t551 = t487 * self.constants[54] - self.constants[55] * t480;
        t555 = t504 * self.constants[24] + self.constants[55] * t522 - t449 * t547
            - t487 * t551;
        t560 = self.constants[55] * t449;
        t566 = t442 * self.constants[24] + t473 * self.constants[54] + t487 * t560
            + t480 * t547 - self.constants[55] * t460;
        t574 = t511 * self.constants[24] + t480 * t551 - self.constants[54] * t522
            - t449 * t560;
        t577 = t406 * t555 + cos_theta * t566 - t430 * t574;
        t582 = cos_delta * t371 + sin_delta * t357;
        t588 = cos_delta * t361 + sin_delta * t334 - t279;
        t590 = t228 * self.constants[48];
        t594 = t224 * self.constants[48] - t233 * self.constants[49];
        t598 = self.constants[47] * t582 + self.constants[49] * t588 - t228 * t590
            - t224 * t594;
        t603 = t228 * self.constants[49];
        t609 = t373 * self.constants[47] + t338 * self.constants[48] + t224 * t603
            + t233 * t590 - t379 * self.constants[49];
        t611 = sin_delta * t598 + cos_delta * t609;
        t617 = self.constants[46] * t338 + t187 * t345 + t397 + t403 * t498 + t430 * t532
            + t469 * t542;
        t622 = t617 + self.constants[30] * t611 - self.constants[40] * t174
            - self.constants[42] * t334 - t182 * t350 - self.constants[32] * t577;
        t630 = self.constants[42] * t187 + t179 * self.constants[46];
        t642 = t233 * self.constants[51] + t224 * self.constants[53];
        t648 = t379 * self.constants[50] + t338 * self.constants[51] + t228 * t642
            - t373 * self.constants[49] - t224 * t387;
        t653 = t301 - t436 - self.constants[30] * t361;
        t664 = t588 + t145 * (t31 * t319 + t142 * t330 - t33 * t297 - t138 * t326);
        t665 = self.constants[28] * t664;
        t672 = t582 * self.constants[49] + self.constants[52] * t588 + t665 + t224 * t392
            - self.constants[48] * t653 - t233 * t642;
        t679 = t174 * self.constants[41] + self.constants[42] * t338 + t182 * t630
            + t454 * t498 + t403 * t542 + cos_delta * t648;
        t684 = t679 - t334 * self.constants[45] - t179 * t345 - t406 * t532
            - self.constants[33] * t577 - sin_delta * t672;
        t685 = t684 - self.constants[31] * t611;
        t691 = t182 * self.constants[41];
        t693 = self.constants[40] * t182;
        t700 = t577 + t611 + self.constants[40] * t338 + t334 * self.constants[41]
            + t179 * t691 + t187 * t693 - t174 * self.constants[44];
        t703 = t71 - sin_phi * t108;
        t716 = t454 * t555 + t403 * t574 - t406 * t566;
        t722 = t403 * t555 + t430 * t566 + t469 * t574;
        t728 = cos_delta * t598 - sin_delta * t609;
        t736 = self.constants[47] * t653 + t233 * t594 - self.constants[48] * t588
            - t228 * t603;
        t743 = self.constants[40] * t179 - t187 * self.constants[41];
        t751 = t13
            * (t722 + t736 + t187 * t743 - t436 * self.constants[44]
                - self.constants[40] * t361 - t182 * t691);
        t761 = t25
            * (t716 + t728 + t369 * self.constants[44] + t361 * self.constants[41]
                - t182 * t693 - t179 * t743);
        t764 = self.constants[27] * t361 - self.constants[7] * (t751 + t761);
        t769 = t369 * self.constants[41] + self.constants[40] * t436
            + self.constants[43] * t361 + t179 * t350 + t406 * t498 + cos_theta * t532;
        t774 = t769 + self.constants[33] * t716 + self.constants[32] * t722
            + sin_delta * t648 + cos_delta * t672 + self.constants[31] * t728;
        t778 = t774 + t764 - t187 * t630 - t430 * t542 - self.constants[30] * t736;
        t780 = cos_phi * t108;
        t783 = t25 * t622 - t13 * t685;
        t790 = forces[0] + t780 * t783 - t13 * t622 - t25 * t685
            - self.constants[7] * t700 - t703 * t778;
        t791 = t790 - t146 * t665;
        t793 = t403 * self.constants[57];
        t803 = sin_delta * self.constants[66];
        t804 = sin_delta * t803;
        t807 = t403 * self.constants[54] + self.constants[55] * t469;
        t808 = self.constants[33] * t807;
        t813 = t808 + t808 + self.constants[63] + self.constants[68];
        t817 = self.constants[45] + self.constants[50]
            + t454 * (self.constants[56] * t454 + t793)
            + t406 * t406 * self.constants[58]
            + t403 * (t454 * self.constants[57] + t403 * self.constants[59]);
        t819 = t817 + t813 - t804;
        t822 = t403 * self.constants[56] + self.constants[57] * t469;
        t824 = t430 * self.constants[58];
        t827 = t793 + t469 * self.constants[59];
        t833 = t454 * self.constants[54] + t403 * self.constants[55];
        t835 = cos_delta * self.constants[48];
        t836 = self.constants[30] * t835;
        t837 = self.constants[32] * t833 - t836;
        t840 = self.constants[65] + self.constants[71] - t837 - t837;
        t845 = self.constants[46] + self.constants[53] + t403 * t822 + t430 * t824
            + t469 * t827 + t840;
        t846 = t845 - t819;
        t847 = t13 * t13;
        t849 = t13 * t25;
        t860 = cos_delta * self.constants[51] - self.constants[31] * t835;
        t865 = self.constants[42] + t454 * t822 + t403 * t827 + self.constants[32] * t807
            + self.constants[64] + t860;
        t869 = t865 - t406 * t824 - self.constants[33] * t833 - self.constants[69]
            - self.constants[70];
        t870 = t869 + t869;
        t872 = t846 * t847 + t849 * t870;
        t877 = self.constants[41] + t807 + self.constants[62] + self.constants[72];
        t884 = self.constants[40] + t833 + t835 + self.constants[67]
            - self.constants[61];
        t886 = t25 * t877 - t13 * t884;
        t887 = self.constants[7] * t886;
        t890 = self.constants[74] - t887 - t887;
        t896 = t406 * self.constants[54] - self.constants[55] * t430;
        t899 = sin_delta * self.constants[48];
        t901 = sin_delta * self.constants[51] - self.constants[31] * t899;
        t905 = t406 * t822 + cos_theta * t824 + t901 - t430 * t827
            - self.constants[33] * t896;
        t909 = t406 * self.constants[56] - t430 * self.constants[57];
        t911 = cos_theta * self.constants[58];
        t915 = t406 * self.constants[57] - t430 * self.constants[59];
        t924 = t454 * t909 + t403 * t915 + self.constants[32] * t896 + cos_delta * t803
            - t406 * t911 - self.constants[30] * t899;
        t926 = t13 * t905 + t25 * t924;
        t936 = t869 + t846 * t849 + self.constants[7] * (t13 * t877 + t25 * t884)
            - t847 * t870;
        t946 = self.constants[43] + self.constants[52] + t804 + t813 + t840 + t890
            + t406 * t909;
        t948 = t946 + cos_theta * t911 - t430 * t915;
        t953 = self.constants[7] * (t896 + t899);
        t955 = t25 * t905 + t953 - t13 * t924;
        t961 = t845 - t872;
        t966 = self.constants[27] * t703;
        t970 = t13 * sin_delta;
        t974 = t146 + cos_delta * t703 - sin_delta * t25 - t780 * t970;
        t975 = self.constants[28] * t974;
        t981 = t819 + t872 + t890 + t703 * t926
            + t703 * (t926 + t703 * t948 - t780 * t955) + t703 * t966;
        t984 = t981 + t974 * t975 - t780 * t936
            - t780 * (t936 + t703 * t955 - t780 * t961);
        t985 = self.constants[0].like(1.0) / t984;
        t987 = self.constants[53] + t836;
        let (
            t992, t994, t997, t998, t1002, t1006, t1010, t1016, t1022, t1026, t1031, t1033, t1035,
            t1041, t1043, t1044, t1054, t1061, t1063, t1068, t1072, t1076, t1079, t1085, t1087,
            t1098, t1102, t1104, t1106, t1109, t1110, t1124, t1125, t1127, t1129, t1135, t1139,
            t1144, t1146, t1151, t1157, t1158, t1171, t1174, t1180, t1191, t1212, t1217, t1219,
            t1223, t1229, t1230, t1231, t1232,
        );
        t992 = t88 - sin_phi * t128;
        t994 = cos_phi * t128;
        t997 = self.constants[7] * t25 * t899;
        t998 = t901 + t997;
        t1002 = t998 + t948 * t992 - t955 * t994;
        t1006 = t25 * t987 - t13 * t860;
        t1010 = t1006 + t955 * t992 - t961 * t994;
        t1016 = t155 + cos_delta * t992 - t970 * t994;
        t1022 = t13 * t987 + t25 * t860 + self.constants[7] * t835 + t926 * t992
            + t703 * t1002 + t966 * t992;
        t1026 = t985 * (t1022 + t975 * t1016 - t936 * t994 - t780 * t1010);
        t1031 = self.constants[27] * t992;
        t1033 = self.constants[28] * t1016;
        t1035 = t984 * t1026;
        t1041 = self.constants[53] + t992 * t1002 + t992 * t998 + t992 * t1031
            + t1016 * t1033 - t994 * t1010;
        t1043 = t1041 - t994 * t1006 - t1026 * t1035;
        t1044 = self.constants[0].like(1.0) / t1043;
        t1054 = forces[1] + t783 * t994 - t397 - t778 * t992 - t155 * t665
            - t791 * t1026;
        t1061 = t406 * self.constants[75];
        t1063 = t430 * self.constants[75];
        t1068 = self.constants[7] * (t13 * t1063 - t25 * t1061);
        t1072 = t406 * self.constants[76] + self.constants[32] * t1063
            - t430 * self.constants[77] - self.constants[33] * t1061 - t1068;
        t1076 = cos_theta * self.constants[75];
        t1079 = t403 * self.constants[76] + t469 * self.constants[77]
            - self.constants[32] * t1076;
        t1085 = t454 * self.constants[76] + t403 * self.constants[77]
            - self.constants[33] * t1076;
        t1087 = t25 * t1079 - t13 * t1085;
        t1098 = t985
            * (t13 * t1079 + t25 * t1085 + self.constants[7] * t1076 + t703 * t1072
                - t780 * t1087);
        t1102 = t1044 * (t992 * t1072 - t994 * t1087 - t1035 * t1098);
        t1104 = t984 * t1098;
        t1106 = t1043 * t1102;
        t1109 = self.constants[78] - t1098 * t1104 - t1102 * t1106;
        t1110 = self.constants[0].like(1.0) / t1109;
        t1124 = forces[2] - self.constants[3] * t498 - self.constants[2] * t542
            - positions[6] * self.constants[5] - speeds[2] * self.constants[6]
            - t791 * t1098;
        t1125 = t1124 - t1054 * t1102;
        t1127 = sin_phi * t131;
        t1129 = cos_phi * t131;
        t1135 = self.constants[7] * (t886 - self.constants[73]);
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
        t1212 = t1127 * t1139 + t1127 * t1135 + self.constants[79]
            + self.constants[27] * t1146 * t1146 + self.constants[28] * t1151 * t1151
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

    #[inline(always)]
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
        t13 = self.constants[3] * sin_pitch + cos_pitch * self.constants[2];
        (sin_delta, cos_delta) = positions[5].sin_cos();
        t16 = cos_phi * t13;
        t21 = sin_phi * sin_delta - cos_delta * t16;
        t25 = self.constants[3] * cos_pitch - self.constants[2] * sin_pitch;
        t26 = cos_phi * t25;
        t29 = (t21 * t21 + t26 * t26).sqrt();
        t30 = self.constants[0].like(1.0) / t29;
        t31 = t21 * t30;
        t33 = t26 * t30;
        t34 = cos_delta * t33;
        t36 = t25 * t34 - t13 * t31;
        t43 = cos_phi * sin_delta * t33 + sin_phi * (t25 * t31 + t13 * t34);
        t47 = sin_phi * cos_delta + sin_delta * t16;
        t48 = self.constants[8] * t47;
        t55 = self.constants[30] + cos_delta * self.constants[37];
        t58 = t43 * t48 + t13 * self.constants[39] + t25 * t55;
        t62 = sin_delta * self.constants[37];
        t66 = t25 * self.constants[39] - t13 * t55;
        t69 = cos_phi * t62 - t36 * t48 - sin_phi * t66;
        t70 = self.constants[7] * sin_phi + t69;
        t73 = self.constants[0].like(1.0) / (t36 * t58 + t43 * t70);
        t74 = sin_phi * t58;
        t76 = sin_phi * t70;
        t78 = t36 * t74 + t43 * t76;
        t80 = self.constants[0].like(1.0) / (cos_phi * t58);
        t81 = t70 * t80;
        t83 = t73 * t78 * t81;
        t90 = t58 - t13 * self.constants[31] - t25 * self.constants[30];
        t97 = t25 * self.constants[31] - t13 * self.constants[30];
        t101 = t29 * self.constants[8] + sin_phi * t62 + cos_phi * t66 - cos_phi * t97;
        t103 = t26 * t90 - t13 * t101;
        t105 = sin_phi * t25;
        t108 = t69 + sin_phi * t97;
        t110 = t101 * t105 + t26 * t108;
        t115 = t80 * (t13 * t108 + t90 * t105);
        t119 = t73 * (t36 * t103 + t43 * t110 + t78 * t115);
        t122 = self.constants[7] * t43 * t73;
        t126 = speeds[0] * t83 + speeds[1] * t119 + t122 * speeds[3];
        t127 = cos_phi * t126;
        t128 = speeds[0] * t127;
        t131 = t13 * speeds[0] - t25 * t127;
        t134 = speeds[0] * t81 + speeds[1] * t115;
        t135 = sin_phi * t126;
        t136 = t134 - t135;
        t137 = self.constants[31] * t136;
        t141 = t25 * speeds[0] + t13 * t127;
        t142 = self.constants[30] * t136;
        t144 = t131 * t137 + t141 * t142;
        t145 = speeds[0] * t135;
        t147 = t134 * t141;
        t148 = t25 * t145 + t147;
        t151 = t131 * t134;
        t152 = t13 * t145 + t151;
        t154 = speeds[3] + t134;
        t155 = self.constants[7] * t154;
        t157 = self.constants[7] * t135;
        t159 = t127 * t157 - t127 * t155;
        t162 = t144 + self.constants[30] * t148 + self.constants[31] * t152 - t159;
        t167 = self.constants[30] * t131 - self.constants[31] * t141;
        t169 = t136 * t142 + t131 * t167;
        t171 = self.constants[7] * speeds[0];
        t172 = t127 * t171;
        t174 = t172 + self.constants[7] * t128;
        t179 = t157 * (t154 - t135) - speeds[0] * t171;
        t183 = t25 * t174 + t13 * t179 - t169 - self.constants[31] * t128;
        t185 = speeds[1] + t131;
        t189 = cos_delta * t136 - sin_delta * t141;
        t190 = self.constants[38] * t189;
        t194 = cos_delta * t141 + sin_delta * t136;
        t195 = self.constants[37] * t189;
        t200 = speeds[1] * t189;
        t202 = t200 - cos_delta * t152 - sin_delta * t128;
        t204 = t31 * self.constants[8];
        t207 = t43 * t74 - t36 * t76;
        t211 = t43 * t58 - t36 * t70;
        t214 = self.constants[0].like(1.0) / self.constants[8];
        t215 = (t83 * t211 - t81 * t207) * t214;
        t224 = t214 * (t36 * t110 + t119 * t211 - t43 * t103 - t115 * t207);
        t229 = t214 * (self.constants[7] * t36 + t122 * t211);
        t232 = speeds[0] * t215 + speeds[1] * t224 + speeds[3] * t229;
        t236 = t33 * self.constants[8];
        t244 = t30 * t47 * (t31 * t194 + t33 * t185);
        t245 = t236 * t244;
        t247 = t204 * t244;
        t253 = cos_delta * t162 + t185 * t190 + t194 * t195 + self.constants[37] * t148
            + t204 * (t148 + t194 * t232) + t185 * t245;
        t257 = t253 + t194 * t247 - sin_delta * t183 - self.constants[38] * t202
            - t236 * (t202 - t185 * t232);
        t264 = self.constants[37] * t185 - self.constants[38] * t194;
        t268 = speeds[1] * t194;
        t270 = sin_delta * t152 - cos_delta * t128 - t268;
        t273 = t189 + t232;
        t278 = self.constants[8] * (t31 * t185 - t33 * t194);
        t284 = cos_delta * t183 + sin_delta * t162 + self.constants[38] * t270
            + t236 * t270 - t189 * t195 - t185 * t264;
        t286 = t284 - t247 * t273 - t185 * t278;
        t290 = t141 * t167 - t136 * t137;
        t304 = t290 + self.constants[30] * t128 + t13 * t174 + t194 * t264 + t194 * t278
            - t25 * t179;
        t308 = t304 - t189 * t190 - self.constants[37] * t270 - t204 * t270
            - t245 * t273;
        t310 = t31 * t286 + t33 * t308;
        t313 = t80 * (t47 * t257 + t29 * t310);
        t319 = t73 * (t29 * t257 + t78 * t313 - t47 * t310);
        t322 = t313 - t128 - sin_phi * t319;
        (sin_theta, cos_theta) = positions[6].sin_cos();
        t328 = self.constants[0].like(1.0) - cos_theta;
        t330 = t328 * self.constants[35];
        t332 = self.constants[7] * t322 - t172;
        t336 = t179 + cos_phi * self.constants[60];
        t338 = t13 * t336 - t25 * t332;
        t340 = t136 * self.constants[32];
        t345 = t131 * self.constants[32] + t141 * self.constants[33];
        t350 = t338 + t136 * t340 + t131 * t345 + t322 * self.constants[33];
        t353 = cos_theta + t328 * self.constants[34];
        t356 = self.constants[2] * sin_theta;
        t357 = t136 * self.constants[33];
        t361 = t145 - cos_phi * t319;
        t363 = t147 + t25 * t361;
        t366 = t151 + t13 * t361;
        t369 = t159 + sin_phi * self.constants[60];
        t373 = t131 * t357 + self.constants[33] * t366 - t141 * t340
            - self.constants[32] * t363 - t369;
        t377 = t25 * t336 + t13 * t332;
        t383 = t322 * self.constants[32] - t377 - t141 * t345 - t136 * t357;
        t386 = t350 * t353 + t356 * t373 + t383 * t330;
        t391 = self.constants[2] * speeds[2];
        t393 = self.constants[3] * sin_theta;
        t397 = cos_theta + t328 * self.constants[36];
        t401 = t391 + t141 * t330 + t131 * t397 - t136 * t393;
        t403 = self.constants[3] * speeds[2];
        t409 = t403 + t141 * t353 + t136 * t356 + t131 * t330;
        t418 = speeds[2] * (self.constants[3] * t401 - self.constants[2] * t409)
            + t356 * t366 + t322 * cos_theta + t363 * t393;
        t424 = t136 * cos_theta + t131 * t393 - t141 * t356;
        t426 = t424 * self.constants[54];
        t430 = t401 * self.constants[54] - self.constants[55] * t409;
        t434 = t386 * self.constants[24] + self.constants[55] * t418 - t424 * t426
            - t401 * t430;
        t440 = cos_theta * t373 + t393 * t383 - t356 * t350;
        t448 = t363 * t397 - t424 * t403 - t366 * t330 - t322 * t393;
        t456 = t424 * t391 + t322 * t356 + t363 * t330 - t366 * t353;
        t458 = self.constants[55] * t424;
        t464 = t440 * self.constants[24] + t448 * self.constants[54] + t401 * t458
            + t409 * t426 - self.constants[55] * t456;
        t470 = t350 * t330 + t383 * t397 - t373 * t393;
        t477 = t470 * self.constants[24] + t409 * t430 - self.constants[54] * t418
            - t424 * t458;
        t480 = t330 * t434 + t393 * t464 + t397 * t477;
        t483 = t290 - t377 - self.constants[30] * t322;
        t490 = cos_delta * t322 + sin_delta * t366 - t268;
        t495 = t185 * self.constants[48] - t194 * self.constants[49];
        t497 = t189 * self.constants[49];
        t501 = t483 * self.constants[47] + t194 * t495 - self.constants[48] * t490
            - t189 * t497;
        t509 = t131 * self.constants[40] - self.constants[41] * t141;
        t511 = self.constants[41] * t136;
        t518 = t13
            * (t480 + t501 + t141 * t509 - t377 * self.constants[44]
                - t322 * self.constants[40] - t136 * t511);
        t523 = t353 * t434 + t330 * t477 - t356 * t464;
        t526 = t338 + self.constants[31] * t322 - t169;
        t532 = t144 + self.constants[30] * t363 + self.constants[31] * t366 - t369;
        t534 = cos_delta * t526 + sin_delta * t532;
        t537 = t189 * self.constants[48];
        t542 = t534 * self.constants[47] + self.constants[49] * t490 - t189 * t537
            - t185 * t495;
        t546 = cos_delta * t532 - sin_delta * t526;
        t552 = t200 + sin_delta * t322 - cos_delta * t366;
        t559 = t546 * self.constants[47] + t363 * self.constants[48] + t185 * t497
            + t194 * t537 - self.constants[49] * t552;
        t561 = cos_delta * t542 - sin_delta * t559;
        t564 = t136 * self.constants[40];
        t572 = t25
            * (t523 + t561 + t338 * self.constants[44] + self.constants[41] * t322
                - t136 * t564 - t131 * t509);
        t575 = t322 * self.constants[27] - self.constants[7] * (t518 + t572);
        t576 = sin_phi * t122;
        t585 = t141 * self.constants[45] + t131 * self.constants[42];
        t590 = t141 * self.constants[42] + t131 * self.constants[46];
        t600 = self.constants[57] * t409 + t401 * self.constants[59];
        t603 = t424 * self.constants[58];
        t608 = self.constants[56] * t456 + self.constants[57] * t448 + t424 * t600
            - self.constants[55] * t440 - t401 * t603;
        t615 = self.constants[56] * t409 + self.constants[57] * t401;
        t621 = self.constants[55] * t386 + self.constants[58] * t418 + t401 * t615
            - self.constants[54] * t470 - t409 * t600;
        t631 = t440 * self.constants[54] + t456 * self.constants[57]
            + t448 * self.constants[59] + t409 * t603 - t424 * t615;
        t643 = t194 * self.constants[51] + t185 * self.constants[53];
        t649 = t189 * self.constants[52] + t273 * self.constants[28];
        t654 = self.constants[50] * t552 + t363 * self.constants[51] + t189 * t643
            - self.constants[49] * t546 - t185 * t649;
        t666 = t214 * (t31 * t308 + t211 * t319 - t33 * t286 - t207 * t313);
        t668 = self.constants[28] * (t490 + t666);
        t671 = t194 * self.constants[50] + t185 * self.constants[51];
        t678 = self.constants[49] * t534 + self.constants[52] * t490 + t668 + t185 * t671
            - self.constants[48] * t483 - t194 * t643;
        t686 = self.constants[41] * t338 + self.constants[40] * t377
            + t322 * self.constants[43] + t131 * t585 + t356 * t608 + cos_theta * t621;
        t691 = t686 + self.constants[33] * t523 + self.constants[32] * t480
            + sin_delta * t654 + cos_delta * t678 + self.constants[31] * t561;
        t695 = t691 + t575 - t141 * t590 - t393 * t631 - self.constants[30] * t501;
        t697 = cos_phi * t122;
        t704 = t136 * self.constants[43] + self.constants[27] * (speeds[3] + t136);
        t715 = t546 * self.constants[48] + t552 * self.constants[51]
            + t363 * self.constants[53] + t194 * t649 - t189 * t671;
        t723 = t356 * t434 + cos_theta * t464 - t393 * t477;
        t727 = sin_delta * t542 + cos_delta * t559;
        t733 = self.constants[46] * t363 + t141 * t704 + t715 + t330 * t608 + t393 * t621
            + t397 * t631;
        t738 = t733 + self.constants[30] * t727 - self.constants[40] * t369
            - self.constants[42] * t366 - t136 * t585 - self.constants[32] * t723;
        t756 = self.constants[41] * t369 + self.constants[42] * t363 + t136 * t590
            + t353 * t608 + t330 * t631 + cos_delta * t654;
        t761 = t756 - self.constants[45] * t366 - t131 * t704 - t356 * t621
            - self.constants[33] * t723 - sin_delta * t678;
        t762 = t761 - self.constants[31] * t727;
        t764 = t25 * t738 - t13 * t762;
        t780 = t723 + t727 + self.constants[40] * t363 + self.constants[41] * t366
            + t131 * t511 + t141 * t564 - t369 * self.constants[44];
        t783 = t81 - sin_phi * t83;
        t785 = cos_phi * t83;
        t792 = forces[0] + t764 * t785 - t13 * t738 - t25 * t762
            - self.constants[7] * t780 - t695 * t783;
        t793 = t792 - t215 * t668;
        t796 = self.constants[56] * t330 + self.constants[57] * t397;
        t798 = t393 * self.constants[58];
        t800 = t330 * self.constants[57];
        t802 = t800 + t397 * self.constants[59];
        t806 = t356 * self.constants[54] - self.constants[55] * t393;
        t809 = sin_delta * self.constants[48];
        t811 = sin_delta * self.constants[51] - self.constants[31] * t809;
        t815 = t356 * t796 + cos_theta * t798 + t811 - t393 * t802
            - self.constants[33] * t806;
        t819 = t356 * self.constants[56] - t393 * self.constants[57];
        t821 = cos_theta * self.constants[58];
        t825 = t356 * self.constants[57] - t393 * self.constants[59];
        t829 = sin_delta * self.constants[66];
        t836 = t353 * t819 + t330 * t825 + self.constants[32] * t806 + cos_delta * t829
            - t356 * t821 - self.constants[30] * t809;
        t838 = t13 * t815 + t25 * t836;
        t845 = t330 * self.constants[54] + self.constants[55] * t397;
        t849 = t353 * self.constants[54] + self.constants[55] * t330;
        t855 = cos_delta * self.constants[48];
        t857 = cos_delta * self.constants[51] - self.constants[31] * t855;
        t862 = self.constants[42] + t353 * t796 + t330 * t802 + self.constants[32] * t845
            + self.constants[64] + t857;
        t866 = t862 - t356 * t798 - self.constants[33] * t849 - self.constants[69]
            - self.constants[70];
        t876 = sin_delta * t829;
        t877 = self.constants[33] * t845;
        t882 = t877 + t877 + self.constants[63] + self.constants[68];
        t886 = self.constants[45] + self.constants[50]
            + t353 * (t800 + self.constants[56] * t353)
            + t356 * t356 * self.constants[58]
            + t330 * (t353 * self.constants[57] + t330 * self.constants[59]);
        t888 = t886 + t882 - t876;
        t895 = self.constants[30] * t855;
        t896 = self.constants[32] * t849 - t895;
        t899 = self.constants[65] + self.constants[71] - t896 - t896;
        t904 = self.constants[46] + self.constants[53] + t330 * t796 + t393 * t798
            + t397 * t802 + t899;
        t905 = t904 - t888;
        t906 = t25 * t13;
        t908 = t13 * t13;
        t909 = t866 + t866;
        t915 = self.constants[41] + t845 + self.constants[62] + self.constants[72];
        t922 = self.constants[40] + t849 + t855 + self.constants[67]
            - self.constants[61];
        t928 = t866 + t905 * t906 + self.constants[7] * (t13 * t915 + t25 * t922)
            - t908 * t909;
        t932 = t25 * t915 - t13 * t922;
        t935 = self.constants[7] * (t932 - self.constants[73]);
        t939 = self.constants[7] * t932;
        t942 = self.constants[74] - t939 - t939;
        t948 = self.constants[43] + self.constants[52] + t876 + t882 + t899 + t356 * t819
            + cos_theta * t821;
        t950 = t948 + t942 - t393 * t825;
        t955 = self.constants[7] * (t806 + t809);
        t957 = t25 * t815 + t955 - t13 * t836;
        t960 = t935 + t576 * t950 + t697 * t957;
        t965 = t905 * t908 + t906 * t909;
        t966 = t904 - t965;
        t969 = t955 - t576 * t957 - t697 * t966;
        t971 = self.constants[0].like(1.0) - t576;
        t972 = self.constants[27] * t783;
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
        t985 = self.constants[28] * t984;
        t991 = t971 * t972 + t978 * t985 - t576 * t838 - t697 * t928 - t783 * t960
            - t785 * t969;
        t1010 = t888 + t942 + t965 + t783 * t838
            + t783 * (t838 + t783 * t950 - t785 * t957) + t783 * t972;
        t1013 = t1010 + t984 * t985 - t785 * t928
            - t785 * (t928 + t783 * t957 - t785 * t966);
        t1014 = self.constants[0].like(1.0) / t1013;
        t1015 = t991 * t1014;
        t1018 = t115 - sin_phi * t119;
        t1020 = self.constants[7] * t25 * t809;
        t1021 = t811 + t1020;
        t1023 = cos_phi * t119;
        t1026 = t1021 + t950 * t1018 - t957 * t1023;
        t1028 = self.constants[53] + t895;
        t1031 = t25 * t1028 - t13 * t857;
        t1035 = t1031 + t957 * t1018 - t966 * t1023;
        t1039 = self.constants[27] * t1018;
        t1044 = t224 + cos_delta * t1018 - t975 * t1023;
        t1045 = self.constants[28] * t1044;
        t1060 = t13 * t1028 + t25 * t857 + self.constants[7] * t855 + t838 * t1018
            + t783 * t1026 + t972 * t1018;
        t1064 = t1014 * (t1060 + t985 * t1044 - t928 * t1023 - t785 * t1035);
        t1065 = t1013 * t1064;
        t1071 = self.constants[53] + t1018 * t1026 + t1018 * t1021 + t1018 * t1039
            + t1044 * t1045 - t1023 * t1035;
        t1073 = t1071 - t1023 * t1031 - t1064 * t1065;
        t1074 = self.constants[0].like(1.0) / t1073;
        t1086 = t1020 + t971 * t1039 + t978 * t1045 - t960 * t1018 - t969 * t1023
            - t576 * t1021;
        t1089 = t1074 * (t1086 - t697 * t1031 - t1015 * t1065);
        t1099 = forces[1] + t764 * t1023 - t715 - t695 * t1018 - t224 * t668
            - t793 * t1064;
        t1102 = t393 * self.constants[75];
        t1104 = t356 * self.constants[75];
        t1107 = self.constants[7] * (t13 * t1102 - t25 * t1104);
        t1117 = t356 * self.constants[76] + self.constants[32] * t1102 - t1107
            - t393 * self.constants[77] - self.constants[33] * t1104;
        t1121 = cos_theta * self.constants[75];
        t1124 = t330 * self.constants[76] + t397 * self.constants[77]
            - self.constants[32] * t1121;
        t1130 = t353 * self.constants[76] + t330 * self.constants[77]
            - self.constants[33] * t1121;
        t1132 = t25 * t1124 - t13 * t1130;
        t1143 = t1014
            * (t13 * t1124 + t25 * t1130 + self.constants[7] * t1121 + t783 * t1117
                - t785 * t1132);
        t1144 = t1013 * t1143;
        t1151 = t1074 * (t1018 * t1117 - t1023 * t1132 - t1065 * t1143);
        t1152 = t1073 * t1151;
        t1162 = self.constants[78] - t1143 * t1144 - t1151 * t1152;
        t1163 = self.constants[0].like(1.0) / t1162;
        t1164 = (t1107 + t576 * t1117 + t697 * t1132 + t1015 * t1144 + t1089 * t1152)
            * t1163;
        t1178 = forces[2] - self.constants[3] * t608 - self.constants[2] * t631
            - positions[6] * self.constants[5] - speeds[2] * self.constants[6]
            - t793 * t1143;
        t1179 = t1178 - t1099 * t1151;
        t1185 = t576 * t695 + t697 * t764 + t1164 * t1179 - t575 - t229 * t668
            - t793 * t1015;
        t1206 = t576 * t960 + t576 * t935 + self.constants[79]
            + self.constants[27] * t971 * t971 + self.constants[28] * t978 * t978
            - t697 * t969;
        t1211 = (t1185 - t1089 * t1099)
            / (t1206 - t697 * t955 - t1013 * t1015 * t1015 - t1073 * t1089 * t1089
                - t1162 * t1164 * t1164);
        t1216 = t1163 * t1179 + t1164 * t1211;
        t1220 = t1074 * t1099 - t1151 * t1216 - t1089 * t1211;
        t1226 = t793 * t1014 - t1064 * t1220 - t1143 * t1216 - t1015 * t1211;
        t1230 = t313 + t81 * t1226 + t115 * t1220;
        t1232 = self.constants[7] * (t1211 + t1230);
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
        let t9 = cos_theta + t6 * self.constants[34];
        let t13 = t6 * self.constants[35];
        let t15 = t13 * self.constants[57];
        let t20 = self.constants[2] * sin_theta;
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t32 = sin_delta * self.constants[66];
        let t33 = sin_delta * t32;
        let t39 = cos_theta + t6 * self.constants[36];
        let t42 = t13 * self.constants[54] + t39 * self.constants[55];
        let t43 = self.constants[33] * t42;
        let t48 = t43 + t43 + self.constants[63] + self.constants[68];
        let t52 = self.constants[45] + self.constants[50]
            + t9 * (t9 * self.constants[56] + t15) + t20 * t20 * self.constants[58]
            + t13 * (t9 * self.constants[57] + t13 * self.constants[59]);
        let t54 = t52 + t48 - t33;
        let t59 = self.constants[56] * t13 + self.constants[57] * t39;
        let t62 = sin_theta * self.constants[3];
        let t63 = self.constants[58] * t62;
        let t66 = t15 + self.constants[59] * t39;
        let t73 = t9 * self.constants[54] + t13 * self.constants[55];
        let t78 = cos_delta * self.constants[48];
        let t79 = self.constants[30] * t78;
        let t80 = self.constants[32] * t73 - t79;
        let t83 = self.constants[65] + self.constants[71] - t80 - t80;
        let t88 = self.constants[46] + self.constants[53] + t13 * t59 + t62 * t63
            + t39 * t66 + t83;
        let t89 = t88 - t54;
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t95 = self.constants[3] * sin_pitch + self.constants[2] * cos_pitch;
        let t96 = t95 * t95;
        let t100 = self.constants[3] * cos_pitch - self.constants[2] * sin_pitch;
        let t101 = t95 * t100;
        let t115 = cos_delta * self.constants[51] - t78 * self.constants[31];
        let t120 = self.constants[42] + t9 * t59 + t13 * t66 + t42 * self.constants[32]
            + self.constants[64] + t115;
        let t124 = t120 - t20 * t63 - self.constants[33] * t73 - self.constants[69]
            - self.constants[70];
        let t125 = t124 + t124;
        let t127 = t89 * t96 + t101 * t125;
        let t134 = t42 + self.constants[41] + self.constants[62] + self.constants[72];
        let t142 = t73 + t78 + self.constants[40] + self.constants[67]
            - self.constants[61];
        let t144 = t100 * t134 - t95 * t142;
        let t145 = self.constants[7] * t144;
        let t148 = self.constants[74] - t145 - t145;
        let t154 = t20 * self.constants[54] - self.constants[55] * t62;
        let t157 = sin_delta * self.constants[48];
        let t159 = sin_delta * self.constants[51] - self.constants[31] * t157;
        let t163 = t20 * t59 + cos_theta * t63 + t159 - t62 * t66
            - self.constants[33] * t154;
        let t167 = self.constants[56] * t20 - self.constants[57] * t62;
        let t169 = cos_theta * self.constants[58];
        let t173 = self.constants[57] * t20 - self.constants[59] * t62;
        let t182 = t9 * t167 + t13 * t173 + self.constants[32] * t154 + t32 * cos_delta
            - t20 * t169 - self.constants[30] * t157;
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
        let t209 = self.constants[8] * (cos_delta * sin_phi + sin_delta * t189);
        let t212 = sin_delta * self.constants[37];
        let t217 = self.constants[30] + cos_delta * self.constants[37];
        let t219 = t100 * self.constants[39] - t95 * t217;
        let t222 = cos_phi * t212 - t204 * t209 - sin_phi * t219;
        let t223 = self.constants[7] * sin_phi + t222;
        let t230 = sin_delta * cos_phi * t201 + sin_phi * (t100 * t199 + t95 * t202);
        let t235 = t209 * t230 + t95 * self.constants[39] + t100 * t217;
        let t237 = self.constants[0].like(1.0) / (cos_phi * t235);
        let t238 = t223 * t237;
        let t239 = sin_phi * t235;
        let t241 = sin_phi * t223;
        let t243 = t204 * t239 + t230 * t241;
        let t247 = self.constants[0].like(1.0) / (t204 * t235 + t223 * t230);
        let t249 = t238 * t243 * t247;
        let t251 = t238 - sin_phi * t249;
        let t261 = t124 + t89 * t101 + self.constants[7] * (t95 * t134 + t100 * t142)
            - t96 * t125;
        let t262 = cos_phi * t249;
        let t274 = t33 + t48 + t83 + t148 + self.constants[43] + self.constants[52]
            + t20 * t167;
        let t276 = t274 + cos_theta * t169 - t62 * t173;
        let t280 = t154 + t157;
        let t281 = self.constants[7] * t280;
        let t283 = t100 * t163 + t281 - t95 * t182;
        let t289 = t88 - t127;
        let t295 = t251 * self.constants[27];
        let t299 = t230 * t239 - t204 * t241;
        let t303 = t230 * t235 - t204 * t223;
        let t306 = self.constants[0].like(1.0) / self.constants[8];
        let t310 = sin_delta * t95;
        let t314 = (t249 * t303 - t238 * t299) * t306 + cos_delta * t251
            - sin_delta * t100 - t262 * t310;
        let t316 = t314 * self.constants[28];
        let t322 = t54 + t127 + t148 + t184 * t251
            + t251 * (t184 + t251 * t276 - t262 * t283) + t251 * t295;
        let t326 = speeds[0]
            * (t322 + t314 * t316 - t261 * t262
                - t262 * (t261 + t251 * t283 - t262 * t289));
        let t328 = self.constants[53] + t79;
        let t334 = t100 * self.constants[31] - self.constants[30] * t95;
        let t336 = t222 + sin_phi * t334;
        let t338 = t100 * sin_phi;
        let t342 = t235 - t95 * self.constants[31] - self.constants[30] * t100;
        let t345 = t237 * (t95 * t336 + t338 * t342);
        let t353 = t197 * self.constants[8] + sin_phi * t212 + cos_phi * t219
            - cos_phi * t334;
        let t355 = t194 * t342 - t95 * t353;
        let t359 = t338 * t353 + t194 * t336;
        let t364 = t247 * (t204 * t355 + t230 * t359 + t243 * t345);
        let t366 = t345 - sin_phi * t364;
        let t368 = cos_phi * t364;
        let t371 = t100 * self.constants[7] * t157;
        let t372 = t159 + t371;
        let t376 = t372 + t276 * t366 - t283 * t368;
        let t380 = t100 * t328 - t95 * t115;
        let t384 = t380 + t283 * t366 - t289 * t368;
        let t397 = t306 * (t204 * t359 + t303 * t364 - t230 * t355 - t299 * t345)
            + cos_delta * t366;
        let t398 = t397 - t310 * t368;
        let t404 = t95 * t328 + t100 * t115 + t78 * self.constants[7] + t184 * t366
            + t251 * t376 + t295 * t366;
        let t407 = t404 + t316 * t398 - t261 * t368 - t262 * t384;
        let t415 = cos_theta * self.constants[75];
        let t418 = t13 * self.constants[76] + t39 * self.constants[77]
            - self.constants[32] * t415;
        let t424 = t9 * self.constants[76] + t13 * self.constants[77]
            - self.constants[33] * t415;
        let t429 = t20 * self.constants[75];
        let t431 = t62 * self.constants[75];
        let t436 = self.constants[7] * (t95 * t431 - t100 * t429);
        let t440 = t20 * self.constants[76] + self.constants[32] * t431
            - t62 * self.constants[77] - self.constants[33] * t429 - t436;
        let t444 = t100 * t418 - t95 * t424;
        let t449 = t95 * t418 + t100 * t424 + self.constants[7] * t415 + t251 * t440
            - t262 * t444;
        let t453 = self.constants[7] * t230 * t247;
        let t454 = sin_phi * t453;
        let t456 = cos_phi * t453;
        let t459 = t144 - self.constants[73];
        let t460 = self.constants[7] * t459;
        let t464 = t460 + t276 * t454 + t283 * t456;
        let t469 = t281 - t283 * t454 - t289 * t456;
        let t471 = self.constants[0].like(1.0) - t454;
        let t480 = t306 * (self.constants[7] * t204 + t303 * t453) - cos_delta * t454
            - t310 * t456;
        let t486 = t295 * t471 + t316 * t480 - t184 * t454 - t261 * t456 - t251 * t464
            - t262 * t469;
        let t497 = self.constants[27] * t366;
        let t499 = self.constants[28] * t398;
        let t505 = self.constants[53] + t366 * t376 + t366 * t372 + t366 * t497
            + t398 * t499 - t368 * t384;
        let t510 = t366 * t440 - t368 * t444;
        let t522 = t371 + t471 * t497 + t480 * t499 - t366 * t464 - t368 * t469
            - t372 * t454;
        let t523 = t522 - t380 * t456;
        let t527 = speeds[0] * t407 + speeds[1] * (t505 - t368 * t380) + speeds[2] * t510
            + speeds[3] * t523;
        let t536 = t436 + t440 * t454 + t444 * t456;
        let t558 = t454 * t464 + t454 * t460 + self.constants[79]
            + self.constants[27] * t471 * t471 + self.constants[28] * t480 * t480
            - t456 * t469;
        let t564 = speeds[3]
            * (speeds[0] * t486 + speeds[1] * t523 + speeds[3] * (t558 - t281 * t456)
                - speeds[2] * t536);
        let t565 = speeds[0]
            * (t326 + speeds[1] * t407 + speeds[2] * t449 + speeds[3] * t486)
            + speeds[1] * t527;
        let t566 = t565
            + speeds[2]
                * (speeds[0] * t449 + speeds[1] * t510 + speeds[2] * self.constants[78]
                    - speeds[3] * t536);
        let t569 = (t566 + t564) * self.constants[0].like(0.5);
        let t579 = positions[6] * positions[6] * self.constants[0].like(0.5)
            * self.constants[5] - self.constants[60] * (sin_phi * t280 + cos_phi * t459);
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
        t9 = self.constants[3] * sin_pitch + self.constants[2] * cos_pitch;
        t13 = self.constants[3] * cos_pitch - sin_pitch * self.constants[2];
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
        t48 = self.constants[8] * t47;
        t55 = self.constants[30] + cos_delta * self.constants[37];
        t58 = t43 * t48 + t9 * self.constants[39] + t13 * t55;
        t59 = sin_phi * t58;
        t64 = sin_delta * self.constants[37];
        t68 = t13 * self.constants[39] - t9 * t55;
        t71 = cos_phi * t64 - t36 * t48 - sin_phi * t68;
        t72 = sin_phi * self.constants[7] + t71;
        t73 = sin_phi * t72;
        t75 = t36 * t59 + t43 * t73;
        t77 = self.constants[0].like(1.0) / (cos_phi * t58);
        t78 = t72 * t77;
        t82 = self.constants[0].like(1.0) / (t36 * t58 + t43 * t72);
        t84 = t75 * t78 * t82;
        t91 = t58 - t9 * self.constants[31] - t13 * self.constants[30];
        t98 = t13 * self.constants[31] - t9 * self.constants[30];
        t102 = t29 * self.constants[8] + sin_phi * t64 + cos_phi * t68 - cos_phi * t98;
        t104 = t26 * t91 - t9 * t102;
        t106 = t13 * sin_phi;
        t109 = t71 + sin_phi * t98;
        t111 = t102 * t106 + t26 * t109;
        t116 = t77 * (t9 * t109 + t91 * t106);
        t120 = t82 * (t36 * t104 + t43 * t111 + t75 * t116);
        t124 = t43 * self.constants[7] * t82;
        t127 = speeds[0] * t84 + speeds[1] * t120 + speeds[3] * t124;
        t128 = cos_phi * t127;
        t130 = speeds[0] * t13 + t9 * t128;
        t133 = t9 * speeds[0] - t13 * t128;
        t138 = t133 * self.constants[40] - t130 * self.constants[41];
        t142 = speeds[0] * t78 + speeds[1] * t116;
        t143 = sin_phi * t127;
        t144 = t142 - t143;
        t145 = self.constants[41] * t144;
        t147 = t130 * t138 - t144 * t145;
        t149 = speeds[0] * self.constants[7];
        t151 = speeds[3] + t142;
        t153 = self.constants[7] * t143;
        t155 = (t151 - t143) * t153 - speeds[0] * t149;
        t158 = t155 + cos_phi * self.constants[60];
        t159 = t13 * t158;
        t160 = t128 * t149;
        t161 = self.constants[31] * t144;
        t163 = self.constants[30] * t144;
        t165 = t133 * t161 + t130 * t163;
        t166 = speeds[0] * t143;
        t168 = t130 * t142;
        t169 = t13 * t166 + t168;
        t172 = t133 * t142;
        t173 = t9 * t166 + t172;
        t175 = t128 * t151;
        t177 = t128 * t153;
        t178 = t177 - self.constants[7] * t175;
        t181 = t165 + self.constants[30] * t169 + self.constants[31] * t173 - t178;
        t186 = self.constants[30] * t133 - self.constants[31] * t130;
        t188 = t144 * t163 + t133 * t186;
        t189 = speeds[0] * t128;
        t192 = t160 + self.constants[7] * t189;
        t197 = t13 * t192 + t9 * t155 - t188 - self.constants[31] * t189;
        t199 = speeds[1] + t133;
        t203 = cos_delta * t144 - sin_delta * t130;
        t204 = self.constants[38] * t203;
        t208 = cos_delta * t130 + sin_delta * t144;
        t209 = self.constants[37] * t203;
        t214 = speeds[1] * t203;
        t216 = t214 - cos_delta * t173 - sin_delta * t189;
        t218 = t31 * self.constants[8];
        t221 = t43 * t59 - t36 * t73;
        t225 = t43 * t58 - t36 * t72;
        t228 = self.constants[0].like(1.0) / self.constants[8];
        t229 = (t84 * t225 - t78 * t221) * t228;
        t238 = t228 * (t36 * t111 + t120 * t225 - t43 * t104 - t116 * t221);
        t243 = t228 * (t36 * self.constants[7] + t124 * t225);
        t246 = speeds[0] * t229 + speeds[1] * t238 + speeds[3] * t243;
        t250 = t33 * self.constants[8];
        t258 = t30 * t47 * (t31 * t208 + t33 * t199);
        t259 = t250 * t258;
        t261 = t218 * t258;
        t267 = cos_delta * t181 + t199 * t204 + t208 * t209 + self.constants[37] * t169
            + t218 * (t169 + t208 * t246) + t199 * t259;
        t271 = t267 + t208 * t261 - sin_delta * t197 - self.constants[38] * t216
            - t250 * (t216 - t199 * t246);
        t278 = self.constants[37] * t199 - self.constants[38] * t208;
        t282 = speeds[1] * t208;
        t284 = sin_delta * t173 - cos_delta * t189 - t282;
        t287 = t203 + t246;
        t292 = self.constants[8] * (t31 * t199 - t33 * t208);
        t298 = cos_delta * t197 + sin_delta * t181 + self.constants[38] * t284
            + t250 * t284 - t203 * t209 - t199 * t278;
        t300 = t298 - t261 * t287 - t199 * t292;
        t304 = t130 * t186 - t144 * t161;
        t318 = t304 + self.constants[30] * t189 + t9 * t192 + t208 * t278 + t208 * t292
            - t13 * t155;
        t322 = t318 - t203 * t204 - self.constants[37] * t284 - t218 * t284
            - t259 * t287;
        t324 = t31 * t300 + t33 * t322;
        t329 = t77 * (t47 * t271 + t29 * t324);
        t333 = t82 * (t29 * t271 + t75 * t329 - t47 * t324);
        t335 = t189 - t329;
        t336 = sin_phi * t333 + t335;
        (sin_theta, cos_theta) = positions[6].sin_cos();
        t342 = self.constants[0].like(1.0) - cos_theta;
        t344 = t342 * self.constants[35];
        t346 = self.constants[7] * t336 + t160;
        t348 = t9 * t158;
        t349 = t348 + t13 * t346;
        t351 = t144 * self.constants[32];
        t356 = t133 * self.constants[32] + t130 * self.constants[33];
        t358 = t144 * t351 + t133 * t356;
        t361 = t349 + t358 - t336 * self.constants[33];
        t364 = cos_theta + t342 * self.constants[34];
        t367 = self.constants[2] * sin_theta;
        t368 = t144 * self.constants[33];
        t371 = t133 * t368 - t130 * t351;
        t373 = t166 - cos_phi * t333;
        t375 = t168 + t13 * t373;
        t378 = t172 + t9 * t373;
        t380 = sin_phi * self.constants[60];
        t381 = t178 + t380;
        t384 = t371 + self.constants[33] * t378 - self.constants[32] * t375 - t381;
        t387 = t159 - t9 * t346;
        t390 = t130 * t356 + t144 * t368;
        t393 = t336 * self.constants[32] + t387 + t390;
        t396 = t361 * t364 + t367 * t384 - t393 * t344;
        t401 = self.constants[2] * speeds[2];
        t403 = self.constants[3] * sin_theta;
        t407 = cos_theta + t342 * self.constants[36];
        t411 = t401 + t130 * t344 + t133 * t407 - t144 * t403;
        t413 = self.constants[3] * speeds[2];
        t419 = t413 + t130 * t364 + t144 * t367 + t133 * t344;
        t422 = speeds[2] * (self.constants[3] * t411 - self.constants[2] * t419);
        t428 = t422 + t367 * t378 - t336 * cos_theta + t375 * t403;
        t434 = t144 * cos_theta + t133 * t403 - t130 * t367;
        t436 = t434 * self.constants[54];
        t440 = t411 * self.constants[54] - self.constants[55] * t419;
        t442 = t434 * t436 + t411 * t440;
        t444 = t396 * self.constants[24] + self.constants[55] * t428 - t442;
        t450 = cos_theta * t384 - t403 * t393 - t367 * t361;
        t452 = t434 * t413;
        t458 = t375 * t407 - t452 - t378 * t344 + t336 * t403;
        t460 = t434 * t401;
        t466 = t460 - t336 * t367 + t375 * t344 - t378 * t364;
        t468 = self.constants[55] * t434;
        t471 = t411 * t468 + t419 * t436;
        t474 = t450 * self.constants[24] + t458 * self.constants[54] + t471
            - self.constants[55] * t466;
        t480 = t361 * t344 - t393 * t407 - t384 * t403;
        t485 = t419 * t440 - t434 * t468;
        t487 = t480 * self.constants[24] + t485 - self.constants[54] * t428;
        t490 = t344 * t444 + t403 * t474 + t407 * t487;
        t493 = t304 - t387 + self.constants[30] * t336;
        t500 = sin_delta * t378 - cos_delta * t336 - t282;
        t505 = t199 * self.constants[48] - t208 * self.constants[49];
        t507 = t203 * self.constants[49];
        t509 = t208 * t505 - t203 * t507;
        t511 = t493 * self.constants[47] + t509 - self.constants[48] * t500;
        t523 = t364 * t444 + t344 * t487 - t367 * t474;
        t526 = t349 - self.constants[31] * t336 - t188;
        t532 = t165 + self.constants[30] * t375 + self.constants[31] * t378 - t381;
        t534 = cos_delta * t526 + sin_delta * t532;
        t537 = t203 * self.constants[48];
        t540 = t203 * t537 + t199 * t505;
        t542 = t534 * self.constants[47] + self.constants[49] * t500 - t540;
        t546 = cos_delta * t532 - sin_delta * t526;
        t552 = t214 - sin_delta * t336 - cos_delta * t378;
        t556 = t199 * t507 + t208 * t537;
        t559 = t546 * self.constants[47] + t375 * self.constants[48] + t556
            - self.constants[49] * t552;
        t561 = cos_delta * t542 - sin_delta * t559;
        t564 = self.constants[40] * t144;
        t567 = t144 * t564 + t133 * t138;
        t573 = t9
            * (t147 + t490 + t511 - self.constants[44] * t387
                + self.constants[40] * t336)
            + t13
                * (t523 + t561 + self.constants[44] * t349 - self.constants[41] * t336
                    - t567);
        t575 = t336 * self.constants[27] + self.constants[7] * t573;
        t576 = sin_phi * t124;
        t585 = t130 * self.constants[45] + t133 * self.constants[42];
        t590 = t130 * self.constants[42] + t133 * self.constants[46];
        t592 = t133 * t585 - t130 * t590;
        t601 = self.constants[57] * t419 + t411 * self.constants[59];
        t604 = t434 * self.constants[58];
        t606 = t434 * t601 - t411 * t604;
        t609 = self.constants[56] * t466 + self.constants[57] * t458 + t606
            - self.constants[55] * t450;
        t616 = self.constants[56] * t419 + self.constants[57] * t411;
        t619 = t411 * t616 - t419 * t601;
        t622 = self.constants[55] * t396 + self.constants[58] * t428 + t619
            - self.constants[54] * t480;
        t629 = t419 * t604 - t434 * t616;
        t632 = t450 * self.constants[54] + t466 * self.constants[57]
            + t458 * self.constants[59] + t629;
        t644 = t208 * self.constants[51] + t199 * self.constants[53];
        t650 = t203 * self.constants[52] + t287 * self.constants[28];
        t652 = t203 * t644 - t199 * t650;
        t655 = self.constants[50] * t552 + t375 * self.constants[51] + t652
            - self.constants[49] * t546;
        t667 = t228 * (t31 * t322 + t225 * t333 - t33 * t300 - t221 * t329);
        t669 = self.constants[28] * (t500 + t667);
        t672 = t208 * self.constants[50] + t199 * self.constants[51];
        t675 = t199 * t672 - t208 * t644;
        t679 = self.constants[49] * t534 + self.constants[52] * t500 + t669 + t675
            - self.constants[48] * t493;
        t687 = self.constants[41] * t349 + self.constants[40] * t387
            - t336 * self.constants[43] + t592 + t367 * t609 + cos_theta * t622;
        t692 = t687 + self.constants[33] * t523 + self.constants[32] * t490
            + sin_delta * t655 + cos_delta * t679 + self.constants[31] * t561;
        t695 = t692 - t575 - t403 * t632 - self.constants[30] * t511;
        t697 = cos_phi * t124;
        t704 = t144 * self.constants[43] + self.constants[27] * (speeds[3] + t144);
        t707 = t130 * t704 - t144 * t585;
        t713 = t208 * t650 - t203 * t672;
        t716 = t546 * self.constants[48] + t552 * self.constants[51]
            + t375 * self.constants[53] + t713;
        t724 = t367 * t444 + cos_theta * t474 - t403 * t487;
        t728 = sin_delta * t542 + cos_delta * t559;
        t734 = self.constants[46] * t375 + t707 + t716 + t344 * t609 + t403 * t622
            + t407 * t632;
        t738 = t734 + self.constants[30] * t728 - self.constants[40] * t381
            - self.constants[42] * t378 - self.constants[32] * t724;
        t745 = t144 * t590 - t133 * t704;
        t757 = self.constants[41] * t381 + self.constants[42] * t375 + t745 + t364 * t609
            + t344 * t632 + cos_delta * t655;
        t762 = t757 - self.constants[45] * t378 - t367 * t622 - self.constants[33] * t724
            - sin_delta * t679 - self.constants[31] * t728;
        t764 = t13 * t738 - t9 * t762;
        t775 = t133 * t145 + t130 * t564;
        t781 = self.constants[7]
            * (t724 + t728 + self.constants[40] * t375 + self.constants[41] * t378 + t775
                - self.constants[44] * t381);
        t783 = t78 - sin_phi * t84;
        t785 = cos_phi * t84;
        t792 = forces[0] + t764 * t785 - t9 * t738 - t13 * t762 - t781 - t695 * t783;
        t793 = t792 - t229 * t669;
        t796 = self.constants[56] * t344 + self.constants[57] * t407;
        t798 = t403 * self.constants[58];
        t800 = t344 * self.constants[57];
        t802 = t800 + t407 * self.constants[59];
        t806 = t367 * self.constants[54] - self.constants[55] * t403;
        t809 = sin_delta * self.constants[48];
        t811 = sin_delta * self.constants[51] - self.constants[31] * t809;
        t815 = t367 * t796 + cos_theta * t798 + t811 - t403 * t802
            - self.constants[33] * t806;
        t819 = t367 * self.constants[56] - t403 * self.constants[57];
        t821 = cos_theta * self.constants[58];
        t825 = t367 * self.constants[57] - t403 * self.constants[59];
        t829 = sin_delta * self.constants[66];
        t836 = t364 * t819 + t344 * t825 + self.constants[32] * t806 + cos_delta * t829
            - t367 * t821 - self.constants[30] * t809;
        t838 = t9 * t815 + t13 * t836;
        t845 = t344 * self.constants[54] + self.constants[55] * t407;
        t849 = t364 * self.constants[54] + self.constants[55] * t344;
        t855 = cos_delta * self.constants[48];
        t857 = cos_delta * self.constants[51] - self.constants[31] * t855;
        t862 = self.constants[42] + t364 * t796 + t344 * t802 + self.constants[32] * t845
            + self.constants[64] + t857;
        t866 = t862 - t367 * t798 - self.constants[33] * t849 - self.constants[69]
            - self.constants[70];
        t876 = sin_delta * t829;
        t877 = self.constants[33] * t845;
        t882 = t877 + t877 + self.constants[63] + self.constants[68];
        t886 = self.constants[45] + self.constants[50]
            + t364 * (t800 + self.constants[56] * t364)
            + t367 * t367 * self.constants[58]
            + t344 * (t364 * self.constants[57] + t344 * self.constants[59]);
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
        t895 = self.constants[30] * t855;
        t896 = self.constants[32] * t849 - t895;
        t899 = self.constants[65] + self.constants[71] - t896 - t896;
        t904 = self.constants[46] + self.constants[53] + t344 * t796 + t403 * t798
            + t407 * t802 + t899;
        t905 = t904 - t888;
        t906 = t9 * t13;
        t908 = t9 * t9;
        t909 = t866 + t866;
        t915 = self.constants[41] + t845 + self.constants[62] + self.constants[72];
        t922 = self.constants[40] + t849 + t855 + self.constants[67]
            - self.constants[61];
        t928 = t866 + t905 * t906 + self.constants[7] * (t9 * t915 + t13 * t922)
            - t908 * t909;
        t932 = t13 * t915 - t9 * t922;
        t935 = self.constants[7] * (t932 - self.constants[73]);
        t939 = self.constants[7] * t932;
        t942 = self.constants[74] - t939 - t939;
        t948 = self.constants[43] + self.constants[52] + t876 + t882 + t899 + t367 * t819
            + cos_theta * t821;
        t950 = t948 + t942 - t403 * t825;
        t955 = self.constants[7] * (t806 + t809);
        t957 = t13 * t815 + t955 - t9 * t836;
        t960 = t935 + t576 * t950 + t697 * t957;
        t965 = t905 * t908 + t906 * t909;
        t966 = t904 - t965;
        t969 = t955 - t576 * t957 - t697 * t966;
        t971 = self.constants[0].like(1.0) - t576;
        t972 = self.constants[27] * t783;
        t975 = t9 * sin_delta;
        t978 = t243 - cos_delta * t576 - t697 * t975;
        t984 = t229 + cos_delta * t783 - t13 * sin_delta - t785 * t975;
        t985 = self.constants[28] * t984;
        t991 = t971 * t972 + t978 * t985 - t576 * t838 - t697 * t928 - t783 * t960
            - t785 * t969;
        t1010 = t888 + t942 + t965 + t783 * t838
            + t783 * (t838 + t783 * t950 - t785 * t957) + t783 * t972;
        t1013 = t1010 + t984 * t985 - t785 * t928
            - t785 * (t928 + t783 * t957 - t785 * t966);
        t1014 = self.constants[0].like(1.0) / t1013;
        t1015 = t991 * t1014;
        t1018 = t116 - sin_phi * t120;
        t1020 = t13 * self.constants[7] * t809;
        t1021 = t811 + t1020;
        t1023 = cos_phi * t120;
        t1026 = t1021 + t950 * t1018 - t957 * t1023;
        t1028 = self.constants[53] + t895;
        t1031 = t13 * t1028 - t9 * t857;
        t1035 = t1031 + t957 * t1018 - t966 * t1023;
        t1039 = self.constants[27] * t1018;
        t1044 = t238 + cos_delta * t1018 - t975 * t1023;
        t1045 = self.constants[28] * t1044;
        t1060 = t9 * t1028 + t13 * t857 + self.constants[7] * t855 + t838 * t1018
            + t783 * t1026 + t972 * t1018;
        t1064 = t1014 * (t1060 + t985 * t1044 - t928 * t1023 - t785 * t1035);
        t1065 = t1013 * t1064;
        t1071 = self.constants[53] + t1018 * t1026 + t1018 * t1021 + t1018 * t1039
            + t1044 * t1045 - t1023 * t1035;
        t1073 = t1071 - t1023 * t1031 - t1064 * t1065;
        t1074 = self.constants[0].like(1.0) / t1073;
        t1086 = t1020 + t971 * t1039 + t978 * t1045 - t960 * t1018 - t969 * t1023
            - t576 * t1021;
        t1089 = t1074 * (t1086 - t697 * t1031 - t1015 * t1065);
        t1099 = forces[1] + t764 * t1023 - t716 - t695 * t1018 - t238 * t669
            - t793 * t1064;
        t1102 = t403 * self.constants[75];
        t1104 = t367 * self.constants[75];
        t1107 = self.constants[7] * (t9 * t1102 - t13 * t1104);
        t1117 = t367 * self.constants[76] + self.constants[32] * t1102 - t1107
            - t403 * self.constants[77] - self.constants[33] * t1104;
        t1121 = cos_theta * self.constants[75];
        t1124 = t344 * self.constants[76] + t407 * self.constants[77]
            - self.constants[32] * t1121;
        t1130 = t364 * self.constants[76] + t344 * self.constants[77]
            - self.constants[33] * t1121;
        t1132 = t13 * t1124 - t9 * t1130;
        t1143 = t1014
            * (t9 * t1124 + t13 * t1130 + self.constants[7] * t1121 + t783 * t1117
                - t785 * t1132);
        t1144 = t1013 * t1143;
        t1151 = t1074 * (t1018 * t1117 - t1023 * t1132 - t1065 * t1143);
        t1152 = t1073 * t1151;
        t1162 = self.constants[78] - t1143 * t1144 - t1151 * t1152;
        t1163 = self.constants[0].like(1.0) / t1162;
        t1164 = (t1107 + t576 * t1117 + t697 * t1132 + t1015 * t1144 + t1089 * t1152)
            * t1163;
        t1178 = forces[2] - self.constants[3] * t609 - self.constants[2] * t632
            - positions[6] * self.constants[5] - speeds[2] * self.constants[6]
            - t793 * t1143;
        t1179 = t1178 - t1099 * t1151;
        t1185 = t576 * t695 + t697 * t764 + t1164 * t1179 + t575 - t243 * t669
            - t793 * t1015;
        t1206 = t576 * t960 + t576 * t935 + self.constants[79]
            + self.constants[27] * t971 * t971 + self.constants[28] * t978 * t978
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
        t1241 = self.constants[7] * t1239 - t160;
        t1243 = t159 + t9 * t1241;
        t1248 = t304 - t1243 - self.constants[30] * t1238;
        t1253 = t166 - cos_phi * t1234;
        t1256 = t13 * t1226 - t172 - t9 * t1253;
        t1259 = cos_delta * t1238 - t282 - sin_delta * t1256;
        t1262 = t509 + self.constants[47] * t1248 - self.constants[48] * t1259;
        t1265 = t348 - t13 * t1241;
        t1267 = t358 + self.constants[33] * t1238 + t1265;
        t1272 = t168 + t13 * t1253 + t9 * t1226;
        t1278 = t177 + t380 - self.constants[7] * (t175 + t1226);
        t1281 = t371 - self.constants[32] * t1272 - self.constants[33] * t1256 - t1278;
        t1285 = self.constants[32] * t1238 - t390 - t1243;
        t1288 = t364 * t1267 + t367 * t1281 + t344 * t1285;
        t1295 = t422 + cos_theta * t1238 + t403 * t1272 - t367 * t1256;
        t1298 = self.constants[24] * t1288 + self.constants[55] * t1295 - t442;
        t1304 = cos_theta * t1281 + t403 * t1285 - t367 * t1267;
        t1313 = t344 * t1256 + t407 * t1272 + self.constants[2] * t1216 - t452
            - t403 * t1238;
        t1322 = t460 + t364 * t1256 + t367 * t1238 + t344 * t1272
            + self.constants[3] * t1216;
        t1326 = t471 + self.constants[24] * t1304 + self.constants[54] * t1313
            - self.constants[55] * t1322;
        t1332 = t344 * t1267 + t407 * t1285 - t403 * t1281;
        t1336 = t485 + self.constants[24] * t1332 - self.constants[54] * t1295;
        t1339 = t344 * t1298 + t403 * t1326 + t407 * t1336;
        t1343 = t147 + t1262 + t1339 - self.constants[44] * t1243
            - self.constants[40] * t1238;
        t1351 = t364 * t1298 + t344 * t1336 - t367 * t1326;
        t1354 = t1265 + self.constants[31] * t1238 - t188;
        t1360 = t165 + self.constants[30] * t1272 - t1278 - self.constants[31] * t1256;
        t1362 = cos_delta * t1354 + sin_delta * t1360;
        t1366 = self.constants[47] * t1362 + self.constants[49] * t1259 - t540;
        t1370 = cos_delta * t1360 - sin_delta * t1354;
        t1372 = t1220 + t1272;
        t1377 = t214 + cos_delta * t1256 + sin_delta * t1238;
        t1381 = t556 + self.constants[47] * t1370 + self.constants[48] * t1372
            - self.constants[49] * t1377;
        t1383 = cos_delta * t1366 - sin_delta * t1381;
        t1387 = self.constants[44] * t1265 + self.constants[41] * t1238 + t1351 + t1383
            - t567;
        t1389 = t9 * t1343 + t13 * t1387;
        t1397 = self.constants[28]
            * (t667 + t1259 + t229 * t1226 + t238 * t1220 + t243 * t1211);
        t1398 = t228 * t1397;
        t1409 = t606 + self.constants[56] * t1322 + self.constants[57] * t1313
            - self.constants[55] * t1304;
        t1416 = t619 + self.constants[55] * t1288 + self.constants[58] * t1295
            - self.constants[54] * t1332;
        t1423 = t629 + self.constants[54] * t1304 + self.constants[57] * t1322
            + self.constants[59] * t1313;
        t1432 = t652 + self.constants[50] * t1377 + self.constants[51] * t1372
            - self.constants[49] * t1370;
        t1440 = t675 + t1397 + self.constants[49] * t1362 + self.constants[52] * t1259
            - self.constants[48] * t1248;
        t1449 = t592 + self.constants[41] * t1265 + self.constants[40] * t1243
            + self.constants[43] * t1238 + self.constants[27] * t1239 + t367 * t1409;
        t1454 = t1449 + cos_theta * t1416 + self.constants[33] * t1351
            + self.constants[32] * t1339 + sin_delta * t1432 + cos_delta * t1440;
        t1458 = t1454 + self.constants[31] * t1383 - t403 * t1423
            - self.constants[30] * t1262 - self.constants[7] * t1389;
        t1473 = t367 * t1298 + cos_theta * t1326 - t403 * t1336;
        t1477 = sin_delta * t1366 + cos_delta * t1381;
        t1484 = t707 + t713 + self.constants[42] * t1256 + self.constants[46] * t1272
            + self.constants[48] * t1370 + self.constants[51] * t1377
            + self.constants[53] * t1372;
        t1489 = t1484 + t344 * t1409 + t403 * t1416 + t407 * t1423
            + self.constants[30] * t1477 - self.constants[40] * t1278;
        t1506 = t745 + self.constants[41] * t1278 + self.constants[45] * t1256
            + self.constants[42] * t1272 + t364 * t1409 + t344 * t1423;
        t1511 = t1506 + cos_delta * t1432 - t367 * t1416 - self.constants[33] * t1473
            - sin_delta * t1440 - self.constants[31] * t1477;
        t1516 = sin_phi * t1458
            + cos_phi * (t13 * (t1489 - self.constants[32] * t1473) - t9 * t1511);
        t1518 = t82 * (t1516 - t225 * t1398);
        t1520 = t36 * t1398 - t43 * t1518;
        t1521 = t1389 - t1520;
        t1526 = t43 * t1398 + t36 * t1518;
        t1534 = t775 + t1473 + t1477 + self.constants[40] * t1272
            - self.constants[44] * t1278 - self.constants[41] * t1256;
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

#[allow(unused_variables)]
impl<T: Scalar> carvallo::motion::UncheckedPartials for WhippleLeaningMotion<T> {
    type State = [T; 13];

    type ByState = [[T; 13]; 13];

    type ByForces = [[T; 3]; 13];

    type Parameters = [T; 36];

    type ByParameters = [[T; 36]; 13];

    fn linearize_unchecked(
        &self, positions: &[T; 9], speeds: &[T; 4], forces: &[T; 3],
    ) -> ([[T; 13]; 13], [[T; 3]; 13]) {
        let (
            zero, sin_phi, cos_phi, t6, sin_pitch, cos_pitch, t14, sin_delta, cos_delta, t18, t21,
            t22, t26, t27, t30, t31, t32, t34, t35, t37, t39, t40, t41, t42, t45, t51, t53, t56,
            t57, t58, t62, t64, t69, t71, t72, t78, t80, t82, t85, t86, t89, t91, t92, t93, sin_psi,
            cos_psi, t96, t98, t99, t100, t106, t107, t108, t110, t111, t113, t114, t115, t117,
            t120, t124, t125, t128, t130, t131, t134, t135, t138, t143, t145, t149, t153, t155,
            t157, t159, t162, t166, t171, t173, t176, t180, t182, t185, t191, t195, t199, t201,
            t203, t205, t211, t213, t216, t220, t223, t227, t231, t233, t235, t238, t240, t242,
            t245, t247, t260, t264, t268, t273, t279, t286, t296, t301, t303, t311, t313, t318,
            t325, t326, t327, t328, t329, t330, t339, t341, t342, t344, t345, t351, t353, t357,
            t358, t362, t363, t364, t365, t369, t371, t373, t374, t376, t379, t387, t390, t397,
            t403, t407, t410, t413, t415, t419, t422, t424, t428, t429, t431, t435, t436, t438,
            t440, t447, t448, t453, t458, t461, t465, t472, t481, t486, t488, t490, t506, t511,
            t512, t516, t518, t519, t523, t524, t525, t527, t528, t537, t539, t543, t545, t555,
            t556, t561, t566, t568, t573, t586, t592, t594, t597, t600, t608, t612, t617, t620,
            t629, t634, t642, t649, t668, t673, t675, t678, t682, t690, t693, sin_theta, cos_theta,
            t698, t701, t705, t707, t711, t721, t722, t725, t728, t731, t732, t737, t741, t743,
            t748, t750, t751, t754, t760, t761, t764, t765, t766, t769, t774, t775, t776, t778,
            t791, t796, t800, t801, t803, t809, t814, t817, t819, t820, t823, t829, t832, t833,
            t834,
        );
        zero = self.constants[0].like(0.0);
        (sin_phi, cos_phi) = positions[3].sin_cos();
        t6 = self.constants[7] * sin_phi;
        (sin_pitch, cos_pitch) = positions[4].sin_cos();
        t14 = self.constants[3] * sin_pitch + self.constants[2] * cos_pitch;
        (sin_delta, cos_delta) = positions[5].sin_cos();
        t18 = t14 * cos_phi;
        t21 = sin_phi * sin_delta;
        t22 = t21 - cos_delta * t18;
        t26 = self.constants[3] * cos_pitch - sin_pitch * self.constants[2];
        t27 = cos_phi * t26;
        t30 = (t22 * t22 + t27 * t27).sqrt();
        t31 = self.constants[0].like(1.0) / t30;
        t32 = t22 * t31;
        t34 = t27 * t31;
        t35 = cos_delta * t34;
        t37 = t26 * t35 - t14 * t32;
        t39 = sin_phi * cos_delta;
        t40 = t18 * sin_delta;
        t41 = t39 + t40;
        t42 = self.constants[8] * t41;
        t45 = sin_delta * self.constants[37];
        t51 = self.constants[30] + cos_delta * self.constants[37];
        t53 = t26 * self.constants[39] - t14 * t51;
        t56 = cos_phi * t45 - t37 * t42 - sin_phi * t53;
        t57 = t6 + t56;
        t58 = sin_delta * t34;
        t62 = t26 * t32 + t14 * t35;
        t64 = cos_phi * t58 + sin_phi * t62;
        t69 = t42 * t64 + t14 * self.constants[39] + t26 * t51;
        t71 = self.constants[0].like(1.0) / (cos_phi * t69);
        t72 = t57 * t71;
        t78 = t26 * self.constants[31] - t14 * self.constants[30];
        t80 = t56 + sin_phi * t78;
        t82 = sin_phi * t26;
        t85 = t14 * self.constants[31] + t26 * self.constants[30];
        t86 = t69 - t85;
        t89 = t71 * (t14 * t80 + t82 * t86);
        t91 = speeds[0] * t72 + speeds[1] * t89;
        t92 = speeds[3] + t91;
        t93 = self.constants[7] * t92;
        (sin_psi, cos_psi) = positions[2].sin_cos();
        t96 = t93 * sin_psi;
        t98 = self.constants[7] * cos_psi;
        t99 = t71 * t72;
        t100 = sin_phi * t69;
        t106 = sin_phi * t45 + cos_phi * t53;
        t107 = t14 * t72;
        t108 = sin_phi * self.constants[39];
        t110 = t26 * t72;
        t111 = sin_phi * t51;
        t113 = t37 * self.constants[8];
        t114 = cos_delta * cos_phi;
        t115 = t14 * sin_delta;
        t117 = cos_phi * sin_delta;
        t120 = t114 + t110 * t117 - sin_phi * t115;
        t124 = t14 * cos_delta;
        t125 = sin_phi * t124;
        t128 = t31 * t114;
        t130 = t31 * t31;
        t131 = t22 * t130;
        t134 = t31 * self.constants[0].like(0.5);
        t135 = (t27 + t27) * t134;
        t138 = t134 * (t22 + t22);
        t143 = cos_phi * t135;
        t145 = t114 * t138;
        t149 = t117 * t138 - sin_phi * (t26 * t135 - t124 * t138) - t107 * t143
            - t110 * t145;
        t153 = t31 * t125 + t31 * t117 - t110 * t128 - t131 * t149;
        t155 = cos_delta * t26;
        t157 = cos_phi * t31;
        t159 = t27 * t130;
        t162 = t31 * t82 + t107 * t157 + t149 * t159;
        t166 = t35 * t107 + t32 * t110 + t14 * t153 + t155 * t162;
        t171 = t107 * t108 + t110 * t111 + t42 * t166 - t106 - t113 * t120;
        t173 = cos_phi * t99;
        t176 = self.constants[8] * t64;
        t180 = sin_phi * t32;
        t182 = sin_phi * t35;
        t185 = t117 + t125;
        t191 = cos_phi * t62 + t110 * t182 + t82 * t153 - sin_phi * t58 - t107 * t180
            - t162 * t185;
        t195 = self.constants[39] * t110 + t120 * t176 + t42 * t191 - t51 * t107;
        t199 = t99 * t100 + self.constants[7] * cos_phi * t71 + t71 * t171 - t173 * t195;
        t201 = t71 * t89;
        t203 = t26 * t86;
        t205 = t14 * t71;
        t211 = t71 * t82;
        t213 = sin_phi * self.constants[31];
        t216 = sin_phi * t71 * t86 + t205 * t213 - self.constants[30] * t211;
        t220 = sin_phi * self.constants[30];
        t223 = t71 * t80 - self.constants[31] * t211 - t205 * t220;
        t227 = t211 - cos_phi * t201;
        t231 = t100 * t201 + cos_phi * (t71 * t203 + t78 * t205) + t110 * t223
            + t171 * t205;
        t233 = t231 + t195 * t227 - t107 * t216;
        t235 = speeds[0] * t199 + speeds[1] * t233;
        t238 = t14 * self.constants[37];
        t240 = t14 * t89;
        t242 = t26 * t89;
        t245 = t117 * t242 - t22;
        t247 = sin_delta * t26;
        t260 = t39 * t138 + t40 * t138 - t143 * t240 - t145 * t242;
        t264 = t31 * t39 + t31 * t40 - t128 * t242 - t131 * t260;
        t268 = t157 * t240 + t159 * t260;
        t273 = t34 * t247 + t35 * t240 + t32 * t242 + t14 * t264 + t155 * t268;
        t279 = self.constants[37] * t114 + t108 * t240 + t111 * t242 + t42 * t273
            - t21 * t238 - t113 * t245;
        t286 = sin_phi * t14;
        t296 = t34 * t114 + t182 * t242 + t82 * t264 - t58 * t286 - t180 * t240
            - t185 * t268;
        t301 = self.constants[39] * t242 + t176 * t245 + t42 * t296
            - self.constants[37] * t247 - t51 * t240;
        t303 = t71 * t279 - t173 * t301;
        t311 = t223 * t242 + t205 * t279 + t227 * t301 - t216 * t240;
        t313 = speeds[0] * t303 + speeds[1] * t311;
        t318 = self.constants[7] * sin_psi;
        t325 = t37 * t69 + t57 * t64;
        t326 = self.constants[0].like(1.0) / t325;
        t327 = self.constants[7] * t64;
        t328 = t326 * t327;
        t329 = t326 * t328;
        t330 = speeds[3] * t329;
        t339 = cos_phi * t327 + t64 * t171 + t57 * t191 + t37 * t195 - t69 * t166;
        t341 = self.constants[7] * t326;
        t342 = speeds[3] * t341;
        t344 = t72 * t326;
        t345 = sin_phi * t64;
        t351 = sin_phi * t57;
        t353 = sin_phi * t37;
        t357 = cos_phi * (t325 + self.constants[7] * t345) + t171 * t345 + t191 * t351
            + t195 * t353;
        t358 = t357 - t100 * t166;
        t362 = t37 * t100 + t64 * t351;
        t363 = t326 * t362;
        t364 = t72 * t363;
        t365 = t326 * t364;
        t369 = t344 * t358 + t199 * t363 - t339 * t365;
        t371 = t37 * t326;
        t373 = t64 * t326;
        t374 = t26 * t80;
        t376 = t53 - t78;
        t379 = t82 * t373 - t14 * t371;
        t387 = t106 + t30 * self.constants[8] - cos_phi * t78;
        t390 = t26 * t387 + t27 * t78;
        t397 = cos_phi * t86 - t27 * self.constants[30];
        t403 = sin_phi * t387 + cos_phi * t80 + t27 * t213;
        t407 = cos_phi * self.constants[39] - cos_phi * self.constants[31];
        t410 = t371 * t397 + t373 * t403 + t379 * t407;
        t413 = t387 + t27 * self.constants[31];
        t415 = t27 * t220;
        t419 = cos_phi * self.constants[30] - cos_phi * t51;
        t422 = t379 * t419 - t371 * t413 - t373 * t415;
        t424 = self.constants[8] * t379;
        t428 = t27 * t86 - t14 * t387;
        t429 = t326 * t428;
        t431 = t27 * t373;
        t435 = t82 * t387 + t27 * t80;
        t436 = t326 * t435;
        t438 = t27 * t371;
        t440 = t89 * t326;
        t447 = t326 * (t37 * t428 + t64 * t435 + t89 * t362);
        t448 = t326 * t447;
        t453 = cos_phi * (t373 * t390 + t45 * t379) + t110 * t422 + t149 * t424
            + t171 * t431;
        t458 = t453 + t191 * t436 + t195 * t438 + t358 * t440 + t233 * t363
            - sin_phi * (t203 * t371 + t373 * t374 + t376 * t379);
        t461 = t458 - t107 * t410 - t166 * t429 - t339 * t448;
        t465 = t330 * t339 - (t191 * t342 + speeds[0] * t369 + speeds[1] * t461);
        t472 = t64 * t279 + t57 * t296 + t37 * t301 - t69 * t273;
        t481 = t279 * t345 + t296 * t351 + t301 * t353 - t100 * t273;
        t486 = t344 * t481 + t303 * t363 - t365 * t472;
        t488 = self.constants[37] * t39;
        t490 = t238 * t117;
        t506 = t379 * t488 + t379 * t490 + t242 * t422 + t260 * t424 + t279 * t431
            + t296 * t436;
        t511 = t506 + t301 * t438 + t440 * t481 + t311 * t363 - t240 * t410
            - t273 * t429;
        t512 = t511 - t448 * t472;
        t516 = t330 * t472 - (t296 * t342 + speeds[0] * t486 + speeds[1] * t512);
        t518 = self.constants[0].like(1.0) / self.constants[8];
        t519 = self.constants[7] * t518;
        t523 = t64 * t69 - t37 * t57;
        t524 = t518 * t523;
        t525 = t341 * t524;
        t527 = t328 * t518;
        t528 = self.constants[7] * t37;
        t537 = t57 * t166 + t69 * t191 + t64 * t195 - cos_phi * t528 - t37 * t171;
        t539 = t329 * t524;
        t543 = t191 * t525 + t527 * t537 - t166 * t519 - t339 * t539;
        t545 = speeds[0] * t518;
        t555 = cos_phi * (t523 - self.constants[7] * t353) + t166 * t351 + t100 * t191
            + t195 * t345;
        t556 = t555 - t171 * t353;
        t561 = t64 * t100 - t37 * t351;
        t566 = t364 * t537 + t369 * t523 - t72 * t556 - t199 * t561;
        t568 = speeds[1] * t518;
        t573 = t14 * t64 + t37 * t82;
        t586 = t37 * t403 + t407 * t573 - t64 * t397;
        t592 = t64 * t413 + t419 * t573 - t37 * t415;
        t594 = self.constants[8] * t573;
        t597 = t27 * t37;
        t600 = t27 * t64;
        t608 = cos_phi * (t37 * t390 + t45 * t573) + t110 * t592 + t149 * t594
            + t171 * t597;
        t612 = t608 + t447 * t537 + t461 * t523
            - sin_phi * (t37 * t374 + t376 * t573 - t64 * t203) - t107 * t586;
        t617 = t612 - t166 * t435 - t191 * t428 - t195 * t600 - t89 * t556 - t233 * t561;
        t620 = speeds[3] * t543 + t545 * t566 + t568 * t617;
        t629 = t57 * t273 + t69 * t296 + t64 * t301 - t37 * t279;
        t634 = t296 * t525 + t527 * t629 - t273 * t519 - t472 * t539;
        t642 = t273 * t351 + t100 * t296 + t301 * t345 - t279 * t353;
        t649 = t364 * t629 + t486 * t523 - t72 * t642 - t303 * t561;
        t668 = t488 * t573 + t490 * t573 + t242 * t592 + t260 * t594 + t279 * t597
            + t447 * t629;
        t673 = t668 + t512 * t523 - t240 * t586 - t273 * t435 - t296 * t428
            - t301 * t600;
        t675 = t673 - t89 * t642 - t311 * t561;
        t678 = speeds[3] * t634 + t545 * t649 + t568 * t675;
        t682 = t518 * (t364 * t523 - t72 * t561);
        t690 = t518 * (t37 * t435 + t447 * t523 - t64 * t428 - t89 * t561);
        t693 = t518 * (t528 + t328 * t523);
        (sin_theta, cos_theta) = positions[6].sin_cos();
        t698 = self.constants[0].like(1.0) - cos_theta;
        t701 = cos_theta + t698 * self.constants[34];
        t705 = t698 * self.constants[35];
        t707 = t705 * self.constants[57];
        t711 = self.constants[2] * sin_theta;
        t721 = sin_delta * self.constants[66];
        t722 = sin_delta * t721;
        t725 = t705 * self.constants[54];
        t728 = cos_theta + t698 * self.constants[36];
        t731 = t725 + t728 * self.constants[55];
        t732 = self.constants[33] * t731;
        t737 = t732 + t732 + self.constants[63] + self.constants[68];
        t741 = self.constants[45] + self.constants[50]
            + t701 * (t701 * self.constants[56] + t707)
            + t711 * t711 * self.constants[58]
            + t705 * (t701 * self.constants[57] + t705 * self.constants[59]);
        t743 = t741 + t737 - t722;
        t748 = self.constants[56] * t705 + self.constants[57] * t728;
        t750 = self.constants[3] * sin_theta;
        t751 = self.constants[58] * t750;
        t754 = t707 + self.constants[59] * t728;
        t760 = t705 * self.constants[55];
        t761 = t701 * self.constants[54] + t760;
        t764 = cos_delta * self.constants[48];
        t765 = self.constants[30] * t764;
        t766 = self.constants[32] * t761 - t765;
        t769 = self.constants[65] + self.constants[71] - t766 - t766;
        t774 = self.constants[46] + self.constants[53] + t705 * t748 + t750 * t751
            + t728 * t754 + t769;
        t775 = t774 - t743;
        t776 = t14 * t14;
        t778 = t14 * t26;
        t791 = cos_delta * self.constants[51] - self.constants[31] * t764;
        t796 = self.constants[42] + t701 * t748 + t705 * t754 + t731 * self.constants[32]
            + self.constants[64] + t791;
        t800 = t796 - t711 * t751 - self.constants[33] * t761 - self.constants[69]
            - self.constants[70];
        t801 = t800 + t800;
        t803 = t775 * t776 + t778 * t801;
        t809 = t731 + self.constants[41] + self.constants[62] + self.constants[72];
        t814 = self.constants[40] + self.constants[67];
        t817 = t761 + t764 + t814 - self.constants[61];
        t819 = t26 * t809 - t14 * t817;
        t820 = self.constants[7] * t819;
        t823 = self.constants[74] - t820 - t820;
        t829 = t711 * self.constants[54] - self.constants[55] * t750;
        t832 = sin_delta * self.constants[48];
        t833 = self.constants[31] * t832;
        t834 = sin_delta * self.constants[51] - t833;
        let (
            t838, t842, t844, t848, t857, t859, t861, t871, t872, t884, t886, t891, t893, t899,
            t905, t910, t911, t913, t919, t922, t923, t924, t929, t930, t932, t933, t934, t938,
            t942, t943, t944, t945, t947, t950, t953, t959, t960, t962, t965, t966, t967, t969,
            t970, t971, t973, t974, t977, t978, t980, t981, t982, t984, t986, t988, t989, t992,
            t996, t999, t1000, t1001, t1003, t1004, t1007, t1008, t1009, t1012, t1014, t1018, t1021,
            t1023, t1026, t1027, t1028, t1030, t1032, t1034, t1036, t1038, t1040, t1043, t1045,
            t1046, t1048, t1054, t1058, t1063, t1064, t1065, t1069, t1071, t1078, t1084, t1086,
            t1090, t1104, t1108, t1110, t1115, t1119, t1121, t1123, t1126, t1132, t1135, t1136,
            t1139, t1142, t1143, t1144, t1146, t1148, t1153, t1158, t1159, t1161, t1162, t1163,
            t1165, t1168, t1170, t1173, t1178, t1182, t1184, t1186, t1188, t1191, t1198, t1199,
            t1200, t1206, t1208, t1209, t1215, t1220, t1223, t1224, t1228, t1231, t1233, t1235,
            t1237, t1240, t1246, t1252, t1256, t1257, t1263, t1266, t1267, t1270, t1273, t1280,
            t1283, t1288, t1290, t1291, t1292, t1294, t1296, t1301, t1304, t1307, t1313, t1315,
            t1318, t1323, t1329, t1331, t1333, t1334, t1335, t1337, t1339, t1344, t1347, t1350,
            t1352, t1358, t1362, t1367, t1369, t1372, t1380, t1382, t1385, t1388, t1393, t1403,
            t1405, t1408, t1412, t1419, t1424, t1430, t1432, t1439, t1446, t1454, t1460, t1466,
            t1472, t1474, t1479, t1480, t1481, t1484, t1494, t1500, t1502, t1507, t1512, t1515,
            t1519, t1526, t1527, t1529, t1534, t1536, t1538, t1539, t1540, t1544, t1548, t1552,
            t1557, t1558, t1564, t1568, t1573, t1575, t1577, t1583, t1585, t1586, t1596, t1599,
            t1601, t1606, t1611, t1614, t1616, t1620, t1621, t1626, t1627, t1629, t1640, t1644,
            t1646,
        );
        t838 = t711 * t748 + cos_theta * t751 + t834 - t750 * t754
            - self.constants[33] * t829;
        t842 = self.constants[56] * t711 - self.constants[57] * t750;
        t844 = cos_theta * self.constants[58];
        t848 = self.constants[57] * t711 - self.constants[59] * t750;
        t857 = t701 * t842 + t705 * t848 + self.constants[32] * t829 + cos_delta * t721
            - t711 * t844 - self.constants[30] * t832;
        t859 = t14 * t838 + t26 * t857;
        t861 = t72 - sin_phi * t364;
        t871 = t800 + t775 * t778 + self.constants[7] * (t14 * t809 + t26 * t817)
            - t776 * t801;
        t872 = cos_phi * t364;
        t884 = t722 + t737 + t769 + t823 + self.constants[43] + self.constants[52]
            + t711 * t842;
        t886 = t884 + cos_theta * t844 - t750 * t848;
        t891 = self.constants[7] * (t829 + t832);
        t893 = t26 * t838 + t891 - t14 * t857;
        t899 = t774 - t803;
        t905 = t861 * self.constants[27];
        t910 = t247 + t115 * t872 - cos_delta * t861;
        t911 = t682 - t910;
        t913 = t911 * self.constants[28];
        t919 = t743 + t803 + t823 + t859 * t861
            + t861 * (t859 + t861 * t886 - t872 * t893) + t861 * t905;
        t922 = t919 + t911 * t913 - t871 * t872
            - t872 * (t871 + t861 * t893 - t872 * t899);
        t923 = self.constants[0].like(1.0) / t922;
        t924 = speeds[0] * t26;
        t929 = speeds[0] * t364 + speeds[1] * t447 + speeds[3] * t328;
        t930 = cos_phi * t929;
        t932 = t924 + t14 * t930;
        t933 = sin_phi * t929;
        t934 = t91 - t933;
        t938 = self.constants[43] * t934 + self.constants[27] * (speeds[3] + t934);
        t942 = speeds[0] * t14;
        t943 = t942 - t26 * t930;
        t944 = self.constants[42] * t943;
        t945 = self.constants[45] * t932 + t944;
        t947 = t932 * t938 - t934 * t945;
        t950 = cos_delta * t932 + sin_delta * t934;
        t953 = cos_delta * t934 - sin_delta * t932;
        t959 = speeds[0] * t682 + speeds[1] * t690 + speeds[3] * t693;
        t960 = t953 + t959;
        t962 = self.constants[52] * t953 + self.constants[28] * t960;
        t965 = speeds[1] + t943;
        t966 = self.constants[51] * t965;
        t967 = self.constants[50] * t950 + t966;
        t969 = t950 * t962 - t953 * t967;
        t970 = self.constants[7] * t933;
        t971 = t930 * t970;
        t973 = sin_phi * self.constants[60];
        t974 = t92 * t930;
        t977 = t971 - self.constants[7] * t974;
        t978 = t973 + t977;
        t980 = t91 * t943;
        t981 = speeds[0] * t933;
        t982 = self.constants[31] * t934;
        t984 = self.constants[30] * t934;
        t986 = t943 * t982 + t932 * t984;
        t988 = t91 * t932;
        t989 = t26 * t981 + t988;
        t992 = t980 + t14 * t981;
        t996 = t986 + self.constants[30] * t989 + self.constants[31] * t992 - t977;
        t999 = self.constants[30] * t943;
        t1000 = self.constants[31] * t932;
        t1001 = t999 - t1000;
        t1003 = t934 * t984 + t943 * t1001;
        t1004 = speeds[0] * t930;
        t1007 = self.constants[7] * speeds[0];
        t1008 = t930 * t1007;
        t1009 = self.constants[7] * t1004 + t1008;
        t1012 = t92 - t933;
        t1014 = t970 * t1012 - speeds[0] * t1007;
        t1018 = t26 * t1009 + t14 * t1014 - t1003 - self.constants[31] * t1004;
        t1021 = t953 * self.constants[38];
        t1023 = self.constants[37] * t953;
        t1026 = cos_delta * t992;
        t1027 = sin_delta * t1004;
        t1028 = speeds[1] * t953;
        t1030 = t1028 - t1026 - t1027;
        t1032 = t32 * self.constants[8];
        t1034 = t989 + t950 * t959;
        t1036 = t34 * self.constants[8];
        t1038 = t1030 - t959 * t965;
        t1040 = t31 * t41;
        t1043 = t32 * t950 + t34 * t965;
        t1045 = self.constants[8] * t1040 * t1043;
        t1046 = t34 * t1045;
        t1048 = t32 * t1045;
        t1054 = cos_delta * t996 + t965 * t1021 + t950 * t1023
            + self.constants[37] * t989 + t1032 * t1034 + t965 * t1046;
        t1058 = t1054 + t950 * t1048 - sin_delta * t1018 - self.constants[38] * t1030
            - t1036 * t1038;
        t1063 = self.constants[37] * t965;
        t1064 = t950 * self.constants[38];
        t1065 = t1063 - t1064;
        t1069 = speeds[1] * t950;
        t1071 = sin_delta * t992 - cos_delta * t1004 - t1069;
        t1078 = self.constants[8] * (t32 * t965 - t34 * t950);
        t1084 = cos_delta * t1018 + sin_delta * t996 + self.constants[38] * t1071
            + t1036 * t1071 - t953 * t1023 - t965 * t1065;
        t1086 = t1084 - t960 * t1048 - t965 * t1078;
        t1090 = t932 * t1001 - t934 * t982;
        t1104 = t1090 + self.constants[30] * t1004 + t14 * t1009 + t950 * t1065
            + t950 * t1078 - t26 * t1014;
        t1108 = t1104 - t953 * t1021 - self.constants[37] * t1071 - t1032 * t1071
            - t960 * t1046;
        t1110 = t32 * t1086 + t34 * t1108;
        t1115 = t71 * (t41 * t1058 + t30 * t1110);
        t1119 = t326 * (t30 * t1058 + t362 * t1115 - t41 * t1110);
        t1121 = t981 - cos_phi * t1119;
        t1123 = t980 + t14 * t1121;
        t1126 = t988 + t26 * t1121;
        t1132 = t986 + self.constants[30] * t1126 + self.constants[31] * t1123 - t978;
        t1135 = t1004 - t1115;
        t1136 = sin_phi * t1119 + t1135;
        t1139 = self.constants[7] * t1136 + t1008;
        t1142 = t1014 + cos_phi * self.constants[60];
        t1143 = t14 * t1142;
        t1144 = t1143 + t26 * t1139;
        t1146 = t1144 - self.constants[31] * t1136 - t1003;
        t1148 = cos_delta * t1132 - sin_delta * t1146;
        t1153 = t1028 - sin_delta * t1136 - cos_delta * t1123;
        t1158 = t969 + self.constants[48] * t1148 + self.constants[51] * t1153
            + self.constants[53] * t1126;
        t1159 = self.constants[32] * t934;
        t1161 = self.constants[32] * t943;
        t1162 = self.constants[33] * t932;
        t1163 = t1161 + t1162;
        t1165 = t934 * t1159 + t943 * t1163;
        t1168 = t1144 + t1165 - self.constants[33] * t1136;
        t1170 = self.constants[33] * t934;
        t1173 = t943 * t1170 - t932 * t1159;
        t1178 = t1173 + self.constants[33] * t1123 - t978 - self.constants[32] * t1126;
        t1182 = t932 * t1163 + t934 * t1170;
        t1184 = t26 * t1142;
        t1186 = t1184 - t14 * t1139;
        t1188 = self.constants[32] * t1136 + t1182 + t1186;
        t1191 = cos_theta * t1178 - t750 * t1188 - t711 * t1168;
        t1198 = cos_theta * t934 + t750 * t943 - t711 * t932;
        t1199 = self.constants[2] * t1198;
        t1200 = speeds[2] * t1199;
        t1206 = t1200 - t711 * t1136 + t705 * t1126 - t701 * t1123;
        t1208 = self.constants[3] * t1198;
        t1209 = speeds[2] * t1208;
        t1215 = t728 * t1126 - t1209 - t705 * t1123 + t750 * t1136;
        t1220 = self.constants[3] * speeds[2];
        t1223 = t701 * t932 + t711 * t934 + t705 * t943 + t1220;
        t1224 = self.constants[57] * t1223;
        t1228 = self.constants[2] * speeds[2];
        t1231 = t705 * t932 + t728 * t943 + t1228 - t750 * t934;
        t1233 = t1224 + self.constants[59] * t1231;
        t1235 = self.constants[58] * t1198;
        t1237 = t1198 * t1233 - t1231 * t1235;
        t1240 = self.constants[56] * t1206 + self.constants[57] * t1215 + t1237
            - self.constants[55] * t1191;
        t1246 = t701 * t1168 + t711 * t1178 - t705 * t1188;
        t1252 = t705 * t1168 - t728 * t1188 - t750 * t1178;
        t1256 = self.constants[3] * t1231 - self.constants[2] * t1223;
        t1257 = speeds[2] * t1256;
        t1263 = t1257 + t711 * t1123 - cos_theta * t1136 + t750 * t1126;
        t1266 = self.constants[57] * t1231;
        t1267 = self.constants[56] * t1223 + t1266;
        t1270 = t1231 * t1267 - t1223 * t1233;
        t1273 = self.constants[55] * t1246 + self.constants[58] * t1263 + t1270
            - self.constants[54] * t1252;
        t1280 = t1223 * t1235 - t1198 * t1267;
        t1283 = self.constants[54] * t1191 + self.constants[57] * t1206
            + self.constants[59] * t1215 + t1280;
        t1288 = self.constants[54] * t1198;
        t1290 = self.constants[54] * t1231;
        t1291 = self.constants[55] * t1223;
        t1292 = t1290 - t1291;
        t1294 = t1198 * t1288 + t1231 * t1292;
        t1296 = t1246 * self.constants[24] + self.constants[55] * t1263 - t1294;
        t1301 = self.constants[55] * t1198;
        t1304 = t1231 * t1301 + t1223 * t1288;
        t1307 = t1191 * self.constants[24] + self.constants[54] * t1215 + t1304
            - self.constants[55] * t1206;
        t1313 = t1223 * t1292 - t1198 * t1301;
        t1315 = t1252 * self.constants[24] + t1313 - self.constants[54] * t1263;
        t1318 = t711 * t1296 + cos_theta * t1307 - t750 * t1315;
        t1323 = cos_delta * t1146 + sin_delta * t1132;
        t1329 = sin_delta * t1123 - cos_delta * t1136 - t1069;
        t1331 = self.constants[48] * t953;
        t1333 = self.constants[48] * t965;
        t1334 = t950 * self.constants[49];
        t1335 = t1333 - t1334;
        t1337 = t953 * t1331 + t965 * t1335;
        t1339 = self.constants[47] * t1323 + self.constants[49] * t1329 - t1337;
        t1344 = t953 * self.constants[49];
        t1347 = t965 * t1344 + t950 * t1331;
        t1350 = t1148 * self.constants[47] + self.constants[48] * t1126 + t1347
            - t1153 * self.constants[49];
        t1352 = sin_delta * t1339 + cos_delta * t1350;
        t1358 = t947 + self.constants[46] * t1126 + t1158 + t705 * t1240 + t750 * t1273
            + t728 * t1283;
        t1362 = t1358 + self.constants[30] * t1352 - self.constants[40] * t978
            - self.constants[42] * t1123 - self.constants[32] * t1318;
        t1367 = self.constants[42] * t932;
        t1369 = t1367 + self.constants[46] * t943;
        t1372 = t934 * t1369 - t938 * t943;
        t1380 = self.constants[51] * t950;
        t1382 = t1380 + self.constants[53] * t965;
        t1385 = t953 * t1382 - t962 * t965;
        t1388 = self.constants[50] * t1153 + self.constants[51] * t1126 + t1385
            - t1148 * self.constants[49];
        t1393 = t1090 - t1186 + self.constants[30] * t1136;
        t1403 = t518 * (t32 * t1108 + t523 * t1119 - t34 * t1086 - t561 * t1115);
        t1405 = self.constants[28] * (t1329 + t1403);
        t1408 = t965 * t967 - t950 * t1382;
        t1412 = t1323 * self.constants[49] + self.constants[52] * t1329 + t1405 + t1408
            - self.constants[48] * t1393;
        t1419 = self.constants[41] * t978 + self.constants[42] * t1126 + t1372
            + t701 * t1240 + t705 * t1283 + cos_delta * t1388;
        t1424 = t1419 - self.constants[45] * t1123 - t711 * t1273
            - self.constants[33] * t1318 - sin_delta * t1412
            - self.constants[31] * t1352;
        t1430 = self.constants[41] * t934;
        t1432 = self.constants[40] * t934;
        t1439 = t1318 + t1352 + self.constants[40] * t1126 + self.constants[41] * t1123
            + t943 * t1430 + t932 * t1432 - t978 * self.constants[44];
        t1446 = t943 * t945 - t932 * t1369;
        t1454 = t701 * t1296 + t705 * t1315 - t711 * t1307;
        t1460 = t705 * t1296 + t750 * t1307 + t728 * t1315;
        t1466 = cos_delta * t1339 - sin_delta * t1350;
        t1472 = t950 * t1335 - t953 * t1344;
        t1474 = self.constants[47] * t1393 + t1472 - self.constants[48] * t1329;
        t1479 = self.constants[40] * t943;
        t1480 = self.constants[41] * t932;
        t1481 = t1479 - t1480;
        t1484 = t932 * t1481 - t934 * t1430;
        t1494 = t934 * t1432 + t943 * t1481;
        t1500 = t14
            * (t1460 + t1474 + t1484 - t1186 * self.constants[44]
                + self.constants[40] * t1136)
            + t26
                * (t1454 + t1466 + t1144 * self.constants[44]
                    - self.constants[41] * t1136 - t1494);
        t1502 = self.constants[27] * t1136 + self.constants[7] * t1500;
        t1507 = self.constants[41] * t1144 + self.constants[40] * t1186
            - self.constants[43] * t1136 + t1446 + t711 * t1240 + cos_theta * t1273;
        t1512 = t1507 + self.constants[33] * t1454 + self.constants[32] * t1460
            + sin_delta * t1388 + cos_delta * t1412 + self.constants[31] * t1466;
        t1515 = t1512 - t1502 - t750 * t1283 - self.constants[30] * t1474;
        t1519 = t26 * t1362 - t14 * t1424;
        t1526 = forces[0] + t872 * t1519 - t14 * t1362 - t26 * t1424
            - self.constants[7] * t1439 - t861 * t1515;
        t1527 = t1526 - t682 * t1405;
        t1529 = self.constants[53] + t765;
        t1534 = t89 - sin_phi * t447;
        t1536 = cos_phi * t447;
        t1538 = t26 * t832;
        t1539 = self.constants[7] * t1538;
        t1540 = t834 + t1539;
        t1544 = t1540 + t886 * t1534 - t893 * t1536;
        t1548 = t26 * t1529 - t14 * t791;
        t1552 = t1548 + t893 * t1534 - t899 * t1536;
        t1557 = cos_delta * t1534 - t115 * t1536;
        t1558 = t690 + t1557;
        t1564 = t14 * t1529 + t26 * t791 + self.constants[7] * t764 + t859 * t1534
            + t861 * t1544 + t905 * t1534;
        t1568 = t923 * (t1564 + t913 * t1558 - t871 * t1536 - t872 * t1552);
        t1573 = self.constants[27] * t1534;
        t1575 = self.constants[28] * t1558;
        t1577 = t922 * t1568;
        t1583 = self.constants[53] + t1534 * t1544 + t1534 * t1540 + t1534 * t1573
            + t1558 * t1575 - t1536 * t1552;
        t1585 = t1583 - t1536 * t1548 - t1568 * t1577;
        t1586 = self.constants[0].like(1.0) / t1585;
        t1596 = forces[1] + t1519 * t1536 - t1158 - t1515 * t1534 - t690 * t1405
            - t1527 * t1568;
        t1599 = t711 * self.constants[75];
        t1601 = t750 * self.constants[75];
        t1606 = self.constants[7] * (t14 * t1601 - t26 * t1599);
        t1611 = t711 * self.constants[76] - t750 * self.constants[77];
        t1614 = self.constants[32] * t1601 + t1611 - self.constants[33] * t1599 - t1606;
        t1616 = cos_theta * self.constants[75];
        t1620 = t705 * self.constants[76] + t728 * self.constants[77];
        t1621 = t1620 - self.constants[32] * t1616;
        t1626 = t701 * self.constants[76] + t705 * self.constants[77];
        t1627 = t1626 - self.constants[33] * t1616;
        t1629 = t26 * t1621 - t14 * t1627;
        t1640 = t923
            * (t14 * t1621 + t26 * t1627 + self.constants[7] * t1616 + t861 * t1614
                - t872 * t1629);
        t1644 = t1586 * (t1534 * t1614 - t1536 * t1629 - t1577 * t1640);
        t1646 = t922 * t1640;
        let (
            t1648, t1651, t1652, t1666, t1667, t1669, t1671, t1677, t1681, t1686, t1688, t1692,
            t1693, t1699, t1700, t1713, t1716, t1722, t1733, t1754, t1759, t1760, t1762, t1766,
            t1772, t1776, t1784, t1786, t1789, t1794, t1800, t1807, t1809, t1811, t1813, t1815,
            t1817, t1821, t1822, t1824, t1828, t1834, t1838, t1840, t1843, t1852, t1861, t1865,
            t1871, t1877, t1884, t1888, t1895, t1900, t1907, t1912, t1915, t1919, t1923, t1924,
            t1927, t1934, t1936, t1943, t1948, t1949, t1963, t1968, t1978, t1982, t1984, t1990,
            t1994, t1996, t1997, t2010, t2016, t2019, t2022, t2027, t2034, t2041, t2049, t2054,
            t2058, t2059, t2066, t2068, t2072, t2074, t2077, t2079, t2080, t2082, t2083, t2086,
            t2087, t2089, t2092, t2094, t2096, t2098, t2099, t2101, t2103, t2104, t2107, t2109,
            t2115, t2120, t2123, t2126, t2127, t2129, t2133, t2134, t2136, t2137, t2143, t2144,
            t2145, t2149, t2152, t2155, t2159, t2161, t2165, t2169, t2170, t2172, t2174, t2178,
            t2182, t2184, t2186, t2189, t2190, t2194, t2198, t2201, t2205, t2208, t2212, t2215,
            t2220, t2224, t2227, t2231, t2232, t2233, t2234, t2236, t2238, t2239, t2241, t2243,
            t2246, t2248, t2249, t2251, t2254, t2259, t2265, t2271, t2274, t2277, t2282, t2284,
            t2290, t2291, t2294, t2299, t2301, t2307, t2310, t2312, t2313, t2314, t2318, t2322,
            t2326, t2328, t2330, t2335, t2336, t2338, t2340, t2341, t2343, t2345, t2352, t2355,
            t2359, t2367, t2370, t2373, t2376, t2388, t2394, t2400, t2406, t2411, t2414, t2419,
            t2421, t2423, t2424, t2426, t2435, t2439, t2442, t2449, t2452, t2454, t2456, t2464,
            t2470, t2475, t2478, t2483, t2487, t2500, t2505, t2511, t2515, t2523, t2526, t2527,
            t2529, t2537, t2539, t2541, t2543, t2545, t2546, t2548, t2550, t2556, t2559, t2561,
            t2563, t2569, t2572, t2574, t2575, t2578, t2582, t2583, t2585, t2587,
        );
        t1648 = t1585 * t1644;
        t1651 = self.constants[78] - t1640 * t1646 - t1644 * t1648;
        t1652 = self.constants[0].like(1.0) / t1651;
        t1666 = forces[2] - self.constants[3] * t1240 - self.constants[2] * t1283
            - positions[6] * self.constants[5] - speeds[2] * self.constants[6]
            - t1527 * t1640;
        t1667 = t1666 - t1596 * t1644;
        t1669 = sin_phi * t328;
        t1671 = cos_phi * t328;
        t1677 = self.constants[7] * (t819 - self.constants[73]);
        t1681 = t1677 + t886 * t1669 + t893 * t1671;
        t1686 = t891 - t893 * t1669 - t899 * t1671;
        t1688 = self.constants[0].like(1.0) - t1669;
        t1692 = cos_delta * t1669 + t115 * t1671;
        t1693 = t693 - t1692;
        t1699 = t905 * t1688 + t913 * t1693 - t859 * t1669 - t871 * t1671 - t861 * t1681
            - t872 * t1686;
        t1700 = t923 * t1699;
        t1713 = t1539 + t1573 * t1688 + t1575 * t1693 - t1534 * t1681 - t1536 * t1686
            - t1540 * t1669;
        t1716 = t1586 * (t1713 - t1548 * t1671 - t1577 * t1700);
        t1722 = t1652
            * (t1606 + t1614 * t1669 + t1629 * t1671 + t1646 * t1700 + t1648 * t1716);
        t1733 = t1515 * t1669 + t1519 * t1671 + t1667 * t1722 + t1502 - t693 * t1405
            - t1527 * t1700;
        t1754 = t1669 * t1681 + t1669 * t1677 + self.constants[79]
            + self.constants[27] * t1688 * t1688 + self.constants[28] * t1693 * t1693
            - t1671 * t1686;
        t1759 = self.constants[0].like(1.0)
            / (t1754 - t891 * t1671 - t922 * t1700 * t1700 - t1585 * t1716 * t1716
                - t1651 * t1722 * t1722);
        t1760 = (t1733 - t1596 * t1716) * t1759;
        t1762 = t1652 * t1667 + t1722 * t1760;
        t1766 = t1586 * t1596 - t1644 * t1762 - t1716 * t1760;
        t1772 = t923 * t1527 - t1568 * t1766 - t1640 * t1762 - t1700 * t1760;
        t1776 = t971 + t973 - self.constants[7] * (t974 + t1772);
        t1784 = t1119 + t364 * t1772 + t447 * t1766 + t328 * t1760;
        t1786 = t981 - cos_phi * t1784;
        t1789 = t26 * t1772 - t980 - t14 * t1786;
        t1794 = t988 + t26 * t1786 + t14 * t1772;
        t1800 = t986 + self.constants[30] * t1794 - t1776 - self.constants[31] * t1789;
        t1807 = t72 * t1772 + t89 * t1766 - sin_phi * t1784 - t1135;
        t1809 = t1760 + t1807;
        t1811 = self.constants[7] * t1809 - t1008;
        t1813 = t1143 - t26 * t1811;
        t1815 = self.constants[31] * t1807 + t1813 - t1003;
        t1817 = cos_delta * t1800 - sin_delta * t1815;
        t1821 = cos_delta * t1789 + sin_delta * t1807;
        t1822 = t1028 + t1821;
        t1824 = t1766 + t1794;
        t1828 = t1165 + t1813 + self.constants[33] * t1807;
        t1834 = t1173 - t1776 - self.constants[32] * t1794 - self.constants[33] * t1789;
        t1838 = t1184 + t14 * t1811;
        t1840 = self.constants[32] * t1807 - t1182 - t1838;
        t1843 = cos_theta * t1834 + t750 * t1840 - t711 * t1828;
        t1852 = t1200 + t701 * t1789 + t711 * t1807 + t705 * t1794
            + self.constants[3] * t1762;
        t1861 = t705 * t1789 + t728 * t1794 + self.constants[2] * t1762 - t1209
            - t750 * t1807;
        t1865 = t1237 + self.constants[56] * t1852 + self.constants[57] * t1861
            - self.constants[55] * t1843;
        t1871 = t701 * t1828 + t711 * t1834 + t705 * t1840;
        t1877 = t705 * t1828 + t728 * t1840 - t750 * t1834;
        t1884 = t1257 + cos_theta * t1807 + t750 * t1794 - t711 * t1789;
        t1888 = t1270 + self.constants[55] * t1871 + self.constants[58] * t1884
            - self.constants[54] * t1877;
        t1895 = t1280 + self.constants[54] * t1843 + self.constants[57] * t1852
            + self.constants[59] * t1861;
        t1900 = self.constants[24] * t1871 + self.constants[55] * t1884 - t1294;
        t1907 = t1304 + self.constants[24] * t1843 + self.constants[54] * t1861
            - self.constants[55] * t1852;
        t1912 = t1313 + self.constants[24] * t1877 - self.constants[54] * t1884;
        t1915 = t711 * t1900 + cos_theta * t1907 - t750 * t1912;
        t1919 = cos_delta * t1815 + sin_delta * t1800;
        t1923 = cos_delta * t1807 - sin_delta * t1789;
        t1924 = t1923 - t1069;
        t1927 = self.constants[47] * t1919 + self.constants[49] * t1924 - t1337;
        t1934 = t1347 + self.constants[47] * t1817 + self.constants[48] * t1824
            - self.constants[49] * t1822;
        t1936 = sin_delta * t1927 + cos_delta * t1934;
        t1943 = t947 + t969 + self.constants[42] * t1789 + self.constants[46] * t1794
            + self.constants[48] * t1817 + self.constants[51] * t1822
            + self.constants[53] * t1824;
        t1948 = t1943 + t705 * t1865 + t750 * t1888 + t728 * t1895
            + self.constants[30] * t1936 - self.constants[40] * t1776;
        t1949 = t1948 - self.constants[32] * t1915;
        t1963 = t1385 + self.constants[50] * t1822 + self.constants[51] * t1824
            - self.constants[49] * t1817;
        t1968 = t1090 - t1838 - self.constants[30] * t1807;
        t1978 = self.constants[28]
            * (t1403 + t1924 + t682 * t1772 + t690 * t1766 + t693 * t1760);
        t1982 = t1408 + self.constants[49] * t1919 + self.constants[52] * t1924 + t1978
            - self.constants[48] * t1968;
        t1984 = cos_delta * t1963 - sin_delta * t1982;
        t1990 = t1372 + self.constants[41] * t1776 + self.constants[45] * t1789
            + self.constants[42] * t1794 + t701 * t1865 + t705 * t1895;
        t1994 = t1990 + t1984 - t711 * t1888 - self.constants[33] * t1915
            - self.constants[31] * t1936;
        t1996 = t26 * t1949 - t14 * t1994;
        t1997 = sin_phi * t1996;
        t2010 = t701 * t1900 + t705 * t1912 - t711 * t1907;
        t2016 = t705 * t1900 + t750 * t1907 + t728 * t1912;
        t2019 = cos_delta * t1982;
        t2022 = cos_delta * t1927 - sin_delta * t1934;
        t2027 = t1472 + self.constants[47] * t1968 - self.constants[48] * t1924;
        t2034 = t1484 + t2016 + t2027 - self.constants[44] * t1838
            - self.constants[40] * t1807;
        t2041 = t2010 + t2022 + self.constants[44] * t1813 + self.constants[41] * t1807
            - t1494;
        t2049 = t1446 + self.constants[41] * t1813 + self.constants[40] * t1838
            + self.constants[43] * t1807 + self.constants[27] * t1809 + t711 * t1865;
        t2054 = t2049 + cos_theta * t1888 + self.constants[33] * t2010
            + self.constants[32] * t2016 + sin_delta * t1963 + t2019;
        t2058 = t2054 + self.constants[31] * t2022 - t750 * t1895
            - self.constants[30] * t2027
            - self.constants[7] * (t14 * t2034 + t26 * t2041);
        t2059 = cos_phi * t2058;
        t2066 = sin_phi * t2058 + cos_phi * t1996;
        t2068 = t518 * t1978;
        t2072 = t107 * t1949 + t110 * t1994;
        t2074 = self.constants[7] * t861;
        t2077 = t110 * t2034 - t107 * t2041;
        t2079 = t326 * t1110;
        t2080 = t524 * t2079;
        t2082 = t326 * t1058;
        t2083 = t524 * t2082;
        t2086 = t41 * t326;
        t2087 = t1086 * t2086;
        t2089 = t518 * t1108 - t524 * t2087;
        t2092 = t1108 * t2086;
        t2094 = t518 * t1086 + t524 * t2092;
        t2096 = t518 * t1115;
        t2098 = t326 * t1115;
        t2099 = t524 * t2098;
        t2101 = t518 * t1119;
        t2103 = t326 * t1119;
        t2104 = t524 * t2103;
        t2107 = t518 * t1772;
        t2109 = t518 * t1766;
        t2115 = t149 * t2083 + t153 * t2089 + t162 * t2094 + t358 * t2099 + t537 * t2101
            + t543 * t1760;
        t2120 = t2115 + t566 * t2107 + t617 * t2109 - t120 * t2080 - t556 * t2096
            - t339 * t2104;
        t2123 = t910 * self.constants[28] - t682 * self.constants[28];
        t2126 = t1007 + t1007;
        t2127 = t26 * t2126;
        t2129 = self.constants[7] * t1784;
        t2133 = self.constants[7] * t1772;
        t2134 = t26 * t2133;
        t2136 = self.constants[7] * t1766;
        t2137 = t26 * t2136;
        t2143 = t27 * t2129 + t107 * t1811 + t110 * t1142 - t286 * self.constants[60]
            - t933 * t2127 - t199 * t2134;
        t2144 = t2143 - t233 * t2137;
        t2145 = t26 * self.constants[44];
        t2149 = t701 * self.constants[55] - t725;
        t2152 = t14 * t750 - t26 * t711;
        t2155 = t14 * t711 + t26 * t750;
        t2159 = t872 * t2155 - t2152 - cos_theta * t861;
        t2161 = t705 * self.constants[24];
        t2165 = t26 * self.constants[33] + t14 * self.constants[32] - self.constants[7];
        t2169 = t14 * self.constants[33] - t26 * self.constants[32];
        t2170 = t750 * t2169;
        t2172 = t26 * t705;
        t2174 = t2172 + t14 * t728;
        t2178 = t705 * self.constants[33] + t728 * self.constants[32];
        t2182 = t2074 * t2174 - t750 * t2165 - t872 * t2170 - t861 * t2178;
        t2184 = t701 * self.constants[24];
        t2186 = t711 * t2169;
        t2189 = t14 * t705;
        t2190 = t26 * t701 + t2189;
        t2194 = t701 * self.constants[33] + t705 * self.constants[32];
        t2198 = t711 * t2165 + t872 * t2186 + t2074 * t2190 - t861 * t2194;
        t2201 = t26 * t728 - t2189;
        t2205 = t872 * t2201 + t750 * t861 - t2174;
        t2208 = t2172 - t14 * t701;
        t2212 = t872 * t2208 - t2190 - t711 * t861;
        t2215 = cos_theta * t2169;
        t2220 = t750 * self.constants[32] - t711 * self.constants[33];
        t2224 = cos_theta * t2165 + t872 * t2215 + t2074 * t2152 - t861 * t2220;
        t2227 = self.constants[54] * t2205 + self.constants[24] * t2224
            - self.constants[55] * t2212;
        t2231 = t2149 * t2159 + t2161 * t2182 + t2184 * t2198 - t711 * t2227;
        t2232 = self.constants[7] - t78;
        t2233 = cos_delta * self.constants[47];
        t2234 = sin_delta * t2233;
        t2236 = t85 * t2234;
        t2238 = cos_delta * t2233;
        t2239 = t26 * t2238;
        t2241 = self.constants[31] * t2238;
        t2243 = cos_delta * self.constants[49];
        t2246 = t85 * t2233;
        t2248 = sin_delta * self.constants[47];
        t2249 = t26 * t2248;
        t2251 = self.constants[31] * t2248;
        t2254 = t26 * t872 - t14;
        t2259 = t155 + t124 * t872 + sin_delta * t861;
        t2265 = t872 * t2246 + t861 * t2251 + self.constants[48] * t2254
            + self.constants[49] * t2259 - t2232 * t2233 - t2074 * t2249;
        t2271 = t872 * t2236 + t2074 * t2239 + t910 * t2243 - t2232 * t2234
            - t861 * t2241 - sin_delta * t2265;
        t2274 = t2074 * t2145 + t2231 + t2271 - self.constants[41] * t861;
        t2277 = t14 * t2126;
        t2282 = t14 * t2133;
        t2284 = t14 * t2136;
        t2290 = t933 * t2277 + t110 * t1811 + t199 * t2282 + t233 * t2284
            - t82 * self.constants[60] - t18 * t2129;
        t2291 = t2290 - t107 * t1142;
        t2294 = t14 * self.constants[44] + t14 * self.constants[47];
        t2299 = t760 - self.constants[54] * t728;
        t2301 = t728 * self.constants[24];
        t2307 = t2159 * t2299 + t2182 * t2301 + t2161 * t2198 + t750 * t2227;
        t2310 = self.constants[48] * t910 - t2074 * t2294 - t814 * t861 - t2307;
        t2312 = t93 - t970;
        t2313 = t933 * t2312;
        t2314 = self.constants[7] * t930;
        t2318 = t2313 + cos_phi * (self.constants[60] + t929 * t2314);
        t2322 = t14 * self.constants[41] + t26 * self.constants[40];
        t2326 = t711 * self.constants[55] + self.constants[54] * t750;
        t2328 = t750 * self.constants[24];
        t2330 = t711 * self.constants[24];
        t2335 = t2159 * t2326 + t2198 * t2330 + cos_theta * t2227 - t2182 * t2328;
        t2336 = sin_delta * t2248;
        t2338 = t85 * t2336;
        t2340 = cos_delta * t2248;
        t2341 = t26 * t2340;
        t2343 = self.constants[31] * t2340;
        t2345 = sin_delta * self.constants[49];
        t2352 = t872 * t2338 + t2074 * t2341 + t910 * t2345 + cos_delta * t2265
            - t2232 * t2336 - t861 * t2343;
        t2355 = t26 * self.constants[41] - t14 * self.constants[40];
        t2359 = self.constants[7] * self.constants[44] - t872 * t2322 - t2335 - t2352
            - t2355;
        t2367 = t82 * t1784 + t924 * t930 + t110 * t1772 - t107 * t1786;
        t2370 = t26 * self.constants[42];
        t2373 = t14 * self.constants[42];
        t2376 = t85 * t764 + t26 * self.constants[46] - t2373;
        t2388 = self.constants[59] * t2205 + self.constants[57] * t2212
            + self.constants[54] * t2224;
        t2394 = self.constants[58] * t2159 + self.constants[55] * t2198
            - self.constants[54] * t2182;
        t2400 = self.constants[57] * t2205 + self.constants[56] * t2212
            - self.constants[55] * t2224;
        t2406 = t872 * t2376 + t833 * t861 + self.constants[53] * t2254
            + self.constants[30] * t2352 + t728 * t2388 + t750 * t2394;
        t2411 = t2406 + t705 * t2400 - self.constants[7] * self.constants[40]
            - t764 * t2232 - t2370 - t14 * self.constants[46];
        t2414 = t2411 - t1538 * t2074 - self.constants[51] * t2259
            - self.constants[32] * t2335;
        t2419 = t1786 + t199 * t1772 + t233 * t1766;
        t2421 = t2355 - t14 * self.constants[67];
        t2423 = self.constants[43] + self.constants[27];
        t2424 = self.constants[71] + t2423;
        t2426 = self.constants[30] * self.constants[48];
        t2435 = t85 * t2345;
        t2439 = t26 * t2243 - t14 * self.constants[48];
        t2442 = t2426 + self.constants[31] * t2243;
        t2449 = t2123 + t872 * t2435 + t2074 * t2439 + self.constants[52] * t910
            - t2232 * t2345 - t861 * t2442;
        t2452 = t85 * t2243;
        t2454 = t26 * t2345;
        t2456 = self.constants[31] * t2345;
        t2464 = t2232 * t2243 + t2074 * t2454 + self.constants[51] * t2254 - t872 * t2452
            - t861 * t2456 - self.constants[50] * t2259;
        t2470 = t2074 * t2421 + t910 * t2426 + self.constants[32] * t2307
            + self.constants[33] * t2231 + self.constants[31] * t2271
            + cos_theta * t2394;
        t2475 = t2470 + t711 * t2400 + cos_delta * t2449 + sin_delta * t2464
            - t861 * t2424 - t750 * t2388;
        t2478 = t930 * t942;
        t2483 = t286 * t1784 + t2478 + t107 * t1772 + t110 * t1786;
        t2487 = t2370 - t14 * self.constants[45];
        t2500 = self.constants[7] * self.constants[41] + t872 * t2487 + t705 * t2388
            + t701 * t2400 + cos_delta * t2464 - t2373;
        t2505 = t2500 - t26 * self.constants[45] - self.constants[33] * t2335
            - self.constants[31] * t2352 - t711 * t2394 - sin_delta * t2449;
        t2511 = t341 * t1760;
        t2515 = t2103 + t329 * t1760;
        t2523 = t149 * t2082 + t162 * t2092 + t191 * t2511 + t358 * t2098 + t369 * t1772
            + t461 * t1766;
        t2526 = t2523 - t120 * t2079 - t153 * t2087 - t339 * t2515;
        t2527 = t6 * t26;
        t2529 = t6 * t14;
        t2537 = t2274 * t2527 + t18 * t2505 - t2310 * t2529 - t27 * t2414
            - sin_phi * t2475;
        t2539 = t71 * t1115;
        t2541 = t71 * t1058;
        t2543 = t71 * t1110;
        t2545 = t30 * t71;
        t2546 = t1086 * t2545;
        t2548 = t1108 * t2545;
        t2550 = cos_phi * t2539;
        t2556 = t100 * t2539 + t120 * t2541 + t149 * t2543 + t153 * t2546 - t162 * t2548
            - t195 * t2550;
        t2559 = t363 * t524 - t518 * t561;
        t2561 = self.constants[7] * t26;
        t2563 = self.constants[7] * t14;
        t2569 = t2475 + t2123 * t2559 + t2310 * t2563 + t363 * t2537 - t2274 * t2561;
        t2572 = self.constants[30] + t2563;
        t2574 = self.constants[37] + t1032;
        t2575 = speeds[0] * cos_delta;
        t2578 = t14 * t1007 + speeds[0] * t2572 + t2574 * t2575;
        t2582 = self.constants[8] * t1071;
        t2583 = self.constants[8] * t950;
        t2585 = t965 * t2583 - t2582;
        t2587 = t960 * t1045;
        let (
            t2589, t2594, t2596, t2598, t2601, t2604, t2606, t2607, t2610, t2612, t2614, t2617,
            t2620, t2621, t2627, t2630, t2632, t2636, t2640, t2644, t2647, t2648, t2649, t2652,
            t2655, t2659, t2665, t2667, t2669, t2671, t2674, t2680, t2681, t2683, t2685, t2688,
            t2691, t2693, t2695, t2697, t2699, t2703, t2704, t2708, t2709, t2710, t2713, t2716,
            t2717, t2726, t2729, t2730, t2734, t2737, t2740, t2742, t2743, t2747, t2750, t2754,
            t2760, t2761, t2764, t2766, t2768, t2770, t2772, t2773, t2774, t2776, t2778, t2779,
            t2780, t2782, t2787, t2791, t2793, t2797, t2800, t2802, t2805, t2812, t2813, t2816,
            t2820, t2823, t2826, t2833, t2834, t2837, t2840, t2842, t2844, t2846, t2854, t2855,
            t2857, t2858, t2859, t2861, t2863, t2865, t2867, t2871, t2873, t2877, t2880, t2882,
            t2885, t2887, t2890, t2891, t2893, t2896, t2897, t2899, t2900, t2906, t2910, t2914,
            t2916, t2918, t2922, t2924, t2928, t2931, t2935, t2937, t2942, t2945, t2948, t2951,
            t2953, t2959, t2964, t2965, t2971, t2976, t2980, t2985, t2987, t2991, t2993, t2994,
            t2996, t2998, t3000, t3005, t3006, t3009, t3015, t3017, t3019, t3030, t3033, t3037,
            t3048, t3053, t3058, t3063, t3065, t3069, t3072, t3075, t3077, t3078, t3081, t3086,
            t3091, t3093, t3096, t3102, t3106, t3110, t3112, t3116, t3119, t3123, t3124, t3128,
            t3131, t3136, t3139, t3148, t3150, t3154, t3159, t3164, t3169, t3174, t3183, t3188,
            t3190, t3192, t3197, t3202, t3203, t3205, t3207, t3210, t3211, t3213, t3215, t3217,
            t3219, t3224, t3227, t3231, t3233, t3243, t3248, t3251, t3257, t3262, t3267, t3272,
            t3277, t3281, t3289, t3293, t3299, t3305, t3311, t3315, t3319, t3325, t3328, t3332,
            t3341, t3345, t3350, t3355, t3358, t3369, t3372, t3381, t3390, t3392, t3405, t3411,
            t3417, t3423, t3427, t3445, t3455, t3461, t3466, t3480, t3482, t3492,
        );
        t2589 = t2587 + t950 * t2583;
        t2594 = t107 * t1014 + t110 * t1009 + t153 * t2585 + t162 * t2589 - t933 * t2578;
        t2596 = t34 * t2086;
        t2598 = t32 * t518 - t524 * t2596;
        t2601 = t34 * t2545;
        t2604 = t2123 * t2598 + t2569 * t2601 - t2537 * t2596;
        t2606 = self.constants[38] + t1036;
        t2607 = sin_delta * t2606;
        t2610 = t2561 - self.constants[31];
        t2612 = t26 * t1007 + speeds[0] * t2610;
        t2614 = speeds[0] * t2607 - sin_delta * t2612;
        t2617 = t924 * t2574;
        t2620 = self.constants[30] * t924 - t2314;
        t2621 = t929 * t2620;
        t2627 = self.constants[30] * t981;
        t2630 = t981 * t2574 + cos_delta * t2627 - sin_delta * t1009;
        t2632 = sin_delta * t1014;
        t2636 = self.constants[8] * t1034 + t950 * t1045;
        t2640 = t965 * t1045 - self.constants[8] * t1038;
        t2644 = cos_phi * (t929 * t2617 + cos_delta * t2621) + t153 * t2636
            - t933 * t2614 - cos_delta * t2313;
        t2647 = t2644 - t107 * t2630 - t110 * t2632 - t162 * t2640;
        t2648 = t30 * t326;
        t2649 = t524 * t2648;
        t2652 = t41 * t71;
        t2655 = t2123 * t2649 + t2537 * t2648 + t2569 * t2652;
        t2659 = cos_delta * t2612 - t2575 * t2606;
        t2665 = cos_delta * t1009 + sin_delta * t2627;
        t2667 = cos_delta * t1014;
        t2669 = self.constants[8] * t965;
        t2671 = t2587 + t965 * t2669;
        t2674 = t2582 + t950 * t2669;
        t2680 = t117 * t2621 + t110 * t2667 - t933 * t2659 - sin_delta * t2313
            - t107 * t2665 - t153 * t2671;
        t2681 = t2680 - t162 * t2674;
        t2683 = t32 * t2086;
        t2685 = t34 * t518 + t524 * t2683;
        t2688 = t32 * t2545;
        t2691 = t2569 * t2688 - t2123 * t2685 - t2537 * t2683;
        t2693 = t31 * t1043;
        t2695 = t1040 * t2693;
        t2697 = t950 * t1040;
        t2699 = t965 * t1040;
        t2703 = t120 * t2693 + t153 * t2697 - t149 * t2695 - t162 * t2699;
        t2704 = t960 * t1036;
        t2708 = t965 * t1036 + t950 * t1032;
        t2709 = t2655 * t2708;
        t2710 = t960 * t1032;
        t2713 = t2709 - t2604 * t2704 - t2691 * t2710;
        t2716 = self.constants[7] * t1012 - t970;
        t2717 = t930 * t2716;
        t2726 = t14 * t2274 + t26 * t2310 + t124 * t2691 - t26 * t2604 - t115 * t2655;
        t2729 = t2478 + t110 * t981;
        t2730 = sin_delta * t2574;
        t2734 = cos_delta * t2606 + cos_delta * self.constants[31];
        t2737 = t2607 + sin_delta * self.constants[31];
        t2740 = t2655 * t2734 + t2691 * t2737 - t2604 * t2730;
        t2742 = self.constants[41] * t943;
        t2743 = self.constants[40] * t932;
        t2747 = t1369 - t943 * t2423;
        t2750 = t932 * t2423 - t945;
        t2754 = t26 * t2750 - t14 * t2747;
        t2760 = t982 + t982;
        t2761 = self.constants[47] * t2760;
        t2764 = t26 * (t1432 + t1432) + t14 * (t1430 + t1430) + t14 * t2761;
        t2766 = self.constants[30] * t2761;
        t2768 = self.constants[48] * t2760;
        t2770 = t1170 + t1170;
        t2772 = self.constants[33] * t943;
        t2773 = self.constants[32] * t932;
        t2774 = t2772 - t2773;
        t2776 = t1159 + t1159;
        t2778 = self.constants[31] * t943;
        t2779 = self.constants[30] * t932;
        t2780 = t2778 + t2779;
        t2782 = t984 + t984;
        t2787 = sin_delta * t2782 + cos_delta * t2780;
        t2791 = sin_delta * t2780 - cos_delta * t2782;
        t2793 = self.constants[57] * t1198;
        t2797 = t1266 + t1267 - self.constants[59] * t1223;
        t2800 = self.constants[59] * t1198 - t1235;
        t2802 = self.constants[54] * t1223;
        t2805 = t1290 + t1292;
        t2812 = t2159 * t2797 + t2212 * t2800 + t2182 * t2802 + t1301 * t2224
            + t1220 * t2394 - t2205 * t2793;
        t2813 = t2812 - t2198 * t2805;
        t2816 = t1235 - self.constants[56] * t1198;
        t2820 = self.constants[56] * t1231 - t1224 - t1233;
        t2823 = t1292 - t1291;
        t2826 = self.constants[55] * t1231;
        t2833 = t2205 * t2816 + t2159 * t2820 + t2212 * t2793 + t2182 * t2823
            + t1288 * t2224 + t2198 * t2826;
        t2834 = t2833 - t1228 * t2394;
        t2837 = self.constants[58] * t1223 - t1267;
        t2840 = t1233 - self.constants[58] * t1231;
        t2842 = t1301 + t1301;
        t2844 = t2802 + t2826;
        t2846 = t1288 + t1288;
        t2854 = t2205 * t2837 + t2212 * t2840 + t2224 * t2844 + t1228 * t2400
            - t2182 * t2842 - t2198 * t2846;
        t2855 = t2854 - t1220 * t2388;
        t2857 = t965 * self.constants[49];
        t2858 = self.constants[48] * t950;
        t2859 = t2857 + t2858;
        t2861 = t1331 + t1331;
        t2863 = cos_delta * t2859 - sin_delta * t2861;
        t2865 = t85 * t2863;
        t2867 = t1344 + t1344;
        t2871 = sin_delta * t2859 + cos_delta * t2861;
        t2873 = t14 * t2867 + t26 * t2871;
        t2877 = self.constants[30] * t2867 - self.constants[31] * t2871;
        t2880 = self.constants[28] * t950;
        t2882 = self.constants[52] * t950 + t2880 - t967;
        t2885 = self.constants[28] * t965;
        t2887 = t1382 - self.constants[52] * t965 - t2885;
        t2890 = t1021 + t1046;
        t2891 = t1021 + t2890;
        t2893 = self.constants[37] * t950;
        t2896 = t965 * self.constants[38] - speeds[1] * t2606;
        t2897 = t2893 + t2896;
        t2899 = t1023 + t1048;
        t2900 = t1023 + t2899;
        t2906 = t872 * t2865 + t2254 * t2882 + speeds[1] * t2464 + t2655 * t2897
            - t2232 * t2863 - t2074 * t2873;
        t2910 = t2906 - t861 * t2877 - t2259 * t2887 - t2604 * t2891 - t2691 * t2900;
        t2914 = cos_delta * t1331 + sin_delta * t2857;
        t2916 = t85 * t2914;
        t2918 = t1335 - t1334;
        t2922 = cos_delta * t2857 - sin_delta * t1331;
        t2924 = t14 * t2918 + t26 * t2922;
        t2928 = self.constants[31] * t2922 - self.constants[30] * t2918;
        t2931 = t962 - self.constants[50] * t953;
        t2935 = self.constants[50] * t965 - t1380 - t1382;
        t2937 = self.constants[51] * t953;
        t2942 = t1065 + t1078;
        t2945 = speeds[1] * t2574 + t2942 - t1064 - t34 * t2583;
        t2948 = t2899 + t959 * t1032;
        t2951 = t2896 + t34 * t2669;
        t2953 = t32 * t1040;
        t2959 = t872 * t2916 + t2074 * t2924 + t2254 * t2931 + t910 * t2935
            + t2604 * t2945 + t2655 * t2948;
        t2964 = t2959 + t2691 * t2951 + t2713 * t2953 - t2232 * t2914 - t861 * t2928
            - t2259 * t2937;
        t2965 = t2964 - speeds[1] * t2449;
        t2971 = t872 * t2754 + t910 * t2768 + t2335 * t2774 + t2231 * t2776
            + t2352 * t2780 + t2655 * t2787;
        t2976 = t2971 + t2691 * t2791 + t711 * t2834 + cos_theta * t2855
            + cos_delta * t2910 + sin_delta * t2965;
        t2980 = t2976 - self.constants[7] * (t2742 + t2743) - t26 * t2747 - t14 * t2750
            - t2074 * t2764;
        t2985 = t2980 - t861 * t2766 - t2307 * t2770 - t2271 * t2782 - t2604 * t2760
            - t750 * t2813;
        t2987 = t14 * t933;
        t2991 = t110 * t930 - t2987 - speeds[0] * t107;
        t2993 = self.constants[42] * t934;
        t2994 = t26 * t2993;
        t2996 = t938 - self.constants[45] * t934;
        t2998 = t14 * t2993;
        t3000 = t26 * t2996 - t2998;
        t3005 = t1001 - t1000;
        t3006 = self.constants[47] * t3005;
        t3009 = t26 * t2742 + t14 * (t1481 - t1480) + t14 * t3006;
        t3015 = self.constants[45] * t943 - t1367 - t1369 - self.constants[30] * t3006;
        t3017 = self.constants[48] * t3005;
        t3019 = t1162 + t1163;
        t3030 = t984 + self.constants[30] * t91;
        t3033 = t91 * t2574 + cos_delta * t3030 - sin_delta * t2778;
        t3037 = cos_delta * t2778 + sin_delta * t3030;
        t3048 = t872 * t3000 + t2074 * t3009 + t2231 * t2772 + t984 * t2352
            + t2271 * t2778 + t91 * t2414;
        t3053 = t3048 + t2604 * t3005 + t2655 * t3033 + t2691 * t3037 + t705 * t2813
            + t701 * t2834;
        t3058 = t3053 + cos_delta * t2965 - self.constants[7] * t1432 - t2994
            - t14 * t2996 - t861 * t3015;
        t3063 = t3058 - t910 * t3017 - t2307 * t3019 - t1159 * t2335 - t711 * t2855
            - sin_delta * t2910;
        t3065 = t26 * t933;
        t3069 = t3065 + t107 * t930 + speeds[0] * t110;
        t3072 = self.constants[46] * t934 - t938;
        t3075 = t1333 + t1335;
        t3077 = cos_delta * t1344 - sin_delta * t3075;
        t3078 = t85 * t3077;
        t3081 = t3078 - t2994 - t14 * t3072;
        t3086 = self.constants[47] * t2779;
        t3091 = sin_delta * t1344 + cos_delta * t3075;
        t3093 = t14 * t2858 - t26 * t3091;
        t3096 = t14 * t2743 + t14 * t3086 + t3093 - t26 * (t1479 + t1481);
        t3102 = self.constants[30] * t2858 + self.constants[31] * t3091;
        t3106 = t944 + t945 - self.constants[46] * t932 - self.constants[30] * t3086
            - t3102;
        t3110 = t966 + t967 - self.constants[53] * t950;
        t3112 = t3110 - self.constants[48] * t2779;
        t3116 = t1161 + t1163;
        t3119 = t999 + t1001;
        t3123 = t2893 + t32 * t2583;
        t3124 = t2779 + t3123;
        t3128 = t2890 + t959 * t1036;
        t3131 = cos_delta * t982 + t3128 + sin_delta * t3119;
        t3136 = t1063 + t2942 + t32 * t2669;
        t3139 = sin_delta * t982 - t3136 - cos_delta * t3119;
        t3148 = self.constants[53] * t953 - t962;
        t3150 = t34 * t1040;
        t3154 = t2232 * t3077 + t2254 * t2937 + t2259 * t3148 - t2713 * t3150;
        t3159 = t2998 + t872 * t3081 + t2074 * t3096 + t910 * t3112 + t1170 * t2335
            + t2231 * t3116;
        t3164 = t3159 + t982 * t2352 + t2604 * t3124 + t2655 * t3131 + t2691 * t3139
            + t91 * t2740;
        t3169 = t3164 + t728 * t2813 + t705 * t2834 + t750 * t2855
            - self.constants[7] * t1430 - t26 * t3072;
        t3174 = t3169 - t861 * t3106 - t2307 * t2773 - t2271 * t3119 - t91 * t2505
            - t3154;
        t3183 = t2709 + t2254 * t2880 + t2259 * t2885 - t1046 * t2604 - t1048 * t2691;
        t3188 = t2314 + t2779;
        t3190 = t932 * t2574 + cos_delta * t3188;
        t3192 = sin_delta * t3188;
        t3197 = t2314 * t2359 - t970 * t2726;
        t3202 = t2985 + t932 * t2414 + t2655 * t3190 + t2691 * t3192 + t943 * t2740
            - t943 * t2505;
        t3203 = t3202 - t3197;
        t3205 = cos_phi * t2127;
        t3207 = cos_phi * t2277;
        t3210 = cos_phi * t2312;
        t3211 = sin_phi * t2314 - t3210;
        t3213 = sin_phi * t924;
        t3215 = speeds[0] * cos_phi;
        t3217 = sin_phi * t942;
        t3219 = cos_phi * t2578;
        t3224 = t3210 + sin_phi * t2620;
        t3227 = sin_phi * t2617 + cos_phi * t2614 + cos_delta * t3224;
        t3231 = cos_phi * t2659 + sin_delta * t3224;
        t3233 = sin_phi * t2716;
        t3243 = t2274 * t3205 + t2359 * t3211 + t2414 * t3213 + t2604 * t3219
            + t2655 * t3227 + t2691 * t3231;
        t3248 = t3243 + t2726 * t3233 + t2740 * t3217 + t18 * t3063 - t2310 * t3207
            - t2475 * t3215;
        t3251 = t3248 - t2505 * t3217 - sin_phi * t2985 - t27 * t3174;
        t3257 = t364 * t2059 + t107 * t1994 + t369 * t2066 + t2074 * t2077
            + t2120 * t2123 + t2144 * t2274;
        t3262 = t3257 + t2291 * t2310 + t2318 * t2359 + t2367 * t2414 + t2419 * t2475
            + t2526 * t2537;
        t3267 = t3262 + t2556 * t2569 + t2594 * t2604 + t2647 * t2655 + t2681 * t2691
            + t2703 * t2713;
        t3272 = t3267 + t2717 * t2726 + t2729 * t2740 + t2991 * t3063 + t3069 * t3174
            + t620 * t3183;
        t3277 = t3272 + t235 * t3203 - t465 * t3251 - t364 * t1997 - t110 * t1949
            - t199 * t2058;
        t3281 = t3277 - t566 * t2068 - t872 * t2072 - t2483 * t2505 - t930 * t2985;
        t3289 = self.constants[7] * t1534;
        t3293 = t690 * self.constants[28] + self.constants[28] * t1557;
        t3299 = t1536 * t2155 - cos_theta * t1534;
        t3305 = t2174 * t3289 - t1536 * t2170 - t1534 * t2178;
        t3311 = t1536 * t2186 + t2190 * t3289 - t1534 * t2194;
        t3315 = t1536 * t2201 + t750 * t1534;
        t3319 = t1536 * t2208 - t711 * t1534;
        t3325 = t1536 * t2215 + t2152 * t3289 - t1534 * t2220;
        t3328 = self.constants[54] * t3315 + self.constants[24] * t3325
            - self.constants[55] * t3319;
        t3332 = t2149 * t3299 + t2161 * t3305 + t2184 * t3311 - t711 * t3328;
        t3341 = t26 * t1536 - self.constants[0].like(1.0);
        t3345 = t124 * t1536 + sin_delta * t1534;
        t3350 = t1536 * t2246 + t1534 * t2251 + self.constants[48] * t3341
            + self.constants[49] * t3345 - t2249 * t3289;
        t3355 = t1536 * t2236 + t2239 * t3289 - t1534 * t2241 - t1557 * t2243
            - sin_delta * t3350;
        t3358 = t2145 * t3289 + t3332 + t3355 - self.constants[41] * t1534;
        t3369 = t2299 * t3299 + t2301 * t3305 + t2161 * t3311 + t750 * t3328;
        t3372 = t2294 * t3289 + t814 * t1534 + self.constants[48] * t1557 + t3369;
        t3381 = t2326 * t3299 + t2330 * t3311 + cos_theta * t3328 - t2328 * t3305;
        t3390 = t1536 * t2338 + t2341 * t3289 + cos_delta * t3350 - t1534 * t2343
            - t1557 * t2345;
        t3392 = t1536 * t2322 + t3381 + t3390;
        t3405 = self.constants[59] * t3315 + self.constants[57] * t3319
            + self.constants[54] * t3325;
        t3411 = self.constants[58] * t3299 + self.constants[55] * t3311
            - self.constants[54] * t3305;
        t3417 = self.constants[57] * t3315 + self.constants[56] * t3319
            - self.constants[55] * t3325;
        t3423 = t1536 * t2376 + t833 * t1534 + self.constants[53] * t3341
            + self.constants[30] * t3390 + t728 * t3405 + t750 * t3411;
        t3427 = t3423 + t705 * t3417 - t1538 * t3289 - self.constants[51] * t3345
            - self.constants[32] * t3381;
        t3445 = t1536 * t2435 + t2439 * t3289 - t3293 - t1534 * t2442
            - self.constants[52] * t1557;
        t3455 = t2454 * t3289 + self.constants[51] * t3341 - t1536 * t2452
            - t1534 * t2456 - self.constants[50] * t3345;
        t3461 = t2421 * t3289 + self.constants[32] * t3369 + self.constants[33] * t3332
            + self.constants[31] * t3355 + cos_theta * t3411 + t711 * t3417;
        t3466 = t3461 + cos_delta * t3445 + sin_delta * t3455 - t1534 * t2424
            - t1557 * t2426 - t750 * t3405;
        t3480 = t1536 * t2487 + t705 * t3405 + t701 * t3417 + cos_delta * t3455
            - self.constants[33] * t3381 - self.constants[31] * t3390;
        t3482 = t3480 - t711 * t3411 - sin_delta * t3445;
        t3492 = t2527 * t3358 + t2529 * t3372 + t18 * t3482 - t27 * t3427
            - sin_phi * t3466;
        let (
            t3501, t3507, t3513, t3519, t3522, t3525, t3535, t3541, t3566, t3567, t3580, t3581,
            t3594, t3595, t3610, t3613, t3630, t3635, t3641, t3646, t3651, t3652, t3676, t3681,
            t3686, t3688, t3711, t3716, t3721, t3726, t3728, t3737, t3746, t3751, t3752, t3772,
            t3777, t3780, t3787, t3792, t3797, t3802, t3807, t3810, t3814, t3815, t3817, t3819,
            t3822, t3827, t3830, t3840, t3847, t3851, t3855, t3859, t3862, t3865, t3875, t3881,
            t3891, t3895, t3903, t3909, t3917, t3923, t3928, t3946, t3951, t3952, t3961, t3970,
            t3975, t3976, t3981, t3990, t3995, t3996, t4016, t4021, t4024, t4032, t4037, t4042,
            t4047, t4048, t4052, t4054, t4059, t4063, t4069, t4075, t4081, t4085, t4089, t4095,
            t4098, t4102, t4110, t4114, t4119, t4124, t4127, t4138, t4141, t4150, t4159, t4161,
            t4174, t4180, t4186, t4192, t4196, t4214, t4224, t4230, t4235, t4236, t4250, t4252,
            t4262, t4271, t4277, t4283, t4289, t4292, t4295, t4305, t4311, t4336, t4337, t4350,
            t4351, t4364, t4365, t4380, t4383, t4400, t4405, t4411, t4416, t4421, t4422, t4446,
            t4451, t4456, t4458, t4481, t4486, t4491, t4496, t4498, t4507, t4516, t4521, t4522,
            t4542, t4547, t4550, t4559, t4564, t4569, t4574, t4579, t4584, t4585, t4587, t4591,
            t4597, t4600, t4604, t4608, t4623, t4631, t4636, t4639, t4643, t4660, t4665, t4674,
            t4682, t4688, t4692, t4696, t4711, t4714, t4724, t4736, t4739, t4742, t4752, t4764,
            t4772, t4774, t4780, t4784, t4793, t4798, t4803, t4808, t4813, t4818, t4822, t4859,
            t4864, t4869, t4874, t4879, t4884, t4911, t4916, t4921, t4926, t4965, t4970, t4975,
            t4980, t4985, t4990, t4993, t4995, t4999, t5005, t5006, t5008, t5013, t5015, t5017,
            t5022, t5028, t5034, t5036, t5038, t5042, t5046, t5051, t5065, t5067, t5069, t5073,
            t5077, t5082, t5085, t5087, t5091, t5097, t5104, t5110, t5117, t5124,
        );
        t3501 = t3466 + t363 * t3492 - t2559 * t3293 - t2561 * t3358 - t2563 * t3372;
        t3507 = t2601 * t3501 - t2598 * t3293 - t2596 * t3492;
        t3513 = t2648 * t3492 + t2652 * t3501 - t2649 * t3293;
        t3519 = t2685 * t3293 + t2688 * t3501 - t2683 * t3492;
        t3522 = t2708 * t3513;
        t3525 = t3522 - t2704 * t3507 - t2710 * t3519;
        t3535 = t14 * t3358 + t124 * t3519 - t26 * t3372 - t26 * t3507 - t115 * t3513;
        t3541 = t2734 * t3513 + t2737 * t3519 - t2730 * t3507;
        t3566 = t2797 * t3299 + t2800 * t3319 + t2802 * t3305 + t1301 * t3325
            + t1220 * t3411 - t2793 * t3315;
        t3567 = t3566 - t2805 * t3311;
        t3580 = t2816 * t3315 + t2820 * t3299 + t2793 * t3319 + t2823 * t3305
            + t1288 * t3325 + t2826 * t3311;
        t3581 = t3580 - t1228 * t3411;
        t3594 = t2837 * t3315 + t2840 * t3319 + t2844 * t3325 + t1228 * t3417
            - t2842 * t3305 - t2846 * t3311;
        t3595 = t3594 - t1220 * t3405;
        t3610 = t1536 * t2865 + t2882 * t3341 + speeds[1] * t3455 + t2897 * t3513
            - t2873 * t3289 - t1534 * t2877;
        t3613 = t3610 - t2887 * t3345 - t2891 * t3507 - t2900 * t3519;
        t3630 = t1536 * t2916 + t2924 * t3289 + t2931 * t3341 + t2945 * t3507
            + t2948 * t3513 + t2951 * t3519;
        t3635 = t3630 + t2953 * t3525 - t1534 * t2928 - t1557 * t2935 - t2937 * t3345
            - speeds[1] * t3445;
        t3641 = t1536 * t2754 + t2774 * t3381 + t2776 * t3332 + t2780 * t3390
            + t2787 * t3513 + t2791 * t3519;
        t3646 = t3641 + t711 * t3581 + cos_theta * t3595 + cos_delta * t3613
            + sin_delta * t3635 - t2764 * t3289;
        t3651 = t3646 - t1534 * t2766 - t1557 * t2768 - t2770 * t3369 - t2782 * t3355
            - t2760 * t3507;
        t3652 = t3651 - t750 * t3567;
        t3676 = t1536 * t3000 + t3009 * t3289 + t1557 * t3017 + t2772 * t3332
            + t984 * t3390 + t2778 * t3355;
        t3681 = t3676 + t91 * t3427 + t3005 * t3507 + t3033 * t3513 + t3037 * t3519
            + t705 * t3567;
        t3686 = t3681 + t701 * t3581 + cos_delta * t3635 - t1534 * t3015 - t3019 * t3369
            - t1159 * t3381;
        t3688 = t3686 - t711 * t3595 - sin_delta * t3613;
        t3711 = t3150 * t3525 - t2937 * t3341 - t3148 * t3345;
        t3716 = t1536 * t3081 + t3096 * t3289 + t1170 * t3381 + t3116 * t3332
            + t982 * t3390 + t3124 * t3507;
        t3721 = t3716 + t3131 * t3513 + t3139 * t3519 + t91 * t3541 + t728 * t3567
            + t705 * t3581;
        t3726 = t3721 + t750 * t3595 + t3711 - t1534 * t3106 - t1557 * t3112
            - t2773 * t3369;
        t3728 = t3726 - t3119 * t3355 - t91 * t3482;
        t3737 = t3522 + t2880 * t3341 + t2885 * t3345 - t1046 * t3507 - t1048 * t3519;
        t3746 = t2314 * t3392 + t970 * t3535;
        t3751 = t3652 + t932 * t3427 + t3190 * t3513 + t3192 * t3519 + t943 * t3541
            + t3746;
        t3752 = t3751 - t943 * t3482;
        t3772 = t3205 * t3358 + t3207 * t3372 + t3213 * t3427 + t3219 * t3507
            + t3227 * t3513 + t3231 * t3519;
        t3777 = t3772 + t3233 * t3535 + t3217 * t3541 + t18 * t3688 - t3211 * t3392
            - t3215 * t3466;
        t3780 = t3777 - t3217 * t3482 - sin_phi * t3652 - t27 * t3728;
        t3787 = t447 * t2059 + t461 * t2066 + t2077 * t3289 + t2144 * t3358
            + t2367 * t3427 + t2419 * t3466;
        t3792 = t3787 + t2526 * t3492 + t2556 * t3501 + t2594 * t3507 + t2647 * t3513
            + t2681 * t3519;
        t3797 = t3792 + t2703 * t3525 + t2717 * t3535 + t2729 * t3541 + t2991 * t3688
            + t3069 * t3728;
        t3802 = t3797 + t620 * t3737 + t235 * t3752 - t465 * t3780 - t447 * t1997
            - t233 * t2058;
        t3807 = t3802 - t617 * t2068 - t1536 * t2072 - t2120 * t3293 - t2291 * t3372
            - t2318 * t3392;
        t3810 = t3807 - t2483 * t3482 - t930 * t3652 - t1568 * t3281;
        t3814 = self.constants[3] * self.constants[55]
            - self.constants[2] * self.constants[54];
        t3815 = t711 * t3814;
        t3817 = t750 * t3814;
        t3819 = cos_theta * t3814;
        t3822 = t1620 + self.constants[32] * t3819;
        t3827 = self.constants[32] * t3817 - t1611 - self.constants[33] * t3815;
        t3830 = t1626 + self.constants[33] * t3819;
        t3840 = t2529 * t3817 + t27 * t3822 - t2527 * t3815 - sin_phi * t3827
            - t18 * t3830;
        t3847 = t3827 + t2561 * t3815 + t363 * t3840 - t2563 * t3817;
        t3851 = t2601 * t3847 - t2596 * t3840;
        t3855 = t2648 * t3840 + t2652 * t3847;
        t3859 = t2688 * t3847 - t2683 * t3840;
        t3862 = t2708 * t3855;
        t3865 = t3862 - t2704 * t3851 - t2710 * t3859;
        t3875 = t124 * t3859 - t14 * t3815 - t26 * t3817 - t26 * t3851 - t115 * t3855;
        t3881 = t2734 * t3855 + t2737 * t3859 - t2730 * t3851;
        t3891 = self.constants[2] * t2793 - self.constants[3] * t2800;
        t3895 = self.constants[2] * t2816 + self.constants[3] * t2793;
        t3903 = t1220 * self.constants[77] - self.constants[2] * t2837
            - self.constants[3] * t2840 - t1228 * self.constants[76];
        t3909 = t2897 * t3855 - t2891 * t3851 - t2900 * t3859;
        t3917 = t2945 * t3851 + t2948 * t3855 + t2951 * t3859 + t2953 * t3865;
        t3923 = t2774 * t3819 + t2787 * t3855 + t2791 * t3859 + cos_theta * t3903
            + cos_delta * t3909 + sin_delta * t3917;
        t3928 = t3923 - t2770 * t3817 - t2776 * t3815 - t2760 * t3851 - t750 * t3891
            - t711 * t3895;
        t3946 = t3005 * t3851 + t3033 * t3855 + t3037 * t3859 + t705 * t3891
            + cos_delta * t3917 - t3019 * t3817;
        t3951 = t3946 - t1159 * t3819 - t2772 * t3815 - t91 * t3822 - t701 * t3895
            - t711 * t3903;
        t3952 = t3951 - sin_delta * t3909;
        t3961 = t3150 * t3865;
        t3970 = t1170 * t3819 + t91 * t3830 + t3124 * t3851 + t3131 * t3855
            + t3139 * t3859 + t3961;
        t3975 = t3970 + t91 * t3881 + t728 * t3891 + t750 * t3903 - t2773 * t3817
            - t3116 * t3815;
        t3976 = t3975 - t705 * t3895;
        t3981 = t3862 - t1046 * t3851 - t1048 * t3859;
        t3990 = t2314 * t3819 + t970 * t3875;
        t3995 = t3928 + t943 * t3830 + t3190 * t3855 + t3192 * t3859 + t943 * t3881
            + t3990;
        t3996 = t3995 - t932 * t3822;
        t4016 = t3207 * t3817 + t3217 * t3830 + t3219 * t3851 + t3227 * t3855
            + t3231 * t3859 + t3233 * t3875;
        t4021 = t4016 + t3217 * t3881 + t18 * t3952 - t3205 * t3815 - t3211 * t3819
            - t3213 * t3822;
        t4024 = t4021 - t3215 * t3827 - sin_phi * t3928 - t27 * t3976;
        t4032 = t2419 * t3827 + t2483 * t3830 + t2526 * t3840 + t2556 * t3847
            + t2594 * t3851 + t2647 * t3855;
        t4037 = t4032 + t2681 * t3859 + t2703 * t3865 + t2717 * t3875 + t2729 * t3881
            + t2991 * t3952;
        t4042 = t4037 + t3069 * t3976 + t620 * t3981 + t235 * t3996 - t465 * t4024
            - t2144 * t3815;
        t4047 = t4042 - t2291 * t3817 - t2318 * t3819 - t2367 * t3822 - t930 * t3928
            - t1640 * t3281;
        t4048 = t4047 - t1644 * t3810;
        t4052 = t341 * t2066;
        t4054 = t329 * t2066;
        t4059 = self.constants[7] - self.constants[7] * t1669;
        t4063 = self.constants[28] * t1692 - t693 * self.constants[28];
        t4069 = t1671 * t2155 + cos_theta * t1669;
        t4075 = t2174 * t4059 + t1669 * t2178 - t1671 * t2170;
        t4081 = t1671 * t2186 + t2190 * t4059 + t1669 * t2194;
        t4085 = t1671 * t2201 - t750 * t1669;
        t4089 = t1671 * t2208 + t711 * t1669;
        t4095 = t1671 * t2215 + t2152 * t4059 + t1669 * t2220;
        t4098 = self.constants[54] * t4085 + self.constants[24] * t4095
            - self.constants[55] * t4089;
        t4102 = t2149 * t4069 + t2161 * t4075 + t2184 * t4081 - t711 * t4098;
        t4110 = t26 * t1671;
        t4114 = sin_delta * t1669 - t124 * t1671;
        t4119 = t1671 * t2246 + self.constants[48] * t4110 - t2249 * t4059
            - t1669 * t2251 - self.constants[49] * t4114;
        t4124 = t1671 * t2236 + t2239 * t4059 + t1669 * t2241 + t1692 * t2243
            - sin_delta * t4119;
        t4127 = t2145 * t4059 + self.constants[41] * t1669 + t4102 + t4124;
        t4138 = t2299 * t4069 + t2301 * t4075 + t2161 * t4081 + t750 * t4098;
        t4141 = t814 * t1669 + self.constants[48] * t1692 - t2294 * t4059 - t4138;
        t4150 = t2326 * t4069 + t2330 * t4081 + cos_theta * t4098 - t2328 * t4075;
        t4159 = t1671 * t2338 + t2341 * t4059 + t1669 * t2343 + t1692 * t2345
            + cos_delta * t4119;
        t4161 = t1671 * t2322 + t4150 + t4159;
        t4174 = self.constants[59] * t4085 + self.constants[57] * t4089
            + self.constants[54] * t4095;
        t4180 = self.constants[58] * t4069 + self.constants[55] * t4081
            - self.constants[54] * t4075;
        t4186 = self.constants[57] * t4085 + self.constants[56] * t4089
            - self.constants[55] * t4095;
        t4192 = t1671 * t2376 + self.constants[53] * t4110 + self.constants[51] * t4114
            + self.constants[30] * t4159 + t728 * t4174 + t750 * t4180;
        t4196 = t4192 + t705 * t4186 - t1538 * t4059 - t833 * t1669
            - self.constants[32] * t4150;
        t4214 = t4063 + t1671 * t2435 + t2439 * t4059 + t1669 * t2442
            + self.constants[52] * t1692;
        t4224 = t2454 * t4059 + t1669 * t2456 + self.constants[51] * t4110
            + self.constants[50] * t4114 - t1671 * t2452;
        t4230 = t2421 * t4059 + t1669 * t2424 + t1692 * t2426
            + self.constants[32] * t4138 + self.constants[33] * t4102
            + self.constants[31] * t4124;
        t4235 = t4230 + cos_theta * t4180 + t711 * t4186 + cos_delta * t4214
            + sin_delta * t4224 - self.constants[27];
        t4236 = t4235 - t750 * t4174;
        t4250 = t1671 * t2487 + t705 * t4174 + t701 * t4186 + cos_delta * t4224
            - self.constants[33] * t4150 - self.constants[31] * t4159;
        t4252 = t4250 - t711 * t4180 - sin_delta * t4214;
        t4262 = t2527 * t4127 + t18 * t4252 - t2529 * t4141 - t27 * t4196
            - sin_phi * t4236;
        t4271 = t4236 + t2559 * t4063 + t2563 * t4141 + t363 * t4262 - t2561 * t4127;
        t4277 = t2598 * t4063 + t2601 * t4271 - t2596 * t4262;
        t4283 = t2649 * t4063 + t2648 * t4262 + t2652 * t4271;
        t4289 = t2688 * t4271 - t2685 * t4063 - t2683 * t4262;
        t4292 = t2708 * t4283;
        t4295 = t4292 - t2704 * t4277 - t2710 * t4289;
        t4305 = t14 * t4127 + t26 * t4141 + t124 * t4289 - t26 * t4277 - t115 * t4283;
        t4311 = t2734 * t4283 + t2737 * t4289 - t2730 * t4277;
        t4336 = t2797 * t4069 + t2800 * t4089 + t2802 * t4075 + t1301 * t4095
            + t1220 * t4180 - t2793 * t4085;
        t4337 = t4336 - t2805 * t4081;
        t4350 = t2816 * t4085 + t2820 * t4069 + t2793 * t4089 + t2823 * t4075
            + t1288 * t4095 + t2826 * t4081;
        t4351 = t4350 - t1228 * t4180;
        t4364 = t2837 * t4085 + t2840 * t4089 + t2844 * t4095 + t1228 * t4186
            - t2842 * t4075 - t2846 * t4081;
        t4365 = t4364 - t1220 * t4174;
        t4380 = t1671 * t2865 + t1669 * t2877 + t2882 * t4110 + t2887 * t4114
            + speeds[1] * t4224 + t2897 * t4283;
        t4383 = t4380 - t2873 * t4059 - t2891 * t4277 - t2900 * t4289;
        t4400 = t1671 * t2916 + t2924 * t4059 + t1669 * t2928 + t2931 * t4110
            + t1692 * t2935 + t2937 * t4114;
        t4405 = t4400 + t2945 * t4277 + t2948 * t4283 + t2951 * t4289 + t2953 * t4295
            - speeds[1] * t4214;
        t4411 = t1671 * t2754 + t1669 * t2766 + t1692 * t2768 + t2774 * t4150
            + t2776 * t4102 + t2780 * t4159;
        t4416 = t4411 + t2787 * t4283 + t2791 * t4289 + t711 * t4351 + cos_theta * t4365
            + cos_delta * t4383;
        t4421 = t4416 + sin_delta * t4405 - t2764 * t4059 - t2770 * t4138 - t2782 * t4124
            - t2760 * t4277;
        t4422 = t4421 - t750 * t4337;
        t4446 = t1671 * t3000 + t3009 * t4059 + t1669 * t3015 + t2772 * t4102
            + t984 * t4159 + t2778 * t4124;
        t4451 = t4446 + t91 * t4196 + t3005 * t4277 + t3033 * t4283 + t3037 * t4289
            + t705 * t4337;
        t4456 = t4451 + t701 * t4351 + cos_delta * t4405 - t1692 * t3017 - t3019 * t4138
            - t1159 * t4150;
        t4458 = t4456 - t711 * t4365 - sin_delta * t4383;
        t4481 = t3150 * t4295 + t3148 * t4114 - t2937 * t4110;
        t4486 = t1671 * t3081 + t3096 * t4059 + t1669 * t3106 + t1692 * t3112
            + t1170 * t4150 + t3116 * t4102;
        t4491 = t4486 + t982 * t4159 + t3124 * t4277 + t3131 * t4283 + t3139 * t4289
            + t91 * t4311;
        t4496 = t4491 + t728 * t4337 + t705 * t4351 + t750 * t4365 + t4481
            - t2773 * t4138;
        t4498 = t4496 - t3119 * t4124 - t91 * t4252;
        t4507 = t4292 + t2880 * t4110 - t2885 * t4114 - t1046 * t4277 - t1048 * t4289;
        t4516 = t2314 * t4161 + t970 * t4305;
        t4521 = t4422 + t932 * t4196 + t3190 * t4283 + t3192 * t4289 + t943 * t4311
            + t4516;
        t4522 = t4521 - t943 * t4252;
        t4542 = t3205 * t4127 + t3213 * t4196 + t3219 * t4277 + t3227 * t4283
            + t3231 * t4289 + t3233 * t4305;
        t4547 = t4542 + t3217 * t4311 + t18 * t4458 - t3207 * t4141 - t3211 * t4161
            - t3215 * t4236;
        t4550 = t4547 - t3217 * t4252 - sin_phi * t4422 - t27 * t4498;
        t4559 = t328 * t2059 + t191 * t4052 + t2077 * t4059 + t2120 * t4063
            + t2144 * t4127 + t2291 * t4141;
        t4564 = t4559 + t2367 * t4196 + t2419 * t4236 + t2526 * t4262 + t2556 * t4271
            + t2594 * t4277;
        t4569 = t4564 + t2647 * t4283 + t2681 * t4289 + t2703 * t4295 + t2717 * t4305
            + t2729 * t4311;
        t4574 = t4569 + t2991 * t4458 + t3069 * t4498 + t620 * t4507 + t235 * t4522
            - t465 * t4550;
        t4579 = t4574 + t1722 * t4048 - t328 * t1997 - t339 * t4054 - t543 * t1978
            - t1671 * t2072;
        t4584 = t4579 - t2318 * t4161 - t2483 * t4252 - t930 * t4422 - t1700 * t3281
            - t1716 * t3810;
        t4585 = t1759 * t4584;
        t4587 = t1652 * t4048 + t1722 * t4585;
        t4591 = t1586 * t3810 - t1644 * t4587 - t1716 * t4585;
        t4597 = t923 * t3281 - t1568 * t4591 - t1640 * t4587 - t1700 * t4585;
        t4600 = self.constants[47] * t1800;
        t4604 = self.constants[47] * t1815;
        t4608 = cos_delta * (t1927 + sin_delta * t4600)
            - sin_delta * (t1934 + sin_delta * t4604);
        t4623 = t14 * t2019 + t115 * t1963 + t85 * t4608 - t240 * t1949 - t242 * t1994;
        t4631 = cos_delta * (cos_delta * t4600 - t1934)
            - sin_delta * (t1927 + cos_delta * t4604);
        t4636 = t26 * t4631 + t242 * t2034 - t240 * t2041;
        t4639 = t1984 + self.constants[31] * t4631;
        t4643 = t1800 * t2243 - t1815 * t2345;
        t4660 = t260 * t2083 + t264 * t2089 + t268 * t2094 + t481 * t2099 + t629 * t2101
            + t634 * t1760;
        t4665 = t4660 + t649 * t2107 + t675 * t2109 - t245 * t2080 - t642 * t2096
            - t472 * t2104;
        t4674 = t240 * t1811 + t242 * t1142 - t303 * t2134 - t311 * t2137;
        t4682 = t242 * t1811 + t303 * t2282 + t311 * t2284 - t240 * t1142;
        t4688 = t242 * t1772 - t240 * t1786;
        t4692 = t303 * t1772 + t311 * t1766;
        t4696 = t240 * t1772 + t242 * t1786;
        t4711 = t260 * t2082 + t268 * t2092 + t296 * t2511 + t481 * t2098 + t486 * t1772
            + t512 * t1766;
        t4714 = t4711 - t245 * t2079 - t264 * t2087 - t472 * t2515;
        t4724 = t245 * t2541 + t260 * t2543 + t264 * t2546 - t268 * t2548 - t301 * t2550;
        t4736 = t240 * t1014 + t242 * t1009 + t264 * t2585 + t268 * t2589 - t1026 * t2574
            - t1027 * t2574;
        t4739 = t1004 * t2606 - t1018;
        t4742 = t996 + t992 * t2606;
        t4752 = cos_delta * t4739 + t264 * t2636 - sin_delta * t4742 - t240 * t2630
            - t242 * t2632 - t268 * t2640;
        t4764 = cos_delta * t4742 + sin_delta * t4739 + t242 * t2667 - t240 * t2665
            - t264 * t2671 - t268 * t2674;
        t4772 = t245 * t2693 + t264 * t2697 - t260 * t2695 - t268 * t2699;
        t4774 = t242 * t981;
        t4780 = t242 * t930 - speeds[0] * t240;
        t4784 = t240 * t930 + speeds[0] * t242;
        t4793 = t26 * t2019 + t247 * t1963 + t240 * t1994 + t486 * t2066 + t872 * t4623
            + t2074 * t4636;
        t4798 = t4793 + t910 * t4643 + t2123 * t4665 + t2274 * t4674 + t2310 * t4682
            + t1923 * t2464;
        t4803 = t4798 + t2414 * t4688 + t2475 * t4692 + t2537 * t4714 + t2569 * t4724
            + t2604 * t4736;
        t4808 = t4803 + t2655 * t4752 + t2691 * t4764 + t2713 * t4772 + t2740 * t4774
            + t953 * t2965;
        t4813 = t4808 + t3063 * t4780 + t3174 * t4784 + t678 * t3183 + t313 * t3203
            - t516 * t3251;
        t4818 = t4813 - t2232 * t4608 - t242 * t1949 - t303 * t2058 - t649 * t2068
            - t861 * t4639;
        t4822 = t4818 - t1919 * t2265 - t1821 * t2449 - t2505 * t4696 - t950 * t2910;
        t4859 = t512 * t2066 + t1536 * t4623 + t3289 * t4636 + t3358 * t4674
            + t1923 * t3455 + t3427 * t4688;
        t4864 = t4859 + t3466 * t4692 + t3492 * t4714 + t3501 * t4724 + t3507 * t4736
            + t3513 * t4752;
        t4869 = t4864 + t3519 * t4764 + t3525 * t4772 + t3541 * t4774 + t953 * t3635
            + t3688 * t4780;
        t4874 = t4869 + t3728 * t4784 + t678 * t3737 + t313 * t3752 - t516 * t3780
            - t311 * t2058;
        t4879 = t4874 - t675 * t2068 - t1534 * t4639 - t1557 * t4643 - t3293 * t4665
            - t1919 * t3350;
        t4884 = t4879 - t3372 * t4682 - t1821 * t3445 - t3482 * t4696 - t950 * t3613
            - t1568 * t4822;
        t4911 = t3827 * t4692 + t3830 * t4696 + t3840 * t4714 + t3847 * t4724
            + t3851 * t4736 + t3855 * t4752;
        t4916 = t4911 + t3859 * t4764 + t3865 * t4772 + t3881 * t4774 + t953 * t3917
            + t3952 * t4780;
        t4921 = t4916 + t3976 * t4784 + t678 * t3981 + t313 * t3996 - t516 * t4024
            - t3815 * t4674;
        t4926 = t4921 - t3817 * t4682 - t3822 * t4688 - t950 * t3909 - t1640 * t4822
            - t1644 * t4884;
        t4965 = t296 * t4052 + t1671 * t4623 + t4059 * t4636 + t1669 * t4639
            + t1692 * t4643 + t4063 * t4665;
        t4970 = t4965 + t4127 * t4674 + t4141 * t4682 + t1923 * t4224 + t4196 * t4688
            + t4236 * t4692;
        t4975 = t4970 + t4262 * t4714 + t4271 * t4724 + t4277 * t4736 + t4283 * t4752
            + t4289 * t4764;
        t4980 = t4975 + t4295 * t4772 + t4311 * t4774 + t953 * t4405 + t4458 * t4780
            + t4498 * t4784;
        t4985 = t4980 + t678 * t4507 + t313 * t4522 - t516 * t4550 + t1722 * t4926
            - t472 * t4054;
        t4990 = t4985 - t634 * t1978 - t1919 * t4119 - t1821 * t4214 - t4252 * t4696
            - t950 * t4383;
        t4993 = t1759 * (t4990 - t1700 * t4822 - t1716 * t4884);
        t4995 = t1652 * t4926 + t1722 * t4993;
        t4999 = t1586 * t4884 - t1644 * t4995 - t1716 * t4993;
        t5005 = t923 * t4822 - t1568 * t4999 - t1640 * t4995 - t1700 * t4993;
        t5006 = self.constants[2] * cos_theta;
        t5008 = self.constants[0].like(1.0) - self.constants[34];
        t5013 = t1888 * t5006 + sin_theta * (t1865 * t5008 - self.constants[35] * t1895);
        t5015 = self.constants[3] * cos_theta;
        t5017 = self.constants[0].like(1.0) - self.constants[36];
        t5022 = t1888 * t5015 - sin_theta * (t1895 * t5017 - self.constants[35] * t1865);
        t5028 = t1900 * t5006 - t1912 * t5015 - sin_theta * t1907;
        t5034 = t14 * t5013 + t26 * t5022 + t2169 * t5028;
        t5036 = t1907 * t5006;
        t5038 = t1907 * t5015;
        t5042 = t1900 * t5008 - self.constants[35] * t1912;
        t5046 = t1912 * t5017 - self.constants[35] * t1900;
        t5051 = t14 * t5038 - t26 * t5036 - sin_theta * (t26 * t5042 + t14 * t5046);
        t5065 = t1865 * t5006 + self.constants[32] * t5038 - t1895 * t5015
            - self.constants[33] * t5036
            - sin_theta
                * (t1888 + self.constants[33] * t5042 + self.constants[32] * t5046);
        t5067 = t1834 * t5006;
        t5069 = t1834 * t5015;
        t5073 = t1828 * t5008 - self.constants[35] * t1840;
        t5077 = t1840 * t5017 - self.constants[35] * t1828;
        t5082 = self.constants[55] * t5067 + self.constants[54] * t5069
            - sin_theta * (self.constants[55] * t5073 - self.constants[54] * t5077);
        t5085 = sin_theta * self.constants[24];
        t5087 = self.constants[24] * t5069 + t5077 * t5085;
        t5091 = self.constants[24] * t5067 - t5073 * t5085;
        t5097 = t1840 * t5015 - t1828 * t5006 - sin_theta * t1834;
        t5104 = t1807 * t5015 + sin_theta * (t1794 * t5017 - self.constants[35] * t1789);
        t5110 = t1794 * t5015 - t1789 * t5006 - sin_theta * t1807;
        t5117 = t1807 * t5006 - sin_theta * (t1789 * t5008 - self.constants[35] * t1794);
        t5124 = t934 * t5015 + sin_theta * (t943 * t5017 - self.constants[35] * t932);
        let (
            t5131, t5137, t5143, t5148, t5153, t5173, t5178, t5181, t5195, t5198, t5220, t5225,
            t5230, t5231, t5233, t5237, t5243, t5244, t5245, t5247, t5254, t5257, t5263, t5265,
            t5269, t5275, t5288, t5293, t5297, t5319, t5324, t5329, t5352, t5357, t5362, t5363,
            t5387, t5392, t5397, t5400, t5402, t5406, t5412, t5420, t5423, t5426, t5435, t5440,
            t5442, t5461, t5466, t5469, t5483, t5486, t5507, t5512, t5517, t5518, t5520, t5524,
            t5530, t5539, t5551, t5563, t5564, t5578, t5581, t5583, t5587, t5593, t5594, t5596,
            t5600, t5602, t5604, t5612, t5614, t5626, t5627, t5639, t5640, t5654, t5658, t5660,
            t5664, t5670, t5673, t5679, t5681, t5685, t5691, t5695, t5697, t5701, t5706, t5707,
            t5709, t5712, t5717, t5718, t5719, t5720, t5721, t5722, t5723, t5724, t5725, t5726,
            t5727, t5728, t5729, t5730, t5731, t5732, t5733, t5734, t5735,
        );
        t5131 = t934 * t5006 - sin_theta * (t932 * t5008 - self.constants[35] * t943);
        t5137 = t943 * t5015 - t932 * t5006 - sin_theta * t934;
        t5143 = t26 * t5013 + t2165 * t5028 + t872 * t5034 + t2074 * t5051
            + t2159 * t5082 + t2198 * t5091;
        t5148 = t5143 + t2227 * t5097 + t2394 * t5110 + t2400 * t5117 + t2834 * t5131
            + t2855 * t5137;
        t5153 = t5148 - t14 * t5022 - t861 * t5065 - t2182 * t5087 - t2388 * t5104
            - t2813 * t5124;
        t5173 = t1536 * t5034 + t3289 * t5051 + t3299 * t5082 + t3311 * t5091
            + t3328 * t5097 + t3411 * t5110;
        t5178 = t5173 + t3417 * t5117 + t3581 * t5131 + t3595 * t5137 - t1534 * t5065
            - t3305 * t5087;
        t5181 = t5178 - t3405 * t5104 - t3567 * t5124 - t1568 * t5153;
        t5195 = t3814 * t5097 + self.constants[77] * t5104 + t3903 * t5137
            - self.constants[5] - self.constants[76] * t5117 - t3891 * t5124;
        t5198 = t5195 - t3895 * t5131 - t1640 * t5153 - t1644 * t5181;
        t5220 = t1671 * t5034 + t4059 * t5051 + t1669 * t5065 + t4069 * t5082
            + t4081 * t5091 + t4098 * t5097;
        t5225 = t5220 + t4180 * t5110 + t4186 * t5117 + t4351 * t5131 + t4365 * t5137
            + t1722 * t5198;
        t5230 = t5225 - t4075 * t5087 - t4174 * t5104 - t4337 * t5124 - t1700 * t5153
            - t1716 * t5181;
        t5231 = t1759 * t5230;
        t5233 = t1652 * t5198 + t1722 * t5231;
        t5237 = t1586 * t5181 - t1644 * t5233 - t1716 * t5231;
        t5243 = t923 * t5153 - t1568 * t5237 - t1640 * t5233 - t1700 * t5231;
        t5244 = t2314 + t2314;
        t5245 = t26 * t5244;
        t5247 = t14 * t5244;
        t5254 = cos_delta * t930;
        t5257 = t14 * t2314 + t930 * t2572 + t2574 * t5254;
        t5263 = t26 * t2314 + t930 * t2610;
        t5265 = self.constants[30] * t3065;
        t5269 = t2574 * t3065 + t930 * t2607 + cos_delta * t5265 - sin_delta * t5263;
        t5275 = cos_delta * t5263 + sin_delta * t5265 - t2606 * t5254;
        t5288 = t2274 * t5245 + t2414 * t3065 + t2604 * t5257 + t2655 * t5269
            + t2691 * t5275 + t2740 * t2987;
        t5293 = t5288 + t26 * t3063 + t14 * t3174 + t682 * t3183 + t72 * t3203
            + t364 * t3251;
        t5297 = t5293 - t2310 * t5247 - t930 * t2475 - t2505 * t2987 - t2126 * t2726;
        t5319 = t3358 * t5245 + t3372 * t5247 + t3065 * t3427 + t3507 * t5257
            + t3513 * t5269 + t3519 * t5275;
        t5324 = t5319 + t2987 * t3541 + t26 * t3688 + t14 * t3728 + t682 * t3737
            + t72 * t3752;
        t5329 = t5324 + t364 * t3780 - t930 * t3466 - t2987 * t3482 - t2126 * t3535
            - t1568 * t5297;
        t5352 = t3817 * t5247 + t2987 * t3830 + t3851 * t5257 + t3855 * t5269
            + t3859 * t5275 + t2987 * t3881;
        t5357 = t5352 + t26 * t3952 + t14 * t3976 + t682 * t3981 + t72 * t3996
            + t364 * t4024;
        t5362 = t5357 - t3815 * t5245 - t3065 * t3822 - t930 * t3827 - t2126 * t3875
            - t1640 * t5297;
        t5363 = t5362 - t1644 * t5329;
        t5387 = t4127 * t5245 + t3065 * t4196 + t4277 * t5257 + t4283 * t5269
            + t4289 * t5275 + t2987 * t4311;
        t5392 = t5387 + t26 * t4458 + t14 * t4498 + t682 * t4507 + t72 * t4522
            + t364 * t4550;
        t5397 = t5392 + t1722 * t5363 - t4141 * t5247 - t930 * t4236 - t2987 * t4252
            - t2126 * t4305;
        t5400 = t1759 * (t5397 - t1700 * t5297 - t1716 * t5329);
        t5402 = t1652 * t5363 + t1722 * t5400;
        t5406 = t1586 * t5329 - t1644 * t5402 - t1716 * t5400;
        t5412 = t923 * t5297 - t1568 * t5406 - t1640 * t5402 - t1700 * t5400;
        t5420 = t3123 + t950 * t2574;
        t5423 = t3128 - t953 * t2606;
        t5426 = t3136 + t950 * t2606;
        t5435 = t872 * t3078 + t2074 * t3093 + t861 * t3102 + t910 * t3110 + t953 * t2464
            + t2604 * t5420;
        t5440 = t5435 + t2655 * t5423 + t690 * t3183 + t89 * t3203 + t447 * t3251
            - t3154;
        t5442 = t5440 - t950 * t2449 - t2691 * t5426;
        t5461 = t3711 + t1536 * t3078 + t3093 * t3289 + t1534 * t3102 + t953 * t3455
            + t3507 * t5420;
        t5466 = t5461 + t3513 * t5423 + t690 * t3737 + t89 * t3752 + t447 * t3780
            - t1557 * t3110;
        t5469 = t5466 - t950 * t3445 - t3519 * t5426 - t1568 * t5442;
        t5483 = t3961 + t3851 * t5420 + t3855 * t5423 + t690 * t3981 + t89 * t3996
            + t447 * t4024;
        t5486 = t5483 - t3859 * t5426 - t1640 * t5442 - t1644 * t5469;
        t5507 = t4481 + t1671 * t3078 + t3093 * t4059 + t1692 * t3110 + t953 * t4224
            + t4277 * t5420;
        t5512 = t5507 + t4283 * t5423 + t690 * t4507 + t89 * t4522 + t447 * t4550
            + t1722 * t5486;
        t5517 = t5512 - t1669 * t3102 - t950 * t4214 - t4289 * t5426 - t1700 * t5442
            - t1716 * t5469;
        t5518 = t1759 * t5517;
        t5520 = t1652 * t5486 + t1722 * t5518;
        t5524 = t1586 * t5469 - t1644 * t5520 - t1716 * t5518;
        t5530 = t923 * t5442 - t1568 * t5524 - t1640 * t5520 - t1700 * t5518;
        t5539 = t1256 * t2394 + t1199 * t2400 + self.constants[2] * t2813
            + self.constants[3] * t2834 - t1208 * t2388;
        t5551 = t1256 * t3411 + t1199 * t3417 + self.constants[2] * t3567
            + self.constants[3] * t3581 - t1208 * t3405 - t1568 * t5539;
        t5563 = t1208 * self.constants[77] + self.constants[2] * t3891
            - self.constants[6] - t1199 * self.constants[76] - self.constants[3] * t3895
            - t1640 * t5539;
        t5564 = t5563 - t1644 * t5551;
        t5578 = t1256 * t4180 + t1199 * t4186 + self.constants[2] * t4337
            + self.constants[3] * t4351 + t1722 * t5564 - t1208 * t4174;
        t5581 = t1759 * (t5578 - t1700 * t5539 - t1716 * t5551);
        t5583 = t1652 * t5564 + t1722 * t5581;
        t5587 = t1586 * t5551 - t1644 * t5583 - t1716 * t5581;
        t5593 = t923 * t5539 - t1568 * t5587 - t1640 * t5583 - t1700 * t5581;
        t5594 = self.constants[27] * t943;
        t5596 = self.constants[27] * t932;
        t5600 = t14 * t5594 + t26 * t5596;
        t5602 = cos_delta * t2314;
        t5604 = sin_delta * t2314;
        t5612 = t26 * t5594 + t872 * t5600 + t2655 * t5602 + t2691 * t5604 + t693 * t3183
            + t328 * t3251;
        t5614 = t5612 - t3197 - t14 * t5596;
        t5626 = t3746 + t1536 * t5600 + t3513 * t5602 + t3519 * t5604 + t693 * t3737
            + t328 * t3780;
        t5627 = t5626 - t1568 * t5614;
        t5639 = t3990 + t3855 * t5602 + t3859 * t5604 + t693 * t3981 + t328 * t4024
            - t1640 * t5614;
        t5640 = t5639 - t1644 * t5627;
        t5654 = t4516 + t1671 * t5600 + t4283 * t5602 + t4289 * t5604 + t693 * t4507
            + t328 * t4550;
        t5658 = t1759 * (t5654 + t1722 * t5640 - t1700 * t5614 - t1716 * t5627);
        t5660 = t1652 * t5640 + t1722 * t5658;
        t5664 = t1586 * t5627 - t1644 * t5660 - t1716 * t5658;
        t5670 = t923 * t5614 - t1568 * t5664 - t1640 * t5660 - t1700 * t5658;
        t5673 = t1568 * t1644 - t1640;
        t5679 = t1759 * (t1568 * t1716 + t1722 * t5673 - t1700);
        t5681 = t1652 * t5673 + t1722 * t5679;
        t5685 = t1568 * t1586 + t1644 * t5681 + t1716 * t5679;
        t5691 = t923 + t1568 * t5685 - t1640 * t5681 - t1700 * t5679;
        t5695 = t1759 * (t1716 + t1644 * t1722);
        t5697 = t1644 * t1652 + t1722 * t5695;
        t5701 = t1586 + t1644 * t5697 + t1716 * t5695;
        t5706 = t1640 * t5697 + t1700 * t5695 - t1568 * t5701;
        t5707 = t1722 * t1759;
        t5709 = t1652 + t1722 * t5707;
        t5712 = t1644 * t5709 + t1716 * t5707;
        t5717 = t1568 * t5712 - t1640 * t5709 - t1700 * t5707;
        t5718 = -(t98 * t235);
        t5719 = -(t98 * t313);
        t5720 = -(t72 * t98);
        t5721 = -(t89 * t98);
        t5722 = -t98;
        t5723 = -(t93 * cos_psi);
        t5724 = -(t235 * t318);
        t5725 = -(t313 * t318);
        t5726 = -(t72 * t318);
        t5727 = -(t89 * t318);
        t5728 = -t318;
        t5729 = -t364;
        t5730 = -t447;
        t5731 = -t328;
        t5732 = -t5685;
        t5733 = -t5712;
        t5734 = -t5697;
        t5735 = -t5695;
        (
            [
                [
                    zero, zero, t96, t5718, zero, t5719, zero, zero, zero, t5720, t5721, zero,
                    t5722,
                ],
                [
                    zero, zero, t5723, t5724, zero, t5725, zero, zero, zero, t5726, t5727, zero,
                    t5728,
                ],
                [
                    zero, zero, zero, t465, zero, t516, zero, zero, zero, t5729, t5730, zero, t5731,
                ],
                [
                    zero, zero, zero, zero, zero, zero, zero, zero, zero,
                    self.constants[0].like(1.0), zero, zero, zero,
                ],
                [
                    zero, zero, zero, t235, zero, t313, zero, zero, zero, t72, t89, zero, zero,
                ],
                [
                    zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                    self.constants[0].like(1.0), zero, zero,
                ],
                [
                    zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                    self.constants[0].like(1.0), zero,
                ],
                [
                    zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                    self.constants[0].like(1.0),
                ],
                [
                    zero, zero, zero, t620, zero, t678, zero, zero, zero, t682, t690, zero, t693,
                ],
                [
                    zero, zero, zero, t4597, zero, t5005, t5243, zero, zero, t5412, t5530, t5593,
                    t5670,
                ],
                [
                    zero, zero, zero, t4591, zero, t4999, t5237, zero, zero, t5406, t5524, t5587,
                    t5664,
                ],
                [
                    zero, zero, zero, t4587, zero, t4995, t5233, zero, zero, t5402, t5520, t5583,
                    t5660,
                ],
                [
                    zero, zero, zero, t4585, zero, t4993, t5231, zero, zero, t5400, t5518, t5581,
                    t5658,
                ],
            ],
            [
                [zero, zero, zero], [zero, zero, zero], [zero, zero, zero], [zero, zero, zero],
                [zero, zero, zero], [zero, zero, zero], [zero, zero, zero], [zero, zero, zero],
                [zero, zero, zero], [t5691, t5706, t5717], [t5732, t5701, t5733],
                [t5681, t5734, t5709], [t5679, t5735, t5707],
            ],
        )
    }

    fn by_parameters_unchecked(&self, positions: &[T; 9], speeds: &[T; 4], forces: &[T; 3]) -> [[T; 36]; 13] {
        let (
            sin_pitch, cos_pitch, t7, sin_phi, cos_phi, t12, t13, sin_delta, cos_delta, t16, t20,
            t21, t25, t26, t27, t28, t30, t32, t36, t40, t41, t48, t51, t53, t55, t56, t57, t58,
            t63, t64, t65, sin_psi, cos_psi, t70, t71, t73, t74, t75, t77, t78, t80, t81, t83, t85,
            t86, t87, t89, t91, t93, t96, t97, t98, t101, t103, t107, t109, t112, t114, t117, t119,
            t123, t126, t129, t131, t135, t136, t137, t139, t140, t141, t142, t145, t147, t153,
            t155, t156, t160, t162, t165, t166, t168, t170, t173, t175, t182, t185, t192, t198,
            t200, t208, t210, t212, t218, t221, t225, t226, t228, t233, t237, t241, t245, t247,
            t255, t256, t258, t276, t279, t281, t283, t286, t292, zero, t297, t298, t304, t307,
            t308, t310, t316, t317, t319, t326, t327, t329, t335, t337, t338, t340, t342, t345,
            t347, t352, t354, t360, t372, t378, t380, t388, t390, t392, t398, t405, t416, t427,
            t438, t442, t443, t444, t446, t453, t456, t458, t459, t463, t464, t468, t469, t473,
            t474, t479, t481, t483, t485, t486, t487, t489, t492, t494, t496, t497, t500, t504,
            t505, t506, t513, t514, t516, t517, t520, t524, t525, t527, t529, t531, t534, t537,
            t542, t547, t552, t556, t562, t566, t568, t576, t583, t587, t596, t600, t606, t608,
            t616, t618, t620, t622, t629, t636, t647, t651, t661, t663, t664, t676, t677, t679,
            t681, t685, t690, t692, t698, t710, t716, t718, t726, t728, t730, t736, t743, t754,
            t763, t774, t775, t776, t777, t779, t784, t785, t792, t796, t797, t798, t800, t804,
            t807, t809, t814, t817, t818, t823, t827, t828, t831, t834, t838, t840,
        );
        (sin_pitch, cos_pitch) = positions[4].sin_cos();
        t7 = self.constants[3] * sin_pitch + self.constants[2] * cos_pitch;
        (sin_phi, cos_phi) = positions[3].sin_cos();
        t12 = self.constants[3] * cos_pitch - sin_pitch * self.constants[2];
        t13 = cos_phi * t12;
        (sin_delta, cos_delta) = positions[5].sin_cos();
        t16 = t7 * cos_phi;
        t20 = sin_phi * sin_delta;
        t21 = t20 - cos_delta * t16;
        t25 = (t21 * t21 + t13 * t13).sqrt();
        t26 = self.constants[0].like(1.0) / t25;
        t27 = t13 * t26;
        t28 = cos_phi * sin_delta;
        t30 = t21 * t26;
        t32 = cos_delta * t27;
        t36 = t27 * t28 + sin_phi * (t12 * t30 + t7 * t32);
        t40 = cos_delta * sin_phi + t16 * sin_delta;
        t41 = self.constants[8] * t40;
        t48 = self.constants[30] + cos_delta * self.constants[37];
        t51 = t36 * t41 + t7 * self.constants[39] + t12 * t48;
        t53 = self.constants[0].like(1.0) / (cos_phi * t51);
        t55 = self.constants[2] * t13;
        t56 = t55 - self.constants[3] * t16;
        t57 = t53 * t56;
        t58 = t7 * t57;
        t63 = t51 - t7 * self.constants[31] - t12 * self.constants[30];
        t64 = sin_phi * t53;
        t65 = t63 * t64;
        (sin_psi, cos_psi) = positions[2].sin_cos();
        t70 = self.constants[7] * cos_psi;
        t71 = speeds[1] * t70;
        t73 = t12 * sin_phi;
        t74 = t53 * t73;
        t75 = t71 * t74;
        t77 = t7 * t64;
        t78 = t71 * t77;
        t80 = t26 * t26;
        t81 = t21 * t80;
        t83 = t26 * self.constants[0].like(0.5);
        t85 = cos_phi * (t13 + t13);
        t86 = t83 * t85;
        t87 = t81 * t86;
        t89 = t12 * cos_delta;
        t91 = t13 * t80;
        t93 = cos_phi * t26 - t86 * t91;
        t96 = t32 + t7 * t87 + t89 * t93;
        t97 = t41 * t96;
        t98 = t7 * t53;
        t101 = t70 * speeds[0];
        t103 = t71 * t98 + t53 * t101;
        t107 = t7 * cos_delta;
        t109 = t28 + sin_phi * t107;
        t112 = sin_phi * t30 + t93 * t109 - t73 * t87;
        t114 = t48 + t41 * t112;
        t117 = t12 * t32 - t7 * t30;
        t119 = sin_delta * self.constants[37];
        t123 = t12 * self.constants[39] - t7 * t48;
        t126 = cos_phi * t119 - t41 * t117 - sin_phi * t123;
        t129 = t12 * self.constants[31] - t7 * self.constants[30];
        t131 = t126 + sin_phi * t129;
        t135 = t53 * (t7 * t131 + t63 * t73);
        t136 = cos_phi * t53;
        t137 = t135 * t136;
        t139 = sin_phi * self.constants[7];
        t140 = t126 + t139;
        t141 = t53 * t140;
        t142 = t136 * t141;
        t145 = t71 * t137 + t101 * t142 - t75;
        t147 = sin_phi * t103;
        t153 = self.constants[30] * t75 + t97 * t103 + t114 * t145
            + self.constants[39] * t147 - t65 * t71 - self.constants[31] * t78;
        t155 = t12 * t57;
        t156 = t53 * t131;
        t160 = t28 * self.constants[8];
        t162 = cos_phi * cos_delta;
        t165 = t162 * (t21 + t21);
        t166 = t83 * t165;
        t168 = t81 * t166 - t26 * t162;
        t170 = t91 * t166;
        t173 = t89 * t170 - t30 - t7 * t168;
        t175 = t117 * t160 + t41 * t173;
        t182 = sin_phi * t32 + t73 * t168 + t109 * t170;
        t185 = self.constants[39] + t36 * t160 + t41 * t182;
        t192 = self.constants[31] * t75 + self.constants[30] * t78 + t103 * t175
            + t145 * t185 - t71 * t156 - t48 * t147;
        t198 = t7 * t145 + t12 * t147;
        t200 = t7 * t75 + t198 - t12 * t78;
        t208 = t12 * t75 + t7 * t78 + t12 * t145 - t7 * t147;
        t210 = self.constants[2] * t200 + self.constants[3] * t208;
        t212 = t155 * t192 + t210 - t58 * t153;
        t218 = t89 * t145 - t28 * t103 - t107 * t147;
        t221 = t20 - cos_phi * t107;
        t225 = t53 * (t56 - t55 - self.constants[3] * t221);
        t226 = t7 * t225;
        t228 = t12 * t225;
        t233 = t210 + t192 * t228 - self.constants[2] * t198 - self.constants[3] * t218
            - t153 * t226;
        t237 = self.constants[0] + self.constants[1];
        t241 = self.constants[3] * self.constants[8]
            - self.constants[2] * (self.constants[0] - t237);
        t245 = cos_phi * t48;
        t247 = cos_phi * self.constants[39];
        t255 = self.constants[8] * t83;
        t256 = t165 * t255;
        t258 = t85 * t255;
        t276 = self.constants[3]
            * (t16 * self.constants[7] + t13 * t237 - cos_pitch * t245
                - sin_pitch * t247) + t221 * t241;
        t279 = t276 + t13 * self.constants[37]
            - self.constants[3] * (cos_pitch * t256 + sin_pitch * t258)
            - self.constants[2]
                * (cos_pitch * t247 + t13 * self.constants[7] - sin_pitch * t245
                    - t16 * t237);
        t281 = t53 * (t279 - self.constants[2] * (cos_pitch * t258 - sin_pitch * t256));
        t283 = t7 + t7 * t281;
        t286 = t12 + t12 * t281;
        t292 = self.constants[37] * t198 + t218 * t241 + self.constants[30] * t200
            + t192 * t286 - self.constants[31] * t208 - t153 * t283;
        zero = self.constants[0].like(0.0);
        t297 = speeds[0] * t141 + speeds[1] * t135;
        t298 = speeds[3] + t297;
        t304 = self.constants[3] * t13;
        t307 = t53 * (self.constants[2] * t16 + t304 - cos_phi);
        t308 = t7 * t307;
        t310 = t12 * t307;
        t316 = self.constants[3] * t200 + t192 * t310 - cos_psi * t298 - t64 * t101
            - self.constants[2] * t208 - t153 * t308;
        t317 = t40 * t117;
        t319 = t36 * t40;
        t326 = t53 * (t25 + self.constants[2] * t221 - t304);
        t327 = t7 * t326;
        t329 = t12 * t326;
        t335 = t103 * t317 + t145 * t319 + self.constants[2] * t218 + t192 * t329
            - self.constants[3] * t198 - t153 * t327;
        t337 = self.constants[7] * sin_psi;
        t338 = speeds[1] * t337;
        t340 = t74 * t338;
        t342 = t77 * t338;
        t345 = speeds[0] * t337;
        t347 = t98 * t338 + t53 * t345;
        t352 = t137 * t338 + t142 * t345 - t340;
        t354 = sin_phi * t347;
        t360 = self.constants[30] * t340 + t97 * t347 + t114 * t352
            + self.constants[39] * t354 - t65 * t338 - self.constants[31] * t342;
        t372 = self.constants[31] * t340 + self.constants[30] * t342 + t175 * t347
            + t185 * t352 - t156 * t338 - t48 * t354;
        t378 = t7 * t352 + t12 * t354;
        t380 = t7 * t340 + t378 - t12 * t342;
        t388 = t12 * t340 + t7 * t342 + t12 * t352 - t7 * t354;
        t390 = self.constants[2] * t380 + self.constants[3] * t388;
        t392 = t155 * t372 + t390 - t58 * t360;
        t398 = t89 * t352 - t28 * t347 - t107 * t354;
        t405 = t390 + t228 * t372 - self.constants[2] * t378 - self.constants[3] * t398
            - t226 * t360;
        t416 = self.constants[37] * t378 + t241 * t398 + self.constants[30] * t380
            + t286 * t372 - self.constants[31] * t388 - t283 * t360;
        t427 = self.constants[3] * t380 + t310 * t372 - t298 * sin_psi - t64 * t345
            - self.constants[2] * t388 - t308 * t360;
        t438 = t317 * t347 + t319 * t352 + self.constants[2] * t398 + t329 * t372
            - self.constants[3] * t378 - t327 * t360;
        t442 = self.constants[0].like(1.0) / (t51 * t117 + t36 * t140);
        t443 = self.constants[7] * t442;
        t444 = t112 * t443;
        t446 = t36 * t442;
        t453 = t25 * self.constants[8] + sin_phi * t119 + cos_phi * t123
            - cos_phi * t129;
        t456 = sin_phi * t453 + cos_phi * t131;
        t458 = t117 * t442;
        t459 = cos_phi * t63;
        t463 = t73 * t446 - t7 * t458;
        t464 = self.constants[8] * t463;
        t468 = t13 * t63 - t7 * t453;
        t469 = t442 * t468;
        t473 = t73 * t453 + t13 * t131;
        t474 = t442 * t473;
        t479 = t446 * t456 + t458 * t459 + t86 * t464 + t96 * t469 + t112 * t474;
        t481 = sin_phi * t51;
        t483 = sin_phi * t140;
        t485 = t117 * t481 + t36 * t483;
        t486 = t442 * t485;
        t487 = speeds[1] * t486;
        t489 = t13 * t458;
        t492 = speeds[1] * t489 + t74 * t487;
        t494 = t13 * sin_phi;
        t496 = cos_phi * t463;
        t497 = t446 * t494 - t496;
        t500 = speeds[1] * t497 + t77 * t487;
        t504 = t51 * t96 + t112 * t140;
        t505 = t36 * t443;
        t506 = t442 * t505;
        t513 = t442 * (t117 * t468 + t36 * t473 + t135 * t485);
        t514 = t442 * t513;
        t516 = t141 * t486;
        t517 = t442 * t516;
        t520 = speeds[3] * t506 + speeds[1] * t514 + speeds[0] * t517;
        t524 = t96 * t481 + t112 * t483;
        t525 = t135 * t442;
        t527 = t141 * t442;
        t529 = speeds[1] * t525 + speeds[0] * t527;
        t531 = t13 * t446;
        t534 = speeds[0] * t486;
        t537 = sin_phi * t36;
        t542 = t36 * t520 - speeds[1] * t531 - t98 * t487 - t53 * t534 - t529 * t537;
        t547 = sin_phi * t117;
        t552 = t137 * t487 + t142 * t534 + t117 * t520 - t492 - t529 * t547;
        t556 = speeds[1] * t496 + sin_phi * t542;
        t562 = self.constants[30] * t492 + t504 * t520 + t114 * t552 - speeds[3] * t444
            - speeds[1] * t479 - t65 * t487;
        t566 = t562 - self.constants[31] * t500 - t524 * t529 - t97 * t542
            - self.constants[39] * t556;
        t568 = t182 * t443;
        t576 = t173 * t469 + t182 * t474 - t453 * t458 - t166 * t464;
        t583 = t51 * t173 + t140 * t182;
        t587 = t173 * t481 + t182 * t483;
        t596 = self.constants[31] * t492 + self.constants[30] * t500 + t520 * t583
            + t185 * t552 + t48 * t556 - speeds[3] * t568;
        t600 = t596 - speeds[1] * t576 - t156 * t487 - t529 * t587 - t175 * t542;
        t606 = t7 * t552 - t12 * t556;
        t608 = t7 * t492 + t606 - t12 * t500;
        t616 = t12 * t492 + t7 * t500 + t12 * t552 + t7 * t556;
        t618 = self.constants[2] * t608 + self.constants[3] * t616;
        t620 = t155 * t600 + t618 - t58 * t566;
        t622 = t20 * t463;
        t629 = t28 * t542 + t89 * t552 + t107 * t556 - speeds[1] * t622;
        t636 = t618 + t228 * t600 - self.constants[2] * t606 - self.constants[3] * t629
            - t226 * t566;
        t647 = self.constants[37] * t606 + t241 * t629 + self.constants[30] * t608
            + t286 * t600 - self.constants[31] * t616 - t283 * t566;
        t651 = sin_phi * t537;
        t661 = t520 * t537 + self.constants[3] * t608 + t310 * t600 - speeds[3] * t446
            - t64 * t534 - t529 * t651;
        t663 = t661 - self.constants[2] * t616 - t308 * t566;
        t664 = t25 * t463;
        t676 = t319 * t552 + self.constants[2] * t629 + t329 * t600 - speeds[1] * t664
            - t317 * t542 - self.constants[3] * t606;
        t677 = t676 - t327 * t566;
        t679 = speeds[1] * t74;
        t681 = speeds[1] * t77;
        t685 = speeds[1] * t98 + t53 * speeds[0];
        t690 = t679 - speeds[1] * t137 - speeds[0] * t142;
        t692 = sin_phi * t685;
        t698 = t65 * speeds[1] + self.constants[31] * t681 + t114 * t690
            - self.constants[30] * t679 - t97 * t685 - self.constants[39] * t692;
        t710 = speeds[1] * t156 + t185 * t690 + t48 * t692 - self.constants[31] * t679
            - self.constants[30] * t681 - t175 * t685;
        t716 = t7 * t690 - t12 * t692;
        t718 = t12 * t681 + t716 - t7 * t679;
        t726 = t12 * t690 + t7 * t692 - t12 * t679 - t7 * t681;
        t728 = self.constants[2] * t718 + self.constants[3] * t726;
        t730 = t155 * t710 + t728 - t58 * t698;
        t736 = t28 * t685 + t89 * t690 + t107 * t692;
        t743 = t728 + t228 * t710 - self.constants[2] * t716 - self.constants[3] * t736
            - t226 * t698;
        t754 = self.constants[37] * t716 + t241 * t736 + self.constants[30] * t718
            + t286 * t710 - self.constants[31] * t726 - t283 * t698;
        t763 = t64 * speeds[0] + self.constants[3] * t718 + t310 * t710
            - self.constants[2] * t726 - t308 * t698;
        t774 = t319 * t690 + self.constants[2] * t736 + t329 * t710 - t317 * t685
            - self.constants[3] * t716 - t327 * t698;
        t775 = self.constants[0].like(1.0) / self.constants[8];
        t776 = self.constants[7] * t775;
        t777 = t96 * t776;
        t779 = speeds[1] * t775;
        t784 = t7 * t36 + t73 * t117;
        t785 = self.constants[8] * t784;
        t792 = t117 * t456 + t86 * t785 + t96 * t473 - t36 * t459 - t112 * t468;
        t796 = t36 * t51 - t117 * t140;
        t797 = t775 * t796;
        t798 = speeds[3] * t797;
        t800 = t779 * t796;
        t804 = t36 * t481 - t117 * t483;
        t807 = t486 * t800 - t779 * t804;
        t809 = t13 * t36;
        t814 = t489 * t800 + t74 * t807 - t779 * t809;
        t817 = cos_phi * t784;
        t818 = t117 * t494 - t817;
        t823 = t779 * t818 + t497 * t800 + t77 * t807;
        t827 = t51 * t112 - t96 * t140;
        t828 = t505 * t775;
        t831 = t516 * t775;
        t834 = speeds[3] * t828 + t513 * t779 + speeds[0] * t831;
        t838 = t112 * t481 - t96 * t483;
        t840 = t141 * t775;
        let (
            t842, t846, t849, t853, t855, t859, t862, t872, t874, t886, t887, t893, t899, t904,
            t907, t909, t917, t926, t930, t941, t946, t949, t955, t957, t965, t967, t969, t971,
            t980, t987, t998, t999, t1004, t1016, t1021, t1029, t1030, t1031, t1035, t1036, t1038,
            t1043, t1044, t1057, t1062, sin_theta, cos_theta, t1068, t1071, t1075, t1077, t1081,
            t1091, t1092, t1095, t1098, t1101, t1102, t1107, t1111, t1113, t1118, t1120, t1121,
            t1124, t1130, t1131, t1134, t1135, t1136, t1139, t1144, t1145, t1146, t1148, t1161,
            t1166, t1170, t1171, t1173, t1179, t1184, t1187, t1189, t1190, t1193, t1199, t1202,
            t1204, t1208, t1212, t1214, t1218, t1227, t1229, t1231, t1241, t1242, t1254, t1256,
            t1261, t1263, t1269, t1275, t1277, t1279, t1282, t1283, t1285, t1291, t1294, t1295,
            t1300, t1301, t1302, t1303, t1304, t1306, t1307, t1309, t1310, t1312, t1315, t1317,
            t1319, t1320, t1321, t1323, t1324, t1327, t1328, t1330, t1331, t1332, t1334, t1336,
            t1338, t1339, t1342, t1346, t1349, t1350, t1351, t1353, t1354, t1357, t1358, t1359,
            t1362, t1364, t1368, t1370, t1374, t1375, t1379, t1380, t1385, t1387, t1389, t1394,
            t1396, t1398, t1400, t1402, t1405, t1406, t1407, t1408, t1410, t1411, t1417, t1421,
            t1426, t1427, t1428, t1432, t1434, t1437, t1441, t1442, t1448, t1450, t1454, t1468,
            t1472, t1474, t1479, t1483, t1485, t1487, t1490, t1494, t1495, t1497, t1502, t1505,
            t1506, t1509, t1512, t1513, t1514, t1516, t1518, t1523, t1528, t1531, t1532, t1534,
            t1537, t1538, t1540, t1541, t1542, t1544, t1547, t1549, t1552, t1557, t1561, t1563,
            t1565, t1567, t1570, t1577, t1578, t1579, t1585, t1587, t1593, t1598, t1601, t1602,
            t1606, t1609, t1611, t1613, t1615, t1618, t1624, t1630, t1635, t1641, t1644, t1645,
            t1648, t1651, t1658, t1661, t1666, t1668, t1669,
        );
        t842 = t135 * t779 + speeds[0] * t840;
        t846 = speeds[0] * t797;
        t849 = t506 * t798 + t514 * t800 + t517 * t846;
        t853 = t525 * t800 + t527 * t846;
        t855 = t13 * t117;
        t859 = t775 * t804;
        t862 = t486 * t846 - speeds[0] * t859;
        t872 = t779 * t855 + t531 * t800 + t98 * t807 + t53 * t862 + t547 * t842
            + t537 * t853;
        t874 = t872 - t117 * t834 - t36 * t849;
        t886 = t814 + t36 * t834 + t547 * t853 - t137 * t807 - t142 * t862 - t537 * t842;
        t887 = t886 - t117 * t849;
        t893 = t779 * t817 + t496 * t800 - sin_phi * t874;
        t899 = speeds[3] * t777 + t779 * t792 + t444 * t798 + t479 * t800 + t65 * t807
            + self.constants[31] * t823;
        t904 = t899 + t827 * t834 + t524 * t853 + t114 * t887 + self.constants[39] * t893
            - self.constants[30] * t814;
        t907 = t904 - t838 * t842 - t504 * t849 - t97 * t874;
        t909 = t173 * t776;
        t917 = t36 * t453 + t173 * t473 - t166 * t785 - t182 * t468;
        t926 = t51 * t182 - t140 * t173;
        t930 = t182 * t481 - t173 * t483;
        t941 = speeds[3] * t909 + t779 * t917 + t568 * t798 + t576 * t800 + t156 * t807
            + t834 * t926;
        t946 = t941 + t587 * t853 + t185 * t887 - self.constants[31] * t814
            - self.constants[30] * t823 - t842 * t930;
        t949 = t946 - t583 * t849 - t175 * t874 - t48 * t893;
        t955 = t7 * t887 + t12 * t893;
        t957 = t12 * t823 + t955 - t7 * t814;
        t965 = t12 * t887 - t12 * t814 - t7 * t823 - t7 * t893;
        t967 = self.constants[2] * t957 + self.constants[3] * t965;
        t969 = t155 * t949 + t967 - t58 * t907;
        t971 = t20 * t784;
        t980 = t779 * t971 + t622 * t800 + t28 * t874 + t89 * t887 - t107 * t893;
        t987 = t967 + t228 * t949 - self.constants[2] * t955 - self.constants[3] * t980
            - t226 * t907;
        t998 = self.constants[37] * t955 + t241 * t980 + self.constants[30] * t957
            + t286 * t949 - self.constants[31] * t965 - t283 * t907;
        t999 = t117 * t775;
        t1004 = sin_phi * t547;
        t1016 = speeds[3] * t999 + t446 * t798 + t64 * t862 + t842 * t1004 + t651 * t853
            + self.constants[3] * t957;
        t1021 = t1016 + t310 * t949 - t547 * t834 - t537 * t849
            - self.constants[2] * t965 - t308 * t907;
        t1029 = t775 * (t117 * t473 + t513 * t796 - t36 * t468 - t135 * t804);
        t1030 = t775 * t1029;
        t1031 = speeds[1] * t1030;
        t1035 = t775 * (self.constants[7] * t117 + t505 * t796);
        t1036 = t775 * t1035;
        t1038 = t25 * t784;
        t1043 = t775 * (t516 * t796 - t141 * t804);
        t1044 = t775 * t1043;
        t1057 = t779 * t1038 + t664 * t800 + t319 * t887 + self.constants[2] * t980
            + t329 * t949 - t1031;
        t1062 = t1057 - speeds[3] * t1036 - speeds[0] * t1044 - t317 * t874
            - self.constants[3] * t955 - t327 * t907;
        (sin_theta, cos_theta) = positions[6].sin_cos();
        t1068 = self.constants[0].like(1.0) - cos_theta;
        t1071 = cos_theta + t1068 * self.constants[34];
        t1075 = t1068 * self.constants[35];
        t1077 = t1075 * self.constants[57];
        t1081 = self.constants[2] * sin_theta;
        t1091 = sin_delta * self.constants[66];
        t1092 = sin_delta * t1091;
        t1095 = t1075 * self.constants[54];
        t1098 = cos_theta + t1068 * self.constants[36];
        t1101 = t1095 + t1098 * self.constants[55];
        t1102 = self.constants[33] * t1101;
        t1107 = t1102 + t1102 + self.constants[63] + self.constants[68];
        t1111 = self.constants[45] + self.constants[50]
            + t1071 * (t1071 * self.constants[56] + t1077)
            + t1081 * t1081 * self.constants[58]
            + t1075 * (t1071 * self.constants[57] + t1075 * self.constants[59]);
        t1113 = t1111 + t1107 - t1092;
        t1118 = self.constants[56] * t1075 + self.constants[57] * t1098;
        t1120 = self.constants[3] * sin_theta;
        t1121 = self.constants[58] * t1120;
        t1124 = t1077 + self.constants[59] * t1098;
        t1130 = t1075 * self.constants[55];
        t1131 = t1071 * self.constants[54] + t1130;
        t1134 = cos_delta * self.constants[48];
        t1135 = self.constants[30] * t1134;
        t1136 = self.constants[32] * t1131 - t1135;
        t1139 = self.constants[65] + self.constants[71] - t1136 - t1136;
        t1144 = self.constants[46] + self.constants[53] + t1075 * t1118 + t1120 * t1121
            + t1098 * t1124 + t1139;
        t1145 = t1144 - t1113;
        t1146 = t7 * t7;
        t1148 = t7 * t12;
        t1161 = cos_delta * self.constants[51] - self.constants[31] * t1134;
        t1166 = self.constants[42] + t1071 * t1118 + t1075 * t1124
            + t1101 * self.constants[32] + self.constants[64] + t1161;
        t1170 = t1166 - t1081 * t1121 - self.constants[33] * t1131 - self.constants[69]
            - self.constants[70];
        t1171 = t1170 + t1170;
        t1173 = t1145 * t1146 + t1148 * t1171;
        t1179 = t1101 + self.constants[41] + self.constants[62] + self.constants[72];
        t1184 = self.constants[40] + self.constants[67];
        t1187 = t1131 + t1134 + t1184 - self.constants[61];
        t1189 = t12 * t1179 - t7 * t1187;
        t1190 = self.constants[7] * t1189;
        t1193 = self.constants[74] - t1190 - t1190;
        t1199 = t1081 * self.constants[54] - self.constants[55] * t1120;
        t1202 = sin_delta * self.constants[48];
        t1204 = sin_delta * self.constants[51] - self.constants[31] * t1202;
        t1208 = t1081 * t1118 + cos_theta * t1121 + t1204 - t1120 * t1124
            - self.constants[33] * t1199;
        t1212 = self.constants[56] * t1081 - self.constants[57] * t1120;
        t1214 = cos_theta * self.constants[58];
        t1218 = self.constants[57] * t1081 - self.constants[59] * t1120;
        t1227 = t1071 * t1212 + t1075 * t1218 + self.constants[32] * t1199
            + cos_delta * t1091 - t1081 * t1214 - self.constants[30] * t1202;
        t1229 = t7 * t1208 + t12 * t1227;
        t1231 = t141 - sin_phi * t516;
        t1241 = t1170 + t1145 * t1148 + self.constants[7] * (t7 * t1179 + t12 * t1187)
            - t1146 * t1171;
        t1242 = cos_phi * t516;
        t1254 = t1092 + t1107 + t1139 + t1193 + self.constants[43] + self.constants[52]
            + t1081 * t1212;
        t1256 = t1254 + cos_theta * t1214 - t1120 * t1218;
        t1261 = self.constants[7] * (t1199 + t1202);
        t1263 = t12 * t1208 + t1261 - t7 * t1227;
        t1269 = t1144 - t1173;
        t1275 = t1231 * self.constants[27];
        t1277 = t12 * sin_delta;
        t1279 = t7 * sin_delta;
        t1282 = cos_delta * t1231 - t1277 - t1242 * t1279;
        t1283 = t1043 + t1282;
        t1285 = t1283 * self.constants[28];
        t1291 = t1113 + t1173 + t1193 + t1229 * t1231
            + t1231 * (t1229 + t1231 * t1256 - t1242 * t1263) + t1231 * t1275;
        t1294 = t1291 + t1283 * t1285 - t1241 * t1242
            - t1242 * (t1241 + t1231 * t1263 - t1242 * t1269);
        t1295 = self.constants[0].like(1.0) / t1294;
        t1300 = speeds[0] * t516 + speeds[1] * t513 + speeds[3] * t505;
        t1301 = sin_phi * t1300;
        t1302 = t297 - t1301;
        t1303 = t12 * speeds[0];
        t1304 = cos_phi * t1300;
        t1306 = t1303 + t7 * t1304;
        t1307 = self.constants[42] * t1306;
        t1309 = t7 * speeds[0];
        t1310 = t1309 - t12 * t1304;
        t1312 = t1307 + self.constants[46] * t1310;
        t1315 = speeds[3] + t1302;
        t1317 = self.constants[43] * t1302 + self.constants[27] * t1315;
        t1319 = t1302 * t1312 - t1310 * t1317;
        t1320 = self.constants[7] * t1301;
        t1321 = t1304 * t1320;
        t1323 = sin_phi * self.constants[60];
        t1324 = t298 * t1304;
        t1327 = t1321 - self.constants[7] * t1324;
        t1328 = t1323 + t1327;
        t1330 = t297 * t1310;
        t1331 = speeds[0] * t1301;
        t1332 = self.constants[31] * t1302;
        t1334 = self.constants[30] * t1302;
        t1336 = t1310 * t1332 + t1306 * t1334;
        t1338 = t297 * t1306;
        t1339 = t12 * t1331 + t1338;
        t1342 = t1330 + t7 * t1331;
        t1346 = t1336 + self.constants[30] * t1339 + self.constants[31] * t1342 - t1327;
        t1349 = self.constants[30] * t1310;
        t1350 = self.constants[31] * t1306;
        t1351 = t1349 - t1350;
        t1353 = t1302 * t1334 + t1310 * t1351;
        t1354 = speeds[0] * t1304;
        t1357 = self.constants[7] * speeds[0];
        t1358 = t1304 * t1357;
        t1359 = self.constants[7] * t1354 + t1358;
        t1362 = t298 - t1301;
        t1364 = t1320 * t1362 - speeds[0] * t1357;
        t1368 = t12 * t1359 + t7 * t1364 - t1353 - self.constants[31] * t1354;
        t1370 = speeds[1] + t1310;
        t1374 = cos_delta * t1302 - sin_delta * t1306;
        t1375 = self.constants[38] * t1374;
        t1379 = cos_delta * t1306 + sin_delta * t1302;
        t1380 = self.constants[37] * t1374;
        t1385 = speeds[1] * t1374;
        t1387 = t1385 - cos_delta * t1342 - sin_delta * t1354;
        t1389 = t30 * self.constants[8];
        t1394 = speeds[0] * t1043 + speeds[1] * t1029 + speeds[3] * t1035;
        t1396 = t1339 + t1379 * t1394;
        t1398 = t27 * self.constants[8];
        t1400 = t1387 - t1370 * t1394;
        t1402 = t26 * t40;
        t1405 = t30 * t1379 + t27 * t1370;
        t1406 = t1402 * t1405;
        t1407 = t27 * t1406;
        t1408 = self.constants[8] * t1407;
        t1410 = t30 * t1406;
        t1411 = self.constants[8] * t1410;
        t1417 = cos_delta * t1346 + t1370 * t1375 + t1379 * t1380
            + self.constants[37] * t1339 + t1389 * t1396 + t1370 * t1408;
        t1421 = t1417 + t1379 * t1411 - sin_delta * t1368 - self.constants[38] * t1387
            - t1398 * t1400;
        t1426 = self.constants[37] * t1370;
        t1427 = self.constants[38] * t1379;
        t1428 = t1426 - t1427;
        t1432 = speeds[1] * t1379;
        t1434 = sin_delta * t1342 - cos_delta * t1354 - t1432;
        t1437 = t1374 + t1394;
        t1441 = t30 * t1370 - t27 * t1379;
        t1442 = self.constants[8] * t1441;
        t1448 = cos_delta * t1368 + sin_delta * t1346 + self.constants[38] * t1434
            + t1398 * t1434 - t1374 * t1380 - t1370 * t1428;
        t1450 = t1448 - t1411 * t1437 - t1370 * t1442;
        t1454 = t1306 * t1351 - t1302 * t1332;
        t1468 = t1454 + self.constants[30] * t1354 + t7 * t1359 + t1379 * t1428
            + t1379 * t1442 - t12 * t1364;
        t1472 = t1468 - t1374 * t1375 - self.constants[37] * t1434 - t1389 * t1434
            - t1408 * t1437;
        t1474 = t30 * t1450 + t27 * t1472;
        t1479 = t53 * (t40 * t1421 + t25 * t1474);
        t1483 = t442 * (t25 * t1421 + t485 * t1479 - t40 * t1474);
        t1485 = t1331 - cos_phi * t1483;
        t1487 = t1330 + t7 * t1485;
        t1490 = t1338 + t12 * t1485;
        t1494 = self.constants[42] * t1310;
        t1495 = self.constants[45] * t1306 + t1494;
        t1497 = t1306 * t1317 - t1302 * t1495;
        t1502 = t1336 + self.constants[30] * t1490 + self.constants[31] * t1487 - t1328;
        t1505 = t1354 - t1479;
        t1506 = sin_phi * t1483 + t1505;
        t1509 = self.constants[7] * t1506 + t1358;
        t1512 = t1364 + cos_phi * self.constants[60];
        t1513 = t7 * t1512;
        t1514 = t1513 + t12 * t1509;
        t1516 = t1514 - self.constants[31] * t1506 - t1353;
        t1518 = cos_delta * t1502 - sin_delta * t1516;
        t1523 = t1385 - sin_delta * t1506 - cos_delta * t1487;
        t1528 = self.constants[52] * t1374 + self.constants[28] * t1437;
        t1531 = self.constants[51] * t1370;
        t1532 = self.constants[50] * t1379 + t1531;
        t1534 = t1379 * t1528 - t1374 * t1532;
        t1537 = self.constants[48] * t1518 + self.constants[51] * t1523
            + self.constants[53] * t1490 + t1534;
        t1538 = self.constants[32] * t1302;
        t1540 = self.constants[32] * t1310;
        t1541 = self.constants[33] * t1306;
        t1542 = t1540 + t1541;
        t1544 = t1302 * t1538 + t1310 * t1542;
        t1547 = t1514 + t1544 - self.constants[33] * t1506;
        t1549 = self.constants[33] * t1302;
        t1552 = t1310 * t1549 - t1306 * t1538;
        t1557 = t1552 + self.constants[33] * t1487 - t1328 - self.constants[32] * t1490;
        t1561 = t1306 * t1542 + t1302 * t1549;
        t1563 = t12 * t1512;
        t1565 = t1563 - t7 * t1509;
        t1567 = self.constants[32] * t1506 + t1561 + t1565;
        t1570 = cos_theta * t1557 - t1120 * t1567 - t1081 * t1547;
        t1577 = cos_theta * t1302 + t1120 * t1310 - t1081 * t1306;
        t1578 = speeds[2] * t1577;
        t1579 = self.constants[2] * t1578;
        t1585 = t1579 - t1081 * t1506 + t1075 * t1490 - t1071 * t1487;
        t1587 = self.constants[3] * t1578;
        t1593 = t1098 * t1490 - t1587 - t1075 * t1487 + t1120 * t1506;
        t1598 = self.constants[3] * speeds[2];
        t1601 = t1071 * t1306 + t1081 * t1302 + t1075 * t1310 + t1598;
        t1602 = self.constants[57] * t1601;
        t1606 = self.constants[2] * speeds[2];
        t1609 = t1075 * t1306 + t1098 * t1310 + t1606 - t1120 * t1302;
        t1611 = t1602 + self.constants[59] * t1609;
        t1613 = self.constants[58] * t1577;
        t1615 = t1577 * t1611 - t1609 * t1613;
        t1618 = self.constants[56] * t1585 + self.constants[57] * t1593 + t1615
            - self.constants[55] * t1570;
        t1624 = t1071 * t1547 + t1081 * t1557 - t1075 * t1567;
        t1630 = t1075 * t1547 - t1098 * t1567 - t1120 * t1557;
        t1635 = speeds[2] * (self.constants[3] * t1609 - self.constants[2] * t1601);
        t1641 = t1635 + t1081 * t1487 - cos_theta * t1506 + t1120 * t1490;
        t1644 = self.constants[57] * t1609;
        t1645 = self.constants[56] * t1601 + t1644;
        t1648 = t1609 * t1645 - t1601 * t1611;
        t1651 = self.constants[55] * t1624 + self.constants[58] * t1641 + t1648
            - self.constants[54] * t1630;
        t1658 = t1601 * t1613 - t1577 * t1645;
        t1661 = self.constants[54] * t1570 + self.constants[57] * t1585
            + self.constants[59] * t1593 + t1658;
        t1666 = self.constants[54] * t1577;
        t1668 = self.constants[54] * t1609;
        t1669 = self.constants[55] * t1601;
        let (
            t1670, t1672, t1674, t1679, t1682, t1685, t1691, t1693, t1696, t1701, t1707, t1709,
            t1711, t1712, t1713, t1715, t1717, t1722, t1725, t1728, t1730, t1736, t1740, t1752,
            t1754, t1757, t1760, t1765, t1775, t1777, t1780, t1784, t1791, t1796, t1802, t1804,
            t1806, t1812, t1818, t1826, t1832, t1838, t1844, t1846, t1851, t1852, t1853, t1856,
            t1866, t1872, t1874, t1879, t1884, t1887, t1891, t1898, t1899, t1901, t1906, t1908,
            t1910, t1911, t1912, t1916, t1920, t1924, t1929, t1930, t1936, t1940, t1945, t1947,
            t1949, t1955, t1957, t1958, t1968, t1971, t1973, t1978, t1983, t1986, t1988, t1992,
            t1993, t1998, t1999, t2001, t2012, t2016, t2018, t2020, t2023, t2024, t2038, t2039,
            t2041, t2043, t2049, t2053, t2058, t2060, t2064, t2065, t2071, t2072, t2085, t2088,
            t2094, t2105, t2114, t2126, t2131, t2132, t2134, t2138, t2144, t2145, t2148, t2156,
            t2158, t2161, t2166, t2173, t2175, t2177, t2179, t2181, t2187, t2191, t2193, t2196,
            t2205, t2214, t2218, t2224, t2230, t2237, t2241, t2248, t2250, t2253, t2255, t2260,
            t2262, t2265, t2268, t2274, t2278, t2280, t2285, t2287, t2291, t2295, t2299, t2304,
            t2312, t2313, t2317, t2322, t2329, t2331, t2337, t2342, t2349, t2352, t2356, t2357,
            t2375, t2380, t2381, t2383, t2384, t2386, t2388, t2389, t2391, t2392, t2394, t2397,
            t2400, t2402, t2403, t2406, t2408, t2410, t2414, t2416, t2418, t2420, t2422, t2423,
            t2424, t2428, t2433, t2435, t2437, t2440, t2441, t2445, t2450, t2455, t2457, t2460,
            t2463, t2467, t2469, t2473, t2477, t2478, t2482, t2484, t2485, t2487, t2490, t2492,
            t2494, t2499, t2500, t2501, t2503, t2506, t2509, t2513, t2516, t2520, t2523, t2527,
            t2529, t2532, t2535, t2539, t2541, t2544, t2546, t2547, t2549, t2551, t2553, t2559,
            t2561, t2564, t2567, t2569, t2575, t2577, t2579, t2584, t2594, t2600,
        );
        t1670 = t1668 - t1669;
        t1672 = t1577 * t1666 + t1609 * t1670;
        t1674 = t1624 * self.constants[24] + self.constants[55] * t1641 - t1672;
        t1679 = self.constants[55] * t1577;
        t1682 = t1609 * t1679 + t1601 * t1666;
        t1685 = t1570 * self.constants[24] + self.constants[54] * t1593 + t1682
            - self.constants[55] * t1585;
        t1691 = t1601 * t1670 - t1577 * t1679;
        t1693 = t1630 * self.constants[24] + t1691 - self.constants[54] * t1641;
        t1696 = t1081 * t1674 + cos_theta * t1685 - t1120 * t1693;
        t1701 = cos_delta * t1516 + sin_delta * t1502;
        t1707 = sin_delta * t1487 - cos_delta * t1506 - t1432;
        t1709 = self.constants[48] * t1374;
        t1711 = self.constants[48] * t1370;
        t1712 = t1379 * self.constants[49];
        t1713 = t1711 - t1712;
        t1715 = t1374 * t1709 + t1370 * t1713;
        t1717 = self.constants[47] * t1701 + self.constants[49] * t1707 - t1715;
        t1722 = t1374 * self.constants[49];
        t1725 = t1370 * t1722 + t1379 * t1709;
        t1728 = t1518 * self.constants[47] + self.constants[48] * t1490 + t1725
            - t1523 * self.constants[49];
        t1730 = sin_delta * t1717 + cos_delta * t1728;
        t1736 = self.constants[46] * t1490 + t1497 + t1537 + t1075 * t1618
            + t1120 * t1651 + t1098 * t1661;
        t1740 = t1736 + self.constants[30] * t1730 - self.constants[40] * t1328
            - self.constants[42] * t1487 - self.constants[32] * t1696;
        t1752 = self.constants[51] * t1379;
        t1754 = t1752 + self.constants[53] * t1370;
        t1757 = t1374 * t1754 - t1370 * t1528;
        t1760 = self.constants[50] * t1523 + self.constants[51] * t1490 + t1757
            - t1518 * self.constants[49];
        t1765 = t1454 - t1565 + self.constants[30] * t1506;
        t1775 = t775 * (t30 * t1472 + t796 * t1483 - t27 * t1450 - t804 * t1479);
        t1777 = self.constants[28] * (t1707 + t1775);
        t1780 = t1370 * t1532 - t1379 * t1754;
        t1784 = t1701 * self.constants[49] + self.constants[52] * t1707 + t1777 + t1780
            - self.constants[48] * t1765;
        t1791 = t1319 + self.constants[41] * t1328 + self.constants[42] * t1490
            + t1071 * t1618 + t1075 * t1661 + cos_delta * t1760;
        t1796 = t1791 - self.constants[45] * t1487 - t1081 * t1651
            - self.constants[33] * t1696 - sin_delta * t1784
            - self.constants[31] * t1730;
        t1802 = self.constants[41] * t1302;
        t1804 = self.constants[40] * t1302;
        t1806 = t1310 * t1802 + t1306 * t1804;
        t1812 = self.constants[7]
            * (t1696 + t1730 + self.constants[40] * t1490 + self.constants[41] * t1487
                + t1806 - t1328 * self.constants[44]);
        t1818 = t1310 * t1495 - t1306 * t1312;
        t1826 = t1071 * t1674 + t1075 * t1693 - t1081 * t1685;
        t1832 = t1075 * t1674 + t1120 * t1685 + t1098 * t1693;
        t1838 = cos_delta * t1717 - sin_delta * t1728;
        t1844 = t1379 * t1713 - t1374 * t1722;
        t1846 = self.constants[47] * t1765 + t1844 - self.constants[48] * t1707;
        t1851 = self.constants[40] * t1310;
        t1852 = self.constants[41] * t1306;
        t1853 = t1851 - t1852;
        t1856 = t1306 * t1853 - t1302 * t1802;
        t1866 = t1302 * t1804 + t1310 * t1853;
        t1872 = t7
            * (t1832 + t1846 + t1856 - t1565 * self.constants[44]
                + self.constants[40] * t1506)
            + t12
                * (t1826 + t1838 + t1514 * self.constants[44]
                    - self.constants[41] * t1506 - t1866);
        t1874 = self.constants[27] * t1506 + self.constants[7] * t1872;
        t1879 = self.constants[41] * t1514 + self.constants[40] * t1565
            - self.constants[43] * t1506 + t1818 + t1081 * t1618 + cos_theta * t1651;
        t1884 = t1879 + self.constants[33] * t1826 + self.constants[32] * t1832
            + sin_delta * t1760 + cos_delta * t1784 + self.constants[31] * t1838;
        t1887 = t1884 - t1874 - t1120 * t1661 - self.constants[30] * t1846;
        t1891 = t12 * t1740 - t7 * t1796;
        t1898 = forces[0] + t1242 * t1891 - t7 * t1740 - t12 * t1796 - t1812
            - t1231 * t1887;
        t1899 = t1898 - t1043 * t1777;
        t1901 = self.constants[53] + t1135;
        t1906 = t135 - sin_phi * t513;
        t1908 = cos_phi * t513;
        t1910 = t12 * self.constants[7];
        t1911 = t1202 * t1910;
        t1912 = t1204 + t1911;
        t1916 = t1912 + t1256 * t1906 - t1263 * t1908;
        t1920 = t12 * t1901 - t7 * t1161;
        t1924 = t1920 + t1263 * t1906 - t1269 * t1908;
        t1929 = cos_delta * t1906 - t1279 * t1908;
        t1930 = t1029 + t1929;
        t1936 = t7 * t1901 + t12 * t1161 + self.constants[7] * t1134 + t1229 * t1906
            + t1231 * t1916 + t1275 * t1906;
        t1940 = t1295 * (t1936 + t1285 * t1930 - t1241 * t1908 - t1242 * t1924);
        t1945 = self.constants[27] * t1906;
        t1947 = self.constants[28] * t1930;
        t1949 = t1294 * t1940;
        t1955 = self.constants[53] + t1906 * t1916 + t1906 * t1912 + t1906 * t1945
            + t1930 * t1947 - t1908 * t1924;
        t1957 = t1955 - t1908 * t1920 - t1940 * t1949;
        t1958 = self.constants[0].like(1.0) / t1957;
        t1968 = forces[1] + t1891 * t1908 - t1537 - t1887 * t1906 - t1029 * t1777
            - t1899 * t1940;
        t1971 = t1081 * self.constants[75];
        t1973 = t1120 * self.constants[75];
        t1978 = self.constants[7] * (t7 * t1973 - t12 * t1971);
        t1983 = t1081 * self.constants[76] - t1120 * self.constants[77];
        t1986 = self.constants[32] * t1973 + t1983 - self.constants[33] * t1971 - t1978;
        t1988 = cos_theta * self.constants[75];
        t1992 = t1075 * self.constants[76] + t1098 * self.constants[77];
        t1993 = t1992 - self.constants[32] * t1988;
        t1998 = t1071 * self.constants[76] + t1075 * self.constants[77];
        t1999 = t1998 - self.constants[33] * t1988;
        t2001 = t12 * t1993 - t7 * t1999;
        t2012 = t1295
            * (t7 * t1993 + t12 * t1999 + self.constants[7] * t1988 + t1231 * t1986
                - t1242 * t2001);
        t2016 = t1958 * (t1906 * t1986 - t1908 * t2001 - t1949 * t2012);
        t2018 = t1294 * t2012;
        t2020 = t1957 * t2016;
        t2023 = self.constants[78] - t2012 * t2018 - t2016 * t2020;
        t2024 = self.constants[0].like(1.0) / t2023;
        t2038 = forces[2] - self.constants[3] * t1618 - self.constants[2] * t1661
            - positions[6] * self.constants[5] - speeds[2] * self.constants[6]
            - t1899 * t2012;
        t2039 = t2038 - t1968 * t2016;
        t2041 = sin_phi * t505;
        t2043 = cos_phi * t505;
        t2049 = self.constants[7] * (t1189 - self.constants[73]);
        t2053 = t2049 + t1256 * t2041 + t1263 * t2043;
        t2058 = t1261 - t1263 * t2041 - t1269 * t2043;
        t2060 = self.constants[0].like(1.0) - t2041;
        t2064 = cos_delta * t2041 + t1279 * t2043;
        t2065 = t1035 - t2064;
        t2071 = t1275 * t2060 + t1285 * t2065 - t1229 * t2041 - t1241 * t2043
            - t1231 * t2053 - t1242 * t2058;
        t2072 = t1295 * t2071;
        t2085 = t1911 + t1945 * t2060 + t1947 * t2065 - t1906 * t2053 - t1908 * t2058
            - t1912 * t2041;
        t2088 = t1958 * (t2085 - t1920 * t2043 - t1949 * t2072);
        t2094 = t2024
            * (t1978 + t1986 * t2041 + t2001 * t2043 + t2018 * t2072 + t2020 * t2088);
        t2105 = t1887 * t2041 + t1891 * t2043 + t2039 * t2094 + t1874 - t1035 * t1777
            - t1899 * t2072;
        t2114 = self.constants[28] * t2065;
        t2126 = t2041 * t2053 + t2041 * t2049 + self.constants[79]
            + self.constants[27] * t2060 * t2060 + t2065 * t2114 - t2043 * t2058;
        t2131 = self.constants[0].like(1.0)
            / (t2126 - t1261 * t2043 - t1294 * t2072 * t2072 - t1957 * t2088 * t2088
                - t2023 * t2094 * t2094);
        t2132 = (t2105 - t1968 * t2088) * t2131;
        t2134 = t2024 * t2039 + t2094 * t2132;
        t2138 = t1958 * t1968 - t2016 * t2134 - t2088 * t2132;
        t2144 = t1295 * t1899 - t1940 * t2138 - t2012 * t2134 - t2072 * t2132;
        t2145 = t1324 + t2144;
        t2148 = t1321 + t1323 - self.constants[7] * t2145;
        t2156 = t1483 + t516 * t2144 + t513 * t2138 + t505 * t2132;
        t2158 = t1331 - cos_phi * t2156;
        t2161 = t12 * t2144 - t1330 - t7 * t2158;
        t2166 = t1338 + t12 * t2158 + t7 * t2144;
        t2173 = t141 * t2144 + t135 * t2138 - sin_phi * t2156 - t1505;
        t2175 = t2132 + t2173;
        t2177 = self.constants[7] * t2175 - t1358;
        t2179 = t1513 - t12 * t2177;
        t2181 = t1544 + self.constants[33] * t2173 + t2179;
        t2187 = t1552 - t2148 - self.constants[32] * t2166 - self.constants[33] * t2161;
        t2191 = t1563 + t7 * t2177;
        t2193 = self.constants[32] * t2173 - t1561 - t2191;
        t2196 = cos_theta * t2187 + t1120 * t2193 - t1081 * t2181;
        t2205 = t1579 + t1071 * t2161 + t1081 * t2173 + t1075 * t2166
            + self.constants[3] * t2134;
        t2214 = t1075 * t2161 + t1098 * t2166 + self.constants[2] * t2134 - t1587
            - t1120 * t2173;
        t2218 = t1615 + self.constants[56] * t2205 + self.constants[57] * t2214
            - self.constants[55] * t2196;
        t2224 = t1071 * t2181 + t1081 * t2187 + t1075 * t2193;
        t2230 = t1075 * t2181 + t1098 * t2193 - t1120 * t2187;
        t2237 = t1635 + cos_theta * t2173 + t1120 * t2166 - t1081 * t2161;
        t2241 = t1648 + self.constants[55] * t2224 + self.constants[58] * t2237
            - self.constants[54] * t2230;
        t2248 = t1658 + self.constants[54] * t2196 + self.constants[57] * t2205
            + self.constants[59] * t2214;
        t2250 = self.constants[24] * t2224;
        t2253 = t2250 + self.constants[55] * t2237 - t1672;
        t2255 = self.constants[24] * t2196;
        t2260 = t1682 + t2255 + self.constants[54] * t2214 - self.constants[55] * t2205;
        t2262 = self.constants[24] * t2230;
        t2265 = t1691 + t2262 - self.constants[54] * t2237;
        t2268 = t1081 * t2253 + cos_theta * t2260 - t1120 * t2265;
        t2274 = t1336 + self.constants[30] * t2166 - t2148 - self.constants[31] * t2161;
        t2278 = t2179 + self.constants[31] * t2173 - t1353;
        t2280 = cos_delta * t2274 - sin_delta * t2278;
        t2285 = t1385 + cos_delta * t2161 + sin_delta * t2173;
        t2287 = t2138 + t2166;
        t2291 = t1757 + self.constants[50] * t2285 + self.constants[51] * t2287
            - self.constants[49] * t2280;
        t2295 = cos_delta * t2278 + sin_delta * t2274;
        t2299 = t1454 - t2191 - self.constants[30] * t2173;
        t2304 = cos_delta * t2173 - t1432 - sin_delta * t2161;
        t2312 = t1775 + t2304 + t1043 * t2144 + t1029 * t2138 + t1035 * t2132;
        t2313 = self.constants[28] * t2312;
        t2317 = t1780 + self.constants[49] * t2295 + self.constants[52] * t2304 + t2313
            - self.constants[48] * t2299;
        t2322 = self.constants[47] * t2295 + self.constants[49] * t2304 - t1715;
        t2329 = t1725 + self.constants[47] * t2280 + self.constants[48] * t2287
            - self.constants[49] * t2285;
        t2331 = sin_delta * t2322 + cos_delta * t2329;
        t2337 = t1319 + self.constants[41] * t2148 + self.constants[45] * t2161
            + self.constants[42] * t2166 + t1071 * t2218 + t1075 * t2248;
        t2342 = t2337 + cos_delta * t2291 - t1081 * t2241 - self.constants[33] * t2268
            - sin_delta * t2317 - self.constants[31] * t2331;
        t2349 = t1071 * t2253 + t1075 * t2265 - t1081 * t2260;
        t2352 = cos_delta * t2322 - sin_delta * t2329;
        t2356 = self.constants[44] * t2179 + self.constants[41] * t2173 + t2349 + t2352
            - t1866;
        t2357 = self.constants[7] * t2356;
        t2375 = t1497 + t1534 + self.constants[42] * t2161 + self.constants[46] * t2166
            + self.constants[48] * t2280 + self.constants[51] * t2285
            + self.constants[53] * t2287;
        t2380 = t2375 + t1075 * t2218 + t1120 * t2241 + t1098 * t2248
            + self.constants[30] * t2331 - self.constants[40] * t2148;
        t2381 = t2380 - self.constants[32] * t2268;
        t2383 = t775 * self.constants[28];
        t2384 = t1472 * t2383;
        t2386 = t1450 * t2383;
        t2388 = t796 * t2383;
        t2389 = t442 * t1421;
        t2391 = t40 * t442;
        t2392 = t1450 * t2391;
        t2394 = t1472 * t2391;
        t2397 = t86 * t2389 + t87 * t2392 - t93 * t2394;
        t2400 = t2388 * t2397 - t87 * t2384 - t93 * t2386;
        t2402 = self.constants[44] * t1910;
        t2403 = self.constants[41] - t2402;
        t2406 = t12 * t1242 - t7;
        t2408 = cos_delta * self.constants[49];
        t2410 = sin_delta * self.constants[49];
        t2414 = t89 + t107 * t1242 + sin_delta * t1231;
        t2416 = sin_delta * self.constants[47];
        t2418 = cos_delta * self.constants[30];
        t2420 = cos_delta * self.constants[31];
        t2422 = sin_delta * self.constants[31];
        t2423 = self.constants[7] * t1277;
        t2424 = t2423 - t2422;
        t2428 = t12 * t2418 + t7 * t2420;
        t2433 = t12 * t2420 + t1242 * t2428 - cos_delta * self.constants[7] - t7 * t2418
            - t1231 * t2424;
        t2435 = cos_delta * self.constants[47];
        t2437 = sin_delta * self.constants[30];
        t2440 = self.constants[7] * t89;
        t2441 = t2420 - t2440;
        t2445 = t12 * t2437 + t7 * t2422;
        t2450 = t12 * t2422 + t1242 * t2445 - sin_delta * self.constants[7] - t7 * t2437
            - t1231 * t2441;
        t2455 = t2435 * t2450 - t1202 * t2406 - t1282 * t2408 - t2410 * t2414
            - t2416 * t2433;
        t2457 = t1071 * self.constants[55] - t1095;
        t2460 = t7 * t1120 - t12 * t1081;
        t2463 = t7 * t1081 + t12 * t1120;
        t2467 = t1242 * t2463 - t2460 - cos_theta * t1231;
        t2469 = t1075 * self.constants[24];
        t2473 = t12 * self.constants[33] + t7 * self.constants[32] - self.constants[7];
        t2477 = t7 * self.constants[33] - t12 * self.constants[32];
        t2478 = t1120 * t2477;
        t2482 = t12 * t1075;
        t2484 = t2482 + t7 * t1098;
        t2485 = self.constants[7] * t2484;
        t2487 = t1075 * self.constants[33] + t1098 * self.constants[32] - t2485;
        t2490 = t1120 * t2473 + t1242 * t2478 + t1231 * t2487;
        t2492 = t1071 * self.constants[24];
        t2494 = t1081 * t2477;
        t2499 = t7 * t1075;
        t2500 = t12 * t1071 + t2499;
        t2501 = self.constants[7] * t2500;
        t2503 = t1071 * self.constants[33] + t1075 * self.constants[32] - t2501;
        t2506 = t1081 * t2473 + t1242 * t2494 - t1231 * t2503;
        t2509 = t12 * t1098 - t2499;
        t2513 = t1242 * t2509 + t1120 * t1231 - t2484;
        t2516 = t2482 - t7 * t1071;
        t2520 = t1242 * t2516 - t2500 - t1081 * t1231;
        t2523 = cos_theta * t2477;
        t2527 = self.constants[7] * t2460;
        t2529 = t1120 * self.constants[32] - t1081 * self.constants[33] - t2527;
        t2532 = cos_theta * t2473 + t1242 * t2523 - t1231 * t2529;
        t2535 = self.constants[54] * t2513 + self.constants[24] * t2532
            - self.constants[55] * t2520;
        t2539 = t2457 * t2467 + t2492 * t2506 - t2469 * t2490 - t1081 * t2535;
        t2541 = t2455 + t2539 - t1231 * t2403;
        t2544 = t7 * self.constants[47];
        t2546 = self.constants[7] * (t7 * self.constants[44] + t2544);
        t2547 = t1184 + t2546;
        t2549 = self.constants[48] * t1282;
        t2551 = t1130 - self.constants[54] * t1098;
        t2553 = t1098 * self.constants[24];
        t2559 = t2467 * t2551 + t2469 * t2506 + t1120 * t2535 - t2490 * t2553;
        t2561 = t1231 * t2547 + t2549 + t2559;
        t2564 = t12 * self.constants[42];
        t2567 = t7 * self.constants[42];
        t2569 = t12 * self.constants[46] - t2567;
        t2575 = t1081 * self.constants[55] + self.constants[54] * t1120;
        t2577 = t1120 * self.constants[24];
        t2579 = t1081 * self.constants[24];
        t2584 = t2467 * t2575 + t2490 * t2577 + t2506 * t2579 + cos_theta * t2535;
        t2594 = t1134 * t2406 + t2408 * t2414 + t2433 * t2435 + t2416 * t2450
            - t1282 * t2410;
        t2600 = self.constants[59] * t2513 + self.constants[57] * t2520
            + self.constants[54] * t2532;
        let (
            t2606, t2612, t2618, t2623, t2624, t2629, t2636, t2637, t2638, t2639, t2645, t2651,
            t2657, t2662, t2664, t2666, t2669, t2673, t2675, t2677, t2692, t2696, t2702, t2704,
            t2706, t2707, t2709, t2712, t2715, t2723, t2725, t2726, t2728, t2730, t2731, t2732,
            t2734, t2737, t2739, t2741, t2744, t2747, t2749, t2752, t2756, t2760, t2765, t2766,
            t2767, t2770, t2773, t2778, t2781, t2785, t2787, t2789, t2792, t2795, t2797, t2798,
            t2800, t2802, t2805, t2806, t2808, t2809, t2810, t2811, t2812, t2815, t2818, t2819,
            t2821, t2823, t2825, t2828, t2830, t2832, t2834, t2841, t2845, t2847, t2849, t2852,
            t2854, t2858, t2859, t2862, t2864, t2866, t2868, t2869, t2870, t2873, t2876, t2878,
            t2880, t2883, t2886, t2888, t2890, t2893, t2894, t2898, t2901, t2903, t2908, t2910,
            t2911, t2916, t2919, t2920, t2925, t2929, t2931, t2934, t2938, t2940, t2941, t2943,
            t2944, t2945, t2948, t2950, t2954, t2957, t2959, t2962, t2969, t2970, t2973, t2977,
            t2980, t2983, t2990, t2991, t2994, t2997, t2999, t3001, t3003, t3011, t3012, t3018,
            t3023, t3028, t3034, t3038, t3042, t3049, t3054, t3058, t3061, t3065, t3068, t3071,
            t3073, t3076, t3079, t3082, t3089, t3097, t3099, t3101, t3103, t3108, t3111, t3114,
            t3123, t3128, t3133, t3138, t3142, t3144, t3146, t3148, t3155, t3157, t3159, t3160,
            t3163, t3167, t3168, t3170, t3172, t3177, t3181, t3186, t3188, t3190, t3192, t3199,
            t3201, t3204, t3213, t3216, t3220, t3226, t3230, t3239, t3245, t3248, t3252, t3256,
            t3265, t3266, t3270, t3272, t3276, t3280, t3284, t3286, t3288, t3290, t3292, t3294,
            t3300, t3308, t3316, t3318, t3320, t3329, t3334, t3339, t3344, t3348, t3356, t3361,
            t3364, t3368, t3374, t3376, t3377, t3379, t3381, t3383, t3386, t3389, t3391, t3392,
            t3394, t3395, t3397, t3407, t3412, t3414, t3420, t3426, t3428, t3432,
        );
        t2606 = self.constants[58] * t2467 + self.constants[54] * t2490
            + self.constants[55] * t2506;
        t2612 = self.constants[57] * t2513 + self.constants[56] * t2520
            - self.constants[55] * t2532;
        t2618 = self.constants[53] * t2406 + t1242 * t2569 + self.constants[48] * t2433
            + self.constants[30] * t2594 + t1098 * t2600 + t1120 * t2606;
        t2623 = t2618 + t1075 * t2612 - self.constants[7] * self.constants[40] - t2564
            - t7 * self.constants[46] - self.constants[51] * t2414;
        t2624 = t2623 - self.constants[32] * t2584;
        t2629 = t2564 - t7 * self.constants[45];
        t2636 = self.constants[30] * self.constants[48];
        t2637 = t7 * self.constants[7];
        t2638 = self.constants[48] * t2637;
        t2639 = t2636 + t2638;
        t2645 = self.constants[49] * t2450 - t1285 - t1231 * t2639
            - self.constants[52] * t1282;
        t2651 = self.constants[51] * t2406 - self.constants[50] * t2414
            - self.constants[49] * t2433;
        t2657 = self.constants[7] * self.constants[41] + t1242 * t2629 + t1075 * t2600
            + t1071 * t2612 + cos_delta * t2651 - t2567;
        t2662 = t2657 - t12 * self.constants[45] - self.constants[33] * t2584
            - self.constants[31] * t2594 - t1081 * t2606 - sin_delta * t2645;
        t2664 = t12 * t139;
        t2666 = t7 * t139;
        t2669 = self.constants[43] + self.constants[27];
        t2673 = t12 * self.constants[41] - t7 * self.constants[40];
        t2675 = self.constants[7] * (t2673 - t7 * self.constants[67]);
        t2677 = self.constants[71] + t2669 - t2675;
        t2692 = self.constants[32] * t2559 + self.constants[33] * t2539
            + self.constants[31] * t2455 + cos_theta * t2606 + t1081 * t2612
            + cos_delta * t2645;
        t2696 = t2692 + sin_delta * t2651 - t1231 * t2677 - t1282 * t2636
            - t1120 * t2600;
        t2702 = t2541 * t2664 + t2561 * t2666 + t16 * t2662 - t13 * t2624
            - sin_phi * t2696;
        t2704 = t53 * t1474;
        t2706 = t25 * t53;
        t2707 = t1450 * t2706;
        t2709 = t1472 * t2706;
        t2712 = t86 * t2704 + t93 * t2709 - t87 * t2707;
        t2715 = t486 * t2388 - t804 * t2383;
        t2723 = t2696 + t486 * t2702 - t1283 * t2715 - t1910 * t2541 - t2561 * t2637;
        t2725 = self.constants[8] * t1434;
        t2726 = self.constants[8] * t1370;
        t2728 = t1379 * t2726 - t2725;
        t2730 = self.constants[8] * t1406;
        t2731 = t1437 * t2730;
        t2732 = self.constants[8] * t1379;
        t2734 = t2731 + t1379 * t2732;
        t2737 = t1364 + t87 * t2728 + t93 * t2734;
        t2739 = t27 * t2391;
        t2741 = t30 * t2383 - t2388 * t2739;
        t2744 = t27 * t2706;
        t2747 = t2723 * t2744 - t1283 * t2741 - t2702 * t2739;
        t2749 = self.constants[37] + t1389;
        t2752 = self.constants[30] * t1331;
        t2756 = self.constants[8] * t1396 + t1379 * t2730;
        t2760 = t1370 * t2730 - self.constants[8] * t1400;
        t2765 = t1331 * t2749 + cos_delta * t2752 + t93 * t2760 - sin_delta * t1359
            - t87 * t2756;
        t2766 = t25 * t442;
        t2767 = t2388 * t2766;
        t2770 = t40 * t53;
        t2773 = t2702 * t2766 + t2723 * t2770 - t1283 * t2767;
        t2778 = t2731 + t1370 * t2726;
        t2781 = t2725 + t1370 * t2732;
        t2785 = cos_delta * t1359 + sin_delta * t2752 + t87 * t2778 + t93 * t2781;
        t2787 = t30 * t2391;
        t2789 = t27 * t2383 + t2388 * t2787;
        t2792 = t30 * t2706;
        t2795 = t1283 * t2789 + t2723 * t2792 - t2702 * t2787;
        t2797 = t26 * t1405;
        t2798 = t1402 * t2797;
        t2800 = t1379 * t1402;
        t2802 = t1370 * t1402;
        t2805 = t93 * t2802 - t86 * t2798 - t87 * t2800;
        t2806 = t1398 * t1437;
        t2808 = t1370 * t1398;
        t2809 = t1379 * t1389;
        t2810 = t2808 + t2809;
        t2811 = t2773 * t2810;
        t2812 = t1389 * t1437;
        t2815 = t2811 - t2747 * t2806 - t2795 * t2812;
        t2818 = self.constants[42] * t1302;
        t2819 = t12 * t2818;
        t2821 = t1317 - self.constants[45] * t1302;
        t2823 = t7 * t2818;
        t2825 = t12 * t2821 - t2823;
        t2828 = t1722 + t1722;
        t2830 = t1713 - t1712;
        t2832 = sin_delta * t2828 + cos_delta * t2830;
        t2834 = self.constants[41] * t1310;
        t2841 = self.constants[7] * (t12 * t2834 + t7 * (t1853 - t1852) + t7 * t2832);
        t2845 = self.constants[45] * t1310 - t1307 - t1312 - self.constants[30] * t2832
            - t2841;
        t2847 = self.constants[52] + self.constants[28];
        t2849 = t1379 * t2847 - t1532;
        t2852 = t1528 - self.constants[50] * t1374;
        t2854 = cos_delta * t2852 - sin_delta * t2849;
        t2858 = self.constants[50] * t1370 - t1752 - t1754;
        t2859 = cos_delta * t2858;
        t2862 = t1754 - t1370 * t2847;
        t2864 = self.constants[51] * t1374;
        t2866 = cos_delta * t2864 - sin_delta * t2862;
        t2868 = t1370 * self.constants[49];
        t2869 = self.constants[48] * t1379;
        t2870 = t2868 + t2869;
        t2873 = cos_delta * t1709 - sin_delta * t2870;
        t2876 = t1709 + t1709;
        t2878 = cos_delta * t2868 + sin_delta * t2876;
        t2880 = t1541 + t1542;
        t2883 = self.constants[33] * t1310;
        t2886 = self.constants[31] * t1310;
        t2888 = cos_delta * speeds[1];
        t2890 = sin_delta * speeds[1];
        t2893 = t1375 + t1408;
        t2894 = t1375 + t2893;
        t2898 = t1428 + t1442;
        t2901 = speeds[1] * t2749 + t2898 - t1427 - t1379 * t1398;
        t2903 = sin_delta * t2894 + cos_delta * t2901;
        t2908 = t1334 + self.constants[30] * t297;
        t2910 = t1370 * self.constants[38];
        t2911 = self.constants[37] * t1379;
        t2916 = t2910 + t2911 - speeds[1] * self.constants[38] - speeds[1] * t1398;
        t2919 = t1380 + t1411;
        t2920 = t1389 * t1394 + t2919;
        t2925 = t297 * t2749 + cos_delta * t2908 + cos_delta * t2920 - sin_delta * t2886
            - sin_delta * t2916;
        t2929 = t1380 + t2919;
        t2931 = self.constants[38] + t1398;
        t2934 = t2808 + t2910 - speeds[1] * t2931;
        t2938 = cos_delta * t2886 + sin_delta * t2908 + sin_delta * t2929
            + cos_delta * t2934;
        t2940 = t30 * t1402;
        t2941 = cos_delta * t2940;
        t2943 = t1351 - t1350;
        t2944 = self.constants[7] * t2544;
        t2945 = self.constants[67] + t2944;
        t2948 = t2549 + t2747 + t1231 * t2945;
        t2950 = self.constants[57] * t1577;
        t2954 = t1644 + t1645 - self.constants[59] * t1601;
        t2957 = self.constants[59] * t1577 - t1613;
        t2959 = self.constants[54] * t1601;
        t2962 = t1668 + t1670;
        t2969 = t2467 * t2954 + t2520 * t2957 + t1679 * t2532 + t1598 * t2606
            - t2513 * t2950 - t2490 * t2959;
        t2970 = t2969 - t2506 * t2962;
        t2973 = t1613 - self.constants[56] * t1577;
        t2977 = self.constants[56] * t1609 - t1602 - t1611;
        t2980 = t1670 - t1669;
        t2983 = self.constants[55] * t1609;
        t2990 = t2513 * t2973 + t2467 * t2977 + t2520 * t2950 + t1666 * t2532
            + t2506 * t2983 - t2490 * t2980;
        t2991 = t2990 - t1606 * t2606;
        t2994 = self.constants[58] * t1601 - t1645;
        t2997 = t1611 - self.constants[58] * t1609;
        t2999 = t1679 + t1679;
        t3001 = t2959 + t2983;
        t3003 = t1666 + t1666;
        t3011 = t2513 * t2994 + t2520 * t2997 + t2490 * t2999 + t2532 * t3001
            + t1606 * t2612 - t2506 * t3003;
        t3012 = t3011 - t1598 * t2600;
        t3018 = t1242 * t2825 + t2406 * t2854 + t2433 * t2873 + t2450 * t2878
            + t2539 * t2883 + t1334 * t2594;
        t3023 = t3018 + t2455 * t2886 + t297 * t2624 + t2747 * t2903 + t2773 * t2925
            + t2795 * t2938;
        t3028 = t3023 + t2815 * t2941 + t2943 * t2948 + t1075 * t2970 + t1071 * t2991
            - self.constants[7] * t1804;
        t3034 = t3028 - t2819 - t7 * t2821 - t1231 * t2845 - t1282 * t2859
            - t2414 * t2866 - t2559 * t2880;
        t3038 = t3034 - t1538 * t2584 - t2645 * t2888 - t2651 * t2890 - t1081 * t3012;
        t3042 = self.constants[46] * t1302 - t1317;
        t3049 = self.constants[40] * t1306;
        t3054 = self.constants[7] * (t7 * t3049 + t7 * t2869 - t12 * (t1851 + t1853));
        t3058 = t1494 + t1495 - self.constants[46] * t1306 - self.constants[30] * t2869
            - t3054;
        t3061 = t2819 + t7 * t3042;
        t3065 = t1531 + t1532 - self.constants[53] * t1379;
        t3068 = self.constants[53] * t1374 - t1528;
        t3071 = t1711 + t1713;
        t3073 = self.constants[32] * t1306;
        t3076 = t1540 + t1542;
        t3079 = t1349 + t1351;
        t3082 = t2809 + t2911;
        t3089 = t2893 + cos_delta * t1332 + t1394 * t1398 + sin_delta * t3079;
        t3097 = sin_delta * t1332 - t1426 - t2898 - cos_delta * t3079 - t1370 * t1389;
        t3099 = t27 * t1402;
        t3101 = self.constants[30] * t1306;
        t3103 = sin_delta * t2749;
        t3108 = t2420 + cos_delta * self.constants[38] + cos_delta * t1398;
        t3111 = t2422 + sin_delta * t2931;
        t3114 = t2773 * t3108 + t2795 * t3111 - t2747 * t3103;
        t3123 = t2823 + t1722 * t2433 + t1549 * t2584 + t2539 * t3076 + t1332 * t2594
            + t2747 * t3082;
        t3128 = t3123 + t2773 * t3089 + t2795 * t3097 + t2815 * t3099 + t2948 * t3101
            + t297 * t3114;
        t3133 = t3128 + t1098 * t2970 + t1075 * t2991 + t1120 * t3012
            - self.constants[7] * t1802 - t12 * t3042;
        t3138 = t3133 - t2406 * t2864 - t1231 * t3058 - t1242 * t3061 - t1282 * t3065
            - t2414 * t3068;
        t3142 = t3138 - t2450 * t3071 - t2559 * t3073 - t2455 * t3079 - t297 * t2662;
        t3144 = self.constants[28] * t2132;
        t3146 = self.constants[28] * t1379;
        t3148 = self.constants[28] * t1370;
        t3155 = t2811 + t2406 * t3146 + t2414 * t3148 - t1408 * t2747 - t1411 * t2795;
        t3157 = speeds[3] * t3155 - t1283 * t3144;
        t3159 = self.constants[28] * t2138;
        t3160 = t775 * t3159;
        t3163 = t779 * t3155 - t1283 * t3160;
        t3167 = cos_phi * (t1357 + t1357);
        t3168 = t12 * t3167;
        t3170 = t7 * t3167;
        t3172 = self.constants[7] * t1304;
        t3177 = sin_phi * t3172 - cos_phi * (self.constants[7] * t298 - t1320);
        t3181 = t7 * self.constants[41] + t12 * self.constants[40];
        t3186 = self.constants[7] * self.constants[44] - t2584 - t2594 - t2673
            - t1242 * t3181;
        t3188 = sin_phi * t1303;
        t3190 = cos_phi * speeds[0];
        t3192 = sin_phi * t1309;
        t3199 = cos_delta * t3190;
        t3201 = cos_phi * (t7 * t1357 + speeds[0] * (self.constants[30] + t2637))
            + t2749 * t3199;
        t3204 = sin_delta * speeds[0];
        t3213 = cos_phi * (t12 * t1357 + speeds[0] * (t1910 - self.constants[31]));
        t3216 = self.constants[30] * t3188 - t3177;
        t3220 = t2749 * t3188 + cos_phi * (self.constants[38] * t3204 + t1398 * t3204)
            + cos_delta * t3216 - sin_delta * t3213;
        t3226 = cos_delta * t3213 + sin_delta * t3216 - t2931 * t3199;
        t3230 = sin_phi * (self.constants[7] * t1362 - t1320);
        t3239 = t7 * t2541 + t107 * t2795 - t12 * t2561 - t12 * t2747 - t1279 * t2773;
        t3245 = t1312 - t1310 * t2669;
        t3248 = t1306 * t2669 - t1495;
        t3252 = t12 * t3248 - t7 * t3245;
        t3256 = sin_delta * t2830 - cos_delta * t2828;
        t3265 = self.constants[7]
            * (t7 * t3256 - t12 * (t1804 + t1804) - t7 * (t1802 + t1802));
        t3266 = self.constants[30] * t3256 + t3265;
        t3270 = cos_delta * t2849 + sin_delta * t2852;
        t3272 = sin_delta * t2858;
        t3276 = cos_delta * t2862 + sin_delta * t2864;
        t3280 = sin_delta * t1709 + cos_delta * t2870;
        t3284 = sin_delta * t2868 - cos_delta * t2876;
        t3286 = t1549 + t1549;
        t3288 = t2883 - t3073;
        t3290 = t1538 + t1538;
        t3292 = t2886 + t3101;
        t3294 = t1334 + t1334;
        t3300 = sin_delta * t2901 - cos_delta * t2894;
        t3308 = sin_delta * t3294 + cos_delta * t3292 + cos_delta * t2916
            + sin_delta * t2920;
        t3316 = sin_delta * t3292 + sin_delta * t2934 - cos_delta * t3294
            - cos_delta * t2929;
        t3318 = sin_delta * t2940;
        t3320 = t1332 + t1332;
        t3329 = t1242 * t3252 + t1231 * t3266 + t2406 * t3270 + t2433 * t3280
            + t2450 * t3284 + t2584 * t3288;
        t3334 = t3329 + t2539 * t3290 + t2594 * t3292 + t2651 * t2888 + t2747 * t3300
            + t2773 * t3308;
        t3339 = t3334 + t2795 * t3316 + t2815 * t3318 + t1081 * t2991 + cos_theta * t3012
            - self.constants[7] * (t2834 + t3049);
        t3344 = t3339 - t12 * t3245 - t7 * t3248 - t1282 * t3272 - t2414 * t3276
            - t2559 * t3286;
        t3348 = t3344 - t2455 * t3294 - t2645 * t2890 - t2948 * t3320 - t1120 * t2970;
        t3356 = t2541 * t3168 + t2561 * t3170 + t3177 * t3186 + t2624 * t3188
            + t2747 * t3201 + t2773 * t3220;
        t3361 = t3356 + t2795 * t3226 + t3230 * t3239 + t3114 * t3192 + t16 * t3038
            - t2696 * t3190;
        t3364 = t3361 - t2662 * t3192 - sin_phi * t3348 - t13 * t3142;
        t3368 = t2132 * t2702 + speeds[3] * t3364 + t797 * t3157;
        t3374 = t2138 * t2702 + speeds[1] * t3364 + t796 * t3163;
        t3376 = self.constants[7] * t2138;
        t3377 = t12 * t3376;
        t3379 = t7 * t3376;
        t3381 = speeds[1] * t3172;
        t3383 = speeds[1] * t1306;
        t3386 = speeds[1] * t1310;
        t3389 = t3101 + t3172;
        t3391 = t1306 * t2749 + cos_delta * t3389;
        t3392 = speeds[1] * t3391;
        t3394 = sin_delta * t3389;
        t3395 = speeds[1] * t3394;
        t3397 = speeds[1] * t1320;
        t3407 = t2624 * t3383 + t2138 * t2696 + t2773 * t3392 + t2795 * t3395
            + t3239 * t3397 + t3114 * t3386;
        t3412 = t3407 + speeds[1] * t3348 + t486 * t3374 - t2541 * t3377 - t2561 * t3379
            - t3186 * t3381;
        t3414 = t3412 - t2662 * t3386 - t804 * t3163;
        t3420 = t489 * t3374 + t74 * t3414 - t809 * t3163;
        t3426 = t818 * t3163 + t497 * t3374 + t77 * t3414;
        t3428 = t1483 * t2383;
        t3432 = self.constants[28] * t2144;
        let (
            t3436, t3440, t3442, t3447, t3449, t3450, t3467, t3475, t3482, t3485, t3491, t3496,
            t3500, t3506, t3512, t3517, t3519, t3520, t3527, t3532, t3533, t3535, t3537, t3539,
            t3542, t3544, t3546, t3548, t3558, t3563, t3566, t3576, t3578, t3580, t3592, t3594,
            t3600, t3606, t3611, t3616, t3621, t3626, t3630, t3632, t3644, t3647, t3661, t3666,
            t3672, t3678, t3686, t3709, t3714, t3719, t3724, t3729, t3734, t3736, t3737, t3739,
            t3741, t3743, t3745, t3747, t3748, t3750, t3751, t3752, t3756, t3758, t3762, t3764,
            t3774, t3779, t3782, t3786, t3790, t3791, t3792, t3793, t3794, t3796, t3797, t3799,
            t3803, t3804, t3805, t3807, t3808, t3809, t3811, t3814, t3816, t3817, t3820, t3822,
            t3823, t3825, t3826, t3831, t3836, t3840, t3842, t3845, t3849, t3851, t3852, t3857,
            t3862, t3866, t3868, t3871, t3872, t3874, t3876, t3878, t3880, t3884, t3886, t3887,
            t3893, t3898, t3903, t3906, t3908, t3916, t3920, t3924, t3928, t3933, t3936, t3940,
            t3944, t3948, t3952, t3956, t3959, t3963, t3965, t3967, t3975, t3977, t3989, t3999,
            t4005, t4011, t4017, t4023, t4026, t4039, t4045, t4051, t4053, t4072, t4076, t4082,
            t4091, t4097, t4103, t4109, t4112, t4115, t4138, t4151, t4152, t4165, t4166, t4179,
            t4180, t4186, t4191, t4196, t4201, t4203, t4227, t4236, t4241, t4246, t4251, t4252,
            t4262, t4264, t4270, t4277, t4293, t4322, t4327, t4332, t4337, t4338, t4346, t4351,
            t4354, t4358, t4365, t4384, t4389, t4392, t4398, t4404, t4411, t4415, t4421, t4431,
            t4436, t4444, t4466, t4471, t4473, t4483, t4485, t4498, t4500, t4506, t4512, t4517,
            t4522, t4527, t4532, t4535, t4571, t4576, t4581, t4586, t4591, t4595, t4615, t4620,
            t4622, t4624, t4626, t4628, t4634, t4636, t4639, t4649, t4653, t4657, t4669, t4673,
            t4675, t4687, t4692, t4696, t4699, t4702, t4706, t4707, t4709, t4711,
        );
        t3436 = speeds[0] * t3155 - t2313 - t1283 * t3432;
        t3440 = t828 * t3157 + t513 * t3163 + t831 * t3436 - t1283 * t3428;
        t3442 = t1479 * t2383;
        t3447 = t135 * t3163 + t840 * t3436 - t1283 * t3442;
        t3449 = t442 * t1483;
        t3450 = t2388 * t3449;
        t3467 = t1075 * t2253 + t1120 * t2260 + t1098 * t2265;
        t3475 = t1844 + self.constants[47] * t2299 - self.constants[48] * t2304;
        t3482 = t1856 + t3467 + t3475 - self.constants[44] * t2191
            - self.constants[40] * t2173;
        t3485 = t7 * t3482 + t12 * t2356;
        t3491 = t1818 + self.constants[41] * t2179 + self.constants[40] * t2191
            + self.constants[43] * t2173 + self.constants[27] * t2175 + t1081 * t2218;
        t3496 = t3491 + cos_theta * t2241 + self.constants[33] * t2349
            + self.constants[32] * t3467 + sin_delta * t2291 + cos_delta * t2317;
        t3500 = t3496 + self.constants[31] * t2352 - t1120 * t2248
            - self.constants[30] * t3475 - self.constants[7] * t3485;
        t3506 = sin_phi * t3500 + cos_phi * (t12 * t2381 - t7 * t2342);
        t3512 = t3506 + t2144 * t2702 + speeds[0] * t3364 + t797 * t3436;
        t3517 = t2702 * t3449 + t506 * t3368 + t514 * t3374 + t517 * t3512
            - t1283 * t3450;
        t3519 = t442 * t1479;
        t3520 = t2388 * t3519;
        t3527 = t2702 * t3519 + t525 * t3374 + t527 * t3512 - t1283 * t3520;
        t3532 = self.constants[7] * t2144;
        t3533 = t12 * t3532;
        t3535 = t7 * t3532;
        t3537 = speeds[0] * t3172;
        t3539 = speeds[0] * t1306;
        t3542 = speeds[0] * t1310;
        t3544 = speeds[0] * t3391;
        t3546 = speeds[0] * t3394;
        t3548 = speeds[0] * t1320;
        t3558 = t2624 * t3539 + t2144 * t2696 + t2773 * t3544 + t2795 * t3546
            + t3239 * t3548 + t3114 * t3542;
        t3563 = t3558 + speeds[0] * t3348 + t486 * t3512 - t3500 - t2541 * t3533
            - t2561 * t3535;
        t3566 = t3563 - t3186 * t3537 - t2662 * t3542 - t859 * t3436;
        t3576 = t855 * t3163 + t531 * t3374 + t98 * t3414 + t53 * t3566 + t547 * t3447
            + t537 * t3527;
        t3578 = t3576 - t117 * t3440 - t36 * t3517;
        t3580 = t136 * t1479;
        t3592 = t3420 + t36 * t3440 + t547 * t3527 - t2723 * t3580 - t137 * t3414
            - t142 * t3566;
        t3594 = t3592 - t537 * t3447 - t117 * t3517;
        t3600 = t817 * t3163 + t496 * t3374 - sin_phi * t3578;
        t3606 = t1231 * t2357 + t1242 * t2381 + t2158 * t2624 + t2144 * t2662
            + t2397 * t2702 + t2712 * t2723;
        t3611 = t3606 + t2765 * t2773 + t2785 * t2795 + t2805 * t2815 + speeds[0] * t3038
            + t777 * t3157;
        t3616 = t3611 + t792 * t3163 + t444 * t3368 + t479 * t3374 + t65 * t3414
            + self.constants[31] * t3426;
        t3621 = t3616 + t827 * t3440 + t524 * t3527 + t114 * t3594
            + self.constants[39] * t3600 - t2342;
        t3626 = t3621 - t1283 * t2400 - t2177 * t2541 - t1512 * t2561 - t2737 * t2747
            - t1304 * t3142;
        t3630 = t3626 - self.constants[30] * t3420 - t838 * t3447 - t504 * t3517
            - t97 * t3578;
        t3632 = self.constants[7] * t3482;
        t3644 = t28 * t442 * t1474 + t166 * t2389 + t168 * t2392 + t170 * t2394;
        t3647 = t168 * t2384 - t170 * t2386 - t2388 * t3644;
        t3661 = t28 * t53 * t1421 + t168 * t2707 + t170 * t2709 - t166 * t2704;
        t3666 = t1359 + t168 * t2728 - t170 * t2734;
        t3672 = t168 * t2756 + t170 * t2760 - sin_delta * t1364;
        t3678 = cos_delta * t1364 + t170 * t2781 - t168 * t2778;
        t3686 = t28 * t2797 + t166 * t2798 + t168 * t2800 + t170 * t2802;
        t3709 = t1231 * t3632 + t1512 * t2541 + t2144 * t2624 + t2723 * t3661
            + t2747 * t3666 + t2773 * t3672;
        t3714 = t3709 + t2795 * t3678 + t2815 * t3686 + t1331 * t3114 + t1304 * t3038
            + speeds[0] * t3142;
        t3719 = t3714 + t909 * t3157 + t917 * t3163 + t568 * t3368 + t576 * t3374
            + t156 * t3414;
        t3724 = t3719 + t926 * t3440 + t587 * t3527 + t185 * t3594 - t2381
            - t1242 * t2342;
        t3729 = t3724 - t1283 * t3647 - t2177 * t2561 - t2158 * t2662 - t2702 * t3644
            - self.constants[31] * t3420;
        t3734 = t3729 - self.constants[30] * t3426 - t930 * t3447 - t583 * t3517
            - t175 * t3578 - t48 * t3600;
        t3736 = t7 * t2331;
        t3737 = self.constants[47] * t2173;
        t3739 = t2637 * t3737;
        t3741 = self.constants[30] * t3737 + t3739 - t3475;
        t3743 = t12 * t2331;
        t3745 = self.constants[48] * t2173;
        t3747 = t1302 * t1306;
        t3748 = t2166 + t3747;
        t3750 = t1302 * t1302;
        t3751 = t1310 * t1310;
        t3752 = t3750 + t3751;
        t3756 = t1339 + t3747;
        t3758 = sin_delta * t3752 + cos_delta * t3756;
        t3762 = sin_delta * t3756 - cos_delta * t3752;
        t3764 = t1306 * t1310;
        t3774 = t1242 * t3743 + t2594 * t3748 + t1354 * t2747 + t2773 * t3758
            + t2795 * t3762 + t2948 * t3764;
        t3779 = t3774 + t12 * t3594 - t3736 - t1231 * t3741 - t1282 * t3745
            - t2455 * t3752;
        t3782 = t3779 - t12 * t3420 - t7 * t3426 - t7 * t3600;
        t3786 = self.constants[19] - t237;
        t3790 = self.constants[2] * t3786 + self.constants[3] * self.constants[20];
        t3791 = self.constants[18] * t3790;
        t3792 = t3791 + t3791;
        t3793 = t1374 * t1379;
        t3794 = t2406 * t3793;
        t3796 = t1370 * t1374;
        t3797 = t2414 * t3796;
        t3799 = t3794 + t3797 - t1282 * t2304;
        t3803 = self.constants[3] * t3786 - self.constants[2] * self.constants[20];
        t3804 = self.constants[18] * t3803;
        t3805 = t3796 - t2285;
        t3807 = t1370 * t1370;
        t3808 = t1379 * t1379;
        t3809 = t3807 - t3808;
        t3811 = t2287 + t3793;
        t3814 = t2406 * t3805 + t1282 * t3809 + t2414 * t3811;
        t3816 = t1370 * t1379;
        t3817 = t1282 * t3816;
        t3820 = t3794 + t3817 + t2285 * t2414;
        t3822 = t1374 * t1374;
        t3823 = t3808 + t3822;
        t3825 = t2637 * t3823;
        t3826 = self.constants[30] * t3823 + t3825;
        t3831 = t2304 + t3816;
        t3836 = t2280 * t2414 + t2433 * t3805 + t2450 * t3831 - t1231 * t3826
            - t1282 * t2295;
        t3840 = t3792 * t3799 + t3804 * t3814 + self.constants[18] * t3836
            - t3792 * t3820;
        t3842 = t3804 + t3804;
        t3845 = t3817 + t2287 * t2406 - t3797;
        t3849 = t3816 - t2304;
        t3851 = t2637 * t3849;
        t3852 = self.constants[30] * t3849 + t3851;
        t3857 = t3807 + t3822;
        t3862 = t1231 * t3852 + t2280 * t2406 + t1282 * t2299 + t2433 * t3811
            - t2450 * t3857;
        t3866 = t3842 * t3845 + t3799 * t3842 + t3791 * t3814
            + self.constants[18] * t3862;
        t3868 = self.constants[2] * t3840 + self.constants[3] * t3866;
        t3871 = t1302 * t1310;
        t3872 = t3871 - t2161;
        t3874 = t2173 + t3764;
        t3876 = t3764 - t1354;
        t3878 = t1342 + t3871;
        t3880 = cos_delta * t3878 - sin_delta * t3876;
        t3884 = cos_delta * t3876 + sin_delta * t3878;
        t3886 = t1306 * t1306;
        t3887 = t3750 + t3886;
        t3893 = t7 * t3594 + t12 * t3600;
        t3898 = t3743 + t1242 * t3736 + t2594 * t3872 + t2455 * t3874 + t2773 * t3880
            + t2795 * t3884;
        t3903 = t3898 + t12 * t3426 + t3893 - t1231 * t2352 - t2948 * t3887 - t7 * t3420;
        t3906 = self.constants[3] * t3782 + self.constants[2] * t3903 - t3868;
        t3908 = t155 * t3734 + t3906 - t58 * t3630;
        t3916 = t12 * t1908 - self.constants[0].like(1.0);
        t3920 = t107 * t1908 + sin_delta * t1906;
        t3924 = t1908 * t2428 - t1906 * t2424;
        t3928 = t1908 * t2445 - t1906 * t2441;
        t3933 = t2435 * t3928 - t1929 * t2408 - t1202 * t3916 - t2410 * t3920
            - t2416 * t3924;
        t3936 = t1908 * t2463 - cos_theta * t1906;
        t3940 = t1908 * t2478 + t1906 * t2487;
        t3944 = t1908 * t2494 - t1906 * t2503;
        t3948 = t1908 * t2509 + t1120 * t1906;
        t3952 = t1908 * t2516 - t1081 * t1906;
        t3956 = t1908 * t2523 - t1906 * t2529;
        t3959 = self.constants[54] * t3948 + self.constants[24] * t3956
            - self.constants[55] * t3952;
        t3963 = t2457 * t3936 + t2492 * t3944 - t2469 * t3940 - t1081 * t3959;
        t3965 = t3933 + t3963 - t1906 * t2403;
        t3967 = self.constants[48] * t1929;
        t3975 = t2551 * t3936 + t2469 * t3944 + t1120 * t3959 - t2553 * t3940;
        t3977 = t3967 + t1906 * t2547 + t3975;
        t3989 = t2575 * t3936 + t2577 * t3940 + t2579 * t3944 + cos_theta * t3959;
        t3999 = t1134 * t3916 + t2408 * t3920 + t2435 * t3924 + t2416 * t3928
            - t1929 * t2410;
        t4005 = self.constants[59] * t3948 + self.constants[57] * t3952
            + self.constants[54] * t3956;
        t4011 = self.constants[58] * t3936 + self.constants[54] * t3940
            + self.constants[55] * t3944;
        t4017 = self.constants[57] * t3948 + self.constants[56] * t3952
            - self.constants[55] * t3956;
        t4023 = self.constants[53] * t3916 + t1908 * t2569 + self.constants[48] * t3924
            + self.constants[30] * t3999 + t1098 * t4005 + t1120 * t4011;
        t4026 = t4023 + t1075 * t4017 - self.constants[51] * t3920
            - self.constants[32] * t3989;
        t4039 = self.constants[49] * t3928 - t1947 - self.constants[52] * t1929
            - t1906 * t2639;
        t4045 = self.constants[51] * t3916 - self.constants[50] * t3920
            - self.constants[49] * t3924;
        t4051 = t1908 * t2629 + t1075 * t4005 + t1071 * t4017 + cos_delta * t4045
            - self.constants[33] * t3989 - self.constants[31] * t3999;
        t4053 = t4051 - t1081 * t4011 - sin_delta * t4039;
        t4072 = self.constants[32] * t3975 + self.constants[33] * t3963
            + self.constants[31] * t3933 + cos_theta * t4011 + t1081 * t4017
            + cos_delta * t4039;
        t4076 = t4072 + sin_delta * t4045 - t1929 * t2636 - t1906 * t2677
            - t1120 * t4005;
        t4082 = t2664 * t3965 + t2666 * t3977 + t16 * t4053 - t13 * t4026
            - sin_phi * t4076;
        t4091 = t4076 + t486 * t4082 - t1930 * t2715 - t1910 * t3965 - t2637 * t3977;
        t4097 = t2744 * t4091 - t1930 * t2741 - t2739 * t4082;
        t4103 = t2766 * t4082 + t2770 * t4091 - t1930 * t2767;
        t4109 = t1930 * t2789 + t2792 * t4091 - t2787 * t4082;
        t4112 = t2810 * t4103;
        t4115 = t4112 - t2806 * t4097 - t2812 * t4109;
        t4138 = t3967 + t4097 + t1906 * t2945;
        t4151 = t2954 * t3936 + t2957 * t3952 + t1679 * t3956 + t1598 * t4011
            - t2950 * t3948 - t2959 * t3940;
        t4152 = t4151 - t2962 * t3944;
        t4165 = t2973 * t3948 + t2977 * t3936 + t2950 * t3952 + t1666 * t3956
            + t2983 * t3944 - t2980 * t3940;
        t4166 = t4165 - t1606 * t4011;
        t4179 = t2994 * t3948 + t2997 * t3952 + t2999 * t3940 + t3001 * t3956
            + t1606 * t4017 - t3003 * t3944;
        t4180 = t4179 - t1598 * t4005;
        t4186 = t1908 * t2825 + t2854 * t3916 + t2873 * t3924 + t2878 * t3928
            + t2883 * t3963 + t1334 * t3999;
        t4191 = t4186 + t2886 * t3933 + t297 * t4026 + t2903 * t4097 + t2925 * t4103
            + t2938 * t4109;
        t4196 = t4191 + t2941 * t4115 + t2943 * t4138 + t1075 * t4152 + t1071 * t4166
            - t1906 * t2845;
        t4201 = t4196 - t1929 * t2859 - t2866 * t3920 - t2880 * t3975 - t1538 * t3989
            - t2888 * t4039;
        t4203 = t4201 - t2890 * t4045 - t1081 * t4180;
        t4227 = t3108 * t4103 + t3111 * t4109 - t3103 * t4097;
        t4236 = t1722 * t3924 + t1549 * t3989 + t3076 * t3963 + t1332 * t3999
            + t3082 * t4097 + t3089 * t4103;
        t4241 = t4236 + t3097 * t4109 + t3099 * t4115 + t3101 * t4138 + t297 * t4227
            + t1098 * t4152;
        t4246 = t4241 + t1075 * t4166 + t1120 * t4180 - t2864 * t3916 - t1929 * t3065
            - t3068 * t3920;
        t4251 = t4246 - t1906 * t3058 - t1908 * t3061 - t3071 * t3928 - t3073 * t3975
            - t3079 * t3933;
        t4252 = t4251 - t297 * t4053;
        t4262 = t4112 + t3146 * t3916 + t3148 * t3920 - t1408 * t4097 - t1411 * t4109;
        t4264 = speeds[3] * t4262 - t1930 * t3144;
        t4270 = t779 * t4262 - t775 * t2313 - t1930 * t3160;
        t4277 = t3989 + t3999 + t1908 * t3181;
        t4293 = t7 * t3965 + t107 * t4109 - t12 * t3977 - t12 * t4097 - t1279 * t4103;
        t4322 = t1908 * t3252 + t1906 * t3266 + t3270 * t3916 + t3280 * t3924
            + t3284 * t3928 + t3288 * t3989;
        t4327 = t4322 + t3290 * t3963 + t3292 * t3999 + t2888 * t4045 + t3300 * t4097
            + t3308 * t4103;
        t4332 = t4327 + t3316 * t4109 + t3318 * t4115 + t1081 * t4166 + cos_theta * t4180
            - t1929 * t3272;
        t4337 = t4332 - t3276 * t3920 - t3286 * t3975 - t3294 * t3933 - t2890 * t4039
            - t3320 * t4138;
        t4338 = t4337 - t1120 * t4152;
        t4346 = t3168 * t3965 + t3170 * t3977 + t3188 * t4026 + t3201 * t4097
            + t3220 * t4103 + t3226 * t4109;
        t4351 = t4346 + t3230 * t4293 + t3192 * t4227 + t16 * t4203 - t3177 * t4277
            - t3190 * t4076;
        t4354 = t4351 - t3192 * t4053 - sin_phi * t4338 - t13 * t4252;
        t4358 = t2132 * t4082 + speeds[3] * t4354 + t797 * t4264;
        t4365 = t3506 + t2138 * t4082 + speeds[1] * t4354 + t796 * t4270;
        t4384 = t3381 * t4277 + t3383 * t4026 + t2138 * t4076 + t3392 * t4103
            + t3395 * t4109 + t3397 * t4293;
        t4389 = t4384 + t3386 * t4227 + speeds[1] * t4338 + t486 * t4365 - t3500
            - t3377 * t3965;
        t4392 = t4389 - t3379 * t3977 - t3386 * t4053 - t804 * t4270;
        t4398 = t489 * t4365 + t74 * t4392 - t809 * t4270;
        t4404 = t818 * t4270 + t497 * t4365 + t77 * t4392;
        t4411 = speeds[0] * t4262 - t1930 * t3432;
        t4415 = t828 * t4264 + t513 * t4270 + t831 * t4411 - t1930 * t3428;
        t4421 = t135 * t4270 + t840 * t4411 - t1930 * t3442;
        t4431 = t2144 * t4082 + speeds[0] * t4354 + t797 * t4411;
        t4436 = t3449 * t4082 + t506 * t4358 + t514 * t4365 + t517 * t4431
            - t1930 * t3450;
        t4444 = t3519 * t4082 + t525 * t4365 + t527 * t4431 - t1930 * t3520;
        t4466 = t3537 * t4277 + t3539 * t4026 + t2144 * t4076 + t3544 * t4103
            + t3546 * t4109 + t3548 * t4293;
        t4471 = t4466 + t3542 * t4227 + speeds[0] * t4338 + t486 * t4431 - t3533 * t3965
            - t3535 * t3977;
        t4473 = t4471 - t3542 * t4053 - t859 * t4411;
        t4483 = t855 * t4270 + t531 * t4365 + t98 * t4392 + t53 * t4473 + t547 * t4421
            + t537 * t4444;
        t4485 = t4483 - t117 * t4415 - t36 * t4436;
        t4498 = t4398 + t36 * t4415 + t547 * t4444 - t3580 * t4091 - t137 * t4392
            - t142 * t4473;
        t4500 = t4498 - t537 * t4421 - t117 * t4436;
        t4506 = t817 * t4270 + t496 * t4365 - sin_phi * t4485;
        t4512 = t1906 * t2357 + t1908 * t2381 + t2158 * t4026 + t2144 * t4053
            + t2397 * t4082 + t2712 * t4091;
        t4517 = t4512 + t2765 * t4103 + t2785 * t4109 + t2805 * t4115 + speeds[0] * t4203
            + t777 * t4264;
        t4522 = t4517 + t792 * t4270 + t444 * t4358 + t479 * t4365 + t65 * t4392
            + self.constants[31] * t4404;
        t4527 = t4522 + t827 * t4415 + t524 * t4444 + t114 * t4500
            + self.constants[39] * t4506 - t1930 * t2400;
        t4532 = t4527 - t2177 * t3965 - t1512 * t3977 - t2737 * t4097 - t1304 * t4252
            - self.constants[30] * t4398;
        t4535 = t4532 - t838 * t4421 - t504 * t4436 - t97 * t4485;
        t4571 = t1906 * t3632 + t1512 * t3965 + t2144 * t4026 + t3661 * t4091
            + t3666 * t4097 + t3672 * t4103;
        t4576 = t4571 + t3678 * t4109 + t3686 * t4115 + t1331 * t4227 + t1304 * t4203
            + speeds[0] * t4252;
        t4581 = t4576 + t909 * t4264 + t917 * t4270 + t568 * t4358 + t576 * t4365
            + t156 * t4392;
        t4586 = t4581 + t926 * t4415 + t587 * t4444 + t185 * t4500 - t1908 * t2342
            - t1930 * t3647;
        t4591 = t4586 - t2177 * t3977 - t2158 * t4053 - t3644 * t4082
            - self.constants[31] * t4398 - self.constants[30] * t4404;
        t4595 = t4591 - t930 * t4421 - t583 * t4436 - t175 * t4485 - t48 * t4506;
        t4615 = t1908 * t3743 + t3748 * t3999 + t1354 * t4097 + t3758 * t4103
            + t3762 * t4109 + t3764 * t4138;
        t4620 = t4615 + t12 * t4500 - t1906 * t3741 - t1929 * t3745 - t3752 * t3933
            - t12 * t4398;
        t4622 = t4620 - t7 * t4404 - t7 * t4506;
        t4624 = t3793 * t3916;
        t4626 = t3796 * t3920;
        t4628 = t4624 + t4626 - t1929 * t2304;
        t4634 = t3805 * t3916 + t1929 * t3809 + t3811 * t3920;
        t4636 = t1929 * t3816;
        t4639 = t4624 + t4636 + t2285 * t3920;
        t4649 = t2280 * t3920 + t3805 * t3924 + t3831 * t3928 - t1906 * t3826
            - t1929 * t2295;
        t4653 = t3792 * t4628 + t3804 * t4634 + self.constants[18] * t4649
            - t3792 * t4639;
        t4657 = t4636 + t2287 * t3916 - t4626;
        t4669 = t1906 * t3852 + t2280 * t3916 + t1929 * t2299 + t3811 * t3924
            - t3857 * t3928;
        t4673 = t3842 * t4657 + t3842 * t4628 + t3791 * t4634
            + self.constants[18] * t4669;
        t4675 = self.constants[2] * t4653 + self.constants[3] * t4673;
        t4687 = t7 * t4500 + t12 * t4506;
        t4692 = t1908 * t3736 + t3872 * t3999 + t3874 * t3933 + t3880 * t4103
            + t3884 * t4109 + t12 * t4404;
        t4696 = t4692 + t4687 - t1906 * t2352 - t3887 * t4138 - t7 * t4398;
        t4699 = self.constants[3] * t4622 + self.constants[2] * t4696 - t4675;
        t4702 = t155 * t4595 + t4699 - t58 * t4535 - t1940 * t3908;
        t4706 = self.constants[3] * self.constants[55]
            - self.constants[2] * self.constants[54];
        t4707 = t1081 * t4706;
        t4709 = t1120 * t4706;
        t4711 = cos_theta * t4706;
        let (
            t4713, t4716, t4724, t4730, t4737, t4741, t4745, t4749, t4752, t4755, t4764, t4768,
            t4776, t4786, t4791, t4792, t4810, t4816, t4821, t4823, t4828, t4829, t4831, t4846,
            t4869, t4874, t4882, t4887, t4890, t4894, t4900, t4919, t4924, t4926, t4932, t4938,
            t4942, t4945, t4949, t4958, t4962, t4968, t4990, t4995, t4997, t5007, t5009, t5022,
            t5024, t5030, t5036, t5041, t5046, t5051, t5056, t5089, t5094, t5099, t5104, t5109,
            t5110, t5121, t5126, t5140, t5142, t5144, t5148, t5155, t5159, t5164, t5169, t5174,
            t5177, t5182, t5187, t5191, t5195, t5200, t5203, t5207, t5210, t5212, t5220, t5223,
            t5235, t5245, t5251, t5257, t5263, t5269, t5272, t5286, t5292, t5298, t5300, t5319,
            t5324, t5325, t5331, t5340, t5346, t5352, t5358, t5361, t5364, t5388, t5401, t5402,
            t5415, t5416, t5429, t5430, t5436, t5441, t5446, t5451, t5454, t5478, t5487, t5492,
            t5497, t5502, t5504, t5514, t5517, t5521, t5528, t5544, t5573, t5578, t5583, t5588,
            t5590, t5598, t5603, t5606, t5611, t5617, t5636, t5641, t5643, t5649, t5655, t5662,
            t5666, t5672, t5682, t5687, t5695, t5717, t5722, t5724, t5734, t5736, t5749, t5751,
            t5757, t5763, t5768, t5773, t5778, t5783, t5787, t5823, t5828, t5833, t5838, t5843,
            t5848, t5870, t5875, t5878, t5880, t5882, t5884, t5890, t5892, t5895, t5906, t5910,
            t5914, t5927, t5931, t5933, t5945, t5950, t5954, t5957, t5962, t5963, t5965, t5969,
            t5975, t5977, t5979, t5982, t5983, t5985, t5993, t5995, t5997, t5999, t6002, t6016,
            t6021, t6022, t6029, t6042, t6044, t6062, t6067, t6068, t6077, t6084, t6098, t6100,
            t6110, t6111, t6124, t6126, t6144, t6149, t6150, t6161, t6164, t6166, t6170, t6176,
            t6177, t6178, t6183, t6185, t6189, t6192, t6200, t6204, t6207, t6209, t6213, t6220,
            t6232, t6244, t6245, t6246, t6252, t6254, t6256, t6260, t6265, t6272,
        );
        t4713 = t1992 + self.constants[32] * t4711;
        t4716 = t1998 + self.constants[33] * t4711;
        t4724 = self.constants[32] * t4709 - t1983 - self.constants[33] * t4707;
        t4730 = t2666 * t4709 + t13 * t4713 - t2664 * t4707 - sin_phi * t4724
            - t16 * t4716;
        t4737 = t4724 + t1910 * t4707 + t486 * t4730 - t2637 * t4709;
        t4741 = t2744 * t4737 - t2739 * t4730;
        t4745 = t2766 * t4730 + t2770 * t4737;
        t4749 = t2792 * t4737 - t2787 * t4730;
        t4752 = t2810 * t4745;
        t4755 = t4752 - t2806 * t4741 - t2812 * t4749;
        t4764 = self.constants[2] * t2950 - self.constants[3] * t2957;
        t4768 = self.constants[2] * t2973 + self.constants[3] * t2950;
        t4776 = t1598 * self.constants[77] - self.constants[2] * t2994
            - self.constants[3] * t2997 - t1606 * self.constants[76];
        t4786 = t2943 * t4741 + t1075 * t4764 + t2903 * t4741 + t2925 * t4745
            + t2938 * t4749 + t2941 * t4755;
        t4791 = t4786 - t2880 * t4709 - t1538 * t4711 - t2883 * t4707 - t297 * t4713
            - t1071 * t4768;
        t4792 = t4791 - t1081 * t4776;
        t4810 = t3111 * t4749 + t3108 * t4745 - t3103 * t4741;
        t4816 = t1549 * t4711 + t297 * t4716 + t3089 * t4745 + t3099 * t4755
            + t1098 * t4764 + t1120 * t4776;
        t4821 = t4816 + t3082 * t4741 + t3097 * t4749 + t3101 * t4741 + t297 * t4810
            - t3073 * t4709;
        t4823 = t4821 - t3076 * t4707 - t1075 * t4768;
        t4828 = t4752 - t1408 * t4741 - t1411 * t4749;
        t4829 = speeds[3] * t4828;
        t4831 = t779 * t4828;
        t4846 = t107 * t4749 - t7 * t4707 - t12 * t4709 - t12 * t4741 - t1279 * t4745;
        t4869 = t3288 * t4711 + cos_theta * t4776 + t3300 * t4741 + t3308 * t4745
            + t3316 * t4749 + t3318 * t4755;
        t4874 = t4869 - t3286 * t4709 - t3290 * t4707 - t3320 * t4741 - t1120 * t4764
            - t1081 * t4768;
        t4882 = t3192 * t4716 + t3230 * t4846 + t3170 * t4709 + t3201 * t4741
            + t3220 * t4745 + t3226 * t4749;
        t4887 = t4882 + t3192 * t4810 + t16 * t4792 - t3177 * t4711 - t3188 * t4713
            - t3190 * t4724;
        t4890 = t4887 - t3168 * t4707 - sin_phi * t4874 - t13 * t4823;
        t4894 = t2132 * t4730 + speeds[3] * t4890 + t797 * t4829;
        t4900 = t2138 * t4730 + speeds[1] * t4890 + t796 * t4831;
        t4919 = t3377 * t4707 + t3381 * t4711 + t2138 * t4724 + t3386 * t4716
            + t3392 * t4745 + t3395 * t4749;
        t4924 = t4919 + t3397 * t4846 + t3386 * t4810 + speeds[1] * t4874 + t486 * t4900
            - t3379 * t4709;
        t4926 = t4924 - t3383 * t4713 - t804 * t4831;
        t4932 = t489 * t4900 + t74 * t4926 - t809 * t4831;
        t4938 = t818 * t4831 + t497 * t4900 + t77 * t4926;
        t4942 = speeds[0] * t4828;
        t4945 = t828 * t4829 + t513 * t4831 + t831 * t4942;
        t4949 = t135 * t4831 + t840 * t4942;
        t4958 = t2144 * t4730 + speeds[0] * t4890 + t797 * t4942;
        t4962 = t3449 * t4730 + t506 * t4894 + t514 * t4900 + t517 * t4958;
        t4968 = t3519 * t4730 + t525 * t4900 + t527 * t4958;
        t4990 = t3533 * t4707 + t3537 * t4711 + t2144 * t4724 + t3542 * t4716
            + t3544 * t4745 + t3546 * t4749;
        t4995 = t4990 + t3548 * t4846 + t3542 * t4810 + speeds[0] * t4874 + t486 * t4958
            - t3535 * t4709;
        t4997 = t4995 - t3539 * t4713 - t859 * t4942;
        t5007 = t855 * t4831 + t531 * t4900 + t98 * t4926 + t53 * t4997 + t547 * t4949
            + t537 * t4968;
        t5009 = t5007 - t117 * t4945 - t36 * t4962;
        t5022 = t4932 + t36 * t4945 + t547 * t4968 - t3580 * t4737 - t137 * t4926
            - t142 * t4997;
        t5024 = t5022 - t537 * t4949 - t117 * t4962;
        t5030 = t817 * t4831 + t496 * t4900 - sin_phi * t5009;
        t5036 = t2177 * t4707 + t2397 * t4730 + t2712 * t4737 + t2765 * t4745
            + t2785 * t4749 + t2805 * t4755;
        t5041 = t5036 + speeds[0] * t4792 + t777 * t4829 + t792 * t4831 + t444 * t4894
            + t479 * t4900;
        t5046 = t5041 + t65 * t4926 + self.constants[31] * t4938 + t827 * t4945
            + t524 * t4968 + t114 * t5024;
        t5051 = t5046 + self.constants[39] * t5030 - t1512 * t4709 - t2158 * t4713
            - t2144 * t4716 - t2737 * t4741;
        t5056 = t5051 - t1304 * t4823 - self.constants[30] * t4932 - t838 * t4949
            - t504 * t4962 - t97 * t5009;
        t5089 = t2158 * t4716 + t3661 * t4737 + t3666 * t4741 + t3672 * t4745
            + t3678 * t4749 + t3686 * t4755;
        t5094 = t5089 + t1331 * t4810 + t1304 * t4792 + speeds[0] * t4823 + t909 * t4829
            + t917 * t4831;
        t5099 = t5094 + t568 * t4894 + t576 * t4900 + t156 * t4926 + t926 * t4945
            + t587 * t4968;
        t5104 = t5099 + t185 * t5024 - t1512 * t4707 - t2177 * t4709 - t2144 * t4713
            - t3644 * t4730;
        t5109 = t5104 - self.constants[31] * t4932 - self.constants[30] * t4938
            - t930 * t4949 - t583 * t4962 - t175 * t5009;
        t5110 = t5109 - t48 * t5030;
        t5121 = t7 * t5024 + t12 * t5030;
        t5126 = t3880 * t4745 + t3884 * t4749 + t12 * t4938 + t5121 - t3887 * t4741
            - t7 * t4932;
        t5140 = t1354 * t4741 + t3758 * t4745 + t3762 * t4749 + t3764 * t4741
            + t12 * t5024 - t12 * t4932;
        t5142 = t5140 - t7 * t4938 - t7 * t5030;
        t5144 = self.constants[2] * t5126 + self.constants[3] * t5142;
        t5148 = t155 * t5110 + t5144 - t58 * t5056 - t2012 * t3908 - t2016 * t4702;
        t5155 = t12 * t2043;
        t5159 = sin_delta * t2041 - t107 * t2043;
        t5164 = t2041 * t2424 + t2043 * t2428 - t2423;
        t5169 = t2440 + t2041 * t2441 + t2043 * t2445;
        t5174 = t2064 * t2408 + t2410 * t5159 + t2435 * t5169 - t1202 * t5155
            - t2416 * t5164;
        t5177 = t2043 * t2463 + cos_theta * t2041;
        t5182 = t2485 + t2041 * t2487 - t2043 * t2478;
        t5187 = t2501 + t2043 * t2494 + t2041 * t2503;
        t5191 = t2043 * t2509 - t1120 * t2041;
        t5195 = t2043 * t2516 + t1081 * t2041;
        t5200 = t2527 + t2043 * t2523 + t2041 * t2529;
        t5203 = self.constants[54] * t5191 + self.constants[24] * t5200
            - self.constants[55] * t5195;
        t5207 = t2457 * t5177 + t2469 * t5182 + t2492 * t5187 - t1081 * t5203;
        t5210 = t2402 + t2041 * t2403 + t5174 + t5207;
        t5212 = self.constants[48] * t2064;
        t5220 = t2551 * t5177 + t2553 * t5182 + t2469 * t5187 + t1120 * t5203;
        t5223 = t5212 + t2041 * t2547 - t2546 - t5220;
        t5235 = t2575 * t5177 + t2579 * t5187 + cos_theta * t5203 - t2577 * t5182;
        t5245 = t2064 * t2410 + t1134 * t5155 + t2435 * t5164 + t2416 * t5169
            - t2408 * t5159;
        t5251 = self.constants[59] * t5191 + self.constants[57] * t5195
            + self.constants[54] * t5200;
        t5257 = self.constants[58] * t5177 + self.constants[55] * t5187
            - self.constants[54] * t5182;
        t5263 = self.constants[57] * t5191 + self.constants[56] * t5195
            - self.constants[55] * t5200;
        t5269 = self.constants[53] * t5155 + self.constants[51] * t5159 + t2043 * t2569
            + self.constants[48] * t5164 + self.constants[30] * t5245 + t1098 * t5251;
        t5272 = t5269 + t1120 * t5257 + t1075 * t5263 - self.constants[32] * t5235;
        t5286 = self.constants[52] * t2064 + t2041 * t2639 + self.constants[49] * t5169
            - t2114 - t2638;
        t5292 = self.constants[51] * t5155 + self.constants[50] * t5159
            - self.constants[49] * t5164;
        t5298 = t2043 * t2629 + t1075 * t5251 + t1071 * t5263 + cos_delta * t5292
            - self.constants[33] * t5235 - self.constants[31] * t5245;
        t5300 = t5298 - t1081 * t5257 - sin_delta * t5286;
        t5319 = t2675 + t2064 * t2636 + t2041 * t2677 + self.constants[32] * t5220
            + self.constants[33] * t5207 + self.constants[31] * t5174;
        t5324 = t5319 + cos_theta * t5257 + t1081 * t5263 + cos_delta * t5286
            + sin_delta * t5292 - self.constants[27];
        t5325 = t5324 - t1120 * t5251;
        t5331 = t2664 * t5210 + t16 * t5300 - t2666 * t5223 - t13 * t5272
            - sin_phi * t5325;
        t5340 = t5325 + t2637 * t5223 + t486 * t5331 - t2065 * t2715 - t1910 * t5210;
        t5346 = t2744 * t5340 - t2065 * t2741 - t2739 * t5331;
        t5352 = t2766 * t5331 + t2770 * t5340 - t2065 * t2767;
        t5358 = t2065 * t2789 + t2792 * t5340 - t2787 * t5331;
        t5361 = t2810 * t5352;
        t5364 = t5361 - t2806 * t5346 - t2812 * t5358;
        t5388 = t2944 + t5346 - t5212 - t2041 * t2945;
        t5401 = t2954 * t5177 + t2957 * t5195 + t2959 * t5182 + t1679 * t5200
            + t1598 * t5257 - t2950 * t5191;
        t5402 = t5401 - t2962 * t5187;
        t5415 = t2973 * t5191 + t2977 * t5177 + t2950 * t5195 + t2980 * t5182
            + t1666 * t5200 + t2983 * t5187;
        t5416 = t5415 - t1606 * t5257;
        t5429 = t2994 * t5191 + t2997 * t5195 + t3001 * t5200 + t1606 * t5263
            - t2999 * t5182 - t3003 * t5187;
        t5430 = t5429 - t1598 * t5251;
        t5436 = t2841 + t2043 * t2825 + t2041 * t2845 + t2854 * t5155 + t2064 * t2859
            + t2866 * t5159;
        t5441 = t5436 + t2873 * t5164 + t2878 * t5169 + t2883 * t5207 + t1334 * t5245
            + t2886 * t5174;
        t5446 = t5441 + t297 * t5272 + t2903 * t5346 + t2925 * t5352 + t2938 * t5358
            + t2941 * t5364;
        t5451 = t5446 + t2943 * t5388 + t1075 * t5402 + t1071 * t5416 - t2880 * t5220
            - t1538 * t5235;
        t5454 = t5451 - t2888 * t5286 - t2890 * t5292 - t1081 * t5430;
        t5478 = t3108 * t5352 + t3111 * t5358 - t3103 * t5346;
        t5487 = t3054 + t2064 * t3065 + t3068 * t5159 + t2041 * t3058 + t1722 * t5164
            + t1549 * t5235;
        t5492 = t5487 + t3076 * t5207 + t1332 * t5245 + t3082 * t5346 + t3089 * t5352
            + t3097 * t5358;
        t5497 = t5492 + t3099 * t5364 + t3101 * t5388 + t297 * t5478 + t1098 * t5402
            + t1075 * t5416;
        t5502 = t5497 + t1120 * t5430 - t2864 * t5155 - t2043 * t3061 - t3071 * t5169
            - t3073 * t5220;
        t5504 = t5502 - t3079 * t5174 - t297 * t5300;
        t5514 = t5361 + t3146 * t5155 - t3148 * t5159 - t1408 * t5346 - t1411 * t5358;
        t5517 = speeds[3] * t5514 - t2313 - t2065 * t3144;
        t5521 = t779 * t5514 - t2065 * t3160;
        t5528 = t5235 + t5245 + t2043 * t3181;
        t5544 = t7 * t5210 + t12 * t5223 + t107 * t5358 - t12 * t5346 - t1279 * t5352;
        t5573 = t3265 + t2043 * t3252 + t3270 * t5155 + t2064 * t3272 + t3276 * t5159
            + t3280 * t5164;
        t5578 = t5573 + t3284 * t5169 + t3288 * t5235 + t3290 * t5207 + t3292 * t5245
            + t2888 * t5292;
        t5583 = t5578 + t3300 * t5346 + t3308 * t5352 + t3316 * t5358 + t3318 * t5364
            + t1081 * t5416;
        t5588 = t5583 + cos_theta * t5430 - t2041 * t3266 - t3286 * t5220 - t3294 * t5174
            - t2890 * t5286;
        t5590 = t5588 - t3320 * t5388 - t1120 * t5402;
        t5598 = t3168 * t5210 + t3188 * t5272 + t3201 * t5346 + t3220 * t5352
            + t3226 * t5358 + t3230 * t5544;
        t5603 = t5598 + t3192 * t5478 + t16 * t5454 - t3170 * t5223 - t3177 * t5528
            - t3190 * t5325;
        t5606 = t5603 - t3192 * t5300 - sin_phi * t5590 - t13 * t5504;
        t5611 = t3506 + t2132 * t5331 + speeds[3] * t5606 + t797 * t5517;
        t5617 = t2138 * t5331 + speeds[1] * t5606 + t796 * t5521;
        t5636 = t3379 * t5223 + t3381 * t5528 + t3383 * t5272 + t2138 * t5325
            + t3392 * t5352 + t3395 * t5358;
        t5641 = t5636 + t3397 * t5544 + t3386 * t5478 + speeds[1] * t5590 + t486 * t5617
            - t3377 * t5210;
        t5643 = t5641 - t3386 * t5300 - t804 * t5521;
        t5649 = t489 * t5617 + t74 * t5643 - t809 * t5521;
        t5655 = t818 * t5521 + t497 * t5617 + t77 * t5643;
        t5662 = speeds[0] * t5514 - t2065 * t3432;
        t5666 = t828 * t5517 + t513 * t5521 + t831 * t5662 - t2065 * t3428;
        t5672 = t135 * t5521 + t840 * t5662 - t2065 * t3442;
        t5682 = t2144 * t5331 + speeds[0] * t5606 + t797 * t5662;
        t5687 = t3449 * t5331 + t506 * t5611 + t514 * t5617 + t517 * t5682
            - t2065 * t3450;
        t5695 = t3519 * t5331 + t525 * t5617 + t527 * t5682 - t2065 * t3520;
        t5717 = t3535 * t5223 + t3537 * t5528 + t3539 * t5272 + t2144 * t5325
            + t3544 * t5352 + t3546 * t5358;
        t5722 = t5717 + t3548 * t5544 + t3542 * t5478 + speeds[0] * t5590 + t486 * t5682
            - t3533 * t5210;
        t5724 = t5722 - t3542 * t5300 - t859 * t5662;
        t5734 = t855 * t5521 + t531 * t5617 + t98 * t5643 + t53 * t5724 + t547 * t5672
            + t537 * t5695;
        t5736 = t5734 - t117 * t5666 - t36 * t5687;
        t5749 = t5649 + t36 * t5666 + t547 * t5695 - t3580 * t5340 - t137 * t5643
            - t142 * t5724;
        t5751 = t5749 - t537 * t5672 - t117 * t5687;
        t5757 = t817 * t5521 + t496 * t5617 - sin_phi * t5736;
        t5763 = t2357 + t2043 * t2381 + t1512 * t5223 + t2158 * t5272 + t2144 * t5300
            + t2397 * t5331;
        t5768 = t5763 + t2712 * t5340 + t2765 * t5352 + t2785 * t5358 + t2805 * t5364
            + speeds[0] * t5454;
        t5773 = t5768 + t777 * t5517 + t792 * t5521 + t444 * t5611 + t479 * t5617
            + t65 * t5643;
        t5778 = t5773 + self.constants[31] * t5655 + t827 * t5666 + t524 * t5695
            + t114 * t5751 + self.constants[39] * t5757;
        t5783 = t5778 - t2041 * t2357 - t2065 * t2400 - t2177 * t5210 - t2737 * t5346
            - t1304 * t5504;
        t5787 = t5783 - self.constants[30] * t5649 - t838 * t5672 - t504 * t5687
            - t97 * t5736;
        t5823 = t3632 + t1512 * t5210 + t2177 * t5223 + t2144 * t5272 + t3661 * t5340
            + t3666 * t5346;
        t5828 = t5823 + t3672 * t5352 + t3678 * t5358 + t3686 * t5364 + t1331 * t5478
            + t1304 * t5454;
        t5833 = t5828 + speeds[0] * t5504 + t909 * t5517 + t917 * t5521 + t568 * t5611
            + t576 * t5617;
        t5838 = t5833 + t156 * t5643 + t926 * t5666 + t587 * t5695 + t185 * t5751
            - t2041 * t3632;
        t5843 = t5838 - t2043 * t2342 - t2065 * t3647 - t2158 * t5300 - t3644 * t5331
            - self.constants[31] * t5649;
        t5848 = t5843 - self.constants[30] * t5655 - t930 * t5672 - t583 * t5687
            - t175 * t5736 - t48 * t5757;
        t5870 = t2041 * t3741 + t2043 * t3743 + t2064 * t3745 + t3748 * t5245
            + t1354 * t5346 + t3758 * t5352;
        t5875 = t5870 + t3762 * t5358 + t3764 * t5388 + t12 * t5751 - t3739
            - t3752 * t5174;
        t5878 = t5875 - t12 * t5649 - t7 * t5655 - t7 * t5757;
        t5880 = t3793 * t5155;
        t5882 = t3796 * t5159;
        t5884 = t5880 + t2064 * t2304 - t5882;
        t5890 = t2064 * t3809 + t3811 * t5159 - t3805 * t5155;
        t5892 = t2064 * t3816;
        t5895 = t5892 + t2285 * t5159 - t5880;
        t5906 = t2041 * t3826 + t2064 * t2295 + t3805 * t5164 + t3831 * t5169 - t3825
            - t2280 * t5159;
        t5910 = t3792 * t5884 + t3792 * t5895 + self.constants[18] * t5906
            - t3804 * t5890;
        t5914 = t5882 + t2287 * t5155 - t5892;
        t5927 = t3851 + t2280 * t5155 + t3811 * t5164 - t2041 * t3852 - t2064 * t2299
            - t3857 * t5169;
        t5931 = t3842 * t5914 + t3842 * t5884 + self.constants[18] * t5927
            - t3791 * t5890;
        t5933 = self.constants[2] * t5910 + self.constants[3] * t5931;
        t5945 = t7 * t5751 + t12 * t5757;
        t5950 = t2041 * t2352 + t2043 * t3736 + t3872 * t5245 + t3874 * t5174
            + t3880 * t5352 + t3884 * t5358;
        t5954 = t5950 + t12 * t5655 + t5945 - t3887 * t5388 - t7 * t5649;
        t5957 = self.constants[3] * t5878 + self.constants[2] * t5954 - t5933;
        t5962 = t155 * t5848 + t2094 * t5148 + t5957 - t58 * t5787 - t2072 * t3908
            - t2088 * t4702;
        t5963 = t2131 * t5962;
        t5965 = t2024 * t5148 + t2094 * t5963;
        t5969 = t1958 * t4702 - t2016 * t5965 - t2088 * t5963;
        t5975 = t1295 * t3908 - t1940 * t5969 - t2012 * t5965 - t2072 * t5963;
        t5977 = t3796 - t1387;
        t5979 = t1434 + t3816;
        t5982 = self.constants[38] * self.constants[29];
        t5983 = t5982 + t5982;
        t5985 = self.constants[37] * self.constants[29];
        t5993 = t3893 + t2773 * t5977 + t2795 * t5979 + t3799 * t5983 + t3814 * t5985
            + t3836 * self.constants[29];
        t5995 = t5993 - t2747 * t3823 - t3820 * t5983;
        t5997 = t3816 - t1434;
        t5999 = t1339 + t3793;
        t6002 = t5985 + t5985;
        t6016 = t2747 * t5997 + t2773 * t5999 + t3845 * t6002 + t3799 * t6002
            + t3814 * t5982 + t3862 * self.constants[29];
        t6021 = t6016 + t971 * t3163 + t622 * t3374 + t28 * t3578 + t89 * t3594
            - t2795 * t3857;
        t6022 = t6021 - t107 * t3600;
        t6029 = t3906 + t228 * t3734 - self.constants[2] * t5995
            - self.constants[3] * t6022 - t226 * t3630;
        t6042 = t4687 + t4103 * t5977 + t4109 * t5979 + t4628 * t5983 + t4634 * t5985
            + t4649 * self.constants[29];
        t6044 = t6042 - t3823 * t4097 - t4639 * t5983;
        t6062 = t4097 * t5997 + t4103 * t5999 + t4657 * t6002 + t4628 * t6002
            + t4634 * t5982 + t4669 * self.constants[29];
        t6067 = t6062 + t971 * t4270 + t622 * t4365 + t28 * t4485 + t89 * t4500
            - t3857 * t4109;
        t6068 = t6067 - t107 * t4506;
        t6077 = t4699 + t228 * t4595 - self.constants[2] * t6044
            - self.constants[3] * t6068 - t226 * t4535 - t1940 * t6029;
        t6084 = t5121 + t4745 * t5977 + t4749 * t5979 - t3823 * t4741;
        t6098 = t4741 * t5997 + t4745 * t5999 + t971 * t4831 + t622 * t4900 + t28 * t5009
            + t89 * t5024;
        t6100 = t6098 - t3857 * t4749 - t107 * t5030;
        t6110 = t5144 + t228 * t5110 - self.constants[2] * t6084
            - self.constants[3] * t6100 - t226 * t5056 - t2012 * t6029;
        t6111 = t6110 - t2016 * t6077;
        t6124 = t5945 + t5352 * t5977 + t5358 * t5979 + t5884 * t5983 + t5895 * t5983
            + t5906 * self.constants[29];
        t6126 = t6124 - t3823 * t5346 - t5890 * t5985;
        t6144 = t5346 * t5997 + t5352 * t5999 + t5914 * t6002 + t5884 * t6002
            + t5927 * self.constants[29] + t971 * t5521;
        t6149 = t6144 + t622 * t5617 + t28 * t5736 + t89 * t5751 - t3857 * t5358
            - t5890 * t5982;
        t6150 = t6149 - t107 * t5757;
        t6161 = t5957 + t228 * t5848 + t2094 * t6111 - self.constants[2] * t6126
            - self.constants[3] * t6150 - t226 * t5787;
        t6164 = t2131 * (t6161 - t2072 * t6029 - t2088 * t6077);
        t6166 = t2024 * t6111 + t2094 * t6164;
        t6170 = t1958 * t6077 - t2016 * t6166 - t2088 * t6164;
        t6176 = t1295 * t6029 - t1940 * t6170 - t2012 * t6166 - t2072 * t6164;
        t6177 = sin_theta * t2241;
        t6178 = self.constants[3] * t1068;
        t6183 = t1068 * (self.constants[3] + self.constants[3]);
        t6185 = self.constants[2] * t1068;
        t6189 = self.constants[3] * (t2248 * t6178 - t6177)
            - self.constants[2] * (t2218 * t6183 + t2248 * t6185);
        t6192 = t1068 * (self.constants[2] + self.constants[2]);
        t6200 = self.constants[3] * (t2248 * t6192 + t2218 * t6178)
            - self.constants[2] * (t6177 + t2218 * t6185);
        t6204 = t1120 * t2253 + t1081 * t2265;
        t6207 = sin_theta * t2260;
        t6209 = t2265 * t6192;
        t6213 = self.constants[33] * t2265 + self.constants[32] * t2253;
        t6220 = t2253 * t6183;
        t6232 = t12 * t2265 + t7 * t2253;
        t6244 = self.constants[7]
            * (self.constants[3] * (t7 * t6209 + t6178 * t6232 - t12 * t6207)
                - self.constants[2] * (t12 * t6220 + t7 * t6207 + t6185 * t6232));
        t6245 = self.constants[3]
            * (sin_theta * t2218 + self.constants[32] * t6209 + t6178 * t6213
                - self.constants[33] * t6207)
            - self.constants[2]
                * (self.constants[33] * t6220 + self.constants[32] * t6207
                    + t6185 * t6213 - sin_theta * t2248);
        t6246 = t6245 - t6244;
        t6252 = t12 * t6200 + t2477 * t6204 - t7 * t6189;
        t6254 = sin_theta * t2187;
        t6256 = t2193 * t6192;
        t6260 = self.constants[55] * t2193 - self.constants[54] * t2181;
        t6265 = t2181 * t6183;
        t6272 = self.constants[3]
            * (self.constants[55] * t6254 + t6178 * t6260 - self.constants[54] * t6256)
            - self.constants[2]
                * (self.constants[55] * t6265 + self.constants[54] * t6254
                    + t6185 * t6260);
        let (
            t6275, t6279, t6283, t6285, t6293, t6297, t6305, t6309, t6319, t6329, t6334, t6335,
            t6338, t6341, t6344, t6346, t6347, t6348, t6349, t6351, t6354, t6358, t6361, t6362,
            t6364, t6365, t6366, t6368, t6369, t6372, t6378, t6379, t6382, t6388, t6390, t6393,
            t6394, t6395, t6397, t6399, t6400, t6402, t6405, t6413, t6415, t6419, t6422, t6423,
            t6425, t6427, t6428, t6430, t6438, t6440, t6445, t6446, t6449, t6452, t6455, t6458,
            t6462, t6465, t6471, t6478, t6479, t6482, t6485, t6488, t6489, t6491, t6492, t6494,
            t6498, t6501, t6505, t6508, t6510, t6512, t6513, t6517, t6523, t6526, t6530, t6534,
            t6539, t6541, t6543, t6545, t6546, t6550, t6551, t6552, t6553, t6555, t6557, t6560,
            t6564, t6571, t6572, t6576, t6577, t6581, t6583, t6584, t6585, t6588, t6596, t6597,
            t6604, t6608, t6618, t6622, t6626, t6628, t6637, t6648, t6658, t6663, t6668, t6673,
            t6678, t6683, t6688, t6690, t6702, t6703, t6705, t6711, t6713, t6716, t6725, t6733,
            t6735, t6749, t6751, t6758, t6760, t6763, t6767, t6774, t6780, t6790, t6805, t6815,
            t6826, t6831, t6836, t6841, t6846, t6851, t6856, t6864, t6865, t6869, t6871, t6873,
            t6876, t6882, t6890, t6901, t6907, t6919, t6924, t6929, t6934, t6936, t6948, t6949,
            t6951, t6957, t6959, t6962, t6971, t6979, t6981, t6995, t6997, t7004, t7006, t7009,
            t7013, t7020, t7027, t7038, t7053, t7063, t7076, t7081, t7086, t7091, t7096, t7101,
            t7106, t7110, t7112, t7116, t7122, t7127, t7135, t7145, t7157, t7158, t7160, t7164,
            t7170, t7175, t7176, t7178, t7180, t7181, t7183, t7184, t7186, t7188, t7190, t7194,
            t7198, t7213, t7216, t7221, t7226, t7231, t7237, t7242, t7266, t7269, t7274, t7279,
            t7284, t7289, t7290, t7314, t7319, t7324, t7329, t7334, t7360, t7363, t7368, t7373,
            t7378, t7383, t7388, t7390, t7394, t7400, t7401, t7404, t7405, t7407,
        );
        t6275 = self.constants[24] * t2181;
        t6279 = self.constants[24] * t6254;
        t6283 = self.constants[3] * (self.constants[24] * t6256 + t6178 * t6275)
            - self.constants[2] * (t6185 * t6275 - t6279);
        t6285 = self.constants[24] * t2193;
        t6293 = self.constants[3] * (t6279 + t6178 * t6285)
            - self.constants[2] * (self.constants[24] * t6265 + t6185 * t6285);
        t6297 = t1120 * t2181 + t1081 * t2193;
        t6305 = t1578 + sin_theta * t2173;
        t6309 = self.constants[3] * (t2134 + t2166 * t6192 + t2161 * t6178)
            - self.constants[2] * (t2161 * t6185 - t6305);
        t6319 = self.constants[3] * (speeds[2] * t1601 + sin_theta * t2161)
            + self.constants[2] * (speeds[2] * t1609 + sin_theta * t2166);
        t6329 = self.constants[3] * (t6305 + t2166 * t6178)
            - self.constants[2] * (t2134 + t2161 * t6183 + t2166 * t6185);
        t6334 = self.constants[3] * self.constants[22];
        t6335 = self.constants[2] * self.constants[21] + t6334;
        t6338 = self.constants[2] * self.constants[22];
        t6341 = t6338 + self.constants[3] * self.constants[23];
        t6344 = self.constants[3] * (t6335 + t6335)
            - self.constants[2] * (t6341 + t6341);
        t6346 = t1601 * t1609;
        t6347 = t2467 * t6346;
        t6348 = t1577 * t1609;
        t6349 = t2520 * t6348;
        t6351 = t2214 * t2513 + t6349 - t6347;
        t6354 = self.constants[3] * self.constants[21] - t6338;
        t6358 = t6334 - self.constants[2] * self.constants[23];
        t6361 = self.constants[3] * (t6354 - t6341)
            - self.constants[2] * (t6335 + t6358);
        t6362 = t6348 - t2205;
        t6364 = t1609 * t1609;
        t6365 = t1601 * t1601;
        t6366 = t6364 - t6365;
        t6368 = t1577 * t1601;
        t6369 = t2214 + t6368;
        t6372 = t2467 * t6366 + t2520 * t6369 - t2513 * t6362;
        t6378 = self.constants[3] * (t6358 + t6358)
            + self.constants[2] * (t6354 + t6354);
        t6379 = t2513 * t6368;
        t6382 = t6347 + t2205 * t2520 - t6379;
        t6388 = self.constants[26] - self.constants[4];
        t6390 = self.constants[3] * self.constants[25] - self.constants[2] * t6388;
        t6393 = t1577 * t1577;
        t6394 = t6365 + t6393;
        t6395 = self.constants[24] * t6394;
        t6397 = self.constants[24] * t6362;
        t6399 = t2237 + t6346;
        t6400 = self.constants[24] * t6399;
        t6402 = self.constants[55] + self.constants[55];
        t6405 = t6379 + t2237 * t2467 - t6349;
        t6413 = t2250 * t2467 + t2490 * t6395 + t2532 * t6397 + t2506 * t6400
            + t6402 * t6405 + t6382 * t6402;
        t6415 = t6413 - t2255 * t2520 - self.constants[54] * t6372;
        t6419 = self.constants[2] * self.constants[25] + self.constants[3] * t6388;
        t6422 = t6346 - t2237;
        t6423 = self.constants[24] * t6422;
        t6425 = self.constants[24] * t6369;
        t6427 = t6364 + t6393;
        t6428 = self.constants[24] * t6427;
        t6430 = self.constants[54] + self.constants[54];
        t6438 = t2255 * t2513 + t2532 * t6425 + t6351 * t6430 + t6405 * t6430
            - t2262 * t2467 - t2490 * t6423;
        t6440 = t6438 - t2506 * t6428 - self.constants[55] * t6372;
        t6445 = self.constants[3] * self.constants[16];
        t6446 = self.constants[2] * self.constants[15] + t6445;
        t6449 = self.constants[2] * self.constants[16];
        t6452 = t6449 + self.constants[3] * self.constants[17];
        t6455 = self.constants[3] * (t6446 + t6446)
            - self.constants[2] * (t6452 + t6452);
        t6458 = self.constants[3] * self.constants[15] - t6449;
        t6462 = t6445 - self.constants[2] * self.constants[17];
        t6465 = self.constants[3] * (t6458 - t6452)
            - self.constants[2] * (t6446 + t6462);
        t6471 = self.constants[3] * (t6462 + t6462)
            + self.constants[2] * (t6458 + t6458);
        t6478 = self.constants[3] * self.constants[10];
        t6479 = self.constants[2] * self.constants[9] + t6478;
        t6482 = self.constants[2] * self.constants[10];
        t6485 = t6482 + self.constants[3] * self.constants[11];
        t6488 = self.constants[3] * (t6479 + t6479)
            - self.constants[2] * (t6485 + t6485);
        t6489 = t12 * t3871;
        t6491 = t1231 * t3764;
        t6492 = t7 * t3871;
        t6494 = t12 * t2166 - t6492;
        t6498 = t6491 + t1242 * t6494 - t6489 - t7 * t2166;
        t6501 = t6478 - self.constants[2] * self.constants[11];
        t6505 = self.constants[3] * self.constants[9] - t6482;
        t6508 = self.constants[3] * (t6501 + t6501)
            + self.constants[2] * (t6505 + t6505);
        t6510 = t7 * t3747;
        t6512 = t12 * t3747;
        t6513 = t7 * t2161 + t6512;
        t6517 = t6510 - t6491 - t12 * t2161 - t1242 * t6513;
        t6523 = self.constants[3] * (t6505 - t6485)
            - self.constants[2] * (t6479 + t6501);
        t6526 = t3751 - t3886;
        t6530 = t7 * t3748 + t12 * t3872;
        t6534 = t12 * t3748 + t1231 * t6526 + t1242 * t6530 - t7 * t3872;
        t6539 = self.constants[7] + self.constants[14];
        t6541 = self.constants[3] * self.constants[13] - self.constants[2] * t6539;
        t6543 = self.constants[7] * t3872;
        t6545 = t2148 * self.constants[12];
        t6546 = t12 * t6545;
        t6550 = t12 * t3874 - t7 * t3887;
        t6551 = self.constants[7] * self.constants[12];
        t6552 = t6550 * t6551;
        t6553 = t2179 * self.constants[12] - t6552;
        t6555 = t7 * t6545;
        t6557 = self.constants[41] + self.constants[41];
        t6560 = t6492 + t6512;
        t6564 = t6489 + t1242 * t6560 - t6510 - t1231 * t2173;
        t6571 = t6517 * t6557 + t6557 * t6564 + self.constants[40] * t6534
            - self.constants[12] * t6543 - t6546 - t1231 * t6553;
        t6572 = t6571 - t1242 * t6555;
        t6576 = self.constants[2] * self.constants[13] + self.constants[3] * t6539;
        t6577 = self.constants[7] * t3748;
        t6581 = t2173 - t3764;
        t6583 = t12 * t3752 + t7 * t6581;
        t6584 = t6551 * t6583;
        t6585 = t2191 * self.constants[12] + t6584;
        t6588 = self.constants[40] + self.constants[40];
        t6596 = t6555 + t6498 * t6588 + t6564 * t6588 + self.constants[41] * t6534
            - self.constants[12] * t6577 - t1231 * t6585;
        t6597 = t6596 - t1242 * t6546;
        t6604 = sin_theta * t1302;
        t6608 = self.constants[3] * (speeds[2] + t1310 * t6192 + t1306 * t6178)
            - self.constants[2] * (t1306 * t6185 - t6604);
        t6618 = self.constants[3] * (t6604 + t1310 * t6178)
            - self.constants[2] * (speeds[2] + t1306 * t6183 + t1310 * t6185);
        t6622 = t1120 * t1306 + t1081 * t1310;
        t6626 = t12 * t2268;
        t6628 = t7 * t2268;
        t6637 = t6626 + t1242 * t6628 + t2584 * t3872 + t2539 * t3874 - t1231 * t2349
            - t2559 * t3887;
        t6648 = t6628 + t2559 * t6581 + t2539 * t3752 - t1231 * t3467 - t1242 * t6626
            - t2584 * t3748;
        t6658 = t2473 * t6204 + t1242 * t6252 + t2467 * t6272 + t2506 * t6293
            + t2600 * t6309 + t2612 * t6329;
        t6663 = t6658 + t6344 * t6351 + t6361 * t6372 + t6390 * t6415 + t3845 * t6455
            + t3820 * t6471;
        t6668 = t6663 + t3803 * t3840 + t6488 * t6498 + t6541 * t6572 + t2970 * t6608
            + t2991 * t6618;
        t6673 = t6668 + self.constants[37] * t5995 + t241 * t6022
            + self.constants[33] * t6648 + self.constants[30] * t3903 + t286 * t3734;
        t6678 = t6673 - t12 * t6189 - t7 * t6200 - t1231 * t6246 - t2490 * t6283
            - t2535 * t6297;
        t6683 = t6678 - t2606 * t6319 - t6378 * t6382 - t6419 * t6440 - t3814 * t6465
            - t3790 * t3866;
        t6688 = t6683 - t6508 * t6517 - t6523 * t6534 - t6576 * t6597 - t3012 * t6622
            - self.constants[32] * t6637;
        t6690 = t6688 - self.constants[31] * t3782 - t283 * t3630;
        t6702 = t3936 * t6346;
        t6703 = t3952 * t6348;
        t6705 = t2214 * t3948 + t6703 - t6702;
        t6711 = t3936 * t6366 + t3952 * t6369 - t3948 * t6362;
        t6713 = t3948 * t6368;
        t6716 = t6702 + t2205 * t3952 - t6713;
        t6725 = t6713 + t2237 * t3936 - t6703;
        t6733 = t2250 * t3936 + t3940 * t6395 + t3956 * t6397 + t3944 * t6400
            + t6402 * t6725 + t6402 * t6716;
        t6735 = t6733 - t2255 * t3952 - self.constants[54] * t6711;
        t6749 = t2255 * t3948 + t3956 * t6425 + t6430 * t6705 + t6430 * t6725
            - t2262 * t3936 - t3940 * t6423;
        t6751 = t6749 - t3944 * t6428 - self.constants[55] * t6711;
        t6758 = t1906 * t3764;
        t6760 = t6758 + t1908 * t6494;
        t6763 = t6758 + t1908 * t6513;
        t6767 = t1906 * t6526 + t1908 * t6530;
        t6774 = t1908 * t6560 - t1906 * t2173;
        t6780 = t6557 * t6774 + self.constants[40] * t6767 - t1906 * t6553
            - t1908 * t6555 - t6557 * t6763;
        t6790 = t6588 * t6760 + t6588 * t6774 + self.constants[41] * t6767
            - t1906 * t6585 - t1908 * t6546;
        t6805 = t1908 * t6628 + t3872 * t3989 + t3874 * t3963 - t1906 * t2349
            - t3887 * t3975;
        t6815 = t3975 * t6581 + t3752 * t3963 - t1906 * t3467 - t1908 * t6626
            - t3748 * t3989;
        t6826 = t1908 * t6252 + t3936 * t6272 + t3944 * t6293 + t4005 * t6309
            + t4017 * t6329 + t6344 * t6705;
        t6831 = t6826 + t6361 * t6711 + t6390 * t6735 + t4657 * t6455 + t4639 * t6471
            + t3803 * t4653;
        t6836 = t6831 + t6488 * t6760 + t6508 * t6763 + t6541 * t6780 + t4152 * t6608
            + t4166 * t6618;
        t6841 = t6836 + self.constants[37] * t6044 + t241 * t6068
            + self.constants[33] * t6815 + self.constants[30] * t4696 + t286 * t4595;
        t6846 = t6841 - t1906 * t6246 - t3940 * t6283 - t3959 * t6297 - t4011 * t6319
            - t6378 * t6716;
        t6851 = t6846 - t6419 * t6751 - t4634 * t6465 - t3790 * t4673 - t6523 * t6767
            - t6576 * t6790;
        t6856 = t6851 - t4180 * t6622 - self.constants[32] * t6805
            - self.constants[31] * t4622 - t283 * t4535 - t1940 * t6690;
        t6864 = self.constants[3] * t6348;
        t6865 = self.constants[2] * t2214 + t6864;
        t6869 = self.constants[3] * t6369 - self.constants[2] * t6362;
        t6871 = self.constants[2] * t6368;
        t6873 = t6871 - self.constants[3] * t2205;
        t6876 = t6864 - t6871;
        t6882 = self.constants[3] * t2255 + t6402 * t6876 + self.constants[54] * t6869
            + t6402 * t6873;
        t6890 = t6430 * t6876 + self.constants[55] * t6869 - self.constants[2] * t2255
            - t6430 * t6865;
        t6901 = t3872 * t4711 - t3887 * t4709 - t3874 * t4707;
        t6907 = t4709 * t6581 - t3748 * t4711 - t3752 * t4707;
        t6919 = self.constants[2] * t2218 + t6390 * t6882 + t4764 * t6608
            + self.constants[37] * t6084 + t241 * t6100 + self.constants[33] * t6907;
        t6924 = t6919 + self.constants[30] * t5126 + t286 * t5110
            - self.constants[3] * t2248 - t4706 * t6297 - self.constants[77] * t6309;
        t6929 = t6924 - self.constants[76] * t6329 - t6344 * t6865 - t6361 * t6869
            - t6378 * t6873 - t6419 * t6890;
        t6934 = t6929 - t4768 * t6618 - t4776 * t6622 - self.constants[32] * t6901
            - self.constants[31] * t5142 - t283 * t5056;
        t6936 = t6934 - t2012 * t6690 - t2016 * t6856;
        t6948 = t5177 * t6346;
        t6949 = t5195 * t6348;
        t6951 = t2214 * t5191 + t6949 - t6948;
        t6957 = t5177 * t6366 + t5195 * t6369 - t5191 * t6362;
        t6959 = t5191 * t6368;
        t6962 = t6948 + t2205 * t5195 - t6959;
        t6971 = t6959 + t2237 * t5177 - t6949;
        t6979 = t2250 * t5177 + t5200 * t6397 + t5187 * t6400 + t6402 * t6971
            + t6402 * t6962 - t2255 * t5195;
        t6981 = t6979 - t5182 * t6395 - self.constants[54] * t6957;
        t6995 = t2255 * t5191 + t5182 * t6423 + t5200 * t6425 + t6430 * t6951
            + t6430 * t6971 - t2262 * t5177;
        t6997 = t6995 - t5187 * t6428 - self.constants[55] * t6957;
        t7004 = t2041 * t3764;
        t7006 = t2043 * t6494 - t7004;
        t7009 = t7004 - t2043 * t6513;
        t7013 = t2041 * t6526 - t2043 * t6530;
        t7020 = t2041 * t2173 + t2043 * t6560;
        t7027 = t6552 + t2041 * t6553 + t6557 * t7009 + t6557 * t7020 - t2043 * t6555
            - self.constants[40] * t7013;
        t7038 = t2041 * t6585 + t6588 * t7006 + t6588 * t7020 - t6584 - t2043 * t6546
            - self.constants[41] * t7013;
        t7053 = t2041 * t2349 + t2043 * t6628 + t3872 * t5235 + t3874 * t5207
            - t3887 * t5220;
        t7063 = t2041 * t3467 + t5220 * t6581 + t3752 * t5207 - t2043 * t6626
            - t3748 * t5235;
        t7076 = t6244 + t2041 * t6246 + t2043 * t6252 + t5177 * t6272 + t5182 * t6283
            + t5187 * t6293;
        t7081 = t7076 + t5251 * t6309 + t5263 * t6329 + t6344 * t6951 + t6361 * t6957
            + t6390 * t6981;
        t7086 = t7081 + t5914 * t6455 + t5890 * t6465 + t3803 * t5910 + t6488 * t7006
            + t6523 * t7013;
        t7091 = t7086 + t6541 * t7027 + t5402 * t6608 + t5416 * t6618
            + self.constants[37] * t6126 + t241 * t6150;
        t7096 = t7091 + self.constants[33] * t7063 + self.constants[30] * t5954
            + t286 * t5848 + t2094 * t6936 - t5203 * t6297;
        t7101 = t7096 - t5257 * t6319 - t6378 * t6962 - t6419 * t6997 - t5895 * t6471
            - t3790 * t5931;
        t7106 = t7101 - t6508 * t7009 - t6576 * t7038 - t5430 * t6622
            - self.constants[32] * t7053 - self.constants[31] * t5878;
        t7110 = t2131 * (t7106 - t283 * t5787 - t2072 * t6690 - t2088 * t6856);
        t7112 = t2024 * t6936 + t2094 * t7110;
        t7116 = t1958 * t6856 - t2016 * t7112 - t2088 * t7110;
        t7122 = t1295 * t6690 - t1940 * t7116 - t2012 * t7112 - t2072 * t7110;
        t7127 = t16 * t2541 + sin_phi * t3186 - t13 * t2561;
        t7135 = t16 * t3965 - t13 * t3977 - sin_phi * t4277 - t1940 * t7127;
        t7145 = t16 * t4707 + t13 * t4709 + sin_phi * t4711 + t2012 * t7127
            + t2016 * t7135;
        t7157 = t16 * t5210 + t13 * t5223 - sin_phi * t5528 - t2072 * t7127
            - t2088 * t7135 - t2094 * t7145;
        t7158 = t2131 * t7157;
        t7160 = t2094 * t7158 - t2024 * t7145;
        t7164 = t1958 * t7135 - t2016 * t7160 - t2088 * t7158;
        t7170 = t1295 * t7127 - t1940 * t7164 - t2012 * t7160 - t2072 * t7158;
        t7175 = t2175 - t1354;
        t7176 = t12 * t7175;
        t7178 = t7 * t7175;
        t7180 = t1301 * t1304;
        t7181 = t7180 - t2145;
        t7183 = t1354 + t1354;
        t7184 = t7 * t7183;
        t7186 = t12 * t7183;
        t7188 = t1324 - t7180;
        t7190 = cos_delta * t7188 - sin_delta * t7186;
        t7194 = cos_delta * t7186 + sin_delta * t7188;
        t7198 = t1301 * t1362 - speeds[0] * speeds[0];
        t7213 = self.constants[3] * t6572 - self.constants[2] * t6597;
        t7216 = self.constants[3] * t6637 + self.constants[2] * t6648;
        t7221 = self.constants[44] * t2148 + self.constants[41] * t2161 + t1231 * t3485
            + t3186 * t7181 + t2747 * t7184 + t2773 * t7190;
        t7226 = t7221 + t2795 * t7194 + t3239 * t7198 + t999 * t3157 + t446 * t3368
            + t64 * t3566;
        t7231 = t7226 + t1004 * t3447 + t651 * t3527 + self.constants[3] * t3903
            + t310 * t3734 + t7213;
        t7237 = t7231 + t7216 - t1806 - t2268 - t2331 - self.constants[40] * t2166
            - t2541 * t7176;
        t7242 = t7237 - t2561 * t7178 - t547 * t3440 - t537 * t3517
            - self.constants[2] * t3782 - t308 * t3630;
        t7266 = self.constants[3] * t6780 - self.constants[2] * t6790;
        t7269 = self.constants[3] * t6805 + self.constants[2] * t6815;
        t7274 = t1906 * t3485 + t4097 * t7184 + t4103 * t7190 + t4109 * t7194
            + t4293 * t7198 + t999 * t4264;
        t7279 = t7274 + t446 * t4358 + t64 * t4473 + t1004 * t4421 + t651 * t4444
            + self.constants[3] * t4696;
        t7284 = t7279 + t310 * t4595 + t7266 + t7269 - t3965 * t7176 - t3977 * t7178;
        t7289 = t7284 - t4277 * t7181 - t547 * t4415 - t537 * t4436
            - self.constants[2] * t4622 - t308 * t4535;
        t7290 = t7289 - t1940 * t7242;
        t7314 = self.constants[3] * t6901 + self.constants[2] * t6907;
        t7319 = t4707 * t7176 + t4741 * t7184 + t4745 * t7190 + t4749 * t7194
            + t4846 * t7198 + t999 * t4829;
        t7324 = t7319 + t446 * t4894 + t64 * t4997 + t1004 * t4949 + t651 * t4968
            + self.constants[3] * t5126;
        t7329 = t7324 + t310 * t5110 + t7314 - t4709 * t7178 - t4711 * t7181
            - t547 * t4945;
        t7334 = t7329 - t537 * t4962 - self.constants[2] * t5142 - t308 * t5056
            - t2012 * t7242 - t2016 * t7290;
        t7360 = self.constants[3] * t7027 - self.constants[2] * t7038;
        t7363 = self.constants[3] * t7053 + self.constants[2] * t7063;
        t7368 = t3485 + t5223 * t7178 + t5346 * t7184 + t5352 * t7190 + t5358 * t7194
            + t5544 * t7198;
        t7373 = t7368 + t999 * t5517 + t446 * t5611 + t64 * t5724 + t1004 * t5672
            + t651 * t5695;
        t7378 = t7373 + self.constants[3] * t5954 + t310 * t5848 + t2094 * t7334 + t7360
            + t7363;
        t7383 = t7378 - t2041 * t3485 - t5210 * t7176 - t5528 * t7181 - t547 * t5666
            - t537 * t5687;
        t7388 = t2131
            * (t7383 - self.constants[2] * t5878 - t308 * t5787 - t2072 * t7242
                - t2088 * t7290);
        t7390 = t2024 * t7334 + t2094 * t7388;
        t7394 = t1958 * t7290 - t2016 * t7390 - t2088 * t7388;
        t7400 = t1295 * t7242 - t1940 * t7394 - t2012 * t7390 - t2072 * t7388;
        t7401 = self.constants[7] * t2148;
        t7404 = t12 * t2179 - t7 * t2191;
        t7405 = self.constants[7] * t7404;
        t7407 = t7401 + t1231 * t7405;
        let (
            t7411, t7415, t7425, t7427, t7431, t7437, t7438, t7442, t7446, t7455, t7457, t7461,
            t7467, t7468, t7470, t7475, t7479, t7485, t7489, t7500, t7501, t7503, t7507, t7513,
            t7516, t7522, t7526, t7537, t7539, t7543, t7549, t7552, t7556, t7564, t7566, t7570,
            t7576, t7579, t7581, t7589, t7591, t7595, t7597, t7599, t7601, t7603, t7609, t7614,
            t7627, t7628, t7632, t7647, t7652, t7654, t7658, t7664, t7667, t7669, t7673, t7677,
            t7681, t7685, t7693, t7694, t7696, t7700, t7706, t7709, t7713, t7721, t7723, t7727,
            t7733, t7737, t7744, t7748, t7759, t7760, t7762, t7766, t7772, t7773, t7776, t7779,
            t7787, t7791, t7803, t7804, t7806, t7810, t7816, t7819, t7823, t7831, t7833, t7837,
            t7843, t7846, t7852, t7856, t7867, t7869, t7873, t7879, t7881, t7882, t7887, t7888,
            t7890, t7891, t7893, t7902, t7903, t7909, t7921, t7923, t7927, t7934, t7948, t7953,
            t7955, t7959, t7965, t7967, t7970, t7973, t7978, t7982, t7985, t7994, t7995, t7997,
            t8001, t8007, t8010, t8014, t8022, t8024, t8028, t8034, t8038, t8045, t8049, t8060,
            t8061, t8063, t8067, t8073, t8078, t8086, t8090, t8102, t8103, t8105, t8109, t8115,
            t8118, t8124, t8132, t8138, t8155, t8160, t8164, t8187, t8192, t8197, t8198, t8220,
            t8225, t8230, t8254, t8259, t8264, t8267, t8269, t8273, t8279, t8280, t8282, t8283,
            t8285, t8294, t8295, t8308, t8310, t8314, t8329, t8334, t8336, t8340, t8346, t8347,
            t8351, t8355, t8364, t8366, t8370, t8376, t8377, t8379, t8383, t8391, t8395, t8407,
            t8408, t8410, t8414, t8420, t8423, t8424, t8428, t8431, t8435, t8440, t8444, t8452,
            t8454, t8458, t8464, t8465, t8469, t8471, t8476, t8481, t8486, t8488, t8490, t8491,
            t8493, t8500, t8504, t8521, t8526, t8540, t8542, t8561, t8566, t8569, t8571, t8575,
            t8581, t8584, t8590, t8598, t8609, t8611, t8615, t8621, t8624, t8629,
        );
        t7411 = t1906 * t7405 - t1940 * t7407;
        t7415 = t2012 * t7407 + t2016 * t7411;
        t7425 = t2131
            * (t7405 - t2041 * t7405 - t2072 * t7407 - t2088 * t7411 - t2094 * t7415);
        t7427 = t2094 * t7425 - t2024 * t7415;
        t7431 = t1958 * t7411 - t2016 * t7427 - t2088 * t7425;
        t7437 = t1295 * t7407 - t1940 * t7431 - t2012 * t7427 - t2072 * t7425;
        t7438 = t6498 + t6517;
        t7442 = t6760 - t6763 - t1940 * t7438;
        t7446 = t2012 * t7438 + t2016 * t7442;
        t7455 = t2131 * (t7006 + t7009 - t2072 * t7438 - t2088 * t7442 - t2094 * t7446);
        t7457 = t2094 * t7455 - t2024 * t7446;
        t7461 = t1958 * t7442 - t2016 * t7457 - t2088 * t7455;
        t7467 = t1295 * t7438 - t1940 * t7461 - t2012 * t7457 - t2072 * t7455;
        t7468 = t1310 * t1315;
        t7470 = t1306 * t1315;
        t7475 = t7 * t7468 + t12 * t7470;
        t7479 = t12 * t7468 + t1242 * t7475 - t7 * t7470 - t1231 * t2175;
        t7485 = t1908 * t7475 - t1906 * t2175 - t1940 * t7479;
        t7489 = t2012 * t7479 + t2016 * t7485;
        t7500 = t2041 * t2175 + t2043 * t7475 - t2175 - t2072 * t7479 - t2088 * t7485
            - t2094 * t7489;
        t7501 = t2131 * t7500;
        t7503 = t2094 * t7501 - t2024 * t7489;
        t7507 = t1958 * t7485 - t2016 * t7503 - t2088 * t7501;
        t7513 = t1295 * t7479 - t1940 * t7507 - t2012 * t7503 - t2072 * t7501;
        t7516 = self.constants[2] * t6572 + self.constants[3] * t6597;
        t7522 = self.constants[2] * t6780 + self.constants[3] * t6790 - t1940 * t7516;
        t7526 = t2012 * t7516 + t2016 * t7522;
        t7537 = t2131
            * (self.constants[2] * t7027 + self.constants[3] * t7038 - t2072 * t7516
                - t2088 * t7522 - t2094 * t7526);
        t7539 = t2094 * t7537 - t2024 * t7526;
        t7543 = t1958 * t7522 - t2016 * t7539 - t2088 * t7537;
        t7549 = t1295 * t7516 - t1940 * t7543 - t2012 * t7539 - t2072 * t7537;
        t7552 = t7266 - t1940 * t7213;
        t7556 = t2012 * t7213 + t2016 * t7552;
        t7564 = t2131 * (t7360 - t2072 * t7213 - t2088 * t7552 - t2094 * t7556);
        t7566 = t2094 * t7564 - t2024 * t7556;
        t7570 = t1958 * t7552 - t2016 * t7566 - t2088 * t7564;
        t7576 = t1295 * t7213 - t1940 * t7570 - t2012 * t7566 - t2072 * t7564;
        t7579 = t2148 * t6576;
        t7581 = t2148 * t6541;
        t7589 = self.constants[7] * (t7404 + t6550 * t6576 - t6541 * t6583);
        t7591 = t2179 * t6576 + t2191 * t6541 - t7589;
        t7595 = t7 * t7579 + t12 * t7581;
        t7597 = t6541 * t6541;
        t7599 = t6576 * t6576;
        t7601 = t7597 + t7599;
        t7603 = t6541 * t6576;
        t7609 = t7401 + t7 * t7581 + t6498 * t7597 + t6517 * t7599 + t6564 * t7601
            + t6534 * t7603;
        t7614 = t7609 - t6543 * t6576 - t6541 * t6577 - t12 * t7579 - t1231 * t7591
            - t1242 * t7595;
        t7627 = t6760 * t7597 + t6774 * t7601 + t6767 * t7603 - t1906 * t7591
            - t1908 * t7595 - t6763 * t7599;
        t7628 = t7627 - t1940 * t7614;
        t7632 = t2012 * t7614 + t2016 * t7628;
        t7647 = t7589 + t2041 * t7591 + t7006 * t7597 + t7009 * t7599 + t7020 * t7601
            - t2043 * t7595;
        t7652 = t2131
            * (t7647 - t7013 * t7603 - t2072 * t7614 - t2088 * t7628 - t2094 * t7632);
        t7654 = t2094 * t7652 - t2024 * t7632;
        t7658 = t1958 * t7628 - t2016 * t7654 - t2088 * t7652;
        t7664 = t1295 * t7614 - t1940 * t7658 - t2012 * t7654 - t2072 * t7652;
        t7667 = self.constants[35] * t6534;
        t7669 = self.constants[36] * t6498 + self.constants[34] * t6517 - t7667;
        t7673 = self.constants[35] * t6767;
        t7677 = self.constants[36] * t6760 - self.constants[34] * t6763 - t7673
            - t1940 * t7669;
        t7681 = t2012 * t7669 + t2016 * t7677;
        t7685 = self.constants[35] * t7013;
        t7693 = self.constants[36] * t7006 + self.constants[34] * t7009 + t7685
            - t2072 * t7669 - t2088 * t7677 - t2094 * t7681;
        t7694 = t2131 * t7693;
        t7696 = t2094 * t7694 - t2024 * t7681;
        t7700 = t1958 * t7677 - t2016 * t7696 - t2088 * t7694;
        t7706 = t1295 * t7669 - t1940 * t7700 - t2012 * t7696 - t2072 * t7694;
        t7709 = t6774 - t1940 * t6564;
        t7713 = t2012 * t6564 + t2016 * t7709;
        t7721 = t2131 * (t7020 - t2072 * t6564 - t2088 * t7709 - t2094 * t7713);
        t7723 = t2094 * t7721 - t2024 * t7713;
        t7727 = t1958 * t7709 - t2016 * t7723 - t2088 * t7721;
        t7733 = t1295 * t6564 - t1940 * t7727 - t2012 * t7723 - t2072 * t7721;
        t7737 = t7667 + self.constants[34] * t6498 + self.constants[36] * t6517;
        t7744 = t7673 + self.constants[34] * t6760 - self.constants[36] * t6763
            - t1940 * t7737;
        t7748 = t2012 * t7737 + t2016 * t7744;
        t7759 = self.constants[34] * t7006 + self.constants[36] * t7009 - t7685
            - t2072 * t7737 - t2088 * t7744 - t2094 * t7748;
        t7760 = t2131 * t7759;
        t7762 = t2094 * t7760 - t2024 * t7748;
        t7766 = t1958 * t7744 - t2016 * t7762 - t2088 * t7760;
        t7772 = t1295 * t7737 - t1940 * t7766 - t2012 * t7762 - t2072 * t7760;
        t7773 = self.constants[35] + self.constants[35];
        t7776 = self.constants[34] - self.constants[36];
        t7779 = t6498 * t7773 - t6517 * t7773 - t6534 * t7776;
        t7787 = t6760 * t7773 + t6763 * t7773 - t6767 * t7776 - t1940 * t7779;
        t7791 = t2012 * t7779 + t2016 * t7787;
        t7803 = t7006 * t7773 + t7013 * t7776 - t7009 * t7773 - t2072 * t7779
            - t2088 * t7787 - t2094 * t7791;
        t7804 = t2131 * t7803;
        t7806 = t2094 * t7804 - t2024 * t7791;
        t7810 = t1958 * t7787 - t2016 * t7806 - t2088 * t7804;
        t7816 = t1295 * t7779 - t1940 * t7810 - t2012 * t7806 - t2072 * t7804;
        t7819 = t4675 - t1940 * t3868;
        t7823 = t2012 * t3868 + t2016 * t7819;
        t7831 = t2131 * (t5933 - t2072 * t3868 - t2088 * t7819 - t2094 * t7823);
        t7833 = t2094 * t7831 - t2024 * t7823;
        t7837 = t1958 * t7819 - t2016 * t7833 - t2088 * t7831;
        t7843 = t1295 * t3868 - t1940 * t7837 - t2012 * t7833 - t2072 * t7831;
        t7846 = self.constants[3] * t3840 - self.constants[2] * t3866;
        t7852 = self.constants[3] * t4653 - self.constants[2] * t4673 - t1940 * t7846;
        t7856 = t2012 * t7846 + t2016 * t7852;
        t7867 = t2131
            * (self.constants[3] * t5910 - self.constants[2] * t5931 - t2072 * t7846
                - t2088 * t7852 - t2094 * t7856);
        t7869 = t2094 * t7867 - t2024 * t7856;
        t7873 = t1958 * t7852 - t2016 * t7869 - t2088 * t7867;
        t7879 = t1295 * t7846 - t1940 * t7873 - t2012 * t7869 - t2072 * t7867;
        t7881 = t2299 * t2637;
        t7882 = self.constants[30] * t2299 + t7881;
        t7887 = t1231 * t7882 + t2280 * t2433 + t2295 * t2450;
        t7888 = t3803 * t3803;
        t7890 = t3790 * t3790;
        t7891 = t7888 + t7890;
        t7893 = t3790 * t3803;
        t7902 = t7887 + t3845 * t7888 + t3799 * t7891 + t3814 * t7893 + t3790 * t3836
            + t3803 * t3862;
        t7903 = t7902 - t3820 * t7890;
        t7909 = t1906 * t7882 + t2280 * t3924 + t2295 * t3928;
        t7921 = t7909 + t4657 * t7888 + t4628 * t7891 + t4634 * t7893 + t3790 * t4649
            + t3803 * t4669;
        t7923 = t7921 - t4639 * t7890 - t1940 * t7903;
        t7927 = t2012 * t7903 + t2016 * t7923;
        t7934 = t7881 + t2280 * t5164 + t2295 * t5169 - t2041 * t7882;
        t7948 = t7934 + t5914 * t7888 + t5884 * t7891 + t5895 * t7890 + t3790 * t5906
            + t3803 * t5927;
        t7953 = t2131
            * (t7948 - t5890 * t7893 - t2072 * t7903 - t2088 * t7923 - t2094 * t7927);
        t7955 = t2094 * t7953 - t2024 * t7927;
        t7959 = t1958 * t7923 - t2016 * t7955 - t2088 * t7953;
        t7965 = t1295 * t7903 - t1940 * t7959 - t2012 * t7955 - t2072 * t7953;
        t7967 = self.constants[35] * t3814;
        t7970 = self.constants[36] * t3845 - t7967 - self.constants[34] * t3820;
        t7973 = self.constants[35] * t4634;
        t7978 = self.constants[36] * t4657 - t7973 - self.constants[34] * t4639
            - t1940 * t7970;
        t7982 = t2012 * t7970 + t2016 * t7978;
        t7985 = self.constants[35] * t5890;
        t7994 = self.constants[36] * t5914 + t7985 + self.constants[34] * t5895
            - t2072 * t7970 - t2088 * t7978 - t2094 * t7982;
        t7995 = t2131 * t7994;
        t7997 = t2094 * t7995 - t2024 * t7982;
        t8001 = t1958 * t7978 - t2016 * t7997 - t2088 * t7995;
        t8007 = t1295 * t7970 - t1940 * t8001 - t2012 * t7997 - t2072 * t7995;
        t8010 = t4628 - t1940 * t3799;
        t8014 = t2012 * t3799 + t2016 * t8010;
        t8022 = t2131 * (t5884 - t2072 * t3799 - t2088 * t8010 - t2094 * t8014);
        t8024 = t2094 * t8022 - t2024 * t8014;
        t8028 = t1958 * t8010 - t2016 * t8024 - t2088 * t8022;
        t8034 = t1295 * t3799 - t1940 * t8028 - t2012 * t8024 - t2072 * t8022;
        t8038 = t7967 + self.constants[34] * t3845 - self.constants[36] * t3820;
        t8045 = t7973 + self.constants[34] * t4657 - self.constants[36] * t4639
            - t1940 * t8038;
        t8049 = t2012 * t8038 + t2016 * t8045;
        t8060 = self.constants[34] * t5914 + self.constants[36] * t5895 - t7985
            - t2072 * t8038 - t2088 * t8045 - t2094 * t8049;
        t8061 = t2131 * t8060;
        t8063 = t2094 * t8061 - t2024 * t8049;
        t8067 = t1958 * t8045 - t2016 * t8063 - t2088 * t8061;
        t8073 = t1295 * t8038 - t1940 * t8067 - t2012 * t8063 - t2072 * t8061;
        t8078 = t3845 * t7773 + t3820 * t7773 - t3814 * t7776;
        t8086 = t4657 * t7773 + t4639 * t7773 - t4634 * t7776 - t1940 * t8078;
        t8090 = t2012 * t8078 + t2016 * t8086;
        t8102 = t5914 * t7773 + t5890 * t7776 - t5895 * t7773 - t2072 * t8078
            - t2088 * t8086 - t2094 * t8090;
        t8103 = t2131 * t8102;
        t8105 = t2094 * t8103 - t2024 * t8090;
        t8109 = t1958 * t8086 - t2016 * t8105 - t2088 * t8103;
        t8115 = t1295 * t8078 - t1940 * t8109 - t2012 * t8105 - t2072 * t8103;
        t8118 = t1775 * t2383 + t1030 * t3159;
        t8124 = t1379 * t1441 - t30 * t1434 - t1407 * t1437;
        t8132 = t30 * t1396 + t1370 * t1407 + t1379 * t1410 - t27 * t1400;
        t8138 = t27 * t1434 - t1410 * t1437 - t1370 * t1441;
        t8155 = t1283 * t8118 + t2747 * t8124 + t2773 * t8132 + t2795 * t8138
            + t1038 * t3163 + t664 * t3374;
        t8160 = t8155 + t319 * t3594 + self.constants[2] * t6022 + t329 * t3734
            - t1031 * t3155 - t1036 * t3157;
        t8164 = t8160 - t1044 * t3436 - t317 * t3578 - self.constants[3] * t5995
            - t327 * t3630;
        t8187 = t1030 * t2313 + t1930 * t8118 + t4097 * t8124 + t4103 * t8132
            + t4109 * t8138 + t1038 * t4270;
        t8192 = t8187 + t664 * t4365 + t319 * t4500 + self.constants[2] * t6068
            + t329 * t4595 - t1031 * t4262;
        t8197 = t8192 - t1036 * t4264 - t1044 * t4411 - t317 * t4485
            - self.constants[3] * t6044 - t327 * t4535;
        t8198 = t8197 - t1940 * t8164;
        t8220 = t4741 * t8124 + t4745 * t8132 + t4749 * t8138 + t1038 * t4831
            + t664 * t4900 + t319 * t5024;
        t8225 = t8220 + self.constants[2] * t6100 + t329 * t5110 - t1031 * t4828
            - t1036 * t4829 - t1044 * t4942;
        t8230 = t8225 - t317 * t5009 - self.constants[3] * t6084 - t327 * t5056
            - t2012 * t8164 - t2016 * t8198;
        t8254 = t2065 * t8118 + t5346 * t8124 + t5352 * t8132 + t5358 * t8138
            + t1038 * t5521 + t664 * t5617;
        t8259 = t8254 + t319 * t5751 + self.constants[2] * t6150 + t329 * t5848
            + t2094 * t8230 - t1031 * t5514;
        t8264 = t8259 - t1036 * t5517 - t1044 * t5662 - t317 * t5736
            - self.constants[3] * t6126 - t327 * t5787;
        t8267 = t2131 * (t8264 - t2072 * t8164 - t2088 * t8198);
        t8269 = t2024 * t8230 + t2094 * t8267;
        t8273 = t1958 * t8198 - t2016 * t8269 - t2088 * t8267;
        t8279 = t1295 * t8164 - t1940 * t8273 - t2012 * t8269 - t2072 * t8267;
        t8280 = self.constants[37] * self.constants[37];
        t8282 = self.constants[38] * self.constants[38];
        t8283 = t8280 + t8282;
        t8285 = self.constants[37] * self.constants[38];
        t8294 = t7887 + t3845 * t8280 + t3799 * t8283 + t3814 * t8285
            + self.constants[38] * t3836 + self.constants[37] * t3862;
        t8295 = t8294 - t3820 * t8282;
        t8308 = t7909 + t4657 * t8280 + t4628 * t8283 + t4634 * t8285
            + self.constants[38] * t4649 + self.constants[37] * t4669;
        t8310 = t8308 - t4639 * t8282 - t1940 * t8295;
        t8314 = t2012 * t8295 + t2016 * t8310;
        t8329 = t7934 + t5914 * t8280 + t5884 * t8283 + t5895 * t8282
            + self.constants[38] * t5906 + self.constants[37] * t5927;
        t8334 = t2131
            * (t8329 - t5890 * t8285 - t2072 * t8295 - t2088 * t8310 - t2094 * t8314);
        t8336 = t2094 * t8334 - t2024 * t8314;
        t8340 = t1958 * t8310 - t2016 * t8336 - t2088 * t8334;
        t8346 = t1295 * t8295 - t1940 * t8340 - t2012 * t8336 - t2072 * t8334;
        t8347 = t3845 - t3820;
        t8351 = t4657 - t4639 - t1940 * t8347;
        t8355 = t2012 * t8347 + t2016 * t8351;
        t8364 = t2131 * (t5895 + t5914 - t2072 * t8347 - t2088 * t8351 - t2094 * t8355);
        t8366 = t2094 * t8364 - t2024 * t8355;
        t8370 = t1958 * t8351 - t2016 * t8366 - t2088 * t8364;
        t8376 = t1295 * t8347 - t1940 * t8370 - t2012 * t8366 - t2072 * t8364;
        t8377 = t1379 * t1437;
        t8379 = t1370 * t1437;
        t8383 = t2406 * t8377 + t2414 * t8379 - t1283 * t2312;
        t8391 = t3916 * t8377 + t3920 * t8379 - t1930 * t2312 - t1940 * t8383;
        t8395 = t2012 * t8383 + t2016 * t8391;
        t8407 = t5155 * t8377 - t5159 * t8379 - t2065 * t2312 - t2072 * t8383
            - t2088 * t8391 - t2094 * t8395;
        t8408 = t2131 * t8407;
        t8410 = t2094 * t8408 - t2024 * t8395;
        t8414 = t1958 * t8391 - t2016 * t8410 - t2088 * t8408;
        t8420 = t1295 * t8383 - t1940 * t8414 - t2012 * t8410 - t2072 * t8408;
        t8423 = self.constants[2] * t6440 - self.constants[3] * t6415;
        t8424 = t7216 + t8423;
        t8428 = self.constants[2] * t6751 - self.constants[3] * t6735;
        t8431 = t7269 + t8428 - t1940 * t8424;
        t8435 = self.constants[2] * t6890 - self.constants[3] * t6882;
        t8440 = t7314 + t8435 - t2012 * t8424 - t2016 * t8431;
        t8444 = self.constants[2] * t6997 - self.constants[3] * t6981;
        t8452 = t2131 * (t7363 + t8444 + t2094 * t8440 - t2072 * t8424 - t2088 * t8431);
        t8454 = t2024 * t8440 + t2094 * t8452;
        t8458 = t1958 * t8431 - t2016 * t8454 - t2088 * t8452;
        t8464 = t1295 * t8424 - t1940 * t8458 - t2012 * t8454 - t2072 * t8452;
        t8465 = t2196 * t6390;
        t8469 = t2224 * t6419 - t2230 * t6390;
        t8471 = t2196 * t6419;
        t8476 = t2230 + t6390 * t6422 - t6394 * t6419;
        t8481 = t2196 + t6362 * t6419 + t6369 * t6390;
        t8486 = t2224 + t6399 * t6419 - t6390 * t6427;
        t8488 = t6390 * t6390;
        t8490 = t6419 * t6419;
        t8491 = t8488 + t8490;
        t8493 = t6390 * t6419;
        t8500 = t2513 * t8465 + t2467 * t8469 + t2532 * t8481 + t2506 * t8486
            + t6351 * t8488 + t6405 * t8491;
        t8504 = t8500 + t6382 * t8490 - t2520 * t8471 - t2490 * t8476 - t6372 * t8493;
        t8521 = t3948 * t8465 + t3936 * t8469 + t3956 * t8481 + t3944 * t8486
            + t6705 * t8488 + t6725 * t8491;
        t8526 = t8521 + t6716 * t8490 - t3952 * t8471 - t3940 * t8476 - t6711 * t8493
            - t1940 * t8504;
        t8540 = self.constants[3] * t8471 + t6876 * t8491 + t6869 * t8493 + t6873 * t8490
            - self.constants[2] * t8465 - t6865 * t8488;
        t8542 = t8540 - t2012 * t8504 - t2016 * t8526;
        t8561 = t5191 * t8465 + t5177 * t8469 + t5182 * t8476 + t5200 * t8481
            + t5187 * t8486 + t6951 * t8488;
        t8566 = t8561 + t6971 * t8491 + t6962 * t8490 + t2094 * t8542 - t5195 * t8471
            - t6957 * t8493;
        t8569 = t2131 * (t8566 - t2072 * t8504 - t2088 * t8526);
        t8571 = t2024 * t8542 + t2094 * t8569;
        t8575 = t1958 * t8526 - t2016 * t8571 - t2088 * t8569;
        t8581 = t1295 * t8504 - t1940 * t8575 - t2012 * t8571 - t2072 * t8569;
        t8584 = self.constants[2] * t6415 + self.constants[3] * t6440;
        t8590 = self.constants[2] * t6735 + self.constants[3] * t6751 - t1940 * t8584;
        t8598 = self.constants[2] * t6882 + self.constants[3] * t6890 - t2012 * t8584
            - t2016 * t8590;
        t8609 = t2131
            * (self.constants[2] * t6981 + self.constants[3] * t6997 + t2094 * t8598
                - t2072 * t8584 - t2088 * t8590);
        t8611 = t2024 * t8598 + t2094 * t8609;
        t8615 = t1958 * t8590 - t2016 * t8611 - t2088 * t8609;
        t8621 = t1295 * t8584 - t1940 * t8615 - t2012 * t8611 - t2072 * t8609;
        t8624 = t1940 * t8423 - t8428;
        t8629 = t2012 * t8423 - t8435 - t2016 * t8624;
        let (
            t8637, t8639, t8643, t8651, t8654, t8657, t8662, t8665, t8672, t8675, t8684, t8685,
            t8687, t8691, t8697, t8700, t8705, t8713, t8715, t8719, t8725, t8729, t8736, t8745,
            t8756, t8757, t8759, t8763, t8769, t8774, t8782, t8792, t8804, t8805, t8807, t8811,
            t8817, t8819, t8820, t8822, t8825, t8830, t8832, t8834, t8837, t8842, t8843, t8844,
            t8845, t8846, t8847,
        );
        t8637 = t2131 * (t2072 * t8423 + t2094 * t8629 - t8444 - t2088 * t8624);
        t8639 = t2024 * t8629 + t2094 * t8637;
        t8643 = t1958 * t8624 - t2016 * t8639 - t2088 * t8637;
        t8651 = self.constants[35] * t6372;
        t8654 = self.constants[36] * t6351 + t8651 + self.constants[34] * t6382;
        t8657 = self.constants[35] * t6711;
        t8662 = self.constants[36] * t6705 + t8657 + self.constants[34] * t6716
            - t1940 * t8654;
        t8665 = self.constants[35] * t6869;
        t8672 = self.constants[34] * t6873 - self.constants[36] * t6865 - t8665
            - t2012 * t8654 - t2016 * t8662;
        t8675 = self.constants[35] * t6957;
        t8684 = self.constants[36] * t6951 + t8675 + self.constants[34] * t6962
            + t2094 * t8672 - t2072 * t8654 - t2088 * t8662;
        t8685 = t2131 * t8684;
        t8687 = t2024 * t8672 + t2094 * t8685;
        t8691 = t1958 * t8662 - t2016 * t8687 - t2088 * t8685;
        t8697 = t1295 * t8654 - t1940 * t8691 - t2012 * t8687 - t2072 * t8685;
        t8700 = t6725 - t1940 * t6405;
        t8705 = t6876 - t2012 * t6405 - t2016 * t8700;
        t8713 = t2131 * (t6971 + t2094 * t8705 - t2072 * t6405 - t2088 * t8700);
        t8715 = t2024 * t8705 + t2094 * t8713;
        t8719 = t1958 * t8700 - t2016 * t8715 - t2088 * t8713;
        t8725 = t1295 * t6405 - t1940 * t8719 - t2012 * t8715 - t2072 * t8713;
        t8729 = self.constants[34] * t6351 + self.constants[36] * t6382 - t8651;
        t8736 = self.constants[34] * t6705 + self.constants[36] * t6716 - t8657
            - t1940 * t8729;
        t8745 = t8665 + self.constants[36] * t6873 - self.constants[34] * t6865
            - t2012 * t8729 - t2016 * t8736;
        t8756 = self.constants[34] * t6951 + self.constants[36] * t6962 + t2094 * t8745
            - t8675 - t2072 * t8729 - t2088 * t8736;
        t8757 = t2131 * t8756;
        t8759 = t2024 * t8745 + t2094 * t8757;
        t8763 = t1958 * t8736 - t2016 * t8759 - t2088 * t8757;
        t8769 = t1295 * t8729 - t1940 * t8763 - t2012 * t8759 - t2072 * t8757;
        t8774 = t6351 * t7773 + t6372 * t7776 - t6382 * t7773;
        t8782 = t6705 * t7773 + t6711 * t7776 - t6716 * t7773 - t1940 * t8774;
        t8792 = t6865 * t7773 + t6869 * t7776 + t6873 * t7773 + t2012 * t8774
            + t2016 * t8782;
        t8804 = t6951 * t7773 + t6957 * t7776 - t6962 * t7773 - t2072 * t8774
            - t2088 * t8782 - t2094 * t8792;
        t8805 = t2131 * t8804;
        t8807 = t2094 * t8805 - t2024 * t8792;
        t8811 = t1958 * t8782 - t2016 * t8807 - t2088 * t8805;
        t8817 = t1295 * t8774 - t1940 * t8811 - t2012 * t8807 - t2072 * t8805;
        t8819 = t2094 * t2131;
        t8820 = positions[6] * t8819;
        t8822 = positions[6] * t2024 + t2094 * t8820;
        t8825 = t2016 * t8822 + t2088 * t8820;
        t8830 = t2012 * t8822 + t2072 * t8820 - t1940 * t8825;
        t8832 = speeds[2] * t8819;
        t8834 = speeds[2] * t2024 + t2094 * t8832;
        t8837 = t2016 * t8834 + t2088 * t8832;
        t8842 = t2012 * t8834 + t2072 * t8832 - t1940 * t8837;
        t8843 = -(t1295 * t8423 + t1940 * t8643 + t2012 * t8639 + t2072 * t8637);
        t8844 = -t8822;
        t8845 = -t8834;
        t8846 = -t8820;
        t8847 = -t8832;
        [
            [
                t212, t233, t292, zero, t316, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, t335, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                t392, t405, t416, zero, t427, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, t438, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                t620, t636, t647, zero, t663, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, t677, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                t730, t743, t754, zero, t763, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, t774, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                t969, t987, t998, zero, t1021, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, t1062, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                t5975, t6176, t7122, t7170, t7400, t7437, t7467, t7513, t7549, t7576, t7664, t7706,
                t7733, t7772, t7816, t7843, t7879, t7965, t8007, t8034, t8073, t8115, t8279, t8346,
                t8376, t8420, t8464, t8581, t8621, t8843, t8697, t8725, t8769, t8817, t8830, t8842,
            ],
            [
                t5969, t6170, t7116, t7164, t7394, t7431, t7461, t7507, t7543, t7570, t7658, t7700,
                t7727, t7766, t7810, t7837, t7873, t7959, t8001, t8028, t8067, t8109, t8273, t8340,
                t8370, t8414, t8458, t8575, t8615, t8643, t8691, t8719, t8763, t8811, t8825, t8837,
            ],
            [
                t5965, t6166, t7112, t7160, t7390, t7427, t7457, t7503, t7539, t7566, t7654, t7696,
                t7723, t7762, t7806, t7833, t7869, t7955, t7997, t8024, t8063, t8105, t8269, t8336,
                t8366, t8410, t8454, t8571, t8611, t8639, t8687, t8715, t8759, t8807, t8844, t8845,
            ],
            [
                t5963, t6164, t7110, t7158, t7388, t7425, t7455, t7501, t7537, t7564, t7652, t7694,
                t7721, t7760, t7804, t7831, t7867, t7953, t7995, t8022, t8061, t8103, t8267, t8334,
                t8364, t8408, t8452, t8569, t8609, t8637, t8685, t8713, t8757, t8805, t8846, t8847,
            ],
        ]
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`WhippleLeaning`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleLeaningDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 163],
}

impl<T: Number> WhippleLeaning<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 113 additions, 224 multiplications, 3 divisions, 5 negations and 2 trigonometric functions: 347 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WhippleLeaningMatrices<T>, WhippleLeaningDerivatives<T>) {
        let zero = self.w.like(0.0);
        let mut matrices = WhippleLeaningMatrices::from_entries([zero; 54]);
        let mut derivatives = WhippleLeaningDerivatives {
            values: [zero; 163],
        };
        self.each_result(
            #[inline(always)]
            |position, value| matrices.set_entry(position, value),
            #[inline(always)]
            |position, value| derivatives.values[position] = value,
        );
        (matrices, derivatives)
    }

    /// Writes the coefficient matrices and their derivatives over others, each as soon as it is computed.
    ///
    /// They are those of [`Self::matrices_and_derivatives`], to the last bit. That function has more results than a
    /// processor has registers, and moves them twice.
    #[inline(always)]
    pub fn write_matrices_and_derivatives(
        &self,
        matrices: &mut WhippleLeaningMatrices<T>,
        derivatives: &mut WhippleLeaningDerivatives<T>,
    ) {
        *matrices = WhippleLeaningMatrices::from_entries([self.w.like(0.0); 54]);
        self.each_result(
            #[inline(always)]
            |position, value| {
                matrices.set_entry(position, value);
                carvallo::write_now();
            },
            #[inline(always)]
            |position, value| {
                derivatives.values[position] = value;
                carvallo::write_now();
            },
        );
    }

    /// The program: gives each entry that differs, and each value of the derivatives, to a function with its position.
    #[inline(always)]
    fn each_result(&self, mut put_entry: impl FnMut(usize, T), mut put_derivative: impl FnMut(usize, T)) {
        put_entry(6, self.dU);
        put_entry(11, self.kU);
        put_derivative(0, self.rR);
        put_derivative(1, self.mR);
        put_derivative(2, self.zB);
        put_derivative(3, self.mB);
        put_derivative(4, self.zH);
        put_derivative(5, self.mH);
        put_derivative(6, self.rF);
        put_derivative(7, self.mF);
        put_derivative(8, self.mU);
        put_derivative(9, self.zU);
        put_derivative(10, self.w.like(1.0));
        let (wx_delta2_delta, wx_delta2_delta_lam) = self.lam.sin_cos();
        put_derivative(11, wx_delta2_delta);
        let M_11_mR = self.rR * self.rR;
        put_derivative(12, M_11_mR);
        let t37 = self.zH * self.mH;
        let t38 = self.rF * self.mF;
        let t43 = self.IHxx + self.IFxx + self.zH * t37 + self.rF * t38;
        let t44 = self.zU * self.mU;
        put_derivative(13, t44);
        let M_11_mB = self.zB * self.zB;
        put_derivative(14, M_11_mB);
        let M_11_zH = t37 + t37;
        put_derivative(15, M_11_zH);
        let M_11_mH = self.zH * self.zH;
        put_derivative(16, M_11_mH);
        let M_11_rF = t38 + t38;
        put_derivative(17, M_11_rF);
        let M_11_mF = self.rF * self.rF;
        put_derivative(18, M_11_mF);
        let M_11_mU = self.zU * self.zU;
        put_derivative(19, M_11_mU);
        let M_11_zU = t44 + t44;
        put_derivative(20, M_11_zU);
        let t52 = self.zB * self.mB;
        let M_11_zB = t52 + t52;
        put_derivative(21, M_11_zB);
        let t54 = self.w.like(1.0) / self.w;
        let t56 = t37 * self.xH - self.IHxz;
        let t63 = self.mR * M_11_mR + t43 + self.IRxx + self.IUxx + self.zU * t44
            + self.IBxx;
        let M_11 = t63 + self.zB * t52;
        put_entry(0, M_11);
        let t66 = self.c * t54;
        let t67 = self.c + self.w;
        let t68 = self.mB * self.xB;
        let t73 = self.zB * t68 + t44 * self.xU - self.IBxz - self.IUxz;
        let K0_13_mU = self.zU - self.zP;
        put_derivative(22, K0_13_mU);
        let M_13_mU = self.zU * K0_13_mU;
        put_derivative(23, M_13_mU);
        let M_33_mU = K0_13_mU * K0_13_mU;
        put_derivative(24, M_33_mU);
        let K0_13 = self.mU * K0_13_mU;
        put_entry(14, K0_13);
        let M_13 = self.IUxx + self.zU * K0_13;
        put_entry(2, M_13);
        let M_33 = self.IUxx + K0_13_mU * K0_13;
        put_entry(5, M_33);
        let M_33_zU = K0_13 + K0_13;
        put_derivative(25, M_33_zU);
        let M_13_zU = t44 + K0_13;
        put_derivative(26, M_13_zU);
        let t84 = self.mH * self.xH;
        let vy_theta3_delta = self.xH * t84;
        let t87 = self.IFxx + self.IHzz + vy_theta3_delta;
        let h_wheels_all = self.mU * self.xU;
        let t94 = self.IRxx + self.IUzz + self.xB * t68 + self.IBzz
            + self.xU * h_wheels_all;
        let yaw_by_delta = wx_delta2_delta_lam * t66;
        put_derivative(27, yaw_by_delta);
        let t96 = wx_delta2_delta_lam * t67;
        let t97 = t56 * wx_delta2_delta;
        let t98 = self.zH * wx_delta2_delta;
        let t100 = self.IUxz - K0_13_mU * h_wheels_all;
        let t101 = self.w.like(1.0) / self.rF;
        let t102 = t56 + t73;
        let t103 = t38 * self.w;
        let C1_12_mR = self.rR * yaw_by_delta;
        put_derivative(28, C1_12_mR);
        let wz_delta2_delta = wx_delta2_delta_lam + yaw_by_delta;
        put_derivative(29, wz_delta2_delta);
        let t106 = t96 + t98;
        let M_23 = yaw_by_delta * t100;
        put_entry(4, M_23);
        let h_spin_F = self.IFyy * t101;
        let t109 = self.mR * self.rR;
        let M_11_rR = t109 + t109;
        put_derivative(30, M_11_rR);
        let t111 = t37 - t38;
        let K0_11 = t44 + t52 + t111 - t109;
        put_entry(12, K0_11);
        let t115 = t54 * M_23;
        put_derivative(31, t115);
        let t118 = wx_delta2_delta_lam * t111 + wx_delta2_delta * t84;
        let t119 = t37 * wz_delta2_delta;
        put_derivative(32, t119);
        let t124 = t43 * wx_delta2_delta + t37 * t96 - wz_delta2_delta * t56;
        let t128 = t97 + t96 * t84 - wz_delta2_delta * t87;
        let M_22_yaw_per_v_delta = t37 * wx_delta2_delta_lam;
        let t131 = t68 + t84 + h_wheels_all;
        let t132 = wz_delta2_delta * self.xH;
        let K0_12_mH = t106 - t132;
        put_derivative(33, K0_12_mH);
        let t134 = t132 - t106;
        let M_12_zH = self.mH * (t98 - t134);
        put_derivative(34, M_12_zH);
        let t137 = self.zH * t134;
        put_derivative(35, t137);
        let M_22_mH = t134 * t134;
        put_derivative(36, M_22_mH);
        let t139 = wx_delta2_delta * t134;
        put_derivative(37, t139);
        let t140 = self.mH * t134;
        let t141 = self.w.like(1.0) / self.rR;
        let t142 = wx_delta2_delta_lam * h_spin_F;
        let yaw_per_v_delta = wx_delta2_delta_lam * t54;
        put_derivative(38, yaw_per_v_delta);
        let M_12 = t124 - yaw_by_delta * t73;
        put_entry(1, M_12);
        let K2_12_mR = self.rR * yaw_per_v_delta;
        put_derivative(39, K2_12_mR);
        let C1_12_IRyy = yaw_by_delta * t141;
        put_derivative(40, C1_12_IRyy);
        let K2_12_IRyy = t141 * yaw_per_v_delta;
        put_derivative(41, K2_12_IRyy);
        let K2_22_mH = t134 * yaw_per_v_delta;
        put_derivative(42, K2_22_mH);
        let C1_22_IHzz = wz_delta2_delta * yaw_per_v_delta;
        put_derivative(43, C1_22_IHzz);
        let t152 = yaw_by_delta * t94 - t128;
        let t156 = yaw_per_v_delta * (t87 + t94 + self.c * t131);
        let t157 = self.IRyy * t141;
        let t158 = t141 * t157;
        let t159 = h_spin_F + t157;
        let t160 = yaw_by_delta * self.xB;
        put_derivative(44, t160);
        let t161 = self.zB * t160;
        put_derivative(45, t161);
        let M_22_mB = t160 * t160;
        put_derivative(46, M_22_mB);
        let t163 = wx_delta2_delta * t160;
        put_derivative(47, t163);
        let M_23_yaw_per_v_delta = t66 * t152 - t128 - t67 * t140;
        let t168 = K0_11 - t159;
        let t169 = self.mB * t160;
        put_derivative(48, t169);
        let C1_21_rR = yaw_by_delta * t158;
        put_derivative(49, C1_21_rR);
        let t171 = self.mR - t158;
        let t172 = t159 * yaw_per_v_delta;
        put_derivative(50, t172);
        let t173 = t38 * wx_delta2_delta;
        let M_23_zP = yaw_by_delta * h_wheels_all;
        put_derivative(51, M_23_zP);
        let t177 = t140 + t169 + t173 + M_23_zP;
        let t178 = self.c * t172;
        let t179 = t140 + t140;
        let C1_12_rR = yaw_by_delta * t171;
        put_derivative(52, C1_12_rR);
        let K2_12_rR = yaw_per_v_delta * t171;
        put_derivative(53, K2_12_rR);
        let M_22_xH = wz_delta2_delta * t179;
        put_derivative(54, M_22_xH);
        let t183 = wx_delta2_delta * t179;
        put_derivative(55, t183);
        let t184 = wx_delta2_delta_lam * t179;
        let t188 = t54 * (t102 + self.c * t168 - t103);
        let C1_21_w = t54 * t178;
        put_derivative(56, C1_21_w);
        let C1_21 = -(t142 + t178);
        put_entry(8, C1_21);
        let K0_12 = -t177;
        put_entry(13, K0_12);
        let K0_22 = -(wx_delta2_delta * t177);
        put_entry(15, K0_22);
        let M_22 = wx_delta2_delta_lam * M_23_yaw_per_v_delta + wx_delta2_delta * t124;
        put_entry(3, M_22);
        let t200 = wx_delta2_delta * M_23_yaw_per_v_delta - wx_delta2_delta_lam * t124;
        let t204 = t152 + self.c * t177 + self.w * t173;
        let t205 = t152 * yaw_per_v_delta;
        let t206 = t205 + t205;
        let t208 = t66 * t206 + t184;
        put_derivative(57, t208);
        let M_22_c = t206 - t184;
        put_derivative(58, M_22_c);
        let M_23_c = t100 * yaw_per_v_delta;
        put_derivative(59, M_23_c);
        let t211 = self.mU * yaw_by_delta;
        put_derivative(60, t211);
        let t212 = self.zU * t211;
        put_derivative(61, t212);
        let t213 = wx_delta2_delta * t211;
        put_derivative(62, t213);
        let t214 = t200 + t200;
        put_derivative(63, t214);
        let t215 = K0_13_mU * t211;
        put_derivative(64, t215);
        let C1_32 = M_23_c - t215;
        put_entry(10, C1_32);
        let C1_12_w = yaw_per_v_delta * (t38 + t188);
        put_derivative(65, C1_12_w);
        let t219 = t54 * C1_32;
        put_derivative(66, t219);
        let ay_all1_delta = h_spin_F - t188;
        let t221 = t168 * yaw_per_v_delta;
        put_derivative(67, t221);
        let C1_22 = yaw_per_v_delta * t204;
        put_entry(9, C1_22);
        let t224 = t204 + self.c * t156;
        let K2_12_w = t54 * t221;
        put_derivative(68, K2_12_w);
        let K2_12 = -t221;
        put_entry(16, K2_12);
        let C1_12 = wx_delta2_delta_lam * ay_all1_delta;
        put_entry(7, C1_12);
        let t228 = wx_delta2_delta * ay_all1_delta;
        put_derivative(69, t228);
        let t229 = wx_delta2_delta * h_spin_F;
        let t230 = t177 + t229;
        let K2_22 = yaw_per_v_delta * t230;
        put_entry(17, K2_22);
        let t232 = K0_13 * yaw_per_v_delta;
        put_derivative(70, t232);
        let K2_32_w = t54 * t232;
        put_derivative(71, K2_32_w);
        let K2_32 = -t232;
        put_entry(18, K2_32);
        let t235 = t102 * yaw_per_v_delta;
        let M_12_w = M_22_yaw_per_v_delta + t66 * t235;
        put_derivative(72, M_12_w);
        let M_12_c = M_22_yaw_per_v_delta - t235;
        put_derivative(73, M_12_c);
        let t239 = self.mH * wx_delta2_delta_lam;
        let t240 = self.c + self.xH;
        let C1_22_mH = t240 * K2_22_mH;
        put_derivative(74, C1_22_mH);
        let t242 = t239 * t240;
        let t246 = yaw_per_v_delta * (t54 * t224 + t242 - t173);
        put_derivative(75, t246);
        let t249 = yaw_per_v_delta * (t242 - t177 - t156);
        put_derivative(76, t249);
        let t250 = t54 * t242;
        put_derivative(77, t250);
        let C1_22_xH = wz_delta2_delta * t250 + self.mH * K2_22_mH;
        put_derivative(78, C1_22_xH);
        let t254 = wx_delta2_delta * t250;
        put_derivative(79, t254);
        let t255 = yaw_per_v_delta * t131;
        let K0_12_w = t239 + t66 * t255;
        put_derivative(80, K0_12_w);
        let K0_12_c = t239 - t255;
        put_derivative(81, K0_12_c);
        let K0_22_c = wx_delta2_delta * K0_12_c;
        put_derivative(82, K0_22_c);
        let t260 = yaw_per_v_delta * K0_12_c;
        put_derivative(83, t260);
        let t261 = t54 * wx_delta2_delta;
        let vy_spin_F5_delta = wx_delta2_delta * t87 + self.c * t118
            - wx_delta2_delta_lam * (t103 - t56);
        let C1_22_lam = t67 * t254 - t224 * t261 - yaw_per_v_delta * vy_spin_F5_delta;
        put_derivative(84, C1_22_lam);
        let t275 = t54 * K2_22 + yaw_per_v_delta * K0_12_w;
        put_derivative(85, t275);
        let K0_22_w = wx_delta2_delta * K0_12_w;
        put_derivative(86, K0_22_w);
        let K2_12_lam = t168 * t261;
        put_derivative(87, K2_12_lam);
        let K2_32_lam = K0_13 * t261;
        put_derivative(88, K2_32_lam);
        let t279 = self.c * t261;
        let C1_21_lam = t229 + t159 * t279;
        put_derivative(89, C1_21_lam);
        let t282 = t100 * t279;
        put_derivative(90, t282);
        let K0_12_zH = self.mH * wx_delta2_delta;
        put_derivative(91, K0_12_zH);
        let t284 = wz_delta2_delta * K0_12_zH;
        put_derivative(92, t284);
        let t285 = yaw_per_v_delta * K0_12_zH;
        put_derivative(93, t285);
        let t286 = t67 * K0_12_zH;
        let M_12_lam = t97 + t43 * wx_delta2_delta_lam + t102 * t279 - self.zH * t286;
        put_derivative(94, M_12_lam);
        let K0_12_lam = t118 + t131 * t279 - t286;
        put_derivative(95, K0_12_lam);
        let t296 = self.c + self.xU;
        let t299 = t261 * (self.IUxz - K0_13 * t296);
        put_derivative(96, t299);
        let C1_22_vy_theta3_delta = yaw_by_delta * yaw_per_v_delta;
        put_derivative(97, C1_22_vy_theta3_delta);
        let M_22_vy_theta3_delta = self.c * C1_22_vy_theta3_delta;
        put_derivative(98, M_22_vy_theta3_delta);
        let t302 = M_22_vy_theta3_delta + M_22_vy_theta3_delta;
        let t303 = self.mB * yaw_by_delta;
        put_derivative(99, t303);
        let t304 = self.zB * t303;
        put_derivative(100, t304);
        let t305 = wx_delta2_delta * t303;
        put_derivative(101, t305);
        let K2_22_xB = yaw_per_v_delta * t303;
        put_derivative(102, K2_22_xB);
        let t307 = self.zB * yaw_per_v_delta;
        put_derivative(103, t307);
        let M_22_xB = t68 * t302;
        put_derivative(104, M_22_xB);
        let M_22_xU = h_wheels_all * t302;
        put_derivative(105, M_22_xU);
        let t310 = self.mB * t307;
        put_derivative(106, t310);
        let K2_22_lam = yaw_per_v_delta * (t142 - K0_12_lam) - t230 * t261;
        put_derivative(107, K2_22_lam);
        let K0_22_lam = wx_delta2_delta * K0_12_lam - wx_delta2_delta_lam * t177;
        put_derivative(108, K0_22_lam);
        let K2_22_h_spin_F = wx_delta2_delta_lam * t261;
        put_derivative(109, K2_22_h_spin_F);
        let K2_22_mF = self.rF * K2_22_h_spin_F;
        put_derivative(110, K2_22_mF);
        let t320 = self.mB * yaw_per_v_delta;
        put_derivative(111, t320);
        let t321 = self.xB * t320;
        let t322 = t303 + t321;
        put_derivative(112, t322);
        let t323 = self.c + self.xB;
        let t324 = t307 * t323;
        put_derivative(113, t324);
        let K2_22_mB = self.xB * C1_22_vy_theta3_delta;
        put_derivative(114, K2_22_mB);
        let C1_22_mB = t323 * K2_22_mB;
        put_derivative(115, C1_22_mB);
        let t327 = self.mH * yaw_per_v_delta;
        put_derivative(116, t327);
        let C1_22_xB = yaw_by_delta * (t321 + t322);
        put_derivative(117, C1_22_xB);
        let t330 = self.zH * t327;
        put_derivative(118, t330);
        let t331 = self.mH * wz_delta2_delta;
        put_derivative(119, t331);
        let K2_22_xH = yaw_per_v_delta * t331;
        put_derivative(120, K2_22_xH);
        let M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
        put_derivative(121, M_22_IHxx);
        let K0_22_zH = self.mH * M_22_IHxx;
        put_derivative(122, K0_22_zH);
        let t335 = self.zH * yaw_per_v_delta;
        put_derivative(123, t335);
        let t336 = t240 * t335;
        put_derivative(124, t336);
        let M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
        put_derivative(125, M_22_IHzz);
        let M_22_IFxx = M_22_IHxx + M_22_IHzz;
        put_derivative(126, M_22_IFxx);
        let t339 = wx_delta2_delta + wx_delta2_delta;
        let M_22_IHxz = wz_delta2_delta * t339;
        put_derivative(127, M_22_IHxz);
        let M_12_rF = t38 * t339;
        put_derivative(128, M_12_rF);
        let M_22_rF = wx_delta2_delta * M_12_rF;
        put_derivative(129, M_22_rF);
        let C1_12_IFyy = wz_delta2_delta * t101;
        put_derivative(130, C1_12_IFyy);
        let C1_21_rF = h_spin_F * C1_12_IFyy;
        put_derivative(131, C1_21_rF);
        let K2_12_IFyy = t101 * yaw_per_v_delta;
        put_derivative(132, K2_12_IFyy);
        let K2_22_IFyy = wx_delta2_delta * K2_12_IFyy;
        put_derivative(133, K2_22_IFyy);
        let t347 = self.mF * yaw_per_v_delta;
        let K2_12_rF = t347 - h_spin_F * K2_12_IFyy;
        put_derivative(134, K2_12_rF);
        let t350 = t67 * t347;
        let C1_12_rF = t350 - C1_21_rF;
        put_derivative(135, C1_12_rF);
        let C1_22_rF = wx_delta2_delta * t350;
        put_derivative(136, C1_22_rF);
        let t353 = self.mF * wx_delta2_delta;
        put_derivative(137, t353);
        let t354 = wx_delta2_delta * t353;
        put_derivative(138, t354);
        let K2_22_rF = wx_delta2_delta * K2_12_rF;
        put_derivative(139, K2_22_rF);
        let t356 = self.rF * wx_delta2_delta;
        put_derivative(140, t356);
        let M_12_mF = self.rF * t356;
        put_derivative(141, M_12_mF);
        let M_22_mF = t356 * t356;
        put_derivative(142, M_22_mF);
        let t359 = wx_delta2_delta * t356;
        put_derivative(143, t359);
        let K2_12_mF = self.rF * yaw_per_v_delta;
        put_derivative(144, K2_12_mF);
        let C1_12_mF = t67 * K2_12_mF;
        put_derivative(145, C1_12_mF);
        let C1_22_mF = wx_delta2_delta * C1_12_mF;
        put_derivative(146, C1_22_mF);
        let K2_32_zP = self.mU * yaw_per_v_delta;
        put_derivative(147, K2_32_zP);
        let C1_32_zP = t296 * K2_32_zP;
        put_derivative(148, C1_32_zP);
        let t365 = self.c * self.xU;
        let t366 = yaw_per_v_delta * t365;
        put_derivative(149, t366);
        let t367 = wx_delta2_delta * t366;
        put_derivative(150, t367);
        let t368 = self.zU * t366;
        put_derivative(151, t368);
        let t369 = K0_13_mU * t366;
        put_derivative(152, t369);
        let K2_22_mU = self.xU * C1_22_vy_theta3_delta;
        put_derivative(153, K2_22_mU);
        let M_22_mU = t365 * K2_22_mU;
        put_derivative(154, M_22_mU);
        let t372 = self.zU * yaw_per_v_delta;
        put_derivative(155, t372);
        let C1_22_mU = t296 * K2_22_mU;
        put_derivative(156, C1_22_mU);
        let t374 = t296 * t372;
        put_derivative(157, t374);
        let t375 = K0_13_mU * yaw_per_v_delta;
        put_derivative(158, t375);
        let t376 = t296 * t375;
        put_derivative(159, t376);
        let t377 = self.mU * t372;
        put_derivative(160, t377);
        let K2_22_xU = self.mU * C1_22_vy_theta3_delta;
        put_derivative(161, K2_22_xU);
        let C1_22_xU = (self.xU + t296) * K2_22_xU;
        put_derivative(162, C1_22_xU);
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
    #[inline(always)]
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

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 19] {
        [
            self.m[0][0], self.m[0][1], self.m[0][2], self.m[1][1], self.m[1][2], self.m[2][2],
            self.c0[2][2], self.c1[0][1], self.c1[1][0], self.c1[1][1], self.c1[2][1],
            self.kc[2][2], self.k0[0][0], self.k0[0][1], self.k0[0][2], self.k0[1][1],
            self.k2[0][1], self.k2[1][1], self.k2[2][1],
        ]
    }

    /// Sets the entry at a position among those that differ, wherever it stands.
    #[inline(always)]
    fn set_entry(&mut self, position: usize, entry: T) {
        match position {
            0 => {
                self.m[0][0] = entry;
            }
            1 => {
                self.m[0][1] = entry;
                self.m[1][0] = entry;
            }
            2 => {
                self.m[0][2] = entry;
                self.m[2][0] = entry;
            }
            3 => {
                self.m[1][1] = entry;
            }
            4 => {
                self.m[1][2] = entry;
                self.m[2][1] = entry;
            }
            5 => {
                self.m[2][2] = entry;
            }
            6 => {
                self.c0[2][2] = entry;
            }
            7 => {
                self.c1[0][1] = entry;
            }
            8 => {
                self.c1[1][0] = entry;
            }
            9 => {
                self.c1[1][1] = entry;
            }
            10 => {
                self.c1[2][1] = entry;
            }
            11 => {
                self.kc[2][2] = entry;
            }
            12 => {
                self.k0[0][0] = entry;
            }
            13 => {
                self.k0[0][1] = entry;
                self.k0[1][0] = entry;
            }
            14 => {
                self.k0[0][2] = entry;
                self.k0[2][0] = entry;
                self.k0[2][2] = entry;
            }
            15 => {
                self.k0[1][1] = entry;
            }
            16 => {
                self.k2[0][1] = entry;
            }
            17 => {
                self.k2[1][1] = entry;
            }
            18 => {
                self.k2[2][1] = entry;
            }
            _ => {}
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
        forces: &[
            carvallo::motion::AppliedInfo {
                name: "Tphi", label: "lean torque", unit: "N*m", position: "phi",
            },
            carvallo::motion::AppliedInfo {
                name: "Tdelta", label: "steer torque", unit: "N*m", position: "delta",
            },
            carvallo::motion::AppliedInfo {
                name: "Ttheta", label: "hip torque", unit: "N*m", position: "theta",
            },
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
        attributes: &[
            FormulaInfo::attribute("B_mass", "the mass of the rear frame and legs B", "kg", "mB"),
            FormulaInfo::attribute("B_x", "x of the centre of mass of the rear frame and legs B", "m", "xB"),
            FormulaInfo::attribute("B_z", "z of the centre of mass of the rear frame and legs B", "m", "zB"),
            FormulaInfo::attribute("B_Ixx", "the inertia xx of the rear frame and legs B", "kg*m^2", "IBxx"),
            FormulaInfo::attribute("B_Ixz", "the inertia xz of the rear frame and legs B", "kg*m^2", "IBxz"),
            FormulaInfo::attribute("B_Iyy", "the inertia yy of the rear frame and legs B", "kg*m^2", "IByy"),
            FormulaInfo::attribute("B_Izz", "the inertia zz of the rear frame and legs B", "kg*m^2", "IBzz"),
            FormulaInfo::attribute("H_mass", "the mass of the front frame H", "kg", "mH"),
            FormulaInfo::attribute("H_x", "x of the centre of mass of the front frame H", "m", "xH"),
            FormulaInfo::attribute("H_z", "z of the centre of mass of the front frame H", "m", "zH"),
            FormulaInfo::attribute("H_Ixx", "the inertia xx of the front frame H", "kg*m^2", "IHxx"),
            FormulaInfo::attribute("H_Ixz", "the inertia xz of the front frame H", "kg*m^2", "IHxz"),
            FormulaInfo::attribute("H_Iyy", "the inertia yy of the front frame H", "kg*m^2", "IHyy"),
            FormulaInfo::attribute("H_Izz", "the inertia zz of the front frame H", "kg*m^2", "IHzz"),
            FormulaInfo::attribute("U_mass", "the mass of the upper body U", "kg", "mU"),
            FormulaInfo::attribute("U_x", "x of the centre of mass of the upper body U", "m", "xU"),
            FormulaInfo::attribute("U_z", "z of the centre of mass of the upper body U", "m", "zU"),
            FormulaInfo::attribute("U_Ixx", "the inertia xx of the upper body U", "kg*m^2", "IUxx"),
            FormulaInfo::attribute("U_Ixz", "the inertia xz of the upper body U", "kg*m^2", "IUxz"),
            FormulaInfo::attribute("U_Iyy", "the inertia yy of the upper body U", "kg*m^2", "IUyy"),
            FormulaInfo::attribute("U_Izz", "the inertia zz of the upper body U", "kg*m^2", "IUzz"),
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
            FormulaInfo::attribute("theta_through_z", "z of the point of the joint theta", "m", "zP"),
            FormulaInfo::attribute("theta_spring", "the spring of the joint theta", "kg*m^2/s^2", "kU"),
            FormulaInfo::attribute("theta_damper", "the damper of the joint theta", "kg*m^2/s", "dU"),
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
            FormulaInfo::definition("Jxx_theta", "kg*m^2", "U_mass*(U_z - theta_through_z)^2 + U_Ixx"),
            FormulaInfo::definition("Jxz_theta", "kg*m^2", "U_Ixz - U_mass*U_x*(U_z - theta_through_z)"),
            FormulaInfo::definition("Jzz_theta", "kg*m^2", "U_mass*U_x^2 + U_Izz"),
            FormulaInfo::definition("Sx_theta", "kg*m", "U_mass*U_x"),
            FormulaInfo::definition("Sz_theta", "kg*m", "U_mass*(U_z - theta_through_z)"),
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
            FormulaInfo::definition(
                "Jxx_all",
                "kg*m^2",
                "B_mass*B_z^2 + B_Ixx + R_mass*R_z^2 + R_radial + 2*theta_through_z*((1/2)*U_mass*theta_through_z + Sz_theta) + Jxx_theta + Jxx_delta",
            ),
            FormulaInfo::definition(
                "Jxz_all",
                "kg*m^2",
                "B_Ixz + Jxz_theta + Jxz_delta - B_mass*B_x*B_z - delta_through_x*Sz_delta - theta_through_z*Sx_theta",
            ),
            FormulaInfo::definition(
                "Jzz_all",
                "kg*m^2",
                "B_mass*B_x^2 + B_Izz + R_radial + 2*delta_through_x*((1/2)*delta_through_x*m_delta + Sx_delta) + Jzz_theta + Jzz_delta",
            ),
            FormulaInfo::definition("Sx_all", "kg*m", "B_mass*B_x + delta_through_x*m_delta + Sx_theta + Sx_delta"),
            FormulaInfo::definition(
                "Sz_all",
                "kg*m",
                "B_mass*B_z + U_mass*theta_through_z + R_mass*R_z + Sz_theta + Sz_delta",
            ),
            FormulaInfo::definition("m_all", "kg", "B_mass + U_mass + R_mass + m_delta"),
            FormulaInfo::definition("load_spin_F", "kg", "-Sx_all/F_x"),
            FormulaInfo::definition("load_spin_R", "kg", "-(m_all + load_spin_F)"),
            FormulaInfo::definition("h_spin_R", "kg*m", "R_axial/R_radius"),
            FormulaInfo::definition("h_spin_F", "kg*m", "F_axial/F_radius"),
            FormulaInfo::definition("h_wheels_all", "kg*m", "h_spin_R + h_spin_F"),
            FormulaInfo::definition("M_yaw_delta", "kg*m^2", "delta_through_x*py_delta + hz_delta"),
            FormulaInfo::definition("M_phi_theta", "kg*m^2", "theta_through_z*Sz_theta + Jxx_theta"),
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
            FormulaInfo::definition(
                "P_phi_theta",
                "kg*m^2",
                "yaw_by_phi_*Jxz_theta + M_phi_theta - lateral_by_phi*Sz_theta",
            ),
            FormulaInfo::definition("P_delta_lateral", "kg*m", "yaw_by_delta*Sx_all + py_delta"),
            FormulaInfo::definition("P_delta_yaw", "kg*m^2", "yaw_by_delta*Jzz_all + M_yaw_delta"),
            FormulaInfo::definition("P_delta_delta", "kg*m^2", "yaw_by_delta*M_yaw_delta + M_delta_delta"),
            FormulaInfo::definition("P_delta_theta", "kg*m^2", "yaw_by_delta*Jxz_theta"),
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
            FormulaInfo::entry(&[(MatrixName::M, 0, 2), (MatrixName::M, 2, 0)], "kg*m^2", "P_phi_theta"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "yaw_by_delta*P_delta_yaw + P_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 2), (MatrixName::M, 2, 1)], "kg*m^2", "P_delta_theta"),
            FormulaInfo::entry(&[(MatrixName::M, 2, 2)], "kg*m^2", "Jxx_theta"),
            FormulaInfo::entry(&[(MatrixName::C0, 2, 2)], "kg*m^2/s", "theta_damper"),
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
            FormulaInfo::entry(&[(MatrixName::C1, 2, 0)], "kg*m", "-yaw_by_phi_*Sz_theta"),
            FormulaInfo::entry(&[(MatrixName::C1, 2, 1)], "kg*m", "yaw_per_v_delta*Jxz_theta - yaw_by_delta*Sz_theta"),
            FormulaInfo::entry(&[(MatrixName::Kc, 2, 2)], "kg*m^2/s^2", "theta_spring"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "K_phi_phi"),
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
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg", "yaw_per_v_delta*(h_wheels_all + P_phi_lateral)"),
            FormulaInfo::entry(
                &[(MatrixName::K2, 1, 1)],
                "kg",
                "yaw_per_v_delta*(delta_along_x*h_spin_F/length_delta + P_delta_lateral)",
            ),
            FormulaInfo::entry(&[(MatrixName::K2, 2, 1)], "kg", "-yaw_per_v_delta*Sz_theta"),
        ],
        motion: Some(
            &MotionFormulas {
                constants: &[
                    "T0=1/sqrt(A33^2+A34^2);C7=A33*T0;C8=A34*T0;C9=C8*A32+C7*A25;C10=C7*A32-C8*A25;T1=A35-A25;C11=C7*T1;C12=C8*T1",
                    "C13=C8^2;C14=C7*C8;C15=C7^2;T2=A30-A32;C16=C8*T2-C7*A31;C17=C7*T2+C8*A31;C18=C10+C17;T3=A2-A25",
                    "T4=C8*A1-C7*T3;C19=A0*T4;T5=C7*A1+C8*T3;C20=A0*T5;T6=C8*A4;T7=C7*A3+T6;T8=C7*A4;T9=T8+C8*A6",
                    "C21=C8*T7-C7*T9-C19*T5;T10=T5*C20;T11=T4*C19;C22=A5+T10+T11;C23=A0+A21",
                    "C24=T10+A24+C8*(C8*A3-T8)-C7*(T6-C7*A6);C25=T11+A24+C7*T7+C8*T9;C26=A7+A26;T12=A8-A32;T13=C8*T12-C7*A9",
                    "T14=A7*T13;T15=C16*A26;C27=T14+T15;T16=C7*T12+C8*A9;T17=A7*T16;T18=C17*A26;C28=T17+T18;T19=C7*A11;T20=C8*A11",
                    "T21=T16*T17+C17*T18;C29=A29+C8*(C8*A10-T19)+T21-C7*(T20-C7*A13);T22=T20+C7*A10;T23=T19+C8*A13",
                    "C30=C8*T22-C7*T23-T14*T16-C17*T15;T24=T13*T14+C16*T15;C31=T21+A12+T24;C32=A29+T24+C7*T22+C8*T23;T25=A16-A35",
                    "T26=C8*A15-C7*T25;C33=A14*T26;T27=C7*A15+C8*T25;C34=A14*T27;T28=C7*A18;T29=C8*A18;T30=T27*C34",
                    "C35=C8*(C8*A17-T28)+T30-C7*(T29-C7*A20);T31=T29+C7*A17;T32=T28+C8*A20;C36=C8*T31-C7*T32-C33*T27;T33=T26*C33",
                    "C37=T30+A19+T33;C38=T33+C7*T31+C8*T32;C40=A14*C11;C41=A14*C12;C42=C12*C41;C43=C12*C40;C44=C11*C40",
                    "C45=C29-C31;C46=C9*C26;T34=C10*C28;T35=C10*C26;C47=T34+T34+C10*T35;C48=C9*C28;C49=C10*C46;C50=C9*C46",
                    "C51=C28+T35;C52=A22*(A14+C23+C26);C53=A22*C52;C54=C7*C33-C8*C34;C55=C8*C35+C7*C36;C56=C8*C36+C7*C38",
                    "C57=C8*C55+C7*C56;C0=A36;C1=A37;C2=A14;C3=A23;C4=A28;C5=A22;C6=A27;C39=P3;C58=C53",
                ],
                closure: &[
                    "T0=cos(Q3);T1=cos(Q5);T2=sin(Q4);T3=cos(Q4);T4=C8*T2+C7*T3;T5=T0*T4;T6=sin(Q3);T7=sin(Q5);T8=T6*T7",
                    "T9=T8-T1*T5;T10=C8*T3-T2*C7;T11=T0*T10;T12=sqrt(T9^2+T11^2);T13=C9+T1*C16",
                    "R0=C6*T12+T8*C16+T0*(T10*C18-T4*T13)-C5*T0;T14=1/T12;T15=T11*T14",
                    "T16=C6*(T1*T6+T5*T7)*(T0*T7*T15+T6*(T9*T10*T14+T1*T4*T15));R1=R0/(T0*(T16+T4*C18+T10*T13))",
                ],
                accelerations: &[
                    "T0=sin(Q3);T1=sin(Q4);T2=cos(Q4);T3=C8*T1+C7*T2;T4=cos(Q5);T5=cos(Q3);T6=T3*T5;T7=sin(Q5);T8=T0*T7-T4*T6",
                    "T9=C8*T2-T1*C7;T10=T5*T9;T11=sqrt(T8^2+T10^2);T12=1/T11;T13=T8*T12;T14=T10*T12;T15=T4*T14;T16=T9*T15-T3*T13",
                    "T17=T0*T4+T6*T7;T18=C6*T17;T19=T7*C16;T20=C9+T4*C16;T21=T9*C18-T3*T20;T22=T5*T19-T16*T18-T0*T21",
                    "T23=C5*T0+T22;T24=T5*T7*T14+T0*(T9*T13+T3*T15);T25=T18*T24+T3*C18+T9*T20;T26=1/(T5*T25);T27=T23*T26",
                    "T28=T9*C10-T3*C9;T29=T22+T0*T28;T30=T0*T9;T31=T25-T3*C10-T9*C9;T32=T26*(T3*T29+T30*T31);R4=U0*T27+U1*T32",
                    "T33=U3+R4;T34=C5*T33;T35=cos(Q2);T36=sin(Q2);T37=T0*T25;T38=T0*T23;T39=T16*T37+T24*T38",
                    "T40=1/(T16*T25+T23*T24);T41=T27*T39*T40;T42=T11*C6+T0*T19+T5*T21-T5*T28;T43=T10*T31-T3*T42",
                    "T44=T30*T42+T10*T29;T45=T40*(T16*T43+T24*T44+T32*T39);T46=C5*T24*T40;T47=U0*T41+U1*T45+U3*T46",
                    "T48=T24*T37-T16*T38;T49=T24*T25-T16*T23;T50=1/C6;T51=(T41*T49-T27*T48)*T50",
                    "T52=T50*(T16*T44+T45*T49-T24*T43-T32*T48);T53=T50*(C5*T16+T46*T49);R8=U0*T51+U1*T52+U3*T53;T54=T5*T47",
                    "T55=U0*T54;T56=U0*T3-T9*T54;T57=T0*T47;T58=R4-T57;T59=C10*T58;T60=U0*T9+T3*T54;T61=C9*T58",
                    "T62=T56*T59+T60*T61;T63=U0*T57;T64=R4*T60;T65=T9*T63+T64;T66=R4*T56;T67=T3*T63+T66;T68=C5*T57",
                    "T69=T54*T68-T34*T54;T70=T62+C9*T65+C10*T67-T69;T71=C9*T56-C10*T60;T72=T58*T61+T56*T71;T73=C5*U0;T74=T54*T73",
                    "T75=T74+C5*T55;T76=T68*(T33-T57)-U0*T73;T77=T9*T75+T3*T76-T72-C10*T55;T78=U1+T56;T79=T4*T58-T7*T60",
                    "T80=C17*T79;T81=T4*T60+T7*T58;T82=C16*T79;T83=U1*T79;T84=T83-T4*T67-T7*T55;T85=T13*C6;T86=T14*C6",
                    "T87=T12*T17*(T13*T81+T14*T78);T88=T86*T87;T89=T85*T87",
                    "T90=T4*T70+T78*T80+T81*T82+C16*T65+T85*(T65+R8*T81)+T78*T88;T91=T90+T81*T89-T7*T77-C17*T84-T86*(T84-R8*T78)",
                    "T92=C16*T78-C17*T81;T93=U1*T81;T94=T7*T67-T4*T55-T93;T95=R8+T79;T96=C6*(T13*T78-T14*T81)",
                    "T97=T4*T77+T7*T70+C17*T94+T86*T94-T79*T82-T78*T92;T98=T97-T89*T95-T78*T96;T99=T60*T71-T58*T59",
                    "T100=T99+C9*T55+T3*T75+T81*T92+T81*T96-T9*T76;T101=T100-T79*T80-C16*T94-T85*T94-T88*T95",
                    "T102=T13*T98+T14*T101;T103=T26*(T17*T91+T11*T102);T104=T40*(T11*T91+T39*T103-T17*T102);T105=T103-T55-T0*T104",
                    "T106=cos(Q6);T107=1.0-T106;T108=T107*C14;T109=C5*T105-T74;T110=T76+T5*C39;T111=T3*T110-T9*T109;T112=T58*C11",
                    "T113=T56*C11+T60*C12;T114=T111+T58*T112+T56*T113+T105*C12;T115=T106+T107*C13;T116=sin(Q6);T117=C7*T116",
                    "T118=T58*C12;T119=T63-T5*T104;T120=T64+T9*T119;T121=T66+T3*T119;T122=T69+T0*C39",
                    "T123=T56*T118+C12*T121-T60*T112-C11*T120-T122;T124=T9*T110+T3*T109;T125=T105*C11-T124-T60*T113-T58*T118",
                    "T126=T114*T115+T117*T123+T125*T108;T127=C7*U2;T128=C8*T116;T129=T106+T107*C15",
                    "T130=T127+T60*T108+T56*T129-T58*T128;T131=C8*U2;T132=T131+T60*T115+T58*T117+T56*T108",
                    "T133=U2*(C8*T130-C7*T132)+T117*T121+T105*T106+T120*T128;T134=T58*T106+T56*T128-T60*T117;T135=T134*C33",
                    "T136=T130*C33-C34*T132;T137=T126*C2+C34*T133-T134*T135-T130*T136;T138=T106*T123+T128*T125-T117*T114",
                    "T139=T120*T129-T134*T131-T121*T108-T105*T128;T140=T134*T127+T105*T117+T120*T108-T121*T115;T141=C34*T134",
                    "T142=T138*C2+T139*C33+T130*T141+T132*T135-C34*T140;T143=T114*T108+T125*T129-T123*T128",
                    "T144=T143*C2+T132*T136-C33*T133-T134*T141;T145=T108*T137+T128*T142+T129*T144;T146=T99-T124-C9*T105",
                    "T147=T4*T105+T7*T121-T93;T148=T78*C27-T81*C28;T149=T79*C28;T150=T146*C26+T81*T148-C27*T147-T79*T149",
                    "T151=T56*C19-C20*T60;T152=C20*T58;T153=T3*(T145+T150+T60*T151-T124*C23-T105*C19-T58*T152)",
                    "T154=T115*T137+T108*T144-T117*T142;T155=T111+C10*T105-T72;T156=T62+C9*T120+C10*T121-T122",
                    "T157=T4*T155+T7*T156;T158=T79*C27;T159=T157*C26+C28*T147-T79*T158-T78*T148;T160=T4*T156-T7*T155",
                    "T161=T83+T7*T105-T4*T121;T162=T160*C26+T120*C27+T78*T149+T81*T158-C28*T161;T163=T4*T159-T7*T162;T164=T58*C19",
                    "T165=T9*(T154+T163+T111*C23+C20*T105-T58*T164-T56*T151);T166=T105*C3-C5*(T153+T165);T167=T0*T46",
                    "T168=T60*C24+T56*C21;T169=T60*C21+T56*C25;T170=C36*T132+T130*C38;T171=T134*C37",
                    "T172=C35*T140+C36*T139+T134*T170-C34*T138-T130*T171;T173=C35*T132+C36*T130",
                    "T174=C34*T126+C37*T133+T130*T173-C33*T143-T132*T170;T175=T138*C33+T140*C36+T139*C38+T132*T171-T134*T173",
                    "T176=T81*C30+T78*C32;T177=T79*C31+T95*C4;T178=C29*T161+T120*C30+T79*T176-C28*T160-T78*T177",
                    "T179=T50*(T13*T101+T49*T104-T14*T98-T48*T103);T180=C4*(T147+T179);T181=T81*C29+T78*C30",
                    "T182=C28*T157+C31*T147+T180+T78*T181-C27*T146-T81*T176",
                    "T183=C20*T111+C19*T124+T105*C22+T56*T168+T117*T172+T106*T174",
                    "T184=T183+C12*T154+C11*T145+T7*T178+T4*T182+C10*T163;T185=T184+T166-T60*T169-T128*T175-C9*T150;T186=T5*T46",
                    "T187=T58*C22+C3*(U3+T58);T188=T160*C27+T161*C30+T120*C32+T81*T177-T79*T181",
                    "T189=T117*T137+T106*T142-T128*T144;T190=T7*T159+T4*T162",
                    "T191=C25*T120+T60*T187+T188+T108*T172+T128*T174+T129*T175",
                    "T192=T191+C9*T190-C19*T122-C21*T121-T58*T168-C11*T189",
                    "T193=C20*T122+C21*T120+T58*T169+T115*T172+T108*T175+T4*T178",
                    "T194=T193-C24*T121-T56*T187-T117*T174-C12*T189-T7*T182;T195=T194-C10*T190;T196=T9*T192-T3*T195",
                    "T197=T189+T190+C19*T120+C20*T121+T56*T152+T60*T164-T122*C23;T198=T27-T0*T41;T199=T5*T41",
                    "T200=F0+T196*T199-T3*T192-T9*T195-C5*T197-T185*T198;T201=T200-T51*T180;T202=C35*T108+C36*T129;T203=T128*C37",
                    "T204=T108*C36;T205=T204+T129*C38;T206=T117*C33-C34*T128;T207=T7*C27;T208=T7*C30-C10*T207",
                    "T209=T117*T202+T106*T203+T208-T128*T205-C12*T206;T210=T117*C35-T128*C36;T211=T106*C37;T212=T117*C36-T128*C38",
                    "T213=T7*C45;T214=T115*T210+T108*T212+C11*T206+T4*T213-T117*T211-C9*T207;T215=T3*T209+T9*T214",
                    "T216=T108*C33+C34*T129;T217=T115*C33+C34*T108;T218=T4*C27;T219=T4*C30-C10*T218",
                    "T220=C21+T115*T202+T108*T205+C11*T216+C43+T219;T221=T220-T117*T203-C12*T217-C48-C49;T222=T7*T213",
                    "T223=C12*T216;T224=T223+T223+C42+C47;T225=C24+C29+T115*(T204+C35*T115)+T117^2*C37+T108*(T115*C36+T108*C38)",
                    "T226=T225+T224-T222;T227=C9*T218;T228=C11*T217-T227;T229=C44+C50-T228-T228",
                    "T230=C25+C32+T108*T202+T128*T203+T129*T205+T229;T231=T230-T226;T232=T3*T9;T233=T3^2;T234=T221+T221",
                    "T235=C20+T216+C41+C51;T236=C19+T217+T218+C46-C40;T237=T221+T231*T232+C5*(T3*T235+T9*T236)-T233*T234",
                    "T238=T9*T235-T3*T236;T239=C5*(T238-C52);T240=C5*T238;T241=C53-T240-T240",
                    "T242=C22+C31+T222+T224+T229+T117*T210+T106*T211;T243=T242+T241-T128*T212;T244=C5*(T206+T207)",
                    "T245=T9*T209+T244-T3*T214;T246=T239+T167*T243+T186*T245;T247=T231*T233+T232*T234;T248=T230-T247",
                    "T249=T244-T167*T245-T186*T248;T250=1.0-T167;T251=C3*T198;T252=T3*T7;T253=T53-T4*T167-T186*T252",
                    "T254=T51+T4*T198-T7*T9-T199*T252;T255=C4*T254",
                    "T256=T250*T251+T253*T255-T167*T215-T186*T237-T198*T246-T199*T249",
                    "T257=T226+T241+T247+T198*T215+T198*(T215+T198*T243-T199*T245)+T198*T251",
                    "T258=T257+T254*T255-T199*T237-T199*(T237+T198*T245-T199*T248);T259=1/T258;T260=T256*T259;T261=T32-T0*T45",
                    "T262=C5*T9*T207;T263=T208+T262;T264=T5*T45;T265=T263+T243*T261-T245*T264;T266=C32+T227;T267=T9*T266-T3*T219",
                    "T268=T267+T245*T261-T248*T264;T269=C3*T261;T270=T52+T4*T261-T252*T264;T271=C4*T270",
                    "T272=T3*T266+T9*T219+C5*T218+T215*T261+T198*T265+T251*T261;T273=T259*(T272+T255*T270-T237*T264-T199*T268)",
                    "T274=T258*T273;T275=C32+T261*T265+T261*T263+T261*T269+T270*T271-T264*T268;T276=T275-T264*T267-T273*T274",
                    "T277=1/T276;T278=T262+T250*T269+T253*T271-T246*T261-T249*T264-T167*T263;T279=T277*(T278-T186*T267-T260*T274)",
                    "T280=F1+T196*T264-T188-T185*T261-T52*T180-T201*T273;T281=T128*C54;T282=T117*C54;T283=C5*(T3*T281-T9*T282)",
                    "T284=T117*C55+C11*T281-T283-T128*C56-C12*T282;T285=T106*C54;T286=T108*C55+T129*C56-C11*T285",
                    "T287=T115*C55+T108*C56-C12*T285;T288=T9*T286-T3*T287;T289=T259*(T3*T286+T9*T287+C5*T285+T198*T284-T199*T288)",
                    "T290=T258*T289;T291=T277*(T261*T284-T264*T288-T274*T289);T292=T276*T291;T293=C57-T289*T290-T291*T292",
                    "T294=1/T293;T295=(T283+T167*T284+T186*T288+T260*T290+T279*T292)*T294",
                    "T296=F2-C8*T172-C7*T175-Q6*C0-U2*C1-T201*T289;T297=T296-T280*T291",
                    "T298=T167*T185+T186*T196+T295*T297-T166-T53*T180-T201*T260",
                    "T299=T167*T246+T167*T239+C58+C3*T250*T250+C4*T253*T253-T186*T249",
                    "R16=(T298-T279*T280)/(T299-T186*T244-T258*T260*T260-T276*T279*T279-T293*T295*T295);R15=T294*T297+T295*R16",
                    "R14=T277*T280-T291*R15-T279*R16;R12=T201*T259-T273*R14-T289*R15-T260*R16;R13=T103+T27*R12+T32*R14",
                    "T300=C5*(R16+R13);T301=T34*T47;R10=T35*T301-T36*T300;R17=T179+T51*R12+T52*R14+T53*R16;R0=-(T34*T35)",
                    "R1=-(T34*T36);R2=-T47;R9=-(T35*T300+T36*T301);R11=-(T104+T41*R12+T45*R14+T46*R16);R3=U0;R5=U1;R6=U2;R7=U3",
                ],
            },
        ),
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

    fn shares(&self, force: usize) -> Option<[T; 3]> {
        (force < 3).then(|| self.kinematics().forces.map(|row| row[force]))
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
        WhippleLeaningMatrices::distinct_entries(&self.matrices())
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

    type WithDerivativesOver<U: Number> = WhippleLeaning<U>;

    const PARTIALS: &'static [Partial] = <WhippleLeaningDerivatives>::PARTIALS;

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

impl<T: Number> EvaluatorWithDerivatives<T, 3> for WhippleLeaning<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl WhippleLeaningDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 243] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 72), Partial::new(MatrixName::M, 1, 0, 0, 72),
        Partial::new(MatrixName::M, 1, 1, 0, 57).negative(),
        Partial::new(MatrixName::M, 1, 2, 0, 31).negative(),
        Partial::new(MatrixName::M, 2, 1, 0, 31).negative(),
        Partial::new(MatrixName::C1, 0, 1, 0, 65), Partial::new(MatrixName::C1, 1, 0, 0, 56),
        Partial::new(MatrixName::C1, 1, 1, 0, 75).negative(),
        Partial::new(MatrixName::C1, 2, 1, 0, 66).negative(),
        Partial::new(MatrixName::K0, 0, 1, 0, 80), Partial::new(MatrixName::K0, 1, 0, 0, 80),
        Partial::new(MatrixName::K0, 1, 1, 0, 86), Partial::new(MatrixName::K2, 0, 1, 0, 68),
        Partial::new(MatrixName::K2, 1, 1, 0, 85).negative(),
        Partial::new(MatrixName::K2, 2, 1, 0, 71), Partial::new(MatrixName::M, 0, 1, 1, 73),
        Partial::new(MatrixName::M, 1, 0, 1, 73), Partial::new(MatrixName::M, 1, 1, 1, 58),
        Partial::new(MatrixName::M, 1, 2, 1, 59), Partial::new(MatrixName::M, 2, 1, 1, 59),
        Partial::new(MatrixName::C1, 0, 1, 1, 67).negative(),
        Partial::new(MatrixName::C1, 1, 0, 1, 50).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 76).negative(),
        Partial::new(MatrixName::C1, 2, 1, 1, 70).negative(),
        Partial::new(MatrixName::K0, 0, 1, 1, 81),
        Partial::new(MatrixName::K0, 1, 0, 1, 81),
        Partial::new(MatrixName::K0, 1, 1, 1, 82),
        Partial::new(MatrixName::K2, 1, 1, 1, 83).negative(),
        Partial::new(MatrixName::M, 0, 1, 2, 94), Partial::new(MatrixName::M, 1, 0, 2, 94),
        Partial::new(MatrixName::M, 1, 1, 2, 63).negative(),
        Partial::new(MatrixName::M, 1, 2, 2, 90).negative(),
        Partial::new(MatrixName::M, 2, 1, 2, 90).negative(),
        Partial::new(MatrixName::C1, 0, 1, 2, 69).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 89),
        Partial::new(MatrixName::C1, 1, 1, 2, 84),
        Partial::new(MatrixName::C1, 2, 1, 2, 96).negative(),
        Partial::new(MatrixName::K0, 0, 1, 2, 95), Partial::new(MatrixName::K0, 1, 0, 2, 95),
        Partial::new(MatrixName::K0, 1, 1, 2, 108), Partial::new(MatrixName::K2, 0, 1, 2, 87),
        Partial::new(MatrixName::K2, 1, 1, 2, 107), Partial::new(MatrixName::K2, 2, 1, 2, 88),
        Partial::new(MatrixName::M, 0, 0, 4, 30), Partial::new(MatrixName::C1, 0, 1, 4, 52),
        Partial::new(MatrixName::C1, 1, 0, 4, 49),
        Partial::new(MatrixName::K0, 0, 0, 4, 1).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 53), Partial::new(MatrixName::M, 0, 0, 5, 12),
        Partial::new(MatrixName::C1, 0, 1, 5, 28),
        Partial::new(MatrixName::K0, 0, 0, 5, 0).negative(),
        Partial::new(MatrixName::K2, 0, 1, 5, 39), Partial::new(MatrixName::M, 0, 0, 6, 10),
        Partial::new(MatrixName::M, 1, 1, 6, 98), Partial::new(MatrixName::C1, 1, 1, 6, 97),
        Partial::new(MatrixName::C1, 0, 1, 7, 40),
        Partial::new(MatrixName::C1, 1, 0, 7, 40).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 41),
        Partial::new(MatrixName::M, 0, 1, 8, 100).negative(),
        Partial::new(MatrixName::M, 1, 0, 8, 100).negative(),
        Partial::new(MatrixName::M, 1, 1, 8, 104),
        Partial::new(MatrixName::C1, 0, 1, 8, 106).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 117),
        Partial::new(MatrixName::K0, 0, 1, 8, 99).negative(),
        Partial::new(MatrixName::K0, 1, 0, 8, 99).negative(),
        Partial::new(MatrixName::K0, 1, 1, 8, 101).negative(),
        Partial::new(MatrixName::K2, 1, 1, 8, 102), Partial::new(MatrixName::M, 0, 0, 9, 21),
        Partial::new(MatrixName::M, 0, 1, 9, 48).negative(),
        Partial::new(MatrixName::M, 1, 0, 9, 48).negative(),
        Partial::new(MatrixName::C1, 0, 1, 9, 112).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 3),
        Partial::new(MatrixName::K2, 0, 1, 9, 111).negative(),
        Partial::new(MatrixName::M, 0, 0, 10, 14),
        Partial::new(MatrixName::M, 0, 1, 10, 45).negative(),
        Partial::new(MatrixName::M, 1, 0, 10, 45).negative(),
        Partial::new(MatrixName::M, 1, 1, 10, 46),
        Partial::new(MatrixName::C1, 0, 1, 10, 113).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 115),
        Partial::new(MatrixName::K0, 0, 0, 10, 2),
        Partial::new(MatrixName::K0, 0, 1, 10, 44).negative(),
        Partial::new(MatrixName::K0, 1, 0, 10, 44).negative(),
        Partial::new(MatrixName::K0, 1, 1, 10, 47).negative(),
        Partial::new(MatrixName::K2, 0, 1, 10, 103).negative(),
        Partial::new(MatrixName::K2, 1, 1, 10, 114), Partial::new(MatrixName::M, 0, 0, 11, 10),
        Partial::new(MatrixName::M, 1, 1, 13, 98), Partial::new(MatrixName::C1, 1, 1, 13, 97),
        Partial::new(MatrixName::M, 0, 1, 14, 27), Partial::new(MatrixName::M, 1, 0, 14, 27),
        Partial::new(MatrixName::C1, 0, 1, 14, 38),
        Partial::new(MatrixName::M, 0, 1, 15, 32).negative(),
        Partial::new(MatrixName::M, 1, 0, 15, 32).negative(),
        Partial::new(MatrixName::M, 1, 1, 15, 54),
        Partial::new(MatrixName::C1, 0, 1, 15, 118).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 78),
        Partial::new(MatrixName::K0, 0, 1, 15, 119).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 119).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 92).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 120), Partial::new(MatrixName::M, 0, 0, 16, 15),
        Partial::new(MatrixName::M, 0, 1, 16, 34), Partial::new(MatrixName::M, 1, 0, 16, 34),
        Partial::new(MatrixName::M, 1, 1, 16, 55).negative(),
        Partial::new(MatrixName::C1, 0, 1, 16, 77).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 79).negative(),
        Partial::new(MatrixName::K0, 0, 0, 16, 5), Partial::new(MatrixName::K0, 0, 1, 16, 91),
        Partial::new(MatrixName::K0, 1, 0, 16, 91), Partial::new(MatrixName::K0, 1, 1, 16, 122),
        Partial::new(MatrixName::K2, 0, 1, 16, 116).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 93).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 16),
        Partial::new(MatrixName::M, 0, 1, 17, 35).negative(),
        Partial::new(MatrixName::M, 1, 0, 17, 35).negative(),
        Partial::new(MatrixName::M, 1, 1, 17, 36),
        Partial::new(MatrixName::C1, 0, 1, 17, 124).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 74), Partial::new(MatrixName::K0, 0, 0, 17, 4),
        Partial::new(MatrixName::K0, 0, 1, 17, 33), Partial::new(MatrixName::K0, 1, 0, 17, 33),
        Partial::new(MatrixName::K0, 1, 1, 17, 37).negative(),
        Partial::new(MatrixName::K2, 0, 1, 17, 123).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 42), Partial::new(MatrixName::M, 0, 0, 18, 10),
        Partial::new(MatrixName::M, 0, 1, 18, 11), Partial::new(MatrixName::M, 1, 0, 18, 11),
        Partial::new(MatrixName::M, 1, 1, 18, 121), Partial::new(MatrixName::M, 1, 1, 20, 125),
        Partial::new(MatrixName::C1, 1, 1, 20, 43), Partial::new(MatrixName::M, 0, 1, 21, 29),
        Partial::new(MatrixName::M, 1, 0, 21, 29), Partial::new(MatrixName::M, 1, 1, 21, 127),
        Partial::new(MatrixName::C1, 0, 1, 21, 38), Partial::new(MatrixName::C1, 1, 1, 21, 109),
        Partial::new(MatrixName::M, 0, 0, 22, 17), Partial::new(MatrixName::M, 0, 1, 22, 128),
        Partial::new(MatrixName::M, 1, 0, 22, 128), Partial::new(MatrixName::M, 1, 1, 22, 129),
        Partial::new(MatrixName::C1, 0, 1, 22, 135), Partial::new(MatrixName::C1, 1, 0, 22, 131),
        Partial::new(MatrixName::C1, 1, 1, 22, 136),
        Partial::new(MatrixName::K0, 0, 0, 22, 7).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 137).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 137).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 138).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 134), Partial::new(MatrixName::K2, 1, 1, 22, 139),
        Partial::new(MatrixName::M, 0, 0, 23, 18), Partial::new(MatrixName::M, 0, 1, 23, 141),
        Partial::new(MatrixName::M, 1, 0, 23, 141), Partial::new(MatrixName::M, 1, 1, 23, 142),
        Partial::new(MatrixName::C1, 0, 1, 23, 145), Partial::new(MatrixName::C1, 1, 1, 23, 146),
        Partial::new(MatrixName::K0, 0, 0, 23, 6).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 140).negative(),
        Partial::new(MatrixName::K0, 1, 0, 23, 140).negative(),
        Partial::new(MatrixName::K0, 1, 1, 23, 143).negative(),
        Partial::new(MatrixName::K2, 0, 1, 23, 144), Partial::new(MatrixName::K2, 1, 1, 23, 110),
        Partial::new(MatrixName::M, 0, 0, 24, 10), Partial::new(MatrixName::M, 0, 1, 24, 11),
        Partial::new(MatrixName::M, 1, 0, 24, 11), Partial::new(MatrixName::M, 1, 1, 24, 126),
        Partial::new(MatrixName::C1, 1, 1, 24, 43), Partial::new(MatrixName::C1, 0, 1, 25, 130),
        Partial::new(MatrixName::C1, 1, 0, 25, 130).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 132),
        Partial::new(MatrixName::K2, 1, 1, 25, 133),
        Partial::new(MatrixName::M, 0, 2, 26, 13).negative(),
        Partial::new(MatrixName::M, 1, 2, 26, 51),
        Partial::new(MatrixName::M, 2, 0, 26, 13).negative(),
        Partial::new(MatrixName::M, 2, 1, 26, 51),
        Partial::new(MatrixName::M, 2, 2, 26, 25).negative(),
        Partial::new(MatrixName::C1, 2, 1, 26, 148),
        Partial::new(MatrixName::K0, 0, 2, 26, 8).negative(),
        Partial::new(MatrixName::K0, 2, 0, 26, 8).negative(),
        Partial::new(MatrixName::K0, 2, 2, 26, 8).negative(),
        Partial::new(MatrixName::K2, 2, 1, 26, 147),
        Partial::new(MatrixName::M, 0, 0, 27, 19),
        Partial::new(MatrixName::M, 0, 1, 27, 151).negative(),
        Partial::new(MatrixName::M, 0, 2, 27, 23),
        Partial::new(MatrixName::M, 1, 0, 27, 151).negative(),
        Partial::new(MatrixName::M, 1, 1, 27, 154),
        Partial::new(MatrixName::M, 1, 2, 27, 152).negative(),
        Partial::new(MatrixName::M, 2, 0, 27, 23),
        Partial::new(MatrixName::M, 2, 1, 27, 152).negative(),
        Partial::new(MatrixName::M, 2, 2, 27, 24),
        Partial::new(MatrixName::C1, 0, 1, 27, 157).negative(),
        Partial::new(MatrixName::C1, 1, 1, 27, 156),
        Partial::new(MatrixName::C1, 2, 1, 27, 159).negative(),
        Partial::new(MatrixName::K0, 0, 0, 27, 9),
        Partial::new(MatrixName::K0, 0, 1, 27, 149).negative(),
        Partial::new(MatrixName::K0, 0, 2, 27, 22),
        Partial::new(MatrixName::K0, 1, 0, 27, 149).negative(),
        Partial::new(MatrixName::K0, 1, 1, 27, 150).negative(),
        Partial::new(MatrixName::K0, 2, 0, 27, 22),
        Partial::new(MatrixName::K0, 2, 2, 27, 22),
        Partial::new(MatrixName::K2, 0, 1, 27, 155).negative(),
        Partial::new(MatrixName::K2, 1, 1, 27, 153),
        Partial::new(MatrixName::K2, 2, 1, 27, 158).negative(),
        Partial::new(MatrixName::M, 0, 1, 28, 61).negative(),
        Partial::new(MatrixName::M, 1, 0, 28, 61).negative(),
        Partial::new(MatrixName::M, 1, 1, 28, 105),
        Partial::new(MatrixName::M, 1, 2, 28, 64).negative(),
        Partial::new(MatrixName::M, 2, 1, 28, 64).negative(),
        Partial::new(MatrixName::C1, 0, 1, 28, 160).negative(),
        Partial::new(MatrixName::C1, 1, 1, 28, 162),
        Partial::new(MatrixName::C1, 2, 1, 28, 70).negative(),
        Partial::new(MatrixName::K0, 0, 1, 28, 60).negative(),
        Partial::new(MatrixName::K0, 1, 0, 28, 60).negative(),
        Partial::new(MatrixName::K0, 1, 1, 28, 62).negative(),
        Partial::new(MatrixName::K2, 1, 1, 28, 161),
        Partial::new(MatrixName::M, 0, 0, 29, 20),
        Partial::new(MatrixName::M, 0, 1, 29, 51).negative(),
        Partial::new(MatrixName::M, 0, 2, 29, 26),
        Partial::new(MatrixName::M, 1, 0, 29, 51).negative(),
        Partial::new(MatrixName::M, 1, 2, 29, 51).negative(),
        Partial::new(MatrixName::M, 2, 0, 29, 26),
        Partial::new(MatrixName::M, 2, 1, 29, 51).negative(),
        Partial::new(MatrixName::M, 2, 2, 29, 25),
        Partial::new(MatrixName::C1, 0, 1, 29, 148).negative(),
        Partial::new(MatrixName::C1, 2, 1, 29, 148).negative(),
        Partial::new(MatrixName::K0, 0, 0, 29, 8), Partial::new(MatrixName::K0, 0, 2, 29, 8),
        Partial::new(MatrixName::K0, 2, 0, 29, 8), Partial::new(MatrixName::K0, 2, 2, 29, 8),
        Partial::new(MatrixName::K2, 0, 1, 29, 147).negative(),
        Partial::new(MatrixName::K2, 2, 1, 29, 147).negative(),
        Partial::new(MatrixName::M, 0, 0, 30, 10), Partial::new(MatrixName::M, 0, 2, 30, 10),
        Partial::new(MatrixName::M, 2, 0, 30, 10), Partial::new(MatrixName::M, 2, 2, 30, 10),
        Partial::new(MatrixName::M, 1, 1, 32, 98), Partial::new(MatrixName::C1, 1, 1, 32, 97),
        Partial::new(MatrixName::M, 0, 1, 33, 27), Partial::new(MatrixName::M, 1, 0, 33, 27),
        Partial::new(MatrixName::M, 1, 2, 33, 27), Partial::new(MatrixName::M, 2, 1, 33, 27),
        Partial::new(MatrixName::C1, 0, 1, 33, 38), Partial::new(MatrixName::C1, 2, 1, 33, 38),
        Partial::new(MatrixName::Kc, 2, 2, 34, 10), Partial::new(MatrixName::C0, 2, 2, 35, 10),
    ];
}
