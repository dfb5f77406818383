//! Positive roots of a polynomial in plain `f64`: how many there are, and where, as far as `f64` can tell for certain.
//!
//! With y = x / (x + t) the half-line of x becomes the unit interval of y, and the coefficients of the powers of x become,
//! up to a factor each, those of the Bernstein form in y. Their changes of sign are as many as the roots or, by an even
//! number, more (Descartes); so none and one tell how many roots there are, and intervals with more are halved, which
//! takes means alone (de Casteljau). It ends soon unless roots nearly coincide (Vincent).

use arrayvec::ArrayVec;

use super::rounded::{CERTAIN, Rounded};

/// An interval with exactly one root.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bracket {
    pub(crate) low: f64,
    /// Infinite if the interval has no end.
    pub(crate) high: f64,
    /// A number in the interval.
    pub(super) guess: f64,
    /// Whether the polynomial is negative below the root and positive above it.
    pub(crate) rises: bool,
}

/// The roots of polynomials of degree up to 12, ascending.
pub(crate) type Brackets = ArrayVec<Bracket, 12>;

/// How often an interval is halved at most: each coefficient is then the result of up to 14 x 12 means.
const DEPTH: u32 = 14;

/// Limits within which no mean leaves the range of `f64`.
const SMALLEST: f64 = 1e-280;
const LARGEST: f64 = 1e280;

impl<const N: usize> Rounded<N> {
    /// Intervals with one root each of all positive roots; `None` if it is not certain how many there are.
    pub(crate) fn isolate(&self, brackets: &mut Brackets) -> Option<()> {
        let first = (0..N).find(|&i| self.size[i] != 0.0)?;
        let last = (0..N).rfind(|&i| self.size[i] != 0.0)?;
        // About the geometric mean of all roots, positive or not.
        let exponent = |i: usize| ((self.size[i].to_bits() >> 52) & 0x7ff) as i32;
        let scale = (exponent(first) - exponent(last)) / ((last - first) as i32).max(1);
        let t = f64::from_bits(u64::try_from(scale + 1023).ok()? << 52);
        let factors = const { reciprocal_binomials::<N>() };
        let (mut value, mut size, mut power) = (self.value, self.size, 1.0);
        let mut is_moderate = true;
        for i in 0..N {
            value[i] *= power * factors[i];
            size[i] *= power * factors[i];
            is_moderate &= (SMALLEST..LARGEST).contains(&size[i]) | (self.size[i] == 0.0);
            power *= t;
        }
        if !is_moderate {
            return None;
        }
        Rounded { value, size }.halve(t, 0.0, 1.0, DEPTH, brackets)
    }

    /// Isolates in an interval of y with these coefficients of the Bernstein form.
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
        let fraction = (i as f64 - above / (above - below)) / (N - 1) as f64;
        let x = |y: f64| t * y / (1.0 - y);
        Bracket { low: x(from), high: x(to), guess: x(from + fraction * (to - from)), rises: first < 0.0 }
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

#[cfg(test)]
mod tests {
    use super::Brackets;
    use crate::numeric::fixed::product;
    use crate::numeric::rounded::Rounded;
    use crate::numeric::{DoubleDouble, Tracked};

    fn linear(root: f64) -> [Tracked; 2] {
        [Tracked::from(-root), Tracked::from(1.0)]
    }

    /// The polynomial with these roots.
    fn from_roots([r0, r1, r2, r3, r4, r5]: [f64; 6]) -> [Tracked; 7] {
        let pairs: [[Tracked; 3]; 3] = [[r0, r1], [r2, r3], [r4, r5]].map(|[x, y]| product(&linear(x), &linear(y)));
        let four: [Tracked; 5] = product(&pairs[0], &pairs[1]);
        product(&four, &pairs[2])
    }

    fn isolate<const N: usize>(polynomial: &[Tracked; N]) -> Option<Vec<f64>> {
        let rounded = Rounded::new(polynomial);
        let mut brackets = Brackets::new();
        rounded.isolate(&mut brackets)?;
        for (bracket, rises) in brackets.iter().rev().zip([true, false].into_iter().cycle()) {
            assert_eq!(bracket.rises, rises);
        }
        brackets.iter().map(|bracket| rounded.refine(bracket, 1e-4)).collect()
    }

    #[test]
    fn finds_the_positive_roots_alone() {
        for roots in [[-3.0, 0.5, 0.75, 1.0, 20.0, 4096.0], [0.01, 0.02, 3.0, -100.0, 200.0, 300.0], [-1.0; 6]] {
            let expected: Vec<f64> = roots.into_iter().filter(|&root| root > 0.0).collect();
            let mut found = isolate(&from_roots(roots)).expect("distinct roots");
            found.sort_by(f64::total_cmp);
            assert_eq!(found.len(), expected.len(), "{found:?}");
            for expected in expected {
                let is_near = |found: &f64| (found - expected).abs() < 1e-9 * expected;
                assert_eq!(found.iter().filter(|found| is_near(found)).count(), 1, "{expected}: {found:?}");
            }
        }
    }

    #[test]
    fn gives_up_on_roots_that_nearly_coincide() {
        assert_eq!(isolate(&from_roots([1.3, 1.3, 2.0, 3.0, 4.0, 5.0])), None);
        assert_eq!(isolate(&from_roots([1.3, 1.3 * (1.0 + 1e-9), 2.0, 3.0, 4.0, 5.0])), None);
    }

    /// x^2 + 1, x^2 + e and x^2 - 2 x + 1 + e, where e is noise, much less than a rounding, or a little.
    #[test]
    fn is_certain_of_signs() {
        let polynomial = |linear: f64, constant: Tracked| [constant, Tracked::from(linear), Tracked::from(1.0)];
        assert_eq!(isolate(&polynomial(0.0, Tracked::from(1.0))), Some(vec![]));
        let noise = Tracked { value: DoubleDouble::from(-1e-27), size: 1.0 };
        assert_eq!(isolate(&polynomial(0.0, noise)), None);
        assert_eq!(isolate(&polynomial(-2.0, Tracked::from(1.0 + f64::EPSILON))), None);
        assert_eq!(isolate(&polynomial(-2.0, Tracked::from(1.001))), Some(vec![]));
    }

    #[test]
    fn stays_in_the_range_of_f64() {
        assert_eq!(isolate(&[1e200, -1e-200, 0.0, 1e-200].map(Tracked::from)), None);
        let scaled = from_roots([1e-30, 2e-30, 3e-30, 4e-30, 5e-30, 6e-30]);
        assert_eq!(isolate(&scaled).map(|found| found.len()), Some(6));
    }
}
