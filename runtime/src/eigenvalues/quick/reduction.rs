//! The state matrix, balanced and in Hessenberg form.

use super::{pairs, pairs_mut};
use crate::number::lane::Lane;

/// The transposed state matrix, with the position and the rate of each coordinate next to each other, in units of time that
/// bring stiffness and damping to about one at most; this unit in 1/s; and whether it is in the middle of the range of numbers.
#[inline(always)]
pub(super) fn state_matrix<T: Lane, const H: usize, const C: usize>(
    n: usize,
    sides: &[[T; C]; H],
) -> ([[T; C]; C], T, T::Mask) {
    assert!(n <= H && 2 * n <= C);
    const RANGE: [f64; 2] = [1e-60, 1e60];
    let (zero, one) = (sides[0][0].like(0.0), sides[0][0].like(1.0));
    let (mut stiffness, mut damping) = (zero, zero);
    for side in &sides[..n] {
        for j in 0..n {
            stiffness = larger(stiffness, side[j].abs());
            damping = larger(damping, side[n + j].abs());
        }
    }
    let largest = larger(stiffness.sqrt(), damping);
    let is_moderate = largest.like(RANGE[0]).less(largest) & largest.less(largest.like(RANGE[1]));
    // Of a system without stiffness and damping, or out of range, nothing is left to divide.
    let unit = T::select(is_moderate, largest, one).power_of_two();
    let inverse = one / unit;
    let mut rows = [[zero; C]; C];
    for (i, side) in sides[..n].iter().enumerate() {
        rows[2 * i + 1][2 * i] = one;
        for j in 0..n {
            rows[2 * j][2 * i + 1] = zero - side[j] * inverse * inverse;
            rows[2 * j + 1][2 * i + 1] = zero - side[n + j] * inverse;
        }
    }
    (rows, unit, is_moderate)
}

/// Scales rows and columns by powers of two, so that those of one place are of about the same size (Parlett & Reinsch 1969).
/// The norm that is left.
#[inline(always)]
pub(super) fn balance<T: Lane, const C: usize>(size: usize, a: &mut [[T; C]; C]) -> T {
    assert!(size <= C);
    const ROUNDS: usize = 6;
    // How much larger one may be than the other: up to here powers of two gain little.
    const ALIKE: f64 = 4.0;
    let (zero, one) = (a[0][0].like(0.0), a[0][0].like(1.0));
    let (alike, half) = (zero.like(ALIKE), zero.like(core::f64::consts::SQRT_2));
    let tiny = zero.like(f64::MIN_POSITIVE);
    let (mut rows, mut columns) = ([zero; C], [zero; C]);
    for i in 0..size {
        let mut sum = zero;
        for j in 0..size {
            let entry = if i == j { zero } else { a[i][j].abs() };
            sum = sum + entry;
            columns[j] = columns[j] + entry;
        }
        rows[i] = sum;
    }
    for _ in 0..ROUNDS {
        let mut are_balanced = zero.less_or_equal(zero);
        for i in 0..size {
            let (row, column) = (rows[i], columns[i]);
            let is_balanced = (row.less_or_equal(alike * column) & column.less_or_equal(alike * row))
                | !(tiny.less(row) & tiny.less(column));
            if T::all(is_balanced) {
                continue;
            }
            are_balanced = are_balanced & is_balanced;
            let up = T::select(is_balanced, one, (half * (row / column).sqrt()).power_of_two());
            let down = one / up;
            (rows[i], columns[i]) = (row * down, column * up);
            for j in 0..size {
                if i != j {
                    let (in_row, in_column) = (a[i][j] * down, a[j][i] * up);
                    columns[j] = columns[j] + (in_row.abs() - a[i][j].abs());
                    rows[j] = rows[j] + (in_column.abs() - a[j][i].abs());
                    (a[i][j], a[j][i]) = (in_row, in_column);
                }
            }
        }
        if T::all(are_balanced) {
            break;
        }
    }
    let mut norm = zero;
    for i in 0..size {
        norm = larger(norm, rows[i] + a[i][i].abs());
    }
    norm
}

/// Reduces to Hessenberg form by Householder's reflections, column by column from `first` on. What is left below is not
/// touched, and not meant.
#[inline(always)]
pub(super) fn reduce<T: Lane, const C: usize>(size: usize, first: usize, a: &mut [[T; C]; C]) {
    assert!(size <= C);
    if C == 6 && size == C {
        // Of three coordinates each column has loops of its own, which are written out.
        if first == 0 {
            reflect(0, C, a);
        }
        if first <= 1 {
            reflect(1, C, a);
        }
        if first <= 2 {
            reflect(2, C, a);
        }
        if first <= 3 {
            reflect(3, C, a);
        }
        return;
    }
    for k in first..size - 2 {
        reflect(k, size, a);
    }
}

#[inline(always)]
fn reflect<T: Lane, const C: usize>(k: usize, size: usize, a: &mut [[T; C]; C]) {
    assert!(k + 1 < size && size <= C);
    // Squares below this have lost digits, of numbers that are nothing beside those of about one.
    const TINY: f64 = 1e-200;
    let (zero, one) = (a[0][0].like(0.0), a[0][0].like(1.0));
    let head = a[k + 1][k];
    let mut square = zero;
    let mut direction = [zero; C];
    for i in k + 2..size {
        direction[i] = a[i][k];
        square = square + a[i][k] * a[i][k];
    }
    let is_reduced = square.less_or_equal(square.like(TINY));
    let norm = (head * head + square).sqrt().copysign(head);
    let pivot = head + norm;
    direction[k + 1] = pivot;
    let factor = T::select(is_reduced, zero, one / (norm * pivot));
    // Two columns at a time, from one with an even number on: left of those that are meant nothing counts.
    let even = k.div_ceil(2) * 2;
    let direction = &direction[..size];
    // From the left, in the columns after k: two rows at a time, so that sums are read and written half as often.
    let mut sums = [zero; C];
    let sums = pairs_mut(&mut sums[even..size]);
    let (two_rows, last_row) = a[k + 1..size].as_chunks::<2>();
    let (two_along, last_along) = direction[k + 1..].as_chunks::<2>();
    for ([row, next], along) in two_rows.iter().zip(two_along) {
        let entries = pairs(&row[even..size]).iter().zip(pairs(&next[even..size]));
        for (sum, (entry, below)) in sums.iter_mut().zip(entries) {
            *sum = [
                sum[0] + along[0] * entry[0] + along[1] * below[0],
                sum[1] + along[0] * entry[1] + along[1] * below[1],
            ];
        }
    }
    for (row, along) in last_row.iter().zip(last_along) {
        for (sum, entry) in sums.iter_mut().zip(pairs(&row[even..size])) {
            *sum = [sum[0] + *along * entry[0], sum[1] + *along * entry[1]];
        }
    }
    for (row, along) in a[k + 1..size].iter_mut().zip(&direction[k + 1..]) {
        let along = *along * factor;
        for (entry, sum) in pairs_mut(&mut row[even..size]).iter_mut().zip(&*sums) {
            *entry = [entry[0] - along * sum[0], entry[1] - along * sum[1]];
        }
    }
    a[k + 1][k] = T::select(is_reduced, head, zero - norm);
    // From the right, in all rows, of which there is an even number.
    let direction = pairs(&direction[even..]);
    for [first, second] in a[..size].as_chunks_mut::<2>().0 {
        let (first, second) = (pairs_mut(&mut first[even..size]), pairs_mut(&mut second[even..size]));
        let (mut of_first, mut of_second) = ([zero; 2], [zero; 2]);
        for ((x, y), along) in first.iter().zip(&*second).zip(direction) {
            of_first = [of_first[0] + x[0] * along[0], of_first[1] + x[1] * along[1]];
            of_second = [of_second[0] + y[0] * along[0], of_second[1] + y[1] * along[1]];
        }
        let (of_first, of_second) = ((of_first[0] + of_first[1]) * factor, (of_second[0] + of_second[1]) * factor);
        for ((x, y), along) in first.iter_mut().zip(second).zip(direction) {
            *x = [x[0] - of_first * along[0], x[1] - of_first * along[1]];
            *y = [y[0] - of_second * along[0], y[1] - of_second * along[1]];
        }
    }
}

#[inline(always)]
fn larger<T: Lane>(x: T, y: T) -> T {
    T::select(x.less(y), y, x)
}
