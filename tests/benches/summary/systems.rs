//! Random systems of any number of coordinates.

use carvallo::System;
use nalgebra::SMatrix;

/// Stable systems with full matrices of a few decades: `L L^T` of random L, for M, C and K.
pub fn random<const N: usize>(count: u64) -> Vec<System<N>> {
    let mut state = 1899_u64;
    let mut draw = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let mut positive = |scale: f64| {
        let l = SMatrix::<f64, N, N>::from_fn(|_, _| draw());
        l * l.transpose() * scale + SMatrix::identity() * (0.1 * scale)
    };
    (0..count).map(|_| System::new(positive(1.0), positive(2.0), positive(50.0))).collect()
}
