//! The stability of many designs as columns: as many for every design of a model, with the same headings.

use carvallo::{Complex, CriticalKind, Stability, Verdict};
use carvallo_design::number::shortest;
use carvallo_design::{Capacity, Shipped, of_kind};

use crate::analysis::kind;

/// What a verdict is called, by its place in a [`Cell`].
pub const VERDICTS: [&str; 3] = ["stable", "marginal", "unstable"];

const KINDS: [CriticalKind; 3] = [CriticalKind::Weave, CriticalKind::Capsize, CriticalKind::DoubleRoot];
const SPEED: &str = "m/s";
const RATE: &str = "1/s";

/// The name, the unit and the kind of a column.
#[derive(Clone, Debug, PartialEq)]
pub struct Heading {
    /// Such as `weave_1`.
    pub name: String,
    /// As declared, such as `kg*m^2`; empty where there is none.
    pub unit: &'static str,
    /// What stands below it.
    pub kind: Kind,
}

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Numbers, of which some may be missing.
    Number,
    /// Whole numbers.
    Count,
    /// Words.
    Text,
}

/// The value of a column for one design.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// A number, if there is one.
    Number(Option<f64>),
    /// How many there are.
    Count(usize),
    /// One of [`VERDICTS`], by its place.
    Verdict(usize),
}

impl Heading {
    /// Of numbers in a unit.
    pub fn number(name: impl Into<String>, unit: &'static str) -> Self {
        Self { name: name.into(), unit, kind: Kind::Number }
    }

    /// Of whole numbers.
    pub fn count(name: &str) -> Self {
        Self { name: name.to_owned(), unit: "", kind: Kind::Count }
    }

    /// Of words.
    pub fn text(name: impl Into<String>) -> Self {
        Self { name: name.into(), unit: "", kind: Kind::Text }
    }
}

/// How many columns there are of each kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// None where nothing depends on the speed.
    pub critical: Option<Capacity>,
    /// The words for weave, capsize and double roots, in this order.
    names: [&'static str; 3],
    /// The speeds of verdicts and eigenvalues in m/s.
    pub speeds: Vec<f64>,
    /// The number of eigenvalues at each of them.
    pub eigenvalues: usize,
}

impl Layout {
    /// Of a model, with verdicts and eigenvalues at speeds in m/s.
    pub fn new(model: &Shipped, speeds: Vec<f64>) -> Self {
        let names = KINDS.map(|of| kind(of, model.info));
        Self { critical: Capacity::of(model), names, speeds, eigenvalues: model.eigenvalues() }
    }

    /// What the columns are called.
    pub fn headings(&self) -> Vec<Heading> {
        let mut headings = Vec::new();
        if let Some(Capacity { weave, capsize, double_root, stable, counts_undecided }) = self.critical {
            for (kind, most) in self.names.into_iter().zip([weave, capsize, double_root]) {
                headings.push(Heading::count(&format!("{kind}_count")));
                headings.extend((1..=most).map(|index| Heading::number(format!("{kind}_{index}"), SPEED)));
            }
            headings.push(Heading::count("stable_count"));
            let ends = |index| ["from", "to"].map(|end| Heading::number(format!("stable_{end}_{index}"), SPEED));
            headings.extend((1..=stable).flat_map(ends));
            headings.extend(counts_undecided.then(|| Heading::count("undecided_count")));
        }
        for speed in &self.speeds {
            let speed = shortest(*speed);
            headings.push(Heading::text(format!("verdict_at_{speed}")));
            let parts = |index| ["re", "im"].map(|part| format!("eigenvalue_{index}_{part}_at_{speed}"));
            headings.extend((1..=self.eigenvalues).flat_map(parts).map(|name| Heading::number(name, RATE)));
        }
        headings
    }

    /// Puts the cells of a design into the columns, in their order: from its stability, the verdicts at the speeds, and the
    /// eigenvalues there, those at one speed after those at another.
    pub fn fill(
        &self,
        stability: &Stability,
        verdicts: &[Verdict],
        eigenvalues: &[Complex<f64>],
        mut put: impl FnMut(Cell),
    ) {
        if let Some(Capacity { weave, capsize, double_root, stable, counts_undecided }) = self.critical {
            for (kind, most) in KINDS.into_iter().zip([weave, capsize, double_root]) {
                put(Cell::Count(of_kind(stability, kind).count()));
                let mut speeds = of_kind(stability, kind);
                (0..most).for_each(|_| put(Cell::Number(speeds.next())));
            }
            put(Cell::Count(stability.stable_ranges.len()));
            for index in 0..stable {
                let range = stability.stable_ranges.get(index);
                put(Cell::Number(range.map(|range| range.from)));
                put(Cell::Number(range.and_then(|range| range.to)));
            }
            if counts_undecided {
                put(Cell::Count(stability.undecided.len()));
            }
        }
        for (verdict, eigenvalues) in verdicts.iter().zip(eigenvalues.chunks(self.eigenvalues.max(1))) {
            put(Cell::Verdict(match verdict {
                Verdict::Stable => 0,
                Verdict::Marginal => 1,
                Verdict::Unstable => 2,
            }));
            for eigenvalue in eigenvalues {
                put(Cell::Number(Some(eigenvalue.re)));
                put(Cell::Number(Some(eigenvalue.im)));
            }
        }
    }
}
