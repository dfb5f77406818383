//! The characteristic polynomial `det(M s^2 + C s + K)`, whose roots in s are the eigenvalues.
//!
//! - [`units`]: powers of two that bring the entries of matrices of any scale to about one.
//! - [`determinant`]: its coefficients in s at one speed, over any kind of number, and their derivatives.
//! - [`powers`]: its coefficients in s as polynomials in the speed, or in the square of the speed.
//! - [`conditions`]: the Hurwitz determinant and the discriminant: what is zero at critical speeds.
//! - [`double_root`]: Newton's step towards a speed with a double eigenvalue.
//!
//! The determinant is that of two coordinates; units are for any number. Another matrix with its own powers of s and v, as
//! C_-1 or K_1, is a line in `units` and its terms in `powers`.

pub(crate) mod conditions;
pub(crate) mod determinant;
pub(crate) mod double_root;
pub(crate) mod powers;
pub(crate) mod units;
