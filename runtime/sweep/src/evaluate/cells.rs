//! From the results of a design to its row.

use std::borrow::Cow;
use std::slice::IterMut;

use carvallo::{Complex, CriticalKind, Stability, Verdict};
use carvallo_design::{Capacity, of_kind};

use super::solution::Solution;
use crate::table::{Column, Layout};

/// The columns that the next values of a row go to.
pub struct Cells<'a>(IterMut<'a, Column>);

impl<'a> Cells<'a> {
    pub fn new(columns: &'a mut [Column]) -> Self {
        Self(columns.iter_mut())
    }

    /// Adds a row, with a value or none in each column.
    pub fn fill(&mut self, solution: &Solution, layout: &Layout) {
        if let (Some(stability), Some(capacity)) = (&solution.stability, &layout.critical) {
            self.stability(stability, capacity);
        }
        for (verdict, eigenvalues) in solution.verdicts.iter().zip(solution.eigenvalues.chunks(layout.eigenvalues)) {
            self.eigenvalues(*verdict, eigenvalues);
        }
    }

    fn stability(&mut self, stability: &Stability, capacity: &Capacity) {
        for (kind, most) in [
            (CriticalKind::Weave, capacity.weave),
            (CriticalKind::Capsize, capacity.capsize),
            (CriticalKind::DoubleRoot, capacity.double_root),
        ] {
            self.count(of_kind(stability, kind).count());
            let mut speeds = of_kind(stability, kind);
            (0..most).for_each(|_| self.number(speeds.next()));
        }
        self.count(stability.stable_ranges.len());
        for index in 0..capacity.stable {
            let range = stability.stable_ranges.get(index);
            self.number(range.map(|range| range.from));
            self.number(range.and_then(|range| range.to));
        }
        if capacity.counts_undecided {
            self.count(stability.undecided.len());
        }
    }

    fn eigenvalues(&mut self, verdict: Verdict, eigenvalues: &[Complex<f64>]) {
        if let Some(Column::Texts(values)) = self.0.next() {
            values.push(Some(Cow::Borrowed(match verdict {
                Verdict::Stable => "stable",
                Verdict::Marginal => "marginal",
                Verdict::Unstable => "unstable",
            })));
        }
        for eigenvalue in eigenvalues {
            self.number(Some(eigenvalue.re));
            self.number(Some(eigenvalue.im));
        }
    }

    fn number(&mut self, value: Option<f64>) {
        if let Some(Column::Numbers(values)) = self.0.next() {
            values.push(value);
        }
    }

    fn count(&mut self, count: usize) {
        if let Some(Column::Counts(values)) = self.0.next() {
            values.push(i32::try_from(count).ok());
        }
    }
}
