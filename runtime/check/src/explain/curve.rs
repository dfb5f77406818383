//! How far a relation is off as one formula has other values, without evaluating what it is made of each time.

use std::ops::{Add, Div, Sub};

/// Where a formula is tried, in steps from the value that it has; the last one tells whether the others make a parabola.
pub const NODES: [f64; 4] = [0.0, 1.0, -1.0, 2.0];

/// Relative to what is added up: more than rounding leaves, and less than a curve that is no parabola.
const SAME: f64 = 1e-12;

/// The step from the value that a formula has.
pub fn step(value: f64) -> f64 {
    if value == 0.0 { 1.0 } else { value }
}

/// The values at the nodes around that which a formula has.
pub fn at_nodes(value: f64) -> [f64; 4] {
    NODES.map(|node| value + node * step(value))
}

/// The coefficients, by powers of the steps, of the parabola through what there is at the first three nodes.
pub fn parabola<T>(here: T, right: T, left: T) -> [T; 3]
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Div<f64, Output = T>,
{
    [here, (right - left) / 2.0, (right + left) / 2.0 - here]
}

/// A parabola: definitions are squared at most in most of what comes of them.
pub struct Curve {
    value: f64,
    step: f64,
    coefficients: [f64; 3],
    /// The largest of what it may be off by, and of what that is made of.
    allowed: f64,
    size: f64,
}

impl Curve {
    /// Around the value that a formula has, from what there is at the nodes: by how much the relation is off, how much that may be, and
    /// the size of what is added up. `None` where it is no parabola.
    pub fn new(value: f64, nodes: [[f64; 3]; 4]) -> Option<Self> {
        let step = step(value);
        let [here, right, left, far] = nodes.map(|[off, ..]| off);
        let largest = |at: usize| nodes.iter().fold(0.0, |largest: f64, node| largest.max(node[at]));
        let coefficients = parabola(here, right, left);
        let own = Self { value, step, coefficients, allowed: largest(1), size: largest(2) };
        let is_parabola = (own.off(NODES[3]) - far).abs() <= SAME * own.size;
        is_parabola.then_some(own)
    }

    /// Whether the relation may hold for a value of the formula.
    pub fn may_hold(&self, value: f64) -> bool {
        let steps = (value - self.value) / self.step;
        let allowed = 2.0 * self.allowed + 10.0 * SAME * self.size;
        self.off(steps).abs() <= allowed * (1.0 + steps * steps)
    }

    fn off(&self, steps: f64) -> f64 {
        let [a, b, c] = self.coefficients;
        a + steps * (b + steps * c)
    }
}

#[cfg(test)]
mod tests {
    use super::{Curve, at_nodes};

    /// 3 (x - 2) (x - 5) is zero at 2 and at 5 alone.
    #[test]
    fn both_zeros_of_a_parabola_are_seen() {
        let nodes = at_nodes(7.0).map(|x| [3.0 * (x - 2.0) * (x - 5.0), 1e-9, 100.0]);
        let curve = Curve::new(7.0, nodes).expect("a parabola");
        let seen = [2.0, 2.001, 3.5, 5.0, 4.999, 7.0].map(|x| curve.may_hold(x));
        assert_eq!(seen, [true, false, false, true, false, false]);
    }

    #[test]
    fn a_quotient_is_no_parabola() {
        assert!(Curve::new(7.0, at_nodes(7.0).map(|x| [1.0 - 2.0 / x, 1e-9, 1.0])).is_none());
    }
}
