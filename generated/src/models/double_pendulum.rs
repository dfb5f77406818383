// @generated from generated/models/double_pendulum.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 159450b9b3aa9cf1

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    MotionFormulas, Nonlinear, Number, ParameterError, ParameterInfo, Partial, Rows,
    Scalar, SetInfo, WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// An inverted double pendulum: two links, one standing on the other, which lean to the right about axes along x.
///
/// Axes: origin at the lower hinge, x forward, y to the right, z down, so that what is above it has z < 0. The second
/// angle is that between the links.
///
/// Source: Mechanism: Kibble & Berkshire (2004), Classical Mechanics, section 11.3, turned upside down
///
/// Derived from a mechanism: body `lower`, body `upper`.
///
/// The fields are the parameters. The coordinates are `theta1` (lower link) in `rad`, `theta2` (upper link) in `rad`.
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
/// Jxx_theta2 = I2 + a2^2*m2 [kg*m^2]
/// Sz_theta2 = -a2*m2 [kg*m]
/// Jxx_theta1 = I1 + Jxx_theta2 + a1^2*m1 - 2*l1*(Sz_theta2 - (1/2)*l1*m2) [kg*m^2]
/// Sz_theta1 = Sz_theta2 - l1*m2 - a1*m1 [kg*m]
/// M_theta1_theta2 = Jxx_theta2 - l1*Sz_theta2 [kg*m^2]
/// M_11 = Jxx_theta1 [kg*m^2]
/// M_12 = M_21 = M_theta1_theta2 [kg*m^2]
/// M_22 = Jxx_theta2 [kg*m^2]
/// K0_11 = Sz_theta1 [kg*m]
/// K0_12 = K0_21 = K0_22 = Sz_theta2 [kg*m]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct DoublePendulum<T = f64> {
    /// Length of the lower link, from hinge to hinge.
    ///
    /// `l1` in `m`: `> 0`.
    pub l1: T,
    /// Centre of mass of the lower link, above its hinge.
    ///
    /// `a1` in `m`: any finite value.
    pub a1: T,
    /// Mass of the lower link.
    ///
    /// `m1` in `kg`: `>= 0`.
    pub m1: T,
    /// Moment of inertia of the lower link about its centre of mass.
    ///
    /// `I1` in `kg*m^2`: `>= 0`.
    pub I1: T,
    /// Centre of mass of the upper link, above its hinge.
    ///
    /// `a2` in `m`: any finite value.
    pub a2: T,
    /// Mass of the upper link.
    ///
    /// `m2` in `kg`: `>= 0`.
    pub m2: T,
    /// Moment of inertia of the upper link about its centre of mass.
    ///
    /// `I2` in `kg*m^2`: `>= 0`.
    pub I2: T,
    /// Gravitational field strength.
    ///
    /// `g` in `N/kg`: `>= 0`.
    pub g: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`DoublePendulum`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoublePendulumMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
}

impl<T: Number> DoublePendulum<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 7 additions, 7 multiplications and 2 negations: 16 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> DoublePendulumMatrices<T> {
        let t5 = self.a1 * self.m1;
        let t9 = self.a2 + self.l1;
        let t11 = self.m2 * t9;
        let Jxx_theta1 = self.I1 + self.I2 + (self.a1 * t5 + t9 * t11);
        let t15 = self.a2 * self.m2;
        let Jxx_theta2 = self.I2 + self.a2 * t15;
        let M_theta1_theta2 = Jxx_theta2 + t15 * self.l1;
        let K0_11 = -(t5 + t11);
        let K0_12 = -t15;
        DoublePendulumMatrices::from_entries([
            Jxx_theta1, M_theta1_theta2, M_theta1_theta2, Jxx_theta2, K0_11, K0_12, K0_12, K0_12,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`DoublePendulum`] that follow from its coordinates q = (`theta1`, `theta2`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoublePendulumKinematics<T = f64> {
    /// The forces f on the coordinates that applied forces make: a row for each coordinate,
    /// a column for each of `T1` (torque at the lower hinge) in `N*m`, `T2` (torque between the links) in `N*m`.
    pub forces: [[T; 2]; 2],
}

impl<T: Scalar> DoublePendulum<T> {
    /// Rates and forces that follow from the coordinates:
    /// no operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> DoublePendulumKinematics<T> {
        let zero = self.l1.like(0.0);
        DoublePendulumKinematics {
            forces: [[self.l1.like(1.0), zero], [zero, self.l1.like(1.0)]],
        }
    }
}

// --- The nonlinear equations of motion -----------------------------------------------------------

/// The nonlinear equations of motion of [`DoublePendulum`], with its parameters: what does not depend on the state is computed.
///
/// Positions: `theta1` (lower link) in `rad`, `theta2` (upper link) in `rad`.
/// Speeds: the rates of `theta1`, `theta2`.
///
/// Each from one straight-line program:
/// - closure: no operations
/// - rates: no operations
/// - derivatives: 17 additions, 25 multiplications, 2 divisions and 4 trigonometric functions: 48 operations
/// - accelerations: 17 additions, 25 multiplications, 2 divisions and 4 trigonometric functions: 48 operations
/// - energy: 10 additions, 13 multiplications, 1 negation and 4 trigonometric functions: 28 operations
/// - contact forces: no operations
/// - linearization: 43 additions, 71 multiplications, 2 divisions, 3 negations and 4 trigonometric functions: 123 operations
/// - by parameters: 58 additions, 97 multiplications, 2 divisions, 6 negations and 4 trigonometric functions: 167 operations
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoublePendulumMotion<T = f64> {
    constants: [T; 12],
}

impl<T: Number> DoublePendulum<T> {
    /// The nonlinear equations of motion, of what is computed once for these parameters:
    /// 4 additions and 6 multiplications: 10 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn motion(&self) -> DoublePendulumMotion<T> {
        let t5 = self.m1 * self.a1;
        let t8 = self.I1 + self.a1 * t5;
        let t10 = self.l1 - self.l1 - self.a2;
        let t11 = self.m2 * t10;
        let t14 = self.I2 + t10 * t11;
        let t16 = self.l1 * self.m2;
        let t17 = self.l1 * t16;
        DoublePendulumMotion {
            constants: [
                self.l1, self.m1, self.a1, self.m2, self.a2, t5, t8, t11, t14, self.g, t16, t17,
            ],
        }
    }
}

impl<T: Scalar> Nonlinear<2> for DoublePendulum<T> {
    type Motion = DoublePendulumMotion<T>;

    type MotionOver<U: Number> = DoublePendulumMotion<U>;

    fn motion(&self) -> DoublePendulumMotion<T> {
        DoublePendulum::motion(self)
    }

    #[inline(always)]
    fn motion_over<U: Number>(model: &DoublePendulum<U>) -> DoublePendulumMotion<U> {
        DoublePendulum::motion(model)
    }
}

impl<T: Scalar> carvallo::motion::Motion for DoublePendulumMotion<T> {
    const INFO: &'static carvallo::motion::MotionInfo = &carvallo::motion::MotionInfo {
        model: "DoublePendulum",
        positions: &[
            carvallo::motion::PositionInfo {
                name: "theta1",
                label: "lower link",
                unit: "rad",
                kind: carvallo::motion::PositionKind::Free,
            },
            carvallo::motion::PositionInfo {
                name: "theta2",
                label: "upper link",
                unit: "rad",
                kind: carvallo::motion::PositionKind::Free,
            },
        ],
        speeds: &[0, 1],
        dependent: &[],
        forces: &[
            carvallo::motion::AppliedInfo {
                name: "T1", label: "torque at the lower hinge", unit: "N*m", position: "theta1",
            },
            carvallo::motion::AppliedInfo {
                name: "T2", label: "torque between the links", unit: "N*m", position: "theta2",
            },
        ],
        wheels: &[],
    };

    fn linearize_into(
        &self, positions: &[T; 2], speeds: &[T; 2], forces: &[T; 2], a: &mut [T], b: &mut [T],
    ) -> Option<Result<(), carvallo::motion::MotionError>> {
        let found = carvallo::motion::Linearizable::linearize(self, positions, speeds, forces);
        Some(found.map(|found| carvallo::motion::Linearization::copy_into(&found, a, b)))
    }
}

#[allow(unused_variables)]
impl<T: Number> carvallo::motion::Unchecked for DoublePendulumMotion<T> {
    type Scalar = T;

    type Positions = [T; 2];

    type Speeds = [T; 2];

    type Dependent = [T; 0];

    type Forces = [T; 2];

    type ContactForces = [[T; 3]; 0];

    #[inline(always)]
    fn closure_unchecked(&self, positions: &[T; 2]) -> ([T; 0], [T; 0]) {
        ([], [])
    }

    #[inline(always)]
    fn rates_unchecked(&self, positions: &[T; 2], speeds: &[T; 2]) -> [T; 2] {
        [speeds[0], speeds[1]]
    }

    #[inline(always)]
    fn derivatives_unchecked(&self, positions: &[T; 2], speeds: &[T; 2], forces: &[T; 2]) -> ([T; 2], [T; 2]) {
        let (sin_theta1, cos_theta1) = positions[0].sin_cos();
        let t7 = sin_theta1 * self.constants[9];
        let (sin_theta2, cos_theta2) = positions[1].sin_cos();
        let t19 = speeds[0] * speeds[0] * self.constants[0]
            - self.constants[9] * cos_theta1;
        let t21 = sin_theta2 * t19 - t7 * cos_theta2;
        let t22 = self.constants[7] * t21;
        let t30 = speeds[0] + speeds[1];
        let t35 = cos_theta2 * t21 * self.constants[3]
            - sin_theta2
                * (self.constants[3] * (cos_theta2 * t19 + t7 * sin_theta2)
                    - self.constants[7] * t30 * t30);
        let t39 = forces[0] + self.constants[5] * t7 + t22 - self.constants[0] * t35;
        let t42 = self.constants[7] * cos_theta2 * self.constants[0];
        let t45 = self.constants[8] - t42;
        let t48 = self.constants[6] + self.constants[11] + t45 - t42;
        let t49 = self.constants[0].like(1.0) / t48;
        let t51 = t45 * t49;
        let t59 = (t22 + forces[1] - t39 * t51) / (self.constants[8] - t48 * t51 * t51);
        let t61 = t39 * t49 - t51 * t59;
        ([speeds[0], speeds[1]], [t61, t59])
    }

    #[inline(always)]
    fn accelerations_unchecked(&self, positions: &[T; 2], speeds: &[T; 2], forces: &[T; 2]) -> [T; 2] {
        let (sin_theta1, cos_theta1) = positions[0].sin_cos();
        let t5 = sin_theta1 * self.constants[9];
        let (sin_theta2, cos_theta2) = positions[1].sin_cos();
        let t18 = self.constants[0] * speeds[0] * speeds[0]
            - self.constants[9] * cos_theta1;
        let t20 = sin_theta2 * t18 - t5 * cos_theta2;
        let t21 = self.constants[7] * t20;
        let t30 = speeds[0] + speeds[1];
        let t35 = cos_theta2 * t20 * self.constants[3]
            - sin_theta2
                * (self.constants[3] * (cos_theta2 * t18 + t5 * sin_theta2)
                    - self.constants[7] * t30 * t30);
        let t39 = forces[0] + self.constants[5] * t5 + t21 - self.constants[0] * t35;
        let t42 = self.constants[7] * cos_theta2 * self.constants[0];
        let t45 = self.constants[8] - t42;
        let t48 = self.constants[6] + self.constants[11] + t45 - t42;
        let t49 = self.constants[0].like(1.0) / t48;
        let t51 = t45 * t49;
        let t59 = (t21 + forces[1] - t39 * t51) / (self.constants[8] - t48 * t51 * t51);
        let t61 = t39 * t49 - t51 * t59;
        [t61, t59]
    }

    fn energy_unchecked(&self, positions: &[T; 2], speeds: &[T; 2]) -> [T; 2] {
        let (sin_theta2, cos_theta2) = positions[1].sin_cos();
        let t6 = cos_theta2 * self.constants[7];
        let t7 = self.constants[0] * t6;
        let t10 = self.constants[8] - t7;
        let t18 = speeds[0]
            * (speeds[0] * (self.constants[6] + self.constants[11] + t10 - t7)
                + t10 * speeds[1]);
        let t25 = (t18 + speeds[1] * (speeds[0] * t10 + self.constants[8] * speeds[1]))
            * self.constants[0].like(0.5);
        let (sin_theta1, cos_theta1) = positions[0].sin_cos();
        let t40 = -(self.constants[9]
            * (cos_theta1 * (t6 - self.constants[5] - self.constants[10])
                - self.constants[7] * sin_theta1 * sin_theta2));
        [t25, t40]
    }

    fn contact_forces_unchecked(&self, positions: &[T; 2], speeds: &[T; 2], forces: &[T; 2]) -> [[T; 3]; 0] {
        []
    }
}

#[allow(unused_variables)]
impl<T: Scalar> carvallo::motion::UncheckedPartials for DoublePendulumMotion<T> {
    type State = [T; 4];

    type ByState = [[T; 4]; 4];

    type ByForces = [[T; 2]; 4];

    type Parameters = [T; 8];

    type ByParameters = [[T; 8]; 4];

    fn linearize_unchecked(&self, positions: &[T; 2], speeds: &[T; 2], forces: &[T; 2]) -> ([[T; 4]; 4], [[T; 2]; 4]) {
        let zero = self.constants[0].like(0.0);
        let (sin_theta2, cos_theta2) = positions[1].sin_cos();
        let t8 = self.constants[0] * cos_theta2 * self.constants[7];
        let t11 = self.constants[8] - t8;
        let t14 = self.constants[6] + self.constants[11] + t11 - t8;
        let t15 = self.constants[0].like(1.0) / t14;
        let (sin_theta1, cos_theta1) = positions[0].sin_cos();
        let t20 = cos_theta1 * self.constants[9];
        let t23 = self.constants[0] * sin_theta2;
        let t28 = self.constants[9] * sin_theta1;
        let t29 = cos_theta2 * self.constants[3];
        let t34 = self.constants[0] * t29 - self.constants[7];
        let t35 = sin_theta2 * t28;
        let t37 = t35 - cos_theta2 * t20;
        let t40 = self.constants[5] * t20
            + t23 * (t20 * sin_theta2 * self.constants[3] + t28 * t29) - t34 * t37;
        let t42 = t11 * t15;
        let t46 = self.constants[0].like(1.0) / (self.constants[8] - t14 * t42 * t42);
        let t50 = t46 * (self.constants[7] * t37 - t40 * t42);
        let t52 = t15 * t40 - t42 * t50;
        let t54 = self.constants[0] * speeds[0];
        let t56 = speeds[0] * t54 - t20;
        let t57 = sin_theta2 * t56;
        let t61 = t57 - cos_theta2 * t28;
        let t62 = self.constants[7] * t61;
        let t64 = cos_theta2 * t56;
        let t68 = speeds[0] + speeds[1];
        let t69 = self.constants[7] * t68;
        let t70 = t68 * t69;
        let t74 = self.constants[0]
            * (t29 * t61 - sin_theta2 * (self.constants[3] * (t35 + t64) - t70));
        let t77 = forces[0] + self.constants[5] * t28 + t62 - t74;
        let t83 = t46 * (t62 + forces[1] - t42 * t77);
        let t85 = t15 * t77 - t42 * t83;
        let t87 = self.constants[0] * t85 - t28;
        let t90 = self.constants[3] * (t57 + cos_theta2 * t87);
        let t96 = t64 - sin_theta2 * t87;
        let t101 = self.constants[0]
            * (sin_theta2 * (t90 - self.constants[7] * (t83 + t85))
                + cos_theta2 * (self.constants[3] * t96 - t70));
        let t105 = t23 * t90 + t34 * t96 - t101;
        let t110 = t46 * (self.constants[7] * t96 + t42 * t105);
        let t113 = t69 + t69;
        let t114 = t54 + t54;
        let t118 = sin_theta2 * t114;
        let t120 = t23 * (t29 * t114 - t113) - t34 * t118;
        let t125 = t46 * (self.constants[7] * t118 - t42 * t120);
        let t127 = t15 * t120 - t42 * t125;
        let t128 = t23 * t113;
        let t130 = t42 * t46;
        let t131 = t128 * t130;
        let t135 = t15 + t42 * t130;
        let t136 = -(t15 * t105 + t42 * t110);
        let t137 = -(t15 * t128 + t42 * t131);
        let t138 = -t130;
        (
            [
                [zero, zero, self.constants[0].like(1.0), zero],
                [zero, zero, zero, self.constants[0].like(1.0)], [t52, t136, t127, t137],
                [t50, t110, t125, t131],
            ],
            [[zero, zero], [zero, zero], [t135, t138], [t138, t46]],
        )
    }

    fn by_parameters_unchecked(&self, positions: &[T; 2], speeds: &[T; 2], forces: &[T; 2]) -> [[T; 8]; 4] {
        let zero = self.constants[0].like(0.0);
        let (sin_theta2, cos_theta2) = positions[1].sin_cos();
        let t7 = self.constants[0] * cos_theta2 * self.constants[7];
        let t10 = self.constants[8] - t7;
        let t13 = self.constants[6] + self.constants[11] + t10 - t7;
        let t14 = self.constants[0].like(1.0) / t13;
        let (sin_theta1, cos_theta1) = positions[0].sin_cos();
        let t22 = speeds[0] * speeds[0];
        let t24 = self.constants[0] * t22 - cos_theta1 * self.constants[9];
        let t25 = sin_theta2 * t24;
        let t27 = self.constants[9] * sin_theta1;
        let t32 = t25 - cos_theta2 * t27;
        let t33 = self.constants[7] * t32;
        let t34 = cos_theta2 * self.constants[3];
        let t36 = cos_theta2 * t24;
        let t41 = speeds[0] + speeds[1];
        let t42 = t41 * t41;
        let t43 = self.constants[7] * t42;
        let t46 = t32 * t34
            - sin_theta2 * (self.constants[3] * (t36 + sin_theta2 * t27) - t43);
        let t50 = forces[0] + t27 * self.constants[5] + t33 - self.constants[0] * t46;
        let t52 = t10 * t14;
        let t60 = self.constants[0].like(1.0) / (self.constants[8] - t13 * t52 * t52);
        let t61 = (t33 + forces[1] - t50 * t52) * t60;
        let t63 = t14 * t50 - t52 * t61;
        let t65 = self.constants[0] * t63 - t27;
        let t67 = t25 + cos_theta2 * t65;
        let t69 = t61 + t63;
        let t70 = self.constants[7] * t69;
        let t74 = t36 - sin_theta2 * t65;
        let t80 = sin_theta2 * t22 + cos_theta2 * t63;
        let t81 = self.constants[7] * t80;
        let t82 = sin_theta2 * t34;
        let t85 = self.constants[3] * sin_theta2 * sin_theta2;
        let t93 = sin_theta2 * (self.constants[3] * t74 - t43) + t81
            - cos_theta2 * (self.constants[3] * t67 - t70)
            - self.constants[0] * (t63 * t85 + t34 * t80 - t22 * t82);
        let t97 = t60 * (t81 - t52 * t93);
        let t99 = t14 * t93 - t52 * t97;
        let t104 = t63 * self.constants[2] - t27;
        let t106 = self.constants[5] * t63 + self.constants[1] * t104;
        let t108 = t52 * t60;
        let t109 = t106 * t108;
        let t112 = self.constants[2] * t104;
        let t114 = t108 * t112;
        let t118 = t63 * t108;
        let t123 = self.constants[0] - self.constants[0] - self.constants[4];
        let t125 = t69 * t123 - t67;
        let t127 = t70 + self.constants[3] * t125;
        let t130 = sin_theta2 * t42 - cos_theta2 * t69;
        let t133 = t127 + self.constants[0] * self.constants[3] * t130;
        let t137 = t60 * (t127 - t52 * t133);
        let t139 = t14 * t133 - t52 * t137;
        let t140 = t123 * t125;
        let t147 = t140
            + self.constants[0] * (cos_theta2 * t67 + t123 * t130 - sin_theta2 * t74);
        let t151 = t60 * (t52 * t147 - t140);
        let t157 = t60 * (t52 * t69 - t69);
        let t163 = sin_theta2 * cos_theta1 + cos_theta2 * sin_theta1;
        let t164 = self.constants[7] * t163;
        let t172 = sin_theta1 * self.constants[5] - t164
            - self.constants[0] * (cos_theta1 * t82 - sin_theta1 * t85 - t34 * t163);
        let t176 = t60 * (t164 + t52 * t172);
        let t178 = t14 * t172 + t52 * t176;
        let t179 = -(t14 * t106 + t52 * t109);
        let t180 = -(t14 * t112 + t52 * t114);
        let t181 = -(t14 * t63 + t52 * t118);
        let t182 = -(t14 * t147 + t52 * t151);
        let t183 = -(t14 * t69 + t52 * t157);
        let t184 = -t176;
        [
            [zero, zero, zero, zero, zero, zero, zero, zero],
            [zero, zero, zero, zero, zero, zero, zero, zero],
            [t99, t179, t180, t181, t139, t182, t183, t178],
            [t97, t109, t114, t118, t137, t151, t157, t184],
        ]
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`DoublePendulum`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoublePendulumDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 15],
}

impl<T: Number> DoublePendulum<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 11 additions, 11 multiplications and 2 negations: 24 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (DoublePendulumMatrices<T>, DoublePendulumDerivatives<T>) {
        let zero = self.l1.like(0.0);
        let mut matrices = DoublePendulumMatrices::from_entries([zero; 8]);
        let mut derivatives = DoublePendulumDerivatives {
            values: [zero; 15],
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
        matrices: &mut DoublePendulumMatrices<T>,
        derivatives: &mut DoublePendulumDerivatives<T>,
    ) {
        *matrices = DoublePendulumMatrices::from_entries([self.l1.like(0.0); 8]);
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
        put_derivative(0, self.a1);
        put_derivative(1, self.m1);
        put_derivative(2, self.a2);
        put_derivative(3, self.m2);
        put_derivative(4, self.l1.like(1.0));
        let t8 = self.a1 * self.m1;
        let t9 = self.l1 + self.a2;
        put_derivative(5, t9);
        let t10 = t9 * self.m2;
        let Jxx_theta1 = self.a1 * t8 + self.I1 + self.I2 + t9 * t10;
        put_entry(0, Jxx_theta1);
        let M_12_l1 = self.a2 * self.m2;
        put_derivative(6, M_12_l1);
        let Jxx_theta2 = self.I2 + self.a2 * M_12_l1;
        put_entry(2, Jxx_theta2);
        let M_11_l1 = t10 + t10;
        put_derivative(7, M_11_l1);
        let M_11_a1 = t8 + t8;
        put_derivative(8, M_11_a1);
        let M_11_m1 = self.a1 * self.a1;
        put_derivative(9, M_11_m1);
        let M_12_a2 = t10 + M_12_l1;
        put_derivative(10, M_12_a2);
        let Jxx_theta2_a2 = M_12_l1 + M_12_l1;
        put_derivative(11, Jxx_theta2_a2);
        let M_theta1_theta2 = Jxx_theta2 + self.l1 * M_12_l1;
        put_entry(1, M_theta1_theta2);
        let M_11_m2 = t9 * t9;
        put_derivative(12, M_11_m2);
        let M_12_m2 = self.a2 * t9;
        put_derivative(13, M_12_m2);
        let Jxx_theta2_m2 = self.a2 * self.a2;
        put_derivative(14, Jxx_theta2_m2);
        let K0_11 = -(t8 + t10);
        put_entry(3, K0_11);
        let K0_12 = -M_12_l1;
        put_entry(4, K0_12);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl DoublePendulum<f64> {
    /// The parameter set `rods`.
    ///
    /// Source: Two slender rods of 1 m and 1 kg
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `l1` | 1 | `m` |
    /// | `a1` | 0.5 | `m` |
    /// | `m1` | 1 | `kg` |
    /// | `I1` | 0.08333333333333333 | `kg*m^2` |
    /// | `a2` | 0.5 | `m` |
    /// | `m2` | 1 | `kg` |
    /// | `I2` | 0.08333333333333333 | `kg*m^2` |
    /// | `g` | 9.81 | `N/kg` |
    pub const RODS: Self = Self {
        l1: 1.0, a1: 0.5, m1: 1.0, I1: 0.08333333333333333, a2: 0.5, m2: 1.0,
        I2: 0.08333333333333333, g: 9.81,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> DoublePendulum<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 8]) -> Self {
        Self {
            l1: values[0], a1: values[1], m1: values[2], I1: values[3], a2: values[4],
            m2: values[5], I2: values[6], g: values[7],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 8] {
        [self.l1, self.a1, self.m1, self.I1, self.a2, self.m2, self.I2, self.g]
    }
}

impl<T: Scalar> DoublePendulum<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> DoublePendulum<U> {
        let values = self.to_array();
        DoublePendulum::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl DoublePendulum<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> DoublePendulum<f32> {
        DoublePendulum::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<DoublePendulum<f32>> for DoublePendulum<f64> {
    fn from(parameters: DoublePendulum<f32>) -> Self {
        DoublePendulum::cast(&parameters)
    }
}

impl<T: Number> DoublePendulumMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 8]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            k0: carvallo::rows(&entries, 4),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 5] {
        [self.m[0][0], self.m[0][1], self.m[1][1], self.k0[0][0], self.k0[0][1]]
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
                self.k0[0][0] = entry;
            }
            4 => {
                self.k0[0][1] = entry;
                self.k0[1][0] = entry;
                self.k0[1][1] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, zeros, zeros, zeros, self.k0.0, zeros, zeros]
    }
}

impl<T: Scalar> From<DoublePendulumMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: DoublePendulumMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for DoublePendulum<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 8];

    type Over<U: Number> = DoublePendulum<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "DoublePendulum",
        docs: "An inverted double pendulum: two links, one standing on the other, which lean to the right about axes along x.\n\nAxes: origin at the lower hinge, x forward, y to the right, z down, so that what is above it has z < 0. The second\nangle is that between the links.",
        source: "Mechanism: Kibble & Berkshire (2004), Classical Mechanics, section 11.3, turned upside down",
        parameters: &[
            ParameterInfo::new("l1", "m", Domain::POSITIVE)
                .docs("Length of the lower link, from hinge to hinge."),
            ParameterInfo::new("a1", "m", Domain::FINITE)
                .docs("Centre of mass of the lower link, above its hinge."),
            ParameterInfo::new("m1", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the lower link."),
            ParameterInfo::new("I1", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the lower link about its centre of mass."),
            ParameterInfo::new("a2", "m", Domain::FINITE)
                .docs("Centre of mass of the upper link, above its hinge."),
            ParameterInfo::new("m2", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the upper link."),
            ParameterInfo::new("I2", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the upper link about its centre of mass."),
            ParameterInfo::new("g", "N/kg", Domain::NONNEGATIVE)
                .docs("Gravitational field strength."),
        ],
        coordinates: &[
            CoordinateInfo::new("theta1", "rad")
                .label("lower link")
                .docs("Lean of the lower link, to the right."),
            CoordinateInfo::new("theta2", "rad")
                .label("upper link")
                .docs("Lean of the upper link relative to the lower one, to the right."),
        ],
        forces: &[
            carvallo::motion::AppliedInfo {
                name: "T1", label: "torque at the lower hinge", unit: "N*m", position: "theta1",
            },
            carvallo::motion::AppliedInfo {
                name: "T2", label: "torque between the links", unit: "N*m", position: "theta2",
            },
        ],
        matrices: &[MatrixName::M, MatrixName::K0],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0), (MatrixName::K0, 1, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "rods",
                docs: "",
                source: "Two slender rods of 1 m and 1 kg",
                values: &DoublePendulum::to_array(&DoublePendulum::<f64>::RODS),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("Jxx_theta2", "kg*m^2", "I2 + a2^2*m2"),
            FormulaInfo::definition("Sz_theta2", "kg*m", "-a2*m2"),
            FormulaInfo::definition(
                "Jxx_theta1",
                "kg*m^2",
                "I1 + Jxx_theta2 + a1^2*m1 - 2*l1*(Sz_theta2 - (1/2)*l1*m2)",
            ),
            FormulaInfo::definition("Sz_theta1", "kg*m", "Sz_theta2 - l1*m2 - a1*m1"),
            FormulaInfo::definition("M_theta1_theta2", "kg*m^2", "Jxx_theta2 - l1*Sz_theta2"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "Jxx_theta1"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)], "kg*m^2", "M_theta1_theta2"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "Jxx_theta2"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "Sz_theta1"),
            FormulaInfo::entry(
                &[
                    (MatrixName::K0, 0, 1),
                    (MatrixName::K0, 1, 0),
                    (MatrixName::K0, 1, 1),
                ],
                "kg*m",
                "Sz_theta2",
            ),
        ],
        attributes: &[
            FormulaInfo::attribute("lower_mass", "the mass of the body lower", "kg", "m1"),
            FormulaInfo::attribute("lower_z", "z of the centre of mass of the body lower", "m", "-a1"),
            FormulaInfo::attribute("lower_Ixx", "the inertia xx of the body lower", "kg*m^2", "I1"),
            FormulaInfo::attribute("upper_mass", "the mass of the body upper", "kg", "m2"),
            FormulaInfo::attribute("upper_z", "z of the centre of mass of the body upper", "m", "-l1 - a2"),
            FormulaInfo::attribute("upper_Ixx", "the inertia xx of the body upper", "kg*m^2", "I2"),
            FormulaInfo::attribute("theta2_through_z", "z of the point of the joint theta2", "m", "-l1"),
            FormulaInfo::definition("Jxx_theta2", "kg*m^2", "upper_mass*(upper_z - theta2_through_z)^2 + upper_Ixx"),
            FormulaInfo::definition("Sz_theta2", "kg*m", "upper_mass*(upper_z - theta2_through_z)"),
            FormulaInfo::definition(
                "Jxx_theta1",
                "kg*m^2",
                "lower_mass*lower_z^2 + lower_Ixx + 2*theta2_through_z*((1/2)*upper_mass*theta2_through_z + Sz_theta2) + Jxx_theta2",
            ),
            FormulaInfo::definition(
                "Sz_theta1",
                "kg*m",
                "lower_mass*lower_z + upper_mass*theta2_through_z + Sz_theta2",
            ),
            FormulaInfo::definition("M_theta1_theta2", "kg*m^2", "theta2_through_z*Sz_theta2 + Jxx_theta2"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "Jxx_theta1"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)], "kg*m^2", "M_theta1_theta2"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "Jxx_theta2"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "Sz_theta1"),
            FormulaInfo::entry(
                &[
                    (MatrixName::K0, 0, 1),
                    (MatrixName::K0, 1, 0),
                    (MatrixName::K0, 1, 1),
                ],
                "kg*m",
                "Sz_theta2",
            ),
        ],
        motion: Some(
            &MotionFormulas {
                constants: &[
                    "C2=A0*A1;C3=A2+A1*C2;T0=A4-A6;C4=A3*T0;C5=A5+T0*C4;C7=A6^2*A3;C0=A6;C1=A3;C6=P7",
                ],
                closure: &[],
                accelerations: &[
                    "T0=sin(Q0);T1=T0*C6;T2=cos(Q1);T3=sin(Q1);T4=cos(Q0);T5=C6*T4+U0^2*C0;T6=T1*T2+T3*T5;T7=C4*T6;T8=U0+U1",
                    "T9=T2*T6*C1+T3*(C1*(T1*T3-T2*T5)-C4*T8*T8);T10=F0-C2*T1-T7-C0*T9;T11=C4*T2*C0;T12=T11+C5;T13=C3+T11+C7+T12",
                    "T14=1/T13;T15=T12*T14;R3=(F1-T7-T10*T15)/(C5-T13*T15*T15);R2=T10*T14-T15*R3;R0=U0;R1=U1",
                ],
            },
        ),
        gravity: Some(7),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("DoublePendulum", 8, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("DoublePendulum", 8, values)?;
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
        Coefficients::from_rows(DoublePendulumMatrices::rows(&self.matrices()))
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

impl DoublePendulum<f64> {
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
impl<T: Scalar> core::fmt::Display for DoublePendulum<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for DoublePendulum<T> {
    type Entries = [T; 5];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            l1: parameter(0), a1: parameter(1), m1: parameter(2), I1: parameter(3),
            a2: parameter(4), m2: parameter(5), I2: parameter(6), g: parameter(7),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        DoublePendulumMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        DoublePendulumMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> DoublePendulumDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<DoublePendulumMatrices<T>> {
        if parameter >= 8 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = DoublePendulumMatrices {
            m: Rows([[zero; 2]; 2]),
            k0: Rows([[zero; 2]; 2]),
        };
        for position in 0..29 {
            let partial = <DoublePendulumDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::K0 => &mut matrices.k0,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<2> for DoublePendulum<T> {
    type Derivatives = [Coefficients<T, 2>; 8];

    type WithDerivativesOver<U: Number> = DoublePendulum<U>;

    const PARTIALS: &'static [Partial] = <DoublePendulumDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 8];
        for position in 0..29 {
            Partial::write(&<DoublePendulumDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(DoublePendulumMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for DoublePendulum<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl DoublePendulumDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 29] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 7), Partial::new(MatrixName::M, 0, 1, 0, 6),
        Partial::new(MatrixName::M, 1, 0, 0, 6),
        Partial::new(MatrixName::K0, 0, 0, 0, 3).negative(),
        Partial::new(MatrixName::M, 0, 0, 1, 8),
        Partial::new(MatrixName::K0, 0, 0, 1, 1).negative(),
        Partial::new(MatrixName::M, 0, 0, 2, 9),
        Partial::new(MatrixName::K0, 0, 0, 2, 0).negative(),
        Partial::new(MatrixName::M, 0, 0, 3, 4), Partial::new(MatrixName::M, 0, 0, 4, 7),
        Partial::new(MatrixName::M, 0, 1, 4, 10), Partial::new(MatrixName::M, 1, 0, 4, 10),
        Partial::new(MatrixName::M, 1, 1, 4, 11),
        Partial::new(MatrixName::K0, 0, 0, 4, 3).negative(),
        Partial::new(MatrixName::K0, 0, 1, 4, 3).negative(),
        Partial::new(MatrixName::K0, 1, 0, 4, 3).negative(),
        Partial::new(MatrixName::K0, 1, 1, 4, 3).negative(),
        Partial::new(MatrixName::M, 0, 0, 5, 12), Partial::new(MatrixName::M, 0, 1, 5, 13),
        Partial::new(MatrixName::M, 1, 0, 5, 13), Partial::new(MatrixName::M, 1, 1, 5, 14),
        Partial::new(MatrixName::K0, 0, 0, 5, 5).negative(),
        Partial::new(MatrixName::K0, 0, 1, 5, 2).negative(),
        Partial::new(MatrixName::K0, 1, 0, 5, 2).negative(),
        Partial::new(MatrixName::K0, 1, 1, 5, 2).negative(),
        Partial::new(MatrixName::M, 0, 0, 6, 4), Partial::new(MatrixName::M, 0, 1, 6, 4),
        Partial::new(MatrixName::M, 1, 0, 6, 4), Partial::new(MatrixName::M, 1, 1, 6, 4),
    ];
}
