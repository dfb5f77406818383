//! Verdicts along speed.

use core::cmp::Ordering;

use super::characteristic::Characteristic;
use super::search::Found;
use super::verdict::{Verdict, verdict};
use crate::number::real::Real;
use crate::numeric::{DoubleDouble, NOISE, positive_roots};

/// An open range of speeds in which every eigenvalue has a negative real part.
///
/// The ends do not belong to it, with one exception: a range from zero contains zero if the motion is stable at rest,
/// which [`Stability::verdict`](crate::Stability::verdict) tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StableRange {
    /// The lower end in m/s.
    pub from: f64,
    /// The upper end in m/s; `None` if the range has no end.
    pub to: Option<f64>,
}

/// The verdict at every speed: constant between speeds at which an eigenvalue is on the imaginary axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Verdicts {
    /// Ascending; the first one is from zero, the last one has no end.
    stretches: Vec<Stretch>,
}

/// The speeds from one on, up to the next stretch.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Stretch {
    speed: f64,
    /// The verdict at the lower end.
    at: Verdict,
    /// The verdict above it.
    above: Verdict,
}

impl Verdicts {
    pub(super) fn new(characteristic: &Characteristic, found: &[Found]) -> Self {
        let at = |speed: DoubleDouble| verdict(&characteristic.at(speed));
        let bounds = bounds(characteristic, found);
        let above = |i: usize| match (i.checked_sub(1).map(|i| bounds[i].speed), bounds.get(i)) {
            (None, None) => at(DoubleDouble::from(1.0)),
            (None, Some(next)) => at(next.speed * 0.5.into()),
            (Some(last), None) => at(last + last),
            (Some(last), Some(next)) => at((last + next.speed) * 0.5.into()),
        };
        let mut stretches = Vec::with_capacity(bounds.len() + 1);
        let mut last = Stretch { speed: 0.0, at: at(DoubleDouble::ZERO), above: above(0) };
        for (i, bound) in bounds.iter().enumerate() {
            let next = Stretch {
                speed: characteristic.speed(bound.speed.to_f64()),
                at: bound.verdict.unwrap_or(last.above.min(above(i + 1))),
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
        Self { stretches }
    }

    /// With verdicts at rest and at the bounds, ascending, and a function for those between.
    pub(super) fn between(
        at_rest: Verdict,
        bounds: &[(f64, Verdict)],
        at: impl Fn(f64) -> Option<Verdict>,
    ) -> Option<Self> {
        let mut stretches = Vec::with_capacity(bounds.len() + 1);
        let (mut speed, mut verdict) = (0.0, at_rest);
        for &(next, next_verdict) in bounds {
            stretches.push(Stretch { speed, at: verdict, above: at(0.5 * (speed + next))? });
            (speed, verdict) = (next, next_verdict);
        }
        let above = at(if speed == 0.0 { 1.0 } else { 2.0 * speed })?;
        stretches.push(Stretch { speed, at: verdict, above });
        Some(Self { stretches })
    }

    /// The verdict at a speed that is not negative.
    pub(super) fn at(&self, speed: f64) -> Verdict {
        let above = self.stretches.partition_point(|stretch| stretch.speed <= speed);
        let stretch = self.stretches[above.max(1) - 1];
        if stretch.speed == speed { stretch.at } else { stretch.above }
    }

    pub(super) fn stable_ranges(&self) -> Vec<StableRange> {
        let ends = self.stretches.iter().skip(1).map(|next| Some(next.speed)).chain([None]);
        let ranges = self.stretches.iter().zip(ends).filter(|(stretch, _)| stretch.above == Verdict::Stable);
        ranges.map(|(stretch, to)| StableRange { from: stretch.speed, to }).collect()
    }
}

/// A speed between different verdicts.
struct Bound {
    speed: DoubleDouble,
    /// The verdict at it, or the better one of the two sides.
    verdict: Option<Verdict>,
}

fn bounds(characteristic: &Characteristic, found: &[Found]) -> Vec<Bound> {
    let mut bounds: Vec<Bound> = if characteristic.hurwitz().is_zero() {
        // Two eigenvalues sum to zero at all speeds: nothing is stable, but it may be marginal in places.
        let discriminant = characteristic.discriminant();
        let polynomials = characteristic.coefficients().iter().chain([&discriminant]);
        polynomials.flat_map(positive_roots).map(|root| Bound { speed: root.at, verdict: None }).collect()
    } else {
        let on_the_axis = found.iter().filter(|found| found.there.is_some());
        on_the_axis.map(|found| Bound { speed: found.at, verdict: found.there }).collect()
    };
    bounds.sort_by(|x, y| x.speed.partial_cmp(&y.speed).unwrap_or(Ordering::Equal));
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

/// Whether two speeds are the same to the precision of the search.
pub(super) fn is_same(x: DoubleDouble, y: DoubleDouble) -> bool {
    (x - y).abs() <= y.abs() * NOISE.into()
}
