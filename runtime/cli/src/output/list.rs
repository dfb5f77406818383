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
        let speeds = |kind: CriticalKind| {
            let speeds = analysis.critical_speeds().iter().filter(|critical| critical.kind == kind);
            joined(speeds.map(|critical| format!("{:.4}", critical.speed)))
        };
        let stable = joined(analysis.stable_ranges().iter().map(|StableRange { from, to }| match to {
            Some(to) => format!("{from:.4} to {to:.4}"),
            None => format!("above {from:.4}"),
        }));
        let style = if analysis.stable_ranges().is_empty() { FAINT } else { GOOD };
        let kind = analysis.design.kind.as_deref().unwrap_or_default();
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{:<17}{:<17}{:<17}{style}{stable:<21}{style:#}{kind}",
            analysis.design.name,
            speeds(CriticalKind::Weave),
            speeds(CriticalKind::Capsize),
        );
    }
    text
}

/// A dash says that there is none.
fn joined(items: impl Iterator<Item = String>) -> String {
    let items: Vec<String> = items.collect();
    if items.is_empty() { "-".to_owned() } else { items.join(", ") }
}
