//! The formulas of a model as people read them.

use core::fmt;

use super::info::{EntryInfo, write_place};
use crate::system::MatrixName;

/// One formula of a model: that of a definition or of an entry of a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FormulaInfo {
    /// What the formula is of.
    pub of: FormulaSubject,
    /// The unit of its value in kg, m and s, such as `kg*m^2`; `1` for pure numbers, empty where it is not known.
    pub unit: &'static str,
    /// The formula as a declaration has it, in the names of parameters and of earlier definitions, such as
    /// `IAlx + mu*ITxz`.
    pub text: &'static str,
}

/// What a formula is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FormulaSubject {
    /// The definition of this name.
    Definition(&'static str),
    /// An attribute of a mechanism.
    Attribute {
        /// Its name in other formulas, such as `H_x`.
        name: &'static str,
        /// What it is, such as `x of the centre of mass of the front frame H`.
        what: &'static str,
    },
    /// An entry of a matrix, with the others of that matrix that have the same formula.
    Entry(EntryInfo),
}

impl FormulaInfo {
    /// The formula of a definition.
    pub const fn definition(name: &'static str, unit: &'static str, text: &'static str) -> Self {
        Self { of: FormulaSubject::Definition(name), unit, text }
    }

    /// The formula of an attribute of a mechanism.
    pub const fn attribute(name: &'static str, what: &'static str, unit: &'static str, text: &'static str) -> Self {
        Self { of: FormulaSubject::Attribute { name, what }, unit, text }
    }

    /// The formula of the entries at these places.
    pub const fn entry(places: &'static [(MatrixName, usize, usize)], unit: &'static str, text: &'static str) -> Self {
        Self { of: FormulaSubject::Entry(EntryInfo::at(places)), unit, text }
    }
}

/// Reads `ITxz = IBxz + IHxz [kg*m^2]` or `M_12 = M_21 = IAlx + mu*ITxz [kg*m^2]`, with rows and columns counted from one.
impl fmt::Display for FormulaInfo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { of, unit, text } = self;
        match of {
            FormulaSubject::Definition(name) | FormulaSubject::Attribute { name, .. } => write!(f, "{name} = ")?,
            FormulaSubject::Entry(EntryInfo { places }) => {
                for place in *places {
                    write_place(f, *place)?;
                    f.write_str(" = ")?;
                }
            }
        }
        f.write_str(text)?;
        if unit.is_empty() { Ok(()) } else { write!(f, " [{unit}]") }
    }
}
