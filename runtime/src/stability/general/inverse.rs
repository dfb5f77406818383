//! The inverse of the pencil, and what follows from it: how the logarithm of its determinant changes.

use super::equations::Pencil;
use super::field::ComplexField;

/// The derivatives of `log det Q` by s and by v, by Jacobi's formula, and the magnitudes of the inverse.
///
/// Near an eigenvalue the inverse is nearly `x y^T / d` with the null vectors x and y of Q and a small d, and the
/// derivatives are `y^T Q' x / d`: quotients of them are those of the determinant itself.
pub(super) struct Slopes<C, const N: usize> {
    pub(super) by_s: C,
    pub(super) by_v: C,
    inverse: [[C; N]; N],
}

/// What stands for a pivot of zero: far less than rounding leaves of one.
const TINY: f64 = 1e-60;

impl<C: ComplexField, const N: usize> Slopes<C, N> {
    pub(super) fn new(pencil: &Pencil<C, N>) -> Self {
        let inverse = invert(pencil.value);
        Self { by_s: trace(&inverse, &pencil.by_s), by_v: trace(&inverse, &pencil.by_v), inverse }
    }

    /// The derivatives of `log det Q` by s twice and by s and v.
    pub(super) fn second(&self, pencil: &Pencil<C, N>) -> [C; 2] {
        let by_s = product(&self.inverse, &pencil.by_s);
        let of = |direction: &[[C; N]; N], twice: &[[C; N]; N]| {
            trace(&self.inverse, twice) - trace(&by_s, &product(&self.inverse, direction))
        };
        [of(&pencil.by_s, &pencil.by_ss), of(&pencil.by_v, &pencil.by_sv)]
    }

    /// A bound on what the logarithm of the determinant changes by if each entry changes by a rounding of its terms.
    pub(super) fn rounding(&self, magnitudes: &[[f64; N]; N]) -> f64 {
        let places = (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
        f64::EPSILON * places.map(|(i, j)| self.inverse[i][j].norm() * magnitudes[j][i]).sum::<f64>()
    }
}

/// The trace of a product.
fn trace<C: ComplexField, const N: usize>(a: &[[C; N]; N], b: &[[C; N]; N]) -> C {
    let places = (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
    places.fold(C::real(0.0.into()), |sum, (i, j)| sum + a[i][j] * b[j][i])
}

fn product<C: ComplexField, const N: usize>(a: &[[C; N]; N], b: &[[C; N]; N]) -> [[C; N]; N] {
    core::array::from_fn(|i| {
        core::array::from_fn(|j| (0..N).fold(C::real(0.0.into()), |sum, k| sum + a[i][k] * b[k][j]))
    })
}

/// The inverse by Gauss and Jordan's elimination with partial pivoting.
fn invert<C: ComplexField, const N: usize>(mut a: [[C; N]; N]) -> [[C; N]; N] {
    let mut order: [usize; N] = core::array::from_fn(|i| i);
    let one = C::real(1.0.into());
    for step in 0..N {
        let by_size = |x: &usize, y: &usize| a[*x][step].norm().total_cmp(&a[*y][step].norm());
        let pivot = (step..N).max_by(by_size).unwrap_or(step);
        a.swap(step, pivot);
        order.swap(step, pivot);
        let mut pivot = a[step][step];
        if pivot.norm() < TINY {
            pivot = C::real(TINY.into());
        }
        a[step][step] = one;
        let inverse = one / pivot;
        a[step] = a[step].map(|entry| entry * inverse);
        let row = a[step];
        for (i, other) in a.iter_mut().enumerate() {
            if i != step {
                let factor = other[step];
                other[step] = C::real(0.0.into());
                for (entry, along) in other.iter_mut().zip(row) {
                    *entry = *entry - factor * along;
                }
            }
        }
    }
    // Rows were exchanged, so that the columns of the inverse are.
    let mut inverse = a;
    for (to, row) in inverse.iter_mut().zip(&a) {
        for (place, &original) in order.iter().enumerate() {
            to[original] = row[place];
        }
    }
    inverse
}

/// The determinant, by elimination with partial pivoting.
pub(super) fn precise_determinant<C: ComplexField, const N: usize>(mut a: [[C; N]; N]) -> C {
    let mut value = C::real(1.0.into());
    for step in 0..N {
        let pivot = (step..N).max_by(|&x, &y| a[x][step].norm().total_cmp(&a[y][step].norm())).unwrap_or(step);
        if pivot != step {
            value = -value;
        }
        a.swap(step, pivot);
        let row = a[step];
        value = value * row[step];
        if row[step].norm() == 0.0 {
            return value;
        }
        for other in &mut a[step + 1..] {
            let factor = other[step] / row[step];
            for (entry, along) in other[step..].iter_mut().zip(&row[step..]) {
                *entry = *entry - factor * *along;
            }
        }
    }
    value
}

/// The determinant with the sign and the relative error that rounding leaves of it, by elimination with partial pivoting.
pub(super) fn determinant<const N: usize>(mut a: [[f64; N]; N]) -> (f64, f64) {
    let mut terms = a.map(|row| row.map(f64::abs));
    let (mut value, mut error) = (1.0, 0.0);
    for step in 0..N {
        let pivot = (step..N).max_by(|&x, &y| a[x][step].abs().total_cmp(&a[y][step].abs())).unwrap_or(step);
        if pivot != step {
            value = -value;
        }
        a.swap(step, pivot);
        terms.swap(step, pivot);
        let pivot = a[step][step];
        value *= pivot;
        if pivot == 0.0 {
            return (0.0, f64::INFINITY);
        }
        error += 4.0 * f64::EPSILON * terms[step][step] / pivot.abs();
        for i in step + 1..N {
            let factor = a[i][step] / pivot;
            for j in step + 1..N {
                let product = factor * a[step][j];
                a[i][j] -= product;
                terms[i][j] += factor.abs() * terms[step][j];
            }
        }
    }
    (value, error)
}
