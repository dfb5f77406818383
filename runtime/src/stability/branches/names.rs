//! What the branches are called, and from which speed to which.

use nalgebra::Complex;

use super::Branches;
use super::assign::cleaned;
use crate::stability::critical::{CriticalKind, CriticalSpeed};
use crate::stability::mode::Mode;
use crate::system::SystemError;

/// A name, and the speed from which on a branch has it.
pub(super) type Named = (f64, Option<Mode>);

/// How far below a critical speed, relative to it, the branch is looked for that is on the axis there: where branches meet at
/// it, nothing tells them apart.
const BELOW: f64 = 1e-4;

impl Branches {
    /// The names of each branch, ascending by speed; the first from the lowest speed on.
    ///
    /// A name holds between meetings. From critical speeds it goes on to stretches that have none, the next one first; of two
    /// as near, that from below.
    pub(super) fn find_names(
        &self,
        critical_speeds: &[CriticalSpeed],
        is_bicycle: bool,
    ) -> Result<Vec<Vec<Named>>, SystemError> {
        let (Some(first), Some(last)) = (self.nodes.first(), self.nodes.last()) else { return Ok(Vec::new()) };
        let mut names: Vec<Vec<Named>> = (0..first.values.len())
            .map(|branch| {
                let met = self.meetings.iter().filter(|meeting| meeting.branches.contains(&branch));
                [first.speed].into_iter().chain(met.map(|meeting| meeting.speed)).map(|speed| (speed, None)).collect()
            })
            .collect();
        let followed = critical_speeds.iter().filter(|critical| (first.speed..=last.speed).contains(&critical.speed));
        for critical in followed {
            let Some(mode) = critical.mode(is_bicycle) else { continue };
            let below = critical.speed * (1.0 - BELOW);
            for branch in self.on_axis(critical, &self.values(below)?) {
                let stretch = names[branch].partition_point(|(from, _)| *from <= below).max(1) - 1;
                // The name of a stretch is that of its first critical speed.
                names[branch][stretch].1.get_or_insert(mode);
            }
        }
        for stretches in &mut names {
            let known: Vec<Option<Mode>> = stretches.iter().map(|(_, name)| *name).collect();
            for (place, (_, name)) in stretches.iter_mut().enumerate() {
                let named = (0..known.len()).filter(|&other| known[other].is_some());
                *name = named.min_by_key(|&other| other.abs_diff(place)).and_then(|other| known[other]);
            }
        }
        Ok(names)
    }

    /// The branches that are on the imaginary axis at a critical speed, by their values just below it: two of a pair, those of
    /// two pairs that meet, or one that is not zero at all speeds; of a real pair that meets in zero that which is unstable.
    fn on_axis(&self, critical: &CriticalSpeed, values: &[Complex<f64>]) -> Vec<usize> {
        let nearest = |target: Complex<f64>, is_wanted: &dyn Fn(usize) -> bool| {
            let wanted = (0..values.len()).filter(|&branch| is_wanted(branch));
            let distance = |branch: usize| (values[branch] - target).norm();
            wanted.min_by(|&i, &j| match (distance(i) - distance(j)).abs() <= TIE * distance(i) {
                true => values[j].re.total_cmp(&values[i].re),
                false => distance(i).total_cmp(&distance(j)),
            })
        };
        let target = Complex::new(0.0, critical.eigenvalue.im);
        match critical.kind {
            CriticalKind::Capsize => {
                let is_real = |branch: usize| values[branch].im == 0.0 && !self.is_zero(branch);
                let is_any = |branch: usize| !self.is_zero(branch);
                nearest(target, &is_real).or_else(|| nearest(target, &is_any)).into_iter().collect()
            }
            _ => {
                let upper = nearest(target, &|branch| values[branch].im > 0.0);
                let lower = nearest(target.conj(), &|branch| values[branch].im < 0.0);
                let mut found: Vec<usize> = [upper, lower].into_iter().flatten().collect();
                if critical.kind == CriticalKind::DoubleRoot {
                    // Another pair meets this one.
                    let upper = nearest(target, &|branch| values[branch].im > 0.0 && !found.contains(&branch));
                    let lower = nearest(target.conj(), &|branch| values[branch].im < 0.0 && !found.contains(&branch));
                    found.extend([upper, lower].into_iter().flatten());
                }
                found
            }
        }
    }

    /// Whether an eigenvalue is zero at all speeds.
    fn is_zero(&self, branch: usize) -> bool {
        self.nodes.iter().all(|node| cleaned(&node.values)[branch] == Complex::new(0.0, 0.0))
    }
}

/// Distances that differ by less, relative to them, are equal.
const TIE: f64 = 1e-6;
