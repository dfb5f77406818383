//! Zeros and poles at s = 0, which are counted rather than computed: of a double one rounding would make a pair beside zero.

use carvallo::{Complex, SystemError, matrix_eigenvalues};
use nalgebra::{DMatrix, DVector};

use crate::balance::Channel;
use crate::zeros::ROUNDING;

/// The eigenvalues of a state matrix in 1/s, sorted by real part, then by imaginary part, those at zero exactly.
///
/// # Errors
/// If the iteration for eigenvalues does not converge, or one leaves the range of `f64`.
pub fn poles(a: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, SystemError> {
    let states = a.nrows();
    let without_ports =
        Channel { a: a.clone(), b: DMatrix::zeros(states, 0), c: DMatrix::zeros(0, states), d: DMatrix::zeros(0, 0) };
    let Channel { a, .. } = take_out_zeros(without_ports);
    let at_rest = states - a.nrows();
    Ok(with_rest(matrix_eigenvalues(&a)?, at_rest))
}

/// Numbers with so many zeros among them, sorted by real part, then by imaginary part.
pub fn with_rest(mut others: Vec<Complex<f64>>, at_rest: usize) -> Vec<Complex<f64>> {
    others.extend(std::iter::repeat_n(Complex::new(0.0, 0.0), at_rest));
    others.sort_by(|x, y| x.re.total_cmp(&y.re).then(x.im.total_cmp(&y.im)));
    others
}

/// A channel without its zeros at s = 0, one state less for each; the other zeros stay as they are, and so does the gain.
///
/// There the pencil of Rosenbrock is the matrix of A, B, C and D, and if that is singular, there are states x and inputs u under which
/// nothing moves and no output is anything. The state that is largest in x is replaced by x itself, the others being counted from where
/// it is; its column of A and C is then as good as one of B and D, which u takes away, so that `-s` alone is left in its column of the
/// pencil. With its row and its column that factor is gone. What follows are the zeros of a smaller channel, again and again, as
/// infinite ones are taken out of the pencil that is turned around (Emami-Naeini & Van Dooren 1982).
pub fn take_out_zeros(Channel { a, b, c, d }: Channel) -> Channel {
    let (mut states, ports) = (a.nrows(), d.nrows());
    let mut entries = DMatrix::zeros(states + ports, states + ports);
    entries.view_mut((0, 0), a.shape()).copy_from(&a);
    entries.view_mut((0, states), b.shape()).copy_from(&b);
    entries.view_mut((states, 0), c.shape()).copy_from(&c);
    entries.view_mut((states, states), d.shape()).copy_from(&d);
    let mut matrix = Rounded { sizes: entries.abs(), entries };
    while let Some(still) = matrix.clone().null_vector() {
        let of_states = still.rows(0, states);
        // Inputs alone that do nothing make no zero; there is no transfer function then.
        let Some(place) = (0..states).max_by(|&i, &j| of_states[i].abs().total_cmp(&of_states[j].abs())) else { break };
        if of_states[place] == 0.0 {
            break;
        }
        for state in (0..states).filter(|state| *state != place) {
            let share = still[state] / still[place];
            matrix.subtract([share, share.abs()], place, state, 0);
        }
        matrix = matrix.without(place);
        states -= 1;
    }
    let part =
        |row: usize, column: usize, shape: (usize, usize)| matrix.entries.view((row, column), shape).into_owned();
    Channel {
        a: part(0, 0, (states, states)),
        b: part(0, states, (states, ports)),
        c: part(states, 0, (ports, states)),
        d: part(states, states, (ports, ports)),
    }
}

/// A matrix, with the largest numbers that went into each entry: what is smaller than their rounding is zero. So the units of rows and
/// columns do not matter, and what was zero from the beginning stays that exactly.
#[derive(Clone, Debug)]
struct Rounded {
    entries: DMatrix<f64>,
    sizes: DMatrix<f64>,
}

impl Rounded {
    /// Subtracts a multiple of one row from another, from a column on; by a factor with the largest numbers that went into it.
    fn subtract(&mut self, [factor, of_factor]: [f64; 2], one: usize, from: usize, first: usize) {
        for column in first..self.entries.ncols() {
            let (entry, of_entry) = (self.entries[(one, column)], self.sizes[(one, column)]);
            let taken = (factor.abs() * of_entry).max(of_factor * entry.abs());
            let size = self.sizes[(from, column)].max(taken);
            let left = self.entries[(from, column)] - factor * entry;
            self.entries[(from, column)] = if left.abs() <= ROUNDING * size { 0.0 } else { left };
            self.sizes[(from, column)] = size;
        }
    }

    /// Without a row and the column of the same place.
    fn without(self, place: usize) -> Self {
        let [entries, sizes] = [self.entries, self.sizes].map(|matrix| matrix.remove_row(place).remove_column(place));
        Self { entries, sizes }
    }

    /// A vector that the matrix makes zero, if it is singular, by elimination with the largest pivot of all.
    fn null_vector(mut self) -> Option<DVector<f64>> {
        let size = self.entries.nrows();
        let mut columns: Vec<usize> = (0..size).collect();
        for step in 0..size {
            let (row, column) = self.entries.view((step, step), (size - step, size - step)).iamax_full();
            let (row, column) = (row + step, column + step);
            if self.entries[(row, column)] == 0.0 {
                return Some(self.solution(step, &columns));
            }
            for matrix in [&mut self.entries, &mut self.sizes] {
                matrix.swap_rows(step, row);
                matrix.swap_columns(step, column);
            }
            columns.swap(step, column);
            for row in step + 1..size {
                let pivot = self.entries[(step, step)];
                let factor = self.entries[(row, step)] / pivot;
                let size = self.sizes[(row, step)].max(factor.abs() * self.sizes[(step, step)]);
                self.subtract([factor, size / pivot.abs()], step, row, step);
            }
        }
        None
    }

    /// What the upper triangle of so many rows makes zero, with one for the unknown behind them, each unknown at the place of its column.
    fn solution(&self, rank: usize, columns: &[usize]) -> DVector<f64> {
        let mut found = DVector::zeros(columns.len());
        found[columns[rank]] = 1.0;
        for row in (0..rank).rev() {
            let parts = || (row + 1..=rank).map(|column| self.entries[(row, column)] * found[columns[column]]);
            let (sum, size) = (parts().sum::<f64>(), parts().fold(0.0, |size: f64, part| size.max(part.abs())));
            if sum.abs() > ROUNDING * size {
                found[columns[row]] = -sum / self.entries[(row, row)];
            }
        }
        found
    }
}
