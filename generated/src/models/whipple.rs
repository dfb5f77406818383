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
impl<T: ::carvallo::Scalar> Whipple<T> {
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
impl<T: ::carvallo::Scalar> Whipple<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 54 additions, 71 multiplications, 4 divisions, 3 negations and 2 trigonometric functions: 134 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn matrices(&self) -> WhippleMatrices<T> {
        let t5 = self.IHxx + self.IFxx;
        let t26 = (((((self.IRxx + self.IBxx) + t5) + (self.mR * (self.rR * self.rR)))
            + (self.mB * (self.zB * self.zB))) + (self.mH * (self.zH * self.zH)))
            + (self.mF * (self.rF * self.rF));
        let mA = self.mH + self.mF;
        let t28 = <T as ::carvallo::Scalar>::from_f64(1.0) / mA;
        let t30 = self.rF * self.mF;
        let t31 = (self.zH * self.mH) - t30;
        let zA = t28 * t31;
        let (t34, t45) = ::carvallo::Scalar::sin_cos(self.lam);
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
            + (mu * ((IAlz * <T as ::carvallo::Scalar>::from_f64(2.0)) + (ITzz * mu))))
            + (t34 * (t68 + (<T as ::carvallo::Scalar>::from_f64(2.0) * t60)));
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
            c1: [[<T as ::carvallo::Scalar>::from_f64(0.0), t139], [t156, t150]],
            k0: [[t134, t157], [t157, t158]],
            k2: [
                [<T as ::carvallo::Scalar>::from_f64(0.0), t152],
                [<T as ::carvallo::Scalar>::from_f64(0.0), t155],
            ],
        }
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Model<2> for Whipple<T> {
    type Scalar = T;
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
impl<T: ::carvallo::Scalar> Whipple<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 194 additions, 332 multiplications, 8 divisions, 43 negations and 2 trigonometric functions: 579 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline]
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
            IAxx_mH,
            IAxx_mF,
            IAxx,
            t61,
            t65,
            uA,
            t68,
            t73,
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
            t147,
            SA_mu,
            SA,
            C122_mu,
            t154,
            t156,
            t157,
            t158,
            t159,
            t160,
            t164,
            t165,
            t168,
            xA_w,
            uA_w,
            t173,
            t174,
            t175,
            M22_IAxz,
            t178,
            t179,
            t183,
            IAlz_w,
            t185,
            ITzz_w,
            M22_ITzz,
            t192,
            M22_mu,
            IAlz_uA,
            M22_uA,
            t201,
            t206,
            t207,
            K222_SF,
            t214,
            t215,
            SA_w,
            C122_ITzz,
            t225,
            C122_uA,
            t228,
            t233,
            t235,
            t238,
            t243,
            t244,
            SA_c,
            t247,
            t249,
            IAlx_lam,
            t252,
            t253,
            t258,
            t260,
            IAlz_lam,
            t272,
            t278,
            t282,
            t290,
            t297,
            t298,
            t299,
            t300,
            t301,
            t302,
            t303,
            t304,
            t305,
            t306,
            t307,
            ITzz_xB,
            t310,
            SA_xB,
            t315,
            t317,
            t318,
            t323,
            t325,
            SA_mB,
            t332,
            t335,
            t336,
            zA_zH,
            uA_xH,
            t344,
            t345,
            t347,
            IAlz_xH,
            ITzz_xH,
            t358,
            t361,
            SA_xH,
            t371,
            t373,
            t374,
            t375,
            IAlx_zH,
            t378,
            t383,
            t385,
            M22_IAxx,
            t391,
            t394,
            t400,
            t403,
            t405,
            t406,
            zA_mH,
            IAlx_mH,
            t418,
            xA_mH,
            uA_mH,
            t424,
            IAlz_mA,
            IAlz_mH,
            t439,
            t441,
            SA_mH,
            t457,
            t460,
            t463,
            t465,
            t466,
            t467,
            IAlx_rF,
            t470,
            uA_rF,
            t477,
            t482,
            t483,
            t487,
            t489,
            t490,
            SA_rF,
            t496,
            t498,
            t501,
            t503,
            IAlx_mF,
            ITxz_mF,
            xA_mF,
            uA_mF,
            t519,
            IAlz_mF,
            t533,
            t535,
            t538,
            SA_mF,
            t551,
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
        );
        t5 = self.IHxx + self.IFxx;
        t9 = self.rR * self.rR;
        t14 = self.zB * self.zB;
        t19 = self.zH * self.zH;
        t24 = self.rF * self.rF;
        t26 = (((((self.IRxx + self.IBxx) + t5) + (self.mR * t9)) + (self.mB * t14))
            + (self.mH * t19)) + (self.mF * t24);
        (t54, t28) = ::carvallo::Scalar::sin_cos(self.lam);
        mA = self.mH + self.mF;
        t32 = <T as ::carvallo::Scalar>::from_f64(1.0) / mA;
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
        IAxx_mH = t37 * t37;
        IAxx_mF = t49 * t49;
        IAxx = (t5 + (self.mH * IAxx_mH)) + (self.mF * IAxx_mF);
        t61 = t54 * IAxx;
        t65 = t48 - self.c;
        uA = (t28 * t65) - (zA * t54);
        t68 = mA * uA;
        t73 = self.zB * self.mB;
        t77 = self.xH * self.zH;
        ITxz = (((self.IBxz + self.IHxz) - (t73 * self.xB)) - (self.mH * t77))
            + (self.w * t33);
        t82 = <T as ::carvallo::Scalar>::from_f64(1.0) / self.w;
        t83 = t28 * t82;
        mu = self.c * t83;
        t86 = ((t53 + t61) - (t68 * zA)) + (ITxz * mu);
        M22_mA = uA * uA;
        t91 = t61 + (t53 * <T as ::carvallo::Scalar>::from_f64(2.0));
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
            + (mu * (t108 + (IAlz * <T as ::carvallo::Scalar>::from_f64(2.0)))))
            + (IAzz * M22_IAzz);
        SF_IFyy = <T as ::carvallo::Scalar>::from_f64(1.0) / self.rF;
        SF = self.IFyy * SF_IFyy;
        t131 = t28 * SF;
        ST_IRyy = <T as ::carvallo::Scalar>::from_f64(1.0) / self.rR;
        ST = SF + (self.IRyy * ST_IRyy);
        t137 = self.rR * self.mR;
        t138 = (t35 + t73) - t137;
        t139 = ST - t138;
        t142 = ITxz * t83;
        t143 = (t131 + (mu * t139)) + t142;
        t147 = self.xB * self.mB;
        SA_mu = t42 + t147;
        SA = t68 + (mu * SA_mu);
        C122_mu = SA + (t83 * ITzz);
        t154 = (t83 * IAlz) + (mu * C122_mu);
        t156 = t83 * t139;
        t157 = t54 * SF;
        t158 = SA + t157;
        t159 = t83 * t158;
        t160 = t49 * self.mF;
        t164 = t28 / ITzz_mF;
        t165 = self.c * t164;
        t168 = mA * zA;
        xA_w = self.mF * t32;
        uA_w = t28 * (xA_w - <T as ::carvallo::Scalar>::from_f64(1.0));
        t173 = (((t160 * t28) + (t33 * mu)) - (ITxz * t165)) - (t168 * uA_w);
        t174 = t54 * <T as ::carvallo::Scalar>::from_f64(2.0);
        t175 = t28 + mu;
        M22_IAxz = t174 * t175;
        t178 = self.mF * <T as ::carvallo::Scalar>::from_f64(2.0);
        t179 = t48 * t178;
        t183 = t68 * xA_w;
        IAlz_w = t183 - (t179 * t28);
        t185 = mu * <T as ::carvallo::Scalar>::from_f64(2.0);
        ITzz_w = self.w * t178;
        M22_ITzz = mu * mu;
        t192 = IAlz + t108;
        M22_mu = <T as ::carvallo::Scalar>::from_f64(2.0) * t192;
        IAlz_uA = mA * xA;
        M22_uA = <T as ::carvallo::Scalar>::from_f64(2.0) * (t68 + (mu * IAlz_uA));
        t201 = (((((M22_IAxz * t160) - (t179 * M22_IAzz)) + (IAlz_w * t185))
            + (ITzz_w * M22_ITzz)) - (t165 * M22_mu)) + (uA_w * M22_uA);
        t206 = ((t33 * t83) - (ITxz * t164)) - (t139 * t165);
        t207 = ST * t165;
        K222_SF = t54 * t83;
        t214 = (self.mF * mu) + (mA * uA_w);
        t215 = t165 * SA_mu;
        SA_w = t214 - t215;
        C122_ITzz = t83 * mu;
        t225 = (((((K222_SF * t160) + (t83 * IAlz_w)) + (mu * SA_w)) - (t164 * t192))
            + (ITzz_w * C122_ITzz)) - (t165 * C122_mu);
        C122_uA = t83 * IAlz_uA;
        t228 = t225 + (uA_w * C122_uA);
        t233 = (t83 * SA_w) - (t164 * t158);
        t235 = t142 + (t168 * t28);
        t238 = (t83 * M22_mu) - (M22_uA * t28);
        t243 = mA * t28;
        t244 = t83 * SA_mu;
        SA_c = t244 - t243;
        t247 = ((t83 * C122_mu) - (C122_uA * t28)) + (mu * SA_c);
        t249 = t83 * SA_c;
        IAlx_lam = (IAxx * t28) - t117;
        t252 = t54 * t82;
        t253 = self.c * t252;
        t258 = (t28 * zA) + (t54 * t65);
        t260 = (IAlx_lam - (ITxz * t253)) + (t168 * t258);
        IAlz_lam = t53 - (IAzz * t54);
        t272 = ((((IAlz_lam * t185) - (t174 * t118)) + (t28 * (t61 + t91)))
            - (t253 * M22_mu)) - (t258 * M22_uA);
        t278 = t157 + (ST * t253);
        t282 = (mA * t258) + (t253 * SA_mu);
        t290 = ((((t83 * IAlz_lam) - (mu * t282)) - (t252 * t192)) - (t253 * C122_mu))
            - (t258 * C122_uA);
        t297 = (t83 * (t131 - t282)) - (t252 * t158);
        t298 = t137 * <T as ::carvallo::Scalar>::from_f64(2.0);
        t299 = self.IRyy / t9;
        t300 = self.mR - t299;
        t301 = mu * t300;
        t302 = t299 * mu;
        t303 = t83 * t300;
        t304 = self.rR * mu;
        t305 = self.rR * t83;
        t306 = mu * ST_IRyy;
        t307 = t83 * ST_IRyy;
        ITzz_xB = <T as ::carvallo::Scalar>::from_f64(2.0) * t147;
        t310 = ITzz_xB * M22_ITzz;
        SA_xB = self.mB * mu;
        t315 = (mu * SA_xB) + (ITzz_xB * C122_ITzz);
        t317 = t83 * SA_xB;
        t318 = <T as ::carvallo::Scalar>::from_f64(2.0) * t73;
        t323 = self.zB * self.xB;
        t325 = ITzz_mB * M22_ITzz;
        SA_mB = self.xB * mu;
        t332 = (mu * SA_mB) + (ITzz_mB * C122_ITzz);
        t335 = t83 * SA_mB;
        t336 = t37 * self.mH;
        zA_zH = self.mH * t32;
        uA_xH = t28 * zA_zH;
        t344 = self.mH * <T as ::carvallo::Scalar>::from_f64(2.0);
        t345 = t44 * t344;
        t347 = t68 * zA_zH;
        IAlz_xH = (t28 * t345) + t347;
        ITzz_xH = self.xH * t344;
        t358 = ((((IAlz_xH * t185) - (t336 * M22_IAxz)) + (t345 * M22_IAzz))
            + (ITzz_xH * M22_ITzz)) + (uA_xH * M22_uA);
        t361 = self.mH * mu;
        SA_xH = t361 + (mA * uA_xH);
        t371 = ((((t83 * IAlz_xH) + (mu * SA_xH)) - (t336 * K222_SF))
            + (ITzz_xH * C122_ITzz)) + (uA_xH * C122_uA);
        t373 = t83 * SA_xH;
        t374 = self.zH * t344;
        t375 = t37 * t344;
        IAlx_zH = (t54 * t375) - t347;
        t378 = t44 * self.mH;
        t383 = zA_zH * t54;
        t385 = ((IAlx_zH - (t28 * t378)) - (mu * t39)) + (t168 * t383);
        M22_IAxx = t54 * t54;
        t391 = ((t375 * M22_IAxx) - (t378 * M22_IAxz)) - (t383 * M22_uA);
        t394 = mA * t383;
        t400 = t394 * t54;
        t403 = uA * zA;
        t405 = <T as ::carvallo::Scalar>::from_f64(1.0) / (mA * mA);
        t406 = t35 * t405;
        zA_mH = (self.zH * t32) - t406;
        IAlx_mH = (t54 * IAxx_mH) - (t403 + (zA_mH * t68));
        t418 = t42 * t405;
        xA_mH = (self.xH * t32) - t418;
        uA_mH = (t28 * xA_mH) - (zA_mH * t54);
        t424 = ((IAlx_mH - (t28 * t45)) - (mu * t77)) - (t168 * uA_mH);
        IAlz_mA = xA * uA;
        IAlz_mH = (IAlz_mA + (t28 * IAzz_mH)) + (t68 * xA_mH);
        t439 = ((((M22_mA + (IAlz_mH * t185)) + (IAxx_mH * M22_IAxx))
            + (IAzz_mH * M22_IAzz)) + (ITzz_mH * M22_ITzz)) - (t45 * M22_IAxz);
        t441 = t439 + (uA_mH * M22_uA);
        SA_mH = (uA + (self.xH * mu)) + (mA * uA_mH);
        t457 = ((((t83 * IAlz_mH) + (mu * SA_mH)) + (ITzz_mH * C122_ITzz))
            - (t45 * K222_SF)) + (uA_mH * C122_uA);
        t460 = t83 * SA_mH;
        t463 = M22_IAzz + (M22_ITzz + (t28 * t185));
        t465 = C122_ITzz + (t28 * t83);
        t466 = t33 * <T as ::carvallo::Scalar>::from_f64(2.0);
        t467 = t49 * t178;
        IAlx_rF = t183 + (t54 * t467);
        t470 = t48 * self.mF;
        uA_rF = xA_w * t54;
        t477 = ((IAlx_rF - (t28 * t470)) + (mu * ITxz_rF)) - (t168 * uA_rF);
        t482 = ((t467 * M22_IAxx) - (t470 * M22_IAxz)) + (uA_rF * M22_uA);
        t483 = self.IFyy / t24;
        t487 = self.mF - t483;
        t489 = ((t83 * ITxz_rF) - (t28 * t483)) + (mu * t487);
        t490 = t483 * t175;
        SA_rF = mA * uA_rF;
        t496 = ((mu * SA_rF) - (t470 * K222_SF)) + (uA_rF * C122_uA);
        t498 = t83 * t487;
        t501 = (t83 * SA_rF) - (t483 * K222_SF);
        t503 = t406 + (self.rF * t32);
        IAlx_mF = ((t503 * t68) - t403) + (t54 * IAxx_mF);
        ITxz_mF = self.w * self.rF;
        xA_mF = (self.w * t32) - t418;
        uA_mF = (t503 * t54) + (t28 * xA_mF);
        t519 = ((IAlx_mF - (t28 * t50)) + (mu * ITxz_mF)) - (t168 * uA_mF);
        IAlz_mF = (IAlz_mA + (t28 * IAzz_mF)) + (t68 * xA_mF);
        t533 = ((((M22_mA + (IAlz_mF * t185)) + (IAxx_mF * M22_IAxx))
            + (IAzz_mF * M22_IAzz)) + (ITzz_mF * M22_ITzz)) - (t50 * M22_IAxz);
        t535 = t533 + (uA_mF * M22_uA);
        t538 = (self.rF * mu) + (t83 * ITxz_mF);
        SA_mF = (uA + (self.w * mu)) + (mA * uA_mF);
        t551 = ((((t83 * IAlz_mF) + (mu * SA_mF)) + (ITzz_mF * C122_ITzz))
            - (t50 * K222_SF)) + (uA_mF * C122_uA);
        t553 = self.rF * t83;
        t554 = t83 * SA_mF;
        t555 = M22_IAxx + t463;
        t556 = SF_IFyy * t175;
        t557 = t83 * SF_IFyy;
        t558 = SF_IFyy * K222_SF;
        t559 = -(t131 + (mu * ST));
        t560 = -SA;
        t561 = -(SA * t54);
        t562 = t215 - t214;
        t563 = -(SA_w * t54);
        t564 = -(t139 * t164);
        t565 = -(ST * t83);
        t566 = t243 - t244;
        t567 = -(SA_c * t54);
        t568 = -(((ITxz * t252) + (t139 * t253)) + t157);
        t569 = (t54 * t282) - (SA * t28);
        t570 = -(t139 * t252);
        t571 = -self.mR;
        t572 = -self.rR;
        t573 = -t306;
        t574 = -(t73 * mu);
        t575 = -(t73 * t83);
        t576 = -SA_xB;
        t577 = -(SA_xB * t54);
        t578 = -(mu * t147);
        t579 = -(SA_xB + (t83 * t147));
        t580 = -(self.mB * t83);
        t581 = -(mu * t323);
        t582 = -((self.zB * mu) + (t83 * t323));
        t583 = -SA_mB;
        t584 = -(SA_mB * t54);
        t585 = -(self.zB * t83);
        t586 = -(((t28 * t336) + (mu * t34)) + (t168 * uA_xH));
        t587 = -(t83 * t34);
        t588 = -SA_xH;
        let (
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
        );
        t589 = -(SA_xH * t54);
        t590 = -(t361 + (t83 * t39));
        t591 = -(((mu * t394) + (t378 * K222_SF)) + (t383 * C122_uA));
        t592 = -(t83 * self.mH);
        t593 = -(t83 * t394);
        t594 = -((mu * self.zH) + (t83 * t77));
        t595 = -SA_mH;
        t596 = -(SA_mH * t54);
        t597 = -(t83 * self.zH);
        t598 = -self.mF;
        t599 = -SA_rF;
        t600 = -(SA_rF * t54);
        t601 = -self.rF;
        t602 = -SA_mF;
        t603 = -(SA_mF * t54);
        t604 = -t556;
        (
            WhippleMatrices {
                m: [[t26, t86], [t86, t126]],
                c1: [[<T as ::carvallo::Scalar>::from_f64(0.0), t143], [t559, t154]],
                k0: [[t138, t560], [t560, t561]],
                k2: [
                    [<T as ::carvallo::Scalar>::from_f64(0.0), t156],
                    [<T as ::carvallo::Scalar>::from_f64(0.0), t159],
                ],
            },
            WhippleDerivatives {
                values: [
                    t173,
                    t173,
                    t201,
                    t206,
                    t207,
                    t228,
                    t562,
                    t562,
                    t563,
                    t564,
                    t233,
                    t235,
                    t235,
                    t238,
                    t156,
                    t565,
                    t247,
                    t566,
                    t566,
                    t567,
                    t249,
                    t260,
                    t260,
                    t272,
                    t568,
                    t278,
                    t290,
                    t282,
                    t282,
                    t569,
                    t570,
                    t297,
                    t298,
                    t301,
                    t302,
                    t571,
                    t303,
                    t9,
                    t304,
                    t572,
                    t305,
                    <T as ::carvallo::Scalar>::from_f64(1.0),
                    M22_ITzz,
                    C122_ITzz,
                    t306,
                    t573,
                    t307,
                    t574,
                    t574,
                    t310,
                    t575,
                    t315,
                    t576,
                    t576,
                    t577,
                    t317,
                    t318,
                    t578,
                    t578,
                    t579,
                    self.mB,
                    t580,
                    t14,
                    t581,
                    t581,
                    t325,
                    t582,
                    t332,
                    self.zB,
                    t583,
                    t583,
                    t584,
                    t585,
                    t335,
                    <T as ::carvallo::Scalar>::from_f64(1.0),
                    M22_ITzz,
                    C122_ITzz,
                    mu,
                    mu,
                    t83,
                    t586,
                    t586,
                    t358,
                    t587,
                    t371,
                    t588,
                    t588,
                    t589,
                    t373,
                    t374,
                    t385,
                    t385,
                    t391,
                    t590,
                    t591,
                    self.mH,
                    t394,
                    t394,
                    t400,
                    t592,
                    t593,
                    t19,
                    t424,
                    t424,
                    t441,
                    t594,
                    t457,
                    self.zH,
                    t595,
                    t595,
                    t596,
                    t597,
                    t460,
                    <T as ::carvallo::Scalar>::from_f64(1.0),
                    t54,
                    t54,
                    M22_IAxx,
                    t463,
                    t465,
                    t175,
                    t175,
                    M22_IAxz,
                    t83,
                    K222_SF,
                    t466,
                    t477,
                    t477,
                    t482,
                    t489,
                    t490,
                    t496,
                    t598,
                    t599,
                    t599,
                    t600,
                    t498,
                    t501,
                    t24,
                    t519,
                    t519,
                    t535,
                    t538,
                    t551,
                    t601,
                    t602,
                    t602,
                    t603,
                    t553,
                    t554,
                    <T as ::carvallo::Scalar>::from_f64(1.0),
                    t54,
                    t54,
                    t555,
                    t465,
                    t556,
                    t604,
                    t557,
                    t558,
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
