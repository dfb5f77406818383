//! The columns of the results: as many for every design.

use carvallo::CriticalKind;
use carvallo_design::number::shortest;
use carvallo_design::{Capacity, Shipped};
use carvallo_plot::analysis::kind;

use super::columns::Heading;

const SPEED: &str = "m/s";
const RATE: &str = "1/s";

/// How many columns there are of each kind, beside those of the designs and of the errors.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// None where nothing depends on the speed.
    pub critical: Option<Capacity>,
    /// The words for weave, capsize and double roots, in this order.
    names: [&'static str; 3],
    /// The speeds of the eigenvalues.
    pub speeds: Vec<f64>,
    /// The number of eigenvalues at each of them.
    pub eigenvalues: usize,
}

impl Layout {
    pub fn new(model: &Shipped, speeds: Vec<f64>) -> Self {
        let kinds = [CriticalKind::Weave, CriticalKind::Capsize, CriticalKind::DoubleRoot];
        let names = kinds.map(|of| kind(of, model.info));
        Self { critical: Capacity::of(model), names, speeds, eigenvalues: model.eigenvalues() }
    }

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
}
