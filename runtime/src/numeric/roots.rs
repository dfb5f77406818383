//! All positive roots of a polynomial, none lost and none twice.
//!
//! Between two neighbouring stationary points a polynomial is monotonic and has one root if its sign changes, none if
//! not. The stationary points are the roots of the derivative, which has one degree less; so the roots of all
//! derivatives, from the last one up, isolate those of the polynomial.

use super::double_double::DoubleDouble;
use super::polynomial::Polynomial;
use super::scale::ldexp;
use crate::number::real::Real;

/// A positive root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Root {
    pub(crate) at: DoubleDouble,
    /// How far the root may move if the terms of the polynomial are rounded to `f64`.
    pub(crate) error: f64,
    /// The sign of the polynomial just below the root.
    pub(crate) before: i8,
    /// The sign just above; the same as below where the polynomial touches zero or cannot be told from one that does.
    pub(crate) after: i8,
}

/// The roots in (0, infinity), ascending; none for the zero polynomial.
///
/// Without those that rounding the terms to `f64` might as well move to zero or to infinity: they come from a first or a
/// last coefficient that should have cancelled to zero.
pub(crate) fn positive_roots(polynomial: &Polynomial) -> Vec<Root> {
    candidates(polynomial).into_iter().filter(Root::is_there).collect()
}

/// The roots in (0, infinity), ascending, with those that may be at zero or at infinity.
pub(crate) fn candidates(polynomial: &Polynomial) -> Vec<Root> {
    let polynomial = polynomial.without_zero_roots();
    match polynomial.in_square() {
        Some(in_square) => roots_on_half_line(&in_square).into_iter().map(square_root).collect(),
        None => roots_on_half_line(&polynomial),
    }
}

impl Root {
    /// Whether no rounding of the terms moves the root to zero or to infinity.
    pub(crate) fn is_there(&self) -> bool {
        self.error < self.at.to_f64()
    }
}

fn square_root(root: Root) -> Root {
    let at = root.at.sqrt();
    // sqrt(x + e) - sqrt(x), without cancellation, for an error of any size.
    let error = root.error / (at.to_f64() + (root.at.to_f64() + root.error).sqrt());
    let error = if root.is_there() { error } else { f64::INFINITY };
    Root { at, error, ..root }
}

/// Splits the half-line at a point t and maps both parts to (0, 1): x = t y below, x = t / y above.
fn roots_on_half_line(polynomial: &Polynomial) -> Vec<Root> {
    let degree = polynomial.coefficients().len().saturating_sub(1);
    if degree == 0 {
        return Vec::new();
    }
    // One of more points than there are roots is no root.
    let no_root = |&t: &f64| polynomial.stretched(t).at(DoubleDouble::from(1.0)).sign() != 0;
    let t = (0..=degree).map(|i| 1.0 + i as f64 / 16.0).find(no_root).unwrap_or(1.0);
    let stretched = polynomial.stretched(t);
    let scale = DoubleDouble::from(t);
    let below = roots_in_unit_interval(&stretched).into_iter();
    let above = roots_in_unit_interval(&stretched.reversed()).into_iter().rev();
    let below = below.map(|root| Root { at: root.at * scale, error: root.error * t, ..root });
    let above = above.map(|Root { at, error, before, after }| {
        let reciprocal = scale / at;
        let below = at.to_f64() - error;
        let error = if below > 0.0 { error * reciprocal.to_f64() / below } else { f64::INFINITY };
        Root { at: reciprocal, error, before: after, after: before }
    });
    below.chain(above).collect()
}

/// The roots in (0, 1) of a polynomial that is not zero.
fn roots_in_unit_interval(polynomial: &Polynomial) -> Vec<Root> {
    if polynomial.coefficients().len() < 2 {
        return Vec::new();
    }
    let derivative = polynomial.derivative();
    let stationary = roots_in_unit_interval(&derivative).into_iter().map(|root| root.at);
    let mut roots = Vec::new();
    let first = polynomial.coefficients().iter().map(|c| c.sign()).find(|&sign| sign != 0);
    let (mut low, mut before) = (DoubleDouble::ZERO, first.unwrap_or(0));
    // Stationary points since `low` at which the polynomial is zero.
    let mut zeros: Option<(DoubleDouble, DoubleDouble)> = None;
    for point in stationary.chain([DoubleDouble::from(1.0)]) {
        let sign = polynomial.at(point).sign();
        if sign == 0 {
            zeros = Some((zeros.map_or(point, |(first, _)| first), point));
            continue;
        }
        if let Some(zeros) = zeros.take() {
            roots.push(touching(polynomial, zeros, before, sign));
        } else if sign != before {
            roots.push(crossing(polynomial, &derivative, (low, point), sign));
        }
        (low, before) = (point, sign);
    }
    roots
}

/// The root between two points at which the polynomial has different signs, `after` at the upper one.
///
/// Newton's iteration, with bisection where it leaves the bracket or does not halve its steps.
fn crossing(
    polynomial: &Polynomial,
    derivative: &Polynomial,
    (mut low, mut high): (DoubleDouble, DoubleDouble),
    after: i8,
) -> Root {
    const STEPS: usize = 400;
    const RESOLUTION: f64 = 1.0 / (1u128 << 102) as f64;
    let half = DoubleDouble::from(0.5);
    let mut at = (low + high) * half;
    let mut last_step = (high - low).to_f64();
    for _ in 0..STEPS {
        let value = polynomial.at(at).value;
        if value.to_f64() == 0.0 {
            break;
        }
        if (value.to_f64() > 0.0) == (after > 0) {
            high = at;
        } else {
            low = at;
        }
        let slope = derivative.at(at).value;
        let newton = at - value / slope;
        let step = (newton - at).to_f64().abs();
        let newton_is_good = newton > low && newton < high && step < 0.5 * last_step;
        let next = if newton_is_good { newton } else { (low + high) * half };
        last_step = (next - at).to_f64().abs();
        at = next;
        if last_step <= RESOLUTION * at.to_f64() {
            break;
        }
    }
    Root { at, error: uncertainty(polynomial, at), before: -after, after }
}

/// The root at stationary points where the polynomial is zero to within its noise.
fn touching(polynomial: &Polynomial, zeros: (DoubleDouble, DoubleDouble), before: i8, after: i8) -> Root {
    let at = (zeros.0 + zeros.1) * 0.5.into();
    let spread = (zeros.1 - zeros.0).to_f64();
    Root { at, error: uncertainty(polynomial, at).max(spread), before, after }
}

/// The distance from a root, up to a factor of two, at which the polynomial differs from zero by more than the rounding
/// of its terms to `f64`; at most the root itself.
fn uncertainty(polynomial: &Polynomial, root: DoubleDouble) -> f64 {
    let differs = |x: DoubleDouble| {
        let sum = polynomial.at(x);
        sum.value.to_f64().abs() > f64::EPSILON * sum.size
    };
    // From an eighth of the rounding of the root itself.
    let distances = (-55..0).map(|e| ldexp(root.to_f64(), e));
    let mut outside = distances.skip_while(|&d| !(differs(root - d.into()) && differs(root + d.into())));
    outside.next().unwrap_or(root.to_f64())
}

#[cfg(test)]
mod tests {
    use super::{Root, positive_roots};
    use crate::numeric::{Polynomial, Tracked};

    fn from_roots(roots: &[f64]) -> Polynomial {
        roots.iter().fold(Polynomial::constant(1.0), |product, &root| {
            &product * &Polynomial::new([Tracked::from(-root), Tracked::from(1.0)])
        })
    }

    fn assert_roots(found: &[Root], expected: &[f64]) {
        let speeds: Vec<f64> = found.iter().map(|root| root.at.to_f64()).collect();
        assert_eq!(speeds.len(), expected.len(), "{speeds:?}");
        for (root, &expected) in found.iter().zip(expected) {
            let difference = (root.at.to_f64() - expected).abs();
            assert!(difference <= root.error + 1e-15 * expected, "{expected}: off by {difference:e}, {root:?}");
        }
    }

    #[test]
    fn finds_twelve_simple_roots() {
        let roots = [0.001, 0.1, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 7.0, 100.0, 4096.0];
        let found = positive_roots(&from_roots(&roots));
        assert_roots(&found, &roots);
        assert!(found.iter().all(|root| root.before == -root.after && root.error < 1e-12 * root.at.to_f64()));
    }

    #[test]
    fn tells_touching_from_crossing() {
        let found = positive_roots(&from_roots(&[0.5, 0.5, 2.0, 3.0, 3.0, 3.0, -1.0, 0.0]));
        assert_roots(&found, &[0.5, 2.0, 3.0]);
        assert_eq!(found.iter().map(|root| root.before == root.after).collect::<Vec<_>>(), [true, false, false]);
    }

    #[test]
    fn separates_what_is_close() {
        assert_roots(&positive_roots(&from_roots(&[1.0, 1.0 + 1e-12])), &[1.0, 1.0 + 1e-12]);
    }

    /// Three roots so close that no arithmetic with 32 digits tells them apart.
    #[test]
    fn tells_how_far_roots_may_be_off() {
        let [root] = positive_roots(&from_roots(&[1.0, 1.0 + 1e-12, 1.0 + 2e-12]))[..] else { panic!("one root") };
        assert!(root.before == -root.after && root.error > 1e-12 && root.error < 1e-3);
    }

    #[test]
    fn solves_even_polynomials_in_the_square() {
        let squares = from_roots(&[4.0, 9.0, -16.0]);
        let spread = squares.coefficients().iter().flat_map(|&c| [c, Tracked::ZERO]);
        assert_roots(&positive_roots(&Polynomial::new(spread)), &[2.0, 3.0]);
    }

    #[test]
    fn has_nothing_to_find_without_positive_roots() {
        assert!(positive_roots(&Polynomial::new([])).is_empty());
        assert!(positive_roots(&from_roots(&[0.0, -2.0])).is_empty());
        assert!(positive_roots(&Polynomial::new([1.0, 0.0, 1.0].map(Tracked::from))).is_empty());
    }
}
