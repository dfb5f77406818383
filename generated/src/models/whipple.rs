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
    type Array<U: ::core::marker::Copy> = [U; 26];
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
    fn array<U: ::core::marker::Copy>(
        element: impl ::core::ops::FnMut(::core::primitive::usize) -> U,
    ) -> Self::Array<U> {
        ::core::array::from_fn(element)
    }
    #[inline(always)]
    fn parameters(&self) -> Self::Array<T> {
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
    /// 207 additions, 337 multiplications, 4 divisions, 40 negations and 2 trigonometric functions: 590 operations.
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
            t39,
            ITxz_rF,
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
            M22_mA,
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
            M22_IAzz,
            t126,
            t129,
            SF,
            t131,
            t133,
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
            t162,
            t163,
            t164,
            t168,
            t169,
            xA_w,
            t173,
            t174,
            M12_xA,
            t177,
            t179,
            t180,
            IAlz_uA,
            t184,
            t187,
            M22_uA,
            t190,
            t193,
            ITzz_w,
            M22_ITzz,
            t199,
            M22_mu,
            t201,
            t205,
            t206,
            t208,
            t213,
            IAlz_xA,
            t215,
            M22_xA,
            t219,
            t222,
            t224,
            t225,
            t226,
            t228,
            t229,
            t232,
            t233,
            t234,
            SA_w,
            C122_ITzz,
            t242,
            C122_xA,
            t247,
            t252,
            t253,
            t254,
            t258,
            t262,
            SA_c,
            t265,
            t267,
            t272,
            t275,
            t277,
            IAlz_lam,
            t291,
            t295,
            t299,
            t303,
            t310,
            t311,
            t313,
            t314,
            t315,
            t316,
            t317,
            t318,
            t319,
            t320,
            t321,
            t323,
            ITzz_xB,
            t325,
            SA_xB,
            t330,
            t332,
            t333,
            SA_mB,
            t337,
            t341,
            t345,
            t348,
            zA_zH,
            t353,
            ITzz_xH,
            t360,
            t363,
            SA_xH,
            t371,
            t373,
            t374,
            t375,
            t376,
            t377,
            t381,
            t382,
            t383,
            t384,
            t387,
            t389,
            t392,
            t393,
            t394,
            IAlz_zA,
            IAlz_zH,
            t404,
            M22_zA,
            t409,
            t413,
            t414,
            t416,
            t417,
            t420,
            t421,
            t423,
            t427,
            t428,
            zA_mH,
            t433,
            xA_mH,
            t437,
            IAlz_mA,
            IAlz_mH,
            t454,
            t458,
            t466,
            t467,
            SA_mH,
            t474,
            t477,
            t478,
            t481,
            t483,
            C112_SF,
            t485,
            K222_SF,
            t487,
            t491,
            t493,
            t497,
            t501,
            t502,
            t503,
            SA_rF,
            t507,
            t510,
            t513,
            t514,
            t515,
            ITxz_mF,
            t522,
            xA_mF,
            t528,
            IAlz_mF,
            t544,
            t548,
            t551,
            SA_mF,
            t564,
            t566,
            t567,
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
        t39 = self.xH * self.mH;
        ITxz_rF = self.w * self.mF;
        t42 = t39 + ITxz_rF;
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
        M22_mA = uA * uA;
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
        M22_IAzz = t28 * t28;
        t126 = (((mA * M22_mA) + (t54 * t91))
            + (mu * (t108 + (IAlz * ::carvallo::Number::like(self.w, 2.0)))))
            + (IAzz * M22_IAzz);
        t129 = ::carvallo::Number::like(self.w, 1.0) / self.rF;
        SF = self.IFyy * t129;
        t131 = t28 * SF;
        t133 = ::carvallo::Number::like(self.w, 1.0) / self.rR;
        ST = SF + (self.IRyy * t133);
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
        t160 = t49 * self.mF;
        t161 = t28 * t160;
        t162 = mA * zA;
        t163 = t28 * t162;
        t164 = t161 + t163;
        t168 = t28 * (t82 * t82);
        t169 = self.c * ITxz;
        xA_w = self.mF * t32;
        t173 = t37 * self.mH;
        t174 = t28 * t173;
        M12_xA = t174 - t164;
        t177 = ((t164 + (t33 * mu)) - (t168 * t169)) + (xA_w * M12_xA);
        t179 = self.mF * ::carvallo::Number::like(self.w, 2.0);
        t180 = t48 * t179;
        IAlz_uA = mA * xA;
        t184 = (t28 * (t180 + IAlz_uA)) - (t54 * t160);
        t187 = t54 * ::carvallo::Number::like(self.w, 2.0);
        M22_uA = ::carvallo::Number::like(self.w, 2.0) * t68;
        t190 = t28 * M22_uA;
        t193 = (t190 - (t161 * t187)) + (t180 * M22_IAzz);
        ITzz_w = self.w * t179;
        M22_ITzz = mu * mu;
        t199 = IAlz + t108;
        M22_mu = ::carvallo::Number::like(self.w, 2.0) * t199;
        t201 = self.c * M22_mu;
        t205 = self.mH * t44;
        t206 = t205 * ::carvallo::Number::like(self.w, 2.0);
        t208 = (t206 * M22_IAzz) - (t174 * t187);
        t213 = (t28 * t206) - (t54 * t173);
        IAlz_xA = (t68 + t184) - t213;
        t215 = mu * ::carvallo::Number::like(self.w, 2.0);
        M22_xA = (t193 - t208) + (IAlz_xA * t215);
        t219 = (((ITzz_w * M22_ITzz)
            - (((mu * t184) * ::carvallo::Number::like(self.w, 2.0)) + t193))
            - (t168 * t201)) + (xA_w * M22_xA);
        t222 = ITxz + (self.c * t139);
        t224 = (t33 * t83) - (t168 * t222);
        t225 = ST * self.c;
        t226 = t168 * t225;
        t228 = self.mF * mu;
        t229 = mA * t28;
        t232 = t228 + (t229 * (xA_w - ::carvallo::Number::like(self.w, 1.0)));
        t233 = self.c * SA_mu;
        t234 = t168 * t233;
        SA_w = t232 - t234;
        C122_ITzz = t83 * mu;
        t242 = t199 + (self.c * C122_mu);
        C122_xA = t83 * IAlz_xA;
        t247 = ((((mu * SA_w) - (t184 * t83)) + (ITzz_w * C122_ITzz)) - (t168 * t242))
            + (xA_w * C122_xA);
        t252 = (t83 * SA_w) - (t168 * t158);
        t253 = t142 + t163;
        t254 = IAlz_uA * t28;
        t258 = (t83 * M22_mu) - (t190 + (t254 * t215));
        t262 = t83 * SA_mu;
        SA_c = t262 - t229;
        t265 = (t83 * (C122_mu - t254)) + (mu * SA_c);
        t267 = t83 * SA_c;
        t272 = (t28 * zA) + (t54 * t65);
        t275 = t82 * t54;
        t277 = (((IAxx * t28) - t117) + (t272 * t162)) - (t275 * t169);
        IAlz_lam = (t53 - (IAzz * t54)) - (t272 * IAlz_uA);
        t291 = ((((IAlz_lam * t215) - (t187 * t118)) + (t28 * (t61 + t91)))
            - (t272 * M22_uA)) - (t275 * t201);
        t295 = t157 + (t275 * t225);
        t299 = (mA * t272) + (t275 * t233);
        t303 = ((t83 * IAlz_lam) - (mu * t299)) - (t275 * t242);
        t310 = (t83 * (t131 - t299)) - (t275 * t158);
        t311 = t137 * ::carvallo::Number::like(self.w, 2.0);
        t313 = self.IRyy * (t133 * t133);
        t314 = self.mR - t313;
        t315 = mu * t314;
        t316 = t313 * mu;
        t317 = t83 * t314;
        t318 = self.rR * mu;
        t319 = self.rR * t83;
        t320 = mu * t133;
        t321 = t83 * t133;
        t323 = self.mB * ::carvallo::Number::like(self.w, 2.0);
        ITzz_xB = self.xB * t323;
        t325 = ITzz_xB * M22_ITzz;
        SA_xB = self.mB * mu;
        t330 = (mu * SA_xB) + (ITzz_xB * C122_ITzz);
        t332 = t83 * SA_xB;
        t333 = self.zB * t323;
        SA_mB = self.xB * mu;
        t337 = mu + (self.xB * t83);
        t341 = ITzz_mB * M22_ITzz;
        t345 = (mu * SA_mB) + (ITzz_mB * C122_ITzz);
        t348 = t83 * SA_mB;
        zA_zH = self.mH * t32;
        t353 = (zA_zH * M12_xA) - (t174 + (mu * t34));
        ITzz_xH = ::carvallo::Number::like(self.w, 2.0) * t39;
        t360 = ((t208 + (t213 * t215)) + (ITzz_xH * M22_ITzz)) + (zA_zH * M22_xA);
        t363 = self.mH * mu;
        SA_xH = t363 + (t229 * zA_zH);
        t371 = (((t83 * t213) + (mu * SA_xH)) + (ITzz_xH * C122_ITzz))
            + (zA_zH * C122_xA);
        t373 = t83 * SA_xH;
        t374 = t34 * ::carvallo::Number::like(self.w, 2.0);
        t375 = t28 * t205;
        t376 = t173 * t187;
        t377 = t376 - t375;
        t381 = t48 * self.mF;
        t382 = t28 * t381;
        t383 = t160 * t187;
        t384 = t383 - t382;
        t387 = ((t68 + t377) - t384) - (t54 * t162);
        t389 = (t377 - (mu * t39)) - (zA_zH * t387);
        t392 = t54 * (t376 - (t375 * ::carvallo::Number::like(self.w, 2.0)));
        t393 = t54 * t205;
        t394 = t54 * t381;
        IAlz_zA = t393 - (t394 + (IAlz_uA * t54));
        IAlz_zH = (zA_zH * IAlz_zA) - t393;
        t404 = t54 * (t383 - (t382 * ::carvallo::Number::like(self.w, 2.0)));
        M22_zA = (t404 - (M22_uA * t54)) - t392;
        t409 = (t392 + (IAlz_zH * t215)) + (zA_zH * M22_zA);
        t413 = mA * t54;
        t414 = zA_zH * t413;
        t416 = (t83 * IAlz_zH) - (mu * t414);
        t417 = t414 * t54;
        t420 = t28 * t45;
        t421 = t54 * t55;
        t423 = uA * zA;
        t427 = t32 * t32;
        t428 = t35 * t427;
        zA_mH = (self.zH * t32) - t428;
        t433 = t42 * t427;
        xA_mH = (self.xH * t32) - t433;
        t437 = ((((t421 - t420) - t423) - (mu * t77)) - (zA_mH * t387))
            + (xA_mH * M12_xA);
        IAlz_mA = xA * uA;
        IAlz_mH = ((IAlz_mA - (t54 * t45)) + (t28 * IAzz_mH)) + (zA_mH * IAlz_zA);
        t454 = (((M22_mA + (IAlz_mH * t215))
            + (t54 * (t421 - (t420 * ::carvallo::Number::like(self.w, 2.0)))))
            + (ITzz_mH * M22_ITzz)) + (IAzz_mH * M22_IAzz);
        t458 = (t454 + (zA_mH * M22_zA)) + (xA_mH * M22_xA);
        t466 = (uA + (self.xH * mu)) + (t229 * xA_mH);
        t467 = zA_mH * t413;
        SA_mH = t466 - t467;
        t474 = (((t83 * IAlz_mH) + (mu * SA_mH)) + (ITzz_mH * C122_ITzz))
            + (xA_mH * C122_xA);
        t477 = t83 * SA_mH;
        t478 = t54 * t54;
        t481 = (M22_ITzz + M22_IAzz) + (t28 * t215);
        t483 = C122_ITzz + (t28 * t83);
        C112_SF = t28 + mu;
        t485 = t187 * C112_SF;
        K222_SF = t54 * t83;
        t487 = t33 * ::carvallo::Number::like(self.w, 2.0);
        t491 = (t384 + (mu * ITxz_rF)) + (xA_w * t387);
        t493 = t394 + (xA_w * IAlz_zA);
        t497 = (t404 - (t493 * t215)) - (xA_w * M22_zA);
        t501 = self.IFyy * (t129 * t129);
        t502 = t501 * C112_SF;
        t503 = (t228 + (t83 * ITxz_rF)) - t502;
        SA_rF = xA_w * t413;
        t507 = (mu * SA_rF) - (t83 * t493);
        t510 = t83 * (self.mF - t501);
        t513 = (t83 * SA_rF) - (t501 * K222_SF);
        t514 = t28 * t50;
        t515 = t54 * t58;
        ITxz_mF = self.w * self.rF;
        t522 = t428 + (self.rF * t32);
        xA_mF = (self.w * t32) - t433;
        t528 = ((((t515 - t514) - t423) + (mu * ITxz_mF)) + (t522 * t387))
            + (xA_mF * M12_xA);
        IAlz_mF = ((IAlz_mA - (t54 * t50)) + (t28 * IAzz_mF)) - (t522 * IAlz_zA);
        t544 = (((M22_mA + (IAlz_mF * t215))
            + (t54 * (t515 - (t514 * ::carvallo::Number::like(self.w, 2.0)))))
            + (ITzz_mF * M22_ITzz)) + (IAzz_mF * M22_IAzz);
        t548 = (t544 - (t522 * M22_zA)) + (xA_mF * M22_xA);
        t551 = (self.rF * mu) + (t83 * ITxz_mF);
        SA_mF = ((uA + (self.w * mu)) + (t229 * xA_mF)) + (t522 * t413);
        t564 = (((t83 * IAlz_mF) + (mu * SA_mF)) + (ITzz_mF * C122_ITzz))
            + (xA_mF * C122_xA);
        t566 = self.rF * t83;
        t567 = t83 * SA_mF;
        t568 = t478 + t481;
        t569 = t129 * C112_SF;
        t570 = t83 * t129;
        t571 = t129 * K222_SF;
        t572 = -(t131 + (mu * ST));
        t573 = -SA;
        t574 = -(SA * t54);
        t575 = t234 - t232;
        t576 = -(SA_w * t54);
        t577 = -(t139 * t168);
        t578 = -(ST * t83);
        t579 = t229 - t262;
        let (
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
            t600,
            t601,
            t602,
            t603,
            t604,
            t605,
            t606,
            t607,
            t608,
            t609,
            t610,
            t611,
            t612,
            t613,
            t614,
            t615,
        );
        t580 = -(SA_c * t54);
        t581 = -(t157 + (t275 * t222));
        t582 = (t54 * t299) - (SA * t28);
        t583 = -(t139 * t275);
        t584 = -self.mR;
        t585 = -self.rR;
        t586 = -t320;
        t587 = -(t74 * mu);
        t588 = -(t74 * t83);
        t589 = -SA_xB;
        t590 = -(SA_xB * t54);
        t591 = -(self.mB * SA_mB);
        t592 = -(self.mB * t337);
        t593 = -(self.mB * t83);
        t594 = -(self.zB * SA_mB);
        t595 = -(self.zB * t337);
        t596 = -SA_mB;
        t597 = -(SA_mB * t54);
        t598 = -(self.zB * t83);
        t599 = -(t83 * t34);
        t600 = -SA_xH;
        t601 = -(SA_xH * t54);
        t602 = -(t363 + (t83 * t39));
        t603 = -(self.mH * t83);
        t604 = -(t83 * t414);
        t605 = -((self.zH * mu) + (t83 * t77));
        t606 = t467 - t466;
        t607 = -(SA_mH * t54);
        t608 = -(self.zH * t83);
        t609 = -self.mF;
        t610 = -SA_rF;
        t611 = -(SA_rF * t54);
        t612 = -self.rF;
        t613 = -SA_mF;
        t614 = -(SA_mF * t54);
        t615 = -t569;
        (
            WhippleMatrices {
                m: [[t26, t86], [t86, t126]],
                c1: [[::carvallo::Number::like(self.w, 0.0), t143], [t572, t154]],
                k0: [[t138, t573], [t573, t574]],
                k2: [
                    [::carvallo::Number::like(self.w, 0.0), t156],
                    [::carvallo::Number::like(self.w, 0.0), t159],
                ],
            },
            WhippleDerivatives {
                values: [
                    t177,
                    t177,
                    t219,
                    t224,
                    t226,
                    t247,
                    t575,
                    t575,
                    t576,
                    t577,
                    t252,
                    t253,
                    t253,
                    t258,
                    t156,
                    t578,
                    t265,
                    t579,
                    t579,
                    t580,
                    t267,
                    t277,
                    t277,
                    t291,
                    t581,
                    t295,
                    t303,
                    t299,
                    t299,
                    t582,
                    t583,
                    t310,
                    t311,
                    t315,
                    t316,
                    t584,
                    t317,
                    t9,
                    t318,
                    t585,
                    t319,
                    ::carvallo::Number::like(self.w, 1.0),
                    M22_ITzz,
                    C122_ITzz,
                    t320,
                    t586,
                    t321,
                    t587,
                    t587,
                    t325,
                    t588,
                    t330,
                    t589,
                    t589,
                    t590,
                    t332,
                    t333,
                    t591,
                    t591,
                    t592,
                    self.mB,
                    t593,
                    t14,
                    t594,
                    t594,
                    t341,
                    t595,
                    t345,
                    self.zB,
                    t596,
                    t596,
                    t597,
                    t598,
                    t348,
                    ::carvallo::Number::like(self.w, 1.0),
                    M22_ITzz,
                    C122_ITzz,
                    mu,
                    mu,
                    t83,
                    t353,
                    t353,
                    t360,
                    t599,
                    t371,
                    t600,
                    t600,
                    t601,
                    t373,
                    t374,
                    t389,
                    t389,
                    t409,
                    t602,
                    t416,
                    self.mH,
                    t414,
                    t414,
                    t417,
                    t603,
                    t604,
                    t19,
                    t437,
                    t437,
                    t458,
                    t605,
                    t474,
                    self.zH,
                    t606,
                    t606,
                    t607,
                    t608,
                    t477,
                    ::carvallo::Number::like(self.w, 1.0),
                    t54,
                    t54,
                    t478,
                    t481,
                    t483,
                    C112_SF,
                    C112_SF,
                    t485,
                    t83,
                    K222_SF,
                    t487,
                    t491,
                    t491,
                    t497,
                    t503,
                    t502,
                    t507,
                    t609,
                    t610,
                    t610,
                    t611,
                    t510,
                    t513,
                    t24,
                    t528,
                    t528,
                    t548,
                    t551,
                    t564,
                    t612,
                    t613,
                    t613,
                    t614,
                    t566,
                    t567,
                    ::carvallo::Number::like(self.w, 1.0),
                    t54,
                    t54,
                    t568,
                    t483,
                    t569,
                    t615,
                    t570,
                    t571,
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
