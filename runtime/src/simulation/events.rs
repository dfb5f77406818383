//! What happens within a step: where functions of the motion change their signs.

use super::crossing::change_of_sign;
use super::nonlinear::{Event, Happening, Simulation};
use crate::motion::MotionError;
use crate::numeric::sort_by;

/// Into how many parts a step is divided, to see changes of sign that would hide in it.
const PARTS: usize = 4;

/// The events in a step, in their order and up to one that ends the simulation, and whether one does; the values of their
/// functions become those at its end.
pub(super) fn happened(
    simulation: &Simulation,
    (begin, end): (f64, f64),
    values: &mut Vec<f64>,
    earlier: &[Happening],
    at: &dyn Fn(f64) -> Result<Vec<f64>, MotionError>,
) -> Result<(Vec<(f64, usize)>, bool), MotionError> {
    let mut happened = Vec::new();
    if values.is_empty() {
        return Ok((happened, false));
    }
    for part in 1..=PARTS {
        let moment = if part == PARTS { end } else { begin + (end - begin) * part as f64 / PARTS as f64 };
        let from = begin + (end - begin) * (part - 1) as f64 / PARTS as f64;
        let after = simulation.event_functions(moment, &at(moment)?)?;
        let mut found = Vec::new();
        for (event, (before, after)) in values.iter().zip(&after).enumerate() {
            if simulation.watched(event).crossing.is_between(*before, *after) {
                let value = |t| Ok(simulation.event_functions(t, &at(t)?)?[event]);
                found.push((change_of_sign((from, *before), moment, value)?, event));
            }
        }
        sort_by(&mut found, |a, b| a.0.total_cmp(&b.0));
        *values = after;
        for (moment, event) in found {
            happened.push((moment, event));
            let Event { name, ends, .. } = simulation.watched(event);
            let before = earlier.iter().filter(|earlier| earlier.name == *name).count();
            let now = happened.iter().filter(|(_, other)| simulation.watched(*other).name == *name).count();
            if ends.is_some_and(|ends| before + now >= ends) {
                return Ok((happened, true));
            }
        }
    }
    Ok((happened, false))
}
