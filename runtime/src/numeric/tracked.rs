//! Numbers that know when they have cancelled.

use core::ops::{Add, Mul, Neg, Sub};

use super::double_double::{DoubleDouble, Part};

/// What is left of a sum, relative to the terms that went into it, when only rounding is left.
///
/// A double-double operation errs by 2^-104; the longest chain here, the discriminant and its evaluation, has fewer than
/// 2^10 operations.
pub(crate) const NOISE: f64 = 1.0 / (1u128 << 94) as f64;

/// A number together with the sum of the magnitudes of the terms that it was computed from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tracked<T = f64> {
    pub(crate) value: DoubleDouble<T>,
    pub(crate) size: T,
}

impl<T: Part> Tracked<T> {
    /// The product with one number without error.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn times(self, factor: T) -> Self {
        Self { value: self.value.times(factor), size: self.size * factor.abs() }
    }

    /// The product with a constant.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn scaled(self, factor: f64) -> Self {
        self.times(self.size.like(factor))
    }

    /// Twice the number.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn doubled(self) -> Self {
        Self { value: self.value.doubled(), size: self.size + self.size }
    }

    /// Zero, in as many lanes as this number has.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn zero(self) -> Self {
        DoubleDouble::from(self.size.like(0.0)).into()
    }

    /// This number, or its opposite where a mask is true.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn opposite_where(self, mask: T::Mask) -> Self {
        Self { value: DoubleDouble::choose(mask, -self.value, self.value), size: self.size }
    }
}

impl Tracked {
    pub(crate) const ZERO: Self = Self { value: DoubleDouble::ZERO, size: 0.0 };

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

impl<T: Part> From<DoubleDouble<T>> for Tracked<T> {
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    fn from(value: DoubleDouble<T>) -> Self {
        Self { value, size: value.high().abs() }
    }
}

impl From<f64> for Tracked {
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    fn from(value: f64) -> Self {
        DoubleDouble::from(value).into()
    }
}

impl<T: Part> Neg for Tracked<T> {
    type Output = Self;
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    fn neg(self) -> Self {
        Self { value: -self.value, size: self.size }
    }
}

impl<T: Part> Add for Tracked<T> {
    type Output = Self;
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    fn add(self, other: Self) -> Self {
        Self { value: self.value.add_roughly(other.value), size: self.size + other.size }
    }
}

impl<T: Part> Sub for Tracked<T> {
    type Output = Self;
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Part> Mul for Tracked<T> {
    type Output = Self;
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    fn mul(self, other: Self) -> Self {
        Self { value: self.value * other.value, size: self.size * other.size }
    }
}

/// A number without error, whose product with another one is exact and with any other number takes little.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Exact<T = f64>(pub(crate) T);

impl<T: Part> Mul for Exact<T> {
    type Output = Tracked<T>;
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    fn mul(self, other: Self) -> Tracked<T> {
        DoubleDouble::product(self.0, other.0).into()
    }
}

impl<T: Part> Mul<Tracked<T>> for Exact<T> {
    type Output = Tracked<T>;
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    fn mul(self, other: Tracked<T>) -> Tracked<T> {
        other.times(self.0)
    }
}
