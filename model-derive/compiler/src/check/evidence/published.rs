//! Parameter sets: the matrices that were published for them, against what the formulas give there.

use std::collections::HashMap;

use super::definite;
use crate::check::constants::Constant;
use crate::check::matrices::check_shape;
use crate::check::units::Dimensions;
use crate::report::{Report, number};
use crate::syntax::{Declaration, ParameterSet, Printed, Published};

/// Reports mass matrices without kinetic energy, and printed entries that the formulas do not give; `order` puts each definition after those that it uses.
///
/// Only for a declaration without mistakes.
pub fn check(declaration: &Declaration, dimensions: &Dimensions, order: &[usize], report: &mut Report) {
    for set in &declaration.sets {
        // At some parameters a definition may have no value.
        let values = match values(declaration, dimensions, set, order) {
            Ok(values) => values,
            Err(error) => {
                report.error(&set.name, format!("a definition has no value in the set `{}`: {error}", set.name));
                continue;
            }
        };
        definite::check(declaration, set, &values, report);
        for (position, matrix) in set.published.iter().enumerate() {
            if set.published[..position].iter().any(|known| known.name == matrix.name) {
                let name = matrix.name.name();
                report.error(matrix.span, format!("`{name}` is published twice: expected one of each matrix"));
            }
            compare(declaration, set, matrix, &values, report);
        }
    }
}

/// The exact values of all names at a parameter set.
fn values(
    declaration: &Declaration,
    dimensions: &Dimensions,
    set: &ParameterSet,
    order: &[usize],
) -> syn::Result<HashMap<String, Constant>> {
    let mut values = HashMap::new();
    for (parameter, own) in declaration.parameters.iter().zip(&dimensions.parameters) {
        let entry = set.values.iter().find(|entry| entry.name == parameter.name);
        if let Some(value) = entry.and_then(|entry| entry.value.as_ref()) {
            values.insert(parameter.name.to_string(), Constant::in_unit(value, *own)?);
        }
    }
    for index in order {
        let definition = &declaration.definitions[*index];
        let value = Constant::evaluate_with(&definition.value, &values)?;
        values.insert(definition.name.to_string(), value);
    }
    Ok(values)
}

fn compare(
    declaration: &Declaration,
    set: &ParameterSet,
    published: &Published,
    values: &HashMap<String, Constant>,
    report: &mut Report,
) {
    let name = published.name.name();
    let Some(matrix) = declaration.matrices.iter().find(|matrix| matrix.name == published.name) else {
        let message = match declaration.mechanism {
            Some(_) => format!("`{name}` of the mechanism is zero: expected one of the matrices that follow from it"),
            None => format!("the model has no matrix `{name}`: expected one of those that it declares"),
        };
        report.error(published.span, message);
        return;
    };
    if !check_shape(name, &published.rows, published.region, declaration.coordinates.len(), report) {
        return;
    }
    for (row, ((_, printed), (_, entries))) in published.rows.iter().zip(&matrix.rows).enumerate() {
        for (column, (printed, entry)) in printed.iter().zip(entries).enumerate() {
            let value = match Constant::evaluate_with(entry, values) {
                Ok(value) => value,
                Err(error) => {
                    report.push(error);
                    continue;
                }
            };
            if !agrees(printed, &value) {
                let found = value.to_f64().map_or_else(|message| message, number);
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
