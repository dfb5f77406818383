//! Verdicts along speed from the critical speeds.

use core::cmp::Ordering;

use super::found::{FoundSpeed, is_same};
use crate::numeric::{DoubleDouble, positive_roots, sort_by};
use crate::stability::along_speed::Characteristic;
use crate::stability::verdict::Verdict;
use crate::stability::verdicts::{Stretch, Verdicts};

/// The verdict at every speed.
pub(super) fn find_verdicts(characteristic: &Characteristic, found: &[FoundSpeed]) -> Verdicts<Vec<Stretch>> {
    let at = |speed: DoubleDouble| Verdict::of_polynomial(&characteristic.at(speed));
    let bounds = find_verdict_changes(characteristic, found);
    let above = |i: usize| match (i.checked_sub(1).map(|i| bounds[i].speed), bounds.get(i)) {
        (None, None) => at(DoubleDouble::from(1.0)),
        (None, Some(next)) => at(next.speed * 0.5.into()),
        (Some(last), None) => at(last + last),
        (Some(last), Some(next)) => at((last + next.speed) * 0.5.into()),
    };
    let mut stretches = Vec::with_capacity(bounds.len() + 1);
    let mut last = Stretch { speed: 0.0, at: Some(at(DoubleDouble::ZERO)), above: above(0) };
    for (i, bound) in bounds.iter().enumerate() {
        let next = Stretch {
            speed: characteristic.speed(bound.speed.to_f64()),
            at: bound.verdict.or(Some(last.above.min(above(i + 1)))),
            above: above(i + 1),
        };
        if next.speed > last.speed {
            stretches.push(last);
            last = next;
        } else {
            // No number is between the two bounds.
            last = Stretch { at: last.at.max(next.at), ..next };
        }
    }
    stretches.push(last);
    Verdicts { stretches }
}

/// A speed between different verdicts.
struct VerdictChange {
    speed: DoubleDouble,
    /// The verdict at it, or the better one of the two sides.
    verdict: Option<Verdict>,
}

fn find_verdict_changes(characteristic: &Characteristic, found: &[FoundSpeed]) -> Vec<VerdictChange> {
    let mut bounds: Vec<VerdictChange> = if characteristic.hurwitz().is_zero() {
        // Two eigenvalues sum to zero at all speeds: nothing is stable, but it may be marginal in places.
        let discriminant = characteristic.discriminant();
        let polynomials = characteristic.coefficients().iter().chain([&discriminant]);
        polynomials.flat_map(positive_roots).map(|root| VerdictChange { speed: root.at, verdict: None }).collect()
    } else {
        let on_the_axis = found.iter().filter(|found| found.there.is_some());
        on_the_axis.map(|found| VerdictChange { speed: found.at, verdict: found.there }).collect()
    };
    sort_by(&mut bounds, |x, y| x.speed.partial_cmp(&y.speed).unwrap_or(Ordering::Equal));
    // At a speed with two reasons to be a bound the worse verdict holds.
    bounds.dedup_by(|next, bound| {
        let same = is_same(bound.speed, next.speed);
        if same {
            bound.verdict = bound.verdict.max(next.verdict);
        }
        same
    });
    bounds
}
