//! A state space as comma-separated values.

use std::io::{Result, Write};

use carvallo::nalgebra::DMatrix;
use carvallo_control::{Signal, StateSpace};

use crate::data::cells::{exact, write_rows};

/// The rows of A and B, named by the derivatives of the states, and those of C and D, named by the outputs, under a header with
/// the states and the inputs, all with their units.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(space: &StateSpace, output: &mut dyn Write) -> Result<()> {
    let named = |signal: &Signal| format!("{} ({})", signal.name, signal.unit);
    let columns = space.states.iter().chain(&space.inputs).map(named);
    let header = std::iter::once("of".to_owned()).chain(columns).collect();
    let rows = |signals: Vec<Signal>, left: &DMatrix<f64>, right: &DMatrix<f64>| -> Vec<Vec<String>> {
        let of_row = |(index, signal): (usize, &Signal)| {
            let entries =
                left.row(index).iter().chain(right.row(index).iter()).map(|entry| exact(*entry)).collect::<Vec<_>>();
            std::iter::once(named(signal)).chain(entries).collect()
        };
        signals.iter().enumerate().map(of_row).collect()
    };
    let derivatives = rows(space.states.iter().map(Signal::derivative).collect(), &space.a, &space.b);
    let outputs = rows(space.outputs.clone(), &space.c, &space.d);
    write_rows(std::iter::once(header).chain(derivatives).chain(outputs), output)
}
