// @generated from generated/models/motorcycle.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 30344da47625ffae

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rate, RequirementInfo, Rows, Scalar,
    SetInfo, States, WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A motorcycle on tyres that slip, whose side forces follow slip and camber over a length: two bodies, of which the front
/// one steers, with wheels in their masses.
///
/// Axes: origin on the ground below the centre of mass of the rear part, x forward, y to the right, z down. The steering takes
/// the load of the front wheel that is given with the parameters, `Zf`, and not the one that follows from the masses.
///
/// Source: Sharp (1971), The stability and control of motorcycles, J. Mech. Eng. Sci. 13, 316-329
///
/// Derived from a mechanism: body `rear` (rear part), body `front` (front part), wheel `R` (rear wheel), wheel `F` (front wheel).
///
/// The fields are the parameters. The coordinates are `y` (lateral) in `m`, of which only the rate is a state; `psi` (yaw) in `rad`, of which only the rate is a state; `phi` (lean) in `rad`; `delta` (steer) in `rad`; `er` (rear tyre) in `m`, of first order: only its position is a state; `ef` (front tyre) in `m`, of first order: only its position is a state.
///
/// Beside what is said of each field, `validate` requires of them:
///
/// - `b + l` in `m`: `> 0`.
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
/// s = sin(eps) [1]
/// c = cos(eps) [1]
/// l = (a - t)/c [m]
/// k = (a + e)*c - f*s [m]
/// j = (a + e)*s + f*c [m]
/// load = (b*(Mf + Mr) + k*Mf)/(b + l) [kg]
/// rest = load - Zf/g [kg]
/// Jxx_delta = Mf*j^2 + Ifx*c^2 + Ifz*s^2 [kg*m^2]
/// Jxz_delta = Mf*j*(k - a/c) + s*c*(Ifz - Ifx) [kg*m^2]
/// Jzz_delta = Mf*(k - a/c)^2 + Ifx*s^2 + Ifz*c^2 [kg*m^2]
/// Sx_delta = Mf*(k - a/c) [kg*m]
/// Sz_delta = -Mf*j [kg*m]
/// py_delta = c*Sx_delta - s*Sz_delta [kg*m]
/// hx_delta = s*Jxx_delta + c*Jxz_delta [kg*m^2]
/// hz_delta = s*Jxz_delta + c*Jzz_delta [kg*m^2]
/// Jxx_all = Mr*h^2 + Irx + Jxx_delta [kg*m^2]
/// Jxz_all = Jxz_delta - Crxz - a*Sz_delta/c [kg*m^2]
/// Jzz_all = Mf*k^2 + Irz + Ifx*s^2 + Ifz*c^2 [kg*m^2]
/// Sx_all = Mf*k [kg*m]
/// Sz_all = Sz_delta - Mr*h [kg*m]
/// m_all = Mf + Mr [kg]
/// load_spin_F = -(b*m_all + Sx_all)/(b + l) [kg]
/// h_spin_R = iry/Rr [kg*m]
/// h_spin_F = ify/Rf [kg*m]
/// h_wheels_all = h_spin_R + h_spin_F [kg*m]
/// M_psi_delta = a*py_delta/c + hz_delta [kg*m^2]
/// M_delta_delta = s*hx_delta + c*hz_delta [kg*m^2]
/// K_phi_delta = -(py_delta + load_spin_F*(c*l - a)) [kg*m]
/// K_delta_delta = -s*(py_delta + load_spin_F*(c*l - a)) [kg*m]
/// M_11 = m_all [kg]
/// M_12 = M_21 = Sx_all [kg*m]
/// M_13 = M_31 = -Sz_all [kg*m]
/// M_14 = M_41 = py_delta [kg*m]
/// M_22 = Jzz_all [kg*m^2]
/// M_23 = M_32 = Jxz_all [kg*m^2]
/// M_24 = M_42 = M_psi_delta [kg*m^2]
/// M_33 = Jxx_all [kg*m^2]
/// M_34 = M_43 = hx_delta [kg*m^2]
/// M_44 = M_delta_delta [kg*m^2]
/// C0_44 = K [kg*m^2/s]
/// C0_51 = -Cr1/sigma [kg/s^2]
/// C0_52 = b*Cr1/sigma [kg*m/s^2]
/// C0_55 = Cr1/sigma [kg/s^2]
/// C0_61 = -Cf1/sigma [kg/s^2]
/// C0_62 = -Cf1*l/sigma [kg*m/s^2]
/// C0_64 = Cf1*(a - c*l)/sigma [kg*m/s^2]
/// C0_66 = Cf1/sigma [kg/s^2]
/// C1_12 = m_all [kg]
/// C1_22 = Sx_all [kg*m]
/// C1_23 = -h_wheels_all [kg*m]
/// C1_24 = -s*h_spin_F [kg*m]
/// C1_32 = h_wheels_all - Sz_all [kg*m]
/// C1_34 = c*h_spin_F [kg*m]
/// C1_42 = s*h_spin_F + py_delta [kg*m]
/// C1_43 = -c*h_spin_F [kg*m]
/// Kc_15 = Cr1/sigma [kg/s^2]
/// Kc_16 = Cf1/sigma [kg/s^2]
/// Kc_25 = -b*Cr1/sigma [kg*m/s^2]
/// Kc_26 = Cf1*l/sigma [kg*m/s^2]
/// Kc_46 = Cf1*(c*l - a)/sigma [kg*m/s^2]
/// K0_33 = Sz_all [kg*m]
/// K0_34 = K0_43 = t*rest + K_phi_delta [kg*m]
/// K0_44 = t*s*rest + K_delta_delta [kg*m]
/// K1_53 = Cr2/sigma [kg/s^2]
/// K1_55 = Cr1/sigma^2 [kg/m/s^2]
/// K1_63 = Cf2/sigma [kg/s^2]
/// K1_64 = (Cf1*c + Cf2*s)/sigma [kg/s^2]
/// K1_66 = Cf1/sigma^2 [kg/m/s^2]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Motorcycle<T = f64> {
    /// Mass of the front part, with its wheel.
    ///
    /// `Mf` in `kg`: `> 0`.
    pub Mf: T,
    /// Mass of the rear part, with its wheel and the rider.
    ///
    /// `Mr` in `kg`: `> 0`.
    pub Mr: T,
    /// Moment of inertia of the rear part about a longitudinal axis, at its centre of mass.
    ///
    /// `Irx` in `kg*m^2`: `>= 0`.
    pub Irx: T,
    /// Moment of inertia of the rear part about a vertical axis.
    ///
    /// `Irz` in `kg*m^2`: `>= 0`.
    pub Irz: T,
    /// Product of inertia of the rear part: what the product of lean and yaw rates is multiplied by in the kinetic
    /// energy, with the opposite sign.
    ///
    /// `Crxz` in `kg*m^2`: any finite value.
    pub Crxz: T,
    /// Moment of inertia of the front part about an axis perpendicular to the steer axis, forward.
    ///
    /// `Ifx` in `kg*m^2`: `>= 0`.
    pub Ifx: T,
    /// Moment of inertia of the front part about an axis along the steer axis.
    ///
    /// `Ifz` in `kg*m^2`: `>= 0`.
    pub Ifz: T,
    /// Moment of inertia of the front wheel about its axle.
    ///
    /// `ify` in `kg*m^2`: `>= 0`.
    pub ify: T,
    /// Moment of inertia of the rear wheel about its axle, with that of the engine as it is geared.
    ///
    /// `iry` in `kg*m^2`: `>= 0`.
    pub iry: T,
    /// Distance of the origin from the steer axis.
    ///
    /// `a` in `m`: `> 0`.
    pub a: T,
    /// Distance of the rear contact point behind the origin.
    ///
    /// `b` in `m`: `> 0`.
    pub b: T,
    /// Distance of the centre of mass of the front part ahead of the steer axis.
    ///
    /// `e` in `m`: any finite value.
    pub e: T,
    /// Height of the centre of mass of the front part, along the steer axis, over the foot of the perpendicular from
    /// the origin.
    ///
    /// `f` in `m`: any finite value.
    pub f: T,
    /// Height of the centre of mass of the rear part.
    ///
    /// `h` in `m`: `> 0`.
    pub h: T,
    /// Radius of the front wheel.
    ///
    /// `Rf` in `m`: `> 0`.
    pub Rf: T,
    /// Radius of the rear wheel.
    ///
    /// `Rr` in `m`: `> 0`.
    pub Rr: T,
    /// Distance of the front contact point behind the steer axis.
    ///
    /// `t` in `m`: any finite value.
    pub t: T,
    /// Tilt of the steer axis from the vertical.
    ///
    /// `eps`, ε, in `rad`: `> -1.5707963267948966 and < 1.5707963267948966`.
    pub eps: T,
    /// Cornering stiffness of the front tyre.
    ///
    /// `Cf1` in `N`: `> 0`.
    pub Cf1: T,
    /// Camber stiffness of the front tyre.
    ///
    /// `Cf2` in `N`: `>= 0`.
    pub Cf2: T,
    /// Cornering stiffness of the rear tyre.
    ///
    /// `Cr1` in `N`: `> 0`.
    pub Cr1: T,
    /// Camber stiffness of the rear tyre.
    ///
    /// `Cr2` in `N`: `>= 0`.
    pub Cr2: T,
    /// Damping of the steering.
    ///
    /// `K` in `N*m*s`: `>= 0`.
    pub K: T,
    /// Relaxation length of both tyres.
    ///
    /// `sigma`, σ, in `m`: `> 0`.
    pub sigma: T,
    /// Load of the front wheel.
    ///
    /// `Zf` in `N`: `>= 0`.
    pub Zf: T,
    /// Gravitational field strength.
    ///
    /// `g` in `N/kg`: `> 0`.
    pub g: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`Motorcycle`], each 6 x 6 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorcycleMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 6>,
    /// Damping C0, a coefficient of q'.
    pub c0: Rows<T, 6>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 6>,
    /// Stiffness Kc, a coefficient of q.
    pub kc: Rows<T, 6>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 6>,
    /// Stiffness K1, a coefficient of v q.
    pub k1: Rows<T, 6>,
}

impl<T: Number> Motorcycle<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 27 additions, 43 multiplications, 6 divisions, 10 negations and 2 trigonometric functions: 88 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> MotorcycleMatrices<T> {
        let M_11 = self.Mf + self.Mr;
        let (s, cos_eps) = self.eps.sin_cos();
        let t10 = self.a + self.e;
        let t12 = cos_eps * t10 - self.f * s;
        let M_12 = self.Mf * t12;
        let t15 = self.Mr * self.h;
        let j = self.f * cos_eps + s * t10;
        let t19 = self.Mf * j;
        let M_13 = t15 + t19;
        let t21 = s * s;
        let t22 = cos_eps * cos_eps;
        let t25 = self.a - t10 * (t21 + t22);
        let t26 = self.Mf * t25;
        let zero = self.Mf.like(0.0);
        let t34 = self.Ifz * t22;
        let M_22 = self.Irz + self.Ifx * t21 + (t12 * M_12 + t34);
        let t44 = t21 * self.Ifz;
        let t45 = t34 + t44;
        let M_24 = cos_eps * t45 - M_12 * t25;
        let M_33 = t44 + (self.Ifx * t22 + (self.h * t15 + (self.Irx + j * t19)));
        let M_44 = self.Ifz + t25 * t26;
        let t63 = self.Mf.like(1.0) / self.sigma;
        let C0_55 = self.Cr1 * t63;
        let C0_52 = C0_55 * self.b;
        let C0_66 = t63 * self.Cf1;
        let C0_64 = C0_66 * self.t;
        let Kc_26 = (self.a * C0_66 - C0_64) / cos_eps;
        let h_spin_R = self.iry / self.Rr;
        let h_spin_F = self.ify / self.Rf;
        let h_wheels_all = h_spin_R + h_spin_F;
        let t81 = s * h_spin_F;
        let C1_32 = M_13 + h_wheels_all;
        let C1_34 = cos_eps * h_spin_F;
        let K0_34 = (t26 * self.g - self.t * self.Zf) / self.g;
        let K0_44 = s * K0_34;
        let K1_53 = t63 * self.Cr2;
        let t94 = self.Mf.like(1.0) / (self.sigma * self.sigma);
        let K1_55 = self.Cr1 * t94;
        let K1_63 = t63 * self.Cf2;
        let K1_64 = s * K1_63 + cos_eps * C0_66;
        let K1_66 = self.Cf1 * t94;
        let M_14 = -t26;
        let M_23 = t12 * t19 - (self.Crxz + cos_eps * (s * (self.Ifx - self.Ifz)));
        let M_34 = s * t45 - j * t26;
        let C0_51 = -C0_55;
        let C0_61 = -C0_66;
        let C0_62 = -Kc_26;
        let C1_23 = -h_wheels_all;
        let C1_24 = -t81;
        let C1_42 = t81 - t26;
        let C1_43 = -C1_34;
        let Kc_25 = -C0_52;
        let Kc_46 = -C0_64;
        let K0_33 = -M_13;
        MotorcycleMatrices::from_entries([
            M_11, M_12, M_13, M_14, zero, zero, M_12, M_22, M_23, M_24, zero, zero, M_13, M_23,
            M_33, M_34, zero, zero, M_14, M_24, M_34, M_44, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, self.K, zero, zero, C0_51, C0_52, zero, zero, C0_55, zero, C0_61, C0_62, zero,
            C0_64, zero, C0_66, zero, M_11, zero, zero, zero, zero, zero, M_12, C1_23, C1_24, zero,
            zero, zero, C1_32, zero, C1_34, zero, zero, zero, C1_42, C1_43, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, C0_55, C0_66, zero, zero, zero, zero, Kc_25, Kc_26, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, Kc_46, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, K0_33, K0_34, zero, zero, zero, zero, K0_34, K0_44, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, K1_53, zero, K1_55,
            zero, zero, zero, K1_63, K1_64, zero, K1_66,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`Motorcycle`] that follow from its coordinates q = (`y`, `psi`, `phi`, `delta`, `er`, `ef`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorcycleKinematics<T = f64> {
    /// Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_R: Rate<T, 6>,
    /// Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_F: Rate<T, 6>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate,
    /// a column for each of `Tdelta` (steer torque) in `N*m`.
    pub forces: [[T; 1]; 6],
}

impl<T: Scalar> Motorcycle<T> {
    /// Rates and forces that follow from the coordinates:
    /// 2 divisions and 2 negations: 4 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> MotorcycleKinematics<T> {
        let zero = self.Mf.like(0.0);
        let t6 = -(self.Mf.like(1.0) / self.Rr);
        let t7 = -(self.Mf.like(1.0) / self.Rf);
        MotorcycleKinematics {
            wheel_R: Rate {
                speed: t6, rates: [zero, zero, zero, zero, zero, zero],
                coordinates: [zero, zero, zero, zero, zero, zero], heading: zero,
            },
            wheel_F: Rate {
                speed: t7, rates: [zero, zero, zero, zero, zero, zero],
                coordinates: [zero, zero, zero, zero, zero, zero], heading: zero,
            },
            forces: [[zero], [zero], [zero], [self.Mf.like(1.0)], [zero], [zero]],
        }
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`Motorcycle`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorcycleDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 85],
}

impl<T: Number> Motorcycle<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 46 additions, 106 multiplications, 7 divisions, 12 negations and 2 trigonometric functions: 173 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (MotorcycleMatrices<T>, MotorcycleDerivatives<T>) {
        let zero = self.Mf.like(0.0);
        let mut matrices = MotorcycleMatrices::from_entries([zero; 216]);
        let mut derivatives = MotorcycleDerivatives {
            values: [zero; 85],
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
        matrices: &mut MotorcycleMatrices<T>,
        derivatives: &mut MotorcycleDerivatives<T>,
    ) {
        *matrices = MotorcycleMatrices::from_entries([self.Mf.like(0.0); 216]);
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
        put_entry(10, self.K);
        put_derivative(0, self.Mr);
        put_derivative(1, self.h);
        put_derivative(2, self.Mf.like(1.0));
        put_derivative(3, self.Mf.like(-1.0));
        let (s, s_eps) = self.eps.sin_cos();
        let M_11 = self.Mf + self.Mr;
        put_entry(0, M_11);
        let t32 = self.a + self.e;
        let t33 = self.Mr * self.h;
        let C0_66_Cf1 = self.Mf.like(1.0) / self.sigma;
        put_derivative(4, C0_66_Cf1);
        let C1_32_ify = self.Mf.like(1.0) / self.Rf;
        put_derivative(5, C1_32_ify);
        let C1_32_iry = self.Mf.like(1.0) / self.Rr;
        put_derivative(6, C1_32_iry);
        let M_33_Mr = self.h * self.h;
        put_derivative(7, M_33_Mr);
        let M_33_h = t33 + t33;
        put_derivative(8, M_33_h);
        let C0_64_Cf1 = C0_66_Cf1 * self.t;
        put_derivative(9, C0_64_Cf1);
        let C0_55 = self.Cr1 * C0_66_Cf1;
        put_entry(13, C0_55);
        put_derivative(10, C0_55);
        let C0_52_Cr1 = C0_66_Cf1 * self.b;
        put_derivative(11, C0_52_Cr1);
        let C0_66 = C0_66_Cf1 * self.Cf1;
        put_entry(17, C0_66);
        put_derivative(12, C0_66);
        let h_spin_F = self.ify * C1_32_ify;
        let t44 = self.iry * C1_32_iry;
        let t45 = self.Mf.like(1.0) / self.g;
        let K1_53 = C0_66_Cf1 * self.Cr2;
        put_entry(30, K1_53);
        let t47 = self.sigma * self.sigma;
        let K1_66_Cf1 = self.Mf.like(1.0) / t47;
        put_derivative(13, K1_66_Cf1);
        let t49 = C0_66_Cf1 * K1_53;
        put_derivative(14, t49);
        let C0_52 = self.Cr1 * C0_52_Cr1;
        put_entry(12, C0_52);
        let C1_23_Rr = C1_32_iry * t44;
        put_derivative(15, C1_23_Rr);
        let h_wheels_all = h_spin_F + t44;
        let C0_61_sigma = C0_66_Cf1 * C0_66;
        put_derivative(16, C0_61_sigma);
        let t55 = self.Mf.like(1.0) / (self.sigma * t47);
        let C0_51 = -C0_55;
        put_entry(11, C0_51);
        let C0_51_sigma = C0_66_Cf1 * C0_55;
        put_derivative(17, C0_51_sigma);
        let C0_61 = -C0_66;
        put_entry(14, C0_61);
        let Kc_25_sigma = self.b * C0_51_sigma;
        put_derivative(18, Kc_25_sigma);
        let Kc_25 = -C0_52;
        put_entry(24, Kc_25);
        let C1_23 = -h_wheels_all;
        put_entry(18, C1_23);
        let K1_55 = self.Cr1 * K1_66_Cf1;
        put_entry(31, K1_55);
        let K1_66 = self.Cf1 * K1_66_Cf1;
        put_entry(34, K1_66);
        let C0_64 = C0_66 * self.t;
        put_entry(16, C0_64);
        let Kc_46_sigma = C0_66_Cf1 * C0_64;
        put_derivative(19, Kc_46_sigma);
        let Kc_46 = -C0_64;
        put_entry(26, Kc_46);
        let t67 = self.g * t45;
        let t68 = self.t * t45;
        put_derivative(20, t68);
        let K1_63 = C0_66_Cf1 * self.Cf2;
        put_entry(32, K1_63);
        let t70 = C0_66_Cf1 * K1_63;
        put_derivative(21, t70);
        let C1_23_Rf = C1_32_ify * h_spin_F;
        put_derivative(22, C1_23_Rf);
        let t72 = t55 + t55;
        let t73 = t45 * self.Zf;
        put_derivative(23, t73);
        let t74 = self.Cr1 * t72;
        put_derivative(24, t74);
        let t75 = self.Cf1 * t72;
        put_derivative(25, t75);
        let t76 = s * self.f;
        let t77 = s_eps * t32;
        let j = self.f * s_eps + s * t32;
        put_derivative(26, j);
        let M_22_Ifx = s * s;
        put_derivative(27, M_22_Ifx);
        let M_33_Ifx = s_eps * s_eps;
        put_derivative(28, M_33_Ifx);
        let M_23_Ifz = s * s_eps;
        put_derivative(29, M_23_Ifz);
        let t84 = self.Mf.like(1.0) / s_eps;
        let C1_42_ify = s * C1_32_ify;
        put_derivative(30, C1_42_ify);
        let C1_34 = s_eps * h_spin_F;
        put_entry(21, C1_34);
        put_derivative(31, C1_34);
        let K1_64 = s * K1_63 + s_eps * C0_66;
        put_entry(33, K1_64);
        let C1_34_ify = s_eps * C1_32_ify;
        put_derivative(32, C1_34_ify);
        let C1_43_Rf = s_eps * C1_23_Rf;
        put_derivative(33, C1_43_Rf);
        let t92 = s * t73;
        put_derivative(34, t92);
        let K1_64_Cf1 = s_eps * C0_66_Cf1;
        put_derivative(35, K1_64_Cf1);
        let t94 = s * t68;
        put_derivative(36, t94);
        let M_12_a = self.Mf * s_eps;
        put_derivative(37, M_12_a);
        let M_13_a = self.Mf * s;
        put_derivative(38, M_13_a);
        let K1_64_Cf2 = s * C0_66_Cf1;
        put_derivative(39, K1_64_Cf2);
        let t98 = t76 - t77;
        let K1_64_eps = s_eps * K1_63 - self.Cf1 * K1_64_Cf2;
        put_derivative(40, K1_64_eps);
        let M_12_Mf = t77 - t76;
        put_derivative(41, M_12_Mf);
        let C1_24_Rf = h_spin_F * C1_42_ify;
        put_derivative(42, C1_24_Rf);
        let C1_43 = -C1_34;
        put_entry(23, C1_43);
        let C1_43_eps = self.ify * C1_42_ify;
        put_derivative(43, C1_43_eps);
        let t106 = M_22_Ifx + M_33_Ifx;
        let K0_33_eps = self.Mf * t98;
        put_derivative(44, K0_33_eps);
        let t108 = self.Mf * j;
        put_derivative(45, t108);
        let t109 = C0_66_Cf1 * K1_64;
        put_derivative(46, t109);
        let t110 = t32 * t106;
        let M_33_Mf = j * j;
        put_derivative(47, M_33_Mf);
        let t112 = j * M_12_a;
        let C1_24 = -C1_43_eps;
        put_entry(19, C1_24);
        let M_22_Mf = t98 * t98;
        put_derivative(48, M_22_Mf);
        let t115 = t98 * j;
        put_derivative(49, t115);
        let Kc_26_Cf1 = C0_66_Cf1 * t84 * (self.a - self.t);
        put_derivative(50, Kc_26_Cf1);
        let t122 = M_23_Ifz * (self.Ifx - self.Ifz) + self.Mf * t115;
        let t127 = self.Mf * M_22_Mf + M_33_Ifx * self.Ifz + M_22_Ifx * self.Ifx;
        let t132 = j * t108 + M_33_Ifx * self.Ifx + M_22_Ifx * self.Ifz;
        let Kc_26_a = C0_66 * t84;
        put_derivative(51, Kc_26_a);
        let M_33_f = t112 + t112;
        put_derivative(52, M_33_f);
        let M_12 = -K0_33_eps;
        put_entry(1, M_12);
        let C0_62_sigma = C0_66 * Kc_26_Cf1;
        put_derivative(53, C0_62_sigma);
        let Kc_26 = self.Cf1 * Kc_26_Cf1;
        put_entry(25, Kc_26);
        let M_14_Mf = t110 - self.a;
        put_derivative(54, M_14_Mf);
        let t139 = self.a - t110;
        let M_24_Mf = t98 * t139;
        put_derivative(55, M_24_Mf);
        let t141 = j * t139;
        put_derivative(56, t141);
        let M_13 = t33 + t108;
        put_entry(2, M_13);
        let C1_32 = M_13 + h_wheels_all;
        put_entry(20, C1_32);
        let K0_33 = -M_13;
        put_entry(27, K0_33);
        let t145 = self.Mf * t139;
        let C1_42 = C1_43_eps - t145;
        put_entry(22, C1_42);
        let Kc_26_eps = s * t84 * Kc_26;
        put_derivative(57, Kc_26_eps);
        let M_33 = self.Irx + t132 + self.h * t33;
        put_entry(7, M_33);
        let M_23_eps = t127 - t132;
        put_derivative(58, M_23_eps);
        let M_22 = self.Irz + t127;
        put_entry(4, M_22);
        let C0_62 = -Kc_26;
        put_entry(15, C0_62);
        let t156 = t106 * (t145 + t145);
        put_derivative(59, t156);
        let M_22_eps = t122 + t122;
        put_derivative(60, M_22_eps);
        let M_23 = -(self.Crxz + t122);
        put_entry(5, M_23);
        let M_14 = -t145;
        put_entry(3, M_14);
        let M_24_Ifz = s_eps * t106;
        put_derivative(61, M_24_Ifz);
        let M_24 = self.Ifz * M_24_Ifz + K0_33_eps * t139;
        put_entry(6, M_24);
        put_derivative(62, M_24);
        let M_34_Ifz = s * t106;
        put_derivative(63, M_34_Ifz);
        let t166 = self.Ifz * M_34_Ifz;
        let t167 = j * t145;
        let M_34 = t166 - t167;
        put_entry(8, M_34);
        let M_24_eps = t167 - t166;
        put_derivative(64, M_24_eps);
        let t170 = j * M_13_a;
        let t171 = t98 * M_13_a;
        let M_23_a = t112 - t171;
        put_derivative(65, M_23_a);
        let M_22_f = t171 + t171;
        put_derivative(66, M_22_f);
        let M_33_a = t170 + t170;
        put_derivative(67, M_33_a);
        let M_44_Mf = t139 * t139;
        put_derivative(68, M_44_Mf);
        let M_44 = self.Ifz + self.Mf * M_44_Mf;
        put_entry(9, M_44);
        let K0_34_Mf = t139 * t67;
        put_derivative(69, K0_34_Mf);
        let K0_34 = self.Mf * K0_34_Mf - self.Zf * t68;
        put_entry(28, K0_34);
        let K0_44_Mf = s * K0_34_Mf;
        put_derivative(70, K0_44_Mf);
        let t183 = s_eps * K0_33_eps;
        let t184 = t183 + t170;
        put_derivative(71, t184);
        let t185 = t183 + t183;
        put_derivative(72, t185);
        let K0_44 = s * K0_34;
        put_entry(29, K0_44);
        let K0_44_eps = s_eps * K0_34;
        put_derivative(73, K0_44_eps);
        let K0_34_g = t45 * (t145 - K0_34);
        put_derivative(74, K0_34_g);
        let M_14_e = self.Mf * t106;
        put_derivative(75, M_14_e);
        let t191 = t67 * M_14_e;
        put_derivative(76, t191);
        let t192 = s * t191;
        put_derivative(77, t192);
        let t193 = s_eps * t145;
        put_derivative(78, t193);
        let t195 = t98 * M_14_e + t193;
        put_derivative(79, t195);
        let M_24_f = s * t145;
        put_derivative(80, M_24_f);
        let M_34_e = t108 * t106 - M_24_f;
        put_derivative(81, M_34_e);
        let M_24_a = K0_33_eps - t195;
        put_derivative(82, M_24_a);
        let M_34_a = M_34_e - t108;
        put_derivative(83, M_34_a);
        let K0_44_g = s * K0_34_g;
        put_derivative(84, K0_44_g);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl Motorcycle<f64> {
    /// The parameter set `standard`.
    ///
    /// Source: Sharp (1971), case 1: in slug, ft and lb, made SI by 14.5939 kg and 0.3048 m
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `Mf` | 30.64719 | `kg` |
    /// | `Mr` | 217.44911 | `kg` |
    /// | `Irx` | 31.183806535488 | `kg*m^2` |
    /// | `Irz` | 21.06940667658624 | `kg*m^2` |
    /// | `Crxz` | 1.73544662458368 | `kg*m^2` |
    /// | `Ifx` | 1.23379408466496 | `kg*m^2` |
    /// | `Ifz` | 0.441996562198656 | `kg*m^2` |
    /// | `ify` | 0.71858336799168 | `kg*m^2` |
    /// | `iry` | 1.0507586984784 | `kg*m^2` |
    /// | `a` | 0.9485376 | `m` |
    /// | `b` | 0.4797552 | `m` |
    /// | `e` | 0.024384 | `m` |
    /// | `f` | 0.0283464 | `m` |
    /// | `h` | 0.615696 | `m` |
    /// | `Rf` | 0.3048 | `m` |
    /// | `Rr` | 0.3048 | `m` |
    /// | `t` | 0.115824 | `m` |
    /// | `eps` | 0.4715 | `rad` |
    /// | `Cf1` | 11173.93044864 | `N` |
    /// | `Cf2` | 938.57457192 | `N` |
    /// | `Cr1` | 15831.21754248 | `N` |
    /// | `Cr2` | 1325.56977456 | `N` |
    /// | `K` | 6.77908837728 | `N*m*s` |
    /// | `sigma` | 0.24384 | `m` |
    /// | `Zf` | 1005.29788272 | `N` |
    /// | `g` | 9.81456 | `N/kg` |
    pub const STANDARD: Self = Self {
        Mf: 30.64719, Mr: 217.44911, Irx: 31.183806535488, Irz: 21.06940667658624,
        Crxz: 1.73544662458368, Ifx: 1.23379408466496, Ifz: 0.441996562198656,
        ify: 0.71858336799168, iry: 1.0507586984784, a: 0.9485376, b: 0.4797552, e: 0.024384,
        f: 0.0283464, h: 0.615696, Rf: 0.3048, Rr: 0.3048, t: 0.115824, eps: 0.4715,
        Cf1: 11173.93044864, Cf2: 938.57457192, Cr1: 15831.21754248, Cr2: 1325.56977456,
        K: 6.77908837728, sigma: 0.24384, Zf: 1005.29788272, g: 9.81456,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> Motorcycle<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 26]) -> Self {
        Self {
            Mf: values[0], Mr: values[1], Irx: values[2], Irz: values[3], Crxz: values[4],
            Ifx: values[5], Ifz: values[6], ify: values[7], iry: values[8], a: values[9],
            b: values[10], e: values[11], f: values[12], h: values[13], Rf: values[14],
            Rr: values[15], t: values[16], eps: values[17], Cf1: values[18], Cf2: values[19],
            Cr1: values[20], Cr2: values[21], K: values[22], sigma: values[23], Zf: values[24],
            g: values[25],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 26] {
        [
            self.Mf, self.Mr, self.Irx, self.Irz, self.Crxz, self.Ifx, self.Ifz, self.ify, self.iry,
            self.a, self.b, self.e, self.f, self.h, self.Rf, self.Rr, self.t, self.eps, self.Cf1,
            self.Cf2, self.Cr1, self.Cr2, self.K, self.sigma, self.Zf, self.g,
        ]
    }
}

impl<T: Scalar> Motorcycle<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> Motorcycle<U> {
        let values = self.to_array();
        Motorcycle::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl Motorcycle<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> Motorcycle<f32> {
        Motorcycle::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<Motorcycle<f32>> for Motorcycle<f64> {
    fn from(parameters: Motorcycle<f32>) -> Self {
        Motorcycle::cast(&parameters)
    }
}

impl<T: Number> MotorcycleMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 216]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c0: carvallo::rows(&entries, 36),
            c1: carvallo::rows(&entries, 72),
            kc: carvallo::rows(&entries, 108),
            k0: carvallo::rows(&entries, 144),
            k1: carvallo::rows(&entries, 180),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 35] {
        [
            self.m[0][0], self.m[0][1], self.m[0][2], self.m[0][3], self.m[1][1], self.m[1][2],
            self.m[1][3], self.m[2][2], self.m[2][3], self.m[3][3], self.c0[3][3], self.c0[4][0],
            self.c0[4][1], self.c0[4][4], self.c0[5][0], self.c0[5][1], self.c0[5][3],
            self.c0[5][5], self.c1[1][2], self.c1[1][3], self.c1[2][1], self.c1[2][3],
            self.c1[3][1], self.c1[3][2], self.kc[1][4], self.kc[1][5], self.kc[3][5],
            self.k0[2][2], self.k0[2][3], self.k0[3][3], self.k1[4][2], self.k1[4][4],
            self.k1[5][2], self.k1[5][3], self.k1[5][5],
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
            }
            3 => {
                self.m[0][3] = entry;
                self.m[3][0] = entry;
            }
            4 => {
                self.m[1][1] = entry;
            }
            5 => {
                self.m[1][2] = entry;
                self.m[2][1] = entry;
            }
            6 => {
                self.m[1][3] = entry;
                self.m[3][1] = entry;
            }
            7 => {
                self.m[2][2] = entry;
            }
            8 => {
                self.m[2][3] = entry;
                self.m[3][2] = entry;
            }
            9 => {
                self.m[3][3] = entry;
            }
            10 => {
                self.c0[3][3] = entry;
            }
            11 => {
                self.c0[4][0] = entry;
            }
            12 => {
                self.c0[4][1] = entry;
            }
            13 => {
                self.c0[4][4] = entry;
                self.kc[0][4] = entry;
            }
            14 => {
                self.c0[5][0] = entry;
            }
            15 => {
                self.c0[5][1] = entry;
            }
            16 => {
                self.c0[5][3] = entry;
            }
            17 => {
                self.c0[5][5] = entry;
                self.kc[0][5] = entry;
            }
            18 => {
                self.c1[1][2] = entry;
            }
            19 => {
                self.c1[1][3] = entry;
            }
            20 => {
                self.c1[2][1] = entry;
            }
            21 => {
                self.c1[2][3] = entry;
            }
            22 => {
                self.c1[3][1] = entry;
            }
            23 => {
                self.c1[3][2] = entry;
            }
            24 => {
                self.kc[1][4] = entry;
            }
            25 => {
                self.kc[1][5] = entry;
            }
            26 => {
                self.kc[3][5] = entry;
            }
            27 => {
                self.k0[2][2] = entry;
            }
            28 => {
                self.k0[2][3] = entry;
                self.k0[3][2] = entry;
            }
            29 => {
                self.k0[3][3] = entry;
            }
            30 => {
                self.k1[4][2] = entry;
            }
            31 => {
                self.k1[4][4] = entry;
            }
            32 => {
                self.k1[5][2] = entry;
            }
            33 => {
                self.k1[5][3] = entry;
            }
            34 => {
                self.k1[5][5] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 6]; 6]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 6]; 6];
        [self.m.0, zeros, self.c0.0, self.c1.0, self.kc.0, self.k0.0, self.k1.0, zeros]
    }
}

impl<T: Scalar> From<MotorcycleMatrices<T>> for Coefficients<T, 6> {
    fn from(matrices: MotorcycleMatrices<T>) -> Self {
        Coefficients {
            states: [
                States::Rate, States::Rate, States::Both, States::Both, States::Position,
                States::Position,
            ],
            ..Coefficients::from_rows(matrices.rows())
        }
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<6> for Motorcycle<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 26];

    type Over<U: Number> = Motorcycle<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "Motorcycle",
        docs: "A motorcycle on tyres that slip, whose side forces follow slip and camber over a length: two bodies, of which the front\none steers, with wheels in their masses.\n\nAxes: origin on the ground below the centre of mass of the rear part, x forward, y to the right, z down. The steering takes\nthe load of the front wheel that is given with the parameters, `Zf`, and not the one that follows from the masses.",
        source: "Sharp (1971), The stability and control of motorcycles, J. Mech. Eng. Sci. 13, 316-329",
        parameters: &[
            ParameterInfo::new("Mf", "kg", Domain::POSITIVE)
                .docs("Mass of the front part, with its wheel."),
            ParameterInfo::new("Mr", "kg", Domain::POSITIVE)
                .docs("Mass of the rear part, with its wheel and the rider."),
            ParameterInfo::new("Irx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the rear part about a longitudinal axis, at its centre of mass."),
            ParameterInfo::new("Irz", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the rear part about a vertical axis."),
            ParameterInfo::new("Crxz", "kg*m^2", Domain::FINITE)
                .docs(
                    "Product of inertia of the rear part: what the product of lean and yaw rates is multiplied by in the kinetic\nenergy, with the opposite sign.",
                ),
            ParameterInfo::new("Ifx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the front part about an axis perpendicular to the steer axis, forward."),
            ParameterInfo::new("Ifz", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the front part about an axis along the steer axis."),
            ParameterInfo::new("ify", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the front wheel about its axle."),
            ParameterInfo::new("iry", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the rear wheel about its axle, with that of the engine as it is geared."),
            ParameterInfo::new("a", "m", Domain::POSITIVE)
                .docs("Distance of the origin from the steer axis."),
            ParameterInfo::new("b", "m", Domain::POSITIVE)
                .docs("Distance of the rear contact point behind the origin."),
            ParameterInfo::new("e", "m", Domain::FINITE)
                .docs("Distance of the centre of mass of the front part ahead of the steer axis."),
            ParameterInfo::new("f", "m", Domain::FINITE)
                .docs(
                    "Height of the centre of mass of the front part, along the steer axis, over the foot of the perpendicular from\nthe origin.",
                ),
            ParameterInfo::new("h", "m", Domain::POSITIVE)
                .docs("Height of the centre of mass of the rear part."),
            ParameterInfo::new("Rf", "m", Domain::POSITIVE)
                .docs("Radius of the front wheel."),
            ParameterInfo::new("Rr", "m", Domain::POSITIVE)
                .docs("Radius of the rear wheel."),
            ParameterInfo::new("t", "m", Domain::FINITE)
                .docs("Distance of the front contact point behind the steer axis."),
            ParameterInfo::new(
                    "eps",
                    "rad",
                    Domain::between(Bound::Open(-1.5707963267948966), Bound::Open(1.5707963267948966)),
                )
                .symbol("ε")
                .docs("Tilt of the steer axis from the vertical."),
            ParameterInfo::new("Cf1", "N", Domain::POSITIVE)
                .docs("Cornering stiffness of the front tyre."),
            ParameterInfo::new("Cf2", "N", Domain::NONNEGATIVE)
                .docs("Camber stiffness of the front tyre."),
            ParameterInfo::new("Cr1", "N", Domain::POSITIVE)
                .docs("Cornering stiffness of the rear tyre."),
            ParameterInfo::new("Cr2", "N", Domain::NONNEGATIVE)
                .docs("Camber stiffness of the rear tyre."),
            ParameterInfo::new("K", "N*m*s", Domain::NONNEGATIVE)
                .docs("Damping of the steering."),
            ParameterInfo::new("sigma", "m", Domain::POSITIVE)
                .symbol("σ")
                .docs("Relaxation length of both tyres."),
            ParameterInfo::new("Zf", "N", Domain::NONNEGATIVE)
                .docs("Load of the front wheel."),
            ParameterInfo::new("g", "N/kg", Domain::POSITIVE)
                .docs("Gravitational field strength."),
        ],
        coordinates: &[
            CoordinateInfo::new("y", "m")
                .label("lateral")
                .docs("Lateral motion of the origin, to the right; its rate is along the axes of the machine.")
                .states(States::Rate),
            CoordinateInfo::new("psi", "rad")
                .label("yaw")
                .docs("Yaw, to the right.")
                .states(States::Rate),
            CoordinateInfo::new("phi", "rad").label("lean").docs("Lean to the right."),
            CoordinateInfo::new("delta", "rad")
                .label("steer")
                .docs("Steer angle of the front part, to the right."),
            CoordinateInfo::new("er", "m")
                .label("rear tyre")
                .docs("Deflection of the rear tyre.")
                .states(States::Position),
            CoordinateInfo::new("ef", "m")
                .label("front tyre")
                .docs("Deflection of the front tyre.")
                .states(States::Position),
        ],
        forces: &[
            carvallo::motion::AppliedInfo {
                name: "Tdelta", label: "steer torque", unit: "N*m", position: "delta",
            },
        ],
        matrices: &[
            MatrixName::M, MatrixName::C0, MatrixName::C1, MatrixName::Kc, MatrixName::K0,
            MatrixName::K1,
        ],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0), (MatrixName::C1, 0, 1)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0), (MatrixName::C1, 1, 1)]),
            EntryInfo::at(&[(MatrixName::M, 0, 2), (MatrixName::M, 2, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 3), (MatrixName::M, 3, 0)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]),
            EntryInfo::at(&[(MatrixName::M, 1, 2), (MatrixName::M, 2, 1)]),
            EntryInfo::at(&[(MatrixName::M, 1, 3), (MatrixName::M, 3, 1)]),
            EntryInfo::at(&[(MatrixName::M, 2, 2)]),
            EntryInfo::at(&[(MatrixName::M, 2, 3), (MatrixName::M, 3, 2)]),
            EntryInfo::at(&[(MatrixName::M, 3, 3)]), EntryInfo::at(&[(MatrixName::C0, 3, 3)]),
            EntryInfo::at(&[(MatrixName::C0, 4, 0)]), EntryInfo::at(&[(MatrixName::C0, 4, 1)]),
            EntryInfo::at(&[(MatrixName::C0, 4, 4), (MatrixName::Kc, 0, 4)]),
            EntryInfo::at(&[(MatrixName::C0, 5, 0)]),
            EntryInfo::at(&[(MatrixName::C0, 5, 1)]),
            EntryInfo::at(&[(MatrixName::C0, 5, 3)]),
            EntryInfo::at(&[(MatrixName::C0, 5, 5), (MatrixName::Kc, 0, 5)]),
            EntryInfo::at(&[(MatrixName::C1, 1, 2)]), EntryInfo::at(&[(MatrixName::C1, 1, 3)]),
            EntryInfo::at(&[(MatrixName::C1, 2, 1)]), EntryInfo::at(&[(MatrixName::C1, 2, 3)]),
            EntryInfo::at(&[(MatrixName::C1, 3, 1)]), EntryInfo::at(&[(MatrixName::C1, 3, 2)]),
            EntryInfo::at(&[(MatrixName::Kc, 1, 4)]), EntryInfo::at(&[(MatrixName::Kc, 1, 5)]),
            EntryInfo::at(&[(MatrixName::Kc, 3, 5)]), EntryInfo::at(&[(MatrixName::K0, 2, 2)]),
            EntryInfo::at(&[(MatrixName::K0, 2, 3), (MatrixName::K0, 3, 2)]),
            EntryInfo::at(&[(MatrixName::K0, 3, 3)]), EntryInfo::at(&[(MatrixName::K1, 4, 2)]),
            EntryInfo::at(&[(MatrixName::K1, 4, 4)]), EntryInfo::at(&[(MatrixName::K1, 5, 2)]),
            EntryInfo::at(&[(MatrixName::K1, 5, 3)]), EntryInfo::at(&[(MatrixName::K1, 5, 5)]),
        ],
        sets: &[
            SetInfo {
                name: "standard",
                docs: "",
                source: "Sharp (1971), case 1: in slug, ft and lb, made SI by 14.5939 kg and 0.3048 m",
                values: &Motorcycle::to_array(&Motorcycle::<f64>::STANDARD),
            },
        ],
        requirements: &[RequirementInfo::new("b + l", "m", Domain::POSITIVE)],
        formulas: &[
            FormulaInfo::definition("s", "1", "sin(eps)"),
            FormulaInfo::definition("c", "1", "cos(eps)"),
            FormulaInfo::definition("l", "m", "(a - t)/c"),
            FormulaInfo::definition("k", "m", "(a + e)*c - f*s"),
            FormulaInfo::definition("j", "m", "(a + e)*s + f*c"),
            FormulaInfo::definition("load", "kg", "(b*(Mf + Mr) + k*Mf)/(b + l)"),
            FormulaInfo::definition("rest", "kg", "load - Zf/g"),
            FormulaInfo::definition("Jxx_delta", "kg*m^2", "Mf*j^2 + Ifx*c^2 + Ifz*s^2"),
            FormulaInfo::definition("Jxz_delta", "kg*m^2", "Mf*j*(k - a/c) + s*c*(Ifz - Ifx)"),
            FormulaInfo::definition("Jzz_delta", "kg*m^2", "Mf*(k - a/c)^2 + Ifx*s^2 + Ifz*c^2"),
            FormulaInfo::definition("Sx_delta", "kg*m", "Mf*(k - a/c)"),
            FormulaInfo::definition("Sz_delta", "kg*m", "-Mf*j"),
            FormulaInfo::definition("py_delta", "kg*m", "c*Sx_delta - s*Sz_delta"),
            FormulaInfo::definition("hx_delta", "kg*m^2", "s*Jxx_delta + c*Jxz_delta"),
            FormulaInfo::definition("hz_delta", "kg*m^2", "s*Jxz_delta + c*Jzz_delta"),
            FormulaInfo::definition("Jxx_all", "kg*m^2", "Mr*h^2 + Irx + Jxx_delta"),
            FormulaInfo::definition("Jxz_all", "kg*m^2", "Jxz_delta - Crxz - a*Sz_delta/c"),
            FormulaInfo::definition("Jzz_all", "kg*m^2", "Mf*k^2 + Irz + Ifx*s^2 + Ifz*c^2"),
            FormulaInfo::definition("Sx_all", "kg*m", "Mf*k"),
            FormulaInfo::definition("Sz_all", "kg*m", "Sz_delta - Mr*h"),
            FormulaInfo::definition("m_all", "kg", "Mf + Mr"),
            FormulaInfo::definition("load_spin_F", "kg", "-(b*m_all + Sx_all)/(b + l)"),
            FormulaInfo::definition("h_spin_R", "kg*m", "iry/Rr"),
            FormulaInfo::definition("h_spin_F", "kg*m", "ify/Rf"),
            FormulaInfo::definition("h_wheels_all", "kg*m", "h_spin_R + h_spin_F"),
            FormulaInfo::definition("M_psi_delta", "kg*m^2", "a*py_delta/c + hz_delta"),
            FormulaInfo::definition("M_delta_delta", "kg*m^2", "s*hx_delta + c*hz_delta"),
            FormulaInfo::definition("K_phi_delta", "kg*m", "-(py_delta + load_spin_F*(c*l - a))"),
            FormulaInfo::definition("K_delta_delta", "kg*m", "-s*(py_delta + load_spin_F*(c*l - a))"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg", "m_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)], "kg*m", "Sx_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 2), (MatrixName::M, 2, 0)], "kg*m", "-Sz_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 3), (MatrixName::M, 3, 0)], "kg*m", "py_delta"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "Jzz_all"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 2), (MatrixName::M, 2, 1)], "kg*m^2", "Jxz_all"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 3), (MatrixName::M, 3, 1)], "kg*m^2", "M_psi_delta"),
            FormulaInfo::entry(&[(MatrixName::M, 2, 2)], "kg*m^2", "Jxx_all"),
            FormulaInfo::entry(&[(MatrixName::M, 2, 3), (MatrixName::M, 3, 2)], "kg*m^2", "hx_delta"),
            FormulaInfo::entry(&[(MatrixName::M, 3, 3)], "kg*m^2", "M_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::C0, 3, 3)], "kg*m^2/s", "K"),
            FormulaInfo::entry(&[(MatrixName::C0, 4, 0)], "kg/s^2", "-Cr1/sigma"),
            FormulaInfo::entry(&[(MatrixName::C0, 4, 1)], "kg*m/s^2", "b*Cr1/sigma"),
            FormulaInfo::entry(&[(MatrixName::C0, 4, 4)], "kg/s^2", "Cr1/sigma"),
            FormulaInfo::entry(&[(MatrixName::C0, 5, 0)], "kg/s^2", "-Cf1/sigma"),
            FormulaInfo::entry(&[(MatrixName::C0, 5, 1)], "kg*m/s^2", "-Cf1*l/sigma"),
            FormulaInfo::entry(&[(MatrixName::C0, 5, 3)], "kg*m/s^2", "Cf1*(a - c*l)/sigma"),
            FormulaInfo::entry(&[(MatrixName::C0, 5, 5)], "kg/s^2", "Cf1/sigma"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 1)], "kg", "m_all"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 1)], "kg*m", "Sx_all"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 2)], "kg*m", "-h_wheels_all"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 3)], "kg*m", "-s*h_spin_F"),
            FormulaInfo::entry(&[(MatrixName::C1, 2, 1)], "kg*m", "h_wheels_all - Sz_all"),
            FormulaInfo::entry(&[(MatrixName::C1, 2, 3)], "kg*m", "c*h_spin_F"),
            FormulaInfo::entry(&[(MatrixName::C1, 3, 1)], "kg*m", "s*h_spin_F + py_delta"),
            FormulaInfo::entry(&[(MatrixName::C1, 3, 2)], "kg*m", "-c*h_spin_F"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 4)], "kg/s^2", "Cr1/sigma"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 5)], "kg/s^2", "Cf1/sigma"),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 4)], "kg*m/s^2", "-b*Cr1/sigma"),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 5)], "kg*m/s^2", "Cf1*l/sigma"),
            FormulaInfo::entry(&[(MatrixName::Kc, 3, 5)], "kg*m/s^2", "Cf1*(c*l - a)/sigma"),
            FormulaInfo::entry(&[(MatrixName::K0, 2, 2)], "kg*m", "Sz_all"),
            FormulaInfo::entry(&[(MatrixName::K0, 2, 3), (MatrixName::K0, 3, 2)], "kg*m", "t*rest + K_phi_delta"),
            FormulaInfo::entry(&[(MatrixName::K0, 3, 3)], "kg*m", "t*s*rest + K_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::K1, 4, 2)], "kg/s^2", "Cr2/sigma"),
            FormulaInfo::entry(&[(MatrixName::K1, 4, 4)], "kg/m/s^2", "Cr1/sigma^2"),
            FormulaInfo::entry(&[(MatrixName::K1, 5, 2)], "kg/s^2", "Cf2/sigma"),
            FormulaInfo::entry(&[(MatrixName::K1, 5, 3)], "kg/s^2", "(Cf1*c + Cf2*s)/sigma"),
            FormulaInfo::entry(&[(MatrixName::K1, 5, 5)], "kg/m/s^2", "Cf1/sigma^2"),
        ],
        attributes: &[
            FormulaInfo::definition("s", "1", "sin(eps)"),
            FormulaInfo::definition("c", "1", "cos(eps)"),
            FormulaInfo::definition("l", "m", "(a - t)/c"),
            FormulaInfo::definition("k", "m", "(a + e)*c - f*s"),
            FormulaInfo::definition("j", "m", "(a + e)*s + f*c"),
            FormulaInfo::definition("load", "kg", "(b*(Mf + Mr) + k*Mf)/(b + l)"),
            FormulaInfo::definition("rest", "kg", "load - Zf/g"),
            FormulaInfo::attribute("rear_mass", "the mass of the rear part rear", "kg", "Mr"),
            FormulaInfo::attribute("rear_z", "z of the centre of mass of the rear part rear", "m", "-h"),
            FormulaInfo::attribute("rear_Ixx", "the inertia xx of the rear part rear", "kg*m^2", "Irx"),
            FormulaInfo::attribute("rear_Ixz", "the inertia xz of the rear part rear", "kg*m^2", "-Crxz"),
            FormulaInfo::attribute("rear_Izz", "the inertia zz of the rear part rear", "kg*m^2", "Irz"),
            FormulaInfo::attribute("front_mass", "the mass of the front part front", "kg", "Mf"),
            FormulaInfo::attribute("front_x", "x of the centre of mass of the front part front", "m", "k"),
            FormulaInfo::attribute("front_z", "z of the centre of mass of the front part front", "m", "-j"),
            FormulaInfo::attribute(
                "front_Ixx", "the inertia xx of the front part front", "kg*m^2",
                "Ifx*c^2 + Ifz*s^2",
            ),
            FormulaInfo::attribute("front_Ixz", "the inertia xz of the front part front", "kg*m^2", "(Ifz - Ifx)*s*c"),
            FormulaInfo::attribute(
                "front_Izz", "the inertia zz of the front part front", "kg*m^2",
                "Ifx*s^2 + Ifz*c^2",
            ),
            FormulaInfo::attribute("R_radius", "the radius of the rear wheel R", "m", "Rr"),
            FormulaInfo::attribute("R_axial", "the axial inertia of the rear wheel R", "kg*m^2", "iry"),
            FormulaInfo::attribute("R_x", "x of the centre of the rear wheel R", "m", "-b"),
            FormulaInfo::attribute("R_z", "z of the centre of the rear wheel R", "m", "-Rr"),
            FormulaInfo::attribute("R_cornering", "the cornering stiffness of the rear wheel R", "kg*m/s^2", "Cr1"),
            FormulaInfo::attribute("R_camber", "the camber stiffness of the rear wheel R", "kg*m/s^2", "Cr2"),
            FormulaInfo::attribute("R_relaxation", "the relaxation length of the rear wheel R", "m", "sigma"),
            FormulaInfo::attribute("F_radius", "the radius of the front wheel F", "m", "Rf"),
            FormulaInfo::attribute("F_axial", "the axial inertia of the front wheel F", "kg*m^2", "ify"),
            FormulaInfo::attribute("F_x", "x of the centre of the front wheel F", "m", "l"),
            FormulaInfo::attribute("F_z", "z of the centre of the front wheel F", "m", "-Rf"),
            FormulaInfo::attribute("F_cornering", "the cornering stiffness of the front wheel F", "kg*m/s^2", "Cf1"),
            FormulaInfo::attribute("F_camber", "the camber stiffness of the front wheel F", "kg*m/s^2", "Cf2"),
            FormulaInfo::attribute("F_relaxation", "the relaxation length of the front wheel F", "m", "sigma"),
            FormulaInfo::attribute("delta_through_x", "x of the point of the joint delta", "m", "a/c"),
            FormulaInfo::attribute("delta_along_x", "x of the axis of the joint delta", "1", "s"),
            FormulaInfo::attribute("delta_along_z", "z of the axis of the joint delta", "1", "c"),
            FormulaInfo::attribute("delta_damper", "the damper of the joint delta", "kg*m^2/s", "K"),
            FormulaInfo::attribute("added_K0_3_4", "what is added to K0_34", "kg*m", "rest*t"),
            FormulaInfo::attribute("added_K0_4_3", "what is added to K0_43", "kg*m", "rest*t"),
            FormulaInfo::attribute("added_K0_4_4", "what is added to K0_44", "kg*m", "rest*t*s"),
            FormulaInfo::definition("length_delta", "1", "sqrt(delta_along_x^2 + delta_along_z^2)"),
            FormulaInfo::definition("Jxx_delta", "kg*m^2", "front_mass*front_z^2 + front_Ixx"),
            FormulaInfo::definition(
                "Jxz_delta",
                "kg*m^2",
                "front_Ixz - front_mass*front_z*(front_x - delta_through_x)",
            ),
            FormulaInfo::definition("Jzz_delta", "kg*m^2", "front_mass*(front_x - delta_through_x)^2 + front_Izz"),
            FormulaInfo::definition("Sx_delta", "kg*m", "front_mass*(front_x - delta_through_x)"),
            FormulaInfo::definition("Sz_delta", "kg*m", "front_mass*front_z"),
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
            FormulaInfo::definition("Jxx_all", "kg*m^2", "rear_mass*rear_z^2 + rear_Ixx + Jxx_delta"),
            FormulaInfo::definition("Jxz_all", "kg*m^2", "rear_Ixz + Jxz_delta - delta_through_x*Sz_delta"),
            FormulaInfo::definition(
                "Jzz_all",
                "kg*m^2",
                "rear_Izz + 2*delta_through_x*((1/2)*front_mass*delta_through_x + Sx_delta) + Jzz_delta",
            ),
            FormulaInfo::definition("Sx_all", "kg*m", "front_mass*delta_through_x + Sx_delta"),
            FormulaInfo::definition("Sz_all", "kg*m", "rear_mass*rear_z + Sz_delta"),
            FormulaInfo::definition("m_all", "kg", "rear_mass + front_mass"),
            FormulaInfo::definition("load_spin_F", "kg", "(Sx_all - R_x*m_all)/(R_x - F_x)"),
            FormulaInfo::definition("load_spin_R", "kg", "-(m_all + load_spin_F)"),
            FormulaInfo::definition("h_spin_R", "kg*m", "R_axial/R_radius"),
            FormulaInfo::definition("h_spin_F", "kg*m", "F_axial/F_radius"),
            FormulaInfo::definition("h_wheels_all", "kg*m", "h_spin_R + h_spin_F"),
            FormulaInfo::definition("M_psi_delta", "kg*m^2", "delta_through_x*py_delta + hz_delta"),
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
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg", "m_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)], "kg*m", "Sx_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 2), (MatrixName::M, 2, 0)], "kg*m", "-Sz_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 3), (MatrixName::M, 3, 0)], "kg*m", "py_delta"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "Jzz_all"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 2), (MatrixName::M, 2, 1)], "kg*m^2", "Jxz_all"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 3), (MatrixName::M, 3, 1)], "kg*m^2", "M_psi_delta"),
            FormulaInfo::entry(&[(MatrixName::M, 2, 2)], "kg*m^2", "Jxx_all"),
            FormulaInfo::entry(&[(MatrixName::M, 2, 3), (MatrixName::M, 3, 2)], "kg*m^2", "hx_delta"),
            FormulaInfo::entry(&[(MatrixName::M, 3, 3)], "kg*m^2", "M_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::C0, 3, 3)], "kg*m^2/s", "delta_damper"),
            FormulaInfo::entry(&[(MatrixName::C0, 4, 0)], "kg/s^2", "-R_cornering/R_relaxation"),
            FormulaInfo::entry(&[(MatrixName::C0, 4, 1)], "kg*m/s^2", "-R_x*R_cornering/R_relaxation"),
            FormulaInfo::entry(&[(MatrixName::C0, 4, 2)], "kg*m/s^2", "R_cornering*(R_radius + R_z)/R_relaxation"),
            FormulaInfo::entry(&[(MatrixName::C0, 4, 4)], "kg/s^2", "R_cornering/R_relaxation"),
            FormulaInfo::entry(&[(MatrixName::C0, 5, 0)], "kg/s^2", "-F_cornering/F_relaxation"),
            FormulaInfo::entry(&[(MatrixName::C0, 5, 1)], "kg*m/s^2", "-F_x*F_cornering/F_relaxation"),
            FormulaInfo::entry(&[(MatrixName::C0, 5, 2)], "kg*m/s^2", "F_cornering*(F_radius + F_z)/F_relaxation"),
            FormulaInfo::entry(
                &[(MatrixName::C0, 5, 3)],
                "kg*m/s^2",
                "-F_cornering*(delta_along_z*(F_x - delta_through_x) - delta_along_x*(F_radius + F_z))/F_relaxation/length_delta",
            ),
            FormulaInfo::entry(&[(MatrixName::C0, 5, 5)], "kg/s^2", "F_cornering/F_relaxation"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 1)], "kg", "m_all"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 1)], "kg*m", "Sx_all"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 2)], "kg*m", "-h_wheels_all"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 3)], "kg*m", "-delta_along_x*h_spin_F/length_delta"),
            FormulaInfo::entry(&[(MatrixName::C1, 2, 1)], "kg*m", "h_wheels_all - Sz_all"),
            FormulaInfo::entry(&[(MatrixName::C1, 2, 3)], "kg*m", "delta_along_z*h_spin_F/length_delta"),
            FormulaInfo::entry(&[(MatrixName::C1, 3, 1)], "kg*m", "delta_along_x*h_spin_F/length_delta + py_delta"),
            FormulaInfo::entry(&[(MatrixName::C1, 3, 2)], "kg*m", "-delta_along_z*h_spin_F/length_delta"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 4)], "kg/s^2", "R_cornering/R_relaxation"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 5)], "kg/s^2", "F_cornering/F_relaxation"),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 4)], "kg*m/s^2", "R_x*R_cornering/R_relaxation"),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 5)], "kg*m/s^2", "F_x*F_cornering/F_relaxation"),
            FormulaInfo::entry(&[(MatrixName::Kc, 2, 4)], "kg*m/s^2", "-R_cornering*(R_radius + R_z)/R_relaxation"),
            FormulaInfo::entry(&[(MatrixName::Kc, 2, 5)], "kg*m/s^2", "-F_cornering*(F_radius + F_z)/F_relaxation"),
            FormulaInfo::entry(
                &[(MatrixName::Kc, 3, 5)],
                "kg*m/s^2",
                "F_cornering*(delta_along_z*(F_x - delta_through_x) - delta_along_x*(F_radius + F_z))/F_relaxation/length_delta",
            ),
            FormulaInfo::entry(&[(MatrixName::K0, 2, 2)], "kg*m", "K_phi_phi"),
            FormulaInfo::entry(&[(MatrixName::K0, 2, 3)], "kg*m", "added_K0_3_4 + K_phi_delta"),
            FormulaInfo::entry(&[(MatrixName::K0, 3, 2)], "kg*m", "added_K0_4_3 + K_phi_delta"),
            FormulaInfo::entry(&[(MatrixName::K0, 3, 3)], "kg*m", "added_K0_4_4 + K_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::K1, 4, 2)], "kg/s^2", "R_camber/R_relaxation"),
            FormulaInfo::entry(&[(MatrixName::K1, 4, 4)], "kg/m/s^2", "R_cornering/R_relaxation^2"),
            FormulaInfo::entry(&[(MatrixName::K1, 5, 2)], "kg/s^2", "F_camber/F_relaxation"),
            FormulaInfo::entry(
                &[(MatrixName::K1, 5, 3)],
                "kg/s^2",
                "(F_cornering*delta_along_z + F_camber*delta_along_x)/F_relaxation/length_delta",
            ),
            FormulaInfo::entry(&[(MatrixName::K1, 5, 5)], "kg/m/s^2", "F_cornering/F_relaxation^2"),
        ],
        motion: None,
        gravity: Some(25),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("Motorcycle", 26, values)?;
        Ok(<Self as Evaluator<T, 6>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("Motorcycle", 26, values)?;
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
        let info = const { &<Self as Model<6>>::INFO.without_formulas() };
        info.validate(&self.to_array().map(Scalar::to_f64))?;
        let c = self.eps.cos();
        let l = (self.a - self.t) / c;
        let t7 = self.b + l;
        info.validate_requirements(&[Scalar::to_f64(t7)])?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 6> {
        Coefficients {
            states: [
                States::Rate, States::Rate, States::Both, States::Both, States::Position,
                States::Position,
            ],
            ..Coefficients::from_rows(MotorcycleMatrices::rows(&self.matrices()))
        }
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 6>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn shares(&self, force: usize) -> Option<[T; 6]> {
        (force < 1).then(|| self.kinematics().forces.map(|row| row[force]))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl Motorcycle<f64> {
    /// What the model tells about itself, the same for every number type.
    pub const INFO: &'static ModelInfo = <Self as Model<6>>::INFO;

    /// The parameter set of this name, however it is spelt: upper and lower case, `_`, `-` and spaces make no
    /// difference. In `f32` it is had by the trait `Model`.
    #[must_use]
    pub fn set(name: &str) -> Option<Self> {
        <Self as Model<6>>::set(name)
    }
}

/// The parameters, one a line with its unit, in the precision that is asked for; `{:#}` says what they are.
impl<T: Scalar> core::fmt::Display for Motorcycle<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<6>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 6> for Motorcycle<T> {
    type Entries = [T; 35];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            Mf: parameter(0), Mr: parameter(1), Irx: parameter(2), Irz: parameter(3),
            Crxz: parameter(4), Ifx: parameter(5), Ifz: parameter(6), ify: parameter(7),
            iry: parameter(8), a: parameter(9), b: parameter(10), e: parameter(11),
            f: parameter(12), h: parameter(13), Rf: parameter(14), Rr: parameter(15),
            t: parameter(16), eps: parameter(17), Cf1: parameter(18), Cf2: parameter(19),
            Cr1: parameter(20), Cr2: parameter(21), K: parameter(22), sigma: parameter(23),
            Zf: parameter(24), g: parameter(25),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        MotorcycleMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 6]; 6]; 8] {
        MotorcycleMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> MotorcycleDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<MotorcycleMatrices<T>> {
        if parameter >= 26 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = MotorcycleMatrices {
            m: Rows([[zero; 6]; 6]), c0: Rows([[zero; 6]; 6]), c1: Rows([[zero; 6]; 6]),
            kc: Rows([[zero; 6]; 6]), k0: Rows([[zero; 6]; 6]), k1: Rows([[zero; 6]; 6]),
        };
        for position in 0..197 {
            let partial = <MotorcycleDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C0 => &mut matrices.c0,
                MatrixName::C1 => &mut matrices.c1,
                MatrixName::Kc => &mut matrices.kc,
                MatrixName::K0 => &mut matrices.k0,
                MatrixName::K1 => &mut matrices.k1,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<6> for Motorcycle<T> {
    type Derivatives = [Coefficients<T, 6>; 26];

    type WithDerivativesOver<U: Number> = Motorcycle<U>;

    const PARTIALS: &'static [Partial] = <MotorcycleDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 6>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 6]; 6]; 8]); 26];
        for position in 0..197 {
            Partial::write(&<MotorcycleDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (
            Coefficients {
                states: [
                    States::Rate, States::Rate, States::Both, States::Both, States::Position,
                    States::Position,
                ],
                ..Coefficients::from_rows(MotorcycleMatrices::rows(&matrices))
            },
            all,
        )
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 6> for Motorcycle<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl MotorcycleDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 197] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 2), Partial::new(MatrixName::M, 0, 1, 0, 41),
        Partial::new(MatrixName::M, 0, 2, 0, 26), Partial::new(MatrixName::M, 0, 3, 0, 54),
        Partial::new(MatrixName::M, 1, 0, 0, 41), Partial::new(MatrixName::M, 1, 1, 0, 48),
        Partial::new(MatrixName::M, 1, 2, 0, 49).negative(),
        Partial::new(MatrixName::M, 1, 3, 0, 55), Partial::new(MatrixName::M, 2, 0, 0, 26),
        Partial::new(MatrixName::M, 2, 1, 0, 49).negative(),
        Partial::new(MatrixName::M, 2, 2, 0, 47),
        Partial::new(MatrixName::M, 2, 3, 0, 56).negative(),
        Partial::new(MatrixName::M, 3, 0, 0, 54), Partial::new(MatrixName::M, 3, 1, 0, 55),
        Partial::new(MatrixName::M, 3, 2, 0, 56).negative(),
        Partial::new(MatrixName::M, 3, 3, 0, 68), Partial::new(MatrixName::C1, 0, 1, 0, 2),
        Partial::new(MatrixName::C1, 1, 1, 0, 41), Partial::new(MatrixName::C1, 2, 1, 0, 26),
        Partial::new(MatrixName::C1, 3, 1, 0, 54),
        Partial::new(MatrixName::K0, 2, 2, 0, 26).negative(),
        Partial::new(MatrixName::K0, 2, 3, 0, 69), Partial::new(MatrixName::K0, 3, 2, 0, 69),
        Partial::new(MatrixName::K0, 3, 3, 0, 70), Partial::new(MatrixName::M, 0, 0, 1, 2),
        Partial::new(MatrixName::M, 0, 2, 1, 1), Partial::new(MatrixName::M, 2, 0, 1, 1),
        Partial::new(MatrixName::M, 2, 2, 1, 7), Partial::new(MatrixName::C1, 0, 1, 1, 2),
        Partial::new(MatrixName::C1, 2, 1, 1, 1),
        Partial::new(MatrixName::K0, 2, 2, 1, 1).negative(),
        Partial::new(MatrixName::M, 2, 2, 2, 2), Partial::new(MatrixName::M, 1, 1, 3, 2),
        Partial::new(MatrixName::M, 1, 2, 4, 3), Partial::new(MatrixName::M, 2, 1, 4, 3),
        Partial::new(MatrixName::M, 1, 1, 5, 27),
        Partial::new(MatrixName::M, 1, 2, 5, 29).negative(),
        Partial::new(MatrixName::M, 2, 1, 5, 29).negative(),
        Partial::new(MatrixName::M, 2, 2, 5, 28), Partial::new(MatrixName::M, 1, 1, 6, 28),
        Partial::new(MatrixName::M, 1, 2, 6, 29), Partial::new(MatrixName::M, 1, 3, 6, 61),
        Partial::new(MatrixName::M, 2, 1, 6, 29), Partial::new(MatrixName::M, 2, 2, 6, 27),
        Partial::new(MatrixName::M, 2, 3, 6, 63), Partial::new(MatrixName::M, 3, 1, 6, 61),
        Partial::new(MatrixName::M, 3, 2, 6, 63), Partial::new(MatrixName::M, 3, 3, 6, 2),
        Partial::new(MatrixName::C1, 1, 2, 7, 5).negative(),
        Partial::new(MatrixName::C1, 1, 3, 7, 30).negative(),
        Partial::new(MatrixName::C1, 2, 1, 7, 5),
        Partial::new(MatrixName::C1, 2, 3, 7, 32),
        Partial::new(MatrixName::C1, 3, 1, 7, 30),
        Partial::new(MatrixName::C1, 3, 2, 7, 32).negative(),
        Partial::new(MatrixName::C1, 1, 2, 8, 6).negative(),
        Partial::new(MatrixName::C1, 2, 1, 8, 6), Partial::new(MatrixName::M, 0, 1, 9, 37),
        Partial::new(MatrixName::M, 0, 2, 9, 38), Partial::new(MatrixName::M, 1, 0, 9, 37),
        Partial::new(MatrixName::M, 1, 1, 9, 72).negative(),
        Partial::new(MatrixName::M, 1, 2, 9, 65), Partial::new(MatrixName::M, 1, 3, 9, 82),
        Partial::new(MatrixName::M, 2, 0, 9, 38), Partial::new(MatrixName::M, 2, 1, 9, 65),
        Partial::new(MatrixName::M, 2, 2, 9, 67), Partial::new(MatrixName::M, 2, 3, 9, 83),
        Partial::new(MatrixName::M, 3, 1, 9, 82), Partial::new(MatrixName::M, 3, 2, 9, 83),
        Partial::new(MatrixName::C0, 5, 1, 9, 51).negative(),
        Partial::new(MatrixName::C1, 1, 1, 9, 37),
        Partial::new(MatrixName::C1, 2, 1, 9, 38),
        Partial::new(MatrixName::Kc, 1, 5, 9, 51),
        Partial::new(MatrixName::K0, 2, 2, 9, 38).negative(),
        Partial::new(MatrixName::C0, 4, 1, 10, 10),
        Partial::new(MatrixName::Kc, 1, 4, 10, 10).negative(),
        Partial::new(MatrixName::M, 0, 1, 11, 37), Partial::new(MatrixName::M, 0, 2, 11, 38),
        Partial::new(MatrixName::M, 0, 3, 11, 75), Partial::new(MatrixName::M, 1, 0, 11, 37),
        Partial::new(MatrixName::M, 1, 1, 11, 72).negative(),
        Partial::new(MatrixName::M, 1, 2, 11, 65),
        Partial::new(MatrixName::M, 1, 3, 11, 79).negative(),
        Partial::new(MatrixName::M, 2, 0, 11, 38), Partial::new(MatrixName::M, 2, 1, 11, 65),
        Partial::new(MatrixName::M, 2, 2, 11, 67), Partial::new(MatrixName::M, 2, 3, 11, 81),
        Partial::new(MatrixName::M, 3, 0, 11, 75),
        Partial::new(MatrixName::M, 3, 1, 11, 79).negative(),
        Partial::new(MatrixName::M, 3, 2, 11, 81),
        Partial::new(MatrixName::M, 3, 3, 11, 59).negative(),
        Partial::new(MatrixName::C1, 1, 1, 11, 37),
        Partial::new(MatrixName::C1, 2, 1, 11, 38),
        Partial::new(MatrixName::C1, 3, 1, 11, 75),
        Partial::new(MatrixName::K0, 2, 2, 11, 38).negative(),
        Partial::new(MatrixName::K0, 2, 3, 11, 76).negative(),
        Partial::new(MatrixName::K0, 3, 2, 11, 76).negative(),
        Partial::new(MatrixName::K0, 3, 3, 11, 77).negative(),
        Partial::new(MatrixName::M, 0, 1, 12, 38).negative(),
        Partial::new(MatrixName::M, 0, 2, 12, 37),
        Partial::new(MatrixName::M, 1, 0, 12, 38).negative(),
        Partial::new(MatrixName::M, 1, 1, 12, 66),
        Partial::new(MatrixName::M, 1, 2, 12, 71).negative(),
        Partial::new(MatrixName::M, 1, 3, 12, 80),
        Partial::new(MatrixName::M, 2, 0, 12, 37),
        Partial::new(MatrixName::M, 2, 1, 12, 71).negative(),
        Partial::new(MatrixName::M, 2, 2, 12, 52),
        Partial::new(MatrixName::M, 2, 3, 12, 78).negative(),
        Partial::new(MatrixName::M, 3, 1, 12, 80),
        Partial::new(MatrixName::M, 3, 2, 12, 78).negative(),
        Partial::new(MatrixName::C1, 1, 1, 12, 38).negative(),
        Partial::new(MatrixName::C1, 2, 1, 12, 37),
        Partial::new(MatrixName::K0, 2, 2, 12, 37).negative(),
        Partial::new(MatrixName::M, 0, 2, 13, 0), Partial::new(MatrixName::M, 2, 0, 13, 0),
        Partial::new(MatrixName::M, 2, 2, 13, 8), Partial::new(MatrixName::C1, 2, 1, 13, 0),
        Partial::new(MatrixName::K0, 2, 2, 13, 0).negative(),
        Partial::new(MatrixName::C1, 1, 2, 14, 22),
        Partial::new(MatrixName::C1, 1, 3, 14, 42),
        Partial::new(MatrixName::C1, 2, 1, 14, 22).negative(),
        Partial::new(MatrixName::C1, 2, 3, 14, 33).negative(),
        Partial::new(MatrixName::C1, 3, 1, 14, 42).negative(),
        Partial::new(MatrixName::C1, 3, 2, 14, 33),
        Partial::new(MatrixName::C1, 1, 2, 15, 15),
        Partial::new(MatrixName::C1, 2, 1, 15, 15).negative(),
        Partial::new(MatrixName::C0, 5, 1, 16, 51),
        Partial::new(MatrixName::C0, 5, 3, 16, 12),
        Partial::new(MatrixName::Kc, 1, 5, 16, 51).negative(),
        Partial::new(MatrixName::Kc, 3, 5, 16, 12).negative(),
        Partial::new(MatrixName::K0, 2, 3, 16, 23).negative(),
        Partial::new(MatrixName::K0, 3, 2, 16, 23).negative(),
        Partial::new(MatrixName::K0, 3, 3, 16, 34).negative(),
        Partial::new(MatrixName::M, 0, 1, 17, 45).negative(),
        Partial::new(MatrixName::M, 0, 2, 17, 44).negative(),
        Partial::new(MatrixName::M, 1, 0, 17, 45).negative(),
        Partial::new(MatrixName::M, 1, 1, 17, 60),
        Partial::new(MatrixName::M, 1, 2, 17, 58),
        Partial::new(MatrixName::M, 1, 3, 17, 64),
        Partial::new(MatrixName::M, 2, 0, 17, 44).negative(),
        Partial::new(MatrixName::M, 2, 1, 17, 58),
        Partial::new(MatrixName::M, 2, 2, 17, 60).negative(),
        Partial::new(MatrixName::M, 2, 3, 17, 62),
        Partial::new(MatrixName::M, 3, 1, 17, 64),
        Partial::new(MatrixName::M, 3, 2, 17, 62),
        Partial::new(MatrixName::C0, 5, 1, 17, 57).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 45).negative(),
        Partial::new(MatrixName::C1, 1, 3, 17, 31).negative(),
        Partial::new(MatrixName::C1, 2, 1, 17, 44).negative(),
        Partial::new(MatrixName::C1, 2, 3, 17, 43).negative(),
        Partial::new(MatrixName::C1, 3, 1, 17, 31), Partial::new(MatrixName::C1, 3, 2, 17, 43),
        Partial::new(MatrixName::Kc, 1, 5, 17, 57), Partial::new(MatrixName::K0, 2, 2, 17, 44),
        Partial::new(MatrixName::K0, 3, 3, 17, 73), Partial::new(MatrixName::K1, 5, 3, 17, 40),
        Partial::new(MatrixName::C0, 5, 0, 18, 4).negative(),
        Partial::new(MatrixName::C0, 5, 1, 18, 50).negative(),
        Partial::new(MatrixName::C0, 5, 3, 18, 9), Partial::new(MatrixName::C0, 5, 5, 18, 4),
        Partial::new(MatrixName::Kc, 0, 5, 18, 4), Partial::new(MatrixName::Kc, 1, 5, 18, 50),
        Partial::new(MatrixName::Kc, 3, 5, 18, 9).negative(),
        Partial::new(MatrixName::K1, 5, 3, 18, 35), Partial::new(MatrixName::K1, 5, 5, 18, 13),
        Partial::new(MatrixName::K1, 5, 2, 19, 4), Partial::new(MatrixName::K1, 5, 3, 19, 39),
        Partial::new(MatrixName::C0, 4, 0, 20, 4).negative(),
        Partial::new(MatrixName::C0, 4, 1, 20, 11),
        Partial::new(MatrixName::C0, 4, 4, 20, 4),
        Partial::new(MatrixName::Kc, 0, 4, 20, 4),
        Partial::new(MatrixName::Kc, 1, 4, 20, 11).negative(),
        Partial::new(MatrixName::K1, 4, 4, 20, 13), Partial::new(MatrixName::K1, 4, 2, 21, 4),
        Partial::new(MatrixName::C0, 3, 3, 22, 2), Partial::new(MatrixName::C0, 4, 0, 23, 17),
        Partial::new(MatrixName::C0, 4, 1, 23, 18).negative(),
        Partial::new(MatrixName::C0, 4, 4, 23, 17).negative(),
        Partial::new(MatrixName::C0, 5, 0, 23, 16),
        Partial::new(MatrixName::C0, 5, 1, 23, 53),
        Partial::new(MatrixName::C0, 5, 3, 23, 19).negative(),
        Partial::new(MatrixName::C0, 5, 5, 23, 16).negative(),
        Partial::new(MatrixName::Kc, 0, 4, 23, 17).negative(),
        Partial::new(MatrixName::Kc, 0, 5, 23, 16).negative(),
        Partial::new(MatrixName::Kc, 1, 4, 23, 18),
        Partial::new(MatrixName::Kc, 1, 5, 23, 53).negative(),
        Partial::new(MatrixName::Kc, 3, 5, 23, 19),
        Partial::new(MatrixName::K1, 4, 2, 23, 14).negative(),
        Partial::new(MatrixName::K1, 4, 4, 23, 24).negative(),
        Partial::new(MatrixName::K1, 5, 2, 23, 21).negative(),
        Partial::new(MatrixName::K1, 5, 3, 23, 46).negative(),
        Partial::new(MatrixName::K1, 5, 5, 23, 25).negative(),
        Partial::new(MatrixName::K0, 2, 3, 24, 20).negative(),
        Partial::new(MatrixName::K0, 3, 2, 24, 20).negative(),
        Partial::new(MatrixName::K0, 3, 3, 24, 36).negative(),
        Partial::new(MatrixName::K0, 2, 3, 25, 74),
        Partial::new(MatrixName::K0, 3, 2, 25, 74),
        Partial::new(MatrixName::K0, 3, 3, 25, 84),
    ];
}
