//! Derivatives of the matrices with respect to the parameters: against differences in exact arithmetic, against
//! differences of the values, and against derivatives by hand.

use carvallo::{Coefficients, Differentiable, Model, Rows, Scalar};
use carvallo_compare::Real;
use carvallo_models::{Pendulum, Whipple, WhippleDerivatives, WhippleMatrices, WhippleMechanism, each_model};
use carvallo_tests::exact::{Matrices, derivative_sizes, derivatives};
use carvallo_tests::{bicycles, designs};
use proptest::prelude::*;

/// The largest error of a derivative with respect to a parameter, in units of the largest entry of the derivative of the
/// same matrix with respect to it, or of the terms that this is summed from, and which one it is; infinite for what is not a
/// number.
fn worst<T: Scalar>(design: &Whipple<T>, computed: &[Coefficients<T, 2>]) -> (f64, String) {
    let mut worst = (0.0, "none".to_string());
    for (parameter, computed) in computed.iter().enumerate() {
        let exact: Matrices<Real> = derivatives(design, parameter);
        let matrices = [computed.m, computed.c1, computed.k0, computed.k2];
        let terms = derivative_sizes(design, parameter);
        for (which, name) in ["M", "C1", "K0", "K2"].into_iter().enumerate() {
            let (matrix, exact) = (matrices[which], exact[which]);
            let least = terms[which].max(f64::MIN_POSITIVE);
            let largest = exact.into_iter().flatten().map(|entry| entry.abs().to_f64()).fold(least, f64::max);
            for (row, exact) in exact.into_iter().enumerate() {
                for (column, exact) in exact.into_iter().enumerate() {
                    let value = matrix[(row, column)].to_f64();
                    let error = if value.is_finite() {
                        (Real::from(value) - exact).abs().to_f64() / largest
                    } else {
                        f64::INFINITY
                    };
                    let parameter = Whipple::INFO.parameters[parameter].name;
                    if error > worst.0 {
                        worst = (error, format!("{name}[{row}, {column}] by {parameter} is {value}, off by {error:e}"));
                    }
                }
            }
        }
    }
    worst
}

/// The same parameters, for the model from bodies.
fn mechanism<T: Scalar>(design: &Whipple<T>) -> WhippleMechanism<T> {
    WhippleMechanism::from_array(design.to_array())
}

#[test]
fn those_of_every_bicycle_agree_with_exact_differences() {
    for (name, bicycle) in bicycles::all() {
        let from_formulas = bicycle.coefficients_and_derivatives().1;
        let from_bodies = mechanism(&bicycle).coefficients_and_derivatives().1;
        for computed in [from_formulas, from_bodies] {
            let (error, which) = worst(&bicycle, &computed);
            assert!(error < 1e-14, "{name}: {which}");
        }
    }
}

proptest! {
    #![proptest_config(designs::config(20))]

    #[test]
    fn those_of_random_designs_agree_with_exact_differences(design in designs::any()) {
        for computed in [
            design.coefficients_and_derivatives().1,
            mechanism(&design).coefficients_and_derivatives().1,
        ] {
            let (error, which) = worst(&design, &computed);
            prop_assert!(error < 1e-12, "{which}");
        }
    }

    #[test]
    fn those_in_single_precision_agree_with_exact_differences(design in designs::regular()) {
        let design = designs::narrowed(&design);
        for computed in [
            design.coefficients_and_derivatives().1,
            mechanism(&design).coefficients_and_derivatives().1,
        ] {
            let (error, which) = worst(&design, &computed);
            prop_assert!(error < 1e-4, "{which}");
        }
    }
}

proptest! {
    #![proptest_config(designs::config(300))]

    #[test]
    fn values_beside_derivatives_agree_with_exact_arithmetic(design in designs::any()) {
        super::designs::check(&design, &design.matrices_and_derivatives().0, f64::EPSILON)?;
        let matrices = mechanism(&design).matrices_and_derivatives().0;
        let matrices = WhippleMatrices { m: matrices.m, c1: matrices.c1, k0: matrices.k0, k2: matrices.k2 };
        super::designs::check(&design, &matrices, f64::EPSILON)?;
    }

    #[test]
    fn those_that_are_written_over_others_are_the_same(design in designs::any()) {
        let expected = design.matrices_and_derivatives();
        let [m, c1, k0, k2] = [[[f64::NAN; 2]; 2]; 4].map(Rows);
        let mut matrices = WhippleMatrices { m, c1, k0, k2 };
        let mut derivatives = WhippleDerivatives { values: expected.1.values.map(|_| f64::NAN) };
        design.write_matrices_and_derivatives(&mut matrices, &mut derivatives);
        prop_assert_eq!((matrices, derivatives), expected);

        let single = mechanism(&design.cast::<f32>());
        let expected = single.matrices_and_derivatives();
        // Those of another one.
        let (mut matrices, mut derivatives) = WhippleMechanism::BENCHMARK.to_f32().matrices_and_derivatives();
        single.write_matrices_and_derivatives(&mut matrices, &mut derivatives);
        prop_assert_eq!((matrices, derivatives), expected);
    }

    #[test]
    fn sparse_and_dense_ones_are_the_same(design in designs::any()) {
        let (matrices, derivatives) = design.matrices_and_derivatives();
        let (coefficients, dense) = design.coefficients_and_derivatives();
        prop_assert_eq!([coefficients.m, coefficients.k2].map(rows), [matrices.m, matrices.k2]);
        for (parameter, coefficients) in dense.iter().enumerate() {
            let matrices = derivatives.with_respect_to(parameter).expect("a parameter");
            let all = [coefficients.m, coefficients.c1, coefficients.k0, coefficients.k2].map(rows);
            prop_assert_eq!([matrices.m, matrices.c1, matrices.k0, matrices.k2], all);
            prop_assert_eq!([coefficients.c0, coefficients.kc].map(rows), [[[0.0; 2]; 2]; 2]);
        }
        prop_assert_eq!(derivatives.with_respect_to(26), None);
    }
}

fn rows(matrix: carvallo::Matrix<f64, 2>) -> [[f64; 2]; 2] {
    matrix.transpose().data.0
}

/// That a derivative is zero for all parameters is seen in random designs: where it is zero in one, it is in all.
#[test]
fn those_that_are_kept_are_those_that_are_not_zero() {
    let design = designs::numbered(7);
    let kept: Vec<_> = WhippleDerivatives::PARTIALS.iter().collect();
    let mut found = 0;
    for parameter in 0..26 {
        let exact: Matrices<Real> = derivatives(&design, parameter);
        for (name, matrix) in ["M", "C1", "K0", "K2"].into_iter().zip(exact) {
            for (row, entries) in matrix.into_iter().enumerate() {
                for (column, entry) in entries.into_iter().enumerate() {
                    let is_kept = kept.iter().any(|partial| {
                        let place = (format!("{:?}", partial.matrix), partial.row, partial.column, partial.parameter);
                        place == (name.to_string(), row, column, parameter)
                    });
                    assert_eq!(is_kept, entry.abs().to_f64() > 1e-20, "{name}[{row}, {column}] by {parameter}");
                    found += usize::from(is_kept);
                }
            }
        }
    }
    assert_eq!(found, kept.len());
}

#[test]
fn those_of_a_pendulum_are_what_they_are_by_hand() {
    // M = m l^2, C0 = c, K0 = m l.
    let pendulum = Pendulum { m: 3.0, l: 0.5, c: 0.25, g: 9.81 };
    let derivatives = pendulum.matrices_and_derivatives().1;
    let by = |name| {
        let position = Pendulum::INFO.position(name).expect("a parameter");
        let matrices = derivatives.with_respect_to(position).expect("a parameter");
        [matrices.m, matrices.c0, matrices.k0].map(|matrix| matrix[0][0])
    };
    assert_eq!(by("m"), [0.25, 0.0, 0.5]);
    assert_eq!(by("l"), [3.0, 0.0, 3.0]);
    assert_eq!(by("c"), [0.0, 1.0, 0.0]);
    assert_eq!(by("g"), [0.0; 3]);
}

/// All entries of all matrices.
fn entries<const N: usize>(coefficients: &Coefficients<f64, N>) -> Vec<f64> {
    let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, .. } = coefficients;
    [m, cm1, c0, c1, kc, k0, k1, k2].into_iter().flat_map(|matrix| matrix.iter().copied()).collect()
}

/// The largest difference between the derivatives of a model at its parameter sets and differences of the values, in
/// units of the largest derivative with respect to the same parameter.
fn from_differences<const N: usize, M: Model<N, Scalar = f64>>() -> (&'static str, f64) {
    let mut worst = 0.0_f64;
    for set in M::INFO.sets {
        // A model may be compiled without.
        let model = M::from_slice(set.values).expect("the model's own set");
        let Some((_, computed)) = model.derivatives() else { continue };
        assert_eq!(computed.as_ref().len(), M::INFO.parameters.len());
        for (parameter, computed) in computed.as_ref().iter().enumerate() {
            let at = |shift: f64| {
                let mut values = set.values.to_vec();
                values[parameter] += shift;
                entries(&M::from_slice(&values).expect("as many values").coefficients())
            };
            // Errors of the fourth order in the step, and of rounding divided by it, are about alike.
            let step = 1e-3 * set.values[parameter].abs().max(0.1);
            let [far_below, below, above, far_above] = [-2.0, -1.0, 1.0, 2.0].map(|steps| at(steps * step));
            let computed = entries(computed);
            let largest = computed.iter().fold(1e-300, |largest: f64, entry| largest.max(entry.abs()));
            for (index, computed) in computed.into_iter().enumerate() {
                let near = 8.0 * (above[index] - below[index]) - (far_above[index] - far_below[index]);
                worst = worst.max((near / (12.0 * step) - computed).abs() / largest);
            }
        }
    }
    (M::INFO.name, worst)
}

#[test]
fn those_of_every_model_agree_with_differences_of_its_values() {
    for (name, worst) in each_model!(from_differences) {
        assert!(worst < 1e-7, "{name}: {worst:e}");
    }
}

/// The operations of values and derivatives together that must never become more.
const MOST: [(&str, &str, usize); 2] = [
    ("whipple", include_str!("../../../generated/src/models/whipple.rs"), 553),
    ("whipple_mechanism", include_str!("../../../generated/src/models/whipple_mechanism.rs"), 420),
];

#[test]
fn values_and_derivatives_never_take_more_operations_than_before() {
    for (name, source, most) in MOST {
        let mut lines = source.lines().skip_while(|line| !line.contains("matrices and their derivatives, from one"));
        let line = lines.nth(1).expect("a line that states the counts");
        let total = line.rsplit_once(": ").and_then(|(_, total)| total.split(' ').next()?.parse::<usize>().ok());
        assert!(total.is_some_and(|total| total <= most), "{name}: {line}");
    }
}
