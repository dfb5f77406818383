//! The design that a question is about: what ships, or the text of a file, with values that replace those in it.

use carvallo_design::input::{self, Request};
use carvallo_design::{Design, Failure};

use crate::question::Question;

/// A design as a page knows it: a model and a set that ship for it, or the name of a file, whose ending tells the format, and
/// what is in it.
#[derive(PartialEq)]
pub struct Subject {
    model: Option<String>,
    set: Option<String>,
    label: Option<String>,
    text: Option<String>,
    /// Names of parameters with their values, in the spelling of files: `1.02`, `102 cm`, `pi/10`.
    changes: Vec<(String, String)>,
    /// Laws of feedback, such as `Tdelta = -10*phi_rate`; otherwise those of the file.
    feedback: Option<Vec<String>>,
    /// What it is called, instead of what the file or the list says.
    name: Option<String>,
}

impl Subject {
    /// What a question calls it.
    ///
    /// # Errors
    /// If something in it is of another kind.
    pub fn read(mut question: Question) -> Result<Self, Failure> {
        let changes = question.lists("changes")?.into_iter();
        Ok(Self {
            model: question.text("model")?,
            set: question.text("set")?,
            label: question.text("label")?,
            text: question.text("text")?,
            changes: changes
                .filter_map(|pair| <[String; 2]>::try_from(pair).ok())
                .map(<(String, String)>::from)
                .collect(),
            feedback: question.texts("feedback")?,
            name: question.text("name")?,
        })
    }

    /// Reads and judges the parameters.
    ///
    /// # Errors
    /// Everything that is wrong with them.
    pub fn load(&self) -> Result<Design, Failure> {
        // The place that a message begins with.
        let place = |(name, value): &(String, String)| (format!("{name} = {value}"), name.clone(), value.clone());
        let overrides: Vec<_> = self.changes.iter().map(place).collect();
        let law = |law: &String| (format!("feedback `{law}`"), law.clone());
        let feedback: Option<Vec<_>> = self.feedback.as_ref().map(|laws| laws.iter().map(law).collect());
        let design = match (&self.label, &self.text) {
            (Some(label), Some(text)) => {
                input::read_changed(label, text.clone().into_bytes(), &overrides, feedback.as_deref())
            }
            _ => {
                let (model, parameters) = (self.model.clone(), self.set.clone());
                let mut request = Request { model, parameters, overrides, ..Request::default() };
                request.feedback = feedback.unwrap_or_default();
                input::load(&request)
            }
        };
        let design = design?;
        Ok(match &self.name {
            Some(name) => Design { name: name.clone(), ..design },
            None => design,
        })
    }
}
