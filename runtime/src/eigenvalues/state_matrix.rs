//! The state matrix of equations of motion of any order.

use crate::numeric::Square;
use crate::system::{SystemError, solve_in_place};

/// Which of the states are the position and the rate of each coordinate: both next to each other, where both are states.
pub(crate) struct Layout {
    places: Vec<Place>,
    states: usize,
}

#[derive(Clone, Copy)]
struct Place {
    position: Option<usize>,
    rate: Option<usize>,
}

impl Place {
    /// The state whose derivative the equations are solved for: the rate of a coordinate of first order, the acceleration of
    /// any other.
    fn solved(self) -> Option<usize> {
        self.rate.or(self.position)
    }
}

impl Layout {
    /// From whether the position and the rate of each coordinate are states.
    pub(crate) fn new(states: impl Iterator<Item = [bool; 2]>) -> Self {
        let mut next = 0;
        let mut place = |is_there: bool| {
            next += usize::from(is_there);
            is_there.then(|| next - 1)
        };
        let places = states.map(|[position, rate]| Place { position: place(position), rate: place(rate) }).collect();
        Self { places, states: next }
    }

    /// How many there are.
    pub(crate) fn states(&self) -> usize {
        self.states
    }

    /// How many columns of the transposed state matrix are in Hessenberg form as they come: the first one, if the first
    /// coordinate has a rate beside its position.
    pub(crate) fn reduced_columns(&self) -> usize {
        self.places.first().map_or(0, |place| usize::from(place.position.is_some() && place.rate.is_some()))
    }

    /// The transposed state matrix of `q'' = stiffness q + damping q'`, whose rows of coordinates of first order give their
    /// rates, with a number in the place of one for the derivatives of positions that are rates.
    pub(crate) fn transposed(&self, stiffness: &Square<f64>, damping: &Square<f64>, one: f64) -> Square<f64> {
        let mut rows = Square::filled(self.states, 0.0);
        for (i, &Place { position, rate }) in self.places.iter().enumerate() {
            if let (Some(position), Some(rate)) = (position, rate) {
                rows[rate][position] = one;
            }
            for (state, matrix) in [(position, stiffness), (rate, damping)] {
                let Some(state) = state else { continue };
                for (j, place) in self.places.iter().enumerate() {
                    if let Some(solved) = place.solved() {
                        rows[state][solved] = matrix[j][i];
                    }
                }
            }
        }
        rows
    }
}

/// Replaces several B by the solutions X of `M X = B`.
///
/// # Errors
/// If M is singular.
pub(crate) fn solve(mut m: Square<f64>, sides: &mut [Square<f64>]) -> Result<(), SystemError> {
    let size = m.size();
    let mut terms = m.clone();
    solve_in_place(size, |row, column| size * row + column, [m.entries_mut(), terms.entries_mut()], sides)
}
