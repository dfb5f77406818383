//! What a motion begins with.

use super::error::{SimulationError, require_finite};
use super::machine::Moving;

/// The state of a [`Machine`](super::Machine): all that decides how it goes on.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// The position of everything, such that every wheel touches the ground.
    pub positions: Vec<f64>,
    /// The speeds: the rates that rolling leaves free.
    pub speeds: Vec<f64>,
}

impl State {
    /// The state in which some positions and rates have values, by the names of
    /// [`MotionInfo`](crate::motion::MotionInfo), and all others are zero; those that depend on them follow.
    ///
    /// Of a position that the heights of the wheels determine, the value is where the search for it begins.
    ///
    /// # Errors
    /// If there is no position or no free rate of a name, if a value is not finite, or if the wheels cannot all touch the
    /// ground.
    pub fn new(
        machine: &dyn Moving,
        positions: &[(&str, f64)],
        rates: &[(&str, f64)],
    ) -> Result<Self, SimulationError> {
        let info = machine.info();
        let mut state = Self { positions: vec![0.0; info.positions.len()], speeds: vec![0.0; info.speeds.len()] };
        let unknown = |what, name: &str| SimulationError::Unknown { what, name: name.to_owned() };
        for &(name, value) in positions {
            let place = info.position(name).ok_or_else(|| unknown("position", name))?;
            require_finite("initial positions", &[value])?;
            state.positions[place] = value;
        }
        for &(name, value) in rates {
            let place = info.position(name).and_then(|place| info.speed_of(place));
            require_finite("initial rates", &[value])?;
            state.speeds[place.ok_or_else(|| unknown("free rate", name))?] = value;
        }
        machine.close(&mut state.positions).map_err(|error| SimulationError::Motion { time: 0.0, error })?;
        Ok(state)
    }
}
