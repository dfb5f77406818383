//! Arithmetic with formulas inside the engine.

use std::ops::{Add, Mul, Neg, Sub};

use symbolica::atom::{Atom, AtomCore, AtomView};

use super::form::Form;

impl Form {
    /// A whole number.
    pub fn number(value: i64) -> Self {
        Self(Atom::num(value))
    }

    /// This divided by a formula that is not zero.
    pub fn over(&self, divisor: &Self) -> Self {
        Self(&self.0 / &divisor.0)
    }

    /// The root of a formula that is not negative.
    pub fn root(&self) -> Self {
        Self(self.0.sqrt())
    }

    /// Whether it is the number zero as it stands.
    pub fn is_nothing(&self) -> bool {
        self.0.is_zero()
    }

    /// Whether it is a number, or one factor of a number and a name: nothing that would be worth a name of its own.
    pub fn is_short(&self) -> bool {
        let AtomView::Mul(product) = self.0.as_view() else { return self.is_trivial() };
        let plain = |factor| matches!(factor, AtomView::Num(_) | AtomView::Var(_));
        product.get_nargs() <= 2 && product.iter().all(plain) && product.iter().any(|f| matches!(f, AtomView::Num(_)))
    }
}

impl Add for &Form {
    type Output = Form;
    fn add(self, other: Self) -> Form {
        Form(&self.0 + &other.0)
    }
}

impl Sub for &Form {
    type Output = Form;
    fn sub(self, other: Self) -> Form {
        Form(&self.0 - &other.0)
    }
}

impl Mul for &Form {
    type Output = Form;
    fn mul(self, other: Self) -> Form {
        Form(&self.0 * &other.0)
    }
}

impl Neg for &Form {
    type Output = Form;
    fn neg(self) -> Form {
        Form(-&self.0)
    }
}
