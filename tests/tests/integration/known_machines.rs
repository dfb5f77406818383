//! Critical speeds of machines other than bicycles, against closed forms, print, and what others computed.

use std::f64::consts::PI;

use carvallo::{Change, Coefficients, CriticalKind, CriticalSpeed, Matrix, Stability, States};

fn assert_near(found: f64, expected: f64, accuracy: f64) {
    assert!((found - expected).abs() <= accuracy * expected, "{found} where {expected} is expected");
}

fn speeds<const N: usize>(coefficients: &Coefficients<f64, N>) -> Vec<CriticalSpeed> {
    let stability = Stability::new(coefficients, 0.0).expect("an answer");
    assert!(stability.undecided.is_empty(), "{stability:?}");
    stability.critical_speeds
}

/// The root of cos x cosh x = -1 of a mode of the cantilever.
fn cantilever(mode: usize) -> f64 {
    let mut x = (mode as f64 + 0.5) * PI + if mode == 0 { 0.3 } else { 0.0 };
    for _ in 0..20 {
        x -= (x.cos() + 1.0 / x.cosh()) / (-x.sin() - x.tanh() / x.cosh());
    }
    x
}

/// A cantilevered pipe that carries a fluid, in its first modes, without damping and gravity: `q'' + 2 sqrt(beta) u B q' +
/// (diag(lambda^4) + u^2 D) q = 0` with B and D in closed form (Gregory & Paidoussis 1966).
fn pipe<const N: usize>(beta: f64) -> Coefficients<f64, N> {
    let lambda: [f64; N] = std::array::from_fn(cantilever);
    let sigma = lambda.map(|x| (x.sinh() - x.sin()) / (x.cosh() + x.cos()));
    let sign = |i: usize, j: usize| if (i + j).is_multiple_of(2) { 1.0 } else { -1.0 };
    let ratio = |i: usize, j: usize| (lambda[i] / lambda[j]).powi(2);
    let product = |i: usize| lambda[i] * sigma[i];
    let b = Matrix::<f64, N>::from_fn(|i, j| if i == j { 2.0 } else { 4.0 / (ratio(i, j) + sign(i, j)) });
    let d = Matrix::<f64, N>::from_fn(|i, j| match i == j {
        true => product(i) * (2.0 - product(i)),
        false => 4.0 * (product(j) - product(i)) / (sign(i, j) - ratio(i, j)),
    });
    Coefficients {
        m: Matrix::identity(),
        c1: b * (2.0 * beta.sqrt()),
        kc: Matrix::from_diagonal(&lambda.map(|x| x.powi(4)).into()),
        k2: d,
        ..Default::default()
    }
}

/// Up to the last listed one these are all speeds at which stability is lost or won; they were found by a search along the
/// speed with the eigenvalues of NumPy, which for six and more modes have fewer digits.
fn check_pipe<const N: usize>(beta: f64, expected: &[f64], accuracy: f64) {
    let stability = Stability::new(&pipe::<N>(beta), 0.0).expect("an answer");
    assert!(stability.undecided.is_empty());
    let ends = stability.stable_ranges.iter().flat_map(|range| [Some(range.from).filter(|&from| from > 0.0), range.to]);
    let ends: Vec<f64> = ends.flatten().collect();
    assert_eq!(ends.len(), expected.len(), "{N} modes, {beta}: {ends:?}");
    ends.into_iter().zip(expected).for_each(|(found, &expected)| assert_near(found, expected, accuracy));
}

/// For a share of 0.69 Paidoussis has three thresholds, the pipe being stable once more "from about 11 to about 12.8"
/// (Fluid-Structure Interactions, volume 1, page 114).
#[test]
fn a_pipe_that_carries_a_fluid_flutters() {
    check_pipe::<2>(0.5, &[8.24857489880456], 1e-12);
    check_pipe::<3>(0.1, &[4.759311489246753], 1e-12);
    check_pipe::<3>(0.7, &[10.622283531286197], 1e-12);
    check_pipe::<4>(0.2, &[5.601242272279362], 1e-12);
    check_pipe::<4>(0.7, &[11.168655744616325, 12.941988279599054, 13.363160607273462], 1e-11);
    check_pipe::<6>(0.69, &[10.948378530522229, 11.433777619799853, 12.778005059175808], 1e-8);
    check_pipe::<8>(0.69, &[10.934089516710383, 11.438152704503482, 12.71074781324639], 1e-8);
    check_pipe::<10>(0.69, &[10.931066075917807, 11.439123970611265, 12.697859827571685], 1e-7);
    check_pipe::<10>(0.1, &[4.749980678598311], 1e-8);
}

/// An elastically restrained wheelset with linear creep: C-1 (Wickens 2003, Fundamentals of Rail Vehicle Dynamics).
#[test]
fn a_wheelset_hunts() {
    let (m, i, f11, f22) = (1250.0, 700.0, 1e7, 1e7);
    let (b, conicity, r, ky, kpsi) = (0.7, 0.15, 0.45, 2e5, 2e5);
    let (d1, d2, steering) = (2.0 * f22, 2.0 * f11 * b * b, 2.0 * f11 * b * conicity / r);
    let wheelset = Coefficients {
        m: Matrix::<f64, 2>::new(m, 0.0, 0.0, i),
        cm1: Matrix::<f64, 2>::new(d1, 0.0, 0.0, d2),
        kc: Matrix::<f64, 2>::new(ky, -d1, steering, kpsi),
        ..Default::default()
    };
    let (a1, a3, a0) = (d1 * kpsi + d2 * ky, m * d2 + i * d1, ky * kpsi + d1 * steering);
    let square = a1 * a3 * d1 * d2 / (a3 * a3 * a0 + m * i * a1 * a1 - a1 * a3 * (m * kpsi + i * ky));
    let [hunting] = speeds(&wheelset)[..] else { panic!("one critical speed") };
    assert_eq!((hunting.kind, hunting.change), (CriticalKind::Weave, Change::Destabilizes));
    assert_near(hunting.speed, square.sqrt(), 1e-13);
    assert_near(hunting.eigenvalue.im, (a1 / a3).sqrt(), 1e-13);
}

/// A single-track car whose lateral and yaw motion matter by their rates: C-1 and C1. It oversteers.
#[test]
fn a_car_that_oversteers_diverges() {
    let (m, i, a, b, cf, cr) = (1400.0, 2420.0, 1.14, 1.33, 25000.0, 21000.0);
    let car = Coefficients {
        m: Matrix::<f64, 2>::new(m, 0.0, 0.0, i),
        cm1: Matrix::<f64, 2>::new(cf + cr, a * cf - b * cr, a * cf - b * cr, a * a * cf + b * b * cr),
        c1: Matrix::<f64, 2>::new(0.0, m, 0.0, 0.0),
        states: [States::Rate; 2],
        ..Default::default()
    };
    let [divergence] = speeds(&car)[..] else { panic!("one critical speed") };
    let l: f64 = a + b;
    assert_eq!((divergence.kind, divergence.change), (CriticalKind::Capsize, Change::Destabilizes));
    assert_near(divergence.speed, (l * l * cf * cr / (m * (a * cf - b * cr))).sqrt(), 1e-13);
}

/// A wheel that is towed by a mass on a lateral spring, of which only the place of the wheel is a state: y' = v psi. The
/// coefficients of s^3 and s (I + m a^2, k l^2) and of s^2 and 1 (m a v, k l v) have one ratio at the limits of stability,
/// which do not depend on the speed (Schwab & Meijaard 2003); beside, everything is stable or nothing.
#[test]
fn a_towed_wheel_shimmies_at_all_speeds_or_at_none() {
    let (m, k, l) = (5.0, 0.3, 1.0);
    let i = 0.21 * m * l * l;
    let towed = |a: f64| Coefficients {
        // Of yaw psi and of the place y of the wheel; the moment about the wheel, and rolling.
        m: Matrix::<f64, 2>::new(i + m * a * a, 0.0, 0.0, 0.0),
        c0: Matrix::<f64, 2>::new(0.0, 0.0, 0.0, 1.0),
        c1: Matrix::<f64, 2>::new(m * a, 0.0, 0.0, 0.0),
        kc: Matrix::<f64, 2>::new(k * l * l, k * l, 0.0, 0.0),
        k1: Matrix::<f64, 2>::new(0.0, 0.0, -1.0, 0.0),
        states: [States::Both, States::Position],
        ..Default::default()
    };
    for (a, is_stable) in [(0.2, false), (0.29, false), (0.31, true), (0.69, true), (0.71, false)] {
        let stability = Stability::new(&towed(a), 0.0).expect("an answer");
        assert!(stability.critical_speeds.is_empty() && stability.undecided.is_empty(), "{a}: {stability:?}");
        assert_eq!(stability.stable_ranges.len(), usize::from(is_stable), "{a}: {stability:?}");
    }
}

/// A Jeffcott rotor with internal damping, K1 by the spin: it whirls above `sqrt(k/m) (1 + ce/ci)`.
#[test]
fn a_rotor_with_internal_damping_whirls() {
    let (k, ce, ci) = (1e4, 3.0, 2.0);
    let ones = Matrix::<f64, 2>::identity();
    let k1 = Matrix::<f64, 2>::new(0.0, ci, -ci, 0.0);
    let rotor = Coefficients { m: ones, c0: ones * (ce + ci), kc: ones * k, k1, ..Default::default() };
    let [whirl] = speeds(&rotor)[..] else { panic!("one critical speed") };
    assert_eq!((whirl.kind, whirl.change), (CriticalKind::Weave, Change::Destabilizes));
    assert_near(whirl.speed, 100.0 * (1.0 + ce / ci), 1e-14);
    assert_near(whirl.eigenvalue.im, 100.0, 1e-14);
}
