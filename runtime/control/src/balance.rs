//! State spaces in units in which everything is about as large.

use nalgebra::DMatrix;

use crate::state_space::StateSpace;

/// A single-input, single-output state space, as far as its numbers go.
#[derive(Clone, Debug)]
pub struct Channel {
    pub a: DMatrix<f64>,
    /// The column of the input.
    pub b: DMatrix<f64>,
    /// The row of the output.
    pub c: DMatrix<f64>,
    pub d: f64,
}

/// A channel in other units, and its gain in the units that were given: that of the channel here times `2^power`.
pub struct Balanced {
    pub channel: Channel,
    pub power: i32,
}

impl Channel {
    /// From an input to an output, by their places.
    pub fn of(space: &StateSpace, input: usize, output: usize) -> Self {
        let all = Self {
            a: space.a.clone(),
            b: space.b.columns(input, 1).into_owned(),
            c: space.c.rows(output, 1).into_owned(),
            d: space.d[(output, input)],
        };
        all.without_hidden()
    }

    /// Without the states that reach nothing, the output included, such as integrals that other outputs ask for.
    fn without_hidden(mut self) -> Self {
        let is_hidden = |channel: &Self, state: usize| {
            let mut others = (0..channel.a.nrows()).filter(|other| *other != state);
            channel.c[(0, state)] == 0.0 && others.all(|other| channel.a[(other, state)] == 0.0)
        };
        while let Some(state) = (0..self.a.nrows()).find(|state| is_hidden(&self, *state)) {
            self.a = self.a.clone().remove_row(state).remove_column(state);
            self.b = self.b.clone().remove_row(state);
            self.c = self.c.clone().remove_column(state);
        }
        self
    }

    /// With states in units that bring the rows of A and B about as close to their columns with C as powers of two do (Parlett &
    /// Reinsch 1969), and then the input and the output in units that bring B and C to about one. Nothing is rounded.
    ///
    /// What a row or a column of zeros says is left alone.
    pub fn balanced(mut self) -> Balanced {
        const ROUNDS: usize = 16;
        for _ in 0..ROUNDS {
            let mut is_balanced = true;
            for state in 0..self.a.nrows() {
                let others = (0..self.a.nrows()).filter(|&other| other != state);
                let [mut row, mut column] = [self.b[(state, 0)].abs(), self.c[(0, state)].abs()];
                for other in others {
                    row += self.a[(state, other)].abs();
                    column += self.a[(other, state)].abs();
                }
                if row < f64::MIN_POSITIVE || column < f64::MIN_POSITIVE {
                    continue;
                }
                let power = ((row.log2() - column.log2()) / 2.0).round() as i32;
                if power != 0 {
                    is_balanced = false;
                    let factor = 2_f64.powi(power);
                    self.a.row_mut(state).unscale_mut(factor);
                    self.b.row_mut(state).unscale_mut(factor);
                    self.a.column_mut(state).scale_mut(factor);
                    self.c.column_mut(state).scale_mut(factor);
                }
            }
            if is_balanced {
                break;
            }
        }
        let size = |matrix: &DMatrix<f64>| match matrix.amax() {
            0.0 => 0,
            largest => largest.log2().ceil() as i32,
        };
        let (of_input, of_output) = (size(&self.b), size(&self.c));
        self.b *= 2_f64.powi(-of_input);
        self.c *= 2_f64.powi(-of_output);
        self.d *= 2_f64.powi(-of_input - of_output);
        Balanced { channel: self, power: of_input + of_output }
    }
}
