//! Matrices balanced, and brought to Hessenberg form, by similarity: their eigenvalues stay the same.

use crate::number::Number;

/// A row of a square matrix, as long as there are rows; the matrix itself is an array of them.
pub(crate) trait Row: Copy {
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
/// of the units of the coordinates. The entries must be at most one.
#[inline]
pub(super) fn balance<R: Row>(a: &mut [R]) {
    // Each round brings the sizes closer; one that does little is the last, and two are usual.
    const ROUNDS: usize = 16;
    // How much larger one may be than the other: up to here no power of two gains much.
    const ALIKE: f64 = 2.0;
    for _ in 0..ROUNDS {
        let mut is_balanced = true;
        for i in 0..a.len() {
            let (mut row, mut column) = (0.0, 0.0);
            for j in (0..a.len()).filter(|&j| j != i) {
                row += a[i].at(j).abs();
                column += a[j].at(i).abs();
            }
            let smaller = row.min(column);
            if row.max(column) <= ALIKE * smaller || smaller < f64::MIN_POSITIVE {
                continue;
            }
            let power = (exponent_bits(row) - exponent_bits(column)) / 2;
            if power == 0 {
                continue;
            }
            is_balanced = false;
            let (down, up) = (power_of_two(-power), power_of_two(power));
            a[i].entries_mut().iter_mut().for_each(|entry| *entry *= down);
            a.iter_mut().for_each(|row| *row.at_mut(i) *= up);
        }
        if is_balanced {
            break;
        }
    }
}

/// The exponent of a positive normal number, up to a constant.
#[inline]
fn exponent_bits(x: f64) -> i64 {
    (x.to_bits() >> 52) as i64
}

/// `2^power` for a power between -1022 and 1023.
#[inline]
fn power_of_two(power: i64) -> f64 {
    f64::from_bits(((1023 + power) as u64) << 52)
}

/// Reduces to Hessenberg form by Householder's reflections, column by column from `first` on.
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
        for (place, row) in direction.entries_mut()[k + 1..].iter_mut().zip(&a[k + 1..]) {
            let entry = row.at(k) / size;
            *place = entry;
            square += entry * entry;
        }
        let norm = Number::sqrt(square).copysign(head);
        let pivot = direction.at(k + 1) + norm;
        *direction.at_mut(k + 1) = pivot;
        let factor = 1.0 / (norm * pivot);
        *a[k + 1].at_mut(k) = -norm * size;
        a[k + 2..].iter_mut().for_each(|row| *row.at_mut(k) = 0.0);
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
