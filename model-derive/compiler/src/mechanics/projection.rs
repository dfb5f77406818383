//! The equations of motion of all joints, projected on the motions that the wheels leave free.
//!
//! With z the positions of all joints, the steady motion has no acceleration in a frame that does not turn. So
//!
//! ```text
//! mass z'' + (slip/v + damping + v spin) z' + (stiffness + g weight + v relaxation) z = forces of the contacts, and applied
//! ```
//!
//! where `weight` has the second derivatives of the heights of the centres of mass and, times the steady load of each
//! wheel, of its contact point. The rates are `z' = N q' + v B z`, hence `z'' = N q'' + v B N q' + v² B B z`, and in the
//! virtual motions N the contacts do no work. A coordinate whose motion the wheels determine has that as its equation, of
//! first order: `z' - N q' - v B z = 0`.

use super::feedback::add_feedback;
use super::formulas::Formulas;
use super::massless::find_massless;
use super::matrix::{self, Matrix, plus, times, transposed};
use super::mechanism::Mechanism;
use super::motion::Motions;
use super::unreduced::Unreduced;
use super::{Fault, Matrices};
use crate::matrix_name::{MatrixName, Whole};
use crate::states::States;
use crate::symbolic::Form;

/// The equations of motion, with a row and a column for each coordinate, and what tells whether they are whole.
pub struct Projection<'a> {
    mechanism: &'a Mechanism<Form>,
    /// In the order of the equation of motion.
    matrices: Vec<(MatrixName, Matrix)>,
    /// The coordinates that the forward motion takes part in.
    coupled: Vec<usize>,
    /// The joints that roll, and on whose positions the motion depends.
    remaining: Vec<usize>,
}

/// Matrices with a row for each freedom.
pub struct Projected {
    /// M, C-1, C0 and C1, with a column for each freedom.
    pub by_rates: [(MatrixName, Matrix); 4],
    /// Kc, K0, K1 and K2, with a column for each joint.
    pub by_positions: [(MatrixName, Matrix); 4],
}

impl<'a> Projection<'a> {
    pub fn new(
        mechanism: &'a Mechanism<Form>,
        unreduced: &Unreduced,
        motions: &Motions,
        formulas: &mut Formulas<'_>,
    ) -> Self {
        let projected = Projected::new(mechanism, unreduced, motions, formulas);
        let coordinates = &mechanism.coordinates;
        let stays = |entry: &Form| !formulas.is_zero(entry);
        // Of the forward motion there is a freedom, and no coordinate.
        let forward = motions.freedoms.iter().position(|joint| !coordinates.contains(joint));
        let couples = |freedom: usize, joint: usize| {
            let Some(forward) = forward else { return false };
            let by_rates = projected.by_rates.iter().map(|(_, matrix)| matrix);
            let by_positions = projected.by_positions.iter().map(|(_, matrix)| matrix);
            by_rates.into_iter().any(|matrix| stays(&matrix[freedom][forward]) || stays(&matrix[forward][freedom]))
                || by_positions.into_iter().any(|matrix| stays(&matrix[forward][joint]))
        };
        let freedoms = motions.freedoms.iter().enumerate().filter(|(freedom, _)| Some(*freedom) != forward);
        // What holds the speed takes whatever force that needs.
        let freedoms = freedoms.filter(|_| !mechanism.holds_speed);
        let coupled = freedoms.filter(|(freedom, joint)| couples(*freedom, **joint)).map(|(_, joint)| *joint).collect();
        let remains = |joint: &usize| {
            let mut matrices = projected.by_positions.iter();
            matrices.any(|(_, matrix)| matrix.iter().any(|row| stays(&row[*joint])))
                || mechanism.following.iter().any(|following| stays(&motions.positions[*following][*joint]))
        };
        let remaining = motions.rolling.iter().copied().filter(remains).collect();
        let matrices = projected.complete(mechanism, motions);
        Self { mechanism, matrices, coupled, remaining }
    }

    /// What the coordinates alone cannot say.
    pub fn faults(&self, formulas: &Formulas<'_>) -> Vec<Fault> {
        let coupled = self.coupled.iter().map(|joint| Fault::Coupled { joint: *joint });
        let mut faults: Vec<Fault> = coupled.collect();
        faults.extend(self.remaining.iter().map(|joint| Fault::Remains { joint: *joint }));
        let coordinates = &self.mechanism.coordinates;
        let Some((_, mass)) = self.matrices.iter().find(|(name, _)| *name == MatrixName::M) else { return faults };
        let moving: Vec<usize> = (0..coordinates.len()).filter(|q| self.moves_mass(coordinates[*q])).collect();
        let mass = matrix::new(moving.len(), moving.len(), |row, column| mass[moving[row]][moving[column]].clone());
        let joints: Vec<usize> = moving.iter().map(|q| coordinates[*q]).collect();
        faults.extend(find_massless(&mass, &joints, formulas));
        faults
    }

    /// Whether a coordinate is one of second order.
    fn moves_mass(&self, joint: usize) -> bool {
        !self.mechanism.following.contains(&joint) && !self.mechanism.is_deflection(joint)
    }

    /// Which positions and rates of the coordinates are states; `matrices` are those of the coordinates.
    pub fn states(mechanism: &Mechanism<Form>, matrices: &Matrices) -> Vec<States> {
        let is_carried = |joint: usize| {
            let Some(root) = mechanism.root else { return false };
            joint == root.forward || mechanism.slips() && (joint == root.lateral || joint == root.yaw)
        };
        let stiffness = matrices.iter().filter(|(name, _)| Whole::Stiffness.parts().contains(name));
        let holds = |column: usize| stiffness.clone().any(|(_, rows)| rows.iter().any(|row| !row[column].is_nothing()));
        let states = |(column, joint): (usize, &usize)| match () {
            () if mechanism.following.contains(joint) || mechanism.is_deflection(*joint) => States::Position,
            () if is_carried(*joint) && !holds(column) => States::Rate,
            () => States::Both,
        };
        mechanism.coordinates.iter().enumerate().map(states).collect()
    }

    /// The coefficient matrices of the coordinates; those that are zero are left out.
    pub fn matrices(self, formulas: &Formulas<'_>) -> Matrices {
        settle(&self.matrices, formulas)
    }
}

impl Projected {
    pub fn new(
        mechanism: &Mechanism<Form>,
        unreduced: &Unreduced,
        motions: &Motions,
        formulas: &mut Formulas<'_>,
    ) -> Self {
        let Motions { rates, positions, places, freedoms, .. } = motions;
        let virtual_motions = transposed(rates);
        let project = |matrix: &Matrix| times(&virtual_motions, matrix);
        let mut named = |what: &str, matrix: &Matrix| {
            let named = |(freedom, row): (usize, Vec<Form>)| {
                let of = &mechanism.joints[freedoms[freedom]].name;
                let name = |column: usize| format!("{what}_{of}_{}", mechanism.joints[column].name);
                row.iter().enumerate().map(|(column, entry)| formulas.name(name(column), entry)).collect()
            };
            project(matrix).into_iter().enumerate().map(named).collect::<Matrix>()
        };
        let (mass, weight) = (named("P", &unreduced.mass), named("W", &unreduced.weight));
        // Spin stays as it is, since much of it cancels; of springs, dampers and tyres there are few.
        let [spin, slip, damping] = [&unreduced.spin, &unreduced.slip, &unreduced.damping].map(project);
        let [stiffness, relaxation] = [&unreduced.stiffness, &unreduced.relaxation].map(project);
        let moving = plus(&times(&mass, positions), &spin);
        let mut projected = Self {
            by_rates: [
                (MatrixName::M, times(&mass, rates)),
                (MatrixName::Cm1, times(&slip, rates)),
                (MatrixName::C0, times(&damping, rates)),
                (MatrixName::C1, times(&moving, rates)),
            ],
            by_positions: [
                (MatrixName::Kc, plus(&times(&stiffness, places), &times(&slip, positions))),
                (MatrixName::K0, times(&weight, places)),
                (MatrixName::K1, plus(&times(&relaxation, places), &times(&damping, positions))),
                (MatrixName::K2, times(&moving, positions)),
            ],
        };
        add_feedback(mechanism, motions, &mut projected.by_rates, &mut projected.by_positions);
        projected
    }

    /// The matrices of the coordinates alone, with the equations of those that follow by rolling, and what is declared beside
    /// the mechanism.
    pub fn complete(self, mechanism: &Mechanism<Form>, motions: &Motions) -> Vec<(MatrixName, Matrix)> {
        let coordinates = &mechanism.coordinates;
        let n = coordinates.len();
        let freedom = |q: usize| motions.freedoms.iter().position(|joint| *joint == coordinates[q]);
        let zero = || Form::number(0);
        let by_rates = self.by_rates.iter().map(|(name, matrix)| {
            let entry = |row: usize, column: usize| match (freedom(row), freedom(column)) {
                (Some(row), Some(column)) => matrix[row][column].clone(),
                (None, Some(column)) if *name == MatrixName::C0 => -&motions.rates[coordinates[row]][column],
                (None, None) if *name == MatrixName::C0 && row == column => Form::number(1),
                _ => zero(),
            };
            (*name, matrix::new(n, n, entry))
        });
        let by_positions = self.by_positions.iter().map(|(name, matrix)| {
            let entry = |row: usize, column: usize| match freedom(row) {
                Some(row) => matrix[row][coordinates[column]].clone(),
                None if *name == MatrixName::K1 => -&motions.positions[coordinates[row]][coordinates[column]],
                None => zero(),
            };
            (*name, matrix::new(n, n, entry))
        });
        let mut matrices: Vec<(MatrixName, Matrix)> = by_rates.chain(by_positions).collect();
        for (name, rows) in &mechanism.added {
            if let Some((_, matrix)) = matrices.iter_mut().find(|(known, _)| known == name) {
                *matrix = plus(matrix, rows);
            }
        }
        matrices
    }
}

/// Entries in their shortest form; matrices that are zero are left out.
pub fn settle(matrices: &[(MatrixName, Matrix)], formulas: &Formulas<'_>) -> Matrices {
    let settled = |entry: &Form| if formulas.is_zero(entry) { Form::number(0) } else { formulas.shortest(entry) };
    let all = matrices.iter().map(|(name, matrix)| {
        let settled = matrix.iter().map(|row| row.iter().map(settled).collect()).collect();
        (*name, mirrored(settled, formulas))
    });
    let is_there = |matrix: &Matrix| matrix.iter().flatten().any(|entry| !entry.is_nothing());
    all.filter(|(name, matrix)| *name == MatrixName::M || is_there(matrix)).collect()
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
