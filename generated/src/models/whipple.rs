// @generated from generated/models/whipple.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 1f3729bd81655189

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, RequirementInfo, Rows, Scalar,
    SetInfo, WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// The Whipple-Carvallo bicycle: the linearized equations of lean and steer about upright straight running.
///
/// Four rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally
/// symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,
/// x forward, y to the right, z down, so that a centre of mass above the ground has z < 0.
///
/// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, Appendix A
///
/// The fields are the parameters. The coordinates are `phi` (lean) in `rad`, `delta` (steer) in `rad`.
///
/// Beside what is said of each field, `validate` requires of them:
///
/// - `mR + mB + mH + mF` in `kg`: `> 0`;
/// - `mH + mF` in `kg`: `> 0`.
///
/// <details><summary>The formulas of its matrices</summary>
///
/// ```text
/// mT = mR + mB + mH + mF [kg]
/// xT = (xB*mB + xH*mH + w*mF)/mT [m]
/// zT = (-rR*mR + zB*mB + zH*mH - rF*mF)/mT [m]
/// ITxx = IRxx + IBxx + IHxx + IFxx + mR*rR^2 + mB*zB^2 + mH*zH^2 + mF*rF^2 [kg*m^2]
/// ITxz = IBxz + IHxz - mB*xB*zB - mH*xH*zH + mF*w*rF [kg*m^2]
/// ITzz = IRxx + IBzz + IHzz + IFxx + mB*xB^2 + mH*xH^2 + mF*w^2 [kg*m^2]
/// mA = mH + mF [kg]
/// xA = (xH*mH + w*mF)/mA [m]
/// zA = (zH*mH - rF*mF)/mA [m]
/// IAxx = IHxx + IFxx + mH*(zH - zA)^2 + mF*(rF + zA)^2 [kg*m^2]
/// IAxz = IHxz - mH*(xH - xA)*(zH - zA) + mF*(w - xA)*(rF + zA) [kg*m^2]
/// IAzz = IHzz + IFxx + mH*(xH - xA)^2 + mF*(w - xA)^2 [kg*m^2]
/// uA = (xA - w - c)*cos(lam) - zA*sin(lam) [m]
/// IAll = mA*uA^2 + IAxx*sin(lam)^2 + 2*IAxz*sin(lam)*cos(lam) + IAzz*cos(lam)^2 [kg*m^2]
/// IAlx = -mA*uA*zA + IAxx*sin(lam) + IAxz*cos(lam) [kg*m^2]
/// IAlz = mA*uA*xA + IAxz*sin(lam) + IAzz*cos(lam) [kg*m^2]
/// mu = (c/w)*cos(lam) [1]
/// SR = IRyy/rR [kg*m]
/// SF = IFyy/rF [kg*m]
/// ST = SR + SF [kg*m]
/// SA = mA*uA + mu*mT*xT [kg*m]
/// M_11 = ITxx [kg*m^2]
/// M_12 = M_21 = IAlx + mu*ITxz [kg*m^2]
/// M_22 = IAll + 2*mu*IAlz + mu^2*ITzz [kg*m^2]
/// C1_12 = mu*ST + SF*cos(lam) + (ITxz/w)*cos(lam) - mu*mT*zT [kg*m]
/// C1_21 = -(mu*ST + SF*cos(lam)) [kg*m]
/// C1_22 = (IAlz/w)*cos(lam) + mu*(SA + (ITzz/w)*cos(lam)) [kg*m]
/// K0_11 = mT*zT [kg*m]
/// K0_12 = K0_21 = -SA [kg*m]
/// K0_22 = -SA*sin(lam) [kg*m]
/// K2_12 = ((ST - mT*zT)/w)*cos(lam) [kg]
/// K2_22 = ((SA + SF*sin(lam))/w)*cos(lam) [kg]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Whipple<T = f64> {
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
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`Whipple`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 2>,
}

impl<T: Number> Whipple<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 49 additions, 50 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 105 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleMatrices<T> {
        let t4 = self.rR * self.mR;
        let t8 = self.zB * self.mB;
        let t12 = self.rF * self.mF;
        let t16 = self.zH * self.mH;
        let t22 = self.rF * t12 + self.zH * t16 + self.IHxx + self.IFxx;
        let ITxx = self.IRxx + self.IBxx + self.rR * t4 + self.zB * t8 + t22;
        let t36 = self.IHxz + t12 * self.w - t16 * self.xH;
        let ITxz = self.IBxz + t36 - t8 * self.xB;
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t42 = cos_lam / self.w;
        let mu = self.c * t42;
        let t47 = self.w + self.c - self.xH;
        let t51 = cos_lam * (self.IHxz + t16 * t47 - t12 * self.c);
        let t54 = t51 + t22 * sin_lam;
        let M_12 = ITxz * mu + t54;
        let t57 = self.IFxx + self.IHzz;
        let t58 = self.mH * t47;
        let t60 = self.mF * self.c;
        let t69 = self.mH * self.xH;
        let IAlz = cos_lam * (t57 - self.w * t60 - t47 * t69) + t36 * sin_lam;
        let t77 = self.mB * self.xB;
        let t80 = self.mF * self.w;
        let ITzz = self.IRxx + t57 + self.IBzz + self.xB * t77 + self.xH * t69
            + self.w * t80;
        let t88 = IAlz + mu * ITzz;
        let M_22 = cos_lam * cos_lam * (t57 + t47 * t58 + self.c * t60)
            + sin_lam * (t51 + t54) + mu * (IAlz + t88);
        let zero = self.w.like(0.0);
        let SF = self.IFyy / self.rF;
        let SR = self.IRyy / self.rR;
        let ST = SF + SR;
        let t100 = t12 - t16;
        let t101 = t8 - t4;
        let t103 = ST + (t100 - t101);
        let C1_12 = t42 * (ITxz + self.w * SF + self.c * t103);
        let K0_12 = cos_lam * (t58 + t60) - (mu * (t69 + t77 + t80) + sin_lam * t100);
        let C1_22 = t42 * t88 - mu * K0_12;
        let K0_22 = sin_lam * K0_12;
        let K2_12 = t42 * t103;
        let K2_22 = t42 * (sin_lam * SF - K0_12);
        let C1_21 = -(mu * ST + cos_lam * SF);
        let K0_11 = t101 - t100;
        WhippleMatrices::from_entries([
            ITxx, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, K0_11, K0_12, K0_12, K0_22, zero,
            K2_12, zero, K2_22,
        ])
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`Whipple`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 124],
}

impl<T: Number> Whipple<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 97 additions, 188 multiplications, 3 divisions, 3 negations and 2 trigonometric functions: 293 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WhippleMatrices<T>, WhippleDerivatives<T>) {
        let zero = self.w.like(0.0);
        let mut matrices = WhippleMatrices::from_entries([zero; 16]);
        let mut derivatives = WhippleDerivatives {
            values: [zero; 124],
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
        matrices: &mut WhippleMatrices<T>,
        derivatives: &mut WhippleDerivatives<T>,
    ) {
        *matrices = WhippleMatrices::from_entries([self.w.like(0.0); 16]);
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
        let M_11_mF = self.rF * self.rF;
        put_derivative(10, M_11_mF);
        let t28 = self.zH * self.mH;
        let t33 = self.IFxx + self.IHxx + self.mF * M_11_mF + self.zH * t28;
        let t34 = self.rR * self.mR;
        let t35 = self.zB * self.mB;
        let t36 = self.mF * self.rF;
        let M_11_rR = t34 + t34;
        put_derivative(11, M_11_rR);
        let M_11_mR = self.rR * self.rR;
        put_derivative(12, M_11_mR);
        let M_11_zB = t35 + t35;
        put_derivative(13, M_11_zB);
        let M_11_mB = self.zB * self.zB;
        put_derivative(14, M_11_mB);
        let M_11_zH = t28 + t28;
        put_derivative(15, M_11_zH);
        let M_11_mH = self.zH * self.zH;
        put_derivative(16, M_11_mH);
        let M_11_rF = t36 + t36;
        put_derivative(17, M_11_rF);
        let t44 = self.mF * self.w;
        let t48 = t28 * self.xH - self.IHxz - self.rF * t44;
        let M_11 = t33 + self.IRxx + self.IBxx + self.rR * t34 + self.zB * t35;
        put_entry(0, M_11);
        let t55 = self.w.like(1.0) / self.w;
        let t56 = self.c + self.w;
        let t57 = self.xH - t56;
        let t58 = self.mH * t57;
        let t60 = self.IBxz - t35 * self.xB;
        let t61 = self.IFxx + self.IHzz;
        let t62 = t48 * t55;
        let t63 = self.c * t55;
        let t65 = self.IHxz - self.zH * t58;
        let t66 = self.mH * self.xH;
        let t68 = t61 + self.xH * t66;
        let t69 = self.mB * self.xB;
        let t70 = self.w.like(1.0) / self.rF;
        let t71 = self.w.like(1.0) / self.rR;
        let t72 = t36 + t62;
        let t73 = t28 - t36;
        let K0_11 = t35 + t73 - t34;
        put_entry(6, K0_11);
        let t83 = t44
            - t55 * (self.IRxx + t68 + self.xB * t69 + self.w * t44 + self.IBzz);
        let t87 = self.mF - t55 * (t44 + t66 + t69);
        let t90 = cos_lam * (t57 + self.xH * t63);
        let t95 = t33 * sin_lam - cos_lam * (self.c * t72 - t65);
        let t97 = t72 - t55 * t60;
        let C1_12_IBxz = cos_lam * t55;
        put_derivative(18, C1_12_IBxz);
        let K2_12_mR = self.rR * C1_12_IBxz;
        put_derivative(19, K2_12_mR);
        let t100 = t35 * C1_12_IBxz;
        put_derivative(20, t100);
        let K2_22_SF = sin_lam * C1_12_IBxz;
        put_derivative(21, K2_22_SF);
        let M_12_lam = t33 * cos_lam + sin_lam * (self.c * t97 - t65);
        put_derivative(22, M_12_lam);
        let M_12_w = cos_lam * (t28 + t63 * t97);
        put_derivative(23, M_12_w);
        let M_12_c = cos_lam * (t28 - t97);
        put_derivative(24, M_12_c);
        let mu = self.c * C1_12_IBxz;
        put_derivative(25, mu);
        let t113 = t35 * mu;
        put_derivative(26, t113);
        let C1_12_mR = self.rR * mu;
        put_derivative(27, C1_12_mR);
        let t115 = mu * t69;
        put_derivative(28, t115);
        let M_12_IHxz = cos_lam + mu;
        put_derivative(29, M_12_IHxz);
        let t117 = self.zH * sin_lam;
        let K0_12_mH = t117 - t90;
        put_derivative(30, K0_12_mH);
        let t119 = t90 - t117;
        let K0_12_mF = self.c * (cos_lam - self.w * C1_12_IBxz) - self.rF * sin_lam;
        put_derivative(31, K0_12_mF);
        let M_12_zH = self.mH * (t117 - t119);
        put_derivative(32, M_12_zH);
        let M_12 = t95 + mu * t60;
        put_entry(1, M_12);
        let t129 = self.zH * t119;
        put_derivative(33, t129);
        let M_22_mH = t119 * t119;
        put_derivative(34, M_22_mH);
        let t131 = sin_lam * t119;
        put_derivative(35, t131);
        let SF = self.IFyy * t70;
        let t133 = self.IRyy * t71;
        let t138 = C1_12_IBxz * (self.c * t83 + t56 * t66 - t68);
        let K2_12_IRyy = C1_12_IBxz * t71;
        put_derivative(36, K2_12_IRyy);
        let t140 = self.rF * K0_12_mF;
        put_derivative(37, t140);
        let M_22_mF = K0_12_mF * K0_12_mF;
        put_derivative(38, M_22_mF);
        let K0_22_mF = sin_lam * K0_12_mF;
        put_derivative(39, K0_22_mF);
        let t143 = self.mF * K0_12_mF;
        let t144 = C1_12_IBxz * K0_12_mF;
        put_derivative(40, t144);
        let ST = SF + t133;
        let t146 = ST - K0_11;
        let t152 = t55 * (t60 + self.w * SF + self.c * t146 - t48);
        let t153 = t56 * t144;
        put_derivative(41, t153);
        let K2_12 = C1_12_IBxz * t146;
        put_entry(9, K2_12);
        put_derivative(42, K2_12);
        let t155 = t55 * t146;
        let t156 = C1_12_IBxz * t155;
        put_derivative(43, t156);
        let t157 = sin_lam * t155;
        put_derivative(44, t157);
        let t158 = C1_12_IBxz * ST;
        put_derivative(45, t158);
        let t159 = t63 * ST;
        let C1_21_w = C1_12_IBxz * t159;
        put_derivative(46, C1_21_w);
        let t161 = SF + t159;
        let C1_21_lam = sin_lam * t161;
        put_derivative(47, C1_21_lam);
        let C1_21 = -(cos_lam * t161);
        put_entry(4, C1_21);
        let M_12_rF = sin_lam * t36 - t143;
        put_derivative(48, M_12_rF);
        let t167 = self.c * t87;
        let t168 = t58 - t167;
        let K0_12 = sin_lam * t73 - cos_lam * t168;
        put_entry(7, K0_12);
        let K0_12_lam = cos_lam * t73 + sin_lam * t168;
        put_derivative(49, K0_12_lam);
        let t176 = t138 + sin_lam * t62;
        let t177 = cos_lam + cos_lam;
        let t178 = t119 + t119;
        let t179 = self.mH * cos_lam;
        let t180 = t178 * t179;
        let t181 = self.c + self.xH;
        let t182 = t179 * t181;
        let K0_12_w = t179 - mu * t87;
        put_derivative(50, K0_12_w);
        let t187 = K0_12 + cos_lam * (t83 + t167);
        let K0_22 = sin_lam * K0_12;
        put_entry(8, K0_22);
        let K0_12_c = t179 + cos_lam * t87;
        put_derivative(51, K0_12_c);
        let K0_22_c = sin_lam * K0_12_c;
        put_derivative(52, K0_22_c);
        let t192 = C1_12_IBxz * K0_12_c;
        put_derivative(53, t192);
        let ITzz_mF = t36 + SF - t152;
        let C1_12_w = C1_12_IBxz * ITzz_mF;
        put_derivative(54, C1_12_w);
        let C1_12 = cos_lam * t152;
        put_entry(3, C1_12);
        let t197 = sin_lam * t152;
        put_derivative(55, t197);
        let K0_22_lam = cos_lam * K0_12 + sin_lam * K0_12_lam;
        put_derivative(56, K0_22_lam);
        let t201 = t55 * t179;
        put_derivative(57, t201);
        let t202 = self.zH * t201;
        put_derivative(58, t202);
        let t204 = -(sin_lam * K0_12_w);
        put_derivative(59, t204);
        let t205 = t143 - t176;
        let t212 = M_12_IHxz * t61 + sin_lam * self.IHxz + t58 * t119 + self.c * t205;
        let t214 = t176 + t63 * K0_12;
        let t216 = sin_lam * SF - K0_12;
        let K2_22 = C1_12_IBxz * t216;
        put_entry(10, K2_22);
        let t221 = C1_12_IBxz * (t205 + t182 - t63 * t187);
        put_derivative(60, t221);
        let t223 = C1_12_IBxz * (t182 + t187);
        put_derivative(61, t223);
        let t224 = t205 * t177;
        let t226 = t63 * t224 + t180;
        put_derivative(62, t226);
        let M_22_c = t224 - t180;
        put_derivative(63, M_22_c);
        let t228 = t55 * t216;
        let t230 = C1_12_IBxz * (K0_12_w + t228);
        put_derivative(64, t230);
        let t231 = t55 * t182;
        put_derivative(65, t231);
        let K2_22_mH = C1_12_IBxz * t119;
        put_derivative(66, K2_22_mH);
        let C1_22_xH = self.mH * K2_22_mH + M_12_IHxz * t231;
        put_derivative(67, C1_22_xH);
        let C1_22_mH = t181 * K2_22_mH;
        put_derivative(68, C1_22_mH);
        let C1_22 = -(cos_lam * t214);
        put_entry(5, C1_22);
        let t239 = sin_lam + sin_lam;
        let t240 = t143 * t239;
        put_derivative(69, t240);
        let M_22_IHxz = M_12_IHxz * t239;
        put_derivative(70, M_22_IHxz);
        let t242 = cos_lam * C1_12_IBxz;
        let C1_22_lam = sin_lam * (t138 + t214) - mu * K0_12_lam - t48 * t242;
        put_derivative(71, C1_22_lam);
        let M_22_lam = t95 * t177 - t212 * t239;
        put_derivative(72, M_22_lam);
        let M_22 = sin_lam * t95 + cos_lam * t212;
        put_entry(2, M_22);
        let K2_22_lam = SF * t242 - C1_12_IBxz * K0_12_lam - sin_lam * t228;
        put_derivative(73, K2_22_lam);
        let C1_22_ITzz = t63 * t242;
        put_derivative(74, C1_22_ITzz);
        let C1_22_IHzz = t242 + C1_22_ITzz;
        put_derivative(75, C1_22_IHzz);
        let K2_22_xH = self.mH * C1_22_IHzz;
        put_derivative(76, K2_22_xH);
        let K2_22_xB = self.mB * C1_22_ITzz;
        put_derivative(77, K2_22_xB);
        let K2_12_rR = self.mR * C1_12_IBxz - t133 * K2_12_IRyy;
        put_derivative(78, K2_12_rR);
        let C1_12_rR = self.c * K2_12_rR;
        put_derivative(79, C1_12_rR);
        let C1_12_IRyy = self.c * K2_12_IRyy;
        put_derivative(80, C1_12_IRyy);
        let C1_21_rR = t133 * C1_12_IRyy;
        put_derivative(81, C1_21_rR);
        let M_22_ITzz = mu * mu;
        put_derivative(82, M_22_ITzz);
        let t271 = t69 * M_22_ITzz;
        let M_22_xB = t271 + t271;
        put_derivative(83, M_22_xB);
        let t273 = mu * self.xB;
        put_derivative(84, t273);
        let t274 = self.zB * t273;
        put_derivative(85, t274);
        let M_22_mB = t273 * t273;
        put_derivative(86, M_22_mB);
        let t276 = sin_lam * t273;
        put_derivative(87, t276);
        let K2_22_mB = C1_12_IBxz * t273;
        put_derivative(88, K2_22_mB);
        let t278 = self.c + self.xB;
        let C1_22_xB = (self.xB + t278) * K2_22_xB;
        put_derivative(89, C1_22_xB);
        let C1_22_mB = t278 * K2_22_mB;
        put_derivative(90, C1_22_mB);
        let t282 = self.mB * C1_12_IBxz;
        put_derivative(91, t282);
        let t283 = t278 * t282;
        put_derivative(92, t283);
        let t284 = self.c * t282;
        put_derivative(93, t284);
        let t285 = sin_lam * t284;
        put_derivative(94, t285);
        let t286 = self.zB * C1_12_IBxz;
        put_derivative(95, t286);
        let t287 = t278 * t286;
        put_derivative(96, t287);
        let t288 = self.mH * M_12_IHxz;
        put_derivative(97, t288);
        let t289 = self.zH * t288;
        put_derivative(98, t289);
        let M_22_xH = t178 * t288;
        put_derivative(99, M_22_xH);
        let t291 = sin_lam * t288;
        put_derivative(100, t291);
        let K0_12_zH = self.mH * sin_lam;
        put_derivative(101, K0_12_zH);
        let t293 = t178 * K0_12_zH;
        put_derivative(102, t293);
        let K0_22_zH = sin_lam * K0_12_zH;
        put_derivative(103, K0_22_zH);
        let t295 = C1_12_IBxz * K0_12_zH;
        put_derivative(104, t295);
        let t296 = t181 * t295;
        put_derivative(105, t296);
        let t297 = self.zH * C1_12_IBxz;
        put_derivative(106, t297);
        let t298 = t181 * t297;
        put_derivative(107, t298);
        let M_22_IHxx = sin_lam * sin_lam;
        put_derivative(108, M_22_IHxx);
        let t300 = self.mF * M_22_IHxx;
        put_derivative(109, t300);
        let M_22_IHzz = M_12_IHxz * M_12_IHxz;
        put_derivative(110, M_22_IHzz);
        let M_22_IFxx = M_22_IHxx + M_22_IHzz;
        put_derivative(111, M_22_IFxx);
        let t303 = M_12_IHxz * t70;
        put_derivative(112, t303);
        let C1_21_rF = SF * t303;
        put_derivative(113, C1_21_rF);
        let t305 = t56 * C1_12_IBxz;
        let t307 = self.mF - t70 * SF;
        let C1_12_rF = t305 * t307;
        put_derivative(114, C1_12_rF);
        let K2_12_rF = C1_12_IBxz * t307;
        put_derivative(115, K2_12_rF);
        let C1_12_IFyy = t70 * t305;
        put_derivative(116, C1_12_IFyy);
        let K2_12_IFyy = C1_12_IBxz * t70;
        put_derivative(117, K2_12_IFyy);
        let K2_22_IFyy = sin_lam * K2_12_IFyy;
        put_derivative(118, K2_22_IFyy);
        let t313 = self.mF * sin_lam;
        put_derivative(119, t313);
        let C1_22_rF = t305 * t313;
        put_derivative(120, C1_22_rF);
        let K2_22_rF = sin_lam * K2_12_rF;
        put_derivative(121, K2_22_rF);
        let K2_12_mF = self.rF * C1_12_IBxz;
        put_derivative(122, K2_12_mF);
        let C1_12_mF = t56 * K2_12_mF;
        put_derivative(123, C1_12_mF);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl Whipple<f64> {
    /// The parameter set `benchmark`.
    ///
    /// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1
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
    pub const BENCHMARK: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3141592653589793, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.0603,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.05892, IHyy: 0.06, IHzz: 0.00708, IHxz: -0.00756,
        rF: 0.35, mF: 3.0, IFxx: 0.1405, IFyy: 0.28,
    };

    /// The parameter set `benchmark_2005`.
    ///
    /// Source: Schwab, Meijaard & Papadopoulos (2005), ENOC 2005
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
    pub const BENCHMARK_2005: Self = Self {
        w: 1.02, c: 0.08, lam: 0.3217505543966422, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.06,
        IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4,
        xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.0546, IHyy: 0.06, IHzz: 0.0114, IHxz: -0.0162, rF: 0.35,
        mF: 3.0, IFxx: 0.14, IFyy: 0.28,
    };
}

impl Whipple<f64> {
    /// The parameter set `benchmark`.
    #[must_use]
    pub const fn default() -> Self {
        Self::BENCHMARK
    }
}

/// The parameter set `benchmark`.
impl<T: Scalar> Default for Whipple<T> {
    fn default() -> Self {
        Whipple::cast(&Whipple::<f64>::BENCHMARK)
    }
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> Whipple<T> {
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

impl<T: Scalar> Whipple<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> Whipple<U> {
        let values = self.to_array();
        Whipple::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl Whipple<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> Whipple<f32> {
        Whipple::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<Whipple<f32>> for Whipple<f64> {
    fn from(parameters: Whipple<f32>) -> Self {
        Whipple::cast(&parameters)
    }
}

impl<T: Number> WhippleMatrices<T> {
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

impl<T: Scalar> From<WhippleMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: WhippleMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for Whipple<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 26];

    type Over<U: Number> = Whipple<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "Whipple",
        docs: "The Whipple-Carvallo bicycle: the linearized equations of lean and steer about upright straight running.\n\nFour rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally\nsymmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,\nx forward, y to the right, z down, so that a centre of mass above the ground has z < 0.",
        source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, Appendix A",
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
        ],
        coordinates: &[
            CoordinateInfo::new("phi", "rad")
                .label("lean")
                .docs("Lean of the rear frame, positive to the right."),
            CoordinateInfo::new("delta", "rad")
                .label("steer")
                .docs("Steer of the front frame relative to the rear frame, positive to the right."),
        ],
        forces: &[],
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
                name: "benchmark",
                docs: "",
                source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1",
                values: &Whipple::to_array(&Whipple::<f64>::BENCHMARK),
            },
            SetInfo {
                name: "benchmark_2005",
                docs: "",
                source: "Schwab, Meijaard & Papadopoulos (2005), ENOC 2005",
                values: &Whipple::to_array(&Whipple::<f64>::BENCHMARK_2005),
            },
        ],
        requirements: &[
            RequirementInfo::new("mR + mB + mH + mF", "kg", Domain::POSITIVE),
            RequirementInfo::new("mH + mF", "kg", Domain::POSITIVE),
        ],
        formulas: &[
            FormulaInfo::definition("mT", "kg", "mR + mB + mH + mF"),
            FormulaInfo::definition("xT", "m", "(xB*mB + xH*mH + w*mF)/mT"),
            FormulaInfo::definition("zT", "m", "(-rR*mR + zB*mB + zH*mH - rF*mF)/mT"),
            FormulaInfo::definition(
                "ITxx",
                "kg*m^2",
                "IRxx + IBxx + IHxx + IFxx + mR*rR^2 + mB*zB^2 + mH*zH^2 + mF*rF^2",
            ),
            FormulaInfo::definition("ITxz", "kg*m^2", "IBxz + IHxz - mB*xB*zB - mH*xH*zH + mF*w*rF"),
            FormulaInfo::definition("ITzz", "kg*m^2", "IRxx + IBzz + IHzz + IFxx + mB*xB^2 + mH*xH^2 + mF*w^2"),
            FormulaInfo::definition("mA", "kg", "mH + mF"),
            FormulaInfo::definition("xA", "m", "(xH*mH + w*mF)/mA"),
            FormulaInfo::definition("zA", "m", "(zH*mH - rF*mF)/mA"),
            FormulaInfo::definition("IAxx", "kg*m^2", "IHxx + IFxx + mH*(zH - zA)^2 + mF*(rF + zA)^2"),
            FormulaInfo::definition("IAxz", "kg*m^2", "IHxz - mH*(xH - xA)*(zH - zA) + mF*(w - xA)*(rF + zA)"),
            FormulaInfo::definition("IAzz", "kg*m^2", "IHzz + IFxx + mH*(xH - xA)^2 + mF*(w - xA)^2"),
            FormulaInfo::definition("uA", "m", "(xA - w - c)*cos(lam) - zA*sin(lam)"),
            FormulaInfo::definition(
                "IAll",
                "kg*m^2",
                "mA*uA^2 + IAxx*sin(lam)^2 + 2*IAxz*sin(lam)*cos(lam) + IAzz*cos(lam)^2",
            ),
            FormulaInfo::definition("IAlx", "kg*m^2", "-mA*uA*zA + IAxx*sin(lam) + IAxz*cos(lam)"),
            FormulaInfo::definition("IAlz", "kg*m^2", "mA*uA*xA + IAxz*sin(lam) + IAzz*cos(lam)"),
            FormulaInfo::definition("mu", "1", "(c/w)*cos(lam)"),
            FormulaInfo::definition("SR", "kg*m", "IRyy/rR"),
            FormulaInfo::definition("SF", "kg*m", "IFyy/rF"),
            FormulaInfo::definition("ST", "kg*m", "SR + SF"),
            FormulaInfo::definition("SA", "kg*m", "mA*uA + mu*mT*xT"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 0)], "kg*m^2", "ITxx"),
            FormulaInfo::entry(&[(MatrixName::M, 0, 1), (MatrixName::M, 1, 0)], "kg*m^2", "IAlx + mu*ITxz"),
            FormulaInfo::entry(&[(MatrixName::M, 1, 1)], "kg*m^2", "IAll + 2*mu*IAlz + mu^2*ITzz"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 1)], "kg*m", "mu*ST + SF*cos(lam) + (ITxz/w)*cos(lam) - mu*mT*zT"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 0)], "kg*m", "-(mu*ST + SF*cos(lam))"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 1)], "kg*m", "(IAlz/w)*cos(lam) + mu*(SA + (ITzz/w)*cos(lam))"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 0)], "kg*m", "mT*zT"),
            FormulaInfo::entry(&[(MatrixName::K0, 0, 1), (MatrixName::K0, 1, 0)], "kg*m", "-SA"),
            FormulaInfo::entry(&[(MatrixName::K0, 1, 1)], "kg*m", "-SA*sin(lam)"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg", "((ST - mT*zT)/w)*cos(lam)"),
            FormulaInfo::entry(&[(MatrixName::K2, 1, 1)], "kg", "((SA + SF*sin(lam))/w)*cos(lam)"),
        ],
        attributes: &[],
        motion: None,
        gravity: Some(3),
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("Whipple", 26, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("Whipple", 26, values)?;
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
        let t4 = self.mH + self.mF;
        let t6 = self.mR + self.mB + t4;
        info.validate_requirements(&[Scalar::to_f64(t6), Scalar::to_f64(t4)])?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 2> {
        Coefficients::from_rows(WhippleMatrices::rows(&self.matrices()))
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 2>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl Whipple<f64> {
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
impl<T: Scalar> core::fmt::Display for Whipple<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for Whipple<T> {
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
        WhippleMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        WhippleMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> WhippleDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<WhippleMatrices<T>> {
        if parameter >= 26 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = WhippleMatrices {
            m: Rows([[zero; 2]; 2]), c1: Rows([[zero; 2]; 2]), k0: Rows([[zero; 2]; 2]),
            k2: Rows([[zero; 2]; 2]),
        };
        for position in 0..158 {
            let partial = <WhippleDerivatives>::PARTIALS[position];
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

impl<T: Scalar> Differentiable<2> for Whipple<T> {
    type Derivatives = [Coefficients<T, 2>; 26];

    type WithDerivativesOver<U: Number> = Whipple<U>;

    const PARTIALS: &'static [Partial] = <WhippleDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 2]; 2]; 8]); 26];
        for position in 0..158 {
            Partial::write(&<WhippleDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(WhippleMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 2> for Whipple<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl WhippleDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 158] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 23), Partial::new(MatrixName::M, 1, 0, 0, 23),
        Partial::new(MatrixName::M, 1, 1, 0, 62).negative(),
        Partial::new(MatrixName::C1, 0, 1, 0, 54), Partial::new(MatrixName::C1, 1, 0, 0, 46),
        Partial::new(MatrixName::C1, 1, 1, 0, 60).negative(),
        Partial::new(MatrixName::K0, 0, 1, 0, 50),
        Partial::new(MatrixName::K0, 1, 0, 0, 50),
        Partial::new(MatrixName::K0, 1, 1, 0, 59).negative(),
        Partial::new(MatrixName::K2, 0, 1, 0, 43).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 64).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 24), Partial::new(MatrixName::M, 1, 0, 1, 24),
        Partial::new(MatrixName::M, 1, 1, 1, 63), Partial::new(MatrixName::C1, 0, 1, 1, 42),
        Partial::new(MatrixName::C1, 1, 0, 1, 45).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 61).negative(),
        Partial::new(MatrixName::K0, 0, 1, 1, 51),
        Partial::new(MatrixName::K0, 1, 0, 1, 51),
        Partial::new(MatrixName::K0, 1, 1, 1, 52),
        Partial::new(MatrixName::K2, 1, 1, 1, 53).negative(),
        Partial::new(MatrixName::M, 0, 1, 2, 22),
        Partial::new(MatrixName::M, 1, 0, 2, 22),
        Partial::new(MatrixName::M, 1, 1, 2, 72),
        Partial::new(MatrixName::C1, 0, 1, 2, 55).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 47), Partial::new(MatrixName::C1, 1, 1, 2, 71),
        Partial::new(MatrixName::K0, 0, 1, 2, 49), Partial::new(MatrixName::K0, 1, 0, 2, 49),
        Partial::new(MatrixName::K0, 1, 1, 2, 56),
        Partial::new(MatrixName::K2, 0, 1, 2, 44).negative(),
        Partial::new(MatrixName::K2, 1, 1, 2, 73), Partial::new(MatrixName::M, 0, 0, 4, 11),
        Partial::new(MatrixName::C1, 0, 1, 4, 79), Partial::new(MatrixName::C1, 1, 0, 4, 81),
        Partial::new(MatrixName::K0, 0, 0, 4, 1).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 78), Partial::new(MatrixName::M, 0, 0, 5, 12),
        Partial::new(MatrixName::C1, 0, 1, 5, 27),
        Partial::new(MatrixName::K0, 0, 0, 5, 0).negative(),
        Partial::new(MatrixName::K2, 0, 1, 5, 19), Partial::new(MatrixName::M, 0, 0, 6, 8),
        Partial::new(MatrixName::M, 1, 1, 6, 82), Partial::new(MatrixName::C1, 1, 1, 6, 74),
        Partial::new(MatrixName::C1, 0, 1, 7, 80),
        Partial::new(MatrixName::C1, 1, 0, 7, 80).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 36),
        Partial::new(MatrixName::M, 0, 1, 8, 26).negative(),
        Partial::new(MatrixName::M, 1, 0, 8, 26).negative(),
        Partial::new(MatrixName::M, 1, 1, 8, 83),
        Partial::new(MatrixName::C1, 0, 1, 8, 20).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 89),
        Partial::new(MatrixName::K0, 0, 1, 8, 93).negative(),
        Partial::new(MatrixName::K0, 1, 0, 8, 93).negative(),
        Partial::new(MatrixName::K0, 1, 1, 8, 94).negative(),
        Partial::new(MatrixName::K2, 1, 1, 8, 77), Partial::new(MatrixName::M, 0, 0, 9, 13),
        Partial::new(MatrixName::M, 0, 1, 9, 28).negative(),
        Partial::new(MatrixName::M, 1, 0, 9, 28).negative(),
        Partial::new(MatrixName::C1, 0, 1, 9, 92).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 3),
        Partial::new(MatrixName::K2, 0, 1, 9, 91).negative(),
        Partial::new(MatrixName::M, 0, 0, 10, 14),
        Partial::new(MatrixName::M, 0, 1, 10, 85).negative(),
        Partial::new(MatrixName::M, 1, 0, 10, 85).negative(),
        Partial::new(MatrixName::M, 1, 1, 10, 86),
        Partial::new(MatrixName::C1, 0, 1, 10, 96).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 90),
        Partial::new(MatrixName::K0, 0, 0, 10, 2),
        Partial::new(MatrixName::K0, 0, 1, 10, 84).negative(),
        Partial::new(MatrixName::K0, 1, 0, 10, 84).negative(),
        Partial::new(MatrixName::K0, 1, 1, 10, 87).negative(),
        Partial::new(MatrixName::K2, 0, 1, 10, 95).negative(),
        Partial::new(MatrixName::K2, 1, 1, 10, 88), Partial::new(MatrixName::M, 0, 0, 11, 8),
        Partial::new(MatrixName::M, 1, 1, 13, 82), Partial::new(MatrixName::C1, 1, 1, 13, 74),
        Partial::new(MatrixName::M, 0, 1, 14, 25), Partial::new(MatrixName::M, 1, 0, 14, 25),
        Partial::new(MatrixName::C1, 0, 1, 14, 18),
        Partial::new(MatrixName::M, 0, 1, 15, 98).negative(),
        Partial::new(MatrixName::M, 1, 0, 15, 98).negative(),
        Partial::new(MatrixName::M, 1, 1, 15, 99),
        Partial::new(MatrixName::C1, 0, 1, 15, 58).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 67),
        Partial::new(MatrixName::K0, 0, 1, 15, 97).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 97).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 100).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 76), Partial::new(MatrixName::M, 0, 0, 16, 15),
        Partial::new(MatrixName::M, 0, 1, 16, 32), Partial::new(MatrixName::M, 1, 0, 16, 32),
        Partial::new(MatrixName::M, 1, 1, 16, 102).negative(),
        Partial::new(MatrixName::C1, 0, 1, 16, 65).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 105).negative(),
        Partial::new(MatrixName::K0, 0, 0, 16, 5), Partial::new(MatrixName::K0, 0, 1, 16, 101),
        Partial::new(MatrixName::K0, 1, 0, 16, 101), Partial::new(MatrixName::K0, 1, 1, 16, 103),
        Partial::new(MatrixName::K2, 0, 1, 16, 57).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 104).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 16),
        Partial::new(MatrixName::M, 0, 1, 17, 33).negative(),
        Partial::new(MatrixName::M, 1, 0, 17, 33).negative(),
        Partial::new(MatrixName::M, 1, 1, 17, 34),
        Partial::new(MatrixName::C1, 0, 1, 17, 107).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 68), Partial::new(MatrixName::K0, 0, 0, 17, 4),
        Partial::new(MatrixName::K0, 0, 1, 17, 30), Partial::new(MatrixName::K0, 1, 0, 17, 30),
        Partial::new(MatrixName::K0, 1, 1, 17, 35).negative(),
        Partial::new(MatrixName::K2, 0, 1, 17, 106).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 66), Partial::new(MatrixName::M, 0, 0, 18, 8),
        Partial::new(MatrixName::M, 0, 1, 18, 9), Partial::new(MatrixName::M, 1, 0, 18, 9),
        Partial::new(MatrixName::M, 1, 1, 18, 108), Partial::new(MatrixName::M, 1, 1, 20, 110),
        Partial::new(MatrixName::C1, 1, 1, 20, 75), Partial::new(MatrixName::M, 0, 1, 21, 29),
        Partial::new(MatrixName::M, 1, 0, 21, 29), Partial::new(MatrixName::M, 1, 1, 21, 70),
        Partial::new(MatrixName::C1, 0, 1, 21, 18), Partial::new(MatrixName::C1, 1, 1, 21, 21),
        Partial::new(MatrixName::M, 0, 0, 22, 17), Partial::new(MatrixName::M, 0, 1, 22, 48),
        Partial::new(MatrixName::M, 1, 0, 22, 48),
        Partial::new(MatrixName::M, 1, 1, 22, 69).negative(),
        Partial::new(MatrixName::C1, 0, 1, 22, 114),
        Partial::new(MatrixName::C1, 1, 0, 22, 113),
        Partial::new(MatrixName::C1, 1, 1, 22, 120),
        Partial::new(MatrixName::K0, 0, 0, 22, 7).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 119).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 119).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 109).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 115),
        Partial::new(MatrixName::K2, 1, 1, 22, 121),
        Partial::new(MatrixName::M, 0, 0, 23, 10),
        Partial::new(MatrixName::M, 0, 1, 23, 37).negative(),
        Partial::new(MatrixName::M, 1, 0, 23, 37).negative(),
        Partial::new(MatrixName::M, 1, 1, 23, 38),
        Partial::new(MatrixName::C1, 0, 1, 23, 123),
        Partial::new(MatrixName::C1, 1, 1, 23, 41).negative(),
        Partial::new(MatrixName::K0, 0, 0, 23, 6).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 31), Partial::new(MatrixName::K0, 1, 0, 23, 31),
        Partial::new(MatrixName::K0, 1, 1, 23, 39), Partial::new(MatrixName::K2, 0, 1, 23, 122),
        Partial::new(MatrixName::K2, 1, 1, 23, 40).negative(),
        Partial::new(MatrixName::M, 0, 0, 24, 8), Partial::new(MatrixName::M, 0, 1, 24, 9),
        Partial::new(MatrixName::M, 1, 0, 24, 9), Partial::new(MatrixName::M, 1, 1, 24, 111),
        Partial::new(MatrixName::C1, 1, 1, 24, 75), Partial::new(MatrixName::C1, 0, 1, 25, 116),
        Partial::new(MatrixName::C1, 1, 0, 25, 112).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 117),
        Partial::new(MatrixName::K2, 1, 1, 25, 118),
    ];
}
