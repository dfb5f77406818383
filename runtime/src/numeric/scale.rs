//! Scaling by powers of two, which rounds nothing.

/// The exponent e of `|x| = m 2^e` with m in [1/2, 1); `None` for zero.
pub(crate) fn exponent(x: f64) -> Option<i32> {
    (x != 0.0).then(|| libm::frexp(x).1)
}

/// `x 2^e`.
pub(crate) fn ldexp(x: f64, e: i32) -> f64 {
    libm::scalbn(x, e)
}
