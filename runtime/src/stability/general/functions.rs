//! The functions of the speed that matrices are multiplied by.

use super::field::RealField;

/// What a function is at a speed, and its derivative; none of what does not depend on it.
pub(super) type Values<R> = [(R, Option<R>); 5];

/// The places of the functions among their values.
pub(super) const OVER_SPEED: usize = 0;
pub(super) const ONE: usize = 1;
pub(super) const SPEED: usize = 2;
pub(super) const SQUARE: usize = 3;
pub(super) const GRAVITY: usize = 4;

/// The values at a scaled speed and a scaled gravitational field strength. At rest the first one is infinite.
pub(super) fn values<R: RealField>(v: R, gravity: f64) -> Values<R> {
    let one = R::from(1.0);
    let over = one / v;
    [(over, Some(-(over * over))), (one, None), (v, Some(one)), (v * v, Some(v + v)), (R::from(gravity), None)]
}
