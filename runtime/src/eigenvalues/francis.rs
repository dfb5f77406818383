//! The eigenvalues of a Hessenberg matrix, by the QR algorithm with two shifts in one real sweep (Francis 1961).

use super::hessenberg::Row;
use crate::{Complex, Scalar};

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
/// `None` if the bound on the sweeps is exceeded. The matrix is overwritten; what is below its subdiagonal is not read.
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
        let (re, im) = (d + half, Scalar::sqrt(-discriminant));
        return [Complex::new(re, -im), Complex::new(re, im)];
    }
    // The offset from d that does not cancel; the other is the product over it.
    let large = half + Scalar::sqrt(discriminant).copysign(half);
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
    let large = half + Scalar::sqrt(discriminant).copysign(half);
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
        let size = column[0].abs()
            * (h[first - 1].at(first - 1).abs() + h[first].at(first).abs() + h[first + 1].at(first + 1).abs());
        if h[first].at(first - 1).abs() * (column[1].abs() + column[2].abs()) <= f64::EPSILON * size {
            break;
        }
        first -= 1;
        column = first_column(h, first, shifts);
    }
    for k in first..last {
        let rows = 3.min(last + 1 - k);
        if k > first {
            column = [h[k].at(k - 1), h[k + 1].at(k - 1), if rows == 3 { h[k + 2].at(k - 1) } else { 0.0 }];
        }
        let size = column[0].abs() + column[1].abs() + column[2].abs();
        if size == 0.0 {
            continue;
        }
        let [p, q, r] = column.map(|entry| entry / size);
        let norm = Scalar::sqrt(p * p + q * q + r * r).copysign(p);
        if k > first {
            *h[k].at_mut(k - 1) = -norm * size;
        } else if first > start {
            let before = h[k].at(k - 1);
            *h[k].at_mut(k - 1) = -before;
        }
        let p = p + norm;
        // The reflection is 1 - (1, v1, v2)^T (u0, u1, u2).
        let (u, v) = ([p / norm, q / norm, r / norm], [q / p, r / p]);
        if rows == 3 {
            reflect_three(h, k, start, last, u, v);
        } else {
            reflect_two(h, k, start, last, u, v[0]);
        }
    }
}

/// The first column of `(H - s1) (H - s2)` from row k on, over the entry below the diagonal there, and scaled.
#[inline]
fn first_column<R: Row>(h: &[R], k: usize, Shifts { x, y, w }: Shifts) -> [f64; 3] {
    let z = h[k].at(k);
    let (from_x, from_y) = (x - z, y - z);
    let column = [
        (from_x * from_y - w) / h[k + 1].at(k) + h[k].at(k + 1),
        h[k + 1].at(k + 1) - z - from_x - from_y,
        h[k + 2].at(k + 1),
    ];
    let size = column[0].abs() + column[1].abs() + column[2].abs();
    column.map(|entry| entry / size)
}

/// The reflection of three rows, and of the same columns.
#[inline]
fn reflect_three<R: Row>(h: &mut [R], k: usize, start: usize, last: usize, u: [f64; 3], v: [f64; 2]) {
    if let [upper, middle, lower] = &mut h[k..k + 3] {
        let columns = k..last + 1;
        let upper = &mut upper.entries_mut()[columns.clone()];
        let middle = &mut middle.entries_mut()[columns.clone()];
        let lower = &mut lower.entries_mut()[columns];
        for ((upper, middle), lower) in upper.iter_mut().zip(middle).zip(lower) {
            let sum = *upper + v[0] * *middle + v[1] * *lower;
            *upper -= sum * u[0];
            *middle -= sum * u[1];
            *lower -= sum * u[2];
        }
    }
    for row in &mut h[start..last.min(k + 3) + 1] {
        if let [left, middle, right] = &mut row.entries_mut()[k..k + 3] {
            let sum = *left * u[0] + *middle * u[1] + *right * u[2];
            *left -= sum;
            *middle -= sum * v[0];
            *right -= sum * v[1];
        }
    }
}

/// The reflection of two rows, and of the same columns.
#[inline]
fn reflect_two<R: Row>(h: &mut [R], k: usize, start: usize, last: usize, u: [f64; 3], v: f64) {
    if let [upper, lower] = &mut h[k..k + 2] {
        for (upper, lower) in upper.entries_mut()[k..last + 1].iter_mut().zip(&mut lower.entries_mut()[k..last + 1]) {
            let sum = *upper + v * *lower;
            *upper -= sum * u[0];
            *lower -= sum * u[1];
        }
    }
    for row in &mut h[start..last + 1] {
        if let [left, right] = &mut row.entries_mut()[k..k + 2] {
            let sum = *left * u[0] + *right * u[1];
            *left -= sum;
            *right -= sum * v;
        }
    }
}
