//! States of many motions in blocks, and in lanes.

use fearless_simd::Simd;

use super::super::{BatchError, Blocks, InLanes, Lanes, side};
use crate::model::{Evaluator, Model, Nonlinear};
use crate::motion::{Motion, MotionInfo, Unchecked, Vector};

/// The equations of a model in lanes.
pub(super) type InLanesOf<S, const N: usize, M> = <M as Nonlinear<N>>::MotionOver<Lanes<S, <M as Model<N>>::Scalar>>;

/// What the motion of a model is described by.
pub(super) const fn info<const N: usize, M: Nonlinear<N>>() -> &'static MotionInfo {
    <M::Motion as Motion>::INFO
}

impl<T: InLanes> Blocks<T> {
    /// Room for the states of `len` motions and the forces in them: all positions, then speeds, then applied forces, in the order
    /// of [`MotionInfo`](crate::motion::MotionInfo). All of them are zero.
    #[must_use]
    pub fn for_states<const N: usize, M: Nonlinear<N, Scalar = T>>(len: usize) -> Self {
        Self::zeros(width_of_states(info::<N, M>()), len)
    }

    /// Room for the accelerations of all positions in `len` states.
    #[must_use]
    pub fn for_accelerations<const N: usize, M: Nonlinear<N, Scalar = T>>(len: usize) -> Self {
        Self::zeros(info::<N, M>().positions.len(), len)
    }

    /// Room for the derivatives of `len` states: the rates of all positions, then those of the speeds.
    #[must_use]
    pub fn for_motion_derivatives<const N: usize, M: Nonlinear<N, Scalar = T>>(len: usize) -> Self {
        Self::zeros(info::<N, M>().positions.len() + info::<N, M>().speeds.len(), len)
    }
}

pub(super) fn width_of_states(info: &MotionInfo) -> usize {
    info.positions.len() + info.speeds.len() + info.forces.len()
}

/// Whether there are parameters of one design or of one for each state, and a number for each position, speed and force.
pub(super) fn check<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
    parameters: &Blocks<M::Scalar>,
    states: &Blocks<M::Scalar>,
) -> Result<(), BatchError> {
    let (model, info) = (M::INFO, info::<N, M>());
    for (what, expected, found) in [
        ("parameters", model.parameters.len(), parameters.width()),
        ("positions, speeds and forces", width_of_states(info), states.width()),
    ] {
        if expected != found {
            return Err(BatchError::Columns { model: model.name, what, expected, found });
        }
    }
    match parameters.len() {
        designs if designs != 1 && designs != states.len() => {
            Err(BatchError::Designs { designs, states: states.len() })
        }
        _ => Ok(()),
    }
}

/// The equations of designs, by the numbers of their parameters.
#[inline(always)]
pub(super) fn motion<S: Simd, const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
    parameter: impl FnMut(usize) -> Lanes<S, M::Scalar>,
) -> InLanesOf<S, N, M> {
    M::motion_over(&M::Over::<Lanes<S, M::Scalar>>::from_parameters(parameter))
}

/// Positions, speeds and forces, of the numbers of a state.
pub(super) type Parts<U> = (<U as Unchecked>::Positions, <U as Unchecked>::Speeds, <U as Unchecked>::Forces);

#[inline(always)]
pub(super) fn parts<U: Unchecked>(info: &MotionInfo, number: impl Fn(usize) -> U::Scalar) -> Parts<U> {
    let [positions, speeds] = [info.positions.len(), info.speeds.len()];
    (
        Vector::from_fn(&number),
        Vector::from_fn(
            #[inline(always)]
            |place| number(positions + place),
        ),
        Vector::from_fn(
            #[inline(always)]
            |place| number(positions + speeds + place),
        ),
    )
}

/// States one after the other, as they lie in blocks.
pub(super) struct States<'a, const N: usize, M: Nonlinear<N>> {
    numbers: &'a mut [M::Scalar],
}

impl<'a, const N: usize, M: Nonlinear<N, Scalar: InLanes>> States<'a, N, M> {
    /// Of whole blocks.
    pub fn new(numbers: &'a mut [M::Scalar]) -> Self {
        Self { numbers }
    }

    fn place(state: usize, position: usize) -> usize {
        let side = side::<M::Scalar>();
        (state / side * width_of_states(info::<N, M>()) + position) * side + state % side
    }

    pub fn get(&self, state: usize) -> Parts<M::Motion> {
        parts::<M::Motion>(info::<N, M>(), |position| self.numbers[Self::place(state, position)])
    }

    /// Writes positions, and speeds behind them.
    pub fn set(&mut self, state: usize, numbers: impl Iterator<Item = M::Scalar>) {
        numbers.enumerate().for_each(|(position, number)| self.numbers[Self::place(state, position)] = number);
    }
}
