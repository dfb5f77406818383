//! How many critical speeds of each kind a design of a model can have: the columns of a table of many designs.

use carvallo::{CriticalKind, MatrixName, Stability};

use crate::model::Shipped;

/// The most that there can be for a model.
///
/// Where critical speeds are the roots of polynomials whose coefficients are known (see [`carvallo::Stability`]), they are
/// the degrees of these in the speed. Without a matrix C0 these are even in the speed, or odd, so that at most half of their
/// roots are positive. A stable range ends at weave and capsize speeds only.
///
/// For any other model the degrees are larger than what is ever found: there is room for at most 12 of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capacity {
    /// Weave or flutter speeds.
    pub weave: usize,
    /// Capsize or divergence speeds.
    pub capsize: usize,
    /// Double-root speeds.
    pub double_root: usize,
    /// Stable ranges.
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

/// The critical speeds of a kind, ascending.
pub fn of_kind(stability: &Stability, kind: CriticalKind) -> impl Iterator<Item = f64> {
    let speeds = stability.critical_speeds.iter().filter(move |critical| critical.kind == kind);
    speeds.map(|critical| critical.speed)
}
