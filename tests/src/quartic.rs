//! The characteristic polynomial of a system of two coordinates, at 320 bits.

use carvallo::{Coefficients, System};

use crate::exact::Number;
use crate::roots::Complex;
use carvallo_compare::Real;

/// Coefficients of `det(M s^2 + C s + K)` from s^4 down to s^0; in [`Size`](crate::exact::Size) the terms they sum.
pub fn characteristic<R: Number>(system: &System<2>) -> [R; 5] {
    determinant(|row, column| [system.m, system.c, system.k].map(|matrix| R::from(matrix[(row, column)])))
}

/// The same of a bicycle at a speed, with its coefficients, the gravity and the speed taken to be exact.
pub fn characteristic_at(coefficients: &Coefficients<f64, 2>, gravity: f64, speed: Real) -> [Real; 5] {
    let Coefficients { m, c0, c1, kc, k0, k2, .. } = coefficients;
    determinant(|row, column| {
        let [m, c0, c1, kc, k0, k2] = [m, c0, c1, kc, k0, k2].map(|matrix| Real::from(matrix[(row, column)]));
        [m, c0 + speed * c1, kc + Real::from(gravity) * k0 + speed * speed * k2]
    })
}

/// Of a 2 x 2 matrix whose entries are polynomials of the second degree, given by their coefficients, the highest first.
pub fn determinant<R: Number>(entry: impl Fn(usize, usize) -> [R; 3]) -> [R; 5] {
    let product = |a: [R; 3], b: [R; 3]| {
        let mut product = [R::from(0.0); 5];
        for i in 0..3 {
            for j in 0..3 {
                product[i + j] = product[i + j] + a[i] * b[j];
            }
        }
        product
    };
    let (diagonal, rest) = (product(entry(0, 0), entry(1, 1)), product(entry(0, 1), entry(1, 0)));
    std::array::from_fn(|power| diagonal[power] - rest[power])
}

/// The monic polynomial with the given roots, which are real or come in conjugate pairs, from s^3 down to s^0.
///
/// Imaginary parts of its coefficients vanish for such roots; they are left out.
pub fn monic(roots: &[nalgebra::Complex<f64>; 4]) -> [Real; 4] {
    let one = Complex { re: Real::from(1.0), im: Real::from(0.0) };
    let zero = Complex { re: Real::from(0.0), im: Real::from(0.0) };
    let mut coefficients = [one, zero, zero, zero, zero];
    for (degree, root) in roots.iter().enumerate() {
        let root = Complex { re: Real::from(root.re), im: Real::from(root.im) };
        for power in (0..=degree).rev() {
            coefficients[power + 1] = coefficients[power + 1] - coefficients[power] * root;
        }
    }
    std::array::from_fn(|power| coefficients[power + 1].re)
}
