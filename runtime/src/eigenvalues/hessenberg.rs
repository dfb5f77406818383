//! Matrices balanced, and brought to Hessenberg form, by similarity: their eigenvalues stay the same.

use crate::number::Number;
use crate::numeric::Square;

/// Scales row i by `2^-e_i` and column i by `2^e_i`, so that both are of about the same size (Parlett & Reinsch 1969).
///
/// Powers of two round nothing. Without it, rounding is relative to the largest of entries that may only be large because
/// of the units of the coordinates. The entries must be at most one.
#[inline]
pub(super) fn balance(a: &mut Square<f64>) {
    // Each round brings the sizes closer; one that does little is the last, and two are usual.
    const ROUNDS: usize = 16;
    // How much larger one may be than the other: up to here no power of two gains much.
    const ALIKE: f64 = 2.0;
    for _ in 0..ROUNDS {
        let mut is_balanced = true;
        for i in 0..a.size() {
            let (mut row, mut column) = (0.0, 0.0);
            for j in (0..a.size()).filter(|&j| j != i) {
                row += a[i][j].abs();
                column += a[j][i].abs();
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
            a[i].iter_mut().for_each(|entry| *entry *= down);
            a.rows_mut().for_each(|row| row[i] *= up);
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
pub(super) fn reduce(a: &mut Square<f64>, first: usize) {
    // As many numbers as two columns of the state matrix of eight coordinates have, without an allocation.
    const USUAL: usize = 32;
    let n = a.size();
    let (mut usual, mut unusual) = ([0.0; USUAL], Vec::new());
    let columns = if 2 * n <= USUAL {
        &mut usual[..2 * n]
    } else {
        unusual.resize(2 * n, 0.0);
        &mut unusual[..]
    };
    // The direction of a reflection, from the row below the diagonal on, and the sums of columns along it.
    let (direction, sums) = columns.split_at_mut(n);
    for k in first..n.saturating_sub(2) {
        let head = a[k + 1][k];
        let size = a.rows().skip(k + 2).fold(0.0, |size: f64, row| size.max(row[k].abs()));
        if size == 0.0 {
            continue;
        }
        let size = size.max(head.abs());
        let mut square = 0.0;
        for (place, row) in direction[k + 1..].iter_mut().zip(a.rows().skip(k + 1)) {
            let entry = row[k] / size;
            *place = entry;
            square += entry * entry;
        }
        let norm = Number::sqrt(square).copysign(head);
        let pivot = direction[k + 1] + norm;
        direction[k + 1] = pivot;
        let factor = 1.0 / (norm * pivot);
        a[k + 1][k] = -norm * size;
        a.rows_mut().skip(k + 2).for_each(|row| row[k] = 0.0);
        let (direction, sums) = (&direction[k + 1..], &mut sums[k + 1..]);
        // From the left, in the columns after k.
        sums.fill(0.0);
        for (row, along) in a.rows().skip(k + 1).zip(direction) {
            sums.iter_mut().zip(&row[k + 1..]).for_each(|(sum, entry)| *sum += along * entry);
        }
        for (row, along) in a.rows_mut().skip(k + 1).zip(direction) {
            let along = along * factor;
            row[k + 1..].iter_mut().zip(&*sums).for_each(|(entry, sum)| *entry -= along * sum);
        }
        // From the right, in all rows.
        for row in a.rows_mut() {
            let row = &mut row[k + 1..];
            let sum = factor * row.iter().zip(direction).fold(0.0, |sum, (entry, along)| sum + entry * along);
            row.iter_mut().zip(direction).for_each(|(entry, along)| *entry -= sum * along);
        }
    }
}
