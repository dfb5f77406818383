// @generated from generated/models/balance_assist.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: a9fd1c383f4b46f9

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A bicycle with a motor that steers into the fall, so that it stays up at lower speeds.
///
/// The Whipple-Carvallo bicycle with a torque on its steer that follows from the lean rate and fades with the speed,
/// `kappa*(vo - v)` times the lean rate: up to the speed `vo`, beyond which such a motor is switched off and the bicycle is
/// [`Whipple`](crate::Whipple). Axes: origin at the rear contact point, x forward, y to the right, z down.
///
/// The declaration asserts that the matrices are those of Appendix A of the paper, less the torque in C0 and C1.
///
/// Source: Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3; torque: BicycleParameters, example plot_balanceassistv1.py
///
/// Derived from a mechanism: body `B` (rear frame and rider), body `H` (front frame), wheel `R` (rear wheel), wheel `F` (front wheel).
///
/// The fields are the parameters. The coordinates are `phi` (lean) in `rad`, `delta` (steer) in `rad`.
///
/// In the matrices is what follows from the motion:
///
/// - `Tmotor` (steer torque of the motor) in `N*m` on `delta`: `kappa*(vo - v)*rate(phi)`.
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
/// mA = mH + mF [kg]
/// mu = (c/w)*cos(lam) [1]
/// SR = IRyy/rR [kg*m]
/// SF = IFyy/rF [kg*m]
/// ST = SR + SF [kg*m]
/// yaw_per_v_delta = cos(lam)/w [1/m]
/// Jxx_delta = IHxx + IFxx + zH^2*mH + rF^2*mF [kg*m^2]
/// Jxz_delta = IHxz - c*rF*mF - zH*mH*(xH - (w + c)) [kg*m^2]
/// Jzz_delta = mH*(xH - (w + c))^2 + IHzz + IFxx + c^2*mF [kg*m^2]
/// Sx_delta = mH*(xH - (w + c)) - c*mF [kg*m]
/// Sz_delta = zH*mH - rF*mF [kg*m]
/// py_delta = Sx_delta*cos(lam) - Sz_delta*sin(lam) [kg*m]
/// hx_delta = Jxx_delta*sin(lam) + Jxz_delta*cos(lam) [kg*m^2]
/// hz_delta = Jxz_delta*sin(lam) + Jzz_delta*cos(lam) [kg*m^2]
/// Jxx_all = IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB [kg*m^2]
/// Jxz_all = IBxz + Jxz_delta - xB*zB*mB - Sz_delta*(w + c) [kg*m^2]
/// Jzz_all = IRxx + IBzz + Jzz_delta + 2*(w + c)*((1/2)*mA*(w + c) + Sx_delta) + xB^2*mB [kg*m^2]
/// Sx_all = xB*mB + mA*(w + c) + Sx_delta [kg*m]
/// Sz_all = zB*mB + Sz_delta - rR*mR [kg*m]
/// load_spin_F = -Sx_all/w [kg]
/// M_yaw_delta = py_delta*(w + c) + hz_delta [kg*m^2]
/// M_delta_delta = hx_delta*sin(lam) + hz_delta*cos(lam) [kg*m^2]
/// K_phi_delta = c*load_spin_F*cos(lam) - py_delta [kg*m]
/// K_delta_delta = (c*load_spin_F*cos(lam) - py_delta)*sin(lam) [kg*m]
/// P_delta_lateral = mu*Sx_all + py_delta [kg*m]
/// P_delta_yaw = mu*Jzz_all + M_yaw_delta [kg*m^2]
/// P_delta_delta = mu*M_yaw_delta + M_delta_delta [kg*m^2]
/// M_11 = Jxx_all [kg*m^2]
/// M_12 = M_21 = mu*Jxz_all + hx_delta [kg*m^2]
/// M_22 = mu*P_delta_yaw + P_delta_delta [kg*m^2]
/// C0_21 = -kappa*vo [kg*m^2/s]
/// C1_12 = mu*(ST - Sz_all) + SF*cos(lam) + yaw_per_v_delta*Jxz_all [kg*m]
/// C1_21 = kappa - mu*ST - SF*cos(lam) [kg*m]
/// C1_22 = mu*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
/// K0_11 = Sz_all [kg*m]
/// K0_12 = K0_21 = K_phi_delta [kg*m]
/// K0_22 = K_delta_delta [kg*m]
/// K2_12 = yaw_per_v_delta*(ST - Sz_all) [kg]
/// K2_22 = yaw_per_v_delta*(SF*sin(lam) + P_delta_lateral) [kg]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct BalanceAssist<T = f64> {
    /// Wheel base.
    ///
    /// `w` in `m`: `> 0`.
    pub w: T,
    /// Trail: positive when the front contact is behind the point where the steer axis meets the ground.
    ///
    /// `c` in `m`: any finite value.
    pub c: T,
    /// Steer axis tilt: 90 degrees minus the head angle.
    ///
    /// `lam`, λ, in `rad`: `> -1.5707963267948966 and < 1.5707963267948966`.
    pub lam: T,
    /// Gravitational field strength.
    ///
    /// `g` in `N/kg`: `>= 0`.
    pub g: T,
    /// Radius of the rear wheel.
    ///
    /// `rR` in `m`: `> 0`.
    pub rR: T,
    /// Mass of the rear wheel.
    ///
    /// `mR` in `kg`: `>= 0`.
    pub mR: T,
    /// Radial moment of inertia of the rear wheel; by symmetry also about the vertical.
    ///
    /// `IRxx` in `kg*m^2`: `>= 0`.
    pub IRxx: T,
    /// Axial moment of inertia of the rear wheel.
    ///
    /// `IRyy` in `kg*m^2`: `>= 0`.
    pub IRyy: T,
    /// Centre of mass of the rear frame and rider, forward of the rear contact.
    ///
    /// `xB` in `m`: any finite value.
    pub xB: T,
    /// Centre of mass of the rear frame and rider, downward.
    ///
    /// `zB` in `m`: any finite value.
    pub zB: T,
    /// Mass of the rear frame and rider.
    ///
    /// `mB` in `kg`: `>= 0`.
    pub mB: T,
    /// Moment of inertia of the rear frame and rider about its centre of mass, in roll.
    ///
    /// `IBxx` in `kg*m^2`: `>= 0`.
    pub IBxx: T,
    /// Moment of inertia of the rear frame and rider about its centre of mass, in pitch.
    ///
    /// `IByy` in `kg*m^2`: `>= 0`. No matrix depends on it.
    pub IByy: T,
    /// Moment of inertia of the rear frame and rider about its centre of mass, in yaw.
    ///
    /// `IBzz` in `kg*m^2`: `>= 0`.
    pub IBzz: T,
    /// Product of inertia of the rear frame and rider about its centre of mass.
    ///
    /// `IBxz` in `kg*m^2`: any finite value.
    pub IBxz: T,
    /// Centre of mass of the front frame, forward of the rear contact.
    ///
    /// `xH` in `m`: any finite value.
    pub xH: T,
    /// Centre of mass of the front frame, downward.
    ///
    /// `zH` in `m`: any finite value.
    pub zH: T,
    /// Mass of the front frame.
    ///
    /// `mH` in `kg`: `>= 0`.
    pub mH: T,
    /// Moment of inertia of the front frame about its centre of mass, in roll.
    ///
    /// `IHxx` in `kg*m^2`: `>= 0`.
    pub IHxx: T,
    /// Moment of inertia of the front frame about its centre of mass, in pitch.
    ///
    /// `IHyy` in `kg*m^2`: `>= 0`. No matrix depends on it.
    pub IHyy: T,
    /// Moment of inertia of the front frame about its centre of mass, in yaw.
    ///
    /// `IHzz` in `kg*m^2`: `>= 0`.
    pub IHzz: T,
    /// Product of inertia of the front frame about its centre of mass.
    ///
    /// `IHxz` in `kg*m^2`: any finite value.
    pub IHxz: T,
    /// Radius of the front wheel.
    ///
    /// `rF` in `m`: `> 0`.
    pub rF: T,
    /// Mass of the front wheel.
    ///
    /// `mF` in `kg`: `>= 0`.
    pub mF: T,
    /// Radial moment of inertia of the front wheel; by symmetry also about the vertical.
    ///
    /// `IFxx` in `kg*m^2`: `>= 0`.
    pub IFxx: T,
    /// Axial moment of inertia of the front wheel.
    ///
    /// `IFyy` in `kg*m^2`: `>= 0`.
    pub IFyy: T,
    /// Steer torque by lean rate, for each m/s that the bicycle is slower than `vo`.
    ///
    /// `kappa`, κ, in `N*s^2`: `>= 0`.
    pub kappa: T,
    /// The speed from which the motor leaves the bicycle alone.
    ///
    /// `vo` in `m/s`: `> 0`.
    pub vo: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`BalanceAssist`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BalanceAssistMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C0, a coefficient of q'.
    pub c0: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 2>,
}

impl<T: Number> BalanceAssist<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 48 additions, 45 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 100 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> BalanceAssistMatrices<T> {
        let t6 = self.zH * self.mH;
        let t10 = self.rF * self.mF;
        let Jxx_delta = self.IHxx + self.IFxx + self.zH * t6 + self.rF * t10;
        let t17 = self.rR * self.mR;
        let t21 = self.zB * self.mB;
        let M_11 = self.IRxx + self.IBxx + Jxx_delta + self.rR * t17 + self.zB * t21;
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t35 = self.c + self.w;
        let t36 = t35 - self.xH;
        let Jxz_delta = self.IHxz + t6 * t36 - t10 * self.c;
        let hx_delta = Jxx_delta * sin_lam + Jxz_delta * cos_lam;
        let yaw_per_v_delta = cos_lam / self.w;
        let mu = self.c * yaw_per_v_delta;
        let Sz_delta = t6 - t10;
        let Jxz_all = Jxz_delta + self.IBxz - t21 * self.xB - t35 * Sz_delta;
        let M_12 = hx_delta + mu * Jxz_all;
        let t57 = self.mH * t36;
        let t59 = self.mF * self.c;
        let Jzz_delta = self.IFxx + self.IHzz + t36 * t57 + self.c * t59;
        let hz_delta = sin_lam * Jxz_delta + cos_lam * Jzz_delta;
        let t67 = t57 + t59;
        let t69 = sin_lam * Sz_delta + cos_lam * t67;
        let M_yaw_delta = hz_delta - t35 * t69;
        let t73 = self.mB * self.xB;
        let mA = self.mH + self.mF;
        let t77 = t67 - t35 * mA;
        let P_delta_yaw = M_yaw_delta
            + mu
                * (self.IRxx + Jzz_delta + self.IBzz + self.xB * t73
                    - t35 * (t67 + t77));
        let M_22 = mu * (M_yaw_delta + P_delta_yaw) + sin_lam * hx_delta
            + cos_lam * hz_delta;
        let zero = self.w.like(0.0);
        let SF = self.IFyy / self.rF;
        let ST = SF + self.IRyy / self.rR;
        let Sz_all = t21 + Sz_delta - t17;
        let t103 = ST - Sz_all;
        let t105 = cos_lam * SF;
        let C1_12 = mu * t103 + t105 + yaw_per_v_delta * Jxz_all;
        let C1_21 = self.kappa - t105 - mu * ST;
        let Sx_all = t73 - t77;
        let t113 = mu * Sx_all;
        let P_delta_lateral = t113 - t69;
        let C1_22 = mu * P_delta_lateral + yaw_per_v_delta * P_delta_yaw;
        let K2_12 = yaw_per_v_delta * t103;
        let K2_22 = yaw_per_v_delta * (P_delta_lateral + sin_lam * SF);
        let C0_21 = -(self.kappa * self.vo);
        let K0_12 = t69 - t113;
        let K0_22 = -(sin_lam * P_delta_lateral);
        BalanceAssistMatrices::from_entries([
            M_11, M_12, M_12, M_22, zero, zero, C0_21, zero, zero, C1_12, C1_21, C1_22, Sz_all,
            K0_12, K0_12, K0_22, zero, K2_12, zero, K2_22,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`BalanceAssist`] that follow from its coordinates q = (`phi`, `delta`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BalanceAssistKinematics<T = f64> {
    /// Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin.
    pub lateral: Rate<T, 2>,
    /// Yaw rate, to the right, in `rad/s`: of `B`.
    pub yaw: Rate<T, 2>,
    /// Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_R: Rate<T, 2>,
    /// Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in `rad/s`.
    pub wheel_F: Rate<T, 2>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate,
    /// a column for each of `Tphi` (lean torque) in `N*m`, `Tdelta` (steer torque) in `N*m`.
    pub forces: [[T; 2]; 2],
}

impl<T: Scalar> BalanceAssist<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> BalanceAssistKinematics<T> {
        let zero = self.w.like(0.0);
        let yaw_per_v_delta = self.lam.cos() / self.w;
        let mu = self.c * yaw_per_v_delta;
        let t12 = -(self.w.like(1.0) / self.rR);
        let t13 = -(self.w.like(1.0) / self.rF);
        BalanceAssistKinematics {
            lateral: Rate {
                speed: zero, rates: [zero, zero], coordinates: [zero, zero],
                heading: self.w.like(1.0),
            },
            yaw: Rate {
                speed: zero, rates: [zero, mu], coordinates: [zero, yaw_per_v_delta], heading: zero,
            },
            wheel_R: Rate {
                speed: t12, rates: [zero, zero], coordinates: [zero, zero], heading: zero,
            },
            wheel_F: Rate {
                speed: t13, rates: [zero, zero], coordinates: [zero, zero], heading: zero,
            },
            forces: [[self.w.like(1.0), zero], [zero, self.w.like(1.0)]],
        }
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`BalanceAssist`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BalanceAssistDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 125],
}

impl<T: Number> BalanceAssist<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 114 additions, 190 multiplications, 3 divisions, 4 negations and 2 trigonometric functions: 313 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (BalanceAssistMatrices<T>, BalanceAssistDerivatives<T>) {
        let zero = self.w.like(0.0);
        let mut matrices = BalanceAssistMatrices::from_entries([zero; 20]);
        let mut derivatives = BalanceAssistDerivatives {
            values: [zero; 125],
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
        matrices: &mut BalanceAssistMatrices<T>,
        derivatives: &mut BalanceAssistDerivatives<T>,
    ) {
        *matrices = BalanceAssistMatrices::from_entries([self.w.like(0.0); 20]);
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
        put_derivative(8, self.kappa);
        put_derivative(9, self.vo);
        put_derivative(10, self.w.like(1.0));
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        put_derivative(11, sin_lam);
        let M_11_mF = self.rF * self.rF;
        put_derivative(12, M_11_mF);
        let t30 = self.zH * self.mH;
        let Jxx_delta = self.IFxx + self.mF * M_11_mF + self.IHxx + self.zH * t30;
        let t36 = self.zB * self.mB;
        let t37 = self.rR * self.mR;
        let t38 = self.c + self.w;
        let M_11_rR = t37 + t37;
        put_derivative(13, M_11_rR);
        let M_11_mR = self.rR * self.rR;
        put_derivative(14, M_11_mR);
        let M_11_zB = t36 + t36;
        put_derivative(15, M_11_zB);
        let M_11_mB = self.zB * self.zB;
        put_derivative(16, M_11_mB);
        let M_11_zH = t30 + t30;
        put_derivative(17, M_11_zH);
        let M_11_mH = self.zH * self.zH;
        put_derivative(18, M_11_mH);
        let C0_21 = -(self.kappa * self.vo);
        put_entry(3, C0_21);
        let t47 = t38 - self.xH;
        let t48 = self.mH * t47;
        let t49 = self.mF * self.c;
        let t53 = self.zH * t48 + self.IHxz - self.rF * t49;
        let t54 = self.w.like(1.0) / self.w;
        let t55 = self.mF * self.rF;
        let M_11_rF = t55 + t55;
        put_derivative(19, M_11_rF);
        let t57 = t55 - t30;
        let M_11 = self.IRxx + self.IBxx + Jxx_delta + self.zB * t36 + self.rR * t37;
        put_entry(0, M_11);
        let K0_11 = t36 - (t37 + t57);
        put_entry(7, K0_11);
        let Jzz_delta = self.IFxx + self.IHzz + self.c * t49 + t47 * t48;
        let t71 = self.c * t54;
        let t72 = self.mB * self.xB;
        let t73 = t48 + t49;
        let t75 = t38 * (self.mF + self.mH);
        let t77 = t48 - t72 - t75;
        let t78 = t73 - t75;
        let t83 = t53 + self.IBxz + t38 * t57 - t36 * self.xB;
        let t90 = self.IRxx + Jzz_delta + self.xB * t72 + self.IBzz - t38 * (t73 + t78);
        let K0_12_zH = self.mH * sin_lam;
        put_derivative(20, K0_12_zH);
        let t92 = t49 + t77;
        let t93 = t53 * cos_lam;
        let t94 = t53 * sin_lam;
        let mu = cos_lam * t71;
        put_derivative(21, mu);
        let t98 = sin_lam * t57 - cos_lam * t73;
        let t99 = t78 * mu;
        let t100 = cos_lam * t57;
        let t102 = t100 + sin_lam * t73;
        let hx_delta = t93 + Jxx_delta * sin_lam;
        let t106 = cos_lam * Jzz_delta + t94;
        let t107 = t54 * t83;
        let t108 = self.w.like(1.0) / self.rF;
        let t109 = self.w.like(1.0) / self.rR;
        let yaw_per_v_delta = cos_lam * t54;
        put_derivative(22, yaw_per_v_delta);
        let t111 = t36 * yaw_per_v_delta;
        put_derivative(23, t111);
        let t112 = self.mB * yaw_per_v_delta;
        put_derivative(24, t112);
        let t113 = self.zB * yaw_per_v_delta;
        put_derivative(25, t113);
        let t114 = t30 * yaw_per_v_delta;
        put_derivative(26, t114);
        let SF = self.IFyy * t108;
        let t116 = cos_lam * t107;
        let t121 = yaw_per_v_delta * (t93 + t38 * t102 - sin_lam * Jzz_delta);
        let t122 = t90 * mu;
        let t124 = t106 + t38 * t98;
        let t125 = t98 - t99;
        let M_12 = hx_delta + self.c * t116;
        put_entry(1, M_12);
        let M_12_c = t116 - t100;
        put_derivative(27, M_12_c);
        let t129 = self.IRyy * t109;
        let K2_12_IRyy = t109 * yaw_per_v_delta;
        put_derivative(28, K2_12_IRyy);
        let ST = SF + t129;
        let t132 = cos_lam * SF;
        let t133 = self.xB * mu;
        put_derivative(29, t133);
        let t135 = t54 * (ST - K0_11);
        let C1_21 = self.kappa - mu * ST - t132;
        put_entry(5, C1_21);
        let t139 = self.zB * t133;
        put_derivative(30, t139);
        let M_22_mB = t133 * t133;
        put_derivative(31, M_22_mB);
        let t141 = sin_lam * t133;
        put_derivative(32, t141);
        let t142 = t122 + t124;
        let t143 = self.mB * t133;
        put_derivative(33, t143);
        let t144 = t125 + t143;
        let t145 = mu * t143;
        let M_22_xB = t145 + t145;
        put_derivative(34, M_22_xB);
        let t148 = t106 + t71 * t142;
        let K0_12 = -t144;
        put_entry(8, K0_12);
        let K0_22 = -(sin_lam * t144);
        put_entry(9, K0_22);
        let t153 = t142 + self.c * t144;
        let t155 = t107 + self.c * t135;
        let t156 = t142 * yaw_per_v_delta;
        let t157 = t156 + t156;
        let t158 = sin_lam * t135;
        put_derivative(35, t158);
        let K2_12 = cos_lam * t135;
        put_entry(10, K2_12);
        put_derivative(36, K2_12);
        let t160 = sin_lam * SF;
        let t162 = t54 * (t144 + t160);
        let M_12_Jxz_delta = cos_lam + mu;
        put_derivative(37, M_12_Jxz_delta);
        let t164 = t54 * K2_12;
        put_derivative(38, t164);
        let C1_22_Jzz_delta = yaw_per_v_delta * M_12_Jxz_delta;
        put_derivative(39, C1_22_Jzz_delta);
        let t166 = t30 * M_12_Jxz_delta;
        put_derivative(40, t166);
        let M_12_w = t166 - t71 * M_12_c;
        put_derivative(41, M_12_w);
        let M_22 = sin_lam * hx_delta + cos_lam * (t148 + t71 * t124);
        put_entry(2, M_22);
        let C1_12_w = yaw_per_v_delta * (t55 - t155);
        put_derivative(42, C1_12_w);
        let t180 = sin_lam * t148 - cos_lam * hx_delta - self.c * t121;
        let t181 = SF + t155;
        let C1_22 = yaw_per_v_delta * t153;
        put_entry(6, C1_22);
        let t184 = t54 * (t122 + t153);
        let C1_12 = cos_lam * t181;
        put_entry(4, C1_12);
        let t186 = sin_lam * t181;
        put_derivative(43, t186);
        let K2_22 = cos_lam * t162;
        put_entry(11, K2_22);
        let t190 = cos_lam * (self.mF + t54 * t92);
        let t191 = t38 * mu;
        let K0_12_mH = self.zH * sin_lam + t47 * M_12_Jxz_delta - t191;
        put_derivative(44, K0_12_mH);
        let t196 = M_12_Jxz_delta + M_12_Jxz_delta;
        let t197 = t180 + t180;
        put_derivative(45, t197);
        let M_22_Jxz_delta = sin_lam * t196;
        put_derivative(46, M_22_Jxz_delta);
        let t199 = ST * yaw_per_v_delta;
        put_derivative(47, t199);
        let C1_21_w = t71 * t199;
        put_derivative(48, C1_21_w);
        let t201 = t71 * t190;
        let t202 = self.mH * M_12_Jxz_delta;
        put_derivative(49, t202);
        let t203 = sin_lam * t202;
        put_derivative(50, t203);
        let t204 = self.mH * cos_lam;
        let K0_12_c = t190 + t204;
        put_derivative(51, K0_12_c);
        let K0_22_c = sin_lam * K0_12_c;
        put_derivative(52, K0_22_c);
        let t207 = yaw_per_v_delta * K0_12_c;
        put_derivative(53, t207);
        let K0_12_w = t204 - t201;
        put_derivative(54, K0_12_w);
        let M_12_mH = self.zH * K0_12_mH;
        put_derivative(55, M_12_mH);
        let M_22_mH = K0_12_mH * K0_12_mH;
        put_derivative(56, M_22_mH);
        let t211 = self.mH * K0_12_mH;
        let t212 = self.rF * sin_lam;
        let t213 = t191 + t212;
        let K0_12_mF = self.c * M_12_Jxz_delta - t213;
        put_derivative(57, K0_12_mF);
        let K0_22_w = sin_lam * K0_12_w;
        put_derivative(58, K0_22_w);
        let t218 = yaw_per_v_delta * (t162 + K0_12_w);
        put_derivative(59, t218);
        let M_22_hz_delta = self.xH * t202 + self.c * t204 - t211;
        let M_12_zH = t211 + t30 * sin_lam;
        put_derivative(60, M_12_zH);
        let t225 = t211 * t196;
        put_derivative(61, t225);
        let t226 = sin_lam * t71;
        let M_12_lam = Jxx_delta * cos_lam - t94 - t83 * t226;
        put_derivative(62, M_12_lam);
        let C1_21_lam = t160 + ST * t226;
        put_derivative(63, C1_21_lam);
        let t234 = t102 + t92 * t226;
        put_derivative(64, t234);
        let K2_22_lam = yaw_per_v_delta * (t132 + t234) - sin_lam * t162;
        put_derivative(65, K2_22_lam);
        let C1_22_lam = t121 + mu * t234 - sin_lam * t184;
        put_derivative(66, C1_22_lam);
        let t245 = cos_lam * t144 + sin_lam * t234;
        put_derivative(67, t245);
        let M_12_rF = self.mF * (t212 - K0_12_mF);
        put_derivative(68, M_12_rF);
        let t250 = mu * (t125 + t125) + t225;
        let t252 = t125 - t99 - M_22_hz_delta;
        let t253 = self.rF * K0_12_mF;
        put_derivative(69, t253);
        let M_22_mF = K0_12_mF * K0_12_mF;
        put_derivative(70, M_22_mF);
        let t255 = t129 * K2_12_IRyy;
        let C1_12_IRyy = self.c * K2_12_IRyy;
        put_derivative(71, C1_12_IRyy);
        let C1_21_rR = t129 * C1_12_IRyy;
        put_derivative(72, C1_21_rR);
        let t258 = self.mR * yaw_per_v_delta;
        let M_22_w = t250 - t71 * t157;
        put_derivative(73, M_22_w);
        let M_22_c = t250 + t157 + self.mF * t196 * K0_12_mF;
        put_derivative(74, M_22_c);
        let t266 = self.c * (t255 - t258);
        put_derivative(75, t266);
        let K2_12_rR = t258 - t255;
        put_derivative(76, K2_12_rR);
        let K2_12_mR = self.rR * yaw_per_v_delta;
        put_derivative(77, K2_12_mR);
        let C1_22_c = yaw_per_v_delta
            * (t144 + t252 + t90 * yaw_per_v_delta
                - self.mF * (t213 + self.w * M_12_Jxz_delta) - mu * t77);
        put_derivative(78, C1_22_c);
        let C1_22_w = yaw_per_v_delta * (self.c * t201 + t252 - t184);
        put_derivative(79, C1_22_w);
        let C1_12_mR = self.c * K2_12_mR;
        put_derivative(80, C1_12_mR);
        let M_22_IRxx = mu * mu;
        put_derivative(81, M_22_IRxx);
        let C1_22_xH = yaw_per_v_delta * M_22_hz_delta + self.mH * M_22_IRxx;
        put_derivative(82, C1_22_xH);
        let C1_22_IRxx = mu * yaw_per_v_delta;
        put_derivative(83, C1_22_IRxx);
        let K2_22_xB = self.mB * C1_22_IRxx;
        put_derivative(84, K2_22_xB);
        let t290 = self.mB * mu;
        put_derivative(85, t290);
        let t291 = self.zB * t290;
        put_derivative(86, t291);
        let t292 = sin_lam * t290;
        put_derivative(87, t292);
        let t293 = self.xB * yaw_per_v_delta;
        let K2_22_mB = mu * t293;
        put_derivative(88, K2_22_mB);
        let t295 = mu + t293;
        let C1_22_xB = t290 * (t293 + t295);
        put_derivative(89, C1_22_xB);
        let C1_22_mB = t133 * t295;
        put_derivative(90, C1_22_mB);
        let t299 = self.mB * t295;
        put_derivative(91, t299);
        let t300 = self.zB * t295;
        put_derivative(92, t300);
        let t301 = self.mH * yaw_per_v_delta;
        put_derivative(93, t301);
        let K2_22_xH = M_12_Jxz_delta * t301;
        put_derivative(94, K2_22_xH);
        let K0_22_mH = sin_lam * K0_12_mH;
        put_derivative(95, K0_22_mH);
        let t304 = self.mH * K0_22_mH;
        let M_22_zH = t304 + t304;
        put_derivative(96, M_22_zH);
        let t306 = yaw_per_v_delta * K0_12_mH;
        put_derivative(97, t306);
        let t307 = self.c + self.xH;
        let t308 = t307 * t306;
        put_derivative(98, t308);
        let t309 = t301 * t307;
        put_derivative(99, t309);
        let t310 = sin_lam * t301;
        put_derivative(100, t310);
        let t311 = t307 * t310;
        put_derivative(101, t311);
        let M_22_Jxx_delta = sin_lam * sin_lam;
        put_derivative(102, M_22_Jxx_delta);
        let K0_22_zH = self.mH * M_22_Jxx_delta;
        put_derivative(103, K0_22_zH);
        let t314 = self.zH * yaw_per_v_delta;
        put_derivative(104, t314);
        let t315 = t307 * t314;
        put_derivative(105, t315);
        let M_22_Jzz_delta = M_12_Jxz_delta * M_12_Jxz_delta;
        put_derivative(106, M_22_Jzz_delta);
        let M_22_IFxx = M_22_Jxx_delta + M_22_Jzz_delta;
        put_derivative(107, M_22_IFxx);
        let C1_12_IFyy = t108 * M_12_Jxz_delta;
        put_derivative(108, C1_12_IFyy);
        let C1_21_rF = SF * C1_12_IFyy;
        put_derivative(109, C1_21_rF);
        let C1_22_Jxz_delta = sin_lam * yaw_per_v_delta;
        put_derivative(110, C1_22_Jxz_delta);
        let K2_22_IFyy = t108 * C1_22_Jxz_delta;
        put_derivative(111, K2_22_IFyy);
        let K2_12_IFyy = t108 * yaw_per_v_delta;
        put_derivative(112, K2_12_IFyy);
        let K0_22_mF = sin_lam * K0_12_mF;
        put_derivative(113, K0_22_mF);
        let t324 = self.mF * K0_22_mF;
        let t325 = t324 + t324;
        put_derivative(114, t325);
        let t326 = yaw_per_v_delta * K0_12_mF;
        put_derivative(115, t326);
        let t327 = t38 * t326;
        put_derivative(116, t327);
        let t328 = self.mF * yaw_per_v_delta;
        let K2_12_rF = t328 - SF * K2_12_IFyy;
        put_derivative(117, K2_12_rF);
        let t331 = t38 * t328;
        let C1_12_rF = t331 - C1_21_rF;
        put_derivative(118, C1_12_rF);
        let C1_22_rF = sin_lam * t331;
        put_derivative(119, C1_22_rF);
        let P_delta_lateral_rF = self.mF * sin_lam;
        put_derivative(120, P_delta_lateral_rF);
        let t335 = sin_lam * P_delta_lateral_rF;
        put_derivative(121, t335);
        let K2_12_mF = self.rF * yaw_per_v_delta;
        put_derivative(122, K2_12_mF);
        let C1_12_mF = t38 * K2_12_mF;
        put_derivative(123, C1_12_mF);
        let t339 = -(sin_lam * K2_12_rF);
        put_derivative(124, t339);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl BalanceAssist<f64> {
    /// The parameter set `benchmark`.
    ///
    /// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; motor: an example of BicycleParameters, plot_balanceassistv1.py
    ///
    /// It is the default.
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
    /// | `kappa` | 10 | `N*s^2` |
    /// | `vo` | 4.7 | `m/s` |
    pub const BENCHMARK: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3141592653589793, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.0603,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.05892, IHyy: 0.06, IHzz: 0.00708, IHxz: -0.00756,
        rF: 0.35, mF: 3.0, IFxx: 0.1405, IFyy: 0.28, kappa: 10.0, vo: 4.7,
    };

    /// The parameter set `balanceassistv1`.
    ///
    /// Source: BicycleParameters 1.5.2 (BSD), Balanceassistv1Benchmark.txt, an electric bicycle without a rider; motor: an example of BicycleParameters, plot_balanceassistv1.py
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `w` | 1.113 | `m` |
    /// | `c` | 0.042 | `m` |
    /// | `lam` | 0.255 | `rad` |
    /// | `g` | 9.80665 | `N/kg` |
    /// | `rR` | 0.34895 | `m` |
    /// | `mR` | 4.085 | `kg` |
    /// | `IRxx` | 0.1023 | `kg*m^2` |
    /// | `IRyy` | 0.1887 | `kg*m^2` |
    /// | `xB` | 0.519 | `m` |
    /// | `zB` | -0.521 | `m` |
    /// | `mB` | 22.5 | `kg` |
    /// | `IBxx` | 1.12 | `kg*m^2` |
    /// | `IByy` | 3.16 | `kg*m^2` |
    /// | `IBzz` | 2.119 | `kg*m^2` |
    /// | `IBxz` | 0.047 | `kg*m^2` |
    /// | `xH` | 0.921 | `m` |
    /// | `zH` | -0.86 | `m` |
    /// | `mH` | 4.3 | `kg` |
    /// | `IHxx` | 0.2984 | `kg*m^2` |
    /// | `IHyy` | 0.257 | `kg*m^2` |
    /// | `IHzz` | 0.0566 | `kg*m^2` |
    /// | `IHxz` | -0.038 | `kg*m^2` |
    /// | `rF` | 0.35231 | `m` |
    /// | `mF` | 2.235 | `kg` |
    /// | `IFxx` | 0.0995 | `kg*m^2` |
    /// | `IFyy` | 0.1902 | `kg*m^2` |
    /// | `kappa` | 10 | `N*s^2` |
    /// | `vo` | 4.7 | `m/s` |
    pub const BALANCEASSISTV1: Self = Self {
        w: 1.113, c: 0.042, lam: 0.255, g: 9.80665, rR: 0.34895, mR: 4.085, IRxx: 0.1023,
        IRyy: 0.1887, xB: 0.519, zB: -0.521, mB: 22.5, IBxx: 1.12, IByy: 3.16, IBzz: 2.119,
        IBxz: 0.047, xH: 0.921, zH: -0.86, mH: 4.3, IHxx: 0.2984, IHyy: 0.257, IHzz: 0.0566,
        IHxz: -0.038, rF: 0.35231, mF: 2.235, IFxx: 0.0995, IFyy: 0.1902, kappa: 10.0, vo: 4.7,
    };
}

impl BalanceAssist<f64> {
    /// The parameter set `benchmark`.
    #[must_use]
    pub const fn default() -> Self {
        Self::BENCHMARK
    }
}

/// The parameter set `benchmark`.
impl<T: Scalar> Default for BalanceAssist<T> {
    fn default() -> Self {
        BalanceAssist::cast(&BalanceAssist::<f64>::BENCHMARK)
    }
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> BalanceAssist<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 28]) -> Self {
        Self {
            w: values[0], c: values[1], lam: values[2], g: values[3], rR: values[4], mR: values[5],
            IRxx: values[6], IRyy: values[7], xB: values[8], zB: values[9], mB: values[10],
            IBxx: values[11], IByy: values[12], IBzz: values[13], IBxz: values[14], xH: values[15],
            zH: values[16], mH: values[17], IHxx: values[18], IHyy: values[19], IHzz: values[20],
            IHxz: values[21], rF: values[22], mF: values[23], IFxx: values[24], IFyy: values[25],
            kappa: values[26], vo: values[27],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 28] {
        [
            self.w, self.c, self.lam, self.g, self.rR, self.mR, self.IRxx, self.IRyy, self.xB,
            self.zB, self.mB, self.IBxx, self.IByy, self.IBzz, self.IBxz, self.xH, self.zH, self.mH,
            self.IHxx, self.IHyy, self.IHzz, self.IHxz, self.rF, self.mF, self.IFxx, self.IFyy,
            self.kappa, self.vo,
        ]
    }
}

impl<T: Scalar> BalanceAssist<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> BalanceAssist<U> {
        let values = self.to_array();
        BalanceAssist::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl BalanceAssist<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> BalanceAssist<f32> {
        BalanceAssist::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<BalanceAssist<f32>> for BalanceAssist<f64> {
    fn from(parameters: BalanceAssist<f32>) -> Self {
        BalanceAssist::cast(&parameters)
    }
}

impl<T: Number> BalanceAssistMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 20]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c0: carvallo::rows(&entries, 4),
            c1: carvallo::rows(&entries, 8),
            k0: carvallo::rows(&entries, 12),
            k2: carvallo::rows(&entries, 16),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 12] {
        [
            self.m[0][0], self.m[0][1], self.m[1][1], self.c0[1][0], self.c1[0][1], self.c1[1][0],
            self.c1[1][1], self.k0[0][0], self.k0[0][1], self.k0[1][1], self.k2[0][1],
            self.k2[1][1],
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
                self.c0[1][0] = entry;
            }
            4 => {
                self.c1[0][1] = entry;
            }
            5 => {
                self.c1[1][0] = entry;
            }
            6 => {
                self.c1[1][1] = entry;
            }
            7 => {
                self.k0[0][0] = entry;
            }
            8 => {
                self.k0[0][1] = entry;
                self.k0[1][0] = entry;
            }
            9 => {
                self.k0[1][1] = entry;
            }
            10 => {
                self.k2[0][1] = entry;
            }
            11 => {
                self.k2[1][1] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, self.c0.0, self.c1.0, zeros, self.k0.0, zeros, self.k2.0]
    }
}

impl<T: Scalar> From<BalanceAssistMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: BalanceAssistMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for BalanceAssist<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 28];

    type Over<U: Number> = BalanceAssist<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "BalanceAssist",
        docs: "A bicycle with a motor that steers into the fall, so that it stays up at lower speeds.\n\nThe Whipple-Carvallo bicycle with a torque on its steer that follows from the lean rate and fades with the speed,\n`kappa*(vo - v)` times the lean rate: up to the speed `vo`, beyond which such a motor is switched off and the bicycle is\n[`Whipple`](crate::Whipple). Axes: origin at the rear contact point, x forward, y to the right, z down.\n\nThe declaration asserts that the matrices are those of Appendix A of the paper, less the torque in C0 and C1.",
        source: "Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3; torque: BicycleParameters, example plot_balanceassistv1.py",
        parameters: &[
            ParameterInfo::new("w", "m", Domain::POSITIVE).docs("Wheel base."),
            ParameterInfo::new("c", "m", Domain::FINITE)
                .docs(
                    "Trail: positive when the front contact is behind the point where the steer axis meets the ground.",
                ),
            ParameterInfo::new(
                    "lam",
                    "rad",
                    Domain::between(Bound::Open(-1.5707963267948966), Bound::Open(1.5707963267948966)),
                )
                .symbol("λ")
                .docs("Steer axis tilt: 90 degrees minus the head angle."),
            ParameterInfo::new("g", "N/kg", Domain::NONNEGATIVE)
                .docs("Gravitational field strength."),
            ParameterInfo::new("rR", "m", Domain::POSITIVE)
                .docs("Radius of the rear wheel."),
            ParameterInfo::new("mR", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the rear wheel."),
            ParameterInfo::new("IRxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Radial moment of inertia of the rear wheel; by symmetry also about the vertical."),
            ParameterInfo::new("IRyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Axial moment of inertia of the rear wheel."),
            ParameterInfo::new("xB", "m", Domain::FINITE)
                .docs("Centre of mass of the rear frame and rider, forward of the rear contact."),
            ParameterInfo::new("zB", "m", Domain::FINITE)
                .docs("Centre of mass of the rear frame and rider, downward."),
            ParameterInfo::new("mB", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the rear frame and rider."),
            ParameterInfo::new("IBxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the rear frame and rider about its centre of mass, in roll."),
            ParameterInfo::new("IByy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the rear frame and rider about its centre of mass, in pitch.")
                .unused(),
            ParameterInfo::new("IBzz", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the rear frame and rider about its centre of mass, in yaw."),
            ParameterInfo::new("IBxz", "kg*m^2", Domain::FINITE)
                .docs("Product of inertia of the rear frame and rider about its centre of mass."),
            ParameterInfo::new("xH", "m", Domain::FINITE)
                .docs("Centre of mass of the front frame, forward of the rear contact."),
            ParameterInfo::new("zH", "m", Domain::FINITE)
                .docs("Centre of mass of the front frame, downward."),
            ParameterInfo::new("mH", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the front frame."),
            ParameterInfo::new("IHxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the front frame about its centre of mass, in roll."),
            ParameterInfo::new("IHyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the front frame about its centre of mass, in pitch.")
                .unused(),
            ParameterInfo::new("IHzz", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Moment of inertia of the front frame about its centre of mass, in yaw."),
            ParameterInfo::new("IHxz", "kg*m^2", Domain::FINITE)
                .docs("Product of inertia of the front frame about its centre of mass."),
            ParameterInfo::new("rF", "m", Domain::POSITIVE)
                .docs("Radius of the front wheel."),
            ParameterInfo::new("mF", "kg", Domain::NONNEGATIVE)
                .docs("Mass of the front wheel."),
            ParameterInfo::new("IFxx", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Radial moment of inertia of the front wheel; by symmetry also about the vertical."),
            ParameterInfo::new("IFyy", "kg*m^2", Domain::NONNEGATIVE)
                .docs("Axial moment of inertia of the front wheel."),
            ParameterInfo::new("kappa", "N*s^2", Domain::NONNEGATIVE)
                .symbol("κ")
                .docs("Steer torque by lean rate, for each m/s that the bicycle is slower than `vo`."),
            ParameterInfo::new("vo", "m/s", Domain::POSITIVE)
                .docs("The speed from which the motor leaves the bicycle alone."),
        ],
        coordinates: &[
            CoordinateInfo::new("phi", "rad")
                .label("lean")
                .docs("Lean of the rear frame, positive to the right."),
            CoordinateInfo::new("delta", "rad")
                .label("steer")
                .docs("Steer of the front frame relative to the rear frame, positive to the right."),
        ],
        forces: &[
            carvallo::motion::AppliedInfo {
                name: "Tphi", label: "lean torque", unit: "N*m", position: "phi",
            },
            carvallo::motion::AppliedInfo {
                name: "Tdelta", label: "steer torque", unit: "N*m", position: "delta",
            },
        ],
        matrices: &[
            MatrixName::M, MatrixName::C0, MatrixName::C1, MatrixName::K0, MatrixName::K2,
        ],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]), EntryInfo::at(&[(MatrixName::C0, 1, 0)]),
            EntryInfo::at(&[(MatrixName::C1, 0, 1)]), EntryInfo::at(&[(MatrixName::C1, 1, 0)]),
            EntryInfo::at(&[(MatrixName::C1, 1, 1)]), EntryInfo::at(&[(MatrixName::K0, 0, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 1, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 0, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 1, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "benchmark",
                docs: "",
                source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; motor: an example of BicycleParameters, plot_balanceassistv1.py",
                values: &BalanceAssist::to_array(&BalanceAssist::<f64>::BENCHMARK),
            },
            SetInfo {
                name: "balanceassistv1",
                docs: "",
                source: "BicycleParameters 1.5.2 (BSD), Balanceassistv1Benchmark.txt, an electric bicycle without a rider; motor: an example of BicycleParameters, plot_balanceassistv1.py",
                values: &BalanceAssist::to_array(&BalanceAssist::<f64>::BALANCEASSISTV1),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("mA", "kg", "mH + mF"),
            FormulaInfo::definition("mu", "1", "(c/w)*cos(lam)"),
            FormulaInfo::definition("SR", "kg*m", "IRyy/rR"),
            FormulaInfo::definition("SF", "kg*m", "IFyy/rF"),
            FormulaInfo::definition("ST", "kg*m", "SR + SF"),
            FormulaInfo::definition("yaw_per_v_delta", "1/m", "cos(lam)/w"),
            FormulaInfo::definition("Jxx_delta", "kg*m^2", "IHxx + IFxx + zH^2*mH + rF^2*mF"),
            FormulaInfo::definition("Jxz_delta", "kg*m^2", "IHxz - c*rF*mF - zH*mH*(xH - (w + c))"),
            FormulaInfo::definition("Jzz_delta", "kg*m^2", "mH*(xH - (w + c))^2 + IHzz + IFxx + c^2*mF"),
            FormulaInfo::definition("Sx_delta", "kg*m", "mH*(xH - (w + c)) - c*mF"),
            FormulaInfo::definition("Sz_delta", "kg*m", "zH*mH - rF*mF"),
            FormulaInfo::definition("py_delta", "kg*m", "Sx_delta*cos(lam) - Sz_delta*sin(lam)"),
            FormulaInfo::definition("hx_delta", "kg*m^2", "Jxx_delta*sin(lam) + Jxz_delta*cos(lam)"),
            FormulaInfo::definition("hz_delta", "kg*m^2", "Jxz_delta*sin(lam) + Jzz_delta*cos(lam)"),
            FormulaInfo::definition("Jxx_all", "kg*m^2", "IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB"),
            FormulaInfo::definition("Jxz_all", "kg*m^2", "IBxz + Jxz_delta - xB*zB*mB - Sz_delta*(w + c)"),
            FormulaInfo::definition(
                "Jzz_all",
                "kg*m^2",
                "IRxx + IBzz + Jzz_delta + 2*(w + c)*((1/2)*mA*(w + c) + Sx_delta) + xB^2*mB",
            ),
            FormulaInfo::definition("Sx_all", "kg*m", "xB*mB + mA*(w + c) + Sx_delta"),
            FormulaInfo::definition("Sz_all", "kg*m", "zB*mB + Sz_delta - rR*mR"),
            FormulaInfo::definition("load_spin_F", "kg", "-Sx_all/w"),
            FormulaInfo::definition("M_yaw_delta", "kg*m^2", "py_delta*(w + c) + hz_delta"),
            FormulaInfo::definition("M_delta_delta", "kg*m^2", "hx_delta*sin(lam) + hz_delta*cos(lam)"),
            FormulaInfo::definition("K_phi_delta", "kg*m", "c*load_spin_F*cos(lam) - py_delta"),
            FormulaInfo::definition("K_delta_delta", "kg*m", "(c*load_spin_F*cos(lam) - py_delta)*sin(lam)"),
            FormulaInfo::definition("P_delta_lateral", "kg*m", "mu*Sx_all + py_delta"),
            FormulaInfo::definition("P_delta_yaw", "kg*m^2", "mu*Jzz_all + M_yaw_delta"),
            FormulaInfo::definition("P_delta_delta", "kg*m^2", "mu*M_yaw_delta + M_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "Jxx_all"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)], "kg*m^2", "mu*Jxz_all + hx_delta"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "mu*P_delta_yaw + P_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::C0, 1, 0)], "kg*m^2/s", "-kappa*vo"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 1)],
                "kg*m",
                "mu*(ST - Sz_all) + SF*cos(lam) + yaw_per_v_delta*Jxz_all",
            ),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 0)], "kg*m", "kappa - mu*ST - SF*cos(lam)"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 1)], "kg*m", "mu*P_delta_lateral + yaw_per_v_delta*P_delta_yaw"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "Sz_all"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)], "kg*m", "K_phi_delta"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "K_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg", "yaw_per_v_delta*(ST - Sz_all)"),
            FormulaInfo::entry(&[(MatrixName::K2, 1, 1)], "kg", "yaw_per_v_delta*(SF*sin(lam) + P_delta_lateral)"),
        ],
        attributes: &[
            FormulaInfo::attribute("B_mass", "the mass of the rear frame and rider B", "kg", "mB"),
            FormulaInfo::attribute("B_x", "x of the centre of mass of the rear frame and rider B", "m", "xB"),
            FormulaInfo::attribute("B_z", "z of the centre of mass of the rear frame and rider B", "m", "zB"),
            FormulaInfo::attribute("B_Ixx", "the inertia xx of the rear frame and rider B", "kg*m^2", "IBxx"),
            FormulaInfo::attribute("B_Ixz", "the inertia xz of the rear frame and rider B", "kg*m^2", "IBxz"),
            FormulaInfo::attribute("B_Izz", "the inertia zz of the rear frame and rider B", "kg*m^2", "IBzz"),
            FormulaInfo::attribute("H_mass", "the mass of the front frame H", "kg", "mH"),
            FormulaInfo::attribute("H_x", "x of the centre of mass of the front frame H", "m", "xH"),
            FormulaInfo::attribute("H_z", "z of the centre of mass of the front frame H", "m", "zH"),
            FormulaInfo::attribute("H_Ixx", "the inertia xx of the front frame H", "kg*m^2", "IHxx"),
            FormulaInfo::attribute("H_Ixz", "the inertia xz of the front frame H", "kg*m^2", "IHxz"),
            FormulaInfo::attribute("H_Izz", "the inertia zz of the front frame H", "kg*m^2", "IHzz"),
            FormulaInfo::attribute("R_mass", "the mass of the rear wheel R", "kg", "mR"),
            FormulaInfo::attribute("R_radius", "the radius of the rear wheel R", "m", "rR"),
            FormulaInfo::attribute("R_axial", "the axial inertia of the rear wheel R", "kg*m^2", "IRyy"),
            FormulaInfo::attribute("R_radial", "the radial inertia of the rear wheel R", "kg*m^2", "IRxx"),
            FormulaInfo::attribute("R_z", "z of the centre of the rear wheel R", "m", "-rR"),
            FormulaInfo::attribute("F_mass", "the mass of the front wheel F", "kg", "mF"),
            FormulaInfo::attribute("F_radius", "the radius of the front wheel F", "m", "rF"),
            FormulaInfo::attribute("F_axial", "the axial inertia of the front wheel F", "kg*m^2", "IFyy"),
            FormulaInfo::attribute("F_radial", "the radial inertia of the front wheel F", "kg*m^2", "IFxx"),
            FormulaInfo::attribute("F_x", "x of the centre of the front wheel F", "m", "w"),
            FormulaInfo::attribute("F_z", "z of the centre of the front wheel F", "m", "-rF"),
            FormulaInfo::attribute("delta_through_x", "x of the point of the joint delta", "m", "w + c"),
            FormulaInfo::attribute("delta_along_x", "x of the axis of the joint delta", "1", "sin(lam)"),
            FormulaInfo::attribute("delta_along_z", "z of the axis of the joint delta", "1", "cos(lam)"),
            FormulaInfo::definition("length_delta", "1", "sqrt(delta_along_x^2 + delta_along_z^2)"),
            FormulaInfo::definition("pitch_by_vertical", "1/m", "1/F_x"),
            FormulaInfo::definition("yaw_by_phi", "1", "(F_radius + F_z)/F_x"),
            FormulaInfo::definition(
                "yaw_by_delta",
                "1",
                "-(delta_along_z*(F_x - delta_through_x) - delta_along_x*(F_radius + F_z))/F_x/length_delta",
            ),
            FormulaInfo::definition("yaw_per_v_delta", "1/m", "delta_along_z/F_x/length_delta"),
            FormulaInfo::definition("lateral_by_phi", "m", "R_radius + R_z"),
            FormulaInfo::definition("yaw_by_phi_", "1", "yaw_by_phi - pitch_by_vertical*lateral_by_phi"),
            FormulaInfo::definition("Jxx_delta", "kg*m^2", "H_mass*H_z^2 + H_Ixx + F_mass*F_z^2 + F_radial"),
            FormulaInfo::definition(
                "Jxz_delta",
                "kg*m^2",
                "H_Ixz - H_mass*H_z*(H_x - delta_through_x) - F_mass*F_z*(F_x - delta_through_x)",
            ),
            FormulaInfo::definition(
                "Jzz_delta",
                "kg*m^2",
                "H_mass*(H_x - delta_through_x)^2 + H_Izz + F_mass*(F_x - delta_through_x)^2 + F_radial",
            ),
            FormulaInfo::definition(
                "Sx_delta",
                "kg*m",
                "H_mass*(H_x - delta_through_x) + F_mass*(F_x - delta_through_x)",
            ),
            FormulaInfo::definition("Sz_delta", "kg*m", "H_mass*H_z + F_mass*F_z"),
            FormulaInfo::definition("m_delta", "kg", "H_mass + F_mass"),
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
            FormulaInfo::definition("Jxx_all", "kg*m^2", "B_mass*B_z^2 + B_Ixx + R_mass*R_z^2 + R_radial + Jxx_delta"),
            FormulaInfo::definition(
                "Jxz_all",
                "kg*m^2",
                "B_Ixz + Jxz_delta - B_mass*B_x*B_z - delta_through_x*Sz_delta",
            ),
            FormulaInfo::definition(
                "Jzz_all",
                "kg*m^2",
                "B_mass*B_x^2 + B_Izz + R_radial + 2*delta_through_x*((1/2)*delta_through_x*m_delta + Sx_delta) + Jzz_delta",
            ),
            FormulaInfo::definition("Sx_all", "kg*m", "B_mass*B_x + delta_through_x*m_delta + Sx_delta"),
            FormulaInfo::definition("Sz_all", "kg*m", "B_mass*B_z + R_mass*R_z + Sz_delta"),
            FormulaInfo::definition("m_all", "kg", "B_mass + R_mass + m_delta"),
            FormulaInfo::definition("load_spin_F", "kg", "-Sx_all/F_x"),
            FormulaInfo::definition("load_spin_R", "kg", "-(m_all + load_spin_F)"),
            FormulaInfo::definition("h_spin_R", "kg*m", "R_axial/R_radius"),
            FormulaInfo::definition("h_spin_F", "kg*m", "F_axial/F_radius"),
            FormulaInfo::definition("h_wheels_all", "kg*m", "h_spin_R + h_spin_F"),
            FormulaInfo::definition("M_yaw_delta", "kg*m^2", "delta_through_x*py_delta + hz_delta"),
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
            FormulaInfo::entry(&[(MatrixName::C0, 1, 0)], "kg*m^2/s", "-kappa*vo"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 0)], "kg*m", "yaw_by_phi_*P_phi_lateral"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 1)],
                "kg*m",
                "(delta_along_z*h_spin_F + length_delta*yaw_by_delta*(h_wheels_all + P_phi_lateral) + length_delta*yaw_per_v_delta*P_phi_yaw - delta_along_x*yaw_by_phi_*h_spin_F)/length_delta",
            ),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 0)],
                "kg*m",
                "(kappa*length_delta + yaw_by_phi_*(delta_along_x*h_spin_F + length_delta*P_delta_lateral) - delta_along_z*h_spin_F - length_delta*yaw_by_delta*h_wheels_all)/length_delta",
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
                "yaw_per_v_delta*(delta_along_x*h_spin_F/length_delta + P_delta_lateral)",
            ),
        ],
        motion: None,
        gravity: Some(3),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("BalanceAssist", 28, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("BalanceAssist", 28, values)?;
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
        Coefficients::from_rows(BalanceAssistMatrices::rows(&self.matrices()))
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

impl BalanceAssist<f64> {
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
impl<T: Scalar> core::fmt::Display for BalanceAssist<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for BalanceAssist<T> {
    type Entries = [T; 12];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            w: parameter(0), c: parameter(1), lam: parameter(2), g: parameter(3), rR: parameter(4),
            mR: parameter(5), IRxx: parameter(6), IRyy: parameter(7), xB: parameter(8),
            zB: parameter(9), mB: parameter(10), IBxx: parameter(11), IByy: parameter(12),
            IBzz: parameter(13), IBxz: parameter(14), xH: parameter(15), zH: parameter(16),
            mH: parameter(17), IHxx: parameter(18), IHyy: parameter(19), IHzz: parameter(20),
            IHxz: parameter(21), rF: parameter(22), mF: parameter(23), IFxx: parameter(24),
            IFyy: parameter(25), kappa: parameter(26), vo: parameter(27),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        BalanceAssistMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        BalanceAssistMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> BalanceAssistDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<BalanceAssistMatrices<T>> {
        if parameter >= 28 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = BalanceAssistMatrices {
            m: Rows([[zero; 2]; 2]), c0: Rows([[zero; 2]; 2]), c1: Rows([[zero; 2]; 2]),
            k0: Rows([[zero; 2]; 2]), k2: Rows([[zero; 2]; 2]),
        };
        for position in 0..161 {
            let partial = <BalanceAssistDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C0 => &mut matrices.c0,
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

impl<T: Scalar> Differentiable<2> for BalanceAssist<T> {
    type Derivatives = [Coefficients<T, 2>; 28];

    type WithDerivativesOver<U: Number> = BalanceAssist<U>;

    const PARTIALS: &'static [Partial] = <BalanceAssistDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 28];
        for position in 0..161 {
            Partial::write(&<BalanceAssistDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(BalanceAssistMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for BalanceAssist<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl BalanceAssistDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 161] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 41), Partial::new(MatrixName::M, 1, 0, 0, 41),
        Partial::new(MatrixName::M, 1, 1, 0, 73), Partial::new(MatrixName::C1, 0, 1, 0, 42),
        Partial::new(MatrixName::C1, 1, 0, 0, 48), Partial::new(MatrixName::C1, 1, 1, 0, 79),
        Partial::new(MatrixName::K0, 0, 1, 0, 54), Partial::new(MatrixName::K0, 1, 0, 0, 54),
        Partial::new(MatrixName::K0, 1, 1, 0, 58),
        Partial::new(MatrixName::K2, 0, 1, 0, 38).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 59).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 27), Partial::new(MatrixName::M, 1, 0, 1, 27),
        Partial::new(MatrixName::M, 1, 1, 1, 74), Partial::new(MatrixName::C1, 0, 1, 1, 36),
        Partial::new(MatrixName::C1, 1, 0, 1, 47).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 78), Partial::new(MatrixName::K0, 0, 1, 1, 51),
        Partial::new(MatrixName::K0, 1, 0, 1, 51), Partial::new(MatrixName::K0, 1, 1, 1, 52),
        Partial::new(MatrixName::K2, 1, 1, 1, 53).negative(),
        Partial::new(MatrixName::M, 0, 1, 2, 62),
        Partial::new(MatrixName::M, 1, 0, 2, 62),
        Partial::new(MatrixName::M, 1, 1, 2, 45).negative(),
        Partial::new(MatrixName::C1, 0, 1, 2, 43).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 63),
        Partial::new(MatrixName::C1, 1, 1, 2, 66),
        Partial::new(MatrixName::K0, 0, 1, 2, 64).negative(),
        Partial::new(MatrixName::K0, 1, 0, 2, 64).negative(),
        Partial::new(MatrixName::K0, 1, 1, 2, 67).negative(),
        Partial::new(MatrixName::K2, 0, 1, 2, 35).negative(),
        Partial::new(MatrixName::K2, 1, 1, 2, 65),
        Partial::new(MatrixName::M, 0, 0, 4, 13),
        Partial::new(MatrixName::C1, 0, 1, 4, 75).negative(),
        Partial::new(MatrixName::C1, 1, 0, 4, 72),
        Partial::new(MatrixName::K0, 0, 0, 4, 1).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 76), Partial::new(MatrixName::M, 0, 0, 5, 14),
        Partial::new(MatrixName::C1, 0, 1, 5, 80),
        Partial::new(MatrixName::K0, 0, 0, 5, 0).negative(),
        Partial::new(MatrixName::K2, 0, 1, 5, 77), Partial::new(MatrixName::M, 0, 0, 6, 10),
        Partial::new(MatrixName::M, 1, 1, 6, 81), Partial::new(MatrixName::C1, 1, 1, 6, 83),
        Partial::new(MatrixName::C1, 0, 1, 7, 71),
        Partial::new(MatrixName::C1, 1, 0, 7, 71).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 28),
        Partial::new(MatrixName::M, 0, 1, 8, 86).negative(),
        Partial::new(MatrixName::M, 1, 0, 8, 86).negative(),
        Partial::new(MatrixName::M, 1, 1, 8, 34),
        Partial::new(MatrixName::C1, 0, 1, 8, 23).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 89),
        Partial::new(MatrixName::K0, 0, 1, 8, 85).negative(),
        Partial::new(MatrixName::K0, 1, 0, 8, 85).negative(),
        Partial::new(MatrixName::K0, 1, 1, 8, 87).negative(),
        Partial::new(MatrixName::K2, 1, 1, 8, 84), Partial::new(MatrixName::M, 0, 0, 9, 15),
        Partial::new(MatrixName::M, 0, 1, 9, 33).negative(),
        Partial::new(MatrixName::M, 1, 0, 9, 33).negative(),
        Partial::new(MatrixName::C1, 0, 1, 9, 91).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 3),
        Partial::new(MatrixName::K2, 0, 1, 9, 24).negative(),
        Partial::new(MatrixName::M, 0, 0, 10, 16),
        Partial::new(MatrixName::M, 0, 1, 10, 30).negative(),
        Partial::new(MatrixName::M, 1, 0, 10, 30).negative(),
        Partial::new(MatrixName::M, 1, 1, 10, 31),
        Partial::new(MatrixName::C1, 0, 1, 10, 92).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 90),
        Partial::new(MatrixName::K0, 0, 0, 10, 2),
        Partial::new(MatrixName::K0, 0, 1, 10, 29).negative(),
        Partial::new(MatrixName::K0, 1, 0, 10, 29).negative(),
        Partial::new(MatrixName::K0, 1, 1, 10, 32).negative(),
        Partial::new(MatrixName::K2, 0, 1, 10, 25).negative(),
        Partial::new(MatrixName::K2, 1, 1, 10, 88), Partial::new(MatrixName::M, 0, 0, 11, 10),
        Partial::new(MatrixName::M, 1, 1, 13, 81), Partial::new(MatrixName::C1, 1, 1, 13, 83),
        Partial::new(MatrixName::M, 0, 1, 14, 21), Partial::new(MatrixName::M, 1, 0, 14, 21),
        Partial::new(MatrixName::C1, 0, 1, 14, 22),
        Partial::new(MatrixName::M, 0, 1, 15, 40).negative(),
        Partial::new(MatrixName::M, 1, 0, 15, 40).negative(),
        Partial::new(MatrixName::M, 1, 1, 15, 61).negative(),
        Partial::new(MatrixName::C1, 0, 1, 15, 26).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 82),
        Partial::new(MatrixName::K0, 0, 1, 15, 49).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 49).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 50).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 94), Partial::new(MatrixName::M, 0, 0, 16, 17),
        Partial::new(MatrixName::M, 0, 1, 16, 60), Partial::new(MatrixName::M, 1, 0, 16, 60),
        Partial::new(MatrixName::M, 1, 1, 16, 96),
        Partial::new(MatrixName::C1, 0, 1, 16, 99).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 101).negative(),
        Partial::new(MatrixName::K0, 0, 0, 16, 5), Partial::new(MatrixName::K0, 0, 1, 16, 20),
        Partial::new(MatrixName::K0, 1, 0, 16, 20), Partial::new(MatrixName::K0, 1, 1, 16, 103),
        Partial::new(MatrixName::K2, 0, 1, 16, 93).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 100).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 18), Partial::new(MatrixName::M, 0, 1, 17, 55),
        Partial::new(MatrixName::M, 1, 0, 17, 55), Partial::new(MatrixName::M, 1, 1, 17, 56),
        Partial::new(MatrixName::C1, 0, 1, 17, 105).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 98).negative(),
        Partial::new(MatrixName::K0, 0, 0, 17, 4), Partial::new(MatrixName::K0, 0, 1, 17, 44),
        Partial::new(MatrixName::K0, 1, 0, 17, 44), Partial::new(MatrixName::K0, 1, 1, 17, 95),
        Partial::new(MatrixName::K2, 0, 1, 17, 104).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 97).negative(),
        Partial::new(MatrixName::M, 0, 0, 18, 10), Partial::new(MatrixName::M, 0, 1, 18, 11),
        Partial::new(MatrixName::M, 1, 0, 18, 11), Partial::new(MatrixName::M, 1, 1, 18, 102),
        Partial::new(MatrixName::M, 1, 1, 20, 106), Partial::new(MatrixName::C1, 1, 1, 20, 39),
        Partial::new(MatrixName::M, 0, 1, 21, 37), Partial::new(MatrixName::M, 1, 0, 21, 37),
        Partial::new(MatrixName::M, 1, 1, 21, 46), Partial::new(MatrixName::C1, 0, 1, 21, 22),
        Partial::new(MatrixName::C1, 1, 1, 21, 110), Partial::new(MatrixName::M, 0, 0, 22, 19),
        Partial::new(MatrixName::M, 0, 1, 22, 68), Partial::new(MatrixName::M, 1, 0, 22, 68),
        Partial::new(MatrixName::M, 1, 1, 22, 114).negative(),
        Partial::new(MatrixName::C1, 0, 1, 22, 118),
        Partial::new(MatrixName::C1, 1, 0, 22, 109),
        Partial::new(MatrixName::C1, 1, 1, 22, 119),
        Partial::new(MatrixName::K0, 0, 0, 22, 7).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 120).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 120).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 121).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 117),
        Partial::new(MatrixName::K2, 1, 1, 22, 124).negative(),
        Partial::new(MatrixName::M, 0, 0, 23, 12),
        Partial::new(MatrixName::M, 0, 1, 23, 69).negative(),
        Partial::new(MatrixName::M, 1, 0, 23, 69).negative(),
        Partial::new(MatrixName::M, 1, 1, 23, 70),
        Partial::new(MatrixName::C1, 0, 1, 23, 123),
        Partial::new(MatrixName::C1, 1, 1, 23, 116).negative(),
        Partial::new(MatrixName::K0, 0, 0, 23, 6).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 57), Partial::new(MatrixName::K0, 1, 0, 23, 57),
        Partial::new(MatrixName::K0, 1, 1, 23, 113), Partial::new(MatrixName::K2, 0, 1, 23, 122),
        Partial::new(MatrixName::K2, 1, 1, 23, 115).negative(),
        Partial::new(MatrixName::M, 0, 0, 24, 10), Partial::new(MatrixName::M, 0, 1, 24, 11),
        Partial::new(MatrixName::M, 1, 0, 24, 11), Partial::new(MatrixName::M, 1, 1, 24, 107),
        Partial::new(MatrixName::C1, 1, 1, 24, 39), Partial::new(MatrixName::C1, 0, 1, 25, 108),
        Partial::new(MatrixName::C1, 1, 0, 25, 108).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 112),
        Partial::new(MatrixName::K2, 1, 1, 25, 111),
        Partial::new(MatrixName::C0, 1, 0, 26, 9).negative(),
        Partial::new(MatrixName::C1, 1, 0, 26, 10),
        Partial::new(MatrixName::C0, 1, 0, 27, 8).negative(),
    ];
}
