//! The eigenvalues of many systems of three coordinates and more.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, dispatch};
use nalgebra::Complex;

use super::transpose::transpose;
use super::{Batch, BatchError, Lanes};
use crate::eigenvalues::quick::{self, IS_THERE, Of, Roots, is_damped};
use crate::system::{States, System, SystemError};

/// What there is for each system: its eigenvalues, or what is wrong with it.
type Eigenvalues = Result<Vec<Complex<f64>>, SystemError>;

/// As many lanes as any processor has.
const MOST_LANES: usize = 8;

impl Batch {
    /// The eigenvalues of each system of N coordinates, into a slice of equal length. Vectors that are there are filled anew.
    ///
    /// They are those of [`System::eigenvalues`], to the last bit, with all that it promises; a system that has none gets its
    /// error, and the others are not affected. Systems of three to eight coordinates with damping are computed side by side,
    /// but for those whose eigenvalues nearly coincide or differ much in size, and others one after the other; for those of two
    /// coordinates there is
    /// [`eigenvalues`](Self::eigenvalues).
    ///
    /// ```
    /// use carvallo::batch::Batch;
    /// use carvallo::{Matrix, System};
    ///
    /// let (one, springs) = (Matrix::<f64, 3>::identity(), Matrix::<f64, 3>::new(9.0, -1.0, 0.0, -1.0, 5.0, -1.0, 0.0, -1.0, 2.0));
    /// let systems = [0.1, 0.2, 0.3].map(|damping| System::new(one, one * damping, springs));
    /// let mut eigenvalues = vec![Ok(Vec::new()); 3];
    /// Batch::new().eigenvalues_of_any(&systems, &mut eigenvalues)?;
    /// assert_eq!(eigenvalues[2], systems[2].eigenvalues());
    /// # Ok::<(), carvallo::batch::BatchError>(())
    /// ```
    ///
    /// # Errors
    /// If the slices differ in length. Nothing is written then.
    pub fn eigenvalues_of_any<const N: usize>(
        &self,
        systems: &[System<N>],
        eigenvalues: &mut [Eigenvalues],
    ) -> Result<(), BatchError> {
        BatchError::require_room("result", systems.len(), eigenvalues.len())?;
        let are_quick = IS_THERE && (3..=quick::MOST).contains(&N);
        if are_quick && systems.iter().all(|system| system.states == [States::Both; N]) {
            let by_entries = |place: usize| {
                let System { m, c, k, .. } = &systems[place];
                [m.as_slice(), c.as_slice(), k.as_slice()]
            };
            self.find(N, eigenvalues, &by_entries, &|place| systems[place].careful_eigenvalues());
        } else {
            systems.iter().zip(eigenvalues).for_each(|(system, eigenvalues)| *eigenvalues = system.eigenvalues());
        }
        Ok(())
    }

    /// As [`Batch::eigenvalues_of_any`], by all cores.
    ///
    /// # Errors
    /// As [`Batch::eigenvalues_of_any`].
    #[cfg(feature = "rayon")]
    pub fn parallel_eigenvalues_of_any<const N: usize>(
        &self,
        systems: &[System<N>],
        eigenvalues: &mut [Eigenvalues],
    ) -> Result<(), BatchError> {
        use rayon::prelude::*;

        /// Some ten microseconds of work and more.
        const SYSTEMS: usize = 32;
        BatchError::require_room("result", systems.len(), eigenvalues.len())?;
        let parts = systems.par_chunks(SYSTEMS).zip(eigenvalues.par_chunks_mut(SYSTEMS));
        parts.try_for_each(|(systems, eigenvalues)| self.eigenvalues_of_any(systems, eigenvalues))
    }

    /// Not generic, so that it is compiled once: from the entries of M, C and K by columns, and from what a system has alone.
    fn find<'a>(
        &self,
        n: usize,
        eigenvalues: &mut [Eigenvalues],
        matrices: &dyn Fn(usize) -> [&'a [f64]; 3],
        alone: &dyn Fn(usize) -> Eigenvalues,
    ) {
        // Where there are many loops, those of one number of coordinates take up to a fifth of the time less.
        match n {
            3 | 4 => dispatch!(self.level, simd => side_by_side::<_, 4, 8>(simd, n, eigenvalues, matrices, alone)),
            5 => dispatch!(self.level, simd => side_by_side::<_, 5, 10>(simd, 5, eigenvalues, matrices, alone)),
            6 => dispatch!(self.level, simd => side_by_side::<_, 6, 12>(simd, 6, eigenvalues, matrices, alone)),
            7 => dispatch!(self.level, simd => side_by_side::<_, 7, 14>(simd, 7, eigenvalues, matrices, alone)),
            _ => dispatch!(self.level, simd => side_by_side::<_, 8, 16>(simd, 8, eigenvalues, matrices, alone)),
        }
    }
}

// A function by its name instead of a closure is called without the instructions of the lanes, as is all that it calls.
#[allow(clippy::redundant_closure)]
#[inline(always)]
fn side_by_side<'a, S: Simd, const H: usize, const C: usize>(
    simd: S,
    n: usize,
    eigenvalues: &mut [Eigenvalues],
    matrices: &dyn Fn(usize) -> [&'a [f64]; 3],
    alone: &dyn Fn(usize) -> Eigenvalues,
) {
    let lanes = Lanes::<S>::COUNT;
    for (first, eigenvalues) in eigenvalues.chunks_mut(lanes).enumerate().map(|(chunk, part)| (chunk * lanes, part)) {
        // Lanes without a system repeat the last one.
        let last = eigenvalues.len() - 1;
        let mut of_lanes = [[&[] as &[f64]; 3]; MOST_LANES];
        for (lane, of_lane) in of_lanes.iter_mut().enumerate().take(lanes) {
            *of_lane = matrices(first + lane.min(last));
        }
        let m = side_by_side_entries::<S, H>(simd, n, &of_lanes, 0);
        let c = side_by_side_entries::<S, H>(simd, n, &of_lanes, 1);
        let k = side_by_side_entries::<S, H>(simd, n, &of_lanes, 2);
        let (roots, are_certain) = quick::find::<Lanes<S>, H, C>(
            n,
            #[inline(always)]
            |of, i, j| {
                let entries = match of {
                    Of::Mass => &m,
                    Of::Damping => &c,
                    Of::Stiffness => &k,
                };
                entries.as_flattened()[i + n * j]
            },
            #[inline(always)]
            |size, reduced_columns, rows| quick::of_matrix(size, reduced_columns, rows),
        );
        let certain = are_certain.to_bitmask();
        for (lane, eigenvalues) in eigenvalues.iter_mut().enumerate() {
            let mut values = core::mem::replace(eigenvalues, Ok(Vec::new())).unwrap_or_default();
            let [re, im] = [&roots.re, &roots.im].map(|part| core::array::from_fn(|i| part[i].lane(lane)));
            let of_lane = Roots::<f64, C> { re, im, norm: roots.norm.lane(lane) };
            let is_here = certain >> lane & 1 != 0
                && is_damped(of_lanes[lane % MOST_LANES][1])
                && of_lane.sort_into(2 * n, &mut values);
            *eigenvalues = if is_here { Ok(values) } else { alone(first + lane) };
        }
    }
}

/// The entries of a matrix of n coordinates by columns, those of each lane from its own slice: squares of them are transposed,
/// the last of which takes some entries again rather than fewer.
#[inline(always)]
fn side_by_side_entries<S: Simd, const H: usize>(
    simd: S,
    n: usize,
    of_lanes: &[[&[f64]; 3]; MOST_LANES],
    of: usize,
) -> [[Lanes<S>; H]; H] {
    let (lanes, count) = (Lanes::<S>::COUNT, n * n);
    let mut entries = [[Lanes::splat(simd, 0.0); H]; H];
    let flat = &mut entries.as_flattened_mut()[..count];
    for first in (0..count).step_by(lanes) {
        let first = first.min(count - lanes);
        let square = &mut flat[first..first + lanes];
        for (numbers, of_lane) in square.iter_mut().zip(of_lanes) {
            *numbers = Lanes::load(simd, &of_lane[of][first..first + lanes]);
        }
        transpose(square);
    }
    entries
}
