//! Models that ask for some of their derivatives: those by hand, and nothing where none were asked for.

use carvallo::{MatrixName, Model};

carvallo::model! {
    /// A damped pendulum that asks for derivatives of two matrices with respect to two parameters.
    pub model Chosen {
        parameters { m: kg, > 0; l: m, > 0; g: N/kg, >= 0, gravity; d: N*m*s, >= 0; }
        derivatives of M, K0 with respect to l, m;
        coordinates { phi: rad; }
        M = [[m*l^2]];
        C0 = [[d]];
        K0 = [[m*l]];
    }
}

carvallo::model! {
    /// The same with derivatives of all matrices with respect to two parameters.
    pub model ByTwo {
        parameters { m: kg, > 0; l: m, > 0; g: N/kg, >= 0, gravity; d: N*m*s, >= 0; }
        derivatives with respect to l, d;
        coordinates { phi: rad; }
        M = [[m*l^2]];
        C0 = [[d]];
        K0 = [[m*l]];
    }
}

carvallo::model! {
    /// The same, in which everything there is is asked for by name.
    pub model All {
        parameters { m: kg, > 0; l: m, > 0; }
        derivatives of M, K0 with respect to m, l;
        coordinates { phi: rad; }
        M = [[m*l^2]];
        K0 = [[m*l]];
    }
}

#[test]
fn of_some_matrices_there_are_those_that_are_asked_for() {
    let (_, derivatives) = Chosen { m: 3.0, l: 0.5, g: 9.81, d: 0.25 }.matrices_and_derivatives();
    let all = ChosenDerivatives::<f64>::PARTIALS.map(|partial| (partial.matrix, partial.parameter));
    // By the position of the parameter.
    assert_eq!(all, [(MatrixName::M, 0), (MatrixName::K0, 0), (MatrixName::M, 1), (MatrixName::K0, 1)]);
    let by_hand = [
        (MatrixName::M, 0, Some([[0.25]])),
        (MatrixName::M, 1, Some([[3.0]])),
        (MatrixName::K0, 0, Some([[0.5]])),
        (MatrixName::K0, 1, Some([[3.0]])),
        (MatrixName::M, 3, None),
        (MatrixName::C0, 1, None),
        (MatrixName::C0, 3, None),
        (MatrixName::M, 4, None),
    ];
    for (matrix, parameter, expected) in by_hand {
        assert_eq!(derivatives.matrix_with_respect_to(matrix, parameter), expected, "{matrix:?} by {parameter}");
    }
}

#[test]
fn of_all_matrices_there_are_those_with_respect_to_what_is_asked_for() {
    let design = ByTwo { m: 3.0, l: 0.5, g: 9.81, d: 0.25 };
    let (_, derivatives) = design.matrices_and_derivatives();
    let by_length = derivatives.with_respect_to(1).expect("asked for");
    assert_eq!((*by_length.m, *by_length.c0, *by_length.k0), ([[3.0]], [[0.0]], [[3.0]]));
    let by_damping = derivatives.with_respect_to(3).expect("asked for");
    assert_eq!((*by_damping.m, *by_damping.c0, *by_damping.k0), ([[0.0]], [[1.0]], [[0.0]]));
    assert_eq!([0, 2, 4].map(|parameter| derivatives.with_respect_to(parameter)), [None; 3]);
}

#[test]
fn what_takes_any_model_is_told_of_all_derivatives_or_of_none() {
    let by_two: Option<carvallo::WithDerivatives<ByTwo, 1>> = ByTwo { m: 3.0, l: 0.5, g: 9.81, d: 0.25 }.derivatives();
    assert!(by_two.is_none());
    let (_, all) = All { m: 3.0, l: 0.5 }.derivatives().expect("all are asked for");
    assert_eq!([all[0].m[(0, 0)], all[0].k0[(0, 0)], all[1].m[(0, 0)], all[1].k0[(0, 0)]], [0.25, 0.5, 3.0, 3.0]);
}
