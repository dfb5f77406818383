use super::{ParameterRange, ParameterStability, ParameterStabilityError};
use crate::stability::critical::{Change, CriticalKind};
use crate::stability::verdict::Verdict;
use crate::system::{Matrix, System, SystemError};

const WEAVE: CriticalKind = CriticalKind::Weave;
const CAPSIZE: CriticalKind = CriticalKind::Capsize;

fn of<const N: usize>(range: [f64; 2], system: impl Fn(f64) -> [Matrix<f64, N>; 3]) -> ParameterStability {
    let at = |value: f64| {
        let [m, c, k] = system(value);
        Ok::<_, SystemError>(System::new(m, c, k))
    };
    let found = ParameterStability::new(range, at).expect("an answer");
    assert!(found.undecided.is_empty(), "{found:?}");
    found
}

fn assert_values(found: &ParameterStability, expected: &[(CriticalKind, f64, Change, f64)]) {
    assert_eq!(found.critical_values.len(), expected.len(), "{found:?}");
    for (found, &(kind, value, change, frequency)) in found.critical_values.iter().zip(expected) {
        assert!(found.kind == kind && found.change == change, "{found:?}");
        assert!((found.value - value).abs() <= found.error.max(1e-12 * value.abs()), "{found:?}, expected {value}");
        assert!((found.eigenvalue.im - frequency).abs() <= 1e-9 * frequency, "{found:?}, expected {frequency}");
    }
}

/// Ziegler's double pendulum under a follower load, masses 2 m and m, lengths l, springs k, all one, undamped but for a
/// little damping in proportion to M and K alike: then the load at which pairs meet, 7/2 - sqrt 2, is hardly passed.
/// With damping c in each joint the load is `41/28 + c^2 / 2` (Ziegler 1952; Bolotin 1963).
#[test]
fn a_follower_load_on_a_damped_double_pendulum() {
    for c in [0.1, 0.5, 1.0] {
        let found = of([0.0, 3.0], |load| {
            [
                Matrix::<f64, 2>::new(3.0, 1.0, 1.0, 1.0),
                Matrix::<f64, 2>::new(2.0, -1.0, -1.0, 1.0) * c,
                Matrix::<f64, 2>::new(2.0 - load, load - 1.0, -1.0, 1.0),
            ]
        });
        let critical = 41.0 / 28.0 + 0.5 * c * c;
        assert_eq!(found.critical_values.len(), 1, "{found:?}");
        let first = found.critical_values[0];
        assert!(first.kind == WEAVE && first.change == Change::Destabilizes);
        assert!((first.value - critical).abs() <= 1e-12 * critical, "{first:?}, expected {critical}");
        assert_eq!(found.stable_ranges, [ParameterRange { from: 0.0, to: first.value }]);
        assert_eq!([0.0, 1.0, 2.9].map(|load| found.verdict(load)), {
            [Some(Verdict::Stable), Some(Verdict::Stable), Some(Verdict::Unstable)]
        });
        assert_eq!([-0.1, 3.1, f64::NAN].map(|load| found.verdict(load)), [None; 3]);
    }
}

/// A mass that grows, and stiffness that is a transcendental function: s^2 p + s + cos p is zero at odd halves of pi.
#[test]
fn matrices_need_be_no_polynomials() {
    let ones = Matrix::<f64, 1>::new(1.0);
    let found = of([0.5, 12.0], |p| [ones * p, ones, ones * p.cos()]);
    let half_pi = core::f64::consts::FRAC_PI_2;
    assert_values(
        &found,
        &[
            (CAPSIZE, half_pi, Change::Destabilizes, 0.0),
            (CAPSIZE, 3.0 * half_pi, Change::Stabilizes, 0.0),
            (CAPSIZE, 5.0 * half_pi, Change::Destabilizes, 0.0),
            (CAPSIZE, 7.0 * half_pi, Change::Stabilizes, 0.0),
        ],
    );
    assert_eq!(found.stable_ranges.len(), 3);
}

/// Whatever the range, also through zero and where it is wide: p in the place of damping of one, p^2 - 4 of stiffness of
/// another coordinate.
#[test]
fn a_range_may_contain_zero_and_be_wide() {
    let system = |p: f64| {
        let diagonal = |entries: [f64; 2]| Matrix::<f64, 2>::from_diagonal(&entries.into());
        [diagonal([2.0, 1.0]), diagonal([p, 1.0]), diagonal([18.0, 4.0 - p * p])]
    };
    let expected = [
        (CAPSIZE, -2.0, Change::Stabilizes, 0.0),
        (WEAVE, 0.0, Change::Stabilizes, 3.0),
        (CAPSIZE, 2.0, Change::Destabilizes, 0.0),
    ];
    for range in [[-3.0, 3.0], [-100.0, 1000.0], [-2.5, 1e4]] {
        let found = of(range, system);
        assert_values(&found, &expected);
        assert_eq!(found.stable_ranges.len(), 1);
    }
    assert_values(&of([0.5, 1.5], system), &[]);
}

#[test]
fn what_does_not_depend_on_the_parameter_is_the_same_everywhere() {
    let one = Matrix::<f64, 2>::identity();
    let found = of([0.0, 1.0], |_| [one, one, one]);
    assert!(found.critical_values.is_empty());
    assert_eq!(found.stable_ranges, [ParameterRange { from: 0.0, to: 1.0 }]);
}

#[test]
fn errors_name_the_value() {
    let one = Matrix::<f64, 1>::new(1.0);
    let along = |range: [f64; 2], mass: fn(f64) -> f64| {
        ParameterStability::new(range, |p| Ok::<_, SystemError>(System::new(one * mass(p), one, one)))
    };
    let Err(ParameterStabilityError::Singular { value }) = along([0.0, 5.0], |p| p - 2.0) else {
        panic!("no mass at 2")
    };
    assert!((value - 2.0).abs() < 1e-6, "{value}");
    assert_eq!(along([1.0, 1.0], |_| 1.0), Err(ParameterStabilityError::Range { from: 1.0, to: 1.0 }));
    assert!(matches!(along([0.0, f64::INFINITY], |_| 1.0), Err(ParameterStabilityError::Range { .. })));
    assert!(matches!(along([0.0, 2.0], |p| 1.0 + (p - 0.7).abs()), Err(ParameterStabilityError::NotSmooth { .. })));
    let refused =
        ParameterStability::new([0.0, 2.0], |p| if p > 1.0 { Err("too much") } else { Ok(System::new(one, one, one)) });
    assert!(
        matches!(refused, Err(ParameterStabilityError::System { value, error: "too much" }) if value > 1.0),
        "{refused:?}"
    );
}
