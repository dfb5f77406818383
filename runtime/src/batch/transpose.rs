//! Numbers that lie one design after the other, into lanes and back.

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use fearless_simd::Level;
use fearless_simd::Simd;
use fearless_simd::prelude::*;

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use super::sixteen;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use super::wide::{self, same};
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

#[inline(always)]
fn zip<S: Simd, T: InLanes>(a: Lanes<S, T>, b: Lanes<S, T>) -> [Lanes<S, T>; 2] {
    [Lanes(a.0.zip_low(b.0)), Lanes(a.0.zip_high(b.0))]
}

#[inline(always)]
fn unzip<S: Simd, T: InLanes>(a: Lanes<S, T>, b: Lanes<S, T>) -> [Lanes<S, T>; 2] {
    [Lanes(a.0.unzip_low(b.0)), Lanes(a.0.unzip_high(b.0))]
}

/// In two rounds, each of which zips the first half with the second. Of wider registers zips bring numbers across them, which
/// takes twice as many instructions as within each four lanes.
#[inline(always)]
fn of_four_lanes<S: Simd, T: InLanes>([a, b, c, d]: [Lanes<S, T>; 4]) -> [Lanes<S, T>; 4] {
    let ([a, b], [c, d]) = (unzip(a, b), unzip(c, d));
    let ([a, c], [b, d]) = (unzip(a, c), unzip(b, d));
    [a, b, c, d]
}

#[inline(always)]
pub fn transpose_f32<S: Simd>(rows: [Lanes<S, f32>; 4]) -> [Lanes<S, f32>; 4] {
    let columns = match rows[0].0.token().level() {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx2(avx2) => same(rows).and_then(
            #[inline(always)]
            |rows| same(wide::transpose_eight_f32(avx2, rows)),
        ),
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx512(avx512) => same(rows).and_then(
            #[inline(always)]
            |rows| same(wide::transpose_sixteen_f32(avx512, rows)),
        ),
        _ => None,
    };
    if let Some(columns) = columns { columns } else { of_four_lanes(rows) }
}

#[inline(always)]
pub fn transpose_f64<S: Simd>(rows: [Lanes<S>; 4]) -> [Lanes<S>; 4] {
    let columns = match rows[0].0.token().level() {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx2(avx2) => same(rows).and_then(
            #[inline(always)]
            |rows| same(wide::transpose_four_f64(avx2, rows)),
        ),
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx512(avx512) => same(rows).and_then(
            #[inline(always)]
            |rows| same(wide::transpose_eight_f64(avx512, rows)),
        ),
        _ => None,
    };
    if let Some(columns) = columns { columns } else { of_four_lanes(rows) }
}

// Not in debug builds: once for each parameter, it would take more stack than a thread has.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn side_by_side_f32<S: Simd>(simd: S, four: impl Fn(usize, usize) -> [f32; 4] + Copy) -> [Lanes<S, f32>; 8] {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    if let Level::Avx512(avx512) = simd.level()
        && let Some(columns) = same(sixteen::side_by_side(avx512, four))
    {
        return columns;
    }
    let [a, b, c, d] = four_f32(
        simd,
        #[inline(always)]
        |design| four(design, 0),
    );
    let [e, f, g, h] = four_f32(
        simd,
        #[inline(always)]
        |design| four(design, 1),
    );
    [a, b, c, d, e, f, g, h]
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub fn side_by_side_f64<S: Simd>(simd: S, four: impl Fn(usize, usize) -> [f64; 4] + Copy) -> [Lanes<S>; 8] {
    let [a, b, c, d] = four_f64(
        simd,
        #[inline(always)]
        |design| four(design, 0),
    );
    let [e, f, g, h] = four_f64(
        simd,
        #[inline(always)]
        |design| four(design, 1),
    );
    [a, b, c, d, e, f, g, h]
}

#[inline(always)]
fn four_f32<S: Simd>(simd: S, four: impl Fn(usize) -> [f32; 4] + Copy) -> [Lanes<S, f32>; 4] {
    let columns = match simd.level() {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx2(avx2) => same(wide::side_by_side_eight_f32(avx2, four)),
        _ => None,
    };
    if let Some(columns) = columns {
        return columns;
    }
    // By twos, which lie side by side already.
    let [[a, e], [b, f], [c, g], [d, h]] = [twos(four(0)), twos(four(1)), twos(four(2)), twos(four(3))];
    let [a, b] = unzip(of_twos(simd, a, b), of_twos(simd, c, d));
    let [c, d] = unzip(of_twos(simd, e, f), of_twos(simd, g, h));
    [a, b, c, d]
}

/// The bits of the first two numbers, as they lie in memory, and of the others.
#[inline(always)]
fn twos([a, b, c, d]: [f32; 4]) -> [u64; 2] {
    let [a, b, c, d]: [u64; 4] = [a.to_bits().into(), b.to_bits().into(), c.to_bits().into(), d.to_bits().into()];
    if cfg!(target_endian = "little") { [a | b << 32, c | d << 32] } else { [a << 32 | b, c << 32 | d] }
}

#[inline(always)]
fn of_twos<S: Simd>(simd: S, a: u64, b: u64) -> Lanes<S, f32> {
    let twos = S::u64s::from_slice(simd, &[a, b]);
    Lanes(twos.bitcast())
}

#[inline(always)]
fn four_f64<S: Simd>(simd: S, four: impl Fn(usize) -> [f64; 4] + Copy) -> [Lanes<S>; 4] {
    let columns = match simd.level() {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx2(avx2) => same(wide::side_by_side_four_f64(avx2, four)),
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx512(avx512) => same(wide::side_by_side_eight_f64(avx512, four)),
        _ => None,
    };
    if let Some(columns) = columns {
        return columns;
    }
    let [first, second] = [four(0), four(1)];
    let [a, b] = zip(Lanes::load(simd, &first[..2]), Lanes::load(simd, &second[..2]));
    let [c, d] = zip(Lanes::load(simd, &first[2..]), Lanes::load(simd, &second[2..]));
    [a, b, c, d]
}
