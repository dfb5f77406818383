//! Scaling by powers of two, which rounds nothing.

/// The exponent e of `|x| = m 2^e` with m in [1/2, 1); `None` for zero.
pub(crate) fn exponent(x: f64) -> Option<i32> {
    (x != 0.0).then(|| libm::frexp(x).1)
}

/// `x 2^e`.
pub(crate) fn ldexp(x: f64, e: i32) -> f64 {
    libm::scalbn(x, e)
}

/// Exponents r and c that bring the largest entry of each row and column of `2^(r_i + c_j) m_ij` into [1/2, 1).
///
/// `None` if a row or a column is zero.
pub(crate) fn equilibrate(m: [[f64; 2]; 2]) -> Option<([i32; 2], [i32; 2])> {
    let e = m.map(|row| row.map(exponent));
    let r = [-e[0][0].max(e[0][1])?, -e[1][0].max(e[1][1])?];
    let column = |j: usize| e[0][j].map(|e| e + r[0]).max(e[1][j].map(|e| e + r[1]));
    Some((r, [-column(0)?, -column(1)?]))
}
