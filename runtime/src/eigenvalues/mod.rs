//! The eigenvalues of the equations of motion.

use crate::{Complex, System, SystemError};

impl System<2> {
    /// The four eigenvalues from the characteristic quartic, in 1/s, without allocation.
    ///
    /// # Errors
    /// As [`System::eigenvalues`], which is the same for N = 2.
    pub fn quartic_eigenvalues(&self) -> Result<[Complex<f64>; 4], SystemError> {
        todo!()
    }
}

#[cfg(feature = "std")]
impl<const N: usize> System<N> {
    /// The 2N eigenvalues in 1/s, sorted by real part, then by imaginary part.
    ///
    /// # Errors
    /// If an entry is not finite, if the mass matrix is singular, if an eigenvalue leaves the range of `f64`, or if the
    /// iteration for N other than 2 does not converge.
    pub fn eigenvalues(&self) -> Result<Vec<Complex<f64>>, SystemError> {
        todo!()
    }
}
