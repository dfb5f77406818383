//! The stability of many designs as columns of numbers, with the headings that `carvallo sweep` has.

use std::ops::Range;
use std::sync::Mutex;

use carvallo::Verdict;
use carvallo_design::Equations;
use carvallo_plot::analysis::columns::{Cell, Heading, Layout};

use crate::at_speeds;

/// The columns of some designs. What is not present is zero.
#[derive(Debug)]
pub struct Sheet {
    /// The heading of each column.
    pub headings: Vec<Heading>,
    /// The numbers of each column; of verdicts their places.
    pub cells: Vec<Vec<f64>>,
    /// Whether there is a number.
    pub present: Vec<Vec<bool>>,
    /// Why a design has no results.
    pub errors: Vec<Option<String>>,
}

impl Sheet {
    /// Without anything in it.
    pub fn new(layout: &Layout, rows: usize) -> Self {
        let headings = layout.headings();
        let columns = headings.len();
        Self {
            headings,
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
        layout.critical.map_or(Ok(()), |capacity| capacity.require_room(&stability))?;
        let mut values = [Vec::new()];
        at_speeds::eigenvalues(equations, gravity, &layout.speeds, &mut values)?;
        let verdict = |&speed: &f64| stability.verdict(speed).map_err(|error| at_speeds::at(speed, error));
        let verdicts = layout.speeds.iter().map(verdict).collect::<Result<Vec<Verdict>, _>>()?;
        let ([values], mut column) = (&values, 0);
        layout.fill(&stability, &verdicts, values, |cell| {
            let number = match cell {
                Cell::Number(number) => number,
                Cell::Count(count) | Cell::Verdict(count) => Some(count as f64),
            };
            if let Some(number) = number {
                self.cells[column][row] = number;
                self.present[column][row] = true;
            }
            column += 1;
        });
        Ok(())
    }
}
