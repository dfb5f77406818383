//! Prints what generated code costs beside Appendix A by hand: operations, time and rounding errors.
//!
//! `cargo run --release -p carvallo-tests --example report`

use std::hint::black_box;
use std::time::Instant;

use carvallo::Scalar;
use carvallo_models::{Whipple, WhippleMatrices};
use carvallo_tests::exact::{Matrices, matrices};
use carvallo_tests::operations::count;
use carvallo_tests::real::Real;
use carvallo_tests::{designs, hand_written};

/// More than any cache holds: 208 MB of parameters and 128 MB of matrices in `f64`, half of that in `f32`.
const DESIGNS: u64 = 1_000_000;
const DESIGNS_AGAINST_EXACT: u64 = 10_000;
const ROUNDS: usize = 9;

fn main() {
    println!("{:<42} {:>12} {:>12}", "Whipple bicycle, 4 matrices", "generated", "by hand");
    let generated = count(include_str!("../../generated/src/models/whipple.rs"), "matrices");
    let by_hand = count(include_str!("../src/hand_written.rs"), "matrices");
    println!("{:<42} {:>12} {:>12}", "operations", generated.total(), by_hand.total());
    times("f64", &Whipple::BENCHMARK, designs::numbered);
    times("f32", &designs::narrowed(&Whipple::BENCHMARK), |number| designs::narrowed(&designs::numbered(number)));
    errors("f64", f64::EPSILON, designs::numbered);
    errors("f32", f32::EPSILON.into(), |number| designs::narrowed(&designs::numbered(number)));
}

/// Nanoseconds for each design, the median of several rounds of both in turn.
fn times<T: Scalar>(scalar: &str, one: &Whipple<T>, design: fn(u64) -> Whipple<T>) {
    let in_cache = |compute: fn(&Whipple<T>) -> WhippleMatrices<T>| {
        let start = Instant::now();
        for _ in 0..DESIGNS {
            black_box(compute(black_box(one)));
        }
        start.elapsed()
    };
    let designs: Vec<Whipple<T>> = (0..DESIGNS).map(design).collect();
    let mut matrices: Vec<WhippleMatrices<T>> = designs.iter().map(Whipple::matrices).collect();
    let mut from_memory = |compute: fn(&Whipple<T>) -> WhippleMatrices<T>| {
        let start = Instant::now();
        for (matrices, design) in matrices.iter_mut().zip(&designs) {
            *matrices = compute(design);
        }
        black_box(&mut matrices);
        start.elapsed()
    };
    let mut rounds: [Vec<f64>; 4] = Default::default();
    for _ in 0..ROUNDS {
        let round = [
            in_cache(Whipple::matrices),
            in_cache(hand_written::matrices),
            from_memory(Whipple::matrices),
            from_memory(hand_written::matrices),
        ];
        for (times, time) in rounds.iter_mut().zip(round) {
            times.push(time.as_secs_f64() * 1e9 / DESIGNS as f64);
        }
    }
    let [a, b, c, d] = rounds.map(|mut times| {
        times.sort_by(f64::total_cmp);
        times[ROUNDS / 2]
    });
    println!("{:<42} {a:>12.1} {b:>12.1}", format!("ns in cache, {scalar}"));
    println!("{:<42} {c:>12.1} {d:>12.1}", format!("ns over a million designs, {scalar}"));
}

/// The largest error of an entry, in units of the last place of the largest entry of its matrix.
fn errors<T: Scalar>(scalar: &str, epsilon: f64, design: fn(u64) -> Whipple<T>) {
    let mut largest = [0f64; 2];
    for number in 0..DESIGNS_AGAINST_EXACT {
        let design = design(number);
        let exact: Matrices<Real> = matrices(&design);
        for (way, computed) in [design.matrices(), hand_written::matrices(&design)].iter().enumerate() {
            for (computed, exact) in [computed.m, computed.c1, computed.k0, computed.k2].iter().zip(&exact) {
                let entries = || [(0, 0), (0, 1), (1, 0), (1, 1)].into_iter();
                let entry = |(row, column): (usize, usize)| exact[row][column];
                let largest_entry = entries().map(|at| entry(at).abs().to_f64()).fold(0.0, f64::max);
                let unit = epsilon * 2f64.powf(largest_entry.log2().floor());
                let error = entries().map(|at| (Real::from(computed[at.0][at.1].to_f64()) - entry(at)).abs().to_f64());
                largest[way] = largest[way].max(error.fold(0.0, f64::max) / unit);
            }
        }
    }
    let label = format!("largest error in ulp, {DESIGNS_AGAINST_EXACT} designs, {scalar}");
    println!("{label:<42} {:>12.2} {:>12.2}", largest[0], largest[1]);
}
