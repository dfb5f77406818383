//! The columns of the results: as many for every design.

use carvallo::{CriticalKind, MatrixName, Stability};
use carvallo_design::Shipped;
use carvallo_design::number::shortest;
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

/// The most that there can be for a model.
///
/// Where critical speeds are the roots of polynomials whose coefficients are known (see [`carvallo::Stability`]), they are
/// the degrees of these in the speed. Without a matrix C0 these are even in the speed, or odd, so that at most half of their
/// roots are positive. A stable range ends at weave and capsize speeds only.
///
/// For any other model the degrees are larger than what is ever found: there is room for at most [`MOST`] of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capacity {
    pub weave: usize,
    pub capsize: usize,
    pub double_root: usize,
    pub stable: usize,
    /// Whether there may be ranges in which a critical speed is missing.
    pub counts_undecided: bool,
}

/// More columns than this for a kind would be empty.
const MOST: usize = 12;

impl Capacity {
    /// None where nothing depends on the speed, unless the polynomials are known.
    pub fn of(model: &Shipped) -> Option<Self> {
        let (info, states) = (model.info, model.eigenvalues());
        if model.has_known_polynomials() {
            let divisor = if info.matrices.contains(&MatrixName::C0) { 1 } else { 2 };
            let [weave, capsize, double_root] = [6, 4, 12].map(|degree| degree / divisor);
            return Some(Self { weave, capsize, double_root, stable: weave + capsize + 1, counts_undecided: false });
        } else if !model.depends_on_speed() {
            return None;
        }
        // Of the product of all sums of two eigenvalues, each a root of a polynomial in the speed and its inverse.
        let weave = MOST.min(states * states.saturating_sub(1));
        let capsize = MOST.min(2 * info.coordinates.len());
        let stable = MOST.min(weave + capsize + 1);
        Some(Self { weave, capsize, double_root: weave, stable, counts_undecided: true })
    }

    /// Nothing is left out unseen.
    ///
    /// # Errors
    /// If a design has more than there are columns for.
    pub fn require_room(&self, stability: &Stability) -> Result<(), String> {
        let count = |kind| of_kind(stability, kind).count();
        for (found, most, what) in [
            (count(CriticalKind::Weave), self.weave, "weave or flutter speeds"),
            (count(CriticalKind::Capsize), self.capsize, "capsize or divergence speeds"),
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

/// The critical speeds of a kind, ascending.
pub fn of_kind(stability: &Stability, kind: CriticalKind) -> impl Iterator<Item = f64> {
    let speeds = stability.critical_speeds.iter().filter(move |critical| critical.kind == kind);
    speeds.map(|critical| critical.speed)
}
