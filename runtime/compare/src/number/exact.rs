//! Numbers with many bits, and the size of what they are summed from.

use std::ops::{Add, Div, Mul, Neg, Sub};

use carvallo::{FormulaNumber, Function, Number};

use super::Real;

/// A number with 320 bits, and the size of the terms that it is summed from: the value of its formula with every term made
/// positive.
///
/// The size does not change when sums are reordered or products expanded. So errors in units of it tell how well a formula
/// is arranged, and not how much of its value is lost between terms of opposite sign, which no arrangement can help.
#[derive(Clone, Copy, Debug)]
pub struct Exact {
    /// The value.
    pub value: Real,
    /// The size of its terms.
    pub size: f64,
    /// Whether it is a parameter or a constant, in which nothing is rounded.
    given: bool,
}

impl Exact {
    /// A parameter or a constant.
    #[must_use]
    pub fn given(value: Real) -> Self {
        Self { value, size: value.abs().to_f64(), given: true }
    }

    fn computed(value: Real, size: f64) -> Self {
        Self { value, size, given: false }
    }

    /// A function of this, with its derivative: what is rounded in the argument is seen in the value.
    fn through(self, value: Real, derivative: Real) -> Self {
        let argument = if self.given { 0.0 } else { self.size * derivative.abs().to_f64() };
        Self::computed(value, value.abs().to_f64() + argument)
    }
}

impl From<f64> for Exact {
    fn from(value: f64) -> Self {
        Self::given(Real::from(value))
    }
}

impl Add for Exact {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::computed(self.value + other.value, self.size + other.size)
    }
}

impl Sub for Exact {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::computed(self.value - other.value, self.size + other.size)
    }
}

impl Mul for Exact {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::computed(self.value * other.value, self.size * other.size)
    }
}

impl Div for Exact {
    type Output = Self;
    /// What is lost in the divisor is lost in the quotient.
    fn div(self, other: Self) -> Self {
        let divisor = other.value.abs().to_f64();
        Self::computed(self.value / other.value, self.size / divisor * (other.size / divisor))
    }
}

impl Neg for Exact {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl Number for Exact {
    fn like(self, value: f64) -> Self {
        Self::from(value)
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = (self.value.sin(), self.value.cos());
        (self.through(sin, cos), self.through(cos, sin))
    }
    fn sin(self) -> Self {
        self.sin_cos().0
    }
    fn cos(self) -> Self {
        self.sin_cos().1
    }
    fn tan(self) -> Self {
        let cos = self.value.cos();
        let value = self.value.sin() / cos;
        self.through(value, Real::from(1.0) / (cos * cos))
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        if root == Real::from(0.0) {
            return Self::computed(root, self.size.sqrt());
        }
        self.through(root, Real::from(0.5) / root)
    }
}

impl FormulaNumber for Exact {
    fn decimal(digits: &str, _: f64) -> Self {
        Self::given(Real::parse(digits))
    }

    fn pi() -> Self {
        Self::given(Real::pi())
    }

    fn call(self, function: Function) -> Self {
        match function {
            Function::Sin => Number::sin(self),
            Function::Cos => Number::cos(self),
            Function::Tan => Number::tan(self),
            Function::Sqrt => Number::sqrt(self),
        }
    }

    fn sign(self) -> i8 {
        let zero = Real::from(0.0);
        i8::from(self.value > zero) - i8::from(self.value < zero)
    }
}

#[cfg(test)]
mod tests {
    use carvallo::{Expression, Formula};

    use super::*;

    fn exact(value: f64) -> Exact {
        Exact::from(value)
    }

    #[test]
    fn sizes_are_those_of_all_terms() {
        let (a, b) = (exact(3.0), exact(2.0));
        let (product, expanded) = ((a - b) * (a - b), a * a - a * b - a * b + b * b);
        assert_eq!((product.value.to_f64(), product.size), (1.0, 25.0));
        assert_eq!((expanded.value.to_f64(), expanded.size), (1.0, 25.0));
        // A divisor that loses much makes the quotient lose as much.
        let quotient = exact(1.0) / (a - b);
        assert_eq!((quotient.value.to_f64(), quotient.size), (1.0, 5.0));
    }

    #[test]
    fn nothing_is_rounded_in_an_angle_that_is_a_parameter() {
        let angle = exact(1.0);
        assert!((angle.sin().size - 1_f64.sin()).abs() < 1e-15);
        // The sum of two has what is rounded in the sum.
        let sum = exact(0.5) + exact(0.5);
        assert!((sum.sin().size - (1_f64.sin() + 1_f64.cos())).abs() < 1e-15);
        assert!((sum.tan().value.to_f64() - 1_f64.tan()).abs() < 1e-15);
        assert!((exact(2.0).sqrt().value.to_f64() - 2_f64.sqrt()).abs() < 1e-15);
    }

    fn at(text: &str, a: f64, b: f64) -> Option<f64> {
        let find = |name: &str| match name {
            "a" => Some(Expression::Parameter(0)),
            "b" => Some(Expression::Parameter(1)),
            _ => None,
        };
        let formula = Expression::new(&Formula::parse(text).expect("a formula"), &find).expect("names that are known");
        let exact = formula.evaluate(&[Exact::from(a), Exact::from(b)], &[]).map(|exact| exact.value.to_f64());
        let double = formula.evaluate(&[a, b], &[]);
        assert!(exact.is_none() == double.is_none());
        if let (Some(exact), Some(double)) = (exact, double) {
            assert!((exact - double).abs() <= 1e-14 * exact.abs(), "{text}: {exact}, {double}");
        }
        exact
    }

    #[test]
    fn formulas_have_their_values() {
        let cases = [
            ("a - (b - 1)", 2.0),
            ("-a^2 + b", -7.0),
            ("1/a*b", 2.0 / 3.0),
            ("a^-1*b^0", 1.0 / 3.0),
            ("sqrt(a + 2*b + 2)", 3.0),
            ("2 [cm]*a", 0.06),
            ("90 [deg]/pi", 0.5),
            ("36 [km/h]", 10.0),
            ("3 [g*mm^2]", 3e-9),
            ("sin(pi/6) + cos(pi/3) + tan(pi/4)", 2.0),
        ];
        for (text, expected) in cases {
            let found = at(text, 3.0, 2.0).expect("a value");
            assert!((found - expected).abs() <= 1e-15 * expected.abs(), "{text}: {found}");
        }
    }

    #[test]
    fn what_has_no_value_has_none() {
        assert_eq!(at("1/(a - b)", 2.0, 2.0), None);
        assert_eq!(at("sqrt(a - b)", 1.0, 2.0), None);
        assert_eq!(at("(a - b)^-2", 2.0, 2.0), None);
    }
}
