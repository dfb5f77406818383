//! A bicycle that is held upright by torques on its steer while its speed changes, all in `f32`, without the standard library.

use carvallo::{Coefficients, Model, StateSpace, SystemError};
use carvallo_models::Whipple;

/// Torque on the steer, in N m, for each rad of lean and steer and each rad/s of their rates, at 1, 2, … 10 m/s.
///
/// They are those of a linear-quadratic regulator of the benchmark bicycle with the weights 100, 100, 10 and 1 on the
/// squares of lean, steer, and their rates and 1 on that of the torque, from the matrices that Meijaard, Papadopoulos, Ruina &
/// Schwab (2007) print, by `scipy.linalg.solve_continuous_are` of SciPy 1.17; the torque is minus their product with the state.
pub const GAINS: [[f32; 4]; 10] = [
    [-211.2834, 8.3137, -67.4151, 1.9393],
    [-71.5313, 19.2561, -22.0249, 2.5377],
    [-36.5966, 21.8303, -10.2091, 2.2293],
    [-23.8138, 21.3891, -5.6674, 1.8177],
    [-18.3779, 20.0209, -3.6483, 1.4652],
    [-15.8294, 18.6876, -2.6495, 1.2015],
    [-14.526, 17.6565, -2.0938, 1.0108],
    [-13.8011, 16.9097, -1.747, 0.8709],
    [-13.3662, 16.3721, -1.5092, 0.7652],
    [-13.0879, 15.9792, -1.3344, 0.6827],
];

/// The gains at a speed in m/s: between those of the two nearest speeds; beyond the ends, those of the end.
pub fn gains(speed: f32) -> [f32; 4] {
    let place = if speed > 1.0 { speed - 1.0 } else { 0.0 };
    let below = (place as usize).min(GAINS.len() - 2);
    let part = place - below as f32;
    let part = if part < 1.0 { part } else { 1.0 };
    let [low, high] = [GAINS[below], GAINS[below + 1]];
    core::array::from_fn(|i| low[i] + part * (high[i] - low[i]))
}

/// The torque on the steer in N m, from the speed and the state: lean, steer, and their rates.
pub fn torque(speed: f32, state: &[f32; 4]) -> f32 {
    let [lean, steer, lean_rate, steer_rate] = gains(speed);
    -(lean * state[0] + steer * state[1] + lean_rate * state[2] + steer_rate * state[3])
}

/// The bicycle with its controller.
#[derive(Clone)]
pub struct Ride {
    matrices: Coefficients<f32, 2>,
    gravity: f32,
    /// Forward speed in m/s.
    pub speed: f32,
    /// Lean and steer in rad, and their rates in rad/s.
    pub state: [f32; 4],
}

impl Ride {
    /// At a speed in m/s, leaned by an angle in rad.
    pub fn new(bicycle: &Whipple<f32>, speed: f32, lean: f32) -> Self {
        Self { matrices: bicycle.coefficients(), gravity: bicycle.g, speed, state: [lean, 0.0, 0.0, 0.0] }
    }

    /// One sample of 10 ms, for which the torque is held; then the speed has changed by what is given in m/s.
    ///
    /// # Errors
    /// If numbers leave the range of `f32`.
    pub fn step(&mut self, faster: f32) -> Result<(), SystemError> {
        const TIME: f32 = 0.01;
        let motion = self.matrices.at(self.speed, self.gravity)?.state_space()?;
        let torque = torque(self.speed, &self.state);
        let from = self.state;
        let after = |time: f32, rates: &[f32; 4]| core::array::from_fn(|i| from[i] + time * rates[i]);
        // By the classical method of Runge and Kutta.
        let a = rates(&motion, &from, torque);
        let b = rates(&motion, &after(0.5 * TIME, &a), torque);
        let c = rates(&motion, &after(0.5 * TIME, &b), torque);
        let d = rates(&motion, &after(TIME, &c), torque);
        self.state = core::array::from_fn(|i| from[i] + TIME / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]));
        self.speed += faster;
        Ok(())
    }
}

/// The rates of the state under a torque on the steer.
fn rates(motion: &StateSpace<2, f32>, state: &[f32; 4], torque: f32) -> [f32; 4] {
    let [lean, steer, lean_rate, steer_rate] = *state;
    let StateSpace { stiffness, damping, input, .. } = motion;
    // Places of matrices by name are checked when this is compiled: no panic is linked.
    let lean_acceleration = stiffness.m11 * lean
        + stiffness.m12 * steer
        + damping.m11 * lean_rate
        + damping.m12 * steer_rate
        + input.m12 * torque;
    let steer_acceleration = stiffness.m21 * lean
        + stiffness.m22 * steer
        + damping.m21 * lean_rate
        + damping.m22 * steer_rate
        + input.m22 * torque;
    [lean_rate, steer_rate, lean_acceleration, steer_acceleration]
}
