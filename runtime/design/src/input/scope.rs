//! Values that refer to others by name, as in `I_Ryy = 2*I_Rxx`.

use std::cell::RefCell;
use std::collections::HashMap;

use carvallo::ModelInfo;

use super::document::{Entry, Written};
use super::names;
use crate::quantity::{self, Context, Mistake, Reason};

/// Values refer to others in chains of at most this length, so that no input can exhaust the stack.
const MAX_DEPTH: usize = 16;

/// The entries that can be referred to, each of which is read once.
pub struct Scope<'a> {
    info: &'static ModelInfo,
    entries: HashMap<String, &'a Entry>,
    /// Values that do not stand among the entries.
    others: HashMap<String, f64>,
    /// `None` while a value is being read.
    found: RefCell<HashMap<String, Option<Result<f64, String>>>>,
}

impl<'a> Scope<'a> {
    pub fn new(
        entries: impl IntoIterator<Item = &'a Entry>,
        others: HashMap<String, f64>,
        info: &'static ModelInfo,
    ) -> Self {
        let entries = entries.into_iter().map(|entry| (key(&entry.name, info), entry)).collect();
        Self { info, entries, others, found: RefCell::default() }
    }

    /// The value of a name, or what is wrong with it; `None` if there is no such entry.
    pub fn value(&self, name: &str) -> Option<Result<f64, String>> {
        let key = key(name, self.info);
        let Some(entry) = self.entries.get(&key) else { return self.others.get(&key).map(|value| Ok(*value)) };
        // The borrow ends before the entry is read, which may come back to here.
        let known = self.found.borrow().get(&key).cloned();
        match known {
            Some(Some(found)) => return Some(found),
            Some(None) => return Some(Err(format!("`{name}` refers to itself"))),
            None => {}
        }
        let depth = self.found.borrow().values().filter(|found| found.is_none()).count();
        if depth >= MAX_DEPTH {
            return Some(Err("values refer to others in too long a chain".to_owned()));
        }
        self.found.borrow_mut().insert(key.clone(), None);
        let found = self.read(entry);
        self.found.borrow_mut().insert(key, Some(found.clone()));
        Some(found)
    }

    fn read(&self, entry: &Entry) -> Result<f64, String> {
        let name = &entry.name;
        let Written::Text(text) = &entry.value else { return Err(format!("`{name}` is no number")) };
        // What is no parameter may be an angle in degrees, or a pure number.
        let position = names::position(name, self.info);
        let unit = position.map_or("rad", |position| self.info.parameters[position].unit);
        let lookup = |name: &str| self.value(name);
        match quantity::measured(text, Context { unit, names: &lookup }) {
            Ok(measured) => Ok(measured.mean.value),
            Err(Mistake { reason: Reason::Unit(unit), .. }) => Err(format!("`{unit}` is no unit for `{name}`")),
            Err(Mistake { reason: Reason::Other(reason), .. }) => Err(reason),
        }
    }

    /// Under what name an entry is kept.
    pub fn key(&self, name: &str) -> String {
        key(name, self.info)
    }

    /// Whether another value refers to it.
    pub fn is_used(&self, entry: &Entry) -> bool {
        self.found.borrow().contains_key(&key(&entry.name, self.info))
    }
}

/// The name of the parameter that is meant, or else the name itself.
fn key(name: &str, info: &ModelInfo) -> String {
    match names::position(name, info) {
        Some(position) => info.parameters[position].name.to_owned(),
        None => names::without_owner(name).to_owned(),
    }
}
