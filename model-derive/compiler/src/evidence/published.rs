//! Parameter sets: the matrices that were published for them, against what the formulas give there.

use super::definite;
use crate::check::Checked;
use crate::constant::{Constant, Constants};
use crate::derivation::Derived;
use crate::report::{Report, number};
use crate::syntax::{Declaration, ParameterSet, Printed, Published};

/// Reports a mass matrix without kinetic energy, and printed entries that the formulas do not give; `exact` are the values
/// of the parameters.
///
/// Only for a declaration without mistakes.
pub fn check_set(
    set: &ParameterSet,
    exact: &[Constant],
    checked: &Checked<'_>,
    derived: &Derived,
    report: &mut Report,
) {
    let mut values =
        Constants { parameters: exact.to_vec(), definitions: Vec::with_capacity(derived.definitions.len()) };
    for definition in &derived.definitions {
        // At some parameters a definition may have no value.
        match values.of(definition) {
            Ok(value) => values.definitions.push(value),
            Err(why) => {
                report.error(&set.name, format!("a definition has no value in the set `{}`: {why}", set.name));
                return;
            }
        }
    }
    definite::check_energy(derived, set, &values, report);
    for published in &set.published {
        compare(checked.declaration, set, published, derived, &values, report);
    }
}

fn compare(
    declaration: &Declaration,
    set: &ParameterSet,
    published: &Published,
    derived: &Derived,
    values: &Constants,
    report: &mut Report,
) {
    let name = published.name.name();
    let Some((_, rows)) = derived.matrices.iter().find(|(name, _)| *name == published.name) else {
        let message = match declaration.mechanism {
            Some(_) => format!("`{name}` of the mechanism is zero: expected one of the matrices that follow from it"),
            None => format!("the model has no matrix `{name}`: expected one of those that it declares"),
        };
        report.error(published.span, message);
        return;
    };
    for (row, ((_, printed), entries)) in published.rows.iter().zip(rows).enumerate() {
        for (column, (printed, entry)) in printed.iter().zip(entries).enumerate() {
            let found = match values.of(entry) {
                Ok(value) if agrees(printed, &value) => continue,
                Ok(value) => value.to_f64().map_or_else(|message| message, number),
                Err(why) => why.to_string(),
            };
            let message = format!(
                "`{}` publishes {}, but `{name}`, row {}, column {}, is {found} there: expected all printed digits",
                set.name,
                printed.text,
                row + 1,
                column + 1,
            );
            report.error(printed.region, message);
        }
    }
}

/// Whether a value agrees with print to less than one unit of the last digit: some print is not rounded to the nearest.
/// What is printed without a decimal point is exact.
fn agrees(printed: &Printed, value: &Constant) -> bool {
    let (mantissa, power) = printed.text.split_once(['e', 'E']).unwrap_or((&printed.text, "0"));
    let Ok(power) = power.parse::<i64>() else { return false };
    let last = match mantissa.split_once('.') {
        Some((_, fraction)) => power - fraction.len() as i64,
        None => power - EXACT,
    };
    let both = Constant::parse(&format!("1e{last}")).zip(Constant::parse(&printed.text));
    both.is_some_and(|(unit, printed)| value.distance(&printed) < unit)
}

/// Digits behind the last one of an exact number that the calculation reaches with room to spare.
const EXACT: i64 = 60;
