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
