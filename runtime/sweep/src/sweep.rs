//! A sweep from its plan to its end.

use carvallo_design::units::Units;
use carvallo_design::{Design, Failure};
use carvallo_plot::picture::Scene;

use crate::destination::Destination;
use crate::map::Map;
use crate::pipeline;
use crate::plan::Plan;
use crate::request::Request;
use crate::source::Batches;

/// A sweep that can begin: what it reads and writes is open.
pub struct Sweep<'a> {
    design: &'a Design,
    plan: &'a Plan,
    batches: Batches<'a>,
    destination: Destination,
    map: Option<Map>,
    units: Units,
}

/// What came of a sweep.
#[derive(Debug)]
pub struct Outcome {
    /// How many designs there are.
    pub designs: u64,
    /// How many of them were done before, by a sweep that was interrupted.
    pub done: u64,
    /// How many were computed now.
    pub computed: usize,
    /// How many have no results.
    pub errors: u64,
    /// The map, if one was asked for.
    pub map: Option<Scene>,
}

impl<'a> Sweep<'a> {
    /// Opens what is read and written.
    ///
    /// # Errors
    /// If a file cannot be read, or may not or cannot be written.
    pub fn open(design: &'a Design, plan: &'a Plan, request: &Request) -> Result<Self, Failure> {
        let destination = Destination::open(request, plan)?;
        let batches = Batches::new(&plan.source)?;
        let (map, units) = (request.map.as_ref().map(|_| Map::default()), request.units.clone());
        Ok(Self { design, plan, batches, destination, map, units })
    }

    /// How many designs there are, where that is known before all are read.
    pub fn total(&self) -> Option<u64> {
        self.batches.total()
    }

    /// Whether the results go to the standard output.
    pub fn is_stdout(&self) -> bool {
        self.destination.is_stdout()
    }

    /// Computes all designs and writes their results in order; `None` if nobody reads the results any more. Of the designs
    /// only a few batches are in memory. From each core, `done` is told how many designs were computed just now.
    ///
    /// # Errors
    /// If a file cannot be read or written. Designs without an answer are no failure: their rows say why.
    pub fn run(self, done: &(dyn Fn(usize) + Sync)) -> Result<Option<Outcome>, Failure> {
        let Self { design, plan, batches, mut destination, mut map, units } = self;
        let before = destination.designs();
        let Some((designs, computed)) = pipeline::run(plan, batches, &mut destination, map.as_mut(), done)? else {
            return Ok(None);
        };
        let errors = destination.finish(plan)?;
        let map = map.map(|map| map.draw(design, plan, &units));
        Ok(Some(Outcome { designs, done: before.min(designs), computed, errors, map }))
    }
}
