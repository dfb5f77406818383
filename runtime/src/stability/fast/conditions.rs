//! The conditions for critical speeds, by coefficients in fixed arrays.

use crate::characteristic::conditions::QuarticConditions;
use crate::characteristic::determinant::rows;
use crate::characteristic::powers::{InSpeed, InSquare, Matrices, Powers, Variable as InVariable};
use crate::numeric::Tracked;
use crate::system::Coefficients;

/// What polynomials along speed are in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Variable {
    Speed,
    /// The square of the speed: without damping at rest (C0 = 0).
    Square,
}

/// The polynomials in a variable x whose roots are the critical speeds, of degree 4, 6 and 12 or half of that.
pub(super) struct Conditions<const P: usize, const H: usize, const D: usize> {
    pub(super) variable: Variable,
    /// `det(M s^2 + (C0 + v C1) s + Kc + g K0 + v^2 K2)`, up to a sign, by powers of s; for [`Variable::Square`] those of
    /// odd powers divided by v. The last one is positive.
    pub(super) p: [[Tracked; P]; 5],
    /// The Hurwitz determinant; for [`Variable::Square`] divided by v^2.
    pub(super) hurwitz: [Tracked; H],
    /// The discriminant.
    pub(super) discriminant: [Tracked; D],
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
    let Coefficients { m, c0, c1, kc, k0, k2, .. } = coefficients;
    let entries = [m, c0, c1, kc, k0, k2].map(rows);
    let is_moderate = |x: f64| (SMALLEST..=LARGEST).contains(&x.abs()) | (x == 0.0);
    // Without a branch for each entry.
    let moderate = entries.as_flattened().as_flattened().iter().fold(true, |all, &x| all & is_moderate(x));
    let matrices = Matrices::new(entries, gravity);
    let is_regular = matrices.mass.value.to_f64().abs() > REGULAR * matrices.mass.size;
    (moderate && is_moderate(gravity) && is_regular).then_some(matrices)
}

impl<const P: usize, const H: usize, const D: usize> Conditions<P, H, D> {
    #[inline]
    fn new<V>(variable: Variable, powers: &Powers<V>) -> Self
    where
        V: InVariable<Hurwitz = [Tracked; H], Discriminant = [Tracked; D]>,
    {
        let conditions = QuarticConditions::new(powers);
        let (hurwitz, discriminant) = (conditions.hurwitz(), conditions.discriminant());
        Self { variable, p: powers.padded(), hurwitz, discriminant }
    }
}

/// In the square of the speed, without damping at rest.
pub(super) fn in_square(matrices: &Matrices) -> Conditions<3, 3, 7> {
    Conditions::new::<InSquare>(Variable::Square, &matrices.in_square())
}

/// In the speed.
pub(super) fn in_speed(matrices: &Matrices) -> Conditions<5, 7, 13> {
    Conditions::new::<InSpeed>(Variable::Speed, &matrices.in_speed())
}
