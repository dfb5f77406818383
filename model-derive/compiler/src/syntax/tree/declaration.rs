//! The syntax tree of a declaration.

use std::fmt;

use proc_macro2::{Ident, Span, TokenStream};
use quote::ToTokens as _;

use super::expression::Expression;
use super::mechanism::Mechanism;
use super::unit::Unit;
use crate::matrix_name::{MatrixName, Whole};
use crate::report::Region;
use crate::states::States;

/// A whole `model!` declaration.
#[derive(Debug)]
pub struct Declaration {
    /// Documentation lines, joined.
    pub docs: String,
    /// Attributes of Rust, for the struct.
    pub rust_attributes: Vec<RustAttribute>,
    pub visibility: TokenStream,
    pub name: Ident,
    /// Where the model comes from.
    pub source: Option<String>,
    pub parameters: Vec<Parameter>,
    /// What stands for the forward speed in formulas: no parameter of the model.
    pub speed: Option<Parameter>,
    pub definitions: Vec<Definition>,
    pub requirements: Vec<Requirement>,
    pub assertions: Vec<Assertion>,
    /// Matrices whose entries are asserted.
    pub asserted: Vec<Matrix>,
    pub sets: Vec<ParameterSet>,
    pub coordinates: Vec<Coordinate>,
    pub matrices: Vec<Matrix>,
    /// Matrices with the speed in them.
    pub wholes: Vec<(Whole, Matrix)>,
    /// What the matrices are derived from, unless they are written.
    pub mechanism: Option<Mechanism>,
    /// What is added to the matrices of the mechanism.
    pub added: Vec<Matrix>,
    /// Forces and torques that follow from the motion.
    pub feedback: Vec<Feedback>,
    /// Functions by hand that are to give the same matrices.
    pub compared: Vec<Compared>,
    /// Which derivatives of the matrices are asked for.
    pub derivatives: Option<AskedDerivatives>,
    /// Where the nonlinear equations of motion are asked for.
    pub nonlinear: Option<Span>,
    /// Names of statements that could not be read: they exist, so using them is no further mistake.
    pub unread: Vec<Ident>,
}

/// `derivatives;`, or `derivatives of M, K0 with respect to w, c;`.
#[derive(Clone, Debug)]
pub struct AskedDerivatives {
    pub span: Span,
    /// Of which matrices, each where it stands; of all if it is not said.
    pub matrices: Option<Vec<(MatrixName, Span)>>,
    /// With respect to which parameters; to all if it is not said.
    pub parameters: Option<Vec<Ident>>,
}

/// A function by hand that is to give the matrices of the model.
#[derive(Clone, Debug)]
pub struct Compared {
    /// The path of the function.
    pub function: TokenStream,
    /// Its name, the last one of the path.
    pub name: Ident,
    /// Whether it takes `f64` alone, and not any number.
    pub only_double: bool,
}

impl Declaration {
    /// The formulas that equations of motion are derived from: those in the mechanism, and behind them the entries that
    /// are added to its matrices, row by row.
    pub fn attributes(&self) -> impl Iterator<Item = &Expression> {
        let added = self.added.iter().flat_map(Matrix::entries);
        self.mechanism.iter().flat_map(Mechanism::formulas).chain(added)
    }

    /// What is said of each coordinate, which of its position and its rate are states.
    pub fn states(&self) -> impl Iterator<Item = Option<States>> {
        self.coordinates.iter().map(|coordinate| coordinate.only.map(|(_, states)| states))
    }

    /// For each coordinate whether it is one of first order as it is written: nothing multiplies its acceleration, or so it
    /// is said.
    pub fn of_first_order(&self) -> Vec<bool> {
        let mass = self.matrices.iter().find(|matrix| matrix.name == MatrixName::M);
        let is_zero = |column: usize| {
            let entry = |row: &Vec<Expression>| row.get(column).is_some_and(Expression::is_zero);
            mass.is_some_and(|mass| mass.rows.iter().all(|(_, row)| entry(row)))
        };
        let said = self.states().enumerate();
        said.map(|(column, said)| said.map_or_else(|| is_zero(column), |states| states == States::Position)).collect()
    }

    /// Where a matrix is declared: under its own name, or as a part of a whole.
    pub fn find_declared(&self, name: MatrixName) -> Option<&Matrix> {
        let own = self.matrices.iter().find(|matrix| matrix.name == name);
        own.or_else(|| self.wholes.iter().find(|(whole, _)| whole.parts().contains(&name)).map(|(_, matrix)| matrix))
    }
}

/// `#[derive(serde::Serialize)]`
pub struct RustAttribute {
    /// What stands between the brackets.
    pub meta: syn::Meta,
    pub region: Region,
}

/// As it is written: `syn` shows nothing without another of its features.
impl fmt::Debug for RustAttribute {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#[{}]", self.meta.to_token_stream())
    }
}

/// `lam "λ": rad, in (-pi/2, pi/2);`
#[derive(Debug)]
pub struct Parameter {
    /// Documentation lines, joined.
    pub docs: String,
    /// Attributes of Rust, for the field.
    pub rust_attributes: Vec<RustAttribute>,
    pub name: Ident,
    pub symbol: Option<String>,
    /// Nothing if it could not be read.
    pub unit: Option<Unit>,
    pub bounds: Vec<Bound>,
    pub direction: Option<Direction>,
    /// The span of the word `gravity`, for the parameter that is the gravitational field strength.
    pub gravity: Option<Span>,
    /// The span of the word `speed`, for what stands for the forward speed.
    pub speed: Option<Span>,
    /// The span of the word `unused`, for a parameter that no matrix depends on.
    pub unused: Option<Span>,
}

/// `along x`, `along x*z`, `about y`: how a quantity lies in the axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// A component of a vector, or of a tensor: for each axis whether it occurs an odd number of times.
    Along([bool; 3]),
    /// An angle about an axis, x, y or z.
    About(usize),
}

/// A constant, in the unit that is written behind it or in that of what it belongs to.
#[derive(Clone, Debug)]
pub struct Value {
    pub number: Expression,
    pub unit: Option<Unit>,
}

impl Value {
    pub fn region(&self) -> Region {
        self.unit.as_ref().map_or(self.number.region, |unit| self.number.region.to(unit.region))
    }
}

/// One end of a domain: `> 0`.
#[derive(Debug)]
pub struct Bound {
    pub relation: Relation,
    pub value: Value,
    pub region: Region,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    Greater,
    GreaterEqual,
    Less,
    LessEqual,
    NotEqual,
}

/// `let mT = mR + mB;`
#[derive(Debug)]
pub struct Definition {
    pub name: Ident,
    pub value: Expression,
}

/// `require mH + mF > 0;`
#[derive(Debug)]
pub struct Requirement {
    pub value: Expression,
    pub bound: Bound,
}

/// `assert mu*w == c*cos(lam);`
#[derive(Debug)]
pub struct Assertion {
    pub left: Expression,
    pub right: Expression,
}

/// `set benchmark "source" { w = 1.02; }`
#[derive(Debug)]
pub struct ParameterSet {
    /// Documentation lines, joined.
    pub docs: String,
    /// Each `#[default]` before it.
    pub defaults: Vec<Region>,
    pub name: Ident,
    pub source: Option<String>,
    pub values: Vec<SetValue>,
    /// Matrices that the source of the set publishes for it.
    pub published: Vec<Published>,
}

/// `w = 1.02;`
#[derive(Debug)]
pub struct SetValue {
    pub name: Ident,
    /// Nothing if it could not be read.
    pub value: Option<Value>,
}

/// `M = [[80.81722, 2.31941332208709], …];` in a set: results as they were printed.
#[derive(Debug)]
pub struct Published {
    pub name: MatrixName,
    pub span: Span,
    /// The rows, each with its region.
    pub rows: Vec<(Region, Vec<Printed>)>,
    pub region: Region,
}

/// A printed number, with all its digits.
#[derive(Clone, Debug)]
pub struct Printed {
    pub text: String,
    pub region: Region,
}

/// `phi "lean": rad;`
#[derive(Debug)]
pub struct Coordinate {
    /// Documentation lines, joined.
    pub docs: String,
    pub name: Ident,
    pub label: Option<String>,
    /// Nothing if it could not be read.
    pub unit: Option<Unit>,
    pub direction: Option<Direction>,
    /// Which of its position and its rate are states, where that is said, with the span of the word.
    pub only: Option<(Span, States)>,
}

/// `M = [[a, b], [b, c]];`, or `add M = …` beside a mechanism.
#[derive(Debug)]
pub struct Matrix {
    pub name: MatrixName,
    /// Whether the word `symmetric` stands before it.
    pub symmetric: bool,
    pub span: Span,
    /// The rows, each with its region.
    pub rows: Vec<(Region, Vec<Expression>)>,
    /// The brackets and all between.
    pub region: Region,
}

/// `feedback T "steer torque" on delta = -k*rate(phi);`
#[derive(Debug)]
pub struct Feedback {
    /// What the force or torque is called.
    pub name: Ident,
    pub label: Option<String>,
    /// The coordinate, joint or wheel that it acts on.
    pub on: Ident,
    /// What it is, in coordinates, their rates, the speed and parameters.
    pub law: Expression,
}

impl Matrix {
    /// Row by row.
    pub fn entries(&self) -> impl Iterator<Item = &Expression> {
        self.rows.iter().flat_map(|(_, row)| row)
    }
}
