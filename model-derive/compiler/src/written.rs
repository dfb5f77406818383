//! The formulas of a model as people read them.

use std::fmt;

use crate::check::{Checked, Units};
use crate::derivation::Derived;
use crate::equations::Equations;
use crate::formula::Formula;
use crate::matrix_name::MatrixName;
use crate::states::States;
use crate::syntax::Matrix;

/// A definition, or an entry of a matrix.
#[derive(Clone, Debug)]
pub struct Written {
    /// What the formula is of.
    pub of: Of,
    /// Its unit; empty where it is not known.
    pub unit: String,
    /// The formula, as it would be declared.
    pub text: String,
}

/// What a formula is of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Of {
    /// A definition by its name.
    Definition(String),
    /// The entries of a matrix that have it, by rows and columns from zero.
    Entries(MatrixName, Vec<[usize; 2]>),
}

/// The definitions that the matrices depend on, each in those before it, and the entries that are not zero: as they are
/// declared, or as they are derived.
pub fn write_formulas(checked: &Checked<'_>, derived: &Derived, units: &Units) -> Vec<Written> {
    let declaration = checked.declaration;
    let entries: Vec<Formula> = derived.matrices.iter().flat_map(|(_, rows)| rows.iter().flatten()).cloned().collect();
    let needed = Equations::of_formulas(checked.domains.len(), &derived.definitions, entries).origins;
    let text = |formula: &Formula| derived.names.text_in_order(formula).to_string();
    let definitions = needed.into_iter().map(|index| Written {
        of: Of::Definition(derived.names.definitions[index].to_string()),
        unit: units.of_definition(index),
        text: match checked.order.get(index) {
            Some(declared) => declaration.definitions[*declared].value.to_string(),
            None => text(&derived.definitions[index]),
        },
    });
    let mut formulas: Vec<Written> = definitions.collect();
    for (name, rows) in &derived.matrices {
        let declared = declaration.matrices.iter().find(|matrix: &&Matrix| matrix.name == *name);
        let places = (0..rows.len()).flat_map(|row| (0..rows.len()).map(move |column| [row, column]));
        let mut found: Vec<(&Formula, Vec<[usize; 2]>)> = Vec::new();
        for [row, column] in places {
            let entry = &rows[row][column];
            match found.iter_mut().find(|(known, _)| *known == entry) {
                _ if entry.is_zero() => {}
                Some((_, places)) => places.push([row, column]),
                None => found.push((entry, vec![[row, column]])),
            }
        }
        formulas.extend(found.into_iter().map(|(entry, places)| {
            let [row, column] = places[0];
            Written {
                of: Of::Entries(*name, places),
                // The row of a coordinate of first order may be multiplied by anything.
                unit: match derived.states.get(row) {
                    Some(States::Position) => units.of(entry),
                    _ => units.of_entry(*name, row, column),
                },
                text: match declared.filter(|_| !derived.fed.contains(&(*name, row, column))) {
                    Some(matrix) => matrix.rows[row].1[column].to_string(),
                    None => text(entry),
                },
            }
        }));
    }
    formulas
}

/// Reads `ITxz = IBxz + IHxz [kg*m^2]` or `M_12 = M_21 = IAlx + mu*ITxz [kg*m^2]`, as the runtime's `FormulaInfo` does.
impl fmt::Display for Written {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { of, unit, text } = self;
        match of {
            Of::Definition(name) => write!(f, "{name} = ")?,
            Of::Entries(matrix, places) => {
                for [row, column] in places {
                    let comma = if *row.max(column) > 8 { "," } else { "" };
                    write!(f, "{}_{}{comma}{} = ", matrix.name(), row + 1, column + 1)?;
                }
            }
        }
        f.write_str(text)?;
        if unit.is_empty() { Ok(()) } else { write!(f, " [{unit}]") }
    }
}
