//! Numbers that lie one design after the other, into lanes and back.

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use super::{InLanes, Lanes};

/// As many lanes as the widest registers have, in `f32`.
pub const MOST: usize = 16;

/// Rows to columns, of as many registers as there are lanes.
///
/// Each round zips the first half with the second; after as many rounds as the logarithm of the number of lanes, each number is
/// in its place.
#[inline(always)]
pub fn transpose<S: Simd, T: InLanes>(square: &mut [Lanes<S, T>]) {
    let lanes = Lanes::<S, T>::COUNT;
    let half = lanes / 2;
    for _ in 0..lanes.ilog2() {
        let mut rows = [square[0]; MOST];
        rows[..lanes].copy_from_slice(square);
        for row in 0..half {
            let (first, second) = (rows[row].0, rows[row + half].0);
            square[2 * row] = Lanes(first.zip_low(second));
            square[2 * row + 1] = Lanes(first.zip_high(second));
        }
    }
}
