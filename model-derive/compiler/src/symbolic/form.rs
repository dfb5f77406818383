//! Formulas inside the engine, and the algebra that the compiler asks of it.

use symbolica::atom::{Atom, AtomCore, AtomView, Symbol};
use symbolica::domains::integer::Z;
use symbolica::domains::rational::{Q, Rational};
use symbolica::symbol;
use symbolica::transcendental::{TranscendentalFunctions, tan};

use crate::model::{Expr, Function};
use crate::syntax::Decimal;

/// The engine, as long as its thread lives. Only the door makes one.
///
/// Symbols live as long as the process, and their order can matter. So parameters have neutral names, made in the same
/// order for every model: a user's `e`, `pi` or `I` cannot collide, and a model before this one changes nothing.
#[derive(Debug)]
pub struct Engine(());

/// A formula in the parameters, in the engine's own form.
#[derive(Clone, Debug, PartialEq)]
pub struct Form(pub(super) Atom);

impl Engine {
    pub(super) fn start() -> Self {
        Self(())
    }

    /// The parameter at a position.
    pub fn parameter(&self, index: usize) -> Form {
        Form(parameter(index).to_atom())
    }

    /// A stand-in for the value of the definition at a position.
    pub(super) fn definition(&self, index: usize) -> Form {
        Form(symbol!(format!("carvallo::d{index}")).to_atom())
    }

    /// The number π, as a symbol: the engine's own would become a floating-point number on export.
    pub(super) fn pi(&self) -> Form {
        Form(symbol!("carvallo::pi").to_atom())
    }

    /// A formula, with the given values of its definitions.
    pub fn form(&self, expr: &Expr, definitions: &[Form]) -> Form {
        let inner = |expr: &Expr| self.form(expr, definitions).0;
        Form(match expr {
            Expr::Number(number) => decimal(number),
            Expr::Pi => self.pi().0,
            Expr::Parameter(index) => self.parameter(*index).0,
            Expr::Definition(index) => definitions[*index].0.clone(),
            Expr::Sum(terms) => Atom::add_many(terms.iter().map(|(negative, term)| {
                let term = inner(term);
                if *negative { -term } else { term }
            })),
            Expr::Product(factors) => Atom::mul_many(factors.iter().map(|(inverse, factor)| {
                let factor = inner(factor);
                if *inverse { factor.pow(-1) } else { factor }
            })),
            Expr::Power(base, exponent) => inner(base).pow(i64::from(*exponent)),
            Expr::Call(Function::Sin, argument) => inner(argument).sin(),
            Expr::Call(Function::Cos, argument) => inner(argument).cos(),
            Expr::Call(Function::Tan, argument) => inner(argument).tan(),
            Expr::Call(Function::Sqrt, argument) => inner(argument).sqrt(),
        })
    }
}

fn parameter(index: usize) -> Symbol {
    symbol!(format!("carvallo::p{index}"))
}

fn decimal(number: &Decimal) -> Atom {
    symbolica::parse!(&number.digits) * Atom::num(10).pow(i64::from(number.exponent))
}

impl Form {
    /// The partial derivative with respect to a parameter.
    pub fn derivative(&self, index: usize) -> Self {
        Self(self.0.derivative(parameter(index)))
    }

    /// With a formula in the place of a parameter.
    pub fn substitute(&self, index: usize, value: &Self) -> Self {
        Self(self.0.replace(parameter(index)).with(value.0.clone()))
    }

    /// The sum of this and another formula.
    pub fn plus(&self, other: &Self) -> Self {
        Self(&self.0 + &other.0)
    }

    /// This less another formula.
    pub fn minus(&self, other: &Self) -> Self {
        Self(&self.0 - &other.0)
    }

    /// Whether the formula is zero for all values of the parameters, exactly.
    ///
    /// `true` is a proof: over the rational functions of the parameters, of square roots, and of sines and cosines
    /// under sin² + cos² = 1. Formulas that are zero only by an addition theorem are not recognized.
    pub fn is_zero(&self) -> bool {
        let plain = self.0.expand().replace_map_bottom_up(|view, _, out| {
            if let Some(argument) = call_of(view, tan()) {
                **out = argument.sin() / argument.cos();
            } else if let Some((base, whole, rest)) = fractional_power(view) {
                **out = base.pow(whole) * base.pow(Atom::num(rest));
            }
        });
        let quotient = plain.to_rational_polynomial::<_, _, u16>(&Q, &Z, None);
        let numerator = quotient.numerator.to_expression().expand();
        let reduced = numerator.replace_map_bottom_up(|view, _, out| {
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
        reduced.expand().is_zero()
    }

    /// The one of several equivalent forms that takes the fewest operations.
    pub fn simplest(&self) -> Self {
        let atom = &self.0;
        let forms = [atom.clone(), atom.collect_factors(), atom.expand().collect_factors(), atom.factor(), atom.together()];
        let operations = |form: &Atom| {
            let count = form.count_operations();
            count.additions + count.multiplications + 4 * count.inversions + 20 * count.function_calls
        };
        let best = forms.into_iter().min_by_key(operations);
        Self(best.unwrap_or_else(|| atom.clone()))
    }
}

/// The argument, if `view` is a call of `function`.
fn call_of(view: AtomView<'_>, function: Symbol) -> Option<Atom> {
    let AtomView::Fun(call) = view else { return None };
    let argument = call.iter().next().filter(|_| call.get_symbol() == function)?;
    Some(argument.to_owned())
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
