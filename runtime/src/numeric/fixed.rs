//! Polynomials of known degree, as arrays of their coefficients, ascending.

use super::tracked::Tracked;

/// The product of two polynomials; `C` is `A + B - 1`.
#[inline]
pub(crate) fn product<const A: usize, const B: usize, const C: usize>(
    a: &[Tracked; A],
    b: &[Tracked; B],
) -> [Tracked; C] {
    const { assert!(C + 1 == A + B) }
    let mut product = [Tracked::ZERO; C];
    for i in 0..A {
        for j in 0..B {
            let term = a[i] * b[j];
            product[i + j] = if i == 0 || j == B - 1 { term } else { product[i + j] + term };
        }
    }
    product
}

/// The square of a polynomial; `C` is `2 A - 1`.
#[inline]
pub(crate) fn square<const A: usize, const C: usize>(a: &[Tracked; A]) -> [Tracked; C] {
    const { assert!(C + 1 == 2 * A) }
    let mut square = [Tracked::ZERO; C];
    for power in 0..C {
        // The terms before the middle one come twice.
        let mut sum = Tracked::ZERO;
        for i in (power + 1).saturating_sub(A)..power.div_ceil(2) {
            let term = a[i] * a[power - i];
            sum = if i == (power + 1).saturating_sub(A) { term } else { sum + term };
        }
        sum = sum.doubled();
        square[power] = if power % 2 == 1 {
            sum
        } else if power == 0 || power == C - 1 {
            a[power / 2] * a[power / 2]
        } else {
            sum + a[power / 2] * a[power / 2]
        };
    }
    square
}

#[inline]
pub(crate) fn add<const N: usize>(a: [Tracked; N], b: [Tracked; N]) -> [Tracked; N] {
    core::array::from_fn(|i| a[i] + b[i])
}

#[inline]
pub(crate) fn sub<const N: usize>(a: [Tracked; N], b: [Tracked; N]) -> [Tracked; N] {
    core::array::from_fn(|i| a[i] - b[i])
}

#[inline]
pub(crate) fn times<const N: usize>(a: [Tracked; N], factor: f64) -> [Tracked; N] {
    a.map(|a| a.times(factor))
}

/// The same polynomial with more coefficients.
#[inline]
pub(crate) fn padded<const A: usize, const B: usize>(a: [Tracked; A]) -> [Tracked; B] {
    let mut padded = [Tracked::ZERO; B];
    padded[..A].copy_from_slice(&a);
    padded
}

/// The value at x.
#[inline]
pub(crate) fn at(coefficients: &[Tracked], x: f64) -> Tracked {
    let mut descending = coefficients.iter().rev().skip_while(|c| c.size == 0.0);
    let first = descending.next().copied().unwrap_or(Tracked::ZERO);
    descending.fold(first, |value, &coefficient| value.times(x) + coefficient)
}
