//! Polynomials of known degree, as arrays of their coefficients, ascending.

use super::tracked::Tracked;

/// The coefficients of a polynomial whose degree is known when the program is compiled.
pub(crate) trait Fixed: Copy + AsRef<[Tracked]> + AsMut<[Tracked]> {
    /// The number of coefficients.
    const COUNT: usize;
    const ZERO: Self;
}

impl<const N: usize> Fixed for [Tracked; N] {
    const COUNT: usize = N;
    const ZERO: Self = [Tracked::ZERO; N];
}

/// The product of two polynomials, which has as many coefficients as both together, less one.
#[inline]
pub(crate) fn product<A: Fixed, B: Fixed, C: Fixed>(a: &A, b: &B) -> C {
    const { assert!(C::COUNT + 1 == A::COUNT + B::COUNT) }
    let mut result = C::ZERO;
    let (a, b, product) = (a.as_ref(), b.as_ref(), result.as_mut());
    for i in 0..A::COUNT {
        for j in 0..B::COUNT {
            let term = a[i] * b[j];
            product[i + j] = if i == 0 || j == B::COUNT - 1 { term } else { product[i + j] + term };
        }
    }
    result
}

/// The square of a polynomial.
#[inline]
pub(crate) fn square<A: Fixed, C: Fixed>(a: &A) -> C {
    const { assert!(C::COUNT + 1 == 2 * A::COUNT) }
    let mut result = C::ZERO;
    let a = a.as_ref();
    let term = |i: usize, j: usize| coefficient(a, i) * coefficient(a, j);
    for (power, square) in result.as_mut().iter_mut().enumerate() {
        // The terms before the middle one come twice.
        let first = (power + 1).saturating_sub(A::COUNT);
        let mut sum = Tracked::ZERO;
        for i in first..power.div_ceil(2) {
            let term = term(i, power - i);
            sum = if i == first { term } else { sum + term };
        }
        sum = sum.doubled();
        *square = if power % 2 == 1 {
            sum
        } else if power == 0 || power == C::COUNT - 1 {
            term(power / 2, power / 2)
        } else {
            sum + term(power / 2, power / 2)
        };
    }
    result
}

/// A coefficient, which is always there. Indexing would link a panic into the programs of microcontrollers, where loops are not
/// unrolled; here and below.
#[inline(always)]
fn coefficient(a: &[Tracked], power: usize) -> Tracked {
    a.get(power).copied().unwrap_or(Tracked::ZERO)
}

/// The sum of two polynomials, of which the first may have more coefficients: those of the second are added from the power
/// `shift` on.
#[inline]
pub(crate) fn add<A: Fixed, B: Fixed>(mut a: A, b: B, shift: usize) -> A {
    for (a, &b) in a.as_mut().iter_mut().skip(shift).zip(b.as_ref()) {
        *a = *a + b;
    }
    a
}

/// Each coefficient through a function.
#[inline]
pub(crate) fn map<A: Fixed>(mut a: A, f: impl Fn(Tracked) -> Tracked) -> A {
    for coefficient in a.as_mut() {
        *coefficient = f(*coefficient);
    }
    a
}

/// The same polynomial with more coefficients.
#[inline]
pub(crate) fn padded<A: Fixed, B: Fixed>(a: A) -> B {
    let mut padded = B::ZERO;
    padded.as_mut().iter_mut().zip(a.as_ref()).for_each(|(padded, a)| *padded = *a);
    padded
}

/// The value at x.
#[inline]
pub(crate) fn evaluate(coefficients: &[Tracked], x: f64) -> Tracked {
    let mut descending = coefficients.iter().rev().skip_while(|c| c.size == 0.0);
    let first = descending.next().copied().unwrap_or(Tracked::ZERO);
    descending.fold(first, |value, &coefficient| value.times(x) + coefficient)
}
