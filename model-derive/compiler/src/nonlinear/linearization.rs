//! The equations of motion to first order about any state.
//!
//! Derivatives are those along motions that the conditions leave: where a position or a parameter changes, positions that
//! the heights of the wheels determine follow. The accelerations a of the speeds solve simultaneous equations M a = b, which
//! are not differentiated through their solution: what b - M a changes by at constant a is solved for with the same M.

use super::chain::{Following, differentiate};
use super::equations::Equations;
use super::quantity::{Arithmetic, Quantity};
use super::rolling::find_rows;
use super::solve::{Matrix, solve, solve_definite};

/// The derivatives of the rates of all positions, and then of those of the speeds: a row for each.
pub struct Partials<'a> {
    /// With respect to all positions, of which those that depend on others have zeros, then to speeds and forces.
    pub by_state: Matrix<'a>,
    /// With respect to the parameters.
    pub by_parameters: Matrix<'a>,
}

/// A machine with accelerations that do not follow its state.
pub struct Linearized<'a, 'e, 'm> {
    arithmetic: &'a Arithmetic,
    equations: &'e Equations<'a, 'm>,
    mass: Matrix<'a>,
    /// What is left of the forces that drive the speeds.
    unbalanced: Vec<Quantity<'a>>,
}

impl<'a, 'e, 'm> Linearized<'a, 'e, 'm> {
    /// With rates of the speeds that stand for theirs.
    pub fn new(arithmetic: &'a Arithmetic, equations: &'e Equations<'a, 'm>, held: &[Quantity<'a>]) -> Self {
        let second = equations.find_second(&equations.find_drift(), held);
        Self { arithmetic, equations, mass: equations.find_mass(), unbalanced: equations.find_unbalanced(&second) }
    }

    /// The derivatives, of which the parameters are the first inputs.
    pub fn find_partials(&self, parameters: usize) -> Partials<'a> {
        let parameters: Vec<Quantity<'a>> = (0..parameters).map(|index| self.arithmetic.input(index)).collect();
        let lowered = differentiate(self.arithmetic, &self.equations.find_below(), &parameters, &[]);
        Partials { by_state: self.by_state(), by_parameters: self.derive(&parameters, &lowered) }
    }

    fn by_state(&self) -> Matrix<'a> {
        let Equations { layout, mechanism, frames, contacts, zero, positions, speeds, forces, .. } = self.equations;
        let is_free = |joint: &usize| !layout.standing.contains(joint);
        let free: Vec<usize> = layout.positions.iter().copied().filter(is_free).collect();
        // Displacements of the whole machine lower no wheel.
        let first = mechanism.root.map_or(0, |root| root.yaw);
        let (ignored, moving): (Vec<usize>, Vec<usize>) = free.iter().partition(|joint| **joint < first);
        let place = |row: Vec<Quantity<'a>>| -> Vec<Quantity<'a>> {
            let zeros = |count: usize| std::iter::repeat_n(*zero, count);
            zeros(ignored.len()).chain(row).chain(zeros(speeds.len() + forces.len())).collect()
        };
        let lowered = find_rows(mechanism, frames, contacts, &layout.heights, &moving).into_iter().map(place);
        let state = free.iter().map(|joint| positions[*joint]).chain(speeds.iter().chain(forces).copied());
        let by_free = self.derive(&state.collect::<Vec<_>>(), &lowered.collect());
        let widen = |row: Vec<Quantity<'a>>| -> Vec<Quantity<'a>> {
            let mut row = row.into_iter();
            let mut position = |joint| if is_free(joint) { row.next() } else { None }.unwrap_or(*zero);
            let positions: Vec<Quantity<'a>> = layout.positions.iter().map(&mut position).collect();
            positions.into_iter().chain(row).collect()
        };
        by_free.into_iter().map(widen).collect()
    }

    /// With respect to any inputs, of what these lower the wheels by at constant positions.
    fn derive(&self, inputs: &[Quantity<'a>], lowered: &Matrix<'a>) -> Matrix<'a> {
        let Equations { layout, mechanism, frames, contacts, positions, .. } = self.equations;
        let standing = find_rows(mechanism, frames, contacts, &layout.heights, &layout.standing);
        let sides = (0..inputs.len()).map(|input| lowered.iter().map(|row| -row[input]).collect()).collect();
        let columns = solve(&standing, &sides);
        let follow = |(place, joint): (usize, &usize)| Following {
            value: positions[*joint],
            by_inputs: columns.iter().map(|column| column[place]).collect(),
        };
        let following: Vec<Following<'a>> = layout.standing.iter().enumerate().map(follow).collect();
        let rates = self.equations.position_rates();
        let outputs: Vec<Quantity<'a>> = rates.iter().chain(&self.unbalanced).copied().collect();
        let mut found = differentiate(self.arithmetic, &outputs, inputs, &following);
        let unbalanced = found.split_off(rates.len());
        let solve = |input: usize| {
            solve_definite(&self.mass, &unbalanced.iter().map(|row| row[input]).collect::<Vec<Quantity<'a>>>())
        };
        let solved: Matrix<'a> = (0..inputs.len()).map(solve).collect();
        found.extend((0..self.mass.len()).map(|speed| solved.iter().map(|column| column[speed]).collect()));
        found
    }
}
