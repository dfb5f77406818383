//! The formulas of a model, all of them compiled to trees, and what becomes of the matrices when some are changed.

mod values;

use std::fmt;

use carvallo::{Expression, FormulaInfo, FormulaSubject, MatrixName, ModelInfo};

use crate::places::{entry_name, index};
use crate::units::{Dimension, Units};

pub use self::values::{Change, Values};

/// What a formula is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The definition of this name.
    Definition(&'static str),
    /// The same where attributes of a mechanism use it.
    OfMechanism(&'static str),
    /// An attribute of a mechanism, in words.
    Attribute(&'static str),
    /// An entry of a matrix, with its row and column from zero.
    Entry(MatrixName, usize, usize),
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Definition(name) | Self::Attribute(name) => f.write_str(name),
            Self::OfMechanism(name) => write!(f, "{name} of the mechanism"),
            Self::Entry(matrix, row, column) => f.write_str(&entry_name(matrix, row, column)),
        }
    }
}

/// One formula of a model.
#[derive(Clone, Debug)]
pub struct Formula {
    /// What it is of.
    pub subject: Subject,
    /// As `carvallo equations` prints it.
    pub text: &'static str,
    /// The entries that have the same formula, this one among them; empty for definitions.
    pub shared: Vec<usize>,
    /// Whether slips in it are tried: not in what is derived from attributes.
    pub is_tried: bool,
    /// Whether it is an attribute of a mechanism, or stands between these and the matrices.
    pub is_of_mechanism: bool,
    expression: Expression,
    unit: Option<Dimension>,
}

/// The formulas of a model: the definitions, each in those before it, then every entry of the matrices that it has.
///
/// Beside them may be those by the attributes of a mechanism, which share nothing with them but the parameters: a change in either
/// makes the matrices.
#[derive(Clone, Debug)]
pub struct Formulas {
    /// All of them.
    pub formulas: Vec<Formula>,
    /// Parameters and definitions, as they are declared.
    pub names: Vec<&'static str>,
    /// How many coordinates there are.
    pub count: usize,
    /// How many of the formulas are definitions: the first ones.
    pub definitions: usize,
    /// Parameters and definitions in formulas by the attributes of a mechanism.
    names_of_mechanism: Vec<&'static str>,
    /// How many of these a mechanism is declared in.
    declared: usize,
    parameters: usize,
    /// Of each definition the formulas that depend on it, in their order.
    dependents: Vec<Vec<usize>>,
    /// Of each formula itself, or of one by attributes of a mechanism the other one of the same entry.
    twins: Vec<usize>,
    units: Units,
}

impl Formulas {
    /// Those of a model.
    ///
    /// # Errors
    /// That it has none, or the one that cannot be read.
    pub fn new(info: &ModelInfo) -> Result<Self, String> {
        Self::with_attributes(info, &[])
    }

    /// The same, and beside them those by the attributes of a mechanism with these parameters, as [`ModelInfo::attributes`] has
    /// them of a model that is one.
    ///
    /// # Errors
    /// As there.
    pub fn with_attributes(info: &ModelInfo, attributes: &[FormulaInfo]) -> Result<Self, String> {
        if info.formulas.is_empty() {
            return Err(format!("the model {} has no formulas", info.name));
        }
        let (count, parameters) = (info.coordinates.len(), info.parameters.len());
        let names = |formulas: &[FormulaInfo]| -> Vec<&'static str> {
            let parameters = info.parameters.iter().map(|parameter| parameter.name);
            parameters.chain(formulas.iter().filter_map(name_of)).collect()
        };
        let is_attribute = |formula: &FormulaInfo| matches!(formula.of, FormulaSubject::Attribute { .. });
        let before = attributes.iter().position(is_attribute).unwrap_or_default();
        let (names, names_of_mechanism) = (names(info.formulas), names(attributes));
        let definitions = names.len() + names_of_mechanism.len() - 2 * parameters;
        let mut own = Self {
            formulas: Vec::new(),
            names,
            count,
            definitions,
            names_of_mechanism,
            declared: parameters + before,
            parameters,
            dependents: Vec::new(),
            twins: Vec::new(),
            units: Units::new(info, attributes),
        };
        for (formulas, is_of_mechanism) in [(info.formulas, false), (attributes, true)] {
            for (at, formula) in formulas.iter().enumerate() {
                let subject = match formula.of {
                    FormulaSubject::Definition(name) if at < before && is_of_mechanism => Subject::OfMechanism(name),
                    FormulaSubject::Definition(name) => Subject::Definition(name),
                    FormulaSubject::Attribute { what, .. } => Subject::Attribute(what),
                    FormulaSubject::Entry(_) => continue,
                };
                let is_tried = !is_of_mechanism || !matches!(subject, Subject::Definition(_));
                own.push(subject, [formula.text, formula.unit], is_tried, is_of_mechanism)?;
            }
        }
        own.push_entries(info)?;
        for FormulaInfo { of, unit, text } in attributes {
            let FormulaSubject::Entry(entry) = of else { continue };
            for &(matrix, row, column) in entry.places {
                own.push(Subject::Entry(matrix, row, column), [text, unit], false, true)?;
            }
        }
        own.dependents = own.find_dependents();
        let twin = |(at, formula): (usize, &Formula)| match formula.subject {
            Subject::Entry(..) => own.formulas.iter().position(|other| other.subject == formula.subject),
            _ => Some(at),
        };
        own.twins = own.formulas.iter().enumerate().filter_map(twin).collect();
        Ok(own)
    }

    /// In the order of the matrices, with the entries that are zero, which may be mistaken, too.
    fn push_entries(&mut self, info: &ModelInfo) -> Result<(), String> {
        let count = self.count;
        let mut texts = vec![None; MatrixName::ALL.len() * count * count];
        for (at, FormulaInfo { of, unit, text }) in info.formulas.iter().enumerate() {
            let FormulaSubject::Entry(entry) = of else { continue };
            for &(matrix, row, column) in entry.places {
                texts[index(matrix, row, column, count)] = Some((at, *text, *unit));
            }
        }
        let mut groups: Vec<(usize, Vec<usize>)> = Vec::new();
        for &matrix in info.matrices {
            for (row, column) in (0..count * count).map(|place| (place / count, place % count)) {
                let text = texts[index(matrix, row, column, count)];
                let (formula, unit) = text.map_or(("0", ""), |(_, text, unit)| (text, unit));
                self.push(Subject::Entry(matrix, row, column), [formula, unit], true, false)?;
                let last = self.formulas.len() - 1;
                match (text, groups.iter_mut().find(|(group, _)| Some(*group) == text.map(|(at, ..)| at))) {
                    (Some(_), Some((_, members))) => members.push(last),
                    (Some((at, ..)), None) => groups.push((at, vec![last])),
                    (None, _) => self.formulas[last].shared.push(last),
                }
            }
        }
        for (_, members) in groups {
            members.iter().for_each(|&member| self.formulas[member].shared.clone_from(&members));
        }
        Ok(())
    }

    fn push(
        &mut self,
        subject: Subject,
        [text, unit]: [&'static str; 2],
        is_tried: bool,
        is_of_mechanism: bool,
    ) -> Result<(), String> {
        let expression = self.parse_in(is_of_mechanism, text).ok_or_else(|| format!("`{text}` is no formula"))?;
        let unit = Dimension::parse(unit).filter(|_| !unit.is_empty());
        // What makes no sense as it is, as a number with a unit, tells nothing of what is changed in it.
        let unit = unit.filter(|unit| self.units.fit(&expression, *unit));
        self.formulas.push(Formula { subject, text, shared: Vec::new(), is_tried, is_of_mechanism, expression, unit });
        Ok(())
    }

    /// The tree of another text in the place of a formula; `None` if it is none.
    pub fn parse(&self, formula: usize, text: &str) -> Option<Expression> {
        self.parse_in(self.formulas[formula].is_of_mechanism, text)
    }

    fn parse_in(&self, is_of_mechanism: bool, text: &str) -> Option<Expression> {
        let (names, behind) = match is_of_mechanism {
            true => (&self.names_of_mechanism, self.names.len() - self.parameters),
            false => (&self.names, 0),
        };
        let name = |name: &str| {
            let position = names.iter().position(|known| *known == name)?;
            Some(match position.checked_sub(self.parameters) {
                None => Expression::Parameter(position),
                Some(definition) => Expression::Definition(behind + definition),
            })
        };
        Expression::new(&carvallo::Formula::parse(text)?, &name)
    }

    /// The names that somebody may have in a formula: those of parameters and definitions, of which attributes of a mechanism have
    /// the declared ones.
    pub fn names_in(&self, formula: usize) -> &[&'static str] {
        match self.formulas[formula].is_of_mechanism {
            true => &self.names_of_mechanism[..self.declared],
            false => &self.names,
        }
    }

    /// Whether a formula was derived from a mechanism, so that nobody declares it.
    pub fn is_derived(&self, formula: usize) -> bool {
        let Formula { subject, is_of_mechanism, .. } = &self.formulas[formula];
        let declared = &self.names_of_mechanism[self.parameters.min(self.declared)..self.declared];
        let is_declared = matches!(subject, Subject::Definition(name) if declared.contains(name));
        self.names_of_mechanism.len() > self.parameters && !is_of_mechanism && !is_declared
    }

    /// Whether a formula could be this one by the units in it, as far as these are known.
    pub fn makes_sense(&self, formula: usize, text: &Expression) -> bool {
        self.formulas[formula].unit.is_none_or(|unit| self.units.fit(text, unit))
    }

    fn find_dependents(&self) -> Vec<Vec<usize>> {
        let uses: Vec<Vec<usize>> = self.formulas.iter().map(|formula| definitions_of(&formula.expression)).collect();
        let dependents = |definition: usize| {
            let mut found: Vec<usize> = Vec::new();
            for (at, uses) in uses.iter().enumerate().skip(definition + 1) {
                if uses.contains(&definition) || uses.iter().any(|used| found.contains(used)) {
                    found.push(at);
                }
            }
            found
        };
        (0..self.definitions).map(dependents).collect()
    }

    /// The formulas that depend on one, without it.
    pub fn dependents(&self, formula: usize) -> &[usize] {
        self.dependents.get(formula).map_or(&[], Vec::as_slice)
    }

    /// Whether one formula is another, or that depends on it; of an entry also by attributes of a mechanism.
    pub fn feeds(&self, formula: usize, other: usize) -> bool {
        self.twins[formula] == other || self.dependents(formula).iter().any(|&own| self.twins[own] == other)
    }

    /// The formula of an entry.
    pub fn entry(&self, matrix: MatrixName, row: usize, column: usize) -> Option<usize> {
        self.formulas.iter().position(|own| own.subject == Subject::Entry(matrix, row, column))
    }

    /// What some formulas are of: `IAzz`, `M_12`, or `M_12 and M_21`.
    pub fn subject(&self, formulas: &[usize]) -> String {
        let names = formulas.iter().map(|&at| self.formulas[at].subject.to_string());
        names.collect::<Vec<_>>().join(" and ")
    }

    /// Whether one of some formulas would depend on itself if it had this text.
    pub fn is_circular(&self, formulas: &[usize], text: &Expression) -> bool {
        formulas.iter().any(|&formula| self.uses(text, formula))
    }

    /// Whether a text uses a formula, or what depends on it.
    pub fn uses(&self, text: &Expression, formula: usize) -> bool {
        definitions_of(text).iter().any(|&used| self.feeds(formula, used))
    }
}

/// The name of a definition or attribute in other formulas.
fn name_of(formula: &FormulaInfo) -> Option<&'static str> {
    match formula.of {
        FormulaSubject::Definition(name) | FormulaSubject::Attribute { name, .. } => Some(name),
        FormulaSubject::Entry(_) => None,
    }
}

fn definitions_of(expression: &Expression) -> Vec<usize> {
    let mut found = Vec::new();
    expression.each_definition(&mut |definition| found.push(definition));
    found
}
