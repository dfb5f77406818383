//! The double eigenvalue at a root of the discriminant.

use nalgebra::Complex;

use crate::characteristic::double_root::Jet;
use crate::number::real::Real;
use crate::numeric::{DoubleDouble, Polynomial, Root, Tracked, candidates, sort_by};
use crate::stability::along_speed::Characteristic;

/// How far polishing may move a speed, relative to it: more than the discriminant errs by, and less than the distance to
/// another root that could be told from this one.
const NEAR: f64 = 1e-12;

/// The same where the terms of the discriminant cancel to their noise.
const NEAR_NOISE: f64 = 1e-6;

/// The digits of double-double arithmetic, but for a few.
const RESOLUTION: f64 = 1.0 / (1u128 << 100) as f64;

/// A double eigenvalue.
pub(super) struct DoubleRoot {
    /// The scaled eigenvalue.
    pub(super) eigenvalue: Complex<f64>,
    /// 1 if two real eigenvalues become a pair as the speed grows, -1 if a pair becomes two real ones, 0 for neither.
    pub(super) unfolding: i8,
}

/// The speeds, ascending, at which the discriminant is zero, polished, with the double eigenvalues there.
///
/// A speed that is not certain from the discriminant, whose terms are large and cancel, may be so once it is polished.
pub(super) fn find_double_roots(characteristic: &Characteristic) -> Vec<(Root, DoubleRoot)> {
    let discriminant = characteristic.discriminant();
    let polished = |mut root: Root| {
        let double_root = find_double_root(characteristic, &discriminant, &mut root);
        root.is_there().then_some((root, double_root))
    };
    candidates(&discriminant).into_iter().filter_map(polished).collect()
}

/// The same speeds, polished only where they are not certain otherwise.
pub(in crate::stability) fn find_speeds(characteristic: &Characteristic) -> Vec<DoubleDouble> {
    let discriminant = characteristic.discriminant();
    let certain = |mut root: Root| {
        if !root.is_there() {
            find_double_root(characteristic, &discriminant, &mut root);
        }
        root.is_there().then_some(root.at)
    };
    candidates(&discriminant).into_iter().filter_map(certain).collect()
}

/// The double eigenvalue at a root of the discriminant; polishes a simple root.
///
/// Near a real double eigenvalue `s^2 = -2 p_v v / p_ss`, both measured from there.
fn find_double_root(characteristic: &Characteristic, discriminant: &Polynomial, root: &mut Root) -> DoubleRoot {
    let (x, y) = closest(characteristic, root.at);
    let eigenvalue = 0.5 * (x + y);
    // Two real eigenvalues, or a pair just off the real axis.
    let is_real = x.im == 0.0 && y.im == 0.0 || x == y.conj();
    if !is_real {
        // The other half of the conjugate pair of double eigenvalues has the other sign.
        return DoubleRoot { eigenvalue: Complex::new(eigenvalue.re, eigenvalue.im.abs()), unfolding: 0 };
    }
    let real = |value: f64| Complex::new(value, 0.0);
    if root.before == root.after {
        return DoubleRoot { eigenvalue: real(eigenvalue.re), unfolding: 0 };
    }
    let mut point = Point { speed: root.at, eigenvalue: DoubleDouble::from(eigenvalue.re) };
    if let Some((polished, error)) = point.polished(characteristic) {
        let moved = (polished.speed - root.at).abs().to_f64() / root.at.to_f64();
        if moved <= NEAR || moved <= NEAR_NOISE && discriminant.at(polished.speed).sign() == 0 {
            point = polished;
            *root = Root { at: point.speed, error, ..*root };
        }
    }
    let Jet { by_v, by_ss, .. } = point.jet(characteristic);
    // Scaled eigenvalues are of about one: far below that is what rounding leaves of zero.
    let eigenvalue = point.eigenvalue.to_f64();
    let eigenvalue = if eigenvalue.abs() <= RESOLUTION { 0.0 } else { eigenvalue };
    DoubleRoot { eigenvalue: real(eigenvalue), unfolding: by_v.sign() * by_ss.sign() }
}

/// The two eigenvalues at a scaled speed that are closest to each other, of those that are not zero at all speeds.
fn closest(characteristic: &Characteristic, speed: DoubleDouble) -> (Complex<f64>, Complex<f64>) {
    let mut roots = characteristic.roots(speed).as_flattened().to_vec();
    sort_by(&mut roots, |x, y| y.norm().total_cmp(&x.norm()));
    let count = characteristic.coefficients().len() - 1;
    let pairs = (0..count).flat_map(|i| (0..i).map(move |j| (i, j)));
    let distance = |&(i, j): &(usize, usize)| (roots[i] - roots[j]).norm();
    let (i, j) = pairs.min_by(|x, y| distance(x).total_cmp(&distance(y))).unwrap_or((0, 1));
    (roots[i], roots[j])
}

/// A scaled speed and a real scaled eigenvalue.
#[derive(Clone, Copy)]
struct Point {
    speed: DoubleDouble,
    eigenvalue: DoubleDouble,
}

impl Point {
    /// The characteristic polynomial and its derivatives here.
    fn jet(self, characteristic: &Characteristic) -> Jet<Tracked> {
        Jet::new(characteristic.at(self.speed), characteristic.slopes_at(self.speed), self.eigenvalue.into())
    }

    /// Newton's iteration for `p = p_s = 0` in speed and eigenvalue, and how far the speed may move if the terms of p are
    /// rounded to `f64`: less than for the discriminant, whose terms are large and cancel.
    fn polished(mut self, characteristic: &Characteristic) -> Option<(Self, f64)> {
        const STEPS: usize = 12;
        for _ in 0..STEPS {
            let jet = self.jet(characteristic);
            let determinant = jet.determinant();
            if determinant.sign() == 0 {
                return None;
            }
            let step = jet.step_against([jet.p, jet.by_s]);
            let [speed, eigenvalue] = step.map(|step| step.value / determinant.value);
            self = Self { speed: self.speed + speed, eigenvalue: self.eigenvalue + eigenvalue };
            let is_small = |step: DoubleDouble, x: DoubleDouble| step.abs().to_f64() <= RESOLUTION * x.abs().to_f64();
            if is_small(speed, self.speed) && is_small(eigenvalue, self.eigenvalue) {
                break;
            }
        }
        let Jet { p, by_v, .. } = self.jet(characteristic);
        let error = f64::EPSILON * p.size / by_v.value.to_f64().abs();
        error.is_finite().then_some((self, error))
    }
}
