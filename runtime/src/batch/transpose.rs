//! Numbers that lie one design after the other, into lanes and back.

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use fearless_simd::Level;
use fearless_simd::Simd;
use fearless_simd::prelude::*;

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use super::wide;
use super::{InLanes, Lanes};

/// As many lanes as the widest registers have, in `f32`.
#[cfg(feature = "std")]
pub const MOST: usize = 16;

/// Numbers of a design that are brought side by side. More would take more rounds; a matrix of two coordinates has four.
pub const GROUP: usize = 4;

/// Rows to columns, within each four lanes of four registers, or of two that have two lanes.
///
/// So registers of the first to the fourth number of designs become registers of the numbers of the first to the fourth
/// design, beside which in the next four lanes stand those of the designs four further on; and back.
#[inline(always)]
pub fn transpose_group<S: Simd, T: InLanes>(registers: &mut [Lanes<S, T>]) {
    match *registers {
        [a, b, c, d] => registers.copy_from_slice(&T::transpose_fours([a, b, c, d])),
        [a, b] => registers.copy_from_slice(&zip(a, b)),
        _ => {}
    }
}

/// Rows to columns, of as many registers as there are lanes.
///
/// Each round zips the first half with the second; after as many rounds as the logarithm of the number of lanes, each number is in
/// its place.
#[cfg(feature = "std")]
#[inline(always)]
pub fn transpose<S: Simd, T: InLanes>(square: &mut [Lanes<S, T>]) {
    let count = square.len();
    let half = count / 2;
    for _ in 0..count.ilog2() {
        let mut rows = [square[0]; MOST];
        rows[..count].copy_from_slice(square);
        for row in 0..half {
            [square[2 * row], square[2 * row + 1]] = zip(rows[row], rows[row + half]);
        }
    }
}

/// The same numbers, to the last bit.
///
/// The compiler reads numbers of designs one by one. It sees through the shuffles of AVX2, and would bring each into its lane
/// alone; but not that the greater of a number and itself is that number. So it reads four at once.
#[inline(always)]
pub fn as_a_whole<S: Simd, T: InLanes>(lanes: Lanes<S, T>) -> Lanes<S, T> {
    match lanes.0.token().level() {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx2(_) => Lanes(lanes.0.max(lanes.0)),
        _ => lanes,
    }
}

/// In two rounds, each of which zips the first half with the second. Of wider registers zips bring numbers across them, which
/// takes twice as many instructions as within each four lanes.
#[inline(always)]
fn of_four_lanes<S: Simd, T: InLanes>([a, b, c, d]: [Lanes<S, T>; 4]) -> [Lanes<S, T>; 4] {
    let ([a, b], [c, d]) = (zip(a, c), zip(b, d));
    let ([a, b], [c, d]) = (zip(a, c), zip(b, d));
    [a, b, c, d]
}

#[inline(always)]
fn zip<S: Simd, T: InLanes>(a: Lanes<S, T>, b: Lanes<S, T>) -> [Lanes<S, T>; 2] {
    [Lanes(a.0.zip_low(b.0)), Lanes(a.0.zip_high(b.0))]
}

#[inline(always)]
pub fn transpose_f32<S: Simd>(registers: [Lanes<S, f32>; 4]) -> [Lanes<S, f32>; 4] {
    match registers[0].0.token().level() {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx2(avx2) => wide::transpose_eight_f32(avx2, registers),
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx512(avx512) => wide::transpose_sixteen_f32(avx512, registers),
        _ => of_four_lanes(registers),
    }
}

#[inline(always)]
pub fn transpose_f64<S: Simd>(registers: [Lanes<S>; 4]) -> [Lanes<S>; 4] {
    match registers[0].0.token().level() {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx2(avx2) => wide::transpose_four_f64(avx2, registers),
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx512(avx512) => wide::transpose_eight_f64(avx512, registers),
        _ => of_four_lanes(registers),
    }
}
