//! The nonlinear equations of motion in many states.

use fearless_simd::{Simd, dispatch};

use super::super::{Batch, BatchError, Blocks, InLanes, Lanes, side};
use super::states::{InLanesOf, Parts, check, info, motion, parts, width_of_states};
use crate::model::Nonlinear;
use crate::motion::Unchecked;

/// For one core after the other: some ten microseconds of work.
#[cfg(feature = "rayon")]
const STATES: usize = 256;

impl Batch {
    /// The accelerations of all positions, from blocks of [states](Blocks::for_states) into blocks of
    /// [accelerations](Blocks::for_accelerations); the parameters are those of one design for all of them, or of one for each.
    ///
    /// They are those of [`Motion::accelerations`](crate::Motion::accelerations), to the last bit, but nothing is checked: in a
    /// state without any they are infinite or not a number. So they are where an input is.
    ///
    /// # Errors
    /// If the blocks do not have a number for each parameter, position, speed and force, or if they differ in length.
    pub fn accelerations<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
        &self,
        parameters: &Blocks<M::Scalar>,
        states: &Blocks<M::Scalar>,
        accelerations: &mut Blocks<M::Scalar>,
    ) -> Result<(), BatchError> {
        check::<N, M>(parameters, states)?;
        check_room::<N, M>(states, accelerations, info::<N, M>().positions.len())?;
        self.accelerate::<N, M>((parameters, 0), states.numbers(), accelerations.numbers_mut());
        Ok(())
    }

    /// As [`Batch::accelerations`], by all cores.
    ///
    /// # Errors
    /// As [`Batch::accelerations`].
    #[cfg(feature = "rayon")]
    pub fn parallel_accelerations<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
        &self,
        parameters: &Blocks<M::Scalar>,
        states: &Blocks<M::Scalar>,
        accelerations: &mut Blocks<M::Scalar>,
    ) -> Result<(), BatchError> {
        use rayon::prelude::*;

        check::<N, M>(parameters, states)?;
        check_room::<N, M>(states, accelerations, info::<N, M>().positions.len())?;
        let parts = states.parts(STATES).zip(accelerations.parts_mut(STATES)).enumerate();
        parts.for_each(|(part, (states, accelerations))| {
            self.accelerate::<N, M>((parameters, part * STATES), states, accelerations);
        });
        Ok(())
    }

    /// The rates of all positions and those of the speeds, from blocks of [states](Blocks::for_states) into blocks of
    /// [derivatives](Blocks::for_motion_derivatives); otherwise as [`Batch::accelerations`].
    ///
    /// They are those of [`Motion::derivatives`](crate::Motion::derivatives), to the last bit.
    ///
    /// # Errors
    /// As there.
    pub fn motion_derivatives<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
        &self,
        parameters: &Blocks<M::Scalar>,
        states: &Blocks<M::Scalar>,
        derivatives: &mut Blocks<M::Scalar>,
    ) -> Result<(), BatchError> {
        check::<N, M>(parameters, states)?;
        let info = info::<N, M>();
        check_room::<N, M>(states, derivatives, info.positions.len() + info.speeds.len())?;
        self.differentiate_motions::<N, M>((parameters, 0), states.numbers(), derivatives.numbers_mut());
        Ok(())
    }

    /// As [`Batch::motion_derivatives`], by all cores.
    ///
    /// # Errors
    /// As [`Batch::motion_derivatives`].
    #[cfg(feature = "rayon")]
    pub fn parallel_motion_derivatives<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
        &self,
        parameters: &Blocks<M::Scalar>,
        states: &Blocks<M::Scalar>,
        derivatives: &mut Blocks<M::Scalar>,
    ) -> Result<(), BatchError> {
        use rayon::prelude::*;

        check::<N, M>(parameters, states)?;
        let info = info::<N, M>();
        check_room::<N, M>(states, derivatives, info.positions.len() + info.speeds.len())?;
        let parts = states.parts(STATES).zip(derivatives.parts_mut(STATES)).enumerate();
        parts.for_each(|(part, (states, derivatives))| {
            self.differentiate_motions::<N, M>((parameters, part * STATES), states, derivatives);
        });
        Ok(())
    }

    /// The accelerations in whole blocks of states, with the parameters of one design or of those from one on.
    fn accelerate<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
        &self,
        parameters: (&Blocks<M::Scalar>, usize),
        states: &[M::Scalar],
        accelerations: &mut [M::Scalar],
    ) {
        let width = info::<N, M>().positions.len();
        dispatch!(self.level, simd => each::<_, N, M>(simd, parameters, states, (accelerations, width),
            #[inline(always)]
            |motion, (q, u, f), mut place| place.store(0, motion.accelerations_unchecked(&q, &u, &f).as_ref())
        ));
    }

    /// The rates of positions and speeds in whole blocks of states, with the parameters of one design or of those from one on.
    fn differentiate_motions<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
        &self,
        parameters: (&Blocks<M::Scalar>, usize),
        states: &[M::Scalar],
        derivatives: &mut [M::Scalar],
    ) {
        let [positions, speeds] = [info::<N, M>().positions.len(), info::<N, M>().speeds.len()];
        dispatch!(self.level, simd => each::<_, N, M>(simd, parameters, states, (derivatives, positions + speeds),
            #[inline(always)]
            |motion, (q, u, f), mut place| {
                let (rates, accelerations) = motion.derivatives_unchecked(&q, &u, &f);
                place.store(0, rates.as_ref());
                place.store(positions, accelerations.as_ref());
            }
        ));
    }
}

fn check_room<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
    states: &Blocks<M::Scalar>,
    results: &Blocks<M::Scalar>,
    expected: usize,
) -> Result<(), BatchError> {
    if expected != results.width() {
        let found = results.width();
        return Err(BatchError::Columns { model: M::INFO.name, what: "results", expected, found });
    }
    BatchError::require_room("result", states.len(), results.len())
}

/// Where the results of some lanes go.
struct Place<'a, T> {
    /// A block.
    results: &'a mut [T],
    /// The first of the designs in it.
    first: usize,
}

impl<T: InLanes> Place<'_, T> {
    /// Stores results from a position on.
    #[inline(always)]
    fn store<S: Simd>(&mut self, from: usize, found: &[Lanes<S, T>]) {
        for (place, result) in self.results.chunks_exact_mut(side::<T>()).skip(from).zip(found) {
            result.store(&mut place[self.first..][..Lanes::<S, T>::COUNT]);
        }
    }
}

/// Computes something in each state of whole blocks, with the parameters of one design or of those from one on.
#[inline(always)]
fn each<S: Simd, const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
    simd: S,
    (parameters, from): (&Blocks<M::Scalar>, usize),
    states: &[M::Scalar],
    (results, width): (&mut [M::Scalar], usize),
    compute: impl Fn(&InLanesOf<S, N, M>, Parts<InLanesOf<S, N, M>>, Place<M::Scalar>),
) {
    let lanes = Lanes::<S, M::Scalar>::COUNT;
    let side = side::<M::Scalar>();
    let is_of_one = parameters.len() == 1;
    let common = is_of_one.then(|| motion::<S, N, M>(|position| Lanes::splat(simd, parameters.get(0, position))));
    let inputs = side * parameters.width();
    let [numbers, outputs] = [width_of_states(info::<N, M>()), width].map(|width| (side * width).max(1));
    let blocks = states.chunks_exact(numbers).zip(results.chunks_exact_mut(outputs));
    for (number, (states, results)) in blocks.enumerate() {
        let block = from / side + number;
        for first in (0..side).step_by(lanes) {
            let motion = common.unwrap_or_else(
                #[inline(always)]
                || {
                    let parameters = &parameters.numbers()[block * inputs..][..inputs];
                    motion::<S, N, M>(
                        #[inline(always)]
                        |position| Lanes::load(simd, &parameters[position * side + first..][..lanes]),
                    )
                },
            );
            let state = parts::<InLanesOf<S, N, M>>(
                info::<N, M>(),
                #[inline(always)]
                |place| Lanes::load(simd, &states[place * side + first..][..lanes]),
            );
            compute(&motion, state, Place { results: &mut *results, first });
        }
    }
}
