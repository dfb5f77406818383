//! The eigenvalues of any number of coordinates, from the state matrix.

use nalgebra::Complex;

use super::francis::{self, SWEEPS_PER_EIGENVALUE};
use super::hessenberg::{balance, reduce};
use super::hidden::Found;
use super::quadratic::Quadratic;
use super::quick;
use super::refined::refine;
use super::state_matrix::{Layout, solve};
use crate::characteristic::units::{time_unit, to_per_second};
use crate::number::{Number, Scalar};
use crate::numeric::{Square, exponent, ldexp, sort_by};
use crate::pencil::Matrices;
use crate::system::{Matrix, States, System, SystemError, require_finite};

impl<const N: usize, T: Scalar> System<N, T> {
    /// The eigenvalues in 1/s, one for each [state](States), so 2N where all positions and rates are, sorted by real part, then
    /// by imaginary part.
    ///
    /// For N = 2 they are [those of the quartic](System::quartic_eigenvalues), and for N = 1 those of the quadratic. For
    /// more they come from the state matrix, balanced: jointly they are the exact ones of a state matrix that differs from the
    /// given one by rounding, relative to its norm. Up to N = 8 they are sought as the roots of its characteristic polynomial
    /// first, corrected by values from the matrix itself, and taken where discs about them show that none is missing; others
    /// come from the QR algorithm with a bound on its iterations. There, too, real ones have an imaginary part of exactly zero
    /// and pairs are exactly conjugate. Without any damping they are the square roots of the eigenvalues of -M^-1 K: what
    /// oscillates then has a real part of exactly zero. Eigenvalues that are smaller than others by more than the digits of
    /// `f64` are the reciprocals of those of the equations with M and K exchanged, and those that have less than half of their
    /// digits beside the largest are refined in twice the precision.
    ///
    /// # Errors
    /// If an entry is not finite, if the mass matrix is singular, if an eigenvalue leaves the range of `f64`, or others are so
    /// much larger and smaller that it is lost in their rounding, or if the iteration does not converge.
    pub fn eigenvalues(&self) -> Result<Vec<Complex<f64>>, SystemError> {
        if N == 2 && self.states == [States::Both; N] {
            let two = |matrix: &Matrix<T, N>| Matrix::<T, 2>::from_fn(|i, j| matrix[(i, j)]);
            let system = System::new(two(&self.m), two(&self.c), two(&self.k));
            return Ok(system.quartic_eigenvalues()?.to_vec());
        }
        if (3..=quick::MOST).contains(&N) && self.states == [States::Both; N] {
            let quick = |system: &System<N>| {
                let System { m, c, k, .. } = system;
                quick::of_system(N, [m.as_slice(), c.as_slice(), k.as_slice()])
            };
            if let Some(values) = self.widened(quick) {
                return Ok(values);
            }
        }
        self.careful_eigenvalues()
    }

    /// The same from the QR algorithm alone.
    pub(crate) fn careful_eigenvalues(&self) -> Result<Vec<Complex<f64>>, SystemError> {
        let square = |matrix: &Matrix<T, N>| Square::from_fn(N, |row, column| matrix[(row, column)].to_f64());
        eigenvalues_of(&|| [&self.m, &self.c, &self.k].map(square), &self.states)
    }
}

/// The eigenvalues of M, C and K, sorted.
fn eigenvalues_of(
    matrices: &dyn Fn() -> [Square<f64>; 3],
    states: &[States],
) -> Result<Vec<Complex<f64>>, SystemError> {
    let found = find(matrices(), states)?;
    let mut values = if states.iter().all(|states| *states == States::Both) {
        let sizes = [found.hidden, found.clear];
        let mut values = found.uncovered(|| {
            let [m, c, k] = matrices();
            find([k, c, m], states)
        })?;
        refine(&mut values, sizes, &|| {
            let [m, c, k] = matrices();
            Matrices::of_rows([k.entries(), c.entries(), m.entries()], states)
        });
        values
    } else {
        found.values
    };
    sort_by(&mut values, |x, y| x.re.total_cmp(&y.re).then(x.im.total_cmp(&y.im)));
    Ok(values)
}

/// The eigenvalues in 1/s as the state matrix has them.
fn find([mut m, mut c, mut k]: [Square<f64>; 3], states: &[States]) -> Result<Found, SystemError> {
    for (quantity, matrix) in [("M", &m), ("C", &c), ("K", &k)] {
        matrix.entries().iter().try_for_each(|&entry| require_finite(quantity, entry))?;
    }
    // Rows of these give a rate instead of an acceleration.
    let is_rate = |row: usize| states[row] == States::Position;
    for column in 0..states.len() {
        match states[column] {
            States::Both => {}
            // What is no state is multiplied by nothing.
            States::Position => (0..states.len()).for_each(|row| m[row][column] = core::mem::take(&mut c[row][column])),
            States::Rate => k.rows_mut().for_each(|row| row[column] = 0.0),
        }
    }
    let mut sides = [k, c];
    sides.iter_mut().flat_map(Square::entries_mut).for_each(|entry| *entry = -*entry);
    solve(m, &mut sides)?;
    let [mut stiffness, mut damping] = sides;
    for (quantity, matrix) in [("M^-1 K", &stiffness), ("M^-1 C", &damping)] {
        if !matrix.entries().iter().all(|entry| entry.is_finite()) {
            return Err(SystemError::OutOfRange { quantity });
        }
    }
    // Time in units that bring stiffness and damping to at most one. A row that gives a rate is per second once less.
    let largest = |matrix: &Square<f64>, of_rates: bool| {
        let rows = matrix.rows().enumerate().filter(|(row, _)| is_rate(*row) == of_rates);
        exponent(rows.flat_map(|(_, row)| row).fold(0.0, |largest: f64, entry| largest.max(entry.abs())))
    };
    let returning = largest(&damping, false).max(largest(&stiffness, true));
    let unit = time_unit(returning, largest(&stiffness, false));
    for (matrix, power) in [(&mut stiffness, 2), (&mut damping, 1)] {
        for (i, row) in matrix.rows_mut().enumerate() {
            row.iter_mut().for_each(|entry| *entry = ldexp(*entry, -(power - i32::from(is_rate(i))) * unit));
        }
    }
    let has_both = states.iter().all(|states| *states == States::Both);
    let mut found = if has_both && states.len() == 1 {
        Found::exactly(Quadratic { p: 0.0 - damping[0][0], q: 0.0 - stiffness[0][0] }.complex_roots().to_vec())
    } else if has_both && damping.entries().iter().all(|&entry| entry == 0.0) {
        // Of q'' = S q: both square roots of the eigenvalues of S, half as many.
        Found::of_spectrum(Spectrum::of(stiffness, 0)?).square_roots(square_roots)
    } else {
        let layout = Layout::new(states.iter().map(|states| [*states != States::Rate, *states != States::Position]));
        let rows = layout.transposed(&stiffness, &damping, 1.0);
        // Where all positions and rates are states, the other way has been tried.
        let of = if has_both { Spectrum::by_iteration } else { Spectrum::of };
        Found::of_spectrum(of(rows, layout.reduced_columns())?)
    };
    to_per_second(&mut found.values, unit)?;
    [found.hidden, found.clear] = [found.hidden, found.clear].map(|size| ldexp(size, unit));
    Ok(found)
}

/// Eigenvalues in no order, but with the halves of each pair next to each other.
pub(crate) struct Spectrum {
    pub(crate) values: Vec<Complex<f64>>,
    /// The norm of the matrix once it is balanced: what they err by is its rounding.
    pub(crate) norm: f64,
}

impl Spectrum {
    /// The eigenvalues of a matrix, transposed or not, so many of whose first columns are in Hessenberg form.
    pub(crate) fn of(rows: Square<f64>, reduced_columns: usize) -> Result<Self, SystemError> {
        match quick::spectrum(&rows, reduced_columns) {
            Some(spectrum) => Ok(spectrum),
            None => Self::by_iteration(rows, reduced_columns),
        }
    }

    /// The same by the QR algorithm.
    fn by_iteration(mut rows: Square<f64>, reduced_columns: usize) -> Result<Self, SystemError> {
        balance(&mut rows);
        let norm = rows.rows().map(|row| row.iter().map(|entry| entry.abs()).sum()).fold(0.0, f64::max);
        reduce(&mut rows, reduced_columns);
        let mut values = Vec::with_capacity(rows.size());
        let iterations = SWEEPS_PER_EIGENVALUE * rows.size();
        francis::find_eigenvalues(&mut rows, |value| values.push(value))
            .ok_or(SystemError::NotConverged { iterations })?;
        Ok(Self { values, norm })
    }
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
