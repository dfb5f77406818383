//! Constant expressions, such as `pi/10`, and constant parts of formulas.

use super::names::unknown_function;
use super::units::declared::Quantity;
use super::units::dimension::Dimension;
use crate::constant::{Constant, NoValue};
use crate::formula::{Factor, Function, Term};
use crate::report::{Report, error};
use crate::syntax::{Expression, Kind, Value};

/// The functions of constants alone, beside those of formulas.
const INVERSES: [&str; 3] = ["asin", "acos", "atan"];

/// The value of an expression without parameters.
///
/// # Errors
/// Names other than `pi`, unknown functions, and values that are not finite.
pub fn evaluate(expression: &Expression) -> syn::Result<Constant> {
    let no_value = |why: NoValue| error(expression.region, why);
    match &expression.kind {
        Kind::Quantity(number, unit) => {
            let number = Expression { kind: Kind::Number(number.clone()), region: expression.region };
            evaluate(&Quantity::new(unit)?.formula(number))
        }
        Kind::Number(number) => Constant::of_decimal(number).map_err(no_value),
        Kind::Name(name) if name == "pi" => Ok(Constant::pi()),
        Kind::Name(name) => {
            Err(error(name, format!("found `{name}`: expected a constant, of numbers, `pi` and functions")))
        }
        Kind::Sum(terms) => {
            let terms = terms.iter().map(|term| Ok(Term { negative: term.negative, value: evaluate(&term.value)? }));
            Constant::sum(terms.collect::<syn::Result<Vec<_>>>()?).map_err(no_value)
        }
        Kind::Product(factors) => {
            let factors =
                factors.iter().map(|factor| Ok(Factor { inverse: factor.inverse, value: evaluate(&factor.value)? }));
            Constant::product(factors.collect::<syn::Result<Vec<_>>>()?).map_err(no_value)
        }
        Kind::Power(base, exponent) => evaluate(base)?.power(*exponent).map_err(no_value),
        Kind::Call(name, argument) => {
            let argument = evaluate(argument)?;
            let value = match name.to_string().as_str() {
                "asin" => argument.asin(),
                "acos" => argument.acos(),
                "atan" => argument.atan(),
                other => match Function::from_name(other) {
                    Some(function) => argument.call(function),
                    None => {
                        let known = [&Function::ALL.map(Function::name)[..], &INVERSES].concat();
                        return Err(error(name, unknown_function(other, &known)));
                    }
                },
            };
            value.map_err(no_value)
        }
    }
}

/// The value in the units of the SI, where `own` is the dimension of what has the value and, unless another is written
/// behind it, its unit.
///
/// # Errors
/// As [`evaluate`], and units that are not known or not of that dimension.
pub fn evaluate_in(value: &Value, own: Option<Dimension>) -> syn::Result<Constant> {
    let Some(unit) = &value.unit else { return evaluate(&value.number) };
    let quantity = Quantity::new(unit)?;
    match own {
        Some(own) if !own.same_unit(quantity.dimension) => {
            let expected = if own.is_number() { "a pure number or an angle".into() } else { format!("one in {own}") };
            let message = format!("a value in `{}`: expected {expected}", unit.text);
            Err(error(unit.region, message))
        }
        _ => evaluate(&quantity.formula(value.number.clone())),
    }
}

/// Reports parts of a formula that are constant and have no finite value within the range of `f64`, and divisors that
/// are zero.
pub fn verify(expression: &Expression, report: &mut Report) {
    if !verify_parts(expression, report) {
        return;
    }
    let value = evaluate(expression)
        .and_then(|constant| constant.to_f64().map_err(|message| error(expression.region, message)));
    if let Err(error) = value {
        report.push(error);
    }
}

/// Whether all of an expression is constant; if not, its constant parts have been verified.
fn verify_parts(expression: &Expression, report: &mut Report) -> bool {
    let parts: Vec<(&Expression, bool)> = match &expression.kind {
        Kind::Number(_) => return true,
        // An unknown unit is another mistake.
        Kind::Quantity(_, unit) => return Quantity::new(unit).is_ok(),
        Kind::Name(name) => return name == "pi",
        Kind::Sum(terms) => terms.iter().map(|term| (&term.value, false)).collect(),
        Kind::Product(factors) => factors.iter().map(|factor| (&factor.value, factor.inverse)).collect(),
        Kind::Power(base, exponent) => vec![(base, *exponent < 0)],
        Kind::Call(function, argument) if Function::from_name(&function.to_string()).is_some() => {
            vec![(argument, false)]
        }
        // An unknown function is another mistake.
        Kind::Call(..) => return false,
    };
    let constant: Vec<bool> = parts.iter().map(|(part, _)| verify_parts(part, report)).collect();
    if constant.iter().all(|constant| *constant) {
        return true;
    }
    for ((part, inverse), _) in parts.iter().zip(&constant).filter(|(_, constant)| **constant) {
        match evaluate(part) {
            Ok(value) if *inverse && value.is_zero() => {
                report.error(part.region, "a division by zero: expected a divisor that is not zero");
            }
            _ => verify(part, report),
        }
    }
    if let Some(together) = constant_parts(expression, &constant) {
        verify(&together, report);
    }
    false
}

/// The constant factors or terms as one formula, if there are several: each may be in range, and all of them not.
fn constant_parts(expression: &Expression, constant: &[bool]) -> Option<Expression> {
    fn chosen<T: Clone>(parts: &[T], constant: &[bool]) -> Option<Vec<T>> {
        let chosen = parts.iter().zip(constant).filter(|(_, constant)| **constant).map(|(part, _)| part.clone());
        Some(chosen.collect::<Vec<T>>()).filter(|chosen| chosen.len() > 1)
    }
    let kind = match &expression.kind {
        Kind::Sum(terms) => Kind::Sum(chosen(terms, constant)?),
        Kind::Product(factors) => Kind::Product(chosen(factors, constant)?),
        _ => return None,
    };
    Some(Expression { kind, region: expression.region })
}
