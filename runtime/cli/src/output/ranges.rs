//! The speeds at which motions die away, and those at which they neither grow nor die away, in sentences.

use std::fmt::Write as _;

use carvallo::{Stability, UndecidedRange};
use carvallo_design::number::shortest;

use super::GOOD;

/// Writing to a string cannot fail, so that the results of `write!` are dropped throughout.
pub fn write_ranges(stability: &Stability, text: &mut String) {
    let marginal = stability.marginal_ranges();
    for range in &stability.stable_ranges {
        let _ = writeln!(text, "  {GOOD}self-stable {}{GOOD:#}", between(range.from, range.to));
    }
    for range in &marginal {
        let _ = writeln!(text, "  marginal {}: it neither falls nor comes to rest", between(range.from, range.to));
    }
    if stability.stable_ranges.is_empty() && marginal.is_empty() {
        let _ = writeln!(text, "  stable by itself at no speed");
    }
}

fn between(from: f64, to: Option<f64>) -> String {
    match to {
        Some(to) => format!("from {} to {} m/s", shortest(from), shortest(to)),
        None => format!("above {} m/s", shortest(from)),
    }
}

/// Where a critical speed may be missing.
pub fn write_undecided(stability: &Stability, text: &mut String) {
    for UndecidedRange { from, to } in &stability.undecided {
        let (from, to) = (shortest(*from), shortest(*to));
        let _ = writeln!(text, "  from {from} to {to} m/s one may be missing: rounding decides there");
    }
}
