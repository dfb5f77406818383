//! The batches that are counted: of the same bicycle in every lane.

use std::hint::black_box;

use carvallo::batch::{Batch, Blocks, InLanes};
use carvallo::{Model, Stability};
use carvallo_models::{Whipple, WhippleMechanism};

/// Designs in a batch.
pub const DESIGNS: usize = 64;

/// A batch by these instructions, if the processor has them.
pub fn of_level(level: &str) -> Option<Batch> {
    Batch::levels().find(|batch| batch.to_string().starts_with(level))
}

/// From blocks.
pub fn blocks(calls: usize, level: &str) -> Option<()> {
    let batch = of_level(level)?;
    let parameters = Blocks::of_designs(&[WhippleMechanism::BENCHMARK; DESIGNS]);
    let mut entries = Blocks::for_entries::<2, WhippleMechanism>(DESIGNS);
    for _ in 0..calls / DESIGNS {
        let done = batch.matrices::<2, WhippleMechanism>(black_box(&parameters), black_box(&mut entries));
        done.expect("blocks that fit");
    }
    Some(())
}

/// From a slice of structs into another.
pub fn structs<T: InLanes>(calls: usize, level: &str, design: WhippleMechanism<T>) -> Option<()> {
    let batch = of_level(level)?;
    let designs = [design; DESIGNS];
    let mut coefficients = [design.coefficients(); DESIGNS];
    for _ in 0..calls / DESIGNS {
        let done = batch.coefficients(black_box(&designs), black_box(&mut coefficients));
        done.expect("slices of equal length");
    }
    Some(())
}

/// From columns into columns.
pub fn columns(calls: usize, level: &str) -> Option<()> {
    let batch = of_level(level)?;
    let parameters = WhippleMechanism::BENCHMARK.to_array().map(|parameter| [parameter; DESIGNS]);
    let parameters = parameters.each_ref().map(<[f64; DESIGNS]>::as_slice);
    let mut entries = vec![[0.0; DESIGNS]; WhippleMechanism::<f64>::INFO.entries.len()];
    let mut entries: Vec<&mut [f64]> = entries.iter_mut().map(<[f64; DESIGNS]>::as_mut_slice).collect();
    for _ in 0..calls / DESIGNS {
        let done = batch.matrices_of_columns::<2, WhippleMechanism>(black_box(&parameters), black_box(&mut entries));
        done.expect("columns that fit");
    }
    Some(())
}

/// Each block of which is forgotten.
pub fn jacobians(calls: usize, level: &str) -> Option<()> {
    let batch = of_level(level)?;
    let parameters = Blocks::of_designs(&[WhippleMechanism::BENCHMARK; DESIGNS]);
    for _ in 0..calls / DESIGNS {
        let done = batch.each_jacobian::<2, WhippleMechanism>(black_box(&parameters), |portion| {
            black_box(&portion);
        });
        done.expect("blocks that fit");
    }
    Some(())
}

/// Rates of positions and speeds of one bicycle that rolls upright.
pub fn rates(calls: usize, level: &str) -> Option<()> {
    let batch = of_level(level)?;
    let parameters = Blocks::of_designs(&[WhippleMechanism::BENCHMARK]);
    let mut states = Blocks::for_states::<2, WhippleMechanism>(DESIGNS);
    (0..DESIGNS).for_each(|state| states.set(state, 10, -10.0));
    let mut derivatives = Blocks::for_motion_derivatives::<2, WhippleMechanism>(DESIGNS);
    for _ in 0..calls / DESIGNS {
        let states = black_box(&states);
        let done = batch.motion_derivatives::<2, WhippleMechanism>(&parameters, states, black_box(&mut derivatives));
        done.expect("blocks that fit");
    }
    Some(())
}

/// Of matrices that are there.
pub fn critical_speeds(calls: usize, level: &str) -> Option<()> {
    let batch = of_level(level)?;
    let (coefficients, gravity) = ([Whipple::BENCHMARK.coefficients(); DESIGNS], [Whipple::BENCHMARK.g; DESIGNS]);
    let mut found = vec![Stability::new(&coefficients[0], gravity[0]); DESIGNS];
    for _ in 0..calls / DESIGNS {
        let done = batch.stability(black_box(&coefficients), &gravity, black_box(&mut found));
        done.expect("slices of equal length");
    }
    Some(())
}
