//! The order in which eigenvalues keep their places as the speed grows.

use nalgebra::Complex;

use super::along_speed::Characteristic;
use super::careful::double_roots;
use crate::numeric::{DoubleDouble, Polynomial, positive_roots, sort_by};
use crate::system::SystemError;

/// A stretch of speeds over which one order keeps every eigenvalue at its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stretch {
    /// The lower end in m/s.
    pub(super) from: f64,
    /// The upper end in m/s; of a stretch without end, some speed in it.
    pub(super) to: f64,
    pub(super) order: Order,
}

/// The distance from an end of a stretch, relative to its length or to the speed there, at which eigenvalues are compared.
const NEAR: f64 = 1.0 / 1024.0;

impl Stretch {
    /// A speed just above the lower end.
    pub(super) fn near_lower_end(&self) -> f64 {
        let length = self.to - self.from;
        self.from + NEAR * if self.from > 0.0 { length.min(self.from) } else { length }
    }

    /// A speed just below the upper end.
    pub(super) fn near_upper_end(&self) -> f64 {
        self.to - NEAR * (self.to - self.from)
    }
}

/// An order of four eigenvalues: real ones, ascending, then pairs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Order {
    pairs: usize,
    /// What two pairs are sorted by.
    key: Key,
}

/// A part in which two pairs differ all over a stretch of speeds; in the other one they may cross.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Key {
    Real,
    Imaginary,
}

/// The stretches of all speeds from zero, ascending: at least one.
///
/// They end where the discriminant is zero. Two pairs, sorted by their real or by their imaginary parts, may also cross
/// without meeting; in stretches around such crossings they are sorted by the part that does not cross.
///
/// # Errors
/// If an end leaves the range of `f64`.
pub(super) fn stretches(characteristic: &Characteristic) -> Result<Vec<Stretch>, SystemError> {
    let half = DoubleDouble::from(0.5);
    let meetings = double_roots::find_speeds(characteristic);
    // At rest, too, two pairs may be symmetric about the imaginary axis, or both on it.
    let mut crossings = vec![DoubleDouble::ZERO];
    crossings.extend(positive_roots(&crossing(characteristic)).iter().map(|root| root.at));
    let mut stretches = Vec::new();
    let mut from = DoubleDouble::ZERO;
    for i in 0..=meetings.len() {
        let end = meetings.get(i).copied();
        let to = end.unwrap_or(if i == 0 { DoubleDouble::from(1.0) } else { from + from });
        let middle = (from + to) * half;
        let pairs = count_pairs(characteristic.roots(middle));
        let inside = crossings.iter().copied().filter(|&at| pairs == 2 && at >= from && end.is_none_or(|end| at < end));
        let mut crossed: Vec<DoubleDouble> = inside.collect();
        if crossed.is_empty() {
            crossed.push(middle);
        }
        for (j, &at) in crossed.iter().enumerate() {
            let next = crossed.get(j + 1).map_or(if at < to { to } else { at }, |&next| (at + next) * half);
            let order = Order { pairs, key: Key::separating(characteristic.roots(at)) };
            let [from_speed, to_speed] = [from, next].map(|speed| characteristic.speed(speed.to_f64()));
            if !to_speed.is_finite() {
                return Err(SystemError::OutOfRange { quantity: "a critical speed" });
            }
            stretches.push(Stretch { from: from_speed, to: to_speed, order });
            from = next;
        }
        from = end.unwrap_or(from);
    }
    Ok(stretches)
}

/// The polynomial in the speed that is zero where two eigenvalues have the same sum as the other two: for two pairs, where
/// their real or their imaginary parts are equal.
fn crossing(characteristic: &Characteristic) -> Polynomial {
    match characteristic.coefficients() {
        [_, p1, p2, p3, p4] => {
            let cubes = &(&(p3 * p3) * p3) + &(&(&(p4 * p4) * p1) * 8.0);
            &cubes - &(&(&(p4 * p3) * p2) * 4.0)
        }
        _ => Polynomial::constant(1.0),
    }
}

pub(super) fn count_pairs(factored: [[Complex<f64>; 2]; 2]) -> usize {
    factored.iter().filter(|factor| is_pair(factor)).count()
}

fn is_pair(factor: &[Complex<f64>; 2]) -> bool {
    factor[1].im != 0.0
}

impl Key {
    /// The part in which two pairs differ more.
    fn separating([x, y]: [[Complex<f64>; 2]; 2]) -> Self {
        let difference = x[1] - y[1];
        if difference.re.abs() >= difference.im.abs() { Self::Real } else { Self::Imaginary }
    }

    fn of(self, factor: [Complex<f64>; 2]) -> f64 {
        match self {
            Self::Real => factor[0].re + factor[1].re,
            Self::Imaginary => factor[1].im,
        }
    }
}

impl Order {
    pub(super) fn pairs(self) -> usize {
        self.pairs
    }

    /// Four eigenvalues, given as the roots of two factors, in this order.
    ///
    /// Within rounding of a speed at which two eigenvalues meet there may be more or fewer pairs than belong to the
    /// stretch. What is closest to being a pair is then taken for one, or what is least one for two real eigenvalues.
    pub(super) fn arrange(self, factored: [[Complex<f64>; 2]; 2]) -> [Complex<f64>; 4] {
        let [[s0, s1], [t0, t1]] = factored;
        let mut all = [s0, s1, t0, t1];
        match (self.pairs, count_pairs(factored)) {
            (0, _) => sort_by(&mut all, by_parts),
            (1, 0) => {
                sort_by(&mut all, by_parts);
                let gap = |&i: &usize| all[i + 1].re - all[i].re;
                let closest = (0..3).min_by(|i, j| gap(i).total_cmp(&gap(j))).unwrap_or(0);
                all[closest..].rotate_left(2);
            }
            // The factor with the larger imaginary part, or with any, comes last.
            (1, _) if s1.im > t1.im => all.rotate_left(2),
            (1, _) => {}
            _ if self.key.of([s0, s1]) > self.key.of([t0, t1]) => all.rotate_left(2),
            _ => {}
        }
        all
    }
}

fn by_parts(x: &Complex<f64>, y: &Complex<f64>) -> core::cmp::Ordering {
    x.re.total_cmp(&y.re).then(x.im.total_cmp(&y.im))
}
