//! Many designs at once: from a plan to a table of their stability, and to a map of it.

mod destination;
mod evaluate;
mod generate;
mod map;
mod options;
pub mod parameter;
mod plan;
mod progress;
mod read;
mod source;
mod table;
mod write;

use std::time::Instant;

use anstyle::Style;
use rayon::prelude::*;

pub use self::options::Options;

use self::destination::Destination;
use self::map::Map;
use self::plan::{Plan, validate};
use self::progress::Progress;
use self::source::Batches;
use self::table::{Designs, Results};
use crate::failure::Failure;
use crate::terminal::{WARNING, note, wrote};
use crate::{input, plot};

/// Computes all designs and writes their results in order. Of the designs only a batch is in memory.
///
/// # Errors
/// Everything that is wrong with the request; and if a file cannot be read or written. Designs without an answer are no
/// failure: their rows say why.
pub fn run(options: &Options) -> Result<(), Failure> {
    let design = options.base.load().map_err(|failure| with_options(failure, options))?;
    let plan = Plan::new(&design, options)?;
    options.map.as_deref().map(plot::check).transpose()?;
    let mut map = options.map.as_ref().map(|_| Map::default());
    let mut destination = Destination::open(options, &plan)?;
    let done = destination.designs();
    let mut batches = Batches::new(&plan.source)?;
    let mut progress = Progress::new(batches.total(), destination.is_stdout());
    let mut first = 0;
    loop {
        // Designs whose results are written are computed again only for a map.
        let is_written = first < done;
        let designs = batches.next(first, plan.batch)?;
        let rows: usize = designs.iter().map(|designs| designs.rows).sum();
        if rows == 0 {
            break;
        }
        if !is_written || map.is_some() {
            let started = Instant::now();
            let compute = |designs: &Designs| {
                let results = plan.task.evaluate(designs);
                progress.add(designs.rows);
                results
            };
            let results: Vec<Results> = designs.par_iter().map(compute).collect();
            progress.computed(rows, started.elapsed());
            if let Some(map) = &mut map {
                results.iter().for_each(|results| map.add(results));
            }
            if !is_written && !destination.write(&plan, designs, results)? {
                return Ok(());
            }
        } else {
            progress.add(rows);
        }
        first += rows as u64;
    }
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
        plot::save(&map.draw(&design, &plan), path)?;
        wrote(path);
    }
    Ok(())
}

/// What is wrong with the design, and with everything else as far as its model is known.
fn with_options(failure: Failure, options: &Options) -> Failure {
    let Failure::Input(mut problems) = failure else { return failure };
    let base = input::Request { overrides: Vec::new(), ..options.base.request() };
    if let Ok(design) = input::load(&base)
        && let Err(Failure::Input(others)) = validate(options, design.model)
    {
        problems.extend(others);
    }
    Failure::Input(problems)
}
