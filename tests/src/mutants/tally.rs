//! How many mutants each check catches.

use std::collections::BTreeMap;
use std::fmt;

use super::{Check, Kind, Mutant, Verdict};

/// Verdicts on mutants, counted.
#[derive(Debug, Default)]
pub struct Tally {
    counts: BTreeMap<(Kind, Verdict), usize>,
    /// For each place at which names were changed: how many were caught, and how many survived.
    names: BTreeMap<usize, [usize; 2]>,
}

impl Tally {
    /// Counts a mutant.
    pub fn add(&mut self, mutant: &Mutant, verdict: Verdict) {
        *self.counts.entry((mutant.kind, verdict)).or_default() += 1;
        if matches!(mutant.kind, Kind::SimilarName | Kind::OtherName) {
            let place = self.names.entry(mutant.place.start).or_default();
            match verdict {
                Verdict::Caught(_) => place[0] += 1,
                Verdict::Survived => place[1] += 1,
                Verdict::Equivalent => {}
            }
        }
    }

    /// How many of a kind have a verdict.
    pub fn count(&self, kind: Kind, verdict: Verdict) -> usize {
        self.counts.get(&(kind, verdict)).copied().unwrap_or_default()
    }

    /// The share caught among all mutants of some kinds that are not equivalent; NaN if there are none.
    pub fn caught(&self, kinds: &[Kind]) -> f64 {
        let of = |verdict| kinds.iter().map(|kind| self.count(*kind, verdict)).sum::<usize>();
        let caught = Check::ALL.map(|check| of(Verdict::Caught(check))).iter().sum::<usize>();
        share(caught, of(Verdict::Survived))
    }

    /// The share caught if one of the names in use, chosen at random, becomes a random other one.
    pub fn caught_at_a_random_name(&self) -> f64 {
        let decided = self.names.values().filter(|[caught, survived]| caught + survived > 0);
        let shares: Vec<f64> = decided.map(|[caught, survived]| share(*caught, *survived)).collect();
        shares.iter().sum::<f64>() / shares.len() as f64
    }
}

fn share(caught: usize, survived: usize) -> f64 {
    caught as f64 / (caught + survived) as f64
}

/// A table: a line for each kind, a column for each verdict.
impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:<22}{:>9}", "", "all")?;
        for check in Check::ALL {
            write!(f, "{check:>10}")?;
        }
        writeln!(f, "{:>10}{:>12}{:>9}", "survived", "equivalent", "caught")?;
        for kind in Kind::PLAIN {
            self.line(f, &kind.to_string(), &[kind])?;
        }
        self.line(f, "all", &Kind::PLAIN)?;
        write!(f, "{:<22}{:>8.1}%", "a name at random", 100.0 * self.caught_at_a_random_name())
    }
}

impl Tally {
    fn line(&self, f: &mut fmt::Formatter<'_>, title: &str, kinds: &[Kind]) -> fmt::Result {
        let of = |verdict| kinds.iter().map(|kind| self.count(*kind, verdict)).sum::<usize>();
        let checks = Check::ALL.map(|check| of(Verdict::Caught(check)));
        let [survived, equivalent] = [Verdict::Survived, Verdict::Equivalent].map(of);
        write!(f, "{title:<22}{:>9}", checks.iter().sum::<usize>() + survived + equivalent)?;
        for count in checks {
            write!(f, "{count:>10}")?;
        }
        write!(f, "{survived:>10}{equivalent:>12}")?;
        match self.caught(kinds) {
            share if share.is_nan() => writeln!(f, "{:>9}", "-"),
            share => writeln!(f, "{:>8.1}%", 100.0 * share),
        }
    }
}
