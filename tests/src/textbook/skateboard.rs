//! A skateboard with a rider who stands still on it: one degree of freedom, the tilt of the board.
//!
//! The model is Hubbard's (1979), as in Kremnev & Kuleshov (2008, 2010):
//!
//! - Board and rider are one rigid body. Trucks and wheels have neither mass nor inertia.
//! - Each truck turns about its king pin, which passes **through the middle of its axle** and lies in the middle plane
//!   of the board. Both wheels of an axle stay on the ground, so the axles stay level, and the board tilts about the
//!   line through the middles of both axles. How high that line is above the ground does not matter: heights count
//!   from it.
//! - The king pins rise outwards, to the front at the front axle and to the rear at the rear one, by the angles lamF
//!   and lamR from the horizontal, so that tilting to the right by gamma turns the front axle to the right and the
//!   rear one to the left: tan(steer) = tan(lam) sin(gamma), exactly.
//! - Wheels do not slip sideways. They turn freely, so nothing holds the speed but the constraint that it is constant.
//! - A spring holds the board level, with the torsional stiffness k of both trucks together about the tilt axis.
//!   Tilting by gamma turns a truck about its king pin by gamma / cos(lam) relative to the board, so a spring of the
//!   stiffness kP that works about the king pin adds kP / cos(lam)^2 to k.
//!
//! Linearized, tilt gamma to the right positive, x from the **rear axle** forward, L the wheel base, sums over bodies
//! of mass m at the height h above the tilt axis, with the products of inertia Ixz = -(sum of x z) about their own
//! centres:
//!
//! ```text
//! A gamma'' + D v gamma' + (B v^2 + k - g sum m h) gamma = tilt torque
//!
//! A = sum (Ixx + m h^2)        t = tan(lamF) + tan(lamR)        B = (t / L) sum m h
//! D = (t / L) sum (Ixz + m h x) - tan(lamR) sum m h
//! ```
//!
//! For one body without Ixz, a behind the front axle and b ahead of the rear one, D = m h (b tan(lamF) - a tan(lamR))
//! / L. The board is stable at v if D v > 0 and B v^2 + k > g sum m h: when the spring alone does not hold it, above
//! the critical speed of [`Skateboard::critical_speed`], and only with the weight ahead of where D vanishes.
//!
//! Sources. That paper and Hubbard's were not at hand beyond their abstracts, which say that there is a critical speed
//! above which inertia stabilizes the tilt (Hubbard 1979), and that standing ahead of the middle is better (Varszegi,
//! Takacs, Stepan & Hogan 2016). The form A, B, D and the assumptions are from memory of Kremnev & Kuleshov,
//! *Nonlinear dynamics and stability of the skateboard*, DCDS-S 3 (2010) 85-103, whose rider and board (in the middle,
//! x = L / 2) are two bodies here. The coefficients were derived anew, and agree to 20 digits with the nonlinear
//! equations of the mechanism as described above, king pins and all (Lagrange with multipliers, by SymPy), linearized
//! numerically.

#![allow(non_snake_case)] // The names are the bicycle's.

use carvallo::Coefficients;

/// A body that rides along.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    /// Mass in kg.
    pub m: f64,
    /// Distance of its centre ahead of the rear axle in m.
    pub x: f64,
    /// Height of its centre above the tilt axis in m.
    pub h: f64,
    /// Moment of inertia about an axis forward through its centre in kg m^2.
    pub Ixx: f64,
    /// Entry xz of its tensor of inertia about its centre in kg m^2.
    pub Ixz: f64,
}

/// A skateboard with what rides on it.
#[derive(Clone, Copy, Debug)]
pub struct Skateboard<'a> {
    /// Wheel base in m.
    pub L: f64,
    /// Angle of the front king pin above the horizontal in rad.
    pub lamF: f64,
    /// Angle of the rear king pin above the horizontal in rad.
    pub lamR: f64,
    /// Stiffness of the springs of both trucks together against tilting in N m/rad.
    pub k: f64,
    /// The board and its rider.
    pub bodies: &'a [Body],
}

impl Skateboard<'_> {
    /// The coefficients for the tilt of the board.
    pub fn matrices(&self) -> Coefficients<f64, 1> {
        let mh = self.sum(|body| body.m * body.h);
        let A = self.sum(|body| body.Ixx + body.m * body.h * body.h);
        let D = self.yaw() * self.sum(|body| body.Ixz + body.m * body.h * body.x) - self.lamR.tan() * mh;
        Coefficients::from_rows([A, 0.0, 0.0, D, self.k, -mh, 0.0, self.yaw() * mh].map(|entry| [[entry]]))
    }

    /// The speed in m/s above which the tilt has a positive stiffness, if gravity wins at rest.
    pub fn critical_speed(&self, g: f64) -> f64 {
        let mh = self.sum(|body| body.m * body.h);
        ((g * mh - self.k) / (self.yaw() * mh)).sqrt()
    }

    /// How fast it turns at the speed of 1 m/s and a tilt of 1 rad.
    fn yaw(&self) -> f64 {
        (self.lamF.tan() + self.lamR.tan()) / self.L
    }

    fn sum(&self, of: impl Fn(&Body) -> f64) -> f64 {
        self.bodies.iter().map(of).sum()
    }
}
