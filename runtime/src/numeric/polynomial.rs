//! Polynomials in one variable.

use core::ops::{Add, Mul, Sub};

use super::double_double::DoubleDouble;
use super::tracked::Tracked;

/// A polynomial by its coefficients, ascending; the zero polynomial has none.
///
/// Coefficients that are only the noise of cancelled terms are exact zeros, and the last coefficient is not zero.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Polynomial(Vec<Tracked>);

impl Polynomial {
    pub(crate) fn new(coefficients: impl IntoIterator<Item = Tracked>) -> Self {
        let clean = |c: Tracked| if c.sign() == 0 { Tracked { value: DoubleDouble::ZERO, ..c } } else { c };
        let mut coefficients: Vec<Tracked> = coefficients.into_iter().map(clean).collect();
        while coefficients.last().is_some_and(|c| c.sign() == 0) {
            coefficients.pop();
        }
        Self(coefficients)
    }

    pub(crate) fn constant(value: f64) -> Self {
        Self::new([value.into()])
    }

    pub(crate) fn coefficients(&self) -> &[Tracked] {
        &self.0
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The value at `x` by Horner's rule; its size is that of the largest partial sums, for `x >= 0`.
    pub(crate) fn at(&self, x: DoubleDouble) -> Tracked {
        let x = Tracked::from(x);
        self.0.iter().rev().fold(Tracked::ZERO, |value, &c| value * x + c)
    }

    pub(crate) fn derivative(&self) -> Self {
        Self::new(self.0.iter().enumerate().skip(1).map(|(power, &c)| c * (power as f64).into()))
    }

    /// The polynomial whose roots are `1 / scale` times those of this one.
    pub(crate) fn stretched(&self, scale: f64) -> Self {
        let mut power = Tracked::from(1.0);
        Self::new(self.0.iter().map(|&c| {
            let stretched = c * power;
            power = power * scale.into();
            stretched
        }))
    }

    /// The polynomial whose roots are the reciprocals of those of this one.
    pub(crate) fn reversed(&self) -> Self {
        Self::new(self.0.iter().rev().copied())
    }

    /// q with `p(x) = q(x^2)`, if there is one.
    pub(crate) fn in_square(&self) -> Option<Self> {
        let odd = self.0.iter().skip(1).step_by(2);
        odd.copied().all(|c| c.sign() == 0).then(|| Self::new(self.0.iter().step_by(2).copied()))
    }

    /// q without a root at zero, with `p(x) = x^k q(x)`.
    pub(crate) fn without_zero_roots(&self) -> Self {
        Self::new(self.0.iter().copied().skip_while(|c| c.sign() == 0))
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: Self) -> Polynomial {
        let coefficient = |p: &Polynomial, power| p.0.get(power).copied().unwrap_or(Tracked::ZERO);
        Polynomial::new((0..self.0.len().max(other.0.len())).map(|i| coefficient(self, i) + coefficient(other, i)))
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: Self) -> Polynomial {
        self + &(other * -1.0)
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: Self) -> Polynomial {
        let mut product = vec![Tracked::ZERO; (self.0.len() + other.0.len()).saturating_sub(1)];
        for (i, &a) in self.0.iter().enumerate() {
            for (j, &b) in other.0.iter().enumerate() {
                product[i + j] = product[i + j] + a * b;
            }
        }
        Polynomial::new(product)
    }
}

impl Mul<f64> for &Polynomial {
    type Output = Polynomial;
    fn mul(self, factor: f64) -> Polynomial {
        Polynomial::new(self.0.iter().map(|&c| c * factor.into()))
    }
}

impl Add for Polynomial {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        &self + &other
    }
}

impl Sub for Polynomial {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        &self - &other
    }
}

impl Mul for Polynomial {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        &self * &other
    }
}
