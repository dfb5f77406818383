// @generated from generated/models/flywheel_bicycle.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 79e8bfc3e5c2959e

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rate, Rows, Scalar, SetInfo,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A bicycle with flywheels: rotors that spin at a constant rate in its frames.
///
/// The Whipple-Carvallo bicycle with a flywheel in the front wheel, as learners ride it, and one in the rear frame. Their
/// angular momenta are independent of the speed, so they act at rest as well; against the wheels they cancel what those
/// do at one speed. The masses and moments of inertia of the flywheels are parts of those of the frames. Axes: origin at
/// the rear contact point, x forward, y to the right, z down.
///
/// The declaration asserts that the matrices are those of Appendix A of the paper and, for the flywheels, its terms of the
/// wheels with angular momenta in the place of those of wheels that roll.
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
/// C0_12 = hH*cos(lam) + mu*(hB + hH) [kg*m^2/s]
/// C0_21 = -(hH*cos(lam) + mu*(hB + hH)) [kg*m^2/s]
/// C1_12 = mu*(ST - Sz_all) + SF*cos(lam) + yaw_per_v_delta*Jxz_all [kg*m]
/// C1_21 = -(mu*ST + SF*cos(lam)) [kg*m]
/// C1_22 = mu*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
/// K0_11 = Sz_all [kg*m]
/// K0_12 = K0_21 = K_phi_delta [kg*m]
/// K0_22 = K_delta_delta [kg*m]
/// K1_12 = yaw_per_v_delta*(hB + hH) [kg*m/s]
/// K1_22 = hH*yaw_per_v_delta*sin(lam) [kg*m/s]
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
pub struct FlywheelBicycle<T = f64> {
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
    /// Angular momentum of the flywheel in the rear frame, positive as the wheels turn.
    ///
    /// `hB` in `N*m*s`: any finite value.
    pub hB: T,
    /// Angular momentum of the flywheel in the front frame, positive as the wheels turn.
    ///
    /// `hH` in `N*m*s`: any finite value.
    pub hH: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`FlywheelBicycle`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlywheelBicycleMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C0, a coefficient of q'.
    pub c0: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
    /// Stiffness K1, a coefficient of v q.
    pub k1: Rows<T, 2>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 2>,
}

impl<T: Number> FlywheelBicycle<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 42 additions, 49 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 98 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> FlywheelBicycleMatrices<T> {
        let t2 = self.zB * self.mB;
        let t10 = self.rF * self.mF;
        let t13 = self.IHxx + (self.IFxx + self.rF * t10);
        let t19 = self.zH * self.mH;
        let t23 = self.rR * self.mR;
        let M_11 = self.zB * t2 + (self.IBxx + (self.IRxx + t13))
            + (self.zH * t19 + self.rR * t23);
        let (wx_delta2_delta, cos_lam) = self.lam.sin_cos();
        let t33 = self.w.like(1.0) / self.w;
        let yaw_per_v_delta = cos_lam * t33;
        let mu = self.c * yaw_per_v_delta;
        let wz_delta2_delta = cos_lam + mu;
        let t39 = t13 * wx_delta2_delta + wz_delta2_delta * self.IHxz;
        let t42 = self.mB * self.xB;
        let t44 = self.zB * t42 - self.IBxz;
        let t52 = self.zH * wx_delta2_delta
            + (cos_lam * (self.c + self.w) - self.xH * wz_delta2_delta);
        let t53 = self.mH * t52;
        let M_12 = t39 + (self.zH * t53 - mu * t44);
        let t62 = wz_delta2_delta * (self.IFxx + self.IHzz)
            + wx_delta2_delta * self.IHxz;
        let ay_delta2_delta = mu * (self.IBzz + (self.IRxx + self.xB * t42));
        let M_22 = t52 * t53 + wz_delta2_delta * t62
            + (mu * ay_delta2_delta + wx_delta2_delta * t39);
        let zero = self.w.like(0.0);
        let t76 = cos_lam * self.hH;
        let K1_12 = yaw_per_v_delta * (self.hH + self.hB);
        let C0_12 = t76 + self.c * K1_12;
        let SF = self.IFyy / self.rF;
        let SR = self.IRyy / self.rR;
        let K0_11 = t19 + t2 - (t23 + t10);
        let t91 = SF - (K0_11 - SR);
        let t98 = t10 + SF - t33 * (t44 + (t19 * self.xH - self.c * t91) - self.IHxz);
        let C1_12 = cos_lam * t98;
        let t103 = t10 * wx_delta2_delta;
        let t106 = t53 - mu * t42;
        let K0_12 = t106 - t103;
        let K0_22 = wx_delta2_delta * K0_12;
        let K1_22 = wx_delta2_delta * (t33 * t76);
        let K2_12 = yaw_per_v_delta * t91;
        let K2_22 = (wx_delta2_delta * SF - K0_12) * yaw_per_v_delta;
        let C0_21 = -C0_12;
        let C1_21 = -(mu * SR + wz_delta2_delta * SF);
        let C1_22 = wz_delta2_delta * t103
            - (self.c * t106 + (self.xH * t53 - t62) - ay_delta2_delta)
                * yaw_per_v_delta;
        FlywheelBicycleMatrices::from_entries([
            M_11, M_12, M_12, M_22, zero, C0_12, C0_21, zero, zero, C1_12, C1_21, C1_22, K0_11,
            K0_12, K0_12, K0_22, zero, K1_12, zero, K1_22, zero, K2_12, zero, K2_22,
        ])
    }
}

// --- Rates and forces of the mechanism -----------------------------------------------------------

/// Rates and forces of [`FlywheelBicycle`] that follow from its coordinates q = (`phi`, `delta`),
/// to first order and in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlywheelBicycleKinematics<T = f64> {
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

impl<T: Scalar> FlywheelBicycle<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> FlywheelBicycleKinematics<T> {
        let zero = self.w.like(0.0);
        let yaw_per_v_delta = self.lam.cos() / self.w;
        let mu = self.c * yaw_per_v_delta;
        let t12 = -(self.w.like(1.0) / self.rR);
        let t13 = -(self.w.like(1.0) / self.rF);
        FlywheelBicycleKinematics {
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

/// The derivatives of the matrices of [`FlywheelBicycle`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlywheelBicycleDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 130],
}

impl<T: Number> FlywheelBicycle<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 97 additions, 186 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 290 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (FlywheelBicycleMatrices<T>, FlywheelBicycleDerivatives<T>) {
        let zero = self.w.like(0.0);
        let mut matrices = FlywheelBicycleMatrices::from_entries([zero; 24]);
        let mut derivatives = FlywheelBicycleDerivatives {
            values: [zero; 130],
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
        matrices: &mut FlywheelBicycleMatrices<T>,
        derivatives: &mut FlywheelBicycleDerivatives<T>,
    ) {
        *matrices = FlywheelBicycleMatrices::from_entries([self.w.like(0.0); 24]);
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
        let (wx_delta2_delta, wx_delta2_delta_lam) = self.lam.sin_cos();
        put_derivative(9, wx_delta2_delta);
        let t29 = self.rR * self.mR;
        let t30 = self.zH * self.mH;
        let M_11_mF = self.rF * self.rF;
        put_derivative(10, M_11_mF);
        let t34 = self.IHxx + self.IFxx + self.mF * M_11_mF;
        let t35 = self.zB * self.mB;
        let M_11_rR = t29 + t29;
        put_derivative(11, M_11_rR);
        let M_11_mR = self.rR * self.rR;
        put_derivative(12, M_11_mR);
        let M_11_zB = t35 + t35;
        put_derivative(13, M_11_zB);
        let M_11 = self.IBxx + self.rR * t29 + self.zH * t30 + t34 + self.IRxx
            + self.zB * t35;
        put_entry(0, M_11);
        let M_11_mB = self.zB * self.zB;
        put_derivative(14, M_11_mB);
        let M_11_zH = t30 + t30;
        put_derivative(15, M_11_zH);
        let M_11_mH = self.zH * self.zH;
        put_derivative(16, M_11_mH);
        let t51 = self.xH - self.c - self.w;
        let t52 = self.w.like(1.0) / self.w;
        let t54 = self.IBxz - t35 * self.xB;
        let t55 = self.IFxx + self.IHzz;
        let t56 = self.mB * self.xB;
        let t57 = self.c * t52;
        let t60 = self.IRxx + self.IBzz + self.xB * t56;
        let t61 = self.hH + self.hB;
        let t62 = self.w.like(1.0) / self.rF;
        let t63 = self.mF * self.rF;
        let K0_11 = t35 - (t29 + t63 - t30);
        put_entry(8, K0_11);
        let M_11_rF = t63 + t63;
        put_derivative(17, M_11_rF);
        let t69 = t51 + self.xH * t57;
        let t70 = t57 * t61;
        let SF = self.IFyy * t62;
        let t72 = self.w.like(1.0) / self.rR;
        let M_12_mu = self.IHxz + t54;
        let t75 = t30 * self.xH - M_12_mu;
        let t76 = self.xH + self.c;
        let t77 = self.hH + t70;
        let SR = self.IRyy * t72;
        let t79 = self.c + self.xB;
        let t81 = self.mF - t62 * SF;
        let t82 = self.zH * wx_delta2_delta;
        let mu = wx_delta2_delta_lam * t57;
        put_derivative(18, mu);
        let t84 = wx_delta2_delta * self.IHxz;
        let t85 = wx_delta2_delta_lam * SF;
        let yaw_per_v_delta = wx_delta2_delta_lam * t52;
        put_derivative(19, yaw_per_v_delta);
        let C0_21_lam = wx_delta2_delta * t77;
        put_derivative(20, C0_21_lam);
        let C0_12 = wx_delta2_delta_lam * t77;
        put_entry(3, C0_12);
        let M_12_mF = M_11_mF * wx_delta2_delta;
        put_derivative(21, M_12_mF);
        let t90 = wx_delta2_delta_lam * t69;
        let t91 = SF + SR;
        let t92 = t72 * SR;
        let t93 = self.rF * wx_delta2_delta;
        put_derivative(22, t93);
        let t94 = wx_delta2_delta * SF;
        let t95 = t30 * wx_delta2_delta_lam;
        let t96 = self.mH * wx_delta2_delta_lam;
        let C0_21_w = t70 * yaw_per_v_delta;
        put_derivative(23, C0_21_w);
        let M_22_mF = wx_delta2_delta * M_12_mF;
        put_derivative(24, M_22_mF);
        let C0_21 = -C0_12;
        put_entry(4, C0_21);
        let t100 = t91 - K0_11;
        let C1_21_rR = mu * t92;
        put_derivative(25, C1_21_rR);
        let C1_22_mu = self.mR - t92;
        let K2_12_rR = yaw_per_v_delta * C1_22_mu;
        put_derivative(26, K2_12_rR);
        let C1_12_mR = self.rR * mu;
        put_derivative(27, C1_12_mR);
        let K2_12_mR = self.rR * yaw_per_v_delta;
        put_derivative(28, K2_12_mR);
        let K2_12_IRyy = t72 * yaw_per_v_delta;
        put_derivative(29, K2_12_IRyy);
        let C1_12_IRyy = self.c * K2_12_IRyy;
        put_derivative(30, C1_12_IRyy);
        let t108 = t35 * yaw_per_v_delta;
        put_derivative(31, t108);
        let t109 = self.c * t108;
        put_derivative(32, t109);
        let t110 = t52 * t95;
        put_derivative(33, t110);
        let t111 = self.zH * yaw_per_v_delta;
        put_derivative(34, t111);
        let t112 = wx_delta2_delta * t93;
        put_derivative(35, t112);
        let K2_12_mF = self.rF * yaw_per_v_delta;
        put_derivative(36, K2_12_mF);
        let K2_22_mF = yaw_per_v_delta * t93;
        put_derivative(37, K2_22_mF);
        let t115 = self.mF * t93;
        let K2_12_IFyy = t62 * yaw_per_v_delta;
        put_derivative(38, K2_12_IFyy);
        let C1_12_rR = self.c * K2_12_rR;
        put_derivative(39, C1_12_rR);
        let C1_21 = -(t85 + mu * t91);
        put_entry(6, C1_21);
        let K0_12_mH = t82 - t90;
        put_derivative(40, K0_12_mH);
        let t122 = t82 + K0_12_mH;
        let t123 = t90 - t122;
        let M_12_zH = self.mH * t122;
        put_derivative(41, M_12_zH);
        let M_22_mH = K0_12_mH * K0_12_mH;
        put_derivative(42, M_22_mH);
        let K0_22_mH = wx_delta2_delta * K0_12_mH;
        put_derivative(43, K0_22_mH);
        let t127 = K0_12_mH * yaw_per_v_delta;
        put_derivative(44, t127);
        let M_12_mH = self.zH * K0_12_mH;
        put_derivative(45, M_12_mH);
        let wz_delta2_delta = wx_delta2_delta_lam + mu;
        put_derivative(46, wz_delta2_delta);
        let t130 = t30 * wz_delta2_delta;
        put_derivative(47, t130);
        let t135 = self.mH * M_12_mH + self.IHxz * wz_delta2_delta
            + t34 * wx_delta2_delta;
        let C1_12_rF = wz_delta2_delta * t81;
        put_derivative(48, C1_12_rF);
        let K2_12_rF = yaw_per_v_delta * t81;
        put_derivative(49, K2_12_rF);
        let K2_22_rF = wx_delta2_delta * K2_12_rF;
        put_derivative(50, K2_22_rF);
        let C1_12_mF = self.rF * wz_delta2_delta;
        put_derivative(51, C1_12_mF);
        let t141 = t84 + wz_delta2_delta * t55;
        let ay_delta2_delta = t141 + mu * t60;
        let t144 = self.mH * K0_12_mH;
        let t147 = t52 * (self.c * t100 - t75);
        let t148 = t75 * yaw_per_v_delta;
        let M_12 = t135 + mu * t54;
        put_entry(1, M_12);
        let M_12_w = t95 + t57 * t148;
        put_derivative(52, M_12_w);
        let M_12_c = t95 - t148;
        put_derivative(53, M_12_c);
        let t154 = t147 * yaw_per_v_delta;
        put_derivative(54, t154);
        let t156 = SF + t63 + t147;
        let t157 = mu * self.xB;
        put_derivative(55, t157);
        let t158 = self.zB * t157;
        put_derivative(56, t158);
        let M_22_mB = t157 * t157;
        put_derivative(57, M_22_mB);
        let t160 = wx_delta2_delta * t157;
        put_derivative(58, t160);
        let t162 = ay_delta2_delta - self.xH * t144;
        let t163 = ay_delta2_delta * yaw_per_v_delta;
        let t164 = self.mB * yaw_per_v_delta;
        put_derivative(59, t164);
        let t165 = self.c * t164;
        put_derivative(60, t165);
        let t166 = wx_delta2_delta * t165;
        put_derivative(61, t166);
        let K2_22_xB = yaw_per_v_delta * t165;
        put_derivative(62, K2_22_xB);
        let ay_delta2_delta_xB = t157 * t165;
        let t169 = self.mB * t157;
        put_derivative(63, t169);
        let t170 = wx_delta2_delta * wz_delta2_delta;
        let M_22_IHxz = t170 + t170;
        put_derivative(64, M_22_IHxz);
        let M_22_xB = ay_delta2_delta_xB + ay_delta2_delta_xB;
        put_derivative(65, M_22_xB);
        let C1_12 = wx_delta2_delta_lam * t156;
        put_entry(5, C1_12);
        let t174 = wx_delta2_delta * t156;
        put_derivative(66, t174);
        let C1_22_mF = self.rF * t170;
        put_derivative(67, C1_22_mF);
        let t176 = yaw_per_v_delta * t76;
        let C1_22 = ay_delta2_delta_xB + t163 + t63 * t170 - t144 * t176;
        put_entry(7, C1_22);
        let t185 = t141 + t57 * t162 - t51 * t144;
        let t186 = K0_12_mH * t176;
        put_derivative(68, t186);
        let t187 = t163 + t163;
        let t188 = wx_delta2_delta_lam * t63;
        let t189 = self.mH * t176;
        put_derivative(69, t189);
        let t190 = self.zH * t176;
        put_derivative(70, t190);
        let K0_12 = t144 - (t169 + t115);
        put_entry(9, K0_12);
        let t196 = t169 - K0_12 + yaw_per_v_delta * (t55 + t60);
        let K0_22 = wx_delta2_delta * K0_12;
        put_entry(10, K0_22);
        let K1_12 = t61 * yaw_per_v_delta;
        put_entry(11, K1_12);
        put_derivative(71, K1_12);
        let t199 = t52 * K1_12;
        put_derivative(72, t199);
        let K2_22_SF = wx_delta2_delta * yaw_per_v_delta;
        put_derivative(73, K2_22_SF);
        let K2_22_IFyy = t62 * K2_22_SF;
        put_derivative(74, K2_22_IFyy);
        let K1_22 = self.hH * K2_22_SF;
        put_entry(12, K1_22);
        let t203 = t52 * K1_22;
        put_derivative(75, t203);
        let C1_12_IFyy = wz_delta2_delta * t62;
        put_derivative(76, C1_12_IFyy);
        let C1_21_rF = SF * C1_12_IFyy;
        put_derivative(77, C1_21_rF);
        let K2_12 = t100 * yaw_per_v_delta;
        put_entry(13, K2_12);
        put_derivative(78, K2_12);
        let t207 = t52 * K2_12;
        put_derivative(79, t207);
        let M_22 = wx_delta2_delta_lam * t185 + wx_delta2_delta * t135;
        put_entry(2, M_22);
        let t213 = wx_delta2_delta_lam * t135 - wx_delta2_delta * t185;
        let K2_22_yaw_per_v_delta = t94 - K0_12;
        let K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
        put_entry(14, K2_22);
        let t216 = self.mH * yaw_per_v_delta;
        put_derivative(80, t216);
        let t217 = self.xH * t216;
        let t219 = t96 + t57 * t217;
        let M_22_mu = self.c * t196;
        let t222 = t52 * (t162 + M_22_mu);
        let t223 = t96 - t217;
        let M_22_wz_delta2_delta = t196 - t76 * t223;
        let C1_22_c = yaw_per_v_delta * M_22_wz_delta2_delta;
        put_derivative(81, C1_22_c);
        let ay_delta2_delta_mB = t123 * t223;
        let M_22_c = t187 - ay_delta2_delta_mB;
        put_derivative(82, M_22_c);
        let M_22_lam = t213 + t213;
        put_derivative(83, M_22_lam);
        let t230 = t91 * yaw_per_v_delta;
        put_derivative(84, t230);
        let C1_21_w = t57 * t230;
        put_derivative(85, C1_21_w);
        let t232 = t56 * yaw_per_v_delta;
        let K0_12_c = t223 - t232;
        put_derivative(86, K0_12_c);
        let t236 = t57 * t187 + t219 * t123;
        put_derivative(87, t236);
        let K0_22_c = wx_delta2_delta * K0_12_c;
        put_derivative(88, K0_22_c);
        let t238 = yaw_per_v_delta * K0_12_c;
        put_derivative(89, t238);
        let t239 = t165 + t232;
        put_derivative(90, t239);
        let C1_22_xB = mu * (t232 + t239);
        put_derivative(91, C1_22_xB);
        let K0_12_w = t219 + t57 * t232;
        put_derivative(92, K0_12_w);
        let t244 = wx_delta2_delta * t57;
        let C1_21_lam = t94 + t91 * t244;
        put_derivative(93, C1_21_lam);
        let C1_22_IRxx = mu * yaw_per_v_delta;
        put_derivative(94, C1_22_IRxx);
        let M_22_IRxx = self.c * C1_22_IRxx;
        put_derivative(95, M_22_IRxx);
        let t251 = yaw_per_v_delta * (t76 * t219 + t222);
        put_derivative(96, t251);
        let K0_12_zH = self.mH * wx_delta2_delta;
        put_derivative(97, K0_12_zH);
        let t254 = t95 + t69 * K0_12_zH;
        let t257 = t52 * K2_22 + yaw_per_v_delta * K0_12_w;
        put_derivative(98, t257);
        let K0_22_w = wx_delta2_delta * K0_12_w;
        put_derivative(99, K0_22_w);
        let t259 = t123 * K0_12_zH;
        put_derivative(100, t259);
        let t265 = t84 + M_12_mu * t244 - t34 * wx_delta2_delta_lam - self.zH * t254;
        put_derivative(101, t265);
        let t267 = t254 + t56 * t244;
        let t268 = wx_delta2_delta * t52;
        let t269 = t61 * t268;
        put_derivative(102, t269);
        let t270 = t100 * t268;
        put_derivative(103, t270);
        let t271 = t96 * t268;
        put_derivative(104, t271);
        let t272 = t76 * t271;
        put_derivative(105, t272);
        let t273 = wx_delta2_delta_lam * yaw_per_v_delta;
        let C1_22_lam = wz_delta2_delta * t188 + self.IHxz * t273
            - wx_delta2_delta * (t115 + t222 + t55 * yaw_per_v_delta) - t176 * t254;
        put_derivative(106, C1_22_lam);
        let t286 = self.hH * (wx_delta2_delta * t268 - t273);
        put_derivative(107, t286);
        let C1_22_IHzz = t273 + C1_22_IRxx;
        put_derivative(108, C1_22_IHzz);
        let K2_22_mB = self.xB * C1_22_IRxx;
        put_derivative(109, K2_22_mB);
        let C1_22_mB = t79 * K2_22_mB;
        put_derivative(110, C1_22_mB);
        let M_12_rF = t115 + t115;
        put_derivative(111, M_12_rF);
        let M_22_rF = wx_delta2_delta * M_12_rF;
        put_derivative(112, M_22_rF);
        let K0_12_lam = t267 - t188;
        put_derivative(113, K0_12_lam);
        let t293 = t188 - t267;
        let K2_22_lam = yaw_per_v_delta * (t85 + t293) - K2_22_yaw_per_v_delta * t268;
        put_derivative(114, K2_22_lam);
        let t300 = wx_delta2_delta * t293 - wx_delta2_delta_lam * K0_12;
        put_derivative(115, t300);
        let t301 = self.zB * yaw_per_v_delta;
        put_derivative(116, t301);
        let t302 = t79 * t301;
        put_derivative(117, t302);
        let t303 = self.mH * wz_delta2_delta;
        put_derivative(118, t303);
        let M_22_xH = t123 * t303;
        put_derivative(119, M_22_xH);
        let C1_22_xH = yaw_per_v_delta * (t76 * t303 - t144);
        put_derivative(120, C1_22_xH);
        let t308 = wx_delta2_delta * t303;
        put_derivative(121, t308);
        let K2_22_xH = yaw_per_v_delta * t303;
        put_derivative(122, K2_22_xH);
        let M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
        put_derivative(123, M_22_IHxx);
        let K0_22_zH = self.mH * M_22_IHxx;
        put_derivative(124, K0_22_zH);
        let M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
        put_derivative(125, M_22_IHzz);
        let t313 = self.mF * wx_delta2_delta;
        put_derivative(126, t313);
        let C1_22_rF = wz_delta2_delta * t313;
        put_derivative(127, C1_22_rF);
        let t315 = self.mF * M_22_IHxx;
        put_derivative(128, t315);
        let M_22_IFxx = M_22_IHxx + M_22_IHzz;
        put_derivative(129, M_22_IFxx);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl FlywheelBicycle<f64> {
    /// The parameter set `benchmark`.
    ///
    /// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; the flywheel in the front wheel is an example
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
    /// | `hB` | 0 | `N*m*s` |
    /// | `hH` | 5 | `N*m*s` |
    pub const BENCHMARK: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3141592653589793, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.0603,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.05892, IHyy: 0.06, IHzz: 0.00708, IHxz: -0.00756,
        rF: 0.35, mF: 3.0, IFxx: 0.1405, IFyy: 0.28, hB: 0.0, hH: 5.0,
    };
}

impl FlywheelBicycle<f64> {
    /// The parameter set `benchmark`.
    #[must_use]
    pub const fn default() -> Self {
        Self::BENCHMARK
    }
}

/// The parameter set `benchmark`.
impl<T: Scalar> Default for FlywheelBicycle<T> {
    fn default() -> Self {
        FlywheelBicycle::cast(&FlywheelBicycle::<f64>::BENCHMARK)
    }
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> FlywheelBicycle<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 28]) -> Self {
        Self {
            w: values[0], c: values[1], lam: values[2], g: values[3], rR: values[4], mR: values[5],
            IRxx: values[6], IRyy: values[7], xB: values[8], zB: values[9], mB: values[10],
            IBxx: values[11], IByy: values[12], IBzz: values[13], IBxz: values[14], xH: values[15],
            zH: values[16], mH: values[17], IHxx: values[18], IHyy: values[19], IHzz: values[20],
            IHxz: values[21], rF: values[22], mF: values[23], IFxx: values[24], IFyy: values[25],
            hB: values[26], hH: values[27],
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
            self.hB, self.hH,
        ]
    }
}

impl<T: Scalar> FlywheelBicycle<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> FlywheelBicycle<U> {
        let values = self.to_array();
        FlywheelBicycle::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl FlywheelBicycle<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> FlywheelBicycle<f32> {
        FlywheelBicycle::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<FlywheelBicycle<f32>> for FlywheelBicycle<f64> {
    fn from(parameters: FlywheelBicycle<f32>) -> Self {
        FlywheelBicycle::cast(&parameters)
    }
}

impl<T: Number> FlywheelBicycleMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 24]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c0: carvallo::rows(&entries, 4),
            c1: carvallo::rows(&entries, 8),
            k0: carvallo::rows(&entries, 12),
            k1: carvallo::rows(&entries, 16),
            k2: carvallo::rows(&entries, 20),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 15] {
        [
            self.m[0][0], self.m[0][1], self.m[1][1], self.c0[0][1], self.c0[1][0], self.c1[0][1],
            self.c1[1][0], self.c1[1][1], self.k0[0][0], self.k0[0][1], self.k0[1][1],
            self.k1[0][1], self.k1[1][1], self.k2[0][1], self.k2[1][1],
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
                self.c0[0][1] = entry;
            }
            4 => {
                self.c0[1][0] = entry;
            }
            5 => {
                self.c1[0][1] = entry;
            }
            6 => {
                self.c1[1][0] = entry;
            }
            7 => {
                self.c1[1][1] = entry;
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
                self.k1[0][1] = entry;
            }
            12 => {
                self.k1[1][1] = entry;
            }
            13 => {
                self.k2[0][1] = entry;
            }
            14 => {
                self.k2[1][1] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 2]; 2];
        [self.m.0, zeros, self.c0.0, self.c1.0, zeros, self.k0.0, self.k1.0, self.k2.0]
    }
}

impl<T: Scalar> From<FlywheelBicycleMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: FlywheelBicycleMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for FlywheelBicycle<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 28];

    type Over<U: Number> = FlywheelBicycle<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "FlywheelBicycle",
        docs: "A bicycle with flywheels: rotors that spin at a constant rate in its frames.\n\nThe Whipple-Carvallo bicycle with a flywheel in the front wheel, as learners ride it, and one in the rear frame. Their\nangular momenta are independent of the speed, so they act at rest as well; against the wheels they cancel what those\ndo at one speed. The masses and moments of inertia of the flywheels are parts of those of the frames. Axes: origin at\nthe rear contact point, x forward, y to the right, z down.\n\nThe declaration asserts that the matrices are those of Appendix A of the paper and, for the flywheels, its terms of the\nwheels with angular momenta in the place of those of wheels that roll.",
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
            ParameterInfo::new("hB", "N*m*s", Domain::FINITE)
                .docs("Angular momentum of the flywheel in the rear frame, positive as the wheels turn."),
            ParameterInfo::new("hH", "N*m*s", Domain::FINITE)
                .docs("Angular momentum of the flywheel in the front frame, positive as the wheels turn."),
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
            MatrixName::M, MatrixName::C0, MatrixName::C1, MatrixName::K0, MatrixName::K1,
            MatrixName::K2,
        ],
        entries: &[
            EntryInfo::at(&[(MatrixName::M, 0, 0)]),
            EntryInfo::at(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)]),
            EntryInfo::at(&[(MatrixName::M, 1, 1)]), EntryInfo::at(&[(MatrixName::C0, 0, 1)]),
            EntryInfo::at(&[(MatrixName::C0, 1, 0)]), EntryInfo::at(&[(MatrixName::C1, 0, 1)]),
            EntryInfo::at(&[(MatrixName::C1, 1, 0)]), EntryInfo::at(&[(MatrixName::C1, 1, 1)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)]),
            EntryInfo::at(&[(MatrixName::K0, 1, 1)]), EntryInfo::at(&[(MatrixName::K1, 0, 1)]),
            EntryInfo::at(&[(MatrixName::K1, 1, 1)]), EntryInfo::at(&[(MatrixName::K2, 0, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 1, 1)]),
        ],
        sets: &[
            SetInfo {
                name: "benchmark",
                docs: "",
                source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; the flywheel in the front wheel is an example",
                values: &FlywheelBicycle::to_array(&FlywheelBicycle::<f64>::BENCHMARK),
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
            FormulaInfo::entry(&[(MatrixName::C0, 0, 1)], "kg*m^2/s", "hH*cos(lam) + mu*(hB + hH)"),
            FormulaInfo::entry(&[(MatrixName::C0, 1, 0)], "kg*m^2/s", "-(hH*cos(lam) + mu*(hB + hH))"),
            FormulaInfo::entry(
                &[(MatrixName::C1, 0, 1)],
                "kg*m",
                "mu*(ST - Sz_all) + SF*cos(lam) + yaw_per_v_delta*Jxz_all",
            ),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 0)], "kg*m", "-(mu*ST + SF*cos(lam))"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 1)], "kg*m", "mu*P_delta_lateral + yaw_per_v_delta*P_delta_yaw"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "Sz_all"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)], "kg*m", "K_phi_delta"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "K_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::K1, 0, 1)], "kg*m/s", "yaw_per_v_delta*(hB + hH)"),
            FormulaInfo::entry(&[(MatrixName::K1, 1, 1)], "kg*m/s", "hH*yaw_per_v_delta*sin(lam)"),
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
            FormulaInfo::attribute(
                "B_momentum_y", "y of the momentum in the rear frame and rider B", "kg*m^2/s",
                "-hB",
            ),
            FormulaInfo::attribute("H_momentum_y", "y of the momentum in the front frame H", "kg*m^2/s", "-hH"),
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
            FormulaInfo::entry(
                &[(MatrixName::C0, 0, 1)],
                "kg*m^2/s",
                "(delta_along_x*H_momentum_y*yaw_by_phi_ - delta_along_z*H_momentum_y - length_delta*yaw_by_delta*(B_momentum_y + H_momentum_y))/length_delta",
            ),
            FormulaInfo::entry(
                &[(MatrixName::C0, 1, 0)],
                "kg*m^2/s",
                "(delta_along_z*H_momentum_y + length_delta*yaw_by_delta*(B_momentum_y + H_momentum_y) - delta_along_x*H_momentum_y*yaw_by_phi_)/length_delta",
            ),
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
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "K_phi_phi"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)], "kg*m", "K_phi_delta"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "K_delta_delta"),
            FormulaInfo::entry(&[(MatrixName::K1, 0, 1)], "kg*m/s", "-yaw_per_v_delta*(B_momentum_y + H_momentum_y)"),
            FormulaInfo::entry(
                &[(MatrixName::K1, 1, 1)],
                "kg*m/s",
                "-delta_along_x*H_momentum_y*yaw_per_v_delta/length_delta",
            ),
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
        LengthError::check("FlywheelBicycle", 28, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("FlywheelBicycle", 28, values)?;
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
        Coefficients::from_rows(FlywheelBicycleMatrices::rows(&self.matrices()))
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

impl FlywheelBicycle<f64> {
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
impl<T: Scalar> core::fmt::Display for FlywheelBicycle<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for FlywheelBicycle<T> {
    type Entries = [T; 15];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            w: parameter(0), c: parameter(1), lam: parameter(2), g: parameter(3), rR: parameter(4),
            mR: parameter(5), IRxx: parameter(6), IRyy: parameter(7), xB: parameter(8),
            zB: parameter(9), mB: parameter(10), IBxx: parameter(11), IByy: parameter(12),
            IBzz: parameter(13), IBxz: parameter(14), xH: parameter(15), zH: parameter(16),
            mH: parameter(17), IHxx: parameter(18), IHyy: parameter(19), IHzz: parameter(20),
            IHxz: parameter(21), rF: parameter(22), mF: parameter(23), IFxx: parameter(24),
            IFyy: parameter(25), hB: parameter(26), hH: parameter(27),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        FlywheelBicycleMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        FlywheelBicycleMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> FlywheelBicycleDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<FlywheelBicycleMatrices<T>> {
        if parameter >= 28 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = FlywheelBicycleMatrices {
            m: Rows([[zero; 2]; 2]), c0: Rows([[zero; 2]; 2]), c1: Rows([[zero; 2]; 2]),
            k0: Rows([[zero; 2]; 2]), k1: Rows([[zero; 2]; 2]), k2: Rows([[zero; 2]; 2]),
        };
        for position in 0..175 {
            let partial = <FlywheelBicycleDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C0 => &mut matrices.c0,
                MatrixName::C1 => &mut matrices.c1,
                MatrixName::K0 => &mut matrices.k0,
                MatrixName::K1 => &mut matrices.k1,
                MatrixName::K2 => &mut matrices.k2,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<2> for FlywheelBicycle<T> {
    type Derivatives = [Coefficients<T, 2>; 28];

    type WithDerivativesOver<U: Number> = FlywheelBicycle<U>;

    const PARTIALS: &'static [Partial] = <FlywheelBicycleDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 28];
        for position in 0..175 {
            Partial::write(&<FlywheelBicycleDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(FlywheelBicycleMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for FlywheelBicycle<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl FlywheelBicycleDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 175] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 52),
        Partial::new(MatrixName::M, 1, 0, 0, 52),
        Partial::new(MatrixName::M, 1, 1, 0, 87).negative(),
        Partial::new(MatrixName::C0, 0, 1, 0, 23).negative(),
        Partial::new(MatrixName::C0, 1, 0, 0, 23),
        Partial::new(MatrixName::C1, 0, 1, 0, 54).negative(),
        Partial::new(MatrixName::C1, 1, 0, 0, 85),
        Partial::new(MatrixName::C1, 1, 1, 0, 96).negative(),
        Partial::new(MatrixName::K0, 0, 1, 0, 92),
        Partial::new(MatrixName::K0, 1, 0, 0, 92),
        Partial::new(MatrixName::K0, 1, 1, 0, 99),
        Partial::new(MatrixName::K1, 0, 1, 0, 72).negative(),
        Partial::new(MatrixName::K1, 1, 1, 0, 75).negative(),
        Partial::new(MatrixName::K2, 0, 1, 0, 79).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 98).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 53), Partial::new(MatrixName::M, 1, 0, 1, 53),
        Partial::new(MatrixName::M, 1, 1, 1, 82), Partial::new(MatrixName::C0, 0, 1, 1, 71),
        Partial::new(MatrixName::C0, 1, 0, 1, 71).negative(),
        Partial::new(MatrixName::C1, 0, 1, 1, 78),
        Partial::new(MatrixName::C1, 1, 0, 1, 84).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 81), Partial::new(MatrixName::K0, 0, 1, 1, 86),
        Partial::new(MatrixName::K0, 1, 0, 1, 86), Partial::new(MatrixName::K0, 1, 1, 1, 88),
        Partial::new(MatrixName::K2, 1, 1, 1, 89).negative(),
        Partial::new(MatrixName::M, 0, 1, 2, 101).negative(),
        Partial::new(MatrixName::M, 1, 0, 2, 101).negative(),
        Partial::new(MatrixName::M, 1, 1, 2, 83),
        Partial::new(MatrixName::C0, 0, 1, 2, 20).negative(),
        Partial::new(MatrixName::C0, 1, 0, 2, 20),
        Partial::new(MatrixName::C1, 0, 1, 2, 66).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 93), Partial::new(MatrixName::C1, 1, 1, 2, 106),
        Partial::new(MatrixName::K0, 0, 1, 2, 113), Partial::new(MatrixName::K0, 1, 0, 2, 113),
        Partial::new(MatrixName::K0, 1, 1, 2, 115).negative(),
        Partial::new(MatrixName::K1, 0, 1, 2, 102).negative(),
        Partial::new(MatrixName::K1, 1, 1, 2, 107).negative(),
        Partial::new(MatrixName::K2, 0, 1, 2, 103).negative(),
        Partial::new(MatrixName::K2, 1, 1, 2, 114), Partial::new(MatrixName::M, 0, 0, 4, 11),
        Partial::new(MatrixName::C1, 0, 1, 4, 39), Partial::new(MatrixName::C1, 1, 0, 4, 25),
        Partial::new(MatrixName::K0, 0, 0, 4, 1).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 26), Partial::new(MatrixName::M, 0, 0, 5, 12),
        Partial::new(MatrixName::C1, 0, 1, 5, 27),
        Partial::new(MatrixName::K0, 0, 0, 5, 0).negative(),
        Partial::new(MatrixName::K2, 0, 1, 5, 28), Partial::new(MatrixName::M, 0, 0, 6, 8),
        Partial::new(MatrixName::M, 1, 1, 6, 95), Partial::new(MatrixName::C1, 1, 1, 6, 94),
        Partial::new(MatrixName::C1, 0, 1, 7, 30),
        Partial::new(MatrixName::C1, 1, 0, 7, 30).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 29),
        Partial::new(MatrixName::M, 0, 1, 8, 32).negative(),
        Partial::new(MatrixName::M, 1, 0, 8, 32).negative(),
        Partial::new(MatrixName::M, 1, 1, 8, 65),
        Partial::new(MatrixName::C1, 0, 1, 8, 31).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 91),
        Partial::new(MatrixName::K0, 0, 1, 8, 60).negative(),
        Partial::new(MatrixName::K0, 1, 0, 8, 60).negative(),
        Partial::new(MatrixName::K0, 1, 1, 8, 61).negative(),
        Partial::new(MatrixName::K2, 1, 1, 8, 62), Partial::new(MatrixName::M, 0, 0, 9, 13),
        Partial::new(MatrixName::M, 0, 1, 9, 63).negative(),
        Partial::new(MatrixName::M, 1, 0, 9, 63).negative(),
        Partial::new(MatrixName::C1, 0, 1, 9, 90).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 3),
        Partial::new(MatrixName::K2, 0, 1, 9, 59).negative(),
        Partial::new(MatrixName::M, 0, 0, 10, 14),
        Partial::new(MatrixName::M, 0, 1, 10, 56).negative(),
        Partial::new(MatrixName::M, 1, 0, 10, 56).negative(),
        Partial::new(MatrixName::M, 1, 1, 10, 57),
        Partial::new(MatrixName::C1, 0, 1, 10, 117).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 110),
        Partial::new(MatrixName::K0, 0, 0, 10, 2),
        Partial::new(MatrixName::K0, 0, 1, 10, 55).negative(),
        Partial::new(MatrixName::K0, 1, 0, 10, 55).negative(),
        Partial::new(MatrixName::K0, 1, 1, 10, 58).negative(),
        Partial::new(MatrixName::K2, 0, 1, 10, 116).negative(),
        Partial::new(MatrixName::K2, 1, 1, 10, 109), Partial::new(MatrixName::M, 0, 0, 11, 8),
        Partial::new(MatrixName::M, 1, 1, 13, 95), Partial::new(MatrixName::C1, 1, 1, 13, 94),
        Partial::new(MatrixName::M, 0, 1, 14, 18), Partial::new(MatrixName::M, 1, 0, 14, 18),
        Partial::new(MatrixName::C1, 0, 1, 14, 19),
        Partial::new(MatrixName::M, 0, 1, 15, 47).negative(),
        Partial::new(MatrixName::M, 1, 0, 15, 47).negative(),
        Partial::new(MatrixName::M, 1, 1, 15, 119),
        Partial::new(MatrixName::C1, 0, 1, 15, 33).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 120),
        Partial::new(MatrixName::K0, 0, 1, 15, 118).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 118).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 121).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 122), Partial::new(MatrixName::M, 0, 0, 16, 15),
        Partial::new(MatrixName::M, 0, 1, 16, 41), Partial::new(MatrixName::M, 1, 0, 16, 41),
        Partial::new(MatrixName::M, 1, 1, 16, 100).negative(),
        Partial::new(MatrixName::C1, 0, 1, 16, 69).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 105).negative(),
        Partial::new(MatrixName::K0, 0, 0, 16, 5), Partial::new(MatrixName::K0, 0, 1, 16, 97),
        Partial::new(MatrixName::K0, 1, 0, 16, 97), Partial::new(MatrixName::K0, 1, 1, 16, 124),
        Partial::new(MatrixName::K2, 0, 1, 16, 80).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 104).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 16), Partial::new(MatrixName::M, 0, 1, 17, 45),
        Partial::new(MatrixName::M, 1, 0, 17, 45), Partial::new(MatrixName::M, 1, 1, 17, 42),
        Partial::new(MatrixName::C1, 0, 1, 17, 70).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 68).negative(),
        Partial::new(MatrixName::K0, 0, 0, 17, 4), Partial::new(MatrixName::K0, 0, 1, 17, 40),
        Partial::new(MatrixName::K0, 1, 0, 17, 40), Partial::new(MatrixName::K0, 1, 1, 17, 43),
        Partial::new(MatrixName::K2, 0, 1, 17, 34).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 44).negative(),
        Partial::new(MatrixName::M, 0, 0, 18, 8), Partial::new(MatrixName::M, 0, 1, 18, 9),
        Partial::new(MatrixName::M, 1, 0, 18, 9), Partial::new(MatrixName::M, 1, 1, 18, 123),
        Partial::new(MatrixName::M, 1, 1, 20, 125), Partial::new(MatrixName::C1, 1, 1, 20, 108),
        Partial::new(MatrixName::M, 0, 1, 21, 46), Partial::new(MatrixName::M, 1, 0, 21, 46),
        Partial::new(MatrixName::M, 1, 1, 21, 64), Partial::new(MatrixName::C1, 0, 1, 21, 19),
        Partial::new(MatrixName::C1, 1, 1, 21, 73), Partial::new(MatrixName::M, 0, 0, 22, 17),
        Partial::new(MatrixName::M, 0, 1, 22, 111), Partial::new(MatrixName::M, 1, 0, 22, 111),
        Partial::new(MatrixName::M, 1, 1, 22, 112), Partial::new(MatrixName::C1, 0, 1, 22, 48),
        Partial::new(MatrixName::C1, 1, 0, 22, 77), Partial::new(MatrixName::C1, 1, 1, 22, 127),
        Partial::new(MatrixName::K0, 0, 0, 22, 7).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 126).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 126).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 128).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 49), Partial::new(MatrixName::K2, 1, 1, 22, 50),
        Partial::new(MatrixName::M, 0, 0, 23, 10), Partial::new(MatrixName::M, 0, 1, 23, 21),
        Partial::new(MatrixName::M, 1, 0, 23, 21), Partial::new(MatrixName::M, 1, 1, 23, 24),
        Partial::new(MatrixName::C1, 0, 1, 23, 51), Partial::new(MatrixName::C1, 1, 1, 23, 67),
        Partial::new(MatrixName::K0, 0, 0, 23, 6).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 22).negative(),
        Partial::new(MatrixName::K0, 1, 0, 23, 22).negative(),
        Partial::new(MatrixName::K0, 1, 1, 23, 35).negative(),
        Partial::new(MatrixName::K2, 0, 1, 23, 36), Partial::new(MatrixName::K2, 1, 1, 23, 37),
        Partial::new(MatrixName::M, 0, 0, 24, 8), Partial::new(MatrixName::M, 0, 1, 24, 9),
        Partial::new(MatrixName::M, 1, 0, 24, 9), Partial::new(MatrixName::M, 1, 1, 24, 129),
        Partial::new(MatrixName::C1, 1, 1, 24, 108), Partial::new(MatrixName::C1, 0, 1, 25, 76),
        Partial::new(MatrixName::C1, 1, 0, 25, 76).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 38),
        Partial::new(MatrixName::K2, 1, 1, 25, 74),
        Partial::new(MatrixName::C0, 0, 1, 26, 18),
        Partial::new(MatrixName::C0, 1, 0, 26, 18).negative(),
        Partial::new(MatrixName::K1, 0, 1, 26, 19),
        Partial::new(MatrixName::C0, 0, 1, 27, 46),
        Partial::new(MatrixName::C0, 1, 0, 27, 46).negative(),
        Partial::new(MatrixName::K1, 0, 1, 27, 19),
        Partial::new(MatrixName::K1, 1, 1, 27, 73),
    ];
}
