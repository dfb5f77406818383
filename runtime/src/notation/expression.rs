//! Formulas whose names have become positions, and their values. This is no computer algebra: nothing is rearranged.

use std::f64::consts::PI;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::formula::Formula;

/// A formula in parameters and definitions, which are known by their positions, to be [evaluated](Self::evaluate).
///
/// Available with feature `std`.
///
/// ```
/// use carvallo::{Expression, Formula};
///
/// let find = |name: &str| (name == "l").then_some(Expression::Parameter(0));
/// let square = Expression::new(&Formula::parse("2*l^2").unwrap(), &find).unwrap();
/// assert_eq!(square.evaluate(&[3.0], &[]), Some(18.0));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A decimal, and the double that is nearest to it.
    Number(String, f64),
    /// The number pi.
    Pi,
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

/// The functions of formulas.
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

/// What formulas are evaluated in.
pub trait FormulaNumber:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// A decimal, of which the nearest double is known.
    fn decimal(digits: &str, nearest: f64) -> Self;
    /// The number pi.
    fn pi() -> Self;
    /// A function of it.
    fn call(self, function: Function) -> Self;
    /// Its sign: -1, 0 or 1; 0 of what is no number.
    fn sign(self) -> i8;
}

impl FormulaNumber for f64 {
    fn decimal(_: &str, nearest: f64) -> Self {
        nearest
    }

    fn pi() -> Self {
        PI
    }

    fn call(self, function: Function) -> Self {
        match function {
            Function::Sin => self.sin(),
            Function::Cos => self.cos(),
            Function::Tan => self.tan(),
            Function::Sqrt => self.sqrt(),
        }
    }

    fn sign(self) -> i8 {
        i8::from(self > 0.0) - i8::from(self < 0.0)
    }
}

/// The units that are no SI units without a prefix, and their sizes in kg, m, s and rad.
const SIZED: [(&str, &str); 11] = [
    ("deg", "pi/180"),
    ("g", "0.001"),
    ("t", "1000"),
    ("mm", "0.001"),
    ("cm", "0.01"),
    ("km", "1000"),
    ("ms", "0.001"),
    ("min", "60"),
    ("h", "3600"),
    ("kN", "1000"),
    ("kPa", "1000"),
];

impl Expression {
    /// A formula with the meanings of its names, of which pi need not be one; nothing if another has none, or a function is not
    /// known.
    pub fn new(formula: &Formula, find: &dyn Fn(&str) -> Option<Self>) -> Option<Self> {
        let parts = |parts: &[(bool, Formula)]| {
            parts.iter().map(|(other, part)| Some((*other, Self::new(part, find)?))).collect::<Option<Vec<_>>>()
        };
        Some(match formula {
            Formula::Number(digits, None) => Self::decimal(digits)?,
            Formula::Number(digits, Some(unit)) => {
                Self::Product(vec![(false, Self::decimal(digits)?), (false, Self::unit(&Formula::parse(unit)?)?)])
            }
            Formula::Name(name) => find(name).or((name == "pi").then_some(Self::Pi))?,
            Formula::Sum(terms) => Self::Sum(parts(terms)?),
            Formula::Product(factors) => Self::Product(parts(factors)?),
            Formula::Power(base, exponent) => Self::Power(Box::new(Self::new(base, find)?), exponent.parse().ok()?),
            Formula::Call(function, argument) => {
                let function = match function.as_str() {
                    "sin" => Function::Sin,
                    "cos" => Function::Cos,
                    "tan" => Function::Tan,
                    "sqrt" => Function::Sqrt,
                    _ => return None,
                };
                Self::Call(function, Box::new(Self::new(argument, find)?))
            }
        })
    }

    fn decimal(digits: &str) -> Option<Self> {
        Some(Self::Number(digits.to_owned(), digits.parse().ok()?))
    }

    /// The size of a unit, which is written as a product of powers of names.
    fn unit(formula: &Formula) -> Option<Self> {
        Some(match formula {
            Formula::Name(name) => match SIZED.iter().find(|(unit, _)| unit == name) {
                Some((_, size)) => Self::new(&Formula::parse(size)?, &|_| None)?,
                None => Self::decimal("1")?,
            },
            Formula::Product(factors) => {
                let factor = |(inverse, factor): &(bool, Formula)| Some((*inverse, Self::unit(factor)?));
                Self::Product(factors.iter().map(factor).collect::<Option<_>>()?)
            }
            Formula::Power(base, exponent) => Self::Power(Box::new(Self::unit(base)?), exponent.parse().ok()?),
            Formula::Number(digits, None) => Self::decimal(digits)?,
            _ => return None,
        })
    }

    /// The value at parameters and definitions; nothing where it has none, as a quotient whose divisor is zero.
    ///
    /// # Panics
    /// If there is no parameter or definition at a position.
    pub fn evaluate<T: FormulaNumber>(&self, parameters: &[T], definitions: &[T]) -> Option<T> {
        let value = |formula: &Self| formula.evaluate(parameters, definitions);
        match self {
            Self::Number(digits, nearest) => Some(T::decimal(digits, *nearest)),
            Self::Pi => Some(T::pi()),
            Self::Parameter(position) => Some(parameters[*position]),
            Self::Definition(position) => Some(definitions[*position]),
            Self::Sum(terms) => {
                let mut sum: Option<T> = None;
                for (negative, term) in terms {
                    let term = value(term)?;
                    sum = Some(match (sum, negative) {
                        (None, false) => term,
                        (None, true) => -term,
                        (Some(sum), false) => sum + term,
                        (Some(sum), true) => sum - term,
                    });
                }
                sum
            }
            Self::Product(factors) => {
                let mut product: Option<T> = None;
                for (inverse, factor) in factors {
                    let factor = value(factor)?;
                    product = Some(match (product, inverse) {
                        (None, false) => factor,
                        (None, true) => quotient(one(), factor)?,
                        (Some(product), false) => product * factor,
                        (Some(product), true) => quotient(product, factor)?,
                    });
                }
                product
            }
            Self::Power(base, exponent) => {
                let base = value(base)?;
                let power = (1..exponent.unsigned_abs()).fold(base, |power, _| power * base);
                match exponent {
                    0 => Some(one()),
                    ..0 => quotient(one(), power),
                    _ => Some(power),
                }
            }
            Self::Call(function, argument) => {
                let argument = value(argument)?;
                (*function != Function::Sqrt || argument.sign() >= 0).then(|| argument.call(*function))
            }
        }
    }

    /// Tells each of the definitions that it uses.
    pub fn each_definition(&self, tell: &mut dyn FnMut(usize)) {
        match self {
            Self::Number(..) | Self::Pi | Self::Parameter(_) => {}
            Self::Definition(position) => tell(*position),
            Self::Sum(parts) | Self::Product(parts) => parts.iter().for_each(|(_, part)| part.each_definition(tell)),
            Self::Power(inner, _) | Self::Call(_, inner) => inner.each_definition(tell),
        }
    }
}

fn one<T: FormulaNumber>() -> T {
    T::decimal("1", 1.0)
}

fn quotient<T: FormulaNumber>(dividend: T, divisor: T) -> Option<T> {
    (divisor.sign() != 0).then(|| dividend / divisor)
}
