//! The matrices of many designs, and their derivatives.

use core::marker::PhantomData;

use fearless_simd::{Simd, dispatch};

use super::matrices::{check_blocks, check_widths};
use super::{Batch, BatchError, Blocks, InLanes, Lanes, side};
use crate::model::{Differentiable, Evaluator, EvaluatorWithDerivatives, Partial, write_now};

/// The entries of the matrices of a few designs and their derivatives, as a [`Batch`] computes them.
#[derive(Clone, Copy, Debug)]
pub struct Portion<'a, T> {
    first: usize,
    len: usize,
    entries: &'a [T],
    derivatives: &'a [T],
}

impl<'a, T: InLanes> Portion<'a, T> {
    /// The first of the designs, of which the others follow.
    #[must_use]
    pub fn first(&self) -> usize {
        self.first
    }

    /// How many designs there are: those of a block, or of the last one what is left.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "there is always one")]
    pub fn len(&self) -> usize {
        self.len
    }

    /// An entry of each design, by its position among [`ModelInfo::entries`](crate::ModelInfo::entries).
    ///
    /// # Panics
    /// If there is no such entry.
    #[must_use]
    pub fn entry(&self, position: usize) -> &'a [T] {
        &self.entries[position * side::<T>()..][..self.len]
    }

    /// A derivative of each design.
    ///
    /// # Panics
    /// If it is none of this model.
    pub fn derivative(&self, partial: &Partial) -> impl ExactSizeIterator<Item = T> + use<'a, T> {
        let negative = partial.negative;
        let values = &self.derivatives[partial.value * side::<T>()..][..self.len];
        values.iter().map(move |value| if negative { -*value } else { *value })
    }
}

impl<T: InLanes> Blocks<T> {
    /// Room for the derivatives of the matrices of `len` designs: for each of their values, which
    /// [`Differentiable::PARTIALS`] says the place of.
    #[must_use]
    pub fn for_derivatives<const N: usize, M: Differentiable<N, Scalar = T>>(len: usize) -> Self {
        Self::zeros(Values::<N, M>::COUNT, len)
    }

    /// One of the derivatives of a design, of blocks of such.
    ///
    /// # Panics
    /// If there is no such design, or if it is no derivative of this model.
    #[must_use]
    pub fn derivative(&self, design: usize, partial: &Partial) -> T {
        let value = self.get(design, partial.value);
        if partial.negative { -value } else { value }
    }
}

impl Batch {
    /// The matrices of designs and their derivatives with respect to the parameters, from blocks of
    /// [parameters](Blocks::of_designs) into blocks of [entries](Blocks::for_entries) and of
    /// [derivatives](Blocks::for_derivatives).
    ///
    /// They are those of [`Differentiable::coefficients_and_derivatives`], to the last bit. A bicycle has 124 derivatives that
    /// differ, so of many designs it is memory that takes the time: where they are summed up to less, use
    /// [`Batch::each_jacobian`]. The parameters are not validated.
    ///
    /// # Errors
    /// If the blocks do not have a number for each parameter, entry or derivative, or if they differ in length.
    pub fn jacobians<const N: usize, M: Differentiable<N, Scalar: InLanes>>(
        &self,
        parameters: &Blocks<M::Scalar>,
        entries: &mut Blocks<M::Scalar>,
        derivatives: &mut Blocks<M::Scalar>,
    ) -> Result<(), BatchError> {
        check_room::<N, M>(parameters, entries, derivatives)?;
        self.differentiate::<N, M>(parameters.numbers(), entries.numbers_mut(), derivatives.numbers_mut());
        Ok(())
    }

    /// As [`Batch::jacobians`], by all cores.
    ///
    /// # Errors
    /// As [`Batch::jacobians`].
    #[cfg(feature = "rayon")]
    pub fn parallel_jacobians<const N: usize, M: Differentiable<N, Scalar: InLanes>>(
        &self,
        parameters: &Blocks<M::Scalar>,
        entries: &mut Blocks<M::Scalar>,
        derivatives: &mut Blocks<M::Scalar>,
    ) -> Result<(), BatchError> {
        use rayon::prelude::*;

        /// Some ten microseconds of work.
        const DESIGNS: usize = 256;
        check_room::<N, M>(parameters, entries, derivatives)?;
        let results = entries.parts_mut(DESIGNS).zip(derivatives.parts_mut(DESIGNS));
        parameters.parts(DESIGNS).zip(results).for_each(|(parameters, (entries, derivatives))| {
            self.differentiate::<N, M>(parameters, entries, derivatives);
        });
        Ok(())
    }

    /// Whole blocks of parameters into whole blocks of entries and derivatives.
    fn differentiate<const N: usize, M: Differentiable<N, Scalar: InLanes>>(
        &self,
        parameters: &[M::Scalar],
        entries: &mut [M::Scalar],
        derivatives: &mut [M::Scalar],
    ) {
        let [inputs, outputs, values] =
            [M::INFO.parameters.len(), M::INFO.entries.len(), Values::<N, M>::COUNT].map(block_of::<M::Scalar>);
        let results = entries.chunks_exact_mut(outputs).zip(derivatives.chunks_exact_mut(values));
        let blocks = parameters.chunks_exact(inputs).zip(results);
        dispatch!(self.level, simd => {
            for (parameters, (entries, derivatives)) in blocks {
                block::<_, N, M>(simd, parameters, entries, derivatives);
            }
        });
    }

    /// The same for a block of designs after the other, in one place: each is given to a function, and then forgotten.
    ///
    /// # Errors
    /// If the blocks do not have a number for each parameter.
    ///
    /// ```
    /// # #[cfg(feature = "derive")] {
    /// use carvallo::Differentiable;
    /// use carvallo::batch::{Batch, Blocks};
    ///
    /// carvallo::model! {
    ///     pub model Oscillator {
    ///         parameters { m: kg, > 0; l: m, > 0; k: N*m, > 0; }
    ///         coordinates { theta: rad; }
    ///         M = [[m*l^2]];
    ///         Kc = [[k]];
    ///         derivatives;
    ///     }
    /// }
    /// # let designs = [Oscillator { m: 2.0, l: 3.0, k: 1.0 }, Oscillator { m: 4.0, l: 0.5, k: 1.0 }];
    /// // How the masses grow with the length, summed up.
    /// let mut sum = 0.0;
    /// Batch::new().each_jacobian::<1, Oscillator>(&Blocks::of_designs(&designs), |portion| {
    ///     for partial in <Oscillator>::PARTIALS.iter().filter(|partial| partial.parameter == 1) {
    ///         sum += portion.derivative(partial).sum::<f64>();
    ///     }
    /// })?;
    /// assert_eq!(sum, 2.0 * 2.0 * 3.0 + 2.0 * 4.0 * 0.5);
    /// # }
    /// # Ok::<(), carvallo::batch::BatchError>(())
    /// ```
    pub fn each_jacobian<const N: usize, M: Differentiable<N, Scalar: InLanes>>(
        &self,
        parameters: &Blocks<M::Scalar>,
        mut take: impl FnMut(Portion<'_, M::Scalar>),
    ) -> Result<(), BatchError> {
        let side = Blocks::<M::Scalar>::SIDE;
        let (mut entries, mut derivatives) = (Blocks::for_entries::<N, M>(side), Blocks::for_derivatives::<N, M>(side));
        check_widths::<N, M>(parameters.width(), entries.width())?;
        let designs = parameters.len();
        let blocks = parameters.numbers().chunks_exact(block_of::<M::Scalar>(parameters.width()));
        for (number, parameters) in blocks.enumerate() {
            let (entries, derivatives) = (entries.numbers_mut(), derivatives.numbers_mut());
            dispatch!(self.level, simd => block::<_, N, M>(simd, parameters, entries, derivatives));
            let first = number * side;
            let len = side.min(designs - first);
            take(Portion { first, len, entries, derivatives });
        }
        Ok(())
    }
}

/// Whether there is a number for each parameter, entry and derivative of as many designs.
fn check_room<const N: usize, M: Differentiable<N, Scalar: InLanes>>(
    parameters: &Blocks<M::Scalar>,
    entries: &Blocks<M::Scalar>,
    derivatives: &Blocks<M::Scalar>,
) -> Result<(), BatchError> {
    check_blocks::<N, M>(parameters, entries)?;
    let (expected, found) = (Values::<N, M>::COUNT, derivatives.width());
    if expected != found {
        return Err(BatchError::Columns { model: M::INFO.name, what: "derivatives", expected, found });
    }
    BatchError::require_room("derivative", parameters.len(), derivatives.len())
}

/// How many numbers a block has; one that has none is never filled.
fn block_of<T>(width: usize) -> usize {
    (side::<T>() * width).max(1)
}

/// A block of parameters into one of entries and one of derivatives.
#[inline(always)]
fn block<S: Simd, const N: usize, M: Differentiable<N, Scalar: InLanes>>(
    simd: S,
    parameters: &[M::Scalar],
    entries: &mut [M::Scalar],
    derivatives: &mut [M::Scalar],
) {
    let lanes = Lanes::<S, M::Scalar>::COUNT;
    let side = side::<M::Scalar>();
    // Constant lengths: what stands within them is not checked again.
    let entries = &mut entries[..side * Values::<N, M>::ENTRIES];
    let derivatives = &mut derivatives[..side * Values::<N, M>::COUNT];
    for group in 0..side / lanes {
        let first = group * lanes;
        let design = M::WithDerivativesOver::<Lanes<S, M::Scalar>>::from_parameters(
            #[inline(always)]
            |position| Lanes::load(simd, &parameters[position * side + first..][..lanes]),
        );
        design.each_result(
            #[inline(always)]
            |position, entry| {
                entry.store(&mut entries[position * side + first..][..lanes]);
                write_now();
            },
            #[inline(always)]
            |position, value| {
                value.store(&mut derivatives[position * side + first..][..lanes]);
                write_now();
            },
        );
    }
}

/// How many entries and values of derivatives a model has.
struct Values<const N: usize, M>(PhantomData<M>);

impl<const N: usize, M: Differentiable<N>> Values<N, M> {
    const ENTRIES: usize = M::INFO.entries.len();

    const COUNT: usize = {
        let (mut count, mut place) = (0, 0);
        while place < M::PARTIALS.len() {
            if M::PARTIALS[place].value >= count {
                count = M::PARTIALS[place].value + 1;
            }
            place += 1;
        }
        count
    };
}
