//! The four matrices of the Whipple bicycle: of one design, of designs in the cache, and of many in memory.

use std::cell::Cell;
use std::hint::black_box;

use carvallo::batch::{Batch, Blocks, InLanes};
use carvallo::{Model, Rows, Scalar};
use carvallo_compare::Task;
use carvallo_models::{Whipple, WhippleMatrices, WhippleMechanism, WhippleMechanismMatrices};
use carvallo_tests::designs;
use carvallo_tests::hand_written::{self, Float};
use carvallo_tests::peers::symplex::{self, Symplex};

use crate::Summary;

/// Of 208 + 128 bytes in `f64`: 21 kB.
const IN_CACHE: usize = 64;
/// Of the designs in memory, how many are computed in one run: 3.4 MB with their matrices.
const IN_A_RUN: usize = 10_000;
/// How many designs a run computes at least, the same ones again and again if there are fewer.
const AT_LEAST: usize = 5_000;
/// Designs in memory that one contender is ahead of the next, if there are a million.
const AHEAD: usize = 90_000;

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
    let designs: Vec<Whipple> = (0..summary.designs as u64).map(upright).collect();
    let singles: Vec<Whipple<f32>> = designs.iter().map(designs::narrowed).collect();
    for (size, kind) in [(1, "the same again and again"), (IN_CACHE, "in the cache"), (designs.len(), "in memory")] {
        let (designs, singles) = (&designs[..size], &singles[..size]);
        let turns = Turns::new(size);
        let name = |scalar| format!("Four matrices, {scalar}, {size} designs, {kind}");
        let of_f64 = one_by_one(Task::new(name("f64"), turns.computed()), &turns, designs);
        summary.run(if size == 1 { of_f64 } else { batches(of_f64, &turns, designs) });
        let turns = Turns::new(size);
        let of_f32 = one_by_one(Task::new(name("f32"), turns.computed()), &turns, singles);
        summary.run(if size == 1 { of_f32 } else { batches(of_f32, &turns, singles) });
    }
    between_precisions(summary, &designs[..IN_CACHE], &singles[..IN_CACHE]);
}

/// Batches of `f32` beside those of `f64`.
fn between_precisions(summary: &mut Summary, designs: &[Whipple], singles: &[Whipple<f32>]) {
    let turns = Turns::new(IN_CACHE);
    let task = Task::new(format!("Four matrices in a batch, {IN_CACHE} designs, in the cache"), turns.computed());
    let task = task.contender("f64, blocks", blocks(&turns, designs));
    summary.run(task.contender("f32, blocks", blocks(&turns, singles)));
}

/// A random design whose steer axis is, as that of every shipped bicycle, within 45 degrees of the vertical: up to there
/// sine and cosine need no quarter turns taken off.
fn upright(number: u64) -> Whipple {
    let design = designs::numbered(number);
    Whipple { lam: 0.85 * design.lam, ..design }
}

/// All who compute one design after the other.
fn one_by_one<'a, T: Float + Symplex>(task: Task<'a>, turns: &Turns, designs: &'a [Whipple<T>]) -> Task<'a> {
    let zero = Rows([[T::from_f64(0.0); 2]; 2]);
    let by =
        |each| turns.each(turns.portions(designs), WhippleMatrices { m: zero, c1: zero, k0: zero, k2: zero }, each);
    let mechanisms = turns.portions(designs).map(mechanisms);
    let of_mechanism = WhippleMechanismMatrices { m: zero, c1: zero, k0: zero, k2: zero };
    let from_bodies = each!(WhippleMechanism::matrices, WhippleMechanism, WhippleMechanismMatrices);
    task.contender("by hand, Appendix A", by(each!(hand_written::matrices)))
        .contender("symplex-build 0.57", by(each!(symplex::matrices)))
        .contender("ours, from formulas", by(each!(Whipple::matrices)))
        .contender("ours, from bodies", turns.each(mechanisms, of_mechanism, from_bodies))
        .limit("limit: reading, writing, sin and cos", by(each!(sine_and_cosine)))
        .limit("limit: reading and writing", by(each!(copy)))
}

/// All that compute several designs at once.
fn batches<'a, T: InLanes>(task: Task<'a>, turns: &Turns, designs: &'a [Whipple<T>]) -> Task<'a> {
    let batch = Batch::new();
    let outputs = Whipple::<T>::INFO.entries.len();
    let zero = T::from_f64(0.0);
    let columns = turns.portions(designs).map(|designs| {
        let column = |parameter| designs.iter().map(|design| design.to_array()[parameter]).collect();
        ((0..26).map(column).collect::<Vec<Vec<T>>>(), vec![vec![zero; designs.len()]; outputs])
    });
    let structs = || {
        turns.portions(designs).map(|designs| {
            let coefficients = vec![designs[0].coefficients(); designs.len()];
            (designs, coefficients)
        })
    };
    // Read and written together, blocks of parameters and entries have so many numbers.
    let copied = turns.portions(designs).map(|designs| {
        let numbers = designs.len() * (26 + outputs) / 2;
        (vec![T::from_f64(1.0); numbers], vec![zero; numbers])
    });
    task.contender("ours, batch, blocks", blocks(turns, designs))
        .contender(
            "ours, batch, columns",
            turns.take(columns, move |(parameters, entries)| {
                let parameters: [&[T]; 26] = std::array::from_fn(|parameter| parameters[parameter].as_slice());
                let mut entries: Vec<&mut [T]> = entries.iter_mut().map(Vec::as_mut_slice).collect();
                batch.matrices_of_columns::<2, Whipple<T>>(&parameters, &mut entries).expect("columns that fit");
            }),
        )
        .contender(
            "ours, batch, structs",
            turns.take(structs(), move |(designs, coefficients)| {
                batch.coefficients(designs, coefficients).expect("slices of equal length");
            }),
        )
        .contender(
            "ours, the same structs one by one",
            turns.take(structs(), move |(designs, coefficients)| {
                for (coefficients, design) in coefficients.iter_mut().zip(designs.iter()) {
                    *coefficients = design.coefficients();
                }
            }),
        )
        .limit("limit: copying as many bytes", turns.take(copied, |(from, to)| to.copy_from_slice(from)))
}

/// From blocks into blocks.
fn blocks<'a, T: InLanes>(turns: &Turns, designs: &'a [Whipple<T>]) -> Box<dyn FnMut() + 'a> {
    let batch = Batch::new();
    let blocks = turns
        .portions(designs)
        .map(|designs| (Blocks::of_designs(designs), Blocks::for_entries::<2, Whipple<T>>(designs.len())));
    turns.take(blocks, move |(parameters, entries)| {
        batch.matrices::<2, Whipple<T>>(parameters, entries).expect("blocks that fit");
    })
}

fn mechanisms<T: Scalar>(designs: &[Whipple<T>]) -> Vec<WhippleMechanism<T>> {
    designs.iter().map(|design| WhippleMechanism::from_array(design.to_array())).collect()
}

/// Portions of the designs are computed in turn, one in a run: again and again if they are small.
///
/// Each contender starts at another portion, so that none finds in the cache what one before it has read.
struct Turns {
    in_a_run: usize,
    repetitions: usize,
    contenders: Cell<usize>,
}

impl Turns {
    fn new(designs: usize) -> Self {
        let in_a_run = designs.min(IN_A_RUN);
        Self { in_a_run, repetitions: AT_LEAST.div_ceil(in_a_run), contenders: Cell::new(0) }
    }

    /// How many designs are computed in a run.
    fn computed(&self) -> usize {
        self.in_a_run * self.repetitions
    }

    fn portions<'a, D>(&self, designs: &'a [D]) -> impl Iterator<Item = &'a [D]> + use<'a, D> {
        designs.chunks_exact(self.in_a_run)
    }

    /// Computes portions, each with room for its results.
    fn take<'a, P: 'a>(
        &self,
        portions: impl Iterator<Item = P>,
        compute: impl Fn(&mut P) + 'a,
    ) -> Box<dyn FnMut() + 'a> {
        let mut portions: Vec<P> = portions.collect();
        let contender = self.contenders.replace(self.contenders.get() + 1);
        let mut turn = contender * AHEAD / self.in_a_run;
        let repetitions = self.repetitions;
        Box::new(move || {
            turn = (turn + 1) % portions.len();
            for _ in 0..repetitions {
                compute(black_box(&mut portions[turn]));
            }
        })
    }

    /// Computes portions of designs into slices.
    fn each<'a, D: 'a, M: Copy + 'a, S: AsRef<[D]> + 'a>(
        &self,
        portions: impl Iterator<Item = S>,
        zero: M,
        each: fn(&[D], &mut [M]),
    ) -> Box<dyn FnMut() + 'a> {
        let with_room = portions.map(|designs| {
            let results = vec![zero; designs.as_ref().len()];
            (designs, results)
        });
        self.take(with_room, move |(designs, results)| each(designs.as_ref(), results))
    }
}

/// Reads all 26 parameters and writes 16 numbers, with an addition for ten of them.
#[inline]
fn copy<T: Scalar>(design: &Whipple<T>) -> WhippleMatrices<T> {
    let read = design.to_array();
    let mut written: [T; 16] = std::array::from_fn(|entry| read[entry]);
    for (written, read) in written.iter_mut().zip(&read[16..]) {
        *written += *read;
    }
    let matrix = |first: usize| Rows([[written[first], written[first + 1]], [written[first + 2], written[first + 3]]]);
    WhippleMatrices { m: matrix(0), c1: matrix(4), k0: matrix(8), k2: matrix(12) }
}

/// The same with sine and cosine of the steer axis tilt in the place of two zeros.
#[inline]
fn sine_and_cosine<T: Float + Scalar>(design: &Whipple<T>) -> WhippleMatrices<T> {
    let mut matrices = copy(design);
    (matrices.c1[0][0], matrices.k2[0][0]) = Float::sin_cos(design.lam);
    matrices
}
