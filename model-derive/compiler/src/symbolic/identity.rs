//! Whether formulas are equal for all values of the parameters.

use nanoserde::{DeBin, SerBin};
use symbolica::atom::{Atom, AtomCore, AtomView, Symbol};
use symbolica::domains::integer::Z;
use symbolica::domains::rational::{Q, Rational};
use symbolica::transcendental::{sec, tan};

use super::angles::Angles;
use super::atoms::{call_of, expanded_terms, operations};
use super::form::Form;

impl Form {
    /// Whether the formula is zero for all values of the parameters, exactly.
    ///
    /// `true` is a proof: over the rational functions of the parameters, of square roots, and of sines and cosines
    /// under sin² + cos² = 1 and the addition theorems. `false` proves nothing; formulas that would grow beyond bounds
    /// are not even looked at.
    pub fn is_zero(&self) -> bool {
        let plain = plain(&self.0);
        if expanded_terms(plain.as_view()) > MAX_TERMS {
            return false;
        }
        let quotient = plain.expand().to_rational_polynomial::<_, _, u16>(&Q, &Z, None);
        without_cosines(&quotient.numerator.to_expression().expand()).is_zero()
    }

    /// With sines in the place of squares of cosines, if that makes it shorter.
    pub fn in_sines(&self) -> Self {
        let sines = Self(without_cosines(&self.0.expand())).simplest();
        if sines.operations() < self.operations() { sines } else { self.clone() }
    }

    /// Whether the formula would grow beyond what [`Form::is_zero`] looks at.
    pub fn is_too_long(&self) -> bool {
        expanded_terms(plain(&self.0).as_view()) > MAX_TERMS
    }

    /// The sign of the number that another formula is to be multiplied by to give this one, if it is seen that there is
    /// such a number and that it is not zero.
    pub fn multiple_of(&self, other: &Self) -> Option<Sign> {
        let [one, other] = [self, other].map(|form| plain(&form.0));
        if [&one, &other].iter().any(|form| expanded_terms(form.as_view()) > MAX_TERMS || form.expand().is_zero()) {
            return None;
        }
        let quotient = (one / other).expand().to_rational_polynomial::<_, _, u16>(&Q, &Z, None);
        let number = quotient.numerator.to_expression() / quotient.denominator.to_expression();
        let number = Rational::try_from(number.as_view()).ok().filter(|number| !number.is_zero())?;
        Some(if number.is_negative() { Sign::Negative } else { Sign::Positive })
    }

    /// Whether the symbol of `other` occurs.
    pub fn mentions(&self, other: &Self) -> bool {
        matches!(other.0.as_view(), AtomView::Var(symbol) if self.0.contains_symbol(symbol.get_symbol()))
    }

    /// With a formula in the place of the symbol `name`.
    pub fn replace(&self, name: &Self, value: &Self) -> Self {
        Self(self.0.replace(name.0.to_pattern()).with(value.0.to_pattern()))
    }
}

/// An expanded formula, expanded again with 1 - sin² in the place of each cos².
fn without_cosines(expanded: &Atom) -> Atom {
    let replaced = expanded.replace_map_bottom_up(|view, _, out| {
        let AtomView::Pow(power) = view else { return };
        let (base, exponent) = power.get_base_exp();
        let exponent = i64::try_from(exponent).unwrap_or(0);
        if let Some(argument) = call_of(base, Symbol::COS)
            && exponent >= 2
        {
            let sine = Atom::num(1) - argument.sin().pow(2);
            **out = sine.pow(exponent / 2) * argument.cos().pow(exponent % 2);
        }
    });
    replaced.expand()
}

/// The sign of a number that is not zero.
#[derive(Clone, Copy, Debug, DeBin, PartialEq, Eq, SerBin)]
pub enum Sign {
    /// Above zero.
    Positive,
    /// Below zero.
    Negative,
}

/// Formulas that could expand into more terms than this are not looked at: their proof could take longer than anyone
/// waits.
const MAX_TERMS: f64 = 5_000.0;

/// Arguments with more operations stay as they are: each tangent of a tangent would at least double them.
const MAX_ARGUMENT: usize = 100;

/// In sines and cosines of single angles, and in whole powers and roots.
fn plain(atom: &Atom) -> Atom {
    let angles = Angles::of(atom);
    atom.replace_map_bottom_up(|view, _, out| {
        let argument = |function| call_of(view, function).filter(|argument| operations(argument) <= MAX_ARGUMENT);
        let call = |function| argument(function).map(|argument| angles.sine_and_cosine(&argument));
        if let Some((sine, _)) = call(Symbol::SIN) {
            **out = sine;
        } else if let Some((_, cosine)) = call(Symbol::COS) {
            **out = cosine;
        } else if let Some((sine, cosine)) = call(tan()) {
            **out = sine / cosine;
        } else if let Some((_, cosine)) = call(sec()) {
            **out = cosine.pow(-1);
        } else if let Some((base, whole, rest)) = fractional_power(view) {
            **out = base.pow(whole) * base.pow(Atom::num(rest));
        }
    })
}

/// Base, whole part and fraction of a power that is not a whole one.
fn fractional_power(view: AtomView<'_>) -> Option<(Atom, i64, Rational)> {
    let AtomView::Pow(power) = view else { return None };
    let (base, exponent) = power.get_base_exp();
    let exponent = Rational::try_from(exponent).ok().filter(|exponent| !exponent.is_integer())?;
    let whole = exponent.floor().to_i64()?;
    let rest = exponent - Rational::from(whole);
    Some((base.to_owned(), whole, rest))
}
