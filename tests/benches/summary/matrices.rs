//! The four matrices of the Whipple bicycle: of one design, of designs in the cache, and of many in memory.

use std::hint::black_box;

use carvallo::Scalar;
use carvallo_models::{Whipple, WhippleMatrices, WhippleMechanism, WhippleMechanismMatrices};
use carvallo_tests::designs;
use carvallo_tests::hand_written::{self, Float};
use carvallo_tests::peers::symplex::{self, Symplex};

use crate::Summary;
use crate::contest::Task;

/// Of 208 + 128 bytes in `f64`: 21 kB.
const IN_CACHE: usize = 64;
/// How many designs a run computes at least, the same ones again and again if there are fewer.
const DESIGNS_IN_A_RUN: usize = 20_000;

/// A loop over designs that is compiled by itself, and in which the evaluator is called at one place: so a compiler
/// that inlines it here does so for every contender.
macro_rules! each {
    ($evaluator:path, $design:ident, $matrices:ident) => {{
        #[inline(never)]
        fn each<T: Float + Symplex>(designs: &[$design<T>], results: &mut [$matrices<T>]) {
            for (result, design) in results.iter_mut().zip(designs) {
                *result = $evaluator(design);
            }
        }
        each
    }};
    ($evaluator:path) => {
        each!($evaluator, Whipple, WhippleMatrices)
    };
}

pub fn add(summary: &mut Summary) {
    let designs: Vec<Whipple> = (0..summary.designs as u64).map(designs::numbered).collect();
    all_sizes(summary, "f64", &designs);
    let designs: Vec<Whipple<f32>> = designs.iter().map(designs::narrowed).collect();
    all_sizes(summary, "f32", &designs);
}

fn all_sizes<T: Float + Symplex>(summary: &mut Summary, scalar: &str, designs: &[Whipple<T>]) {
    let mechanisms: Vec<_> = designs.iter().map(|design| WhippleMechanism::from_array(design.to_array())).collect();
    let zero = [[T::from_f64(0.0); 2]; 2];
    let results = || vec![WhippleMatrices { m: zero, c1: zero, k0: zero, k2: zero }; designs.len()];
    let of_mechanisms = || vec![WhippleMechanismMatrices { m: zero, c1: zero, k0: zero, k2: zero }; designs.len()];
    for (size, kind) in [(1, "the same again and again"), (IN_CACHE, "in the cache"), (designs.len(), "in memory")] {
        let repetitions = DESIGNS_IN_A_RUN.div_ceil(size);
        let (designs, mechanisms) = (&designs[..size], &mechanisms[..size]);
        let task = Task::new(format!("Four matrices, {scalar}, {size} designs, {kind}"), size * repetitions)
            .contender("by hand, Appendix A", run(designs, results(), repetitions, each!(hand_written::matrices)))
            .contender("symplex-build 0.57", run(designs, results(), repetitions, each!(symplex::matrices)))
            .contender("ours, from formulas", run(designs, results(), repetitions, each!(Whipple::matrices)))
            .contender(
                "ours, from bodies",
                run(
                    mechanisms,
                    of_mechanisms(),
                    repetitions,
                    each!(WhippleMechanism::matrices, WhippleMechanism, WhippleMechanismMatrices),
                ),
            )
            .limit("limit: reading, writing, sin and cos", run(designs, results(), repetitions, each!(sine_and_cosine)))
            .limit("limit: reading and writing", run(designs, results(), repetitions, each!(copy)));
        summary.run(task);
    }
}

fn run<D, M>(designs: &[D], mut results: Vec<M>, repetitions: usize, each: fn(&[D], &mut [M])) -> impl FnMut() {
    results.truncate(designs.len());
    move || {
        for _ in 0..repetitions {
            each(black_box(designs), black_box(&mut results));
        }
    }
}

/// Reads all 26 parameters and writes 16 numbers, with an addition for ten of them.
#[inline]
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
#[inline]
fn sine_and_cosine<T: Float>(design: &Whipple<T>) -> WhippleMatrices<T> {
    let mut matrices = copy(design);
    (matrices.c1[0][0], matrices.k2[0][0]) = Float::sin_cos(design.lam);
    matrices
}
