// @generated from generated/models/skateboard.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 0f4f8539b65fdea9

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A skateboard with a rider who stands still on it: one degree of freedom, the tilt of the board.
///
/// Each truck turns about its king pin, which passes through the middle of its axle, with a wheel at either end. All
/// four wheels stay on the ground and do not slip, so that tilting steers both axles. Trucks and wheels have no mass;
/// board and rider are one rigid body. Axes: origin on the ground below the rear axle, x forward, y to the right, z
/// down.
///
/// Source: Mechanism: Hubbard (1979), J. Appl. Mech. 46, 931-936; Kremnev & Kuleshov (2010), DCDS-S 3, 85-103
///
/// Derived from a mechanism: body `B` (board and rider), body `TF` (front truck), body `TR` (rear truck), wheel `FL` (front left), wheel `FR` (front right), wheel `RL` (rear left), wheel `RR` (rear right).
///
/// The fields are the parameters. The coordinates are `gamma` (tilt) in `rad`.
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
/// pitch_by_vertical = 1/L [1/m]
/// deltaF_by_gamma = -1/cos(lamF) [1]
/// deltaR_by_gamma = -1/cos(lamR) [1]
/// yaw_per_v_deltaF = -sin(lamF)/L [1/m]
/// lateral_per_v_deltaR = sin(lamR) [1]
/// yaw_per_v_deltaR = -pitch_by_vertical*lateral_per_v_deltaR [1/m]
/// Jxx_all = m*(r + h)^2 + Ixx [kg*m^2]
/// Jxz_all = m*x*(r + h) + Ixz [kg*m^2]
/// Sx_all = m*x [kg*m]
/// Sz_all = -m*(r + h) [kg*m]
/// P_gamma_lateral = m*h [kg*m]
/// P_gamma_yaw = Jxz_all - r*Sx_all [kg*m^2]
/// P_gamma_gamma = r*Sz_all + Jxx_all [kg*m^2]
/// M_11 = P_gamma_gamma - r*P_gamma_lateral [kg*m^2]
/// C1_11 = deltaR_by_gamma*lateral_per_v_deltaR*P_gamma_lateral + P_gamma_yaw*(deltaF_by_gamma*yaw_per_v_deltaF + deltaR_by_gamma*yaw_per_v_deltaR) [kg*m]
/// Kc_11 = kF*deltaF_by_gamma^2 + kR*deltaR_by_gamma^2 [kg*m^2/s^2]
/// K0_11 = -P_gamma_lateral [kg*m]
/// K2_11 = P_gamma_lateral*(deltaF_by_gamma*yaw_per_v_deltaF + deltaR_by_gamma*yaw_per_v_deltaR) [kg]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Skateboard<T = f64> {
    /// Wheel base, from axle to axle.
    ///
    /// `L` in `m`: `> 0`.
    pub L: T,
    /// Half of the track, from the middle of an axle to a wheel.
    ///
    /// `b` in `m`: `> 0`.
    pub b: T,
    /// Radius of the wheels.
    ///
    /// `r` in `m`: `> 0`.
    pub r: T,
    /// Angle of the front king pin above the horizontal, rising forward.
    ///
    /// `lamF`, λF, in `rad`: `> 0 and < 1.5707963267948966`.
    pub lamF: T,
    /// Angle of the rear king pin above the horizontal, rising backward.
    ///
    /// `lamR`, λR, in `rad`: `> 0 and < 1.5707963267948966`.
    pub lamR: T,
    /// Stiffness of the front truck about its king pin.
    ///
    /// `kF` in `N*m`: `>= 0`.
    pub kF: T,
    /// Stiffness of the rear truck about its king pin.
    ///
    /// `kR` in `N*m`: `>= 0`.
    pub kR: T,
    /// Mass of board and rider.
    ///
    /// `m` in `kg`: `> 0`.
    pub m: T,
    /// Centre of mass, forward of the rear axle.
    ///
    /// `x` in `m`: any finite value.
    pub x: T,
    /// Centre of mass, above the axles.
    ///
    /// `h` in `m`: any finite value.
    pub h: T,
    /// Moment of inertia of board and rider about their centre of mass, in roll.
    ///
    /// `Ixx` in `kg*m^2`: `>= 0`.
    pub Ixx: T,
    /// Moment of inertia of board and rider about their centre of mass, in pitch.
    ///
    /// `Iyy` in `kg*m^2`: `>= 0`. No matrix depends on it.
    pub Iyy: T,
    /// Moment of inertia of board and rider about their centre of mass, in yaw.
    ///
    /// `Izz` in `kg*m^2`: `>= 0`. No matrix depends on it.
    pub Izz: T,
    /// Product of inertia of board and rider about their centre of mass.
    ///
    /// `Ixz` in `kg*m^2`: any finite value.
    pub Ixz: T,
    /// Gravitational field strength.
    ///
    /// `g` in `N/kg`: `>= 0`.
    pub g: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`Skateboard`], each 1 x 1 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkateboardMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''.
    pub m: Rows<T, 1>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 1>,
    /// Stiffness Kc, a coefficient of q.
    pub kc: Rows<T, 1>,
    /// Stiffness K0, a coefficient of g q.
    pub k0: Rows<T, 1>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 1>,
}

impl<T: Number> Skateboard<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 5 additions, 14 multiplications, 3 divisions, 1 negation and 4 trigonometric functions: 27 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> SkateboardMatrices<T> {
        let P_gamma_lateral = self.h * self.m;
        let M_11 = self.Ixx + self.h * P_gamma_lateral;
        let (lateral_per_v_deltaR, cos_lamR) = self.lamR.sin_cos();
        let t8 = self.L.like(1.0) / cos_lamR;
        let t10 = t8 * lateral_per_v_deltaR;
        let P_gamma_yaw = self.Ixz + P_gamma_lateral * self.x;
        let (sin_lamF, cos_lamF) = self.lamF.sin_cos();
        let t18 = self.L.like(1.0) / cos_lamF;
        let t21 = self.L.like(1.0) / self.L;
        let t25 = t18 * sin_lamF * t21 + t10 * t21;
        let C1_11 = P_gamma_yaw * t25 - P_gamma_lateral * t10;
        let Kc_11 = t18 * t18 * self.kF + t8 * t8 * self.kR;
        let K2_11 = P_gamma_lateral * t25;
        let K0_11 = -P_gamma_lateral;
        SkateboardMatrices::from_entries([M_11, C1_11, Kc_11, K0_11, K2_11])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`Skateboard`] that follow from its coordinates q = (`gamma`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkateboardKinematics<T = f64> {
    /// Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin.
    pub lateral: Rate<T, 1>,
    /// Yaw rate, to the right, in `rad/s`: of `B`.
    pub yaw: Rate<T, 1>,
    /// Rate of `deltaF`, in `rad/s`.
    pub deltaF: Rate<T, 1>,
    /// Rate of `deltaR`, in `rad/s`.
    pub deltaR: Rate<T, 1>,
    /// Spin of the wheel `FL`, front left: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_FL: Rate<T, 1>,
    /// Spin of the wheel `FR`, front right: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_FR: Rate<T, 1>,
    /// Spin of the wheel `RL`, rear left: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_RL: Rate<T, 1>,
    /// Spin of the wheel `RR`, rear right: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_RR: Rate<T, 1>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate,
    /// a column for each of `T` (tilt torque) in `N*m`.
    pub forces: [[T; 1]; 1],
}

impl<T: Scalar> Skateboard<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 addition, 6 multiplications, 4 divisions, 8 negations and 4 trigonometric functions: 23 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> SkateboardKinematics<T> {
        let zero = self.L.like(0.0);
        let (lateral_per_v_deltaR, cos_lamR) = self.lamR.sin_cos();
        let t4 = self.L.like(1.0) / cos_lamR;
        let t6 = t4 * lateral_per_v_deltaR;
        let (sin_lamF, cos_lamF) = self.lamF.sin_cos();
        let t11 = self.L.like(1.0) / cos_lamF;
        let t13 = t11 * sin_lamF;
        let t15 = (t6 + t13) / self.L;
        let t16 = self.L.like(1.0) / self.r;
        let t18 = t16 * self.b;
        let t19 = t13 * t18;
        let t20 = t15 * t18;
        let spin_RL_by_gamma = t6 * t18;
        let t22 = -self.r;
        let t23 = -t6;
        let t24 = -t11;
        let t25 = -t4;
        let t26 = -t16;
        let t27 = -t19;
        let t28 = -t20;
        let t29 = -spin_RL_by_gamma;
        SkateboardKinematics {
            lateral: Rate {
                speed: zero, rates: [t22], coordinates: [t23], heading: self.L.like(1.0),
            },
            yaw: Rate {
                speed: zero, rates: [zero], coordinates: [t15], heading: zero,
            },
            deltaF: Rate {
                speed: zero, rates: [t24], coordinates: [zero], heading: zero,
            },
            deltaR: Rate {
                speed: zero, rates: [t25], coordinates: [zero], heading: zero,
            },
            wheel_FL: Rate {
                speed: t26, rates: [t27], coordinates: [t28], heading: zero,
            },
            wheel_FR: Rate {
                speed: t26, rates: [t19], coordinates: [t20], heading: zero,
            },
            wheel_RL: Rate {
                speed: t26, rates: [spin_RL_by_gamma], coordinates: [t28], heading: zero,
            },
            wheel_RR: Rate {
                speed: t26, rates: [t29], coordinates: [t20], heading: zero,
            },
            forces: [[self.L.like(1.0)]],
        }
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`Skateboard`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkateboardDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 21],
}

impl<T: Number> Skateboard<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 12 additions, 32 multiplications, 3 divisions, 1 negation and 4 trigonometric functions: 52 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (SkateboardMatrices<T>, SkateboardDerivatives<T>) {
        let zero = self.L.like(0.0);
        let mut matrices = SkateboardMatrices::from_entries([zero; 5]);
        let mut derivatives = SkateboardDerivatives {
            values: [zero; 21],
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
        matrices: &mut SkateboardMatrices<T>,
        derivatives: &mut SkateboardDerivatives<T>,
    ) {
        *matrices = SkateboardMatrices::from_entries([self.L.like(0.0); 5]);
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
        put_derivative(1, self.h);
        put_derivative(2, self.L.like(1.0));
        let (lateral_per_v_deltaR, cos_lamR) = self.lamR.sin_cos();
        let (sin_lamF, cos_lamF) = self.lamF.sin_cos();
        let M_11_m = self.h * self.h;
        put_derivative(3, M_11_m);
        let M_11 = self.Ixx + self.m * M_11_m;
        put_entry(0, M_11);
        let t18 = self.L.like(1.0) / self.L;
        let P_gamma_lateral = self.m * self.h;
        let M_11_h = P_gamma_lateral + P_gamma_lateral;
        put_derivative(4, M_11_h);
        let K0_11 = -P_gamma_lateral;
        put_entry(3, K0_11);
        let t24 = t18 * (self.Ixz + self.x * P_gamma_lateral);
        let t25 = t18 * P_gamma_lateral;
        let t26 = self.L.like(1.0) / cos_lamR;
        let t27 = self.L.like(1.0) / cos_lamF;
        let t28 = t26 * lateral_per_v_deltaR;
        let Kc_11_kR = t26 * t26;
        put_derivative(5, Kc_11_kR);
        let t30 = self.kR * Kc_11_kR;
        let t32 = self.L.like(1.0) + t28 * t28;
        let t33 = t27 * sin_lamF;
        let Kc_11_kF = t27 * t27;
        put_derivative(6, Kc_11_kF);
        let t35 = t28 * t30;
        let C1_11_Ixz = t18 * (t28 + t33);
        put_derivative(7, C1_11_Ixz);
        let t38 = self.kF * Kc_11_kF;
        let t41 = t27 * (cos_lamF + sin_lamF * t33);
        let C1_11_lamR = t32 * (t24 - P_gamma_lateral);
        put_derivative(8, C1_11_lamR);
        let Kc_11_lamR = t35 + t35;
        put_derivative(9, Kc_11_lamR);
        let K2_11_lamR = t25 * t32;
        put_derivative(10, K2_11_lamR);
        let Kc_11 = t38 + t30;
        put_entry(2, Kc_11);
        let t47 = t33 * t38;
        let t49 = self.x * C1_11_Ixz - t28;
        let K2_11_h = self.m * C1_11_Ixz;
        put_derivative(11, K2_11_h);
        let t51 = C1_11_Ixz * t24;
        put_derivative(12, t51);
        let Kc_11_lamF = t47 + t47;
        put_derivative(13, Kc_11_lamF);
        let K2_11_m = self.h * C1_11_Ixz;
        put_derivative(14, K2_11_m);
        let K2_11 = self.h * K2_11_h;
        put_entry(4, K2_11);
        put_derivative(15, K2_11);
        let C1_11_lamF = t24 * t41;
        put_derivative(16, C1_11_lamF);
        let K2_11_lamF = t41 * t25;
        put_derivative(17, K2_11_lamF);
        let C1_11_m = self.h * t49;
        put_derivative(18, C1_11_m);
        let t58 = t18 * K2_11;
        put_derivative(19, t58);
        let C1_11_h = self.m * t49;
        put_derivative(20, C1_11_h);
        let C1_11 = self.m * C1_11_m + C1_11_Ixz * self.Ixz;
        put_entry(1, C1_11);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl Skateboard<f64> {
    /// The parameter set `example`.
    ///
    /// Source: An adult on a board; the figures are an example
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `L` | 0.8 | `m` |
    /// | `b` | 0.1 | `m` |
    /// | `r` | 0.03 | `m` |
    /// | `lamF` | 0.7853981633974483 | `rad` |
    /// | `lamR` | 0.7853981633974483 | `rad` |
    /// | `kF` | 50 | `N*m` |
    /// | `kR` | 50 | `N*m` |
    /// | `m` | 75 | `kg` |
    /// | `x` | 0.42 | `m` |
    /// | `h` | 0.9 | `m` |
    /// | `Ixx` | 9 | `kg*m^2` |
    /// | `Iyy` | 9 | `kg*m^2` |
    /// | `Izz` | 1 | `kg*m^2` |
    /// | `Ixz` | 0 | `kg*m^2` |
    /// | `g` | 9.81 | `N/kg` |
    pub const EXAMPLE: Self = Self {
        L: 0.8, b: 0.1, r: 0.03, lamF: 0.7853981633974483, lamR: 0.7853981633974483, kF: 50.0,
        kR: 50.0, m: 75.0, x: 0.42, h: 0.9, Ixx: 9.0, Iyy: 9.0, Izz: 1.0, Ixz: 0.0, g: 9.81,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> Skateboard<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 15]) -> Self {
        Self {
            L: values[0], b: values[1], r: values[2], lamF: values[3], lamR: values[4],
            kF: values[5], kR: values[6], m: values[7], x: values[8], h: values[9], Ixx: values[10],
            Iyy: values[11], Izz: values[12], Ixz: values[13], g: values[14],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 15] {
        [
            self.L, self.b, self.r, self.lamF, self.lamR, self.kF, self.kR, self.m, self.x, self.h,
            self.Ixx, self.Iyy, self.Izz, self.Ixz, self.g,
        ]
    }
}

impl<T: Scalar> Skateboard<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> Skateboard<U> {
        let values = self.to_array();
        Skateboard::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl Skateboard<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> Skateboard<f32> {
        Skateboard::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<Skateboard<f32>> for Skateboard<f64> {
    fn from(parameters: Skateboard<f32>) -> Self {
        Skateboard::cast(&parameters)
    }
}

impl<T: Number> SkateboardMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 5]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c1: carvallo::rows(&entries, 1),
            kc: carvallo::rows(&entries, 2),
            k0: carvallo::rows(&entries, 3),
            k2: carvallo::rows(&entries, 4),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 5] {
        [self.m[0][0], self.c1[0][0], self.kc[0][0], self.k0[0][0], self.k2[0][0]]
    }

    /// Sets the entry at a position among those that differ, wherever it stands.
    #[inline(always)]
    fn set_entry(&mut self, position: usize, entry: T) {
        match position {
            0 => {
                self.m[0][0] = entry;
            }
            1 => {
                self.c1[0][0] = entry;
            }
            2 => {
                self.kc[0][0] = entry;
            }
            3 => {
                self.k0[0][0] = entry;
            }
            4 => {
                self.k2[0][0] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 1]; 1]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 1]; 1];
        [self.m.0, zeros, zeros, self.c1.0, self.kc.0, self.k0.0, zeros, self.k2.0]
    }
}

impl<T: Scalar> From<SkateboardMatrices<T>> for Coefficients<T, 1> {
    fn from(matrices: SkateboardMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<1> for Skateboard<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 15];

    type Over<U: Number> = Skateboard<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "Skateboard",
        docs: "A skateboard with a rider who stands still on it: one degree of freedom, the tilt of the board.\n\nEach truck turns about its king pin, which passes through the middle of its axle, with a wheel at either end. All\nfour wheels stay on the ground and do not slip, so that tilting steers both axles. Trucks and wheels have no mass;\nboard and rider are one rigid body. Axes: origin on the ground below the rear axle, x forward, y to the right, z\ndown.",
        source: "Mechanism: Hubbard (1979), J. Appl. Mech. 46, 931-936; Kremnev & Kuleshov (2010), DCDS-S 3, 85-103",
        parameters: &[
            ParameterInfo::new("L", "m", Domain::POSITIVE)
                .docs("Wheel base, from axle to axle."),
            ParameterInfo::new("b", "m", Domain::POSITIVE)
                .docs("Half of the track, from the middle of an axle to a wheel."),
            ParameterInfo::new("r", "m", Domain::POSITIVE).docs("Radius of the wheels."),
            ParameterInfo::new(
                    "lamF",
                    "rad",
                    Domain::between(Bound::Open(0.0), Bound::Open(1.5707963267948966)),
                )
                .symbol("λF")
                .docs("Angle of the front king pin above the horizontal, rising forward."),
            ParameterInfo::new(
                    "lamR",
                    "rad",
                    Domain::between(Bound::Open(0.0), Bound::Open(1.5707963267948966)),
                )
                .symbol("λR")
                .docs("Angle of the rear king pin above the horizontal, rising backward."),
            ParameterInfo::new("kF", "N*m", Domain::NONNEGATIVE)
                .docs("Stiffness of the front truck about its king pin."),
            ParameterInfo::new("kR", "N*m", Domain::NONNEGATIVE)
                .docs("Stiffness of the rear truck about its king pin."),
            ParameterInfo::new("m", "kg", Domain::POSITIVE)
                .docs("Mass of board and rider."),
            ParameterInfo::new("x", "m", Domain::FINITE)
                .docs("Centre of mass, forward of the rear axle."),
            ParameterInfo::new("h", "m", Domain::FINITE)
                .docs("Centre of mass, above the axles."),
            ParameterInfo::new("Ixx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of board and rider about their centre of mass, in roll."),
            ParameterInfo::new("Iyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of board and rider about their centre of mass, in pitch.")
                .unused(),
            ParameterInfo::new("Izz", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of board and rider about their centre of mass, in yaw.")
                .unused(),
            ParameterInfo::new("Ixz", "kg*m^2", Domain::FINITE)
                .docs("Product of inertia of board and rider about their centre of mass."),
            ParameterInfo::new("g", "N/kg", Domain::NONNEGATIVE)
                .docs("Gravitational field strength."),
        ],
        coordinates: &[
            CoordinateInfo::new("gamma", "rad")
                .label("tilt")
                .docs("Tilt of the board, to the right."),
        ],
        forces: &[
            carvallo::motion::AppliedInfo {
                name: "T", label: "tilt torque", unit: "N*m", position: "gamma",
            },
        ],
        matrices: &[
            MatrixName::M, MatrixName::C1, MatrixName::Kc, MatrixName::K0, MatrixName::K2,
        ],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]), EntryInfo::at(&[(MatrixName::C1, 0, 0)]),
            EntryInfo::at(&[(MatrixName::Kc, 0, 0)]), EntryInfo::at(&[(MatrixName::K0, 0, 0)]),
            EntryInfo::at(&[(MatrixName::K2, 0, 0)]),
        ],
        sets: &[
            SetInfo {
                name: "example",
                docs: "",
                source: "An adult on a board; the figures are an example",
                values: &Skateboard::to_array(&Skateboard::<f64>::EXAMPLE),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("pitch_by_vertical", "1/m", "1/L"),
            FormulaInfo::definition("deltaF_by_gamma", "1", "-1/cos(lamF)"),
            FormulaInfo::definition("deltaR_by_gamma", "1", "-1/cos(lamR)"),
            FormulaInfo::definition("yaw_per_v_deltaF", "1/m", "-sin(lamF)/L"),
            FormulaInfo::definition("lateral_per_v_deltaR", "1", "sin(lamR)"),
            FormulaInfo::definition("yaw_per_v_deltaR", "1/m", "-pitch_by_vertical*lateral_per_v_deltaR"),
            FormulaInfo::definition("Jxx_all", "kg*m^2", "m*(r + h)^2 + Ixx"),
            FormulaInfo::definition("Jxz_all", "kg*m^2", "m*x*(r + h) + Ixz"),
            FormulaInfo::definition("Sx_all", "kg*m", "m*x"),
            FormulaInfo::definition("Sz_all", "kg*m", "-m*(r + h)"),
            FormulaInfo::definition("P_gamma_lateral", "kg*m", "m*h"),
            FormulaInfo::definition("P_gamma_yaw", "kg*m^2", "Jxz_all - r*Sx_all"),
            FormulaInfo::definition("P_gamma_gamma", "kg*m^2", "r*Sz_all + Jxx_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "P_gamma_gamma - r*P_gamma_lateral"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 0)],
                "kg*m",
                "deltaR_by_gamma*lateral_per_v_deltaR*P_gamma_lateral + P_gamma_yaw*(deltaF_by_gamma*yaw_per_v_deltaF + deltaR_by_gamma*yaw_per_v_deltaR)",
            ),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 0)], "kg*m^2/s^2", "kF*deltaF_by_gamma^2 + kR*deltaR_by_gamma^2"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "-P_gamma_lateral"),
            FormulaInfo::entry(
                &[(MatrixName::K2, 0, 0)],
                "kg",
                "P_gamma_lateral*(deltaF_by_gamma*yaw_per_v_deltaF + deltaR_by_gamma*yaw_per_v_deltaR)",
            ),
        ],
        attributes: &[
            FormulaInfo::attribute("B_mass", "the mass of the board and rider B", "kg", "m"),
            FormulaInfo::attribute("B_x", "x of the centre of mass of the board and rider B", "m", "x"),
            FormulaInfo::attribute("B_z", "z of the centre of mass of the board and rider B", "m", "-r - h"),
            FormulaInfo::attribute("B_Ixx", "the inertia xx of the board and rider B", "kg*m^2", "Ixx"),
            FormulaInfo::attribute("B_Ixz", "the inertia xz of the board and rider B", "kg*m^2", "Ixz"),
            FormulaInfo::attribute("B_Izz", "the inertia zz of the board and rider B", "kg*m^2", "Izz"),
            FormulaInfo::attribute("FL_radius", "the radius of the front left FL", "m", "r"),
            FormulaInfo::attribute("FL_x", "x of the centre of the front left FL", "m", "L"),
            FormulaInfo::attribute("FL_y", "y of the centre of the front left FL", "m", "-b"),
            FormulaInfo::attribute("FL_z", "z of the centre of the front left FL", "m", "-r"),
            FormulaInfo::attribute("FR_radius", "the radius of the front right FR", "m", "r"),
            FormulaInfo::attribute("FR_x", "x of the centre of the front right FR", "m", "L"),
            FormulaInfo::attribute("FR_y", "y of the centre of the front right FR", "m", "b"),
            FormulaInfo::attribute("FR_z", "z of the centre of the front right FR", "m", "-r"),
            FormulaInfo::attribute("RL_radius", "the radius of the rear left RL", "m", "r"),
            FormulaInfo::attribute("RL_y", "y of the centre of the rear left RL", "m", "-b"),
            FormulaInfo::attribute("RL_z", "z of the centre of the rear left RL", "m", "-r"),
            FormulaInfo::attribute("RR_radius", "the radius of the rear right RR", "m", "r"),
            FormulaInfo::attribute("RR_y", "y of the centre of the rear right RR", "m", "b"),
            FormulaInfo::attribute("RR_z", "z of the centre of the rear right RR", "m", "-r"),
            FormulaInfo::attribute("deltaF_through_x", "x of the point of the joint deltaF", "m", "L"),
            FormulaInfo::attribute("deltaF_through_z", "z of the point of the joint deltaF", "m", "-r"),
            FormulaInfo::attribute("deltaF_along_x", "x of the axis of the joint deltaF", "1", "cos(lamF)"),
            FormulaInfo::attribute("deltaF_along_z", "z of the axis of the joint deltaF", "1", "-sin(lamF)"),
            FormulaInfo::attribute("deltaF_spring", "the spring of the joint deltaF", "kg*m^2/s^2", "kF"),
            FormulaInfo::attribute("deltaR_through_z", "z of the point of the joint deltaR", "m", "-r"),
            FormulaInfo::attribute("deltaR_along_x", "x of the axis of the joint deltaR", "1", "cos(lamR)"),
            FormulaInfo::attribute("deltaR_along_z", "z of the axis of the joint deltaR", "1", "sin(lamR)"),
            FormulaInfo::attribute("deltaR_spring", "the spring of the joint deltaR", "kg*m^2/s^2", "kR"),
            FormulaInfo::definition("length_deltaF", "1", "sqrt(deltaF_along_x^2 + deltaF_along_z^2)"),
            FormulaInfo::definition("length_deltaR", "1", "sqrt(deltaR_along_x^2 + deltaR_along_z^2)"),
            FormulaInfo::definition("pitch_by_vertical", "1/m", "1/FL_x"),
            FormulaInfo::definition("pitch_by_gamma", "1", "FL_y/FL_x"),
            FormulaInfo::definition(
                "deltaF_by_vertical",
                "1/m",
                "FL_x*(FR_x*pitch_by_vertical - 1)*sqrt(deltaF_along_x^2 + deltaF_along_z^2)/deltaF_along_x/(FL_x*FR_y - FL_y*FR_x)",
            ),
            FormulaInfo::definition(
                "deltaF_by_gamma",
                "1",
                "FL_x*sqrt(deltaF_along_x^2 + deltaF_along_z^2)*(FR_x*pitch_by_gamma - FR_y)/deltaF_along_x/(FL_x*FR_y - FL_y*FR_x)",
            ),
            FormulaInfo::definition("vertical_by_deltaR", "m", "-RL_y*deltaR_along_x/length_deltaR"),
            FormulaInfo::definition("deltaF_by_gamma_", "1", "deltaF_by_gamma - RL_y*deltaF_by_vertical"),
            FormulaInfo::definition("deltaF_by_deltaR", "1", "deltaF_by_vertical*vertical_by_deltaR"),
            FormulaInfo::definition(
                "deltaR_by_gamma",
                "1",
                "-sqrt(deltaR_along_x^2 + deltaR_along_z^2)/deltaR_along_x",
            ),
            FormulaInfo::definition("deltaF_by_gamma__", "1", "deltaF_by_gamma_ + deltaF_by_deltaR*deltaR_by_gamma"),
            FormulaInfo::definition(
                "yaw_by_gamma",
                "1",
                "-(deltaF_by_gamma__*(deltaF_along_z*(FL_x - deltaF_through_x) - deltaF_along_x*(FL_radius + FL_z - deltaF_through_z))/length_deltaF - (FL_radius + FL_z))/FL_x",
            ),
            FormulaInfo::definition("yaw_per_v_deltaF", "1/m", "deltaF_along_z/FL_x/length_deltaF"),
            FormulaInfo::definition(
                "lateral_by_gamma",
                "m",
                "(deltaR_along_x*deltaR_by_gamma*(RL_radius + RL_z - deltaR_through_z) + length_deltaR*(RL_radius + RL_z))/length_deltaR",
            ),
            FormulaInfo::definition("lateral_per_v_deltaR", "1", "deltaR_along_z/length_deltaR"),
            FormulaInfo::definition("yaw_by_gamma_", "1", "yaw_by_gamma - pitch_by_vertical*lateral_by_gamma"),
            FormulaInfo::definition("yaw_per_v_deltaR", "1/m", "-pitch_by_vertical*lateral_per_v_deltaR"),
            FormulaInfo::definition("Jxx_all", "kg*m^2", "B_mass*B_z^2 + B_Ixx"),
            FormulaInfo::definition("Jxz_all", "kg*m^2", "B_Ixz - B_mass*B_x*B_z"),
            FormulaInfo::definition("Jzz_all", "kg*m^2", "B_mass*B_x^2 + B_Izz"),
            FormulaInfo::definition("Sx_all", "kg*m", "B_mass*B_x"),
            FormulaInfo::definition("Sz_all", "kg*m", "B_mass*B_z"),
            FormulaInfo::definition("load_spin_RR", "1", "(RL_y - FL_y)/(RR_y - RL_y)"),
            FormulaInfo::definition("load_spin_RR_", "1", "(RL_y - FR_y)/(RR_y - RL_y)"),
            FormulaInfo::definition("load_spin_RR__", "kg", "B_mass*RL_y/(RR_y - RL_y)"),
            FormulaInfo::definition("load_spin_RL", "1", "-1 - load_spin_RR"),
            FormulaInfo::definition("load_spin_RL_", "1", "-1 - load_spin_RR_"),
            FormulaInfo::definition("load_spin_RL__", "kg", "-(B_mass + load_spin_RR__)"),
            FormulaInfo::definition("load_spin_FL", "1", "-FR_x/FL_x"),
            FormulaInfo::definition("load_spin_FL_", "kg", "-Sx_all/FL_x"),
            FormulaInfo::definition("load_spin_RL___", "1", "load_spin_RL*load_spin_FL + load_spin_RL_"),
            FormulaInfo::definition("load_spin_RL____", "kg", "load_spin_RL*load_spin_FL_ + load_spin_RL__"),
            FormulaInfo::definition("load_spin_RR___", "1", "load_spin_RR*load_spin_FL + load_spin_RR_"),
            FormulaInfo::definition("load_spin_RR____", "kg", "load_spin_RR*load_spin_FL_ + load_spin_RR__"),
            FormulaInfo::definition(
                "load_spin_FR",
                "kg",
                "FL_x*FL_y*load_spin_FL_*sqrt(deltaF_along_x^2 + deltaF_along_z^2)/length_deltaF/(FL_y*FR_x - FL_x*FR_y)",
            ),
            FormulaInfo::definition("load_spin_RL_____", "kg", "load_spin_RL___*load_spin_FR + load_spin_RL____"),
            FormulaInfo::definition("load_spin_RR_____", "kg", "load_spin_RR___*load_spin_FR + load_spin_RR____"),
            FormulaInfo::definition("load_spin_FL__", "kg", "load_spin_FL*load_spin_FR + load_spin_FL_"),
            FormulaInfo::definition(
                "K_gamma_gamma",
                "kg*m",
                "Sz_all + load_spin_FR*(FR_radius + FR_z) + load_spin_RL_____*(RL_radius + RL_z) + load_spin_RR_____*(RR_radius + RR_z) + load_spin_FL__*(FL_radius + FL_z)",
            ),
            FormulaInfo::definition(
                "K_gamma_deltaF",
                "kg*m",
                "-(load_spin_FR*(deltaF_along_z*(FR_x - deltaF_through_x) - deltaF_along_x*(FR_radius + FR_z - deltaF_through_z)) + load_spin_FL__*(deltaF_along_z*(FL_x - deltaF_through_x) - deltaF_along_x*(FL_radius + FL_z - deltaF_through_z)))/length_deltaF",
            ),
            FormulaInfo::definition(
                "K_gamma_deltaR",
                "kg*m",
                "deltaR_along_x*(load_spin_RL_____*(RL_radius + RL_z - deltaR_through_z) + load_spin_RR_____*(RR_radius + RR_z - deltaR_through_z))/length_deltaR",
            ),
            FormulaInfo::definition(
                "P_gamma_lateral",
                "kg*m",
                "B_mass*lateral_by_gamma + yaw_by_gamma_*Sx_all - Sz_all",
            ),
            FormulaInfo::definition(
                "P_gamma_yaw",
                "kg*m^2",
                "lateral_by_gamma*Sx_all + yaw_by_gamma_*Jzz_all + Jxz_all",
            ),
            FormulaInfo::definition(
                "P_gamma_gamma",
                "kg*m^2",
                "yaw_by_gamma_*Jxz_all + Jxx_all - lateral_by_gamma*Sz_all",
            ),
            FormulaInfo::definition(
                "W_gamma_gamma",
                "kg*m",
                "deltaR_by_gamma*K_gamma_deltaR + deltaF_by_gamma__*K_gamma_deltaF + K_gamma_gamma",
            ),
            FormulaInfo::entry(
                &[(MatrixName::M, 0, 0)],
                "kg*m^2",
                "lateral_by_gamma*P_gamma_lateral + yaw_by_gamma_*P_gamma_yaw + P_gamma_gamma",
            ),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 0)],
                "kg*m",
                "deltaR_by_gamma*lateral_per_v_deltaR*P_gamma_lateral + yaw_by_gamma_*P_gamma_lateral + P_gamma_yaw*(deltaR_by_gamma*yaw_per_v_deltaR + deltaF_by_gamma__*yaw_per_v_deltaF)",
            ),
            FormulaInfo::entry(
                &[(MatrixName::Kc, 0, 0)],
                "kg*m^2/s^2",
                "deltaF_spring*deltaF_by_gamma__^2 + deltaR_spring*deltaR_by_gamma^2",
            ),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "W_gamma_gamma"),
            FormulaInfo::entry(
                &[(MatrixName::K2, 0, 0)],
                "kg",
                "P_gamma_lateral*(deltaR_by_gamma*yaw_per_v_deltaR + deltaF_by_gamma__*yaw_per_v_deltaF)",
            ),
        ],
        motion: None,
        gravity: Some(14),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("Skateboard", 15, values)?;
        Ok(<Self as Evaluator<T, 1>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("Skateboard", 15, values)?;
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
        let info = const { &<Self as Model<1>>::INFO.without_formulas() };
        info.validate(&self.to_array().map(Scalar::to_f64))?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 1> {
        Coefficients::from_rows(SkateboardMatrices::rows(&self.matrices()))
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 1>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn shares(&self, force: usize) -> Option<[T; 1]> {
        (force < 1).then(|| self.kinematics().forces.map(|row| row[force]))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl Skateboard<f64> {
    /// What the model tells about itself, the same for every number type.
    pub const INFO: &'static ModelInfo = <Self as Model<1>>::INFO;

    /// The parameter set of this name, however it is spelt: upper and lower case, `_`, `-` and spaces make no
    /// difference. In `f32` it is had by the trait `Model`.
    #[must_use]
    pub fn set(name: &str) -> Option<Self> {
        <Self as Model<1>>::set(name)
    }
}

/// The parameters, one a line with its unit, in the precision that is asked for; `{:#}` says what they are.
impl<T: Scalar> core::fmt::Display for Skateboard<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<1>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 1> for Skateboard<T> {
    type Entries = [T; 5];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            L: parameter(0), b: parameter(1), r: parameter(2), lamF: parameter(3),
            lamR: parameter(4), kF: parameter(5), kR: parameter(6), m: parameter(7),
            x: parameter(8), h: parameter(9), Ixx: parameter(10), Iyy: parameter(11),
            Izz: parameter(12), Ixz: parameter(13), g: parameter(14),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        SkateboardMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 1]; 1]; 8] {
        SkateboardMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> SkateboardDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<SkateboardMatrices<T>> {
        if parameter >= 15 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = SkateboardMatrices {
            m: Rows([[zero; 1]; 1]), c1: Rows([[zero; 1]; 1]), kc: Rows([[zero; 1]; 1]),
            k0: Rows([[zero; 1]; 1]), k2: Rows([[zero; 1]; 1]),
        };
        for position in 0..21 {
            let partial = <SkateboardDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C1 => &mut matrices.c1,
                MatrixName::Kc => &mut matrices.kc,
                MatrixName::K0 => &mut matrices.k0,
                MatrixName::K2 => &mut matrices.k2,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<1> for Skateboard<T> {
    type Derivatives = [Coefficients<T, 1>; 15];

    type WithDerivativesOver<U: Number> = Skateboard<U>;

    const PARTIALS: &'static [Partial] = <SkateboardDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 1>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 1]; 1]; 8]); 15];
        for position in 0..21 {
            Partial::write(&<SkateboardDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(SkateboardMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 1> for Skateboard<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl SkateboardDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 21] = &[
        Partial::new(MatrixName::C1, 0, 0, 0, 12).negative(),
        Partial::new(MatrixName::K2, 0, 0, 0, 19).negative(),
        Partial::new(MatrixName::C1, 0, 0, 3, 16), Partial::new(MatrixName::Kc, 0, 0, 3, 13),
        Partial::new(MatrixName::K2, 0, 0, 3, 17), Partial::new(MatrixName::C1, 0, 0, 4, 8),
        Partial::new(MatrixName::Kc, 0, 0, 4, 9), Partial::new(MatrixName::K2, 0, 0, 4, 10),
        Partial::new(MatrixName::Kc, 0, 0, 5, 6), Partial::new(MatrixName::Kc, 0, 0, 6, 5),
        Partial::new(MatrixName::M, 0, 0, 7, 3), Partial::new(MatrixName::C1, 0, 0, 7, 18),
        Partial::new(MatrixName::K0, 0, 0, 7, 1).negative(),
        Partial::new(MatrixName::K2, 0, 0, 7, 14), Partial::new(MatrixName::C1, 0, 0, 8, 15),
        Partial::new(MatrixName::M, 0, 0, 9, 4), Partial::new(MatrixName::C1, 0, 0, 9, 20),
        Partial::new(MatrixName::K0, 0, 0, 9, 0).negative(),
        Partial::new(MatrixName::K2, 0, 0, 9, 11), Partial::new(MatrixName::M, 0, 0, 10, 2),
        Partial::new(MatrixName::C1, 0, 0, 13, 7),
    ];
}
