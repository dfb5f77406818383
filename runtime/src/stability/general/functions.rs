//! The functions that matrices are multiplied by: of the speed, or of another parameter.

use super::field::RealField;

/// What a function is at a speed, and its derivative; none of what does not depend on it.
pub(super) type Values<R> = Vec<(R, Option<R>)>;

/// What the equations depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Variable {
    /// The scaled speed, from zero on, at a scaled gravitational field strength.
    Speed { gravity: f64 },
    /// A parameter over a range, as a number from 1 to 2. The functions are Chebyshev's polynomials up to a degree.
    Parameter { degree: usize },
}

/// The places of the functions of the speed among their values.
pub(super) const OVER_SPEED: usize = 0;
pub(super) const ONE: usize = 1;
pub(super) const SPEED: usize = 2;
pub(super) const SQUARE: usize = 3;
pub(super) const GRAVITY: usize = 4;

impl Variable {
    /// The values of all functions. At rest the first one of the speed is infinite.
    pub(super) fn values<R: RealField>(self, v: R) -> Values<R> {
        let one = R::from(1.0);
        match self {
            Self::Speed { gravity } => {
                let (over, gravity) = (one / v, R::from(gravity));
                vec![(over, Some(-(over * over))), (one, None), (v, Some(one)), (v * v, Some(v + v)), (gravity, None)]
            }
            Self::Parameter { degree } => {
                // From -1 to 1, with the derivative 2.
                let (t, zero, two) = (v + v - R::from(3.0), R::from(0.0), R::from(2.0));
                let mut values = vec![(one, None), (t, Some(two))];
                while values.len() <= degree {
                    let [(before, by_before), (last, by_last)] =
                        [values.len() - 2, values.len() - 1].map(|k| values[k]);
                    let (by_before, by_last) = (by_before.unwrap_or(zero), by_last.unwrap_or(zero));
                    let derivative = (last * two + t * by_last) * two - by_before;
                    values.push((t * last * two - before, Some(derivative)));
                }
                values
            }
        }
    }

    /// Values of which none is special, to see at them what holds everywhere.
    pub(super) fn samples(self) -> [f64; 5] {
        match self {
            Self::Speed { .. } => [0.137, 0.613, 1.291, 3.17, 11.9],
            Self::Parameter { .. } => [1.137, 1.291, 1.483, 1.613, 1.871],
        }
    }

    /// The lower end, and the upper one if there is one.
    pub(super) fn ends(self) -> (f64, Option<f64>) {
        match self {
            Self::Speed { .. } => (0.0, None),
            Self::Parameter { .. } => (1.0, Some(2.0)),
        }
    }
}
