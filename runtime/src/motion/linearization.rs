//! Nonlinear equations of motion to first order about any state.

use super::error::MotionError;
use super::traits::{Motion, Unchecked, applied, state, valued};
use super::vector::Vector;
use crate::number::Scalar;

/// The nonlinear equations of motion to first order about any state: what a declaration with `nonlinear;` and `derivatives;`
/// has.
///
/// Derivatives are exact, by the chain rule over the program of the equations, and are those **along motions that the
/// conditions leave**: positions that depend on others follow them, as [`close`](Motion::close) and
/// [`rates`](Motion::rates) have it. So a column for such a position is zero, and nothing but zero may be put into it.
///
/// Positions have to be such that every wheel touches the ground, as there. Nothing here allocates, and no result is infinite
/// or not a number.
///
/// ```text
/// let motion = bicycle.motion();
/// let Linearization { a, b } = motion.linearize(&positions, &speeds, &forces)?;
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not the motion of a model that was compiled with the derivatives of its nonlinear equations",
    label = "nonlinear equations without derivatives",
    note = "add `derivatives;` to its declaration, beside `nonlinear;`"
)]
pub trait Linearizable: Motion + UncheckedPartials {
    /// The equations about a state, which need not be one of equilibrium.
    ///
    /// # Errors
    /// If the state is singular, or if something is not finite.
    fn linearize(
        &self,
        positions: &Self::Positions,
        speeds: &Self::Speeds,
        forces: &Self::Forces,
    ) -> Result<Linearization<Self::ByState, Self::ByForces>, MotionError> {
        state(Self::INFO, positions.as_ref(), speeds.as_ref())?;
        applied(Self::INFO, forces.as_ref())?;
        let (a, b) = self.linearize_unchecked(positions, speeds, forces);
        Ok(Linearization { a: all_valued(a)?, b: all_valued(b)? })
    }

    /// The derivatives of the rates of all positions, and then of the rates of the speeds, with respect to the parameters of
    /// the model in their declared order: a row for each, in SI units. Free positions, speeds and forces stay what they are,
    /// and dependent positions follow.
    ///
    /// # Errors
    /// If the state is singular, or if something is not finite.
    fn by_parameters(
        &self,
        positions: &Self::Positions,
        speeds: &Self::Speeds,
        forces: &Self::Forces,
    ) -> Result<Self::ByParameters, MotionError> {
        state(Self::INFO, positions.as_ref(), speeds.as_ref())?;
        applied(Self::INFO, forces.as_ref())?;
        all_valued(self.by_parameters_unchecked(positions, speeds, forces))
    }
}

impl<M: Motion + UncheckedPartials> Linearizable for M {}

/// Equations of motion to first order about a state: x' = x0' + A (x - x0) + B (f - f0), where x are all positions and then all
/// speeds, and f are the forces.
///
/// Rows and columns are in the order of [`MotionInfo`](super::MotionInfo): of A the positions and behind them the speeds; of
/// B a row is one of these, and a column a force. All are in SI units, so an entry has the unit of the rate of its row by that
/// of its column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearization<A, B> {
    /// The derivatives of the rates of positions and speeds with respect to these.
    pub a: A,
    /// Those with respect to forces: of positions they are zero, and of speeds the inverse of the mass matrix, times what
    /// the forces drive of the speeds.
    pub b: B,
}

impl<A, B> Linearization<A, B> {
    /// Writes A and B row by row.
    ///
    /// # Panics
    /// If there are not as many places as entries.
    pub fn copy_into<T: Scalar, X: Vector<T>, F: Vector<T>>(&self, a: &mut [T], b: &mut [T])
    where
        A: Vector<X>,
        B: Vector<F>,
    {
        copy(&self.a, a);
        copy(&self.b, b);
    }
}

fn copy<T: Scalar, R: Vector<T>, M: Vector<R>>(rows: &M, to: &mut [T]) {
    let columns = rows.as_ref().first().map_or(0, |row| row.as_ref().len());
    assert_eq!(to.len(), rows.as_ref().len() * columns, "places for all entries");
    for (row, places) in rows.as_ref().iter().zip(to.chunks_mut(columns.max(1))) {
        places.copy_from_slice(row.as_ref());
    }
}

fn all_valued<T: Scalar, R: Vector<T>, M: Vector<R>>(rows: M) -> Result<M, MotionError> {
    rows.as_ref().iter().try_for_each(|row| valued("a derivative of an acceleration", *row).map(drop))?;
    Ok(rows)
}

/// What generated programs compute of [`Linearizable`], without looking at what they are given and at what comes out.
pub trait UncheckedPartials: Unchecked {
    /// An array with an element for each position and then for each speed.
    type State: Vector<Self::Scalar>;
    /// As many of these.
    type ByState: Vector<Self::State>;
    /// As many arrays with an element for each applied force.
    type ByForces: Vector<Self::Forces>;
    /// An array with an element for each parameter.
    type Parameters: Vector<Self::Scalar>;
    /// As many of these as there are positions and speeds.
    type ByParameters: Vector<Self::Parameters>;

    /// See [`Linearizable::linearize`].
    fn linearize_unchecked(
        &self,
        positions: &Self::Positions,
        speeds: &Self::Speeds,
        forces: &Self::Forces,
    ) -> (Self::ByState, Self::ByForces);

    /// See [`Linearizable::by_parameters`].
    fn by_parameters_unchecked(
        &self,
        positions: &Self::Positions,
        speeds: &Self::Speeds,
        forces: &Self::Forces,
    ) -> Self::ByParameters;
}
