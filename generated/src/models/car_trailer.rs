// @generated from generated/models/car_trailer.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 1a935d722786e794

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo, States,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A car with a trailer, which snakes above a critical speed.
///
/// Car and trailer are one rigid body each, joined by a ball at which only yaw takes part, on tyres whose side forces are
/// linear in slip. What two front wheels do is in one, and so it is for the trailer; its load on the ball is that of its
/// centre of mass. Axes: origin on the ground below the centre of mass of the car, x forward, y to the right, z down.
///
/// Source: Mechanism of the single-track car with a trailer, as in Hac, Fulk & Chen (2008), SAE 2008-01-1228
///
/// Derived from a mechanism: body `B` (car), body `P` (ball), body `T` (trailer), wheel `F` (front axle), wheel `L` (rear left), wheel `R` (rear right), wheel `U` (axle of the trailer).
///
/// The fields are the parameters. The coordinates are `y` (lateral) in `m`, of which only the rate is a state; `psi` (yaw) in `rad`, of which only the rate is a state; `q` (hitch) in `rad`.
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
/// Jyy_q = mT*e^2 + IT [kg*m^2]
/// Sx_q = -mT*e [kg*m]
/// Jzz_all = I + Jyy_q - 2*h*(Sx_q - (1/2)*h*mT) [kg*m^2]
/// Sx_all = Sx_q - h*mT [kg*m]
/// m_all = m + mT [kg]
/// M_psi_q = Jyy_q - h*Sx_q [kg*m^2]
/// M_11 = m_all [kg]
/// M_12 = M_21 = Sx_all [kg*m]
/// M_13 = M_31 = Sx_q [kg*m]
/// M_22 = Jzz_all [kg*m^2]
/// M_23 = M_32 = M_psi_q [kg*m^2]
/// M_33 = Jyy_q [kg*m^2]
/// C-1_11 = Cf + Cr + CT [kg*m/s^2]
/// C-1_12 = C-1_21 = a*Cf - b*Cr - CT*(h + l) [kg*m^2/s^2]
/// C-1_13 = C-1_31 = -l*CT [kg*m^2/s^2]
/// C-1_22 = CT*(h + l)^2 + a^2*Cf + b^2*Cr [kg*m^3/s^2]
/// C-1_23 = C-1_32 = l*CT*(h + l) [kg*m^3/s^2]
/// C-1_33 = l^2*CT [kg*m^3/s^2]
/// C0_33 = d [kg*m^2/s]
/// C1_12 = m_all [kg]
/// C1_22 = Sx_all [kg*m]
/// C1_32 = Sx_q [kg*m]
/// Kc_13 = -CT [kg*m/s^2]
/// Kc_23 = CT*(h + l) [kg*m^2/s^2]
/// Kc_33 = l*CT [kg*m^2/s^2]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct CarTrailer<T = f64> {
    /// Mass of the car.
    ///
    /// `m` in `kg`: `> 0`.
    pub m: T,
    /// Moment of inertia of the car about its centre of mass, in yaw.
    ///
    /// `I` in `kg*m^2`: `> 0`.
    pub I: T,
    /// From the centre of mass of the car forward to the front axle.
    ///
    /// `a` in `m`: `> 0`.
    pub a: T,
    /// From the centre of mass of the car backward to the rear axle.
    ///
    /// `b` in `m`: `> 0`.
    pub b: T,
    /// From the centre of mass of the car backward to the ball.
    ///
    /// `h` in `m`: `> 0`.
    pub h: T,
    /// Mass of the trailer.
    ///
    /// `mT` in `kg`: `> 0`.
    pub mT: T,
    /// Moment of inertia of the trailer about its centre of mass, in yaw.
    ///
    /// `IT` in `kg*m^2`: `> 0`.
    pub IT: T,
    /// From the ball backward to the centre of mass of the trailer.
    ///
    /// `e` in `m`: any finite value.
    pub e: T,
    /// From the ball backward to the axle of the trailer.
    ///
    /// `l` in `m`: `> 0`.
    pub l: T,
    /// Cornering stiffness of the front axle of the car.
    ///
    /// `Cf` in `N/rad`: `> 0`.
    pub Cf: T,
    /// Cornering stiffness of the rear axle of the car, of both wheels.
    ///
    /// `Cr` in `N/rad`: `> 0`.
    pub Cr: T,
    /// Cornering stiffness of the axle of the trailer.
    ///
    /// `CT` in `N/rad`: `> 0`.
    pub CT: T,
    /// Damping of yaw at the ball.
    ///
    /// `d` in `N*m*s/rad`: `>= 0`.
    pub d: T,
    /// Half of the track of the rear axle.
    ///
    /// `t` in `m`: `> 0`.
    pub t: T,
    /// Radius of the wheels.
    ///
    /// `r` in `m`: `> 0`.
    pub r: T,
    /// Gravitational field strength.
    ///
    /// `g` in `N/kg`: `>= 0`.
    pub g: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`CarTrailer`], each 3 x 3 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarTrailerMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 3>,
    /// Damping C-1, a coefficient of q'/v. Symmetric, proved.
    pub cm1: Rows<T, 3>,
    /// Damping C0, a coefficient of q'. Symmetric, proved.
    pub c0: Rows<T, 3>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 3>,
    /// Stiffness Kc, a coefficient of q.
    pub kc: Rows<T, 3>,
}

impl<T: Number> CarTrailer<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 13 additions, 14 multiplications and 4 negations: 31 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> CarTrailerMatrices<T> {
        let m_all = self.m + self.mT;
        let t6 = self.mT * (self.e + self.h);
        let t7 = self.mT * self.e;
        let M_psi_q = self.IT + self.e * t6;
        let Jzz_all = self.h * t6 + (self.I + M_psi_q);
        let Jyy_q = self.IT + self.e * t7;
        let Cm1_11 = self.Cf + self.Cr + self.CT;
        let t23 = self.h + self.l;
        let Kc_23 = self.CT * t23;
        let t26 = self.Cf * self.a;
        let t29 = self.Cr * self.b;
        let Kc_33 = self.CT * self.l;
        let Cm1_22 = self.a * t26 + (self.b * t29 + t23 * Kc_23);
        let Cm1_23 = t23 * Kc_33;
        let Cm1_33 = self.l * Kc_33;
        let zero = self.m.like(0.0);
        let M_12 = -t6;
        let M_13 = -t7;
        let Cm1_12 = t26 - Kc_23 - t29;
        let Cm1_13 = -Kc_33;
        let Kc_13 = -self.CT;
        CarTrailerMatrices::from_entries([
            m_all, M_12, M_13, M_12, Jzz_all, M_psi_q, M_13, M_psi_q, Jyy_q, Cm1_11, Cm1_12, Cm1_13,
            Cm1_12, Cm1_22, Cm1_23, Cm1_13, Cm1_23, Cm1_33, zero, zero, zero, zero, zero, zero,
            zero, zero, self.d, zero, m_all, zero, zero, M_12, zero, zero, M_13, zero, zero, zero,
            Kc_13, zero, zero, Kc_23, zero, zero, Kc_33,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`CarTrailer`] that follow from its coordinates q = (`y`, `psi`, `q`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarTrailerKinematics<T = f64> {
    /// Rate, in `rad/s`: of `B`.
    pub lean: Rate<T, 3>,
    /// Rate of `pitch`, in `rad/s`.
    pub pitch: Rate<T, 3>,
    /// Spin of the wheel `F`, front axle: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_F: Rate<T, 3>,
    /// Spin of the wheel `L`, rear left: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_L: Rate<T, 3>,
    /// Spin of the wheel `R`, rear right: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_R: Rate<T, 3>,
    /// Spin of the wheel `U`, axle of the trailer: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_U: Rate<T, 3>,
}

impl<T: Scalar> CarTrailer<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 1 division and 2 negations: 4 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> CarTrailerKinematics<T> {
        let zero = self.m.like(0.0);
        let t2 = self.m.like(1.0) / self.r;
        let t4 = t2 * self.t;
        let t5 = -t2;
        let t6 = -t4;
        CarTrailerKinematics {
            lean: Rate {
                speed: zero, rates: [zero, zero, zero], coordinates: [zero, zero, zero],
                heading: zero,
            },
            pitch: Rate {
                speed: zero, rates: [zero, zero, zero], coordinates: [zero, zero, zero],
                heading: zero,
            },
            wheel_F: Rate {
                speed: t5, rates: [zero, zero, zero], coordinates: [zero, zero, zero],
                heading: zero,
            },
            wheel_L: Rate {
                speed: t5, rates: [zero, t6, zero], coordinates: [zero, zero, zero], heading: zero,
            },
            wheel_R: Rate {
                speed: t5, rates: [zero, t4, zero], coordinates: [zero, zero, zero], heading: zero,
            },
            wheel_U: Rate {
                speed: t5, rates: [zero, zero, zero], coordinates: [zero, zero, zero],
                heading: zero,
            },
        }
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`CarTrailer`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarTrailerDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 30],
}

impl<T: Number> CarTrailer<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 21 additions, 22 multiplications and 4 negations: 47 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (CarTrailerMatrices<T>, CarTrailerDerivatives<T>) {
        let zero = self.m.like(0.0);
        let mut matrices = CarTrailerMatrices::from_entries([zero; 45]);
        let mut derivatives = CarTrailerDerivatives {
            values: [zero; 30],
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
        matrices: &mut CarTrailerMatrices<T>,
        derivatives: &mut CarTrailerDerivatives<T>,
    ) {
        *matrices = CarTrailerMatrices::from_entries([self.m.like(0.0); 45]);
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
        put_entry(12, self.d);
        put_derivative(0, self.a);
        put_derivative(1, self.b);
        put_derivative(2, self.mT);
        put_derivative(3, self.e);
        put_derivative(4, self.l);
        put_derivative(5, self.Cf);
        put_derivative(6, self.Cr);
        put_derivative(7, self.CT);
        put_derivative(8, self.m.like(1.0));
        put_derivative(9, self.m.like(-1.0));
        let m_all = self.m + self.mT;
        put_entry(0, m_all);
        let t17 = self.e + self.h;
        put_derivative(10, t17);
        let t18 = self.mT * t17;
        let M_23_h = self.mT * self.e;
        put_derivative(11, M_23_h);
        let M_23_e = t18 + M_23_h;
        put_derivative(12, M_23_e);
        let Jyy_q = self.e * M_23_h + self.IT;
        put_entry(5, Jyy_q);
        let M_23_mT = self.e * t17;
        put_derivative(13, M_23_mT);
        let M_psi_q = self.IT + self.mT * M_23_mT;
        put_entry(4, M_psi_q);
        let Cm1_11 = self.Cf + self.Cr + self.CT;
        put_entry(6, Cm1_11);
        let Jzz_all = self.h * M_23_e + self.I + Jyy_q;
        put_entry(3, Jzz_all);
        let t31 = self.Cr * self.b;
        let Kc_23_CT = self.h + self.l;
        put_derivative(14, Kc_23_CT);
        let Kc_23 = self.CT * Kc_23_CT;
        put_entry(14, Kc_23);
        let M_22_mT = t17 * t17;
        put_derivative(15, M_22_mT);
        let t35 = self.Cf * self.a;
        let Cm1_12 = t35 - t31 - Kc_23;
        put_entry(7, Cm1_12);
        let Cm1_22 = self.b * t31 + Kc_23_CT * Kc_23 + self.a * t35;
        put_entry(9, Cm1_22);
        let Cm1_22_a = t35 + t35;
        put_derivative(16, Cm1_22_a);
        let Kc_33 = self.CT * self.l;
        put_entry(15, Kc_33);
        put_derivative(17, Kc_33);
        let Cm1_22_b = t31 + t31;
        put_derivative(18, Cm1_22_b);
        let Cm1_23_CT = self.l * Kc_23_CT;
        put_derivative(19, Cm1_23_CT);
        let Cm1_23 = self.CT * Cm1_23_CT;
        put_entry(10, Cm1_23);
        let Cm1_33_CT = self.l * self.l;
        put_derivative(20, Cm1_33_CT);
        let Cm1_33 = self.CT * Cm1_33_CT;
        put_entry(11, Cm1_33);
        let M_22_h = t18 + t18;
        put_derivative(21, M_22_h);
        let Cm1_22_h = Kc_23 + Kc_23;
        put_derivative(22, Cm1_22_h);
        let Jyy_q_mT = self.e * self.e;
        put_derivative(23, Jyy_q_mT);
        let Jyy_q_e = M_23_h + M_23_h;
        put_derivative(24, Jyy_q_e);
        let Cm1_23_l = Kc_23 + Kc_33;
        put_derivative(25, Cm1_23_l);
        let Cm1_33_l = Kc_33 + Kc_33;
        put_derivative(26, Cm1_33_l);
        let Cm1_22_Cf = self.a * self.a;
        put_derivative(27, Cm1_22_Cf);
        let Cm1_22_Cr = self.b * self.b;
        put_derivative(28, Cm1_22_Cr);
        let Cm1_22_CT = Kc_23_CT * Kc_23_CT;
        put_derivative(29, Cm1_22_CT);
        let M_12 = -t18;
        put_entry(1, M_12);
        let M_13 = -M_23_h;
        put_entry(2, M_13);
        let Cm1_13 = -Kc_33;
        put_entry(8, Cm1_13);
        let Kc_13 = -self.CT;
        put_entry(13, Kc_13);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl CarTrailer<f64> {
    /// The parameter set `caravan`.
    ///
    /// Source: A family car with a caravan, by estimate
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `m` | 1500 | `kg` |
    /// | `I` | 2500 | `kg*m^2` |
    /// | `a` | 1.2 | `m` |
    /// | `b` | 1.5 | `m` |
    /// | `h` | 2.4 | `m` |
    /// | `mT` | 1200 | `kg` |
    /// | `IT` | 2200 | `kg*m^2` |
    /// | `e` | 3.5 | `m` |
    /// | `l` | 3.7 | `m` |
    /// | `Cf` | 80000 | `N/rad` |
    /// | `Cr` | 100000 | `N/rad` |
    /// | `CT` | 70000 | `N/rad` |
    /// | `d` | 0 | `N*m*s/rad` |
    /// | `t` | 0.75 | `m` |
    /// | `r` | 0.3 | `m` |
    /// | `g` | 9.81 | `N/kg` |
    pub const CARAVAN: Self = Self {
        m: 1500.0, I: 2500.0, a: 1.2, b: 1.5, h: 2.4, mT: 1200.0, IT: 2200.0, e: 3.5, l: 3.7,
        Cf: 80000.0, Cr: 100000.0, CT: 70000.0, d: 0.0, t: 0.75, r: 0.3, g: 9.81,
    };

    /// The parameter set `loaded_behind`.
    ///
    /// Source: The same with its load behind the axle of the caravan
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `m` | 1500 | `kg` |
    /// | `I` | 2500 | `kg*m^2` |
    /// | `a` | 1.2 | `m` |
    /// | `b` | 1.5 | `m` |
    /// | `h` | 2.4 | `m` |
    /// | `mT` | 1200 | `kg` |
    /// | `IT` | 3200 | `kg*m^2` |
    /// | `e` | 3.8 | `m` |
    /// | `l` | 3.7 | `m` |
    /// | `Cf` | 80000 | `N/rad` |
    /// | `Cr` | 100000 | `N/rad` |
    /// | `CT` | 70000 | `N/rad` |
    /// | `d` | 0 | `N*m*s/rad` |
    /// | `t` | 0.75 | `m` |
    /// | `r` | 0.3 | `m` |
    /// | `g` | 9.81 | `N/kg` |
    pub const LOADED_BEHIND: Self = Self {
        m: 1500.0, I: 2500.0, a: 1.2, b: 1.5, h: 2.4, mT: 1200.0, IT: 3200.0, e: 3.8, l: 3.7,
        Cf: 80000.0, Cr: 100000.0, CT: 70000.0, d: 0.0, t: 0.75, r: 0.3, g: 9.81,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> CarTrailer<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 16]) -> Self {
        Self {
            m: values[0], I: values[1], a: values[2], b: values[3], h: values[4], mT: values[5],
            IT: values[6], e: values[7], l: values[8], Cf: values[9], Cr: values[10],
            CT: values[11], d: values[12], t: values[13], r: values[14], g: values[15],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 16] {
        [
            self.m, self.I, self.a, self.b, self.h, self.mT, self.IT, self.e, self.l, self.Cf,
            self.Cr, self.CT, self.d, self.t, self.r, self.g,
        ]
    }
}

impl<T: Scalar> CarTrailer<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> CarTrailer<U> {
        let values = self.to_array();
        CarTrailer::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl CarTrailer<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> CarTrailer<f32> {
        CarTrailer::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<CarTrailer<f32>> for CarTrailer<f64> {
    fn from(parameters: CarTrailer<f32>) -> Self {
        CarTrailer::cast(&parameters)
    }
}

impl<T: Number> CarTrailerMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 45]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            cm1: carvallo::rows(&entries, 9),
            c0: carvallo::rows(&entries, 18),
            c1: carvallo::rows(&entries, 27),
            kc: carvallo::rows(&entries, 36),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 16] {
        [
            self.m[0][0], self.m[0][1], self.m[0][2], self.m[1][1], self.m[1][2], self.m[2][2],
            self.cm1[0][0], self.cm1[0][1], self.cm1[0][2], self.cm1[1][1], self.cm1[1][2],
            self.cm1[2][2], self.c0[2][2], self.kc[0][2], self.kc[1][2], self.kc[2][2],
        ]
    }

    /// Sets the entry at a position among those that differ, wherever it stands.
    #[inline(always)]
    fn set_entry(&mut self, position: usize, entry: T) {
        match position {
            0 => {
                self.m[0][0] = entry;
                self.c1[0][1] = entry;
            }
            1 => {
                self.m[0][1] = entry;
                self.m[1][0] = entry;
                self.c1[1][1] = entry;
            }
            2 => {
                self.m[0][2] = entry;
                self.m[2][0] = entry;
                self.c1[2][1] = entry;
            }
            3 => {
                self.m[1][1] = entry;
            }
            4 => {
                self.m[1][2] = entry;
                self.m[2][1] = entry;
            }
            5 => {
                self.m[2][2] = entry;
            }
            6 => {
                self.cm1[0][0] = entry;
            }
            7 => {
                self.cm1[0][1] = entry;
                self.cm1[1][0] = entry;
            }
            8 => {
                self.cm1[0][2] = entry;
                self.cm1[2][0] = entry;
            }
            9 => {
                self.cm1[1][1] = entry;
            }
            10 => {
                self.cm1[1][2] = entry;
                self.cm1[2][1] = entry;
            }
            11 => {
                self.cm1[2][2] = entry;
            }
            12 => {
                self.c0[2][2] = entry;
            }
            13 => {
                self.kc[0][2] = entry;
            }
            14 => {
                self.kc[1][2] = entry;
            }
            15 => {
                self.kc[2][2] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 3]; 3]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 3]; 3];
        [self.m.0, self.cm1.0, self.c0.0, self.c1.0, self.kc.0, zeros, zeros, zeros]
    }
}

impl<T: Scalar> From<CarTrailerMatrices<T>> for Coefficients<T, 3> {
    fn from(matrices: CarTrailerMatrices<T>) -> Self {
        Coefficients {
            states: [States::Rate, States::Rate, States::Both],
            ..Coefficients::from_rows(matrices.rows())
        }
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<3> for CarTrailer<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 16];

    type Over<U: Number> = CarTrailer<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "CarTrailer",
        docs: "A car with a trailer, which snakes above a critical speed.\n\nCar and trailer are one rigid body each, joined by a ball at which only yaw takes part, on tyres whose side forces are\nlinear in slip. What two front wheels do is in one, and so it is for the trailer; its load on the ball is that of its\ncentre of mass. Axes: origin on the ground below the centre of mass of the car, x forward, y to the right, z down.",
        source: "Mechanism of the single-track car with a trailer, as in Hac, Fulk & Chen (2008), SAE 2008-01-1228",
        parameters: &[
            ParameterInfo::new("m", "kg", Domain::POSITIVE).docs("Mass of the car."),
            ParameterInfo::new("I", "kg*m^2", Domain::POSITIVE)
                .docs("Moment of inertia of the car about its centre of mass, in yaw."),
            ParameterInfo::new("a", "m", Domain::POSITIVE)
                .docs("From the centre of mass of the car forward to the front axle."),
            ParameterInfo::new("b", "m", Domain::POSITIVE)
                .docs("From the centre of mass of the car backward to the rear axle."),
            ParameterInfo::new("h", "m", Domain::POSITIVE)
                .docs("From the centre of mass of the car backward to the ball."),
            ParameterInfo::new("mT", "kg", Domain::POSITIVE)
                .docs("Mass of the trailer."),
            ParameterInfo::new("IT", "kg*m^2", Domain::POSITIVE)
                .docs("Moment of inertia of the trailer about its centre of mass, in yaw."),
            ParameterInfo::new("e", "m", Domain::FINITE)
                .docs("From the ball backward to the centre of mass of the trailer."),
            ParameterInfo::new("l", "m", Domain::POSITIVE)
                .docs("From the ball backward to the axle of the trailer."),
            ParameterInfo::new("Cf", "N/rad", Domain::POSITIVE)
                .docs("Cornering stiffness of the front axle of the car."),
            ParameterInfo::new("Cr", "N/rad", Domain::POSITIVE)
                .docs("Cornering stiffness of the rear axle of the car, of both wheels."),
            ParameterInfo::new("CT", "N/rad", Domain::POSITIVE)
                .docs("Cornering stiffness of the axle of the trailer."),
            ParameterInfo::new("d", "N*m*s/rad", Domain::NONNEGATIVE)
                .docs("Damping of yaw at the ball."),
            ParameterInfo::new("t", "m", Domain::POSITIVE)
                .docs("Half of the track of the rear axle."),
            ParameterInfo::new("r", "m", Domain::POSITIVE).docs("Radius of the wheels."),
            ParameterInfo::new("g", "N/kg", Domain::NONNEGATIVE)
                .docs("Gravitational field strength."),
        ],
        coordinates: &[
            CoordinateInfo::new("y", "m")
                .label("lateral")
                .docs(
                    "Lateral motion of the car, positive to the right: its rate is the velocity along the axes of the car.",
                )
                .states(States::Rate),
            CoordinateInfo::new("psi", "rad")
                .label("yaw")
                .docs("Yaw of the car, positive to the right.")
                .states(States::Rate),
            CoordinateInfo::new("q", "rad")
                .label("hitch")
                .docs("Angle of the trailer to the car, positive to the right."),
        ],
        forces: &[],
        matrices: &[
            MatrixName::M, MatrixName::Cm1, MatrixName::C0, MatrixName::C1, MatrixName::Kc,
        ],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0), (MatrixName::C1, 0, 1)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0), (MatrixName::C1, 1, 1)]),
            EntryInfo::at(&[(MatrixName::M, 0, 2), (MatrixName::M, 2, 0), (MatrixName::C1, 2, 1)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]),
            EntryInfo::at(&[(MatrixName::M, 1, 2), (MatrixName::M, 2, 1)]),
            EntryInfo::at(&[(MatrixName::M, 2, 2)]),
            EntryInfo::at(&[(MatrixName::Cm1, 0, 0)]),
            EntryInfo::at(&[(MatrixName::Cm1, 0, 1), (MatrixName::Cm1, 1, 0)]),
            EntryInfo::at(&[(MatrixName::Cm1, 0, 2), (MatrixName::Cm1, 2, 0)]),
            EntryInfo::at(&[(MatrixName::Cm1, 1, 1)]),
            EntryInfo::at(&[(MatrixName::Cm1, 1, 2), (MatrixName::Cm1, 2, 1)]),
            EntryInfo::at(&[(MatrixName::Cm1, 2, 2)]), EntryInfo::at(&[(MatrixName::C0, 2, 2)]),
            EntryInfo::at(&[(MatrixName::Kc, 0, 2)]), EntryInfo::at(&[(MatrixName::Kc, 1, 2)]),
            EntryInfo::at(&[(MatrixName::Kc, 2, 2)]),
        ],
        sets: &[
            SetInfo {
                name: "caravan",
                docs: "",
                source: "A family car with a caravan, by estimate",
                values: &CarTrailer::to_array(&CarTrailer::<f64>::CARAVAN),
            },
            SetInfo {
                name: "loaded_behind",
                docs: "",
                source: "The same with its load behind the axle of the caravan",
                values: &CarTrailer::to_array(&CarTrailer::<f64>::LOADED_BEHIND),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("Jyy_q", "kg*m^2", "mT*e^2 + IT"),
            FormulaInfo::definition("Sx_q", "kg*m", "-mT*e"),
            FormulaInfo::definition("Jzz_all", "kg*m^2", "I + Jyy_q - 2*h*(Sx_q - (1/2)*h*mT)"),
            FormulaInfo::definition("Sx_all", "kg*m", "Sx_q - h*mT"),
            FormulaInfo::definition("m_all", "kg", "m + mT"),
            FormulaInfo::definition("M_psi_q", "kg*m^2", "Jyy_q - h*Sx_q"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg", "m_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)], "kg*m", "Sx_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 2), (MatrixName::M, 2, 0)], "kg*m", "Sx_q"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "Jzz_all"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 2), (MatrixName::M, 2, 1)], "kg*m^2", "M_psi_q"),
            FormulaInfo::entry(&[(MatrixName::M, 2, 2)], "kg*m^2", "Jyy_q"),
            FormulaInfo::entry(&[(MatrixName::Cm1, 0, 0)], "kg*m/s^2", "Cf + Cr + CT"),
            FormulaInfo::entry(
                &[(MatrixName::Cm1, 0, 1), (MatrixName::Cm1, 1, 0)],
                "kg*m^2/s^2",
                "a*Cf - b*Cr - CT*(h + l)",
            ),
            FormulaInfo::entry(&[(MatrixName::Cm1, 0, 2), (MatrixName::Cm1, 2, 0)], "kg*m^2/s^2", "-l*CT"),
            FormulaInfo::entry(&[(MatrixName::Cm1, 1, 1)], "kg*m^3/s^2", "CT*(h + l)^2 + a^2*Cf + b^2*Cr"),
            FormulaInfo::entry(&[(MatrixName::Cm1, 1, 2), (MatrixName::Cm1, 2, 1)], "kg*m^3/s^2", "l*CT*(h + l)"),
            FormulaInfo::entry(&[(MatrixName::Cm1, 2, 2)], "kg*m^3/s^2", "l^2*CT"),
            FormulaInfo::entry(&[(MatrixName::C0, 2, 2)], "kg*m^2/s", "d"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 1)], "kg", "m_all"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 1)], "kg*m", "Sx_all"),
            FormulaInfo::entry(&[(MatrixName::C1, 2, 1)], "kg*m", "Sx_q"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 2)], "kg*m/s^2", "-CT"),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 2)], "kg*m^2/s^2", "CT*(h + l)"),
            FormulaInfo::entry(&[(MatrixName::Kc, 2, 2)], "kg*m^2/s^2", "l*CT"),
        ],
        attributes: &[
            FormulaInfo::attribute("B_mass", "the mass of the car B", "kg", "m"),
            FormulaInfo::attribute("B_Izz", "the inertia zz of the car B", "kg*m^2", "I"),
            FormulaInfo::attribute("T_mass", "the mass of the trailer T", "kg", "mT"),
            FormulaInfo::attribute("T_x", "x of the centre of mass of the trailer T", "m", "-h - e"),
            FormulaInfo::attribute("T_Izz", "the inertia zz of the trailer T", "kg*m^2", "IT"),
            FormulaInfo::attribute("F_x", "x of the centre of the front axle F", "m", "a"),
            FormulaInfo::attribute("F_cornering", "the cornering stiffness of the front axle F", "kg*m/s^2", "Cf"),
            FormulaInfo::attribute("L_x", "x of the centre of the rear left L", "m", "-b"),
            FormulaInfo::attribute("L_cornering", "the cornering stiffness of the rear left L", "kg*m/s^2", "Cr/2"),
            FormulaInfo::attribute("R_x", "x of the centre of the rear right R", "m", "-b"),
            FormulaInfo::attribute("R_cornering", "the cornering stiffness of the rear right R", "kg*m/s^2", "Cr/2"),
            FormulaInfo::attribute("U_x", "x of the centre of the axle of the trailer U", "m", "-h - l"),
            FormulaInfo::attribute(
                "U_cornering",
                "the cornering stiffness of the axle of the trailer U",
                "kg*m/s^2",
                "CT",
            ),
            FormulaInfo::attribute("pitch_through_x", "x of the point of the joint pitch", "m", "-h"),
            FormulaInfo::attribute("q_through_x", "x of the point of the joint q", "m", "-h"),
            FormulaInfo::attribute("q_damper", "the damper of the joint q", "kg*m^2/s", "d"),
            FormulaInfo::definition("Jzz_q", "kg*m^2", "T_mass*(T_x - q_through_x)^2 + T_Izz"),
            FormulaInfo::definition("Sx_q", "kg*m", "T_mass*(T_x - q_through_x)"),
            FormulaInfo::definition(
                "Jzz_pitch",
                "kg*m^2",
                "Jzz_q + 2*(q_through_x - pitch_through_x)*((1/2)*T_mass*(q_through_x - pitch_through_x) + Sx_q)",
            ),
            FormulaInfo::definition("Sx_pitch", "kg*m", "T_mass*(q_through_x - pitch_through_x) + Sx_q"),
            FormulaInfo::definition(
                "Jzz_all",
                "kg*m^2",
                "B_Izz + 2*pitch_through_x*((1/2)*T_mass*pitch_through_x + Sx_pitch) + Jzz_pitch",
            ),
            FormulaInfo::definition("Sx_all", "kg*m", "T_mass*pitch_through_x + Sx_pitch"),
            FormulaInfo::definition("m_all", "kg", "B_mass + T_mass"),
            FormulaInfo::definition("M_psi_q", "kg*m^2", "q_through_x*Sx_q + Jzz_q"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg", "m_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)], "kg*m", "Sx_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 2), (MatrixName::M, 2, 0)], "kg*m", "Sx_q"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "Jzz_all"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 2), (MatrixName::M, 2, 1)], "kg*m^2", "M_psi_q"),
            FormulaInfo::entry(&[(MatrixName::M, 2, 2)], "kg*m^2", "Jzz_q"),
            FormulaInfo::entry(
                &[(MatrixName::Cm1, 0, 0)],
                "kg*m/s^2",
                "F_cornering + L_cornering + R_cornering + U_cornering",
            ),
            FormulaInfo::entry(
                &[(MatrixName::Cm1, 0, 1), (MatrixName::Cm1, 1, 0)],
                "kg*m^2/s^2",
                "F_x*F_cornering + L_x*L_cornering + R_x*R_cornering + U_x*U_cornering",
            ),
            FormulaInfo::entry(
                &[(MatrixName::Cm1, 0, 2), (MatrixName::Cm1, 2, 0)],
                "kg*m^2/s^2",
                "U_cornering*(U_x - q_through_x)",
            ),
            FormulaInfo::entry(
                &[(MatrixName::Cm1, 1, 1)],
                "kg*m^3/s^2",
                "F_x^2*F_cornering + L_x^2*L_cornering + R_x^2*R_cornering + U_x^2*U_cornering",
            ),
            FormulaInfo::entry(
                &[(MatrixName::Cm1, 1, 2), (MatrixName::Cm1, 2, 1)],
                "kg*m^3/s^2",
                "U_x*U_cornering*(U_x - q_through_x)",
            ),
            FormulaInfo::entry(&[(MatrixName::Cm1, 2, 2)], "kg*m^3/s^2", "U_cornering*(U_x - q_through_x)^2"),
            FormulaInfo::entry(&[(MatrixName::C0, 2, 2)], "kg*m^2/s", "q_damper"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 1)], "kg", "m_all"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 1)], "kg*m", "Sx_all"),
            FormulaInfo::entry(&[(MatrixName::C1, 2, 1)], "kg*m", "Sx_q"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 2)], "kg*m/s^2", "-U_cornering"),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 2)], "kg*m^2/s^2", "-U_x*U_cornering"),
            FormulaInfo::entry(&[(MatrixName::Kc, 2, 2)], "kg*m^2/s^2", "U_cornering*(q_through_x - U_x)"),
        ],
        motion: None,
        gravity: Some(15),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("CarTrailer", 16, values)?;
        Ok(<Self as Evaluator<T, 3>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("CarTrailer", 16, values)?;
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
            states: [States::Rate, States::Rate, States::Both],
            ..Coefficients::from_rows(CarTrailerMatrices::rows(&self.matrices()))
        }
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 3>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl CarTrailer<f64> {
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
impl<T: Scalar> core::fmt::Display for CarTrailer<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<3>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 3> for CarTrailer<T> {
    type Entries = [T; 16];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            m: parameter(0), I: parameter(1), a: parameter(2), b: parameter(3), h: parameter(4),
            mT: parameter(5), IT: parameter(6), e: parameter(7), l: parameter(8), Cf: parameter(9),
            Cr: parameter(10), CT: parameter(11), d: parameter(12), t: parameter(13),
            r: parameter(14), g: parameter(15),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        CarTrailerMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 3]; 3]; 8] {
        CarTrailerMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> CarTrailerDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<CarTrailerMatrices<T>> {
        if parameter >= 16 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = CarTrailerMatrices {
            m: Rows([[zero; 3]; 3]), cm1: Rows([[zero; 3]; 3]), c0: Rows([[zero; 3]; 3]),
            c1: Rows([[zero; 3]; 3]), kc: Rows([[zero; 3]; 3]),
        };
        for position in 0..78 {
            let partial = <CarTrailerDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::Cm1 => &mut matrices.cm1,
                MatrixName::C0 => &mut matrices.c0,
                MatrixName::C1 => &mut matrices.c1,
                MatrixName::Kc => &mut matrices.kc,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<3> for CarTrailer<T> {
    type Derivatives = [Coefficients<T, 3>; 16];

    type WithDerivativesOver<U: Number> = CarTrailer<U>;

    const PARTIALS: &'static [Partial] = <CarTrailerDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 3>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 3]; 3]; 8]); 16];
        for position in 0..78 {
            Partial::write(&<CarTrailerDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (
            Coefficients {
                states: [States::Rate, States::Rate, States::Both],
                ..Coefficients::from_rows(CarTrailerMatrices::rows(&matrices))
            },
            all,
        )
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 3> for CarTrailer<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl CarTrailerDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 78] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 8), Partial::new(MatrixName::C1, 0, 1, 0, 8),
        Partial::new(MatrixName::M, 1, 1, 1, 8), Partial::new(MatrixName::Cm1, 0, 1, 2, 5),
        Partial::new(MatrixName::Cm1, 1, 0, 2, 5), Partial::new(MatrixName::Cm1, 1, 1, 2, 16),
        Partial::new(MatrixName::Cm1, 0, 1, 3, 6).negative(),
        Partial::new(MatrixName::Cm1, 1, 0, 3, 6).negative(),
        Partial::new(MatrixName::Cm1, 1, 1, 3, 18),
        Partial::new(MatrixName::M, 0, 1, 4, 2).negative(),
        Partial::new(MatrixName::M, 1, 0, 4, 2).negative(),
        Partial::new(MatrixName::M, 1, 1, 4, 21), Partial::new(MatrixName::M, 1, 2, 4, 11),
        Partial::new(MatrixName::M, 2, 1, 4, 11),
        Partial::new(MatrixName::Cm1, 0, 1, 4, 7).negative(),
        Partial::new(MatrixName::Cm1, 1, 0, 4, 7).negative(),
        Partial::new(MatrixName::Cm1, 1, 1, 4, 22), Partial::new(MatrixName::Cm1, 1, 2, 4, 17),
        Partial::new(MatrixName::Cm1, 2, 1, 4, 17),
        Partial::new(MatrixName::C1, 1, 1, 4, 2).negative(),
        Partial::new(MatrixName::Kc, 1, 2, 4, 7), Partial::new(MatrixName::M, 0, 0, 5, 8),
        Partial::new(MatrixName::M, 0, 1, 5, 10).negative(),
        Partial::new(MatrixName::M, 0, 2, 5, 3).negative(),
        Partial::new(MatrixName::M, 1, 0, 5, 10).negative(),
        Partial::new(MatrixName::M, 1, 1, 5, 15), Partial::new(MatrixName::M, 1, 2, 5, 13),
        Partial::new(MatrixName::M, 2, 0, 5, 3).negative(),
        Partial::new(MatrixName::M, 2, 1, 5, 13), Partial::new(MatrixName::M, 2, 2, 5, 23),
        Partial::new(MatrixName::C1, 0, 1, 5, 8),
        Partial::new(MatrixName::C1, 1, 1, 5, 10).negative(),
        Partial::new(MatrixName::C1, 2, 1, 5, 3).negative(),
        Partial::new(MatrixName::M, 1, 1, 6, 8), Partial::new(MatrixName::M, 1, 2, 6, 8),
        Partial::new(MatrixName::M, 2, 1, 6, 8), Partial::new(MatrixName::M, 2, 2, 6, 8),
        Partial::new(MatrixName::M, 0, 1, 7, 2).negative(),
        Partial::new(MatrixName::M, 0, 2, 7, 2).negative(),
        Partial::new(MatrixName::M, 1, 0, 7, 2).negative(),
        Partial::new(MatrixName::M, 1, 1, 7, 21), Partial::new(MatrixName::M, 1, 2, 7, 12),
        Partial::new(MatrixName::M, 2, 0, 7, 2).negative(),
        Partial::new(MatrixName::M, 2, 1, 7, 12), Partial::new(MatrixName::M, 2, 2, 7, 24),
        Partial::new(MatrixName::C1, 1, 1, 7, 2).negative(),
        Partial::new(MatrixName::C1, 2, 1, 7, 2).negative(),
        Partial::new(MatrixName::Cm1, 0, 1, 8, 7).negative(),
        Partial::new(MatrixName::Cm1, 0, 2, 8, 7).negative(),
        Partial::new(MatrixName::Cm1, 1, 0, 8, 7).negative(),
        Partial::new(MatrixName::Cm1, 1, 1, 8, 22),
        Partial::new(MatrixName::Cm1, 1, 2, 8, 25),
        Partial::new(MatrixName::Cm1, 2, 0, 8, 7).negative(),
        Partial::new(MatrixName::Cm1, 2, 1, 8, 25), Partial::new(MatrixName::Cm1, 2, 2, 8, 26),
        Partial::new(MatrixName::Kc, 1, 2, 8, 7), Partial::new(MatrixName::Kc, 2, 2, 8, 7),
        Partial::new(MatrixName::Cm1, 0, 0, 9, 8), Partial::new(MatrixName::Cm1, 0, 1, 9, 0),
        Partial::new(MatrixName::Cm1, 1, 0, 9, 0), Partial::new(MatrixName::Cm1, 1, 1, 9, 27),
        Partial::new(MatrixName::Cm1, 0, 0, 10, 8),
        Partial::new(MatrixName::Cm1, 0, 1, 10, 1).negative(),
        Partial::new(MatrixName::Cm1, 1, 0, 10, 1).negative(),
        Partial::new(MatrixName::Cm1, 1, 1, 10, 28),
        Partial::new(MatrixName::Cm1, 0, 0, 11, 8),
        Partial::new(MatrixName::Cm1, 0, 1, 11, 14).negative(),
        Partial::new(MatrixName::Cm1, 0, 2, 11, 4).negative(),
        Partial::new(MatrixName::Cm1, 1, 0, 11, 14).negative(),
        Partial::new(MatrixName::Cm1, 1, 1, 11, 29),
        Partial::new(MatrixName::Cm1, 1, 2, 11, 19),
        Partial::new(MatrixName::Cm1, 2, 0, 11, 4).negative(),
        Partial::new(MatrixName::Cm1, 2, 1, 11, 19), Partial::new(MatrixName::Cm1, 2, 2, 11, 20),
        Partial::new(MatrixName::Kc, 0, 2, 11, 9), Partial::new(MatrixName::Kc, 1, 2, 11, 14),
        Partial::new(MatrixName::Kc, 2, 2, 11, 4), Partial::new(MatrixName::C0, 2, 2, 12, 8),
    ];
}
