//! Formulas inside the engine, and what the compiler asks of them.

use symbolica::atom::{Atom, AtomCore, AtomView};
use symbolica::transcendental::{sec, tan};

use super::atoms::{call_of, expanded_terms, operations, parameter};
use super::failure::Undefined;

/// A formula in the parameters, in the engine's own form.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Form(pub(super) Atom);

impl Form {
    pub(super) fn power(&self, exponent: i32) -> Result<Atom, Undefined> {
        // The engine would go on with infinity, or with an indeterminate number.
        if exponent <= 0 && self.is_zero() {
            return Err(Undefined::DivisionByZero);
        }
        Ok(self.0.pow(i64::from(exponent)))
    }

    /// Whether it is a number, a parameter or a stand-in: nothing that would be worth a name.
    pub(super) fn is_trivial(&self) -> bool {
        matches!(self.0.as_view(), AtomView::Num(_) | AtomView::Var(_))
    }

    /// The partial derivative with respect to a parameter.
    pub fn derivative(&self, index: usize) -> Self {
        Self(self.0.derivative(parameter(index)))
    }

    /// This less another formula.
    pub fn minus(&self, other: &Self) -> Self {
        Self(&self.0 - &other.0)
    }

    /// The one of several equivalent forms that takes the fewest operations.
    ///
    /// Long formulas stay as they are: rewriting them could take longer than anyone waits.
    pub fn simplest(&self) -> Self {
        let atom = &self.0;
        if self.operations() > MAX_REWRITTEN || expanded_terms(atom.as_view()) > MAX_EXPANDED {
            return self.clone();
        }
        // One operation cannot become fewer.
        if self.operations() <= 1 {
            return self.clone();
        }
        let mut forms = vec![atom.clone(), atom.collect_factors()];
        let expanded = atom.expand();
        // Most formulas of mechanisms are expanded as they stand.
        if expanded != *atom {
            forms.push(expanded.collect_factors());
        }
        forms.push(atom.factor());
        if atom.count_operations().inversions > 0 {
            forms.push(atom.together());
        }
        let best = forms.into_iter().map(Self).min_by_key(Self::cost);
        best.unwrap_or_else(|| self.clone())
    }

    /// With sines and cosines in the place of the tangents of numbers, of which the engine's evaluator makes 0.
    pub(super) fn without_tangents_of_numbers(&self) -> Self {
        let is_number = |argument: &Atom| matches!(argument.as_view(), AtomView::Num(_));
        Self(self.0.replace_map_bottom_up(|view, _, out| {
            if let Some(number) = call_of(view, tan()).filter(is_number) {
                **out = number.sin() / number.cos();
            } else if let Some(number) = call_of(view, sec()).filter(is_number) {
                **out = number.cos().pow(-1);
            }
        }))
    }

    /// The number of operations that the formula takes as it stands.
    pub fn operations(&self) -> usize {
        operations(&self.0)
    }

    fn cost(&self) -> usize {
        let count = self.0.count_operations();
        count.additions + count.multiplications + 4 * count.inversions + 20 * count.function_calls
    }
}

/// Formulas with more operations than this are not rewritten.
const MAX_REWRITTEN: usize = 50;

/// Formulas that could expand into more terms than this are not rewritten, such as fractions in fractions in fractions.
const MAX_EXPANDED: f64 = 500.0;

#[cfg(test)]
mod tests {
    use super::super::enter;
    use super::*;
    use crate::formula::{Decimal, Factor, Formula, Function, Term};

    fn number(value: &str) -> Formula {
        Formula::Number(Decimal { digits: value.into(), exponent: 0 })
    }

    fn call(function: Function, index: usize) -> Formula {
        Formula::Call(function, Box::new(Formula::Parameter(index)))
    }

    fn power(base: Formula, exponent: i32) -> Formula {
        Formula::Power(Box::new(base), exponent)
    }

    /// Runs a check of formulas in x = parameter 0 and y = parameter 1.
    fn check(name: &'static str, test: impl FnOnce(&dyn Fn(&Formula) -> Form) -> bool + Send + 'static) {
        let holds = enter(|engine| test(&|formula| engine.form(formula, &[]).expect("it has a value")))
            .expect("the engine works");
        assert!(holds, "{name}");
    }

    #[test]
    fn identities_are_proved() {
        check("sin^2 + cos^2 = 1", |form| {
            let squares = [call(Function::Sin, 0), call(Function::Cos, 0)].map(|f| Term::plus(power(f, 2)));
            let one = Term::minus(number("1"));
            form(&Formula::Sum(squares.into_iter().chain([one]).collect())).is_zero()
        });
        check("tan cos = sin", |form| {
            let product =
                Formula::Product(vec![Factor::times(call(Function::Tan, 0)), Factor::times(call(Function::Cos, 0))]);
            form(&Formula::Sum(vec![Term::plus(product), Term::minus(call(Function::Sin, 0))])).is_zero()
        });
        check("sqrt(x)^3 / x = sqrt(x)", |form| {
            let root = call(Function::Sqrt, 0);
            let quotient =
                Formula::Product(vec![Factor::times(power(root.clone(), 3)), Factor::over(Formula::Parameter(0))]);
            form(&Formula::Sum(vec![Term::plus(quotient), Term::minus(root)])).is_zero()
        });
        check("1/x + 1/y = (x + y)/(x y)", |form| {
            let [x, y] = [0, 1].map(Formula::Parameter);
            let left = [x.clone(), y.clone()].map(|p| Term::plus(power(p, -1)));
            let sum = Formula::Sum(vec![Term::plus(x.clone()), Term::plus(y.clone())]);
            let right = Formula::Product(vec![Factor::times(sum), Factor::over(x), Factor::over(y)]);
            form(&Formula::Sum(left.into_iter().chain([Term::minus(right)]).collect())).is_zero()
        });
    }

    #[test]
    fn formulas_without_a_value_are_refused() {
        let zero = || Formula::Sum(vec![Term::plus(Formula::Parameter(0)), Term::minus(Formula::Parameter(0))]);
        let squares = [call(Function::Sin, 0), call(Function::Cos, 0)].map(|f| Term::plus(power(f, 2)));
        let hidden = Formula::Sum(squares.into_iter().chain([Term::minus(number("1"))]).collect());
        let negative = Formula::Sum(vec![Term::minus(number("4"))]);
        let cases = [
            (
                Formula::Product(vec![Factor::times(Formula::Parameter(1)), Factor::over(zero())]),
                Undefined::DivisionByZero,
            ),
            (power(hidden, -2), Undefined::DivisionByZero),
            (power(zero(), 0), Undefined::DivisionByZero),
            (Formula::Call(Function::Sqrt, Box::new(negative)), Undefined::RootOfNegative),
        ];
        for (formula, expected) in cases {
            let found = enter(move |engine| engine.form(&formula, &[]).err()).expect("the engine works");
            assert_eq!(found, Some(expected));
        }
    }

    #[test]
    fn what_is_not_zero_is_not_proved() {
        check("sin^2 is not 0", |form| !form(&power(call(Function::Sin, 0), 2)).is_zero());
        check("sin x - sin y is not 0", |form| {
            !form(&Formula::Sum(vec![Term::plus(call(Function::Sin, 0)), Term::minus(call(Function::Sin, 1))]))
                .is_zero()
        });
    }

    #[test]
    fn derivatives_and_substitutions_follow_the_rules() {
        check("d(x^2 sin y)/dx = 2 x sin y", |form| {
            let sine = call(Function::Sin, 1);
            let product =
                Formula::Product(vec![Factor::times(power(Formula::Parameter(0), 2)), Factor::times(sine.clone())]);
            let expected = Formula::Product(vec![
                Factor::times(number("2")),
                Factor::times(Formula::Parameter(0)),
                Factor::times(sine),
            ]);
            form(&product).derivative(0).minus(&form(&expected)).is_zero()
        });
        check("d tan x/dx = 1 + tan^2 x", |form| {
            let tangent = call(Function::Tan, 0);
            let expected = Formula::Sum(vec![Term::plus(number("1")), Term::plus(power(tangent.clone(), 2))]);
            form(&tangent).derivative(0).minus(&form(&expected)).is_zero()
        });
        check("x^2 at x = 3 is 9", |form| {
            let x = Formula::Parameter(0);
            let nine = form(&power(x.clone(), 2)).replace(&form(&x), &form(&number("3")));
            nine.minus(&form(&number("9"))).is_zero()
        });
    }

    #[test]
    fn the_simplest_form_is_equal_and_not_longer() {
        check("x y + x", |form| {
            let [x, y] = [0, 1].map(Formula::Parameter);
            let product = Formula::Product(vec![Factor::times(x.clone()), Factor::times(y)]);
            let long = form(&Formula::Sum(vec![Term::plus(product), Term::plus(x)]));
            let short = long.simplest();
            short.minus(&long).is_zero() && short.0.count_operations().multiplications == 1
        });
    }
}
