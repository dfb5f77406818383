//! What a complex matrix that is singular up to rounding has for null vectors.

use super::Square;
use crate::numeric::{ComplexDoubleDouble, exponent, ldexp};

/// The factors of a matrix by elimination with complete pivoting, of which the last pivot, which should be zero, is left out.
///
/// Rows and columns are first brought to a common size by the sizes of the terms of their entries, in powers of two, so that
/// their units do not matter to the choice of pivots.
pub(crate) struct Elimination {
    /// The upper factor, and below its diagonal the lower one.
    factors: Square,
    /// By place the row and the column of the matrix.
    rows: Vec<usize>,
    columns: Vec<usize>,
    /// The exponents of the factors of rows and columns of the matrix.
    row_units: Vec<i32>,
    column_units: Vec<i32>,
}

type Column = Vec<ComplexDoubleDouble>;

impl Elimination {
    /// Of a matrix with a row or more, and the sizes of the terms that its entries were summed from.
    pub(crate) fn new(matrix: &Square, sizes: &[f64]) -> Self {
        let n = matrix.size;
        let largest = |sizes: &mut dyn Iterator<Item = f64>| exponent(sizes.fold(0.0, f64::max)).unwrap_or(0);
        let row_units: Vec<i32> = (0..n).map(|i| -largest(&mut sizes[i * n..(i + 1) * n].iter().copied())).collect();
        let column_units: Vec<i32> =
            (0..n).map(|j| -largest(&mut (0..n).map(|i| ldexp(sizes[i * n + j], row_units[i])))).collect();
        let scaled =
            (0..n * n).map(|place| scale(matrix.entries[place], row_units[place / n] + column_units[place % n]));
        let factors = Square { size: n, entries: scaled.collect() };
        let order: Vec<usize> = (0..n).collect();
        let mut elimination = Self { factors, rows: order.clone(), columns: order, row_units, column_units };
        for step in 0..n.saturating_sub(1) {
            if !elimination.eliminate(step) {
                break;
            }
        }
        elimination
    }

    fn at(&self, row: usize, column: usize) -> ComplexDoubleDouble {
        self.factors.entries[row * self.size() + column]
    }

    fn size(&self) -> usize {
        self.factors.size
    }

    /// One step; false if all that is left is zero.
    fn eliminate(&mut self, step: usize) -> bool {
        let n = self.size();
        let places = (step..n).flat_map(|i| (step..n).map(move |j| (i, j)));
        let by_size =
            |x: &(usize, usize), y: &(usize, usize)| self.at(x.0, x.1).norm().total_cmp(&self.at(y.0, y.1).norm());
        let (row, column) = places.max_by(by_size).unwrap_or((step, step));
        for k in 0..n {
            self.factors.entries.swap(step * n + k, row * n + k);
        }
        for k in 0..n {
            self.factors.entries.swap(k * n + step, k * n + column);
        }
        self.rows.swap(step, row);
        self.columns.swap(step, column);
        let pivot = self.at(step, step);
        if pivot.norm() == 0.0 {
            return false;
        }
        for i in step + 1..n {
            let factor = self.at(i, step) / pivot;
            self.factors.entries[i * n + step] = factor;
            for j in step + 1..n {
                let product = factor * self.at(step, j);
                self.factors.entries[i * n + j] = self.at(i, j) - product;
            }
        }
        true
    }

    /// A pivot, counted from the last, in a unit in which the terms of the entries are of about one: where the last but one is
    /// tiny there is a second null vector. What is beyond the first is one.
    pub(crate) fn pivot(&self, from_last: usize) -> f64 {
        self.size().checked_sub(1 + from_last).map_or(1.0, |place| self.at(place, place).norm())
    }

    /// The x with `Q x = 0` but for the last pivot; of several such vectors one by its number, independent of the others.
    pub(crate) fn right(&self, number: usize) -> Column {
        let n = self.size();
        let free = n - 1 - number.min(n - 1);
        let mut x = vec![ComplexDoubleDouble::ZERO; n];
        x[free] = 1.0.into();
        self.substitute_back(&mut x, free);
        self.to_columns(x)
    }

    /// The y with `y^T Q = 0` but for the last pivot.
    pub(crate) fn left(&self, number: usize) -> Column {
        let n = self.size();
        let free = n - 1 - number.min(n - 1);
        let mut y = vec![ComplexDoubleDouble::ZERO; n];
        y[free] = 1.0.into();
        for j in (0..free).rev() {
            y[j] = -(j + 1..=free).fold(ComplexDoubleDouble::ZERO, |sum, i| sum + self.at(i, j) * y[i]);
        }
        let mut left = vec![ComplexDoubleDouble::ZERO; n];
        for (y, &row) in y.into_iter().zip(&self.rows) {
            left[row] = scale(y, self.row_units[row]);
        }
        left
    }

    /// The x that solves `Q x = r` but for what the left null vector makes of r, and which has nothing of the right one.
    pub(crate) fn solve(&self, r: &[ComplexDoubleDouble]) -> Column {
        let last = self.size() - 1;
        let mut x: Column = self.rows.iter().map(|&row| scale(r[row], self.row_units[row])).collect();
        for i in 1..last {
            x[i] = (0..i).fold(x[i], |sum, j| sum - self.at(i, j) * x[j]);
        }
        x[last] = ComplexDoubleDouble::ZERO;
        self.substitute_back(&mut x, last);
        self.to_columns(x)
    }

    /// Solves for the unknowns before one, which the sums take from what stands in their places. A zero pivot leaves its
    /// unknown free.
    fn substitute_back(&self, x: &mut [ComplexDoubleDouble], free: usize) {
        for i in (0..free).rev() {
            let sum = (i + 1..=free).fold(x[i], |sum, j| sum - self.at(i, j) * x[j]);
            let pivot = self.at(i, i);
            x[i] = if pivot.norm() == 0.0 { ComplexDoubleDouble::ZERO } else { sum / pivot };
        }
    }

    fn to_columns(&self, x: Column) -> Column {
        let mut right = vec![ComplexDoubleDouble::ZERO; x.len()];
        for (x, &column) in x.into_iter().zip(&self.columns) {
            right[column] = scale(x, self.column_units[column]);
        }
        right
    }
}

/// Times a power of two.
fn scale(ComplexDoubleDouble { re, im }: ComplexDoubleDouble, power: i32) -> ComplexDoubleDouble {
    ComplexDoubleDouble { re: re.ldexp(power), im: im.ldexp(power) }
}

#[cfg(test)]
mod tests {
    use super::Elimination;
    use crate::numeric::ComplexDoubleDouble;
    use crate::pencil::{Square, dot};

    fn z(re: f64, im: f64) -> ComplexDoubleDouble {
        ComplexDoubleDouble { re: re.into(), im: im.into() }
    }

    /// A matrix of rank 2, whose second row is the sum of the first and i times the third: its left null vector is known.
    fn singular() -> Square {
        let (first, third) = ([z(1.0, 2.0), z(0.0, -1.0), z(3.0, 0.5)], [z(-2.0, 0.0), z(4.0, 1.0), z(0.25, 0.0)]);
        let second: [ComplexDoubleDouble; 3] = core::array::from_fn(|j| first[j] + z(0.0, 1.0) * third[j]);
        Square { size: 3, entries: [first, second, third].concat() }
    }

    fn sizes(matrix: &Square) -> Vec<f64> {
        matrix.entries.iter().map(|entry| entry.norm()).collect()
    }

    #[test]
    fn both_sides_are_null_vectors_to_twice_the_digits() {
        let matrix = singular();
        let elimination = Elimination::new(&matrix, &sizes(&matrix));
        let (right, left) = (elimination.right(0), elimination.left(0));
        assert!(matrix.times(&right).iter().all(|entry| entry.norm() < 1e-30));
        for (found, expected) in left.iter().zip([z(-1.0, 0.0), z(1.0, 0.0), z(0.0, -1.0)]) {
            assert!((*found / left[1] - expected).norm() < 1e-30);
        }
        assert!(elimination.pivot(1) > 0.01 && elimination.pivot(0) < 1e-25);
    }

    /// What is in the range of the matrix is solved for, in units that differ by a factor of 2^300.
    #[test]
    fn solves_what_can_be_solved_in_any_units() {
        let plain = singular();
        let unit = 2f64.powi(300);
        let factor = |place: usize| [unit, 1.0, 1.0][place / 3] * [1.0, 1.0 / unit, 1.0][place % 3];
        let scaled: Vec<_> =
            plain.entries.iter().enumerate().map(|(place, &entry)| entry * factor(place).into()).collect();
        let matrix = Square { size: 3, entries: scaled };
        let elimination = Elimination::new(&matrix, &sizes(&matrix));
        let expected = matrix.times(&[z(1.0, 1.0), z(unit, 0.0), z(0.0, -2.0)]);
        let found = matrix.times(&elimination.solve(&expected));
        for (row, (found, expected)) in found.iter().zip(&expected).enumerate() {
            assert!((*found - *expected).norm() <= 1e-29 * expected.norm(), "row {row}");
        }
        assert!(dot(&elimination.left(0), &expected).norm() < 1e-25 * unit);
    }

    /// A matrix of rank 1 has two independent null vectors.
    #[test]
    fn several_null_vectors_are_independent() {
        let entries = [1.0, 2.0, 3.0].iter().flat_map(|x| [1.0, 4.0, 0.5].map(|y| z(x * y, 0.0))).collect();
        let matrix = Square { size: 3, entries };
        let elimination = Elimination::new(&matrix, &sizes(&matrix));
        let [first, second] = [0, 1].map(|number| elimination.right(number));
        for vector in [&first, &second] {
            assert!(matrix.times(vector).iter().all(|entry| entry.norm() < 1e-30));
        }
        let minors = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| (first[i] * second[j] - first[j] * second[i]).norm());
        assert!(minors.iter().any(|minor| *minor > 0.1));
    }
}
