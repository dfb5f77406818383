//! Verdicts along speed.

use super::verdict::Verdict;

/// An open range of speeds in which every eigenvalue has a negative real part.
///
/// The ends do not belong to it, with one exception: a range from zero contains zero if the motion is stable at rest,
/// which [`Stability::verdict`](crate::Stability::verdict) tells.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct StableRange {
    /// The lower end in m/s.
    pub from: f64,
    /// The upper end in m/s; `None` if the range has no end.
    pub to: Option<f64>,
}

/// A range of speeds in which no motion grows and some do not die away, as those of a rolling disc above its critical
/// speed.
///
/// [`Stability::verdict`](crate::Stability::verdict) tells what holds at its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct MarginalRange {
    /// The lower end in m/s.
    pub from: f64,
    /// The upper end in m/s; `None` if the range has no end.
    pub to: Option<f64>,
}

/// An open range of speeds in which something is missing: as many eigenvalues are unstable at its ends as the critical
/// speeds in it do not explain, and what they do between them is within rounding of the imaginary axis.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct UndecidedRange {
    /// The lower end in m/s.
    pub from: f64,
    /// The upper end in m/s.
    pub to: f64,
}

/// The verdict at every speed: constant between speeds at which an eigenvalue is on the imaginary axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Verdicts {
    /// Ascending; the first one is from zero, the last one has no end.
    pub(super) stretches: Vec<Stretch>,
}

/// The speeds from one on, up to the next stretch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stretch {
    pub(super) speed: f64,
    /// The verdict at the lower end; none at rest where the damping C-1/v has no value there.
    pub(super) at: Option<Verdict>,
    /// The verdict above it.
    pub(super) above: Verdict,
}

impl Verdicts {
    /// With verdicts at rest and at the bounds, ascending, and a function for those between.
    pub(super) fn between(
        at_rest: Verdict,
        bounds: &[(f64, Verdict)],
        at: impl Fn(f64) -> Option<Verdict>,
    ) -> Option<Self> {
        let mut stretches = Vec::with_capacity(bounds.len() + 1);
        let (mut speed, mut verdict) = (0.0, at_rest);
        for &(next, next_verdict) in bounds {
            stretches.push(Stretch { speed, at: Some(verdict), above: at(0.5 * (speed + next))? });
            (speed, verdict) = (next, next_verdict);
        }
        let above = at(if speed == 0.0 { 1.0 } else { 2.0 * speed })?;
        stretches.push(Stretch { speed, at: Some(verdict), above });
        Some(Self { stretches })
    }

    /// The verdict at a speed that is not negative.
    pub(super) fn at(&self, speed: f64) -> Option<Verdict> {
        let above = self.stretches.partition_point(|stretch| stretch.speed <= speed);
        let stretch = self.stretches[above.max(1) - 1];
        if stretch.speed == speed { stretch.at } else { Some(stretch.above) }
    }

    /// The verdicts just below and just above a speed that is not negative; at rest the one above stands for both.
    pub(super) fn around(&self, speed: f64) -> [Verdict; 2] {
        let above = self.stretches.partition_point(|stretch| stretch.speed <= speed);
        let below = self.stretches.partition_point(|stretch| stretch.speed < speed);
        [below, above].map(|next| self.stretches[next.max(1) - 1].above)
    }

    pub(super) fn stable_ranges(&self) -> Vec<StableRange> {
        let ends = self.stretches.iter().skip(1).map(|next| Some(next.speed)).chain([None]);
        let ranges = self.stretches.iter().zip(ends).filter(|(stretch, _)| stretch.above == Verdict::Stable);
        ranges.map(|(stretch, to)| StableRange { from: stretch.speed, to }).collect()
    }

    /// Real parts are continuous, so that no motion grows at a speed between two marginal stretches, which are one range.
    pub(super) fn marginal_ranges(&self) -> Vec<MarginalRange> {
        let mut ranges: Vec<MarginalRange> = Vec::new();
        for stretch in &self.stretches {
            let is_marginal = stretch.above == Verdict::Marginal;
            match ranges.last_mut() {
                Some(open) if open.to.is_none() && !is_marginal => open.to = Some(stretch.speed),
                Some(open) if open.to.is_none() => {}
                _ if is_marginal => ranges.push(MarginalRange { from: stretch.speed, to: None }),
                _ => {}
            }
        }
        ranges
    }
}
