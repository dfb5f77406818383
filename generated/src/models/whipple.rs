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
    /// 113 additions, 196 multiplications, 3 divisions, 3 negations and 2 trigonometric functions: 317 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WhippleMatrices<T>, WhippleDerivatives<T>) {
        let t5 = self.rF * self.mF;
        let M_11_mH = self.zH * self.zH;
        let t13 = self.IFxx + self.IHxx + self.rF * t5 + self.mH * M_11_mH;
        let M_11_mB = self.zB * self.zB;
        let t21 = self.rR * self.mR;
        let M_11 = self.IRxx + t13 + self.mB * M_11_mB + self.IBxx + self.rR * t21;
        let t31 = self.mH * self.xH;
        let t33 = self.IHxz - self.zH * t31;
        let t34 = t5 * self.w + t33;
        let t36 = self.mB * self.zB;
        let t40 = t34 + self.IBxz - t36 * self.xB;
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t44 = self.w.like(1.0) / self.w;
        let C1_12_IBxz = cos_lam * t44;
        let mu = self.c * C1_12_IBxz;
        let t48 = self.mH * self.zH;
        let t49 = t48 - t5;
        let t53 = t33 + self.c * t49 + self.w * t48;
        let t57 = cos_lam * t53 + t13 * sin_lam;
        let M_12 = t40 * mu + t57;
        let t63 = self.IFxx + self.IHzz;
        let t64 = self.w + self.c;
        let t65 = self.xH - t64;
        let t66 = self.mH * t65;
        let t71 = t53 * sin_lam;
        let t72 = cos_lam * (self.mF * self.c * self.c + t63 + t65 * t66) + t71;
        let t76 = self.mF * self.w;
        let t80 = cos_lam * (t63 + t31 * t65 - self.c * t76);
        let t81 = t34 * sin_lam + t80;
        let t82 = self.c * cos_lam;
        let t86 = self.mB * self.xB;
        let t93 = t44
            * (self.IRxx + t63 + self.IBzz + self.w * t76 + self.xH * t31
                + self.xB * t86);
        let t94 = t82 * t93;
        let t95 = t81 + t94;
        let M_22 = sin_lam * t57 + cos_lam * t72 + mu * (t81 + t95);
        let zero = self.w.like(0.0);
        let t102 = self.w.like(1.0) / self.rF;
        let SF = self.IFyy * t102;
        let t105 = self.w.like(1.0) / self.rR;
        let t106 = self.IRyy * t105;
        let ST = SF + t106;
        let t108 = t36 + t49;
        let t110 = ST + (t21 - t108);
        let t114 = t40 + self.c * t110 + self.w * SF;
        let C1_12 = C1_12_IBxz * t114;
        let t116 = cos_lam * SF;
        let t117 = C1_12_IBxz * ST;
        let t118 = self.c * t117;
        let t120 = t49 * sin_lam;
        let t124 = self.mF - t44 * (t31 + t76 + t86);
        let t125 = self.c * t124;
        let t126 = t125 - t66;
        let K0_12 = t120 + cos_lam * t126;
        let t130 = t95 - self.c * K0_12;
        let C1_22 = C1_12_IBxz * t130;
        let K0_22 = sin_lam * K0_12;
        let K2_12 = C1_12_IBxz * t110;
        let t134 = sin_lam * SF;
        let t135 = K0_12 - t134;
        let t136 = C1_12_IBxz * t135;
        let t138 = t5 * cos_lam;
        let t139 = t40 * C1_12_IBxz - t138;
        let t142 = cos_lam * t48;
        let M_12_w = t142 - self.c * t44 * t139;
        let t144 = self.rF * sin_lam;
        let K0_12_mF = t82 - t144 - self.w * mu;
        let t148 = self.mF * K0_12_mF;
        let t149 = t44 * t95;
        let t150 = t148 + t149;
        let t151 = t150 + t150;
        let M_12_IHxz = cos_lam + mu;
        let t154 = self.xH * M_12_IHxz;
        let t155 = cos_lam * t64;
        let t156 = self.zH * sin_lam;
        let t157 = t155 + t156;
        let t158 = t154 - t157;
        let t159 = t158 + t158;
        let t160 = self.mH * t159;
        let t161 = cos_lam * t160;
        let t162 = mu * t151 + t161;
        let t163 = t116 + t138;
        let t165 = t44 * (C1_12 - t163);
        let C1_21_w = t44 * t118;
        let t168 = t44 * (t94 + t130);
        let t169 = self.mH * cos_lam;
        let t170 = self.xH + self.c;
        let t172 = t76 + t125;
        let C1_22_w = C1_12_IBxz * (mu * t172 - t148 - t168 - t169 * t170);
        let K0_12_w = t169 - C1_12_IBxz * t125;
        let t181 = t44 * K2_12;
        let K2_22_w = t44 * (t136 - cos_lam * K0_12_w);
        let M_12_c = t139 + t142;
        let t187 = cos_lam * (t160 - t151);
        let t188 = cos_lam * C1_12_IBxz;
        let t189 = self.mH * t170;
        let C1_22_c = t188 * (t93 - t126 - t172 - t189) - C1_12_IBxz * t120;
        let K0_12_c = t169 + cos_lam * t124;
        let K0_22_c = sin_lam * K0_12_c;
        let t199 = C1_12_IBxz * K0_12_c;
        let t200 = t44 * sin_lam;
        let t201 = self.c * t200;
        let t205 = t71 + t40 * t201 - t13 * cos_lam;
        let t210 = t34 * t188 - t80 * t200;
        let t215 = cos_lam * t57 - self.c * (sin_lam * t149 - t210) - sin_lam * t72;
        let M_22_lam = t215 + t215;
        let t217 = t114 * t200;
        let C1_21_lam = t134 + ST * t201;
        let t222 = t142 - sin_lam * t126;
        let t223 = t138 - t222;
        let C1_22_lam = t210 + mu * t223 - sin_lam * t168;
        let K0_22_lam = cos_lam * K0_12 - sin_lam * t223;
        let t230 = t110 * t200;
        let K2_22_lam = C1_12_IBxz * (t163 - t222) + t135 * t200;
        let M_11_rR = t21 + t21;
        let K2_12_rR = C1_12_IBxz * (self.mR - t105 * t106);
        let C1_12_rR = self.c * K2_12_rR;
        let C1_12_IRyy = mu * t105;
        let C1_21_rR = t106 * C1_12_IRyy;
        let M_11_mR = self.rR * self.rR;
        let C1_12_mR = self.rR * mu;
        let K2_12_mR = self.rR * C1_12_IBxz;
        let C1_22_ITzz = C1_12_IBxz * mu;
        let M_22_ITzz = self.c * C1_22_ITzz;
        let K2_12_IRyy = C1_12_IBxz * t105;
        let t249 = self.mB * C1_12_IBxz;
        let t250 = self.c * t249;
        let t251 = self.zB * t250;
        let t252 = self.xB * mu;
        let t253 = t250 * t252;
        let M_22_xB = t253 + t253;
        let t255 = self.zB * t249;
        let t256 = self.mB * t252;
        let t257 = self.xB + self.c;
        let C1_22_xB = C1_12_IBxz * (t256 + t250 * t257);
        let t261 = sin_lam * t250;
        let K2_22_xB = self.mB * C1_22_ITzz;
        let M_11_zB = t36 + t36;
        let t264 = t249 * t257;
        let t265 = self.zB * t252;
        let M_22_mB = t252 * t252;
        let t267 = self.zB * C1_12_IBxz;
        let t268 = t257 * t267;
        let K2_22_mB = self.xB * C1_22_ITzz;
        let C1_22_mB = t257 * K2_22_mB;
        let t271 = sin_lam * t252;
        let t272 = t48 * M_12_IHxz;
        let t273 = self.mH * C1_12_IBxz;
        let t274 = self.c * t273;
        let M_22_xH = t161 + t158 * (t274 + t274);
        let t278 = self.zH * C1_12_IBxz;
        let t279 = self.mH * t278;
        let C1_22_IHzz = C1_12_IBxz * M_12_IHxz;
        let C1_22_xH = t158 * t273 + t189 * C1_22_IHzz;
        let t284 = t169 + t274;
        let t285 = sin_lam * t284;
        let K2_22_xH = self.mH * C1_22_IHzz;
        let M_11_zH = t48 + t48;
        let M_12_zH = self.mH * (t156 - t158);
        let K0_12_zH = self.mH * sin_lam;
        let t291 = t159 * K0_12_zH;
        let t292 = t170 * t273;
        let t293 = t169 * t200;
        let t294 = t170 * t293;
        let K0_22_zH = sin_lam * K0_12_zH;
        let t296 = self.zH * t158;
        let M_22_mH = t158 * t158;
        let t298 = t170 * t278;
        let K2_22_mH = C1_12_IBxz * t158;
        let C1_22_mH = t170 * K2_22_mH;
        let t301 = sin_lam * t158;
        let M_22_IHxx = sin_lam * sin_lam;
        let M_22_IHzz = M_22_ITzz + cos_lam * (mu + M_12_IHxz);
        let t306 = sin_lam + sin_lam;
        let M_22_IHxz = M_12_IHxz * t306;
        let K2_22_SF = C1_12_IBxz * sin_lam;
        let M_11_rF = t5 + t5;
        let M_12_rF = self.mF * (t144 - K0_12_mF);
        let t312 = t148 * t306;
        let ITzz_w = self.mF - t102 * SF;
        let C1_12_SF = t44 * t155;
        let C1_12_rF = ITzz_w * C1_12_SF;
        let t317 = t102 * M_12_IHxz;
        let C1_21_rF = SF * t317;
        let t319 = self.mF * sin_lam;
        let C1_22_rF = C1_12_SF * t319;
        let t321 = sin_lam * t319;
        let K2_12_rF = C1_12_IBxz * ITzz_w;
        let K2_22_rF = sin_lam * K2_12_rF;
        let M_11_mF = self.rF * self.rF;
        let t325 = self.rF * K0_12_mF;
        let M_22_mF = K0_12_mF * K0_12_mF;
        let C1_12_mF = self.rF * C1_12_SF;
        let t328 = K0_12_mF * C1_12_SF;
        let K0_22_mF = sin_lam * K0_12_mF;
        let K2_12_mF = self.rF * C1_12_IBxz;
        let t331 = C1_12_IBxz * K0_12_mF;
        let M_22_IFxx = M_22_IHxx + M_22_IHzz;
        let C1_12_IFyy = t102 * C1_12_SF;
        let K2_12_IFyy = C1_12_IBxz * t102;
        let K2_22_IFyy = t102 * K2_22_SF;
        let C1_21 = -(t116 + t118);
        let K0_11 = t108 - t21;
        let K2_22 = -t136;
        let t339 = -(sin_lam * K0_12_w);
        let K0_12_lam = t222 - t138;
        let K0_12_mH = t157 - t154;
        (
            WhippleMatrices::from_entries([
                M_11, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, K0_11, K0_12, K0_12, K0_22, zero,
                K2_12, zero, K2_22,
            ]),
            WhippleDerivatives {
                values: [
                    M_12_w, t162, t165, C1_21_w, C1_22_w, K0_12_w, t339, t181, K2_22_w, M_12_c,
                    t187, K2_12, t117, C1_22_c, K0_12_c, K0_22_c, t199, t205, M_22_lam, t217,
                    C1_21_lam, C1_22_lam, K0_12_lam, K0_22_lam, t230, K2_22_lam, M_11_rR, C1_12_rR,
                    C1_21_rR, self.mR, K2_12_rR, M_11_mR, C1_12_mR, self.rR, K2_12_mR,
                    self.w.like(1.0), M_22_ITzz, C1_22_ITzz, C1_12_IRyy, K2_12_IRyy, t251, M_22_xB,
                    t255, C1_22_xB, t250, t261, K2_22_xB, M_11_zB, t256, t264, self.mB, t249,
                    M_11_mB, t265, M_22_mB, t268, C1_22_mB, self.zB, t252, t271, t267, K2_22_mB, mu,
                    C1_12_IBxz, t272, M_22_xH, t279, C1_22_xH, t284, t285, K2_22_xH, M_11_zH,
                    M_12_zH, t291, t292, t294, self.mH, K0_12_zH, K0_22_zH, t273, t293, M_11_mH,
                    t296, M_22_mH, t298, C1_22_mH, self.zH, K0_12_mH, t301, t278, K2_22_mH, sin_lam,
                    M_22_IHxx, M_22_IHzz, C1_22_IHzz, M_12_IHxz, M_22_IHxz, K2_22_SF, M_11_rF,
                    M_12_rF, t312, C1_12_rF, C1_21_rF, C1_22_rF, self.mF, t319, t321, K2_12_rF,
                    K2_22_rF, M_11_mF, t325, M_22_mF, C1_12_mF, t328, self.rF, K0_12_mF, K0_22_mF,
                    K2_12_mF, t331, M_22_IFxx, C1_12_IFyy, t317, K2_12_IFyy, K2_22_IFyy,
                ],
            },
        )
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
    type Derivatives = [T; 124];

    #[inline(always)]
    fn entries_and_derivatives(&self) -> ([T; 11], [T; 124]) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        (WhippleMatrices::distinct_entries(&matrices), derivatives.values)
    }
}

impl WhippleDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 158] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 0), Partial::new(MatrixName::M, 1, 0, 0, 0),
        Partial::new(MatrixName::M, 1, 1, 0, 1).negative(),
        Partial::new(MatrixName::C1, 0, 1, 0, 2).negative(),
        Partial::new(MatrixName::C1, 1, 0, 0, 3), Partial::new(MatrixName::C1, 1, 1, 0, 4),
        Partial::new(MatrixName::K0, 0, 1, 0, 5), Partial::new(MatrixName::K0, 1, 0, 0, 5),
        Partial::new(MatrixName::K0, 1, 1, 0, 6).negative(),
        Partial::new(MatrixName::K2, 0, 1, 0, 7).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 8), Partial::new(MatrixName::M, 0, 1, 1, 9),
        Partial::new(MatrixName::M, 1, 0, 1, 9),
        Partial::new(MatrixName::M, 1, 1, 1, 10).negative(),
        Partial::new(MatrixName::C1, 0, 1, 1, 11),
        Partial::new(MatrixName::C1, 1, 0, 1, 12).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 13), Partial::new(MatrixName::K0, 0, 1, 1, 14),
        Partial::new(MatrixName::K0, 1, 0, 1, 14), Partial::new(MatrixName::K0, 1, 1, 1, 15),
        Partial::new(MatrixName::K2, 1, 1, 1, 16).negative(),
        Partial::new(MatrixName::M, 0, 1, 2, 17).negative(),
        Partial::new(MatrixName::M, 1, 0, 2, 17).negative(),
        Partial::new(MatrixName::M, 1, 1, 2, 18),
        Partial::new(MatrixName::C1, 0, 1, 2, 19).negative(),
        Partial::new(MatrixName::C1, 1, 0, 2, 20), Partial::new(MatrixName::C1, 1, 1, 2, 21),
        Partial::new(MatrixName::K0, 0, 1, 2, 22), Partial::new(MatrixName::K0, 1, 0, 2, 22),
        Partial::new(MatrixName::K0, 1, 1, 2, 23),
        Partial::new(MatrixName::K2, 0, 1, 2, 24).negative(),
        Partial::new(MatrixName::K2, 1, 1, 2, 25), Partial::new(MatrixName::M, 0, 0, 4, 26),
        Partial::new(MatrixName::C1, 0, 1, 4, 27), Partial::new(MatrixName::C1, 1, 0, 4, 28),
        Partial::new(MatrixName::K0, 0, 0, 4, 29).negative(),
        Partial::new(MatrixName::K2, 0, 1, 4, 30),
        Partial::new(MatrixName::M, 0, 0, 5, 31),
        Partial::new(MatrixName::C1, 0, 1, 5, 32),
        Partial::new(MatrixName::K0, 0, 0, 5, 33).negative(),
        Partial::new(MatrixName::K2, 0, 1, 5, 34), Partial::new(MatrixName::M, 0, 0, 6, 35),
        Partial::new(MatrixName::M, 1, 1, 6, 36), Partial::new(MatrixName::C1, 1, 1, 6, 37),
        Partial::new(MatrixName::C1, 0, 1, 7, 38),
        Partial::new(MatrixName::C1, 1, 0, 7, 38).negative(),
        Partial::new(MatrixName::K2, 0, 1, 7, 39),
        Partial::new(MatrixName::M, 0, 1, 8, 40).negative(),
        Partial::new(MatrixName::M, 1, 0, 8, 40).negative(),
        Partial::new(MatrixName::M, 1, 1, 8, 41),
        Partial::new(MatrixName::C1, 0, 1, 8, 42).negative(),
        Partial::new(MatrixName::C1, 1, 1, 8, 43),
        Partial::new(MatrixName::K0, 0, 1, 8, 44).negative(),
        Partial::new(MatrixName::K0, 1, 0, 8, 44).negative(),
        Partial::new(MatrixName::K0, 1, 1, 8, 45).negative(),
        Partial::new(MatrixName::K2, 1, 1, 8, 46), Partial::new(MatrixName::M, 0, 0, 9, 47),
        Partial::new(MatrixName::M, 0, 1, 9, 48).negative(),
        Partial::new(MatrixName::M, 1, 0, 9, 48).negative(),
        Partial::new(MatrixName::C1, 0, 1, 9, 49).negative(),
        Partial::new(MatrixName::K0, 0, 0, 9, 50),
        Partial::new(MatrixName::K2, 0, 1, 9, 51).negative(),
        Partial::new(MatrixName::M, 0, 0, 10, 52),
        Partial::new(MatrixName::M, 0, 1, 10, 53).negative(),
        Partial::new(MatrixName::M, 1, 0, 10, 53).negative(),
        Partial::new(MatrixName::M, 1, 1, 10, 54),
        Partial::new(MatrixName::C1, 0, 1, 10, 55).negative(),
        Partial::new(MatrixName::C1, 1, 1, 10, 56),
        Partial::new(MatrixName::K0, 0, 0, 10, 57),
        Partial::new(MatrixName::K0, 0, 1, 10, 58).negative(),
        Partial::new(MatrixName::K0, 1, 0, 10, 58).negative(),
        Partial::new(MatrixName::K0, 1, 1, 10, 59).negative(),
        Partial::new(MatrixName::K2, 0, 1, 10, 60).negative(),
        Partial::new(MatrixName::K2, 1, 1, 10, 61), Partial::new(MatrixName::M, 0, 0, 11, 35),
        Partial::new(MatrixName::M, 1, 1, 13, 36), Partial::new(MatrixName::C1, 1, 1, 13, 37),
        Partial::new(MatrixName::M, 0, 1, 14, 62), Partial::new(MatrixName::M, 1, 0, 14, 62),
        Partial::new(MatrixName::C1, 0, 1, 14, 63),
        Partial::new(MatrixName::M, 0, 1, 15, 64).negative(),
        Partial::new(MatrixName::M, 1, 0, 15, 64).negative(),
        Partial::new(MatrixName::M, 1, 1, 15, 65),
        Partial::new(MatrixName::C1, 0, 1, 15, 66).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 67),
        Partial::new(MatrixName::K0, 0, 1, 15, 68).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 68).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 69).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 70), Partial::new(MatrixName::M, 0, 0, 16, 71),
        Partial::new(MatrixName::M, 0, 1, 16, 72), Partial::new(MatrixName::M, 1, 0, 16, 72),
        Partial::new(MatrixName::M, 1, 1, 16, 73).negative(),
        Partial::new(MatrixName::C1, 0, 1, 16, 74).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 75).negative(),
        Partial::new(MatrixName::K0, 0, 0, 16, 76), Partial::new(MatrixName::K0, 0, 1, 16, 77),
        Partial::new(MatrixName::K0, 1, 0, 16, 77), Partial::new(MatrixName::K0, 1, 1, 16, 78),
        Partial::new(MatrixName::K2, 0, 1, 16, 79).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 80).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 81),
        Partial::new(MatrixName::M, 0, 1, 17, 82).negative(),
        Partial::new(MatrixName::M, 1, 0, 17, 82).negative(),
        Partial::new(MatrixName::M, 1, 1, 17, 83),
        Partial::new(MatrixName::C1, 0, 1, 17, 84).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 85), Partial::new(MatrixName::K0, 0, 0, 17, 86),
        Partial::new(MatrixName::K0, 0, 1, 17, 87), Partial::new(MatrixName::K0, 1, 0, 17, 87),
        Partial::new(MatrixName::K0, 1, 1, 17, 88).negative(),
        Partial::new(MatrixName::K2, 0, 1, 17, 89).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 90), Partial::new(MatrixName::M, 0, 0, 18, 35),
        Partial::new(MatrixName::M, 0, 1, 18, 91), Partial::new(MatrixName::M, 1, 0, 18, 91),
        Partial::new(MatrixName::M, 1, 1, 18, 92), Partial::new(MatrixName::M, 1, 1, 20, 93),
        Partial::new(MatrixName::C1, 1, 1, 20, 94), Partial::new(MatrixName::M, 0, 1, 21, 95),
        Partial::new(MatrixName::M, 1, 0, 21, 95), Partial::new(MatrixName::M, 1, 1, 21, 96),
        Partial::new(MatrixName::C1, 0, 1, 21, 63), Partial::new(MatrixName::C1, 1, 1, 21, 97),
        Partial::new(MatrixName::M, 0, 0, 22, 98), Partial::new(MatrixName::M, 0, 1, 22, 99),
        Partial::new(MatrixName::M, 1, 0, 22, 99),
        Partial::new(MatrixName::M, 1, 1, 22, 100).negative(),
        Partial::new(MatrixName::C1, 0, 1, 22, 101),
        Partial::new(MatrixName::C1, 1, 0, 22, 102),
        Partial::new(MatrixName::C1, 1, 1, 22, 103),
        Partial::new(MatrixName::K0, 0, 0, 22, 104).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 105).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 105).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 106).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 107),
        Partial::new(MatrixName::K2, 1, 1, 22, 108),
        Partial::new(MatrixName::M, 0, 0, 23, 109),
        Partial::new(MatrixName::M, 0, 1, 23, 110).negative(),
        Partial::new(MatrixName::M, 1, 0, 23, 110).negative(),
        Partial::new(MatrixName::M, 1, 1, 23, 111),
        Partial::new(MatrixName::C1, 0, 1, 23, 112),
        Partial::new(MatrixName::C1, 1, 1, 23, 113).negative(),
        Partial::new(MatrixName::K0, 0, 0, 23, 114).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 115), Partial::new(MatrixName::K0, 1, 0, 23, 115),
        Partial::new(MatrixName::K0, 1, 1, 23, 116), Partial::new(MatrixName::K2, 0, 1, 23, 117),
        Partial::new(MatrixName::K2, 1, 1, 23, 118).negative(),
        Partial::new(MatrixName::M, 0, 0, 24, 35), Partial::new(MatrixName::M, 0, 1, 24, 91),
        Partial::new(MatrixName::M, 1, 0, 24, 91), Partial::new(MatrixName::M, 1, 1, 24, 119),
        Partial::new(MatrixName::C1, 1, 1, 24, 94), Partial::new(MatrixName::C1, 0, 1, 25, 120),
        Partial::new(MatrixName::C1, 1, 0, 25, 121).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 122),
        Partial::new(MatrixName::K2, 1, 1, 25, 123),
    ];
}
