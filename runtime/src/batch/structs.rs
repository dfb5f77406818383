//! Slices of designs, which are brought into lanes and back in registers.

use fearless_simd::Simd;

use super::transpose::{MOST, transpose};
use super::{InLanes, Lanes};
use crate::model::{Evaluator, Model};
use crate::number::Scalar;
use crate::system::Coefficients;

/// The rows of a matrix.
type Rows<T, const N: usize> = [[T; N]; N];

#[inline(always)]
pub fn structs<S: Simd, const N: usize, M: Model<N, Scalar: InLanes>>(
    simd: S,
    designs: &[M],
    coefficients: &mut [Coefficients<M::Scalar, N>],
) {
    let lanes = Lanes::<S, M::Scalar>::COUNT;
    let whole = designs.len() - designs.len() % lanes;
    for (designs, coefficients) in designs.chunks_exact(lanes).zip(coefficients.chunks_exact_mut(lanes)) {
        let rows = parameters::<S, N, M>(simd, designs).rows();
        write::<S, N, M>(&rows, coefficients);
    }
    for (design, coefficients) in designs[whole..].iter().zip(&mut coefficients[whole..]) {
        *coefficients = design.coefficients();
    }
}

/// The designs in lanes: squares of them are transposed, the last of which takes some parameters again rather than fewer.
#[inline(always)]
fn parameters<S: Simd, const N: usize, M: Model<N, Scalar: InLanes>>(
    simd: S,
    designs: &[M],
) -> M::Over<Lanes<S, M::Scalar>> {
    let lanes = Lanes::<S, M::Scalar>::COUNT;
    let count = M::INFO.parameters.len();
    let mut square = [Lanes::splat(simd, M::Scalar::from_f64(0.0)); MOST];
    let mut begin = usize::MAX;
    M::Over::<Lanes<S, M::Scalar>>::from_parameters(
        #[inline(always)]
        |position| {
            if count < lanes {
                return Lanes::from_fn(
                    simd,
                    #[inline(always)]
                    |lane| designs[lane].parameters().as_ref()[position],
                );
            }
            // They are asked for in order, so a square is made once.
            let first = (position - position % lanes).min(count - lanes);
            if first != begin {
                for (numbers, design) in square[..lanes].iter_mut().zip(designs) {
                    *numbers = Lanes::load(simd, &design.parameters().as_ref()[first..][..lanes]);
                }
                transpose(&mut square[..lanes]);
                begin = first;
            }
            square[position - first]
        },
    )
}

/// Writes what lanes hold as the matrices of one design after the other.
#[inline(always)]
fn write<S: Simd, const N: usize, M: Model<N, Scalar: InLanes>>(
    rows: &[Rows<Lanes<S, M::Scalar>, N>; 8],
    coefficients: &mut [Coefficients<M::Scalar, N>],
) {
    let lanes = Lanes::<S, M::Scalar>::COUNT;
    // By columns, as matrices lie in memory.
    let mut columns = *rows;
    for (columns, rows) in columns.iter_mut().zip(rows) {
        for (row, numbers) in rows.iter().enumerate() {
            for (column, number) in numbers.iter().enumerate() {
                columns[column][row] = *number;
            }
        }
    }
    let columns = columns.as_flattened_mut().as_flattened_mut();
    for square in columns.chunks_exact_mut(lanes) {
        transpose(square);
    }
    let squares = columns.chunks_exact(lanes);
    let rest = squares.remainder();
    let states = core::array::from_fn(|coordinate| M::INFO.coordinates[coordinate].states);
    for (lane, coefficients) in coefficients.iter_mut().enumerate() {
        let mut matrices = [[[M::Scalar::from_f64(0.0); N]; N]; 8];
        let (places, places_of_rest) =
            matrices.as_flattened_mut().as_flattened_mut().split_at_mut(8 * N * N - rest.len());
        for (square, places) in squares.clone().zip(places.chunks_exact_mut(lanes)) {
            square[lane].store(places);
        }
        for (numbers, place) in rest.iter().zip(places_of_rest) {
            *place = numbers.lane(lane);
        }
        let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, states: of_all } = coefficients;
        for (matrix, columns) in [m, cm1, c0, c1, kc, k0, k1, k2].into_iter().zip(&matrices) {
            matrix.as_mut_slice().copy_from_slice(columns.as_flattened());
        }
        *of_all = states;
    }
}
