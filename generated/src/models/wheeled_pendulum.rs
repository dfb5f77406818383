// @generated from generated/models/wheeled_pendulum.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 16f5399401874b12

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    FormulaInfo, LengthError, MatrixName, Model, ModelInfo, Nonlinear, Number,
    ParameterError, ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo, States,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A pendulum upside down on two wheels, as balancing robots and the Segway are: it stands only where a motor balances it.
///
/// Two wheels on one axle that roll without slip, and a body above it. The motors act between body and wheels; forward
/// motion, pitch and yaw take part. A positive torque, about y, drives a wheel backward and pitches the body forward.
/// Axes: origin on the ground below the axle, x forward, y to the right, z down.
///
/// Source: Mechanism: Grasser, D'Arrigo, Colombi & Rufer (2002), JOE: a mobile, inverted pendulum, IEEE Trans. Ind. Electron. 49, 107-114
///
/// Derived from a mechanism: body `B` (body), wheel `L` (left wheel), wheel `R` (right wheel).
///
/// The fields are the parameters. The coordinates are `x` (forward) in `m`, of which only the rate is a state; `theta` (pitch) in `rad`; `psi` (yaw) in `rad`, of which only the rate is a state.
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
/// spin_L_by_x = -1/r [1/m]
/// spin_L_by_psi = -b/r [1]
/// Jyy_all = m*(l + r)^2 + Iyy + 2*mW*r^2 + 2*Ia [kg*m^2]
/// Jzz_all = Izz + 2*mW*b^2 + 2*Ir [kg*m^2]
/// Sz_all = -m*(l + r) - 2*mW*r [kg*m]
/// m_all = m + 2*mW [kg]
/// K_theta_theta = r*m_all + Sz_all [kg*m]
/// P_x_theta = 2*Ia*spin_L_by_x + Sz_all [kg*m]
/// P_x_spin_L = Ia*spin_L_by_x [kg*m]
/// P_psi_spin_L = Ia*spin_L_by_psi [kg*m^2]
/// M_11 = 2*spin_L_by_x*P_x_spin_L + m_all [kg]
/// M_12 = M_21 = P_x_theta [kg*m]
/// M_22 = Jyy_all [kg*m^2]
/// M_33 = 2*spin_L_by_psi*P_psi_spin_L + Jzz_all [kg*m^2]
/// K0_22 = K_theta_theta [kg*m]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct WheeledPendulum<T = f64> {
    /// Mass of the body.
    ///
    /// `m` in `kg`: `> 0`.
    pub m: T,
    /// Centre of mass of the body, above the axle.
    ///
    /// `l` in `m`: `> 0`.
    pub l: T,
    /// Moment of inertia of the body about its centre of mass, in pitch.
    ///
    /// `Iyy` in `kg*m^2`: `>= 0`.
    pub Iyy: T,
    /// Moment of inertia of the body about its centre of mass, in yaw.
    ///
    /// `Izz` in `kg*m^2`: `>= 0`.
    pub Izz: T,
    /// Mass of each wheel.
    ///
    /// `mW` in `kg`: `>= 0`.
    pub mW: T,
    /// Axial moment of inertia of each wheel.
    ///
    /// `Ia` in `kg*m^2`: `>= 0`.
    pub Ia: T,
    /// Radial moment of inertia of each wheel, about a diameter.
    ///
    /// `Ir` in `kg*m^2`: `>= 0`.
    pub Ir: T,
    /// Radius of the wheels.
    ///
    /// `r` in `m`: `> 0`.
    pub r: T,
    /// Half of the track, from the middle of the axle to a wheel.
    ///
    /// `b` in `m`: `> 0`.
    pub b: T,
    /// Gravitational field strength.
    ///
    /// `g` in `N/kg`: `>= 0`.
    pub g: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`WheeledPendulum`], each 3 x 3 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheeledPendulumMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 3>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 3>,
}

impl<T: Number> WheeledPendulum<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 15 additions, 10 multiplications, 1 division and 1 negation: 27 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WheeledPendulumMatrices<T> {
        let t2 = self.mW + self.mW;
        let m_all = self.m + t2;
        let t5 = self.m.like(1.0) / self.r;
        let t7 = self.Ia + self.Ia;
        let t8 = t5 * t7;
        let t9 = t5 * t8;
        let M_11 = m_all + t9;
        let t11 = t2 * self.r;
        let t13 = self.r + self.l;
        let t14 = self.m * t13;
        let t15 = t11 + t14;
        let zero = self.m.like(0.0);
        let M_22 = t7 + self.Iyy + self.r * t11 + t13 * t14;
        let t26 = self.b * self.b;
        let M_33 = self.Izz + t2 * t26 + t9 * t26 + self.Ir + self.Ir;
        let K0_22 = m_all * self.r - t15;
        let M_12 = -(t8 + t15);
        WheeledPendulumMatrices::from_entries([
            M_11, M_12, zero, M_12, M_22, zero, zero, zero, M_33, zero, zero, zero, zero, K0_22,
            zero, zero, zero, zero,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`WheeledPendulum`] that follow from its coordinates q = (`x`, `theta`, `psi`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheeledPendulumKinematics<T = f64> {
    /// Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin.
    pub lateral: Rate<T, 3>,
    /// Rate, in `rad/s`: of `B`.
    pub lean: Rate<T, 3>,
    /// Spin of the wheel `L`, left wheel: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_L: Rate<T, 3>,
    /// Spin of the wheel `R`, right wheel: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_R: Rate<T, 3>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate,
    /// a column for each of `TL` (torque of the left motor) in `N*m`, `TR` (torque of the right motor) in `N*m`.
    pub forces: [[T; 2]; 3],
}

impl<T: Scalar> WheeledPendulum<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 1 division and 2 negations: 4 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> WheeledPendulumKinematics<T> {
        let zero = self.m.like(0.0);
        let t3 = self.m.like(1.0) / self.r;
        let t5 = t3 * self.b;
        let t6 = -t3;
        let t7 = -t5;
        WheeledPendulumKinematics {
            lateral: Rate {
                speed: zero, rates: [zero, zero, zero], coordinates: [zero, zero, self.m.like(1.0)],
                heading: zero,
            },
            lean: Rate {
                speed: zero, rates: [zero, zero, zero], coordinates: [zero, zero, zero],
                heading: zero,
            },
            wheel_L: Rate {
                speed: t6, rates: [t6, zero, t7], coordinates: [zero, zero, zero], heading: zero,
            },
            wheel_R: Rate {
                speed: t6, rates: [t6, zero, t5], coordinates: [zero, zero, zero], heading: zero,
            },
            forces: [[t6, t6], [zero, zero], [t7, t5]],
        }
    }
}

// --- The nonlinear equations of motion -----------------------------------------------------------

/// The nonlinear equations of motion of [`WheeledPendulum`], with its parameters: what does not depend on the state is computed.
///
/// Positions: `x` (forward) in `m`, `y` (y of the contact point of the left wheel) in `m`, `psi` (yaw) in `rad`, `phi` (lean, by the heights of the wheels) in `rad`, `theta` (pitch) in `rad`, `thetaL` (angle of the left wheel) in `rad`, `thetaR` (angle of the right wheel) in `rad`.
/// Speeds: the rates of `psi`, `theta`, `thetaL`.
///
/// Each from one straight-line program:
/// - closure: 4 additions, 4 multiplications, 1 division, 1 negation and 2 trigonometric functions: 12 operations
/// - rates: 5 additions, 9 multiplications, 1 division, 2 negations and 4 trigonometric functions: 21 operations
/// - derivatives: 93 additions, 132 multiplications, 5 divisions, 2 negations and 6 trigonometric functions: 238 operations
/// - accelerations: 99 additions, 139 multiplications, 5 divisions, 2 negations and 6 trigonometric functions: 251 operations
/// - energy: 33 additions, 42 multiplications, 1 division, 1 negation and 4 trigonometric functions: 81 operations
/// - contact forces: 127 additions, 174 multiplications, 5 divisions and 6 trigonometric functions: 312 operations
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheeledPendulumMotion<T = f64> {
    constants: [T; 17],
}

impl<T: Scalar> WheeledPendulum<T> {
    /// The nonlinear equations of motion, of what is computed once for these parameters:
    /// 15 additions, 12 multiplications and 1 division: 28 operations.
    ///
    /// The parameters are not validated.
    #[must_use]
    pub fn motion(&self) -> WheeledPendulumMotion<T> {
        let t3 = self.b + self.b;
        let t4 = self.r / self.r;
        let t8 = self.r - self.r - self.l;
        let t9 = self.m * t8;
        let t11 = t8 * t9;
        let t12 = self.Iyy + t11;
        let t13 = self.b * self.m;
        let t14 = t8 * t13;
        let t17 = self.m + self.mW + self.mW;
        let t18 = t3 * self.mW;
        let t19 = t13 + t18;
        let t25 = self.Ir + self.Ir + t3 * t18 + self.b * t13;
        let t26 = t11 + t25;
        let t28 = t25 + self.Izz;
        let t30 = t28 - t26;
        let t31 = self.r * t17;
        let t32 = self.r * t31;
        let t33 = self.r * t19;
        let t37 = self.Ia + t32 + self.Ia * t4 * t4;
        WheeledPendulumMotion {
            constants: [
                self.r, self.Ia, t3, t4, t9, t12, t14, t17, t19, t26, t28, self.g, t30, t31, t32,
                t33, t37,
            ],
        }
    }
}

impl<T: Scalar> Nonlinear<3> for WheeledPendulum<T> {
    type Motion = WheeledPendulumMotion<T>;

    fn motion(&self) -> WheeledPendulumMotion<T> {
        WheeledPendulum::motion(self)
    }
}

impl<T: Scalar> carvallo::motion::Motion for WheeledPendulumMotion<T> {
    const INFO: &'static carvallo::motion::MotionInfo = &carvallo::motion::MotionInfo {
        model: "WheeledPendulum",
        positions: &[
            carvallo::motion::PositionInfo {
                name: "x",
                label: "forward",
                unit: "m",
                kind: carvallo::motion::PositionKind::Ignorable,
            },
            carvallo::motion::PositionInfo {
                name: "y",
                label: "y of the contact point of the left wheel",
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
                kind: carvallo::motion::PositionKind::Dependent,
            },
            carvallo::motion::PositionInfo {
                name: "theta",
                label: "pitch",
                unit: "rad",
                kind: carvallo::motion::PositionKind::Free,
            },
            carvallo::motion::PositionInfo {
                name: "thetaL",
                label: "angle of the left wheel",
                unit: "rad",
                kind: carvallo::motion::PositionKind::Ignorable,
            },
            carvallo::motion::PositionInfo {
                name: "thetaR",
                label: "angle of the right wheel",
                unit: "rad",
                kind: carvallo::motion::PositionKind::Ignorable,
            },
        ],
        speeds: &[2, 4, 5],
        dependent: &[3],
        forces: &[
            carvallo::motion::AppliedInfo {
                name: "TL",
                label: "torque of the left motor",
                unit: "N*m",
            },
            carvallo::motion::AppliedInfo {
                name: "TR",
                label: "torque of the right motor",
                unit: "N*m",
            },
        ],
        wheels: &[
            carvallo::motion::WheelInfo {
                name: "L",
                label: "left wheel",
            },
            carvallo::motion::WheelInfo {
                name: "R",
                label: "right wheel",
            },
        ],
    };
}

#[allow(unused_variables)]
impl<T: Scalar> carvallo::motion::Unchecked for WheeledPendulumMotion<T> {
    type Scalar = T;

    type Positions = [T; 7];

    type Speeds = [T; 3];

    type Dependent = [T; 1];

    type Forces = [T; 2];

    type ContactForces = [[T; 3]; 2];

    fn closure_unchecked(&self, positions: &[T; 7]) -> ([T; 1], [T; 1]) {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t3 = self.constants[0] * cos_phi;
        let t8 = t3 + sin_phi * self.constants[2] - t3;
        let t9 = self.constants[0] * sin_phi;
        let t14 = -(t8 / (t9 + cos_phi * self.constants[2] - t9));
        ([t8], [t14])
    }

    fn rates_unchecked(&self, positions: &[T; 7], speeds: &[T; 3]) -> [T; 7] {
        let t4 = self.constants[0] * (speeds[1] + speeds[2]);
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t14 = self.constants[0] * sin_phi;
        let t20 = (t14 + cos_phi * self.constants[2] - t14) / self.constants[0];
        let t27 = speeds[0] * t20 + speeds[1] * sin_phi * t20
            + speeds[2] * self.constants[3];
        let t28 = -(t4 * cos_psi);
        let t29 = -(t4 * sin_psi);
        [t28, t29, speeds[0], self.constants[0].like(0.0), speeds[1], speeds[2], t27]
    }

    fn derivatives_unchecked(&self, positions: &[T; 7], speeds: &[T; 3], forces: &[T; 2]) -> ([T; 7], [T; 3]) {
        let t3 = speeds[1] + speeds[2];
        let t4 = self.constants[0] * t3;
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t14 = self.constants[0] * sin_phi;
        let t19 = t14 + cos_phi * self.constants[2] - t14;
        let t20 = self.constants[0].like(1.0) / self.constants[0];
        let t21 = t19 * t20;
        let t23 = sin_phi * t21;
        let t28 = speeds[0] * t21 + speeds[1] * t23 + speeds[2] * self.constants[3];
        let (sin_theta, cos_theta) = positions[4].sin_cos();
        let t32 = speeds[0] * sin_phi;
        let t34 = self.constants[0] * t32;
        let t35 = (t3 + t32) * t34;
        let t38 = t35 - cos_phi * self.constants[11];
        let t39 = sin_theta * t38;
        let t42 = speeds[0] * cos_phi;
        let t43 = sin_theta * t42;
        let t44 = speeds[1] * t43;
        let t45 = t3 * t42;
        let t47 = t34 * t42;
        let t49 = t42 * cos_theta;
        let t50 = self.constants[2] * t49;
        let t52 = self.constants[2] * t43;
        let t54 = speeds[1] + t28;
        let t60 = t47 + self.constants[0] * t42 * t54 - self.constants[0] * t45 - t47
            - t49 * t50;
        let t64 = speeds[1] + t32;
        let t66 = speeds[1] * t49;
        let t69 = t35 * cos_theta + t50 * t64 - self.constants[2] * t66;
        let t75 = self.constants[2] * t44 - sin_theta * t35 - t52 * t64;
        let t83 = (sin_phi * (t60 - t43 * t52)
            + cos_phi * (cos_theta * t69 - sin_theta * t75 - t34 * (t32 + t54))) / t19;
        let t85 = t44 + sin_theta * t83;
        let t92 = t20 * self.constants[1] * (sin_theta * t69 + cos_theta * t75);
        let t94 = t43 * self.constants[9];
        let t99 = t49 * self.constants[10] - self.constants[6] * t64;
        let t102 = t38 * cos_theta;
        let t106 = t66 + cos_theta * t83;
        let t108 = self.constants[4] * t43;
        let t127 = sin_theta
            * (self.constants[7] * t102 - self.constants[8] * t106 - t43 * t108
                - t64 * (self.constants[4] * t64 - t49 * self.constants[8]))
            + cos_theta
                * (t85 * self.constants[8] - t39 * self.constants[7]
                    - t43 * t64 * self.constants[8] - t49 * t108);
        let t128 = self.constants[0] * t127;
        let t133 = self.constants[6] * t85 + t43 * t99 - self.constants[4] * t39 - t92
            - t49 * t94 - t128;
        let t146 = t64 * self.constants[5] + self.constants[1] * (speeds[2] + t64)
            + self.constants[1] * (t28 + t64) - self.constants[6] * t49;
        let t164 = t102 * self.constants[8]
            + self.constants[4]
                * (t47 + sin_phi * self.constants[11] + self.constants[0] * (t45 + t83))
            + t64 * t99;
        let t168 = cos_theta
            * (t39 * self.constants[8] + t64 * t94 - t85 * self.constants[10]
                - t43 * t146)
            - sin_theta * (t164 - self.constants[9] * t106 - t49 * t146);
        let t171 = t92 + forces[1];
        let t174 = t21 * t171 - sin_phi * t133 - cos_phi * t168;
        let t175 = self.constants[4] * cos_theta;
        let t176 = self.constants[0] * t175;
        let t180 = self.constants[5] + self.constants[14] - t176 - t176;
        let t184 = self.constants[15] - self.constants[6] * cos_theta;
        let t186 = sin_phi * t180 + cos_phi * t184;
        let t195 = cos_phi
            * (sin_phi * t184
                + cos_phi
                    * (self.constants[10] - sin_theta * sin_theta * self.constants[12]));
        let t196 = sin_phi * self.constants[1];
        let t198 = sin_phi + t21;
        let t199 = self.constants[1] * t198;
        let t203 = sin_phi * t186 + t195 + sin_phi * t196 + t198 * t199;
        let t204 = self.constants[0].like(1.0) / t203;
        let t207 = t23 + self.constants[0].like(1.0);
        let t211 = t204 * (t186 + t196 + t199 * t207);
        let t212 = self.constants[1] * t207;
        let t214 = t203 * t211;
        let t218 = self.constants[1] + t180 + t207 * t212 - t211 * t214;
        let t219 = self.constants[0].like(1.0) / t218;
        let t223 = t23 * t171 - t133 - t174 * t211;
        let t227 = self.constants[0] * (t175 - self.constants[13]);
        let t235 = t204
            * (t196 + cos_phi * self.constants[15] + self.constants[3] * t199
                - sin_phi * t227);
        let t240 = t219
            * (self.constants[1] + self.constants[3] * t212 - t227 - t214 * t235);
        let t256 = (t128 + forces[0] + self.constants[3] * t171 - t174 * t235
            - t223 * t240)
            / (self.constants[16] - t203 * t235 * t235 - t218 * t240 * t240);
        let t258 = t219 * t223 - t240 * t256;
        let t262 = t174 * t204 - t211 * t258 - t235 * t256;
        let t263 = -(t4 * cos_psi);
        let t264 = -(t4 * sin_psi);
        (
            [
                t263, t264, speeds[0], self.constants[0].like(0.0), speeds[1], speeds[2], t28,
            ],
            [t262, t258, t256],
        )
    }

    fn accelerations_unchecked(&self, positions: &[T; 7], speeds: &[T; 3], forces: &[T; 2]) -> [T; 7] {
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_theta, cos_theta) = positions[4].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t11 = speeds[0] * sin_phi;
        let t14 = speeds[1] + speeds[2];
        let t16 = self.constants[0] * t11;
        let t17 = (t11 + t14) * t16;
        let t21 = t17 - cos_phi * self.constants[11];
        let t22 = cos_theta * t21;
        let t25 = speeds[0] * cos_phi;
        let t26 = cos_theta * t25;
        let t27 = speeds[1] * t26;
        let t28 = t14 * t25;
        let t30 = t16 * t25;
        let t32 = t26 * self.constants[2];
        let t34 = sin_theta * t25;
        let t35 = self.constants[2] * t34;
        let t37 = self.constants[0] * sin_phi;
        let t40 = t37 + cos_phi * self.constants[2] - t37;
        let t41 = self.constants[0].like(1.0) / self.constants[0];
        let t42 = t40 * t41;
        let t44 = sin_phi * t42;
        let t49 = speeds[0] * t42 + speeds[1] * t44 + speeds[2] * self.constants[3];
        let t50 = speeds[1] + t49;
        let t56 = t30 + self.constants[0] * t25 * t50 - self.constants[0] * t28 - t30
            - t26 * t32;
        let t60 = t11 + speeds[1];
        let t64 = cos_theta * t17 + t32 * t60 - t27 * self.constants[2];
        let t68 = speeds[1] * t34;
        let t71 = self.constants[2] * t68 - sin_theta * t17 - t35 * t60;
        let t79 = (sin_phi * (t56 - t34 * t35)
            + cos_phi * (cos_theta * t64 - sin_theta * t71 - t16 * (t11 + t50))) / t40;
        let t81 = t27 + cos_theta * t79;
        let t84 = t34 * self.constants[4];
        let t94 = sin_theta * t21;
        let t97 = t68 + sin_theta * t79;
        let t106 = sin_theta
            * (self.constants[7] * t22 - self.constants[8] * t81 - t34 * t84
                - t60 * (t60 * self.constants[4] - self.constants[8] * t26))
            + cos_theta
                * (self.constants[8] * t97 - self.constants[7] * t94
                    - self.constants[8] * t34 * t60 - t26 * t84);
        let t107 = self.constants[0] * t106;
        let t113 = t41 * (sin_theta * t64 + cos_theta * t71);
        let t114 = self.constants[1] * t113;
        let t115 = forces[1] + t114;
        let t121 = t34 * self.constants[9];
        let t126 = t26 * self.constants[10] - t60 * self.constants[6];
        let t132 = t97 * self.constants[6] + t34 * t126 - t107 - t114
            - self.constants[4] * t94 - t26 * t121;
        let t145 = t60 * self.constants[5] + self.constants[1] * (speeds[2] + t60)
            + self.constants[1] * (t49 + t60) - t26 * self.constants[6];
        let t163 = t22 * self.constants[8]
            + self.constants[4]
                * (t30 + sin_phi * self.constants[11] + self.constants[0] * (t28 + t79))
            + t60 * t126;
        let t167 = cos_theta
            * (self.constants[8] * t94 + t60 * t121 - t97 * self.constants[10]
                - t34 * t145)
            - sin_theta * (t163 - t81 * self.constants[9] - t26 * t145);
        let t171 = t42 * t115 - sin_phi * t132 - cos_phi * t167;
        let t172 = sin_phi * self.constants[1];
        let t173 = cos_theta * self.constants[4];
        let t176 = self.constants[0] * (t173 - self.constants[13]);
        let t180 = sin_phi + t42;
        let t181 = self.constants[1] * t180;
        let t186 = self.constants[0] * t173;
        let t190 = self.constants[5] + self.constants[14] - t186 - t186;
        let t193 = self.constants[15] - cos_theta * self.constants[6];
        let t195 = sin_phi * t190 + cos_phi * t193;
        let t204 = cos_phi
            * (sin_phi * t193
                + cos_phi
                    * (self.constants[10] - sin_theta * sin_theta * self.constants[12]));
        let t209 = sin_phi * t195 + t204 + sin_phi * t172 + t180 * t181;
        let t210 = self.constants[0].like(1.0) / t209;
        let t211 = (t172 + cos_phi * self.constants[15] + self.constants[3] * t181
            - sin_phi * t176) * t210;
        let t214 = t44 + self.constants[0].like(1.0);
        let t215 = self.constants[1] * t214;
        let t220 = t210 * (t172 + t195 + t181 * t214);
        let t221 = t209 * t220;
        let t230 = self.constants[1] + t190 + t214 * t215 - t220 * t221;
        let t231 = self.constants[0].like(1.0) / t230;
        let t232 = (self.constants[1] + self.constants[3] * t215 - t176 - t211 * t221)
            * t231;
        let t236 = t44 * t115 - t132 - t171 * t220;
        let t249 = (forces[0] + t107 + self.constants[3] * t115 - t171 * t211
            - t232 * t236)
            / (self.constants[16] - t209 * t211 * t211 - t230 * t232 * t232);
        let t252 = t231 * t236 - t232 * t249;
        let t254 = self.constants[0] * (t249 + t252);
        let t258 = self.constants[0] * speeds[0] * t14;
        let t260 = sin_psi * t258 - cos_psi * t254;
        let t268 = t171 * t210 - t220 * t252 - t211 * t249;
        let t274 = t42 * t268 + t44 * t252 + self.constants[3] * t249 - t113;
        let t275 = -(t254 * sin_psi + cos_psi * t258);
        let t276 = -t79;
        [t260, t275, t268, t276, t252, t249, t274]
    }

    fn energy_unchecked(&self, positions: &[T; 7], speeds: &[T; 3]) -> [T; 2] {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_theta, cos_theta) = positions[4].sin_cos();
        let t8 = cos_theta * self.constants[4];
        let t9 = self.constants[0] * t8;
        let t13 = self.constants[5] + self.constants[14] - t9 - t9;
        let t19 = self.constants[15] - cos_theta * self.constants[6];
        let t21 = sin_phi * t13 + cos_phi * t19;
        let t32 = cos_phi
            * (sin_phi * t19
                + cos_phi
                    * (self.constants[10] - sin_theta * sin_theta * self.constants[12]));
        let t34 = sin_phi * self.constants[1];
        let t36 = sin_phi * self.constants[0];
        let t41 = (t36 + cos_phi * self.constants[2] - t36) / self.constants[0];
        let t42 = sin_phi + t41;
        let t43 = self.constants[1] * t42;
        let t52 = self.constants[0].like(1.0) + sin_phi * t41;
        let t55 = t21 + t34 + t43 * t52;
        let t59 = t8 - self.constants[13];
        let t60 = self.constants[0] * t59;
        let t67 = t34 + cos_phi * self.constants[15] + t43 * self.constants[3]
            - sin_phi * t60;
        let t69 = speeds[0] * (sin_phi * t21 + t32 + sin_phi * t34 + t42 * t43)
            + speeds[1] * t55;
        let t73 = self.constants[1] * t52;
        let t80 = self.constants[1] + self.constants[3] * t73 - t60;
        let t84 = speeds[1]
            * (speeds[0] * t55 + speeds[1] * (t13 + self.constants[1] + t52 * t73)
                + speeds[2] * t80);
        let t95 = (speeds[0] * (t69 + speeds[2] * t67) + t84
            + speeds[2]
                * (speeds[0] * t67 + speeds[1] * t80 + speeds[2] * self.constants[16]))
            * self.constants[0].like(0.5);
        let t102 = -(self.constants[11] * (sin_phi * self.constants[8] + cos_phi * t59));
        [t95, t102]
    }

    fn contact_forces_unchecked(&self, positions: &[T; 7], speeds: &[T; 3], forces: &[T; 2]) -> [[T; 3]; 2] {
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_theta, cos_theta) = positions[4].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t7 = speeds[0] * cos_phi;
        let t8 = sin_theta * t7;
        let t10 = t8 * self.constants[4];
        let t14 = speeds[0] * sin_phi;
        let t15 = speeds[1] + t14;
        let t18 = t7 * cos_theta;
        let t21 = self.constants[4] * t15 - t18 * self.constants[8];
        let t23 = t8 * t10 + t15 * t21;
        let t26 = speeds[1] + speeds[2];
        let t29 = t14 * self.constants[0];
        let t30 = (t14 + t26) * t29;
        let t33 = t30 - cos_phi * self.constants[11];
        let t34 = cos_theta * t33;
        let t37 = speeds[1] * t18;
        let t38 = t7 * t26;
        let t40 = t7 * t29;
        let t42 = t18 * self.constants[2];
        let t44 = t8 * self.constants[2];
        let t46 = sin_phi * self.constants[0];
        let t49 = t46 + cos_phi * self.constants[2] - t46;
        let t50 = self.constants[0].like(1.0) / self.constants[0];
        let t51 = t49 * t50;
        let t53 = sin_phi * t51;
        let t58 = speeds[0] * t51 + speeds[1] * t53 + speeds[2] * self.constants[3];
        let t59 = speeds[1] + t58;
        let t65 = t40 + t7 * self.constants[0] * t59 - self.constants[0] * t38 - t40
            - t18 * t42;
        let t72 = cos_theta * t30 + t15 * t42 - t37 * self.constants[2];
        let t76 = t8 * speeds[1];
        let t79 = self.constants[2] * t76 - sin_theta * t30 - t15 * t44;
        let t87 = self.constants[0].like(1.0) / t49;
        let t88 = (sin_phi * (t65 - t8 * t44)
            + cos_phi * (cos_theta * t72 - sin_theta * t79 - t29 * (t14 + t59))) * t87;
        let t90 = t37 + cos_theta * t88;
        let t95 = sin_theta * t33;
        let t98 = t76 + sin_theta * t88;
        let t100 = t8 * self.constants[8];
        let t103 = t15 * t100 + t10 * t18;
        let t108 = self.constants[0]
            * (sin_theta * (self.constants[7] * t34 - t23 - self.constants[8] * t90)
                + cos_theta
                    * (self.constants[8] * t98 - self.constants[7] * t95 - t103));
        let t114 = t50 * (sin_theta * t72 + cos_theta * t79);
        let t115 = self.constants[1] * t114;
        let t116 = forces[1] + t115;
        let t122 = t8 * self.constants[9];
        let t127 = t18 * self.constants[10] - t15 * self.constants[6];
        let t133 = t98 * self.constants[6] + t8 * t127 - t108 - t115
            - self.constants[4] * t95 - t18 * t122;
        let t146 = t15 * self.constants[5] + self.constants[1] * (t15 + speeds[2])
            + self.constants[1] * (t15 + t58) - t18 * self.constants[6];
        let t149 = t15 * t122 - t8 * t146;
        let t159 = t40 + sin_phi * self.constants[11] + self.constants[0] * (t38 + t88);
        let t164 = self.constants[4] * t159 + t15 * t127 - t18 * t146;
        let t169 = cos_phi
            * (cos_theta * (self.constants[8] * t95 + t149 - t98 * self.constants[10])
                - sin_theta
                    * (self.constants[8] * t34 + t164 - t90 * self.constants[9]));
        let t172 = t51 * t116 - sin_phi * t133 - t169;
        let t173 = sin_phi * self.constants[1];
        let t174 = self.constants[4] * cos_theta;
        let t177 = self.constants[0] * (t174 - self.constants[13]);
        let t181 = sin_phi + t51;
        let t182 = self.constants[1] * t181;
        let t187 = self.constants[0] * t174;
        let t191 = self.constants[5] + self.constants[14] - t187 - t187;
        let t194 = self.constants[15] - cos_theta * self.constants[6];
        let t196 = sin_phi * t191 + cos_phi * t194;
        let t205 = cos_phi
            * (sin_phi * t194
                + cos_phi
                    * (self.constants[10] - sin_theta * sin_theta * self.constants[12]));
        let t210 = sin_phi * t196 + t205 + sin_phi * t173 + t181 * t182;
        let t211 = self.constants[0].like(1.0) / t210;
        let t212 = (t173 + cos_phi * self.constants[15] + self.constants[3] * t182
            - sin_phi * t177) * t211;
        let t215 = t53 + self.constants[0].like(1.0);
        let t216 = self.constants[1] * t215;
        let t221 = t211 * (t173 + t196 + t182 * t215);
        let t222 = t210 * t221;
        let t231 = self.constants[1] + t191 + t215 * t216 - t221 * t222;
        let t232 = self.constants[0].like(1.0) / t231;
        let t233 = (self.constants[1] + self.constants[3] * t216 - t177 - t212 * t222)
            * t232;
        let t237 = t53 * t116 - t133 - t172 * t221;
        let t250 = (forces[0] + t108 + self.constants[3] * t116 - t172 * t212
            - t233 * t237)
            / (self.constants[16] - t210 * t212 * t212 - t231 * t233 * t233);
        let t253 = t232 * t237 - t233 * t250;
        let t258 = t172 * t211 - t221 * t253 - t212 * t250;
        let t260 = t253 + sin_phi * t258;
        let t262 = self.constants[0] * (t250 + t260);
        let t264 = t34 - sin_theta * t262;
        let t266 = cos_phi * t258;
        let t268 = t90 + sin_theta * t266;
        let t271 = self.constants[7] * t264 - t23 - self.constants[8] * t268;
        let t274 = t95 + cos_theta * t262;
        let t278 = cos_theta * t266 - t98;
        let t282 = self.constants[4] * t260 - t103 - self.constants[7] * t274
            - self.constants[8] * t278;
        let t291 = self.constants[1]
            * (t260 + t51 * t258 + t53 * t253 + self.constants[3] * t250 - t114);
        let t293 = t50 * (t291 - forces[1]);
        let t295 = sin_theta * t271 + cos_theta * t282 - t293;
        let t304 = t18 * t21 + self.constants[4] * t268 - self.constants[7] * t159
            - t8 * t100;
        let t308 = cos_theta * t271 - sin_theta * t282;
        let t310 = cos_phi * t304 - sin_phi * t308;
        let t312 = cos_psi * t295 - sin_psi * t310;
        let t315 = t295 * sin_psi + cos_psi * t310;
        let t329 = sin_theta
            * (t149 + self.constants[8] * t274 + self.constants[10] * t278
                - self.constants[6] * t260)
            + cos_theta * (t164 + self.constants[8] * t264 - self.constants[9] * t268);
        let t331 = t87 * (t329 + self.constants[0] * t304);
        let t335 = sin_phi * t304 + cos_phi * t308 - t331;
        let t336 = cos_psi * t293;
        let t337 = t293 * sin_psi;
        [[t312, t315, t335], [t336, t337, t331]]
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`WheeledPendulum`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheeledPendulumDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 18],
}

impl<T: Number> WheeledPendulum<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 26 additions, 17 multiplications, 1 division and 1 negation: 45 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WheeledPendulumMatrices<T>, WheeledPendulumDerivatives<T>) {
        let t2 = self.mW + self.mW;
        let m_all = self.m + t2;
        let t5 = self.m.like(1.0) / self.r;
        let t7 = self.Ia + self.Ia;
        let t8 = t5 * t7;
        let t9 = t5 * t8;
        let M_11 = m_all + t9;
        let t11 = t2 * self.r;
        let t13 = self.r + self.l;
        let t14 = self.m * t13;
        let t15 = t11 + t14;
        let zero = self.m.like(0.0);
        let M_22 = t7 + self.Iyy + self.r * t11 + t13 * t14;
        let t27 = self.b * self.b;
        let t28 = t2 + t9;
        let M_33 = self.Izz + self.Ir + self.Ir + t27 * t28;
        let K0_22 = m_all * self.r - t15;
        let M_22_m = t13 * t13;
        let K0_22_m = self.r - t13;
        let M_22_l = t14 + t14;
        let t40 = self.r + self.r;
        let t41 = self.r * self.r;
        let M_22_mW = t41 + t41;
        let M_33_mW = t27 + t27;
        let t44 = t5 * t5;
        let M_11_Ia = t44 + t44;
        let t46 = t5 + t5;
        let M_33_Ia = t27 * M_11_Ia;
        let t48 = t7 * t44;
        let t49 = t46 * t48;
        let M_12_r = t48 - m_all;
        let M_22_r = t11 + t11 + M_22_l;
        let t53 = t27 * t49;
        let M_33_b = t28 * (self.b + self.b);
        let M_12 = -(t8 + t15);
        (
            WheeledPendulumMatrices::from_entries([
                M_11, M_12, zero, M_12, M_22, zero, zero, zero, M_33, zero, zero, zero, zero, K0_22,
                zero, zero, zero, zero,
            ]),
            WheeledPendulumDerivatives {
                values: [
                    self.m.like(1.0), t13, M_22_m, K0_22_m, self.m, M_22_l, self.m.like(2.0), t40,
                    M_22_mW, M_33_mW, M_11_Ia, t46, M_33_Ia, t49, M_12_r, M_22_r, t53, M_33_b,
                ],
            },
        )
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl WheeledPendulum<f64> {
    /// The parameter set `robot`.
    ///
    /// Source: A robot of the size of a boot, by estimate
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `m` | 0.6 | `kg` |
    /// | `l` | 0.07 | `m` |
    /// | `Iyy` | 0.001 | `kg*m^2` |
    /// | `Izz` | 0.0011 | `kg*m^2` |
    /// | `mW` | 0.03 | `kg` |
    /// | `Ia` | 0.000024 | `kg*m^2` |
    /// | `Ir` | 0.000012 | `kg*m^2` |
    /// | `r` | 0.04 | `m` |
    /// | `b` | 0.07 | `m` |
    /// | `g` | 9.81 | `N/kg` |
    pub const ROBOT: Self = Self {
        m: 0.6, l: 0.07, Iyy: 0.001, Izz: 0.0011, mW: 0.03, Ia: 0.000024, Ir: 0.000012, r: 0.04,
        b: 0.07, g: 9.81,
    };

    /// The parameter set `transporter`.
    ///
    /// Source: A transporter with a rider who stands still, by estimate
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `m` | 110 | `kg` |
    /// | `l` | 0.9 | `m` |
    /// | `Iyy` | 12 | `kg*m^2` |
    /// | `Izz` | 2 | `kg*m^2` |
    /// | `mW` | 5 | `kg` |
    /// | `Ia` | 0.08 | `kg*m^2` |
    /// | `Ir` | 0.045 | `kg*m^2` |
    /// | `r` | 0.24 | `m` |
    /// | `b` | 0.28 | `m` |
    /// | `g` | 9.81 | `N/kg` |
    pub const TRANSPORTER: Self = Self {
        m: 110.0, l: 0.9, Iyy: 12.0, Izz: 2.0, mW: 5.0, Ia: 0.08, Ir: 0.045, r: 0.24, b: 0.28,
        g: 9.81,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> WheeledPendulum<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 10]) -> Self {
        Self {
            m: values[0], l: values[1], Iyy: values[2], Izz: values[3], mW: values[4],
            Ia: values[5], Ir: values[6], r: values[7], b: values[8], g: values[9],
        }
    }

    /// The parameters as an array in declared order.
    #[must_use]
    pub const fn to_array(&self) -> [T; 10] {
        [
            self.m, self.l, self.Iyy, self.Izz, self.mW, self.Ia, self.Ir, self.r, self.b, self.g,
        ]
    }
}

impl<T: Scalar> WheeledPendulum<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> WheeledPendulum<U> {
        let values = self.to_array();
        WheeledPendulum::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl WheeledPendulum<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> WheeledPendulum<f32> {
        WheeledPendulum::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<WheeledPendulum<f32>> for WheeledPendulum<f64> {
    fn from(parameters: WheeledPendulum<f32>) -> Self {
        WheeledPendulum::cast(&parameters)
    }
}

impl<T: Number> WheeledPendulumMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 18]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            k0: carvallo::rows(&entries, 9),
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 3]; 3]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 3]; 3];
        [self.m.0, zeros, zeros, zeros, zeros, self.k0.0, zeros, zeros]
    }
}

impl<T: Scalar> From<WheeledPendulumMatrices<T>> for Coefficients<T, 3> {
    fn from(matrices: WheeledPendulumMatrices<T>) -> Self {
        Coefficients {
            states: [States::Rate, States::Both, States::Rate],
            ..Coefficients::from_rows(matrices.rows())
        }
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<3> for WheeledPendulum<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 10];

    type Over<U: Number> = WheeledPendulum<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "WheeledPendulum",
        docs: "A pendulum upside down on two wheels, as balancing robots and the Segway are: it stands only where a motor balances it.\n\nTwo wheels on one axle that roll without slip, and a body above it. The motors act between body and wheels; forward\nmotion, pitch and yaw take part. A positive torque, about y, drives a wheel backward and pitches the body forward.\nAxes: origin on the ground below the axle, x forward, y to the right, z down.",
        source: "Mechanism: Grasser, D'Arrigo, Colombi & Rufer (2002), JOE: a mobile, inverted pendulum, IEEE Trans. Ind. Electron. 49, 107-114",
        parameters: &[
            ParameterInfo::new("m", "kg", Domain::POSITIVE).docs("Mass of the body."),
            ParameterInfo::new("l", "m", Domain::POSITIVE)
                .docs("Centre of mass of the body, above the axle."),
            ParameterInfo::new("Iyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the body about its centre of mass, in pitch."),
            ParameterInfo::new("Izz", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the body about its centre of mass, in yaw."),
            ParameterInfo::new("mW", "kg", Domain::NONNEGATIVE)
                .docs("Mass of each wheel."),
            ParameterInfo::new("Ia", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Axial moment of inertia of each wheel."),
            ParameterInfo::new("Ir", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Radial moment of inertia of each wheel, about a diameter."),
            ParameterInfo::new("r", "m", Domain::POSITIVE).docs("Radius of the wheels."),
            ParameterInfo::new("b", "m", Domain::POSITIVE)
                .docs("Half of the track, from the middle of the axle to a wheel."),
            ParameterInfo::new("g", "N/kg", Domain::NONNEGATIVE)
                .docs("Gravitational field strength."),
        ],
        coordinates: &[
            CoordinateInfo::new("x", "m")
                .label("forward")
                .docs(
                    "Forward motion, beside that at the speed v, of the point of the body that is on the ground when it is upright.",
                )
                .states(States::Rate),
            CoordinateInfo::new("theta", "rad")
                .label("pitch")
                .docs("Pitch of the body, positive backward."),
            CoordinateInfo::new("psi", "rad")
                .label("yaw")
                .docs("Yaw, positive to the right.")
                .states(States::Rate),
        ],
        matrices: &[MatrixName::M, MatrixName::K0],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]),
            EntryInfo::at(&[(MatrixName::M, 2, 2)]),
            EntryInfo::at(&[(MatrixName::K0, 1, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "robot",
                docs: "",
                source: "A robot of the size of a boot, by estimate",
                values: &WheeledPendulum::to_array(&WheeledPendulum::<f64>::ROBOT),
            },
            SetInfo {
                name: "transporter",
                docs: "",
                source: "A transporter with a rider who stands still, by estimate",
                values: &WheeledPendulum::to_array(&WheeledPendulum::<f64>::TRANSPORTER),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("spin_L_by_x", "1/m", "-1/r"),
            FormulaInfo::definition("spin_L_by_psi", "1", "-b/r"),
            FormulaInfo::definition("Jyy_all", "kg*m^2", "m*(l + r)^2 + Iyy + 2*mW*r^2 + 2*Ia"),
            FormulaInfo::definition("Jzz_all", "kg*m^2", "Izz + 2*mW*b^2 + 2*Ir"),
            FormulaInfo::definition("Sz_all", "kg*m", "-m*(l + r) - 2*mW*r"),
            FormulaInfo::definition("m_all", "kg", "m + 2*mW"),
            FormulaInfo::definition("K_theta_theta", "kg*m", "r*m_all + Sz_all"),
            FormulaInfo::definition("P_x_theta", "kg*m", "2*Ia*spin_L_by_x + Sz_all"),
            FormulaInfo::definition("P_x_spin_L", "kg*m", "Ia*spin_L_by_x"),
            FormulaInfo::definition("P_psi_spin_L", "kg*m^2", "Ia*spin_L_by_psi"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg", "2*spin_L_by_x*P_x_spin_L + m_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)], "kg*m", "P_x_theta"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "Jyy_all"),
            FormulaInfo::entry(&[(MatrixName::M, 2, 2)], "kg*m^2", "2*spin_L_by_psi*P_psi_spin_L + Jzz_all"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "K_theta_theta"),
        ],
        gravity: Some(9),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("WheeledPendulum", 10, values)?;
        Ok(<Self as Evaluator<T, 3>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("WheeledPendulum", 10, values)?;
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
        let info = const { &<Self as Model<3>>::INFO.without_formulas() };
        info.validate(&self.to_array().map(Scalar::to_f64))?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 3> {
        Coefficients {
            states: [States::Rate, States::Both, States::Rate],
            ..Coefficients::from_rows(WheeledPendulumMatrices::rows(&self.matrices()))
        }
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 3>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn nonlinear(&self) -> Option<impl carvallo::motion::Motion<Scalar = Self::Scalar>> {
        Some(self.motion())
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl WheeledPendulum<f64> {
    /// What the model tells about itself, the same for every number type.
    pub const INFO: &'static ModelInfo = <Self as Model<3>>::INFO;

    /// The parameter set of this name, however it is spelt: upper and lower case, `_`, `-` and spaces make no
    /// difference. In `f32` it is had by the trait `Model`.
    #[must_use]
    pub fn set(name: &str) -> Option<Self> {
        <Self as Model<3>>::set(name)
    }
}

/// The parameters, one a line with its unit, in the precision that is asked for; `{:#}` says what they are.
impl<T: Scalar> core::fmt::Display for WheeledPendulum<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<3>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 3> for WheeledPendulum<T> {
    type Entries = [T; 5];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            m: parameter(0), l: parameter(1), Iyy: parameter(2), Izz: parameter(3),
            mW: parameter(4), Ia: parameter(5), Ir: parameter(6), r: parameter(7), b: parameter(8),
            g: parameter(9),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        let matrices = self.matrices();
        [
            matrices.m[0][0], matrices.m[0][1], matrices.m[1][1], matrices.m[2][2],
            matrices.k0[1][1],
        ]
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 3]; 3]; 8] {
        WheeledPendulumMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> WheeledPendulumDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<WheeledPendulumMatrices<T>> {
        if parameter >= 10 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = WheeledPendulumMatrices {
            m: Rows([[zero; 3]; 3]),
            k0: Rows([[zero; 3]; 3]),
        };
        for position in 0..28 {
            let partial = <WheeledPendulumDerivatives>::PARTIALS[position];
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

impl<T: Scalar> Differentiable<3> for WheeledPendulum<T> {
    type Derivatives = [Coefficients<T, 3>; 10];

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 3>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 3]; 3]; 8]); 10];
        for position in 0..28 {
            Partial::write(&<WheeledPendulumDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (
            Coefficients {
                states: [States::Rate, States::Both, States::Rate],
                ..Coefficients::from_rows(WheeledPendulumMatrices::rows(&matrices))
            },
            all,
        )
    }
}

impl WheeledPendulumDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 28] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 0), Partial::new(MatrixName::M, 0, 1, 0, 1).negative(),
        Partial::new(MatrixName::M, 1, 0, 0, 1).negative(), Partial::new(MatrixName::M, 1, 1, 0, 2),
        Partial::new(MatrixName::K0, 1, 1, 0, 3),
        Partial::new(MatrixName::M, 0, 1, 1, 4).negative(),
        Partial::new(MatrixName::M, 1, 0, 1, 4).negative(), Partial::new(MatrixName::M, 1, 1, 1, 5),
        Partial::new(MatrixName::K0, 1, 1, 1, 4).negative(),
        Partial::new(MatrixName::M, 1, 1, 2, 0), Partial::new(MatrixName::M, 2, 2, 3, 0),
        Partial::new(MatrixName::M, 0, 0, 4, 6), Partial::new(MatrixName::M, 0, 1, 4, 7).negative(),
        Partial::new(MatrixName::M, 1, 0, 4, 7).negative(), Partial::new(MatrixName::M, 1, 1, 4, 8),
        Partial::new(MatrixName::M, 2, 2, 4, 9), Partial::new(MatrixName::M, 0, 0, 5, 10),
        Partial::new(MatrixName::M, 0, 1, 5, 11).negative(),
        Partial::new(MatrixName::M, 1, 0, 5, 11).negative(),
        Partial::new(MatrixName::M, 1, 1, 5, 6), Partial::new(MatrixName::M, 2, 2, 5, 12),
        Partial::new(MatrixName::M, 2, 2, 6, 6),
        Partial::new(MatrixName::M, 0, 0, 7, 13).negative(),
        Partial::new(MatrixName::M, 0, 1, 7, 14), Partial::new(MatrixName::M, 1, 0, 7, 14),
        Partial::new(MatrixName::M, 1, 1, 7, 15),
        Partial::new(MatrixName::M, 2, 2, 7, 16).negative(),
        Partial::new(MatrixName::M, 2, 2, 8, 17),
    ];
}
