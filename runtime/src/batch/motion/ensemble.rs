//! Many motions in time.

use fearless_simd::dispatch;

use super::super::{Batch, BatchError, Blocks, InLanes};
use super::limits::Limit;
use super::run::run;
use super::states::{check, info};
use crate::model::Nonlinear;
use crate::motion::MotionError;

/// How motions are simulated: for how long, how well, and within which limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ensemble<'a> {
    /// For how long each motion is simulated, in s.
    pub duration: f64,
    /// How much each step may err, in the mean of all positions and speeds, relative to their size or, where it is less than
    /// 1, absolutely; no less than eight units in the last place are taken.
    pub tolerance: f64,
    /// A motion ends where a position leaves one of these.
    pub limits: &'a [Limit],
}

/// How a motion of an ensemble ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Arrival {
    /// After the whole time.
    Reached,
    /// Where a position left a limit.
    Left {
        /// The place of the limit among those of the ensemble.
        limit: usize,
        /// When, in s.
        time: f64,
    },
    /// The steps became ever smaller: beyond there the equations have no value or, in these coordinates, nearly none. A
    /// [`Simulation`](crate::simulation::Simulation) of the motion tells more, and goes on in others.
    Stopped {
        /// The last time that was reached, in s.
        time: f64,
    },
}

/// How a motion ended; an error where there is none from its state, or where there are no positions with all wheels on the
/// ground.
pub type Outcome = Result<Arrival, MotionError>;

impl Batch {
    /// Simulates motions from [states](Blocks::for_states), which become those at their ends, under forces that stay what
    /// they are; the parameters are those of one design for all of them, or of one for each.
    ///
    /// The equations are integrated by the method of Dormand and Prince of order 5, each motion with steps of its own, and
    /// ends are found on its polynomials of order 4 between steps. Where a motion has ended, the next one takes its lane. So
    /// each is what it would be alone, to the last bit. The positions that the heights of the wheels determine are made to do so
    /// at both ends, and by a step of Newton's method after each step; those of a state are where the search begins. The
    /// parameters are not validated.
    ///
    /// What takes controllers, forces that change, other events or what is between both ends is a
    /// [`Simulation`](crate::simulation::Simulation).
    ///
    /// # Errors
    /// If the blocks do not have a number for each parameter, position, speed and force, if they and the outcomes differ in
    /// length, or if the duration, the tolerance or a limit is none. Nothing is written then.
    pub fn simulate<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
        &self,
        ensemble: &Ensemble,
        parameters: &Blocks<M::Scalar>,
        states: &mut Blocks<M::Scalar>,
        outcomes: &mut [Outcome],
    ) -> Result<(), BatchError> {
        ensemble.check::<N, M>(parameters, states, outcomes)?;
        self.run::<N, M>(ensemble, (parameters, 0), states.numbers_mut(), outcomes);
        Ok(())
    }

    /// As [`Batch::simulate`], by all cores.
    ///
    /// # Errors
    /// As [`Batch::simulate`].
    #[cfg(feature = "rayon")]
    pub fn parallel_simulate<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
        &self,
        ensemble: &Ensemble,
        parameters: &Blocks<M::Scalar>,
        states: &mut Blocks<M::Scalar>,
        outcomes: &mut [Outcome],
    ) -> Result<(), BatchError> {
        use rayon::prelude::*;

        /// So many that the last ones, for which there are more lanes than motions, do not count.
        const MOTIONS: usize = 1024;
        ensemble.check::<N, M>(parameters, states, outcomes)?;
        let parts = states.parts_mut(MOTIONS).zip(outcomes.par_chunks_mut(MOTIONS)).enumerate();
        parts.for_each(|(part, (states, outcomes))| {
            self.run::<N, M>(ensemble, (parameters, part * MOTIONS), states, outcomes);
        });
        Ok(())
    }

    /// Simulates the motions of whole blocks, with the parameters of one design or of those from one on.
    fn run<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
        &self,
        ensemble: &Ensemble,
        parameters: (&Blocks<M::Scalar>, usize),
        states: &mut [M::Scalar],
        outcomes: &mut [Outcome],
    ) {
        dispatch!(self.level, simd => run::<_, N, M>(simd, ensemble, parameters, states, outcomes));
    }
}

impl Ensemble<'_> {
    fn check<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
        &self,
        parameters: &Blocks<M::Scalar>,
        states: &Blocks<M::Scalar>,
        outcomes: &[Outcome],
    ) -> Result<(), BatchError> {
        check::<N, M>(parameters, states)?;
        BatchError::require_room("outcome", states.len(), outcomes.len())?;
        let require = |is_met: bool, what, required, found| match is_met {
            true => Ok(()),
            false => Err(BatchError::Simulation { what, required, found }),
        };
        let is_positive = |number: f64| number > 0.0 && number.is_finite();
        require(is_positive(self.duration), "the duration in s", "a positive number", self.duration)?;
        require(is_positive(self.tolerance), "the tolerance", "a positive number", self.tolerance)?;
        for limit in self.limits {
            let place = limit.position;
            let is_there = place < info::<N, M>().positions.len();
            require(is_there, "the position of a limit", "the place of one of the positions", place as f64)?;
            require(limit.low < limit.high, "the lower end of a limit", "a number below its upper end", limit.low)?;
        }
        Ok(())
    }
}
