//! All zeros of a condition, each in an interval of its own.

use super::bernstein::{Bernstein, POINTS, Zeros, points};
use super::condition::Condition;
use super::polynomial::Normalized;
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
    let is_exact = is_polynomial && condition.degree() < POINTS;
    let mut search = Search { condition, is_exact, narrow, brackets: Vec::new() };
    search.interpolate(condition.range().map(|v| v / (1.0 + v)))?;
    Ok(search.brackets)
}

struct Search<'a, F> {
    condition: &'a Normalized<'a, F>,
    is_exact: bool,
    narrow: f64,
    brackets: Vec<Bracket>,
}

impl<F: Condition> Search<'_, F> {
    fn interpolate(&mut self, interval: [f64; 2]) -> Result<(), SystemError> {
        let mut products = points(interval).into_iter().map(|x| self.condition.at(x / (1.0 - x)));
        let first = products.next().transpose()?;
        let mut values = [first.unwrap_or(super::product::Product::ONE); POINTS];
        for (value, product) in values[1..].iter_mut().zip(products) {
            *value = product?;
        }
        let unit = values.iter().map(|value| value.exponent).max().unwrap_or(0);
        let value = values.map(|value| crate::numeric::ldexp(value.mantissa, value.exponent - unit));
        let error: [f64; POINTS] = core::array::from_fn(|i| {
            // Even where it is nothing but rounding it is of the size of that.
            value[i].abs() * values[i].error.min(1.0) + f64::MIN_POSITIVE
        });
        let polynomial = Bernstein::new(&value, &error, self.is_exact);
        self.examine(&polynomial, interval, 0)
    }

    fn examine(&mut self, polynomial: &Bernstein, [from, to]: [f64; 2], halvings: usize) -> Result<(), SystemError> {
        let speed = |x: f64| x / (1.0 - x);
        let [low, high] = [from, to].map(speed);
        match polynomial.zeros() {
            Zeros::None => return Ok(()),
            Zeros::One => {
                let zero = speed(from + (to - from) * polynomial.zero());
                self.brackets.push(Bracket { low, high, zero: Some(zero) });
                return Ok(());
            }
            Zeros::Unknown if high - low <= self.narrow * low => {
                self.brackets.push(Bracket { low, high, zero: None });
                return Ok(());
            }
            Zeros::Unknown => {}
        }
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
}
