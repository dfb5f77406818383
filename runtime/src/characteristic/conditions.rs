//! What is zero where a characteristic polynomial is critical: the Hurwitz determinant, where two eigenvalues sum to zero,
//! and the discriminant, where two of them coincide.

use core::ops::{Mul, Sub};

use super::powers::{Powers, Variable};
use crate::numeric::Part;
#[cfg(feature = "std")]
use crate::numeric::Polynomial;
use crate::numeric::fixed::{add, map, product, square};

/// The products that both conditions of a quartic have, in the variable V.
pub(crate) struct QuarticConditions<'a, V: Variable, T: Part = f64> {
    p: &'a Powers<V, T>,
    p13: V::P1P3<T>,
    /// `p_1 p_2 p_3`.
    first: V::Hurwitz<T>,
    /// `p_1^2 p_4 + p_0 p_3^2`.
    rest: V::Hurwitz<T>,
}

impl<'a, V: Variable, T: Part> QuarticConditions<'a, V, T> {
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn new(p: &'a Powers<V, T>) -> Self {
        let p13: V::P1P3<T> = product(&p.p1, &p.p3);
        let p33: V::P3P3<T> = square(&p.p3);
        let p11: V::Hurwitz<T> = square(&p.p1);
        let p033: V::Hurwitz<T> = product(&p33, &p.p0);
        Self { p, first: product(&p13, &p.p2), rest: add(map(p11, |p11| p.p4 * p11), p033, 0), p13 }
    }

    /// The Hurwitz determinant `p_1 p_2 p_3 - p_1^2 p_4 - p_0 p_3^2`, without the power of the variable that
    /// [`Variable::LACKING`] says.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn hurwitz(&self) -> V::Hurwitz<T> {
        add(self.first, map(self.rest, |rest| -rest), 0)
    }

    /// The discriminant `4 I^3 - J^2`, up to a factor, with the invariants I and J of the quartic.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn discriminant(&self) -> V::Discriminant<T> {
        let Powers { p0, p2, p4, .. } = self.p;
        let p04 = map(*p0, |p0| *p4 * p0);
        let p22: V::P0<T> = square(p2);
        // I = 12 p_0 p_4 - 3 p_1 p_3 + p_2^2.
        let i = add(map(p04, |p04| p04.scaled(12.0)), p22, 0);
        let i = add(i, map(self.p13, |p13| -p13.scaled(3.0)), V::LACKING);
        // J = p_2 (72 p_0 p_4 - 2 p_2^2) + 9 p_1 p_2 p_3 - 27 (p_1^2 p_4 + p_0 p_3^2).
        let even = add(map(p04, |p04| p04.scaled(72.0)), map(p22, |p22| -p22.doubled()), 0);
        let odd = add(map(self.first, |first| first.scaled(9.0)), map(self.rest, |rest| -rest.scaled(27.0)), 0);
        let j: V::J<T> = product(p2, &even);
        let j = add(j, odd, V::LACKING);
        let ii: V::II<T> = square(&i);
        let iii: V::Discriminant<T> = product(&ii, &i);
        let jj: V::Discriminant<T> = square(&j);
        add(map(iii, |iii| iii.doubled().doubled()), map(jj, |jj| -jj), 0)
    }
}

/// The Hurwitz determinant of a cubic, ascending.
pub(crate) fn hurwitz_of_cubic<T: Mul<Output = T> + Sub<Output = T>>([p0, p1, p2, p3]: [T; 4]) -> T {
    p1 * p2 - p0 * p3
}

/// The discriminant of the cubic `a s^3 + b s^2 + c s + d`.
#[cfg(feature = "std")]
pub(crate) fn discriminant_of_cubic([d, c, b, a]: [&Polynomial; 4]) -> Polynomial {
    let (bc, ad) = (&(b * c), &(a * d));
    let cubes = &(&(b * b) * b) * d + &(&(c * c) * c) * a;
    bc * bc + &(bc * ad) * 18.0 - &(ad * ad) * 27.0 - &cubes * 4.0
}

/// The discriminant of the quadratic `a s^2 + b s + c`.
#[cfg(feature = "std")]
pub(crate) fn discriminant_of_quadratic([c, b, a]: [&Polynomial; 3]) -> Polynomial {
    b * b - &(a * c) * 4.0
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::{QuarticConditions, discriminant_of_cubic, discriminant_of_quadratic, hurwitz_of_cubic};
    use crate::characteristic::powers::{Matrices, Powers};
    use crate::numeric::fixed::evaluate;
    use crate::numeric::{Polynomial, Tracked};

    fn constants<const N: usize>(values: [f64; N]) -> [Polynomial; N] {
        values.map(Polynomial::constant)
    }

    fn constant(polynomial: &Polynomial) -> f64 {
        polynomial.coefficients()[0].value.to_f64()
    }

    /// The Hurwitz determinant is the product of all sums of two roots, up to the sign, and the discriminant the square of
    /// that of all differences; that of the quartic is 27 times as large.
    #[test]
    fn are_products_over_pairs_of_roots() {
        // (s + 1)(s + 2)(s + 3)(s + 4)
        let quartic = Powers::of_numbers([24.0, 50.0, 35.0, 10.0, 1.0].map(Tracked::from));
        let conditions = QuarticConditions::new(&quartic);
        assert_eq!(conditions.hurwitz()[0].value.to_f64(), 3.0 * 4.0 * 5.0 * 5.0 * 6.0 * 7.0);
        assert_eq!(conditions.discriminant()[0].value.to_f64(), 27.0 * 12.0 * 12.0);
        // (s + 1)(s + 2)(s + 4)
        assert_eq!(constant(&hurwitz_of_cubic(constants([8.0, 14.0, 7.0, 1.0]))), 3.0 * 5.0 * 6.0);
        assert_eq!(constant(&discriminant_of_cubic(constants([8.0, 14.0, 7.0, 1.0]).each_ref())), 6.0 * 6.0);
        // (s + 1)(s + 4)
        assert_eq!(constant(&discriminant_of_quadratic(constants([4.0, 5.0, 1.0]).each_ref())), 3.0 * 3.0);
    }

    /// At a speed, the polynomials in the speed and in its square are what the numbers there give.
    #[test]
    fn are_the_same_in_the_speed_and_at_it() {
        let rows = |x: [f64; 4]| [[x[0], x[1]], [x[2], x[3]]];
        let [m, c1, kc, k2] =
            [[2.0, 1.0, 1.0, 3.0], [1.0, 4.0, -3.0, 2.0], [5.0, 1.0, 1.0, -2.0], [0.0, 3.0, 1.0, 1.0]].map(rows);
        let [c0, k0] = [[1.0, 0.0, 2.0, 5.0], [-1.0, 2.0, 2.0, 1.0]].map(rows);
        let speed = 3.0;
        for c0 in [c0, rows([0.0; 4])] {
            let matrices = Matrices::new([m, c0, c1, kc, k0, k2], 2.0);
            let powers = matrices.in_speed();
            let there = powers.padded::<[Tracked; 5]>().map(|p| evaluate(&p, speed));
            let there = Powers::of_numbers(there);
            let (all, there) = (QuarticConditions::new(&powers), QuarticConditions::new(&there));
            assert_eq!(evaluate(&all.hurwitz(), speed).value, there.hurwitz()[0].value);
            assert_eq!(evaluate(&all.discriminant(), speed).value, there.discriminant()[0].value);
            if matrices.are_undamped_at_rest() {
                let square = speed * speed;
                let powers = matrices.in_square();
                let all = QuarticConditions::new(&powers);
                // Two powers of the speed are left out.
                assert_eq!(evaluate(&all.hurwitz(), square).times(square).value, there.hurwitz()[0].value);
                assert_eq!(evaluate(&all.discriminant(), square).value, there.discriminant()[0].value);
            }
        }
    }
}
