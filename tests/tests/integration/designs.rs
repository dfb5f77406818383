//! Generated matrices on random designs, against exact arithmetic.
//!
//! The bound. Each entry of the matrices is a sum of products of parameters, and its computed value is the exact value
//! of a sum in which every term carries the relative errors of the roundings on its way to the result: at most half an
//! epsilon for each operation, and twice that for a sine or cosine. So the error is at most `count * epsilon / 2` times
//! the sum of the magnitudes of the terms, where `count` is the largest number of roundings that one term collects; a
//! product collects those of both factors. Appendix A comes to 28, in the lower right entry of M, which makes 14
//! epsilon; 16 leave a compiled arrangement a little more. The sum of magnitudes does not depend on the arrangement.

use carvallo::{Coefficients, Model, Scalar};
use carvallo_compare::Real;
use carvallo_models::{Whipple, WhippleDerivatives, WhippleMatrices};
use carvallo_tests::exact::{Matrices, Size, matrices};
use carvallo_tests::peers::symplex::{self, Symplex};
use carvallo_tests::{designs, hand_written};
use nalgebra::SMatrix;
use proptest::prelude::*;

const BOUND: f64 = 16.0;

/// Fails if an entry differs from exact arithmetic by more than `BOUND` epsilons of the size of its terms.
pub fn check<T: Scalar>(design: &Whipple<T>, computed: &WhippleMatrices<T>, epsilon: f64) -> Result<(), TestCaseError> {
    let exact: Matrices<Real> = matrices(design);
    let sizes: Matrices<Size> = matrices(design);
    let computed = [computed.m, computed.c1, computed.k0, computed.k2];
    for (matrix, name) in ["M", "C1", "K0", "K2"].into_iter().enumerate() {
        for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let value = computed[matrix][row][column].to_f64();
            let error = (Real::from(value) - exact[matrix][row][column]).abs().to_f64();
            let allowed = BOUND * epsilon * sizes[matrix][row][column].0;
            prop_assert!(
                error <= allowed,
                "{name}[{row}, {column}] = {value} is off by {error:e}; allowed: {allowed:e}"
            );
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(designs::config(300))]

    #[test]
    fn generated_agrees_with_exact_arithmetic(design in designs::any()) {
        check(&design, &design.matrices(), f64::EPSILON)?;
    }

    #[test]
    fn hand_written_agrees_with_exact_arithmetic(design in designs::any()) {
        check(&design, &hand_written::matrices(&design), f64::EPSILON)?;
    }

    #[test]
    fn a_peer_agrees_with_exact_arithmetic(design in designs::any()) {
        check(&design, &symplex::matrices(&design), f64::EPSILON)?;
        let design = designs::narrowed(&design);
        check(&design, &symplex::matrices(&design), f32::EPSILON.into())?;
    }

    #[test]
    fn derivatives_are_those_of_a_peer(design in designs::any()) {
        let (_, derivatives) = design.matrices_and_derivatives();
        let expected = &Symplex::entries_and_derivatives(&design)[16..];
        let partials = WhippleDerivatives::<f64>::PARTIALS;
        prop_assert_eq!(partials.len(), expected.len());
        let largest = expected.iter().fold(1.0, |largest: f64, value| largest.max(value.abs()));
        for (partial, expected) in partials.iter().zip(expected) {
            let value = derivatives.values[partial.value];
            let found = if partial.negative { -value } else { value };
            prop_assert!((found - expected).abs() <= 1e-12 * largest, "{partial:?}: {found}, not {expected}");
        }
    }

    #[test]
    fn generated_agrees_with_exact_arithmetic_in_single_precision(design in designs::any()) {
        let design = designs::narrowed(&design);
        check(&design, &design.matrices(), f32::EPSILON.into())?;
    }

    #[test]
    fn coefficients_are_the_matrices_and_zeros(design in designs::any()) {
        let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, .. } = design.coefficients();
        let matrices = design.matrices();
        let rows = [matrices.m, matrices.c1, matrices.k0, matrices.k2];
        prop_assert_eq!([m, c1, k0, k2].map(|matrix| matrix.transpose().data.0), rows);
        prop_assert_eq!([cm1, c0, kc, k1], [SMatrix::<f64, 2, 2>::zeros(); 4]);
    }

    #[test]
    fn matrices_have_their_structure(design in designs::any()) {
        let Coefficients { m, c1, k0, k2, .. } = design.coefficients();
        prop_assert_eq!(m, m.transpose());
        prop_assert_eq!(k0, k0.transpose());
        prop_assert_eq!([c1.m11, k2.m11, k2.m21], [0.0; 3]);
    }

    #[test]
    fn the_weight_scales_with_gravity_outside_of_the_matrices(design in designs::any(), g in 0.0..30.0) {
        prop_assert_eq!(design.coefficients(), Whipple { g, ..design }.coefficients());
        prop_assert_eq!(design.gravity(), Some(design.g));
    }
}

#[test]
fn every_bicycle_agrees_with_exact_arithmetic() {
    for (name, bicycle) in carvallo_tests::bicycles::all() {
        check(&bicycle, &bicycle.matrices(), f64::EPSILON).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}
