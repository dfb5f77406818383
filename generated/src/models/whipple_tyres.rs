// @generated from generated/models/whipple_tyres.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 4689e1a6c62163ba

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    FormulaInfo, LengthError, MatrixName, Model, ModelInfo, Number, ParameterError,
    ParameterInfo, Partial, Rate, RequirementInfo, Rows, Scalar, SetInfo, WithDerivatives,
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
