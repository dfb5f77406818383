//! The equations solved for the accelerations, of mass matrices that are symmetric and positive.

use crate::number::lane::Lane;

/// Replaces the rows of `[K C]` by those of `M^-1 [K C]`, by M = L D L^T, which needs no pivots. True where M is symmetric,
/// positive, and not nearly singular.
#[inline(always)]
pub(super) fn solve<T: Lane, const H: usize, const C: usize>(
    n: usize,
    mut m: [[T; H]; H],
    sides: &mut [[T; C]; H],
) -> T::Mask {
    assert!(n <= H && 2 * n <= C);
    // What is left of a diagonal entry has so many of its digits at least.
    const LEFT: f64 = 1.0 / (1u64 << 24) as f64;
    let (zero, one) = (m[0][0].like(0.0), m[0][0].like(1.0));
    let mut is_regular = zero.less(m[0][0]);
    for i in 1..n {
        is_regular = is_regular & zero.less(m[i][i]);
        for j in 0..i {
            is_regular = is_regular & (m[i][j] - m[j][i]).abs().less_or_equal(zero);
        }
    }
    let mut least = [zero; H];
    for i in 0..n {
        least[i] = m[i][i] * m[i][i].like(LEFT);
    }
    let mut inverse = [zero; H];
    for j in 0..n {
        is_regular = is_regular & least[j].less(m[j][j]);
        inverse[j] = one / m[j][j];
        let side = sides[j];
        for i in j + 1..n {
            let factor = m[i][j] * inverse[j];
            for k in j + 1..=i {
                m[i][k] = m[i][k] - factor * m[k][j];
            }
            for k in 0..2 * n {
                sides[i][k] = sides[i][k] - factor * side[k];
            }
        }
        for i in j + 1..n {
            m[i][j] = m[i][j] * inverse[j];
        }
    }
    for j in (0..n).rev() {
        for k in 0..2 * n {
            sides[j][k] = sides[j][k] * inverse[j];
        }
    }
    for j in (1..n).rev() {
        let side = sides[j];
        for i in 0..j {
            let factor = m[j][i];
            for k in 0..2 * n {
                sides[i][k] = sides[i][k] - factor * side[k];
            }
        }
    }
    is_regular
}
