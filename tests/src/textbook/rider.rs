//! The Whipple bicycle with a rider whose upper body leans.
//!
//! The upper body is a fifth rigid body, joined to the rear frame by a hinge with a spring and a damper; the axis of
//! the hinge runs forward, level, in the middle plane at the height h. The third coordinate is the lean beta of the
//! upper body **relative to the rear frame**, right positive, after the lean phi and the steer delta of the bicycle;
//! the third force is the torque in the hinge. With the upper body's mass m, its centre at (x, z) in the bicycle's
//! axes, a = -z - h its height above the hinge and inertia about its centre, with mu = (c / w) cos lam,
//!
//! ```text
//! M[beta, phi]   = Ixx - m a z              M[beta, delta]  = mu (Ixz + m a x)              M[beta, beta] = Ixx + m a^2
//! C1[beta, delta] = (cos lam / w) (Ixz + m a x) + mu m a                                    C0[beta, beta] = damping
//! K0[beta, phi]  = K0[beta, beta] = -m a    K2[beta, delta] = (cos lam / w) m a             Kc[beta, beta] = stiffness
//! ```
//!
//! and nothing else in that row. M and K0 are symmetric; the other two rows of C1 and K2 have nothing in the column of
//! beta, and their block is Appendix A's, with the upper body in the rear frame.
//!
//! Sources. The model is that of J. K. Moore's dissertation *Human control of a bicycle* (Davis 2012), section
//! "Leaning rider extension". The formulas were derived anew; they agree with his linearized equations as his program
//! BicycleParameters 1.5.2 evaluates them (`MooreRiderLean2012Model`, generated from the dissertation's code), to 13
//! digits at several speeds, with and without spring and damper. Both were at hand.

#![allow(non_snake_case)] // The names are the field's.

use carvallo::{Coefficients, Matrix};
use carvallo_models::Whipple;

use crate::hand_written;

/// The upper body of a rider, hinged to the rear frame.
#[derive(Clone, Copy, Debug)]
pub struct UpperBody {
    /// Height of the hinge above the ground in m.
    pub h: f64,
    /// Mass in kg.
    pub m: f64,
    /// Centre of mass, forward from the rear contact, in m.
    pub x: f64,
    /// Centre of mass, down from the ground, in m.
    pub z: f64,
    /// Moment of inertia about an axis forward through its centre in kg m^2.
    pub Ixx: f64,
    /// Moment of inertia about an axis down through its centre in kg m^2.
    pub Izz: f64,
    /// Entry xz of its tensor of inertia about its centre in kg m^2.
    pub Ixz: f64,
    /// Stiffness of the hinge in N m/rad.
    pub stiffness: f64,
    /// Damping of the hinge in N m s/rad.
    pub damping: f64,
}

/// The coefficients for the lean and steer of a bicycle and the lean of what is hinged to its rear frame.
pub fn matrices(bicycle: &Whipple, upper: &UpperBody) -> Coefficients<f64, 3> {
    let &Whipple { w, c, lam, .. } = bicycle;
    let &UpperBody { h, m, x, z, Ixx, Ixz, stiffness, damping, .. } = upper;
    let turn = lam.cos() / w;
    let mu = c * turn;
    let a = -z - h;
    let yaw = Ixz + m * a * x;

    let rigid = hand_written::matrices(&with_rigid(bicycle, upper));
    let lean = [Ixx - m * a * z, mu * yaw, Ixx + m * a * a];
    Coefficients {
        m: bordered(rigid.m.0, lean, true),
        c0: bordered([[0.0; 2]; 2], [0.0, 0.0, damping], false),
        c1: bordered(rigid.c1.0, [0.0, turn * yaw + mu * m * a, 0.0], false),
        kc: bordered([[0.0; 2]; 2], [0.0, 0.0, stiffness], false),
        k0: bordered(rigid.k0.0, [-m * a, 0.0, -m * a], true),
        k2: bordered(rigid.k2.0, [0.0, turn * m * a, 0.0], false),
        ..Default::default()
    }
}

/// The bicycle with the upper body as a part of its rear frame.
fn with_rigid(bicycle: &Whipple, upper: &UpperBody) -> Whipple {
    let &Whipple { xB, zB, mB, .. } = bicycle;
    let &UpperBody { m, x, z, .. } = upper;
    let mass = mB + m;
    let (dx, dz) = (x - xB, z - zB);
    // Two bodies about their common centre: the reduced mass at their distance.
    let reduced = mB * m / mass;
    Whipple {
        mB: mass,
        xB: xB + dx * m / mass,
        zB: zB + dz * m / mass,
        IBxx: bicycle.IBxx + upper.Ixx + reduced * dz * dz,
        IBzz: bicycle.IBzz + upper.Izz + reduced * dx * dx,
        IBxz: bicycle.IBxz + upper.Ixz - reduced * dx * dz,
        ..*bicycle
    }
}

/// A matrix with a third row, and with the same column if it is symmetric.
fn bordered(block: [[f64; 2]; 2], row: [f64; 3], symmetric: bool) -> Matrix<f64, 3> {
    Matrix::<f64, 3>::from_fn(|i, j| match (i, j) {
        (2, j) => row[j],
        (i, 2) => f64::from(symmetric) * row[i],
        (i, j) => block[i][j],
    })
}
