//! Four ways to compute the matrices of the Whipple bicycle, beside each other.

use carvallo::Number;
use carvallo_compare::Comparison;
use carvallo_models::{Whipple, WhippleMechanism, WhippleMechanismMatrices};

use crate::hand_written;
use crate::peers::symplex;

/// From the formulas of Appendix A and from the bodies of the mechanism, both generated; Appendix A by hand; and by
/// `symplex-build` from the formulas, whose code takes no numbers that count.
pub fn four_ways(designs: impl IntoIterator<Item = Whipple>) -> Comparison<Whipple, 2> {
    Comparison::of(Whipple::matrices)
        .single(Whipple::matrices)
        .counted(Whipple::matrices)
        .against("from bodies", from_bodies)
        .single(from_bodies)
        .counted(from_bodies)
        .against("by hand", hand_written::matrices)
        .single(hand_written::matrices)
        .counted(hand_written::matrices)
        .against("symplex-build", symplex::matrices)
        .single(symplex::matrices)
        .at(designs)
}

#[inline(always)]
fn from_bodies<T: Number>(design: &Whipple<T>) -> WhippleMechanismMatrices<T> {
    WhippleMechanism::from_array(design.to_array()).matrices()
}
