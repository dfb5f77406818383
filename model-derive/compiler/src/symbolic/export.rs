//! Formulas on their way back out of the engine.

use symbolica::atom::{AtomView, Symbol};
use symbolica::domains::rational::Rational;
use symbolica::transcendental::{sec, tan};

use super::atoms::call_of;
use super::form::Form;
use crate::formula::{Decimal, Factor, Formula, Function, Term};

impl Form {
    /// The form as a formula of so many parameters and of definitions.
    pub fn to_formula(&self, parameters: usize) -> Formula {
        to_formula(self.0.as_view(), parameters)
    }
}

fn to_formula(view: AtomView<'_>, parameters: usize) -> Formula {
    match view {
        AtomView::Num(_) => number(view),
        AtomView::Var(symbol) => symbol_at(symbol.get_symbol(), parameters),
        AtomView::Add(sum) => Formula::Sum(sum.iter().map(|term| signed(term, parameters)).collect()),
        AtomView::Mul(product) => Formula::Product(product.iter().map(|factor| divided(factor, parameters)).collect()),
        AtomView::Pow(_) => match divided(view, parameters) {
            divisor @ Factor { inverse: true, .. } => Formula::Product(vec![Factor::times(whole("1")), divisor]),
            Factor { inverse: false, value } => value,
        },
        AtomView::Fun(_) => {
            let argument =
                |function| call_of(view, function).map(|argument| Box::new(to_formula(argument.as_view(), parameters)));
            let call = |function, known| argument(function).map(|argument| Formula::Call(known, argument));
            let known = call(Symbol::SIN, Function::Sin)
                .or_else(|| call(Symbol::COS, Function::Cos))
                .or_else(|| call(tan(), Function::Tan));
            known.unwrap_or_else(|| {
                let argument = argument(sec()).unwrap_or_else(|| unreachable!("a function that no formula has"));
                Formula::Product(vec![Factor::times(whole("1")), Factor::over(Formula::Call(Function::Cos, argument))])
            })
        }
    }
}

/// A term and whether it is subtracted.
fn signed(term: AtomView<'_>, parameters: usize) -> Term {
    let factor = match term {
        AtomView::Num(_) => Rational::try_from(term).ok(),
        AtomView::Mul(product) => product.iter().find_map(|factor| Rational::try_from(factor).ok()),
        _ => None,
    };
    if factor.is_some_and(|number| number.is_negative()) {
        Term::minus(to_formula((-term.to_owned()).as_view(), parameters))
    } else {
        Term::plus(to_formula(term, parameters))
    }
}

/// More roots of roots than a formula can have, since its brackets nest less deeply.
const MAX_ROOTS: usize = 256;

/// A factor and whether it divides.
fn divided(factor: AtomView<'_>, parameters: usize) -> Factor {
    let AtomView::Pow(power) = factor else { return Factor::times(to_formula(factor, parameters)) };
    let (base, exponent) = power.get_base_exp();
    let mut exponent = Rational::try_from(exponent).unwrap_or_else(|_| unreachable!("powers are rational"));
    let mut base = to_formula(base, parameters);
    // Roots are powers of a half, roots of roots of a quarter, and so on.
    for root in 0.. {
        if exponent.is_integer() {
            break;
        }
        assert!(root < MAX_ROOTS, "no root but square ones");
        base = Formula::Call(Function::Sqrt, Box::new(base));
        exponent *= Rational::from(2);
    }
    let exponent = exponent.floor().to_i64().and_then(|exponent| i32::try_from(exponent).ok());
    let exponent = exponent.unwrap_or_else(|| unreachable!("a power beyond all use"));
    let power = match exponent.abs() {
        1 => base,
        other => Formula::Power(Box::new(base), other),
    };
    Factor { inverse: exponent < 0, value: power }
}

fn number(view: AtomView<'_>) -> Formula {
    let number = Rational::try_from(view).unwrap_or_else(|_| unreachable!("numbers are rational"));
    let (above, below) = (number.numerator_ref(), number.denominator_ref());
    let value = match below.is_one() {
        true => whole(&above.abs().to_string()),
        false => Formula::Product(vec![
            Factor::times(whole(&above.abs().to_string())),
            Factor::over(whole(&below.to_string())),
        ]),
    };
    if number.is_negative() { Formula::Sum(vec![Term::minus(value)]) } else { value }
}

fn whole(digits: &str) -> Formula {
    let trimmed = digits.trim_end_matches('0');
    let exponent = (digits.len() - trimmed.len()) as i32;
    let (digits, exponent) = if trimmed.is_empty() { ("0", 0) } else { (trimmed, exponent) };
    Formula::Number(Decimal { digits: digits.into(), exponent })
}

/// Symbols are π, then the parameters, then stand-ins for definitions.
fn symbol_at(symbol: Symbol, parameters: usize) -> Formula {
    let position = symbol.get_stripped_name().strip_prefix('x').and_then(|digits| digits.parse::<usize>().ok());
    match position {
        Some(0) => Formula::Pi,
        Some(index) if index <= parameters => Formula::Parameter(index - 1),
        Some(index) => Formula::Definition(index - 1 - parameters),
        None => unreachable!("a symbol that no formula has"),
    }
}

#[cfg(test)]
mod tests {
    use super::super::enter;
    use super::*;

    #[test]
    fn formulas_come_out_with_the_values_they_went_in_with() {
        let [x, y] = [0, 1].map(Formula::Parameter);
        let call = |function, argument: &Formula| Formula::Call(function, Box::new(argument.clone()));
        let power = |base: &Formula, exponent| Formula::Power(Box::new(base.clone()), exponent);
        let sum = Formula::Sum(vec![Term::plus(x.clone()), Term::minus(power(&y, 2)), Term::plus(whole("30"))]);
        let root = call(Function::Sqrt, &sum);
        let cases = [
            whole("0"),
            Formula::Product(vec![Factor::times(whole("7")), Factor::over(whole("1200")), Factor::over(Formula::Pi)]),
            Formula::Sum(vec![Term::minus(call(Function::Sin, &x)), Term::minus(call(Function::Cos, &sum))]),
            Formula::Product(vec![Factor::over(call(Function::Tan, &y)), Factor::times(call(Function::Tan, &x))]),
            Formula::Product(vec![Factor::times(power(&root, 3)), Factor::over(power(&x, 4))]),
            call(Function::Sqrt, &call(Function::Sqrt, &root)),
            Formula::Product(vec![Factor::times(x.clone()), Factor::over(call(Function::Sqrt, &root))]),
            Formula::Product(vec![
                Factor::times(sum.clone()),
                Factor::times(Formula::Definition(0)),
                Factor::times(Formula::Sum(vec![Term::minus(x)])),
            ]),
        ];
        for case in cases {
            let same = case.clone();
            let out = enter(move |engine| {
                engine.form(&same, &[engine.definition(2, 0)]).expect("it has a value").to_formula(2)
            });
            let out = out.expect("the engine works");
            let [before, after] = [&case, &out].map(|formula| formula.evaluate(&[0.7, 1.9], &[1.3]));
            assert!((before - after).abs() <= 1e-14 * before.abs(), "{case:?} became {out:?}: {before} {after}");
        }
    }
}
