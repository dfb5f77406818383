//! Intervals of real numbers with bounds that rounding can only move outward.
//!
//! A result holds every value that the operation can have, of numbers in its operands, exact or rounded to `f64`. What it
//! holds beyond that is little, except that equal operands are taken for different ones.

mod rounding;
#[cfg(test)]
mod tests;
mod waves;

use self::rounding::{TINY, add_down, mul_down, recip_down, recip_up};

/// A bound, and whether it is itself left out. Infinite bounds always are.
#[derive(Clone, Copy, Debug, PartialEq)]
struct End {
    value: f64,
    open: bool,
}

impl End {
    /// Of the result of an operation: rounded, it may lie on a bound that the exact one does not reach. Only zero is no
    /// sum, product, root or wave of other numbers by rounding, save of numbers too small for `f64`.
    fn rounded(value: f64, open: bool) -> Self {
        Self { value, open: open && (value == 0.0 || value.is_infinite()) }
    }
}

/// All numbers between two bounds, with or without zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    lower: End,
    upper: End,
    /// Zero is left out, wherever the bounds are.
    nonzero: bool,
}

impl Interval {
    /// All numbers.
    pub const ALL: Self = Self::open(f64::NEG_INFINITY, f64::INFINITY);

    /// One number.
    pub const fn point(value: f64) -> Self {
        Self::closed(value, value)
    }

    /// All numbers between two, with them.
    pub const fn closed(lower: f64, upper: f64) -> Self {
        Self { lower: End { value: lower, open: false }, upper: End { value: upper, open: false }, nonzero: false }
    }

    /// All numbers between two, without them.
    pub const fn open(lower: f64, upper: f64) -> Self {
        Self { lower: End { value: lower, open: true }, upper: End { value: upper, open: true }, nonzero: false }
    }

    /// The same with a lower bound that is left out.
    pub const fn without_lower(self) -> Self {
        Self { lower: End { open: true, ..self.lower }, ..self }
    }

    /// The same with an upper bound that is left out.
    pub const fn without_upper(self) -> Self {
        Self { upper: End { open: true, ..self.upper }, ..self }
    }

    /// The same without zero.
    pub const fn without_zero(self) -> Self {
        Self { nonzero: true, ..self }
    }

    /// Whether zero is not inside.
    pub fn excludes_zero(self) -> bool {
        let Self { lower, upper, nonzero } = self;
        nonzero || lower.value > 0.0 || upper.value < 0.0 || self.has_open_zero()
    }

    fn has_open_zero(self) -> bool {
        [self.lower, self.upper].into_iter().any(|end| end.open && end.value == 0.0)
    }

    /// The distance of the bounds.
    pub fn width(self) -> f64 {
        self.upper.value - self.lower.value
    }

    /// Half way between the bounds.
    pub fn middle(self) -> f64 {
        self.lower.value / 2.0 + self.upper.value / 2.0
    }

    /// Whether no negative number is inside.
    pub fn is_nonnegative(self) -> bool {
        self.lower.value >= 0.0
    }

    /// Whether only negative numbers are inside.
    pub fn is_negative(self) -> bool {
        self.upper.value < 0.0 || self.upper.value == 0.0 && self.upper.open
    }

    /// Whether all numbers inside are finite and no number is in both.
    pub fn is_apart_from(self, other: Self) -> bool {
        let bounded = |interval: Self| interval.lower.value.is_finite() && interval.upper.value.is_finite();
        bounded(self)
            && bounded(other)
            && (self.upper.value < other.lower.value || other.upper.value < self.lower.value)
    }

    /// The numbers in both; those in this one if there are none.
    pub fn intersection(self, other: Self) -> Self {
        let tighter = |a: End, b: End, sign: f64| {
            if a.value == b.value {
                End { open: a.open || b.open, ..a }
            } else if a.value * sign > b.value * sign {
                a
            } else {
                b
            }
        };
        let (lower, upper) = (tighter(self.lower, other.lower, 1.0), tighter(self.upper, other.upper, -1.0));
        if lower.value > upper.value {
            return self;
        }
        Self { lower, upper, nonzero: self.nonzero || other.nonzero }
    }

    /// Sums of a number in each.
    fn plus(self, other: Self) -> Self {
        let end = |a: End, b: End, add: fn(f64, f64) -> f64| End::rounded(add(a.value, b.value), a.open || b.open);
        Self {
            lower: end(self.lower, other.lower, add_down),
            upper: end(self.upper, other.upper, |a, b| -add_down(-a, -b)),
            nonzero: false,
        }
    }

    /// Products of a number in each.
    fn times(self, other: Self) -> Self {
        let pairs = [self.lower, self.upper].into_iter().flat_map(|a| [other.lower, other.upper].map(|b| (a, b)));
        let product = |(a, b): (End, End), mul: fn(f64, f64) -> f64| {
            let reached_zero = [a, b].into_iter().any(|end| end.value == 0.0 && !end.open);
            End::rounded(mul(a.value, b.value), (a.open || b.open) && !reached_zero)
        };
        // Of equal bounds one that is inside.
        let least = |a: End, b: End| if b.value < a.value || b.value == a.value && a.open { b } else { a };
        let most = |a: End, b: End| if b.value > a.value || b.value == a.value && a.open { b } else { a };
        let lower = pairs.clone().map(|pair| product(pair, mul_down)).reduce(least);
        let upper = pairs.map(|pair| product(pair, |a, b| -mul_down(-a, b))).reduce(most);
        let nonzero = self.excludes_zero() && other.excludes_zero();
        match (lower, upper) {
            (Some(lower), Some(upper)) => Self { lower, upper, nonzero },
            _ => Self::ALL,
        }
    }

    /// One divided by each number but zero.
    pub fn reciprocal(self) -> Self {
        if self.lower.value < 0.0 && self.upper.value > 0.0 {
            return Self::ALL.without_zero();
        }
        if self.lower.value < 0.0 {
            return -(-self).reciprocal();
        }
        if self.upper.value == 0.0 {
            return Self::ALL.without_zero();
        }
        // From here on no number is negative; a zero at the lower bound is left out.
        let lower = match self.upper.value {
            f64::INFINITY => End { value: 0.0, open: true },
            value => End::rounded(recip_down(value), self.upper.open),
        };
        let upper = match self.lower.value {
            0.0 => End { value: f64::INFINITY, open: true },
            value => End::rounded(recip_up(value), self.lower.open),
        };
        Self { lower, upper, nonzero: true }
    }

    /// Whole powers; zero is left out of the base where the exponent is negative.
    pub fn power(self, exponent: i32) -> Self {
        if exponent < 0 {
            return self.power(-exponent).reciprocal();
        }
        let nonzero = self.excludes_zero();
        let even = exponent % 2 == 0;
        let power = |end: End, up: bool| {
            let size = (0..exponent).fold(1.0, |power, _| {
                if up { -mul_down(-power, end.value.abs()) } else { mul_down(power, end.value.abs()) }
            });
            End::rounded(size, end.open)
        };
        let signed = |end: End, up: bool| {
            if end.value < 0.0 { End { value: -power(end, !up).value, ..end } } else { power(end, up) }
        };
        if exponent == 0 {
            Self::point(1.0)
        } else if !even {
            Self { lower: signed(self.lower, false), upper: signed(self.upper, true), nonzero }
        } else if self.lower.value >= 0.0 {
            Self { lower: power(self.lower, false), upper: power(self.upper, true), nonzero }
        } else if self.upper.value <= 0.0 {
            Self { lower: power(self.upper, false), upper: power(self.lower, true), nonzero }
        } else {
            let [low, high] = [self.lower, self.upper].map(|end| power(end, true));
            let upper = if high.value > low.value || high.value == low.value && low.open { high } else { low };
            Self { lower: End { value: 0.0, open: nonzero }, upper, nonzero }
        }
    }

    /// Square roots of the numbers that are not negative.
    pub fn sqrt(self) -> Self {
        let least = Self::closed(0.0, f64::INFINITY).without_upper();
        let Self { lower, upper, nonzero } = self.intersection(least);
        let root = |end: End, outward: fn(f64) -> f64| {
            let root = end.value.max(0.0).sqrt();
            let error = root.mul_add(root, -end.value);
            // On the wrong side of the exact root, or too small to tell.
            let rounded_inward = error != 0.0 && (error < 0.0) == (outward(root) > root);
            let unclear = root != 0.0 && end.value < TINY;
            End::rounded(if rounded_inward || unclear { outward(root).max(0.0) } else { root }, end.open)
        };
        Self { lower: root(lower, f64::next_down), upper: root(upper, f64::next_up), nonzero }
    }
}

impl std::iter::Sum for Interval {
    fn sum<I: Iterator<Item = Self>>(parts: I) -> Self {
        parts.reduce(Self::plus).unwrap_or(Self::point(0.0))
    }
}

impl std::iter::Product for Interval {
    fn product<I: Iterator<Item = Self>>(parts: I) -> Self {
        parts.reduce(Self::times).unwrap_or(Self::point(1.0))
    }
}

impl std::ops::Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        let negative = |end: End| End { value: -end.value, ..end };
        Self { lower: negative(self.upper), upper: negative(self.lower), ..self }
    }
}
