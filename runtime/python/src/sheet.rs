//! The stability of many designs as columns, with the headings that `carvallo sweep` has.

use std::ops::Range;
use std::sync::Mutex;

use carvallo::{Complex, CriticalKind, Stability, Verdict};
use carvallo_design::number::shortest;
use carvallo_design::{Capacity, Equations, Shipped, of_kind};
use carvallo_plot::analysis::kind;

use crate::at_speeds;

/// What the cells of a column are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Count,
    Number,
    /// By its place in [`VERDICTS`].
    Verdict,
}

/// What a verdict is called.
pub const VERDICTS: [&str; 3] = ["stable", "marginal", "unstable"];

const KINDS: [CriticalKind; 3] = [CriticalKind::Weave, CriticalKind::Capsize, CriticalKind::DoubleRoot];

/// The columns that there are for any design of a model.
#[derive(Debug)]
pub struct Layout {
    capacity: Option<Capacity>,
    /// Those of eigenvalues and verdicts, in m/s.
    speeds: Vec<f64>,
    headings: Vec<(String, Kind)>,
}

impl Layout {
    /// With eigenvalues and verdicts at speeds.
    pub fn new(model: &Shipped, speeds: Vec<f64>) -> Self {
        let capacity = Capacity::of(model);
        let mut headings = Vec::new();
        let number = |name: String| (name, Kind::Number);
        let count = |name: String| (name, Kind::Count);
        if let Some(Capacity { weave, capsize, double_root, stable, counts_undecided }) = capacity {
            for (of, most) in KINDS.into_iter().zip([weave, capsize, double_root]) {
                let name = kind(of, model.info);
                headings.push(count(format!("{name}_count")));
                headings.extend((1..=most).map(|index| number(format!("{name}_{index}"))));
            }
            headings.push(count("stable_count".to_owned()));
            let ends = |index| ["from", "to"].map(|end| number(format!("stable_{end}_{index}")));
            headings.extend((1..=stable).flat_map(ends));
            headings.extend(counts_undecided.then(|| count("undecided_count".to_owned())));
        }
        for speed in speeds.iter().map(|speed| shortest(*speed)) {
            headings.push((format!("verdict_at_{speed}"), Kind::Verdict));
            let parts = |index| ["re", "im"].map(|part| number(format!("eigenvalue_{index}_{part}_at_{speed}")));
            headings.extend((1..=model.eigenvalues()).flat_map(parts));
        }
        Self { capacity, speeds, headings }
    }
}

/// The columns of some designs. What is not present is zero.
#[derive(Debug)]
pub struct Sheet {
    /// The heading of each column.
    pub headings: Vec<(String, Kind)>,
    /// The numbers of each column.
    pub cells: Vec<Vec<f64>>,
    /// Whether there is a number.
    pub present: Vec<Vec<bool>>,
    /// Why a design has no results.
    pub errors: Vec<Option<String>>,
}

impl Sheet {
    /// Without anything in it.
    pub fn new(layout: &Layout, rows: usize) -> Self {
        let columns = layout.headings.len();
        Self {
            headings: layout.headings.clone(),
            cells: (0..columns).map(|_| vec![0.0; rows]).collect(),
            present: (0..columns).map(|_| vec![false; rows]).collect(),
            errors: vec![None; rows],
        }
    }

    /// Its rows in parts of equal length, but for the last, that can be written side by side.
    pub fn parts(&mut self, rows: usize) -> Vec<Mutex<Part<'_>>> {
        let rows = rows.max(1);
        let errors = self.errors.chunks_mut(rows);
        let mut parts: Vec<Part> =
            errors.map(|errors| Part { cells: Vec::new(), present: Vec::new(), errors }).collect();
        for (cells, present) in self.cells.iter_mut().zip(&mut self.present) {
            let both = cells.chunks_mut(rows).zip(present.chunks_mut(rows));
            for (part, (cells, present)) in parts.iter_mut().zip(both) {
                part.cells.push(cells);
                part.present.push(present);
            }
        }
        parts.into_iter().map(Mutex::new).collect()
    }
}

/// Some rows of a sheet.
#[derive(Debug)]
pub struct Part<'a> {
    cells: Vec<&'a mut [f64]>,
    present: Vec<&'a mut [bool]>,
    errors: &'a mut [Option<String>],
}

impl Part<'_> {
    /// What becomes of a range of designs, each of which is looked at by `visit`.
    pub fn fill(
        &mut self,
        layout: &Layout,
        range: Range<usize>,
        mut visit: impl FnMut(usize, &mut dyn FnMut(&dyn Equations, f64) -> Result<(), String>) -> Result<(), String>,
    ) {
        for (row, index) in range.enumerate() {
            let solved = visit(index, &mut |equations, gravity| self.solve(layout, row, equations, gravity));
            self.errors[row] = solved.err();
        }
    }

    /// Nothing is written where there is an error.
    fn solve(&mut self, layout: &Layout, row: usize, equations: &dyn Equations, gravity: f64) -> Result<(), String> {
        let stability = equations.stability(gravity).map_err(|error| error.to_string())?;
        layout.capacity.map_or(Ok(()), |capacity| capacity.require_room(&stability))?;
        let mut values = [Vec::new()];
        at_speeds::eigenvalues(equations, gravity, &layout.speeds, &mut values)?;
        let verdict = |&speed: &f64| stability.verdict(speed).map_err(|error| at_speeds::at(speed, error));
        let verdicts = layout.speeds.iter().map(verdict).collect::<Result<Vec<Verdict>, _>>()?;
        let mut row = Row { part: self, row, column: 0 };
        if let Some(capacity) = &layout.capacity {
            row.stability(&stability, capacity);
        }
        let [values] = &values;
        let at_one = (values.len() / layout.speeds.len().max(1)).max(1);
        for (verdict, values) in verdicts.iter().zip(values.chunks(at_one)) {
            row.eigenvalues(*verdict, values);
        }
        Ok(())
    }
}

/// A row, as far as it is written.
struct Row<'a, 'b> {
    part: &'a mut Part<'b>,
    row: usize,
    column: usize,
}

impl Row<'_, '_> {
    fn stability(&mut self, stability: &Stability, capacity: &Capacity) {
        let Capacity { weave, capsize, double_root, stable, counts_undecided } = *capacity;
        for (kind, most) in KINDS.into_iter().zip([weave, capsize, double_root]) {
            self.count(of_kind(stability, kind).count());
            let mut speeds = of_kind(stability, kind);
            (0..most).for_each(|_| self.number(speeds.next()));
        }
        self.count(stability.stable_ranges.len());
        for index in 0..stable {
            let range = stability.stable_ranges.get(index);
            self.number(range.map(|range| range.from));
            self.number(range.and_then(|range| range.to));
        }
        if counts_undecided {
            self.count(stability.undecided.len());
        }
    }

    fn eigenvalues(&mut self, verdict: Verdict, values: &[Complex<f64>]) {
        self.count(match verdict {
            Verdict::Stable => 0,
            Verdict::Marginal => 1,
            Verdict::Unstable => 2,
        });
        for value in values {
            self.number(Some(value.re));
            self.number(Some(value.im));
        }
    }

    fn number(&mut self, number: Option<f64>) {
        if let Some(number) = number {
            self.part.cells[self.column][self.row] = number;
            self.part.present[self.column][self.row] = true;
        }
        self.column += 1;
    }

    fn count(&mut self, count: usize) {
        self.number(Some(count as f64));
    }
}
