//! A formula with its names resolved, and its value. This is no computer algebra: nothing is rearranged.

use carvallo::Formula;

/// A formula in parameters and definitions, which are known by their positions.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A number.
    Number(f64),
    /// The parameter at this position.
    Parameter(usize),
    /// The definition at this position.
    Definition(usize),
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Expression)>),
    /// Factors, each with whether it divides.
    Product(Vec<(bool, Expression)>),
    /// A whole power.
    Power(Box<Expression>, i32),
    /// A function of an argument.
    Call(Function, Box<Expression>),
}

/// The functions that formulas may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Square root.
    Sqrt,
}

impl Function {
    fn called(name: &str) -> Option<Self> {
        Some(match name {
            "sin" => Self::Sin,
            "cos" => Self::Cos,
            "tan" => Self::Tan,
            "sqrt" => Self::Sqrt,
            _ => return None,
        })
    }

    fn of(self, argument: f64) -> f64 {
        match self {
            Self::Sin => argument.sin(),
            Self::Cos => argument.cos(),
            Self::Tan => argument.tan(),
            Self::Sqrt => argument.sqrt(),
        }
    }
}

impl Expression {
    /// The formula of a text; `name` knows what a name stands for. `None` if it is none.
    pub fn parse(text: &str, name: &dyn Fn(&str) -> Option<Self>) -> Option<Self> {
        Self::of(&Formula::parse(text)?, name)
    }

    fn of(formula: &Formula, name: &dyn Fn(&str) -> Option<Self>) -> Option<Self> {
        let parts = |parts: &[(bool, Formula)]| {
            parts.iter().map(|(other, part)| Some((*other, Self::of(part, name)?))).collect::<Option<Vec<_>>>()
        };
        Some(match formula {
            Formula::Number(_, Some(_)) => return None,
            Formula::Number(digits, None) => Self::Number(digits.parse().ok()?),
            Formula::Name(own) if own == "pi" => Self::Number(std::f64::consts::PI),
            Formula::Name(own) => name(own)?,
            Formula::Sum(terms) => Self::Sum(parts(terms)?),
            Formula::Product(factors) => Self::Product(parts(factors)?),
            Formula::Power(base, exponent) => Self::Power(Box::new(Self::of(base, name)?), exponent.parse().ok()?),
            Formula::Call(function, argument) => {
                Self::Call(Function::called(function)?, Box::new(Self::of(argument, name)?))
            }
        })
    }

    /// Its value; not finite where it has none.
    pub fn value(&self, parameters: &[f64], definitions: &[f64]) -> f64 {
        match self {
            Self::Number(value) => *value,
            Self::Parameter(position) => parameters[*position],
            Self::Definition(position) => definitions[*position],
            Self::Sum(terms) => terms.iter().fold(0.0, |sum, (negative, term)| {
                let value = term.value(parameters, definitions);
                if *negative { sum - value } else { sum + value }
            }),
            Self::Product(factors) => factors.iter().fold(1.0, |product, (inverse, factor)| {
                let value = factor.value(parameters, definitions);
                if *inverse { product / value } else { product * value }
            }),
            Self::Power(base, exponent) => base.value(parameters, definitions).powi(*exponent),
            Self::Call(function, argument) => function.of(argument.value(parameters, definitions)),
        }
    }

    /// Tells each of the definitions that it uses.
    pub fn each_definition(&self, tell: &mut dyn FnMut(usize)) {
        match self {
            Self::Number(_) | Self::Parameter(_) => {}
            Self::Definition(position) => tell(*position),
            Self::Sum(parts) | Self::Product(parts) => parts.iter().for_each(|(_, part)| part.each_definition(tell)),
            Self::Power(inner, _) | Self::Call(_, inner) => inner.each_definition(tell),
        }
    }
}
