//! The coefficients of the characteristic polynomial in s as polynomials in the speed.

use core::ops::Mul;

use super::determinant::{Rows, determinant, mixed};
use crate::numeric::fixed::{Fixed, map, padded};
use crate::numeric::{DoubleDouble, Exact, Part, Tracked};

/// What the coefficients are polynomials in: by it the numbers of their coefficients are known, and those of all that is
/// made of them.
///
/// For the matrices M, C0, C1, Kc, K0 and K2 the coefficients p_0 to p_3 are of degree 4, 3, 2 and 1 in the speed, and p_4
/// does not depend on it.
pub(crate) trait Variable {
    type P0<T: Part>: Fixed<T>;
    type P1<T: Part>: Fixed<T>;
    type P2<T: Part>: Fixed<T>;
    type P3<T: Part>: Fixed<T>;
    /// Of `p_1 p_3`.
    type P1P3<T: Part>: Fixed<T>;
    /// Of `p_3^2`.
    type P3P3<T: Part>: Fixed<T>;
    /// Of the Hurwitz determinant.
    type Hurwitz<T: Part>: Fixed<T>;
    /// Of the invariant J of the quartic.
    type J<T: Part>: Fixed<T>;
    /// Of the square of the invariant I, which itself has those of p_0.
    type II<T: Part>: Fixed<T>;
    /// Of the discriminant.
    type Discriminant<T: Part>: Fixed<T>;
    /// The power of the variable that `p_1 p_3` and the Hurwitz determinant lack.
    const LACKING: usize;
}

/// The speed.
pub(crate) struct InSpeed;

impl Variable for InSpeed {
    type P0<T: Part> = [Tracked<T>; 5];
    type P1<T: Part> = [Tracked<T>; 4];
    type P2<T: Part> = [Tracked<T>; 3];
    type P3<T: Part> = [Tracked<T>; 2];
    type P1P3<T: Part> = [Tracked<T>; 5];
    type P3P3<T: Part> = [Tracked<T>; 3];
    type Hurwitz<T: Part> = [Tracked<T>; 7];
    type J<T: Part> = [Tracked<T>; 7];
    type II<T: Part> = [Tracked<T>; 9];
    type Discriminant<T: Part> = [Tracked<T>; 13];
    const LACKING: usize = 0;
}

/// The square of the speed, without damping at rest (C0 = 0): then p_1 and p_3 are odd in the speed, and stand here divided
/// by it.
pub(crate) struct InSquare;

impl Variable for InSquare {
    type P0<T: Part> = [Tracked<T>; 3];
    type P1<T: Part> = [Tracked<T>; 2];
    type P2<T: Part> = [Tracked<T>; 2];
    type P3<T: Part> = [Tracked<T>; 1];
    type P1P3<T: Part> = [Tracked<T>; 2];
    type P3P3<T: Part> = [Tracked<T>; 1];
    type Hurwitz<T: Part> = [Tracked<T>; 3];
    type J<T: Part> = [Tracked<T>; 4];
    type II<T: Part> = [Tracked<T>; 5];
    type Discriminant<T: Part> = [Tracked<T>; 7];
    const LACKING: usize = 1;
}

/// One speed: the coefficients are numbers.
pub(crate) struct AtOneSpeed;

impl Variable for AtOneSpeed {
    type P0<T: Part> = [Tracked<T>; 1];
    type P1<T: Part> = [Tracked<T>; 1];
    type P2<T: Part> = [Tracked<T>; 1];
    type P3<T: Part> = [Tracked<T>; 1];
    type P1P3<T: Part> = [Tracked<T>; 1];
    type P3P3<T: Part> = [Tracked<T>; 1];
    type Hurwitz<T: Part> = [Tracked<T>; 1];
    type J<T: Part> = [Tracked<T>; 1];
    type II<T: Part> = [Tracked<T>; 1];
    type Discriminant<T: Part> = [Tracked<T>; 1];
    const LACKING: usize = 0;
}

/// The characteristic polynomial `p_0 + p_1 s + p_2 s^2 + p_3 s^3 + p_4 s^4`.
pub(crate) struct Powers<V: Variable, T: Part = f64> {
    pub(crate) p0: V::P0<T>,
    pub(crate) p1: V::P1<T>,
    pub(crate) p2: V::P2<T>,
    pub(crate) p3: V::P3<T>,
    pub(crate) p4: Tracked<T>,
}

impl<V: Variable, T: Part> Powers<V, T> {
    /// All of its coefficients, each with as many of its own.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn padded<P: Fixed<T>>(&self) -> [P; 5] {
        let Self { p0, p1, p2, p3, p4 } = *self;
        [padded(p0), padded(p1), padded(p2), padded(p3), padded([p4])]
    }

    /// With the last coefficient positive.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    fn normalized(self) -> Self {
        let leading = self.p4.value.high();
        let is_negative = leading.less(leading.like(0.0));
        let positive = |p: Tracked<T>| p.opposite_where(is_negative);
        let Self { p0, p1, p2, p3, p4 } = self;
        Self {
            p0: map(p0, positive),
            p1: map(p1, positive),
            p2: map(p2, positive),
            p3: map(p3, positive),
            p4: positive(p4),
        }
    }
}

impl Powers<AtOneSpeed> {
    pub(crate) fn of_numbers([p0, p1, p2, p3, p4]: [Tracked; 5]) -> Self {
        Self { p0: [p0], p1: [p1], p2: [p2], p3: [p3], p4 }
    }
}

/// The matrices that the polynomials are made of, K = Kc + g K0 in twice the precision.
pub(crate) struct Matrices<T = f64> {
    m: Rows<Exact<T>>,
    c0: Rows<Exact<T>>,
    c1: Rows<Exact<T>>,
    k: Rows<Tracked<T>>,
    k2: Rows<Exact<T>>,
    /// The determinant of the mass matrix.
    pub(crate) mass: Tracked<T>,
}

impl<T: Part> Matrices<T> {
    /// From the rows of M, C0, C1, Kc, K0 and K2.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn new(rows: [Rows<T>; 6], gravity: T) -> Self {
        let [m, c0, c1, kc, k0, k2] = rows;
        let exact = |[[a, b], [c, d]]: Rows<T>| [[Exact(a), Exact(b)], [Exact(c), Exact(d)]];
        let [m, c0, c1, k2] = [exact(m), exact(c0), exact(c1), exact(k2)];
        // Only what is given to a function can be told to be inlined.
        let stiffness = core::convert::identity(
            #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
            |i: usize, j: usize| Exact(gravity) * Exact(k0[i][j]) + DoubleDouble::from(kc[i][j]).into(),
        );
        let k = [[stiffness(0, 0), stiffness(0, 1)], [stiffness(1, 0), stiffness(1, 1)]];
        Self { m, c0, c1, k, k2, mass: determinant(m) }
    }

    /// In the speed.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn in_speed(&self) -> Powers<InSpeed, T> {
        let Self { m, c0, c1, k, k2, mass } = *self;
        let zero = mass.zero();
        Powers {
            p0: [determinant(k), zero, shared(k2, k), zero, determinant(k2)],
            p1: [shared(c0, k), shared(c1, k), shared(c0, k2), shared(c1, k2)],
            p2: [shared(m, k) + determinant(c0), shared(c0, c1), shared(m, k2) + determinant(c1)],
            p3: [shared(m, c0), shared(m, c1)],
            p4: mass,
        }
        .normalized()
    }

    /// In the square of the speed, without damping at rest.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn in_square(&self) -> Powers<InSquare, T> {
        let Self { m, c1, k, k2, mass, .. } = *self;
        Powers {
            p0: [determinant(k), mixed(k2, k), determinant(k2)],
            p1: [mixed(c1, k), mixed(c1, k2)],
            p2: [mixed(m, k), mixed(m, k2) + determinant(c1)],
            p3: [mixed(m, c1)],
            p4: mass,
        }
        .normalized()
    }
}

/// The same as [`mixed`], compiled once for a microcontroller, which has little room: of the ten in the speed that takes 3 to 8 kB
/// less. Those in its square stay apart, for they share what their factors are split into.
#[cfg_attr(any(target_os = "none", target_family = "wasm"), inline(never))]
#[cfg_attr(not(any(target_os = "none", target_family = "wasm")), inline(always))]
fn shared<T: Part, X: Copy + Mul<Y, Output = Tracked<T>>, Y: Copy>(x: Rows<X>, y: Rows<Y>) -> Tracked<T> {
    mixed(x, y)
}

impl Matrices {
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn are_undamped_at_rest(&self) -> bool {
        self.c0 == [[Exact(0.0); 2]; 2]
    }
}
