//! What both kinds of equations have: what may be given, and the motion from it.

use std::ops::ControlFlow;

use carvallo::simulation::Force;
use carvallo_design::{Design, Failure, Problem};

use super::force::{Channel, forces};
use super::initial::{Givable, Initial};
use super::motion::Motion;
use super::watch::Watch;

/// The equations of motion of a design, at a speed.
pub trait Solver {
    /// What an initial state is given by.
    fn givable(&self) -> &[Givable];

    /// The forces that may act.
    fn channels(&self) -> &[Channel];

    /// Whether there is a forward speed to give.
    fn takes_speed(&self, design: &Design) -> bool {
        design.model.depends_on_speed()
    }

    /// The motion at a forward speed in m/s and times in s, the first of which is zero. What takes long tells how far it is, the
    /// time of the motion in s, and ends there if that breaks.
    ///
    /// # Errors
    /// If there is none.
    fn run<'a>(
        &self,
        design: &'a Design,
        given: &Given,
        speed: f64,
        times: &[f64],
        reach: &dyn Fn(f64) -> ControlFlow<()>,
    ) -> Result<Motion<'a>, Failure>;
}

/// What a motion begins with, and what acts on it, in the orders of a [`Solver`].
pub struct Given<'a> {
    /// The state at the beginning.
    pub initial: Initial,
    /// One for each channel.
    pub forces: Vec<Force>,
    /// What is watched for on the way; nothing, unless it is added.
    pub watches: Vec<Watch<'a>>,
}

/// What is given: the initial state, and the forces until the end of the motion.
///
/// # Errors
/// Everything that is wrong with the options.
pub fn read(
    solver: &dyn Solver,
    design: &Design,
    initial: &[String],
    force: &[String],
    duration: f64,
) -> Result<Given<'static>, Vec<Problem>> {
    let model = design.info().name;
    let state = super::initial::initial(initial, solver.givable(), model);
    match (state, forces(force, solver.channels(), duration, model)) {
        (Ok(initial), Ok(forces)) => Ok(Given { initial, forces, watches: Vec::new() }),
        (state, forces) => Err(state.err().into_iter().chain(forces.err()).flatten().collect()),
    }
}
