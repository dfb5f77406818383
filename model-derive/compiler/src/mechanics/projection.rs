//! The equations of motion of all joints, projected on the motions that the wheels leave free.
//!
//! With z the positions of all joints, the steady motion has no acceleration in a frame that does not turn. So
//!
//! ```text
//! mass z'' + (damping + v spin) z' + (stiffness + g weight) z = forces of the contacts, and applied ones,
//! ```
//!
//! where `weight` has the second derivatives of the heights of the centres of mass and, times the steady load of each
//! wheel, of its contact point. The rates are `z' = N q' + v B z`, hence `z'' = N q'' + v B N q' + v² B B z`, and in the
//! virtual motions N the contacts do no work.

use super::formulas::Formulas;
use super::massless::find_massless;
use super::matrix::{self, Matrix, plus, times, transposed};
use super::mechanism::Mechanism;
use super::motion::Motions;
use super::unreduced::Unreduced;
use super::{Fault, Matrices};
use crate::matrix_name::MatrixName;
use crate::symbolic::Form;

/// The equations of motion with a row for each freedom: the coordinates, and behind them the forward motion if there is
/// one.
pub struct Projection<'a> {
    mechanism: &'a Mechanism<Form>,
    /// M, C0 and C1, with a column for each freedom.
    by_rates: [(MatrixName, Matrix); 3],
    /// Kc, K0 and K2, with a column for each joint.
    by_positions: [(MatrixName, Matrix); 3],
    /// Stiffness proportional to the speed, with a column for each joint.
    dragged: Matrix,
}

impl<'a> Projection<'a> {
    pub fn new(
        mechanism: &'a Mechanism<Form>,
        unreduced: &Unreduced,
        motions: &Motions,
        formulas: &mut Formulas<'_>,
    ) -> Self {
        let Motions { rates, positions, places, .. } = motions;
        let virtual_motions = transposed(rates);
        let project = |matrix: &Matrix| times(&virtual_motions, matrix);
        let mut named = |what: &str, matrix: &Matrix| {
            let named = |(freedom, row): (usize, Vec<Form>)| {
                let of = mechanism.coordinates.get(freedom).map_or("forward", |joint| &mechanism.joints[*joint].name);
                let name = |column: usize| format!("{what}_{of}_{}", mechanism.joints[column].name);
                row.iter().enumerate().map(|(column, entry)| formulas.name(name(column), entry)).collect()
            };
            project(matrix).into_iter().enumerate().map(named).collect::<Matrix>()
        };
        let (mass, weight) = (named("P", &unreduced.mass), named("W", &unreduced.weight));
        // Spin stays as it is, since much of it cancels; of springs and dampers there are few.
        let [spin, damping, stiffness] = [&unreduced.spin, &unreduced.damping, &unreduced.stiffness].map(project);
        let moving = plus(&times(&mass, positions), &spin);
        let mut projection = Self {
            mechanism,
            by_rates: [
                (MatrixName::M, times(&mass, rates)),
                (MatrixName::C0, times(&damping, rates)),
                (MatrixName::C1, times(&moving, rates)),
            ],
            by_positions: [
                (MatrixName::Kc, times(&stiffness, places)),
                (MatrixName::K0, times(&weight, places)),
                (MatrixName::K2, times(&moving, positions)),
            ],
            dragged: times(&damping, positions),
        };
        mechanism.added.iter().for_each(|(name, rows)| projection.add(*name, rows));
        projection
    }

    /// Adds to a matrix what is declared beside the mechanism: forces of the coordinates, by their rates and positions.
    fn add(&mut self, name: MatrixName, rows: &Matrix) {
        let coordinates = &self.mechanism.coordinates;
        for (row, entries) in rows.iter().enumerate() {
            for (column, entry) in entries.iter().enumerate() {
                let by_rates = self.by_rates.iter_mut().find(|(known, _)| *known == name);
                let by_positions = self.by_positions.iter_mut().find(|(known, _)| *known == name);
                let sum = match (by_rates, by_positions) {
                    (Some((_, matrix)), _) => &mut matrix[row][column],
                    (None, Some((_, matrix))) => &mut matrix[row][coordinates[column]],
                    (None, None) => unreachable!("one of the two has it"),
                };
                *sum = &*sum + entry;
            }
        }
    }

    /// What the coordinates alone cannot say.
    pub fn faults(&self, motions: &Motions, formulas: &Formulas<'_>) -> Vec<Fault> {
        let coordinates = &self.mechanism.coordinates;
        let n = coordinates.len();
        let stays = |entry: &Form| !formulas.is_zero(entry);
        let mut faults = Vec::new();
        for (_, matrix) in &self.by_rates {
            let coupled = (0..n).filter(|q| {
                let (columns, rows) = (&matrix[*q][n..], &matrix[n..]);
                columns.iter().any(stays) || rows.iter().any(|row| stays(&row[*q]))
            });
            faults.extend(coupled.map(|q| Fault::Coupled { joint: coordinates[q] }));
        }
        for (_, matrix) in &self.by_positions {
            let coupled = coordinates.iter().filter(|joint| matrix[n..].iter().any(|row| stays(&row[**joint])));
            faults.extend(coupled.map(|joint| Fault::Coupled { joint: *joint }));
            let remaining = motions.rolling.iter().filter(|joint| matrix.iter().any(|row| stays(&row[**joint])));
            faults.extend(remaining.map(|joint| Fault::Remains { joint: *joint }));
        }
        let joints = 0..self.mechanism.joints.len();
        let dragged = joints.filter(|joint| self.dragged.iter().any(|row| stays(&row[*joint])));
        faults.extend(dragged.map(|joint| Fault::Dragged { joint }));
        let [(_, mass), ..] = &self.by_rates;
        let mass = matrix::new(n, n, |row, column| mass[row][column].clone());
        faults.extend(find_massless(&mass, coordinates, formulas));
        faults
    }

    /// The coefficient matrices of the coordinates; those that are zero are left out.
    pub fn matrices(self, formulas: &Formulas<'_>) -> Matrices {
        let coordinates = &self.mechanism.coordinates;
        let n = coordinates.len();
        let settled = |entry: &Form| if formulas.is_zero(entry) { Form::number(0) } else { formulas.shortest(entry) };
        let by_rates = self
            .by_rates
            .iter()
            .map(|(name, matrix)| (*name, matrix::new(n, n, |row, column| settled(&matrix[row][column]))));
        let by_positions = self
            .by_positions
            .iter()
            .map(|(name, matrix)| (*name, matrix::new(n, n, |row, column| settled(&matrix[row][coordinates[column]]))));
        let all = by_rates.chain(by_positions).map(|(name, matrix)| (name, mirrored(matrix, formulas)));
        let is_there = |matrix: &Matrix| matrix.iter().flatten().any(|entry| !entry.is_nothing());
        all.filter(|(name, matrix)| *name == MatrixName::M || is_there(matrix)).collect()
    }
}

/// With the same form for entries that mirror each other, where they are equal.
fn mirrored(matrix: Matrix, formulas: &Formulas<'_>) -> Matrix {
    let size = matrix.len();
    matrix::new(size, size, |row, column| {
        let (entry, mirrored) = (&matrix[row][column], &matrix[column][row]);
        let equal = row > column && formulas.is_zero(&(entry - mirrored));
        if equal { mirrored.clone() } else { entry.clone() }
    })
}
