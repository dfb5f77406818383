//! Positive roots of a polynomial in plain `f64`: how many there are, and where, as far as `f64` can tell for certain.
//!
//! With x = u / (u + t) the half-line of u becomes the unit interval of x, and the coefficients of the powers of u become,
//! up to a factor each, those of the Bernstein form in x. Their changes of sign are as many as the roots or, by an even
//! number, more (Descartes); so none and one tell how many roots there are, and intervals with more are halved, which
//! takes means alone (de Casteljau). It ends soon unless roots nearly coincide (Vincent).

use arrayvec::ArrayVec;

use super::{NOISE, Sum};
use crate::Number;

/// A polynomial with coefficients in `f64`, ascending, with a size for each: coefficients err by a rounding of their size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rounded<const N: usize> {
    value: [f64; N],
    size: [f64; N],
}

/// An interval with exactly one root.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bracket {
    pub(crate) low: f64,
    /// Infinite if the interval has no end.
    pub(crate) high: f64,
    guess: f64,
    /// Whether the polynomial is negative below the root and positive above it.
    pub(crate) rises: bool,
}

/// The roots of polynomials of degree up to 12, ascending.
pub(crate) type Brackets = ArrayVec<Bracket, 12>;

/// How much less than its terms a value may be, for its sign to be certain: 2^7 roundings.
const CERTAIN: f64 = 128.0 * f64::EPSILON;

/// How often an interval is halved at most.
const DEPTH: u32 = 14;

impl<const N: usize> Rounded<N> {
    #[inline]
    pub(crate) fn new(coefficients: &[Sum; N]) -> Self {
        let coefficients = coefficients.map(|c| if c.sign() == 0 { Sum::ZERO } else { c });
        let value = coefficients.map(|c| c.value.to_f64());
        // What is left of cancelled terms errs by the rounding of these in double-double.
        let size = coefficients.map(|c| c.value.to_f64().abs() + c.size * (NOISE / f64::EPSILON));
        Self { value, size }
    }

    /// The sign at u >= 0; `None` where it is not certain.
    #[inline]
    pub(crate) fn sign(&self, u: f64) -> Option<i8> {
        let (mut value, mut size) = (0.0, 0.0);
        for i in (0..N).rev() {
            value = value * u + self.value[i];
            size = size * u + self.size[i];
        }
        if value > CERTAIN * size {
            Some(1)
        } else if value < -CERTAIN * size {
            Some(-1)
        } else {
            None
        }
    }

    /// The value at x, the first derivative, and half of the second one.
    #[inline]
    pub(crate) fn taylor(&self, x: f64) -> [f64; 3] {
        let [mut value, mut slope, mut half_curvature] = [0.0; 3];
        for i in (0..N).rev() {
            half_curvature = half_curvature * x + slope;
            slope = slope * x + value;
            value = value * x + self.value[i];
        }
        [value, slope, half_curvature]
    }

    /// Intervals with one root each of all positive roots; `None` if it is not certain how many there are.
    pub(crate) fn isolate(&self, brackets: &mut Brackets) -> Option<()> {
        let last = (0..N).rev().find(|&i| self.size[i] != 0.0)?;
        // About the geometric mean of all roots, positive or not.
        let exponent = |x: f64| ((x.to_bits() >> 52) & 0x7ff) as i32;
        let scale = (exponent(self.value[0]) - exponent(self.value[last])) / (last as i32).max(1);
        let t = f64::from_bits(u64::try_from(scale + 1023).ok()? << 52);
        let factors = const { reciprocal_binomials::<N>() };
        let (mut value, mut size, mut power) = (self.value, self.size, 1.0);
        for i in 0..N {
            value[i] *= power * factors[i];
            size[i] *= power * factors[i];
            power *= t;
        }
        Rounded { value, size }.halve(t, 0.0, 1.0, DEPTH, brackets)
    }

    /// Isolates in an interval of x with these coefficients of the Bernstein form.
    fn halve(&self, t: f64, from: f64, to: f64, depth: u32, brackets: &mut Brackets) -> Option<()> {
        match self.changes() {
            Some(0) => return Some(()),
            Some(1) => {
                brackets.try_push(self.bracket(t, from, to)).ok()?;
                return Some(());
            }
            _ if depth == 0 => return None,
            _ => {}
        }
        let (mut left, mut right) = (*self, *self);
        for level in 1..N {
            for i in 0..N - level {
                right.value[i] = 0.5 * (right.value[i] + right.value[i + 1]);
                right.size[i] = 0.5 * (right.size[i] + right.size[i + 1]);
            }
            left.value[level] = right.value[0];
            left.size[level] = right.size[0];
        }
        // The root may be where the interval is halved.
        if right.value[0].abs() <= CERTAIN * right.size[0] || right.value[0].is_nan() {
            return None;
        }
        let middle = 0.5 * (from + to);
        left.halve(t, from, middle, depth - 1, brackets)?;
        right.halve(t, middle, to, depth - 1, brackets)
    }

    /// The number of changes of sign; `None` if signs that are not certain make a difference.
    fn changes(&self) -> Option<u32> {
        let (mut positive, mut negative) = (0u32, 0u32);
        for i in 0..N {
            positive |= u32::from(self.value[i] > CERTAIN * self.size[i]) << i;
            negative |= u32::from(self.value[i] < -CERTAIN * self.size[i]) << i;
        }
        if positive | negative == (1 << N) - 1 {
            return Some(((positive ^ (positive >> 1)) & ((1 << (N - 1)) - 1)).count_ones());
        }
        let (mut changes, mut last, mut uncertain) = (0, 0, 0);
        for i in 0..N {
            let sign = (positive >> i & 1) as i32 - (negative >> i & 1) as i32;
            if sign != 0 {
                // One sign between different ones may be either.
                if uncertain > 1 || uncertain == 1 && sign == last || uncertain > 0 && last == 0 {
                    return None;
                }
                changes += u32::from(last != 0 && sign != last);
                (last, uncertain) = (sign, 0);
            } else if self.size[i] != 0.0 {
                uncertain += 1;
            }
        }
        (uncertain == 0).then_some(changes)
    }

    fn bracket(&self, t: f64, from: f64, to: f64) -> Bracket {
        // Where the polygon through the coefficients is zero.
        let first = self.value.iter().copied().find(|&value| value != 0.0).unwrap_or(0.0);
        let i = (1..N).find(|&i| self.value[i] * first < 0.0).unwrap_or(N - 1);
        let (below, above) = (self.value[i - 1], self.value[i]);
        let x = (i as f64 - above / (above - below)) / (N - 1) as f64;
        let u = |x: f64| t * x / (1.0 - x);
        Bracket { low: u(from), high: u(to), guess: u(from + x * (to - from)), rises: first < 0.0 }
    }

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
        let [c, b, a] = [0, 1, 2].map(|i| self.value[i]);
        // The numerator without cancellation.
        let q = -0.5 * (b + Number::sqrt((b * b - 4.0 * a * c).max(0.0)).copysign(b));
        let is_in = |x: &f64| *x > bracket.low && *x < bracket.high;
        [q / a, c / q].into_iter().find(is_in).unwrap_or(bracket.guess)
    }
}

const fn reciprocal_binomials<const N: usize>() -> [f64; N] {
    let mut reciprocals = [1.0; N];
    let (mut i, mut binomial) = (1, 1);
    while i < N {
        binomial = binomial * (N - i) / i;
        reciprocals[i] = 1.0 / binomial as f64;
        i += 1;
    }
    reciprocals
}
