//! What a model tells about itself: names, units, documentation, domains.

use core::fmt;

use super::domain::Domain;
use super::error::ParameterError;
use super::formula::FormulaInfo;
use super::motion_formulas::MotionFormulas;
use crate::motion::AppliedInfo;
use crate::system::{MatrixName, States};

/// A model's own description, for tables, files and messages.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelInfo {
    /// The name of the model's type.
    pub name: &'static str,
    /// The documentation of the declaration.
    pub docs: &'static str,
    /// Where the model comes from, or empty.
    pub source: &'static str,
    /// The parameters, in declared order.
    pub parameters: &'static [ParameterInfo],
    /// The coordinates q, in the order of the rows of the matrices.
    pub coordinates: &'static [CoordinateInfo],
    /// The forces and torques that the declaration of its mechanism names, in their order.
    pub forces: &'static [AppliedInfo],
    /// The matrices that the model has, in the order of [`MatrixName::ALL`]; the others are zero.
    pub matrices: &'static [MatrixName],
    /// The entries of the matrices that differ from each other and are not zero at all parameters: the columns of what
    /// is computed for many designs at once.
    pub entries: &'static [EntryInfo],
    /// The named parameter sets that the declaration carries.
    pub sets: &'static [SetInfo],
    /// What the model requires of several parameters at once: what its formulas need to have a value, then what its
    /// declaration requires.
    pub requirements: &'static [RequirementInfo],
    /// The definitions that the matrices depend on, each in those before it, and then the entries of the matrices that
    /// are not zero: as they are declared, or as they are derived from a mechanism. `equations` writes them for people.
    pub formulas: &'static [FormulaInfo],
    /// The same matrices by the attributes of a mechanism, such as the mass of a body or a place on the axis of a joint: each that has a
    /// parameter in it is a definition of its own, in which a mistake can be tried by itself. What holds because of relations
    /// between attributes, as that a wheel touches the ground, is taken to hold. Of a model with nonlinear equations there are also
    /// attributes that these alone depend on. Empty for models that are no mechanisms.
    pub attributes: &'static [FormulaInfo],
    /// Accelerations by the nonlinear equations of motion in these attributes, of a model whose declaration says `nonlinear;`.
    pub motion: Option<&'static MotionFormulas>,
    /// The position of the parameter that is the gravitational field strength g, if there is one.
    pub gravity: Option<usize>,
}

impl ModelInfo {
    /// The same without formulas: all that checks of parameters need, so that a program that only checks carries no more.
    #[must_use]
    pub const fn without_formulas(&self) -> Self {
        Self { formulas: &[], attributes: &[], motion: None, ..*self }
    }

    /// The position of the parameter called `name`.
    pub fn position(&self, name: &str) -> Option<usize> {
        self.parameters.iter().position(|p| p.name == name)
    }

    /// Whether the model has a matrix that the speed is a factor of: C-1, C1, K1 or K2.
    pub fn depends_on_speed(&self) -> bool {
        self.matrices
            .iter()
            .any(|matrix| matches!(matrix, MatrixName::Cm1 | MatrixName::C1 | MatrixName::K1 | MatrixName::K2))
    }

    /// Whether each of `values`, in declared order, lies in the domain of its parameter.
    ///
    /// # Errors
    /// The first parameter that does not.
    pub fn validate(&self, values: &[f64]) -> Result<(), ParameterError> {
        for (parameter, value) in self.parameters.iter().zip(values) {
            let ParameterInfo { name, unit, domain, .. } = *parameter;
            self.require(name, *value, unit, domain)?;
        }
        Ok(())
    }

    /// Whether each of `values`, those of the expressions of the requirements in their order, is one that is allowed.
    ///
    /// # Errors
    /// The first requirement that does not hold.
    pub fn validate_requirements(&self, values: &[f64]) -> Result<(), ParameterError> {
        for (requirement, value) in self.requirements.iter().zip(values) {
            let RequirementInfo { expression, unit, domain } = *requirement;
            self.require(expression, *value, unit, domain)?;
        }
        Ok(())
    }

    /// Whether a value lies in a domain; `subject` is the parameter or expression that has the value.
    ///
    /// # Errors
    /// If it does not.
    fn require(
        &self,
        subject: &'static str,
        value: f64,
        unit: &'static str,
        required: Domain,
    ) -> Result<(), ParameterError> {
        if required.contains(value) {
            return Ok(());
        }
        Err(ParameterError { model: self.name, subject, value, unit, required })
    }
}

/// One entry of the matrices of a model, or several that are always equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EntryInfo {
    /// Where it is: a matrix, a row and a column, both from zero as in `matrices().m[0][1]`. The first place names it.
    pub places: &'static [(MatrixName, usize, usize)],
}

impl EntryInfo {
    /// An entry that stands at these places.
    pub const fn at(places: &'static [(MatrixName, usize, usize)]) -> Self {
        Self { places }
    }
}

/// Reads `M_12`, with row and column counted from one, as in formulas and messages.
impl fmt::Display for EntryInfo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.places {
            [place, ..] => write_place(f, *place),
            [] => Ok(()),
        }
    }
}

/// Writes `M_12`, or `M_9,10` where the numbers could be read otherwise.
pub(super) fn write_place(
    f: &mut fmt::Formatter<'_>,
    (matrix, row, column): (MatrixName, usize, usize),
) -> fmt::Result {
    let comma = if row.max(column) > 8 { "," } else { "" };
    write!(f, "{matrix}_{}{comma}{}", row + 1, column + 1)
}

/// One parameter of a model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterInfo {
    /// The name of the field.
    pub name: &'static str,
    /// The symbol in formulas, such as λ for `lam`; the name where none is declared.
    pub symbol: &'static str,
    /// The documentation of the declaration.
    pub docs: &'static str,
    /// The unit as written in the declaration, such as `kg*m^2`; `1` for pure numbers.
    pub unit: &'static str,
    /// The values that are allowed.
    pub domain: Domain,
    /// Whether any matrix depends on it.
    pub used: bool,
}

impl ParameterInfo {
    /// A parameter on which a matrix depends, whose symbol is its name, without documentation.
    pub const fn new(name: &'static str, unit: &'static str, domain: Domain) -> Self {
        Self { name, symbol: name, docs: "", unit, domain, used: true }
    }

    /// The same with another symbol.
    pub const fn symbol(self, symbol: &'static str) -> Self {
        Self { symbol, ..self }
    }

    /// The same with documentation.
    pub const fn docs(self, docs: &'static str) -> Self {
        Self { docs, ..self }
    }

    /// The same, but no matrix depends on it.
    pub const fn unused(self) -> Self {
        Self { used: false, ..self }
    }
}

/// What a model requires of several parameters at once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RequirementInfo {
    /// An expression in the parameters and the definitions, as the declaration has it, such as `mH + mF`.
    pub expression: &'static str,
    /// The unit of its value, such as `kg`; `1` for pure numbers, empty where it is not known.
    pub unit: &'static str,
    /// The values that are allowed.
    pub domain: Domain,
}

impl RequirementInfo {
    /// An expression whose value must lie in a domain.
    pub const fn new(expression: &'static str, unit: &'static str, domain: Domain) -> Self {
        Self { expression, unit, domain }
    }
}

/// One coordinate of a model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoordinateInfo {
    /// The symbol in formulas, such as `phi`.
    pub name: &'static str,
    /// What it is, such as `lean`; the symbol where nothing is declared.
    pub label: &'static str,
    /// The documentation of the declaration.
    pub docs: &'static str,
    /// The unit as written in the declaration, such as `rad`.
    pub unit: &'static str,
    /// Which of its position and its rate are states.
    pub states: States,
}

impl CoordinateInfo {
    /// A coordinate whose label is its name, without documentation, of which position and rate are states.
    pub const fn new(name: &'static str, unit: &'static str) -> Self {
        Self { name, label: name, docs: "", unit, states: States::Both }
    }

    /// The same with another label.
    pub const fn label(self, label: &'static str) -> Self {
        Self { label, ..self }
    }

    /// The same, but of its position and its rate only one is a state.
    #[must_use]
    pub const fn states(self, states: States) -> Self {
        Self { states, ..self }
    }

    /// The same with documentation.
    pub const fn docs(self, docs: &'static str) -> Self {
        Self { docs, ..self }
    }
}

/// One named parameter set of a model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SetInfo {
    /// The name as declared, such as `benchmark`.
    pub name: &'static str,
    /// The documentation of the declaration.
    pub docs: &'static str,
    /// Where the values come from, or empty.
    pub source: &'static str,
    /// The values, in the declared order of the parameters: each the `f64` nearest to the exact value.
    pub values: &'static [f64],
}
