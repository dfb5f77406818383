//! What JSON and TOML have in common: names with values, lists and tables, and what they mean in a file of parameters.

use super::document::{Document, Entry, FEEDBACK, Written};
use super::matrices;
use super::names::is_part;
use crate::failure::Place;

/// What the output of an analysis, or of the sensitivity, holds besides the parameters; correlations are read before these.
const RESULTS: [&str; 12] = [
    "speed_unit",
    "matrices",
    "matrix_standard_deviations",
    "critical_speeds",
    "stable_ranges",
    "undecided_ranges",
    "eigenvalues",
    "correlations",
    // Of an optimum.
    "goal",
    "varied",
    "constraints",
    "search",
];

/// What outputs of motions, turns and control hold besides them, and of an analysis along a parameter.
#[cfg(feature = "full")]
const MORE_RESULTS: [&str; 27] = [
    "equations",
    "excitation",
    "rate_units",
    "acceleration_units",
    "feedback_force_units",
    "contact_force_unit",
    "energy_unit",
    "end",
    "rows",
    "families",
    "speed",
    "states",
    "inputs",
    "outputs",
    "A",
    "B",
    "C",
    "D",
    "weights",
    "regulators",
    "unstable_between",
    "transfer_functions",
    "singular_values",
    "lost",
    "along",
    "range",
    "critical_values",
];

/// What may stand before the parameters.
#[cfg(feature = "full")]
const HEADINGS: [&str; 8] =
    ["name", "bicycle", "kind", "source", "model", "feedback", "parameterization", "correlations"];

/// A name with its value and what is in that.
#[derive(Debug)]
pub struct Named {
    /// The name.
    pub name: String,
    /// What it names.
    pub node: Node,
}

/// A value with what is in it, as it was written.
#[derive(Debug)]
pub struct Node {
    /// Where it stands.
    pub place: Place,
    /// What it is.
    pub value: Value,
}

/// What a node is.
#[derive(Debug)]
pub enum Value {
    /// In quotes.
    Text(String),
    /// By its digits.
    Number(String),
    /// In brackets.
    List(Vec<Node>),
    /// In the order of the file.
    Table(Vec<Named>),
    /// What has no place in a file of parameters, in words: `a boolean`.
    Other(&'static str),
}

/// What a format calls its parts.
pub struct Words {
    /// The group of the parameters.
    pub parameters: &'static str,
    pub table: &'static str,
    pub table_without_value: &'static str,
}

impl Document {
    /// Takes everything in a file, with the parameters in a group of their own, or matrices in one, or all at its top.
    pub fn take_all(&mut self, members: Vec<Named>, words: &Words) {
        let is_table = |name: &str| {
            members.iter().any(|member| member.name == name && matches!(member.node.value, Value::Table(_)))
        };
        let has_parameters = is_table("parameters");
        let has_matrices = !has_parameters && is_table("matrices");
        let mut group = Vec::new();
        for Named { name, node: Node { place, value } } in members {
            match value {
                Value::Text(text) if self.take_heading(&name, &text) || self.take_law(&name, &place, &text) => {}
                Value::List(laws) if name == FEEDBACK => self.take_laws(laws),
                Value::Text(text) if name == "parameterization" => self.parameterization = Some((place, text)),
                Value::Text(text) if !has_parameters && matrices::is_text(&name, &text) => {
                    self.take_matrix_text(&name, &text, &|_| place.clone());
                }
                Value::Table(inner) if has_parameters && name == "parameters" || has_matrices && name == "matrices" => {
                    group.extend(inner);
                }
                value if matrices::is_part(&name, &value, has_parameters) => {
                    self.parts.push(Named { name, node: Node { place, value } });
                }
                Value::Table(_) if name == "measurements" => {
                    self.problem(place, "these are measurements; `carvallo measure` makes parameters of such a file")
                }
                #[cfg(feature = "full")]
                Value::Table(inner) if has_parameters && name == "correlations" => self.correlations = inner,
                _ if has_parameters && RESULTS.contains(&name.as_str()) => {}
                #[cfg(feature = "full")]
                _ if has_parameters && MORE_RESULTS.contains(&name.as_str()) => {}
                // Of results; a text is meant for the parameters, which it does not change.
                #[cfg(feature = "full")]
                Value::Table(_) if has_parameters && name == "units" => {}
                _ if has_parameters => {
                    let message = format!("`{name}` stands outside of {}", words.parameters);
                    #[cfg(feature = "full")]
                    let message = match crate::nearest(&name, HEADINGS) {
                        Some(meant) => format!("{message}; did you mean `{meant}`?"),
                        None => message,
                    };
                    self.problem(place, message);
                }
                value => self.take(name, place, value, words),
            }
        }
        for Named { name, node } in group {
            let text = match &node.value {
                Value::Text(text) if has_matrices && matrices::is_text(&name, text) => Some(text),
                _ => None,
            };
            if let Some(text) = text {
                self.take_matrix_text(&name, text, &|_| node.place.clone());
            } else if has_matrices && matrices::is_part(&name, &node.value, false) {
                self.parts.push(Named { name, node });
            } else {
                self.take(name, node.place, node.value, words);
            }
        }
        self.finish_matrices(words);
    }

    fn take_laws(&mut self, laws: Vec<Node>) {
        for Node { place, value } in laws {
            match value {
                Value::Text(text) => self.feedback.push((place, text)),
                _ => self.problem(place, "`feedback` has laws in quotes, such as [\"Tdelta = -10*phi_rate\"]"),
            }
        }
    }

    /// A parameter by its value, or by a table with that and others: `{ value = …, std = …, unit = … }`; or those of a part that has
    /// its own, as attributes: `rear.m`.
    fn take(&mut self, name: String, place: Place, value: Value, words: &Words) {
        match value {
            Value::Table(members) if is_part(&name) && members.iter().all(|member| member.name != "value") => {
                for Named { name: own, node } in members {
                    self.take(format!("{name}.{own}"), node.place, node.value, words);
                }
            }
            value => {
                let entry = self.entry_of(name, place, value, words);
                self.entries.push(entry);
            }
        }
    }

    /// The same, without taking it.
    pub fn entry_of(&mut self, name: String, place: Place, value: Value, words: &Words) -> Entry {
        match value {
            Value::Text(text) => Entry::from_text(&name, place, &text),
            Value::Table(members) => {
                let members = members.into_iter().map(|member| (member.name, member.node.value.written(words)));
                self.entry_of_members(name, place, members, words.table_without_value)
            }
            value => Entry::new(name, place, value.written(words), None),
        }
    }
}

/// Of a format that has one value a line.
impl From<Entry> for Named {
    fn from(Entry { name, place, value, .. }: Entry) -> Self {
        let value = match value {
            Written::Text(text) => Value::Text(text),
            Written::Other(what) => Value::Other(what),
        };
        Self { name, node: Node { place, value } }
    }
}

impl Value {
    /// As the value of a parameter.
    pub fn written(self, words: &Words) -> Written {
        match self {
            Self::Text(text) | Self::Number(text) => Written::Text(text),
            Self::List(_) => Written::Other("an array"),
            Self::Table(_) => Written::Other(words.table),
            Self::Other(what) => Written::Other(what),
        }
    }
}
