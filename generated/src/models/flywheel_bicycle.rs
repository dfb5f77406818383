// @generated from generated/models/flywheel_bicycle.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 79e8bfc3e5c2959e

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A bicycle with flywheels: rotors that spin at a constant rate in its frames.
///
/// The Whipple-Carvallo bicycle with a flywheel in the front wheel, as learners ride it, and one in the rear frame. Their
/// angular momenta are independent of the speed, so they act at rest as well; against the wheels they cancel what those
/// do at one speed. The masses and moments of inertia of the flywheels are parts of those of the frames. Axes: origin at
/// the rear contact point, x forward, y to the right, z down.
///
/// The declaration asserts that the matrices are those of Appendix A of the paper and, for the flywheels, its terms of the
/// wheels with angular momenta in the place of those of wheels that roll.
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
/// C0_12 = hH*cos(lam) + mu*(hB + hH) [kg*m^2/s]
/// C0_21 = -(hH*cos(lam) + mu*(hB + hH)) [kg*m^2/s]
/// C1_12 = mu*(ST - Sz_all) + SF*cos(lam) + yaw_per_v_delta*Jxz_all [kg*m]
/// C1_21 = -(mu*ST + SF*cos(lam)) [kg*m]
/// C1_22 = mu*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
/// K0_11 = Sz_all [kg*m]
/// K0_12 = K0_21 = K_phi_delta [kg*m]
/// K0_22 = K_delta_delta [kg*m]
/// K1_12 = yaw_per_v_delta*(hB + hH) [kg*m/s]
/// K1_22 = hH*yaw_per_v_delta*sin(lam) [kg*m/s]
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
pub struct FlywheelBicycle<T = f64> {
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
    /// Angular momentum of the flywheel in the rear frame, positive as the wheels turn.
    ///
    /// `hB` in `N*m*s`: any finite value.
    pub hB: T,
    /// Angular momentum of the flywheel in the front frame, positive as the wheels turn.
    ///
    /// `hH` in `N*m*s`: any finite value.
    pub hH: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`FlywheelBicycle`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlywheelBicycleMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C0, a coefficient of q'.
    pub c0: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
    /// Stiffness K1, a coefficient of v q.
    pub k1: Rows<T, 2>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 2>,
}

impl<T: Number> FlywheelBicycle<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 42 additions, 49 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 98 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> FlywheelBicycleMatrices<T> {
        let t2 = self.zB * self.mB;
        let t10 = self.rF * self.mF;
        let t13 = self.IHxx + (self.IFxx + self.rF * t10);
        let t19 = self.zH * self.mH;
        let t23 = self.rR * self.mR;
        let M_11 = self.zB * t2 + (self.IBxx + (self.IRxx + t13))
            + (self.zH * t19 + self.rR * t23);
        let (wx_delta2_delta, cos_lam) = self.lam.sin_cos();
        let t33 = self.w.like(1.0) / self.w;
        let yaw_per_v_delta = cos_lam * t33;
        let mu = self.c * yaw_per_v_delta;
        let wz_delta2_delta = cos_lam + mu;
        let t39 = t13 * wx_delta2_delta + wz_delta2_delta * self.IHxz;
        let t42 = self.mB * self.xB;
        let t44 = self.zB * t42 - self.IBxz;
        let t52 = self.zH * wx_delta2_delta
            + (cos_lam * (self.c + self.w) - self.xH * wz_delta2_delta);
        let t53 = self.mH * t52;
        let M_12 = t39 + (self.zH * t53 - mu * t44);
        let t62 = wz_delta2_delta * (self.IFxx + self.IHzz)
            + wx_delta2_delta * self.IHxz;
        let ay_delta2_delta = mu * (self.IBzz + (self.IRxx + self.xB * t42));
        let M_22 = t52 * t53 + wz_delta2_delta * t62
            + (mu * ay_delta2_delta + wx_delta2_delta * t39);
        let zero = self.w.like(0.0);
        let t76 = cos_lam * self.hH;
        let K1_12 = yaw_per_v_delta * (self.hH + self.hB);
        let C0_12 = t76 + self.c * K1_12;
        let SF = self.IFyy / self.rF;
        let SR = self.IRyy / self.rR;
        let K0_11 = t19 + t2 - (t23 + t10);
        let t91 = SF - (K0_11 - SR);
        let t98 = t10 + SF - t33 * (t44 + (t19 * self.xH - self.c * t91) - self.IHxz);
        let C1_12 = cos_lam * t98;
        let t103 = t10 * wx_delta2_delta;
        let t106 = t53 - mu * t42;
        let K0_12 = t106 - t103;
        let K0_22 = wx_delta2_delta * K0_12;
        let K1_22 = wx_delta2_delta * (t33 * t76);
        let K2_12 = yaw_per_v_delta * t91;
        let K2_22 = (wx_delta2_delta * SF - K0_12) * yaw_per_v_delta;
        let C0_21 = -C0_12;
        let C1_21 = -(mu * SR + wz_delta2_delta * SF);
        let C1_22 = wz_delta2_delta * t103
            - (self.c * t106 + (self.xH * t53 - t62) - ay_delta2_delta)
                * yaw_per_v_delta;
        FlywheelBicycleMatrices::from_entries([
            M_11, M_12, M_12, M_22, zero, C0_12, C0_21, zero, zero, C1_12, C1_21, C1_22, K0_11,
            K0_12, K0_12, K0_22, zero, K1_12, zero, K1_22, zero, K2_12, zero, K2_22,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`FlywheelBicycle`] that follow from its coordinates q = (`phi`, `delta`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlywheelBicycleKinematics<T = f64> {
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

impl<T: Scalar> FlywheelBicycle<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> FlywheelBicycleKinematics<T> {
        let zero = self.w.like(0.0);
        let yaw_per_v_delta = self.lam.cos() / self.w;
        let mu = self.c * yaw_per_v_delta;
        let t12 = -(self.w.like(1.0) / self.rR);
        let t13 = -(self.w.like(1.0) / self.rF);
        FlywheelBicycleKinematics {
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

/// The derivatives of the matrices of [`FlywheelBicycle`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlywheelBicycleDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 130],
}

impl<T: Number> FlywheelBicycle<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 100 additions, 189 multiplications, 3 divisions, 6 negations and 2 trigonometric functions: 300 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (FlywheelBicycleMatrices<T>, FlywheelBicycleDerivatives<T>) {
        let t4 = self.rF * self.mF;
        let t7 = self.IHxx + self.IFxx + self.rF * t4;
        let t10 = self.zB * self.mB;
        let M_22_mu = self.zB * t10;
        let t14 = self.rR * self.mR;
        let M_11_mH = self.zH * self.zH;
        let M_11 = t7 + M_22_mu + self.rR * t14 + self.IBxx + self.IRxx
            + self.mH * M_11_mH;
        let (wx_delta2_delta, wx_delta2_delta_lam) = self.lam.sin_cos();
        let t31 = self.w.like(1.0) / self.w;
        let yaw_per_v_delta = wx_delta2_delta_lam * t31;
        let mu = self.c * yaw_per_v_delta;
        let ay_delta2_delta = t10 * self.xB;
        let t37 = self.IBxz - ay_delta2_delta;
        let wz_delta2_delta = wx_delta2_delta_lam + mu;
        let t44 = self.IHxz * wz_delta2_delta + t7 * wx_delta2_delta;
        let t45 = self.zH * wx_delta2_delta;
        let t47 = self.c * t31;
        let t51 = self.xH + self.xH * t47 - self.c - self.w;
        let K0_12_mH = t45 - wx_delta2_delta_lam * t51;
        let M_12_mH = self.zH * K0_12_mH;
        let t56 = t44 + self.mH * M_12_mH;
        let M_12 = mu * t37 + t56;
        let M_22_mH = K0_12_mH * K0_12_mH;
        let t62 = self.mB * self.xB;
        let t66 = yaw_per_v_delta * (self.IRxx + self.IBzz + self.xB * t62);
        let t67 = self.c * t66;
        let t69 = self.IHxz * wx_delta2_delta;
        let t71 = self.IFxx + self.IHzz;
        let t73 = t69 + wz_delta2_delta * t71;
        let M_22 = wx_delta2_delta * t44 + self.mH * M_22_mH + mu * t67
            + wz_delta2_delta * t73;
        let zero = self.w.like(0.0);
        let t81 = self.hH + self.hB;
        let t83 = self.hH + t47 * t81;
        let C0_12 = wx_delta2_delta_lam * t83;
        let t86 = self.w.like(1.0) / self.rF;
        let SF = self.IFyy * t86;
        let t88 = self.mH * self.zH;
        let K0_11 = t10 + t88 - t4 - t14;
        let t93 = self.w.like(1.0) / self.rR;
        let SR = self.IRyy * t93;
        let t95 = SF + SR;
        let t96 = t95 - K0_11;
        let M_12_mu = t37 + self.IHxz;
        let t100 = self.xH * t88 - M_12_mu;
        let t102 = t31 * (self.c * t96 - t100);
        let t104 = t4 + SF + t102;
        let C1_12 = wx_delta2_delta_lam * t104;
        let t106 = wx_delta2_delta_lam * SF;
        let t109 = t67 + t73;
        let t110 = self.mH * K0_12_mH;
        let t111 = self.mB * mu;
        let t112 = self.xB * t111;
        let t113 = t112 - t110;
        let t117 = t109 + self.c * t113 - self.xH * t110;
        let t119 = self.mF * wx_delta2_delta;
        let t120 = self.rF * t119;
        let M_22_wz_delta2_delta = wz_delta2_delta * t120;
        let C1_22 = yaw_per_v_delta * t117 + M_22_wz_delta2_delta;
        let t123 = t113 + t120;
        let K1_12 = yaw_per_v_delta * t81;
        let t126 = t31 * wx_delta2_delta;
        let K2_22_SF = wx_delta2_delta_lam * t126;
        let K1_22 = self.hH * K2_22_SF;
        let K2_12 = yaw_per_v_delta * t96;
        let t130 = wx_delta2_delta * SF;
        let K2_22_yaw_per_v_delta = t123 + t130;
        let K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
        let t133 = wx_delta2_delta_lam * t88;
        let t134 = yaw_per_v_delta * t100;
        let M_12_w = t133 + t47 * t134;
        let t137 = yaw_per_v_delta * self.xH;
        let t139 = wx_delta2_delta_lam + t47 * t137;
        let t140 = t110 + t110;
        let t142 = yaw_per_v_delta * t109;
        let t143 = t142 + t142;
        let M_22_w = t139 * t140 - t47 * t143;
        let C0_21_w = t47 * K1_12;
        let t147 = yaw_per_v_delta * t102;
        let t148 = yaw_per_v_delta * t95;
        let C1_21_w = t47 * t148;
        let t151 = t120 + yaw_per_v_delta * t71;
        let C1_22_mu = t66 + t112 + t151;
        let ay_delta2_delta_mu = t117 + self.c * C1_22_mu;
        let t156 = t31 * ay_delta2_delta_mu;
        let t157 = self.c + self.xH;
        let t158 = self.mH * t139;
        let t161 = yaw_per_v_delta * (t156 + t157 * t158);
        let K0_12_w = t158 + t31 * t112;
        let K0_22_w = wx_delta2_delta * K0_12_w;
        let t165 = t31 * K1_12;
        let t166 = t31 * K1_22;
        let t167 = t31 * K2_12;
        let t170 = t31 * (K2_22 + wx_delta2_delta_lam * K0_12_w);
        let M_12_c = t133 - t134;
        let t172 = wx_delta2_delta_lam - t137;
        let M_22_c = t143 + t140 * t172;
        let t175 = self.mH * t172;
        let C1_22_c = yaw_per_v_delta * (t113 + C1_22_mu - t157 * t175);
        let t180 = yaw_per_v_delta * t62;
        let K0_12_c = t175 - t180;
        let t184 = wx_delta2_delta * t47;
        let K0_12_zH = self.mH * wx_delta2_delta;
        let t189 = t133 + t51 * K0_12_zH;
        let t193 = t69 + M_12_mu * t184 - t7 * wx_delta2_delta_lam - self.zH * t189;
        let t200 = wx_delta2_delta * (t73 + t47 * t109 - t51 * t110)
            - wx_delta2_delta_lam * t56;
        let t201 = t200 + t200;
        let C0_21_lam = wx_delta2_delta * t83;
        let t203 = wx_delta2_delta * t104;
        let C1_21_lam = t130 + t95 * t184;
        let t206 = t4 * wx_delta2_delta_lam;
        let ay_delta2_delta_xB = wx_delta2_delta_lam * yaw_per_v_delta;
        let t212 = mu + t137;
        let C1_22_lam = wz_delta2_delta * t206 + self.IHxz * ay_delta2_delta_xB
            - wx_delta2_delta * (t151 + t156) - t189 * t212;
        let K0_12_lam = t189 + t62 * t184 - t206;
        let K0_22_lam = wx_delta2_delta * K0_12_lam - wx_delta2_delta_lam * t123;
        let t223 = t81 * t126;
        let t226 = self.hH * (wx_delta2_delta * t126 - ay_delta2_delta_xB);
        let t227 = t96 * t126;
        let K2_22_lam = yaw_per_v_delta * (t106 - K0_12_lam)
            - t126 * K2_22_yaw_per_v_delta;
        let M_11_rR = t14 + t14;
        let K2_12_IRyy = yaw_per_v_delta * t93;
        let K2_12_rR = self.mR * yaw_per_v_delta - SR * K2_12_IRyy;
        let C1_12_rR = self.c * K2_12_rR;
        let C1_12_IRyy = self.c * K2_12_IRyy;
        let C1_21_rR = SR * C1_12_IRyy;
        let M_11_mR = self.rR * self.rR;
        let C1_12_mR = self.rR * mu;
        let K2_12_mR = self.rR * yaw_per_v_delta;
        let C1_22_IRxx = yaw_per_v_delta * mu;
        let M_22_IRxx = self.c * C1_22_IRxx;
        let t246 = t10 * mu;
        let t247 = t62 * M_22_IRxx;
        let M_22_xB = t247 + t247;
        let t249 = t10 * yaw_per_v_delta;
        let K2_22_xB = yaw_per_v_delta * t111;
        let t251 = self.c + self.xB;
        let C1_22_xB = K2_22_xB * (self.xB + t251);
        let t254 = wx_delta2_delta * t111;
        let M_11_zB = t10 + t10;
        let t256 = t111 + t180;
        let t257 = self.mB * yaw_per_v_delta;
        let M_11_mB = self.zB * self.zB;
        let t259 = mu * self.xB;
        let t260 = self.zB * t259;
        let M_22_mB = t259 * t259;
        let t262 = self.zB * yaw_per_v_delta;
        let t263 = t251 * t262;
        let K2_22_mB = self.xB * C1_22_IRxx;
        let C1_22_mB = t251 * K2_22_mB;
        let t266 = wx_delta2_delta * t259;
        let t267 = self.mH * wz_delta2_delta;
        let t268 = self.zH * t267;
        let t269 = wz_delta2_delta * t110;
        let t270 = t269 + t269;
        let t271 = self.zH * yaw_per_v_delta;
        let t272 = self.mH * t271;
        let C1_22_IHzz = ay_delta2_delta_xB + C1_22_IRxx;
        let t275 = yaw_per_v_delta * K0_12_mH;
        let C1_22_xH = self.mH * (t157 * C1_22_IHzz - t275);
        let t278 = wx_delta2_delta * t267;
        let K2_22_xH = self.mH * C1_22_IHzz;
        let M_11_zH = t88 + t88;
        let M_12_zH = t110 + self.mH * t45;
        let M_22_zH = wx_delta2_delta * t140;
        let t284 = self.mH * t212;
        let t285 = K0_12_zH * t212;
        let M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
        let K0_22_zH = self.mH * M_22_IHxx;
        let t288 = self.mH * yaw_per_v_delta;
        let t289 = wx_delta2_delta * t288;
        let t290 = t157 * t271;
        let t291 = K0_12_mH * t212;
        let K0_22_mH = wx_delta2_delta * K0_12_mH;
        let M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
        let t294 = wz_delta2_delta * wx_delta2_delta;
        let M_22_IHxz = t294 + t294;
        let M_11_rF = t4 + t4;
        let M_12_rF = t120 + t120;
        let t298 = wx_delta2_delta * t120;
        let M_22_rF = t298 + t298;
        let t301 = self.mF - t86 * SF;
        let C1_12_rF = wz_delta2_delta * t301;
        let C1_12_IFyy = wz_delta2_delta * t86;
        let C1_21_rF = SF * C1_12_IFyy;
        let C1_22_rF = wz_delta2_delta * t119;
        let t306 = wx_delta2_delta * t119;
        let K2_12_rF = yaw_per_v_delta * t301;
        let K2_22_rF = K2_22_SF * t301;
        let M_11_mF = self.rF * self.rF;
        let M_12_mF = wx_delta2_delta * M_11_mF;
        let M_22_mF = M_22_IHxx * M_11_mF;
        let C1_12_mF = self.rF * wz_delta2_delta;
        let C1_22_mF = self.rF * t294;
        let t314 = self.rF * wx_delta2_delta;
        let t315 = wx_delta2_delta * t314;
        let K2_12_mF = self.rF * yaw_per_v_delta;
        let K2_22_mF = self.rF * K2_22_SF;
        let M_22_IFxx = M_22_IHxx + M_22_IHzz;
        let K2_12_IFyy = yaw_per_v_delta * t86;
        let K2_22_IFyy = t86 * K2_22_SF;
        let C0_21 = -C0_12;
        let C1_21 = -(t106 + mu * t95);
        let K0_12 = -t123;
        let K0_22 = -(wx_delta2_delta * t123);
        let t325 = -(wx_delta2_delta * K0_12_c);
        let K2_22_c = -(yaw_per_v_delta * K0_12_c);
        (
            FlywheelBicycleMatrices::from_entries([
                M_11, M_12, M_12, M_22, zero, C0_12, C0_21, zero, zero, C1_12, C1_21, C1_22, K0_11,
                K0_12, K0_12, K0_22, zero, K1_12, zero, K1_22, zero, K2_12, zero, K2_22,
            ]),
            FlywheelBicycleDerivatives {
                values: [
                    M_12_w, M_22_w, C0_21_w, t147, C1_21_w, t161, K0_12_w, K0_22_w, t165, t166,
                    t167, t170, M_12_c, M_22_c, K1_12, K2_12, t148, C1_22_c, K0_12_c, t325, K2_22_c,
                    t193, t201, C0_21_lam, t203, C1_21_lam, C1_22_lam, K0_12_lam, K0_22_lam, t223,
                    t226, t227, K2_22_lam, M_11_rR, C1_12_rR, C1_21_rR, self.mR, K2_12_rR, M_11_mR,
                    C1_12_mR, self.rR, K2_12_mR, self.w.like(1.0), M_22_IRxx, C1_22_IRxx,
                    C1_12_IRyy, K2_12_IRyy, t246, M_22_xB, t249, C1_22_xB, t111, t254, K2_22_xB,
                    M_11_zB, t112, t256, self.mB, t257, M_11_mB, t260, M_22_mB, t263, C1_22_mB,
                    self.zB, t259, t266, t262, K2_22_mB, mu, yaw_per_v_delta, t268, t270, t272,
                    C1_22_xH, t267, t278, K2_22_xH, M_11_zH, M_12_zH, M_22_zH, t284, t285, self.mH,
                    K0_12_zH, K0_22_zH, t288, t289, M_11_mH, M_12_mH, M_22_mH, t290, t291, self.zH,
                    K0_12_mH, K0_22_mH, t271, t275, wx_delta2_delta, M_22_IHxx, M_22_IHzz,
                    C1_22_IHzz, wz_delta2_delta, M_22_IHxz, K2_22_SF, M_11_rF, M_12_rF, M_22_rF,
                    C1_12_rF, C1_21_rF, C1_22_rF, self.mF, t119, t306, K2_12_rF, K2_22_rF, M_11_mF,
                    M_12_mF, M_22_mF, C1_12_mF, C1_22_mF, self.rF, t314, t315, K2_12_mF, K2_22_mF,
                    M_22_IFxx, C1_12_IFyy, K2_12_IFyy, K2_22_IFyy,
                ],
            },
        )
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl FlywheelBicycle<f64> {
    /// The parameter set `benchmark`.
    ///
    /// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; the flywheel in the front wheel is an example
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
    /// | `hB` | 0 | `N*m*s` |
    /// | `hH` | 5 | `N*m*s` |
    pub const BENCHMARK: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3141592653589793, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.0603,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.05892, IHyy: 0.06, IHzz: 0.00708, IHxz: -0.00756,
        rF: 0.35, mF: 3.0, IFxx: 0.1405, IFyy: 0.28, hB: 0.0, hH: 5.0,
    };
}

impl FlywheelBicycle<f64> {
    /// The parameter set `benchmark`.
    #[must_use]
    pub const fn default() -> Self {
        Self::BENCHMARK
    }
}

/// The parameter set `benchmark`.
impl<T: Scalar> Default for FlywheelBicycle<T> {
    fn default() -> Self {
        FlywheelBicycle::cast(&FlywheelBicycle::<f64>::BENCHMARK)
    }
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> FlywheelBicycle<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 28]) -> Self {
        Self {
            w: values[0], c: values[1], lam: values[2], g: values[3], rR: values[4], mR: values[5],
            IRxx: values[6], IRyy: values[7], xB: values[8], zB: values[9], mB: values[10],
            IBxx: values[11], IByy: values[12], IBzz: values[13], IBxz: values[14], xH: values[15],
            zH: values[16], mH: values[17], IHxx: values[18], IHyy: values[19], IHzz: values[20],
            IHxz: values[21], rF: values[22], mF: values[23], IFxx: values[24], IFyy: values[25],
            hB: values[26], hH: values[27],
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
            self.hB, self.hH,
        ]
    }
}

impl<T: Scalar> FlywheelBicycle<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> FlywheelBicycle<U> {
        let values = self.to_array();
        FlywheelBicycle::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl FlywheelBicycle<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> FlywheelBicycle<f32> {
        FlywheelBicycle::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<FlywheelBicycle<f32>> for FlywheelBicycle<f64> {
    fn from(parameters: FlywheelBicycle<f32>) -> Self {
        FlywheelBicycle::cast(&parameters)
    }
}

impl<T: Number> FlywheelBicycleMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 24]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c0: carvallo::rows(&entries, 4),
            c1: carvallo::rows(&entries, 8),
            k0: carvallo::rows(&entries, 12),
            k1: carvallo::rows(&entries, 16),
            k2: carvallo::rows(&entries, 20),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 15] {
        [
            self.m[0][0], self.m[0][1], self.m[1][1], self.c0[0][1], self.c0[1][0], self.c1[0][1],
            self.c1[1][0], self.c1[1][1], self.k0[0][0], self.k0[0][1], self.k0[1][1],
            self.k1[0][1], self.k1[1][1], self.k2[0][1], self.k2[1][1],
        ]
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, self.c0.0, self.c1.0, zeros, self.k0.0, self.k1.0, self.k2.0]
    }
}

impl<T: Scalar> From<FlywheelBicycleMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: FlywheelBicycleMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for FlywheelBicycle<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 28];

    type Over<U: Number> = FlywheelBicycle<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "FlywheelBicycle",
        docs: "A bicycle with flywheels: rotors that spin at a constant rate in its frames.\n\nThe Whipple-Carvallo bicycle with a flywheel in the front wheel, as learners ride it, and one in the rear frame. Their\nangular momenta are independent of the speed, so they act at rest as well; against the wheels they cancel what those\ndo at one speed. The masses and moments of inertia of the flywheels are parts of those of the frames. Axes: origin at\nthe rear contact point, x forward, y to the right, z down.\n\nThe declaration asserts that the matrices are those of Appendix A of the paper and, for the flywheels, its terms of the\nwheels with angular momenta in the place of those of wheels that roll.",
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
            ParameterInfo::new("hB", "N*m*s", Domain::FINITE)
                .docs("Angular momentum of the flywheel in the rear frame, positive as the wheels turn."),
            ParameterInfo::new("hH", "N*m*s", Domain::FINITE)
                .docs("Angular momentum of the flywheel in the front frame, positive as the wheels turn."),
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
            MatrixName::M, MatrixName::C0, MatrixName::C1, MatrixName::K0, MatrixName::K1,
            MatrixName::K2,
        ],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]), EntryInfo::at(&[(MatrixName::C0, 0, 1)]),
            EntryInfo::at(&[(MatrixName::C0, 1, 0)]), EntryInfo::at(&[(MatrixName::C1, 0, 1)]),
            EntryInfo::at(&[(MatrixName::C1, 1, 0)]), EntryInfo::at(&[(MatrixName::C1, 1, 1)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 1, 1)]), EntryInfo::at(&[(MatrixName::K1, 0, 1)]),
            EntryInfo::at(&[(MatrixName::K1, 1, 1)]), EntryInfo::at(&[(MatrixName::K2, 0, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 1, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "benchmark",
                docs: "",
                source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; the flywheel in the front wheel is an example",
                values: &FlywheelBicycle::to_array(&FlywheelBicycle::<f64>::BENCHMARK),
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
            FormulaInfo::entry(&[(MatrixName::C0, 0, 1)], "kg*m^2/s", "hH*cos(lam) + mu*(hB + hH)"),
            FormulaInfo::entry(&[(MatrixName::C0, 1, 0)], "kg*m^2/s", "-(hH*cos(lam) + mu*(hB + hH))"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 1)],
                "kg*m",
                "mu*(ST - Sz_all) + SF*cos(lam) + yaw_per_v_delta*Jxz_all",
            ),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 0)], "kg*m", "-(mu*ST + SF*cos(lam))"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 1)], "kg*m", "mu*P_delta_lateral + yaw_per_v_delta*P_delta_yaw"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "Sz_all"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)], "kg*m", "K_phi_delta"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "K_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::K1, 0, 1)], "kg*m/s", "yaw_per_v_delta*(hB + hH)"),
            FormulaInfo::entry(&[(MatrixName::K1, 1, 1)], "kg*m/s", "hH*yaw_per_v_delta*sin(lam)"),
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
            FormulaInfo::attribute(
                "B_momentum_y", "y of the momentum in the rear frame and rider B", "kg*m^2/s",
                "-hB",
            ),
            FormulaInfo::attribute("H_momentum_y", "y of the momentum in the front frame H", "kg*m^2/s", "-hH"),
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
            FormulaInfo::entry(
                &[(MatrixName::C0, 0, 1)],
                "kg*m^2/s",
                "(delta_along_x*H_momentum_y*yaw_by_phi_ - delta_along_z*H_momentum_y - length_delta*yaw_by_delta*(B_momentum_y + H_momentum_y))/length_delta",
            ),
            FormulaInfo::entry(
                &[(MatrixName::C0, 1, 0)],
                "kg*m^2/s",
                "(delta_along_z*H_momentum_y + length_delta*yaw_by_delta*(B_momentum_y + H_momentum_y) - delta_along_x*H_momentum_y*yaw_by_phi_)/length_delta",
            ),
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
            FormulaInfo::entry(&[(MatrixName::K1, 0, 1)], "kg*m/s", "-yaw_per_v_delta*(B_momentum_y + H_momentum_y)"),
            FormulaInfo::entry(
                &[(MatrixName::K1, 1, 1)],
                "kg*m/s",
                "-delta_along_x*H_momentum_y*yaw_per_v_delta/length_delta",
            ),
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
        LengthError::check("FlywheelBicycle", 28, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("FlywheelBicycle", 28, values)?;
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
        Coefficients::from_rows(FlywheelBicycleMatrices::rows(&self.matrices()))
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

impl FlywheelBicycle<f64> {
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
impl<T: Scalar> core::fmt::Display for FlywheelBicycle<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for FlywheelBicycle<T> {
    type Entries = [T; 15];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            w: parameter(0), c: parameter(1), lam: parameter(2), g: parameter(3), rR: parameter(4),
            mR: parameter(5), IRxx: parameter(6), IRyy: parameter(7), xB: parameter(8),
            zB: parameter(9), mB: parameter(10), IBxx: parameter(11), IByy: parameter(12),
            IBzz: parameter(13), IBxz: parameter(14), xH: parameter(15), zH: parameter(16),
            mH: parameter(17), IHxx: parameter(18), IHyy: parameter(19), IHzz: parameter(20),
            IHxz: parameter(21), rF: parameter(22), mF: parameter(23), IFxx: parameter(24),
            IFyy: parameter(25), hB: parameter(26), hH: parameter(27),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        FlywheelBicycleMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        FlywheelBicycleMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> FlywheelBicycleDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<FlywheelBicycleMatrices<T>> {
        if parameter >= 28 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = FlywheelBicycleMatrices {
            m: Rows([[zero; 2]; 2]), c0: Rows([[zero; 2]; 2]), c1: Rows([[zero; 2]; 2]),
            k0: Rows([[zero; 2]; 2]), k1: Rows([[zero; 2]; 2]), k2: Rows([[zero; 2]; 2]),
        };
        for position in 0..175 {
            let partial = <FlywheelBicycleDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C0 => &mut matrices.c0,
                MatrixName::C1 => &mut matrices.c1,
                MatrixName::K0 => &mut matrices.k0,
                MatrixName::K1 => &mut matrices.k1,
                MatrixName::K2 => &mut matrices.k2,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<2> for FlywheelBicycle<T> {
    type Derivatives = [Coefficients<T, 2>; 28];

    type WithDerivativesOver<U: Number> = FlywheelBicycle<U>;

    const PARTIALS: &'static [Partial] = <FlywheelBicycleDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 28];
        for position in 0..175 {
            Partial::write(&<FlywheelBicycleDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(FlywheelBicycleMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for FlywheelBicycle<T> {
    type Derivatives = [T; 130];

    #[inline(always)]
    fn entries_and_derivatives(&self) -> ([T; 15], [T; 130]) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        (FlywheelBicycleMatrices::distinct_entries(&matrices), derivatives.values)
    }
}

impl FlywheelBicycleDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 175] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 0), Partial::new(MatrixName::M, 1, 0, 0, 0),
        Partial::new(MatrixName::M, 1, 1, 0, 1),
        Partial::new(MatrixName::C0, 0, 1, 0, 2).negative(),
        Partial::new(MatrixName::C0, 1, 0, 0, 2),
        Partial::new(MatrixName::C1, 0, 1, 0, 3).negative(),
        Partial::new(MatrixName::C1, 1, 0, 0, 4),
        Partial::new(MatrixName::C1, 1, 1, 0, 5).negative(),
        Partial::new(MatrixName::K0, 0, 1, 0, 6), Partial::new(MatrixName::K0, 1, 0, 0, 6),
        Partial::new(MatrixName::K0, 1, 1, 0, 7),
        Partial::new(MatrixName::K1, 0, 1, 0, 8).negative(),
        Partial::new(MatrixName::K1, 1, 1, 0, 9).negative(),
        Partial::new(MatrixName::K2, 0, 1, 0, 10).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 11).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 12), Partial::new(MatrixName::M, 1, 0, 1, 12),
        Partial::new(MatrixName::M, 1, 1, 1, 13), Partial::new(MatrixName::C0, 0, 1, 1, 14),
        Partial::new(MatrixName::C0, 1, 0, 1, 14).negative(),
        Partial::new(MatrixName::C1, 0, 1, 1, 15),
        Partial::new(MatrixName::C1, 1, 0, 1, 16).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 17),
        Partial::new(MatrixName::K0, 0, 1, 1, 18),
        Partial::new(MatrixName::K0, 1, 0, 1, 18),
        Partial::new(MatrixName::K0, 1, 1, 1, 19).negative(),
        Partial::new(MatrixName::K2, 1, 1, 1, 20),
        Partial::new(MatrixName::M, 0, 1, 2, 21).negative(),
        Partial::new(MatrixName::M, 1, 0, 2, 21).negative(),
        Partial::new(MatrixName::M, 1, 1, 2, 22).negative(),
        Partial::new(MatrixName::C0, 0, 1, 2, 23).negative(),
        Partial::new(MatrixName::C0, 1, 0, 2, 23),
        Partial::new(MatrixName::C1, 0, 1, 2, 24).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 25), Partial::new(MatrixName::C1, 1, 1, 2, 26),
        Partial::new(MatrixName::K0, 0, 1, 2, 27), Partial::new(MatrixName::K0, 1, 0, 2, 27),
        Partial::new(MatrixName::K0, 1, 1, 2, 28),
        Partial::new(MatrixName::K1, 0, 1, 2, 29).negative(),
        Partial::new(MatrixName::K1, 1, 1, 2, 30).negative(),
        Partial::new(MatrixName::K2, 0, 1, 2, 31).negative(),
        Partial::new(MatrixName::K2, 1, 1, 2, 32), Partial::new(MatrixName::M, 0, 0, 4, 33),
        Partial::new(MatrixName::C1, 0, 1, 4, 34), Partial::new(MatrixName::C1, 1, 0, 4, 35),
        Partial::new(MatrixName::K0, 0, 0, 4, 36).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 37),
        Partial::new(MatrixName::M, 0, 0, 5, 38),
        Partial::new(MatrixName::C1, 0, 1, 5, 39),
        Partial::new(MatrixName::K0, 0, 0, 5, 40).negative(),
        Partial::new(MatrixName::K2, 0, 1, 5, 41), Partial::new(MatrixName::M, 0, 0, 6, 42),
        Partial::new(MatrixName::M, 1, 1, 6, 43), Partial::new(MatrixName::C1, 1, 1, 6, 44),
        Partial::new(MatrixName::C1, 0, 1, 7, 45),
        Partial::new(MatrixName::C1, 1, 0, 7, 45).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 46),
        Partial::new(MatrixName::M, 0, 1, 8, 47).negative(),
        Partial::new(MatrixName::M, 1, 0, 8, 47).negative(),
        Partial::new(MatrixName::M, 1, 1, 8, 48),
        Partial::new(MatrixName::C1, 0, 1, 8, 49).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 50),
        Partial::new(MatrixName::K0, 0, 1, 8, 51).negative(),
        Partial::new(MatrixName::K0, 1, 0, 8, 51).negative(),
        Partial::new(MatrixName::K0, 1, 1, 8, 52).negative(),
        Partial::new(MatrixName::K2, 1, 1, 8, 53), Partial::new(MatrixName::M, 0, 0, 9, 54),
        Partial::new(MatrixName::M, 0, 1, 9, 55).negative(),
        Partial::new(MatrixName::M, 1, 0, 9, 55).negative(),
        Partial::new(MatrixName::C1, 0, 1, 9, 56).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 57),
        Partial::new(MatrixName::K2, 0, 1, 9, 58).negative(),
        Partial::new(MatrixName::M, 0, 0, 10, 59),
        Partial::new(MatrixName::M, 0, 1, 10, 60).negative(),
        Partial::new(MatrixName::M, 1, 0, 10, 60).negative(),
        Partial::new(MatrixName::M, 1, 1, 10, 61),
        Partial::new(MatrixName::C1, 0, 1, 10, 62).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 63),
        Partial::new(MatrixName::K0, 0, 0, 10, 64),
        Partial::new(MatrixName::K0, 0, 1, 10, 65).negative(),
        Partial::new(MatrixName::K0, 1, 0, 10, 65).negative(),
        Partial::new(MatrixName::K0, 1, 1, 10, 66).negative(),
        Partial::new(MatrixName::K2, 0, 1, 10, 67).negative(),
        Partial::new(MatrixName::K2, 1, 1, 10, 68), Partial::new(MatrixName::M, 0, 0, 11, 42),
        Partial::new(MatrixName::M, 1, 1, 13, 43), Partial::new(MatrixName::C1, 1, 1, 13, 44),
        Partial::new(MatrixName::M, 0, 1, 14, 69), Partial::new(MatrixName::M, 1, 0, 14, 69),
        Partial::new(MatrixName::C1, 0, 1, 14, 70),
        Partial::new(MatrixName::M, 0, 1, 15, 71).negative(),
        Partial::new(MatrixName::M, 1, 0, 15, 71).negative(),
        Partial::new(MatrixName::M, 1, 1, 15, 72).negative(),
        Partial::new(MatrixName::C1, 0, 1, 15, 73).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 74),
        Partial::new(MatrixName::K0, 0, 1, 15, 75).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 75).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 76).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 77), Partial::new(MatrixName::M, 0, 0, 16, 78),
        Partial::new(MatrixName::M, 0, 1, 16, 79), Partial::new(MatrixName::M, 1, 0, 16, 79),
        Partial::new(MatrixName::M, 1, 1, 16, 80),
        Partial::new(MatrixName::C1, 0, 1, 16, 81).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 82).negative(),
        Partial::new(MatrixName::K0, 0, 0, 16, 83), Partial::new(MatrixName::K0, 0, 1, 16, 84),
        Partial::new(MatrixName::K0, 1, 0, 16, 84), Partial::new(MatrixName::K0, 1, 1, 16, 85),
        Partial::new(MatrixName::K2, 0, 1, 16, 86).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 87).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 88), Partial::new(MatrixName::M, 0, 1, 17, 89),
        Partial::new(MatrixName::M, 1, 0, 17, 89), Partial::new(MatrixName::M, 1, 1, 17, 90),
        Partial::new(MatrixName::C1, 0, 1, 17, 91).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 92).negative(),
        Partial::new(MatrixName::K0, 0, 0, 17, 93), Partial::new(MatrixName::K0, 0, 1, 17, 94),
        Partial::new(MatrixName::K0, 1, 0, 17, 94), Partial::new(MatrixName::K0, 1, 1, 17, 95),
        Partial::new(MatrixName::K2, 0, 1, 17, 96).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 97).negative(),
        Partial::new(MatrixName::M, 0, 0, 18, 42), Partial::new(MatrixName::M, 0, 1, 18, 98),
        Partial::new(MatrixName::M, 1, 0, 18, 98), Partial::new(MatrixName::M, 1, 1, 18, 99),
        Partial::new(MatrixName::M, 1, 1, 20, 100), Partial::new(MatrixName::C1, 1, 1, 20, 101),
        Partial::new(MatrixName::M, 0, 1, 21, 102), Partial::new(MatrixName::M, 1, 0, 21, 102),
        Partial::new(MatrixName::M, 1, 1, 21, 103), Partial::new(MatrixName::C1, 0, 1, 21, 70),
        Partial::new(MatrixName::C1, 1, 1, 21, 104), Partial::new(MatrixName::M, 0, 0, 22, 105),
        Partial::new(MatrixName::M, 0, 1, 22, 106), Partial::new(MatrixName::M, 1, 0, 22, 106),
        Partial::new(MatrixName::M, 1, 1, 22, 107), Partial::new(MatrixName::C1, 0, 1, 22, 108),
        Partial::new(MatrixName::C1, 1, 0, 22, 109), Partial::new(MatrixName::C1, 1, 1, 22, 110),
        Partial::new(MatrixName::K0, 0, 0, 22, 111).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 112).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 112).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 113).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 114), Partial::new(MatrixName::K2, 1, 1, 22, 115),
        Partial::new(MatrixName::M, 0, 0, 23, 116), Partial::new(MatrixName::M, 0, 1, 23, 117),
        Partial::new(MatrixName::M, 1, 0, 23, 117), Partial::new(MatrixName::M, 1, 1, 23, 118),
        Partial::new(MatrixName::C1, 0, 1, 23, 119), Partial::new(MatrixName::C1, 1, 1, 23, 120),
        Partial::new(MatrixName::K0, 0, 0, 23, 121).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 122).negative(),
        Partial::new(MatrixName::K0, 1, 0, 23, 122).negative(),
        Partial::new(MatrixName::K0, 1, 1, 23, 123).negative(),
        Partial::new(MatrixName::K2, 0, 1, 23, 124), Partial::new(MatrixName::K2, 1, 1, 23, 125),
        Partial::new(MatrixName::M, 0, 0, 24, 42), Partial::new(MatrixName::M, 0, 1, 24, 98),
        Partial::new(MatrixName::M, 1, 0, 24, 98), Partial::new(MatrixName::M, 1, 1, 24, 126),
        Partial::new(MatrixName::C1, 1, 1, 24, 101), Partial::new(MatrixName::C1, 0, 1, 25, 127),
        Partial::new(MatrixName::C1, 1, 0, 25, 127).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 128),
        Partial::new(MatrixName::K2, 1, 1, 25, 129),
        Partial::new(MatrixName::C0, 0, 1, 26, 69),
        Partial::new(MatrixName::C0, 1, 0, 26, 69).negative(),
        Partial::new(MatrixName::K1, 0, 1, 26, 70),
        Partial::new(MatrixName::C0, 0, 1, 27, 102),
        Partial::new(MatrixName::C0, 1, 0, 27, 102).negative(),
        Partial::new(MatrixName::K1, 0, 1, 27, 70),
        Partial::new(MatrixName::K1, 1, 1, 27, 104),
    ];
}
