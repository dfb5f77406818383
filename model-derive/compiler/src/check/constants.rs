//! Constant expressions, such as `pi/10`, evaluated far beyond double precision.

use std::cell::RefCell;
use std::collections::HashMap;

use astro_float::{BigFloat, Consts, Radix, RoundingMode};

use super::resolve::unknown_function;
use super::units::{Dimension, Quantity};
use crate::formula::Function;
use crate::report::{Report, error};
use crate::syntax::{Expression, Kind, Value};

/// Bits of the calculation: enough that the nearest `f64` of the result is the nearest of the exact value.
const PRECISION: usize = 320;
const ROUNDING: RoundingMode = RoundingMode::ToEven;
/// Binary digits behind the point of a cosine that is taken for zero.
const POLE: i32 = 256;
const FUNCTIONS: [&str; 7] = ["sin", "cos", "tan", "sqrt", "asin", "acos", "atan"];

/// A finite constant.
#[derive(Clone, Debug)]
pub struct Constant(BigFloat);

impl Constant {
    /// The value of an expression without parameters.
    ///
    /// # Errors
    /// Names other than `pi`, unknown functions, and values that are not finite.
    pub fn evaluate(expression: &Expression) -> syn::Result<Self> {
        Self::evaluate_with(expression, &HashMap::new())
    }

    /// The value of a formula at given values of the names in it.
    ///
    /// # Errors
    /// As [`Constant::evaluate`], for names that have no value.
    pub fn evaluate_with(formula: &Expression, names: &HashMap<String, Self>) -> syn::Result<Self> {
        let value = with_digits(|digits| evaluate(formula, names, digits));
        value.unwrap_or_else(|| Err(error(formula.region, "out of memory"))).map(Self)
    }

    /// The value in the units of the SI, where `own` is the dimension of what has the value and, unless another is
    /// written behind it, its unit.
    ///
    /// # Errors
    /// As [`Constant::evaluate`], and units that are not known or not of that dimension.
    pub fn in_unit(value: &Value, own: Option<Dimension>) -> syn::Result<Self> {
        let Some(unit) = &value.unit else { return Self::evaluate(&value.number) };
        let quantity = Quantity::new(unit)?;
        match own {
            Some(own) if !own.same_unit(quantity.dimension) => {
                let expected =
                    if own.is_number() { "a pure number or an angle".into() } else { format!("one in {own}") };
                let message = format!("a value in `{}`: expected {expected}", unit.text);
                Err(error(unit.region, message))
            }
            _ => Self::evaluate(&quantity.formula(value.number.clone())),
        }
    }

    /// A decimal number as text; nothing if it is none.
    pub fn parse(text: &str) -> Option<Self> {
        let value = with_digits(|digits| BigFloat::parse(text, Radix::Dec, PRECISION, ROUNDING, digits))?;
        (!value.is_nan()).then_some(Self(value))
    }

    /// The size of the difference of two constants.
    pub fn distance(&self, other: &Self) -> Self {
        Self(self.0.sub(&other.0, PRECISION, ROUNDING).abs())
    }

    /// This less a product.
    pub fn minus_product(&self, one: &Self, other: &Self) -> Self {
        let product = one.0.mul(&other.0, PRECISION, ROUNDING);
        Self(self.0.sub(&product, PRECISION, ROUNDING))
    }

    /// This divided by another constant.
    pub fn over(&self, other: &Self) -> Self {
        Self(self.0.div(&other.0, PRECISION, ROUNDING))
    }

    /// Whether it is above zero by more than the rounding of a calculation with numbers of the size of `scale`.
    pub fn is_positive_beside(&self, scale: &Self) -> bool {
        let rounding = BigFloat::from_word(2, PRECISION).powi(PRECISION / 2, PRECISION, ROUNDING);
        self.0 > scale.0.abs().div(&rounding, PRECISION, ROUNDING)
    }

    /// Whether it is zero.
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }

    /// The nearest `f64`.
    ///
    /// # Errors
    /// If the value is beyond the range of `f64`, a sentence that says so.
    pub fn to_f64(&self) -> Result<f64, String> {
        let text = with_digits(|digits| self.0.format(Radix::Dec, ROUNDING, digits).ok()).flatten();
        let value: f64 = text.and_then(|text| text.parse().ok()).unwrap_or(f64::NAN);
        if value.is_finite() && (value != 0.0 || self.0.is_zero()) {
            Ok(value)
        } else {
            Err("beyond the range of f64: expected a magnitude between 1e-300 and 1e300".into())
        }
    }
}

/// Digits of π and the like. Found anew for each constant they would take most of the time of a check.
fn with_digits<T>(work: impl FnOnce(&mut Consts) -> T) -> Option<T> {
    thread_local!(static DIGITS: RefCell<Option<Consts>> = RefCell::new(Consts::new().ok()));
    DIGITS.with_borrow_mut(|digits| digits.as_mut().map(work))
}

/// Reports parts of a formula that are constant and have no finite value within the range of `f64`, and divisors that
/// are zero.
pub fn verify(expression: &Expression, report: &mut Report) {
    if !verify_parts(expression, report) {
        return;
    }
    let value = Constant::evaluate(expression)
        .and_then(|constant| constant.to_f64().map_err(|message| error(expression.region, message)));
    if let Err(error) = value {
        report.push(error);
    }
}

/// Whether all of an expression is constant; if not, its constant parts have been verified.
fn verify_parts(expression: &Expression, report: &mut Report) -> bool {
    let parts: Vec<(&Expression, bool)> = match &expression.kind {
        Kind::Number(_) => return true,
        // An unknown unit is another mistake.
        Kind::Quantity(_, unit) => return Quantity::new(unit).is_ok(),
        Kind::Name(name) => return name == "pi",
        Kind::Sum(terms) => terms.iter().map(|term| (&term.value, false)).collect(),
        Kind::Product(factors) => factors.iter().map(|factor| (&factor.value, factor.inverse)).collect(),
        Kind::Power(base, exponent) => vec![(base, *exponent < 0)],
        Kind::Call(function, argument) if Function::from_name(&function.to_string()).is_some() => {
            vec![(argument, false)]
        }
        // An unknown function is another mistake.
        Kind::Call(..) => return false,
    };
    let constant: Vec<bool> = parts.iter().map(|(part, _)| verify_parts(part, report)).collect();
    if constant.iter().all(|constant| *constant) {
        return true;
    }
    for ((part, inverse), _) in parts.iter().zip(&constant).filter(|(_, constant)| **constant) {
        match Constant::evaluate(part) {
            Ok(value) if *inverse && value.is_zero() => {
                report.error(part.region, "a division by zero: expected a divisor that is not zero");
            }
            _ => verify(part, report),
        }
    }
    if let Some(together) = together(expression, &constant) {
        verify(&together, report);
    }
    false
}

/// The constant factors or terms as one formula, if there are several: each may be in range, and all of them not.
fn together(expression: &Expression, constant: &[bool]) -> Option<Expression> {
    fn chosen<T: Clone>(parts: &[T], constant: &[bool]) -> Option<Vec<T>> {
        let chosen = parts.iter().zip(constant).filter(|(_, constant)| **constant).map(|(part, _)| part.clone());
        Some(chosen.collect::<Vec<T>>()).filter(|chosen| chosen.len() > 1)
    }
    let kind = match &expression.kind {
        Kind::Sum(terms) => Kind::Sum(chosen(terms, constant)?),
        Kind::Product(factors) => Kind::Product(chosen(factors, constant)?),
        _ => return None,
    };
    Some(Expression { kind, region: expression.region })
}

impl PartialOrd for Constant {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

impl PartialEq for Constant {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

fn evaluate(
    expression: &Expression,
    names: &HashMap<String, Constant>,
    constants: &mut Consts,
) -> syn::Result<BigFloat> {
    let (p, rm) = (PRECISION, ROUNDING);
    let value = match &expression.kind {
        Kind::Quantity(number, unit) => {
            let number = Expression { kind: Kind::Number(number.clone()), region: expression.region };
            return evaluate(&Quantity::new(unit)?.formula(number), names, constants);
        }
        Kind::Number(number) => BigFloat::parse(&number.to_string(), Radix::Dec, p, rm, constants),
        Kind::Name(name) if name == "pi" => constants.pi(p, rm),
        Kind::Name(name) => {
            if let Some(known) = names.get(&name.to_string()) {
                return Ok(known.0.clone());
            }
            return Err(error(name, format!("found `{name}`: expected a constant, of numbers, `pi` and functions")));
        }
        Kind::Sum(terms) => {
            let mut sum = BigFloat::from_word(0, p);
            for term in terms {
                let value = evaluate(&term.value, names, constants)?;
                sum = if term.negative { sum.sub(&value, p, rm) } else { sum.add(&value, p, rm) };
            }
            sum
        }
        Kind::Product(factors) => {
            let mut product = BigFloat::from_word(1, p);
            for factor in factors {
                let value = evaluate(&factor.value, names, constants)?;
                product = if factor.inverse { product.div(&value, p, rm) } else { product.mul(&value, p, rm) };
            }
            product
        }
        Kind::Power(base, exponent) => {
            let base = evaluate(base, names, constants)?;
            let power = base.powi(exponent.unsigned_abs() as usize, p, rm);
            if *exponent <= 0 && base.is_zero() {
                astro_float::NAN
            } else if *exponent < 0 {
                BigFloat::from_word(1, p).div(&power, p, rm)
            } else {
                power
            }
        }
        Kind::Call(name, argument) => {
            let value = evaluate(argument, names, constants)?;
            match name.to_string().as_str() {
                "sin" => value.sin(p, rm, constants),
                "cos" => value.cos(p, rm, constants),
                // At a pole the cosine is nothing but the rounding of π.
                "tan" if value.cos(p, rm, constants).exponent().is_some_and(|e| e < -POLE) => astro_float::NAN,
                "tan" => value.tan(p, rm, constants),
                "sqrt" => value.sqrt(p, rm),
                "asin" => value.asin(p, rm, constants),
                "acos" => value.acos(p, rm, constants),
                "atan" => value.atan(p, rm, constants),
                other => return Err(error(name, unknown_function(other, &FUNCTIONS))),
            }
        }
    };
    if value.is_nan() || value.is_inf() {
        return Err(error(expression.region, "not a real and finite number: expected a constant that has a value"));
    }
    Ok(value)
}
