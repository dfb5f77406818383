//! The speeds at which motions die away, and those at which they neither grow nor die away, in sentences.

use std::fmt::Write as _;

use anstyle::Style;
use carvallo::{Stability, UndecidedRange};
use carvallo_design::DisplayUnit;
use carvallo_design::number::shortest;

use super::GOOD;

/// Each as a line; those of stable ranges in their style.
///
/// Writing to a string cannot fail, so that the results of `write!` are dropped throughout.
pub fn write_ranges(stability: &Stability, unit: &DisplayUnit, text: &mut String) {
    for (is_stable, sentence) in ranges(stability, unit) {
        let style = if is_stable { GOOD } else { Style::new() };
        let _ = writeln!(text, "  {style}{sentence}{style:#}");
    }
}

/// A sentence for each range, and whether it is stable there; or that there is none.
pub fn ranges(stability: &Stability, unit: &DisplayUnit) -> Vec<(bool, String)> {
    let marginal = stability.marginal_ranges();
    let stable = stability
        .stable_ranges
        .iter()
        .map(|range| (true, format!("self-stable {}", between(range.from, range.to, unit))));
    let neither = marginal.iter().map(|range| {
        (false, format!("marginal {}: it neither falls nor comes to rest", between(range.from, range.to, unit)))
    });
    let mut sentences: Vec<(bool, String)> = stable.chain(neither).collect();
    if sentences.is_empty() {
        sentences.push((false, "stable by itself at no speed".to_owned()));
    }
    sentences
}

fn between(from: f64, to: Option<f64>, unit: &DisplayUnit) -> String {
    let shown = |speed: f64| shortest(unit.value(speed));
    match to {
        Some(to) => format!("from {} to {} {}", shown(from), shown(to), unit.written),
        None => format!("above {} {}", shown(from), unit.written),
    }
}

/// Where a critical speed may be missing.
pub fn write_undecided(stability: &Stability, unit: &DisplayUnit, text: &mut String) {
    for sentence in undecided(stability, unit) {
        let _ = writeln!(text, "  {sentence}");
    }
}

/// The same in sentences.
pub fn undecided(stability: &Stability, unit: &DisplayUnit) -> Vec<String> {
    let sentence = |UndecidedRange { from, to }: &UndecidedRange| {
        let [from, to] = [*from, *to].map(|speed| shortest(unit.value(speed)));
        format!("from {from} to {to} {} one may be missing: rounding decides there", unit.written)
    };
    stability.undecided.iter().map(sentence).collect()
}
