//! Verdicts along speed, wherever they are kept.

#[cfg(feature = "std")]
use super::ranges::MarginalRange;
use super::ranges::StableRange;
use super::verdict::Verdict;

/// The verdict at every speed: constant between speeds at which an eigenvalue is on the imaginary axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Verdicts<S> {
    /// Ascending; the first one is from zero, the last one has no end.
    pub(super) stretches: S,
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

/// The stretches between speeds, with verdicts at rest and at these bounds, ascending, and a function for those between;
/// `None` in the place of one about which that is not certain.
pub(super) fn stretches_between(
    at_rest: Verdict,
    bounds: &[(f64, Verdict)],
    at: impl Fn(f64) -> Option<Verdict>,
) -> impl Iterator<Item = Option<Stretch>> {
    let first = (0.0, at_rest);
    let starts = core::iter::once(first).chain(bounds.iter().copied());
    let ends = bounds.iter().map(|&(speed, _)| Some(speed)).chain([None]);
    starts.zip(ends).map(move |((speed, verdict), end)| {
        let inside = match end {
            Some(end) => 0.5 * (speed + end),
            None if speed == 0.0 => 1.0,
            None => 2.0 * speed,
        };
        Some(Stretch { speed, at: Some(verdict), above: at(inside)? })
    })
}

impl<S: AsRef<[Stretch]>> Verdicts<S> {
    /// The verdict at a speed that is not negative.
    pub(super) fn at(&self, speed: f64) -> Option<Verdict> {
        let stretches = self.stretches.as_ref();
        let above = stretches.partition_point(|stretch| stretch.speed <= speed);
        let stretch = stretches.get(above.max(1) - 1)?;
        if stretch.speed == speed { stretch.at } else { Some(stretch.above) }
    }

    pub(super) fn stable_ranges(&self) -> impl Iterator<Item = StableRange> {
        let stretches = self.stretches.as_ref();
        let ends = stretches.iter().skip(1).map(|next| Some(next.speed)).chain([None]);
        let ranges = stretches.iter().zip(ends).filter(|(stretch, _)| stretch.above == Verdict::Stable);
        ranges.map(|(stretch, to)| StableRange { from: stretch.speed, to })
    }
}

#[cfg(feature = "std")]
impl Verdicts<Vec<Stretch>> {
    /// The verdicts just below and just above a speed that is not negative; at rest the one above stands for both.
    pub(super) fn around(&self, speed: f64) -> [Verdict; 2] {
        let above = self.stretches.partition_point(|stretch| stretch.speed <= speed);
        let below = self.stretches.partition_point(|stretch| stretch.speed < speed);
        [below, above].map(|next| self.stretches[next.max(1) - 1].above)
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
