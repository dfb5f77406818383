//! Slices of designs in `f32` by the instructions of AVX-512, sixteen at a time.
//!
//! What takes the time there is bringing numbers across registers, which one of the processor's units does alone, and writing: so
//! many small writes wait for each other. So eight numbers of each design are read at once, and two matrices written.

#[cfg(target_arch = "x86")]
use core::arch::x86::*;
#[cfg(target_arch = "x86_64")]
use core::arch::x86_64::*;
use core::hint::black_box;
use core::sync::atomic::{Ordering, compiler_fence};

use fearless_simd::prelude::*;
use fearless_simd::{Avx512, f32x4, f32x8, kernel, u32x16};

use super::Lanes;
use crate::system::{Coefficients, States};

/// Sixteen numbers.
type Register = Lanes<Avx512, f32>;

/// The first to the eighth of eight numbers of designs, which are given by fours.
#[inline(always)]
pub fn side_by_side(avx512: Avx512, four: impl Fn(usize, usize) -> [f32; 4] + Copy) -> [Register; 8] {
    let [a, b, c, d] = [row(avx512, four, 0), row(avx512, four, 1), row(avx512, four, 2), row(avx512, four, 3)];
    let [e, f, g, h] = [row(avx512, four, 8), row(avx512, four, 9), row(avx512, four, 10), row(avx512, four, 11)];
    across_quarters(avx512, in_quarters(avx512, [a, b, c, d]), in_quarters(avx512, [e, f, g, h]))
}

/// Eight numbers of a design, and of the one four further on.
#[inline(always)]
fn row(avx512: Avx512, four: impl Fn(usize, usize) -> [f32; 4], design: usize) -> Register {
    let [first, second] =
        [eight(avx512, four(design, 0), four(design, 1)), eight(avx512, four(design + 4, 0), four(design + 4, 1))];
    Lanes(first.combine(second))
}

#[inline(always)]
fn eight(avx512: Avx512, first: [f32; 4], second: [f32; 4]) -> f32x8<Avx512> {
    f32x4::simd_from(avx512, first).combine(f32x4::simd_from(avx512, second))
}

kernel!(
    /// Rows to columns, within each four lanes.
    #[inline(always)]
    fn in_quarters(avx512: Avx512, rows: [Register; 4]) -> [Register; 4] {
        let [a, c, b, d] = zip_rows(avx512, rows);
        let (a, b): (__m512, __m512) = (a.0.into(), b.0.into());
        let (c, d): (__m512, __m512) = (c.0.into(), d.0.into());
        let (a, b, c, d) = (_mm512_castps_pd(a), _mm512_castps_pd(b), _mm512_castps_pd(c), _mm512_castps_pd(d));
        [
            Lanes(_mm512_castpd_ps(_mm512_unpacklo_pd(a, c)).simd_into(avx512)),
            Lanes(_mm512_castpd_ps(_mm512_unpackhi_pd(a, c)).simd_into(avx512)),
            Lanes(_mm512_castpd_ps(_mm512_unpacklo_pd(b, d)).simd_into(avx512)),
            Lanes(_mm512_castpd_ps(_mm512_unpackhi_pd(b, d)).simd_into(avx512)),
        ]
    }
);

kernel!(
    /// The first and the third four lanes of each two registers, then the second and the fourth.
    #[inline(always)]
    fn across_quarters(avx512: Avx512, low: [Register; 4], high: [Register; 4]) -> [Register; 8] {
        let ([a, b, c, d], [e, f, g, h]) = (low, high);
        let (a, b, c, d): (__m512, __m512, __m512, __m512) = (a.0.into(), b.0.into(), c.0.into(), d.0.into());
        let (e, f, g, h): (__m512, __m512, __m512, __m512) = (e.0.into(), f.0.into(), g.0.into(), h.0.into());
        [
            Lanes(_mm512_shuffle_f32x4::<0x88>(a, e).simd_into(avx512)),
            Lanes(_mm512_shuffle_f32x4::<0x88>(b, f).simd_into(avx512)),
            Lanes(_mm512_shuffle_f32x4::<0x88>(c, g).simd_into(avx512)),
            Lanes(_mm512_shuffle_f32x4::<0x88>(d, h).simd_into(avx512)),
            Lanes(_mm512_shuffle_f32x4::<0xdd>(a, e).simd_into(avx512)),
            Lanes(_mm512_shuffle_f32x4::<0xdd>(b, f).simd_into(avx512)),
            Lanes(_mm512_shuffle_f32x4::<0xdd>(c, g).simd_into(avx512)),
            Lanes(_mm512_shuffle_f32x4::<0xdd>(d, h).simd_into(avx512)),
        ]
    }
);

kernel!(
    /// The first halves of each four lanes of two registers, one number of each in turn, and the others; of the first two and
    /// of the last two registers.
    #[inline(always)]
    fn zip_rows(avx512: Avx512, rows: [Register; 4]) -> [Register; 4] {
        let [a, b, c, d] = rows;
        let (a, b, c, d): (__m512, __m512, __m512, __m512) = (a.0.into(), b.0.into(), c.0.into(), d.0.into());
        [
            Lanes(_mm512_unpacklo_ps(a, b).simd_into(avx512)),
            Lanes(_mm512_unpacklo_ps(c, d).simd_into(avx512)),
            Lanes(_mm512_unpackhi_ps(a, b).simd_into(avx512)),
            Lanes(_mm512_unpackhi_ps(c, d).simd_into(avx512)),
        ]
    }
);

/// Which pairs of lanes the first of two matrices takes, and which the second one.
const FIRST_AND_SECOND: [u8; 2] = [0b0011_0011, 0b1100_1100];

/// Writes the matrices of one design after the other: those that are there, and zeros.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn write(
    matrices: &[[[Register; 2]; 2]; 8],
    are_there: [bool; 8],
    states: [States; 2],
    coefficients: &mut [Coefficients<f32, 2>; 16],
) {
    let avx512 = matrices[0][0][0].0.token();
    // Where the compiler knows that half of a register is zero, it writes that half for itself.
    let masks = black_box(FIRST_AND_SECOND);
    let mut zipped = [[Lanes::splat(avx512, 0.0); 4]; 8];
    for ((zipped, [[a, b], [c, d]]), is_there) in zipped.iter_mut().zip(matrices).zip(are_there) {
        if is_there {
            // By columns, as matrices lie in memory.
            *zipped = zip_rows(avx512, [*a, *c, *b, *d]);
        }
    }
    let [first, second, third, fourth] = coefficients.as_chunks_mut().0 else { return };
    // One after the other, not in a loop: what is in a lane is only known where the lane is.
    write_four(&zipped, masks, are_there, states, 0, first);
    write_four(&zipped, masks, are_there, states, 1, second);
    write_four(&zipped, masks, are_there, states, 2, third);
    write_four(&zipped, masks, are_there, states, 3, fourth);
}

/// Writes the matrices of the designs in four lanes.
#[inline(always)]
fn write_four(
    zipped: &[[Register; 4]; 8],
    masks: [u8; 2],
    are_there: [bool; 8],
    states: [States; 2],
    quarter: usize,
    coefficients: &mut [Coefficients<f32, 2>; 4],
) {
    let avx512 = zipped[0][0].0.token();
    let [a, b, c, d] = coefficients;
    for (two, half) in [[a, b], [c, d]].into_iter().zip([0, 2]) {
        let mut pairs = [Lanes::splat(avx512, 0.0); 4];
        for (index, pair) in pairs.iter_mut().enumerate() {
            let [first, second] = [2 * index, 2 * index + 1];
            let first = are_there[first].then_some([zipped[first][half], zipped[first][half + 1]]);
            let second = are_there[second].then_some([zipped[second][half], zipped[second][half + 1]]);
            *pair = match (first, second) {
                (Some(first), Some(second)) => both(avx512, first, second, quarter, masks),
                (Some(first), None) => of_two_designs(avx512, first, quarter, masks[0]),
                (None, Some(second)) => of_two_designs(avx512, second, quarter, masks[1]),
                (None, None) => *pair,
            };
        }
        for (of_one, coefficients) in two.into_iter().enumerate() {
            let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, states: of_all } = coefficients;
            for ([first, second], pair) in [[m, cm1], [c0, c1], [kc, k0], [k1, k2]].into_iter().zip(&pairs) {
                let numbers = &pair.numbers()[8 * of_one..][..8];
                first.as_mut_slice().copy_from_slice(&numbers[..4]);
                second.as_mut_slice().copy_from_slice(&numbers[4..]);
                // Two matrices make one write, which takes no shuffle. Four would take one, and cross a line of the cache each time.
                compiler_fence(Ordering::SeqCst);
            }
            *of_all = states;
        }
    }
}

#[inline(always)]
fn both(avx512: Avx512, first: [Register; 2], second: [Register; 2], quarter: usize, masks: [u8; 2]) -> Register {
    let [first, second] =
        [of_two_designs(avx512, first, quarter, masks[0]), of_two_designs(avx512, second, quarter, masks[1])];
    let (first, second): (u32x16<Avx512>, u32x16<Avx512>) = (first.0.bitcast(), second.0.bitcast());
    Lanes((first | second).bitcast())
}

kernel!(
    /// The first or the last two designs of four, whose numbers are zipped: at the places that the mask has, and zeros at the others.
    #[inline(always)]
    fn of_two_designs(avx512: Avx512, zipped: [Register; 2], quarter: usize, mask: u8) -> Register {
        let (a, b): (__m512, __m512) = (zipped[0].0.into(), zipped[1].0.into());
        let places = match quarter {
            0 => _mm512_setr_epi64(0, 8, 0, 8, 1, 9, 1, 9),
            1 => _mm512_setr_epi64(2, 10, 2, 10, 3, 11, 3, 11),
            2 => _mm512_setr_epi64(4, 12, 4, 12, 5, 13, 5, 13),
            _ => _mm512_setr_epi64(6, 14, 6, 14, 7, 15, 7, 15),
        };
        let numbers = _mm512_maskz_permutex2var_pd(mask, _mm512_castps_pd(a), places, _mm512_castps_pd(b));
        Lanes(_mm512_castpd_ps(numbers).simd_into(avx512))
    }
);
