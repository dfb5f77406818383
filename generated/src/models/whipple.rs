// @generated from generated/models/whipple.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 3e007e0439a8d63f

/// The Whipple-Carvallo bicycle: the linearized equations of lean and steer about upright straight running.
///
/// Four rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally
/// symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,
/// x forward, y to the right, z down, so that a centre of mass above the ground has z < 0.
///
/// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, Appendix A
///
/// The fields are the parameters. The coordinates are `phi` (lean) in rad, `delta` (steer) in rad.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Whipple<T = ::core::primitive::f64> {
    /// Wheel base.
    ///
    /// `w` in m: > 0.
    pub w: T,
    /// Trail: positive when the front contact is behind the point where the steer axis meets the ground.
    ///
    /// `c` in m: any finite value.
    pub c: T,
    /// Steer axis tilt: 90 degrees minus the head angle.
    ///
    /// `lam`, λ, in rad: > -1.5707963267948966 and < 1.5707963267948966.
    pub lam: T,
    /// Gravitational field strength.
    ///
    /// `g` in N/kg: >= 0.
    pub g: T,
    /// Radius of the rear wheel.
    ///
    /// `rR` in m: > 0.
    pub rR: T,
    /// Mass of the rear wheel.
    ///
    /// `mR` in kg: >= 0.
    pub mR: T,
    /// Radial moment of inertia of the rear wheel; by symmetry also about the vertical.
    ///
    /// `IRxx` in kg*m^2: >= 0.
    pub IRxx: T,
    /// Axial moment of inertia of the rear wheel.
    ///
    /// `IRyy` in kg*m^2: >= 0.
    pub IRyy: T,
    /// Centre of mass of the rear frame and rider, forward of the rear contact.
    ///
    /// `xB` in m: any finite value.
    pub xB: T,
    /// Centre of mass of the rear frame and rider, downward.
    ///
    /// `zB` in m: any finite value.
    pub zB: T,
    /// Mass of the rear frame and rider.
    ///
    /// `mB` in kg: >= 0.
    pub mB: T,
    /// Moment of inertia of the rear frame and rider about its centre of mass, in roll.
    ///
    /// `IBxx` in kg*m^2: >= 0.
    pub IBxx: T,
    /// Moment of inertia of the rear frame and rider about its centre of mass, in pitch.
    ///
    /// `IByy` in kg*m^2: >= 0. No matrix depends on it.
    pub IByy: T,
    /// Moment of inertia of the rear frame and rider about its centre of mass, in yaw.
    ///
    /// `IBzz` in kg*m^2: >= 0.
    pub IBzz: T,
    /// Product of inertia of the rear frame and rider about its centre of mass.
    ///
    /// `IBxz` in kg*m^2: any finite value.
    pub IBxz: T,
    /// Centre of mass of the front frame, forward of the rear contact.
    ///
    /// `xH` in m: any finite value.
    pub xH: T,
    /// Centre of mass of the front frame, downward.
    ///
    /// `zH` in m: any finite value.
    pub zH: T,
    /// Mass of the front frame.
    ///
    /// `mH` in kg: >= 0.
    pub mH: T,
    /// Moment of inertia of the front frame about its centre of mass, in roll.
    ///
    /// `IHxx` in kg*m^2: >= 0.
    pub IHxx: T,
    /// Moment of inertia of the front frame about its centre of mass, in pitch.
    ///
    /// `IHyy` in kg*m^2: >= 0. No matrix depends on it.
    pub IHyy: T,
    /// Moment of inertia of the front frame about its centre of mass, in yaw.
    ///
    /// `IHzz` in kg*m^2: >= 0.
    pub IHzz: T,
    /// Product of inertia of the front frame about its centre of mass.
    ///
    /// `IHxz` in kg*m^2: any finite value.
    pub IHxz: T,
    /// Radius of the front wheel.
    ///
    /// `rF` in m: > 0.
    pub rF: T,
    /// Mass of the front wheel.
    ///
    /// `mF` in kg: >= 0.
    pub mF: T,
    /// Radial moment of inertia of the front wheel; by symmetry also about the vertical.
    ///
    /// `IFxx` in kg*m^2: >= 0.
    pub IFxx: T,
    /// Axial moment of inertia of the front wheel.
    ///
    /// `IFyy` in kg*m^2: >= 0.
    pub IFyy: T,
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl Whipple<::core::primitive::f64> {
    /// The parameter set `benchmark`.
    ///
    /// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1
    pub const BENCHMARK: Self = Self {
        w: 1.02,
        c: 0.08,
        lam: 0.3141592653589793,
        g: 9.81,
        rR: 0.3,
        mR: 2.0,
        IRxx: 0.0603,
        IRyy: 0.12,
        xB: 0.3,
        zB: -0.9,
        mB: 85.0,
        IBxx: 9.2,
        IByy: 11.0,
        IBzz: 2.8,
        IBxz: 2.4,
        xH: 0.9,
        zH: -0.7,
        mH: 4.0,
        IHxx: 0.05892,
        IHyy: 0.06,
        IHzz: 0.00708,
        IHxz: -0.00756,
        rF: 0.35,
        mF: 3.0,
        IFxx: 0.1405,
        IFyy: 0.28,
    };
    /// The parameter set `benchmark_2005`.
    ///
    /// Source: Schwab, Meijaard & Papadopoulos (2005), ENOC 2005
    pub const BENCHMARK_2005: Self = Self {
        w: 1.02,
        c: 0.08,
        lam: 0.3217505543966422,
        g: 9.81,
        rR: 0.3,
        mR: 2.0,
        IRxx: 0.06,
        IRyy: 0.12,
        xB: 0.3,
        zB: -0.9,
        mB: 85.0,
        IBxx: 9.2,
        IByy: 11.0,
        IBzz: 2.8,
        IBxz: 2.4,
        xH: 0.9,
        zH: -0.7,
        mH: 4.0,
        IHxx: 0.0546,
        IHyy: 0.06,
        IHzz: 0.0114,
        IHxz: -0.0162,
        rF: 0.35,
        mF: 3.0,
        IFxx: 0.14,
        IFyy: 0.28,
    };
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> Whipple<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 26]) -> Self {
        Self {
            w: values[0],
            c: values[1],
            lam: values[2],
            g: values[3],
            rR: values[4],
            mR: values[5],
            IRxx: values[6],
            IRyy: values[7],
            xB: values[8],
            zB: values[9],
            mB: values[10],
            IBxx: values[11],
            IByy: values[12],
            IBzz: values[13],
            IBxz: values[14],
            xH: values[15],
            zH: values[16],
            mH: values[17],
            IHxx: values[18],
            IHyy: values[19],
            IHzz: values[20],
            IHxz: values[21],
            rF: values[22],
            mF: values[23],
            IFxx: values[24],
            IFyy: values[25],
        }
    }
    /// The parameters as an array in declared order.
    #[must_use]
    pub const fn to_array(&self) -> [T; 26] {
        [
            self.w,
            self.c,
            self.lam,
            self.g,
            self.rR,
            self.mR,
            self.IRxx,
            self.IRyy,
            self.xB,
            self.zB,
            self.mB,
            self.IBxx,
            self.IByy,
            self.IBzz,
            self.IBxz,
            self.xH,
            self.zH,
            self.mH,
            self.IHxx,
            self.IHyy,
            self.IHzz,
            self.IHxz,
            self.rF,
            self.mF,
            self.IFxx,
            self.IFyy,
        ]
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> Whipple<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: ::carvallo::Scalar>(&self) -> Whipple<U> {
        Whipple {
            w: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.w)),
            c: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.c)),
            lam: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.lam)),
            g: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.g)),
            rR: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.rR)),
            mR: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.mR)),
            IRxx: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IRxx)),
            IRyy: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IRyy)),
            xB: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.xB)),
            zB: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.zB)),
            mB: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.mB)),
            IBxx: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IBxx)),
            IByy: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IByy)),
            IBzz: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IBzz)),
            IBxz: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IBxz)),
            xH: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.xH)),
            zH: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.zH)),
            mH: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.mH)),
            IHxx: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IHxx)),
            IHyy: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IHyy)),
            IHzz: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IHzz)),
            IHxz: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IHxz)),
            rF: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.rF)),
            mF: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.mF)),
            IFxx: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IFxx)),
            IFyy: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.IFyy)),
        }
    }
}
/// The coefficient matrices of [`Whipple`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleMatrices<T = ::core::primitive::f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: [[T; 2]; 2],
    /// Damping C1, a coefficient of v q'.
    pub c1: [[T; 2]; 2],
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: [[T; 2]; 2],
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: [[T; 2]; 2],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> Whipple<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 54 additions, 71 multiplications, 4 divisions, 3 negations and 2 trigonometric functions: 134 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleMatrices<T> {
        let t5 = self.IHxx + self.IFxx;
        let t26 = (((((self.IRxx + self.IBxx) + t5) + (self.mR * (self.rR * self.rR)))
            + (self.mB * (self.zB * self.zB))) + (self.mH * (self.zH * self.zH)))
            + (self.mF * (self.rF * self.rF));
        let mA = self.mH + self.mF;
        let t28 = ::carvallo::Number::like(self.w, 1.0) / mA;
        let t30 = self.rF * self.mF;
        let t31 = (self.zH * self.mH) - t30;
        let zA = t28 * t31;
        let (t34, t45) = ::carvallo::Number::sin_cos(self.lam);
        let t40 = (self.xH * self.mH) + (self.w * self.mF);
        let xA = t40 * t28;
        let t42 = xA - self.w;
        let uA = ((t42 - self.c) * t45) - (zA * t34);
        let t48 = mA * uA;
        let t51 = self.zH - zA;
        let t53 = self.xH - xA;
        let t56 = self.rF + zA;
        let IAxz = (self.IHxz - ((self.mH * t51) * t53)) - ((self.mF * t56) * t42);
        let t60 = IAxz * t45;
        let IAxx = ((self.mH * (t51 * t51)) + (self.mF * (t56 * t56))) + t5;
        let t68 = IAxx * t34;
        let IAlx = (t60 - (zA * t48)) + t68;
        let t73 = self.zB * self.mB;
        let ITxz = (((self.IBxz + self.IHxz) - (self.xB * t73))
            - ((self.xH * self.zH) * self.mH)) + (self.w * t30);
        let t81 = t45 / self.w;
        let mu = self.c * t81;
        let t84 = IAlx + (ITxz * mu);
        let t88 = self.IHzz + self.IFxx;
        let IAzz = (t88 + (self.mH * (t53 * t53))) + (self.mF * (t42 * t42));
        let IAlz = ((xA * t48) + (IAxz * t34)) + (IAzz * t45);
        let ITzz = ((((self.IRxx + self.IBzz) + (self.mB * (self.xB * self.xB)))
            + (self.mH * (self.xH * self.xH))) + (self.mF * (self.w * self.w))) + t88;
        let t124 = (((mA * (uA * uA)) + (IAzz * (t45 * t45)))
            + (mu * ((IAlz * ::carvallo::Number::like(self.w, 2.0)) + (ITzz * mu))))
            + (t34 * (t68 + (::carvallo::Number::like(self.w, 2.0) * t60)));
        let SF = self.IFyy / self.rF;
        let ST = SF + (self.IRyy / self.rR);
        let t134 = (t73 + t31) - (self.rR * self.mR);
        let t135 = ST - t134;
        let t138 = SF * t45;
        let t139 = ((ITxz * t81) + (mu * t135)) + t138;
        let SA = t48 + (mu * (t40 + (self.xB * self.mB)));
        let t150 = (IAlz * t81) + (mu * (SA + (ITzz * t81)));
        let t152 = t81 * t135;
        let t155 = t81 * (SA + (SF * t34));
        let t156 = -(t138 + (mu * ST));
        let t157 = -SA;
        let t158 = -(t34 * SA);
        WhippleMatrices {
            m: [[t26, t84], [t84, t124]],
            c1: [[::carvallo::Number::like(self.w, 0.0), t139], [t156, t150]],
            k0: [[t134, t157], [t157, t158]],
            k2: [
                [::carvallo::Number::like(self.w, 0.0), t152],
                [::carvallo::Number::like(self.w, 0.0), t155],
            ],
        }
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Model<2> for Whipple<T> {
    type Scalar = T;
    type Parameters = [T; 26];
    type Over<U: ::carvallo::Number> = Whipple<U>;
    const INFO: &'static ::carvallo::ModelInfo = &::carvallo::ModelInfo {
        name: "Whipple",
        docs: "The Whipple-Carvallo bicycle: the linearized equations of lean and steer about upright straight running.\n\nFour rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally\nsymmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,\nx forward, y to the right, z down, so that a centre of mass above the ground has z < 0.",
        source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, Appendix A",
        parameters: &[
            ::carvallo::ParameterInfo {
                name: "w",
                symbol: "w",
                docs: "Wheel base.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "c",
                symbol: "c",
                docs: "Trail: positive when the front contact is behind the point where the steer axis meets the ground.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "lam",
                symbol: "λ",
                docs: "Steer axis tilt: 90 degrees minus the head angle.",
                unit: "rad",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(-1.5707963267948966),
                    upper: ::carvallo::Bound::Open(1.5707963267948966),
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "g",
                symbol: "g",
                docs: "Gravitational field strength.",
                unit: "N/kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "rR",
                symbol: "rR",
                docs: "Radius of the rear wheel.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "mR",
                symbol: "mR",
                docs: "Mass of the rear wheel.",
                unit: "kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IRxx",
                symbol: "IRxx",
                docs: "Radial moment of inertia of the rear wheel; by symmetry also about the vertical.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IRyy",
                symbol: "IRyy",
                docs: "Axial moment of inertia of the rear wheel.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "xB",
                symbol: "xB",
                docs: "Centre of mass of the rear frame and rider, forward of the rear contact.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "zB",
                symbol: "zB",
                docs: "Centre of mass of the rear frame and rider, downward.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "mB",
                symbol: "mB",
                docs: "Mass of the rear frame and rider.",
                unit: "kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IBxx",
                symbol: "IBxx",
                docs: "Moment of inertia of the rear frame and rider about its centre of mass, in roll.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IByy",
                symbol: "IByy",
                docs: "Moment of inertia of the rear frame and rider about its centre of mass, in pitch.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: false,
            },
            ::carvallo::ParameterInfo {
                name: "IBzz",
                symbol: "IBzz",
                docs: "Moment of inertia of the rear frame and rider about its centre of mass, in yaw.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IBxz",
                symbol: "IBxz",
                docs: "Product of inertia of the rear frame and rider about its centre of mass.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "xH",
                symbol: "xH",
                docs: "Centre of mass of the front frame, forward of the rear contact.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "zH",
                symbol: "zH",
                docs: "Centre of mass of the front frame, downward.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "mH",
                symbol: "mH",
                docs: "Mass of the front frame.",
                unit: "kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IHxx",
                symbol: "IHxx",
                docs: "Moment of inertia of the front frame about its centre of mass, in roll.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IHyy",
                symbol: "IHyy",
                docs: "Moment of inertia of the front frame about its centre of mass, in pitch.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: false,
            },
            ::carvallo::ParameterInfo {
                name: "IHzz",
                symbol: "IHzz",
                docs: "Moment of inertia of the front frame about its centre of mass, in yaw.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IHxz",
                symbol: "IHxz",
                docs: "Product of inertia of the front frame about its centre of mass.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Unbounded,
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "rF",
                symbol: "rF",
                docs: "Radius of the front wheel.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Open(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "mF",
                symbol: "mF",
                docs: "Mass of the front wheel.",
                unit: "kg",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IFxx",
                symbol: "IFxx",
                docs: "Radial moment of inertia of the front wheel; by symmetry also about the vertical.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "IFyy",
                symbol: "IFyy",
                docs: "Axial moment of inertia of the front wheel.",
                unit: "kg*m^2",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
        ],
        coordinates: &[
            ::carvallo::CoordinateInfo {
                name: "phi",
                label: "lean",
                docs: "Lean of the rear frame, positive to the right.",
                unit: "rad",
            },
            ::carvallo::CoordinateInfo {
                name: "delta",
                label: "steer",
                docs: "Steer of the front frame relative to the rear frame, positive to the right.",
                unit: "rad",
            },
        ],
        matrices: &["M", "C1", "K0", "K2"],
        entries: &[
            ::carvallo::EntryInfo {
                places: &[("M", 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("M", 0, 1), ("M", 1, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("M", 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("C1", 0, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("C1", 1, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("C1", 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("K0", 0, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("K0", 0, 1), ("K0", 1, 0)],
            },
            ::carvallo::EntryInfo {
                places: &[("K0", 1, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("K2", 0, 1)],
            },
            ::carvallo::EntryInfo {
                places: &[("K2", 1, 1)],
            },
        ],
        sets: &[
            ::carvallo::SetInfo {
                name: "benchmark",
                docs: "",
                source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1",
                values: &[
                    1.02,
                    0.08,
                    0.3141592653589793,
                    9.81,
                    0.3,
                    2.0,
                    0.0603,
                    0.12,
                    0.3,
                    -0.9,
                    85.0,
                    9.2,
                    11.0,
                    2.8,
                    2.4,
                    0.9,
                    -0.7,
                    4.0,
                    0.05892,
                    0.06,
                    0.00708,
                    -0.00756,
                    0.35,
                    3.0,
                    0.1405,
                    0.28,
                ],
            },
            ::carvallo::SetInfo {
                name: "benchmark_2005",
                docs: "",
                source: "Schwab, Meijaard & Papadopoulos (2005), ENOC 2005",
                values: &[
                    1.02,
                    0.08,
                    0.3217505543966422,
                    9.81,
                    0.3,
                    2.0,
                    0.06,
                    0.12,
                    0.3,
                    -0.9,
                    85.0,
                    9.2,
                    11.0,
                    2.8,
                    2.4,
                    0.9,
                    -0.7,
                    4.0,
                    0.0546,
                    0.06,
                    0.0114,
                    -0.0162,
                    0.35,
                    3.0,
                    0.14,
                    0.28,
                ],
            },
        ],
        gravity: ::core::option::Option::Some(3),
    };
    fn from_slice(
        values: &[T],
    ) -> ::core::result::Result<Self, ::carvallo::LengthError> {
        if values.len() != 26 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "Whipple",
                expected: 26,
                found: values.len(),
            });
        }
        ::core::result::Result::Ok(Self {
            w: values[0],
            c: values[1],
            lam: values[2],
            g: values[3],
            rR: values[4],
            mR: values[5],
            IRxx: values[6],
            IRyy: values[7],
            xB: values[8],
            zB: values[9],
            mB: values[10],
            IBxx: values[11],
            IByy: values[12],
            IBzz: values[13],
            IBxz: values[14],
            xH: values[15],
            zH: values[16],
            mH: values[17],
            IHxx: values[18],
            IHyy: values[19],
            IHzz: values[20],
            IHxz: values[21],
            rF: values[22],
            mF: values[23],
            IFxx: values[24],
            IFyy: values[25],
        })
    }
    fn write_to(
        &self,
        values: &mut [T],
    ) -> ::core::result::Result<(), ::carvallo::LengthError> {
        if values.len() != 26 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "Whipple",
                expected: 26,
                found: values.len(),
            });
        }
        values.copy_from_slice(&self.to_array());
        ::core::result::Result::Ok(())
    }
    #[inline(always)]
    fn parameters(&self) -> Self::Parameters {
        self.to_array()
    }
    fn validate(&self) -> ::core::result::Result<(), ::carvallo::ParameterError> {
        let info = <Self as ::carvallo::Model<2>>::INFO;
        info.validate(
            &[
                ::carvallo::Scalar::to_f64(self.w),
                ::carvallo::Scalar::to_f64(self.c),
                ::carvallo::Scalar::to_f64(self.lam),
                ::carvallo::Scalar::to_f64(self.g),
                ::carvallo::Scalar::to_f64(self.rR),
                ::carvallo::Scalar::to_f64(self.mR),
                ::carvallo::Scalar::to_f64(self.IRxx),
                ::carvallo::Scalar::to_f64(self.IRyy),
                ::carvallo::Scalar::to_f64(self.xB),
                ::carvallo::Scalar::to_f64(self.zB),
                ::carvallo::Scalar::to_f64(self.mB),
                ::carvallo::Scalar::to_f64(self.IBxx),
                ::carvallo::Scalar::to_f64(self.IByy),
                ::carvallo::Scalar::to_f64(self.IBzz),
                ::carvallo::Scalar::to_f64(self.IBxz),
                ::carvallo::Scalar::to_f64(self.xH),
                ::carvallo::Scalar::to_f64(self.zH),
                ::carvallo::Scalar::to_f64(self.mH),
                ::carvallo::Scalar::to_f64(self.IHxx),
                ::carvallo::Scalar::to_f64(self.IHyy),
                ::carvallo::Scalar::to_f64(self.IHzz),
                ::carvallo::Scalar::to_f64(self.IHxz),
                ::carvallo::Scalar::to_f64(self.rF),
                ::carvallo::Scalar::to_f64(self.mF),
                ::carvallo::Scalar::to_f64(self.IFxx),
                ::carvallo::Scalar::to_f64(self.IFyy),
            ],
        )?;
        let t5 = self.mH + self.mF;
        let t6 = (self.mR + self.mB) + t5;
        info.require(
            "mR + mB + mH + mF",
            ::carvallo::Scalar::to_f64(t6),
            "",
            ::carvallo::Domain {
                lower: ::carvallo::Bound::Open(0.0),
                upper: ::carvallo::Bound::Unbounded,
                nonzero: false,
            },
        )?;
        info.require(
            "mH + mF",
            ::carvallo::Scalar::to_f64(t5),
            "",
            ::carvallo::Domain {
                lower: ::carvallo::Bound::Open(0.0),
                upper: ::carvallo::Bound::Unbounded,
                nonzero: false,
            },
        )?;
        ::core::result::Result::Ok(())
    }
    #[inline]
    fn coefficients(&self) -> ::carvallo::Coefficients<T, 2> {
        let matrices = self.matrices();
        ::carvallo::Coefficients::from_rows([
            matrices.m,
            [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
            matrices.c1,
            [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
            matrices.k0,
            matrices.k2,
        ])
    }
    fn gravity(&self) -> ::core::option::Option<T> {
        ::core::option::Option::Some(self.g)
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> ::carvallo::Evaluator<T, 2> for Whipple<T> {
    type Entries = [T; 11];
    #[inline(always)]
    fn from_parameters(
        mut parameter: impl ::core::ops::FnMut(::core::primitive::usize) -> T,
    ) -> Self {
        Self {
            w: parameter(0),
            c: parameter(1),
            lam: parameter(2),
            g: parameter(3),
            rR: parameter(4),
            mR: parameter(5),
            IRxx: parameter(6),
            IRyy: parameter(7),
            xB: parameter(8),
            zB: parameter(9),
            mB: parameter(10),
            IBxx: parameter(11),
            IByy: parameter(12),
            IBzz: parameter(13),
            IBxz: parameter(14),
            xH: parameter(15),
            zH: parameter(16),
            mH: parameter(17),
            IHxx: parameter(18),
            IHyy: parameter(19),
            IHzz: parameter(20),
            IHxz: parameter(21),
            rF: parameter(22),
            mF: parameter(23),
            IFxx: parameter(24),
            IFyy: parameter(25),
        }
    }
    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        let matrices = self.matrices();
        [
            matrices.m[0][0],
            matrices.m[0][1],
            matrices.m[1][1],
            matrices.c1[0][1],
            matrices.c1[1][0],
            matrices.c1[1][1],
            matrices.k0[0][0],
            matrices.k0[0][1],
            matrices.k0[1][1],
            matrices.k2[0][1],
            matrices.k2[1][1],
        ]
    }
    #[inline(always)]
    fn rows(&self) -> [[[T; 2]; 2]; 6] {
        let matrices = self.matrices();
        [
            matrices.m,
            [[::carvallo::Number::like(self.w, 0.0); 2]; 2],
            matrices.c1,
            [[::carvallo::Number::like(self.w, 0.0); 2]; 2],
            matrices.k0,
            matrices.k2,
        ]
    }
}
/// The derivatives of the matrices of [`Whipple`] with respect to its parameters, in SI units: those that are not zero for all parameters.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleDerivatives<T = ::core::primitive::f64> {
    /// The value of each derivative in [`Self::PARTIALS`].
    pub values: [T; 158],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl WhippleDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [::carvallo::Partial; 158] = &[
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 1),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 2),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 4),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 5),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 6),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 6),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 6),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 7),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 8),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 9),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 10),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 11),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 13),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 14),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 14),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 14),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 15),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 16),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 17),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 18),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 18),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 18),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 18),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 20),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 20),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 21),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 21),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 21),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 21),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 21),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 22),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 23),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 0, 24),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 24),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 24),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 24),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 24),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 25),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 25),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 0, 1, 25),
        ::carvallo::Partial::new(::carvallo::MatrixName::K2, 1, 1, 25),
    ];
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> WhippleDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(
        &self,
        parameter: ::core::primitive::usize,
    ) -> ::core::option::Option<WhippleMatrices<T>> {
        if parameter >= 26 {
            return ::core::option::Option::None;
        }
        let zero = <T as ::carvallo::Scalar>::from_f64(0.0);
        let mut matrices = WhippleMatrices {
            m: [[zero; 2]; 2],
            c1: [[zero; 2]; 2],
            k0: [[zero; 2]; 2],
            k2: [[zero; 2]; 2],
        };
        for position in 0..158 {
            let partial = <WhippleDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                ::carvallo::MatrixName::M => &mut matrices.m,
                ::carvallo::MatrixName::C1 => &mut matrices.c1,
                ::carvallo::MatrixName::K0 => &mut matrices.k0,
                ::carvallo::MatrixName::K2 => &mut matrices.k2,
                _ => continue,
            };
            matrix[partial.row][partial.column] = self.values[position];
        }
        ::core::option::Option::Some(matrices)
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> Whipple<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 203 additions, 321 multiplications, 8 divisions, 40 negations and 2 trigonometric functions: 574 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(
        &self,
    ) -> (WhippleMatrices<T>, WhippleDerivatives<T>) {
        let (
            t5,
            t9,
            t14,
            t19,
            t24,
            t26,
            t54,
            t28,
            mA,
            t32,
            t33,
            t34,
            t35,
            zA,
            t37,
            t41,
            t42,
            xA,
            t44,
            t45,
            t48,
            t49,
            t50,
            IAxz,
            t53,
            t55,
            t58,
            IAxx,
            t61,
            t65,
            uA,
            t68,
            t74,
            t77,
            ITxz,
            t82,
            t83,
            mu,
            t86,
            t87,
            t91,
            t97,
            ITzz_mB,
            ITzz_mH,
            ITzz_mF,
            ITzz,
            t108,
            IAzz_mH,
            IAzz_mF,
            IAzz,
            t117,
            t118,
            IAlz,
            t126,
            SF_IFyy,
            SF,
            t131,
            ST_IRyy,
            ST,
            t137,
            t138,
            t139,
            t142,
            t143,
            SA_mu,
            SA,
            C122_mu,
            t154,
            t156,
            t157,
            t158,
            t159,
            t160,
            t161,
            t163,
            t166,
            t167,
            xA_w,
            t171,
            t172,
            M12_xA,
            t175,
            IAlz_uA,
            M22_uA,
            t180,
            t181,
            t182,
            t183,
            M22_IAzz,
            t188,
            C112_SF,
            M22_IAxz,
            t192,
            ITzz_w,
            M22_ITzz,
            t197,
            M22_mu,
            t199,
            t202,
            t203,
            t206,
            M22_xA,
            t211,
            t214,
            t216,
            t217,
            t218,
            C122_uA,
            t220,
            C122_IAzz,
            C122_IAxz,
            t226,
            t228,
            t231,
            t232,
            t233,
            SA_w,
            C122_ITzz,
            t241,
            t246,
            C122_xA,
            t251,
            t256,
            t258,
            t260,
            t264,
            SA_c,
            t267,
            t269,
            t270,
            t274,
            t277,
            t279,
            IAlz_lam,
            t292,
            t296,
            t300,
            t306,
            t313,
            t314,
            t315,
            t316,
            t317,
            t318,
            t319,
            t320,
            t321,
            t322,
            t323,
            t325,
            ITzz_xB,
            t327,
            SA_xB,
            t332,
            t334,
            t335,
            SA_mB,
            t339,
            t343,
            t347,
            t350,
            xA_xH,
            t355,
            ITzz_xH,
            t360,
            t362,
            SA_xH,
            t370,
            t372,
            t373,
            t374,
            t375,
            t380,
            t381,
            t383,
            t387,
            t389,
            t390,
            t391,
            t395,
            t399,
            t401,
            t404,
            t405,
            t407,
            t409,
            C122_zA,
            t414,
            t415,
            t418,
            t419,
            t426,
            t427,
            xA_mH,
            t432,
            zA_mH,
            t436,
            IAlz_mA,
            M22_mA,
            t449,
            t451,
            C122_mA,
            t459,
            t460,
            SA_mH,
            t471,
            t473,
            t476,
            t477,
            t478,
            t479,
            t480,
            t481,
            t485,
            t487,
            t489,
            t491,
            t492,
            t493,
            SA_rF,
            t498,
            t501,
            t504,
            t505,
            xA_mF,
            t516,
            t518,
            t528,
            t530,
            t531,
            SA_mF,
            t546,
            t548,
            t550,
            t551,
            t552,
            t553,
            t554,
            t555,
            t556,
            t557,
            t558,
            t559,
            t560,
            t561,
            t562,
            t563,
            t564,
            t565,
            t566,
            t567,
        );
        t5 = self.IHxx + self.IFxx;
        t9 = self.rR * self.rR;
        t14 = self.zB * self.zB;
        t19 = self.zH * self.zH;
        t24 = self.rF * self.rF;
        t26 = (((((self.IRxx + self.IBxx) + t5) + (self.mR * t9)) + (self.mB * t14))
            + (self.mH * t19)) + (self.mF * t24);
        (t54, t28) = ::carvallo::Number::sin_cos(self.lam);
        mA = self.mH + self.mF;
        t32 = ::carvallo::Number::like(self.w, 1.0) / mA;
        t33 = self.rF * self.mF;
        t34 = self.zH * self.mH;
        t35 = t34 - t33;
        zA = t32 * t35;
        t37 = self.zH - zA;
        t41 = self.xH * self.mH;
        t42 = (self.w * self.mF) + t41;
        xA = t32 * t42;
        t44 = self.xH - xA;
        t45 = t37 * t44;
        t48 = xA - self.w;
        t49 = self.rF + zA;
        t50 = t48 * t49;
        IAxz = (self.IHxz - (self.mH * t45)) - (self.mF * t50);
        t53 = t28 * IAxz;
        t55 = t37 * t37;
        t58 = t49 * t49;
        IAxx = (t5 + (self.mH * t55)) + (self.mF * t58);
        t61 = t54 * IAxx;
        t65 = t48 - self.c;
        uA = (t28 * t65) - (zA * t54);
        t68 = mA * uA;
        t74 = self.zB * self.mB;
        t77 = self.xH * self.zH;
        ITxz = (((self.IBxz + self.IHxz) - (self.xB * t74)) - (self.mH * t77))
            + (self.w * t33);
        t82 = ::carvallo::Number::like(self.w, 1.0) / self.w;
        t83 = t28 * t82;
        mu = self.c * t83;
        t86 = ((t53 + t61) - (t68 * zA)) + (ITxz * mu);
        t87 = uA * uA;
        t91 = t61 + (t53 * ::carvallo::Number::like(self.w, 2.0));
        t97 = self.IHzz + self.IFxx;
        ITzz_mB = self.xB * self.xB;
        ITzz_mH = self.xH * self.xH;
        ITzz_mF = self.w * self.w;
        ITzz = ((((self.IRxx + self.IBzz) + t97) + (self.mB * ITzz_mB))
            + (self.mH * ITzz_mH)) + (self.mF * ITzz_mF);
        t108 = mu * ITzz;
        IAzz_mH = t44 * t44;
        IAzz_mF = t48 * t48;
        IAzz = (t97 + (self.mH * IAzz_mH)) + (self.mF * IAzz_mF);
        t117 = t54 * IAxz;
        t118 = (t28 * IAzz) + t117;
        IAlz = (xA * t68) + t118;
        t126 = (((mA * t87) + (t54 * t91))
            + (mu * (t108 + (IAlz * ::carvallo::Number::like(self.w, 2.0)))))
            + (IAzz * (t28 * t28));
        SF_IFyy = ::carvallo::Number::like(self.w, 1.0) / self.rF;
        SF = self.IFyy * SF_IFyy;
        t131 = t28 * SF;
        ST_IRyy = ::carvallo::Number::like(self.w, 1.0) / self.rR;
        ST = SF + (self.IRyy * ST_IRyy);
        t137 = self.rR * self.mR;
        t138 = (t35 + t74) - t137;
        t139 = ST - t138;
        t142 = ITxz * t83;
        t143 = (t131 + (mu * t139)) + t142;
        SA_mu = t42 + (self.xB * self.mB);
        SA = t68 + (mu * SA_mu);
        C122_mu = SA + (t83 * ITzz);
        t154 = (t83 * IAlz) + (mu * C122_mu);
        t156 = t83 * t139;
        t157 = t54 * SF;
        t158 = SA + t157;
        t159 = t83 * t158;
        t160 = mA * zA;
        t161 = t49 * self.mF;
        t163 = t28 * (t160 + t161);
        t166 = t28 / ITzz_mF;
        t167 = self.c * ITxz;
        xA_w = self.mF * t32;
        t171 = t37 * self.mH;
        t172 = t28 * t171;
        M12_xA = t172 - t163;
        t175 = ((t163 + (t33 * mu)) - (t166 * t167)) + (xA_w * M12_xA);
        IAlz_uA = mA * xA;
        M22_uA = ::carvallo::Number::like(self.w, 2.0) * (t68 + (mu * IAlz_uA));
        t180 = t28 * M22_uA;
        t181 = self.mF * ::carvallo::Number::like(self.w, 2.0);
        t182 = t48 * t181;
        t183 = mu * ::carvallo::Number::like(self.w, 2.0);
        M22_IAzz = t28 * (t28 + t183);
        t188 = t54 * ::carvallo::Number::like(self.w, 2.0);
        C112_SF = t28 + mu;
        M22_IAxz = t188 * C112_SF;
        t192 = (t180 + (t182 * M22_IAzz)) - (t161 * M22_IAxz);
        ITzz_w = self.w * t181;
        M22_ITzz = mu * mu;
        t197 = IAlz + t108;
        M22_mu = ::carvallo::Number::like(self.w, 2.0) * t197;
        t199 = self.c * M22_mu;
        t202 = self.mH * t44;
        t203 = t202 * ::carvallo::Number::like(self.w, 2.0);
        t206 = (t203 * M22_IAzz) - (t171 * M22_IAxz);
        M22_xA = (t192 - t206) + (t68 * t183);
        t211 = (((ITzz_w * M22_ITzz) - t192) - (t166 * t199)) + (xA_w * M22_xA);
        t214 = ITxz + (self.c * t139);
        t216 = (t33 * t83) - (t166 * t214);
        t217 = ST * self.c;
        t218 = t166 * t217;
        C122_uA = t83 * IAlz_uA;
        t220 = t28 * C122_uA;
        C122_IAzz = t28 * t83;
        C122_IAxz = t54 * t83;
        t226 = (t220 + (t182 * C122_IAzz)) - (t161 * C122_IAxz);
        t228 = mA * t28;
        t231 = (self.mF * mu) + (t228 * (xA_w - ::carvallo::Number::like(self.w, 1.0)));
        t232 = self.c * SA_mu;
        t233 = t166 * t232;
        SA_w = t231 - t233;
        C122_ITzz = t83 * mu;
        t241 = t197 + (self.c * C122_mu);
        t246 = (t203 * C122_IAzz) - (t171 * C122_IAxz);
        C122_xA = (t226 - t246) + (t68 * t83);
        t251 = ((((mu * SA_w) - t226) + (ITzz_w * C122_ITzz)) - (t166 * t241))
            + (xA_w * C122_xA);
        t256 = (t83 * SA_w) - (t166 * t158);
        t258 = t142 + (t160 * t28);
        t260 = (t83 * M22_mu) - t180;
        t264 = t83 * SA_mu;
        SA_c = t264 - t228;
        t267 = ((t83 * C122_mu) - t220) + (mu * SA_c);
        t269 = t83 * SA_c;
        t270 = IAxx * t28;
        t274 = (t28 * zA) + (t54 * t65);
        t277 = t54 * t82;
        t279 = ((t270 - t117) + (t274 * t160)) - (t277 * t167);
        IAlz_lam = t53 - (IAzz * t54);
        t292 = (((((IAlz_lam * t183) - (t188 * t118)) + (t54 * t270)) + (t28 * t91))
            - (t274 * M22_uA)) - (t277 * t199);
        t296 = t157 + (t277 * t217);
        t300 = (mA * t274) + (t277 * t232);
        t306 = (((t83 * IAlz_lam) - (mu * t300)) - (t274 * C122_uA)) - (t277 * t241);
        t313 = (t83 * (t131 - t300)) - (t277 * t158);
        t314 = t137 * ::carvallo::Number::like(self.w, 2.0);
        t315 = self.IRyy / t9;
        t316 = self.mR - t315;
        t317 = mu * t316;
        t318 = t315 * mu;
        t319 = t83 * t316;
        t320 = self.rR * mu;
        t321 = self.rR * t83;
        t322 = mu * ST_IRyy;
        t323 = t83 * ST_IRyy;
        t325 = self.mB * ::carvallo::Number::like(self.w, 2.0);
        ITzz_xB = self.xB * t325;
        t327 = ITzz_xB * M22_ITzz;
        SA_xB = self.mB * mu;
        t332 = (mu * SA_xB) + (ITzz_xB * C122_ITzz);
        t334 = t83 * SA_xB;
        t335 = self.zB * t325;
        SA_mB = self.xB * mu;
        t339 = mu + (self.xB * t83);
        t343 = ITzz_mB * M22_ITzz;
        t347 = (mu * SA_mB) + (ITzz_mB * C122_ITzz);
        t350 = t83 * SA_mB;
        xA_xH = self.mH * t32;
        t355 = (xA_xH * M12_xA) - (t172 + (mu * t34));
        ITzz_xH = ::carvallo::Number::like(self.w, 2.0) * t41;
        t360 = (t206 + (ITzz_xH * M22_ITzz)) + (xA_xH * M22_xA);
        t362 = self.mH * mu;
        SA_xH = t362 + (t228 * xA_xH);
        t370 = ((t246 + (mu * SA_xH)) + (ITzz_xH * C122_ITzz)) + (xA_xH * C122_xA);
        t372 = t83 * SA_xH;
        t373 = t34 * ::carvallo::Number::like(self.w, 2.0);
        t374 = t171 * t188;
        t375 = t28 * t202;
        t380 = t161 * t188;
        t381 = t48 * self.mF;
        t383 = t380 - (t28 * t381);
        t387 = (((t68 + t374) - t383) - (t54 * t160)) - t375;
        t389 = ((t374 - t375) - (mu * t41)) - (xA_xH * t387);
        t390 = t54 * t374;
        t391 = t202 * M22_IAxz;
        t395 = (t54 * t380) - (t381 * M22_IAxz);
        t399 = ((t390 - t395) + (t54 * M22_uA)) - t391;
        t401 = (t390 - t391) - (xA_xH * t399);
        t404 = mA * t54;
        t405 = xA_xH * t404;
        t407 = t202 * C122_IAxz;
        t409 = t381 * C122_IAxz;
        C122_zA = t407 - (t409 + (C122_uA * t54));
        t414 = (xA_xH * C122_zA) - ((mu * t405) + t407);
        t415 = t405 * t54;
        t418 = t54 * t55;
        t419 = uA * zA;
        t426 = ::carvallo::Number::like(self.w, 1.0) / (mA * mA);
        t427 = t42 * t426;
        xA_mH = (self.xH * t32) - t427;
        t432 = t35 * t426;
        zA_mH = (self.zH * t32) - t432;
        t436 = ((((t418 - t419) - (t28 * t45)) - (mu * t77)) + (xA_mH * M12_xA))
            - (zA_mH * t387);
        IAlz_mA = xA * uA;
        M22_mA = (IAlz_mA * t183) + t87;
        t449 = ((((M22_mA + (t54 * t418)) + (ITzz_mH * M22_ITzz)) + (IAzz_mH * M22_IAzz))
            - (t45 * M22_IAxz)) + (xA_mH * M22_xA);
        t451 = t449 - (zA_mH * t399);
        C122_mA = t83 * IAlz_mA;
        t459 = (uA + (self.xH * mu)) + (t228 * xA_mH);
        t460 = zA_mH * t404;
        SA_mH = t459 - t460;
        t471 = ((((C122_mA + (mu * SA_mH)) + (ITzz_mH * C122_ITzz))
            + (IAzz_mH * C122_IAzz)) - (t45 * C122_IAxz)) + (xA_mH * C122_xA);
        t473 = t471 + (zA_mH * C122_zA);
        t476 = t83 * SA_mH;
        t477 = t54 * t54;
        t478 = M22_ITzz + M22_IAzz;
        t479 = C122_ITzz + C122_IAzz;
        t480 = t33 * ::carvallo::Number::like(self.w, 2.0);
        t481 = self.w * mu;
        t485 = (t383 + (self.mF * t481)) + (xA_w * t387);
        t487 = t395 + (xA_w * t399);
        t489 = mu + (self.w * t83);
        t491 = self.IFyy / t24;
        t492 = t491 * C112_SF;
        t493 = (self.mF * t489) - t492;
        SA_rF = xA_w * t404;
        t498 = ((mu * SA_rF) - t409) - (xA_w * C122_zA);
        t501 = t83 * (self.mF - t491);
        t504 = (t83 * SA_rF) - (t491 * C122_IAxz);
        t505 = t54 * t58;
        xA_mF = (self.w * t32) - t427;
        t516 = t432 + (self.rF * t32);
        t518 = ((((t505 - t419) + (self.rF * t481)) - (t28 * t50)) + (xA_mF * M12_xA))
            + (t516 * t387);
        t528 = ((((M22_mA + (t54 * t505)) + (ITzz_mF * M22_ITzz)) + (IAzz_mF * M22_IAzz))
            - (t50 * M22_IAxz)) + (xA_mF * M22_xA);
        t530 = t528 + (t516 * t399);
        t531 = self.rF * t489;
        SA_mF = ((uA + t481) + (t228 * xA_mF)) + (t516 * t404);
        t546 = ((((C122_mA + (mu * SA_mF)) + (ITzz_mF * C122_ITzz))
            + (IAzz_mF * C122_IAzz)) - (t50 * C122_IAxz)) + (xA_mF * C122_xA);
        t548 = t546 - (t516 * C122_zA);
        t550 = self.rF * t83;
        t551 = t83 * SA_mF;
        t552 = t477 + t478;
        t553 = SF_IFyy * C112_SF;
        t554 = t83 * SF_IFyy;
        t555 = SF_IFyy * C122_IAxz;
        t556 = -(t131 + (mu * ST));
        t557 = -SA;
        t558 = -(SA * t54);
        t559 = t233 - t231;
        t560 = -(SA_w * t54);
        t561 = -(t139 * t166);
        t562 = -(ST * t83);
        t563 = t228 - t264;
        t564 = -(SA_c * t54);
        t565 = -(t157 + (t277 * t214));
        t566 = (t54 * t300) - (SA * t28);
        t567 = -(t139 * t277);
        let (
            t568,
            t569,
            t570,
            t571,
            t572,
            t573,
            t574,
            t575,
            t576,
            t577,
            t578,
            t579,
            t580,
            t581,
            t582,
            t583,
            t584,
            t585,
            t586,
            t587,
            t588,
            t589,
            t590,
            t591,
            t592,
            t593,
            t594,
            t595,
            t596,
            t597,
            t598,
            t599,
        );
        t568 = -self.mR;
        t569 = -self.rR;
        t570 = -t322;
        t571 = -(t74 * mu);
        t572 = -(t74 * t83);
        t573 = -SA_xB;
        t574 = -(SA_xB * t54);
        t575 = -(self.mB * SA_mB);
        t576 = -(self.mB * t339);
        t577 = -(self.mB * t83);
        t578 = -(self.zB * SA_mB);
        t579 = -(self.zB * t339);
        t580 = -SA_mB;
        t581 = -(SA_mB * t54);
        t582 = -(self.zB * t83);
        t583 = -(t83 * t34);
        t584 = -SA_xH;
        t585 = -(SA_xH * t54);
        t586 = -(t362 + (t83 * t41));
        t587 = -(self.mH * t83);
        t588 = -(t83 * t405);
        t589 = -((self.zH * mu) + (t83 * t77));
        t590 = t460 - t459;
        t591 = -(SA_mH * t54);
        t592 = -(self.zH * t83);
        t593 = -self.mF;
        t594 = -SA_rF;
        t595 = -(SA_rF * t54);
        t596 = -self.rF;
        t597 = -SA_mF;
        t598 = -(SA_mF * t54);
        t599 = -t553;
        (
            WhippleMatrices {
                m: [[t26, t86], [t86, t126]],
                c1: [[::carvallo::Number::like(self.w, 0.0), t143], [t556, t154]],
                k0: [[t138, t557], [t557, t558]],
                k2: [
                    [::carvallo::Number::like(self.w, 0.0), t156],
                    [::carvallo::Number::like(self.w, 0.0), t159],
                ],
            },
            WhippleDerivatives {
                values: [
                    t175,
                    t175,
                    t211,
                    t216,
                    t218,
                    t251,
                    t559,
                    t559,
                    t560,
                    t561,
                    t256,
                    t258,
                    t258,
                    t260,
                    t156,
                    t562,
                    t267,
                    t563,
                    t563,
                    t564,
                    t269,
                    t279,
                    t279,
                    t292,
                    t565,
                    t296,
                    t306,
                    t300,
                    t300,
                    t566,
                    t567,
                    t313,
                    t314,
                    t317,
                    t318,
                    t568,
                    t319,
                    t9,
                    t320,
                    t569,
                    t321,
                    ::carvallo::Number::like(self.w, 1.0),
                    M22_ITzz,
                    C122_ITzz,
                    t322,
                    t570,
                    t323,
                    t571,
                    t571,
                    t327,
                    t572,
                    t332,
                    t573,
                    t573,
                    t574,
                    t334,
                    t335,
                    t575,
                    t575,
                    t576,
                    self.mB,
                    t577,
                    t14,
                    t578,
                    t578,
                    t343,
                    t579,
                    t347,
                    self.zB,
                    t580,
                    t580,
                    t581,
                    t582,
                    t350,
                    ::carvallo::Number::like(self.w, 1.0),
                    M22_ITzz,
                    C122_ITzz,
                    mu,
                    mu,
                    t83,
                    t355,
                    t355,
                    t360,
                    t583,
                    t370,
                    t584,
                    t584,
                    t585,
                    t372,
                    t373,
                    t389,
                    t389,
                    t401,
                    t586,
                    t414,
                    self.mH,
                    t405,
                    t405,
                    t415,
                    t587,
                    t588,
                    t19,
                    t436,
                    t436,
                    t451,
                    t589,
                    t473,
                    self.zH,
                    t590,
                    t590,
                    t591,
                    t592,
                    t476,
                    ::carvallo::Number::like(self.w, 1.0),
                    t54,
                    t54,
                    t477,
                    t478,
                    t479,
                    C112_SF,
                    C112_SF,
                    M22_IAxz,
                    t83,
                    C122_IAxz,
                    t480,
                    t485,
                    t485,
                    t487,
                    t493,
                    t492,
                    t498,
                    t593,
                    t594,
                    t594,
                    t595,
                    t501,
                    t504,
                    t24,
                    t518,
                    t518,
                    t530,
                    t531,
                    t548,
                    t596,
                    t597,
                    t597,
                    t598,
                    t550,
                    t551,
                    ::carvallo::Number::like(self.w, 1.0),
                    t54,
                    t54,
                    t552,
                    t479,
                    t553,
                    t599,
                    t554,
                    t555,
                ],
            },
        )
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Differentiable<2> for Whipple<T> {
    type Derivatives = [::carvallo::Coefficients<T, 2>; 26];
    fn coefficients_and_derivatives(
        &self,
    ) -> (::carvallo::Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let mut all = [::carvallo::Coefficients::from_rows(
            [[[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2]; 6],
        ); 26];
        for position in 0..158 {
            <WhippleDerivatives>::PARTIALS[position]
                .write(derivatives.values[position], &mut all);
        }
        (
            ::carvallo::Coefficients::from_rows([
                matrices.m,
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
                matrices.c1,
                [[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2],
                matrices.k0,
                matrices.k2,
            ]),
            all,
        )
    }
}
