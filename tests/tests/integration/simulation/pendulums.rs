//! Two pendulums of which everything is known: one by its angle, one by Cartesian coordinates, of which one depends on the other.

use carvallo::Motion;
use carvallo::motion::{AppliedInfo, MotionInfo, PositionInfo, PositionKind, Unchecked, WheelInfo};

/// Of unit mass and length, by its angle from hanging, under a torque.
#[derive(Clone, Copy, Debug)]
pub struct Swing {
    pub gravity: f64,
}

const fn position(name: &'static str, unit: &'static str, kind: PositionKind) -> PositionInfo {
    PositionInfo { name, label: name, unit, kind }
}

impl Motion for Swing {
    const INFO: &'static MotionInfo = &MotionInfo {
        model: "Swing",
        positions: &[position("angle", "rad", PositionKind::Free)],
        speeds: &[0],
        dependent: &[],
        forces: &[AppliedInfo { name: "T", label: "torque", unit: "N*m", position: "theta" }],
        wheels: &[],
    };
}

impl Unchecked for Swing {
    type Scalar = f64;
    type Positions = [f64; 1];
    type Speeds = [f64; 1];
    type Dependent = [f64; 0];
    type Forces = [f64; 1];
    type ContactForces = [[f64; 3]; 0];

    fn closure_unchecked(&self, _: &[f64; 1]) -> ([f64; 0], [f64; 0]) {
        ([], [])
    }

    fn rates_unchecked(&self, _: &[f64; 1], speeds: &[f64; 1]) -> [f64; 1] {
        *speeds
    }

    fn derivatives_unchecked(&self, q: &[f64; 1], u: &[f64; 1], f: &[f64; 1]) -> ([f64; 1], [f64; 1]) {
        (*u, self.accelerations_unchecked(q, u, f))
    }

    fn accelerations_unchecked(&self, q: &[f64; 1], _: &[f64; 1], f: &[f64; 1]) -> [f64; 1] {
        [f[0] - self.gravity * q[0].sin()]
    }

    fn energy_unchecked(&self, q: &[f64; 1], u: &[f64; 1]) -> [f64; 2] {
        [0.5 * u[0] * u[0], -self.gravity * q[0].cos()]
    }

    fn contact_forces_unchecked(&self, _: &[f64; 1], _: &[f64; 1], _: &[f64; 1]) -> [[f64; 3]; 0] {
        []
    }
}

/// The same by the place of its bob, x to the right and z down: x is free and z depends on it, so that it is singular where
/// the rod is level.
#[derive(Clone, Copy, Debug)]
pub struct Bob {
    pub gravity: f64,
}

impl Motion for Bob {
    const INFO: &'static MotionInfo = &MotionInfo {
        model: "Bob",
        positions: &[position("x", "m", PositionKind::Free), position("z", "m", PositionKind::Dependent)],
        speeds: &[0],
        dependent: &[1],
        forces: &[AppliedInfo { name: "F", label: "force", unit: "N", position: "x" }],
        wheels: &[WheelInfo { name: "rod", label: "rod" }, WheelInfo { name: "rod", label: "rod" }],
    };
}

impl Unchecked for Bob {
    type Scalar = f64;
    type Positions = [f64; 2];
    type Speeds = [f64; 1];
    type Dependent = [f64; 1];
    type Forces = [f64; 1];
    type ContactForces = [[f64; 3]; 1];

    fn closure_unchecked(&self, [x, z]: &[f64; 2]) -> ([f64; 1], [f64; 1]) {
        let beyond = x * x + z * z - 1.0;
        ([beyond], [-beyond / (2.0 * z)])
    }

    fn rates_unchecked(&self, [x, z]: &[f64; 2], [u]: &[f64; 1]) -> [f64; 2] {
        [*u, -x * u / z]
    }

    fn derivatives_unchecked(&self, q: &[f64; 2], u: &[f64; 1], f: &[f64; 1]) -> ([f64; 2], [f64; 1]) {
        (self.rates_unchecked(q, u), [self.accelerations_unchecked(q, u, f)[0]])
    }

    /// x x'' + z z'' = -(x'² + z'²), and what is along the path: z x'' - x z'' = z F - x g.
    fn accelerations_unchecked(&self, q: &[f64; 2], u: &[f64; 1], [f]: &[f64; 1]) -> [f64; 2] {
        let [x, z] = *q;
        let [x_rate, z_rate] = self.rates_unchecked(q, u);
        let (inward, along) = (-(x_rate * x_rate + z_rate * z_rate), z * f - x * self.gravity);
        // A rate that has no value makes what follows have none.
        [x * inward + z * along, z * inward - x * along]
    }

    fn energy_unchecked(&self, q: &[f64; 2], u: &[f64; 1]) -> [f64; 2] {
        let [x_rate, z_rate] = self.rates_unchecked(q, u);
        [0.5 * (x_rate * x_rate + z_rate * z_rate), -self.gravity * q[1]]
    }

    fn contact_forces_unchecked(&self, q: &[f64; 2], u: &[f64; 1], f: &[f64; 1]) -> [[f64; 3]; 1] {
        let [x, z] = self.accelerations_unchecked(q, u, f);
        [[x - f[0], 0.0, z - self.gravity]]
    }
}
