//! Polynomials of known degree, as arrays of their coefficients, ascending.

use super::double_double::Part;
use super::tracked::Tracked;

/// The coefficients of a polynomial whose degree is known when the program is compiled.
pub(crate) trait Fixed<T = f64>: Copy + AsRef<[Tracked<T>]> + AsMut<[Tracked<T>]> {
    /// The number of coefficients.
    const COUNT: usize;
    /// With the same number for all of them.
    fn filled(number: Tracked<T>) -> Self;
    /// The first of them.
    fn first(&self) -> Tracked<T>;
}

impl<T: Part, const N: usize> Fixed<T> for [Tracked<T>; N] {
    const COUNT: usize = N;

    #[inline(always)]
    fn filled(number: Tracked<T>) -> Self {
        [number; N]
    }
    #[inline(always)]
    fn first(&self) -> Tracked<T> {
        self[0]
    }
}

/// The product of two polynomials, which has as many coefficients as both together, less one.
#[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
#[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
pub(crate) fn product<T: Part, A: Fixed<T>, B: Fixed<T>, C: Fixed<T>>(a: &A, b: &B) -> C {
    const { assert!(C::COUNT + 1 == A::COUNT + B::COUNT) }
    let mut result = C::filled(a.first().zero());
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
#[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
#[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
pub(crate) fn square<T: Part, A: Fixed<T>, C: Fixed<T>>(a: &A) -> C {
    const { assert!(C::COUNT + 1 == 2 * A::COUNT) }
    let zero = a.first().zero();
    let mut result = C::filled(zero);
    let a = a.as_ref();
    // A coefficient is always there. Indexing would link a panic into the programs of microcontrollers, where loops are not
    // unrolled; here and below.
    let coefficient = |power: usize| a.get(power).copied().unwrap_or(zero);
    // Only what is given to a function can be told to be inlined.
    let term = core::convert::identity(
        #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
        |i: usize, j: usize| coefficient(i) * coefficient(j),
    );
    for (power, square) in result.as_mut().iter_mut().enumerate() {
        // The terms before the middle one come twice.
        let first = (power + 1).saturating_sub(A::COUNT);
        let mut sum = zero;
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

/// The sum of two polynomials, of which the first may have more coefficients: those of the second are added from the power
/// `shift` on.
#[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
#[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
pub(crate) fn add<T: Part, A: Fixed<T>, B: Fixed<T>>(mut a: A, b: B, shift: usize) -> A {
    for (a, &b) in a.as_mut().iter_mut().skip(shift).zip(b.as_ref()) {
        *a = *a + b;
    }
    a
}

/// Each coefficient through a function.
#[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
#[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
pub(crate) fn map<T: Part, A: Fixed<T>>(mut a: A, f: impl Fn(Tracked<T>) -> Tracked<T>) -> A {
    for coefficient in a.as_mut() {
        *coefficient = f(*coefficient);
    }
    a
}

/// The same polynomial with more coefficients.
#[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
#[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
pub(crate) fn padded<T: Part, A: Fixed<T>, B: Fixed<T>>(a: A) -> B {
    let mut padded = B::filled(a.first().zero());
    padded.as_mut().iter_mut().zip(a.as_ref()).for_each(|(padded, a)| *padded = *a);
    padded
}

/// The value at x.
#[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
#[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
pub(crate) fn evaluate(coefficients: &[Tracked], x: f64) -> Tracked {
    let mut descending = coefficients.iter().rev().skip_while(|c| c.size == 0.0);
    let first = descending.next().copied().unwrap_or(Tracked::ZERO);
    descending.fold(first, |value, &coefficient| value.times(x) + coefficient)
}
