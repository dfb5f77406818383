//! The matrices of many designs.

use fearless_simd::{Simd, dispatch};

#[cfg(feature = "std")]
use super::Blocks;
use super::structs::structs;
use super::{Batch, BatchError, InLanes, Lanes, side};
use crate::model::{Evaluator, Model};
use crate::number::Scalar;
use crate::system::Coefficients;

#[cfg(feature = "std")]
impl Batch {
    /// The matrices of designs, from blocks of [parameters](Blocks::of_designs) into blocks of
    /// [entries](Blocks::for_entries).
    ///
    /// The parameters are not validated.
    ///
    /// # Errors
    /// If the blocks do not have a number for each parameter or each entry, or if they differ in length.
    pub fn matrices<const N: usize, M: Model<N, Scalar: InLanes>>(
        &self,
        parameters: &Blocks<M::Scalar>,
        entries: &mut Blocks<M::Scalar>,
    ) -> Result<(), BatchError> {
        check_blocks::<N, M>(parameters, entries)?;
        self.fill::<N, M>(parameters.numbers(), entries.numbers_mut());
        Ok(())
    }

    /// As [`Batch::matrices`], by all cores.
    ///
    /// # Errors
    /// As [`Batch::matrices`].
    #[cfg(feature = "rayon")]
    pub fn parallel_matrices<const N: usize, M: Model<N, Scalar: InLanes>>(
        &self,
        parameters: &Blocks<M::Scalar>,
        entries: &mut Blocks<M::Scalar>,
    ) -> Result<(), BatchError> {
        use rayon::prelude::*;

        /// Some ten microseconds of work.
        const DESIGNS: usize = 2048;
        check_blocks::<N, M>(parameters, entries)?;
        let parts = parameters.parts(DESIGNS).zip(entries.parts_mut(DESIGNS));
        parts.for_each(|(parameters, entries)| self.fill::<N, M>(parameters, entries));
        Ok(())
    }

    /// Whole blocks of parameters into whole blocks of entries.
    fn fill<const N: usize, M: Model<N, Scalar: InLanes>>(&self, parameters: &[M::Scalar], entries: &mut [M::Scalar]) {
        dispatch!(self.level, simd => blocks::<_, N, M>(simd, parameters, entries));
    }
}

impl Batch {
    /// The matrices of designs that are given by columns, one for each parameter, into columns, one for each of the
    /// [entries](crate::ModelInfo::entries) of the model's matrices.
    ///
    /// All columns are of equal length, the number of designs. In the cache blocks are faster. The parameters are not validated.
    ///
    /// # Errors
    /// If there is not a column for each parameter and each entry, or if they differ in length. Nothing is written then.
    pub fn matrices_of_columns<const N: usize, M: Model<N, Scalar: InLanes>>(
        &self,
        parameters: &[&[M::Scalar]],
        entries: &mut [&mut [M::Scalar]],
    ) -> Result<(), BatchError> {
        let designs = check_columns::<N, M>(parameters, entries)?;
        dispatch!(self.level, simd => columns::<_, N, M>(simd, designs, parameters, entries));
        Ok(())
    }

    /// The coefficient matrices of a slice of designs into a slice of equal length.
    ///
    /// Numbers are brought from one design after the other into the lanes and back, in registers, which takes longer than the
    /// arithmetic: where it matters, keep designs in blocks. The parameters are not validated.
    ///
    /// # Errors
    /// If the slices differ in length. Nothing is written then.
    pub fn coefficients<const N: usize, M: Model<N, Scalar: InLanes>>(
        &self,
        designs: &[M],
        coefficients: &mut [Coefficients<M::Scalar, N>],
    ) -> Result<(), BatchError> {
        BatchError::require_room("result", designs.len(), coefficients.len())?;
        dispatch!(self.level, simd => structs::<_, N, M>(simd, designs, coefficients));
        Ok(())
    }
}

#[cfg(feature = "std")]
pub(super) fn check_blocks<const N: usize, M: Model<N, Scalar: InLanes>>(
    parameters: &Blocks<M::Scalar>,
    entries: &Blocks<M::Scalar>,
) -> Result<(), BatchError> {
    check_widths::<N, M>(parameters.width(), entries.width())?;
    BatchError::require_room("entry", parameters.len(), entries.len())
}

pub(super) fn check_widths<const N: usize, M: Model<N, Scalar: InLanes>>(
    parameters: usize,
    entries: usize,
) -> Result<(), BatchError> {
    let info = M::INFO;
    let counts = [("parameters", info.parameters.len(), parameters), ("entries", info.entries.len(), entries)];
    match counts.into_iter().find(|(_, expected, found)| expected != found) {
        Some((what, expected, found)) => Err(BatchError::Columns { model: info.name, what, expected, found }),
        None => Ok(()),
    }
}

/// The number of designs, if all columns fit.
fn check_columns<const N: usize, M: Model<N, Scalar: InLanes>>(
    parameters: &[&[M::Scalar]],
    entries: &[&mut [M::Scalar]],
) -> Result<usize, BatchError> {
    check_widths::<N, M>(parameters.len(), entries.len())?;
    let expected = parameters.first().map_or(0, |column| column.len());
    let inputs = parameters.iter().map(|column| ("parameter", column.len())).enumerate();
    let outputs = entries.iter().map(|column| ("entry", column.len())).enumerate();
    match inputs.chain(outputs).find(|(_, (_, found))| *found != expected) {
        Some((position, (what, found))) => Err(BatchError::Length { what, position, expected, found }),
        None => Ok(expected),
    }
}

/// Whole blocks of parameters into whole blocks of entries.
#[cfg(feature = "std")]
#[inline(always)]
fn blocks<S: Simd, const N: usize, M: Model<N, Scalar: InLanes>>(
    simd: S,
    parameters: &[M::Scalar],
    entries: &mut [M::Scalar],
) {
    let lanes = Lanes::<S, M::Scalar>::COUNT;
    let side = side::<M::Scalar>();
    // A model without entries has no blocks to fill.
    let [inputs, outputs] = [M::INFO.parameters.len(), M::INFO.entries.len()].map(|width| (side * width).max(1));
    for (parameters, entries) in parameters.chunks_exact(inputs).zip(entries.chunks_exact_mut(outputs)) {
        for first in (0..side).step_by(lanes) {
            let design = M::Over::<Lanes<S, M::Scalar>>::from_parameters(
                #[inline(always)]
                |position| Lanes::load(simd, &parameters[position * side + first..][..lanes]),
            );
            for (position, result) in design.entries().as_ref().iter().enumerate() {
                result.store(&mut entries[position * side + first..][..lanes]);
            }
        }
    }
}

/// Designs between two looks at how long the columns are.
const STRETCH: usize = 64;

/// Columns of so many designs do not stay in the cache.
const MANY: usize = 4096;

#[inline(always)]
fn columns<S: Simd, const N: usize, M: Model<N, Scalar: InLanes>>(
    simd: S,
    designs: usize,
    parameters: &[&[M::Scalar]],
    entries: &mut [&mut [M::Scalar]],
) {
    let lanes = Lanes::<S, M::Scalar>::COUNT;
    let zeros = [M::Scalar::from_f64(0.0); STRETCH];
    // Large columns mostly begin at the same place of a page, so that their lines drive each other out of the cache: then each
    // is to be read once, as a whole.
    let aligned = parameters.first().map_or(0, |column| column.as_ptr().align_offset(64));
    let begin = if designs < MANY { 0 } else { aligned.min(side::<M::Scalar>()) };
    let end = designs - (designs - begin) % STRETCH;
    for start in (begin..end).step_by(STRETCH) {
        let stretch = M::array(
            #[inline(always)]
            |position| parameters[position][start..].first_chunk::<STRETCH>().unwrap_or(&zeros),
        );
        for first in (0..STRETCH).step_by(lanes) {
            let design = M::Over::<Lanes<S, M::Scalar>>::from_parameters(
                #[inline(always)]
                |position| Lanes::load(simd, &stretch.as_ref()[position][first..first + lanes]),
            );
            for (column, result) in entries.iter_mut().zip(design.entries().as_ref()) {
                result.store(&mut column[start + first..start + first + lanes]);
            }
        }
    }
    for (start, end) in [(0, begin), (end, designs)] {
        for start in (start..end).step_by(lanes) {
            // Lanes without a design repeat the last one.
            let design = M::Over::<Lanes<S, M::Scalar>>::from_parameters(
                #[inline(always)]
                |position| Lanes::from_fn(simd, |lane| parameters[position][(start + lane).min(end - 1)]),
            );
            for (column, result) in entries.iter_mut().zip(design.entries().as_ref()) {
                for (lane, number) in column[start..end].iter_mut().take(lanes).enumerate() {
                    *number = result.lane(lane);
                }
            }
        }
    }
}
