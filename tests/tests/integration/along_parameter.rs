//! Critical values of a parameter of random systems, all matrices of which depend on it, against a scan of the eigenvalues by
//! nalgebra.

use carvallo::nalgebra::{DMatrix, SMatrix, Schur};
use carvallo::{Change, CriticalKind, ParameterStability, System, SystemError, Verdict};

/// The values at which eigenvalues are computed, at the least.
const VALUES: usize = 600;

struct Random(u64);

impl Random {
    /// Between -1 and 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn matrix<const N: usize>(&mut self) -> SMatrix<f64, N, N> {
        SMatrix::from_fn(|_, _| self.next())
    }

    fn positive<const N: usize>(&mut self) -> SMatrix<f64, N, N> {
        let factor: SMatrix<f64, N, N> = self.matrix();
        factor * factor.transpose() + SMatrix::identity() * 0.3
    }
}

/// How many eigenvalues are unstable; none where one is so near to the axis that its digits do not tell.
fn count<const N: usize>([m, c, k]: [SMatrix<f64, N, N>; 3]) -> Option<usize> {
    let inverse = m.try_inverse().expect("a regular mass matrix");
    let (damping, stiffness) = (inverse * c, inverse * k);
    let state = DMatrix::from_fn(2 * N, 2 * N, |i, j| match (i < N, j < N) {
        (true, _) => f64::from(u8::from(j == i + N)),
        (false, true) => -stiffness[(i - N, j)],
        (false, false) => -damping[(i - N, j - N)],
    });
    let norm = state.norm();
    // Without a bound its iteration may not end.
    let eigenvalues = Schur::try_new(state, f64::EPSILON, 10_000)?.complex_eigenvalues();
    let is_clear = eigenvalues.iter().all(|value| value.re.abs() > 1e-10 * norm);
    is_clear.then(|| eigenvalues.iter().filter(|value| value.re > 0.0).count())
}

/// Damped structures under loads that follow, with gyroscopes, and masses that grow; the functions of the parameter are
/// polynomials, or sine and cosine.
fn check<const N: usize>(seed: u64, is_polynomial: bool) -> usize {
    let mut random = Random(seed);
    let (m0, m1): (SMatrix<f64, N, N>, _) = (random.positive(), random.positive());
    let (c0, c1) = (random.positive() * 0.4, random.matrix() * 0.5);
    let (k0, k1, k2) = (random.positive() * 3.0, random.matrix() * 2.0, random.matrix());
    let matrices = |p: f64| {
        let (linear, square) = if is_polynomial { (p, p * p) } else { (p.sin(), 1.0 - p.cos()) };
        [m0 + m1 * square, c0 + c1 * linear, k0 + k1 * linear + k2 * square]
    };
    let range = [-1.5, 2.5];
    let system = |p: f64| {
        let [m, c, k] = matrices(p);
        Ok::<_, SystemError>(System::new(m, c, k))
    };
    let found = ParameterStability::new(range, system).expect("an answer");
    let name = format!("{N} coordinates, seed {seed}");
    assert!(found.undecided.is_empty(), "{name}: {:?}", found.undecided);
    let mut last: Option<(f64, usize)> = None;
    for step in 0..=VALUES {
        let p = range[0] + (range[1] - range[0]) * step as f64 / VALUES as f64;
        let Some(unstable) = count(matrices(p)) else { continue };
        let verdict = if unstable == 0 { Verdict::Stable } else { Verdict::Unstable };
        assert_eq!(found.verdict(p), Some(verdict), "{name} at {p}");
        if let Some((from, before)) = last {
            let between = found.critical_values.iter().filter(|critical| critical.value > from && critical.value <= p);
            let gain: isize = between
                .map(|critical| {
                    let size = if critical.kind == CriticalKind::Capsize { 1 } else { 2 };
                    match critical.change {
                        Change::Destabilizes => size,
                        Change::Stabilizes => -size,
                        _ => 0,
                    }
                })
                .sum();
            assert_eq!(unstable as isize - before as isize, gain, "{name} between {from} and {p}");
        }
        last = Some((p, unstable));
    }
    for critical in &found.critical_values {
        // On the axis: the smallest singular value of the pencil there, beside the norms of its terms.
        let [m, c, k] = matrices(critical.value);
        let s = critical.eigenvalue;
        let norm = m.norm() * s.norm_sqr() + c.norm() * s.norm() + k0.norm() + k1.norm() + k2.norm();
        let complex = |matrix: SMatrix<f64, N, N>| DMatrix::from_fn(N, N, |i, j| s * 0.0 + matrix[(i, j)]);
        let pencil = complex(m) * (s * s) + complex(c) * s + complex(k);
        let least = pencil.singular_values().min();
        assert!(least <= 1e-12 * norm, "{name}: {critical:?} is off by {least:e} of {norm:e}");
    }
    found.critical_values.len()
}

#[test]
fn critical_values_are_those_of_a_scan() {
    let mut critical = 0;
    for seed in 0..3 {
        for is_polynomial in [true, false] {
            critical += check::<1>(seed, is_polynomial);
            critical += check::<2>(seed, is_polynomial);
            critical += check::<3>(seed, is_polynomial);
            critical += check::<4>(seed, is_polynomial);
            critical += check::<5>(seed, is_polynomial);
        }
    }
    assert!(critical > 60, "{critical}");
}
