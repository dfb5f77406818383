//! Which eigenvalue at one speed goes on as which at the next.

use nalgebra::Complex;

use crate::numeric::sort_by;

/// How far an eigenvalue may move in a step, relative to its distance from others: where it moves farther, the step is too
/// long to tell.
const STEP: f64 = 0.3;

/// What is smaller than this, relative to the largest eigenvalue, and an imaginary part that is so relative to its own, may
/// be rounding of two eigenvalues that coincide.
const COINCIDENT: f64 = 1e-7;

/// Two that are closer than this before and after a step, relative to the largest, are so at all speeds.
const SAME: f64 = 1e-12;

/// The eigenvalues without what rounding makes of those that coincide.
pub(super) fn cleaned(values: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let tiny = COINCIDENT * largest(values);
    let clean = |value: &Complex<f64>| {
        if value.norm() <= tiny {
            Complex::new(0.0, 0.0)
        } else if value.im.abs() <= COINCIDENT * value.norm() {
            Complex::new(value.re, 0.0)
        } else {
            *value
        }
    };
    values.iter().map(clean).collect()
}

fn largest(values: &[Complex<f64>]) -> f64 {
    values.iter().map(|value| value.norm()).fold(0.0, f64::max)
}

/// The side of the real axis: eigenvalues change it only where two of them meet.
pub(super) fn side(value: Complex<f64>) -> i8 {
    i8::from(value.im > 0.0) - i8::from(value.im < 0.0)
}

/// By place in `from` the place in `to`, the closest first.
pub(super) fn closest(from: &[Complex<f64>], to: &[Complex<f64>]) -> Vec<usize> {
    let mut pairs: Vec<(f64, usize, usize)> = Vec::with_capacity(from.len() * to.len());
    for (i, a) in from.iter().enumerate() {
        pairs.extend(to.iter().enumerate().map(|(j, b)| ((a - b).norm(), i, j)));
    }
    sort_by(&mut pairs, |x, y| x.0.total_cmp(&y.0));
    let mut places = vec![None; from.len()];
    let mut is_taken = vec![false; to.len()];
    for (_, i, j) in pairs {
        if places[i].is_none() && !is_taken[j] {
            (places[i], is_taken[j]) = (Some(j), true);
        }
    }
    places.into_iter().map(Option::unwrap_or_default).collect()
}

/// The same where it is beyond doubt: as many eigenvalues are real, and each moves little beside its distance from all
/// others that are on the same side of the real axis. Those that coincide before and after do not matter to each other.
pub(super) fn find_clear(from: &[Complex<f64>], to: &[Complex<f64>]) -> Option<Vec<usize>> {
    let places = closest(from, to);
    (0..from.len()).all(|i| is_clear(i, from, to, &places)).then_some(places)
}

/// Lets both halves of a pair go on as those of one pair, also where others are at the same place.
pub(super) fn keep_pairs(from: &[Complex<f64>], to: &[Complex<f64>], places: &mut [usize]) {
    let (before, after) = (partners(from), partners(to));
    for upper in (0..from.len()).filter(|&i| side(from[i]) > 0) {
        let (Some(lower), Some(half)) = (before[upper], after[places[upper]]) else { continue };
        if let Some(other) = places.iter().position(|&place| place == half).filter(|_| side(to[half]) < 0) {
            places.swap(lower, other);
        }
    }
}

/// Of each half of a pair the place of the other one, each once.
fn partners(values: &[Complex<f64>]) -> Vec<Option<usize>> {
    let mut partners = vec![None; values.len()];
    for upper in (0..values.len()).filter(|&i| side(values[i]) > 0) {
        let is_free = |&lower: &usize| partners[lower].is_none() && values[lower] == values[upper].conj();
        if let Some(lower) = (0..values.len()).find(is_free) {
            (partners[upper], partners[lower]) = (Some(lower), Some(upper));
        }
    }
    partners
}

/// Whether one of them is beyond doubt.
pub(super) fn is_clear(i: usize, from: &[Complex<f64>], to: &[Complex<f64>], places: &[usize]) -> bool {
    let (a, b) = (from[i], to[places[i]]);
    if side(a) != side(b) {
        return false;
    }
    let tiny = SAME * largest(to);
    let others = (0..from.len()).filter(|&k| k != i && side(from[k]) == side(a));
    let apart = others.map(|k| ((a - from[k]).norm(), (b - to[places[k]]).norm()));
    let apart = apart.filter(|(before, after)| *before > tiny || *after > tiny);
    let nearest = apart.map(|(before, after)| before.min(after)).fold(f64::INFINITY, f64::min);
    (a - b).norm() <= STEP * nearest
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::{cleaned, closest, find_clear};

    fn z(re: f64, im: f64) -> Complex<f64> {
        Complex::new(re, im)
    }

    #[test]
    fn steps_that_are_short_are_clear() {
        let from = [z(-1.0, 0.0), z(-3.0, 0.0), z(-2.0, 5.0), z(-2.0, -5.0)];
        let to = [z(-2.1, -5.2), z(-2.1, 5.2), z(-3.1, 0.0), z(-1.1, 0.0)];
        assert_eq!(find_clear(&from, &to), Some(vec![3, 2, 1, 0]));
        // One moves half of the way to the other.
        assert_eq!(find_clear(&from, &[z(-2.0, 0.0), z(-3.1, 0.0), to[0], to[1]]), None);
        // Two real ones have become a pair.
        assert_eq!(find_clear(&from, &[z(-2.0, 0.1), z(-2.0, -0.1), to[0], to[1]]), None);
    }

    #[test]
    fn what_coincides_at_both_speeds_is_clear() {
        let double = |value: Complex<f64>| [value, value.conj(), value, value.conj()];
        assert!(find_clear(&double(z(-1.0, 3.0)), &double(z(-1.1, 3.1))).is_some());
        let zeros = cleaned(&[z(3e-9, 0.0), z(-3e-9, 0.0), z(-2.0, 1.0), z(-2.0, -1.0)]);
        let others = cleaned(&[z(0.0, 4e-9), z(0.0, -4e-9), z(-2.1, 1.0), z(-2.1, -1.0)]);
        assert!(find_clear(&zeros, &others).is_some());
    }

    #[test]
    fn every_one_has_a_place() {
        let from = [z(0.0, 0.0), z(1.0, 0.0), z(10.0, 0.0)];
        assert_eq!(closest(&from, &[z(11.0, 0.0), z(0.9, 0.0), z(0.8, 0.0)]), [2, 1, 0]);
    }
}
