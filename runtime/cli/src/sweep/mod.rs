//! Many designs at once: from a plan to a table of their stability, and to a map of it.

mod args;
mod axis;
mod columns;
mod definition;
mod evaluate;
mod generate;
mod journal;
mod judge;
mod layout;
mod map;
mod plan;
mod progress;
mod random;
mod read;
mod store;
mod target;
mod write;

use std::time::Instant;

use anstyle::Style;
use rayon::prelude::*;

pub use self::args::{Request, command, request};

use self::evaluate::{Designs, Results};
use self::map::Map;
use self::plan::{Plan, Source};
use self::progress::Progress;
use self::read::{File, Records};
use self::target::Target;
use crate::failure::Failure;
use crate::input::{self, Design};
use crate::plot;
use crate::terminal::{WARNING, note};

/// The designs that one core computes before it looks for more: small enough for its cache.
const CHUNK: usize = 512;

/// Computes all designs and writes their results in order. Of the designs only a batch is in memory.
///
/// # Errors
/// Everything that is wrong with the request; and if a file cannot be read or written. Designs without an answer are no
/// failure: their rows say why.
pub fn run(design: Result<Design, Failure>, request: &Request) -> Result<(), Failure> {
    let design = design.map_err(|failure| with_options(failure, request))?;
    let plan = Plan::new(&design, request)?;
    request.map.as_deref().map(plot::check).transpose()?;
    let mut map = request.map.as_ref().map(|_| Map::new(&plan));
    let mut target = Target::open(request, &plan)?;
    let done = target.designs();
    let mut reader = Reader::new(&plan)?;
    let mut progress = Progress::new(reader.total, &target);
    let mut first = 0;
    loop {
        // Designs whose results are written are computed again only for a map.
        let is_written = first < done;
        let designs = reader.batch(first, plan.batch)?;
        let rows: usize = designs.iter().map(|designs| designs.rows).sum();
        if rows == 0 {
            break;
        }
        if !is_written || map.is_some() {
            let started = Instant::now();
            let compute = |designs: &Designs| {
                let results = (plan.task.evaluate)(&plan.task, designs);
                progress.add(designs.rows);
                results
            };
            let results: Vec<Results> = designs.par_iter().map(compute).collect();
            progress.computed(rows, started.elapsed());
            if let Some(map) = &mut map {
                results.iter().for_each(|results| map.add(results));
            }
            if !is_written && !target.write(&plan, designs, results)? {
                return Ok(());
            }
        } else {
            progress.add(rows);
        }
        first += rows as u64;
    }
    let errors = target.finish(&plan)?;
    progress.finish();
    if done > 0 {
        note(Style::new(), "resumed", &format!("{} of {first} designs were done", done.min(first)));
    }
    note(Style::new(), "computed", &progress.to_string());
    if errors > 0 {
        note(WARNING, "note", &format!("{errors} of {first} designs have no results; the column `error` says why"));
    }
    if let Some(path) = &request.output {
        note(Style::new(), "wrote", &path.display().to_string());
    }
    if let (Some(path), Some(map)) = (&request.map, map) {
        plot::save(&map.draw(&design, &plan), path)?;
        note(Style::new(), "wrote", &path.display().to_string());
    }
    Ok(())
}

/// What is wrong with the design, and with everything else as far as its model is known.
fn with_options(failure: Failure, request: &Request) -> Failure {
    let Failure::Input(mut problems) = failure else { return failure };
    let base = input::Request { overrides: Vec::new(), ..request.base.clone() };
    if let Ok(design) = input::load(&base)
        && let Err(Failure::Input(others)) = judge::judge(request, design.info())
    {
        problems.extend(others);
    }
    Failure::Input(problems)
}

/// The designs, one batch after the other.
struct Reader<'a> {
    source: &'a Source,
    records: Option<(&'a File, Records)>,
    /// How many there are, where that is known.
    total: Option<u64>,
}

impl<'a> Reader<'a> {
    fn new(plan: &'a Plan) -> Result<Self, Failure> {
        let source = &plan.source;
        Ok(match source {
            Source::Generated(generator) => Self { source, records: None, total: generator.total() },
            Source::File(file) => Self { source, records: Some((file, file.records()?)), total: None },
        })
    }

    /// At most so many designs from one on, in chunks; those of a file come in its order.
    fn batch(&mut self, first: u64, most: usize) -> Result<Vec<Designs>, Failure> {
        let chunks = (0..most).step_by(CHUNK);
        match (&mut self.records, self.source) {
            (Some((file, records)), _) => chunks.map(|start| file.designs(records, CHUNK.min(most - start))).collect(),
            (None, Source::Generated(generator)) => {
                let left = self.total.unwrap_or(0).saturating_sub(first).min(most as u64) as usize;
                let chunks: Vec<usize> = (0..left).step_by(CHUNK).collect();
                let designs = |&start: &usize| generator.designs(first + start as u64, CHUNK.min(left - start));
                Ok(chunks.par_iter().map(designs).collect())
            }
            (None, Source::File(_)) => Ok(Vec::new()),
        }
    }
}
