//! Matrices balanced, and brought to Hessenberg form, by similarity: their eigenvalues stay the same.

use crate::Scalar;
use crate::numeric::{exponent, ldexp};

/// A row of a square matrix, as long as there are rows; the matrix itself is an array of them.
pub(super) trait Row: Copy {
    fn entries(&self) -> &[f64];
    fn entries_mut(&mut self) -> &mut [f64];
    #[inline]
    fn at(&self, column: usize) -> f64 {
        self.entries()[column]
    }
    #[inline]
    fn at_mut(&mut self, column: usize) -> &mut f64 {
        &mut self.entries_mut()[column]
    }
}

impl<const N: usize> Row for [f64; N] {
    #[inline]
    fn entries(&self) -> &[f64] {
        self
    }
    #[inline]
    fn entries_mut(&mut self) -> &mut [f64] {
        self
    }
}

/// 2N entries: their number cannot be written in the type.
impl<const N: usize> Row for [[f64; 2]; N] {
    #[inline]
    fn entries(&self) -> &[f64] {
        self.as_flattened()
    }
    #[inline]
    fn entries_mut(&mut self) -> &mut [f64] {
        self.as_flattened_mut()
    }
}

/// Scales row i by `2^-e_i` and column i by `2^e_i`, so that both are of about the same size (Parlett & Reinsch 1969).
///
/// Powers of two round nothing. Without it, rounding is relative to the largest of entries that may only be large because
/// of the units of the coordinates.
#[inline]
pub(super) fn balance<R: Row>(a: &mut [R]) {
    // Each round brings the sizes closer; one that does little is the last, and two are usual.
    const ROUNDS: usize = 16;
    /// By how much the sum of both sizes must shrink.
    const WORTHWHILE: f64 = 0.9;
    for _ in 0..ROUNDS {
        let mut is_balanced = true;
        for i in 0..a.len() {
            let row = a[i].entries().iter().fold(0.0, |sum, entry| sum + entry.abs()) - a[i].at(i).abs();
            let column = a.iter().fold(0.0, |sum, row| sum + row.at(i).abs()) - a[i].at(i).abs();
            // In range already: a factor of two of one and of the other changes nothing worthwhile.
            if row <= 2.0 * column && column <= 2.0 * row {
                continue;
            }
            let (Some(row_exponent), Some(column_exponent)) = (exponent(row), exponent(column)) else { continue };
            let power = (row_exponent - column_exponent).div_euclid(2);
            if ldexp(column, power) + ldexp(row, -power) >= WORTHWHILE * (column + row) {
                continue;
            }
            is_balanced = false;
            a[i].entries_mut().iter_mut().for_each(|entry| *entry = ldexp(*entry, -power));
            a.iter_mut().for_each(|row| *row.at_mut(i) = ldexp(row.at(i), power));
        }
        if is_balanced {
            break;
        }
    }
}

/// Reduces to Hessenberg form by Householder's reflections, column by column from `first` on; what is below the
/// subdiagonal is left over.
#[inline]
pub(super) fn reduce<R: Row>(a: &mut [R], first: usize) {
    let n = a.len();
    // The direction of a reflection, from the row below the diagonal on, and the sums of columns along it.
    let Some(&template) = a.first() else { return };
    let (mut direction, mut sums) = (template, template);
    for k in first..n.saturating_sub(2) {
        let head = a[k + 1].at(k);
        let size = a[k + 2..].iter().fold(0.0, |sum: f64, row| sum.max(row.at(k).abs()));
        if size == 0.0 {
            continue;
        }
        let size = size.max(head.abs());
        let mut square = 0.0;
        for i in k + 1..n {
            let entry = a[i].at(k) / size;
            *direction.at_mut(i) = entry;
            square += entry * entry;
        }
        let norm = Scalar::sqrt(square).copysign(head);
        let pivot = direction.at(k + 1) + norm;
        *direction.at_mut(k + 1) = pivot;
        let factor = 1.0 / (norm * pivot);
        *a[k + 1].at_mut(k) = -norm * size;
        let direction = &direction.entries()[k + 1..n];
        let sums = &mut sums.entries_mut()[k + 1..n];
        // From the left, in the columns after k.
        sums.fill(0.0);
        for (row, along) in a[k + 1..].iter().zip(direction) {
            sums.iter_mut().zip(&row.entries()[k + 1..n]).for_each(|(sum, entry)| *sum += along * entry);
        }
        for (row, along) in a[k + 1..].iter_mut().zip(direction) {
            let along = along * factor;
            row.entries_mut()[k + 1..n].iter_mut().zip(&*sums).for_each(|(entry, sum)| *entry -= along * sum);
        }
        // From the right, in all rows.
        for row in &mut *a {
            let row = &mut row.entries_mut()[k + 1..n];
            let sum = factor * row.iter().zip(direction).fold(0.0, |sum, (entry, along)| sum + entry * along);
            row.iter_mut().zip(direction).for_each(|(entry, along)| *entry -= sum * along);
        }
    }
}
