//! Names in formulas to what they stand for.

use super::constants;
use super::feedback::RATE;
use super::names::{Meaning, Scope, unknown_function};
use super::units::LOAD;
use super::units::declared::Quantity;
use crate::formula::{Factor, Formula, Function, Term};
use crate::report::Report;
use crate::syntax::{self, Expression, Kind, reserved};

/// Resolves a formula. Mistakes are reported, and then some value stands in their place.
pub fn resolve(expression: &Expression, scope: &mut Scope, report: &mut Report) -> Formula {
    constants::verify(expression, report);
    resolve_names(expression, false, scope, report)
}

/// Resolves a formula that may depend on the speed, which is a parameter behind all others in it.
pub fn resolve_in_speed(expression: &Expression, scope: &mut Scope, report: &mut Report) -> Formula {
    constants::verify(expression, report);
    resolve_names(expression, true, scope, report)
}

fn resolve_names(expression: &Expression, in_speed: bool, scope: &mut Scope, report: &mut Report) -> Formula {
    if let Kind::Call(name, argument) = &expression.kind
        && name == RATE
        && scope.get(name).is_none()
    {
        let message = format!(
            "`{RATE}({argument})` where nothing moves: expected parameters and definitions; the rate of a coordinate may stand \
             in a `feedback T on q = …;`"
        );
        report.error(expression.region, message);
        return Formula::Pi;
    }
    if let Kind::Call(name, argument) = &expression.kind
        && name == LOAD
        && scope.get(name).is_none()
    {
        return resolve_load(expression, argument, scope, report);
    }
    let mut inner = |value: &Expression| resolve_names(value, in_speed, scope, report);
    match &expression.kind {
        Kind::Number(number) => Formula::Number(number.clone()),
        Kind::Quantity(number, unit) => {
            let number = Expression { kind: Kind::Number(number.clone()), region: expression.region };
            match Quantity::new(unit) {
                Ok(quantity) => inner(&quantity.formula(number)),
                Err(error) => {
                    report.push(error);
                    Formula::Pi
                }
            }
        }
        Kind::Sum(terms) => {
            let term = |term: &syntax::Term| Term { negative: term.negative, value: inner(&term.value) };
            Formula::Sum(terms.iter().map(term).collect())
        }
        Kind::Product(factors) => {
            let factor = |factor: &syntax::Factor| Factor { inverse: factor.inverse, value: inner(&factor.value) };
            Formula::Product(factors.iter().map(factor).collect())
        }
        Kind::Power(base, exponent) => Formula::Power(Box::new(inner(base)), *exponent),
        Kind::Call(name, argument) => {
            let argument = inner(argument);
            match Function::from_name(&name.to_string()) {
                Some(function) => Formula::Call(function, Box::new(argument)),
                None if scope.get(name).is_some() => {
                    report.error(name, format!("`{name}` is no function: expected an operator before the parentheses"));
                    scope.excused.insert(name.to_string());
                    argument
                }
                None => {
                    report.error(name, unknown_function(&name.to_string(), &Function::ALL.map(Function::name)));
                    argument
                }
            }
        }
        Kind::Name(name) if name == "pi" => Formula::Pi,
        Kind::Name(name) => match scope.get(name) {
            Some(Meaning::Speed(_)) if !in_speed => {
                let message = format!(
                    "`{name}` is the speed, which `C`, `K` and a `feedback` may depend on, and definitions that only they use: \
                     expected parameters and definitions"
                );
                report.error(name, message);
                Formula::Pi
            }
            Some(Meaning::Definition(index)) if !in_speed && index >= scope.steady => {
                let message = format!(
                    "`{name}` depends on the speed, which only `C`, `K` and a `feedback` may: expected parameters and definitions \
                     that do not"
                );
                report.error(name, message);
                Formula::Pi
            }
            Some(Meaning::Parameter(index) | Meaning::Speed(index)) => Formula::Parameter(index),
            Some(Meaning::Definition(index)) => Formula::Definition(index),
            Some(Meaning::Refused) => Formula::Pi,
            Some(Meaning::Coordinate) => {
                let message = format!(
                    "`{name}` is a coordinate: the matrices are its coefficients; expected parameters and definitions"
                );
                report.error(name, message);
                Formula::Pi
            }
            None => {
                let message = match Function::from_name(&name.to_string()) {
                    Some(_) => format!("`{name}` is a function: expected its argument in parentheses"),
                    None if name == "v" => SPEED.to_string(),
                    None => match reserved(&name.to_string()) {
                        Some(what) => format!("`{name}`, {what}, is not supported in formulas: expected a formula"),
                        None => {
                            let hint = scope.suggest(name);
                            format!("unknown name `{name}`: expected a parameter or a definition{hint}")
                        }
                    },
                };
                report.error(name, message);
                // Any value will do: with a mistake reported nothing is compiled.
                Formula::Pi
            }
        },
    }
}

/// `load(R)`: the steady load of a wheel.
fn resolve_load(expression: &Expression, argument: &Expression, scope: &Scope, report: &mut Report) -> Formula {
    let Some(loads) = &scope.loads else {
        let message = format!(
            "`{expression}`, the steady load of a wheel, may stand in the `cornering` and `camber` of wheels alone: expected \
             parameters and definitions"
        );
        report.error(expression.region, message);
        return Formula::Pi;
    };
    let wheel = match &argument.kind {
        Kind::Name(name) => loads.iter().find(|(known, _)| name == known),
        _ => None,
    };
    match wheel {
        Some((_, load)) => load.clone(),
        None => {
            let names: Vec<String> = loads.iter().map(|(name, _)| format!("`{name}`")).collect();
            let message = format!("`{argument}` is no wheel: expected the load of one of {}", names.join(", "));
            report.error(argument.region, message);
            Formula::Pi
        }
    }
}

const SPEED: &str = "unknown name `v`: expected parameters and definitions in `C1`, the coefficient of v, in `K2`, that of \
                     v^2, and so on; or `v: m/s, speed;` among the parameters, and `C = …;` and `K = …;` with the speed in \
                     them";
