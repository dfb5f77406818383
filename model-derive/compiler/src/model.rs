//! The model: formulas in the parameters alone, which are what the declaration says of them.

use proc_macro2::{Ident, Span, TokenStream};

use crate::domain::Domain;
use crate::formula::Formula;
use crate::kinematics::Kinematics;
use crate::matrix_name::MatrixName;
use crate::motion::MotionModel;
use crate::report::Region;
use crate::states::States;
use crate::syntax::Compared;
use crate::written::Written;

/// A model that passed all checks, and whose claims are proved.
#[derive(Debug)]
pub struct Model {
    /// The name of the struct that is generated.
    pub name: Ident,
    /// `pub` and the like, or nothing.
    pub visibility: TokenStream,
    /// Attributes of the user's own for the struct, each without its brackets.
    pub rust_attributes: Vec<TokenStream>,
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
    /// The same matrices in other formulas, summed over the bodies of a mechanism. Definitions that only they use are the last.
    pub by_bodies: Option<Matrices>,
    /// Where the entries of the matrices stand, in the same order, row by row.
    pub entries: Vec<Region>,
    /// The matrices that are proved to be symmetric.
    pub symmetric: Vec<MatrixName>,
    /// The definitions that the matrices depend on, and their entries, as people read them.
    pub formulas: Vec<Written>,
    /// The same matrices by the attributes of a mechanism, each of which has a name of its own; empty for other models.
    pub attributes: Vec<Written>,
    /// Forces and torques that follow from the motion, which are in the matrices.
    pub feedback: Vec<Feedback>,
    /// Rates and forces, of a model that is a mechanism.
    pub kinematics: Option<Kinematics<Formula>>,
    /// What is free of the motion of a mechanism, if its nonlinear equations are asked for.
    pub motion: Option<MotionModel>,
    /// Functions by hand that are to give the same matrices.
    pub compared: Vec<Compared>,
    /// Which derivatives of the matrices are asked for.
    pub derivatives: Option<AskedDerivatives>,
    /// The names in the declaration, for editors.
    pub references: References,
}

impl Model {
    /// The formulas of the definitions, in their order.
    pub fn formulas_of_definitions(&self) -> impl Iterator<Item = &Formula> {
        self.definitions.iter().map(|(_, formula)| formula)
    }
}

/// What editors need to know of the names in a declaration.
#[derive(Debug)]
pub struct References {
    /// What has a name beside the parameters: each name once for what it stands for.
    pub named: Vec<Named>,
    /// Every use of a name.
    pub uses: Vec<(Target, Ident)>,
    /// Names that stand for nothing, each with what it should stand for: beside a definition that may be a parameter. One
    /// of them is what is just being written in an editor.
    pub unknown: Vec<(Target, Ident)>,
    /// The names of the declared matrices, where they are declared.
    pub matrices: Vec<(MatrixName, Span)>,
}

/// Something that has a name.
#[derive(Debug)]
pub struct Named {
    /// What it is.
    pub target: Target,
    /// The name, where it is declared.
    pub name: Ident,
    /// What is to be known of it, as Markdown.
    pub docs: String,
}

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// A parameter.
    Parameter,
    /// A definition, or the speed.
    Definition,
    /// A coordinate: also the joint or the freedom that has its name.
    Coordinate,
    /// A body or a wheel.
    Part,
    /// A unit, which is declared nowhere.
    Unit,
}

/// Matrices by name, each as rows of formulas.
pub type Matrices = Vec<(MatrixName, Vec<Vec<Formula>>)>;

/// One parameter.
#[derive(Debug)]
pub struct Parameter {
    /// The name of the field.
    pub name: Ident,
    /// Attributes of the user's own for the field.
    pub rust_attributes: Vec<TokenStream>,
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
    /// Which of its position and its rate are states.
    pub states: States,
    /// The documentation of the declaration.
    pub docs: String,
    /// The unit in its canonical spelling.
    pub unit: String,
}

/// A force or torque that follows from the motion.
#[derive(Debug)]
pub struct Feedback {
    /// What it is called.
    pub name: String,
    /// What it is; the name where nothing is declared.
    pub label: String,
    /// The coordinate, joint or wheel that it acts on.
    pub on: String,
    /// What it is in, where it is a force or a torque.
    pub unit: Option<&'static str>,
    /// What it is, as it is declared.
    pub law: String,
}

/// Which derivatives of the matrices are asked for.
#[derive(Clone, Debug)]
pub struct AskedDerivatives {
    /// Where they are.
    pub span: Span,
    /// Of which matrices, if not of all.
    pub matrices: Option<Vec<MatrixName>>,
    /// For each parameter whether those with respect to it.
    pub parameters: Vec<bool>,
}

impl AskedDerivatives {
    /// Whether those of a matrix are asked for.
    pub fn has(&self, matrix: MatrixName) -> bool {
        self.matrices.as_ref().is_none_or(|matrices| matrices.contains(&matrix))
    }

    /// Whether those of all matrices are asked for.
    pub fn has_all_matrices(&self, model: &Model) -> bool {
        model.matrices.iter().all(|(matrix, _)| self.has(*matrix))
    }

    /// Whether all derivatives are asked for, which is what everything needs that takes any model.
    pub fn is_all(&self, model: &Model) -> bool {
        self.has_all_matrices(model) && self.parameters.iter().all(|asked| *asked)
    }
}

/// One named parameter set.
#[derive(Debug)]
pub struct ParameterSet {
    /// The name as declared.
    pub name: Ident,
    /// Whether it is the default of the model.
    pub is_default: bool,
    /// The documentation of the declaration.
    pub docs: String,
    /// Where the values come from, or empty.
    pub source: String,
    /// One for each parameter, in declared order.
    pub values: Vec<f64>,
}

/// A condition on several parameters.
#[derive(Clone, Debug)]
pub struct Requirement {
    /// The expression as it was written.
    pub text: String,
    /// The unit of its value; empty where it is not known.
    pub unit: String,
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
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The declaration.
    Declared,
    /// The matrices, which have no value without it.
    Matrices,
    /// A requirement of the declaration, which has no value without it.
    Requirements,
    /// The mechanism, of which it is this: "the mass of `B`".
    Mechanism(String),
}
