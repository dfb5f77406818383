// @generated from generated/models/cantilevered_pipe.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 0185b6c845d15a5e

#![allow(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)]

use carvallo::{
    Coefficients, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator,
    EvaluatorWithDerivatives, FormulaInfo, LengthError, MatrixName, Model, ModelInfo,
    Number, ParameterError, ParameterInfo, Partial, Rows, Scalar, SetInfo,
    WithDerivatives,
};

// --- The parameters ------------------------------------------------------------------------------

/// A cantilevered pipe that carries a fluid, in its first four modes: it flutters above a critical speed.
///
/// A slender elastic pipe, clamped where the fluid enters and free where it leaves, in a horizontal plane and without
/// damping of its own. The deflection is a sum of the first four modes of the clamped beam (Galerkin), each with a
/// mean square of one over the length, so that its end is deflected by twice its coordinate. The speed v is that of the
/// fluid; textbooks have it as u = v l sqrt(f/EI), and the part of the fluid in the mass as beta = f/(m + f).
///
/// Source: Gregory & Paidoussis (1966), Unstable oscillation of tubular cantilevers conveying fluid, Proc. R. Soc. A 293, 512-527; integrals of the modes: Paidoussis, Fluid-Structure Interactions, vol. 1
///
/// The fields are the parameters. The coordinates are `first` in `m`, `second` in `m`, `third` in `m`, `fourth` in `m`.
///
/// <details><summary>The formulas of its matrices</summary>
///
/// ```text
/// mass = (m + f)*l [kg]
/// stiffness = EI/l^3 [kg/s^2]
/// flow = f/l [kg/m^2]
/// lam1 = 1.875104068711961166445308 [1]
/// lam2 = 4.694091132974174576436392 [1]
/// lam3 = 7.854757438237612564861009 [1]
/// lam4 = 10.99554073487546699066735 [1]
/// n1 = 0.7340955137589127558287828*lam1 [1]
/// n2 = 1.018467318759219405032741*lam2 [1]
/// n3 = 0.9992244965174282872163576*lam3 [1]
/// n4 = 1.000033553251713398399016*lam4 [1]
/// M_11 = M_22 = M_33 = M_44 = mass [kg]
/// C1_11 = C1_22 = C1_33 = C1_44 = 4*f [kg/m]
/// C1_12 = 8*f/((lam1/lam2)^2 - 1) [kg/m]
/// C1_13 = 8*f/((lam1/lam3)^2 + 1) [kg/m]
/// C1_14 = 8*f/((lam1/lam4)^2 - 1) [kg/m]
/// C1_21 = 8*f/((lam2/lam1)^2 - 1) [kg/m]
/// C1_23 = 8*f/((lam2/lam3)^2 - 1) [kg/m]
/// C1_24 = 8*f/((lam2/lam4)^2 + 1) [kg/m]
/// C1_31 = 8*f/((lam3/lam1)^2 + 1) [kg/m]
/// C1_32 = 8*f/((lam3/lam2)^2 - 1) [kg/m]
/// C1_34 = 8*f/((lam3/lam4)^2 - 1) [kg/m]
/// C1_41 = 8*f/((lam4/lam1)^2 - 1) [kg/m]
/// C1_42 = 8*f/((lam4/lam2)^2 + 1) [kg/m]
/// C1_43 = 8*f/((lam4/lam3)^2 - 1) [kg/m]
/// Kc_11 = stiffness*lam1^4 [kg/s^2]
/// Kc_22 = stiffness*lam2^4 [kg/s^2]
/// Kc_33 = stiffness*lam3^4 [kg/s^2]
/// Kc_44 = stiffness*lam4^4 [kg/s^2]
/// K2_11 = flow*n1*(2 - n1) [kg/m^2]
/// K2_12 = 4*flow*(n2 - n1)/(-1 - (lam1/lam2)^2) [kg/m^2]
/// K2_13 = 4*flow*(n3 - n1)/(1 - (lam1/lam3)^2) [kg/m^2]
/// K2_14 = 4*flow*(n4 - n1)/(-1 - (lam1/lam4)^2) [kg/m^2]
/// K2_21 = 4*flow*(n1 - n2)/(-1 - (lam2/lam1)^2) [kg/m^2]
/// K2_22 = flow*n2*(2 - n2) [kg/m^2]
/// K2_23 = 4*flow*(n3 - n2)/(-1 - (lam2/lam3)^2) [kg/m^2]
/// K2_24 = 4*flow*(n4 - n2)/(1 - (lam2/lam4)^2) [kg/m^2]
/// K2_31 = 4*flow*(n1 - n3)/(1 - (lam3/lam1)^2) [kg/m^2]
/// K2_32 = 4*flow*(n2 - n3)/(-1 - (lam3/lam2)^2) [kg/m^2]
/// K2_33 = flow*n3*(2 - n3) [kg/m^2]
/// K2_34 = 4*flow*(n4 - n3)/(-1 - (lam3/lam4)^2) [kg/m^2]
/// K2_41 = 4*flow*(n1 - n4)/(-1 - (lam4/lam1)^2) [kg/m^2]
/// K2_42 = 4*flow*(n2 - n4)/(1 - (lam4/lam2)^2) [kg/m^2]
/// K2_43 = 4*flow*(n3 - n4)/(-1 - (lam4/lam3)^2) [kg/m^2]
/// K2_44 = flow*n4*(2 - n4) [kg/m^2]
/// ```
///
/// </details>
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct CantileveredPipe<T = f64> {
    /// Length.
    ///
    /// `l` in `m`: `> 0`.
    pub l: T,
    /// Flexural rigidity.
    ///
    /// `EI` in `N*m^2`: `> 0`.
    pub EI: T,
    /// Mass of the pipe for each metre.
    ///
    /// `m` in `kg/m`: `> 0`.
    pub m: T,
    /// Mass of the fluid in it for each metre.
    ///
    /// `f` in `kg/m`: `>= 0`.
    pub f: T,
}

// --- The coefficient matrices --------------------------------------------------------------------

/// The coefficient matrices of [`CantileveredPipe`], each 4 x 4 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CantileveredPipeMatrices<T = f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: Rows<T, 4>,
    /// Damping C1, a coefficient of v q'.
    pub c1: Rows<T, 4>,
    /// Stiffness Kc, a coefficient of q. Symmetric, proved.
    pub kc: Rows<T, 4>,
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: Rows<T, 4>,
}

impl<T: Number> CantileveredPipe<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 1 addition, 36 multiplications, 2 divisions and 11 negations: 50 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> CantileveredPipeMatrices<T> {
        let mass = self.l * (self.m + self.f);
        let zero = self.l.like(0.0);
        let C1_11 = self.f * self.l.like(4.0);
        let C1_13 = self.f * self.l.like(7.568674603525367);
        let C1_21 = self.f * self.l.like(1.5189220591449966);
        let C1_24 = self.f * self.l.like(6.766752743711723);
        let C1_31 = self.f * self.l.like(0.43132539647463314);
        let C1_32 = self.f * self.l.like(4.4443729491027995);
        let C1_41 = self.f * self.l.like(0.2396209592479588);
        let C1_42 = self.f * self.l.like(1.2332472562882775);
        let C1_43 = self.f * self.l.like(8.336799302190666);
        let stiffness = self.EI / (self.l * self.l * self.l);
        let Kc_11 = stiffness * self.l.like(12.362363368326191);
        let Kc_22 = stiffness * self.l.like(485.51881851337106);
        let Kc_33 = stiffness * self.l.like(3806.546266391451);
        let Kc_44 = stiffness * self.l.like(14617.27330511878);
        let flow = self.f / self.l;
        let K2_11 = flow * self.l.like(0.8582436200114997);
        let K2_13 = flow * self.l.like(27.45314869883141);
        let K2_21 = flow * self.l.like(1.8738533309718404);
        let K2_24 = flow * self.l.like(30.40116729418553);
        let K2_31 = flow * self.l.like(1.564506451563535);
        let K2_32 = flow * self.l.like(3.229330799040317);
        let K2_41 = flow * self.l.like(1.087366479542848);
        let K2_42 = flow * self.l.like(5.540642250946188);
        let K2_43 = flow * self.l.like(4.253605462830704);
        let C1_12 = -(self.f * self.l.like(9.518922059144996));
        let C1_14 = -(self.f * self.l.like(8.23962095924796));
        let C1_23 = -(self.f * self.l.like(12.4443729491028));
        let C1_34 = -(self.f * self.l.like(16.336799302190666));
        let K2_12 = -(flow * self.l.like(11.743238371184557));
        let K2_14 = -(flow * self.l.like(37.39025026585289));
        let K2_22 = -(flow * self.l.like(13.294285387122411));
        let K2_23 = -(flow * self.l.like(9.04221974607116));
        let K2_33 = -(flow * self.l.like(45.904226616338164));
        let K2_34 = -(flow * self.l.like(8.33536903529716));
        let K2_44 = -(flow * self.l.like(98.91821015122053));
        CantileveredPipeMatrices::from_entries([
            mass, zero, zero, zero, zero, mass, zero, zero, zero, zero, mass, zero, zero, zero,
            zero, mass, C1_11, C1_12, C1_13, C1_14, C1_21, C1_11, C1_23, C1_24, C1_31, C1_32, C1_11,
            C1_34, C1_41, C1_42, C1_43, C1_11, Kc_11, zero, zero, zero, zero, Kc_22, zero, zero,
            zero, zero, Kc_33, zero, zero, zero, zero, Kc_44, K2_11, K2_12, K2_13, K2_14, K2_21,
            K2_22, K2_23, K2_24, K2_31, K2_32, K2_33, K2_34, K2_41, K2_42, K2_43, K2_44,
        ])
    }
}

// --- The derivatives of the matrices -------------------------------------------------------------

/// The derivatives of the matrices of [`CantileveredPipe`] with respect to its parameters,
/// in SI units: those that are not zero for all parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CantileveredPipeDerivatives<T = f64> {
    /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
    pub values: [T; 55],
}

impl<T: Number> CantileveredPipe<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 1 addition, 81 multiplications, 3 divisions and 11 negations: 96 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    ///
    /// Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(&self) -> (CantileveredPipeMatrices<T>, CantileveredPipeDerivatives<T>) {
        let zero = self.l.like(0.0);
        let mut matrices = CantileveredPipeMatrices::from_entries([zero; 64]);
        let mut derivatives = CantileveredPipeDerivatives {
            values: [zero; 55],
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
        matrices: &mut CantileveredPipeMatrices<T>,
        derivatives: &mut CantileveredPipeDerivatives<T>,
    ) {
        *matrices = CantileveredPipeMatrices::from_entries([self.l.like(0.0); 64]);
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
        put_derivative(0, self.l);
        put_derivative(1, self.l.like(4.0));
        put_derivative(2, self.l.like(7.568674603525367));
        put_derivative(3, self.l.like(1.5189220591449966));
        put_derivative(4, self.l.like(6.766752743711723));
        put_derivative(5, self.l.like(0.43132539647463314));
        put_derivative(6, self.l.like(4.4443729491027995));
        put_derivative(7, self.l.like(0.2396209592479588));
        put_derivative(8, self.l.like(1.2332472562882775));
        put_derivative(9, self.l.like(8.336799302190666));
        put_derivative(10, self.l.like(-9.518922059144996));
        put_derivative(11, self.l.like(-8.23962095924796));
        put_derivative(12, self.l.like(-12.4443729491028));
        put_derivative(13, self.l.like(-16.336799302190666));
        let M_11_l = self.m + self.f;
        put_derivative(14, M_11_l);
        let mass = self.l * M_11_l;
        put_entry(0, mass);
        let C1_11 = self.f * self.l.like(4.0);
        put_entry(1, C1_11);
        let C1_13 = self.f * self.l.like(7.568674603525367);
        put_entry(3, C1_13);
        let C1_21 = self.f * self.l.like(1.5189220591449966);
        put_entry(5, C1_21);
        let C1_24 = self.f * self.l.like(6.766752743711723);
        put_entry(7, C1_24);
        let C1_31 = self.f * self.l.like(0.43132539647463314);
        put_entry(8, C1_31);
        let C1_32 = self.f * self.l.like(4.4443729491027995);
        put_entry(9, C1_32);
        let C1_41 = self.f * self.l.like(0.2396209592479588);
        put_entry(11, C1_41);
        let C1_42 = self.f * self.l.like(1.2332472562882775);
        put_entry(12, C1_42);
        let C1_43 = self.f * self.l.like(8.336799302190666);
        put_entry(13, C1_43);
        let t54 = self.l * self.l;
        let t56 = self.l.like(1.0) / (self.l * t54);
        let t57 = self.l.like(1.0) / self.l;
        let t60 = self.EI * self.l.like(3.0) / (t54 * t54);
        let C1_12 = -(self.f * self.l.like(9.518922059144996));
        put_entry(2, C1_12);
        let flow = self.f * t57;
        let K2_11_f = t57 * self.l.like(0.8582436200114997);
        put_derivative(15, K2_11_f);
        let t65 = t57 * self.l.like(11.743238371184557);
        put_derivative(16, t65);
        let K2_13_f = t57 * self.l.like(27.45314869883141);
        put_derivative(17, K2_13_f);
        let t67 = t57 * self.l.like(37.39025026585289);
        put_derivative(18, t67);
        let K2_21_f = t57 * self.l.like(1.8738533309718404);
        put_derivative(19, K2_21_f);
        let t69 = t57 * self.l.like(13.294285387122413);
        put_derivative(20, t69);
        let t70 = t57 * self.l.like(9.04221974607116);
        put_derivative(21, t70);
        let K2_24_f = t57 * self.l.like(30.40116729418553);
        put_derivative(22, K2_24_f);
        let K2_11 = flow * self.l.like(0.8582436200114997);
        put_entry(18, K2_11);
        let K2_13 = flow * self.l.like(27.45314869883141);
        put_entry(20, K2_13);
        let K2_21 = flow * self.l.like(1.8738533309718404);
        put_entry(22, K2_21);
        let K2_24 = flow * self.l.like(30.40116729418553);
        put_entry(25, K2_24);
        let K2_31 = flow * self.l.like(1.564506451563535);
        put_entry(26, K2_31);
        let K2_32 = flow * self.l.like(3.229330799040317);
        put_entry(27, K2_32);
        let K2_41 = flow * self.l.like(1.087366479542848);
        put_entry(30, K2_41);
        let stiffness = self.EI * t56;
        let K2_42 = flow * self.l.like(5.540642250946188);
        put_entry(31, K2_42);
        let K2_43 = flow * self.l.like(4.253605462830704);
        put_entry(32, K2_43);
        let t82 = self.l.like(12.362363368326193) * t60;
        put_derivative(23, t82);
        let t83 = self.l.like(485.51881851337106) * t60;
        put_derivative(24, t83);
        let t84 = self.l.like(3806.546266391451) * t60;
        put_derivative(25, t84);
        let t85 = self.l.like(14617.27330511878) * t60;
        put_derivative(26, t85);
        let t86 = t57 * flow;
        let t87 = self.l.like(0.8582436200114997) * t86;
        put_derivative(27, t87);
        let K2_12_l = self.l.like(11.743238371184557) * t86;
        put_derivative(28, K2_12_l);
        let Kc_11 = stiffness * self.l.like(12.362363368326193);
        put_entry(14, Kc_11);
        let Kc_22 = stiffness * self.l.like(485.51881851337106);
        put_entry(15, Kc_22);
        let Kc_33 = stiffness * self.l.like(3806.546266391451);
        put_entry(16, Kc_33);
        let Kc_44 = stiffness * self.l.like(14617.27330511878);
        put_entry(17, Kc_44);
        let t93 = self.l.like(27.45314869883141) * t86;
        put_derivative(29, t93);
        let K2_14_l = self.l.like(37.39025026585289) * t86;
        put_derivative(30, K2_14_l);
        let t95 = self.l.like(1.8738533309718404) * t86;
        put_derivative(31, t95);
        let K2_22_l = self.l.like(13.294285387122413) * t86;
        put_derivative(32, K2_22_l);
        let K2_23_l = self.l.like(9.04221974607116) * t86;
        put_derivative(33, K2_23_l);
        let t98 = self.l.like(30.40116729418553) * t86;
        put_derivative(34, t98);
        let t99 = self.l.like(1.564506451563535) * t86;
        put_derivative(35, t99);
        let t100 = self.l.like(3.229330799040317) * t86;
        put_derivative(36, t100);
        let K2_33_l = self.l.like(45.90422661633816) * t86;
        put_derivative(37, K2_33_l);
        let K2_34_l = self.l.like(8.33536903529716) * t86;
        put_derivative(38, K2_34_l);
        let t103 = self.l.like(1.087366479542848) * t86;
        put_derivative(39, t103);
        let t104 = self.l.like(5.540642250946188) * t86;
        put_derivative(40, t104);
        let t105 = self.l.like(4.253605462830704) * t86;
        put_derivative(41, t105);
        let K2_44_l = self.l.like(98.91821015122052) * t86;
        put_derivative(42, K2_44_l);
        let Kc_11_EI = t56 * self.l.like(12.362363368326193);
        put_derivative(43, Kc_11_EI);
        let Kc_22_EI = t56 * self.l.like(485.51881851337106);
        put_derivative(44, Kc_22_EI);
        let Kc_33_EI = t56 * self.l.like(3806.546266391451);
        put_derivative(45, Kc_33_EI);
        let Kc_44_EI = t56 * self.l.like(14617.27330511878);
        put_derivative(46, Kc_44_EI);
        let K2_31_f = t57 * self.l.like(1.564506451563535);
        put_derivative(47, K2_31_f);
        let K2_32_f = t57 * self.l.like(3.229330799040317);
        put_derivative(48, K2_32_f);
        let t113 = t57 * self.l.like(45.90422661633816);
        put_derivative(49, t113);
        let t114 = t57 * self.l.like(8.33536903529716);
        put_derivative(50, t114);
        let K2_41_f = t57 * self.l.like(1.087366479542848);
        put_derivative(51, K2_41_f);
        let K2_42_f = t57 * self.l.like(5.540642250946188);
        put_derivative(52, K2_42_f);
        let K2_43_f = t57 * self.l.like(4.253605462830704);
        put_derivative(53, K2_43_f);
        let t118 = t57 * self.l.like(98.91821015122052);
        put_derivative(54, t118);
        let C1_14 = -(self.f * self.l.like(8.23962095924796));
        put_entry(4, C1_14);
        let C1_23 = -(self.f * self.l.like(12.4443729491028));
        put_entry(6, C1_23);
        let C1_34 = -(self.f * self.l.like(16.336799302190666));
        put_entry(10, C1_34);
        let K2_12 = -(flow * self.l.like(11.743238371184557));
        put_entry(19, K2_12);
        let K2_14 = -(flow * self.l.like(37.39025026585289));
        put_entry(21, K2_14);
        let K2_22 = -(flow * self.l.like(13.294285387122413));
        put_entry(23, K2_22);
        let K2_23 = -(flow * self.l.like(9.04221974607116));
        put_entry(24, K2_23);
        let K2_33 = -(flow * self.l.like(45.90422661633816));
        put_entry(28, K2_33);
        let K2_34 = -(flow * self.l.like(8.33536903529716));
        put_entry(29, K2_34);
        let K2_44 = -(flow * self.l.like(98.91821015122052));
        put_entry(33, K2_44);
    }
}

// --- Parameter sets ------------------------------------------------------------------------------

impl CantileveredPipe<f64> {
    /// The parameter set `beta_02`.
    ///
    /// Source: beta = 0.2, with v = u
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `l` | 1 | `m` |
    /// | `EI` | 1 | `N*m^2` |
    /// | `m` | 4 | `kg/m` |
    /// | `f` | 1 | `kg/m` |
    pub const BETA_02: Self = Self {
        l: 1.0, EI: 1.0, m: 4.0, f: 1.0,
    };

    /// The parameter set `beta_05`.
    ///
    /// Source: beta = 0.5, with v = u
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `l` | 1 | `m` |
    /// | `EI` | 1 | `N*m^2` |
    /// | `m` | 1 | `kg/m` |
    /// | `f` | 1 | `kg/m` |
    pub const BETA_05: Self = Self {
        l: 1.0, EI: 1.0, m: 1.0, f: 1.0,
    };

    /// The parameter set `beta_07`.
    ///
    /// Source: beta = 0.7, with v = u: four modes lose their stability, regain and lose it
    ///
    /// | parameter | value | unit |
    /// | --- | ---: | --- |
    /// | `l` | 1 | `m` |
    /// | `EI` | 1 | `N*m^2` |
    /// | `m` | 0.42857142857142855 | `kg/m` |
    /// | `f` | 1 | `kg/m` |
    pub const BETA_07: Self = Self {
        l: 1.0, EI: 1.0, m: 0.42857142857142855, f: 1.0,
    };
}

// --- Parameters and matrices as arrays -----------------------------------------------------------

impl<T: Number> CantileveredPipe<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 4]) -> Self {
        Self {
            l: values[0], EI: values[1], m: values[2], f: values[3],
        }
    }

    /// The parameters as an array in declared order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(&self) -> [T; 4] {
        [self.l, self.EI, self.m, self.f]
    }
}

impl<T: Scalar> CantileveredPipe<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: Scalar>(&self) -> CantileveredPipe<U> {
        let values = self.to_array();
        CantileveredPipe::from_array(values.map(|value| Scalar::from_f64(Scalar::to_f64(value))))
    }
}

impl CantileveredPipe<f64> {
    /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
    #[must_use]
    pub const fn to_f32(&self) -> CantileveredPipe<f32> {
        CantileveredPipe::from_array(carvallo::to_f32(self.to_array()))
    }
}

/// The same parameters, exactly.
impl From<CantileveredPipe<f32>> for CantileveredPipe<f64> {
    fn from(parameters: CantileveredPipe<f32>) -> Self {
        CantileveredPipe::cast(&parameters)
    }
}

impl<T: Number> CantileveredPipeMatrices<T> {
    /// From the entries of one matrix after the other, each row by row.
    #[inline(always)]
    fn from_entries(entries: [T; 64]) -> Self {
        Self {
            m: carvallo::rows(&entries, 0),
            c1: carvallo::rows(&entries, 16),
            kc: carvallo::rows(&entries, 32),
            k2: carvallo::rows(&entries, 48),
        }
    }

    /// Those entries that differ and are not always zero.
    #[inline(always)]
    fn distinct_entries(&self) -> [T; 34] {
        [
            self.m[0][0], self.c1[0][0], self.c1[0][1], self.c1[0][2], self.c1[0][3], self.c1[1][0],
            self.c1[1][2], self.c1[1][3], self.c1[2][0], self.c1[2][1], self.c1[2][3],
            self.c1[3][0], self.c1[3][1], self.c1[3][2], self.kc[0][0], self.kc[1][1],
            self.kc[2][2], self.kc[3][3], self.k2[0][0], self.k2[0][1], self.k2[0][2],
            self.k2[0][3], self.k2[1][0], self.k2[1][1], self.k2[1][2], self.k2[1][3],
            self.k2[2][0], self.k2[2][1], self.k2[2][2], self.k2[2][3], self.k2[3][0],
            self.k2[3][1], self.k2[3][2], self.k2[3][3],
        ]
    }

    /// Sets the entry at a position among those that differ, wherever it stands.
    #[inline(always)]
    fn set_entry(&mut self, position: usize, entry: T) {
        match position {
            0 => {
                self.m[0][0] = entry;
                self.m[1][1] = entry;
                self.m[2][2] = entry;
                self.m[3][3] = entry;
            }
            1 => {
                self.c1[0][0] = entry;
                self.c1[1][1] = entry;
                self.c1[2][2] = entry;
                self.c1[3][3] = entry;
            }
            2 => {
                self.c1[0][1] = entry;
            }
            3 => {
                self.c1[0][2] = entry;
            }
            4 => {
                self.c1[0][3] = entry;
            }
            5 => {
                self.c1[1][0] = entry;
            }
            6 => {
                self.c1[1][2] = entry;
            }
            7 => {
                self.c1[1][3] = entry;
            }
            8 => {
                self.c1[2][0] = entry;
            }
            9 => {
                self.c1[2][1] = entry;
            }
            10 => {
                self.c1[2][3] = entry;
            }
            11 => {
                self.c1[3][0] = entry;
            }
            12 => {
                self.c1[3][1] = entry;
            }
            13 => {
                self.c1[3][2] = entry;
            }
            14 => {
                self.kc[0][0] = entry;
            }
            15 => {
                self.kc[1][1] = entry;
            }
            16 => {
                self.kc[2][2] = entry;
            }
            17 => {
                self.kc[3][3] = entry;
            }
            18 => {
                self.k2[0][0] = entry;
            }
            19 => {
                self.k2[0][1] = entry;
            }
            20 => {
                self.k2[0][2] = entry;
            }
            21 => {
                self.k2[0][3] = entry;
            }
            22 => {
                self.k2[1][0] = entry;
            }
            23 => {
                self.k2[1][1] = entry;
            }
            24 => {
                self.k2[1][2] = entry;
            }
            25 => {
                self.k2[1][3] = entry;
            }
            26 => {
                self.k2[2][0] = entry;
            }
            27 => {
                self.k2[2][1] = entry;
            }
            28 => {
                self.k2[2][2] = entry;
            }
            29 => {
                self.k2[2][3] = entry;
            }
            30 => {
                self.k2[3][0] = entry;
            }
            31 => {
                self.k2[3][1] = entry;
            }
            32 => {
                self.k2[3][2] = entry;
            }
            33 => {
                self.k2[3][3] = entry;
            }
            _ => {}
        }
    }

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    #[inline(always)]
    fn rows(&self) -> [[[T; 4]; 4]; 8] {
        let zeros = [[self.m.0[0][0].like(0.0); 4]; 4];
        [self.m.0, zeros, zeros, self.c1.0, self.kc.0, zeros, zeros, self.k2.0]
    }
}

impl<T: Scalar> From<CantileveredPipeMatrices<T>> for Coefficients<T, 4> {
    fn from(matrices: CantileveredPipeMatrices<T>) -> Self {
        Coefficients::from_rows(matrices.rows())
    }
}

// --- What the runtime knows of the model ---------------------------------------------------------

impl<T: Scalar> Model<4> for CantileveredPipe<T> {
    type Scalar = T;

    type Array<U: Copy> = [U; 4];

    type Over<U: Number> = CantileveredPipe<U>;

    const INFO: &'static ModelInfo = &ModelInfo {
        name: "CantileveredPipe",
        docs: "A cantilevered pipe that carries a fluid, in its first four modes: it flutters above a critical speed.\n\nA slender elastic pipe, clamped where the fluid enters and free where it leaves, in a horizontal plane and without\ndamping of its own. The deflection is a sum of the first four modes of the clamped beam (Galerkin), each with a\nmean square of one over the length, so that its end is deflected by twice its coordinate. The speed v is that of the\nfluid; textbooks have it as u = v l sqrt(f/EI), and the part of the fluid in the mass as beta = f/(m + f).",
        source: "Gregory & Paidoussis (1966), Unstable oscillation of tubular cantilevers conveying fluid, Proc. R. Soc. A 293, 512-527; integrals of the modes: Paidoussis, Fluid-Structure Interactions, vol. 1",
        parameters: &[
            ParameterInfo::new("l", "m", Domain::POSITIVE).docs("Length."),
            ParameterInfo::new("EI", "N*m^2", Domain::POSITIVE)
                .docs("Flexural rigidity."),
            ParameterInfo::new("m", "kg/m", Domain::POSITIVE)
                .docs("Mass of the pipe for each metre."),
            ParameterInfo::new("f", "kg/m", Domain::NONNEGATIVE)
                .docs("Mass of the fluid in it for each metre."),
        ],
        coordinates: &[
            CoordinateInfo::new("first", "m").docs("Deflection in the first mode."),
            CoordinateInfo::new("second", "m").docs("Deflection in the second mode."),
            CoordinateInfo::new("third", "m").docs("Deflection in the third mode."),
            CoordinateInfo::new("fourth", "m").docs("Deflection in the fourth mode."),
        ],
        forces: &[],
        matrices: &[MatrixName::M, MatrixName::C1, MatrixName::Kc, MatrixName::K2],
        entries: &[
            EntryInfo::at(
                &[
                    (MatrixName::M, 0, 0), (MatrixName::M, 1, 1), (MatrixName::M, 2, 2),
                    (MatrixName::M, 3, 3),
                ],
            ),
            EntryInfo::at(
                &[
                    (MatrixName::C1, 0, 0), (MatrixName::C1, 1, 1), (MatrixName::C1, 2, 2),
                    (MatrixName::C1, 3, 3),
                ],
            ),
            EntryInfo::at(&[(MatrixName::C1, 0, 1)]), EntryInfo::at(&[(MatrixName::C1, 0, 2)]),
            EntryInfo::at(&[(MatrixName::C1, 0, 3)]), EntryInfo::at(&[(MatrixName::C1, 1, 0)]),
            EntryInfo::at(&[(MatrixName::C1, 1, 2)]), EntryInfo::at(&[(MatrixName::C1, 1, 3)]),
            EntryInfo::at(&[(MatrixName::C1, 2, 0)]), EntryInfo::at(&[(MatrixName::C1, 2, 1)]),
            EntryInfo::at(&[(MatrixName::C1, 2, 3)]), EntryInfo::at(&[(MatrixName::C1, 3, 0)]),
            EntryInfo::at(&[(MatrixName::C1, 3, 1)]), EntryInfo::at(&[(MatrixName::C1, 3, 2)]),
            EntryInfo::at(&[(MatrixName::Kc, 0, 0)]), EntryInfo::at(&[(MatrixName::Kc, 1, 1)]),
            EntryInfo::at(&[(MatrixName::Kc, 2, 2)]), EntryInfo::at(&[(MatrixName::Kc, 3, 3)]),
            EntryInfo::at(&[(MatrixName::K2, 0, 0)]), EntryInfo::at(&[(MatrixName::K2, 0, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 0, 2)]), EntryInfo::at(&[(MatrixName::K2, 0, 3)]),
            EntryInfo::at(&[(MatrixName::K2, 1, 0)]), EntryInfo::at(&[(MatrixName::K2, 1, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 1, 2)]), EntryInfo::at(&[(MatrixName::K2, 1, 3)]),
            EntryInfo::at(&[(MatrixName::K2, 2, 0)]), EntryInfo::at(&[(MatrixName::K2, 2, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 2, 2)]), EntryInfo::at(&[(MatrixName::K2, 2, 3)]),
            EntryInfo::at(&[(MatrixName::K2, 3, 0)]), EntryInfo::at(&[(MatrixName::K2, 3, 1)]),
            EntryInfo::at(&[(MatrixName::K2, 3, 2)]), EntryInfo::at(&[(MatrixName::K2, 3, 3)]),
        ],
        sets: &[
            SetInfo {
                name: "beta_02",
                docs: "",
                source: "beta = 0.2, with v = u",
                values: &CantileveredPipe::to_array(&CantileveredPipe::<f64>::BETA_02),
            },
            SetInfo {
                name: "beta_05",
                docs: "",
                source: "beta = 0.5, with v = u",
                values: &CantileveredPipe::to_array(&CantileveredPipe::<f64>::BETA_05),
            },
            SetInfo {
                name: "beta_07",
                docs: "",
                source: "beta = 0.7, with v = u: four modes lose their stability, regain and lose it",
                values: &CantileveredPipe::to_array(&CantileveredPipe::<f64>::BETA_07),
            },
        ],
        requirements: &[],
        formulas: &[
            FormulaInfo::definition("mass", "kg", "(m + f)*l"),
            FormulaInfo::definition("stiffness", "kg/s^2", "EI/l^3"),
            FormulaInfo::definition("flow", "kg/m^2", "f/l"),
            FormulaInfo::definition("lam1", "1", "1.875104068711961166445308"),
            FormulaInfo::definition("lam2", "1", "4.694091132974174576436392"),
            FormulaInfo::definition("lam3", "1", "7.854757438237612564861009"),
            FormulaInfo::definition("lam4", "1", "10.99554073487546699066735"),
            FormulaInfo::definition("n1", "1", "0.7340955137589127558287828*lam1"),
            FormulaInfo::definition("n2", "1", "1.018467318759219405032741*lam2"),
            FormulaInfo::definition("n3", "1", "0.9992244965174282872163576*lam3"),
            FormulaInfo::definition("n4", "1", "1.000033553251713398399016*lam4"),
            FormulaInfo::entry(
                &[
                    (MatrixName::M, 0, 0), (MatrixName::M, 1, 1), (MatrixName::M, 2, 2),
                    (MatrixName::M, 3, 3),
                ],
                "kg",
                "mass",
            ),
            FormulaInfo::entry(
                &[
                    (MatrixName::C1, 0, 0), (MatrixName::C1, 1, 1), (MatrixName::C1, 2, 2),
                    (MatrixName::C1, 3, 3),
                ],
                "kg/m",
                "4*f",
            ),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 1)], "kg/m", "8*f/((lam1/lam2)^2 - 1)"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 2)], "kg/m", "8*f/((lam1/lam3)^2 + 1)"),
            FormulaInfo::entry(&[(MatrixName::C1, 0, 3)], "kg/m", "8*f/((lam1/lam4)^2 - 1)"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 0)], "kg/m", "8*f/((lam2/lam1)^2 - 1)"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 2)], "kg/m", "8*f/((lam2/lam3)^2 - 1)"),
            FormulaInfo::entry(&[(MatrixName::C1, 1, 3)], "kg/m", "8*f/((lam2/lam4)^2 + 1)"),
            FormulaInfo::entry(&[(MatrixName::C1, 2, 0)], "kg/m", "8*f/((lam3/lam1)^2 + 1)"),
            FormulaInfo::entry(&[(MatrixName::C1, 2, 1)], "kg/m", "8*f/((lam3/lam2)^2 - 1)"),
            FormulaInfo::entry(&[(MatrixName::C1, 2, 3)], "kg/m", "8*f/((lam3/lam4)^2 - 1)"),
            FormulaInfo::entry(&[(MatrixName::C1, 3, 0)], "kg/m", "8*f/((lam4/lam1)^2 - 1)"),
            FormulaInfo::entry(&[(MatrixName::C1, 3, 1)], "kg/m", "8*f/((lam4/lam2)^2 + 1)"),
            FormulaInfo::entry(&[(MatrixName::C1, 3, 2)], "kg/m", "8*f/((lam4/lam3)^2 - 1)"),
            FormulaInfo::entry(&[(MatrixName::Kc, 0, 0)], "kg/s^2", "stiffness*lam1^4"),
            FormulaInfo::entry(&[(MatrixName::Kc, 1, 1)], "kg/s^2", "stiffness*lam2^4"),
            FormulaInfo::entry(&[(MatrixName::Kc, 2, 2)], "kg/s^2", "stiffness*lam3^4"),
            FormulaInfo::entry(&[(MatrixName::Kc, 3, 3)], "kg/s^2", "stiffness*lam4^4"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 0)], "kg/m^2", "flow*n1*(2 - n1)"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 1)], "kg/m^2", "4*flow*(n2 - n1)/(-1 - (lam1/lam2)^2)"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 2)], "kg/m^2", "4*flow*(n3 - n1)/(1 - (lam1/lam3)^2)"),
            FormulaInfo::entry(&[(MatrixName::K2, 0, 3)], "kg/m^2", "4*flow*(n4 - n1)/(-1 - (lam1/lam4)^2)"),
            FormulaInfo::entry(&[(MatrixName::K2, 1, 0)], "kg/m^2", "4*flow*(n1 - n2)/(-1 - (lam2/lam1)^2)"),
            FormulaInfo::entry(&[(MatrixName::K2, 1, 1)], "kg/m^2", "flow*n2*(2 - n2)"),
            FormulaInfo::entry(&[(MatrixName::K2, 1, 2)], "kg/m^2", "4*flow*(n3 - n2)/(-1 - (lam2/lam3)^2)"),
            FormulaInfo::entry(&[(MatrixName::K2, 1, 3)], "kg/m^2", "4*flow*(n4 - n2)/(1 - (lam2/lam4)^2)"),
            FormulaInfo::entry(&[(MatrixName::K2, 2, 0)], "kg/m^2", "4*flow*(n1 - n3)/(1 - (lam3/lam1)^2)"),
            FormulaInfo::entry(&[(MatrixName::K2, 2, 1)], "kg/m^2", "4*flow*(n2 - n3)/(-1 - (lam3/lam2)^2)"),
            FormulaInfo::entry(&[(MatrixName::K2, 2, 2)], "kg/m^2", "flow*n3*(2 - n3)"),
            FormulaInfo::entry(&[(MatrixName::K2, 2, 3)], "kg/m^2", "4*flow*(n4 - n3)/(-1 - (lam3/lam4)^2)"),
            FormulaInfo::entry(&[(MatrixName::K2, 3, 0)], "kg/m^2", "4*flow*(n1 - n4)/(-1 - (lam4/lam1)^2)"),
            FormulaInfo::entry(&[(MatrixName::K2, 3, 1)], "kg/m^2", "4*flow*(n2 - n4)/(1 - (lam4/lam2)^2)"),
            FormulaInfo::entry(&[(MatrixName::K2, 3, 2)], "kg/m^2", "4*flow*(n3 - n4)/(-1 - (lam4/lam3)^2)"),
            FormulaInfo::entry(&[(MatrixName::K2, 3, 3)], "kg/m^2", "flow*n4*(2 - n4)"),
        ],
        attributes: &[],
        motion: None,
        gravity: None,
    };

    fn from_slice(values: &[T]) -> Result<Self, LengthError> {
        LengthError::check("CantileveredPipe", 4, values)?;
        Ok(<Self as Evaluator<T, 4>>::from_parameters(|position| values[position]))
    }

    fn write_to(&self, values: &mut [T]) -> Result<(), LengthError> {
        LengthError::check("CantileveredPipe", 4, values)?;
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
        let info = const { &<Self as Model<4>>::INFO.without_formulas() };
        info.validate(&self.to_array().map(Scalar::to_f64))?;
        Ok(())
    }

    #[inline]
    fn coefficients(&self) -> Coefficients<T, 4> {
        Coefficients::from_rows(CantileveredPipeMatrices::rows(&self.matrices()))
    }

    fn derivatives(&self) -> Option<WithDerivatives<Self, 4>> {
        Some(Differentiable::coefficients_and_derivatives(self))
    }

    fn gravity(&self) -> Option<T> {
        None
    }
}

impl CantileveredPipe<f64> {
    /// What the model tells about itself, the same for every number type.
    pub const INFO: &'static ModelInfo = <Self as Model<4>>::INFO;

    /// The parameter set of this name, however it is spelt: upper and lower case, `_`, `-` and spaces make no
    /// difference. In `f32` it is had by the trait `Model`.
    #[must_use]
    pub fn set(name: &str) -> Option<Self> {
        <Self as Model<4>>::set(name)
    }
}

/// The parameters, one a line with its unit, in the precision that is asked for; `{:#}` says what they are.
impl<T: Scalar> core::fmt::Display for CantileveredPipe<T> {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> Result<(), core::fmt::Error> {
        let info = const { &<Self as Model<4>>::INFO.without_formulas() };
        info.write_parameters(&self.to_array(), formatter)
    }
}

impl<T: Number> Evaluator<T, 4> for CantileveredPipe<T> {
    type Entries = [T; 34];

    #[inline(always)]
    fn from_parameters(mut parameter: impl FnMut(usize) -> T) -> Self {
        Self {
            l: parameter(0), EI: parameter(1), m: parameter(2), f: parameter(3),
        }
    }

    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        CantileveredPipeMatrices::distinct_entries(&self.matrices())
    }

    #[inline(always)]
    fn rows(&self) -> [[[T; 4]; 4]; 8] {
        CantileveredPipeMatrices::rows(&self.matrices())
    }
}

// --- Which derivatives there are -----------------------------------------------------------------

impl<T: Scalar> CantileveredPipeDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(&self, parameter: usize) -> Option<CantileveredPipeMatrices<T>> {
        if parameter >= 4 {
            return None;
        }
        let zero = <T as Scalar>::from_f64(0.0);
        let mut matrices = CantileveredPipeMatrices {
            m: Rows([[zero; 4]; 4]), c1: Rows([[zero; 4]; 4]), kc: Rows([[zero; 4]; 4]),
            k2: Rows([[zero; 4]; 4]),
        };
        for position in 0..68 {
            let partial = <CantileveredPipeDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                MatrixName::M => &mut matrices.m,
                MatrixName::C1 => &mut matrices.c1,
                MatrixName::Kc => &mut matrices.kc,
                MatrixName::K2 => &mut matrices.k2,
                _ => continue,
            };
            matrix[partial.row][partial.column] = Partial::of(&partial, &self.values);
        }
        Some(matrices)
    }
}

impl<T: Scalar> Differentiable<4> for CantileveredPipe<T> {
    type Derivatives = [Coefficients<T, 4>; 4];

    type WithDerivativesOver<U: Number> = CantileveredPipe<U>;

    const PARTIALS: &'static [Partial] = <CantileveredPipeDerivatives>::PARTIALS;

    fn coefficients_and_derivatives(&self) -> (Coefficients<T, 4>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let zero = <T as Scalar>::from_f64(0.0);
        let mut all = [Coefficients::from_rows([[[zero; 4]; 4]; 8]); 4];
        for position in 0..68 {
            Partial::write(&<CantileveredPipeDerivatives>::PARTIALS[position], &derivatives.values, &mut all);
        }
        (Coefficients::from_rows(CantileveredPipeMatrices::rows(&matrices)), all)
    }
}

impl<T: Number> EvaluatorWithDerivatives<T, 4> for CantileveredPipe<T> {
    #[inline(always)]
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T)) {
        self.each_result(put_entry, put_derivative);
    }
}

impl CantileveredPipeDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [Partial; 68] = &[
        Partial::new(MatrixName::M, 0, 0, 0, 14), Partial::new(MatrixName::M, 1, 1, 0, 14),
        Partial::new(MatrixName::M, 2, 2, 0, 14), Partial::new(MatrixName::M, 3, 3, 0, 14),
        Partial::new(MatrixName::Kc, 0, 0, 0, 23).negative(),
        Partial::new(MatrixName::Kc, 1, 1, 0, 24).negative(),
        Partial::new(MatrixName::Kc, 2, 2, 0, 25).negative(),
        Partial::new(MatrixName::Kc, 3, 3, 0, 26).negative(),
        Partial::new(MatrixName::K2, 0, 0, 0, 27).negative(),
        Partial::new(MatrixName::K2, 0, 1, 0, 28),
        Partial::new(MatrixName::K2, 0, 2, 0, 29).negative(),
        Partial::new(MatrixName::K2, 0, 3, 0, 30),
        Partial::new(MatrixName::K2, 1, 0, 0, 31).negative(),
        Partial::new(MatrixName::K2, 1, 1, 0, 32),
        Partial::new(MatrixName::K2, 1, 2, 0, 33),
        Partial::new(MatrixName::K2, 1, 3, 0, 34).negative(),
        Partial::new(MatrixName::K2, 2, 0, 0, 35).negative(),
        Partial::new(MatrixName::K2, 2, 1, 0, 36).negative(),
        Partial::new(MatrixName::K2, 2, 2, 0, 37),
        Partial::new(MatrixName::K2, 2, 3, 0, 38),
        Partial::new(MatrixName::K2, 3, 0, 0, 39).negative(),
        Partial::new(MatrixName::K2, 3, 1, 0, 40).negative(),
        Partial::new(MatrixName::K2, 3, 2, 0, 41).negative(),
        Partial::new(MatrixName::K2, 3, 3, 0, 42), Partial::new(MatrixName::Kc, 0, 0, 1, 43),
        Partial::new(MatrixName::Kc, 1, 1, 1, 44), Partial::new(MatrixName::Kc, 2, 2, 1, 45),
        Partial::new(MatrixName::Kc, 3, 3, 1, 46), Partial::new(MatrixName::M, 0, 0, 2, 0),
        Partial::new(MatrixName::M, 1, 1, 2, 0), Partial::new(MatrixName::M, 2, 2, 2, 0),
        Partial::new(MatrixName::M, 3, 3, 2, 0), Partial::new(MatrixName::M, 0, 0, 3, 0),
        Partial::new(MatrixName::M, 1, 1, 3, 0), Partial::new(MatrixName::M, 2, 2, 3, 0),
        Partial::new(MatrixName::M, 3, 3, 3, 0), Partial::new(MatrixName::C1, 0, 0, 3, 1),
        Partial::new(MatrixName::C1, 0, 1, 3, 10), Partial::new(MatrixName::C1, 0, 2, 3, 2),
        Partial::new(MatrixName::C1, 0, 3, 3, 11), Partial::new(MatrixName::C1, 1, 0, 3, 3),
        Partial::new(MatrixName::C1, 1, 1, 3, 1), Partial::new(MatrixName::C1, 1, 2, 3, 12),
        Partial::new(MatrixName::C1, 1, 3, 3, 4), Partial::new(MatrixName::C1, 2, 0, 3, 5),
        Partial::new(MatrixName::C1, 2, 1, 3, 6), Partial::new(MatrixName::C1, 2, 2, 3, 1),
        Partial::new(MatrixName::C1, 2, 3, 3, 13), Partial::new(MatrixName::C1, 3, 0, 3, 7),
        Partial::new(MatrixName::C1, 3, 1, 3, 8), Partial::new(MatrixName::C1, 3, 2, 3, 9),
        Partial::new(MatrixName::C1, 3, 3, 3, 1), Partial::new(MatrixName::K2, 0, 0, 3, 15),
        Partial::new(MatrixName::K2, 0, 1, 3, 16).negative(),
        Partial::new(MatrixName::K2, 0, 2, 3, 17),
        Partial::new(MatrixName::K2, 0, 3, 3, 18).negative(),
        Partial::new(MatrixName::K2, 1, 0, 3, 19),
        Partial::new(MatrixName::K2, 1, 1, 3, 20).negative(),
        Partial::new(MatrixName::K2, 1, 2, 3, 21).negative(),
        Partial::new(MatrixName::K2, 1, 3, 3, 22),
        Partial::new(MatrixName::K2, 2, 0, 3, 47),
        Partial::new(MatrixName::K2, 2, 1, 3, 48),
        Partial::new(MatrixName::K2, 2, 2, 3, 49).negative(),
        Partial::new(MatrixName::K2, 2, 3, 3, 50).negative(),
        Partial::new(MatrixName::K2, 3, 0, 3, 51),
        Partial::new(MatrixName::K2, 3, 1, 3, 52),
        Partial::new(MatrixName::K2, 3, 2, 3, 53),
        Partial::new(MatrixName::K2, 3, 3, 3, 54).negative(),
    ];
}
