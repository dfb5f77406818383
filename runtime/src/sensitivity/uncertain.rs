//! Arithmetic with measured numbers: their deviations, and what of them is common to several, go along exactly to first order.

use std::cell::{Cell, RefCell};
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::covariance::Covariance;
use super::deviation::root_sum_square;

/// Where the deviations of numbers come from: sources that are independent of each other and of unit variance.
///
/// ```
/// use carvallo::Sources;
///
/// // A rod of (12 +- 0.3) kg and (2 +- 0.04) m: m l^2/12 is 4 kg m^2, of which the mass moves 2.5 %, and the length 4 %.
/// let sources = Sources::default();
/// let (m, l) = (sources.measured(12.0, 0.3), sources.measured(2.0, 0.04));
/// let inertia = m * l * l / 12.0;
/// assert_eq!(inertia.value(), 4.0);
/// assert!((inertia.deviation() - 4.0 * 0.025_f64.hypot(0.04)).abs() < 1e-15);
/// // What comes from the same measurement cancels.
/// assert_eq!((m / m).deviation(), 0.0);
/// ```
#[derive(Default)]
pub struct Sources {
    count: Cell<usize>,
    /// The derivatives of every number that depends on sources, with respect to each; what is missing at the end is zero.
    gradients: RefCell<Vec<Vec<f64>>>,
}

/// A number with its derivatives with respect to the sources of its deviation.
#[derive(Clone, Copy)]
pub struct Uncertain<'a> {
    sources: &'a Sources,
    value: f64,
    /// The place of its derivatives; `None` of an exact number.
    gradient: Option<usize>,
}

impl Sources {
    /// A number without a deviation.
    pub fn exact(&self, value: f64) -> Uncertain<'_> {
        Uncertain { sources: self, value, gradient: None }
    }

    /// A number with the standard deviation of its measurement, which depends on no other.
    pub fn measured(&self, value: f64, deviation: f64) -> Uncertain<'_> {
        if deviation == 0.0 {
            return self.exact(value);
        }
        let source = self.take(1);
        let mut gradient = vec![0.0; source + 1];
        gradient[source] = deviation;
        self.keep(value, gradient)
    }

    /// Numbers of which it is known how they vary together, in its order.
    pub fn correlated(&self, values: &[f64], covariance: &Covariance) -> Vec<Uncertain<'_>> {
        let parts = covariance.parts();
        let first = self.take(parts.iter().map(Vec::len).max().unwrap_or(0));
        let number = |(&value, parts): (&f64, &Vec<f64>)| {
            let is_exact = parts.iter().all(|&part| part == 0.0);
            if is_exact { self.exact(value) } else { self.keep(value, [&vec![0.0; first], &parts[..]].concat()) }
        };
        values.iter().zip(parts).map(number).collect()
    }

    /// How numbers vary together.
    ///
    /// # Errors
    /// If a derivative is not finite.
    pub fn covariance(&self, numbers: &[Uncertain]) -> Result<Covariance, super::SensitivityError> {
        Covariance::of_parts(numbers.iter().map(|number| number.parts()).collect())
    }

    fn take(&self, count: usize) -> usize {
        self.count.replace(self.count.get() + count)
    }

    fn keep(&self, value: f64, gradient: Vec<f64>) -> Uncertain<'_> {
        let mut gradients = self.gradients.borrow_mut();
        gradients.push(gradient);
        Uncertain { sources: self, value, gradient: Some(gradients.len() - 1) }
    }
}

impl<'a> Uncertain<'a> {
    /// The number.
    pub fn value(self) -> f64 {
        self.value
    }

    /// Its standard deviation, to first order.
    pub fn deviation(self) -> f64 {
        root_sum_square(self.parts().into_iter())
    }

    /// Its derivatives with respect to the sources, which are the parts of its deviation that come from each; what is missing
    /// at the end is zero.
    pub fn parts(self) -> Vec<f64> {
        self.gradient.map_or(Vec::new(), |place| self.sources.gradients.borrow()[place].clone())
    }

    /// Its square.
    pub fn squared(self) -> Self {
        self.map(self.value * self.value, 2.0 * self.value)
    }

    /// Its square root.
    pub fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.map(root, 0.5 / root)
    }

    /// The sine of an angle in radians.
    pub fn sin(self) -> Self {
        self.map(self.value.sin(), self.value.cos())
    }

    /// The cosine of an angle in radians.
    pub fn cos(self) -> Self {
        self.map(self.value.cos(), -self.value.sin())
    }

    /// The tangent of an angle in radians.
    pub fn tan(self) -> Self {
        let tangent = self.value.tan();
        self.map(tangent, 1.0 + tangent * tangent)
    }

    /// The angle in radians, between -pi/2 and pi/2, of which this is the sine.
    pub fn asin(self) -> Self {
        self.map(self.value.asin(), 1.0 / (1.0 - self.value * self.value).sqrt())
    }

    /// The angle in radians of the point (`x`, `self`).
    pub fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        self.combine(self.value.atan2(x.value), x.value / square, x, -self.value / square)
    }

    fn map(self, value: f64, slope: f64) -> Self {
        self.combine(value, slope, self.sources.exact(0.0), 0.0)
    }

    /// A value that depends on two numbers with these slopes.
    fn combine(self, value: f64, slope: f64, other: Self, other_slope: f64) -> Self {
        let gradient = {
            let gradients = self.sources.gradients.borrow();
            let of = |number: Self| number.gradient.map_or(&[][..], |place| &gradients[place][..]);
            let (own, others) = (of(self), of(other));
            let at = |gradient: &[f64], slope: f64, source: usize| gradient.get(source).map_or(0.0, |by| slope * by);
            let sum = |source: usize| at(own, slope, source) + at(others, other_slope, source);
            (0..own.len().max(others.len())).map(sum).collect::<Vec<f64>>()
        };
        if gradient.is_empty() { self.sources.exact(value) } else { self.sources.keep(value, gradient) }
    }
}

impl fmt::Debug for Sources {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Sources").field("count", &self.count.get()).finish_non_exhaustive()
    }
}

impl fmt::Debug for Uncertain<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} +/- {}", self.value, self.deviation())
    }
}

impl Add for Uncertain<'_> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.combine(self.value + other.value, 1.0, other, 1.0)
    }
}

impl Sub for Uncertain<'_> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.combine(self.value - other.value, 1.0, other, -1.0)
    }
}

impl Mul for Uncertain<'_> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        self.combine(self.value * other.value, other.value, other, self.value)
    }
}

impl Div for Uncertain<'_> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        self.combine(quotient, 1.0 / other.value, other, -quotient / other.value)
    }
}

impl Neg for Uncertain<'_> {
    type Output = Self;

    fn neg(self) -> Self {
        self.map(-self.value, -1.0)
    }
}

impl Add<f64> for Uncertain<'_> {
    type Output = Self;

    fn add(self, number: f64) -> Self {
        self.map(self.value + number, 1.0)
    }
}

impl Sub<f64> for Uncertain<'_> {
    type Output = Self;

    fn sub(self, number: f64) -> Self {
        self.map(self.value - number, 1.0)
    }
}

impl Mul<f64> for Uncertain<'_> {
    type Output = Self;

    fn mul(self, number: f64) -> Self {
        self.map(self.value * number, number)
    }
}

impl Div<f64> for Uncertain<'_> {
    type Output = Self;

    fn div(self, number: f64) -> Self {
        self.map(self.value / number, 1.0 / number)
    }
}

#[cfg(test)]
mod tests {
    use super::{Sources, Uncertain};
    use crate::sensitivity::Covariance;

    /// Each function against the slope of its secant, which needs no derivative.
    #[test]
    fn slopes_are_those_of_the_functions() {
        let (x, y, step) = (0.37, -0.83, 1e-6);
        type Function = for<'a> fn(Uncertain<'a>, Uncertain<'a>) -> Uncertain<'a>;
        let functions: [Function; 15] = [
            |x, y| x + y,
            |x, y| x - y,
            |x, y| x * y,
            |x, y| x / y,
            |x, _| -x,
            |x, _| x + 2.0,
            |x, _| x - 2.0,
            |x, _| x * 3.0,
            |x, _| x / 3.0,
            |x, _| x.squared(),
            |x, _| x.sqrt(),
            |x, _| x.sin() * x.cos(),
            |_, y| y.tan(),
            |_, y| y.asin(),
            |x, y| y.atan2(x),
        ];
        for (index, function) in functions.into_iter().enumerate() {
            let sources = Sources::default();
            let exact = |x: f64, y: f64| function(sources.exact(x), sources.exact(y)).value();
            let slopes = [exact(x + step, y) - exact(x - step, y), exact(x, y + step) - exact(x, y - step)]
                .map(|d| d / (2.0 * step));
            let parts = function(sources.measured(x, 1.0), sources.measured(y, 1.0)).parts();
            for (source, slope) in slopes.into_iter().enumerate() {
                let found = parts.get(source).copied().unwrap_or(0.0);
                assert!((found - slope).abs() < 1e-8 * (1.0 + slope.abs()), "function {index}: {found}, not {slope}");
            }
        }
    }

    #[test]
    fn numbers_that_vary_together_go_on_doing_so() {
        let sources = Sources::default();
        let other = sources.measured(1.0, 0.1);
        let covariance = Covariance::of_correlations(&[3.0, 4.0], &[(0, 1, -0.8)]).unwrap();
        let [x, y] = sources.correlated(&[10.0, 20.0], &covariance)[..] else { panic!("two") };
        assert!(((x + y).deviation() - 5.8_f64.sqrt()).abs() < 1e-14);
        assert!(((x + other).deviation() - 3.0_f64.hypot(0.1)).abs() < 1e-14);
        let found = sources.covariance(&[x, y, x + y]).unwrap();
        assert!((found.correlation(0, 1) + 0.8).abs() < 1e-15);
        // cov(x, x + y) = 9 - 9.6.
        assert!((found.correlation(2, 0) + 0.6 / (3.0 * 5.8_f64.sqrt())).abs() < 1e-15);
    }
}
