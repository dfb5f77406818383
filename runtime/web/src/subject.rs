//! The design that a question is about: what ships, or the text of a file, with values that replace those in it.

use carvallo_design::input::{self, Request};
use carvallo_design::{Design, Failure};
use serde::Deserialize;

/// A design as a page knows it: a model and a set that ship for it, or the name of a file, whose ending tells the format, and
/// what is in it.
#[derive(Deserialize)]
pub struct Subject {
    model: Option<String>,
    set: Option<String>,
    label: Option<String>,
    text: Option<String>,
    /// Names of parameters with their values, in the spelling of files: `1.02`, `102 cm`, `pi/10`.
    changes: Vec<(String, String)>,
    /// What it is called, instead of what the file or the list says.
    name: Option<String>,
}

impl Subject {
    /// Reads and judges the parameters.
    ///
    /// # Errors
    /// Everything that is wrong with them.
    pub fn load(&self) -> Result<Design, Failure> {
        // The place that a message begins with.
        let place = |(name, value): &(String, String)| (format!("{name} = {value}"), name.clone(), value.clone());
        let overrides: Vec<_> = self.changes.iter().map(place).collect();
        let design = match (&self.label, &self.text) {
            (Some(label), Some(text)) => input::read_changed(label, text.clone().into_bytes(), &overrides),
            _ => input::load(&Request {
                model: self.model.clone(),
                parameters: self.set.clone(),
                overrides,
                ..Request::default()
            }),
        };
        let design = design?;
        Ok(match &self.name {
            Some(name) => Design { name: name.clone(), ..design },
            None => design,
        })
    }
}
