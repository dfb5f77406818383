// @generated from generated/models/whipple_tyres.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 0fd874e368fb3457

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    MotionFormulas, Nonlinear, Number, ParameterError, ParameterInfo, Partial, Rate,
    RequirementInfo, Rows, Scalar, SetInfo, WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// The Whipple-Carvallo bicycle on tyres whose cross-sections are circles.
///
/// Four rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally
/// symmetric. The rims of the wheels are parts of tori that roll without slip on level ground: the radii rR and rF of
/// the wheels reach from the centre to the ground, and those of the cross-sections, rhoR and rhoF, are parts of them.
/// Axes: origin at the rear contact point, x forward, y to the right, z down.
///
/// Source: Mechanism: a bicycle on tyres with circular cross-sections, as in Meijaard & Schwab (2006), Linearized equations for an extended bicycle model, III European Conference on Computational Mechanics
///
/// Derived from a mechanism: body `B` (rear frame and rider), body `H` (front frame), wheel `R` (rear wheel), wheel `F` (front wheel).
///
/// The fields are the parameters. The coordinates are `phi` (lean) in `rad`, `delta` (steer) in `rad`.
///
/// Beside what is said of each field, `validate` requires of them:
///
/// - `rR - rhoR` in `m`: `>= 0`, as the radius of `R` without that of its tyre;
/// - `rF - rhoF` in `m`: `>= 0`, as the radius of `F` without that of its tyre.
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
/// m_all = mR + mB + m_delta [kg]
/// load_spin_F = -Sx_all/w [kg]
/// load_spin_R = -(m_all + load_spin_F) [kg]
/// h_spin_R = IRyy/rR [kg*m]
/// h_spin_F = IFyy/rF [kg*m]
/// h_wheels_all = h_spin_R + h_spin_F [kg*m]
/// M_yaw_delta = py_delta*(w + c) + hz_delta [kg*m^2]
/// M_delta_delta = hx_delta*sin(lam) + hz_delta*cos(lam) [kg*m^2]
/// K_phi_phi = Sz_all - rhoR*load_spin_R - rhoF*load_spin_F [kg*m]
/// K_phi_delta = -(py_delta + load_spin_F*(rhoF*sin(lam) - c*cos(lam))) [kg*m]
/// K_delta_delta = -(py_delta + load_spin_F*(rhoF*sin(lam) - c*cos(lam)))*sin(lam) [kg*m]
/// P_delta_lateral = yaw_by_delta*Sx_all + py_delta [kg*m]
/// P_delta_yaw = yaw_by_delta*Jzz_all + M_yaw_delta [kg*m^2]
/// P_delta_delta = yaw_by_delta*M_yaw_delta + M_delta_delta [kg*m^2]
/// M_11 = Jxx_all [kg*m^2]
/// M_12 = M_21 = yaw_by_delta*Jxz_all + hx_delta [kg*m^2]
/// M_22 = yaw_by_delta*P_delta_yaw + P_delta_delta [kg*m^2]
/// C1_12 = yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_F*cos(lam) [kg*m]
/// C1_21 = -(yaw_by_delta*h_wheels_all + h_spin_F*cos(lam)) [kg*m]
/// C1_22 = yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
/// K0_11 = K_phi_phi [kg*m]
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
pub struct WhippleTyres<T = f64> {
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
    /// Radius of the cross-section of the rear tyre.
    ///
    /// `rhoR` in `m`: `>= 0`.
    pub rhoR: T,
    /// Radius of the cross-section of the front tyre.
    ///
    /// `rhoF` in `m`: `>= 0`.
    pub rhoF: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`WhippleTyres`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleTyresMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 2>,
}

impl<T: Number> WhippleTyres<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 49 additions, 47 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 102 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleTyresMatrices<T> {
        let t2 = self.zH * self.mH;
        let t7 = self.rR * self.mR;
        let K_phi_phi_ = self.zH * t2 + (self.IBxx + self.rR * t7);
        let t14 = self.zB * self.mB;
        let t20 = self.rF * self.mF;
        let t23 = self.IHxx + (self.IFxx + self.rF * t20);
        let M_11 = K_phi_phi_ + (self.IRxx + (self.zB * t14 + t23));
        let (wx_delta2_delta, cos_lam) = self.lam.sin_cos();
        let t31 = self.w + self.c;
        let t36 = self.w.like(1.0) / self.w;
        let yaw_per_v_delta = cos_lam * t36;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let wz_delta2_delta = cos_lam + yaw_by_delta;
        let t42 = self.xH * wz_delta2_delta - self.zH * wx_delta2_delta - cos_lam * t31;
        let t47 = t14 * self.xB - self.IBxz;
        let t50 = wz_delta2_delta * self.IHxz;
        let t52 = t50 + t23 * wx_delta2_delta;
        let M_12 = t52 - yaw_by_delta * t47 - t2 * t42;
        let t57 = wz_delta2_delta * (self.IFxx + self.IHzz);
        let t59 = self.mB * self.xB;
        let t64 = yaw_by_delta * (self.IRxx + self.xB * t59 + self.IBzz);
        let t67 = self.mH * t42;
        let M_22 = wz_delta2_delta * t57 + yaw_by_delta * t64 + t42 * t67
            + wx_delta2_delta * (t50 + t52);
        let zero = self.w.like(0.0);
        let ay_all1_delta = self.mH * self.xH;
        let t77 = t7 - t2 - t14;
        let h_spin_R = self.IRyy / self.rR;
        let h_spin_F = self.IFyy / self.rF;
        let h_wheels_all = h_spin_R + h_spin_F;
        let t83 = t77 + h_wheels_all;
        let vy_delta2_delta = t20 * t31;
        let t88 = self.IHxz + vy_delta2_delta;
        let t91 = cos_lam * h_spin_F;
        let t97 = t67 + yaw_by_delta * t59;
        let C1_22 = yaw_per_v_delta
            * (t57 + (t64 + wx_delta2_delta * t88 + self.c * t97 + self.xH * t67));
        let t107 = t36 * (ay_all1_delta + t59);
        let t114 = (self.mF + t107) * self.rhoF - t20;
        let K0_12 = wx_delta2_delta * t114 - t97;
        let K0_22 = wx_delta2_delta * K0_12;
        let vy_all1_delta = t20 + t83;
        let K2_12 = yaw_per_v_delta * vy_all1_delta;
        let K2_22 = yaw_per_v_delta * (t97 + wx_delta2_delta * (t20 + h_spin_F));
        let C1_12 = t91
            - yaw_per_v_delta * (self.zH * ay_all1_delta + (t47 - self.c * t83) - t88);
        let C1_21 = -(yaw_by_delta * h_wheels_all + t91);
        let K0_11 = (self.mB + (self.mH + self.mR) - t107) * self.rhoR + t114 - t77;
        WhippleTyresMatrices::from_entries([
            M_11, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, K0_11, K0_12, K0_12, K0_22, zero,
            K2_12, zero, K2_22,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`WhippleTyres`] that follow from its coordinates q = (`phi`, `delta`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleTyresKinematics<T = f64> {
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

impl<T: Scalar> WhippleTyres<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> WhippleTyresKinematics<T> {
        let zero = self.w.like(0.0);
        let yaw_per_v_delta = self.lam.cos() / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let t12 = -(self.w.like(1.0) / self.rR);
        let t13 = -(self.w.like(1.0) / self.rF);
        WhippleTyresKinematics {
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

// --- The nonlinear equations of motion -----------------------------------------------------------

/// The nonlinear equations of motion of [`WhippleTyres`], with its parameters: what does not depend on the state is computed.
///
/// Positions: `x` (x of the contact point of the rear wheel) in `m`, `y` (y of the contact point of the rear wheel) in `m`, `psi` (yaw) in `rad`, `phi` (lean) in `rad`, `pitch` (pitch, by the heights of the wheels) in `rad`, `delta` (steer) in `rad`, `thetaR` (angle of the rear wheel) in `rad`, `thetaF` (angle of the front wheel) in `rad`.
/// Speeds: the rates of `phi`, `delta`, `thetaR`.
///
/// Each from one straight-line program:
/// - closure: 16 additions, 32 multiplications, 2 divisions, 1 square root and 6 trigonometric functions: 57 operations
/// - rates: 47 additions, 98 multiplications, 4 divisions, 2 negations, 1 square root and 8 trigonometric functions: 160 operations
/// - derivatives: 349 additions, 477 multiplications, 7 divisions, 2 negations, 1 square root and 8 trigonometric functions: 844 operations
/// - accelerations: 361 additions, 491 multiplications, 7 divisions, 1 negation, 1 square root and 8 trigonometric functions: 869 operations
/// - energy: 157 additions, 216 multiplications, 4 divisions, 1 negation, 1 square root and 6 trigonometric functions: 385 operations
/// - contact forces: 455 additions, 583 multiplications, 7 divisions, 1 negation, 1 square root and 8 trigonometric functions: 1055 operations
/// - linearization: 1769 additions, 2341 multiplications, 7 divisions, 15 negations, 1 square root and 8 trigonometric functions: 4141 operations
/// - by parameters: 2747 additions, 3528 multiplications, 7 divisions, 1 square root and 8 trigonometric functions: 6291 operations
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleTyresMotion<T = f64> {
    constants: [T; 53],
}

impl<T: Number> WhippleTyres<T> {
    /// The nonlinear equations of motion, of what is computed once for these parameters:
    /// 56 additions, 62 multiplications and 2 trigonometric functions: 120 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn motion(&self) -> WhippleTyresMotion<T> {
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t24 = self.w + self.c;
        let t27 = cos_lam * t24 - sin_lam * self.rR;
        let t30 = sin_lam * t24 + cos_lam * self.rR;
        let t31 = self.rR - self.rhoR;
        let t32 = self.w - t24;
        let t35 = cos_lam * t32 + sin_lam * self.rF;
        let t38 = sin_lam * t32 - cos_lam * self.rF;
        let t39 = self.rF - self.rhoF;
        let t40 = t30 + t38;
        let t42 = self.rR + self.zB;
        let t44 = cos_lam * self.xB - sin_lam * t42;
        let t45 = self.mB * t44;
        let t48 = sin_lam * self.xB + cos_lam * t42;
        let t49 = self.mB * t48;
        let t51 = cos_lam * self.IBxz;
        let t52 = sin_lam * self.IBxx + t51;
        let t54 = sin_lam * self.IBxz;
        let t56 = t54 + cos_lam * self.IBzz;
        let t60 = cos_lam * t52 - sin_lam * t56 - t45 * t48;
        let t62 = t48 * t49;
        let t63 = t44 * t45;
        let t65 = self.IByy + t62 + t63;
        let t67 = self.mB + self.mR;
        let t77 = t62 + self.IRxx + cos_lam * (cos_lam * self.IBxx - t54)
            - sin_lam * (t51 - sin_lam * self.IBzz);
        let t82 = t63 + self.IRxx + sin_lam * t52 + cos_lam * t56;
        let t83 = self.mH + self.mF;
        let t84 = self.xH - t24;
        let t87 = cos_lam * t84 - sin_lam * self.zH;
        let t88 = self.mH * t87;
        let t89 = self.mF * t35;
        let t90 = t88 + t89;
        let t93 = sin_lam * t84 + cos_lam * self.zH;
        let t94 = self.mH * t93;
        let t95 = self.mF * t38;
        let t96 = t94 + t95;
        let t99 = sin_lam * self.IHxz;
        let t102 = cos_lam * self.IHxz;
        let t108 = t93 * t94 + t38 * t95;
        let t111 = self.IFxx + cos_lam * (cos_lam * self.IHxx - t99) + t108
            - sin_lam * (t102 - sin_lam * self.IHzz);
        let t113 = t102 + sin_lam * self.IHxx;
        let t116 = t99 + cos_lam * self.IHzz;
        let t122 = cos_lam * t113 - sin_lam * t116 - t88 * t93 - t38 * t89;
        let t126 = t87 * t88 + t35 * t89;
        let t128 = t108 + self.IHyy + t126;
        let t133 = self.IFxx + t126 + sin_lam * t113 + cos_lam * t116;
        let t135 = t111 - t128;
        let t136 = t27 * t83;
        let t137 = t30 * t96;
        let t138 = t30 * t83;
        let t141 = t137 + t137 + t30 * t138;
        let t142 = t27 * t96;
        let t143 = t30 * t136;
        let t144 = t27 * t136;
        let t145 = t67 + t83;
        let t147 = t49 + t96 + t138;
        WhippleTyresMotion {
            constants: [
                self.w, self.c, sin_lam, cos_lam, self.rR, self.rF, self.IBxx, self.IBxz, self.IBzz,
                self.mB, self.xB, self.zB, self.IHxx, self.IHxz, self.IHzz, self.mH, self.xH,
                self.zH, self.IRyy, self.IFyy, self.mF, self.rhoR, self.rhoF, t27, t30, t31, t35,
                t38, t39, t40, t45, t49, t60, t65, t67, t77, t82, t83, t90, t96, t111, t122, t128,
                t133, self.g, t135, t136, t141, t142, t143, t144, t145, t147,
            ],
        }
    }
}

impl<T: Scalar> Nonlinear<2> for WhippleTyres<T> {
    type Motion = WhippleTyresMotion<T>;

    type MotionOver<U: Number> = WhippleTyresMotion<U>;

    fn motion(&self) -> WhippleTyresMotion<T> {
        WhippleTyres::motion(self)
    }

    #[inline(always)]
    fn motion_over<U: Number>(model: &WhippleTyres<U>) -> WhippleTyresMotion<U> {
        WhippleTyres::motion(model)
    }
}

impl<T: Scalar> carvallo::motion::Motion for WhippleTyresMotion<T> {
    const INFO: &'static carvallo::motion::MotionInfo = &carvallo::motion::MotionInfo {
        model: "WhippleTyres",
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
        speeds: &[3, 5, 6],
        dependent: &[4],
        forces: &[
            carvallo::motion::AppliedInfo {
                name: "Tphi", label: "lean torque", unit: "N*m", position: "phi",
            },
            carvallo::motion::AppliedInfo {
                name: "Tdelta", label: "steer torque", unit: "N*m", position: "delta",
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
        &self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2], a: &mut [T], b: &mut [T],
    ) -> Option<Result<(), carvallo::motion::MotionError>> {
        let found = carvallo::motion::Linearizable::linearize(self, positions, speeds, forces);
        Some(found.map(|found| carvallo::motion::Linearization::copy_into(&found, a, b)))
    }
}

#[allow(unused_variables)]
impl<T: Number> carvallo::motion::Unchecked for WhippleTyresMotion<T> {
    type Scalar = T;

    type Positions = [T; 8];

    type Speeds = [T; 3];

    type Dependent = [T; 1];

    type Forces = [T; 2];

    type ContactForces = [[T; 3]; 2];

    #[inline(always)]
    fn closure_unchecked(&self, positions: &[T; 8]) -> ([T; 1], [T; 1]) {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t15 = self.constants[3] * sin_pitch + self.constants[2] * cos_pitch;
        let t16 = cos_phi * t15;
        let t20 = sin_phi * sin_delta;
        let t21 = t20 - cos_delta * t16;
        let t25 = self.constants[3] * cos_pitch - sin_pitch * self.constants[2];
        let t26 = cos_phi * t25;
        let t29 = (t21 * t21 + t26 * t26).sqrt();
        let t38 = self.constants[23] + cos_delta * self.constants[26];
        let t46 = self.constants[22] + t29 * self.constants[28]
            + t20 * self.constants[26] + cos_phi * (t25 * self.constants[29] - t15 * t38)
            - self.constants[21] - cos_phi * self.constants[25];
        let t50 = self.constants[0].like(1.0) / t29;
        let t51 = t26 * t50;
        let t62 = self.constants[28] * (cos_delta * sin_phi + t16 * sin_delta)
            * (cos_phi * sin_delta * t51
                + sin_phi * (t21 * t25 * t50 + cos_delta * t15 * t51));
        let t68 = t46 / (cos_phi * (t62 + t15 * self.constants[29] + t25 * t38));
        ([t46], [t68])
    }

    #[inline(always)]
    fn rates_unchecked(&self, positions: &[T; 8], speeds: &[T; 3]) -> [T; 8] {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t5 = self.constants[25] + self.constants[21] * cos_phi;
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t17 = self.constants[3] * sin_pitch + self.constants[2] * cos_pitch;
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t20 = cos_phi * t17;
        let t24 = sin_phi * sin_delta - cos_delta * t20;
        let t28 = self.constants[3] * cos_pitch - sin_pitch * self.constants[2];
        let t29 = cos_phi * t28;
        let t32 = (t24 * t24 + t29 * t29).sqrt();
        let t33 = self.constants[0].like(1.0) / t32;
        let t34 = t24 * t33;
        let t36 = t29 * t33;
        let t37 = cos_delta * t36;
        let t39 = t28 * t37 - t17 * t34;
        let t44 = (sin_phi * cos_delta + t20 * sin_delta) * self.constants[28];
        let t47 = sin_delta * self.constants[26];
        let t53 = self.constants[23] + cos_delta * self.constants[26];
        let t55 = t28 * self.constants[29] - t17 * t53;
        let t58 = cos_phi * t47 - t39 * t44 - sin_phi * t55;
        let t59 = self.constants[25] * sin_phi + t58;
        let t66 = cos_phi * sin_delta * t36 + sin_phi * (t28 * t34 + t17 * t37);
        let t71 = t44 * t66 + t17 * self.constants[29] + t28 * t53;
        let t73 = self.constants[0].like(1.0) / (cos_phi * t71);
        let t74 = t59 * t73;
        let t80 = t28 * self.constants[24] - t17 * self.constants[23];
        let t82 = t58 + sin_phi * t80;
        let t84 = sin_phi * t28;
        let t88 = t71 - t17 * self.constants[24] - t28 * self.constants[23];
        let t91 = t73 * (t17 * t82 + t84 * t88);
        let t93 = speeds[0] * t74 + speeds[1] * t91;
        let t95 = t5 * (speeds[2] + t93);
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let t99 = self.constants[21] * speeds[0];
        let t105 = cos_psi * t99 - t95 * sin_psi;
        let t106 = sin_phi * t71;
        let t108 = sin_phi * t59;
        let t110 = t39 * t106 + t66 * t108;
        let t114 = self.constants[0].like(1.0) / (t39 * t71 + t59 * t66);
        let t116 = t74 * t110 * t114;
        let t127 = self.constants[22] + t32 * self.constants[28] + sin_phi * t47
            + cos_phi * t55 - cos_phi * t80;
        let t129 = t29 * t88 - t17 * t127;
        let t133 = t84 * t127 + t29 * t82;
        let t138 = t114 * (t39 * t129 + t66 * t133 + t91 * t110);
        let t141 = t5 * t66 * t114;
        let t147 = t66 * t106 - t39 * t108;
        let t151 = t66 * t71 - t39 * t59;
        let t156 = self.constants[0].like(1.0)
            / (self.constants[28] + t32 * self.constants[22]);
        let t173 = speeds[0] * (t116 * t151 - t74 * t147) * t156
            + speeds[1] * t156 * (t39 * t133 + t138 * t151 - t66 * t129 - t91 * t147);
        let t174 = t173 + speeds[2] * t156 * (t5 * t39 + t141 * t151);
        let t175 = -(t95 * cos_psi + t99 * sin_psi);
        let t176 = -(speeds[0] * t116 + speeds[1] * t138 + speeds[2] * t141);
        [t175, t105, t176, speeds[0], t93, speeds[1], speeds[2], t174]
    }

    #[inline(always)]
    fn derivatives_unchecked(&self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2]) -> ([T; 8], [T; 3]) {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t5 = self.constants[25] + self.constants[21] * cos_phi;
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t17 = self.constants[3] * sin_pitch + self.constants[2] * cos_pitch;
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t20 = cos_phi * t17;
        let t24 = sin_phi * sin_delta - cos_delta * t20;
        let t28 = self.constants[3] * cos_pitch - sin_pitch * self.constants[2];
        let t29 = cos_phi * t28;
        let t32 = (t24 * t24 + t29 * t29).sqrt();
        let t33 = self.constants[0].like(1.0) / t32;
        let t34 = t24 * t33;
        let t36 = t29 * t33;
        let t37 = cos_delta * t36;
        let t39 = t28 * t37 - t17 * t34;
        let t42 = sin_phi * cos_delta + t20 * sin_delta;
        let t44 = t42 * self.constants[28];
        let t47 = sin_delta * self.constants[26];
        let t53 = self.constants[23] + cos_delta * self.constants[26];
        let t55 = t28 * self.constants[29] - t17 * t53;
        let t58 = cos_phi * t47 - t39 * t44 - sin_phi * t55;
        let t59 = self.constants[25] * sin_phi + t58;
        let t66 = cos_phi * sin_delta * t36 + sin_phi * (t28 * t34 + t17 * t37);
        let t71 = t44 * t66 + t17 * self.constants[29] + t28 * t53;
        let t73 = self.constants[0].like(1.0) / (cos_phi * t71);
        let t74 = t59 * t73;
        let t80 = t28 * self.constants[24] - t17 * self.constants[23];
        let t82 = t58 + sin_phi * t80;
        let t84 = sin_phi * t28;
        let t88 = t71 - t17 * self.constants[24] - t28 * self.constants[23];
        let t91 = t73 * (t17 * t82 + t84 * t88);
        let t93 = speeds[0] * t74 + speeds[1] * t91;
        let t94 = speeds[2] + t93;
        let t95 = t5 * t94;
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let t99 = self.constants[21] * speeds[0];
        let t105 = cos_psi * t99 - t95 * sin_psi;
        let t106 = sin_phi * t71;
        let t108 = sin_phi * t59;
        let t110 = t39 * t106 + t66 * t108;
        let t114 = self.constants[0].like(1.0) / (t39 * t71 + t59 * t66);
        let t116 = t74 * t110 * t114;
        let t127 = self.constants[22] + t32 * self.constants[28] + sin_phi * t47
            + cos_phi * t55 - cos_phi * t80;
        let t129 = t29 * t88 - t17 * t127;
        let t133 = t84 * t127 + t29 * t82;
        let t138 = t114 * (t39 * t129 + t66 * t133 + t91 * t110);
        let t141 = t5 * t66 * t114;
        let t144 = speeds[0] * t116 + speeds[1] * t138 + speeds[2] * t141;
        let t147 = t66 * t106 - t39 * t108;
        let t151 = t66 * t71 - t39 * t59;
        let t155 = self.constants[28] + t32 * self.constants[22];
        let t156 = self.constants[0].like(1.0) / t155;
        let t157 = (t116 * t151 - t74 * t147) * t156;
        let t166 = t156 * (t39 * t133 + t138 * t151 - t66 * t129 - t91 * t147);
        let t171 = t156 * (t5 * t39 + t141 * t151);
        let t174 = speeds[0] * t157 + speeds[1] * t166 + speeds[2] * t171;
        let t177 = cos_phi * t144;
        let t178 = t94 * t177;
        let t180 = sin_phi * t144;
        let t181 = self.constants[25] * t180;
        let t183 = t177 * t181 - t5 * t178;
        let t186 = t183 + sin_phi * self.constants[44];
        let t191 = speeds[0] * t17 - t28 * t177;
        let t192 = t93 * t191;
        let t193 = speeds[0] * t180;
        let t194 = t93 - t180;
        let t195 = self.constants[24] * t194;
        let t199 = speeds[0] * t28 + t17 * t177;
        let t200 = self.constants[23] * t194;
        let t202 = t191 * t195 + t199 * t200;
        let t204 = t93 * t199;
        let t205 = t28 * t193 + t204;
        let t208 = t192 + t17 * t193;
        let t212 = t202 + self.constants[23] * t205 + self.constants[24] * t208 - t183;
        let t217 = self.constants[23] * t191 - self.constants[24] * t199;
        let t219 = t194 * t200 + t191 * t217;
        let t220 = speeds[0] * t177;
        let t223 = self.constants[21] * sin_phi;
        let t224 = speeds[0] * t94;
        let t227 = self.constants[25] * speeds[0];
        let t228 = t177 * t227;
        let t230 = t5 * t220 + t223 * (t193 + t224) + t228;
        let t237 = t178 * t223 + t181 * (t94 - t180) - speeds[0] * t227;
        let t241 = t28 * t230 + t17 * t237 - t219 - self.constants[24] * t220;
        let t243 = speeds[1] + t191;
        let t247 = cos_delta * t194 - sin_delta * t199;
        let t248 = self.constants[27] * t247;
        let t252 = cos_delta * t199 + sin_delta * t194;
        let t253 = self.constants[26] * t247;
        let t258 = speeds[1] * t247;
        let t260 = t258 - cos_delta * t208 - sin_delta * t220;
        let t262 = t34 * t155;
        let t264 = t205 + t174 * t252;
        let t266 = t36 * t155;
        let t268 = t260 - t174 * t243;
        let t274 = t33 * (t34 * t252 + t36 * t243) * t44;
        let t275 = t36 * t274;
        let t277 = t34 * t274;
        let t283 = cos_delta * t212 + t243 * t248 + t252 * t253
            + self.constants[26] * t205 + t262 * t264 + t243 * t275;
        let t287 = t283 + t252 * t277 - sin_delta * t241 - self.constants[27] * t260
            - t266 * t268;
        let t294 = self.constants[26] * t243 - self.constants[27] * t252;
        let t298 = speeds[1] * t252;
        let t300 = sin_delta * t208 - cos_delta * t220 - t298;
        let t303 = t42 * self.constants[22];
        let t305 = t174 + t247;
        let t310 = self.constants[28] * (t34 * t243 - t36 * t252);
        let t316 = cos_delta * t241 + sin_delta * t212 + self.constants[27] * t300
            + t266 * t300 - t247 * t253 - t243 * t294;
        let t319 = t316 - t264 * t303 - t277 * t305 - t243 * t310;
        let t323 = t199 * t217 - t194 * t195;
        let t338 = t323 + self.constants[23] * t220 + t17 * t230 + t252 * t294
            + t268 * t303 + t252 * t310;
        let t343 = t338 - t28 * t237 - t247 * t248 - self.constants[26] * t300
            - t262 * t300 - t275 * t305;
        let t345 = t34 * t319 + t36 * t343;
        let t350 = t73 * (t42 * t287 + t32 * t345);
        let t354 = t114 * (t32 * t287 + t110 * t350 - t42 * t345);
        let t356 = t193 - cos_phi * t354;
        let t358 = t192 + t17 * t356;
        let t362 = t204 + t28 * t356;
        let t369 = t194 * self.constants[33] + self.constants[18] * (speeds[2] + t194);
        let t374 = t199 * self.constants[35] + self.constants[32] * t191;
        let t381 = t202 + self.constants[23] * t362 + self.constants[24] * t358 - t186;
        let t385 = t350 - t220 - sin_phi * t354;
        let t391 = t5 * t385 - t228 - t223 * (t224 + t356);
        let t394 = t237 + cos_phi * self.constants[44];
        let t396 = t17 * t394 - t28 * t391;
        let t398 = self.constants[24] * t385 + t396 - t219;
        let t400 = cos_delta * t381 - sin_delta * t398;
        let t406 = t258 + sin_delta * t385 - cos_delta * t358;
        let t414 = t247 * self.constants[42] + t305 * self.constants[19];
        let t419 = t252 * self.constants[40] + t243 * self.constants[41];
        let t424 = self.constants[38] * t400 + self.constants[41] * t406
            + t362 * self.constants[43] + t252 * t414 - t247 * t419;
        let t428 = cos_delta * t398 + sin_delta * t381;
        let t434 = cos_delta * t385 + sin_delta * t358 - t298;
        let t436 = t247 * self.constants[38];
        let t440 = t243 * self.constants[38] - t252 * self.constants[39];
        let t444 = self.constants[37] * t428 + self.constants[39] * t434 - t247 * t436
            - t243 * t440;
        let t449 = t247 * self.constants[39];
        let t455 = t400 * self.constants[37] + t362 * self.constants[38] + t243 * t449
            + t252 * t436 - t406 * self.constants[39];
        let t457 = sin_delta * t444 + cos_delta * t455;
        let t463 = self.constants[36] * t362 + t199 * t369 + t424
            + self.constants[23] * t457 - self.constants[30] * t186
            - self.constants[32] * t358;
        let t464 = t463 - t194 * t374;
        let t472 = self.constants[32] * t199 + t191 * self.constants[36];
        let t480 = t252 * self.constants[41] + t243 * self.constants[43];
        let t486 = t406 * self.constants[40] + t362 * self.constants[41] + t247 * t480
            - t400 * self.constants[39] - t243 * t414;
        let t492 = t28 * t394 + t17 * t391;
        let t494 = t323 - self.constants[23] * t385 - t492;
        let t505 = t434 + t156 * (t34 * t343 + t151 * t354 - t36 * t319 - t147 * t350);
        let t506 = self.constants[19] * t505;
        let t513 = t428 * self.constants[39] + self.constants[42] * t434 + t506
            + t243 * t419 - self.constants[38] * t494 - t252 * t480;
        let t520 = t186 * self.constants[31] + self.constants[32] * t362 + t194 * t472
            + cos_delta * t486 - t358 * self.constants[35] - t191 * t369;
        let t522 = t520 - sin_delta * t513 - self.constants[24] * t457;
        let t529 = self.constants[30] * t191 - t199 * self.constants[31];
        let t531 = t194 * self.constants[31];
        let t539 = self.constants[37] * t494 + t252 * t440 - self.constants[38] * t434
            - t247 * t449;
        let t543 = t199 * t529 + t539 - t492 * self.constants[34]
            - self.constants[30] * t385 - t194 * t531;
        let t547 = self.constants[30] * t194;
        let t552 = cos_delta * t444 - sin_delta * t455;
        let t556 = t396 * self.constants[34] + t385 * self.constants[31] + t552
            - t194 * t547 - t191 * t529;
        let t569 = t457 + self.constants[30] * t362 + t358 * self.constants[31]
            + t191 * t531 + t199 * t547 - t186 * self.constants[34];
        let t572 = t74 - sin_phi * t116;
        let t585 = t17 * t543 + t28 * t556;
        let t587 = self.constants[18] * t385 - t5 * t585;
        let t592 = t396 * self.constants[31] + self.constants[30] * t492
            + self.constants[33] * t385 + t191 * t374 + sin_delta * t486
            + cos_delta * t513;
        let t596 = t592 + self.constants[24] * t552 + t587 - t199 * t472
            - self.constants[23] * t539;
        let t598 = cos_phi * t116;
        let t603 = t28 * t464 + t223 * t585 - t17 * t522;
        let t608 = forces[0] + t223 * (t28 * t543 - t17 * t556) + t598 * t603
            - t17 * t464;
        let t612 = t608 - t28 * t522 - t5 * t569 - t572 * t596 - t157 * t506;
        let t614 = sin_delta * self.constants[45];
        let t615 = sin_delta * t614;
        let t619 = self.constants[35] + self.constants[40] + self.constants[47] - t615;
        let t620 = cos_delta * self.constants[38];
        let t621 = self.constants[23] * t620;
        let t624 = t621 + t621 + self.constants[50];
        let t626 = self.constants[36] + self.constants[43] + t624;
        let t627 = t626 - t619;
        let t628 = t17 * t17;
        let t630 = t17 * t28;
        let t635 = cos_delta * self.constants[41] - self.constants[24] * t620;
        let t638 = self.constants[32] + t635 - self.constants[48] - self.constants[49];
        let t639 = t638 + t638;
        let t641 = t627 * t628 + t630 * t639;
        let t642 = sin_delta * self.constants[38];
        let t643 = t223 * t642;
        let t645 = t223 * self.constants[51];
        let t648 = t223 * t645 - t643 - t643;
        let t653 = self.constants[30] + t620 + self.constants[46];
        let t655 = t28 * self.constants[52] - t17 * t653;
        let t656 = t5 * t655;
        let t657 = t5 * self.constants[51];
        let t658 = t5 * t657;
        let t660 = t658 - t656 - t656;
        let t663 = sin_delta * self.constants[41] - self.constants[24] * t642;
        let t667 = cos_delta * t614 - self.constants[23] * t642;
        let t671 = t17 * self.constants[52] + t28 * t653;
        let t674 = t17 * t663 + t28 * t667 + t223 * t671;
        let t681 = t638 + t627 * t630 + t5 * t671 - t628 * t639;
        let t687 = self.constants[33] + self.constants[42] + t615 + self.constants[47]
            + t624 + t660;
        let t697 = t28 * t663 + t223 * t655 + t5 * t642 - t17 * t667 - t5 * t645;
        let t704 = t626 + t648 - t641;
        let t709 = self.constants[18] * t572;
        let t713 = t17 * sin_delta;
        let t717 = t157 + cos_delta * t572 - sin_delta * t28 - t598 * t713;
        let t718 = self.constants[19] * t717;
        let t725 = t619 + t641 + t648 + t660 + t572 * t674
            + t572 * (t674 + t572 * t687 - t598 * t697) + t572 * t709;
        let t728 = t725 + t717 * t718 - t598 * t681
            - t598 * (t681 + t572 * t697 - t598 * t704);
        let t729 = self.constants[0].like(1.0) / t728;
        let t731 = self.constants[43] + t621;
        let t737 = t91 - sin_phi * t138;
        let t739 = cos_phi * t138;
        let t741 = t28 * t642;
        let t742 = t5 * t741;
        let t743 = t663 + t742;
        let t747 = t743 + t687 * t737 - t697 * t739;
        let t753 = t28 * t731 - t17 * t635 - t223 * t741;
        let t757 = t753 + t697 * t737 - t704 * t739;
        let t763 = t166 + cos_delta * t737 - t713 * t739;
        let t769 = t17 * t731 + t28 * t635 + t5 * t620 + t674 * t737 + t572 * t747
            + t709 * t737;
        let t774 = t729 * (t769 + t718 * t763 - t17 * t643 - t681 * t739 - t598 * t757);
        let t779 = self.constants[18] * t737;
        let t781 = self.constants[19] * t763;
        let t783 = t728 * t774;
        let t789 = self.constants[43] + t737 * t747 + t737 * t743 + t737 * t779
            + t763 * t781 - t739 * t757;
        let t791 = t789 - t739 * t753 - t774 * t783;
        let t792 = self.constants[0].like(1.0) / t791;
        let t802 = forces[1] + t603 * t739 - t424 - t596 * t737 - t166 * t506
            - t612 * t774;
        let t805 = t5 * (t655 - t657);
        let t806 = sin_phi * t141;
        let t808 = cos_phi * t141;
        let t811 = t805 + t687 * t806 + t697 * t808;
        let t814 = t5 * (t642 - t645);
        let t818 = t814 - t697 * t806 - t704 * t808;
        let t823 = self.constants[0].like(1.0) - t806;
        let t828 = t171 - cos_delta * t806 - t713 * t808;
        let t840 = t709 * t823 + t718 * t828 - t674 * t806 - t681 * t808 - t572 * t811
            - t598 * t818;
        let t841 = t729 * t840;
        let t847 = t742 + t779 * t823 + t781 * t828 - t737 * t811 - t739 * t818
            - t743 * t806;
        let t850 = t792 * (t847 - t753 * t808 - t783 * t841);
        let t860 = t596 * t806 + t603 * t808 - t587 - t171 * t506 - t612 * t841
            - t802 * t850;
        let t877 = t658 + t806 * t811 + t805 * t806 + self.constants[18] * t823 * t823
            + self.constants[19] * t828 * t828 - t808 * t818;
        let t881 = t860 / (t877 - t808 * t814 - t728 * t841 * t841 - t791 * t850 * t850);
        let t883 = t792 * t802 - t850 * t881;
        let t887 = t612 * t729 - t774 * t883 - t841 * t881;
        let t888 = -(t95 * cos_psi + t99 * sin_psi);
        let t889 = -t144;
        (
            [t888, t105, t889, speeds[0], t93, speeds[1], speeds[2], t174],
            [t887, t883, t881],
        )
    }

    #[inline(always)]
    fn accelerations_unchecked(&self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2]) -> [T; 8] {
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t15 = self.constants[3] * sin_pitch + self.constants[2] * cos_pitch;
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t19 = t15 * cos_phi;
        let t23 = sin_phi * sin_delta - cos_delta * t19;
        let t27 = self.constants[3] * cos_pitch - sin_pitch * self.constants[2];
        let t28 = cos_phi * t27;
        let t31 = (t23 * t23 + t28 * t28).sqrt();
        let t32 = self.constants[0].like(1.0) / t31;
        let t33 = t23 * t32;
        let t35 = t28 * t32;
        let t36 = cos_delta * t35;
        let t38 = t27 * t36 - t15 * t33;
        let t41 = sin_phi * cos_delta + t19 * sin_delta;
        let t43 = t41 * self.constants[28];
        let t46 = sin_delta * self.constants[26];
        let t52 = self.constants[23] + cos_delta * self.constants[26];
        let t54 = t27 * self.constants[29] - t15 * t52;
        let t57 = cos_phi * t46 - t38 * t43 - sin_phi * t54;
        let t58 = sin_phi * self.constants[25] + t57;
        let t65 = cos_phi * sin_delta * t35 + sin_phi * (t27 * t33 + t15 * t36);
        let t70 = t43 * t65 + t15 * self.constants[29] + t27 * t52;
        let t72 = self.constants[0].like(1.0) / (cos_phi * t70);
        let t73 = t58 * t72;
        let t79 = t27 * self.constants[24] - t15 * self.constants[23];
        let t81 = t57 + sin_phi * t79;
        let t83 = sin_phi * t27;
        let t87 = t70 - t15 * self.constants[24] - t27 * self.constants[23];
        let t90 = t72 * (t15 * t81 + t83 * t87);
        let t92 = speeds[0] * t73 + speeds[1] * t90;
        let t93 = speeds[2] + t92;
        let t95 = speeds[0] * self.constants[21];
        let t99 = self.constants[25] + cos_phi * self.constants[21];
        let t103 = self.constants[0].like(1.0) / (t38 * t70 + t58 * t65);
        let t104 = sin_phi * t70;
        let t106 = sin_phi * t58;
        let t108 = t38 * t104 + t65 * t106;
        let t110 = t73 * t103 * t108;
        let t121 = self.constants[22] + t31 * self.constants[28] + sin_phi * t46
            + cos_phi * t54 - cos_phi * t79;
        let t123 = t28 * t87 - t15 * t121;
        let t127 = t83 * t121 + t28 * t81;
        let t132 = t103 * (t38 * t123 + t65 * t127 + t90 * t108);
        let t135 = t65 * t99 * t103;
        let t138 = speeds[0] * t110 + speeds[1] * t132 + speeds[2] * t135;
        let t139 = cos_phi * t138;
        let t140 = speeds[0] * t139;
        let t143 = speeds[0] * t15 - t27 * t139;
        let t144 = sin_phi * t138;
        let t145 = t92 - t144;
        let t146 = self.constants[24] * t145;
        let t150 = speeds[0] * t27 + t15 * t139;
        let t151 = self.constants[23] * t145;
        let t153 = t143 * t146 + t150 * t151;
        let t154 = speeds[0] * t144;
        let t156 = t92 * t150;
        let t157 = t27 * t154 + t156;
        let t160 = t92 * t143;
        let t161 = t15 * t154 + t160;
        let t163 = t93 * t139;
        let t165 = self.constants[25] * t144;
        let t167 = t139 * t165 - t99 * t163;
        let t170 = t153 + self.constants[23] * t157 + self.constants[24] * t161 - t167;
        let t175 = self.constants[23] * t143 - self.constants[24] * t150;
        let t177 = t145 * t151 + t143 * t175;
        let t179 = speeds[0] * self.constants[25];
        let t180 = t139 * t179;
        let t182 = sin_phi * self.constants[21];
        let t183 = speeds[0] * t93;
        let t187 = t180 + t99 * t140 + t182 * (t154 + t183);
        let t194 = t163 * t182 + t165 * (t93 - t144) - speeds[0] * t179;
        let t198 = t27 * t187 + t15 * t194 - t177 - self.constants[24] * t140;
        let t200 = speeds[1] + t143;
        let t204 = cos_delta * t145 - sin_delta * t150;
        let t205 = self.constants[27] * t204;
        let t209 = cos_delta * t150 + sin_delta * t145;
        let t210 = self.constants[26] * t204;
        let t215 = speeds[1] * t204;
        let t217 = t215 - cos_delta * t161 - sin_delta * t140;
        let t220 = self.constants[28] + t31 * self.constants[22];
        let t221 = t33 * t220;
        let t224 = t65 * t104 - t38 * t106;
        let t228 = t65 * t70 - t38 * t58;
        let t231 = self.constants[0].like(1.0) / t220;
        let t232 = (t110 * t228 - t73 * t224) * t231;
        let t241 = t231 * (t38 * t127 + t132 * t228 - t65 * t123 - t90 * t224);
        let t246 = t231 * (t38 * t99 + t135 * t228);
        let t249 = speeds[0] * t232 + speeds[1] * t241 + speeds[2] * t246;
        let t251 = t157 + t209 * t249;
        let t253 = t35 * t220;
        let t255 = t217 - t200 * t249;
        let t261 = t32 * (t33 * t209 + t35 * t200) * t43;
        let t262 = t35 * t261;
        let t264 = t33 * t261;
        let t270 = cos_delta * t170 + t200 * t205 + t209 * t210
            + self.constants[26] * t157 + t221 * t251 + t200 * t262;
        let t274 = t270 + t209 * t264 - sin_delta * t198 - self.constants[27] * t217
            - t253 * t255;
        let t281 = self.constants[26] * t200 - self.constants[27] * t209;
        let t285 = speeds[1] * t209;
        let t287 = sin_delta * t161 - cos_delta * t140 - t285;
        let t290 = t41 * self.constants[22];
        let t292 = t204 + t249;
        let t297 = self.constants[28] * (t33 * t200 - t35 * t209);
        let t303 = cos_delta * t198 + sin_delta * t170 + self.constants[27] * t287
            + t253 * t287 - t204 * t210 - t200 * t281;
        let t306 = t303 - t251 * t290 - t264 * t292 - t200 * t297;
        let t310 = t150 * t175 - t145 * t146;
        let t325 = t310 + self.constants[23] * t140 + t15 * t187 + t209 * t281
            + t255 * t290 + t209 * t297;
        let t330 = t325 - t27 * t194 - t204 * t205 - self.constants[26] * t287
            - t221 * t287 - t262 * t292;
        let t332 = t33 * t306 + t35 * t330;
        let t335 = t72 * (t41 * t274 + t31 * t332);
        let t341 = t103 * (t31 * t274 + t108 * t335 - t41 * t332);
        let t344 = t335 - t140 - sin_phi * t341;
        let t349 = t194 + cos_phi * self.constants[44];
        let t353 = t154 - cos_phi * t341;
        let t357 = t99 * t344 - t180 - t182 * (t183 + t353);
        let t359 = t27 * t349 + t15 * t357;
        let t362 = t310 - t359 - self.constants[23] * t344;
        let t368 = t160 + t15 * t353;
        let t371 = cos_delta * t344 + sin_delta * t368 - t285;
        let t376 = t200 * self.constants[38] - t209 * self.constants[39];
        let t378 = t204 * self.constants[39];
        let t382 = t362 * self.constants[37] + t209 * t376 - self.constants[38] * t371
            - t204 * t378;
        let t390 = t143 * self.constants[30] - self.constants[31] * t150;
        let t392 = self.constants[31] * t145;
        let t397 = t382 + t150 * t390 - t359 * self.constants[34]
            - t344 * self.constants[30] - t145 * t392;
        let t401 = t15 * t349 - t27 * t357;
        let t404 = t401 + self.constants[24] * t344 - t177;
        let t407 = t156 + t27 * t353;
        let t411 = t167 + sin_phi * self.constants[44];
        let t414 = t153 + self.constants[23] * t407 + self.constants[24] * t368 - t411;
        let t416 = cos_delta * t404 + sin_delta * t414;
        let t419 = t204 * self.constants[38];
        let t424 = t416 * self.constants[37] + self.constants[39] * t371 - t204 * t419
            - t200 * t376;
        let t428 = cos_delta * t414 - sin_delta * t404;
        let t434 = t215 + sin_delta * t344 - cos_delta * t368;
        let t441 = t428 * self.constants[37] + t407 * self.constants[38] + t200 * t378
            + t209 * t419 - self.constants[39] * t434;
        let t443 = cos_delta * t424 - sin_delta * t441;
        let t446 = t145 * self.constants[30];
        let t452 = t443 + t401 * self.constants[34] + self.constants[31] * t344
            - t145 * t446 - t143 * t390;
        let t454 = t15 * t397 + t27 * t452;
        let t456 = t344 * self.constants[18] - t99 * t454;
        let t457 = sin_phi * t135;
        let t466 = t150 * self.constants[35] + t143 * self.constants[32];
        let t471 = t150 * self.constants[32] + t143 * self.constants[36];
        let t481 = t209 * self.constants[41] + t200 * self.constants[43];
        let t487 = t204 * self.constants[42] + t292 * self.constants[19];
        let t492 = self.constants[40] * t434 + t407 * self.constants[41] + t204 * t481
            - self.constants[39] * t428 - t200 * t487;
        let t504 = t231 * (t33 * t330 + t228 * t341 - t35 * t306 - t224 * t335);
        let t506 = self.constants[19] * (t371 + t504);
        let t509 = t209 * self.constants[40] + t200 * self.constants[41];
        let t516 = self.constants[39] * t416 + self.constants[42] * t371 + t506
            + t200 * t509 - self.constants[38] * t362 - t209 * t481;
        let t524 = self.constants[31] * t401 + self.constants[30] * t359
            + t344 * self.constants[33] + t143 * t466 + sin_delta * t492
            + cos_delta * t516;
        let t528 = t524 + self.constants[24] * t443 + t456 - t150 * t471
            - self.constants[23] * t382;
        let t530 = cos_phi * t135;
        let t537 = t145 * self.constants[33] + self.constants[18] * (speeds[2] + t145);
        let t548 = t428 * self.constants[38] + t434 * self.constants[41]
            + t407 * self.constants[43] + t209 * t487 - t204 * t509;
        let t551 = sin_delta * t424 + cos_delta * t441;
        let t557 = self.constants[36] * t407 + t150 * t537 + t548
            + self.constants[23] * t551 - self.constants[30] * t411
            - self.constants[32] * t368;
        let t558 = t557 - t145 * t466;
        let t572 = self.constants[31] * t411 + self.constants[32] * t407 + t145 * t471
            + cos_delta * t492 - self.constants[35] * t368 - t143 * t537;
        let t574 = t572 - sin_delta * t516 - self.constants[24] * t551;
        let t578 = t27 * t558 + t182 * t454 - t15 * t574;
        let t597 = t551 + self.constants[30] * t407 + self.constants[31] * t368
            + t143 * t392 + t150 * t446 - t411 * self.constants[34];
        let t600 = t73 - sin_phi * t110;
        let t602 = cos_phi * t110;
        let t607 = forces[0] + t182 * (t27 * t397 - t15 * t452) + t578 * t602
            - t15 * t558;
        let t611 = t607 - t27 * t574 - t99 * t597 - t528 * t600 - t232 * t506;
        let t613 = sin_delta * self.constants[38];
        let t615 = sin_delta * self.constants[41] - self.constants[24] * t613;
        let t618 = sin_delta * self.constants[45];
        let t621 = cos_delta * t618 - self.constants[23] * t613;
        let t625 = cos_delta * self.constants[38];
        let t628 = self.constants[30] + t625 + self.constants[46];
        let t630 = t15 * self.constants[52] + t27 * t628;
        let t633 = t15 * t615 + t27 * t621 + t182 * t630;
        let t639 = cos_delta * self.constants[41] - self.constants[24] * t625;
        let t642 = self.constants[32] + t639 - self.constants[48] - self.constants[49];
        let t643 = sin_delta * t618;
        let t647 = self.constants[35] + self.constants[40] + self.constants[47] - t643;
        let t648 = self.constants[23] * t625;
        let t651 = t648 + t648 + self.constants[50];
        let t653 = self.constants[36] + self.constants[43] + t651;
        let t654 = t653 - t647;
        let t655 = t15 * t27;
        let t657 = t15 * t15;
        let t658 = t642 + t642;
        let t663 = t642 + t654 * t655 + t99 * t630 - t657 * t658;
        let t667 = t27 * self.constants[52] - t15 * t628;
        let t669 = t99 * self.constants[51];
        let t671 = t99 * (t667 - t669);
        let t672 = t99 * t667;
        let t673 = t99 * t669;
        let t675 = t673 - t672 - t672;
        let t680 = self.constants[33] + self.constants[42] + t643 + self.constants[47]
            + t651 + t675;
        let t686 = t182 * self.constants[51];
        let t691 = t27 * t615 + t182 * t667 + t99 * t613 - t15 * t621 - t99 * t686;
        let t694 = t671 + t457 * t680 + t530 * t691;
        let t697 = t99 * (t613 - t686);
        let t701 = t654 * t657 + t655 * t658;
        let t702 = t182 * t613;
        let t705 = t182 * t686 - t702 - t702;
        let t707 = t653 + t705 - t701;
        let t710 = t697 - t457 * t691 - t530 * t707;
        let t713 = self.constants[0].like(1.0) - t457;
        let t714 = self.constants[18] * t600;
        let t717 = t15 * sin_delta;
        let t720 = t246 - cos_delta * t457 - t530 * t717;
        let t726 = t232 + cos_delta * t600 - sin_delta * t27 - t602 * t717;
        let t727 = self.constants[19] * t726;
        let t733 = t713 * t714 + t720 * t727 - t457 * t633 - t530 * t663 - t600 * t694
            - t602 * t710;
        let t753 = t647 + t675 + t701 + t705 + t600 * t633
            + t600 * (t633 + t600 * t680 - t602 * t691) + t600 * t714;
        let t756 = t753 + t726 * t727 - t602 * t663
            - t602 * (t663 + t600 * t691 - t602 * t707);
        let t757 = self.constants[0].like(1.0) / t756;
        let t758 = t733 * t757;
        let t760 = t27 * t613;
        let t761 = t99 * t760;
        let t763 = t90 - sin_phi * t132;
        let t765 = cos_phi * t132;
        let t767 = t615 + t761;
        let t769 = self.constants[43] + t648;
        let t774 = t27 * t769 - t15 * t639 - t182 * t760;
        let t776 = self.constants[18] * t763;
        let t781 = t241 + cos_delta * t763 - t717 * t765;
        let t782 = self.constants[19] * t781;
        let t793 = t767 + t680 * t763 - t691 * t765;
        let t798 = t774 + t691 * t763 - t707 * t765;
        let t806 = t15 * t769 + t27 * t639 + t99 * t625 + t633 * t763 + t600 * t793
            + t714 * t763;
        let t811 = t757 * (t806 + t727 * t781 - t15 * t702 - t663 * t765 - t602 * t798);
        let t812 = t756 * t811;
        let t818 = t761 + t713 * t776 + t720 * t782 - t694 * t763 - t710 * t765
            - t457 * t767;
        let t832 = self.constants[43] + t763 * t793 + t763 * t767 + t763 * t776
            + t781 * t782 - t765 * t798;
        let t834 = t832 - t765 * t774 - t811 * t812;
        let t835 = self.constants[0].like(1.0) / t834;
        let t836 = (t818 - t530 * t774 - t758 * t812) * t835;
        let t846 = forces[1] + t578 * t765 - t548 - t528 * t763 - t241 * t506
            - t611 * t811;
        let t852 = t457 * t528 + t530 * t578 - t456 - t246 * t506 - t611 * t758
            - t836 * t846;
        let t869 = t673 + t457 * t694 + t457 * t671 + self.constants[18] * t713 * t713
            + self.constants[19] * t720 * t720 - t530 * t710;
        let t873 = t852 / (t869 - t530 * t697 - t756 * t758 * t758 - t834 * t836 * t836);
        let t877 = t835 * t846 - t836 * t873;
        let t881 = t611 * t757 - t811 * t877 - t758 * t873;
        let t885 = t335 + t73 * t881 + t90 * t877;
        let t890 = sin_phi * t93 * t95 + t95 * t138 - t99 * (t873 + t885);
        let t896 = self.constants[21] * t881 + t93 * t99 * t138;
        let t898 = cos_psi * t890 - sin_psi * t896;
        let t901 = t890 * sin_psi + cos_psi * t896;
        let t913 = t504 + t232 * t881 + t241 * t877 + t246 * t873;
        let t914 = -(t341 + t110 * t881 + t132 * t877 + t135 * t873);
        [t898, t901, t914, t881, t885, t877, t873, t913]
    }

    fn energy_unchecked(&self, positions: &[T; 8], speeds: &[T; 3]) -> [T; 2] {
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t6 = sin_delta * self.constants[45];
        let t7 = sin_delta * t6;
        let t11 = self.constants[35] + self.constants[40] + self.constants[47] - t7;
        let t17 = cos_delta * self.constants[38];
        let t18 = self.constants[23] * t17;
        let t21 = t18 + t18 + self.constants[50];
        let t23 = self.constants[36] + self.constants[43] + t21;
        let t24 = t23 - t11;
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t32 = self.constants[3] * sin_pitch + self.constants[2] * cos_pitch;
        let t33 = t32 * t32;
        let t37 = self.constants[3] * cos_pitch - sin_pitch * self.constants[2];
        let t38 = t32 * t37;
        let t46 = cos_delta * self.constants[41] - t17 * self.constants[24];
        let t49 = self.constants[32] + t46 - self.constants[48] - self.constants[49];
        let t50 = t49 + t49;
        let t52 = t24 * t33 + t38 * t50;
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t56 = self.constants[21] * sin_phi;
        let t57 = sin_delta * self.constants[38];
        let t58 = t56 * t57;
        let t60 = t56 * self.constants[51];
        let t63 = t56 * t60 - t58 - t58;
        let t67 = self.constants[25] + self.constants[21] * cos_phi;
        let t73 = t17 + self.constants[30] + self.constants[46];
        let t75 = t37 * self.constants[52] - t32 * t73;
        let t76 = t67 * t75;
        let t77 = self.constants[51] * t67;
        let t78 = t67 * t77;
        let t80 = t78 - t76 - t76;
        let t83 = sin_delta * self.constants[41] - self.constants[24] * t57;
        let t87 = t6 * cos_delta - self.constants[23] * t57;
        let t91 = t32 * self.constants[52] + t37 * t73;
        let t94 = t32 * t83 + t37 * t87 + t56 * t91;
        let t96 = t32 * cos_phi;
        let t99 = sin_delta * sin_phi - cos_delta * t96;
        let t101 = t37 * cos_phi;
        let t104 = (t99 * t99 + t101 * t101).sqrt();
        let t105 = self.constants[0].like(1.0) / t104;
        let t106 = t99 * t105;
        let t108 = t101 * t105;
        let t109 = cos_delta * t108;
        let t111 = t37 * t109 - t32 * t106;
        let t116 = (cos_delta * sin_phi + sin_delta * t96) * self.constants[28];
        let t119 = sin_delta * self.constants[26];
        let t124 = self.constants[23] + cos_delta * self.constants[26];
        let t126 = t37 * self.constants[29] - t32 * t124;
        let t129 = cos_phi * t119 - t111 * t116 - sin_phi * t126;
        let t130 = sin_phi * self.constants[25] + t129;
        let t137 = sin_delta * cos_phi * t108 + sin_phi * (t37 * t106 + t32 * t109);
        let t142 = t116 * t137 + t32 * self.constants[29] + t37 * t124;
        let t144 = self.constants[0].like(1.0) / (cos_phi * t142);
        let t145 = t130 * t144;
        let t146 = sin_phi * t142;
        let t148 = sin_phi * t130;
        let t150 = t111 * t146 + t137 * t148;
        let t154 = self.constants[0].like(1.0) / (t111 * t142 + t130 * t137);
        let t156 = t145 * t150 * t154;
        let t158 = t145 - sin_phi * t156;
        let t165 = t49 + t24 * t38 + t67 * t91 - t33 * t50;
        let t166 = cos_phi * t156;
        let t174 = t7 + self.constants[47] + t21 + t80 + self.constants[33]
            + self.constants[42];
        let t184 = t37 * t83 + t56 * t75 + t57 * t67 - t32 * t87 - t60 * t67;
        let t191 = t23 + t63 - t52;
        let t197 = t158 * self.constants[18];
        let t201 = t137 * t146 - t111 * t148;
        let t205 = t137 * t142 - t111 * t130;
        let t211 = self.constants[0].like(1.0)
            / (self.constants[28] + t104 * self.constants[22]);
        let t215 = sin_delta * t32;
        let t219 = (t156 * t205 - t145 * t201) * t211 + cos_delta * t158
            - sin_delta * t37 - t166 * t215;
        let t221 = t219 * self.constants[19];
        let t228 = t11 + t52 + t63 + t80 + t94 * t158
            + t158 * (t94 + t158 * t174 - t166 * t184) + t158 * t197;
        let t232 = speeds[0]
            * (t228 + t219 * t221 - t165 * t166
                - t166 * (t165 + t158 * t184 - t166 * t191));
        let t234 = self.constants[43] + t18;
        let t241 = t37 * self.constants[24] - self.constants[23] * t32;
        let t243 = t129 + sin_phi * t241;
        let t245 = t37 * sin_phi;
        let t249 = t142 - t32 * self.constants[24] - self.constants[23] * t37;
        let t252 = t144 * (t32 * t243 + t245 * t249);
        let t261 = self.constants[22] + t104 * self.constants[28] + sin_phi * t119
            + cos_phi * t126 - cos_phi * t241;
        let t263 = t101 * t249 - t32 * t261;
        let t267 = t245 * t261 + t101 * t243;
        let t272 = t154 * (t111 * t263 + t137 * t267 + t150 * t252);
        let t274 = t252 - sin_phi * t272;
        let t276 = cos_phi * t272;
        let t278 = t37 * t57;
        let t279 = t67 * t278;
        let t280 = t83 + t279;
        let t284 = t280 + t174 * t274 - t184 * t276;
        let t290 = t37 * t234 - t32 * t46 - t56 * t278;
        let t294 = t290 + t184 * t274 - t191 * t276;
        let t307 = t211 * (t111 * t267 + t205 * t272 - t137 * t263 - t201 * t252)
            + cos_delta * t274;
        let t308 = t307 - t215 * t276;
        let t314 = t32 * t234 + t37 * t46 + t17 * t67 + t94 * t274 + t158 * t284
            + t197 * t274;
        let t318 = t314 + t221 * t308 - t32 * t58 - t165 * t276 - t166 * t294;
        let t322 = t67 * t137 * t154;
        let t323 = sin_phi * t322;
        let t325 = cos_phi * t322;
        let t327 = t75 - t77;
        let t328 = t67 * t327;
        let t332 = t328 + t174 * t323 + t184 * t325;
        let t334 = t57 - t60;
        let t335 = t67 * t334;
        let t339 = t335 - t184 * t323 - t191 * t325;
        let t342 = self.constants[0].like(1.0) - t323;
        let t351 = t211 * (t67 * t111 + t205 * t322) - cos_delta * t323 - t215 * t325;
        let t357 = t197 * t342 + t221 * t351 - t94 * t323 - t165 * t325 - t158 * t332
            - t166 * t339;
        let t367 = self.constants[18] * t274;
        let t369 = self.constants[19] * t308;
        let t375 = self.constants[43] + t274 * t284 + t274 * t280 + t274 * t367
            + t308 * t369 - t276 * t294;
        let t388 = t279 + t342 * t367 + t351 * t369 - t274 * t332 - t276 * t339
            - t280 * t323;
        let t389 = t388 - t290 * t325;
        let t393 = speeds[1]
            * (speeds[0] * t318 + speeds[1] * (t375 - t276 * t290) + speeds[2] * t389);
        let t408 = t78 + t323 * t332 + t323 * t328 + self.constants[18] * t342 * t342
            + self.constants[19] * t351 * t351 - t325 * t339;
        let t415 = speeds[0] * (t232 + speeds[1] * t318 + speeds[2] * t357) + t393
            + speeds[2]
                * (speeds[0] * t357 + speeds[1] * t389
                    + speeds[2] * (t408 - t325 * t335));
        let t417 = t415 * self.constants[0].like(0.5);
        let t423 = -(self.constants[44] * (sin_phi * t334 + cos_phi * t327));
        [t417, t423]
    }

    fn contact_forces_unchecked(&self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2]) -> [[T; 3]; 2] {
        let (
            sin_psi, cos_psi, sin_pitch, cos_pitch, t9, t13, sin_phi, cos_phi, sin_delta, cos_delta,
            t19, t24, t26, t29, t30, t31, t33, t34, t36, t43, t46, t48, t55, t58, t59, t64, t68,
            t71, t72, t73, t75, t77, t78, t82, t84, t91, t99, t104, t106, t108, t111, t113, t118,
            t122, t127, t129, t132, t133, t135, t138, t143, t147, t148, t149, t150, t152, t154,
            t155, t156, t158, t160, t161, t163, t164, t167, t168, t170, t171, t173, t174, t175,
            t178, t183, t185, t186, t189, t190, t194, t200, t201, t205, t207, t211, t212, t216,
            t217, t222, t224, t227, t228, t231, t235, t238, t239, t248, t253, t256, t258, t260,
            t262, t268, t269, t271, t277, t281, t288, t292, t294, t297, t299, t304, t310, t313,
            t317, t332, t337, t339, t344, t348, t350, t351, t355, t356, t360, t364, t366, t369,
            t375, t378, t383, t385, t387, t389, t394, t398, t401, t404, t407, t408, t411, t413,
            t416, t419, t421, t425, t431, t435, t438, t440, t443, t446, t449, t451, t453, t454,
            t463, t468, t470, t479, t485, t487, t490, t502, t504, t507, t510, t514, t522, t525,
            t527, t534, t537, t543, t546, t549, t555, t562, t570, t571, t575, t590, t595, t597,
            t599, t604, t608, t610, t612, t615, t618, t622, t625, t627, t630, t636, t639, t640,
            t644, t645, t648, t650, t651, t652, t654, t655, t660, t664, t666, t668, t669, t670,
            t672, t677, t683, t688, t691, t694, t698, t699, t702, t704, t707, t710, t711, t714,
            t717, t723, t724, t730, t750, t753, t754, t755, t757, t758, t760, t762, t764, t766,
            t771, t773, t778, t779, t790, t795, t803, t808, t809, t815, t829, t831, t832, t833,
            t843,
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
        t46 = cos_delta * sin_phi + t19 * sin_delta;
        t48 = t46 * self.constants[28];
        t55 = self.constants[23] + cos_delta * self.constants[26];
        t58 = t43 * t48 + t9 * self.constants[29] + t13 * t55;
        t59 = sin_phi * t58;
        t64 = sin_delta * self.constants[26];
        t68 = t13 * self.constants[29] - t9 * t55;
        t71 = cos_phi * t64 - t36 * t48 - sin_phi * t68;
        t72 = sin_phi * self.constants[25] + t71;
        t73 = sin_phi * t72;
        t75 = t36 * t59 + t43 * t73;
        t77 = self.constants[0].like(1.0) / (cos_phi * t58);
        t78 = t72 * t77;
        t82 = self.constants[0].like(1.0) / (t36 * t58 + t43 * t72);
        t84 = t75 * t78 * t82;
        t91 = t58 - t9 * self.constants[24] - t13 * self.constants[23];
        t99 = t13 * self.constants[24] - t9 * self.constants[23];
        t104 = self.constants[22] + t29 * self.constants[28] + sin_phi * t64
            + cos_phi * t68 - cos_phi * t99;
        t106 = t26 * t91 - t9 * t104;
        t108 = t13 * sin_phi;
        t111 = t71 + sin_phi * t99;
        t113 = t104 * t108 + t26 * t111;
        t118 = t77 * (t9 * t111 + t91 * t108);
        t122 = t82 * (t36 * t106 + t43 * t113 + t75 * t118);
        t127 = self.constants[25] + cos_phi * self.constants[21];
        t129 = t43 * t82 * t127;
        t132 = speeds[0] * t84 + speeds[1] * t122 + speeds[2] * t129;
        t133 = cos_phi * t132;
        t135 = speeds[0] * t13 + t9 * t133;
        t138 = t9 * speeds[0] - t13 * t133;
        t143 = t138 * self.constants[30] - t135 * self.constants[31];
        t147 = speeds[0] * t78 + speeds[1] * t118;
        t148 = sin_phi * t132;
        t149 = t147 - t148;
        t150 = self.constants[31] * t149;
        t152 = t135 * t143 - t149 * t150;
        t154 = speeds[0] * self.constants[25];
        t155 = t133 * t154;
        t156 = self.constants[24] * t149;
        t158 = self.constants[23] * t149;
        t160 = t138 * t156 + t135 * t158;
        t161 = speeds[0] * t148;
        t163 = t135 * t147;
        t164 = t13 * t161 + t163;
        t167 = t138 * t147;
        t168 = t9 * t161 + t167;
        t170 = speeds[2] + t147;
        t171 = t133 * t170;
        t173 = self.constants[25] * t148;
        t174 = t133 * t173;
        t175 = t174 - t127 * t171;
        t178 = t160 + self.constants[23] * t164 + self.constants[24] * t168 - t175;
        t183 = self.constants[23] * t138 - self.constants[24] * t135;
        t185 = t149 * t158 + t138 * t183;
        t186 = speeds[0] * t133;
        t189 = sin_phi * self.constants[21];
        t190 = speeds[0] * t170;
        t194 = t155 + t127 * t186 + t189 * (t161 + t190);
        t200 = t173 * (t170 - t148) - speeds[0] * t154;
        t201 = t171 * t189 + t200;
        t205 = t13 * t194 + t9 * t201 - t185 - self.constants[24] * t186;
        t207 = speeds[1] + t138;
        t211 = cos_delta * t149 - sin_delta * t135;
        t212 = self.constants[27] * t211;
        t216 = cos_delta * t135 + sin_delta * t149;
        t217 = self.constants[26] * t211;
        t222 = speeds[1] * t211;
        t224 = t222 - cos_delta * t168 - sin_delta * t186;
        t227 = self.constants[28] + t29 * self.constants[22];
        t228 = t31 * t227;
        t231 = t43 * t59 - t36 * t73;
        t235 = t43 * t58 - t36 * t72;
        t238 = self.constants[0].like(1.0) / t227;
        t239 = (t84 * t235 - t78 * t231) * t238;
        t248 = t238 * (t36 * t113 + t122 * t235 - t43 * t106 - t118 * t231);
        t253 = t238 * (t36 * t127 + t129 * t235);
        t256 = speeds[0] * t239 + speeds[1] * t248 + speeds[2] * t253;
        t258 = t164 + t216 * t256;
        t260 = t33 * t227;
        t262 = t224 - t207 * t256;
        t268 = t30 * (t31 * t216 + t33 * t207) * t48;
        t269 = t33 * t268;
        t271 = t31 * t268;
        t277 = cos_delta * t178 + t207 * t212 + t216 * t217 + self.constants[26] * t164
            + t228 * t258 + t207 * t269;
        t281 = t277 + t216 * t271 - sin_delta * t205 - self.constants[27] * t224
            - t260 * t262;
        t288 = self.constants[26] * t207 - self.constants[27] * t216;
        t292 = speeds[1] * t216;
        t294 = sin_delta * t168 - cos_delta * t186 - t292;
        t297 = t46 * self.constants[22];
        t299 = t211 + t256;
        t304 = self.constants[28] * (t31 * t207 - t33 * t216);
        t310 = cos_delta * t205 + sin_delta * t178 + self.constants[27] * t294
            + t260 * t294 - t211 * t217 - t207 * t288;
        t313 = t310 - t258 * t297 - t271 * t299 - t207 * t304;
        t317 = t135 * t183 - t149 * t156;
        t332 = t317 + self.constants[23] * t186 + t9 * t194 + t216 * t288 + t262 * t297
            + t216 * t304;
        t337 = t332 - t13 * t201 - t211 * t212 - self.constants[26] * t294 - t228 * t294
            - t269 * t299;
        t339 = t31 * t313 + t33 * t337;
        t344 = t77 * (t46 * t281 + t29 * t339);
        t348 = t82 * (t29 * t281 + t75 * t344 - t46 * t339);
        t350 = t186 - t344;
        t351 = sin_phi * t348 + t350;
        t355 = cos_phi * self.constants[44];
        t356 = t201 + t355;
        t360 = t161 - cos_phi * t348;
        t364 = t127 * t351 + t155 + t189 * (t190 + t360);
        t366 = t13 * t356 - t9 * t364;
        t369 = t317 - t366 + self.constants[23] * t351;
        t375 = t167 + t9 * t360;
        t378 = sin_delta * t375 - cos_delta * t351 - t292;
        t383 = t207 * self.constants[38] - t216 * self.constants[39];
        t385 = t211 * self.constants[39];
        t387 = t216 * t383 - t211 * t385;
        t389 = t369 * self.constants[37] + t387 - self.constants[38] * t378;
        t394 = t152 + t389 - self.constants[34] * t366 + self.constants[30] * t351;
        t398 = t9 * t356 + t13 * t364;
        t401 = t398 - self.constants[24] * t351 - t185;
        t404 = t163 + t13 * t360;
        t407 = sin_phi * self.constants[44];
        t408 = t175 + t407;
        t411 = t160 + self.constants[23] * t404 + self.constants[24] * t375 - t408;
        t413 = cos_delta * t401 + sin_delta * t411;
        t416 = t211 * self.constants[38];
        t419 = t211 * t416 + t207 * t383;
        t421 = t413 * self.constants[37] + self.constants[39] * t378 - t419;
        t425 = cos_delta * t411 - sin_delta * t401;
        t431 = t222 - sin_delta * t351 - cos_delta * t375;
        t435 = t207 * t385 + t216 * t416;
        t438 = t425 * self.constants[37] + t404 * self.constants[38] + t435
            - self.constants[39] * t431;
        t440 = cos_delta * t421 - sin_delta * t438;
        t443 = self.constants[30] * t149;
        t446 = t149 * t443 + t138 * t143;
        t449 = t440 + self.constants[34] * t398 - self.constants[31] * t351 - t446;
        t451 = t9 * t394 + t13 * t449;
        t453 = t351 * self.constants[18] + t127 * t451;
        t454 = sin_phi * t129;
        t463 = t135 * self.constants[35] + t138 * self.constants[32];
        t468 = t135 * self.constants[32] + t138 * self.constants[36];
        t470 = t138 * t463 - t135 * t468;
        t479 = t216 * self.constants[41] + t207 * self.constants[43];
        t485 = t211 * self.constants[42] + t299 * self.constants[19];
        t487 = t211 * t479 - t207 * t485;
        t490 = self.constants[40] * t431 + t404 * self.constants[41] + t487
            - self.constants[39] * t425;
        t502 = t238 * (t31 * t337 + t235 * t348 - t33 * t313 - t231 * t344);
        t504 = self.constants[19] * (t378 + t502);
        t507 = t216 * self.constants[40] + t207 * self.constants[41];
        t510 = t207 * t507 - t216 * t479;
        t514 = self.constants[39] * t413 + self.constants[42] * t378 + t504 + t510
            - self.constants[38] * t369;
        t522 = self.constants[31] * t398 + self.constants[30] * t366
            - t351 * self.constants[33] + t470 + sin_delta * t490 + cos_delta * t514;
        t525 = t522 + self.constants[24] * t440 - t453 - self.constants[23] * t389;
        t527 = cos_phi * t129;
        t534 = t149 * self.constants[33] + self.constants[18] * (speeds[2] + t149);
        t537 = t135 * t534 - t149 * t463;
        t543 = t216 * t485 - t211 * t507;
        t546 = t425 * self.constants[38] + t431 * self.constants[41]
            + t404 * self.constants[43] + t543;
        t549 = sin_delta * t421 + cos_delta * t438;
        t555 = self.constants[36] * t404 + t537 + t546 + self.constants[23] * t549
            - self.constants[30] * t408 - self.constants[32] * t375;
        t562 = t149 * t468 - t138 * t534;
        t570 = self.constants[31] * t408 + self.constants[32] * t404 + t562
            + cos_delta * t490 - self.constants[35] * t375 - sin_delta * t514;
        t571 = t570 - self.constants[24] * t549;
        t575 = t13 * t555 + t189 * t451 - t9 * t571;
        t590 = t138 * t150 + t135 * t443;
        t595 = t127
            * (t549 + self.constants[30] * t404 + self.constants[31] * t375 + t590
                - self.constants[34] * t408);
        t597 = t78 - sin_phi * t84;
        t599 = cos_phi * t84;
        t604 = forces[0] + t189 * (t13 * t394 - t9 * t449) + t575 * t599 - t9 * t555;
        t608 = t604 - t13 * t571 - t595 - t525 * t597 - t239 * t504;
        t610 = sin_delta * self.constants[38];
        t612 = sin_delta * self.constants[41] - self.constants[24] * t610;
        t615 = sin_delta * self.constants[45];
        t618 = cos_delta * t615 - self.constants[23] * t610;
        t622 = cos_delta * self.constants[38];
        t625 = self.constants[30] + t622 + self.constants[46];
        t627 = t9 * self.constants[52] + t13 * t625;
        t630 = t9 * t612 + t13 * t618 + t189 * t627;
        t636 = cos_delta * self.constants[41] - self.constants[24] * t622;
        t639 = self.constants[32] + t636 - self.constants[48] - self.constants[49];
        t640 = sin_delta * t615;
        t644 = self.constants[35] + self.constants[40] + self.constants[47] - t640;
        t645 = self.constants[23] * t622;
        t648 = t645 + t645 + self.constants[50];
        t650 = self.constants[36] + self.constants[43] + t648;
        t651 = t650 - t644;
        t652 = t9 * t13;
        t654 = t9 * t9;
        t655 = t639 + t639;
        t660 = t639 + t651 * t652 + t127 * t627 - t654 * t655;
        t664 = t13 * self.constants[52] - t9 * t625;
        t666 = t127 * self.constants[51];
        t668 = t127 * (t664 - t666);
        t669 = t127 * t664;
        t670 = t127 * t666;
        t672 = t670 - t669 - t669;
        t677 = self.constants[33] + self.constants[42] + t640 + self.constants[47] + t648
            + t672;
        t683 = t189 * self.constants[51];
        t688 = t13 * t612 + t189 * t664 + t127 * t610 - t9 * t618 - t127 * t683;
        t691 = t668 + t454 * t677 + t527 * t688;
        t694 = t127 * (t610 - t683);
        t698 = t651 * t654 + t652 * t655;
        t699 = t189 * t610;
        t702 = t189 * t683 - t699 - t699;
        t704 = t650 + t702 - t698;
        t707 = t694 - t454 * t688 - t527 * t704;
        t710 = self.constants[0].like(1.0) - t454;
        t711 = self.constants[18] * t597;
        t714 = t9 * sin_delta;
        t717 = t253 - cos_delta * t454 - t527 * t714;
        t723 = t239 + cos_delta * t597 - t13 * sin_delta - t599 * t714;
        t724 = self.constants[19] * t723;
        t730 = t710 * t711 + t717 * t724 - t454 * t630 - t527 * t660 - t597 * t691
            - t599 * t707;
        t750 = t644 + t672 + t698 + t702 + t597 * t630
            + t597 * (t630 + t597 * t677 - t599 * t688) + t597 * t711;
        t753 = t750 + t723 * t724 - t599 * t660
            - t599 * (t660 + t597 * t688 - t599 * t704);
        t754 = self.constants[0].like(1.0) / t753;
        t755 = t730 * t754;
        t757 = t13 * t610;
        t758 = t127 * t757;
        t760 = t118 - sin_phi * t122;
        t762 = cos_phi * t122;
        t764 = t612 + t758;
        t766 = self.constants[43] + t645;
        t771 = t13 * t766 - t9 * t636 - t189 * t757;
        t773 = self.constants[18] * t760;
        t778 = t248 + cos_delta * t760 - t714 * t762;
        t779 = self.constants[19] * t778;
        t790 = t764 + t677 * t760 - t688 * t762;
        t795 = t771 + t688 * t760 - t704 * t762;
        t803 = t9 * t766 + t13 * t636 + t127 * t622 + t630 * t760 + t597 * t790
            + t711 * t760;
        t808 = t754 * (t803 + t724 * t778 - t9 * t699 - t660 * t762 - t599 * t795);
        t809 = t753 * t808;
        t815 = t758 + t710 * t773 + t717 * t779 - t691 * t760 - t707 * t762
            - t454 * t764;
        t829 = self.constants[43] + t760 * t790 + t760 * t764 + t760 * t773 + t778 * t779
            - t762 * t795;
        t831 = t829 - t762 * t771 - t808 * t809;
        t832 = self.constants[0].like(1.0) / t831;
        t833 = (t815 - t527 * t771 - t755 * t809) * t832;
        t843 = forces[1] + t575 * t762 - t546 - t525 * t760 - t248 * t504 - t608 * t808;
        let (
            t849, t866, t870, t874, t878, t886, t890, t891, t894, t898, t900, t903, t905, t910,
            t916, t919, t922, t925, t929, t934, t939, t944, t947, t949, t953, t957, t959, t964,
            t968, t970, t973, t975, t983, t984, t995, t1003, t1012, t1016, t1026, t1033, t1047,
            t1052, t1057, t1059, t1060, t1065, t1072, t1076, t1079, t1081, t1084, t1089, t1093,
            t1096, t1099, t1100,
        );
        t849 = t454 * t525 + t527 * t575 + t453 - t253 * t504 - t608 * t755
            - t833 * t843;
        t866 = t670 + t454 * t691 + t454 * t668 + self.constants[18] * t710 * t710
            + self.constants[19] * t717 * t717 - t527 * t707;
        t870 = t849 / (t866 - t527 * t694 - t753 * t755 * t755 - t831 * t833 * t833);
        t874 = t832 * t843 - t833 * t870;
        t878 = t608 * t754 - t808 * t874 - t755 * t870;
        t886 = t348 + t84 * t878 + t122 * t874 + t129 * t870;
        t890 = t78 * t878 + t118 * t874 - sin_phi * t886 - t350;
        t891 = t870 + t890;
        t894 = t161 - cos_phi * t886;
        t898 = t127 * t891 - t155 - t189 * (t190 + t894);
        t900 = t171 + t878;
        t903 = t200 + t355 + t189 * t900;
        t905 = t9 * t898 + t13 * t903;
        t910 = t317 - t905 - self.constants[23] * t890;
        t916 = t13 * t878 - t167 - t9 * t894;
        t919 = cos_delta * t890 - t292 - sin_delta * t916;
        t922 = t387 + self.constants[37] * t910 - self.constants[38] * t919;
        t925 = t152 + t922 - self.constants[34] * t905 - self.constants[30] * t890;
        t929 = t9 * t903 - t13 * t898;
        t934 = t929 + self.constants[24] * t890 - t185;
        t939 = t163 + t13 * t894 + t9 * t878;
        t944 = t174 + t407 - t127 * t900;
        t947 = t160 + self.constants[23] * t939 - self.constants[24] * t916 - t944;
        t949 = cos_delta * t934 + sin_delta * t947;
        t953 = self.constants[37] * t949 + self.constants[39] * t919 - t419;
        t957 = cos_delta * t947 - sin_delta * t934;
        t959 = t874 + t939;
        t964 = t222 + cos_delta * t916 + sin_delta * t890;
        t968 = t435 + self.constants[37] * t957 + self.constants[38] * t959
            - self.constants[39] * t964;
        t970 = cos_delta * t953 - sin_delta * t968;
        t973 = self.constants[34] * t929 + self.constants[31] * t890 + t970 - t446;
        t975 = t9 * t925 + t13 * t973;
        t983 = self.constants[19]
            * (t502 + t919 + t239 * t878 + t248 * t874 + t253 * t870);
        t984 = t238 * t983;
        t995 = t487 + self.constants[40] * t964 + self.constants[41] * t959
            - self.constants[39] * t957;
        t1003 = t510 + t983 + self.constants[39] * t949 + self.constants[42] * t919
            - self.constants[38] * t910;
        t1012 = t470 + self.constants[31] * t929 + self.constants[30] * t905
            + self.constants[33] * t890 + self.constants[18] * t891 + sin_delta * t995;
        t1016 = t1012 + cos_delta * t1003 + self.constants[24] * t970
            - self.constants[23] * t922 - t127 * t975;
        t1026 = sin_delta * t953 + cos_delta * t968;
        t1033 = t537 + t543 + self.constants[32] * t916 + self.constants[36] * t939
            + self.constants[38] * t957 + self.constants[41] * t964
            + self.constants[43] * t959;
        t1047 = t562 + self.constants[31] * t944 + self.constants[35] * t916
            + self.constants[32] * t939 + cos_delta * t995 - sin_delta * t1003;
        t1052 = t13 * (t1033 + self.constants[23] * t1026 - self.constants[30] * t944)
            + t189 * t975 - t9 * (t1047 - self.constants[24] * t1026);
        t1057 = t82 * (sin_phi * t1016 + cos_phi * t1052 - t235 * t984);
        t1059 = t36 * t984 - t43 * t1057;
        t1060 = t975 - t1059;
        t1065 = t43 * t984 + t36 * t1057;
        t1072 = t590 + t1026 + self.constants[30] * t939 - self.constants[34] * t944
            - self.constants[31] * t916;
        t1076 = t13 * t925 - t9 * t973;
        t1079 = cos_phi * t1072 - t1065 - sin_phi * t1076;
        t1081 = cos_psi * t1060 - sin_psi * t1079;
        t1084 = t1060 * sin_psi + cos_psi * t1079;
        t1089 = t77 * (t1016 - t75 * t1057 - t231 * t984);
        t1093 = t1089 + sin_phi * t1072 + cos_phi * t1076;
        t1096 = cos_psi * t1059 - sin_psi * t1065;
        t1099 = t1059 * sin_psi + cos_psi * t1065;
        t1100 = -t1089;
        [[t1081, t1084, t1093], [t1096, t1099, t1100]]
    }
}

#[allow(unused_variables)]
impl<T: Scalar> carvallo::motion::UncheckedPartials for WhippleTyresMotion<T> {
    type State = [T; 11];

    type ByState = [[T; 11]; 11];

    type ByForces = [[T; 2]; 11];

    type Parameters = [T; 28];

    type ByParameters = [[T; 28]; 11];

    fn linearize_unchecked(
        &self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2],
    ) -> ([[T; 11]; 11], [[T; 2]; 11]) {
        let (
            zero, sin_phi, cos_phi, t6, sin_pitch, cos_pitch, t18, sin_delta, cos_delta, t21, t24,
            t25, t29, t30, t33, t34, t35, t37, t38, t40, t41, t42, t43, t45, t48, t54, t56, t59,
            t60, t61, t65, t67, t72, t74, t75, t81, t83, t85, t88, t89, t92, t94, t95, t96, sin_psi,
            cos_psi, t100, t103, t104, t105, t107, t108, t110, t111, t115, t116, t117, t119, t120,
            t122, t123, t124, t126, t129, t134, t135, t137, t139, t140, t143, t144, t147, t152,
            t154, t158, t162, t164, t166, t168, t171, t175, t180, t182, t185, t189, t191, t194,
            t200, t204, t208, t210, t212, t216, t220, t222, t225, t229, t232, t236, t240, t242,
            t244, t246, t248, t250, t252, t255, t257, t270, t274, t278, t283, t289, t306, t311,
            t313, t321, t323, t333, t335, t339, t343, t344, t345, t347, t349, t350, t359, t362,
            t364, t365, t370, t373, t377, t378, t382, t383, t384, t385, t389, t396, t399, t401,
            t404, t409, t411, t418, t424, t428, t431, t434, t436, t440, t443, t445, t449, t450,
            t454, t455, t457, t459, t461, t468, t469, t474, t479, t482, t485, t493, t495, t503,
            t508, t510, t512, t528, t533, t534, t537, t540, t541, t546, t550, t555, t556, t557,
            t558, t565, t566, t567, t569, t571, t580, t582, t587, t592, t593, t595, t605, t606,
            t608, t610, t616, t618, t622, t636, t642, t644, t648, t650, t658, t662, t667, t671,
            t681, t686, t695, t703, t722, t727, t729, t733, t737, t738, t742, t744, t745, t748,
            t751, t752, t753, t754, t756, t758, t762, t763, t766, t767, t769, t770, t771, t773,
            t776, t781, t782, t784, t785, t786, t787, t789, t790, t792, t796, t800, t803,
        );
        zero = self.constants[0].like(0.0);
        (sin_phi, cos_phi) = positions[3].sin_cos();
        t6 = self.constants[25] + self.constants[21] * cos_phi;
        (sin_pitch, cos_pitch) = positions[4].sin_cos();
        t18 = self.constants[3] * sin_pitch + self.constants[2] * cos_pitch;
        (sin_delta, cos_delta) = positions[5].sin_cos();
        t21 = cos_phi * t18;
        t24 = sin_phi * sin_delta;
        t25 = t24 - cos_delta * t21;
        t29 = self.constants[3] * cos_pitch - sin_pitch * self.constants[2];
        t30 = cos_phi * t29;
        t33 = (t25 * t25 + t30 * t30).sqrt();
        t34 = self.constants[0].like(1.0) / t33;
        t35 = t25 * t34;
        t37 = t30 * t34;
        t38 = cos_delta * t37;
        t40 = t29 * t38 - t18 * t35;
        t41 = sin_phi * cos_delta;
        t42 = t21 * sin_delta;
        t43 = t41 + t42;
        t45 = t43 * self.constants[28];
        t48 = sin_delta * self.constants[26];
        t54 = self.constants[23] + cos_delta * self.constants[26];
        t56 = t29 * self.constants[29] - t18 * t54;
        t59 = cos_phi * t48 - t40 * t45 - sin_phi * t56;
        t60 = self.constants[25] * sin_phi + t59;
        t61 = sin_delta * t37;
        t65 = t29 * t35 + t18 * t38;
        t67 = cos_phi * t61 + sin_phi * t65;
        t72 = t45 * t67 + t18 * self.constants[29] + t29 * t54;
        t74 = self.constants[0].like(1.0) / (cos_phi * t72);
        t75 = t60 * t74;
        t81 = t29 * self.constants[24] - t18 * self.constants[23];
        t83 = t59 + sin_phi * t81;
        t85 = sin_phi * t29;
        t88 = t18 * self.constants[24] + t29 * self.constants[23];
        t89 = t72 - t88;
        t92 = t74 * (t18 * t83 + t85 * t89);
        t94 = speeds[0] * t75 + speeds[1] * t92;
        t95 = speeds[2] + t94;
        t96 = t6 * t95;
        (sin_psi, cos_psi) = positions[2].sin_cos();
        t100 = self.constants[21] * speeds[0];
        t103 = t96 * sin_psi - t100 * cos_psi;
        t104 = self.constants[21] * sin_phi;
        t105 = t95 * t104;
        t107 = t6 * cos_psi;
        t108 = self.constants[25] * cos_phi;
        t110 = t74 * t75;
        t111 = sin_phi * t72;
        t115 = sin_phi * t48 + cos_phi * t56;
        t116 = t18 * t75;
        t117 = sin_phi * self.constants[29];
        t119 = t29 * t75;
        t120 = sin_phi * t54;
        t122 = t40 * self.constants[28];
        t123 = cos_phi * cos_delta;
        t124 = t18 * sin_delta;
        t126 = cos_phi * sin_delta;
        t129 = t123 + t119 * t126 - sin_phi * t124;
        t134 = t18 * cos_delta;
        t135 = sin_phi * t134;
        t137 = t34 * t123;
        t139 = t34 * t34;
        t140 = t25 * t139;
        t143 = t34 * self.constants[0].like(0.5);
        t144 = (t25 + t25) * t143;
        t147 = t143 * (t30 + t30);
        t152 = cos_phi * t147;
        t154 = t123 * t144;
        t158 = t126 * t144 - sin_phi * (t29 * t147 - t134 * t144) - t116 * t152
            - t119 * t154;
        t162 = t34 * t126 + t34 * t135 - t119 * t137 - t140 * t158;
        t164 = cos_delta * t29;
        t166 = cos_phi * t34;
        t168 = t30 * t139;
        t171 = t34 * t85 + t116 * t166 + t158 * t168;
        t175 = t38 * t116 + t35 * t119 + t18 * t162 + t164 * t171;
        t180 = t116 * t117 + t119 * t120 + t45 * t175 - t115 - t122 * t129;
        t182 = cos_phi * t110;
        t185 = self.constants[28] * t67;
        t189 = sin_phi * t35;
        t191 = sin_phi * t38;
        t194 = t126 + t135;
        t200 = cos_phi * t65 + t119 * t191 + t85 * t162 - sin_phi * t61 - t116 * t189
            - t171 * t194;
        t204 = self.constants[29] * t119 + t129 * t185 + t45 * t200 - t54 * t116;
        t208 = t74 * t108 + t110 * t111 + t74 * t180 - t182 * t204;
        t210 = t29 * t89;
        t212 = t18 * t74;
        t216 = t74 * t92;
        t220 = t74 * t85;
        t222 = sin_phi * self.constants[24];
        t225 = sin_phi * t74 * t89 + t212 * t222 - self.constants[23] * t220;
        t229 = sin_phi * self.constants[23];
        t232 = t74 * t83 - self.constants[24] * t220 - t212 * t229;
        t236 = t220 - cos_phi * t216;
        t240 = cos_phi * (t74 * t210 + t81 * t212) + t111 * t216 + t119 * t232
            + t180 * t212;
        t242 = t240 + t204 * t236 - t116 * t225;
        t244 = speeds[0] * t208 + speeds[1] * t242;
        t246 = cos_psi * t105 - t107 * t244;
        t248 = t18 * self.constants[26];
        t250 = t18 * t92;
        t252 = t29 * t92;
        t255 = t126 * t252 - t25;
        t257 = sin_delta * t29;
        t270 = t41 * t144 + t42 * t144 - t152 * t250 - t154 * t252;
        t274 = t34 * t41 + t34 * t42 - t137 * t252 - t140 * t270;
        t278 = t166 * t250 + t168 * t270;
        t283 = t37 * t257 + t38 * t250 + t35 * t252 + t18 * t274 + t164 * t278;
        t289 = self.constants[26] * t123 + t117 * t250 + t120 * t252 + t45 * t283
            - t24 * t248 - t122 * t255;
        t306 = t37 * t123 + t191 * t252 + t85 * t274 - t18 * t24 * t37 - t189 * t250
            - t194 * t278;
        t311 = self.constants[29] * t252 + t185 * t255 + t45 * t306
            - self.constants[26] * t257 - t54 * t250;
        t313 = t74 * t289 - t182 * t311;
        t321 = t232 * t252 + t212 * t289 + t236 * t311 - t225 * t250;
        t323 = speeds[0] * t313 + speeds[1] * t321;
        t333 = t6 * sin_psi;
        t335 = sin_psi * t105 - t244 * t333;
        t339 = self.constants[21] * cos_psi - t75 * t333;
        t343 = t40 * t72 + t60 * t67;
        t344 = self.constants[0].like(1.0) / t343;
        t345 = t67 * t344;
        t347 = t6 * t344;
        t349 = t67 * t347;
        t350 = t344 * t349;
        t359 = t67 * t108 + t60 * t200 + t67 * t180 + t40 * t204 - t72 * t175;
        t362 = t200 * t347 - t104 * t345 - t350 * t359;
        t364 = t75 * t344;
        t365 = sin_phi * t67;
        t370 = sin_phi * t60;
        t373 = sin_phi * t40;
        t377 = cos_phi * (t343 + self.constants[25] * t365) + t200 * t370 + t180 * t365
            + t204 * t373;
        t378 = t377 - t111 * t175;
        t382 = t40 * t111 + t67 * t370;
        t383 = t344 * t382;
        t384 = t75 * t383;
        t385 = t344 * t384;
        t389 = t364 * t378 + t208 * t383 - t359 * t385;
        t396 = t115 + self.constants[22] + t33 * self.constants[28] - cos_phi * t81;
        t399 = t29 * t396 + t30 * t81;
        t401 = t40 * t344;
        t404 = t85 * t345 - t18 * t401;
        t409 = t29 * t83;
        t411 = t56 - t81;
        t418 = cos_phi * t89 - t30 * self.constants[23];
        t424 = sin_phi * t396 + cos_phi * t83 + t30 * t222;
        t428 = cos_phi * self.constants[29] - cos_phi * self.constants[24];
        t431 = t401 * t418 + t345 * t424 + t404 * t428;
        t434 = t396 + t30 * self.constants[24];
        t436 = t30 * t229;
        t440 = cos_phi * self.constants[23] - cos_phi * t54;
        t443 = t404 * t440 - t401 * t434 - t345 * t436;
        t445 = self.constants[28] * t404;
        t449 = t30 * t89 - t18 * t396;
        t450 = t344 * t449;
        t454 = t85 * t396 + t30 * t83;
        t455 = t344 * t454;
        t457 = t30 * t345;
        t459 = t30 * t401;
        t461 = t92 * t344;
        t468 = t344 * (t40 * t449 + t67 * t454 + t92 * t382);
        t469 = t344 * t468;
        t474 = cos_phi * (t345 * t399 + t48 * t404) + t119 * t443 + t158 * t445
            + t200 * t455;
        t479 = t474 + t180 * t457 + t204 * t459 + t378 * t461 + t242 * t383
            - sin_phi * (t210 * t401 + t345 * t409 + t404 * t411);
        t482 = t479 - t116 * t431 - t175 * t450 - t359 * t469;
        t485 = speeds[2] * t362 + speeds[0] * t389 + speeds[1] * t482;
        t493 = t60 * t306 + t67 * t289 + t40 * t311 - t72 * t283;
        t495 = t306 * t347 - t350 * t493;
        t503 = t306 * t370 + t289 * t365 + t311 * t373 - t111 * t283;
        t508 = t364 * t503 + t313 * t383 - t385 * t493;
        t510 = self.constants[26] * t41;
        t512 = t248 * t126;
        t528 = t404 * t510 + t404 * t512 + t252 * t443 + t270 * t445 + t306 * t455
            + t289 * t457;
        t533 = t528 + t311 * t459 + t461 * t503 + t321 * t383 - t250 * t431
            - t283 * t450;
        t534 = t533 - t469 * t493;
        t537 = speeds[2] * t495 + speeds[0] * t508 + speeds[1] * t534;
        t540 = self.constants[28] + t33 * self.constants[22];
        t541 = self.constants[0].like(1.0) / t540;
        t546 = t67 * t111 - t40 * t370;
        t550 = t67 * t72 - t40 * t60;
        t555 = t541 * (t40 * t454 + t468 * t550 - t67 * t449 - t92 * t546);
        t556 = t541 * t555;
        t557 = self.constants[22] * t556;
        t558 = speeds[1] * t557;
        t565 = t541 * (t6 * t40 + t349 * t550);
        t566 = self.constants[22] * t541;
        t567 = t565 * t566;
        t569 = t6 * t541;
        t571 = t349 * t541;
        t580 = t60 * t175 + t72 * t200 + t67 * t204 - t40 * t108 - t40 * t180;
        t582 = t541 * t550;
        t587 = t571 * t580 + t362 * t582 - t40 * t104 * t541 - t158 * t567 - t175 * t569;
        t592 = t541 * (t384 * t550 - t75 * t546);
        t593 = t566 * t592;
        t595 = t75 * t541;
        t605 = cos_phi * (t550 - self.constants[25] * t373) + t175 * t370 + t111 * t200
            + t204 * t365;
        t606 = t605 - t180 * t373;
        t608 = t384 * t541;
        t610 = t541 * t546;
        t616 = t580 * t608 + t389 * t582 - t158 * t593 - t595 * t606 - t208 * t610;
        t618 = speeds[1] * t541;
        t622 = t18 * t67 + t40 * t85;
        t636 = t40 * t424 + t428 * t622 - t67 * t418;
        t642 = t67 * t434 + t440 * t622 - t40 * t436;
        t644 = self.constants[28] * t622;
        t648 = t30 * t40;
        t650 = t30 * t67;
        t658 = cos_phi * (t40 * t399 + t48 * t622) + t119 * t642 + t158 * t644
            + t180 * t648;
        t662 = t658 + t468 * t580 + t482 * t550
            - sin_phi * (t40 * t409 + t411 * t622 - t67 * t210) - t116 * t636;
        t667 = t662 - t175 * t454 - t200 * t449 - t204 * t650 - t92 * t606 - t242 * t546;
        t671 = speeds[2] * t587 + speeds[0] * t616 + t618 * t667 - t158 * t558;
        t681 = t60 * t283 + t72 * t306 + t67 * t311 - t40 * t289;
        t686 = t571 * t681 + t495 * t582 - t270 * t567 - t283 * t569;
        t695 = t283 * t370 + t111 * t306 + t311 * t365 - t289 * t373;
        t703 = t608 * t681 + t508 * t582 - t270 * t593 - t595 * t695 - t313 * t610;
        t722 = t510 * t622 + t512 * t622 + t252 * t642 + t270 * t644 + t289 * t648
            + t468 * t681;
        t727 = t722 + t534 * t550 - t250 * t636 - t283 * t454 - t306 * t449
            - t311 * t650;
        t729 = t727 - t92 * t695 - t321 * t546;
        t733 = speeds[2] * t686 + speeds[0] * t703 + t618 * t729 - t270 * t558;
        t737 = sin_delta * self.constants[45];
        t738 = sin_delta * t737;
        t742 = self.constants[35] + self.constants[40] + self.constants[47] - t738;
        t744 = cos_delta * self.constants[38];
        t745 = self.constants[23] * t744;
        t748 = t745 + t745 + self.constants[50];
        t751 = self.constants[36] + self.constants[43];
        t752 = t748 + t751;
        t753 = t752 - t742;
        t754 = t18 * t18;
        t756 = t18 * t29;
        t758 = self.constants[24] * t744;
        t762 = cos_delta * self.constants[41];
        t763 = self.constants[32] + t762;
        t766 = t763 - self.constants[48] - t758 - self.constants[49];
        t767 = t766 + t766;
        t769 = t753 * t754 + t756 * t767;
        t770 = sin_delta * self.constants[38];
        t771 = t104 * t770;
        t773 = t104 * self.constants[51];
        t776 = t104 * t773 - t771 - t771;
        t781 = t744 + self.constants[30];
        t782 = self.constants[46] + t781;
        t784 = t29 * self.constants[52] - t18 * t782;
        t785 = t6 * t784;
        t786 = t6 * self.constants[51];
        t787 = t6 * t786;
        t789 = t787 - t785 - t785;
        t790 = sin_delta * self.constants[41];
        t792 = t790 - self.constants[24] * t770;
        t796 = cos_delta * t737 - self.constants[23] * t770;
        t800 = t18 * self.constants[52] + t29 * t782;
        t803 = t18 * t792 + t29 * t796 + t104 * t800;
        let (
            t805, t812, t813, t821, t831, t838, t844, t850, t852, t859, t862, t863, t868, t869,
            t871, t872, t873, t875, t877, t878, t880, t882, t884, t886, t887, t888, t889, t890,
            t892, t894, t895, t897, t898, t901, t902, t904, t906, t907, t908, t911, t914, t915,
            t916, t918, t919, t922, t923, t926, t930, t932, t933, t937, t939, t943, t944, t948,
            t949, t954, t956, t958, t963, t965, t967, t969, t971, t974, t976, t977, t979, t985,
            t989, t994, t995, t996, t1000, t1002, t1005, t1007, t1012, t1018, t1021, t1025, t1040,
            t1045, t1047, t1052, t1056, t1058, t1059, t1062, t1063, t1067, t1071, t1073, t1076,
            t1081, t1084, t1086, t1088, t1089, t1091, t1093, t1095, t1099, t1100, t1101, t1103,
            t1105, t1108, t1112, t1115, t1118, t1121, t1122, t1125, t1127, t1130, t1133, t1135,
            t1139, t1145, t1149, t1152, t1154, t1157, t1160, t1163, t1165, t1167, t1168, t1175,
            t1177, t1181, t1183, t1186, t1198, t1200, t1202, t1203, t1206, t1210, t1218, t1221,
            t1223, t1230, t1233, t1239, t1242, t1245, t1251, t1258, t1266, t1267, t1271, t1286,
            t1291, t1297, t1301, t1305, t1309, t1312, t1316, t1318, t1323, t1329, t1330, t1332,
            t1333, t1334, t1335, t1337, t1339, t1341, t1343, t1347, t1349, t1354, t1355, t1359,
            t1367, t1372, t1380, t1385, t1386, t1392, t1406, t1408, t1409, t1410, t1420, t1426,
            t1433, t1443, t1447, t1448, t1452, t1456, t1464, t1465, t1468, t1469, t1471, t1472,
            t1473, t1476, t1478, t1481, t1483, t1487, t1494, t1499, t1503, t1506, t1510, t1512,
            t1516, t1517, t1519, t1523, t1527, t1531, t1535, t1536, t1545, t1549, t1551, t1555,
            t1562, t1564, t1569, t1575, t1581, t1583, t1589, t1592, t1608, t1615, t1617, t1624,
            t1630, t1634, t1644, t1647, t1650, t1655, t1658, t1663, t1665, t1669, t1672,
        );
        t805 = t75 - sin_phi * t384;
        t812 = t766 + t753 * t756 + t6 * t800 - t754 * t767;
        t813 = cos_phi * t384;
        t821 = t738 + self.constants[47] + t748 + t789 + self.constants[33]
            + self.constants[42];
        t831 = t29 * t792 + t104 * t784 + t6 * t770 - t18 * t796 - t6 * t773;
        t838 = t752 + t776 - t769;
        t844 = t805 * self.constants[18];
        t850 = t592 + cos_delta * t805 - t257 - t124 * t813;
        t852 = t850 * self.constants[19];
        t859 = t742 + t769 + t776 + t789 + t803 * t805
            + t805 * (t803 + t805 * t821 - t813 * t831) + t805 * t844;
        t862 = t859 + t850 * t852 - t812 * t813
            - t813 * (t812 + t805 * t831 - t813 * t838);
        t863 = self.constants[0].like(1.0) / t862;
        t868 = speeds[0] * t384 + speeds[1] * t468 + speeds[2] * t349;
        t869 = cos_phi * t868;
        t871 = speeds[0] * t18;
        t872 = t871 - t29 * t869;
        t873 = speeds[0] * t29;
        t875 = t873 + t18 * t869;
        t877 = self.constants[32] * t872;
        t878 = self.constants[35] * t875 + t877;
        t880 = self.constants[32] * t875;
        t882 = t880 + self.constants[36] * t872;
        t884 = t872 * t878 - t875 * t882;
        t886 = self.constants[25] * speeds[0];
        t887 = t869 * t886;
        t888 = sin_phi * t868;
        t889 = t94 - t888;
        t890 = self.constants[24] * t889;
        t892 = self.constants[23] * t889;
        t894 = t872 * t890 + t875 * t892;
        t895 = speeds[0] * t888;
        t897 = t94 * t875;
        t898 = t29 * t895 + t897;
        t901 = t94 * t872;
        t902 = t18 * t895 + t901;
        t904 = t95 * t869;
        t906 = self.constants[25] * t888;
        t907 = t869 * t906;
        t908 = t907 - t6 * t904;
        t911 = t894 + self.constants[23] * t898 + self.constants[24] * t902 - t908;
        t914 = self.constants[23] * t872;
        t915 = self.constants[24] * t875;
        t916 = t914 - t915;
        t918 = t889 * t892 + t872 * t916;
        t919 = speeds[0] * t869;
        t922 = speeds[0] * t95;
        t923 = t895 + t922;
        t926 = t887 + t6 * t919 + t104 * t923;
        t930 = t95 - t888;
        t932 = t906 * t930 - speeds[0] * t886;
        t933 = t104 * t904 + t932;
        t937 = t29 * t926 + t18 * t933 - t918 - self.constants[24] * t919;
        t939 = speeds[1] + t872;
        t943 = cos_delta * t889 - sin_delta * t875;
        t944 = self.constants[27] * t943;
        t948 = cos_delta * t875 + sin_delta * t889;
        t949 = self.constants[26] * t943;
        t954 = speeds[1] * t943;
        t956 = t954 - cos_delta * t902 - sin_delta * t919;
        t958 = t35 * t540;
        t963 = speeds[0] * t592 + speeds[1] * t555 + speeds[2] * t565;
        t965 = t898 + t948 * t963;
        t967 = t37 * t540;
        t969 = t956 - t939 * t963;
        t971 = t34 * t43;
        t974 = t35 * t948 + t37 * t939;
        t976 = self.constants[28] * t971 * t974;
        t977 = t37 * t976;
        t979 = t35 * t976;
        t985 = cos_delta * t911 + t939 * t944 + t948 * t949 + self.constants[26] * t898
            + t958 * t965 + t939 * t977;
        t989 = t985 + t948 * t979 - sin_delta * t937 - self.constants[27] * t956
            - t967 * t969;
        t994 = self.constants[26] * t939;
        t995 = self.constants[27] * t948;
        t996 = t994 - t995;
        t1000 = speeds[1] * t948;
        t1002 = sin_delta * t902 - cos_delta * t919 - t1000;
        t1005 = t43 * self.constants[22];
        t1007 = t943 + t963;
        t1012 = self.constants[28] * (t35 * t939 - t37 * t948);
        t1018 = cos_delta * t937 + sin_delta * t911 + self.constants[27] * t1002
            + t967 * t1002 - t943 * t949 - t939 * t996;
        t1021 = t1018 - t965 * t1005 - t979 * t1007 - t939 * t1012;
        t1025 = t875 * t916 - t889 * t890;
        t1040 = t1025 + self.constants[23] * t919 + t18 * t926 + t948 * t996
            + t969 * t1005 + t948 * t1012;
        t1045 = t1040 - t29 * t933 - t943 * t944 - self.constants[26] * t1002
            - t958 * t1002 - t977 * t1007;
        t1047 = t35 * t1021 + t37 * t1045;
        t1052 = t74 * (t43 * t989 + t33 * t1047);
        t1056 = t344 * (t33 * t989 + t382 * t1052 - t43 * t1047);
        t1058 = t919 - t1052;
        t1059 = sin_phi * t1056 + t1058;
        t1062 = cos_phi * self.constants[44];
        t1063 = t933 + t1062;
        t1067 = t895 - cos_phi * t1056;
        t1071 = t6 * t1059 + t887 + t104 * (t922 + t1067);
        t1073 = t29 * t1063 - t18 * t1071;
        t1076 = t1025 - t1073 + self.constants[23] * t1059;
        t1081 = t901 + t18 * t1067;
        t1084 = sin_delta * t1081 - cos_delta * t1059 - t1000;
        t1086 = self.constants[38] * t939;
        t1088 = t948 * self.constants[39];
        t1089 = t1086 - t1088;
        t1091 = t943 * self.constants[39];
        t1093 = t948 * t1089 - t943 * t1091;
        t1095 = t1076 * self.constants[37] + t1093 - self.constants[38] * t1084;
        t1099 = self.constants[30] * t872;
        t1100 = t875 * self.constants[31];
        t1101 = t1099 - t1100;
        t1103 = self.constants[31] * t889;
        t1105 = t875 * t1101 - t889 * t1103;
        t1108 = t1095 + t1105 - t1073 * self.constants[34] + self.constants[30] * t1059;
        t1112 = t18 * t1063 + t29 * t1071;
        t1115 = t1112 - self.constants[24] * t1059 - t918;
        t1118 = t897 + t29 * t1067;
        t1121 = sin_phi * self.constants[44];
        t1122 = t908 + t1121;
        t1125 = t894 + self.constants[23] * t1118 + self.constants[24] * t1081 - t1122;
        t1127 = cos_delta * t1115 + sin_delta * t1125;
        t1130 = self.constants[38] * t943;
        t1133 = t943 * t1130 + t939 * t1089;
        t1135 = t1127 * self.constants[37] + self.constants[39] * t1084 - t1133;
        t1139 = cos_delta * t1125 - sin_delta * t1115;
        t1145 = t954 - sin_delta * t1059 - cos_delta * t1081;
        t1149 = t939 * t1091 + t948 * t1130;
        t1152 = t1139 * self.constants[37] + self.constants[38] * t1118 + t1149
            - self.constants[39] * t1145;
        t1154 = cos_delta * t1135 - sin_delta * t1152;
        t1157 = self.constants[30] * t889;
        t1160 = t889 * t1157 + t872 * t1101;
        t1163 = t1154 + t1112 * self.constants[34] - self.constants[31] * t1059 - t1160;
        t1165 = t18 * t1108 + t29 * t1163;
        t1167 = self.constants[18] * t1059 + t6 * t1165;
        t1168 = sin_phi * t349;
        t1175 = self.constants[41] * t948;
        t1177 = t1175 + self.constants[43] * t939;
        t1181 = self.constants[42] * t943 + self.constants[19] * t1007;
        t1183 = t943 * t1177 - t939 * t1181;
        t1186 = self.constants[40] * t1145 + self.constants[41] * t1118 + t1183
            - self.constants[39] * t1139;
        t1198 = t541 * (t35 * t1045 + t550 * t1056 - t37 * t1021 - t546 * t1052);
        t1200 = self.constants[19] * (t1084 + t1198);
        t1202 = self.constants[41] * t939;
        t1203 = self.constants[40] * t948 + t1202;
        t1206 = t939 * t1203 - t948 * t1177;
        t1210 = self.constants[39] * t1127 + self.constants[42] * t1084 + t1200 + t1206
            - self.constants[38] * t1076;
        t1218 = t884 + self.constants[31] * t1112 + self.constants[30] * t1073
            - self.constants[33] * t1059 + sin_delta * t1186 + cos_delta * t1210;
        t1221 = t1218 + self.constants[24] * t1154 - t1167 - self.constants[23] * t1095;
        t1223 = cos_phi * t349;
        t1230 = self.constants[33] * t889 + self.constants[18] * (speeds[2] + t889);
        t1233 = t875 * t1230 - t878 * t889;
        t1239 = t948 * t1181 - t943 * t1203;
        t1242 = self.constants[38] * t1139 + self.constants[41] * t1145
            + self.constants[43] * t1118 + t1239;
        t1245 = sin_delta * t1135 + cos_delta * t1152;
        t1251 = self.constants[36] * t1118 + t1233 + t1242 + self.constants[23] * t1245
            - self.constants[30] * t1122 - self.constants[32] * t1081;
        t1258 = t882 * t889 - t872 * t1230;
        t1266 = self.constants[31] * t1122 + self.constants[32] * t1118 + t1258
            + cos_delta * t1186 - self.constants[35] * t1081 - sin_delta * t1210;
        t1267 = t1266 - self.constants[24] * t1245;
        t1271 = t29 * t1251 + t104 * t1165 - t18 * t1267;
        t1286 = t872 * t1103 + t875 * t1157;
        t1291 = t6
            * (t1245 + self.constants[30] * t1118 + self.constants[31] * t1081 + t1286
                - t1122 * self.constants[34]);
        t1297 = forces[0] + t104 * (t29 * t1108 - t18 * t1163) + t813 * t1271
            - t18 * t1251;
        t1301 = t1297 - t29 * t1267 - t1291 - t805 * t1221 - t592 * t1200;
        t1305 = t6 * (t784 - t786);
        t1309 = t1305 + t821 * t1168 + t831 * t1223;
        t1312 = t6 * (t770 - t773);
        t1316 = t1312 - t831 * t1168 - t838 * t1223;
        t1318 = self.constants[0].like(1.0) - t1168;
        t1323 = t124 * t1223 + cos_delta * t1168 - t565;
        t1329 = t844 * t1318 - t803 * t1168 - t812 * t1223 - t805 * t1309 - t813 * t1316
            - t852 * t1323;
        t1330 = t863 * t1329;
        t1332 = t29 * t770;
        t1333 = t6 * t1332;
        t1334 = sin_phi * t468;
        t1335 = t92 - t1334;
        t1337 = cos_phi * t468;
        t1339 = t792 + t1333;
        t1341 = t745 + self.constants[43];
        t1343 = t762 - t758;
        t1347 = t29 * t1341 - t18 * t1343 - t104 * t1332;
        t1349 = self.constants[18] * t1335;
        t1354 = t124 * t1337 - t555 - cos_delta * t1335;
        t1355 = self.constants[19] * t1354;
        t1359 = t18 * t770;
        t1367 = t1339 + t821 * t1335 - t831 * t1337;
        t1372 = t1347 + t831 * t1335 - t838 * t1337;
        t1380 = t18 * t1341 + t29 * t1343 + t6 * t744 + t803 * t1335 + t805 * t1367
            + t844 * t1335;
        t1385 = t863
            * (t1380 - t104 * t1359 - t812 * t1337 - t813 * t1372 - t852 * t1354);
        t1386 = t862 * t1385;
        t1392 = t1333 + t1318 * t1349 + t1323 * t1355 - t1309 * t1335 - t1316 * t1337
            - t1168 * t1339;
        t1406 = self.constants[43] + t1335 * t1367 + t1335 * t1339 + t1335 * t1349
            + t1354 * t1355 - t1337 * t1372;
        t1408 = t1406 - t1337 * t1347 - t1385 * t1386;
        t1409 = self.constants[0].like(1.0) / t1408;
        t1410 = (t1392 - t1223 * t1347 - t1330 * t1386) * t1409;
        t1420 = forces[1] + t1271 * t1337 - t1242 - t1221 * t1335 - t555 * t1200
            - t1301 * t1385;
        t1426 = t1168 * t1221 + t1223 * t1271 + t1167 - t565 * t1200 - t1301 * t1330
            - t1410 * t1420;
        t1433 = self.constants[19] * t1323;
        t1443 = t787 + t1168 * t1309 + t1168 * t1305 + self.constants[18] * t1318 * t1318
            + t1323 * t1433 - t1223 * t1316;
        t1447 = self.constants[0].like(1.0)
            / (t1443 - t1223 * t1312 - t862 * t1330 * t1330 - t1408 * t1410 * t1410);
        t1448 = t1426 * t1447;
        t1452 = t1409 * t1420 - t1410 * t1448;
        t1456 = t863 * t1301 - t1385 * t1452 - t1330 * t1448;
        t1464 = t1056 + t384 * t1456 + t468 * t1452 + t349 * t1448;
        t1465 = sin_phi * t1464;
        t1468 = t75 * t1456 + t92 * t1452 - t1465 - t1058;
        t1469 = t1448 + t1468;
        t1471 = cos_phi * t1464;
        t1472 = t895 - t1471;
        t1473 = t922 + t1472;
        t1476 = t6 * t1469 - t887 - t104 * t1473;
        t1478 = t904 + t1456;
        t1481 = t932 + t1062 + t104 * t1478;
        t1483 = t18 * t1481 - t29 * t1476;
        t1487 = t29 * t1481 + t18 * t1476;
        t1494 = t897 + t29 * t1472 + t18 * t1456;
        t1499 = t29 * t1456 - t901 - t18 * t1472;
        t1503 = t907 + t1121 - t6 * t1478;
        t1506 = t894 + self.constants[23] * t1494 - self.constants[24] * t1499 - t1503;
        t1510 = t1483 + self.constants[24] * t1468 - t918;
        t1512 = cos_delta * t1506 - sin_delta * t1510;
        t1516 = cos_delta * t1499 + sin_delta * t1468;
        t1517 = t954 + t1516;
        t1519 = t1452 + t1494;
        t1523 = t1183 + self.constants[40] * t1517 + self.constants[41] * t1519
            - self.constants[39] * t1512;
        t1527 = cos_delta * t1510 + sin_delta * t1506;
        t1531 = t1025 - t1487 - self.constants[23] * t1468;
        t1535 = cos_delta * t1468 - sin_delta * t1499;
        t1536 = t1535 - t1000;
        t1545 = self.constants[19]
            * (t1198 + t1536 + t592 * t1456 + t555 * t1452 + t565 * t1448);
        t1549 = t1206 + self.constants[39] * t1527 + self.constants[42] * t1536 + t1545
            - self.constants[38] * t1531;
        t1551 = sin_delta * t1523 + cos_delta * t1549;
        t1555 = self.constants[37] * t1527 + self.constants[39] * t1536 - t1133;
        t1562 = t1149 + self.constants[37] * t1512 + self.constants[38] * t1519
            - self.constants[39] * t1517;
        t1564 = cos_delta * t1555 - sin_delta * t1562;
        t1569 = t1093 + self.constants[37] * t1531 - self.constants[38] * t1536;
        t1575 = t1105 + t1569 - self.constants[34] * t1487 - self.constants[30] * t1468;
        t1581 = t1564 + self.constants[34] * t1483 + self.constants[31] * t1468 - t1160;
        t1583 = t18 * t1575 + t29 * t1581;
        t1589 = t884 + self.constants[31] * t1483 + self.constants[30] * t1487
            + self.constants[33] * t1468 + self.constants[18] * t1469 + t1551;
        t1592 = t1589 + self.constants[24] * t1564 - self.constants[23] * t1569
            - t6 * t1583;
        t1608 = sin_delta * t1555 + cos_delta * t1562;
        t1615 = t1233 + t1239 + self.constants[32] * t1499 + self.constants[36] * t1494
            + self.constants[38] * t1512 + self.constants[41] * t1517
            + self.constants[43] * t1519;
        t1617 = t1615 + self.constants[23] * t1608 - self.constants[30] * t1503;
        t1624 = cos_delta * t1523 - sin_delta * t1549;
        t1630 = t1258 + self.constants[31] * t1503 + self.constants[35] * t1499
            + self.constants[32] * t1494 + t1624 - self.constants[24] * t1608;
        t1634 = t29 * t1617 + t104 * t1583 - t18 * t1630;
        t1644 = t384 * t1634
            - self.constants[21]
                * (t1286 + t1608 + self.constants[30] * t1494
                    - self.constants[34] * t1503 - self.constants[31] * t1499);
        t1647 = t104 * t1575 - t1630;
        t1650 = t1617 + t104 * t1581;
        t1655 = sin_phi * t1592 + cos_phi * t1634;
        t1658 = self.constants[21] * t1583;
        t1663 = cos_phi * t1658 - t116 * t1617 - t119 * t1630;
        t1665 = sin_phi * t1658;
        t1669 = t119 * t1575 - t116 * t1581;
        t1672 = t104 * t813 + t6 * t805;
        let (
            t1674, t1675, t1676, t1677, t1680, t1684, t1686, t1689, t1690, t1692, t1695, t1697,
            t1699, t1701, t1702, t1704, t1706, t1707, t1709, t1711, t1713, t1719, t1724, t1726,
            t1729, t1730, t1734, t1740, t1744, t1746, t1753, t1754, t1756, t1757, t1760, t1762,
            t1763, t1764, t1767, t1769, t1770, t1772, t1773, t1774, t1778, t1780, t1782, t1786,
            t1795, t1797, t1799, t1805, t1811, t1814, t1817, t1824, t1832, t1834, t1837, t1840,
            t1841, t1845, t1850, t1856, t1858, t1859, t1862, t1866, t1870, t1872, t1874, t1878,
            t1880, t1882, t1889, t1892, t1895, t1899, t1908, t1917, t1919, t1921, t1927, t1930,
            t1931, t1933, t1935, t1937, t1942, t1947, t1949, t1957, t1958, t1961, t1968, t1970,
            t1977, t1983, t1987, t1991, t1997, t2006, t2007, t2010, t2017, t2032, t2035, t2036,
            t2037, t2039, t2045, t2047, t2049, t2051, t2053, t2054, t2056, t2058, t2064, t2067,
            t2069, t2071, t2077, t2079, t2081, t2083, t2084, t2085, t2090, t2093, t2095, t2097,
            t2098, t2103, t2109, t2111, t2112, t2114, t2115, t2117, t2119, t2121, t2124, t2129,
            t2131, t2133, t2136, t2139, t2142, t2144, t2148, t2149, t2152, t2158, t2159, t2162,
            t2166, t2169, t2171, t2178, t2180, t2185, t2189, t2193, t2196, t2198, t2200, t2201,
            t2202, t2205, t2208, t2212, t2221, t2229, t2231, t2233, t2235, t2237, t2239, t2242,
            t2245, t2247, t2250, t2252, t2254, t2257, t2260, t2262, t2264, t2266, t2268, t2272,
            t2273, t2274, t2277, t2279, t2281, t2284, t2288, t2291, t2295, t2298, t2301, t2303,
            t2304, t2307, t2309, t2312, t2315, t2316, t2319, t2323, t2325, t2329, t2331, t2333,
            t2334, t2335, t2337, t2342, t2346, t2349, t2351, t2354, t2356, t2357, t2359, t2360,
            t2361, t2363, t2365, t2371, t2373, t2377, t2379, t2383, t2385, t2387, t2390, t2391,
            t2393, t2394, t2400, t2405, t2408, t2410, t2414, t2416, t2420, t2426,
        );
        t1674 = t344 * t1047;
        t1675 = t541 * self.constants[19];
        t1676 = t550 * t1675;
        t1677 = t1674 * t1676;
        t1680 = self.constants[19] * t1452;
        t1684 = t344 * t989;
        t1686 = t1676 * t1684 - self.constants[22] * (t1198 * t1675 + t556 * t1680);
        t1689 = t43 * t344;
        t1690 = t1021 * t1689;
        t1692 = t1045 * t1675 - t1676 * t1690;
        t1695 = t1045 * t1689;
        t1697 = t1021 * t1675 + t1676 * t1695;
        t1699 = t1052 * t1675;
        t1701 = t344 * t1052;
        t1702 = t1676 * t1701;
        t1704 = t1056 * t1675;
        t1706 = t344 * t1056;
        t1707 = t1676 * t1706;
        t1709 = self.constants[19] * t1448;
        t1711 = self.constants[19] * t1456;
        t1713 = t541 * t1680;
        t1719 = t158 * t1686 + t162 * t1692 + t171 * t1697 + t378 * t1702 + t580 * t1704
            + t587 * t1709;
        t1724 = t1719 + t616 * t1711 + t667 * t1713 - t129 * t1677 - t606 * t1699
            - t359 * t1707;
        t1726 = self.constants[21] * t1478;
        t1729 = self.constants[25] * t930 - t906;
        t1730 = t18 * t1729;
        t1734 = self.constants[21] * t1473 + t6 * t1464;
        t1740 = t18 * t105;
        t1744 = t886 + t6 * speeds[0];
        t1746 = self.constants[21] * t1469 - t868 * t1744;
        t1753 = t6 * t1456;
        t1754 = t29 * t1753;
        t1756 = t6 * t1452;
        t1757 = t29 * t1756;
        t1760 = cos_phi * (t18 * t1726 + t868 * t1730 + t29 * t1734) + t116 * t1476
            + t119 * t1481;
        t1762 = t1760 - sin_phi * (t18 * self.constants[44] + t868 * t1740 - t29 * t1746)
            - t208 * t1754;
        t1763 = t1762 - t242 * t1757;
        t1764 = t18 * t104;
        t1767 = t29 * self.constants[34];
        t1769 = cos_delta * self.constants[39];
        t1770 = sin_delta * t1769;
        t1772 = cos_delta * self.constants[37];
        t1773 = sin_delta * t1772;
        t1774 = t81 - t6;
        t1778 = t18 * t1770 + t88 * t1773;
        t1780 = cos_delta * t1769;
        t1782 = cos_delta * t1772;
        t1786 = t29 * t1672 - t1764 - self.constants[24] * t805;
        t1795 = t29 * self.constants[38] + t18 * t1769 + t88 * t1772;
        t1797 = sin_delta * self.constants[39];
        t1799 = sin_delta * self.constants[37];
        t1805 = t29 * t1769 + t1772 * t1774 + t813 * t1795 + t805 * t1797
            - t18 * self.constants[38] - t1786 * t1799;
        t1811 = t29 * t1770 + t1773 * t1774 + t813 * t1778 + t1782 * t1786 - t805 * t1780
            - sin_delta * t1805;
        t1814 = t1672 * t1767 + t1811 - self.constants[34] * t1764
            - t805 * self.constants[31];
        t1817 = t29 * t1729;
        t1824 = t29 * t105;
        t1832 = t18 * t1753;
        t1834 = t18 * t1756;
        t1837 = cos_phi * (t29 * t1726 + t868 * t1817 - t18 * t1734) + t119 * t1476
            + t208 * t1832;
        t1840 = t1837 + t242 * t1834
            - sin_phi * (t29 * self.constants[44] + t868 * t1824 + t18 * t1746)
            - t116 * t1481;
        t1841 = t29 * t104;
        t1845 = t18 * self.constants[34];
        t1850 = t1841 + self.constants[23] * t805 + t18 * t1672;
        t1856 = t1332 + t813 * t1359 - self.constants[34] * t1841 - t781 * t805
            - t1672 * t1845 - self.constants[37] * t1850;
        t1858 = self.constants[25] * t869;
        t1859 = t868 * t1858;
        t1862 = t96 - t906;
        t1866 = cos_phi * (self.constants[44] + t1859)
            + sin_phi * (t1726 + t868 * t1862);
        t1870 = t29 * self.constants[30] + t18 * self.constants[31];
        t1872 = sin_delta * t1797;
        t1874 = sin_delta * t1799;
        t1878 = t18 * t1872 + t88 * t1874;
        t1880 = cos_delta * t1797;
        t1882 = cos_delta * t1799;
        t1889 = t29 * t1872 + t1774 * t1874 + t813 * t1878 + t1786 * t1882
            + cos_delta * t1805 - t805 * t1880;
        t1892 = t29 * self.constants[31] - t18 * self.constants[30];
        t1895 = t6 * self.constants[34] - t813 * t1870 - t1889 - t1892;
        t1899 = t119 * t1456 - t116 * t1472;
        t1908 = t29 * t751 + t88 * t744 - t18 * t763;
        t1917 = t744 * t1774 + t813 * t1908 + self.constants[23] * t1889
            - t6 * self.constants[30] - t18 * t751 - t29 * t763;
        t1919 = t1917 - t790 * t805 - t770 * t1786;
        t1921 = speeds[0] * t868;
        t1927 = sin_phi * t1921 + t208 * t1456 + t242 * t1452 - t1471;
        t1930 = self.constants[23] * self.constants[38];
        t1931 = sin_delta * t1930;
        t1933 = t18 * t1931;
        t1935 = self.constants[33] + self.constants[18];
        t1937 = t1935 + cos_delta * t1930;
        t1942 = sin_delta * self.constants[42];
        t1947 = t18 * t1942 + t88 * t1797;
        t1949 = cos_delta * self.constants[42];
        t1957 = t29 * t1942 + t1774 * t1797 + t813 * t1947 + t1769 * t1786 - t852
            - t805 * t1949;
        t1958 = t1957 - self.constants[38] * t1850;
        t1961 = cos_delta * self.constants[40];
        t1968 = t29 * self.constants[41] - t18 * t1961 - t88 * t1769;
        t1970 = sin_delta * self.constants[40];
        t1977 = t813 * t1968 + t1786 * t1797 - t18 * self.constants[41] - t29 * t1961
            - t1769 * t1774 - t805 * t1970;
        t1983 = t29 * t1931 + t813 * t1933 + t1672 * t1892 + self.constants[24] * t1811
            + cos_delta * t1958 + sin_delta * t1977;
        t1987 = t1983 - self.constants[31] * t1764 - self.constants[30] * t1841
            - t805 * t1937 - self.constants[46] * t1850;
        t1991 = t116 * t1456 + t119 * t1472;
        t1997 = t29 * self.constants[32] - t18 * self.constants[35];
        t2006 = t6 * self.constants[31] + t813 * t1997 + cos_delta * t1977
            - t18 * self.constants[32] - t29 * self.constants[35]
            - self.constants[24] * t1889;
        t2007 = t2006 - sin_delta * t1958;
        t2010 = t1465 + cos_phi * t1921;
        t2017 = t1814 * t1841 + t29 * t1919 - t1764 * t1856 - t18 * t2007;
        t2032 = t158 * t1684 + t171 * t1695 + t378 * t1701 + t362 * t1448 + t389 * t1456
            + t482 * t1452;
        t2035 = t2032 - t129 * t1674 - t162 * t1690 - t359 * t1706;
        t2036 = t6 * sin_phi;
        t2037 = t29 * t2036;
        t2039 = t18 * t2036;
        t2045 = t1814 * t2037 - t1856 * t2039 - sin_phi * t1987 - cos_phi * t2017;
        t2047 = t74 * t1052;
        t2049 = t74 * t989;
        t2051 = t74 * t1047;
        t2053 = t33 * t74;
        t2054 = t1021 * t2053;
        t2056 = t1045 * t2053;
        t2058 = cos_phi * t2047;
        t2064 = t111 * t2047 + t129 * t2049 + t158 * t2051 + t162 * t2054 - t171 * t2056
            - t204 * t2058;
        t2067 = t383 * t1676 - t546 * t1675;
        t2069 = t6 * t29;
        t2071 = t6 * t18;
        t2077 = t1987 + t1856 * t2071 + t383 * t2045 - t850 * t2067 - t1814 * t2069;
        t2079 = self.constants[21] * t904;
        t2081 = self.constants[21] * t923;
        t2083 = speeds[0] * t104;
        t2084 = t18 * t2083;
        t2085 = t2084 - t1817;
        t2090 = self.constants[21] * t919;
        t2093 = self.constants[23] + t2071;
        t2095 = sin_delta * t1005;
        t2097 = self.constants[26] + t958;
        t2098 = speeds[0] * cos_delta;
        t2103 = t18 * t886 + speeds[0] * t2093 + t2097 * t2098 - t1824
            - speeds[0] * t2095;
        t2109 = self.constants[22] * t969;
        t2111 = self.constants[22] * t1002;
        t2112 = t35 * t2111;
        t2114 = t540 * t1002;
        t2115 = self.constants[28] * t948;
        t2117 = t939 * t2115 - t2114;
        t2119 = t976 * t1007;
        t2121 = t2119 + t948 * t2115;
        t2124 = cos_phi * (t18 * t2081 + t868 * t2085 - t29 * t2079) + t116 * t933
            + t119 * t926;
        t2129 = t2124 + t129 * t2109 + t162 * t2117 + t171 * t2121
            - sin_phi * (t18 * t2090 + t868 * t2103) - t158 * t2112;
        t2131 = t37 * t1689;
        t2133 = t35 * t1675 - t1676 * t2131;
        t2136 = t37 * t2053;
        t2139 = t2077 * t2136 - t850 * t2133 - t2045 * t2131;
        t2142 = t868 * t873;
        t2144 = t2097 + cos_delta * self.constants[23];
        t2148 = t29 * t2083;
        t2149 = t1730 + t2148;
        t2152 = t18 * t2079 + t29 * t2081 + t868 * t2149;
        t2158 = self.constants[27] + t967;
        t2159 = sin_delta * t2158;
        t2162 = speeds[0] * t2159 + cos_delta * t1862;
        t2166 = t2069 - self.constants[24];
        t2169 = t1740 + t29 * t886 + speeds[0] * t2166;
        t2171 = t29 * t2090 + t868 * t2169;
        t2178 = t895 * t2144 - sin_delta * t926;
        t2180 = sin_delta * t933;
        t2185 = self.constants[22] * (t35 * t965 - t37 * t969);
        t2189 = t540 * t965 + t948 * t976;
        t2193 = t939 * t976 - t540 * t969;
        t2196 = cos_phi * (t2142 * t2144 - cos_delta * t1859 - sin_delta * t2152)
            + t158 * t2185 + t162 * t2189;
        t2198 = t2196 - sin_phi * (cos_delta * t2079 + t868 * t2162 - sin_delta * t2171)
            - t116 * t2178;
        t2200 = t2198 - t119 * t2180 - t171 * t2193;
        t2201 = t33 * t344;
        t2202 = t1676 * t2201;
        t2205 = t43 * t74;
        t2208 = t2045 * t2201 + t2077 * t2205 - t850 * t2202;
        t2212 = sin_delta * self.constants[23] - t1005;
        t2221 = sin_delta * t1862 - t2098 * t2158;
        t2229 = t895 * t2212 + cos_delta * t926;
        t2231 = cos_delta * t933;
        t2233 = self.constants[22] * t965;
        t2235 = t37 * t2111;
        t2237 = self.constants[28] * t939;
        t2239 = t2119 + t939 * t2237;
        t2242 = t2114 + t948 * t2237;
        t2245 = cos_phi * (t2142 * t2212 + cos_delta * t2152 - sin_delta * t1859)
            + t119 * t2231 + t158 * t2235;
        t2247 = t2245 - sin_phi * (sin_delta * t2079 + t868 * t2221 + cos_delta * t2171)
            - t116 * t2229;
        t2250 = t2247 - t129 * t2233 - t162 * t2239 - t171 * t2242;
        t2252 = t35 * t1689;
        t2254 = t37 * t1675 + t1676 * t2252;
        t2257 = t35 * t2053;
        t2260 = t850 * t2254 + t2077 * t2257 - t2045 * t2252;
        t2262 = t34 * t974;
        t2264 = t971 * t2262;
        t2266 = t948 * t971;
        t2268 = t939 * t971;
        t2272 = t129 * t2262 + t162 * t2266 - t158 * t2264 - t171 * t2268;
        t2273 = t37 * self.constants[28];
        t2274 = t1007 * t2273;
        t2277 = t35 * self.constants[28];
        t2279 = t939 * t2273 + t948 * t2277;
        t2281 = t1007 * t2277;
        t2284 = t2208 * t2279 - t2139 * t2274 - t2260 * t2281;
        t2288 = t869 * t871 + t119 * t895;
        t2291 = cos_delta * t1005 + sin_delta * t2097;
        t2295 = cos_delta * t2158 + cos_delta * self.constants[24];
        t2298 = t2159 + sin_delta * self.constants[24];
        t2301 = t2208 * t2295 + t2260 * t2298 - t2139 * t2291;
        t2303 = t872 * self.constants[31];
        t2304 = self.constants[30] * t875;
        t2307 = t1157 + t1157;
        t2309 = t1103 + t1103;
        t2312 = t875 * t1935 - t878;
        t2315 = t890 + t890;
        t2316 = self.constants[38] * t2315;
        t2319 = t882 - t872 * t1935 - sin_delta * t2316;
        t2323 = t29 * t2312 - t18 * t2319;
        t2325 = cos_delta * t2316;
        t2329 = t29 * t2307 + t18 * t2309;
        t2331 = self.constants[37] * t2315;
        t2333 = self.constants[24] * t872;
        t2334 = self.constants[23] * t875;
        t2335 = t2333 + t2334;
        t2337 = t892 + t892;
        t2342 = cos_delta * t2335 + sin_delta * t2337;
        t2346 = sin_delta * t2335 - cos_delta * t2337;
        t2349 = self.constants[19] * t948;
        t2351 = self.constants[42] * t948 + t2349 - t1203;
        t2354 = self.constants[19] * t939;
        t2356 = t1177 - self.constants[42] * t939 - t2354;
        t2357 = cos_delta * t2356;
        t2359 = t939 * self.constants[39];
        t2360 = self.constants[38] * t948;
        t2361 = t2359 + t2360;
        t2363 = t1130 + t1130;
        t2365 = cos_delta * t2361 - sin_delta * t2363;
        t2371 = t29 * t2351 + t88 * t2365 - t18 * t2357;
        t2373 = sin_delta * t2356;
        t2377 = sin_delta * t2361 + cos_delta * t2363;
        t2379 = t1091 + t1091;
        t2383 = t944 + t977;
        t2385 = speeds[1] * t1005 - t944 - t2383;
        t2387 = self.constants[26] * t948;
        t2390 = t939 * self.constants[27] - speeds[1] * t2158;
        t2391 = t2387 + t2390;
        t2393 = t949 + t979;
        t2394 = t949 + t2393;
        t2400 = t1774 * t2365 + t813 * t2371 + speeds[1] * t1977 + t2139 * t2385
            + t2208 * t2391 - t18 * t2351;
        t2405 = t2400 - t29 * t2357 - t805 * t2373 - t1786 * t2377 - t1850 * t2379
            - t2260 * t2394;
        t2408 = t1181 - self.constants[40] * t943;
        t2410 = self.constants[41] * t943;
        t2414 = self.constants[40] * t939 - t1175 - t1177;
        t2416 = cos_delta * t2410 - sin_delta * t2414;
        t2420 = cos_delta * t1130 + sin_delta * t2359;
        t2426 = t29 * t2408 + t88 * t2420 - t18 * t2416;
        let (
            t2430, t2434, t2436, t2441, t2444, t2447, t2449, t2452, t2454, t2460, t2465, t2466,
            t2472, t2477, t2482, t2484, t2488, t2491, t2494, t2496, t2497, t2498, t2500, t2504,
            t2510, t2514, t2516, t2526, t2532, t2540, t2545, t2550, t2551, t2557, t2559, t2562,
            t2566, t2567, t2570, t2572, t2576, t2581, t2583, t2584, t2586, t2589, t2594, t2598,
            t2601, t2604, t2609, t2610, t2614, t2617, t2622, t2625, t2628, t2633, t2636, t2641,
            t2646, t2652, t2655, t2659, t2661, t2664, t2668, t2671, t2677, t2678, t2683, t2686,
            t2688, t2690, t2691, t2696, t2697, t2702, t2708, t2713, t2714, t2718, t2721, t2727,
            t2729, t2731, t2733, t2735, t2739, t2742, t2747, t2751, t2759, t2761, t2770, t2775,
            t2776, t2778, t2783, t2788, t2793, t2798, t2803, t2807, t2811, t2815, t2821, t2830,
            t2837, t2841, t2843, t2850, t2854, t2863, t2864, t2873, t2887, t2894, t2900, t2901,
            t2909, t2917, t2925, t2934, t2940, t2946, t2952, t2958, t2964, t2987, t2990, t3005,
            t3009, t3015, t3020, t3038, t3043, t3044, t3060, t3065, t3070, t3071, t3082, t3095,
            t3100, t3101, t3119, t3124, t3125, t3132, t3137, t3142, t3147, t3152, t3157, t3170,
            t3179, t3185, t3189, t3191, t3198, t3202, t3211, t3212, t3220, t3234, t3240, t3246,
            t3248, t3256, t3264, t3272, t3281, t3287, t3293, t3299, t3305, t3311, t3334, t3336,
            t3351, t3354, t3360, t3365, t3383, t3388, t3389, t3404, t3409, t3414, t3415, t3425,
            t3438, t3443, t3444, t3462, t3467, t3468, t3476, t3481, t3486, t3491, t3496, t3501,
            t3503, t3507, t3511, t3513, t3515, t3519, t3523, t3535, t3538, t3542, t3550, t3567,
            t3572, t3581, t3589, t3595, t3599, t3603, t3618, t3621, t3631, t3651, t3653, t3656,
            t3659, t3670, t3671, t3685, t3687, t3695, t3697, t3703, t3707, t3716, t3721, t3726,
            t3731, t3736, t3741, t3744, t3782, t3787, t3792, t3797, t3802, t3807,
        );
        t2430 = sin_delta * t2410 + cos_delta * t2414;
        t2434 = cos_delta * t2359 - sin_delta * t1130;
        t2436 = t1089 - t1088;
        t2441 = t996 + t1012;
        t2444 = speeds[1] * t2097 + t2441 - t995 - t37 * t2115;
        t2447 = t2393 + t958 * t963;
        t2449 = t963 * t1005;
        t2452 = t2390 + t37 * t2237 - t2449;
        t2454 = t35 * t971;
        t2460 = t1774 * t2420 + t813 * t2426 + t1786 * t2434 + t1850 * t2436
            + t2139 * t2444 + t2208 * t2447;
        t2465 = t2460 + t2260 * t2452 + t2284 * t2454 - t18 * t2408 - t29 * t2416
            - t805 * t2430;
        t2466 = t2465 - speeds[1] * t1958;
        t2472 = t1764 * t2307 + t813 * t2323 + t1889 * t2335 + t2208 * t2342
            + t2260 * t2346 + cos_delta * t2405;
        t2477 = t2472 + sin_delta * t2466 - t6 * (t2303 + t2304) - t1841 * t2309
            - t18 * t2312 - t29 * t2319;
        t2482 = t2477 - t805 * t2325 - t1672 * t2329 - t1850 * t2331 - t1811 * t2337
            - t2139 * t2315;
        t2484 = t18 * t888;
        t2488 = t119 * t869 - t2484 - speeds[0] * t116;
        t2491 = t1101 - t1100;
        t2494 = t1230 - self.constants[35] * t889;
        t2496 = self.constants[32] * t889;
        t2497 = t916 - t915;
        t2498 = self.constants[38] * t2497;
        t2500 = t2496 + sin_delta * t2498;
        t2504 = t29 * t2494 - t18 * t2500;
        t2510 = self.constants[35] * t872 - t880 - t882 - cos_delta * t2498;
        t2514 = t29 * t2303 + t18 * t2491;
        t2516 = self.constants[37] * t2497;
        t2526 = cos_delta * t892 + t94 * t2144 - sin_delta * t2333;
        t2532 = sin_delta * t892 + t94 * t2212 + cos_delta * t2333;
        t2540 = t1841 * t2491 + t813 * t2504 + t1672 * t2514 + t1850 * t2516
            + t892 * t1889 + t1811 * t2333;
        t2545 = t2540 + t94 * t1919 + t2139 * t2497 + t2208 * t2526 + t2260 * t2532
            + cos_delta * t2466;
        t2550 = t2545 - t6 * t1157 - t1764 * t2303 - t18 * t2494 - t29 * t2500
            - t805 * t2510;
        t2551 = t2550 - sin_delta * t2405;
        t2557 = t85 * t868 + t116 * t869 + speeds[0] * t119;
        t2559 = t1099 + t1101;
        t2562 = t2410 + t2496;
        t2566 = self.constants[43] * t943 - t1181;
        t2567 = cos_delta * t2566;
        t2570 = t1202 + t1203 - self.constants[43] * t948;
        t2572 = t2570 - self.constants[38] * t2334;
        t2576 = self.constants[36] * t889 + t2567 - t1230 - sin_delta * t2572;
        t2581 = t1086 + t1089;
        t2583 = cos_delta * t1091 - sin_delta * t2581;
        t2584 = t88 * t2583;
        t2586 = t2584 - t29 * t2562 - t18 * t2576;
        t2589 = sin_delta * t2566;
        t2594 = t877 + t878 + t2589 + cos_delta * t2572 - self.constants[36] * t875;
        t2598 = t18 * t2304 - t29 * t2559;
        t2601 = t2360 + self.constants[37] * t2334;
        t2604 = t914 + t916;
        t2609 = t2387 + t35 * t2115 - t2449;
        t2610 = t2334 + t2609;
        t2614 = t2383 + t963 * t967;
        t2617 = cos_delta * t890 + t2614 + sin_delta * t2604;
        t2622 = t994 + t2441 + t35 * t2237;
        t2625 = sin_delta * t890 - t2622 - cos_delta * t2604;
        t2628 = t37 * t971;
        t2633 = sin_delta * t1091 + cos_delta * t2581;
        t2636 = t2284 * t2628 + t1774 * t2583 - t1786 * t2633;
        t2641 = t1764 * t2559 + t1841 * t2304 + t18 * t2562 + t813 * t2586
            + t1672 * t2598 + t1850 * t2601;
        t2646 = t2641 + t890 * t1889 + t2139 * t2610 + t2208 * t2617 + t2260 * t2625
            + t94 * t2301;
        t2652 = t2646 + t2636 - t6 * t1103 - t29 * t2576 - t805 * t2594 - t1811 * t2604
            - t94 * t2007;
        t2655 = cos_delta * t2354;
        t2659 = t29 * t2349 + t18 * t2655;
        t2661 = sin_delta * t2354;
        t2664 = t977 + t939 * t1005;
        t2668 = t939 * t967 + t948 * t958;
        t2671 = t979 + t948 * t1005;
        t2677 = t29 * t2655 + t813 * t2659 + t805 * t2661 + t2208 * t2668 - t18 * t2349
            - t2139 * t2664;
        t2678 = t2677 - t2260 * t2671;
        t2683 = t6 * t869;
        t2686 = t906 + t104 * t869;
        t2688 = t2148 + t18 * t2686;
        t2690 = cos_delta * t2683 - sin_delta * t2688;
        t2691 = t875 * t2144 + t2690;
        t2696 = sin_delta * t2683 + cos_delta * t2688;
        t2697 = t875 * t2212 + t2696;
        t2702 = t2084 - t29 * t2686;
        t2708 = t1814 * t2688 + t2139 * t2702 - t1856 * t2702 - t1895 * t2683;
        t2713 = t2482 + t875 * t1919 + t2208 * t2691 + t2260 * t2697 + t872 * t2301
            + t2708;
        t2714 = t2713 - t872 * t2007;
        t2718 = cos_phi * t1744;
        t2721 = sin_phi * t1730 + cos_phi * t1740 + t29 * t2718;
        t2727 = sin_phi * t1817 + cos_phi * t1824 - t18 * t2718;
        t2729 = sin_phi * t1858;
        t2731 = t2729 - cos_phi * t1862;
        t2733 = cos_phi * speeds[0];
        t2735 = speeds[0] * sin_phi;
        t2739 = sin_phi * t2085 + cos_phi * t2103;
        t2742 = sin_phi * t873;
        t2747 = sin_phi * t2149 + cos_phi * t2169;
        t2751 = t2144 * t2742 + cos_phi * t2162 - cos_delta * t2729 - sin_delta * t2747;
        t2759 = t2212 * t2742 + cos_phi * t2221 + cos_delta * t2747 - sin_delta * t2729;
        t2761 = sin_phi * t871;
        t2770 = t1814 * t2721 + t1856 * t2727 + t1895 * t2731 + t2017 * t2735
            + t2139 * t2739 + t2208 * t2751;
        t2775 = t2770 + t2260 * t2759 + t2301 * t2761 + t21 * t2551 - t1987 * t2733
            - sin_phi * t2482;
        t2776 = t2775 - t30 * t2652;
        t2778 = cos_phi
            * (t384 * t1592 + self.constants[21] * (t29 * t1575 - t18 * t1581))
            + t389 * t1655;
        t2783 = t2778 + t813 * t1663 + t1669 * t1672 + t1763 * t1814 + t1840 * t1856
            + t1866 * t1895;
        t2788 = t2783 + t1899 * t1919 + t1927 * t1987 + t2010 * t2017 + t2035 * t2045
            + t2064 * t2077;
        t2793 = t2788 + t2129 * t2139 + t2200 * t2208 + t2250 * t2260 + t2272 * t2284
            + t2288 * t2301;
        t2798 = t2793 + t2488 * t2551 + t2557 * t2652 + t671 * t2678 + t244 * t2714
            + t485 * t2776;
        t2803 = t2798 - sin_phi * t1644 - t116 * t1647 - t119 * t1650 - t208 * t1592
            - t616 * t1545;
        t2807 = t2803 - t805 * t1665 - t850 * t1724 - t1991 * t2007 - t869 * t2482;
        t2811 = t557 * t1545;
        t2815 = t541 * t1545;
        t2821 = t104 * t1337 + t6 * t1335;
        t2830 = t29 * t2821 - self.constants[24] * t1335;
        t2837 = t1337 * t1795 + t1335 * t1797 - self.constants[38] - t1799 * t2830;
        t2841 = t1337 * t1778 + t1782 * t2830 - t1335 * t1780 - sin_delta * t2837;
        t2843 = t1767 * t2821 + t2841 - self.constants[31] * t1335;
        t2850 = self.constants[23] * t1335 + t18 * t2821;
        t2854 = t1337 * t1359 - t781 * t1335 - t1845 * t2821
            - self.constants[37] * t2850;
        t2863 = t1337 * t1878 + t1882 * t2830 + cos_delta * t2837 - t1335 * t1880;
        t2864 = t1337 * t1870 + t2863;
        t2873 = t1337 * t1908 + self.constants[23] * t2863 - self.constants[43]
            - t790 * t1335 - t770 * t2830;
        t2887 = t1355 + t1337 * t1947 + t1769 * t2830 - t1335 * t1949
            - self.constants[38] * t2850;
        t2894 = t1337 * t1968 + t1797 * t2830 - self.constants[41] - t1335 * t1970;
        t2900 = t1337 * t1933 + t1892 * t2821 + self.constants[24] * t2841
            + cos_delta * t2887 + sin_delta * t2894 - t1335 * t1937;
        t2901 = t2900 - self.constants[46] * t2850;
        t2909 = t1337 * t1997 + cos_delta * t2894 - self.constants[24] * t2863
            - sin_delta * t2887;
        t2917 = t1841 * t2843 + t29 * t2873 - t1764 * t2854 - t18 * t2909;
        t2925 = t2037 * t2843 - t2039 * t2854 - sin_phi * t2901 - cos_phi * t2917;
        t2934 = t2901 + t1354 * t2067 + t2071 * t2854 + t383 * t2925 - t2069 * t2843;
        t2940 = t1354 * t2133 + t2136 * t2934 - t2131 * t2925;
        t2946 = t1354 * t2202 + t2201 * t2925 + t2205 * t2934;
        t2952 = t2257 * t2934 - t1354 * t2254 - t2252 * t2925;
        t2958 = t2279 * t2946 - t2274 * t2940 - t2281 * t2952;
        t2964 = t2295 * t2946 + t2298 * t2952 - t2291 * t2940;
        t2987 = t1337 * t2371 + speeds[1] * t2894 + t2385 * t2940 + t2391 * t2946 - t2351
            - t1335 * t2373;
        t2990 = t2987 - t2377 * t2830 - t2379 * t2850 - t2394 * t2952;
        t3005 = t1337 * t2426 + t2434 * t2830 + t2436 * t2850 + t2444 * t2940
            + t2447 * t2946 + t2452 * t2952;
        t3009 = t3005 + t2454 * t2958 - t2408 - t1335 * t2430 - speeds[1] * t2887;
        t3015 = t1337 * t2323 + t2335 * t2863 + t2342 * t2946 + t2346 * t2952
            + cos_delta * t2990 + sin_delta * t3009;
        t3020 = t3015 - t1335 * t2325 - t2329 * t2821 - t2331 * t2850 - t2337 * t2841
            - t2315 * t2940;
        t3038 = t1337 * t2504 + t2514 * t2821 + t2516 * t2850 + t892 * t2863
            + t2333 * t2841 + t94 * t2873;
        t3043 = t3038 + t2497 * t2940 + t2526 * t2946 + t2532 * t2952 + cos_delta * t3009
            - t1335 * t2510;
        t3044 = t3043 - sin_delta * t2990;
        t3060 = t2410 + t2628 * t2958 - t2633 * t2830;
        t3065 = t1337 * t2586 + t2598 * t2821 + t2601 * t2850 + t890 * t2863
            + t2610 * t2940 + t2617 * t2946;
        t3070 = t3065 + t2625 * t2952 + t94 * t2964 + t3060 - t1335 * t2594
            - t2604 * t2841;
        t3071 = t3070 - t94 * t2909;
        t3082 = t1337 * t2659 + t1335 * t2661 + t2668 * t2946 - t2349 - t2664 * t2940
            - t2671 * t2952;
        t3095 = t2688 * t2843 + t2683 * t2864 + t2702 * t2940 - t2702 * t2854;
        t3100 = t3020 + t875 * t2873 + t2691 * t2946 + t2697 * t2952 + t872 * t2964
            + t3095;
        t3101 = t3100 - t872 * t2909;
        t3119 = t2721 * t2843 + t2727 * t2854 + t2735 * t2917 + t2739 * t2940
            + t2751 * t2946 + t2759 * t2952;
        t3124 = t3119 + t2761 * t2964 + t21 * t3044 - t2731 * t2864 - t2733 * t2901
            - sin_phi * t3020;
        t3125 = t3124 - t30 * t3071;
        t3132 = t1337 * t1592 + t158 * t2811 + t482 * t1655 + t1337 * t1663
            + t1669 * t2821 + t1354 * t1724;
        t3137 = t3132 + t1763 * t2843 + t1840 * t2854 + t1899 * t2873 + t1927 * t2901
            + t2010 * t2917;
        t3142 = t3137 + t2035 * t2925 + t2064 * t2934 + t2129 * t2940 + t2200 * t2946
            + t2250 * t2952;
        t3147 = t3142 + t2272 * t2958 + t2288 * t2964 + t2488 * t3044 + t2557 * t3071
            + t671 * t3082;
        t3152 = t3147 + t244 * t3101 + t485 * t3125 - t1334 * t1634 - t242 * t1592
            - t667 * t2815;
        t3157 = t3152 - t1335 * t1665 - t1866 * t2864 - t1991 * t2909 - t869 * t3020
            - t1385 * t2807;
        t3170 = t6 + t104 * t1223 - t6 * t1168;
        t3179 = self.constants[24] * t1168 + t29 * t3170;
        t3185 = t1223 * t1795 - t1168 * t1797 - t1799 * t3179;
        t3189 = t1223 * t1778 + t1168 * t1780 + t1782 * t3179 - sin_delta * t3185;
        t3191 = self.constants[31] * t1168 + t1767 * t3170 + t3189;
        t3198 = t18 * t3170 - self.constants[23] * t1168;
        t3202 = t1223 * t1359 + t781 * t1168 - t1845 * t3170
            - self.constants[37] * t3198;
        t3211 = t1223 * t1878 + t1168 * t1880 + t1882 * t3179 + cos_delta * t3185;
        t3212 = t1223 * t1870 + t3211;
        t3220 = t1223 * t1908 + t790 * t1168 + self.constants[23] * t3211 - t770 * t3179;
        t3234 = t1433 + t1223 * t1947 + t1168 * t1949 + t1769 * t3179
            - self.constants[38] * t3198;
        t3240 = t1223 * t1968 + t1168 * t1970 + t1797 * t3179;
        t3246 = t1223 * t1933 + t1168 * t1937 + t1892 * t3170
            + self.constants[24] * t3189 + cos_delta * t3234 + sin_delta * t3240;
        t3248 = t3246 - self.constants[18] - self.constants[46] * t3198;
        t3256 = t1223 * t1997 + cos_delta * t3240 - self.constants[24] * t3211
            - sin_delta * t3234;
        t3264 = t1841 * t3191 + t29 * t3220 - t1764 * t3202 - t18 * t3256;
        t3272 = t2037 * t3191 - t2039 * t3202 - sin_phi * t3248 - cos_phi * t3264;
        t3281 = t3248 + t1323 * t2067 + t2071 * t3202 + t383 * t3272 - t2069 * t3191;
        t3287 = t1323 * t2133 + t2136 * t3281 - t2131 * t3272;
        t3293 = t1323 * t2202 + t2201 * t3272 + t2205 * t3281;
        t3299 = t2257 * t3281 - t1323 * t2254 - t2252 * t3272;
        t3305 = t2279 * t3293 - t2274 * t3287 - t2281 * t3299;
        t3311 = t2295 * t3293 + t2298 * t3299 - t2291 * t3287;
        t3334 = t1223 * t2371 + t1168 * t2373 + speeds[1] * t3240 + t2385 * t3287
            + t2391 * t3293 - t2377 * t3179;
        t3336 = t3334 - t2379 * t3198 - t2394 * t3299;
        t3351 = t1223 * t2426 + t1168 * t2430 + t2434 * t3179 + t2436 * t3198
            + t2444 * t3287 + t2447 * t3293;
        t3354 = t3351 + t2452 * t3299 + t2454 * t3305 - speeds[1] * t3234;
        t3360 = t1223 * t2323 + t1168 * t2325 + t2335 * t3211 + t2342 * t3293
            + t2346 * t3299 + cos_delta * t3336;
        t3365 = t3360 + sin_delta * t3354 - t2329 * t3170 - t2331 * t3198 - t2337 * t3189
            - t2315 * t3287;
        t3383 = t1223 * t2504 + t1168 * t2510 + t2514 * t3170 + t2516 * t3198
            + t892 * t3211 + t2333 * t3189;
        t3388 = t3383 + t94 * t3220 + t2497 * t3287 + t2526 * t3293 + t2532 * t3299
            + cos_delta * t3354;
        t3389 = t3388 - sin_delta * t3336;
        t3404 = t2633 * t3179 - t2628 * t3305;
        t3409 = t1223 * t2586 + t1168 * t2594 + t2598 * t3170 + t2601 * t3198
            + t890 * t3211 + t2610 * t3287;
        t3414 = t3409 + t2617 * t3293 + t2625 * t3299 + t94 * t3311 - t2604 * t3189
            - t94 * t3256;
        t3415 = t3414 - t3404;
        t3425 = t1223 * t2659 + t2668 * t3293 - t1168 * t2661 - t2664 * t3287
            - t2671 * t3299;
        t3438 = t2688 * t3191 + t2683 * t3212 + t2702 * t3287 - t2702 * t3202;
        t3443 = t3365 + t875 * t3220 + t2691 * t3293 + t2697 * t3299 + t872 * t3311
            + t3438;
        t3444 = t3443 - t872 * t3256;
        t3462 = t2721 * t3191 + t2727 * t3202 + t2735 * t3264 + t2739 * t3287
            + t2751 * t3293 + t2759 * t3299;
        t3467 = t3462 + t2761 * t3311 + t21 * t3389 - t2731 * t3212 - t2733 * t3248
            - sin_phi * t3365;
        t3468 = t3467 - t30 * t3415;
        t3476 = t1223 * t1592 + t362 * t1655 + t1223 * t1663 + t1168 * t1665
            + t1669 * t3170 + t1323 * t1724;
        t3481 = t3476 + t1763 * t3191 + t1840 * t3202 + t1899 * t3220 + t1927 * t3248
            + t2010 * t3264;
        t3486 = t3481 + t2035 * t3272 + t2064 * t3281 + t2129 * t3287 + t2200 * t3293
            + t2250 * t3299;
        t3491 = t3486 + t2272 * t3305 + t2288 * t3311 + t2488 * t3389 + t2557 * t3415
            + t671 * t3425;
        t3496 = t3491 + t244 * t3444 + t485 * t3468 - sin_phi * (t1658 + t349 * t1634)
            - t587 * t1545 - t1866 * t3212;
        t3501 = t1447
            * (t3496 - t1991 * t3256 - t869 * t3365 - t1330 * t2807 - t1410 * t3157);
        t3503 = t1409 * t3157 - t1410 * t3501;
        t3507 = t863 * t2807 - t1385 * t3503 - t1330 * t3501;
        t3511 = t1506 * t1769 - t1510 * t1797;
        t3513 = t1551 + sin_delta * t3511;
        t3515 = self.constants[37] * t1506;
        t3519 = self.constants[37] * t1510;
        t3523 = cos_delta * (t1555 + sin_delta * t3515)
            - sin_delta * (t1562 + sin_delta * t3519);
        t3535 = t18 * t3513 + t88 * t3523 - t250 * t1617 - t252 * t1630;
        t3538 = t1624 + cos_delta * t3511;
        t3542 = t252 * t1575 - t250 * t1581;
        t3550 = cos_delta * (cos_delta * t3515 - t1562)
            - sin_delta * (t1555 + cos_delta * t3519);
        t3567 = t270 * t1686 + t274 * t1692 + t278 * t1697 + t503 * t1702 + t681 * t1704
            + t686 * t1709;
        t3572 = t3567 + t703 * t1711 + t729 * t1713 - t255 * t1677 - t695 * t1699
            - t493 * t1707;
        t3581 = t250 * t1476 + t252 * t1481 - t313 * t1754 - t321 * t1757;
        t3589 = t252 * t1476 + t313 * t1832 + t321 * t1834 - t250 * t1481;
        t3595 = t252 * t1456 - t250 * t1472;
        t3599 = t313 * t1456 + t321 * t1452;
        t3603 = t250 * t1456 + t252 * t1472;
        t3618 = t270 * t1684 + t278 * t1695 + t503 * t1701 + t495 * t1448 + t508 * t1456
            + t534 * t1452;
        t3621 = t3618 - t255 * t1674 - t274 * t1690 - t493 * t1706;
        t3631 = t255 * t2049 + t270 * t2051 + t274 * t2054 - t278 * t2056 - t311 * t2058;
        t3651 = t250 * t933 + t252 * t926 + t255 * t2109 + t274 * t2117 + t278 * t2121
            - cos_delta * (t919 * t1005 + t902 * t2097);
        t3653 = t3651 - sin_delta * (t919 * t2097 - t902 * t1005) - t270 * t2112;
        t3656 = t919 * t2158 - t937;
        t3659 = t911 + t902 * t2158;
        t3670 = cos_delta * t3656 + t270 * t2185 + t274 * t2189 - sin_delta * t3659
            - t250 * t2178 - t252 * t2180;
        t3671 = t3670 - t278 * t2193;
        t3685 = cos_delta * t3659 + sin_delta * t3656 + t252 * t2231 + t270 * t2235
            - t250 * t2229 - t255 * t2233;
        t3687 = t3685 - t274 * t2239 - t278 * t2242;
        t3695 = t255 * t2262 + t274 * t2266 - t270 * t2264 - t278 * t2268;
        t3697 = t252 * t895;
        t3703 = t252 * t869 - speeds[0] * t250;
        t3707 = t250 * t869 + speeds[0] * t252;
        t3716 = t29 * t3513 + t1774 * t3523 + t508 * t1655 + t813 * t3535 + t1672 * t3542
            + t1786 * t3550;
        t3721 = t3716 + t1814 * t3581 + t1856 * t3589 + t1535 * t1977 + t1919 * t3595
            + t1987 * t3599;
        t3726 = t3721 + t2045 * t3621 + t2077 * t3631 + t2139 * t3653 + t2208 * t3671
            + t2260 * t3687;
        t3731 = t3726 + t2284 * t3695 + t2301 * t3697 + t943 * t2466 + t2551 * t3703
            + t2652 * t3707;
        t3736 = t3731 + t733 * t2678 + t323 * t2714 + t537 * t2776 - t250 * t1647
            - t252 * t1650;
        t3741 = t3736 - t313 * t1592 - t703 * t1545 - t805 * t3538 - t850 * t3572
            - t1527 * t1805;
        t3744 = t3741 - t1516 * t1958 - t2007 * t3603 - t948 * t2405;
        t3782 = t270 * t2811 + t534 * t1655 + t1337 * t3535 + t2821 * t3542
            + t2830 * t3550 + t1354 * t3572;
        t3787 = t3782 + t2843 * t3581 + t2854 * t3589 + t1535 * t2894 + t2873 * t3595
            + t2901 * t3599;
        t3792 = t3787 + t2925 * t3621 + t2934 * t3631 + t2940 * t3653 + t2946 * t3671
            + t2952 * t3687;
        t3797 = t3792 + t2958 * t3695 + t2964 * t3697 + t943 * t3009 + t3044 * t3703
            + t3071 * t3707;
        t3802 = t3797 + t733 * t3082 + t323 * t3101 + t537 * t3125 - t321 * t1592
            - t729 * t2815;
        t3807 = t3802 - t1335 * t3538 - t1527 * t2837 - t1516 * t2887 - t2909 * t3603
            - t948 * t2990;
        let (
            t3808, t3845, t3850, t3855, t3860, t3865, t3870, t3871, t3873, t3877, t3878, t3879,
            t3880, t3881, t3883, t3885, t3887, t3892, t3896, t3901, t3904, t3909, t3912, t3918,
            t3930, t3935, t3937, t3957, t3962, t3965, t3986, t3991, t3996, t3998, t4002, t4005,
            t4010, t4013, t4021, t4024, t4027, t4036, t4041, t4044, t4062, t4067, t4069, t4088,
            t4093, t4097, t4099, t4103, t4104, t4106, t4110, t4120, t4122, t4134, t4135, t4148,
            t4151, t4153, t4157, t4161, t4163, t4167, t4168, t4170, t4173, t4174, t4175, t4176,
            t4177, t4178, t4179, t4180, t4181, t4182, t4183, t4184, t4185, t4186, t4187, t4188,
        );
        t3808 = t3807 - t1385 * t3744;
        t3845 = t495 * t1655 + t1223 * t3535 + t1168 * t3538 + t3170 * t3542
            + t3179 * t3550 + t1323 * t3572;
        t3850 = t3845 + t3191 * t3581 + t3202 * t3589 + t1535 * t3240 + t3220 * t3595
            + t3248 * t3599;
        t3855 = t3850 + t3272 * t3621 + t3281 * t3631 + t3287 * t3653 + t3293 * t3671
            + t3299 * t3687;
        t3860 = t3855 + t3305 * t3695 + t3311 * t3697 + t943 * t3354 + t3389 * t3703
            + t3415 * t3707;
        t3865 = t3860 + t733 * t3425 + t323 * t3444 + t537 * t3468 - t686 * t1545
            - t1527 * t3185;
        t3870 = t3865 - t1516 * t3234 - t3256 * t3603 - t948 * t3336 - t1330 * t3744
            - t1410 * t3808;
        t3871 = t1447 * t3870;
        t3873 = t1409 * t3808 - t1410 * t3871;
        t3877 = t863 * t3744 - t1385 * t3873 - t1330 * t3871;
        t3878 = t886 + t886;
        t3879 = t18 * t3878;
        t3880 = t105 + t1858;
        t3881 = t2683 + t3880;
        t3883 = t29 * t3881 - t3879;
        t3885 = t29 * t3878;
        t3887 = t3885 + t18 * t3881;
        t3892 = t3880 + t104 * t888;
        t3896 = cos_delta * t869;
        t3901 = t3885 + t18 * t3892 + t869 * t2093 + t2097 * t3896 - t869 * t2095;
        t3904 = t29 * t888;
        t3909 = t29 * t3892 + t869 * t2166 - t3879;
        t3912 = t869 * t2159 + t2144 * t3904 - sin_delta * t3909;
        t3918 = t2212 * t3904 + cos_delta * t3909 - t2158 * t3896;
        t3930 = t1814 * t3883 + t888 * t2017 + t2139 * t3901 + t2208 * t3912
            + t2260 * t3918 + t2301 * t2484;
        t3935 = t3930 + t29 * t2551 + t18 * t2652 + t592 * t2678 + t75 * t2714
            + t384 * t2776;
        t3937 = t3935 - t1856 * t3887 - t869 * t1987;
        t3957 = t2843 * t3883 + t888 * t2917 + t2940 * t3901 + t2946 * t3912
            + t2952 * t3918 + t2484 * t2964;
        t3962 = t3957 + t29 * t3044 + t18 * t3071 + t592 * t3082 + t75 * t3101
            + t384 * t3125;
        t3965 = t3962 - t2854 * t3887 - t869 * t2901 - t1385 * t3937;
        t3986 = t3191 * t3883 + t888 * t3264 + t3287 * t3901 + t3293 * t3912
            + t3299 * t3918 + t2484 * t3311;
        t3991 = t3986 + t29 * t3389 + t18 * t3415 + t592 * t3425 + t75 * t3444
            + t384 * t3468;
        t3996 = t1447
            * (t3991 - t3202 * t3887 - t869 * t3248 - t1330 * t3937 - t1410 * t3965);
        t3998 = t1409 * t3965 - t1410 * t3996;
        t4002 = t863 * t3937 - t1385 * t3998 - t1330 * t3996;
        t4005 = t2567 - sin_delta * t2570;
        t4010 = t2584 - t29 * t2410 - t18 * t4005;
        t4013 = t2589 + cos_delta * t2570;
        t4021 = t2609 + t943 * t1005 + t948 * t2097;
        t4024 = t2614 - t943 * t2158;
        t4027 = t2622 + t948 * t2158;
        t4036 = t2636 + t18 * t2410 + t813 * t4010 + t1850 * t2360 + t943 * t1977
            + t2139 * t4021;
        t4041 = t4036 + t2208 * t4024 + t555 * t2678 + t92 * t2714 + t468 * t2776
            - t29 * t4005;
        t4044 = t4041 - t805 * t4013 - t948 * t1958 - t2260 * t4027;
        t4062 = t3060 + t1337 * t4010 + t2360 * t2850 + t943 * t2894 + t2940 * t4021
            + t2946 * t4024;
        t4067 = t4062 + t555 * t3082 + t92 * t3101 + t468 * t3125 - t1335 * t4013
            - t948 * t2887;
        t4069 = t4067 - t2952 * t4027 - t1385 * t4044;
        t4088 = t1223 * t4010 + t1168 * t4013 + t2360 * t3198 + t943 * t3240
            + t3287 * t4021 + t3293 * t4024;
        t4093 = t4088 + t555 * t3425 + t92 * t3444 + t468 * t3468 - t3404 - t948 * t3234;
        t4097 = t1447 * (t4093 - t3299 * t4027 - t1330 * t4044 - t1410 * t4069);
        t4099 = t1409 * t4069 - t1410 * t4097;
        t4103 = t863 * t4044 - t1385 * t4099 - t1330 * t4097;
        t4104 = self.constants[18] * t875;
        t4106 = self.constants[18] * t872;
        t4110 = t29 * t4104 + t18 * t4106;
        t4120 = t2708 + t29 * t4106 + t813 * t4110 + t2208 * t2690 + t2260 * t2696
            + t565 * t2678;
        t4122 = t4120 + t349 * t2776 - t18 * t4104;
        t4134 = t3095 + t1337 * t4110 + t2690 * t2946 + t2696 * t2952 + t565 * t3082
            + t349 * t3125;
        t4135 = t4134 - t1385 * t4122;
        t4148 = t3438 + t1223 * t4110 + t2690 * t3293 + t2696 * t3299 + t565 * t3425
            + t349 * t3468;
        t4151 = t1447 * (t4148 - t1330 * t4122 - t1410 * t4135);
        t4153 = t1409 * t4135 - t1410 * t4151;
        t4157 = t863 * t4122 - t1385 * t4153 - t1330 * t4151;
        t4161 = t1447 * (t1385 * t1410 - t1330);
        t4163 = t1385 * t1409 + t1410 * t4161;
        t4167 = t863 + t1385 * t4163 - t1330 * t4161;
        t4168 = t1410 * t1447;
        t4170 = t1409 + t1410 * t4168;
        t4173 = t1330 * t4168 - t1385 * t4170;
        t4174 = -(t107 * t323);
        t4175 = -(self.constants[21] * sin_psi + t75 * t107);
        t4176 = -(t92 * t107);
        t4177 = -t107;
        t4178 = -(t96 * cos_psi + sin_psi * t100);
        t4179 = -(t323 * t333);
        t4180 = -(t92 * t333);
        t4181 = -t333;
        t4182 = -t485;
        t4183 = -t537;
        t4184 = -t384;
        t4185 = -t468;
        t4186 = -t349;
        t4187 = -t4163;
        t4188 = -t4168;
        (
            [
                [zero, zero, t103, t246, zero, t4174, zero, zero, t4175, t4176, t4177],
                [zero, zero, t4178, t335, zero, t4179, zero, zero, t339, t4180, t4181],
                [zero, zero, zero, t4182, zero, t4183, zero, zero, t4184, t4185, t4186],
                [
                    zero, zero, zero, zero, zero, zero, zero, zero, self.constants[0].like(1.0),
                    zero, zero,
                ],
                [zero, zero, zero, t244, zero, t323, zero, zero, t75, t92, zero],
                [
                    zero, zero, zero, zero, zero, zero, zero, zero, zero,
                    self.constants[0].like(1.0), zero,
                ],
                [
                    zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                    self.constants[0].like(1.0),
                ],
                [zero, zero, zero, t671, zero, t733, zero, zero, t592, t555, t565],
                [zero, zero, zero, t3507, zero, t3877, zero, zero, t4002, t4103, t4157],
                [zero, zero, zero, t3503, zero, t3873, zero, zero, t3998, t4099, t4153],
                [zero, zero, zero, t3501, zero, t3871, zero, zero, t3996, t4097, t4151],
            ],
            [
                [zero, zero], [zero, zero], [zero, zero], [zero, zero], [zero, zero], [zero, zero],
                [zero, zero], [zero, zero], [t4167, t4173], [t4187, t4170], [t4161, t4188],
            ],
        )
    }

    fn by_parameters_unchecked(&self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2]) -> [[T; 28]; 11] {
        let (
            sin_pitch, cos_pitch, t7, sin_phi, cos_phi, t12, t13, sin_delta, cos_delta, t16, t20,
            t21, t25, t26, t27, t28, t30, t32, t36, t39, t41, t48, t51, t53, t55, t56, t57, t58,
            t63, t64, t66, t67, t69, t74, sin_psi, cos_psi, t77, t78, t80, t81, t82, t85, t86, t88,
            t90, t91, t92, t94, t96, t98, t101, t103, t104, t107, t109, t113, t115, t118, t120,
            t123, t125, t129, t132, t135, t137, t141, t142, t144, t146, t147, t148, t149, t151,
            t155, t157, t160, t164, t166, t169, t170, t172, t174, t177, t180, t187, t190, t194,
            t196, t201, t203, t205, t212, t214, t216, t220, t223, t227, t228, t230, t235, t239,
            t244, t248, t249, t251, t255, t257, t280, t284, t285, t287, t290, t296, zero, t301,
            t302, t303, t304, t308, t311, t312, t314, t320, t321, t323, t325, t331, t332, t334,
            t339, t343, t345, t346, t348, t353, t354, t355, t356, t358, t361, t362, t363, t365,
            t368, t370, t374, t378, t386, t392, t394, t402, t404, t406, t410, t417, t428, t429,
            t430, t439, t442, t450, t458, t462, t466, t467, t468, t470, t473, t475, t484, t487,
            t491, t493, t497, t498, t502, t503, t508, t510, t512, t514, t515, t516, t520, t523,
            t526, t530, t531, t532, t539, t540, t542, t543, t546, t550, t551, t553, t555, t557,
            t560, t563, t568, t570, t575, t580, t586, t588, t590, t593, t596, t602, t608, t612,
            t620, t622, t624, t626, t627, t633, t636, t638, t641, t650, t652, t654, t656, t658,
            t663, t670, t681, t687, t692, t697, t698, t706, t711, t712, t718, t719, t725, t727,
            t731, t735, t739, t747, t753, t755, t763, t765, t767, t771, t778, t789, t790,
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
        t39 = cos_delta * sin_phi + t16 * sin_delta;
        t41 = t39 * self.constants[28];
        t48 = self.constants[23] + cos_delta * self.constants[26];
        t51 = t36 * t41 + t7 * self.constants[29] + t12 * t48;
        t53 = self.constants[0].like(1.0) / (cos_phi * t51);
        t55 = self.constants[2] * t13;
        t56 = t55 - self.constants[3] * t16;
        t57 = t53 * t56;
        t58 = t7 * t57;
        t63 = t51 - t7 * self.constants[24] - t12 * self.constants[23];
        t64 = sin_phi * t53;
        t66 = t12 * sin_phi;
        t67 = t53 * t66;
        t69 = t63 * t64 - self.constants[23] * t67;
        t74 = self.constants[25] + cos_phi * self.constants[21];
        (sin_psi, cos_psi) = positions[2].sin_cos();
        t77 = t74 * cos_psi;
        t78 = speeds[1] * t77;
        t80 = t7 * sin_phi;
        t81 = t53 * t80;
        t82 = t78 * t81;
        t85 = t26 * t26;
        t86 = t21 * t85;
        t88 = t26 * self.constants[0].like(0.5);
        t90 = cos_phi * (t13 + t13);
        t91 = t88 * t90;
        t92 = t86 * t91;
        t94 = t12 * cos_delta;
        t96 = t13 * t85;
        t98 = cos_phi * t26 - t91 * t96;
        t101 = t32 + t7 * t92 + t94 * t98;
        t103 = sin_phi * self.constants[29] + t41 * t101;
        t104 = t7 * t53;
        t107 = t77 * speeds[0];
        t109 = t78 * t104 + t53 * t107;
        t113 = t7 * cos_delta;
        t115 = t28 + sin_phi * t113;
        t118 = sin_phi * t30 + t98 * t115 - t66 * t92;
        t120 = t48 + t41 * t118;
        t123 = t12 * t32 - t7 * t30;
        t125 = sin_delta * self.constants[26];
        t129 = t12 * self.constants[29] - t7 * t48;
        t132 = cos_phi * t125 - t41 * t123 - sin_phi * t129;
        t135 = t12 * self.constants[24] - t7 * self.constants[23];
        t137 = t132 + sin_phi * t135;
        t141 = t53 * (t7 * t137 + t63 * t66);
        t142 = cos_phi * t53;
        t144 = t67 - t141 * t142;
        t146 = sin_phi * self.constants[25];
        t147 = t132 + t146;
        t148 = t53 * t147;
        t149 = t142 * t148;
        t151 = t107 * t149 - t78 * t144;
        t155 = t103 * t109 + t120 * t151 - t69 * t78 - self.constants[24] * t82;
        t157 = t12 * t57;
        t160 = t53 * t137 - self.constants[24] * t67;
        t164 = t28 * self.constants[28];
        t166 = cos_phi * cos_delta;
        t169 = t166 * (t21 + t21);
        t170 = t88 * t169;
        t172 = t86 * t170 - t26 * t166;
        t174 = t96 * t170;
        t177 = t94 * t174 - t30 - t7 * t172;
        t180 = sin_phi * t48 - t123 * t164 - t41 * t177;
        t187 = sin_phi * t32 + t66 * t172 + t115 * t174;
        t190 = self.constants[29] + t36 * t164 + t41 * t187;
        t194 = self.constants[23] * t82 + t151 * t190 - t78 * t160 - t109 * t180;
        t196 = t7 * t67;
        t201 = t66 * t109 + t7 * t151;
        t203 = t78 * t196 + t201 - t12 * t82;
        t205 = t12 * t67;
        t212 = t78 * t205 + t7 * t82 + t12 * t151 - t80 * t109;
        t214 = self.constants[2] * t203 + self.constants[3] * t212;
        t216 = t157 * t194 + t214 - t58 * t155;
        t220 = t94 * t151 - t109 * t115;
        t223 = t20 - cos_phi * t113;
        t227 = t53 * (t56 - t55 - self.constants[3] * t223);
        t228 = t7 * t227;
        t230 = t12 * t227;
        t235 = t214 + t194 * t230 - self.constants[2] * t201 - self.constants[3] * t220
            - t155 * t228;
        t239 = self.constants[0] + self.constants[1];
        t244 = self.constants[3] * self.constants[5]
            - self.constants[2] * (self.constants[0] - t239);
        t248 = self.constants[28] * t88;
        t249 = t169 * t248;
        t251 = t90 * t248;
        t255 = cos_phi * t48;
        t257 = cos_phi * self.constants[29];
        t280 = self.constants[3]
            * (t16 * self.constants[4] + t13 * t239 - cos_pitch * t255
                - sin_pitch * t257) + t223 * t244;
        t284 = t280 + t13 * self.constants[26]
            - self.constants[3] * (cos_pitch * t249 + sin_pitch * t251)
            - self.constants[2] * (cos_pitch * t251 - sin_pitch * t249)
            - self.constants[2]
                * (cos_pitch * t257 + t13 * self.constants[4] - sin_pitch * t255
                    - t16 * t239);
        t285 = t53 * t284;
        t287 = t7 + t7 * t285;
        t290 = t12 + t12 * t285;
        t296 = self.constants[26] * t201 + t220 * t244 + self.constants[23] * t203
            + t194 * t290 - self.constants[24] * t212 - t155 * t287;
        zero = self.constants[0].like(0.0);
        t301 = speeds[0] * t148 + speeds[1] * t141;
        t302 = speeds[2] + t301;
        t303 = cos_psi * t302;
        t304 = t64 * t107;
        t308 = self.constants[3] * t13;
        t311 = t53 * (self.constants[2] * t16 + t308 - cos_phi);
        t312 = t7 * t311;
        t314 = t12 * t311;
        t320 = self.constants[3] * t203 + t194 * t314 - t303 - t304
            - self.constants[2] * t212 - t155 * t312;
        t321 = t39 * t123;
        t323 = t36 * t39;
        t325 = t109 * t321 + t151 * t323;
        t331 = t53 * (t25 + self.constants[2] * t223 - t308);
        t332 = t7 * t331;
        t334 = t12 * t331;
        t339 = t325 + self.constants[2] * t220 + t194 * t334 - self.constants[3] * t201
            - t155 * t332;
        t343 = self.constants[0].like(1.0) - cos_phi;
        t345 = t53 * t343;
        t346 = t7 * t345;
        t348 = t12 * t345;
        t353 = t304 + t303 * t343 + t155 * t346 - speeds[0] * sin_psi - t194 * t348;
        t354 = self.constants[0].like(1.0) - t25;
        t355 = t53 * t354;
        t356 = t7 * t355;
        t358 = t12 * t355;
        t361 = t194 * t358 - t325 - t155 * t356;
        t362 = t74 * sin_psi;
        t363 = speeds[1] * t362;
        t365 = t81 * t363;
        t368 = speeds[0] * t362;
        t370 = t104 * t363 + t53 * t368;
        t374 = t149 * t368 - t144 * t363;
        t378 = t103 * t370 + t120 * t374 - t69 * t363 - self.constants[24] * t365;
        t386 = self.constants[23] * t365 + t190 * t374 - t160 * t363 - t180 * t370;
        t392 = t66 * t370 + t7 * t374;
        t394 = t196 * t363 + t392 - t12 * t365;
        t402 = t205 * t363 + t7 * t365 + t12 * t374 - t80 * t370;
        t404 = self.constants[2] * t394 + self.constants[3] * t402;
        t406 = t157 * t386 + t404 - t58 * t378;
        t410 = t94 * t374 - t115 * t370;
        t417 = t404 + t230 * t386 - self.constants[2] * t392 - self.constants[3] * t410
            - t228 * t378;
        t428 = self.constants[26] * t392 + t244 * t410 + self.constants[23] * t394
            + t290 * t386 - self.constants[24] * t402 - t287 * t378;
        t429 = t302 * sin_psi;
        t430 = t64 * t368;
        t439 = self.constants[3] * t394 + t314 * t386 - t429 - t430
            - self.constants[2] * t402 - t312 * t378;
        t442 = t321 * t370 + t323 * t374;
        t450 = t442 + self.constants[2] * t410 + t334 * t386 - self.constants[3] * t392
            - t332 * t378;
        t458 = t430 + cos_psi * speeds[0] + t343 * t429 + t346 * t378 - t348 * t386;
        t462 = t358 * t386 - t442 - t356 * t378;
        t466 = self.constants[0].like(1.0) / (t51 * t123 + t36 * t147);
        t467 = t74 * t466;
        t468 = t118 * t467;
        t470 = t123 * t466;
        t473 = cos_phi * t63 - t13 * self.constants[23];
        t475 = t36 * t466;
        t484 = self.constants[22] + t25 * self.constants[28] + sin_phi * t125
            + cos_phi * t129 - cos_phi * t135;
        t487 = sin_phi * t484 + cos_phi * t137;
        t491 = t66 * t475 - t7 * t470;
        t493 = t257 + self.constants[28] * t91;
        t497 = t13 * t63 - t7 * t484;
        t498 = t466 * t497;
        t502 = t66 * t484 + t13 * t137;
        t503 = t466 * t502;
        t508 = t470 * t473 + t475 * t487 + t491 * t493 + t101 * t498 + t118 * t503;
        t510 = sin_phi * t51;
        t512 = sin_phi * t147;
        t514 = t123 * t510 + t36 * t512;
        t515 = t466 * t514;
        t516 = speeds[1] * t515;
        t520 = t13 * sin_phi - cos_phi * t66;
        t523 = t475 * t520 + t16 * t470;
        t526 = speeds[1] * t523 + t81 * t516;
        t530 = t51 * t101 + t118 * t147;
        t531 = t36 * t467;
        t532 = t466 * t531;
        t539 = t466 * (t123 * t497 + t36 * t502 + t141 * t514);
        t540 = t466 * t539;
        t542 = t148 * t515;
        t543 = t466 * t542;
        t546 = speeds[2] * t532 + speeds[1] * t540 + speeds[0] * t543;
        t550 = t101 * t510 + t118 * t512;
        t551 = t141 * t466;
        t553 = t148 * t466;
        t555 = speeds[1] * t551 + speeds[0] * t553;
        t557 = t13 * t475;
        t560 = speeds[0] * t515;
        t563 = sin_phi * t36;
        t568 = t36 * t546 - speeds[1] * t557 - t104 * t516 - t53 * t560 - t555 * t563;
        t570 = t13 * t470;
        t575 = sin_phi * t123;
        t580 = t149 * t560 + t123 * t546 - speeds[1] * t570 - t144 * t516 - t555 * t575;
        t586 = t530 * t546 + t120 * t580 - speeds[2] * t468 - speeds[1] * t508
            - t69 * t516 - self.constants[24] * t526;
        t588 = t586 - t550 * t555 - t103 * t568;
        t590 = t187 * t467;
        t593 = t484 + t13 * self.constants[24];
        t596 = t255 + self.constants[28] * t170;
        t602 = t177 * t498 + t187 * t503 - t470 * t593 - t491 * t596;
        t608 = t51 * t177 + t147 * t187;
        t612 = t177 * t510 + t187 * t512;
        t620 = self.constants[23] * t526 + t546 * t608 + t180 * t568 + t190 * t580
            - speeds[2] * t590 - speeds[1] * t602;
        t622 = t620 - t160 * t516 - t555 * t612;
        t624 = t7 * t13;
        t626 = t13 * t491;
        t627 = t626 - t470 * t624;
        t633 = t66 * t568 - t7 * t580;
        t636 = t196 * t516 - speeds[1] * t627 - t12 * t526 - t633;
        t638 = t12 * t13;
        t641 = t470 * t638 + t16 * t491;
        t650 = speeds[1] * t641 + t205 * t516 + t7 * t526 + t80 * t568 + t12 * t580;
        t652 = self.constants[2] * t636 + self.constants[3] * t650;
        t654 = t157 * t622 + t652 - t58 * t588;
        t656 = t633 + speeds[1] * t626;
        t658 = t223 * t491;
        t663 = t115 * t568 + t94 * t580 - speeds[1] * t658;
        t670 = t652 + self.constants[2] * t656 + t230 * t622 - self.constants[3] * t663
            - t228 * t588;
        t681 = t244 * t663 + self.constants[23] * t636 + t290 * t622
            - self.constants[26] * t656 - self.constants[24] * t650 - t287 * t588;
        t687 = sin_phi * t563;
        t692 = t555 * t687 + t64 * t560 - t546 * t563;
        t697 = self.constants[3] * t636 + t314 * t622 - speeds[2] * t475
            - self.constants[2] * t650 - t312 * t588 - t692;
        t698 = t25 * t491;
        t706 = t321 * t568 - t323 * t580;
        t711 = self.constants[3] * t656 + self.constants[2] * t663 + t334 * t622
            - speeds[1] * t698 - t332 * t588 - t706;
        t712 = t343 * t475;
        t718 = t692 + speeds[2] * t712 + t346 * t588 - t348 * t622;
        t719 = t354 * t491;
        t725 = t706 + t358 * t622 - speeds[1] * t719 - t356 * t588;
        t727 = speeds[1] * t81;
        t731 = speeds[1] * t104 + t53 * speeds[0];
        t735 = speeds[1] * t144 - speeds[0] * t149;
        t739 = t69 * speeds[1] + self.constants[24] * t727 + t120 * t735 - t103 * t731;
        t747 = speeds[1] * t160 + t180 * t731 + t190 * t735 - self.constants[23] * t727;
        t753 = t66 * t731 - t7 * t735;
        t755 = t12 * t727 - speeds[1] * t196 - t753;
        t763 = t80 * t731 + t12 * t735 - speeds[1] * t205 - t7 * t727;
        t765 = self.constants[2] * t755 + self.constants[3] * t763;
        t767 = t157 * t747 + t765 - t58 * t739;
        t771 = t115 * t731 + t94 * t735;
        t778 = t765 + self.constants[2] * t753 + t230 * t747 - self.constants[3] * t771
            - t228 * t739;
        t789 = t244 * t771 + self.constants[23] * t755 + t290 * t747
            - self.constants[26] * t753 - self.constants[24] * t763 - t287 * t739;
        t790 = t64 * speeds[0];
        let (
            t798, t801, t809, t813, t817, t819, t820, t821, t822, t824, t829, t836, t840, t841,
            t842, t844, t848, t851, t855, t860, t864, t865, t868, t871, t875, t877, t879, t883,
            t886, t890, t892, t896, t899, t909, t911, t913, t926, t928, t930, t938, t939, t940,
            t944, t945, t950, t951, t954, t960, t965, t967, t969, t977, t985, t989, t995, t1001,
            t1006, t1008, t1011, t1012, t1019, t1023, t1027, t1038, t1040, t1042, t1046, t1048,
            t1055, t1062, t1073, t1074, t1081, t1090, t1095, t1096, t1097, t1106, t1111, t1113,
            t1114, t1122, t1123, t1133, t1137, t1138, t1142, t1144, t1145, t1148, t1151, t1152,
            t1153, t1154, t1156, t1158, t1162, t1163, t1166, t1167, t1169, t1170, t1171, t1172,
            t1174, t1177, t1182, t1183, t1185, t1186, t1187, t1188, t1190, t1191, t1193, t1197,
            t1201, t1204, t1206, t1213, t1214, t1222, t1232, t1239, t1245, t1247, t1249, t1253,
            t1255, t1262, t1265, t1266, t1271, t1272, t1273, t1275, t1277, t1278, t1281, t1283,
            t1286, t1288, t1290, t1292, t1293, t1295, t1296, t1299, t1300, t1302, t1303, t1304,
            t1306, t1308, t1310, t1311, t1314, t1318, t1321, t1322, t1323, t1325, t1326, t1329,
            t1330, t1332, t1333, t1335, t1339, t1341, t1342, t1346, t1348, t1352, t1353, t1357,
            t1358, t1363, t1365, t1367, t1372, t1374, t1376, t1378, t1380, t1383, t1384, t1385,
            t1386, t1388, t1389, t1395, t1399, t1404, t1405, t1406, t1410, t1412, t1415, t1417,
            t1421, t1422, t1428, t1431, t1435, t1450, t1455, t1457, t1462, t1466, t1468, t1470,
            t1473, t1477, t1478, t1480, t1485, t1488, t1489, t1495, t1497, t1498, t1500, t1502,
            t1504, t1509, t1514, t1517, t1518, t1520, t1523, t1527, t1533, t1535, t1537, t1538,
            t1539, t1541, t1543, t1548, t1551, t1554, t1556, t1562, t1570, t1572, t1575, t1578,
            t1584, t1586,
        );
        t798 = t790 + self.constants[3] * t755 + t314 * t747 - self.constants[2] * t763
            - t312 * t739;
        t801 = t323 * t735 - t321 * t731;
        t809 = t801 + self.constants[3] * t753 + self.constants[2] * t771 + t334 * t747
            - t332 * t739;
        t813 = t346 * t739 - t790 - t348 * t747;
        t817 = t358 * t747 - t801 - t356 * t739;
        t819 = self.constants[28] + t25 * self.constants[22];
        t820 = self.constants[0].like(1.0) / t819;
        t821 = t74 * t820;
        t822 = t101 * t821;
        t824 = speeds[1] * t820;
        t829 = t7 * t36 + t66 * t123;
        t836 = t123 * t487 + t493 * t829 + t101 * t502 - t36 * t473 - t118 * t497;
        t840 = t36 * t51 - t123 * t147;
        t841 = t820 * t840;
        t842 = speeds[2] * t841;
        t844 = t824 * t840;
        t848 = t36 * t510 - t123 * t512;
        t851 = t515 * t844 - t824 * t848;
        t855 = t123 * t520 - t16 * t36;
        t860 = t824 * t855 + t523 * t844 + t81 * t851;
        t864 = t51 * t118 - t101 * t147;
        t865 = t531 * t820;
        t868 = t542 * t820;
        t871 = speeds[2] * t865 + t539 * t824 + speeds[0] * t868;
        t875 = t118 * t510 - t101 * t512;
        t877 = t148 * t820;
        t879 = t141 * t824 + speeds[0] * t877;
        t883 = speeds[0] * t841;
        t886 = t532 * t842 + t540 * t844 + t543 * t883;
        t890 = t551 * t844 + t553 * t883;
        t892 = t13 * t123;
        t896 = t820 * t848;
        t899 = t515 * t883 - speeds[0] * t896;
        t909 = t824 * t892 + t557 * t844 + t104 * t851 + t53 * t899 + t575 * t879
            + t563 * t890;
        t911 = t909 - t123 * t871 - t36 * t886;
        t913 = t13 * t36;
        t926 = t570 * t844 + t144 * t851 + t36 * t871 + t575 * t890 - t824 * t913
            - t149 * t899;
        t928 = t926 - t563 * t879 - t123 * t886;
        t930 = t91 * self.constants[22];
        t938 = t820 * (t123 * t502 + t539 * t840 - t36 * t497 - t141 * t848);
        t939 = t820 * t938;
        t940 = speeds[1] * t939;
        t944 = t820 * (t74 * t123 + t531 * t840);
        t945 = t820 * t944;
        t950 = t820 * (t542 * t840 - t148 * t848);
        t951 = t820 * t950;
        t954 = t940 + speeds[2] * t945 + speeds[0] * t951;
        t960 = speeds[2] * t822 + t824 * t836 + t468 * t842 + t508 * t844 + t69 * t851
            + self.constants[24] * t860;
        t965 = t960 + t864 * t871 + t550 * t890 + t120 * t928 - t875 * t879
            - t530 * t886;
        t967 = t965 - t103 * t911 - t930 * t954;
        t969 = t177 * t821;
        t977 = t36 * t593 + t177 * t502 - t596 * t829 - t187 * t497;
        t985 = t51 * t187 - t147 * t177;
        t989 = t187 * t510 - t177 * t512;
        t995 = t170 * self.constants[22];
        t1001 = speeds[2] * t969 + t824 * t977 + t590 * t842 + t602 * t844 + t160 * t851
            + t871 * t985;
        t1006 = t1001 + t612 * t890 + t180 * t911 + t190 * t928 + t954 * t995
            - self.constants[23] * t860;
        t1008 = t1006 - t879 * t989 - t608 * t886;
        t1011 = t13 * t829;
        t1012 = t36 * t624 + t1011;
        t1019 = t66 * t911 - t7 * t928;
        t1023 = t824 * t1012 + t627 * t844 + t12 * t860 - t196 * t851 - t1019;
        t1027 = t36 * t638 - t16 * t829;
        t1038 = t824 * t1027 + t80 * t911 + t12 * t928 - t641 * t844 - t205 * t851
            - t7 * t860;
        t1040 = self.constants[2] * t1023 + self.constants[3] * t1038;
        t1042 = t157 * t1008 + t1040 - t58 * t967;
        t1046 = t824 * t1011 + t626 * t844 - t1019;
        t1048 = t223 * t829;
        t1055 = t824 * t1048 + t658 * t844 + t115 * t911 + t94 * t928;
        t1062 = t1040 + t230 * t1008 - self.constants[2] * t1046
            - self.constants[3] * t1055 - t228 * t967;
        t1073 = self.constants[26] * t1046 + t244 * t1055 + self.constants[23] * t1023
            + t290 * t1008 - self.constants[24] * t1038 - t287 * t967;
        t1074 = t123 * t820;
        t1081 = sin_phi * t575;
        t1090 = t879 * t1081 + t687 * t890 + t64 * t899 - t563 * t886 - t575 * t871;
        t1095 = speeds[2] * t1074 + t475 * t842 + self.constants[3] * t1023
            + t314 * t1008 + t1090 - self.constants[2] * t1038;
        t1096 = t1095 - t312 * t967;
        t1097 = t25 * t829;
        t1106 = t321 * t911 - t323 * t928;
        t1111 = t824 * t1097 + t698 * t844 + self.constants[2] * t1055 + t334 * t1008
            - t954 - self.constants[3] * t1046;
        t1113 = t1111 - t332 * t967 - t1106;
        t1114 = t343 * t1074;
        t1122 = t346 * t967 - t1090 - speeds[2] * t1114 - t712 * t842 - t348 * t1008;
        t1123 = t354 * t829;
        t1133 = t1106 + t824 * t1123 + t719 * t844 + t354 * t954 + t358 * t1008
            - t356 * t967;
        t1137 = sin_delta * self.constants[45];
        t1138 = sin_delta * t1137;
        t1142 = self.constants[35] + self.constants[40] + self.constants[47] - t1138;
        t1144 = cos_delta * self.constants[38];
        t1145 = self.constants[23] * t1144;
        t1148 = t1145 + t1145 + self.constants[50];
        t1151 = self.constants[36] + self.constants[43];
        t1152 = t1148 + t1151;
        t1153 = t1152 - t1142;
        t1154 = t7 * t7;
        t1156 = t7 * t12;
        t1158 = self.constants[24] * t1144;
        t1162 = cos_delta * self.constants[41];
        t1163 = self.constants[32] + t1162;
        t1166 = t1163 - self.constants[48] - t1158 - self.constants[49];
        t1167 = t1166 + t1166;
        t1169 = t1153 * t1154 + t1156 * t1167;
        t1170 = sin_phi * self.constants[21];
        t1171 = sin_delta * self.constants[38];
        t1172 = t1170 * t1171;
        t1174 = t1170 * self.constants[51];
        t1177 = t1170 * t1174 - t1172 - t1172;
        t1182 = t1144 + self.constants[30];
        t1183 = self.constants[46] + t1182;
        t1185 = t12 * self.constants[52] - t7 * t1183;
        t1186 = t74 * t1185;
        t1187 = t74 * self.constants[51];
        t1188 = t74 * t1187;
        t1190 = t1188 - t1186 - t1186;
        t1191 = sin_delta * self.constants[41];
        t1193 = t1191 - self.constants[24] * t1171;
        t1197 = cos_delta * t1137 - self.constants[23] * t1171;
        t1201 = t7 * self.constants[52] + t12 * t1183;
        t1204 = t7 * t1193 + t12 * t1197 + t1170 * t1201;
        t1206 = t148 - sin_phi * t542;
        t1213 = t1166 + t1153 * t1156 + t74 * t1201 - t1154 * t1167;
        t1214 = cos_phi * t542;
        t1222 = t1138 + self.constants[47] + t1148 + t1190 + self.constants[33]
            + self.constants[42];
        t1232 = t12 * t1193 + t1170 * t1185 + t74 * t1171 - t7 * t1197 - t74 * t1174;
        t1239 = t1152 + t1177 - t1169;
        t1245 = t1206 * self.constants[18];
        t1247 = t12 * sin_delta;
        t1249 = t7 * sin_delta;
        t1253 = t950 + cos_delta * t1206 - t1247 - t1214 * t1249;
        t1255 = t1253 * self.constants[19];
        t1262 = t1142 + t1169 + t1177 + t1190 + t1204 * t1206
            + t1206 * (t1204 + t1206 * t1222 - t1214 * t1232) + t1206 * t1245;
        t1265 = t1262 + t1253 * t1255 - t1213 * t1214
            - t1214 * (t1213 + t1206 * t1232 - t1214 * t1239);
        t1266 = self.constants[0].like(1.0) / t1265;
        t1271 = speeds[0] * t542 + speeds[1] * t539 + speeds[2] * t531;
        t1272 = sin_phi * t1271;
        t1273 = t301 - t1272;
        t1275 = cos_phi * t1271;
        t1277 = t12 * speeds[0] + t7 * t1275;
        t1278 = self.constants[32] * t1277;
        t1281 = t7 * speeds[0] - t12 * t1275;
        t1283 = t1278 + self.constants[36] * t1281;
        t1286 = speeds[2] + t1273;
        t1288 = self.constants[33] * t1273 + self.constants[18] * t1286;
        t1290 = t1273 * t1283 - t1281 * t1288;
        t1292 = self.constants[25] * t1272;
        t1293 = t1275 * t1292;
        t1295 = sin_phi * self.constants[44];
        t1296 = t302 * t1275;
        t1299 = t1293 - t74 * t1296;
        t1300 = t1295 + t1299;
        t1302 = t301 * t1281;
        t1303 = speeds[0] * t1272;
        t1304 = self.constants[24] * t1273;
        t1306 = self.constants[23] * t1273;
        t1308 = t1281 * t1304 + t1277 * t1306;
        t1310 = t301 * t1277;
        t1311 = t12 * t1303 + t1310;
        t1314 = t1302 + t7 * t1303;
        t1318 = t1308 + self.constants[23] * t1311 + self.constants[24] * t1314 - t1299;
        t1321 = self.constants[23] * t1281;
        t1322 = self.constants[24] * t1277;
        t1323 = t1321 - t1322;
        t1325 = t1273 * t1306 + t1281 * t1323;
        t1326 = speeds[0] * t1275;
        t1329 = speeds[0] * t302;
        t1330 = t1303 + t1329;
        t1332 = self.constants[25] * speeds[0];
        t1333 = t1275 * t1332;
        t1335 = t74 * t1326 + t1170 * t1330 + t1333;
        t1339 = t302 - t1272;
        t1341 = t1292 * t1339 - speeds[0] * t1332;
        t1342 = t1170 * t1296 + t1341;
        t1346 = t12 * t1335 + t7 * t1342 - t1325 - self.constants[24] * t1326;
        t1348 = speeds[1] + t1281;
        t1352 = cos_delta * t1273 - sin_delta * t1277;
        t1353 = self.constants[27] * t1352;
        t1357 = cos_delta * t1277 + sin_delta * t1273;
        t1358 = self.constants[26] * t1352;
        t1363 = speeds[1] * t1352;
        t1365 = t1363 - cos_delta * t1314 - sin_delta * t1326;
        t1367 = t30 * t819;
        t1372 = speeds[0] * t950 + speeds[1] * t938 + speeds[2] * t944;
        t1374 = t1311 + t1357 * t1372;
        t1376 = t27 * t819;
        t1378 = t1365 - t1348 * t1372;
        t1380 = t26 * t39;
        t1383 = t30 * t1357 + t27 * t1348;
        t1384 = t1380 * t1383;
        t1385 = t27 * t1384;
        t1386 = self.constants[28] * t1385;
        t1388 = t30 * t1384;
        t1389 = self.constants[28] * t1388;
        t1395 = cos_delta * t1318 + t1348 * t1353 + t1357 * t1358
            + self.constants[26] * t1311 + t1367 * t1374 + t1348 * t1386;
        t1399 = t1395 + t1357 * t1389 - sin_delta * t1346 - self.constants[27] * t1365
            - t1376 * t1378;
        t1404 = self.constants[26] * t1348;
        t1405 = self.constants[27] * t1357;
        t1406 = t1404 - t1405;
        t1410 = speeds[1] * t1357;
        t1412 = sin_delta * t1314 - cos_delta * t1326 - t1410;
        t1415 = t39 * self.constants[22];
        t1417 = t1352 + t1372;
        t1421 = t30 * t1348 - t27 * t1357;
        t1422 = self.constants[28] * t1421;
        t1428 = cos_delta * t1346 + sin_delta * t1318 + self.constants[27] * t1412
            + t1376 * t1412 - t1352 * t1358 - t1348 * t1406;
        t1431 = t1428 - t1374 * t1415 - t1389 * t1417 - t1348 * t1422;
        t1435 = t1277 * t1323 - t1273 * t1304;
        t1450 = t1435 + self.constants[23] * t1326 + t7 * t1335 + t1357 * t1406
            + t1378 * t1415 + t1357 * t1422;
        t1455 = t1450 - t12 * t1342 - t1352 * t1353 - self.constants[26] * t1412
            - t1367 * t1412 - t1386 * t1417;
        t1457 = t30 * t1431 + t27 * t1455;
        t1462 = t53 * (t39 * t1399 + t25 * t1457);
        t1466 = t466 * (t25 * t1399 + t514 * t1462 - t39 * t1457);
        t1468 = t1303 - cos_phi * t1466;
        t1470 = t1302 + t7 * t1468;
        t1473 = t1310 + t12 * t1468;
        t1477 = self.constants[32] * t1281;
        t1478 = self.constants[35] * t1277 + t1477;
        t1480 = t1277 * t1288 - t1273 * t1478;
        t1485 = t1308 + self.constants[23] * t1473 + self.constants[24] * t1470 - t1300;
        t1488 = t1326 - t1462;
        t1489 = sin_phi * t1466 + t1488;
        t1495 = t74 * t1489 + t1333 + t1170 * (t1329 + t1468);
        t1497 = cos_phi * self.constants[44];
        t1498 = t1342 + t1497;
        t1500 = t7 * t1498 + t12 * t1495;
        t1502 = t1500 - self.constants[24] * t1489 - t1325;
        t1504 = cos_delta * t1485 - sin_delta * t1502;
        t1509 = t1363 - sin_delta * t1489 - cos_delta * t1470;
        t1514 = self.constants[42] * t1352 + self.constants[19] * t1417;
        t1517 = self.constants[41] * t1348;
        t1518 = self.constants[40] * t1357 + t1517;
        t1520 = t1357 * t1514 - t1352 * t1518;
        t1523 = self.constants[38] * t1504 + self.constants[41] * t1509
            + self.constants[43] * t1473 + t1520;
        t1527 = cos_delta * t1502 + sin_delta * t1485;
        t1533 = sin_delta * t1470 - cos_delta * t1489 - t1410;
        t1535 = self.constants[38] * t1352;
        t1537 = self.constants[38] * t1348;
        t1538 = t1357 * self.constants[39];
        t1539 = t1537 - t1538;
        t1541 = t1352 * t1535 + t1348 * t1539;
        t1543 = self.constants[37] * t1527 + self.constants[39] * t1533 - t1541;
        t1548 = t1352 * self.constants[39];
        t1551 = t1348 * t1548 + t1357 * t1535;
        t1554 = t1504 * self.constants[37] + self.constants[38] * t1473 + t1551
            - t1509 * self.constants[39];
        t1556 = sin_delta * t1543 + cos_delta * t1554;
        t1562 = self.constants[36] * t1473 + t1480 + t1523 + self.constants[23] * t1556
            - self.constants[30] * t1300 - self.constants[32] * t1470;
        t1570 = self.constants[41] * t1357;
        t1572 = t1570 + self.constants[43] * t1348;
        t1575 = t1352 * t1572 - t1348 * t1514;
        t1578 = self.constants[40] * t1509 + self.constants[41] * t1473 + t1575
            - t1504 * self.constants[39];
        t1584 = t12 * t1498 - t7 * t1495;
        t1586 = t1435 + self.constants[23] * t1489 - t1584;
        let (
            t1596, t1598, t1601, t1605, t1612, t1613, t1618, t1619, t1620, t1622, t1624, t1629,
            t1631, t1634, t1638, t1641, t1644, t1647, t1656, t1661, t1667, t1675, t1677, t1682,
            t1685, t1691, t1696, t1700, t1702, t1704, t1706, t1710, t1712, t1714, t1715, t1716,
            t1720, t1726, t1730, t1736, t1742, t1747, t1752, t1754, t1756, t1762, t1764, t1765,
            t1775, t1778, t1779, t1781, t1784, t1787, t1791, t1795, t1800, t1812, t1813, t1819,
            t1822, t1832, t1839, t1849, t1853, t1854, t1856, t1860, t1861, t1864, t1872, t1874,
            t1877, t1882, t1888, t1895, t1897, t1899, t1902, t1906, t1908, t1910, t1912, t1917,
            t1919, t1923, t1927, t1932, t1934, t1939, t1947, t1948, t1952, t1957, t1964, t1966,
            t1972, t1973, t1979, t1982, t1996, t1998, t2004, t2007, t2010, t2012, t2013, t2015,
            t2017, t2018, t2020, t2021, t2023, t2026, t2029, t2031, t2034, t2036, t2038, t2040,
            t2043, t2047, t2049, t2052, t2054, t2058, t2060, t2067, t2068, t2070, t2073, t2078,
            t2086, t2087, t2093, t2096, t2098, t2101, t2106, t2110, t2113, t2121, t2128, t2137,
            t2143, t2144, t2151, t2154, t2156, t2159, t2166, t2169, t2171, t2175, t2181, t2187,
            t2188, t2192, t2193, t2195, t2200, t2201, t2203, t2205, t2207, t2211, t2221, t2225,
            t2231, t2233, t2235, t2236, t2238, t2241, t2244, t2246, t2248, t2254, t2256, t2257,
            t2259, t2261, t2262, t2263, t2265, t2268, t2270, t2272, t2275, t2278, t2280, t2281,
            t2286, t2290, t2294, t2295, t2296, t2299, t2302, t2304, t2308, t2311, t2315, t2317,
            t2319, t2322, t2325, t2327, t2328, t2330, t2332, t2335, t2336, t2337, t2339, t2340,
            t2341, t2342, t2344, t2347, t2350, t2352, t2356, t2359, t2361, t2364, t2366, t2368,
            t2370, t2371, t2374, t2376, t2380, t2381, t2384, t2388, t2396, t2398, t2400, t2402,
            t2404, t2405, t2406, t2409, t2412, t2414, t2417, t2419, t2421, t2425,
        );
        t1596 = t820 * (t30 * t1455 + t840 * t1466 - t27 * t1431 - t848 * t1462);
        t1598 = self.constants[19] * (t1533 + t1596);
        t1601 = t1348 * t1518 - t1357 * t1572;
        t1605 = t1527 * self.constants[39] + self.constants[42] * t1533 + t1598 + t1601
            - self.constants[38] * t1586;
        t1612 = t1290 + self.constants[31] * t1300 + self.constants[32] * t1473
            + cos_delta * t1578 - self.constants[35] * t1470 - sin_delta * t1605;
        t1613 = t1612 - self.constants[24] * t1556;
        t1618 = self.constants[30] * t1281;
        t1619 = t1277 * self.constants[31];
        t1620 = t1618 - t1619;
        t1622 = t1273 * self.constants[31];
        t1624 = t1277 * t1620 - t1273 * t1622;
        t1629 = t1357 * t1539 - t1352 * t1548;
        t1631 = self.constants[37] * t1586 + t1629 - self.constants[38] * t1533;
        t1634 = t1624 + t1631 - t1584 * self.constants[34] + self.constants[30] * t1489;
        t1638 = self.constants[30] * t1273;
        t1641 = t1273 * t1638 + t1281 * t1620;
        t1644 = cos_delta * t1543 - sin_delta * t1554;
        t1647 = t1500 * self.constants[34] - self.constants[31] * t1489 + t1644 - t1641;
        t1656 = t1281 * t1622 + t1277 * t1638;
        t1661 = t74
            * (t1556 + self.constants[30] * t1473 + self.constants[31] * t1470 + t1656
                - t1300 * self.constants[34]);
        t1667 = t1281 * t1478 - t1277 * t1283;
        t1675 = t7 * t1634 + t12 * t1647;
        t1677 = self.constants[18] * t1489 + t74 * t1675;
        t1682 = self.constants[31] * t1500 + self.constants[30] * t1584
            - self.constants[33] * t1489 + t1667 + sin_delta * t1578 + cos_delta * t1605;
        t1685 = t1682 + self.constants[24] * t1644 - t1677 - self.constants[23] * t1631;
        t1691 = t12 * t1562 + t1170 * t1675 - t7 * t1613;
        t1696 = forces[0] + t1170 * (t12 * t1634 - t7 * t1647) + t1214 * t1691
            - t7 * t1562;
        t1700 = t1696 - t12 * t1613 - t1661 - t1206 * t1685 - t950 * t1598;
        t1702 = t1145 + self.constants[43];
        t1704 = t1162 - t1158;
        t1706 = t7 * t1171;
        t1710 = t141 - sin_phi * t539;
        t1712 = cos_phi * t539;
        t1714 = t12 * t1171;
        t1715 = t74 * t1714;
        t1716 = t1193 + t1715;
        t1720 = t1716 + t1222 * t1710 - t1232 * t1712;
        t1726 = t12 * t1702 - t7 * t1704 - t1170 * t1714;
        t1730 = t1726 + t1232 * t1710 - t1239 * t1712;
        t1736 = t1249 * t1712 - t938 - cos_delta * t1710;
        t1742 = t7 * t1702 + t12 * t1704 + t74 * t1144 + t1204 * t1710 + t1206 * t1720
            + t1245 * t1710;
        t1747 = t1266
            * (t1742 - t1170 * t1706 - t1213 * t1712 - t1214 * t1730 - t1255 * t1736);
        t1752 = self.constants[18] * t1710;
        t1754 = self.constants[19] * t1736;
        t1756 = t1265 * t1747;
        t1762 = self.constants[43] + t1710 * t1720 + t1710 * t1716 + t1710 * t1752
            + t1736 * t1754 - t1712 * t1730;
        t1764 = t1762 - t1712 * t1726 - t1747 * t1756;
        t1765 = self.constants[0].like(1.0) / t1764;
        t1775 = forces[1] + t1691 * t1712 - t1523 - t1685 * t1710 - t938 * t1598
            - t1700 * t1747;
        t1778 = t74 * (t1185 - t1187);
        t1779 = sin_phi * t531;
        t1781 = cos_phi * t531;
        t1784 = t1778 + t1222 * t1779 + t1232 * t1781;
        t1787 = t74 * (t1171 - t1174);
        t1791 = t1787 - t1232 * t1779 - t1239 * t1781;
        t1795 = self.constants[0].like(1.0) - t1779;
        t1800 = t1249 * t1781 + cos_delta * t1779 - t944;
        t1812 = t1245 * t1795 - t1204 * t1779 - t1213 * t1781 - t1206 * t1784
            - t1214 * t1791 - t1255 * t1800;
        t1813 = t1266 * t1812;
        t1819 = t1715 + t1752 * t1795 + t1754 * t1800 - t1710 * t1784 - t1712 * t1791
            - t1716 * t1779;
        t1822 = t1765 * (t1819 - t1726 * t1781 - t1756 * t1813);
        t1832 = t1685 * t1779 + t1691 * t1781 + t1677 - t944 * t1598 - t1700 * t1813
            - t1775 * t1822;
        t1839 = self.constants[19] * t1800;
        t1849 = t1188 + t1779 * t1784 + t1778 * t1779
            + self.constants[18] * t1795 * t1795 + t1800 * t1839 - t1781 * t1791;
        t1853 = self.constants[0].like(1.0)
            / (t1849 - t1781 * t1787 - t1265 * t1813 * t1813 - t1764 * t1822 * t1822);
        t1854 = t1832 * t1853;
        t1856 = t1765 * t1775 - t1822 * t1854;
        t1860 = t1266 * t1700 - t1747 * t1856 - t1813 * t1854;
        t1861 = t1296 + t1860;
        t1864 = t1293 + t1295 - t74 * t1861;
        t1872 = t1466 + t542 * t1860 + t539 * t1856 + t531 * t1854;
        t1874 = t1303 - cos_phi * t1872;
        t1877 = t12 * t1860 - t1302 - t7 * t1874;
        t1882 = t1310 + t12 * t1874 + t7 * t1860;
        t1888 = t1308 + self.constants[23] * t1882 - t1864 - self.constants[24] * t1877;
        t1895 = t148 * t1860 + t141 * t1856 - sin_phi * t1872 - t1488;
        t1897 = t1854 + t1895;
        t1899 = t1329 + t1874;
        t1902 = t74 * t1897 - t1333 - t1170 * t1899;
        t1906 = t1341 + t1497 + t1170 * t1861;
        t1908 = t7 * t1906 - t12 * t1902;
        t1910 = self.constants[24] * t1895 + t1908 - t1325;
        t1912 = cos_delta * t1888 - sin_delta * t1910;
        t1917 = t1363 + cos_delta * t1877 + sin_delta * t1895;
        t1919 = t1856 + t1882;
        t1923 = t1575 + self.constants[40] * t1917 + self.constants[41] * t1919
            - self.constants[39] * t1912;
        t1927 = cos_delta * t1910 + sin_delta * t1888;
        t1932 = t12 * t1906 + t7 * t1902;
        t1934 = t1435 - self.constants[23] * t1895 - t1932;
        t1939 = cos_delta * t1895 - t1410 - sin_delta * t1877;
        t1947 = t1596 + t1939 + t950 * t1860 + t938 * t1856 + t944 * t1854;
        t1948 = self.constants[19] * t1947;
        t1952 = t1601 + self.constants[39] * t1927 + self.constants[42] * t1939 + t1948
            - self.constants[38] * t1934;
        t1957 = self.constants[37] * t1927 + self.constants[39] * t1939 - t1541;
        t1964 = t1551 + self.constants[37] * t1912 + self.constants[38] * t1919
            - self.constants[39] * t1917;
        t1966 = sin_delta * t1957 + cos_delta * t1964;
        t1972 = t1290 + self.constants[31] * t1864 + self.constants[35] * t1877
            + self.constants[32] * t1882 + cos_delta * t1923 - sin_delta * t1952;
        t1973 = t1972 - self.constants[24] * t1966;
        t1979 = t1629 + self.constants[37] * t1934 - self.constants[38] * t1939;
        t1982 = t1624 + t1979 - self.constants[34] * t1932 - self.constants[30] * t1895;
        t1996 = t1480 + t1520 + self.constants[32] * t1877 + self.constants[36] * t1882
            + self.constants[38] * t1912 + self.constants[41] * t1917
            + self.constants[43] * t1919;
        t1998 = t1996 + self.constants[23] * t1966 - self.constants[30] * t1864;
        t2004 = cos_delta * t1957 - sin_delta * t1964;
        t2007 = self.constants[34] * t1908 + self.constants[31] * t1895 + t2004 - t1641;
        t2010 = t1170 * t1214 + t74 * t1206;
        t2012 = t820 * self.constants[19];
        t2013 = t1455 * t2012;
        t2015 = t1431 * t2012;
        t2017 = t840 * t2012;
        t2018 = t466 * t1399;
        t2020 = t39 * t466;
        t2021 = t1431 * t2020;
        t2023 = t1455 * t2020;
        t2026 = t91 * t2018 + t92 * t2021 - t98 * t2023;
        t2029 = t2017 * t2026 - t92 * t2013 - t98 * t2015;
        t2031 = t7 * t1170;
        t2034 = t12 * self.constants[34];
        t2036 = cos_delta * self.constants[39];
        t2038 = sin_delta * self.constants[39];
        t2040 = cos_delta * t2038 - sin_delta * t2036;
        t2043 = t1714 + t7 * t2040;
        t2047 = sin_delta * t2038 + cos_delta * t2036;
        t2049 = sin_delta * self.constants[37];
        t2052 = cos_delta * self.constants[23];
        t2054 = cos_delta * self.constants[24];
        t2058 = t12 * t2052 + t7 * t2054;
        t2060 = sin_delta * self.constants[24];
        t2067 = sin_delta * t2031 + t12 * t2054 + t1214 * t2058 + t1206 * t2060
            - cos_delta * t74 - t7 * t2052;
        t2068 = t2067 - t1247 * t2010;
        t2070 = cos_delta * self.constants[37];
        t2073 = sin_delta * self.constants[23];
        t2078 = t12 * t2073 + t7 * t2060;
        t2086 = t12 * t2060 + t1214 * t2078 + t94 * t2010 - sin_delta * t74
            - cos_delta * t2031 - t7 * t2073;
        t2087 = t2086 - t1206 * t2054;
        t2093 = t1706 + t2070 * t2087 - t12 * t2040 - t1214 * t2043 - t1206 * t2047
            - t2049 * t2068;
        t2096 = t2010 * t2034 + t2093 - self.constants[34] * t2031
            - t1206 * self.constants[31];
        t2098 = t12 * t1170;
        t2101 = t7 * self.constants[34];
        t2106 = t2098 + self.constants[23] * t1206 + t7 * t2010;
        t2110 = self.constants[37] * t2106 - t1714 - t1214 * t1706;
        t2113 = self.constants[34] * t2098 + t1182 * t1206 + t2010 * t2101 + t2110;
        t2121 = t12 * t1151 - t7 * t1163;
        t2128 = t12 * t1144 + t7 * t2047;
        t2137 = t12 * t2047 + t1214 * t2128 + t2068 * t2070 + t2049 * t2087 - t7 * t1144
            - t1206 * t2040;
        t2143 = t1214 * t2121 + self.constants[38] * t2068 + self.constants[23] * t2137
            - t74 * self.constants[30] - t7 * t1151 - t12 * t1163;
        t2144 = t2143 - t1191 * t1206;
        t2151 = t12 * self.constants[32] - t7 * self.constants[35];
        t2154 = sin_delta * self.constants[42];
        t2156 = cos_delta * self.constants[42];
        t2159 = t7 * t2154;
        t2166 = t12 * t2154 + t1214 * t2159 + self.constants[39] * t2087 - t1255
            - t1206 * t2156 - self.constants[38] * t2106;
        t2169 = cos_delta * self.constants[40];
        t2171 = sin_delta * self.constants[40];
        t2175 = t12 * self.constants[41] - t7 * t2169;
        t2181 = t1214 * t2175 - t7 * self.constants[41] - t12 * t2169 - t1206 * t2171
            - self.constants[39] * t2068;
        t2187 = t74 * self.constants[31] + t1214 * t2151 + cos_delta * t2181
            - t7 * self.constants[32] - t12 * self.constants[35]
            - self.constants[24] * t2137;
        t2188 = t2187 - sin_delta * t2166;
        t2192 = cos_phi * t1170 - sin_phi * t74;
        t2193 = t12 * t2192;
        t2195 = t7 * t2192;
        t2200 = self.constants[23] * self.constants[38];
        t2201 = sin_delta * t2200;
        t2203 = t7 * t2201;
        t2205 = self.constants[33] + self.constants[18];
        t2207 = t2205 + cos_delta * t2200;
        t2211 = t12 * self.constants[31] - t7 * self.constants[30];
        t2221 = t12 * t2201 + t1214 * t2203 + t2010 * t2211 + self.constants[24] * t2093
            + cos_delta * t2166 + sin_delta * t2181;
        t2225 = t2221 - self.constants[31] * t2031 - self.constants[30] * t2098
            - t1206 * t2207 - self.constants[46] * t2106;
        t2231 = t16 * t2188 - t2096 * t2193 - t2113 * t2195 - t13 * t2144
            - sin_phi * t2225;
        t2233 = t53 * t1457;
        t2235 = t25 * t53;
        t2236 = t1431 * t2235;
        t2238 = t1455 * t2235;
        t2241 = t91 * t2233 + t98 * t2238 - t92 * t2236;
        t2244 = t515 * t2017 - t848 * t2012;
        t2246 = t7 * t74;
        t2248 = t12 * t74;
        t2254 = t2225 + t515 * t2231 - t1253 * t2244 - t2113 * t2246 - t2096 * t2248;
        t2256 = t819 * t1412;
        t2257 = self.constants[28] * t1348;
        t2259 = t1357 * t2257 - t2256;
        t2261 = self.constants[28] * t1384;
        t2262 = t1417 * t2261;
        t2263 = self.constants[28] * t1357;
        t2265 = t2262 + t1357 * t2263;
        t2268 = t1342 + t92 * t2259 + t98 * t2265;
        t2270 = t27 * t2020;
        t2272 = t30 * t2012 - t2017 * t2270;
        t2275 = t27 * t2235;
        t2278 = t2254 * t2275 - t1253 * t2272 - t2231 * t2270;
        t2280 = self.constants[26] + t1367;
        t2281 = t2052 + t2280;
        t2286 = t819 * t1374 + t1357 * t2261;
        t2290 = t1348 * t2261 - t819 * t1378;
        t2294 = t1303 * t2281 + t98 * t2290 - sin_delta * t1335 - t92 * t2286;
        t2295 = t25 * t466;
        t2296 = t2017 * t2295;
        t2299 = t39 * t53;
        t2302 = t2231 * t2295 + t2254 * t2299 - t1253 * t2296;
        t2304 = t2073 - t1415;
        t2308 = t2262 + t1348 * t2257;
        t2311 = t2256 + t1348 * t2263;
        t2315 = t1303 * t2304 + cos_delta * t1335 + t92 * t2308 + t98 * t2311;
        t2317 = t30 * t2020;
        t2319 = t27 * t2012 + t2017 * t2317;
        t2322 = t30 * t2235;
        t2325 = t1253 * t2319 + t2254 * t2322 - t2231 * t2317;
        t2327 = t26 * t1383;
        t2328 = t1380 * t2327;
        t2330 = t1357 * t1380;
        t2332 = t1348 * t1380;
        t2335 = t98 * t2332 - t91 * t2328 - t92 * t2330;
        t2336 = t27 * self.constants[28];
        t2337 = t1417 * t2336;
        t2339 = t1348 * t2336;
        t2340 = t30 * self.constants[28];
        t2341 = t1357 * t2340;
        t2342 = t2339 + t2341;
        t2344 = t1417 * t2340;
        t2347 = t2302 * t2342 - t2278 * t2337 - t2325 * t2344;
        t2350 = t1281 * self.constants[31];
        t2352 = t1620 - t1619;
        t2356 = t12 * t2350 + t7 * t2352;
        t2359 = self.constants[42] + self.constants[19];
        t2361 = t1357 * t2359 - t1518;
        t2364 = t1514 - self.constants[40] * t1352;
        t2366 = cos_delta * t2364 - sin_delta * t2361;
        t2368 = t1288 + t2366 - self.constants[35] * t1273;
        t2370 = self.constants[32] * t1273;
        t2371 = self.constants[41] * t1352;
        t2374 = t1572 - t1348 * t2359;
        t2376 = cos_delta * t2371 - sin_delta * t2374;
        t2380 = self.constants[40] * t1348 - t1570 - t1572;
        t2381 = cos_delta * t2380;
        t2384 = t2370 + cos_delta * t2376 - sin_delta * t2381;
        t2388 = t12 * t2368 - t7 * t2384;
        t2396 = self.constants[35] * t1281 + sin_delta * t2376 + cos_delta * t2381
            - t1278 - t1283;
        t2398 = t1548 + t1548;
        t2400 = t1539 - t1538;
        t2402 = sin_delta * t2398 + cos_delta * t2400;
        t2404 = t1348 * self.constants[39];
        t2405 = self.constants[38] * t1357;
        t2406 = t2404 + t2405;
        t2409 = cos_delta * t1535 - sin_delta * t2406;
        t2412 = t1535 + t1535;
        t2414 = cos_delta * t2404 + sin_delta * t2412;
        t2417 = self.constants[24] * t1281;
        t2419 = cos_delta * speeds[1];
        t2421 = sin_delta * speeds[1];
        t2425 = t1353 + t1386;
        let (
            t2427, t2431, t2434, t2436, t2441, t2442, t2447, t2450, t2451, t2456, t2461, t2463,
            t2464, t2468, t2473, t2475, t2476, t2478, t2481, t2487, t2492, t2497, t2502, t2505,
            t2507, t2509, t2513, t2518, t2522, t2526, t2530, t2538, t2541, t2544, t2548, t2555,
            t2563, t2565, t2567, t2571, t2576, t2579, t2582, t2588, t2593, t2598, t2602, t2604,
            t2606, t2608, t2609, t2613, t2615, t2618, t2622, t2625, t2631, t2632, t2634, t2636,
            t2637, t2640, t2645, t2648, t2650, t2653, t2656, t2658, t2662, t2668, t2672, t2676,
            t2678, t2681, t2684, t2686, t2690, t2697, t2702, t2710, t2715, t2717, t2721, t2726,
            t2728, t2733, t2735, t2739, t2743, t2747, t2751, t2755, t2759, t2761, t2763, t2769,
            t2777, t2785, t2787, t2789, t2795, t2800, t2804, t2809, t2817, t2822, t2824, t2828,
            t2834, t2836, t2838, t2841, t2843, t2845, t2850, t2851, t2852, t2854, t2855, t2857,
            t2860, t2867, t2868, t2874, t2875, t2885, t2890, t2892, t2898, t2900, t2904, t2908,
            t2912, t2914, t2919, t2921, t2922, t2937, t2943, t2947, t2955, t2961, t2966, t2968,
            t2969, t2976, t2981, t2984, t2987, t2988, t2990, t2992, t2995, t2998, t3000, t3010,
            t3015, t3018, t3028, t3030, t3032, t3046, t3049, t3053, t3055, t3059, t3061, t3070,
            t3071, t3077, t3082, t3087, t3092, t3098, t3101, t3115, t3118, t3132, t3134, t3140,
            t3146, t3154, t3162, t3184, t3189, t3194, t3199, t3204, t3209, t3211, t3212, t3213,
            t3215, t3217, t3220, t3222, t3224, t3225, t3227, t3228, t3229, t3232, t3235, t3239,
            t3241, t3253, t3258, t3263, t3264, t3268, t3272, t3273, t3274, t3275, t3276, t3277,
            t3278, t3280, t3282, t3284, t3286, t3288, t3292, t3296, t3297, t3298, t3300, t3302,
            t3303, t3304, t3306, t3310, t3314, t3318, t3321, t3322, t3323, t3326, t3329, t3330,
            t3334, t3338, t3340, t3344, t3346, t3347, t3350, t3356, t3360, t3362,
        );
        t2427 = speeds[1] * t1415 - t1353 - t2425;
        t2431 = t1406 + t1422;
        t2434 = speeds[1] * t2280 + t2431 - t1405 - t1357 * t2336;
        t2436 = cos_delta * t2434 - sin_delta * t2427;
        t2441 = t1348 * self.constants[27];
        t2442 = self.constants[26] * t1357;
        t2447 = t2441 + t2442 - speeds[1] * self.constants[27] - speeds[1] * t1376;
        t2450 = t1358 + t1389;
        t2451 = t1367 * t1372 + t2450;
        t2456 = cos_delta * t1306 + t301 * t2281 + cos_delta * t2451 - sin_delta * t2417
            - sin_delta * t2447;
        t2461 = t1358 + t2450;
        t2463 = t1372 * t1415;
        t2464 = self.constants[27] + t1376;
        t2468 = t2339 + t2441 - t2463 - speeds[1] * t2464;
        t2473 = sin_delta * t1306 + t301 * t2304 + cos_delta * t2417 + sin_delta * t2461
            + cos_delta * t2468;
        t2475 = t30 * t1380;
        t2476 = cos_delta * t2475;
        t2478 = t1323 - t1322;
        t2481 = t2110 + t2278 + t1144 * t1206;
        t2487 = t2098 * t2352 + t2010 * t2356 + t1214 * t2388 + t2106 * t2402
            + t2068 * t2409 + t2087 * t2414;
        t2492 = t2487 + t1306 * t2137 + t2093 * t2417 + t301 * t2144 + t2278 * t2436
            + t2302 * t2456;
        t2497 = t2492 + t2325 * t2473 + t2347 * t2476 + t2478 * t2481 - t74 * t1638
            - t2031 * t2350;
        t2502 = t2497 - t7 * t2368 - t12 * t2384 - t1206 * t2396 - t2166 * t2419
            - t2181 * t2421;
        t2505 = t1618 + t1620;
        t2507 = self.constants[30] * t1277;
        t2509 = t2370 + t2371;
        t2513 = t7 * t2507 - t12 * t2505;
        t2518 = self.constants[43] * t1352 - t1514;
        t2522 = t1517 + t1518 - self.constants[43] * t1357;
        t2526 = self.constants[36] * t1273 + cos_delta * t2518 - t1288
            - sin_delta * t2522;
        t2530 = t12 * t2509 + t7 * t2526;
        t2538 = t1477 + t1478 + sin_delta * t2518 + cos_delta * t2522
            - self.constants[36] * t1277;
        t2541 = t1537 + t1539;
        t2544 = t1321 + t1323;
        t2548 = t2341 + t2442 - t2463;
        t2555 = t2425 + cos_delta * t1304 + t1372 * t1376 + sin_delta * t2544;
        t2563 = sin_delta * t1304 - t1404 - t2431 - cos_delta * t2544 - t1348 * t2340;
        t2565 = t27 * t1380;
        t2567 = self.constants[23] * t1277;
        t2571 = cos_delta * t1415 + sin_delta * t2280;
        t2576 = t2054 + cos_delta * self.constants[27] + cos_delta * t1376;
        t2579 = t2060 + sin_delta * t2464;
        t2582 = t2302 * t2576 + t2325 * t2579 - t2278 * t2571;
        t2588 = t2031 * t2505 + t2098 * t2507 + t7 * t2509 + t2010 * t2513
            + t2106 * t2405 + t1548 * t2068;
        t2593 = t2588 + t1304 * t2137 + t2278 * t2548 + t2302 * t2555 + t2325 * t2563
            + t2347 * t2565;
        t2598 = t2593 + t2481 * t2567 + t301 * t2582 - t74 * t1622 - t12 * t2526
            - t1214 * t2530;
        t2602 = t2598 - t1206 * t2538 - t2087 * t2541 - t2093 * t2544 - t301 * t2188;
        t2604 = self.constants[19] * t1854;
        t2606 = self.constants[19] * t1357;
        t2608 = self.constants[19] * t1348;
        t2609 = cos_delta * t2608;
        t2613 = t12 * t2606 + t7 * t2609;
        t2615 = sin_delta * t2608;
        t2618 = t1386 + t1348 * t1415;
        t2622 = t1348 * t1376 + t1357 * t1367;
        t2625 = t1389 + t1357 * t1415;
        t2631 = t12 * t2609 + t1214 * t2613 + t1206 * t2615 + t2302 * t2622 - t7 * t2606
            - t2278 * t2618;
        t2632 = t2631 - t2325 * t2625;
        t2634 = speeds[2] * t2632 - t1253 * t2604;
        t2636 = self.constants[19] * t1856;
        t2637 = t820 * t2636;
        t2640 = t824 * t2632 - t1253 * t2637;
        t2645 = cos_phi * t302;
        t2648 = t146 * t1339 + t1170 * t2645 - sin_phi * t1292;
        t2650 = sin_phi * speeds[0];
        t2653 = cos_phi * speeds[0];
        t2656 = t1170 * t2650 + cos_phi * t1332 + t74 * t2653;
        t2658 = t7 * t2648 + t12 * t2656;
        t2662 = t12 * t2648 - t7 * t2656;
        t2668 = t74 * t2645 - t146 * t1275 - cos_phi * t1292;
        t2672 = t12 * self.constants[30] + t7 * self.constants[31];
        t2676 = t74 * self.constants[34] - t2137 - t2211 - t1214 * t2672;
        t2678 = t12 * t2650;
        t2681 = t7 * t2650;
        t2684 = sin_delta * t2653;
        t2686 = cos_delta * t2653;
        t2690 = self.constants[23] * t2653 + t2280 * t2686 - t2662 - t1415 * t2684;
        t2697 = t2658 - self.constants[24] * t2653;
        t2702 = self.constants[27] * t2684 + t1376 * t2684 + cos_delta * t2668
            + t2281 * t2678 - sin_delta * t2697;
        t2710 = sin_delta * t2668 + t2304 * t2678 + cos_delta * t2697 - t2464 * t2686;
        t2715 = t1638 + t1638;
        t2717 = t1622 + t1622;
        t2721 = t12 * t2715 + t7 * t2717;
        t2726 = cos_delta * t2361 + sin_delta * t2364;
        t2728 = t1277 * t2205 + t2726 - t1478;
        t2733 = sin_delta * t2371 + cos_delta * t2374;
        t2735 = sin_delta * t2380;
        t2739 = t1283 + cos_delta * t2733 - t1281 * t2205 - sin_delta * t2735;
        t2743 = t12 * t2728 - t7 * t2739;
        t2747 = sin_delta * t2733 + cos_delta * t2735;
        t2751 = sin_delta * t2400 - cos_delta * t2398;
        t2755 = sin_delta * t1535 + cos_delta * t2406;
        t2759 = sin_delta * t2404 - cos_delta * t2412;
        t2761 = t2417 + t2567;
        t2763 = t1306 + t1306;
        t2769 = cos_delta * t2427 + sin_delta * t2434;
        t2777 = cos_delta * t2761 + sin_delta * t2763 + cos_delta * t2447
            + sin_delta * t2451;
        t2785 = sin_delta * t2761 + sin_delta * t2468 - cos_delta * t2763
            - cos_delta * t2461;
        t2787 = sin_delta * t2475;
        t2789 = t1304 + t1304;
        t2795 = t2031 * t2715 + t1214 * t2743 + t2106 * t2751 + t2068 * t2755
            + t2087 * t2759 + t2137 * t2761;
        t2800 = t2795 + t2181 * t2419 + t2278 * t2769 + t2302 * t2777 + t2325 * t2785
            + t2347 * t2787;
        t2804 = t2800 - t74 * (t2350 + t2507) - t2098 * t2717 - t2010 * t2721
            - t7 * t2728;
        t2809 = t2804 - t12 * t2739 - t1206 * t2747 - t2093 * t2763 - t2166 * t2421
            - t2481 * t2789;
        t2817 = t2096 * t2658 + t2144 * t2678 + t2278 * t2690 + t2302 * t2702
            + t2325 * t2710 + t2582 * t2681;
        t2822 = t2817 + t16 * t2502 - t2113 * t2662 - t2668 * t2676 - t2225 * t2653
            - t2188 * t2681;
        t2824 = t2822 - sin_phi * t2809 - t13 * t2602;
        t2828 = t1854 * t2231 + speeds[2] * t2824 + t841 * t2634;
        t2834 = t1856 * t2231 + speeds[1] * t2824 + t840 * t2640;
        t2836 = t74 * t1856;
        t2838 = speeds[0] * t1170;
        t2841 = t1292 + t1170 * t1275;
        t2843 = t12 * t2838 + t7 * t2841;
        t2845 = speeds[1] * t2843 - t12 * t2836;
        t2850 = t7 * t2838 - t12 * t2841;
        t2851 = speeds[1] * t2850;
        t2852 = t7 * t2836 - t2851;
        t2854 = t74 * t1275;
        t2855 = speeds[1] * t2854;
        t2857 = speeds[1] * t1277;
        t2860 = speeds[1] * t1281;
        t2867 = cos_delta * t2854 + t1277 * t2281 - sin_delta * t2843;
        t2868 = speeds[1] * t2867;
        t2874 = sin_delta * t2854 + t1277 * t2304 + cos_delta * t2843;
        t2875 = speeds[1] * t2874;
        t2885 = t2096 * t2845 + t2144 * t2857 + t1856 * t2225 + t2278 * t2851
            + t2302 * t2868 + t2325 * t2875;
        t2890 = t2885 + t2582 * t2860 + speeds[1] * t2809 + t515 * t2834 - t2113 * t2852
            - t2676 * t2855;
        t2892 = t2890 - t2188 * t2860 - t848 * t2640;
        t2898 = t855 * t2640 + t523 * t2834 + t81 * t2892;
        t2900 = t1466 * t2012;
        t2904 = self.constants[19] * t1860;
        t2908 = speeds[0] * t2632 - t1948 - t1253 * t2904;
        t2912 = t865 * t2634 + t539 * t2640 + t868 * t2908 - t1253 * t2900;
        t2914 = t1462 * t2012;
        t2919 = t141 * t2640 + t877 * t2908 - t1253 * t2914;
        t2921 = t466 * t1466;
        t2922 = t2017 * t2921;
        t2937 = t7 * t1982 + t12 * t2007;
        t2943 = t1667 + self.constants[31] * t1908 + self.constants[30] * t1932
            + self.constants[33] * t1895 + self.constants[18] * t1897
            + sin_delta * t1923;
        t2947 = t2943 + cos_delta * t1952 + self.constants[24] * t2004
            - self.constants[23] * t1979 - t74 * t2937;
        t2955 = sin_phi * t2947 + cos_phi * (t12 * t1998 + t1170 * t2937 - t7 * t1973);
        t2961 = t2955 + t1860 * t2231 + speeds[0] * t2824 + t841 * t2908;
        t2966 = t2231 * t2921 + t532 * t2828 + t540 * t2834 + t543 * t2961
            - t1253 * t2922;
        t2968 = t466 * t1462;
        t2969 = t2017 * t2968;
        t2976 = t2231 * t2968 + t551 * t2834 + t553 * t2961 - t1253 * t2969;
        t2981 = t74 * t1860;
        t2984 = speeds[0] * t2843 - t12 * t2981;
        t2987 = speeds[0] * t2850;
        t2988 = t7 * t2981 - t2987;
        t2990 = speeds[0] * t2854;
        t2992 = speeds[0] * t1277;
        t2995 = speeds[0] * t1281;
        t2998 = speeds[0] * t2867;
        t3000 = speeds[0] * t2874;
        t3010 = t2096 * t2984 + t2144 * t2992 + t1860 * t2225 + t2278 * t2987
            + t2302 * t2998 + t2325 * t3000;
        t3015 = t3010 + t2582 * t2995 + speeds[0] * t2809 + t515 * t2961 - t2947
            - t2113 * t2988;
        t3018 = t3015 - t2676 * t2990 - t2188 * t2995 - t896 * t2908;
        t3028 = t892 * t2640 + t557 * t2834 + t104 * t2892 + t53 * t3018 + t575 * t2919
            + t563 * t2976;
        t3030 = t3028 - t123 * t2912 - t36 * t2966;
        t3032 = t142 * t1462;
        t3046 = t570 * t2834 + t144 * t2892 + t36 * t2912 + t575 * t2976 - t2254 * t3032
            - t913 * t2640;
        t3049 = t3046 - t149 * t3018 - t563 * t2919 - t123 * t2966;
        t3053 = t1596 * t2012 + t939 * t2636;
        t3055 = t30 * t1412;
        t3059 = t30 * t1374 - t27 * t1378;
        t3061 = t27 * t1412;
        t3070 = t1253 * t3053 + t2302 * t3059 + t2325 * t3061 - t2278 * t3055
            - t940 * t2632 - t945 * t2634;
        t3071 = t3070 - t951 * t2908;
        t3077 = t1170 * t1982 + t1214 * t1998 + t2007 * t2010 + t1874 * t2144
            + t1860 * t2188 + t2026 * t2231;
        t3082 = t3077 + t2241 * t2254 + t2294 * t2302 + t2315 * t2325 + t2335 * t2347
            + speeds[0] * t2502;
        t3087 = t3082 + t822 * t2634 + t836 * t2640 + t468 * t2828 + t508 * t2834
            + t69 * t2892;
        t3092 = t3087 + self.constants[24] * t2898 + t864 * t2912 + t550 * t2976
            + t120 * t3049 + t930 * t3071;
        t3098 = t3092 - t1973 - t1253 * t2029 - t1902 * t2096 - t1906 * t2113
            - t2268 * t2278 - t1275 * t2602;
        t3101 = t3098 - t875 * t2919 - t530 * t2966 - t103 * t3030;
        t3115 = t28 * t466 * t1457 + t170 * t2018 + t172 * t2021 + t174 * t2023;
        t3118 = t172 * t2013 - t174 * t2015 - t2017 * t3115;
        t3132 = t28 * t53 * t1399 + t172 * t2236 + t174 * t2238 - t170 * t2233;
        t3134 = t28 * self.constants[22];
        t3140 = t1335 + t1378 * t3134 + t172 * t2259 - t174 * t2265;
        t3146 = t172 * t2286 + t174 * t2290 - sin_delta * t1342;
        t3154 = cos_delta * t1342 + t174 * t2311 - t1374 * t3134 - t172 * t2308;
        t3162 = t28 * t2327 + t170 * t2328 + t172 * t2330 + t174 * t2332;
        t3184 = t1982 * t2010 + t1906 * t2096 + t1860 * t2144 + t2254 * t3132
            + t2278 * t3140 + t2302 * t3146;
        t3189 = t3184 + t2325 * t3154 + t2347 * t3162 + t1303 * t2582 + t1275 * t2502
            + speeds[0] * t2602;
        t3194 = t3189 + t969 * t2634 + t977 * t2640 + t590 * t2828 + t602 * t2834
            + t160 * t2892;
        t3199 = t3194 + t985 * t2912 + t612 * t2976 + t180 * t3030 + t190 * t3049
            - t1998;
        t3204 = t3199 - t1170 * t2007 - t1214 * t1973 - t1253 * t3118 - t1902 * t2113
            - t1874 * t2188;
        t3209 = t3204 - t2231 * t3115 - self.constants[23] * t2898 - t989 * t2919
            - t608 * t2966 - t995 * t3071;
        t3211 = t7 * t1966;
        t3212 = self.constants[38] * t1895;
        t3213 = sin_delta * t3212;
        t3215 = t12 * t1966;
        t3217 = t3215 + t7 * t3213;
        t3220 = cos_delta * t3212 - t1979;
        t3222 = self.constants[37] * t1895;
        t3224 = t1273 * t1277;
        t3225 = t1882 + t3224;
        t3227 = t1273 * t1273;
        t3228 = t1281 * t1281;
        t3229 = t3227 + t3228;
        t3232 = t1311 + t3224;
        t3235 = cos_delta * t3232 + sin_delta * t3229;
        t3239 = sin_delta * t3232 - cos_delta * t3229;
        t3241 = t1277 * t1281;
        t3253 = t12 * t3213 + t1214 * t3217 + t2137 * t3225 + t1326 * t2278
            + t2302 * t3235 + t2325 * t3239;
        t3258 = t3253 + t2481 * t3241 + t1027 * t2640 + t80 * t3030 + t12 * t3049
            - t3211;
        t3263 = t3258 - t1206 * t3220 - t2106 * t3222 - t2093 * t3229 - t641 * t2834
            - t205 * t2892;
        t3264 = t3263 - t7 * t2898;
        t3268 = self.constants[16] - t239;
        t3272 = self.constants[2] * t3268 + self.constants[3] * self.constants[17];
        t3273 = self.constants[15] * t3272;
        t3274 = t3273 + t3273;
        t3275 = t1352 * t1357;
        t3276 = t7 * t3275;
        t3277 = t1348 * t1352;
        t3278 = cos_delta * t3277;
        t3280 = t3278 + sin_delta * t1939;
        t3282 = t12 * t3275;
        t3284 = t3282 + t7 * t3280;
        t3286 = sin_delta * t3277;
        t3288 = cos_delta * t1939 - t3286;
        t3292 = t12 * t3280 + t1214 * t3284 - t3276 - t1206 * t3288;
        t3296 = self.constants[3] * t3268 - self.constants[2] * self.constants[17];
        t3297 = self.constants[15] * t3296;
        t3298 = t3277 - t1917;
        t3300 = t1919 + t3275;
        t3302 = t1348 * t1348;
        t3303 = t1357 * t1357;
        t3304 = t3302 - t3303;
        t3306 = cos_delta * t3300 - sin_delta * t3304;
        t3310 = t12 * t3298 + t7 * t3306;
        t3314 = sin_delta * t3300 + cos_delta * t3304;
        t3318 = t12 * t3306 + t1214 * t3310 + t1206 * t3314 - t7 * t3298;
        t3321 = t1348 * t1357;
        t3322 = sin_delta * t3321;
        t3323 = cos_delta * t1917 - t3322;
        t3326 = t3282 + t7 * t3323;
        t3329 = cos_delta * t3321;
        t3330 = sin_delta * t1917 + t3329;
        t3334 = t3276 - t12 * t3323 - t1214 * t3326 - t1206 * t3330;
        t3338 = cos_delta * t1912 + sin_delta * t1927;
        t3340 = t7 * t3338;
        t3344 = cos_delta * t1927 - sin_delta * t1912;
        t3346 = t1352 * t1352;
        t3347 = t3303 + t3346;
        t3350 = t1939 + t3321;
        t3356 = t12 * t3338 + t1214 * t3340 + t2068 * t3298 + t2087 * t3350
            - t1206 * t3344 - t2106 * t3347;
        t3360 = t3274 * t3292 + t3297 * t3318 + t3274 * t3334
            + self.constants[15] * t3356;
        t3362 = t3297 + t3297;
        let (
            t3364, t3368, t3370, t3374, t3379, t3383, t3385, t3387, t3390, t3396, t3397, t3401,
            t3403, t3406, t3407, t3409, t3411, t3413, t3415, t3419, t3421, t3422, t3430, t3435,
            t3440, t3442, t3445, t3447, t3452, t3463, t3469, t3474, t3476, t3483, t3485, t3487,
            t3499, t3504, t3515, t3522, t3526, t3542, t3543, t3549, t3558, t3564, t3570, t3576,
            t3582, t3601, t3607, t3612, t3617, t3618, t3638, t3644, t3649, t3654, t3666, t3668,
            t3674, t3680, t3708, t3713, t3718, t3726, t3731, t3733, t3737, t3744, t3763, t3768,
            t3771, t3777, t3784, t3788, t3794, t3804, t3809, t3817, t3839, t3844, t3846, t3856,
            t3858, t3873, t3876, t3890, t3892, t3898, t3903, t3908, t3913, t3918, t3920, t3955,
            t3960, t3965, t3970, t3975, t3978, t4000, t4005, t4009, t4014, t4019, t4024, t4034,
            t4038, t4043, t4056, t4060, t4062, t4076, t4081, t4086, t4087, t4090, t4093, t4099,
            t4110, t4116, t4120, t4122, t4129, t4131, t4133, t4144, t4148, t4159, t4165, t4169,
            t4185, t4187, t4193, t4202, t4208, t4214, t4220, t4226, t4245, t4251, t4256, t4261,
            t4281, t4287, t4292, t4296, t4307, t4310, t4314, t4320, t4348, t4353, t4357, t4365,
            t4370, t4372, t4377, t4383, t4402, t4407, t4409, t4415, t4422, t4426, t4432, t4442,
            t4447, t4455, t4477, t4482, t4484, t4494, t4496, t4511, t4514, t4527, t4528, t4534,
            t4539, t4544, t4549, t4554, t4556, t4591, t4596, t4601, t4606, t4611, t4614, t4637,
            t4642, t4646, t4650, t4654, t4658, t4668, t4672, t4676, t4688, t4692, t4694, t4708,
            t4713, t4718, t4719, t4722, t4727, t4729, t4733, t4735, t4737, t4740, t4741, t4743,
            t4753, t4757, t4759, t4761, t4764, t4777, t4782, t4789, t4804, t4808, t4825, t4830,
            t4839, t4854, t4858, t4875, t4880, t4890, t4892, t4894, t4898, t4902, t4903, t4906,
            t4909, t4912, t4915, t4919, t4922, t4928, t4935, t4936, t4939, t4942,
        );
        t3364 = t3278 + t3322;
        t3368 = t12 * t1919 - t7 * t3364;
        t3370 = t3286 - t3329;
        t3374 = t1214 * t3368 - t7 * t1919 - t12 * t3364 - t1206 * t3370;
        t3379 = sin_delta * t1934;
        t3383 = t12 * t1912 - t7 * t3379;
        t3385 = cos_delta * t1934;
        t3387 = t3321 - t1939;
        t3390 = t3302 + t3346;
        t3396 = t1214 * t3383 + t1206 * t3385 + t2106 * t3387 + t2068 * t3300
            - t7 * t1912 - t12 * t3379;
        t3397 = t3396 - t2087 * t3390;
        t3401 = t3362 * t3374 + t3292 * t3362 + t3273 * t3318
            + self.constants[15] * t3397;
        t3403 = self.constants[2] * t3360 + self.constants[3] * t3401;
        t3406 = t1273 * t1281;
        t3407 = t3406 - t1877;
        t3409 = t1895 + t3241;
        t3411 = t1314 + t3406;
        t3413 = t3241 - t1326;
        t3415 = cos_delta * t3411 - sin_delta * t3413;
        t3419 = sin_delta * t3411 + cos_delta * t3413;
        t3421 = t1277 * t1277;
        t3422 = t3227 + t3421;
        t3430 = t66 * t3030 - t7 * t3049;
        t3435 = t3215 + t1214 * t3211 + t2137 * t3407 + t2093 * t3409 + t2302 * t3415
            + t2325 * t3419;
        t3440 = t3435 + t1012 * t2640 + t627 * t2834 + t12 * t2898 - t1206 * t2004
            - t2481 * t3422;
        t3442 = t3440 - t196 * t2892 - t3430;
        t3445 = self.constants[3] * t3264 + self.constants[2] * t3442 - t3403;
        t3447 = t157 * t3209 + t3445 - t58 * t3101;
        t3452 = t1170 * t1712 + t74 * t1710;
        t3463 = t1712 * t2058 + t1710 * t2060 - t1247 * t3452;
        t3469 = t1712 * t2078 + t94 * t3452 - t1710 * t2054;
        t3474 = t1171 + t2070 * t3469 - t1712 * t2043 - t1710 * t2047 - t2049 * t3463;
        t3476 = t2034 * t3452 + t3474 - self.constants[31] * t1710;
        t3483 = self.constants[23] * t1710 + t7 * t3452;
        t3485 = t1706 * t1712 - self.constants[37] * t3483;
        t3487 = t3485 - t1182 * t1710 - t2101 * t3452;
        t3499 = t1712 * t2128 + t2070 * t3463 + t2049 * t3469 - t1144 - t1710 * t2040;
        t3504 = t1712 * t2121 + self.constants[38] * t3463 + self.constants[23] * t3499
            - self.constants[43] - t1191 * t1710;
        t3515 = t1754 + t1712 * t2159 + self.constants[39] * t3469 - t1710 * t2156
            - self.constants[38] * t3483;
        t3522 = t1712 * t2175 - self.constants[41] - t1710 * t2171
            - self.constants[39] * t3463;
        t3526 = t1712 * t2151 + cos_delta * t3522 - self.constants[24] * t3499
            - sin_delta * t3515;
        t3542 = t1712 * t2203 + t2211 * t3452 + self.constants[24] * t3474
            + cos_delta * t3515 + sin_delta * t3522 - t1710 * t2207;
        t3543 = t3542 - self.constants[46] * t3483;
        t3549 = t2195 * t3487 + t16 * t3526 - t2193 * t3476 - t13 * t3504
            - sin_phi * t3543;
        t3558 = t3543 + t1736 * t2244 + t2246 * t3487 + t515 * t3549 - t2248 * t3476;
        t3564 = t1736 * t2272 + t2275 * t3558 - t2270 * t3549;
        t3570 = t1736 * t2296 + t2295 * t3549 + t2299 * t3558;
        t3576 = t2322 * t3558 - t1736 * t2319 - t2317 * t3549;
        t3582 = t2342 * t3570 - t2337 * t3564 - t2344 * t3576;
        t3601 = t3564 + t1144 * t1710 - t3485;
        t3607 = t2356 * t3452 + t1712 * t2388 + t2402 * t3483 + t2409 * t3463
            + t2414 * t3469 + t1306 * t3499;
        t3612 = t3607 + t2417 * t3474 + t301 * t3504 + t2436 * t3564 + t2456 * t3570
            + t2473 * t3576;
        t3617 = t3612 + t2476 * t3582 + t2478 * t3601 - t2366 - t1710 * t2396
            - t2419 * t3515;
        t3618 = t3617 - t2421 * t3522;
        t3638 = t2576 * t3570 + t2579 * t3576 - t2571 * t3564;
        t3644 = t2371 + t2513 * t3452 + t2405 * t3483 + t1548 * t3463 + t1304 * t3499
            + t2548 * t3564;
        t3649 = t3644 + t2555 * t3570 + t2563 * t3576 + t2565 * t3582 + t2567 * t3601
            + t301 * t3638;
        t3654 = t3649 - t1712 * t2530 - t1710 * t2538 - t2541 * t3469 - t2544 * t3474
            - t301 * t3526;
        t3666 = t1712 * t2613 + t1710 * t2615 + t2622 * t3570 - t2606 - t2618 * t3564
            - t2625 * t3576;
        t3668 = t1736 * t2604 + speeds[2] * t3666;
        t3674 = t1736 * t2637 + t824 * t3666 - t820 * t1948;
        t3680 = t3499 + t1712 * t2672;
        t3708 = t1712 * t2743 + t2751 * t3483 + t2755 * t3463 + t2759 * t3469
            + t2761 * t3499 + t2419 * t3522;
        t3713 = t3708 + t2769 * t3564 + t2777 * t3570 + t2785 * t3576 + t2787 * t3582
            - t2726;
        t3718 = t3713 - t2721 * t3452 - t1710 * t2747 - t2763 * t3474 - t2421 * t3515
            - t2789 * t3601;
        t3726 = t2658 * t3476 + t2662 * t3487 + t2668 * t3680 + t2678 * t3504
            + t2690 * t3564 + t2702 * t3570;
        t3731 = t3726 + t2710 * t3576 + t2681 * t3638 + t16 * t3618 - t2653 * t3543
            - t2681 * t3526;
        t3733 = t3731 - sin_phi * t3718 - t13 * t3654;
        t3737 = t1854 * t3549 + speeds[2] * t3733 + t841 * t3668;
        t3744 = t2955 + t1856 * t3549 + speeds[1] * t3733 + t840 * t3674;
        t3763 = t2845 * t3476 + t2852 * t3487 + t2855 * t3680 + t2857 * t3504
            + t1856 * t3543 + t2851 * t3564;
        t3768 = t3763 + t2868 * t3570 + t2875 * t3576 + t2860 * t3638 + speeds[1] * t3718
            + t515 * t3744;
        t3771 = t3768 - t2947 - t2860 * t3526 - t848 * t3674;
        t3777 = t855 * t3674 + t523 * t3744 + t81 * t3771;
        t3784 = t1736 * t2904 + speeds[0] * t3666;
        t3788 = t1736 * t2900 + t865 * t3668 + t539 * t3674 + t868 * t3784;
        t3794 = t1736 * t2914 + t141 * t3674 + t877 * t3784;
        t3804 = t1860 * t3549 + speeds[0] * t3733 + t841 * t3784;
        t3809 = t1736 * t2922 + t2921 * t3549 + t532 * t3737 + t540 * t3744
            + t543 * t3804;
        t3817 = t1736 * t2969 + t2968 * t3549 + t551 * t3744 + t553 * t3804;
        t3839 = t2984 * t3476 + t2988 * t3487 + t2990 * t3680 + t2992 * t3504
            + t1860 * t3543 + t2987 * t3564;
        t3844 = t3839 + t2998 * t3570 + t3000 * t3576 + t2995 * t3638 + speeds[0] * t3718
            + t515 * t3804;
        t3846 = t3844 - t2995 * t3526 - t896 * t3784;
        t3856 = t892 * t3674 + t557 * t3744 + t104 * t3771 + t53 * t3846 + t575 * t3794
            + t563 * t3817;
        t3858 = t3856 - t123 * t3788 - t36 * t3809;
        t3873 = t570 * t3744 + t144 * t3771 + t36 * t3788 + t575 * t3817 - t3032 * t3558
            - t913 * t3674;
        t3876 = t3873 - t149 * t3846 - t563 * t3794 - t123 * t3809;
        t3890 = t939 * t1948 + t3059 * t3570 + t3061 * t3576 - t1736 * t3053
            - t3055 * t3564 - t940 * t3666;
        t3892 = t3890 - t945 * t3668 - t951 * t3784;
        t3898 = t1712 * t1998 + t2007 * t3452 + t1736 * t2029 + t1906 * t3487
            + t1874 * t3504 + t1860 * t3526;
        t3903 = t3898 + t2026 * t3549 + t2241 * t3558 + t2294 * t3570 + t2315 * t3576
            + t2335 * t3582;
        t3908 = t3903 + speeds[0] * t3618 + t822 * t3668 + t836 * t3674 + t468 * t3737
            + t508 * t3744;
        t3913 = t3908 + t69 * t3771 + self.constants[24] * t3777 + t864 * t3788
            + t550 * t3817 + t120 * t3876;
        t3918 = t3913 + t930 * t3892 - t1902 * t3476 - t2268 * t3564 - t1275 * t3654
            - t875 * t3794;
        t3920 = t3918 - t530 * t3809 - t103 * t3858;
        t3955 = t1982 * t3452 + t1736 * t3118 + t1906 * t3476 + t1902 * t3487
            + t1860 * t3504 + t3132 * t3558;
        t3960 = t3955 + t3140 * t3564 + t3146 * t3570 + t3154 * t3576 + t3162 * t3582
            + t1303 * t3638;
        t3965 = t3960 + t1275 * t3618 + speeds[0] * t3654 + t969 * t3668 + t977 * t3674
            + t590 * t3737;
        t3970 = t3965 + t602 * t3744 + t160 * t3771 + t985 * t3788 + t612 * t3817
            + t180 * t3858;
        t3975 = t3970 + t190 * t3876 - t1712 * t1973 - t1874 * t3526 - t3115 * t3549
            - self.constants[23] * t3777;
        t3978 = t3975 - t989 * t3794 - t608 * t3809 - t995 * t3892;
        t4000 = t1712 * t3217 + t3225 * t3499 + t1326 * t3564 + t3235 * t3570
            + t3239 * t3576 + t3241 * t3601;
        t4005 = t4000 + t1027 * t3674 + t80 * t3858 + t12 * t3876 - t1710 * t3220
            - t3222 * t3483;
        t4009 = t4005 - t3229 * t3474 - t641 * t3744 - t205 * t3771 - t7 * t3777;
        t4014 = t1712 * t3284 - t3275 - t1710 * t3288;
        t4019 = t3298 - t1712 * t3310 - t1710 * t3314;
        t4024 = t3275 - t1712 * t3326 - t1710 * t3330;
        t4034 = t1712 * t3340 + t3298 * t3463 + t3350 * t3469 - t1710 * t3344
            - t3347 * t3483;
        t4038 = t3274 * t4014 + t3274 * t4024 + self.constants[15] * t4034
            - t3297 * t4019;
        t4043 = t1712 * t3368 - t1919 - t1710 * t3370;
        t4056 = t1712 * t3383 + t1710 * t3385 + t3387 * t3483 + t3300 * t3463 - t1912
            - t3390 * t3469;
        t4060 = t3362 * t4043 + t3362 * t4014 + self.constants[15] * t4056
            - t3273 * t4019;
        t4062 = self.constants[2] * t4038 + self.constants[3] * t4060;
        t4076 = t66 * t3858 - t7 * t3876;
        t4081 = t1712 * t3211 + t3407 * t3499 + t3409 * t3474 + t3415 * t3570
            + t3419 * t3576 + t1012 * t3674;
        t4086 = t4081 + t627 * t3744 + t12 * t3777 - t1710 * t2004 - t3422 * t3601
            - t196 * t3771;
        t4087 = t4086 - t4076;
        t4090 = self.constants[3] * t4009 + self.constants[2] * t4087 - t4062;
        t4093 = t157 * t3978 + t4090 - t58 * t3920 - t1747 * t3447;
        t4099 = t74 + t1170 * t1781 - t74 * t1779;
        t4110 = t1781 * t2058 - t1779 * t2060 - t1247 * t4099;
        t4116 = t1781 * t2078 + t1779 * t2054 + t94 * t4099;
        t4120 = t1779 * t2047 + t2070 * t4116 - t1781 * t2043 - t2049 * t4110;
        t4122 = self.constants[31] * t1779 + t2034 * t4099 + t4120;
        t4129 = t7 * t4099 - self.constants[23] * t1779;
        t4131 = t1706 * t1781 - self.constants[37] * t4129;
        t4133 = t1182 * t1779 + t4131 - t2101 * t4099;
        t4144 = t1781 * t2128 + t1779 * t2040 + t2070 * t4110 + t2049 * t4116;
        t4148 = t1191 * t1779 + t1781 * t2121 + self.constants[38] * t4110
            + self.constants[23] * t4144;
        t4159 = t1839 + t1779 * t2156 + t1781 * t2159 + self.constants[39] * t4116
            - self.constants[38] * t4129;
        t4165 = t1779 * t2171 + t1781 * t2175 - self.constants[39] * t4110;
        t4169 = t1781 * t2151 + cos_delta * t4165 - self.constants[24] * t4144
            - sin_delta * t4159;
        t4185 = t1781 * t2203 + t1779 * t2207 + t2211 * t4099
            + self.constants[24] * t4120 + cos_delta * t4159 + sin_delta * t4165;
        t4187 = t4185 - self.constants[18] - self.constants[46] * t4129;
        t4193 = t2195 * t4133 + t16 * t4169 - t2193 * t4122 - t13 * t4148
            - sin_phi * t4187;
        t4202 = t4187 + t1800 * t2244 + t2246 * t4133 + t515 * t4193 - t2248 * t4122;
        t4208 = t1800 * t2272 + t2275 * t4202 - t2270 * t4193;
        t4214 = t1800 * t2296 + t2295 * t4193 + t2299 * t4202;
        t4220 = t2322 * t4202 - t1800 * t2319 - t2317 * t4193;
        t4226 = t2342 * t4214 - t2337 * t4208 - t2344 * t4220;
        t4245 = t4208 - t4131 - t1144 * t1779;
        t4251 = t2356 * t4099 + t1781 * t2388 + t1779 * t2396 + t2402 * t4129
            + t2409 * t4110 + t2414 * t4116;
        t4256 = t4251 + t1306 * t4144 + t2417 * t4120 + t301 * t4148 + t2436 * t4208
            + t2456 * t4214;
        t4261 = t4256 + t2473 * t4220 + t2476 * t4226 + t2478 * t4245 - t2419 * t4159
            - t2421 * t4165;
        t4281 = t2576 * t4214 + t2579 * t4220 - t2571 * t4208;
        t4287 = t2513 * t4099 + t2405 * t4129 + t1779 * t2538 + t1548 * t4110
            + t1304 * t4144 + t2548 * t4208;
        t4292 = t4287 + t2555 * t4214 + t2563 * t4220 + t2565 * t4226 + t2567 * t4245
            + t301 * t4281;
        t4296 = t4292 - t1781 * t2530 - t2541 * t4116 - t2544 * t4120 - t301 * t4169;
        t4307 = t1781 * t2613 + t2622 * t4214 - t1779 * t2615 - t2618 * t4208
            - t2625 * t4220;
        t4310 = t1800 * t2604 + speeds[2] * t4307 - t1948;
        t4314 = t1800 * t2637 + t824 * t4307;
        t4320 = t4144 + t1781 * t2672;
        t4348 = t1781 * t2743 + t1779 * t2747 + t2751 * t4129 + t2755 * t4110
            + t2759 * t4116 + t2761 * t4144;
        t4353 = t4348 + t2419 * t4165 + t2769 * t4208 + t2777 * t4214 + t2785 * t4220
            + t2787 * t4226;
        t4357 = t4353 - t2721 * t4099 - t2763 * t4120 - t2421 * t4159 - t2789 * t4245;
        t4365 = t2658 * t4122 + t2662 * t4133 + t2668 * t4320 + t2678 * t4148
            + t2690 * t4208 + t2702 * t4214;
        t4370 = t4365 + t2710 * t4220 + t2681 * t4281 + t16 * t4261 - t2653 * t4187
            - t2681 * t4169;
        t4372 = t4370 - sin_phi * t4357 - t13 * t4296;
        t4377 = t2955 + t1854 * t4193 + speeds[2] * t4372 + t841 * t4310;
        t4383 = t1856 * t4193 + speeds[1] * t4372 + t840 * t4314;
        t4402 = t2845 * t4122 + t2852 * t4133 + t2855 * t4320 + t2857 * t4148
            + t1856 * t4187 + t2851 * t4208;
        t4407 = t4402 + t2868 * t4214 + t2875 * t4220 + t2860 * t4281 + speeds[1] * t4357
            + t515 * t4383;
        t4409 = t4407 - t2860 * t4169 - t848 * t4314;
        t4415 = t855 * t4314 + t523 * t4383 + t81 * t4409;
        t4422 = t1800 * t2904 + speeds[0] * t4307;
        t4426 = t1800 * t2900 + t865 * t4310 + t539 * t4314 + t868 * t4422;
        t4432 = t1800 * t2914 + t141 * t4314 + t877 * t4422;
        t4442 = t1860 * t4193 + speeds[0] * t4372 + t841 * t4422;
        t4447 = t1800 * t2922 + t2921 * t4193 + t532 * t4377 + t540 * t4383
            + t543 * t4442;
        t4455 = t1800 * t2969 + t2968 * t4193 + t551 * t4383 + t553 * t4442;
        t4477 = t2984 * t4122 + t2988 * t4133 + t2990 * t4320 + t2992 * t4148
            + t1860 * t4187 + t2987 * t4208;
        t4482 = t4477 + t2998 * t4214 + t3000 * t4220 + t2995 * t4281 + speeds[0] * t4357
            + t515 * t4442;
        t4484 = t4482 - t2995 * t4169 - t896 * t4422;
        t4494 = t892 * t4314 + t557 * t4383 + t104 * t4409 + t53 * t4484 + t575 * t4432
            + t563 * t4455;
        t4496 = t4494 - t123 * t4426 - t36 * t4447;
        t4511 = t570 * t4383 + t144 * t4409 + t36 * t4426 + t575 * t4455 - t3032 * t4202
            - t913 * t4314;
        t4514 = t4511 - t149 * t4484 - t563 * t4432 - t123 * t4447;
        t4527 = t3059 * t4214 + t3061 * t4220 - t1800 * t3053 - t3055 * t4208
            - t940 * t4307 - t945 * t4310;
        t4528 = t4527 - t951 * t4422;
        t4534 = t1781 * t1998 + t2007 * t4099 + t1800 * t2029 + t1906 * t4133
            + t1874 * t4148 + t1860 * t4169;
        t4539 = t4534 + t2026 * t4193 + t2241 * t4202 + t2294 * t4214 + t2315 * t4220
            + t2335 * t4226;
        t4544 = t4539 + speeds[0] * t4261 + t822 * t4310 + t836 * t4314 + t468 * t4377
            + t508 * t4383;
        t4549 = t4544 + t69 * t4409 + self.constants[24] * t4415 + t864 * t4426
            + t550 * t4455 + t120 * t4514;
        t4554 = t4549 + t930 * t4528 - t1902 * t4122 - t2268 * t4208 - t1275 * t4296
            - t875 * t4432;
        t4556 = t4554 - t530 * t4447 - t103 * t4496;
        t4591 = t1982 * t4099 + t1800 * t3118 + t1906 * t4122 + t1902 * t4133
            + t1860 * t4148 + t3132 * t4202;
        t4596 = t4591 + t3140 * t4208 + t3146 * t4214 + t3154 * t4220 + t3162 * t4226
            + t1303 * t4281;
        t4601 = t4596 + t1275 * t4261 + speeds[0] * t4296 + t969 * t4310 + t977 * t4314
            + t590 * t4377;
        t4606 = t4601 + t602 * t4383 + t160 * t4409 + t985 * t4426 + t612 * t4455
            + t180 * t4496;
        t4611 = t4606 + t190 * t4514 - t1781 * t1973 - t1874 * t4169 - t3115 * t4193
            - self.constants[23] * t4415;
        t4614 = t4611 - t989 * t4432 - t608 * t4447 - t995 * t4528;
        t4637 = t1781 * t3217 + t1779 * t3220 + t3225 * t4144 + t1326 * t4208
            + t3235 * t4214 + t3239 * t4220;
        t4642 = t4637 + t3241 * t4245 + t1027 * t4314 + t80 * t4496 + t12 * t4514
            - t3222 * t4129;
        t4646 = t4642 - t3229 * t4120 - t641 * t4383 - t205 * t4409 - t7 * t4415;
        t4650 = t1781 * t3284 + t1779 * t3288;
        t4654 = t1779 * t3314 - t1781 * t3310;
        t4658 = t1779 * t3330 - t1781 * t3326;
        t4668 = t1781 * t3340 + t1779 * t3344 + t3298 * t4110 + t3350 * t4116
            - t3347 * t4129;
        t4672 = t3274 * t4650 + t3274 * t4658 + self.constants[15] * t4668
            - t3297 * t4654;
        t4676 = t1781 * t3368 + t1779 * t3370;
        t4688 = t1781 * t3383 + t3387 * t4129 + t3300 * t4110 - t1779 * t3385
            - t3390 * t4116;
        t4692 = t3362 * t4676 + t3362 * t4650 + self.constants[15] * t4688
            - t3273 * t4654;
        t4694 = self.constants[2] * t4672 + self.constants[3] * t4692;
        t4708 = t66 * t4496 - t7 * t4514;
        t4713 = t1781 * t3211 + t1779 * t2004 + t3407 * t4144 + t3409 * t4120
            + t3415 * t4214 + t3419 * t4220;
        t4718 = t4713 + t1012 * t4314 + t627 * t4383 + t12 * t4415 - t3422 * t4245
            - t196 * t4409;
        t4719 = t4718 - t4708;
        t4722 = self.constants[3] * t4646 + self.constants[2] * t4719 - t4694;
        t4727 = t1853
            * (t157 * t4614 + t4722 - t58 * t4556 - t1813 * t3447 - t1822 * t4093);
        t4729 = t1765 * t4093 - t1822 * t4727;
        t4733 = t1266 * t3447 - t1747 * t4729 - t1813 * t4727;
        t4735 = t3277 - t1365;
        t4737 = t1412 + t3321;
        t4740 = self.constants[27] * self.constants[20];
        t4741 = t4740 + t4740;
        t4743 = self.constants[26] * self.constants[20];
        t4753 = t2302 * t4735 + t2325 * t4737 + t3292 * t4741 + t3318 * t4743
            + t3334 * t4741 + t3356 * self.constants[20];
        t4757 = t4753 + t1011 * t2640 + t626 * t2834 - t3430 - t2278 * t3347;
        t4759 = t3321 - t1412;
        t4761 = t1311 + t3275;
        t4764 = t4743 + t4743;
        t4777 = t2278 * t4759 + t2302 * t4761 + t3374 * t4764 + t3292 * t4764
            + t3318 * t4740 + t3397 * self.constants[20];
        t4782 = t4777 + t1048 * t2640 + t658 * t2834 + t115 * t3030 + t94 * t3049
            - t2325 * t3390;
        t4789 = t3445 + t230 * t3209 - self.constants[2] * t4757
            - self.constants[3] * t4782 - t228 * t3101;
        t4804 = t3570 * t4735 + t3576 * t4737 + t4014 * t4741 + t4024 * t4741
            + t4034 * self.constants[20] + t1011 * t3674;
        t4808 = t4804 + t626 * t3744 - t4076 - t3347 * t3564 - t4019 * t4743;
        t4825 = t3564 * t4759 + t3570 * t4761 + t4043 * t4764 + t4014 * t4764
            + t4056 * self.constants[20] + t1048 * t3674;
        t4830 = t4825 + t658 * t3744 + t115 * t3858 + t94 * t3876 - t3390 * t3576
            - t4019 * t4740;
        t4839 = t4090 + t230 * t3978 - self.constants[2] * t4808
            - self.constants[3] * t4830 - t228 * t3920 - t1747 * t4789;
        t4854 = t4214 * t4735 + t4220 * t4737 + t4650 * t4741 + t4658 * t4741
            + t4668 * self.constants[20] + t1011 * t4314;
        t4858 = t4854 + t626 * t4383 - t4708 - t3347 * t4208 - t4654 * t4743;
        t4875 = t4208 * t4759 + t4214 * t4761 + t4676 * t4764 + t4650 * t4764
            + t4688 * self.constants[20] + t1048 * t4314;
        t4880 = t4875 + t658 * t4383 + t115 * t4496 + t94 * t4514 - t3390 * t4220
            - t4654 * t4740;
        t4890 = t4722 + t230 * t4614 - self.constants[2] * t4858
            - self.constants[3] * t4880 - t228 * t4556 - t1813 * t4789;
        t4892 = t1853 * (t4890 - t1822 * t4839);
        t4894 = t1765 * t4839 - t1822 * t4892;
        t4898 = t1266 * t4789 - t1747 * t4894 - t1813 * t4892;
        t4902 = self.constants[3] * self.constants[13];
        t4903 = self.constants[2] * self.constants[12] + t4902;
        t4906 = self.constants[2] * self.constants[13];
        t4909 = t4906 + self.constants[3] * self.constants[14];
        t4912 = self.constants[3] * (t4903 + t4903)
            - self.constants[2] * (t4909 + t4909);
        t4915 = self.constants[3] * self.constants[12] - t4906;
        t4919 = t4902 - self.constants[2] * self.constants[14];
        t4922 = self.constants[3] * (t4915 - t4909)
            - self.constants[2] * (t4903 + t4919);
        t4928 = self.constants[3] * (t4919 + t4919)
            + self.constants[2] * (t4915 + t4915);
        t4935 = self.constants[3] * self.constants[7];
        t4936 = self.constants[2] * self.constants[6] + t4935;
        t4939 = self.constants[2] * self.constants[7];
        t4942 = t4939 + self.constants[3] * self.constants[8];
        let (
            t4945, t4947, t4949, t4950, t4952, t4955, t4958, t4962, t4965, t4966, t4968, t4970,
            t4974, t4980, t4985, t4987, t4991, t4996, t4998, t5000, t5002, t5004, t5006, t5007,
            t5008, t5010, t5014, t5016, t5018, t5023, t5030, t5034, t5038, t5039, t5041, t5043,
            t5044, t5047, t5051, t5053, t5061, t5065, t5077, t5082, t5087, t5095, t5096, t5099,
            t5103, t5111, t5118, t5130, t5143, t5148, t5153, t5154, t5162, t5163, t5166, t5170,
            t5178, t5185, t5197, t5211, t5216, t5221, t5224, t5226, t5230, t5235, t5243, t5254,
            t5256, t5260, t5267, t5271, t5273, t5274, t5275, t5276, t5279, t5280, t5281, t5282,
            t5284, t5285, t5287, t5291, t5294, t5295, t5299, t5302, t5303, t5313, t5322, t5327,
            t5332, t5337, t5355, t5364, t5369, t5374, t5379, t5398, t5407, t5412, t5417, t5423,
            t5425, t5427, t5431, t5432, t5437, t5441, t5445, t5452, t5454, t5458, t5459, t5463,
            t5470, t5472, t5476, t5477, t5479, t5483, t5488, t5494, t5504, t5506, t5510, t5513,
            t5519, t5528, t5530, t5534, t5537, t5543, t5545, t5549, t5555, t5560, t5562, t5564,
            t5568, t5572, t5576, t5578, t5580, t5582, t5584, t5590, t5595, t5598, t5612, t5614,
            t5629, t5633, t5635, t5639, t5640, t5642, t5644, t5645, t5647, t5651, t5655, t5659,
            t5666, t5668, t5672, t5675, t5681, t5683, t5687, t5691, t5698, t5708, t5710, t5714,
            t5715, t5718, t5721, t5729, t5740, t5742, t5746, t5749, t5755, t5757, t5761, t5764,
            t5770, t5779, t5781, t5785, t5790, t5791, t5793, t5794, t5796, t5805, t5806, t5812,
            t5824, t5826, t5832, t5845, t5849, t5851, t5855, t5857, t5860, t5863, t5868, t5871,
            t5879, t5881, t5885, t5888, t5894, t5896, t5900, t5904, t5911, t5921, t5923, t5927,
            t5932, t5940, t5951, t5953, t5957, t5960, t5964, t5975, t5979, t5984, t5988, t6003,
            t6008, t6013, t6029, t6034, t6040, t6041, t6043, t6047, t6048, t6050,
        );
        t4945 = self.constants[3] * (t4936 + t4936)
            - self.constants[2] * (t4942 + t4942);
        t4947 = t12 * t3406;
        t4949 = t7 * t3406;
        t4950 = t12 * t1882 - t4949;
        t4952 = t1206 * t3241;
        t4955 = t1214 * t4950 + t4952 - t7 * t1882 - t4947;
        t4958 = t4935 - self.constants[2] * self.constants[8];
        t4962 = self.constants[3] * self.constants[6] - t4939;
        t4965 = self.constants[3] * (t4958 + t4958)
            + self.constants[2] * (t4962 + t4962);
        t4966 = t7 * t3224;
        t4968 = t12 * t3224;
        t4970 = t4968 + t7 * t1877;
        t4974 = t4966 - t4952 - t12 * t1877 - t1214 * t4970;
        t4980 = self.constants[3] * (t4962 - t4942)
            - self.constants[2] * (t4936 + t4958);
        t4985 = t12 * t3407 + t7 * t3225;
        t4987 = t3228 - t3421;
        t4991 = t12 * t3225 + t1214 * t4985 + t1206 * t4987 - t7 * t3407;
        t4996 = self.constants[4] + self.constants[11];
        t4998 = self.constants[3] * self.constants[10] - self.constants[2] * t4996;
        t5000 = t74 * t3407;
        t5002 = t3409 * self.constants[9];
        t5004 = t3422 * self.constants[9];
        t5006 = t1864 * self.constants[9];
        t5007 = t12 * t5006;
        t5008 = t7 * t5006;
        t5010 = t1908 * self.constants[9];
        t5014 = t12 * t5002 - t7 * t5004;
        t5016 = self.constants[31] + self.constants[31];
        t5018 = t4949 + t4968;
        t5023 = t4947 + t1214 * t5018 - t4966 - t1206 * t1895;
        t5030 = t2010 * t5014 + t4974 * t5016 + t5016 * t5023
            + self.constants[30] * t4991 - self.constants[9] * t5000 - t2031 * t5002;
        t5034 = t5030 - t2098 * t5004 - t5007 - t1214 * t5008 - t1206 * t5010;
        t5038 = self.constants[2] * self.constants[10] + self.constants[3] * t4996;
        t5039 = t74 * t3225;
        t5041 = t3229 * self.constants[9];
        t5043 = t3241 - t1895;
        t5044 = self.constants[9] * t5043;
        t5047 = t1932 * self.constants[9];
        t5051 = t7 * t5044 - t12 * t5041;
        t5053 = self.constants[30] + self.constants[30];
        t5061 = t5008 + t2031 * t5041 + t2098 * t5044 + t2010 * t5051 + t4955 * t5053
            + t5023 * t5053;
        t5065 = t5061 + self.constants[31] * t4991 - self.constants[9] * t5039
            - t1214 * t5007 - t1206 * t5047;
        t5077 = t3374 * t4912 + t3296 * t3360 + t4945 * t4955 + t4998 * t5034
            + self.constants[26] * t4757 + t244 * t4782;
        t5082 = t5077 + self.constants[23] * t3442 + t290 * t3209 - t3318 * t4922
            - t3334 * t4928 - t3272 * t3401;
        t5087 = t5082 - t4965 * t4974 - t4980 * t4991 - t5038 * t5065
            - self.constants[24] * t3264 - t287 * t3101;
        t5095 = t1710 * t3241;
        t5096 = t1712 * t4950 + t5095;
        t5099 = t5095 + t1712 * t4970;
        t5103 = t1712 * t4985 + t1710 * t4987;
        t5111 = t1712 * t5018 - t1710 * t1895;
        t5118 = t3452 * t5014 + t5016 * t5111 + self.constants[30] * t5103
            - t1712 * t5008 - t1710 * t5010 - t5016 * t5099;
        t5130 = t3452 * t5051 + t5053 * t5096 + t5053 * t5111
            + self.constants[31] * t5103 - t1712 * t5007 - t1710 * t5047;
        t5143 = t4043 * t4912 + t4019 * t4922 + t3296 * t4038 + t4945 * t5096
            + t4965 * t5099 + t4998 * t5118;
        t5148 = t5143 + self.constants[26] * t4808 + t244 * t4830
            + self.constants[23] * t4087 + t290 * t3978 - t4024 * t4928;
        t5153 = t5148 - t3272 * t4060 - t4980 * t5103 - t5038 * t5130
            - self.constants[24] * t4009 - t287 * t3920;
        t5154 = t5153 - t1747 * t5087;
        t5162 = t1779 * t3241;
        t5163 = t1781 * t4950 - t5162;
        t5166 = t5162 - t1781 * t4970;
        t5170 = t1779 * t4987 - t1781 * t4985;
        t5178 = t1781 * t5018 + t1779 * t1895;
        t5185 = t1779 * t5010 + t4099 * t5014 + t5016 * t5166 + t5016 * t5178
            - t1781 * t5008 - self.constants[30] * t5170;
        t5197 = t1779 * t5047 + t4099 * t5051 + t5053 * t5163 + t5053 * t5178
            - t1781 * t5007 - self.constants[31] * t5170;
        t5211 = t4676 * t4912 + t4654 * t4922 + t3296 * t4672 + t4945 * t5163
            + t4980 * t5170 + t4998 * t5185;
        t5216 = t5211 + self.constants[26] * t4858 + t244 * t4880
            + self.constants[23] * t4719 + t290 * t4614 - t4658 * t4928;
        t5221 = t5216 - t3272 * t4692 - t4965 * t5166 - t5038 * t5197
            - self.constants[24] * t4646 - t287 * t4556;
        t5224 = t1853 * (t5221 - t1813 * t5087 - t1822 * t5154);
        t5226 = t1765 * t5154 - t1822 * t5224;
        t5230 = t1266 * t5087 - t1747 * t5226 - t1813 * t5224;
        t5235 = t16 * t2096 + sin_phi * t2676 - t13 * t2113;
        t5243 = t16 * t3476 + t13 * t3487 - sin_phi * t3680 - t1747 * t5235;
        t5254 = t1853
            * (t16 * t4122 + t13 * t4133 - sin_phi * t4320 - t1813 * t5235
                - t1822 * t5243);
        t5256 = t1765 * t5243 - t1822 * t5254;
        t5260 = t1266 * t5235 - t1747 * t5256 - t1813 * t5254;
        t5267 = t1656 + t1966 + self.constants[30] * t1882 - self.constants[34] * t1864
            - self.constants[31] * t1877;
        t5271 = t1272 * t1339 - speeds[0] * speeds[0];
        t5273 = t12 * t1326;
        t5274 = t7 * t5271 + t5273;
        t5275 = t12 * t1897;
        t5276 = t5274 - t5275;
        t5279 = t7 * t1326;
        t5280 = t5279 - t12 * t5271;
        t5281 = t7 * t1897;
        t5282 = t5281 - t5280;
        t5284 = t1272 * t1275;
        t5285 = t5284 - t1861;
        t5287 = t5279 + t5280;
        t5291 = cos_delta * t5284 + sin_delta * t5274;
        t5294 = cos_delta * t1296 - sin_delta * t5273;
        t5295 = t5294 - t5291;
        t5299 = cos_delta * t5274 - sin_delta * t5284;
        t5302 = sin_delta * t1296 + cos_delta * t5273;
        t5303 = t5299 + t5302;
        t5313 = self.constants[3] * t5034 - self.constants[2] * t5065;
        t5322 = t1081 * t2919 + t687 * t2976 + t64 * t3018 - t563 * t2966 - t575 * t2912;
        t5327 = t1206 * t2937 + t2096 * t5276 + t2676 * t5285 + t2278 * t5287
            + t2302 * t5295 + t2325 * t5303;
        t5332 = t5327 + t1074 * t2634 + t475 * t2828 + self.constants[3] * t3442
            + t314 * t3209 + t5313;
        t5337 = t5332 + t5322 - t5267 - t2113 * t5282 - self.constants[2] * t3264
            - t312 * t3101;
        t5355 = self.constants[3] * t5118 - self.constants[2] * t5130;
        t5364 = t1081 * t3794 + t687 * t3817 + t64 * t3846 - t563 * t3809 - t575 * t3788;
        t5369 = t1710 * t2937 + t3476 * t5276 + t3487 * t5282 + t3564 * t5287
            + t3570 * t5295 + t3576 * t5303;
        t5374 = t5369 + t1074 * t3668 + t475 * t3737 + self.constants[3] * t4087
            + t314 * t3978 + t5355;
        t5379 = t5374 + t5364 - t3680 * t5285 - self.constants[2] * t4009 - t312 * t3920
            - t1747 * t5337;
        t5398 = self.constants[3] * t5185 - self.constants[2] * t5197;
        t5407 = t1081 * t4432 + t687 * t4455 + t64 * t4484 - t563 * t4447 - t575 * t4426;
        t5412 = t2937 + t4122 * t5276 + t4133 * t5282 + t4208 * t5287 + t4214 * t5295
            + t4220 * t5303;
        t5417 = t5412 + t1074 * t4310 + t475 * t4377 + self.constants[3] * t4719
            + t314 * t4614 + t5398;
        t5423 = t5417 + t5407 - t1779 * t2937 - t4320 * t5285 - self.constants[2] * t4646
            - t312 * t4556 - t1813 * t5337;
        t5425 = t1853 * (t5423 - t1822 * t5379);
        t5427 = t1765 * t5379 - t1822 * t5425;
        t5431 = t1266 * t5337 - t1747 * t5427 - t1813 * t5425;
        t5432 = t74 * t1864;
        t5437 = t12 * t1908 - t7 * t1932;
        t5441 = t5432 + t2010 * t5437 - t1908 * t2031 - t1932 * t2098;
        t5445 = t3452 * t5437 - t1747 * t5441;
        t5452 = t1853 * (t4099 * t5437 - t1813 * t5441 - t1822 * t5445);
        t5454 = t1765 * t5445 - t1822 * t5452;
        t5458 = t1266 * t5441 - t1747 * t5454 - t1813 * t5452;
        t5459 = t4955 + t4974;
        t5463 = t5096 - t5099 - t1747 * t5459;
        t5470 = t1853 * (t5163 + t5166 - t1813 * t5459 - t1822 * t5463);
        t5472 = t1765 * t5463 - t1822 * t5470;
        t5476 = t1266 * t5459 - t1747 * t5472 - t1813 * t5470;
        t5477 = t1277 * t1286;
        t5479 = t1281 * t1286;
        t5483 = t12 * t5477 + t7 * t5479;
        t5488 = t12 * t5479 + t1214 * t5483 - t7 * t5477 - t1206 * t1897;
        t5494 = t1712 * t5483 - t1710 * t1897 - t1747 * t5488;
        t5504 = t1853
            * (t1781 * t5483 + t1779 * t1897 - t1897 - t1813 * t5488 - t1822 * t5494);
        t5506 = t1765 * t5494 - t1822 * t5504;
        t5510 = t1266 * t5488 - t1747 * t5506 - t1813 * t5504;
        t5513 = self.constants[2] * t5034 + self.constants[3] * t5065;
        t5519 = self.constants[2] * t5118 + self.constants[3] * t5130 - t1747 * t5513;
        t5528 = t1853
            * (self.constants[2] * t5185 + self.constants[3] * t5197 - t1813 * t5513
                - t1822 * t5519);
        t5530 = t1765 * t5519 - t1822 * t5528;
        t5534 = t1266 * t5513 - t1747 * t5530 - t1813 * t5528;
        t5537 = t5355 - t1747 * t5313;
        t5543 = t1853 * (t5398 - t1813 * t5313 - t1822 * t5537);
        t5545 = t1765 * t5537 - t1822 * t5543;
        t5549 = t1266 * t5313 - t1747 * t5545 - t1813 * t5543;
        t5555 = t1908 + t3409 * t5038 - t3229 * t4998;
        t5560 = t4998 * t5043 - t1932 - t3422 * t5038;
        t5562 = t1864 * t4998;
        t5564 = t1864 * t5038;
        t5568 = t12 * t5562 + t7 * t5564;
        t5572 = t1908 * t5038 + t1932 * t4998;
        t5576 = t12 * t5555 + t7 * t5560;
        t5578 = t4998 * t4998;
        t5580 = t5038 * t5038;
        t5582 = t5578 + t5580;
        t5584 = t4998 * t5038;
        t5590 = t5432 + t2098 * t5560 + t7 * t5562 + t2010 * t5576 + t4955 * t5578
            + t4974 * t5580;
        t5595 = t5590 + t5023 * t5582 + t4991 * t5584 - t5000 * t5038 - t4998 * t5039
            - t2031 * t5555;
        t5598 = t5595 - t12 * t5564 - t1214 * t5568 - t1206 * t5572;
        t5612 = t3452 * t5576 + t5096 * t5578 + t5111 * t5582 + t5103 * t5584
            - t1712 * t5568 - t1710 * t5572;
        t5614 = t5612 - t5099 * t5580 - t1747 * t5598;
        t5629 = t1779 * t5572 + t4099 * t5576 + t5163 * t5578 + t5166 * t5580
            + t5178 * t5582 - t1781 * t5568;
        t5633 = t1853 * (t5629 - t5170 * t5584 - t1813 * t5598 - t1822 * t5614);
        t5635 = t1765 * t5614 - t1822 * t5633;
        t5639 = t1266 * t5598 - t1747 * t5635 - t1813 * t5633;
        t5640 = self.constants[2] * self.constants[2];
        t5642 = self.constants[3] * self.constants[3];
        t5644 = self.constants[3] * self.constants[2];
        t5645 = t4991 * t5644;
        t5647 = t4955 * t5640 + t4974 * t5642 - t5645;
        t5651 = t5103 * t5644;
        t5655 = t5096 * t5640 - t5099 * t5642 - t5651 - t1747 * t5647;
        t5659 = t5170 * t5644;
        t5666 = t1853
            * (t5163 * t5640 + t5166 * t5642 + t5659 - t1813 * t5647 - t1822 * t5655);
        t5668 = t1765 * t5655 - t1822 * t5666;
        t5672 = t1266 * t5647 - t1747 * t5668 - t1813 * t5666;
        t5675 = t5111 - t1747 * t5023;
        t5681 = t1853 * (t5178 - t1813 * t5023 - t1822 * t5675);
        t5683 = t1765 * t5675 - t1822 * t5681;
        t5687 = t1266 * t5023 - t1747 * t5683 - t1813 * t5681;
        t5691 = t5645 + t4955 * t5642 + t4974 * t5640;
        t5698 = t5651 + t5096 * t5642 - t5099 * t5640 - t1747 * t5691;
        t5708 = t1853
            * (t5163 * t5642 + t5166 * t5640 - t5659 - t1813 * t5691 - t1822 * t5698);
        t5710 = t1765 * t5698 - t1822 * t5708;
        t5714 = t1266 * t5691 - t1747 * t5710 - t1813 * t5708;
        t5715 = t5644 + t5644;
        t5718 = t5642 - t5640;
        t5721 = t4955 * t5715 - t4974 * t5715 - t4991 * t5718;
        t5729 = t5096 * t5715 + t5099 * t5715 - t5103 * t5718 - t1747 * t5721;
        t5740 = t1853
            * (t5163 * t5715 + t5170 * t5718 - t5166 * t5715 - t1813 * t5721
                - t1822 * t5729);
        t5742 = t1765 * t5729 - t1822 * t5740;
        t5746 = t1266 * t5721 - t1747 * t5742 - t1813 * t5740;
        t5749 = t4062 - t1747 * t3403;
        t5755 = t1853 * (t4694 - t1813 * t3403 - t1822 * t5749);
        t5757 = t1765 * t5749 - t1822 * t5755;
        t5761 = t1266 * t3403 - t1747 * t5757 - t1813 * t5755;
        t5764 = self.constants[3] * t3360 - self.constants[2] * t3401;
        t5770 = self.constants[3] * t4038 - self.constants[2] * t4060 - t1747 * t5764;
        t5779 = t1853
            * (self.constants[3] * t4672 - self.constants[2] * t4692 - t1813 * t5764
                - t1822 * t5770);
        t5781 = t1765 * t5770 - t1822 * t5779;
        t5785 = t1266 * t5764 - t1747 * t5781 - t1813 * t5779;
        t5790 = t1934 * t2106 + t1912 * t2068 + t1927 * t2087;
        t5791 = t3296 * t3296;
        t5793 = t3272 * t3272;
        t5794 = t5791 + t5793;
        t5796 = t3272 * t3296;
        t5805 = t5790 + t3374 * t5791 + t3292 * t5794 + t3318 * t5796 + t3334 * t5793
            + t3272 * t3356;
        t5806 = t5805 + t3296 * t3397;
        t5812 = t1934 * t3483 + t1912 * t3463 + t1927 * t3469;
        t5824 = t5812 + t4043 * t5791 + t4014 * t5794 + t4024 * t5793 + t3272 * t4034
            + t3296 * t4056;
        t5826 = t5824 - t4019 * t5796 - t1747 * t5806;
        t5832 = t1934 * t4129 + t1912 * t4110 + t1927 * t4116;
        t5845 = t5832 + t4676 * t5791 + t4650 * t5794 + t4658 * t5793 + t3272 * t4668
            + t3296 * t4688;
        t5849 = t1853 * (t5845 - t4654 * t5796 - t1813 * t5806 - t1822 * t5826);
        t5851 = t1765 * t5826 - t1822 * t5849;
        t5855 = t1266 * t5806 - t1747 * t5851 - t1813 * t5849;
        t5857 = t3318 * t5644;
        t5860 = t3374 * t5640 + t3334 * t5642 - t5857;
        t5863 = t4019 * t5644;
        t5868 = t4043 * t5640 + t5863 + t4024 * t5642 - t1747 * t5860;
        t5871 = t4654 * t5644;
        t5879 = t1853
            * (t4676 * t5640 + t5871 + t4658 * t5642 - t1813 * t5860 - t1822 * t5868);
        t5881 = t1765 * t5868 - t1822 * t5879;
        t5885 = t1266 * t5860 - t1747 * t5881 - t1813 * t5879;
        t5888 = t4014 - t1747 * t3292;
        t5894 = t1853 * (t4650 - t1813 * t3292 - t1822 * t5888);
        t5896 = t1765 * t5888 - t1822 * t5894;
        t5900 = t1266 * t3292 - t1747 * t5896 - t1813 * t5894;
        t5904 = t5857 + t3374 * t5642 + t3334 * t5640;
        t5911 = t4043 * t5642 + t4024 * t5640 - t5863 - t1747 * t5904;
        t5921 = t1853
            * (t4676 * t5642 + t4658 * t5640 - t5871 - t1813 * t5904 - t1822 * t5911);
        t5923 = t1765 * t5911 - t1822 * t5921;
        t5927 = t1266 * t5904 - t1747 * t5923 - t1813 * t5921;
        t5932 = t3374 * t5715 - t3318 * t5718 - t3334 * t5715;
        t5940 = t4043 * t5715 + t4019 * t5718 - t4024 * t5715 - t1747 * t5932;
        t5951 = t1853
            * (t4676 * t5715 + t4654 * t5718 - t4658 * t5715 - t1813 * t5932
                - t1822 * t5940);
        t5953 = t1765 * t5940 - t1822 * t5951;
        t5957 = t1266 * t5932 - t1747 * t5953 - t1813 * t5951;
        t5960 = t1357 * t1421 - t1385 * t1417;
        t5964 = t1388 * t1417 + t1348 * t1421;
        t5975 = t1348 * t1385 + t1357 * t1388;
        t5979 = t323 * t3049 + t2302 * t5975 - t321 * t3030;
        t5984 = t3071 + t2278 * t5960 + t1097 * t2640 + t698 * t2834
            + self.constants[2] * t4782 + t334 * t3209;
        t5988 = t5984 + t5979 - t2325 * t5964 - self.constants[3] * t4757 - t332 * t3101;
        t6003 = t323 * t3876 + t3570 * t5975 - t321 * t3858;
        t6008 = t3892 + t3564 * t5960 + t1097 * t3674 + t698 * t3744
            + self.constants[2] * t4830 + t334 * t3978;
        t6013 = t6008 + t6003 - t3576 * t5964 - self.constants[3] * t4808 - t332 * t3920
            - t1747 * t5988;
        t6029 = t323 * t4514 + t4214 * t5975 - t321 * t4496;
        t6034 = t4528 + t4208 * t5960 + t1097 * t4314 + t698 * t4383
            + self.constants[2] * t4880 + t334 * t4614;
        t6040 = t6034 + t6029 - t4220 * t5964 - self.constants[3] * t4858 - t332 * t4556
            - t1813 * t5988 - t1822 * t6013;
        t6041 = t1853 * t6040;
        t6043 = t1765 * t6013 - t1822 * t6041;
        t6047 = t1266 * t5988 - t1747 * t6043 - t1813 * t6041;
        t6048 = self.constants[26] * self.constants[26];
        t6050 = self.constants[27] * self.constants[27];
        let (
            t6051, t6053, t6062, t6063, t6076, t6078, t6092, t6096, t6098, t6102, t6103, t6107,
            t6114, t6116, t6120, t6121, t6123, t6124, t6128, t6130, t6136, t6145, t6156, t6158,
            t6162, t6168, t6170, t6172, t6174, t6179, t6186, t6189, t6191, t6193, t6198, t6202,
            t6206, t6211, t6219, t6224, t6229, t6230, t6249, t6254, t6257, t6277, t6282, t6287,
            t6288, t6290, t6294, t6296, t6299, t6310, t6312, t6326, t6329, t6344, t6349, t6351,
            t6355,
        );
        t6051 = t6048 + t6050;
        t6053 = self.constants[26] * self.constants[27];
        t6062 = t5790 + t3374 * t6048 + t3292 * t6051 + t3318 * t6053 + t3334 * t6050
            + self.constants[27] * t3356;
        t6063 = t6062 + self.constants[26] * t3397;
        t6076 = t5812 + t4043 * t6048 + t4014 * t6051 + t4024 * t6050
            + self.constants[27] * t4034 + self.constants[26] * t4056;
        t6078 = t6076 - t4019 * t6053 - t1747 * t6063;
        t6092 = t5832 + t4676 * t6048 + t4650 * t6051 + t4658 * t6050
            + self.constants[27] * t4668 + self.constants[26] * t4688;
        t6096 = t1853 * (t6092 - t4654 * t6053 - t1813 * t6063 - t1822 * t6078);
        t6098 = t1765 * t6078 - t1822 * t6096;
        t6102 = t1266 * t6063 - t1747 * t6098 - t1813 * t6096;
        t6103 = t3334 + t3374;
        t6107 = t4024 + t4043 - t1747 * t6103;
        t6114 = t1853 * (t4658 + t4676 - t1813 * t6103 - t1822 * t6107);
        t6116 = t1765 * t6107 - t1822 * t6114;
        t6120 = t1266 * t6103 - t1747 * t6116 - t1813 * t6114;
        t6121 = t1357 * t1417;
        t6123 = t1348 * t1417;
        t6124 = cos_delta * t6123;
        t6128 = t12 * t6121 + t7 * t6124;
        t6130 = sin_delta * t6123;
        t6136 = t12 * t6124 + t1214 * t6128 + t1206 * t6130 - t7 * t6121 - t1253 * t1947;
        t6145 = t1712 * t6128 + t1710 * t6130 + t1736 * t1947 - t6121 - t1747 * t6136;
        t6156 = t1853
            * (t1781 * t6128 + t1800 * t1947 - t1779 * t6130 - t1813 * t6136
                - t1822 * t6145);
        t6158 = t1765 * t6145 - t1822 * t6156;
        t6162 = t1266 * t6136 - t1747 * t6158 - t1813 * t6156;
        t6168 = sin_phi * t2937;
        t6170 = t343 * t2937;
        t6172 = sin_phi * t1861;
        t6174 = sin_phi * t1899;
        t6179 = t7 * t6172 + t12 * t6174 + t343 * t5275 - t5274;
        t6186 = t5280 + t12 * t6172 - t7 * t6174 - t343 * t5281;
        t6189 = t5284 - t343 * t1861;
        t6191 = sin_phi * t1296;
        t6193 = sin_phi * t1330;
        t6198 = t7 * t6193 - t5280 - t12 * t6191 - t343 * t5279;
        t6202 = t7 * t6191 + t12 * t6193;
        t6206 = t5291 - sin_delta * t6202 - t343 * t5294;
        t6211 = cos_delta * t6202 - t5299 - t343 * t5302;
        t6219 = sin_phi * (t12 * t1982 - t7 * t2007) + t343 * t5267 + t1214 * t6168
            + t2096 * t6179;
        t6224 = t6219 + t2278 * t6198 + t2302 * t6206 + t2325 * t6211 + t346 * t3101
            - t5322;
        t6229 = t6224 - t1206 * t6170 - t2113 * t6186 - t2676 * t6189 - t1114 * t2634
            - t712 * t2828;
        t6230 = t6229 - t348 * t3209;
        t6249 = t1712 * t6168 + t3476 * t6179 + t3487 * t6186 + t3680 * t6189
            + t3564 * t6198 + t3570 * t6206;
        t6254 = t6249 + t3576 * t6211 + t346 * t3920 - t5364 - t1710 * t6170
            - t1114 * t3668;
        t6257 = t6254 - t712 * t3737 - t348 * t3978 - t1747 * t6230;
        t6277 = t1781 * t6168 + t1779 * t6170 + t4122 * t6179 + t4133 * t6186
            + t4320 * t6189 + t4208 * t6198;
        t6282 = t6277 + t4214 * t6206 + t4220 * t6211 + t346 * t4556 - t5407 - t6170;
        t6287 = t6282 - t1114 * t4310 - t712 * t4377 - t348 * t4614 - t1813 * t6230
            - t1822 * t6257;
        t6288 = t1853 * t6287;
        t6290 = t1765 * t6257 - t1822 * t6288;
        t6294 = t1266 * t6230 - t1747 * t6290 - t1813 * t6288;
        t6296 = t39 * t1378 - t5960;
        t6299 = t5964 - t39 * t1374;
        t6310 = t2278 * t6296 + t2325 * t6299 + t1123 * t2640 + t719 * t2834
            + t358 * t3209 - t5979;
        t6312 = t6310 - t354 * t3071 - t356 * t3101;
        t6326 = t3564 * t6296 + t3576 * t6299 + t1123 * t3674 + t719 * t3744
            + t358 * t3978 - t6003;
        t6329 = t6326 - t354 * t3892 - t356 * t3920 - t1747 * t6312;
        t6344 = t4208 * t6296 + t4220 * t6299 + t1123 * t4314 + t719 * t4383
            + t358 * t4614 - t6029;
        t6349 = t1853
            * (t6344 - t354 * t4528 - t356 * t4556 - t1813 * t6312 - t1822 * t6329);
        t6351 = t1765 * t6329 - t1822 * t6349;
        t6355 = t1266 * t6312 - t1747 * t6351 - t1813 * t6349;
        [
            [
                t216, t235, t296, zero, t320, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, t339, zero, zero, zero, t353, t361,
            ],
            [
                t406, t417, t428, zero, t439, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, t450, zero, zero, zero, t458, t462,
            ],
            [
                t654, t670, t681, zero, t697, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, t711, zero, zero, zero, t718, t725,
            ],
            [
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                t767, t778, t789, zero, t798, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, t809, zero, zero, zero, t813, t817,
            ],
            [
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                t1042, t1062, t1073, zero, t1096, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, zero, t1113, zero, zero, zero,
                t1122, t1133,
            ],
            [
                t4733, t4898, t5230, t5260, t5431, t5458, t5476, t5510, t5534, t5549, t5639, t5672,
                t5687, t5714, t5746, t5761, t5785, t5855, t5885, t5900, t5927, t5957, t6047, t6102,
                t6120, t6162, t6294, t6355,
            ],
            [
                t4729, t4894, t5226, t5256, t5427, t5454, t5472, t5506, t5530, t5545, t5635, t5668,
                t5683, t5710, t5742, t5757, t5781, t5851, t5881, t5896, t5923, t5953, t6043, t6098,
                t6116, t6158, t6290, t6351,
            ],
            [
                t4727, t4892, t5224, t5254, t5425, t5452, t5470, t5504, t5528, t5543, t5633, t5666,
                t5681, t5708, t5740, t5755, t5779, t5849, t5879, t5894, t5921, t5951, t6041, t6096,
                t6114, t6156, t6288, t6349,
            ],
        ]
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`WhippleTyres`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleTyresDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 130],
}

impl<T: Number> WhippleTyres<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 114 additions, 194 multiplications, 3 divisions, 3 negations and 2 trigonometric functions: 316 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WhippleTyresMatrices<T>, WhippleTyresDerivatives<T>) {
        let zero = self.w.like(0.0);
        let mut matrices = WhippleTyresMatrices::from_entries([zero; 16]);
        let mut derivatives = WhippleTyresDerivatives {
            values: [zero; 130],
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
        matrices: &mut WhippleTyresMatrices<T>,
        derivatives: &mut WhippleTyresDerivatives<T>,
    ) {
        *matrices = WhippleTyresMatrices::from_entries([self.w.like(0.0); 16]);
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
        put_derivative(0, self.mR);
        put_derivative(1, self.mB);
        put_derivative(2, self.mH);
        put_derivative(3, self.mF);
        put_derivative(4, self.w.like(1.0));
        let (wx_delta2_delta, wx_delta2_delta_lam) = self.lam.sin_cos();
        put_derivative(5, wx_delta2_delta);
        let t29 = self.rR * self.mR;
        let t30 = self.rF * self.mF;
        let C1_22_wz_delta2_delta = self.rF * t30;
        let t33 = self.IFxx + self.IHxx + C1_22_wz_delta2_delta;
        let M_11_mH = self.zH * self.zH;
        put_derivative(6, M_11_mH);
        let M_11_mB = self.zB * self.zB;
        put_derivative(7, M_11_mB);
        let M_11_rR = t29 + t29;
        put_derivative(8, M_11_rR);
        let M_11_mR = self.rR * self.rR;
        put_derivative(9, M_11_mR);
        let M_11 = self.rR * t29 + self.IRxx + self.IBxx + t33 + self.mH * M_11_mH
            + self.mB * M_11_mB;
        put_entry(0, M_11);
        let t46 = self.mB * self.zB;
        let t48 = self.IBxz - t46 * self.xB;
        let K0_11_mR = self.rhoR - self.rR;
        put_derivative(10, K0_11_mR);
        let M_11_zB = t46 + t46;
        put_derivative(11, M_11_zB);
        let M_11_rF = t30 + t30;
        put_derivative(12, M_11_rF);
        let K0_11_mF = self.rhoF - self.rF;
        put_derivative(13, K0_11_mF);
        let t53 = self.w.like(1.0) / self.w;
        let t54 = self.mH * self.zH;
        let t57 = t29 + t30 - t46 - t54;
        let M_11_zH = t54 + t54;
        put_derivative(14, M_11_zH);
        let t59 = self.c + self.w;
        let t60 = self.IFxx + self.IHzz;
        let ay_all1_delta = self.mH * self.xH;
        let t62 = self.c * t53;
        let t63 = self.mB * self.xB;
        let t64 = t48 + self.IHxz;
        let t66 = t64 - t54 * self.xH;
        let t67 = self.w.like(1.0) / self.rF;
        let t68 = self.w.like(1.0) / self.rR;
        let t69 = t30 * t59;
        let t71 = t53 * (ay_all1_delta + t63);
        let h_spin_F = self.IFyy * t67;
        let t73 = self.IRyy * t68;
        let t74 = self.c + self.xH;
        let t76 = t53 * (self.rhoF - self.rhoR);
        let t77 = self.xB + self.c;
        let t78 = t71 * t76;
        put_derivative(15, t78);
        let K0_11_xB = self.mB * t76;
        put_derivative(16, K0_11_xB);
        let K0_11_mB = self.zB + self.rhoR + self.xB * t76;
        put_derivative(17, K0_11_mB);
        let K0_11_xH = self.mH * t76;
        put_derivative(18, K0_11_xH);
        let K0_11_mH = self.zH + self.rhoR + self.xH * t76;
        put_derivative(19, K0_11_mH);
        let t87 = self.mF * wx_delta2_delta;
        put_derivative(20, t87);
        let yaw_per_v_delta = wx_delta2_delta_lam * t53;
        put_derivative(21, yaw_per_v_delta);
        let t89 = self.zH * wx_delta2_delta;
        let t90 = self.IHxz * wx_delta2_delta;
        let h_wheels_all = h_spin_F + t73;
        let t92 = wx_delta2_delta_lam * h_spin_F;
        let vy_all1_delta = h_wheels_all + t57;
        let t94 = t53 * wx_delta2_delta;
        let K0_11_rhoF = self.mF + t71;
        put_derivative(22, K0_11_rhoF);
        let t96 = self.rhoF * K0_11_rhoF;
        let K0_12_rhoF = wx_delta2_delta * K0_11_rhoF;
        put_derivative(23, K0_12_rhoF);
        let t98 = yaw_per_v_delta * t54;
        put_derivative(24, t98);
        let K0_22_rhoF = wx_delta2_delta * K0_12_rhoF;
        put_derivative(25, K0_22_rhoF);
        let t100 = self.rhoF * K0_12_rhoF;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        put_derivative(26, yaw_by_delta);
        let t103 = t89 + wx_delta2_delta_lam * t59;
        let t104 = vy_all1_delta * t94;
        put_derivative(27, t104);
        let t108 = yaw_per_v_delta * (self.IRxx + self.IBzz + self.xB * t63);
        let t109 = t46 * yaw_by_delta;
        put_derivative(28, t109);
        let C1_21 = -(t92 + yaw_by_delta * h_wheels_all);
        put_entry(4, C1_21);
        let wz_delta2_delta = wx_delta2_delta_lam + yaw_by_delta;
        put_derivative(29, wz_delta2_delta);
        let t117 = t30 * self.w + t66 + self.c * vy_all1_delta;
        let K2_12 = yaw_per_v_delta * vy_all1_delta;
        put_entry(9, K2_12);
        put_derivative(30, K2_12);
        let t119 = t53 * K2_12;
        put_derivative(31, t119);
        let t120 = yaw_per_v_delta * t66;
        let t121 = wz_delta2_delta * t54;
        put_derivative(32, t121);
        let t123 = t103 - wz_delta2_delta * self.xH;
        let t124 = self.xB * yaw_by_delta;
        let t125 = self.zB * t124;
        put_derivative(33, t125);
        let M_22_mB = t124 * t124;
        put_derivative(34, M_22_mB);
        let t127 = self.mB * t124;
        put_derivative(35, t127);
        let t128 = self.mH - t71;
        let K0_11_rhoR = self.mR + self.mB + t128;
        put_derivative(36, K0_11_rhoR);
        let K0_12_c = wx_delta2_delta_lam * t128;
        put_derivative(37, K0_12_c);
        let K0_22_c = wx_delta2_delta * K0_12_c;
        put_derivative(38, K0_22_c);
        let t133 = yaw_per_v_delta * K0_12_c;
        put_derivative(39, t133);
        let t134 = yaw_per_v_delta * t117;
        let t135 = t30 * wx_delta2_delta;
        let K0_11 = t96 + self.rhoR * K0_11_rhoR - t57;
        put_entry(6, K0_11);
        let t139 = t30 * wx_delta2_delta_lam;
        let M_12_mH = self.zH * t123;
        put_derivative(40, M_12_mH);
        let M_22_mH = t123 * t123;
        put_derivative(41, M_22_mH);
        let M_12_rF = t135 + t135;
        put_derivative(42, M_12_rF);
        let C1_12 = t134 + t92;
        put_entry(3, C1_12);
        let t145 = t53 * (t134 - t139);
        put_derivative(43, t145);
        let t150 = self.IHxz * wz_delta2_delta + t33 * wx_delta2_delta + t54 * t123;
        let t151 = wx_delta2_delta_lam * t54;
        let M_12_w = t151 - t62 * t120;
        put_derivative(44, M_12_w);
        let M_12_c = t120 + t151;
        put_derivative(45, M_12_c);
        let t158 = wz_delta2_delta * t60 + t90 - t123 * ay_all1_delta;
        let t159 = yaw_per_v_delta * t60;
        let t160 = self.mH * t123;
        let M_12_zH = t160 + self.mH * t89;
        put_derivative(46, M_12_zH);
        let t163 = yaw_per_v_delta * t123;
        put_derivative(47, t163);
        let t164 = t74 * t163;
        put_derivative(48, t164);
        let t165 = t160 - t127;
        let t166 = t135 - t165;
        let M_12 = t48 * yaw_by_delta + t150;
        put_entry(1, M_12);
        let K0_12 = t100 - t166;
        put_entry(7, K0_12);
        let t170 = t166 - t100;
        let t172 = t158 + self.c * t108;
        let t174 = t108 + t127 + t159;
        let t175 = yaw_by_delta * t127;
        let M_22_xB = t175 + t175;
        put_derivative(49, M_22_xB);
        let t177 = wx_delta2_delta * h_spin_F;
        let t179 = t177 + t117 * t94;
        put_derivative(50, t179);
        let t180 = t166 + t177;
        let K2_22 = yaw_per_v_delta * t180;
        put_entry(10, K2_22);
        let t182 = t53 * t180;
        let K0_22 = -(wx_delta2_delta * t170);
        put_entry(8, K0_22);
        let t185 = wx_delta2_delta_lam + wx_delta2_delta_lam;
        let t186 = yaw_per_v_delta * h_wheels_all;
        put_derivative(51, t186);
        let C1_21_w = t62 * t186;
        put_derivative(52, C1_21_w);
        let t191 = t158 + t59 * t160 + t62 * t172;
        let t192 = t53 * t172;
        let t193 = self.mH * wx_delta2_delta_lam;
        let t197 = yaw_per_v_delta * (t193 + t182 + yaw_by_delta * t71);
        put_derivative(53, t197);
        let t200 = t185 * (t62 * t192 - t160);
        put_derivative(54, t200);
        let M_22_c = t185 * (t160 + t192);
        put_derivative(55, M_22_c);
        let t206 = t69 * t94 + t192 - t62 * t165;
        let t207 = t74 * t193;
        let t208 = t135 - t207;
        let t209 = t53 * t207;
        put_derivative(56, t209);
        let t210 = t53 * t193;
        put_derivative(57, t210);
        let K2_22_xH = wz_delta2_delta * t210;
        put_derivative(58, K2_22_xH);
        let t212 = wx_delta2_delta * t210;
        put_derivative(59, t212);
        let t213 = wx_delta2_delta * t209;
        put_derivative(60, t213);
        let t214 = self.xH * t209;
        let C1_22_c = yaw_per_v_delta * (t208 + t174 + t214 - t165);
        put_derivative(61, C1_22_c);
        let M_22 = wx_delta2_delta_lam * t191 + wx_delta2_delta * t150;
        put_entry(2, M_22);
        let t223 = yaw_by_delta - t94 * self.rhoF;
        let K0_12_w = t193 + t71 * t223;
        put_derivative(62, K0_12_w);
        let t226 = self.c * t94;
        let C1_21_lam = t177 + h_wheels_all * t226;
        put_derivative(63, C1_21_lam);
        let C1_22 = wx_delta2_delta_lam * t206;
        put_entry(5, C1_22);
        let t231 = t206 + t62 * t174;
        let K2_22_h_spin_F = wx_delta2_delta_lam * t94;
        put_derivative(64, K2_22_h_spin_F);
        let K2_22_mF = self.rF * K2_22_h_spin_F;
        put_derivative(65, K2_22_mF);
        let K2_22_IFyy = t67 * K2_22_h_spin_F;
        put_derivative(66, K2_22_IFyy);
        let K0_12_zH = self.mH * wx_delta2_delta;
        put_derivative(67, K0_12_zH);
        let t240 = t151 + ay_all1_delta * (wx_delta2_delta + t226) - t59 * K0_12_zH;
        let K0_22_w = wx_delta2_delta * K0_12_w;
        put_derivative(68, K0_22_w);
        let t242 = wx_delta2_delta + wx_delta2_delta;
        let M_22_lam = t150 * t185 - t191 * t242;
        put_derivative(69, M_22_lam);
        let M_22_rF = t135 * t242;
        put_derivative(70, M_22_rF);
        let C1_22_w = yaw_per_v_delta * (t208 - t231 - t62 * t214);
        put_derivative(71, C1_22_w);
        let M_22_zH = t160 * t242;
        put_derivative(72, M_22_zH);
        let t253 = self.mR - t68 * t73;
        let C1_12_rR = yaw_by_delta * t253;
        put_derivative(73, C1_12_rR);
        let K2_12_rR = yaw_per_v_delta * t253;
        put_derivative(74, K2_12_rR);
        let K2_12_IRyy = yaw_per_v_delta * t68;
        put_derivative(75, K2_12_IRyy);
        let C1_12_IRyy = self.c * K2_12_IRyy;
        put_derivative(76, C1_12_IRyy);
        let C1_21_rR = t73 * C1_12_IRyy;
        put_derivative(77, C1_21_rR);
        let K2_12_mR = self.rR * yaw_per_v_delta;
        put_derivative(78, K2_12_mR);
        let C1_12_mR = self.c * K2_12_mR;
        put_derivative(79, C1_12_mR);
        let C1_22_IRxx = yaw_per_v_delta * yaw_by_delta;
        put_derivative(80, C1_22_IRxx);
        let M_22_IRxx = self.c * C1_22_IRxx;
        put_derivative(81, M_22_IRxx);
        let M_12_lam = t33 * wx_delta2_delta_lam + self.zH * t240 - t90 - t64 * t226;
        put_derivative(82, M_12_lam);
        let M_22_yaw_by_delta = wx_delta2_delta_lam * (self.IHxz + t69) - t74 * t240;
        let C1_22_lam = yaw_per_v_delta * M_22_yaw_by_delta
            - wx_delta2_delta * (t159 + t231);
        put_derivative(83, C1_22_lam);
        let t279 = t240 + t63 * t226 - t139;
        let K2_22_mB = self.xB * C1_22_IRxx;
        put_derivative(84, K2_22_mB);
        let C1_22_mB = t77 * K2_22_mB;
        put_derivative(85, C1_22_mB);
        let t282 = self.mB * yaw_per_v_delta;
        put_derivative(86, t282);
        let t283 = self.zB * t282;
        put_derivative(87, t283);
        let K2_22_xB = yaw_by_delta * t282;
        put_derivative(88, K2_22_xB);
        let C1_22_xB = (self.xB + t77) * K2_22_xB;
        put_derivative(89, C1_22_xB);
        let t287 = t282 * t77;
        put_derivative(90, t287);
        let t288 = self.mB * t223;
        put_derivative(91, t288);
        let t289 = wx_delta2_delta * t288;
        put_derivative(92, t289);
        let t290 = self.zB * yaw_per_v_delta;
        put_derivative(93, t290);
        let t291 = t77 * t290;
        put_derivative(94, t291);
        let t292 = self.xB * t223;
        put_derivative(95, t292);
        let K2_22_lam = yaw_per_v_delta * (t92 - t279) - wx_delta2_delta * t182;
        put_derivative(96, K2_22_lam);
        let K0_12_lam = wx_delta2_delta_lam * t96 + t279;
        put_derivative(97, K0_12_lam);
        let t299 = wx_delta2_delta * t292;
        put_derivative(98, t299);
        let t300 = wx_delta2_delta_lam + t223;
        let t301 = K0_12_zH * t300;
        put_derivative(99, t301);
        let t302 = self.mH * t300;
        put_derivative(100, t302);
        let K0_12_mH = t103 - self.xH * t300;
        put_derivative(101, K0_12_mH);
        let t305 = wz_delta2_delta + wz_delta2_delta;
        let t306 = t160 * t305;
        put_derivative(102, t306);
        let M_22_IHxz = wx_delta2_delta * t305;
        put_derivative(103, M_22_IHxz);
        let K0_22_mH = wx_delta2_delta * K0_12_mH;
        put_derivative(104, K0_22_mH);
        let C1_22_IHzz = yaw_per_v_delta * wz_delta2_delta;
        put_derivative(105, C1_22_IHzz);
        let C1_22_yaw_by_delta = t74 * C1_22_IHzz;
        let C1_22_xH = self.mH * (C1_22_yaw_by_delta - t163);
        put_derivative(106, C1_22_xH);
        let K2_22_yaw_by_delta = wx_delta2_delta * K0_12_lam;
        let K0_22_lam = K2_22_yaw_by_delta - wx_delta2_delta_lam * t170;
        put_derivative(107, K0_22_lam);
        let M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
        put_derivative(108, M_22_IHxx);
        let K0_22_zH = self.mH * M_22_IHxx;
        put_derivative(109, K0_22_zH);
        let t318 = self.mF * M_22_IHxx;
        put_derivative(110, t318);
        let t319 = self.zH * yaw_per_v_delta;
        put_derivative(111, t319);
        let t320 = t74 * t319;
        put_derivative(112, t320);
        let M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
        put_derivative(113, M_22_IHzz);
        let M_22_IFxx = M_22_IHxx + M_22_IHzz;
        put_derivative(114, M_22_IFxx);
        let C1_12_IFyy = wz_delta2_delta * t67;
        put_derivative(115, C1_12_IFyy);
        let C1_21_rF = h_spin_F * C1_12_IFyy;
        put_derivative(116, C1_21_rF);
        let K2_12_IFyy = yaw_per_v_delta * t67;
        put_derivative(117, K2_12_IFyy);
        let t326 = self.mF * yaw_per_v_delta;
        let K2_12_rF = t326 - h_spin_F * K2_12_IFyy;
        put_derivative(118, K2_12_rF);
        let t329 = t59 * t326;
        let C1_12_rF = t329 - C1_21_rF;
        put_derivative(119, C1_12_rF);
        let C1_22_rF = wx_delta2_delta * t329;
        put_derivative(120, C1_22_rF);
        let M_11_mF = self.rF * self.rF;
        put_derivative(121, M_11_mF);
        let M_22_mF = M_22_IHxx * M_11_mF;
        put_derivative(122, M_22_mF);
        let M_12_mF = wx_delta2_delta * M_11_mF;
        put_derivative(123, M_12_mF);
        let K2_12_mF = self.rF * yaw_per_v_delta;
        put_derivative(124, K2_12_mF);
        let C1_12_mF = t59 * K2_12_mF;
        put_derivative(125, C1_12_mF);
        let C1_22_mF = wx_delta2_delta * C1_12_mF;
        put_derivative(126, C1_22_mF);
        let t339 = wx_delta2_delta * (self.rF - self.rhoF);
        put_derivative(127, t339);
        let t340 = wx_delta2_delta * t339;
        put_derivative(128, t340);
        let t342 = -(wx_delta2_delta * K2_12_rF);
        put_derivative(129, t342);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl WhippleTyres<f64> {
    /// The parameter set `benchmark`.
    ///
    /// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; tyres are examples
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
    /// | `rhoR` | 0.02 | `m` |
    /// | `rhoF` | 0.02 | `m` |
    pub const BENCHMARK: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3141592653589793, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.0603,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.05892, IHyy: 0.06, IHzz: 0.00708, IHxz: -0.00756,
        rF: 0.35, mF: 3.0, IFxx: 0.1405, IFyy: 0.28, rhoR: 0.02, rhoF: 0.02,
    };

    /// The parameter set `benchmark_2005`.
    ///
    /// Source: Schwab, Meijaard & Papadopoulos (2005), ENOC 2005; tyres are examples
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
    /// | `rhoR` | 0.02 | `m` |
    /// | `rhoF` | 0.02 | `m` |
    pub const BENCHMARK_2005: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3217505543966422, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.06,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.0546, IHyy: 0.06, IHzz: 0.0114, IHxz: -0.0162, rF: 0.35,
        mF: 3.0, IFxx: 0.14, IFyy: 0.28, rhoR: 0.02, rhoF: 0.02,
    };
}

impl WhippleTyres<f64> {
    /// The parameter set `benchmark`.
    #[must_use]
    pub const fn default() -> Self {
        Self::BENCHMARK
    }
}

/// The parameter set `benchmark`.
impl<T: Scalar> Default for WhippleTyres<T> {
    fn default() -> Self {
        WhippleTyres::cast(&WhippleTyres::<f64>::BENCHMARK)
    }
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> WhippleTyres<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 28]) -> Self {
        Self {
            w: values[0], c: values[1], lam: values[2], g: values[3], rR: values[4], mR: values[5],
            IRxx: values[6], IRyy: values[7], xB: values[8], zB: values[9], mB: values[10],
            IBxx: values[11], IByy: values[12], IBzz: values[13], IBxz: values[14], xH: values[15],
            zH: values[16], mH: values[17], IHxx: values[18], IHyy: values[19], IHzz: values[20],
            IHxz: values[21], rF: values[22], mF: values[23], IFxx: values[24], IFyy: values[25],
            rhoR: values[26], rhoF: values[27],
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
            self.rhoR, self.rhoF,
        ]
    }
}

impl<T: Scalar> WhippleTyres<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> WhippleTyres<U> {
        let values = self.to_array();
        WhippleTyres::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl WhippleTyres<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> WhippleTyres<f32> {
        WhippleTyres::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<WhippleTyres<f32>> for WhippleTyres<f64> {
    fn from(parameters: WhippleTyres<f32>) -> Self {
        WhippleTyres::cast(&parameters)
    }
}

impl<T: Number> WhippleTyresMatrices<T> {
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
                self.m[1][1] = entry;
            }
            3 => {
                self.c1[0][1] = entry;
            }
            4 => {
                self.c1[1][0] = entry;
            }
            5 => {
                self.c1[1][1] = entry;
            }
            6 => {
                self.k0[0][0] = entry;
            }
            7 => {
                self.k0[0][1] = entry;
                self.k0[1][0] = entry;
            }
            8 => {
                self.k0[1][1] = entry;
            }
            9 => {
                self.k2[0][1] = entry;
            }
            10 => {
                self.k2[1][1] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, zeros, self.c1.0, zeros, self.k0.0, zeros, self.k2.0]
    }
}

impl<T: Scalar> From<WhippleTyresMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: WhippleTyresMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for WhippleTyres<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 28];

    type Over<U: Number> = WhippleTyres<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "WhippleTyres",
        docs: "The Whipple-Carvallo bicycle on tyres whose cross-sections are circles.\n\nFour rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally\nsymmetric. The rims of the wheels are parts of tori that roll without slip on level ground: the radii rR and rF of\nthe wheels reach from the centre to the ground, and those of the cross-sections, rhoR and rhoF, are parts of them.\nAxes: origin at the rear contact point, x forward, y to the right, z down.",
        source: "Mechanism: a bicycle on tyres with circular cross-sections, as in Meijaard & Schwab (2006), Linearized equations for an extended bicycle model, III European Conference on Computational Mechanics",
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
            ParameterInfo::new("rhoR", "m", Domain::NONNEGATIVE)
                .docs("Radius of the cross-section of the rear tyre."),
            ParameterInfo::new("rhoF", "m", Domain::NONNEGATIVE)
                .docs("Radius of the cross-section of the front tyre."),
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
                name: "benchmark",
                docs: "",
                source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; tyres are examples",
                values: &WhippleTyres::to_array(&WhippleTyres::<f64>::BENCHMARK),
            },
            SetInfo {
                name: "benchmark_2005",
                docs: "",
                source: "Schwab, Meijaard & Papadopoulos (2005), ENOC 2005; tyres are examples",
                values: &WhippleTyres::to_array(&WhippleTyres::<f64>::BENCHMARK_2005),
            },
        ],
        requirements: &[
            RequirementInfo::new("rR - rhoR", "m", Domain::NONNEGATIVE),
            RequirementInfo::new("rF - rhoF", "m", Domain::NONNEGATIVE),
        ],
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
            FormulaInfo::definition("m_all", "kg", "mR + mB + m_delta"),
            FormulaInfo::definition("load_spin_F", "kg", "-Sx_all/w"),
            FormulaInfo::definition("load_spin_R", "kg", "-(m_all + load_spin_F)"),
            FormulaInfo::definition("h_spin_R", "kg*m", "IRyy/rR"),
            FormulaInfo::definition("h_spin_F", "kg*m", "IFyy/rF"),
            FormulaInfo::definition("h_wheels_all", "kg*m", "h_spin_R + h_spin_F"),
            FormulaInfo::definition("M_yaw_delta", "kg*m^2", "py_delta*(w + c) + hz_delta"),
            FormulaInfo::definition("M_delta_delta", "kg*m^2", "hx_delta*sin(lam) + hz_delta*cos(lam)"),
            FormulaInfo::definition("K_phi_phi", "kg*m", "Sz_all - rhoR*load_spin_R - rhoF*load_spin_F"),
            FormulaInfo::definition("K_phi_delta", "kg*m", "-(py_delta + load_spin_F*(rhoF*sin(lam) - c*cos(lam)))"),
            FormulaInfo::definition(
                "K_delta_delta",
                "kg*m",
                "-(py_delta + load_spin_F*(rhoF*sin(lam) - c*cos(lam)))*sin(lam)",
            ),
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
                "yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_F*cos(lam)",
            ),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 0)], "kg*m", "-(yaw_by_delta*h_wheels_all + h_spin_F*cos(lam))"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 1)],
                "kg*m",
                "yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw",
            ),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "K_phi_phi"),
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
            FormulaInfo::attribute("B_Iyy", "the inertia yy of the rear frame and rider B", "kg*m^2", "IByy"),
            FormulaInfo::attribute("B_Izz", "the inertia zz of the rear frame and rider B", "kg*m^2", "IBzz"),
            FormulaInfo::attribute("H_mass", "the mass of the front frame H", "kg", "mH"),
            FormulaInfo::attribute("H_x", "x of the centre of mass of the front frame H", "m", "xH"),
            FormulaInfo::attribute("H_z", "z of the centre of mass of the front frame H", "m", "zH"),
            FormulaInfo::attribute("H_Ixx", "the inertia xx of the front frame H", "kg*m^2", "IHxx"),
            FormulaInfo::attribute("H_Ixz", "the inertia xz of the front frame H", "kg*m^2", "IHxz"),
            FormulaInfo::attribute("H_Iyy", "the inertia yy of the front frame H", "kg*m^2", "IHyy"),
            FormulaInfo::attribute("H_Izz", "the inertia zz of the front frame H", "kg*m^2", "IHzz"),
            FormulaInfo::attribute("R_mass", "the mass of the rear wheel R", "kg", "mR"),
            FormulaInfo::attribute("R_radius", "the radius of the rear wheel R", "m", "rR"),
            FormulaInfo::attribute("R_axial", "the axial inertia of the rear wheel R", "kg*m^2", "IRyy"),
            FormulaInfo::attribute("R_radial", "the radial inertia of the rear wheel R", "kg*m^2", "IRxx"),
            FormulaInfo::attribute("R_z", "z of the centre of the rear wheel R", "m", "-rR"),
            FormulaInfo::attribute("R_tyre", "the radius of the tyre of the rear wheel R", "m", "rhoR"),
            FormulaInfo::attribute("F_mass", "the mass of the front wheel F", "kg", "mF"),
            FormulaInfo::attribute("F_radius", "the radius of the front wheel F", "m", "rF"),
            FormulaInfo::attribute("F_axial", "the axial inertia of the front wheel F", "kg*m^2", "IFyy"),
            FormulaInfo::attribute("F_radial", "the radial inertia of the front wheel F", "kg*m^2", "IFxx"),
            FormulaInfo::attribute("F_x", "x of the centre of the front wheel F", "m", "w"),
            FormulaInfo::attribute("F_z", "z of the centre of the front wheel F", "m", "-rF"),
            FormulaInfo::attribute("F_tyre", "the radius of the tyre of the front wheel F", "m", "rhoF"),
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
                "Sz_all - load_spin_F*(F_tyre - (F_radius + F_z)) - load_spin_R*(R_tyre - (R_radius + R_z))",
            ),
            FormulaInfo::definition(
                "K_phi_delta",
                "kg*m",
                "-py_delta - load_spin_F*(F_tyre*delta_along_x + delta_along_z*(F_x - delta_through_x) - delta_along_x*(F_radius + F_z))/length_delta",
            ),
            FormulaInfo::definition(
                "K_delta_delta",
                "kg*m",
                "-delta_along_x*(length_delta*py_delta + load_spin_F*(F_tyre*delta_along_x + delta_along_z*(F_x - delta_through_x) - delta_along_x*(F_radius + F_z)))/length_delta^2",
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
        motion: Some(
            &MotionFormulas {
                constants: &[
                    "T0=1/sqrt(A28^2+A29^2);C4=A28*T0;C5=A29*T0;C6=C5*A27+C4*A18;C7=C4*A27-C5*A18;C8=A15-A19;T1=A24-A27",
                    "C9=C5*T1-C4*A25;C10=C4*T1+C5*A25;C11=A21-A26;C12=C7+C10;T2=A2-A18;T3=C5*A1-C4*T2;C13=A0*T3;T4=C4*A1+C5*T2",
                    "C14=A0*T4;T5=C5*A4;T6=C4*A3+T5;T7=C4*A4;T8=T7+C5*A6;C15=C5*T6-C4*T8-C13*T4;T9=T4*C14;T10=T3*C13",
                    "C16=A5+T9+T10;C17=A0+A14;C18=T9+A17+C5*(C5*A3-T7)-C4*(T5-C4*A6);C19=T10+A17+C4*T6+C5*T8;C20=A7+A20",
                    "T11=A8-A27;T12=C5*T11-C4*A9;T13=A7*T12;T14=C9*A20;C21=T13+T14;T15=C4*T11+C5*A9;T16=A7*T15;T17=C10*A20",
                    "C22=T16+T17;T18=C4*A11;T19=C5*A11;T20=T15*T16+C10*T17;C23=A23+C5*(C5*A10-T18)+T20-C4*(T19-C4*A13)",
                    "T21=T19+C4*A10;T22=T18+C5*A13;C24=C5*T21-C4*T22-T13*T15-C10*T14;T23=T12*T13+C9*T14;C25=T20+A12+T23",
                    "C26=A23+T23+C4*T21+C5*T22;C28=C23-C25;C29=C6*C20;T24=C7*C22;T25=C7*C20;C30=T24+T24+C7*T25;C31=C6*C22",
                    "C32=C7*C29;C33=C6*C29;C34=C17+C20;C35=C14+C22+T25;C0=A16;C1=A22;C2=A19;C3=A26;C27=P3",
                ],
                closure: &[
                    "T0=cos(Q3);T1=cos(Q5);T2=sin(Q4);T3=cos(Q4);T4=C5*T2+C4*T3;T5=T0*T4;T6=sin(Q3);T7=sin(Q5);T8=T6*T7",
                    "T9=T8-T1*T5;T10=C5*T3-T2*C4;T11=T0*T10;T12=sqrt(T9^2+T11^2);T13=C6+T1*C9",
                    "R0=C3+T12*C11+T8*C9+T0*(T10*C12-T4*T13)-C2-T0*C8;T14=1/T12;T15=T11*T14",
                    "T16=C11*(T1*T6+T5*T7)*(T0*T7*T15+T6*(T9*T10*T14+T1*T4*T15));R1=R0/(T0*(T16+T4*C12+T10*T13))",
                ],
                accelerations: &[
                    "T0=cos(Q3);T1=C8+C2*T0;T2=sin(Q3);T3=sin(Q4);T4=cos(Q4);T5=C5*T3+C4*T4;T6=cos(Q5);T7=T0*T5;T8=sin(Q5)",
                    "T9=T2*T8-T6*T7;T10=C5*T4-T3*C4;T11=T0*T10;T12=sqrt(T9^2+T11^2);T13=1/T12;T14=T9*T13;T15=T11*T13;T16=T6*T15",
                    "T17=T10*T16-T5*T14;T18=T2*T6+T7*T8;T19=T18*C11;T20=T8*C9;T21=C6+T6*C9;T22=T10*C12-T5*T21",
                    "T23=T0*T20-T17*T19-T2*T22;T24=C8*T2+T23;T25=T0*T8*T15+T2*(T10*T14+T5*T16);T26=T19*T25+T5*C12+T10*T21",
                    "T27=1/(T0*T26);T28=T24*T27;T29=T10*C7-T5*C6;T30=T23+T2*T29;T31=T2*T10;T32=T26-T5*C7-T10*C6",
                    "T33=T27*(T5*T30+T31*T32);R4=U0*T28+U1*T33;T34=U2+R4;T35=T1*T34;T36=cos(Q2);T37=C2*U0;T38=sin(Q2)",
                    "R1=T36*T37-T35*T38;T39=T2*T26;T40=T2*T24;T41=T17*T39+T25*T40;T42=1/(T17*T26+T24*T25);T43=T28*T41*T42",
                    "T44=C3+T12*C11+T2*T20+T0*T22-T0*T29;T45=T11*T32-T5*T44;T46=T31*T44+T11*T30;T47=T42*(T17*T45+T25*T46+T33*T41)",
                    "T48=T1*T25*T42;T49=U0*T43+U1*T47+U2*T48;T50=T25*T39-T17*T40;T51=T25*T26-T17*T24;T52=C11+T12*C3;T53=1/T52",
                    "T54=(T43*T51-T28*T50)*T53;T55=T53*(T17*T46+T47*T51-T25*T45-T33*T50);T56=T53*(T1*T17+T48*T51)",
                    "R7=U0*T54+U1*T55+U2*T56;T57=T0*T49;T58=U0*T57;T59=U0*T5-T10*T57;T60=T2*T49;T61=R4-T60;T62=C7*T61",
                    "T63=U0*T10+T5*T57;T64=C6*T61;T65=T59*T62+T63*T64;T66=U0*T60;T67=R4*T63;T68=T10*T66+T67;T69=R4*T59",
                    "T70=T5*T66+T69;T71=T34*T57;T72=C8*T60;T73=T57*T72-T1*T71;T74=T65+C6*T68+C7*T70-T73;T75=C6*T59-C7*T63",
                    "T76=T61*T64+T59*T75;T77=C8*U0;T78=T57*T77;T79=C2*T2;T80=U0*T34;T81=T78+T1*T58+T79*(T66+T80)",
                    "T82=T71*T79+T72*(T34-T60)-U0*T77;T83=T10*T81+T5*T82-T76-C7*T58;T84=U1+T59;T85=T6*T61-T8*T63;T86=C10*T85",
                    "T87=T6*T63+T8*T61;T88=C9*T85;T89=U1*T85;T90=T89-T6*T70-T8*T58;T91=T14*T52;T92=T68+R7*T87;T93=T15*T52",
                    "T94=T90-R7*T84;T95=T13*(T14*T87+T15*T84)*T19;T96=T15*T95;T97=T14*T95",
                    "T98=T6*T74+T84*T86+T87*T88+C9*T68+T91*T92+T84*T96;T99=T98+T87*T97-T8*T83-C10*T90-T93*T94;T100=C9*T84-C10*T87",
                    "T101=U1*T87;T102=T8*T70-T6*T58-T101;T103=T18*C3;T104=R7+T85;T105=C11*(T14*T84-T15*T87)",
                    "T106=T6*T83+T8*T74+C10*T102+T93*T102-T85*T88-T84*T100;T107=T106-T92*T103-T97*T104-T84*T105",
                    "T108=T63*T75-T61*T62;T109=T108+C6*T58+T5*T81+T87*T100+T94*T103+T87*T105",
                    "T110=T109-T10*T82-T85*T86-C9*T102-T91*T102-T96*T104;T111=T14*T107+T15*T110;T112=T27*(T18*T99+T12*T111)",
                    "T113=T42*(T12*T99+T41*T112-T18*T111);T114=T112-T58-T2*T113;T115=T82+T0*C27;T116=T66-T0*T113",
                    "T117=T1*T114-T78-T79*(T80+T116);T118=T10*T115+T5*T117;T119=T108-T118-C6*T114;T120=T69+T5*T116",
                    "T121=T6*T114+T8*T120-T101;T122=T84*C21-T87*C22;T123=T85*C22;T124=T119*C20+T87*T122-C21*T121-T85*T123",
                    "T125=T59*C13-C14*T63;T126=C14*T61;T127=T124+T63*T125-T118*C17-T114*C13-T61*T126;T128=T5*T115-T10*T117",
                    "T129=T128+C7*T114-T76;T130=T67+T10*T116;T131=T73+T2*C27;T132=T65+C6*T130+C7*T120-T131;T133=T6*T129+T8*T132",
                    "T134=T85*C21;T135=T133*C20+C22*T121-T85*T134-T84*T122;T136=T6*T132-T8*T129;T137=T89+T8*T114-T6*T120",
                    "T138=T136*C20+T130*C21+T84*T123+T87*T134-C22*T137;T139=T6*T135-T8*T138;T140=T61*C13",
                    "T141=T139+T128*C17+C14*T114-T61*T140-T59*T125;T142=T5*T127+T10*T141;T143=T114*C0-T1*T142;T144=T2*T48",
                    "T145=T63*C18+T59*C15;T146=T63*C15+T59*C19;T147=T87*C24+T84*C26;T148=T85*C25+T104*C1",
                    "T149=C23*T137+T130*C24+T85*T147-C22*T136-T84*T148;T150=T53*(T14*T110+T51*T113-T15*T107-T50*T112)",
                    "T151=C1*(T121+T150);T152=T87*C23+T84*C24;T153=C22*T133+C25*T121+T151+T84*T152-C21*T119-T87*T147",
                    "T154=C14*T128+C13*T118+T114*C16+T59*T145+T8*T149+T6*T153;T155=T154+C7*T139+T143-T63*T146-C6*T124;T156=T0*T48",
                    "T157=T61*C16+C0*(U2+T61);T158=T136*C21+T137*C24+T130*C26+T87*T148-T85*T152;T159=T8*T135+T6*T138",
                    "T160=C19*T130+T63*T157+T158+C6*T159-C13*T131-C15*T120;T161=T160-T61*T145",
                    "T162=C14*T131+C15*T130+T61*T146+T6*T149-C18*T120-T59*T157;T163=T162-T8*T153-C7*T159",
                    "T164=T10*T161+T79*T142-T5*T163;T165=T159+C13*T130+C14*T120+T59*T126+T63*T140-T131*C17;T166=T28-T2*T43",
                    "T167=T0*T43;T168=F0+T79*(T10*T127-T5*T141)+T164*T167-T5*T161;T169=T168-T10*T163-T1*T165-T155*T166-T54*T151",
                    "T170=T8*C21;T171=T8*C24-C7*T170;T172=T8*C28;T173=T6*T172-C6*T170;T174=T6*C21;T175=C13+T174+C29",
                    "T176=T5*C35+T10*T175;T177=T5*T171+T10*T173+T79*T176;T178=T6*C24-C7*T174;T179=C15+T178-C31-C32;T180=T8*T172",
                    "T181=C18+C23+C30-T180;T182=C6*T174;T183=T182+T182+C33;T184=C19+C26+T183;T185=T184-T181;T186=T5*T10;T187=T5^2",
                    "T188=T179+T179;T189=T179+T185*T186+T1*T176-T187*T188;T190=T10*C35-T5*T175;T191=T1*C34;T192=T1*(T190-T191)",
                    "T193=T1*T190;T194=T1*T191;T195=T194-T193-T193;T196=C16+C25+T180+C30+T183+T195;T197=T79*C34",
                    "T198=T10*T171+T79*T190+T1*T170-T5*T173-T1*T197;T199=T192+T144*T196+T156*T198;T200=T1*(T170-T197)",
                    "T201=T185*T187+T186*T188;T202=T79*T170;T203=T79*T197-T202-T202;T204=T184+T203-T201",
                    "T205=T200-T144*T198-T156*T204;T206=1.0-T144;T207=C0*T166;T208=T5*T8;T209=T56-T6*T144-T156*T208",
                    "T210=T54+T6*T166-T8*T10-T167*T208;T211=C1*T210",
                    "T212=T206*T207+T209*T211-T144*T177-T156*T189-T166*T199-T167*T205",
                    "T213=T181+T195+T201+T203+T166*T177+T166*(T177+T166*T196-T167*T198)+T166*T207",
                    "T214=T213+T210*T211-T167*T189-T167*(T189+T166*T198-T167*T204);T215=1/T214;T216=T212*T215;T217=T10*T170",
                    "T218=T1*T217;T219=T33-T2*T47;T220=T0*T47;T221=T171+T218;T222=C26+T182;T223=T10*T222-T5*T178-T79*T217",
                    "T224=C0*T219;T225=T55+T6*T219-T208*T220;T226=C1*T225;T227=T221+T196*T219-T198*T220",
                    "T228=T223+T198*T219-T204*T220;T229=T5*T222+T10*T178+T1*T174+T177*T219+T166*T227+T207*T219",
                    "T230=T215*(T229+T211*T225-T5*T202-T189*T220-T167*T228);T231=T214*T230",
                    "T232=T218+T206*T224+T209*T226-T199*T219-T205*T220-T144*T221",
                    "T233=C26+T219*T227+T219*T221+T219*T224+T225*T226-T220*T228;T234=T233-T220*T223-T230*T231;T235=1/T234",
                    "T236=(T232-T156*T223-T216*T231)*T235;T237=F1+T164*T220-T158-T155*T219-T55*T151-T169*T230",
                    "T238=T144*T155+T156*T164-T143-T56*T151-T169*T216-T236*T237",
                    "T239=T194+T144*T199+T144*T192+C0*T206*T206+C1*T209*T209-T156*T205",
                    "R14=T238/(T239-T156*T200-T214*T216*T216-T234*T236*T236);R13=T235*T237-T236*R14",
                    "R11=T169*T215-T230*R13-T216*R14;R12=T112+T28*R11+T33*R13;T240=T2*T34*T37+T37*T49-T1*(R14+R12)",
                    "T241=C2*R11+T35*T49;R8=T36*T240-T38*T241;R9=T38*T240+T36*T241;R15=T150+T54*R11+T55*R13+T56*R14",
                    "R0=-(T35*T36+T37*T38);R2=-T49;R10=-(T113+T43*R11+T47*R13+T48*R14);R3=U0;R5=U1;R6=U2",
                ],
            },
        ),
        gravity: Some(3),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("WhippleTyres", 28, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("WhippleTyres", 28, values)?;
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
        let t2 = self.rR - self.rhoR;
        let t5 = self.rF - self.rhoF;
        info.validate_requirements(&[Scalar::to_f64(t2), Scalar::to_f64(t5)])?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 2> {
        Coefficients::from_rows(WhippleTyresMatrices::rows(&self.matrices()))
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 2>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn nonlinear(&self) -> Option<impl carvallo::motion::Motion<Scalar = Self::Scalar>> {
        Some(self.motion())
    }

    fn shares(&self, force: usize) -> Option<[T; 2]> {
        (force < 2).then(|| self.kinematics().forces.map(|row| row[force]))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl WhippleTyres<f64> {
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
impl<T: Scalar> core::fmt::Display for WhippleTyres<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for WhippleTyres<T> {
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
            IFyy: parameter(25), rhoR: parameter(26), rhoF: parameter(27),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        WhippleTyresMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        WhippleTyresMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> WhippleTyresDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<WhippleTyresMatrices<T>> {
        if parameter >= 28 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = WhippleTyresMatrices {
            m: Rows([[zero; 2]; 2]), c1: Rows([[zero; 2]; 2]), k0: Rows([[zero; 2]; 2]),
            k2: Rows([[zero; 2]; 2]),
        };
        for position in 0..166 {
            let partial = <WhippleTyresDerivatives>::PARTIALS[position];
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

impl<T: Scalar> Differentiable<2> for WhippleTyres<T> {
    type Derivatives = [Coefficients<T, 2>; 28];

    type WithDerivativesOver<U: Number> = WhippleTyres<U>;

    const PARTIALS: &'static [Partial] = <WhippleTyresDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 28];
        for position in 0..166 {
            Partial::write(&<WhippleTyresDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(WhippleTyresMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for WhippleTyres<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl WhippleTyresDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 166] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 44),
        Partial::new(MatrixName::M, 1, 0, 0, 44),
        Partial::new(MatrixName::M, 1, 1, 0, 54).negative(),
        Partial::new(MatrixName::C1, 0, 1, 0, 43).negative(),
        Partial::new(MatrixName::C1, 1, 0, 0, 52),
        Partial::new(MatrixName::C1, 1, 1, 0, 71),
        Partial::new(MatrixName::K0, 0, 0, 0, 15).negative(),
        Partial::new(MatrixName::K0, 0, 1, 0, 62),
        Partial::new(MatrixName::K0, 1, 0, 0, 62),
        Partial::new(MatrixName::K0, 1, 1, 0, 68),
        Partial::new(MatrixName::K2, 0, 1, 0, 31).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 53).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 45), Partial::new(MatrixName::M, 1, 0, 1, 45),
        Partial::new(MatrixName::M, 1, 1, 1, 55), Partial::new(MatrixName::C1, 0, 1, 1, 30),
        Partial::new(MatrixName::C1, 1, 0, 1, 51).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 61), Partial::new(MatrixName::K0, 0, 1, 1, 37),
        Partial::new(MatrixName::K0, 1, 0, 1, 37), Partial::new(MatrixName::K0, 1, 1, 1, 38),
        Partial::new(MatrixName::K2, 1, 1, 1, 39).negative(),
        Partial::new(MatrixName::M, 0, 1, 2, 82),
        Partial::new(MatrixName::M, 1, 0, 2, 82),
        Partial::new(MatrixName::M, 1, 1, 2, 69),
        Partial::new(MatrixName::C1, 0, 1, 2, 50).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 63), Partial::new(MatrixName::C1, 1, 1, 2, 83),
        Partial::new(MatrixName::K0, 0, 1, 2, 97), Partial::new(MatrixName::K0, 1, 0, 2, 97),
        Partial::new(MatrixName::K0, 1, 1, 2, 107),
        Partial::new(MatrixName::K2, 0, 1, 2, 27).negative(),
        Partial::new(MatrixName::K2, 1, 1, 2, 96), Partial::new(MatrixName::M, 0, 0, 4, 8),
        Partial::new(MatrixName::C1, 0, 1, 4, 73), Partial::new(MatrixName::C1, 1, 0, 4, 77),
        Partial::new(MatrixName::K0, 0, 0, 4, 0).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 74), Partial::new(MatrixName::M, 0, 0, 5, 9),
        Partial::new(MatrixName::C1, 0, 1, 5, 79), Partial::new(MatrixName::K0, 0, 0, 5, 10),
        Partial::new(MatrixName::K2, 0, 1, 5, 78), Partial::new(MatrixName::M, 0, 0, 6, 4),
        Partial::new(MatrixName::M, 1, 1, 6, 81), Partial::new(MatrixName::C1, 1, 1, 6, 80),
        Partial::new(MatrixName::C1, 0, 1, 7, 76),
        Partial::new(MatrixName::C1, 1, 0, 7, 76).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 75),
        Partial::new(MatrixName::M, 0, 1, 8, 28).negative(),
        Partial::new(MatrixName::M, 1, 0, 8, 28).negative(),
        Partial::new(MatrixName::M, 1, 1, 8, 49),
        Partial::new(MatrixName::C1, 0, 1, 8, 87).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 89),
        Partial::new(MatrixName::K0, 0, 0, 8, 16),
        Partial::new(MatrixName::K0, 0, 1, 8, 91).negative(),
        Partial::new(MatrixName::K0, 1, 0, 8, 91).negative(),
        Partial::new(MatrixName::K0, 1, 1, 8, 92).negative(),
        Partial::new(MatrixName::K2, 1, 1, 8, 88), Partial::new(MatrixName::M, 0, 0, 9, 11),
        Partial::new(MatrixName::M, 0, 1, 9, 35).negative(),
        Partial::new(MatrixName::M, 1, 0, 9, 35).negative(),
        Partial::new(MatrixName::C1, 0, 1, 9, 90).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 1),
        Partial::new(MatrixName::K2, 0, 1, 9, 86).negative(),
        Partial::new(MatrixName::M, 0, 0, 10, 7),
        Partial::new(MatrixName::M, 0, 1, 10, 33).negative(),
        Partial::new(MatrixName::M, 1, 0, 10, 33).negative(),
        Partial::new(MatrixName::M, 1, 1, 10, 34),
        Partial::new(MatrixName::C1, 0, 1, 10, 94).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 85),
        Partial::new(MatrixName::K0, 0, 0, 10, 17),
        Partial::new(MatrixName::K0, 0, 1, 10, 95).negative(),
        Partial::new(MatrixName::K0, 1, 0, 10, 95).negative(),
        Partial::new(MatrixName::K0, 1, 1, 10, 98).negative(),
        Partial::new(MatrixName::K2, 0, 1, 10, 93).negative(),
        Partial::new(MatrixName::K2, 1, 1, 10, 84), Partial::new(MatrixName::M, 0, 0, 11, 4),
        Partial::new(MatrixName::M, 1, 1, 13, 81), Partial::new(MatrixName::C1, 1, 1, 13, 80),
        Partial::new(MatrixName::M, 0, 1, 14, 26), Partial::new(MatrixName::M, 1, 0, 14, 26),
        Partial::new(MatrixName::C1, 0, 1, 14, 21),
        Partial::new(MatrixName::M, 0, 1, 15, 32).negative(),
        Partial::new(MatrixName::M, 1, 0, 15, 32).negative(),
        Partial::new(MatrixName::M, 1, 1, 15, 102).negative(),
        Partial::new(MatrixName::C1, 0, 1, 15, 24).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 106),
        Partial::new(MatrixName::K0, 0, 0, 15, 18),
        Partial::new(MatrixName::K0, 0, 1, 15, 100).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 100).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 99).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 58), Partial::new(MatrixName::M, 0, 0, 16, 14),
        Partial::new(MatrixName::M, 0, 1, 16, 46), Partial::new(MatrixName::M, 1, 0, 16, 46),
        Partial::new(MatrixName::M, 1, 1, 16, 72),
        Partial::new(MatrixName::C1, 0, 1, 16, 56).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 60).negative(),
        Partial::new(MatrixName::K0, 0, 0, 16, 2), Partial::new(MatrixName::K0, 0, 1, 16, 67),
        Partial::new(MatrixName::K0, 1, 0, 16, 67), Partial::new(MatrixName::K0, 1, 1, 16, 109),
        Partial::new(MatrixName::K2, 0, 1, 16, 57).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 59).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 6), Partial::new(MatrixName::M, 0, 1, 17, 40),
        Partial::new(MatrixName::M, 1, 0, 17, 40), Partial::new(MatrixName::M, 1, 1, 17, 41),
        Partial::new(MatrixName::C1, 0, 1, 17, 112).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 48).negative(),
        Partial::new(MatrixName::K0, 0, 0, 17, 19), Partial::new(MatrixName::K0, 0, 1, 17, 101),
        Partial::new(MatrixName::K0, 1, 0, 17, 101), Partial::new(MatrixName::K0, 1, 1, 17, 104),
        Partial::new(MatrixName::K2, 0, 1, 17, 111).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 47).negative(),
        Partial::new(MatrixName::M, 0, 0, 18, 4), Partial::new(MatrixName::M, 0, 1, 18, 5),
        Partial::new(MatrixName::M, 1, 0, 18, 5), Partial::new(MatrixName::M, 1, 1, 18, 108),
        Partial::new(MatrixName::M, 1, 1, 20, 113), Partial::new(MatrixName::C1, 1, 1, 20, 105),
        Partial::new(MatrixName::M, 0, 1, 21, 29), Partial::new(MatrixName::M, 1, 0, 21, 29),
        Partial::new(MatrixName::M, 1, 1, 21, 103), Partial::new(MatrixName::C1, 0, 1, 21, 21),
        Partial::new(MatrixName::C1, 1, 1, 21, 64), Partial::new(MatrixName::M, 0, 0, 22, 12),
        Partial::new(MatrixName::M, 0, 1, 22, 42), Partial::new(MatrixName::M, 1, 0, 22, 42),
        Partial::new(MatrixName::M, 1, 1, 22, 70), Partial::new(MatrixName::C1, 0, 1, 22, 119),
        Partial::new(MatrixName::C1, 1, 0, 22, 116), Partial::new(MatrixName::C1, 1, 1, 22, 120),
        Partial::new(MatrixName::K0, 0, 0, 22, 3).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 20).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 20).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 110).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 118),
        Partial::new(MatrixName::K2, 1, 1, 22, 129).negative(),
        Partial::new(MatrixName::M, 0, 0, 23, 121), Partial::new(MatrixName::M, 0, 1, 23, 123),
        Partial::new(MatrixName::M, 1, 0, 23, 123), Partial::new(MatrixName::M, 1, 1, 23, 122),
        Partial::new(MatrixName::C1, 0, 1, 23, 125), Partial::new(MatrixName::C1, 1, 1, 23, 126),
        Partial::new(MatrixName::K0, 0, 0, 23, 13),
        Partial::new(MatrixName::K0, 0, 1, 23, 127).negative(),
        Partial::new(MatrixName::K0, 1, 0, 23, 127).negative(),
        Partial::new(MatrixName::K0, 1, 1, 23, 128).negative(),
        Partial::new(MatrixName::K2, 0, 1, 23, 124), Partial::new(MatrixName::K2, 1, 1, 23, 65),
        Partial::new(MatrixName::M, 0, 0, 24, 4), Partial::new(MatrixName::M, 0, 1, 24, 5),
        Partial::new(MatrixName::M, 1, 0, 24, 5), Partial::new(MatrixName::M, 1, 1, 24, 114),
        Partial::new(MatrixName::C1, 1, 1, 24, 105), Partial::new(MatrixName::C1, 0, 1, 25, 115),
        Partial::new(MatrixName::C1, 1, 0, 25, 115).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 117), Partial::new(MatrixName::K2, 1, 1, 25, 66),
        Partial::new(MatrixName::K0, 0, 0, 26, 36), Partial::new(MatrixName::K0, 0, 0, 27, 22),
        Partial::new(MatrixName::K0, 0, 1, 27, 23), Partial::new(MatrixName::K0, 1, 0, 27, 23),
        Partial::new(MatrixName::K0, 1, 1, 27, 25),
    ];
}
