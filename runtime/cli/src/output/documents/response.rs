//! A response in time, in a table.

use carvallo_control::Signal;
use carvallo_design::number::{fixed, unit};
use carvallo_plot::analysis::response::Responses;

use super::state_space::at;
use crate::output::motion::time;
use crate::output::typeset::{Cell, Column, Document, Table};

/// Outputs at each time; angles and their rates are in degrees.
pub fn of_responses(responses: &Responses) -> Document {
    let Responses { design, space, response, .. } = responses;
    let columns = space.outputs.iter().map(|signal| match shown(signal).0 {
        unit if unit.is_empty() => Column::right(&signal.name),
        unit => Column::right(format!("{} ({unit})", signal.name)),
    });
    let cell = |(signal, value): (&Signal, &f64)| {
        let value = shown(signal).1 * value;
        Cell::number(if value == 0.0 { "0.000000".to_owned() } else { fixed(value, 6) })
    };
    let row = |(moment, values): (&f64, &Vec<f64>)| {
        std::iter::once(Cell::number(time(*moment))).chain(space.outputs.iter().zip(values).map(cell)).collect()
    };
    let table = Table {
        title: format!("{}{}", responses.title(), at(space)),
        columns: std::iter::once(Column::right("t (s)")).chain(columns).collect(),
        rows: response.times.iter().zip(&response.outputs).map(row).collect(),
        notes: Vec::new(),
    };
    super::about(design, vec![table])
}

/// The unit that an output is shown in, and what its values are multiplied with.
fn shown(signal: &Signal) -> (String, f64) {
    match signal.unit.strip_prefix("rad") {
        Some(rest) => (format!("°{}", unit(rest)), 1_f64.to_degrees()),
        None => (unit(&signal.unit), 1.0),
    }
}
