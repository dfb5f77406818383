//! The eigenvalues of any number of coordinates, from the state matrix.

use nalgebra::Complex;

use super::francis::{self, SWEEPS_PER_EIGENVALUE};
use super::hessenberg::{Row, balance, reduce};
use super::quadratic::Quadratic;
use crate::characteristic::units::{time_unit, to_per_second};
use crate::number::{Number, Scalar};
use crate::numeric::{exponent, ldexp};
use crate::system::{Matrix, States, System, SystemError, require_in_range};

impl<const N: usize, T: Scalar> System<N, T> {
    /// The eigenvalues in 1/s, one for each [state](States), so 2N where all positions and rates are, sorted by real part, then
    /// by imaginary part.
    ///
    /// For N = 2 they are [those of the quartic](System::quartic_eigenvalues), and for N = 1 those of the quadratic. For
    /// more they come from the state matrix, balanced, by the QR algorithm with a bound on its iterations; jointly they are
    /// the exact ones of a state matrix that differs from the given one by rounding, relative to its norm. There, too, real
    /// ones have an imaginary part of exactly zero and pairs are exactly conjugate. Without any damping they are the square
    /// roots of the eigenvalues of -M^-1 K: what oscillates then has a real part of exactly zero.
    ///
    /// # Errors
    /// If an entry is not finite, if the mass matrix is singular, if an eigenvalue leaves the range of `f64`, or if the
    /// iteration for N other than 2 does not converge.
    pub fn eigenvalues(&self) -> Result<Vec<Complex<f64>>, SystemError> {
        if N == 2 && self.states == [States::Both; N] {
            let two = |matrix: &Matrix<T, N>| Matrix::<T, 2>::from_fn(|i, j| matrix[(i, j)]);
            let system = System::new(two(&self.m), two(&self.c), two(&self.k));
            return Ok(system.quartic_eigenvalues()?.to_vec());
        }
        let found = self.widened(eigenvalues_of_state_matrix)?;
        let absent = self.states.iter().filter(|states| **states != States::Both).count();
        let mut eigenvalues = found.as_flattened()[..2 * N - absent].to_vec();
        eigenvalues.sort_by(|x, y| x.re.total_cmp(&y.re).then(x.im.total_cmp(&y.im)));
        Ok(eigenvalues)
    }
}

/// The eigenvalues, in no order; behind them zeros in the places of what is no state.
fn eigenvalues_of_state_matrix<const N: usize>(system: &System<N>) -> Result<[[Complex<f64>; 2]; N], SystemError> {
    system.require_finite()?;
    let [stiffness, damping] = system.solve(system.with_columns_of_states([-system.k, -system.c]))?;
    require_in_range("M^-1 K", &stiffness)?;
    require_in_range("M^-1 C", &damping)?;
    // Time in units that bring stiffness and damping to at most one. A row that gives a rate is per second once less.
    let is_rate = |row: usize| system.states[row] == States::Position;
    let largest = |matrix: &Matrix<f64, N>, of_rates: bool| {
        let rows = (0..N).filter(|&row| is_rate(row) == of_rates);
        let entries = rows.flat_map(|row| (0..N).map(move |column| matrix[(row, column)].abs()));
        exponent(entries.fold(0.0, f64::max))
    };
    let returning = largest(&damping, false).max(largest(&stiffness, true));
    let unit = time_unit(returning, largest(&stiffness, false));
    let scale = |matrix: &Matrix<f64, N>, power: i32| -> Matrix<f64, N> {
        Matrix::from_fn(|i, j| ldexp(matrix[(i, j)], -(power - i32::from(is_rate(i))) * unit))
    };
    let (stiffness, damping) = (scale(&stiffness, 2), scale(&damping, 1));
    let mut found = [[Complex::new(0.0, 0.0); 2]; N];
    if N == 1 && system.states == [States::Both; N] {
        found[0] = Quadratic { p: 0.0 - damping[(0, 0)], q: 0.0 - stiffness[(0, 0)] }.complex_roots();
    } else if system.states == [States::Both; N] && damping.iter().all(|&entry| entry == 0.0) {
        undamped(&stiffness, found.as_flattened_mut())?;
    } else {
        damped(&stiffness, &damping, &system.states, found.as_flattened_mut())?;
    }
    to_per_second(found, unit)
}

/// Of `q'' = D q' + S q`, from the transposed state matrix with each coordinate next to its rate, (q1, q1', q2, q2', ...):
/// its first column is in Hessenberg form already.
fn damped<const N: usize>(
    stiffness: &Matrix<f64, N>,
    damping: &Matrix<f64, N>,
    states: &[States; N],
    found: &mut [Complex<f64>],
) -> Result<(), SystemError> {
    let mut rows = [[[[0.0; 2]; N]; 2]; N];
    for i in 0..N {
        for j in 0..N {
            // What is solved for is the rate of a coordinate of first order, the acceleration of any other.
            let solved = if states[j] == States::Position { 0 } else { 1 };
            rows[i][0][j][solved] = stiffness[(j, i)];
            rows[i][1][j][solved] = damping[(j, i)];
        }
        rows[i][1][i][0] = 1.0;
    }
    let rows = without_absent(rows.as_flattened_mut(), states);
    balance(rows);
    // Without the position of the first coordinate its first column is not in that form.
    reduce(rows, usize::from(states[0] == States::Both));
    collect(rows, found)
}

/// The rows and columns of states alone.
fn without_absent<'a, const N: usize>(rows: &'a mut [[[f64; 2]; N]], states: &[States; N]) -> &'a mut [[[f64; 2]; N]] {
    if *states == [States::Both; N] {
        return rows;
    }
    let kept = |place: usize| match states[place / 2] {
        States::Both => true,
        States::Position => place.is_multiple_of(2),
        States::Rate => !place.is_multiple_of(2),
    };
    let kept = || (0..2 * N).filter(|&place| kept(place));
    for (row, from) in kept().enumerate() {
        rows[row] = rows[from];
        let entries = rows[row].as_flattened_mut();
        for (column, from) in kept().enumerate() {
            entries[column] = entries[from];
        }
    }
    &mut rows[..kept().count()]
}

/// Of `q'' = S q`: both square roots of the eigenvalues of S, half as many.
fn undamped<const N: usize>(stiffness: &Matrix<f64, N>, found: &mut [Complex<f64>]) -> Result<(), SystemError> {
    let mut rows: [[f64; N]; N] = core::array::from_fn(|i| core::array::from_fn(|j| stiffness[(i, j)]));
    balance(&mut rows);
    reduce(&mut rows, 0);
    let (squares, _) = found.split_at_mut(N);
    collect(&mut rows, squares)?;
    for i in (0..N).rev() {
        [found[2 * i], found[2 * i + 1]] = square_roots(found[i]);
    }
    Ok(())
}

/// The eigenvalues of a matrix of any size given by its rows, transposed or not, whose columns before `first` are in
/// Hessenberg form, and the norm of the matrix once it is balanced: what they err by is its rounding. The rows are
/// overwritten.
pub(crate) fn eigenvalues_of_rows<R: Row>(
    rows: &mut [R],
    first: usize,
    found: &mut [Complex<f64>],
) -> Result<f64, SystemError> {
    balance(rows);
    let sum = |row: &R| row.entries()[..found.len()].iter().map(|entry| entry.abs()).sum();
    let norm = rows.iter().map(sum).fold(0.0, f64::max);
    reduce(rows, first);
    collect(rows, found)?;
    Ok(norm)
}

fn collect<R: Row>(rows: &mut [R], found: &mut [Complex<f64>]) -> Result<(), SystemError> {
    let mut next = found.iter_mut();
    let put = |eigenvalue| {
        if let Some(place) = next.next() {
            *place = eigenvalue;
        }
    };
    let iterations = SWEEPS_PER_EIGENVALUE * rows.len();
    francis::find_eigenvalues(rows, put).ok_or(SystemError::NotConverged { iterations })
}

/// Both square roots. Those of conjugate numbers are exactly conjugate.
fn square_roots(square: Complex<f64>) -> [Complex<f64>; 2] {
    let Complex { re, im } = square;
    if im == 0.0 {
        let root = Number::sqrt(re.abs());
        return if re < 0.0 {
            [Complex::new(0.0, -root), Complex::new(0.0, root)]
        } else {
            [Complex::new(0.0 - root, 0.0), Complex::new(root, 0.0)]
        };
    }
    // The part that is larger is a sum without cancellation.
    let large = Number::sqrt(0.5 * (Number::sqrt(re * re + im * im) + re.abs()));
    let small = 0.5 * im.abs() / large;
    let (re, im) = if re < 0.0 { (small, large.copysign(im)) } else { (large, small.copysign(im)) };
    [Complex::new(-re, -im), Complex::new(re, im)]
}
