//! Interpolation of a function in an interval by a polynomial in the form of Bernstein, whose coefficients show where it
//! has no zero.

use core::f64::consts::PI;
use std::sync::OnceLock;

/// The number of points and of coefficients.
pub(super) const POINTS: usize = 17;

type Row = [f64; POINTS];

/// How coefficients follow from values at the points of Chebyshev of the first kind.
struct Interpolation {
    /// In (0, 1), ascending.
    points: Row,
    /// By row the coefficient, by column the point.
    bernstein: [Row; POINTS],
    /// The last coefficients of Chebyshev.
    last: [Row; 3],
}

fn interpolation() -> &'static Interpolation {
    static INTERPOLATION: OnceLock<Interpolation> = OnceLock::new();
    INTERPOLATION.get_or_init(|| {
        let angle = |k: usize| PI * (2 * (POINTS - k) - 1) as f64 / (2 * POINTS) as f64;
        let points: Row = core::array::from_fn(|k| 0.5 * (1.0 + angle(k).cos()));
        let mut bernstein = [[0.0; POINTS]; POINTS];
        for k in 0..POINTS {
            // The polynomial that is one at this point and zero at the others, as a product of (x - x_j) with the
            // coefficients -x_j and 1 - x_j, all times binomials.
            let mut product = [0.0; POINTS];
            product[0] = 1.0;
            for j in (0..POINTS).filter(|&j| j != k) {
                let scale = points[k] - points[j];
                let (low, high) = (-points[j] / scale, (1.0 - points[j]) / scale);
                for i in (0..POINTS).rev() {
                    product[i] = product[i] * low + if i > 0 { product[i - 1] * high } else { 0.0 };
                }
            }
            let mut binomial = 1.0;
            for i in 0..POINTS {
                bernstein[i][k] = product[i] / binomial;
                binomial = binomial * (POINTS - 1 - i) as f64 / (i + 1) as f64;
            }
        }
        let last = core::array::from_fn(|row| {
            let order = POINTS - 3 + row;
            core::array::from_fn(|k| 2.0 / POINTS as f64 * (order as f64 * angle(k)).cos())
        });
        Interpolation { points, bernstein, last }
    })
}

/// The points in an interval, ascending.
pub(super) fn points([from, to]: [f64; 2]) -> [f64; POINTS] {
    interpolation().points.map(|x| from + x * (to - from))
}

/// A polynomial in an interval by its coefficients, each with what it may err by.
#[derive(Clone, Copy)]
pub(super) struct Bernstein {
    value: Row,
    error: Row,
    /// The part of the errors that a higher degree would not have.
    missing: f64,
}

/// What coefficients tell about the zeros in an interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Zeros {
    None,
    One,
    /// Several, or none.
    Several,
    /// The signs of the coefficients are not certain.
    Unknown,
}

impl Bernstein {
    /// From values at the points and what these err by. Where the function is no polynomial of so low a degree, the last
    /// coefficients of Chebyshev tell what is missing.
    pub(super) fn new(values: &Row, errors: &Row, is_exact: bool) -> Self {
        let Interpolation { bernstein, last, .. } = interpolation();
        let along =
            |row: &Row, values: &Row| -> f64 { row.iter().zip(values).map(|(factor, value)| factor * value).sum() };
        let missing =
            if is_exact { 0.0 } else { MISSING * last.iter().map(|row| along(row, values).abs()).fold(0.0, f64::max) };
        let value = core::array::from_fn(|i| along(&bernstein[i], values));
        let error = core::array::from_fn(|i| along(&bernstein[i].map(f64::abs), errors) + missing);
        Self { value, error, missing }
    }

    /// Whether it is rounding that decides about the errors, rather than the degree.
    pub(super) fn is_resolved(&self) -> bool {
        self.error.iter().fold(0.0, |max: f64, error| max.max(*error)) >= 2.0 * self.missing
    }

    /// By the rule of Descartes: no more zeros than changes of sign, and as many but for an even number.
    pub(super) fn zeros(&self) -> Zeros {
        let mut changes = 0;
        let mut last = 0.0;
        for (value, error) in self.value.iter().zip(&self.error) {
            if value.abs() <= *error || value.is_nan() {
                return Zeros::Unknown;
            }
            changes += usize::from(value * last < 0.0);
            last = *value;
        }
        match changes {
            0 => Zeros::None,
            1 => Zeros::One,
            _ => Zeros::Several,
        }
    }

    /// The same polynomial in the parts below and above a fraction of the interval (de Casteljau).
    pub(super) fn split(&self, fraction: f64) -> [Self; 2] {
        let (mut left, mut right) = (*self, *self);
        let mean = |row: &Row, i: usize| row[i] + fraction * (row[i + 1] - row[i]);
        for level in 1..POINTS {
            for i in 0..POINTS - level {
                right.value[i] = mean(&right.value, i);
                right.error[i] = mean(&right.error, i);
            }
            left.value[level] = right.value[0];
            left.error[level] = right.error[0];
        }
        [left, right]
    }

    /// The value at a fraction of the interval.
    fn at(&self, fraction: f64) -> f64 {
        let mut row = self.value;
        for level in 1..POINTS {
            for i in 0..POINTS - level {
                row[i] += fraction * (row[i + 1] - row[i]);
            }
        }
        row[0]
    }

    /// The fraction of the interval at which the only zero is, by false position with halved ends (Dowell & Jarratt 1971).
    pub(super) fn zero(&self) -> f64 {
        const STEPS: usize = 24;
        const CLOSE: f64 = 1e-9;
        let (mut low, mut high) = (0.0, 1.0);
        let (mut below, mut above) = (self.value[0], self.value[POINTS - 1]);
        let mut last = 0.5;
        for _ in 0..STEPS {
            let next = low + (high - low) * (below / (below - above)).clamp(0.01, 0.99);
            let value = self.at(next);
            if value == 0.0 || (next - last).abs() <= CLOSE {
                return next;
            }
            if (value > 0.0) == (below > 0.0) {
                (low, below, above) = (next, value, 0.5 * above);
            } else {
                (high, above, below) = (next, value, 0.5 * below);
            }
            last = next;
        }
        last
    }
}

/// How many times the last coefficients of Chebyshev those that are missing sum to at most: they decay by half or faster.
const MISSING: f64 = 4.0;
