//! The ranking for people, at a terminal.

use std::fmt::Write as _;

use carvallo::CriticalKind;
use carvallo_design::number::{fixed, shortest};
use carvallo_plot::analysis::sensitivity::{Changes, Step, decides};
use carvallo_plot::analysis::{kind, name};

use super::deviations::write_deviations;
use crate::output::columns::width;
use crate::output::ranges::{write_ranges, write_undecided};
use crate::output::table::{describe_effect, write_heading};
use crate::output::{FAINT, HEADING};

/// What the ranking is of.
pub const RANKING: &str = "What 1 % of a parameter changes";

/// What else it has, in the unit that speeds are shown in.
pub fn ranking_more(changes: &Changes) -> String {
    format!("and the derivative ({} per unit); the largest effect first", changes.of_speeds().unit())
}

/// Writing to a string cannot fail, so that the results of `write!` are dropped throughout.
pub fn render_table(changes: &Changes) -> String {
    let mut text = String::new();
    write_heading(&changes.design, &mut text);
    write_critical_speeds(changes, &mut text);
    if !changes.ranked().is_empty() {
        write_ranking(changes, &mut text);
    }
    if changes.deviations.is_some() {
        write_deviations(changes, &mut text);
    }
    text
}

/// The weave and capsize speeds, and that there is none, or none that can be ranked by.
fn write_critical_speeds(changes: &Changes, text: &mut String) {
    let info = changes.design.info();
    let [weave, capsize] = [CriticalKind::Weave, CriticalKind::Capsize].map(|of| kind(of, info));
    let first = weave[..1].to_uppercase() + &weave[1..];
    let speed = changes.of_speeds();
    let _ = writeln!(text, "\n{HEADING}{first} and {capsize} speeds{HEADING:#} ({})", speed.unit());
    let none = |kind: CriticalKind| !changes.critical_speeds.iter().any(|critical| critical.speed.kind == kind);
    let all = changes.critical_speeds.iter().filter(|critical| decides(&critical.speed));
    let values: Vec<String> = all.clone().map(|critical| shortest(speed.value(critical.speed.speed))).collect();
    let column = width(&values, 20);
    for (critical, value) in all.zip(&values) {
        let reason = critical.derivatives.as_ref().err();
        let reason = reason.map(|reason| format!("; not ranked: {reason}")).unwrap_or_default();
        let kind = name(&critical.speed, info).replace('_', " ");
        let effect = describe_effect(&changes.stability, &critical.speed);
        let _ = writeln!(text, "  {kind:<13}{value:<column$}{FAINT}{effect}{reason}{FAINT:#}");
    }
    for (kind, meaning) in [(CriticalKind::Weave, weave), (CriticalKind::Capsize, capsize)] {
        if none(kind) {
            let reason =
                if changes.stability.undecided.is_empty() { "there is no such speed" } else { "none was found" };
            let _ = writeln!(text, "  {meaning:<13}{:<column$}{FAINT}{reason}{FAINT:#}", "-");
        }
    }
    write_undecided(&changes.stability, &speed, text);
    write_ranges(&changes.stability, &speed, text);
}

/// The columns of the ranking, each with its heading and a line for every parameter that has an effect: names, values, what 1 %
/// is, units, and behind them for each ranked speed the effect and the derivative.
pub fn ranking(changes: &Changes) -> Vec<(String, Vec<String>)> {
    let (info, ranked, order) = (changes.design.info(), changes.ranked(), changes.order());
    let signed = |value: f64, decimals: usize| {
        if value == 0.0 {
            return "0".to_owned();
        }
        let sign = if value >= 0.0 { "+" } else { "" };
        format!("{sign}{}", fixed(value, decimals))
    };
    // The header and the lines of each column.
    let lines =
        |cell: &dyn Fn(usize) -> String| order.iter().map(|&parameter| cell(parameter)).collect::<Vec<String>>();
    let values = changes.design.values();
    let speed = changes.of_speeds();
    let shown = |i: usize, value: f64| changes.of_parameter(i).value(value);
    let mut columns = vec![
        (String::new(), lines(&|i| info.parameters[i].name.to_owned())),
        ("value".to_owned(), lines(&|i| shortest(changes.of_parameter(i).value(values[i])))),
        (
            "1 % is".to_owned(),
            lines(&|i| match changes.steps[i] {
                Step::OfValue(step) => signed(shown(i, step), 6),
                Step::OfScale(step) => format!("*{}", signed(shown(i, step), 6)),
                Step::Unknown => "-".to_owned(),
            }),
        ),
        ("unit".to_owned(), lines(&|i| changes.of_parameter(i).unit())),
    ];
    for (critical, derivatives) in &ranked {
        let kind = name(critical, changes.design.info()).replace('_', " ");
        let name = format!("{kind} {}", fixed(speed.value(critical.speed), 4));
        let effect = |i| changes.effect(derivatives, i).map_or("-".to_owned(), |effect| signed(speed.value(effect), 6));
        columns.push((name, lines(&effect)));
        columns.push(("per unit".to_owned(), lines(&|i| signed(speed.value(derivatives.speed[i]) / shown(i, 1.0), 6))));
    }
    columns
}

/// What stands below the ranking.
pub fn notes(changes: &Changes) -> Vec<String> {
    let (info, order) = (changes.design.info(), changes.order());
    let mut notes = Vec::new();
    let others = (0..info.parameters.len()).filter(|i| !order.contains(i));
    let without: Vec<&str> = others.map(|i| info.parameters[i].name).collect();
    if changes.are_entries() {
        notes.push("each entry by itself; the derivatives by entries that are zero are in CSV and JSON".to_owned());
    } else if !without.is_empty() {
        notes.push(format!("without effect: {}", without.join(", ")));
    }
    if order.iter().any(|&i| matches!(changes.steps[i], Step::OfScale(_))) {
        notes.push(
            "* zero itself, so 1 % of the median size of the others in the same unit; of an angle, of a radian"
                .to_owned(),
        );
    }
    if order.iter().any(|&i| changes.steps[i] == Step::Unknown) {
        notes.push("- zero, as all others in the same unit are: there is only the derivative".to_owned());
    }
    notes
}

fn write_ranking(changes: &Changes, text: &mut String) {
    let _ =
        writeln!(text, "\n{HEADING}{RANKING}{HEADING:#} ({}), {}", changes.of_speeds().unit(), ranking_more(changes));
    let columns = ranking(changes);
    let widths: Vec<usize> = columns.iter().map(|(header, lines)| width(lines.iter().chain([header]), 8)).collect();
    let row = |cell: &dyn Fn(usize) -> String| {
        let mut line = String::new();
        for (column, width) in widths.iter().enumerate() {
            let cell = cell(column);
            // Names and units begin below each other, numbers end so.
            let _ = match column {
                0 => write!(line, "  {cell:<width$}"),
                3 => write!(line, "  {cell:<0$}", width - 2),
                _ => write!(line, "{cell:>width$}"),
            };
        }
        line.trim_end().to_owned()
    };
    let _ = writeln!(text, "{FAINT}{}{FAINT:#}", row(&|column| columns[column].0.clone()));
    for index in 0..columns[0].1.len() {
        let _ = writeln!(text, "{}", row(&|column| columns[column].1[index].clone()));
    }
    for note in notes(changes) {
        let _ = writeln!(text, "  {note}");
    }
}
