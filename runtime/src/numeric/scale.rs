//! Scaling by powers of two, which rounds nothing.

/// A number that can be scaled.
pub(crate) trait Scaled: Copy {
    /// See [`exponent`].
    fn exponent(self) -> Option<i32>;
    /// See [`ldexp`].
    fn ldexp(self, e: i32) -> Self;
}

impl Scaled for f64 {
    fn exponent(self) -> Option<i32> {
        (self != 0.0).then(|| libm::frexp(self).1)
    }
    fn ldexp(self, e: i32) -> Self {
        // One product rounds as the function does, in less time.
        if (-1022..=1023).contains(&e) {
            self * f64::from_bits(((1023 + i64::from(e)) as u64) << 52)
        } else {
            libm::scalbn(self, e)
        }
    }
}

impl Scaled for f32 {
    fn exponent(self) -> Option<i32> {
        (self != 0.0).then(|| libm::frexpf(self).1)
    }
    fn ldexp(self, e: i32) -> Self {
        libm::scalbnf(self, e)
    }
}

/// The exponent e of `|x| = m 2^e` with m in [1/2, 1); `None` for zero.
pub(crate) fn exponent<T: Scaled>(x: T) -> Option<i32> {
    x.exponent()
}

/// `x 2^e`.
pub(crate) fn ldexp<T: Scaled>(x: T, e: i32) -> T {
    x.ldexp(e)
}
