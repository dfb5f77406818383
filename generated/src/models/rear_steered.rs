// @generated from generated/models/rear_steered.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 55b70df1229c7642

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A bicycle that is steered at the rear: a Whipple bicycle run backwards, with its geometry mirrored.
///
/// Four rigid bodies (front wheel F, main frame with a rigid rider B, steered frame H, steered rear wheel R),
/// laterally symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the front
/// contact point, x forward, y to the right, z down. Lengths along x are counted backward from the front contact, so
/// that the parameters of a bicycle are those of the same bicycle run backwards.
///
/// Source: Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3
///
/// Derived from a mechanism: body `B` (main frame and rider), body `H` (steered frame), wheel `F` (front wheel), wheel `R` (rear wheel).
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
/// yaw_by_delta = c*cos(lam)/w [1]
/// yaw_per_v_delta = -cos(lam)/w [1/m]
/// Jxx_delta = IHxx + IFxx + zH^2*mH + rF^2*mF [kg*m^2]
/// Jxz_delta = c*rF*mF - zH*mH*(w + c - xH) - IHxz [kg*m^2]
/// Jzz_delta = mH*(w + c - xH)^2 + IHzz + IFxx + c^2*mF [kg*m^2]
/// Sx_delta = c*mF + mH*(w + c - xH) [kg*m]
/// Sz_delta = zH*mH - rF*mF [kg*m]
/// py_delta = Sx_delta*cos(lam) + Sz_delta*sin(lam) [kg*m]
/// hx_delta = Jxz_delta*cos(lam) - Jxx_delta*sin(lam) [kg*m^2]
/// hz_delta = Jzz_delta*cos(lam) - Jxz_delta*sin(lam) [kg*m^2]
/// Jxx_all = IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB [kg*m^2]
/// Jxz_all = xB*zB*mB + Jxz_delta + Sz_delta*(w + c) - IBxz [kg*m^2]
/// Jzz_all = IRxx + IBzz + IHzz + IFxx + w^2*mF + xB^2*mB + xH^2*mH [kg*m^2]
/// Sx_all = -(w*mF + xB*mB + xH*mH) [kg*m]
/// Sz_all = zB*mB + Sz_delta - rR*mR [kg*m]
/// load_spin_R = Sx_all/w [kg]
/// h_spin_F = IRyy/rR [kg*m]
/// h_spin_R = IFyy/rF [kg*m]
/// h_wheels_all = h_spin_F + h_spin_R [kg*m]
/// M_yaw_delta = hz_delta - py_delta*(w + c) [kg*m^2]
/// M_delta_delta = hz_delta*cos(lam) - hx_delta*sin(lam) [kg*m^2]
/// K_phi_delta = -(c*load_spin_R*cos(lam) + py_delta) [kg*m]
/// K_delta_delta = (c*load_spin_R*cos(lam) + py_delta)*sin(lam) [kg*m]
/// P_delta_lateral = yaw_by_delta*Sx_all + py_delta [kg*m]
/// P_delta_yaw = yaw_by_delta*Jzz_all + M_yaw_delta [kg*m^2]
/// P_delta_delta = yaw_by_delta*M_yaw_delta + M_delta_delta [kg*m^2]
/// M_11 = Jxx_all [kg*m^2]
/// M_12 = M_21 = yaw_by_delta*Jxz_all + hx_delta [kg*m^2]
/// M_22 = yaw_by_delta*P_delta_yaw + P_delta_delta [kg*m^2]
/// C1_12 = yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_R*cos(lam) [kg*m]
/// C1_21 = -(yaw_by_delta*h_wheels_all + h_spin_R*cos(lam)) [kg*m]
/// C1_22 = yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
/// K0_11 = Sz_all [kg*m]
/// K0_12 = K0_21 = K_phi_delta [kg*m]
/// K0_22 = K_delta_delta [kg*m]
/// K2_12 = yaw_per_v_delta*(h_wheels_all - Sz_all) [kg]
/// K2_22 = yaw_per_v_delta*(P_delta_lateral - h_spin_R*sin(lam)) [kg]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct RearSteered<T = f64> {
    /// Wheel base.
    ///
    /// `w` in `m`: `> 0`.
    pub w: T,
    /// Distance by which the steer axis meets the ground behind the contact of the steered wheel.
    ///
    /// `c` in `m`: any finite value.
    pub c: T,
    /// Steer axis tilt: from the ground upward the axis leans forward by this angle.
    ///
    /// `lam`, λ, in `rad`: `> -1.5707963267948966 and < 1.5707963267948966`.
    pub lam: T,
    /// Gravitational field strength.
    ///
    /// `g` in `N/kg`: `>= 0`.
    pub g: T,
    /// Radius of the front wheel.
    ///
    /// `rR` in `m`: `> 0`.
    pub rR: T,
    /// Mass of the front wheel.
    ///
    /// `mR` in `kg`: `>= 0`.
    pub mR: T,
    /// Radial moment of inertia of the front wheel; by symmetry also about the vertical.
    ///
    /// `IRxx` in `kg*m^2`: `>= 0`.
    pub IRxx: T,
    /// Axial moment of inertia of the front wheel.
    ///
    /// `IRyy` in `kg*m^2`: `>= 0`.
    pub IRyy: T,
    /// Centre of mass of the main frame and rider, behind the front contact.
    ///
    /// `xB` in `m`: any finite value.
    pub xB: T,
    /// Centre of mass of the main frame and rider, downward.
    ///
    /// `zB` in `m`: any finite value.
    pub zB: T,
    /// Mass of the main frame and rider.
    ///
    /// `mB` in `kg`: `>= 0`.
    pub mB: T,
    /// Moment of inertia of the main frame and rider about its centre of mass, in roll.
    ///
    /// `IBxx` in `kg*m^2`: `>= 0`.
    pub IBxx: T,
    /// Moment of inertia of the main frame and rider about its centre of mass, in pitch.
    ///
    /// `IByy` in `kg*m^2`: `>= 0`. No matrix depends on it.
    pub IByy: T,
    /// Moment of inertia of the main frame and rider about its centre of mass, in yaw.
    ///
    /// `IBzz` in `kg*m^2`: `>= 0`.
    pub IBzz: T,
    /// Product of inertia of the main frame and rider about its centre of mass.
    ///
    /// `IBxz` in `kg*m^2`: any finite value.
    pub IBxz: T,
    /// Centre of mass of the steered frame, behind the front contact.
    ///
    /// `xH` in `m`: any finite value.
    pub xH: T,
    /// Centre of mass of the steered frame, downward.
    ///
    /// `zH` in `m`: any finite value.
    pub zH: T,
    /// Mass of the steered frame.
    ///
    /// `mH` in `kg`: `>= 0`.
    pub mH: T,
    /// Moment of inertia of the steered frame about its centre of mass, in roll.
    ///
    /// `IHxx` in `kg*m^2`: `>= 0`.
    pub IHxx: T,
    /// Moment of inertia of the steered frame about its centre of mass, in pitch.
    ///
    /// `IHyy` in `kg*m^2`: `>= 0`. No matrix depends on it.
    pub IHyy: T,
    /// Moment of inertia of the steered frame about its centre of mass, in yaw.
    ///
    /// `IHzz` in `kg*m^2`: `>= 0`.
    pub IHzz: T,
    /// Product of inertia of the steered frame about its centre of mass.
    ///
    /// `IHxz` in `kg*m^2`: any finite value.
    pub IHxz: T,
    /// Radius of the rear wheel.
    ///
    /// `rF` in `m`: `> 0`.
    pub rF: T,
    /// Mass of the rear wheel.
    ///
    /// `mF` in `kg`: `>= 0`.
    pub mF: T,
    /// Radial moment of inertia of the rear wheel; by symmetry also about the vertical.
    ///
    /// `IFxx` in `kg*m^2`: `>= 0`.
    pub IFxx: T,
    /// Axial moment of inertia of the rear wheel.
    ///
    /// `IFyy` in `kg*m^2`: `>= 0`.
    pub IFyy: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`RearSteered`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RearSteeredMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 2>,
}

impl<T: Number> RearSteered<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 42 additions, 44 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 92 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> RearSteeredMatrices<T> {
        let t2 = self.rR * self.mR;
        let t6 = self.rF * self.mF;
        let ay_all1_delta = self.rF * t6 + (self.IHxx + self.IFxx);
        let t15 = self.zB * self.mB;
        let t19 = self.zH * self.mH;
        let M_11 = self.rR * t2 + ay_all1_delta
            + (self.zB * t15 + (self.zH * t19 + (self.IRxx + self.IBxx)));
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t31 = self.w.like(1.0) / self.w;
        let t32 = cos_lam * t31;
        let yaw_by_delta = self.c * t32;
        let t39 = t15 * self.xB - (self.IBxz + self.IHxz);
        let wz_delta2_delta = cos_lam + yaw_by_delta;
        let t50 = cos_lam * (self.c + self.w) - self.xH * wz_delta2_delta;
        let t51 = self.zH * sin_lam + t50;
        let t54 = t19 * t51 + sin_lam * ay_all1_delta;
        let t55 = sin_lam * self.IHxz;
        let t59 = t55 + wz_delta2_delta * (self.IFxx + self.IHzz);
        let t63 = self.mB * self.xB;
        let t68 = yaw_by_delta * (self.xB * t63 + (self.IRxx + self.IBzz));
        let t71 = self.mH * t51;
        let M_22 = wz_delta2_delta * (t55 + t59)
            + (sin_lam * t54 + yaw_by_delta * t68 + t71 * t50);
        let zero = self.w.like(0.0);
        let K0_11 = t15 - (t2 + (t6 - t19));
        let t85 = cos_lam * (t31 * (t19 * self.xH + (self.c * K0_11 + t39)) - t6);
        let h_spin_R = self.IFyy / self.rF;
        let t90 = self.IRyy / self.rR;
        let t92 = wz_delta2_delta * h_spin_R + yaw_by_delta * t90;
        let C1_12 = t92 - t85;
        let t94 = t6 * sin_lam;
        let t96 = yaw_by_delta * t63 + t94;
        let t97 = t71 - t96;
        let t104 = t31 * (self.c * t97 + (self.xH * t71 - t68) - t59) - t94;
        let C1_22 = cos_lam * t104;
        let K0_22 = sin_lam * t97;
        let K2_12 = t32 * (K0_11 - t90 - h_spin_R);
        let K2_22 = t32 * (sin_lam * h_spin_R - t97);
        let M_12 = yaw_by_delta * t39 - cos_lam * self.IHxz - t54;
        let C1_21 = -t92;
        let K0_12 = t96 - t71;
        RearSteeredMatrices::from_entries([
            M_11, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, K0_11, K0_12, K0_12, K0_22, zero,
            K2_12, zero, K2_22,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`RearSteered`] that follow from its coordinates q = (`phi`, `delta`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RearSteeredKinematics<T = f64> {
    /// Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin.
    pub lateral: Rate<T, 2>,
    /// Yaw rate, to the right, in `rad/s`: of `B`.
    pub yaw: Rate<T, 2>,
    /// Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_F: Rate<T, 2>,
    /// Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_R: Rate<T, 2>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate,
    /// a column for each of `Tphi` (lean torque) in `N*m`, `Tdelta` (steer torque) in `N*m`.
    pub forces: [[T; 2]; 2],
}

impl<T: Scalar> RearSteered<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 3 negations and 1 trigonometric function: 8 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> RearSteeredKinematics<T> {
        let zero = self.w.like(0.0);
        let t6 = self.lam.cos() / self.w;
        let yaw_by_delta = self.c * t6;
        let t12 = -t6;
        let t13 = -(self.w.like(1.0) / self.rR);
        let t14 = -(self.w.like(1.0) / self.rF);
        RearSteeredKinematics {
            lateral: Rate {
                speed: zero, rates: [zero, zero], coordinates: [zero, zero],
                heading: self.w.like(1.0),
            },
            yaw: Rate {
                speed: zero, rates: [zero, yaw_by_delta], coordinates: [zero, t12], heading: zero,
            },
            wheel_F: Rate {
                speed: t13, rates: [zero, zero], coordinates: [zero, zero], heading: zero,
            },
            wheel_R: Rate {
                speed: t14, rates: [zero, zero], coordinates: [zero, zero], heading: zero,
            },
            forces: [[self.w.like(1.0), zero], [zero, self.w.like(1.0)]],
        }
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`RearSteered`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RearSteeredDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 123],
}

impl<T: Number> RearSteered<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 93 additions, 175 multiplications, 3 divisions, 5 negations and 2 trigonometric functions: 278 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (RearSteeredMatrices<T>, RearSteeredDerivatives<T>) {
        let zero = self.w.like(0.0);
        let mut matrices = RearSteeredMatrices::from_entries([zero; 16]);
        let mut derivatives = RearSteeredDerivatives {
            values: [zero; 123],
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
        matrices: &mut RearSteeredMatrices<T>,
        derivatives: &mut RearSteeredDerivatives<T>,
    ) {
        *matrices = RearSteeredMatrices::from_entries([self.w.like(0.0); 16]);
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
        put_derivative(0, self.rR);
        put_derivative(1, self.mR);
        put_derivative(2, self.zB);
        put_derivative(3, self.mB);
        put_derivative(4, self.zH);
        put_derivative(5, self.mH);
        put_derivative(6, self.rF);
        put_derivative(7, self.mF);
        put_derivative(8, self.w.like(1.0));
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        put_derivative(9, sin_lam);
        let M_11_mH = self.zH * self.zH;
        put_derivative(10, M_11_mH);
        let ay_all1_delta_mF = self.rF * self.rF;
        put_derivative(11, ay_all1_delta_mF);
        let t31 = self.IHxx + self.IFxx + self.mF * ay_all1_delta_mF;
        let M_11_mB = self.zB * self.zB;
        put_derivative(12, M_11_mB);
        let M_11_mR = self.rR * self.rR;
        put_derivative(13, M_11_mR);
        let t34 = self.mB * self.xB;
        let t37 = self.zB * t34 - self.IHxz - self.IBxz;
        let M_11 = self.mH * M_11_mH + self.IRxx + self.IBxx + t31 + self.mB * M_11_mB
            + self.mR * M_11_mR;
        put_entry(0, M_11);
        let t46 = self.w.like(1.0) / self.w;
        let t47 = self.IFxx + self.IHzz;
        let t50 = self.IRxx + self.IBzz + self.xB * t34;
        let t51 = self.c * t46;
        let t52 = self.w.like(1.0) / self.rF;
        let t53 = self.w.like(1.0) / self.rR;
        let t54 = self.mB * self.zB;
        let M_11_zB = t54 + t54;
        put_derivative(14, M_11_zB);
        let t56 = self.mF * self.rF;
        let ay_all1_delta_rF = t56 + t56;
        put_derivative(15, ay_all1_delta_rF);
        let h_spin_R = self.IFyy * t52;
        let t59 = self.IRyy * t53;
        let t60 = self.mH * self.zH;
        let M_11_zH = t60 + t60;
        put_derivative(16, M_11_zH);
        let t62 = self.xH * t51;
        let t63 = self.mR * self.rR;
        let M_11_rR = t63 + t63;
        put_derivative(17, M_11_rR);
        let K0_11 = t54 - (t56 + t63 - t60);
        put_entry(6, K0_11);
        let t68 = h_spin_R + t59;
        let t70 = t37 + self.xH * t60;
        let t73 = self.c + self.w - self.xH - t62;
        let t74 = t56 + h_spin_R;
        let t75 = self.c + self.xH;
        let t76 = self.xB + self.c;
        let t78 = self.mF - t52 * h_spin_R;
        let t79 = t51 * t68;
        let t80 = t68 - K0_11;
        let C1_12_IBxz = cos_lam * t46;
        put_derivative(18, C1_12_IBxz);
        let t82 = self.zH * sin_lam;
        let t83 = self.IHxz * cos_lam;
        let t84 = self.IHxz * sin_lam;
        let t85 = cos_lam * t74;
        let t86 = sin_lam * t74;
        let ay_all1_delta = sin_lam * t56;
        let t88 = cos_lam * t56;
        let t89 = h_spin_R + t79;
        let t90 = self.mH * cos_lam;
        let t92 = t70 - self.c * t80;
        let t93 = cos_lam + cos_lam;
        let t94 = cos_lam * t60;
        let C1_21_w = C1_12_IBxz * t79;
        put_derivative(19, C1_21_w);
        let M_12_c = C1_12_IBxz * t70 - t94;
        put_derivative(20, M_12_c);
        let t98 = C1_12_IBxz * t68;
        put_derivative(21, t98);
        let C1_21_lam = sin_lam * t89;
        put_derivative(22, C1_21_lam);
        let C1_21 = -(cos_lam * t89);
        put_entry(4, C1_21);
        let t102 = self.rR * C1_12_IBxz;
        put_derivative(23, t102);
        let t103 = C1_12_IBxz * t53;
        put_derivative(24, t103);
        let t104 = C1_12_IBxz * t54;
        put_derivative(25, t104);
        let t105 = t46 * t94;
        put_derivative(26, t105);
        let t106 = ay_all1_delta + ay_all1_delta;
        put_derivative(27, t106);
        let t107 = self.rF * C1_12_IBxz;
        put_derivative(28, t107);
        let yaw_by_delta = self.c * C1_12_IBxz;
        put_derivative(29, yaw_by_delta);
        let M_12_xB = yaw_by_delta * t54;
        put_derivative(30, M_12_xB);
        let C1_12_mR = self.rR * yaw_by_delta;
        put_derivative(31, C1_12_mR);
        let t111 = t37 * yaw_by_delta;
        let t113 = cos_lam * t73 + t82;
        put_derivative(32, t113);
        let wz_delta2_delta = cos_lam + yaw_by_delta;
        put_derivative(33, wz_delta2_delta);
        let M_12_xH = wz_delta2_delta * t60;
        put_derivative(34, M_12_xH);
        let C1_12_rF = wz_delta2_delta * t78;
        put_derivative(35, C1_12_rF);
        let t117 = C1_12_IBxz * t78;
        put_derivative(36, t117);
        let K2_22_rF = sin_lam * t117;
        put_derivative(37, K2_22_rF);
        let C1_12_mF = self.rF * wz_delta2_delta;
        put_derivative(38, C1_12_mF);
        let t121 = t84 + t47 * wz_delta2_delta;
        let t123 = self.mH * (t82 + t113);
        put_derivative(39, t123);
        let M_22_mH = t113 * t113;
        put_derivative(40, M_22_mH);
        let K0_22_mH = sin_lam * t113;
        put_derivative(41, K0_22_mH);
        let t126 = self.zH * t113;
        put_derivative(42, t126);
        let t127 = self.mH * t113;
        let t128 = C1_12_IBxz * t92;
        let C1_12 = t85 - t128;
        put_entry(3, C1_12);
        let C1_12_w = t46 * t128;
        put_derivative(43, C1_12_w);
        let t134 = t31 * sin_lam + self.mH * t126 + t83;
        let t136 = t121 + yaw_by_delta * t50;
        let M_12_zB = t34 * yaw_by_delta;
        put_derivative(44, M_12_zB);
        let t140 = M_12_zB + C1_12_IBxz * (t47 + t50);
        let t141 = M_12_zB - t127;
        let K0_12 = ay_all1_delta + t141;
        put_entry(7, K0_12);
        let t144 = t46 * (t141 + t86);
        let C1_12_c = C1_12_IBxz * t80;
        put_derivative(45, C1_12_c);
        let K2_12_w = t46 * C1_12_c;
        put_derivative(46, K2_12_w);
        let K2_12 = -C1_12_c;
        put_entry(9, K2_12);
        let K2_12_zH = self.mH * C1_12_IBxz;
        put_derivative(47, K2_12_zH);
        let t150 = t62 * K2_12_zH + t90;
        let t153 = K2_12_zH * (wz_delta2_delta * t75 - t113);
        put_derivative(48, t153);
        let t154 = C1_12_IBxz * t113;
        put_derivative(49, t154);
        let C1_22_mH = t75 * t154;
        put_derivative(50, C1_22_mH);
        let t159 = t121 + t73 * t127 + t51 * t136;
        let t162 = t46 * (t136 - self.xH * t127);
        let M_12 = t111 - t134;
        put_entry(1, M_12);
        let t166 = self.zH * t150 + t46 * t111;
        put_derivative(51, t166);
        let t168 = t134 + t51 * t83;
        let K2_22 = cos_lam * t144;
        put_entry(10, K2_22);
        let t171 = t150 + t46 * M_12_zB;
        put_derivative(52, t171);
        let t172 = t46 * sin_lam;
        let C1_12_lam = t92 * t172 - t86;
        put_derivative(53, C1_12_lam);
        let K2_12_lam = t80 * t172;
        put_derivative(54, K2_12_lam);
        let K0_22_w = sin_lam * t171;
        put_derivative(55, K0_22_w);
        let t178 = C1_12_IBxz * (t144 + t171);
        put_derivative(56, t178);
        let K2_22_h_spin_R = cos_lam * t172;
        put_derivative(57, K2_22_h_spin_R);
        let t180 = self.c * t172;
        let K0_22 = -(sin_lam * K0_12);
        put_entry(8, K0_22);
        let t183 = t51 * t140;
        let t185 = t90 - self.xH * K2_12_zH;
        let C1_22_c = C1_12_IBxz * (t75 * t185 - K0_12 - t140);
        put_derivative(58, C1_22_c);
        let M_22 = cos_lam * t159 + sin_lam * t168;
        put_entry(2, M_22);
        let t195 = (t51 * t162 - t127) * t93;
        put_derivative(59, t195);
        let M_22_c = t93 * (t127 + t162);
        put_derivative(60, M_22_c);
        let t199 = t162 + t51 * K0_12;
        let K0_12_xH = t90 + t51 * t90;
        put_derivative(61, K0_12_xH);
        let t202 = sin_lam * K0_12_xH;
        put_derivative(62, t202);
        let t203 = K2_12_zH * t75;
        put_derivative(63, t203);
        let C1_22_zH = sin_lam * t203;
        put_derivative(64, C1_22_zH);
        let C1_22_w = C1_12_IBxz * (t199 + t150 * t75 + t183);
        put_derivative(65, C1_22_w);
        let t209 = ay_all1_delta + t199;
        let K2_12_zB = self.mB * C1_12_IBxz;
        put_derivative(66, K2_12_zB);
        let t211 = self.xB * K2_12_zB;
        let K0_12_c = t211 - t185;
        put_derivative(67, K0_12_c);
        let t213 = t185 - t211;
        let t214 = self.mH * sin_lam;
        put_derivative(68, t214);
        let M_22_yaw_by_delta = t94 - t73 * t214;
        let t217 = C1_12_IBxz * t214;
        put_derivative(69, t217);
        let K0_22_c = sin_lam * t213;
        put_derivative(70, K0_22_c);
        let t219 = C1_12_IBxz * t213;
        put_derivative(71, t219);
        let C1_22 = -(cos_lam * t209);
        put_entry(5, C1_22);
        let C1_22_lam = sin_lam * (t209 + t183 + C1_12_IBxz * t47)
            + C1_12_IBxz * (t75 * M_22_yaw_by_delta - t83) - wz_delta2_delta * t88;
        put_derivative(72, C1_22_lam);
        let M_12_lam = t84 - t31 * cos_lam - t37 * t180 - self.zH * M_22_yaw_by_delta;
        put_derivative(73, M_12_lam);
        let t239 = M_22_yaw_by_delta + t34 * t180;
        let t240 = sin_lam + sin_lam;
        let M_22_lam = t168 * t93 - t159 * t240;
        put_derivative(74, M_22_lam);
        let t247 = sin_lam * t144 + C1_12_IBxz * (t239 - t85);
        put_derivative(75, t247);
        let K0_12_lam = t88 - t239;
        put_derivative(76, K0_12_lam);
        let M_22_rF = ay_all1_delta * t240;
        put_derivative(77, M_22_rF);
        let M_22_zH = t127 * t240;
        put_derivative(78, M_22_zH);
        let M_22_IHxz = wz_delta2_delta * t240;
        put_derivative(79, M_22_IHxz);
        let K0_22_lam = -(cos_lam * K0_12 + sin_lam * K0_12_lam);
        put_derivative(80, K0_22_lam);
        let t256 = wz_delta2_delta * t127;
        let t257 = t256 + t256;
        put_derivative(81, t257);
        let t260 = C1_12_IBxz * (self.mR - t53 * t59);
        put_derivative(82, t260);
        let C1_12_IRyy = yaw_by_delta * t53;
        put_derivative(83, C1_12_IRyy);
        let C1_21_rR = t59 * C1_12_IRyy;
        put_derivative(84, C1_21_rR);
        let t263 = C1_12_IBxz * yaw_by_delta;
        put_derivative(85, t263);
        let M_22_IRxx = self.c * t263;
        put_derivative(86, M_22_IRxx);
        let K2_22_xB = self.mB * t263;
        put_derivative(87, K2_22_xB);
        let C1_12_rR = self.c * t260;
        put_derivative(88, C1_12_rR);
        let K2_22_mB = self.xB * t263;
        put_derivative(89, K2_22_mB);
        let t268 = t76 * K2_22_mB;
        put_derivative(90, t268);
        let K0_12_xB = self.mB * yaw_by_delta;
        put_derivative(91, K0_12_xB);
        let t270 = sin_lam * K0_12_xB;
        put_derivative(92, t270);
        let K0_12_mB = self.xB * yaw_by_delta;
        put_derivative(93, K0_12_mB);
        let M_12_mB = self.zB * K0_12_mB;
        put_derivative(94, M_12_mB);
        let M_22_mB = K0_12_mB * K0_12_mB;
        put_derivative(95, M_22_mB);
        let t274 = sin_lam * K0_12_mB;
        put_derivative(96, t274);
        let t275 = K0_12_xB * K0_12_mB;
        let M_22_xB = t275 + t275;
        put_derivative(97, M_22_xB);
        let t277 = t211 + K0_12_xB;
        put_derivative(98, t277);
        let t279 = yaw_by_delta * (t211 + t277);
        put_derivative(99, t279);
        let K2_12_mB = self.zB * C1_12_IBxz;
        put_derivative(100, K2_12_mB);
        let t281 = t76 * K2_12_mB;
        put_derivative(101, t281);
        let t282 = C1_12_IBxz * wz_delta2_delta;
        put_derivative(102, t282);
        let K2_22_xH = self.mH * t282;
        put_derivative(103, K2_22_xH);
        let M_22_ay_all1_delta = sin_lam * sin_lam;
        put_derivative(104, M_22_ay_all1_delta);
        let M_22_mF = ay_all1_delta_mF * M_22_ay_all1_delta;
        put_derivative(105, M_22_mF);
        let K0_22_zH = self.mH * M_22_ay_all1_delta;
        put_derivative(106, K0_22_zH);
        let K2_12_mH = self.zH * C1_12_IBxz;
        put_derivative(107, K2_12_mH);
        let t288 = t75 * K2_12_mH;
        put_derivative(108, t288);
        let M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
        put_derivative(109, M_22_IHzz);
        let M_22_IFxx = M_22_ay_all1_delta + M_22_IHzz;
        put_derivative(110, M_22_IFxx);
        let C1_12_IFyy = wz_delta2_delta * t52;
        put_derivative(111, C1_12_IFyy);
        let C1_21_rF = h_spin_R * C1_12_IFyy;
        put_derivative(112, C1_21_rF);
        let K0_12_rF = self.mF * sin_lam;
        put_derivative(113, K0_12_rF);
        let t294 = wz_delta2_delta * K0_12_rF;
        put_derivative(114, t294);
        let t295 = sin_lam * K0_12_rF;
        put_derivative(115, t295);
        let K0_12_mF = self.rF * sin_lam;
        put_derivative(116, K0_12_mF);
        let t297 = self.rF * K0_12_mF;
        put_derivative(117, t297);
        let t298 = wz_delta2_delta * K0_12_mF;
        put_derivative(118, t298);
        let t299 = sin_lam * K0_12_mF;
        put_derivative(119, t299);
        let K2_22_mF = C1_12_IBxz * K0_12_mF;
        put_derivative(120, K2_22_mF);
        let t301 = C1_12_IBxz * t52;
        put_derivative(121, t301);
        let K2_22_IFyy = sin_lam * t301;
        put_derivative(122, K2_22_IFyy);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl RearSteered<f64> {
    /// The parameter set `backwards`.
    ///
    /// Source: The benchmark of Meijaard et al. (2007), Table 1, run backwards
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
    pub const BACKWARDS: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3141592653589793, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.0603,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.05892, IHyy: 0.06, IHzz: 0.00708, IHxz: -0.00756,
        rF: 0.35, mF: 3.0, IFxx: 0.1405, IFyy: 0.28,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> RearSteered<T> {
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
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 26] {
        [
            self.w, self.c, self.lam, self.g, self.rR, self.mR, self.IRxx, self.IRyy, self.xB,
            self.zB, self.mB, self.IBxx, self.IByy, self.IBzz, self.IBxz, self.xH, self.zH, self.mH,
            self.IHxx, self.IHyy, self.IHzz, self.IHxz, self.rF, self.mF, self.IFxx, self.IFyy,
        ]
    }
}

impl<T: Scalar> RearSteered<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> RearSteered<U> {
        let values = self.to_array();
        RearSteered::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl RearSteered<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> RearSteered<f32> {
        RearSteered::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<RearSteered<f32>> for RearSteered<f64> {
    fn from(parameters: RearSteered<f32>) -> Self {
        RearSteered::cast(&parameters)
    }
}

impl<T: Number> RearSteeredMatrices<T> {
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

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 11] {
        [
            self.m[0][0], self.m[0][1], self.m[1][1], self.c1[0][1], self.c1[1][0], self.c1[1][1],
            self.k0[0][0], self.k0[0][1], self.k0[1][1], self.k2[0][1], self.k2[1][1],
        ]
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
                self.c1[0][1] = entry;
            }
            4 => {
                self.c1[1][0] = entry;
            }
            5 => {
                self.c1[1][1] = entry;
            }
            6 => {
                self.k0[0][0] = entry;
            }
            7 => {
                self.k0[0][1] = entry;
                self.k0[1][0] = entry;
            }
            8 => {
                self.k0[1][1] = entry;
            }
            9 => {
                self.k2[0][1] = entry;
            }
            10 => {
                self.k2[1][1] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, zeros, self.c1.0, zeros, self.k0.0, zeros, self.k2.0]
    }
}

impl<T: Scalar> From<RearSteeredMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: RearSteeredMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for RearSteered<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 26];

    type Over<U: Number> = RearSteered<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "RearSteered",
        docs: "A bicycle that is steered at the rear: a Whipple bicycle run backwards, with its geometry mirrored.\n\nFour rigid bodies (front wheel F, main frame with a rigid rider B, steered frame H, steered rear wheel R),\nlaterally symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the front\ncontact point, x forward, y to the right, z down. Lengths along x are counted backward from the front contact, so\nthat the parameters of a bicycle are those of the same bicycle run backwards.",
        source: "Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3",
        parameters: &[
            ParameterInfo::new("w", "m", Domain::POSITIVE).docs("Wheel base."),
            ParameterInfo::new("c", "m", Domain::FINITE)
                .docs("Distance by which the steer axis meets the ground behind the contact of the steered wheel."),
            ParameterInfo::new(
                    "lam",
                    "rad",
                    Domain::between(Bound::Open(-1.5707963267948966), Bound::Open(1.5707963267948966)),
                )
                .symbol("λ")
                .docs("Steer axis tilt: from the ground upward the axis leans forward by this angle."),
            ParameterInfo::new("g", "N/kg", Domain::NONNEGATIVE)
                .docs("Gravitational field strength."),
            ParameterInfo::new("rR", "m", Domain::POSITIVE)
                .docs("Radius of the front wheel."),
            ParameterInfo::new("mR", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the front wheel."),
            ParameterInfo::new("IRxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Radial moment of inertia of the front wheel; by symmetry also about the vertical."),
            ParameterInfo::new("IRyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Axial moment of inertia of the front wheel."),
            ParameterInfo::new("xB", "m", Domain::FINITE)
                .docs("Centre of mass of the main frame and rider, behind the front contact."),
            ParameterInfo::new("zB", "m", Domain::FINITE)
                .docs("Centre of mass of the main frame and rider, downward."),
            ParameterInfo::new("mB", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the main frame and rider."),
            ParameterInfo::new("IBxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the main frame and rider about its centre of mass, in roll."),
            ParameterInfo::new("IByy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the main frame and rider about its centre of mass, in pitch.")
                .unused(),
            ParameterInfo::new("IBzz", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the main frame and rider about its centre of mass, in yaw."),
            ParameterInfo::new("IBxz", "kg*m^2", Domain::FINITE)
                .docs("Product of inertia of the main frame and rider about its centre of mass."),
            ParameterInfo::new("xH", "m", Domain::FINITE)
                .docs("Centre of mass of the steered frame, behind the front contact."),
            ParameterInfo::new("zH", "m", Domain::FINITE)
                .docs("Centre of mass of the steered frame, downward."),
            ParameterInfo::new("mH", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the steered frame."),
            ParameterInfo::new("IHxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the steered frame about its centre of mass, in roll."),
            ParameterInfo::new("IHyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the steered frame about its centre of mass, in pitch.")
                .unused(),
            ParameterInfo::new("IHzz", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the steered frame about its centre of mass, in yaw."),
            ParameterInfo::new("IHxz", "kg*m^2", Domain::FINITE)
                .docs("Product of inertia of the steered frame about its centre of mass."),
            ParameterInfo::new("rF", "m", Domain::POSITIVE)
                .docs("Radius of the rear wheel."),
            ParameterInfo::new("mF", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the rear wheel."),
            ParameterInfo::new("IFxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Radial moment of inertia of the rear wheel; by symmetry also about the vertical."),
            ParameterInfo::new("IFyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Axial moment of inertia of the rear wheel."),
        ],
        coordinates: &[
            CoordinateInfo::new("phi", "rad")
                .label("lean")
                .docs("Lean of the main frame, positive to the right."),
            CoordinateInfo::new("delta", "rad")
                .label("steer")
                .docs("Steer of the steered frame relative to the main frame, positive to the right seen from above."),
        ],
        forces: &[
            carvallo::motion::AppliedInfo {
                name: "Tphi", label: "lean torque", unit: "N*m", position: "phi",
            },
            carvallo::motion::AppliedInfo {
                name: "Tdelta", label: "steer torque", unit: "N*m", position: "delta",
            },
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
                name: "backwards",
                docs: "",
                source: "The benchmark of Meijaard et al. (2007), Table 1, run backwards",
                values: &RearSteered::to_array(&RearSteered::<f64>::BACKWARDS),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("yaw_by_delta", "1", "c*cos(lam)/w"),
            FormulaInfo::definition("yaw_per_v_delta", "1/m", "-cos(lam)/w"),
            FormulaInfo::definition("Jxx_delta", "kg*m^2", "IHxx + IFxx + zH^2*mH + rF^2*mF"),
            FormulaInfo::definition("Jxz_delta", "kg*m^2", "c*rF*mF - zH*mH*(w + c - xH) - IHxz"),
            FormulaInfo::definition("Jzz_delta", "kg*m^2", "mH*(w + c - xH)^2 + IHzz + IFxx + c^2*mF"),
            FormulaInfo::definition("Sx_delta", "kg*m", "c*mF + mH*(w + c - xH)"),
            FormulaInfo::definition("Sz_delta", "kg*m", "zH*mH - rF*mF"),
            FormulaInfo::definition("py_delta", "kg*m", "Sx_delta*cos(lam) + Sz_delta*sin(lam)"),
            FormulaInfo::definition("hx_delta", "kg*m^2", "Jxz_delta*cos(lam) - Jxx_delta*sin(lam)"),
            FormulaInfo::definition("hz_delta", "kg*m^2", "Jzz_delta*cos(lam) - Jxz_delta*sin(lam)"),
            FormulaInfo::definition("Jxx_all", "kg*m^2", "IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB"),
            FormulaInfo::definition("Jxz_all", "kg*m^2", "xB*zB*mB + Jxz_delta + Sz_delta*(w + c) - IBxz"),
            FormulaInfo::definition("Jzz_all", "kg*m^2", "IRxx + IBzz + IHzz + IFxx + w^2*mF + xB^2*mB + xH^2*mH"),
            FormulaInfo::definition("Sx_all", "kg*m", "-(w*mF + xB*mB + xH*mH)"),
            FormulaInfo::definition("Sz_all", "kg*m", "zB*mB + Sz_delta - rR*mR"),
            FormulaInfo::definition("load_spin_R", "kg", "Sx_all/w"),
            FormulaInfo::definition("h_spin_F", "kg*m", "IRyy/rR"),
            FormulaInfo::definition("h_spin_R", "kg*m", "IFyy/rF"),
            FormulaInfo::definition("h_wheels_all", "kg*m", "h_spin_F + h_spin_R"),
            FormulaInfo::definition("M_yaw_delta", "kg*m^2", "hz_delta - py_delta*(w + c)"),
            FormulaInfo::definition("M_delta_delta", "kg*m^2", "hz_delta*cos(lam) - hx_delta*sin(lam)"),
            FormulaInfo::definition("K_phi_delta", "kg*m", "-(c*load_spin_R*cos(lam) + py_delta)"),
            FormulaInfo::definition("K_delta_delta", "kg*m", "(c*load_spin_R*cos(lam) + py_delta)*sin(lam)"),
            FormulaInfo::definition("P_delta_lateral", "kg*m", "yaw_by_delta*Sx_all + py_delta"),
            FormulaInfo::definition("P_delta_yaw", "kg*m^2", "yaw_by_delta*Jzz_all + M_yaw_delta"),
            FormulaInfo::definition("P_delta_delta", "kg*m^2", "yaw_by_delta*M_yaw_delta + M_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "Jxx_all"),
            FormulaInfo::entry(
                &[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)],
                "kg*m^2",
                "yaw_by_delta*Jxz_all + hx_delta",
            ),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "yaw_by_delta*P_delta_yaw + P_delta_delta"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 1)],
                "kg*m",
                "yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_R*cos(lam)",
            ),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 0)], "kg*m", "-(yaw_by_delta*h_wheels_all + h_spin_R*cos(lam))"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 1)],
                "kg*m",
                "yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw",
            ),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "Sz_all"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)], "kg*m", "K_phi_delta"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "K_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg", "yaw_per_v_delta*(h_wheels_all - Sz_all)"),
            FormulaInfo::entry(
                &[(MatrixName::K2, 1, 1)],
                "kg",
                "yaw_per_v_delta*(P_delta_lateral - h_spin_R*sin(lam))",
            ),
        ],
        attributes: &[
            FormulaInfo::attribute("B_mass", "the mass of the main frame and rider B", "kg", "mB"),
            FormulaInfo::attribute("B_x", "x of the centre of mass of the main frame and rider B", "m", "-xB"),
            FormulaInfo::attribute("B_z", "z of the centre of mass of the main frame and rider B", "m", "zB"),
            FormulaInfo::attribute("B_Ixx", "the inertia xx of the main frame and rider B", "kg*m^2", "IBxx"),
            FormulaInfo::attribute("B_Ixz", "the inertia xz of the main frame and rider B", "kg*m^2", "-IBxz"),
            FormulaInfo::attribute("B_Izz", "the inertia zz of the main frame and rider B", "kg*m^2", "IBzz"),
            FormulaInfo::attribute("H_mass", "the mass of the steered frame H", "kg", "mH"),
            FormulaInfo::attribute("H_x", "x of the centre of mass of the steered frame H", "m", "-xH"),
            FormulaInfo::attribute("H_z", "z of the centre of mass of the steered frame H", "m", "zH"),
            FormulaInfo::attribute("H_Ixx", "the inertia xx of the steered frame H", "kg*m^2", "IHxx"),
            FormulaInfo::attribute("H_Ixz", "the inertia xz of the steered frame H", "kg*m^2", "-IHxz"),
            FormulaInfo::attribute("H_Izz", "the inertia zz of the steered frame H", "kg*m^2", "IHzz"),
            FormulaInfo::attribute("F_mass", "the mass of the front wheel F", "kg", "mR"),
            FormulaInfo::attribute("F_radius", "the radius of the front wheel F", "m", "rR"),
            FormulaInfo::attribute("F_axial", "the axial inertia of the front wheel F", "kg*m^2", "IRyy"),
            FormulaInfo::attribute("F_radial", "the radial inertia of the front wheel F", "kg*m^2", "IRxx"),
            FormulaInfo::attribute("F_z", "z of the centre of the front wheel F", "m", "-rR"),
            FormulaInfo::attribute("R_mass", "the mass of the rear wheel R", "kg", "mF"),
            FormulaInfo::attribute("R_radius", "the radius of the rear wheel R", "m", "rF"),
            FormulaInfo::attribute("R_axial", "the axial inertia of the rear wheel R", "kg*m^2", "IFyy"),
            FormulaInfo::attribute("R_radial", "the radial inertia of the rear wheel R", "kg*m^2", "IFxx"),
            FormulaInfo::attribute("R_x", "x of the centre of the rear wheel R", "m", "-w"),
            FormulaInfo::attribute("R_z", "z of the centre of the rear wheel R", "m", "-rF"),
            FormulaInfo::attribute("delta_through_x", "x of the point of the joint delta", "m", "-w - c"),
            FormulaInfo::attribute("delta_along_x", "x of the axis of the joint delta", "1", "-sin(lam)"),
            FormulaInfo::attribute("delta_along_z", "z of the axis of the joint delta", "1", "cos(lam)"),
            FormulaInfo::definition("length_delta", "1", "sqrt(delta_along_x^2 + delta_along_z^2)"),
            FormulaInfo::definition("pitch_by_vertical", "1/m", "1/R_x"),
            FormulaInfo::definition("yaw_by_phi", "1", "(R_radius + R_z)/R_x"),
            FormulaInfo::definition(
                "yaw_by_delta",
                "1",
                "-(delta_along_z*(R_x - delta_through_x) - delta_along_x*(R_radius + R_z))/R_x/length_delta",
            ),
            FormulaInfo::definition("yaw_per_v_delta", "1/m", "delta_along_z/R_x/length_delta"),
            FormulaInfo::definition("lateral_by_phi", "m", "F_radius + F_z"),
            FormulaInfo::definition("yaw_by_phi_", "1", "yaw_by_phi - pitch_by_vertical*lateral_by_phi"),
            FormulaInfo::definition("Jxx_delta", "kg*m^2", "H_mass*H_z^2 + H_Ixx + R_mass*R_z^2 + R_radial"),
            FormulaInfo::definition(
                "Jxz_delta",
                "kg*m^2",
                "H_Ixz - H_mass*H_z*(H_x - delta_through_x) - R_mass*R_z*(R_x - delta_through_x)",
            ),
            FormulaInfo::definition(
                "Jzz_delta",
                "kg*m^2",
                "H_mass*(H_x - delta_through_x)^2 + H_Izz + R_mass*(R_x - delta_through_x)^2 + R_radial",
            ),
            FormulaInfo::definition(
                "Sx_delta",
                "kg*m",
                "H_mass*(H_x - delta_through_x) + R_mass*(R_x - delta_through_x)",
            ),
            FormulaInfo::definition("Sz_delta", "kg*m", "H_mass*H_z + R_mass*R_z"),
            FormulaInfo::definition("m_delta", "kg", "H_mass + R_mass"),
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
            FormulaInfo::definition("Jxx_all", "kg*m^2", "B_mass*B_z^2 + B_Ixx + F_mass*F_z^2 + F_radial + Jxx_delta"),
            FormulaInfo::definition(
                "Jxz_all",
                "kg*m^2",
                "B_Ixz + Jxz_delta - B_mass*B_x*B_z - delta_through_x*Sz_delta",
            ),
            FormulaInfo::definition(
                "Jzz_all",
                "kg*m^2",
                "B_mass*B_x^2 + B_Izz + F_radial + 2*delta_through_x*((1/2)*delta_through_x*m_delta + Sx_delta) + Jzz_delta",
            ),
            FormulaInfo::definition("Sx_all", "kg*m", "B_mass*B_x + delta_through_x*m_delta + Sx_delta"),
            FormulaInfo::definition("Sz_all", "kg*m", "B_mass*B_z + F_mass*F_z + Sz_delta"),
            FormulaInfo::definition("m_all", "kg", "B_mass + F_mass + m_delta"),
            FormulaInfo::definition("load_spin_R", "kg", "-Sx_all/R_x"),
            FormulaInfo::definition("load_spin_F", "kg", "-(m_all + load_spin_R)"),
            FormulaInfo::definition("h_spin_F", "kg*m", "F_axial/F_radius"),
            FormulaInfo::definition("h_spin_R", "kg*m", "R_axial/R_radius"),
            FormulaInfo::definition("h_wheels_all", "kg*m", "h_spin_F + h_spin_R"),
            FormulaInfo::definition("M_yaw_delta", "kg*m^2", "delta_through_x*py_delta + hz_delta"),
            FormulaInfo::definition(
                "M_delta_delta",
                "kg*m^2",
                "(delta_along_x*hx_delta + delta_along_z*hz_delta)/length_delta",
            ),
            FormulaInfo::definition(
                "K_phi_phi",
                "kg*m",
                "Sz_all + load_spin_R*(R_radius + R_z) + load_spin_F*(F_radius + F_z)",
            ),
            FormulaInfo::definition(
                "K_phi_delta",
                "kg*m",
                "-py_delta - load_spin_R*(delta_along_z*(R_x - delta_through_x) - delta_along_x*(R_radius + R_z))/length_delta",
            ),
            FormulaInfo::definition(
                "K_delta_delta",
                "kg*m",
                "-delta_along_x*(length_delta*py_delta + load_spin_R*(delta_along_z*(R_x - delta_through_x) - delta_along_x*(R_radius + R_z)))/length_delta^2",
            ),
            FormulaInfo::definition("P_phi_lateral", "kg*m", "lateral_by_phi*m_all + yaw_by_phi_*Sx_all - Sz_all"),
            FormulaInfo::definition("P_phi_yaw", "kg*m^2", "lateral_by_phi*Sx_all + yaw_by_phi_*Jzz_all + Jxz_all"),
            FormulaInfo::definition("P_phi_phi", "kg*m^2", "yaw_by_phi_*Jxz_all + Jxx_all - lateral_by_phi*Sz_all"),
            FormulaInfo::definition(
                "P_phi_delta",
                "kg*m^2",
                "lateral_by_phi*py_delta + yaw_by_phi_*M_yaw_delta + hx_delta",
            ),
            FormulaInfo::definition("P_delta_lateral", "kg*m", "yaw_by_delta*Sx_all + py_delta"),
            FormulaInfo::definition("P_delta_yaw", "kg*m^2", "yaw_by_delta*Jzz_all + M_yaw_delta"),
            FormulaInfo::definition("P_delta_delta", "kg*m^2", "yaw_by_delta*M_yaw_delta + M_delta_delta"),
            FormulaInfo::entry(
                &[(MatrixName::M, 0, 0)],
                "kg*m^2",
                "lateral_by_phi*P_phi_lateral + yaw_by_phi_*P_phi_yaw + P_phi_phi",
            ),
            FormulaInfo::entry(
                &[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)],
                "kg*m^2",
                "yaw_by_delta*P_phi_yaw + P_phi_delta",
            ),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "yaw_by_delta*P_delta_yaw + P_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 0)], "kg*m", "yaw_by_phi_*P_phi_lateral"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 1)],
                "kg*m",
                "(delta_along_z*h_spin_R + length_delta*yaw_by_delta*(h_wheels_all + P_phi_lateral) + length_delta*yaw_per_v_delta*P_phi_yaw - delta_along_x*yaw_by_phi_*h_spin_R)/length_delta",
            ),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 0)],
                "kg*m",
                "(yaw_by_phi_*(delta_along_x*h_spin_R + length_delta*P_delta_lateral) - delta_along_z*h_spin_R - length_delta*yaw_by_delta*h_wheels_all)/length_delta",
            ),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 1)],
                "kg*m",
                "yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw",
            ),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "K_phi_phi"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)], "kg*m", "K_phi_delta"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "K_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg", "yaw_per_v_delta*(h_wheels_all + P_phi_lateral)"),
            FormulaInfo::entry(
                &[(MatrixName::K2, 1, 1)],
                "kg",
                "yaw_per_v_delta*(delta_along_x*h_spin_R/length_delta + P_delta_lateral)",
            ),
        ],
        motion: None,
        gravity: Some(3),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("RearSteered", 26, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("RearSteered", 26, values)?;
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
        Coefficients::from_rows(RearSteeredMatrices::rows(&self.matrices()))
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 2>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn shares(&self, force: usize) -> Option<[T; 2]> {
        (force < 2).then(|| self.kinematics().forces.map(|row| row[force]))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl RearSteered<f64> {
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
impl<T: Scalar> core::fmt::Display for RearSteered<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for RearSteered<T> {
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
        RearSteeredMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        RearSteeredMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> RearSteeredDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<RearSteeredMatrices<T>> {
        if parameter >= 26 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = RearSteeredMatrices {
            m: Rows([[zero; 2]; 2]), c1: Rows([[zero; 2]; 2]), k0: Rows([[zero; 2]; 2]),
            k2: Rows([[zero; 2]; 2]),
        };
        for position in 0..158 {
            let partial = <RearSteeredDerivatives>::PARTIALS[position];
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

impl<T: Scalar> Differentiable<2> for RearSteered<T> {
    type Derivatives = [Coefficients<T, 2>; 26];

    type WithDerivativesOver<U: Number> = RearSteered<U>;

    const PARTIALS: &'static [Partial] = <RearSteeredDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 26];
        for position in 0..158 {
            Partial::write(&<RearSteeredDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(RearSteeredMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for RearSteered<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl RearSteeredDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 158] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 51).negative(),
        Partial::new(MatrixName::M, 1, 0, 0, 51).negative(),
        Partial::new(MatrixName::M, 1, 1, 0, 59).negative(),
        Partial::new(MatrixName::C1, 0, 1, 0, 43), Partial::new(MatrixName::C1, 1, 0, 0, 19),
        Partial::new(MatrixName::C1, 1, 1, 0, 65),
        Partial::new(MatrixName::K0, 0, 1, 0, 52).negative(),
        Partial::new(MatrixName::K0, 1, 0, 0, 52).negative(),
        Partial::new(MatrixName::K0, 1, 1, 0, 55),
        Partial::new(MatrixName::K2, 0, 1, 0, 46),
        Partial::new(MatrixName::K2, 1, 1, 0, 56).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 20), Partial::new(MatrixName::M, 1, 0, 1, 20),
        Partial::new(MatrixName::M, 1, 1, 1, 60), Partial::new(MatrixName::C1, 0, 1, 1, 45),
        Partial::new(MatrixName::C1, 1, 0, 1, 21).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 58), Partial::new(MatrixName::K0, 0, 1, 1, 67),
        Partial::new(MatrixName::K0, 1, 0, 1, 67), Partial::new(MatrixName::K0, 1, 1, 1, 70),
        Partial::new(MatrixName::K2, 1, 1, 1, 71).negative(),
        Partial::new(MatrixName::M, 0, 1, 2, 73), Partial::new(MatrixName::M, 1, 0, 2, 73),
        Partial::new(MatrixName::M, 1, 1, 2, 74), Partial::new(MatrixName::C1, 0, 1, 2, 53),
        Partial::new(MatrixName::C1, 1, 0, 2, 22), Partial::new(MatrixName::C1, 1, 1, 2, 72),
        Partial::new(MatrixName::K0, 0, 1, 2, 76), Partial::new(MatrixName::K0, 1, 0, 2, 76),
        Partial::new(MatrixName::K0, 1, 1, 2, 80), Partial::new(MatrixName::K2, 0, 1, 2, 54),
        Partial::new(MatrixName::K2, 1, 1, 2, 75).negative(),
        Partial::new(MatrixName::M, 0, 0, 4, 17), Partial::new(MatrixName::C1, 0, 1, 4, 88),
        Partial::new(MatrixName::C1, 1, 0, 4, 84),
        Partial::new(MatrixName::K0, 0, 0, 4, 1).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 82).negative(),
        Partial::new(MatrixName::M, 0, 0, 5, 13),
        Partial::new(MatrixName::C1, 0, 1, 5, 31),
        Partial::new(MatrixName::K0, 0, 0, 5, 0).negative(),
        Partial::new(MatrixName::K2, 0, 1, 5, 23).negative(),
        Partial::new(MatrixName::M, 0, 0, 6, 8),
        Partial::new(MatrixName::M, 1, 1, 6, 86),
        Partial::new(MatrixName::C1, 1, 1, 6, 85).negative(),
        Partial::new(MatrixName::C1, 0, 1, 7, 83),
        Partial::new(MatrixName::C1, 1, 0, 7, 83).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 24).negative(),
        Partial::new(MatrixName::M, 0, 1, 8, 30),
        Partial::new(MatrixName::M, 1, 0, 8, 30),
        Partial::new(MatrixName::M, 1, 1, 8, 97),
        Partial::new(MatrixName::C1, 0, 1, 8, 25).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 99).negative(),
        Partial::new(MatrixName::K0, 0, 1, 8, 91),
        Partial::new(MatrixName::K0, 1, 0, 8, 91),
        Partial::new(MatrixName::K0, 1, 1, 8, 92).negative(),
        Partial::new(MatrixName::K2, 1, 1, 8, 87), Partial::new(MatrixName::M, 0, 0, 9, 14),
        Partial::new(MatrixName::M, 0, 1, 9, 44), Partial::new(MatrixName::M, 1, 0, 9, 44),
        Partial::new(MatrixName::C1, 0, 1, 9, 98).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 3), Partial::new(MatrixName::K2, 0, 1, 9, 66),
        Partial::new(MatrixName::M, 0, 0, 10, 12), Partial::new(MatrixName::M, 0, 1, 10, 94),
        Partial::new(MatrixName::M, 1, 0, 10, 94), Partial::new(MatrixName::M, 1, 1, 10, 95),
        Partial::new(MatrixName::C1, 0, 1, 10, 101).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 90).negative(),
        Partial::new(MatrixName::K0, 0, 0, 10, 2),
        Partial::new(MatrixName::K0, 0, 1, 10, 93),
        Partial::new(MatrixName::K0, 1, 0, 10, 93),
        Partial::new(MatrixName::K0, 1, 1, 10, 96).negative(),
        Partial::new(MatrixName::K2, 0, 1, 10, 100), Partial::new(MatrixName::K2, 1, 1, 10, 89),
        Partial::new(MatrixName::M, 0, 0, 11, 8), Partial::new(MatrixName::M, 1, 1, 13, 86),
        Partial::new(MatrixName::C1, 1, 1, 13, 85).negative(),
        Partial::new(MatrixName::M, 0, 1, 14, 29).negative(),
        Partial::new(MatrixName::M, 1, 0, 14, 29).negative(),
        Partial::new(MatrixName::C1, 0, 1, 14, 18),
        Partial::new(MatrixName::M, 0, 1, 15, 34),
        Partial::new(MatrixName::M, 1, 0, 15, 34),
        Partial::new(MatrixName::M, 1, 1, 15, 81).negative(),
        Partial::new(MatrixName::C1, 0, 1, 15, 26).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 48).negative(),
        Partial::new(MatrixName::K0, 0, 1, 15, 61),
        Partial::new(MatrixName::K0, 1, 0, 15, 61),
        Partial::new(MatrixName::K0, 1, 1, 15, 62).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 103),
        Partial::new(MatrixName::M, 0, 0, 16, 16),
        Partial::new(MatrixName::M, 0, 1, 16, 39).negative(),
        Partial::new(MatrixName::M, 1, 0, 16, 39).negative(),
        Partial::new(MatrixName::M, 1, 1, 16, 78),
        Partial::new(MatrixName::C1, 0, 1, 16, 63).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 64),
        Partial::new(MatrixName::K0, 0, 0, 16, 5),
        Partial::new(MatrixName::K0, 0, 1, 16, 68).negative(),
        Partial::new(MatrixName::K0, 1, 0, 16, 68).negative(),
        Partial::new(MatrixName::K0, 1, 1, 16, 106),
        Partial::new(MatrixName::K2, 0, 1, 16, 47),
        Partial::new(MatrixName::K2, 1, 1, 16, 69).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 10),
        Partial::new(MatrixName::M, 0, 1, 17, 42).negative(),
        Partial::new(MatrixName::M, 1, 0, 17, 42).negative(),
        Partial::new(MatrixName::M, 1, 1, 17, 40),
        Partial::new(MatrixName::C1, 0, 1, 17, 108).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 50),
        Partial::new(MatrixName::K0, 0, 0, 17, 4),
        Partial::new(MatrixName::K0, 0, 1, 17, 32).negative(),
        Partial::new(MatrixName::K0, 1, 0, 17, 32).negative(),
        Partial::new(MatrixName::K0, 1, 1, 17, 41),
        Partial::new(MatrixName::K2, 0, 1, 17, 107),
        Partial::new(MatrixName::K2, 1, 1, 17, 49).negative(),
        Partial::new(MatrixName::M, 0, 0, 18, 8),
        Partial::new(MatrixName::M, 0, 1, 18, 9).negative(),
        Partial::new(MatrixName::M, 1, 0, 18, 9).negative(),
        Partial::new(MatrixName::M, 1, 1, 18, 104), Partial::new(MatrixName::M, 1, 1, 20, 109),
        Partial::new(MatrixName::C1, 1, 1, 20, 102).negative(),
        Partial::new(MatrixName::M, 0, 1, 21, 33).negative(),
        Partial::new(MatrixName::M, 1, 0, 21, 33).negative(),
        Partial::new(MatrixName::M, 1, 1, 21, 79),
        Partial::new(MatrixName::C1, 0, 1, 21, 18),
        Partial::new(MatrixName::C1, 1, 1, 21, 57).negative(),
        Partial::new(MatrixName::M, 0, 0, 22, 15),
        Partial::new(MatrixName::M, 0, 1, 22, 27).negative(),
        Partial::new(MatrixName::M, 1, 0, 22, 27).negative(),
        Partial::new(MatrixName::M, 1, 1, 22, 77),
        Partial::new(MatrixName::C1, 0, 1, 22, 35),
        Partial::new(MatrixName::C1, 1, 0, 22, 112),
        Partial::new(MatrixName::C1, 1, 1, 22, 114).negative(),
        Partial::new(MatrixName::K0, 0, 0, 22, 7).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 113),
        Partial::new(MatrixName::K0, 1, 0, 22, 113),
        Partial::new(MatrixName::K0, 1, 1, 22, 115).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 36).negative(),
        Partial::new(MatrixName::K2, 1, 1, 22, 37),
        Partial::new(MatrixName::M, 0, 0, 23, 11),
        Partial::new(MatrixName::M, 0, 1, 23, 117).negative(),
        Partial::new(MatrixName::M, 1, 0, 23, 117).negative(),
        Partial::new(MatrixName::M, 1, 1, 23, 105),
        Partial::new(MatrixName::C1, 0, 1, 23, 38),
        Partial::new(MatrixName::C1, 1, 1, 23, 118).negative(),
        Partial::new(MatrixName::K0, 0, 0, 23, 6).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 116),
        Partial::new(MatrixName::K0, 1, 0, 23, 116),
        Partial::new(MatrixName::K0, 1, 1, 23, 119).negative(),
        Partial::new(MatrixName::K2, 0, 1, 23, 28).negative(),
        Partial::new(MatrixName::K2, 1, 1, 23, 120), Partial::new(MatrixName::M, 0, 0, 24, 8),
        Partial::new(MatrixName::M, 0, 1, 24, 9).negative(),
        Partial::new(MatrixName::M, 1, 0, 24, 9).negative(),
        Partial::new(MatrixName::M, 1, 1, 24, 110),
        Partial::new(MatrixName::C1, 1, 1, 24, 102).negative(),
        Partial::new(MatrixName::C1, 0, 1, 25, 111),
        Partial::new(MatrixName::C1, 1, 0, 25, 111).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 121).negative(),
        Partial::new(MatrixName::K2, 1, 1, 25, 122),
    ];
}
