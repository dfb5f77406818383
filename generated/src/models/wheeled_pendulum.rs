// @generated from generated/models/wheeled_pendulum.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: b992785cfa4d8bcd

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    MotionFormulas, Nonlinear, Number, ParameterError, ParameterInfo, Partial, Rate,
    Rows, Scalar, SetInfo, States, WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A pendulum upside down on two wheels, as balancing robots and the Segway are: it stands only where a motor balances it.
///
/// Two wheels on one axle that roll without slip, and a body above it. The motors act between body and wheels; forward
/// motion, pitch and yaw take part. A positive torque, about y, drives a wheel backward and pitches the body forward.
/// In the matrices `x` is of a point of the body, as declared; in the nonlinear equations `x` and `y` are of where the left wheel
/// touches the ground, to first order `x - r*theta + b*psi` of that `x`.
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
    /// 13 additions, 9 multiplications, 1 division and 2 negations: 25 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WheeledPendulumMatrices<T> {
        let t2 = self.mW + self.mW;
        let t4 = self.m.like(1.0) / self.r;
        let t6 = self.Ia + self.Ia;
        let t7 = t4 * t6;
        let t9 = t2 + t4 * t7;
        let M_11 = self.m + t9;
        let t11 = t2 * self.r;
        let t13 = self.r + self.l;
        let t14 = self.m * t13;
        let zero = self.m.like(0.0);
        let m_all = t6 + t13 * t14;
        let M_22 = self.r * t11 + (m_all + self.Iyy);
        let M_33 = self.Izz + (self.b * t9 * self.b + self.Ir) + self.Ir;
        let M_12 = -(t11 + (t7 + t14));
        let K0_22 = -(self.m * self.l);
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
/// - linearization: 278 additions, 382 multiplications, 5 divisions, 4 negations and 6 trigonometric functions: 675 operations
/// - by parameters: 394 additions, 568 multiplications, 5 divisions, 11 negations and 6 trigonometric functions: 984 operations
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheeledPendulumMotion<T = f64> {
    constants: [T; 20],
}

impl<T: Number> WheeledPendulum<T> {
    /// The nonlinear equations of motion, of what is computed once for these parameters:
    /// 15 additions and 10 multiplications: 25 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn motion(&self) -> WheeledPendulumMotion<T> {
        let t6 = self.b + self.b;
        let t8 = self.r - self.r - self.l;
        let t9 = self.m * t8;
        let t11 = t8 * t9;
        let t12 = self.Iyy + t11;
        let t13 = self.b * self.m;
        let t14 = t8 * t13;
        let t16 = self.m + self.mW + self.mW;
        let t17 = self.mW * t6;
        let t18 = t13 + t17;
        let t24 = self.Ir + self.Ir + t6 * t17 + self.b * t13;
        let t25 = t11 + t24;
        let t27 = t24 + self.Izz;
        let t29 = t27 - t25;
        let t30 = self.r * t16;
        let t31 = self.r * t30;
        let t32 = self.r * t18;
        let t34 = self.Ia + self.Ia + t31;
        WheeledPendulumMotion {
            constants: [
                self.b, self.r, self.m, self.l, self.Ia, self.mW, t6, t9, t12, t14, t16, t18, t25,
                t27, self.g, t29, t30, t31, t32, t34,
            ],
        }
    }
}

impl<T: Scalar> Nonlinear<3> for WheeledPendulum<T> {
    type Motion = WheeledPendulumMotion<T>;

    type MotionOver<U: Number> = WheeledPendulumMotion<U>;

    fn motion(&self) -> WheeledPendulumMotion<T> {
        WheeledPendulum::motion(self)
    }

    #[inline(always)]
    fn motion_over<U: Number>(model: &WheeledPendulum<U>) -> WheeledPendulumMotion<U> {
        WheeledPendulum::motion(model)
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
                name: "TL", label: "torque of the left motor", unit: "N*m", position: "thetaL",
            },
            carvallo::motion::AppliedInfo {
                name: "TR", label: "torque of the right motor", unit: "N*m", position: "thetaR",
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

    fn linearize_into(
        &self, positions: &[T; 7], speeds: &[T; 3], forces: &[T; 2], a: &mut [T], b: &mut [T],
    ) -> Option<Result<(), carvallo::motion::MotionError>> {
        let found = carvallo::motion::Linearizable::linearize(self, positions, speeds, forces);
        Some(found.map(|found| carvallo::motion::Linearization::copy_into(&found, a, b)))
    }
}

#[allow(unused_variables)]
impl<T: Number> carvallo::motion::Unchecked for WheeledPendulumMotion<T> {
    type Scalar = T;

    type Positions = [T; 7];

    type Speeds = [T; 3];

    type Dependent = [T; 1];

    type Forces = [T; 2];

    type ContactForces = [[T; 3]; 2];

    #[inline(always)]
    fn closure_unchecked(&self, positions: &[T; 7]) -> ([T; 1], [T; 1]) {
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t3 = self.constants[1] * cos_phi;
        let t8 = t3 + sin_phi * self.constants[6] - t3;
        let t9 = self.constants[1] * sin_phi;
        let t14 = -(t8 / (t9 + cos_phi * self.constants[6] - t9));
        ([t8], [t14])
    }

    #[inline(always)]
    fn rates_unchecked(&self, positions: &[T; 7], speeds: &[T; 3]) -> [T; 7] {
        let t4 = self.constants[1] * (speeds[1] + speeds[2]);
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t14 = self.constants[1] * sin_phi;
        let t20 = (t14 + cos_phi * self.constants[6] - t14) / self.constants[1];
        let t25 = speeds[2] + speeds[0] * t20 + speeds[1] * sin_phi * t20;
        let t26 = -(t4 * cos_psi);
        let t27 = -(t4 * sin_psi);
        [t26, t27, speeds[0], self.constants[0].like(0.0), speeds[1], speeds[2], t25]
    }

    #[inline(always)]
    fn derivatives_unchecked(&self, positions: &[T; 7], speeds: &[T; 3], forces: &[T; 2]) -> ([T; 7], [T; 3]) {
        let t3 = speeds[1] + speeds[2];
        let t4 = self.constants[1] * t3;
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t14 = self.constants[1] * sin_phi;
        let t19 = t14 + cos_phi * self.constants[6] - t14;
        let t20 = self.constants[0].like(1.0) / self.constants[1];
        let t21 = t19 * t20;
        let t23 = sin_phi * t21;
        let t26 = speeds[2] + speeds[0] * t21 + speeds[1] * t23;
        let (sin_theta, cos_theta) = positions[4].sin_cos();
        let t30 = speeds[0] * sin_phi;
        let t32 = self.constants[1] * t30;
        let t33 = (t3 + t30) * t32;
        let t36 = t33 - cos_phi * self.constants[14];
        let t37 = sin_theta * t36;
        let t40 = speeds[0] * cos_phi;
        let t41 = sin_theta * t40;
        let t42 = speeds[1] * t41;
        let t43 = t3 * t40;
        let t45 = t32 * t40;
        let t47 = t40 * cos_theta;
        let t48 = self.constants[6] * t47;
        let t50 = self.constants[6] * t41;
        let t52 = speeds[1] + t26;
        let t58 = t45 + self.constants[1] * t40 * t52 - self.constants[1] * t43 - t45
            - t47 * t48;
        let t62 = speeds[1] + t30;
        let t64 = speeds[1] * t47;
        let t67 = t33 * cos_theta + t48 * t62 - self.constants[6] * t64;
        let t73 = self.constants[6] * t42 - sin_theta * t33 - t50 * t62;
        let t81 = (sin_phi * (t58 - t41 * t50)
            + cos_phi * (cos_theta * t67 - sin_theta * t73 - t32 * (t30 + t52))) / t19;
        let t83 = t42 + sin_theta * t81;
        let t90 = t20 * self.constants[4] * (sin_theta * t67 + cos_theta * t73);
        let t92 = t41 * self.constants[12];
        let t97 = t47 * self.constants[13] - self.constants[9] * t62;
        let t100 = t36 * cos_theta;
        let t104 = t64 + cos_theta * t81;
        let t106 = self.constants[7] * t41;
        let t125 = sin_theta
            * (self.constants[10] * t100 - self.constants[11] * t104 - t41 * t106
                - t62 * (self.constants[7] * t62 - t47 * self.constants[11]))
            + cos_theta
                * (t83 * self.constants[11] - t37 * self.constants[10]
                    - t41 * t62 * self.constants[11] - t47 * t106);
        let t126 = self.constants[1] * t125;
        let t131 = self.constants[9] * t83 + t41 * t97 - self.constants[7] * t37 - t90
            - t47 * t92 - t126;
        let t144 = t62 * self.constants[8] + self.constants[4] * (speeds[2] + t62)
            + self.constants[4] * (t26 + t62) - self.constants[9] * t47;
        let t162 = t100 * self.constants[11]
            + self.constants[7]
                * (t45 + sin_phi * self.constants[14] + self.constants[1] * (t43 + t81))
            + t62 * t97;
        let t166 = cos_theta
            * (t37 * self.constants[11] + t62 * t92 - t83 * self.constants[13]
                - t41 * t144)
            - sin_theta * (t162 - self.constants[12] * t104 - t47 * t144);
        let t169 = t90 + forces[1];
        let t172 = t21 * t169 - sin_phi * t131 - cos_phi * t166;
        let t173 = self.constants[7] * cos_theta;
        let t174 = self.constants[1] * t173;
        let t178 = self.constants[8] + self.constants[17] - t174 - t174;
        let t182 = self.constants[18] - self.constants[9] * cos_theta;
        let t184 = sin_phi * t178 + cos_phi * t182;
        let t193 = cos_phi
            * (sin_phi * t182
                + cos_phi
                    * (self.constants[13] - sin_theta * sin_theta * self.constants[15]));
        let t194 = sin_phi * self.constants[4];
        let t196 = sin_phi + t21;
        let t197 = self.constants[4] * t196;
        let t201 = sin_phi * t184 + t193 + sin_phi * t194 + t196 * t197;
        let t202 = self.constants[0].like(1.0) / t201;
        let t205 = t23 + self.constants[0].like(1.0);
        let t209 = t202 * (t184 + t194 + t197 * t205);
        let t210 = self.constants[4] * t205;
        let t212 = t201 * t209;
        let t216 = self.constants[4] + t178 + t205 * t210 - t209 * t212;
        let t217 = self.constants[0].like(1.0) / t216;
        let t221 = t23 * t169 - t131 - t172 * t209;
        let t225 = self.constants[1] * (t173 - self.constants[16]);
        let t231 = t202 * (t194 + t197 + cos_phi * self.constants[18] - sin_phi * t225);
        let t236 = t217 * (self.constants[4] + t210 - t225 - t212 * t231);
        let t251 = (t126 + t169 + forces[0] - t172 * t231 - t221 * t236)
            / (self.constants[19] - t201 * t231 * t231 - t216 * t236 * t236);
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

    #[inline(always)]
    fn accelerations_unchecked(&self, positions: &[T; 7], speeds: &[T; 3], forces: &[T; 2]) -> [T; 7] {
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_theta, cos_theta) = positions[4].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t11 = speeds[0] * sin_phi;
        let t14 = speeds[1] + speeds[2];
        let t16 = self.constants[1] * t11;
        let t17 = (t11 + t14) * t16;
        let t21 = t17 - cos_phi * self.constants[14];
        let t22 = cos_theta * t21;
        let t25 = speeds[0] * cos_phi;
        let t26 = cos_theta * t25;
        let t27 = speeds[1] * t26;
        let t28 = t14 * t25;
        let t30 = t16 * t25;
        let t32 = t26 * self.constants[6];
        let t34 = sin_theta * t25;
        let t35 = self.constants[6] * t34;
        let t37 = self.constants[1] * sin_phi;
        let t40 = t37 + cos_phi * self.constants[6] - t37;
        let t41 = self.constants[0].like(1.0) / self.constants[1];
        let t42 = t40 * t41;
        let t44 = sin_phi * t42;
        let t47 = speeds[2] + speeds[0] * t42 + speeds[1] * t44;
        let t48 = speeds[1] + t47;
        let t54 = t30 + self.constants[1] * t25 * t48 - self.constants[1] * t28 - t30
            - t26 * t32;
        let t58 = t11 + speeds[1];
        let t62 = cos_theta * t17 + t32 * t58 - t27 * self.constants[6];
        let t66 = speeds[1] * t34;
        let t69 = self.constants[6] * t66 - sin_theta * t17 - t35 * t58;
        let t77 = (sin_phi * (t54 - t34 * t35)
            + cos_phi * (cos_theta * t62 - sin_theta * t69 - t16 * (t11 + t48))) / t40;
        let t79 = t27 + cos_theta * t77;
        let t82 = t34 * self.constants[7];
        let t92 = sin_theta * t21;
        let t95 = t66 + sin_theta * t77;
        let t104 = sin_theta
            * (self.constants[10] * t22 - self.constants[11] * t79 - t34 * t82
                - t58 * (t58 * self.constants[7] - self.constants[11] * t26))
            + cos_theta
                * (self.constants[11] * t95 - self.constants[10] * t92
                    - self.constants[11] * t34 * t58 - t26 * t82);
        let t105 = self.constants[1] * t104;
        let t111 = t41 * (sin_theta * t62 + cos_theta * t69);
        let t112 = self.constants[4] * t111;
        let t113 = forces[1] + t112;
        let t118 = t34 * self.constants[12];
        let t123 = t26 * self.constants[13] - t58 * self.constants[9];
        let t129 = t95 * self.constants[9] + t34 * t123 - t105 - t112
            - self.constants[7] * t92 - t26 * t118;
        let t142 = t58 * self.constants[8] + self.constants[4] * (speeds[2] + t58)
            + self.constants[4] * (t47 + t58) - t26 * self.constants[9];
        let t160 = t22 * self.constants[11]
            + self.constants[7]
                * (t30 + sin_phi * self.constants[14] + self.constants[1] * (t28 + t77))
            + t58 * t123;
        let t164 = cos_theta
            * (self.constants[11] * t92 + t58 * t118 - t95 * self.constants[13]
                - t34 * t142)
            - sin_theta * (t160 - t79 * self.constants[12] - t26 * t142);
        let t168 = t42 * t113 - sin_phi * t129 - cos_phi * t164;
        let t169 = sin_phi * self.constants[4];
        let t170 = cos_theta * self.constants[7];
        let t173 = self.constants[1] * (t170 - self.constants[16]);
        let t177 = sin_phi + t42;
        let t178 = self.constants[4] * t177;
        let t182 = self.constants[1] * t170;
        let t186 = self.constants[8] + self.constants[17] - t182 - t182;
        let t189 = self.constants[18] - cos_theta * self.constants[9];
        let t191 = sin_phi * t186 + cos_phi * t189;
        let t200 = cos_phi
            * (sin_phi * t189
                + cos_phi
                    * (self.constants[13] - sin_theta * sin_theta * self.constants[15]));
        let t205 = sin_phi * t191 + t200 + sin_phi * t169 + t177 * t178;
        let t206 = self.constants[0].like(1.0) / t205;
        let t207 = (t169 + cos_phi * self.constants[18] + t178 - sin_phi * t173) * t206;
        let t210 = t44 + self.constants[0].like(1.0);
        let t211 = self.constants[4] * t210;
        let t215 = t206 * (t169 + t191 + t178 * t210);
        let t216 = t205 * t215;
        let t225 = self.constants[4] + t186 + t210 * t211 - t215 * t216;
        let t226 = self.constants[0].like(1.0) / t225;
        let t227 = (self.constants[4] + t211 - t173 - t207 * t216) * t226;
        let t231 = t44 * t113 - t129 - t168 * t215;
        let t244 = (forces[0] + t105 + t113 - t168 * t207 - t227 * t231)
            / (self.constants[19] - t205 * t207 * t207 - t225 * t227 * t227);
        let t247 = t226 * t231 - t227 * t244;
        let t249 = self.constants[1] * (t244 + t247);
        let t253 = self.constants[1] * speeds[0] * t14;
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
        let t8 = cos_theta * self.constants[7];
        let t9 = self.constants[1] * t8;
        let t13 = self.constants[8] + self.constants[17] - t9 - t9;
        let t19 = self.constants[18] - cos_theta * self.constants[9];
        let t21 = sin_phi * t13 + cos_phi * t19;
        let t32 = cos_phi
            * (sin_phi * t19
                + cos_phi
                    * (self.constants[13] - sin_theta * sin_theta * self.constants[15]));
        let t34 = sin_phi * self.constants[4];
        let t36 = sin_phi * self.constants[1];
        let t41 = (t36 + cos_phi * self.constants[6] - t36) / self.constants[1];
        let t42 = sin_phi + t41;
        let t43 = self.constants[4] * t42;
        let t52 = self.constants[0].like(1.0) + sin_phi * t41;
        let t55 = t21 + t34 + t43 * t52;
        let t59 = t8 - self.constants[16];
        let t60 = self.constants[1] * t59;
        let t65 = t34 + t43 + cos_phi * self.constants[18] - sin_phi * t60;
        let t67 = speeds[0] * (sin_phi * t21 + t32 + sin_phi * t34 + t42 * t43)
            + speeds[1] * t55;
        let t71 = self.constants[4] * t52;
        let t77 = self.constants[4] + t71 - t60;
        let t81 = speeds[1]
            * (speeds[0] * t55 + speeds[1] * (t13 + self.constants[4] + t52 * t71)
                + speeds[2] * t77);
        let t92 = (speeds[0] * (t67 + speeds[2] * t65) + t81
            + speeds[2]
                * (speeds[0] * t65 + speeds[1] * t77 + speeds[2] * self.constants[19]))
            * self.constants[0].like(0.5);
        let t99 = -(self.constants[14] * (sin_phi * self.constants[11] + cos_phi * t59));
        [t92, t99]
    }

    fn contact_forces_unchecked(&self, positions: &[T; 7], speeds: &[T; 3], forces: &[T; 2]) -> [[T; 3]; 2] {
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let (sin_theta, cos_theta) = positions[4].sin_cos();
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t7 = speeds[0] * cos_phi;
        let t8 = sin_theta * t7;
        let t10 = t8 * self.constants[7];
        let t14 = speeds[0] * sin_phi;
        let t15 = speeds[1] + t14;
        let t18 = t7 * cos_theta;
        let t21 = self.constants[7] * t15 - t18 * self.constants[11];
        let t23 = t8 * t10 + t15 * t21;
        let t26 = speeds[1] + speeds[2];
        let t29 = t14 * self.constants[1];
        let t30 = (t14 + t26) * t29;
        let t33 = t30 - cos_phi * self.constants[14];
        let t34 = cos_theta * t33;
        let t37 = speeds[1] * t18;
        let t38 = t7 * t26;
        let t40 = t7 * t29;
        let t42 = t18 * self.constants[6];
        let t44 = t8 * self.constants[6];
        let t46 = sin_phi * self.constants[1];
        let t49 = t46 + cos_phi * self.constants[6] - t46;
        let t50 = self.constants[0].like(1.0) / self.constants[1];
        let t51 = t49 * t50;
        let t53 = sin_phi * t51;
        let t56 = speeds[2] + speeds[0] * t51 + speeds[1] * t53;
        let t57 = speeds[1] + t56;
        let t63 = t40 + t7 * self.constants[1] * t57 - self.constants[1] * t38 - t40
            - t18 * t42;
        let t70 = cos_theta * t30 + t15 * t42 - t37 * self.constants[6];
        let t74 = t8 * speeds[1];
        let t77 = self.constants[6] * t74 - sin_theta * t30 - t15 * t44;
        let t85 = self.constants[0].like(1.0) / t49;
        let t86 = (sin_phi * (t63 - t8 * t44)
            + cos_phi * (cos_theta * t70 - sin_theta * t77 - t29 * (t14 + t57))) * t85;
        let t88 = t37 + cos_theta * t86;
        let t93 = sin_theta * t33;
        let t96 = t74 + sin_theta * t86;
        let t98 = t8 * self.constants[11];
        let t101 = t15 * t98 + t10 * t18;
        let t106 = self.constants[1]
            * (sin_theta * (self.constants[10] * t34 - t23 - self.constants[11] * t88)
                + cos_theta
                    * (self.constants[11] * t96 - self.constants[10] * t93 - t101));
        let t112 = t50 * (sin_theta * t70 + cos_theta * t77);
        let t113 = self.constants[4] * t112;
        let t114 = forces[1] + t113;
        let t119 = t8 * self.constants[12];
        let t124 = t18 * self.constants[13] - t15 * self.constants[9];
        let t130 = t96 * self.constants[9] + t8 * t124 - t106 - t113
            - self.constants[7] * t93 - t18 * t119;
        let t143 = t15 * self.constants[8] + self.constants[4] * (t15 + speeds[2])
            + self.constants[4] * (t15 + t56) - t18 * self.constants[9];
        let t146 = t15 * t119 - t8 * t143;
        let t156 = t40 + sin_phi * self.constants[14] + self.constants[1] * (t38 + t86);
        let t161 = self.constants[7] * t156 + t15 * t124 - t18 * t143;
        let t166 = cos_phi
            * (cos_theta * (self.constants[11] * t93 + t146 - t96 * self.constants[13])
                - sin_theta
                    * (self.constants[11] * t34 + t161 - t88 * self.constants[12]));
        let t169 = t51 * t114 - sin_phi * t130 - t166;
        let t170 = sin_phi * self.constants[4];
        let t171 = self.constants[7] * cos_theta;
        let t174 = self.constants[1] * (t171 - self.constants[16]);
        let t178 = sin_phi + t51;
        let t179 = self.constants[4] * t178;
        let t183 = self.constants[1] * t171;
        let t187 = self.constants[8] + self.constants[17] - t183 - t183;
        let t190 = self.constants[18] - cos_theta * self.constants[9];
        let t192 = sin_phi * t187 + cos_phi * t190;
        let t201 = cos_phi
            * (sin_phi * t190
                + cos_phi
                    * (self.constants[13] - sin_theta * sin_theta * self.constants[15]));
        let t206 = sin_phi * t192 + t201 + sin_phi * t170 + t178 * t179;
        let t207 = self.constants[0].like(1.0) / t206;
        let t208 = (t170 + cos_phi * self.constants[18] + t179 - sin_phi * t174) * t207;
        let t211 = t53 + self.constants[0].like(1.0);
        let t212 = self.constants[4] * t211;
        let t216 = t207 * (t170 + t192 + t179 * t211);
        let t217 = t206 * t216;
        let t226 = self.constants[4] + t187 + t211 * t212 - t216 * t217;
        let t227 = self.constants[0].like(1.0) / t226;
        let t228 = (self.constants[4] + t212 - t174 - t208 * t217) * t227;
        let t232 = t53 * t114 - t130 - t169 * t216;
        let t245 = (forces[0] + t106 + t114 - t169 * t208 - t228 * t232)
            / (self.constants[19] - t206 * t208 * t208 - t226 * t228 * t228);
        let t248 = t227 * t232 - t228 * t245;
        let t253 = t169 * t207 - t216 * t248 - t208 * t245;
        let t255 = t248 + sin_phi * t253;
        let t256 = t245 + t255;
        let t257 = self.constants[1] * t256;
        let t259 = t34 - sin_theta * t257;
        let t261 = cos_phi * t253;
        let t263 = t88 + sin_theta * t261;
        let t266 = self.constants[10] * t259 - t23 - self.constants[11] * t263;
        let t269 = t93 + cos_theta * t257;
        let t273 = cos_theta * t261 - t96;
        let t277 = self.constants[7] * t255 - t101 - self.constants[10] * t269
            - self.constants[11] * t273;
        let t285 = self.constants[4] * (t51 * t253 + t53 * t248 + t256 - t112)
            - forces[1];
        let t286 = t50 * t285;
        let t288 = sin_theta * t266 + cos_theta * t277 - t286;
        let t297 = t18 * t21 + self.constants[7] * t263 - self.constants[10] * t156
            - t8 * t98;
        let t301 = cos_theta * t266 - sin_theta * t277;
        let t303 = cos_phi * t297 - sin_phi * t301;
        let t305 = cos_psi * t288 - sin_psi * t303;
        let t308 = t288 * sin_psi + cos_psi * t303;
        let t322 = sin_theta
            * (t146 + self.constants[11] * t269 + self.constants[13] * t273
                - self.constants[9] * t255)
            + cos_theta * (t161 + self.constants[11] * t259 - self.constants[12] * t263);
        let t324 = t85 * (t322 + self.constants[1] * t297);
        let t328 = sin_phi * t297 + cos_phi * t301 - t324;
        let t329 = cos_psi * t286;
        let t330 = t286 * sin_psi;
        [[t305, t308, t328], [t329, t330, t324]]
    }
}

#[allow(unused_variables)]
impl<T: Scalar> carvallo::motion::UncheckedPartials for WheeledPendulumMotion<T> {
    type State = [T; 10];

    type ByState = [[T; 10]; 10];

    type ByForces = [[T; 2]; 10];

    type Parameters = [T; 10];

    type ByParameters = [[T; 10]; 10];

    fn linearize_unchecked(
        &self, positions: &[T; 7], speeds: &[T; 3], forces: &[T; 2],
    ) -> ([[T; 10]; 10], [[T; 2]; 10]) {
        let zero = self.constants[0].like(0.0);
        let t4 = speeds[1] + speeds[2];
        let t5 = self.constants[1] * t4;
        let (sin_psi, cos_psi) = positions[2].sin_cos();
        let t8 = t5 * sin_psi;
        let (sin_phi, cos_phi) = positions[3].sin_cos();
        let t16 = self.constants[1] * sin_phi;
        let t21 = t16 + cos_phi * self.constants[6] - t16;
        let t22 = self.constants[0].like(1.0) / self.constants[1];
        let t23 = t21 * t22;
        let t24 = sin_phi * t23;
        let (sin_theta, cos_theta) = positions[4].sin_cos();
        let t29 = cos_theta * self.constants[7];
        let t30 = self.constants[1] * t29;
        let t34 = self.constants[8] + self.constants[17] - t30 - t30;
        let t39 = self.constants[18] - cos_theta * self.constants[9];
        let t41 = sin_phi * t34 + cos_phi * t39;
        let t52 = cos_phi
            * (sin_phi * t39
                + cos_phi
                    * (self.constants[13] - sin_theta * sin_theta * self.constants[15]));
        let t54 = sin_phi * self.constants[4];
        let t56 = sin_phi + t23;
        let t57 = self.constants[4] * t56;
        let t61 = sin_phi * t41 + t52 + sin_phi * t54 + t56 * t57;
        let t62 = self.constants[0].like(1.0) / t61;
        let t64 = sin_phi * speeds[0];
        let t65 = self.constants[1] * t64;
        let t66 = cos_phi * speeds[0];
        let t67 = t65 * t66;
        let t70 = t4 * t66;
        let t72 = cos_theta * t66;
        let t73 = self.constants[6] * t72;
        let t75 = sin_theta * t66;
        let t76 = self.constants[6] * t75;
        let t81 = speeds[2] + t23 * speeds[0] + speeds[1] * t24;
        let t82 = speeds[1] + t81;
        let t88 = t67 + self.constants[1] * t66 * t82 - self.constants[1] * t70 - t67
            - t72 * t73;
        let t91 = t4 + t64;
        let t92 = t91 * t65;
        let t93 = cos_theta * t92;
        let t94 = speeds[1] + t64;
        let t96 = speeds[1] * t72;
        let t99 = t93 + t73 * t94 - self.constants[6] * t96;
        let t101 = sin_theta * t92;
        let t103 = speeds[1] * t75;
        let t106 = self.constants[6] * t103 - t101 - t76 * t94;
        let t108 = cos_theta * t99 - sin_theta * t106;
        let t109 = t64 + t82;
        let t114 = self.constants[0].like(1.0) / t21;
        let t115 = (sin_phi * (t88 - t75 * t76) + cos_phi * (t108 - t65 * t109)) * t114;
        let t121 = self.constants[9] * t94;
        let t123 = self.constants[13] * t72 - t121;
        let t133 = self.constants[8] * t94 + self.constants[4] * (speeds[2] + t94)
            + self.constants[4] * (t81 + t94) - self.constants[9] * t72;
        let t136 = self.constants[7]
            * (t67 + sin_phi * self.constants[14] + self.constants[1] * (t70 + t115))
            + t94 * t123 - t72 * t133;
        let t139 = t92 - cos_phi * self.constants[14];
        let t140 = cos_theta * t139;
        let t145 = t96 + cos_theta * t115;
        let t147 = self.constants[7] * t75;
        let t149 = self.constants[7] * t94;
        let t151 = t149 - self.constants[11] * t72;
        let t153 = t75 * t147 + t94 * t151;
        let t157 = sin_theta * t139;
        let t159 = sin_theta * t115;
        let t160 = t103 + t159;
        let t162 = self.constants[11] * t75;
        let t165 = t94 * t162 + t72 * t147;
        let t170 = self.constants[1]
            * (sin_theta * (t140 * self.constants[10] - self.constants[11] * t145 - t153)
                + cos_theta
                    * (self.constants[11] * t160 - self.constants[10] * t157 - t165));
        let t175 = t22 * self.constants[4];
        let t176 = (sin_theta * t99 + cos_theta * t106) * t175;
        let t177 = forces[1] + t176;
        let t181 = t75 * self.constants[12];
        let t188 = self.constants[9] * t160 + t75 * t123 - t170 - t176
            - self.constants[7] * t157 - t72 * t181;
        let t194 = t94 * t181 - t75 * t133;
        let t204 = cos_phi
            * (cos_theta * (self.constants[11] * t157 + t194 - self.constants[13] * t160)
                - sin_theta
                    * (self.constants[11] * t140 + t136 - t145 * self.constants[12]));
        let t207 = t23 * t177 - sin_phi * t188 - t204;
        let t210 = self.constants[1] * (t29 - self.constants[16]);
        let t216 = t62 * (t54 + t57 + cos_phi * self.constants[18] - sin_phi * t210);
        let t218 = self.constants[0].like(1.0) + t24;
        let t219 = self.constants[4] * t218;
        let t223 = t62 * (t41 + t54 + t57 * t218);
        let t224 = t61 * t223;
        let t233 = t34 + self.constants[4] + t218 * t219 - t223 * t224;
        let t234 = self.constants[0].like(1.0) / t233;
        let t235 = (self.constants[4] + t219 - t210 - t216 * t224) * t234;
        let t239 = t24 * t177 - t188 - t207 * t223;
        let t252 = self.constants[0].like(1.0)
            / (self.constants[19] - t61 * t216 * t216 - t233 * t235 * t235);
        let t253 = (forces[0] + t170 + t177 - t207 * t216 - t235 * t239) * t252;
        let t256 = t234 * t239 - t235 * t253;
        let t261 = t62 * t207 - t223 * t256 - t216 * t253;
        let t263 = t256 + sin_phi * t261;
        let t265 = self.constants[1] * (t253 + t263);
        let t267 = t140 - sin_theta * t265;
        let t269 = cos_phi * t261;
        let t271 = t145 + sin_theta * t269;
        let t273 = sin_theta * self.constants[11];
        let t280 = t157 + cos_theta * t265;
        let t284 = cos_theta * t269 - t159;
        let t285 = t284 - t103;
        let t292 = sin_theta
            * (t194 + self.constants[11] * t280 + self.constants[13] * t285
                - self.constants[9] * t263 - t139 * t273);
        let t293 = cos_theta * self.constants[11];
        let t295 = sin_theta * self.constants[12];
        let t302 = sin_theta * t72 - cos_theta * t75;
        let t306 = speeds[1] * t295 - sin_theta * (self.constants[13] * t94 - t133)
            - self.constants[9] * t302;
        let t308 = cos_theta
            * (self.constants[12] * t271 + t265 * t273 - t136
                - self.constants[11] * t267) + t267 * t293;
        let t315 = cos_phi * cos_theta;
        let t316 = (t94 * self.constants[12] - t133) * t315;
        let t318 = t23 * t175;
        let t322 = self.constants[6] * t94 - speeds[1] * self.constants[6];
        let t324 = t101 + t75 * t322;
        let t326 = cos_theta * t322;
        let t330 = t108 - cos_theta * t93 - sin_theta * t324 - t72 * t326;
        let t334 = self.constants[13] * t75 - t181;
        let t337 = t123 - t72 * self.constants[12];
        let t342 = sin_theta * self.constants[10];
        let t356 = sin_theta
            * (self.constants[7] * t263 + t139 * t342 - t165 - self.constants[10] * t280
                - self.constants[11] * t285);
        let t357 = cos_theta * self.constants[10];
        let t361 = self.constants[11] * t94;
        let t365 = sin_theta * t361 - cos_theta * t147 - speeds[1] * t273;
        let t372 = cos_theta * (t361 + self.constants[7] * t72)
            + sin_theta * (t147 + t147);
        let t374 = cos_theta
            * (self.constants[10] * t267 - t153 - self.constants[11] * t271
                - t265 * t342) - t356;
        let t379 = self.constants[1]
            * (t374 - t267 * t357 - t273 * t284 - t75 * t365 - t72 * t372);
        let t380 = t175 * t330 + t379;
        let t383 = t72 * t337 - self.constants[7] * t267 - t75 * t334 - t380;
        let t386 = self.constants[1] * t293;
        let t387 = t386 - self.constants[9];
        let t389 = self.constants[13] * t315 + sin_phi * t387;
        let t392 = cos_phi * sin_theta;
        let t395 = sin_phi * (t73 + t73);
        let t402 = sin_phi * (t76 + t76) - t322 * t392;
        let t408 = t75 * t395 + t93 * t392 - t106 * t315 - t99 * t392 - t315 * t324
            - t72 * t402;
        let t409 = self.constants[1] * self.constants[7];
        let t410 = sin_theta * t114;
        let t412 = cos_theta * t114;
        let t417 = self.constants[1] * t273 * t412;
        let t421 = t389 * t410 - cos_phi * (t295 * t412 - t409 * t410) - sin_phi * t417;
        let t425 = t318 * t330 + t271 * t389 + t408 * t421
            - cos_phi * (t308 + t284 * t295 - t292 - t75 * t306);
        let t427 = t425 - t72 * t316 - sin_phi * t383;
        let t429 = t24 * t175;
        let t433 = t387 * t410 - t417;
        let t439 = t330 * t429 + t271 * t387 + t408 * t433 - t383 - t223 * t427;
        let t443 = t386 * t410 - t417;
        let t451 = t252 * (t380 + t271 * t386 + t408 * t443 - t216 * t427 - t235 * t439);
        let t453 = t234 * t439 - t235 * t451;
        let t457 = t62 * t427 - t223 * t453 - t216 * t451;
        let t458 = t16 * t66;
        let t474 = cos_theta * t181
            + t302 * (self.constants[8] + self.constants[4] + self.constants[4])
            - sin_theta * (t123 - t121);
        let t478 = sin_phi * (t65 + self.constants[1] * t91);
        let t481 = sin_theta * t293 - cos_theta * t273;
        let t485 = t306 * t315 + sin_phi * t474 + t478 * t481
            - sin_theta
                * (self.constants[7] * t458
                    + cos_phi * (t4 * t409 + self.constants[7] * t65));
        let t490 = t315 * t322 + sin_phi * t73;
        let t492 = sin_phi * t76;
        let t496 = sin_theta * t490 - cos_theta * t492 - t326 * t392;
        let t499 = self.constants[9] * t75;
        let t501 = self.constants[7] * sin_theta;
        let t509 = cos_theta * t162 + sin_theta * (t149 + t151);
        let t513 = cos_theta * t342 - sin_theta * t357;
        let t520 = t175 * t496
            + self.constants[1]
                * (t315 * t365 + t478 * t513 - sin_phi * t509 - t372 * t392);
        let t524 = t315 * t334 + t337 * t392 - sin_phi * t499 - t478 * t501 - t520;
        let t526 = speeds[1] * t392;
        let t541 = cos_theta * t315 + sin_theta * t392;
        let t546 = cos_phi * (t16 * t82 - t5 * sin_phi) + t315 * t490 + t392 * t492
            + t478 * t541;
        let t549 = t546 - sin_phi * cos_phi * (t65 + self.constants[1] * t109)
            - t315 * t395 - t392 * t402;
        let t552 = cos_phi * self.constants[4] * t302;
        let t554 = t458 - cos_phi * t65;
        let t556 = t421 * t554 - t552;
        let t562 = t318 * t496 + t389 * t526 + t421 * t549 + t23 * t556 - cos_phi * t485
            - t316 * t392;
        let t563 = t562 - sin_phi * t524;
        let t568 = t433 * t554;
        let t575 = t429 * t496 + t387 * t526 + t433 * t549 + t23 * t568 - t524
            - t223 * t563;
        let t579 = t443 * t554;
        let t587 = t520 + t386 * t526 + t443 * t549 + t23 * t579 - t216 * t563
            - t235 * t575;
        let t588 = t252 * t587;
        let t590 = t234 * t575 - t235 * t588;
        let t594 = t62 * t563 - t223 * t590 - t216 * t588;
        let t601 = cos_phi * (t65 * t481 - t75 * t409);
        let t602 = t65 * t501;
        let t604 = t65 * t513;
        let t607 = self.constants[1] * (t604 - t509 - t72 * t273);
        let t609 = t499 + t602 + t607;
        let t613 = t65 * t541 - t458;
        let t614 = t554 + t613;
        let t621 = sin_phi * t609 + t75 * t389 + t421 * t614 + t24 * t556
            - cos_phi * (t474 + t72 * t295) - t601;
        let t630 = t609 + t75 * t387 + t433 * t614 + t24 * t568 - t223 * t621;
        let t641 = t607 + t75 * t386 + t443 * t614 + t24 * t579 - t216 * t621
            - t235 * t630;
        let t642 = t252 * t641;
        let t644 = t234 * t630 - t235 * t642;
        let t648 = t62 * t621 - t223 * t644 - t216 * t642;
        let t649 = self.constants[1] * t604;
        let t650 = t602 + t649;
        let t656 = t556 + sin_phi * t650 + t421 * t613 - t552 - t601;
        let t662 = t568 + t650 + t433 * t613 - t223 * t656;
        let t671 = t252 * (t579 + t649 + t443 * t613 - t216 * t656 - t235 * t662);
        let t673 = t234 * t662 - t235 * t671;
        let t677 = t62 * t656 - t223 * t673 - t216 * t671;
        let t678 = t235 * t252;
        let t681 = t223 * t678 - t216 * t252;
        let t684 = t24 - t23 * t223;
        let t690 = t252 * (self.constants[0].like(1.0) - t23 * t216 - t235 * t684);
        let t692 = t234 * t684 - t235 * t690;
        let t696 = t23 * t62 - t223 * t692 - t216 * t690;
        let t697 = -(self.constants[1] * cos_psi);
        let t698 = -(t5 * cos_psi);
        let t699 = -(self.constants[1] * sin_psi);
        let t700 = -t678;
        (
            [
                [zero, zero, t8, zero, zero, zero, zero, zero, t697, t697],
                [zero, zero, t698, zero, zero, zero, zero, zero, t699, t699],
                [
                    zero, zero, zero, zero, zero, zero, zero, self.constants[0].like(1.0), zero,
                    zero,
                ],
                [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
                [
                    zero, zero, zero, zero, zero, zero, zero, zero, self.constants[0].like(1.0),
                    zero,
                ],
                [
                    zero, zero, zero, zero, zero, zero, zero, zero, zero,
                    self.constants[0].like(1.0),
                ],
                [
                    zero, zero, zero, zero, zero, zero, zero, t23, t24, self.constants[0].like(1.0),
                ],
                [zero, zero, zero, zero, t457, zero, zero, t594, t648, t677],
                [zero, zero, zero, zero, t453, zero, zero, t590, t644, t673],
                [zero, zero, zero, zero, t451, zero, zero, t588, t642, t671],
            ],
            [
                [zero, zero], [zero, zero], [zero, zero], [zero, zero], [zero, zero], [zero, zero],
                [zero, zero], [t681, t696], [t700, t692], [t252, t690],
            ],
        )
    }

    fn by_parameters_unchecked(&self, positions: &[T; 7], speeds: &[T; 3], forces: &[T; 2]) -> [[T; 10]; 10] {
        let (
            zero, t3, sin_psi, cos_psi, t11, sin_phi, cos_phi, t14, t19, t20, t21, t23, t24, t27,
            t29, t31, t32, t33, t35, t37, t40, t43, t45, sin_theta, cos_theta, t50, t51, t55, t58,
            t60, t62, t73, t75, t77, t78, t82, t83, t86, t87, t88, t89, t90, t93, t95, t96, t98,
            t99, t104, t105, t106, t112, t114, t115, t117, t119, t122, t126, t129, t131, t134, t137,
            t138, t141, t145, t148, t151, t153, t154, t157, t162, t163, t165, t169, t171, t173,
            t177, t179, t181, t183, t189, t192, t197, t201, t207, t209, t213, t216, t226, t231,
            t233, t236, t239, t243, t244, t246, t250, t251, t255, t259, t265, t270, t285, t286,
            t288, t292, t293, t295, t297, t299, t301, t303, t306, t308, t310, t312, t314, t319,
            t325, t326, t328, t330, t332, t335, t337, t338, t342, t344, t345, t347, t351, t355,
            t362, t365, t367, t369, t370, t372, t375, t382, t384, t392, t394, t400, t408, t412,
            t414, t417, t423, t425, t429, t430, t433, t436, t441, t443, t450, t453, t458, t460,
            t465, t474, t478, t481, t483, t489, t491, t503, t506, t511, t518, t520, t525, t527,
            t529, t534, t536, t541, t542, t544, t548, t549, t551, t552, t554, t557, t559, t562,
            t563, t564, t567, t569, t570, t571, t573, t574, t579, t580, t582, t587, t588, t593,
            t595, t598, t613, t617, t618, t620, t622, t624, t626, t628, t633, t635, t637, t638,
            t640, t645, t649, t655, t661, t668, t672, t680, t681, t683, t687, t700, t713, t716,
            t718, t719, t723, t727, t731, t736, t738, t743, t748, t751, t756, t760, t761, t767,
            t769, t775, t780, t783, t786, t787, t789, t790, t806, t807,
        );
        zero = self.constants[0].like(0.0);
        t3 = speeds[1] + speeds[2];
        (sin_psi, cos_psi) = positions[2].sin_cos();
        t11 = self.constants[0].like(1.0) / self.constants[1];
        (sin_phi, cos_phi) = positions[3].sin_cos();
        t14 = self.constants[1] * sin_phi;
        t19 = t14 + cos_phi * self.constants[6] - t14;
        t20 = t11 * t19;
        t21 = t11 * t20;
        t23 = sin_phi * t20;
        t24 = t11 * t23;
        t27 = cos_phi + cos_phi;
        t29 = self.constants[0].like(1.0) / t19;
        t31 = t29 * (sin_phi + sin_phi);
        t32 = sin_phi * t31;
        t33 = self.constants[6] * t32;
        t35 = t11 * t27 + t11 * t33;
        t37 = t11 * sin_phi;
        t40 = cos_phi * t31;
        t43 = t27 * t37 + t33 * t37 - t20 * t40;
        t45 = speeds[0] * t35 + speeds[1] * t43;
        (sin_theta, cos_theta) = positions[4].sin_cos();
        t50 = cos_theta * self.constants[7];
        t51 = self.constants[1] * t50;
        t55 = self.constants[8] + self.constants[17] - t51 - t51;
        t58 = cos_theta * self.constants[9];
        t60 = self.constants[18] - t58;
        t62 = sin_phi * t55 + cos_phi * t60;
        t73 = cos_phi
            * (sin_phi * t60
                + cos_phi
                    * (self.constants[13] - sin_theta * sin_theta * self.constants[15]));
        t75 = sin_phi * self.constants[4];
        t77 = sin_phi + t20;
        t78 = self.constants[4] * t77;
        t82 = sin_phi * t62 + t73 + sin_phi * t75 + t77 * t78;
        t83 = self.constants[0].like(1.0) / t82;
        t86 = self.constants[1] - self.constants[1] - self.constants[3];
        t87 = speeds[0] * cos_phi;
        t88 = speeds[0] * sin_phi;
        t89 = self.constants[1] * t88;
        t90 = t87 * t89;
        t93 = t3 * t87;
        t95 = cos_theta * t87;
        t96 = self.constants[6] * t95;
        t98 = sin_theta * t87;
        t99 = self.constants[6] * t98;
        t104 = speeds[2] + speeds[0] * t20 + speeds[1] * t23;
        t105 = speeds[1] + t104;
        t106 = t87 * t105;
        t112 = t90 + self.constants[1] * t106 - t90 - self.constants[1] * t93 - t95 * t96
            - t98 * t99;
        t114 = t3 + t88;
        t115 = t89 * t114;
        t117 = speeds[1] + t88;
        t119 = speeds[1] * t95;
        t122 = cos_theta * t115 + t96 * t117 - self.constants[6] * t119;
        t126 = speeds[1] * t98;
        t129 = self.constants[6] * t126 - sin_theta * t115 - t99 * t117;
        t131 = t88 + t105;
        t134 = cos_theta * t122 - sin_theta * t129 - t89 * t131;
        t137 = t29 * (sin_phi * t112 + cos_phi * t134);
        t138 = t93 + t137;
        t141 = t90 + sin_phi * self.constants[14] + self.constants[1] * t138;
        t145 = sin_theta * t95 - cos_theta * t98;
        t148 = t86 * t117 * t145 - sin_theta * t141;
        t151 = t119 + cos_theta * t137;
        t153 = t115 - cos_phi * self.constants[14];
        t154 = sin_theta * t153;
        t157 = t126 + sin_theta * t137;
        t162 = t11 * (sin_theta * t122 + cos_theta * t129);
        t163 = self.constants[4] * t162;
        t165 = t98 * self.constants[12];
        t169 = self.constants[13] * t95 - self.constants[9] * t117;
        t171 = t98 * t169 - t95 * t165;
        t173 = cos_theta * t153;
        t177 = self.constants[7] * t98;
        t179 = self.constants[7] * t117;
        t181 = t179 - t95 * self.constants[11];
        t183 = t98 * t177 + t117 * t181;
        t189 = t98 * self.constants[11];
        t192 = t117 * t189 + t95 * t177;
        t197 = self.constants[1]
            * (sin_theta * (self.constants[10] * t173 - self.constants[11] * t151 - t183)
                + cos_theta
                    * (t157 * self.constants[11] - t154 * self.constants[10] - t192));
        t201 = self.constants[9] * t157 + t171 - self.constants[7] * t154 - t163 - t197;
        t207 = speeds[2] + t117;
        t209 = t104 + t117;
        t213 = self.constants[8] * t117 + self.constants[4] * t207
            + self.constants[4] * t209 - self.constants[9] * t95;
        t216 = t117 * t165 - t98 * t213;
        t226 = self.constants[7] * t141 + t117 * t169 - t95 * t213;
        t231 = cos_phi
            * (cos_theta * (t154 * self.constants[11] + t216 - self.constants[13] * t157)
                - sin_theta
                    * (t173 * self.constants[11] + t226 - self.constants[12] * t151));
        t233 = t163 + forces[1];
        t236 = t20 * t233 - sin_phi * t201 - t231;
        t239 = t23 + self.constants[0].like(1.0);
        t243 = t83 * (t62 + t75 + t78 * t239);
        t244 = self.constants[4] * t239;
        t246 = t82 * t243;
        t250 = t55 + self.constants[4] + t239 * t244 - t243 * t246;
        t251 = self.constants[0].like(1.0) / t250;
        t255 = t23 * t233 - t201 - t236 * t243;
        t259 = self.constants[1] * (t50 - self.constants[16]);
        t265 = t83 * (t75 + t78 + cos_phi * self.constants[18] - sin_phi * t259);
        t270 = t251 * (self.constants[4] + t244 - t259 - t246 * t265);
        t285 = self.constants[0].like(1.0)
            / (self.constants[19] - t82 * t265 * t265 - t250 * t270 * t270);
        t286 = (t197 + t233 + forces[0] - t236 * t265 - t255 * t270) * t285;
        t288 = t251 * t255 - t270 * t286;
        t292 = t83 * t236 - t243 * t288 - t265 * t286;
        t293 = cos_phi * t292;
        t295 = t151 + sin_theta * t293;
        t297 = t98 * t117;
        t299 = sin_theta * t295 + cos_theta * t297;
        t301 = self.constants[0] * self.constants[0];
        t303 = t301 + t86 * t86;
        t306 = cos_theta * t293 - t157;
        t308 = sin_theta * t117;
        t310 = cos_theta * t306 - t95 * t308;
        t312 = t86 * self.constants[0];
        t314 = t288 + sin_phi * t292;
        t319 = t117 * t308 - cos_theta * t314 - t95 * t145;
        t325 = t286 + t314;
        t326 = self.constants[1] * t325;
        t328 = t154 + cos_theta * t326;
        t330 = t86 * t314 - t328;
        t332 = t95 * t98;
        t335 = t297 + t306;
        t337 = self.constants[1] * cos_theta;
        t338 = t314 - t332;
        t342 = self.constants[1] * sin_theta;
        t344 = t173 - sin_theta * t326;
        t345 = t98 * t98;
        t347 = t345 + t117 * t117;
        t351 = t337 * (t86 * t338 - t328) + t342 * (t344 - t86 * t347);
        t355 = t86 * t330 + t301 * t332 - t303 * t332 - t312 * t335 - t351;
        t362 = t95 * t117;
        t365 = t335 * t337 - t342 * (t362 - t295);
        t367 = cos_phi * (cos_theta * t328 - sin_theta * t344) + sin_phi * t365;
        t369 = cos_phi * (t86 * t148 + t299 * t303 + t301 * t310 + t312 * t319)
            + sin_phi * t355;
        t370 = t369 + self.constants[0] * t367;
        t372 = self.constants[0] * t365;
        t375 = t243 * t370 - t355 - t372;
        t382 = t285 * (t351 + t265 * t370 - t372 - t270 * t375);
        t384 = t251 * t375 - t270 * t382;
        t392 = self.constants[7] + self.constants[7];
        t394 = self.constants[0] * self.constants[2];
        t400 = self.constants[7] * t314;
        t408 = t337 * t338 * self.constants[2] - t342 * t347 * self.constants[2];
        t412 = t332 * t392 + t335 * t394 + t408 - t400 - t330 * self.constants[2];
        t414 = cos_phi
            * (t145 * t179 + t148 * self.constants[2] + t299 * t392 + t319 * t394)
            - sin_phi * t412;
        t417 = t412 + t243 * t414;
        t423 = t285 * (t270 * t417 - t408 - t265 * t414);
        t425 = t251 * t417 + t270 * t423;
        t429 = t83 * t414 + t243 * t425 - t265 * t423;
        t430 = cos_phi * t145;
        t433 = t117 * t430 + sin_phi * t314;
        t436 = t243 * t433 - t314;
        t441 = t285 * (t265 * t433 - t270 * t436);
        t443 = t251 * t436 - t270 * t441;
        t450 = cos_phi * t310 + sin_phi * t332;
        t453 = t243 * t450 - t332;
        t458 = t285 * (t265 * t450 - t270 * t453);
        t460 = t251 * t453 - t270 * t458;
        t465 = self.constants[6] * self.constants[6];
        t474 = t337 * (t328 + t328) - t342 * (t344 + t344);
        t478 = cos_phi * (t299 * t465 + t310 * t465) + sin_phi * t474
            + self.constants[6] * t367;
        t481 = t474 + self.constants[6] * t365;
        t483 = t243 * t478 - t481;
        t489 = t285 * (t265 * t478 - t481 - t270 * t483);
        t491 = t251 * t483 - t270 * t489;
        t503 = t325 + t20 * t292 + t23 * t288 - t162;
        t506 = t430 * (t207 + t209) + sin_phi * t325 + t77 * t503;
        t511 = t243 * t506 - t325 - t239 * t503;
        t518 = t285 * (t265 * t506 - t325 - t503 - t270 * t511);
        t520 = t251 * t511 - t270 * t518;
        t525 = t299 + t310;
        t527 = cos_phi * (t525 + t525);
        t529 = t243 * t527;
        t534 = t285 * (t265 * t527 - t270 * t529);
        t536 = t251 * t529 - t270 * t534;
        t541 = self.constants[4] * t503;
        t542 = forces[1] - t541;
        t544 = self.constants[7] * sin_theta;
        t548 = sin_theta * self.constants[11];
        t549 = sin_theta * t325;
        t551 = self.constants[4] * t145;
        t552 = speeds[0] * t551;
        t554 = speeds[1] * t551;
        t557 = sin_theta * self.constants[12];
        t559 = cos_theta * self.constants[13];
        t562 = cos_theta * t557 - self.constants[1] * t544 - sin_theta * t559;
        t563 = cos_phi * t29;
        t564 = t131 * t563;
        t567 = sin_phi * t29;
        t569 = sin_theta * t563;
        t570 = t88 * t114;
        t571 = sin_theta * t570;
        t573 = cos_theta * t563;
        t574 = cos_theta * t570;
        t579 = self.constants[1] * t87 * t567 - t89 * t563;
        t580 = speeds[0] * t579;
        t582 = speeds[1] * t579;
        t587 = (t106 - t93) * t567 + t569 * t571 + t573 * t574 - t88 * t564 - t21 * t580;
        t588 = t587 - t24 * t582;
        t593 = t548 * t549 + t562 * t588 - t544 * (t138 + t87 * t88) - t21 * t552
            - t24 * t554;
        t595 = self.constants[9] * sin_theta;
        t598 = cos_theta * self.constants[11];
        t613 = sin_theta * (self.constants[10] * t344 - t183 - self.constants[11] * t295)
            + cos_theta
                * (t400 - t192 - self.constants[10] * t328 - self.constants[11] * t306);
        t617 = t342 * (self.constants[10] * t549 + t588 * t598) - t613
            - t337 * t548 * t588;
        t618 = t588 * t595 + t617;
        t620 = t11 * self.constants[4];
        t622 = cos_theta * t620;
        t624 = sin_theta * t620;
        t626 = self.constants[4] * t292;
        t628 = self.constants[4] * t288;
        t633 = t162 * t620 + t571 * t622 - t574 * t624 - t21 * t626 - t24 * t628;
        t635 = cos_theta * t325;
        t637 = self.constants[10] * t337;
        t638 = t637 - self.constants[7];
        t640 = cos_phi * t598 + sin_phi * t638;
        t645 = cos_theta * self.constants[10] * t342;
        t649 = cos_phi * cos_theta * t548 + sin_phi * t645 - sin_theta * t640;
        t655 = t570 * t649 - t21 * t542 - cos_phi * t593 - sin_phi * t618 - t77 * t633
            - t635 * t640;
        t661 = t645 - sin_theta * t638;
        t668 = t570 * t661 - t618 - t24 * t542 - t239 * t633 - t635 * t638 - t243 * t655;
        t672 = t645 - sin_theta * t637;
        t680 = t570 * t672 - t617 - t633 - t635 * t637 - t265 * t655 - t270 * t668;
        t681 = t285 * t680;
        t683 = t251 * t668 - t270 * t681;
        t687 = t83 * t655 - t243 * t683 - t265 * t681;
        t700 = cos_theta
            * (t216 + self.constants[11] * t328 + self.constants[13] * t306
                - self.constants[9] * t314)
            - sin_theta * (t226 + self.constants[11] * t344 - self.constants[12] * t295);
        t713 = t171 + t541 + self.constants[8] * t314 + self.constants[4] * t325
            - self.constants[7] * t328 - self.constants[9] * t306
            - self.constants[1] * t613;
        t716 = self.constants[6] * self.constants[5];
        t718 = t394 + t716 + t716;
        t719 = t718 + t718;
        t723 = t3 * self.constants[1];
        t727 = sin_theta * t292;
        t731 = speeds[0] * sin_theta;
        t736 = cos_theta * t292 - speeds[1] * t731;
        t738 = speeds[0] * cos_theta;
        t743 = self.constants[13] * t738;
        t748 = t557 * t727 + cos_theta * (t117 * self.constants[12] - t213) * t731
            + t559 * t736;
        t751 = t748 + t738 * (speeds[1] * t557 + sin_theta * t213)
            - speeds[0] * t544 * (t89 + t723) - t308 * t743;
        t756 = speeds[0] * self.constants[1];
        t760 = self.constants[1] * t292;
        t761 = sin_theta * t760;
        t767 = speeds[0] * self.constants[9];
        t769 = self.constants[8] + self.constants[4];
        t775 = t548 * t761 + speeds[0] * (cos_theta * t165 - sin_theta * t169)
            + t308 * t767 + speeds[0] * t145 * (self.constants[4] + t769);
        t780 = t29 * t137;
        t783 = t345 + t95 * t95;
        t786 = t126 - t297;
        t787 = t786 + t786;
        t789 = t362 - t119;
        t790 = t789 + t789;
        t806 = self.constants[6] * t117 - speeds[1] * self.constants[6];
        t807 = t731 * t806;
        let (
            t809, t813, t820, t824, t827, t831, t837, t839, t844, t845, t850, t853, t864, t871,
            t879, t896, t904, t906, t910, t929, t932, t936, t939, t945, t948, t954, t960, t961,
            t972, t975, t977, t981, t985, t989, t996, t998, t1002, t1003, t1004, t1005, t1006,
            t1007, t1008, t1009, t1010, t1011, t1012, t1013,
        );
        t809 = t738 * t806;
        t813 = t29 * t134 + speeds[0] * t567 * (self.constants[1] * t105 - t723)
            + t569 * t807 + t573 * t809;
        t820 = speeds[0] * t89;
        t824 = t820 + t114 * t756;
        t827 = sin_theta * t824 + speeds[0] * t99;
        t831 = cos_theta * t824 + speeds[0] * t96;
        t837 = t40
            * (t29 * t112 + t569 * t827 + t573 * t831 - t563 * t820 - t564 * t756);
        t839 = t573 * t790
            + t32
                * (t813 - self.constants[6] * t780 - t567 * t731 * (t99 + t99)
                    - t567 * t738 * (t96 + t96));
        t844 = t839 + t35 * t580 + t43 * t582 - t27 * t780 - t567 * (t783 + t783)
            - t569 * t787;
        t845 = t844 - t837;
        t850 = t299 * t719 + t310 * t719 + self.constants[7] * t319
            + t32 * (t751 - self.constants[9] * t145 * t738) + t35 * t552;
        t853 = t850 + t43 * t554 + t562 * t845
            - t40 * (t775 - t58 * t292 - t544 * (self.constants[14] + t87 * t756));
        t864 = t731 * (t169 - t95 * self.constants[12]) + t98 * t743
            - self.constants[9] * t736 - t165 * t738;
        t871 = t117 * self.constants[11];
        t879 = t32
            * (t731 * (t871 + self.constants[7] * t95) + self.constants[11] * t736
                + t177 * t738);
        t896 = t32
            * (t738 * (t871 - speeds[1] * self.constants[11]) - self.constants[11] * t727
                - t731 * (t177 + t177));
        t904 = t896 + t40 * (self.constants[10] * t761 + speeds[0] * (t179 + t181))
            - t598 * t845;
        t906 = t337
            * (t548 * t845 - t879 - t40 * (self.constants[7] * t292 - speeds[0] * t189))
            + t342 * t904;
        t910 = t32 * t864 + t595 * t845 - self.constants[7] * t335
            - t40 * (t292 * t769 - t98 * t767) - t906;
        t929 = t35 * t626 + t43 * t628 - t622 * t787 - t624 * t790
            - t32 * (t624 * t809 - t622 * t807)
            - t40 * (t626 + t622 * t827 - t624 * t831);
        t932 = t40 * cos_theta * t760;
        t936 = t32 * self.constants[14] + t40 * t824;
        t939 = self.constants[2] + self.constants[5] + self.constants[5];
        t945 = t35 * t542 + t40 * t713 + t640 * t932 - t32 * t700 - cos_phi * t853
            - sin_phi * t910;
        t948 = t945 - t77 * t929 - t649 * t936 - t367 * t939;
        t954 = t365 * t939;
        t960 = t43 * t542 + t638 * t932 - t910 - t239 * t929 - t661 * t936 - t954;
        t961 = t960 - t243 * t948;
        t972 = t906 + t40 * t626 + t637 * t932 - t929 - t954 - t672 * t936;
        t975 = t285 * (t972 - t265 * t948 - t270 * t961);
        t977 = t251 * t961 - t270 * t975;
        t981 = t83 * t948 - t243 * t977 - t265 * t975;
        t985 = sin_phi * cos_phi * t544 - cos_phi * t649;
        t989 = cos_phi * t661 + t243 * t985;
        t996 = t285 * (t270 * t989 - cos_phi * t672 - t265 * t985);
        t998 = t251 * t989 + t270 * t996;
        t1002 = t83 * t985 + t243 * t998 - t265 * t996;
        t1003 = -(t3 * cos_psi);
        t1004 = -(t3 * sin_psi);
        t1005 = -(speeds[0] * t21 + speeds[1] * t24);
        t1006 = -(t83 * t370 + t243 * t384 + t265 * t382);
        t1007 = -(t83 * t433 + t243 * t443 + t265 * t441);
        t1008 = -(t83 * t450 + t243 * t460 + t265 * t458);
        t1009 = -(t83 * t478 + t243 * t491 + t265 * t489);
        t1010 = -(t83 * t506 + t243 * t520 + t265 * t518);
        t1011 = -(t83 * t527 + t243 * t536 + t265 * t534);
        t1012 = -t425;
        t1013 = -t998;
        [
            [zero, zero, zero, zero, zero, zero, zero, t1003, zero, zero],
            [zero, zero, zero, zero, zero, zero, zero, t1004, zero, zero],
            [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
            [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
            [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
            [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
            [zero, zero, zero, zero, zero, zero, zero, t1005, t45, zero],
            [t1006, t429, t1007, t1008, t1009, t1010, t1011, t687, t981, t1002],
            [t384, t1012, t443, t460, t491, t520, t536, t683, t977, t1013],
            [t382, t423, t441, t458, t489, t518, t534, t681, t975, t996],
        ]
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
    /// 21 additions, 16 multiplications, 1 division and 2 negations: 40 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WheeledPendulumMatrices<T>, WheeledPendulumDerivatives<T>) {
        let zero = self.m.like(0.0);
        let mut matrices = WheeledPendulumMatrices::from_entries([zero; 18]);
        let mut derivatives = WheeledPendulumDerivatives {
            values: [zero; 18],
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
        matrices: &mut WheeledPendulumMatrices<T>,
        derivatives: &mut WheeledPendulumDerivatives<T>,
    ) {
        *matrices = WheeledPendulumMatrices::from_entries([self.m.like(0.0); 18]);
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
        put_derivative(0, self.m);
        put_derivative(1, self.l);
        put_derivative(2, self.m.like(1.0));
        put_derivative(3, self.m.like(2.0));
        let t12 = self.mW + self.mW;
        let t13 = self.m.like(1.0) / self.r;
        let t14 = self.m * self.l;
        let t15 = self.m + t12;
        let t17 = t14 + self.r * t15;
        let t18 = t13 + t13;
        put_derivative(4, t18);
        let K0_22 = -t14;
        put_entry(4, K0_22);
        let t20 = self.r + self.l;
        put_derivative(5, t20);
        let M_22_m = t20 * t20;
        put_derivative(6, M_22_m);
        let t22 = self.m * t20;
        let M_22_l = t22 + t22;
        put_derivative(7, M_22_l);
        let t24 = self.r + self.r;
        put_derivative(8, t24);
        let M_22_mW = self.r * t24;
        put_derivative(9, M_22_mW);
        let t26 = self.b * self.b;
        let M_33_mW = t26 + t26;
        put_derivative(10, M_33_mW);
        let M_11_Ia = t13 * t18;
        put_derivative(11, M_11_Ia);
        let t29 = self.Ia * t18;
        let M_22 = self.Ia + self.Ia + t14 * t20 + self.r * t17 + self.Iyy;
        put_entry(2, M_22);
        let M_22_r = t17 + t17;
        put_derivative(12, M_22_r);
        let t37 = self.Ia * M_11_Ia;
        let M_12 = -(t17 + t29);
        put_entry(1, M_12);
        let M_33_Ia = M_11_Ia * t26;
        put_derivative(13, M_33_Ia);
        let t41 = M_11_Ia * t29;
        put_derivative(14, t41);
        let t42 = t12 + t37;
        let M_12_r = t37 - t15;
        put_derivative(15, M_12_r);
        let t44 = t26 * t41;
        put_derivative(16, t44);
        let M_11 = self.m + t42;
        put_entry(0, M_11);
        let t46 = t42 * self.b;
        let M_33 = self.Ir + self.Ir + self.b * t46 + self.Izz;
        put_entry(3, M_33);
        let M_33_b = t46 + t46;
        put_derivative(17, M_33_b);
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
    #[inline(always)]
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

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 5] {
        [self.m[0][0], self.m[0][1], self.m[1][1], self.m[2][2], self.k0[1][1]]
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
                self.m[2][2] = entry;
            }
            4 => {
                self.k0[1][1] = entry;
            }
            _ => {}
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
        docs: "A pendulum upside down on two wheels, as balancing robots and the Segway are: it stands only where a motor balances it.\n\nTwo wheels on one axle that roll without slip, and a body above it. The motors act between body and wheels; forward\nmotion, pitch and yaw take part. A positive torque, about y, drives a wheel backward and pitches the body forward.\nIn the matrices `x` is of a point of the body, as declared; in the nonlinear equations `x` and `y` are of where the left wheel\ntouches the ground, to first order `x - r*theta + b*psi` of that `x`.\nAxes: origin on the ground below the axle, x forward, y to the right, z down.",
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
        forces: &[
            carvallo::motion::AppliedInfo {
                name: "TL", label: "torque of the left motor", unit: "N*m", position: "thetaL",
            },
            carvallo::motion::AppliedInfo {
                name: "TR", label: "torque of the right motor", unit: "N*m", position: "thetaR",
            },
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
        attributes: &[
            FormulaInfo::attribute("B_mass", "the mass of the body B", "kg", "m"),
            FormulaInfo::attribute("B_z", "z of the centre of mass of the body B", "m", "-r - l"),
            FormulaInfo::attribute("B_Iyy", "the inertia yy of the body B", "kg*m^2", "Iyy"),
            FormulaInfo::attribute("B_Izz", "the inertia zz of the body B", "kg*m^2", "Izz"),
            FormulaInfo::attribute("L_mass", "the mass of the left wheel L", "kg", "mW"),
            FormulaInfo::attribute("L_radius", "the radius of the left wheel L", "m", "r"),
            FormulaInfo::attribute("L_axial", "the axial inertia of the left wheel L", "kg*m^2", "Ia"),
            FormulaInfo::attribute("L_radial", "the radial inertia of the left wheel L", "kg*m^2", "Ir"),
            FormulaInfo::attribute("L_y", "y of the centre of the left wheel L", "m", "-b"),
            FormulaInfo::attribute("L_z", "z of the centre of the left wheel L", "m", "-r"),
            FormulaInfo::attribute("R_mass", "the mass of the right wheel R", "kg", "mW"),
            FormulaInfo::attribute("R_radius", "the radius of the right wheel R", "m", "r"),
            FormulaInfo::attribute("R_axial", "the axial inertia of the right wheel R", "kg*m^2", "Ia"),
            FormulaInfo::attribute("R_radial", "the radial inertia of the right wheel R", "kg*m^2", "Ir"),
            FormulaInfo::attribute("R_y", "y of the centre of the right wheel R", "m", "b"),
            FormulaInfo::attribute("R_z", "z of the centre of the right wheel R", "m", "-r"),
            FormulaInfo::definition("spin_L_by_x", "1/m", "-1/L_radius"),
            FormulaInfo::definition("spin_L_by_psi", "1", "L_y/L_radius"),
            FormulaInfo::definition("spin_L_by_theta", "1", "-(L_radius + L_z)/L_radius"),
            FormulaInfo::definition("spin_R_by_x", "1/m", "-1/R_radius"),
            FormulaInfo::definition("spin_R_by_psi", "1", "R_y/R_radius"),
            FormulaInfo::definition("spin_R_by_theta", "1", "-(R_radius + R_z)/R_radius"),
            FormulaInfo::definition(
                "Jyy_all",
                "kg*m^2",
                "B_mass*B_z^2 + B_Iyy + L_mass*L_z^2 + L_axial + R_mass*R_z^2 + R_axial",
            ),
            FormulaInfo::definition("Jyz_all", "kg*m^2", "-(L_mass*L_y*L_z + R_mass*R_y*R_z)"),
            FormulaInfo::definition("Jzz_all", "kg*m^2", "B_Izz + L_mass*L_y^2 + L_radial + R_mass*R_y^2 + R_radial"),
            FormulaInfo::definition("Sy_all", "kg*m", "L_mass*L_y + R_mass*R_y"),
            FormulaInfo::definition("Sz_all", "kg*m", "B_mass*B_z + L_mass*L_z + R_mass*R_z"),
            FormulaInfo::definition("m_all", "kg", "B_mass + L_mass + R_mass"),
            FormulaInfo::definition("load_spin_R", "kg", "(L_y*m_all - Sy_all)/(R_y - L_y)"),
            FormulaInfo::definition("load_spin_L", "kg", "-(m_all + load_spin_R)"),
            FormulaInfo::definition("K_theta_theta", "kg*m", "L_z*load_spin_L + R_z*load_spin_R + Sz_all"),
            FormulaInfo::definition("P_x_theta", "kg*m", "L_axial*spin_L_by_x + R_axial*spin_R_by_x + Sz_all"),
            FormulaInfo::definition("P_x_spin_L", "kg*m", "L_axial*spin_L_by_x"),
            FormulaInfo::definition("P_x_spin_R", "kg*m", "R_axial*spin_R_by_x"),
            FormulaInfo::definition(
                "P_theta_theta",
                "kg*m^2",
                "L_axial*spin_L_by_theta + R_axial*spin_R_by_theta + Jyy_all",
            ),
            FormulaInfo::definition("P_theta_spin_L", "kg*m^2", "L_axial + L_axial*spin_L_by_theta"),
            FormulaInfo::definition("P_theta_spin_R", "kg*m^2", "R_axial + R_axial*spin_R_by_theta"),
            FormulaInfo::definition("P_psi_spin_L", "kg*m^2", "L_axial*spin_L_by_psi"),
            FormulaInfo::definition("P_psi_spin_R", "kg*m^2", "R_axial*spin_R_by_psi"),
            FormulaInfo::entry(
                &[(MatrixName::M, 0, 0)],
                "kg",
                "spin_L_by_x*P_x_spin_L + spin_R_by_x*P_x_spin_R + m_all",
            ),
            FormulaInfo::entry(
                &[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)],
                "kg*m",
                "spin_L_by_theta*P_x_spin_L + spin_R_by_theta*P_x_spin_R + P_x_theta",
            ),
            FormulaInfo::entry(
                &[(MatrixName::M, 0, 2), (MatrixName::M, 2, 0)],
                "kg*m",
                "spin_L_by_psi*P_x_spin_L + spin_R_by_psi*P_x_spin_R - Sy_all",
            ),
            FormulaInfo::entry(
                &[(MatrixName::M, 1, 1)],
                "kg*m^2",
                "spin_L_by_theta*P_theta_spin_L + spin_R_by_theta*P_theta_spin_R + P_theta_theta",
            ),
            FormulaInfo::entry(
                &[(MatrixName::M, 1, 2), (MatrixName::M, 2, 1)],
                "kg*m^2",
                "spin_L_by_psi*P_theta_spin_L + spin_R_by_psi*P_theta_spin_R + Jyz_all",
            ),
            FormulaInfo::entry(
                &[(MatrixName::M, 2, 2)],
                "kg*m^2",
                "spin_L_by_psi*P_psi_spin_L + spin_R_by_psi*P_psi_spin_R + Jzz_all",
            ),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "K_theta_theta"),
        ],
        motion: Some(
            &MotionFormulas {
                constants: &[
                    "C4=A14-A8;C5=A15-A9;C6=A5/A11;C7=A0+A4+A10;T0=A8*A0;T1=C4*A10;C8=T1-T0;T2=A1-A9;T3=A0*T2;T4=C5*A10;C9=T3+T4",
                    "T5=T2*T3+C5*T4;T6=A7+A13+A8*T0+C4*T1;C10=T5+T6;C11=T5+A2;C12=T0*T2-C5*T1;C13=T6+A3;C15=C13-C10;C16=A5*C7",
                    "C17=A5*C16;C18=A5*C8;C19=A6+C17+A12*C6*C6;C0=A6;C1=A12;C2=A5;C3=A11;C14=P9",
                ],
                closure: &[
                    "T0=cos(Q3);T1=sin(Q3);T2=cos(Q4)*C5;R0=T0*C3+T1*C4+T0*T2-C2*T0;R1=-(R0/(C2*T1+T0*C4-C3*T1-T1*T2))",
                ],
                accelerations: &[
                    "T0=U1+U2;T1=C2*T0;T2=cos(Q2);T3=sin(Q2);T4=cos(Q3);T5=sin(Q4);T6=sin(Q3);T7=cos(Q4)",
                    "T8=C2*T6+T4*C4-T6*C3-C5*T6*T7;T9=1/T8;T10=T4*T5*C5*T9;R3=U1*T10;T11=1/C3;T12=T8*T11;T13=T6*T12",
                    "R6=U0*T12+U1*T13+U2*C6;T14=U0*T4;T15=R3*T14;T16=C2*R3;T17=U0*T6;T18=C2*T17;T19=R3*T16+(T0+T17)*T18",
                    "T20=C2*T15+T14*T16;T21=T5*T20;T22=T7*R3-T5*T14;T23=C5*T22;T24=U1+T17;T25=T7*T14+T5*R3;T26=C5*T24-C4*T25",
                    "T27=R3*T17;T28=T5*T27-U1*T25;T29=T7*T19+C4*T28-T21-T22*T23-T24*T26;T30=T7*T20;T31=C4*T22;T32=T7*T27-U1*T22",
                    "T33=T24*T31+T23*T25+C5*T15+C4*T32-T30-T5*T19;T34=C3*R3;T35=T11*(T5*T29+T7*T33+C3*T15+T14*T34)",
                    "T36=C1*(T15-T35);T37=F1-T36;T38=T19-T4*C14;T39=T7*T38-T21;T40=T0*T14;T41=T14*T18;T42=U1+R6;T43=C3*T17",
                    "T44=T25*T26+C3*T14*T42+T14*T43-C2*T40-T41",
                    "T45=T6*(T44-T22*T31-C5*T28)+T4*(T7*T29-T5*T33-R3*T34-T43*(T17+T42));T46=T9*T45;T47=T28-T7*T46;T48=T22*C9",
                    "T49=T24*C9-T25*C8;T50=T30+T5*T38;T51=T32+T5*T46;T52=T22*C8;T53=T7*(T15*C9+T51*C8+T24*T52+T25*T48-T50*C7)",
                    "T54=T5*(C7*T39+C8*T47-T22*T48-T24*T49)+T53;T55=T15*C0-C2*T54;T56=T22*C10;T57=T24*C12+T25*C13",
                    "T58=T36+T15*C11+T25*T56+T55-C9*T50-C12*T51;T59=T58-T22*T57;T60=T24*C11+T25*C12+C0*(U2+T24)+C1*(R6+T24)",
                    "T61=T50*C8+T15*C12+T22*T60-T51*C13-T24*T56;T62=T41+T6*C14+C2*(T40+T46)",
                    "T63=T39*C8+C9*T62+C10*T47+T24*T57-T25*T60;T64=T12*T37-T6*T59-T4*(T7*T61-T5*T63);T65=T6*C0;T66=T7*C9",
                    "T67=C2*(T66-C16);T68=T6+T12;T69=C1*T68;T70=C2*T66;T71=C17-T70-T70;T72=C11+T71;T73=C18+T7*C12;T74=T5*C15",
                    "T75=T5*T74;T76=T6*(T6*T72+T4*T73)+T4*(T6*T73+T4*(C13-T75))+T6*T65;T77=T76+T68*T69;T78=1/T77",
                    "T79=(T65+T4*C18+C6*T69-T6*T67)*T78;T80=T13+1.0;T81=C1*T80;T82=T5*C12;T83=T72+T10*T82",
                    "T84=T4*(T73+T10*(T7*T74+C2*T5*C9));T85=T78*(T65+T6*T83+T84+T69*T80);T86=T77*T85",
                    "T87=C0+T83+T10*(T82+T10*(C10+T71+T75));T88=T87+T80*T81-T85*T86;T89=1/T88;T90=(C0+C6*T81-T67-T79*T86)*T89",
                    "T91=T5*T61+T7*T63+C2*(T25*T49-C7*T62-C9*T47-T22*T52);T92=T13*T37-T59-T10*T91-T64*T85",
                    "R12=(F0+C6*T37-T55-T64*T79-T90*T92)/(C19-T77*T79*T79-T88*T90*T90);R11=T89*T92-T90*R12;T93=C2*(R12+R11)",
                    "T94=T1*U0;R7=T3*T94-T2*T93;R9=T64*T78-T85*R11-T79*R12;R10=T10*R11-T46;R13=T12*R9+T13*R11+C6*R12-T35",
                    "R0=-(T1*T2);R1=-(T1*T3);R8=-(T3*T93+T2*T94);R2=U0;R4=U1;R5=U2",
                ],
            },
        ),
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

    fn shares(&self, force: usize) -> Option<[T; 3]> {
        (force < 2).then(|| self.kinematics().forces.map(|row| row[force]))
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
        WheeledPendulumMatrices::distinct_entries(&self.matrices())
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

    type WithDerivativesOver<U: Number> = WheeledPendulum<U>;

    const PARTIALS: &'static [Partial] = <WheeledPendulumDerivatives>::PARTIALS;

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

impl<T: Number> EvaluatorWithDerivatives<T, 3> for WheeledPendulum<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl WheeledPendulumDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 28] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 2), Partial::new(MatrixName::M, 0, 1, 0, 5).negative(),
        Partial::new(MatrixName::M, 1, 0, 0, 5).negative(), Partial::new(MatrixName::M, 1, 1, 0, 6),
        Partial::new(MatrixName::K0, 1, 1, 0, 1).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 0).negative(),
        Partial::new(MatrixName::M, 1, 0, 1, 0).negative(), Partial::new(MatrixName::M, 1, 1, 1, 7),
        Partial::new(MatrixName::K0, 1, 1, 1, 0).negative(),
        Partial::new(MatrixName::M, 1, 1, 2, 2), Partial::new(MatrixName::M, 2, 2, 3, 2),
        Partial::new(MatrixName::M, 0, 0, 4, 3), Partial::new(MatrixName::M, 0, 1, 4, 8).negative(),
        Partial::new(MatrixName::M, 1, 0, 4, 8).negative(), Partial::new(MatrixName::M, 1, 1, 4, 9),
        Partial::new(MatrixName::M, 2, 2, 4, 10), Partial::new(MatrixName::M, 0, 0, 5, 11),
        Partial::new(MatrixName::M, 0, 1, 5, 4).negative(),
        Partial::new(MatrixName::M, 1, 0, 5, 4).negative(), Partial::new(MatrixName::M, 1, 1, 5, 3),
        Partial::new(MatrixName::M, 2, 2, 5, 13), Partial::new(MatrixName::M, 2, 2, 6, 3),
        Partial::new(MatrixName::M, 0, 0, 7, 14).negative(),
        Partial::new(MatrixName::M, 0, 1, 7, 15), Partial::new(MatrixName::M, 1, 0, 7, 15),
        Partial::new(MatrixName::M, 1, 1, 7, 12),
        Partial::new(MatrixName::M, 2, 2, 7, 16).negative(),
        Partial::new(MatrixName::M, 2, 2, 8, 17),
    ];
}
