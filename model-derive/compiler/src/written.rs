//! The formulas of a model as people read them.

use std::fmt;

use crate::check::{Checked, Units};
use crate::derivation::{Attributes, Derived};
use crate::equations::Equations;
use crate::formula::{Formula, Names};
use crate::matrix_name::MatrixName;
use crate::model::Matrices;
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
    /// An attribute of a mechanism by its name in other formulas, with what it is in words.
    Attribute(String, String),
    /// The entries of a matrix that have it, by rows and columns from zero.
    Entries(MatrixName, Vec<[usize; 2]>),
}

/// The definitions that the matrices depend on, each in those before it, and the entries that are not zero: as they are
/// declared, or as they are derived.
pub fn write_formulas(checked: &Checked<'_>, derived: &Derived, units: &Units) -> Vec<Written> {
    let declaration = checked.declaration;
    let Derived { definitions, names, matrices, states, fed, .. } = derived;
    let declared = |matrix: MatrixName, row: usize, column: usize| {
        let declared = declaration.matrices.iter().find(|declared: &&Matrix| declared.name == matrix);
        let declared = declared.filter(|_| !fed.contains(&(matrix, row, column)));
        declared.map(|declared| declared.rows[row].1[column].to_string())
    };
    let writer = Writer { checked, definitions, names, units, states };
    let mut formulas = writer.definitions(matrices, &[]);
    formulas.extend(writer.entries(matrices, declared));
    formulas
}

/// The same by the attributes of a mechanism.
pub fn write_attributes(
    checked: &Checked<'_>,
    Attributes { definitions, names, whats, matrices }: &Attributes,
    states: &[States],
) -> Vec<Written> {
    let units = &checked.units.with_derived(definitions);
    let parameters = checked.declaration.parameters.iter().map(|parameter| parameter.name.clone()).collect();
    let names = &Names { parameters, definitions: names.clone() };
    let writer = Writer { checked, definitions, names, units, states };
    let mut formulas = writer.definitions(matrices, whats);
    formulas.extend(writer.entries(matrices, |_, _, _| None));
    formulas
}

struct Writer<'a> {
    checked: &'a Checked<'a>,
    definitions: &'a [Formula],
    names: &'a Names,
    units: &'a Units,
    states: &'a [States],
}

impl Writer<'_> {
    fn text(&self, formula: &Formula) -> String {
        self.names.text_in_order(formula).to_string()
    }

    /// Those that the matrices depend on, and attributes that only a nonlinear motion depends on; behind those of the declaration are the attributes of a mechanism, which are this.
    fn definitions(&self, matrices: &Matrices, whats: &[String]) -> Vec<Written> {
        let first = self.checked.definitions.len();
        let entries = matrices.iter().flat_map(|(_, rows)| rows.iter().flatten()).cloned();
        let attributes = (first..first + whats.len()).map(Formula::Definition);
        let needed = entries.chain(attributes).collect();
        let needed = Equations::of_formulas(self.checked.domains.len(), self.definitions, needed).origins;
        let written = needed.into_iter().map(|index| {
            let name = self.names.definitions[index].to_string();
            let what = index.checked_sub(first).and_then(|index| whats.get(index));
            Written {
                of: match what {
                    Some(what) => Of::Attribute(name, what.clone()),
                    None => Of::Definition(name),
                },
                unit: self.units.of_definition(index),
                text: match self.checked.order.get(index).filter(|_| index < first) {
                    Some(declared) => self.checked.declaration.definitions[*declared].value.to_string(),
                    None => self.text(&self.definitions[index]),
                },
            }
        });
        written.collect()
    }

    /// The entries that are not zero, those of one formula together.
    fn entries(
        &self,
        matrices: &Matrices,
        declared: impl Fn(MatrixName, usize, usize) -> Option<String>,
    ) -> Vec<Written> {
        let mut formulas = Vec::new();
        for (name, rows) in matrices {
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
                    unit: match self.states.get(row) {
                        Some(States::Position) => self.units.of(entry),
                        _ => self.units.of_entry(*name, row, column),
                    },
                    text: declared(*name, row, column).unwrap_or_else(|| self.text(entry)),
                }
            }));
        }
        formulas
    }
}

/// Reads `ITxz = IBxz + IHxz [kg*m^2]` or `M_12 = M_21 = IAlx + mu*ITxz [kg*m^2]`, as the runtime's `FormulaInfo` does.
impl fmt::Display for Written {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { of, unit, text } = self;
        match of {
            Of::Definition(name) | Of::Attribute(name, _) => write!(f, "{name} = ")?,
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
