//! The four matrices of the Whipple bicycle: of one design that stays in the cache, and of distinct designs in memory.

use std::hint::black_box;

use carvallo::Scalar;
use carvallo_models::{Whipple, WhippleMatrices, WhippleMechanism};
use carvallo_tests::designs;
use carvallo_tests::hand_written::{self, Float};
use carvallo_tests::peers::symplex::{self, Symplex};

use crate::Summary;
use crate::contest::Task;

const REPETITIONS: usize = 20_000;

pub fn add(summary: &mut Summary) {
    let designs: Vec<Whipple> = (0..summary.designs as u64).map(designs::numbered).collect();
    one_design(summary, "f64", &designs[0]);
    distinct_designs(summary, "f64", &designs);
    let designs: Vec<Whipple<f32>> = designs.iter().map(designs::narrowed).collect();
    one_design(summary, "f32", &designs[0]);
    distinct_designs(summary, "f32", &designs);
}

fn one_design<T: Float + Symplex>(summary: &mut Summary, scalar: &str, design: &Whipple<T>) {
    let mechanism = mechanism(design);
    let task = Task::new(format!("Four matrices, {scalar}, one design in the cache"), REPETITIONS)
        .contender("by hand, Appendix A", repeated(design, hand_written::matrices))
        .contender("symplex-build 0.57", repeated(design, symplex::matrices))
        .contender("ours, from formulas", repeated(design, Whipple::matrices))
        .contender("ours, from bodies", repeated(&mechanism, WhippleMechanism::matrices))
        .limit("limit: reading, writing, sin and cos", repeated(design, sine_and_cosine))
        .limit("limit: reading and writing", repeated(design, copy));
    summary.run(task);
}

fn distinct_designs<T: Float + Symplex>(summary: &mut Summary, scalar: &str, designs: &[Whipple<T>]) {
    let mechanisms: Vec<_> = designs.iter().map(mechanism).collect();
    let task = Task::new(format!("Four matrices, {scalar}, {} distinct designs", designs.len()), designs.len())
        .contender("by hand, Appendix A", each(designs, hand_written::matrices))
        .contender("symplex-build 0.57", each(designs, symplex::matrices))
        .contender("ours, from formulas", each(designs, Whipple::matrices))
        .contender("ours, from bodies", each(&mechanisms, WhippleMechanism::matrices))
        .limit("limit: reading, writing, sin and cos", each(designs, sine_and_cosine))
        .limit("limit: reading and writing", each(designs, copy));
    summary.run(task);
}

fn mechanism<T: Scalar>(design: &Whipple<T>) -> WhippleMechanism<T> {
    WhippleMechanism::from_array(design.to_array())
}

/// Computes one thing again and again.
fn repeated<D, M>(design: &D, compute: impl Fn(&D) -> M) -> impl FnMut() {
    move || {
        for _ in 0..REPETITIONS {
            black_box(compute(black_box(design)));
        }
    }
}

/// Computes each in its turn, into memory that is as large.
fn each<D, M>(designs: &[D], compute: impl Fn(&D) -> M) -> impl FnMut() {
    let mut results: Vec<M> = designs.iter().map(&compute).collect();
    move || {
        for (result, design) in results.iter_mut().zip(designs) {
            *result = compute(design);
        }
        black_box(&mut results);
    }
}

/// Reads all 26 parameters and writes 16 numbers, with an addition for ten of them.
fn copy<T: Scalar>(design: &Whipple<T>) -> WhippleMatrices<T> {
    let read = design.to_array();
    let mut written: [T; 16] = std::array::from_fn(|entry| read[entry]);
    for (written, read) in written.iter_mut().zip(&read[16..]) {
        *written = *written + *read;
    }
    let matrix = |first: usize| [[written[first], written[first + 1]], [written[first + 2], written[first + 3]]];
    WhippleMatrices { m: matrix(0), c1: matrix(4), k0: matrix(8), k2: matrix(12) }
}

/// The same with sine and cosine of the steer axis tilt in the place of two zeros.
fn sine_and_cosine<T: Float>(design: &Whipple<T>) -> WhippleMatrices<T> {
    let mut matrices = copy(design);
    (matrices.c1[0][0], matrices.k2[0][0]) = Float::sin_cos(design.lam);
    matrices
}
