//! Powers of powers: what they would expand to has a bound.

use crate::report::Report;
use crate::syntax::{Declaration, Expression, Kind};

/// Powers inside powers may have no larger exponent together: expanded forms of them would take longer than anyone waits.
const MAX_EXPONENT: u64 = 512;

/// Reports powers inside powers whose exponents together are too large. Definitions count as names: what is written of them
/// in the places of others is bounded by the search of programs, and three powers of 64 through them take seconds.
pub fn check_powers(declaration: &Declaration, report: &mut Report) {
    let definitions = declaration.definitions.iter().map(|definition| &definition.value);
    let requirements = declaration.requirements.iter().map(|requirement| &requirement.value);
    let assertions = declaration.assertions.iter().flat_map(|assertion| [&assertion.left, &assertion.right]);
    let wholes = declaration.wholes.iter().map(|(_, matrix)| matrix);
    let matrices = declaration.matrices.iter().chain(&declaration.asserted).chain(wholes);
    let entries = matrices.flat_map(|matrix| matrix.rows.iter().flat_map(|(_, row)| row));
    let laws = declaration.feedback.iter().map(|feedback| &feedback.law);
    let attributes = declaration.attributes().chain(laws);
    for formula in definitions.chain(requirements).chain(assertions).chain(entries).chain(attributes) {
        find_exponent(formula, report);
    }
}

/// The largest product of the exponents of powers inside each other; zero once one is refused.
fn find_exponent(formula: &Expression, report: &mut Report) -> u64 {
    let mut inner = |formula: &Expression| find_exponent(formula, report);
    match &formula.kind {
        Kind::Number(_) | Kind::Quantity(..) | Kind::Name(_) => 1,
        Kind::Sum(terms) => terms.iter().map(|term| inner(&term.value)).max().unwrap_or(1),
        Kind::Product(factors) => factors.iter().map(|factor| inner(&factor.value)).max().unwrap_or(1),
        Kind::Call(_, argument) => inner(argument),
        Kind::Power(base, exponent) => {
            let before = inner(base);
            let own = u64::from(exponent.unsigned_abs()).max(1);
            let together = before * own;
            if before > 1 && together > MAX_EXPONENT {
                let message = format!(
                    "the exponents of powers inside each other are {together} together here: expected at most \
                     {MAX_EXPONENT}"
                );
                report.error(formula.region, message);
                return 0;
            }
            together
        }
    }
}
