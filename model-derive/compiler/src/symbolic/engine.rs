//! The engine, its symbols, and formulas on their way into it.

use std::sync::atomic::Ordering;

use symbolica::atom::{Atom, AtomCore};
use symbolica::domains::rational::Rational;
use symbolica::transcendental::TranscendentalFunctions;

use super::atoms::{parameter, pi, symbol_at};
use super::failure::Undefined;
use super::form::Form;
use crate::formula::{Algebra, Decimal, Factor, Formula, Function, Term, Values};

/// The engine, as long as its thread lives. Only the door makes one.
///
/// Symbols live as long as the process, and the engine sorts by their age. So all formulas use one sequence of neutral
/// names, always made from its start: a user's `e`, `pi` or `I` cannot collide, and a model before changes nothing.
#[derive(Debug)]
pub struct Engine(());

/// Symbols that are made at the start, so that only larger models make more, and those in their order.
const READY: usize = 64;

impl Engine {
    pub(super) fn start() -> Self {
        // The engine's log would mix with the messages of the build.
        symbolica::GLOBAL_SETTINGS.initialize_tracing.store(false, Ordering::Relaxed);
        (0..READY).for_each(|index| {
            symbol_at(index);
        });
        Self(())
    }

    /// The number π, as a symbol: the engine's own would become a floating-point number on export.
    pub(super) fn pi(&self) -> Form {
        Form(pi())
    }

    /// The parameter at a position.
    pub fn parameter(&self, index: usize) -> Form {
        Form(parameter(index).to_atom())
    }

    /// The stand-in for the value of a definition, behind so many parameters.
    pub fn definition(&self, parameters: usize, index: usize) -> Form {
        Form(symbol_at(parameters + 1 + index).to_atom())
    }

    /// Stand-ins for the values of definitions, behind so many parameters.
    pub(super) fn definitions(&self, parameters: usize, count: usize) -> Vec<Form> {
        let all: Vec<Form> = (0..=parameters + count).map(|index| Form(symbol_at(index).to_atom())).collect();
        all[parameters + 1..].to_vec()
    }

    /// A formula, with the given values of its definitions.
    ///
    /// # Errors
    /// If it has no value for any parameters.
    pub fn form(&self, formula: &Formula, definitions: &[Form]) -> Result<Form, Undefined> {
        formula.fold(&Forms { engine: self, definitions })
    }
}

/// Forms of the engine, with the given values of definitions.
struct Forms<'a> {
    engine: &'a Engine,
    definitions: &'a [Form],
}

impl Algebra for Forms<'_> {
    type Value = Form;
    type Error = Undefined;

    fn number(&self, number: &Decimal) -> Result<Form, Undefined> {
        Ok(Form(decimal(number)))
    }

    fn pi(&self) -> Form {
        self.engine.pi()
    }

    fn parameter(&self, index: usize) -> Form {
        self.engine.parameter(index)
    }

    fn definition(&self, index: usize) -> Form {
        self.definitions[index].clone()
    }

    fn sum(&self, terms: impl Values<Term<Form>, Undefined>) -> Result<Form, Undefined> {
        let terms = terms.map(|term| {
            let Term { negative, value: Form(term) } = term?;
            Ok(if negative { -term } else { term })
        });
        Ok(Form(Atom::add_many(terms.collect::<Result<Vec<_>, _>>()?)))
    }

    fn product(&self, factors: impl Values<Factor<Form>, Undefined>) -> Result<Form, Undefined> {
        let factors = factors.map(|factor| {
            let Factor { inverse, value } = factor?;
            if inverse { value.power(-1) } else { Ok(value.0) }
        });
        Ok(Form(Atom::mul_many(factors.collect::<Result<Vec<_>, _>>()?)))
    }

    fn power(&self, base: Form, exponent: i32) -> Result<Form, Undefined> {
        base.power(exponent).map(Form)
    }

    fn call(&self, function: Function, Form(argument): Form) -> Result<Form, Undefined> {
        Ok(Form(match function {
            Function::Sin => argument.sin(),
            Function::Cos => argument.cos(),
            Function::Tan => argument.tan(),
            Function::Sqrt => {
                if Rational::try_from(argument.as_view()).is_ok_and(|number| number.is_negative()) {
                    return Err(Undefined::RootOfNegative);
                }
                argument.sqrt()
            }
        }))
    }
}

fn decimal(number: &Decimal) -> Atom {
    // Most numbers are short, and need no parser.
    let digits = match number.digits.parse::<i64>() {
        Ok(digits) => Atom::num(digits),
        Err(_) => symbolica::parse!(&number.digits),
    };
    if number.exponent == 0 { digits } else { digits * Atom::num(10).pow(i64::from(number.exponent)) }
}
