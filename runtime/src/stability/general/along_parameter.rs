//! Critical values of a parameter over a range: the same search as along the speed, piece by piece where the matrices are
//! no polynomials in all of it.

use nalgebra::Complex;

use super::chebyshev::{Triple, interpolate};
use super::equations::Equations;
use super::verdict_at;
use crate::stability::critical::Change;
use crate::stability::parameter::{CriticalValue, ParameterStabilityError, ParameterStretch};
use crate::system::{States, SystemError};

/// How often a range is halved at most.
const DEPTH: usize = 6;

/// What is known over a range.
#[derive(Default)]
pub(in crate::stability) struct Found {
    pub(in crate::stability) critical: Vec<CriticalValue>,
    pub(in crate::stability) stretches: Vec<ParameterStretch>,
    pub(in crate::stability) undecided: Vec<[f64; 2]>,
    /// At the upper end.
    pub(in crate::stability) last: Option<ParameterStretch>,
}

/// The matrices M, C and K at a value of the parameter.
pub(in crate::stability) type At<'a, E> = &'a mut dyn FnMut(f64) -> Result<Triple, E>;

/// Adds what is found in a range to what was found below it.
pub(in crate::stability) fn search<E>(
    range: [f64; 2],
    depth: usize,
    states: &[States],
    at: At<E>,
    found: &mut Found,
) -> Result<(), ParameterStabilityError<E>> {
    let failed = |error: SystemError| ParameterStabilityError::Analysis { from: range[0], to: range[1], error };
    let system = |(value, error)| ParameterStabilityError::System { value, error };
    let coefficients = {
        let mut named = |value: f64| at(value).map_err(|error| (value, error));
        interpolate(range, &mut named).map_err(system)?
    };
    let Some([m, c, k]) = coefficients else {
        if depth == DEPTH {
            return Err(ParameterStabilityError::NotSmooth { from: range[0], to: range[1] });
        }
        let middle = 0.5 * (range[0] + range[1]);
        search([range[0], middle], depth + 1, states, at, found)?;
        return search([middle, range[1]], depth + 1, states, at, found);
    };
    let equations = match Equations::along_parameter([&m, &c, &k], states) {
        Err(SystemError::SingularMass) => return Err(ParameterStabilityError::Singular { value: range[0] }),
        other => other.map_err(failed)?,
    };
    let value = |v: f64| range[0] + (v - 1.0) * (range[1] - range[0]);
    if let Some(v) = equations.find_singular().map_err(failed)? {
        return Err(ParameterStabilityError::Singular { value: value(v) });
    }
    let course = equations.complete(equations.find_crossings().map_err(failed)?).map_err(failed)?;
    let verdict = |v: f64| equations.count(v).map(|count| count.verdict()).map_err(failed);
    found.stretches.push(ParameterStretch {
        value: range[0],
        at: verdict(1.0)?,
        above: course.between[0].verdict(),
        is_critical: false,
    });
    for (i, group) in course.groups.iter().enumerate() {
        let mut at_value = range[1];
        for crossing in &course.found[group.clone()] {
            let v = crossing.crossing.v;
            // With all digits, also where the range is far wider than the value.
            at_value = range[0] + (v - 1.0.into()).to_f64() * (range[1] - range[0]);
            let rounding = f64::EPSILON * (at_value.abs() + 4.0 * (range[1] - range[0]));
            found.critical.push(CriticalValue {
                kind: crossing.kind,
                value: at_value,
                error: crossing.crossing.error * (range[1] - range[0]) + rounding,
                eigenvalue: equations.units.eigenvalue(Complex::new(0.0, crossing.crossing.omega)),
                change: crossing.change.unwrap_or(Change::Touches),
            });
        }
        let (at, above) = (verdict_at(&course, i), course.between[i + 1].verdict());
        found.stretches.push(ParameterStretch { value: at_value, at, above, is_critical: true });
    }
    found.undecided.extend(course.undecided.iter().map(|ends| ends.map(value)));
    let end = verdict(2.0)?;
    found.last = Some(ParameterStretch { value: range[1], at: end, above: end, is_critical: false });
    Ok(())
}
