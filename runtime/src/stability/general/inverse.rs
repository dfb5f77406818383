//! The inverse of the pencil, and what follows from it: how the logarithm of its determinant changes.

use super::field::ComplexField;
use super::pencil::Pencil;
use crate::numeric::Square;

/// The derivatives of `log det Q` by s and by v, by Jacobi's formula, and the magnitudes of the inverse.
///
/// Near an eigenvalue the inverse is nearly `x y^T / d` with the null vectors x and y of Q and a small d, and the
/// derivatives are `y^T Q' x / d`: quotients of them are those of the determinant itself.
pub(super) struct Slopes<C> {
    pub(super) by_s: C,
    pub(super) by_v: C,
    inverse: Square<C>,
}

/// What stands for a pivot of zero: far less than rounding leaves of one.
const TINY: f64 = 1e-60;

impl<C: ComplexField> Slopes<C> {
    pub(super) fn new(pencil: &Pencil<C>) -> Self {
        let inverse = invert(pencil.value.clone());
        Self { by_s: trace(&inverse, &pencil.by_s), by_v: trace(&inverse, &pencil.by_v), inverse }
    }

    /// The derivatives of `log det Q` by s twice and by s and v.
    pub(super) fn second(&self, pencil: &Pencil<C>) -> [C; 2] {
        let by_s = product(&self.inverse, &pencil.by_s);
        let of = |direction: &Square<C>, twice: &Square<C>| {
            trace(&self.inverse, twice) - trace(&by_s, &product(&self.inverse, direction))
        };
        [of(&pencil.by_s, &pencil.by_ss), of(&pencil.by_v, &pencil.by_sv)]
    }

    /// A bound on what the logarithm of the determinant changes by if each entry changes by a rounding of its terms.
    pub(super) fn rounding(&self, magnitudes: &Square<f64>) -> f64 {
        let along = |(i, row): (usize, &[C])| -> f64 {
            row.iter().zip(magnitudes.column(i)).map(|(entry, magnitude)| entry.norm() * magnitude).sum()
        };
        f64::EPSILON * self.inverse.rows().enumerate().map(along).sum::<f64>()
    }
}

/// The trace of a product.
fn trace<C: ComplexField>(a: &Square<C>, b: &Square<C>) -> C {
    let zero = C::real(0.0.into());
    let along = |sum: C, (i, row): (usize, &[C])| row.iter().zip(b.column(i)).fold(sum, |sum, (x, y)| sum + *x * y);
    a.rows().enumerate().fold(zero, along)
}

fn product<C: ComplexField>(a: &Square<C>, b: &Square<C>) -> Square<C> {
    let zero = C::real(0.0.into());
    Square::from_fn(a.size(), |i, j| a[i].iter().zip(b.column(j)).fold(zero, |sum, (x, y)| sum + *x * y))
}

/// The inverse by Gauss and Jordan's elimination with partial pivoting.
fn invert<C: ComplexField>(mut a: Square<C>) -> Square<C> {
    let size = a.size();
    let mut order: Vec<usize> = (0..size).collect();
    let one = C::real(1.0.into());
    let mut row = vec![one; size];
    for step in 0..size {
        let by_size = |x: &usize, y: &usize| a[*x][step].norm().total_cmp(&a[*y][step].norm());
        let pivot = (step..size).max_by(by_size).unwrap_or(step);
        a.swap_rows(step, pivot);
        order.swap(step, pivot);
        let mut pivot = a[step][step];
        if pivot.norm() < TINY {
            pivot = C::real(TINY.into());
        }
        a[step][step] = one;
        let inverse = one / pivot;
        row.clear();
        row.extend(a[step].iter().map(|entry| *entry * inverse));
        a[step].copy_from_slice(&row);
        for (i, other) in a.rows_mut().enumerate() {
            if i != step {
                let factor = other[step];
                other[step] = C::real(0.0.into());
                for (entry, along) in other.iter_mut().zip(&row) {
                    *entry = *entry - factor * *along;
                }
            }
        }
    }
    // Rows were exchanged, so that the columns of the inverse are.
    for to in a.rows_mut() {
        row.copy_from_slice(to);
        for (entry, &original) in row.iter().zip(&order) {
            to[original] = *entry;
        }
    }
    a
}

/// The determinant, by elimination with partial pivoting.
pub(super) fn precise_determinant<C: ComplexField>(mut a: Square<C>) -> C {
    let mut value = C::real(1.0.into());
    for step in 0..a.size() {
        let pivot = (step..a.size()).max_by(|&x, &y| a[x][step].norm().total_cmp(&a[y][step].norm())).unwrap_or(step);
        if pivot != step {
            value = -value;
        }
        a.swap_rows(step, pivot);
        let row = a[step].to_vec();
        value = value * row[step];
        if row[step].norm() == 0.0 {
            return value;
        }
        for other in a.rows_mut().skip(step + 1) {
            let factor = other[step] / row[step];
            for (entry, along) in other[step..].iter_mut().zip(&row[step..]) {
                *entry = *entry - factor * *along;
            }
        }
    }
    value
}

/// The determinant with the sign and the relative error that rounding leaves of it, by elimination with partial pivoting.
pub(super) fn determinant(mut a: Square<f64>) -> (f64, f64) {
    let size = a.size();
    let mut terms = a.map(f64::abs);
    let (mut value, mut error) = (1.0, 0.0);
    for step in 0..size {
        let pivot = (step..size).max_by(|&x, &y| a[x][step].abs().total_cmp(&a[y][step].abs())).unwrap_or(step);
        if pivot != step {
            value = -value;
        }
        a.swap_rows(step, pivot);
        terms.swap_rows(step, pivot);
        let pivot = a[step][step];
        value *= pivot;
        if pivot == 0.0 {
            return (0.0, f64::INFINITY);
        }
        error += 4.0 * f64::EPSILON * terms[step][step] / pivot.abs();
        for i in step + 1..size {
            let factor = a[i][step] / pivot;
            for j in step + 1..size {
                let product = factor * a[step][j];
                a[i][j] -= product;
                terms[i][j] += factor.abs() * terms[step][j];
            }
        }
    }
    (value, error)
}
