//! Formulas as sums of powers of one name.

use std::collections::BTreeMap;

use nanoserde::{DeBin, SerBin};
use symbolica::atom::{Atom, AtomCore, AtomView, Symbol};
use symbolica::domains::integer::Z;
use symbolica::domains::rational::{Q, Rational};

use super::door::ask;
use super::engine::Engine;
use super::failure::{Failure, Place};
use super::form::Form;
use super::prove::MAX_OPERATIONS;
use crate::equations::Equations;
use crate::formula::Formula;

/// One term of a formula that is sorted by powers of its last parameter.
#[derive(Clone, Debug, DeBin, PartialEq, SerBin)]
pub struct PowerTerm {
    /// The exponent of the last parameter, as numerator and denominator.
    pub exponent: (i64, i64),
    /// Whether the parameter that is to be set apart is a factor of the term beside that.
    pub has_factor: bool,
    /// What multiplies them.
    pub coefficient: Formula,
}

/// What a formula is as a sum of powers of its last parameter.
#[derive(Clone, Debug, DeBin, PartialEq, SerBin)]
pub enum Sorted {
    /// Its terms, those that are not zero, with ascending exponents.
    Terms(Vec<PowerTerm>),
    /// It depends on the parameter otherwise than by powers of it.
    OtherThanPowers,
    /// It grows beyond bounds.
    TooLong,
}

/// Each output of some equations by powers of the last parameter. Definitions from the position
/// `unsteady` on may depend on it, and stand in no result. Of what does not depend on it that part is set apart which the
/// parameter `factor` multiplies.
///
/// # Errors
/// If a formula has no value, or if the engine cannot be had or stops.
pub fn sort_by_powers(equations: Equations, unsteady: usize, factor: Option<usize>) -> Result<Vec<Sorted>, Failure> {
    ask("powers", (equations, unsteady, factor), |engine, (equations, unsteady, factor)| {
        let Equations { parameters, definitions, outputs, .. } = equations;
        // Names of definitions that are steady, and the values of the others.
        let mut known = engine.definitions(*parameters, *unsteady);
        let undefined = |place: Place| move |why| Failure::Undefined { equations: 0, place, why };
        let is_too_long = |form: &Form| form.operations() > MAX_OPERATIONS || form.is_too_long();
        for (index, definition) in definitions.iter().enumerate().skip(*unsteady) {
            let value = engine.form(definition, &known).map_err(undefined(Place::Definition(index)))?;
            if is_too_long(&value) {
                return Ok(vec![Sorted::TooLong; outputs.len()]);
            }
            known.push(value);
        }
        let sort = |(index, output): (usize, &Formula)| {
            let form = engine.form(output, &known).map_err(undefined(Place::Output(index)))?;
            Ok(if is_too_long(&form) { Sorted::TooLong } else { sort_terms(engine, &form, *parameters, *factor) })
        };
        outputs.iter().enumerate().map(sort).collect()
    })
}

fn sort_terms(engine: &Engine, form: &Form, parameters: usize, factor: Option<usize>) -> Sorted {
    let Some(sorted) = form.by_powers(&engine.parameter(parameters - 1)) else { return Sorted::OtherThanPowers };
    let mut terms = Vec::new();
    for (exponent, mut coefficient) in sorted {
        let exponent = whole_parts(&exponent);
        let mut push = |has_factor: bool, form: &Form| {
            if !form.is_zero() {
                let coefficient = form.simplest().to_formula(parameters);
                terms.push(PowerTerm { exponent, has_factor, coefficient });
            }
        };
        if let Some(factor) = factor.filter(|_| exponent == (0, 1)).map(|index| engine.parameter(index))
            && let Some(powers) = coefficient.by_powers(&factor)
            && let Some(once) = powers.get(&Rational::from(1))
        {
            push(true, once);
            let others = powers.iter().filter(|(power, _)| **power != 1);
            coefficient = others.fold(Form::number(0), |sum, (power, form)| &sum + &form.times_power(&factor, power));
        }
        push(false, &coefficient);
    }
    Sorted::Terms(terms)
}

/// Numerator and denominator; those of exponents that no formula has are out of range of the parts that matter.
fn whole_parts(number: &Rational) -> (i64, i64) {
    let [above, below] = [number.numerator_ref(), number.denominator_ref()].map(|part| part.to_i64());
    (above.unwrap_or(i64::MAX), below.unwrap_or(i64::MAX))
}

impl Form {
    /// The coefficients of the powers of a name that the formula is a sum of, those that are not proved to be zero; nothing
    /// if it depends on the name otherwise.
    pub fn by_powers(&self, name: &Self) -> Option<BTreeMap<Rational, Self>> {
        let AtomView::Var(symbol) = name.0.as_view() else { return None };
        let symbol = symbol.get_symbol();
        // Products stay as they are written where they can; a common denominator is the last resort.
        let expanded = self.0.expand_in(symbol);
        let sorted = split(&expanded, symbol).or_else(|| split(&self.0.collect_factors().expand_in(symbol), symbol));
        let sorted = sorted.or_else(|| {
            let quotient = self.0.expand().to_rational_polynomial::<_, _, u16>(&Q, &Z, None);
            let divisor = quotient.denominator.to_expression().collect_factors();
            split(&(quotient.numerator.to_expression() / divisor).expand_in(symbol), symbol)
        })?;
        Some(sorted.into_iter().map(|(power, atom)| (power, Self(atom))).filter(|(_, form)| !form.is_zero()).collect())
    }
}

impl Form {
    fn times_power(&self, base: &Self, power: &Rational) -> Self {
        Self(&self.0 * base.0.pow(Atom::num(power.clone())))
    }
}

/// The terms of a sum by the powers of a symbol that are factors of them; nothing if it stands elsewhere.
fn split(sum: &Atom, symbol: Symbol) -> Option<BTreeMap<Rational, Atom>> {
    let mut sorted: BTreeMap<Rational, Vec<Atom>> = BTreeMap::new();
    let mut add = |term: AtomView<'_>| {
        let (mut power, mut rest) = (Rational::from(0), Vec::new());
        let mut multiply = |factor: AtomView<'_>| match power_of(factor, symbol) {
            Some(exponent) => {
                power += exponent;
                true
            }
            None => {
                rest.push(factor.to_owned());
                !factor.contains_symbol(symbol)
            }
        };
        let is_plain = match term {
            AtomView::Mul(product) => product.iter().all(&mut multiply),
            factor => multiply(factor),
        };
        sorted.entry(power).or_default().push(Atom::mul_many(rest));
        is_plain
    };
    let is_sorted = match sum.as_view() {
        AtomView::Add(sum) => sum.iter().all(&mut add),
        term => add(term),
    };
    is_sorted.then(|| sorted.into_iter().map(|(power, terms)| (power, Atom::add_many(terms))).collect())
}

/// The exponent of a factor that is a power of a symbol.
fn power_of(factor: AtomView<'_>, symbol: Symbol) -> Option<Rational> {
    let is_symbol = |view: AtomView<'_>| matches!(view, AtomView::Var(found) if found.get_symbol() == symbol);
    match factor {
        AtomView::Pow(power) => {
            let (base, exponent) = power.get_base_exp();
            is_symbol(base).then(|| Rational::try_from(exponent).ok()).flatten()
        }
        _ => is_symbol(factor).then(|| Rational::from(1)),
    }
}
