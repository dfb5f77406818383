//! The eigenvalues of many systems of two coordinates.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, dispatch};
use nalgebra::Complex;

use super::{Batch, BatchError, Lanes};
use crate::characteristic::determinant::Rows;
use crate::eigenvalues::{Four, quick_eigenvalues};
use crate::system::{Coefficients, System, SystemError};

/// What there is for each system: its four eigenvalues in 1/s, sorted by real part, then by imaginary part, or what is
/// wrong with it.
pub type Eigenvalues = Result<[Complex<f64>; 4], SystemError>;

impl Batch {
    /// The eigenvalues of each system, into a slice of equal length.
    ///
    /// They are those of [`System::quartic_eigenvalues`], to the last bit, with all that it promises; a system that has
    /// none gets its error, and the others are not affected.
    ///
    /// ```
    /// use carvallo::batch::Batch;
    /// use carvallo::{Complex, Matrix, System};
    ///
    /// let one = Matrix::<f64, 2>::identity();
    /// let systems = [1.0, 4.0, 9.0].map(|k| System::new(one, one * 0.0, one * k));
    /// let mut eigenvalues = systems.map(|_| Ok(Default::default()));
    /// Batch::new().eigenvalues(&systems, &mut eigenvalues)?;
    /// assert_eq!(eigenvalues[2].unwrap()[3], Complex::new(0.0, 3.0));
    /// # Ok::<(), carvallo::batch::BatchError>(())
    /// ```
    ///
    /// # Errors
    /// If the slices differ in length. Nothing is written then.
    pub fn eigenvalues(&self, systems: &[System<2>], eigenvalues: &mut [Eigenvalues]) -> Result<(), BatchError> {
        BatchError::require_room("result", systems.len(), eigenvalues.len())?;
        dispatch!(self.level, simd => of_systems(simd, systems, eigenvalues));
        Ok(())
    }

    /// As [`Batch::eigenvalues`], by all cores.
    ///
    /// # Errors
    /// As [`Batch::eigenvalues`].
    #[cfg(feature = "rayon")]
    pub fn parallel_eigenvalues(
        &self,
        systems: &[System<2>],
        eigenvalues: &mut [Eigenvalues],
    ) -> Result<(), BatchError> {
        use rayon::prelude::*;

        /// Some ten microseconds of work.
        const SYSTEMS: usize = 512;
        BatchError::require_room("result", systems.len(), eigenvalues.len())?;
        let parts = systems.par_chunks(SYSTEMS).zip(eigenvalues.par_chunks_mut(SYSTEMS));
        parts.try_for_each(|(systems, eigenvalues)| self.eigenvalues(systems, eigenvalues))
    }

    /// The eigenvalues of one design at each forward speed in m/s, under a gravitational field strength in N/kg, into a
    /// slice as long as that of the speeds.
    ///
    /// They are those of [`Coefficients::at`] and [`System::quartic_eigenvalues`], to the last bit, with all that they
    /// promise; a speed without any gets its error, and the others are not affected.
    ///
    /// # Errors
    /// If the slices differ in length. Nothing is written then.
    pub fn eigenvalues_along(
        &self,
        coefficients: &Coefficients<f64, 2>,
        gravity: f64,
        speeds: &[f64],
        eigenvalues: &mut [Eigenvalues],
    ) -> Result<(), BatchError> {
        BatchError::require_room("result", speeds.len(), eigenvalues.len())?;
        dispatch!(self.level, simd => along(simd, coefficients, gravity, speeds, eigenvalues));
        Ok(())
    }
}

#[inline(always)]
fn of_systems<S: Simd>(simd: S, systems: &[System<2>], eigenvalues: &mut [Eigenvalues]) {
    let lanes = Lanes::<S>::COUNT;
    for (systems, eigenvalues) in systems.chunks(lanes).zip(eigenvalues.chunks_mut(lanes)) {
        // Lanes without a system repeat the last one.
        let last = systems.len() - 1;
        let m = by_rows(
            #[inline(always)]
            |i, j| {
                Lanes::from_fn(
                    simd,
                    #[inline(always)]
                    |lane| systems[lane.min(last)].m[(i, j)],
                )
            },
        );
        let c = by_rows(
            #[inline(always)]
            |i, j| {
                Lanes::from_fn(
                    simd,
                    #[inline(always)]
                    |lane| systems[lane.min(last)].c[(i, j)],
                )
            },
        );
        let k = by_rows(
            #[inline(always)]
            |i, j| {
                Lanes::from_fn(
                    simd,
                    #[inline(always)]
                    |lane| systems[lane.min(last)].k[(i, j)],
                )
            },
        );
        write(quick_eigenvalues(m, c, k), eigenvalues, |lane| systems[lane].quartic_eigenvalues());
    }
}

#[inline(always)]
fn along<S: Simd>(
    simd: S,
    coefficients: &Coefficients<f64, 2>,
    gravity: f64,
    speeds: &[f64],
    eigenvalues: &mut [Eigenvalues],
) {
    let lanes = Lanes::<S>::COUNT;
    let scalar = |speed: f64| coefficients.at(speed, gravity)?.quartic_eigenvalues();
    if coefficients.has_odd_powers() {
        for (speed, eigenvalues) in speeds.iter().zip(eigenvalues) {
            *eigenvalues = scalar(*speed);
        }
        return;
    }
    let Coefficients { m, c0, c1, kc, k0, k2, .. } = coefficients;
    let standing = kc + k0 * gravity;
    let [m, c0, c1, standing, k2] = [m, c0, c1, &standing, k2].map(
        #[inline(always)]
        |matrix| {
            by_rows(
                #[inline(always)]
                |i, j| Lanes::splat(simd, matrix[(i, j)]),
            )
        },
    );
    for (speeds, eigenvalues) in speeds.chunks(lanes).zip(eigenvalues.chunks_mut(lanes)) {
        let last = speeds.len() - 1;
        let v = Lanes::<S>::from_fn(
            simd,
            #[inline(always)]
            |lane| speeds[lane.min(last)],
        );
        let c = by_rows(
            #[inline(always)]
            |i, j| c0[i][j] + c1[i][j] * v,
        );
        let k = by_rows(
            #[inline(always)]
            |i, j| standing[i][j] + k2[i][j] * v * v,
        );
        write(quick_eigenvalues(m, c, k), eigenvalues, |lane| scalar(speeds[lane]));
    }
}

#[inline(always)]
fn by_rows<T>(entry: impl Fn(usize, usize) -> T) -> Rows<T> {
    [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
}

/// Writes what the lanes hold, and the rest as the scalar function gives it.
#[inline(always)]
fn write<S: Simd>(
    (four, are_exact): (Four<Lanes<S>>, S::mask64s),
    eigenvalues: &mut [Eigenvalues],
    scalar: impl Fn(usize) -> Eigenvalues,
) {
    let exact = are_exact.to_bitmask();
    for (lane, eigenvalues) in eigenvalues.iter_mut().enumerate() {
        *eigenvalues = if exact >> lane & 1 != 0 {
            let at = |i: usize| Complex::new(four.re[i].lane(lane), four.im[i].lane(lane));
            Ok([at(0), at(1), at(2), at(3)])
        } else {
            scalar(lane)
        };
    }
}
