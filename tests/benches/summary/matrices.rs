//! The four matrices of the Whipple bicycle: of one design, of designs in the cache, and of many in memory.

use std::hint::black_box;

use carvallo::batch::{Batch, Blocks};
use carvallo::{Model, Scalar};
use carvallo_models::{Whipple, WhippleMatrices, WhippleMechanism, WhippleMechanismMatrices};
use carvallo_tests::designs;
use carvallo_tests::hand_written::{self, Float};
use carvallo_tests::peers::symplex::{self, Symplex};

use crate::Summary;
use crate::contest::Task;

/// Of 208 + 128 bytes in `f64`: 21 kB.
const IN_CACHE: usize = 64;
/// How many designs a run computes at least, the same ones again and again if there are fewer.
const DESIGNS_IN_A_RUN: usize = 5_000;

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
    let singles: Vec<Whipple<f32>> = designs.iter().map(designs::narrowed).collect();
    for (size, kind) in [(1, "the same again and again"), (IN_CACHE, "in the cache"), (designs.len(), "in memory")] {
        let (designs, singles) = (&designs[..size], &singles[..size]);
        let repetitions = DESIGNS_IN_A_RUN.div_ceil(size);
        let task = |scalar| Task::new(format!("Four matrices, {scalar}, {size} designs, {kind}"), size * repetitions);
        let f64 = one_by_one(task("f64"), designs, repetitions);
        summary.run(if size == 1 { f64 } else { batches(f64, designs, repetitions) });
        summary.run(one_by_one(task("f32"), singles, repetitions));
    }
}

/// All who compute one design after the other.
fn one_by_one<'a, T: Float + Symplex>(task: Task<'a>, designs: &'a [Whipple<T>], repetitions: usize) -> Task<'a> {
    let zeros = || zeros(designs.len());
    let mechanisms: Vec<_> = designs.iter().map(mechanism).collect();
    let zero = [[T::from_f64(0.0); 2]; 2];
    let mut of_mechanisms = vec![WhippleMechanismMatrices { m: zero, c1: zero, k0: zero, k2: zero }; designs.len()];
    let from_bodies = each!(WhippleMechanism::matrices, WhippleMechanism, WhippleMechanismMatrices);
    task.contender("by hand, Appendix A", run(designs, zeros(), repetitions, each!(hand_written::matrices)))
        .contender("symplex-build 0.57", run(designs, zeros(), repetitions, each!(symplex::matrices)))
        .contender("ours, from formulas", run(designs, zeros(), repetitions, each!(Whipple::matrices)))
        .contender("ours, from bodies", move || {
            for _ in 0..repetitions {
                from_bodies(black_box(&mechanisms), black_box(&mut of_mechanisms));
            }
        })
        .limit("limit: reading, writing, sin and cos", run(designs, zeros(), repetitions, each!(sine_and_cosine)))
        .limit("limit: reading and writing", run(designs, zeros(), repetitions, each!(copy)))
}

/// All that compute several designs at once.
fn batches<'a>(task: Task<'a>, designs: &[Whipple], repetitions: usize) -> Task<'a> {
    let batch = Batch::new();
    let mechanisms: Vec<WhippleMechanism> = designs.iter().map(mechanism).collect();
    task.contender("ours, batch, blocks", blocks(batch, &mechanisms, repetitions))
        .contender("ours, batch, columns", columns(batch, &mechanisms, repetitions))
        .contender("ours, batch, structs", structs(batch, mechanisms, repetitions))
        .limit("limit: copying as many bytes", copied(designs.len(), repetitions))
}

fn zeros<T: Scalar>(count: usize) -> Vec<WhippleMatrices<T>> {
    let zero = [[T::from_f64(0.0); 2]; 2];
    vec![WhippleMatrices { m: zero, c1: zero, k0: zero, k2: zero }; count]
}

fn mechanism<T: Scalar>(design: &Whipple<T>) -> WhippleMechanism<T> {
    WhippleMechanism::from_array(design.to_array())
}

fn blocks(batch: Batch, designs: &[WhippleMechanism], repetitions: usize) -> impl FnMut() + use<> {
    let parameters = Blocks::of_designs(designs);
    let mut entries = Blocks::for_entries::<2, WhippleMechanism>(designs.len());
    move || {
        for _ in 0..repetitions {
            let done = batch.matrices::<2, WhippleMechanism>(black_box(&parameters), black_box(&mut entries));
            done.expect("blocks that fit");
        }
    }
}

/// A column for each parameter and for each entry.
fn columns(batch: Batch, designs: &[WhippleMechanism], repetitions: usize) -> impl FnMut() + use<> {
    let parameters: Vec<Vec<f64>> =
        (0..26).map(|parameter| designs.iter().map(|design| design.to_array()[parameter]).collect()).collect();
    let mut entries = vec![vec![0.0; designs.len()]; WhippleMechanism::<f64>::INFO.entries.len()];
    move || {
        let parameters: Vec<&[f64]> = parameters.iter().map(Vec::as_slice).collect();
        let mut entries: Vec<&mut [f64]> = entries.iter_mut().map(Vec::as_mut_slice).collect();
        for _ in 0..repetitions {
            let (parameters, entries) = (black_box(&parameters), black_box(&mut entries));
            batch.matrices_of_columns::<2, WhippleMechanism>(parameters, entries).expect("columns that fit");
        }
    }
}

fn structs(batch: Batch, designs: Vec<WhippleMechanism>, repetitions: usize) -> impl FnMut() {
    let mut coefficients = vec![designs[0].coefficients(); designs.len()];
    move || {
        for _ in 0..repetitions {
            let done = batch.coefficients(black_box(&designs), black_box(&mut coefficients));
            done.expect("slices of equal length");
        }
    }
}

/// As many bytes, read and written together, as the blocks of parameters and entries have.
fn copied(designs: usize, repetitions: usize) -> impl FnMut() {
    let size = (26 + WhippleMechanism::<f64>::INFO.entries.len()) * designs / 2;
    let (from, mut to) = (vec![1.0; size], vec![0.0; size]);
    move || {
        for _ in 0..repetitions {
            black_box(&mut to).copy_from_slice(black_box(&from));
        }
    }
}

fn run<D, M>(designs: &[D], mut results: Vec<M>, repetitions: usize, each: fn(&[D], &mut [M])) -> impl FnMut() {
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
