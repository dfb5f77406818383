//! The shipped bicycles at a glance.

use std::fmt::Write as _;

use carvallo::{CriticalKind, StableRange};
use carvallo_design::DisplayUnit;
use carvallo_plot::analysis::Analysis;

use super::{FAINT, GOOD, HEADING};

pub fn render_bicycles(analyses: &[Analysis], unit: &DisplayUnit) -> String {
    let headings = ["weave", "capsize", "stable"].map(|what| format!("{what} ({})", unit.written));
    let mut text =
        format!("{HEADING}{:<17}{:<17}{:<17}{:<21}kind{HEADING:#}\n", "bicycle", headings[0], headings[1], headings[2]);
    for analysis in analyses {
        let style = if analysis.stable_ranges().is_empty() { FAINT } else { GOOD };
        let kind = analysis.design.kind.as_deref().unwrap_or_default();
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{:<17}{:<17}{:<17}{style}{:<21}{style:#}{kind}",
            analysis.design.name,
            speeds(analysis, CriticalKind::Weave, unit),
            speeds(analysis, CriticalKind::Capsize, unit),
            ranges(analysis.stable_ranges(), unit),
        );
    }
    text
}

/// The critical speeds of a kind.
pub fn speeds(analysis: &Analysis, kind: CriticalKind, unit: &DisplayUnit) -> String {
    let speeds = analysis.critical_speeds().iter().filter(|critical| critical.kind == kind);
    joined(speeds.map(|critical| format!("{:.4}", unit.value(critical.speed))))
}

/// Stable ranges, side by side.
pub fn ranges(ranges: &[StableRange], unit: &DisplayUnit) -> String {
    joined(ranges.iter().map(|StableRange { from, to }| match to {
        Some(to) => format!("{:.4} to {:.4}", unit.value(*from), unit.value(*to)),
        None => format!("above {:.4}", unit.value(*from)),
    }))
}

/// A dash says that there is none.
fn joined(items: impl Iterator<Item = String>) -> String {
    let items: Vec<String> = items.collect();
    if items.is_empty() { "-".to_owned() } else { items.join(", ") }
}
