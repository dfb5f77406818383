// @generated from generated/models/whipple_mechanism.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: d2f6051b9c7ec604

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    FormulaInfo, LengthError, MatrixName, Model, ModelInfo, Nonlinear, Number,
    ParameterError, ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo, WithDerivatives,
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
    /// 47 additions, 44 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 98 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleMechanismMatrices<T> {
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
        let yaw_per_v_delta = cos_lam / self.w;
        let mu = self.c * yaw_per_v_delta;
        let Sz_delta = t6 - t10;
        let Jxz_all = Jxz_delta + self.IBxz - t21 * self.xB - t35 * Sz_delta;
        let M_12 = hx_delta + mu * Jxz_all;
        let t57 = self.mH * t36;
        let t59 = self.mF * self.c;
        let Jzz_delta = self.IFxx + self.IHzz + t36 * t57 + self.c * t59;
        let hz_delta = sin_lam * Jxz_delta + cos_lam * Jzz_delta;
        let t67 = t57 + t59;
        let t69 = sin_lam * Sz_delta + cos_lam * t67;
        let M_yaw_delta = hz_delta - t35 * t69;
        let t73 = self.mB * self.xB;
        let mA = self.mH + self.mF;
        let t77 = t67 - t35 * mA;
        let P_delta_yaw = M_yaw_delta
            + mu
                * (self.IRxx + Jzz_delta + self.IBzz + self.xB * t73
                    - t35 * (t67 + t77));
        let M_22 = mu * (M_yaw_delta + P_delta_yaw) + sin_lam * hx_delta
            + cos_lam * hz_delta;
        let zero = self.w.like(0.0);
        let SF = self.IFyy / self.rF;
        let ST = SF + self.IRyy / self.rR;
        let Sz_all = t21 + Sz_delta - t17;
        let t100 = ST - Sz_all;
        let t103 = cos_lam * SF;
        let C1_12 = mu * t100 + yaw_per_v_delta * Jxz_all + t103;
        let Sx_all = t73 - t77;
        let t109 = mu * Sx_all;
        let P_delta_lateral = t109 - t69;
        let C1_22 = mu * P_delta_lateral + yaw_per_v_delta * P_delta_yaw;
        let K2_12 = yaw_per_v_delta * t100;
        let K2_22 = yaw_per_v_delta * (P_delta_lateral + sin_lam * SF);
        let C1_21 = -(t103 + mu * ST);
        let K0_12 = t69 - t109;
        let K0_22 = -(sin_lam * P_delta_lateral);
        WhippleMechanismMatrices::from_entries([
            M_11, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, Sz_all, K0_12, K0_12, K0_22, zero,
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleMechanismMotion<T = f64> {
    constants: [T; 36],
}

impl<T: Scalar> WhippleMechanism<T> {
    /// The nonlinear equations of motion, of what is computed once for these parameters:
    /// 54 additions, 64 multiplications and 2 trigonometric functions: 120 operations.
    ///
    /// The parameters are not validated.
    #[must_use]
    pub fn motion(&self) -> WhippleMechanismMotion<T> {
        let t2 = self.mR + self.mB;
        let t7 = self.mH + self.mF;
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t15 = self.w + self.c;
        let t18 = cos_lam * t15 - self.rR * sin_lam;
        let t21 = sin_lam * t15 + self.rR * cos_lam;
        let t22 = self.w - t15;
        let t25 = cos_lam * t22 + self.rF * sin_lam;
        let t28 = sin_lam * t22 - self.rF * cos_lam;
        let t29 = t21 + t28;
        let t33 = self.rR + self.zB;
        let t35 = cos_lam * self.xB - sin_lam * t33;
        let t36 = self.mB * t35;
        let t39 = sin_lam * self.xB + cos_lam * t33;
        let t40 = self.mB * t39;
        let t44 = cos_lam * self.IBxz;
        let t45 = sin_lam * self.IBxx + t44;
        let t47 = sin_lam * self.IBxz;
        let t50 = t47 + cos_lam * self.IBzz;
        let t54 = cos_lam * t45 - sin_lam * t50 - t36 * t39;
        let t56 = t39 * t40;
        let t57 = t35 * t36;
        let t59 = self.IByy + t56 + t57;
        let t69 = t56 + self.IRxx + cos_lam * (cos_lam * self.IBxx - t47)
            - sin_lam * (t44 - sin_lam * self.IBzz);
        let t74 = t57 + self.IRxx + sin_lam * t45 + cos_lam * t50;
        let t76 = self.xH - t15;
        let t80 = cos_lam * t76 - sin_lam * self.zH;
        let t81 = self.mH * t80;
        let t82 = self.mF * t25;
        let t83 = t81 + t82;
        let t86 = sin_lam * t76 + cos_lam * self.zH;
        let t87 = self.mH * t86;
        let t88 = self.mF * t28;
        let t89 = t87 + t88;
        let t94 = sin_lam * self.IHxz;
        let t97 = cos_lam * self.IHxz;
        let t104 = t86 * t87 + t28 * t88;
        let t107 = self.IFxx + cos_lam * (cos_lam * self.IHxx - t94) + t104
            - sin_lam * (t97 - sin_lam * self.IHzz);
        let t109 = t97 + sin_lam * self.IHxx;
        let t112 = t94 + cos_lam * self.IHzz;
        let t118 = cos_lam * t109 - sin_lam * t112 - t81 * t86 - t28 * t82;
        let t122 = t80 * t81 + t25 * t82;
        let t124 = t104 + self.IHyy + t122;
        let t129 = self.IFxx + t122 + sin_lam * t109 + cos_lam * t112;
        let t131 = t107 - t124;
        let t132 = t7 * t18;
        let t133 = t21 * t89;
        let t134 = t7 * t21;
        let t137 = t133 + t133 + t21 * t134;
        let t138 = t18 * t89;
        let t139 = t21 * t132;
        let t140 = t18 * t132;
        let t142 = t40 + t89 + t134;
        let t144 = self.rR * (t2 + t7);
        let t145 = self.rR * t144;
        WhippleMechanismMotion {
            constants: [
                t2, self.rR, self.rF, t7, cos_lam, sin_lam, self.IRyy, self.IFyy, t18, t21, t25,
                t28, t29, t36, t40, t54, t59, t69, t74, t83, t89, t107, t118, t124, t129, self.g,
                t131, t132, t137, t138, t139, t140, t142, t144, t145, t145,
            ],
        }
    }
}

impl<T: Scalar> Nonlinear<2> for WhippleMechanism<T> {
    type Motion = WhippleMechanismMotion<T>;

    fn motion(&self) -> WhippleMechanismMotion<T> {
        WhippleMechanism::motion(self)
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
impl<T: Scalar> carvallo::motion::Unchecked for WhippleMechanismMotion<T> {
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
        let t14 = self.constants[4] * sin_pitch + self.constants[5] * cos_pitch;
        let t15 = cos_phi * t14;
        let t19 = sin_phi * sin_delta;
        let t20 = t19 - cos_delta * t15;
        let t24 = self.constants[4] * cos_pitch - sin_pitch * self.constants[5];
        let t25 = cos_phi * t24;
        let t28 = (t20 * t20 + t25 * t25).sqrt();
        let t36 = self.constants[8] + cos_delta * self.constants[10];
        let t42 = self.constants[2] * t28 + t19 * self.constants[10]
            + cos_phi * (t24 * self.constants[12] - t14 * t36)
            - self.constants[1] * cos_phi;
        let t46 = self.constants[0].like(1.0) / t28;
        let t47 = t25 * t46;
        let t58 = self.constants[2] * (cos_delta * sin_phi + t15 * sin_delta)
            * (cos_phi * sin_delta * t47
                + sin_phi * (t20 * t24 * t46 + cos_delta * t14 * t47));
        let t64 = t42 / (cos_phi * (t58 + t14 * self.constants[12] + t24 * t36));
        ([t42], [t64])
    }

    fn rates_unchecked(&self, positions: &[T; 8], speeds: &[T; 3]) -> [T; 8] {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t13 = self.constants[4] * sin_pitch + self.constants[5] * cos_pitch;
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t17 = t13 * cos_phi;
        let t21 = sin_phi * sin_delta - cos_delta * t17;
        let t25 = self.constants[4] * cos_pitch - sin_pitch * self.constants[5];
        let t26 = cos_phi * t25;
        let t29 = (t21 * t21 + t26 * t26).sqrt();
        let t30 = self.constants[0].like(1.0) / t29;
        let t31 = t21 * t30;
        let t33 = t26 * t30;
        let t34 = cos_delta * t33;
        let t36 = t25 * t34 - t13 * t31;
        let t41 = self.constants[2] * (sin_phi * cos_delta + t17 * sin_delta);
        let t44 = sin_delta * self.constants[10];
        let t50 = self.constants[8] + cos_delta * self.constants[10];
        let t52 = t25 * self.constants[12] - t13 * t50;
        let t55 = cos_phi * t44 - t36 * t41 - sin_phi * t52;
        let t56 = self.constants[1] * sin_phi + t55;
        let t63 = cos_phi * sin_delta * t33 + sin_phi * (t25 * t31 + t13 * t34);
        let t68 = t41 * t63 + t13 * self.constants[12] + t25 * t50;
        let t70 = self.constants[0].like(1.0) / (cos_phi * t68);
        let t71 = t56 * t70;
        let t77 = t25 * self.constants[9] - t13 * self.constants[8];
        let t79 = t55 + sin_phi * t77;
        let t81 = sin_phi * t25;
        let t85 = t68 - t13 * self.constants[9] - t25 * self.constants[8];
        let t88 = t70 * (t13 * t79 + t81 * t85);
        let t90 = speeds[0] * t71 + speeds[1] * t88;
        let t92 = self.constants[1] * (speeds[2] + t90);
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let t98 = sin_phi * t68;
        let t100 = sin_phi * t56;
        let t102 = t36 * t98 + t63 * t100;
        let t106 = self.constants[0].like(1.0) / (t36 * t68 + t56 * t63);
        let t108 = t71 * t102 * t106;
        let t117 = t29 * self.constants[2] + sin_phi * t44 + cos_phi * t52
            - cos_phi * t77;
        let t119 = t26 * t85 - t13 * t117;
        let t123 = t81 * t117 + t26 * t79;
        let t128 = t106 * (t36 * t119 + t63 * t123 + t88 * t102);
        let t131 = self.constants[1] * t63 * t106;
        let t137 = t63 * t98 - t36 * t100;
        let t141 = t63 * t68 - t36 * t56;
        let t144 = self.constants[0].like(1.0) / self.constants[2];
        let t161 = speeds[0] * (t108 * t141 - t71 * t137) * t144
            + speeds[1] * t144 * (t36 * t123 + t128 * t141 - t63 * t119 - t88 * t137);
        let t162 = t161 + speeds[2] * t144 * (self.constants[1] * t36 + t131 * t141);
        let t163 = -(t92 * cos_psi);
        let t164 = -(t92 * sin_psi);
        let t165 = -(speeds[0] * t108 + speeds[1] * t128 + speeds[2] * t131);
        [t163, t164, t165, speeds[0], t90, speeds[1], speeds[2], t162]
    }

    fn derivatives_unchecked(&self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2]) -> ([T; 8], [T; 3]) {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t13 = self.constants[4] * sin_pitch + self.constants[5] * cos_pitch;
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t17 = t13 * cos_phi;
        let t21 = sin_phi * sin_delta - cos_delta * t17;
        let t25 = self.constants[4] * cos_pitch - sin_pitch * self.constants[5];
        let t26 = cos_phi * t25;
        let t29 = (t21 * t21 + t26 * t26).sqrt();
        let t30 = self.constants[0].like(1.0) / t29;
        let t31 = t21 * t30;
        let t33 = t26 * t30;
        let t34 = cos_delta * t33;
        let t36 = t25 * t34 - t13 * t31;
        let t40 = sin_phi * cos_delta + t17 * sin_delta;
        let t41 = self.constants[2] * t40;
        let t44 = sin_delta * self.constants[10];
        let t50 = self.constants[8] + cos_delta * self.constants[10];
        let t52 = t25 * self.constants[12] - t13 * t50;
        let t55 = cos_phi * t44 - t36 * t41 - sin_phi * t52;
        let t56 = self.constants[1] * sin_phi + t55;
        let t63 = cos_phi * sin_delta * t33 + sin_phi * (t25 * t31 + t13 * t34);
        let t68 = t41 * t63 + t13 * self.constants[12] + t25 * t50;
        let t70 = self.constants[0].like(1.0) / (cos_phi * t68);
        let t71 = t56 * t70;
        let t77 = t25 * self.constants[9] - t13 * self.constants[8];
        let t79 = t55 + sin_phi * t77;
        let t81 = sin_phi * t25;
        let t85 = t68 - t13 * self.constants[9] - t25 * self.constants[8];
        let t88 = t70 * (t13 * t79 + t81 * t85);
        let t90 = speeds[0] * t71 + speeds[1] * t88;
        let t91 = speeds[2] + t90;
        let t92 = self.constants[1] * t91;
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let t98 = sin_phi * t68;
        let t100 = sin_phi * t56;
        let t102 = t36 * t98 + t63 * t100;
        let t106 = self.constants[0].like(1.0) / (t36 * t68 + t56 * t63);
        let t108 = t71 * t102 * t106;
        let t117 = t29 * self.constants[2] + sin_phi * t44 + cos_phi * t52
            - cos_phi * t77;
        let t119 = t26 * t85 - t13 * t117;
        let t123 = t81 * t117 + t26 * t79;
        let t128 = t106 * (t36 * t119 + t63 * t123 + t88 * t102);
        let t131 = self.constants[1] * t63 * t106;
        let t134 = speeds[0] * t108 + speeds[1] * t128 + speeds[2] * t131;
        let t137 = t63 * t98 - t36 * t100;
        let t141 = t63 * t68 - t36 * t56;
        let t144 = self.constants[0].like(1.0) / self.constants[2];
        let t145 = (t108 * t141 - t71 * t137) * t144;
        let t154 = t144 * (t36 * t123 + t128 * t141 - t63 * t119 - t88 * t137);
        let t159 = t144 * (self.constants[1] * t36 + t131 * t141);
        let t162 = speeds[0] * t145 + speeds[1] * t154 + speeds[2] * t159;
        let t165 = cos_phi * t134;
        let t167 = sin_phi * t134;
        let t168 = self.constants[1] * t167;
        let t170 = t165 * t168 - t92 * t165;
        let t173 = t170 + sin_phi * self.constants[25];
        let t178 = speeds[0] * t13 - t25 * t165;
        let t179 = t90 * t178;
        let t180 = speeds[0] * t167;
        let t181 = t90 - t167;
        let t182 = self.constants[9] * t181;
        let t186 = speeds[0] * t25 + t13 * t165;
        let t187 = self.constants[8] * t181;
        let t189 = t178 * t182 + t186 * t187;
        let t191 = t90 * t186;
        let t192 = t25 * t180 + t191;
        let t195 = t179 + t13 * t180;
        let t199 = t189 + self.constants[8] * t192 + self.constants[9] * t195 - t170;
        let t204 = self.constants[8] * t178 - self.constants[9] * t186;
        let t206 = t181 * t187 + t178 * t204;
        let t207 = speeds[0] * t165;
        let t210 = self.constants[1] * speeds[0];
        let t211 = t165 * t210;
        let t212 = self.constants[1] * t207 + t211;
        let t217 = t168 * (t91 - t167) - speeds[0] * t210;
        let t221 = t25 * t212 + t13 * t217 - t206 - self.constants[9] * t207;
        let t223 = speeds[1] + t178;
        let t227 = cos_delta * t181 - sin_delta * t186;
        let t228 = self.constants[11] * t227;
        let t232 = cos_delta * t186 + sin_delta * t181;
        let t233 = self.constants[10] * t227;
        let t238 = speeds[1] * t227;
        let t240 = t238 - cos_delta * t195 - sin_delta * t207;
        let t242 = t31 * self.constants[2];
        let t246 = t33 * self.constants[2];
        let t254 = t30 * t40 * (t31 * t232 + t33 * t223);
        let t255 = t246 * t254;
        let t257 = t242 * t254;
        let t263 = cos_delta * t199 + t223 * t228 + t232 * t233
            + self.constants[10] * t192 + t242 * (t192 + t162 * t232) + t223 * t255;
        let t267 = t263 + t232 * t257 - sin_delta * t221 - self.constants[11] * t240
            - t246 * (t240 - t162 * t223);
        let t274 = self.constants[10] * t223 - self.constants[11] * t232;
        let t278 = speeds[1] * t232;
        let t280 = sin_delta * t195 - cos_delta * t207 - t278;
        let t283 = t162 + t227;
        let t288 = self.constants[2] * (t31 * t223 - t33 * t232);
        let t294 = cos_delta * t221 + sin_delta * t199 + self.constants[11] * t280
            + t246 * t280 - t227 * t233 - t223 * t274;
        let t296 = t294 - t257 * t283 - t223 * t288;
        let t300 = t186 * t204 - t181 * t182;
        let t314 = t300 + self.constants[8] * t207 + t13 * t212 + t232 * t274
            + t232 * t288 - t25 * t217;
        let t318 = t314 - t227 * t228 - self.constants[10] * t280 - t242 * t280
            - t255 * t283;
        let t320 = t31 * t296 + t33 * t318;
        let t325 = t70 * (t40 * t267 + t29 * t320);
        let t329 = t106 * (t29 * t267 + t102 * t325 - t40 * t320);
        let t331 = t180 - cos_phi * t329;
        let t333 = t179 + t13 * t331;
        let t337 = t191 + t25 * t331;
        let t344 = t181 * self.constants[16] + self.constants[6] * (speeds[2] + t181);
        let t349 = t186 * self.constants[17] + self.constants[15] * t178;
        let t356 = t189 + self.constants[8] * t337 + self.constants[9] * t333 - t173;
        let t360 = t325 - t207 - sin_phi * t329;
        let t363 = self.constants[1] * t360 - t211;
        let t366 = t217 + cos_phi * self.constants[25];
        let t368 = t13 * t366 - t25 * t363;
        let t370 = self.constants[9] * t360 + t368 - t206;
        let t372 = cos_delta * t356 - sin_delta * t370;
        let t378 = t238 + sin_delta * t360 - cos_delta * t333;
        let t386 = t227 * self.constants[23] + t283 * self.constants[7];
        let t391 = t232 * self.constants[21] + t223 * self.constants[22];
        let t396 = self.constants[19] * t372 + self.constants[22] * t378
            + t337 * self.constants[24] + t232 * t386 - t227 * t391;
        let t400 = cos_delta * t370 + sin_delta * t356;
        let t406 = cos_delta * t360 + sin_delta * t333 - t278;
        let t408 = t227 * self.constants[19];
        let t412 = t223 * self.constants[19] - t232 * self.constants[20];
        let t416 = self.constants[3] * t400 + self.constants[20] * t406 - t227 * t408
            - t223 * t412;
        let t421 = t227 * self.constants[20];
        let t427 = t372 * self.constants[3] + t337 * self.constants[19] + t223 * t421
            + t232 * t408 - t378 * self.constants[20];
        let t429 = sin_delta * t416 + cos_delta * t427;
        let t435 = self.constants[18] * t337 + t186 * t344 + t396
            + self.constants[8] * t429 - self.constants[13] * t173
            - self.constants[15] * t333;
        let t436 = t435 - t181 * t349;
        let t444 = self.constants[15] * t186 + t178 * self.constants[18];
        let t452 = t232 * self.constants[22] + t223 * self.constants[24];
        let t458 = t378 * self.constants[21] + t337 * self.constants[22] + t227 * t452
            - t372 * self.constants[20] - t223 * t386;
        let t464 = t25 * t366 + t13 * t363;
        let t466 = t300 - self.constants[8] * t360 - t464;
        let t477 = t406 + t144 * (t31 * t318 + t141 * t329 - t33 * t296 - t137 * t325);
        let t478 = self.constants[7] * t477;
        let t485 = t400 * self.constants[20] + self.constants[23] * t406 + t478
            + t223 * t391 - self.constants[19] * t466 - t232 * t452;
        let t492 = t173 * self.constants[14] + self.constants[15] * t337 + t181 * t444
            + cos_delta * t458 - t333 * self.constants[17] - t178 * t344;
        let t494 = t492 - sin_delta * t485 - self.constants[9] * t429;
        let t500 = t181 * self.constants[14];
        let t502 = self.constants[13] * t181;
        let t508 = t429 + self.constants[13] * t337 + t333 * self.constants[14]
            + t178 * t500 + t186 * t502 - t173 * self.constants[0];
        let t511 = t71 - sin_phi * t108;
        let t521 = cos_delta * t416 - sin_delta * t427;
        let t529 = self.constants[3] * t466 + t232 * t412 - self.constants[19] * t406
            - t227 * t421;
        let t536 = self.constants[13] * t178 - t186 * self.constants[14];
        let t543 = t13
            * (t529 + t186 * t536 - t464 * self.constants[0] - self.constants[13] * t360
                - t181 * t500);
        let t552 = t25
            * (t521 + t368 * self.constants[0] + t360 * self.constants[14] - t181 * t502
                - t178 * t536);
        let t555 = self.constants[6] * t360 - self.constants[1] * (t543 + t552);
        let t560 = t368 * self.constants[14] + self.constants[13] * t464
            + self.constants[16] * t360 + t178 * t349 + sin_delta * t458
            + cos_delta * t485;
        let t564 = t560 + self.constants[9] * t521 + t555 - t186 * t444
            - self.constants[8] * t529;
        let t566 = cos_phi * t108;
        let t569 = t25 * t436 - t13 * t494;
        let t576 = forces[0] + t566 * t569 - t13 * t436 - t25 * t494
            - self.constants[1] * t508 - t511 * t564;
        let t577 = t576 - t145 * t478;
        let t579 = sin_delta * self.constants[26];
        let t580 = sin_delta * t579;
        let t584 = self.constants[17] + self.constants[21] + self.constants[28] - t580;
        let t585 = cos_delta * self.constants[19];
        let t586 = self.constants[8] * t585;
        let t589 = t586 + t586 + self.constants[31];
        let t591 = self.constants[18] + self.constants[24] + t589;
        let t592 = t591 - t584;
        let t593 = t13 * t13;
        let t595 = t13 * t25;
        let t600 = cos_delta * self.constants[22] - self.constants[9] * t585;
        let t603 = self.constants[15] + t600 - self.constants[29] - self.constants[30];
        let t604 = t603 + t603;
        let t606 = t592 * t593 + t595 * t604;
        let t611 = self.constants[13] + t585 + self.constants[27];
        let t613 = t25 * self.constants[32] - t13 * t611;
        let t614 = self.constants[1] * t613;
        let t617 = self.constants[34] - t614 - t614;
        let t619 = sin_delta * self.constants[19];
        let t621 = sin_delta * self.constants[22] - self.constants[9] * t619;
        let t625 = cos_delta * t579 - self.constants[8] * t619;
        let t627 = t13 * t621 + t25 * t625;
        let t637 = t603 + t592 * t595
            + self.constants[1] * (t13 * self.constants[32] + t25 * t611) - t593 * t604;
        let t643 = self.constants[16] + self.constants[23] + t580 + self.constants[28]
            + t589 + t617;
        let t647 = self.constants[1] * t619;
        let t649 = t25 * t621 + t647 - t13 * t625;
        let t655 = t591 - t606;
        let t660 = self.constants[6] * t511;
        let t664 = t13 * sin_delta;
        let t668 = t145 + cos_delta * t511 - sin_delta * t25 - t566 * t664;
        let t669 = self.constants[7] * t668;
        let t675 = t584 + t606 + t617 + t511 * t627
            + t511 * (t627 + t511 * t643 - t566 * t649) + t511 * t660;
        let t678 = t675 + t668 * t669 - t566 * t637
            - t566 * (t637 + t511 * t649 - t566 * t655);
        let t679 = self.constants[0].like(1.0) / t678;
        let t681 = self.constants[24] + t586;
        let t686 = t88 - sin_phi * t128;
        let t688 = cos_phi * t128;
        let t690 = t25 * t647;
        let t691 = t621 + t690;
        let t695 = t691 + t643 * t686 - t649 * t688;
        let t699 = t25 * t681 - t13 * t600;
        let t703 = t699 + t649 * t686 - t655 * t688;
        let t709 = t154 + cos_delta * t686 - t664 * t688;
        let t715 = t13 * t681 + t25 * t600 + self.constants[1] * t585 + t627 * t686
            + t511 * t695 + t660 * t686;
        let t719 = t679 * (t715 + t669 * t709 - t637 * t688 - t566 * t703);
        let t724 = self.constants[6] * t686;
        let t726 = self.constants[7] * t709;
        let t728 = t678 * t719;
        let t734 = self.constants[24] + t686 * t695 + t686 * t691 + t686 * t724
            + t709 * t726 - t688 * t703;
        let t736 = t734 - t688 * t699 - t719 * t728;
        let t737 = self.constants[0].like(1.0) / t736;
        let t747 = forces[1] + t569 * t688 - t396 - t564 * t686 - t154 * t478
            - t577 * t719;
        let t751 = self.constants[1] * (t613 - self.constants[33]);
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
        let t822 = t752 * t757 + t751 * t752 + self.constants[35]
            + self.constants[6] * t767 * t767 + self.constants[7] * t772 * t772
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

    fn accelerations_unchecked(&self, positions: &[T; 8], speeds: &[T; 3], forces: &[T; 2]) -> [T; 8] {
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t13 = self.constants[4] * sin_pitch + cos_pitch * self.constants[5];
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t16 = cos_phi * t13;
        let t21 = sin_phi * sin_delta - cos_delta * t16;
        let t25 = self.constants[4] * cos_pitch - self.constants[5] * sin_pitch;
        let t26 = cos_phi * t25;
        let t29 = (t21 * t21 + t26 * t26).sqrt();
        let t30 = self.constants[0].like(1.0) / t29;
        let t31 = t21 * t30;
        let t33 = t26 * t30;
        let t34 = cos_delta * t33;
        let t36 = t25 * t34 - t13 * t31;
        let t43 = cos_phi * sin_delta * t33 + sin_phi * (t25 * t31 + t13 * t34);
        let t47 = sin_phi * cos_delta + sin_delta * t16;
        let t48 = self.constants[2] * t47;
        let t55 = self.constants[8] + cos_delta * self.constants[10];
        let t58 = t43 * t48 + t13 * self.constants[12] + t25 * t55;
        let t62 = sin_delta * self.constants[10];
        let t66 = t25 * self.constants[12] - t13 * t55;
        let t69 = cos_phi * t62 - t36 * t48 - sin_phi * t66;
        let t70 = self.constants[1] * sin_phi + t69;
        let t73 = self.constants[0].like(1.0) / (t36 * t58 + t43 * t70);
        let t74 = sin_phi * t58;
        let t76 = sin_phi * t70;
        let t78 = t36 * t74 + t43 * t76;
        let t80 = self.constants[0].like(1.0) / (cos_phi * t58);
        let t81 = t70 * t80;
        let t83 = t73 * t78 * t81;
        let t90 = t58 - t13 * self.constants[9] - t25 * self.constants[8];
        let t97 = t25 * self.constants[9] - t13 * self.constants[8];
        let t101 = t29 * self.constants[2] + sin_phi * t62 + cos_phi * t66
            - cos_phi * t97;
        let t103 = t26 * t90 - t13 * t101;
        let t105 = sin_phi * t25;
        let t108 = t69 + sin_phi * t97;
        let t110 = t101 * t105 + t26 * t108;
        let t115 = t80 * (t13 * t108 + t90 * t105);
        let t119 = t73 * (t36 * t103 + t43 * t110 + t78 * t115);
        let t122 = self.constants[1] * t43 * t73;
        let t126 = speeds[0] * t83 + speeds[1] * t119 + t122 * speeds[2];
        let t127 = cos_phi * t126;
        let t128 = speeds[0] * t127;
        let t131 = t13 * speeds[0] - t25 * t127;
        let t134 = speeds[0] * t81 + speeds[1] * t115;
        let t135 = sin_phi * t126;
        let t136 = t134 - t135;
        let t137 = self.constants[9] * t136;
        let t141 = t25 * speeds[0] + t13 * t127;
        let t142 = self.constants[8] * t136;
        let t144 = t131 * t137 + t141 * t142;
        let t145 = speeds[0] * t135;
        let t147 = t134 * t141;
        let t148 = t25 * t145 + t147;
        let t151 = t131 * t134;
        let t152 = t13 * t145 + t151;
        let t154 = speeds[2] + t134;
        let t155 = self.constants[1] * t154;
        let t157 = self.constants[1] * t135;
        let t159 = t127 * t157 - t127 * t155;
        let t162 = t144 + self.constants[8] * t148 + self.constants[9] * t152 - t159;
        let t167 = self.constants[8] * t131 - self.constants[9] * t141;
        let t169 = t136 * t142 + t131 * t167;
        let t171 = self.constants[1] * speeds[0];
        let t172 = t127 * t171;
        let t174 = t172 + self.constants[1] * t128;
        let t179 = t157 * (t154 - t135) - speeds[0] * t171;
        let t183 = t25 * t174 + t13 * t179 - t169 - self.constants[9] * t128;
        let t185 = speeds[1] + t131;
        let t189 = cos_delta * t136 - sin_delta * t141;
        let t190 = self.constants[11] * t189;
        let t194 = cos_delta * t141 + sin_delta * t136;
        let t195 = self.constants[10] * t189;
        let t200 = speeds[1] * t189;
        let t202 = t200 - cos_delta * t152 - sin_delta * t128;
        let t204 = t31 * self.constants[2];
        let t207 = t43 * t74 - t36 * t76;
        let t211 = t43 * t58 - t36 * t70;
        let t214 = self.constants[0].like(1.0) / self.constants[2];
        let t215 = (t83 * t211 - t81 * t207) * t214;
        let t224 = t214 * (t36 * t110 + t119 * t211 - t43 * t103 - t115 * t207);
        let t229 = t214 * (self.constants[1] * t36 + t122 * t211);
        let t232 = speeds[0] * t215 + speeds[1] * t224 + speeds[2] * t229;
        let t236 = t33 * self.constants[2];
        let t244 = t30 * t47 * (t31 * t194 + t33 * t185);
        let t245 = t236 * t244;
        let t247 = t204 * t244;
        let t253 = cos_delta * t162 + t185 * t190 + t194 * t195
            + self.constants[10] * t148 + t204 * (t148 + t194 * t232) + t185 * t245;
        let t257 = t253 + t194 * t247 - sin_delta * t183 - self.constants[11] * t202
            - t236 * (t202 - t185 * t232);
        let t264 = self.constants[10] * t185 - self.constants[11] * t194;
        let t268 = speeds[1] * t194;
        let t270 = sin_delta * t152 - cos_delta * t128 - t268;
        let t273 = t189 + t232;
        let t278 = self.constants[2] * (t31 * t185 - t33 * t194);
        let t284 = cos_delta * t183 + sin_delta * t162 + self.constants[11] * t270
            + t236 * t270 - t189 * t195 - t185 * t264;
        let t286 = t284 - t247 * t273 - t185 * t278;
        let t290 = t141 * t167 - t136 * t137;
        let t304 = t290 + self.constants[8] * t128 + t13 * t174 + t194 * t264
            + t194 * t278 - t25 * t179;
        let t308 = t304 - t189 * t190 - self.constants[10] * t270 - t204 * t270
            - t245 * t273;
        let t310 = t31 * t286 + t33 * t308;
        let t313 = t80 * (t47 * t257 + t29 * t310);
        let t319 = t73 * (t29 * t257 + t78 * t313 - t47 * t310);
        let t322 = t313 - t128 - sin_phi * t319;
        let t327 = t179 + cos_phi * self.constants[25];
        let t330 = self.constants[1] * t322 - t172;
        let t332 = t25 * t327 + t13 * t330;
        let t335 = t290 - t332 - self.constants[8] * t322;
        let t341 = t145 - cos_phi * t319;
        let t343 = t151 + t13 * t341;
        let t346 = cos_delta * t322 + sin_delta * t343 - t268;
        let t351 = t185 * self.constants[19] - t194 * self.constants[20];
        let t353 = t189 * self.constants[20];
        let t357 = t335 * self.constants[3] + t194 * t351 - self.constants[19] * t346
            - t189 * t353;
        let t365 = t131 * self.constants[13] - self.constants[14] * t141;
        let t367 = self.constants[14] * t136;
        let t373 = t13
            * (t357 + t141 * t365 - t332 * self.constants[0] - t322 * self.constants[13]
                - t136 * t367);
        let t376 = t13 * t327 - t25 * t330;
        let t379 = t376 + self.constants[9] * t322 - t169;
        let t382 = t147 + t25 * t341;
        let t386 = t159 + sin_phi * self.constants[25];
        let t389 = t144 + self.constants[8] * t382 + self.constants[9] * t343 - t386;
        let t391 = cos_delta * t379 + sin_delta * t389;
        let t394 = t189 * self.constants[19];
        let t399 = t391 * self.constants[3] + self.constants[20] * t346 - t189 * t394
            - t185 * t351;
        let t403 = cos_delta * t389 - sin_delta * t379;
        let t409 = t200 + sin_delta * t322 - cos_delta * t343;
        let t416 = t403 * self.constants[3] + t382 * self.constants[19] + t185 * t353
            + t194 * t394 - self.constants[20] * t409;
        let t418 = cos_delta * t399 - sin_delta * t416;
        let t421 = t136 * self.constants[13];
        let t428 = t25
            * (t418 + t376 * self.constants[0] + self.constants[14] * t322 - t136 * t421
                - t131 * t365);
        let t431 = t322 * self.constants[6] - self.constants[1] * (t373 + t428);
        let t432 = sin_phi * t122;
        let t441 = t141 * self.constants[17] + t131 * self.constants[15];
        let t446 = t141 * self.constants[15] + t131 * self.constants[18];
        let t456 = t194 * self.constants[22] + t185 * self.constants[24];
        let t462 = t189 * self.constants[23] + t273 * self.constants[7];
        let t467 = self.constants[21] * t409 + t382 * self.constants[22] + t189 * t456
            - self.constants[20] * t403 - t185 * t462;
        let t479 = t214 * (t31 * t308 + t211 * t319 - t33 * t286 - t207 * t313);
        let t481 = self.constants[7] * (t346 + t479);
        let t484 = t194 * self.constants[21] + t185 * self.constants[22];
        let t491 = self.constants[20] * t391 + self.constants[23] * t346 + t481
            + t185 * t484 - self.constants[19] * t335 - t194 * t456;
        let t499 = self.constants[14] * t376 + self.constants[13] * t332
            + t322 * self.constants[16] + t131 * t441 + sin_delta * t467
            + cos_delta * t491;
        let t503 = t499 + self.constants[9] * t418 + t431 - t141 * t446
            - self.constants[8] * t357;
        let t505 = cos_phi * t122;
        let t512 = t136 * self.constants[16] + self.constants[6] * (speeds[2] + t136);
        let t523 = t403 * self.constants[19] + t409 * self.constants[22]
            + t382 * self.constants[24] + t194 * t462 - t189 * t484;
        let t526 = sin_delta * t399 + cos_delta * t416;
        let t532 = self.constants[18] * t382 + t141 * t512 + t523
            + self.constants[8] * t526 - self.constants[13] * t386
            - self.constants[15] * t343;
        let t533 = t532 - t136 * t441;
        let t547 = self.constants[14] * t386 + self.constants[15] * t382 + t136 * t446
            + cos_delta * t467 - self.constants[17] * t343 - t131 * t512;
        let t549 = t547 - sin_delta * t491 - self.constants[9] * t526;
        let t551 = t25 * t533 - t13 * t549;
        let t566 = t526 + self.constants[13] * t382 + self.constants[14] * t343
            + t131 * t367 + t141 * t421 - t386 * self.constants[0];
        let t569 = t81 - sin_phi * t83;
        let t571 = cos_phi * t83;
        let t578 = forces[0] + t551 * t571 - t13 * t533 - t25 * t549
            - self.constants[1] * t566 - t503 * t569;
        let t579 = t578 - t215 * t481;
        let t581 = sin_delta * self.constants[19];
        let t583 = sin_delta * self.constants[22] - self.constants[9] * t581;
        let t586 = sin_delta * self.constants[26];
        let t589 = cos_delta * t586 - self.constants[8] * t581;
        let t591 = t13 * t583 + t25 * t589;
        let t596 = cos_delta * self.constants[19];
        let t598 = cos_delta * self.constants[22] - self.constants[9] * t596;
        let t601 = self.constants[15] + t598 - self.constants[29] - self.constants[30];
        let t602 = sin_delta * t586;
        let t606 = self.constants[17] + self.constants[21] + self.constants[28] - t602;
        let t607 = self.constants[8] * t596;
        let t610 = t607 + t607 + self.constants[31];
        let t612 = self.constants[18] + self.constants[24] + t610;
        let t613 = t612 - t606;
        let t614 = t25 * t13;
        let t616 = t13 * t13;
        let t617 = t601 + t601;
        let t623 = self.constants[13] + t596 + self.constants[27];
        let t629 = t601 + t613 * t614
            + self.constants[1] * (t13 * self.constants[32] + t25 * t623) - t616 * t617;
        let t633 = t25 * self.constants[32] - t13 * t623;
        let t636 = self.constants[1] * (t633 - self.constants[33]);
        let t637 = self.constants[1] * t633;
        let t640 = self.constants[34] - t637 - t637;
        let t645 = self.constants[16] + self.constants[23] + t602 + self.constants[28]
            + t610 + t640;
        let t649 = self.constants[1] * t581;
        let t651 = t25 * t583 + t649 - t13 * t589;
        let t654 = t636 + t432 * t645 + t505 * t651;
        let t659 = t613 * t616 + t614 * t617;
        let t660 = t612 - t659;
        let t663 = t649 - t432 * t651 - t505 * t660;
        let t666 = self.constants[0].like(1.0) - t432;
        let t667 = self.constants[6] * t569;
        let t670 = sin_delta * t13;
        let t673 = t229 - cos_delta * t432 - t505 * t670;
        let t679 = t215 + cos_delta * t569 - sin_delta * t25 - t571 * t670;
        let t680 = self.constants[7] * t679;
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
        let t720 = self.constants[24] + t607;
        let t723 = t25 * t720 - t13 * t598;
        let t725 = self.constants[6] * t714;
        let t730 = t224 + cos_delta * t714 - t670 * t716;
        let t731 = self.constants[7] * t730;
        let t741 = t718 + t645 * t714 - t651 * t716;
        let t746 = t723 + t651 * t714 - t660 * t716;
        let t754 = t13 * t720 + t25 * t598 + self.constants[1] * t596 + t591 * t714
            + t569 * t741 + t667 * t714;
        let t758 = t709 * (t754 + t680 * t730 - t629 * t716 - t571 * t746);
        let t759 = t708 * t758;
        let t765 = t712 + t666 * t725 + t673 * t731 - t654 * t714 - t663 * t716
            - t432 * t718;
        let t779 = self.constants[24] + t714 * t741 + t714 * t718 + t714 * t725
            + t730 * t731 - t716 * t746;
        let t781 = t779 - t716 * t723 - t758 * t759;
        let t782 = self.constants[0].like(1.0) / t781;
        let t783 = (t765 - t505 * t723 - t710 * t759) * t782;
        let t793 = forces[1] + t551 * t716 - t523 - t503 * t714 - t224 * t481
            - t579 * t758;
        let t799 = t432 * t503 + t505 * t551 - t431 - t229 * t481 - t579 * t710
            - t783 * t793;
        let t817 = t432 * t654 + t432 * t636 + self.constants[35]
            + self.constants[6] * t666 * t666 + self.constants[7] * t673 * t673
            - t505 * t663;
        let t821 = t799 / (t817 - t505 * t649 - t708 * t710 * t710 - t781 * t783 * t783);
        let t825 = t782 * t793 - t783 * t821;
        let t829 = t579 * t709 - t758 * t825 - t710 * t821;
        let t833 = t313 + t81 * t829 + t115 * t825;
        let t835 = self.constants[1] * (t821 + t833);
        let t838 = t126 * t155;
        let t843 = cos_psi * t838 - t835 * sin_psi;
        let t855 = t479 + t215 * t829 + t224 * t825 + t229 * t821;
        let t856 = -(cos_psi * t835 + sin_psi * t838);
        let t857 = -(t319 + t83 * t829 + t119 * t825 + t122 * t821);
        [t856, t843, t857, t829, t833, t825, t821, t855]
    }

    fn energy_unchecked(&self, positions: &[T; 8], speeds: &[T; 3]) -> [T; 2] {
        let (sin_delta, cos_delta) = positions[5].sin_cos();
        let t6 = sin_delta * self.constants[26];
        let t7 = sin_delta * t6;
        let t11 = self.constants[17] + self.constants[21] + self.constants[28] - t7;
        let t17 = cos_delta * self.constants[19];
        let t18 = self.constants[8] * t17;
        let t21 = t18 + t18 + self.constants[31];
        let t23 = self.constants[18] + self.constants[24] + t21;
        let t24 = t23 - t11;
        let (sin_pitch, cos_pitch) = positions[4].sin_cos();
        let t32 = self.constants[4] * sin_pitch + self.constants[5] * cos_pitch;
        let t33 = t32 * t32;
        let t37 = self.constants[4] * cos_pitch - sin_pitch * self.constants[5];
        let t38 = t32 * t37;
        let t46 = cos_delta * self.constants[22] - t17 * self.constants[9];
        let t49 = self.constants[15] + t46 - self.constants[29] - self.constants[30];
        let t50 = t49 + t49;
        let t52 = t24 * t33 + t38 * t50;
        let t59 = t17 + self.constants[13] + self.constants[27];
        let t61 = t37 * self.constants[32] - t32 * t59;
        let t62 = self.constants[1] * t61;
        let t65 = self.constants[34] - t62 - t62;
        let t67 = sin_delta * self.constants[19];
        let t69 = sin_delta * self.constants[22] - self.constants[9] * t67;
        let t73 = t6 * cos_delta - self.constants[8] * t67;
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
        let t100 = self.constants[2] * (cos_delta * sin_phi + sin_delta * t80);
        let t103 = sin_delta * self.constants[10];
        let t108 = self.constants[8] + cos_delta * self.constants[10];
        let t110 = t37 * self.constants[12] - t32 * t108;
        let t113 = cos_phi * t103 - t95 * t100 - sin_phi * t110;
        let t114 = self.constants[1] * sin_phi + t113;
        let t121 = sin_delta * cos_phi * t92 + sin_phi * (t37 * t90 + t32 * t93);
        let t126 = t100 * t121 + t32 * self.constants[12] + t37 * t108;
        let t128 = self.constants[0].like(1.0) / (cos_phi * t126);
        let t129 = t114 * t128;
        let t130 = sin_phi * t126;
        let t132 = sin_phi * t114;
        let t134 = t95 * t130 + t121 * t132;
        let t138 = self.constants[0].like(1.0) / (t95 * t126 + t114 * t121);
        let t140 = t129 * t134 * t138;
        let t142 = t129 - sin_phi * t140;
        let t152 = t49 + t24 * t38
            + self.constants[1] * (t32 * self.constants[32] + t37 * t59) - t33 * t50;
        let t153 = cos_phi * t140;
        let t161 = t7 + self.constants[28] + t21 + t65 + self.constants[16]
            + self.constants[23];
        let t165 = self.constants[1] * t67;
        let t167 = t37 * t69 + t165 - t32 * t73;
        let t173 = t23 - t52;
        let t179 = t142 * self.constants[6];
        let t183 = t121 * t130 - t95 * t132;
        let t187 = t121 * t126 - t95 * t114;
        let t190 = self.constants[0].like(1.0) / self.constants[2];
        let t194 = sin_delta * t32;
        let t198 = (t140 * t187 - t129 * t183) * t190 + cos_delta * t142
            - sin_delta * t37 - t153 * t194;
        let t200 = t198 * self.constants[7];
        let t206 = t11 + t52 + t65 + t75 * t142
            + t142 * (t75 + t142 * t161 - t153 * t167) + t142 * t179;
        let t210 = speeds[0]
            * (t206 + t198 * t200 - t152 * t153
                - t153 * (t152 + t142 * t167 - t153 * t173));
        let t212 = self.constants[24] + t18;
        let t218 = t37 * self.constants[9] - self.constants[8] * t32;
        let t220 = t113 + sin_phi * t218;
        let t222 = t37 * sin_phi;
        let t226 = t126 - t32 * self.constants[9] - self.constants[8] * t37;
        let t229 = t128 * (t32 * t220 + t222 * t226);
        let t237 = t88 * self.constants[2] + sin_phi * t103 + cos_phi * t110
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
        let t287 = t32 * t212 + t37 * t46 + t17 * self.constants[1] + t75 * t250
            + t142 * t259 + t179 * t250;
        let t290 = t287 + t200 * t281 - t152 * t252 - t153 * t267;
        let t294 = self.constants[1] * t121 * t138;
        let t295 = sin_phi * t294;
        let t297 = cos_phi * t294;
        let t300 = t61 - self.constants[33];
        let t301 = self.constants[1] * t300;
        let t305 = t301 + t161 * t295 + t167 * t297;
        let t310 = t165 - t167 * t295 - t173 * t297;
        let t313 = self.constants[0].like(1.0) - t295;
        let t322 = t190 * (self.constants[1] * t95 + t187 * t294) - cos_delta * t295
            - t194 * t297;
        let t328 = t179 * t313 + t200 * t322 - t75 * t295 - t152 * t297 - t142 * t305
            - t153 * t310;
        let t338 = self.constants[6] * t250;
        let t340 = self.constants[7] * t281;
        let t346 = self.constants[24] + t250 * t259 + t250 * t255 + t250 * t338
            + t281 * t340 - t252 * t267;
        let t359 = t254 + t313 * t338 + t322 * t340 - t250 * t305 - t252 * t310
            - t255 * t295;
        let t360 = t359 - t263 * t297;
        let t364 = speeds[1]
            * (speeds[0] * t290 + speeds[1] * (t346 - t252 * t263) + speeds[2] * t360);
        let t380 = t295 * t305 + t295 * t301 + self.constants[35]
            + self.constants[6] * t313 * t313 + self.constants[7] * t322 * t322
            - t297 * t310;
        let t387 = speeds[0] * (t210 + speeds[1] * t290 + speeds[2] * t328) + t364
            + speeds[2]
                * (speeds[0] * t328 + speeds[1] * t360
                    + speeds[2] * (t380 - t165 * t297));
        let t389 = t387 * self.constants[0].like(0.5);
        let t395 = -(self.constants[25] * (t67 * sin_phi + cos_phi * t300));
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
        t9 = self.constants[4] * sin_pitch + self.constants[5] * cos_pitch;
        t13 = self.constants[4] * cos_pitch - sin_pitch * self.constants[5];
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
        t48 = self.constants[2] * t47;
        t55 = self.constants[8] + cos_delta * self.constants[10];
        t58 = t43 * t48 + t9 * self.constants[12] + t13 * t55;
        t59 = sin_phi * t58;
        t64 = sin_delta * self.constants[10];
        t68 = t13 * self.constants[12] - t9 * t55;
        t71 = cos_phi * t64 - t36 * t48 - sin_phi * t68;
        t72 = sin_phi * self.constants[1] + t71;
        t73 = sin_phi * t72;
        t75 = t36 * t59 + t43 * t73;
        t77 = self.constants[0].like(1.0) / (cos_phi * t58);
        t78 = t72 * t77;
        t82 = self.constants[0].like(1.0) / (t36 * t58 + t43 * t72);
        t84 = t75 * t78 * t82;
        t91 = t58 - t9 * self.constants[9] - t13 * self.constants[8];
        t98 = t13 * self.constants[9] - t9 * self.constants[8];
        t102 = t29 * self.constants[2] + sin_phi * t64 + cos_phi * t68 - cos_phi * t98;
        t104 = t26 * t91 - t9 * t102;
        t106 = t13 * sin_phi;
        t109 = t71 + sin_phi * t98;
        t111 = t102 * t106 + t26 * t109;
        t116 = t77 * (t9 * t109 + t91 * t106);
        t120 = t82 * (t36 * t104 + t43 * t111 + t75 * t116);
        t124 = t43 * self.constants[1] * t82;
        t127 = speeds[0] * t84 + speeds[1] * t120 + speeds[2] * t124;
        t128 = cos_phi * t127;
        t130 = speeds[0] * t13 + t9 * t128;
        t133 = t9 * speeds[0] - t13 * t128;
        t138 = t133 * self.constants[13] - t130 * self.constants[14];
        t142 = speeds[0] * t78 + speeds[1] * t116;
        t143 = sin_phi * t127;
        t144 = t142 - t143;
        t145 = self.constants[14] * t144;
        t147 = t130 * t138 - t144 * t145;
        t149 = speeds[0] * self.constants[1];
        t151 = speeds[2] + t142;
        t153 = self.constants[1] * t143;
        t155 = (t151 - t143) * t153 - speeds[0] * t149;
        t158 = t155 + cos_phi * self.constants[25];
        t159 = t13 * t158;
        t160 = t128 * t149;
        t161 = self.constants[9] * t144;
        t163 = self.constants[8] * t144;
        t165 = t133 * t161 + t130 * t163;
        t166 = speeds[0] * t143;
        t168 = t130 * t142;
        t169 = t13 * t166 + t168;
        t172 = t133 * t142;
        t173 = t9 * t166 + t172;
        t175 = t128 * t151;
        t177 = t128 * t153;
        t178 = t177 - self.constants[1] * t175;
        t181 = t165 + self.constants[8] * t169 + self.constants[9] * t173 - t178;
        t186 = self.constants[8] * t133 - self.constants[9] * t130;
        t188 = t144 * t163 + t133 * t186;
        t189 = speeds[0] * t128;
        t192 = t160 + self.constants[1] * t189;
        t197 = t13 * t192 + t9 * t155 - t188 - self.constants[9] * t189;
        t199 = speeds[1] + t133;
        t203 = cos_delta * t144 - sin_delta * t130;
        t204 = self.constants[11] * t203;
        t208 = cos_delta * t130 + sin_delta * t144;
        t209 = self.constants[10] * t203;
        t214 = speeds[1] * t203;
        t216 = t214 - cos_delta * t173 - sin_delta * t189;
        t218 = t31 * self.constants[2];
        t221 = t43 * t59 - t36 * t73;
        t225 = t43 * t58 - t36 * t72;
        t228 = self.constants[0].like(1.0) / self.constants[2];
        t229 = (t84 * t225 - t78 * t221) * t228;
        t238 = t228 * (t36 * t111 + t120 * t225 - t43 * t104 - t116 * t221);
        t243 = t228 * (t36 * self.constants[1] + t124 * t225);
        t246 = speeds[0] * t229 + speeds[1] * t238 + speeds[2] * t243;
        t250 = t33 * self.constants[2];
        t258 = t30 * t47 * (t31 * t208 + t33 * t199);
        t259 = t250 * t258;
        t261 = t218 * t258;
        t267 = cos_delta * t181 + t199 * t204 + t208 * t209 + self.constants[10] * t169
            + t218 * (t169 + t208 * t246) + t199 * t259;
        t271 = t267 + t208 * t261 - sin_delta * t197 - self.constants[11] * t216
            - t250 * (t216 - t199 * t246);
        t278 = self.constants[10] * t199 - self.constants[11] * t208;
        t282 = speeds[1] * t208;
        t284 = sin_delta * t173 - cos_delta * t189 - t282;
        t287 = t203 + t246;
        t292 = self.constants[2] * (t31 * t199 - t33 * t208);
        t298 = cos_delta * t197 + sin_delta * t181 + self.constants[11] * t284
            + t250 * t284 - t203 * t209 - t199 * t278;
        t300 = t298 - t261 * t287 - t199 * t292;
        t304 = t130 * t186 - t144 * t161;
        t318 = t304 + self.constants[8] * t189 + t9 * t192 + t208 * t278 + t208 * t292
            - t13 * t155;
        t322 = t318 - t203 * t204 - self.constants[10] * t284 - t218 * t284
            - t259 * t287;
        t324 = t31 * t300 + t33 * t322;
        t329 = t77 * (t47 * t271 + t29 * t324);
        t333 = t82 * (t29 * t271 + t75 * t329 - t47 * t324);
        t335 = t189 - t329;
        t336 = sin_phi * t333 + t335;
        t340 = self.constants[1] * t336 + t160;
        t342 = t159 - t9 * t340;
        t345 = t304 - t342 + self.constants[8] * t336;
        t351 = t166 - cos_phi * t333;
        t353 = t172 + t9 * t351;
        t356 = sin_delta * t353 - cos_delta * t336 - t282;
        t361 = t199 * self.constants[19] - t208 * self.constants[20];
        t363 = t203 * self.constants[20];
        t365 = t208 * t361 - t203 * t363;
        t367 = t345 * self.constants[3] + t365 - self.constants[19] * t356;
        t375 = t9 * t158;
        t376 = t375 + t13 * t340;
        t379 = t376 - self.constants[9] * t336 - t188;
        t382 = t168 + t13 * t351;
        t385 = sin_phi * self.constants[25];
        t386 = t178 + t385;
        t389 = t165 + self.constants[8] * t382 + self.constants[9] * t353 - t386;
        t391 = cos_delta * t379 + sin_delta * t389;
        t394 = t203 * self.constants[19];
        t397 = t203 * t394 + t199 * t361;
        t399 = t391 * self.constants[3] + self.constants[20] * t356 - t397;
        t403 = cos_delta * t389 - sin_delta * t379;
        t409 = t214 - sin_delta * t336 - cos_delta * t353;
        t413 = t199 * t363 + t208 * t394;
        t416 = t403 * self.constants[3] + t382 * self.constants[19] + t413
            - self.constants[20] * t409;
        t418 = cos_delta * t399 - sin_delta * t416;
        t421 = self.constants[13] * t144;
        t424 = t144 * t421 + t133 * t138;
        t429 = t9 * (t147 + t367 - self.constants[0] * t342 + self.constants[13] * t336)
            + t13 * (t418 + self.constants[0] * t376 - self.constants[14] * t336 - t424);
        t431 = t336 * self.constants[6] + self.constants[1] * t429;
        t432 = sin_phi * t124;
        t441 = t130 * self.constants[17] + t133 * self.constants[15];
        t446 = t130 * self.constants[15] + t133 * self.constants[18];
        t448 = t133 * t441 - t130 * t446;
        t457 = t208 * self.constants[22] + t199 * self.constants[24];
        t463 = t203 * self.constants[23] + t287 * self.constants[7];
        t465 = t203 * t457 - t199 * t463;
        t468 = self.constants[21] * t409 + t382 * self.constants[22] + t465
            - self.constants[20] * t403;
        t480 = t228 * (t31 * t322 + t225 * t333 - t33 * t300 - t221 * t329);
        t482 = self.constants[7] * (t356 + t480);
        t485 = t208 * self.constants[21] + t199 * self.constants[22];
        t488 = t199 * t485 - t208 * t457;
        t492 = self.constants[20] * t391 + self.constants[23] * t356 + t482 + t488
            - self.constants[19] * t345;
        t500 = self.constants[14] * t376 + self.constants[13] * t342
            - t336 * self.constants[16] + t448 + sin_delta * t468 + cos_delta * t492;
        t503 = t500 + self.constants[9] * t418 - t431 - self.constants[8] * t367;
        t505 = cos_phi * t124;
        t512 = t144 * self.constants[16] + self.constants[6] * (speeds[2] + t144);
        t515 = t130 * t512 - t144 * t441;
        t521 = t208 * t463 - t203 * t485;
        t524 = t403 * self.constants[19] + t409 * self.constants[22]
            + t382 * self.constants[24] + t521;
        t527 = sin_delta * t399 + cos_delta * t416;
        t533 = self.constants[18] * t382 + t515 + t524 + self.constants[8] * t527
            - self.constants[13] * t386 - self.constants[15] * t353;
        t540 = t144 * t446 - t133 * t512;
        t548 = self.constants[14] * t386 + self.constants[15] * t382 + t540
            + cos_delta * t468 - self.constants[17] * t353 - sin_delta * t492;
        t549 = t548 - self.constants[9] * t527;
        t551 = t13 * t533 - t9 * t549;
        t562 = t133 * t145 + t130 * t421;
        t567 = self.constants[1]
            * (t527 + self.constants[13] * t382 + self.constants[14] * t353 + t562
                - self.constants[0] * t386);
        t569 = t78 - sin_phi * t84;
        t571 = cos_phi * t84;
        t578 = forces[0] + t551 * t571 - t9 * t533 - t13 * t549 - t567 - t503 * t569;
        t579 = t578 - t229 * t482;
        t581 = sin_delta * self.constants[19];
        t583 = sin_delta * self.constants[22] - self.constants[9] * t581;
        t586 = sin_delta * self.constants[26];
        t589 = cos_delta * t586 - self.constants[8] * t581;
        t591 = t9 * t583 + t13 * t589;
        t596 = cos_delta * self.constants[19];
        t598 = cos_delta * self.constants[22] - self.constants[9] * t596;
        t601 = self.constants[15] + t598 - self.constants[29] - self.constants[30];
        t602 = sin_delta * t586;
        t606 = self.constants[17] + self.constants[21] + self.constants[28] - t602;
        t607 = self.constants[8] * t596;
        t610 = t607 + t607 + self.constants[31];
        t612 = self.constants[18] + self.constants[24] + t610;
        t613 = t612 - t606;
        t614 = t9 * t13;
        t616 = t9 * t9;
        t617 = t601 + t601;
        t623 = self.constants[13] + t596 + self.constants[27];
        t629 = t601 + t613 * t614
            + self.constants[1] * (t9 * self.constants[32] + t13 * t623) - t616 * t617;
        t633 = t13 * self.constants[32] - t9 * t623;
        t636 = self.constants[1] * (t633 - self.constants[33]);
        t637 = self.constants[1] * t633;
        t640 = self.constants[34] - t637 - t637;
        t645 = self.constants[16] + self.constants[23] + t602 + self.constants[28] + t610
            + t640;
        t649 = self.constants[1] * t581;
        t651 = t13 * t583 + t649 - t9 * t589;
        t654 = t636 + t432 * t645 + t505 * t651;
        t659 = t613 * t616 + t614 * t617;
        t660 = t612 - t659;
        t663 = t649 - t432 * t651 - t505 * t660;
        t666 = self.constants[0].like(1.0) - t432;
        t667 = self.constants[6] * t569;
        t670 = t9 * sin_delta;
        t673 = t243 - cos_delta * t432 - t505 * t670;
        t679 = t229 + cos_delta * t569 - t13 * sin_delta - t571 * t670;
        t680 = self.constants[7] * t679;
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
        t720 = self.constants[24] + t607;
        t723 = t13 * t720 - t9 * t598;
        t725 = self.constants[6] * t714;
        t730 = t238 + cos_delta * t714 - t670 * t716;
        t731 = self.constants[7] * t730;
        t741 = t718 + t645 * t714 - t651 * t716;
        t746 = t723 + t651 * t714 - t660 * t716;
        t754 = t9 * t720 + t13 * t598 + self.constants[1] * t596 + t591 * t714
            + t569 * t741 + t667 * t714;
        t758 = t709 * (t754 + t680 * t730 - t629 * t716 - t571 * t746);
        t759 = t708 * t758;
        t765 = t712 + t666 * t725 + t673 * t731 - t654 * t714 - t663 * t716
            - t432 * t718;
        t779 = self.constants[24] + t714 * t741 + t714 * t718 + t714 * t725 + t730 * t731
            - t716 * t746;
        t781 = t779 - t716 * t723 - t758 * t759;
        t782 = self.constants[0].like(1.0) / t781;
        t783 = (t765 - t505 * t723 - t710 * t759) * t782;
        t793 = forces[1] + t551 * t716 - t524 - t503 * t714 - t238 * t482 - t579 * t758;
        t799 = t432 * t503 + t505 * t551 + t431 - t243 * t482 - t579 * t710
            - t783 * t793;
        t817 = t432 * t654 + t432 * t636 + self.constants[35]
            + self.constants[6] * t666 * t666 + self.constants[7] * t673 * t673
            - t505 * t663;
        t821 = t799 / (t817 - t505 * t649 - t708 * t710 * t710 - t781 * t783 * t783);
        t825 = t782 * t793 - t783 * t821;
        t829 = t579 * t709 - t758 * t825 - t710 * t821;
        t837 = t333 + t84 * t829 + t120 * t825 + t124 * t821;
        t841 = t78 * t829 + t116 * t825 - sin_phi * t837 - t335;
        t842 = t821 + t841;
        t844 = self.constants[1] * t842 - t160;
        t846 = t159 + t9 * t844;
        t851 = t304 - t846 - self.constants[8] * t841;
        t856 = t166 - cos_phi * t837;
        t859 = t13 * t829 - t172 - t9 * t856;
        t862 = cos_delta * t841 - t282 - sin_delta * t859;
        t865 = t365 + self.constants[3] * t851 - self.constants[19] * t862;
        t868 = t147 + t865 - self.constants[0] * t846 - self.constants[13] * t841;
        let (
            t871, t876, t881, t887, t890, t892, t896, t900, t902, t907, t911, t913, t916, t918,
            t926, t927, t938, t946, t955, t959, t969, t976, t990, t994, t998, t1000, t1001, t1006,
            t1013, t1017, t1020, t1022, t1025, t1030, t1034, t1037, t1040, t1041,
        );
        t871 = t375 - t13 * t844;
        t876 = t871 + self.constants[9] * t841 - t188;
        t881 = t168 + t13 * t856 + t9 * t829;
        t887 = t177 + t385 - self.constants[1] * (t175 + t829);
        t890 = t165 + self.constants[8] * t881 - self.constants[9] * t859 - t887;
        t892 = cos_delta * t876 + sin_delta * t890;
        t896 = self.constants[3] * t892 + self.constants[20] * t862 - t397;
        t900 = cos_delta * t890 - sin_delta * t876;
        t902 = t825 + t881;
        t907 = t214 + cos_delta * t859 + sin_delta * t841;
        t911 = t413 + self.constants[3] * t900 + self.constants[19] * t902
            - self.constants[20] * t907;
        t913 = cos_delta * t896 - sin_delta * t911;
        t916 = self.constants[0] * t871 + self.constants[14] * t841 + t913 - t424;
        t918 = t9 * t868 + t13 * t916;
        t926 = self.constants[7]
            * (t480 + t862 + t229 * t829 + t238 * t825 + t243 * t821);
        t927 = t228 * t926;
        t938 = t465 + self.constants[21] * t907 + self.constants[22] * t902
            - self.constants[20] * t900;
        t946 = t488 + t926 + self.constants[20] * t892 + self.constants[23] * t862
            - self.constants[19] * t851;
        t955 = t448 + self.constants[14] * t871 + self.constants[13] * t846
            + self.constants[16] * t841 + self.constants[6] * t842 + sin_delta * t938;
        t959 = t955 + cos_delta * t946 + self.constants[9] * t913
            - self.constants[8] * t865 - self.constants[1] * t918;
        t969 = sin_delta * t896 + cos_delta * t911;
        t976 = t515 + t521 + self.constants[15] * t859 + self.constants[18] * t881
            + self.constants[19] * t900 + self.constants[22] * t907
            + self.constants[24] * t902;
        t990 = t540 + self.constants[14] * t887 + self.constants[17] * t859
            + self.constants[15] * t881 + cos_delta * t938 - sin_delta * t946;
        t994 = cos_phi
            * (t13 * (t976 + self.constants[8] * t969 - self.constants[13] * t887)
                - t9 * (t990 - self.constants[9] * t969));
        t998 = t82 * (sin_phi * t959 + t994 - t225 * t927);
        t1000 = t36 * t927 - t43 * t998;
        t1001 = t918 - t1000;
        t1006 = t43 * t927 + t36 * t998;
        t1013 = t562 + t969 + self.constants[13] * t881 - self.constants[0] * t887
            - self.constants[14] * t859;
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
    /// 160 additions, 242 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 408 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WhippleMechanismMatrices<T>, WhippleMechanismDerivatives<T>) {
        let t6 = self.zH * self.mH;
        let t10 = self.rF * self.mF;
        let Jxx_delta = self.IHxx + self.IFxx + self.zH * t6 + self.rF * t10;
        let t17 = self.rR * self.mR;
        let t21 = self.zB * self.mB;
        let M_11 = self.IRxx + self.IBxx + Jxx_delta + self.rR * t17 + self.zB * t21;
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t34 = self.c + self.w;
        let t36 = t34 - self.xH;
        let Jxz_delta = self.IHxz + t6 * t36 - t10 * self.c;
        let t41 = Jxz_delta * cos_lam;
        let hx_delta = Jxx_delta * sin_lam + t41;
        let t43 = self.w.like(1.0) / self.w;
        let yaw_per_v_delta = cos_lam * t43;
        let mu = self.c * yaw_per_v_delta;
        let Sz_delta = t6 - t10;
        let Jxz_all = Jxz_delta + self.IBxz - t21 * self.xB - t34 * Sz_delta;
        let M_12 = hx_delta + mu * Jxz_all;
        let t57 = sin_lam * Jxz_delta;
        let t59 = self.mF * self.c;
        let t61 = self.mH * t36;
        let Jzz_delta = self.IFxx + self.IHzz + self.c * t59 + t36 * t61;
        let hz_delta = t57 + cos_lam * Jzz_delta;
        let t70 = t59 + t61;
        let t72 = sin_lam * Sz_delta + cos_lam * t70;
        let M_yaw_delta = hz_delta - t34 * t72;
        let mA = self.mH + self.mF;
        let t78 = t70 - t34 * mA;
        let t79 = t70 + t78;
        let t81 = self.mB * self.xB;
        let P_delta_yaw_mu = self.IRxx + Jzz_delta + self.IBzz + self.xB * t81
            - t34 * t79;
        let t87 = mu * P_delta_yaw_mu;
        let P_delta_yaw = M_yaw_delta + t87;
        let t89 = M_yaw_delta + P_delta_yaw;
        let M_22 = sin_lam * hx_delta + cos_lam * hz_delta + mu * t89;
        let zero = self.w.like(0.0);
        let t95 = self.w.like(1.0) / self.rF;
        let SF = self.IFyy * t95;
        let t97 = cos_lam * SF;
        let t99 = self.w.like(1.0) / self.rR;
        let t100 = self.IRyy * t99;
        let ST = SF + t100;
        let Sz_all = t21 + Sz_delta - t17;
        let t104 = ST - Sz_all;
        let t106 = yaw_per_v_delta * Jxz_all;
        let C1_12 = t97 + mu * t104 + t106;
        let Sx_all = t81 - t78;
        let K0_12 = t72 - mu * Sx_all;
        let C1_22 = yaw_per_v_delta * P_delta_yaw - mu * K0_12;
        let K0_22 = sin_lam * K0_12;
        let K2_12 = yaw_per_v_delta * t104;
        let t119 = sin_lam * SF;
        let K2_22_yaw_per_v_delta = t119 - K0_12;
        let K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
        let t122 = t43 * yaw_per_v_delta;
        let t123 = self.c * Jxz_all;
        let M_12_Jxz_delta = cos_lam + mu;
        let t127 = t6 * M_12_Jxz_delta;
        let t128 = t127 - mu * Sz_delta;
        let M_12_w = t128 - t122 * t123;
        let M_22_mu = t87 + t89;
        let M_22_yaw_per_v_delta = self.c * M_22_mu;
        let t134 = t34 * mu;
        let t137 = mA * t134 - t72 - mu * t79;
        let t140 = t134 + t134;
        let t143 = cos_lam * t140 + mu * t140;
        let M_22_hz_delta = mu + M_12_Jxz_delta;
        let M_22_IRxx = mu * mu;
        let M_22_Jzz_delta = cos_lam * M_22_hz_delta + M_22_IRxx;
        let t149 = t36 * M_22_Jzz_delta - t143;
        let M_22_Jxz_delta = sin_lam * (cos_lam + M_22_hz_delta);
        let t156 = self.mH * t149 + t6 * M_22_Jxz_delta + t61 * M_22_Jzz_delta;
        let t157 = mu * (t137 - t72) + t156;
        let M_22_w = t157 - t122 * M_22_yaw_per_v_delta;
        let C1_12_yaw_per_v_delta = Jxz_all + self.c * t104;
        let t163 = t6 * yaw_per_v_delta;
        let t164 = t163 - yaw_per_v_delta * Sz_delta;
        let C1_12_w = t164 - t122 * C1_12_yaw_per_v_delta;
        let t166 = self.c * ST;
        let C1_21_w = t122 * t166;
        let t168 = mu * mA;
        let t169 = self.c * Sx_all;
        let t171 = t168 - t122 * t169;
        let t172 = self.mH * M_12_Jxz_delta;
        let P_delta_lateral_w = t171 - t172;
        let C1_22_mu = yaw_per_v_delta * P_delta_yaw_mu - K0_12;
        let C1_22_yaw_per_v_delta = P_delta_yaw + self.c * C1_22_mu;
        let t181 = t34 * yaw_per_v_delta;
        let t184 = cos_lam * t181 + yaw_per_v_delta * t140;
        let C1_22_IRxx = yaw_per_v_delta * mu;
        let C1_22_Jzz_delta = cos_lam * yaw_per_v_delta + C1_22_IRxx;
        let t189 = t36 * C1_22_Jzz_delta - t184;
        let C1_22_Jxz_delta = sin_lam * yaw_per_v_delta;
        let t195 = self.mH * t189 + t6 * C1_22_Jxz_delta + t61 * C1_22_Jzz_delta;
        let t196 = yaw_per_v_delta * t137 + t195;
        let C1_22_w = mu * P_delta_lateral_w + t196 - t122 * C1_22_yaw_per_v_delta;
        let t199 = sin_lam * P_delta_lateral_w;
        let t200 = t104 * t122;
        let K2_22_w = yaw_per_v_delta * P_delta_lateral_w - K2_22_yaw_per_v_delta * t122;
        let M_12_c = t106 + t128 - t10 * M_12_Jxz_delta;
        let t209 = self.c * M_22_Jzz_delta - t143;
        let M_22_c = t157 + self.mF * t209 + yaw_per_v_delta * M_22_mu
            + t59 * M_22_Jzz_delta - t10 * M_22_Jxz_delta;
        let C1_12_c = t164 + yaw_per_v_delta * (t104 - t10);
        let t220 = yaw_per_v_delta * ST;
        let t223 = self.c * C1_22_Jzz_delta - t184;
        let t228 = t168 + yaw_per_v_delta * Sx_all - t172;
        let t229 = self.mF * M_12_Jxz_delta;
        let P_delta_lateral_c = t228 - t229;
        let C1_22_c = t196 + self.mF * t223 + yaw_per_v_delta * C1_22_mu
            + mu * P_delta_lateral_c + t59 * C1_22_Jzz_delta - t10 * C1_22_Jxz_delta;
        let t238 = sin_lam * P_delta_lateral_c;
        let K2_22_c = yaw_per_v_delta * P_delta_lateral_c;
        let hx_delta_lam = Jxx_delta * cos_lam - t57;
        let t242 = sin_lam * t43;
        let M_12_lam = hx_delta_lam - t123 * t242;
        let hz_delta_lam = t41 - sin_lam * Jzz_delta;
        let t254 = cos_lam * Sz_delta - sin_lam * t70;
        let M_22_lam = sin_lam * hx_delta_lam + cos_lam * hx_delta
            + M_22_hz_delta * hz_delta_lam - sin_lam * hz_delta
            - M_22_yaw_per_v_delta * t242 - t140 * t254;
        let t262 = t119 + C1_12_yaw_per_v_delta * t242;
        let C1_21_lam = t119 + t166 * t242;
        let K0_12_lam = t254 + t169 * t242;
        let C1_22_lam = yaw_per_v_delta * hz_delta_lam - mu * K0_12_lam
            - C1_22_yaw_per_v_delta * t242 - t181 * t254;
        let K0_22_lam = sin_lam * K0_12_lam + cos_lam * K0_12;
        let t277 = t104 * t242;
        let K2_22_lam = yaw_per_v_delta * (t97 - K0_12_lam)
            - K2_22_yaw_per_v_delta * t242;
        let M_11_rR = t17 + t17;
        let t283 = t99 * t100;
        let t284 = self.mR - t283;
        let C1_12_rR = mu * t284;
        let C1_21_rR = mu * t283;
        let K2_12_rR = yaw_per_v_delta * t284;
        let M_11_mR = self.rR * self.rR;
        let C1_12_mR = self.rR * mu;
        let K2_12_mR = self.rR * yaw_per_v_delta;
        let C1_12_IRyy = mu * t99;
        let K2_12_IRyy = yaw_per_v_delta * t99;
        let t294 = t21 * mu;
        let t295 = mu * self.xB;
        let t296 = self.mB * t295;
        let P_delta_yaw_xB = t296 + mu * t81;
        let M_22_xB = mu * P_delta_yaw_xB;
        let t300 = t21 * yaw_per_v_delta;
        let t302 = self.mB * mu;
        let C1_22_xB = yaw_per_v_delta * P_delta_yaw_xB + mu * t302;
        let t305 = sin_lam * t302;
        let K2_22_xB = yaw_per_v_delta * t302;
        let M_11_zB = t21 + t21;
        let t309 = mu + yaw_per_v_delta * self.xB;
        let t310 = self.mB * t309;
        let t311 = self.mB * yaw_per_v_delta;
        let M_11_mB = self.zB * self.zB;
        let t313 = self.zB * t295;
        let P_delta_yaw_mB = self.xB * t295;
        let M_22_mB = mu * P_delta_yaw_mB;
        let t316 = self.zB * t309;
        let C1_22_mB = yaw_per_v_delta * P_delta_yaw_mB + mu * t295;
        let t320 = sin_lam * t295;
        let t321 = self.zB * yaw_per_v_delta;
        let K2_22_mB = yaw_per_v_delta * t295;
        let C1_22_xH = mu * t172 - t195;
        let t325 = sin_lam * t172;
        let K2_22_xH = yaw_per_v_delta * t172;
        let M_11_zH = t6 + t6;
        let K0_12_mH = self.zH * sin_lam + t36 * M_12_Jxz_delta - t134;
        let M_12_zH = self.mH * K0_12_mH + t6 * sin_lam;
        let t335 = sin_lam * t140;
        let M_22_Jxx_delta = sin_lam * sin_lam;
        let t340 = self.zH * M_22_Jxx_delta + t36 * M_22_Jxz_delta - t335;
        let M_22_zH = self.mH * t340 + t6 * M_22_Jxx_delta;
        let t344 = mu + t181;
        let t346 = t36 * yaw_per_v_delta - t344;
        let C1_12_zH = self.mH * t346;
        let t348 = sin_lam * t181;
        let t350 = t36 * C1_22_Jxz_delta - t348;
        let K0_12_zH = self.mH * sin_lam;
        let C1_22_zH = self.mH * t350 - mu * K0_12_zH;
        let K0_22_zH = sin_lam * K0_12_zH;
        let t356 = self.mH * yaw_per_v_delta;
        let t357 = yaw_per_v_delta * K0_12_zH;
        let M_11_mH = self.zH * self.zH;
        let M_12_mH = self.zH * K0_12_mH;
        let P_delta_yaw_mA = t34 * t134;
        let M_22_mA = mu * P_delta_yaw_mA;
        let M_22_mH = M_22_mA + self.zH * t340 + t36 * t149;
        let C1_12_mH = self.zH * t346;
        let C1_22_mA = yaw_per_v_delta * P_delta_yaw_mA;
        let C1_22_mH = C1_22_mA + self.zH * t350 + t36 * t189 - mu * K0_12_mH;
        let K0_22_mH = sin_lam * K0_12_mH;
        let t375 = self.zH * yaw_per_v_delta;
        let t376 = yaw_per_v_delta * K0_12_mH;
        let M_11_rF = t10 + t10;
        let K0_12_mF = self.c * M_12_Jxz_delta - t134 - self.rF * sin_lam;
        let M_12_rF = t10 * sin_lam - self.mF * K0_12_mF;
        let t388 = t335 + self.rF * M_22_Jxx_delta - self.c * M_22_Jxz_delta;
        let M_22_rF = self.mF * t388 + t10 * M_22_Jxx_delta;
        let t392 = t344 - mu;
        let t394 = t95 * SF;
        let C1_21_rF = M_12_Jxz_delta * t394;
        let C1_12_rF = self.mF * t392 - C1_21_rF;
        let t398 = t348 - self.c * C1_22_Jxz_delta;
        let P_delta_lateral_rF = self.mF * sin_lam;
        let C1_22_rF = self.mF * t398 + mu * P_delta_lateral_rF;
        let t403 = sin_lam * P_delta_lateral_rF;
        let K2_12_rF = self.mF * yaw_per_v_delta - yaw_per_v_delta * t394;
        let K2_22_rF = yaw_per_v_delta * P_delta_lateral_rF - C1_22_Jxz_delta * t394;
        let M_11_mF = self.rF * self.rF;
        let t411 = self.rF * K0_12_mF;
        let M_22_mF = M_22_mA + self.c * t209 + self.rF * t388;
        let C1_12_mF = self.rF * t392;
        let C1_22_mF = C1_22_mA + self.c * t223 + self.rF * t398 - mu * K0_12_mF;
        let K0_22_mF = sin_lam * K0_12_mF;
        let K2_12_mF = self.rF * yaw_per_v_delta;
        let t425 = yaw_per_v_delta * K0_12_mF;
        let M_22_IFxx = M_22_Jzz_delta + M_22_Jxx_delta;
        let C1_12_IFyy = t95 * M_12_Jxz_delta;
        let K2_12_IFyy = yaw_per_v_delta * t95;
        let K2_22_IFyy = t95 * C1_22_Jxz_delta;
        let C1_21 = -(t97 + mu * ST);
        let K0_12_w = t172 - t171;
        let K0_12_c = t229 - t228;
        (
            WhippleMechanismMatrices::from_entries([
                M_11, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, Sz_all, K0_12, K0_12, K0_22,
                zero, K2_12, zero, K2_22,
            ]),
            WhippleMechanismDerivatives {
                values: [
                    M_12_w, M_22_w, C1_12_w, C1_21_w, C1_22_w, K0_12_w, t199, t200, K2_22_w, M_12_c,
                    M_22_c, C1_12_c, t220, C1_22_c, K0_12_c, t238, K2_22_c, M_12_lam, M_22_lam,
                    t262, C1_21_lam, C1_22_lam, K0_12_lam, K0_22_lam, t277, K2_22_lam, M_11_rR,
                    C1_12_rR, C1_21_rR, self.mR, K2_12_rR, M_11_mR, C1_12_mR, self.rR, K2_12_mR,
                    self.w.like(1.0), M_22_IRxx, C1_22_IRxx, C1_12_IRyy, K2_12_IRyy, t294, M_22_xB,
                    t300, C1_22_xB, t302, t305, K2_22_xB, M_11_zB, t296, t310, self.mB, t311,
                    M_11_mB, t313, M_22_mB, t316, C1_22_mB, self.zB, t295, t320, t321, K2_22_mB, mu,
                    yaw_per_v_delta, t127, t156, t163, C1_22_xH, t172, t325, K2_22_xH, M_11_zH,
                    M_12_zH, M_22_zH, C1_12_zH, C1_22_zH, self.mH, K0_12_zH, K0_22_zH, t356, t357,
                    M_11_mH, M_12_mH, M_22_mH, C1_12_mH, C1_22_mH, self.zH, K0_12_mH, K0_22_mH,
                    t375, t376, sin_lam, M_22_Jxx_delta, M_22_Jzz_delta, C1_22_Jzz_delta,
                    M_12_Jxz_delta, M_22_Jxz_delta, C1_22_Jxz_delta, M_11_rF, M_12_rF, M_22_rF,
                    C1_12_rF, C1_21_rF, C1_22_rF, self.mF, P_delta_lateral_rF, t403, K2_12_rF,
                    K2_22_rF, M_11_mF, t411, M_22_mF, C1_12_mF, C1_22_mF, self.rF, K0_12_mF,
                    K0_22_mF, K2_12_mF, t425, M_22_IFxx, C1_12_IFyy, K2_12_IFyy, K2_22_IFyy,
                ],
            },
        )
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
        let matrices = self.matrices();
        [
            matrices.m[0][0], matrices.m[0][1], matrices.m[1][1], matrices.c1[0][1],
            matrices.c1[1][0], matrices.c1[1][1], matrices.k0[0][0], matrices.k0[0][1],
            matrices.k0[1][1], matrices.k2[0][1], matrices.k2[1][1],
        ]
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

impl WhippleMechanismDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 158] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 0), Partial::new(MatrixName::M, 1, 0, 0, 0),
        Partial::new(MatrixName::M, 1, 1, 0, 1), Partial::new(MatrixName::C1, 0, 1, 0, 2),
        Partial::new(MatrixName::C1, 1, 0, 0, 3), Partial::new(MatrixName::C1, 1, 1, 0, 4),
        Partial::new(MatrixName::K0, 0, 1, 0, 5), Partial::new(MatrixName::K0, 1, 0, 0, 5),
        Partial::new(MatrixName::K0, 1, 1, 0, 6).negative(),
        Partial::new(MatrixName::K2, 0, 1, 0, 7).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 8), Partial::new(MatrixName::M, 0, 1, 1, 9),
        Partial::new(MatrixName::M, 1, 0, 1, 9), Partial::new(MatrixName::M, 1, 1, 1, 10),
        Partial::new(MatrixName::C1, 0, 1, 1, 11),
        Partial::new(MatrixName::C1, 1, 0, 1, 12).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 13),
        Partial::new(MatrixName::K0, 0, 1, 1, 14),
        Partial::new(MatrixName::K0, 1, 0, 1, 14),
        Partial::new(MatrixName::K0, 1, 1, 1, 15).negative(),
        Partial::new(MatrixName::K2, 1, 1, 1, 16), Partial::new(MatrixName::M, 0, 1, 2, 17),
        Partial::new(MatrixName::M, 1, 0, 2, 17), Partial::new(MatrixName::M, 1, 1, 2, 18),
        Partial::new(MatrixName::C1, 0, 1, 2, 19).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 20), Partial::new(MatrixName::C1, 1, 1, 2, 21),
        Partial::new(MatrixName::K0, 0, 1, 2, 22), Partial::new(MatrixName::K0, 1, 0, 2, 22),
        Partial::new(MatrixName::K0, 1, 1, 2, 23),
        Partial::new(MatrixName::K2, 0, 1, 2, 24).negative(),
        Partial::new(MatrixName::K2, 1, 1, 2, 25), Partial::new(MatrixName::M, 0, 0, 4, 26),
        Partial::new(MatrixName::C1, 0, 1, 4, 27), Partial::new(MatrixName::C1, 1, 0, 4, 28),
        Partial::new(MatrixName::K0, 0, 0, 4, 29).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 30),
        Partial::new(MatrixName::M, 0, 0, 5, 31),
        Partial::new(MatrixName::C1, 0, 1, 5, 32),
        Partial::new(MatrixName::K0, 0, 0, 5, 33).negative(),
        Partial::new(MatrixName::K2, 0, 1, 5, 34), Partial::new(MatrixName::M, 0, 0, 6, 35),
        Partial::new(MatrixName::M, 1, 1, 6, 36), Partial::new(MatrixName::C1, 1, 1, 6, 37),
        Partial::new(MatrixName::C1, 0, 1, 7, 38),
        Partial::new(MatrixName::C1, 1, 0, 7, 38).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 39),
        Partial::new(MatrixName::M, 0, 1, 8, 40).negative(),
        Partial::new(MatrixName::M, 1, 0, 8, 40).negative(),
        Partial::new(MatrixName::M, 1, 1, 8, 41),
        Partial::new(MatrixName::C1, 0, 1, 8, 42).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 43),
        Partial::new(MatrixName::K0, 0, 1, 8, 44).negative(),
        Partial::new(MatrixName::K0, 1, 0, 8, 44).negative(),
        Partial::new(MatrixName::K0, 1, 1, 8, 45).negative(),
        Partial::new(MatrixName::K2, 1, 1, 8, 46), Partial::new(MatrixName::M, 0, 0, 9, 47),
        Partial::new(MatrixName::M, 0, 1, 9, 48).negative(),
        Partial::new(MatrixName::M, 1, 0, 9, 48).negative(),
        Partial::new(MatrixName::C1, 0, 1, 9, 49).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 50),
        Partial::new(MatrixName::K2, 0, 1, 9, 51).negative(),
        Partial::new(MatrixName::M, 0, 0, 10, 52),
        Partial::new(MatrixName::M, 0, 1, 10, 53).negative(),
        Partial::new(MatrixName::M, 1, 0, 10, 53).negative(),
        Partial::new(MatrixName::M, 1, 1, 10, 54),
        Partial::new(MatrixName::C1, 0, 1, 10, 55).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 56),
        Partial::new(MatrixName::K0, 0, 0, 10, 57),
        Partial::new(MatrixName::K0, 0, 1, 10, 58).negative(),
        Partial::new(MatrixName::K0, 1, 0, 10, 58).negative(),
        Partial::new(MatrixName::K0, 1, 1, 10, 59).negative(),
        Partial::new(MatrixName::K2, 0, 1, 10, 60).negative(),
        Partial::new(MatrixName::K2, 1, 1, 10, 61), Partial::new(MatrixName::M, 0, 0, 11, 35),
        Partial::new(MatrixName::M, 1, 1, 13, 36), Partial::new(MatrixName::C1, 1, 1, 13, 37),
        Partial::new(MatrixName::M, 0, 1, 14, 62), Partial::new(MatrixName::M, 1, 0, 14, 62),
        Partial::new(MatrixName::C1, 0, 1, 14, 63),
        Partial::new(MatrixName::M, 0, 1, 15, 64).negative(),
        Partial::new(MatrixName::M, 1, 0, 15, 64).negative(),
        Partial::new(MatrixName::M, 1, 1, 15, 65).negative(),
        Partial::new(MatrixName::C1, 0, 1, 15, 66).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 67),
        Partial::new(MatrixName::K0, 0, 1, 15, 68).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 68).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 69).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 70), Partial::new(MatrixName::M, 0, 0, 16, 71),
        Partial::new(MatrixName::M, 0, 1, 16, 72), Partial::new(MatrixName::M, 1, 0, 16, 72),
        Partial::new(MatrixName::M, 1, 1, 16, 73), Partial::new(MatrixName::C1, 0, 1, 16, 74),
        Partial::new(MatrixName::C1, 1, 1, 16, 75), Partial::new(MatrixName::K0, 0, 0, 16, 76),
        Partial::new(MatrixName::K0, 0, 1, 16, 77), Partial::new(MatrixName::K0, 1, 0, 16, 77),
        Partial::new(MatrixName::K0, 1, 1, 16, 78),
        Partial::new(MatrixName::K2, 0, 1, 16, 79).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 80).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 81), Partial::new(MatrixName::M, 0, 1, 17, 82),
        Partial::new(MatrixName::M, 1, 0, 17, 82), Partial::new(MatrixName::M, 1, 1, 17, 83),
        Partial::new(MatrixName::C1, 0, 1, 17, 84), Partial::new(MatrixName::C1, 1, 1, 17, 85),
        Partial::new(MatrixName::K0, 0, 0, 17, 86), Partial::new(MatrixName::K0, 0, 1, 17, 87),
        Partial::new(MatrixName::K0, 1, 0, 17, 87), Partial::new(MatrixName::K0, 1, 1, 17, 88),
        Partial::new(MatrixName::K2, 0, 1, 17, 89).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 90).negative(),
        Partial::new(MatrixName::M, 0, 0, 18, 35), Partial::new(MatrixName::M, 0, 1, 18, 91),
        Partial::new(MatrixName::M, 1, 0, 18, 91), Partial::new(MatrixName::M, 1, 1, 18, 92),
        Partial::new(MatrixName::M, 1, 1, 20, 93), Partial::new(MatrixName::C1, 1, 1, 20, 94),
        Partial::new(MatrixName::M, 0, 1, 21, 95), Partial::new(MatrixName::M, 1, 0, 21, 95),
        Partial::new(MatrixName::M, 1, 1, 21, 96), Partial::new(MatrixName::C1, 0, 1, 21, 63),
        Partial::new(MatrixName::C1, 1, 1, 21, 97), Partial::new(MatrixName::M, 0, 0, 22, 98),
        Partial::new(MatrixName::M, 0, 1, 22, 99), Partial::new(MatrixName::M, 1, 0, 22, 99),
        Partial::new(MatrixName::M, 1, 1, 22, 100), Partial::new(MatrixName::C1, 0, 1, 22, 101),
        Partial::new(MatrixName::C1, 1, 0, 22, 102), Partial::new(MatrixName::C1, 1, 1, 22, 103),
        Partial::new(MatrixName::K0, 0, 0, 22, 104).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 105).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 105).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 106).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 107),
        Partial::new(MatrixName::K2, 1, 1, 22, 108),
        Partial::new(MatrixName::M, 0, 0, 23, 109),
        Partial::new(MatrixName::M, 0, 1, 23, 110).negative(),
        Partial::new(MatrixName::M, 1, 0, 23, 110).negative(),
        Partial::new(MatrixName::M, 1, 1, 23, 111),
        Partial::new(MatrixName::C1, 0, 1, 23, 112),
        Partial::new(MatrixName::C1, 1, 1, 23, 113),
        Partial::new(MatrixName::K0, 0, 0, 23, 114).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 115), Partial::new(MatrixName::K0, 1, 0, 23, 115),
        Partial::new(MatrixName::K0, 1, 1, 23, 116), Partial::new(MatrixName::K2, 0, 1, 23, 117),
        Partial::new(MatrixName::K2, 1, 1, 23, 118).negative(),
        Partial::new(MatrixName::M, 0, 0, 24, 35), Partial::new(MatrixName::M, 0, 1, 24, 91),
        Partial::new(MatrixName::M, 1, 0, 24, 91), Partial::new(MatrixName::M, 1, 1, 24, 119),
        Partial::new(MatrixName::C1, 1, 1, 24, 94), Partial::new(MatrixName::C1, 0, 1, 25, 120),
        Partial::new(MatrixName::C1, 1, 0, 25, 120).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 121),
        Partial::new(MatrixName::K2, 1, 1, 25, 122),
    ];
}
