//! Optima with constraints, against those that SciPy 1.17.1 found by differential evolution and SLSQP over formulas of its own:
//! `optima.py`, beside this file, prints the numbers.

use std::cell::Cell;
use std::ops::ControlFlow;

use carvallo_design::input::{Request, load};
use carvallo_optimize::{Goal, Measure, Optimum, Problem, Range, Settings, optimize};

/// How far both may be from the optimum, relative to it.
const TOLERANCE: f64 = 1e-7;

/// The best design of a shipped bicycle; it keeps everything exactly.
fn best(bicycle: &str, vary: &[&str], goal: Goal, keep: &[&str], speeds: [f64; 2]) -> Optimum {
    let design = load(&Request { parameters: Some(bicycle.to_owned()), ..Request::default() }).unwrap();
    let owned = |texts: &[&str]| texts.iter().map(|text| (*text).to_owned()).collect::<Vec<_>>();
    let ranges = Range::parse(&owned(vary), design.info()).unwrap();
    let problem = Problem::new(&design, ranges, goal, &owned(keep)).unwrap();
    let settings = Settings { speeds, ..problem.settings };
    let problem = problem.with(settings).unwrap();
    let optimum = optimize(&problem, &|_| ControlFlow::Continue(())).unwrap();
    assert_eq!(optimum.violations(&problem), Vec::<String>::new());
    optimum
}

fn check(optimum: &Optimum, value: f64, varied: &[f64]) {
    assert!((optimum.value - value).abs() < TOLERANCE * value.abs(), "{}, by SciPy {value}", optimum.value);
    for (found, expected) in optimum.varied.iter().zip(varied) {
        // Around an optimum the value changes by the square.
        assert!((found - expected).abs() < 2e-4 * expected.abs(), "{:?}, by SciPy {varied:?}", optimum.varied);
    }
}

#[test]
fn the_lowest_weave_speed_beside_a_capsize_speed() {
    let vary = ["lam=5 deg:35 deg", "c=0:15 cm", "w=0.9:1.3"];
    let keep = ["capsize_speed >= 6", "c >= 3 cm", "w >= 1"];
    let optimum = best("benchmark", &vary, Goal::minimize(Measure::WeaveSpeed), &keep, [0.0, 20.0]);
    check(&optimum, 4.063_721_762_06, &[0.217_822_191, 0.088_673_509, 1.0]);
}

#[test]
fn the_widest_stable_range_beside_a_weave_speed() {
    let vary = ["w=0.9:1.2", "c=0:15 cm", "xH=0.7:1.1"];
    let keep = ["xH <= w - 0.1", "weave_speed <= 4"];
    let optimum = best("pista", &vary, Goal::maximize(Measure::StableRange), &keep, [0.0, 10.0]);
    check(&optimum, 3.922_513_789_5, &[0.9, 0.15, 0.8]);
}

#[test]
fn the_heaviest_rider_with_a_stable_range() {
    let vary = ["mB=60:100", "zB=-1.2:-0.6", "lam=5 deg:35 deg", "c=0.02:0.12"];
    let keep = ["stable_range >= 2.5", "weave_speed <= 4.2", "c >= 0.1*lam", "zB <= -0.8"];
    let design = load(&Request::default()).unwrap();
    let mass = Measure::called("mB", design.info()).unwrap();
    let optimum = best("benchmark", &vary, Goal::maximize(mass), &keep, [0.0, 20.0]);
    check(&optimum, 78.613_574_249_6, &[78.613_574_2, -0.8, 0.231_419_359, 0.12]);
}

#[test]
fn a_search_ends_when_it_is_told_to() {
    let design = load(&Request::default()).unwrap();
    let ranges = Range::parse(&["w=0.9:1.3".to_owned(), "c=0:15 cm".to_owned()], design.info()).unwrap();
    let problem = Problem::new(&design, ranges, Goal::minimize(Measure::WeaveSpeed), &[]).unwrap();
    let told = Cell::new(0);
    let progress = |_| {
        told.set(told.get() + 1);
        if told.get() < 200 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let failure = optimize(&problem, &progress).unwrap_err();
    assert!(failure.to_string().contains("benchmark: the search was ended"), "{failure}");
    assert_eq!(told.get(), 200);
}
