// @generated from generated/models/whipple.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 1f3729bd81655189

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    FormulaInfo, LengthError, MatrixName, Model, ModelInfo, Number, ParameterError,
    ParameterInfo, Partial, RequirementInfo, Rows, Scalar, SetInfo, WithDerivatives,
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
    /// 48 additions, 50 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 104 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleMatrices<T> {
        let t3 = self.zB * self.mB;
        let t7 = self.zH * self.mH;
        let t12 = self.rF * self.mF;
        let t17 = self.zH * t7 + (self.IHxx + (self.rF * t12 + self.IFxx));
        let t22 = self.rR * self.mR;
        let ITxx = self.IBxx + (self.zB * t3 + t17 + (self.IRxx + self.rR * t22));
        let t28 = self.mH * self.xH;
        let t34 = self.IHxz + t12 * self.w - self.zH * t28;
        let ITzz = t3 * self.xB;
        let t39 = t34 - ITzz + self.IBxz;
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t43 = cos_lam / self.w;
        let mu = self.c * t43;
        let t49 = self.w - self.xH + self.c;
        let t52 = cos_lam * (t12 * self.c - self.IHxz - t7 * t49);
        let t55 = t17 * sin_lam - t52;
        let M_12 = t39 * mu + t55;
        let t58 = self.IFxx + self.IHzz;
        let t59 = self.mF * self.c;
        let t62 = self.mH * t49;
        let t69 = self.mF * self.w;
        let IAlz = t34 * sin_lam - cos_lam * (self.xH * t62 - t58 + self.c * t69);
        let t76 = self.mB * self.xB;
        let t86 = IAlz
            + (self.IRxx + t58
                + (self.xB * t76 + self.xH * t28 + (self.IBzz + self.w * t69))) * mu;
        let t89 = cos_lam * (cos_lam * (t58 + self.c * t59 + t49 * t62))
            + mu * (IAlz + t86);
        let M_22 = t89 + sin_lam * (t55 - t52);
        let zero = self.w.like(0.0);
        let SF = self.IFyy / self.rF;
        let SR = self.IRyy / self.rR;
        let ST = SF + SR;
        let t99 = t7 - t12;
        let K0_11 = t3 + t99 - t22;
        let t102 = ST - K0_11;
        let C1_12 = t43 * (t39 + self.c * t102 + self.w * SF);
        let K0_12 = cos_lam * (t62 + t59) + sin_lam * t99 - mu * (t28 + t69 + t76);
        let C1_22 = t43 * t86 - mu * K0_12;
        let K0_22 = sin_lam * K0_12;
        let K2_12 = t43 * t102;
        let K2_22 = t43 * (sin_lam * SF - K0_12);
        let C1_21 = -(cos_lam * SF + mu * ST);
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
    /// 107 additions, 198 multiplications, 3 divisions, 3 negations and 2 trigonometric functions: 313 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WhippleMatrices<T>, WhippleDerivatives<T>) {
        let t4 = self.zH * self.mH;
        let t9 = self.rF * self.mF;
        let t13 = self.IFxx + self.zH * t4 + self.IHxx + self.rF * t9;
        let M_11_mR = self.rR * self.rR;
        let t21 = self.zB * self.mB;
        let M_11 = self.IBxx + t13 + self.mR * M_11_mR + self.IRxx + self.zB * t21;
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t33 = t9 * self.c;
        let t36 = self.c + self.w;
        let t37 = self.xH - t36;
        let t38 = self.mH * t37;
        let IAlz_rF = self.zH * t38;
        let t41 = self.IHxz - t33 - IAlz_rF;
        let t43 = t13 * sin_lam + cos_lam * t41;
        let t48 = self.IHxz + t9 * self.w - t4 * self.xH;
        let t50 = self.mB * self.xB;
        let t53 = self.IBxz + t48 - self.zB * t50;
        let t54 = self.w.like(1.0) / self.w;
        let t55 = self.c * t54;
        let t56 = t53 * t55;
        let M_12 = t43 + cos_lam * t56;
        let C1_12_IBxz = cos_lam * t54;
        let t62 = self.IFxx + self.IHzz;
        let t63 = self.mF * self.w;
        let t65 = self.mH * self.xH;
        let t68 = t62 + t37 * t65 - self.c * t63;
        let t70 = sin_lam * t54;
        let t72 = C1_12_IBxz * t68 + t48 * t70;
        let t73 = cos_lam * self.c;
        let t88 = C1_12_IBxz
            * (self.IRxx + t62 + self.xB * t50 + self.IBzz + self.w * t63
                + self.xH * t65);
        let t89 = t55 * t88;
        let t90 = t72 + t89;
        let t92 = t90 + self.mF * t73;
        let t95 = cos_lam * (t62 + t37 * t38) + sin_lam * t41 + self.c * t92;
        let M_22 = sin_lam * t43 + t72 * t73 + cos_lam * t95;
        let zero = self.w.like(0.0);
        let t101 = self.w.like(1.0) / self.rF;
        let SF = self.IFyy * t101;
        let t105 = self.w.like(1.0) / self.rR;
        let t106 = self.IRyy * t105;
        let ST = SF + t106;
        let t108 = self.mR * self.rR;
        let t109 = t4 - t9;
        let K0_11 = t21 + t109 - t108;
        let t112 = ST - K0_11;
        let t115 = t53 + self.w * SF + self.c * t112;
        let C1_12 = C1_12_IBxz * t115;
        let t117 = t55 * ST;
        let t118 = SF + t117;
        let t120 = t63 + t65;
        let t123 = self.mF - t54 * (t50 + t120);
        let t125 = t38 - self.c * t123;
        let t126 = cos_lam * t125;
        let t127 = sin_lam * t109;
        let t128 = t126 - t127;
        let t130 = t90 + t55 * t128;
        let C1_22 = cos_lam * t130;
        let K2_12 = C1_12_IBxz * t112;
        let t135 = t128 + sin_lam * SF;
        let K2_22 = C1_12_IBxz * t135;
        let M_12_w = cos_lam * (t4 + t54 * (t33 - t56));
        let t141 = self.mH * cos_lam;
        let t144 = cos_lam * t37 - self.zH * sin_lam;
        let t145 = t141 * t144;
        let t146 = t145 + t145;
        let mu = cos_lam * t55;
        let t148 = mu + mu;
        let t149 = self.w * mu;
        let t150 = self.rF * sin_lam;
        let t151 = t73 - t150;
        let t152 = t149 - t151;
        let t153 = self.mF * t152;
        let t154 = self.xH * t141;
        let t155 = t154 - t153;
        let t158 = t146 + t148 * (t90 + t155);
        let C1_12_SF = t54 * t115;
        let C1_12_w = C1_12_IBxz * (t9 + SF - C1_12_SF);
        let C1_21_w = C1_12_IBxz * t117;
        let K0_12_w = t141 - t123 * mu;
        let C1_22_mu = self.c * (C1_12_IBxz * t63 - K0_12_w);
        let t169 = t89 + t130;
        let C1_22_w = C1_12_IBxz * (C1_22_mu - t155 - t169);
        let t174 = t54 * K2_12;
        let t177 = t54 * (K2_22 + cos_lam * K0_12_w);
        let t179 = cos_lam * t109;
        let M_12_c = t53 * C1_12_IBxz + t179;
        let t182 = t92 - t120 * mu;
        let t183 = sin_lam + sin_lam;
        let M_12_rF = t9 * t183;
        let M_22_c = cos_lam * (t182 + t182 - M_12_rF) - t146;
        let t189 = C1_12_IBxz * ST;
        let IAlz = self.mH + t123;
        let K0_12_c = cos_lam * IAlz;
        let t197 = C1_12_IBxz * (self.c * K0_12_c + cos_lam * t120 - t88 - t128);
        let K0_22_c = sin_lam * K0_12_c;
        let t199 = C1_12_IBxz * K0_12_c;
        let M_12_lam = t13 * cos_lam - sin_lam * (t41 + t56);
        let t206 = sin_lam * t68 - cos_lam * t48;
        let t211 = cos_lam * (t43 - t55 * t206) - sin_lam * t95;
        let M_22_lam = t211 + t211;
        let t213 = sin_lam * C1_12_SF;
        let C1_21_lam = sin_lam * t118;
        let K0_12_lam = t179 + sin_lam * t125;
        let t221 = sin_lam * t169 + mu * K0_12_lam + C1_12_IBxz * t206;
        let K0_22_lam = sin_lam * K0_12_lam - cos_lam * t128;
        let t225 = t70 * t112;
        let K2_22_lam = C1_12_IBxz * (cos_lam * SF - K0_12_lam) - t70 * t135;
        let M_11_rR = t108 + t108;
        let t232 = t105 * t106;
        let t233 = self.mR - t232;
        let C1_12_rR = mu * t233;
        let C1_21_rR = mu * t232;
        let K2_12_rR = C1_12_IBxz * t233;
        let C1_12_mR = self.rR * mu;
        let K2_12_mR = self.rR * C1_12_IBxz;
        let M_22_IRxx = mu * mu;
        let C1_22_IRxx = C1_12_IBxz * mu;
        let C1_12_IRyy = t105 * mu;
        let K2_12_IRyy = C1_12_IBxz * t105;
        let t244 = self.mB * C1_12_IBxz;
        let t245 = self.c * t244;
        let t246 = self.zB * t245;
        let t247 = self.xB * t245;
        let M_22_xB = t148 * t247;
        let t249 = t21 * C1_12_IBxz;
        let t250 = self.c + self.xB;
        let t251 = t244 * t250;
        let C1_22_xB = C1_12_IBxz * (t247 + self.c * t251);
        let t255 = sin_lam * t245;
        let K2_22_xB = self.mB * C1_22_IRxx;
        let M_11_zB = t21 + t21;
        let M_11_mB = self.zB * self.zB;
        let t259 = self.xB * mu;
        let t260 = self.zB * t259;
        let M_22_mB = t259 * t259;
        let t262 = self.zB * C1_12_IBxz;
        let t263 = t250 * t262;
        let K2_22_mB = self.xB * C1_22_IRxx;
        let C1_22_mB = t250 * K2_22_mB;
        let t266 = sin_lam * t259;
        let M_12_IHxz = cos_lam + mu;
        let t268 = t4 * M_12_IHxz;
        let t270 = t144 + self.xH * mu;
        let t271 = self.mH * t270;
        let t272 = t154 + t271;
        let M_22_xH = t146 + t148 * t272;
        let t275 = t4 * C1_12_IBxz;
        let t276 = self.c + self.xH;
        let C1_22_xH = C1_12_IBxz * (t272 + self.mH * (t73 + mu * t276));
        let t282 = self.mH * M_12_IHxz;
        let t283 = sin_lam * t282;
        let t284 = t54 * t141;
        let K2_22_xH = M_12_IHxz * t284;
        let M_11_zH = t4 + t4;
        let M_12_zH = t4 * sin_lam - t271;
        let t289 = t183 * t271;
        let t290 = t276 * t284;
        let t291 = sin_lam * t290;
        let K0_12_zH = self.mH * sin_lam;
        let K0_22_zH = sin_lam * K0_12_zH;
        let t294 = t70 * t141;
        let M_11_mH = self.zH * self.zH;
        let t296 = self.zH * t270;
        let M_22_mH = t270 * t270;
        let t298 = self.zH * C1_12_IBxz;
        let t299 = t276 * t298;
        let K2_22_mH = C1_12_IBxz * t270;
        let C1_22_mH = t276 * K2_22_mH;
        let t302 = sin_lam * t270;
        let M_22_IHxx = sin_lam * sin_lam;
        let M_22_IHzz = M_12_IHxz * M_12_IHxz;
        let C1_22_IHzz = C1_12_IBxz * M_12_IHxz;
        let M_22_IHxz = t183 * M_12_IHxz;
        let K2_22_SF = cos_lam * t70;
        let M_11_rF = t9 + t9;
        let M_22_rF = t153 * t183;
        let t310 = t36 * C1_12_IBxz;
        let t312 = self.mF - t101 * SF;
        let C1_12_rF = t310 * t312;
        let t314 = t101 * M_12_IHxz;
        let C1_21_rF = SF * t314;
        let t316 = self.mF * sin_lam;
        let C1_22_rF = t310 * t316;
        let t318 = sin_lam * t316;
        let K2_12_rF = C1_12_IBxz * t312;
        let K2_22_rF = K2_22_SF * t312;
        let M_11_mF = self.rF * self.rF;
        let M_12_mF = self.rF * t150;
        let M_22_mF = t152 * t152;
        let C1_12_mF = self.rF * t310;
        let K2_22_mF = C1_12_IBxz * t152;
        let C1_22_mF = t36 * K2_22_mF;
        let t327 = sin_lam * t152;
        let K2_12_mF = self.rF * C1_12_IBxz;
        let M_22_IFxx = M_22_IHxx + M_22_IHzz;
        let C1_12_IFyy = t101 * t310;
        let K2_12_IFyy = C1_12_IBxz * t101;
        let K2_22_IFyy = t101 * K2_22_SF;
        let C1_21 = -(cos_lam * t118);
        let K0_12 = t127 - t126;
        let K0_22 = -(sin_lam * t128);
        let t336 = -(sin_lam * K0_12_w);
        let K0_12_mF = t151 - t149;
        (
            WhippleMatrices::from_entries([
                M_11, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, K0_11, K0_12, K0_12, K0_22, zero,
                K2_12, zero, K2_22,
            ]),
            WhippleDerivatives {
                values: [
                    M_12_w, t158, C1_12_w, C1_21_w, C1_22_w, K0_12_w, t336, t174, t177, M_12_c,
                    M_22_c, K2_12, t189, t197, K0_12_c, K0_22_c, t199, M_12_lam, M_22_lam, t213,
                    C1_21_lam, t221, K0_12_lam, K0_22_lam, t225, K2_22_lam, M_11_rR, C1_12_rR,
                    C1_21_rR, self.mR, K2_12_rR, M_11_mR, C1_12_mR, self.rR, K2_12_mR,
                    self.w.like(1.0), M_22_IRxx, C1_22_IRxx, C1_12_IRyy, K2_12_IRyy, t246, M_22_xB,
                    t249, C1_22_xB, t245, t255, K2_22_xB, M_11_zB, t247, t251, self.mB, t244,
                    M_11_mB, t260, M_22_mB, t263, C1_22_mB, self.zB, t259, t266, t262, K2_22_mB, mu,
                    C1_12_IBxz, t268, M_22_xH, t275, C1_22_xH, t282, t283, K2_22_xH, M_11_zH,
                    M_12_zH, t289, t290, t291, self.mH, K0_12_zH, K0_22_zH, t284, t294, M_11_mH,
                    t296, M_22_mH, t299, C1_22_mH, self.zH, t270, t302, t298, K2_22_mH, sin_lam,
                    M_22_IHxx, M_22_IHzz, C1_22_IHzz, M_12_IHxz, M_22_IHxz, K2_22_SF, M_11_rF,
                    M_12_rF, M_22_rF, C1_12_rF, C1_21_rF, C1_22_rF, self.mF, t316, t318, K2_12_rF,
                    K2_22_rF, M_11_mF, M_12_mF, M_22_mF, C1_12_mF, C1_22_mF, self.rF, K0_12_mF,
                    t327, K2_12_mF, K2_22_mF, M_22_IFxx, C1_12_IFyy, t314, K2_12_IFyy, K2_22_IFyy,
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
        let matrices = self.matrices();
        [
            matrices.m[0][0], matrices.m[0][1], matrices.m[1][1], matrices.c1[0][1],
            matrices.c1[1][0], matrices.c1[1][1], matrices.k0[0][0], matrices.k0[0][1],
            matrices.k0[1][1], matrices.k2[0][1], matrices.k2[1][1],
        ]
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

impl WhippleDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 158] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 0), Partial::new(MatrixName::M, 1, 0, 0, 0),
        Partial::new(MatrixName::M, 1, 1, 0, 1).negative(),
        Partial::new(MatrixName::C1, 0, 1, 0, 2), Partial::new(MatrixName::C1, 1, 0, 0, 3),
        Partial::new(MatrixName::C1, 1, 1, 0, 4), Partial::new(MatrixName::K0, 0, 1, 0, 5),
        Partial::new(MatrixName::K0, 1, 0, 0, 5),
        Partial::new(MatrixName::K0, 1, 1, 0, 6).negative(),
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
        Partial::new(MatrixName::C1, 1, 0, 2, 20),
        Partial::new(MatrixName::C1, 1, 1, 2, 21).negative(),
        Partial::new(MatrixName::K0, 0, 1, 2, 22),
        Partial::new(MatrixName::K0, 1, 0, 2, 22),
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
        Partial::new(MatrixName::C1, 1, 1, 17, 85),
        Partial::new(MatrixName::K0, 0, 0, 17, 86),
        Partial::new(MatrixName::K0, 0, 1, 17, 87).negative(),
        Partial::new(MatrixName::K0, 1, 0, 17, 87).negative(),
        Partial::new(MatrixName::K0, 1, 1, 17, 88).negative(),
        Partial::new(MatrixName::K2, 0, 1, 17, 89).negative(),
        Partial::new(MatrixName::K2, 1, 1, 17, 90), Partial::new(MatrixName::M, 0, 0, 18, 35),
        Partial::new(MatrixName::M, 0, 1, 18, 91), Partial::new(MatrixName::M, 1, 0, 18, 91),
        Partial::new(MatrixName::M, 1, 1, 18, 92), Partial::new(MatrixName::M, 1, 1, 20, 93),
        Partial::new(MatrixName::C1, 1, 1, 20, 94), Partial::new(MatrixName::M, 0, 1, 21, 95),
        Partial::new(MatrixName::M, 1, 0, 21, 95), Partial::new(MatrixName::M, 1, 1, 21, 96),
        Partial::new(MatrixName::C1, 0, 1, 21, 63), Partial::new(MatrixName::C1, 1, 1, 21, 97),
        Partial::new(MatrixName::M, 0, 0, 22, 98), Partial::new(MatrixName::M, 0, 1, 22, 99),
        Partial::new(MatrixName::M, 1, 0, 22, 99), Partial::new(MatrixName::M, 1, 1, 22, 100),
        Partial::new(MatrixName::C1, 0, 1, 22, 101), Partial::new(MatrixName::C1, 1, 0, 22, 102),
        Partial::new(MatrixName::C1, 1, 1, 22, 103),
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
