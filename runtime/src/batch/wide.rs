//! Rows to columns within each four lanes, by the instructions of AVX2 and AVX-512.

#[cfg(target_arch = "x86")]
use core::arch::x86::*;
#[cfg(target_arch = "x86_64")]
use core::arch::x86_64::*;

use fearless_simd::prelude::*;
use fearless_simd::{Avx2, Avx512, Simd, f32x8, f32x16, f64x4, f64x8, kernel};

use super::Lanes;

/// A function of four registers, `$a` to `$d`, of a level whose instructions it names.
macro_rules! fours {
    ($name:ident, $level:ident, $number:ident, $register:ident, |$a:ident, $b:ident, $c:ident, $d:ident| $body:expr) => {
        #[inline(always)]
        pub fn $name<S: Simd>(level: $level, [a, b, c, d]: [Lanes<S, $number>; 4]) -> [Lanes<S, $number>; 4] {
            kernel!(
                #[inline(always)]
                fn transposed(
                    level: $level,
                    a: $register<$level>,
                    b: $register<$level>,
                    c: $register<$level>,
                    d: $register<$level>,
                ) -> [$register<$level>; 4] {
                    let ($a, $b, $c, $d) = (a.into(), b.into(), c.into(), d.into());
                    let [a, b, c, d] = $body;
                    [a.simd_into(level), b.simd_into(level), c.simd_into(level), d.simd_into(level)]
                }
            );
            let simd = a.0.token();
            // The same registers, once of a level that is generic.
            let [a, b, c, d] = transposed(
                level,
                $register::from_slice(level, a.numbers()),
                $register::from_slice(level, b.numbers()),
                $register::from_slice(level, c.numbers()),
                $register::from_slice(level, d.numbers()),
            );
            [
                Lanes::load(simd, a.as_slice()),
                Lanes::load(simd, b.as_slice()),
                Lanes::load(simd, c.as_slice()),
                Lanes::load(simd, d.as_slice()),
            ]
        }
    };
}

fours!(transpose_eight_f32, Avx2, f32, f32x8, |a, b, c, d| {
    let (e, f) = (_mm256_unpacklo_ps(a, c), _mm256_unpackhi_ps(a, c));
    let (g, h) = (_mm256_unpacklo_ps(b, d), _mm256_unpackhi_ps(b, d));
    [_mm256_unpacklo_ps(e, g), _mm256_unpackhi_ps(e, g), _mm256_unpacklo_ps(f, h), _mm256_unpackhi_ps(f, h)]
});

fours!(transpose_sixteen_f32, Avx512, f32, f32x16, |a, b, c, d| {
    let low = _mm512_setr_epi32(0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
    let high = _mm512_setr_epi32(2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
    let (e, f) = (_mm512_permutex2var_ps(a, low, c), _mm512_permutex2var_ps(a, high, c));
    let (g, h) = (_mm512_permutex2var_ps(b, low, d), _mm512_permutex2var_ps(b, high, d));
    [
        _mm512_permutex2var_ps(e, low, g),
        _mm512_permutex2var_ps(e, high, g),
        _mm512_permutex2var_ps(f, low, h),
        _mm512_permutex2var_ps(f, high, h),
    ]
});

fours!(transpose_four_f64, Avx2, f64, f64x4, |a, b, c, d| {
    let (e, f) = (_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b));
    let (g, h) = (_mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d));
    [
        _mm256_permute2f128_pd::<0x20>(e, g),
        _mm256_permute2f128_pd::<0x20>(f, h),
        _mm256_permute2f128_pd::<0x31>(e, g),
        _mm256_permute2f128_pd::<0x31>(f, h),
    ]
});

fours!(transpose_eight_f64, Avx512, f64, f64x8, |a, b, c, d| {
    let (low, high) = (_mm512_setr_epi64(0, 8, 1, 9, 4, 12, 5, 13), _mm512_setr_epi64(2, 10, 3, 11, 6, 14, 7, 15));
    let (e, f) = (_mm512_permutex2var_pd(a, low, c), _mm512_permutex2var_pd(a, high, c));
    let (g, h) = (_mm512_permutex2var_pd(b, low, d), _mm512_permutex2var_pd(b, high, d));
    [
        _mm512_permutex2var_pd(e, low, g),
        _mm512_permutex2var_pd(e, high, g),
        _mm512_permutex2var_pd(f, low, h),
        _mm512_permutex2var_pd(f, high, h),
    ]
});
