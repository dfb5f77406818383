//! The critical speeds, as roots of the conditions.

use arrayvec::ArrayVec;
use nalgebra::Complex;

use super::super::certain::MOST;
use super::super::critical::{Change, CriticalKind, CriticalSpeed};
use super::super::verdict::Verdict;
use super::conditions::{Conditions, Variable};
use super::meeting::DoubleRoots;
use super::signs::Signs;
use super::simple_root::Root;
use crate::numeric::fixed::evaluate;
use crate::numeric::isolation::Brackets;
use crate::numeric::rounded::Rounded;
use crate::numeric::{DoubleDouble, Tracked};

/// A critical speed and the verdict at it, `None` where no eigenvalue is on the imaginary axis.
pub(super) struct CertainSpeed {
    pub(super) critical: CriticalSpeed,
    pub(super) there: Option<Verdict>,
}

/// As many as the conditions have roots at most.
pub(super) type CertainSpeeds = ArrayVec<CertainSpeed, MOST>;

/// The least relative distance between critical speeds, for their order to be certain.
const APART: f64 = 1.0 / (1u64 << 36) as f64;

/// The largest relative error of a critical speed that is surely one.
const SHARP: f64 = 1.0 / (1u64 << 20) as f64;

/// The last step of a root of the discriminant, relative to it, from where on it is polished as a double root.
const CLOSE: f64 = 1.0 / (1u64 << 7) as f64;

/// The least that may be left of terms that cancel, for a quotient to have all the digits of `f64`.
const CANCELLED: f64 = 1.0 / (1u64 << 16) as f64;

impl<const P: usize, const H: usize, const D: usize> Conditions<P, H, D> {
    /// All critical speeds, ascending; `None` if it is not certain which there are.
    pub(super) fn find_certain_speeds(&self, signs: &Signs<P, H>, found: &mut CertainSpeeds) -> Option<()> {
        let mut brackets = Brackets::new();
        self.find_capsizes(signs, &mut brackets, found)?;
        self.find_weaves(signs, &mut brackets, found)?;
        self.find_meetings(&mut brackets, found)?;
        sort(found);
        let is_apart =
            |(x, y): (&CertainSpeed, &CertainSpeed)| y.critical.speed - x.critical.speed > APART * y.critical.speed;
        found.iter().zip(found.iter().skip(1)).all(is_apart).then_some(())
    }

    /// Where the lowest coefficient is zero. Nearby the eigenvalue is about `-p_0 / p_1`.
    fn find_capsizes(&self, signs: &Signs<P, H>, brackets: &mut Brackets, found: &mut CertainSpeeds) -> Option<()> {
        brackets.clear();
        signs.capsize().isolate(brackets)?;
        for bracket in brackets.iter() {
            let root = Root::simple(&self.p[0], signs.capsize(), bracket)?;
            let stabilizes = bracket.rises == signs.is_positive(1, root.x)?;
            let there = Some(signs.verdict(true, root.x)?.max(Verdict::Marginal));
            let critical = self.critical(CriticalKind::Capsize, &root, Complex::new(0.0, 0.0), change(stabilizes))?;
            found.try_push(CertainSpeed { critical, there }).ok()?;
        }
        Some(())
    }

    /// Where the Hurwitz determinant is zero, if the two eigenvalues that sum to zero are imaginary.
    fn find_weaves(&self, signs: &Signs<P, H>, brackets: &mut Brackets, found: &mut CertainSpeeds) -> Option<()> {
        brackets.clear();
        signs.hurwitz.isolate(brackets)?;
        for bracket in brackets.iter() {
            let root = Root::simple(&self.hurwitz, &signs.hurwitz, bracket)?;
            let is_damped = signs.is_positive(3, root.x)?;
            if signs.is_positive(1, root.x)? != is_damped {
                continue;
            }
            let stabilizes = bracket.rises == is_damped;
            let is_rest_stable = is_damped && signs.is_positive(0, root.x)?;
            let there = Some(if is_rest_stable { Verdict::Marginal } else { Verdict::Unstable });
            let eigenvalue = Complex::new(0.0, self.frequency(&root)?);
            let critical = self.critical(CriticalKind::Weave, &root, eigenvalue, change(stabilizes))?;
            found.try_push(CertainSpeed { critical, there }).ok()?;
        }
        Some(())
    }

    /// The frequency of an imaginary pair: the square root of `p_1 / p_3`.
    fn frequency(&self, root: &Root) -> Option<f64> {
        let coefficient = |p: &[Tracked; P]| {
            let sum = evaluate(p, root.x);
            let slope = Rounded::new(p).taylor(root.x)[1];
            let is_sharp = sum.value.to_f64().abs() >= CANCELLED * sum.size;
            is_sharp.then(|| sum.value.add_roughly((slope * root.rest).into()))
        };
        let (numerator, denominator) = (coefficient(&self.p[1])?, coefficient(&self.p[3])?);
        let quotient = numerator.to_f64() / denominator.to_f64();
        let rest = (numerator - denominator.times(quotient)).to_f64() / denominator.to_f64();
        Some(Root::sqrt(quotient, rest).0)
    }

    /// Where the discriminant is zero: simply, so that the double eigenvalue is real.
    fn find_meetings(&self, brackets: &mut Brackets, found: &mut CertainSpeeds) -> Option<()> {
        let discriminant = Rounded::new(&self.discriminant);
        brackets.clear();
        discriminant.isolate(brackets)?;
        if brackets.is_empty() {
            return Some(());
        }
        let double_roots = DoubleRoots::new(self);
        for bracket in brackets.iter() {
            let at = double_roots.near(discriminant.refine(bracket, CLOSE)?, bracket)?;
            let (sigma, sigma_rest) = at.sigma;
            let eigenvalue = match self.variable {
                Variable::Speed => sigma + sigma_rest,
                Variable::Square => {
                    let (speed, rest) = at.root.speed(self.variable);
                    let product = DoubleDouble::product(speed, sigma);
                    product.add_roughly((speed * sigma_rest + rest * sigma).into()).to_f64()
                }
            };
            let change = if at.merges { Change::Merges } else { Change::Splits };
            let kind = CriticalKind::DoubleRoot;
            let critical = self.critical(kind, &at.root, Complex::new(eigenvalue, 0.0), change)?;
            found.try_push(CertainSpeed { critical, there: None }).ok()?;
        }
        Some(())
    }

    fn critical(
        &self,
        kind: CriticalKind,
        root: &Root,
        eigenvalue: Complex<f64>,
        change: Change,
    ) -> Option<CriticalSpeed> {
        let (speed, _) = root.speed(self.variable);
        // An eighth of the rounding of the root at least.
        let error = root.error.max(0.125 * f64::EPSILON * root.x);
        let error = match self.variable {
            Variable::Speed => error,
            Variable::Square => error / (2.0 * speed),
        };
        let critical = CriticalSpeed { kind, speed, error: error + 0.5 * f64::EPSILON * speed, eigenvalue, change };
        (error <= SHARP * speed).then_some(critical)
    }
}

fn change(stabilizes: bool) -> Change {
    if stabilizes { Change::Stabilizes } else { Change::Destabilizes }
}

/// Ascending, by insertion: they are few, and it has no panic, which that of the standard library has.
fn sort(found: &mut [CertainSpeed]) {
    for last in 1..found.len() {
        for place in (0..last).rev() {
            match found.get_mut(place..place + 2) {
                Some([x, y]) if x.critical.speed > y.critical.speed => core::mem::swap(x, y),
                _ => break,
            }
        }
    }
}
