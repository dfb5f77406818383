//! Scheduled gains: a table for each input, and the eigenvalues of the closed loop.

use carvallo::Complex;
use carvallo_control::{Regulator, Schedule, Signal};
use carvallo_design::Design;
use carvallo_design::number::{fixed, shortest, unit};

use crate::output::typeset::{Cell, Column, Document, Table};

pub fn of_schedule(design: &Design, schedule: &Schedule) -> Document {
    let space = &schedule.regulators[0].space;
    let gains = space.inputs.iter().enumerate().map(|(input, signal)| gains(schedule, input, signal));
    super::about(design, gains.chain([eigenvalues(schedule)]).collect())
}

/// The gains of one input.
fn gains(schedule: &Schedule, input: usize, signal: &Signal) -> Table {
    // Of matrices without units a gain may have none, either.
    let state = |state: &Signal| match unit(&signal.unit_by(state)) {
        none if none.is_empty() => Column::right(state.name.clone()),
        unit => Column::right(format!("{} ({unit})", state.name)),
    };
    let states = schedule.regulators[0].space.states.iter().map(state);
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
    schedule.regulators[0].space.speed.map(|_| Column::right("v (m/s)"))
}

fn at(regulator: &Regulator) -> Option<Cell> {
    regulator.space.speed.map(|speed| Cell::number(shortest(speed)))
}
