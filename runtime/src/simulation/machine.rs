//! A mechanism that moves, whichever it is.

use nalgebra::DMatrix;

use crate::motion::{Energy, Linearization, Motion, MotionError, MotionInfo, Vector};

/// What has positions, and accelerations at a state and under forces: as much of a [`Machine`] as a [`State`](super::State) and a
/// [`Drive`](super::Drive) need.
///
/// Slices are as long as [`MotionInfo`] has positions, speeds and forces.
pub trait Moving {
    /// See [`Motion::INFO`].
    fn info(&self) -> &'static MotionInfo;

    /// See [`Motion::close`]; the positions are replaced.
    ///
    /// # Errors
    /// As there.
    fn close(&self, positions: &mut [f64]) -> Result<(), MotionError>;

    /// See [`Motion::rates`].
    ///
    /// # Errors
    /// As there.
    fn rates(&self, positions: &[f64], speeds: &[f64], rates: &mut [f64]) -> Result<(), MotionError>;

    /// See [`Motion::accelerations`].
    ///
    /// # Errors
    /// As there.
    fn accelerations(
        &self,
        positions: &[f64],
        speeds: &[f64],
        forces: &[f64],
        accelerations: &mut [f64],
    ) -> Result<(), MotionError>;
}

/// A [`Motion`] whose arrays are slices, so that what is done with it is compiled once for all of them, and machines of all
/// kinds go into one list. Every [`Motion`] in `f64` is one.
pub trait Machine: Moving {
    /// See [`Motion::derivatives`]: the rates of all positions, and those of the speeds.
    ///
    /// # Errors
    /// As there.
    fn derivatives(
        &self,
        positions: &[f64],
        speeds: &[f64],
        forces: &[f64],
        rates: &mut [f64],
        of_speeds: &mut [f64],
    ) -> Result<(), MotionError>;

    /// See [`Linearizable::linearize`](crate::motion::Linearizable::linearize): nothing for a model whose declaration does not
    /// say `derivatives;`, and without the feature `turns`.
    ///
    /// # Errors
    /// As there.
    fn linearize(
        &self,
        _positions: &[f64],
        _speeds: &[f64],
        _forces: &[f64],
    ) -> Option<Result<MachineLinearization, MotionError>> {
        None
    }

    /// See [`Motion::energy`].
    ///
    /// # Errors
    /// As there.
    fn energy(&self, positions: &[f64], speeds: &[f64]) -> Result<Energy, MotionError>;

    /// See [`Motion::contact_forces`].
    ///
    /// # Errors
    /// As there.
    fn contact_forces(&self, positions: &[f64], speeds: &[f64], forces: &[f64]) -> Result<Vec<[f64; 3]>, MotionError>;
}

/// The equations of any machine to first order, with as many rows and columns as it has positions and speeds, and forces.
pub type MachineLinearization = Linearization<DMatrix<f64>, DMatrix<f64>>;

fn array<V: Vector<f64>>(values: &[f64]) -> V {
    V::from_fn(|place| values[place])
}

impl<M: Motion<Scalar = f64>> Moving for M {
    fn info(&self) -> &'static MotionInfo {
        M::INFO
    }

    fn close(&self, positions: &mut [f64]) -> Result<(), MotionError> {
        positions.copy_from_slice(Motion::close(self, &array(positions))?.as_ref());
        Ok(())
    }

    fn rates(&self, positions: &[f64], speeds: &[f64], rates: &mut [f64]) -> Result<(), MotionError> {
        rates.copy_from_slice(Motion::rates(self, &array(positions), &array(speeds))?.as_ref());
        Ok(())
    }

    fn accelerations(
        &self,
        positions: &[f64],
        speeds: &[f64],
        forces: &[f64],
        accelerations: &mut [f64],
    ) -> Result<(), MotionError> {
        let found = Motion::accelerations(self, &array(positions), &array(speeds), &array(forces))?;
        accelerations.copy_from_slice(found.as_ref());
        Ok(())
    }
}

impl<M: Motion<Scalar = f64>> Machine for M {
    fn derivatives(
        &self,
        positions: &[f64],
        speeds: &[f64],
        forces: &[f64],
        rates: &mut [f64],
        of_speeds: &mut [f64],
    ) -> Result<(), MotionError> {
        let (of_positions, own) = Motion::derivatives(self, &array(positions), &array(speeds), &array(forces))?;
        rates.copy_from_slice(of_positions.as_ref());
        of_speeds.copy_from_slice(own.as_ref());
        Ok(())
    }

    #[cfg(feature = "turns")]
    fn linearize(
        &self,
        positions: &[f64],
        speeds: &[f64],
        forces: &[f64],
    ) -> Option<Result<MachineLinearization, MotionError>> {
        let states = positions.len() + speeds.len();
        // Rows are written one after the other, and matrices have columns so.
        let (mut a, mut b) = (DMatrix::zeros(states, states), DMatrix::zeros(forces.len(), states));
        let (to_a, to_b) = (a.as_mut_slice(), b.as_mut_slice());
        let done = self.linearize_into(&array(positions), &array(speeds), &array(forces), to_a, to_b)?;
        Some(done.map(|()| Linearization { a: a.transpose(), b: b.transpose() }))
    }

    fn energy(&self, positions: &[f64], speeds: &[f64]) -> Result<Energy, MotionError> {
        Motion::energy(self, &array(positions), &array(speeds))
    }

    fn contact_forces(&self, positions: &[f64], speeds: &[f64], forces: &[f64]) -> Result<Vec<[f64; 3]>, MotionError> {
        Ok(Motion::contact_forces(self, &array(positions), &array(speeds), &array(forces))?.as_ref().to_vec())
    }
}
