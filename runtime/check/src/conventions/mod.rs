//! What else than a slip in a formula makes other numbers: conventions in which people differ, entries that stand at another
//! place, and parameters that were taken for others.

mod coordinates;
mod entries;
mod feedback;
mod matrices;
mod parameters;
mod powers;
mod shipped;
mod speeds;
mod usual;
mod wholes;

use std::borrow::Cow;

use carvallo_design::matrices::dependent_column;

use crate::predict::World;

pub use self::coordinates::coordinates;
pub use self::entries::entries;
pub use self::feedback::{feedback, gains, term};
pub use self::matrices::{matrices, sums};
pub use self::parameters::parameters;
pub use self::powers::powers;
pub use self::shipped::shipped;
pub use self::speeds::{power, speeds, units};
pub use self::usual::usual;
pub use self::wholes::{degrees, wholes};

/// What is said of a cause that is none of the closed loop's number, but of what feedback is added to.
pub const BEFORE_CLOSING: &str = ", before the loop is closed";

/// One of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Convention {
    /// What is otherwise, as the end of a sentence: `K2 was filled row by column`.
    pub what: String,
    /// What that does to the numbers.
    pub effect: Effect,
    /// How likely it is, 0 the most.
    pub rank: u8,
}

/// What a convention does to the numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Parameters, by their positions, have other values.
    Parameters(Vec<(usize, f64)>),
    /// Entries of matrices have other values.
    Entries(Vec<Assignment>),
    /// Every matrix is divided by M from the left, and M is 1.
    DividedByMass,
    /// The same from the right.
    DividedByMassFromRight,
    /// Coordinates are others: ours are this matrix times theirs, row by row.
    Coordinates(Vec<f64>),
    /// Each gain of the feedback is multiplied by a factor.
    Gains(Vec<f64>),
    /// All speeds are multiplied by a factor, and each gain of the feedback by what comes of it.
    Speeds(f64, Vec<f64>),
}

/// An entry that has the value of another one, times a factor; places are those of [`World::entries`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assignment {
    /// The entry.
    pub to: usize,
    /// The other one.
    pub from: usize,
    /// The factor.
    pub factor: f64,
    /// What is added.
    pub constant: f64,
}

impl Assignment {
    /// The value of another entry times a factor.
    pub const fn times(to: usize, from: usize, factor: f64) -> Self {
        Self { to, from, factor, constant: 0.0 }
    }

    /// Always the same value.
    pub const fn constant(to: usize, constant: f64) -> Self {
        Self { to, from: to, factor: 0.0, constant }
    }
}

impl Convention {
    /// Says so where it is of entries that feedback is added to: what was written of it is true of the open loop.
    pub fn of_open_loop(mut self, closed: &[usize]) -> Self {
        if let Effect::Entries(assignments) = &self.effect
            && assignments.iter().any(|own| closed.contains(&own.to) || closed.contains(&own.from))
        {
            self.what += BEFORE_CLOSING;
        }
        self
    }

    /// Entries that have other values.
    pub fn of_entries(what: impl Into<String>, assignments: Vec<Assignment>) -> Self {
        Self { what: what.into(), effect: Effect::Entries(assignments), rank: 0 }
    }

    /// Parameters that have other values.
    pub fn of_parameters(what: impl Into<String>, values: Vec<(usize, f64)>) -> Self {
        Self { what: what.into(), effect: Effect::Parameters(values), rank: 0 }
    }

    /// The same, less likely.
    pub fn ranked(self, rank: u8) -> Self {
        Self { rank, ..self }
    }

    /// What it makes of these parameters.
    pub fn change_parameters(&self, parameters: &mut [f64]) {
        if let Effect::Parameters(values) = &self.effect {
            values.iter().for_each(|&(position, value)| parameters[position] = value);
        }
    }

    /// What it makes of entries; `None` of what is done to them in another way, or to nothing else.
    pub fn assignments(&self, count: usize) -> Option<Cow<'_, [Assignment]>> {
        match &self.effect {
            Effect::Entries(assignments) => Some(Cow::Borrowed(assignments)),
            Effect::Speeds(factor, gains) if gains.is_empty() => Some(Cow::Owned(speeds::assignments(*factor, count))),
            _ => None,
        }
    }

    /// What it makes of the matrices in `own` where they were `old`.
    pub fn change_matrices(&self, old: &World, own: &mut World, count: usize) {
        own.clone_from(old);
        let mut assign = |assignments: &[Assignment]| {
            for &Assignment { to, from, factor, constant } in assignments {
                own.entries[to] = factor * old.entries[from] + constant;
            }
        };
        let scale = |gains: &mut [f64], factors: &[f64]| {
            gains.iter_mut().zip(factors).for_each(|(value, factor)| *value *= factor);
        };
        match &self.effect {
            Effect::Parameters(_) => {}
            Effect::Entries(assignments) => assign(assignments),
            Effect::DividedByMass => divide(&mut own.entries, count),
            Effect::DividedByMassFromRight => {
                transpose(&mut own.entries, count);
                divide(&mut own.entries, count);
                transpose(&mut own.entries, count);
            }
            Effect::Coordinates(shares) => coordinates::transform(&mut own.entries, shares, count),
            Effect::Gains(factors) => scale(&mut own.gains, factors),
            Effect::Speeds(factor, factors) => {
                assign(&speeds::assignments(*factor, count));
                scale(&mut own.gains, factors);
            }
        }
    }
}

/// Transposes all matrices.
fn transpose(entries: &mut [f64], count: usize) {
    for matrix in entries.chunks_exact_mut(count * count) {
        for row in 0..count {
            (0..row).for_each(|column| matrix.swap(row * count + column, column * count + row));
        }
    }
}

/// Divides all matrices by the first one from the left; they stay as they are where that is singular.
fn divide(entries: &mut [f64], count: usize) {
    let square = count * count;
    let transposed: Vec<f64> = (0..square).map(|at| entries[at % count * count + at / count]).collect();
    if dependent_column(&transposed, count, &|_| true).is_some() {
        return;
    }
    for column in 0..count {
        let pivot = (column..count)
            .max_by(|&a, &b| entries[a * count + column].abs().total_cmp(&entries[b * count + column].abs()))
            .unwrap_or(column);
        for matrix in entries.chunks_exact_mut(square) {
            (0..count).for_each(|at| matrix.swap(column * count + at, pivot * count + at));
        }
        let scale = entries[column * count + column];
        for matrix in entries.chunks_exact_mut(square) {
            matrix[column * count..][..count].iter_mut().for_each(|entry| *entry /= scale);
        }
        for row in (0..count).filter(|row| *row != column) {
            let factor = entries[row * count + column];
            for matrix in entries.chunks_exact_mut(square) {
                for at in 0..count {
                    matrix[row * count + at] -= factor * matrix[column * count + at];
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::divide;

    #[test]
    fn division_by_the_mass_matrix_solves() {
        // M = [[0, 2], [4, 0]], K = [[6, 8], [4, 12]]: M^-1 K = [[1, 3], [3, 4]].
        let mut entries = [0.0, 2.0, 4.0, 0.0, 6.0, 8.0, 4.0, 12.0];
        divide(&mut entries, 2);
        assert_eq!(entries, [1.0, 0.0, 0.0, 1.0, 1.0, 3.0, 3.0, 4.0]);
        let mut singular = [1.0, 2.0, 2.0, 4.0, 6.0, 8.0, 4.0, 12.0];
        let before = singular;
        divide(&mut singular, 2);
        assert_eq!(singular, before);
    }
}
