//! A model with derivatives in a crate without the standard library: roots, tangents and quotients, by hand.

#![no_std]
#![forbid(unsafe_code)]
#![deny(warnings)]

// For the program's start alone.
extern crate std;

use carvallo::{Differentiable, MatrixName};

carvallo::model! {
    pub model Any {
        parameters { x: 1, > 0; a: 1, in (-1, 1); n: 1; I: kg*m^2, unused; }
        let r = sqrt(x);
        let b = r + x;
        derivatives;
        coordinates { theta: rad; }
        M = [[1 [kg*m^2]*(b*tan(a) + n^1*x^3)]];
        Kc = [[1 [N*m]*n^2/(r*x)]];
    }
}

fn main() {
    let at = Any { x: 4.0_f64, a: 0.0, n: 3.0, I: 1.0 };
    let (matrices, derivatives) = at.matrices_and_derivatives();
    assert_eq!((*matrices.m, *matrices.kc), ([[192.0]], [[1.125]]));
    // M = (sqrt(x) + x) tan(a) + n x^3 and Kc = n^2 x^(-3/2), by x, a and n.
    let by_hand = [
        (MatrixName::M, 0, 144.0),
        (MatrixName::M, 1, 6.0),
        (MatrixName::M, 2, 64.0),
        (MatrixName::Kc, 0, -27.0 / 64.0),
        (MatrixName::Kc, 2, 0.75),
    ];
    assert_eq!(AnyDerivatives::PARTIALS.len(), by_hand.len());
    for (matrix, parameter, value) in by_hand {
        let mut partials = AnyDerivatives::PARTIALS.iter();
        let partial = partials.find(|partial| (partial.matrix, partial.parameter) == (matrix, parameter));
        let found = partial.expect("it is kept").of(&derivatives.values);
        assert!((found - value).abs() < 1e-14, "{matrix:?} by {parameter} is {found}");
    }
    let (mut again, mut values) = Any { x: 1.0, a: 0.5, n: 2.0, I: 0.0 }.matrices_and_derivatives();
    at.write_matrices_and_derivatives(&mut again, &mut values);
    assert_eq!((again, values), (matrices, derivatives));
    // Nothing is infinite where powers and factors vanish.
    let (_, dense) = Any { x: 1.0_f32, a: 0.0, n: 0.0, I: 0.0 }.coefficients_and_derivatives();
    assert_eq!(dense.map(|by| [by.m[(0, 0)], by.kc[(0, 0)]]), [[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [0.0, 0.0]]);
}
