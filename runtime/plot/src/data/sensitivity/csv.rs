//! The derivatives as comma-separated values.

use std::io::{Result, Write};

use super::name_critical_speeds;
use crate::analysis::sensitivity::Changes;
use crate::data::cells::{exact, write_rows};

/// One row a parameter, in the order of the model, under a header with the units. Each critical speed has two columns: its
/// change by 1 % of the parameter, and its derivative. A cell is empty where there is nothing.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(changes: &Changes, output: &mut dyn Write) -> Result<()> {
    let mut header = ["parameter", "unit", "value", "standard deviation", "1 %"].map(str::to_owned).to_vec();
    let speed = changes.of_speeds().written;
    for name in name_critical_speeds(changes) {
        header.extend([format!("{name} by 1 % ({speed})"), format!("{name} derivative ({speed} per unit)")]);
    }
    let rows = (0..changes.steps.len()).map(|parameter| row(changes, parameter));
    write_rows(std::iter::once(header).chain(rows), output)
}

fn row(changes: &Changes, parameter: usize) -> Vec<String> {
    let info = &changes.design.info().parameters[parameter];
    let (unit, speed) = (changes.of_parameter(parameter), changes.of_speeds());
    let deviation = changes.deviations.as_ref().map(|deviations| deviations[parameter]);
    let mut row = vec![
        info.name.to_owned(),
        unit.written.clone(),
        number(unit.value(changes.design.parameters[parameter].value)),
        optional(deviation.filter(|&deviation| deviation > 0.0).map(|deviation| unit.value(deviation))),
        optional(changes.steps[parameter].size().map(|step| unit.value(step))),
    ];
    for critical in &changes.critical_speeds {
        let derivatives = critical.derivatives.as_ref().ok();
        row.push(optional(
            derivatives.and_then(|derivatives| changes.effect(derivatives, parameter)).map(|own| speed.value(own)),
        ));
        let derivative = derivatives.map(|derivatives| speed.value(derivatives.speed[parameter]) / unit.value(1.0));
        row.push(optional(derivative));
    }
    row
}

fn optional(value: Option<f64>) -> String {
    value.map(number).unwrap_or_default()
}

fn number(value: f64) -> String {
    // Adding zero turns -0 into 0.
    exact(value + 0.0)
}
