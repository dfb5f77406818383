//! The coefficients of the characteristic polynomial in s as polynomials in the speed.

use super::determinant::{Rows, determinant, mixed};
use crate::numeric::fixed::{Fixed, map, padded};
use crate::numeric::{Exact, Tracked};

/// What the coefficients are polynomials in: by it the numbers of their coefficients are known, and those of all that is
/// made of them.
///
/// For the matrices M, C0, C1, Kc, K0 and K2 the coefficients p_0 to p_3 are of degree 4, 3, 2 and 1 in the speed, and p_4
/// does not depend on it.
pub(crate) trait Variable {
    type P0: Fixed;
    type P1: Fixed;
    type P2: Fixed;
    type P3: Fixed;
    /// Of `p_1 p_3`.
    type P1P3: Fixed;
    /// Of `p_3^2`.
    type P3P3: Fixed;
    /// Of the Hurwitz determinant.
    type Hurwitz: Fixed;
    /// Of the invariant J of the quartic.
    type J: Fixed;
    /// Of the square of the invariant I, which itself has those of p_0.
    type II: Fixed;
    /// Of the discriminant.
    type Discriminant: Fixed;
    /// The power of the variable that `p_1 p_3` and the Hurwitz determinant lack.
    const LACKING: usize;
}

/// The speed.
pub(crate) struct InSpeed;

impl Variable for InSpeed {
    type P0 = [Tracked; 5];
    type P1 = [Tracked; 4];
    type P2 = [Tracked; 3];
    type P3 = [Tracked; 2];
    type P1P3 = [Tracked; 5];
    type P3P3 = [Tracked; 3];
    type Hurwitz = [Tracked; 7];
    type J = [Tracked; 7];
    type II = [Tracked; 9];
    type Discriminant = [Tracked; 13];
    const LACKING: usize = 0;
}

/// The square of the speed, without damping at rest (C0 = 0): then p_1 and p_3 are odd in the speed, and stand here divided
/// by it.
pub(crate) struct InSquare;

impl Variable for InSquare {
    type P0 = [Tracked; 3];
    type P1 = [Tracked; 2];
    type P2 = [Tracked; 2];
    type P3 = [Tracked; 1];
    type P1P3 = [Tracked; 2];
    type P3P3 = [Tracked; 1];
    type Hurwitz = [Tracked; 3];
    type J = [Tracked; 4];
    type II = [Tracked; 5];
    type Discriminant = [Tracked; 7];
    const LACKING: usize = 1;
}

/// One speed: the coefficients are numbers.
pub(crate) struct AtOneSpeed;

impl Variable for AtOneSpeed {
    type P0 = [Tracked; 1];
    type P1 = [Tracked; 1];
    type P2 = [Tracked; 1];
    type P3 = [Tracked; 1];
    type P1P3 = [Tracked; 1];
    type P3P3 = [Tracked; 1];
    type Hurwitz = [Tracked; 1];
    type J = [Tracked; 1];
    type II = [Tracked; 1];
    type Discriminant = [Tracked; 1];
    const LACKING: usize = 0;
}

/// The characteristic polynomial `p_0 + p_1 s + p_2 s^2 + p_3 s^3 + p_4 s^4`.
pub(crate) struct Powers<V: Variable> {
    pub(crate) p0: V::P0,
    pub(crate) p1: V::P1,
    pub(crate) p2: V::P2,
    pub(crate) p3: V::P3,
    pub(crate) p4: Tracked,
}

impl<V: Variable> Powers<V> {
    /// All of its coefficients, each with as many of its own.
    #[inline]
    pub(crate) fn padded<P: Fixed>(&self) -> [P; 5] {
        let Self { p0, p1, p2, p3, p4 } = *self;
        [padded(p0), padded(p1), padded(p2), padded(p3), padded([p4])]
    }

    /// With the last coefficient positive.
    #[inline]
    fn normalized(self) -> Self {
        let is_negative = self.p4.value.to_f64() < 0.0;
        let positive = |p: Tracked| if is_negative { -p } else { p };
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
pub(crate) struct Matrices {
    m: Rows<Exact>,
    c0: Rows<Exact>,
    c1: Rows<Exact>,
    k: Rows<Tracked>,
    k2: Rows<Exact>,
    /// The determinant of the mass matrix.
    pub(crate) mass: Tracked,
}

impl Matrices {
    /// From the rows of M, C0, C1, Kc, K0 and K2.
    #[inline]
    pub(crate) fn new(rows: [Rows; 6], gravity: f64) -> Self {
        let [m, c0, c1, kc, k0, k2] = rows;
        let exact = |[[a, b], [c, d]]: Rows| [[Exact(a), Exact(b)], [Exact(c), Exact(d)]];
        let [m, c0, c1, k2] = [exact(m), exact(c0), exact(c1), exact(k2)];
        let stiffness = |i: usize, j: usize| Exact(gravity) * Exact(k0[i][j]) + kc[i][j].into();
        let k = [[stiffness(0, 0), stiffness(0, 1)], [stiffness(1, 0), stiffness(1, 1)]];
        Self { m, c0, c1, k, k2, mass: determinant(m) }
    }

    #[inline]
    pub(crate) fn are_undamped_at_rest(&self) -> bool {
        self.c0 == [[Exact(0.0); 2]; 2]
    }

    /// In the speed.
    #[inline]
    pub(crate) fn in_speed(&self) -> Powers<InSpeed> {
        let Self { m, c0, c1, k, k2, mass } = *self;
        Powers {
            p0: [determinant(k), Tracked::ZERO, mixed(k2, k), Tracked::ZERO, determinant(k2)],
            p1: [mixed(c0, k), mixed(c1, k), mixed(c0, k2), mixed(c1, k2)],
            p2: [mixed(m, k) + determinant(c0), mixed(c0, c1), mixed(m, k2) + determinant(c1)],
            p3: [mixed(m, c0), mixed(m, c1)],
            p4: mass,
        }
        .normalized()
    }

    /// In the square of the speed, without damping at rest.
    #[inline]
    pub(crate) fn in_square(&self) -> Powers<InSquare> {
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
