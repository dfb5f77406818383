//! What a mechanism that moves can do.

use super::close;
use super::error::MotionError;
use super::info::MotionInfo;
use super::vector::Vector;
use crate::number::{Number, Scalar};

/// The nonlinear equations of motion of a mechanism with its parameters.
///
/// All numbers are in SI units. Positions, rates of positions and their accelerations are arrays in the order of
/// [`MotionInfo::positions`]; speeds and what becomes of them in that of [`MotionInfo::speeds`]; forces in that of
/// [`MotionInfo::forces`], positive as the coordinate is that they act on.
///
/// Positions have to be such that every wheel touches the ground, as [`close`](Motion::close) makes them; how far they are
/// from that, so far are the results. Nothing here allocates, and no result is infinite or not a number.
///
/// ```text
/// let motion = bicycle.motion();
/// let positions = motion.close(&positions)?;
/// let (rates, accelerations) = motion.derivatives(&positions, &speeds, &forces)?;
/// ```
pub trait Motion: Unchecked<Scalar: Scalar> {
    /// Names, units, and which positions are free.
    const INFO: &'static MotionInfo;

    /// The positions with those that depend on the others such that every wheel touches the ground: what is given for
    /// these is where the search begins, so that it finds the solution that continues a motion.
    ///
    /// It is Newton's method with bounded steps, on the derived heights and their exact derivatives.
    ///
    /// # Errors
    /// If there is no such position near, or if something is not finite.
    fn close(&self, positions: &Self::Positions) -> Result<Self::Positions, MotionError> {
        finite(Self::INFO, "position", positions.as_ref(), |place| place)?;
        close::close(|positions| self.closure_unchecked(positions), Self::INFO, *positions)
    }

    /// The rates of all positions at given speeds: rolling determines those that are not speeds.
    ///
    /// # Errors
    /// If the state is singular, or if something is not finite.
    fn rates(&self, positions: &Self::Positions, speeds: &Self::Speeds) -> Result<Self::Positions, MotionError> {
        state(Self::INFO, positions.as_ref(), speeds.as_ref())?;
        valued("a rate", self.rates_unchecked(positions, speeds))
    }

    /// The speeds among the rates of all positions.
    #[must_use]
    fn speeds(&self, rates: &Self::Positions) -> Self::Speeds {
        Self::Speeds::from_fn(|speed| rates.as_ref()[Self::INFO.speeds[speed]])
    }

    /// The rates of all positions, and those of the speeds: what an integration takes.
    ///
    /// # Errors
    /// If the state is singular, or if something is not finite.
    fn derivatives(
        &self,
        positions: &Self::Positions,
        speeds: &Self::Speeds,
        forces: &Self::Forces,
    ) -> Result<(Self::Positions, Self::Speeds), MotionError> {
        state(Self::INFO, positions.as_ref(), speeds.as_ref())?;
        applied(Self::INFO, forces.as_ref())?;
        let (rates, accelerations) = self.derivatives_unchecked(positions, speeds, forces);
        Ok((valued("a rate", rates)?, valued("an acceleration", accelerations)?))
    }

    /// The second derivatives of all positions.
    ///
    /// # Errors
    /// If the state is singular, or if something is not finite.
    fn accelerations(
        &self,
        positions: &Self::Positions,
        speeds: &Self::Speeds,
        forces: &Self::Forces,
    ) -> Result<Self::Positions, MotionError> {
        state(Self::INFO, positions.as_ref(), speeds.as_ref())?;
        applied(Self::INFO, forces.as_ref())?;
        valued("an acceleration", self.accelerations_unchecked(positions, speeds, forces))
    }

    /// Kinetic energy, and potential energy of gravity and springs.
    ///
    /// # Errors
    /// If the state is singular, or if something is not finite.
    fn energy(&self, positions: &Self::Positions, speeds: &Self::Speeds) -> Result<Energy<Self::Scalar>, MotionError> {
        state(Self::INFO, positions.as_ref(), speeds.as_ref())?;
        let [kinetic, potential] = valued("the energy", self.energy_unchecked(positions, speeds))?;
        Ok(Energy { kinetic, potential })
    }

    /// For each wheel the force of the ground on it, along the axes of the ground: z is downward, so that of a wheel that
    /// stands on the ground is negative.
    ///
    /// Of wheels that share an axle the sideways force cannot be told apart: that of the first of them is all of it.
    ///
    /// # Errors
    /// If the state is singular, or if something is not finite.
    fn contact_forces(
        &self,
        positions: &Self::Positions,
        speeds: &Self::Speeds,
        forces: &Self::Forces,
    ) -> Result<Self::ContactForces, MotionError> {
        state(Self::INFO, positions.as_ref(), speeds.as_ref())?;
        applied(Self::INFO, forces.as_ref())?;
        let contact_forces = self.contact_forces_unchecked(positions, speeds, forces);
        let all = contact_forces.as_ref().iter().flatten().all(|force| force.is_finite());
        if all { Ok(contact_forces) } else { Err(MotionError::Singular { quantity: "a contact force" }) }
    }

    /// Writes A and B of [`Linearizable::linearize`](super::Linearizable::linearize) row by row; nothing for a model whose
    /// declaration does not say `derivatives;`.
    ///
    /// For code that takes any motion. What needs them takes a [`Linearizable`](super::Linearizable) one.
    ///
    /// # Errors
    /// As there.
    ///
    /// # Panics
    /// If there are not as many places as entries.
    fn linearize_into(
        &self,
        _positions: &Self::Positions,
        _speeds: &Self::Speeds,
        _forces: &Self::Forces,
        _a: &mut [Self::Scalar],
        _b: &mut [Self::Scalar],
    ) -> Option<Result<(), MotionError>> {
        None
    }
}

/// The straight-line programs behind [`Motion`], as they are generated: nothing is checked, and what has no value is
/// infinite or not a number.
pub trait Unchecked: Copy {
    /// What is computed in: `f32`, `f64`, or as many of them as a register holds.
    type Scalar: Number;
    /// An array with an element for each position.
    type Positions: Vector<Self::Scalar>;
    /// An array with an element for each speed.
    type Speeds: Vector<Self::Scalar>;
    /// An array with an element for each position that depends on others.
    type Dependent: Vector<Self::Scalar>;
    /// An array with an element for each applied force.
    type Forces: Vector<Self::Scalar>;
    /// An array with the force on each wheel.
    type ContactForces: Vector<[Self::Scalar; 3]>;

    /// How far the lowest points of the wheels behind the first are below the ground, in m, and what to add to the dependent
    /// positions by Newton's method.
    fn closure_unchecked(&self, positions: &Self::Positions) -> (Self::Dependent, Self::Dependent);

    /// See [`Motion::rates`].
    fn rates_unchecked(&self, positions: &Self::Positions, speeds: &Self::Speeds) -> Self::Positions;

    /// See [`Motion::derivatives`].
    fn derivatives_unchecked(
        &self,
        positions: &Self::Positions,
        speeds: &Self::Speeds,
        forces: &Self::Forces,
    ) -> (Self::Positions, Self::Speeds);

    /// See [`Motion::accelerations`].
    fn accelerations_unchecked(
        &self,
        positions: &Self::Positions,
        speeds: &Self::Speeds,
        forces: &Self::Forces,
    ) -> Self::Positions;

    /// Kinetic and potential energy.
    fn energy_unchecked(&self, positions: &Self::Positions, speeds: &Self::Speeds) -> [Self::Scalar; 2];

    /// See [`Motion::contact_forces`].
    fn contact_forces_unchecked(
        &self,
        positions: &Self::Positions,
        speeds: &Self::Speeds,
        forces: &Self::Forces,
    ) -> Self::ContactForces;
}

/// The energy of a mechanism in J.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy<T = f64> {
    /// Of the motion of all bodies; of what spins at a constant rate in one that of the body alone.
    pub kinetic: T,
    /// Of gravity, zero where the centre of mass is at the height of the ground, and of springs.
    pub potential: T,
}

pub(super) fn state<T: Scalar>(info: &MotionInfo, positions: &[T], speeds: &[T]) -> Result<(), MotionError> {
    finite(info, "position", positions, |place| place)?;
    finite(info, "rate", speeds, |speed| info.speeds[speed])
}

fn finite<T: Scalar>(
    info: &MotionInfo,
    what: &'static str,
    values: &[T],
    position: impl Fn(usize) -> usize,
) -> Result<(), MotionError> {
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(place) => {
            let name = info.positions[position(place)].name;
            Err(MotionError::NotFinite { name, what, value: values[place].to_f64() })
        }
    }
}

pub(super) fn applied<T: Scalar>(info: &MotionInfo, forces: &[T]) -> Result<(), MotionError> {
    match forces.iter().zip(info.forces).find(|(value, _)| !value.is_finite()) {
        None => Ok(()),
        Some((value, force)) => Err(MotionError::NotFinite { name: force.name, what: "force", value: value.to_f64() }),
    }
}

/// Results that are all finite.
pub(super) fn valued<T: Scalar, V: Vector<T>>(quantity: &'static str, values: V) -> Result<V, MotionError> {
    if values.as_ref().iter().all(|value| value.is_finite()) {
        Ok(values)
    } else {
        Err(MotionError::Singular { quantity })
    }
}
