//! The imaginary eigenvalues at a root of the Hurwitz determinant.

use crate::number::real::Real;
use crate::numeric::{DoubleDouble, Root, Tracked};
use crate::stability::along_speed::Characteristic;

/// A pair of eigenvalues +-i omega, both scaled.
pub(super) struct Pair {
    /// The square of omega.
    pub(super) square: DoubleDouble,
    /// The coefficients, ascending, of the polynomial of the other eigenvalues.
    pub(super) rest: Vec<Tracked>,
    /// The sign of the real part of the pair just below and just above the speed.
    pub(super) side: (i8, i8),
}

/// What may be left, relative to its terms, of a coefficient that is zero where the determinant touches zero.
const BLUR: f64 = 1e-10;

/// The imaginary pairs at a root of the Hurwitz determinant.
///
/// The determinant is, up to a positive factor, a product of sums of two eigenvalues each. Two of these have a sign that
/// may change: the real part of the pair and, for a quartic, the sum `-p_3 / p_4` of the other two eigenvalues.
pub(super) fn find_imaginary_pairs(characteristic: &Characteristic, root: Root) -> Vec<Pair> {
    let p: Vec<Tracked> = characteristic.coefficients().iter().map(|p| p.at(root.at)).collect();
    let pair = |numerator: Tracked, denominator: Tracked, rest: Vec<Tracked>, sign: i8| {
        let is_imaginary = numerator.sign() * denominator.sign() > 0;
        let square = numerator.value / denominator.value;
        is_imaginary.then(|| Pair { square, rest, side: (sign * root.before, sign * root.after) }).into_iter().collect()
    };
    // A root at which the determinant only touches zero is less sharp than one at which it changes sign.
    let is_touched = root.before == root.after;
    let is_zero = |p: Tracked| p.sign() == 0 || is_touched && p.value.abs().to_f64() <= BLUR * p.size;
    match p[..] {
        [p0, p1, p2, p3, p4] if is_zero(p1) && is_zero(p3) => {
            let slopes = characteristic.slopes_at(root.at);
            two_pairs([p0, p2, p4], [slopes[1], slopes[3]])
        }
        [p0, p1, _, p3, p4] => pair(p1, p3, vec![p0, p3, p4], -p3.sign()),
        [_, p1, p2, p3] => pair(p1, p3, vec![p2, p3], -1),
        [p0, _, p2] => pair(p0, p2, vec![p2], -1),
        _ => Vec::new(),
    }
}

/// The imaginary pairs of the polynomial `p_0 + p_2 s^2 + p_4 s^4`, given the slopes of p_1 and p_3 along speed.
///
/// Both pairs may cross the axis, so that the determinant keeps its sign. The real part of a pair changes by
/// `-(p_1' - p_3' omega^2) / (2 (p_2 - 2 p_4 omega^2))`.
fn two_pairs([p0, p2, p4]: [Tracked; 3], [p1_slope, p3_slope]: [Tracked; 2]) -> Vec<Pair> {
    let radicand = p2 * p2 * 0.25.into() - p0 * p4;
    if radicand.sign() < 0 {
        return Vec::new();
    }
    let (half, root) = (p2.value * 0.5.into(), radicand.value.sqrt_or_zero());
    let squares = [(half - root) / p4.value, (half + root) / p4.value];
    let pair = |square: DoubleDouble, other: DoubleDouble| {
        let change = (p1_slope - p3_slope * square.into()).sign() * (p2 - p4 * (square + square).into()).sign();
        Pair { square, rest: vec![other.into(), Tracked::ZERO, Tracked::from(1.0)], side: (change, -change) }
    };
    let pairs = [pair(squares[0], squares[1]), pair(squares[1], squares[0])];
    pairs.into_iter().filter(|pair| pair.square > DoubleDouble::ZERO).collect()
}
