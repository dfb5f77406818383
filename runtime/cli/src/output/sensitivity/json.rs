//! The derivatives as JSON; its form is documented in `docs/sensitivity.md`, and stays.
//!
//! Numbers are written with the fewest digits that read back to the same double.

use super::super::equations::{Matrix, matrices};
use super::super::json::{lines, list};
use super::super::quoted;
use crate::model::Equations;
use crate::sensitivity::{Changes, Critical, Derivatives};

pub fn json(changes: &Changes) -> String {
    let design = &changes.design;
    let info = design.info();
    let rows = |rows: &Vec<Vec<f64>>| list(rows.iter().map(|row| list(row.iter().map(number))));
    let matrices = matrices(design).into_iter();
    let matrices =
        matrices.map(|Matrix { name, rows: entries, .. }| format!("    {}: {}", quoted(name), rows(&entries)));
    let matrix_deviations = changes.matrix_deviations.as_ref().map(|known| {
        let known = known.matrices().into_iter().filter(|(name, _)| info.matrices.contains(name));
        lines('{', known.map(|(name, entries)| format!("    {}: {}", quoted(name.name()), rows(&entries))), '}')
    });
    let parameters = design.parameters.iter().zip(&changes.steps).map(|(given, step)| {
        let deviation = given.deviation.as_ref().map_or(0.0, |deviation| deviation.value);
        let step = step.size().as_ref().map_or("null".to_owned(), number);
        format!("{{\"value\": {:?}, \"std\": {deviation:?}, \"one_percent\": {step}}}", given.value)
    });
    let critical = changes.critical_speeds.iter().map(|critical| self::critical(changes, critical));
    format!(
        "{{\n  \"model\": {},\n  \"{}\": {},\n  \"parameters\": {},\n  \"critical_speeds\": {},\n  \"matrices\": {},\n  \"matrix_standard_deviations\": {}\n}}\n",
        quoted(info.name),
        if design.model.is_whipple() { "bicycle" } else { "name" },
        quoted(&design.name),
        by_parameter(changes, "  ", parameters),
        lines('[', critical, ']'),
        lines('{', matrices, '}'),
        matrix_deviations.unwrap_or("null".to_owned()),
    )
}

fn critical(changes: &Changes, Critical { speed, derivatives }: &Critical) -> String {
    let head = format!(
        "    {{\"kind\": \"{}\", \"speed\": {:?}, \"eigenvalue\": {}, \"change\": \"{}\",\n     ",
        speed.kind,
        speed.speed,
        parts(&speed.eigenvalue),
        speed.change
    );
    let derivatives = match derivatives {
        Ok(derivatives) => derivatives,
        Err(reason) => {
            return format!(
                "{head}\"derivatives\": null, \"eigenvalue_derivatives\": null, \"condition\": null, \
                 \"standard_deviation\": null, \"variance_shares\": null, \"not_differentiable\": {}}}",
                quoted(&reason.to_string())
            );
        }
    };
    let Derivatives { speed, eigenvalue, condition, deviation, variance_shares } = derivatives;
    format!(
        "{head}\"derivatives\": {},\n     \"eigenvalue_derivatives\": {},\n     \"condition\": {condition:?}, \
         \"standard_deviation\": {},\n     \"variance_shares\": {},\n     \"not_differentiable\": null}}",
        by_parameter(changes, "     ", speed.iter().map(number)),
        by_parameter(changes, "     ", eigenvalue.iter().map(parts)),
        deviation.as_ref().map_or("null".to_owned(), number),
        variance_shares.as_ref().map_or("null".to_owned(), |shares| by_parameter(
            changes,
            "     ",
            shares.iter().map(number)
        )),
    )
}

/// An object with a member for each parameter.
fn by_parameter(changes: &Changes, indent: &str, values: impl Iterator<Item = String>) -> String {
    let members = changes.design.info().parameters.iter().zip(values);
    let members: Vec<String> =
        members.map(|(info, value)| format!("{indent}  {}: {value}", quoted(info.name))).collect();
    format!("{{\n{}\n{indent}}}", members.join(",\n"))
}

fn parts(value: &carvallo::Complex<f64>) -> String {
    format!("{{\"re\": {}, \"im\": {}}}", number(&value.re), number(&value.im))
}

fn number(value: &f64) -> String {
    // Adding zero turns -0 into 0.
    format!("{:?}", value + 0.0)
}
