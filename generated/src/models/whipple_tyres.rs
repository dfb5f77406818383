// @generated from generated/models/whipple_tyres.rs by carvallo-compiler 0.1.0; do not edit.
// To write it anew: cargo regenerate
// Hash of the source: 6e6bda8fcc5ab6a5

/// The Whipple-Carvallo bicycle on tyres whose cross-sections are circles.
///
/// Four rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally
/// symmetric. The rims of the wheels are parts of tori that roll without slip on level ground: the radii rR and rF of
/// the wheels reach from the centre to the ground, and those of the cross-sections, rhoR and rhoF, are parts of them.
/// Axes: origin at the rear contact point, x forward, y to the right, z down.
///
/// Source: Mechanism: Meijaard & Schwab (2006), Linearized equations for an extended bicycle model, III European Conference on Computational Mechanics
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
pub struct WhippleTyres<T = ::core::primitive::f64> {
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
    /// Radius of the cross-section of the rear tyre.
    ///
    /// `rhoR` in m: >= 0.
    pub rhoR: T,
    /// Radius of the cross-section of the front tyre.
    ///
    /// `rhoF` in m: >= 0.
    pub rhoF: T,
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl WhippleTyres<::core::primitive::f64> {
    /// The parameter set `benchmark`.
    ///
    /// Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; tyres are examples
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
        rhoR: 0.02,
        rhoF: 0.02,
    };
    /// The parameter set `benchmark_2005`.
    ///
    /// Source: Schwab, Meijaard & Papadopoulos (2005), ENOC 2005; tyres are examples
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
        rhoR: 0.02,
        rhoF: 0.02,
    };
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Number> WhippleTyres<T> {
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
            rhoR: values[26],
            rhoF: values[27],
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
            self.rhoR,
            self.rhoF,
        ]
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> WhippleTyres<T> {
    /// The same parameters in another number type, each rounded to the nearest.
    #[must_use]
    pub fn cast<U: ::carvallo::Scalar>(&self) -> WhippleTyres<U> {
        WhippleTyres {
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
            rhoR: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.rhoR)),
            rhoF: ::carvallo::Scalar::from_f64(::carvallo::Scalar::to_f64(self.rhoF)),
        }
    }
}
/// The coefficient matrices of [`WhippleTyres`], each 2 x 2 and row by row, in SI units.
///
/// Matrices that are not among them are zero.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleTyresMatrices<T = ::core::primitive::f64> {
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
impl<T: ::carvallo::Number> WhippleTyres<T> {
    /// The coefficient matrices, from one straight-line program:
    /// 54 additions, 61 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 122 operations.
    ///
    /// The parameters are not validated.
    #[inline(always)]
    #[must_use]
    pub fn matrices(&self) -> WhippleTyresMatrices<T> {
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
        let t45 = ::carvallo::Number::like(self.w, 1.0) / self.w;
        let yaw_per_v_delta = t42 * t45;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let t51 = self.zB * self.mB;
        let Sz_delta = (self.zH * self.mH) - t32;
        let Jxz_all = ((self.IBxz + Jxz_delta) - (self.xB * t51)) - (Sz_delta * t37);
        let t59 = hx_delta + (yaw_by_delta * Jxz_all);
        let t67 = self.IHzz + self.IFxx;
        let hz_delta = (Jxz_delta * t28)
            + (t42 * (((self.mH * (t38 * t38)) + (self.mF * (self.c * self.c))) + t67));
        let Sx_delta = t39 - (self.c * self.mF);
        let py_delta = (Sx_delta * t42) - (Sz_delta * t28);
        let M_yaw_delta = hz_delta + (py_delta * t37);
        let t90 = yaw_by_delta
            * (((((self.IRxx + self.IBzz) + t67) + (self.mB * (self.xB * self.xB)))
                + (self.mH * (self.xH * self.xH))) + (self.mF * (self.w * self.w)));
        let P_delta_yaw = M_yaw_delta + t90;
        let t97 = ((yaw_by_delta * (M_yaw_delta + P_delta_yaw)) + (hx_delta * t28))
            + (hz_delta * t42);
        let h_spin_F = self.IFyy / self.rF;
        let h_wheels_all = h_spin_F + (self.IRyy / self.rR);
        let Sz_all = (Sz_delta + t51) - (self.rR * self.mR);
        let t107 = h_wheels_all - Sz_all;
        let t111 = h_spin_F * t42;
        let t112 = ((yaw_by_delta * t107) + (yaw_per_v_delta * Jxz_all)) + t111;
        let m_delta = self.mH + self.mF;
        let Sx_all = (Sx_delta + (self.xB * self.mB)) + (m_delta * t37);
        let P_delta_lateral = py_delta + (yaw_by_delta * Sx_all);
        let t124 = (yaw_by_delta * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
        let t126 = Sx_all * t45;
        let t134 = (Sz_all + (self.rhoF * t126))
            + (self.rhoR * (((self.mR + self.mB) + m_delta) - t126));
        let t138 = t126 * ((self.rhoF * t28) - (self.c * t42));
        let t141 = yaw_per_v_delta * t107;
        let t144 = yaw_per_v_delta * (P_delta_lateral + (h_spin_F * t28));
        let t145 = -(t111 + (yaw_by_delta * h_wheels_all));
        let t146 = t138 - py_delta;
        let t147 = -(t28 * (py_delta - t138));
        WhippleTyresMatrices {
            m: [[t26, t59], [t59, t97]],
            c1: [[::carvallo::Number::like(self.w, 0.0), t112], [t145, t124]],
            k0: [[t134, t146], [t146, t147]],
            k2: [
                [::carvallo::Number::like(self.w, 0.0), t141],
                [::carvallo::Number::like(self.w, 0.0), t144],
            ],
        }
    }
}
/// Rates and forces of [`WhippleTyres`] that follow from its coordinates q = (`phi`, `delta`), to first order and in SI units.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleTyresKinematics<T = ::core::primitive::f64> {
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
impl<T: ::carvallo::Scalar> WhippleTyres<T> {
    /// Rates and forces that follow from the coordinates:
    /// 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
    ///
    /// The parameters are not validated.
    #[inline]
    #[must_use]
    pub fn kinematics(&self) -> WhippleTyresKinematics<T> {
        let yaw_per_v_delta = (::carvallo::Number::cos(self.lam)) / self.w;
        let yaw_by_delta = self.c * yaw_per_v_delta;
        let t12 = -(::carvallo::Number::like(self.w, 1.0) / self.rR);
        let t13 = -(::carvallo::Number::like(self.w, 1.0) / self.rF);
        WhippleTyresKinematics {
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
impl<T: ::carvallo::Scalar> ::carvallo::Model<2> for WhippleTyres<T> {
    type Scalar = T;
    type Array<U: ::core::marker::Copy> = [U; 28];
    type Over<U: ::carvallo::Number> = WhippleTyres<U>;
    const INFO: &'static ::carvallo::ModelInfo = &::carvallo::ModelInfo {
        name: "WhippleTyres",
        docs: "The Whipple-Carvallo bicycle on tyres whose cross-sections are circles.\n\nFour rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally\nsymmetric. The rims of the wheels are parts of tori that roll without slip on level ground: the radii rR and rF of\nthe wheels reach from the centre to the ground, and those of the cross-sections, rhoR and rhoF, are parts of them.\nAxes: origin at the rear contact point, x forward, y to the right, z down.",
        source: "Mechanism: Meijaard & Schwab (2006), Linearized equations for an extended bicycle model, III European Conference on Computational Mechanics",
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
                name: "rhoR",
                symbol: "rhoR",
                docs: "Radius of the cross-section of the rear tyre.",
                unit: "m",
                domain: ::carvallo::Domain {
                    lower: ::carvallo::Bound::Closed(0.0),
                    upper: ::carvallo::Bound::Unbounded,
                    nonzero: false,
                },
                used: true,
            },
            ::carvallo::ParameterInfo {
                name: "rhoF",
                symbol: "rhoF",
                docs: "Radius of the cross-section of the front tyre.",
                unit: "m",
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
                source: "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; tyres are examples",
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
                    0.02,
                    0.02,
                ],
            },
            ::carvallo::SetInfo {
                name: "benchmark_2005",
                docs: "",
                source: "Schwab, Meijaard & Papadopoulos (2005), ENOC 2005; tyres are examples",
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
                    0.02,
                    0.02,
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
                model: "WhippleTyres",
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
            rhoR: values[26],
            rhoF: values[27],
        })
    }
    fn write_to(
        &self,
        values: &mut [T],
    ) -> ::core::result::Result<(), ::carvallo::LengthError> {
        if values.len() != 28 {
            return ::core::result::Result::Err(::carvallo::LengthError {
                model: "WhippleTyres",
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
                ::carvallo::Scalar::to_f64(self.rhoR),
                ::carvallo::Scalar::to_f64(self.rhoF),
            ],
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
impl<T: ::carvallo::Number> ::carvallo::Evaluator<T, 2> for WhippleTyres<T> {
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
            rhoR: parameter(26),
            rhoF: parameter(27),
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
/// The derivatives of the matrices of [`WhippleTyres`] with respect to its parameters, in SI units: those that are not zero for all parameters.
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhippleTyresDerivatives<T = ::core::primitive::f64> {
    /// The value of each derivative in [`Self::PARTIALS`].
    pub values: [T; 166],
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl WhippleTyresDerivatives {
    /// Which derivatives there are, by parameters.
    pub const PARTIALS: &'static [::carvallo::Partial; 166] = &[
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 0, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::M, 1, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 0, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 0, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::C1, 1, 1, 0),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 0),
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
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 8),
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
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 15),
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
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 26),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 0, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 0, 1, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 0, 27),
        ::carvallo::Partial::new(::carvallo::MatrixName::K0, 1, 1, 27),
    ];
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> WhippleTyresDerivatives<T> {
    /// The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing
    /// if there is no such parameter.
    #[must_use]
    pub fn with_respect_to(
        &self,
        parameter: ::core::primitive::usize,
    ) -> ::core::option::Option<WhippleTyresMatrices<T>> {
        if parameter >= 28 {
            return ::core::option::Option::None;
        }
        let zero = <T as ::carvallo::Scalar>::from_f64(0.0);
        let mut matrices = WhippleTyresMatrices {
            m: [[zero; 2]; 2],
            c1: [[zero; 2]; 2],
            k0: [[zero; 2]; 2],
            k2: [[zero; 2]; 2],
        };
        for position in 0..166 {
            let partial = <WhippleTyresDerivatives>::PARTIALS[position];
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
impl<T: ::carvallo::Number> WhippleTyres<T> {
    /// The coefficient matrices and their derivatives, from one straight-line program:
    /// 191 additions, 306 multiplications, 3 divisions, 28 negations and 2 trigonometric functions: 530 operations.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    #[inline(always)]
    #[must_use]
    pub fn matrices_and_derivatives(
        &self,
    ) -> (WhippleTyresMatrices<T>, WhippleTyresDerivatives<T>) {
        let (
            Jxx_delta_mH,
            Jxx_delta_mF,
            Jxx_delta,
            t19,
            t24,
            t26,
            t28,
            t43,
            t31,
            t38,
            t39,
            t40,
            Jxz_delta,
            t44,
            hx_delta,
            t46,
            yaw_per_v_delta,
            yaw_by_delta,
            t51,
            t55,
            Sz_delta,
            Jxz_all,
            t60,
            t62,
            t64,
            t65,
            t68,
            t70,
            hz_delta,
            Sx_delta,
            py_delta,
            M_yaw_delta,
            t85,
            t88,
            t91,
            P_delta_yaw_yaw_by_delta,
            t94,
            P_delta_yaw,
            t96,
            t98,
            t101,
            h_spin_F,
            t103,
            t105,
            h_wheels_all,
            t109,
            Sz_all,
            t111,
            t114,
            t115,
            t119,
            m_delta,
            Sx_all,
            t124,
            P_delta_lateral,
            t127,
            t131,
            t132,
            t137,
            t139,
            t140,
            t142,
            t143,
            t144,
            t145,
            t146,
            t147,
            t148,
            t149,
            t151,
            t152,
            t153,
            M12_yaw_per_v_delta,
            t156,
            t159,
            t160,
            t163,
            t164,
            M22_hz_delta,
            t168,
            M22_py_delta,
            t171,
            t173,
            P_delta_yaw_w,
            M22_yaw_by_delta,
            M22_yaw_per_v_delta,
            t181,
            t182,
            C112_yaw_per_v_delta,
            t187,
            t188,
            C122_Sx_all,
            C122_py_delta,
            t196,
            t200,
            C122_yaw_by_delta,
            C122_yaw_per_v_delta,
            t209,
            t210,
            K011_Sx_all,
            t212,
            t215,
            t217,
            t218,
            t219,
            t220,
            t222,
            t223,
            t224,
            t225,
            t227,
            t229,
            K222_Sx_all,
            t234,
            t236,
            K222_yaw_by_delta,
            K222_yaw_per_v_delta,
            t241,
            t242,
            t246,
            t252,
            hz_delta_c,
            t257,
            t259,
            t262,
            t270,
            t274,
            t275,
            t277,
            t282,
            hx_delta_lam,
            t285,
            t287,
            hz_delta_lam,
            t301,
            t303,
            t307,
            t312,
            t313,
            t317,
            t320,
            t325,
            t326,
            t328,
            t329,
            t330,
            t331,
            t332,
            t333,
            t334,
            t335,
            t336,
            t337,
            P_delta_yaw_xB,
            t340,
            t344,
            t345,
            t346,
            t347,
            t348,
            t349,
            t355,
            P_delta_yaw_mB,
            t358,
            t364,
            t367,
            t368,
            t369,
            t371,
            P_delta_yaw_xH,
            t377,
            t380,
            Jxx_delta_zH,
            hx_delta_zH,
            t386,
            t388,
            t390,
            t393,
            t395,
            t402,
            t406,
            hx_delta_mH,
            t410,
            t412,
            P_delta_yaw_mH,
            hz_delta_mH,
            py_delta_mH,
            t425,
            Sx_all_mH,
            t435,
            t438,
            t440,
            t441,
            t445,
            t446,
            t448,
            t449,
            t450,
            t452,
            K222_h_spin_F,
            Jxx_delta_rF,
            hx_delta_rF,
            Sx_all_mF,
            Jxz_all_rF,
            t461,
            t463,
            py_delta_rF,
            t468,
            t470,
            t474,
            t476,
            t477,
            t480,
            t482,
            t485,
            hx_delta_mF,
            Jxz_all_mF,
            t491,
            P_delta_yaw_mF,
            hz_delta_mF,
            py_delta_mF,
            t504,
            t507,
            t513,
            t516,
            t518,
            t519,
            t520,
            t523,
            t524,
            t525,
            t526,
            t527,
            t528,
            t529,
            t530,
            t531,
            t532,
            t533,
            t534,
            t535,
            t536,
            t537,
            t538,
            t539,
            t540,
            t541,
            t542,
            t543,
            t544,
            t545,
        );
        Jxx_delta_mH = self.zH * self.zH;
        Jxx_delta_mF = self.rF * self.rF;
        Jxx_delta = ((self.IHxx + self.IFxx) + (self.mH * Jxx_delta_mH))
            + (self.mF * Jxx_delta_mF);
        t19 = self.rR * self.rR;
        t24 = self.zB * self.zB;
        t26 = (((self.IRxx + self.IBxx) + Jxx_delta) + (self.mR * t19))
            + (self.mB * t24);
        (t28, t43) = ::carvallo::Number::sin_cos(self.lam);
        t31 = self.rF * self.mF;
        t38 = self.w + self.c;
        t39 = self.xH - t38;
        t40 = self.mH * t39;
        Jxz_delta = (self.IHxz - (t31 * self.c)) - (t40 * self.zH);
        t44 = Jxz_delta * t43;
        hx_delta = (Jxx_delta * t28) + t44;
        t46 = ::carvallo::Number::like(self.w, 1.0) / self.w;
        yaw_per_v_delta = t43 * t46;
        yaw_by_delta = self.c * yaw_per_v_delta;
        t51 = self.zB * self.mB;
        t55 = self.zH * self.mH;
        Sz_delta = t55 - t31;
        Jxz_all = ((self.IBxz + Jxz_delta) - (t51 * self.xB)) - (t38 * Sz_delta);
        t60 = hx_delta + (yaw_by_delta * Jxz_all);
        t62 = t28 * Jxz_delta;
        t64 = self.IHzz + self.IFxx;
        t65 = t39 * t39;
        t68 = self.c * self.c;
        t70 = (t64 + (self.mH * t65)) + (self.mF * t68);
        hz_delta = t62 + (t43 * t70);
        Sx_delta = t40 - (self.mF * self.c);
        py_delta = (t43 * Sx_delta) - (Sz_delta * t28);
        M_yaw_delta = hz_delta + (t38 * py_delta);
        t85 = self.xB * self.xB;
        t88 = self.xH * self.xH;
        t91 = self.w * self.w;
        P_delta_yaw_yaw_by_delta = ((((self.IRxx + self.IBzz) + t64) + (self.mB * t85))
            + (self.mH * t88)) + (self.mF * t91);
        t94 = yaw_by_delta * P_delta_yaw_yaw_by_delta;
        P_delta_yaw = M_yaw_delta + t94;
        t96 = M_yaw_delta + P_delta_yaw;
        t98 = ((t28 * hx_delta) + (t43 * hz_delta)) + (yaw_by_delta * t96);
        t101 = ::carvallo::Number::like(self.w, 1.0) / self.rF;
        h_spin_F = self.IFyy * t101;
        t103 = t43 * h_spin_F;
        t105 = ::carvallo::Number::like(self.w, 1.0) / self.rR;
        h_wheels_all = h_spin_F + (self.IRyy * t105);
        t109 = self.rR * self.mR;
        Sz_all = (t51 + Sz_delta) - t109;
        t111 = h_wheels_all - Sz_all;
        t114 = yaw_per_v_delta * Jxz_all;
        t115 = (t103 + (yaw_by_delta * t111)) + t114;
        t119 = self.xB * self.mB;
        m_delta = self.mH + self.mF;
        Sx_all = (Sx_delta + t119) + (t38 * m_delta);
        t124 = yaw_by_delta * Sx_all;
        P_delta_lateral = py_delta + t124;
        t127 = (yaw_per_v_delta * P_delta_yaw) + (yaw_by_delta * P_delta_lateral);
        t131 = t46 * Sx_all;
        t132 = ((self.mR + self.mB) + m_delta) - t131;
        t137 = (Sz_all + (self.rhoR * t132)) + (self.rhoF * t131);
        t139 = t43 * self.c;
        t140 = (self.rhoF * t28) - t139;
        t142 = (t131 * t140) - py_delta;
        t143 = t28 * t142;
        t144 = yaw_per_v_delta * t111;
        t145 = t28 * h_spin_F;
        t146 = P_delta_lateral + t145;
        t147 = yaw_per_v_delta * t146;
        t148 = t43 * t55;
        t149 = Sz_delta - t55;
        t151 = t148 - (yaw_by_delta * t149);
        t152 = t46 * t46;
        t153 = t43 * t152;
        M12_yaw_per_v_delta = self.c * Jxz_all;
        t156 = t151 - (t153 * M12_yaw_per_v_delta);
        t159 = self.mH * ::carvallo::Number::like(self.w, 2.0);
        t160 = t39 * t43;
        t163 = (t159 * t160) - (t28 * t55);
        t164 = yaw_by_delta * ::carvallo::Number::like(self.w, 2.0);
        M22_hz_delta = t43 + t164;
        t168 = self.mH * t43;
        M22_py_delta = t38 * t164;
        t171 = ((t163 * M22_hz_delta) - (t28 * t148)) + (t168 * M22_py_delta);
        t173 = (py_delta * t164) - t171;
        P_delta_yaw_w = (self.w * self.mF) * t164;
        M22_yaw_by_delta = t94 + t96;
        M22_yaw_per_v_delta = self.c * M22_yaw_by_delta;
        t181 = (t173 + (yaw_by_delta * P_delta_yaw_w)) - (t153 * M22_yaw_per_v_delta);
        t182 = yaw_per_v_delta * t149;
        C112_yaw_per_v_delta = Jxz_all + (self.c * t111);
        t187 = h_wheels_all * self.c;
        t188 = t153 * t187;
        C122_Sx_all = yaw_by_delta * yaw_by_delta;
        C122_py_delta = yaw_by_delta + (t38 * yaw_per_v_delta);
        t196 = ((self.mH * C122_Sx_all) + (yaw_per_v_delta * t163))
            + (t168 * C122_py_delta);
        t200 = ((yaw_per_v_delta * py_delta) - t196) + (m_delta * C122_Sx_all);
        C122_yaw_by_delta = (P_delta_lateral + t124)
            + (yaw_per_v_delta * P_delta_yaw_yaw_by_delta);
        C122_yaw_per_v_delta = P_delta_yaw + (self.c * C122_yaw_by_delta);
        t209 = (t200 + (yaw_per_v_delta * P_delta_yaw_w))
            - (t153 * C122_yaw_per_v_delta);
        t210 = self.rhoF - self.rhoR;
        K011_Sx_all = t46 * t210;
        t212 = self.mH * K011_Sx_all;
        t215 = Sx_all * t152;
        t217 = ((m_delta * K011_Sx_all) - t212) - (t215 * t210);
        t218 = t215 * t140;
        t219 = t46 * t140;
        t220 = m_delta * t219;
        t222 = (self.mH * t219) - t168;
        t223 = t220 - t222;
        t224 = t223 - t218;
        t225 = t28 * t222;
        t227 = (t28 * t220) - t225;
        t229 = t227 - (t28 * t218);
        K222_Sx_all = yaw_per_v_delta * yaw_by_delta;
        t234 = (self.mH * K222_Sx_all) + (yaw_per_v_delta * t168);
        t236 = (m_delta * K222_Sx_all) - t234;
        K222_yaw_by_delta = yaw_per_v_delta * Sx_all;
        K222_yaw_per_v_delta = (self.c * K222_yaw_by_delta) + t146;
        t241 = t236 - (t153 * K222_yaw_per_v_delta);
        t242 = t43 * t31;
        t246 = ((t151 - t242) + t114) - (t31 * yaw_by_delta);
        t252 = self.mF * ::carvallo::Number::like(self.w, 2.0);
        hz_delta_c = (t139 * t252) - (t31 * t28);
        t257 = self.mF * t43;
        t259 = (((t173 - (t28 * t242)) + (yaw_per_v_delta * M22_yaw_by_delta))
            + (hz_delta_c * M22_hz_delta)) - (t257 * M22_py_delta);
        t262 = (yaw_per_v_delta * (t111 - t31)) - t182;
        t270 = ((t200 - (C122_Sx_all * self.mF))
            + (yaw_per_v_delta * (hz_delta_c + C122_yaw_by_delta)))
            - (t257 * C122_py_delta);
        t274 = t257 - ((self.mF * t219) + (t43 * t131));
        t275 = t223 + t274;
        t277 = t227 + (t28 * t274);
        t282 = (t236 - (K222_Sx_all * self.mF))
            + (yaw_per_v_delta * (K222_yaw_by_delta - t257));
        hx_delta_lam = (Jxx_delta * t43) - t62;
        t285 = t46 * t28;
        t287 = hx_delta_lam - (t285 * M12_yaw_per_v_delta);
        hz_delta_lam = t44 - (t28 * t70);
        t301 = (t43 * Sz_delta) + (Sx_delta * t28);
        t303 = (((((t28 * hx_delta_lam) + (hx_delta * t43)) - (hz_delta * t28))
            + (hz_delta_lam * M22_hz_delta)) - (t285 * M22_yaw_per_v_delta))
            - (t301 * M22_py_delta);
        t307 = t145 + (t285 * t187);
        t312 = ((yaw_per_v_delta * hz_delta_lam) - (t285 * C122_yaw_per_v_delta))
            - (t301 * C122_py_delta);
        t313 = t28 * self.c;
        t317 = (t131 * (t313 + (self.rhoF * t43))) + t301;
        t320 = (t43 * t142) + (t28 * t317);
        t325 = (yaw_per_v_delta * (t103 - t301)) - (t285 * K222_yaw_per_v_delta);
        t326 = t109 * ::carvallo::Number::like(self.w, 2.0);
        t328 = self.IRyy * (t105 * t105);
        t329 = self.mR - t328;
        t330 = yaw_by_delta * t329;
        t331 = t328 * yaw_by_delta;
        t332 = yaw_per_v_delta * t329;
        t333 = self.rR * yaw_by_delta;
        t334 = self.rhoR - self.rR;
        t335 = self.rR * yaw_per_v_delta;
        t336 = yaw_by_delta * t105;
        t337 = yaw_per_v_delta * t105;
        P_delta_yaw_xB = t119 * t164;
        t340 = yaw_by_delta * P_delta_yaw_xB;
        t344 = (self.mB * C122_Sx_all) + (yaw_per_v_delta * P_delta_yaw_xB);
        t345 = self.mB * K011_Sx_all;
        t346 = self.mB * t219;
        t347 = t28 * t346;
        t348 = self.mB * K222_Sx_all;
        t349 = ::carvallo::Number::like(self.w, 2.0) * t51;
        t355 = self.zB * self.xB;
        P_delta_yaw_mB = yaw_by_delta * t85;
        t358 = yaw_by_delta * P_delta_yaw_mB;
        t364 = (self.xB * C122_Sx_all) + (yaw_per_v_delta * P_delta_yaw_mB);
        t367 = (self.zB + self.rhoR) + (self.xB * K011_Sx_all);
        t368 = self.xB * t219;
        t369 = t28 * t368;
        t371 = self.xB * K222_Sx_all;
        P_delta_yaw_xH = (self.xH * self.mH) * t164;
        t377 = t171 + (yaw_by_delta * P_delta_yaw_xH);
        t380 = t196 + (yaw_per_v_delta * P_delta_yaw_xH);
        Jxx_delta_zH = self.zH * t159;
        hx_delta_zH = (t28 * Jxx_delta_zH) - (t40 * t43);
        t386 = t40 + (self.mH * t38);
        t388 = hx_delta_zH - (yaw_by_delta * t386);
        t390 = t40 * t28;
        t393 = self.mH * t28;
        t395 = ((t28 * hx_delta_zH) - (t390 * M22_hz_delta)) - (t393 * M22_py_delta);
        t402 = t28 * t393;
        t406 = t39 * self.zH;
        hx_delta_mH = (t28 * Jxx_delta_mH) - (t43 * t406);
        t410 = t406 + (t38 * self.zH);
        t412 = hx_delta_mH - (yaw_by_delta * t410);
        P_delta_yaw_mH = yaw_by_delta * t88;
        hz_delta_mH = (t43 * t65) - (t28 * t406);
        py_delta_mH = t160 - (self.zH * t28);
        t425 = (((t28 * hx_delta_mH) + (yaw_by_delta * P_delta_yaw_mH))
            + (hz_delta_mH * M22_hz_delta)) + (py_delta_mH * M22_py_delta);
        Sx_all_mH = t38 + t39;
        t435 = ((yaw_per_v_delta * (P_delta_yaw_mH + hz_delta_mH))
            + (Sx_all_mH * C122_Sx_all)) + (py_delta_mH * C122_py_delta);
        t438 = (self.zH + self.rhoR) + (Sx_all_mH * K011_Sx_all);
        t440 = (Sx_all_mH * t219) - py_delta_mH;
        t441 = t28 * t440;
        t445 = (yaw_per_v_delta * py_delta_mH) + (Sx_all_mH * K222_Sx_all);
        t446 = t28 * t28;
        t448 = C122_Sx_all + (t43 * M22_hz_delta);
        t449 = t43 + yaw_by_delta;
        t450 = yaw_per_v_delta * t449;
        t452 = t28 * (t43 + M22_hz_delta);
        K222_h_spin_F = t28 * yaw_per_v_delta;
        Jxx_delta_rF = self.rF * t252;
        hx_delta_rF = (t28 * Jxx_delta_rF) - (self.mF * t139);
        Sx_all_mF = t38 - self.c;
        Jxz_all_rF = self.mF * Sx_all_mF;
        t461 = hx_delta_rF + (yaw_by_delta * Jxz_all_rF);
        t463 = self.mF * t313;
        py_delta_rF = self.mF * t28;
        t468 = ((t28 * hx_delta_rF) - (t463 * M22_hz_delta))
            + (py_delta_rF * M22_py_delta);
        t470 = self.IFyy * (t101 * t101);
        t474 = self.mF - t470;
        t476 = ((yaw_per_v_delta * Jxz_all_rF) - (t43 * t470)) + (yaw_by_delta * t474);
        t477 = t470 * t449;
        t480 = (py_delta_rF * C122_py_delta) - (yaw_per_v_delta * t463);
        t482 = yaw_per_v_delta * t474;
        t485 = (yaw_per_v_delta * py_delta_rF) - (t470 * K222_h_spin_F);
        hx_delta_mF = (t28 * Jxx_delta_mF) - (self.rF * t139);
        Jxz_all_mF = self.rF * Sx_all_mF;
        t491 = hx_delta_mF + (yaw_by_delta * Jxz_all_mF);
        P_delta_yaw_mF = yaw_by_delta * t91;
        hz_delta_mF = (t43 * t68) - (self.rF * t313);
        py_delta_mF = (self.rF * t28) - t139;
        t504 = (((t28 * hx_delta_mF) + (yaw_by_delta * P_delta_yaw_mF))
            + (hz_delta_mF * M22_hz_delta)) + (py_delta_mF * M22_py_delta);
        t507 = (self.rF * yaw_by_delta) + (yaw_per_v_delta * Jxz_all_mF);
        t513 = ((yaw_per_v_delta * (P_delta_yaw_mF + hz_delta_mF))
            + (Sx_all_mF * C122_Sx_all)) + (py_delta_mF * C122_py_delta);
        t516 = (self.rhoR - self.rF) + (Sx_all_mF * K011_Sx_all);
        t518 = (Sx_all_mF * t219) - py_delta_mF;
        t519 = t28 * t518;
        t520 = self.rF * yaw_per_v_delta;
        t523 = (yaw_per_v_delta * py_delta_mF) + (Sx_all_mF * K222_Sx_all);
        t524 = t448 + t446;
        t525 = t101 * t449;
        t526 = yaw_per_v_delta * t101;
        t527 = t101 * K222_h_spin_F;
        t528 = t28 * t131;
        t529 = t28 * t528;
        t530 = -(t103 + (yaw_by_delta * h_wheels_all));
        t531 = -(t182 + (t153 * C112_yaw_per_v_delta));
        t532 = -(t111 * t153);
        t533 = -(h_wheels_all * yaw_per_v_delta);
        t534 = -(t145 + (t285 * C112_yaw_per_v_delta));
        t535 = -(t111 * t285);
        t536 = -self.mR;
        t537 = -t336;
        t538 = -(t51 * yaw_by_delta);
        t539 = -(t51 * yaw_per_v_delta);
        t540 = -(yaw_by_delta * t119);
        t541 = -((self.mB * yaw_by_delta) + (yaw_per_v_delta * t119));
        t542 = -(self.mB * yaw_per_v_delta);
        t543 = -(yaw_by_delta * t355);
        t544 = -((self.zB * yaw_by_delta) + (yaw_per_v_delta * t355));
        t545 = -(self.zB * yaw_per_v_delta);
        let (t546, t547, t548, t549, t550, t551, t552, t553, t554, t555, t556, t557);
        t546 = -(t148 + (yaw_by_delta * t55));
        t547 = -(yaw_per_v_delta * t55);
        t548 = -((self.mH * yaw_by_delta) + (yaw_per_v_delta * t386));
        t549 = -((yaw_per_v_delta * t390) + (t393 * C122_py_delta));
        t550 = -(self.mH * yaw_per_v_delta);
        t551 = -(yaw_per_v_delta * t393);
        t552 = -((self.zH * yaw_by_delta) + (yaw_per_v_delta * t410));
        t553 = -(self.zH * yaw_per_v_delta);
        t554 = -self.mF;
        t555 = -py_delta_rF;
        t556 = -(t28 * py_delta_rF);
        t557 = -t525;
        (
            WhippleTyresMatrices {
                m: [[t26, t60], [t60, t98]],
                c1: [[::carvallo::Number::like(self.w, 0.0), t115], [t530, t127]],
                k0: [[t137, t142], [t142, t143]],
                k2: [
                    [::carvallo::Number::like(self.w, 0.0), t144],
                    [::carvallo::Number::like(self.w, 0.0), t147],
                ],
            },
            WhippleTyresDerivatives {
                values: [
                    t156,
                    t156,
                    t181,
                    t531,
                    t188,
                    t209,
                    t217,
                    t224,
                    t224,
                    t229,
                    t532,
                    t241,
                    t246,
                    t246,
                    t259,
                    t262,
                    t533,
                    t270,
                    t275,
                    t275,
                    t277,
                    t282,
                    t287,
                    t287,
                    t303,
                    t534,
                    t307,
                    t312,
                    t317,
                    t317,
                    t320,
                    t535,
                    t325,
                    t326,
                    t330,
                    t331,
                    t536,
                    t332,
                    t19,
                    t333,
                    t334,
                    t335,
                    ::carvallo::Number::like(self.w, 1.0),
                    C122_Sx_all,
                    K222_Sx_all,
                    t336,
                    t537,
                    t337,
                    t538,
                    t538,
                    t340,
                    t539,
                    t344,
                    t345,
                    t346,
                    t346,
                    t347,
                    t348,
                    t349,
                    t540,
                    t540,
                    t541,
                    self.mB,
                    t542,
                    t24,
                    t543,
                    t543,
                    t358,
                    t544,
                    t364,
                    t367,
                    t368,
                    t368,
                    t369,
                    t545,
                    t371,
                    ::carvallo::Number::like(self.w, 1.0),
                    C122_Sx_all,
                    K222_Sx_all,
                    yaw_by_delta,
                    yaw_by_delta,
                    yaw_per_v_delta,
                    t546,
                    t546,
                    t377,
                    t547,
                    t380,
                    t212,
                    t222,
                    t222,
                    t225,
                    t234,
                    Jxx_delta_zH,
                    t388,
                    t388,
                    t395,
                    t548,
                    t549,
                    self.mH,
                    t393,
                    t393,
                    t402,
                    t550,
                    t551,
                    Jxx_delta_mH,
                    t412,
                    t412,
                    t425,
                    t552,
                    t435,
                    t438,
                    t440,
                    t440,
                    t441,
                    t553,
                    t445,
                    ::carvallo::Number::like(self.w, 1.0),
                    t28,
                    t28,
                    t446,
                    t448,
                    t450,
                    t449,
                    t449,
                    t452,
                    yaw_per_v_delta,
                    K222_h_spin_F,
                    Jxx_delta_rF,
                    t461,
                    t461,
                    t468,
                    t476,
                    t477,
                    t480,
                    t554,
                    t555,
                    t555,
                    t556,
                    t482,
                    t485,
                    Jxx_delta_mF,
                    t491,
                    t491,
                    t504,
                    t507,
                    t513,
                    t516,
                    t518,
                    t518,
                    t519,
                    t520,
                    t523,
                    ::carvallo::Number::like(self.w, 1.0),
                    t28,
                    t28,
                    t524,
                    t450,
                    t525,
                    t557,
                    t526,
                    t527,
                    t132,
                    t131,
                    t528,
                    t528,
                    t529,
                ],
            },
        )
    }
}
#[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)]
impl<T: ::carvallo::Scalar> ::carvallo::Differentiable<2> for WhippleTyres<T> {
    type Derivatives = [::carvallo::Coefficients<T, 2>; 28];
    fn coefficients_and_derivatives(
        &self,
    ) -> (::carvallo::Coefficients<T, 2>, Self::Derivatives) {
        let (matrices, derivatives) = self.matrices_and_derivatives();
        let mut all = [::carvallo::Coefficients::from_rows(
            [[[<T as ::carvallo::Scalar>::from_f64(0.0); 2]; 2]; 6],
        ); 28];
        for position in 0..166 {
            <WhippleTyresDerivatives>::PARTIALS[position]
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
