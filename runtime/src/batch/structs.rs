//! Slices of designs, which are brought into lanes and back in registers.

use core::hint::black_box;
use core::marker::PhantomData;

use fearless_simd::Simd;

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use super::sixteen;
use super::transpose::{GROUP, transpose_group};
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
    let zeros = zeros(simd);
    for (designs, coefficients) in designs.chunks_exact(lanes).zip(coefficients.chunks_exact_mut(lanes)) {
        write::<S, N, M>(parameters::<S, N, M>(simd, designs).rows(), &zeros, coefficients);
    }
    for (design, coefficients) in designs[whole..].iter().zip(&mut coefficients[whole..]) {
        *coefficients = design.coefficients();
    }
}

/// Zeros, for matrices that are not there.
///
/// In registers of eight `f32` the compiler is not to know that they are: it would write two of these matrices at once, across lines of
/// the cache, which takes two cycles a design longer.
#[inline(always)]
fn zeros<S: Simd, T: InLanes>(simd: S) -> Lanes<S, T> {
    let zeros = Lanes::splat(simd, T::from_f64(0.0));
    if 2 * Lanes::<S, T>::COUNT == super::side::<T>() && size_of::<T>() == 4 { black_box(zeros) + zeros } else { zeros }
}

/// The designs in lanes: groups of numbers are transposed, the last of which may have zeros behind it.
#[inline(always)]
fn parameters<S: Simd, const N: usize, M: Model<N, Scalar: InLanes>>(
    simd: S,
    designs: &[M],
) -> M::Over<Lanes<S, M::Scalar>> {
    let zero = M::Scalar::from_f64(0.0);
    let mut columns = [Lanes::splat(simd, zero); 2 * GROUP];
    M::Over::<Lanes<S, M::Scalar>>::from_parameters(
        #[inline(always)]
        |position| {
            // They are asked for in order.
            if position % (2 * GROUP) == 0 {
                columns = M::Scalar::side_by_side(
                    simd,
                    #[inline(always)]
                    |design, group| {
                        let count = const { M::INFO.parameters.len() };
                        let begin = (position + group * GROUP).min(count);
                        let end = (begin + GROUP).min(count);
                        let mut four = [zero; GROUP];
                        four[..end - begin].copy_from_slice(&designs[design].parameters().as_ref()[begin..end]);
                        four
                    },
                );
            }
            columns[position % (2 * GROUP)]
        },
    )
}

/// Writes what lanes hold as the matrices of one design after the other.
#[inline(always)]
fn write<S: Simd, const N: usize, M: Model<N, Scalar: InLanes>>(
    mut matrices: [Rows<Lanes<S, M::Scalar>, N>; 8],
    zeros: &Lanes<S, M::Scalar>,
    coefficients: &mut [Coefficients<M::Scalar, N>],
) {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    if let Some(matrices) = (&matrices as &dyn core::any::Any).downcast_ref()
        && let Some(coefficients) = coefficients.first_chunk_mut::<16>()
        && let Some(coefficients) = (coefficients as &mut dyn core::any::Any).downcast_mut()
    {
        sixteen::write(
            matrices,
            Matrices::<N, M>::ARE_THERE,
            [0, 1].map(|coordinate| M::INFO.coordinates[coordinate].states),
            coefficients,
        );
        return;
    }
    // One half after the other: there are fewer registers than all of them have rows.
    write_half::<S, N, M>(&mut matrices, zeros, coefficients, Half::First);
    write_half::<S, N, M>(&mut matrices, zeros, coefficients, Half::Second);
}

/// Which four of the eight matrices.
#[derive(Clone, Copy, PartialEq)]
enum Half {
    First,
    Second,
}

/// Writes half of the matrices of all designs.
#[inline(always)]
fn write_half<S: Simd, const N: usize, M: Model<N, Scalar: InLanes>>(
    matrices: &mut [Rows<Lanes<S, M::Scalar>, N>; 8],
    zeros: &Lanes<S, M::Scalar>,
    coefficients: &mut [Coefficients<M::Scalar, N>],
    half: Half,
) {
    let lanes = Lanes::<S, M::Scalar>::COUNT;
    let group = lanes.min(GROUP);
    for ((place, matrix), is_there) in matrices.iter_mut().enumerate().zip(Matrices::<N, M>::ARE_THERE) {
        if is_there && (place < 4) == (half == Half::First) {
            // By columns, as matrices lie in memory.
            let mut columns = *matrix;
            for (row, numbers) in matrix.iter().enumerate() {
                for (column, number) in numbers.iter().enumerate() {
                    columns[column][row] = *number;
                }
            }
            for group in columns.as_flattened_mut().chunks_exact_mut(group) {
                transpose_group(group);
            }
            *matrix = columns;
        }
    }
    // One after the other, not in a loop: what is in a lane is only known where the lane is.
    write_four::<S, N, M>(matrices, zeros, coefficients, half, 0);
    if lanes > GROUP {
        write_four::<S, N, M>(matrices, zeros, coefficients, half, 1);
    }
    if lanes > 2 * GROUP {
        write_four::<S, N, M>(matrices, zeros, coefficients, half, 2);
        write_four::<S, N, M>(matrices, zeros, coefficients, half, 3);
    }
}

/// Writes them of four designs, or of as many as there are lanes.
#[inline(always)]
fn write_four<S: Simd, const N: usize, M: Model<N, Scalar: InLanes>>(
    matrices: &[Rows<Lanes<S, M::Scalar>, N>; 8],
    zeros: &Lanes<S, M::Scalar>,
    coefficients: &mut [Coefficients<M::Scalar, N>],
    half: Half,
    four: usize,
) {
    let group = Lanes::<S, M::Scalar>::COUNT.min(GROUP);
    let states = core::array::from_fn(|coordinate| M::INFO.coordinates[coordinate].states);
    for (row, coefficients) in coefficients[four * group..][..group].iter_mut().enumerate() {
        let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, states: of_all } = coefficients;
        for (((place, matrix), columns), is_there) in
            [m, cm1, c0, c1, kc, k0, k1, k2].into_iter().enumerate().zip(matrices).zip(Matrices::<N, M>::ARE_THERE)
        {
            if (place < 4) != (half == Half::First) {
                continue;
            }
            if !is_there {
                let mut places = matrix.as_mut_slice().chunks_exact_mut(group);
                places.by_ref().for_each(|places| places.copy_from_slice(&zeros.numbers()[..group]));
                places.into_remainder().fill(M::Scalar::from_f64(0.0));
                continue;
            }
            let groups = columns.as_flattened().chunks_exact(group);
            let mut places = matrix.as_mut_slice().chunks_exact_mut(group);
            let rest = groups.remainder();
            for (registers, places) in groups.zip(&mut places) {
                places.copy_from_slice(&registers[row].numbers()[four * group..][..group]);
            }
            for (numbers, place) in rest.iter().zip(places.into_remainder()) {
                *place = numbers.lane(four * group + row);
            }
        }
        if half == Half::Second {
            *of_all = states;
        }
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
