//! The eigenvalues of three to eight coordinates, of one system or of one in each lane, without a decision that lanes would
//! not share.
//!
//! 1. [`mass`]: the equations solved for the accelerations;
//! 2. [`reduction`]: the state matrix, balanced and in Hessenberg form;
//! 3. [`recurrence`]: its characteristic polynomial, and the values of that which are as good as the matrix;
//! 4. [`laguerre`]: the roots of the polynomial, which are as good as its coefficients;
//! 5. [`correction`]: roots as good as the matrix, and whether they are certain.
//!
//! What is not certain is left to the QR algorithm: a mass matrix that is not symmetric and positive, eigenvalues that nearly
//! coincide or are of very different sizes, and iterations that do not converge.

// Places are those of several arrays, in one room for all numbers of coordinates.
#![allow(clippy::needless_range_loop)]

mod alone;
mod correction;
mod laguerre;
mod mass;
mod recurrence;
mod reduction;
#[cfg(test)]
mod tests;

use nalgebra::Complex;

#[cfg(feature = "batch")]
pub(crate) use self::alone::{IS_THERE, is_damped};
pub(crate) use self::alone::{of_system, spectrum};
use self::recurrence::Recurrence;
use crate::number::lane::Lane;

/// The most coordinates that are computed so.
pub(crate) const MOST: usize = 8;

/// M, C and K.
#[derive(Clone, Copy)]
pub(crate) enum Of {
    Mass,
    Damping,
    Stiffness,
}

/// Eigenvalues in no order, but with the halves of each pair next to each other, and the norm of the balanced state matrix.
#[derive(Clone, Copy)]
pub(crate) struct Roots<T, const C: usize> {
    pub(crate) re: [T; C],
    pub(crate) im: [T; C],
    pub(crate) norm: T,
}

/// The eigenvalues of n coordinates, from the entries of their matrices, and whether they are certain; those of the state
/// matrix by [`of_matrix`]. There is room for H coordinates and for C = 2 H states.
#[inline(always)]
pub(crate) fn find<T: Lane, const H: usize, const C: usize>(
    n: usize,
    entry: impl Fn(Of, usize, usize) -> T,
    of_matrix: impl Fn(usize, usize, [[T; C]; C]) -> (Roots<T, C>, T::Mask),
) -> (Roots<T, C>, T::Mask) {
    let zero = entry(Of::Mass, 0, 0).like(0.0);
    let (mut m, mut sides) = ([[zero; H]; H], [[zero; C]; H]);
    for i in 0..n.min(H) {
        for j in 0..n.min(H) {
            m[i][j] = entry(Of::Mass, i, j);
            sides[i][j] = entry(Of::Stiffness, i, j);
            sides[i][n + j] = entry(Of::Damping, i, j);
        }
    }
    let is_positive = mass::solve(n, m, &mut sides);
    let (rows, unit, is_moderate) = reduction::state_matrix(n, &sides);
    let (mut roots, are_certain) = of_matrix(2 * n, 1, rows);
    for (re, im) in roots.re.iter_mut().zip(&mut roots.im) {
        (*re, *im) = (*re * unit, *im * unit);
    }
    roots.norm = roots.norm * unit;
    (roots, is_positive & is_moderate & are_certain)
}

/// The eigenvalues of a matrix of an even number of rows, four or more, so many of whose first columns are in Hessenberg form;
/// and whether they are certain.
#[inline(always)]
pub(crate) fn of_matrix<T: Lane, const C: usize>(
    size: usize,
    reduced_columns: usize,
    mut rows: [[T; C]; C],
) -> (Roots<T, C>, T::Mask) {
    let norm = reduction::balance(size, &mut rows);
    reduction::reduce(size, reduced_columns, &mut rows);
    let recurrence = Recurrence::new(size, &mut rows);
    let mut roots = laguerre::find(size, &recurrence.coefficients());
    let are_certain = correction::correct(&recurrence, &mut roots, norm);
    let [re, im] = roots;
    (Roots { re, im, norm }, are_certain)
}

impl<const C: usize> Roots<f64, C> {
    /// Puts so many of them in the place of what is there, sorted by real part, then by imaginary part. False if they are not
    /// [of one size](Self::are_of_one_size).
    pub(crate) fn sort_into(&self, size: usize, values: &mut Vec<Complex<f64>>) -> bool {
        values.clear();
        if !self.are_of_one_size(size) {
            return false;
        }
        let is_after = |x: &Complex<f64>, y: &Complex<f64>| x.re > y.re || (x.re == y.re && x.im > y.im);
        let mut sorted = [Complex::new(0.0, 0.0); C];
        for place in (0..size).step_by(2) {
            let half = |i: usize| Complex::new(self.re[place + i], self.im[place + i]);
            let [mut first, mut second] = [half(0), half(1)];
            if is_after(&first, &second) {
                core::mem::swap(&mut first, &mut second);
            }
            // From behind to where the first belongs, and from there on for the second: halves of a pair stay together.
            let (mut at, end) = (place, place + 2);
            while at > 0 && is_after(&sorted[at - 1], &first) {
                sorted[at + 1] = sorted[at - 1];
                at -= 1;
            }
            sorted[at] = first;
            while at + 2 < end && is_after(&second, &sorted[at + 2]) {
                sorted[at + 1] = sorted[at + 2];
                at += 1;
            }
            sorted[at + 1] = second;
        }
        values.extend_from_slice(&sorted[..size]);
        true
    }

    /// Whether none is so small that it has less than eleven digits beside the norm: errors are some units in the last place
    /// of the norm here, and of rows of different sizes often less than that by the QR algorithm.
    fn are_of_one_size(&self, size: usize) -> bool {
        const SMALLEST: f64 = 1.0 / 65536.0;
        self.re.iter().zip(&self.im).take(size).all(|(re, im)| re.abs() + im.abs() >= SMALLEST * self.norm)
    }
}

/// Two at a time, which baseline instructions have: loops have an even number of columns.
#[inline(always)]
fn pairs<T>(row: &[T]) -> &[[T; 2]] {
    row.as_chunks().0
}

#[inline(always)]
fn pairs_mut<T>(row: &mut [T]) -> &mut [[T; 2]] {
    row.as_chunks_mut().0
}

/// The first of the columns after k, or an even one before. In few columns all count: then everything is written out, and what
/// nobody asks for left out again.
#[inline(always)]
fn first_meant<const C: usize>(k: usize) -> usize {
    const FEW: usize = 6;
    if C <= FEW { 0 } else { k.div_ceil(2) * 2 }
}
