//! The derivatives as comma-separated values.

use super::names;
use crate::sensitivity::Changes;

/// One row a parameter, in the order of the model, under a header with the units. Each critical speed has two columns: its
/// change by 1 % of the parameter, and its derivative. A cell is empty where there is nothing.
pub fn csv(changes: &Changes) -> String {
    let info = changes.design.info();
    let mut header = ["parameter", "unit", "value", "standard deviation", "1 %"].map(str::to_owned).to_vec();
    let names = names(changes);
    for name in &names {
        header.extend([format!("{name} by 1 % (m/s)"), format!("{name} derivative (m/s per unit)")]);
    }
    let mut lines = vec![header];
    let values = changes.design.values();
    for (index, parameter) in info.parameters.iter().enumerate() {
        let deviation = changes.deviations.as_ref().map(|deviations| deviations[index]);
        let mut line = vec![
            parameter.name.to_owned(),
            parameter.unit.to_owned(),
            number(values[index]),
            optional(deviation.filter(|&deviation| deviation > 0.0)),
            optional(changes.steps[index].size()),
        ];
        for critical in &changes.critical_speeds {
            let derivatives = critical.derivatives.as_ref().ok();
            line.push(optional(derivatives.and_then(|derivatives| changes.effect(derivatives, index))));
            line.push(optional(derivatives.map(|derivatives| derivatives.speed[index])));
        }
        lines.push(line);
    }
    lines.into_iter().map(|line| line.join(",") + "\n").collect()
}

fn optional(value: Option<f64>) -> String {
    value.map(number).unwrap_or_default()
}

/// Digits that read back to the same double.
fn number(value: f64) -> String {
    // Adding zero turns -0 into 0.
    format!("{:?}", value + 0.0)
}
