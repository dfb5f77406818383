//! Critical speeds and stable ranges of ordinary models, fast: for certain, or not at all.
//!
//! The conditions for critical speeds are polynomials with coefficients in double-double, in arrays of fixed size. Their
//! roots are isolated in `f64`, with bounds on all errors that decide whether a sign is certain, and polished in
//! double-double. Wherever a sign is not certain (nearly multiple roots, speeds that nearly coincide, terms that cancel)
//! there is no answer, and the careful search in double-double has to find one.

mod characteristic;
mod double_root;
mod root;
mod search;
mod signs;

use arrayvec::ArrayVec;

use super::Stability;
use super::ranges::Verdicts;
use super::verdict::{Verdict, verdict};
use crate::number::Scalar;
use crate::system::Coefficients;
use characteristic::{Conditions, Matrices, Variable};
use search::All;
use signs::Signs;

/// All critical speeds and stable ranges; `None` if they are not certain.
pub(super) fn stability<T: Scalar>(coefficients: &Coefficients<T, 2>, gravity: f64) -> Option<Stability> {
    let matrices = Matrices::new(coefficients, gravity)?;
    if matrices.are_undamped_at_rest() { matrices.of_square().stability() } else { matrices.of_speed().stability() }
}

impl<const P: usize, const H: usize, const D: usize> Conditions<P, H, D> {
    fn stability(&self) -> Option<Stability> {
        let signs = Signs::new(self);
        let mut found = All::new();
        self.search(&signs, &mut found)?;
        let bounds = found.iter().filter_map(|found| Some((found.critical.speed, found.there?)));
        let bounds: ArrayVec<(f64, Verdict), 24> = bounds.collect();
        let verdicts = Verdicts::between(self.at_rest(), &bounds, |speed| {
            let x = match self.variable {
                Variable::Speed => speed,
                Variable::Square => speed * speed,
            };
            signs.verdict(false, x)
        })?;
        Some(Stability {
            critical_speeds: found.iter().map(|found| found.critical).collect(),
            stable_ranges: verdicts.stable_ranges(),
            verdicts,
        })
    }

    fn at_rest(&self) -> Verdict {
        let mut p = self.p.map(|p| p[0]);
        if self.variable == Variable::Square {
            (p[1], p[3]) = (0.0.into(), 0.0.into());
        }
        verdict(&p)
    }
}
