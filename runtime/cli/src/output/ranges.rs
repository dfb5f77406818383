//! The speeds at which motions die away, and those at which they neither grow nor die away, in sentences.

use std::fmt::Write as _;
use std::iter;

use carvallo::{Stability, Verdict};

use super::GOOD;
use crate::number::shortest;

/// Writing to a string cannot fail, so that the results of `write!` are dropped throughout.
pub fn write_ranges(stability: &Stability, text: &mut String) {
    let marginal = marginal_ranges(stability);
    for range in &stability.stable_ranges {
        let _ = writeln!(text, "  {GOOD}self-stable {}{GOOD:#}", between(range.from, range.to));
    }
    for &(from, to) in &marginal {
        let _ = writeln!(text, "  marginal {}: it neither falls nor comes to rest", between(from, to));
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

/// Where motions neither grow nor decay, as those of a rolling disc above its critical speed; the second is `None` for a
/// range that has no end.
fn marginal_ranges(stability: &Stability) -> Vec<(f64, Option<f64>)> {
    // Between critical speeds the verdict does not change; without any, one speed tells of all.
    let critical = &stability.critical_speeds;
    let lowest = match critical.first() {
        Some(first) => stability.verdicts_around(first)[0] == Verdict::Marginal,
        None => stability.verdict(1.0) == Ok(Verdict::Marginal),
    };
    let is_marginal_above = |critical| stability.verdicts_around(critical)[1] == Verdict::Marginal;
    let above = critical.iter().map(|critical| (critical.speed, is_marginal_above(critical)));
    let mut ranges: Vec<(f64, Option<f64>)> = Vec::new();
    for (from, is_marginal) in iter::once((0.0, lowest)).chain(above) {
        let open = ranges.last_mut().filter(|(_, to)| to.is_none());
        match (open, is_marginal) {
            (None, true) => ranges.push((from, None)),
            (Some((_, to)), false) => *to = Some(from),
            // Real parts are continuous, so that no motion grows at a critical speed between two marginal ranges.
            _ => {}
        }
    }
    ranges
}
