//! The eigenvalues of a Hessenberg matrix, by the QR algorithm with two shifts in one real sweep (Francis 1961).

use nalgebra::Complex;

use super::shifts::Shifts;
use crate::number::Number;
use crate::numeric::Square;

/// The bound on the sweeps per eigenvalue that LAPACK uses; two or three are usual.
pub(super) const SWEEPS_PER_EIGENVALUE: usize = 30;

/// After so many sweeps without an eigenvalue the shifts are others, since the usual ones may go around in a circle.
const PATIENCE: usize = 10;

/// What is lost below this is nothing beside entries of size one.
const TINY: f64 = f64::MIN_POSITIVE / f64::EPSILON;

/// Passes the eigenvalues on one by one; pairs one after the other, exactly conjugate.
///
/// `None` if the bound on the sweeps is exceeded. The matrix is overwritten.
#[inline]
pub(super) fn find_eigenvalues(h: &mut Square<f64>, mut found: impl FnMut(Complex<f64>)) -> Option<()> {
    let mut end = h.size();
    let (mut sweeps, mut since_last) = (0, 0);
    while end > 0 {
        let last = end - 1;
        let start = (1..end).rev().find(|&i| splits(h, i)).unwrap_or(0);
        if start == last {
            found(Complex::new(h[last][last] + 0.0, 0.0));
        } else if start + 1 == last {
            let pair = block([[h[start][start], h[start][last]], [h[last][start], h[last][last]]]);
            pair.into_iter().for_each(&mut found);
        } else {
            if sweeps == SWEEPS_PER_EIGENVALUE * h.size() {
                return None;
            }
            sweeps += 1;
            since_last += 1;
            let shifts = match since_last % PATIENCE {
                0 => Shifts::exceptional(h, last),
                1 => Shifts::of_block(h, start, last),
                _ => Shifts::usual(h, last),
            };
            sweep(h, start, last, shifts);
            continue;
        }
        (end, since_last) = (start, 0);
    }
    Some(())
}

/// Whether the entry to the left of the diagonal in row i is negligible (Ahues & Tisseur 1997).
#[inline(always)]
fn splits(h: &Square<f64>, i: usize) -> bool {
    let (above, below) = (h[i - 1][i - 1], h[i][i]);
    let (left, right) = (h[i][i - 1].abs(), h[i - 1][i].abs());
    let mut size = above.abs() + below.abs();
    if size == 0.0 {
        let before = if i > 1 { h[i - 1][i - 2].abs() } else { 0.0 };
        size = before + if i + 1 < h.size() { h[i + 1][i].abs() } else { 0.0 };
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

/// One step for both shifts, in the rows from `start` to `last`: three of them or more.
#[inline(always)]
fn sweep(h: &mut Square<f64>, start: usize, last: usize, shifts: Shifts) {
    // Where two entries below the diagonal are small together, the sweep may start after them.
    let mut first = last - 2;
    let mut column = first_column(h, first, shifts);
    while first > start {
        let diagonal = h[first - 1][first - 1].abs() + h[first][first].abs() + h[first + 1][first + 1].abs();
        let moved = h[first][first - 1].abs() * (column[1].abs() + column[2].abs());
        if moved <= f64::EPSILON * column[0].abs() * diagonal {
            break;
        }
        first -= 1;
        column = first_column(h, first, shifts);
    }
    for k in first..last - 1 {
        let Some(reflection) = Reflection::new(column) else {
            column = [h[k + 1][k], h[k + 2][k], 0.0];
            continue;
        };
        if k > first {
            h[k][k - 1] = reflection.head;
            h[k + 1][k - 1] = 0.0;
            h[k + 2][k - 1] = 0.0;
        } else if first > start {
            h[k][k - 1] *= 1.0 - reflection.along[0] * reflection.across[0];
        }
        column = reflection.apply(h, k, start, last);
    }
    // The last reflection is of two rows.
    let k = last - 1;
    let Some(Reflection { along, across, head }) = Reflection::new([column[0], column[1], 0.0]) else {
        return;
    };
    h[k][k - 1] = head;
    h[last][k - 1] = 0.0;
    for column in [k, last] {
        let (upper, lower) = (h[k][column], h[last][column]);
        let sum = upper * along[0] + lower * along[1];
        h[k][column] = upper - sum * across[0];
        h[last][column] = lower - sum * across[1];
    }
    for row in h.rows_between_mut(start, last + 1) {
        if let [left, right] = &mut row[k..last + 1] {
            let sum = *left * along[0] + *right * along[1];
            *left -= sum * across[0];
            *right -= sum * across[1];
        }
    }
}

/// The first column of `(H - s1) (H - s2)` from row k on.
#[inline(always)]
fn first_column(h: &Square<f64>, k: usize, Shifts { x, y, w }: Shifts) -> [f64; 3] {
    let (z, below) = (h[k][k], h[k + 1][k]);
    let (from_x, from_y) = (x - z, y - z);
    [
        (from_x * from_y - w) + below * h[k][k + 1],
        below * (h[k + 1][k + 1] - z - from_x - from_y),
        below * h[k + 2][k + 1],
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
    #[inline(always)]
    fn new([mut c0, mut c1, mut c2]: [f64; 3]) -> Option<Self> {
        const SMALL: f64 = f64::MIN_POSITIVE / (f64::EPSILON * f64::EPSILON);
        let (mut square, mut unit) = (c0 * c0 + (c1 * c1 + c2 * c2), 1.0);
        if square < SMALL {
            // The squares have lost digits to underflow.
            const SCALE: f64 =
                (1u128 << 127) as f64 * (1u128 << 127) as f64 * (1u128 << 127) as f64 * (1u128 << 127) as f64;
            (c0, c1, c2, unit) = (c0 * SCALE, c1 * SCALE, c2 * SCALE, 1.0 / SCALE);
            square = c0 * c0 + (c1 * c1 + c2 * c2);
            if square < SMALL {
                return None;
            }
        }
        let norm = Number::sqrt(square).copysign(c0);
        let head = c0 + norm;
        let factor = 1.0 / (norm * head);
        Some(Self { along: [head, c1, c2], across: [head * factor, c1 * factor, c2 * factor], head: -norm * unit })
    }

    /// Reflects three rows from k on, and the same columns; what column k is then below the diagonal.
    #[inline(always)]
    fn apply(&self, h: &mut Square<f64>, k: usize, start: usize, last: usize) -> [f64; 3] {
        let (size, count) = (h.size(), last + 1 - k);
        let entries = h.entries_mut();
        // The three rows from the diagonal of the first one on.
        let rows = entries.get_mut(k * (size + 1)..).and_then(|rows| {
            let (first, rows) = rows.split_at_mut_checked(size)?;
            let (second, third) = rows.split_at_mut_checked(size)?;
            Some([first.get_mut(..count)?, second.get_mut(..count)?, third.get_mut(..count)?])
        });
        let Some([[u0, u1, u2, first @ ..], [m0, m1, m2, second @ ..], [l0, l1, l2, third @ ..]]) = rows else {
            return [0.0; 3];
        };
        // What both change is kept in registers: the next reflection waits for it.
        let (x0, y0, z0) = self.mirrored(*u0, *m0, *l0);
        let (x1, y1, z1) = self.mirrored(*u1, *m1, *l1);
        let (x2, y2, z2) = self.mirrored(*u2, *m2, *l2);
        (*u0, *u1, *u2) = self.mirrored(x0, x1, x2);
        (*m0, *m1, *m2) = self.mirrored(y0, y1, y2);
        (*l0, *l1, *l2) = self.mirrored(z0, z1, z2);
        let next = [*m0, *l0];
        for ((first, second), third) in first.iter_mut().zip(second).zip(third) {
            (*first, *second, *third) = self.mirrored(*first, *second, *third);
        }
        let mut place = start * size + k;
        for _ in start..k {
            if let Some([left, middle, right]) = entries.get_mut(place..place + 3) {
                (*left, *middle, *right) = self.mirrored(*left, *middle, *right);
            }
            place += size;
        }
        // Of the row after them there is only the entry below the diagonal so far.
        let after = place + 3 * size;
        let mut below = 0.0;
        if count > 3
            && let Some([left, middle, right]) = entries.get_mut(after..after + 3)
        {
            (*left, *middle, *right) = self.mirrored(0.0, 0.0, *right);
            below = *left;
        }
        [next[0], next[1], below]
    }

    #[inline(always)]
    fn mirrored(&self, x: f64, y: f64, z: f64) -> (f64, f64, f64) {
        let sum = self.along[0] * x + (self.along[1] * y + self.along[2] * z);
        (x - sum * self.across[0], y - sum * self.across[1], z - sum * self.across[2])
    }
}
