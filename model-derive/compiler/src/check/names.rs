//! What each name means; duplicates and names that are taken.

use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::formula::{Formula, Function};
use crate::nearest::{ask_for, find_nearest};
use crate::report::Report;
use crate::syntax::{Declaration, reserved};

/// What a name in a formula stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meaning {
    Parameter(usize),
    /// A position among the definitions: as they are declared, then in their order.
    Definition(usize),
    Coordinate,
    /// The forward speed, by a position behind all parameters.
    Speed(usize),
    /// Its statement could not be read, or it cannot be a name: what is reported already.
    Refused,
}

/// All names of a declaration.
#[derive(Debug)]
pub struct Scope {
    names: HashMap<String, Meaning>,
    /// In declared order, for suggestions.
    order: Vec<String>,
    /// Names that are not reported as unused: refused ones, and those suggested for an unknown one, so probably meant.
    pub excused: HashSet<String>,
    /// Definitions from this position on depend on the speed.
    pub steady: usize,
    /// What stands for the steady load of each wheel, where a formula may have it.
    pub loads: Option<Vec<(String, Formula)>>,
}

impl Scope {
    pub fn new(declaration: &Declaration, report: &mut Report) -> Self {
        let mut scope =
            Self { names: HashMap::new(), order: Vec::new(), excused: HashSet::new(), steady: usize::MAX, loads: None };
        for (index, parameter) in declaration.parameters.iter().enumerate() {
            scope.declare(&parameter.name, Meaning::Parameter(index), report);
        }
        if let Some(speed) = &declaration.speed {
            scope.declare(&speed.name, Meaning::Speed(declaration.parameters.len()), report);
        }
        for (index, definition) in declaration.definitions.iter().enumerate() {
            scope.declare(&definition.name, Meaning::Definition(index), report);
        }
        for coordinate in &declaration.coordinates {
            scope.declare(&coordinate.name, Meaning::Coordinate, report);
        }
        for name in &declaration.unread {
            scope.names.entry(name.to_string()).or_insert(Meaning::Refused);
        }
        scope
    }

    fn declare(&mut self, name: &Ident, meaning: Meaning, report: &mut Report) {
        let text = name.to_string();
        let refused = match text.as_str() {
            "pi" => Some("the name of the number π"),
            name if Function::from_name(name).is_some() => Some("the name of a function"),
            name => reserved(name),
        };
        if let Some(what) = refused {
            report.error(name, format!("`{text}` is {what}: expected another name"));
            self.names.entry(text.clone()).or_insert(Meaning::Refused);
            self.excused.insert(text);
        } else if self.names.contains_key(&text) {
            report.error(name, format!("`{text}` is declared twice: expected one declaration of each name"));
            self.excused.insert(text);
        } else {
            self.names.insert(text.clone(), meaning);
            self.order.push(text);
        }
    }

    /// Gives each definition another position.
    pub fn number_definitions(&mut self, positions: &[usize]) {
        for meaning in self.names.values_mut() {
            if let Meaning::Definition(position) = meaning {
                *position = positions[*position];
            }
        }
    }

    pub fn get(&self, name: &Ident) -> Option<Meaning> {
        self.names.get(&name.to_string()).copied()
    }

    /// "; did you mean `…`?" with the nearest name in formulas, if one is near.
    pub fn suggest(&mut self, name: &Ident) -> String {
        let usable = self.order.iter().filter(|known| self.names.get(*known) != Some(&Meaning::Coordinate));
        match find_nearest(&name.to_string(), usable.map(String::as_str)) {
            Some(known) => {
                self.excused.insert(known.to_string());
                ask_for(known)
            }
            None => String::new(),
        }
    }
}

/// What to say of a function that does not exist.
pub fn unknown_function(name: &str, known: &[&'static str]) -> String {
    let hint = find_nearest(name, known.iter().copied()).map(ask_for).unwrap_or_default();
    format!("unknown function `{name}`: expected one of {}{hint}", known.join(", "))
}
