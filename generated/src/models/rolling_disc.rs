// @generated from generated/models/rolling_disc.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 8da020cde61b723e

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    MotionFormulas, Nonlinear, Number, ParameterError, ParameterInfo, Partial, Rate,
    Rows, Scalar, SetInfo, WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A disc that rolls without slip on level ground, upright and straight but for small lean and yaw.
///
/// Its spin balances it: it falls over, slowly, unless v^2 > g r It m r^2/(Ia (Ia + m r^2)), which is g r/3 for a
/// uniform disc and g r/4 for a hoop. Axes: origin at the contact point, x forward, y to the right, z down.
///
/// Source: Mechanism: Neimark & Fufaev (1972), Dynamics of Nonholonomic Systems
///
/// Derived from a mechanism: wheel `D` (disc).
///
/// The fields are the parameters. The coordinates are `phi` (lean) in `rad`, `psi` (yaw) in `rad`.
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
/// Jxx_all = It + r^2*m [kg*m^2]
/// Sz_all = -r*m [kg*m]
/// h_spin_D = Ia/r [kg*m]
/// M_11 = Jxx_all [kg*m^2]
/// M_22 = It [kg*m^2]
/// C1_12 = h_spin_D - Sz_all [kg*m]
/// C1_21 = -h_spin_D [kg*m]
/// K0_11 = Sz_all [kg*m]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct RollingDisc<T = f64> {
    /// Radius.
    ///
    /// `r` in `m`: `> 0`.
    pub r: T,
    /// Mass.
    ///
    /// `m` in `kg`: `> 0`.
    pub m: T,
    /// Axial moment of inertia, about the axle.
    ///
    /// `Ia` in `kg*m^2`: `>= 0`.
    pub Ia: T,
    /// Transverse moment of inertia, about a diameter.
    ///
    /// `It` in `kg*m^2`: `> 0`.
    pub It: T,
    /// Gravitational field strength.
    ///
    /// `g` in `N/kg`: `>= 0`.
    pub g: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`RollingDisc`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingDiscMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
}

impl<T: Number> RollingDisc<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 2 additions, 2 multiplications, 1 division and 2 negations: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> RollingDiscMatrices<T> {
        let t3 = self.r * self.m;
        let Jxx_all = self.It + self.r * t3;
        let zero = self.r.like(0.0);
        let h_spin_D = self.Ia / self.r;
        let C1_12 = t3 + h_spin_D;
        let C1_21 = -h_spin_D;
        let K0_11 = -t3;
        RollingDiscMatrices::from_entries([
            Jxx_all, zero, zero, self.It, zero, C1_12, C1_21, zero, K0_11, zero, zero, zero,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`RollingDisc`] that follow from its coordinates q = (`phi`, `psi`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingDiscKinematics<T = f64> {
    /// Lateral velocity, to the right, in `m/s`: of the point of `D` that is at the origin.
    pub lateral: Rate<T, 2>,
    /// Spin of the wheel `D`, disc: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_D: Rate<T, 2>,
}

impl<T: Scalar> RollingDisc<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 division and 1 negation: 2 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> RollingDiscKinematics<T> {
        let zero = self.r.like(0.0);
        let t4 = -(self.r.like(1.0) / self.r);
        RollingDiscKinematics {
            lateral: Rate {
                speed: zero, rates: [zero, zero], coordinates: [zero, self.r.like(1.0)],
                heading: zero,
            },
            wheel_D: Rate {
                speed: t4, rates: [zero, zero], coordinates: [zero, zero], heading: zero,
            },
        }
    }
}

// --- The nonlinear equations of motion -----------------------------------------------------------

/// The nonlinear equations of motion of [`RollingDisc`], with its parameters: what does not depend on the state is computed.
///
/// Positions: `x` (x of the contact point of the disc) in `m`, `y` (y of the contact point of the disc) in `m`, `psi` (yaw) in `rad`, `phi` (lean) in `rad`, `thetaD` (angle of the disc) in `rad`.
/// Speeds: the rates of `psi`, `phi`, `thetaD`.
///
/// Each from one straight-line program:
/// - closure: no operations
/// - rates: 3 multiplications, 2 negations and 2 trigonometric functions: 7 operations
/// - derivatives: 18 additions, 39 multiplications, 3 divisions, 4 negations and 4 trigonometric functions: 68 operations
/// - accelerations: 20 additions, 43 multiplications, 3 divisions, 3 negations and 4 trigonometric functions: 73 operations
/// - energy: 7 additions, 17 multiplications and 2 trigonometric functions: 26 operations
/// - contact forces: 29 additions, 55 multiplications, 3 divisions, 1 negation and 4 trigonometric functions: 92 operations
/// - linearization: 53 additions, 101 multiplications, 3 divisions, 7 negations and 4 trigonometric functions: 168 operations
/// - by parameters: 38 additions, 83 multiplications, 3 divisions, 7 negations and 4 trigonometric functions: 135 operations
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingDiscMotion<T = f64> {
    constants: [T; 9],
}

impl<T: Number> RollingDisc<T> {
    /// The nonlinear equations of motion, of what is computed once for these parameters:
    /// 2 additions and 2 multiplications: 4 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn motion(&self) -> RollingDiscMotion<T> {
        let t5 = self.r * self.m;
        let t6 = self.r * t5;
        let t7 = self.It + t6;
        let t8 = self.Ia + t6;
        RollingDiscMotion {
            constants: [self.r, self.It, self.Ia, self.m, self.g, t5, t6, t7, t8],
        }
    }
}

impl<T: Scalar> Nonlinear<2> for RollingDisc<T> {
    type Motion = RollingDiscMotion<T>;

    type MotionOver<U: Number> = RollingDiscMotion<U>;

    fn motion(&self) -> RollingDiscMotion<T> {
        RollingDisc::motion(self)
    }

    #[inline(always)]
    fn motion_over<U: Number>(model: &RollingDisc<U>) -> RollingDiscMotion<U> {
        RollingDisc::motion(model)
    }
}

impl<T: Scalar> carvallo::motion::Motion for RollingDiscMotion<T> {
    const INFO: &'static carvallo::motion::MotionInfo = &carvallo::motion::MotionInfo {
        model: "RollingDisc",
        positions: &[
            carvallo::motion::PositionInfo {
                name: "x",
                label: "x of the contact point of the disc",
                unit: "m",
                kind: carvallo::motion::PositionKind::Ignorable,
            },
            carvallo::motion::PositionInfo {
                name: "y",
                label: "y of the contact point of the disc",
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
                name: "thetaD",
                label: "angle of the disc",
                unit: "rad",
                kind: carvallo::motion::PositionKind::Ignorable,
            },
        ],
        speeds: &[2, 3, 4],
        dependent: &[],
        forces: &[],
        wheels: &[
            carvallo::motion::WheelInfo {
                name: "D",
                label: "disc",
            },
        ],
    };

    fn linearize_into(
        &self, positions: &[T; 5], speeds: &[T; 3], forces: &[T; 0], a: &mut [T], b: &mut [T],
    ) -> Option<Result<(), carvallo::motion::MotionError>> {
        let found = carvallo::motion::Linearizable::linearize(self, positions, speeds, forces);
        Some(found.map(|found| carvallo::motion::Linearization::copy_into(&found, a, b)))
    }
}

#[allow(unused_variables)]
impl<T: Number> carvallo::motion::Unchecked for RollingDiscMotion<T> {
    type Scalar = T;

    type Positions = [T; 5];

    type Speeds = [T; 3];

    type Dependent = [T; 0];

    type Forces = [T; 0];

    type ContactForces = [[T; 3]; 1];

    #[inline(always)]
    fn closure_unchecked(&self, positions: &[T; 5]) -> ([T; 0], [T; 0]) {
        ([], [])
    }

    #[inline(always)]
    fn rates_unchecked(&self, positions: &[T; 5], speeds: &[T; 3]) -> [T; 5] {
        let t2 = self.constants[0] * speeds[2];
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let t10 = -(t2 * cos_psi);
        let t11 = -(t2 * sin_psi);
        [t10, t11, speeds[0], speeds[1], speeds[2]]
    }

    #[inline(always)]
    fn derivatives_unchecked(&self, positions: &[T; 5], speeds: &[T; 3], forces: &[T; 0]) -> ([T; 5], [T; 3]) {
        let t2 = self.constants[0] * speeds[2];
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t13 = speeds[0] * cos_phi;
        let t15 = speeds[1] * self.constants[1];
        let t17 = t13 * self.constants[1];
        let t20 = speeds[1] * t13;
        let t23 = self.constants[0] * t13;
        let t27 = self.constants[0] * self.constants[3];
        let t29 = self.constants[2] * t20
            + (self.constants[0] * t20 + speeds[1] * t23) * t27;
        let t33 = speeds[0] * sin_phi;
        let t34 = t15 * t33;
        let t36 = self.constants[2] * (speeds[2] + t33);
        let t41 = sin_phi * (t13 * t15 + t29 - speeds[1] * t17)
            + cos_phi * (speeds[1] * t36 - t34 - t34);
        let t43 = sin_phi * self.constants[6];
        let t47 = sin_phi * self.constants[2];
        let t50 = sin_phi * t43 + cos_phi * cos_phi * self.constants[1] + sin_phi * t47;
        let t51 = self.constants[0].like(1.0) / t50;
        let t54 = t51 * (t43 + t47);
        let t61 = (t41 * t54 - t29) / (self.constants[8] - t50 * t54 * t54);
        let t76 = (t17 * t33 - t13 * t36
            - t27 * (speeds[2] * t23 + t23 * t33 + sin_phi * self.constants[4]))
            / self.constants[7];
        let t77 = -(t2 * cos_psi);
        let t78 = -(t2 * sin_psi);
        let t79 = -(t41 * t51 + t54 * t61);
        let t80 = -t76;
        ([t77, t78, speeds[0], speeds[1], speeds[2]], [t79, t80, t61])
    }

    #[inline(always)]
    fn accelerations_unchecked(&self, positions: &[T; 5], speeds: &[T; 3], forces: &[T; 0]) -> [T; 5] {
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t7 = speeds[0] * cos_phi;
        let t9 = t7 * speeds[1];
        let t12 = self.constants[0] * t7;
        let t16 = self.constants[0] * self.constants[3];
        let t18 = self.constants[2] * t9
            + (self.constants[0] * t9 + speeds[1] * t12) * t16;
        let t21 = self.constants[1] * speeds[1];
        let t23 = t7 * self.constants[1];
        let t28 = sin_phi * speeds[0];
        let t29 = t21 * t28;
        let t32 = self.constants[2] * (t28 + speeds[2]);
        let t37 = sin_phi * (t7 * t21 + t18 - speeds[1] * t23)
            + cos_phi * (speeds[1] * t32 - t29 - t29);
        let t39 = sin_phi * self.constants[6];
        let t40 = sin_phi * self.constants[2];
        let t47 = sin_phi * t39 + cos_phi * cos_phi * self.constants[1] + sin_phi * t40;
        let t48 = self.constants[0].like(1.0) / t47;
        let t49 = (t39 + t40) * t48;
        let t56 = (t37 * t49 - t18) / (self.constants[8] - t47 * t49 * t49);
        let t57 = self.constants[0] * t56;
        let t61 = self.constants[0] * speeds[0] * speeds[2];
        let t63 = sin_psi * t61 - cos_psi * t57;
        let t82 = (t23 * t28 - t7 * t32
            - t16 * (t12 * speeds[2] + t12 * t28 + sin_phi * self.constants[4]))
            / self.constants[7];
        let t83 = -(t57 * sin_psi + cos_psi * t61);
        let t84 = -(t37 * t48 + t49 * t56);
        let t85 = -t82;
        [t63, t83, t84, t85, t56]
    }

    fn energy_unchecked(&self, positions: &[T; 5], speeds: &[T; 3]) -> [T; 2] {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t4 = sin_phi * self.constants[6];
        let t11 = sin_phi * self.constants[2];
        let t17 = t4 + t11;
        let t19 = speeds[0]
            * (sin_phi * t4 + self.constants[1] * cos_phi * cos_phi + sin_phi * t11)
            + speeds[2] * t17;
        let t33 = (speeds[0] * t19 + speeds[1] * speeds[1] * self.constants[7]
            + speeds[2] * (speeds[0] * t17 + speeds[2] * self.constants[8]))
            * self.constants[0].like(0.5);
        let t37 = cos_phi * self.constants[4] * self.constants[5];
        [t33, t37]
    }

    fn contact_forces_unchecked(&self, positions: &[T; 5], speeds: &[T; 3], forces: &[T; 0]) -> [[T; 3]; 1] {
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t6 = speeds[0] * cos_phi;
        let t9 = self.constants[0] * speeds[1];
        let t10 = t6 * t9;
        let t11 = t6 * speeds[1];
        let t16 = self.constants[3] * self.constants[0];
        let t18 = t11 * self.constants[2] + (t10 + self.constants[0] * t11) * t16;
        let t21 = speeds[1] * self.constants[1];
        let t23 = t6 * self.constants[1];
        let t28 = speeds[0] * sin_phi;
        let t29 = t21 * t28;
        let t31 = t28 + speeds[2];
        let t32 = self.constants[2] * t31;
        let t37 = sin_phi * (t6 * t21 + t18 - speeds[1] * t23)
            + cos_phi * (speeds[1] * t32 - t29 - t29);
        let t39 = sin_phi * self.constants[6];
        let t40 = sin_phi * self.constants[2];
        let t47 = sin_phi * t39 + cos_phi * cos_phi * self.constants[1] + sin_phi * t40;
        let t48 = self.constants[0].like(1.0) / t47;
        let t49 = (t39 + t40) * t48;
        let t56 = (t37 * t49 - t18) / (self.constants[8] - t47 * t49 * t49);
        let t64 = t10
            + self.constants[0] * (t11 + t56 - sin_phi * (t37 * t48 + t49 * t56));
        let t65 = self.constants[3] * t64;
        let t68 = self.constants[0] * t28;
        let t72 = t6 * t68 + sin_phi * self.constants[4];
        let t73 = t6 * speeds[2];
        let t83 = t73
            + (t23 * t28 - t6 * t32 - t16 * (self.constants[0] * t73 + t72))
                / self.constants[7];
        let t86 = self.constants[3] * (t72 + self.constants[0] * t83);
        let t93 = self.constants[3]
            * (speeds[1] * t9 + t31 * t68 - cos_phi * self.constants[4]);
        let t95 = cos_phi * t86 + sin_phi * t93;
        let t97 = sin_psi * t95 - cos_psi * t65;
        let t103 = cos_phi * t93 - sin_phi * t86;
        let t104 = -(t65 * sin_psi + cos_psi * t95);
        [[t97, t104, t103]]
    }
}

#[allow(unused_variables)]
impl<T: Scalar> carvallo::motion::UncheckedPartials for RollingDiscMotion<T> {
    type State = [T; 8];

    type ByState = [[T; 8]; 8];

    type ByForces = [[T; 0]; 8];

    type Parameters = [T; 5];

    type ByParameters = [[T; 5]; 8];

    fn linearize_unchecked(&self, positions: &[T; 5], speeds: &[T; 3], forces: &[T; 0]) -> ([[T; 8]; 8], [[T; 0]; 8]) {
        let zero = self.constants[0].like(0.0);
        let t3 = self.constants[0] * speeds[2];
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let t6 = t3 * sin_psi;
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t15 = sin_phi * self.constants[6];
        let t19 = cos_phi * self.constants[1];
        let t22 = sin_phi * self.constants[2];
        let t25 = sin_phi * t15 + cos_phi * t19 + sin_phi * t22;
        let t26 = self.constants[0].like(1.0) / t25;
        let t29 = sin_phi * speeds[0];
        let t31 = self.constants[2] * (speeds[2] + t29);
        let t33 = self.constants[1] * speeds[1];
        let t35 = speeds[1] * t31 - t29 * t33;
        let t36 = speeds[1] * t29;
        let t37 = cos_phi * speeds[0];
        let t39 = self.constants[1] * t37;
        let t41 = t33 * t37 - speeds[1] * t39;
        let t42 = speeds[1] * t37;
        let t45 = self.constants[0] * speeds[1];
        let t46 = t37 * t45;
        let t49 = self.constants[0] * self.constants[3];
        let t51 = self.constants[2] * t42 + (self.constants[0] * t42 + t46) * t49;
        let t57 = sin_phi * (t41 + t51) + cos_phi * (t35 - self.constants[1] * t36);
        let t60 = t26 * (t15 + t22);
        let t67 = self.constants[0].like(1.0) / (self.constants[8] - t25 * t60 * t60);
        let t68 = (t57 * t60 - t51) * t67;
        let t70 = t26 * t57 + t60 * t68;
        let t72 = t36 + cos_phi * t70;
        let t76 = sin_phi * t70;
        let t79 = t42 + t68 - t76;
        let t89 = cos_phi * speeds[1];
        let t90 = self.constants[2] * t89;
        let t92 = t90 - cos_phi * t33 - t19 * speeds[1];
        let t95 = sin_phi * self.constants[5];
        let t96 = t29 * t45;
        let t99 = t22 + self.constants[0] * t95;
        let t103 = sin_phi * (t35 - self.constants[1] * t72) + t95 * t96 + t72 * t99
            - t19 * t76;
        let t104 = t103
            - cos_phi
                * (t41 + self.constants[2] * t79
                    + t49 * (t46 + self.constants[0] * t79));
        let t105 = t104 - t37 * t92;
        let t108 = self.constants[6] + self.constants[2];
        let t113 = t67 * (self.constants[5] * t96 + t72 * t108 - t60 * t105);
        let t115 = t26 * t105 - t60 * t113;
        let t117 = cos_phi * t45;
        let t121 = sin_phi * t92 + t95 * t117 + t89 * t99;
        let t128 = t67 * (t60 * t121 - self.constants[5] * t117 - t89 * t108);
        let t132 = self.constants[1] * t29 - t31;
        let t135 = self.constants[0] * t37;
        let t140 = t95 * t135 + t37 * t99 - cos_phi * t132 - t19 * t29;
        let t142 = self.constants[5] * t135;
        let t147 = t67 * (t60 * t140 - t142 - t37 * t108);
        let t152 = t60 * t67 * t90;
        let t159 = t142 + self.constants[2] * t37;
        let t160 = t39 - t159;
        let t165 = t132 - self.constants[5] * (t3 + self.constants[0] * t29);
        let t170 = self.constants[0].like(1.0) / self.constants[7];
        let t171 = (cos_phi * self.constants[5] * self.constants[4] + t29 * t165
            - t37 * t160) * t170;
        let t176 = t159 * t170;
        let t177 = -(self.constants[0] * cos_psi);
        let t178 = -(t3 * cos_psi);
        let t179 = -(self.constants[0] * sin_psi);
        let t180 = -(t26 * t121 + t60 * t128);
        let t181 = -(t26 * t140 + t60 * t147);
        let t182 = -(t26 * t90 + t60 * t152);
        let t183 = -(t170 * (sin_phi * t160 + cos_phi * t165));
        (
            [
                [zero, zero, t6, zero, zero, zero, zero, t177],
                [zero, zero, t178, zero, zero, zero, zero, t179],
                [zero, zero, zero, zero, zero, self.constants[0].like(1.0), zero, zero],
                [zero, zero, zero, zero, zero, zero, self.constants[0].like(1.0), zero],
                [zero, zero, zero, zero, zero, zero, zero, self.constants[0].like(1.0)],
                [zero, zero, zero, t115, zero, t180, t181, t182],
                [zero, zero, zero, t171, zero, t183, zero, t176],
                [zero, zero, zero, t113, zero, t128, t147, t152],
            ],
            [[], [], [], [], [], [], [], []],
        )
    }

    fn by_parameters_unchecked(&self, positions: &[T; 5], speeds: &[T; 3], forces: &[T; 0]) -> [[T; 5]; 8] {
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let zero = self.constants[0].like(0.0);
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t10 = sin_phi * self.constants[6];
        let t17 = sin_phi * self.constants[2];
        let t20 = sin_phi * t10 + self.constants[1] * cos_phi * cos_phi + sin_phi * t17;
        let t21 = self.constants[0].like(1.0) / t20;
        let t26 = cos_phi * speeds[0];
        let t27 = self.constants[0] * t26;
        let t28 = speeds[1] * t27;
        let t29 = speeds[1] * t26;
        let t33 = self.constants[3] * self.constants[0];
        let t35 = self.constants[2] * t29 + (t28 + self.constants[0] * t29) * t33;
        let t36 = self.constants[1] * speeds[1];
        let t38 = self.constants[1] * t26;
        let t43 = sin_phi * speeds[0];
        let t44 = speeds[1] * t43;
        let t46 = speeds[2] + t43;
        let t47 = self.constants[2] * t46;
        let t53 = sin_phi * (t26 * t36 + t35 - speeds[1] * t38)
            + cos_phi * (speeds[1] * t47 - self.constants[1] * t44 - t36 * t43);
        let t55 = t21 * (t10 + t17);
        let t62 = self.constants[0].like(1.0) / (self.constants[8] - t20 * t55 * t55);
        let t63 = (t53 * t55 - t35) * t62;
        let t66 = t21 * t53 + t55 * t63;
        let t69 = t29 + t63 - sin_phi * t66;
        let t71 = t28 + self.constants[0] * t69;
        let t75 = self.constants[3] * t71 + t33 * (t29 + t69);
        let t76 = sin_phi * t75;
        let t80 = t62 * (t55 * t76 - t75);
        let t83 = self.constants[0] * t71;
        let t84 = sin_phi * t83;
        let t88 = t62 * (t55 * t84 - t83);
        let t94 = cos_phi * speeds[1] * t46 + sin_phi * t69;
        let t98 = t62 * (t55 * t94 - t69);
        let t104 = cos_phi * (t44 + t44 + cos_phi * t66);
        let t107 = t55 * t62 * t104;
        let t109 = t21 * t104 + t55 * t107;
        let t111 = self.constants[0].like(1.0) / self.constants[7];
        let t115 = t27 * t43 + sin_phi * self.constants[4];
        let t116 = speeds[2] * t26;
        let t124 = t111
            * (t38 * t43 - t26 * t47 - t33 * (self.constants[0] * t116 + t115));
        let t125 = t116 + t124;
        let t127 = t115 + self.constants[0] * t125;
        let t129 = t26 * t43;
        let t133 = t111 * (self.constants[3] * t127 + t33 * (t125 + t129));
        let t135 = self.constants[0] * t111 * t127;
        let t137 = t26 * t46 * t111;
        let t141 = sin_phi * t33 * t111;
        let t142 = -(speeds[2] * cos_psi);
        let t143 = -(speeds[2] * sin_psi);
        let t144 = -(t21 * t76 + t55 * t80);
        let t145 = -(t21 * t84 + t55 * t88);
        let t146 = -(t21 * t94 + t55 * t98);
        let t147 = -(t111 * (t129 - t124));
        let t148 = -t107;
        [
            [t142, zero, zero, zero, zero], [t143, zero, zero, zero, zero],
            [zero, zero, zero, zero, zero], [zero, zero, zero, zero, zero],
            [zero, zero, zero, zero, zero], [t144, t145, t146, t109, zero],
            [t133, t135, t137, t147, t141], [t80, t88, t98, t148, zero],
        ]
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`RollingDisc`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingDiscDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 8],
}

impl<T: Number> RollingDisc<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 4 additions, 5 multiplications, 1 division and 2 negations: 12 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (RollingDiscMatrices<T>, RollingDiscDerivatives<T>) {
        let zero = self.r.like(0.0);
        let mut matrices = RollingDiscMatrices::from_entries([zero; 12]);
        let mut derivatives = RollingDiscDerivatives {
            values: [zero; 8],
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
        matrices: &mut RollingDiscMatrices<T>,
        derivatives: &mut RollingDiscDerivatives<T>,
    ) {
        *matrices = RollingDiscMatrices::from_entries([self.r.like(0.0); 12]);
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
        put_entry(1, self.It);
        put_derivative(0, self.r);
        put_derivative(1, self.m);
        put_derivative(2, self.r.like(1.0));
        let t6 = self.r * self.m;
        let Jxx_all = self.It + self.r * t6;
        put_entry(0, Jxx_all);
        let C1_12_Ia = self.r.like(1.0) / self.r;
        put_derivative(3, C1_12_Ia);
        let M_11_r = t6 + t6;
        put_derivative(4, M_11_r);
        let M_11_m = self.r * self.r;
        put_derivative(5, M_11_m);
        let K0_11 = -t6;
        put_entry(4, K0_11);
        let h_spin_D = self.Ia * C1_12_Ia;
        let C1_12 = t6 + h_spin_D;
        put_entry(2, C1_12);
        let C1_21_r = C1_12_Ia * h_spin_D;
        put_derivative(6, C1_21_r);
        let C1_21 = -h_spin_D;
        put_entry(3, C1_21);
        let C1_12_r = self.m - C1_21_r;
        put_derivative(7, C1_12_r);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl RollingDisc<f64> {
    /// The parameter set `uniform`.
    ///
    /// Source: A uniform disc of 1 kg: Ia = m r^2/2, It = m r^2/4
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `r` | 0.3 | `m` |
    /// | `m` | 1 | `kg` |
    /// | `Ia` | 0.045 | `kg*m^2` |
    /// | `It` | 0.0225 | `kg*m^2` |
    /// | `g` | 9.81 | `N/kg` |
    pub const UNIFORM: Self = Self {
        r: 0.3, m: 1.0, Ia: 0.045, It: 0.0225, g: 9.81,
    };

    /// The parameter set `hoop`.
    ///
    /// Source: A hoop of 1 kg: Ia = m r^2, It = m r^2/2
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `r` | 0.3 | `m` |
    /// | `m` | 1 | `kg` |
    /// | `Ia` | 0.09 | `kg*m^2` |
    /// | `It` | 0.045 | `kg*m^2` |
    /// | `g` | 9.81 | `N/kg` |
    pub const HOOP: Self = Self {
        r: 0.3, m: 1.0, Ia: 0.09, It: 0.045, g: 9.81,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> RollingDisc<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 5]) -> Self {
        Self {
            r: values[0], m: values[1], Ia: values[2], It: values[3], g: values[4],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 5] {
        [self.r, self.m, self.Ia, self.It, self.g]
    }
}

impl<T: Scalar> RollingDisc<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> RollingDisc<U> {
        let values = self.to_array();
        RollingDisc::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl RollingDisc<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> RollingDisc<f32> {
        RollingDisc::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<RollingDisc<f32>> for RollingDisc<f64> {
    fn from(parameters: RollingDisc<f32>) -> Self {
        RollingDisc::cast(&parameters)
    }
}

impl<T: Number> RollingDiscMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 12]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c1: carvallo::rows(&entries, 4),
            k0: carvallo::rows(&entries, 8),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 5] {
        [self.m[0][0], self.m[1][1], self.c1[0][1], self.c1[1][0], self.k0[0][0]]
    }

    /// Sets the entry at a position among those that differ, wherever it stands.
    #[inline(always)]
    fn set_entry(&mut self, position: usize, entry: T) {
        match position {
            0 => {
                self.m[0][0] = entry;
            }
            1 => {
                self.m[1][1] = entry;
            }
            2 => {
                self.c1[0][1] = entry;
            }
            3 => {
                self.c1[1][0] = entry;
            }
            4 => {
                self.k0[0][0] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, zeros, self.c1.0, zeros, self.k0.0, zeros, zeros]
    }
}

impl<T: Scalar> From<RollingDiscMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: RollingDiscMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for RollingDisc<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 5];

    type Over<U: Number> = RollingDisc<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "RollingDisc",
        docs: "A disc that rolls without slip on level ground, upright and straight but for small lean and yaw.\n\nIts spin balances it: it falls over, slowly, unless v^2 > g r It m r^2/(Ia (Ia + m r^2)), which is g r/3 for a\nuniform disc and g r/4 for a hoop. Axes: origin at the contact point, x forward, y to the right, z down.",
        source: "Mechanism: Neimark & Fufaev (1972), Dynamics of Nonholonomic Systems",
        parameters: &[
            ParameterInfo::new("r", "m", Domain::POSITIVE).docs("Radius."),
            ParameterInfo::new("m", "kg", Domain::POSITIVE).docs("Mass."),
            ParameterInfo::new("Ia", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Axial moment of inertia, about the axle."),
            ParameterInfo::new("It", "kg*m^2", Domain::POSITIVE)
                .docs("Transverse moment of inertia, about a diameter."),
            ParameterInfo::new("g", "N/kg", Domain::NONNEGATIVE)
                .docs("Gravitational field strength."),
        ],
        coordinates: &[
            CoordinateInfo::new("phi", "rad")
                .label("lean")
                .docs("Lean, positive to the right."),
            CoordinateInfo::new("psi", "rad")
                .label("yaw")
                .docs("Yaw, positive to the right."),
        ],
        forces: &[],
        matrices: &[MatrixName::M, MatrixName::C1, MatrixName::K0],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]), EntryInfo::at(&[(MatrixName::M, 1, 1)]),
            EntryInfo::at(&[(MatrixName::C1, 0, 1)]), EntryInfo::at(&[(MatrixName::C1, 1, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 0)]),
        ],
        sets: &[
            SetInfo {
                name: "uniform",
                docs: "",
                source: "A uniform disc of 1 kg: Ia = m r^2/2, It = m r^2/4",
                values: &RollingDisc::to_array(&RollingDisc::<f64>::UNIFORM),
            },
            SetInfo {
                name: "hoop",
                docs: "",
                source: "A hoop of 1 kg: Ia = m r^2, It = m r^2/2",
                values: &RollingDisc::to_array(&RollingDisc::<f64>::HOOP),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("Jxx_all", "kg*m^2", "It + r^2*m"),
            FormulaInfo::definition("Sz_all", "kg*m", "-r*m"),
            FormulaInfo::definition("h_spin_D", "kg*m", "Ia/r"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "Jxx_all"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "It"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 1)], "kg*m", "h_spin_D - Sz_all"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 0)], "kg*m", "-h_spin_D"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "Sz_all"),
        ],
        attributes: &[
            FormulaInfo::attribute("D_mass", "the mass of the disc D", "kg", "m"),
            FormulaInfo::attribute("D_radius", "the radius of the disc D", "m", "r"),
            FormulaInfo::attribute("D_axial", "the axial inertia of the disc D", "kg*m^2", "Ia"),
            FormulaInfo::attribute("D_radial", "the radial inertia of the disc D", "kg*m^2", "It"),
            FormulaInfo::attribute("D_z", "z of the centre of the disc D", "m", "-r"),
            FormulaInfo::definition("lateral_by_phi", "m", "D_radius + D_z"),
            FormulaInfo::definition("Jxx_all", "kg*m^2", "D_mass*D_z^2 + D_radial"),
            FormulaInfo::definition("Sz_all", "kg*m", "D_mass*D_z"),
            FormulaInfo::definition("h_spin_D", "kg*m", "D_axial/D_radius"),
            FormulaInfo::definition("K_phi_phi", "kg*m", "Sz_all - D_mass*(D_radius + D_z)"),
            FormulaInfo::definition("P_phi_lateral", "kg*m", "D_mass*lateral_by_phi - Sz_all"),
            FormulaInfo::definition("P_phi_phi", "kg*m^2", "Jxx_all - lateral_by_phi*Sz_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "lateral_by_phi*P_phi_lateral + P_phi_phi"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "D_radial"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 1)], "kg*m", "h_spin_D + P_phi_lateral"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 0)], "kg*m", "-h_spin_D"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "K_phi_phi"),
        ],
        motion: Some(
            &MotionFormulas {
                constants: &[
                    "C5=A0*A1*A1;C6=A3+C5;C7=A2+C5;C0=A3;C1=A2;C2=A0;C3=A1;C4=P4",
                ],
                closure: &[],
                accelerations: &[
                    "T0=C3*U2;T1=cos(Q2);T2=sin(Q2);T3=cos(Q3);T4=U0*T3;T5=U1*T4;T6=C3*T4;T7=C3*C2;T8=C1*T5+(C3*T5+U1*T6)*T7",
                    "T9=sin(Q3);T10=U1*C0;T11=T4*C0;T12=U0*T9;T13=T10*T12;T14=C1*(U2+T12)",
                    "T15=T9*(T4*T10+T8-U1*T11)+T3*(U1*T14-T13-T13);T16=T9*C5;T17=T9*C1;T18=T9*T16+T3^2*C0+T9*T17;T19=1/T18",
                    "T20=(T16+T17)*T19;R9=(T15*T20-T8)/(C7-T18*T20*T20);T21=C3*R9;T22=T0*U0;R5=T2*T22-T1*T21",
                    "T23=(T11*T12-T4*T14-T7*(U2*T6+T6*T12+T9*C4))/C6;R0=-(T0*T1);R1=-(T0*T2);R6=-(T2*T21+T1*T22)",
                    "R7=-(T15*T19+T20*R9);R8=-T23;R2=U0;R3=U1;R4=U2",
                ],
            },
        ),
        gravity: Some(4),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("RollingDisc", 5, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("RollingDisc", 5, values)?;
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
        Coefficients::from_rows(RollingDiscMatrices::rows(&self.matrices()))
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

impl RollingDisc<f64> {
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
impl<T: Scalar> core::fmt::Display for RollingDisc<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for RollingDisc<T> {
    type Entries = [T; 5];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            r: parameter(0), m: parameter(1), Ia: parameter(2), It: parameter(3), g: parameter(4),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        RollingDiscMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        RollingDiscMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> RollingDiscDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<RollingDiscMatrices<T>> {
        if parameter >= 5 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = RollingDiscMatrices {
            m: Rows([[zero; 2]; 2]),
            c1: Rows([[zero; 2]; 2]),
            k0: Rows([[zero; 2]; 2]),
        };
        for position in 0..11 {
            let partial = <RollingDiscDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C1 => &mut matrices.c1,
                MatrixName::K0 => &mut matrices.k0,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<2> for RollingDisc<T> {
    type Derivatives = [Coefficients<T, 2>; 5];

    type WithDerivativesOver<U: Number> = RollingDisc<U>;

    const PARTIALS: &'static [Partial] = <RollingDiscDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 5];
        for position in 0..11 {
            Partial::write(&<RollingDiscDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(RollingDiscMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for RollingDisc<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl RollingDiscDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 11] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 4), Partial::new(MatrixName::C1, 0, 1, 0, 7),
        Partial::new(MatrixName::C1, 1, 0, 0, 6),
        Partial::new(MatrixName::K0, 0, 0, 0, 1).negative(),
        Partial::new(MatrixName::M, 0, 0, 1, 5), Partial::new(MatrixName::C1, 0, 1, 1, 0),
        Partial::new(MatrixName::K0, 0, 0, 1, 0).negative(),
        Partial::new(MatrixName::C1, 0, 1, 2, 3),
        Partial::new(MatrixName::C1, 1, 0, 2, 3).negative(),
        Partial::new(MatrixName::M, 0, 0, 3, 2), Partial::new(MatrixName::M, 1, 1, 3, 2),
    ];
}
