//! The characteristic polynomial and the conditions for critical speeds, by coefficients in fixed arrays.

use crate::number::Scalar;
use crate::numeric::Tracked;
use crate::numeric::fixed::{add, padded, product, square, sub, times};
use crate::system::{Coefficients, Matrix};

/// What polynomials along speed are in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Variable {
    Speed,
    /// The square of the speed: without damping at rest (C0 = 0).
    Square,
}

/// The polynomials in a variable x whose roots are the critical speeds, of degree 4, 6 and 12 or half of that.
pub(super) struct Conditions<const P: usize, const H: usize, const D: usize> {
    pub(super) variable: Variable,
    /// `det(M s^2 + (C0 + v C1) s + Kc + g K0 + v^2 K2)`, up to a sign, by powers of s; for [`Variable::Square`] those of
    /// odd powers divided by v. The last one is positive.
    pub(super) p: [[Tracked; P]; 5],
    /// The Hurwitz determinant; for [`Variable::Square`] divided by v^2.
    pub(super) hurwitz: [Tracked; H],
    /// The discriminant.
    pub(super) discriminant: [Tracked; D],
}

pub(super) type OfSquare = Conditions<3, 3, 7>;
pub(super) type OfSpeed = Conditions<5, 7, 13>;

type Rows<T> = [[T; 2]; 2];

/// Matrices with entries of moderate size, `Kc + g K0` in double-double.
pub(super) struct Matrices {
    m: Rows<f64>,
    c0: Rows<f64>,
    c1: Rows<f64>,
    k: Rows<Tracked>,
    k2: Rows<f64>,
    /// The determinant of the mass matrix.
    mass: Tracked,
}

/// Products of 18 numbers within these limits stay in the range of `f64`: those of 12 entries, 6 times with gravity, that
/// the discriminant consists of.
const SMALLEST: f64 = 1e-15;
const LARGEST: f64 = 1e15;

/// The smallest determinant of the mass matrix that is surely not zero, relative to its terms.
const REGULAR: f64 = 16.0 * f64::EPSILON;

impl Matrices {
    /// `None` if the mass matrix may be singular, or if entries are not finite or of unusual size.
    pub(super) fn new<T: Scalar>(coefficients: &Coefficients<T, 2>, gravity: f64) -> Option<Self> {
        let Coefficients { m, c0, c1, kc, k0, k2 } = coefficients;
        let entries = [m, c0, c1, kc, k0, k2].map(rows);
        let is_moderate = |x: f64| (SMALLEST..=LARGEST).contains(&x.abs()) | (x == 0.0);
        // Without a branch for each entry.
        let moderate = entries.as_flattened().as_flattened().iter().fold(true, |all, &x| all & is_moderate(x));
        let [m, c0, c1, kc, k0, k2] = entries;
        let mass = determinant(m);
        if !moderate || !is_moderate(gravity) || mass.value.to_f64().abs() <= REGULAR * mass.size {
            return None;
        }
        let stiffness = |i: usize, j: usize| Tracked::product(gravity, k0[i][j]) + kc[i][j].into();
        let k = [[stiffness(0, 0), stiffness(0, 1)], [stiffness(1, 0), stiffness(1, 1)]];
        Some(Self { m, c0, c1, k, k2, mass })
    }

    pub(super) fn are_undamped_at_rest(&self) -> bool {
        self.c0 == [[0.0; 2]; 2]
    }

    /// The conditions in the square of the speed, without damping at rest.
    pub(super) fn of_square(&self) -> OfSquare {
        let Self { m, c1, k, k2, mass, .. } = *self;
        let positive = |p: Tracked| if mass.value.to_f64() < 0.0 { -p } else { p };
        let p0 = [determinant_of_sums(k), mixed_sums(k2, k), determinant(k2)].map(positive);
        let p1 = [mixed_sums(c1, k), mixed(c1, k2)].map(positive);
        let p2 = [mixed_sums(m, k), mixed(m, k2) + determinant(c1)].map(positive);
        let (p3, p4) = ([positive(mixed(m, c1))], positive(mass));
        let (hurwitz, discriminant) = conditions::<3, 2, 2, 1, 2, 1, 3, 4, 5, 7>((p0, p1, p2, p3, p4), 1);
        let p = [p0, padded(p1), padded(p2), padded(p3), padded([p4])];
        Conditions { variable: Variable::Square, p, hurwitz, discriminant }
    }

    /// The conditions in the speed.
    pub(super) fn of_speed(&self) -> OfSpeed {
        let Self { m, c0, c1, k, k2, mass } = *self;
        let positive = |p: Tracked| if mass.value.to_f64() < 0.0 { -p } else { p };
        let p0 = [determinant_of_sums(k), Tracked::ZERO, mixed_sums(k2, k), Tracked::ZERO, determinant(k2)];
        let p1 = [mixed_sums(c0, k), mixed_sums(c1, k), mixed(c0, k2), mixed(c1, k2)];
        let p2 = [mixed_sums(m, k) + determinant(c0), mixed(c0, c1), mixed(m, k2) + determinant(c1)];
        let p3 = [mixed(m, c0), mixed(m, c1)];
        let (p0, p1) = (p0.map(positive), p1.map(positive));
        let (p2, p3, p4) = (p2.map(positive), p3.map(positive), positive(mass));
        let (hurwitz, discriminant) = conditions::<5, 4, 3, 2, 5, 3, 7, 7, 9, 13>((p0, p1, p2, p3, p4), 0);
        let p = [p0, padded(p1), padded(p2), padded(p3), padded([p4])];
        Conditions { variable: Variable::Speed, p, hurwitz, discriminant }
    }
}

/// The coefficients of a quartic by their own: `p_0` to `p_4`, of which only the last one does not depend on the speed.
type Powers<const P0: usize, const P1: usize, const P2: usize, const P3: usize> =
    ([Tracked; P0], [Tracked; P1], [Tracked; P2], [Tracked; P3], Tracked);

/// The Hurwitz determinant `p_1 p_2 p_3 - p_1^2 p_4 - p_0 p_3^2` and the discriminant `4 I^3 - J^2`, up to a factor, with
/// the invariants I and J of the quartic; `x^odd p_1 p_3` is what the true product is. Products are shared.
#[inline]
fn conditions<
    const P0: usize,
    const P1: usize,
    const P2: usize,
    const P3: usize,
    const P13: usize,
    const P33: usize,
    const H: usize,
    const J: usize,
    const II: usize,
    const D: usize,
>(
    (p0, p1, p2, p3, p4): Powers<P0, P1, P2, P3>,
    odd: usize,
) -> ([Tracked; H], [Tracked; D]) {
    let p13: [Tracked; P13] = product(&p1, &p3);
    let p33: [Tracked; P33] = square(&p3);
    let p11: [Tracked; H] = square(&p1);
    let first: [Tracked; H] = product(&p13, &p2);
    let rest: [Tracked; H] = add(p11.map(|p11| p4 * p11), product(&p33, &p0));

    let p04 = p0.map(|p0| p4 * p0);
    let p22: [Tracked; P0] = square(&p2);
    // I = 12 p_0 p_4 - 3 p_1 p_3 + p_2^2.
    let mut i = add(times(p04, 12.0), p22);
    for power in 0..P13 {
        i[power + odd] = i[power + odd] - p13[power].times(3.0);
    }
    // J = p_2 (72 p_0 p_4 - 2 p_2^2) + 9 p_1 p_2 p_3 - 27 (p_1^2 p_4 + p_0 p_3^2).
    let mut j: [Tracked; J] = product(&p2, &sub(times(p04, 72.0), p22.map(Tracked::doubled)));
    for power in 0..H {
        j[power + odd] = j[power + odd] + (first[power].times(9.0) - rest[power].times(27.0));
    }
    let ii: [Tracked; II] = square(&i);
    let iii: [Tracked; D] = product(&ii, &i);
    let jj: [Tracked; D] = square(&j);
    (sub(first, rest), sub(iii.map(|iii| iii.doubled().doubled()), jj))
}

#[inline]
fn rows<T: Scalar>(matrix: &Matrix<T, 2>) -> Rows<f64> {
    [[matrix.m11.to_f64(), matrix.m12.to_f64()], [matrix.m21.to_f64(), matrix.m22.to_f64()]]
}

#[inline]
fn determinant(x: Rows<f64>) -> Tracked {
    Tracked::product(x[0][0], x[1][1]) - Tracked::product(x[0][1], x[1][0])
}

#[inline]
fn determinant_of_sums(x: Rows<Tracked>) -> Tracked {
    x[0][0] * x[1][1] - x[0][1] * x[1][0]
}

/// `det(x + y) - det(x) - det(y)`.
#[inline]
fn mixed(x: Rows<f64>, y: Rows<f64>) -> Tracked {
    (Tracked::product(x[0][0], y[1][1]) - Tracked::product(x[0][1], y[1][0]))
        + (Tracked::product(y[0][0], x[1][1]) - Tracked::product(y[0][1], x[1][0]))
}

/// The same.
#[inline]
fn mixed_sums(x: Rows<f64>, y: Rows<Tracked>) -> Tracked {
    (y[1][1].times(x[0][0]) - y[1][0].times(x[0][1])) + (y[0][0].times(x[1][1]) - y[0][1].times(x[1][0]))
}
