// @generated from generated/models/flywheel_bicycle.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 79e8bfc3e5c2959e

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    FormulaInfo, LengthError, MatrixName, Model, ModelInfo, Number, ParameterError,
    ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo, WithDerivatives,
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
    /// 47 additions, 51 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 105 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> FlywheelBicycleMatrices<T> {
        let t2 = self.zB * self.mB;
        let t7 = self.zH * self.mH;
        let t13 = self.rF * self.mF;
        let Jxx_delta = self.IFxx + self.zH * t7 + (self.IHxx + self.rF * t13);
        let t19 = self.rR * self.mR;
        let M_11 = self.zB * t2
            + (Jxx_delta + (self.rR * t19 + (self.IRxx + self.IBxx)));
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t31 = self.w.like(1.0) / self.w;
        let yaw_per_v_delta = cos_lam * t31;
        let mu = self.c * yaw_per_v_delta;
        let t36 = self.c + self.w;
        let t37 = self.xH - t36;
        let t41 = self.IHxz - t7 * t37 - t13 * self.c;
        let Sz_delta = t7 - t13;
        let t47 = self.mB * self.xB;
        let mA = self.zB * t47;
        let t50 = t41 + (self.IBxz - t36 * Sz_delta - mA);
        let t55 = Jxx_delta * sin_lam + t41 * cos_lam;
        let M_12 = mu * t50 + t55;
        let t59 = self.mH * t37;
        let t62 = self.mF * self.c;
        let Jzz_delta = self.IFxx + (self.IHzz + t37 * t59 + self.c * t62);
        let t67 = sin_lam * t41 + cos_lam * Jzz_delta;
        let t70 = t59 - t62;
        let t72 = sin_lam * Sz_delta - cos_lam * t70;
        let t74 = t36 * t72 - t67;
        let t79 = self.mH * self.xH + self.mF * self.w;
        let hx_delta = self.IRxx + Jzz_delta + (self.xB * t47 + t36 * (t70 + t79));
        let t87 = mu * (hx_delta + self.IBzz) - t74;
        let zero = self.w.like(0.0);
        let t95 = self.hH + self.hB;
        let t97 = cos_lam * self.hH;
        let C0_12 = mu * t95 + t97;
        let K0_11 = Sz_delta - (t19 - t2);
        let SF = self.IFyy / self.rF;
        let ST = SF + self.IRyy / self.rR;
        let t111 = mu * ST + cos_lam * SF;
        let C1_12 = (t50 - self.c * K0_11) * yaw_per_v_delta + t111;
        let Sx_all = t47 + t79;
        let K0_12 = t72 - mu * Sx_all;
        let C1_22 = yaw_per_v_delta * t87 - mu * K0_12;
        let K0_22 = sin_lam * K0_12;
        let K1_12 = yaw_per_v_delta * t95;
        let K1_22 = t31 * (sin_lam * t97);
        let K2_12 = yaw_per_v_delta * (ST - K0_11);
        let K2_22 = yaw_per_v_delta * (sin_lam * SF - K0_12);
        let M_22 = cos_lam * t67 - (mu * (t74 - t87) - sin_lam * t55);
        let C0_21 = -C0_12;
        let C1_21 = -t111;
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
    /// 145 additions, 215 multiplications, 6 divisions, 5 negations and 2 trigonometric functions: 373 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (FlywheelBicycleMatrices<T>, FlywheelBicycleDerivatives<T>) {
        let t3 = self.rF * self.mF;
        let Jzz_all_mB = self.rF * t3;
        let Jxz_delta_w = self.zH * self.mH;
        let Jxx_delta = Jzz_all_mB + self.IFxx + self.IHxx + self.zH * Jxz_delta_w;
        let M_11_mB = self.zB * self.zB;
        let M_11_mR = self.rR * self.rR;
        let M_11 = self.IRxx + Jxx_delta + self.IBxx + self.mB * M_11_mB
            + self.mR * M_11_mR;
        let (hx_delta_Jxx_delta, hx_delta_Jxz_delta) = self.lam.sin_cos();
        let t31 = self.mF * self.c;
        let Sx_all_mA = self.c + self.w;
        let Sx_delta_mH = self.xH - Sx_all_mA;
        let t40 = self.rF * t31 + Jxz_delta_w * Sx_delta_mH - self.IHxz;
        let t42 = t40 * hx_delta_Jxz_delta;
        let hx_delta = Jxx_delta * hx_delta_Jxx_delta - t42;
        let t44 = self.w.like(1.0) / self.w;
        let yaw_per_v_delta = hx_delta_Jxz_delta * t44;
        let mu = self.c * yaw_per_v_delta;
        let t48 = self.mB * self.xB;
        let t50 = t3 - Jxz_delta_w;
        let t55 = t40 + self.zB * t48 - Sx_all_mA * t50 - self.IBxz;
        let M_12 = hx_delta - mu * t55;
        let t59 = hx_delta_Jxx_delta * t40;
        let t62 = self.mH * Sx_delta_mH;
        let Jzz_delta = self.IFxx + self.IHzz + self.c * t31 + Sx_delta_mH * t62;
        let t68 = t59 - hx_delta_Jxz_delta * Jzz_delta;
        let t70 = hx_delta_Jxx_delta * t50;
        let Sx_delta = t62 - t31;
        let py_delta = t70 + hx_delta_Jxz_delta * Sx_delta;
        let t75 = t68 - Sx_all_mA * py_delta;
        let mA = self.mF + self.mH;
        let t80 = Sx_all_mA * mA;
        let t81 = self.w.like(0.5) * t80;
        let t82 = Sx_delta + Sx_delta;
        let t84 = t81 + t81 + t82;
        let t89 = self.IRxx + Jzz_delta + self.IBzz + self.xB * t48 + Sx_all_mA * t84;
        let t90 = mu * t89;
        let t91 = t75 - t90;
        let t92 = t75 + t91;
        let M_22 = hx_delta_Jxx_delta * hx_delta - hx_delta_Jxz_delta * t68 - mu * t92;
        let zero = self.w.like(0.0);
        let K1_12_yaw_per_v_delta = self.hH + self.hB;
        let t101 = hx_delta_Jxz_delta * self.hH;
        let C0_12 = mu * K1_12_yaw_per_v_delta + t101;
        let SF_IFyy = self.w.like(1.0) / self.rF;
        let SF = self.IFyy * SF_IFyy;
        let t106 = hx_delta_Jxz_delta * SF;
        let SR_IRyy = self.w.like(1.0) / self.rR;
        let ST = SF + self.IRyy * SR_IRyy;
        let t111 = self.mB * self.zB;
        let t112 = self.mR * self.rR;
        let t113 = t111 - t112;
        let K2_12_yaw_per_v_delta = ST + (t50 - t113);
        let t117 = self.c * K2_12_yaw_per_v_delta - t55;
        let C1_12 = t106 + yaw_per_v_delta * t117;
        let Sx_all = t48 + Sx_delta + t80;
        let t124 = mu * Sx_all;
        let P_delta_lateral = py_delta + t124;
        let K1_12 = yaw_per_v_delta * K1_12_yaw_per_v_delta;
        let t131 = hx_delta_Jxx_delta * t44;
        let C1_22_Jxz_delta = hx_delta_Jxz_delta * t131;
        let K1_22 = self.hH * C1_22_Jxz_delta;
        let K2_12 = yaw_per_v_delta * K2_12_yaw_per_v_delta;
        let t135 = hx_delta_Jxx_delta * SF;
        let K2_22_yaw_per_v_delta = P_delta_lateral + t135;
        let K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
        let M_12_Jxz_delta = hx_delta_Jxz_delta + mu;
        let t140 = self.mH * M_12_Jxz_delta;
        let t141 = self.zH * t140;
        let t143 = hx_delta_Jxz_delta / (self.w * self.w);
        let t144 = self.c * t143;
        let M_12_w = mu * t50 + t141 + t55 * t144;
        let t148 = Sx_delta_mH * M_12_Jxz_delta;
        let t149 = M_12_Jxz_delta * t148;
        let Jzz_all_Sx_delta = Sx_all_mA + Sx_all_mA;
        let t151 = mu * Jzz_all_Sx_delta;
        let M_22_Sx_delta = M_12_Jxz_delta * t151;
        let M_22_Jxz_delta = M_12_Jxz_delta * (hx_delta_Jxx_delta + hx_delta_Jxx_delta);
        let t157 = t149 + M_22_Sx_delta - self.zH * M_22_Jxz_delta;
        let M_22_xH = self.mH * (t149 + t157);
        let t160 = t92 - t90;
        let Jzz_all_w = t80 + t84;
        let t164 = py_delta + mu * Jzz_all_w;
        let t166 = mu * (py_delta + t164);
        let M_22_w = t144 * t160 + t166 - M_22_xH;
        let C0_21_w = K1_12_yaw_per_v_delta * t144;
        let C1_12_w = t3 * yaw_per_v_delta - t117 * t143;
        let C1_21_w = ST * t144;
        let t174 = mu * mA;
        let t176 = t164 + self.c * t174;
        let K2_22_Sx_delta = yaw_per_v_delta * M_12_Jxz_delta;
        let C1_22_Jzz_all = yaw_per_v_delta * mu;
        let M_22_Jzz_all = self.c * C1_22_Jzz_all;
        let t182 = Sx_all_mA * yaw_per_v_delta;
        let C1_22_py_delta = mu + t182;
        let K2_22_mA = Sx_all_mA * C1_22_Jzz_all;
        let t187 = M_22_Jzz_all + hx_delta_Jxz_delta * C1_22_py_delta + K2_22_mA;
        let M_22_mA = self.c * t182;
        let t189 = self.zH * hx_delta_Jxx_delta;
        let t190 = M_22_mA - t189;
        let t191 = t148 + t190;
        let K2_22_mH = yaw_per_v_delta * t191;
        let t193 = t187 + K2_22_mH;
        let C1_22_xH = t62 * K2_22_Sx_delta + self.mH * t193;
        let C1_22_mu = t124 + P_delta_lateral + yaw_per_v_delta * t89;
        let t200 = t91 - self.c * C1_22_mu;
        let C1_22_w = yaw_per_v_delta * t176 + t143 * t200 - C1_22_xH;
        let K0_12_w = t140 + Sx_all * t144 - t174;
        let K0_22_w = hx_delta_Jxx_delta * K0_12_w;
        let t208 = K1_12_yaw_per_v_delta * t143;
        let K1_22_yaw_per_v_delta = hx_delta_Jxx_delta * self.hH;
        let t210 = t143 * K1_22_yaw_per_v_delta;
        let t211 = K2_12_yaw_per_v_delta * t143;
        let t214 = yaw_per_v_delta * K0_12_w + K2_22_yaw_per_v_delta * t143;
        let t216 = hx_delta_Jxz_delta * t50;
        let t217 = yaw_per_v_delta * t55 + t216;
        let t220 = t70 + t82 * M_12_Jxz_delta;
        let M_22_c = t166 - yaw_per_v_delta * t160
            - M_12_Jxz_delta * (t70 + t220 + mA * t151);
        let t227 = yaw_per_v_delta * ST;
        let C1_22_Sx_delta = K2_22_mA + t187;
        let C1_22_c = yaw_per_v_delta * (t176 + C1_22_mu - t220) - mA * C1_22_Sx_delta;
        let K0_12_c = hx_delta_Jxz_delta * (mA - t44 * Sx_all);
        let K0_22_c = hx_delta_Jxx_delta * K0_12_c;
        let t238 = yaw_per_v_delta * K0_12_c;
        let t239 = self.c * t131;
        let hx_delta_lam = t59 + Jxx_delta * hx_delta_Jxz_delta;
        let M_12_lam = t55 * t239 + hx_delta_lam;
        let t245 = hx_delta_Jxx_delta * Sx_delta - t216;
        let t248 = M_22_mA * t245 - t91 * t239;
        let M_22_hz_delta = mu + M_12_Jxz_delta;
        let t251 = t42 + hx_delta_Jxx_delta * Jzz_delta;
        let M_22_lam = hx_delta_Jxz_delta * hx_delta
            + hx_delta_Jxx_delta * (t68 + hx_delta_lam) - t248 - t248
            - M_22_hz_delta * t251;
        let t260 = K1_12_yaw_per_v_delta * t131;
        let C0_21_lam = K1_22_yaw_per_v_delta + self.c * t260;
        let t264 = t135 + t117 * t131;
        let C1_21_lam = t135 + ST * t239;
        let C1_22_lam = t131 * t200 - yaw_per_v_delta * t251 - C1_22_py_delta * t245;
        let K0_12_lam = t245 + Sx_all * t239;
        let K0_22_lam = hx_delta_Jxx_delta * K0_12_lam
            - hx_delta_Jxz_delta * P_delta_lateral;
        let K1_22_lam = yaw_per_v_delta * t101 - t131 * K1_22_yaw_per_v_delta;
        let t280 = K2_12_yaw_per_v_delta * t131;
        let K2_22_lam = yaw_per_v_delta * (t106 - K0_12_lam)
            - t131 * K2_22_yaw_per_v_delta;
        let M_11_rR = t112 + t112;
        let t286 = self.IRyy / M_11_mR;
        let K2_12_rR = yaw_per_v_delta * (self.mR - t286);
        let C1_12_rR = self.c * K2_12_rR;
        let C1_21_rR = mu * t286;
        let K2_12_mR = self.rR * yaw_per_v_delta;
        let C1_12_mR = self.c * K2_12_mR;
        let C1_12_IRyy = mu * SR_IRyy;
        let K2_12_IRyy = yaw_per_v_delta * SR_IRyy;
        let t296 = yaw_per_v_delta * t111;
        let t297 = self.c * t296;
        let t298 = self.mB * yaw_per_v_delta;
        let t299 = self.c * t298;
        let t300 = yaw_per_v_delta * self.xB;
        let t301 = self.c * t300;
        let t302 = t299 * t301;
        let M_22_xB = t302 + t302;
        let t304 = mu + t300;
        let Jzz_delta_mF = t300 + t304;
        let C1_22_xB = t299 * Jzz_delta_mF;
        let t307 = hx_delta_Jxx_delta * t299;
        let K2_22_xB = yaw_per_v_delta * t299;
        let M_11_zB = t111 + t111;
        let t310 = self.mB * t301;
        let t311 = self.mB * t304;
        let t312 = self.zB * t301;
        let M_22_mB = t301 * t301;
        let t314 = self.zB * t304;
        let K2_22_mB = yaw_per_v_delta * t301;
        let C1_22_mB = self.xB * (M_22_Jzz_all + K2_22_mB);
        let t318 = hx_delta_Jxx_delta * t301;
        let t319 = self.zB * yaw_per_v_delta;
        let t320 = self.mH * yaw_per_v_delta;
        let t321 = self.zH * t320;
        let K0_12_zH = self.mH * hx_delta_Jxx_delta;
        let t323 = M_12_Jxz_delta * K0_12_zH;
        let K2_22_xH = yaw_per_v_delta * t140;
        let Jxx_delta_zH = Jxz_delta_w + Jxz_delta_w;
        let M_12_zH = self.mH * (t189 - t191);
        let t328 = hx_delta_Jxx_delta * t191;
        let t330 = self.mH * (t328 + t328);
        let t331 = self.c + self.xH;
        let t332 = t320 * t331;
        let t333 = hx_delta_Jxx_delta * t332;
        let K0_22_zH = hx_delta_Jxx_delta * K0_12_zH;
        let t335 = self.mH * C1_22_Jxz_delta;
        let Jxx_delta_mH = self.zH * self.zH;
        let t337 = self.zH * t191;
        let t338 = M_22_mA * M_22_mA;
        let M_22_mH = t338 + Sx_delta_mH * t157 - t189 * (M_22_mA + t190);
        let t344 = self.zH * yaw_per_v_delta;
        let t345 = t331 * t344;
        let C1_22_mH = C1_22_py_delta * t190 + Sx_delta_mH * t193;
        let M_delta_delta_Jxx_delta = hx_delta_Jxx_delta * hx_delta_Jxx_delta;
        let M_22_Jzz_delta = M_12_Jxz_delta * M_12_Jxz_delta;
        let Jxx_delta_rF = t3 + t3;
        let py_delta_mF = self.rF * hx_delta_Jxx_delta;
        let t353 = self.c * M_12_Jxz_delta;
        let t354 = M_22_mA + py_delta_mF;
        let K0_12_mF = t353 - t354;
        let M_12_rF = self.mF * (py_delta_mF - K0_12_mF);
        let M_22_rF = M_delta_delta_Jxx_delta * Jxx_delta_rF
            - t31 * (M_22_Jxz_delta - C1_22_Jxz_delta * Jzz_all_Sx_delta);
        let t363 = self.mF * t182;
        let Jxx_delta_mF = self.rF * self.rF;
        let t365 = self.IFyy / Jxx_delta_mF;
        let C1_21_rF = M_12_Jxz_delta * t365;
        let C1_12_rF = t363 - C1_21_rF;
        let C1_22_rF = hx_delta_Jxx_delta * t363;
        let py_delta_rF = self.mF * hx_delta_Jxx_delta;
        let t370 = self.mF * M_delta_delta_Jxx_delta;
        let K2_12_rF = yaw_per_v_delta * (self.mF - t365);
        let K2_22_rF = hx_delta_Jxx_delta * K2_12_rF;
        let t374 = self.rF * K0_12_mF;
        let M_22_mF = t338 + self.c * (self.c * M_22_Jzz_delta - M_22_Sx_delta)
            - py_delta_mF * (t353 + K0_12_mF - M_22_mA);
        let C1_12_mF = self.rF * t182;
        let t385 = yaw_per_v_delta * K0_12_mF;
        let C1_22_mF = C1_22_py_delta * t354 - self.c * (t187 - t385);
        let K0_22_mF = hx_delta_Jxx_delta * K0_12_mF;
        let K2_12_mF = self.rF * yaw_per_v_delta;
        let M_22_IFxx = M_delta_delta_Jxx_delta + M_22_Jzz_delta;
        let C1_12_IFyy = SF_IFyy * M_12_Jxz_delta;
        let K2_12_IFyy = yaw_per_v_delta * SF_IFyy;
        let K2_22_IFyy = SF_IFyy * C1_22_Jxz_delta;
        let C0_21 = -C0_12;
        let C1_21 = -(t106 + mu * ST);
        let C1_22 = -(yaw_per_v_delta * (t91 - self.c * P_delta_lateral));
        let K0_11 = t113 - t50;
        let K0_12 = -P_delta_lateral;
        let K0_22 = -(hx_delta_Jxx_delta * P_delta_lateral);
        (
            FlywheelBicycleMatrices::from_entries([
                M_11, M_12, M_12, M_22, zero, C0_12, C0_21, zero, zero, C1_12, C1_21, C1_22, K0_11,
                K0_12, K0_12, K0_22, zero, K1_12, zero, K1_22, zero, K2_12, zero, K2_22,
            ]),
            FlywheelBicycleDerivatives {
                values: [
                    M_12_w, M_22_w, C0_21_w, C1_12_w, C1_21_w, C1_22_w, K0_12_w, K0_22_w, t208,
                    t210, t211, t214, t217, M_22_c, K1_12, K2_12, t227, C1_22_c, K0_12_c, K0_22_c,
                    t238, M_12_lam, M_22_lam, C0_21_lam, t264, C1_21_lam, C1_22_lam, K0_12_lam,
                    K0_22_lam, t260, K1_22_lam, t280, K2_22_lam, M_11_rR, C1_12_rR, C1_21_rR,
                    self.mR, K2_12_rR, M_11_mR, C1_12_mR, self.rR, K2_12_mR, self.w.like(1.0),
                    M_22_Jzz_all, C1_22_Jzz_all, C1_12_IRyy, K2_12_IRyy, t297, M_22_xB, t296,
                    C1_22_xB, t299, t307, K2_22_xB, M_11_zB, t310, t311, self.mB, t298, M_11_mB,
                    t312, M_22_mB, t314, C1_22_mB, self.zB, t301, t318, t319, K2_22_mB, mu,
                    yaw_per_v_delta, t141, M_22_xH, t321, C1_22_xH, t140, t323, K2_22_xH,
                    Jxx_delta_zH, M_12_zH, t330, t332, t333, self.mH, K0_12_zH, K0_22_zH, t320,
                    t335, Jxx_delta_mH, t337, M_22_mH, t345, C1_22_mH, self.zH, t191, t328, t344,
                    K2_22_mH, hx_delta_Jxx_delta, M_delta_delta_Jxx_delta, M_22_Jzz_delta,
                    K2_22_Sx_delta, M_12_Jxz_delta, M_22_Jxz_delta, C1_22_Jxz_delta, Jxx_delta_rF,
                    M_12_rF, M_22_rF, C1_12_rF, C1_21_rF, C1_22_rF, self.mF, py_delta_rF, t370,
                    K2_12_rF, K2_22_rF, Jxx_delta_mF, t374, M_22_mF, C1_12_mF, C1_22_mF, self.rF,
                    K0_12_mF, K0_22_mF, K2_12_mF, t385, M_22_IFxx, C1_12_IFyy, K2_12_IFyy,
                    K2_22_IFyy,
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
        let matrices = self.matrices();
        [
            matrices.m[0][0], matrices.m[0][1], matrices.m[1][1], matrices.c0[0][1],
            matrices.c0[1][0], matrices.c1[0][1], matrices.c1[1][0], matrices.c1[1][1],
            matrices.k0[0][0], matrices.k0[0][1], matrices.k0[1][1], matrices.k1[0][1],
            matrices.k1[1][1], matrices.k2[0][1], matrices.k2[1][1],
        ]
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

impl FlywheelBicycleDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 175] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 0), Partial::new(MatrixName::M, 1, 0, 0, 0),
        Partial::new(MatrixName::M, 1, 1, 0, 1),
        Partial::new(MatrixName::C0, 0, 1, 0, 2).negative(),
        Partial::new(MatrixName::C0, 1, 0, 0, 2), Partial::new(MatrixName::C1, 0, 1, 0, 3),
        Partial::new(MatrixName::C1, 1, 0, 0, 4), Partial::new(MatrixName::C1, 1, 1, 0, 5),
        Partial::new(MatrixName::K0, 0, 1, 0, 6), Partial::new(MatrixName::K0, 1, 0, 0, 6),
        Partial::new(MatrixName::K0, 1, 1, 0, 7),
        Partial::new(MatrixName::K1, 0, 1, 0, 8).negative(),
        Partial::new(MatrixName::K1, 1, 1, 0, 9).negative(),
        Partial::new(MatrixName::K2, 0, 1, 0, 10).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 11).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 12).negative(),
        Partial::new(MatrixName::M, 1, 0, 1, 12).negative(),
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
        Partial::new(MatrixName::K1, 1, 1, 2, 30),
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
        Partial::new(MatrixName::M, 1, 1, 15, 72),
        Partial::new(MatrixName::C1, 0, 1, 15, 73).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 74),
        Partial::new(MatrixName::K0, 0, 1, 15, 75).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 75).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 76).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 77), Partial::new(MatrixName::M, 0, 0, 16, 78),
        Partial::new(MatrixName::M, 0, 1, 16, 79), Partial::new(MatrixName::M, 1, 0, 16, 79),
        Partial::new(MatrixName::M, 1, 1, 16, 80).negative(),
        Partial::new(MatrixName::C1, 0, 1, 16, 81).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 82).negative(),
        Partial::new(MatrixName::K0, 0, 0, 16, 83), Partial::new(MatrixName::K0, 0, 1, 16, 84),
        Partial::new(MatrixName::K0, 1, 0, 16, 84), Partial::new(MatrixName::K0, 1, 1, 16, 85),
        Partial::new(MatrixName::K2, 0, 1, 16, 86).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 87).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 88),
        Partial::new(MatrixName::M, 0, 1, 17, 89).negative(),
        Partial::new(MatrixName::M, 1, 0, 17, 89).negative(),
        Partial::new(MatrixName::M, 1, 1, 17, 90),
        Partial::new(MatrixName::C1, 0, 1, 17, 91).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 92),
        Partial::new(MatrixName::K0, 0, 0, 17, 93),
        Partial::new(MatrixName::K0, 0, 1, 17, 94).negative(),
        Partial::new(MatrixName::K0, 1, 0, 17, 94).negative(),
        Partial::new(MatrixName::K0, 1, 1, 17, 95).negative(),
        Partial::new(MatrixName::K2, 0, 1, 17, 96).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 97), Partial::new(MatrixName::M, 0, 0, 18, 42),
        Partial::new(MatrixName::M, 0, 1, 18, 98), Partial::new(MatrixName::M, 1, 0, 18, 98),
        Partial::new(MatrixName::M, 1, 1, 18, 99), Partial::new(MatrixName::M, 1, 1, 20, 100),
        Partial::new(MatrixName::C1, 1, 1, 20, 101), Partial::new(MatrixName::M, 0, 1, 21, 102),
        Partial::new(MatrixName::M, 1, 0, 21, 102), Partial::new(MatrixName::M, 1, 1, 21, 103),
        Partial::new(MatrixName::C1, 0, 1, 21, 70), Partial::new(MatrixName::C1, 1, 1, 21, 104),
        Partial::new(MatrixName::M, 0, 0, 22, 105), Partial::new(MatrixName::M, 0, 1, 22, 106),
        Partial::new(MatrixName::M, 1, 0, 22, 106), Partial::new(MatrixName::M, 1, 1, 22, 107),
        Partial::new(MatrixName::C1, 0, 1, 22, 108), Partial::new(MatrixName::C1, 1, 0, 22, 109),
        Partial::new(MatrixName::C1, 1, 1, 22, 110),
        Partial::new(MatrixName::K0, 0, 0, 22, 111).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 112).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 112).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 113).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 114),
        Partial::new(MatrixName::K2, 1, 1, 22, 115),
        Partial::new(MatrixName::M, 0, 0, 23, 116),
        Partial::new(MatrixName::M, 0, 1, 23, 117).negative(),
        Partial::new(MatrixName::M, 1, 0, 23, 117).negative(),
        Partial::new(MatrixName::M, 1, 1, 23, 118),
        Partial::new(MatrixName::C1, 0, 1, 23, 119),
        Partial::new(MatrixName::C1, 1, 1, 23, 120),
        Partial::new(MatrixName::K0, 0, 0, 23, 121).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 122), Partial::new(MatrixName::K0, 1, 0, 23, 122),
        Partial::new(MatrixName::K0, 1, 1, 23, 123), Partial::new(MatrixName::K2, 0, 1, 23, 124),
        Partial::new(MatrixName::K2, 1, 1, 23, 125).negative(),
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
