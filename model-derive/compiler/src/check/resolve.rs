//! Names in formulas to what they stand for.

use super::constants;
use super::names::{Meaning, Scope};
use super::units::Quantity;
use crate::model::{Expr, Function};
use crate::nearest::nearest;
use crate::report::Report;
use crate::syntax::{Expression, Kind, reserved};

/// Resolves a formula; definitions are numbered as they are declared.
pub fn expression(expression: &Expression, scope: &mut Scope, report: &mut Report) -> Expr {
    constants::verify(expression, report);
    resolve(expression, scope, report)
}

fn resolve(expression: &Expression, scope: &mut Scope, report: &mut Report) -> Expr {
    let mut inner = |value: &Expression| resolve(value, scope, report);
    match &expression.kind {
        Kind::Number(number) => Expr::Number(number.clone()),
        Kind::Quantity(number, unit) => {
            let number = Expression { kind: Kind::Number(number.clone()), region: expression.region };
            match Quantity::new(unit) {
                Ok(quantity) => inner(&quantity.formula(number)),
                Err(error) => {
                    report.push(error);
                    Expr::Pi
                }
            }
        }
        Kind::Sum(terms) => Expr::Sum(terms.iter().map(|term| (term.negative, inner(&term.value))).collect()),
        Kind::Product(factors) => Expr::Product(factors.iter().map(|f| (f.inverse, inner(&f.value))).collect()),
        Kind::Power(base, exponent) => Expr::Power(Box::new(inner(base)), *exponent),
        Kind::Call(name, argument) => {
            let argument = inner(argument);
            match Function::from_name(&name.to_string()) {
                Some(function) => Expr::Call(function, Box::new(argument)),
                None if scope.get(name).is_some() => {
                    report.error(name, format!("`{name}` is no function: expected an operator before the parentheses"));
                    scope.excused.insert(name.to_string());
                    argument
                }
                None => {
                    report.error(name, unknown_function(&name.to_string(), &FORMULA_FUNCTIONS));
                    argument
                }
            }
        }
        Kind::Name(name) if name == "pi" => Expr::Pi,
        Kind::Name(name) => match scope.get(name) {
            Some(Meaning::Parameter(index)) => Expr::Parameter(index),
            Some(Meaning::Definition(index)) => Expr::Definition(index),
            Some(Meaning::Refused) => Expr::Pi,
            Some(Meaning::Coordinate) => {
                let message = format!(
                    "`{name}` is a coordinate: the matrices are its coefficients; expected parameters and definitions"
                );
                report.error(name, message);
                Expr::Pi
            }
            None => {
                let message = match Function::from_name(&name.to_string()) {
                    Some(_) => format!("`{name}` is a function: expected its argument in parentheses"),
                    None if name == "v" => SPEED.to_string(),
                    None => match reserved(&name.to_string()) {
                        Some(what) => format!("`{name}`, {what}, is not supported in formulas: expected a formula"),
                        None => {
                            let hint = scope.suggestion(name);
                            format!("unknown name `{name}`: expected a parameter or a definition{hint}")
                        }
                    },
                };
                report.error(name, message);
                // Any value will do: with a mistake reported nothing is compiled.
                Expr::Pi
            }
        },
    }
}

const SPEED: &str = "unknown name `v`: the speed is taken out of the matrices; expected parameters and definitions in \
                     C1, the coefficient of v, and in K2, the coefficient of v^2";

const FORMULA_FUNCTIONS: [&str; 4] = ["sin", "cos", "tan", "sqrt"];

/// What to say of a function that does not exist.
pub fn unknown_function(name: &str, known: &[&'static str]) -> String {
    let hint = nearest(name, known.iter().copied()).map(|near| format!("; did you mean `{near}`?")).unwrap_or_default();
    format!("unknown function `{name}`: expected one of {}{hint}", known.join(", "))
}

/// A formula as text, for messages.
pub fn text(expression: &Expression) -> String {
    match &expression.kind {
        Kind::Number(number) => number.to_string(),
        Kind::Quantity(number, unit) => format!("{number} [{}]", unit.text),
        Kind::Name(name) => name.to_string(),
        Kind::Sum(terms) => {
            let mut text = String::new();
            for (index, term) in terms.iter().enumerate() {
                text.push_str(match (index, term.negative) {
                    (0, false) => "",
                    (0, true) => "-",
                    (_, false) => " + ",
                    (_, true) => " - ",
                });
                text.push_str(&enclosed(&term.value, matches!(term.value.kind, Kind::Sum(_))));
            }
            text
        }
        Kind::Product(factors) => {
            let mut text = String::new();
            for (index, factor) in factors.iter().enumerate() {
                text.push_str(match (index, factor.inverse) {
                    (0, false) => "",
                    (0, true) => "1/",
                    (_, false) => "*",
                    (_, true) => "/",
                });
                text.push_str(&enclosed(&factor.value, matches!(factor.value.kind, Kind::Sum(_) | Kind::Product(_))));
            }
            text
        }
        Kind::Power(base, exponent) => {
            let compound = matches!(base.kind, Kind::Sum(_) | Kind::Product(_) | Kind::Power(..));
            format!("{}^{exponent}", enclosed(base, compound))
        }
        Kind::Call(name, argument) => format!("{name}({})", text(argument)),
    }
}

fn enclosed(expression: &Expression, compound: bool) -> String {
    let text = text(expression);
    if compound { format!("({text})") } else { text }
}
