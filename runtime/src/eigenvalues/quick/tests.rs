use nalgebra::Complex;

use super::of_system;
use crate::system::{Matrix, System};

/// Random systems, stable ones and any, of which most are certain; and then as near to what the QR algorithm has as both are to
/// what is right.
fn check<const N: usize>(certain_at_least: usize) {
    const SYSTEMS: usize = 100;
    let mut state = 1899_u64;
    let mut draw = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let mut certain = 0;
    for number in 0..SYSTEMS {
        let mut matrix = || Matrix::<f64, N>::from_fn(|_, _| draw());
        let (l, c, k) = (matrix(), matrix(), matrix());
        let one = Matrix::<f64, N>::identity();
        let m = l * l.transpose() + one * 0.3;
        let system = if number % 2 == 0 {
            System::new(m, c * c.transpose() + one * 0.1, (k * k.transpose() + one * 0.1) * 20.0)
        } else {
            System::new(m, c, k * 10.0)
        };
        let Some(found) = of_system(N, [system.m.as_slice(), system.c.as_slice(), system.k.as_slice()]) else {
            continue;
        };
        certain += 1;
        let expected = system.careful_eigenvalues().expect("eigenvalues");
        let largest = expected.iter().map(|value| value.norm()).fold(0.0, f64::max);
        for value in &found {
            let distance = |other: &Complex<f64>| (other - value).norm();
            let nearest = expected.iter().map(distance).fold(f64::MAX, f64::min);
            assert!(nearest < 1e-9 * largest, "{value} of number {number} is off by {nearest:e}: {expected:?}");
        }
        assert!(found.iter().all(|value| found.contains(&value.conj())), "{found:?}");
        assert!(found.is_sorted_by(|x, y| (x.re, x.im) <= (y.re, y.im)), "{found:?}");
    }
    assert!(certain >= certain_at_least, "{certain} of {SYSTEMS} of {N} coordinates are certain");
}

#[test]
fn most_systems_are_certain_and_agree_with_the_qr_algorithm() {
    check::<3>(99);
    check::<4>(99);
    check::<6>(98);
    check::<8>(98);
}

/// A mass matrix that is not symmetric or not positive, eigenvalues that coincide, and what is no number.
#[test]
fn what_is_not_certain_is_left_to_others() {
    let one = Matrix::<f64, 3>::identity();
    let (c, k) = (one * 0.2, Matrix::<f64, 3>::new(3.0, 1.0, 0.0, 1.0, 5.0, 1.0, 0.0, 1.0, 9.0));
    let is_certain = |m: Matrix<f64, 3>, c: Matrix<f64, 3>, k: Matrix<f64, 3>| {
        of_system(3, [m.as_slice(), c.as_slice(), k.as_slice()]).is_some()
    };
    assert!(is_certain(one, c, k));
    let mut skew = one;
    skew[(0, 1)] = 0.1;
    for m in [skew, -one, one * 0.0, one * f64::NAN, one * f64::INFINITY] {
        assert!(!is_certain(m, c, k), "{m}");
    }
    assert!(!is_certain(one, c, one) && !is_certain(one, c * 0.0, k) && !is_certain(one, c, k * f64::NAN));
}
