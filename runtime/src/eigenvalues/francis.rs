//! The eigenvalues of a Hessenberg matrix, by the QR algorithm with two shifts in one real sweep (Francis 1961).

use super::hessenberg::Row;
use crate::{Complex, Number};

/// The bound on the sweeps per eigenvalue that LAPACK uses; two or three are usual.
pub(super) const SWEEPS_PER_EIGENVALUE: usize = 30;

/// After so many sweeps without an eigenvalue the shifts are others, since the usual ones may go around in a circle.
const PATIENCE: usize = 10;

/// What is lost below this is nothing beside entries of size one.
const TINY: f64 = f64::MIN_POSITIVE / f64::EPSILON;

/// Two shifts: the eigenvalues of a matrix with the diagonal x, y and the product w of the other entries.
#[derive(Clone, Copy)]
struct Shifts {
    x: f64,
    y: f64,
    w: f64,
}

/// Passes the eigenvalues on one by one; pairs one after the other, exactly conjugate.
///
/// `None` if the bound on the sweeps is exceeded. The matrix is overwritten.
#[inline]
pub(super) fn eigenvalues<R: Row>(h: &mut [R], mut found: impl FnMut(Complex<f64>)) -> Option<()> {
    let mut end = h.len();
    let (mut sweeps, mut since_last) = (0, 0);
    while end > 0 {
        let last = end - 1;
        let start = (1..end).rev().find(|&i| splits(h, i)).unwrap_or(0);
        if start == last {
            found(Complex::new(h[last].at(last) + 0.0, 0.0));
        } else if start + 1 == last {
            let pair = block([[h[start].at(start), h[start].at(last)], [h[last].at(start), h[last].at(last)]]);
            pair.into_iter().for_each(&mut found);
        } else {
            if sweeps == SWEEPS_PER_EIGENVALUE * h.len() {
                return None;
            }
            sweeps += 1;
            since_last += 1;
            let shifts = if since_last % PATIENCE == 0 { exceptional_shifts(h, last) } else { usual_shifts(h, last) };
            sweep(h, start, last, shifts);
            continue;
        }
        (end, since_last) = (start, 0);
    }
    Some(())
}

/// Whether the entry to the left of the diagonal in row i is negligible (Ahues & Tisseur 1997).
#[inline]
fn splits<R: Row>(h: &[R], i: usize) -> bool {
    let (above, below) = (h[i - 1].at(i - 1), h[i].at(i));
    let (left, right) = (h[i].at(i - 1).abs(), h[i - 1].at(i).abs());
    let mut size = above.abs() + below.abs();
    if size == 0.0 {
        let before = if i > 1 { h[i - 1].at(i - 2).abs() } else { 0.0 };
        size = before + if i + 1 < h.len() { h[i + 1].at(i).abs() } else { 0.0 };
    }
    if left <= TINY {
        return true;
    }
    if left > f64::EPSILON * size {
        return false;
    }
    let difference = (above - below).abs();
    let (large, small) = (below.abs().max(difference), below.abs().min(difference));
    let size = large + small;
    left.min(right) * (left.max(right) / size) <= TINY.max(f64::EPSILON * (small * (large / size)))
}

/// The eigenvalues of a block of two rows.
#[inline]
fn block([[a, b], [c, d]]: [[f64; 2]; 2]) -> [Complex<f64>; 2] {
    let half = 0.5 * (a - d);
    let product = b * c;
    let discriminant = half * half + product;
    if discriminant < 0.0 {
        let (re, im) = (d + half, Number::sqrt(-discriminant));
        return [Complex::new(re, -im), Complex::new(re, im)];
    }
    // The offset from d that does not cancel; the other is the product over it.
    let large = half + Number::sqrt(discriminant).copysign(half);
    let small = if large == 0.0 { 0.0 } else { product / large };
    [d + large, d - small].map(|re| Complex::new(re + 0.0, 0.0))
}

/// The eigenvalues of the last block of two rows; if they are real, twice the one that is closer to the last entry.
#[inline]
fn usual_shifts<R: Row>(h: &[R], last: usize) -> Shifts {
    let (x, y) = (h[last].at(last), h[last - 1].at(last - 1));
    let w = h[last].at(last - 1) * h[last - 1].at(last);
    let half = 0.5 * (y - x);
    let discriminant = half * half + w;
    if discriminant < 0.0 {
        return Shifts { x, y, w };
    }
    let large = half + Number::sqrt(discriminant).copysign(half);
    let closer = x - if large == 0.0 { 0.0 } else { w / large };
    Shifts { x: closer, y: closer, w: 0.0 }
}

/// A pair about the last entry, as far away as the entries below the diagonal are large (Wilkinson & Reinsch 1971).
#[cold]
fn exceptional_shifts<R: Row>(h: &[R], last: usize) -> Shifts {
    let size = h[last].at(last - 1).abs() + h[last - 1].at(last - 2).abs();
    let x = 0.75 * size + h[last].at(last);
    Shifts { x, y: x, w: -0.4375 * size * size }
}

/// One step for both shifts, in the rows from `start` to `last`: three of them or more.
#[inline]
fn sweep<R: Row>(h: &mut [R], start: usize, last: usize, shifts: Shifts) {
    // Where two entries below the diagonal are small together, the sweep may start after them.
    let mut first = last - 2;
    let mut column = first_column(h, first, shifts);
    while first > start {
        let diagonal = h[first - 1].at(first - 1).abs() + h[first].at(first).abs() + h[first + 1].at(first + 1).abs();
        let moved = h[first].at(first - 1).abs() * (column[1].abs() + column[2].abs());
        if moved <= f64::EPSILON * column[0].abs() * diagonal {
            break;
        }
        first -= 1;
        column = first_column(h, first, shifts);
    }
    for k in first..last - 1 {
        if k > first {
            column = core::array::from_fn(|i| h[k + i].at(k - 1));
        }
        let Some(Reflection { along, across, head }) = Reflection::new(column) else { continue };
        if k > first {
            *h[k].at_mut(k - 1) = head;
            *h[k + 1].at_mut(k - 1) = 0.0;
            *h[k + 2].at_mut(k - 1) = 0.0;
        } else if first > start {
            *h[k].at_mut(k - 1) *= 1.0 - along[0] * across[0];
        }
        if let [upper, middle, lower] = &mut h[k..k + 3] {
            let columns = k..last + 1;
            let upper = &mut upper.entries_mut()[columns.clone()];
            let middle = &mut middle.entries_mut()[columns.clone()];
            let lower = &mut lower.entries_mut()[columns];
            for ((upper, middle), lower) in upper.iter_mut().zip(middle).zip(lower) {
                let sum = *upper * along[0] + *middle * along[1] + *lower * along[2];
                *upper -= sum * across[0];
                *middle -= sum * across[1];
                *lower -= sum * across[2];
            }
        }
        for row in &mut h[start..last.min(k + 3) + 1] {
            if let [left, middle, right] = &mut row.entries_mut()[k..k + 3] {
                let sum = *left * along[0] + *middle * along[1] + *right * along[2];
                *left -= sum * across[0];
                *middle -= sum * across[1];
                *right -= sum * across[2];
            }
        }
    }
    // The last reflection is of two rows.
    let k = last - 1;
    let Some(Reflection { along, across, head }) = Reflection::new([h[k].at(k - 1), h[last].at(k - 1), 0.0]) else {
        return;
    };
    *h[k].at_mut(k - 1) = head;
    *h[last].at_mut(k - 1) = 0.0;
    for column in [k, last] {
        let (upper, lower) = (h[k].at(column), h[last].at(column));
        let sum = upper * along[0] + lower * along[1];
        *h[k].at_mut(column) = upper - sum * across[0];
        *h[last].at_mut(column) = lower - sum * across[1];
    }
    for row in &mut h[start..last + 1] {
        if let [left, right] = &mut row.entries_mut()[k..last + 1] {
            let sum = *left * along[0] + *right * along[1];
            *left -= sum * across[0];
            *right -= sum * across[1];
        }
    }
}

/// The first column of `(H - s1) (H - s2)` from row k on.
#[inline]
fn first_column<R: Row>(h: &[R], k: usize, Shifts { x, y, w }: Shifts) -> [f64; 3] {
    let (z, below) = (h[k].at(k), h[k + 1].at(k));
    let (from_x, from_y) = (x - z, y - z);
    [
        (from_x * from_y - w) + below * h[k].at(k + 1),
        below * (h[k + 1].at(k + 1) - z - from_x - from_y),
        below * h[k + 2].at(k + 1),
    ]
}

/// The reflection `1 - across along^T` that turns a column to (head, 0, 0).
struct Reflection {
    along: [f64; 3],
    across: [f64; 3],
    head: f64,
}

impl Reflection {
    /// `None` if the column is zero.
    #[inline]
    fn new(column: [f64; 3]) -> Option<Self> {
        let square = column[0] * column[0] + (column[1] * column[1] + column[2] * column[2]);
        if square < f64::MIN_POSITIVE / (f64::EPSILON * f64::EPSILON) {
            return Self::of_small(column);
        }
        let norm = Number::sqrt(square).copysign(column[0]);
        let along = [column[0] + norm, column[1], column[2]];
        let factor = 1.0 / (norm * along[0]);
        Some(Self { along, across: along.map(|entry| entry * factor), head: -norm })
    }

    /// Of a column whose square has lost digits to underflow.
    #[cold]
    fn of_small(column: [f64; 3]) -> Option<Self> {
        let scale = 2f64.powi(500);
        let scaled = column.map(|entry| entry * scale);
        if scaled.iter().all(|entry| entry.abs() <= TINY) {
            return None;
        }
        Self::new(scaled).map(|reflection| Self { head: reflection.head / scale, ..reflection })
    }
}
