// @generated from generated/models/whipple_mechanism.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: d2f6051b9c7ec604

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    MotionFormulas, Nonlinear, Number, ParameterError, ParameterInfo, Partial, Rate,
    Rows, Scalar, SetInfo, WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// The Whipple-Carvallo bicycle, derived from its bodies, joints and wheels.
///
/// Four rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally
/// symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,
/// x forward, y to the right, z down, so that a centre of mass above the ground has z < 0.
///
/// The declaration asserts that the matrices are those of Appendix A of the paper, which is proved when it is compiled.
/// [`Whipple`](crate::Whipple) computes them from these formulas.
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
/// C1_12 = mu*(ST - Sz_all) + SF*cos(lam) + yaw_per_v_delta*Jxz_all [kg*m]
/// C1_21 = -(mu*ST + SF*cos(lam)) [kg*m]
/// C1_22 = mu*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
/// K0_11 = Sz_all [kg*m]
/// K0_12 = K0_21 = K_phi_delta [kg*m]
/// K0_22 = K_delta_delta [kg*m]
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
pub struct WhippleMechanism<T = f64> {
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
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`WhippleMechanism`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleMechanismMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 2>,
}

impl<T: Number> WhippleMechanism<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 40 additions, 43 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 89 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleMechanismMatrices<T> {
        let t2 = self.zH * self.mH;
        let t9 = self.rR * self.mR;
        let t13 = self.rF * self.mF;
        let t18 = self.rF * t13 + (self.IHxx + self.IFxx);
        let t21 = self.zB * self.mB;
        let M_11 = self.zH * t2
            + (self.IRxx + self.IBxx + (self.rR * t9 + (t18 + self.zB * t21)));
        let (wx_delta2_delta, cos_lam) = self.lam.sin_cos();
        let yaw_per_v_delta = cos_lam / self.w;
        let mu = self.c * yaw_per_v_delta;
        let wz_delta2_delta = cos_lam + mu;
        let t38 = wz_delta2_delta * self.IHxz + t18 * wx_delta2_delta;
        let t42 = self.IBxz - t21 * self.xB;
        let t47 = self.zH * wx_delta2_delta + cos_lam * (self.c + self.w);
        let t51 = self.mH * (t47 - self.xH * wz_delta2_delta);
        let M_12 = t38 + (mu * t42 + self.zH * t51);
        let t57 = self.mB * self.xB;
        let t61 = mu * (self.IBzz + (self.IRxx + self.xB * t57));
        let t71 = wz_delta2_delta * (self.IFxx + self.IHzz) + wx_delta2_delta * self.IHxz
            - self.xH * t51;
        let M_22 = t47 * t51
            + (mu * t61 + wx_delta2_delta * t38 + wz_delta2_delta * t71);
        let zero = self.w.like(0.0);
        let SF = self.IFyy / self.rF;
        let t78 = t13 + SF;
        let SR = self.IRyy / self.rR;
        let t83 = t21 - (t9 - t2);
        let ST = SR - t83;
        let C1_12 = wz_delta2_delta * t78
            + yaw_per_v_delta * (t42 + self.c * ST + (self.IHxz - t2 * self.xH));
        let t95 = t13 * wx_delta2_delta;
        let K0_12 = t51 - mu * t57 - t95;
        let C1_22 = cos_lam * t95 - yaw_per_v_delta * (self.c * K0_12 - t61 - t71);
        let K0_22 = wx_delta2_delta * K0_12;
        let K2_12 = yaw_per_v_delta * (ST + t78);
        let K2_22 = yaw_per_v_delta * (wx_delta2_delta * SF - K0_12);
        let C1_21 = -(mu * SR + wz_delta2_delta * SF);
        let K0_11 = t83 - t13;
        WhippleMechanismMatrices::from_entries([
            M_11, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, K0_11, K0_12, K0_12, K0_22, zero,
            K2_12, zero, K2_22,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`WhippleMechanism`] that follow from its coordinates q = (`phi`, `delta`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleMechanismKinematics<T = f64> {
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

impl<T: Scalar> WhippleMechanism<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> WhippleMechanismKinematics<T> {
        let zero = self.w.like(0.0);
        let yaw_per_v_delta = self.lam.cos() / self.w;
        let mu = self.c * yaw_per_v_delta;
        let t12 = -(self.w.like(1.0) / self.rR);
        let t13 = -(self.w.like(1.0) / self.rF);
        WhippleMechanismKinematics {
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

// --- The nonlinear equations of motion -----------------------------------------------------------

/// The nonlinear equations of motion of [`WhippleMechanism`], with its parameters: what does not depend on the state is computed.
///
/// Positions: `x` (x of the contact point of the rear wheel) in `m`, `y` (y of the contact point of the rear wheel) in `m`, `psi` (yaw) in `rad`, `phi` (lean) in `rad`, `pitch` (pitch, by the heights of the wheels) in `rad`, `delta` (steer) in `rad`, `thetaR` (angle of the rear wheel) in `rad`, `thetaF` (angle of the front wheel) in `rad`.
/// Speeds: the rates of `phi`, `delta`, `thetaR`.
///
/// Each from one straight-line program:
/// - closure: 14 additions, 32 multiplications, 2 divisions, 1 square root and 6 trigonometric functions: 55 operations
/// - rates: 42 additions, 93 multiplications, 4 divisions, 3 negations, 1 square root and 8 trigonometric functions: 151 operations
/// - derivatives: 324 additions, 447 multiplications, 7 divisions, 3 negations, 1 square root and 8 trigonometric functions: 790 operations
/// - accelerations: 335 additions, 459 multiplications, 7 divisions, 2 negations, 1 square root and 8 trigonometric functions: 812 operations
/// - energy: 144 additions, 201 multiplications, 4 divisions, 1 negation, 1 square root and 6 trigonometric functions: 357 operations
/// - contact forces: 427 additions, 552 multiplications, 7 divisions, 1 negation, 1 square root and 8 trigonometric functions: 996 operations
/// - linearization: 1629 additions, 2130 multiplications, 7 divisions, 16 negations, 1 square root and 8 trigonometric functions: 3791 operations
/// - by parameters: 2546 additions, 3260 multiplications, 7 divisions, 1 square root and 8 trigonometric functions: 5822 operations
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleMechanismMotion<T = f64> {
    constants: [T; 51],
}

impl<T: Number> WhippleMechanism<T> {
    /// The nonlinear equations of motion, of what is computed once for these parameters:
    /// 54 additions, 64 multiplications and 2 trigonometric functions: 120 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn motion(&self) -> WhippleMechanismMotion<T> {
        let t2 = self.mB + self.mR;
        let t18 = self.mH + self.mF;
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t25 = self.w + self.c;
        let t28 = cos_lam * t25 - self.rR * sin_lam;
        let t31 = sin_lam * t25 + self.rR * cos_lam;
        let t32 = self.w - t25;
        let t35 = cos_lam * t32 + self.rF * sin_lam;
        let t38 = sin_lam * t32 - self.rF * cos_lam;
        let t39 = t31 + t38;
        let t41 = self.rR + self.zB;
        let t43 = self.xB * cos_lam - sin_lam * t41;
        let t44 = self.mB * t43;
        let t47 = self.xB * sin_lam + cos_lam * t41;
        let t48 = self.mB * t47;
        let t50 = self.IBxz * cos_lam;
        let t51 = self.IBxx * sin_lam + t50;
        let t53 = self.IBxz * sin_lam;
        let t55 = t53 + self.IBzz * cos_lam;
        let t59 = cos_lam * t51 - sin_lam * t55 - t44 * t47;
        let t61 = t47 * t48;
        let t62 = t43 * t44;
        let t64 = self.IByy + t61 + t62;
        let t74 = t61 + self.IRxx + cos_lam * (self.IBxx * cos_lam - t53)
            - sin_lam * (t50 - self.IBzz * sin_lam);
        let t79 = t62 + self.IRxx + sin_lam * t51 + cos_lam * t55;
        let t80 = self.xH - t25;
        let t83 = cos_lam * t80 - self.zH * sin_lam;
        let t84 = self.mH * t83;
        let t85 = self.mF * t35;
        let t86 = t84 + t85;
        let t89 = sin_lam * t80 + self.zH * cos_lam;
        let t90 = self.mH * t89;
        let t91 = self.mF * t38;
        let t92 = t90 + t91;
        let t95 = self.IHxz * sin_lam;
        let t98 = self.IHxz * cos_lam;
        let t104 = t89 * t90 + t38 * t91;
        let t107 = self.IFxx + cos_lam * (self.IHxx * cos_lam - t95) + t104
            - sin_lam * (t98 - self.IHzz * sin_lam);
        let t109 = t98 + self.IHxx * sin_lam;
        let t112 = t95 + self.IHzz * cos_lam;
        let t118 = cos_lam * t109 - sin_lam * t112 - t84 * t89 - t38 * t85;
        let t122 = t83 * t84 + t35 * t85;
        let t124 = t104 + self.IHyy + t122;
        let t129 = self.IFxx + t122 + sin_lam * t109 + cos_lam * t112;
        let t131 = t107 - t124;
        let t132 = t18 * t28;
        let t133 = t31 * t92;
        let t134 = t18 * t31;
        let t137 = t133 + t133 + t31 * t134;
        let t138 = t28 * t92;
        let t139 = t31 * t132;
        let t140 = t28 * t132;
        let t142 = t48 + t92 + t134;
        let t144 = self.rR * (t2 + t18);
        let t145 = self.rR * t144;
        WhippleMechanismMotion {
            constants: [
                self.mB, t2, self.mH, self.mF, self.xB, self.xH, self.w, self.rR, self.zB, self.zH,
                self.rF, self.IBxx, self.IHxx, self.IBxz, self.IHxz, self.IBzz, self.IHzz, t18,
                self.c, cos_lam, sin_lam, self.IRyy, self.IFyy, t28, t31, t35, t38, t39, t44, t48,
                t59, t64, t74, t79, t86, t92, t107, t118, t124, t129, self.g, t131, t132, t137,
                t138, t139, t140, t142, t144, t145, t145,
            ],
        }
    }
}

impl<T: Scalar> Nonlinear<2> for WhippleMechanism<T> {
    type Motion = WhippleMechanismMotion<T>;

    type MotionOver<U: Number> = WhippleMechanismMotion<U>;

    fn motion(&self) -> WhippleMechanismMotion<T> {
        WhippleMechanism::motion(self)
    }

    #[inline(always)]
    fn motion_over<U: Number>(model: &WhippleMechanism<U>) -> WhippleMechanismMotion<U> {
        WhippleMechanism::motion(model)
    }
}

impl<T: Scalar> carvallo::motion::Motion for WhippleMechanismMotion<T> {
    const INFO: &'static carvallo::motion::MotionInfo = &carvallo::motion::MotionInfo {
        model: "WhippleMechanism",
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
impl<T: Number> carvallo::motion::Unchecked for WhippleMechanismMotion<T> {
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
        let t14 = self.constants[19] * sin_pitch + self.constants[20] * cos_pitch;
        let t15 = cos_phi * t14;
        let t19 = sin_phi * sin_delta;
        let t20 = t19 - cos_delta * t15;
        let t24 = self.constants[19] * cos_pitch - sin_pitch * self.constants[20];
        let t25 = cos_phi * t24;
        let t28 = (t20 * t20 + t25 * t25).sqrt();
        let t36 = self.constants[23] + cos_delta * self.constants[25];
        let t42 = self.constants[10] * t28 + t19 * self.constants[25]
            + cos_phi * (t24 * self.constants[27] - t14 * t36)
            - self.constants[7] * cos_phi;
        let t46 = self.constants[0].like(1.0) / t28;
        let t47 = t25 * t46;
        let t58 = self.constants[10] * (cos_delta * sin_phi + t15 * sin_delta)
            * (cos_phi * sin_delta * t47
                + sin_phi * (t20 * t24 * t46 + cos_delta * t14 * t47));
        let t64 = t42 / (cos_phi * (t58 + t14 * self.constants[27] + t24 * t36));
        ([t42], [t64])
    }

    #[inline(always)]
    fn rates_unchecked(&self, positions: &[T; 8], speeds: &[T; 3]) -> [T; 8] {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t13 = self.constants[19] * sin_pitch + self.constants[20] * cos_pitch;
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t17 = t13 * cos_phi;
        let t21 = sin_phi * sin_delta - cos_delta * t17;
        let t25 = self.constants[19] * cos_pitch - sin_pitch * self.constants[20];
        let t26 = cos_phi * t25;
        let t29 = (t21 * t21 + t26 * t26).sqrt();
        let t30 = self.constants[0].like(1.0) / t29;
        let t31 = t21 * t30;
        let t33 = t26 * t30;
        let t34 = cos_delta * t33;
        let t36 = t25 * t34 - t13 * t31;
        let t41 = self.constants[10] * (sin_phi * cos_delta + t17 * sin_delta);
        let t44 = sin_delta * self.constants[25];
        let t50 = self.constants[23] + cos_delta * self.constants[25];
        let t52 = t25 * self.constants[27] - t13 * t50;
        let t55 = cos_phi * t44 - t36 * t41 - sin_phi * t52;
        let t56 = self.constants[7] * sin_phi + t55;
        let t63 = cos_phi * sin_delta * t33 + sin_phi * (t25 * t31 + t13 * t34);
        let t68 = t41 * t63 + t13 * self.constants[27] + t25 * t50;
        let t70 = self.constants[0].like(1.0) / (cos_phi * t68);
        let t71 = t56 * t70;
        let t77 = t25 * self.constants[24] - t13 * self.constants[23];
        let t79 = t55 + sin_phi * t77;
        let t81 = sin_phi * t25;
        let t85 = t68 - t13 * self.constants[24] - t25 * self.constants[23];
        let t88 = t70 * (t13 * t79 + t81 * t85);
        let t90 = speeds[0] * t71 + speeds[1] * t88;
        let t92 = self.constants[7] * (speeds[2] + t90);
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let t98 = sin_phi * t68;
        let t100 = sin_phi * t56;
        let t102 = t36 * t98 + t63 * t100;
        let t106 = self.constants[0].like(1.0) / (t36 * t68 + t56 * t63);
        let t108 = t71 * t102 * t106;
        let t117 = t29 * self.constants[10] + sin_phi * t44 + cos_phi * t52
            - cos_phi * t77;
        let t119 = t26 * t85 - t13 * t117;
        let t123 = t81 * t117 + t26 * t79;
        let t128 = t106 * (t36 * t119 + t63 * t123 + t88 * t102);
        let t131 = self.constants[7] * t63 * t106;
        let t137 = t63 * t98 - t36 * t100;
        let t141 = t63 * t68 - t36 * t56;
        let t144 = self.constants[0].like(1.0) / self.constants[10];
        let t161 = speeds[0] * (t108 * t141 - t71 * t137) * t144
            + speeds[1] * t144 * (t36 * t123 + t128 * t141 - t63 * t119 - t88 * t137);
        let t162 = t161 + speeds[2] * t144 * (self.constants[7] * t36 + t131 * t141);
        let t163 = -(t92 * cos_psi);
        let t164 = -(t92 * sin_psi);
        let t165 = -(speeds[0] * t108 + speeds[1] * t128 + speeds[2] * t131);
        [t163, t164, t165, speeds[0], t90, speeds[1], speeds[2], t162]
    }

    #[inline(always)]
    fn derivatives_unchecked(&self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2]) -> ([T; 8], [T; 3]) {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t13 = self.constants[19] * sin_pitch + self.constants[20] * cos_pitch;
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t17 = t13 * cos_phi;
        let t21 = sin_phi * sin_delta - cos_delta * t17;
        let t25 = self.constants[19] * cos_pitch - sin_pitch * self.constants[20];
        let t26 = cos_phi * t25;
        let t29 = (t21 * t21 + t26 * t26).sqrt();
        let t30 = self.constants[0].like(1.0) / t29;
        let t31 = t21 * t30;
        let t33 = t26 * t30;
        let t34 = cos_delta * t33;
        let t36 = t25 * t34 - t13 * t31;
        let t40 = sin_phi * cos_delta + t17 * sin_delta;
        let t41 = self.constants[10] * t40;
        let t44 = sin_delta * self.constants[25];
        let t50 = self.constants[23] + cos_delta * self.constants[25];
        let t52 = t25 * self.constants[27] - t13 * t50;
        let t55 = cos_phi * t44 - t36 * t41 - sin_phi * t52;
        let t56 = self.constants[7] * sin_phi + t55;
        let t63 = cos_phi * sin_delta * t33 + sin_phi * (t25 * t31 + t13 * t34);
        let t68 = t41 * t63 + t13 * self.constants[27] + t25 * t50;
        let t70 = self.constants[0].like(1.0) / (cos_phi * t68);
        let t71 = t56 * t70;
        let t77 = t25 * self.constants[24] - t13 * self.constants[23];
        let t79 = t55 + sin_phi * t77;
        let t81 = sin_phi * t25;
        let t85 = t68 - t13 * self.constants[24] - t25 * self.constants[23];
        let t88 = t70 * (t13 * t79 + t81 * t85);
        let t90 = speeds[0] * t71 + speeds[1] * t88;
        let t91 = speeds[2] + t90;
        let t92 = self.constants[7] * t91;
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let t98 = sin_phi * t68;
        let t100 = sin_phi * t56;
        let t102 = t36 * t98 + t63 * t100;
        let t106 = self.constants[0].like(1.0) / (t36 * t68 + t56 * t63);
        let t108 = t71 * t102 * t106;
        let t117 = t29 * self.constants[10] + sin_phi * t44 + cos_phi * t52
            - cos_phi * t77;
        let t119 = t26 * t85 - t13 * t117;
        let t123 = t81 * t117 + t26 * t79;
        let t128 = t106 * (t36 * t119 + t63 * t123 + t88 * t102);
        let t131 = self.constants[7] * t63 * t106;
        let t134 = speeds[0] * t108 + speeds[1] * t128 + speeds[2] * t131;
        let t137 = t63 * t98 - t36 * t100;
        let t141 = t63 * t68 - t36 * t56;
        let t144 = self.constants[0].like(1.0) / self.constants[10];
        let t145 = (t108 * t141 - t71 * t137) * t144;
        let t154 = t144 * (t36 * t123 + t128 * t141 - t63 * t119 - t88 * t137);
        let t159 = t144 * (self.constants[7] * t36 + t131 * t141);
        let t162 = speeds[0] * t145 + speeds[1] * t154 + speeds[2] * t159;
        let t165 = cos_phi * t134;
        let t167 = sin_phi * t134;
        let t168 = self.constants[7] * t167;
        let t170 = t165 * t168 - t92 * t165;
        let t173 = t170 + sin_phi * self.constants[40];
        let t178 = speeds[0] * t13 - t25 * t165;
        let t179 = t90 * t178;
        let t180 = speeds[0] * t167;
        let t181 = t90 - t167;
        let t182 = self.constants[24] * t181;
        let t186 = speeds[0] * t25 + t13 * t165;
        let t187 = self.constants[23] * t181;
        let t189 = t178 * t182 + t186 * t187;
        let t191 = t90 * t186;
        let t192 = t25 * t180 + t191;
        let t195 = t179 + t13 * t180;
        let t199 = t189 + self.constants[23] * t192 + self.constants[24] * t195 - t170;
        let t204 = self.constants[23] * t178 - self.constants[24] * t186;
        let t206 = t181 * t187 + t178 * t204;
        let t207 = speeds[0] * t165;
        let t210 = self.constants[7] * speeds[0];
        let t211 = t165 * t210;
        let t212 = self.constants[7] * t207 + t211;
        let t217 = t168 * (t91 - t167) - speeds[0] * t210;
        let t221 = t25 * t212 + t13 * t217 - t206 - self.constants[24] * t207;
        let t223 = speeds[1] + t178;
        let t227 = cos_delta * t181 - sin_delta * t186;
        let t228 = self.constants[26] * t227;
        let t232 = cos_delta * t186 + sin_delta * t181;
        let t233 = self.constants[25] * t227;
        let t238 = speeds[1] * t227;
        let t240 = t238 - cos_delta * t195 - sin_delta * t207;
        let t242 = t31 * self.constants[10];
        let t246 = t33 * self.constants[10];
        let t254 = t30 * t40 * (t31 * t232 + t33 * t223);
        let t255 = t246 * t254;
        let t257 = t242 * t254;
        let t263 = cos_delta * t199 + t223 * t228 + t232 * t233
            + self.constants[25] * t192 + t242 * (t192 + t162 * t232) + t223 * t255;
        let t267 = t263 + t232 * t257 - sin_delta * t221 - self.constants[26] * t240
            - t246 * (t240 - t162 * t223);
        let t274 = self.constants[25] * t223 - self.constants[26] * t232;
        let t278 = speeds[1] * t232;
        let t280 = sin_delta * t195 - cos_delta * t207 - t278;
        let t283 = t162 + t227;
        let t288 = self.constants[10] * (t31 * t223 - t33 * t232);
        let t294 = cos_delta * t221 + sin_delta * t199 + self.constants[26] * t280
            + t246 * t280 - t227 * t233 - t223 * t274;
        let t296 = t294 - t257 * t283 - t223 * t288;
        let t300 = t186 * t204 - t181 * t182;
        let t314 = t300 + self.constants[23] * t207 + t13 * t212 + t232 * t274
            + t232 * t288 - t25 * t217;
        let t318 = t314 - t227 * t228 - self.constants[25] * t280 - t242 * t280
            - t255 * t283;
        let t320 = t31 * t296 + t33 * t318;
        let t325 = t70 * (t40 * t267 + t29 * t320);
        let t329 = t106 * (t29 * t267 + t102 * t325 - t40 * t320);
        let t331 = t180 - cos_phi * t329;
        let t333 = t179 + t13 * t331;
        let t337 = t191 + t25 * t331;
        let t344 = t181 * self.constants[31] + self.constants[21] * (speeds[2] + t181);
        let t349 = t186 * self.constants[32] + self.constants[30] * t178;
        let t356 = t189 + self.constants[23] * t337 + self.constants[24] * t333 - t173;
        let t360 = t325 - t207 - sin_phi * t329;
        let t363 = self.constants[7] * t360 - t211;
        let t366 = t217 + cos_phi * self.constants[40];
        let t368 = t13 * t366 - t25 * t363;
        let t370 = self.constants[24] * t360 + t368 - t206;
        let t372 = cos_delta * t356 - sin_delta * t370;
        let t378 = t238 + sin_delta * t360 - cos_delta * t333;
        let t386 = t227 * self.constants[38] + t283 * self.constants[22];
        let t391 = t232 * self.constants[36] + t223 * self.constants[37];
        let t396 = self.constants[34] * t372 + self.constants[37] * t378
            + t337 * self.constants[39] + t232 * t386 - t227 * t391;
        let t400 = cos_delta * t370 + sin_delta * t356;
        let t406 = cos_delta * t360 + sin_delta * t333 - t278;
        let t408 = t227 * self.constants[34];
        let t412 = t223 * self.constants[34] - t232 * self.constants[35];
        let t416 = self.constants[17] * t400 + self.constants[35] * t406 - t227 * t408
            - t223 * t412;
        let t421 = t227 * self.constants[35];
        let t427 = t372 * self.constants[17] + t337 * self.constants[34] + t223 * t421
            + t232 * t408 - t378 * self.constants[35];
        let t429 = sin_delta * t416 + cos_delta * t427;
        let t435 = self.constants[33] * t337 + t186 * t344 + t396
            + self.constants[23] * t429 - self.constants[28] * t173
            - self.constants[30] * t333;
        let t436 = t435 - t181 * t349;
        let t444 = self.constants[30] * t186 + t178 * self.constants[33];
        let t452 = t232 * self.constants[37] + t223 * self.constants[39];
        let t458 = t378 * self.constants[36] + t337 * self.constants[37] + t227 * t452
            - t372 * self.constants[35] - t223 * t386;
        let t464 = t25 * t366 + t13 * t363;
        let t466 = t300 - self.constants[23] * t360 - t464;
        let t477 = t406 + t144 * (t31 * t318 + t141 * t329 - t33 * t296 - t137 * t325);
        let t478 = self.constants[22] * t477;
        let t485 = t400 * self.constants[35] + self.constants[38] * t406 + t478
            + t223 * t391 - self.constants[34] * t466 - t232 * t452;
        let t492 = t173 * self.constants[29] + self.constants[30] * t337 + t181 * t444
            + cos_delta * t458 - t333 * self.constants[32] - t178 * t344;
        let t494 = t492 - sin_delta * t485 - self.constants[24] * t429;
        let t500 = t181 * self.constants[29];
        let t502 = self.constants[28] * t181;
        let t508 = t429 + self.constants[28] * t337 + t333 * self.constants[29]
            + t178 * t500 + t186 * t502 - t173 * self.constants[1];
        let t511 = t71 - sin_phi * t108;
        let t521 = cos_delta * t416 - sin_delta * t427;
        let t529 = self.constants[17] * t466 + t232 * t412 - self.constants[34] * t406
            - t227 * t421;
        let t536 = self.constants[28] * t178 - t186 * self.constants[29];
        let t543 = t13
            * (t529 + t186 * t536 - t464 * self.constants[1] - self.constants[28] * t360
                - t181 * t500);
        let t552 = t25
            * (t521 + t368 * self.constants[1] + t360 * self.constants[29] - t181 * t502
                - t178 * t536);
        let t555 = self.constants[21] * t360 - self.constants[7] * (t543 + t552);
        let t560 = t368 * self.constants[29] + self.constants[28] * t464
            + self.constants[31] * t360 + t178 * t349 + sin_delta * t458
            + cos_delta * t485;
        let t564 = t560 + self.constants[24] * t521 + t555 - t186 * t444
            - self.constants[23] * t529;
        let t566 = cos_phi * t108;
        let t569 = t25 * t436 - t13 * t494;
        let t576 = forces[0] + t566 * t569 - t13 * t436 - t25 * t494
            - self.constants[7] * t508 - t511 * t564;
        let t577 = t576 - t145 * t478;
        let t579 = sin_delta * self.constants[41];
        let t580 = sin_delta * t579;
        let t584 = self.constants[32] + self.constants[36] + self.constants[43] - t580;
        let t585 = cos_delta * self.constants[34];
        let t586 = self.constants[23] * t585;
        let t589 = t586 + t586 + self.constants[46];
        let t591 = self.constants[33] + self.constants[39] + t589;
        let t592 = t591 - t584;
        let t593 = t13 * t13;
        let t595 = t13 * t25;
        let t600 = cos_delta * self.constants[37] - self.constants[24] * t585;
        let t603 = self.constants[30] + t600 - self.constants[44] - self.constants[45];
        let t604 = t603 + t603;
        let t606 = t592 * t593 + t595 * t604;
        let t611 = self.constants[28] + t585 + self.constants[42];
        let t613 = t25 * self.constants[47] - t13 * t611;
        let t614 = self.constants[7] * t613;
        let t617 = self.constants[49] - t614 - t614;
        let t619 = sin_delta * self.constants[34];
        let t621 = sin_delta * self.constants[37] - self.constants[24] * t619;
        let t625 = cos_delta * t579 - self.constants[23] * t619;
        let t627 = t13 * t621 + t25 * t625;
        let t637 = t603 + t592 * t595
            + self.constants[7] * (t13 * self.constants[47] + t25 * t611) - t593 * t604;
        let t643 = self.constants[31] + self.constants[38] + t580 + self.constants[43]
            + t589 + t617;
        let t647 = self.constants[7] * t619;
        let t649 = t25 * t621 + t647 - t13 * t625;
        let t655 = t591 - t606;
        let t660 = self.constants[21] * t511;
        let t664 = t13 * sin_delta;
        let t668 = t145 + cos_delta * t511 - sin_delta * t25 - t566 * t664;
        let t669 = self.constants[22] * t668;
        let t675 = t584 + t606 + t617 + t511 * t627
            + t511 * (t627 + t511 * t643 - t566 * t649) + t511 * t660;
        let t678 = t675 + t668 * t669 - t566 * t637
            - t566 * (t637 + t511 * t649 - t566 * t655);
        let t679 = self.constants[0].like(1.0) / t678;
        let t681 = self.constants[39] + t586;
        let t686 = t88 - sin_phi * t128;
        let t688 = cos_phi * t128;
        let t690 = t25 * t647;
        let t691 = t621 + t690;
        let t695 = t691 + t643 * t686 - t649 * t688;
        let t699 = t25 * t681 - t13 * t600;
        let t703 = t699 + t649 * t686 - t655 * t688;
        let t709 = t154 + cos_delta * t686 - t664 * t688;
        let t715 = t13 * t681 + t25 * t600 + self.constants[7] * t585 + t627 * t686
            + t511 * t695 + t660 * t686;
        let t719 = t679 * (t715 + t669 * t709 - t637 * t688 - t566 * t703);
        let t724 = self.constants[21] * t686;
        let t726 = self.constants[22] * t709;
        let t728 = t678 * t719;
        let t734 = self.constants[39] + t686 * t695 + t686 * t691 + t686 * t724
            + t709 * t726 - t688 * t703;
        let t736 = t734 - t688 * t699 - t719 * t728;
        let t737 = self.constants[0].like(1.0) / t736;
        let t747 = forces[1] + t569 * t688 - t396 - t564 * t686 - t154 * t478
            - t577 * t719;
        let t751 = self.constants[7] * (t613 - self.constants[48]);
        let t752 = sin_phi * t131;
        let t754 = cos_phi * t131;
        let t757 = t751 + t643 * t752 + t649 * t754;
        let t762 = t647 - t649 * t752 - t655 * t754;
        let t767 = self.constants[0].like(1.0) - t752;
        let t772 = t159 - cos_delta * t752 - t664 * t754;
        let t784 = t660 * t767 + t669 * t772 - t627 * t752 - t637 * t754 - t511 * t757
            - t566 * t762;
        let t785 = t679 * t784;
        let t791 = t690 + t724 * t767 + t726 * t772 - t686 * t757 - t688 * t762
            - t691 * t752;
        let t794 = t737 * (t791 - t699 * t754 - t728 * t785);
        let t804 = t564 * t752 + t569 * t754 - t555 - t159 * t478 - t577 * t785
            - t747 * t794;
        let t822 = t752 * t757 + t751 * t752 + self.constants[50]
            + self.constants[21] * t767 * t767 + self.constants[22] * t772 * t772
            - t754 * t762;
        let t826 = t804 / (t822 - t647 * t754 - t678 * t785 * t785 - t736 * t794 * t794);
        let t828 = t737 * t747 - t794 * t826;
        let t832 = t577 * t679 - t719 * t828 - t785 * t826;
        let t833 = -(t92 * cos_psi);
        let t834 = -(t92 * sin_psi);
        let t835 = -t134;
        (
            [t833, t834, t835, speeds[0], t90, speeds[1], speeds[2], t162],
            [t832, t828, t826],
        )
    }

    #[inline(always)]
    fn accelerations_unchecked(&self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2]) -> [T; 8] {
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t13 = self.constants[19] * sin_pitch + cos_pitch * self.constants[20];
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t16 = cos_phi * t13;
        let t21 = sin_phi * sin_delta - cos_delta * t16;
        let t25 = self.constants[19] * cos_pitch - self.constants[20] * sin_pitch;
        let t26 = cos_phi * t25;
        let t29 = (t21 * t21 + t26 * t26).sqrt();
        let t30 = self.constants[0].like(1.0) / t29;
        let t31 = t21 * t30;
        let t33 = t26 * t30;
        let t34 = cos_delta * t33;
        let t36 = t25 * t34 - t13 * t31;
        let t43 = cos_phi * sin_delta * t33 + sin_phi * (t25 * t31 + t13 * t34);
        let t47 = sin_phi * cos_delta + sin_delta * t16;
        let t48 = self.constants[10] * t47;
        let t55 = self.constants[23] + cos_delta * self.constants[25];
        let t58 = t43 * t48 + t13 * self.constants[27] + t25 * t55;
        let t62 = sin_delta * self.constants[25];
        let t66 = t25 * self.constants[27] - t13 * t55;
        let t69 = cos_phi * t62 - t36 * t48 - sin_phi * t66;
        let t70 = self.constants[7] * sin_phi + t69;
        let t73 = self.constants[0].like(1.0) / (t36 * t58 + t43 * t70);
        let t74 = sin_phi * t58;
        let t76 = sin_phi * t70;
        let t78 = t36 * t74 + t43 * t76;
        let t80 = self.constants[0].like(1.0) / (cos_phi * t58);
        let t81 = t70 * t80;
        let t83 = t73 * t78 * t81;
        let t90 = t58 - t13 * self.constants[24] - t25 * self.constants[23];
        let t97 = t25 * self.constants[24] - t13 * self.constants[23];
        let t101 = t29 * self.constants[10] + sin_phi * t62 + cos_phi * t66
            - cos_phi * t97;
        let t103 = t26 * t90 - t13 * t101;
        let t105 = sin_phi * t25;
        let t108 = t69 + sin_phi * t97;
        let t110 = t101 * t105 + t26 * t108;
        let t115 = t80 * (t13 * t108 + t90 * t105);
        let t119 = t73 * (t36 * t103 + t43 * t110 + t78 * t115);
        let t122 = self.constants[7] * t43 * t73;
        let t126 = speeds[0] * t83 + speeds[1] * t119 + t122 * speeds[2];
        let t127 = cos_phi * t126;
        let t128 = speeds[0] * t127;
        let t131 = t13 * speeds[0] - t25 * t127;
        let t134 = speeds[0] * t81 + speeds[1] * t115;
        let t135 = sin_phi * t126;
        let t136 = t134 - t135;
        let t137 = self.constants[24] * t136;
        let t141 = t25 * speeds[0] + t13 * t127;
        let t142 = self.constants[23] * t136;
        let t144 = t131 * t137 + t141 * t142;
        let t145 = speeds[0] * t135;
        let t147 = t134 * t141;
        let t148 = t25 * t145 + t147;
        let t151 = t131 * t134;
        let t152 = t13 * t145 + t151;
        let t154 = speeds[2] + t134;
        let t155 = self.constants[7] * t154;
        let t157 = self.constants[7] * t135;
        let t159 = t127 * t157 - t127 * t155;
        let t162 = t144 + self.constants[23] * t148 + self.constants[24] * t152 - t159;
        let t167 = self.constants[23] * t131 - self.constants[24] * t141;
        let t169 = t136 * t142 + t131 * t167;
        let t171 = self.constants[7] * speeds[0];
        let t172 = t127 * t171;
        let t174 = t172 + self.constants[7] * t128;
        let t179 = t157 * (t154 - t135) - speeds[0] * t171;
        let t183 = t25 * t174 + t13 * t179 - t169 - self.constants[24] * t128;
        let t185 = speeds[1] + t131;
        let t189 = cos_delta * t136 - sin_delta * t141;
        let t190 = self.constants[26] * t189;
        let t194 = cos_delta * t141 + sin_delta * t136;
        let t195 = self.constants[25] * t189;
        let t200 = speeds[1] * t189;
        let t202 = t200 - cos_delta * t152 - sin_delta * t128;
        let t204 = t31 * self.constants[10];
        let t207 = t43 * t74 - t36 * t76;
        let t211 = t43 * t58 - t36 * t70;
        let t214 = self.constants[0].like(1.0) / self.constants[10];
        let t215 = (t83 * t211 - t81 * t207) * t214;
        let t224 = t214 * (t36 * t110 + t119 * t211 - t43 * t103 - t115 * t207);
        let t229 = t214 * (self.constants[7] * t36 + t122 * t211);
        let t232 = speeds[0] * t215 + speeds[1] * t224 + speeds[2] * t229;
        let t236 = t33 * self.constants[10];
        let t244 = t30 * t47 * (t31 * t194 + t33 * t185);
        let t245 = t236 * t244;
        let t247 = t204 * t244;
        let t253 = cos_delta * t162 + t185 * t190 + t194 * t195
            + self.constants[25] * t148 + t204 * (t148 + t194 * t232) + t185 * t245;
        let t257 = t253 + t194 * t247 - sin_delta * t183 - self.constants[26] * t202
            - t236 * (t202 - t185 * t232);
        let t264 = self.constants[25] * t185 - self.constants[26] * t194;
        let t268 = speeds[1] * t194;
        let t270 = sin_delta * t152 - cos_delta * t128 - t268;
        let t273 = t189 + t232;
        let t278 = self.constants[10] * (t31 * t185 - t33 * t194);
        let t284 = cos_delta * t183 + sin_delta * t162 + self.constants[26] * t270
            + t236 * t270 - t189 * t195 - t185 * t264;
        let t286 = t284 - t247 * t273 - t185 * t278;
        let t290 = t141 * t167 - t136 * t137;
        let t304 = t290 + self.constants[23] * t128 + t13 * t174 + t194 * t264
            + t194 * t278 - t25 * t179;
        let t308 = t304 - t189 * t190 - self.constants[25] * t270 - t204 * t270
            - t245 * t273;
        let t310 = t31 * t286 + t33 * t308;
        let t313 = t80 * (t47 * t257 + t29 * t310);
        let t319 = t73 * (t29 * t257 + t78 * t313 - t47 * t310);
        let t322 = t313 - t128 - sin_phi * t319;
        let t327 = t179 + cos_phi * self.constants[40];
        let t330 = self.constants[7] * t322 - t172;
        let t332 = t25 * t327 + t13 * t330;
        let t335 = t290 - t332 - self.constants[23] * t322;
        let t341 = t145 - cos_phi * t319;
        let t343 = t151 + t13 * t341;
        let t346 = cos_delta * t322 + sin_delta * t343 - t268;
        let t351 = t185 * self.constants[34] - t194 * self.constants[35];
        let t353 = t189 * self.constants[35];
        let t357 = t335 * self.constants[17] + t194 * t351 - self.constants[34] * t346
            - t189 * t353;
        let t365 = t131 * self.constants[28] - self.constants[29] * t141;
        let t367 = self.constants[29] * t136;
        let t373 = t13
            * (t357 + t141 * t365 - t332 * self.constants[1] - t322 * self.constants[28]
                - t136 * t367);
        let t376 = t13 * t327 - t25 * t330;
        let t379 = t376 + self.constants[24] * t322 - t169;
        let t382 = t147 + t25 * t341;
        let t386 = t159 + sin_phi * self.constants[40];
        let t389 = t144 + self.constants[23] * t382 + self.constants[24] * t343 - t386;
        let t391 = cos_delta * t379 + sin_delta * t389;
        let t394 = t189 * self.constants[34];
        let t399 = t391 * self.constants[17] + self.constants[35] * t346 - t189 * t394
            - t185 * t351;
        let t403 = cos_delta * t389 - sin_delta * t379;
        let t409 = t200 + sin_delta * t322 - cos_delta * t343;
        let t416 = t403 * self.constants[17] + t382 * self.constants[34] + t185 * t353
            + t194 * t394 - self.constants[35] * t409;
        let t418 = cos_delta * t399 - sin_delta * t416;
        let t421 = t136 * self.constants[28];
        let t428 = t25
            * (t418 + t376 * self.constants[1] + self.constants[29] * t322 - t136 * t421
                - t131 * t365);
        let t431 = t322 * self.constants[21] - self.constants[7] * (t373 + t428);
        let t432 = sin_phi * t122;
        let t441 = t141 * self.constants[32] + t131 * self.constants[30];
        let t446 = t141 * self.constants[30] + t131 * self.constants[33];
        let t456 = t194 * self.constants[37] + t185 * self.constants[39];
        let t462 = t189 * self.constants[38] + t273 * self.constants[22];
        let t467 = self.constants[36] * t409 + t382 * self.constants[37] + t189 * t456
            - self.constants[35] * t403 - t185 * t462;
        let t479 = t214 * (t31 * t308 + t211 * t319 - t33 * t286 - t207 * t313);
        let t481 = self.constants[22] * (t346 + t479);
        let t484 = t194 * self.constants[36] + t185 * self.constants[37];
        let t491 = self.constants[35] * t391 + self.constants[38] * t346 + t481
            + t185 * t484 - self.constants[34] * t335 - t194 * t456;
        let t499 = self.constants[29] * t376 + self.constants[28] * t332
            + t322 * self.constants[31] + t131 * t441 + sin_delta * t467
            + cos_delta * t491;
        let t503 = t499 + self.constants[24] * t418 + t431 - t141 * t446
            - self.constants[23] * t357;
        let t505 = cos_phi * t122;
        let t512 = t136 * self.constants[31] + self.constants[21] * (speeds[2] + t136);
        let t523 = t403 * self.constants[34] + t409 * self.constants[37]
            + t382 * self.constants[39] + t194 * t462 - t189 * t484;
        let t526 = sin_delta * t399 + cos_delta * t416;
        let t532 = self.constants[33] * t382 + t141 * t512 + t523
            + self.constants[23] * t526 - self.constants[28] * t386
            - self.constants[30] * t343;
        let t533 = t532 - t136 * t441;
        let t547 = self.constants[29] * t386 + self.constants[30] * t382 + t136 * t446
            + cos_delta * t467 - self.constants[32] * t343 - t131 * t512;
        let t549 = t547 - sin_delta * t491 - self.constants[24] * t526;
        let t551 = t25 * t533 - t13 * t549;
        let t566 = t526 + self.constants[28] * t382 + self.constants[29] * t343
            + t131 * t367 + t141 * t421 - t386 * self.constants[1];
        let t569 = t81 - sin_phi * t83;
        let t571 = cos_phi * t83;
        let t578 = forces[0] + t551 * t571 - t13 * t533 - t25 * t549
            - self.constants[7] * t566 - t503 * t569;
        let t579 = t578 - t215 * t481;
        let t581 = sin_delta * self.constants[34];
        let t583 = sin_delta * self.constants[37] - self.constants[24] * t581;
        let t586 = sin_delta * self.constants[41];
        let t589 = cos_delta * t586 - self.constants[23] * t581;
        let t591 = t13 * t583 + t25 * t589;
        let t596 = cos_delta * self.constants[34];
        let t598 = cos_delta * self.constants[37] - self.constants[24] * t596;
        let t601 = self.constants[30] + t598 - self.constants[44] - self.constants[45];
        let t602 = sin_delta * t586;
        let t606 = self.constants[32] + self.constants[36] + self.constants[43] - t602;
        let t607 = self.constants[23] * t596;
        let t610 = t607 + t607 + self.constants[46];
        let t612 = self.constants[33] + self.constants[39] + t610;
        let t613 = t612 - t606;
        let t614 = t25 * t13;
        let t616 = t13 * t13;
        let t617 = t601 + t601;
        let t623 = self.constants[28] + t596 + self.constants[42];
        let t629 = t601 + t613 * t614
            + self.constants[7] * (t13 * self.constants[47] + t25 * t623) - t616 * t617;
        let t633 = t25 * self.constants[47] - t13 * t623;
        let t636 = self.constants[7] * (t633 - self.constants[48]);
        let t637 = self.constants[7] * t633;
        let t640 = self.constants[49] - t637 - t637;
        let t645 = self.constants[31] + self.constants[38] + t602 + self.constants[43]
            + t610 + t640;
        let t649 = self.constants[7] * t581;
        let t651 = t25 * t583 + t649 - t13 * t589;
        let t654 = t636 + t432 * t645 + t505 * t651;
        let t659 = t613 * t616 + t614 * t617;
        let t660 = t612 - t659;
        let t663 = t649 - t432 * t651 - t505 * t660;
        let t666 = self.constants[0].like(1.0) - t432;
        let t667 = self.constants[21] * t569;
        let t670 = sin_delta * t13;
        let t673 = t229 - cos_delta * t432 - t505 * t670;
        let t679 = t215 + cos_delta * t569 - sin_delta * t25 - t571 * t670;
        let t680 = self.constants[22] * t679;
        let t686 = t666 * t667 + t673 * t680 - t432 * t591 - t505 * t629 - t569 * t654
            - t571 * t663;
        let t705 = t606 + t640 + t659 + t569 * t591
            + t569 * (t591 + t569 * t645 - t571 * t651) + t569 * t667;
        let t708 = t705 + t679 * t680 - t571 * t629
            - t571 * (t629 + t569 * t651 - t571 * t660);
        let t709 = self.constants[0].like(1.0) / t708;
        let t710 = t686 * t709;
        let t712 = t25 * t649;
        let t714 = t115 - sin_phi * t119;
        let t716 = cos_phi * t119;
        let t718 = t583 + t712;
        let t720 = self.constants[39] + t607;
        let t723 = t25 * t720 - t13 * t598;
        let t725 = self.constants[21] * t714;
        let t730 = t224 + cos_delta * t714 - t670 * t716;
        let t731 = self.constants[22] * t730;
        let t741 = t718 + t645 * t714 - t651 * t716;
        let t746 = t723 + t651 * t714 - t660 * t716;
        let t754 = t13 * t720 + t25 * t598 + self.constants[7] * t596 + t591 * t714
            + t569 * t741 + t667 * t714;
        let t758 = t709 * (t754 + t680 * t730 - t629 * t716 - t571 * t746);
        let t759 = t708 * t758;
        let t765 = t712 + t666 * t725 + t673 * t731 - t654 * t714 - t663 * t716
            - t432 * t718;
        let t779 = self.constants[39] + t714 * t741 + t714 * t718 + t714 * t725
            + t730 * t731 - t716 * t746;
        let t781 = t779 - t716 * t723 - t758 * t759;
        let t782 = self.constants[0].like(1.0) / t781;
        let t783 = (t765 - t505 * t723 - t710 * t759) * t782;
        let t793 = forces[1] + t551 * t716 - t523 - t503 * t714 - t224 * t481
            - t579 * t758;
        let t799 = t432 * t503 + t505 * t551 - t431 - t229 * t481 - t579 * t710
            - t783 * t793;
        let t817 = t432 * t654 + t432 * t636 + self.constants[50]
            + self.constants[21] * t666 * t666 + self.constants[22] * t673 * t673
            - t505 * t663;
        let t821 = t799 / (t817 - t505 * t649 - t708 * t710 * t710 - t781 * t783 * t783);
        let t825 = t782 * t793 - t783 * t821;
        let t829 = t579 * t709 - t758 * t825 - t710 * t821;
        let t833 = t313 + t81 * t829 + t115 * t825;
        let t835 = self.constants[7] * (t821 + t833);
        let t838 = t126 * t155;
        let t843 = cos_psi * t838 - t835 * sin_psi;
        let t855 = t479 + t215 * t829 + t224 * t825 + t229 * t821;
        let t856 = -(cos_psi * t835 + sin_psi * t838);
        let t857 = -(t319 + t83 * t829 + t119 * t825 + t122 * t821);
        [t856, t843, t857, t829, t833, t825, t821, t855]
    }

    fn energy_unchecked(&self, positions: &[T; 8], speeds: &[T; 3]) -> [T; 2] {
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t6 = sin_delta * self.constants[41];
        let t7 = sin_delta * t6;
        let t11 = self.constants[32] + self.constants[36] + self.constants[43] - t7;
        let t17 = cos_delta * self.constants[34];
        let t18 = self.constants[23] * t17;
        let t21 = t18 + t18 + self.constants[46];
        let t23 = self.constants[33] + self.constants[39] + t21;
        let t24 = t23 - t11;
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t32 = self.constants[19] * sin_pitch + self.constants[20] * cos_pitch;
        let t33 = t32 * t32;
        let t37 = self.constants[19] * cos_pitch - sin_pitch * self.constants[20];
        let t38 = t32 * t37;
        let t46 = cos_delta * self.constants[37] - t17 * self.constants[24];
        let t49 = self.constants[30] + t46 - self.constants[44] - self.constants[45];
        let t50 = t49 + t49;
        let t52 = t24 * t33 + t38 * t50;
        let t59 = t17 + self.constants[28] + self.constants[42];
        let t61 = t37 * self.constants[47] - t32 * t59;
        let t62 = self.constants[7] * t61;
        let t65 = self.constants[49] - t62 - t62;
        let t67 = sin_delta * self.constants[34];
        let t69 = sin_delta * self.constants[37] - self.constants[24] * t67;
        let t73 = t6 * cos_delta - self.constants[23] * t67;
        let t75 = t32 * t69 + t37 * t73;
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t80 = t32 * cos_phi;
        let t83 = sin_delta * sin_phi - cos_delta * t80;
        let t85 = t37 * cos_phi;
        let t88 = (t83 * t83 + t85 * t85).sqrt();
        let t89 = self.constants[0].like(1.0) / t88;
        let t90 = t83 * t89;
        let t92 = t85 * t89;
        let t93 = cos_delta * t92;
        let t95 = t37 * t93 - t32 * t90;
        let t100 = self.constants[10] * (cos_delta * sin_phi + sin_delta * t80);
        let t103 = sin_delta * self.constants[25];
        let t108 = self.constants[23] + cos_delta * self.constants[25];
        let t110 = t37 * self.constants[27] - t32 * t108;
        let t113 = cos_phi * t103 - t95 * t100 - sin_phi * t110;
        let t114 = self.constants[7] * sin_phi + t113;
        let t121 = sin_delta * cos_phi * t92 + sin_phi * (t37 * t90 + t32 * t93);
        let t126 = t100 * t121 + t32 * self.constants[27] + t37 * t108;
        let t128 = self.constants[0].like(1.0) / (cos_phi * t126);
        let t129 = t114 * t128;
        let t130 = sin_phi * t126;
        let t132 = sin_phi * t114;
        let t134 = t95 * t130 + t121 * t132;
        let t138 = self.constants[0].like(1.0) / (t95 * t126 + t114 * t121);
        let t140 = t129 * t134 * t138;
        let t142 = t129 - sin_phi * t140;
        let t152 = t49 + t24 * t38
            + self.constants[7] * (t32 * self.constants[47] + t37 * t59) - t33 * t50;
        let t153 = cos_phi * t140;
        let t161 = t7 + self.constants[43] + t21 + t65 + self.constants[31]
            + self.constants[38];
        let t165 = self.constants[7] * t67;
        let t167 = t37 * t69 + t165 - t32 * t73;
        let t173 = t23 - t52;
        let t179 = t142 * self.constants[21];
        let t183 = t121 * t130 - t95 * t132;
        let t187 = t121 * t126 - t95 * t114;
        let t190 = self.constants[0].like(1.0) / self.constants[10];
        let t194 = sin_delta * t32;
        let t198 = (t140 * t187 - t129 * t183) * t190 + cos_delta * t142
            - sin_delta * t37 - t153 * t194;
        let t200 = t198 * self.constants[22];
        let t206 = t11 + t52 + t65 + t75 * t142
            + t142 * (t75 + t142 * t161 - t153 * t167) + t142 * t179;
        let t210 = speeds[0]
            * (t206 + t198 * t200 - t152 * t153
                - t153 * (t152 + t142 * t167 - t153 * t173));
        let t212 = self.constants[39] + t18;
        let t218 = t37 * self.constants[24] - self.constants[23] * t32;
        let t220 = t113 + sin_phi * t218;
        let t222 = t37 * sin_phi;
        let t226 = t126 - t32 * self.constants[24] - self.constants[23] * t37;
        let t229 = t128 * (t32 * t220 + t222 * t226);
        let t237 = t88 * self.constants[10] + sin_phi * t103 + cos_phi * t110
            - cos_phi * t218;
        let t239 = t85 * t226 - t32 * t237;
        let t243 = t222 * t237 + t85 * t220;
        let t248 = t138 * (t95 * t239 + t121 * t243 + t134 * t229);
        let t250 = t229 - sin_phi * t248;
        let t252 = cos_phi * t248;
        let t254 = t37 * t165;
        let t255 = t69 + t254;
        let t259 = t255 + t161 * t250 - t167 * t252;
        let t263 = t37 * t212 - t32 * t46;
        let t267 = t263 + t167 * t250 - t173 * t252;
        let t280 = t190 * (t95 * t243 + t187 * t248 - t121 * t239 - t183 * t229)
            + cos_delta * t250;
        let t281 = t280 - t194 * t252;
        let t287 = t32 * t212 + t37 * t46 + t17 * self.constants[7] + t75 * t250
            + t142 * t259 + t179 * t250;
        let t290 = t287 + t200 * t281 - t152 * t252 - t153 * t267;
        let t294 = self.constants[7] * t121 * t138;
        let t295 = sin_phi * t294;
        let t297 = cos_phi * t294;
        let t300 = t61 - self.constants[48];
        let t301 = self.constants[7] * t300;
        let t305 = t301 + t161 * t295 + t167 * t297;
        let t310 = t165 - t167 * t295 - t173 * t297;
        let t313 = self.constants[0].like(1.0) - t295;
        let t322 = t190 * (self.constants[7] * t95 + t187 * t294) - cos_delta * t295
            - t194 * t297;
        let t328 = t179 * t313 + t200 * t322 - t75 * t295 - t152 * t297 - t142 * t305
            - t153 * t310;
        let t338 = self.constants[21] * t250;
        let t340 = self.constants[22] * t281;
        let t346 = self.constants[39] + t250 * t259 + t250 * t255 + t250 * t338
            + t281 * t340 - t252 * t267;
        let t359 = t254 + t313 * t338 + t322 * t340 - t250 * t305 - t252 * t310
            - t255 * t295;
        let t360 = t359 - t263 * t297;
        let t364 = speeds[1]
            * (speeds[0] * t290 + speeds[1] * (t346 - t252 * t263) + speeds[2] * t360);
        let t380 = t295 * t305 + t295 * t301 + self.constants[50]
            + self.constants[21] * t313 * t313 + self.constants[22] * t322 * t322
            - t297 * t310;
        let t387 = speeds[0] * (t210 + speeds[1] * t290 + speeds[2] * t328) + t364
            + speeds[2]
                * (speeds[0] * t328 + speeds[1] * t360
                    + speeds[2] * (t380 - t165 * t297));
        let t389 = t387 * self.constants[0].like(0.5);
        let t395 = -(self.constants[40] * (t67 * sin_phi + cos_phi * t300));
        [t389, t395]
    }

    fn contact_forces_unchecked(&self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2]) -> [[T; 3]; 2] {
        let (
            sin_psi, cos_psi, sin_pitch, cos_pitch, t9, t13, sin_phi, cos_phi, sin_delta, cos_delta,
            t19, t24, t26, t29, t30, t31, t33, t34, t36, t43, t47, t48, t55, t58, t59, t64, t68,
            t71, t72, t73, t75, t77, t78, t82, t84, t91, t98, t102, t104, t106, t109, t111, t116,
            t120, t124, t127, t128, t130, t133, t138, t142, t143, t144, t145, t147, t149, t151,
            t153, t155, t158, t159, t160, t161, t163, t165, t166, t168, t169, t172, t173, t175,
            t177, t178, t181, t186, t188, t189, t192, t197, t199, t203, t204, t208, t209, t214,
            t216, t218, t221, t225, t228, t229, t238, t243, t246, t250, t258, t259, t261, t267,
            t271, t278, t282, t284, t287, t292, t298, t300, t304, t318, t322, t324, t329, t333,
            t335, t336, t340, t342, t345, t351, t353, t356, t361, t363, t365, t367, t375, t376,
            t379, t382, t385, t386, t389, t391, t394, t397, t399, t403, t409, t413, t416, t418,
            t421, t424, t429, t431, t432, t441, t446, t448, t457, t463, t465, t468, t480, t482,
            t485, t488, t492, t500, t503, t505, t512, t515, t521, t524, t527, t533, t540, t548,
            t549, t551, t562, t567, t569, t571, t578, t579, t581, t583, t586, t589, t591, t596,
            t598, t601, t602, t606, t607, t610, t612, t613, t614, t616, t617, t623, t629, t633,
            t636, t637, t640, t645, t649, t651, t654, t659, t660, t663, t666, t667, t670, t673,
            t679, t680, t686, t705, t708, t709, t710, t712, t714, t716, t718, t720, t723, t725,
            t730, t731, t741, t746, t754, t758, t759, t765, t779, t781, t782, t783, t793, t799,
            t817, t821, t825, t829, t837, t841, t842, t844, t846, t851, t856, t859, t862, t865,
            t868,
        );
        (sin_psi, cos_psi) = positions[2].sin_cos();
        (sin_pitch, cos_pitch) = positions[4].sin_cos();
        t9 = self.constants[19] * sin_pitch + self.constants[20] * cos_pitch;
        t13 = self.constants[19] * cos_pitch - sin_pitch * self.constants[20];
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
        t48 = self.constants[10] * t47;
        t55 = self.constants[23] + cos_delta * self.constants[25];
        t58 = t43 * t48 + t9 * self.constants[27] + t13 * t55;
        t59 = sin_phi * t58;
        t64 = sin_delta * self.constants[25];
        t68 = t13 * self.constants[27] - t9 * t55;
        t71 = cos_phi * t64 - t36 * t48 - sin_phi * t68;
        t72 = sin_phi * self.constants[7] + t71;
        t73 = sin_phi * t72;
        t75 = t36 * t59 + t43 * t73;
        t77 = self.constants[0].like(1.0) / (cos_phi * t58);
        t78 = t72 * t77;
        t82 = self.constants[0].like(1.0) / (t36 * t58 + t43 * t72);
        t84 = t75 * t78 * t82;
        t91 = t58 - t9 * self.constants[24] - t13 * self.constants[23];
        t98 = t13 * self.constants[24] - t9 * self.constants[23];
        t102 = t29 * self.constants[10] + sin_phi * t64 + cos_phi * t68 - cos_phi * t98;
        t104 = t26 * t91 - t9 * t102;
        t106 = t13 * sin_phi;
        t109 = t71 + sin_phi * t98;
        t111 = t102 * t106 + t26 * t109;
        t116 = t77 * (t9 * t109 + t91 * t106);
        t120 = t82 * (t36 * t104 + t43 * t111 + t75 * t116);
        t124 = t43 * self.constants[7] * t82;
        t127 = speeds[0] * t84 + speeds[1] * t120 + speeds[2] * t124;
        t128 = cos_phi * t127;
        t130 = speeds[0] * t13 + t9 * t128;
        t133 = t9 * speeds[0] - t13 * t128;
        t138 = t133 * self.constants[28] - t130 * self.constants[29];
        t142 = speeds[0] * t78 + speeds[1] * t116;
        t143 = sin_phi * t127;
        t144 = t142 - t143;
        t145 = self.constants[29] * t144;
        t147 = t130 * t138 - t144 * t145;
        t149 = speeds[0] * self.constants[7];
        t151 = speeds[2] + t142;
        t153 = self.constants[7] * t143;
        t155 = (t151 - t143) * t153 - speeds[0] * t149;
        t158 = t155 + cos_phi * self.constants[40];
        t159 = t13 * t158;
        t160 = t128 * t149;
        t161 = self.constants[24] * t144;
        t163 = self.constants[23] * t144;
        t165 = t133 * t161 + t130 * t163;
        t166 = speeds[0] * t143;
        t168 = t130 * t142;
        t169 = t13 * t166 + t168;
        t172 = t133 * t142;
        t173 = t9 * t166 + t172;
        t175 = t128 * t151;
        t177 = t128 * t153;
        t178 = t177 - self.constants[7] * t175;
        t181 = t165 + self.constants[23] * t169 + self.constants[24] * t173 - t178;
        t186 = self.constants[23] * t133 - self.constants[24] * t130;
        t188 = t144 * t163 + t133 * t186;
        t189 = speeds[0] * t128;
        t192 = t160 + self.constants[7] * t189;
        t197 = t13 * t192 + t9 * t155 - t188 - self.constants[24] * t189;
        t199 = speeds[1] + t133;
        t203 = cos_delta * t144 - sin_delta * t130;
        t204 = self.constants[26] * t203;
        t208 = cos_delta * t130 + sin_delta * t144;
        t209 = self.constants[25] * t203;
        t214 = speeds[1] * t203;
        t216 = t214 - cos_delta * t173 - sin_delta * t189;
        t218 = t31 * self.constants[10];
        t221 = t43 * t59 - t36 * t73;
        t225 = t43 * t58 - t36 * t72;
        t228 = self.constants[0].like(1.0) / self.constants[10];
        t229 = (t84 * t225 - t78 * t221) * t228;
        t238 = t228 * (t36 * t111 + t120 * t225 - t43 * t104 - t116 * t221);
        t243 = t228 * (t36 * self.constants[7] + t124 * t225);
        t246 = speeds[0] * t229 + speeds[1] * t238 + speeds[2] * t243;
        t250 = t33 * self.constants[10];
        t258 = t30 * t47 * (t31 * t208 + t33 * t199);
        t259 = t250 * t258;
        t261 = t218 * t258;
        t267 = cos_delta * t181 + t199 * t204 + t208 * t209 + self.constants[25] * t169
            + t218 * (t169 + t208 * t246) + t199 * t259;
        t271 = t267 + t208 * t261 - sin_delta * t197 - self.constants[26] * t216
            - t250 * (t216 - t199 * t246);
        t278 = self.constants[25] * t199 - self.constants[26] * t208;
        t282 = speeds[1] * t208;
        t284 = sin_delta * t173 - cos_delta * t189 - t282;
        t287 = t203 + t246;
        t292 = self.constants[10] * (t31 * t199 - t33 * t208);
        t298 = cos_delta * t197 + sin_delta * t181 + self.constants[26] * t284
            + t250 * t284 - t203 * t209 - t199 * t278;
        t300 = t298 - t261 * t287 - t199 * t292;
        t304 = t130 * t186 - t144 * t161;
        t318 = t304 + self.constants[23] * t189 + t9 * t192 + t208 * t278 + t208 * t292
            - t13 * t155;
        t322 = t318 - t203 * t204 - self.constants[25] * t284 - t218 * t284
            - t259 * t287;
        t324 = t31 * t300 + t33 * t322;
        t329 = t77 * (t47 * t271 + t29 * t324);
        t333 = t82 * (t29 * t271 + t75 * t329 - t47 * t324);
        t335 = t189 - t329;
        t336 = sin_phi * t333 + t335;
        t340 = self.constants[7] * t336 + t160;
        t342 = t159 - t9 * t340;
        t345 = t304 - t342 + self.constants[23] * t336;
        t351 = t166 - cos_phi * t333;
        t353 = t172 + t9 * t351;
        t356 = sin_delta * t353 - cos_delta * t336 - t282;
        t361 = t199 * self.constants[34] - t208 * self.constants[35];
        t363 = t203 * self.constants[35];
        t365 = t208 * t361 - t203 * t363;
        t367 = t345 * self.constants[17] + t365 - self.constants[34] * t356;
        t375 = t9 * t158;
        t376 = t375 + t13 * t340;
        t379 = t376 - self.constants[24] * t336 - t188;
        t382 = t168 + t13 * t351;
        t385 = sin_phi * self.constants[40];
        t386 = t178 + t385;
        t389 = t165 + self.constants[23] * t382 + self.constants[24] * t353 - t386;
        t391 = cos_delta * t379 + sin_delta * t389;
        t394 = t203 * self.constants[34];
        t397 = t203 * t394 + t199 * t361;
        t399 = t391 * self.constants[17] + self.constants[35] * t356 - t397;
        t403 = cos_delta * t389 - sin_delta * t379;
        t409 = t214 - sin_delta * t336 - cos_delta * t353;
        t413 = t199 * t363 + t208 * t394;
        t416 = t403 * self.constants[17] + t382 * self.constants[34] + t413
            - self.constants[35] * t409;
        t418 = cos_delta * t399 - sin_delta * t416;
        t421 = self.constants[28] * t144;
        t424 = t144 * t421 + t133 * t138;
        t429 = t9 * (t147 + t367 - self.constants[1] * t342 + self.constants[28] * t336)
            + t13 * (t418 + self.constants[1] * t376 - self.constants[29] * t336 - t424);
        t431 = t336 * self.constants[21] + self.constants[7] * t429;
        t432 = sin_phi * t124;
        t441 = t130 * self.constants[32] + t133 * self.constants[30];
        t446 = t130 * self.constants[30] + t133 * self.constants[33];
        t448 = t133 * t441 - t130 * t446;
        t457 = t208 * self.constants[37] + t199 * self.constants[39];
        t463 = t203 * self.constants[38] + t287 * self.constants[22];
        t465 = t203 * t457 - t199 * t463;
        t468 = self.constants[36] * t409 + t382 * self.constants[37] + t465
            - self.constants[35] * t403;
        t480 = t228 * (t31 * t322 + t225 * t333 - t33 * t300 - t221 * t329);
        t482 = self.constants[22] * (t356 + t480);
        t485 = t208 * self.constants[36] + t199 * self.constants[37];
        t488 = t199 * t485 - t208 * t457;
        t492 = self.constants[35] * t391 + self.constants[38] * t356 + t482 + t488
            - self.constants[34] * t345;
        t500 = self.constants[29] * t376 + self.constants[28] * t342
            - t336 * self.constants[31] + t448 + sin_delta * t468 + cos_delta * t492;
        t503 = t500 + self.constants[24] * t418 - t431 - self.constants[23] * t367;
        t505 = cos_phi * t124;
        t512 = t144 * self.constants[31] + self.constants[21] * (speeds[2] + t144);
        t515 = t130 * t512 - t144 * t441;
        t521 = t208 * t463 - t203 * t485;
        t524 = t403 * self.constants[34] + t409 * self.constants[37]
            + t382 * self.constants[39] + t521;
        t527 = sin_delta * t399 + cos_delta * t416;
        t533 = self.constants[33] * t382 + t515 + t524 + self.constants[23] * t527
            - self.constants[28] * t386 - self.constants[30] * t353;
        t540 = t144 * t446 - t133 * t512;
        t548 = self.constants[29] * t386 + self.constants[30] * t382 + t540
            + cos_delta * t468 - self.constants[32] * t353 - sin_delta * t492;
        t549 = t548 - self.constants[24] * t527;
        t551 = t13 * t533 - t9 * t549;
        t562 = t133 * t145 + t130 * t421;
        t567 = self.constants[7]
            * (t527 + self.constants[28] * t382 + self.constants[29] * t353 + t562
                - self.constants[1] * t386);
        t569 = t78 - sin_phi * t84;
        t571 = cos_phi * t84;
        t578 = forces[0] + t551 * t571 - t9 * t533 - t13 * t549 - t567 - t503 * t569;
        t579 = t578 - t229 * t482;
        t581 = sin_delta * self.constants[34];
        t583 = sin_delta * self.constants[37] - self.constants[24] * t581;
        t586 = sin_delta * self.constants[41];
        t589 = cos_delta * t586 - self.constants[23] * t581;
        t591 = t9 * t583 + t13 * t589;
        t596 = cos_delta * self.constants[34];
        t598 = cos_delta * self.constants[37] - self.constants[24] * t596;
        t601 = self.constants[30] + t598 - self.constants[44] - self.constants[45];
        t602 = sin_delta * t586;
        t606 = self.constants[32] + self.constants[36] + self.constants[43] - t602;
        t607 = self.constants[23] * t596;
        t610 = t607 + t607 + self.constants[46];
        t612 = self.constants[33] + self.constants[39] + t610;
        t613 = t612 - t606;
        t614 = t9 * t13;
        t616 = t9 * t9;
        t617 = t601 + t601;
        t623 = self.constants[28] + t596 + self.constants[42];
        t629 = t601 + t613 * t614
            + self.constants[7] * (t9 * self.constants[47] + t13 * t623) - t616 * t617;
        t633 = t13 * self.constants[47] - t9 * t623;
        t636 = self.constants[7] * (t633 - self.constants[48]);
        t637 = self.constants[7] * t633;
        t640 = self.constants[49] - t637 - t637;
        t645 = self.constants[31] + self.constants[38] + t602 + self.constants[43] + t610
            + t640;
        t649 = self.constants[7] * t581;
        t651 = t13 * t583 + t649 - t9 * t589;
        t654 = t636 + t432 * t645 + t505 * t651;
        t659 = t613 * t616 + t614 * t617;
        t660 = t612 - t659;
        t663 = t649 - t432 * t651 - t505 * t660;
        t666 = self.constants[0].like(1.0) - t432;
        t667 = self.constants[21] * t569;
        t670 = t9 * sin_delta;
        t673 = t243 - cos_delta * t432 - t505 * t670;
        t679 = t229 + cos_delta * t569 - t13 * sin_delta - t571 * t670;
        t680 = self.constants[22] * t679;
        t686 = t666 * t667 + t673 * t680 - t432 * t591 - t505 * t629 - t569 * t654
            - t571 * t663;
        t705 = t606 + t640 + t659 + t569 * t591
            + t569 * (t591 + t569 * t645 - t571 * t651) + t569 * t667;
        t708 = t705 + t679 * t680 - t571 * t629
            - t571 * (t629 + t569 * t651 - t571 * t660);
        t709 = self.constants[0].like(1.0) / t708;
        t710 = t686 * t709;
        t712 = t13 * t649;
        t714 = t116 - sin_phi * t120;
        t716 = cos_phi * t120;
        t718 = t583 + t712;
        t720 = self.constants[39] + t607;
        t723 = t13 * t720 - t9 * t598;
        t725 = self.constants[21] * t714;
        t730 = t238 + cos_delta * t714 - t670 * t716;
        t731 = self.constants[22] * t730;
        t741 = t718 + t645 * t714 - t651 * t716;
        t746 = t723 + t651 * t714 - t660 * t716;
        t754 = t9 * t720 + t13 * t598 + self.constants[7] * t596 + t591 * t714
            + t569 * t741 + t667 * t714;
        t758 = t709 * (t754 + t680 * t730 - t629 * t716 - t571 * t746);
        t759 = t708 * t758;
        t765 = t712 + t666 * t725 + t673 * t731 - t654 * t714 - t663 * t716
            - t432 * t718;
        t779 = self.constants[39] + t714 * t741 + t714 * t718 + t714 * t725 + t730 * t731
            - t716 * t746;
        t781 = t779 - t716 * t723 - t758 * t759;
        t782 = self.constants[0].like(1.0) / t781;
        t783 = (t765 - t505 * t723 - t710 * t759) * t782;
        t793 = forces[1] + t551 * t716 - t524 - t503 * t714 - t238 * t482 - t579 * t758;
        t799 = t432 * t503 + t505 * t551 + t431 - t243 * t482 - t579 * t710
            - t783 * t793;
        t817 = t432 * t654 + t432 * t636 + self.constants[50]
            + self.constants[21] * t666 * t666 + self.constants[22] * t673 * t673
            - t505 * t663;
        t821 = t799 / (t817 - t505 * t649 - t708 * t710 * t710 - t781 * t783 * t783);
        t825 = t782 * t793 - t783 * t821;
        t829 = t579 * t709 - t758 * t825 - t710 * t821;
        t837 = t333 + t84 * t829 + t120 * t825 + t124 * t821;
        t841 = t78 * t829 + t116 * t825 - sin_phi * t837 - t335;
        t842 = t821 + t841;
        t844 = self.constants[7] * t842 - t160;
        t846 = t159 + t9 * t844;
        t851 = t304 - t846 - self.constants[23] * t841;
        t856 = t166 - cos_phi * t837;
        t859 = t13 * t829 - t172 - t9 * t856;
        t862 = cos_delta * t841 - t282 - sin_delta * t859;
        t865 = t365 + self.constants[17] * t851 - self.constants[34] * t862;
        t868 = t147 + t865 - self.constants[1] * t846 - self.constants[28] * t841;
        let (
            t871, t876, t881, t887, t890, t892, t896, t900, t902, t907, t911, t913, t916, t918,
            t926, t927, t938, t946, t955, t959, t969, t976, t990, t994, t998, t1000, t1001, t1006,
            t1013, t1017, t1020, t1022, t1025, t1030, t1034, t1037, t1040, t1041,
        );
        t871 = t375 - t13 * t844;
        t876 = t871 + self.constants[24] * t841 - t188;
        t881 = t168 + t13 * t856 + t9 * t829;
        t887 = t177 + t385 - self.constants[7] * (t175 + t829);
        t890 = t165 + self.constants[23] * t881 - self.constants[24] * t859 - t887;
        t892 = cos_delta * t876 + sin_delta * t890;
        t896 = self.constants[17] * t892 + self.constants[35] * t862 - t397;
        t900 = cos_delta * t890 - sin_delta * t876;
        t902 = t825 + t881;
        t907 = t214 + cos_delta * t859 + sin_delta * t841;
        t911 = t413 + self.constants[17] * t900 + self.constants[34] * t902
            - self.constants[35] * t907;
        t913 = cos_delta * t896 - sin_delta * t911;
        t916 = self.constants[1] * t871 + self.constants[29] * t841 + t913 - t424;
        t918 = t9 * t868 + t13 * t916;
        t926 = self.constants[22]
            * (t480 + t862 + t229 * t829 + t238 * t825 + t243 * t821);
        t927 = t228 * t926;
        t938 = t465 + self.constants[36] * t907 + self.constants[37] * t902
            - self.constants[35] * t900;
        t946 = t488 + t926 + self.constants[35] * t892 + self.constants[38] * t862
            - self.constants[34] * t851;
        t955 = t448 + self.constants[29] * t871 + self.constants[28] * t846
            + self.constants[31] * t841 + self.constants[21] * t842 + sin_delta * t938;
        t959 = t955 + cos_delta * t946 + self.constants[24] * t913
            - self.constants[23] * t865 - self.constants[7] * t918;
        t969 = sin_delta * t896 + cos_delta * t911;
        t976 = t515 + t521 + self.constants[30] * t859 + self.constants[33] * t881
            + self.constants[34] * t900 + self.constants[37] * t907
            + self.constants[39] * t902;
        t990 = t540 + self.constants[29] * t887 + self.constants[32] * t859
            + self.constants[30] * t881 + cos_delta * t938 - sin_delta * t946;
        t994 = cos_phi
            * (t13 * (t976 + self.constants[23] * t969 - self.constants[28] * t887)
                - t9 * (t990 - self.constants[24] * t969));
        t998 = t82 * (sin_phi * t959 + t994 - t225 * t927);
        t1000 = t36 * t927 - t43 * t998;
        t1001 = t918 - t1000;
        t1006 = t43 * t927 + t36 * t998;
        t1013 = t562 + t969 + self.constants[28] * t881 - self.constants[1] * t887
            - self.constants[29] * t859;
        t1017 = t13 * t868 - t9 * t916;
        t1020 = cos_phi * t1013 - t1006 - sin_phi * t1017;
        t1022 = cos_psi * t1001 - sin_psi * t1020;
        t1025 = t1001 * sin_psi + cos_psi * t1020;
        t1030 = t77 * (t959 - t75 * t998 - t221 * t927);
        t1034 = t1030 + sin_phi * t1013 + cos_phi * t1017;
        t1037 = cos_psi * t1000 - sin_psi * t1006;
        t1040 = t1000 * sin_psi + cos_psi * t1006;
        t1041 = -t1030;
        [[t1022, t1025, t1034], [t1037, t1040, t1041]]
    }
}

#[allow(unused_variables)]
impl<T: Scalar> carvallo::motion::UncheckedPartials for WhippleMechanismMotion<T> {
    type State = [T; 11];

    type ByState = [[T; 11]; 11];

    type ByForces = [[T; 2]; 11];

    type Parameters = [T; 26];

    type ByParameters = [[T; 26]; 11];

    fn linearize_unchecked(
        &self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2],
    ) -> ([[T; 11]; 11], [[T; 2]; 11]) {
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
            t629, t634, t642, t649, t668, t673, t675, t678, t682, t690, t693, t697, t698, t702,
            t704, t705, t708, t711, t712, t713, t714, t716, t718, t722, t723, t726, t727, t729,
            t735, t737, t738, t741, t743, t745, t749, t751, t753, t763, t764, t772, t776, t778,
            t784, t790, t796, t798, t804, t807, t808, t809, t814, t815, t817, t818, t819,
        );
        zero = self.constants[0].like(0.0);
        (sin_phi, cos_phi) = positions[3].sin_cos();
        t6 = self.constants[7] * sin_phi;
        (sin_pitch, cos_pitch) = positions[4].sin_cos();
        t14 = self.constants[19] * sin_pitch + self.constants[20] * cos_pitch;
        (sin_delta, cos_delta) = positions[5].sin_cos();
        t18 = t14 * cos_phi;
        t21 = sin_phi * sin_delta;
        t22 = t21 - cos_delta * t18;
        t26 = self.constants[19] * cos_pitch - sin_pitch * self.constants[20];
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
        t42 = self.constants[10] * t41;
        t45 = sin_delta * self.constants[25];
        t51 = self.constants[23] + cos_delta * self.constants[25];
        t53 = t26 * self.constants[27] - t14 * t51;
        t56 = cos_phi * t45 - t37 * t42 - sin_phi * t53;
        t57 = t6 + t56;
        t58 = sin_delta * t34;
        t62 = t26 * t32 + t14 * t35;
        t64 = cos_phi * t58 + sin_phi * t62;
        t69 = t42 * t64 + t14 * self.constants[27] + t26 * t51;
        t71 = self.constants[0].like(1.0) / (cos_phi * t69);
        t72 = t57 * t71;
        t78 = t26 * self.constants[24] - t14 * self.constants[23];
        t80 = t56 + sin_phi * t78;
        t82 = sin_phi * t26;
        t85 = t14 * self.constants[24] + t26 * self.constants[23];
        t86 = t69 - t85;
        t89 = t71 * (t14 * t80 + t82 * t86);
        t91 = speeds[0] * t72 + speeds[1] * t89;
        t92 = speeds[2] + t91;
        t93 = self.constants[7] * t92;
        (sin_psi, cos_psi) = positions[2].sin_cos();
        t96 = t93 * sin_psi;
        t98 = self.constants[7] * cos_psi;
        t99 = t71 * t72;
        t100 = sin_phi * t69;
        t106 = sin_phi * t45 + cos_phi * t53;
        t107 = t14 * t72;
        t108 = sin_phi * self.constants[27];
        t110 = t26 * t72;
        t111 = sin_phi * t51;
        t113 = t37 * self.constants[10];
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
        t176 = self.constants[10] * t64;
        t180 = sin_phi * t32;
        t182 = sin_phi * t35;
        t185 = t117 + t125;
        t191 = cos_phi * t62 + t110 * t182 + t82 * t153 - sin_phi * t58 - t107 * t180
            - t162 * t185;
        t195 = self.constants[27] * t110 + t120 * t176 + t42 * t191 - t51 * t107;
        t199 = t99 * t100 + self.constants[7] * cos_phi * t71 + t71 * t171 - t173 * t195;
        t201 = t71 * t89;
        t203 = t26 * t86;
        t205 = t14 * t71;
        t211 = t71 * t82;
        t213 = sin_phi * self.constants[24];
        t216 = sin_phi * t71 * t86 + t205 * t213 - self.constants[23] * t211;
        t220 = sin_phi * self.constants[23];
        t223 = t71 * t80 - self.constants[24] * t211 - t205 * t220;
        t227 = t211 - cos_phi * t201;
        t231 = t100 * t201 + cos_phi * (t71 * t203 + t78 * t205) + t110 * t223
            + t171 * t205;
        t233 = t231 + t195 * t227 - t107 * t216;
        t235 = speeds[0] * t199 + speeds[1] * t233;
        t238 = t14 * self.constants[25];
        t240 = t14 * t89;
        t242 = t26 * t89;
        t245 = t117 * t242 - t22;
        t247 = sin_delta * t26;
        t260 = t39 * t138 + t40 * t138 - t143 * t240 - t145 * t242;
        t264 = t31 * t39 + t31 * t40 - t128 * t242 - t131 * t260;
        t268 = t157 * t240 + t159 * t260;
        t273 = t34 * t247 + t35 * t240 + t32 * t242 + t14 * t264 + t155 * t268;
        t279 = self.constants[25] * t114 + t108 * t240 + t111 * t242 + t42 * t273
            - t21 * t238 - t113 * t245;
        t286 = sin_phi * t14;
        t296 = t34 * t114 + t182 * t242 + t82 * t264 - t58 * t286 - t180 * t240
            - t185 * t268;
        t301 = self.constants[27] * t242 + t176 * t245 + t42 * t296
            - self.constants[25] * t247 - t51 * t240;
        t303 = t71 * t279 - t173 * t301;
        t311 = t223 * t242 + t205 * t279 + t227 * t301 - t216 * t240;
        t313 = speeds[0] * t303 + speeds[1] * t311;
        t318 = self.constants[7] * sin_psi;
        t325 = t37 * t69 + t57 * t64;
        t326 = self.constants[0].like(1.0) / t325;
        t327 = self.constants[7] * t64;
        t328 = t326 * t327;
        t329 = t326 * t328;
        t330 = speeds[2] * t329;
        t339 = cos_phi * t327 + t64 * t171 + t57 * t191 + t37 * t195 - t69 * t166;
        t341 = self.constants[7] * t326;
        t342 = speeds[2] * t341;
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
        t387 = t106 + t30 * self.constants[10] - cos_phi * t78;
        t390 = t26 * t387 + t27 * t78;
        t397 = cos_phi * t86 - t27 * self.constants[23];
        t403 = sin_phi * t387 + cos_phi * t80 + t27 * t213;
        t407 = cos_phi * self.constants[27] - cos_phi * self.constants[24];
        t410 = t371 * t397 + t373 * t403 + t379 * t407;
        t413 = t387 + t27 * self.constants[24];
        t415 = t27 * t220;
        t419 = cos_phi * self.constants[23] - cos_phi * t51;
        t422 = t379 * t419 - t371 * t413 - t373 * t415;
        t424 = self.constants[10] * t379;
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
        t488 = self.constants[25] * t39;
        t490 = t238 * t117;
        t506 = t379 * t488 + t379 * t490 + t242 * t422 + t260 * t424 + t279 * t431
            + t296 * t436;
        t511 = t506 + t301 * t438 + t440 * t481 + t311 * t363 - t240 * t410
            - t273 * t429;
        t512 = t511 - t448 * t472;
        t516 = t330 * t472 - (t296 * t342 + speeds[0] * t486 + speeds[1] * t512);
        t518 = self.constants[0].like(1.0) / self.constants[10];
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
        t594 = self.constants[10] * t573;
        t597 = t27 * t37;
        t600 = t27 * t64;
        t608 = cos_phi * (t37 * t390 + t45 * t573) + t110 * t592 + t149 * t594
            + t171 * t597;
        t612 = t608 + t447 * t537 + t461 * t523
            - sin_phi * (t37 * t374 + t376 * t573 - t64 * t203) - t107 * t586;
        t617 = t612 - t166 * t435 - t191 * t428 - t195 * t600 - t89 * t556 - t233 * t561;
        t620 = speeds[2] * t543 + t545 * t566 + t568 * t617;
        t629 = t57 * t273 + t69 * t296 + t64 * t301 - t37 * t279;
        t634 = t296 * t525 + t527 * t629 - t273 * t519 - t472 * t539;
        t642 = t273 * t351 + t100 * t296 + t301 * t345 - t279 * t353;
        t649 = t364 * t629 + t486 * t523 - t72 * t642 - t303 * t561;
        t668 = t488 * t573 + t490 * t573 + t242 * t592 + t260 * t594 + t279 * t597
            + t447 * t629;
        t673 = t668 + t512 * t523 - t240 * t586 - t273 * t435 - t296 * t428
            - t301 * t600;
        t675 = t673 - t89 * t642 - t311 * t561;
        t678 = speeds[2] * t634 + t545 * t649 + t568 * t675;
        t682 = t518 * (t364 * t523 - t72 * t561);
        t690 = t518 * (t37 * t435 + t447 * t523 - t64 * t428 - t89 * t561);
        t693 = t518 * (t528 + t328 * t523);
        t697 = sin_delta * self.constants[41];
        t698 = sin_delta * t697;
        t702 = self.constants[32] + self.constants[36] + self.constants[43] - t698;
        t704 = cos_delta * self.constants[34];
        t705 = self.constants[23] * t704;
        t708 = t705 + t705 + self.constants[46];
        t711 = self.constants[33] + self.constants[39];
        t712 = t708 + t711;
        t713 = t712 - t702;
        t714 = t14 * t14;
        t716 = t14 * t26;
        t718 = self.constants[24] * t704;
        t722 = cos_delta * self.constants[37];
        t723 = self.constants[30] + t722;
        t726 = t723 - self.constants[44] - t718 - self.constants[45];
        t727 = t726 + t726;
        t729 = t713 * t714 + t716 * t727;
        t735 = t704 + self.constants[42] + self.constants[28];
        t737 = t26 * self.constants[47] - t14 * t735;
        t738 = self.constants[7] * t737;
        t741 = self.constants[49] - t738 - t738;
        t743 = sin_delta * self.constants[34];
        t745 = sin_delta * self.constants[37] - self.constants[24] * t743;
        t749 = cos_delta * t697 - self.constants[23] * t743;
        t751 = t14 * t745 + t26 * t749;
        t753 = t72 - sin_phi * t364;
        t763 = t726 + t713 * t716
            + self.constants[7] * (t14 * self.constants[47] + t26 * t735) - t714 * t727;
        t764 = cos_phi * t364;
        t772 = t698 + self.constants[43] + t708 + t741 + self.constants[31]
            + self.constants[38];
        t776 = self.constants[7] * t743;
        t778 = t26 * t745 + t776 - t14 * t749;
        t784 = t712 - t729;
        t790 = t753 * self.constants[21];
        t796 = t682 + cos_delta * t753 - t247 - t115 * t764;
        t798 = t796 * self.constants[22];
        t804 = t702 + t729 + t741 + t751 * t753
            + t753 * (t751 + t753 * t772 - t764 * t778) + t753 * t790;
        t807 = t804 + t796 * t798 - t763 * t764
            - t764 * (t763 + t753 * t778 - t764 * t784);
        t808 = self.constants[0].like(1.0) / t807;
        t809 = speeds[0] * t26;
        t814 = speeds[0] * t364 + speeds[1] * t447 + speeds[2] * t328;
        t815 = cos_phi * t814;
        t817 = t809 + t14 * t815;
        t818 = sin_phi * t814;
        t819 = t91 - t818;
        let (
            t823, t827, t828, t829, t830, t832, t835, t838, t844, t845, t847, t850, t851, t852,
            t854, t855, t856, t858, t859, t862, t863, t865, t866, t867, t869, t871, t873, t874,
            t877, t881, t884, t885, t886, t888, t889, t892, t893, t894, t897, t899, t903, t906,
            t908, t911, t912, t913, t915, t917, t919, t921, t923, t925, t928, t930, t931, t933,
            t939, t943, t948, t949, t950, t954, t956, t963, t969, t971, t975, t989, t993, t995,
            t1000, t1004, t1006, t1008, t1011, t1017, t1020, t1021, t1024, t1027, t1028, t1029,
            t1031, t1033, t1038, t1043, t1047, t1053, t1055, t1057, t1058, t1059, t1061, t1063,
            t1068, t1071, t1074, t1076, t1082, t1088, t1090, t1093, t1097, t1099, t1102, t1105,
            t1109, t1111, t1113, t1123, t1125, t1128, t1132, t1139, t1140, t1146, t1148, t1154,
            t1161, t1166, t1172, t1174, t1179, t1180, t1181, t1184, t1193, t1198, t1200, t1205,
            t1208, t1212, t1219, t1220, t1222, t1224, t1228, t1230, t1232, t1233, t1234, t1238,
            t1242, t1246, t1252, t1258, t1262, t1267, t1269, t1271, t1277, t1279, t1280, t1290,
            t1294, t1295, t1297, t1300, t1305, t1309, t1314, t1326, t1327, t1333, t1336, t1346,
            t1364, t1368, t1369, t1371, t1375, t1379, t1387, t1389, t1392, t1397, t1403, t1410,
            t1412, t1414, t1416, t1418, t1420, t1424, t1425, t1427, t1431, t1435, t1436, t1439,
            t1446, t1448, t1455, t1457, t1467, t1472, t1474, t1484, t1488, t1490, t1496, t1498,
            t1499, t1507, t1510, t1515, t1521, t1527, t1535, t1538, t1539, t1546, t1548, t1550,
            t1552, t1554, t1558, t1560, t1561, t1563, t1564, t1567, t1568, t1570, t1573, t1575,
            t1577, t1579, t1580, t1582, t1584, t1585, t1588, t1590, t1596, t1601, t1603, t1605,
            t1607, t1611, t1614, t1615, t1617, t1621, t1622, t1624, t1625, t1631, t1632, t1633,
        );
        t823 = self.constants[31] * t819 + self.constants[21] * (speeds[2] + t819);
        t827 = speeds[0] * t14;
        t828 = t827 - t26 * t815;
        t829 = self.constants[30] * t828;
        t830 = self.constants[32] * t817 + t829;
        t832 = t817 * t823 - t819 * t830;
        t835 = cos_delta * t817 + sin_delta * t819;
        t838 = cos_delta * t819 - sin_delta * t817;
        t844 = speeds[0] * t682 + speeds[1] * t690 + speeds[2] * t693;
        t845 = t838 + t844;
        t847 = self.constants[38] * t838 + self.constants[22] * t845;
        t850 = speeds[1] + t828;
        t851 = self.constants[37] * t850;
        t852 = self.constants[36] * t835 + t851;
        t854 = t835 * t847 - t838 * t852;
        t855 = self.constants[7] * t818;
        t856 = t815 * t855;
        t858 = sin_phi * self.constants[40];
        t859 = t92 * t815;
        t862 = t856 - self.constants[7] * t859;
        t863 = t858 + t862;
        t865 = t91 * t828;
        t866 = speeds[0] * t818;
        t867 = self.constants[24] * t819;
        t869 = self.constants[23] * t819;
        t871 = t828 * t867 + t817 * t869;
        t873 = t91 * t817;
        t874 = t26 * t866 + t873;
        t877 = t865 + t14 * t866;
        t881 = t871 + self.constants[23] * t874 + self.constants[24] * t877 - t862;
        t884 = self.constants[23] * t828;
        t885 = self.constants[24] * t817;
        t886 = t884 - t885;
        t888 = t819 * t869 + t828 * t886;
        t889 = speeds[0] * t815;
        t892 = self.constants[7] * speeds[0];
        t893 = t815 * t892;
        t894 = self.constants[7] * t889 + t893;
        t897 = t92 - t818;
        t899 = t855 * t897 - speeds[0] * t892;
        t903 = t26 * t894 + t14 * t899 - t888 - self.constants[24] * t889;
        t906 = t838 * self.constants[26];
        t908 = self.constants[25] * t838;
        t911 = cos_delta * t877;
        t912 = sin_delta * t889;
        t913 = speeds[1] * t838;
        t915 = t913 - t911 - t912;
        t917 = t32 * self.constants[10];
        t919 = t874 + t835 * t844;
        t921 = t34 * self.constants[10];
        t923 = t915 - t844 * t850;
        t925 = t31 * t41;
        t928 = t32 * t835 + t34 * t850;
        t930 = self.constants[10] * t925 * t928;
        t931 = t34 * t930;
        t933 = t32 * t930;
        t939 = cos_delta * t881 + t850 * t906 + t835 * t908 + self.constants[25] * t874
            + t917 * t919 + t850 * t931;
        t943 = t939 + t835 * t933 - sin_delta * t903 - self.constants[26] * t915
            - t921 * t923;
        t948 = self.constants[25] * t850;
        t949 = t835 * self.constants[26];
        t950 = t948 - t949;
        t954 = speeds[1] * t835;
        t956 = sin_delta * t877 - cos_delta * t889 - t954;
        t963 = self.constants[10] * (t32 * t850 - t34 * t835);
        t969 = cos_delta * t903 + sin_delta * t881 + self.constants[26] * t956
            + t921 * t956 - t838 * t908 - t850 * t950;
        t971 = t969 - t845 * t933 - t850 * t963;
        t975 = t817 * t886 - t819 * t867;
        t989 = t975 + self.constants[23] * t889 + t14 * t894 + t835 * t950 + t835 * t963
            - t26 * t899;
        t993 = t989 - t838 * t906 - self.constants[25] * t956 - t917 * t956
            - t845 * t931;
        t995 = t32 * t971 + t34 * t993;
        t1000 = t71 * (t41 * t943 + t30 * t995);
        t1004 = t326 * (t30 * t943 + t362 * t1000 - t41 * t995);
        t1006 = t866 - cos_phi * t1004;
        t1008 = t865 + t14 * t1006;
        t1011 = t873 + t26 * t1006;
        t1017 = t871 + self.constants[23] * t1011 + self.constants[24] * t1008 - t863;
        t1020 = t889 - t1000;
        t1021 = sin_phi * t1004 + t1020;
        t1024 = self.constants[7] * t1021 + t893;
        t1027 = t899 + cos_phi * self.constants[40];
        t1028 = t14 * t1027;
        t1029 = t1028 + t26 * t1024;
        t1031 = t1029 - self.constants[24] * t1021 - t888;
        t1033 = cos_delta * t1017 - sin_delta * t1031;
        t1038 = t913 - sin_delta * t1021 - cos_delta * t1008;
        t1043 = t854 + self.constants[34] * t1033 + self.constants[37] * t1038
            + self.constants[39] * t1011;
        t1047 = cos_delta * t1031 + sin_delta * t1017;
        t1053 = sin_delta * t1008 - cos_delta * t1021 - t954;
        t1055 = self.constants[34] * t838;
        t1057 = self.constants[34] * t850;
        t1058 = t835 * self.constants[35];
        t1059 = t1057 - t1058;
        t1061 = t838 * t1055 + t850 * t1059;
        t1063 = self.constants[17] * t1047 + self.constants[35] * t1053 - t1061;
        t1068 = t838 * self.constants[35];
        t1071 = t850 * t1068 + t835 * t1055;
        t1074 = t1033 * self.constants[17] + self.constants[34] * t1011 + t1071
            - t1038 * self.constants[35];
        t1076 = sin_delta * t1063 + cos_delta * t1074;
        t1082 = t832 + self.constants[33] * t1011 + t1043 + self.constants[23] * t1076
            - self.constants[28] * t863 - self.constants[30] * t1008;
        t1088 = self.constants[30] * t817;
        t1090 = t1088 + self.constants[33] * t828;
        t1093 = t819 * t1090 - t823 * t828;
        t1097 = self.constants[37] * t835;
        t1099 = t1097 + self.constants[39] * t850;
        t1102 = t838 * t1099 - t847 * t850;
        t1105 = self.constants[36] * t1038 + self.constants[37] * t1011 + t1102
            - t1033 * self.constants[35];
        t1109 = t26 * t1027;
        t1111 = t1109 - t14 * t1024;
        t1113 = t975 + self.constants[23] * t1021 - t1111;
        t1123 = t518 * (t32 * t993 + t523 * t1004 - t34 * t971 - t561 * t1000);
        t1125 = self.constants[22] * (t1053 + t1123);
        t1128 = t850 * t852 - t835 * t1099;
        t1132 = t1047 * self.constants[35] + self.constants[38] * t1053 + t1125 + t1128
            - self.constants[34] * t1113;
        t1139 = t863 * self.constants[29] + self.constants[30] * t1011 + t1093
            + cos_delta * t1105 - self.constants[32] * t1008 - sin_delta * t1132;
        t1140 = t1139 - self.constants[24] * t1076;
        t1146 = t819 * self.constants[29];
        t1148 = self.constants[28] * t819;
        t1154 = t1076 + self.constants[28] * t1011 + t1008 * self.constants[29]
            + t828 * t1146 + t817 * t1148 - t863 * self.constants[1];
        t1161 = t828 * t830 - t817 * t1090;
        t1166 = cos_delta * t1063 - sin_delta * t1074;
        t1172 = t835 * t1059 - t838 * t1068;
        t1174 = self.constants[17] * t1113 + t1172 - self.constants[34] * t1053;
        t1179 = self.constants[28] * t828;
        t1180 = t817 * self.constants[29];
        t1181 = t1179 - t1180;
        t1184 = t817 * t1181 - t819 * t1146;
        t1193 = t819 * t1148 + t828 * t1181;
        t1198 = t14
            * (t1174 + t1184 - t1111 * self.constants[1] + self.constants[28] * t1021)
            + t26
                * (t1166 + t1029 * self.constants[1] - t1021 * self.constants[29]
                    - t1193);
        t1200 = self.constants[21] * t1021 + self.constants[7] * t1198;
        t1205 = t1029 * self.constants[29] + self.constants[28] * t1111
            - self.constants[31] * t1021 + t1161 + sin_delta * t1105 + cos_delta * t1132;
        t1208 = t1205 + self.constants[24] * t1166 - t1200 - self.constants[23] * t1174;
        t1212 = t26 * t1082 - t14 * t1140;
        t1219 = forces[0] + t764 * t1212 - t14 * t1082 - t26 * t1140
            - self.constants[7] * t1154 - t753 * t1208;
        t1220 = t1219 - t682 * t1125;
        t1222 = t705 + self.constants[39];
        t1224 = t722 - t718;
        t1228 = t89 - sin_phi * t447;
        t1230 = cos_phi * t447;
        t1232 = t26 * t743;
        t1233 = self.constants[7] * t1232;
        t1234 = t745 + t1233;
        t1238 = t1234 + t772 * t1228 - t778 * t1230;
        t1242 = t26 * t1222 - t14 * t1224;
        t1246 = t1242 + t778 * t1228 - t784 * t1230;
        t1252 = t690 + cos_delta * t1228 - t115 * t1230;
        t1258 = t14 * t1222 + t26 * t1224 + self.constants[7] * t704 + t751 * t1228
            + t753 * t1238 + t790 * t1228;
        t1262 = t808 * (t1258 + t798 * t1252 - t763 * t1230 - t764 * t1246);
        t1267 = self.constants[21] * t1228;
        t1269 = self.constants[22] * t1252;
        t1271 = t807 * t1262;
        t1277 = self.constants[39] + t1228 * t1238 + t1228 * t1234 + t1228 * t1267
            + t1252 * t1269 - t1230 * t1246;
        t1279 = t1277 - t1230 * t1242 - t1262 * t1271;
        t1280 = self.constants[0].like(1.0) / t1279;
        t1290 = forces[1] + t1212 * t1230 - t1043 - t1208 * t1228 - t690 * t1125
            - t1220 * t1262;
        t1294 = self.constants[7] * (t737 - self.constants[48]);
        t1295 = sin_phi * t328;
        t1297 = cos_phi * t328;
        t1300 = t1294 + t772 * t1295 + t778 * t1297;
        t1305 = t776 - t778 * t1295 - t784 * t1297;
        t1309 = self.constants[0].like(1.0) - t1295;
        t1314 = t693 - cos_delta * t1295 - t115 * t1297;
        t1326 = t790 * t1309 + t798 * t1314 - t751 * t1295 - t763 * t1297 - t753 * t1300
            - t764 * t1305;
        t1327 = t808 * t1326;
        t1333 = t1233 + t1267 * t1309 + t1269 * t1314 - t1228 * t1300 - t1230 * t1305
            - t1234 * t1295;
        t1336 = t1280 * (t1333 - t1242 * t1297 - t1271 * t1327);
        t1346 = t1208 * t1295 + t1212 * t1297 + t1200 - t693 * t1125 - t1220 * t1327
            - t1290 * t1336;
        t1364 = t1295 * t1300 + t1294 * t1295 + self.constants[50]
            + self.constants[21] * t1309 * t1309 + self.constants[22] * t1314 * t1314
            - t1297 * t1305;
        t1368 = self.constants[0].like(1.0)
            / (t1364 - t776 * t1297 - t807 * t1327 * t1327 - t1279 * t1336 * t1336);
        t1369 = t1346 * t1368;
        t1371 = t1280 * t1290 - t1336 * t1369;
        t1375 = t808 * t1220 - t1262 * t1371 - t1327 * t1369;
        t1379 = t856 + t858 - self.constants[7] * (t859 + t1375);
        t1387 = t1004 + t364 * t1375 + t447 * t1371 + t328 * t1369;
        t1389 = t866 - cos_phi * t1387;
        t1392 = t26 * t1375 - t865 - t14 * t1389;
        t1397 = t873 + t26 * t1389 + t14 * t1375;
        t1403 = t871 + self.constants[23] * t1397 - t1379 - self.constants[24] * t1392;
        t1410 = t72 * t1375 + t89 * t1371 - sin_phi * t1387 - t1020;
        t1412 = t1369 + t1410;
        t1414 = self.constants[7] * t1412 - t893;
        t1416 = t1028 - t26 * t1414;
        t1418 = self.constants[24] * t1410 + t1416 - t888;
        t1420 = cos_delta * t1403 - sin_delta * t1418;
        t1424 = cos_delta * t1392 + sin_delta * t1410;
        t1425 = t913 + t1424;
        t1427 = t1371 + t1397;
        t1431 = cos_delta * t1418 + sin_delta * t1403;
        t1435 = cos_delta * t1410 - sin_delta * t1392;
        t1436 = t1435 - t954;
        t1439 = self.constants[17] * t1431 + self.constants[35] * t1436 - t1061;
        t1446 = t1071 + self.constants[17] * t1420 + self.constants[34] * t1427
            - self.constants[35] * t1425;
        t1448 = sin_delta * t1439 + cos_delta * t1446;
        t1455 = t832 + t854 + self.constants[30] * t1392 + self.constants[33] * t1397
            + self.constants[34] * t1420 + self.constants[37] * t1425
            + self.constants[39] * t1427;
        t1457 = t1455 + self.constants[23] * t1448 - self.constants[28] * t1379;
        t1467 = t1102 + self.constants[36] * t1425 + self.constants[37] * t1427
            - self.constants[35] * t1420;
        t1472 = t1109 + t14 * t1414;
        t1474 = t975 - self.constants[23] * t1410 - t1472;
        t1484 = self.constants[22]
            * (t1123 + t1436 + t682 * t1375 + t690 * t1371 + t693 * t1369);
        t1488 = t1128 + self.constants[35] * t1431 + self.constants[38] * t1436 + t1484
            - self.constants[34] * t1474;
        t1490 = cos_delta * t1467 - sin_delta * t1488;
        t1496 = t1093 + self.constants[29] * t1379 + self.constants[32] * t1392
            + self.constants[30] * t1397 + t1490 - self.constants[24] * t1448;
        t1498 = t26 * t1457 - t14 * t1496;
        t1499 = sin_phi * t1498;
        t1507 = sin_delta * t1467 + cos_delta * t1488;
        t1510 = cos_delta * t1439 - sin_delta * t1446;
        t1515 = t1172 + self.constants[17] * t1474 - self.constants[34] * t1436;
        t1521 = t1184 + t1515 - self.constants[1] * t1472 - self.constants[28] * t1410;
        t1527 = t1510 + self.constants[1] * t1416 + self.constants[29] * t1410 - t1193;
        t1535 = t1161 + self.constants[29] * t1416 + self.constants[28] * t1472
            + self.constants[31] * t1410 + self.constants[21] * t1412 + t1507;
        t1538 = t1535 + self.constants[24] * t1510 - self.constants[23] * t1515
            - self.constants[7] * (t14 * t1521 + t26 * t1527);
        t1539 = cos_phi * t1538;
        t1546 = sin_phi * t1538 + cos_phi * t1498;
        t1548 = t518 * t1484;
        t1550 = self.constants[7] * t1527;
        t1552 = self.constants[7] * t1521;
        t1554 = t107 * t1550 - t110 * t1552;
        t1558 = t107 * t1457 + t110 * t1496;
        t1560 = t326 * t995;
        t1561 = t524 * t1560;
        t1563 = t326 * t943;
        t1564 = t524 * t1563;
        t1567 = t41 * t326;
        t1568 = t971 * t1567;
        t1570 = t518 * t993 - t524 * t1568;
        t1573 = t993 * t1567;
        t1575 = t518 * t971 + t524 * t1573;
        t1577 = t518 * t1000;
        t1579 = t326 * t1000;
        t1580 = t524 * t1579;
        t1582 = t518 * t1004;
        t1584 = t326 * t1004;
        t1585 = t524 * t1584;
        t1588 = t518 * t1375;
        t1590 = t518 * t1371;
        t1596 = t149 * t1564 + t153 * t1570 + t162 * t1575 + t358 * t1580 + t537 * t1582
            + t543 * t1369;
        t1601 = t1596 + t566 * t1588 + t617 * t1590 - t120 * t1561 - t556 * t1577
            - t339 * t1585;
        t1603 = sin_delta * self.constants[22];
        t1605 = cos_delta * self.constants[22];
        t1607 = t14 * t1603;
        t1611 = t26 * t1603 + t764 * t1607 - t682 * self.constants[22] - t753 * t1605;
        t1614 = t892 + t892;
        t1615 = t26 * t1614;
        t1617 = self.constants[7] * t1387;
        t1621 = self.constants[7] * t1375;
        t1622 = t26 * t1621;
        t1624 = self.constants[7] * t1371;
        t1625 = t26 * t1624;
        t1631 = t27 * t1617 + t107 * t1414 + t110 * t1027 - t286 * self.constants[40]
            - t818 * t1615 - t199 * t1622;
        t1632 = t1631 - t233 * t1625;
        t1633 = self.constants[7] * t26;
        let (
            t1634, t1635, t1637, t1638, t1640, t1641, t1642, t1644, t1645, t1649, t1653, t1658,
            t1659, t1660, t1663, t1669, t1674, t1679, t1680, t1683, t1688, t1690, t1696, t1697,
            t1698, t1701, t1702, t1704, t1707, t1709, t1710, t1711, t1715, t1721, t1723, t1725,
            t1727, t1728, t1732, t1736, t1742, t1746, t1754, t1759, t1760, t1766, t1773, t1774,
            t1779, t1780, t1781, t1783, t1788, t1792, t1794, t1797, t1802, t1807, t1811, t1816,
            t1819, t1823, t1826, t1832, t1837, t1843, t1846, t1851, t1857, t1866, t1867, t1873,
            t1877, t1885, t1888, t1889, t1891, t1899, t1901, t1903, t1905, t1907, t1908, t1910,
            t1912, t1918, t1921, t1929, t1932, t1934, t1935, t1938, t1942, t1943, t1945, t1947,
            t1949, t1954, t1956, t1958, t1961, t1964, t1966, t1967, t1970, t1972, t1974, t1977,
            t1980, t1981, t1987, t1990, t1992, t1996, t2000, t2004, t2007, t2008, t2009, t2012,
            t2015, t2019, t2025, t2027, t2029, t2031, t2034, t2040, t2041, t2043, t2045, t2048,
            t2051, t2053, t2055, t2057, t2059, t2063, t2064, t2068, t2069, t2070, t2073, t2076,
            t2077, t2086, t2089, t2090, t2094, t2097, t2100, t2102, t2103, t2107, t2110, t2111,
            t2114, t2120, t2123, t2127, t2131, t2133, t2134, t2135, t2137, t2142, t2146, t2149,
            t2151, t2154, t2156, t2157, t2159, t2160, t2161, t2163, t2165, t2168, t2173, t2175,
            t2179, t2185, t2188, t2189, t2191, t2194, t2195, t2197, t2198, t2204, t2207, t2210,
            t2212, t2216, t2218, t2222, t2225, t2230, t2232, t2238, t2244, t2249, t2252, t2255,
            t2258, t2260, t2266, t2270, t2276, t2280, t2282, t2284, t2288, t2291, t2293, t2294,
            t2295, t2297, t2303, t2306, t2313, t2317, t2326, t2329, t2333, t2341, t2346, t2348,
            t2350, t2354, t2356, t2360, t2361, t2364, t2366, t2370, t2373, t2378, t2380, t2383,
            t2390, t2393, t2400, t2406, t2407, t2409, t2412, t2416, t2417, t2421,
        );
        t1634 = self.constants[1] * t1633;
        t1635 = self.constants[29] - t1634;
        t1637 = cos_delta * self.constants[35];
        t1638 = sin_delta * t1637;
        t1640 = cos_delta * self.constants[17];
        t1641 = sin_delta * t1640;
        t1642 = t78 - self.constants[7];
        t1644 = cos_delta * t1640;
        t1645 = t1633 * t1644;
        t1649 = self.constants[24] * t1644 + cos_delta * t1637 - t1645;
        t1653 = t14 * t1638 + t85 * t1641;
        t1658 = sin_delta * self.constants[35];
        t1659 = sin_delta * self.constants[17];
        t1660 = t1633 * t1659;
        t1663 = t1660 - t1658 - self.constants[24] * t1659;
        t1669 = t26 * self.constants[34] + t14 * t1637 + t85 * t1640;
        t1674 = t26 * t1637 + t1640 * t1642 + t764 * t1669 - t14 * self.constants[34]
            - t753 * t1663;
        t1679 = t26 * t1638 + t1641 * t1642 + t764 * t1653 - t753 * t1649
            - sin_delta * t1674;
        t1680 = t1679 - t753 * t1635;
        t1683 = t14 * t1614;
        t1688 = t14 * t1621;
        t1690 = t14 * t1624;
        t1696 = t818 * t1683 + t110 * t1414 + t199 * t1688 + t233 * t1690
            - t82 * self.constants[40] - t18 * t1617;
        t1697 = t1696 - t107 * t1027;
        t1698 = self.constants[7] * t14;
        t1701 = self.constants[1] * t1698 + self.constants[17] * t1698;
        t1702 = t735 + t1701;
        t1704 = t14 * t743;
        t1707 = t1232 + t764 * t1704 - t753 * t1702;
        t1709 = t93 - t855;
        t1710 = t818 * t1709;
        t1711 = self.constants[7] * t815;
        t1715 = t1710 + cos_phi * (self.constants[40] + t814 * t1711);
        t1721 = t26 * self.constants[28] + t14 * self.constants[29];
        t1723 = sin_delta * t1658;
        t1725 = sin_delta * t1659;
        t1727 = cos_delta * t1659;
        t1728 = t1633 * t1727;
        t1732 = self.constants[24] * t1727 + cos_delta * t1658 - t1728;
        t1736 = t14 * t1723 + t85 * t1725;
        t1742 = t26 * t1723 + t1642 * t1725 + t764 * t1736 + cos_delta * t1674
            - t753 * t1732;
        t1746 = self.constants[7] * self.constants[1] + t14 * self.constants[28]
            - t26 * self.constants[29] - t764 * t1721 - t1742;
        t1754 = t82 * t1387 + t809 * t815 + t110 * t1375 - t107 * t1389;
        t1759 = t743 * t1633;
        t1760 = t745 + t1759;
        t1766 = t26 * t711 + t85 * t704 - t14 * t723;
        t1773 = t704 * t1642 + t764 * t1766 + self.constants[23] * t1742
            - self.constants[7] * self.constants[28] - t14 * t711 - t26 * t723;
        t1774 = t1773 - t753 * t1760;
        t1779 = t1389 + t199 * t1375 + t233 * t1371;
        t1780 = self.constants[23] * self.constants[34];
        t1781 = sin_delta * t1780;
        t1783 = self.constants[31] + self.constants[21];
        t1788 = self.constants[29] * t1633 - self.constants[28] * t1698
            - self.constants[42] * t1698;
        t1792 = self.constants[46] + t1783 + cos_delta * t1780 - t1788;
        t1794 = t14 * t1781;
        t1797 = sin_delta * self.constants[38];
        t1802 = t1633 * t1637 - self.constants[34] * t1698;
        t1807 = t1780 + self.constants[24] * t1637 + cos_delta * self.constants[38]
            - t1802;
        t1811 = t14 * t1797 + t85 * t1658;
        t1816 = t1611 + t26 * t1797 + t1642 * t1658 + t764 * t1811 - t753 * t1807;
        t1819 = cos_delta * self.constants[36];
        t1823 = t1633 * t1658;
        t1826 = sin_delta * self.constants[36] + self.constants[24] * t1658 - t1823;
        t1832 = t26 * self.constants[37] - t14 * t1819 - t85 * t1637;
        t1837 = t764 * t1832 - t14 * self.constants[37] - t26 * t1819 - t1637 * t1642
            - t753 * t1826;
        t1843 = t26 * t1781 + t764 * t1794 + self.constants[24] * t1679
            + cos_delta * t1816 + sin_delta * t1837 - t753 * t1792;
        t1846 = t815 * t827;
        t1851 = t286 * t1387 + t1846 + t107 * t1375 + t110 * t1389;
        t1857 = t26 * self.constants[30] - t14 * self.constants[32];
        t1866 = self.constants[7] * self.constants[29] + t764 * t1857 + cos_delta * t1837
            - t14 * self.constants[30] - t26 * self.constants[32]
            - self.constants[24] * t1742;
        t1867 = t1866 - sin_delta * t1816;
        t1873 = t341 * t1369;
        t1877 = t1584 + t329 * t1369;
        t1885 = t149 * t1563 + t162 * t1573 + t191 * t1873 + t358 * t1579 + t369 * t1375
            + t461 * t1371;
        t1888 = t1885 - t120 * t1560 - t153 * t1568 - t339 * t1877;
        t1889 = t6 * t26;
        t1891 = t6 * t14;
        t1899 = t1680 * t1889 + t18 * t1867 - t1707 * t1891 - t27 * t1774
            - sin_phi * t1843;
        t1901 = t71 * t1000;
        t1903 = t71 * t943;
        t1905 = t71 * t995;
        t1907 = t30 * t71;
        t1908 = t971 * t1907;
        t1910 = t993 * t1907;
        t1912 = cos_phi * t1901;
        t1918 = t100 * t1901 + t120 * t1903 + t149 * t1905 + t153 * t1908 - t162 * t1910
            - t195 * t1912;
        t1921 = t363 * t524 - t518 * t561;
        t1929 = t1843 + t1611 * t1921 + t1698 * t1707 + t363 * t1899 - t1633 * t1680;
        t1932 = self.constants[23] + t1698;
        t1934 = self.constants[25] + t917;
        t1935 = speeds[0] * cos_delta;
        t1938 = t14 * t892 + speeds[0] * t1932 + t1934 * t1935;
        t1942 = self.constants[10] * t956;
        t1943 = self.constants[10] * t835;
        t1945 = t850 * t1943 - t1942;
        t1947 = t845 * t930;
        t1949 = t1947 + t835 * t1943;
        t1954 = t107 * t899 + t110 * t894 + t153 * t1945 + t162 * t1949 - t818 * t1938;
        t1956 = t34 * t1567;
        t1958 = t32 * t518 - t524 * t1956;
        t1961 = t34 * t1907;
        t1964 = t1611 * t1958 + t1929 * t1961 - t1899 * t1956;
        t1966 = self.constants[26] + t921;
        t1967 = sin_delta * t1966;
        t1970 = t1633 - self.constants[24];
        t1972 = t26 * t892 + speeds[0] * t1970;
        t1974 = speeds[0] * t1967 - sin_delta * t1972;
        t1977 = t809 * t1934;
        t1980 = self.constants[23] * t809 - t1711;
        t1981 = t814 * t1980;
        t1987 = self.constants[23] * t866;
        t1990 = t866 * t1934 + cos_delta * t1987 - sin_delta * t894;
        t1992 = sin_delta * t899;
        t1996 = self.constants[10] * t919 + t835 * t930;
        t2000 = t850 * t930 - self.constants[10] * t923;
        t2004 = cos_phi * (t814 * t1977 + cos_delta * t1981) + t153 * t1996
            - t818 * t1974 - cos_delta * t1710;
        t2007 = t2004 - t107 * t1990 - t110 * t1992 - t162 * t2000;
        t2008 = t30 * t326;
        t2009 = t524 * t2008;
        t2012 = t41 * t71;
        t2015 = t1611 * t2009 + t1899 * t2008 + t1929 * t2012;
        t2019 = cos_delta * t1972 - t1935 * t1966;
        t2025 = cos_delta * t894 + sin_delta * t1987;
        t2027 = cos_delta * t899;
        t2029 = self.constants[10] * t850;
        t2031 = t1947 + t850 * t2029;
        t2034 = t1942 + t835 * t2029;
        t2040 = t117 * t1981 + t110 * t2027 - t818 * t2019 - sin_delta * t1710
            - t107 * t2025 - t153 * t2031;
        t2041 = t2040 - t162 * t2034;
        t2043 = t32 * t1567;
        t2045 = t34 * t518 + t524 * t2043;
        t2048 = t32 * t1907;
        t2051 = t1929 * t2048 - t1611 * t2045 - t1899 * t2043;
        t2053 = t31 * t928;
        t2055 = t925 * t2053;
        t2057 = t835 * t925;
        t2059 = t850 * t925;
        t2063 = t120 * t2053 + t153 * t2057 - t149 * t2055 - t162 * t2059;
        t2064 = t845 * t921;
        t2068 = t850 * t921 + t835 * t917;
        t2069 = t2015 * t2068;
        t2070 = t845 * t917;
        t2073 = t2069 - t1964 * t2064 - t2051 * t2070;
        t2076 = self.constants[7] * t897 - t855;
        t2077 = t815 * t2076;
        t2086 = t14 * t1680 + t26 * t1707 + t124 * t2051 - t26 * t1964 - t115 * t2015;
        t2089 = t1846 + t110 * t866;
        t2090 = sin_delta * t1934;
        t2094 = cos_delta * t1966 + cos_delta * self.constants[24];
        t2097 = t1967 + sin_delta * self.constants[24];
        t2100 = t2015 * t2094 + t2051 * t2097 - t1964 * t2090;
        t2102 = t828 * self.constants[29];
        t2103 = self.constants[28] * t817;
        t2107 = t817 * t1783 - t830;
        t2110 = t867 + t867;
        t2111 = self.constants[34] * t2110;
        t2114 = t1090 - t828 * t1783 - sin_delta * t2111;
        t2120 = self.constants[17] * t2110;
        t2123 = t1633 * (t1148 + t1148) + t1698 * (t1146 + t1146) + t1698 * t2120;
        t2127 = t2123 + self.constants[23] * t2120 + cos_delta * t2111;
        t2131 = t26 * t2107 - t14 * t2114;
        t2133 = self.constants[24] * t828;
        t2134 = self.constants[23] * t817;
        t2135 = t2133 + t2134;
        t2137 = t869 + t869;
        t2142 = sin_delta * t2137 + cos_delta * t2135;
        t2146 = sin_delta * t2135 - cos_delta * t2137;
        t2149 = self.constants[22] * t835;
        t2151 = self.constants[38] * t835 + t2149 - t852;
        t2154 = self.constants[22] * t850;
        t2156 = t1099 - self.constants[38] * t850 - t2154;
        t2157 = cos_delta * t2156;
        t2159 = t850 * self.constants[35];
        t2160 = self.constants[34] * t835;
        t2161 = t2159 + t2160;
        t2163 = t1055 + t1055;
        t2165 = cos_delta * t2161 - sin_delta * t2163;
        t2168 = t1068 + t1068;
        t2173 = sin_delta * t2161 + cos_delta * t2163;
        t2175 = t1698 * t2168 + t1633 * t2173;
        t2179 = sin_delta * t2156 + self.constants[23] * t2168 + t2175
            - self.constants[24] * t2173;
        t2185 = t26 * t2151 + t85 * t2165 - t14 * t2157;
        t2188 = t906 + t931;
        t2189 = t906 + t2188;
        t2191 = self.constants[25] * t835;
        t2194 = t850 * self.constants[26] - speeds[1] * t1966;
        t2195 = t2191 + t2194;
        t2197 = t908 + t933;
        t2198 = t908 + t2197;
        t2204 = t1642 * t2165 + t764 * t2185 + speeds[1] * t1837 + t2015 * t2195
            - t14 * t2151 - t26 * t2157;
        t2207 = t2204 - t753 * t2179 - t1964 * t2189 - t2051 * t2198;
        t2210 = t847 - self.constants[36] * t838;
        t2212 = self.constants[37] * t838;
        t2216 = self.constants[36] * t850 - t1097 - t1099;
        t2218 = cos_delta * t2212 - sin_delta * t2216;
        t2222 = cos_delta * t1055 + sin_delta * t2159;
        t2225 = t1059 - t1058;
        t2230 = cos_delta * t2159 - sin_delta * t1055;
        t2232 = t1698 * t2225 + t1633 * t2230;
        t2238 = sin_delta * t2212 + self.constants[24] * t2230 + cos_delta * t2216
            - self.constants[23] * t2225 - t2232;
        t2244 = t26 * t2210 + t85 * t2222 - t14 * t2218;
        t2249 = t950 + t963;
        t2252 = speeds[1] * t1934 + t2249 - t949 - t34 * t1943;
        t2255 = t2197 + t844 * t917;
        t2258 = t2194 + t34 * t2029;
        t2260 = t32 * t925;
        t2266 = t1642 * t2222 + t764 * t2244 + t1964 * t2252 + t2015 * t2255
            + t2051 * t2258 + t2073 * t2260;
        t2270 = t2266 - t14 * t2210 - t26 * t2218 - t753 * t2238 - speeds[1] * t1816;
        t2276 = t764 * t2131 + t1742 * t2135 + t2015 * t2142 + t2051 * t2146
            + cos_delta * t2207 + sin_delta * t2270;
        t2280 = t2276 - self.constants[7] * (t2102 + t2103) - t14 * t2107 - t26 * t2114
            - t753 * t2127;
        t2282 = t2280 - t1679 * t2137 - t1964 * t2110;
        t2284 = t14 * t818;
        t2288 = t110 * t815 - t2284 - speeds[0] * t107;
        t2291 = t823 - self.constants[32] * t819;
        t2293 = self.constants[30] * t819;
        t2294 = t886 - t885;
        t2295 = self.constants[34] * t2294;
        t2297 = t2293 + sin_delta * t2295;
        t2303 = self.constants[17] * t2294;
        t2306 = t1633 * t2102 + t1698 * (t1181 - t1180) + t1698 * t2303;
        t2313 = self.constants[32] * t828 - t1088 - t1090 - t2306
            - self.constants[23] * t2303 - cos_delta * t2295;
        t2317 = t26 * t2291 - t14 * t2297;
        t2326 = t869 + self.constants[23] * t91;
        t2329 = t91 * t1934 + cos_delta * t2326 - sin_delta * t2133;
        t2333 = cos_delta * t2133 + sin_delta * t2326;
        t2341 = t764 * t2317 + t869 * t1742 + t1679 * t2133 + t91 * t1774 + t1964 * t2294
            + t2015 * t2329;
        t2346 = t2341 + t2051 * t2333 + cos_delta * t2270 - self.constants[7] * t1148
            - t14 * t2291 - t26 * t2297;
        t2348 = t2346 - t753 * t2313 - sin_delta * t2207;
        t2350 = t26 * t818;
        t2354 = t2350 + t107 * t815 + speeds[0] * t110;
        t2356 = t2212 + t2293;
        t2360 = self.constants[39] * t838 - t847;
        t2361 = cos_delta * t2360;
        t2364 = t851 + t852 - self.constants[39] * t835;
        t2366 = t2364 - self.constants[34] * t2134;
        t2370 = self.constants[33] * t819 + t2361 - t823 - sin_delta * t2366;
        t2373 = self.constants[17] * t2134;
        t2378 = t1057 + t1059;
        t2380 = sin_delta * t1068 + cos_delta * t2378;
        t2383 = sin_delta * t2360 - self.constants[23] * t2160
            - self.constants[24] * t2380;
        t2390 = t1698 * t2160 - t1633 * t2380;
        t2393 = t1698 * t2103 + t1698 * t2373 + t2390 - t1633 * (t1179 + t1181);
        t2400 = t829 + t830 + t2383 + cos_delta * t2366 - self.constants[33] * t817
            - self.constants[23] * t2373 - t2393;
        t2406 = cos_delta * t1068 - sin_delta * t2378;
        t2407 = t85 * t2406;
        t2409 = t2407 - t26 * t2356 - t14 * t2370;
        t2412 = t884 + t886;
        t2416 = t2191 + t32 * t1943;
        t2417 = t2134 + t2416;
        t2421 = t2188 + t844 * t921;
        let (
            t2424, t2429, t2432, t2436, t2438, t2443, t2448, t2450, t2453, t2455, t2459, t2467,
            t2468, t2473, t2475, t2477, t2482, t2487, t2488, t2490, t2492, t2495, t2496, t2498,
            t2500, t2502, t2504, t2509, t2512, t2516, t2518, t2528, t2533, t2536, t2542, t2547,
            t2552, t2557, t2562, t2566, t2579, t2587, t2590, t2591, t2595, t2602, t2603, t2610,
            t2618, t2623, t2628, t2636, t2646, t2655, t2661, t2667, t2673, t2676, t2679, t2689,
            t2695, t2714, t2715, t2728, t2730, t2736, t2739, t2755, t2759, t2771, t2776, t2780,
            t2790, t2799, t2804, t2805, t2825, t2830, t2833, t2840, t2845, t2850, t2855, t2860,
            t2863, t2867, t2869, t2878, t2886, t2890, t2892, t2897, t2905, t2906, t2913, t2922,
            t2927, t2933, t2934, t2942, t2952, t2961, t2967, t2973, t2979, t2982, t2985, t2995,
            t3001, t3020, t3021, t3034, t3036, t3042, t3046, t3062, t3067, t3077, t3083, t3088,
            t3097, t3106, t3111, t3112, t3132, t3137, t3140, t3148, t3153, t3158, t3163, t3169,
            t3174, t3176, t3180, t3183, t3185, t3187, t3191, t3195, t3208, t3215, t3218, t3226,
            t3243, t3248, t3257, t3265, t3271, t3275, t3279, t3294, t3297, t3307, t3319, t3322,
            t3325, t3335, t3347, t3355, t3357, t3363, t3367, t3376, t3381, t3386, t3391, t3396,
            t3401, t3402, t3437, t3442, t3447, t3452, t3457, t3460, t3496, t3501, t3506, t3511,
            t3516, t3521, t3522, t3524, t3528, t3529, t3530, t3532, t3539, t3542, t3548, t3550,
            t3554, t3560, t3573, t3578, t3582, t3604, t3609, t3614, t3637, t3642, t3647, t3649,
            t3651, t3655, t3658, t3662, t3667, t3672, t3675, t3678, t3687, t3692, t3694, t3711,
            t3716, t3717, t3736, t3741, t3744, t3746, t3750, t3751, t3753, t3757, t3759, t3761,
            t3769, t3771, t3783, t3784, t3797, t3800, t3802, t3806, t3810, t3812, t3816, t3817,
            t3819, t3822, t3823, t3824, t3825, t3826, t3827, t3828, t3829, t3830,
        );
        t2424 = cos_delta * t867 + t2421 + sin_delta * t2412;
        t2429 = t948 + t2249 + t32 * t2029;
        t2432 = sin_delta * t867 - t2429 - cos_delta * t2412;
        t2436 = t34 * t925;
        t2438 = t1642 * t2406 + t2073 * t2436;
        t2443 = t14 * t2356 + t764 * t2409 + t867 * t1742 + t1964 * t2417 + t2015 * t2424
            + t2051 * t2432;
        t2448 = t2443 + t91 * t2100 + t2438 - self.constants[7] * t1146 - t26 * t2370
            - t753 * t2400;
        t2450 = t2448 - t1679 * t2412 - t91 * t1867;
        t2453 = cos_delta * t2154;
        t2455 = sin_delta * t2154;
        t2459 = t26 * t2149 + t14 * t2453;
        t2467 = t2069 + t26 * t2453 + t753 * t2455 + t764 * t2459 - t14 * t2149
            - t931 * t1964;
        t2468 = t2467 - t933 * t2051;
        t2473 = t1711 + t2134;
        t2475 = t817 * t1934 + cos_delta * t2473;
        t2477 = sin_delta * t2473;
        t2482 = t1711 * t1746 - t855 * t2086;
        t2487 = t2282 + t817 * t1774 + t2015 * t2475 + t2051 * t2477 + t828 * t2100
            - t828 * t1867;
        t2488 = t2487 - t2482;
        t2490 = cos_phi * t1615;
        t2492 = cos_phi * t1683;
        t2495 = cos_phi * t1709;
        t2496 = sin_phi * t1711 - t2495;
        t2498 = sin_phi * t809;
        t2500 = speeds[0] * cos_phi;
        t2502 = sin_phi * t827;
        t2504 = cos_phi * t1938;
        t2509 = t2495 + sin_phi * t1980;
        t2512 = sin_phi * t1977 + cos_phi * t1974 + cos_delta * t2509;
        t2516 = cos_phi * t2019 + sin_delta * t2509;
        t2518 = sin_phi * t2076;
        t2528 = t1680 * t2490 + t1746 * t2496 + t1774 * t2498 + t1964 * t2504
            + t2015 * t2512 + t2051 * t2516;
        t2533 = t2528 + t2086 * t2518 + t2100 * t2502 + t18 * t2348 - t1707 * t2492
            - t1843 * t2500;
        t2536 = t2533 - t1867 * t2502 - sin_phi * t2282 - t27 * t2450;
        t2542 = t364 * t1539 + t107 * t1496 + t369 * t1546 + t1601 * t1611
            + t1632 * t1680 + t1697 * t1707;
        t2547 = t2542 + t1715 * t1746 + t1754 * t1774 + t1779 * t1843 + t1888 * t1899
            + t1918 * t1929;
        t2552 = t2547 + t1954 * t1964 + t2007 * t2015 + t2041 * t2051 + t2063 * t2073
            + t2077 * t2086;
        t2557 = t2552 + t2089 * t2100 + t2288 * t2348 + t2354 * t2450 + t620 * t2468
            + t235 * t2488;
        t2562 = t2557 - t465 * t2536 - t364 * t1499 - t110 * t1457 - t199 * t1538
            - t566 * t1548;
        t2566 = t2562 - t753 * t1554 - t764 * t1558 - t1851 * t1867 - t815 * t2282;
        t2579 = t1230 * t1607 - t690 * self.constants[22] - t1228 * t1605;
        t2587 = t1230 * t1669 - self.constants[34] - t1228 * t1663;
        t2590 = t1230 * t1653 - t1228 * t1649 - sin_delta * t2587;
        t2591 = t2590 - t1228 * t1635;
        t2595 = t1230 * t1704 - t1228 * t1702;
        t2602 = t1230 * t1736 + cos_delta * t2587 - t1228 * t1732;
        t2603 = t1230 * t1721 + t2602;
        t2610 = t1230 * t1766 + self.constants[23] * t2602 - self.constants[39]
            - t1228 * t1760;
        t2618 = t2579 + t1230 * t1811 - t1228 * t1807;
        t2623 = t1230 * t1832 - self.constants[37] - t1228 * t1826;
        t2628 = t1230 * t1794 + self.constants[24] * t2590 + cos_delta * t2618
            + sin_delta * t2623 - t1228 * t1792;
        t2636 = t1230 * t1857 + cos_delta * t2623 - self.constants[24] * t2602
            - sin_delta * t2618;
        t2646 = t1889 * t2591 + t18 * t2636 - t1891 * t2595 - t27 * t2610
            - sin_phi * t2628;
        t2655 = t2628 + t1921 * t2579 + t1698 * t2595 + t363 * t2646 - t1633 * t2591;
        t2661 = t1958 * t2579 + t1961 * t2655 - t1956 * t2646;
        t2667 = t2009 * t2579 + t2008 * t2646 + t2012 * t2655;
        t2673 = t2048 * t2655 - t2045 * t2579 - t2043 * t2646;
        t2676 = t2068 * t2667;
        t2679 = t2676 - t2064 * t2661 - t2070 * t2673;
        t2689 = t14 * t2591 + t26 * t2595 + t124 * t2673 - t26 * t2661 - t115 * t2667;
        t2695 = t2094 * t2667 + t2097 * t2673 - t2090 * t2661;
        t2714 = t1230 * t2185 + speeds[1] * t2623 + t2195 * t2667 - t2151 - t1228 * t2179
            - t2189 * t2661;
        t2715 = t2714 - t2198 * t2673;
        t2728 = t1230 * t2244 + t2252 * t2661 + t2255 * t2667 + t2258 * t2673
            + t2260 * t2679 - t2210;
        t2730 = t2728 - t1228 * t2238 - speeds[1] * t2618;
        t2736 = t1230 * t2131 + t2135 * t2602 + t2142 * t2667 + t2146 * t2673
            + cos_delta * t2715 + sin_delta * t2730;
        t2739 = t2736 - t1228 * t2127 - t2137 * t2590 - t2110 * t2661;
        t2755 = t1230 * t2317 + t869 * t2602 + t2133 * t2590 + t91 * t2610
            + t2294 * t2661 + t2329 * t2667;
        t2759 = t2755 + t2333 * t2673 + cos_delta * t2730 - t1228 * t2313
            - sin_delta * t2715;
        t2771 = t2212 + t2436 * t2679;
        t2776 = t1230 * t2409 + t867 * t2602 + t2417 * t2661 + t2424 * t2667
            + t2432 * t2673 + t91 * t2695;
        t2780 = t2776 + t2771 - t1228 * t2400 - t2412 * t2590 - t91 * t2636;
        t2790 = t2676 + t1228 * t2455 + t1230 * t2459 - t2149 - t931 * t2661
            - t933 * t2673;
        t2799 = t1711 * t2603 + t855 * t2689;
        t2804 = t2739 + t817 * t2610 + t2475 * t2667 + t2477 * t2673 + t828 * t2695
            + t2799;
        t2805 = t2804 - t828 * t2636;
        t2825 = t2490 * t2591 + t2498 * t2610 + t2504 * t2661 + t2512 * t2667
            + t2516 * t2673 + t2518 * t2689;
        t2830 = t2825 + t2502 * t2695 + t18 * t2759 - t2492 * t2595 - t2496 * t2603
            - t2500 * t2628;
        t2833 = t2830 - t2502 * t2636 - sin_phi * t2739 - t27 * t2780;
        t2840 = t447 * t1539 + t461 * t1546 + t1601 * t2579 + t1632 * t2591
            + t1697 * t2595 + t1754 * t2610;
        t2845 = t2840 + t1779 * t2628 + t1888 * t2646 + t1918 * t2655 + t1954 * t2661
            + t2007 * t2667;
        t2850 = t2845 + t2041 * t2673 + t2063 * t2679 + t2077 * t2689 + t2089 * t2695
            + t2288 * t2759;
        t2855 = t2850 + t2354 * t2780 + t620 * t2790 + t235 * t2805 - t465 * t2833
            - t447 * t1499;
        t2860 = t2855 - t233 * t1538 - t617 * t1548 - t1228 * t1554 - t1230 * t1558
            - t1715 * t2603;
        t2863 = t2860 - t1851 * t2636 - t815 * t2739 - t1262 * t2566;
        t2867 = t341 * t1546;
        t2869 = t329 * t1546;
        t2878 = t1295 * t1605 + t1297 * t1607 - t693 * self.constants[22];
        t2886 = t1295 * t1663 + t1297 * t1669 - t1660;
        t2890 = t1645 + t1295 * t1649 + t1297 * t1653 - sin_delta * t2886;
        t2892 = t1634 + t1295 * t1635 + t2890;
        t2897 = t1295 * t1702 + t1297 * t1704 - t1701;
        t2905 = t1728 + t1295 * t1732 + t1297 * t1736 + cos_delta * t2886;
        t2906 = t1297 * t1721 + t2905;
        t2913 = t1295 * t1760 + t1297 * t1766 + self.constants[23] * t2905 - t1759;
        t2922 = t1802 + t2878 + t1295 * t1807 + t1297 * t1811;
        t2927 = t1823 + t1295 * t1826 + t1297 * t1832;
        t2933 = t1788 + t1295 * t1792 + t1297 * t1794 + self.constants[24] * t2890
            + cos_delta * t2922 + sin_delta * t2927;
        t2934 = t2933 - self.constants[21];
        t2942 = t1297 * t1857 + cos_delta * t2927 - self.constants[24] * t2905
            - sin_delta * t2922;
        t2952 = t1889 * t2892 + t18 * t2942 - t1891 * t2897 - t27 * t2913
            - sin_phi * t2934;
        t2961 = t2934 + t1921 * t2878 + t1698 * t2897 + t363 * t2952 - t1633 * t2892;
        t2967 = t1958 * t2878 + t1961 * t2961 - t1956 * t2952;
        t2973 = t2009 * t2878 + t2008 * t2952 + t2012 * t2961;
        t2979 = t2048 * t2961 - t2045 * t2878 - t2043 * t2952;
        t2982 = t2068 * t2973;
        t2985 = t2982 - t2064 * t2967 - t2070 * t2979;
        t2995 = t14 * t2892 + t26 * t2897 + t124 * t2979 - t26 * t2967 - t115 * t2973;
        t3001 = t2094 * t2973 + t2097 * t2979 - t2090 * t2967;
        t3020 = t1295 * t2179 + t1297 * t2185 + speeds[1] * t2927 + t2195 * t2973 - t2175
            - t2189 * t2967;
        t3021 = t3020 - t2198 * t2979;
        t3034 = t2232 + t1295 * t2238 + t1297 * t2244 + t2252 * t2967 + t2255 * t2973
            + t2258 * t2979;
        t3036 = t3034 + t2260 * t2985 - speeds[1] * t2922;
        t3042 = t1295 * t2127 + t1297 * t2131 + t2135 * t2905 + t2142 * t2973
            + t2146 * t2979 + cos_delta * t3021;
        t3046 = t3042 + sin_delta * t3036 - t2123 - t2137 * t2890 - t2110 * t2967;
        t3062 = t2306 + t1295 * t2313 + t1297 * t2317 + t869 * t2905 + t2133 * t2890
            + t91 * t2913;
        t3067 = t3062 + t2294 * t2967 + t2329 * t2973 + t2333 * t2979 + cos_delta * t3036
            - sin_delta * t3021;
        t3077 = t2436 * t2985;
        t3083 = t2393 + t1295 * t2400 + t1297 * t2409 + t867 * t2905 + t2417 * t2967
            + t2424 * t2973;
        t3088 = t3083 + t2432 * t2979 + t3077 + t91 * t3001 - t2412 * t2890
            - t91 * t2942;
        t3097 = t2982 + t1297 * t2459 - t1295 * t2455 - t931 * t2967 - t933 * t2979;
        t3106 = t1711 * t2906 + t855 * t2995;
        t3111 = t3046 + t817 * t2913 + t2475 * t2973 + t2477 * t2979 + t828 * t3001
            + t3106;
        t3112 = t3111 - t828 * t2942;
        t3132 = t2490 * t2892 + t2498 * t2913 + t2504 * t2967 + t2512 * t2973
            + t2516 * t2979 + t2518 * t2995;
        t3137 = t3132 + t2502 * t3001 + t18 * t3067 - t2492 * t2897 - t2496 * t2906
            - t2500 * t2934;
        t3140 = t3137 - t2502 * t2942 - sin_phi * t3046 - t27 * t3088;
        t3148 = t328 * t1539 + t191 * t2867 + t1295 * t1554 + t1601 * t2878
            + t1632 * t2892 + t1697 * t2897;
        t3153 = t3148 + t1754 * t2913 + t1779 * t2934 + t1888 * t2952 + t1918 * t2961
            + t1954 * t2967;
        t3158 = t3153 + t2007 * t2973 + t2041 * t2979 + t2063 * t2985 + t2077 * t2995
            + t2089 * t3001;
        t3163 = t3158 + t2288 * t3067 + t2354 * t3088 + t620 * t3097 + t235 * t3112
            - t465 * t3140;
        t3169 = t3163 - t1554 - t328 * t1499 - t339 * t2869 - t543 * t1484
            - t1297 * t1558 - t1715 * t2906;
        t3174 = t1368
            * (t3169 - t1851 * t2942 - t815 * t3046 - t1327 * t2566 - t1336 * t2863);
        t3176 = t1280 * t2863 - t1336 * t3174;
        t3180 = t808 * t2566 - t1262 * t3176 - t1327 * t3174;
        t3183 = t1403 * t1637 - t1418 * t1658;
        t3185 = t1507 + sin_delta * t3183;
        t3187 = self.constants[17] * t1403;
        t3191 = self.constants[17] * t1418;
        t3195 = cos_delta * (t1439 + sin_delta * t3187)
            - sin_delta * (t1446 + sin_delta * t3191);
        t3208 = cos_delta * (cos_delta * t3187 - t1446)
            - sin_delta * (t1439 + cos_delta * t3191);
        t3215 = t242 * t1552 + t1633 * t3208 - t240 * t1550;
        t3218 = t1490 + self.constants[24] * t3208 + cos_delta * t3183 - t3215;
        t3226 = t14 * t3185 + t85 * t3195 - t240 * t1457 - t242 * t1496;
        t3243 = t260 * t1564 + t264 * t1570 + t268 * t1575 + t481 * t1580 + t629 * t1582
            + t634 * t1369;
        t3248 = t3243 + t649 * t1588 + t675 * t1590 - t245 * t1561 - t642 * t1577
            - t472 * t1585;
        t3257 = t240 * t1414 + t242 * t1027 - t303 * t1622 - t311 * t1625;
        t3265 = t242 * t1414 + t303 * t1688 + t311 * t1690 - t240 * t1027;
        t3271 = t242 * t1375 - t240 * t1389;
        t3275 = t303 * t1375 + t311 * t1371;
        t3279 = t240 * t1375 + t242 * t1389;
        t3294 = t260 * t1563 + t268 * t1573 + t296 * t1873 + t481 * t1579 + t486 * t1375
            + t512 * t1371;
        t3297 = t3294 - t245 * t1560 - t264 * t1568 - t472 * t1877;
        t3307 = t245 * t1903 + t260 * t1905 + t264 * t1908 - t268 * t1910 - t301 * t1912;
        t3319 = t240 * t899 + t242 * t894 + t264 * t1945 + t268 * t1949 - t911 * t1934
            - t912 * t1934;
        t3322 = t889 * t1966 - t903;
        t3325 = t881 + t877 * t1966;
        t3335 = cos_delta * t3322 + t264 * t1996 - sin_delta * t3325 - t240 * t1990
            - t242 * t1992 - t268 * t2000;
        t3347 = cos_delta * t3325 + sin_delta * t3322 + t242 * t2027 - t240 * t2025
            - t264 * t2031 - t268 * t2034;
        t3355 = t245 * t2053 + t264 * t2057 - t260 * t2055 - t268 * t2059;
        t3357 = t242 * t866;
        t3363 = t242 * t815 - speeds[0] * t240;
        t3367 = t240 * t815 + speeds[0] * t242;
        t3376 = t26 * t3185 + t1642 * t3195 + t240 * t1496 + t486 * t1546 + t764 * t3226
            + t1611 * t3248;
        t3381 = t3376 + t1680 * t3257 + t1707 * t3265 + t1435 * t1837 + t1774 * t3271
            + t1843 * t3275;
        t3386 = t3381 + t1899 * t3297 + t1929 * t3307 + t1964 * t3319 + t2015 * t3335
            + t2051 * t3347;
        t3391 = t3386 + t2073 * t3355 + t2100 * t3357 + t838 * t2270 + t2348 * t3363
            + t2450 * t3367;
        t3396 = t3391 + t678 * t2468 + t313 * t2488 - t516 * t2536 - t242 * t1457
            - t303 * t1538;
        t3401 = t3396 - t649 * t1548 - t753 * t3218 - t1431 * t1674 - t1424 * t1816
            - t1867 * t3279;
        t3402 = t3401 - t835 * t2207;
        t3437 = t512 * t1546 + t1230 * t3226 + t2579 * t3248 + t2591 * t3257
            + t2595 * t3265 + t1435 * t2623;
        t3442 = t3437 + t2610 * t3271 + t2628 * t3275 + t2646 * t3297 + t2655 * t3307
            + t2661 * t3319;
        t3447 = t3442 + t2667 * t3335 + t2673 * t3347 + t2679 * t3355 + t2695 * t3357
            + t838 * t2730;
        t3452 = t3447 + t2759 * t3363 + t2780 * t3367 + t678 * t2790 + t313 * t2805
            - t516 * t2833;
        t3457 = t3452 - t311 * t1538 - t675 * t1548 - t1228 * t3218 - t1431 * t2587
            - t1424 * t2618;
        t3460 = t3457 - t2636 * t3279 - t835 * t2715 - t1262 * t3402;
        t3496 = t3215 + t296 * t2867 + t1295 * t3218 + t1297 * t3226 + t2878 * t3248
            + t2892 * t3257;
        t3501 = t3496 + t2897 * t3265 + t1435 * t2927 + t2913 * t3271 + t2934 * t3275
            + t2952 * t3297;
        t3506 = t3501 + t2961 * t3307 + t2967 * t3319 + t2973 * t3335 + t2979 * t3347
            + t2985 * t3355;
        t3511 = t3506 + t3001 * t3357 + t838 * t3036 + t3067 * t3363 + t3088 * t3367
            + t678 * t3097;
        t3516 = t3511 + t313 * t3112 - t516 * t3140 - t472 * t2869 - t634 * t1484
            - t1431 * t2886;
        t3521 = t3516 - t1424 * t2922 - t2942 * t3279 - t835 * t3021 - t1327 * t3402
            - t1336 * t3460;
        t3522 = t1368 * t3521;
        t3524 = t1280 * t3460 - t1336 * t3522;
        t3528 = t808 * t3402 - t1262 * t3524 - t1327 * t3522;
        t3529 = t1711 + t1711;
        t3530 = t26 * t3529;
        t3532 = t14 * t3529;
        t3539 = cos_delta * t815;
        t3542 = t14 * t1711 + t815 * t1932 + t1934 * t3539;
        t3548 = t26 * t1711 + t815 * t1970;
        t3550 = self.constants[23] * t2350;
        t3554 = t1934 * t2350 + t815 * t1967 + cos_delta * t3550 - sin_delta * t3548;
        t3560 = cos_delta * t3548 + sin_delta * t3550 - t1966 * t3539;
        t3573 = t1680 * t3530 + t1774 * t2350 + t1964 * t3542 + t2015 * t3554
            + t2051 * t3560 + t2100 * t2284;
        t3578 = t3573 + t26 * t2348 + t14 * t2450 + t682 * t2468 + t72 * t2488
            + t364 * t2536;
        t3582 = t3578 - t1707 * t3532 - t815 * t1843 - t1867 * t2284 - t1614 * t2086;
        t3604 = t2591 * t3530 + t2350 * t2610 + t2661 * t3542 + t2667 * t3554
            + t2673 * t3560 + t2284 * t2695;
        t3609 = t3604 + t26 * t2759 + t14 * t2780 + t682 * t2790 + t72 * t2805
            + t364 * t2833;
        t3614 = t3609 - t2595 * t3532 - t815 * t2628 - t2284 * t2636 - t1614 * t2689
            - t1262 * t3582;
        t3637 = t2892 * t3530 + t2350 * t2913 + t2967 * t3542 + t2973 * t3554
            + t2979 * t3560 + t2284 * t3001;
        t3642 = t3637 + t26 * t3067 + t14 * t3088 + t682 * t3097 + t72 * t3112
            + t364 * t3140;
        t3647 = t3642 - t2897 * t3532 - t815 * t2934 - t2284 * t2942 - t1614 * t2995
            - t1327 * t3582;
        t3649 = t1368 * (t3647 - t1336 * t3614);
        t3651 = t1280 * t3614 - t1336 * t3649;
        t3655 = t808 * t3582 - t1262 * t3651 - t1327 * t3649;
        t3658 = t2361 - sin_delta * t2364;
        t3662 = t2383 + cos_delta * t2364 - t2390;
        t3667 = t2407 - t26 * t2212 - t14 * t3658;
        t3672 = t2416 + t835 * t1934;
        t3675 = t2421 - t838 * t1966;
        t3678 = t2429 + t835 * t1966;
        t3687 = t2438 + t14 * t2212 + t764 * t3667 + t838 * t1837 + t1964 * t3672
            + t2015 * t3675;
        t3692 = t3687 + t690 * t2468 + t89 * t2488 + t447 * t2536 - t26 * t3658
            - t753 * t3662;
        t3694 = t3692 - t835 * t1816 - t2051 * t3678;
        t3711 = t2771 + t1230 * t3667 + t838 * t2623 + t2661 * t3672 + t2667 * t3675
            + t690 * t2790;
        t3716 = t3711 + t89 * t2805 + t447 * t2833 - t1228 * t3662 - t835 * t2618
            - t2673 * t3678;
        t3717 = t3716 - t1262 * t3694;
        t3736 = t2390 + t3077 + t1295 * t3662 + t1297 * t3667 + t838 * t2927
            + t2967 * t3672 + t2973 * t3675;
        t3741 = t3736 + t690 * t3097 + t89 * t3112 + t447 * t3140 - t835 * t2922
            - t2979 * t3678;
        t3744 = t1368 * (t3741 - t1327 * t3694 - t1336 * t3717);
        t3746 = t1280 * t3717 - t1336 * t3744;
        t3750 = t808 * t3694 - t1262 * t3746 - t1327 * t3744;
        t3751 = self.constants[21] * t817;
        t3753 = self.constants[21] * t828;
        t3757 = t26 * t3751 + t14 * t3753;
        t3759 = cos_delta * t1711;
        t3761 = sin_delta * t1711;
        t3769 = t26 * t3753 + t764 * t3757 + t2015 * t3759 + t2051 * t3761 + t693 * t2468
            + t328 * t2536;
        t3771 = t3769 - t2482 - t14 * t3751;
        t3783 = t2799 + t1230 * t3757 + t2667 * t3759 + t2673 * t3761 + t693 * t2790
            + t328 * t2833;
        t3784 = t3783 - t1262 * t3771;
        t3797 = t3106 + t1297 * t3757 + t2973 * t3759 + t2979 * t3761 + t693 * t3097
            + t328 * t3140;
        t3800 = t1368 * (t3797 - t1327 * t3771 - t1336 * t3784);
        t3802 = t1280 * t3784 - t1336 * t3800;
        t3806 = t808 * t3771 - t1262 * t3802 - t1327 * t3800;
        t3810 = t1368 * (t1262 * t1336 - t1327);
        t3812 = t1262 * t1280 + t1336 * t3810;
        t3816 = t808 + t1262 * t3812 - t1327 * t3810;
        t3817 = t1336 * t1368;
        t3819 = t1280 + t1336 * t3817;
        t3822 = t1327 * t3817 - t1262 * t3819;
        t3823 = -(t98 * t235);
        t3824 = -(t98 * t313);
        t3825 = -(t72 * t98);
        t3826 = -(t89 * t98);
        t3827 = -t98;
        t3828 = -(t93 * cos_psi);
        t3829 = -(t235 * t318);
        t3830 = -(t313 * t318);
        let (t3831, t3832, t3833, t3834, t3835, t3836, t3837, t3838);
        t3831 = -(t72 * t318);
        t3832 = -(t89 * t318);
        t3833 = -t318;
        t3834 = -t364;
        t3835 = -t447;
        t3836 = -t328;
        t3837 = -t3812;
        t3838 = -t3817;
        (
            [
                [zero, zero, t96, t3823, zero, t3824, zero, zero, t3825, t3826, t3827],
                [zero, zero, t3828, t3829, zero, t3830, zero, zero, t3831, t3832, t3833],
                [zero, zero, zero, t465, zero, t516, zero, zero, t3834, t3835, t3836],
                [
                    zero, zero, zero, zero, zero, zero, zero, zero, self.constants[0].like(1.0),
                    zero, zero,
                ],
                [zero, zero, zero, t235, zero, t313, zero, zero, t72, t89, zero],
                [
                    zero, zero, zero, zero, zero, zero, zero, zero, zero,
                    self.constants[0].like(1.0), zero,
                ],
                [
                    zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                    self.constants[0].like(1.0),
                ],
                [zero, zero, zero, t620, zero, t678, zero, zero, t682, t690, t693],
                [zero, zero, zero, t3180, zero, t3528, zero, zero, t3655, t3750, t3806],
                [zero, zero, zero, t3176, zero, t3524, zero, zero, t3651, t3746, t3802],
                [zero, zero, zero, t3174, zero, t3522, zero, zero, t3649, t3744, t3800],
            ],
            [
                [zero, zero], [zero, zero], [zero, zero], [zero, zero], [zero, zero], [zero, zero],
                [zero, zero], [zero, zero], [t3816, t3822], [t3837, t3819], [t3810, t3838],
            ],
        )
    }

    fn by_parameters_unchecked(&self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2]) -> [[T; 26]; 11] {
        let (
            sin_pitch, cos_pitch, t7, sin_phi, cos_phi, t12, t13, sin_delta, cos_delta, t16, t20,
            t21, t25, t26, t27, t28, t30, t32, t36, t40, t41, t48, t51, t53, t54, t55, t57, t59,
            t62, t64, t65, t70, t71, t72, sin_psi, cos_psi, t77, t78, t80, t81, t82, t84, t85, t87,
            t88, t90, t92, t93, t94, t96, t98, t100, t103, t104, t105, t108, t110, t115, t118, t120,
            t123, t125, t129, t132, t135, t137, t141, t142, t143, t145, t146, t147, t148, t151,
            t153, t159, t161, t162, t166, t168, t171, t172, t174, t176, t179, t181, t188, t191,
            t198, t204, t206, t214, t216, t218, t224, t226, t227, t229, t234, t238, t242, t246,
            t248, t256, t257, t259, t277, t279, t282, t284, t287, t293, zero, t298, t299, t305,
            t308, t309, t311, t317, t318, t320, t327, t328, t330, t336, t338, t339, t341, t343,
            t346, t348, t353, t355, t361, t373, t379, t381, t389, t391, t393, t399, t406, t417,
            t428, t439, t443, t444, t445, t447, t454, t457, t459, t460, t464, t465, t469, t470,
            t474, t475, t480, t482, t484, t486, t487, t488, t490, t493, t495, t497, t498, t501,
            t505, t506, t507, t514, t515, t517, t518, t521, t525, t526, t528, t530, t532, t535,
            t538, t543, t548, t553, t557, t563, t567, t569, t577, t584, t588, t597, t601, t607,
            t609, t617, t619, t621, t623, t630, t637, t648, t652, t662, t664, t665, t677, t678,
            t680, t682, t686, t691, t693, t699, t711, t717, t719, t727, t729, t731, t737, t744,
            t755, t764, t775, t776, t777, t778, t780, t785, t786, t793, t797, t798, t799, t801,
            t805, t808, t810, t815, t818, t819, t824, t828, t829, t832, t835, t839,
        );
        (sin_pitch, cos_pitch) = positions[4].sin_cos();
        t7 = self.constants[19] * sin_pitch + self.constants[20] * cos_pitch;
        (sin_phi, cos_phi) = positions[3].sin_cos();
        t12 = self.constants[19] * cos_pitch - sin_pitch * self.constants[20];
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
        t41 = self.constants[10] * t40;
        t48 = self.constants[23] + cos_delta * self.constants[25];
        t51 = t36 * t41 + t7 * self.constants[27] + t12 * t48;
        t53 = self.constants[0].like(1.0) / (cos_phi * t51);
        t54 = self.constants[20] * t13;
        t55 = t7 * cos_delta;
        t57 = t20 - cos_phi * t55;
        t59 = t54 + self.constants[19] * t57;
        t62 = t54 - t59 - self.constants[19] * t16;
        t64 = t53 * (t59 + t62);
        t65 = t7 * t64;
        t70 = t51 - t7 * self.constants[24] - t12 * self.constants[23];
        t71 = sin_phi * t53;
        t72 = t70 * t71;
        (sin_psi, cos_psi) = positions[2].sin_cos();
        t77 = self.constants[7] * cos_psi;
        t78 = speeds[1] * t77;
        t80 = t12 * sin_phi;
        t81 = t53 * t80;
        t82 = t78 * t81;
        t84 = t7 * t71;
        t85 = t78 * t84;
        t87 = t26 * t26;
        t88 = t21 * t87;
        t90 = t26 * self.constants[0].like(0.5);
        t92 = cos_phi * (t13 + t13);
        t93 = t90 * t92;
        t94 = t88 * t93;
        t96 = t12 * cos_delta;
        t98 = t13 * t87;
        t100 = cos_phi * t26 - t93 * t98;
        t103 = t32 + t7 * t94 + t96 * t100;
        t104 = t41 * t103;
        t105 = t7 * t53;
        t108 = t77 * speeds[0];
        t110 = t78 * t105 + t53 * t108;
        t115 = t28 + sin_phi * t55;
        t118 = sin_phi * t30 + t100 * t115 - t80 * t94;
        t120 = t48 + t41 * t118;
        t123 = t12 * t32 - t7 * t30;
        t125 = sin_delta * self.constants[25];
        t129 = t12 * self.constants[27] - t7 * t48;
        t132 = cos_phi * t125 - t41 * t123 - sin_phi * t129;
        t135 = t12 * self.constants[24] - t7 * self.constants[23];
        t137 = t132 + sin_phi * t135;
        t141 = t53 * (t7 * t137 + t70 * t80);
        t142 = cos_phi * t53;
        t143 = t141 * t142;
        t145 = sin_phi * self.constants[7];
        t146 = t132 + t145;
        t147 = t53 * t146;
        t148 = t142 * t147;
        t151 = t78 * t143 + t108 * t148 - t82;
        t153 = sin_phi * t110;
        t159 = self.constants[23] * t82 + t104 * t110 + t120 * t151
            + self.constants[27] * t153 - t72 * t78 - self.constants[24] * t85;
        t161 = t12 * t64;
        t162 = t53 * t137;
        t166 = t28 * self.constants[10];
        t168 = cos_phi * cos_delta;
        t171 = t168 * (t21 + t21);
        t172 = t90 * t171;
        t174 = t88 * t172 - t26 * t168;
        t176 = t98 * t172;
        t179 = t96 * t176 - t30 - t7 * t174;
        t181 = t123 * t166 + t41 * t179;
        t188 = sin_phi * t32 + t80 * t174 + t115 * t176;
        t191 = self.constants[27] + t36 * t166 + t41 * t188;
        t198 = self.constants[24] * t82 + self.constants[23] * t85 + t110 * t181
            + t151 * t191 - t78 * t162 - t48 * t153;
        t204 = t7 * t151 + t12 * t153;
        t206 = t7 * t82 + t204 - t12 * t85;
        t214 = t12 * t82 + t7 * t85 + t12 * t151 - t7 * t153;
        t216 = self.constants[20] * t206 + self.constants[19] * t214;
        t218 = t161 * t198 + t216 - t65 * t159;
        t224 = t96 * t151 - t28 * t110 - t55 * t153;
        t226 = t53 * t62;
        t227 = t7 * t226;
        t229 = t12 * t226;
        t234 = t216 + t198 * t229 - self.constants[20] * t204 - self.constants[19] * t224
            - t159 * t227;
        t238 = self.constants[6] + self.constants[18];
        t242 = self.constants[19] * self.constants[10]
            - self.constants[20] * (self.constants[6] - t238);
        t246 = cos_phi * t48;
        t248 = cos_phi * self.constants[27];
        t256 = self.constants[10] * t90;
        t257 = t171 * t256;
        t259 = t92 * t256;
        t277 = self.constants[19]
            * (t16 * self.constants[7] + t13 * t238 - cos_pitch * t246
                - sin_pitch * t248) + t57 * t242;
        t279 = t277 + t13 * self.constants[25]
            - self.constants[20]
                * (cos_pitch * t248 + t13 * self.constants[7] - sin_pitch * t246
                    - t16 * t238);
        t282 = t53
            * (t279 - self.constants[20] * (cos_pitch * t259 - sin_pitch * t257)
                - self.constants[19] * (cos_pitch * t257 + sin_pitch * t259));
        t284 = t7 + t7 * t282;
        t287 = t12 + t12 * t282;
        t293 = self.constants[25] * t204 + t224 * t242 + self.constants[23] * t206
            + t198 * t287 - self.constants[24] * t214 - t159 * t284;
        zero = self.constants[0].like(0.0);
        t298 = speeds[0] * t147 + speeds[1] * t141;
        t299 = speeds[2] + t298;
        t305 = self.constants[19] * t13;
        t308 = t53 * (self.constants[20] * t16 + t305 - cos_phi);
        t309 = t7 * t308;
        t311 = t12 * t308;
        t317 = self.constants[19] * t206 + t198 * t311 - cos_psi * t299 - t71 * t108
            - self.constants[20] * t214 - t159 * t309;
        t318 = t40 * t123;
        t320 = t36 * t40;
        t327 = t53 * (t25 + self.constants[20] * t57 - t305);
        t328 = t7 * t327;
        t330 = t12 * t327;
        t336 = t110 * t318 + t151 * t320 + self.constants[20] * t224 + t198 * t330
            - self.constants[19] * t204 - t159 * t328;
        t338 = self.constants[7] * sin_psi;
        t339 = speeds[1] * t338;
        t341 = t81 * t339;
        t343 = t84 * t339;
        t346 = speeds[0] * t338;
        t348 = t105 * t339 + t53 * t346;
        t353 = t143 * t339 + t148 * t346 - t341;
        t355 = sin_phi * t348;
        t361 = self.constants[23] * t341 + t104 * t348 + t120 * t353
            + self.constants[27] * t355 - t72 * t339 - self.constants[24] * t343;
        t373 = self.constants[24] * t341 + self.constants[23] * t343 + t181 * t348
            + t191 * t353 - t162 * t339 - t48 * t355;
        t379 = t7 * t353 + t12 * t355;
        t381 = t7 * t341 + t379 - t12 * t343;
        t389 = t12 * t341 + t7 * t343 + t12 * t353 - t7 * t355;
        t391 = self.constants[20] * t381 + self.constants[19] * t389;
        t393 = t161 * t373 + t391 - t65 * t361;
        t399 = t96 * t353 - t28 * t348 - t55 * t355;
        t406 = t391 + t229 * t373 - self.constants[20] * t379 - self.constants[19] * t399
            - t227 * t361;
        t417 = self.constants[25] * t379 + t242 * t399 + self.constants[23] * t381
            + t287 * t373 - self.constants[24] * t389 - t284 * t361;
        t428 = self.constants[19] * t381 + t311 * t373 - t299 * sin_psi - t71 * t346
            - self.constants[20] * t389 - t309 * t361;
        t439 = t318 * t348 + t320 * t353 + self.constants[20] * t399 + t330 * t373
            - self.constants[19] * t379 - t328 * t361;
        t443 = self.constants[0].like(1.0) / (t51 * t123 + t36 * t146);
        t444 = self.constants[7] * t443;
        t445 = t118 * t444;
        t447 = t36 * t443;
        t454 = t25 * self.constants[10] + sin_phi * t125 + cos_phi * t129
            - cos_phi * t135;
        t457 = sin_phi * t454 + cos_phi * t137;
        t459 = t123 * t443;
        t460 = cos_phi * t70;
        t464 = t80 * t447 - t7 * t459;
        t465 = self.constants[10] * t464;
        t469 = t13 * t70 - t7 * t454;
        t470 = t443 * t469;
        t474 = t80 * t454 + t13 * t137;
        t475 = t443 * t474;
        t480 = t447 * t457 + t459 * t460 + t93 * t465 + t103 * t470 + t118 * t475;
        t482 = sin_phi * t51;
        t484 = sin_phi * t146;
        t486 = t123 * t482 + t36 * t484;
        t487 = t443 * t486;
        t488 = speeds[1] * t487;
        t490 = t13 * t459;
        t493 = speeds[1] * t490 + t81 * t488;
        t495 = t13 * sin_phi;
        t497 = cos_phi * t464;
        t498 = t447 * t495 - t497;
        t501 = speeds[1] * t498 + t84 * t488;
        t505 = t51 * t103 + t118 * t146;
        t506 = t36 * t444;
        t507 = t443 * t506;
        t514 = t443 * (t123 * t469 + t36 * t474 + t141 * t486);
        t515 = t443 * t514;
        t517 = t147 * t487;
        t518 = t443 * t517;
        t521 = speeds[2] * t507 + speeds[1] * t515 + speeds[0] * t518;
        t525 = t103 * t482 + t118 * t484;
        t526 = t141 * t443;
        t528 = t147 * t443;
        t530 = speeds[1] * t526 + speeds[0] * t528;
        t532 = t13 * t447;
        t535 = speeds[0] * t487;
        t538 = sin_phi * t36;
        t543 = t36 * t521 - speeds[1] * t532 - t105 * t488 - t53 * t535 - t530 * t538;
        t548 = sin_phi * t123;
        t553 = t143 * t488 + t148 * t535 + t123 * t521 - t493 - t530 * t548;
        t557 = speeds[1] * t497 + sin_phi * t543;
        t563 = self.constants[23] * t493 + t505 * t521 + t120 * t553 - speeds[2] * t445
            - speeds[1] * t480 - t72 * t488;
        t567 = t563 - self.constants[24] * t501 - t525 * t530 - t104 * t543
            - self.constants[27] * t557;
        t569 = t188 * t444;
        t577 = t179 * t470 + t188 * t475 - t454 * t459 - t172 * t465;
        t584 = t51 * t179 + t146 * t188;
        t588 = t179 * t482 + t188 * t484;
        t597 = self.constants[24] * t493 + self.constants[23] * t501 + t521 * t584
            + t191 * t553 + t48 * t557 - speeds[2] * t569;
        t601 = t597 - speeds[1] * t577 - t162 * t488 - t530 * t588 - t181 * t543;
        t607 = t7 * t553 - t12 * t557;
        t609 = t7 * t493 + t607 - t12 * t501;
        t617 = t12 * t493 + t7 * t501 + t12 * t553 + t7 * t557;
        t619 = self.constants[20] * t609 + self.constants[19] * t617;
        t621 = t161 * t601 + t619 - t65 * t567;
        t623 = t20 * t464;
        t630 = t28 * t543 + t96 * t553 + t55 * t557 - speeds[1] * t623;
        t637 = t619 + t229 * t601 - self.constants[20] * t607 - self.constants[19] * t630
            - t227 * t567;
        t648 = self.constants[25] * t607 + t242 * t630 + self.constants[23] * t609
            + t287 * t601 - self.constants[24] * t617 - t284 * t567;
        t652 = sin_phi * t538;
        t662 = t521 * t538 + self.constants[19] * t609 + t311 * t601 - speeds[2] * t447
            - t71 * t535 - t530 * t652;
        t664 = t662 - self.constants[20] * t617 - t309 * t567;
        t665 = t25 * t464;
        t677 = t320 * t553 + self.constants[20] * t630 + t330 * t601 - speeds[1] * t665
            - t318 * t543 - self.constants[19] * t607;
        t678 = t677 - t328 * t567;
        t680 = speeds[1] * t81;
        t682 = speeds[1] * t84;
        t686 = speeds[1] * t105 + t53 * speeds[0];
        t691 = t680 - speeds[1] * t143 - speeds[0] * t148;
        t693 = sin_phi * t686;
        t699 = t72 * speeds[1] + self.constants[24] * t682 + t120 * t691
            - self.constants[23] * t680 - t104 * t686 - self.constants[27] * t693;
        t711 = speeds[1] * t162 + t191 * t691 + t48 * t693 - self.constants[24] * t680
            - self.constants[23] * t682 - t181 * t686;
        t717 = t7 * t691 - t12 * t693;
        t719 = t12 * t682 + t717 - t7 * t680;
        t727 = t12 * t691 + t7 * t693 - t12 * t680 - t7 * t682;
        t729 = self.constants[20] * t719 + self.constants[19] * t727;
        t731 = t161 * t711 + t729 - t65 * t699;
        t737 = t28 * t686 + t96 * t691 + t55 * t693;
        t744 = t729 + t229 * t711 - self.constants[20] * t717 - self.constants[19] * t737
            - t227 * t699;
        t755 = self.constants[25] * t717 + t242 * t737 + self.constants[23] * t719
            + t287 * t711 - self.constants[24] * t727 - t284 * t699;
        t764 = t71 * speeds[0] + self.constants[19] * t719 + t311 * t711
            - self.constants[20] * t727 - t309 * t699;
        t775 = t320 * t691 + self.constants[20] * t737 + t330 * t711 - t318 * t686
            - self.constants[19] * t717 - t328 * t699;
        t776 = self.constants[0].like(1.0) / self.constants[10];
        t777 = self.constants[7] * t776;
        t778 = t103 * t777;
        t780 = speeds[1] * t776;
        t785 = t7 * t36 + t80 * t123;
        t786 = self.constants[10] * t785;
        t793 = t123 * t457 + t93 * t786 + t103 * t474 - t36 * t460 - t118 * t469;
        t797 = t36 * t51 - t123 * t146;
        t798 = t776 * t797;
        t799 = speeds[2] * t798;
        t801 = t780 * t797;
        t805 = t36 * t482 - t123 * t484;
        t808 = t487 * t801 - t780 * t805;
        t810 = t13 * t36;
        t815 = t490 * t801 + t81 * t808 - t780 * t810;
        t818 = cos_phi * t785;
        t819 = t123 * t495 - t818;
        t824 = t780 * t819 + t498 * t801 + t84 * t808;
        t828 = t51 * t118 - t103 * t146;
        t829 = t506 * t776;
        t832 = t517 * t776;
        t835 = speeds[2] * t829 + t514 * t780 + speeds[0] * t832;
        t839 = t118 * t482 - t103 * t484;
        let (
            t841, t843, t847, t850, t854, t856, t860, t863, t873, t875, t887, t888, t894, t900,
            t905, t908, t910, t918, t927, t931, t942, t947, t950, t956, t958, t966, t968, t970,
            t972, t981, t988, t999, t1000, t1005, t1017, t1022, t1030, t1031, t1032, t1036, t1037,
            t1039, t1044, t1045, t1058, t1063, t1067, t1068, t1072, t1074, t1075, t1078, t1081,
            t1082, t1083, t1084, t1086, t1088, t1092, t1093, t1096, t1097, t1099, t1104, t1105,
            t1107, t1108, t1111, t1112, t1113, t1115, t1119, t1121, t1123, t1133, t1134, t1142,
            t1146, t1148, t1154, t1160, t1164, t1168, t1170, t1176, t1179, t1180, t1185, t1186,
            t1187, t1188, t1189, t1191, t1192, t1194, t1195, t1197, t1200, t1202, t1204, t1206,
            t1207, t1209, t1210, t1213, t1214, t1216, t1217, t1218, t1220, t1222, t1224, t1225,
            t1228, t1232, t1235, t1236, t1237, t1239, t1240, t1243, t1244, t1245, t1248, t1250,
            t1254, t1256, t1260, t1261, t1265, t1266, t1271, t1273, t1275, t1280, t1282, t1284,
            t1286, t1288, t1291, t1292, t1293, t1294, t1296, t1297, t1303, t1307, t1312, t1313,
            t1314, t1318, t1320, t1323, t1327, t1328, t1334, t1336, t1340, t1354, t1358, t1360,
            t1365, t1369, t1371, t1373, t1376, t1380, t1381, t1383, t1388, t1391, t1392, t1395,
            t1398, t1399, t1400, t1402, t1404, t1409, t1414, t1417, t1418, t1420, t1423, t1427,
            t1433, t1435, t1437, t1438, t1439, t1441, t1443, t1448, t1451, t1454, t1456, t1462,
            t1470, t1472, t1475, t1478, t1482, t1484, t1486, t1496, t1498, t1501, t1505, t1512,
            t1513, t1519, t1521, t1523, t1528, t1534, t1539, t1545, t1547, t1552, t1553, t1554,
            t1557, t1566, t1571, t1573, t1578, t1581, t1585, t1592, t1593, t1595, t1597, t1601,
            t1603, t1605, t1606, t1607, t1611, t1615, t1619, t1625, t1631, t1635, t1640, t1642,
            t1644, t1650, t1652, t1653, t1663,
        );
        t841 = t147 * t776;
        t843 = t141 * t780 + speeds[0] * t841;
        t847 = speeds[0] * t798;
        t850 = t507 * t799 + t515 * t801 + t518 * t847;
        t854 = t526 * t801 + t528 * t847;
        t856 = t13 * t123;
        t860 = t776 * t805;
        t863 = t487 * t847 - speeds[0] * t860;
        t873 = t780 * t856 + t532 * t801 + t105 * t808 + t53 * t863 + t548 * t843
            + t538 * t854;
        t875 = t873 - t123 * t835 - t36 * t850;
        t887 = t815 + t36 * t835 + t548 * t854 - t143 * t808 - t148 * t863 - t538 * t843;
        t888 = t887 - t123 * t850;
        t894 = t780 * t818 + t497 * t801 - sin_phi * t875;
        t900 = speeds[2] * t778 + t780 * t793 + t445 * t799 + t480 * t801 + t72 * t808
            + self.constants[24] * t824;
        t905 = t900 + t828 * t835 + t525 * t854 + t120 * t888 + self.constants[27] * t894
            - self.constants[23] * t815;
        t908 = t905 - t839 * t843 - t505 * t850 - t104 * t875;
        t910 = t179 * t777;
        t918 = t36 * t454 + t179 * t474 - t172 * t786 - t188 * t469;
        t927 = t51 * t188 - t146 * t179;
        t931 = t188 * t482 - t179 * t484;
        t942 = speeds[2] * t910 + t780 * t918 + t569 * t799 + t577 * t801 + t162 * t808
            + t835 * t927;
        t947 = t942 + t588 * t854 + t191 * t888 - self.constants[24] * t815
            - self.constants[23] * t824 - t843 * t931;
        t950 = t947 - t584 * t850 - t181 * t875 - t48 * t894;
        t956 = t7 * t888 + t12 * t894;
        t958 = t12 * t824 + t956 - t7 * t815;
        t966 = t12 * t888 - t12 * t815 - t7 * t824 - t7 * t894;
        t968 = self.constants[20] * t958 + self.constants[19] * t966;
        t970 = t161 * t950 + t968 - t65 * t908;
        t972 = t20 * t785;
        t981 = t780 * t972 + t623 * t801 + t28 * t875 + t96 * t888 - t55 * t894;
        t988 = t968 + t229 * t950 - self.constants[20] * t956 - self.constants[19] * t981
            - t227 * t908;
        t999 = self.constants[25] * t956 + t242 * t981 + self.constants[23] * t958
            + t287 * t950 - self.constants[24] * t966 - t284 * t908;
        t1000 = t123 * t776;
        t1005 = sin_phi * t548;
        t1017 = speeds[2] * t1000 + t447 * t799 + t71 * t863 + t843 * t1005 + t652 * t854
            + self.constants[19] * t958;
        t1022 = t1017 + t311 * t950 - t548 * t835 - t538 * t850
            - self.constants[20] * t966 - t309 * t908;
        t1030 = t776 * (t123 * t474 + t514 * t797 - t36 * t469 - t141 * t805);
        t1031 = t776 * t1030;
        t1032 = speeds[1] * t1031;
        t1036 = t776 * (self.constants[7] * t123 + t506 * t797);
        t1037 = t776 * t1036;
        t1039 = t25 * t785;
        t1044 = t776 * (t517 * t797 - t147 * t805);
        t1045 = t776 * t1044;
        t1058 = t780 * t1039 + t665 * t801 + t320 * t888 + self.constants[20] * t981
            + t330 * t950 - t1032;
        t1063 = t1058 - speeds[2] * t1037 - speeds[0] * t1045 - t318 * t875
            - self.constants[19] * t956 - t328 * t908;
        t1067 = sin_delta * self.constants[41];
        t1068 = sin_delta * t1067;
        t1072 = self.constants[32] + self.constants[36] + self.constants[43] - t1068;
        t1074 = cos_delta * self.constants[34];
        t1075 = self.constants[23] * t1074;
        t1078 = t1075 + t1075 + self.constants[46];
        t1081 = self.constants[33] + self.constants[39];
        t1082 = t1078 + t1081;
        t1083 = t1082 - t1072;
        t1084 = t7 * t7;
        t1086 = t7 * t12;
        t1088 = self.constants[24] * t1074;
        t1092 = cos_delta * self.constants[37];
        t1093 = self.constants[30] + t1092;
        t1096 = t1093 - self.constants[44] - t1088 - self.constants[45];
        t1097 = t1096 + t1096;
        t1099 = t1083 * t1084 + t1086 * t1097;
        t1104 = t1074 + self.constants[42];
        t1105 = self.constants[28] + t1104;
        t1107 = t12 * self.constants[47] - t7 * t1105;
        t1108 = self.constants[7] * t1107;
        t1111 = self.constants[49] - t1108 - t1108;
        t1112 = sin_delta * self.constants[37];
        t1113 = sin_delta * self.constants[34];
        t1115 = t1112 - self.constants[24] * t1113;
        t1119 = cos_delta * t1067 - self.constants[23] * t1113;
        t1121 = t7 * t1115 + t12 * t1119;
        t1123 = t147 - sin_phi * t517;
        t1133 = t1096 + t1083 * t1086
            + self.constants[7] * (t7 * self.constants[47] + t12 * t1105)
            - t1084 * t1097;
        t1134 = cos_phi * t517;
        t1142 = t1068 + self.constants[43] + t1078 + t1111 + self.constants[31]
            + self.constants[38];
        t1146 = self.constants[7] * t1113;
        t1148 = t12 * t1115 + t1146 - t7 * t1119;
        t1154 = t1082 - t1099;
        t1160 = t1123 * self.constants[21];
        t1164 = t7 * sin_delta;
        t1168 = t1044 + cos_delta * t1123 - t12 * sin_delta - t1134 * t1164;
        t1170 = t1168 * self.constants[22];
        t1176 = t1072 + t1099 + t1111 + t1121 * t1123
            + t1123 * (t1121 + t1123 * t1142 - t1134 * t1148) + t1123 * t1160;
        t1179 = t1176 + t1168 * t1170 - t1133 * t1134
            - t1134 * (t1133 + t1123 * t1148 - t1134 * t1154);
        t1180 = self.constants[0].like(1.0) / t1179;
        t1185 = speeds[0] * t517 + speeds[1] * t514 + speeds[2] * t506;
        t1186 = sin_phi * t1185;
        t1187 = t298 - t1186;
        t1188 = t12 * speeds[0];
        t1189 = cos_phi * t1185;
        t1191 = t1188 + t7 * t1189;
        t1192 = self.constants[30] * t1191;
        t1194 = t7 * speeds[0];
        t1195 = t1194 - t12 * t1189;
        t1197 = t1192 + self.constants[33] * t1195;
        t1200 = speeds[2] + t1187;
        t1202 = self.constants[31] * t1187 + self.constants[21] * t1200;
        t1204 = t1187 * t1197 - t1195 * t1202;
        t1206 = self.constants[7] * t1186;
        t1207 = t1189 * t1206;
        t1209 = sin_phi * self.constants[40];
        t1210 = t299 * t1189;
        t1213 = t1207 - self.constants[7] * t1210;
        t1214 = t1209 + t1213;
        t1216 = t298 * t1195;
        t1217 = speeds[0] * t1186;
        t1218 = self.constants[24] * t1187;
        t1220 = self.constants[23] * t1187;
        t1222 = t1195 * t1218 + t1191 * t1220;
        t1224 = t298 * t1191;
        t1225 = t12 * t1217 + t1224;
        t1228 = t1216 + t7 * t1217;
        t1232 = t1222 + self.constants[23] * t1225 + self.constants[24] * t1228 - t1213;
        t1235 = self.constants[23] * t1195;
        t1236 = self.constants[24] * t1191;
        t1237 = t1235 - t1236;
        t1239 = t1187 * t1220 + t1195 * t1237;
        t1240 = speeds[0] * t1189;
        t1243 = self.constants[7] * speeds[0];
        t1244 = t1189 * t1243;
        t1245 = self.constants[7] * t1240 + t1244;
        t1248 = t299 - t1186;
        t1250 = t1206 * t1248 - speeds[0] * t1243;
        t1254 = t12 * t1245 + t7 * t1250 - t1239 - self.constants[24] * t1240;
        t1256 = speeds[1] + t1195;
        t1260 = cos_delta * t1187 - sin_delta * t1191;
        t1261 = self.constants[26] * t1260;
        t1265 = cos_delta * t1191 + sin_delta * t1187;
        t1266 = self.constants[25] * t1260;
        t1271 = speeds[1] * t1260;
        t1273 = t1271 - cos_delta * t1228 - sin_delta * t1240;
        t1275 = t30 * self.constants[10];
        t1280 = speeds[0] * t1044 + speeds[1] * t1030 + speeds[2] * t1036;
        t1282 = t1225 + t1265 * t1280;
        t1284 = t27 * self.constants[10];
        t1286 = t1273 - t1256 * t1280;
        t1288 = t26 * t40;
        t1291 = t30 * t1265 + t27 * t1256;
        t1292 = t1288 * t1291;
        t1293 = t27 * t1292;
        t1294 = self.constants[10] * t1293;
        t1296 = t30 * t1292;
        t1297 = self.constants[10] * t1296;
        t1303 = cos_delta * t1232 + t1256 * t1261 + t1265 * t1266
            + self.constants[25] * t1225 + t1275 * t1282 + t1256 * t1294;
        t1307 = t1303 + t1265 * t1297 - sin_delta * t1254 - self.constants[26] * t1273
            - t1284 * t1286;
        t1312 = self.constants[25] * t1256;
        t1313 = self.constants[26] * t1265;
        t1314 = t1312 - t1313;
        t1318 = speeds[1] * t1265;
        t1320 = sin_delta * t1228 - cos_delta * t1240 - t1318;
        t1323 = t1260 + t1280;
        t1327 = t30 * t1256 - t27 * t1265;
        t1328 = self.constants[10] * t1327;
        t1334 = cos_delta * t1254 + sin_delta * t1232 + self.constants[26] * t1320
            + t1284 * t1320 - t1260 * t1266 - t1256 * t1314;
        t1336 = t1334 - t1297 * t1323 - t1256 * t1328;
        t1340 = t1191 * t1237 - t1187 * t1218;
        t1354 = t1340 + self.constants[23] * t1240 + t7 * t1245 + t1265 * t1314
            + t1265 * t1328 - t12 * t1250;
        t1358 = t1354 - t1260 * t1261 - self.constants[25] * t1320 - t1275 * t1320
            - t1294 * t1323;
        t1360 = t30 * t1336 + t27 * t1358;
        t1365 = t53 * (t40 * t1307 + t25 * t1360);
        t1369 = t443 * (t25 * t1307 + t486 * t1365 - t40 * t1360);
        t1371 = t1217 - cos_phi * t1369;
        t1373 = t1216 + t7 * t1371;
        t1376 = t1224 + t12 * t1371;
        t1380 = self.constants[30] * t1195;
        t1381 = self.constants[32] * t1191 + t1380;
        t1383 = t1191 * t1202 - t1187 * t1381;
        t1388 = t1222 + self.constants[23] * t1376 + self.constants[24] * t1373 - t1214;
        t1391 = t1240 - t1365;
        t1392 = sin_phi * t1369 + t1391;
        t1395 = self.constants[7] * t1392 + t1244;
        t1398 = t1250 + cos_phi * self.constants[40];
        t1399 = t7 * t1398;
        t1400 = t1399 + t12 * t1395;
        t1402 = t1400 - self.constants[24] * t1392 - t1239;
        t1404 = cos_delta * t1388 - sin_delta * t1402;
        t1409 = t1271 - sin_delta * t1392 - cos_delta * t1373;
        t1414 = self.constants[38] * t1260 + self.constants[22] * t1323;
        t1417 = self.constants[37] * t1256;
        t1418 = self.constants[36] * t1265 + t1417;
        t1420 = t1265 * t1414 - t1260 * t1418;
        t1423 = self.constants[34] * t1404 + self.constants[37] * t1409
            + self.constants[39] * t1376 + t1420;
        t1427 = cos_delta * t1402 + sin_delta * t1388;
        t1433 = sin_delta * t1373 - cos_delta * t1392 - t1318;
        t1435 = self.constants[34] * t1260;
        t1437 = self.constants[34] * t1256;
        t1438 = t1265 * self.constants[35];
        t1439 = t1437 - t1438;
        t1441 = t1260 * t1435 + t1256 * t1439;
        t1443 = self.constants[17] * t1427 + self.constants[35] * t1433 - t1441;
        t1448 = t1260 * self.constants[35];
        t1451 = t1256 * t1448 + t1265 * t1435;
        t1454 = t1404 * self.constants[17] + self.constants[34] * t1376 + t1451
            - t1409 * self.constants[35];
        t1456 = sin_delta * t1443 + cos_delta * t1454;
        t1462 = self.constants[33] * t1376 + t1383 + t1423 + self.constants[23] * t1456
            - self.constants[28] * t1214 - self.constants[30] * t1373;
        t1470 = self.constants[37] * t1265;
        t1472 = t1470 + self.constants[39] * t1256;
        t1475 = t1260 * t1472 - t1256 * t1414;
        t1478 = self.constants[36] * t1409 + self.constants[37] * t1376 + t1475
            - t1404 * self.constants[35];
        t1482 = t12 * t1398;
        t1484 = t1482 - t7 * t1395;
        t1486 = t1340 + self.constants[23] * t1392 - t1484;
        t1496 = t776 * (t30 * t1358 + t797 * t1369 - t27 * t1336 - t805 * t1365);
        t1498 = self.constants[22] * (t1433 + t1496);
        t1501 = t1256 * t1418 - t1265 * t1472;
        t1505 = t1427 * self.constants[35] + self.constants[38] * t1433 + t1498 + t1501
            - self.constants[34] * t1486;
        t1512 = t1204 + self.constants[29] * t1214 + self.constants[30] * t1376
            + cos_delta * t1478 - self.constants[32] * t1373 - sin_delta * t1505;
        t1513 = t1512 - self.constants[24] * t1456;
        t1519 = t1187 * self.constants[29];
        t1521 = self.constants[28] * t1187;
        t1523 = t1195 * t1519 + t1191 * t1521;
        t1528 = self.constants[7]
            * (t1456 + self.constants[28] * t1376 + self.constants[29] * t1373 + t1523
                - t1214 * self.constants[1]);
        t1534 = t1195 * t1381 - t1191 * t1197;
        t1539 = cos_delta * t1443 - sin_delta * t1454;
        t1545 = t1265 * t1439 - t1260 * t1448;
        t1547 = self.constants[17] * t1486 + t1545 - self.constants[34] * t1433;
        t1552 = self.constants[28] * t1195;
        t1553 = t1191 * self.constants[29];
        t1554 = t1552 - t1553;
        t1557 = t1191 * t1554 - t1187 * t1519;
        t1566 = t1187 * t1521 + t1195 * t1554;
        t1571 = t7
            * (t1547 + t1557 - t1484 * self.constants[1] + self.constants[28] * t1392)
            + t12
                * (t1539 + t1400 * self.constants[1] - self.constants[29] * t1392
                    - t1566);
        t1573 = self.constants[21] * t1392 + self.constants[7] * t1571;
        t1578 = self.constants[29] * t1400 + self.constants[28] * t1484
            - self.constants[31] * t1392 + t1534 + sin_delta * t1478 + cos_delta * t1505;
        t1581 = t1578 + self.constants[24] * t1539 - t1573 - self.constants[23] * t1547;
        t1585 = t12 * t1462 - t7 * t1513;
        t1592 = forces[0] + t1134 * t1585 - t7 * t1462 - t12 * t1513 - t1528
            - t1123 * t1581;
        t1593 = t1592 - t1044 * t1498;
        t1595 = t1075 + self.constants[39];
        t1597 = t1092 - t1088;
        t1601 = t141 - sin_phi * t514;
        t1603 = cos_phi * t514;
        t1605 = t12 * t1113;
        t1606 = self.constants[7] * t1605;
        t1607 = t1115 + t1606;
        t1611 = t1607 + t1142 * t1601 - t1148 * t1603;
        t1615 = t12 * t1595 - t7 * t1597;
        t1619 = t1615 + t1148 * t1601 - t1154 * t1603;
        t1625 = t1164 * t1603 - t1030 - cos_delta * t1601;
        t1631 = t7 * t1595 + t12 * t1597 + self.constants[7] * t1074 + t1121 * t1601
            + t1123 * t1611 + t1160 * t1601;
        t1635 = t1180 * (t1631 - t1133 * t1603 - t1134 * t1619 - t1170 * t1625);
        t1640 = self.constants[21] * t1601;
        t1642 = self.constants[22] * t1625;
        t1644 = t1179 * t1635;
        t1650 = self.constants[39] + t1601 * t1611 + t1601 * t1607 + t1601 * t1640
            + t1625 * t1642 - t1603 * t1619;
        t1652 = t1650 - t1603 * t1615 - t1635 * t1644;
        t1653 = self.constants[0].like(1.0) / t1652;
        t1663 = forces[1] + t1585 * t1603 - t1423 - t1581 * t1601 - t1030 * t1498
            - t1593 * t1635;
        let (
            t1667, t1668, t1670, t1673, t1678, t1683, t1688, t1700, t1701, t1707, t1710, t1720,
            t1728, t1738, t1742, t1743, t1745, t1749, t1750, t1753, t1761, t1763, t1766, t1771,
            t1777, t1784, t1786, t1788, t1790, t1792, t1794, t1799, t1801, t1805, t1809, t1813,
            t1815, t1820, t1828, t1829, t1833, t1838, t1845, t1847, t1853, t1854, t1859, t1862,
            t1863, t1877, t1879, t1881, t1882, t1884, t1886, t1887, t1889, t1890, t1892, t1895,
            t1898, t1900, t1901, t1902, t1904, t1905, t1907, t1909, t1913, t1916, t1918, t1920,
            t1922, t1924, t1925, t1926, t1930, t1935, t1937, t1939, t1942, t1943, t1947, t1952,
            t1958, t1959, t1961, t1963, t1964, t1965, t1968, t1969, t1977, t1985, t1993, t1999,
            t2000, t2007, t2010, t2012, t2013, t2016, t2018, t2024, t2027, t2029, t2033, t2039,
            t2045, t2046, t2048, t2050, t2053, t2055, t2060, t2064, t2066, t2075, t2081, t2083,
            t2085, t2086, t2088, t2091, t2095, t2102, t2104, t2105, t2107, t2109, t2110, t2111,
            t2113, t2116, t2118, t2120, t2123, t2126, t2128, t2131, t2135, t2139, t2144, t2145,
            t2146, t2149, t2152, t2157, t2160, t2164, t2166, t2168, t2171, t2174, t2176, t2177,
            t2179, t2181, t2184, t2185, t2187, t2188, t2189, t2190, t2191, t2194, t2198, t2200,
            t2203, t2205, t2207, t2209, t2210, t2213, t2215, t2219, t2220, t2223, t2226, t2230,
            t2232, t2234, t2237, t2245, t2246, t2250, t2252, t2253, t2254, t2257, t2260, t2262,
            t2265, t2267, t2269, t2272, t2273, t2277, t2280, t2282, t2287, t2289, t2290, t2295,
            t2298, t2299, t2304, t2308, t2310, t2313, t2317, t2319, t2320, t2322, t2323, t2326,
            t2332, t2337, t2342, t2343, t2346, t2350, t2354, t2358, t2366, t2370, t2376, t2380,
            t2383, t2386, t2389, t2396, t2404, t2406, t2408, t2410, t2415, t2418, t2421, t2427,
            t2432, t2437, t2439, t2441, t2443, t2444, t2446, t2450, t2458, t2459,
        );
        t1667 = self.constants[7] * (t1107 - self.constants[48]);
        t1668 = sin_phi * t506;
        t1670 = cos_phi * t506;
        t1673 = t1667 + t1142 * t1668 + t1148 * t1670;
        t1678 = t1146 - t1148 * t1668 - t1154 * t1670;
        t1683 = self.constants[0].like(1.0) - t1668;
        t1688 = t1164 * t1670 + cos_delta * t1668 - t1036;
        t1700 = t1160 * t1683 - t1121 * t1668 - t1133 * t1670 - t1123 * t1673
            - t1134 * t1678 - t1170 * t1688;
        t1701 = t1180 * t1700;
        t1707 = t1606 + t1640 * t1683 + t1642 * t1688 - t1601 * t1673 - t1603 * t1678
            - t1607 * t1668;
        t1710 = t1653 * (t1707 - t1615 * t1670 - t1644 * t1701);
        t1720 = t1581 * t1668 + t1585 * t1670 + t1573 - t1036 * t1498 - t1593 * t1701
            - t1663 * t1710;
        t1728 = self.constants[22] * t1688;
        t1738 = t1668 * t1673 + t1667 * t1668 + self.constants[50]
            + self.constants[21] * t1683 * t1683 + t1688 * t1728 - t1670 * t1678;
        t1742 = self.constants[0].like(1.0)
            / (t1738 - t1146 * t1670 - t1179 * t1701 * t1701 - t1652 * t1710 * t1710);
        t1743 = t1720 * t1742;
        t1745 = t1653 * t1663 - t1710 * t1743;
        t1749 = t1180 * t1593 - t1635 * t1745 - t1701 * t1743;
        t1750 = t1210 + t1749;
        t1753 = t1207 + t1209 - self.constants[7] * t1750;
        t1761 = t1369 + t517 * t1749 + t514 * t1745 + t506 * t1743;
        t1763 = t1217 - cos_phi * t1761;
        t1766 = t12 * t1749 - t1216 - t7 * t1763;
        t1771 = t1224 + t12 * t1763 + t7 * t1749;
        t1777 = t1222 + self.constants[23] * t1771 - t1753 - self.constants[24] * t1766;
        t1784 = t147 * t1749 + t141 * t1745 - sin_phi * t1761 - t1391;
        t1786 = t1743 + t1784;
        t1788 = self.constants[7] * t1786 - t1244;
        t1790 = t1399 - t12 * t1788;
        t1792 = self.constants[24] * t1784 + t1790 - t1239;
        t1794 = cos_delta * t1777 - sin_delta * t1792;
        t1799 = t1271 + cos_delta * t1766 + sin_delta * t1784;
        t1801 = t1745 + t1771;
        t1805 = t1475 + self.constants[36] * t1799 + self.constants[37] * t1801
            - self.constants[35] * t1794;
        t1809 = cos_delta * t1792 + sin_delta * t1777;
        t1813 = t1482 + t7 * t1788;
        t1815 = t1340 - self.constants[23] * t1784 - t1813;
        t1820 = cos_delta * t1784 - t1318 - sin_delta * t1766;
        t1828 = t1496 + t1820 + t1044 * t1749 + t1030 * t1745 + t1036 * t1743;
        t1829 = self.constants[22] * t1828;
        t1833 = t1501 + self.constants[35] * t1809 + self.constants[38] * t1820 + t1829
            - self.constants[34] * t1815;
        t1838 = self.constants[17] * t1809 + self.constants[35] * t1820 - t1441;
        t1845 = t1451 + self.constants[17] * t1794 + self.constants[34] * t1801
            - self.constants[35] * t1799;
        t1847 = sin_delta * t1838 + cos_delta * t1845;
        t1853 = t1204 + self.constants[29] * t1753 + self.constants[32] * t1766
            + self.constants[30] * t1771 + cos_delta * t1805 - sin_delta * t1833;
        t1854 = t1853 - self.constants[24] * t1847;
        t1859 = cos_delta * t1838 - sin_delta * t1845;
        t1862 = self.constants[1] * t1790 + self.constants[29] * t1784 + t1859 - t1566;
        t1863 = self.constants[7] * t1862;
        t1877 = t1383 + t1420 + self.constants[30] * t1766 + self.constants[33] * t1771
            + self.constants[34] * t1794 + self.constants[37] * t1799
            + self.constants[39] * t1801;
        t1879 = t1877 + self.constants[23] * t1847 - self.constants[28] * t1753;
        t1881 = t776 * self.constants[22];
        t1882 = t1358 * t1881;
        t1884 = t1336 * t1881;
        t1886 = t797 * t1881;
        t1887 = t443 * t1307;
        t1889 = t40 * t443;
        t1890 = t1336 * t1889;
        t1892 = t1358 * t1889;
        t1895 = t93 * t1887 + t94 * t1890 - t100 * t1892;
        t1898 = t1886 * t1895 - t94 * t1882 - t100 * t1884;
        t1900 = t12 * self.constants[7];
        t1901 = self.constants[1] * t1900;
        t1902 = self.constants[29] - t1901;
        t1904 = t7 * t1113;
        t1905 = cos_delta * self.constants[35];
        t1907 = sin_delta * self.constants[35];
        t1909 = cos_delta * t1907 - sin_delta * t1905;
        t1913 = sin_delta * t1907 + cos_delta * t1905;
        t1916 = t1605 + t7 * t1909;
        t1918 = sin_delta * self.constants[17];
        t1920 = cos_delta * self.constants[23];
        t1922 = cos_delta * self.constants[24];
        t1924 = sin_delta * self.constants[24];
        t1925 = sin_delta * t1900;
        t1926 = t1925 - t1924;
        t1930 = t12 * t1920 + t7 * t1922;
        t1935 = t12 * t1922 + t1134 * t1930 - cos_delta * self.constants[7] - t7 * t1920
            - t1123 * t1926;
        t1937 = cos_delta * self.constants[17];
        t1939 = sin_delta * self.constants[23];
        t1942 = cos_delta * t1900;
        t1943 = t1922 - t1942;
        t1947 = t12 * t1939 + t7 * t1924;
        t1952 = t12 * t1924 + t1134 * t1947 - sin_delta * self.constants[7] - t7 * t1939
            - t1123 * t1943;
        t1958 = t1904 + t1937 * t1952 - t12 * t1909 - t1123 * t1913 - t1134 * t1916
            - t1918 * t1935;
        t1959 = t1958 - t1123 * t1902;
        t1961 = t7 * self.constants[7];
        t1963 = self.constants[17] * t1961;
        t1964 = self.constants[1] * t1961 + t1963;
        t1965 = t1964 + t1105;
        t1968 = t1605 + t1134 * t1904;
        t1969 = t1968 - t1123 * t1965;
        t1977 = t12 * t1081 - t7 * t1093;
        t1985 = t12 * t1074 + t7 * t1913;
        t1993 = t12 * t1913 + t1134 * t1985 + t1935 * t1937 + t1918 * t1952 - t7 * t1074
            - t1123 * t1909;
        t1999 = t1134 * t1977 + self.constants[34] * t1935 + self.constants[23] * t1993
            - self.constants[7] * self.constants[28] - t7 * t1081 - t12 * t1093;
        t2000 = t1999 - t1112 * t1123;
        t2007 = t12 * self.constants[30] - t7 * self.constants[32];
        t2010 = sin_delta * self.constants[38];
        t2012 = self.constants[23] * self.constants[34];
        t2013 = self.constants[34] * t1961;
        t2016 = t2012 + t2013 + cos_delta * self.constants[38];
        t2018 = t7 * t2010;
        t2024 = t12 * t2010 + t1134 * t2018 + self.constants[35] * t1952 - t1170
            - t1123 * t2016;
        t2027 = cos_delta * self.constants[36];
        t2029 = sin_delta * self.constants[36];
        t2033 = t12 * self.constants[37] - t7 * t2027;
        t2039 = t1134 * t2033 - t7 * self.constants[37] - t12 * t2027 - t1123 * t2029
            - self.constants[35] * t1935;
        t2045 = self.constants[7] * self.constants[29] + t1134 * t2007
            + cos_delta * t2039 - t7 * self.constants[30] - t12 * self.constants[32]
            - self.constants[24] * t1993;
        t2046 = t2045 - sin_delta * t2024;
        t2048 = t7 * t145;
        t2050 = t12 * t145;
        t2053 = sin_delta * t2012;
        t2055 = self.constants[31] + self.constants[21];
        t2060 = self.constants[29] * t1900 - self.constants[28] * t1961
            - self.constants[42] * t1961;
        t2064 = self.constants[46] + t2055 + cos_delta * t2012 - t2060;
        t2066 = t7 * t2053;
        t2075 = t12 * t2053 + t1134 * t2066 + self.constants[24] * t1958
            + cos_delta * t2024 + sin_delta * t2039 - t1123 * t2064;
        t2081 = t1959 * t2050 + t16 * t2046 - t1969 * t2048 - t13 * t2000
            - sin_phi * t2075;
        t2083 = t53 * t1360;
        t2085 = t25 * t53;
        t2086 = t1336 * t2085;
        t2088 = t1358 * t2085;
        t2091 = t93 * t2083 + t100 * t2088 - t94 * t2086;
        t2095 = t487 * t1886 - t805 * t1881;
        t2102 = t2075 + t1961 * t1969 + t487 * t2081 - t1168 * t2095 - t1900 * t1959;
        t2104 = self.constants[10] * t1320;
        t2105 = self.constants[10] * t1256;
        t2107 = t1265 * t2105 - t2104;
        t2109 = self.constants[10] * t1292;
        t2110 = t1323 * t2109;
        t2111 = self.constants[10] * t1265;
        t2113 = t2110 + t1265 * t2111;
        t2116 = t1250 + t94 * t2107 + t100 * t2113;
        t2118 = t27 * t1889;
        t2120 = t30 * t1881 - t1886 * t2118;
        t2123 = t27 * t2085;
        t2126 = t2102 * t2123 - t1168 * t2120 - t2081 * t2118;
        t2128 = self.constants[25] + t1275;
        t2131 = self.constants[23] * t1217;
        t2135 = self.constants[10] * t1282 + t1265 * t2109;
        t2139 = t1256 * t2109 - self.constants[10] * t1286;
        t2144 = t1217 * t2128 + cos_delta * t2131 + t100 * t2139 - sin_delta * t1245
            - t94 * t2135;
        t2145 = t25 * t443;
        t2146 = t1886 * t2145;
        t2149 = t40 * t53;
        t2152 = t2081 * t2145 + t2102 * t2149 - t1168 * t2146;
        t2157 = t2110 + t1256 * t2105;
        t2160 = t2104 + t1256 * t2111;
        t2164 = cos_delta * t1245 + sin_delta * t2131 + t94 * t2157 + t100 * t2160;
        t2166 = t30 * t1889;
        t2168 = t27 * t1881 + t1886 * t2166;
        t2171 = t30 * t2085;
        t2174 = t1168 * t2168 + t2102 * t2171 - t2081 * t2166;
        t2176 = t26 * t1291;
        t2177 = t1288 * t2176;
        t2179 = t1265 * t1288;
        t2181 = t1256 * t1288;
        t2184 = t100 * t2181 - t93 * t2177 - t94 * t2179;
        t2185 = t1284 * t1323;
        t2187 = t1256 * t1284;
        t2188 = t1265 * t1275;
        t2189 = t2187 + t2188;
        t2190 = t2152 * t2189;
        t2191 = t1275 * t1323;
        t2194 = t2190 - t2126 * t2185 - t2174 * t2191;
        t2198 = self.constants[38] + self.constants[22];
        t2200 = t1265 * t2198 - t1418;
        t2203 = t1414 - self.constants[36] * t1260;
        t2205 = cos_delta * t2203 - sin_delta * t2200;
        t2207 = t1202 + t2205 - self.constants[32] * t1187;
        t2209 = self.constants[30] * t1187;
        t2210 = self.constants[37] * t1260;
        t2213 = t1472 - t1256 * t2198;
        t2215 = cos_delta * t2210 - sin_delta * t2213;
        t2219 = self.constants[36] * t1256 - t1470 - t1472;
        t2220 = cos_delta * t2219;
        t2223 = t2209 + cos_delta * t2215 - sin_delta * t2220;
        t2226 = t1195 * self.constants[29];
        t2230 = t1448 + t1448;
        t2232 = t1439 - t1438;
        t2234 = sin_delta * t2230 + cos_delta * t2232;
        t2237 = t1900 * t2226 + t1961 * (t1554 - t1553) + t1961 * t2234;
        t2245 = self.constants[32] * t1195 + sin_delta * t2215 + cos_delta * t2220
            - t1192 - t1197 - t2237;
        t2246 = t2245 - self.constants[23] * t2234;
        t2250 = t12 * t2207 - t7 * t2223;
        t2252 = t1256 * self.constants[35];
        t2253 = self.constants[34] * t1265;
        t2254 = t2252 + t2253;
        t2257 = cos_delta * t1435 - sin_delta * t2254;
        t2260 = t1435 + t1435;
        t2262 = cos_delta * t2252 + sin_delta * t2260;
        t2265 = self.constants[24] * t1195;
        t2267 = cos_delta * speeds[1];
        t2269 = sin_delta * speeds[1];
        t2272 = t1261 + t1294;
        t2273 = t1261 + t2272;
        t2277 = t1314 + t1328;
        t2280 = speeds[1] * t2128 + t2277 - t1313 - t1265 * t1284;
        t2282 = sin_delta * t2273 + cos_delta * t2280;
        t2287 = t1220 + self.constants[23] * t298;
        t2289 = t1256 * self.constants[26];
        t2290 = self.constants[25] * t1265;
        t2295 = t2289 + t2290 - speeds[1] * self.constants[26] - speeds[1] * t1284;
        t2298 = t1266 + t1297;
        t2299 = t1275 * t1280 + t2298;
        t2304 = t298 * t2128 + cos_delta * t2287 + cos_delta * t2299 - sin_delta * t2265
            - sin_delta * t2295;
        t2308 = t1266 + t2298;
        t2310 = self.constants[26] + t1284;
        t2313 = t2187 + t2289 - speeds[1] * t2310;
        t2317 = cos_delta * t2265 + sin_delta * t2287 + sin_delta * t2308
            + cos_delta * t2313;
        t2319 = t30 * t1288;
        t2320 = cos_delta * t2319;
        t2322 = t1237 - t1236;
        t2323 = t1104 + t1963;
        t2326 = t2126 + t1123 * t2323 - t1968;
        t2332 = t1134 * t2250 + t1935 * t2257 + t1952 * t2262 + t1220 * t1993
            + t1958 * t2265 + t298 * t2000;
        t2337 = t2332 + t2126 * t2282 + t2152 * t2304 + t2174 * t2317 + t2194 * t2320
            + t2322 * t2326;
        t2342 = t2337 - self.constants[7] * t1521 - t7 * t2207 - t12 * t2223
            - t1123 * t2246 - t2024 * t2267;
        t2343 = t2342 - t2039 * t2269;
        t2346 = t2209 + t2210;
        t2350 = self.constants[39] * t1260 - t1414;
        t2354 = t1417 + t1418 - self.constants[39] * t1265;
        t2358 = self.constants[33] * t1187 + cos_delta * t2350 - t1202
            - sin_delta * t2354;
        t2366 = self.constants[28] * t1191;
        t2370 = t1961 * t2366 + t1961 * t2253 - t1900 * (t1552 + t1554);
        t2376 = t1380 + t1381 + sin_delta * t2350 + cos_delta * t2354
            - self.constants[33] * t1191 - self.constants[23] * t2253 - t2370;
        t2380 = t12 * t2346 + t7 * t2358;
        t2383 = t1437 + t1439;
        t2386 = t1235 + t1237;
        t2389 = t2188 + t2290;
        t2396 = t2272 + cos_delta * t1218 + t1280 * t1284 + sin_delta * t2386;
        t2404 = sin_delta * t1218 - t1312 - t2277 - cos_delta * t2386 - t1256 * t1275;
        t2406 = t27 * t1288;
        t2408 = self.constants[23] * t1191;
        t2410 = sin_delta * t2128;
        t2415 = t1922 + cos_delta * self.constants[26] + cos_delta * t1284;
        t2418 = t1924 + sin_delta * t2310;
        t2421 = t2152 * t2415 + t2174 * t2418 - t2126 * t2410;
        t2427 = t7 * t2346 + t1448 * t1935 + t1218 * t1993 + t2126 * t2389
            + t2152 * t2396 + t2174 * t2404;
        t2432 = t2427 + t2194 * t2406 + t2326 * t2408 + t298 * t2421
            - self.constants[7] * t1519 - t12 * t2358;
        t2437 = t2432 - t1123 * t2376 - t1134 * t2380 - t1952 * t2383 - t1958 * t2386
            - t298 * t2046;
        t2439 = self.constants[22] * t1743;
        t2441 = self.constants[22] * t1265;
        t2443 = self.constants[22] * t1256;
        t2444 = cos_delta * t2443;
        t2446 = sin_delta * t2443;
        t2450 = t12 * t2441 + t7 * t2444;
        t2458 = t2190 + t12 * t2444 + t1123 * t2446 + t1134 * t2450 - t7 * t2441
            - t1294 * t2126;
        t2459 = t2458 - t1297 * t2174;
        let (
            t2461, t2463, t2464, t2467, t2471, t2472, t2474, t2476, t2481, t2487, t2492, t2494,
            t2496, t2498, t2505, t2507, t2510, t2519, t2522, t2526, t2532, t2536, t2545, t2553,
            t2555, t2560, t2562, t2566, t2574, t2577, t2583, t2587, t2591, t2595, t2597, t2599,
            t2605, t2613, t2621, t2623, t2625, t2631, t2636, t2641, t2649, t2654, t2657, t2661,
            t2667, t2669, t2670, t2672, t2674, t2676, t2679, t2682, t2684, t2685, t2687, t2688,
            t2690, t2700, t2705, t2707, t2713, t2719, t2721, t2725, t2729, t2733, t2735, t2740,
            t2742, t2743, t2758, t2764, t2767, t2773, t2777, t2783, t2789, t2794, t2796, t2797,
            t2804, t2809, t2810, t2812, t2814, t2816, t2819, t2821, t2823, t2825, t2835, t2840,
            t2843, t2853, t2855, t2857, t2869, t2871, t2877, t2883, t2888, t2893, t2898, t2904,
            t2907, t2909, t2921, t2924, t2938, t2943, t2949, t2955, t2963, t2986, t2991, t2996,
            t3001, t3006, t3011, t3013, t3014, t3015, t3017, t3018, t3023, t3025, t3027, t3029,
            t3030, t3032, t3033, t3034, t3038, t3040, t3044, t3046, t3056, t3061, t3064, t3068,
            t3072, t3073, t3074, t3075, t3076, t3077, t3078, t3080, t3082, t3084, t3086, t3088,
            t3092, t3096, t3097, t3098, t3100, t3102, t3103, t3104, t3106, t3110, t3114, t3118,
            t3121, t3122, t3123, t3126, t3127, t3130, t3134, t3138, t3140, t3141, t3142, t3148,
            t3150, t3153, t3158, t3162, t3164, t3166, t3168, t3172, t3176, t3181, t3183, t3184,
            t3188, t3192, t3195, t3201, t3205, t3207, t3210, t3211, t3213, t3215, t3217, t3219,
            t3223, t3225, t3226, t3232, t3237, t3242, t3245, t3247, t3257, t3261, t3266, t3267,
            t3270, t3271, t3283, t3288, t3297, t3304, t3308, t3321, t3327, t3336, t3342, t3348,
            t3354, t3357, t3360, t3377, t3383, t3388, t3392, t3410, t3416, t3421, t3424, t3435,
            t3437, t3443, t3449, t3465, t3485, t3490, t3493, t3501, t3506, t3509,
        );
        t2461 = speeds[2] * t2459 - t1168 * t2439;
        t2463 = self.constants[22] * t1745;
        t2464 = t776 * t2463;
        t2467 = t780 * t2459 - t1168 * t2464;
        t2471 = cos_phi * (t1243 + t1243);
        t2472 = t12 * t2471;
        t2474 = t7 * t2471;
        t2476 = self.constants[7] * t1189;
        t2481 = sin_phi * t2476 - cos_phi * (self.constants[7] * t299 - t1206);
        t2487 = t12 * self.constants[28] + t7 * self.constants[29];
        t2492 = self.constants[7] * self.constants[1] + t7 * self.constants[28] - t1993
            - t12 * self.constants[29] - t1134 * t2487;
        t2494 = sin_phi * t1188;
        t2496 = cos_phi * speeds[0];
        t2498 = sin_phi * t1194;
        t2505 = cos_delta * t2496;
        t2507 = cos_phi * (t7 * t1243 + speeds[0] * (self.constants[23] + t1961))
            + t2128 * t2505;
        t2510 = sin_delta * speeds[0];
        t2519 = cos_phi * (t12 * t1243 + speeds[0] * (t1900 - self.constants[24]));
        t2522 = self.constants[23] * t2494 - t2481;
        t2526 = t2128 * t2494 + cos_phi * (self.constants[26] * t2510 + t1284 * t2510)
            + cos_delta * t2522 - sin_delta * t2519;
        t2532 = cos_delta * t2519 + sin_delta * t2522 - t2310 * t2505;
        t2536 = sin_phi * (self.constants[7] * t1248 - t1206);
        t2545 = t12 * t1969 + t7 * t1959 + t55 * t2174 - t12 * t2126 - t1164 * t2152;
        t2553 = cos_delta * t2200 + sin_delta * t2203;
        t2555 = t1191 * t2055 + t2553 - t1381;
        t2560 = sin_delta * t2210 + cos_delta * t2213;
        t2562 = sin_delta * t2219;
        t2566 = t1197 + cos_delta * t2560 - t1195 * t2055 - sin_delta * t2562;
        t2574 = sin_delta * t2232 - cos_delta * t2230;
        t2577 = t1961 * t2574 - t1900 * (t1521 + t1521) - t1961 * (t1519 + t1519);
        t2583 = sin_delta * t2560 + cos_delta * t2562 - t2577
            - self.constants[23] * t2574;
        t2587 = t12 * t2555 - t7 * t2566;
        t2591 = sin_delta * t1435 + cos_delta * t2254;
        t2595 = sin_delta * t2252 - cos_delta * t2260;
        t2597 = t2265 + t2408;
        t2599 = t1220 + t1220;
        t2605 = sin_delta * t2280 - cos_delta * t2273;
        t2613 = sin_delta * t2599 + cos_delta * t2597 + cos_delta * t2295
            + sin_delta * t2299;
        t2621 = sin_delta * t2597 + sin_delta * t2313 - cos_delta * t2599
            - cos_delta * t2308;
        t2623 = sin_delta * t2319;
        t2625 = t1218 + t1218;
        t2631 = t1134 * t2587 + t1935 * t2591 + t1952 * t2595 + t1993 * t2597
            + t2039 * t2267 + t2126 * t2605;
        t2636 = t2631 + t2152 * t2613 + t2174 * t2621 + t2194 * t2623
            - self.constants[7] * (t2226 + t2366) - t7 * t2555;
        t2641 = t2636 - t12 * t2566 - t1123 * t2583 - t1958 * t2599 - t2024 * t2269
            - t2326 * t2625;
        t2649 = t1959 * t2472 + t2481 * t2492 + t2000 * t2494 + t2126 * t2507
            + t2152 * t2526 + t2174 * t2532;
        t2654 = t2649 + t2536 * t2545 + t2421 * t2498 + t16 * t2343 - t1969 * t2474
            - t2075 * t2496;
        t2657 = t2654 - t2046 * t2498 - sin_phi * t2641 - t13 * t2437;
        t2661 = t1743 * t2081 + speeds[2] * t2657 + t798 * t2461;
        t2667 = t1745 * t2081 + speeds[1] * t2657 + t797 * t2467;
        t2669 = self.constants[7] * t1745;
        t2670 = t12 * t2669;
        t2672 = t7 * t2669;
        t2674 = speeds[1] * t2476;
        t2676 = speeds[1] * t1191;
        t2679 = speeds[1] * t1195;
        t2682 = t2408 + t2476;
        t2684 = t1191 * t2128 + cos_delta * t2682;
        t2685 = speeds[1] * t2684;
        t2687 = sin_delta * t2682;
        t2688 = speeds[1] * t2687;
        t2690 = speeds[1] * t1206;
        t2700 = t1969 * t2672 + t2000 * t2676 + t1745 * t2075 + t2152 * t2685
            + t2174 * t2688 + t2545 * t2690;
        t2705 = t2700 + t2421 * t2679 + speeds[1] * t2641 + t487 * t2667 - t1959 * t2670
            - t2492 * t2674;
        t2707 = t2705 - t2046 * t2679 - t805 * t2467;
        t2713 = t490 * t2667 + t81 * t2707 - t810 * t2467;
        t2719 = t819 * t2467 + t498 * t2667 + t84 * t2707;
        t2721 = t1369 * t1881;
        t2725 = self.constants[22] * t1749;
        t2729 = speeds[0] * t2459 - t1829 - t1168 * t2725;
        t2733 = t829 * t2461 + t514 * t2467 + t832 * t2729 - t1168 * t2721;
        t2735 = t1365 * t1881;
        t2740 = t141 * t2467 + t841 * t2729 - t1168 * t2735;
        t2742 = t443 * t1369;
        t2743 = t1886 * t2742;
        t2758 = t1545 + self.constants[17] * t1815 - self.constants[34] * t1820;
        t2764 = t1557 + t2758 - self.constants[1] * t1813 - self.constants[28] * t1784;
        t2767 = t7 * t2764 + t12 * t1862;
        t2773 = t1534 + self.constants[29] * t1790 + self.constants[28] * t1813
            + self.constants[31] * t1784 + self.constants[21] * t1786
            + sin_delta * t1805;
        t2777 = t2773 + cos_delta * t1833 + self.constants[24] * t1859
            - self.constants[23] * t2758 - self.constants[7] * t2767;
        t2783 = sin_phi * t2777 + cos_phi * (t12 * t1879 - t7 * t1854);
        t2789 = t2783 + t1749 * t2081 + speeds[0] * t2657 + t798 * t2729;
        t2794 = t2081 * t2742 + t507 * t2661 + t515 * t2667 + t518 * t2789
            - t1168 * t2743;
        t2796 = t443 * t1365;
        t2797 = t1886 * t2796;
        t2804 = t2081 * t2796 + t526 * t2667 + t528 * t2789 - t1168 * t2797;
        t2809 = self.constants[7] * t1749;
        t2810 = t12 * t2809;
        t2812 = t7 * t2809;
        t2814 = speeds[0] * t2476;
        t2816 = speeds[0] * t1191;
        t2819 = speeds[0] * t1195;
        t2821 = speeds[0] * t2684;
        t2823 = speeds[0] * t2687;
        t2825 = speeds[0] * t1206;
        t2835 = t1969 * t2812 + t2000 * t2816 + t1749 * t2075 + t2152 * t2821
            + t2174 * t2823 + t2545 * t2825;
        t2840 = t2835 + t2421 * t2819 + speeds[0] * t2641 + t487 * t2789 - t2777
            - t1959 * t2810;
        t2843 = t2840 - t2492 * t2814 - t2046 * t2819 - t860 * t2729;
        t2853 = t856 * t2467 + t532 * t2667 + t105 * t2707 + t53 * t2843 + t548 * t2740
            + t538 * t2804;
        t2855 = t2853 - t123 * t2733 - t36 * t2794;
        t2857 = t142 * t1365;
        t2869 = t2713 + t36 * t2733 + t548 * t2804 - t2102 * t2857 - t143 * t2707
            - t148 * t2843;
        t2871 = t2869 - t538 * t2740 - t123 * t2794;
        t2877 = t818 * t2467 + t497 * t2667 - sin_phi * t2855;
        t2883 = t1123 * t1863 + t1134 * t1879 + t1398 * t1969 + t1763 * t2000
            + t1749 * t2046 + t1895 * t2081;
        t2888 = t2883 + t2091 * t2102 + t2144 * t2152 + t2164 * t2174 + t2184 * t2194
            + speeds[0] * t2343;
        t2893 = t2888 + t778 * t2461 + t793 * t2467 + t445 * t2661 + t480 * t2667
            + t72 * t2707;
        t2898 = t2893 + self.constants[24] * t2719 + t828 * t2733 + t525 * t2804
            + t120 * t2871 + self.constants[27] * t2877;
        t2904 = t2898 - t1854 - t1168 * t1898 - t1788 * t1959 - t2116 * t2126
            - t1189 * t2437 - self.constants[23] * t2713;
        t2907 = t2904 - t839 * t2740 - t505 * t2794 - t104 * t2855;
        t2909 = self.constants[7] * t2764;
        t2921 = t28 * t443 * t1360 + t172 * t1887 + t174 * t1890 + t176 * t1892;
        t2924 = t174 * t1882 - t176 * t1884 - t1886 * t2921;
        t2938 = t28 * t53 * t1307 + t174 * t2086 + t176 * t2088 - t172 * t2083;
        t2943 = t1245 + t174 * t2107 - t176 * t2113;
        t2949 = t174 * t2135 + t176 * t2139 - sin_delta * t1250;
        t2955 = cos_delta * t1250 + t176 * t2160 - t174 * t2157;
        t2963 = t28 * t2176 + t172 * t2177 + t174 * t2179 + t176 * t2181;
        t2986 = t1123 * t2909 + t1398 * t1959 + t1788 * t1969 + t1749 * t2000
            + t2102 * t2938 + t2126 * t2943;
        t2991 = t2986 + t2152 * t2949 + t2174 * t2955 + t2194 * t2963 + t1217 * t2421
            + t1189 * t2343;
        t2996 = t2991 + speeds[0] * t2437 + t910 * t2461 + t918 * t2467 + t569 * t2661
            + t577 * t2667;
        t3001 = t2996 + t162 * t2707 + t927 * t2733 + t588 * t2804 + t191 * t2871
            - t1879;
        t3006 = t3001 - t1134 * t1854 - t1168 * t2924 - t1763 * t2046 - t2081 * t2921
            - self.constants[24] * t2713;
        t3011 = t3006 - self.constants[23] * t2719 - t931 * t2740 - t584 * t2794
            - t181 * t2855 - t48 * t2877;
        t3013 = t7 * t1847;
        t3014 = self.constants[34] * t1784;
        t3015 = sin_delta * t3014;
        t3017 = self.constants[17] * t1784;
        t3018 = t1961 * t3017;
        t3023 = t3018 + self.constants[23] * t3017 + cos_delta * t3014 - t2758;
        t3025 = t12 * t1847;
        t3027 = t3025 + t7 * t3015;
        t3029 = t1187 * t1191;
        t3030 = t1771 + t3029;
        t3032 = t1187 * t1187;
        t3033 = t1195 * t1195;
        t3034 = t3032 + t3033;
        t3038 = t1225 + t3029;
        t3040 = sin_delta * t3034 + cos_delta * t3038;
        t3044 = sin_delta * t3038 - cos_delta * t3034;
        t3046 = t1191 * t1195;
        t3056 = t12 * t3015 + t1134 * t3027 + t1993 * t3030 + t1240 * t2126
            + t2152 * t3040 + t2174 * t3044;
        t3061 = t3056 + t2326 * t3046 + t12 * t2871 - t3013 - t1123 * t3023
            - t1958 * t3034;
        t3064 = t3061 - t12 * t2713 - t7 * t2719 - t7 * t2877;
        t3068 = self.constants[5] - t238;
        t3072 = self.constants[20] * t3068 + self.constants[19] * self.constants[9];
        t3073 = self.constants[2] * t3072;
        t3074 = t3073 + t3073;
        t3075 = t1260 * t1265;
        t3076 = t7 * t3075;
        t3077 = t1256 * t1260;
        t3078 = cos_delta * t3077;
        t3080 = t3078 + sin_delta * t1820;
        t3082 = sin_delta * t3077;
        t3084 = cos_delta * t1820 - t3082;
        t3086 = t12 * t3075;
        t3088 = t3086 + t7 * t3080;
        t3092 = t12 * t3080 + t1134 * t3088 - t3076 - t1123 * t3084;
        t3096 = self.constants[19] * t3068 - self.constants[20] * self.constants[9];
        t3097 = self.constants[2] * t3096;
        t3098 = t3077 - t1799;
        t3100 = t1801 + t3075;
        t3102 = t1256 * t1256;
        t3103 = t1265 * t1265;
        t3104 = t3102 - t3103;
        t3106 = cos_delta * t3100 - sin_delta * t3104;
        t3110 = sin_delta * t3100 + cos_delta * t3104;
        t3114 = t12 * t3098 + t7 * t3106;
        t3118 = t12 * t3106 + t1123 * t3110 + t1134 * t3114 - t7 * t3098;
        t3121 = t1256 * t1265;
        t3122 = sin_delta * t3121;
        t3123 = cos_delta * t1799 - t3122;
        t3126 = cos_delta * t3121;
        t3127 = sin_delta * t1799 + t3126;
        t3130 = t3086 + t7 * t3123;
        t3134 = t3076 - t12 * t3123 - t1123 * t3127 - t1134 * t3130;
        t3138 = cos_delta * t1794 + sin_delta * t1809;
        t3140 = t1260 * t1260;
        t3141 = t3103 + t3140;
        t3142 = t1961 * t3141;
        t3148 = t3142 + self.constants[23] * t3141 + cos_delta * t1809
            - sin_delta * t1794;
        t3150 = t7 * t3138;
        t3153 = t1820 + t3121;
        t3158 = t12 * t3138 + t1134 * t3150 + t1935 * t3098 + t1952 * t3153
            - t1123 * t3148;
        t3162 = t3074 * t3092 + t3097 * t3118 + t3074 * t3134
            + self.constants[2] * t3158;
        t3164 = t3097 + t3097;
        t3166 = t3078 + t3122;
        t3168 = t3082 - t3126;
        t3172 = t12 * t1801 - t7 * t3166;
        t3176 = t1134 * t3172 - t7 * t1801 - t12 * t3166 - t1123 * t3168;
        t3181 = sin_delta * t1815;
        t3183 = t3121 - t1820;
        t3184 = t1961 * t3183;
        t3188 = t3184 + self.constants[23] * t3183 + cos_delta * t1815;
        t3192 = t12 * t1794 - t7 * t3181;
        t3195 = t3102 + t3140;
        t3201 = t1123 * t3188 + t1134 * t3192 + t1935 * t3100 - t7 * t1794 - t12 * t3181
            - t1952 * t3195;
        t3205 = t3164 * t3176 + t3092 * t3164 + t3073 * t3118
            + self.constants[2] * t3201;
        t3207 = self.constants[20] * t3162 + self.constants[19] * t3205;
        t3210 = t1187 * t1195;
        t3211 = t3210 - t1766;
        t3213 = t1784 + t3046;
        t3215 = t3046 - t1240;
        t3217 = t1228 + t3210;
        t3219 = cos_delta * t3217 - sin_delta * t3215;
        t3223 = cos_delta * t3215 + sin_delta * t3217;
        t3225 = t1191 * t1191;
        t3226 = t3032 + t3225;
        t3232 = t7 * t2871 + t12 * t2877;
        t3237 = t3025 + t1134 * t3013 + t1993 * t3211 + t1958 * t3213 + t2152 * t3219
            + t2174 * t3223;
        t3242 = t3237 + t12 * t2719 + t3232 - t1123 * t1859 - t2326 * t3226 - t7 * t2713;
        t3245 = self.constants[19] * t3064 + self.constants[20] * t3242 - t3207;
        t3247 = t161 * t3011 + t3245 - t65 * t2907;
        t3257 = t1603 * t1930 - t1601 * t1926;
        t3261 = t1603 * t1947 - t1601 * t1943;
        t3266 = t1113 + t1937 * t3261 - t1601 * t1913 - t1603 * t1916 - t1918 * t3257;
        t3267 = t3266 - t1601 * t1902;
        t3270 = t1603 * t1904;
        t3271 = t3270 - t1601 * t1965;
        t3283 = t1603 * t1985 + t1937 * t3257 + t1918 * t3261 - t1074 - t1601 * t1909;
        t3288 = t1603 * t1977 + self.constants[34] * t3257 + self.constants[23] * t3283
            - self.constants[39] - t1112 * t1601;
        t3297 = t1642 + t1603 * t2018 + self.constants[35] * t3261 - t1601 * t2016;
        t3304 = t1603 * t2033 - self.constants[37] - t1601 * t2029
            - self.constants[35] * t3257;
        t3308 = t1603 * t2007 + cos_delta * t3304 - self.constants[24] * t3283
            - sin_delta * t3297;
        t3321 = t1603 * t2066 + self.constants[24] * t3266 + cos_delta * t3297
            + sin_delta * t3304 - t1601 * t2064;
        t3327 = t2050 * t3267 + t16 * t3308 - t2048 * t3271 - t13 * t3288
            - sin_phi * t3321;
        t3336 = t3321 + t1961 * t3271 + t1625 * t2095 + t487 * t3327 - t1900 * t3267;
        t3342 = t1625 * t2120 + t2123 * t3336 - t2118 * t3327;
        t3348 = t1625 * t2146 + t2145 * t3327 + t2149 * t3336;
        t3354 = t2171 * t3336 - t1625 * t2168 - t2166 * t3327;
        t3357 = t2189 * t3348;
        t3360 = t3357 - t2185 * t3342 - t2191 * t3354;
        t3377 = t3342 + t1601 * t2323 - t3270;
        t3383 = t1603 * t2250 + t2257 * t3257 + t2262 * t3261 + t1220 * t3283
            + t2265 * t3266 + t298 * t3288;
        t3388 = t3383 + t2282 * t3342 + t2304 * t3348 + t2317 * t3354 + t2320 * t3360
            + t2322 * t3377;
        t3392 = t3388 - t2205 - t1601 * t2246 - t2267 * t3297 - t2269 * t3304;
        t3410 = t2415 * t3348 + t2418 * t3354 - t2410 * t3342;
        t3416 = t2210 + t1448 * t3257 + t1218 * t3283 + t2389 * t3342 + t2396 * t3348
            + t2404 * t3354;
        t3421 = t3416 + t2406 * t3360 + t2408 * t3377 + t298 * t3410 - t1601 * t2376
            - t1603 * t2380;
        t3424 = t3421 - t2383 * t3261 - t2386 * t3266 - t298 * t3308;
        t3435 = t3357 + t1601 * t2446 + t1603 * t2450 - t2441 - t1294 * t3342
            - t1297 * t3354;
        t3437 = t1625 * t2439 + speeds[2] * t3435;
        t3443 = t1625 * t2464 + t780 * t3435 - t776 * t1829;
        t3449 = t3283 + t1603 * t2487;
        t3465 = t12 * t3271 + t7 * t3267 + t55 * t3354 - t12 * t3342 - t1164 * t3348;
        t3485 = t1603 * t2587 + t2591 * t3257 + t2595 * t3261 + t2597 * t3283
            + t2267 * t3304 + t2605 * t3342;
        t3490 = t3485 + t2613 * t3348 + t2621 * t3354 + t2623 * t3360 - t2553
            - t1601 * t2583;
        t3493 = t3490 - t2599 * t3266 - t2269 * t3297 - t2625 * t3377;
        t3501 = t2472 * t3267 + t2494 * t3288 + t2507 * t3342 + t2526 * t3348
            + t2532 * t3354 + t2536 * t3465;
        t3506 = t3501 + t2498 * t3410 + t16 * t3392 - t2474 * t3271 - t2481 * t3449
            - t2496 * t3321;
        t3509 = t3506 - t2498 * t3308 - sin_phi * t3493 - t13 * t3424;
        let (
            t3513, t3520, t3539, t3544, t3547, t3553, t3559, t3566, t3570, t3576, t3586, t3591,
            t3599, t3621, t3626, t3628, t3638, t3640, t3653, t3655, t3661, t3667, t3672, t3677,
            t3682, t3687, t3690, t3726, t3731, t3736, t3741, t3746, t3750, t3769, t3774, t3775,
            t3780, t3785, t3790, t3798, t3802, t3807, t3818, t3822, t3824, t3836, t3841, t3845,
            t3848, t3851, t3862, t3867, t3871, t3873, t3876, t3878, t3889, t3893, t3903, t3909,
            t3913, t3927, t3928, t3934, t3943, t3949, t3955, t3961, t3964, t3967, t3985, t3991,
            t3996, t4000, t4018, t4024, t4029, t4032, t4042, t4045, t4049, t4055, t4071, t4091,
            t4096, t4099, t4107, t4112, t4115, t4120, t4126, t4145, t4150, t4152, t4158, t4164,
            t4171, t4175, t4181, t4191, t4196, t4204, t4226, t4231, t4233, t4243, t4245, t4258,
            t4260, t4266, t4272, t4277, t4282, t4287, t4292, t4296, t4332, t4337, t4342, t4347,
            t4352, t4357, t4377, t4382, t4384, t4388, t4392, t4396, t4405, t4409, t4413, t4424,
            t4428, t4430, t4442, t4447, t4451, t4454, t4459, t4461, t4465, t4467, t4469, t4472,
            t4473, t4475, t4483, t4485, t4487, t4489, t4492, t4506, t4511, t4512, t4519, t4532,
            t4534, t4552, t4557, t4558, t4567, t4580, t4582, t4600, t4605, t4606, t4616, t4618,
            t4620, t4624, t4626, t4629, t4634, t4635, t4638, t4641, t4645, t4648, t4654, t4659,
            t4662, t4667, t4668, t4671, t4673, t4674, t4676, t4677, t4681, t4684, t4688, t4691,
            t4692, t4694, t4696, t4700, t4706, t4709, t4713, t4717, t4722, t4724, t4726, t4728,
            t4729, t4733, t4734, t4735, t4737, t4739, t4742, t4746, t4753, t4754, t4758, t4759,
            t4764, t4765, t4767, t4770, t4778, t4779, t4791, t4796, t4801, t4808, t4810, t4813,
            t4817, t4824, t4830, t4840, t4853, t4858, t4863, t4864, t4871, t4873, t4876, t4880,
            t4887, t4894, t4905, t4919, t4924, t4929, t4932, t4934, t4938, t4943,
        );
        t3513 = t1743 * t3327 + speeds[2] * t3509 + t798 * t3437;
        t3520 = t2783 + t1745 * t3327 + speeds[1] * t3509 + t797 * t3443;
        t3539 = t2672 * t3271 + t2674 * t3449 + t2676 * t3288 + t1745 * t3321
            + t2685 * t3348 + t2688 * t3354;
        t3544 = t3539 + t2690 * t3465 + t2679 * t3410 + speeds[1] * t3493 + t487 * t3520
            - t2777;
        t3547 = t3544 - t2670 * t3267 - t2679 * t3308 - t805 * t3443;
        t3553 = t490 * t3520 + t81 * t3547 - t810 * t3443;
        t3559 = t819 * t3443 + t498 * t3520 + t84 * t3547;
        t3566 = t1625 * t2725 + speeds[0] * t3435;
        t3570 = t1625 * t2721 + t829 * t3437 + t514 * t3443 + t832 * t3566;
        t3576 = t1625 * t2735 + t141 * t3443 + t841 * t3566;
        t3586 = t1749 * t3327 + speeds[0] * t3509 + t798 * t3566;
        t3591 = t1625 * t2743 + t2742 * t3327 + t507 * t3513 + t515 * t3520
            + t518 * t3586;
        t3599 = t1625 * t2797 + t2796 * t3327 + t526 * t3520 + t528 * t3586;
        t3621 = t2812 * t3271 + t2814 * t3449 + t2816 * t3288 + t1749 * t3321
            + t2821 * t3348 + t2823 * t3354;
        t3626 = t3621 + t2825 * t3465 + t2819 * t3410 + speeds[0] * t3493 + t487 * t3586
            - t2810 * t3267;
        t3628 = t3626 - t2819 * t3308 - t860 * t3566;
        t3638 = t856 * t3443 + t532 * t3520 + t105 * t3547 + t53 * t3628 + t548 * t3576
            + t538 * t3599;
        t3640 = t3638 - t123 * t3570 - t36 * t3591;
        t3653 = t3553 + t36 * t3570 + t548 * t3599 - t2857 * t3336 - t143 * t3547
            - t148 * t3628;
        t3655 = t3653 - t538 * t3576 - t123 * t3591;
        t3661 = t818 * t3443 + t497 * t3520 - sin_phi * t3640;
        t3667 = t1601 * t1863 + t1603 * t1879 + t1625 * t1898 + t1398 * t3271
            + t1763 * t3288 + t1749 * t3308;
        t3672 = t3667 + t1895 * t3327 + t2091 * t3336 + t2144 * t3348 + t2164 * t3354
            + t2184 * t3360;
        t3677 = t3672 + speeds[0] * t3392 + t778 * t3437 + t793 * t3443 + t445 * t3513
            + t480 * t3520;
        t3682 = t3677 + t72 * t3547 + self.constants[24] * t3559 + t828 * t3570
            + t525 * t3599 + t120 * t3655;
        t3687 = t3682 + self.constants[27] * t3661 - t1788 * t3267 - t2116 * t3342
            - t1189 * t3424 - self.constants[23] * t3553;
        t3690 = t3687 - t839 * t3576 - t505 * t3591 - t104 * t3640;
        t3726 = t1601 * t2909 + t1625 * t2924 + t1398 * t3267 + t1788 * t3271
            + t1749 * t3288 + t2938 * t3336;
        t3731 = t3726 + t2943 * t3342 + t2949 * t3348 + t2955 * t3354 + t2963 * t3360
            + t1217 * t3410;
        t3736 = t3731 + t1189 * t3392 + speeds[0] * t3424 + t910 * t3437 + t918 * t3443
            + t569 * t3513;
        t3741 = t3736 + t577 * t3520 + t162 * t3547 + t927 * t3570 + t588 * t3599
            + t191 * t3655;
        t3746 = t3741 - t1603 * t1854 - t1763 * t3308 - t2921 * t3327
            - self.constants[24] * t3553 - self.constants[23] * t3559;
        t3750 = t3746 - t931 * t3576 - t584 * t3591 - t181 * t3640 - t48 * t3661;
        t3769 = t1603 * t3027 + t3030 * t3283 + t1240 * t3342 + t3040 * t3348
            + t3044 * t3354 + t3046 * t3377;
        t3774 = t3769 + t12 * t3655 - t1601 * t3023 - t3034 * t3266 - t12 * t3553
            - t7 * t3559;
        t3775 = t3774 - t7 * t3661;
        t3780 = t1603 * t3088 - t3075 - t1601 * t3084;
        t3785 = t1601 * t3110 + t1603 * t3114 - t3098;
        t3790 = t3075 - t1601 * t3127 - t1603 * t3130;
        t3798 = t1603 * t3150 + t3098 * t3257 + t3153 * t3261 - t1601 * t3148;
        t3802 = t3074 * t3780 + t3097 * t3785 + t3074 * t3790
            + self.constants[2] * t3798;
        t3807 = t1603 * t3172 - t1801 - t1601 * t3168;
        t3818 = t1601 * t3188 + t1603 * t3192 + t3100 * t3257 - t1794 - t3195 * t3261;
        t3822 = t3164 * t3807 + t3164 * t3780 + t3073 * t3785
            + self.constants[2] * t3818;
        t3824 = self.constants[20] * t3802 + self.constants[19] * t3822;
        t3836 = t7 * t3655 + t12 * t3661;
        t3841 = t1603 * t3013 + t3211 * t3283 + t3213 * t3266 + t3219 * t3348
            + t3223 * t3354 + t12 * t3559;
        t3845 = t3841 + t3836 - t1601 * t1859 - t3226 * t3377 - t7 * t3553;
        t3848 = self.constants[19] * t3775 + self.constants[20] * t3845 - t3824;
        t3851 = t161 * t3750 + t3848 - t65 * t3690 - t1635 * t3247;
        t3862 = t1668 * t1926 + t1670 * t1930 - t1925;
        t3867 = t1942 + t1668 * t1943 + t1670 * t1947;
        t3871 = t1668 * t1913 + t1937 * t3867 - t1670 * t1916 - t1918 * t3862;
        t3873 = t1901 + t1668 * t1902 + t3871;
        t3876 = t1670 * t1904;
        t3878 = t1668 * t1965 + t3876 - t1964;
        t3889 = t1668 * t1909 + t1670 * t1985 + t1937 * t3862 + t1918 * t3867;
        t3893 = t1112 * t1668 + t1670 * t1977 + self.constants[34] * t3862
            + self.constants[23] * t3889;
        t3903 = t1728 + t1668 * t2016 + t1670 * t2018 + self.constants[35] * t3867
            - t2013;
        t3909 = t1668 * t2029 + t1670 * t2033 - self.constants[35] * t3862;
        t3913 = t1670 * t2007 + cos_delta * t3909 - self.constants[24] * t3889
            - sin_delta * t3903;
        t3927 = t2060 + t1668 * t2064 + t1670 * t2066 + self.constants[24] * t3871
            + cos_delta * t3903 + sin_delta * t3909;
        t3928 = t3927 - self.constants[21];
        t3934 = t2050 * t3873 + t16 * t3913 - t2048 * t3878 - t13 * t3893
            - sin_phi * t3928;
        t3943 = t3928 + t1961 * t3878 + t1688 * t2095 + t487 * t3934 - t1900 * t3873;
        t3949 = t1688 * t2120 + t2123 * t3943 - t2118 * t3934;
        t3955 = t1688 * t2146 + t2145 * t3934 + t2149 * t3943;
        t3961 = t2171 * t3943 - t1688 * t2168 - t2166 * t3934;
        t3964 = t2189 * t3955;
        t3967 = t3964 - t2185 * t3949 - t2191 * t3961;
        t3985 = t1963 + t3949 - t3876 - t1668 * t2323;
        t3991 = t2237 + t1668 * t2246 + t1670 * t2250 + t2257 * t3862 + t2262 * t3867
            + t1220 * t3889;
        t3996 = t3991 + t2265 * t3871 + t298 * t3893 + t2282 * t3949 + t2304 * t3955
            + t2317 * t3961;
        t4000 = t3996 + t2320 * t3967 + t2322 * t3985 - t2267 * t3903 - t2269 * t3909;
        t4018 = t2415 * t3955 + t2418 * t3961 - t2410 * t3949;
        t4024 = t2370 + t1668 * t2376 + t1448 * t3862 + t1218 * t3889 + t2389 * t3949
            + t2396 * t3955;
        t4029 = t4024 + t2404 * t3961 + t2406 * t3967 + t2408 * t3985 + t298 * t4018
            - t1670 * t2380;
        t4032 = t4029 - t2383 * t3867 - t2386 * t3871 - t298 * t3913;
        t4042 = t3964 + t1670 * t2450 - t1668 * t2446 - t1294 * t3949 - t1297 * t3961;
        t4045 = t1688 * t2439 + speeds[2] * t4042 - t1829;
        t4049 = t1688 * t2464 + t780 * t4042;
        t4055 = t3889 + t1670 * t2487;
        t4071 = t12 * t3878 + t7 * t3873 + t55 * t3961 - t12 * t3949 - t1164 * t3955;
        t4091 = t2577 + t1668 * t2583 + t1670 * t2587 + t2591 * t3862 + t2595 * t3867
            + t2597 * t3889;
        t4096 = t4091 + t2267 * t3909 + t2605 * t3949 + t2613 * t3955 + t2621 * t3961
            + t2623 * t3967;
        t4099 = t4096 - t2599 * t3871 - t2269 * t3903 - t2625 * t3985;
        t4107 = t2472 * t3873 + t2494 * t3893 + t2507 * t3949 + t2526 * t3955
            + t2532 * t3961 + t2536 * t4071;
        t4112 = t4107 + t2498 * t4018 + t16 * t4000 - t2474 * t3878 - t2481 * t4055
            - t2496 * t3928;
        t4115 = t4112 - t2498 * t3913 - sin_phi * t4099 - t13 * t4032;
        t4120 = t2783 + t1743 * t3934 + speeds[2] * t4115 + t798 * t4045;
        t4126 = t1745 * t3934 + speeds[1] * t4115 + t797 * t4049;
        t4145 = t2672 * t3878 + t2674 * t4055 + t2676 * t3893 + t1745 * t3928
            + t2685 * t3955 + t2688 * t3961;
        t4150 = t4145 + t2690 * t4071 + t2679 * t4018 + speeds[1] * t4099 + t487 * t4126
            - t2670 * t3873;
        t4152 = t4150 - t2679 * t3913 - t805 * t4049;
        t4158 = t490 * t4126 + t81 * t4152 - t810 * t4049;
        t4164 = t819 * t4049 + t498 * t4126 + t84 * t4152;
        t4171 = t1688 * t2725 + speeds[0] * t4042;
        t4175 = t1688 * t2721 + t829 * t4045 + t514 * t4049 + t832 * t4171;
        t4181 = t1688 * t2735 + t141 * t4049 + t841 * t4171;
        t4191 = t1749 * t3934 + speeds[0] * t4115 + t798 * t4171;
        t4196 = t1688 * t2743 + t2742 * t3934 + t507 * t4120 + t515 * t4126
            + t518 * t4191;
        t4204 = t1688 * t2797 + t2796 * t3934 + t526 * t4126 + t528 * t4191;
        t4226 = t2812 * t3878 + t2814 * t4055 + t2816 * t3893 + t1749 * t3928
            + t2821 * t3955 + t2823 * t3961;
        t4231 = t4226 + t2825 * t4071 + t2819 * t4018 + speeds[0] * t4099 + t487 * t4191
            - t2810 * t3873;
        t4233 = t4231 - t2819 * t3913 - t860 * t4171;
        t4243 = t856 * t4049 + t532 * t4126 + t105 * t4152 + t53 * t4233 + t548 * t4181
            + t538 * t4204;
        t4245 = t4243 - t123 * t4175 - t36 * t4196;
        t4258 = t4158 + t36 * t4175 + t548 * t4204 - t2857 * t3943 - t143 * t4152
            - t148 * t4233;
        t4260 = t4258 - t538 * t4181 - t123 * t4196;
        t4266 = t818 * t4049 + t497 * t4126 - sin_phi * t4245;
        t4272 = t1863 + t1670 * t1879 + t1688 * t1898 + t1398 * t3878 + t1763 * t3893
            + t1749 * t3913;
        t4277 = t4272 + t1895 * t3934 + t2091 * t3943 + t2144 * t3955 + t2164 * t3961
            + t2184 * t3967;
        t4282 = t4277 + speeds[0] * t4000 + t778 * t4045 + t793 * t4049 + t445 * t4120
            + t480 * t4126;
        t4287 = t4282 + t72 * t4152 + self.constants[24] * t4164 + t828 * t4175
            + t525 * t4204 + t120 * t4260;
        t4292 = t4287 + self.constants[27] * t4266 - t1668 * t1863 - t1788 * t3873
            - t2116 * t3949 - t1189 * t4032;
        t4296 = t4292 - self.constants[23] * t4158 - t839 * t4181 - t505 * t4196
            - t104 * t4245;
        t4332 = t2909 + t1688 * t2924 + t1398 * t3873 + t1788 * t3878 + t1749 * t3893
            + t2938 * t3943;
        t4337 = t4332 + t2943 * t3949 + t2949 * t3955 + t2955 * t3961 + t2963 * t3967
            + t1217 * t4018;
        t4342 = t4337 + t1189 * t4000 + speeds[0] * t4032 + t910 * t4045 + t918 * t4049
            + t569 * t4120;
        t4347 = t4342 + t577 * t4126 + t162 * t4152 + t927 * t4175 + t588 * t4204
            + t191 * t4260;
        t4352 = t4347 - t1668 * t2909 - t1670 * t1854 - t1763 * t3913 - t2921 * t3934
            - self.constants[24] * t4158;
        t4357 = t4352 - self.constants[23] * t4164 - t931 * t4181 - t584 * t4196
            - t181 * t4245 - t48 * t4266;
        t4377 = t1668 * t3023 + t1670 * t3027 + t3030 * t3889 + t1240 * t3949
            + t3040 * t3955 + t3044 * t3961;
        t4382 = t4377 + t3046 * t3985 + t12 * t4260 - t3018 - t3034 * t3871
            - t12 * t4158;
        t4384 = t4382 - t7 * t4164 - t7 * t4266;
        t4388 = t1668 * t3084 + t1670 * t3088;
        t4392 = t1668 * t3110 - t1670 * t3114;
        t4396 = t1668 * t3127 - t1670 * t3130;
        t4405 = t1668 * t3148 + t1670 * t3150 + t3098 * t3862 + t3153 * t3867 - t3142;
        t4409 = t3074 * t4388 + t3074 * t4396 + self.constants[2] * t4405
            - t3097 * t4392;
        t4413 = t1668 * t3168 + t1670 * t3172;
        t4424 = t3184 + t1670 * t3192 + t3100 * t3862 - t1668 * t3188 - t3195 * t3867;
        t4428 = t3164 * t4413 + t3164 * t4388 + self.constants[2] * t4424
            - t3073 * t4392;
        t4430 = self.constants[20] * t4409 + self.constants[19] * t4428;
        t4442 = t7 * t4260 + t12 * t4266;
        t4447 = t1668 * t1859 + t1670 * t3013 + t3211 * t3889 + t3213 * t3871
            + t3219 * t3955 + t3223 * t3961;
        t4451 = t4447 + t12 * t4164 + t4442 - t3226 * t3985 - t7 * t4158;
        t4454 = self.constants[19] * t4384 + self.constants[20] * t4451 - t4430;
        t4459 = t1742
            * (t161 * t4357 + t4454 - t65 * t4296 - t1701 * t3247 - t1710 * t3851);
        t4461 = t1653 * t3851 - t1710 * t4459;
        t4465 = t1180 * t3247 - t1635 * t4461 - t1701 * t4459;
        t4467 = t3077 - t1273;
        t4469 = t1320 + t3121;
        t4472 = self.constants[26] * self.constants[3];
        t4473 = t4472 + t4472;
        t4475 = self.constants[25] * self.constants[3];
        t4483 = t3232 + t2152 * t4467 + t2174 * t4469 + t3092 * t4473 + t3118 * t4475
            + t3134 * t4473;
        t4485 = t4483 + t3158 * self.constants[3] - t2126 * t3141;
        t4487 = t3121 - t1320;
        t4489 = t1225 + t3075;
        t4492 = t4475 + t4475;
        t4506 = t2126 * t4487 + t2152 * t4489 + t3176 * t4492 + t3092 * t4492
            + t3118 * t4472 + t3201 * self.constants[3];
        t4511 = t4506 + t972 * t2467 + t623 * t2667 + t28 * t2855 + t96 * t2871
            - t2174 * t3195;
        t4512 = t4511 - t55 * t2877;
        t4519 = t3245 + t229 * t3011 - self.constants[20] * t4485
            - self.constants[19] * t4512 - t227 * t2907;
        t4532 = t3836 + t3348 * t4467 + t3354 * t4469 + t3780 * t4473 + t3785 * t4475
            + t3790 * t4473;
        t4534 = t4532 + t3798 * self.constants[3] - t3141 * t3342;
        t4552 = t3342 * t4487 + t3348 * t4489 + t3807 * t4492 + t3780 * t4492
            + t3785 * t4472 + t3818 * self.constants[3];
        t4557 = t4552 + t972 * t3443 + t623 * t3520 + t28 * t3640 + t96 * t3655
            - t3195 * t3354;
        t4558 = t4557 - t55 * t3661;
        t4567 = t3848 + t229 * t3750 - self.constants[20] * t4534
            - self.constants[19] * t4558 - t227 * t3690 - t1635 * t4519;
        t4580 = t4442 + t3955 * t4467 + t3961 * t4469 + t4388 * t4473 + t4396 * t4473
            + t4405 * self.constants[3];
        t4582 = t4580 - t3141 * t3949 - t4392 * t4475;
        t4600 = t3949 * t4487 + t3955 * t4489 + t4413 * t4492 + t4388 * t4492
            + t4424 * self.constants[3] + t972 * t4049;
        t4605 = t4600 + t623 * t4126 + t28 * t4245 + t96 * t4260 - t3195 * t3961
            - t4392 * t4472;
        t4606 = t4605 - t55 * t4266;
        t4616 = t4454 + t229 * t4357 - self.constants[20] * t4582
            - self.constants[19] * t4606 - t227 * t4296 - t1701 * t4519;
        t4618 = t1742 * (t4616 - t1710 * t4567);
        t4620 = t1653 * t4567 - t1710 * t4618;
        t4624 = t1180 * t4519 - t1635 * t4620 - t1701 * t4618;
        t4626 = self.constants[20] * self.constants[14];
        t4629 = t4626 + self.constants[19] * self.constants[16];
        t4634 = self.constants[19] * self.constants[14];
        t4635 = self.constants[20] * self.constants[12] + t4634;
        t4638 = self.constants[19] * (t4635 + t4635)
            - self.constants[20] * (t4629 + t4629);
        t4641 = t4634 - self.constants[20] * self.constants[16];
        t4645 = self.constants[19] * self.constants[12] - t4626;
        t4648 = self.constants[19] * (t4645 - t4629)
            - self.constants[20] * (t4635 + t4641);
        t4654 = self.constants[20] * (t4645 + t4645)
            + self.constants[19] * (t4641 + t4641);
        t4659 = self.constants[20] * self.constants[13];
        t4662 = t4659 + self.constants[19] * self.constants[15];
        t4667 = self.constants[19] * self.constants[13];
        t4668 = self.constants[20] * self.constants[11] + t4667;
        t4671 = self.constants[19] * (t4668 + t4668)
            - self.constants[20] * (t4662 + t4662);
        t4673 = t12 * t3210;
        t4674 = t1123 * t3046;
        t4676 = t7 * t3210;
        t4677 = t12 * t1771 - t4676;
        t4681 = t4674 + t1134 * t4677 - t7 * t1771 - t4673;
        t4684 = self.constants[19] * self.constants[11] - t4659;
        t4688 = t4667 - self.constants[20] * self.constants[15];
        t4691 = self.constants[20] * (t4684 + t4684)
            + self.constants[19] * (t4688 + t4688);
        t4692 = t7 * t3029;
        t4694 = t12 * t3029;
        t4696 = t4694 + t7 * t1766;
        t4700 = t4692 - t4674 - t12 * t1766 - t1134 * t4696;
        t4706 = self.constants[19] * (t4684 - t4662)
            - self.constants[20] * (t4668 + t4688);
        t4709 = t3033 - t3225;
        t4713 = t12 * t3211 + t7 * t3030;
        t4717 = t12 * t3030 + t1123 * t4709 + t1134 * t4713 - t7 * t3211;
        t4722 = self.constants[7] + self.constants[8];
        t4724 = self.constants[19] * self.constants[4] - self.constants[20] * t4722;
        t4726 = self.constants[7] * t3211;
        t4728 = t1753 * self.constants[0];
        t4729 = t12 * t4728;
        t4733 = t1900 * t3213 - t1961 * t3226;
        t4734 = self.constants[0] * t4733;
        t4735 = t1790 * self.constants[0] - t4734;
        t4737 = t7 * t4728;
        t4739 = self.constants[29] + self.constants[29];
        t4742 = t4676 + t4694;
        t4746 = t4673 + t1134 * t4742 - t4692 - t1123 * t1784;
        t4753 = t4700 * t4739 + t4739 * t4746 + self.constants[28] * t4717
            - self.constants[0] * t4726 - t4729 - t1123 * t4735;
        t4754 = t4753 - t1134 * t4737;
        t4758 = self.constants[20] * self.constants[4] + self.constants[19] * t4722;
        t4759 = self.constants[7] * t3030;
        t4764 = t1961 * (t3046 - t1784) - t1900 * t3034;
        t4765 = self.constants[0] * t4764;
        t4767 = t1813 * self.constants[0] - t4765;
        t4770 = self.constants[28] + self.constants[28];
        t4778 = t4737 + t4681 * t4770 + t4746 * t4770 + self.constants[29] * t4717
            - self.constants[0] * t4759 - t1123 * t4767;
        t4779 = t4778 - t1134 * t4729;
        t4791 = t3176 * t4638 + t3096 * t3162 + t4671 * t4681 + t4724 * t4754
            + self.constants[25] * t4485 + t242 * t4512;
        t4796 = t4791 + self.constants[23] * t3242 + t287 * t3011 - t3118 * t4648
            - t3134 * t4654 - t3072 * t3205;
        t4801 = t4796 - t4691 * t4700 - t4706 * t4717 - t4758 * t4779
            - self.constants[24] * t3064 - t284 * t2907;
        t4808 = t1601 * t3046;
        t4810 = t4808 + t1603 * t4677;
        t4813 = t4808 + t1603 * t4696;
        t4817 = t1601 * t4709 + t1603 * t4713;
        t4824 = t1603 * t4742 - t1601 * t1784;
        t4830 = t4739 * t4824 + self.constants[28] * t4817 - t1601 * t4735
            - t1603 * t4737 - t4739 * t4813;
        t4840 = t4770 * t4810 + t4770 * t4824 + self.constants[29] * t4817
            - t1601 * t4767 - t1603 * t4729;
        t4853 = t3807 * t4638 + t3096 * t3802 + t4671 * t4810 + t4691 * t4813
            + t4724 * t4830 + self.constants[25] * t4534;
        t4858 = t4853 + t242 * t4558 + self.constants[23] * t3845 + t287 * t3750
            - t3785 * t4648 - t3790 * t4654;
        t4863 = t4858 - t3072 * t3822 - t4706 * t4817 - t4758 * t4840
            - self.constants[24] * t3775 - t284 * t3690;
        t4864 = t4863 - t1635 * t4801;
        t4871 = t1668 * t3046;
        t4873 = t1670 * t4677 - t4871;
        t4876 = t4871 - t1670 * t4696;
        t4880 = t1668 * t4709 - t1670 * t4713;
        t4887 = t1668 * t1784 + t1670 * t4742;
        t4894 = t4734 + t1668 * t4735 + t4739 * t4876 + t4739 * t4887 - t1670 * t4737
            - self.constants[28] * t4880;
        t4905 = t4765 + t1668 * t4767 + t4770 * t4873 + t4770 * t4887 - t1670 * t4729
            - self.constants[29] * t4880;
        t4919 = t4413 * t4638 + t4392 * t4648 + t3096 * t4409 + t4671 * t4873
            + t4706 * t4880 + t4724 * t4894;
        t4924 = t4919 + self.constants[25] * t4582 + t242 * t4606
            + self.constants[23] * t4451 + t287 * t4357 - t4396 * t4654;
        t4929 = t4924 - t3072 * t4428 - t4691 * t4876 - t4758 * t4905
            - self.constants[24] * t4384 - t284 * t4296;
        t4932 = t1742 * (t4929 - t1701 * t4801 - t1710 * t4864);
        t4934 = t1653 * t4864 - t1710 * t4932;
        t4938 = t1180 * t4801 - t1635 * t4934 - t1701 * t4932;
        t4943 = t16 * t1959 + t13 * t1969 + sin_phi * t2492;
        let (
            t4951, t4962, t4964, t4968, t4973, t4974, t4976, t4978, t4979, t4981, t4982, t4984,
            t4986, t4988, t4992, t4996, t5011, t5016, t5021, t5026, t5032, t5035, t5059, t5064,
            t5069, t5074, t5079, t5104, t5109, t5114, t5119, t5124, t5127, t5129, t5133, t5134,
            t5137, t5139, t5143, t5151, t5153, t5157, t5158, t5162, t5169, t5171, t5175, t5176,
            t5178, t5183, t5187, t5193, t5203, t5205, t5209, t5212, t5218, t5227, t5229, t5233,
            t5236, t5242, t5244, t5248, t5251, t5253, t5259, t5262, t5266, t5268, t5270, t5272,
            t5274, t5280, t5285, t5298, t5299, t5313, t5317, t5319, t5323, t5324, t5326, t5328,
            t5329, t5331, t5335, t5339, t5343, t5350, t5352, t5356, t5359, t5365, t5367, t5371,
            t5375, t5382, t5392, t5394, t5398, t5399, t5402, t5405, t5413, t5424, t5426, t5430,
            t5433, t5439, t5441, t5445, t5448, t5454, t5463, t5465, t5469, t5470, t5472, t5477,
            t5478, t5480, t5481, t5483, t5492, t5493, t5499, t5511, t5513, t5520, t5533, t5537,
            t5539, t5543, t5545, t5548, t5551, t5556, t5559, t5567, t5569, t5573, t5576, t5582,
            t5584, t5588, t5592, t5599, t5609, t5611, t5615, t5620, t5628, t5639, t5641, t5645,
            t5648, t5654, t5662, t5668, t5685, t5690, t5694, t5717, t5722, t5727, t5728, t5751,
            t5756, t5761, t5763, t5765, t5769, t5770, t5772, t5773, t5775, t5784, t5785, t5798,
            t5800, t5814, t5818, t5820, t5824, t5825, t5829, t5836, t5838, t5842, t5843, t5845,
            t5846, t5848, t5852, t5858, t5867, t5878, t5880, t5884,
        );
        t4951 = t16 * t3267 + t13 * t3271 - sin_phi * t3449 - t1635 * t4943;
        t4962 = t1742
            * (t16 * t3873 + t13 * t3878 - sin_phi * t4055 - t1701 * t4943
                - t1710 * t4951);
        t4964 = t1653 * t4951 - t1710 * t4962;
        t4968 = t1180 * t4943 - t1635 * t4964 - t1701 * t4962;
        t4973 = t1786 - t1240;
        t4974 = t12 * t4973;
        t4976 = t7 * t4973;
        t4978 = t1186 * t1189;
        t4979 = t4978 - t1750;
        t4981 = t1240 + t1240;
        t4982 = t7 * t4981;
        t4984 = t12 * t4981;
        t4986 = t1210 - t4978;
        t4988 = cos_delta * t4986 - sin_delta * t4984;
        t4992 = cos_delta * t4984 + sin_delta * t4986;
        t4996 = t1186 * t1248 - speeds[0] * speeds[0];
        t5011 = self.constants[19] * t4754 - self.constants[20] * t4779;
        t5016 = self.constants[1] * t1753 + self.constants[29] * t1766 + t1123 * t2767
            + t1969 * t4976 + t2492 * t4979 + t2126 * t4982;
        t5021 = t5016 + t2152 * t4988 + t2174 * t4992 + t2545 * t4996 + t1000 * t2461
            + t447 * t2661;
        t5026 = t5021 + t71 * t2843 + t1005 * t2740 + t652 * t2804
            + self.constants[19] * t3242 + t311 * t3011;
        t5032 = t5026 + t5011 - t1523 - t1847 - self.constants[28] * t1771
            - t1959 * t4974 - t548 * t2733;
        t5035 = t5032 - t538 * t2794 - self.constants[20] * t3064 - t309 * t2907;
        t5059 = self.constants[19] * t4830 - self.constants[20] * t4840;
        t5064 = t1601 * t2767 + t3271 * t4976 + t3342 * t4982 + t3348 * t4988
            + t3354 * t4992 + t3465 * t4996;
        t5069 = t5064 + t1000 * t3437 + t447 * t3513 + t71 * t3628 + t1005 * t3576
            + t652 * t3599;
        t5074 = t5069 + self.constants[19] * t3845 + t311 * t3750 + t5059 - t3267 * t4974
            - t3449 * t4979;
        t5079 = t5074 - t548 * t3570 - t538 * t3591 - self.constants[20] * t3775
            - t309 * t3690 - t1635 * t5035;
        t5104 = self.constants[19] * t4894 - self.constants[20] * t4905;
        t5109 = t2767 + t3878 * t4976 + t3949 * t4982 + t3955 * t4988 + t3961 * t4992
            + t4071 * t4996;
        t5114 = t5109 + t1000 * t4045 + t447 * t4120 + t71 * t4233 + t1005 * t4181
            + t652 * t4204;
        t5119 = t5114 + self.constants[19] * t4451 + t311 * t4357 + t5104 - t1668 * t2767
            - t3873 * t4974;
        t5124 = t5119 - t4055 * t4979 - t548 * t4175 - t538 * t4196
            - self.constants[20] * t4384 - t309 * t4296;
        t5127 = t1742 * (t5124 - t1701 * t5035 - t1710 * t5079);
        t5129 = t1653 * t5079 - t1710 * t5127;
        t5133 = t1180 * t5035 - t1635 * t5129 - t1701 * t5127;
        t5134 = self.constants[7] * t1753;
        t5137 = t1790 * t1900 - t1813 * t1961;
        t5139 = t5134 + t1123 * t5137;
        t5143 = t1601 * t5137 - t1635 * t5139;
        t5151 = t1742 * (t5137 - t1668 * t5137 - t1701 * t5139 - t1710 * t5143);
        t5153 = t1653 * t5143 - t1710 * t5151;
        t5157 = t1180 * t5139 - t1635 * t5153 - t1701 * t5151;
        t5158 = t4681 + t4700;
        t5162 = t4810 - t4813 - t1635 * t5158;
        t5169 = t1742 * (t4873 + t4876 - t1701 * t5158 - t1710 * t5162);
        t5171 = t1653 * t5162 - t1710 * t5169;
        t5175 = t1180 * t5158 - t1635 * t5171 - t1701 * t5169;
        t5176 = t1191 * t1200;
        t5178 = t1195 * t1200;
        t5183 = t12 * t5176 + t7 * t5178;
        t5187 = t12 * t5178 + t1134 * t5183 - t7 * t5176 - t1123 * t1786;
        t5193 = t1603 * t5183 - t1601 * t1786 - t1635 * t5187;
        t5203 = t1742
            * (t1668 * t1786 + t1670 * t5183 - t1786 - t1701 * t5187 - t1710 * t5193);
        t5205 = t1653 * t5193 - t1710 * t5203;
        t5209 = t1180 * t5187 - t1635 * t5205 - t1701 * t5203;
        t5212 = self.constants[20] * t4754 + self.constants[19] * t4779;
        t5218 = self.constants[20] * t4830 + self.constants[19] * t4840 - t1635 * t5212;
        t5227 = t1742
            * (self.constants[20] * t4894 + self.constants[19] * t4905 - t1701 * t5212
                - t1710 * t5218);
        t5229 = t1653 * t5218 - t1710 * t5227;
        t5233 = t1180 * t5212 - t1635 * t5229 - t1701 * t5227;
        t5236 = t5059 - t1635 * t5011;
        t5242 = t1742 * (t5104 - t1701 * t5011 - t1710 * t5236);
        t5244 = t1653 * t5236 - t1710 * t5242;
        t5248 = t1180 * t5011 - t1635 * t5244 - t1701 * t5242;
        t5251 = t1753 * t4724;
        t5253 = t1753 * t4758;
        t5259 = t5137 + t4733 * t4758 + t4724 * t4764;
        t5262 = t1790 * t4758 + t1813 * t4724 - t5259;
        t5266 = t12 * t5251 + t7 * t5253;
        t5268 = t4724 * t4724;
        t5270 = t4758 * t4758;
        t5272 = t5268 + t5270;
        t5274 = t4724 * t4758;
        t5280 = t5134 + t7 * t5251 + t4681 * t5268 + t4700 * t5270 + t4746 * t5272
            + t4717 * t5274;
        t5285 = t5280 - t4726 * t4758 - t4724 * t4759 - t12 * t5253 - t1123 * t5262
            - t1134 * t5266;
        t5298 = t4810 * t5268 + t4824 * t5272 + t4817 * t5274 - t1601 * t5262
            - t1603 * t5266 - t4813 * t5270;
        t5299 = t5298 - t1635 * t5285;
        t5313 = t5259 + t1668 * t5262 + t4873 * t5268 + t4876 * t5270 + t4887 * t5272
            - t1670 * t5266;
        t5317 = t1742 * (t5313 - t4880 * t5274 - t1701 * t5285 - t1710 * t5299);
        t5319 = t1653 * t5299 - t1710 * t5317;
        t5323 = t1180 * t5285 - t1635 * t5319 - t1701 * t5317;
        t5324 = self.constants[20] * self.constants[20];
        t5326 = self.constants[19] * self.constants[19];
        t5328 = self.constants[19] * self.constants[20];
        t5329 = t4717 * t5328;
        t5331 = t4681 * t5324 + t4700 * t5326 - t5329;
        t5335 = t4817 * t5328;
        t5339 = t4810 * t5324 - t4813 * t5326 - t5335 - t1635 * t5331;
        t5343 = t4880 * t5328;
        t5350 = t1742
            * (t4873 * t5324 + t4876 * t5326 + t5343 - t1701 * t5331 - t1710 * t5339);
        t5352 = t1653 * t5339 - t1710 * t5350;
        t5356 = t1180 * t5331 - t1635 * t5352 - t1701 * t5350;
        t5359 = t4824 - t1635 * t4746;
        t5365 = t1742 * (t4887 - t1701 * t4746 - t1710 * t5359);
        t5367 = t1653 * t5359 - t1710 * t5365;
        t5371 = t1180 * t4746 - t1635 * t5367 - t1701 * t5365;
        t5375 = t5329 + t4681 * t5326 + t4700 * t5324;
        t5382 = t5335 + t4810 * t5326 - t4813 * t5324 - t1635 * t5375;
        t5392 = t1742
            * (t4873 * t5326 + t4876 * t5324 - t5343 - t1701 * t5375 - t1710 * t5382);
        t5394 = t1653 * t5382 - t1710 * t5392;
        t5398 = t1180 * t5375 - t1635 * t5394 - t1701 * t5392;
        t5399 = t5328 + t5328;
        t5402 = t5326 - t5324;
        t5405 = t4681 * t5399 - t4700 * t5399 - t4717 * t5402;
        t5413 = t4810 * t5399 + t4813 * t5399 - t4817 * t5402 - t1635 * t5405;
        t5424 = t1742
            * (t4873 * t5399 + t4880 * t5402 - t4876 * t5399 - t1701 * t5405
                - t1710 * t5413);
        t5426 = t1653 * t5413 - t1710 * t5424;
        t5430 = t1180 * t5405 - t1635 * t5426 - t1701 * t5424;
        t5433 = t3824 - t1635 * t3207;
        t5439 = t1742 * (t4430 - t1701 * t3207 - t1710 * t5433);
        t5441 = t1653 * t5433 - t1710 * t5439;
        t5445 = t1180 * t3207 - t1635 * t5441 - t1701 * t5439;
        t5448 = self.constants[19] * t3162 - self.constants[20] * t3205;
        t5454 = self.constants[19] * t3802 - self.constants[20] * t3822 - t1635 * t5448;
        t5463 = t1742
            * (self.constants[19] * t4409 - self.constants[20] * t4428 - t1701 * t5448
                - t1710 * t5454);
        t5465 = t1653 * t5454 - t1710 * t5463;
        t5469 = t1180 * t5448 - t1635 * t5465 - t1701 * t5463;
        t5470 = t1815 * t1961;
        t5472 = t5470 + self.constants[23] * t1815;
        t5477 = t1123 * t5472 + t1794 * t1935 + t1809 * t1952;
        t5478 = t3096 * t3096;
        t5480 = t3072 * t3072;
        t5481 = t5478 + t5480;
        t5483 = t3072 * t3096;
        t5492 = t5477 + t3176 * t5478 + t3092 * t5481 + t3118 * t5483 + t3134 * t5480
            + t3072 * t3158;
        t5493 = t5492 + t3096 * t3201;
        t5499 = t1601 * t5472 + t1794 * t3257 + t1809 * t3261;
        t5511 = t5499 + t3807 * t5478 + t3780 * t5481 + t3785 * t5483 + t3790 * t5480
            + t3072 * t3798;
        t5513 = t5511 + t3096 * t3818 - t1635 * t5493;
        t5520 = t5470 + t1794 * t3862 + t1809 * t3867 - t1668 * t5472;
        t5533 = t5520 + t4413 * t5478 + t4388 * t5481 + t4396 * t5480 + t3072 * t4405
            + t3096 * t4424;
        t5537 = t1742 * (t5533 - t4392 * t5483 - t1701 * t5493 - t1710 * t5513);
        t5539 = t1653 * t5513 - t1710 * t5537;
        t5543 = t1180 * t5493 - t1635 * t5539 - t1701 * t5537;
        t5545 = t3118 * t5328;
        t5548 = t3176 * t5324 + t3134 * t5326 - t5545;
        t5551 = t3785 * t5328;
        t5556 = t3807 * t5324 + t3790 * t5326 - t5551 - t1635 * t5548;
        t5559 = t4392 * t5328;
        t5567 = t1742
            * (t4413 * t5324 + t5559 + t4396 * t5326 - t1701 * t5548 - t1710 * t5556);
        t5569 = t1653 * t5556 - t1710 * t5567;
        t5573 = t1180 * t5548 - t1635 * t5569 - t1701 * t5567;
        t5576 = t3780 - t1635 * t3092;
        t5582 = t1742 * (t4388 - t1701 * t3092 - t1710 * t5576);
        t5584 = t1653 * t5576 - t1710 * t5582;
        t5588 = t1180 * t3092 - t1635 * t5584 - t1701 * t5582;
        t5592 = t5545 + t3176 * t5326 + t3134 * t5324;
        t5599 = t5551 + t3807 * t5326 + t3790 * t5324 - t1635 * t5592;
        t5609 = t1742
            * (t4413 * t5326 + t4396 * t5324 - t5559 - t1701 * t5592 - t1710 * t5599);
        t5611 = t1653 * t5599 - t1710 * t5609;
        t5615 = t1180 * t5592 - t1635 * t5611 - t1701 * t5609;
        t5620 = t3176 * t5399 - t3118 * t5402 - t3134 * t5399;
        t5628 = t3807 * t5399 - t3785 * t5402 - t3790 * t5399 - t1635 * t5620;
        t5639 = t1742
            * (t4413 * t5399 + t4392 * t5402 - t4396 * t5399 - t1701 * t5620
                - t1710 * t5628);
        t5641 = t1653 * t5628 - t1710 * t5639;
        t5645 = t1180 * t5620 - t1635 * t5641 - t1701 * t5639;
        t5648 = t1496 * t1881 + t1031 * t2463;
        t5654 = t1265 * t1327 - t30 * t1320 - t1293 * t1323;
        t5662 = t30 * t1282 + t1256 * t1293 + t1265 * t1296 - t27 * t1286;
        t5668 = t27 * t1320 - t1296 * t1323 - t1256 * t1327;
        t5685 = t1168 * t5648 + t2126 * t5654 + t2152 * t5662 + t2174 * t5668
            + t1039 * t2467 + t665 * t2667;
        t5690 = t5685 + t320 * t2871 + self.constants[20] * t4512 + t330 * t3011
            - t1032 * t2459 - t1037 * t2461;
        t5694 = t5690 - t1045 * t2729 - t318 * t2855 - self.constants[19] * t4485
            - t328 * t2907;
        t5717 = t1031 * t1829 + t3342 * t5654 + t3348 * t5662 + t3354 * t5668
            + t1039 * t3443 + t665 * t3520;
        t5722 = t5717 + t320 * t3655 + self.constants[20] * t4558 + t330 * t3750
            - t1625 * t5648 - t1032 * t3435;
        t5727 = t5722 - t1037 * t3437 - t1045 * t3566 - t318 * t3640
            - self.constants[19] * t4534 - t328 * t3690;
        t5728 = t5727 - t1635 * t5694;
        t5751 = t3949 * t5654 + t3955 * t5662 + t3961 * t5668 + t1039 * t4049
            + t665 * t4126 + t320 * t4260;
        t5756 = t5751 + self.constants[20] * t4606 + t330 * t4357 - t1688 * t5648
            - t1032 * t4042 - t1037 * t4045;
        t5761 = t5756 - t1045 * t4171 - t318 * t4245 - self.constants[19] * t4582
            - t328 * t4296 - t1701 * t5694;
        t5763 = t1742 * (t5761 - t1710 * t5728);
        t5765 = t1653 * t5728 - t1710 * t5763;
        t5769 = t1180 * t5694 - t1635 * t5765 - t1701 * t5763;
        t5770 = self.constants[25] * self.constants[25];
        t5772 = self.constants[26] * self.constants[26];
        t5773 = t5770 + t5772;
        t5775 = self.constants[25] * self.constants[26];
        t5784 = t5477 + t3176 * t5770 + t3092 * t5773 + t3118 * t5775 + t3134 * t5772
            + self.constants[26] * t3158;
        t5785 = t5784 + self.constants[25] * t3201;
        t5798 = t5499 + t3807 * t5770 + t3780 * t5773 + t3785 * t5775 + t3790 * t5772
            + self.constants[26] * t3798;
        t5800 = t5798 + self.constants[25] * t3818 - t1635 * t5785;
        t5814 = t5520 + t4413 * t5770 + t4388 * t5773 + t4396 * t5772
            + self.constants[26] * t4405 + self.constants[25] * t4424;
        t5818 = t1742 * (t5814 - t4392 * t5775 - t1701 * t5785 - t1710 * t5800);
        t5820 = t1653 * t5800 - t1710 * t5818;
        t5824 = t1180 * t5785 - t1635 * t5820 - t1701 * t5818;
        t5825 = t3134 + t3176;
        t5829 = t3790 + t3807 - t1635 * t5825;
        t5836 = t1742 * (t4396 + t4413 - t1701 * t5825 - t1710 * t5829);
        t5838 = t1653 * t5829 - t1710 * t5836;
        t5842 = t1180 * t5825 - t1635 * t5838 - t1701 * t5836;
        t5843 = t1265 * t1323;
        t5845 = t1256 * t1323;
        t5846 = cos_delta * t5845;
        t5848 = sin_delta * t5845;
        t5852 = t12 * t5843 + t7 * t5846;
        t5858 = t12 * t5846 + t1123 * t5848 + t1134 * t5852 - t7 * t5843 - t1168 * t1828;
        t5867 = t1601 * t5848 + t1603 * t5852 + t1625 * t1828 - t5843 - t1635 * t5858;
        t5878 = t1742
            * (t1670 * t5852 + t1688 * t1828 - t1668 * t5848 - t1701 * t5858
                - t1710 * t5867);
        t5880 = t1653 * t5867 - t1710 * t5878;
        t5884 = t1180 * t5858 - t1635 * t5880 - t1701 * t5878;
        [
            [
                t218, t234, t293, zero, t317, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, t336, zero, zero, zero,
            ],
            [
                t393, t406, t417, zero, t428, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, t439, zero, zero, zero,
            ],
            [
                t621, t637, t648, zero, t664, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, t678, zero, zero, zero,
            ],
            [
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                t731, t744, t755, zero, t764, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, t775, zero, zero, zero,
            ],
            [
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            ],
            [
                t970, t988, t999, zero, t1022, zero, zero, zero, zero, zero, zero, zero, zero, zero,
                zero, zero, zero, zero, zero, zero, zero, zero, t1063, zero, zero, zero,
            ],
            [
                t4465, t4624, t4938, t4968, t5133, t5157, t5175, t5209, t5233, t5248, t5323, t5356,
                t5371, t5398, t5430, t5445, t5469, t5543, t5573, t5588, t5615, t5645, t5769, t5824,
                t5842, t5884,
            ],
            [
                t4461, t4620, t4934, t4964, t5129, t5153, t5171, t5205, t5229, t5244, t5319, t5352,
                t5367, t5394, t5426, t5441, t5465, t5539, t5569, t5584, t5611, t5641, t5765, t5820,
                t5838, t5880,
            ],
            [
                t4459, t4618, t4932, t4962, t5127, t5151, t5169, t5203, t5227, t5242, t5317, t5350,
                t5365, t5392, t5424, t5439, t5463, t5537, t5567, t5582, t5609, t5639, t5763, t5818,
                t5836, t5878,
            ],
        ]
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`WhippleMechanism`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleMechanismDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 123],
}

impl<T: Number> WhippleMechanism<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 92 additions, 175 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 273 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WhippleMechanismMatrices<T>, WhippleMechanismDerivatives<T>) {
        let zero = self.w.like(0.0);
        let mut matrices = WhippleMechanismMatrices::from_entries([zero; 16]);
        let mut derivatives = WhippleMechanismDerivatives {
            values: [zero; 123],
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
        matrices: &mut WhippleMechanismMatrices<T>,
        derivatives: &mut WhippleMechanismDerivatives<T>,
    ) {
        *matrices = WhippleMechanismMatrices::from_entries([self.w.like(0.0); 16]);
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
        put_derivative(0, self.rR);
        put_derivative(1, self.mR);
        put_derivative(2, self.zB);
        put_derivative(3, self.mB);
        put_derivative(4, self.zH);
        put_derivative(5, self.mH);
        put_derivative(6, self.rF);
        put_derivative(7, self.mF);
        put_derivative(8, self.w.like(1.0));
        let (wx_delta2_delta, wx_delta2_delta_lam) = self.lam.sin_cos();
        put_derivative(9, wx_delta2_delta);
        let M_11_mB = self.zB * self.zB;
        put_derivative(10, M_11_mB);
        let t28 = self.rR * self.mR;
        let M_11_mH = self.zH * self.zH;
        put_derivative(11, M_11_mH);
        let M_11_mF = self.rF * self.rF;
        put_derivative(12, M_11_mF);
        let t35 = self.mH * M_11_mH + self.IHxx + self.IFxx + self.mF * M_11_mF;
        let t36 = self.w.like(1.0) / self.w;
        let M_11_rR = t28 + t28;
        put_derivative(13, M_11_rR);
        let M_11_mR = self.rR * self.rR;
        put_derivative(14, M_11_mR);
        let t39 = self.mH * self.xH;
        let M_12_wz_delta2_delta = self.IHxz - self.zH * t39;
        let t42 = self.mB * self.xB;
        let t43 = self.mH * self.zH;
        let M_11_zH = t43 + t43;
        put_derivative(15, M_11_zH);
        let t45 = self.c + self.w;
        let t46 = t45 - self.xH;
        let t50 = t36 * (self.IBxz + M_12_wz_delta2_delta - self.zB * t42);
        let t52 = self.IHxz + t43 * t46;
        let t55 = self.IFxx + self.IHzz + self.xH * t39;
        let t56 = self.c * t36;
        let t57 = self.w.like(1.0) / self.rF;
        let C1_22_wz_delta2_delta = self.mB * M_11_mB;
        let M_11 = self.IBxx + C1_22_wz_delta2_delta + self.rR * t28 + self.IRxx + t35;
        put_entry(0, M_11);
        let SF = self.IFyy * t57;
        let t65 = self.mF * self.rF;
        let M_11_rF = t65 + t65;
        put_derivative(16, M_11_rF);
        let t67 = self.w.like(1.0) / self.rR;
        let t68 = self.mB * self.zB;
        let K0_11 = t68 - (t28 + t65 - t43);
        put_entry(6, K0_11);
        let M_11_zB = t68 + t68;
        put_derivative(17, M_11_zB);
        let SR = self.IRyy * t67;
        let t74 = t39 + t42;
        let t75 = self.c + self.xB;
        let t76 = self.c + self.xH;
        let t78 = self.c * t50 + t52;
        let t80 = self.mF - t57 * SF;
        let t81 = SF + SR;
        let t83 = self.mR - t67 * SR;
        let t84 = t35 * wx_delta2_delta;
        let M_12_c = wx_delta2_delta_lam * (t50 + t43);
        put_derivative(18, M_12_c);
        let yaw_per_v_delta = wx_delta2_delta_lam * t36;
        put_derivative(19, yaw_per_v_delta);
        let K0_12_mH = self.zH * wx_delta2_delta
            + wx_delta2_delta_lam * (t46 - self.xH * t56);
        put_derivative(20, K0_12_mH);
        let t93 = t81 - K0_11;
        let t94 = wx_delta2_delta_lam * t39;
        let K2_12_IRyy = yaw_per_v_delta * t67;
        put_derivative(21, K2_12_IRyy);
        let K2_12_rF = yaw_per_v_delta * t80;
        put_derivative(22, K2_12_rF);
        let M_12_lam = t35 * wx_delta2_delta_lam - wx_delta2_delta * t78;
        put_derivative(23, M_12_lam);
        let M_12 = t84 + wx_delta2_delta_lam * t78;
        put_entry(1, M_12);
        let K2_12_rR = yaw_per_v_delta * t83;
        put_derivative(24, K2_12_rR);
        let K2_12_mF = self.rF * yaw_per_v_delta;
        put_derivative(25, K2_12_mF);
        let K2_12_IFyy = yaw_per_v_delta * t57;
        put_derivative(26, K2_12_IFyy);
        let t105 = M_12_wz_delta2_delta * yaw_per_v_delta;
        let ST = t84 + wx_delta2_delta_lam * t52 + self.c * t105;
        let t110 = wx_delta2_delta * M_12_wz_delta2_delta;
        let mu = self.c * yaw_per_v_delta;
        put_derivative(27, mu);
        let C1_12_rR = mu * t83;
        put_derivative(28, C1_12_rR);
        let t113 = mu * t68;
        put_derivative(29, t113);
        let C1_12_IRyy = mu * t67;
        put_derivative(30, C1_12_IRyy);
        let C1_21_rR = SR * C1_12_IRyy;
        put_derivative(31, C1_21_rR);
        let M_22_IRxx = mu * mu;
        put_derivative(32, M_22_IRxx);
        let C1_22_IRxx = yaw_per_v_delta * mu;
        put_derivative(33, C1_22_IRxx);
        let wz_delta2_delta = wx_delta2_delta_lam + mu;
        put_derivative(34, wz_delta2_delta);
        let t119 = t43 * wz_delta2_delta;
        put_derivative(35, t119);
        let t120 = wx_delta2_delta_lam * t43;
        let M_12_w = t120 - t50 * mu;
        put_derivative(36, M_12_w);
        let t124 = t50 + t56 * t93;
        let t125 = t36 * t93;
        let t126 = yaw_per_v_delta * t124;
        put_derivative(37, t126);
        let t128 = SF + t65 + t124;
        let t129 = wx_delta2_delta_lam * t65;
        let t130 = wx_delta2_delta * t125;
        put_derivative(38, t130);
        let K2_12 = wx_delta2_delta_lam * t125;
        put_entry(9, K2_12);
        put_derivative(39, K2_12);
        let t132 = t36 * K2_12;
        put_derivative(40, t132);
        let M_12_mH = self.zH * K0_12_mH;
        put_derivative(41, M_12_mH);
        let M_22_mH = K0_12_mH * K0_12_mH;
        put_derivative(42, M_22_mH);
        let K0_22_mH = wx_delta2_delta * K0_12_mH;
        put_derivative(43, K0_22_mH);
        let C1_12_rF = wz_delta2_delta * t80;
        put_derivative(44, C1_12_rF);
        let t137 = self.mH * K0_12_mH;
        let t142 = yaw_per_v_delta * (self.IRxx + t55 + self.IBzz + self.xB * t42);
        let C1_12 = wx_delta2_delta_lam * t128;
        put_entry(3, C1_12);
        let t144 = wx_delta2_delta * t128;
        put_derivative(45, t144);
        let t145 = t42 * mu;
        put_derivative(46, t145);
        let t146 = yaw_per_v_delta * t81;
        put_derivative(47, t146);
        let t147 = self.c * t146;
        let C1_21_w = t36 * t147;
        put_derivative(48, C1_21_w);
        let t149 = wx_delta2_delta_lam * SF;
        let C1_21 = -(t147 + t149);
        put_entry(4, C1_21);
        let t152 = self.rF * wx_delta2_delta;
        put_derivative(49, t152);
        let M_12_mF = self.rF * t152;
        put_derivative(50, M_12_mF);
        let t154 = wx_delta2_delta * t152;
        put_derivative(51, t154);
        let K2_22_mF = yaw_per_v_delta * t152;
        put_derivative(52, K2_22_mF);
        let t156 = self.mF * t152;
        let t157 = t56 * t142;
        let K0_12 = t137 - t156 - t145;
        put_entry(7, K0_12);
        let t160 = wx_delta2_delta * SF;
        let t161 = mu + mu;
        let M_22_xB = t145 * t161;
        put_derivative(53, M_22_xB);
        let t163 = self.xB * mu;
        put_derivative(54, t163);
        let t164 = self.zB * t163;
        put_derivative(55, t164);
        let M_22_mB = t163 * t163;
        put_derivative(56, M_22_mB);
        let t169 = t157 + yaw_per_v_delta * (t55 - t39 * t45);
        let K0_22 = wx_delta2_delta * K0_12;
        put_entry(8, K0_22);
        let t171 = wx_delta2_delta * t163;
        put_derivative(57, t171);
        let K2_22_mB = yaw_per_v_delta * t163;
        put_derivative(58, K2_22_mB);
        let C1_22_mB = t75 * K2_22_mB;
        put_derivative(59, C1_22_mB);
        let t175 = t36 * (t160 - K0_12);
        let t176 = self.mH * wx_delta2_delta_lam;
        let t177 = K0_12_mH + K0_12_mH;
        let t178 = yaw_per_v_delta * K0_12_mH;
        put_derivative(60, t178);
        let t179 = t76 * t178;
        put_derivative(61, t179);
        let t180 = yaw_per_v_delta * t74;
        let K0_12_w = t176 + t56 * t180;
        put_derivative(62, K0_12_w);
        let K0_12_c = t176 - t180;
        put_derivative(63, K0_12_c);
        let t188 = yaw_per_v_delta * (t94 + K0_12 + self.c * K0_12_c - t142);
        put_derivative(64, t188);
        let K0_22_w = wx_delta2_delta * K0_12_w;
        put_derivative(65, K0_22_w);
        let K2_22 = wx_delta2_delta_lam * t175;
        put_entry(10, K2_22);
        let t192 = yaw_per_v_delta * (t175 + K0_12_w);
        put_derivative(66, t192);
        let K0_22_c = wx_delta2_delta * K0_12_c;
        put_derivative(67, K0_22_c);
        let t194 = yaw_per_v_delta * K0_12_c;
        put_derivative(68, t194);
        let t195 = wx_delta2_delta * t56;
        let C1_21_lam = t160 + t81 * t195;
        put_derivative(69, C1_21_lam);
        let K0_12_zH = self.mH * wx_delta2_delta;
        put_derivative(70, K0_12_zH);
        let t203 = t129 + t46 * K0_12_zH - t120 - t74 * t195;
        put_derivative(71, t203);
        let M_12_zH = t137 + self.zH * K0_12_zH;
        put_derivative(72, M_12_zH);
        let M_22_zH = t177 * K0_12_zH;
        put_derivative(73, M_22_zH);
        let t207 = yaw_per_v_delta * K0_12_zH;
        put_derivative(74, t207);
        let t208 = t76 * t207;
        put_derivative(75, t208);
        let t210 = t36 * t110 + t169;
        let t211 = t36 * t176;
        put_derivative(76, t211);
        let t212 = t76 * t211;
        put_derivative(77, t212);
        let K2_12_mR = self.rR * yaw_per_v_delta;
        put_derivative(78, K2_12_mR);
        let C1_12_mR = self.c * K2_12_mR;
        put_derivative(79, C1_12_mR);
        let t215 = self.zB * yaw_per_v_delta;
        put_derivative(80, t215);
        let t216 = self.mB * t215;
        put_derivative(81, t216);
        let t217 = t215 * t75;
        put_derivative(82, t217);
        let t218 = self.mB * yaw_per_v_delta;
        put_derivative(83, t218);
        let t219 = t75 * t218;
        put_derivative(84, t219);
        let t220 = self.c * t218;
        put_derivative(85, t220);
        let t221 = wx_delta2_delta * t220;
        put_derivative(86, t221);
        let K2_22_xB = yaw_per_v_delta * t220;
        put_derivative(87, K2_22_xB);
        let t223 = self.mH * wz_delta2_delta;
        put_derivative(88, t223);
        let t224 = t177 * t223;
        put_derivative(89, t224);
        let t225 = wx_delta2_delta * t223;
        put_derivative(90, t225);
        let M_22_w = t176 * t177 - t210 * t161;
        put_derivative(91, M_22_w);
        let t235 = wz_delta2_delta * t55 + t45 * (t137 - t94) + t110 + self.c * t210;
        let K2_22_lam = yaw_per_v_delta * (t149 + t203) - wx_delta2_delta * t175;
        put_derivative(92, K2_22_lam);
        let C1_22_xB = (self.xB + t75) * K2_22_xB;
        put_derivative(93, C1_22_xB);
        let K2_22_xH = yaw_per_v_delta * t223;
        put_derivative(94, K2_22_xH);
        let t243 = t137 + t210;
        let M_22_c = wx_delta2_delta_lam * (t243 + t243);
        put_derivative(95, M_22_c);
        let t247 = t210 - t56 * K0_12;
        let t252 = yaw_per_v_delta * (t94 + t157 + t247 + self.c * K0_12_w);
        put_derivative(96, t252);
        let K0_22_lam = wx_delta2_delta_lam * K0_12 - wx_delta2_delta * t203;
        put_derivative(97, K0_22_lam);
        let t256 = t156 + t247;
        let C1_22_lam = wx_delta2_delta_lam * (t105 + t129 + t56 * t203)
            - wx_delta2_delta * (t169 + t256);
        put_derivative(98, C1_22_lam);
        let C1_22 = wx_delta2_delta_lam * t256;
        put_entry(5, C1_22);
        let M_12_rF = t156 + t156;
        put_derivative(99, M_12_rF);
        let M_22_rF = wx_delta2_delta * M_12_rF;
        put_derivative(100, M_22_rF);
        let t267 = self.zH * yaw_per_v_delta;
        put_derivative(101, t267);
        let t268 = self.mH * t267;
        put_derivative(102, t268);
        let t269 = t267 * t76;
        put_derivative(103, t269);
        let C1_22_IHzz = yaw_per_v_delta * wz_delta2_delta;
        put_derivative(104, C1_22_IHzz);
        let M_12_yaw_per_v_delta = t76 * C1_22_IHzz;
        let C1_22_xH = self.mH * (M_12_yaw_per_v_delta - t178);
        put_derivative(105, C1_22_xH);
        let K2_22_SF = wx_delta2_delta * yaw_per_v_delta;
        put_derivative(106, K2_22_SF);
        let K2_22_rF = K2_22_SF * t80;
        put_derivative(107, K2_22_rF);
        let K2_22_IFyy = t57 * K2_22_SF;
        put_derivative(108, K2_22_IFyy);
        let M_22 = wx_delta2_delta * ST + wx_delta2_delta_lam * t235;
        put_entry(2, M_22);
        let t282 = wx_delta2_delta_lam * ST - wx_delta2_delta * t235;
        let C1_12_IFyy = wz_delta2_delta * t57;
        put_derivative(109, C1_12_IFyy);
        let C1_21_rF = SF * C1_12_IFyy;
        put_derivative(110, C1_21_rF);
        let M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
        put_derivative(111, M_22_IHxx);
        let K0_22_zH = self.mH * M_22_IHxx;
        put_derivative(112, K0_22_zH);
        let M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
        put_derivative(113, M_22_IHzz);
        let M_22_mF = M_11_mF * M_22_IHxx;
        put_derivative(114, M_22_mF);
        let t289 = wx_delta2_delta * wz_delta2_delta;
        let M_22_IHxz = t289 + t289;
        put_derivative(115, M_22_IHxz);
        let t291 = self.mF * wx_delta2_delta;
        put_derivative(116, t291);
        let M_22_IFxx = M_22_IHxx + M_22_IHzz;
        put_derivative(117, M_22_IFxx);
        let C1_22_rF = wz_delta2_delta * t291;
        put_derivative(118, C1_22_rF);
        let t294 = wx_delta2_delta * t291;
        put_derivative(119, t294);
        let C1_12_mF = self.rF * wz_delta2_delta;
        put_derivative(120, C1_12_mF);
        let M_22_lam = t282 + t282;
        put_derivative(121, M_22_lam);
        let C1_22_mF = wx_delta2_delta * C1_12_mF;
        put_derivative(122, C1_22_mF);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl WhippleMechanism<f64> {
    /// The parameter set `benchmark`.
    ///
    /// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1
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
    pub const BENCHMARK: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3141592653589793, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.0603,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.05892, IHyy: 0.06, IHzz: 0.00708, IHxz: -0.00756,
        rF: 0.35, mF: 3.0, IFxx: 0.1405, IFyy: 0.28,
    };

    /// The parameter set `benchmark_2005`.
    ///
    /// Source: Schwab, Meijaard & Papadopoulos (2005), ENOC 2005
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
    pub const BENCHMARK_2005: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3217505543966422, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.06,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.0546, IHyy: 0.06, IHzz: 0.0114, IHxz: -0.0162, rF: 0.35,
        mF: 3.0, IFxx: 0.14, IFyy: 0.28,
    };

    /// A bicycle that balances itself without gyroscopic effects and without trail: two points of mass on skates.
    ///
    /// Source: Kooijman, Meijaard, Papadopoulos, Ruina & Schwab (2011), Science 332, 339-342
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `w` | 1 | `m` |
    /// | `c` | 0 | `m` |
    /// | `lam` | 0.08726646259971647 | `rad` |
    /// | `g` | 9.81 | `N/kg` |
    /// | `rR` | 0.1 | `m` |
    /// | `mR` | 0 | `kg` |
    /// | `IRxx` | 0 | `kg*m^2` |
    /// | `IRyy` | 0 | `kg*m^2` |
    /// | `xB` | 1.2 | `m` |
    /// | `zB` | -0.4 | `m` |
    /// | `mB` | 10 | `kg` |
    /// | `IBxx` | 0 | `kg*m^2` |
    /// | `IByy` | 0 | `kg*m^2` |
    /// | `IBzz` | 0 | `kg*m^2` |
    /// | `IBxz` | 0 | `kg*m^2` |
    /// | `xH` | 1.02 | `m` |
    /// | `zH` | -0.2 | `m` |
    /// | `mH` | 1 | `kg` |
    /// | `IHxx` | 0 | `kg*m^2` |
    /// | `IHyy` | 0 | `kg*m^2` |
    /// | `IHzz` | 0 | `kg*m^2` |
    /// | `IHxz` | 0 | `kg*m^2` |
    /// | `rF` | 0.1 | `m` |
    /// | `mF` | 0 | `kg` |
    /// | `IFxx` | 0 | `kg*m^2` |
    /// | `IFyy` | 0 | `kg*m^2` |
    pub const TWO_MASS_SKATE: Self = Self {
        w: 1.0, c: 0.0, lam: 0.08726646259971647, g: 9.81, rR: 0.1, mR: 0.0, IRxx: 0.0, IRyy: 0.0,
        xB: 1.2, zB: -0.4, mB: 10.0, IBxx: 0.0, IByy: 0.0, IBzz: 0.0, IBxz: 0.0, xH: 1.02, zH: -0.2,
        mH: 1.0, IHxx: 0.0, IHyy: 0.0, IHzz: 0.0, IHxz: 0.0, rF: 0.1, mF: 0.0, IFxx: 0.0, IFyy: 0.0,
    };
}

impl WhippleMechanism<f64> {
    /// The parameter set `benchmark`.
    #[must_use]
    pub const fn default() -> Self {
        Self::BENCHMARK
    }
}

/// The parameter set `benchmark`.
impl<T: Scalar> Default for WhippleMechanism<T> {
    fn default() -> Self {
        WhippleMechanism::cast(&WhippleMechanism::<f64>::BENCHMARK)
    }
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> WhippleMechanism<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 26]) -> Self {
        Self {
            w: values[0], c: values[1], lam: values[2], g: values[3], rR: values[4], mR: values[5],
            IRxx: values[6], IRyy: values[7], xB: values[8], zB: values[9], mB: values[10],
            IBxx: values[11], IByy: values[12], IBzz: values[13], IBxz: values[14], xH: values[15],
            zH: values[16], mH: values[17], IHxx: values[18], IHyy: values[19], IHzz: values[20],
            IHxz: values[21], rF: values[22], mF: values[23], IFxx: values[24], IFyy: values[25],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 26] {
        [
            self.w, self.c, self.lam, self.g, self.rR, self.mR, self.IRxx, self.IRyy, self.xB,
            self.zB, self.mB, self.IBxx, self.IByy, self.IBzz, self.IBxz, self.xH, self.zH, self.mH,
            self.IHxx, self.IHyy, self.IHzz, self.IHxz, self.rF, self.mF, self.IFxx, self.IFyy,
        ]
    }
}

impl<T: Scalar> WhippleMechanism<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> WhippleMechanism<U> {
        let values = self.to_array();
        WhippleMechanism::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl WhippleMechanism<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> WhippleMechanism<f32> {
        WhippleMechanism::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<WhippleMechanism<f32>> for WhippleMechanism<f64> {
    fn from(parameters: WhippleMechanism<f32>) -> Self {
        WhippleMechanism::cast(&parameters)
    }
}

impl<T: Number> WhippleMechanismMatrices<T> {
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

impl<T: Scalar> From<WhippleMechanismMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: WhippleMechanismMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for WhippleMechanism<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 26];

    type Over<U: Number> = WhippleMechanism<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "WhippleMechanism",
        docs: "The Whipple-Carvallo bicycle, derived from its bodies, joints and wheels.\n\nFour rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally\nsymmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,\nx forward, y to the right, z down, so that a centre of mass above the ground has z < 0.\n\nThe declaration asserts that the matrices are those of Appendix A of the paper, which is proved when it is compiled.\n[`Whipple`](crate::Whipple) computes them from these formulas.",
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
                source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1",
                values: &WhippleMechanism::to_array(&WhippleMechanism::<f64>::BENCHMARK),
            },
            SetInfo {
                name: "benchmark_2005",
                docs: "",
                source: "Schwab, Meijaard & Papadopoulos (2005), ENOC 2005",
                values: &WhippleMechanism::to_array(&WhippleMechanism::<f64>::BENCHMARK_2005),
            },
            SetInfo {
                name: "two_mass_skate",
                docs: "A bicycle that balances itself without gyroscopic effects and without trail: two points of mass on skates.",
                source: "Kooijman, Meijaard, Papadopoulos, Ruina & Schwab (2011), Science 332, 339-342",
                values: &WhippleMechanism::to_array(&WhippleMechanism::<f64>::TWO_MASS_SKATE),
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
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg", "yaw_per_v_delta*(ST - Sz_all)"),
            FormulaInfo::entry(&[(MatrixName::K2, 1, 1)], "kg", "yaw_per_v_delta*(SF*sin(lam) + P_delta_lateral)"),
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
            FormulaInfo::attribute("F_mass", "the mass of the front wheel F", "kg", "mF"),
            FormulaInfo::attribute("F_radius", "the radius of the front wheel F", "m", "rF"),
            FormulaInfo::attribute("F_axial", "the axial inertia of the front wheel F", "kg*m^2", "IFyy"),
            FormulaInfo::attribute("F_radial", "the radial inertia of the front wheel F", "kg*m^2", "IFxx"),
            FormulaInfo::attribute("F_x", "x of the centre of the front wheel F", "m", "w"),
            FormulaInfo::attribute("F_z", "z of the centre of the front wheel F", "m", "-rF"),
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
                    "T0=1/sqrt(A26^2+A27^2);C4=A26*T0;C5=A27*T0;C6=C5*A25+C4*A18;C7=C4*A25-C5*A18;T1=A23-A25;C8=C5*T1-C4*A24",
                    "C9=C4*T1+C5*A24;C10=C7+C9;T2=A2-A18;T3=C5*A1-C4*T2;C11=A0*T3;T4=C4*A1+C5*T2;C12=A0*T4;T5=C5*A4;T6=C4*A3+T5",
                    "T7=C4*A4;T8=T7+C5*A6;C13=C5*T6-C4*T8-C11*T4;T9=T4*C12;T10=T3*C11;C14=A5+T9+T10;C15=A0+A14",
                    "C16=T9+A17+C5*(C5*A3-T7)-C4*(T5-C4*A6);C17=T10+A17+C4*T6+C5*T8;C18=A7+A19;T11=A8-A25;T12=C5*T11-C4*A9",
                    "T13=A7*T12;T14=C8*A19;C19=T13+T14;T15=C4*T11+C5*A9;T16=A7*T15;T17=C9*A19;C20=T16+T17;T18=C4*A11;T19=C5*A11",
                    "T20=T15*T16+C9*T17;C21=A22+C5*(C5*A10-T18)+T20-C4*(T19-C4*A13);T21=T19+C4*A10;T22=T18+C5*A13",
                    "C22=C5*T21-C4*T22-T13*T15-C9*T14;T23=T12*T13+C8*T14;C23=T20+A12+T23;C24=A22+T23+C4*T21+C5*T22;C26=C21-C23",
                    "C27=C6*C18;T24=C7*C20;T25=C7*C18;C28=T24+T24+C7*T25;C29=C6*C20;C30=C7*C27;C31=C6*C27;C32=C12+C20+T25",
                    "C33=A15*(C15+C18);C34=A15*C33;C0=A16;C1=A21;C2=A15;C3=A20;C25=P3;C35=C34",
                ],
                closure: &[
                    "T0=cos(Q3);T1=cos(Q5);T2=sin(Q4);T3=cos(Q4);T4=C5*T2+C4*T3;T5=T0*T4;T6=sin(Q3);T7=sin(Q5);T8=T6*T7",
                    "T9=T8-T1*T5;T10=C5*T3-T2*C4;T11=T0*T10;T12=sqrt(T9^2+T11^2);T13=C6+T1*C8",
                    "R0=C3*T12+T8*C8+T0*(T10*C10-T4*T13)-C2*T0;T14=1/T12;T15=T11*T14",
                    "T16=C3*(T1*T6+T5*T7)*(T0*T7*T15+T6*(T9*T10*T14+T1*T4*T15));R1=R0/(T0*(T16+T4*C10+T10*T13))",
                ],
                accelerations: &[
                    "T0=sin(Q3);T1=sin(Q4);T2=cos(Q4);T3=C5*T1+C4*T2;T4=cos(Q5);T5=cos(Q3);T6=T3*T5;T7=sin(Q5);T8=T0*T7-T4*T6",
                    "T9=C5*T2-T1*C4;T10=T5*T9;T11=sqrt(T8^2+T10^2);T12=1/T11;T13=T8*T12;T14=T10*T12;T15=T4*T14;T16=T9*T15-T3*T13",
                    "T17=T0*T4+T6*T7;T18=C3*T17;T19=T7*C8;T20=C6+T4*C8;T21=T9*C10-T3*T20;T22=T5*T19-T16*T18-T0*T21;T23=C2*T0+T22",
                    "T24=T5*T7*T14+T0*(T9*T13+T3*T15);T25=T18*T24+T3*C10+T9*T20;T26=1/(T5*T25);T27=T23*T26;T28=T9*C7-T3*C6",
                    "T29=T22+T0*T28;T30=T0*T9;T31=T25-T3*C7-T9*C6;T32=T26*(T3*T29+T30*T31);R4=U0*T27+U1*T32;T33=U2+R4;T34=C2*T33",
                    "T35=cos(Q2);T36=sin(Q2);T37=T0*T25;T38=T0*T23;T39=T16*T37+T24*T38;T40=1/(T16*T25+T23*T24);T41=T27*T39*T40",
                    "T42=T11*C3+T0*T19+T5*T21-T5*T28;T43=T10*T31-T3*T42;T44=T30*T42+T10*T29;T45=T40*(T16*T43+T24*T44+T32*T39)",
                    "T46=C2*T24*T40;T47=U0*T41+U1*T45+U2*T46;T48=T24*T37-T16*T38;T49=T24*T25-T16*T23;T50=1/C3",
                    "T51=(T41*T49-T27*T48)*T50;T52=T50*(T16*T44+T45*T49-T24*T43-T32*T48);T53=T50*(C2*T16+T46*T49)",
                    "R7=U0*T51+U1*T52+U2*T53;T54=T5*T47;T55=U0*T54;T56=U0*T3-T9*T54;T57=T0*T47;T58=R4-T57;T59=C7*T58",
                    "T60=U0*T9+T3*T54;T61=C6*T58;T62=T56*T59+T60*T61;T63=U0*T57;T64=R4*T60;T65=T9*T63+T64;T66=R4*T56",
                    "T67=T3*T63+T66;T68=C2*T57;T69=T54*T68-T34*T54;T70=T62+C6*T65+C7*T67-T69;T71=C6*T56-C7*T60",
                    "T72=T58*T61+T56*T71;T73=C2*U0;T74=T54*T73;T75=T74+C2*T55;T76=T68*(T33-T57)-U0*T73",
                    "T77=T9*T75+T3*T76-T72-C7*T55;T78=U1+T56;T79=T4*T58-T7*T60;T80=C9*T79;T81=T4*T60+T7*T58;T82=C8*T79;T83=U1*T79",
                    "T84=T83-T4*T67-T7*T55;T85=T13*C3;T86=T14*C3;T87=T12*T17*(T13*T81+T14*T78);T88=T86*T87;T89=T85*T87",
                    "T90=T4*T70+T78*T80+T81*T82+C8*T65+T85*(T65+R7*T81)+T78*T88;T91=T90+T81*T89-T7*T77-C9*T84-T86*(T84-R7*T78)",
                    "T92=C8*T78-C9*T81;T93=U1*T81;T94=T7*T67-T4*T55-T93;T95=R7+T79;T96=C3*(T13*T78-T14*T81)",
                    "T97=T4*T77+T7*T70+C9*T94+T86*T94-T79*T82-T78*T92;T98=T97-T89*T95-T78*T96;T99=T60*T71-T58*T59",
                    "T100=T99+C6*T55+T3*T75+T81*T92+T81*T96-T9*T76;T101=T100-T79*T80-C8*T94-T85*T94-T88*T95;T102=T13*T98+T14*T101",
                    "T103=T26*(T17*T91+T11*T102);T104=T40*(T11*T91+T39*T103-T17*T102);T105=T103-T55-T0*T104;T106=T76+T5*C25",
                    "T107=C2*T105-T74;T108=T9*T106+T3*T107;T109=T99-T108-C6*T105;T110=T63-T5*T104;T111=T66+T3*T110",
                    "T112=T4*T105+T7*T111-T93;T113=T78*C19-T81*C20;T114=T79*C20;T115=T109*C18+T81*T113-C19*T112-T79*T114",
                    "T116=T56*C11-C12*T60;T117=C12*T58;T118=T3*(T115+T60*T116-T108*C15-T105*C11-T58*T117);T119=T3*T106-T9*T107",
                    "T120=T119+C7*T105-T72;T121=T64+T9*T110;T122=T69+T0*C25;T123=T62+C6*T121+C7*T111-T122;T124=T4*T120+T7*T123",
                    "T125=T79*C19;T126=T124*C18+C20*T112-T79*T125-T78*T113;T127=T4*T123-T7*T120;T128=T83+T7*T105-T4*T111",
                    "T129=T127*C18+T121*C19+T78*T114+T81*T125-C20*T128;T130=T4*T126-T7*T129;T131=T58*C11",
                    "T132=T9*(T130+T119*C15+C12*T105-T58*T131-T56*T116);T133=T105*C0-C2*(T118+T132);T134=T0*T46",
                    "T135=T60*C16+T56*C13;T136=T60*C13+T56*C17;T137=T81*C22+T78*C24;T138=T79*C23+T95*C1",
                    "T139=C21*T128+T121*C22+T79*T137-C20*T127-T78*T138;T140=T50*(T13*T101+T49*T104-T14*T98-T48*T103)",
                    "T141=C1*(T112+T140);T142=T81*C21+T78*C22;T143=C20*T124+C23*T112+T141+T78*T142-C19*T109-T81*T137",
                    "T144=C12*T119+C11*T108+T105*C14+T56*T135+T7*T139+T4*T143;T145=T144+C7*T130+T133-T60*T136-C6*T115;T146=T5*T46",
                    "T147=T58*C14+C0*(U2+T58);T148=T127*C19+T128*C22+T121*C24+T81*T138-T79*T142;T149=T7*T126+T4*T129",
                    "T150=C17*T121+T60*T147+T148+C6*T149-C11*T122-C13*T111;T151=T150-T58*T135",
                    "T152=C12*T122+C13*T121+T58*T136+T4*T139-C16*T111-T56*T147;T153=T152-T7*T143-C7*T149;T154=T9*T151-T3*T153",
                    "T155=T149+C11*T121+C12*T111+T56*T117+T60*T131-T122*C15;T156=T27-T0*T41;T157=T5*T41",
                    "T158=F0+T154*T157-T3*T151-T9*T153-C2*T155-T145*T156;T159=T158-T51*T141;T160=T7*C19;T161=T7*C22-C7*T160",
                    "T162=T7*C26;T163=T4*T162-C6*T160;T164=T3*T161+T9*T163;T165=T4*C19;T166=T4*C22-C7*T165;T167=C13+T166-C29-C30",
                    "T168=T7*T162;T169=C16+C21+C28-T168;T170=C6*T165;T171=T170+T170+C31;T172=C17+C24+T171;T173=T172-T169",
                    "T174=T3*T9;T175=T3^2;T176=T167+T167;T177=C11+T165+C27;T178=T167+T173*T174+C2*(T3*C32+T9*T177)-T175*T176",
                    "T179=T9*C32-T3*T177;T180=C2*(T179-C33);T181=C2*T179;T182=C34-T181-T181;T183=C14+C23+T168+C28+T171+T182",
                    "T184=C2*T160;T185=T9*T161+T184-T3*T163;T186=T180+T134*T183+T146*T185;T187=T173*T175+T174*T176;T188=T172-T187",
                    "T189=T184-T134*T185-T146*T188;T190=1.0-T134;T191=C0*T156;T192=T3*T7;T193=T53-T4*T134-T146*T192",
                    "T194=T51+T4*T156-T7*T9-T157*T192;T195=C1*T194",
                    "T196=T190*T191+T193*T195-T134*T164-T146*T178-T156*T186-T157*T189",
                    "T197=T169+T182+T187+T156*T164+T156*(T164+T156*T183-T157*T185)+T156*T191",
                    "T198=T197+T194*T195-T157*T178-T157*(T178+T156*T185-T157*T188);T199=1/T198;T200=T196*T199;T201=T9*T184",
                    "T202=T32-T0*T45;T203=T5*T45;T204=T161+T201;T205=C24+T170;T206=T9*T205-T3*T166;T207=C0*T202",
                    "T208=T52+T4*T202-T192*T203;T209=C1*T208;T210=T204+T183*T202-T185*T203;T211=T206+T185*T202-T188*T203",
                    "T212=T3*T205+T9*T166+C2*T165+T164*T202+T156*T210+T191*T202;T213=T199*(T212+T195*T208-T178*T203-T157*T211)",
                    "T214=T198*T213;T215=T201+T190*T207+T193*T209-T186*T202-T189*T203-T134*T204",
                    "T216=C24+T202*T210+T202*T204+T202*T207+T208*T209-T203*T211;T217=T216-T203*T206-T213*T214;T218=1/T217",
                    "T219=(T215-T146*T206-T200*T214)*T218;T220=F1+T154*T203-T148-T145*T202-T52*T141-T159*T213",
                    "T221=T134*T145+T146*T154-T133-T53*T141-T159*T200-T219*T220",
                    "T222=T134*T186+T134*T180+C35+C0*T190*T190+C1*T193*T193-T146*T189",
                    "R14=T221/(T222-T146*T184-T198*T200*T200-T217*T219*T219);R13=T218*T220-T219*R14",
                    "R11=T159*T199-T213*R13-T200*R14;R12=T103+T27*R11+T32*R13;T223=C2*(R14+R12);T224=T34*T47;R9=T35*T224-T36*T223",
                    "R15=T140+T51*R11+T52*R13+T53*R14;R0=-(T34*T35);R1=-(T34*T36);R2=-T47;R8=-(T35*T223+T36*T224)",
                    "R10=-(T104+T41*R11+T45*R13+T46*R14);R3=U0;R5=U1;R6=U2",
                ],
            },
        ),
        gravity: Some(3),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("WhippleMechanism", 26, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("WhippleMechanism", 26, values)?;
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
        Coefficients::from_rows(WhippleMechanismMatrices::rows(&self.matrices()))
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

impl WhippleMechanism<f64> {
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
impl<T: Scalar> core::fmt::Display for WhippleMechanism<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for WhippleMechanism<T> {
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
            IFyy: parameter(25),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        WhippleMechanismMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        WhippleMechanismMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> WhippleMechanismDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<WhippleMechanismMatrices<T>> {
        if parameter >= 26 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = WhippleMechanismMatrices {
            m: Rows([[zero; 2]; 2]), c1: Rows([[zero; 2]; 2]), k0: Rows([[zero; 2]; 2]),
            k2: Rows([[zero; 2]; 2]),
        };
        for position in 0..158 {
            let partial = <WhippleMechanismDerivatives>::PARTIALS[position];
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

impl<T: Scalar> Differentiable<2> for WhippleMechanism<T> {
    type Derivatives = [Coefficients<T, 2>; 26];

    type WithDerivativesOver<U: Number> = WhippleMechanism<U>;

    const PARTIALS: &'static [Partial] = <WhippleMechanismDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 26];
        for position in 0..158 {
            Partial::write(&<WhippleMechanismDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(WhippleMechanismMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for WhippleMechanism<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl WhippleMechanismDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 158] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 36),
        Partial::new(MatrixName::M, 1, 0, 0, 36),
        Partial::new(MatrixName::M, 1, 1, 0, 91),
        Partial::new(MatrixName::C1, 0, 1, 0, 37).negative(),
        Partial::new(MatrixName::C1, 1, 0, 0, 48),
        Partial::new(MatrixName::C1, 1, 1, 0, 96).negative(),
        Partial::new(MatrixName::K0, 0, 1, 0, 62),
        Partial::new(MatrixName::K0, 1, 0, 0, 62),
        Partial::new(MatrixName::K0, 1, 1, 0, 65),
        Partial::new(MatrixName::K2, 0, 1, 0, 40).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 66).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 18), Partial::new(MatrixName::M, 1, 0, 1, 18),
        Partial::new(MatrixName::M, 1, 1, 1, 95), Partial::new(MatrixName::C1, 0, 1, 1, 39),
        Partial::new(MatrixName::C1, 1, 0, 1, 47).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 64).negative(),
        Partial::new(MatrixName::K0, 0, 1, 1, 63),
        Partial::new(MatrixName::K0, 1, 0, 1, 63),
        Partial::new(MatrixName::K0, 1, 1, 1, 67),
        Partial::new(MatrixName::K2, 1, 1, 1, 68).negative(),
        Partial::new(MatrixName::M, 0, 1, 2, 23),
        Partial::new(MatrixName::M, 1, 0, 2, 23),
        Partial::new(MatrixName::M, 1, 1, 2, 121),
        Partial::new(MatrixName::C1, 0, 1, 2, 45).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 69),
        Partial::new(MatrixName::C1, 1, 1, 2, 98),
        Partial::new(MatrixName::K0, 0, 1, 2, 71).negative(),
        Partial::new(MatrixName::K0, 1, 0, 2, 71).negative(),
        Partial::new(MatrixName::K0, 1, 1, 2, 97),
        Partial::new(MatrixName::K2, 0, 1, 2, 38).negative(),
        Partial::new(MatrixName::K2, 1, 1, 2, 92), Partial::new(MatrixName::M, 0, 0, 4, 13),
        Partial::new(MatrixName::C1, 0, 1, 4, 28), Partial::new(MatrixName::C1, 1, 0, 4, 31),
        Partial::new(MatrixName::K0, 0, 0, 4, 1).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 24), Partial::new(MatrixName::M, 0, 0, 5, 14),
        Partial::new(MatrixName::C1, 0, 1, 5, 79),
        Partial::new(MatrixName::K0, 0, 0, 5, 0).negative(),
        Partial::new(MatrixName::K2, 0, 1, 5, 78), Partial::new(MatrixName::M, 0, 0, 6, 8),
        Partial::new(MatrixName::M, 1, 1, 6, 32), Partial::new(MatrixName::C1, 1, 1, 6, 33),
        Partial::new(MatrixName::C1, 0, 1, 7, 30),
        Partial::new(MatrixName::C1, 1, 0, 7, 30).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 21),
        Partial::new(MatrixName::M, 0, 1, 8, 29).negative(),
        Partial::new(MatrixName::M, 1, 0, 8, 29).negative(),
        Partial::new(MatrixName::M, 1, 1, 8, 53),
        Partial::new(MatrixName::C1, 0, 1, 8, 81).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 93),
        Partial::new(MatrixName::K0, 0, 1, 8, 85).negative(),
        Partial::new(MatrixName::K0, 1, 0, 8, 85).negative(),
        Partial::new(MatrixName::K0, 1, 1, 8, 86).negative(),
        Partial::new(MatrixName::K2, 1, 1, 8, 87), Partial::new(MatrixName::M, 0, 0, 9, 17),
        Partial::new(MatrixName::M, 0, 1, 9, 46).negative(),
        Partial::new(MatrixName::M, 1, 0, 9, 46).negative(),
        Partial::new(MatrixName::C1, 0, 1, 9, 84).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 3),
        Partial::new(MatrixName::K2, 0, 1, 9, 83).negative(),
        Partial::new(MatrixName::M, 0, 0, 10, 10),
        Partial::new(MatrixName::M, 0, 1, 10, 55).negative(),
        Partial::new(MatrixName::M, 1, 0, 10, 55).negative(),
        Partial::new(MatrixName::M, 1, 1, 10, 56),
        Partial::new(MatrixName::C1, 0, 1, 10, 82).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 59),
        Partial::new(MatrixName::K0, 0, 0, 10, 2),
        Partial::new(MatrixName::K0, 0, 1, 10, 54).negative(),
        Partial::new(MatrixName::K0, 1, 0, 10, 54).negative(),
        Partial::new(MatrixName::K0, 1, 1, 10, 57).negative(),
        Partial::new(MatrixName::K2, 0, 1, 10, 80).negative(),
        Partial::new(MatrixName::K2, 1, 1, 10, 58), Partial::new(MatrixName::M, 0, 0, 11, 8),
        Partial::new(MatrixName::M, 1, 1, 13, 32), Partial::new(MatrixName::C1, 1, 1, 13, 33),
        Partial::new(MatrixName::M, 0, 1, 14, 27), Partial::new(MatrixName::M, 1, 0, 14, 27),
        Partial::new(MatrixName::C1, 0, 1, 14, 19),
        Partial::new(MatrixName::M, 0, 1, 15, 35).negative(),
        Partial::new(MatrixName::M, 1, 0, 15, 35).negative(),
        Partial::new(MatrixName::M, 1, 1, 15, 89).negative(),
        Partial::new(MatrixName::C1, 0, 1, 15, 102).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 105),
        Partial::new(MatrixName::K0, 0, 1, 15, 88).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 88).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 90).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 94), Partial::new(MatrixName::M, 0, 0, 16, 15),
        Partial::new(MatrixName::M, 0, 1, 16, 72), Partial::new(MatrixName::M, 1, 0, 16, 72),
        Partial::new(MatrixName::M, 1, 1, 16, 73),
        Partial::new(MatrixName::C1, 0, 1, 16, 77).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 75).negative(),
        Partial::new(MatrixName::K0, 0, 0, 16, 5), Partial::new(MatrixName::K0, 0, 1, 16, 70),
        Partial::new(MatrixName::K0, 1, 0, 16, 70), Partial::new(MatrixName::K0, 1, 1, 16, 112),
        Partial::new(MatrixName::K2, 0, 1, 16, 76).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 74).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 11), Partial::new(MatrixName::M, 0, 1, 17, 41),
        Partial::new(MatrixName::M, 1, 0, 17, 41), Partial::new(MatrixName::M, 1, 1, 17, 42),
        Partial::new(MatrixName::C1, 0, 1, 17, 103).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 61).negative(),
        Partial::new(MatrixName::K0, 0, 0, 17, 4), Partial::new(MatrixName::K0, 0, 1, 17, 20),
        Partial::new(MatrixName::K0, 1, 0, 17, 20), Partial::new(MatrixName::K0, 1, 1, 17, 43),
        Partial::new(MatrixName::K2, 0, 1, 17, 101).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 60).negative(),
        Partial::new(MatrixName::M, 0, 0, 18, 8), Partial::new(MatrixName::M, 0, 1, 18, 9),
        Partial::new(MatrixName::M, 1, 0, 18, 9), Partial::new(MatrixName::M, 1, 1, 18, 111),
        Partial::new(MatrixName::M, 1, 1, 20, 113), Partial::new(MatrixName::C1, 1, 1, 20, 104),
        Partial::new(MatrixName::M, 0, 1, 21, 34), Partial::new(MatrixName::M, 1, 0, 21, 34),
        Partial::new(MatrixName::M, 1, 1, 21, 115), Partial::new(MatrixName::C1, 0, 1, 21, 19),
        Partial::new(MatrixName::C1, 1, 1, 21, 106), Partial::new(MatrixName::M, 0, 0, 22, 16),
        Partial::new(MatrixName::M, 0, 1, 22, 99), Partial::new(MatrixName::M, 1, 0, 22, 99),
        Partial::new(MatrixName::M, 1, 1, 22, 100), Partial::new(MatrixName::C1, 0, 1, 22, 44),
        Partial::new(MatrixName::C1, 1, 0, 22, 110), Partial::new(MatrixName::C1, 1, 1, 22, 118),
        Partial::new(MatrixName::K0, 0, 0, 22, 7).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 116).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 116).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 119).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 22), Partial::new(MatrixName::K2, 1, 1, 22, 107),
        Partial::new(MatrixName::M, 0, 0, 23, 12), Partial::new(MatrixName::M, 0, 1, 23, 50),
        Partial::new(MatrixName::M, 1, 0, 23, 50), Partial::new(MatrixName::M, 1, 1, 23, 114),
        Partial::new(MatrixName::C1, 0, 1, 23, 120), Partial::new(MatrixName::C1, 1, 1, 23, 122),
        Partial::new(MatrixName::K0, 0, 0, 23, 6).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 49).negative(),
        Partial::new(MatrixName::K0, 1, 0, 23, 49).negative(),
        Partial::new(MatrixName::K0, 1, 1, 23, 51).negative(),
        Partial::new(MatrixName::K2, 0, 1, 23, 25), Partial::new(MatrixName::K2, 1, 1, 23, 52),
        Partial::new(MatrixName::M, 0, 0, 24, 8), Partial::new(MatrixName::M, 0, 1, 24, 9),
        Partial::new(MatrixName::M, 1, 0, 24, 9), Partial::new(MatrixName::M, 1, 1, 24, 117),
        Partial::new(MatrixName::C1, 1, 1, 24, 104), Partial::new(MatrixName::C1, 0, 1, 25, 109),
        Partial::new(MatrixName::C1, 1, 0, 25, 109).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 26),
        Partial::new(MatrixName::K2, 1, 1, 25, 108),
    ];
}
