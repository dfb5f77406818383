//! The columns of the results: as many for every design.

use carvallo::{CriticalKind, MatrixName, ModelInfo, Stability};

use super::columns::Heading;
use crate::model::Shipped;
use crate::number::shortest;

const SPEED: &str = "m/s";
const RATE: &str = "1/s";

/// How many columns there are of each kind, beside those of the designs and of the errors.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// For models that have critical speeds.
    pub critical: Option<Capacity>,
    /// The speeds of the eigenvalues.
    pub speeds: Vec<f64>,
    /// The number of eigenvalues at each of them.
    pub eigenvalues: usize,
}

/// The most that there can be for a model.
///
/// They are the degrees, in the speed, of the polynomials that have the critical speeds as their roots (see
/// [`carvallo::Stability`]). Without a matrix C0 these are even in the speed, or odd, so that at most half of their roots
/// are positive. A stable range ends at weave and capsize speeds only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capacity {
    pub weave: usize,
    pub capsize: usize,
    pub double_root: usize,
    pub stable: usize,
}

impl Capacity {
    fn of(info: &ModelInfo) -> Self {
        let divisor = if info.matrices.contains(&MatrixName::C0) { 1 } else { 2 };
        let [weave, capsize, double_root] = [6, 4, 12].map(|degree| degree / divisor);
        Self { weave, capsize, double_root, stable: weave + capsize + 1 }
    }

    /// Nothing is left out unseen.
    ///
    /// # Errors
    /// If a design has more than there are columns for.
    pub fn require_room(&self, stability: &Stability) -> Result<(), String> {
        let count = |kind| of_kind(stability, kind).count();
        for (found, most, what) in [
            (count(CriticalKind::Weave), self.weave, "weave speeds"),
            (count(CriticalKind::Capsize), self.capsize, "capsize speeds"),
            (count(CriticalKind::DoubleRoot), self.double_root, "double-root speeds"),
            (stability.stable_ranges.len(), self.stable, "stable ranges"),
        ] {
            if found > most {
                return Err(format!("it has {found} {what}; there are columns for {most}"));
            }
        }
        Ok(())
    }
}

impl Layout {
    pub fn new(model: &Shipped, speeds: Vec<f64>) -> Self {
        let critical = model.has_critical_speeds().then(|| Capacity::of(model.info));
        Self { critical, speeds, eigenvalues: model.eigenvalues() }
    }

    pub fn headings(&self) -> Vec<Heading> {
        let mut headings = Vec::new();
        if let Some(Capacity { weave, capsize, double_root, stable }) = self.critical {
            for (kind, most) in [("weave", weave), ("capsize", capsize), ("double_root", double_root)] {
                headings.push(Heading::count(&format!("{kind}_count")));
                headings.extend((1..=most).map(|index| Heading::number(format!("{kind}_{index}"), SPEED)));
            }
            headings.push(Heading::count("stable_count"));
            let ends = |index| ["from", "to"].map(|end| Heading::number(format!("stable_{end}_{index}"), SPEED));
            headings.extend((1..=stable).flat_map(ends));
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

/// The critical speeds of a kind, ascending.
pub fn of_kind(stability: &Stability, kind: CriticalKind) -> impl Iterator<Item = f64> {
    let speeds = stability.critical_speeds.iter().filter(move |critical| critical.kind == kind);
    speeds.map(|critical| critical.speed)
}
