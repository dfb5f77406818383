//! Scheduled gains: a table for each input, and the eigenvalues of the closed loop.

use carvallo::nalgebra::DMatrix;
use carvallo::{Complex, ParameterInfo};
use carvallo_control::{Regulator, Schedule, Signal};
use carvallo_design::number::{fixed, shortest, unit};
use carvallo_design::{Design, Given};

use crate::output::typeset::{Cell, Column, Document, Table};

/// With what 1 % of each parameter changes, if the derivatives of the gains of each regulator by parameter are given.
pub fn of_schedule(design: &Design, schedule: &Schedule, sensitivities: Option<&[Vec<DMatrix<f64>>]>) -> Document {
    let space = &schedule.regulators[0].space;
    let gains = space.inputs.iter().enumerate().map(|(input, signal)| gains(schedule, input, signal));
    let changes = sensitivities.into_iter().flat_map(|of| {
        let inputs = space.inputs.iter().enumerate();
        inputs.flat_map(move |(input, signal)| {
            let regulators = schedule.regulators.iter().zip(of);
            regulators.map(move |(own, by_parameter)| changes(design, own, by_parameter, input, signal))
        })
    });
    super::about(design, gains.chain([eigenvalues(schedule)]).chain(changes).collect())
}

/// What 1 % of each parameter changes about the gains of one input at one speed.
fn changes(design: &Design, own: &Regulator, by_parameter: &[DMatrix<f64>], input: usize, signal: &Signal) -> Table {
    let parameters = design.info().parameters.iter().zip(&design.parameters).zip(by_parameter);
    let row = |((info, given), by): ((&ParameterInfo, &Given), &DMatrix<f64>)| {
        let change = |by: &f64| match 0.01 * given.value.abs() * by {
            0.0 => Cell::number("0"),
            change => Cell::number(format!("{}{}", if change > 0.0 { "+" } else { "" }, fixed(change, 6))),
        };
        let name = Cell::Symbol { name: info.name.to_owned(), symbol: info.symbol.to_owned() };
        [name].into_iter().chain(by.row(input).iter().map(change)).collect()
    };
    let speed = own.space.speed_text().map(|speed| format!(", at {speed}")).unwrap_or_default();
    Table {
        title: format!("What 1 % of each parameter changes about the gains K of {}{speed}", signal.name),
        columns: [Column::left("parameter")]
            .into_iter()
            .chain(own.space.states.iter().map(|of| state(signal, of)))
            .collect(),
        rows: parameters.map(row).collect(),
        notes: Vec::new(),
    }
}

/// The heading of the gains by a state. Of matrices without units a gain may have none, either.
fn state(signal: &Signal, state: &Signal) -> Column {
    match unit(&signal.unit_by(state)) {
        none if none.is_empty() => Column::right(state.name.clone()),
        unit => Column::right(format!("{} ({unit})", state.name)),
    }
}

/// The gains of one input.
fn gains(schedule: &Schedule, input: usize, signal: &Signal) -> Table {
    let states = schedule.regulators[0].space.states.iter().map(|of| state(signal, of));
    let row = |own: &Regulator| {
        let gains = own.gains.row(input).iter().map(|gain| Cell::number(fixed(*gain, 6))).collect::<Vec<_>>();
        at(own).into_iter().chain(gains).collect()
    };
    Table {
        title: format!("Gains K of {} = -K x", signal.name),
        columns: speed(schedule).into_iter().chain(states).collect(),
        rows: schedule.regulators.iter().map(row).collect(),
        notes: Vec::new(),
    }
}

fn eigenvalues(schedule: &Schedule) -> Table {
    let value = |value: &Complex<f64>| match value.im {
        0.0 => Some(fixed(value.re, 4)),
        im if im > 0.0 => Some(format!("{} ± {} i", fixed(value.re, 4), fixed(im, 4))),
        _ => None,
    };
    let row = |own: &Regulator| {
        let values: Vec<String> = own.eigenvalues.iter().filter_map(value).collect();
        at(own).into_iter().chain([Cell::number(values.join(", "))]).collect()
    };
    Table {
        title: "Eigenvalues of the closed loop (1/s)".to_owned(),
        columns: speed(schedule).into_iter().chain([Column::left("λ")]).collect(),
        rows: schedule.regulators.iter().map(row).collect(),
        notes: Vec::new(),
    }
}

/// The column of speeds, where there are any.
fn speed(schedule: &Schedule) -> Option<Column> {
    let space = &schedule.regulators[0].space;
    space.speed.map(|_| Column::right(format!("v ({})", space.speed_unit.unit())))
}

fn at(regulator: &Regulator) -> Option<Cell> {
    regulator.space.shown_speed().map(|speed| Cell::number(shortest(speed)))
}
