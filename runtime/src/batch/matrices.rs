//! The matrices of many designs.

use fearless_simd::{Simd, SimdBase, dispatch};

use super::{Batch, BatchError, Lanes};
use crate::{Coefficients, Evaluator, Model};

impl Batch {
    /// The matrices of designs that are given by columns, one for each parameter, into columns, one for each of the
    /// [entries](crate::ModelInfo::entries) of the model's matrices.
    ///
    /// All columns are of equal length, the number of designs. The parameters are not validated.
    ///
    /// # Errors
    /// If there is not a column for each parameter and each entry, or if they differ in length. Nothing is written then.
    pub fn matrices<const N: usize, M: Model<N, Scalar = f64>>(
        &self,
        parameters: &[&[f64]],
        entries: &mut [&mut [f64]],
    ) -> Result<(), BatchError> {
        let designs = check::<N, M>(parameters, entries)?;
        dispatch!(self.level, simd => columns::<_, N, M>(simd, designs, parameters, entries));
        Ok(())
    }

    /// The coefficient matrices of a slice of designs into a slice of equal length.
    ///
    /// Numbers have to be brought from one design after the other into the lanes and back, which takes about as long as
    /// the arithmetic: where it matters, keep designs in columns. The parameters are not validated.
    ///
    /// # Errors
    /// If the slices differ in length. Nothing is written then.
    pub fn coefficients<const N: usize, M: Model<N, Scalar = f64>>(
        &self,
        designs: &[M],
        coefficients: &mut [Coefficients<f64, N>],
    ) -> Result<(), BatchError> {
        let (expected, found) = (designs.len(), coefficients.len());
        if expected != found {
            return Err(BatchError::Length { what: "results", position: 0, expected, found });
        }
        dispatch!(self.level, simd => structs::<_, N, M>(simd, designs, coefficients));
        Ok(())
    }
}

/// The number of designs, if all columns fit.
fn check<const N: usize, M: Model<N, Scalar = f64>>(
    parameters: &[&[f64]],
    entries: &[&mut [f64]],
) -> Result<usize, BatchError> {
    let info = M::INFO;
    let counts =
        [("parameters", info.parameters.len(), parameters.len()), ("entries", info.entries.len(), entries.len())];
    for (what, expected, found) in counts {
        if expected != found {
            return Err(BatchError::Columns { model: info.name, what, expected, found });
        }
    }
    let expected = parameters.first().map_or(0, |column| column.len());
    let inputs = parameters.iter().map(|column| ("parameter", column.len())).enumerate();
    let outputs = entries.iter().map(|column| ("entry", column.len())).enumerate();
    match inputs.chain(outputs).find(|(_, (_, found))| *found != expected) {
        Some((position, (what, found))) => Err(BatchError::Length { what, position, expected, found }),
        None => Ok(expected),
    }
}

#[inline(always)]
fn columns<S: Simd, const N: usize, M: Model<N, Scalar = f64>>(
    simd: S,
    designs: usize,
    parameters: &[&[f64]],
    entries: &mut [&mut [f64]],
) {
    let lanes = Lanes::<S>::COUNT;
    let whole = designs - designs % lanes;
    for start in (0..whole).step_by(lanes) {
        let results = M::Over::<Lanes<S>>::from_parameters(
            #[inline(always)]
            |position| Lanes(S::f64s::from_slice(simd, &parameters[position][start..start + lanes])),
        );
        for (column, result) in entries.iter_mut().zip(results.entries().as_ref()) {
            result.0.store_slice(&mut column[start..start + lanes]);
        }
    }
    if whole < designs {
        // Lanes without a design repeat the last one.
        let results = M::Over::<Lanes<S>>::from_parameters(
            #[inline(always)]
            |position| Lanes::from_fn(simd, |lane| parameters[position][(whole + lane).min(designs - 1)]),
        );
        for (column, result) in entries.iter_mut().zip(results.entries().as_ref()) {
            for (lane, number) in column[whole..].iter_mut().enumerate() {
                *number = result.lane(lane);
            }
        }
    }
}

#[inline(always)]
fn structs<S: Simd, const N: usize, M: Model<N, Scalar = f64>>(
    simd: S,
    designs: &[M],
    coefficients: &mut [Coefficients<f64, N>],
) {
    let lanes = Lanes::<S>::COUNT;
    for (designs, coefficients) in designs.chunks(lanes).zip(coefficients.chunks_mut(lanes)) {
        let last = designs.len() - 1;
        let rows = M::Over::<Lanes<S>>::from_parameters(
            #[inline(always)]
            |position| {
                Lanes::<S>::from_fn(
                    simd,
                    #[inline(always)]
                    |lane| designs[lane.min(last)].parameters().as_ref()[position],
                )
            },
        )
        .rows();
        for (lane, coefficients) in coefficients.iter_mut().enumerate() {
            *coefficients =
                Coefficients::from_rows(rows.map(|matrix| matrix.map(|row| row.map(|entry| entry.lane(lane)))));
        }
    }
}
