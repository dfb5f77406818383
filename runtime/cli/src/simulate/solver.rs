//! What both kinds of equations have: what may be given, and the motion from it.

use carvallo::simulation::Force;

use super::force::{Channel, forces};
use super::initial::{Givable, Initial, initial};
use super::motion::Motion;
use super::options::Options;
use crate::design::Design;
use crate::failure::{Failure, Problem};

/// The equations of motion of a design, at a speed.
pub trait Solver {
    /// What an initial state is given by.
    fn givable(&self) -> &[Givable];

    /// The forces that may act.
    fn channels(&self) -> &[Channel];

    /// The motion at a forward speed in m/s and times in s, the first of which is zero.
    ///
    /// # Errors
    /// If there is none.
    fn run<'a>(&self, design: &'a Design, given: &Given, speed: f64, times: &[f64]) -> Result<Motion<'a>, Failure>;
}

/// What a motion begins with, and what acts on it, in the orders of a [`Solver`].
pub struct Given {
    pub initial: Initial,
    pub forces: Vec<Force>,
}

/// What is given: the initial state, and the forces until the end of the motion.
///
/// # Errors
/// Everything that is wrong with the options.
pub fn read(solver: &dyn Solver, design: &Design, options: &Options, duration: f64) -> Result<Given, Vec<Problem>> {
    let model = design.info().name;
    let state = initial(&options.initial, solver.givable(), model);
    match (state, forces(&options.force, solver.channels(), duration, model)) {
        (Ok(initial), Ok(forces)) => Ok(Given { initial, forces }),
        (state, forces) => Err(state.err().into_iter().chain(forces.err()).flatten().collect()),
    }
}
