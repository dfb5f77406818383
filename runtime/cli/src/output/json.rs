//! An analysis as JSON; its form is documented in `docs/json.md`, and stays.
//!
//! Numbers are written with the fewest digits that read back to the same double.

use carvallo::{CriticalSpeed, ModeValue, StableRange};

use super::{matrices, quoted};
use crate::analysis::{Analysis, Row};

pub fn json(analysis: &Analysis, rows: &[Row]) -> String {
    let Analysis { bicycle, coefficients, stability, .. } = analysis;
    let info = bicycle.info();
    let parameters = info.parameters.iter().zip(&bicycle.parameters);
    let parameters = parameters.map(|(info, given)| format!("    {}: {:?}", quoted(info.name), given.value));
    let matrices = matrices(coefficients)
        .map(|(name, _, [[a, b], [c, d]])| format!("    {}: [[{a:?}, {b:?}], [{c:?}, {d:?}]]", quoted(name)));
    let rows = rows.iter().map(|Row { speed, values }| {
        let values: Vec<String> = values.iter().map(eigenvalue).collect();
        format!("    {{\"speed\": {speed:?}, \"values\": [{}]}}", values.join(", "))
    });
    let ranges = stability.stable_ranges.iter().map(|StableRange { from, to }| match to {
        Some(to) => format!("    [{from:?}, {to:?}]"),
        None => format!("    [{from:?}, null]"),
    });
    let critical = stability.critical_speeds.iter().map(critical);
    format!(
        "{{\n  \"model\": {},\n  \"bicycle\": {},\n  \"parameters\": {},\n  \"matrices\": {},\n  \
         \"critical_speeds\": {},\n  \"stable_ranges\": {},\n  \"eigenvalues\": {}\n}}\n",
        quoted(info.name),
        quoted(&bicycle.name),
        lines('{', parameters, '}'),
        lines('{', matrices, '}'),
        lines('[', critical, ']'),
        lines('[', ranges, ']'),
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

fn eigenvalue(ModeValue { mode, value }: &ModeValue) -> String {
    format!("{{\"re\": {:?}, \"im\": {:?}, \"mode\": \"{mode}\"}}", value.re, value.im)
}

/// An array or object with one item a line.
fn lines(open: char, items: impl IntoIterator<Item = String>, close: char) -> String {
    let items: Vec<String> = items.into_iter().collect();
    if items.is_empty() { format!("{open}{close}") } else { format!("{open}\n{}\n  {close}", items.join(",\n")) }
}
