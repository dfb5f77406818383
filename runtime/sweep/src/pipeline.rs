//! Reading, computing and writing, all at the same time: each batch goes from one to the next, in order.

use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;

use carvallo_design::Failure;
use rayon::prelude::*;

use super::destination::Destination;
use super::map::Map;
use super::plan::Plan;
use super::source::Batches;
use super::table::{Designs, Results};

/// How many designs may wait between two of them: as many as a disk that is busy for a moment keeps waiting.
const WAITING: usize = 65_536;

/// Computes all designs, the results of which are not written yet, and for a map all; how many there are and how many were
/// computed, or `None` if nobody reads the results any more.
///
/// # Errors
/// If designs cannot be read or results cannot be written.
pub fn run(
    plan: &Plan,
    batches: Batches,
    destination: &mut Destination,
    mut map: Option<&mut Map>,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<Option<(u64, usize)>, Failure> {
    let done = destination.designs();
    let room = WAITING / plan.batch;
    let (to_compute, read) = sync_channel(room);
    let (to_write, computed) = sync_channel(room);
    let (mut first, mut count) = (0, 0);
    thread::scope(|scope| {
        scope.spawn(|| read_all(plan, batches, to_compute));
        let writer = scope.spawn(|| write_all(plan, destination, computed));
        let mut failure = None;
        for designs in read {
            let designs = match designs {
                Ok(designs) => designs,
                Err(error) => {
                    failure = Some(error);
                    break;
                }
            };
            // Designs whose results are written are computed again only for a map.
            let is_written = first < done;
            first += rows(&designs) as u64;
            if is_written && map.is_none() {
                progress(rows(&designs));
                continue;
            }
            let results = compute(plan, &designs, progress);
            count += rows(&designs);
            if let Some(map) = &mut map {
                results.iter().for_each(|results| map.add(results));
            }
            // Whoever does not take them says why at the end.
            if !is_written && to_write.send((designs, results)).is_err() {
                break;
            }
        }
        drop(to_write);
        let has_reader = writer.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))?;
        failure.map_or(Ok(has_reader.then_some((first, count))), Err)
    })
}

/// Ends where nobody wants more.
fn read_all(plan: &Plan, mut batches: Batches, to_compute: SyncSender<Result<Vec<Designs>, Failure>>) {
    let mut first = 0;
    loop {
        let designs = batches.next(first, plan.batch);
        let count = designs.as_ref().map_or(0, |designs| rows(designs));
        let is_over = designs.is_ok() && count == 0;
        // Nothing can be read after a failure.
        let is_last = designs.is_err();
        if is_over || to_compute.send(designs).is_err() || is_last {
            return;
        }
        first += count as u64;
    }
}

fn compute(plan: &Plan, designs: &[Designs], progress: &(dyn Fn(usize) + Sync)) -> Vec<Results> {
    let compute = |designs: &Designs| {
        let results = plan.task.evaluate(designs);
        progress(designs.rows);
        results
    };
    designs.par_iter().map(compute).collect()
}

/// Whether somebody reads the results to their end.
fn write_all(
    plan: &Plan,
    destination: &mut Destination,
    computed: Receiver<(Vec<Designs>, Vec<Results>)>,
) -> Result<bool, Failure> {
    for (designs, results) in computed {
        if !destination.write(plan, designs, results)? {
            return Ok(false);
        }
    }
    Ok(true)
}

fn rows(designs: &[Designs]) -> usize {
    designs.iter().map(|designs| designs.rows).sum()
}
