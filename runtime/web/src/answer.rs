//! The questions, and what answers each.

use carvallo_design::Failure;
use serde::{Deserialize, Serialize};

use crate::motion::Asked;
use crate::subject::Subject;
use crate::{catalogue, eigenvalues, files, motion};

/// What is answered.
#[derive(Debug, Default)]
pub struct Answer {
    /// JSON: what was asked for, or an object with the one member `error`.
    pub text: String,
    /// What the text counts, in its order.
    pub numbers: Vec<f64>,
}

/// What may be asked: one of
///
/// - `catalogue`: the models that are there, with their parameters and sets;
/// - `analyze`: everything about a design along speed, and the eigenvalues at one speed;
/// - `simulate`: a motion of a design;
/// - `write`: a file of a design, as the command line writes it.
#[derive(Deserialize)]
struct Question {
    ask: String,
    design: Option<Subject>,
    /// From where to where in m/s; otherwise as far as there is something to see.
    range: Option<[f64; 2]>,
    /// In m/s.
    speed: Option<f64>,
    motion: Option<Asked>,
    file: Option<String>,
}

#[derive(Serialize)]
struct Error {
    error: String,
}

/// Answers a question, JSON in UTF-8.
pub fn answer(question: &[u8]) -> Answer {
    let mut numbers = Vec::new();
    let text = match serde_json::from_slice(question) {
        Ok(question) => reply(question, &mut numbers),
        Err(error) => Err(Failure::Run(format!("this is no question: {error}"))),
    };
    let text = text.unwrap_or_else(|failure| {
        numbers.clear();
        json(&Error { error: failure.to_string() }).unwrap_or_default()
    });
    Answer { text, numbers }
}

fn reply(question: Question, numbers: &mut Vec<f64>) -> Result<String, Failure> {
    let Question { ask, design, range, speed, motion, file } = question;
    let missing = |what: &str| Failure::usage(format!("`{ask}` needs `{what}`"));
    let design = || design.as_ref().ok_or_else(|| missing("design"));
    match ask.as_str() {
        "catalogue" => json(&catalogue::catalogue()),
        "analyze" => json(&eigenvalues::analyze(design()?, range, speed, numbers)?),
        "simulate" => json(&motion::simulate(design()?, &motion.ok_or_else(|| missing("motion"))?, numbers)?),
        "write" => json(&files::write(design()?, &file.ok_or_else(|| missing("file"))?, motion.as_ref())?),
        _ => Err(Failure::usage(format!("nothing answers `{ask}`"))),
    }
}

fn json(value: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string(value).map_err(|error| Failure::Run(error.to_string()))
}
