//! Held against numbers from outside: what each was made with stands beside it.

mod files;
mod frequency_responses;
mod modal;
mod regulators;
mod responses;
mod sensitivities;
mod state_spaces;
mod transfer_functions;
mod transmission;

use carvallo_design::Design;
use carvallo_design::input::{self, Request};
use nalgebra::DMatrix;

use crate::{Output, Ports, StateSpace};

/// A parameter set of a model.
fn design(model: &str, set: &str) -> Design {
    let request = Request { model: Some(model.to_owned()), parameters: Some(set.to_owned()), ..Request::default() };
    input::load(&request).expect("a design that ships")
}

fn benchmark() -> Design {
    design("Whipple", "benchmark")
}

fn state_space(design: &Design, speed: f64, inputs: &[&str], outputs: &[&str]) -> StateSpace {
    let ports = Ports::of(design);
    let inputs: Vec<usize> = inputs.iter().map(|name| ports.input(name).expect("an input")).collect();
    let outputs: Vec<Output> = outputs.iter().map(|name| ports.output(name).expect("an output")).collect();
    StateSpace::new(design, speed, &inputs, &outputs).expect("a state space")
}

/// Whether entries differ by no more than a share of the largest of their row.
#[track_caller]
fn assert_rows(found: &DMatrix<f64>, expected: &[&[f64]], share: f64) {
    assert_eq!(found.nrows(), expected.len(), "{found}");
    for (row, expected) in found.row_iter().zip(expected) {
        assert_eq!(row.len(), expected.len(), "{found}");
        let largest = expected.iter().fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
        for (found, expected) in row.iter().zip(*expected) {
            assert!((found - expected).abs() <= share * largest, "{found} is not {expected}, in {row}");
        }
    }
}
