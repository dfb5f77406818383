//! Critical speeds and stable ranges of ordinary models, fast: for certain, or not at all.
//!
//! The conditions for critical speeds are polynomials with coefficients in double-double, in arrays of fixed size. Their
//! roots are isolated in `f64`, with bounds on all errors that decide whether a sign is certain, and polished in
//! double-double. Wherever a sign is not certain (nearly multiple roots, speeds that nearly coincide, terms that cancel)
//! there is no answer, and the careful search in double-double has to find one.

mod certain_speeds;
pub(crate) mod conditions;
mod meeting;
mod signs;
mod simple_root;

use arrayvec::ArrayVec;

use super::certain::{CertainStability, MOST};
use super::verdict::Verdict;
use super::verdicts::stretches_between;
use crate::characteristic::powers::Matrices;
use crate::system::Coefficients;
use certain_speeds::{CertainSpeed, CertainSpeeds};
use conditions::{Conditions, Variable};
use signs::Signs;

/// Fills in all critical speeds, ascending, and the verdicts between and at them; `None` if they are not certain.
pub(super) fn find_stability(
    coefficients: &Coefficients<f64, 2>,
    gravity: f64,
    stability: &mut CertainStability,
) -> Option<()> {
    let matrices = conditions::moderate_matrices(coefficients, gravity)?;
    if matrices.are_undamped_at_rest() {
        conditions::in_square(&matrices).find_stability(stability)
    } else {
        damped(&matrices, stability)
    }
}

/// With damping at rest: in a place of its own, so that others do not take its room on the stack.
#[inline(never)]
fn damped(matrices: &Matrices, stability: &mut CertainStability) -> Option<()> {
    conditions::in_speed(matrices).find_stability(stability)
}

impl<const P: usize, const H: usize, const D: usize> Conditions<P, H, D> {
    pub(super) fn find_stability(&self, stability: &mut CertainStability) -> Option<()> {
        let signs = Signs::new(self);
        let mut found = CertainSpeeds::new();
        self.find_certain_speeds(&signs, &mut found)?;
        let mut bounds = ArrayVec::<(f64, Verdict), MOST>::new();
        for CertainSpeed { critical, there } in &found {
            there.map_or(Ok(()), |there| bounds.try_push((critical.speed, there))).ok()?;
        }
        let at = |speed: f64| {
            let x = match self.variable {
                Variable::Speed => speed,
                Variable::Square => speed * speed,
            };
            signs.verdict(false, x)
        };
        for stretch in stretches_between(self.at_rest(), &bounds, at) {
            stability.verdicts.stretches.try_push(stretch?).ok()?;
        }
        for found in &found {
            stability.critical_speeds.try_push(found.critical).ok()?;
        }
        Some(())
    }

    fn at_rest(&self) -> Verdict {
        let mut p = self.p.map(|p| p[0]);
        if self.variable == Variable::Square {
            (p[1], p[3]) = (0.0.into(), 0.0.into());
        }
        Verdict::of_polynomial(&p)
    }
}
