// @generated from generated/models/whipple.rs, with fewer derivatives; do not edit.
// To write it anew: UPDATE=1 cargo test --workspace --test integration chosen_derivatives
// Hash of the source: c040b54a706ae5db

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Bound, Coefficients, CoordinateInfo, Domain, EntryInfo, Evaluator, FormulaInfo,
    LengthError, MatrixName, Model, ModelInfo, Number, ParameterError, ParameterInfo,
    Partial, RequirementInfo, Rows, Scalar, SetInfo,
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
pub struct WhippleChosen<T = f64> {
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

/// The coefficient matrices of [`WhippleChosen`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleChosenMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 2>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 2>,
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: Rows<T, 2>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 2>,
}

impl<T: Number> WhippleChosen<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 49 additions, 50 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 105 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleChosenMatrices<T> {
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
        WhippleChosenMatrices::from_entries([
            ITxx, M_12, M_12, M_22, zero, C1_12, C1_21, C1_22, K0_11, K0_12, K0_12, K0_22, zero,
            K2_12, zero, K2_22,
        ])
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`WhippleChosen`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
///
/// Asked for are those of M, K0 with respect to `w`, `c`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhippleChosenDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 8],
}

impl<T: Number> WhippleChosen<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 59 additions, 67 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 132 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (WhippleChosenMatrices<T>, WhippleChosenDerivatives<T>) {
        let zero = self.w.like(0.0);
        let mut matrices = WhippleChosenMatrices::from_entries([zero; 16]);
        let mut derivatives = WhippleChosenDerivatives {
            values: [zero; 8],
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
        matrices: &mut WhippleChosenMatrices<T>,
        derivatives: &mut WhippleChosenDerivatives<T>,
    ) {
        *matrices = WhippleChosenMatrices::from_entries([self.w.like(0.0); 16]);
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
        let (sin_lam, cos_lam) = self.lam.sin_cos();
        let t26 = self.rF * self.mF;
        let t27 = self.zH * self.mH;
        let t32 = self.rF * t26 + self.IHxx + self.IFxx + self.zH * t27;
        let t33 = self.zB * self.mB;
        let t34 = self.rR * self.mR;
        let t35 = self.w.like(1.0) / self.w;
        let t37 = t27 * self.xH - self.IHxz;
        let t38 = self.mF * self.w;
        let t43 = self.IBxz + self.rF * t38 - t33 * self.xB - t37;
        let t44 = t26 - t27;
        let t45 = self.IFxx + self.IHzz;
        let t47 = self.c + self.w - self.xH;
        let t48 = self.mB * self.xB;
        let t49 = self.mH * self.xH;
        let SF = self.IFyy / self.rF;
        let K0_11 = t33 - t34 - t44;
        put_entry(6, K0_11);
        let ITxx = t32 + self.zB * t33 + self.rR * t34 + self.IRxx + self.IBxx;
        put_entry(0, ITxx);
        let SR = self.IRyy / self.rR;
        let ST = SF + SR;
        let t61 = t35 * t43;
        let t62 = cos_lam * t35;
        let t69 = cos_lam * (t37 + self.c * t44 - t27 * self.w) - t32 * sin_lam;
        let t72 = self.IHxz * sin_lam + cos_lam * t45;
        let t73 = self.mF * cos_lam;
        let t74 = t26 * sin_lam;
        let t75 = self.mH * cos_lam;
        let t76 = cos_lam + cos_lam;
        let M_12_c = cos_lam * (t61 - t44);
        put_derivative(0, M_12_c);
        let t79 = ST - K0_11;
        let mu = self.c * t62;
        let M_22_mu = self.c * t73;
        let t82 = t74 - M_22_mu;
        let t85 = t27 * sin_lam + t47 * t75;
        let t89 = t73 - t62 * (t38 + t48 + t49);
        let C1_12 = t62 * (t43 + self.c * t79 + self.w * SF);
        put_entry(3, C1_12);
        let K2_12 = t62 * t79;
        put_entry(9, K2_12);
        let M_12_w = t27 * cos_lam - mu * (t61 - t26);
        put_derivative(1, M_12_w);
        let C1_21 = -(cos_lam * SF + mu * ST);
        put_entry(4, C1_21);
        let t107 = t72 + self.w * t82 - self.xH * t85;
        let t109 = t85 - mu * t49;
        let M_12 = mu * t43 - t69;
        put_entry(1, M_12);
        let t112 = self.c * t89;
        let K0_12_c = t75 + t89;
        put_derivative(2, K0_12_c);
        let t122 = mu
            * (self.IRxx + t45 + self.xB * t48 + self.xH * t49 + self.w * t38
                + self.IBzz);
        let t124 = t35 * (t107 + t122);
        let K0_12 = t85 + t112 - t74;
        put_entry(7, K0_12);
        let K0_12_w = t75 - t35 * t112;
        put_derivative(3, K0_12_w);
        let K0_22_c = sin_lam * K0_12_c;
        put_derivative(4, K0_22_c);
        let K0_22 = sin_lam * K0_12;
        put_entry(8, K0_22);
        let K2_22 = t62 * (sin_lam * SF - K0_12);
        put_entry(10, K2_22);
        let K0_22_w = sin_lam * K0_12_w;
        put_derivative(5, K0_22_w);
        let t135 = t124 - t82;
        let C1_22 = cos_lam * t124 - mu * K0_12;
        put_entry(5, C1_22);
        let t145 = cos_lam * (t72 + self.c * (t35 * t107 + t135) + t47 * t85);
        let M_22 = t145 - sin_lam * t69;
        put_entry(2, M_22);
        let t149 = t135 - mu * t38;
        let M_22_w = t76 * (t109 - self.c * t35 * t149);
        put_derivative(6, M_22_w);
        let M_22_c = t76 * (t109 + t149);
        put_derivative(7, M_22_c);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl WhippleChosen<f64> {
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

impl WhippleChosen<f64> {
    /// The parameter set `benchmark`.
    #[must_use]
    pub const fn default() -> Self {
        Self::BENCHMARK
    }
}

/// The parameter set `benchmark`.
impl<T: Scalar> Default for WhippleChosen<T> {
    fn default() -> Self {
        WhippleChosen::cast(&WhippleChosen::<f64>::BENCHMARK)
    }
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> WhippleChosen<T> {
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

impl<T: Scalar> WhippleChosen<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> WhippleChosen<U> {
        let values = self.to_array();
        WhippleChosen::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl WhippleChosen<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> WhippleChosen<f32> {
        WhippleChosen::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<WhippleChosen<f32>> for WhippleChosen<f64> {
    fn from(parameters: WhippleChosen<f32>) -> Self {
        WhippleChosen::cast(&parameters)
    }
}

impl<T: Number> WhippleChosenMatrices<T> {
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

impl<T: Scalar> From<WhippleChosenMatrices<T>> for Coefficients<T, 2> {
    fn from(matrices: WhippleChosenMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<2> for WhippleChosen<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 26];

    type Over<U: Number> = WhippleChosen<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "WhippleChosen",
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
                values: &WhippleChosen::to_array(&WhippleChosen::<f64>::BENCHMARK),
            },
            SetInfo {
                name: "benchmark_2005",
                docs: "",
                source: "Schwab, Meijaard & Papadopoulos (2005), ENOC 2005",
                values: &WhippleChosen::to_array(&WhippleChosen::<f64>::BENCHMARK_2005),
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
        LengthError::check("WhippleChosen", 26, values)?;
        Ok(<Self as Evaluator<T, 2>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("WhippleChosen", 26, values)?;
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
        Coefficients::from_rows(WhippleChosenMatrices::rows(&self.matrices()))
    }

    fn gravity(&self) -> Option<T> {
        Some(self.g)
    }
}

impl WhippleChosen<f64> {
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
impl<T: Scalar> core::fmt::Display for WhippleChosen<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<2>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 2> for WhippleChosen<T> {
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
        WhippleChosenMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 8] {
        WhippleChosenMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> WhippleChosenDerivatives<T> {
    /// The derivatives of a matrix with respect to the parameter at a position, row by row, with the zeros filled in;

    /// nothing if those are not asked for.
    #[must_use]
    pub fn matrix_with_respect_to(&self, matrix: MatrixName, parameter: usize) -> Option<[[T; 2]; 2]> {
        if !core::matches!(matrix, MatrixName::M | MatrixName::K0)
            || !core::matches!(parameter, 0 | 1)
        {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut rows = [[zero; 2]; 2];
        for position in 0..12 {
            let partial = <WhippleChosenDerivatives>::PARTIALS[position];
            if partial.parameter == parameter && partial.matrix == matrix {
                rows[partial.row][partial.column] = Partial::of(&partial, &self.values);
            }
        }
        Some(rows)
    }
}

impl WhippleChosenDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 12] = &[
        Partial::new(MatrixName::M, 0, 1, 0, 1), Partial::new(MatrixName::M, 1, 0, 0, 1),
        Partial::new(MatrixName::M, 1, 1, 0, 6), Partial::new(MatrixName::K0, 0, 1, 0, 3),
        Partial::new(MatrixName::K0, 1, 0, 0, 3), Partial::new(MatrixName::K0, 1, 1, 0, 5),
        Partial::new(MatrixName::M, 0, 1, 1, 0), Partial::new(MatrixName::M, 1, 0, 1, 0),
        Partial::new(MatrixName::M, 1, 1, 1, 7), Partial::new(MatrixName::K0, 0, 1, 1, 2),
        Partial::new(MatrixName::K0, 1, 0, 1, 2), Partial::new(MatrixName::K0, 1, 1, 1, 4),
    ];
}
