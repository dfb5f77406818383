//! The eigenvalues of the equations of motion.

mod characteristic;
pub(crate) mod field;
#[cfg(feature = "batch")]
mod four;
#[cfg(feature = "std")]
mod francis;
#[cfg(feature = "std")]
mod general;
#[cfg(feature = "std")]
mod hessenberg;
mod quartic;
mod resolvent;

use crate::system::require_finite;
use crate::{Complex, System, SystemError};

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

#[cfg(feature = "std")]
impl<const N: usize> System<N> {
    /// The 2N eigenvalues in 1/s, sorted by real part, then by imaginary part.
    ///
    /// For N = 2 they are [those of the quartic](System::quartic_eigenvalues), and for N = 1 those of the quadratic. For
    /// more they come from the state matrix, balanced, by the QR algorithm with a bound on its iterations; jointly they are
    /// the exact ones of a state matrix that differs from the given one by rounding, relative to its norm. There, too, real
    /// ones have an imaginary part of exactly zero and pairs are exactly conjugate. Without any damping they are the square
    /// roots of the eigenvalues of -M^-1 K: what oscillates then has a real part of exactly zero. Stability along speed is
    /// for N = 2 alone.
    ///
    /// # Errors
    /// If an entry is not finite, if the mass matrix is singular, if an eigenvalue leaves the range of `f64`, or if the
    /// iteration for N other than 2 does not converge.
    pub fn eigenvalues(&self) -> Result<Vec<Complex<f64>>, SystemError> {
        if N == 2 {
            let two = |matrix: &crate::Matrix<f64, N>| crate::Matrix::<f64, 2>::from_fn(|i, j| matrix[(i, j)]);
            let system = System { m: two(&self.m), c: two(&self.c), k: two(&self.k) };
            return Ok(system.quartic_eigenvalues()?.to_vec());
        }
        let mut eigenvalues = general::eigenvalues(self)?.as_flattened().to_vec();
        eigenvalues.sort_by(|x, y| x.re.total_cmp(&y.re).then(x.im.total_cmp(&y.im)));
        Ok(eigenvalues)
    }
}

impl<const N: usize> System<N> {
    /// Whether every entry is finite.
    pub(crate) fn require_finite(&self) -> Result<(), SystemError> {
        for (quantity, matrix) in [("M", &self.m), ("C", &self.c), ("K", &self.k)] {
            matrix.iter().try_for_each(|&entry| require_finite(quantity, entry))?;
        }
        Ok(())
    }
}

#[inline]
fn precedes(x: Complex<f64>, y: Complex<f64>) -> bool {
    x.re < y.re || (x.re == y.re && x.im < y.im)
}
