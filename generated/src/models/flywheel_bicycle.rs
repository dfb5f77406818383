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
        let t7 = self.rF * self.mF;
        let t11 = self.IHxx + (self.rF * t7 + self.IFxx);
        let t16 = self.rR * self.mR;
        let t22 = self.zH * self.mH;
        let M_11 = self.zB * t2 + t11
            + (self.IBxx + self.rR * t16 + (self.IRxx + self.zH * t22));
        let (wx_delta2_delta, cos_lam) = self.lam.sin_cos();
        let t31 = self.w.like(1.0) / self.w;
        let yaw_per_v_delta = cos_lam * t31;
        let mu = self.c * yaw_per_v_delta;
        let wz_delta2_delta = cos_lam + mu;
        let t36 = wz_delta2_delta * self.IHxz;
        let t39 = t36 + t11 * wx_delta2_delta;
        let t43 = t2 * self.xB - self.IBxz;
        let t52 = cos_lam * (self.c + self.w)
            - (self.xH * wz_delta2_delta - self.zH * wx_delta2_delta);
        let t56 = self.mB * self.xB;
        let t61 = mu * (self.IRxx + (self.xB * t56 + self.IBzz));
        let t64 = self.mH * t52;
        let t68 = wz_delta2_delta * (self.IFxx + self.IHzz);
        let M_22 = wx_delta2_delta * (t36 + t39) + mu * t61
            + (t52 * t64 + wz_delta2_delta * t68);
        let zero = self.w.like(0.0);
        let ay_delta2_delta = cos_lam * self.hH;
        let t76 = self.hH + self.hB;
        let C0_12 = ay_delta2_delta + mu * t76;
        let t80 = t22 + (t2 - t16);
        let SR = self.IRyy / self.rR;
        let SF = self.IFyy / self.rF;
        let t92 = mu * SR + wz_delta2_delta * SF;
        let t96 = t7 * wz_delta2_delta + yaw_per_v_delta * self.IHxz;
        let t100 = t64 - mu * t56;
        let C1_22 = (t68 + (t61 - self.xH * t64 - self.c * t100)) * yaw_per_v_delta
            + wx_delta2_delta * t96;
        let K0_11 = t80 - t7;
        let K0_12 = t100 - t7 * wx_delta2_delta;
        let K0_22 = wx_delta2_delta * K0_12;
        let K1_12 = yaw_per_v_delta * t76;
        let K1_22 = t31 * (wx_delta2_delta * ay_delta2_delta);
        let vy_all1_delta = SR - K0_11 + SF;
        let K2_12 = yaw_per_v_delta * vy_all1_delta;
        let K2_22 = yaw_per_v_delta * (wx_delta2_delta * SF - K0_12);
        let M_12 = t22 * t52 - (mu * t43 - t39);
        let C0_21 = -C0_12;
        let C1_12 = t96 - (yaw_per_v_delta * (t43 + self.c * t80 + t22 * self.xH) - t92);
        let C1_21 = -t92;
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
    /// 102 additions, 191 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 300 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (FlywheelBicycleMatrices<T>, FlywheelBicycleDerivatives<T>) {
        let t4 = self.rF * self.mF;
        let t7 = self.IHxx + self.IFxx + self.rF * t4;
        let t11 = self.rR * self.mR;
        let t15 = self.zB * self.mB;
        let t20 = self.zH * self.mH;
        let M_11 = t7 + self.IBxx + self.rR * t11 + self.zB * t15 + self.IRxx
            + self.zH * t20;
        let (wx_delta2_delta, wx_delta2_delta_lam) = self.lam.sin_cos();
        let t32 = self.w.like(1.0) / self.w;
        let t33 = self.c * t32;
        let mu = wx_delta2_delta_lam * t33;
        let wz_delta2_delta = wx_delta2_delta_lam + mu;
        let t39 = self.IHxz * wz_delta2_delta + t7 * wx_delta2_delta;
        let t42 = self.mB * self.xB;
        let t44 = self.IBxz - self.zB * t42;
        let t51 = self.c + self.w - self.xH - t33 * self.xH;
        let K0_12_mH = self.zH * wx_delta2_delta + wx_delta2_delta_lam * t51;
        let t54 = self.mH * K0_12_mH;
        let M_12 = t39 + mu * t44 + self.zH * t54;
        let K1_22_ay_delta2_delta = t32 * wx_delta2_delta;
        let t59 = self.c * K1_22_ay_delta2_delta;
        let t61 = self.IHxz * (wx_delta2_delta + t59);
        let t63 = self.IFxx + self.IHzz;
        let t66 = wz_delta2_delta * t63 + self.IHxz * wx_delta2_delta;
        let t70 = self.IRxx + self.xB * t42 + self.IBzz;
        let t72 = t66 + mu * t70;
        let t74 = t66 + t33 * t72;
        let M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
        let M_22 = wx_delta2_delta_lam * (t61 + t74) + K0_12_mH * t54 + t7 * M_22_IHxx;
        let zero = self.w.like(0.0);
        let t85 = self.hH + self.hB;
        let t87 = self.hH + t33 * t85;
        let C0_12 = wx_delta2_delta_lam * t87;
        let t90 = self.w.like(1.0) / self.rF;
        let SF = self.IFyy * t90;
        let t92 = wx_delta2_delta_lam * SF;
        let yaw_per_v_delta = wx_delta2_delta_lam * t32;
        let t95 = self.w.like(1.0) / self.rR;
        let SR = self.IRyy * t95;
        let t97 = SF + SR;
        let K0_11 = t15 + t20 - t4 - t11;
        let vy_all1_delta = t97 - K0_11;
        let t105 = self.IHxz + t44 - t20 * self.xH;
        let t106 = self.c * vy_all1_delta + t105;
        let M_22_wz_delta2_delta = yaw_per_v_delta * t106;
        let t108 = t4 * wx_delta2_delta_lam;
        let C1_12 = t92 + M_22_wz_delta2_delta + t108;
        let t111 = mu * t97;
        let t113 = mu * self.xB;
        let t114 = self.mB * t113;
        let t115 = t54 - t114;
        let t119 = t32 * (t72 - self.xH * t54);
        let t122 = wz_delta2_delta * wx_delta2_delta;
        let C1_22 = t4 * t122 - wx_delta2_delta_lam * (t33 * t115 - t119);
        let t125 = t4 * wx_delta2_delta;
        let K0_12 = t115 - t125;
        let K0_22 = wx_delta2_delta * K0_12;
        let K1_12 = t85 * yaw_per_v_delta;
        let K2_22_SF = wx_delta2_delta_lam * K1_22_ay_delta2_delta;
        let K1_22 = self.hH * K2_22_SF;
        let K2_12 = yaw_per_v_delta * vy_all1_delta;
        let t132 = wx_delta2_delta * SF;
        let ay_delta2_delta = t125 + t132;
        let t134 = ay_delta2_delta - t115;
        let t135 = t32 * t134;
        let K2_22 = wx_delta2_delta_lam * t135;
        let t137 = self.zH * wx_delta2_delta_lam;
        let t138 = self.mH * t137;
        let t139 = yaw_per_v_delta * t105;
        let M_12_w = t138 - t33 * t139;
        let t142 = t72 * yaw_per_v_delta;
        let t143 = t33 * t142;
        let t144 = self.xH * yaw_per_v_delta;
        let t146 = wx_delta2_delta_lam + t33 * t144;
        let t147 = self.mH * t146;
        let t148 = K0_12_mH + K0_12_mH;
        let M_22_w = t147 * t148 - t143 - t143;
        let C0_21_w = t33 * K1_12;
        let t153 = t32 * M_22_wz_delta2_delta;
        let C1_21_w = t32 * t111;
        let t155 = mu + t144;
        let t156 = self.mH * t155;
        let t159 = t63 * yaw_per_v_delta;
        let t162 = t114 + t70 * yaw_per_v_delta + t159 - K0_12;
        let t164 = t119 + t33 * t162;
        let t166 = t146 * t156 + yaw_per_v_delta * t164;
        let K0_12_w = t147 + t32 * t114;
        let K0_22_w = wx_delta2_delta * K0_12_w;
        let t170 = t32 * K1_12;
        let t171 = t32 * K1_22;
        let t172 = t32 * K2_12;
        let t174 = yaw_per_v_delta * (t135 + K0_12_w);
        let M_12_c = t138 + t139;
        let t176 = wx_delta2_delta_lam - t144;
        let t177 = self.mH * t176;
        let C1_12_mu = t142 + K0_12_mH * t177;
        let M_22_c = C1_12_mu + C1_12_mu;
        let t181 = yaw_per_v_delta * t97;
        let C1_22_c = yaw_per_v_delta * t162 - t156 * t176;
        let t185 = t42 * yaw_per_v_delta;
        let K0_12_c = t177 - t185;
        let K0_22_c = wx_delta2_delta * K0_12_c;
        let t188 = yaw_per_v_delta * K0_12_c;
        let t192 = t137 - wx_delta2_delta * t51;
        let t193 = self.mH * t192;
        let M_12_lam = t7 * wx_delta2_delta_lam + self.zH * t193 - t61 - t44 * t59;
        let t202 = K0_12_mH * t193 + wx_delta2_delta_lam * t39 - wx_delta2_delta * t74;
        let M_22_lam = t202 + t202;
        let C0_21_lam = wx_delta2_delta * t87;
        let t206 = ay_delta2_delta + K1_22_ay_delta2_delta * t106;
        let C1_21_lam = t132 + t59 * t97;
        let t213 = wx_delta2_delta_lam * yaw_per_v_delta;
        let C1_22_lam = wz_delta2_delta * t108 + self.IHxz * t213
            - wx_delta2_delta * (t125 + t159 + t164) - t156 * t192;
        let K0_12_lam = t193 + t42 * t59 - t108;
        let K0_22_lam = wx_delta2_delta * K0_12_lam + wx_delta2_delta_lam * K0_12;
        let t225 = K1_22_ay_delta2_delta * t85;
        let t228 = self.hH * (wx_delta2_delta * K1_22_ay_delta2_delta - t213);
        let t229 = K1_22_ay_delta2_delta * vy_all1_delta;
        let K2_22_lam = yaw_per_v_delta * (t92 - K0_12_lam)
            - K1_22_ay_delta2_delta * t134;
        let M_11_rR = t11 + t11;
        let t235 = t95 * SR;
        let K2_12_rR = yaw_per_v_delta * (self.mR - t235);
        let C1_12_rR = self.c * K2_12_rR;
        let C1_21_rR = mu * t235;
        let M_11_mR = self.rR * self.rR;
        let K2_12_mR = self.rR * yaw_per_v_delta;
        let C1_12_mR = self.c * K2_12_mR;
        let M_22_IRxx = mu * mu;
        let C1_22_IRxx = t33 * t213;
        let K2_12_IRyy = yaw_per_v_delta * t95;
        let C1_12_IRyy = self.c * K2_12_IRyy;
        let t248 = t15 * mu;
        let M_22_xB = t114 * (mu + mu);
        let t251 = self.zB * yaw_per_v_delta;
        let t252 = self.mB * t251;
        let t253 = self.mB * yaw_per_v_delta;
        let t254 = self.c * t253;
        let t255 = t185 + t254;
        let C1_22_xB = mu * (t185 + t255);
        let t258 = wx_delta2_delta * t254;
        let K2_22_xB = yaw_per_v_delta * t254;
        let M_11_zB = t15 + t15;
        let M_11_mB = self.zB * self.zB;
        let t262 = self.zB * t113;
        let M_22_mB = t113 * t113;
        let t265 = mu + self.xB * yaw_per_v_delta;
        let t266 = self.zB * t265;
        let C1_22_mB = t113 * t265;
        let t268 = wx_delta2_delta * t113;
        let K2_22_mB = self.xB * C1_22_IRxx;
        let t270 = t20 * wz_delta2_delta;
        let t271 = self.mH * wz_delta2_delta;
        let t272 = t148 * t271;
        let t273 = t20 * yaw_per_v_delta;
        let t275 = K0_12_mH * yaw_per_v_delta;
        let C1_22_xH = self.mH * (wz_delta2_delta * t155 - t275);
        let t278 = self.mH * t122;
        let K2_22_xH = yaw_per_v_delta * t271;
        let M_11_zH = t20 + t20;
        let K0_12_zH = self.mH * wx_delta2_delta;
        let M_12_zH = t54 + self.zH * K0_12_zH;
        let M_22_zH = wx_delta2_delta * (t54 + t54);
        let t286 = wx_delta2_delta * t156;
        let K0_22_zH = self.mH * M_22_IHxx;
        let t288 = self.mH * yaw_per_v_delta;
        let t289 = self.mH * K2_22_SF;
        let M_11_mH = self.zH * self.zH;
        let M_12_mH = self.zH * K0_12_mH;
        let M_22_mH = K0_12_mH * K0_12_mH;
        let t293 = self.zH * t155;
        let t294 = K0_12_mH * t155;
        let K0_22_mH = wx_delta2_delta * K0_12_mH;
        let t296 = self.zH * yaw_per_v_delta;
        let M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
        let C1_22_IHzz = t213 + C1_22_IRxx;
        let M_22_IHxz = t122 + t122;
        let M_11_rF = t4 + t4;
        let M_12_rF = t125 + t125;
        let M_22_rF = M_22_IHxx * M_11_rF;
        let t304 = self.mF - t90 * SF;
        let C1_12_rF = wz_delta2_delta * t304;
        let C1_12_IFyy = wz_delta2_delta * t90;
        let C1_21_rF = SF * C1_12_IFyy;
        let t308 = self.mF * wx_delta2_delta;
        let C1_22_rF = wz_delta2_delta * t308;
        let t310 = wx_delta2_delta * t308;
        let K2_12_rF = yaw_per_v_delta * t304;
        let K2_22_rF = K2_22_SF * t304;
        let M_11_mF = self.rF * self.rF;
        let t314 = self.rF * wx_delta2_delta;
        let M_12_mF = self.rF * t314;
        let t316 = self.rF * M_22_IHxx;
        let M_22_mF = self.rF * t316;
        let C1_12_mF = self.rF * wz_delta2_delta;
        let C1_22_mF = wx_delta2_delta * C1_12_mF;
        let K2_12_mF = self.rF * yaw_per_v_delta;
        let K2_22_mF = yaw_per_v_delta * t314;
        let M_22_IFxx = M_22_IHxx + M_22_IHzz;
        let K2_12_IFyy = t90 * yaw_per_v_delta;
        let K2_22_IFyy = t90 * K2_22_SF;
        let C0_21 = -C0_12;
        let C1_21 = -(t92 + t111);
        (
            FlywheelBicycleMatrices::from_entries([
                M_11, M_12, M_12, M_22, zero, C0_12, C0_21, zero, zero, C1_12, C1_21, C1_22, K0_11,
                K0_12, K0_12, K0_22, zero, K1_12, zero, K1_22, zero, K2_12, zero, K2_22,
            ]),
            FlywheelBicycleDerivatives {
                values: [
                    M_12_w, M_22_w, C0_21_w, t153, C1_21_w, t166, K0_12_w, K0_22_w, t170, t171,
                    t172, t174, M_12_c, M_22_c, K1_12, K2_12, t181, C1_22_c, K0_12_c, K0_22_c, t188,
                    M_12_lam, M_22_lam, C0_21_lam, t206, C1_21_lam, C1_22_lam, K0_12_lam, K0_22_lam,
                    t225, t228, t229, K2_22_lam, M_11_rR, C1_12_rR, C1_21_rR, self.mR, K2_12_rR,
                    M_11_mR, C1_12_mR, self.rR, K2_12_mR, self.w.like(1.0), M_22_IRxx, C1_22_IRxx,
                    C1_12_IRyy, K2_12_IRyy, t248, M_22_xB, t252, C1_22_xB, t254, t258, K2_22_xB,
                    M_11_zB, t114, t255, self.mB, t253, M_11_mB, t262, M_22_mB, t266, C1_22_mB,
                    self.zB, t113, t268, t251, K2_22_mB, mu, yaw_per_v_delta, t270, t272, t273,
                    C1_22_xH, t271, t278, K2_22_xH, M_11_zH, M_12_zH, M_22_zH, t156, t286, self.mH,
                    K0_12_zH, K0_22_zH, t288, t289, M_11_mH, M_12_mH, M_22_mH, t293, t294, self.zH,
                    K0_12_mH, K0_22_mH, t296, t275, wx_delta2_delta, M_22_IHxx, M_22_IHzz,
                    C1_22_IHzz, wz_delta2_delta, M_22_IHxz, K2_22_SF, M_11_rF, M_12_rF, M_22_rF,
                    C1_12_rF, C1_21_rF, C1_22_rF, self.mF, t308, t310, K2_12_rF, K2_22_rF, M_11_mF,
                    M_12_mF, M_22_mF, C1_12_mF, C1_22_mF, self.rF, t314, t316, K2_12_mF, K2_22_mF,
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
        Partial::new(MatrixName::C1, 1, 1, 1, 17), Partial::new(MatrixName::K0, 0, 1, 1, 18),
        Partial::new(MatrixName::K0, 1, 0, 1, 18), Partial::new(MatrixName::K0, 1, 1, 1, 19),
        Partial::new(MatrixName::K2, 1, 1, 1, 20).negative(),
        Partial::new(MatrixName::M, 0, 1, 2, 21),
        Partial::new(MatrixName::M, 1, 0, 2, 21),
        Partial::new(MatrixName::M, 1, 1, 2, 22),
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
