//! Slices of designs, which are brought into lanes and back in registers.

use core::marker::PhantomData;

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
        write::<S, N, M>(parameters::<S, N, M>(simd, designs).rows(), coefficients);
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

/// Numbers of a design that are brought side by side: the more, the more rounds it takes; a matrix of two coordinates has four.
const GROUP: usize = 4;

/// Writes what lanes hold as the matrices of one design after the other.
#[inline(always)]
fn write<S: Simd, const N: usize, M: Model<N, Scalar: InLanes>>(
    mut matrices: [Rows<Lanes<S, M::Scalar>, N>; 8],
    coefficients: &mut [Coefficients<M::Scalar, N>],
) {
    let lanes = Lanes::<S, M::Scalar>::COUNT;
    let group = lanes.min(GROUP);
    for (matrix, is_there) in matrices.iter_mut().zip(Matrices::<N, M>::ARE_THERE) {
        if is_there {
            // By columns, as matrices lie in memory.
            let mut columns = *matrix;
            for (row, numbers) in matrix.iter().enumerate() {
                for (column, number) in numbers.iter().enumerate() {
                    columns[column][row] = *number;
                }
            }
            columns.as_flattened_mut().chunks_exact_mut(group).for_each(transpose);
            *matrix = columns;
        }
    }
    let states = core::array::from_fn(|coordinate| M::INFO.coordinates[coordinate].states);
    for (lane, coefficients) in coefficients.iter_mut().enumerate() {
        // Each register of a group has the numbers of so many designs.
        let designs = lanes / group;
        let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, states: of_all } = coefficients;
        for ((matrix, columns), is_there) in
            [m, cm1, c0, c1, kc, k0, k1, k2].into_iter().zip(&matrices).zip(Matrices::<N, M>::ARE_THERE)
        {
            if !is_there {
                matrix.as_mut_slice().fill(M::Scalar::from_f64(0.0));
                continue;
            }
            let groups = columns.as_flattened().chunks_exact(group);
            let mut places = matrix.as_mut_slice().chunks_exact_mut(group);
            let rest = groups.remainder();
            for (group_of_all, places) in groups.zip(&mut places) {
                let register = &group_of_all[lane / designs];
                if designs == 1 {
                    register.store(places);
                } else {
                    places.copy_from_slice(&register.numbers()[lane % designs * group..][..group]);
                }
            }
            for (numbers, place) in rest.iter().zip(places.into_remainder()) {
                *place = numbers.lane(lane);
            }
        }
        *of_all = states;
    }
}

/// The matrices of a model.
struct Matrices<const N: usize, M>(PhantomData<M>);

impl<const N: usize, M: Model<N>> Matrices<N, M> {
    /// Which of them have entries that are not always zero.
    const ARE_THERE: [bool; 8] = {
        let mut are_there = [false; 8];
        let mut entry = 0;
        while entry < M::INFO.entries.len() {
            let places = M::INFO.entries[entry].places;
            let mut place = 0;
            while place < places.len() {
                are_there[places[place].0 as usize] = true;
                place += 1;
            }
            entry += 1;
        }
        are_there
    };
}
