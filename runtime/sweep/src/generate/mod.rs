//! Designs from values and distributions: each by its number.

mod axis;
mod random;
mod together;

use carvallo::ModelInfo;
use carvallo_design::conventions::Varying;

pub use self::axis::Axis;
pub use self::random::{Distribution, Random};
pub use self::together::{MEASURED, Together};

use self::random::Draws;
use super::table::{Column, Designs};

/// Every combination of the values, each with every sample.
pub struct Generator {
    /// The first one varies slowest.
    pub vary: Vec<Axis>,
    pub random: Vec<Random>,
    /// Those that are drawn as they were measured.
    pub together: Option<Together>,
    /// How many there are of each combination; 1 where nothing is drawn.
    pub samples: u64,
    pub seed: u64,
}

impl Generator {
    /// The number of designs, unless it is too large to be counted.
    pub fn total(&self) -> Option<u64> {
        self.vary.iter().try_fold(self.samples, |total, axis| total.checked_mul(axis.values.len() as u64))
    }

    /// The parameters of its columns, of a model.
    pub fn parameters(&self, info: &ModelInfo) -> Vec<Varying> {
        let vary = self.vary.iter().map(|axis| axis.parameter.clone());
        let random = self.random.iter().map(|random| random.parameter.clone());
        let together = self.together.iter().flat_map(|together| together.positions.iter());
        vary.chain(random).chain(together.map(|at| Varying::of_model(info, *at))).collect()
    }

    /// So many designs from the one with a number on.
    pub fn designs(&self, first: u64, rows: usize) -> Designs {
        let numbers = || first..first + rows as u64;
        let mut columns = Vec::with_capacity(self.vary.len() + self.random.len());
        // How many designs have the same value one after the other.
        let mut run = self.samples;
        for Axis { values, .. } in self.vary.iter().rev() {
            let value = |number: u64| values[(number / run % values.len() as u64) as usize];
            columns.push(Column::Numbers(numbers().map(|number| Some(value(number))).collect()));
            run *= values.len() as u64;
        }
        columns.reverse();
        for random in &self.random {
            let mut draws: Draws = random.draws(self.seed);
            let sample = |number: u64| Some(draws.sample(number % self.samples));
            columns.push(Column::Numbers(numbers().map(sample).collect()));
        }
        if let Some(together) = &self.together {
            let drawn = together.columns(self.seed, numbers().map(|number| number % self.samples));
            columns.extend(drawn.into_iter().map(|column| Column::Numbers(column.into_iter().map(Some).collect())));
        }
        Designs { rows, columns, errors: vec![None; rows] }
    }
}
