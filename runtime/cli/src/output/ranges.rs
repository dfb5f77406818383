//! The speeds at which motions die away, and those at which they neither grow nor die away, in sentences.

use std::fmt::Write as _;

use anstyle::Style;
use carvallo::{Stability, UndecidedRange};
use carvallo_design::number::shortest;

use super::GOOD;

/// Each as a line; those of stable ranges in their style.
///
/// Writing to a string cannot fail, so that the results of `write!` are dropped throughout.
pub fn write_ranges(stability: &Stability, text: &mut String) {
    for (is_stable, sentence) in ranges(stability) {
        let style = if is_stable { GOOD } else { Style::new() };
        let _ = writeln!(text, "  {style}{sentence}{style:#}");
    }
}

/// A sentence for each range, and whether it is stable there; or that there is none.
pub fn ranges(stability: &Stability) -> Vec<(bool, String)> {
    let marginal = stability.marginal_ranges();
    let stable =
        stability.stable_ranges.iter().map(|range| (true, format!("self-stable {}", between(range.from, range.to))));
    let neither = marginal.iter().map(|range| {
        (false, format!("marginal {}: it neither falls nor comes to rest", between(range.from, range.to)))
    });
    let mut sentences: Vec<(bool, String)> = stable.chain(neither).collect();
    if sentences.is_empty() {
        sentences.push((false, "stable by itself at no speed".to_owned()));
    }
    sentences
}

fn between(from: f64, to: Option<f64>) -> String {
    match to {
        Some(to) => format!("from {} to {} m/s", shortest(from), shortest(to)),
        None => format!("above {} m/s", shortest(from)),
    }
}

/// Where a critical speed may be missing.
pub fn write_undecided(stability: &Stability, text: &mut String) {
    for sentence in undecided(stability) {
        let _ = writeln!(text, "  {sentence}");
    }
}

/// The same in sentences.
pub fn undecided(stability: &Stability) -> Vec<String> {
    let sentence = |UndecidedRange { from, to }: &UndecidedRange| {
        let (from, to) = (shortest(*from), shortest(*to));
        format!("from {from} to {to} m/s one may be missing: rounding decides there")
    };
    stability.undecided.iter().map(sentence).collect()
}
