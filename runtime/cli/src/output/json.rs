//! An analysis as JSON; its form is documented in `docs/json.md`, and stays.
//!
//! Numbers are written with the fewest digits that read back to the same double.

use carvallo::{Complex, CriticalSpeed, ModeValue, StableRange};

use super::equations::{Matrix, matrices};
use super::quoted;
use crate::analysis::{Analysis, Eigenvalues, Row, Rows};

pub fn json(analysis: &Analysis, rows: &Rows) -> String {
    let Analysis { design, .. } = analysis;
    let info = design.info();
    let parameters = info.parameters.iter().zip(&design.parameters);
    let parameters = parameters.map(|(info, given)| format!("    {}: {:?}", quoted(info.name), given.value));
    let matrices = matrices(design).into_iter().map(|Matrix { name, rows, .. }| {
        let rows = rows.iter().map(|row| list(row.iter().map(|value| format!("{value:?}"))));
        format!("    {}: {}", quoted(name), list(rows))
    });
    let rows: Vec<String> = match rows {
        Rows::Modes(rows) => rows.iter().map(modes).collect(),
        Rows::Sorted(rows) => rows.iter().map(|row| sorted(row, design.model.depends_on_speed())).collect(),
    };
    let (critical, ranges) = match &analysis.stability {
        Some(stability) => (
            lines('[', stability.critical_speeds.iter().map(critical), ']'),
            lines('[', stability.stable_ranges.iter().map(range), ']'),
        ),
        None => ("null".to_owned(), "null".to_owned()),
    };
    format!(
        "{{\n  \"model\": {},\n  \"{}\": {},\n  \"parameters\": {},\n  \"matrices\": {},\n  \
         \"critical_speeds\": {critical},\n  \"stable_ranges\": {ranges},\n  \"eigenvalues\": {}\n}}\n",
        quoted(info.name),
        if design.model.is_whipple() { "bicycle" } else { "name" },
        quoted(&design.name),
        lines('{', parameters, '}'),
        lines('{', matrices, '}'),
        lines('[', rows, ']'),
    )
}

fn critical(CriticalSpeed { kind, speed, eigenvalue, change, .. }: &CriticalSpeed) -> String {
    format!(
        "    {{\"kind\": \"{kind}\", \"speed\": {speed:?}, \"eigenvalue\": {{\"re\": {:?}, \"im\": {:?}}}, \"change\": \
         \"{change}\"}}",
        eigenvalue.re, eigenvalue.im,
    )
}

fn range(StableRange { from, to }: &StableRange) -> String {
    match to {
        Some(to) => format!("    [{from:?}, {to:?}]"),
        None => format!("    [{from:?}, null]"),
    }
}

fn modes(Row { speed, values }: &Row<[ModeValue; 4]>) -> String {
    let value = |ModeValue { mode, value }: &ModeValue| format!("{{{}, \"mode\": \"{mode}\"}}", parts(value));
    format!("    {{\"speed\": {speed:?}, \"values\": {}}}", list(values.iter().map(value)))
}

fn sorted(Row { speed, values: Eigenvalues { values, verdict } }: &Row<Eigenvalues>, moves: bool) -> String {
    let speed = if moves { format!("{speed:?}") } else { "null".to_owned() };
    let values = list(values.iter().map(|value| format!("{{{}}}", parts(value))));
    format!("    {{\"speed\": {speed}, \"verdict\": \"{verdict}\", \"values\": {values}}}")
}

fn parts(value: &Complex<f64>) -> String {
    format!("\"re\": {:?}, \"im\": {:?}", value.re, value.im)
}

/// An array on one line.
pub fn list(items: impl Iterator<Item = String>) -> String {
    format!("[{}]", items.collect::<Vec<_>>().join(", "))
}

/// An array or object with one item a line.
pub fn lines(open: char, items: impl IntoIterator<Item = String>, close: char) -> String {
    let items: Vec<String> = items.into_iter().collect();
    if items.is_empty() { format!("{open}{close}") } else { format!("{open}\n{}\n  {close}", items.join(",\n")) }
}
