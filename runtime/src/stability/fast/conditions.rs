//! The conditions for critical speeds, by coefficients in fixed arrays.

#[cfg(all(feature = "batch", feature = "std"))]
use fearless_simd::Simd;

#[cfg(all(feature = "batch", feature = "std"))]
use crate::batch::Lanes;
use crate::characteristic::conditions::QuarticConditions;
use crate::characteristic::determinant::{Rows, rows};
use crate::characteristic::powers::{InSpeed, InSquare, Matrices, Powers, Variable as InVariable};
use crate::numeric::{Part, Tracked};
use crate::system::Coefficients;

/// What polynomials along speed are in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Variable {
    Speed,
    /// The square of the speed: without damping at rest (C0 = 0).
    Square,
}

/// The polynomials in a variable x whose roots are the critical speeds, of degree 4, 6 and 12 or half of that.
pub(crate) struct Conditions<const P: usize, const H: usize, const D: usize, T = f64> {
    pub(super) variable: Variable,
    /// `det(M s^2 + (C0 + v C1) s + Kc + g K0 + v^2 K2)`, up to a sign, by powers of s; for [`Variable::Square`] those of
    /// odd powers divided by v. The last one is positive.
    pub(super) p: [[Tracked<T>; P]; 5],
    /// The Hurwitz determinant; for [`Variable::Square`] divided by v^2.
    pub(super) hurwitz: [Tracked<T>; H],
    /// The discriminant.
    pub(super) discriminant: [Tracked<T>; D],
}

/// Products of 18 numbers within these limits stay in the range of `f64`: those of 12 entries, 6 times with gravity, that
/// the discriminant consists of.
const SMALLEST: f64 = 1e-15;
const LARGEST: f64 = 1e15;

/// The smallest determinant of the mass matrix that is surely not zero, relative to its terms.
const REGULAR: f64 = 16.0 * f64::EPSILON;

/// The matrices; `None` if the mass matrix may be singular, or if entries are not finite or of unusual size.
#[inline]
pub(super) fn moderate_matrices(coefficients: &Coefficients<f64, 2>, gravity: f64) -> Option<Matrices> {
    let entries = entries(coefficients);
    let matrices = Matrices::new(entries, gravity);
    (are_moderate(&entries, gravity) && is_regular(matrices.mass)).then_some(matrices)
}

/// The rows of M, C0, C1, Kc, K0 and K2.
#[inline]
pub(crate) fn entries(coefficients: &Coefficients<f64, 2>) -> [Rows; 6] {
    let Coefficients { m, c0, c1, kc, k0, k2, .. } = coefficients;
    // One by one: a function of an array calls another one for it.
    [rows(m), rows(c0), rows(c1), rows(kc), rows(k0), rows(k2)]
}

/// Whether no entry is not finite or of unusual size.
#[inline]
pub(crate) fn are_moderate(entries: &[Rows; 6], gravity: f64) -> bool {
    let is_moderate = |x: f64| (SMALLEST..=LARGEST).contains(&x.abs()) | (x == 0.0);
    // Without a branch for each entry.
    let moderate = entries.as_flattened().as_flattened().iter().fold(true, |all, &x| all & is_moderate(x));
    moderate && is_moderate(gravity)
}

/// Whether the determinant of a mass matrix is surely not zero.
#[inline]
fn is_regular(mass: Tracked) -> bool {
    mass.value.to_f64().abs() > REGULAR * mass.size
}

impl<const P: usize, const H: usize, const D: usize, T: Part> Conditions<P, H, D, T> {
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    fn new<V>(variable: Variable, powers: &Powers<V, T>) -> Self
    where
        V: InVariable<Hurwitz<T> = [Tracked<T>; H], Discriminant<T> = [Tracked<T>; D]>,
    {
        let conditions = QuarticConditions::new(powers);
        let (hurwitz, discriminant) = (conditions.hurwitz(), conditions.discriminant());
        Self { variable, p: powers.padded(), hurwitz, discriminant }
    }
}

#[cfg(all(feature = "batch", feature = "std"))]
impl<const P: usize, const H: usize, const D: usize, S: Simd> Conditions<P, H, D, Lanes<S>> {
    /// Those of a lane; `None` if its mass matrix may be singular.
    pub(crate) fn lane(&self, lane: usize) -> Option<Conditions<P, H, D>> {
        let mut conditions = Conditions {
            variable: self.variable,
            p: [[Tracked::ZERO; P]; 5],
            hurwitz: [Tracked::ZERO; H],
            discriminant: [Tracked::ZERO; D],
        };
        conditions.p.iter_mut().zip(&self.p).for_each(|(of_lane, p)| take_lane(of_lane, p, lane));
        take_lane(&mut conditions.hurwitz, &self.hurwitz, lane);
        take_lane(&mut conditions.discriminant, &self.discriminant, lane);
        is_regular(conditions.p[4][0]).then_some(conditions)
    }
}

#[cfg(all(feature = "batch", feature = "std"))]
#[inline]
fn take_lane<S: Simd>(of_lane: &mut [Tracked], of_lanes: &[Tracked<Lanes<S>>], lane: usize) {
    for (number, lanes) in of_lane.iter_mut().zip(of_lanes) {
        *number = Tracked { value: lanes.value.map(|part| part.lane(lane)), size: lanes.size.lane(lane) };
    }
}

/// In the square of the speed, without damping at rest.
#[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
#[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
pub(crate) fn in_square<T: Part>(matrices: &Matrices<T>) -> Conditions<3, 3, 7, T> {
    Conditions::new::<InSquare>(Variable::Square, &matrices.in_square())
}

/// In the speed.
#[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
#[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
pub(crate) fn in_speed<T: Part>(matrices: &Matrices<T>) -> Conditions<5, 7, 13, T> {
    Conditions::new::<InSpeed>(Variable::Speed, &matrices.in_speed())
}
