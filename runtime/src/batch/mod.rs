//! Many designs at once: one in each lane of the processor's registers.
//!
//! A [`Batch`] runs the same straight-line code as a single design, in as many lanes as the processor has, which is found
//! out when the program runs: 2 lanes at the baseline of x86-64 (SSE2), of ARM (NEON) and of WebAssembly, 4 with AVX2, 8
//! with AVX-512, and twice as many of `f32`. Every lane computes what the scalar evaluator computes, to the last bit, at every level: no multiplication
//! is fused with an addition, and sine and cosine are the same code.

#[cfg(feature = "std")]
mod blocks;
#[cfg(feature = "std")]
mod derivatives;
mod eigenvalues;
mod error;
mod lanes;
mod matrices;
#[cfg(feature = "std")]
mod motion;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod sixteen;
#[cfg(feature = "std")]
mod stability;
mod structs;
#[cfg(feature = "std")]
mod systems;
mod transpose;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod wide;

use core::fmt;

use fearless_simd::{Level, SimdBase, dispatch};

#[cfg(feature = "std")]
pub use blocks::Blocks;
#[cfg(feature = "std")]
pub use derivatives::Portion;
pub use eigenvalues::Eigenvalues;
pub use error::BatchError;
pub use lanes::{InLanes, Lanes};
#[cfg(feature = "std")]
pub use motion::{Arrival, Ensemble, Limit, Outcome};

/// The number of designs in a block: as many as the widest registers hold, which have 64 bytes.
const fn side<T>() -> usize {
    64 / size_of::<T>()
}

/// How many designs are computed side by side, and by which instructions.
#[derive(Clone, Copy, Debug)]
pub struct Batch {
    level: Level,
}

impl Batch {
    /// With the widest lanes that the processor has.
    ///
    /// Without feature `std` processors are not asked: then it is what the target is compiled for.
    #[must_use]
    pub fn new() -> Self {
        Self { level: Level::try_detect().unwrap_or(Level::baseline()) }
    }

    /// Every level that the processor has, from the baseline of the target up. All of them give the same results.
    pub fn levels() -> impl Iterator<Item = Self> {
        let widest = Self::new().level;
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        let narrower = [
            widest.as_sse2().map(Level::Sse2),
            widest.as_sse4_2().map(Level::Sse4_2),
            widest.as_avx2().map(Level::Avx2),
            widest.as_avx512().map(Level::Avx512),
        ];
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        let narrower = [Some(widest)];
        narrower.into_iter().flatten().map(|level| Self { level })
    }

    /// How many designs are computed side by side in `f64`; twice as many are in `f32`.
    #[must_use]
    pub fn lanes(&self) -> usize {
        fn count<S: fearless_simd::Simd>(_: S) -> usize {
            S::f64s::LEN
        }
        dispatch!(self.level, simd => count(simd))
    }
}

impl Default for Batch {
    fn default() -> Self {
        Self::new()
    }
}

/// Reads `AVX2, 4 lanes`.
impl fmt::Display for Batch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = match self.level {
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Sse2(_) => "SSE2",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Sse4_2(_) => "SSE4.2",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Avx2(_) => "AVX2",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Avx512(_) => "AVX-512",
            #[cfg(target_arch = "aarch64")]
            Level::Neon(_) => "NEON",
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            Level::WasmSimd128(_) => "SIMD128",
            _ => "no registers of several numbers",
        };
        write!(f, "{name}, {} lanes", self.lanes())
    }
}
