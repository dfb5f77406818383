//! Critical speeds and stable ranges of any model, in twice the precision of `f64`.
//!
//! The conditions for critical speeds are polynomials in the speed, whose roots are found all, with what rounding may do to
//! each.

mod critical_speeds;
pub(super) mod double_roots;
mod found;
mod imaginary;
mod verdicts;

use super::along_speed::Characteristic;
use super::critical::CriticalSpeed;
use super::verdicts::{Stretch, Verdicts};
use crate::system::SystemError;

/// All critical speeds, ascending, and the verdicts between and at them.
pub(super) fn find_stability(
    characteristic: &Characteristic,
) -> Result<(Vec<CriticalSpeed>, Verdicts<Vec<Stretch>>), SystemError> {
    let found = critical_speeds::find_critical_speeds(characteristic)?;
    let verdicts = verdicts::find_verdicts(characteristic, &found);
    Ok((found.iter().map(|found| found.critical).collect(), verdicts))
}
