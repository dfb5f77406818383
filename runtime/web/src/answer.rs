//! The questions, and what answers each.

use carvallo_design::Failure;
use serde::Serialize;

use crate::motion::Asked;
use crate::question::{Question, missing};
use crate::subject::Subject;
use crate::{catalogue, eigenvalues, files, kept, motion};

/// What is answered.
#[derive(Debug, Default)]
pub struct Answer {
    /// JSON: what was asked for, or an object with the one member `error`.
    pub text: String,
    /// What the text counts, in its order.
    pub numbers: Vec<f64>,
}

#[derive(Serialize)]
struct Error {
    error: String,
}

/// Answers a question, JSON in UTF-8. What may be asked, as `ask`, is one of
///
/// - `catalogue`: the models that are there, with their parameters and sets;
/// - `analyze`: everything about a `design` along speed;
/// - `eigenvalues`: those of a `design` at one `speed` in m/s;
/// - `simulate`: a `motion` of a `design`;
/// - `write`: a `file` of a `design`, as the command line writes it.
pub fn answer(question: &[u8]) -> Answer {
    let mut numbers = Vec::new();
    let text = Question::read(question).and_then(|question| reply(question, &mut numbers));
    let text = text.unwrap_or_else(|failure| {
        numbers.clear();
        json(&Error { error: failure.to_string() }).unwrap_or_default()
    });
    Answer { text, numbers }
}

fn reply(mut question: Question, numbers: &mut Vec<f64>) -> Result<String, Failure> {
    let ask = question.text("ask")?.ok_or_else(|| missing("ask"))?;
    if ask == "catalogue" {
        return json(&catalogue::catalogue());
    }
    let design = question.object("design")?.ok_or_else(|| missing("design"))?;
    let analysis = kept::analysis(Subject::read(design)?)?;
    let motion = question.object("motion")?.map(Asked::read).transpose()?;
    match ask.as_str() {
        "analyze" => json(&eigenvalues::tell(&analysis, numbers)?),
        "eigenvalues" => {
            let speed = question.number("speed")?.ok_or_else(|| missing("speed"))?;
            json(&eigenvalues::at(&analysis, speed)?)
        }
        "simulate" => json(&motion::simulate(&analysis.design, &motion.ok_or_else(|| missing("motion"))?, numbers)?),
        "write" => {
            let file = question.text("file")?.ok_or_else(|| missing("file"))?;
            json(&files::write(&analysis, &file, motion.as_ref())?)
        }
        _ => Err(Failure::usage(format!("nothing answers `{ask}`"))),
    }
}

fn json(value: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string(value).map_err(|error| Failure::Run(error.to_string()))
}
