//! A wheel that rolls on its own without slipping: a disc, a hoop or a torus.
//!
//! Linearized about straight upright rolling in lean phi (right positive) and yaw psi (right positive), with Ia the
//! moment of inertia about the axle, It about a diameter, m the mass, r the outer radius and rho the radius of the
//! tyre's crown (0: an edge):
//!
//! ```text
//! (It + m r^2) phi'' + (Ia + m r^2) (v / r) psi' - m g (r - rho) phi = lean torque
//!  It          psi'' -  Ia          (v / r) phi'                     = yaw torque
//! ```
//!
//! Yaw enters by its rates alone. With psi' = (Ia / It) (v / r) phi + constant in the first line, lean is a mass on a
//! spring, stable exactly when
//!
//! ```text
//! v^2 > g r^2 (r - rho) It m / (Ia (Ia + m r^2))
//! ```
//!
//! which is g r / 3 for the uniform disc (Ia = m r^2 / 2, It = m r^2 / 4) and g r / 4 for the hoop (Ia = m r^2,
//! It = m r^2 / 2), and does not depend on what the edge is in M, C1 and K2: a crown lowers the wheel's centre less as
//! it leans, and that is all it does.
//!
//! Sources. The edge: the classical result of Routh, Appell, Chaplygin and Korteweg (for example Neimark & Fufaev,
//! *Dynamics of Nonholonomic Systems*, 1972), written here from the nonlinear equations in H. Nakanishi's note on the
//! rolling coin, which has general moments of inertia and gives the critical spin (g / 3 r)^(1/2) of the uniform disc;
//! and for the uniform disc the linearized equations in SymPy's test `test_linearize_rolling_disc_kane` (its wheel
//! rolls forward at a negative spin, v = -r q3'). The crown: the nonlinear equations of a solid torus in D. L.
//! Peterson's program Rolling-Torus (2010), linearized by hand; its axes are these. All three were at hand.

#![allow(non_snake_case)] // The names are the bicycle's, with a for axial and t for transverse.

use carvallo::Coefficients;

/// A wheel on its own.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    /// Mass in kg.
    pub m: f64,
    /// Outer radius in m: how high the centre is when the wheel is upright.
    pub r: f64,
    /// Radius of the tyre's crown in m, in 0 ..= r.
    pub rho: f64,
    /// Moment of inertia about the axle in kg m^2.
    pub Ia: f64,
    /// Moment of inertia about a diameter in kg m^2.
    pub It: f64,
}

impl Disc {
    /// The coefficients for lean and yaw.
    pub fn matrices(&self) -> Coefficients<f64, 2> {
        let &Self { m, r, rho, Ia, It } = self;
        let zero = [[0.0; 2]; 2];
        let M = [[It + m * r * r, 0.0], [0.0, It]];
        let C1 = [[0.0, Ia / r + m * r], [-Ia / r, 0.0]];
        let K0 = [[-m * (r - rho), 0.0], [0.0, 0.0]];
        Coefficients::from_rows([M, zero, zero, C1, zero, K0, zero, zero])
    }

    /// The speed in m/s above which the wheel stays upright.
    pub fn critical_speed(&self, g: f64) -> f64 {
        let &Self { m, r, rho, Ia, It } = self;
        (g * r * r * (r - rho) * It * m / (Ia * (Ia + m * r * r))).sqrt()
    }
}
