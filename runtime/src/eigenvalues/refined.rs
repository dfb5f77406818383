//! Eigenvalues of which rounding beside larger ones has left some digits, with all of them.

use nalgebra::Complex;

use super::vectors::newton_step;
use crate::numeric::ComplexDoubleDouble;
use crate::pencil::Matrices;

/// Moves those of a size in this range to where the equations themselves have them, in twice the precision; not those that are
/// multiple, or nearly.
pub(super) fn refine(values: &mut [Complex<f64>], [from, to]: [f64; 2], matrices: &dyn Fn() -> Matrices) {
    let has_few_digits = |value: &Complex<f64>| (from..to).contains(&value.norm());
    if !values.iter().any(has_few_digits) {
        return;
    }
    let (matrices, before) = (matrices(), values.to_vec());
    for (place, &value) in before.iter().enumerate().filter(|(_, value)| has_few_digits(value)) {
        let others = before.iter().enumerate().filter(|(other, _)| *other != place);
        let closeness = others.map(|(_, other)| 1.0 / (value - other).norm()).sum();
        // Pairs stay exactly conjugate, and real ones real.
        let upper = Complex::new(value.re, value.im.abs());
        if let Some(Complex { re, im }) = nearest(&matrices, upper, closeness) {
            values[place] = Complex::new(re, if value.im == 0.0 { 0.0 } else { im.copysign(value.im) });
        }
    }
}

/// The eigenvalue that Newton's iteration comes to, if it is far nearer than all others, whose reciprocal distances have this
/// sum.
fn nearest(matrices: &Matrices, value: Complex<f64>, closeness: f64) -> Option<Complex<f64>> {
    const STEPS: usize = 4;
    const NEAR: f64 = 1e-2;
    // What is left is the square of it.
    const LAST: f64 = 1e-9;
    let mut found = ComplexDoubleDouble { re: value.re.into(), im: value.im.into() };
    for _ in 0..STEPS {
        let step = newton_step(matrices, found);
        let size = step.norm();
        // Not a number is not near, either.
        if size.is_nan() || size * closeness > NEAR {
            return None;
        }
        found = found - step;
        if size <= LAST * found.norm() {
            return Some(found.to_f64());
        }
    }
    None
}
