//! Formulas with their values: the second way to what the compiler makes of them.

use std::fmt;

/// A formula in quantities that are numbered: parameters, then definitions.
#[derive(Clone)]
pub enum Formula {
    Name(usize),
    Number(&'static str),
    Sum(Box<[Formula; 2]>),
    Difference(Box<[Formula; 2]>),
    Product(Box<[Formula; 2]>),
    Quotient(Box<[Formula; 2]>),
    Power(Box<Formula>, i32),
    Call(&'static str, Box<Formula>),
}

impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Name(index) => write!(f, "a{index}"),
            Self::Number(number) => f.write_str(number),
            Self::Sum(parts) => write!(f, "({} + {})", parts[0], parts[1]),
            Self::Difference(parts) => write!(f, "({} - {})", parts[0], parts[1]),
            Self::Product(parts) => write!(f, "{}*{}", parts[0], parts[1]),
            Self::Quotient(parts) => write!(f, "({})/({})", parts[0], parts[1]),
            Self::Power(base, exponent) => write!(f, "({base})^{exponent}"),
            Self::Call(function, argument) => write!(f, "{function}({argument})"),
        }
    }
}

/// A value, and how far rounding may have taken it.
#[derive(Clone, Copy, Debug)]
pub struct Rounded {
    pub value: f64,
    pub error: f64,
}

impl Rounded {
    pub fn new(value: f64) -> Self {
        Self { value, error: value.abs() * f64::EPSILON }
    }

    fn after(value: f64, error: f64) -> Self {
        Self { value, error: error + value.abs() * f64::EPSILON }
    }
}

impl Formula {
    pub fn value(&self, names: &[Rounded]) -> Rounded {
        let both = |parts: &[Formula; 2]| (parts[0].value(names), parts[1].value(names));
        match self {
            Self::Name(index) => names[*index],
            Self::Number("pi") => Rounded::new(std::f64::consts::PI),
            Self::Number(number) => Rounded::new(number.parse().expect("a number")),
            Self::Sum(parts) => {
                let (a, b) = both(parts);
                Rounded::after(a.value + b.value, a.error + b.error)
            }
            Self::Difference(parts) => {
                let (a, b) = both(parts);
                Rounded::after(a.value - b.value, a.error + b.error)
            }
            Self::Product(parts) => {
                let (a, b) = both(parts);
                Rounded::after(a.value * b.value, a.error * b.value.abs() + b.error * a.value.abs())
            }
            Self::Quotient(parts) => {
                let (a, b) = both(parts);
                let value = a.value / b.value;
                Rounded::after(value, (a.error + value.abs() * b.error) / b.value.abs())
            }
            Self::Power(base, exponent) => {
                let base = base.value(names);
                let slope = f64::from(*exponent) * base.value.powi(exponent - 1);
                Rounded::after(
                    base.value.powi(*exponent),
                    if *exponent == 0 { 0.0 } else { (slope * base.error).abs() },
                )
            }
            Self::Call(function, argument) => {
                let x = argument.value(names);
                let (value, slope) = match *function {
                    "sin" => (x.value.sin(), 1.0),
                    "cos" => (x.value.cos(), 1.0),
                    "tan" => (x.value.tan(), 1.0 + x.value.tan().powi(2)),
                    // Of -0 the root is -0, and the slope is not.
                    "sqrt" => (x.value.sqrt(), 0.5 / x.value.sqrt().abs()),
                    _ => (-x.value, 1.0),
                };
                Rounded::after(value, slope * x.error)
            }
        }
    }
}
