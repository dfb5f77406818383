//! What breaks a limit, and what is said of it.

use std::time::Duration;

use carvallo::{Coefficients, Model, Number, Rows};
use carvallo_compare::{Comparison, Limits, compare};
use carvallo_models::{Pendulum, PendulumMatrices};

fn by_hand<T: Number>(p: &Pendulum<T>) -> PendulumMatrices<T> {
    let Pendulum { m, l, c, .. } = *p;
    PendulumMatrices { m: Rows([[m * l * l]]), c0: Rows([[c]]), k0: Rows([[m * l]]) }
}

/// Less exact than it should be, and the same formula.
fn rough(p: &Pendulum) -> Coefficients<f64, 1> {
    let mut all = p.coefficients();
    all.m[(0, 0)] *= 1.0 + 1e-12;
    all
}

#[test]
fn errors_are_limited() {
    let report = Comparison::<Pendulum, 1>::of(Pendulum::matrices).against("rough", rough).random_designs(10).report();
    let broken = report.expect("designs").broken(Limits::default());
    let [broken] = &broken[..] else { panic!("{broken:?}") };
    assert!(broken.starts_with("M_11 of `rough` in f64 is off by "), "{broken}");
    assert!(broken.ends_with(", of which 16 are allowed"), "{broken}");
}

#[test]
#[should_panic(expected = "Pendulum: `twice` differs in M_11")]
fn what_differs_is_asserted() {
    let twice = |p: &Pendulum| {
        let mut all = p.coefficients();
        all.m *= 2.0;
        all
    };
    let comparison = Comparison::<Pendulum, 1>::of(Pendulum::matrices).against("twice", twice).random_designs(10);
    comparison.report().expect("designs").assert(Limits::default());
}

#[test]
fn operations_are_limited() {
    let report = compare!(Pendulum, by_hand).random_designs(10).report().expect("designs");
    let limits = |operations_by_hand| Limits { operations_by_hand: Some(operations_by_hand), ..Limits::default() };
    assert_eq!(report.broken(limits(1.0)), [""; 0]);
    assert_eq!(
        report.broken(limits(0.5)),
        ["`generated` does 2 operations, `by_hand` 3, of which 0.5 times as many are allowed"]
    );
}

#[test]
fn a_limit_of_time_needs_times() {
    let limits = Limits { times_by_hand: Some(1e-3), ..Limits::default() };
    let comparison = compare!(Pendulum, by_hand).random_designs(10);
    assert_eq!(
        comparison.report().expect("designs").broken(limits),
        ["no time was taken, which a limit needs: `timed`"]
    );
    let mut report = comparison.timed(Duration::from_millis(1)).report().expect("designs");
    let tasks: Vec<&str> = report.times.iter().map(|task| task.task.as_str()).collect();
    let expected = ["f64, one design", "f64, a loop over 64 designs", "f32, one design", "f32, a loop over 64 designs"];
    assert_eq!(tasks, expected);
    let names: Vec<&str> = report.times[1].times.iter().map(|time| time.name.as_str()).collect();
    assert_eq!(names[..2], ["generated", "by_hand"]);
    assert!(names[2].starts_with("generated, batch, "), "{names:?}");
    report.optimized = false;
    assert_eq!(report.broken(limits), ["times of a program without optimization cannot be limited: `--release`"]);
    // No program is a thousand times as fast as another that does as much.
    report.optimized = true;
    let broken = report.broken(limits);
    assert_eq!(broken.len(), 4, "{broken:?}");
    assert!(broken[0].starts_with("f64, one design: `generated` takes "), "{broken:?}");
    assert!(broken[0].ends_with(" times as long as `by_hand`, of which 0.001 are allowed"), "{broken:?}");
}
