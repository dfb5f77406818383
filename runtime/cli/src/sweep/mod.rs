//! Many designs at once: from a plan to a table of their stability, and to a map of it.

mod options;
mod progress;

use anstyle::Style;
use carvallo_design::{Failure, input};
use carvallo_sweep::{Plan, Request, Sweep};

pub use self::options::Options;

use self::progress::Progress;
use crate::picture;
use crate::terminal::{WARNING, note, wrote};

/// Computes all designs and writes their results in order.
///
/// # Errors
/// Everything that is wrong with the request; and if a file cannot be read or written. Designs without an answer are no
/// failure: their rows say why.
pub fn run(options: &Options) -> Result<(), Failure> {
    let request = options.request()?;
    let design = options.base.load().map_err(|failure| with_request(failure, &request))?;
    let plan = Plan::new(&design, &request)?;
    for text in plan.warnings() {
        note(WARNING, "warning", text);
    }
    for text in plan.notes() {
        note(WARNING, "note", &text);
    }
    let sweep = Sweep::open(&design, &plan, &request)?;
    let progress = Progress::new(sweep.total(), sweep.is_stdout());
    let Some(outcome) = sweep.run(&|designs| progress.add(designs))? else {
        return Ok(());
    };
    progress.finish();
    if outcome.done > 0 {
        note(Style::new(), "resumed", &format!("{} of {} designs were done", outcome.done, outcome.designs));
    }
    note(Style::new(), "computed", &progress.summary(outcome.computed));
    if outcome.errors > 0 {
        let (errors, designs) = (outcome.errors, outcome.designs);
        note(WARNING, "note", &format!("{errors} of {designs} designs have no results; the column `error` says why"));
    }
    if let Some(path) = &request.output {
        wrote(path);
    }
    if let (Some(path), Some(map)) = (&request.map, &outcome.map) {
        picture::save(map, path)?;
        wrote(path);
    }
    Ok(())
}

/// What is wrong with the design, and with everything else as far as its model is known.
fn with_request(failure: Failure, request: &Request) -> Failure {
    let Failure::Input(mut problems) = failure else { return failure };
    let base = input::Request { overrides: Vec::new(), feedback: Vec::new(), ..request.base.clone() };
    if let Ok(design) = input::load(&base)
        && let Err(Failure::Input(others)) = request.check(design.model)
    {
        problems.extend(others);
    }
    Failure::Input(problems)
}
