//! The forward speed of a machine.

use super::machine::Moving;
use super::state::State;

/// What the forward speed of a machine is told by: the rate of one of its positions, which is proportional to it.
///
/// Of a machine that rolls that is the angle of its first wheel, so that the speed is that of this wheel, also in a turn:
/// `-rR thetaR'` for a bicycle. Where the rate of x is itself a free one, it is x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive {
    position: usize,
    per_speed: f64,
}

impl Drive {
    /// That of a machine; `None` for what does not run.
    #[must_use]
    pub fn of(machine: &dyn Moving) -> Option<Self> {
        let info = machine.info();
        let x = info.position("x")?;
        if info.speed_of(x).is_some() {
            return Some(Self { position: x, per_speed: 1.0 });
        }
        let wheel = info.wheels.first()?;
        let position = info.position(&format!("theta{}", wheel.name))?;
        let speed = info.speed_of(position)?;
        // The rate of x where that of the wheel alone is one, upright and straight.
        let state = State::new(machine, &[], &[]).ok()?;
        let mut speeds = state.speeds;
        speeds[speed] = 1.0;
        let mut rates = vec![0.0; info.positions.len()];
        machine.rates(&state.positions, &speeds, &mut rates).ok()?;
        (rates[x] != 0.0).then(|| Self { position, per_speed: 1.0 / rates[x] })
    }

    /// The position whose rate it is, by its place in [`MotionInfo`](crate::motion::MotionInfo).
    #[must_use]
    pub fn position(&self) -> usize {
        self.position
    }

    /// The rate of this position at a forward speed in m/s.
    #[must_use]
    pub fn rate(&self, speed: f64) -> f64 {
        self.per_speed * speed
    }

    /// The forward speed in m/s at the rates of all positions.
    ///
    /// # Panics
    /// If there are too few.
    #[must_use]
    pub fn speed(&self, rates: &[f64]) -> f64 {
        rates[self.position] / self.per_speed
    }
}
