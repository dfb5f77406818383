//! State spaces in units in which everything is about as large.

use nalgebra::DMatrix;

use crate::state_space::StateSpace;

/// What is between some inputs and outputs of a state space, as far as its numbers go.
#[derive(Clone, Debug)]
pub struct Channel {
    pub a: DMatrix<f64>,
    /// A column for each input.
    pub b: DMatrix<f64>,
    /// A row for each output.
    pub c: DMatrix<f64>,
    pub d: DMatrix<f64>,
}

/// A channel in other units, and the determinant of its transfer functions in the units that were given: that of the channel here
/// times `2^power`.
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
            d: space.d.view((output, input), (1, 1)).into_owned(),
        };
        all.without_hidden()
    }

    /// From all inputs to all outputs.
    pub fn whole(space: &StateSpace) -> Self {
        let StateSpace { a, b, c, d, .. } = space.clone();
        Self { a, b, c, d }.without_hidden()
    }

    /// Without the states that reach nothing, the output included, such as integrals that other outputs ask for.
    fn without_hidden(mut self) -> Self {
        let is_hidden = |channel: &Self, state: usize| {
            let mut others = (0..channel.a.nrows()).filter(|other| *other != state);
            channel.c.column(state).iter().all(|entry| *entry == 0.0)
                && others.all(|other| channel.a[(other, state)] == 0.0)
        };
        while let Some(state) = (0..self.a.nrows()).find(|state| is_hidden(&self, *state)) {
            self.a = self.a.clone().remove_row(state).remove_column(state);
            self.b = self.b.clone().remove_row(state);
            self.c = self.c.clone().remove_column(state);
        }
        self
    }

    /// With states in units that bring the rows of A and B about as close to their columns with C as powers of two do (Parlett &
    /// Reinsch 1969), and then each input and output in units that bring its part of B or C to about one. Nothing is rounded.
    ///
    /// What a row or a column of zeros says is left alone.
    pub fn balanced(mut self) -> Balanced {
        const ROUNDS: usize = 16;
        for _ in 0..ROUNDS {
            let mut is_balanced = true;
            for state in 0..self.a.nrows() {
                let others = (0..self.a.nrows()).filter(|&other| other != state);
                let mut row: f64 = self.b.row(state).iter().map(|entry| entry.abs()).sum();
                let mut column: f64 = self.c.column(state).iter().map(|entry| entry.abs()).sum();
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
        let size = |largest: f64| if largest == 0.0 { 0 } else { largest.log2().ceil() as i32 };
        let of_inputs: Vec<i32> = self.b.column_iter().map(|column| size(column.amax())).collect();
        let of_outputs: Vec<i32> = self.c.row_iter().map(|row| size(row.amax())).collect();
        for (input, power) in of_inputs.iter().enumerate() {
            self.b.column_mut(input).scale_mut(2_f64.powi(-power));
        }
        for (output, power) in of_outputs.iter().enumerate() {
            self.c.row_mut(output).scale_mut(2_f64.powi(-power));
        }
        self.d = DMatrix::from_fn(self.d.nrows(), self.d.ncols(), |output, input| {
            self.d[(output, input)] * 2_f64.powi(-of_inputs[input] - of_outputs[output])
        });
        Balanced { channel: self, power: of_inputs.iter().chain(&of_outputs).sum() }
    }
}
