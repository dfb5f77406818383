//! The formulas of a model: names are resolved, and what is left are positions of parameters and definitions.
//!
//! A formula does not know where it was written. It goes to the thread of the symbolic engine, where the places of a
//! source cannot follow; a stage that tells of places walks along the syntax beside it.

mod decimal;
mod fold;
mod text;

pub use self::decimal::Decimal;
pub use self::fold::{Algebra, Values};
pub use self::text::{Names, Text};

use nanoserde::{DeBin, SerBin};

/// A formula in parameters and definitions, by position. Sums and products are flat.
#[derive(Clone, Debug, DeBin, PartialEq, SerBin)]
pub enum Formula {
    /// A decimal number, exact.
    Number(Decimal),
    /// The number π.
    Pi,
    /// The parameter at a position.
    Parameter(usize),
    /// The definition at a position.
    Definition(usize),
    /// A sum of terms.
    Sum(Vec<Term>),
    /// A product of factors.
    Product(Vec<Factor>),
    /// A whole power.
    Power(Box<Formula>, i32),
    /// A function of an argument.
    Call(Function, Box<Formula>),
}

/// One term of a sum.
#[derive(Clone, Debug, DeBin, PartialEq, SerBin)]
pub struct Term<V = Formula> {
    /// Whether it is subtracted.
    pub negative: bool,
    /// What is added or subtracted.
    pub value: V,
}

/// One factor of a product.
#[derive(Clone, Debug, DeBin, PartialEq, SerBin)]
pub struct Factor<V = Formula> {
    /// Whether it divides.
    pub inverse: bool,
    /// What multiplies or divides.
    pub value: V,
}

impl<V> Term<V> {
    /// A term that is added.
    pub fn plus(value: V) -> Self {
        Self { negative: false, value }
    }

    /// A term that is subtracted.
    pub fn minus(value: V) -> Self {
        Self { negative: true, value }
    }

    /// The same term of another value.
    pub fn map<W>(&self, f: impl FnOnce(&V) -> W) -> Term<W> {
        Term { negative: self.negative, value: f(&self.value) }
    }
}

impl<V> Factor<V> {
    /// A factor that multiplies.
    pub fn times(value: V) -> Self {
        Self { inverse: false, value }
    }

    /// A factor that divides.
    pub fn over(value: V) -> Self {
        Self { inverse: true, value }
    }

    /// The same factor of another value.
    pub fn map<W>(&self, f: impl FnOnce(&V) -> W) -> Factor<W> {
        Factor { inverse: self.inverse, value: f(&self.value) }
    }
}

/// The functions that formulas may use.
#[derive(Clone, Copy, Debug, DeBin, PartialEq, Eq, Hash, SerBin)]
pub enum Function {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// The non-negative square root.
    Sqrt,
}

impl Function {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Sin, Self::Cos, Self::Tan, Self::Sqrt];

    /// As it is written.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Tan => "tan",
            Self::Sqrt => "sqrt",
        }
    }

    /// The function called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|function| function.name() == name)
    }
}

impl Formula {
    /// The number zero.
    pub fn zero() -> Self {
        Self::Number(Decimal { digits: "0".into(), exponent: 0 })
    }

    /// The number one.
    pub fn one() -> Self {
        Self::Number(Decimal { digits: "1".into(), exponent: 0 })
    }

    /// Whether it is the number zero as it stands.
    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Number(number) if number.is_zero())
    }

    /// The same formula with another position for each definition.
    pub fn renumbered(&self, new: &[usize]) -> Self {
        self.with_leaves(&|leaf| match leaf {
            Self::Definition(old) => Self::Definition(new[*old]),
            other => other.clone(),
        })
    }

    /// The same formula with others in the place of its numbers, parameters and definitions.
    pub fn with_leaves(&self, new: &impl Fn(&Self) -> Self) -> Self {
        match self {
            Self::Sum(terms) => Self::Sum(terms.iter().map(|term| term.map(|value| value.with_leaves(new))).collect()),
            Self::Product(factors) => {
                Self::Product(factors.iter().map(|factor| factor.map(|value| value.with_leaves(new))).collect())
            }
            Self::Power(base, exponent) => Self::Power(Box::new(base.with_leaves(new)), *exponent),
            Self::Call(function, argument) => Self::Call(*function, Box::new(argument.with_leaves(new))),
            Self::Number(_) | Self::Pi | Self::Parameter(_) | Self::Definition(_) => new(self),
        }
    }

    /// The definitions that the formula uses itself, as often as it does.
    pub fn find_definitions(&self) -> Vec<usize> {
        let mut found = Vec::new();
        self.walk(&mut |part| {
            if let Self::Definition(index) = part {
                found.push(*index);
            }
        });
        found
    }

    /// Calls `visit` with this formula and every one inside it.
    pub fn walk(&self, visit: &mut impl FnMut(&Self)) {
        visit(self);
        match self {
            Self::Sum(terms) => terms.iter().for_each(|term| term.value.walk(visit)),
            Self::Product(factors) => factors.iter().for_each(|factor| factor.value.walk(visit)),
            Self::Power(inner, _) | Self::Call(_, inner) => inner.walk(visit),
            Self::Number(_) | Self::Pi | Self::Parameter(_) | Self::Definition(_) => {}
        }
    }
}
