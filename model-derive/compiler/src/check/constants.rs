//! Constant expressions, such as `pi/10`, evaluated far beyond double precision.

use astro_float::{BigFloat, Consts, Radix, RoundingMode};

use super::resolve::unknown_function;
use crate::report::error;
use crate::syntax::{Expression, Kind};

/// Bits of the calculation: enough that the nearest `f64` of the result is the nearest of the exact value.
const PRECISION: usize = 320;
const ROUNDING: RoundingMode = RoundingMode::ToEven;
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
        let mut constants = Consts::new().map_err(|_| error(expression.region, "out of memory"))?;
        evaluate(expression, &mut constants).map(Self)
    }

    /// The nearest `f64`.
    ///
    /// # Errors
    /// If the value is beyond the range of `f64`, a sentence that says so.
    pub fn to_f64(&self) -> Result<f64, String> {
        let text = Consts::new().ok().and_then(|mut c| self.0.format(Radix::Dec, ROUNDING, &mut c).ok());
        let value: f64 = text.and_then(|text| text.parse().ok()).unwrap_or(f64::NAN);
        if value.is_finite() && (value != 0.0 || self.0.is_zero()) {
            Ok(value)
        } else {
            Err("beyond the range of f64: expected a magnitude between 1e-300 and 1e300".into())
        }
    }
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

fn evaluate(expression: &Expression, constants: &mut Consts) -> syn::Result<BigFloat> {
    let (p, rm) = (PRECISION, ROUNDING);
    let value = match &expression.kind {
        Kind::Number(number) => BigFloat::parse(&number.to_string(), Radix::Dec, p, rm, constants),
        Kind::Name(name) if name == "pi" => constants.pi(p, rm),
        Kind::Name(name) => {
            return Err(error(name, format!("found `{name}`: expected a constant, of numbers, `pi` and functions")));
        }
        Kind::Sum(terms) => {
            let mut sum = BigFloat::from_word(0, p);
            for term in terms {
                let value = evaluate(&term.value, constants)?;
                sum = if term.negative { sum.sub(&value, p, rm) } else { sum.add(&value, p, rm) };
            }
            sum
        }
        Kind::Product(factors) => {
            let mut product = BigFloat::from_word(1, p);
            for factor in factors {
                let value = evaluate(&factor.value, constants)?;
                product = if factor.inverse { product.div(&value, p, rm) } else { product.mul(&value, p, rm) };
            }
            product
        }
        Kind::Power(base, exponent) => {
            let power = evaluate(base, constants)?.powi(exponent.unsigned_abs() as usize, p, rm);
            if *exponent < 0 { BigFloat::from_word(1, p).div(&power, p, rm) } else { power }
        }
        Kind::Call(name, argument) => {
            let value = evaluate(argument, constants)?;
            match name.to_string().as_str() {
                "sin" => value.sin(p, rm, constants),
                "cos" => value.cos(p, rm, constants),
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
        return Err(error(expression.region, "not a finite number: expected a constant with a finite value"));
    }
    Ok(value)
}
