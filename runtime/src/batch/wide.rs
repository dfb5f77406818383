//! Numbers into lanes, and rows to columns within each four lanes, by the instructions of AVX2 and AVX-512.

use core::any::Any;
#[cfg(target_arch = "x86")]
use core::arch::x86::*;
#[cfg(target_arch = "x86_64")]
use core::arch::x86_64::*;

use fearless_simd::prelude::*;
use fearless_simd::{Avx2, Avx512, Simd, f32x4, f32x8, f64x2, f64x4, kernel};

use super::Lanes;

/// Registers of a level that is generic, if it is this one.
///
/// They stay registers. On a way through slices the compiler may take their numbers one by one.
#[inline(always)]
pub fn same<A: 'static, B: Copy + 'static>(registers: A) -> Option<B> {
    (&registers as &dyn Any).downcast_ref().copied()
}

kernel!(
    #[inline(always)]
    pub fn transpose_eight_f32(avx2: Avx2, rows: [Lanes<Avx2, f32>; 4]) -> [Lanes<Avx2, f32>; 4] {
        let [a, b, c, d] = rows;
        let (a, b, c, d): (__m256, __m256, __m256, __m256) = (a.0.into(), b.0.into(), c.0.into(), d.0.into());
        let (e, f) = (_mm256_shuffle_ps::<0x88>(a, b), _mm256_shuffle_ps::<0xdd>(a, b));
        let (g, h) = (_mm256_shuffle_ps::<0x88>(c, d), _mm256_shuffle_ps::<0xdd>(c, d));
        let [e, f, g, h] = [
            _mm256_shuffle_ps::<0x88>(e, g),
            _mm256_shuffle_ps::<0x88>(f, h),
            _mm256_shuffle_ps::<0xdd>(e, g),
            _mm256_shuffle_ps::<0xdd>(f, h),
        ];
        [Lanes(e.simd_into(avx2)), Lanes(f.simd_into(avx2)), Lanes(g.simd_into(avx2)), Lanes(h.simd_into(avx2))]
    }
);

kernel!(
    #[inline(always)]
    pub fn transpose_sixteen_f32(avx512: Avx512, rows: [Lanes<Avx512, f32>; 4]) -> [Lanes<Avx512, f32>; 4] {
        let [a, b, c, d] = rows;
        let (a, b, c, d): (__m512, __m512, __m512, __m512) = (a.0.into(), b.0.into(), c.0.into(), d.0.into());
        let low = _mm512_setr_epi32(0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
        let high = _mm512_setr_epi32(2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
        let (e, f) = (_mm512_permutex2var_ps(a, low, c), _mm512_permutex2var_ps(a, high, c));
        let (g, h) = (_mm512_permutex2var_ps(b, low, d), _mm512_permutex2var_ps(b, high, d));
        let [e, f, g, h] = [
            _mm512_permutex2var_ps(e, low, g),
            _mm512_permutex2var_ps(e, high, g),
            _mm512_permutex2var_ps(f, low, h),
            _mm512_permutex2var_ps(f, high, h),
        ];
        [Lanes(e.simd_into(avx512)), Lanes(f.simd_into(avx512)), Lanes(g.simd_into(avx512)), Lanes(h.simd_into(avx512))]
    }
);

kernel!(
    #[inline(always)]
    pub fn transpose_four_f64(avx2: Avx2, rows: [Lanes<Avx2>; 4]) -> [Lanes<Avx2>; 4] {
        let [a, b, c, d] = rows;
        let (a, b, c, d): (__m256d, __m256d, __m256d, __m256d) = (a.0.into(), b.0.into(), c.0.into(), d.0.into());
        let (e, f) = (_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b));
        let (g, h) = (_mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d));
        let [e, f, g, h] = [
            _mm256_permute2f128_pd::<0x20>(e, g),
            _mm256_permute2f128_pd::<0x20>(f, h),
            _mm256_permute2f128_pd::<0x31>(e, g),
            _mm256_permute2f128_pd::<0x31>(f, h),
        ];
        [Lanes(e.simd_into(avx2)), Lanes(f.simd_into(avx2)), Lanes(g.simd_into(avx2)), Lanes(h.simd_into(avx2))]
    }
);

kernel!(
    #[inline(always)]
    pub fn transpose_eight_f64(avx512: Avx512, rows: [Lanes<Avx512>; 4]) -> [Lanes<Avx512>; 4] {
        let [a, b, c, d] = rows;
        let (a, b, c, d): (__m512d, __m512d, __m512d, __m512d) = (a.0.into(), b.0.into(), c.0.into(), d.0.into());
        let (low, high) = (_mm512_setr_epi64(0, 8, 1, 9, 4, 12, 5, 13), _mm512_setr_epi64(2, 10, 3, 11, 6, 14, 7, 15));
        let (e, f) = (_mm512_permutex2var_pd(a, low, c), _mm512_permutex2var_pd(a, high, c));
        let (g, h) = (_mm512_permutex2var_pd(b, low, d), _mm512_permutex2var_pd(b, high, d));
        let [e, f, g, h] = [
            _mm512_permutex2var_pd(e, low, g),
            _mm512_permutex2var_pd(e, high, g),
            _mm512_permutex2var_pd(f, low, h),
            _mm512_permutex2var_pd(f, high, h),
        ];
        [Lanes(e.simd_into(avx512)), Lanes(f.simd_into(avx512)), Lanes(g.simd_into(avx512)), Lanes(h.simd_into(avx512))]
    }
);

// Registers are filled from memory by parts of 16 bytes and more, which then no shuffle has to bring across them.

#[inline(always)]
pub fn side_by_side_eight_f32(avx2: Avx2, four: impl Fn(usize) -> [f32; 4] + Copy) -> [Lanes<Avx2, f32>; 4] {
    transpose_eight_f32(
        avx2,
        [
            Lanes(beside_f32(avx2, four(0), four(4))),
            Lanes(beside_f32(avx2, four(1), four(5))),
            Lanes(beside_f32(avx2, four(2), four(6))),
            Lanes(beside_f32(avx2, four(3), four(7))),
        ],
    )
}

#[inline(always)]
pub fn side_by_side_four_f64(avx2: Avx2, four: impl Fn(usize) -> [f64; 4] + Copy) -> [Lanes<Avx2>; 4] {
    let [[a, b, c, d], [e, f, g, h], [i, j, k, l], [m, n, o, p]] = [four(0), four(1), four(2), four(3)];
    zip_pairs_f64(
        avx2,
        [
            Lanes(beside_f64(avx2, [a, b], [i, j])),
            Lanes(beside_f64(avx2, [e, f], [m, n])),
            Lanes(beside_f64(avx2, [c, d], [k, l])),
            Lanes(beside_f64(avx2, [g, h], [o, p])),
        ],
    )
}

kernel!(
    #[inline(always)]
    fn zip_pairs_f64(avx2: Avx2, rows: [Lanes<Avx2>; 4]) -> [Lanes<Avx2>; 4] {
        let [a, b, c, d] = rows;
        let (a, b, c, d): (__m256d, __m256d, __m256d, __m256d) = (a.0.into(), b.0.into(), c.0.into(), d.0.into());
        let [e, f, g, h] =
            [_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b), _mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d)];
        [Lanes(e.simd_into(avx2)), Lanes(f.simd_into(avx2)), Lanes(g.simd_into(avx2)), Lanes(h.simd_into(avx2))]
    }
);

#[inline(always)]
pub fn side_by_side_eight_f64(avx512: Avx512, four: impl Fn(usize) -> [f64; 4] + Copy) -> [Lanes<Avx512>; 4] {
    transpose_eight_f64(
        avx512,
        [
            Lanes(f64x4::simd_from(avx512, four(0)).combine(f64x4::simd_from(avx512, four(4)))),
            Lanes(f64x4::simd_from(avx512, four(1)).combine(f64x4::simd_from(avx512, four(5)))),
            Lanes(f64x4::simd_from(avx512, four(2)).combine(f64x4::simd_from(avx512, four(6)))),
            Lanes(f64x4::simd_from(avx512, four(3)).combine(f64x4::simd_from(avx512, four(7)))),
        ],
    )
}

#[inline(always)]
fn beside_f32<S: Simd>(simd: S, a: [f32; 4], b: [f32; 4]) -> f32x8<S> {
    f32x4::simd_from(simd, a).combine(f32x4::simd_from(simd, b))
}

#[inline(always)]
fn beside_f64<S: Simd>(simd: S, a: [f64; 2], b: [f64; 2]) -> f64x4<S> {
    f64x2::simd_from(simd, a).combine(f64x2::simd_from(simd, b))
}
