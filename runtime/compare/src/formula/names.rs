//! Formulas whose names have become positions.

use carvallo::Formula;

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Name {
    Parameter(usize),
    Definition(usize),
    Pi,
}

/// The functions of formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Sqrt,
}

/// A formula that can be evaluated.
#[derive(Clone, Debug)]
pub enum Resolved {
    Number(String),
    Name(Name),
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Resolved)>),
    /// Factors, each with whether it divides.
    Product(Vec<(bool, Resolved)>),
    Power(Box<Resolved>, i32),
    Call(Function, Box<Resolved>),
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

impl Resolved {
    /// A formula with the meanings of its names; nothing if one has none, or a function is not known.
    pub fn new(formula: &Formula, find: impl Fn(&str) -> Option<Name> + Copy) -> Option<Self> {
        let parts = |parts: &[(bool, Formula)]| {
            parts.iter().map(|(other, part)| Some((*other, Self::new(part, find)?))).collect::<Option<Vec<_>>>()
        };
        Some(match formula {
            Formula::Number(digits, None) => Self::Number(digits.clone()),
            Formula::Number(digits, Some(unit)) => {
                Self::Product(vec![(false, Self::Number(digits.clone())), (false, Self::unit(&Formula::parse(unit)?)?)])
            }
            Formula::Name(name) => Self::Name(find(name)?),
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

    /// The size of a unit, which is written as a product of powers of names.
    fn unit(formula: &Formula) -> Option<Self> {
        Some(match formula {
            Formula::Name(name) => match SIZED.iter().find(|(unit, _)| unit == name) {
                Some((_, size)) => Self::new(&Formula::parse(size)?, |name| (name == "pi").then_some(Name::Pi))?,
                None => Self::Number("1".into()),
            },
            Formula::Product(factors) => {
                let factor = |(inverse, factor): &(bool, Formula)| Some((*inverse, Self::unit(factor)?));
                Self::Product(factors.iter().map(factor).collect::<Option<_>>()?)
            }
            Formula::Power(base, exponent) => Self::Power(Box::new(Self::unit(base)?), exponent.parse().ok()?),
            Formula::Number(digits, None) => Self::Number(digits.clone()),
            _ => return None,
        })
    }
}
