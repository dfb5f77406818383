// @generated from generated/models/whipple_sprung.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: f9b201944e308ecc

/// The Whipple-Carvallo bicycle with a spring and a damper between rear frame and front frame.
///
/// Four rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally
/// symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,
/// x forward, y to the right, z down, so that a centre of mass above the ground has z < 0.
///
/// Source: Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3
///
/// Derived from a mechanism: body `B` (rear frame and rider), body `H` (front frame), wheel `R` (rear wheel), wheel `F` (front wheel).
///
/// The fields are the parameters. The coordinates are `phi` (lean) in rad, `delta` (steer) in rad.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleSprung<T = ::core::primitive::f64> {
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
    /// Stiffness of the steering spring.
    ///
    /// `k` in N*m: >= 0.
    pub k: T,
    /// Damping of the steering damper.
    ///
    /// `d` in N*m*s: >= 0.
    pub d: T,
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl WhippleSprung<::core::primitive::f64> {
    /// The parameter set `benchmark`.
    ///
    /// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; spring and damper are examples
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
        k: 0.5,
        d: 0.25,
    };
    /// The parameter set `benchmark_2005`.
    ///
    /// Source: Schwab, Meijaard & Papadopoulos (2005), ENOC 2005; spring and damper are examples
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
        k: 0.5,
        d: 0.25,
    };
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> WhippleSprung<T> {
    /// The parameters from an array in declared order.
    #[must_use]
    pub const fn from_array(values: [T; 28]) -> Self {
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
            k: values[26],
            d: values[27],
        }
    }
    /// The parameters as an array in declared order.
    #[must_use]
    pub const fn to_array(&self) -> [T; 28] {
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
            self.k,
            self.d,
        ]
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> WhippleSprung<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: ::carvallo::Scalar>(&self) -> WhippleSprung<U> {
        WhippleSprung {
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
            k: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.k)),
            d: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.d)),
        }
    }
}
/// The coefficient matrices of [`WhippleSprung`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleSprungMatrices<T = ::core::primitive::f64> {
    /// Mass matrix M, the coefficient of q''. Symmetric, proved.
    pub m: [[T; 2]; 2],
    /// Damping C0, a coefficient of q'. Symmetric, proved.
    pub c0: [[T; 2]; 2],
    /// Damping C1, a coefficient of v q'.
    pub c1: [[T; 2]; 2],
    /// Stiffness Kc, a coefficient of q. Symmetric, proved.
    pub kc: [[T; 2]; 2],
    /// Stiffness K0, a coefficient of g q. Symmetric, proved.
    pub k0: [[T; 2]; 2],
    /// Stiffness K2, a coefficient of v^2 q.
    pub k2: [[T; 2]; 2],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> WhippleSprung<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 46 additions, 54 multiplications, 3 divisions, 3 negations and 2 trigonometric functions: 108 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleSprungMatrices<T> {
        let Jxx_delta = ((self.IHxx + self.IFxx) + (self.mH * (self.zH * self.zH)))
            + (self.mF * (self.rF * self.rF));
        let t26 = (((self.IRxx + self.IBxx) + Jxx_delta)
            + (self.mR * (self.rR * self.rR))) + (self.mB * (self.zB * self.zB));
        let (t28, t42) = ::carvallo::Number::sin_cos(self.lam);
        let t32 = self.rF * self.mF;
        let t37 = self.w + self.c;
        let t38 = self.xH - t37;
        let t39 = self.mH * t38;
        let Jxz_delta = (self.IHxz - (self.c * t32)) - (self.zH * t39);
        let hx_delta = (Jxx_delta * t28) + (Jxz_delta * t42);
        let yaw_per_v_delta = t42 / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let t50 = self.zB * self.mB;
        let Sz_delta = (self.zH * self.mH) - t32;
        let Jxz_all = ((self.IBxz + Jxz_delta) - (self.xB * t50)) - (Sz_delta * t37);
        let t58 = hx_delta + (yaw_by_delta * Jxz_all);
        let t66 = self.IHzz + self.IFxx;
        let hz_delta = (Jxz_delta * t28)
            + (t42 * (((self.mH * (t38 * t38)) + (self.mF * (self.c * self.c))) + t66));
        let Sx_delta = t39 - (self.c * self.mF);
        let py_delta = (Sx_delta * t42) - (Sz_delta * t28);
        let M_yaw_delta = hz_delta + (py_delta * t37);
        let t89 = yaw_by_delta
            * (((((self.IRxx + self.IBzz) + t66) + (self.mB * (self.xB * self.xB)))
                + (self.mH * (self.xH * self.xH))) + (self.mF * (self.w * self.w)));
        let P_delta_yaw = M_yaw_delta + t89;
        let t96 = ((yaw_by_delta * (M_yaw_delta + P_delta_yaw)) + (hx_delta * t28))
            + (hz_delta * t42);
        let h_spin_F = self.IFyy / self.rF;
        let h_wheels_all = h_spin_F + (self.IRyy / self.rR);
        let Sz_all = (Sz_delta + t50) - (self.rR * self.mR);
        let t107 = h_wheels_all - Sz_all;
        let t111 = h_spin_F * t42;
        let t112 = ((yaw_by_delta * t107) + (yaw_per_v_delta * Jxz_all)) + t111;
        let Sx_all = (Sx_delta + (self.xB * self.mB)) + (t37 * (self.mH + self.mF));
        let P_delta_lateral = py_delta + (yaw_by_delta * Sx_all);
        let t124 = (yaw_by_delta * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
        let t127 = yaw_per_v_delta * t107;
        let t130 = yaw_per_v_delta * (P_delta_lateral + (h_spin_F * t28));
        let t131 = -(t111 + (yaw_by_delta * h_wheels_all));
        let t132 = -P_delta_lateral;
        let t133 = -(t28 * P_delta_lateral);
        WhippleSprungMatrices {
            m: [[t26, t58], [t58, t96]],
            c0: [
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                [::carvallo::Number::like(self.w, 0.0), self.d],
            ],
            c1: [[::carvallo::Number::like(self.w, 0.0), t112], [t131, t124]],
            kc: [
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                [::carvallo::Number::like(self.w, 0.0), self.k],
            ],
            k0: [[Sz_all, t132], [t132, t133]],
            k2: [
                [::carvallo::Number::like(self.w, 0.0), t127],
                [::carvallo::Number::like(self.w, 0.0), t130],
            ],
        }
    }
}
/// Rates and forces of [`WhippleSprung`] that follow from its coordinates q = (`phi`, `delta`), to first order and in SI units.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleSprungKinematics<T = ::core::primitive::f64> {
    /// Lateral velocity, to the right, in m/s: of the point of `B` that is at the origin.
    pub lateral: ::carvallo::Rate<T, 2>,
    /// Yaw rate, to the right, in rad/s: of `B`.
    pub yaw: ::carvallo::Rate<T, 2>,
    /// Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_R: ::carvallo::Rate<T, 2>,
    /// Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in rad/s.
    pub wheel_F: ::carvallo::Rate<T, 2>,
    /// The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of `Tphi` (lean torque) in N*m, `Tdelta` (steer torque) in N*m.
    pub forces: [[T; 2]; 2],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> WhippleSprung<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> WhippleSprungKinematics<T> {
        let yaw_per_v_delta = (::carvallo::Number::cos(self.lam)) / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let t12 = -(::carvallo::Number::like(self.w, 1.0) / self.rR);
        let t13 = -(::carvallo::Number::like(self.w, 1.0) / self.rF);
        WhippleSprungKinematics {
            lateral: ::carvallo::Rate {
                speed: ::carvallo::Number::like(self.w, 0.0),
                rates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                coordinates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                heading: ::carvallo::Number::like(self.w, 1.0),
            },
            yaw: ::carvallo::Rate {
                speed: ::carvallo::Number::like(self.w, 0.0),
                rates: [::carvallo::Number::like(self.w, 0.0), yaw_by_delta],
                coordinates: [::carvallo::Number::like(self.w, 0.0), yaw_per_v_delta],
                heading: ::carvallo::Number::like(self.w, 0.0),
            },
            wheel_R: ::carvallo::Rate {
                speed: t12,
                rates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                coordinates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                heading: ::carvallo::Number::like(self.w, 0.0),
            },
            wheel_F: ::carvallo::Rate {
                speed: t13,
                rates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                coordinates: [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                heading: ::carvallo::Number::like(self.w, 0.0),
            },
            forces: [
                [
                    ::carvallo::Number::like(self.w, 1.0),
                    ::carvallo::Number::like(self.w, 0.0),
                ],
                [
                    ::carvallo::Number::like(self.w, 0.0),
                    ::carvallo::Number::like(self.w, 1.0),
                ],
            ],
        }
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Model<2> for WhippleSprung<T> {
    type Scalar = T;
    type Array<U: ::core::marker::Copy> = [U; 28];
    type Over<U: ::carvallo::Number> = WhippleSprung<U>;
    const INFO: &'static ::carvallo::ModelInfo = &::carvallo::ModelInfo {
        name: "WhippleSprung",
        docs: "The Whipple-Carvallo bicycle with a spring and a damper between rear frame and front frame.\n\nFour rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally\nsymmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,\nx forward, y to the right, z down, so that a centre of mass above the ground has z < 0.",
        source: "Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3",
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
            ::carvallo::ParameterInfo {
                name: "k",
                symbol: "k",
                docs: "Stiffness of the steering spring.",
                unit: "N*m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "d",
                symbol: "d",
                docs: "Damping of the steering damper.",
                unit: "N*m*s",
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
        matrices: &["M", "C0", "C1", "Kc", "K0", "K2"],
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
                places: &[("C0", 1, 1)],
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
                places: &[("Kc", 1, 1)],
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
                source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; spring and damper are examples",
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
                    0.5,
                    0.25,
                ],
            },
            ::carvallo::SetInfo {
                name: "benchmark_2005",
                docs: "",
                source: "Schwab, Meijaard & Papadopoulos (2005), ENOC 2005; spring and damper are examples",
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
                    0.5,
                    0.25,
                ],
            },
        ],
        gravity: ::core::option::Option::Some(3),
    };
    fn from_slice(
        values: &[T],
    ) -> ::core::result::Result<Self, ::carvallo::LengthError> {
        if values.len() != 28 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "WhippleSprung",
                expected: 28,
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
            k: values[26],
            d: values[27],
        })
    }
    fn write_to(
        &self,
        values: &mut [T],
    ) -> ::core::result::Result<(), ::carvallo::LengthError> {
        if values.len() != 28 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "WhippleSprung",
                expected: 28,
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
                ::carvallo::Scalar::to_f64(self.k),
                ::carvallo::Scalar::to_f64(self.d),
            ],
        )?;
        ::core::result::Result::Ok(())
    }
    #[inline]
    fn coefficients(&self) -> ::carvallo::Coefficients<T, 2> {
        let matrices = self.matrices();
        ::carvallo::Coefficients::from_rows([
            matrices.m,
            matrices.c0,
            matrices.c1,
            matrices.kc,
            matrices.k0,
            matrices.k2,
        ])
    }
    fn gravity(&self) -> ::core::option::Option<T> {
        ::core::option::Option::Some(self.g)
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> ::carvallo::Evaluator<T, 2> for WhippleSprung<T> {
    type Entries = [T; 13];
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
            k: parameter(26),
            d: parameter(27),
        }
    }
    #[inline(always)]
    fn entries(&self) -> Self::Entries {
        let matrices = self.matrices();
        [
            matrices.m[0][0],
            matrices.m[0][1],
            matrices.m[1][1],
            matrices.c0[1][1],
            matrices.c1[0][1],
            matrices.c1[1][0],
            matrices.c1[1][1],
            matrices.kc[1][1],
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
        [matrices.m, matrices.c0, matrices.c1, matrices.kc, matrices.k0, matrices.k2]
    }
}
/// The derivatives of the matrices of [`WhippleSprung`] with respect to its parameters, in SI units: those that are not zero for all parameters.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleSprungDerivatives<T = ::core::primitive::f64> {
    /// The value of each derivative in [`Self::PARTIALS`].
    pub values: [T; 160],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl WhippleSprungDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [::carvallo::Partial; 160] = &[
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
        ::carvallo::Partial::new(::carvallo::MatrixName::Kc, 1, 1, 26),
        ::carvallo::Partial::new(::carvallo::MatrixName::C0, 1, 1, 27),
    ];
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> WhippleSprungDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(
        &self,
        parameter: ::core::primitive::usize,
    ) -> ::core::option::Option<WhippleSprungMatrices<T>> {
        if parameter >= 28 {
            return ::core::option::Option::None;
        }
        let zero = <T as ::carvallo::Scalar>::from_f64(0.0);
        let mut matrices = WhippleSprungMatrices {
            m: [[zero; 2]; 2],
            c0: [[zero; 2]; 2],
            c1: [[zero; 2]; 2],
            kc: [[zero; 2]; 2],
            k0: [[zero; 2]; 2],
            k2: [[zero; 2]; 2],
        };
        for position in 0..160 {
            let partial = <WhippleSprungDerivatives>::PARTIALS[position];
            if partial.parameter != parameter {
                continue;
            }
            let matrix = match partial.matrix {
                ::carvallo::MatrixName::M => &mut matrices.m,
                ::carvallo::MatrixName::C0 => &mut matrices.c0,
                ::carvallo::MatrixName::C1 => &mut matrices.c1,
                ::carvallo::MatrixName::Kc => &mut matrices.kc,
                ::carvallo::MatrixName::K0 => &mut matrices.k0,
                ::carvallo::MatrixName::K2 => &mut matrices.k2,
            };
            matrix[partial.row][partial.column] = self.values[position];
        }
        ::core::option::Option::Some(matrices)
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> WhippleSprung<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 162 additions, 278 multiplications, 3 divisions, 46 negations and 2 trigonometric functions: 491 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(
        &self,
    ) -> (WhippleSprungMatrices<T>, WhippleSprungDerivatives<T>) {
        let Jxx_delta_mH = self.zH * self.zH;
        let Jxx_delta_mF = self.rF * self.rF;
        let Jxx_delta = ((self.IHxx + self.IFxx) + (self.mH * Jxx_delta_mH))
            + (self.mF * Jxx_delta_mF);
        let t19 = self.rR * self.rR;
        let t24 = self.zB * self.zB;
        let t26 = (((self.IRxx + self.IBxx) + Jxx_delta) + (self.mR * t19))
            + (self.mB * t24);
        let (t28, t43) = ::carvallo::Number::sin_cos(self.lam);
        let t31 = self.rF * self.mF;
        let t38 = self.w + self.c;
        let t39 = self.xH - t38;
        let t40 = self.mH * t39;
        let Jxz_delta = (self.IHxz - (t31 * self.c)) - (t40 * self.zH);
        let t44 = Jxz_delta * t43;
        let hx_delta = (Jxx_delta * t28) + t44;
        let t46 = ::carvallo::Number::like(self.w, 1.0) / self.w;
        let yaw_per_v_delta = t43 * t46;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let t52 = self.zB * self.mB;
        let t55 = self.zH * self.mH;
        let Sz_delta = t55 - t31;
        let Jxz_all = ((self.IBxz + Jxz_delta) - (self.xB * t52)) - (t38 * Sz_delta);
        let t60 = hx_delta + (yaw_by_delta * Jxz_all);
        let t62 = t28 * Jxz_delta;
        let t64 = self.IHzz + self.IFxx;
        let t65 = t39 * t39;
        let t68 = self.c * self.c;
        let t70 = (t64 + (self.mH * t65)) + (self.mF * t68);
        let hz_delta = t62 + (t43 * t70);
        let Sx_delta = t40 - (self.mF * self.c);
        let py_delta = (t43 * Sx_delta) - (Sz_delta * t28);
        let M_yaw_delta = hz_delta + (t38 * py_delta);
        let t85 = self.xB * self.xB;
        let t88 = self.xH * self.xH;
        let t91 = self.w * self.w;
        let P_delta_yaw_yaw_by_delta = ((((self.IRxx + self.IBzz) + t64)
            + (self.mB * t85)) + (self.mH * t88)) + (self.mF * t91);
        let t94 = yaw_by_delta * P_delta_yaw_yaw_by_delta;
        let P_delta_yaw = M_yaw_delta + t94;
        let t96 = M_yaw_delta + P_delta_yaw;
        let t98 = ((t28 * hx_delta) + (t43 * hz_delta)) + (yaw_by_delta * t96);
        let t102 = ::carvallo::Number::like(self.w, 1.0) / self.rF;
        let h_spin_F = self.IFyy * t102;
        let t104 = t43 * h_spin_F;
        let t106 = ::carvallo::Number::like(self.w, 1.0) / self.rR;
        let h_wheels_all = h_spin_F + (self.IRyy * t106);
        let t110 = self.rR * self.mR;
        let Sz_all = (t52 + Sz_delta) - t110;
        let t112 = h_wheels_all - Sz_all;
        let t115 = yaw_per_v_delta * Jxz_all;
        let t116 = (t104 + (yaw_by_delta * t112)) + t115;
        let t120 = self.xB * self.mB;
        let t122 = self.mH + self.mF;
        let Sx_all = (Sx_delta + t120) + (t38 * t122);
        let P_delta_lateral = py_delta + (yaw_by_delta * Sx_all);
        let t128 = (yaw_per_v_delta * P_delta_yaw) + (yaw_by_delta * P_delta_lateral);
        let t131 = yaw_per_v_delta * t112;
        let t132 = t28 * h_spin_F;
        let K222_yaw_per_v_delta = P_delta_lateral + t132;
        let t134 = yaw_per_v_delta * K222_yaw_per_v_delta;
        let t135 = t43 * t55;
        let t137 = t135 + (yaw_by_delta * t55);
        let t139 = (yaw_by_delta * Sz_delta) - t137;
        let t141 = t43 * (t46 * t46);
        let t142 = self.c * Jxz_all;
        let t146 = self.mH * t43;
        let t148 = yaw_by_delta * ::carvallo::Number::like(self.w, 2.0);
        let M22_py_delta = t38 * t148;
        let t152 = self.mH * ::carvallo::Number::like(self.w, 2.0);
        let t153 = t39 * t43;
        let t156 = (t152 * t153) - (t28 * t55);
        let M22_hz_delta = t43 + t148;
        let t159 = ((t146 * M22_py_delta) - (t28 * t135)) + (t156 * M22_hz_delta);
        let t161 = (py_delta * t148) - t159;
        let P_delta_yaw_w = (self.w * self.mF) * t148;
        let M22_yaw_by_delta = t94 + t96;
        let M22_yaw_per_v_delta = self.c * M22_yaw_by_delta;
        let t169 = (t161 + (yaw_by_delta * P_delta_yaw_w))
            - (t141 * M22_yaw_per_v_delta);
        let t170 = yaw_per_v_delta * t55;
        let t172 = (yaw_per_v_delta * Sz_delta) - t170;
        let C112_yaw_per_v_delta = Jxz_all + (self.c * t112);
        let t177 = h_wheels_all * self.c;
        let t178 = t141 * t177;
        let C122_py_delta = t38 * yaw_per_v_delta;
        let t182 = (yaw_per_v_delta * t156) + (t146 * C122_py_delta);
        let t184 = (yaw_per_v_delta * py_delta) - t182;
        let t188 = self.mH * yaw_by_delta;
        let t189 = t146 + t188;
        let t190 = (yaw_by_delta * t122) - t189;
        let P_delta_lateral_yaw_per_v_delta = self.c * Sx_all;
        let t192 = t141 * P_delta_lateral_yaw_per_v_delta;
        let P_delta_lateral_w = t190 - t192;
        let C122_yaw_by_delta = P_delta_lateral
            + (yaw_per_v_delta * P_delta_yaw_yaw_by_delta);
        let C122_yaw_per_v_delta = P_delta_yaw + (self.c * C122_yaw_by_delta);
        let t201 = ((t184 + (yaw_per_v_delta * P_delta_yaw_w))
            + (yaw_by_delta * P_delta_lateral_w)) - (t141 * C122_yaw_per_v_delta);
        let t206 = (yaw_per_v_delta * P_delta_lateral_w) - (t141 * K222_yaw_per_v_delta);
        let t207 = t31 * t43;
        let t211 = (t115 - (t207 + t139)) - (t31 * yaw_by_delta);
        let t216 = self.mF * t43;
        let t220 = self.c * t43;
        let t221 = self.mF * ::carvallo::Number::like(self.w, 2.0);
        let hz_delta_c = (t220 * t221) - (t31 * t28);
        let t225 = (((t161 - (t28 * t207)) + (yaw_per_v_delta * M22_yaw_by_delta))
            - (t216 * M22_py_delta)) + (hz_delta_c * M22_hz_delta);
        let t228 = (yaw_per_v_delta * (t112 - t31)) - t172;
        let P_delta_lateral_c = ((t190 - t216) - (self.mF * yaw_by_delta))
            + (yaw_per_v_delta * Sx_all);
        let t241 = ((t184 + (yaw_per_v_delta * (hz_delta_c + C122_yaw_by_delta)))
            + (yaw_by_delta * P_delta_lateral_c)) - (t216 * C122_py_delta);
        let t243 = yaw_per_v_delta * P_delta_lateral_c;
        let hx_delta_lam = (Jxx_delta * t43) - t62;
        let t246 = t46 * t28;
        let t248 = hx_delta_lam - (t246 * t142);
        let t256 = (t43 * Sz_delta) + (Sx_delta * t28);
        let hz_delta_lam = t44 - (t28 * t70);
        let t264 = (((((t28 * hx_delta_lam) + (hx_delta * t43)) - (hz_delta * t28))
            - (t256 * M22_py_delta)) + (hz_delta_lam * M22_hz_delta))
            - (t246 * M22_yaw_per_v_delta);
        let t268 = t132 + (t246 * t177);
        let t271 = t256 + (t246 * P_delta_lateral_yaw_per_v_delta);
        let t277 = (((yaw_per_v_delta * hz_delta_lam) - (yaw_by_delta * t271))
            - (t256 * C122_py_delta)) - (t246 * C122_yaw_per_v_delta);
        let t284 = (yaw_per_v_delta * (t104 - t271)) - (t246 * K222_yaw_per_v_delta);
        let t285 = t110 * ::carvallo::Number::like(self.w, 2.0);
        let t287 = self.IRyy * (t106 * t106);
        let t288 = self.mR - t287;
        let t289 = yaw_by_delta * t288;
        let t290 = t287 * yaw_by_delta;
        let t291 = yaw_per_v_delta * t288;
        let t292 = self.rR * yaw_by_delta;
        let t293 = self.rR * yaw_per_v_delta;
        let t294 = yaw_by_delta * yaw_by_delta;
        let t295 = yaw_per_v_delta * yaw_by_delta;
        let t296 = yaw_by_delta * t106;
        let t297 = yaw_per_v_delta * t106;
        let P_delta_yaw_xB = t120 * t148;
        let t300 = yaw_by_delta * P_delta_yaw_xB;
        let P_delta_lateral_xB = self.mB * yaw_by_delta;
        let t305 = (yaw_per_v_delta * P_delta_yaw_xB)
            + (yaw_by_delta * P_delta_lateral_xB);
        let t307 = yaw_per_v_delta * P_delta_lateral_xB;
        let t308 = ::carvallo::Number::like(self.w, 2.0) * t52;
        let P_delta_lateral_mB = self.xB * yaw_by_delta;
        let t312 = yaw_by_delta + (self.xB * yaw_per_v_delta);
        let P_delta_yaw_mB = yaw_by_delta * t85;
        let t317 = yaw_by_delta * P_delta_yaw_mB;
        let t321 = (yaw_per_v_delta * P_delta_yaw_mB)
            + (yaw_by_delta * P_delta_lateral_mB);
        let t324 = yaw_per_v_delta * P_delta_lateral_mB;
        let P_delta_yaw_xH = (self.xH * self.mH) * t148;
        let t328 = t159 + (yaw_by_delta * P_delta_yaw_xH);
        let t332 = (t182 + (yaw_per_v_delta * P_delta_yaw_xH)) + (yaw_by_delta * t189);
        let t334 = yaw_per_v_delta * t189;
        let Jxx_delta_zH = self.zH * t152;
        let hx_delta_zH = (t28 * Jxx_delta_zH) - (t40 * t43);
        let t340 = t40 + (self.mH * t38);
        let t342 = hx_delta_zH - (yaw_by_delta * t340);
        let t344 = self.mH * t28;
        let t347 = t40 * t28;
        let t349 = ((t28 * hx_delta_zH) - (t344 * M22_py_delta)) - (t347 * M22_hz_delta);
        let t357 = t344 * t28;
        let t361 = t39 * self.zH;
        let hx_delta_mH = (t28 * Jxx_delta_mH) - (t43 * t361);
        let t365 = t361 + (t38 * self.zH);
        let t367 = hx_delta_mH - (yaw_by_delta * t365);
        let P_delta_yaw_mH = yaw_by_delta * t88;
        let py_delta_mH = t153 - (self.zH * t28);
        let hz_delta_mH = (t43 * t65) - (t28 * t361);
        let t380 = (((t28 * hx_delta_mH) + (yaw_by_delta * P_delta_yaw_mH))
            + (py_delta_mH * M22_py_delta)) + (hz_delta_mH * M22_hz_delta);
        let P_delta_lateral_mH = py_delta_mH + (yaw_by_delta * (t38 + t39));
        let t392 = ((yaw_per_v_delta * (P_delta_yaw_mH + hz_delta_mH))
            + (yaw_by_delta * P_delta_lateral_mH)) + (py_delta_mH * C122_py_delta);
        let t395 = yaw_per_v_delta * P_delta_lateral_mH;
        let t396 = t28 * t28;
        let t398 = (t43 * M22_hz_delta) + t294;
        let C112_h_spin_F = t43 + yaw_by_delta;
        let t400 = yaw_per_v_delta * C112_h_spin_F;
        let t402 = t28 * (t43 + M22_hz_delta);
        let K222_h_spin_F = t28 * yaw_per_v_delta;
        let Jxx_delta_rF = self.rF * t221;
        let hx_delta_rF = (t28 * Jxx_delta_rF) - (self.mF * t220);
        let t408 = t38 - self.c;
        let t409 = yaw_by_delta * t408;
        let t411 = hx_delta_rF + (self.mF * t409);
        let py_delta_rF = self.mF * t28;
        let t416 = self.c * t28;
        let t417 = self.mF * t416;
        let t419 = ((t28 * hx_delta_rF) + (py_delta_rF * M22_py_delta))
            - (t417 * M22_hz_delta);
        let t421 = yaw_by_delta + (yaw_per_v_delta * t408);
        let t424 = self.IFyy * (t102 * t102);
        let t425 = t424 * C112_h_spin_F;
        let t426 = (self.mF * t421) - t425;
        let t431 = ((yaw_by_delta * py_delta_rF) - (yaw_per_v_delta * t417))
            + (py_delta_rF * C122_py_delta);
        let t434 = yaw_per_v_delta * (self.mF - t424);
        let t437 = (yaw_per_v_delta * py_delta_rF) - (t424 * K222_h_spin_F);
        let hx_delta_mF = (t28 * Jxx_delta_mF) - (self.rF * t220);
        let t442 = hx_delta_mF + (self.rF * t409);
        let P_delta_yaw_mF = yaw_by_delta * t91;
        let py_delta_mF = (self.rF * t28) - t220;
        let hz_delta_mF = (t43 * t68) - (self.rF * t416);
        let t455 = (((t28 * hx_delta_mF) + (yaw_by_delta * P_delta_yaw_mF))
            + (py_delta_mF * M22_py_delta)) + (hz_delta_mF * M22_hz_delta);
        let t456 = self.rF * t421;
        let P_delta_lateral_mF = py_delta_mF + t409;
        let t463 = ((yaw_per_v_delta * (P_delta_yaw_mF + hz_delta_mF))
            + (yaw_by_delta * P_delta_lateral_mF)) + (py_delta_mF * C122_py_delta);
        let t465 = self.rF * yaw_per_v_delta;
        let t466 = yaw_per_v_delta * P_delta_lateral_mF;
        let t467 = t398 + t396;
        let t468 = t102 * C112_h_spin_F;
        let t469 = yaw_per_v_delta * t102;
        let t470 = t102 * K222_h_spin_F;
        let t471 = -(t104 + (yaw_by_delta * h_wheels_all));
        let t472 = -P_delta_lateral;
        let t473 = -(P_delta_lateral * t28);
        let t474 = -(t139 + (t141 * t142));
        let t475 = -(t172 + (t141 * C112_yaw_per_v_delta));
        let t476 = t192 - t190;
        let t477 = -(P_delta_lateral_w * t28);
        let t478 = -(t112 * t141);
        let t479 = -(h_wheels_all * yaw_per_v_delta);
        let t480 = -P_delta_lateral_c;
        let t481 = -(P_delta_lateral_c * t28);
        let t482 = -(t132 + (t246 * C112_yaw_per_v_delta));
        let t483 = (t28 * t271) - (P_delta_lateral * t43);
        let t484 = -(t112 * t246);
        let t485 = -self.mR;
        let t486 = -self.rR;
        let t487 = -t296;
        let t488 = -(t52 * yaw_by_delta);
        let t489 = -(t52 * yaw_per_v_delta);
        let t490 = -P_delta_lateral_xB;
        let t491 = -(P_delta_lateral_xB * t28);
        let t492 = -(self.mB * P_delta_lateral_mB);
        let t493 = -(self.mB * t312);
        let t494 = -(self.mB * yaw_per_v_delta);
        let t495 = -(self.zB * P_delta_lateral_mB);
        let t496 = -(self.zB * t312);
        let t497 = -P_delta_lateral_mB;
        let t498 = -(P_delta_lateral_mB * t28);
        let t499 = -(self.zB * yaw_per_v_delta);
        let t500 = -t137;
        let t501 = -t170;
        let t502 = -t189;
        let t503 = -(t189 * t28);
        let t504 = -(t188 + (yaw_per_v_delta * t340));
        let t505 = -(((yaw_per_v_delta * t347) + (yaw_by_delta * t344))
            + (t344 * C122_py_delta));
        let t506 = -(self.mH * yaw_per_v_delta);
        let t507 = -(yaw_per_v_delta * t344);
        let t508 = -((self.zH * yaw_by_delta) + (yaw_per_v_delta * t365));
        let t509 = -P_delta_lateral_mH;
        let t510 = -(P_delta_lateral_mH * t28);
        let t511 = -(self.zH * yaw_per_v_delta);
        let t512 = -self.mF;
        let t513 = -py_delta_rF;
        let t514 = -(py_delta_rF * t28);
        let t515 = -self.rF;
        let t516 = -P_delta_lateral_mF;
        let t517 = -(P_delta_lateral_mF * t28);
        let t518 = -t468;
        (
            WhippleSprungMatrices {
                m: [[t26, t60], [t60, t98]],
                c0: [
                    [
                        ::carvallo::Number::like(self.w, 0.0),
                        ::carvallo::Number::like(self.w, 0.0),
                    ],
                    [::carvallo::Number::like(self.w, 0.0), self.d],
                ],
                c1: [[::carvallo::Number::like(self.w, 0.0), t116], [t471, t128]],
                kc: [
                    [
                        ::carvallo::Number::like(self.w, 0.0),
                        ::carvallo::Number::like(self.w, 0.0),
                    ],
                    [::carvallo::Number::like(self.w, 0.0), self.k],
                ],
                k0: [[Sz_all, t472], [t472, t473]],
                k2: [
                    [::carvallo::Number::like(self.w, 0.0), t131],
                    [::carvallo::Number::like(self.w, 0.0), t134],
                ],
            },
            WhippleSprungDerivatives {
                values: [
                    t474,
                    t474,
                    t169,
                    t475,
                    t178,
                    t201,
                    t476,
                    t476,
                    t477,
                    t478,
                    t206,
                    t211,
                    t211,
                    t225,
                    t228,
                    t479,
                    t241,
                    t480,
                    t480,
                    t481,
                    t243,
                    t248,
                    t248,
                    t264,
                    t482,
                    t268,
                    t277,
                    t271,
                    t271,
                    t483,
                    t484,
                    t284,
                    t285,
                    t289,
                    t290,
                    t485,
                    t291,
                    t19,
                    t292,
                    t486,
                    t293,
                    ::carvallo::Number::like(self.w, 1.0),
                    t294,
                    t295,
                    t296,
                    t487,
                    t297,
                    t488,
                    t488,
                    t300,
                    t489,
                    t305,
                    t490,
                    t490,
                    t491,
                    t307,
                    t308,
                    t492,
                    t492,
                    t493,
                    self.mB,
                    t494,
                    t24,
                    t495,
                    t495,
                    t317,
                    t496,
                    t321,
                    self.zB,
                    t497,
                    t497,
                    t498,
                    t499,
                    t324,
                    ::carvallo::Number::like(self.w, 1.0),
                    t294,
                    t295,
                    yaw_by_delta,
                    yaw_by_delta,
                    yaw_per_v_delta,
                    t500,
                    t500,
                    t328,
                    t501,
                    t332,
                    t502,
                    t502,
                    t503,
                    t334,
                    Jxx_delta_zH,
                    t342,
                    t342,
                    t349,
                    t504,
                    t505,
                    self.mH,
                    t344,
                    t344,
                    t357,
                    t506,
                    t507,
                    Jxx_delta_mH,
                    t367,
                    t367,
                    t380,
                    t508,
                    t392,
                    self.zH,
                    t509,
                    t509,
                    t510,
                    t511,
                    t395,
                    ::carvallo::Number::like(self.w, 1.0),
                    t28,
                    t28,
                    t396,
                    t398,
                    t400,
                    C112_h_spin_F,
                    C112_h_spin_F,
                    t402,
                    yaw_per_v_delta,
                    K222_h_spin_F,
                    Jxx_delta_rF,
                    t411,
                    t411,
                    t419,
                    t426,
                    t425,
                    t431,
                    t512,
                    t513,
                    t513,
                    t514,
                    t434,
                    t437,
                    Jxx_delta_mF,
                    t442,
                    t442,
                    t455,
                    t456,
                    t463,
                    t515,
                    t516,
                    t516,
                    t517,
                    t465,
                    t466,
                    ::carvallo::Number::like(self.w, 1.0),
                    t28,
                    t28,
                    t467,
                    t400,
                    t468,
                    t518,
                    t469,
                    t470,
                    ::carvallo::Number::like(self.w, 1.0),
                    ::carvallo::Number::like(self.w, 1.0),
                ],
            },
        )
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Differentiable<2> for WhippleSprung<T> {
    type Derivatives = [::carvallo::Coefficients<T, 2>; 28];
    fn coefficients_and_derivatives(
        &self,
    ) -> (::carvallo::Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let mut all = [::carvallo::Coefficients::from_rows(
            [[[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2]; 6],
        ); 28];
        for position in 0..160 {
            <WhippleSprungDerivatives>::PARTIALS[position]
                .write(derivatives.values[position], &mut all);
        }
        (
            ::carvallo::Coefficients::from_rows([
                matrices.m,
                matrices.c0,
                matrices.c1,
                matrices.kc,
                matrices.k0,
                matrices.k2,
            ]),
            all,
        )
    }
}
