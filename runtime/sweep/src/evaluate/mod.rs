//! From designs to results: the part of a sweep that computes.

mod solution;

use carvallo_design::Shipped;
use carvallo_design::conventions::Varied;

use self::solution::Solution;
use super::table::{Column, Designs, Layout, Results};

/// What is the same for all designs.
pub struct Task {
    pub model: &'static Shipped,
    /// The parameters that no column gives.
    pub base: Vec<f64>,
    /// Puts the columns of the designs into them.
    pub varied: Varied,
    pub layout: Layout,
}

impl Task {
    /// The results of some designs, row by row.
    pub fn evaluate(&self, designs: &Designs) -> Results {
        let headings = self.layout.headings();
        let mut columns: Vec<Column> =
            headings.into_iter().map(|heading| Column::new(heading.kind, designs.rows)).collect();
        let mut errors = Vec::with_capacity(designs.rows);
        let mut stable = Vec::with_capacity(designs.rows);
        let mut values = self.base.clone();
        // Its memory serves one design after the other.
        let mut solution = Solution::default();
        for row in 0..designs.rows {
            let solved = match &designs.errors[row] {
                Some(error) => Err(error.clone()),
                None => {
                    let put = self.varied.put(|column| designs.columns[column].number(row), &mut values);
                    put.and_then(|()| solution.solve(self.model, &values, &self.layout))
                }
            };
            match solved {
                Ok(()) => {
                    solution.fill_row(&mut columns, &self.layout);
                    stable.push(solution.first_stable());
                    errors.push(None);
                }
                Err(error) => {
                    columns.iter_mut().for_each(Column::push_none);
                    stable.push(None);
                    errors.push(Some(error));
                }
            }
        }
        Results { columns, errors, stable }
    }
}
