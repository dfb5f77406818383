//! A condition as a polynomial: without the powers of the speed that it has at its ends.

use super::condition::Condition;
use super::product::Product;
use crate::system::SystemError;

/// A condition divided by `v^low (1 + v)^(high - low)`, which are its powers toward zero and toward infinity: a polynomial
/// of degree `high - low` in `v / (1 + v)`, not zero at either end.
pub(super) struct Normalized<'a, F> {
    condition: &'a F,
    low: Asymptote,
    high: Asymptote,
}

/// What a condition is proportional to toward an end.
#[derive(Clone, Copy, Debug)]
struct Asymptote {
    power: i32,
    /// The speed beyond which there is nothing else.
    from: f64,
}

impl<'a, F: Condition> Normalized<'a, F> {
    /// `None` if the condition is zero at all speeds, as far as rounding tells.
    pub(super) fn new(condition: &'a F) -> Result<Option<Self>, SystemError> {
        let (low, high) = (asymptote(condition, -1)?, asymptote(condition, 1)?);
        Ok(low.zip(high).map(|(low, high)| Self { condition, low, high }))
    }

    /// Over a range, as it is; `None` if it is zero all over it, as far as rounding tells.
    pub(super) fn over_range(condition: &'a F, [low, high]: [f64; 2]) -> Result<Option<Self>, SystemError> {
        const POINTS: i32 = 7;
        for k in 1..POINTS {
            let v = low + (high - low) * f64::from(k) / f64::from(POINTS);
            if condition.at(v)?.error <= CERTAIN {
                let [low, high] = [low, high].map(|from| Asymptote { power: 0, from });
                return Ok(Some(Self { condition, low, high }));
            }
        }
        Ok(None)
    }

    /// The speeds outside of which the condition has no zero.
    pub(super) fn range(&self) -> [f64; 2] {
        [self.low.from, self.high.from]
    }

    pub(super) fn degree(&self) -> usize {
        usize::try_from(self.high.power - self.low.power).unwrap_or(0)
    }

    pub(super) fn at(&self, v: f64) -> Result<Product, SystemError> {
        let (low, high) = (self.low.power, self.high.power);
        Ok(self.condition.at(v)?.times_power(v, -low).times_power(1.0 + v, low - high))
    }
}

/// The relative error up to which a condition is known.
const CERTAIN: f64 = 1e-3;

/// The power of the speed that a condition is proportional to, toward zero for the direction -1, toward infinity for 1.
///
/// It is integral where the condition has come close to it at three speeds, each twice the one before, and at a speed that is
/// far beyond as well, unless rounding has the better of it there. `None` if there is nothing but rounding anywhere.
fn asymptote(condition: &impl Condition, direction: i32) -> Result<Option<Asymptote>, SystemError> {
    /// The binary orders of magnitude at which it is tried.
    const ORDERS: [i32; 7] = [8, 12, 16, 20, 26, 34, 44];
    const INTEGRAL: f64 = 0.02;
    let at = |order: i32| condition.at(2f64.powi(direction * order));
    let mut last = None;
    for order in ORDERS {
        let products = [at(order)?, at(order + 1)?, at(order + 2)?];
        if products.iter().any(|product| product.error > CERTAIN) {
            break;
        }
        let slope =
            |from: &Product, to: &Product, orders: i32| (to.log2() - from.log2()) / f64::from(direction * orders);
        let power = slope(&products[0], &products[1], 1).round();
        let agrees = |from: &Product, to: &Product, orders: i32| {
            (slope(from, to, orders) - power).abs() * f64::from(orders) <= INTEGRAL && from.mantissa * to.mantissa > 0.0
        };
        let asymptote = Asymptote { power: power as i32, from: 2f64.powi(direction * order) };
        last = Some(asymptote);
        if agrees(&products[0], &products[1], 1) && agrees(&products[1], &products[2], 1) {
            let far = at(2 * order + 8)?;
            if far.error > CERTAIN || agrees(&products[2], &far, order + 6) {
                return Ok(Some(asymptote));
            }
        }
    }
    Ok(last)
}
