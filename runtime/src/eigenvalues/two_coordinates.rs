//! The four eigenvalues of two coordinates, at any scale of the matrices.

use nalgebra::Complex;

use super::factors::Precision;
#[cfg(feature = "batch")]
use super::four::Four;
use super::quartic::Quartic;
use crate::characteristic::determinant::{Rows, coefficients, rows};
use crate::characteristic::units::{Units, to_per_second};
use crate::number::Scalar;
use crate::number::lane::Lane;
use crate::system::{System, SystemError};

impl<T: Scalar> System<2, T> {
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
    /// let system = System::new(
    ///     Matrix::<f64, 2>::identity(),
    ///     Matrix::<f64, 2>::new(2.0, 0.0, 0.0, 0.0),
    ///     Matrix::<f64, 2>::new(5.0, 0.0, 0.0, -4.0),
    /// );
    /// let expected = [(-2.0, 0.0), (-1.0, -2.0), (-1.0, 2.0), (2.0, 0.0)].map(|(re, im)| Complex::new(re, im));
    /// for (eigenvalue, expected) in system.quartic_eigenvalues()?.into_iter().zip(expected) {
    ///     assert!((eigenvalue - expected).norm() < 1e-15);
    /// }
    /// # Ok::<(), carvallo::SystemError>(())
    /// ```
    ///
    /// # Errors
    /// If an entry is not finite, if the mass matrix is singular, or if an eigenvalue leaves the range of `f64`.
    #[inline]
    pub fn quartic_eigenvalues(&self) -> Result<[Complex<f64>; 4], SystemError> {
        self.widened(sorted_eigenvalues_f64)
    }
}

impl System<2, f32> {
    /// The four eigenvalues, computed in `f32` throughout, for processors that have no `f64`: those of
    /// [`quartic_eigenvalues`](Self::quartic_eigenvalues), which computes in `f64`, in fewer digits.
    ///
    /// As there, they jointly belong to a quartic whose coefficients differ from the given one by a few units in the last place
    /// of the terms that they are summed from, here of `f32`. Those of the benchmark bicycle from 0 to 10 m/s err by up to
    /// 2e-6 times the largest, which is where two of them are about to meet; at a double eigenvalue half of the digits are
    /// left, that is three. Eigenvalues that are smaller than the largest by a factor of more than 1e9 have fewer digits, or are
    /// zero.
    ///
    /// ```
    /// use carvallo::{Matrix, System};
    ///
    /// // q1'' + 2 q1' + 5 q1 = 0 and q2'' - 4 q2 = 0.
    /// let system = System::new(
    ///     Matrix::<f32, 2>::identity(),
    ///     Matrix::<f32, 2>::new(2.0, 0.0, 0.0, 0.0),
    ///     Matrix::<f32, 2>::new(5.0, 0.0, 0.0, -4.0),
    /// );
    /// let [fast, .., growing] = system.quartic_eigenvalues_f32()?;
    /// assert!((fast.re + 2.0).abs() < 1e-6 && (growing.re - 2.0).abs() < 1e-6);
    /// # Ok::<(), carvallo::SystemError>(())
    /// ```
    ///
    /// # Errors
    /// If an entry is not finite, if the mass matrix is singular as far as `f32` can tell, or if an eigenvalue leaves the range
    /// of `f32`.
    pub fn quartic_eigenvalues_f32(&self) -> Result<[Complex<f32>; 4], SystemError> {
        sorted_eigenvalues(self)
    }
}

impl System<2> {
    /// The four eigenvalues as the roots of two quadratic factors: in each half two real ones, ascending, or a conjugate
    /// pair, the negative imaginary part first.
    #[cfg(feature = "std")]
    #[inline]
    pub(crate) fn factored_eigenvalues(&self) -> Result<[[Complex<f64>; 2]; 2], SystemError> {
        factored_eigenvalues(self)
    }
}

/// The four eigenvalues by quadratic factors, not sorted.
#[inline]
fn factored_eigenvalues<T: Precision>(system: &System<2, T>) -> Result<[[Complex<T>; 2]; 2], SystemError> {
    let [k, c, m] = [rows(&system.k), rows(&system.c), rows(&system.m)];
    // Without a branch for each entry.
    if are_moderate(m) & are_moderate(c) & are_moderate(k) {
        return regular_quartic(m, c, k)?.roots();
    }
    system.require_finite()?;
    scaled_eigenvalues(system)
}

/// Compiled once, here.
fn sorted_eigenvalues_f64(system: &System<2>) -> Result<[Complex<f64>; 4], SystemError> {
    sorted_eigenvalues(system)
}

/// The four eigenvalues, sorted.
#[inline]
fn sorted_eigenvalues<T: Precision>(system: &System<2, T>) -> Result<[Complex<T>; 4], SystemError> {
    let [[s0, s1], [t0, t1]] = factored_eigenvalues(system)?;
    // Both halves are in order already; merge them.
    let (first, t0) = ordered(s0, t0);
    let (s1, last) = ordered(s1, t1);
    let (second, third) = ordered(s1, t0);
    Ok([first, second, third, last])
}

#[inline]
fn ordered<T: PartialOrd>(x: Complex<T>, y: Complex<T>) -> (Complex<T>, Complex<T>) {
    if precedes(&y, &x) { (y, x) } else { (x, y) }
}

/// The sorted eigenvalues of the equations of motion in each lane, and whether they are as exact as those of the scalar
/// [`System::quartic_eigenvalues`], which are then the same to the last bit; where they are not, it has to be asked.
#[cfg(feature = "batch")]
#[inline(always)]
pub(crate) fn quick_eigenvalues<T: Lane>(m: Rows<T>, c: Rows<T>, k: Rows<T>) -> (Four<T>, T::Mask) {
    let (quartic, is_singular) = quartic(m, c, k);
    let is_regular = !is_singular & quartic.is_moderate() & are_moderate(m) & are_moderate(c) & are_moderate(k);
    let (factors, are_exact) = quartic.quick_factors();
    (Four::new(factors), is_regular & are_exact)
}

#[inline(always)]
fn are_moderate<T: Lane>(matrix: Rows<T>) -> T::Mask {
    let [[x11, x12], [x21, x22]] = matrix;
    (is_moderate(x11) & is_moderate(x12)) & (is_moderate(x21) & is_moderate(x22))
}

#[inline(always)]
fn is_moderate<T: Lane>(entry: T) -> T::Mask {
    let magnitude = entry.abs();
    let [small, large] = T::ENTRIES;
    (entry.like(small).less_or_equal(magnitude) & magnitude.less_or_equal(entry.like(large)))
        | magnitude.less_or_equal(entry.like(0.0))
}

/// The quartic `det(M s^2 + C s + K) / det M`, and whether M is singular.
#[inline(always)]
fn quartic<T: Lane>(m: Rows<T>, c: Rows<T>, k: Rows<T>) -> (Quartic<T>, T::Mask) {
    let [d, c, b, a, det] = coefficients([k, c, m]);
    // Below this the determinant is no more than the rounding of the entries.
    let size = (m[0][0] * m[1][1]).abs() + (m[0][1] * m[1][0]).abs();
    let rounding = det.like(8.0 * T::EPSILON) * size;
    let scale = det.like(1.0) / det;
    (Quartic { a: a * scale, b: b * scale, c: c * scale, d: d * scale }, det.abs().less_or_equal(rounding))
}

#[inline]
fn regular_quartic<T: Precision>(m: Rows<T>, c: Rows<T>, k: Rows<T>) -> Result<Quartic<T>, SystemError> {
    let (quartic, is_singular) = quartic(m, c, k);
    if is_singular { Err(SystemError::SingularMass) } else { Ok(quartic) }
}

/// Eigenvalues of matrices of any scale, in units that bring all entries to at most one.
#[cold]
fn scaled_eigenvalues<T: Precision>(system: &System<2, T>) -> Result<[[Complex<T>; 2]; 2], SystemError> {
    let units = Units::of_system(system)?;
    let System { m, c, k, .. } = units.scale_system(system);
    let mut roots = regular_quartic(rows(&m), rows(&c), rows(&k))?.roots()?;
    to_per_second(roots.as_flattened_mut(), units.time)?;
    Ok(roots)
}

#[inline]
fn precedes<T: PartialOrd>(x: &Complex<T>, y: &Complex<T>) -> bool {
    x.re < y.re || (x.re == y.re && x.im < y.im)
}
