// @generated from generated/models/wheeled_pendulum.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 33b55348424b197b

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    FormulaInfo, LengthError, MatrixName, Model, ModelInfo, Number, ParameterError,
    ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo, States, WithDerivatives,
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
