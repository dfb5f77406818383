//! Where two polynomials in the square of the eigenvalue have a root in common, as a polynomial in the speed.

// Places are those of several arrays.
#![allow(clippy::needless_range_loop)]

use super::characteristic::MOST;
use super::terms::Terms;

/// Room for those that are made of the coefficients of the characteristic polynomial.
pub(super) const ROOM: usize = 32;

type Polynomial = Terms<ROOM>;

/// What is zero where two polynomials f and g, of the same degree or g of one less, have a root in common: the determinant of
/// Bezout's matrix, by its first row.
pub(super) struct CommonRoot {
    pub(super) determinant: Polynomial,
    degree: usize,
    /// Where the determinant is zero they are to each other as the powers of the root: the cofactors of the first row.
    cofactors: [Polynomial; MOST],
}

impl CommonRoot {
    /// Of polynomials by their coefficients, ascending, f of degree one to four; `None` if there is no room for it.
    pub(super) fn new<const R: usize>(degree: usize, f: &[Terms<R>], g: &[Terms<R>]) -> Option<Self> {
        let mut bezout = [[Polynomial::ZERO; MOST]; MOST];
        for i in 0..degree {
            for j in i..degree {
                let products = (0..=i.min(degree - 1 - j)).flat_map(|k| {
                    let (high, low) = (j + k + 1, i - k);
                    [(1.0, f.get(high), g.get(low)), (-1.0, f.get(low), g.get(high))]
                });
                let products = products.filter_map(|(sign, f, g)| Some((sign, f?, g?)));
                bezout[i][j] = Terms::sum(products)?;
                bezout[j][i] = bezout[i][j];
            }
        }
        let minor = |rows: [usize; 2], columns: [usize; 2]| {
            let [[a, b], [c, d]] = rows.map(|row| columns.map(|column| &bezout[row][column]));
            Polynomial::sum([(1.0, a, d), (-1.0, b, c)].into_iter())
        };
        let mut cofactors = [Polynomial::ZERO; MOST];
        if degree == 1 {
            // There is one entry, and f tells the root.
            let one = Terms::<1>::new(&[(1.0, 0.0)]);
            let of_f = |sign: f64, coefficient: &Terms<R>| Polynomial::sum([(sign, &one, coefficient)].into_iter());
            let cofactors = [of_f(1.0, &f[1])?, of_f(-1.0, &f[0])?, Polynomial::ZERO, Polynomial::ZERO];
            return Some(Self { determinant: bezout[0][0], degree, cofactors });
        }
        if degree == 2 {
            cofactors[0] = bezout[1][1];
            cofactors[1] = bezout[1][0].times(-1.0);
        } else if degree == 3 {
            cofactors[0] = minor([1, 2], [1, 2])?;
            cofactors[1] = minor([1, 2], [2, 0])?;
            cofactors[2] = minor([1, 2], [0, 1])?;
        } else {
            let mut below = [[Polynomial::ZERO; MOST]; MOST];
            for i in 0..MOST {
                for j in i + 1..MOST {
                    below[i][j] = minor([2, 3], [i, j])?;
                }
            }
            for (omitted, cofactor) in cofactors.iter_mut().enumerate() {
                let [i, j, k] = [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]][omitted];
                let sign = if omitted % 2 == 0 { 1.0 } else { -1.0 };
                let terms = [(sign, i, &below[j][k]), (-sign, j, &below[i][k]), (sign, k, &below[i][j])].into_iter();
                *cofactor = Polynomial::sum(terms.map(|(sign, column, minor)| (sign, &bezout[1][column], minor)))?;
            }
        }
        let determinant = Polynomial::sum((0..degree).map(|j| (1.0, &bezout[0][j], &cofactors[j])))?;
        Some(Self { determinant, degree, cofactors })
    }

    /// The root in common near a zero x of the determinant; `None` where several are.
    pub(super) fn at(&self, x: f64) -> Option<f64> {
        const AGREEING: f64 = 1e-4;
        let [one, root, square, _] = self.cofactors.each_ref().map(|cofactor| cofactor.at(x));
        let [first, second] = [root / one, square / root];
        // Of less than three powers there is no second ratio.
        (self.degree < 3 || (first - second).abs() <= AGREEING * first.abs()).then_some(first)
    }
}

#[cfg(test)]
mod tests {
    use super::CommonRoot;
    use crate::stability::general::polynomials::terms::Terms;

    /// f = (y - x)(y - 2)(y - 5) and g = (y - 3)(y - 7) have a root in common at x = 3 and x = 7, which is x; of degree four
    /// with the factors y + 1 and y + 4.
    #[test]
    fn is_found_with_the_speeds_at_which_it_is() {
        let linear = |values: [f64; 2]| Terms::<9>::new(&values.map(|x| (x, 0.0)));
        let times = |[constant, slope]: [&[f64]; 2]| -> Vec<Terms<9>> {
            let coefficient = |power: usize| [constant, slope].map(|part| part.get(power).copied().unwrap_or(0.0));
            (0..constant.len().max(slope.len())).map(|power| linear(coefficient(power))).collect()
        };
        let cubic = times([&[0.0, 10.0, -7.0, 1.0], &[-10.0, 7.0, -1.0]]);
        let quadratic = times([&[21.0, -10.0, 1.0], &[]]);
        let quartic = times([&[0.0, 10.0, 3.0, -6.0, 1.0], &[-10.0, -3.0, 6.0, -1.0]]);
        let four = times([&[84.0, -19.0, -6.0, 1.0], &[]]);
        for (degree, f, g) in [(3, cubic, quadratic), (4, quartic, four)] {
            let common = CommonRoot::new(degree, &f, &g).expect("room for it");
            for x in [3.0, 7.0] {
                assert!(common.determinant.at(x).abs() <= 1e-9 * common.determinant.at(4.0).abs());
                let root = common.at(x).expect("one root");
                assert!((root - x).abs() <= 1e-12 * x, "{root} at {x}");
            }
            assert!(common.determinant.at(5.0) * common.determinant.at(1.0) < 0.0);
        }
    }
}
