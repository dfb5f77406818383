//! Prints what generated code costs beside Appendix A by hand: operations, time and rounding errors.
//!
//! Two models come out of the compiler: from the formulas of Appendix A, and from the bodies of the mechanism.
//!
//! `cargo run --release -p carvallo-tests --example report`

use std::hint::black_box;
use std::time::{Duration, Instant};

use carvallo::Scalar;
use carvallo_models::{Whipple, WhippleMechanism};
use carvallo_tests::exact::{Matrices, matrices};
use carvallo_tests::operations::count;
use carvallo_tests::real::Real;
use carvallo_tests::{designs, hand_written};

/// More than any cache holds: 208 MB of parameters and 128 MB of matrices in `f64`, half of that in `f32`.
const DESIGNS: u64 = 1_000_000;
const DESIGNS_AGAINST_EXACT: u64 = 10_000;
const ROUNDS: usize = 9;

fn main() {
    row("Whipple bicycle, 4 matrices", ["from formulas", "from bodies", "by hand"]);
    let sources = [
        include_str!("../../generated/src/models/whipple.rs"),
        include_str!("../../generated/src/models/whipple_mechanism.rs"),
        include_str!("../src/hand_written.rs"),
    ];
    row("operations", sources.map(|source| count(source, "matrices").total()));
    times("f64", designs::numbered);
    times("f32", |number| designs::narrowed(&designs::numbered(number)));
    errors("f64", f64::EPSILON, designs::numbered);
    errors("f32", f32::EPSILON.into(), |number| designs::narrowed(&designs::numbered(number)));
}

fn row<T: std::fmt::Display>(label: &str, columns: [T; 3]) {
    let [formulas, bodies, by_hand] = columns.map(|column| column.to_string());
    println!("{label:<42} {formulas:>14} {bodies:>14} {by_hand:>14}");
}

fn mechanism<T: Scalar>(design: &Whipple<T>) -> WhippleMechanism<T> {
    WhippleMechanism::from_array(design.to_array())
}

/// Nanoseconds for each design, the median of several rounds of all in turn.
fn times<T: Scalar>(scalar: &str, design: fn(u64) -> Whipple<T>) {
    let formulas: Vec<Whipple<T>> = (0..DESIGNS).map(design).collect();
    let bodies: Vec<WhippleMechanism<T>> = formulas.iter().map(mechanism).collect();
    let mut rounds: [Vec<f64>; 6] = Default::default();
    for _ in 0..ROUNDS {
        let round = [
            in_cache(&formulas[0], Whipple::matrices),
            in_cache(&bodies[0], WhippleMechanism::matrices),
            in_cache(&formulas[0], hand_written::matrices),
            from_memory(&formulas, Whipple::matrices),
            from_memory(&bodies, WhippleMechanism::matrices),
            from_memory(&formulas, hand_written::matrices),
        ];
        for (times, time) in rounds.iter_mut().zip(round) {
            times.push(time.as_secs_f64() * 1e9 / DESIGNS as f64);
        }
    }
    let [a, b, c, d, e, f] = rounds.map(|mut times| {
        times.sort_by(f64::total_cmp);
        format!("{:.1}", times[ROUNDS / 2])
    });
    row(&format!("ns in cache, {scalar}"), [a, b, c]);
    row(&format!("ns over a million designs, {scalar}"), [d, e, f]);
}

fn in_cache<D, M>(design: &D, compute: fn(&D) -> M) -> Duration {
    let start = Instant::now();
    for _ in 0..DESIGNS {
        black_box(compute(black_box(design)));
    }
    start.elapsed()
}

fn from_memory<D, M>(designs: &[D], compute: fn(&D) -> M) -> Duration {
    // Once before, so that the memory of the results is there.
    let mut matrices: Vec<M> = designs.iter().map(compute).collect();
    let start = Instant::now();
    for (matrices, design) in matrices.iter_mut().zip(designs) {
        *matrices = compute(design);
    }
    black_box(&mut matrices);
    start.elapsed()
}

/// The largest error of an entry, in units of the last place of the largest entry of its matrix.
fn errors<T: Scalar>(scalar: &str, epsilon: f64, design: fn(u64) -> Whipple<T>) {
    let mut largest = [0f64; 3];
    for number in 0..DESIGNS_AGAINST_EXACT {
        let design = design(number);
        let exact: Matrices<Real> = matrices(&design);
        let (formulas, bodies, by_hand) =
            (design.matrices(), mechanism(&design).matrices(), hand_written::matrices(&design));
        let ways = [
            [formulas.m, formulas.c1, formulas.k0, formulas.k2],
            [bodies.m, bodies.c1, bodies.k0, bodies.k2],
            [by_hand.m, by_hand.c1, by_hand.k0, by_hand.k2],
        ];
        for (largest, computed) in largest.iter_mut().zip(ways) {
            for (computed, exact) in computed.iter().zip(&exact) {
                let entries = || [(0, 0), (0, 1), (1, 0), (1, 1)].into_iter();
                let entry = |(row, column): (usize, usize)| exact[row][column];
                let largest_entry = entries().map(|at| entry(at).abs().to_f64()).fold(0.0, f64::max);
                let unit = epsilon * 2f64.powf(largest_entry.log2().floor());
                let error = entries().map(|at| (Real::from(computed[at.0][at.1].to_f64()) - entry(at)).abs().to_f64());
                *largest = largest.max(error.fold(0.0, f64::max) / unit);
            }
        }
    }
    let label = format!("largest error in ulp, {DESIGNS_AGAINST_EXACT} designs, {scalar}");
    row(&label, largest.map(|error| format!("{error:.2}")));
}
