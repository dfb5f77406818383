//! The checked model: every name resolved, every shape and domain right.

use proc_macro2::{Ident, Span, TokenStream};

use crate::formula::Formula;
use crate::kinematics::Kinematics;
use crate::report::Region;
use crate::syntax::MatrixName;

/// A model that passed all checks.
#[derive(Debug)]
pub struct Model {
    /// The name of the struct that is generated.
    pub name: Ident,
    /// `pub` and the like, or nothing.
    pub visibility: TokenStream,
    /// The documentation of the declaration.
    pub docs: String,
    /// Where the model comes from, or empty.
    pub source: String,
    /// In declared order.
    pub parameters: Vec<Parameter>,
    /// The parameter that is the gravitational field strength.
    pub gravity: Option<usize>,
    /// With their names, in an order in which each uses only earlier ones.
    pub definitions: Vec<(Ident, Formula)>,
    /// Conditions on several parameters: those that the formulas need to have a value, then those that are written.
    pub requirements: Vec<Requirement>,
    /// Named parameter sets.
    pub sets: Vec<ParameterSet>,
    /// The coordinates q, in the order of the rows of the matrices.
    pub coordinates: Vec<Coordinate>,
    /// The declared matrices, in the order of the equation of motion.
    pub matrices: Matrices,
    /// Where the entries of the matrices stand, in the same order, row by row.
    pub entries: Vec<Region>,
    /// The matrices that are proved to be symmetric.
    pub symmetric: Vec<MatrixName>,
    /// Rates and forces, of a model that is a mechanism.
    pub kinematics: Option<Kinematics<Formula>>,
    /// Where the derivatives of the matrices are asked for.
    pub derivatives: Option<Span>,
    /// The names in the declaration, for editors.
    pub references: References,
}

/// What editors need to know of the names in a declaration.
#[derive(Debug)]
pub struct References {
    /// The definitions in declared order, each with its formula as it was written.
    pub definitions: Vec<(Ident, String)>,
    /// Every use of a name in a formula or a parameter set.
    pub uses: Vec<(Target, Ident)>,
    /// The names of the declared matrices, where they are declared.
    pub matrices: Vec<(MatrixName, Span)>,
}

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A parameter.
    Parameter,
    /// A definition.
    Definition,
}

/// Matrices by name, each as rows of formulas.
pub type Matrices = Vec<(MatrixName, Vec<Vec<Formula>>)>;

/// One parameter.
#[derive(Debug)]
pub struct Parameter {
    /// The name of the field.
    pub name: Ident,
    /// The symbol in formulas; the name where none is declared.
    pub symbol: String,
    /// The documentation of the declaration.
    pub docs: String,
    /// The unit in its canonical spelling.
    pub unit: String,
    /// The values that are allowed.
    pub domain: Domain,
    /// Whether a matrix depends on it.
    pub used: bool,
}

/// One coordinate.
#[derive(Debug)]
pub struct Coordinate {
    /// The symbol in formulas.
    pub name: String,
    /// What it is; the symbol where nothing is declared.
    pub label: String,
    /// The documentation of the declaration.
    pub docs: String,
    /// The unit in its canonical spelling.
    pub unit: String,
}

/// One named parameter set.
#[derive(Debug)]
pub struct ParameterSet {
    /// The name as declared.
    pub name: Ident,
    /// The documentation of the declaration.
    pub docs: String,
    /// Where the values come from, or empty.
    pub source: String,
    /// One for each parameter, in declared order.
    pub values: Vec<f64>,
}

/// A condition on several parameters.
#[derive(Debug)]
pub struct Requirement {
    /// The expression as it was written.
    pub text: String,
    /// Where it stands.
    pub region: Region,
    /// The same, resolved.
    pub value: Formula,
    /// The values that are allowed.
    pub domain: Domain,
    /// Who asks for it.
    pub origin: Origin,
}

/// Who asks for a requirement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The declaration.
    Declared,
    /// The matrices, which have no value without it.
    Matrices,
    /// A requirement of the declaration, which has no value without it.
    Requirements,
}

/// Finite values between two bounds, with or without zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// The lower end.
    pub lower: Bound,
    /// The upper end.
    pub upper: Bound,
    /// Whether zero is left out.
    pub nonzero: bool,
}

/// One end of a domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// Any finite value.
    Unbounded,
    /// Without the bound itself.
    Open(f64),
    /// With the bound itself.
    Closed(f64),
}

impl Domain {
    /// Any finite value but zero.
    pub const NONZERO: Self = Self { lower: Bound::Unbounded, upper: Bound::Unbounded, nonzero: true };
    /// What a square root takes.
    pub const NONNEGATIVE: Self = Self { lower: Bound::Closed(0.0), upper: Bound::Unbounded, nonzero: false };

    /// Whether `value` is finite and inside.
    pub fn contains(&self, value: f64) -> bool {
        let above = match self.lower {
            Bound::Unbounded => true,
            Bound::Open(bound) => value > bound,
            Bound::Closed(bound) => value >= bound,
        };
        let below = match self.upper {
            Bound::Unbounded => true,
            Bound::Open(bound) => value < bound,
            Bound::Closed(bound) => value <= bound,
        };
        value.is_finite() && above && below && !(self.nonzero && value == 0.0)
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
            (None, None) if self.nonzero => return f.write_str("not 0"),
            (None, None) => return f.write_str("any finite value"),
            (Some(one), None) | (None, Some(one)) => f.write_str(&one)?,
            (Some(low), Some(high)) => write!(f, "{low} and {high}")?,
        }
        if self.nonzero { f.write_str(" and not 0") } else { Ok(()) }
    }
}
