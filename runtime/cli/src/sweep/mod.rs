//! Many designs at once: from a plan to a table of their stability, and to a map of it.

mod destination;
mod evaluate;
mod generate;
mod map;
mod options;
mod pipeline;
mod plan;
mod progress;
mod read;
mod source;
mod table;
mod write;

use anstyle::Style;
use carvallo_design::{Failure, input};

pub use self::options::Options;

use self::destination::Destination;
use self::map::Map;
use self::plan::{Plan, validate};
use self::progress::Progress;
use self::source::Batches;
use crate::picture;
use crate::terminal::{WARNING, note, wrote};

/// Computes all designs and writes their results in order. Of the designs only a few batches are in memory.
///
/// # Errors
/// Everything that is wrong with the request; and if a file cannot be read or written. Designs without an answer are no
/// failure: their rows say why.
pub fn run(options: &Options) -> Result<(), Failure> {
    let design = options.base.load().map_err(|failure| with_options(failure, options))?;
    let plan = Plan::new(&design, options)?;
    options.map.as_deref().map(picture::check).transpose()?;
    let mut map = options.map.as_ref().map(|_| Map::default());
    let mut destination = Destination::open(options, &plan)?;
    let done = destination.designs();
    let batches = Batches::new(&plan.source)?;
    let mut progress = Progress::new(batches.total(), destination.is_stdout());
    let Some(first) = pipeline::run(&plan, batches, &mut destination, map.as_mut(), &mut progress)? else {
        return Ok(());
    };
    let errors = destination.finish(&plan)?;
    progress.finish();
    if done > 0 {
        note(Style::new(), "resumed", &format!("{} of {first} designs were done", done.min(first)));
    }
    note(Style::new(), "computed", &progress.to_string());
    if errors > 0 {
        note(WARNING, "note", &format!("{errors} of {first} designs have no results; the column `error` says why"));
    }
    if let Some(path) = &options.output {
        wrote(path);
    }
    if let (Some(path), Some(map)) = (&options.map, map) {
        picture::save(&map.draw(&design, &plan), path)?;
        wrote(path);
    }
    Ok(())
}

/// What is wrong with the design, and with everything else as far as its model is known.
fn with_options(failure: Failure, options: &Options) -> Failure {
    let Failure::Input(mut problems) = failure else { return failure };
    let base = input::Request { overrides: Vec::new(), feedback: Vec::new(), ..options.base.request() };
    if let Ok(design) = input::load(&base)
        && let Err(Failure::Input(others)) = validate(options, design.model)
    {
        problems.extend(others);
    }
    Failure::Input(problems)
}
