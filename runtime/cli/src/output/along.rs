//! Stability along a parameter, for people.

use std::fmt::Write as _;

use carvallo::{Complex, CriticalKind, CriticalValue, ParameterRange, Verdict};
use carvallo_design::number::{fixed, shortest};
use carvallo_plot::analysis::along::{AlongAnalysis, AtValue};

use super::columns::width;
use super::table::{effect, write_heading};
use super::{FAINT, GOOD, HEADING};

/// Writing to a string cannot fail, so that the results of `write!` are dropped throughout.
pub fn render_along(analysis: &AlongAnalysis, rows: &[AtValue]) -> String {
    let AlongAnalysis { design, parameter, range, stability, .. } = analysis;
    let (name, in_unit) = (parameter.name, |value: f64| analysis.with_unit(value));
    let plain = |value: f64| shortest(analysis.shown(value));
    let mut text = String::new();
    write_heading(design, &mut text);
    let at = analysis.at_speed(", at ");
    let _ = writeln!(text, "\nAlong {name} from {} to {}{at}", in_unit(range[0]), in_unit(range[1]));
    let title = analysis.heading();
    let of = title.strip_prefix(name).unwrap_or_default();
    let _ = writeln!(text, "\n{HEADING}Critical values of {name}{HEADING:#}{of}");
    let values: Vec<String> = stability.critical_values.iter().map(|critical| plain(critical.value)).collect();
    let columns = width(&values, 20);
    for (critical, value) in stability.critical_values.iter().zip(&values) {
        let at = critical_eigenvalue(critical);
        let change = effect(critical.change, stability.verdicts_around(critical));
        let kind = analysis.name(critical).replace('_', " ");
        let _ = writeln!(text, "  {kind:<13}{value:<columns$}{FAINT}{change}, at λ = {at}{FAINT:#}");
    }
    if values.is_empty() {
        let _ = writeln!(text, "  none");
    }
    for ParameterRange { from, to } in &stability.undecided {
        let (from, to) = (plain(*from), in_unit(*to));
        let _ = writeln!(text, "  from {from} to {to} one may be missing: rounding decides there");
    }
    for ParameterRange { from, to } in &stability.stable_ranges {
        let _ = writeln!(text, "  {GOOD}stable from {} to {}{GOOD:#}", plain(*from), in_unit(*to));
    }
    if stability.stable_ranges.is_empty() {
        let _ = writeln!(text, "  stable at no value");
    }
    let _ = writeln!(text, "\n{HEADING}Eigenvalues{HEADING:#} (1/s)");
    let values: Vec<String> = rows.iter().map(|row| plain(row.value)).collect();
    let first = width(values.iter().chain([&title]), 9);
    let _ = writeln!(text, "{FAINT}{title:>first$}{FAINT:#}");
    for (row, value) in rows.iter().zip(&values) {
        let style = if row.verdict == Verdict::Stable { GOOD } else { anstyle::Style::new() };
        let entries = row.eigenvalues.iter().filter(|value| value.im <= 0.0).map(entry);
        let entries = entries.collect::<Vec<_>>().join(", ");
        let _ = writeln!(text, "{style}{value:>first$}  {:<9} {entries}{style:#}", row.verdict.to_string());
    }
    text
}

/// The eigenvalue, or the pair, at a critical value.
pub fn critical_eigenvalue(critical: &CriticalValue) -> String {
    match critical.kind {
        CriticalKind::Capsize => "0".to_owned(),
        _ => format!("±{} i", fixed(critical.eigenvalue.im, 4)),
    }
}

/// Pairs stand where their half with the negative imaginary part does.
pub fn entry(value: &Complex<f64>) -> String {
    let re = fixed(value.re, 4);
    if value.im < 0.0 { format!("{re} ± {} i", fixed(-value.im, 4)) } else { re }
}
