//! What happens within a step: where functions of the motion change their signs.

use super::nonlinear::Simulation;
use crate::motion::MotionError;

/// Into how many parts a step is divided, to see changes of sign that would hide in it.
const PARTS: usize = 4;

/// The events in a step, in their order and up to one that ends the simulation; the values of their functions become those
/// at its end.
pub(super) fn happened(
    simulation: &Simulation,
    (begin, end): (f64, f64),
    values: &mut Vec<f64>,
    at: &dyn Fn(f64) -> Result<Vec<f64>, MotionError>,
) -> Result<Vec<(f64, usize)>, MotionError> {
    let mut happened = Vec::new();
    if values.is_empty() {
        return Ok(happened);
    }
    for part in 1..=PARTS {
        let moment = if part == PARTS { end } else { begin + (end - begin) * part as f64 / PARTS as f64 };
        let from = begin + (end - begin) * (part - 1) as f64 / PARTS as f64;
        let after = simulation.event_functions(moment, &at(moment)?)?;
        let mut found = Vec::new();
        for (event, (before, after)) in values.iter().zip(&after).enumerate() {
            if before * after < 0.0 || *after == 0.0 && *before != 0.0 {
                let value = |t| Ok(simulation.event_functions(t, &at(t)?)?[event]);
                found.push((change_of_sign((from, *before), moment, value)?, event));
            }
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        *values = after;
        for (moment, event) in found {
            happened.push((moment, event));
            if simulation.named(event).1 {
                return Ok(happened);
            }
        }
    }
    Ok(happened)
}

/// The time between two at which a function changes its sign, to rounding: the latter of two neighbours.
fn change_of_sign(
    (mut from, before): (f64, f64),
    mut to: f64,
    value: impl Fn(f64) -> Result<f64, MotionError>,
) -> Result<f64, MotionError> {
    // As often as a double can be halved.
    for _ in 0..100 {
        let middle = from + 0.5 * (to - from);
        if middle <= from || middle >= to {
            break;
        }
        if value(middle)? * before > 0.0 {
            from = middle;
        } else {
            to = middle;
        }
    }
    Ok(to)
}
