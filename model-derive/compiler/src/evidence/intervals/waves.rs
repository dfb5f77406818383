//! Sines, cosines and tangents of intervals of angles.

use std::cmp::Ordering;
use std::f64::consts::FRAC_PI_2;

use super::{End, Interval};

impl Interval {
    /// Sines.
    pub fn sin(self) -> Self {
        self.wave(f64::sin, 1)
    }

    /// Cosines.
    pub fn cos(self) -> Self {
        self.wave(f64::cos, 0)
    }

    /// A wave that is greatest at the right angle numbered `top`, and at every fourth one from there.
    fn wave(self, wave: fn(f64) -> f64, top: i64) -> Self {
        let full = Self::closed(-1.0, 1.0);
        let Some(mut angles) = self.right_angles() else { return full };
        let has_top = angles.clone().any(|angle| (angle - top).rem_euclid(4) == 0);
        let has_bottom = angles.clone().any(|angle| (angle - top).rem_euclid(4) == 2);
        let has_zero = angles.any(|angle| (angle - top).rem_euclid(2) == 1 && (angle != 0 || !self.excludes_zero()));
        // Without a turning point inside, the greatest and the least value are at the bounds.
        let [a, b] = [self.lower, self.upper].map(|end| End { value: wave(end.value), ..end });
        let (low, high) = match a.value.partial_cmp(&b.value) {
            Some(Ordering::Less) => (a, b),
            Some(Ordering::Greater) => (b, a),
            _ => (End { open: a.open && b.open, ..a }, End { open: a.open && b.open, ..a }),
        };
        let end = |end: End, turn: bool, bound: f64, shift: fn(f64) -> f64| {
            let value = if turn { bound } else { shifted(end.value, shift).clamp(-1.0, 1.0) };
            End::rounded(value, !turn && end.open)
        };
        Self {
            lower: end(low, has_bottom, -1.0, f64::next_down),
            upper: end(high, has_top, 1.0, f64::next_up),
            nonzero: !has_zero,
        }
    }

    /// Tangents; angles at which there is none are left out.
    pub fn tan(self) -> Self {
        let Some(mut angles) = self.right_angles() else { return Self::ALL };
        if angles.clone().any(|angle| angle.rem_euclid(2) == 1) {
            return Self::ALL;
        }
        let end = |end: End, shift: fn(f64) -> f64| End::rounded(shifted(end.value.tan(), shift), end.open);
        let has_zero = angles.any(|angle| angle != 0 || !self.excludes_zero());
        Self { lower: end(self.lower, f64::next_down), upper: end(self.upper, f64::next_up), nonzero: !has_zero }
    }

    /// The whole multiples of π/2 inside, by their numbers, if they are few and not too far from zero to tell.
    fn right_angles(self) -> Option<impl Iterator<Item = i64> + Clone> {
        let (lower, upper) = (self.lower.value, self.upper.value);
        if lower < -FAR || upper > FAR || upper - lower > 2.0 * std::f64::consts::TAU {
            return None;
        }
        let numbers = (lower / FRAC_PI_2).floor() as i64 - 1..=(upper / FRAC_PI_2).ceil() as i64 + 1;
        Some(numbers.filter(move |number| {
            let (below, above) = (beyond(lower, *number), beyond(upper, *number));
            let inside = |at: f64, end: End| at > 0.0 || at == 0.0 && !end.open;
            inside(-below, self.lower) && inside(above, self.upper)
        }))
    }
}

/// Angles further from zero than this are not told from multiples of π/2.
const FAR: f64 = 1e5;

/// How far a number is beyond a whole multiple of π/2, with the right sign: no multiple but zero is itself an `f64`.
fn beyond(angle: f64, number: i64) -> f64 {
    // What is left of π/2 behind its nearest f64.
    const REST: f64 = 6.123_233_995_736_766e-17;
    let number = number as f64;
    (-number).mul_add(FRAC_PI_2, angle) - number * REST
}

/// Moved outward by more than a library function errs; zero is taken for exact.
fn shifted(value: f64, shift: fn(f64) -> f64) -> f64 {
    if value == 0.0 { value } else { (0..4).fold(value, |value, _| shift(value)) }
}
