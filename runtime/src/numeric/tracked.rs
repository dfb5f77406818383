//! Numbers that know when they have cancelled.

use core::ops::{Add, Mul, Neg, Sub};

use super::double_double::DoubleDouble;

/// What is left of a sum, relative to the terms that went into it, when only rounding is left.
///
/// A double-double operation errs by 2^-104; the longest chain here, the discriminant and its evaluation, has fewer than
/// 2^10 operations.
pub(crate) const NOISE: f64 = 1.0 / (1u128 << 94) as f64;

/// A number together with the sum of the magnitudes of the terms that it was computed from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tracked {
    pub(crate) value: DoubleDouble,
    pub(crate) size: f64,
}

impl Tracked {
    pub(crate) const ZERO: Self = Self { value: DoubleDouble::ZERO, size: 0.0 };

    /// The product with one `f64`.
    #[inline]
    pub(crate) fn times(self, factor: f64) -> Self {
        Self { value: self.value.times(factor), size: self.size * factor.abs() }
    }

    /// Twice the number.
    #[inline]
    pub(crate) fn doubled(self) -> Self {
        Self { value: self.value.doubled(), size: 2.0 * self.size }
    }

    /// -1, 0 or 1; zero if the terms cancel as far as the arithmetic can tell.
    pub(crate) fn sign(self) -> i8 {
        let value = self.value.to_f64();
        if value.abs() <= NOISE * self.size {
            0
        } else if value < 0.0 {
            -1
        } else {
            1
        }
    }
}

impl From<DoubleDouble> for Tracked {
    #[inline]
    fn from(value: DoubleDouble) -> Self {
        Self { value, size: value.to_f64().abs() }
    }
}

impl From<f64> for Tracked {
    #[inline]
    fn from(value: f64) -> Self {
        DoubleDouble::from(value).into()
    }
}

impl Neg for Tracked {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, size: self.size }
    }
}

impl Add for Tracked {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { value: self.value.add_roughly(other.value), size: self.size + other.size }
    }
}

impl Sub for Tracked {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Tracked {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self { value: self.value * other.value, size: self.size * other.size }
    }
}

/// A number without error, whose product with another one is exact and with any other number takes little.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Exact(pub(crate) f64);

impl Mul for Exact {
    type Output = Tracked;
    #[inline]
    fn mul(self, other: Self) -> Tracked {
        DoubleDouble::product(self.0, other.0).into()
    }
}

impl Mul<Tracked> for Exact {
    type Output = Tracked;
    #[inline]
    fn mul(self, other: Tracked) -> Tracked {
        other.times(self.0)
    }
}
