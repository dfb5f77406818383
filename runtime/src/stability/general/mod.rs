//! Critical speeds and stable ranges of any number of coordinates, of any powers of the speed and orders of coordinates.
//!
//! Two conditions are functions of the speed alone that are zero at critical speeds: the product of all eigenvalues, and
//! that of all sums of two of them. Up to a known power of the speed both are polynomials in `v / (1 + v)` of known degree,
//! so that interpolation has them exactly; how often they are zero in an interval is read from their coefficients.
//!
//! - [`units`], [`functions`], [`combination`], [`equations`], [`pencil`]: the equations in scaled units, their
//!   eigenvalues and their pencil at a speed;
//! - [`polynomials`]: the conditions of two to four coordinates as polynomials with known coefficients, which are all that
//!   it takes where their zeros are certain; otherwise:
//! - [`condition`], [`sums`], [`product`], [`polynomial`]: the conditions, and what they are as polynomials;
//! - [`samples`], [`bernstein`], [`isolation`]: all of their zeros, each in an interval of its own;
//! - [`field`], [`inverse`], [`newton`]: critical speeds and eigenvalues to all digits;
//! - [`crossings`]: the critical speeds in the intervals;
//! - [`chebyshev`], [`along_parameter`]: the same along another parameter, over a range;
//! - [`count`], [`complete`]: whether the numbers of unstable eigenvalues between them agree, and the search where not.

mod along_parameter;
mod bernstein;
mod chebyshev;
mod combination;
mod complete;
mod condition;
mod count;
mod crossings;
mod equations;
mod field;
mod functions;
mod inverse;
mod isolation;
mod newton;
mod pencil;
mod polynomial;
mod polynomials;
mod product;
mod samples;
mod sums;
#[cfg(test)]
mod tests;
mod units;

use nalgebra::Complex;

pub(super) use self::along_parameter::{Found, search};
use self::complete::Course;
use self::count::Count;
use self::equations::Equations;
pub(super) use self::equations::Matrices;
use super::critical::{Change, CriticalKind, CriticalSpeed};
use super::ranges::UndecidedRange;
use super::verdict::Verdict;
use super::verdicts::{Stretch, Verdicts};
use crate::system::SystemError;

/// What is known along the speed.
pub(super) struct Answer {
    /// Ascending.
    pub(super) critical_speeds: Vec<CriticalSpeed>,
    pub(super) verdicts: Verdicts<Vec<Stretch>>,
    pub(super) undecided: Vec<UndecidedRange>,
}

/// All critical speeds, ascending, and the verdicts between and at them.
pub(super) fn find_stability(matrices: &Matrices, gravity: f64) -> Result<Answer, SystemError> {
    let equations = Equations::new(matrices, gravity)?;
    let course = equations.complete(equations.find_crossings()?)?;
    let critical_speeds = critical_speeds(&equations, &course)?;
    let undecided = course
        .undecided
        .iter()
        .map(|&[low, high]| UndecidedRange { from: equations.units.speed(low), to: equations.units.speed(high) });
    let undecided = undecided.collect();
    // With C-1 there is no motion at rest, and where that is not regular either.
    let at_rest = if equations.excludes_rest() { None } else { equations.count(0.0).ok().map(Count::verdict) };
    let mut verdicts = vec![Stretch { speed: 0.0, at: at_rest, above: course.between[0].verdict() }];
    for (i, group) in course.groups.iter().enumerate() {
        let speed = critical_speeds[group.start].speed;
        let at = Some(verdict_at(&course, i));
        verdicts.push(Stretch { speed, at, above: course.between[i + 1].verdict() });
    }
    Ok(Answer { critical_speeds, verdicts: Verdicts { stretches: verdicts }, undecided })
}

fn critical_speeds(equations: &Equations, course: &Course) -> Result<Vec<CriticalSpeed>, SystemError> {
    let critical = course.found.iter().map(|found| {
        let speed = equations.speed(found.crossing.v);
        let error = equations.units.speed(found.crossing.error) + 0.5 * f64::EPSILON * speed;
        let eigenvalue = equations.units.eigenvalue(Complex::new(0.0, found.crossing.omega));
        let change = found.change.unwrap_or(Change::Touches);
        let is_finite = [speed, error, eigenvalue.im].iter().all(|number| number.is_finite()) && speed > 0.0;
        let critical = CriticalSpeed { kind: found.kind, speed, error, eigenvalue, change };
        is_finite.then_some(critical).ok_or(SystemError::OutOfRange { quantity: "a critical speed" })
    });
    critical.collect()
}

/// The verdict at the speed of a group: by the eigenvalues that are not on the axis there.
fn verdict_at(course: &Course, i: usize) -> Verdict {
    let leaving = course.found[course.groups[i].clone()].iter().map(|found| match (found.change, found.kind) {
        (Some(Change::Stabilizes), CriticalKind::Capsize) => 1,
        (Some(Change::Stabilizes), _) => 2,
        _ => 0,
    });
    let rest = course.between[i].unstable.saturating_sub(leaving.sum());
    if rest > 0 { Verdict::Unstable } else { Verdict::Marginal }
}
