//! Rounding errors of four ways to compute the matrices of the Whipple bicycle, against exact arithmetic.

use carvallo::Scalar;
use carvallo_models::{Whipple, WhippleMechanism};

use crate::exact::{Matrices, matrices};
use crate::hand_written::{self, Float};
use crate::peers::symplex::{self, Symplex};
use crate::real::Real;

/// One number for each way.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ways<E> {
    /// Generated from the formulas of Appendix A.
    pub formulas: E,
    /// Generated from the bodies of the mechanism.
    pub bodies: E,
    /// Appendix A by hand.
    pub by_hand: E,
    /// By `symplex-build` from the formulas of Appendix A.
    pub symplex: E,
}

/// The largest error of an entry over all designs, in units of the last place of the largest entry of its matrix, for a
/// scalar type with this epsilon.
pub fn largest<T: Float + Symplex>(designs: impl Iterator<Item = Whipple<T>>, epsilon: f64) -> Ways<f64> {
    let mut largest = Ways::default();
    for design in designs {
        let exact: Matrices<Real> = matrices(&design);
        let (formulas, by_hand) = (design.matrices(), hand_written::matrices(&design));
        let bodies = WhippleMechanism::from_array(design.to_array()).matrices();
        let symplex = symplex::matrices(&design);
        let Ways { formulas: in_formulas, bodies: in_bodies, by_hand: in_by_hand, symplex: in_symplex } = &mut largest;
        let ways = [
            (in_formulas, [formulas.m, formulas.c1, formulas.k0, formulas.k2]),
            (in_bodies, [bodies.m, bodies.c1, bodies.k0, bodies.k2]),
            (in_by_hand, [by_hand.m, by_hand.c1, by_hand.k0, by_hand.k2]),
            (in_symplex, [symplex.m, symplex.c1, symplex.k0, symplex.k2]),
        ];
        for (largest, computed) in ways {
            for (computed, exact) in computed.iter().zip(&exact) {
                *largest = f64::max(*largest, error(computed, exact, epsilon));
            }
        }
    }
    largest
}

/// The largest error in a matrix.
fn error<T: Scalar>(computed: &[[T; 2]; 2], exact: &[[Real; 2]; 2], epsilon: f64) -> f64 {
    let pairs = || computed.iter().flatten().zip(exact.iter().flatten());
    let largest_entry = pairs().map(|(_, exact)| exact.abs().to_f64()).fold(0.0, f64::max);
    let unit = epsilon * 2f64.powf(largest_entry.log2().floor());
    let errors = pairs().map(|(computed, exact)| (Real::from(computed.to_f64()) - *exact).abs().to_f64());
    errors.fold(0.0, f64::max) / unit
}
