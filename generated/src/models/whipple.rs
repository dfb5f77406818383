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
    /// 110 additions, 195 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 312 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WhippleMatrices<T>, WhippleDerivatives<T>) {
        let M_11_mB = self.zB * self.zB;
        let t8 = self.rF * self.mF;
        let t12 = self.zH * self.mH;
        let t18 = self.rF * t8 + self.zH * t12 + self.IHxx + self.IFxx;
        let t21 = self.rR * self.mR;
        let M_11 = self.IRxx + self.IBxx + self.mB * M_11_mB + t18 + self.rR * t21;
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t32 = self.c + self.w;
        let t33 = self.xH - t32;
        let t34 = self.mH * t33;
        let t39 = self.IHxz - self.zH * t34 - t8 * self.c;
        let t43 = cos_lam * t39 + t18 * sin_lam;
        let t44 = self.mH * self.xH;
        let t46 = self.mF * self.w;
        let t49 = self.IHxz + self.rF * t46 - self.zH * t44;
        let t52 = self.mB * self.xB;
        let t55 = t49 + self.IBxz - self.zB * t52;
        let t56 = self.w.like(1.0) / self.w;
        let C1_12_IBxz = cos_lam * t56;
        let mu = self.c * C1_12_IBxz;
        let M_12 = t43 + t55 * mu;
        let t62 = sin_lam * t56;
        let t65 = self.IFxx + self.IHzz;
        let t69 = t65 + self.xH * t34 - self.c * t46;
        let t71 = t49 * t62 + C1_12_IBxz * t69;
        let t73 = t39 * sin_lam;
        let t86 = C1_12_IBxz
            * (self.IRxx + t65 + self.xH * t44 + self.xB * t52 + self.w * t46
                + self.IBzz);
        let t87 = self.c * t56;
        let t88 = t86 * t87;
        let t89 = t71 + t88;
        let t90 = self.mF * self.c;
        let t91 = cos_lam * t90;
        let t95 = t73 + cos_lam * (t65 + t33 * t34) + self.c * (t89 + t91);
        let M_22 = sin_lam * t43 + cos_lam * (self.c * t71 + t95);
        let zero = self.w.like(0.0);
        let t101 = self.w.like(1.0) / self.rF;
        let SF = self.IFyy * t101;
        let t104 = self.w.like(1.0) / self.rR;
        let t105 = self.IRyy * t104;
        let ST = SF + t105;
        let t107 = self.mB * self.zB;
        let t108 = t8 - t107;
        let t109 = t12 - t21;
        let t111 = ST + (t108 - t109);
        let t115 = t55 + self.c * t111 + self.w * SF;
        let C1_12 = C1_12_IBxz * t115;
        let t117 = t87 * ST;
        let t118 = SF + t117;
        let t120 = t44 + t46;
        let ITzz_mB = t56 * (t52 + t120);
        let t123 = self.mF - ITzz_mB;
        let t125 = self.c * t123 - t34;
        let t127 = self.mF * sin_lam;
        let t128 = self.rF * t127;
        let K0_12 = cos_lam * t125 + t12 * sin_lam - t128;
        let t133 = t89 - t87 * K0_12;
        let C1_22 = cos_lam * t133;
        let K0_22 = sin_lam * K0_12;
        let K2_12 = C1_12_IBxz * t111;
        let t138 = sin_lam * SF - K0_12;
        let K2_22 = C1_12_IBxz * t138;
        let t140 = t12 * cos_lam;
        let t141 = t55 * t56;
        let M_12_w = t140 + mu * (t8 - t141);
        let t145 = self.mH * cos_lam;
        let M_12_IHxz = cos_lam + mu;
        let t149 = cos_lam * t32 - self.xH * M_12_IHxz;
        let t150 = self.zH * sin_lam;
        let K0_12_mH = t149 + t150;
        let t152 = t150 + K0_12_mH;
        let t153 = t149 + t152;
        let t154 = t145 * t153;
        let t155 = self.w * C1_12_IBxz;
        let t156 = t90 * t155;
        let t158 = t128 + t156 - t91;
        let t159 = t89 - t158;
        let t160 = mu + mu;
        let M_22_w = t154 - t159 * t160;
        let t163 = cos_lam * SF;
        let t164 = t8 * cos_lam;
        let t167 = t56 * (C1_12 - t163 - t164);
        let C1_21_w = C1_12_IBxz * t117;
        let t169 = cos_lam * C1_12_IBxz;
        let t170 = t44 * t169;
        let t171 = t88 + t133;
        let K0_12_w = t145 - mu * t123;
        let C1_22_w = C1_12_IBxz * (t156 + t158 - t171 - self.c * K0_12_w) - t170;
        let K0_22_w = sin_lam * K0_12_w;
        let t181 = t56 * K2_12;
        let t182 = t56 * t138;
        let t184 = C1_12_IBxz * (K0_12_w + t182);
        let t186 = t140 - t164;
        let M_12_c = cos_lam * t141 + t186;
        let t188 = cos_lam * t159;
        let M_22_c = t154 + t188 + t188;
        let t191 = C1_12_IBxz * ST;
        let K0_12_c = t145 + cos_lam * t123;
        let t199 = C1_12_IBxz * (K0_12 + cos_lam * t120 + self.c * K0_12_c - t86);
        let K0_22_c = sin_lam * K0_12_c;
        let t201 = C1_12_IBxz * K0_12_c;
        let M_12_lam = t18 * cos_lam - t73 - self.c * t55 * t62;
        let K2_22_SF = sin_lam * C1_12_IBxz;
        let ITzz_xB = t69 * K2_22_SF;
        let t211 = ITzz_xB - t49 * t169;
        let t215 = cos_lam * t43 - self.c * t211 - sin_lam * t95;
        let M_22_lam = t215 + t215;
        let t217 = t62 * t115;
        let C1_21_lam = sin_lam * t118;
        let K0_12_lam = t186 - sin_lam * t125;
        let K0_22_lam = sin_lam * K0_12_lam + cos_lam * K0_12;
        let t228 = t62 * t111;
        let K2_22_lam = C1_12_IBxz * (t163 - K0_12_lam) - sin_lam * t182;
        let M_11_rR = t21 + t21;
        let t234 = t104 * t105;
        let t235 = self.mR - t234;
        let C1_12_rR = mu * t235;
        let C1_21_rR = mu * t234;
        let K2_12_rR = C1_12_IBxz * t235;
        let M_11_mR = self.rR * self.rR;
        let C1_12_mR = self.rR * mu;
        let K2_12_mR = self.rR * C1_12_IBxz;
        let M_22_ITzz = mu * mu;
        let C1_22_ITzz = C1_12_IBxz * mu;
        let K2_12_IRyy = C1_12_IBxz * t104;
        let C1_12_IRyy = self.c * K2_12_IRyy;
        let t247 = mu * t107;
        let t248 = self.xB * mu;
        let t249 = self.mB * t248;
        let M_22_xB = t160 * t249;
        let t251 = self.mB * C1_12_IBxz;
        let t252 = self.zB * t251;
        let t253 = self.c * t251;
        let t254 = self.xB * C1_12_IBxz;
        let t255 = mu + t254;
        let C1_22_xB = t253 * (t254 + t255);
        let t258 = sin_lam * t253;
        let K2_22_xB = self.mB * C1_22_ITzz;
        let M_11_zB = t107 + t107;
        let t261 = self.mB * t255;
        let t262 = self.zB * t248;
        let M_22_mB = t248 * t248;
        let t264 = self.zB * t255;
        let C1_22_mB = t248 * t255;
        let t266 = sin_lam * t248;
        let t267 = self.zB * C1_12_IBxz;
        let K2_22_mB = mu * t254;
        let t269 = self.mH * M_12_IHxz;
        let t270 = self.zH * t269;
        let t271 = t153 * t269;
        let t272 = t12 * C1_12_IBxz;
        let t274 = C1_12_IBxz * (self.xH + self.c);
        let t277 = C1_12_IBxz * K0_12_mH;
        let C1_22_xH = t170 + self.mH * (mu * (cos_lam + t274) - t277);
        let K0_12_zH = self.mH * sin_lam;
        let t282 = M_12_IHxz * K0_12_zH;
        let C1_22_IHzz = t169 + C1_22_ITzz;
        let K2_22_xH = self.mH * C1_22_IHzz;
        let M_11_zH = t12 + t12;
        let M_12_zH = self.mH * t152;
        let M_22_zH = t153 * K0_12_zH;
        let t288 = self.mH * t274;
        let t289 = sin_lam * t288;
        let K0_22_zH = sin_lam * K0_12_zH;
        let t291 = self.mH * C1_12_IBxz;
        let t292 = sin_lam * t291;
        let M_11_mH = self.zH * self.zH;
        let M_12_mH = self.zH * K0_12_mH;
        let M_22_mH = K0_12_mH * K0_12_mH;
        let t296 = self.zH * t274;
        let t297 = K0_12_mH * t274;
        let K0_22_mH = sin_lam * K0_12_mH;
        let t299 = self.zH * C1_12_IBxz;
        let M_22_IHxx = sin_lam * sin_lam;
        let M_22_IHzz = M_12_IHxz * M_12_IHxz;
        let t302 = sin_lam + sin_lam;
        let M_22_IHxz = M_12_IHxz * t302;
        let M_11_rF = t8 + t8;
        let M_12_rF = t128 + t158;
        let M_22_rF = t158 * t302;
        let C1_12_SF = t32 * C1_12_IBxz;
        let t309 = self.mF - t101 * SF;
        let C1_12_rF = C1_12_SF * t309;
        let t311 = t101 * M_12_IHxz;
        let C1_21_rF = SF * t311;
        let C1_22_rF = t127 * C1_12_SF;
        let t314 = sin_lam * t127;
        let K2_12_rF = C1_12_IBxz * t309;
        let K2_22_rF = K2_22_SF * t309;
        let M_11_mF = self.rF * self.rF;
        let t318 = self.rF * sin_lam;
        let t320 = self.c * (cos_lam - t155);
        let t321 = t318 - t320;
        let M_12_mF = self.rF * t321;
        let M_22_mF = t321 * t321;
        let C1_12_mF = self.rF * C1_12_SF;
        let K2_22_mF = C1_12_IBxz * t321;
        let C1_22_mF = t32 * K2_22_mF;
        let t327 = sin_lam * t321;
        let K2_12_mF = self.rF * C1_12_IBxz;
        let M_22_IFxx = M_22_IHxx + M_22_IHzz;
        let C1_12_IFyy = t101 * C1_12_SF;
        let K2_12_IFyy = C1_12_IBxz * t101;
        let K2_22_IFyy = sin_lam * K2_12_IFyy;
        let C1_21 = -(cos_lam * t118);
        let K0_11 = t109 - t108;
        let C1_22_lam = -(t211 + sin_lam * t171 + mu * K0_12_lam);
        let K0_12_mF = t320 - t318;
        (
            WhippleMatrices::from_entries([
                M_11, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, K0_11, K0_12, K0_12, K0_22, zero,
                K2_12, zero, K2_22,
            ]),
            WhippleDerivatives {
                values: [
                    M_12_w, M_22_w, t167, C1_21_w, C1_22_w, K0_12_w, K0_22_w, t181, t184, M_12_c,
                    M_22_c, K2_12, t191, t199, K0_12_c, K0_22_c, t201, M_12_lam, M_22_lam, t217,
                    C1_21_lam, C1_22_lam, K0_12_lam, K0_22_lam, t228, K2_22_lam, M_11_rR, C1_12_rR,
                    C1_21_rR, self.mR, K2_12_rR, M_11_mR, C1_12_mR, self.rR, K2_12_mR,
                    self.w.like(1.0), M_22_ITzz, C1_22_ITzz, C1_12_IRyy, K2_12_IRyy, t247, M_22_xB,
                    t252, C1_22_xB, t253, t258, K2_22_xB, M_11_zB, t249, t261, self.mB, t251,
                    M_11_mB, t262, M_22_mB, t264, C1_22_mB, self.zB, t248, t266, t267, K2_22_mB, mu,
                    C1_12_IBxz, t270, t271, t272, C1_22_xH, t269, t282, K2_22_xH, M_11_zH, M_12_zH,
                    M_22_zH, t288, t289, self.mH, K0_12_zH, K0_22_zH, t291, t292, M_11_mH, M_12_mH,
                    M_22_mH, t296, t297, self.zH, K0_12_mH, K0_22_mH, t299, t277, sin_lam,
                    M_22_IHxx, M_22_IHzz, C1_22_IHzz, M_12_IHxz, M_22_IHxz, K2_22_SF, M_11_rF,
                    M_12_rF, M_22_rF, C1_12_rF, C1_21_rF, C1_22_rF, self.mF, t127, t314, K2_12_rF,
                    K2_22_rF, M_11_mF, M_12_mF, M_22_mF, C1_12_mF, C1_22_mF, self.rF, K0_12_mF,
                    t327, K2_12_mF, K2_22_mF, M_22_IFxx, C1_12_IFyy, t311, K2_12_IFyy, K2_22_IFyy,
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
        Partial::new(MatrixName::M, 1, 1, 0, 1),
        Partial::new(MatrixName::C1, 0, 1, 0, 2).negative(),
        Partial::new(MatrixName::C1, 1, 0, 0, 3), Partial::new(MatrixName::C1, 1, 1, 0, 4),
        Partial::new(MatrixName::K0, 0, 1, 0, 5), Partial::new(MatrixName::K0, 1, 0, 0, 5),
        Partial::new(MatrixName::K0, 1, 1, 0, 6),
        Partial::new(MatrixName::K2, 0, 1, 0, 7).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 8).negative(),
        Partial::new(MatrixName::M, 0, 1, 1, 9), Partial::new(MatrixName::M, 1, 0, 1, 9),
        Partial::new(MatrixName::M, 1, 1, 1, 10), Partial::new(MatrixName::C1, 0, 1, 1, 11),
        Partial::new(MatrixName::C1, 1, 0, 1, 12).negative(),
        Partial::new(MatrixName::C1, 1, 1, 1, 13).negative(),
        Partial::new(MatrixName::K0, 0, 1, 1, 14),
        Partial::new(MatrixName::K0, 1, 0, 1, 14),
        Partial::new(MatrixName::K0, 1, 1, 1, 15),
        Partial::new(MatrixName::K2, 1, 1, 1, 16).negative(),
        Partial::new(MatrixName::M, 0, 1, 2, 17),
        Partial::new(MatrixName::M, 1, 0, 2, 17),
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
        Partial::new(MatrixName::M, 1, 1, 15, 65).negative(),
        Partial::new(MatrixName::C1, 0, 1, 15, 66).negative(),
        Partial::new(MatrixName::C1, 1, 1, 15, 67),
        Partial::new(MatrixName::K0, 0, 1, 15, 68).negative(),
        Partial::new(MatrixName::K0, 1, 0, 15, 68).negative(),
        Partial::new(MatrixName::K0, 1, 1, 15, 69).negative(),
        Partial::new(MatrixName::K2, 1, 1, 15, 70), Partial::new(MatrixName::M, 0, 0, 16, 71),
        Partial::new(MatrixName::M, 0, 1, 16, 72), Partial::new(MatrixName::M, 1, 0, 16, 72),
        Partial::new(MatrixName::M, 1, 1, 16, 73),
        Partial::new(MatrixName::C1, 0, 1, 16, 74).negative(),
        Partial::new(MatrixName::C1, 1, 1, 16, 75).negative(),
        Partial::new(MatrixName::K0, 0, 0, 16, 76), Partial::new(MatrixName::K0, 0, 1, 16, 77),
        Partial::new(MatrixName::K0, 1, 0, 16, 77), Partial::new(MatrixName::K0, 1, 1, 16, 78),
        Partial::new(MatrixName::K2, 0, 1, 16, 79).negative(),
        Partial::new(MatrixName::K2, 1, 1, 16, 80).negative(),
        Partial::new(MatrixName::M, 0, 0, 17, 81), Partial::new(MatrixName::M, 0, 1, 17, 82),
        Partial::new(MatrixName::M, 1, 0, 17, 82), Partial::new(MatrixName::M, 1, 1, 17, 83),
        Partial::new(MatrixName::C1, 0, 1, 17, 84).negative(),
        Partial::new(MatrixName::C1, 1, 1, 17, 85).negative(),
        Partial::new(MatrixName::K0, 0, 0, 17, 86), Partial::new(MatrixName::K0, 0, 1, 17, 87),
        Partial::new(MatrixName::K0, 1, 0, 17, 87), Partial::new(MatrixName::K0, 1, 1, 17, 88),
        Partial::new(MatrixName::K2, 0, 1, 17, 89).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 90).negative(),
        Partial::new(MatrixName::M, 0, 0, 18, 35), Partial::new(MatrixName::M, 0, 1, 18, 91),
        Partial::new(MatrixName::M, 1, 0, 18, 91), Partial::new(MatrixName::M, 1, 1, 18, 92),
        Partial::new(MatrixName::M, 1, 1, 20, 93), Partial::new(MatrixName::C1, 1, 1, 20, 94),
        Partial::new(MatrixName::M, 0, 1, 21, 95), Partial::new(MatrixName::M, 1, 0, 21, 95),
        Partial::new(MatrixName::M, 1, 1, 21, 96), Partial::new(MatrixName::C1, 0, 1, 21, 63),
        Partial::new(MatrixName::C1, 1, 1, 21, 97), Partial::new(MatrixName::M, 0, 0, 22, 98),
        Partial::new(MatrixName::M, 0, 1, 22, 99), Partial::new(MatrixName::M, 1, 0, 22, 99),
        Partial::new(MatrixName::M, 1, 1, 22, 100), Partial::new(MatrixName::C1, 0, 1, 22, 101),
        Partial::new(MatrixName::C1, 1, 0, 22, 102), Partial::new(MatrixName::C1, 1, 1, 22, 103),
        Partial::new(MatrixName::K0, 0, 0, 22, 104).negative(),
        Partial::new(MatrixName::K0, 0, 1, 22, 105).negative(),
        Partial::new(MatrixName::K0, 1, 0, 22, 105).negative(),
        Partial::new(MatrixName::K0, 1, 1, 22, 106).negative(),
        Partial::new(MatrixName::K2, 0, 1, 22, 107), Partial::new(MatrixName::K2, 1, 1, 22, 108),
        Partial::new(MatrixName::M, 0, 0, 23, 109), Partial::new(MatrixName::M, 0, 1, 23, 110),
        Partial::new(MatrixName::M, 1, 0, 23, 110), Partial::new(MatrixName::M, 1, 1, 23, 111),
        Partial::new(MatrixName::C1, 0, 1, 23, 112), Partial::new(MatrixName::C1, 1, 1, 23, 113),
        Partial::new(MatrixName::K0, 0, 0, 23, 114).negative(),
        Partial::new(MatrixName::K0, 0, 1, 23, 115),
        Partial::new(MatrixName::K0, 1, 0, 23, 115),
        Partial::new(MatrixName::K0, 1, 1, 23, 116).negative(),
        Partial::new(MatrixName::K2, 0, 1, 23, 117), Partial::new(MatrixName::K2, 1, 1, 23, 118),
        Partial::new(MatrixName::M, 0, 0, 24, 35), Partial::new(MatrixName::M, 0, 1, 24, 91),
        Partial::new(MatrixName::M, 1, 0, 24, 91), Partial::new(MatrixName::M, 1, 1, 24, 119),
        Partial::new(MatrixName::C1, 1, 1, 24, 94), Partial::new(MatrixName::C1, 0, 1, 25, 120),
        Partial::new(MatrixName::C1, 1, 0, 25, 121).negative(),
        Partial::new(MatrixName::K2, 0, 1, 25, 122),
        Partial::new(MatrixName::K2, 1, 1, 25, 123),
    ];
}
