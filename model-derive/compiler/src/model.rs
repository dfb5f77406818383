//! The checked model: every name resolved, every shape and domain right.

use proc_macro2::{Ident, TokenStream};

use crate::syntax::{Decimal, MatrixName};

/// A model that passed all checks.
#[derive(Debug)]
pub struct Model {
    pub name: Ident,
    pub visibility: TokenStream,
    pub docs: String,
    pub source: String,
    pub parameters: Vec<Parameter>,
    /// The parameter that is the gravitational field strength.
    pub gravity: Option<usize>,
    /// In an order in which each uses only earlier ones.
    pub definitions: Vec<(Ident, Expr)>,
    pub requirements: Vec<Requirement>,
    pub sets: Vec<ParameterSet>,
    pub coordinates: Vec<Coordinate>,
    /// The declared matrices, in the order of the equation of motion.
    pub matrices: Vec<(MatrixName, Vec<Vec<Expr>>)>,
}

#[derive(Debug)]
pub struct Parameter {
    pub name: Ident,
    pub symbol: String,
    pub docs: String,
    pub unit: String,
    pub domain: Domain,
    /// Whether a matrix depends on it.
    pub used: bool,
}

#[derive(Debug)]
pub struct Coordinate {
    pub name: String,
    pub label: String,
    pub docs: String,
    pub unit: String,
}

#[derive(Debug)]
pub struct ParameterSet {
    pub name: Ident,
    pub docs: String,
    pub source: String,
    /// One for each parameter, in declared order.
    pub values: Vec<f64>,
}

/// A condition on several parameters.
#[derive(Debug)]
pub struct Requirement {
    /// The expression as it was written.
    pub text: String,
    pub value: Expr,
    pub domain: Domain,
}

/// Finite values between two bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    pub lower: Bound,
    pub upper: Bound,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    Unbounded,
    Open(f64),
    Closed(f64),
}

/// A formula in parameters and definitions, by position.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    Number(Decimal),
    Pi,
    Parameter(usize),
    Definition(usize),
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Expr)>),
    /// Factors, each with whether it divides.
    Product(Vec<(bool, Expr)>),
    Power(Box<Expr>, i32),
    Call(Function, Box<Expr>),
}

/// The functions that formulas may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Sqrt,
}

impl Function {
    pub const ALL: [Self; 4] = [Self::Sin, Self::Cos, Self::Tan, Self::Sqrt];

    pub fn name(self) -> &'static str {
        match self {
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Tan => "tan",
            Self::Sqrt => "sqrt",
        }
    }

    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|function| function.name() == name)
    }
}

impl Expr {
    /// Calls `visit` with this formula and every one inside it.
    pub fn walk(&self, visit: &mut impl FnMut(&Expr)) {
        visit(self);
        match self {
            Self::Sum(parts) | Self::Product(parts) => parts.iter().for_each(|(_, part)| part.walk(visit)),
            Self::Power(inner, _) | Self::Call(_, inner) => inner.walk(visit),
            Self::Number(_) | Self::Pi | Self::Parameter(_) | Self::Definition(_) => {}
        }
    }
}

/// Reads as the end of a sentence "expected …".
impl std::fmt::Display for Domain {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let lower = match self.lower {
            Bound::Unbounded => None,
            Bound::Open(bound) => Some(format!("> {bound}")),
            Bound::Closed(bound) => Some(format!(">= {bound}")),
        };
        let upper = match self.upper {
            Bound::Unbounded => None,
            Bound::Open(bound) => Some(format!("< {bound}")),
            Bound::Closed(bound) => Some(format!("<= {bound}")),
        };
        match (lower, upper) {
            (None, None) => f.write_str("any finite value"),
            (Some(one), None) | (None, Some(one)) => f.write_str(&one),
            (Some(low), Some(high)) => write!(f, "{low} and {high}"),
        }
    }
}
