// @generated from generated/models/whipple_sprung.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 578b2dd2541ebae4

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// The Whipple-Carvallo bicycle with a spring and a damper between rear frame and front frame.
///
/// Four rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally
/// symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,
/// x forward, y to the right, z down, so that a centre of mass above the ground has z < 0.
///
/// Source: Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3
///
/// Derived from a mechanism: body `B` (rear frame and rider), body `H` (front frame), wheel `R` (rear wheel), wheel `F` (front wheel).
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
/// yaw_per_v_delta = cos(lam)/w [1/m]
/// Jxx_delta = IHxx + IFxx + zH^2*mH + rF^2*mF [kg*m^2]
/// Jxz_delta = IHxz - c*rF*mF - zH*mH*(xH - (w + c)) [kg*m^2]
/// Jzz_delta = mH*(xH - (w + c))^2 + IHzz + IFxx + c^2*mF [kg*m^2]
/// Sx_delta = mH*(xH - (w + c)) - c*mF [kg*m]
/// Sz_delta = zH*mH - rF*mF [kg*m]
/// m_delta = mH + mF [kg]
/// py_delta = Sx_delta*cos(lam) - Sz_delta*sin(lam) [kg*m]
/// hx_delta = Jxx_delta*sin(lam) + Jxz_delta*cos(lam) [kg*m^2]
/// hz_delta = Jxz_delta*sin(lam) + Jzz_delta*cos(lam) [kg*m^2]
/// Jxx_all = IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB [kg*m^2]
/// Jxz_all = IBxz + Jxz_delta - xB*zB*mB - Sz_delta*(w + c) [kg*m^2]
/// Jzz_all = IRxx + IBzz + IHzz + IFxx + w^2*mF + xB^2*mB + xH^2*mH [kg*m^2]
/// Sx_all = xB*mB + Sx_delta + m_delta*(w + c) [kg*m]
/// Sz_all = zB*mB + Sz_delta - rR*mR [kg*m]
/// load_spin_F = -Sx_all/w [kg]
/// h_spin_R = IRyy/rR [kg*m]
/// h_spin_F = IFyy/rF [kg*m]
/// h_wheels_all = h_spin_R + h_spin_F [kg*m]
/// M_yaw_delta = py_delta*(w + c) + hz_delta [kg*m^2]
/// M_delta_delta = hx_delta*sin(lam) + hz_delta*cos(lam) [kg*m^2]
/// K_phi_delta = c*load_spin_F*cos(lam) - py_delta [kg*m]
/// K_delta_delta = (c*load_spin_F*cos(lam) - py_delta)*sin(lam) [kg*m]
/// P_delta_lateral = yaw_by_delta*Sx_all + py_delta [kg*m]
/// P_delta_yaw = yaw_by_delta*Jzz_all + M_yaw_delta [kg*m^2]
/// P_delta_delta = yaw_by_delta*M_yaw_delta + M_delta_delta [kg*m^2]
/// M_11 = Jxx_all [kg*m^2]
/// M_12 = M_21 = yaw_by_delta*Jxz_all + hx_delta [kg*m^2]
/// M_22 = yaw_by_delta*P_delta_yaw + P_delta_delta [kg*m^2]
/// C0_22 = d [kg*m^2/s]
/// C1_12 = yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_F*cos(lam) [kg*m]
/// C1_21 = -(yaw_by_delta*h_wheels_all + h_spin_F*cos(lam)) [kg*m]
/// C1_22 = yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
/// Kc_22 = k [kg*m^2/s^2]
/// K0_11 = Sz_all [kg*m]
/// K0_12 = K0_21 = K_phi_delta [kg*m]
/// K0_22 = K_delta_delta [kg*m]
/// K2_12 = yaw_per_v_delta*(h_wheels_all - Sz_all) [kg]
/// K2_22 = yaw_per_v_delta*(h_spin_F*sin(lam) + P_delta_lateral) [kg]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct WhippleSprung<T = f64> {
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
    /// Stiffness of the steering spring.
    ///
    /// `k` in `N*m`: `>= 0`.
    pub k: T,
    /// Damping of the steering damper.
    ///
    /// `d` in `N*m*s`: `>= 0`.
    pub d: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`WhippleSprung`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleSprungMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C0, a coefficient of q'. Symmetric, proved.
    pub c0: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness Kc, a coefficient of q. Symmetric, proved.
    pub kc: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 2>,
}

impl<T: Number> WhippleSprung<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 40 additions, 43 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 89 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleSprungMatrices<T> {
        let t2 = self.zH * self.mH;
        let t7 = self.zB * self.mB;
        let t13 = self.rR * self.mR;
        let t18 = self.rF * self.mF;
        let ay_delta2_delta = self.IHxx + self.IFxx;
        let t23 = self.rF * t18 + ay_delta2_delta;
        let M_11 = self.zH * t2 + (self.IRxx + self.zB * t7)
            + (self.rR * t13 + (self.IBxx + t23));
        let (wx_delta2_delta, cos_lam) = self.lam.sin_cos();
        let yaw_per_v_delta = cos_lam / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let wz_delta2_delta = cos_lam + yaw_by_delta;
        let t35 = self.IHxz * wz_delta2_delta;
        let t38 = t35 + wx_delta2_delta * t23;
        let t42 = self.IBxz - t7 * self.xB;
        let vy_spin_F4_delta = cos_lam * (self.c + self.w);
        let t51 = vy_spin_F4_delta
            + (self.zH * wx_delta2_delta - self.xH * wz_delta2_delta);
        let t52 = self.mH * t51;
        let M_12 = t38 + yaw_by_delta * t42 + self.zH * t52;
        let t57 = wz_delta2_delta * (self.IFxx + self.IHzz);
        let t60 = self.mB * self.xB;
        let t64 = yaw_by_delta * (self.IRxx + (self.IBzz + self.xB * t60));
        let M_22 = wz_delta2_delta * t57 + yaw_by_delta * t64
            + (t51 * t52 + wx_delta2_delta * (t38 + t35));
        let zero = self.w.like(0.0);
        let vy_all1_delta = t18 * wz_delta2_delta + yaw_per_v_delta * self.IHxz;
        let t78 = t7 + t2 - t13;
        let h_spin_R = self.IRyy / self.rR;
        let h_spin_F = self.IFyy / self.rF;
        let t91 = yaw_by_delta * h_spin_R + wz_delta2_delta * h_spin_F;
        let C1_12 = vy_all1_delta - yaw_per_v_delta * (self.c * t78 + t2 * self.xH - t42)
            + t91;
        let t96 = t52 - yaw_by_delta * t60;
        let h_wheels_all = (self.xH * t52 - t64 + self.c * t96 - t57) * yaw_per_v_delta;
        let K0_11 = t78 - t18;
        let K0_12 = t96 - t18 * wx_delta2_delta;
        let K0_22 = wx_delta2_delta * K0_12;
        let K2_12 = yaw_per_v_delta * (h_spin_R + h_spin_F - K0_11);
        let K2_22 = yaw_per_v_delta * (wx_delta2_delta * h_spin_F - K0_12);
        let C1_21 = -t91;
        let C1_22 = vy_all1_delta * wx_delta2_delta - h_wheels_all;
        WhippleSprungMatrices::from_entries([
            M_11, M_12, M_12, M_22, zero, zero, zero, self.d, zero, C1_12, C1_21, C1_22, zero, zero,
            zero, self.k, K0_11, K0_12, K0_12, K0_22, zero, K2_12, zero, K2_22,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`WhippleSprung`] that follow from its coordinates q = (`phi`, `delta`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleSprungKinematics<T = f64> {
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

impl<T: Scalar> WhippleSprung<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> WhippleSprungKinematics<T> {
        let zero = self.w.like(0.0);
        let yaw_per_v_delta = self.lam.cos() / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let t12 = -(self.w.like(1.0) / self.rR);
        let t13 = -(self.w.like(1.0) / self.rF);
        WhippleSprungKinematics {
            lateral: Rate {
                speed: zero, rates: [zero, zero], coordinates: [zero, zero],
                heading: self.w.like(1.0),
            },
            yaw: Rate {
                speed: zero, rates: [zero, yaw_by_delta], coordinates: [zero, yaw_per_v_delta],
                heading: zero,
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

/// The derivatives of the matrices of [`WhippleSprung`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleSprungDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 123],
}

impl<T: Number> WhippleSprung<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 93 additions, 179 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 278 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WhippleSprungMatrices<T>, WhippleSprungDerivatives<T>) {
        let zero = self.w.like(0.0);
        let mut matrices = WhippleSprungMatrices::from_entries([zero; 24]);
        let mut derivatives = WhippleSprungDerivatives {
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
        matrices: &mut WhippleSprungMatrices<T>,
        derivatives: &mut WhippleSprungDerivatives<T>,
    ) {
        *matrices = WhippleSprungMatrices::from_entries([self.w.like(0.0); 24]);
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
        put_entry(3, self.d);
        put_entry(7, self.k);
        put_derivative(0, self.rR);
        put_derivative(1, self.mR);
        put_derivative(2, self.zB);
        put_derivative(3, self.mB);
        put_derivative(4, self.zH);
        put_derivative(5, self.mH);
        put_derivative(6, self.rF);
        put_derivative(7, self.mF);
        put_derivative(8, self.w.like(1.0));
        let (wx_delta2_delta, wx_delta2_delta_lam) = self.lam.sin_cos();
        put_derivative(9, wx_delta2_delta);
        let t29 = self.rF * self.mF;
        let t32 = self.rF * t29 + self.IHxx + self.IFxx;
        let M_11_mH = self.zH * self.zH;
        put_derivative(10, M_11_mH);
        let M_11_mR = self.rR * self.rR;
        put_derivative(11, M_11_mR);
        let M_11_mB = self.zB * self.zB;
        put_derivative(12, M_11_mB);
        let t36 = self.mB * self.xB;
        let M_12_yaw_by_delta = self.IHxz + self.IBxz - self.zB * t36;
        let t40 = self.w.like(1.0) / self.w;
        let t41 = self.mH * self.zH;
        let M_11_zH = t41 + t41;
        put_derivative(13, M_11_zH);
        let t43 = self.IFxx + self.IHzz;
        let t46 = self.IRxx + self.IBzz + self.xB * t36;
        let M_11 = t32 + self.mH * M_11_mH + self.IRxx + self.mR * M_11_mR + self.IBxx
            + self.mB * M_11_mB;
        put_entry(0, M_11);
        let t55 = self.c * t40;
        let t56 = t55 * self.xH;
        let t57 = self.w.like(1.0) / self.rF;
        let t60 = t40 * (t41 * self.xH - M_12_yaw_by_delta);
        let t61 = self.w.like(1.0) / self.rR;
        let h_spin_F = self.IFyy * t57;
        let t63 = self.mR * self.rR;
        let M_11_rR = t63 + t63;
        put_derivative(14, M_11_rR);
        let t67 = self.c + self.w - self.xH - t56;
        let h_spin_R = self.IRyy * t61;
        let t69 = self.mB * self.zB;
        let M_11_zB = t69 + t69;
        put_derivative(15, M_11_zB);
        let t72 = t41 + t69 - t29;
        let t73 = self.c + self.xH;
        let t74 = self.xB + self.c;
        let M_11_rF = t29 + t29;
        put_derivative(16, M_11_rF);
        let t76 = h_spin_F + h_spin_R;
        let t77 = t61 * h_spin_R;
        let K0_11 = t72 - t63;
        put_entry(8, K0_11);
        let t80 = self.mF - t57 * h_spin_F;
        let M_11_mF = self.rF * self.rF;
        put_derivative(17, M_11_mF);
        let t83 = t76 + (t63 - t72);
        let t84 = self.mR - t77;
        let t85 = wx_delta2_delta_lam * self.IHxz;
        let yaw_by_delta = wx_delta2_delta_lam * t55;
        put_derivative(18, yaw_by_delta);
        let M_12_c = wx_delta2_delta_lam * (t41 - t60);
        put_derivative(19, M_12_c);
        let M_12_rF = wx_delta2_delta * M_11_rF;
        put_derivative(20, M_12_rF);
        let M_12_mF = wx_delta2_delta * M_11_mF;
        put_derivative(21, M_12_mF);
        let t91 = t32 * wx_delta2_delta;
        let t92 = self.zH * wx_delta2_delta;
        let t93 = self.IHxz * wx_delta2_delta;
        let t94 = wx_delta2_delta_lam * h_spin_F;
        let vy_all1_delta = t29 * wx_delta2_delta;
        let yaw_per_v_delta = wx_delta2_delta_lam * t40;
        put_derivative(22, yaw_per_v_delta);
        let C1_21_rR = yaw_by_delta * t77;
        put_derivative(23, C1_21_rR);
        let t98 = t69 * yaw_per_v_delta;
        put_derivative(24, t98);
        let M_22_rF = wx_delta2_delta * M_12_rF;
        put_derivative(25, M_22_rF);
        let M_22_mF = wx_delta2_delta * M_12_mF;
        put_derivative(26, M_22_mF);
        let t101 = t76 * yaw_per_v_delta;
        put_derivative(27, t101);
        let C1_12_rR = yaw_by_delta * t84;
        put_derivative(28, C1_12_rR);
        let K2_12_rR = yaw_per_v_delta * t84;
        put_derivative(29, K2_12_rR);
        let C1_12_mR = self.rR * yaw_by_delta;
        put_derivative(30, C1_12_mR);
        let K2_12_mR = self.rR * yaw_per_v_delta;
        put_derivative(31, K2_12_mR);
        let K2_12 = t83 * yaw_per_v_delta;
        put_entry(11, K2_12);
        put_derivative(32, K2_12);
        let t107 = t40 * t83;
        let K2_12_IRyy = t61 * yaw_per_v_delta;
        put_derivative(33, K2_12_IRyy);
        let C1_12_IRyy = self.c * K2_12_IRyy;
        put_derivative(34, C1_12_IRyy);
        let K2_12_rF = yaw_per_v_delta * t80;
        put_derivative(35, K2_12_rF);
        let K2_12_mF = self.rF * yaw_per_v_delta;
        put_derivative(36, K2_12_mF);
        let t112 = M_12_yaw_by_delta * yaw_by_delta;
        let K0_12_mH = t92 + wx_delta2_delta_lam * t67;
        put_derivative(37, K0_12_mH);
        let wz_delta2_delta = wx_delta2_delta_lam + yaw_by_delta;
        put_derivative(38, wz_delta2_delta);
        let t117 = t60 - self.c * t107;
        let M_12 = t85 + t112 + t91 + t41 * K0_12_mH;
        put_entry(1, M_12);
        let t123 = t91 + self.IHxz * wz_delta2_delta;
        let t124 = t107 * yaw_per_v_delta;
        put_derivative(39, t124);
        let t125 = wx_delta2_delta * t107;
        put_derivative(40, t125);
        let M_12_mH = self.zH * K0_12_mH;
        put_derivative(41, M_12_mH);
        let K0_22_mH = wx_delta2_delta * K0_12_mH;
        put_derivative(42, K0_22_mH);
        let C1_12_rF = wz_delta2_delta * t80;
        put_derivative(43, C1_12_rF);
        let t130 = wz_delta2_delta * t43 + t93;
        let t132 = t130 + yaw_by_delta * t46;
        let M_22_mH = K0_12_mH * K0_12_mH;
        put_derivative(44, M_22_mH);
        let t134 = yaw_by_delta * t76;
        let C1_21_w = t40 * t134;
        put_derivative(45, C1_21_w);
        let C1_21 = -(t94 + t134);
        put_entry(5, C1_21);
        let C1_12_w = t117 * yaw_per_v_delta;
        put_derivative(46, C1_12_w);
        let t140 = t29 + h_spin_F - t117;
        let t141 = t29 * wx_delta2_delta_lam;
        let t142 = self.mH * K0_12_mH;
        let M_12_zH = t142 + self.mH * t92;
        put_derivative(47, M_12_zH);
        let t145 = t36 * yaw_by_delta;
        put_derivative(48, t145);
        let K0_12 = t142 - vy_all1_delta - t145;
        put_entry(9, K0_12);
        let t149 = t130 + t55 * t132;
        let t152 = t40 * (self.xH * t142 - t132);
        let t156 = t145 + yaw_per_v_delta * (t43 + t46) - K0_12;
        let C1_12 = wx_delta2_delta_lam * t140;
        put_entry(4, C1_12);
        let t158 = wx_delta2_delta * t140;
        put_derivative(49, t158);
        let K0_22 = wx_delta2_delta * K0_12;
        put_entry(10, K0_22);
        let t161 = t132 * (yaw_per_v_delta + yaw_per_v_delta);
        let t162 = wx_delta2_delta * h_spin_F;
        let t164 = t40 * (t162 - K0_12);
        let t165 = self.mH * yaw_per_v_delta;
        put_derivative(50, t165);
        let t166 = t165 * t73;
        put_derivative(51, t166);
        let C1_12_yaw_per_v_delta = wx_delta2_delta * t123;
        let M_22 = wx_delta2_delta_lam * t149 + C1_12_yaw_per_v_delta
            + self.mH * M_22_mH;
        put_entry(2, M_22);
        let t172 = self.mH * wx_delta2_delta_lam;
        let K2_22 = wx_delta2_delta_lam * t164;
        put_entry(12, K2_22);
        let t175 = t56 * t165 + t172;
        let t177 = t172 - self.xH * t165;
        let t178 = vy_all1_delta - t152;
        let M_22_wz_delta2_delta = K0_12_mH + K0_12_mH;
        let M_12_w = self.zH * t175 - t40 * t112;
        put_derivative(52, M_12_w);
        let C1_12_yaw_by_delta = t175 * M_22_wz_delta2_delta;
        let M_22_w = C1_12_yaw_by_delta - t55 * t161;
        put_derivative(53, M_22_w);
        let M_22_c = t161 + M_22_wz_delta2_delta * t177;
        put_derivative(54, M_22_c);
        let C1_22 = wx_delta2_delta_lam * (t178 - t55 * K0_12);
        put_entry(6, C1_22);
        let t191 = t36 * yaw_per_v_delta;
        let K0_12_c = t177 - t191;
        put_derivative(55, K0_12_c);
        let C1_22_c = yaw_per_v_delta * (t156 - t73 * t177);
        put_derivative(56, C1_22_c);
        let t196 = t55 * t156;
        let t197 = t191 - t177;
        let t198 = wx_delta2_delta * t197;
        put_derivative(57, t198);
        let K2_22_c = yaw_per_v_delta * t197;
        put_derivative(58, K2_22_c);
        let K0_12_w = t175 + t55 * t191;
        put_derivative(59, K0_12_w);
        let K0_22_w = wx_delta2_delta * K0_12_w;
        put_derivative(60, K0_22_w);
        let C1_22_w = yaw_per_v_delta * (t152 - t196 - t175 * t73);
        put_derivative(61, C1_22_w);
        let t208 = yaw_per_v_delta * (t164 + K0_12_w);
        put_derivative(62, t208);
        let t209 = t55 * wx_delta2_delta;
        let C1_21_lam = t162 + t76 * t209;
        put_derivative(63, C1_21_lam);
        let K0_12_zH = self.mH * wx_delta2_delta;
        put_derivative(64, K0_12_zH);
        let C1_22_yaw_by_delta = wx_delta2_delta_lam * t41 - t67 * K0_12_zH;
        let M_22_zH = M_22_wz_delta2_delta * K0_12_zH;
        put_derivative(65, M_22_zH);
        let C1_22_IRxx = yaw_by_delta * yaw_per_v_delta;
        put_derivative(66, C1_22_IRxx);
        let M_22_IRxx = self.c * C1_22_IRxx;
        put_derivative(67, M_22_IRxx);
        let t219 = self.mB * yaw_per_v_delta;
        put_derivative(68, t219);
        let C1_22_wz_delta2_delta = wx_delta2_delta * t43;
        let M_22_yaw_by_delta = t85 - t73 * C1_22_yaw_by_delta - C1_22_wz_delta2_delta;
        let C1_22_lam = wz_delta2_delta * t141 + yaw_per_v_delta * M_22_yaw_by_delta
            - wx_delta2_delta * (t178 + t196);
        put_derivative(69, C1_22_lam);
        let t235 = t93 + M_12_yaw_by_delta * t209 - self.zH * C1_22_yaw_by_delta
            - t32 * wx_delta2_delta_lam;
        put_derivative(70, t235);
        let K0_12_lam = C1_22_yaw_by_delta + t36 * t209 - t141;
        put_derivative(71, K0_12_lam);
        let t243 = K0_12_mH * C1_22_yaw_by_delta + wx_delta2_delta_lam * t123
            - wx_delta2_delta * t149;
        let t244 = self.c * t219;
        put_derivative(72, t244);
        let t245 = self.zB * t244;
        put_derivative(73, t245);
        let t246 = t219 * t74;
        put_derivative(74, t246);
        let C1_22_xB = yaw_by_delta * (t191 + t246);
        put_derivative(75, C1_22_xB);
        let t249 = self.xB * yaw_by_delta;
        put_derivative(76, t249);
        let M_12_yaw_per_v_delta = t94 - K0_12_lam;
        let K2_22_lam = yaw_per_v_delta * M_12_yaw_per_v_delta - wx_delta2_delta * t164;
        put_derivative(77, K2_22_lam);
        let K0_22_lam = wx_delta2_delta_lam * K0_12 + wx_delta2_delta * K0_12_lam;
        put_derivative(78, K0_22_lam);
        let M_22_lam = t243 + t243;
        put_derivative(79, M_22_lam);
        let M_22_xB = t244 * (t249 + t249);
        put_derivative(80, M_22_xB);
        let t260 = wx_delta2_delta * t244;
        put_derivative(81, t260);
        let K2_22_xB = yaw_per_v_delta * t244;
        put_derivative(82, K2_22_xB);
        let t262 = self.zB * t249;
        put_derivative(83, t262);
        let M_22_mB = t249 * t249;
        put_derivative(84, M_22_mB);
        let t264 = wx_delta2_delta * t249;
        put_derivative(85, t264);
        let K2_22_mB = yaw_per_v_delta * t249;
        put_derivative(86, K2_22_mB);
        let C1_22_mB = t74 * K2_22_mB;
        put_derivative(87, C1_22_mB);
        let t267 = self.zB * yaw_per_v_delta;
        put_derivative(88, t267);
        let t268 = t74 * t267;
        put_derivative(89, t268);
        let t269 = self.mH * wz_delta2_delta;
        put_derivative(90, t269);
        let t270 = M_22_wz_delta2_delta * t269;
        put_derivative(91, t270);
        let t271 = self.zH * t269;
        put_derivative(92, t271);
        let t272 = self.zH * yaw_per_v_delta;
        put_derivative(93, t272);
        let t273 = self.mH * t272;
        put_derivative(94, t273);
        let t274 = t73 * t272;
        put_derivative(95, t274);
        let C1_22_IHzz = wz_delta2_delta * yaw_per_v_delta;
        put_derivative(96, C1_22_IHzz);
        let K2_22_xH = self.mH * C1_22_IHzz;
        put_derivative(97, K2_22_xH);
        let C1_22_xH = t73 * K2_22_xH - K0_12_mH * t165;
        put_derivative(98, C1_22_xH);
        let t280 = K0_12_mH * yaw_per_v_delta;
        put_derivative(99, t280);
        let t281 = t73 * t280;
        put_derivative(100, t281);
        let t282 = wx_delta2_delta * wz_delta2_delta;
        let t283 = self.mH * t282;
        put_derivative(101, t283);
        let M_22_IHxz = t282 + t282;
        put_derivative(102, M_22_IHxz);
        let K2_22_h_spin_F = wx_delta2_delta * yaw_per_v_delta;
        put_derivative(103, K2_22_h_spin_F);
        let K2_22_rF = K2_22_h_spin_F * t80;
        put_derivative(104, K2_22_rF);
        let t287 = self.mH * K2_22_h_spin_F;
        put_derivative(105, t287);
        let t288 = t73 * t287;
        put_derivative(106, t288);
        let M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
        put_derivative(107, M_22_IHxx);
        let K0_22_zH = self.mH * M_22_IHxx;
        put_derivative(108, K0_22_zH);
        let t291 = self.mF * M_22_IHxx;
        put_derivative(109, t291);
        let t292 = self.rF * M_22_IHxx;
        put_derivative(110, t292);
        let M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
        put_derivative(111, M_22_IHzz);
        let M_22_IFxx = M_22_IHxx + M_22_IHzz;
        put_derivative(112, M_22_IFxx);
        let C1_12_IFyy = wz_delta2_delta * t57;
        put_derivative(113, C1_12_IFyy);
        let C1_21_rF = h_spin_F * C1_12_IFyy;
        put_derivative(114, C1_21_rF);
        let t297 = self.mF * wx_delta2_delta;
        put_derivative(115, t297);
        let C1_22_rF = wz_delta2_delta * t297;
        put_derivative(116, C1_22_rF);
        let C1_12_mF = self.rF * wz_delta2_delta;
        put_derivative(117, C1_12_mF);
        let C1_22_mF = wx_delta2_delta * C1_12_mF;
        put_derivative(118, C1_22_mF);
        let t301 = self.rF * wx_delta2_delta;
        put_derivative(119, t301);
        let K2_22_mF = yaw_per_v_delta * t301;
        put_derivative(120, K2_22_mF);
        let K2_12_IFyy = t57 * yaw_per_v_delta;
        put_derivative(121, K2_12_IFyy);
        let K2_22_IFyy = wx_delta2_delta * K2_12_IFyy;
        put_derivative(122, K2_22_IFyy);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl WhippleSprung<f64> {
    /// The parameter set `benchmark`.
    ///
    /// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; spring and damper are examples
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
    /// | `k` | 0.5 | `N*m` |
    /// | `d` | 0.25 | `N*m*s` |
    pub const BENCHMARK: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3141592653589793, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.0603,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.05892, IHyy: 0.06, IHzz: 0.00708, IHxz: -0.00756,
        rF: 0.35, mF: 3.0, IFxx: 0.1405, IFyy: 0.28, k: 0.5, d: 0.25,
    };

    /// The parameter set `benchmark_2005`.
    ///
    /// Source: Schwab, Meijaard & Papadopoulos (2005), ENOC 2005; spring and damper are examples
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `w` | 1.02 | `m` |
    /// | `c` | 0.08 | `m` |
    /// | `lam` | 0.3217505543966422 | `rad` |
    /// | `g` | 9.81 | `N/kg` |
    /// | `rR` | 0.3 | `m` |
    /// | `mR` | 2 | `kg` |
    /// | `IRxx` | 0.06 | `kg*m^2` |
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
    /// | `IHxx` | 0.0546 | `kg*m^2` |
    /// | `IHyy` | 0.06 | `kg*m^2` |
    /// | `IHzz` | 0.0114 | `kg*m^2` |
    /// | `IHxz` | -0.0162 | `kg*m^2` |
    /// | `rF` | 0.35 | `m` |
    /// | `mF` | 3 | `kg` |
    /// | `IFxx` | 0.14 | `kg*m^2` |
    /// | `IFyy` | 0.28 | `kg*m^2` |
    /// | `k` | 0.5 | `N*m` |
    /// | `d` | 0.25 | `N*m*s` |
    pub const BENCHMARK_2005: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3217505543966422, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.06,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.0546, IHyy: 0.06, IHzz: 0.0114, IHxz: -0.0162, rF: 0.35,
        mF: 3.0, IFxx: 0.14, IFyy: 0.28, k: 0.5, d: 0.25,
    };
}

impl WhippleSprung<f64> {
    /// The parameter set `benchmark`.
    #[must_use]
    pub const fn default() -> Self {
        Self::BENCHMARK
    }
}

/// The parameter set `benchmark`.
impl<T: Scalar> Default for WhippleSprung<T> {
    fn default() -> Self {
        WhippleSprung::cast(&WhippleSprung::<f64>::BENCHMARK)
    }
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> WhippleSprung<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 28]) -> Self {
        Self {
            w: values[0], c: values[1], lam: values[2], g: values[3], rR: values[4], mR: values[5],
            IRxx: values[6], IRyy: values[7], xB: values[8], zB: values[9], mB: values[10],
            IBxx: values[11], IByy: values[12], IBzz: values[13], IBxz: values[14], xH: values[15],
            zH: values[16], mH: values[17], IHxx: values[18], IHyy: values[19], IHzz: values[20],
            IHxz: values[21], rF: values[22], mF: values[23], IFxx: values[24], IFyy: values[25],
            k: values[26], d: values[27],
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
            self.k, self.d,
        ]
    }
}

impl<T: Scalar> WhippleSprung<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> WhippleSprung<U> {
        let values = self.to_array();
        WhippleSprung::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl WhippleSprung<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> WhippleSprung<f32> {
        WhippleSprung::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<WhippleSprung<f32>> for WhippleSprung<f64> {
    fn from(parameters: WhippleSprung<f32>) -> Self {
        WhippleSprung::cast(&parameters)
    }
}

impl<T: Number> WhippleSprungMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 24]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c0: carvallo::rows(&entries, 4),
            c1: carvallo::rows(&entries, 8),
            kc: carvallo::rows(&entries, 12),
            k0: carvallo::rows(&entries, 16),
            k2: carvallo::rows(&entries, 20),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 13] {
        [
            self.m[0][0], self.m[0][1], self.m[1][1], self.c0[1][1], self.c1[0][1], self.c1[1][0],
            self.c1[1][1], self.kc[1][1], self.k0[0][0], self.k0[0][1], self.k0[1][1],
            self.k2[0][1], self.k2[1][1],
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
                self.c0[1][1] = entry;
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
                self.kc[1][1] = entry;
            }
            8 => {
                self.k0[0][0] = entry;
            }
            9 => {
                self.k0[0][1] = entry;
                self.k0[1][0] = entry;
            }
            10 => {
                self.k0[1][1] = entry;
            }
            11 => {
                self.k2[0][1] = entry;
            }
            12 => {
                self.k2[1][1] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, self.c0.0, self.c1.0, self.kc.0, self.k0.0, zeros, self.k2.0]
    }
}

impl<T: Scalar> From<WhippleSprungMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: WhippleSprungMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for WhippleSprung<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 28];

    type Over<U: Number> = WhippleSprung<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "WhippleSprung",
        docs: "The Whipple-Carvallo bicycle with a spring and a damper between rear frame and front frame.\n\nFour rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally\nsymmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,\nx forward, y to the right, z down, so that a centre of mass above the ground has z < 0.",
        source: "Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3",
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
            ParameterInfo::new("k", "N*m", Domain::NONNEGATIVE)
                .docs("Stiffness of the steering spring."),
            ParameterInfo::new("d", "N*m*s", Domain::NONNEGATIVE)
                .docs("Damping of the steering damper."),
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
            MatrixName::M, MatrixName::C0, MatrixName::C1, MatrixName::Kc, MatrixName::K0,
            MatrixName::K2,
        ],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]), EntryInfo::at(&[(MatrixName::C0, 1, 1)]),
            EntryInfo::at(&[(MatrixName::C1, 0, 1)]), EntryInfo::at(&[(MatrixName::C1, 1, 0)]),
            EntryInfo::at(&[(MatrixName::C1, 1, 1)]), EntryInfo::at(&[(MatrixName::Kc, 1, 1)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 1, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 0, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 1, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "benchmark",
                docs: "",
                source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; spring and damper are examples",
                values: &WhippleSprung::to_array(&WhippleSprung::<f64>::BENCHMARK),
            },
            SetInfo {
                name: "benchmark_2005",
                docs: "",
                source: "Schwab, Meijaard & Papadopoulos (2005), ENOC 2005; spring and damper are examples",
                values: &WhippleSprung::to_array(&WhippleSprung::<f64>::BENCHMARK_2005),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("yaw_by_delta", "1", "c*cos(lam)/w"),
            FormulaInfo::definition("yaw_per_v_delta", "1/m", "cos(lam)/w"),
            FormulaInfo::definition("Jxx_delta", "kg*m^2", "IHxx + IFxx + zH^2*mH + rF^2*mF"),
            FormulaInfo::definition("Jxz_delta", "kg*m^2", "IHxz - c*rF*mF - zH*mH*(xH - (w + c))"),
            FormulaInfo::definition("Jzz_delta", "kg*m^2", "mH*(xH - (w + c))^2 + IHzz + IFxx + c^2*mF"),
            FormulaInfo::definition("Sx_delta", "kg*m", "mH*(xH - (w + c)) - c*mF"),
            FormulaInfo::definition("Sz_delta", "kg*m", "zH*mH - rF*mF"),
            FormulaInfo::definition("m_delta", "kg", "mH + mF"),
            FormulaInfo::definition("py_delta", "kg*m", "Sx_delta*cos(lam) - Sz_delta*sin(lam)"),
            FormulaInfo::definition("hx_delta", "kg*m^2", "Jxx_delta*sin(lam) + Jxz_delta*cos(lam)"),
            FormulaInfo::definition("hz_delta", "kg*m^2", "Jxz_delta*sin(lam) + Jzz_delta*cos(lam)"),
            FormulaInfo::definition("Jxx_all", "kg*m^2", "IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB"),
            FormulaInfo::definition("Jxz_all", "kg*m^2", "IBxz + Jxz_delta - xB*zB*mB - Sz_delta*(w + c)"),
            FormulaInfo::definition("Jzz_all", "kg*m^2", "IRxx + IBzz + IHzz + IFxx + w^2*mF + xB^2*mB + xH^2*mH"),
            FormulaInfo::definition("Sx_all", "kg*m", "xB*mB + Sx_delta + m_delta*(w + c)"),
            FormulaInfo::definition("Sz_all", "kg*m", "zB*mB + Sz_delta - rR*mR"),
            FormulaInfo::definition("load_spin_F", "kg", "-Sx_all/w"),
            FormulaInfo::definition("h_spin_R", "kg*m", "IRyy/rR"),
            FormulaInfo::definition("h_spin_F", "kg*m", "IFyy/rF"),
            FormulaInfo::definition("h_wheels_all", "kg*m", "h_spin_R + h_spin_F"),
            FormulaInfo::definition("M_yaw_delta", "kg*m^2", "py_delta*(w + c) + hz_delta"),
            FormulaInfo::definition("M_delta_delta", "kg*m^2", "hx_delta*sin(lam) + hz_delta*cos(lam)"),
            FormulaInfo::definition("K_phi_delta", "kg*m", "c*load_spin_F*cos(lam) - py_delta"),
            FormulaInfo::definition("K_delta_delta", "kg*m", "(c*load_spin_F*cos(lam) - py_delta)*sin(lam)"),
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
            FormulaInfo::entry(&[(MatrixName::C0, 1, 1)], "kg*m^2/s", "d"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 1)],
                "kg*m",
                "yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_F*cos(lam)",
            ),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 0)], "kg*m", "-(yaw_by_delta*h_wheels_all + h_spin_F*cos(lam))"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 1)],
                "kg*m",
                "yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw",
            ),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 1)], "kg*m^2/s^2", "k"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "Sz_all"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)], "kg*m", "K_phi_delta"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "K_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg", "yaw_per_v_delta*(h_wheels_all - Sz_all)"),
            FormulaInfo::entry(
                &[(MatrixName::K2, 1, 1)],
                "kg",
                "yaw_per_v_delta*(h_spin_F*sin(lam) + P_delta_lateral)",
            ),
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
            FormulaInfo::attribute("delta_spring", "the spring of the joint delta", "kg*m^2/s^2", "k"),
            FormulaInfo::attribute("delta_damper", "the damper of the joint delta", "kg*m^2/s", "d"),
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
            FormulaInfo::entry(&[(MatrixName::C0, 1, 1)], "kg*m^2/s", "delta_damper"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 0)], "kg*m", "yaw_by_phi_*P_phi_lateral"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 1)],
                "kg*m",
                "(delta_along_z*h_spin_F + length_delta*yaw_by_delta*(h_wheels_all + P_phi_lateral) + length_delta*yaw_per_v_delta*P_phi_yaw - delta_along_x*yaw_by_phi_*h_spin_F)/length_delta",
            ),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 0)],
                "kg*m",
                "(yaw_by_phi_*(delta_along_x*h_spin_F + length_delta*P_delta_lateral) - delta_along_z*h_spin_F - length_delta*yaw_by_delta*h_wheels_all)/length_delta",
            ),
            FormulaInfo::entry(
                &[(MatrixName::C1, 1, 1)],
                "kg*m",
                "yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw",
            ),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 1)], "kg*m^2/s^2", "delta_spring"),
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
        LengthError::check("WhippleSprung", 28, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("WhippleSprung", 28, values)?;
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
        Coefficients::from_rows(WhippleSprungMatrices::rows(&self.matrices()))
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

impl WhippleSprung<f64> {
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
impl<T: Scalar> core::fmt::Display for WhippleSprung<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for WhippleSprung<T> {
    type Entries = [T; 13];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            w: parameter(0), c: parameter(1), lam: parameter(2), g: parameter(3), rR: parameter(4),
            mR: parameter(5), IRxx: parameter(6), IRyy: parameter(7), xB: parameter(8),
            zB: parameter(9), mB: parameter(10), IBxx: parameter(11), IByy: parameter(12),
            IBzz: parameter(13), IBxz: parameter(14), xH: parameter(15), zH: parameter(16),
            mH: parameter(17), IHxx: parameter(18), IHyy: parameter(19), IHzz: parameter(20),
            IHxz: parameter(21), rF: parameter(22), mF: parameter(23), IFxx: parameter(24),
            IFyy: parameter(25), k: parameter(26), d: parameter(27),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        WhippleSprungMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        WhippleSprungMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> WhippleSprungDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<WhippleSprungMatrices<T>> {
        if parameter >= 28 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = WhippleSprungMatrices {
            m: Rows([[zero; 2]; 2]), c0: Rows([[zero; 2]; 2]), c1: Rows([[zero; 2]; 2]),
            kc: Rows([[zero; 2]; 2]), k0: Rows([[zero; 2]; 2]), k2: Rows([[zero; 2]; 2]),
        };
        for position in 0..160 {
            let partial = <WhippleSprungDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C0 => &mut matrices.c0,
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

impl<T: Scalar> Differentiable<2> for WhippleSprung<T> {
    type Derivatives = [Coefficients<T, 2>; 28];

    type WithDerivativesOver<U: Number> = WhippleSprung<U>;

    const PARTIALS: &'static [Partial] = <WhippleSprungDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 28];
        for position in 0..160 {
            Partial::write(&<WhippleSprungDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(WhippleSprungMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for WhippleSprung<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl WhippleSprungDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 160] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 52), Partial::new(MatrixName::M, 1, 0, 0, 52),
        Partial::new(MatrixName::M, 1, 1, 0, 53), Partial::new(MatrixName::C1, 0, 1, 0, 46),
        Partial::new(MatrixName::C1, 1, 0, 0, 45), Partial::new(MatrixName::C1, 1, 1, 0, 61),
        Partial::new(MatrixName::K0, 0, 1, 0, 59), Partial::new(MatrixName::K0, 1, 0, 0, 59),
        Partial::new(MatrixName::K0, 1, 1, 0, 60),
        Partial::new(MatrixName::K2, 0, 1, 0, 39).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 62).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 19), Partial::new(MatrixName::M, 1, 0, 1, 19),
        Partial::new(MatrixName::M, 1, 1, 1, 54), Partial::new(MatrixName::C1, 0, 1, 1, 32),
        Partial::new(MatrixName::C1, 1, 0, 1, 27).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 56),
        Partial::new(MatrixName::K0, 0, 1, 1, 55),
        Partial::new(MatrixName::K0, 1, 0, 1, 55),
        Partial::new(MatrixName::K0, 1, 1, 1, 57).negative(),
        Partial::new(MatrixName::K2, 1, 1, 1, 58),
        Partial::new(MatrixName::M, 0, 1, 2, 70).negative(),
        Partial::new(MatrixName::M, 1, 0, 2, 70).negative(),
        Partial::new(MatrixName::M, 1, 1, 2, 79),
        Partial::new(MatrixName::C1, 0, 1, 2, 49).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 63), Partial::new(MatrixName::C1, 1, 1, 2, 69),
        Partial::new(MatrixName::K0, 0, 1, 2, 71), Partial::new(MatrixName::K0, 1, 0, 2, 71),
        Partial::new(MatrixName::K0, 1, 1, 2, 78),
        Partial::new(MatrixName::K2, 0, 1, 2, 40).negative(),
        Partial::new(MatrixName::K2, 1, 1, 2, 77), Partial::new(MatrixName::M, 0, 0, 4, 14),
        Partial::new(MatrixName::C1, 0, 1, 4, 28), Partial::new(MatrixName::C1, 1, 0, 4, 23),
        Partial::new(MatrixName::K0, 0, 0, 4, 1).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 29), Partial::new(MatrixName::M, 0, 0, 5, 11),
        Partial::new(MatrixName::C1, 0, 1, 5, 30),
        Partial::new(MatrixName::K0, 0, 0, 5, 0).negative(),
        Partial::new(MatrixName::K2, 0, 1, 5, 31), Partial::new(MatrixName::M, 0, 0, 6, 8),
        Partial::new(MatrixName::M, 1, 1, 6, 67), Partial::new(MatrixName::C1, 1, 1, 6, 66),
        Partial::new(MatrixName::C1, 0, 1, 7, 34),
        Partial::new(MatrixName::C1, 1, 0, 7, 34).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 33),
        Partial::new(MatrixName::M, 0, 1, 8, 73).negative(),
        Partial::new(MatrixName::M, 1, 0, 8, 73).negative(),
        Partial::new(MatrixName::M, 1, 1, 8, 80),
        Partial::new(MatrixName::C1, 0, 1, 8, 24).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 75),
        Partial::new(MatrixName::K0, 0, 1, 8, 72).negative(),
        Partial::new(MatrixName::K0, 1, 0, 8, 72).negative(),
        Partial::new(MatrixName::K0, 1, 1, 8, 81).negative(),
        Partial::new(MatrixName::K2, 1, 1, 8, 82), Partial::new(MatrixName::M, 0, 0, 9, 15),
        Partial::new(MatrixName::M, 0, 1, 9, 48).negative(),
        Partial::new(MatrixName::M, 1, 0, 9, 48).negative(),
        Partial::new(MatrixName::C1, 0, 1, 9, 74).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 3),
        Partial::new(MatrixName::K2, 0, 1, 9, 68).negative(),
        Partial::new(MatrixName::M, 0, 0, 10, 12),
        Partial::new(MatrixName::M, 0, 1, 10, 83).negative(),
        Partial::new(MatrixName::M, 1, 0, 10, 83).negative(),
        Partial::new(MatrixName::M, 1, 1, 10, 84),
        Partial::new(MatrixName::C1, 0, 1, 10, 89).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 87),
        Partial::new(MatrixName::K0, 0, 0, 10, 2),
        Partial::new(MatrixName::K0, 0, 1, 10, 76).negative(),
        Partial::new(MatrixName::K0, 1, 0, 10, 76).negative(),
        Partial::new(MatrixName::K0, 1, 1, 10, 85).negative(),
        Partial::new(MatrixName::K2, 0, 1, 10, 88).negative(),
        Partial::new(MatrixName::K2, 1, 1, 10, 86), Partial::new(MatrixName::M, 0, 0, 11, 8),
        Partial::new(MatrixName::M, 1, 1, 13, 67), Partial::new(MatrixName::C1, 1, 1, 13, 66),
        Partial::new(MatrixName::M, 0, 1, 14, 18), Partial::new(MatrixName::M, 1, 0, 14, 18),
        Partial::new(MatrixName::C1, 0, 1, 14, 22),
        Partial::new(MatrixName::M, 0, 1, 15, 92).negative(),
        Partial::new(MatrixName::M, 1, 0, 15, 92).negative(),
        Partial::new(MatrixName::M, 1, 1, 15, 91).negative(),
        Partial::new(MatrixName::C1, 0, 1, 15, 94).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 98),
        Partial::new(MatrixName::K0, 0, 1, 15, 90).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 90).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 101).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 97), Partial::new(MatrixName::M, 0, 0, 16, 13),
        Partial::new(MatrixName::M, 0, 1, 16, 47), Partial::new(MatrixName::M, 1, 0, 16, 47),
        Partial::new(MatrixName::M, 1, 1, 16, 65),
        Partial::new(MatrixName::C1, 0, 1, 16, 51).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 106).negative(),
        Partial::new(MatrixName::K0, 0, 0, 16, 5), Partial::new(MatrixName::K0, 0, 1, 16, 64),
        Partial::new(MatrixName::K0, 1, 0, 16, 64), Partial::new(MatrixName::K0, 1, 1, 16, 108),
        Partial::new(MatrixName::K2, 0, 1, 16, 50).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 105).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 10), Partial::new(MatrixName::M, 0, 1, 17, 41),
        Partial::new(MatrixName::M, 1, 0, 17, 41), Partial::new(MatrixName::M, 1, 1, 17, 44),
        Partial::new(MatrixName::C1, 0, 1, 17, 95).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 100).negative(),
        Partial::new(MatrixName::K0, 0, 0, 17, 4), Partial::new(MatrixName::K0, 0, 1, 17, 37),
        Partial::new(MatrixName::K0, 1, 0, 17, 37), Partial::new(MatrixName::K0, 1, 1, 17, 42),
        Partial::new(MatrixName::K2, 0, 1, 17, 93).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 99).negative(),
        Partial::new(MatrixName::M, 0, 0, 18, 8), Partial::new(MatrixName::M, 0, 1, 18, 9),
        Partial::new(MatrixName::M, 1, 0, 18, 9), Partial::new(MatrixName::M, 1, 1, 18, 107),
        Partial::new(MatrixName::M, 1, 1, 20, 111), Partial::new(MatrixName::C1, 1, 1, 20, 96),
        Partial::new(MatrixName::M, 0, 1, 21, 38), Partial::new(MatrixName::M, 1, 0, 21, 38),
        Partial::new(MatrixName::M, 1, 1, 21, 102), Partial::new(MatrixName::C1, 0, 1, 21, 22),
        Partial::new(MatrixName::C1, 1, 1, 21, 103), Partial::new(MatrixName::M, 0, 0, 22, 16),
        Partial::new(MatrixName::M, 0, 1, 22, 20), Partial::new(MatrixName::M, 1, 0, 22, 20),
        Partial::new(MatrixName::M, 1, 1, 22, 25), Partial::new(MatrixName::C1, 0, 1, 22, 43),
        Partial::new(MatrixName::C1, 1, 0, 22, 114), Partial::new(MatrixName::C1, 1, 1, 22, 116),
        Partial::new(MatrixName::K0, 0, 0, 22, 7).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 115).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 115).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 109).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 35), Partial::new(MatrixName::K2, 1, 1, 22, 104),
        Partial::new(MatrixName::M, 0, 0, 23, 17), Partial::new(MatrixName::M, 0, 1, 23, 21),
        Partial::new(MatrixName::M, 1, 0, 23, 21), Partial::new(MatrixName::M, 1, 1, 23, 26),
        Partial::new(MatrixName::C1, 0, 1, 23, 117), Partial::new(MatrixName::C1, 1, 1, 23, 118),
        Partial::new(MatrixName::K0, 0, 0, 23, 6).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 119).negative(),
        Partial::new(MatrixName::K0, 1, 0, 23, 119).negative(),
        Partial::new(MatrixName::K0, 1, 1, 23, 110).negative(),
        Partial::new(MatrixName::K2, 0, 1, 23, 36), Partial::new(MatrixName::K2, 1, 1, 23, 120),
        Partial::new(MatrixName::M, 0, 0, 24, 8), Partial::new(MatrixName::M, 0, 1, 24, 9),
        Partial::new(MatrixName::M, 1, 0, 24, 9), Partial::new(MatrixName::M, 1, 1, 24, 112),
        Partial::new(MatrixName::C1, 1, 1, 24, 96), Partial::new(MatrixName::C1, 0, 1, 25, 113),
        Partial::new(MatrixName::C1, 1, 0, 25, 113).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 121), Partial::new(MatrixName::K2, 1, 1, 25, 122),
        Partial::new(MatrixName::Kc, 1, 1, 26, 8), Partial::new(MatrixName::C0, 1, 1, 27, 8),
    ];
}
