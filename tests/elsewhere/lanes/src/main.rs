//! All models in the lanes of the processor that this runs on, in `f64` and in `f32`, from blocks, columns and structs,
//! eigenvalues, derivatives and nonlinear motions: each must be what it is alone, to the last bit.
//!
//! It prints the lanes, and a number that is made of the bits of all results, for which every processor has to give the same.
//! `.ci/run` compares that of the host with those of ARM, under qemu, and of WebAssembly, in node.

use std::process::ExitCode;

use carvallo::batch::{Arrival, Batch, Blocks, Ensemble, InLanes, Limit};
use carvallo::{Coefficients, EntryInfo, MatrixName, Model, Scalar};
use carvallo_models::{Whipple, WhippleMechanism, each_model};

/// Designs enough for columns that are read from memory, and lanes to spare.
const DESIGNS: usize = 4101;

/// Designs of which there are fewer than stretches of columns, and lanes to spare.
const FEW: usize = 67;

/// Forward speeds in m/s.
const SPEEDS: [f64; 9] = [0.0, 0.5, 1.0, 2.0, 4.3, 5.0, 6.02, 9.0, 12.0];

/// What all results are summed up to.
#[derive(Default)]
struct Sum(u64);

impl Sum {
    /// A number, of which all that is not a number counts as the same.
    fn add(&mut self, number: f64) {
        let bits = if number.is_nan() { 0 } else { number.to_bits() };
        // The step of the hash FNV-1a, by words.
        self.0 = (self.0 ^ bits).wrapping_mul(0x0100_0000_01b3);
    }
}

fn same<T: Scalar>(x: T, y: T) -> bool {
    let [x, y] = [x, y].map(Scalar::to_f64);
    x.to_bits() == y.to_bits() || x.is_nan() && y.is_nan()
}

/// Designs about the first parameter set of a model.
fn some<const N: usize, M: Model<N>>(count: usize) -> Vec<M> {
    let set = M::INFO.sets.first().expect("a parameter set").values;
    let design = |number: usize| {
        let value = |(i, x): (usize, &f64)| M::Scalar::from_f64(x * (1.0 + 0.01 * ((number * (i + 1)) % 17) as f64));
        M::from_slice(&set.iter().enumerate().map(value).collect::<Vec<_>>()).expect("as many values as parameters")
    };
    (0..count).map(design).collect()
}

/// The matrices of designs at every level; what differs is told, and counted.
fn check<const N: usize, M: Model<N, Scalar: InLanes>>(designs: &[M], sum: &mut Sum) -> usize {
    let alone: Vec<Coefficients<M::Scalar, N>> = designs.iter().map(Model::coefficients).collect();
    let entry = |coefficients: &Coefficients<M::Scalar, N>, entry: &EntryInfo| {
        let (matrix, row, column) = entry.places[0];
        coefficients.matrix(matrix)[(row, column)]
    };
    for coefficients in &alone {
        M::INFO.entries.iter().for_each(|info| sum.add(entry(coefficients, info).to_f64()));
    }
    let columns: Vec<Vec<M::Scalar>> = (0..M::INFO.parameters.len())
        .map(|position| designs.iter().map(|design| design.parameters().as_ref()[position]).collect())
        .collect();
    let inputs: Vec<&[M::Scalar]> = columns.iter().map(Vec::as_slice).collect();
    let mut wrong = 0;
    for batch in Batch::levels() {
        let mut blocks = Blocks::for_entries::<N, M>(designs.len());
        batch.matrices::<N, M>(&Blocks::of_designs(designs), &mut blocks).expect("blocks that fit");
        let mut outputs = vec![vec![M::Scalar::from_f64(f64::NAN); designs.len()]; M::INFO.entries.len()];
        let mut borrowed: Vec<&mut [M::Scalar]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
        batch.matrices_of_columns::<N, M>(&inputs, &mut borrowed).expect("columns that fit");
        let mut structs = vec![Coefficients::default(); designs.len()];
        batch.coefficients(designs, &mut structs).expect("slices of equal length");
        for (design, alone) in alone.iter().enumerate() {
            let of_entries = M::INFO.entries.iter().enumerate().all(|(position, info)| {
                let expected = entry(alone, info);
                same(blocks.get(design, position), expected) && same(outputs[position][design], expected)
            });
            let matrices = |of: &Coefficients<M::Scalar, N>| MatrixName::ALL.map(|name| *of.matrix(name));
            let of_structs = matrices(&structs[design])
                .iter()
                .zip(&matrices(alone))
                .all(|(found, expected)| found.iter().zip(expected).all(|(x, y)| same(*x, *y)));
            if !of_entries || !of_structs {
                wrong += 1;
                println!("{}, {batch}: design {design} is not what it is alone", M::INFO.name);
            }
        }
    }
    wrong
}

/// The eigenvalues of a bicycle at speeds, at every level.
fn check_eigenvalues(design: &Whipple, sum: &mut Sum) -> usize {
    let coefficients = design.coefficients();
    let alone = SPEEDS.map(|speed| coefficients.at(speed, design.g).expect("a system").quartic_eigenvalues());
    for part in alone.iter().flatten().flatten().flat_map(|eigenvalue| [eigenvalue.re, eigenvalue.im]) {
        sum.add(part);
    }
    let wrong = Batch::levels().filter(|batch| {
        let mut found = SPEEDS.map(|_| Ok(Default::default()));
        batch.eigenvalues_along(&coefficients, design.g, &SPEEDS, &mut found).expect("slices of equal length");
        found.iter().zip(&alone).any(|(found, alone)| format!("{found:?}") != format!("{alone:?}"))
    });
    wrong.inspect(|batch| println!("{batch}: eigenvalues are not what they are alone")).count()
}

/// The derivatives of bicycles at every level.
fn check_derivatives<T: InLanes>(designs: &[Whipple<T>], sum: &mut Sum) -> usize {
    let alone: Vec<_> = designs.iter().map(|design| design.matrices_and_derivatives().1.values).collect();
    alone.iter().flatten().for_each(|value| sum.add(value.to_f64()));
    let wrong = Batch::levels().filter(|batch| {
        let mut entries = Blocks::for_entries::<2, Whipple<T>>(designs.len());
        let mut values = Blocks::for_derivatives::<2, Whipple<T>>(designs.len());
        let parameters = Blocks::of_designs(designs);
        batch.jacobians::<2, Whipple<T>>(&parameters, &mut entries, &mut values).expect("blocks that fit");
        let mut all = alone.iter().enumerate();
        all.any(|(design, alone)| alone.iter().enumerate().any(|(i, value)| !same(values.get(design, i), *value)))
    });
    wrong.inspect(|batch| println!("{batch}: derivatives are not what they are alone")).count()
}

/// Bicycles that are pushed, at every level: one after the other is what the lanes of each level have to give.
fn check_motions<T: InLanes>(sum: &mut Sum) -> usize {
    const RIDES: usize = 5;
    let designs: Vec<WhippleMechanism<T>> = some(RIDES);
    let mut begin = Blocks::for_states::<2, WhippleMechanism<T>>(RIDES);
    for (ride, design) in designs.iter().enumerate() {
        begin.set(ride, 8, T::from_f64(0.5 + 0.2 * ride as f64));
        begin.set(ride, 10, T::from_f64(-3.0 / design.rR.to_f64()));
    }
    let limits = [Limit::symmetric(3, 0.4)];
    let ensemble = Ensemble { duration: 0.6, tolerance: 1e-5, limits: &limits };
    let run = |batch: Batch, rides: std::ops::Range<usize>| {
        let mut states = Blocks::for_states::<2, WhippleMechanism<T>>(rides.len());
        for (place, ride) in rides.clone().enumerate() {
            (0..states.width()).for_each(|position| states.set(place, position, begin.get(ride, position)));
        }
        let mut outcomes = vec![Ok(Arrival::Reached); rides.len()];
        let parameters = Blocks::of_designs(&designs[rides]);
        let done = batch.simulate::<2, WhippleMechanism<T>>(&ensemble, &parameters, &mut states, &mut outcomes);
        done.expect("blocks that fit");
        let of_ride = |(ride, outcome)| (outcome, (0..states.width()).map(|i| states.get(ride, i)).collect::<Vec<T>>());
        outcomes.into_iter().enumerate().map(of_ride).collect::<Vec<_>>()
    };
    let alone: Vec<_> = (0..RIDES).flat_map(|ride| run(Batch::new(), ride..ride + 1)).collect();
    alone.iter().flat_map(|(_, state)| state).for_each(|number| sum.add(number.to_f64()));
    let wrong = Batch::levels().filter(|batch| run(*batch, 0..RIDES) != alone);
    wrong.inspect(|batch| println!("{batch}: motions are not what they are alone")).count()
}

/// A model in both precisions: how much of it is wrong, and the sum of its results.
fn check_model<const N: usize, M: Model<N, Scalar = f64, Over<f32>: Model<N, Scalar = f32>>>() -> (usize, Sum) {
    let mut sum = Sum::default();
    let wrong = check(&some::<N, M>(FEW), &mut sum) + check(&some::<N, M::Over<f32>>(FEW), &mut sum);
    (wrong, sum)
}

fn main() -> ExitCode {
    let (mut sum, mut wrong) = (Sum::default(), 0);
    let of_models = each_model!(check_model);
    for (of_model, results) in &of_models {
        wrong += of_model;
        sum.0 = sum.0.rotate_left(17) ^ results.0;
    }
    let bicycles: Vec<Whipple> = some(DESIGNS);
    // Angles beyond an eighth of a turn, so that quarter turns are taken off.
    let steep = |i: usize| Whipple { lam: 0.001 * i as f64 - 2.0, ..Whipple::BENCHMARK };
    let steep: Vec<Whipple> = (0..DESIGNS).map(steep).collect();
    for designs in [&bicycles, &steep] {
        wrong += check(designs, &mut sum);
        wrong += check(&designs.iter().map(Whipple::cast::<f32>).collect::<Vec<_>>(), &mut sum);
    }
    for bicycle in &bicycles[..FEW] {
        wrong += check_eigenvalues(bicycle, &mut sum);
    }
    wrong += check_derivatives(&bicycles[..FEW], &mut sum);
    wrong += check_derivatives(&bicycles[..FEW].iter().map(Whipple::cast::<f32>).collect::<Vec<_>>(), &mut sum);
    wrong += check_motions::<f64>(&mut sum) + check_motions::<f32>(&mut sum);
    for batch in Batch::levels() {
        eprintln!("{batch}");
    }
    println!("{} models: {:016x}", of_models.len(), sum.0);
    if wrong == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
