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
/// - rates: 5 additions, 8 multiplications, 1 division, 2 negations and 4 trigonometric functions: 20 operations
/// - derivatives: 93 additions, 128 multiplications, 5 divisions, 2 negations and 6 trigonometric functions: 234 operations
/// - accelerations: 99 additions, 134 multiplications, 5 divisions, 2 negations and 6 trigonometric functions: 246 operations
/// - energy: 33 additions, 40 multiplications, 1 division, 1 negation and 4 trigonometric functions: 79 operations
/// - contact forces: 126 additions, 169 multiplications, 5 divisions and 6 trigonometric functions: 306 operations
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheeledPendulumMotion<T = f64> {
    constants: [T; 16],
}

impl<T: Scalar> WheeledPendulum<T> {
    /// The nonlinear equations of motion, of what is computed once for these parameters:
    /// 15 additions and 10 multiplications: 25 operations.
    ///
    /// The parameters are not validated.
    #[must_use]
    pub fn motion(&self) -> WheeledPendulumMotion<T> {
        let t3 = self.b + self.b;
        let t7 = self.r - self.r - self.l;
        let t8 = self.m * t7;
        let t10 = t7 * t8;
        let t11 = self.Iyy + t10;
        let t12 = self.b * self.m;
        let t13 = t7 * t12;
        let t16 = self.m + self.mW + self.mW;
        let t17 = t3 * self.mW;
        let t18 = t12 + t17;
        let t24 = self.Ir + self.Ir + t3 * t17 + self.b * t12;
        let t25 = t10 + t24;
        let t27 = t24 + self.Izz;
        let t29 = t27 - t25;
        let t30 = self.r * t16;
        let t31 = self.r * t30;
        let t32 = self.r * t18;
        let t34 = self.Ia + self.Ia + t31;
        WheeledPendulumMotion {
            constants: [
                self.r, self.Ia, t3, t8, t11, t13, t16, t18, t25, t27, self.g, t29, t30, t31, t32,
                t34,
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
        let t25 = speeds[2] + speeds[0] * t20 + speeds[1] * sin_phi * t20;
        let t26 = -(t4 * cos_psi);
        let t27 = -(t4 * sin_psi);
        [t26, t27, speeds[0], self.constants[0].like(0.0), speeds[1], speeds[2], t25]
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
        let t26 = speeds[2] + speeds[0] * t21 + speeds[1] * t23;
        let (sin_theta, cos_theta) = positions[4].sin_cos();
        let t30 = speeds[0] * sin_phi;
        let t32 = self.constants[0] * t30;
        let t33 = (t3 + t30) * t32;
        let t36 = t33 - cos_phi * self.constants[10];
        let t37 = sin_theta * t36;
        let t40 = speeds[0] * cos_phi;
        let t41 = sin_theta * t40;
        let t42 = speeds[1] * t41;
        let t43 = t3 * t40;
        let t45 = t32 * t40;
        let t47 = t40 * cos_theta;
        let t48 = self.constants[2] * t47;
        let t50 = self.constants[2] * t41;
        let t52 = speeds[1] + t26;
        let t58 = t45 + self.constants[0] * t40 * t52 - self.constants[0] * t43 - t45
            - t47 * t48;
        let t62 = speeds[1] + t30;
        let t64 = speeds[1] * t47;
        let t67 = t33 * cos_theta + t48 * t62 - self.constants[2] * t64;
        let t73 = self.constants[2] * t42 - sin_theta * t33 - t50 * t62;
        let t81 = (sin_phi * (t58 - t41 * t50)
            + cos_phi * (cos_theta * t67 - sin_theta * t73 - t32 * (t30 + t52))) / t19;
        let t83 = t42 + sin_theta * t81;
        let t90 = t20 * self.constants[1] * (sin_theta * t67 + cos_theta * t73);
        let t92 = t41 * self.constants[8];
        let t97 = t47 * self.constants[9] - self.constants[5] * t62;
        let t100 = t36 * cos_theta;
        let t104 = t64 + cos_theta * t81;
        let t106 = self.constants[3] * t41;
        let t125 = sin_theta
            * (self.constants[6] * t100 - self.constants[7] * t104 - t41 * t106
                - t62 * (self.constants[3] * t62 - t47 * self.constants[7]))
            + cos_theta
                * (t83 * self.constants[7] - t37 * self.constants[6]
                    - t41 * t62 * self.constants[7] - t47 * t106);
        let t126 = self.constants[0] * t125;
        let t131 = self.constants[5] * t83 + t41 * t97 - self.constants[3] * t37 - t90
            - t47 * t92 - t126;
        let t144 = t62 * self.constants[4] + self.constants[1] * (speeds[2] + t62)
            + self.constants[1] * (t26 + t62) - self.constants[5] * t47;
        let t162 = t100 * self.constants[7]
            + self.constants[3]
                * (t45 + sin_phi * self.constants[10] + self.constants[0] * (t43 + t81))
            + t62 * t97;
        let t166 = cos_theta
            * (t37 * self.constants[7] + t62 * t92 - t83 * self.constants[9]
                - t41 * t144)
            - sin_theta * (t162 - self.constants[8] * t104 - t47 * t144);
        let t169 = t90 + forces[1];
        let t172 = t21 * t169 - sin_phi * t131 - cos_phi * t166;
        let t173 = self.constants[3] * cos_theta;
        let t174 = self.constants[0] * t173;
        let t178 = self.constants[4] + self.constants[13] - t174 - t174;
        let t182 = self.constants[14] - self.constants[5] * cos_theta;
        let t184 = sin_phi * t178 + cos_phi * t182;
        let t193 = cos_phi
            * (sin_phi * t182
                + cos_phi
                    * (self.constants[9] - sin_theta * sin_theta * self.constants[11]));
        let t194 = sin_phi * self.constants[1];
        let t196 = sin_phi + t21;
        let t197 = self.constants[1] * t196;
        let t201 = sin_phi * t184 + t193 + sin_phi * t194 + t196 * t197;
        let t202 = self.constants[0].like(1.0) / t201;
        let t205 = t23 + self.constants[0].like(1.0);
        let t209 = t202 * (t184 + t194 + t197 * t205);
        let t210 = self.constants[1] * t205;
        let t212 = t201 * t209;
        let t216 = self.constants[1] + t178 + t205 * t210 - t209 * t212;
        let t217 = self.constants[0].like(1.0) / t216;
        let t221 = t23 * t169 - t131 - t172 * t209;
        let t225 = self.constants[0] * (t173 - self.constants[12]);
        let t231 = t202 * (t194 + t197 + cos_phi * self.constants[14] - sin_phi * t225);
        let t236 = t217 * (self.constants[1] + t210 - t225 - t212 * t231);
        let t251 = (t126 + t169 + forces[0] - t172 * t231 - t221 * t236)
            / (self.constants[15] - t201 * t231 * t231 - t216 * t236 * t236);
        let t253 = t217 * t221 - t236 * t251;
        let t257 = t172 * t202 - t209 * t253 - t231 * t251;
        let t258 = -(t4 * cos_psi);
        let t259 = -(t4 * sin_psi);
        (
            [
                t258, t259, speeds[0], self.constants[0].like(0.0), speeds[1], speeds[2], t26,
            ],
            [t257, t253, t251],
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
        let t21 = t17 - cos_phi * self.constants[10];
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
        let t47 = speeds[2] + speeds[0] * t42 + speeds[1] * t44;
        let t48 = speeds[1] + t47;
        let t54 = t30 + self.constants[0] * t25 * t48 - self.constants[0] * t28 - t30
            - t26 * t32;
        let t58 = t11 + speeds[1];
        let t62 = cos_theta * t17 + t32 * t58 - t27 * self.constants[2];
        let t66 = speeds[1] * t34;
        let t69 = self.constants[2] * t66 - sin_theta * t17 - t35 * t58;
        let t77 = (sin_phi * (t54 - t34 * t35)
            + cos_phi * (cos_theta * t62 - sin_theta * t69 - t16 * (t11 + t48))) / t40;
        let t79 = t27 + cos_theta * t77;
        let t82 = t34 * self.constants[3];
        let t92 = sin_theta * t21;
        let t95 = t66 + sin_theta * t77;
        let t104 = sin_theta
            * (self.constants[6] * t22 - self.constants[7] * t79 - t34 * t82
                - t58 * (t58 * self.constants[3] - self.constants[7] * t26))
            + cos_theta
                * (self.constants[7] * t95 - self.constants[6] * t92
                    - self.constants[7] * t34 * t58 - t26 * t82);
        let t105 = self.constants[0] * t104;
        let t111 = t41 * (sin_theta * t62 + cos_theta * t69);
        let t112 = self.constants[1] * t111;
        let t113 = forces[1] + t112;
        let t118 = t34 * self.constants[8];
        let t123 = t26 * self.constants[9] - t58 * self.constants[5];
        let t129 = t95 * self.constants[5] + t34 * t123 - t105 - t112
            - self.constants[3] * t92 - t26 * t118;
        let t142 = t58 * self.constants[4] + self.constants[1] * (speeds[2] + t58)
            + self.constants[1] * (t47 + t58) - t26 * self.constants[5];
        let t160 = t22 * self.constants[7]
            + self.constants[3]
                * (t30 + sin_phi * self.constants[10] + self.constants[0] * (t28 + t77))
            + t58 * t123;
        let t164 = cos_theta
            * (self.constants[7] * t92 + t58 * t118 - t95 * self.constants[9]
                - t34 * t142)
            - sin_theta * (t160 - t79 * self.constants[8] - t26 * t142);
        let t168 = t42 * t113 - sin_phi * t129 - cos_phi * t164;
        let t169 = sin_phi * self.constants[1];
        let t170 = cos_theta * self.constants[3];
        let t173 = self.constants[0] * (t170 - self.constants[12]);
        let t177 = sin_phi + t42;
        let t178 = self.constants[1] * t177;
        let t182 = self.constants[0] * t170;
        let t186 = self.constants[4] + self.constants[13] - t182 - t182;
        let t189 = self.constants[14] - cos_theta * self.constants[5];
        let t191 = sin_phi * t186 + cos_phi * t189;
        let t200 = cos_phi
            * (sin_phi * t189
                + cos_phi
                    * (self.constants[9] - sin_theta * sin_theta * self.constants[11]));
        let t205 = sin_phi * t191 + t200 + sin_phi * t169 + t177 * t178;
        let t206 = self.constants[0].like(1.0) / t205;
        let t207 = (t169 + cos_phi * self.constants[14] + t178 - sin_phi * t173) * t206;
        let t210 = t44 + self.constants[0].like(1.0);
        let t211 = self.constants[1] * t210;
        let t215 = t206 * (t169 + t191 + t178 * t210);
        let t216 = t205 * t215;
        let t225 = self.constants[1] + t186 + t210 * t211 - t215 * t216;
        let t226 = self.constants[0].like(1.0) / t225;
        let t227 = (self.constants[1] + t211 - t173 - t207 * t216) * t226;
        let t231 = t44 * t113 - t129 - t168 * t215;
        let t244 = (forces[0] + t105 + t113 - t168 * t207 - t227 * t231)
            / (self.constants[15] - t205 * t207 * t207 - t225 * t227 * t227);
        let t247 = t226 * t231 - t227 * t244;
        let t249 = self.constants[0] * (t244 + t247);
        let t253 = self.constants[0] * speeds[0] * t14;
        let t255 = sin_psi * t253 - cos_psi * t249;
        let t263 = t168 * t206 - t215 * t247 - t207 * t244;
        let t268 = t244 + t42 * t263 + t44 * t247 - t111;
        let t269 = -(t249 * sin_psi + cos_psi * t253);
        let t270 = -t77;
        [t255, t269, t263, t270, t247, t244, t268]
    }

    fn energy_unchecked(&self, positions: &[T; 7], speeds: &[T; 3]) -> [T; 2] {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let (sin_theta, cos_theta) = positions[4].sin_cos();
        let t8 = cos_theta * self.constants[3];
        let t9 = self.constants[0] * t8;
        let t13 = self.constants[4] + self.constants[13] - t9 - t9;
        let t19 = self.constants[14] - cos_theta * self.constants[5];
        let t21 = sin_phi * t13 + cos_phi * t19;
        let t32 = cos_phi
            * (sin_phi * t19
                + cos_phi
                    * (self.constants[9] - sin_theta * sin_theta * self.constants[11]));
        let t34 = sin_phi * self.constants[1];
        let t36 = sin_phi * self.constants[0];
        let t41 = (t36 + cos_phi * self.constants[2] - t36) / self.constants[0];
        let t42 = sin_phi + t41;
        let t43 = self.constants[1] * t42;
        let t52 = self.constants[0].like(1.0) + sin_phi * t41;
        let t55 = t21 + t34 + t43 * t52;
        let t59 = t8 - self.constants[12];
        let t60 = self.constants[0] * t59;
        let t65 = t34 + t43 + cos_phi * self.constants[14] - sin_phi * t60;
        let t67 = speeds[0] * (sin_phi * t21 + t32 + sin_phi * t34 + t42 * t43)
            + speeds[1] * t55;
        let t71 = self.constants[1] * t52;
        let t77 = self.constants[1] + t71 - t60;
        let t81 = speeds[1]
            * (speeds[0] * t55 + speeds[1] * (t13 + self.constants[1] + t52 * t71)
                + speeds[2] * t77);
        let t92 = (speeds[0] * (t67 + speeds[2] * t65) + t81
            + speeds[2]
                * (speeds[0] * t65 + speeds[1] * t77 + speeds[2] * self.constants[15]))
            * self.constants[0].like(0.5);
        let t99 = -(self.constants[10] * (sin_phi * self.constants[7] + cos_phi * t59));
        [t92, t99]
    }

    fn contact_forces_unchecked(&self, positions: &[T; 7], speeds: &[T; 3], forces: &[T; 2]) -> [[T; 3]; 2] {
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_theta, cos_theta) = positions[4].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t7 = speeds[0] * cos_phi;
        let t8 = sin_theta * t7;
        let t10 = t8 * self.constants[3];
        let t14 = speeds[0] * sin_phi;
        let t15 = speeds[1] + t14;
        let t18 = t7 * cos_theta;
        let t21 = self.constants[3] * t15 - t18 * self.constants[7];
        let t23 = t8 * t10 + t15 * t21;
        let t26 = speeds[1] + speeds[2];
        let t29 = t14 * self.constants[0];
        let t30 = (t14 + t26) * t29;
        let t33 = t30 - cos_phi * self.constants[10];
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
        let t56 = speeds[2] + speeds[0] * t51 + speeds[1] * t53;
        let t57 = speeds[1] + t56;
        let t63 = t40 + t7 * self.constants[0] * t57 - self.constants[0] * t38 - t40
            - t18 * t42;
        let t70 = cos_theta * t30 + t15 * t42 - t37 * self.constants[2];
        let t74 = t8 * speeds[1];
        let t77 = self.constants[2] * t74 - sin_theta * t30 - t15 * t44;
        let t85 = self.constants[0].like(1.0) / t49;
        let t86 = (sin_phi * (t63 - t8 * t44)
            + cos_phi * (cos_theta * t70 - sin_theta * t77 - t29 * (t14 + t57))) * t85;
        let t88 = t37 + cos_theta * t86;
        let t93 = sin_theta * t33;
        let t96 = t74 + sin_theta * t86;
        let t98 = t8 * self.constants[7];
        let t101 = t15 * t98 + t10 * t18;
        let t106 = self.constants[0]
            * (sin_theta * (self.constants[6] * t34 - t23 - self.constants[7] * t88)
                + cos_theta
                    * (self.constants[7] * t96 - self.constants[6] * t93 - t101));
        let t112 = t50 * (sin_theta * t70 + cos_theta * t77);
        let t113 = self.constants[1] * t112;
        let t114 = forces[1] + t113;
        let t119 = t8 * self.constants[8];
        let t124 = t18 * self.constants[9] - t15 * self.constants[5];
        let t130 = t96 * self.constants[5] + t8 * t124 - t106 - t113
            - self.constants[3] * t93 - t18 * t119;
        let t143 = t15 * self.constants[4] + self.constants[1] * (t15 + speeds[2])
            + self.constants[1] * (t15 + t56) - t18 * self.constants[5];
        let t146 = t15 * t119 - t8 * t143;
        let t156 = t40 + sin_phi * self.constants[10] + self.constants[0] * (t38 + t86);
        let t161 = self.constants[3] * t156 + t15 * t124 - t18 * t143;
        let t166 = cos_phi
            * (cos_theta * (self.constants[7] * t93 + t146 - t96 * self.constants[9])
                - sin_theta
                    * (self.constants[7] * t34 + t161 - t88 * self.constants[8]));
        let t169 = t51 * t114 - sin_phi * t130 - t166;
        let t170 = sin_phi * self.constants[1];
        let t171 = self.constants[3] * cos_theta;
        let t174 = self.constants[0] * (t171 - self.constants[12]);
        let t178 = sin_phi + t51;
        let t179 = self.constants[1] * t178;
        let t183 = self.constants[0] * t171;
        let t187 = self.constants[4] + self.constants[13] - t183 - t183;
        let t190 = self.constants[14] - cos_theta * self.constants[5];
        let t192 = sin_phi * t187 + cos_phi * t190;
        let t201 = cos_phi
            * (sin_phi * t190
                + cos_phi
                    * (self.constants[9] - sin_theta * sin_theta * self.constants[11]));
        let t206 = sin_phi * t192 + t201 + sin_phi * t170 + t178 * t179;
        let t207 = self.constants[0].like(1.0) / t206;
        let t208 = (t170 + cos_phi * self.constants[14] + t179 - sin_phi * t174) * t207;
        let t211 = t53 + self.constants[0].like(1.0);
        let t212 = self.constants[1] * t211;
        let t216 = t207 * (t170 + t192 + t179 * t211);
        let t217 = t206 * t216;
        let t226 = self.constants[1] + t187 + t211 * t212 - t216 * t217;
        let t227 = self.constants[0].like(1.0) / t226;
        let t228 = (self.constants[1] + t212 - t174 - t208 * t217) * t227;
        let t232 = t53 * t114 - t130 - t169 * t216;
        let t245 = (forces[0] + t106 + t114 - t169 * t208 - t228 * t232)
            / (self.constants[15] - t206 * t208 * t208 - t226 * t228 * t228);
        let t248 = t227 * t232 - t228 * t245;
        let t253 = t169 * t207 - t216 * t248 - t208 * t245;
        let t255 = t248 + sin_phi * t253;
        let t256 = t245 + t255;
        let t257 = self.constants[0] * t256;
        let t259 = t34 - sin_theta * t257;
        let t261 = cos_phi * t253;
        let t263 = t88 + sin_theta * t261;
        let t266 = self.constants[6] * t259 - t23 - self.constants[7] * t263;
        let t269 = t93 + cos_theta * t257;
        let t273 = cos_theta * t261 - t96;
        let t277 = self.constants[3] * t255 - t101 - self.constants[6] * t269
            - self.constants[7] * t273;
        let t285 = self.constants[1] * (t51 * t253 + t53 * t248 + t256 - t112)
            - forces[1];
        let t286 = t50 * t285;
        let t288 = sin_theta * t266 + cos_theta * t277 - t286;
        let t297 = t18 * t21 + self.constants[3] * t263 - self.constants[6] * t156
            - t8 * t98;
        let t301 = cos_theta * t266 - sin_theta * t277;
        let t303 = cos_phi * t297 - sin_phi * t301;
        let t305 = cos_psi * t288 - sin_psi * t303;
        let t308 = t288 * sin_psi + cos_psi * t303;
        let t322 = sin_theta
            * (t146 + self.constants[7] * t269 + self.constants[9] * t273
                - self.constants[5] * t255)
            + cos_theta * (t161 + self.constants[7] * t259 - self.constants[8] * t263);
        let t324 = t85 * (t322 + self.constants[0] * t297);
        let t328 = sin_phi * t297 + cos_phi * t301 - t324;
        let t329 = cos_psi * t286;
        let t330 = t286 * sin_psi;
        [[t305, t308, t328], [t329, t330, t324]]
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
