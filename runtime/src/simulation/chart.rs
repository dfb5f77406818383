//! In which rates a motion is integrated.
//!
//! The speeds of a machine are the rates of certain positions, and there are states in which these do not tell how it moves
//! although it moves as smoothly as elsewhere: the rear wheel of a bicycle stands still where the front wheel is steered by
//! a right angle, whatever the yaw rate. Toward such a state other rates grow beyond all bounds at given speeds, and what is
//! integrated near it is rounding. So where that begins the rates of other positions take the place of speeds, chosen as in
//! elimination with complete pivoting.

use nalgebra::DMatrix;

use super::machine::Machine;
use crate::motion::MotionError;

/// A rate that is so many times a speed is integrated in the place of that speed, in rad or m.
const LARGE: f64 = 16.0;
/// Speeds that no rate is so many times of are integrated again.
const MODERATE: f64 = 8.0;
/// Other rates are chosen such that none is more than so many times one of them.
const SMALL: f64 = 2.0;

/// The positions whose rates are integrated.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chart {
    places: Vec<usize>,
}

impl Chart {
    /// Of the speeds.
    pub fn of_speeds(machine: &dyn Machine) -> Self {
        Self { places: machine.info().speeds.to_vec() }
    }

    pub fn is_of_speeds(&self, machine: &dyn Machine) -> bool {
        self.places == machine.info().speeds
    }

    /// What is integrated in a state: of a state, or of the accelerations of all positions.
    pub fn choose<'a>(&'a self, all: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
        self.places.iter().map(|&place| all[place])
    }

    /// The speeds at given rates of what is integrated.
    pub fn speeds(&self, machine: &dyn Machine, positions: &[f64], rates: &[f64]) -> Result<Vec<f64>, MotionError> {
        if self.is_of_speeds(machine) {
            return Ok(rates.to_vec());
        }
        let shares = shares(machine, positions)?;
        let mut equations = self.rows(&shares);
        let mut sides = nalgebra::DVector::from_column_slice(rates);
        // Rows of one size: what makes one of them large is common to all that is in it.
        for (row, side) in sides.iter_mut().enumerate() {
            let size = equations.row(row).amax();
            equations.row_mut(row).unscale_mut(size);
            *side /= size;
        }
        let speeds = equations.full_piv_lu().solve(&sides).ok_or(MotionError::Singular { quantity: "a speed" })?;
        Ok(speeds.as_slice().to_vec())
    }

    /// Another choice, where this one is no good any more.
    pub fn renewed(&self, machine: &dyn Machine, positions: &[f64]) -> Result<Option<Self>, MotionError> {
        let shares = shares(machine, positions)?;
        let (native, largest) = (self.is_of_speeds(machine), shares.amax());
        if native && largest <= LARGE {
            return Ok(None);
        }
        if !native {
            if largest < MODERATE {
                return Ok(Some(Self::of_speeds(machine)));
            }
            let by_these = self.rows(&shares).full_piv_lu().try_inverse().map(|inverse| &shares * inverse);
            if by_these.is_some_and(|shares| shares.amax() <= LARGE) {
                return Ok(None);
            }
        }
        let chosen = Self::pivoted(machine, shares);
        Ok((chosen != *self).then_some(chosen))
    }

    /// Exchanges a speed for the rate that is largest by it, until none is large.
    fn pivoted(machine: &dyn Machine, mut shares: DMatrix<f64>) -> Self {
        let mut chart = Self::of_speeds(machine);
        // Each exchange more than doubles a determinant that is bounded; this many are enough for any of doubles.
        for _ in 0..1000 {
            let (row, column) = shares.icamax_full();
            let pivot = shares[(row, column)];
            if pivot.abs() <= SMALL || !pivot.is_finite() {
                break;
            }
            chart.places[column] = row;
            let by_pivot = shares.column(column) / pivot;
            let of_row = shares.row(row).into_owned();
            for other in (0..shares.ncols()).filter(|other| *other != column) {
                shares.column_mut(other).axpy(-of_row[other], &by_pivot, 1.0);
            }
            shares.set_column(column, &by_pivot);
        }
        chart
    }

    /// The rates of what is integrated, by the speeds.
    fn rows(&self, shares: &DMatrix<f64>) -> DMatrix<f64> {
        DMatrix::from_fn(self.places.len(), shares.ncols(), |row, speed| shares[(self.places[row], speed)])
    }
}

/// The rates of all positions, by the speeds: linear in them, so a column is what there is at one of them alone.
fn shares(machine: &dyn Machine, positions: &[f64]) -> Result<DMatrix<f64>, MotionError> {
    let info = machine.info();
    let mut shares = DMatrix::zeros(info.positions.len(), info.speeds.len());
    let mut speeds = vec![0.0; info.speeds.len()];
    for (speed, mut column) in shares.column_iter_mut().enumerate() {
        speeds.fill(0.0);
        speeds[speed] = 1.0;
        machine.rates(positions, &speeds, column.as_mut_slice())?;
    }
    Ok(shares)
}
