//! What there is of one design.

use carvallo::{Complex, Stability, StableRange, SystemError, Verdict};
use carvallo_design::{Equations, Shipped};

use crate::table::{Column, Layout};

/// The results of one design.
#[derive(Default)]
pub struct Solution {
    /// None before the first design.
    pub stability: Option<Stability>,
    /// At each of the speeds.
    pub verdicts: Vec<Verdict>,
    /// Those at one speed after those at another.
    pub eigenvalues: Vec<Complex<f64>>,
}

impl Solution {
    /// Takes the results of another design in the place of its own.
    ///
    /// # Errors
    /// If the parameters, which are in declared order, are not valid, or if there is no answer. Nothing can be said of the
    /// results then.
    pub fn solve(&mut self, model: &Shipped, parameters: &[f64], layout: &Layout) -> Result<(), String> {
        let gravity = model.info.gravity.map_or(0.0, |position| parameters[position]);
        model.visit(parameters, &mut |equations| self.fill(equations, gravity, layout))
    }

    fn fill(&mut self, equations: &dyn Equations, gravity: f64, layout: &Layout) -> Result<(), String> {
        self.verdicts.clear();
        self.eigenvalues.clear();
        let two = equations.of_two();
        let stability = equations.stability(gravity).map_err(|error| error.to_string())?;
        layout.critical.map_or(Ok(()), |capacity| capacity.require_room(&stability))?;
        for &speed in &layout.speeds {
            let fail = |error: SystemError| format!("at {speed} m/s: {error}");
            match two {
                // Without allocation.
                Some(two) => {
                    let found = two.at(speed, gravity).and_then(|system| system.quartic_eigenvalues());
                    self.eigenvalues.extend(found.map_err(fail)?);
                }
                None => self.eigenvalues.extend(equations.eigenvalues(speed, gravity).map_err(fail)?),
            }
            self.verdicts.push(stability.verdict(speed).map_err(fail)?);
        }
        self.stability = Some(stability);
        Ok(())
    }

    /// Adds a row, with a value or none in each column.
    pub fn fill_row(&self, columns: &mut [Column], layout: &Layout) {
        let mut columns = columns.iter_mut();
        let put = |cell| columns.next().into_iter().for_each(|column| column.push(cell));
        if let Some(stability) = &self.stability {
            layout.fill(stability, &self.verdicts, &self.eigenvalues, put);
        }
    }

    /// The first stable range, if there is one.
    pub fn first_stable(&self) -> Option<StableRange> {
        self.stability.as_ref()?.stable_ranges.first().copied()
    }
}
