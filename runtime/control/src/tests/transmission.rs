//! Transmission zeros and singular values, against those that `transmission.py` finds with 60 digits from exact determinants.

use carvallo::{Complex, matrix_eigenvalues};
use nalgebra::DMatrix;

use super::transfer_functions::{assert_roots_among, roots};
use super::{benchmark, design, state_space};
use crate::{StateSpace, TransferFunction, singular_values, transmission_zeros};

/// From each input to each output, those of one input one after the other.
fn functions(space: &StateSpace) -> Vec<TransferFunction> {
    let places = (0..space.inputs.len()).flat_map(|input| (0..space.outputs.len()).map(move |output| (input, output)));
    places.map(|(input, output)| TransferFunction::new(space, input, output).expect("a transfer function")).collect()
}

#[test]
fn zeros_and_singular_values_are_those_of_exact_determinants() {
    let lines = include_str!("transmission.tsv").lines().filter(|line| !line.starts_with('#'));
    assert_eq!(lines.clone().count(), 17);
    for line in lines {
        let [model, set, speed, inputs, outputs, zeros, values] = line.split('\t').collect::<Vec<_>>()[..] else {
            panic!("seven columns: {line}");
        };
        let what = format!("{model} {set} at {speed} from {inputs} to {outputs}");
        let [inputs, outputs] = [inputs, outputs].map(|names| names.split(',').collect::<Vec<_>>());
        let space = state_space(&design(model, set), speed.parse().expect("a speed"), &inputs, &outputs);
        let found = transmission_zeros(&space).expect("eigenvalues");
        match zeros {
            "-" => assert_eq!(found, None, "{what}"),
            zeros => {
                // What there is beside zero is as good as the state matrix is.
                let (expected, poles) = (roots(zeros), matrix_eigenvalues(&space.a).expect("eigenvalues"));
                assert_roots_among(&what, &found.expect("zeros"), &expected, &[expected.clone(), poles].concat());
            }
        }
        let functions = functions(&space);
        for (frequency, expected) in [0.1, 3.0, 40.0].into_iter().zip(values.split(' ')) {
            let found = singular_values(&functions, inputs.len(), frequency).expect("no pole");
            let expected: Vec<f64> = expected.split(',').map(|value| value.parse().expect("a number")).collect();
            assert_eq!(found.len(), expected.len(), "{what}");
            for (found, value) in found.iter().zip(&expected) {
                // Rounding is that of the largest.
                assert!((found - value).abs() < 1e-13 * expected[0], "{what} at {frequency}: {found} is not {value}");
            }
        }
    }
}

/// Neither two outputs of which one is a multiple of the other, nor outputs that are always zero.
#[test]
fn outputs_that_depend_on_each_other_have_none() {
    let mut space = state_space(&benchmark(), 5.0, &["Tphi", "Tdelta"], &["phi", "delta"]);
    let row = space.c.row(0) * -3.0;
    space.c.set_row(1, &row);
    assert_eq!(transmission_zeros(&space).expect("eigenvalues"), None);
    let values = singular_values(&functions(&space), 2, 1.0).expect("no pole");
    assert!(values[0] > 0.0 && values[1] == 0.0, "{values:?}");
    space.c.fill(0.0);
    assert_eq!(transmission_zeros(&space).expect("eigenvalues"), None);
}

/// A diagonal system with `(s + 3) / (s + 1)` and `1 / (s + 2)`, turned in its inputs and outputs: the zero is -3, and singular values at
/// rest are 3 and 1/2.
#[test]
fn directions_do_not_matter() {
    let matrix = DMatrix::from_row_slice;
    let turned = |angle: f64| matrix(2, 2, &[angle.cos(), -angle.sin(), angle.sin(), angle.cos()]);
    let mut space = state_space(&benchmark(), 5.0, &["Tphi", "Tdelta"], &["phi", "delta"]);
    let [inputs, outputs] = [turned(0.7), turned(-0.3)];
    space.a = matrix(2, 2, &[-1.0, 0.0, 0.0, -2.0]);
    space.b = &matrix(2, 2, &[2.0, 0.0, 0.0, 1.0]) * &inputs;
    space.c = &outputs * matrix(2, 2, &[1.0, 0.0, 0.0, 1.0]);
    space.d = &outputs * matrix(2, 2, &[1.0, 0.0, 0.0, 0.0]) * &inputs;
    space.states.truncate(2);
    let zeros = transmission_zeros(&space).expect("eigenvalues").expect("full rank");
    assert!(zeros.len() == 1 && (zeros[0] - Complex::new(-3.0, 0.0)).norm() < 1e-13, "{zeros:?}");
    let values = singular_values(&functions(&space), 2, 0.0).expect("no pole");
    assert!((values[0] - 3.0).abs() < 1e-13 && (values[1] - 0.5).abs() < 1e-13, "{values:?}");
}
