//! The coefficients of the characteristic polynomial of two coordinates at one speed.

#[cfg(feature = "std")]
use core::ops::Neg;
use core::ops::{Add, Mul, Sub};

use crate::number::Scalar;
use crate::system::Matrix;

/// The entries of a matrix of two coordinates, by rows.
pub(crate) type Rows<T = f64> = [[T; 2]; 2];

/// Something for each of the matrices K, C and M, in the order of the powers of s that they are multiplied by.
pub(crate) type ByPower<T> = [T; 3];

/// The rows of a matrix.
#[inline(always)]
pub(crate) fn rows<T: Scalar>(matrix: &Matrix<T, 2>) -> Rows<T> {
    [[matrix.m11, matrix.m12], [matrix.m21, matrix.m22]]
}

/// `det(X)`.
#[inline(always)]
pub(crate) fn determinant<T, P>(x: Rows<T>) -> P
where
    T: Copy + Mul<T, Output = P>,
    P: Sub<Output = P>,
{
    x[0][0] * x[1][1] - x[0][1] * x[1][0]
}

/// `det(X + Y) - det(X) - det(Y)`: what the determinant of a sum has of both, and its derivative at X in the direction Y.
#[inline(always)]
pub(crate) fn mixed<X, Y, P>(x: Rows<X>, y: Rows<Y>) -> P
where
    X: Copy + Mul<Y, Output = P>,
    Y: Copy,
    P: Add<Output = P> + Sub<Output = P>,
{
    (x[0][0] * y[1][1] - x[0][1] * y[1][0]) + (x[1][1] * y[0][0] - x[1][0] * y[0][1])
}

/// The coefficients of `det(M s^2 + C s + K)` in s, ascending.
#[inline(always)]
pub(crate) fn coefficients<T>([k, c, m]: ByPower<Rows<T>>) -> [T; 5]
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
    [determinant(k), mixed(c, k), mixed(m, k) + determinant(c), mixed(m, c), determinant(m)]
}

/// Their derivatives as the matrices change in a direction.
#[cfg(feature = "std")]
pub(crate) fn derivatives<T>([k, c, m]: ByPower<Rows<T>>, [dk, dc, dm]: ByPower<Rows<T>>) -> [T; 5]
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
    [
        mixed(k, dk),
        mixed(k, dc) + mixed(c, dk),
        mixed(k, dm) + mixed(c, dc) + mixed(m, dk),
        mixed(c, dm) + mixed(m, dc),
        mixed(m, dm),
    ]
}

/// The derivatives of `det(X)` with respect to each entry.
#[cfg(feature = "std")]
pub(crate) fn cofactors<T: Copy + Neg<Output = T>>([[a, b], [c, d]]: Rows<T>) -> Rows<T> {
    [[d, -c], [-b, a]]
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::{ByPower, Rows, coefficients, cofactors, derivatives};

    const MATRICES: ByPower<Rows> = [[[5.0, 1.0], [-2.0, 3.0]], [[1.0, 4.0], [2.0, -1.0]], [[2.0, 1.0], [1.0, 7.0]]];
    const CHANGE: ByPower<Rows> = [[[1.0, -2.0], [4.0, 6.0]], [[3.0, 0.0], [-5.0, 2.0]], [[-1.0, 8.0], [2.0, 1.0]]];

    /// det [5 + s + 2 s^2, 1 + 4 s + s^2; -2 + 2 s + s^2, 3 - s + 7 s^2], multiplied out.
    #[test]
    fn coefficients_are_those_of_the_determinant() {
        assert_eq!(coefficients(MATRICES), [17.0, 4.0, 33.0, -1.0, 13.0]);
    }

    /// The coefficients are quadratic in the entries: what a change adds beside its own is the derivative.
    #[test]
    fn derivatives_are_what_a_change_adds() {
        let mut sum = MATRICES;
        for (entry, change) in
            sum.as_flattened_mut().as_flattened_mut().iter_mut().zip(CHANGE.as_flattened().as_flattened())
        {
            *entry += change;
        }
        let [before, after, own] = [MATRICES, sum, CHANGE].map(coefficients);
        let expected: [f64; 5] = core::array::from_fn(|power| after[power] - before[power] - own[power]);
        assert_eq!(derivatives(MATRICES, CHANGE), expected);
    }

    #[test]
    fn cofactors_are_the_derivatives_by_the_entries() {
        let zero = [[0.0; 2]; 2];
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let mut unit = zero;
            unit[i][j] = 1.0;
            assert_eq!(cofactors(MATRICES[0])[i][j], derivatives([MATRICES[0], zero, zero], [unit, zero, zero])[0]);
        }
    }
}
