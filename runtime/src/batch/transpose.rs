//! Numbers that lie one design after the other, into lanes and back.

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use super::{InLanes, Lanes};

/// As many lanes as the widest registers have, in `f32`.
pub const MOST: usize = 16;

/// Numbers of designs, a register of each, to one design after the other: the numbers of the first one side by side, then those
/// of the second one. The registers are a power of two; of as many as there are lanes each becomes a design.
///
/// Each round zips the first half with the second; after as many rounds as the logarithm of the number of registers, each number
/// is in its place.
#[inline(always)]
pub fn transpose<S: Simd, T: InLanes>(registers: &mut [Lanes<S, T>]) {
    let count = registers.len();
    let half = count / 2;
    for _ in 0..count.ilog2() {
        let mut rows = [registers[0]; MOST];
        rows[..count].copy_from_slice(registers);
        for row in 0..half {
            let (first, second) = (rows[row].0, rows[row + half].0);
            registers[2 * row] = Lanes(first.zip_low(second));
            registers[2 * row + 1] = Lanes(first.zip_high(second));
        }
    }
}
