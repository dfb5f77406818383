//! The eigenvalues of the equations of motion.

mod characteristic;
mod factors;
#[cfg(feature = "batch")]
mod four;
#[cfg(feature = "std")]
mod francis;
#[cfg(feature = "std")]
mod general;
#[cfg(feature = "std")]
mod hessenberg;
mod quadratic;
mod quartic;
mod resolvent;

use nalgebra::Complex;

use crate::system::{System, SystemError};

#[cfg(feature = "batch")]
pub(crate) use characteristic::{Rows, quick_eigenvalues};
#[cfg(feature = "batch")]
pub(crate) use four::Four;
pub(crate) use quartic::Quartic;

impl System<2> {
    /// The four eigenvalues in 1/s, sorted by real part, then by imaginary part; without allocation.
    ///
    /// They are the roots of the characteristic quartic `det(M s^2 + C s + K)`. Real ones have an imaginary part of
    /// exactly zero, and complex ones come in pairs that are exactly conjugate. Jointly they belong to a quartic whose
    /// coefficients differ from the given one by a few units in the last place of the terms that they are summed from;
    /// close to a double eigenvalue that leaves about half of the digits.
    ///
    /// ```
    /// use carvallo::{Complex, Matrix, System};
    ///
    /// // q1'' + 2 q1' + 5 q1 = 0 and q2'' - 4 q2 = 0.
    /// let system = System {
    ///     m: Matrix::<f64, 2>::identity(),
    ///     c: Matrix::<f64, 2>::new(2.0, 0.0, 0.0, 0.0),
    ///     k: Matrix::<f64, 2>::new(5.0, 0.0, 0.0, -4.0),
    /// };
    /// let expected = [(-2.0, 0.0), (-1.0, -2.0), (-1.0, 2.0), (2.0, 0.0)].map(|(re, im)| Complex::new(re, im));
    /// for (eigenvalue, expected) in system.quartic_eigenvalues()?.into_iter().zip(expected) {
    ///     assert!((eigenvalue - expected).norm() < 1e-15);
    /// }
    /// # Ok::<(), carvallo::SystemError>(())
    /// ```
    ///
    /// # Errors
    /// If an entry is not finite, if the mass matrix is singular, or if an eigenvalue leaves the range of `f64`.
    pub fn quartic_eigenvalues(&self) -> Result<[Complex<f64>; 4], SystemError> {
        let [[s0, s1], [t0, t1]] = self.factored_eigenvalues()?;
        let mut sorted = [s0, s1, t0, t1];
        // Both halves are in order already; merge them.
        for [i, j] in [[0, 2], [1, 3], [1, 2]] {
            if precedes(sorted[j], sorted[i]) {
                sorted.swap(i, j);
            }
        }
        Ok(sorted)
    }
}

#[inline]
fn precedes(x: Complex<f64>, y: Complex<f64>) -> bool {
    x.re < y.re || (x.re == y.re && x.im < y.im)
}
