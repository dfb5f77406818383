// @generated from generated/models/whipple_tyres.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 0fd874e368fb3457

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    FormulaInfo, LengthError, MatrixName, Model, ModelInfo, Nonlinear, Number,
    ParameterError, ParameterInfo, Partial, Rate, RequirementInfo, Rows, Scalar, SetInfo,
    WithDerivatives,
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
    /// 53 additions, 54 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 113 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleTyresMatrices<T> {
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
        let t43 = self.w.like(1.0) / self.w;
        let yaw_per_v_delta = cos_lam * t43;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let Sz_delta = t6 - t10;
        let Jxz_all = Jxz_delta + self.IBxz - t21 * self.xB - t35 * Sz_delta;
        let M_12 = hx_delta + yaw_by_delta * Jxz_all;
        let t57 = self.mH * t36;
        let t59 = self.mF * self.c;
        let t62 = self.IFxx + self.IHzz;
        let hz_delta = sin_lam * Jxz_delta + cos_lam * (t36 * t57 + self.c * t59 + t62);
        let t68 = t57 + t59;
        let t70 = sin_lam * Sz_delta + cos_lam * t68;
        let M_yaw_delta = hz_delta - t35 * t70;
        let t74 = self.mB * self.xB;
        let t85 = yaw_by_delta
            * (self.IRxx + t62 + self.IBzz + self.xB * t74 + self.mH * self.xH * self.xH
                + self.mF * self.w * self.w);
        let P_delta_yaw = M_yaw_delta + t85;
        let M_22 = yaw_by_delta * (M_yaw_delta + P_delta_yaw) + sin_lam * hx_delta
            + cos_lam * hz_delta;
        let zero = self.w.like(0.0);
        let h_spin_F = self.IFyy / self.rF;
        let h_wheels_all = h_spin_F + self.IRyy / self.rR;
        let Sz_all = t21 + Sz_delta - t17;
        let t101 = h_wheels_all - Sz_all;
        let t104 = cos_lam * h_spin_F;
        let C1_12 = yaw_by_delta * t101 + yaw_per_v_delta * Jxz_all + t104;
        let m_delta = self.mH + self.mF;
        let Sx_all = t74 + t35 * m_delta - t68;
        let P_delta_lateral = yaw_by_delta * Sx_all - t70;
        let C1_22 = yaw_by_delta * P_delta_lateral + yaw_per_v_delta * P_delta_yaw;
        let t119 = t43 * Sx_all;
        let K0_11 = Sz_all + self.rhoF * t119
            + self.rhoR * (self.mR + self.mB + m_delta - t119);
        let K_phi_delta = t70 + t119 * (sin_lam * self.rhoF - self.c * cos_lam);
        let K0_22 = sin_lam * K_phi_delta;
        let K2_12 = yaw_per_v_delta * t101;
        let K2_22 = yaw_per_v_delta * (P_delta_lateral + sin_lam * h_spin_F);
        let C1_21 = -(t104 + yaw_by_delta * h_wheels_all);
        WhippleTyresMatrices::from_entries([
            M_11, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, K0_11, K_phi_delta, K_phi_delta,
            K0_22, zero, K2_12, zero, K2_22,
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleTyresMotion<T = f64> {
    constants: [T; 36],
}

impl<T: Scalar> WhippleTyres<T> {
    /// The nonlinear equations of motion, of what is computed once for these parameters:
    /// 56 additions, 62 multiplications and 2 trigonometric functions: 120 operations.
    ///
    /// The parameters are not validated.
    #[must_use]
    pub fn motion(&self) -> WhippleTyresMotion<T> {
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t9 = self.w + self.c;
        let t13 = cos_lam * t9 - sin_lam * self.rR;
        let t16 = sin_lam * t9 + cos_lam * self.rR;
        let t17 = self.rR - self.rhoR;
        let t18 = self.w - t9;
        let t22 = cos_lam * t18 + sin_lam * self.rF;
        let t25 = sin_lam * t18 - cos_lam * self.rF;
        let t26 = self.rF - self.rhoF;
        let t27 = t16 + t25;
        let t32 = self.rR + self.zB;
        let t34 = cos_lam * self.xB - sin_lam * t32;
        let t35 = self.mB * t34;
        let t38 = sin_lam * self.xB + cos_lam * t32;
        let t39 = self.mB * t38;
        let t43 = cos_lam * self.IBxz;
        let t44 = sin_lam * self.IBxx + t43;
        let t46 = sin_lam * self.IBxz;
        let t49 = t46 + cos_lam * self.IBzz;
        let t53 = cos_lam * t44 - sin_lam * t49 - t35 * t38;
        let t55 = t38 * t39;
        let t56 = t34 * t35;
        let t58 = self.IByy + t55 + t56;
        let t60 = self.mB + self.mR;
        let t70 = t55 + self.IRxx + cos_lam * (cos_lam * self.IBxx - t46)
            - sin_lam * (t43 - sin_lam * self.IBzz);
        let t75 = t56 + self.IRxx + sin_lam * t44 + cos_lam * t49;
        let t78 = self.mH + self.mF;
        let t80 = self.xH - t9;
        let t84 = cos_lam * t80 - sin_lam * self.zH;
        let t85 = self.mH * t84;
        let t86 = t22 * self.mF;
        let t87 = t85 + t86;
        let t90 = sin_lam * t80 + cos_lam * self.zH;
        let t91 = self.mH * t90;
        let t92 = t25 * self.mF;
        let t93 = t91 + t92;
        let t98 = sin_lam * self.IHxz;
        let t101 = cos_lam * self.IHxz;
        let t108 = t90 * t91 + t25 * t92;
        let t111 = self.IFxx + cos_lam * (cos_lam * self.IHxx - t98) + t108
            - sin_lam * (t101 - sin_lam * self.IHzz);
        let t113 = t101 + sin_lam * self.IHxx;
        let t116 = t98 + cos_lam * self.IHzz;
        let t122 = cos_lam * t113 - sin_lam * t116 - t85 * t90 - t25 * t86;
        let t126 = t84 * t85 + t22 * t86;
        let t128 = t108 + self.IHyy + t126;
        let t133 = self.IFxx + t126 + sin_lam * t113 + cos_lam * t116;
        let t135 = t111 - t128;
        let t136 = t13 * t78;
        let t137 = t16 * t93;
        let t138 = t16 * t78;
        let t141 = t137 + t137 + t16 * t138;
        let t142 = t13 * t93;
        let t143 = t16 * t136;
        let t144 = t13 * t136;
        let t145 = t60 + t78;
        let t147 = t39 + t93 + t138;
        WhippleTyresMotion {
            constants: [
                sin_lam, cos_lam, self.IRyy, self.IFyy, self.rhoR, self.rhoF, t13, t16, t17, t22,
                t25, t26, t27, t35, t39, t53, t58, t60, t70, t75, t78, t87, t93, t111, t122, t128,
                t133, self.g, t135, t136, t141, t142, t143, t144, t145, t147,
            ],
        }
    }
}

impl<T: Scalar> Nonlinear<2> for WhippleTyres<T> {
    type Motion = WhippleTyresMotion<T>;

    fn motion(&self) -> WhippleTyresMotion<T> {
        WhippleTyres::motion(self)
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
                name: "Tphi",
                label: "lean torque",
                unit: "N*m",
            },
            carvallo::motion::AppliedInfo {
                name: "Tdelta",
                label: "steer torque",
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
impl<T: Scalar> carvallo::motion::Unchecked for WhippleTyresMotion<T> {
    type Scalar = T;

    type Positions = [T; 8];

    type Speeds = [T; 3];

    type Dependent = [T; 1];

    type Forces = [T; 2];

    type ContactForces = [[T; 3]; 2];

    fn closure_unchecked(&self, positions: &[T; 8]) -> ([T; 1], [T; 1]) {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t15 = self.constants[1] * sin_pitch + self.constants[0] * cos_pitch;
        let t16 = cos_phi * t15;
        let t20 = sin_phi * sin_delta;
        let t21 = t20 - cos_delta * t16;
        let t25 = self.constants[1] * cos_pitch - sin_pitch * self.constants[0];
        let t26 = cos_phi * t25;
        let t29 = (t21 * t21 + t26 * t26).sqrt();
        let t38 = self.constants[6] + cos_delta * self.constants[9];
        let t46 = self.constants[5] + t29 * self.constants[11] + t20 * self.constants[9]
            + cos_phi * (t25 * self.constants[12] - t15 * t38) - self.constants[4]
            - cos_phi * self.constants[8];
        let t50 = self.constants[0].like(1.0) / t29;
        let t51 = t26 * t50;
        let t62 = self.constants[11] * (cos_delta * sin_phi + t16 * sin_delta)
            * (cos_phi * sin_delta * t51
                + sin_phi * (t21 * t25 * t50 + cos_delta * t15 * t51));
        let t68 = t46 / (cos_phi * (t62 + t15 * self.constants[12] + t25 * t38));
        ([t46], [t68])
    }

    fn rates_unchecked(&self, positions: &[T; 8], speeds: &[T; 3]) -> [T; 8] {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t5 = self.constants[8] + self.constants[4] * cos_phi;
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t17 = self.constants[1] * sin_pitch + self.constants[0] * cos_pitch;
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t20 = cos_phi * t17;
        let t24 = sin_phi * sin_delta - cos_delta * t20;
        let t28 = self.constants[1] * cos_pitch - sin_pitch * self.constants[0];
        let t29 = cos_phi * t28;
        let t32 = (t24 * t24 + t29 * t29).sqrt();
        let t33 = self.constants[0].like(1.0) / t32;
        let t34 = t24 * t33;
        let t36 = t29 * t33;
        let t37 = cos_delta * t36;
        let t39 = t28 * t37 - t17 * t34;
        let t44 = (sin_phi * cos_delta + t20 * sin_delta) * self.constants[11];
        let t47 = sin_delta * self.constants[9];
        let t53 = self.constants[6] + cos_delta * self.constants[9];
        let t55 = t28 * self.constants[12] - t17 * t53;
        let t58 = cos_phi * t47 - t39 * t44 - sin_phi * t55;
        let t59 = self.constants[8] * sin_phi + t58;
        let t66 = cos_phi * sin_delta * t36 + sin_phi * (t28 * t34 + t17 * t37);
        let t71 = t44 * t66 + t17 * self.constants[12] + t28 * t53;
        let t73 = self.constants[0].like(1.0) / (cos_phi * t71);
        let t74 = t59 * t73;
        let t80 = t28 * self.constants[7] - t17 * self.constants[6];
        let t82 = t58 + sin_phi * t80;
        let t84 = sin_phi * t28;
        let t88 = t71 - t17 * self.constants[7] - t28 * self.constants[6];
        let t91 = t73 * (t17 * t82 + t84 * t88);
        let t93 = speeds[0] * t74 + speeds[1] * t91;
        let t95 = t5 * (speeds[2] + t93);
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let t99 = self.constants[4] * speeds[0];
        let t105 = cos_psi * t99 - t95 * sin_psi;
        let t106 = sin_phi * t71;
        let t108 = sin_phi * t59;
        let t110 = t39 * t106 + t66 * t108;
        let t114 = self.constants[0].like(1.0) / (t39 * t71 + t59 * t66);
        let t116 = t74 * t110 * t114;
        let t127 = self.constants[5] + t32 * self.constants[11] + sin_phi * t47
            + cos_phi * t55 - cos_phi * t80;
        let t129 = t29 * t88 - t17 * t127;
        let t133 = t84 * t127 + t29 * t82;
        let t138 = t114 * (t39 * t129 + t66 * t133 + t91 * t110);
        let t141 = t5 * t66 * t114;
        let t147 = t66 * t106 - t39 * t108;
        let t151 = t66 * t71 - t39 * t59;
        let t156 = self.constants[0].like(1.0)
            / (self.constants[11] + t32 * self.constants[5]);
        let t173 = speeds[0] * (t116 * t151 - t74 * t147) * t156
            + speeds[1] * t156 * (t39 * t133 + t138 * t151 - t66 * t129 - t91 * t147);
        let t174 = t173 + speeds[2] * t156 * (t5 * t39 + t141 * t151);
        let t175 = -(t95 * cos_psi + t99 * sin_psi);
        let t176 = -(speeds[0] * t116 + speeds[1] * t138 + speeds[2] * t141);
        [t175, t105, t176, speeds[0], t93, speeds[1], speeds[2], t174]
    }

    fn derivatives_unchecked(&self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2]) -> ([T; 8], [T; 3]) {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t5 = self.constants[8] + self.constants[4] * cos_phi;
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t17 = self.constants[1] * sin_pitch + self.constants[0] * cos_pitch;
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t20 = cos_phi * t17;
        let t24 = sin_phi * sin_delta - cos_delta * t20;
        let t28 = self.constants[1] * cos_pitch - sin_pitch * self.constants[0];
        let t29 = cos_phi * t28;
        let t32 = (t24 * t24 + t29 * t29).sqrt();
        let t33 = self.constants[0].like(1.0) / t32;
        let t34 = t24 * t33;
        let t36 = t29 * t33;
        let t37 = cos_delta * t36;
        let t39 = t28 * t37 - t17 * t34;
        let t42 = sin_phi * cos_delta + t20 * sin_delta;
        let t44 = t42 * self.constants[11];
        let t47 = sin_delta * self.constants[9];
        let t53 = self.constants[6] + cos_delta * self.constants[9];
        let t55 = t28 * self.constants[12] - t17 * t53;
        let t58 = cos_phi * t47 - t39 * t44 - sin_phi * t55;
        let t59 = self.constants[8] * sin_phi + t58;
        let t66 = cos_phi * sin_delta * t36 + sin_phi * (t28 * t34 + t17 * t37);
        let t71 = t44 * t66 + t17 * self.constants[12] + t28 * t53;
        let t73 = self.constants[0].like(1.0) / (cos_phi * t71);
        let t74 = t59 * t73;
        let t80 = t28 * self.constants[7] - t17 * self.constants[6];
        let t82 = t58 + sin_phi * t80;
        let t84 = sin_phi * t28;
        let t88 = t71 - t17 * self.constants[7] - t28 * self.constants[6];
        let t91 = t73 * (t17 * t82 + t84 * t88);
        let t93 = speeds[0] * t74 + speeds[1] * t91;
        let t94 = speeds[2] + t93;
        let t95 = t5 * t94;
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let t99 = self.constants[4] * speeds[0];
        let t105 = cos_psi * t99 - t95 * sin_psi;
        let t106 = sin_phi * t71;
        let t108 = sin_phi * t59;
        let t110 = t39 * t106 + t66 * t108;
        let t114 = self.constants[0].like(1.0) / (t39 * t71 + t59 * t66);
        let t116 = t74 * t110 * t114;
        let t127 = self.constants[5] + t32 * self.constants[11] + sin_phi * t47
            + cos_phi * t55 - cos_phi * t80;
        let t129 = t29 * t88 - t17 * t127;
        let t133 = t84 * t127 + t29 * t82;
        let t138 = t114 * (t39 * t129 + t66 * t133 + t91 * t110);
        let t141 = t5 * t66 * t114;
        let t144 = speeds[0] * t116 + speeds[1] * t138 + speeds[2] * t141;
        let t147 = t66 * t106 - t39 * t108;
        let t151 = t66 * t71 - t39 * t59;
        let t155 = self.constants[11] + t32 * self.constants[5];
        let t156 = self.constants[0].like(1.0) / t155;
        let t157 = (t116 * t151 - t74 * t147) * t156;
        let t166 = t156 * (t39 * t133 + t138 * t151 - t66 * t129 - t91 * t147);
        let t171 = t156 * (t5 * t39 + t141 * t151);
        let t174 = speeds[0] * t157 + speeds[1] * t166 + speeds[2] * t171;
        let t177 = cos_phi * t144;
        let t178 = t94 * t177;
        let t180 = sin_phi * t144;
        let t181 = self.constants[8] * t180;
        let t183 = t177 * t181 - t5 * t178;
        let t186 = t183 + sin_phi * self.constants[27];
        let t191 = speeds[0] * t17 - t28 * t177;
        let t192 = t93 * t191;
        let t193 = speeds[0] * t180;
        let t194 = t93 - t180;
        let t195 = self.constants[7] * t194;
        let t199 = speeds[0] * t28 + t17 * t177;
        let t200 = self.constants[6] * t194;
        let t202 = t191 * t195 + t199 * t200;
        let t204 = t93 * t199;
        let t205 = t28 * t193 + t204;
        let t208 = t192 + t17 * t193;
        let t212 = t202 + self.constants[6] * t205 + self.constants[7] * t208 - t183;
        let t217 = self.constants[6] * t191 - self.constants[7] * t199;
        let t219 = t194 * t200 + t191 * t217;
        let t220 = speeds[0] * t177;
        let t223 = self.constants[4] * sin_phi;
        let t224 = speeds[0] * t94;
        let t227 = self.constants[8] * speeds[0];
        let t228 = t177 * t227;
        let t230 = t5 * t220 + t223 * (t193 + t224) + t228;
        let t237 = t178 * t223 + t181 * (t94 - t180) - speeds[0] * t227;
        let t241 = t28 * t230 + t17 * t237 - t219 - self.constants[7] * t220;
        let t243 = speeds[1] + t191;
        let t247 = cos_delta * t194 - sin_delta * t199;
        let t248 = self.constants[10] * t247;
        let t252 = cos_delta * t199 + sin_delta * t194;
        let t253 = self.constants[9] * t247;
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
            + self.constants[9] * t205 + t262 * t264 + t243 * t275;
        let t287 = t283 + t252 * t277 - sin_delta * t241 - self.constants[10] * t260
            - t266 * t268;
        let t294 = self.constants[9] * t243 - self.constants[10] * t252;
        let t298 = speeds[1] * t252;
        let t300 = sin_delta * t208 - cos_delta * t220 - t298;
        let t303 = t42 * self.constants[5];
        let t305 = t174 + t247;
        let t310 = self.constants[11] * (t34 * t243 - t36 * t252);
        let t316 = cos_delta * t241 + sin_delta * t212 + self.constants[10] * t300
            + t266 * t300 - t247 * t253 - t243 * t294;
        let t319 = t316 - t264 * t303 - t277 * t305 - t243 * t310;
        let t323 = t199 * t217 - t194 * t195;
        let t338 = t323 + self.constants[6] * t220 + t17 * t230 + t252 * t294
            + t268 * t303 + t252 * t310;
        let t343 = t338 - t28 * t237 - t247 * t248 - self.constants[9] * t300
            - t262 * t300 - t275 * t305;
        let t345 = t34 * t319 + t36 * t343;
        let t350 = t73 * (t42 * t287 + t32 * t345);
        let t354 = t114 * (t32 * t287 + t110 * t350 - t42 * t345);
        let t356 = t193 - cos_phi * t354;
        let t358 = t192 + t17 * t356;
        let t362 = t204 + t28 * t356;
        let t369 = t194 * self.constants[16] + self.constants[2] * (speeds[2] + t194);
        let t374 = t199 * self.constants[18] + self.constants[15] * t191;
        let t381 = t202 + self.constants[6] * t362 + self.constants[7] * t358 - t186;
        let t385 = t350 - t220 - sin_phi * t354;
        let t391 = t5 * t385 - t228 - t223 * (t224 + t356);
        let t394 = t237 + cos_phi * self.constants[27];
        let t396 = t17 * t394 - t28 * t391;
        let t398 = self.constants[7] * t385 + t396 - t219;
        let t400 = cos_delta * t381 - sin_delta * t398;
        let t406 = t258 + sin_delta * t385 - cos_delta * t358;
        let t414 = t247 * self.constants[25] + t305 * self.constants[3];
        let t419 = t252 * self.constants[23] + t243 * self.constants[24];
        let t424 = self.constants[21] * t400 + self.constants[24] * t406
            + t362 * self.constants[26] + t252 * t414 - t247 * t419;
        let t428 = cos_delta * t398 + sin_delta * t381;
        let t434 = cos_delta * t385 + sin_delta * t358 - t298;
        let t436 = t247 * self.constants[21];
        let t440 = t243 * self.constants[21] - t252 * self.constants[22];
        let t444 = self.constants[20] * t428 + self.constants[22] * t434 - t247 * t436
            - t243 * t440;
        let t449 = t247 * self.constants[22];
        let t455 = t400 * self.constants[20] + t362 * self.constants[21] + t243 * t449
            + t252 * t436 - t406 * self.constants[22];
        let t457 = sin_delta * t444 + cos_delta * t455;
        let t463 = self.constants[19] * t362 + t199 * t369 + t424
            + self.constants[6] * t457 - self.constants[13] * t186
            - self.constants[15] * t358;
        let t464 = t463 - t194 * t374;
        let t472 = self.constants[15] * t199 + t191 * self.constants[19];
        let t480 = t252 * self.constants[24] + t243 * self.constants[26];
        let t486 = t406 * self.constants[23] + t362 * self.constants[24] + t247 * t480
            - t400 * self.constants[22] - t243 * t414;
        let t492 = t28 * t394 + t17 * t391;
        let t494 = t323 - self.constants[6] * t385 - t492;
        let t505 = t434 + t156 * (t34 * t343 + t151 * t354 - t36 * t319 - t147 * t350);
        let t506 = self.constants[3] * t505;
        let t513 = t428 * self.constants[22] + self.constants[25] * t434 + t506
            + t243 * t419 - self.constants[21] * t494 - t252 * t480;
        let t520 = t186 * self.constants[14] + self.constants[15] * t362 + t194 * t472
            + cos_delta * t486 - t358 * self.constants[18] - t191 * t369;
        let t522 = t520 - sin_delta * t513 - self.constants[7] * t457;
        let t529 = self.constants[13] * t191 - t199 * self.constants[14];
        let t531 = t194 * self.constants[14];
        let t539 = self.constants[20] * t494 + t252 * t440 - self.constants[21] * t434
            - t247 * t449;
        let t543 = t199 * t529 + t539 - t492 * self.constants[17]
            - self.constants[13] * t385 - t194 * t531;
        let t547 = self.constants[13] * t194;
        let t552 = cos_delta * t444 - sin_delta * t455;
        let t556 = t396 * self.constants[17] + t385 * self.constants[14] + t552
            - t194 * t547 - t191 * t529;
        let t569 = t457 + self.constants[13] * t362 + t358 * self.constants[14]
            + t191 * t531 + t199 * t547 - t186 * self.constants[17];
        let t572 = t74 - sin_phi * t116;
        let t585 = t17 * t543 + t28 * t556;
        let t587 = self.constants[2] * t385 - t5 * t585;
        let t592 = t396 * self.constants[14] + self.constants[13] * t492
            + self.constants[16] * t385 + t191 * t374 + sin_delta * t486
            + cos_delta * t513;
        let t596 = t592 + self.constants[7] * t552 + t587 - t199 * t472
            - self.constants[6] * t539;
        let t598 = cos_phi * t116;
        let t603 = t28 * t464 + t223 * t585 - t17 * t522;
        let t608 = forces[0] + t223 * (t28 * t543 - t17 * t556) + t598 * t603
            - t17 * t464;
        let t612 = t608 - t28 * t522 - t5 * t569 - t572 * t596 - t157 * t506;
        let t614 = sin_delta * self.constants[28];
        let t615 = sin_delta * t614;
        let t619 = self.constants[18] + self.constants[23] + self.constants[30] - t615;
        let t620 = cos_delta * self.constants[21];
        let t621 = self.constants[6] * t620;
        let t624 = t621 + t621 + self.constants[33];
        let t626 = self.constants[19] + self.constants[26] + t624;
        let t627 = t626 - t619;
        let t628 = t17 * t17;
        let t630 = t17 * t28;
        let t635 = cos_delta * self.constants[24] - self.constants[7] * t620;
        let t638 = self.constants[15] + t635 - self.constants[31] - self.constants[32];
        let t639 = t638 + t638;
        let t641 = t627 * t628 + t630 * t639;
        let t642 = sin_delta * self.constants[21];
        let t643 = t223 * t642;
        let t645 = t223 * self.constants[34];
        let t648 = t223 * t645 - t643 - t643;
        let t653 = self.constants[13] + t620 + self.constants[29];
        let t655 = t28 * self.constants[35] - t17 * t653;
        let t656 = t5 * t655;
        let t657 = t5 * self.constants[34];
        let t658 = t5 * t657;
        let t660 = t658 - t656 - t656;
        let t663 = sin_delta * self.constants[24] - self.constants[7] * t642;
        let t667 = cos_delta * t614 - self.constants[6] * t642;
        let t671 = t17 * self.constants[35] + t28 * t653;
        let t674 = t17 * t663 + t28 * t667 + t223 * t671;
        let t681 = t638 + t627 * t630 + t5 * t671 - t628 * t639;
        let t687 = self.constants[16] + self.constants[25] + t615 + self.constants[30]
            + t624 + t660;
        let t697 = t28 * t663 + t223 * t655 + t5 * t642 - t17 * t667 - t5 * t645;
        let t704 = t626 + t648 - t641;
        let t709 = self.constants[2] * t572;
        let t713 = t17 * sin_delta;
        let t717 = t157 + cos_delta * t572 - sin_delta * t28 - t598 * t713;
        let t718 = self.constants[3] * t717;
        let t725 = t619 + t641 + t648 + t660 + t572 * t674
            + t572 * (t674 + t572 * t687 - t598 * t697) + t572 * t709;
        let t728 = t725 + t717 * t718 - t598 * t681
            - t598 * (t681 + t572 * t697 - t598 * t704);
        let t729 = self.constants[0].like(1.0) / t728;
        let t731 = self.constants[26] + t621;
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
        let t779 = self.constants[2] * t737;
        let t781 = self.constants[3] * t763;
        let t783 = t728 * t774;
        let t789 = self.constants[26] + t737 * t747 + t737 * t743 + t737 * t779
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
        let t877 = t658 + t806 * t811 + t805 * t806 + self.constants[2] * t823 * t823
            + self.constants[3] * t828 * t828 - t808 * t818;
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

    fn accelerations_unchecked(&self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2]) -> [T; 8] {
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t15 = self.constants[1] * sin_pitch + self.constants[0] * cos_pitch;
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t19 = t15 * cos_phi;
        let t23 = sin_phi * sin_delta - cos_delta * t19;
        let t27 = self.constants[1] * cos_pitch - sin_pitch * self.constants[0];
        let t28 = cos_phi * t27;
        let t31 = (t23 * t23 + t28 * t28).sqrt();
        let t32 = self.constants[0].like(1.0) / t31;
        let t33 = t23 * t32;
        let t35 = t28 * t32;
        let t36 = cos_delta * t35;
        let t38 = t27 * t36 - t15 * t33;
        let t41 = sin_phi * cos_delta + t19 * sin_delta;
        let t43 = t41 * self.constants[11];
        let t46 = sin_delta * self.constants[9];
        let t52 = self.constants[6] + cos_delta * self.constants[9];
        let t54 = t27 * self.constants[12] - t15 * t52;
        let t57 = cos_phi * t46 - t38 * t43 - sin_phi * t54;
        let t58 = sin_phi * self.constants[8] + t57;
        let t65 = cos_phi * sin_delta * t35 + sin_phi * (t27 * t33 + t15 * t36);
        let t70 = t43 * t65 + t15 * self.constants[12] + t27 * t52;
        let t72 = self.constants[0].like(1.0) / (cos_phi * t70);
        let t73 = t58 * t72;
        let t79 = t27 * self.constants[7] - t15 * self.constants[6];
        let t81 = t57 + sin_phi * t79;
        let t83 = sin_phi * t27;
        let t87 = t70 - t15 * self.constants[7] - t27 * self.constants[6];
        let t90 = t72 * (t15 * t81 + t83 * t87);
        let t92 = speeds[0] * t73 + speeds[1] * t90;
        let t93 = speeds[2] + t92;
        let t95 = speeds[0] * self.constants[4];
        let t99 = self.constants[8] + cos_phi * self.constants[4];
        let t103 = self.constants[0].like(1.0) / (t38 * t70 + t58 * t65);
        let t104 = sin_phi * t70;
        let t106 = sin_phi * t58;
        let t108 = t38 * t104 + t65 * t106;
        let t110 = t73 * t103 * t108;
        let t121 = self.constants[5] + t31 * self.constants[11] + sin_phi * t46
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
        let t146 = self.constants[7] * t145;
        let t150 = speeds[0] * t27 + t15 * t139;
        let t151 = self.constants[6] * t145;
        let t153 = t143 * t146 + t150 * t151;
        let t154 = speeds[0] * t144;
        let t156 = t92 * t150;
        let t157 = t27 * t154 + t156;
        let t160 = t92 * t143;
        let t161 = t15 * t154 + t160;
        let t163 = t93 * t139;
        let t165 = self.constants[8] * t144;
        let t167 = t139 * t165 - t99 * t163;
        let t170 = t153 + self.constants[6] * t157 + self.constants[7] * t161 - t167;
        let t175 = self.constants[6] * t143 - self.constants[7] * t150;
        let t177 = t145 * t151 + t143 * t175;
        let t179 = speeds[0] * self.constants[8];
        let t180 = t139 * t179;
        let t182 = sin_phi * self.constants[4];
        let t183 = speeds[0] * t93;
        let t187 = t180 + t99 * t140 + t182 * (t154 + t183);
        let t194 = t163 * t182 + t165 * (t93 - t144) - speeds[0] * t179;
        let t198 = t27 * t187 + t15 * t194 - t177 - self.constants[7] * t140;
        let t200 = speeds[1] + t143;
        let t204 = cos_delta * t145 - sin_delta * t150;
        let t205 = self.constants[10] * t204;
        let t209 = cos_delta * t150 + sin_delta * t145;
        let t210 = self.constants[9] * t204;
        let t215 = speeds[1] * t204;
        let t217 = t215 - cos_delta * t161 - sin_delta * t140;
        let t220 = self.constants[11] + t31 * self.constants[5];
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
            + self.constants[9] * t157 + t221 * t251 + t200 * t262;
        let t274 = t270 + t209 * t264 - sin_delta * t198 - self.constants[10] * t217
            - t253 * t255;
        let t281 = self.constants[9] * t200 - self.constants[10] * t209;
        let t285 = speeds[1] * t209;
        let t287 = sin_delta * t161 - cos_delta * t140 - t285;
        let t290 = t41 * self.constants[5];
        let t292 = t204 + t249;
        let t297 = self.constants[11] * (t33 * t200 - t35 * t209);
        let t303 = cos_delta * t198 + sin_delta * t170 + self.constants[10] * t287
            + t253 * t287 - t204 * t210 - t200 * t281;
        let t306 = t303 - t251 * t290 - t264 * t292 - t200 * t297;
        let t310 = t150 * t175 - t145 * t146;
        let t325 = t310 + self.constants[6] * t140 + t15 * t187 + t209 * t281
            + t255 * t290 + t209 * t297;
        let t330 = t325 - t27 * t194 - t204 * t205 - self.constants[9] * t287
            - t221 * t287 - t262 * t292;
        let t332 = t33 * t306 + t35 * t330;
        let t335 = t72 * (t41 * t274 + t31 * t332);
        let t341 = t103 * (t31 * t274 + t108 * t335 - t41 * t332);
        let t344 = t335 - t140 - sin_phi * t341;
        let t349 = t194 + cos_phi * self.constants[27];
        let t353 = t154 - cos_phi * t341;
        let t357 = t99 * t344 - t180 - t182 * (t183 + t353);
        let t359 = t27 * t349 + t15 * t357;
        let t362 = t310 - t359 - self.constants[6] * t344;
        let t368 = t160 + t15 * t353;
        let t371 = cos_delta * t344 + sin_delta * t368 - t285;
        let t376 = t200 * self.constants[21] - t209 * self.constants[22];
        let t378 = t204 * self.constants[22];
        let t382 = t362 * self.constants[20] + t209 * t376 - self.constants[21] * t371
            - t204 * t378;
        let t390 = t143 * self.constants[13] - self.constants[14] * t150;
        let t392 = self.constants[14] * t145;
        let t397 = t382 + t150 * t390 - t359 * self.constants[17]
            - t344 * self.constants[13] - t145 * t392;
        let t401 = t15 * t349 - t27 * t357;
        let t404 = t401 + self.constants[7] * t344 - t177;
        let t407 = t156 + t27 * t353;
        let t411 = t167 + sin_phi * self.constants[27];
        let t414 = t153 + self.constants[6] * t407 + self.constants[7] * t368 - t411;
        let t416 = cos_delta * t404 + sin_delta * t414;
        let t419 = t204 * self.constants[21];
        let t424 = t416 * self.constants[20] + self.constants[22] * t371 - t204 * t419
            - t200 * t376;
        let t428 = cos_delta * t414 - sin_delta * t404;
        let t434 = t215 + sin_delta * t344 - cos_delta * t368;
        let t441 = t428 * self.constants[20] + t407 * self.constants[21] + t200 * t378
            + t209 * t419 - self.constants[22] * t434;
        let t443 = cos_delta * t424 - sin_delta * t441;
        let t446 = t145 * self.constants[13];
        let t452 = t443 + t401 * self.constants[17] + self.constants[14] * t344
            - t145 * t446 - t143 * t390;
        let t454 = t15 * t397 + t27 * t452;
        let t456 = t344 * self.constants[2] - t99 * t454;
        let t457 = sin_phi * t135;
        let t466 = t150 * self.constants[18] + t143 * self.constants[15];
        let t471 = t150 * self.constants[15] + t143 * self.constants[19];
        let t481 = t209 * self.constants[24] + t200 * self.constants[26];
        let t487 = t204 * self.constants[25] + t292 * self.constants[3];
        let t492 = self.constants[23] * t434 + t407 * self.constants[24] + t204 * t481
            - self.constants[22] * t428 - t200 * t487;
        let t504 = t231 * (t33 * t330 + t228 * t341 - t35 * t306 - t224 * t335);
        let t506 = self.constants[3] * (t371 + t504);
        let t509 = t209 * self.constants[23] + t200 * self.constants[24];
        let t516 = self.constants[22] * t416 + self.constants[25] * t371 + t506
            + t200 * t509 - self.constants[21] * t362 - t209 * t481;
        let t524 = self.constants[14] * t401 + self.constants[13] * t359
            + t344 * self.constants[16] + t143 * t466 + sin_delta * t492
            + cos_delta * t516;
        let t528 = t524 + self.constants[7] * t443 + t456 - t150 * t471
            - self.constants[6] * t382;
        let t530 = cos_phi * t135;
        let t537 = t145 * self.constants[16] + self.constants[2] * (speeds[2] + t145);
        let t548 = t428 * self.constants[21] + t434 * self.constants[24]
            + t407 * self.constants[26] + t209 * t487 - t204 * t509;
        let t551 = sin_delta * t424 + cos_delta * t441;
        let t557 = self.constants[19] * t407 + t150 * t537 + t548
            + self.constants[6] * t551 - self.constants[13] * t411
            - self.constants[15] * t368;
        let t558 = t557 - t145 * t466;
        let t572 = self.constants[14] * t411 + self.constants[15] * t407 + t145 * t471
            + cos_delta * t492 - self.constants[18] * t368 - t143 * t537;
        let t574 = t572 - sin_delta * t516 - self.constants[7] * t551;
        let t578 = t27 * t558 + t182 * t454 - t15 * t574;
        let t597 = t551 + self.constants[13] * t407 + self.constants[14] * t368
            + t143 * t392 + t150 * t446 - t411 * self.constants[17];
        let t600 = t73 - sin_phi * t110;
        let t602 = cos_phi * t110;
        let t607 = forces[0] + t182 * (t27 * t397 - t15 * t452) + t578 * t602
            - t15 * t558;
        let t611 = t607 - t27 * t574 - t99 * t597 - t528 * t600 - t232 * t506;
        let t613 = sin_delta * self.constants[21];
        let t615 = sin_delta * self.constants[24] - self.constants[7] * t613;
        let t618 = sin_delta * self.constants[28];
        let t621 = cos_delta * t618 - self.constants[6] * t613;
        let t625 = cos_delta * self.constants[21];
        let t628 = self.constants[13] + t625 + self.constants[29];
        let t630 = t15 * self.constants[35] + t27 * t628;
        let t633 = t15 * t615 + t27 * t621 + t182 * t630;
        let t639 = cos_delta * self.constants[24] - self.constants[7] * t625;
        let t642 = self.constants[15] + t639 - self.constants[31] - self.constants[32];
        let t643 = sin_delta * t618;
        let t647 = self.constants[18] + self.constants[23] + self.constants[30] - t643;
        let t648 = self.constants[6] * t625;
        let t651 = t648 + t648 + self.constants[33];
        let t653 = self.constants[19] + self.constants[26] + t651;
        let t654 = t653 - t647;
        let t655 = t15 * t27;
        let t657 = t15 * t15;
        let t658 = t642 + t642;
        let t663 = t642 + t654 * t655 + t99 * t630 - t657 * t658;
        let t667 = t27 * self.constants[35] - t15 * t628;
        let t669 = t99 * self.constants[34];
        let t671 = t99 * (t667 - t669);
        let t672 = t99 * t667;
        let t673 = t99 * t669;
        let t675 = t673 - t672 - t672;
        let t680 = self.constants[16] + self.constants[25] + t643 + self.constants[30]
            + t651 + t675;
        let t686 = t182 * self.constants[34];
        let t691 = t27 * t615 + t182 * t667 + t99 * t613 - t15 * t621 - t99 * t686;
        let t694 = t671 + t457 * t680 + t530 * t691;
        let t697 = t99 * (t613 - t686);
        let t701 = t654 * t657 + t655 * t658;
        let t702 = t182 * t613;
        let t705 = t182 * t686 - t702 - t702;
        let t707 = t653 + t705 - t701;
        let t710 = t697 - t457 * t691 - t530 * t707;
        let t713 = self.constants[0].like(1.0) - t457;
        let t714 = self.constants[2] * t600;
        let t717 = t15 * sin_delta;
        let t720 = t246 - cos_delta * t457 - t530 * t717;
        let t726 = t232 + cos_delta * t600 - sin_delta * t27 - t602 * t717;
        let t727 = self.constants[3] * t726;
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
        let t769 = self.constants[26] + t648;
        let t774 = t27 * t769 - t15 * t639 - t182 * t760;
        let t776 = self.constants[2] * t763;
        let t781 = t241 + cos_delta * t763 - t717 * t765;
        let t782 = self.constants[3] * t781;
        let t793 = t767 + t680 * t763 - t691 * t765;
        let t798 = t774 + t691 * t763 - t707 * t765;
        let t806 = t15 * t769 + t27 * t639 + t99 * t625 + t633 * t763 + t600 * t793
            + t714 * t763;
        let t811 = t757 * (t806 + t727 * t781 - t15 * t702 - t663 * t765 - t602 * t798);
        let t812 = t756 * t811;
        let t818 = t761 + t713 * t776 + t720 * t782 - t694 * t763 - t710 * t765
            - t457 * t767;
        let t832 = self.constants[26] + t763 * t793 + t763 * t767 + t763 * t776
            + t781 * t782 - t765 * t798;
        let t834 = t832 - t765 * t774 - t811 * t812;
        let t835 = self.constants[0].like(1.0) / t834;
        let t836 = (t818 - t530 * t774 - t758 * t812) * t835;
        let t846 = forces[1] + t578 * t765 - t548 - t528 * t763 - t241 * t506
            - t611 * t811;
        let t852 = t457 * t528 + t530 * t578 - t456 - t246 * t506 - t611 * t758
            - t836 * t846;
        let t869 = t673 + t457 * t694 + t457 * t671 + self.constants[2] * t713 * t713
            + self.constants[3] * t720 * t720 - t530 * t710;
        let t873 = t852 / (t869 - t530 * t697 - t756 * t758 * t758 - t834 * t836 * t836);
        let t877 = t835 * t846 - t836 * t873;
        let t881 = t611 * t757 - t811 * t877 - t758 * t873;
        let t885 = t335 + t73 * t881 + t90 * t877;
        let t890 = sin_phi * t93 * t95 + t95 * t138 - t99 * (t873 + t885);
        let t896 = self.constants[4] * t881 + t93 * t99 * t138;
        let t898 = cos_psi * t890 - sin_psi * t896;
        let t901 = t890 * sin_psi + cos_psi * t896;
        let t913 = t504 + t232 * t881 + t241 * t877 + t246 * t873;
        let t914 = -(t341 + t110 * t881 + t132 * t877 + t135 * t873);
        [t898, t901, t914, t881, t885, t877, t873, t913]
    }

    fn energy_unchecked(&self, positions: &[T; 8], speeds: &[T; 3]) -> [T; 2] {
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t6 = sin_delta * self.constants[28];
        let t7 = sin_delta * t6;
        let t11 = self.constants[18] + self.constants[23] + self.constants[30] - t7;
        let t17 = cos_delta * self.constants[21];
        let t18 = self.constants[6] * t17;
        let t21 = t18 + t18 + self.constants[33];
        let t23 = self.constants[19] + self.constants[26] + t21;
        let t24 = t23 - t11;
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t32 = self.constants[1] * sin_pitch + self.constants[0] * cos_pitch;
        let t33 = t32 * t32;
        let t37 = self.constants[1] * cos_pitch - sin_pitch * self.constants[0];
        let t38 = t32 * t37;
        let t46 = cos_delta * self.constants[24] - t17 * self.constants[7];
        let t49 = self.constants[15] + t46 - self.constants[31] - self.constants[32];
        let t50 = t49 + t49;
        let t52 = t24 * t33 + t38 * t50;
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t56 = self.constants[4] * sin_phi;
        let t57 = sin_delta * self.constants[21];
        let t58 = t56 * t57;
        let t60 = t56 * self.constants[34];
        let t63 = t56 * t60 - t58 - t58;
        let t67 = self.constants[8] + self.constants[4] * cos_phi;
        let t73 = t17 + self.constants[13] + self.constants[29];
        let t75 = t37 * self.constants[35] - t32 * t73;
        let t76 = t67 * t75;
        let t77 = self.constants[34] * t67;
        let t78 = t67 * t77;
        let t80 = t78 - t76 - t76;
        let t83 = sin_delta * self.constants[24] - self.constants[7] * t57;
        let t87 = t6 * cos_delta - self.constants[6] * t57;
        let t91 = t32 * self.constants[35] + t37 * t73;
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
        let t116 = (cos_delta * sin_phi + sin_delta * t96) * self.constants[11];
        let t119 = sin_delta * self.constants[9];
        let t124 = self.constants[6] + cos_delta * self.constants[9];
        let t126 = t37 * self.constants[12] - t32 * t124;
        let t129 = cos_phi * t119 - t111 * t116 - sin_phi * t126;
        let t130 = sin_phi * self.constants[8] + t129;
        let t137 = sin_delta * cos_phi * t108 + sin_phi * (t37 * t106 + t32 * t109);
        let t142 = t116 * t137 + t32 * self.constants[12] + t37 * t124;
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
        let t174 = t7 + self.constants[30] + t21 + t80 + self.constants[16]
            + self.constants[25];
        let t184 = t37 * t83 + t56 * t75 + t57 * t67 - t32 * t87 - t60 * t67;
        let t191 = t23 + t63 - t52;
        let t197 = t158 * self.constants[2];
        let t201 = t137 * t146 - t111 * t148;
        let t205 = t137 * t142 - t111 * t130;
        let t211 = self.constants[0].like(1.0)
            / (self.constants[11] + t104 * self.constants[5]);
        let t215 = sin_delta * t32;
        let t219 = (t156 * t205 - t145 * t201) * t211 + cos_delta * t158
            - sin_delta * t37 - t166 * t215;
        let t221 = t219 * self.constants[3];
        let t228 = t11 + t52 + t63 + t80 + t94 * t158
            + t158 * (t94 + t158 * t174 - t166 * t184) + t158 * t197;
        let t232 = speeds[0]
            * (t228 + t219 * t221 - t165 * t166
                - t166 * (t165 + t158 * t184 - t166 * t191));
        let t234 = self.constants[26] + t18;
        let t241 = t37 * self.constants[7] - self.constants[6] * t32;
        let t243 = t129 + sin_phi * t241;
        let t245 = t37 * sin_phi;
        let t249 = t142 - t32 * self.constants[7] - self.constants[6] * t37;
        let t252 = t144 * (t32 * t243 + t245 * t249);
        let t261 = self.constants[5] + t104 * self.constants[11] + sin_phi * t119
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
        let t367 = self.constants[2] * t274;
        let t369 = self.constants[3] * t308;
        let t375 = self.constants[26] + t274 * t284 + t274 * t280 + t274 * t367
            + t308 * t369 - t276 * t294;
        let t388 = t279 + t342 * t367 + t351 * t369 - t274 * t332 - t276 * t339
            - t280 * t323;
        let t389 = t388 - t290 * t325;
        let t393 = speeds[1]
            * (speeds[0] * t318 + speeds[1] * (t375 - t276 * t290) + speeds[2] * t389);
        let t408 = t78 + t323 * t332 + t323 * t328 + self.constants[2] * t342 * t342
            + self.constants[3] * t351 * t351 - t325 * t339;
        let t415 = speeds[0] * (t232 + speeds[1] * t318 + speeds[2] * t357) + t393
            + speeds[2]
                * (speeds[0] * t357 + speeds[1] * t389
                    + speeds[2] * (t408 - t325 * t335));
        let t417 = t415 * self.constants[0].like(0.5);
        let t423 = -(self.constants[27] * (sin_phi * t334 + cos_phi * t327));
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
        t46 = cos_delta * sin_phi + t19 * sin_delta;
        t48 = t46 * self.constants[11];
        t55 = self.constants[6] + cos_delta * self.constants[9];
        t58 = t43 * t48 + t9 * self.constants[12] + t13 * t55;
        t59 = sin_phi * t58;
        t64 = sin_delta * self.constants[9];
        t68 = t13 * self.constants[12] - t9 * t55;
        t71 = cos_phi * t64 - t36 * t48 - sin_phi * t68;
        t72 = sin_phi * self.constants[8] + t71;
        t73 = sin_phi * t72;
        t75 = t36 * t59 + t43 * t73;
        t77 = self.constants[0].like(1.0) / (cos_phi * t58);
        t78 = t72 * t77;
        t82 = self.constants[0].like(1.0) / (t36 * t58 + t43 * t72);
        t84 = t75 * t78 * t82;
        t91 = t58 - t9 * self.constants[7] - t13 * self.constants[6];
        t99 = t13 * self.constants[7] - t9 * self.constants[6];
        t104 = self.constants[5] + t29 * self.constants[11] + sin_phi * t64
            + cos_phi * t68 - cos_phi * t99;
        t106 = t26 * t91 - t9 * t104;
        t108 = t13 * sin_phi;
        t111 = t71 + sin_phi * t99;
        t113 = t104 * t108 + t26 * t111;
        t118 = t77 * (t9 * t111 + t91 * t108);
        t122 = t82 * (t36 * t106 + t43 * t113 + t75 * t118);
        t127 = self.constants[8] + cos_phi * self.constants[4];
        t129 = t43 * t82 * t127;
        t132 = speeds[0] * t84 + speeds[1] * t122 + speeds[2] * t129;
        t133 = cos_phi * t132;
        t135 = speeds[0] * t13 + t9 * t133;
        t138 = t9 * speeds[0] - t13 * t133;
        t143 = t138 * self.constants[13] - t135 * self.constants[14];
        t147 = speeds[0] * t78 + speeds[1] * t118;
        t148 = sin_phi * t132;
        t149 = t147 - t148;
        t150 = self.constants[14] * t149;
        t152 = t135 * t143 - t149 * t150;
        t154 = speeds[0] * self.constants[8];
        t155 = t133 * t154;
        t156 = self.constants[7] * t149;
        t158 = self.constants[6] * t149;
        t160 = t138 * t156 + t135 * t158;
        t161 = speeds[0] * t148;
        t163 = t135 * t147;
        t164 = t13 * t161 + t163;
        t167 = t138 * t147;
        t168 = t9 * t161 + t167;
        t170 = speeds[2] + t147;
        t171 = t133 * t170;
        t173 = self.constants[8] * t148;
        t174 = t133 * t173;
        t175 = t174 - t127 * t171;
        t178 = t160 + self.constants[6] * t164 + self.constants[7] * t168 - t175;
        t183 = self.constants[6] * t138 - self.constants[7] * t135;
        t185 = t149 * t158 + t138 * t183;
        t186 = speeds[0] * t133;
        t189 = sin_phi * self.constants[4];
        t190 = speeds[0] * t170;
        t194 = t155 + t127 * t186 + t189 * (t161 + t190);
        t200 = t173 * (t170 - t148) - speeds[0] * t154;
        t201 = t171 * t189 + t200;
        t205 = t13 * t194 + t9 * t201 - t185 - self.constants[7] * t186;
        t207 = speeds[1] + t138;
        t211 = cos_delta * t149 - sin_delta * t135;
        t212 = self.constants[10] * t211;
        t216 = cos_delta * t135 + sin_delta * t149;
        t217 = self.constants[9] * t211;
        t222 = speeds[1] * t211;
        t224 = t222 - cos_delta * t168 - sin_delta * t186;
        t227 = self.constants[11] + t29 * self.constants[5];
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
        t277 = cos_delta * t178 + t207 * t212 + t216 * t217 + self.constants[9] * t164
            + t228 * t258 + t207 * t269;
        t281 = t277 + t216 * t271 - sin_delta * t205 - self.constants[10] * t224
            - t260 * t262;
        t288 = self.constants[9] * t207 - self.constants[10] * t216;
        t292 = speeds[1] * t216;
        t294 = sin_delta * t168 - cos_delta * t186 - t292;
        t297 = t46 * self.constants[5];
        t299 = t211 + t256;
        t304 = self.constants[11] * (t31 * t207 - t33 * t216);
        t310 = cos_delta * t205 + sin_delta * t178 + self.constants[10] * t294
            + t260 * t294 - t211 * t217 - t207 * t288;
        t313 = t310 - t258 * t297 - t271 * t299 - t207 * t304;
        t317 = t135 * t183 - t149 * t156;
        t332 = t317 + self.constants[6] * t186 + t9 * t194 + t216 * t288 + t262 * t297
            + t216 * t304;
        t337 = t332 - t13 * t201 - t211 * t212 - self.constants[9] * t294 - t228 * t294
            - t269 * t299;
        t339 = t31 * t313 + t33 * t337;
        t344 = t77 * (t46 * t281 + t29 * t339);
        t348 = t82 * (t29 * t281 + t75 * t344 - t46 * t339);
        t350 = t186 - t344;
        t351 = sin_phi * t348 + t350;
        t355 = cos_phi * self.constants[27];
        t356 = t201 + t355;
        t360 = t161 - cos_phi * t348;
        t364 = t127 * t351 + t155 + t189 * (t190 + t360);
        t366 = t13 * t356 - t9 * t364;
        t369 = t317 - t366 + self.constants[6] * t351;
        t375 = t167 + t9 * t360;
        t378 = sin_delta * t375 - cos_delta * t351 - t292;
        t383 = t207 * self.constants[21] - t216 * self.constants[22];
        t385 = t211 * self.constants[22];
        t387 = t216 * t383 - t211 * t385;
        t389 = t369 * self.constants[20] + t387 - self.constants[21] * t378;
        t394 = t152 + t389 - self.constants[17] * t366 + self.constants[13] * t351;
        t398 = t9 * t356 + t13 * t364;
        t401 = t398 - self.constants[7] * t351 - t185;
        t404 = t163 + t13 * t360;
        t407 = sin_phi * self.constants[27];
        t408 = t175 + t407;
        t411 = t160 + self.constants[6] * t404 + self.constants[7] * t375 - t408;
        t413 = cos_delta * t401 + sin_delta * t411;
        t416 = t211 * self.constants[21];
        t419 = t211 * t416 + t207 * t383;
        t421 = t413 * self.constants[20] + self.constants[22] * t378 - t419;
        t425 = cos_delta * t411 - sin_delta * t401;
        t431 = t222 - sin_delta * t351 - cos_delta * t375;
        t435 = t207 * t385 + t216 * t416;
        t438 = t425 * self.constants[20] + t404 * self.constants[21] + t435
            - self.constants[22] * t431;
        t440 = cos_delta * t421 - sin_delta * t438;
        t443 = self.constants[13] * t149;
        t446 = t149 * t443 + t138 * t143;
        t449 = t440 + self.constants[17] * t398 - self.constants[14] * t351 - t446;
        t451 = t9 * t394 + t13 * t449;
        t453 = t351 * self.constants[2] + t127 * t451;
        t454 = sin_phi * t129;
        t463 = t135 * self.constants[18] + t138 * self.constants[15];
        t468 = t135 * self.constants[15] + t138 * self.constants[19];
        t470 = t138 * t463 - t135 * t468;
        t479 = t216 * self.constants[24] + t207 * self.constants[26];
        t485 = t211 * self.constants[25] + t299 * self.constants[3];
        t487 = t211 * t479 - t207 * t485;
        t490 = self.constants[23] * t431 + t404 * self.constants[24] + t487
            - self.constants[22] * t425;
        t502 = t238 * (t31 * t337 + t235 * t348 - t33 * t313 - t231 * t344);
        t504 = self.constants[3] * (t378 + t502);
        t507 = t216 * self.constants[23] + t207 * self.constants[24];
        t510 = t207 * t507 - t216 * t479;
        t514 = self.constants[22] * t413 + self.constants[25] * t378 + t504 + t510
            - self.constants[21] * t369;
        t522 = self.constants[14] * t398 + self.constants[13] * t366
            - t351 * self.constants[16] + t470 + sin_delta * t490 + cos_delta * t514;
        t525 = t522 + self.constants[7] * t440 - t453 - self.constants[6] * t389;
        t527 = cos_phi * t129;
        t534 = t149 * self.constants[16] + self.constants[2] * (speeds[2] + t149);
        t537 = t135 * t534 - t149 * t463;
        t543 = t216 * t485 - t211 * t507;
        t546 = t425 * self.constants[21] + t431 * self.constants[24]
            + t404 * self.constants[26] + t543;
        t549 = sin_delta * t421 + cos_delta * t438;
        t555 = self.constants[19] * t404 + t537 + t546 + self.constants[6] * t549
            - self.constants[13] * t408 - self.constants[15] * t375;
        t562 = t149 * t468 - t138 * t534;
        t570 = self.constants[14] * t408 + self.constants[15] * t404 + t562
            + cos_delta * t490 - self.constants[18] * t375 - sin_delta * t514;
        t571 = t570 - self.constants[7] * t549;
        t575 = t13 * t555 + t189 * t451 - t9 * t571;
        t590 = t138 * t150 + t135 * t443;
        t595 = t127
            * (t549 + self.constants[13] * t404 + self.constants[14] * t375 + t590
                - self.constants[17] * t408);
        t597 = t78 - sin_phi * t84;
        t599 = cos_phi * t84;
        t604 = forces[0] + t189 * (t13 * t394 - t9 * t449) + t575 * t599 - t9 * t555;
        t608 = t604 - t13 * t571 - t595 - t525 * t597 - t239 * t504;
        t610 = sin_delta * self.constants[21];
        t612 = sin_delta * self.constants[24] - self.constants[7] * t610;
        t615 = sin_delta * self.constants[28];
        t618 = cos_delta * t615 - self.constants[6] * t610;
        t622 = cos_delta * self.constants[21];
        t625 = self.constants[13] + t622 + self.constants[29];
        t627 = t9 * self.constants[35] + t13 * t625;
        t630 = t9 * t612 + t13 * t618 + t189 * t627;
        t636 = cos_delta * self.constants[24] - self.constants[7] * t622;
        t639 = self.constants[15] + t636 - self.constants[31] - self.constants[32];
        t640 = sin_delta * t615;
        t644 = self.constants[18] + self.constants[23] + self.constants[30] - t640;
        t645 = self.constants[6] * t622;
        t648 = t645 + t645 + self.constants[33];
        t650 = self.constants[19] + self.constants[26] + t648;
        t651 = t650 - t644;
        t652 = t9 * t13;
        t654 = t9 * t9;
        t655 = t639 + t639;
        t660 = t639 + t651 * t652 + t127 * t627 - t654 * t655;
        t664 = t13 * self.constants[35] - t9 * t625;
        t666 = t127 * self.constants[34];
        t668 = t127 * (t664 - t666);
        t669 = t127 * t664;
        t670 = t127 * t666;
        t672 = t670 - t669 - t669;
        t677 = self.constants[16] + self.constants[25] + t640 + self.constants[30] + t648
            + t672;
        t683 = t189 * self.constants[34];
        t688 = t13 * t612 + t189 * t664 + t127 * t610 - t9 * t618 - t127 * t683;
        t691 = t668 + t454 * t677 + t527 * t688;
        t694 = t127 * (t610 - t683);
        t698 = t651 * t654 + t652 * t655;
        t699 = t189 * t610;
        t702 = t189 * t683 - t699 - t699;
        t704 = t650 + t702 - t698;
        t707 = t694 - t454 * t688 - t527 * t704;
        t710 = self.constants[0].like(1.0) - t454;
        t711 = self.constants[2] * t597;
        t714 = t9 * sin_delta;
        t717 = t253 - cos_delta * t454 - t527 * t714;
        t723 = t239 + cos_delta * t597 - t13 * sin_delta - t599 * t714;
        t724 = self.constants[3] * t723;
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
        t766 = self.constants[26] + t645;
        t771 = t13 * t766 - t9 * t636 - t189 * t757;
        t773 = self.constants[2] * t760;
        t778 = t248 + cos_delta * t760 - t714 * t762;
        t779 = self.constants[3] * t778;
        t790 = t764 + t677 * t760 - t688 * t762;
        t795 = t771 + t688 * t760 - t704 * t762;
        t803 = t9 * t766 + t13 * t636 + t127 * t622 + t630 * t760 + t597 * t790
            + t711 * t760;
        t808 = t754 * (t803 + t724 * t778 - t9 * t699 - t660 * t762 - t599 * t795);
        t809 = t753 * t808;
        t815 = t758 + t710 * t773 + t717 * t779 - t691 * t760 - t707 * t762
            - t454 * t764;
        t829 = self.constants[26] + t760 * t790 + t760 * t764 + t760 * t773 + t778 * t779
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
        t866 = t670 + t454 * t691 + t454 * t668 + self.constants[2] * t710 * t710
            + self.constants[3] * t717 * t717 - t527 * t707;
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
        t910 = t317 - t905 - self.constants[6] * t890;
        t916 = t13 * t878 - t167 - t9 * t894;
        t919 = cos_delta * t890 - t292 - sin_delta * t916;
        t922 = t387 + self.constants[20] * t910 - self.constants[21] * t919;
        t925 = t152 + t922 - self.constants[17] * t905 - self.constants[13] * t890;
        t929 = t9 * t903 - t13 * t898;
        t934 = t929 + self.constants[7] * t890 - t185;
        t939 = t163 + t13 * t894 + t9 * t878;
        t944 = t174 + t407 - t127 * t900;
        t947 = t160 + self.constants[6] * t939 - self.constants[7] * t916 - t944;
        t949 = cos_delta * t934 + sin_delta * t947;
        t953 = self.constants[20] * t949 + self.constants[22] * t919 - t419;
        t957 = cos_delta * t947 - sin_delta * t934;
        t959 = t874 + t939;
        t964 = t222 + cos_delta * t916 + sin_delta * t890;
        t968 = t435 + self.constants[20] * t957 + self.constants[21] * t959
            - self.constants[22] * t964;
        t970 = cos_delta * t953 - sin_delta * t968;
        t973 = self.constants[17] * t929 + self.constants[14] * t890 + t970 - t446;
        t975 = t9 * t925 + t13 * t973;
        t983 = self.constants[3]
            * (t502 + t919 + t239 * t878 + t248 * t874 + t253 * t870);
        t984 = t238 * t983;
        t995 = t487 + self.constants[23] * t964 + self.constants[24] * t959
            - self.constants[22] * t957;
        t1003 = t510 + t983 + self.constants[22] * t949 + self.constants[25] * t919
            - self.constants[21] * t910;
        t1012 = t470 + self.constants[14] * t929 + self.constants[13] * t905
            + self.constants[16] * t890 + self.constants[2] * t891 + sin_delta * t995;
        t1016 = t1012 + cos_delta * t1003 + self.constants[7] * t970
            - self.constants[6] * t922 - t127 * t975;
        t1026 = sin_delta * t953 + cos_delta * t968;
        t1033 = t537 + t543 + self.constants[15] * t916 + self.constants[19] * t939
            + self.constants[21] * t957 + self.constants[24] * t964
            + self.constants[26] * t959;
        t1047 = t562 + self.constants[14] * t944 + self.constants[18] * t916
            + self.constants[15] * t939 + cos_delta * t995 - sin_delta * t1003;
        t1052 = t13 * (t1033 + self.constants[6] * t1026 - self.constants[13] * t944)
            + t189 * t975 - t9 * (t1047 - self.constants[7] * t1026);
        t1057 = t82 * (sin_phi * t1016 + cos_phi * t1052 - t235 * t984);
        t1059 = t36 * t984 - t43 * t1057;
        t1060 = t975 - t1059;
        t1065 = t43 * t984 + t36 * t1057;
        t1072 = t590 + t1026 + self.constants[13] * t939 - self.constants[17] * t944
            - self.constants[14] * t916;
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
    /// 185 additions, 280 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 471 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WhippleTyresMatrices<T>, WhippleTyresDerivatives<T>) {
        let (
            t6, t10, Jxx_delta, t17, t21, M_11, sin_lam, cos_lam, t34, t36, Jxz_delta, t41,
            hx_delta, t43, yaw_per_v_delta, yaw_by_delta, Sz_delta, Jxz_all, M_12, t57, t59, t60,
            t62, t65, hz_delta, t70, t72, M_yaw_delta, t76, t78, t80, P_delta_yaw_yaw_by_delta, t87,
            P_delta_yaw, t89, M_22, zero, t95, h_spin_F, t97, t99, t100, h_wheels_all, Sz_all, t104,
            t106, C1_12, m_delta, Sx_all, t116, P_delta_lateral, C1_22, K0_11_rhoF, t122,
            K0_11_rhoR, K0_11, t130, t132, K_phi_delta, K0_22, K2_12, t137, t138, K2_22,
            C1_12_h_spin_F, t141, t143, t144, t145, M_12_yaw_per_v_delta, M_12_w, t149, t150, t151,
            t152, M_22_hz_delta, t155, M_22_Jxz_delta, t160, t163, t165, P_delta_yaw_w,
            M_22_yaw_by_delta, M_22_yaw_per_v_delta, M_22_w, t174, t176, C1_12_yaw_per_v_delta,
            C1_12_w, t181, C1_21_w, C1_22_Sx_all, t185, t187, t189, K2_22_h_spin_F, t195, t199,
            C1_22_yaw_by_delta, C1_22_yaw_per_v_delta, C1_22_w, t209, K0_11_Sx_all, K0_11_xH, t213,
            K0_11_w, K_phi_delta_Sx_all, t218, t219, t221, K_phi_delta_w, K0_22_w, t225,
            K2_22_Sx_all, t228, K2_22_xH, t231, K2_22_yaw_by_delta, K2_22_yaw_per_v_delta, K2_22_w,
            M_12_c, t242, hz_delta_c, M_22_c, C1_12_c, t254, t257, C1_22_c, K_phi_delta_c, K0_22_c,
            K2_22_c, hx_delta_lam, t275, M_12_lam, t283, hz_delta_lam, M_22_lam, t295, C1_21_lam,
            C1_22_lam, K_phi_delta_rhoF, K_phi_delta_lam, K0_22_lam, t311, K2_22_lam, M_11_rR, t317,
            t318, C1_12_rR, C1_21_rR, K2_12_rR, M_11_mR, C1_12_mR, K0_11_mR, K2_12_mR, C1_12_IRyy,
            K2_12_IRyy, t329, t330, t331, P_delta_yaw_xB, M_22_xB, t335, C1_22_xB, K0_11_xB,
            K_phi_delta_xB, K0_22_xB, K2_22_xB, M_11_zB, t345, t346, t347, M_11_mB, t349,
            P_delta_yaw_mB, M_22_mB, t352, C1_22_mB, K0_11_mB, K_phi_delta_mB, K0_22_mB, t361,
            K2_22_mB, P_delta_yaw_xH, M_22_xH, C1_22_xH, t369, M_11_zH, t371, t373, t375, M_12_zH,
            t379, M_22_Jxx_delta, t384, M_22_zH, t389, C1_12_zH, t391, t393, C1_22_zH,
            K_phi_delta_zH, K0_22_zH, t397, t398, M_11_mH, M_12_mH, P_delta_yaw_mH, M_22_mH,
            C1_12_mH, C1_22_m_delta, C1_22_mH, K0_11_m_delta, K0_11_mH, K_phi_delta_m_delta,
            K_phi_delta_mH, K0_22_mH, t425, K2_22_m_delta, K2_22_mH, M_22_IHzz, C1_22_IHzz, M_11_rF,
            t436, t438, M_12_rF, t445, M_22_rF, t449, t451, C1_21_rF, C1_12_rF, t455, C1_22_rF,
            t457, t458, K2_12_rF, K2_22_rF, M_11_mF, M_12_mF, P_delta_yaw_mF, M_22_mF, C1_12_mF,
            C1_22_mF, K0_11_mF, K_phi_delta_mF, K0_22_mF, K2_12_mF, K2_22_mF, M_22_IFxx, C1_12_IFyy,
        );
        t6 = self.zH * self.mH;
        t10 = self.rF * self.mF;
        Jxx_delta = self.IHxx + self.IFxx + self.zH * t6 + self.rF * t10;
        t17 = self.rR * self.mR;
        t21 = self.zB * self.mB;
        M_11 = self.IRxx + self.IBxx + Jxx_delta + self.rR * t17 + self.zB * t21;
        (sin_lam, cos_lam) = self.lam.sin_cos();
        t34 = self.c + self.w;
        t36 = t34 - self.xH;
        Jxz_delta = self.IHxz + t6 * t36 - t10 * self.c;
        t41 = Jxz_delta * cos_lam;
        hx_delta = Jxx_delta * sin_lam + t41;
        t43 = self.w.like(1.0) / self.w;
        yaw_per_v_delta = cos_lam * t43;
        yaw_by_delta = self.c * yaw_per_v_delta;
        Sz_delta = t6 - t10;
        Jxz_all = Jxz_delta + self.IBxz - t21 * self.xB - t34 * Sz_delta;
        M_12 = hx_delta + yaw_by_delta * Jxz_all;
        t57 = sin_lam * Jxz_delta;
        t59 = self.IFxx + self.IHzz;
        t60 = self.mF * self.c;
        t62 = self.mH * t36;
        t65 = t59 + self.c * t60 + t36 * t62;
        hz_delta = t57 + cos_lam * t65;
        t70 = t60 + t62;
        t72 = sin_lam * Sz_delta + cos_lam * t70;
        M_yaw_delta = hz_delta - t34 * t72;
        t76 = self.mB * self.xB;
        t78 = self.xH * self.xH;
        t80 = self.w * self.w;
        P_delta_yaw_yaw_by_delta = self.IRxx + t59 + self.IBzz + self.xB * t76
            + self.mH * t78 + self.mF * t80;
        t87 = yaw_by_delta * P_delta_yaw_yaw_by_delta;
        P_delta_yaw = M_yaw_delta + t87;
        t89 = M_yaw_delta + P_delta_yaw;
        M_22 = sin_lam * hx_delta + cos_lam * hz_delta + yaw_by_delta * t89;
        zero = self.w.like(0.0);
        t95 = self.w.like(1.0) / self.rF;
        h_spin_F = self.IFyy * t95;
        t97 = cos_lam * h_spin_F;
        t99 = self.w.like(1.0) / self.rR;
        t100 = self.IRyy * t99;
        h_wheels_all = h_spin_F + t100;
        Sz_all = t21 + Sz_delta - t17;
        t104 = h_wheels_all - Sz_all;
        t106 = yaw_per_v_delta * Jxz_all;
        C1_12 = t97 + yaw_by_delta * t104 + t106;
        m_delta = self.mH + self.mF;
        Sx_all = t76 + t34 * m_delta - t70;
        t116 = yaw_by_delta * Sx_all;
        P_delta_lateral = t116 - t72;
        C1_22 = yaw_per_v_delta * P_delta_yaw + yaw_by_delta * P_delta_lateral;
        K0_11_rhoF = t43 * Sx_all;
        t122 = self.rhoF * K0_11_rhoF;
        K0_11_rhoR = self.mR + self.mB + m_delta - K0_11_rhoF;
        K0_11 = Sz_all + t122 + self.rhoR * K0_11_rhoR;
        t130 = self.c * cos_lam;
        t132 = sin_lam * self.rhoF - t130;
        K_phi_delta = t72 + K0_11_rhoF * t132;
        K0_22 = sin_lam * K_phi_delta;
        K2_12 = yaw_per_v_delta * t104;
        t137 = sin_lam * h_spin_F;
        t138 = P_delta_lateral + t137;
        K2_22 = yaw_per_v_delta * t138;
        C1_12_h_spin_F = cos_lam + yaw_by_delta;
        t141 = t6 * C1_12_h_spin_F;
        t143 = t141 - yaw_by_delta * Sz_delta;
        t144 = t43 * t43;
        t145 = cos_lam * t144;
        M_12_yaw_per_v_delta = self.c * Jxz_all;
        M_12_w = t143 - t145 * M_12_yaw_per_v_delta;
        t149 = yaw_by_delta + yaw_by_delta;
        t150 = t34 * t149;
        t151 = cos_lam * t150;
        t152 = t36 * cos_lam;
        M_22_hz_delta = cos_lam + t149;
        t155 = t152 * M_22_hz_delta - t151;
        M_22_Jxz_delta = sin_lam * (cos_lam + M_22_hz_delta);
        t160 = cos_lam * t62;
        t163 = self.mH * t155 + t6 * M_22_Jxz_delta + M_22_hz_delta * t160;
        t165 = t163 - t72 * t149;
        P_delta_yaw_w = self.mF * self.w * t149;
        M_22_yaw_by_delta = t87 + t89;
        M_22_yaw_per_v_delta = self.c * M_22_yaw_by_delta;
        M_22_w = t165 + yaw_by_delta * P_delta_yaw_w - t145 * M_22_yaw_per_v_delta;
        t174 = t6 * yaw_per_v_delta;
        t176 = t174 - yaw_per_v_delta * Sz_delta;
        C1_12_yaw_per_v_delta = Jxz_all + self.c * t104;
        C1_12_w = t176 - t145 * C1_12_yaw_per_v_delta;
        t181 = self.c * h_wheels_all;
        C1_21_w = t145 * t181;
        C1_22_Sx_all = yaw_by_delta * yaw_by_delta;
        t185 = yaw_by_delta + t34 * yaw_per_v_delta;
        t187 = C1_22_Sx_all + cos_lam * t185;
        t189 = yaw_per_v_delta * t152 - t187;
        K2_22_h_spin_F = sin_lam * yaw_per_v_delta;
        t195 = self.mH * t189 + t6 * K2_22_h_spin_F + yaw_per_v_delta * t160;
        t199 = t195 + m_delta * C1_22_Sx_all - yaw_per_v_delta * t72;
        C1_22_yaw_by_delta = t116 + P_delta_lateral
            + yaw_per_v_delta * P_delta_yaw_yaw_by_delta;
        C1_22_yaw_per_v_delta = P_delta_yaw + self.c * C1_22_yaw_by_delta;
        C1_22_w = t199 + yaw_per_v_delta * P_delta_yaw_w - t145 * C1_22_yaw_per_v_delta;
        t209 = self.rhoF - self.rhoR;
        K0_11_Sx_all = t43 * t209;
        K0_11_xH = self.mH * K0_11_Sx_all;
        t213 = Sx_all * t144;
        K0_11_w = m_delta * K0_11_Sx_all - K0_11_xH - t209 * t213;
        K_phi_delta_Sx_all = t43 * t132;
        t218 = cos_lam - K_phi_delta_Sx_all;
        t219 = self.mH * t218;
        t221 = t219 + m_delta * K_phi_delta_Sx_all;
        K_phi_delta_w = t221 - t132 * t213;
        K0_22_w = sin_lam * K_phi_delta_w;
        t225 = t104 * t145;
        K2_22_Sx_all = yaw_per_v_delta * yaw_by_delta;
        t228 = cos_lam * yaw_per_v_delta + K2_22_Sx_all;
        K2_22_xH = self.mH * t228;
        t231 = m_delta * K2_22_Sx_all - K2_22_xH;
        K2_22_yaw_by_delta = yaw_per_v_delta * Sx_all;
        K2_22_yaw_per_v_delta = t138 + self.c * K2_22_yaw_by_delta;
        K2_22_w = t231 - t145 * K2_22_yaw_per_v_delta;
        M_12_c = t106 + t143 - t10 * C1_12_h_spin_F;
        t242 = t130 * M_22_hz_delta - t151;
        hz_delta_c = cos_lam * t60;
        M_22_c = t165 + self.mF * t242 + yaw_per_v_delta * M_22_yaw_by_delta
            + M_22_hz_delta * hz_delta_c - t10 * M_22_Jxz_delta;
        C1_12_c = t176 + yaw_per_v_delta * (t104 - t10);
        t254 = yaw_per_v_delta * h_wheels_all;
        t257 = yaw_per_v_delta * t130 - t187;
        C1_22_c = t199 + self.mF * t257
            + yaw_per_v_delta * (C1_22_yaw_by_delta + hz_delta_c) - t10 * K2_22_h_spin_F;
        K_phi_delta_c = t221 + self.mF * t218 - cos_lam * K0_11_rhoF;
        K0_22_c = sin_lam * K_phi_delta_c;
        K2_22_c = t231 + yaw_per_v_delta * K2_22_yaw_by_delta - self.mF * t228;
        hx_delta_lam = Jxx_delta * cos_lam - t57;
        t275 = sin_lam * t43;
        M_12_lam = hx_delta_lam - M_12_yaw_per_v_delta * t275;
        t283 = cos_lam * Sz_delta - sin_lam * t70;
        hz_delta_lam = t41 - sin_lam * t65;
        M_22_lam = sin_lam * hx_delta_lam + cos_lam * hx_delta
            + M_22_hz_delta * hz_delta_lam - sin_lam * hz_delta - t150 * t283
            - M_22_yaw_per_v_delta * t275;
        t295 = t137 + C1_12_yaw_per_v_delta * t275;
        C1_21_lam = t137 + t181 * t275;
        C1_22_lam = yaw_per_v_delta * hz_delta_lam - t185 * t283
            - C1_22_yaw_per_v_delta * t275;
        K_phi_delta_rhoF = sin_lam * K0_11_rhoF;
        K_phi_delta_lam = t283 + self.c * K_phi_delta_rhoF + cos_lam * t122;
        K0_22_lam = sin_lam * K_phi_delta_lam + cos_lam * K_phi_delta;
        t311 = t104 * t275;
        K2_22_lam = yaw_per_v_delta * (t97 - t283) - K2_22_yaw_per_v_delta * t275;
        M_11_rR = t17 + t17;
        t317 = t99 * t100;
        t318 = self.mR - t317;
        C1_12_rR = yaw_by_delta * t318;
        C1_21_rR = yaw_by_delta * t317;
        K2_12_rR = yaw_per_v_delta * t318;
        M_11_mR = self.rR * self.rR;
        C1_12_mR = self.rR * yaw_by_delta;
        K0_11_mR = self.rhoR - self.rR;
        K2_12_mR = self.rR * yaw_per_v_delta;
        C1_12_IRyy = yaw_by_delta * t99;
        K2_12_IRyy = yaw_per_v_delta * t99;
        t329 = t21 * yaw_by_delta;
        t330 = yaw_by_delta * self.xB;
        t331 = self.mB * t330;
        P_delta_yaw_xB = t331 + yaw_by_delta * t76;
        M_22_xB = yaw_by_delta * P_delta_yaw_xB;
        t335 = t21 * yaw_per_v_delta;
        C1_22_xB = self.mB * C1_22_Sx_all + yaw_per_v_delta * P_delta_yaw_xB;
        K0_11_xB = self.mB * K0_11_Sx_all;
        K_phi_delta_xB = self.mB * K_phi_delta_Sx_all;
        K0_22_xB = sin_lam * K_phi_delta_xB;
        K2_22_xB = self.mB * K2_22_Sx_all;
        M_11_zB = t21 + t21;
        t345 = yaw_by_delta + yaw_per_v_delta * self.xB;
        t346 = self.mB * t345;
        t347 = self.mB * yaw_per_v_delta;
        M_11_mB = self.zB * self.zB;
        t349 = self.zB * t330;
        P_delta_yaw_mB = self.xB * t330;
        M_22_mB = yaw_by_delta * P_delta_yaw_mB;
        t352 = self.zB * t345;
        C1_22_mB = self.xB * C1_22_Sx_all + yaw_per_v_delta * P_delta_yaw_mB;
        K0_11_mB = self.zB + self.rhoR + self.xB * K0_11_Sx_all;
        K_phi_delta_mB = self.xB * K_phi_delta_Sx_all;
        K0_22_mB = sin_lam * K_phi_delta_mB;
        t361 = self.zB * yaw_per_v_delta;
        K2_22_mB = self.xB * K2_22_Sx_all;
        P_delta_yaw_xH = self.mH * self.xH * t149;
        M_22_xH = yaw_by_delta * P_delta_yaw_xH - t163;
        C1_22_xH = yaw_per_v_delta * P_delta_yaw_xH - t195;
        t369 = sin_lam * t219;
        M_11_zH = t6 + t6;
        t371 = t34 * yaw_by_delta;
        t373 = self.zH * sin_lam;
        t375 = t36 * C1_12_h_spin_F + t373 - t371;
        M_12_zH = self.mH * t375 + t6 * sin_lam;
        t379 = sin_lam * t150;
        M_22_Jxx_delta = sin_lam * sin_lam;
        t384 = self.zH * M_22_Jxx_delta + t36 * M_22_Jxz_delta - t379;
        M_22_zH = self.mH * t384 + t6 * M_22_Jxx_delta;
        t389 = t36 * yaw_per_v_delta - t185;
        C1_12_zH = self.mH * t389;
        t391 = sin_lam * t185;
        t393 = t36 * K2_22_h_spin_F - t391;
        C1_22_zH = self.mH * t393;
        K_phi_delta_zH = self.mH * sin_lam;
        K0_22_zH = sin_lam * K_phi_delta_zH;
        t397 = self.mH * yaw_per_v_delta;
        t398 = self.mH * K2_22_h_spin_F;
        M_11_mH = self.zH * self.zH;
        M_12_mH = self.zH * t375;
        P_delta_yaw_mH = yaw_by_delta * t78;
        M_22_mH = self.zH * t384 + t36 * t155 + yaw_by_delta * P_delta_yaw_mH;
        C1_12_mH = self.zH * t389;
        C1_22_m_delta = t34 * C1_22_Sx_all;
        C1_22_mH = C1_22_m_delta + self.zH * t393 + t36 * t189
            + yaw_per_v_delta * P_delta_yaw_mH;
        K0_11_m_delta = self.rhoR + t34 * K0_11_Sx_all;
        K0_11_mH = self.zH + K0_11_m_delta - t36 * K0_11_Sx_all;
        K_phi_delta_m_delta = t34 * K_phi_delta_Sx_all;
        K_phi_delta_mH = t373 + K_phi_delta_m_delta + t36 * t218;
        K0_22_mH = sin_lam * K_phi_delta_mH;
        t425 = self.zH * yaw_per_v_delta;
        K2_22_m_delta = t34 * K2_22_Sx_all;
        K2_22_mH = K2_22_m_delta - self.zH * K2_22_h_spin_F - t36 * t228;
        M_22_IHzz = C1_22_Sx_all + cos_lam * M_22_hz_delta;
        C1_22_IHzz = yaw_per_v_delta * C1_12_h_spin_F;
        M_11_rF = t10 + t10;
        t436 = self.rF * sin_lam;
        t438 = t371 + t436 - self.c * C1_12_h_spin_F;
        M_12_rF = self.mF * t438 + t10 * sin_lam;
        t445 = t379 + self.rF * M_22_Jxx_delta - self.c * M_22_Jxz_delta;
        M_22_rF = self.mF * t445 + t10 * M_22_Jxx_delta;
        t449 = t185 - yaw_by_delta;
        t451 = t95 * h_spin_F;
        C1_21_rF = C1_12_h_spin_F * t451;
        C1_12_rF = self.mF * t449 - C1_21_rF;
        t455 = t391 - self.c * K2_22_h_spin_F;
        C1_22_rF = self.mF * t455;
        t457 = self.mF * sin_lam;
        t458 = sin_lam * t457;
        K2_12_rF = self.mF * yaw_per_v_delta - yaw_per_v_delta * t451;
        K2_22_rF = self.mF * K2_22_h_spin_F - K2_22_h_spin_F * t451;
        M_11_mF = self.rF * self.rF;
        M_12_mF = self.rF * t438;
        P_delta_yaw_mF = yaw_by_delta * t80;
        M_22_mF = self.c * t242 + self.rF * t445 + yaw_by_delta * P_delta_yaw_mF;
        C1_12_mF = self.rF * t449;
        C1_22_mF = C1_22_m_delta + self.c * t257 + self.rF * t455
            + yaw_per_v_delta * P_delta_yaw_mF;
        K0_11_mF = K0_11_m_delta - self.rF - self.c * K0_11_Sx_all;
        K_phi_delta_mF = K_phi_delta_m_delta + self.c * t218 - t436;
        K0_22_mF = sin_lam * K_phi_delta_mF;
        K2_12_mF = self.rF * yaw_per_v_delta;
        K2_22_mF = K2_22_m_delta + self.rF * K2_22_h_spin_F - self.c * t228;
        M_22_IFxx = M_22_Jxx_delta + M_22_IHzz;
        C1_12_IFyy = t95 * C1_12_h_spin_F;
        let (K2_12_IFyy, K2_22_IFyy, K0_22_rhoF, C1_21);
        K2_12_IFyy = yaw_per_v_delta * t95;
        K2_22_IFyy = t95 * K2_22_h_spin_F;
        K0_22_rhoF = sin_lam * K_phi_delta_rhoF;
        C1_21 = -(t97 + yaw_by_delta * h_wheels_all);
        (
            WhippleTyresMatrices::from_entries([
                M_11, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, K0_11, K_phi_delta, K_phi_delta,
                K0_22, zero, K2_12, zero, K2_22,
            ]),
            WhippleTyresDerivatives {
                values: [
                    M_12_w, M_22_w, C1_12_w, C1_21_w, C1_22_w, K0_11_w, K_phi_delta_w, K0_22_w,
                    t225, K2_22_w, M_12_c, M_22_c, C1_12_c, t254, C1_22_c, K_phi_delta_c, K0_22_c,
                    K2_22_c, M_12_lam, M_22_lam, t295, C1_21_lam, C1_22_lam, K_phi_delta_lam,
                    K0_22_lam, t311, K2_22_lam, M_11_rR, C1_12_rR, C1_21_rR, self.mR, K2_12_rR,
                    M_11_mR, C1_12_mR, K0_11_mR, K2_12_mR, self.w.like(1.0), C1_22_Sx_all,
                    K2_22_Sx_all, C1_12_IRyy, K2_12_IRyy, t329, M_22_xB, t335, C1_22_xB, K0_11_xB,
                    K_phi_delta_xB, K0_22_xB, K2_22_xB, M_11_zB, t331, t346, self.mB, t347, M_11_mB,
                    t349, M_22_mB, t352, C1_22_mB, K0_11_mB, K_phi_delta_mB, K0_22_mB, t361,
                    K2_22_mB, yaw_by_delta, yaw_per_v_delta, t141, M_22_xH, t174, C1_22_xH,
                    K0_11_xH, t219, t369, K2_22_xH, M_11_zH, M_12_zH, M_22_zH, C1_12_zH, C1_22_zH,
                    self.mH, K_phi_delta_zH, K0_22_zH, t397, t398, M_11_mH, M_12_mH, M_22_mH,
                    C1_12_mH, C1_22_mH, K0_11_mH, K_phi_delta_mH, K0_22_mH, t425, K2_22_mH, sin_lam,
                    M_22_Jxx_delta, M_22_IHzz, C1_22_IHzz, C1_12_h_spin_F, M_22_Jxz_delta,
                    K2_22_h_spin_F, M_11_rF, M_12_rF, M_22_rF, C1_12_rF, C1_21_rF, C1_22_rF,
                    self.mF, t457, t458, K2_12_rF, K2_22_rF, M_11_mF, M_12_mF, M_22_mF, C1_12_mF,
                    C1_22_mF, K0_11_mF, K_phi_delta_mF, K0_22_mF, K2_12_mF, K2_22_mF, M_22_IFxx,
                    C1_12_IFyy, K2_12_IFyy, K2_22_IFyy, K0_11_rhoR, K0_11_rhoF, K_phi_delta_rhoF,
                    K0_22_rhoF,
                ],
            },
        )
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
        let matrices = self.matrices();
        [
            matrices.m[0][0], matrices.m[0][1], matrices.m[1][1], matrices.c1[0][1],
            matrices.c1[1][0], matrices.c1[1][1], matrices.k0[0][0], matrices.k0[0][1],
            matrices.k0[1][1], matrices.k2[0][1], matrices.k2[1][1],
        ]
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

impl WhippleTyresDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 166] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 0), Partial::new(MatrixName::M, 1, 0, 0, 0),
        Partial::new(MatrixName::M, 1, 1, 0, 1), Partial::new(MatrixName::C1, 0, 1, 0, 2),
        Partial::new(MatrixName::C1, 1, 0, 0, 3), Partial::new(MatrixName::C1, 1, 1, 0, 4),
        Partial::new(MatrixName::K0, 0, 0, 0, 5), Partial::new(MatrixName::K0, 0, 1, 0, 6),
        Partial::new(MatrixName::K0, 1, 0, 0, 6), Partial::new(MatrixName::K0, 1, 1, 0, 7),
        Partial::new(MatrixName::K2, 0, 1, 0, 8).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 9), Partial::new(MatrixName::M, 0, 1, 1, 10),
        Partial::new(MatrixName::M, 1, 0, 1, 10), Partial::new(MatrixName::M, 1, 1, 1, 11),
        Partial::new(MatrixName::C1, 0, 1, 1, 12),
        Partial::new(MatrixName::C1, 1, 0, 1, 13).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 14), Partial::new(MatrixName::K0, 0, 1, 1, 15),
        Partial::new(MatrixName::K0, 1, 0, 1, 15), Partial::new(MatrixName::K0, 1, 1, 1, 16),
        Partial::new(MatrixName::K2, 1, 1, 1, 17), Partial::new(MatrixName::M, 0, 1, 2, 18),
        Partial::new(MatrixName::M, 1, 0, 2, 18), Partial::new(MatrixName::M, 1, 1, 2, 19),
        Partial::new(MatrixName::C1, 0, 1, 2, 20).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 21), Partial::new(MatrixName::C1, 1, 1, 2, 22),
        Partial::new(MatrixName::K0, 0, 1, 2, 23), Partial::new(MatrixName::K0, 1, 0, 2, 23),
        Partial::new(MatrixName::K0, 1, 1, 2, 24),
        Partial::new(MatrixName::K2, 0, 1, 2, 25).negative(),
        Partial::new(MatrixName::K2, 1, 1, 2, 26), Partial::new(MatrixName::M, 0, 0, 4, 27),
        Partial::new(MatrixName::C1, 0, 1, 4, 28), Partial::new(MatrixName::C1, 1, 0, 4, 29),
        Partial::new(MatrixName::K0, 0, 0, 4, 30).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 31), Partial::new(MatrixName::M, 0, 0, 5, 32),
        Partial::new(MatrixName::C1, 0, 1, 5, 33), Partial::new(MatrixName::K0, 0, 0, 5, 34),
        Partial::new(MatrixName::K2, 0, 1, 5, 35), Partial::new(MatrixName::M, 0, 0, 6, 36),
        Partial::new(MatrixName::M, 1, 1, 6, 37), Partial::new(MatrixName::C1, 1, 1, 6, 38),
        Partial::new(MatrixName::C1, 0, 1, 7, 39),
        Partial::new(MatrixName::C1, 1, 0, 7, 39).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 40),
        Partial::new(MatrixName::M, 0, 1, 8, 41).negative(),
        Partial::new(MatrixName::M, 1, 0, 8, 41).negative(),
        Partial::new(MatrixName::M, 1, 1, 8, 42),
        Partial::new(MatrixName::C1, 0, 1, 8, 43).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 44), Partial::new(MatrixName::K0, 0, 0, 8, 45),
        Partial::new(MatrixName::K0, 0, 1, 8, 46), Partial::new(MatrixName::K0, 1, 0, 8, 46),
        Partial::new(MatrixName::K0, 1, 1, 8, 47), Partial::new(MatrixName::K2, 1, 1, 8, 48),
        Partial::new(MatrixName::M, 0, 0, 9, 49),
        Partial::new(MatrixName::M, 0, 1, 9, 50).negative(),
        Partial::new(MatrixName::M, 1, 0, 9, 50).negative(),
        Partial::new(MatrixName::C1, 0, 1, 9, 51).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 52),
        Partial::new(MatrixName::K2, 0, 1, 9, 53).negative(),
        Partial::new(MatrixName::M, 0, 0, 10, 54),
        Partial::new(MatrixName::M, 0, 1, 10, 55).negative(),
        Partial::new(MatrixName::M, 1, 0, 10, 55).negative(),
        Partial::new(MatrixName::M, 1, 1, 10, 56),
        Partial::new(MatrixName::C1, 0, 1, 10, 57).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 58), Partial::new(MatrixName::K0, 0, 0, 10, 59),
        Partial::new(MatrixName::K0, 0, 1, 10, 60), Partial::new(MatrixName::K0, 1, 0, 10, 60),
        Partial::new(MatrixName::K0, 1, 1, 10, 61),
        Partial::new(MatrixName::K2, 0, 1, 10, 62).negative(),
        Partial::new(MatrixName::K2, 1, 1, 10, 63), Partial::new(MatrixName::M, 0, 0, 11, 36),
        Partial::new(MatrixName::M, 1, 1, 13, 37), Partial::new(MatrixName::C1, 1, 1, 13, 38),
        Partial::new(MatrixName::M, 0, 1, 14, 64), Partial::new(MatrixName::M, 1, 0, 14, 64),
        Partial::new(MatrixName::C1, 0, 1, 14, 65),
        Partial::new(MatrixName::M, 0, 1, 15, 66).negative(),
        Partial::new(MatrixName::M, 1, 0, 15, 66).negative(),
        Partial::new(MatrixName::M, 1, 1, 15, 67),
        Partial::new(MatrixName::C1, 0, 1, 15, 68).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 69),
        Partial::new(MatrixName::K0, 0, 0, 15, 70),
        Partial::new(MatrixName::K0, 0, 1, 15, 71).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 71).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 72).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 73), Partial::new(MatrixName::M, 0, 0, 16, 74),
        Partial::new(MatrixName::M, 0, 1, 16, 75), Partial::new(MatrixName::M, 1, 0, 16, 75),
        Partial::new(MatrixName::M, 1, 1, 16, 76), Partial::new(MatrixName::C1, 0, 1, 16, 77),
        Partial::new(MatrixName::C1, 1, 1, 16, 78), Partial::new(MatrixName::K0, 0, 0, 16, 79),
        Partial::new(MatrixName::K0, 0, 1, 16, 80), Partial::new(MatrixName::K0, 1, 0, 16, 80),
        Partial::new(MatrixName::K0, 1, 1, 16, 81),
        Partial::new(MatrixName::K2, 0, 1, 16, 82).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 83).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 84), Partial::new(MatrixName::M, 0, 1, 17, 85),
        Partial::new(MatrixName::M, 1, 0, 17, 85), Partial::new(MatrixName::M, 1, 1, 17, 86),
        Partial::new(MatrixName::C1, 0, 1, 17, 87), Partial::new(MatrixName::C1, 1, 1, 17, 88),
        Partial::new(MatrixName::K0, 0, 0, 17, 89), Partial::new(MatrixName::K0, 0, 1, 17, 90),
        Partial::new(MatrixName::K0, 1, 0, 17, 90), Partial::new(MatrixName::K0, 1, 1, 17, 91),
        Partial::new(MatrixName::K2, 0, 1, 17, 92).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 93), Partial::new(MatrixName::M, 0, 0, 18, 36),
        Partial::new(MatrixName::M, 0, 1, 18, 94), Partial::new(MatrixName::M, 1, 0, 18, 94),
        Partial::new(MatrixName::M, 1, 1, 18, 95), Partial::new(MatrixName::M, 1, 1, 20, 96),
        Partial::new(MatrixName::C1, 1, 1, 20, 97), Partial::new(MatrixName::M, 0, 1, 21, 98),
        Partial::new(MatrixName::M, 1, 0, 21, 98), Partial::new(MatrixName::M, 1, 1, 21, 99),
        Partial::new(MatrixName::C1, 0, 1, 21, 65), Partial::new(MatrixName::C1, 1, 1, 21, 100),
        Partial::new(MatrixName::M, 0, 0, 22, 101), Partial::new(MatrixName::M, 0, 1, 22, 102),
        Partial::new(MatrixName::M, 1, 0, 22, 102), Partial::new(MatrixName::M, 1, 1, 22, 103),
        Partial::new(MatrixName::C1, 0, 1, 22, 104), Partial::new(MatrixName::C1, 1, 0, 22, 105),
        Partial::new(MatrixName::C1, 1, 1, 22, 106),
        Partial::new(MatrixName::K0, 0, 0, 22, 107).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 108).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 108).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 109).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 110), Partial::new(MatrixName::K2, 1, 1, 22, 111),
        Partial::new(MatrixName::M, 0, 0, 23, 112), Partial::new(MatrixName::M, 0, 1, 23, 113),
        Partial::new(MatrixName::M, 1, 0, 23, 113), Partial::new(MatrixName::M, 1, 1, 23, 114),
        Partial::new(MatrixName::C1, 0, 1, 23, 115), Partial::new(MatrixName::C1, 1, 1, 23, 116),
        Partial::new(MatrixName::K0, 0, 0, 23, 117), Partial::new(MatrixName::K0, 0, 1, 23, 118),
        Partial::new(MatrixName::K0, 1, 0, 23, 118), Partial::new(MatrixName::K0, 1, 1, 23, 119),
        Partial::new(MatrixName::K2, 0, 1, 23, 120), Partial::new(MatrixName::K2, 1, 1, 23, 121),
        Partial::new(MatrixName::M, 0, 0, 24, 36), Partial::new(MatrixName::M, 0, 1, 24, 94),
        Partial::new(MatrixName::M, 1, 0, 24, 94), Partial::new(MatrixName::M, 1, 1, 24, 122),
        Partial::new(MatrixName::C1, 1, 1, 24, 97), Partial::new(MatrixName::C1, 0, 1, 25, 123),
        Partial::new(MatrixName::C1, 1, 0, 25, 123).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 124), Partial::new(MatrixName::K2, 1, 1, 25, 125),
        Partial::new(MatrixName::K0, 0, 0, 26, 126), Partial::new(MatrixName::K0, 0, 0, 27, 127),
        Partial::new(MatrixName::K0, 0, 1, 27, 128), Partial::new(MatrixName::K0, 1, 0, 27, 128),
        Partial::new(MatrixName::K0, 1, 1, 27, 129),
    ];
}
