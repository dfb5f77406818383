//! Matrices of generated code, which are rows, as those of nalgebra, which are columns.

use carvallo::{Coefficients, Model};
use carvallo_models::Whipple;
use nalgebra::Matrix2;

/// C1 of the benchmark is not symmetric, which tells it from the transposed one (Meijaard et al. 2007, Table 2).
#[test]
fn what_becomes_of_rows_is_not_transposed() {
    let matrices = Whipple::BENCHMARK.matrices();
    let converted: Matrix2<f64> = matrices.c1.into();
    let published = Matrix2::new(0.0, 33.86641391492494, -0.85035641456978, 1.68540397397560);
    assert!((converted - published).amax() < 1e-13, "{converted}");
    assert_eq!(matrices.c1.matrix(), converted);
    assert_eq!(carvallo::Rows::from(converted), matrices.c1);
}

#[test]
fn all_of_them_are_the_coefficients() {
    let coefficients = Coefficients::from(Whipple::BENCHMARK.matrices());
    assert_eq!(coefficients, Whipple::BENCHMARK.coefficients());
    assert_eq!(coefficients.c1, Whipple::BENCHMARK.matrices().c1.matrix());
}
