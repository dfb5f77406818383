//! What is computed for a bicycle, once, for every way of showing it.

use std::ops::RangeInclusive;

use carvallo::{Coefficients, ModeValue, Model, Modes, Stability, SystemError};

use crate::failure::Failure;
use crate::input::Bicycle;
use crate::number::shortest;

/// Sizes beyond which a parameter makes the others vanish in rounding, or leaves the range of doubles.
const ORDINARY: RangeInclusive<f64> = 1e-20..=1e20;

/// A bicycle with everything about it along speed.
pub struct Analysis {
    pub bicycle: Bicycle,
    /// The gravitational field strength in N/kg.
    pub gravity: f64,
    pub coefficients: Coefficients<f64, 2>,
    pub stability: Stability,
    modes: Modes,
}

/// The eigenvalues at one speed.
pub struct Row {
    pub speed: f64,
    /// Castering, capsize, weave and weave.
    pub values: [ModeValue; 4],
}

impl Analysis {
    /// # Errors
    /// If the equations of motion have no answer, such as for a singular mass matrix.
    pub fn new(bicycle: Bicycle) -> Result<Self, Failure> {
        let coefficients = bicycle.model.coefficients();
        // A model without gravity as its parameter has no terms with it either.
        let gravity = bicycle.model.gravity().unwrap_or(0.0);
        let fail = |error: SystemError| Failure::Run(format!("{}: {error}{}", bicycle.name, extremes(&bicycle)));
        let stability = Stability::new(&coefficients, gravity).map_err(fail)?;
        let modes = Modes::new(&coefficients, gravity).map_err(fail)?;
        Ok(Self { bicycle, gravity, coefficients, stability, modes })
    }

    /// The eigenvalues at each of the speeds.
    ///
    /// # Errors
    /// If they cannot be computed at one of them.
    pub fn rows(&self, speeds: &[f64]) -> Result<Vec<Row>, Failure> {
        let row = |&speed: &f64| match self.modes.at(speed) {
            Ok(values) => Ok(Row { speed, values }),
            Err(error) => {
                let (name, speed, hint) = (&self.bicycle.name, shortest(speed), extremes(&self.bicycle));
                Err(Failure::Run(format!("{name} at {speed} m/s: {error}{hint}")))
            }
        };
        speeds.iter().map(row).collect()
    }
}

/// The parameters that are probably to blame where there is no answer, as the end of a sentence.
fn extremes(bicycle: &Bicycle) -> String {
    let parameters = bicycle.info().parameters.iter().zip(&bicycle.parameters);
    let extremes = parameters.filter(|(_, given)| given.value != 0.0 && !ORDINARY.contains(&given.value.abs()));
    let extremes: Vec<String> =
        extremes.map(|(info, given)| format!("{} = {}", info.name, shortest(given.value))).collect();
    if extremes.is_empty() { String::new() } else { format!("; parameters of extreme size: {}", extremes.join(", ")) }
}
