//! A polynomial of any degree by its values at as many points as it takes.

use core::f64::consts::PI;

use super::product::Product;

/// Values at the points of Chebyshev of the first kind in an interval, all in one unit, with what they err by.
pub(super) struct Samples {
    points: Vec<Sample>,
}

#[derive(Clone, Copy)]
struct Sample {
    x: f64,
    value: f64,
    error: f64,
    /// Of the barycentric formula.
    weight: f64,
}

impl Samples {
    /// So many points, ascending.
    pub(super) fn points([from, to]: [f64; 2], count: usize) -> impl Iterator<Item = f64> {
        (0..count).map(move |k| from + 0.5 * (1.0 + angle(k, count).cos()) * (to - from))
    }

    /// From the values at the points.
    pub(super) fn new(interval: [f64; 2], products: &[Product]) -> Self {
        let count = products.len();
        let unit = products.iter().map(|product| product.exponent).max().unwrap_or(0);
        let sample = |(k, (x, product)): (usize, (f64, &Product))| {
            let (value, error) = product.in_unit(unit);
            let sign = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
            Sample { x, value, error, weight: sign * angle(k, count).sin() }
        };
        Self { points: Self::points(interval, count).zip(products).enumerate().map(sample).collect() }
    }

    /// The value at x of the polynomial through all points, and what it errs by (Berrut & Trefethen 2004).
    pub(super) fn at(&self, x: f64) -> (f64, f64) {
        let (mut value, mut error, mut weights) = (0.0, 0.0, 0.0);
        for sample in &self.points {
            let distance = x - sample.x;
            if distance == 0.0 {
                return (sample.value, sample.error);
            }
            let weight = sample.weight / distance;
            value += weight * sample.value;
            error += weight.abs() * sample.error;
            weights += weight;
        }
        (value / weights, error / weights.abs())
    }
}

/// Of the k-th point, from the last one down.
fn angle(k: usize, count: usize) -> f64 {
    PI * (2 * (count - k) - 1) as f64 / (2 * count) as f64
}

#[cfg(test)]
mod tests {
    use super::{Product, Samples};

    /// x^40 - 0.5 in (0, 2), with 41 points.
    #[test]
    fn a_polynomial_of_high_degree_is_known_between_its_points() {
        let power = |x: f64| x.powi(40) - 0.5;
        let products: Vec<Product> =
            Samples::points([0.0, 2.0], 41).map(|x| Product::ONE.times(power(x), 1e-16)).collect();
        let samples = Samples::new([0.0, 2.0], &products);
        let unit = 2f64.powi(products.iter().map(|product| product.exponent).max().unwrap());
        for x in [0.1, 1.3, 1.9, 1.999] {
            let (value, error) = samples.at(x);
            let rounding = 1e-13 * power(2.0) / unit;
            assert!((value - power(x) / unit).abs() <= error + rounding, "{value} at {x}");
        }
    }
}
