//! All zeros of a condition, each in an interval of its own.

use super::bernstein::{Bernstein, POINTS, Zeros, points};
use super::condition::Condition;
use super::polynomial::Normalized;
use super::product::Product;
use super::samples::Samples;
use crate::system::SystemError;

/// An interval of speeds with a zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bracket {
    pub(super) low: f64,
    pub(super) high: f64,
    /// Where the zero is, if it is the only one, with about six digits; where there may be several or none that are too
    /// close to be told apart, nothing.
    pub(super) zero: Option<f64>,
}

/// Where intervals are divided: not in the middle, where zeros are that come from numbers of few digits.
const DIVISION: f64 = 0.484_375;

/// The most points at which a polynomial is computed in all of its range. Of higher degrees it differs so much in size there
/// that rounding is left of most of it, and it is computed in parts.
const MOST_POINTS: usize = 60;

/// The most intervals in which a condition is interpolated anew: usual are less than thirty. What is left then is left to
/// others as it is.
const MOST_INTERPOLATIONS: usize = 400;

/// How often a polynomial is halved before it is interpolated anew in what is left, which is more precise.
const HALVINGS: usize = 4;

/// The brackets, ascending, in which a condition has zeros.
///
/// Where zeros cannot be told apart in an interval whose width is less than `narrow`, relative to the speed, it is left to
/// others.
///
/// In `x = v / (1 + v)` the condition is a polynomial of known degree. It is interpolated in intervals, and the coefficients
/// of its form of Bernstein tell for each how many zeros are in it; where they do not, it is divided.
pub(super) fn isolate<F: Condition>(
    condition: &Normalized<'_, F>,
    is_polynomial: bool,
    narrow: f64,
) -> Result<Vec<Bracket>, SystemError> {
    if is_polynomial && condition.degree() == 0 {
        return Ok(Vec::new());
    }
    let count = condition.degree() + 1;
    let is_exact = is_polynomial && count <= POINTS;
    let mut search = Search { condition, is_exact, narrow, interpolations: 0, brackets: Vec::new() };
    let interval = condition.range().map(|v| v / (1.0 + v));
    if is_polynomial && !is_exact && count <= MOST_POINTS {
        let products = Samples::points(interval, count).map(|x| condition.at(speed(x)));
        let samples = Samples::new(interval, &products.collect::<Result<Vec<_>, _>>()?);
        search.examine_part(&samples, interval)?;
    } else {
        search.interpolate(interval)?;
    }
    Ok(search.brackets)
}

fn speed(x: f64) -> f64 {
    x / (1.0 - x)
}

struct Search<'a, F> {
    condition: &'a Normalized<'a, F>,
    is_exact: bool,
    narrow: f64,
    interpolations: usize,
    brackets: Vec<Bracket>,
}

impl<F: Condition> Search<'_, F> {
    /// Reads a part of the range from the polynomial that is known in all of it, unless rounding there is too much for that.
    fn examine_part(&mut self, samples: &Samples, interval: [f64; 2]) -> Result<(), SystemError> {
        let (mut values, mut errors) = ([0.0; POINTS], [0.0; POINTS]);
        for ((value, error), x) in values.iter_mut().zip(&mut errors).zip(points(interval)) {
            (*value, *error) = samples.at(x);
        }
        let polynomial = Bernstein::new(&values, &errors, false);
        let zeros = polynomial.zeros();
        if self.accept(&polynomial, zeros, interval) {
            return Ok(());
        }
        if zeros == Zeros::Unknown && polynomial.is_resolved() {
            return self.interpolate(interval);
        }
        let [from, to] = interval;
        let middle = from + DIVISION * (to - from);
        self.examine_part(samples, [from, middle])?;
        self.examine_part(samples, [middle, to])
    }

    /// Computes the condition at points in an interval.
    fn interpolate(&mut self, interval: [f64; 2]) -> Result<(), SystemError> {
        self.interpolations += 1;
        let mut products = [Product::ONE; POINTS];
        for (product, x) in products.iter_mut().zip(points(interval)) {
            *product = self.condition.at(speed(x))?;
        }
        let unit = products.iter().map(|product| product.exponent).max().unwrap_or(0);
        let [values, errors] = [0, 1].map(|part| products.map(|product| <[f64; 2]>::from(product.in_unit(unit))[part]));
        self.examine(&Bernstein::new(&values, &errors, self.is_exact), interval, 0)
    }

    fn examine(&mut self, polynomial: &Bernstein, interval: [f64; 2], halvings: usize) -> Result<(), SystemError> {
        if self.accept(polynomial, polynomial.zeros(), interval) {
            return Ok(());
        }
        let [from, to] = interval;
        let middle = from + DIVISION * (to - from);
        if halvings < HALVINGS {
            let [left, right] = polynomial.split(DIVISION);
            self.examine(&left, [from, middle], halvings + 1)?;
            self.examine(&right, [middle, to], halvings + 1)
        } else {
            self.interpolate([from, middle])?;
            self.interpolate([middle, to])
        }
    }

    /// Whether all is known of an interval, or nothing more is sought.
    fn accept(&mut self, polynomial: &Bernstein, zeros: Zeros, [from, to]: [f64; 2]) -> bool {
        let [low, high] = [from, to].map(speed);
        match zeros {
            Zeros::None => {}
            Zeros::One => {
                let zero = speed(from + (to - from) * polynomial.zero());
                self.brackets.push(Bracket { low, high, zero: Some(zero) });
            }
            _ if high - low <= self.narrow * low || self.interpolations >= MOST_INTERPOLATIONS => {
                self.brackets.push(Bracket { low, high, zero: None });
            }
            _ => return false,
        }
        true
    }
}
