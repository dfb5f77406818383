//! Whether a formula is zero for all parameters.

use super::samples::{Samples, maybe_zero};
use crate::derivation::Derived;
use crate::equations::Equations;
use crate::formula::Formula;
use crate::symbolic::{self, Depth, Proof};

/// Whether that is proved. A failure of the engine proves nothing, and is reported where it compiles the model.
pub fn is_zero(formula: &Formula, samples: &Samples, derived: &Derived) -> bool {
    if formula.is_zero() || !maybe_zero(&samples.of(formula)) {
        return formula.is_zero();
    }
    let sides = vec![formula.clone(), Formula::zero()];
    let pair = Equations::of_formulas(derived.names.parameters.len(), &derived.definitions, sides);
    symbolic::prove_equal(vec![pair], Depth::Formulas).is_ok_and(|proofs| proofs.contains(&Proof::Found))
}
