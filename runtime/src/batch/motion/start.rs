//! Where a motion begins.

use super::super::{Blocks, InLanes};
use super::ensemble::{Arrival, Ensemble};
use super::states::States;
use super::steps::Point;
use crate::model::Nonlinear;
use crate::motion::{Motion, MotionError, Unchecked};
use crate::number::Scalar;

/// The equations of one of many designs.
fn motion_of<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
    parameters: &Blocks<M::Scalar>,
    design: usize,
) -> M::Motion {
    let parameters = M::array(|position| parameters.get(design, position));
    match M::from_slice(parameters.as_ref()) {
        Ok(model) => model.motion(),
        Err(_) => unreachable!("there are as many numbers as parameters"),
    }
}

/// Makes every wheel touch the ground in a state.
///
/// # Errors
/// Those of [`Motion::close`].
pub(super) fn close<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
    (parameters, design): (&Blocks<M::Scalar>, usize),
    states: &mut States<N, M>,
    place: usize,
) -> Result<(), MotionError> {
    let (positions, _, _) = states.get(place);
    let positions = motion_of::<N, M>(parameters, design).close(&positions)?;
    states.set(place, positions.as_ref().iter().copied());
    Ok(())
}

/// In the first step nothing moves by more than this part of its size or, where that is less than 1, of 1.
const FIRST: f64 = 1e-3;

/// The beginning of a motion, with all that there is before its first step.
pub(super) struct Start<const N: usize, M: Nonlinear<N>> {
    pub point: Point<M::Motion>,
    pub slope: Point<M::Motion>,
    pub forces: <M::Motion as Unchecked>::Forces,
    /// How long the first step is, in s.
    pub size: f64,
    /// Where it ends, if it is out of the limits from the beginning.
    pub arrival: Arrival,
}

impl<const N: usize, M: Nonlinear<N, Scalar: InLanes>> Start<N, M> {
    /// That of a state, with its positions such that every wheel touches the ground.
    ///
    /// # Errors
    /// Those of [`Motion`].
    pub fn new(
        ensemble: &Ensemble,
        (parameters, design): (&Blocks<M::Scalar>, usize),
        states: &States<N, M>,
        place: usize,
    ) -> Result<Self, MotionError> {
        let motion = motion_of::<N, M>(parameters, design);
        let (positions, speeds, forces) = states.get(place);
        let positions = motion.close(&positions)?;
        let (rates, accelerations) = motion.derivatives(&positions, &speeds, &forces)?;
        let point = Point { positions, speeds };
        let slope = Point { positions: rates, speeds: accelerations };
        let share = |(number, rate): (&M::Scalar, &M::Scalar)| rate.to_f64().abs() / number.to_f64().abs().max(1.0);
        let fastest = point.numbers().zip(slope.numbers()).map(share).fold(0.0, f64::max);
        let size = if fastest * ensemble.duration > FIRST { FIRST / fastest } else { ensemble.duration };
        let out = ensemble.limits.iter().position(|limit| limit.excludes(positions.as_ref()[limit.position].to_f64()));
        let arrival = out.map_or(Arrival::Reached, |limit| Arrival::Left { limit, time: 0.0 });
        Ok(Self { point, slope, forces, size, arrival })
    }
}
