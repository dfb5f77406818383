//! A root in an interval, in plain `f64`.

use super::isolation::Bracket;
use super::rounded::Rounded;
use crate::number::Number;

impl<const N: usize> Rounded<N> {
    /// The root in an interval, to a relative error of about the cube of `close`, by Halley's iteration.
    #[inline]
    pub(crate) fn refine(&self, bracket: &Bracket, close: f64) -> Option<f64> {
        const STEPS: usize = 24;
        let &Bracket { mut low, mut high, guess, rises } = bracket;
        let mut x = if N == 3 { self.quadratic_root(bracket) } else { guess };
        for _ in 0..STEPS {
            let [value, slope, half_curvature] = self.taylor(x);
            if (value > 0.0) == rises {
                high = x;
            } else {
                low = x;
            }
            let step = value * slope / (slope * slope - value * half_curvature);
            let next = x - step;
            if step.abs() <= close * x {
                return Some(next);
            }
            x = if next > low && next < high {
                next
            } else if high < f64::INFINITY {
                0.5 * (low + high)
            } else {
                2.0 * x
            };
        }
        None
    }

    /// The root in an interval by the formula for quadratics, or a guess where it is not precise enough for that.
    #[inline]
    fn quadratic_root(&self, bracket: &Bracket) -> f64 {
        let &[c, b, a, ..] = self.value.as_slice() else { return bracket.guess };
        // The numerator without cancellation.
        let q = -0.5 * (b + Number::sqrt((b * b - 4.0 * a * c).max(0.0)).copysign(b));
        let is_in = |x: &f64| *x > bracket.low && *x < bracket.high;
        [q / a, c / q].into_iter().find(is_in).unwrap_or(bracket.guess)
    }
}
