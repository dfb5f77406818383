//! What changes smoothly where two eigenvalues coincide: their mean, and the square of half their difference.
//!
//! Sums over the eigenvalues s_1 and s_2 inside a circle are integrals along it of the logarithmic derivative of det Q,
//! and so are their derivatives, however close the two are (Keldysh 1951):
//!
//! ```text
//! d (s_1 + s_2)                     = -1/(2 pi i) * integral of       tr(Q(z)^-1 dQ(z)) dz
//! d ((s_1 - a)^2 + (s_2 - a)^2) / 2 = -1/(2 pi i) * integral of (z - a) tr(Q(z)^-1 dQ(z)) dz
//! ```
//!
//! With a at the mean, the second is the derivative of the square of half the difference.

use nalgebra::Complex;

use super::pencil::{Pencil, Weights};
use crate::numeric::sort_by;

/// The other eigenvalues, as one of them sees them.
pub(super) struct Neighbours {
    /// The sum of the reciprocal distances to all of them.
    pub(super) closeness: f64,
    /// The closest of them.
    partner: Complex<f64>,
    /// The distance from the middle between both to the closest of the rest; infinite without a rest.
    room: f64,
}

impl Neighbours {
    pub(super) fn of(eigenvalues: &[Complex<f64>], index: usize) -> Self {
        let s = eigenvalues[index];
        let mut others: Vec<Complex<f64>> =
            eigenvalues.iter().enumerate().filter(|(other, _)| *other != index).map(|(_, &t)| t).collect();
        sort_by(&mut others, |t, u| (s - t).norm().total_cmp(&(s - u).norm()));
        let closeness = others.iter().map(|t| 1.0 / (s - t).norm()).sum();
        // Every number of coordinates has at least two eigenvalues.
        let partner = others.first().copied().unwrap_or(s);
        let middle = (s + partner) * 0.5;
        let room = others.iter().skip(1).map(|t| (middle - t).norm()).fold(f64::INFINITY, f64::min);
        Self { closeness, partner, room }
    }
}

/// Points on the circle: with the two eigenvalues and the others each a factor of four away from it, the rule of
/// trapezoids errs by 4^-32.
const POINTS: usize = 32;
const MARGIN: f64 = 4.0;

/// The weights of the derivatives of the mean of the two, and of the square of half their difference; `None` if no circle
/// keeps them apart from the others.
pub(super) fn find_weights<const N: usize>(
    pencil: &Pencil<N>,
    s: Complex<f64>,
    neighbours: &Neighbours,
) -> Option<[Weights<N>; 2]> {
    let Neighbours { partner, room, .. } = *neighbours;
    let middle = (s + partner) * 0.5;
    let radius = if room.is_finite() { room / MARGIN } else { 1.0 + middle.norm() };
    if MARGIN * (s - partner).norm() * 0.5 > radius || radius == 0.0 {
        return None;
    }
    let (mut mean, mut square) = (Weights::zero(), Weights::zero());
    for point in 0..POINTS {
        let angle = core::f64::consts::TAU * (point as f64 + 0.5) / POINTS as f64;
        let offset = Complex::from_polar(radius, angle);
        let z = middle + offset;
        // dz = i (z - a) d(angle)
        let factor = -offset / POINTS as f64;
        let inverse = pencil.at(z).try_inverse()?.transpose();
        mean.add(&Weights::at(z, &(inverse * (factor * 0.5))));
        square.add(&Weights::at(z, &(inverse * (factor * offset))));
    }
    // A real mean has real derivatives: the points are symmetric about the real axis.
    let is_real = middle.im == 0.0;
    Some([mean, square].map(|weights| if is_real { weights.real() } else { weights }))
}
