//! The shipped bicycles at a glance.

use std::fmt::Write as _;

use carvallo::{CriticalKind, StableRange};
use carvallo_plot::analysis::Analysis;

use super::{FAINT, GOOD, HEADING};

pub fn render_bicycles(analyses: &[Analysis]) -> String {
    let mut text = format!(
        "{HEADING}{:<17}{:<17}{:<17}{:<21}kind{HEADING:#}\n",
        "bicycle", "weave (m/s)", "capsize (m/s)", "stable (m/s)"
    );
    for analysis in analyses {
        let style = if analysis.stable_ranges().is_empty() { FAINT } else { GOOD };
        let kind = analysis.design.kind.as_deref().unwrap_or_default();
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{:<17}{:<17}{:<17}{style}{:<21}{style:#}{kind}",
            analysis.design.name,
            speeds(analysis, CriticalKind::Weave),
            speeds(analysis, CriticalKind::Capsize),
            ranges(analysis.stable_ranges()),
        );
    }
    text
}

/// The critical speeds of a kind.
pub fn speeds(analysis: &Analysis, kind: CriticalKind) -> String {
    let speeds = analysis.critical_speeds().iter().filter(|critical| critical.kind == kind);
    joined(speeds.map(|critical| format!("{:.4}", critical.speed)))
}

/// Stable ranges, side by side.
pub fn ranges(ranges: &[StableRange]) -> String {
    joined(ranges.iter().map(|StableRange { from, to }| match to {
        Some(to) => format!("{from:.4} to {to:.4}"),
        None => format!("above {from:.4}"),
    }))
}

/// A dash says that there is none.
fn joined(items: impl Iterator<Item = String>) -> String {
    let items: Vec<String> = items.collect();
    if items.is_empty() { "-".to_owned() } else { items.join(", ") }
}
