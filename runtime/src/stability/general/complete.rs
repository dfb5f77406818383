//! Whether the critical speeds are complete: between neighbours as many eigenvalues are unstable as they say.

use super::count::Count;
use super::crossings::{Findings, Found};
use super::equations::Equations;
use crate::numeric::sort_by;
use crate::stability::critical::{Change, CriticalKind};
use crate::system::SystemError;

/// The critical speeds with what lies between them.
pub(super) struct Course {
    /// Ascending.
    pub(super) found: Vec<Found>,
    /// Those that are the same to all digits are one: the range of each in `found`.
    pub(super) groups: Vec<core::ops::Range<usize>>,
    /// Below each of the groups, and above the last.
    pub(super) between: Vec<Count>,
    /// The lower end, and the upper one if there is one.
    ends: (f64, Option<f64>),
    /// Scaled speeds between which something is missing.
    pub(super) undecided: Vec<[f64; 2]>,
}

/// How often the search goes on by another way.
const ROUNDS: usize = 4;

/// How many gaps are searched in one round.
const GAPS: usize = 16;

/// Speeds that differ by less, relative to them, are the same.
const SAME: f64 = 1e-11;

impl Equations {
    /// Sorts what was found, and finds what counts of unstable eigenvalues show to be missing.
    pub(super) fn complete(&self, Findings { found, samples, unexamined }: Findings) -> Result<Course, SystemError> {
        let mut course = self.course(found)?;
        for _ in 0..ROUNDS {
            let gaps = course.gaps(&samples);
            if gaps.is_empty() || self.is_exhausted() {
                break;
            }
            let mut found = course.found.clone();
            for &([low, high], unstable) in gaps.iter().take(GAPS) {
                if !self.is_exhausted() {
                    self.bisect([low, high], unstable, &mut found)?;
                }
            }
            if found.len() == course.found.len() {
                break;
            }
            course = self.course(found)?;
        }
        let gaps = course.gaps(&samples).into_iter().map(|(gap, _)| gap);
        course.undecided = union(gaps.chain(unexamined).collect());
        Ok(course)
    }

    fn course(&self, mut found: Vec<Found>) -> Result<Course, SystemError> {
        if let (low, Some(high)) = self.variable.ends() {
            found.retain(|found| found.v() > low && found.v() <= high);
        }
        sort_by(&mut found, |x, y| x.v().total_cmp(&y.v()));
        let mut groups: Vec<core::ops::Range<usize>> = Vec::new();
        for i in 0..found.len() {
            match groups.last_mut() {
                Some(group) if found[i].v() - found[group.start].v() <= SAME * found[i].v() => group.end = i + 1,
                _ => groups.push(i..i + 1),
            }
        }
        let ends = self.variable.ends();
        let between =
            (0..=groups.len()).map(|i| self.count(middle(&found, &groups, i, ends))).collect::<Result<_, _>>()?;
        let mut course = Course { found, groups, between, ends, undecided: Vec::new() };
        course.decide_changes();
        Ok(course)
    }
}

impl Found {
    fn v(&self) -> f64 {
        self.crossing.v.to_f64()
    }

    /// How many eigenvalues become unstable.
    fn gain(&self) -> isize {
        let count = if self.kind == CriticalKind::Capsize { 1 } else { 2 };
        match self.change {
            Some(Change::Destabilizes) => count,
            Some(Change::Stabilizes) => -count,
            _ => 0,
        }
    }
}

impl Course {
    /// Of the only one in its group, what its own derivative does not tell follows from the counts.
    fn decide_changes(&mut self) {
        for (i, group) in self.groups.iter().enumerate() {
            for found in &mut self.found[group.clone()] {
                let order = self.between[i + 1].unstable.cmp(&self.between[i].unstable);
                found.change = found.change.or(Some(match order {
                    core::cmp::Ordering::Less => Change::Stabilizes,
                    core::cmp::Ordering::Equal => Change::Touches,
                    core::cmp::Ordering::Greater => Change::Destabilizes,
                }));
            }
        }
    }

    /// The intervals at whose ends the numbers of unstable eigenvalues differ by more or less than what was found between
    /// them says, with the number at the lower end.
    fn gaps(&self, samples: &[(f64, usize)]) -> Vec<([f64; 2], usize)> {
        let mut gaps = Vec::new();
        let middles: Vec<f64> =
            (0..self.between.len()).map(|i| middle(&self.found, &self.groups, i, self.ends)).collect();
        for (i, group) in self.groups.iter().enumerate() {
            let gain: isize = self.found[group.clone()].iter().map(Found::gain).sum();
            let [below, above] = [i, i + 1].map(|i| self.between[i].unstable);
            if above as isize - below as isize != gain {
                gaps.push(([middles[i], middles[i + 1]], below));
            }
        }
        // Speeds at which the eigenvalues are known by the way.
        for &(v, unstable) in samples {
            let i = self.groups.partition_point(|group| self.found[group.start].v() <= v);
            let count = self.between[i].unstable;
            if unstable != count {
                gaps.push(if v < middles[i] { ([v, middles[i]], unstable) } else { ([middles[i], v], count) });
            }
        }
        gaps
    }
}

/// Intervals, of which those that overlap or touch have become one.
fn union(mut intervals: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    sort_by(&mut intervals, |x, y| x[0].total_cmp(&y[0]));
    let mut union: Vec<[f64; 2]> = Vec::new();
    for [low, high] in intervals {
        match union.last_mut() {
            Some(last) if low <= last[1] => last[1] = last[1].max(high),
            _ => union.push([low, high]),
        }
    }
    union
}

/// A scaled speed between two neighbours.
fn middle(found: &[Found], groups: &[core::ops::Range<usize>], i: usize, (low, high): (f64, Option<f64>)) -> f64 {
    let last = i.checked_sub(1).map(|i| found[groups[i].end - 1].v());
    let next = groups.get(i).map(|next| found[next.start].v()).or(high);
    match (last, next) {
        (None, None) => low + 1.0,
        (Some(last), None) => 2.0 * last,
        (last, Some(next)) => 0.5 * (last.unwrap_or(low) + next),
    }
}
