//! One system by itself: compiled for each size.

use nalgebra::Complex;

use super::{Of, Roots, find, of_matrix};
use crate::eigenvalues::general::Spectrum;
use crate::numeric::Square;

/// Of a web page, which loads the faster without them, none is computed so.
pub(crate) const IS_THERE: bool = !cfg!(target_family = "wasm");

/// The eigenvalues of three to eight coordinates, sorted, from the entries of M, C and K by columns, where they are certain.
pub(crate) fn of_system(n: usize, matrices: [&[f64]; 3]) -> Option<Vec<Complex<f64>>> {
    if !IS_THERE || !is_damped(matrices[1]) {
        return None;
    }
    match n {
        3 => sorted::<3, 6>(matrices),
        4 => sorted::<4, 8>(matrices),
        5 => sorted::<5, 10>(matrices),
        6 => sorted::<6, 12>(matrices),
        7 => sorted::<7, 14>(matrices),
        8 => sorted::<8, 16>(matrices),
        _ => None,
    }
}

/// Whether there is any damping: without it there are half as many to find, in another way.
pub(crate) fn is_damped(c: &[f64]) -> bool {
    c.iter().any(|&entry| entry != 0.0)
}

fn sorted<const H: usize, const C: usize>([m, c, k]: [&[f64]; 3]) -> Option<Vec<Complex<f64>>> {
    let entry = |of, i, j| {
        let entries = match of {
            Of::Mass => m,
            Of::Damping => c,
            Of::Stiffness => k,
        };
        entries[i + H * j]
    };
    let of_matrix = |_, reduced_columns, rows| of_matrix_alone::<C>(reduced_columns, rows);
    let (roots, are_certain) = find::<f64, H, C>(H, entry, of_matrix);
    let mut values = Vec::with_capacity(C);
    (are_certain && roots.sort_into(C, &mut values)).then_some(values)
}

/// The eigenvalues of a matrix of an even number of rows from four to sixteen, where they are certain.
pub(crate) fn spectrum(rows: &Square<f64>, reduced_columns: usize) -> Option<Spectrum> {
    if !IS_THERE {
        return None;
    }
    match rows.size() {
        4 => of_rows::<4>(rows, reduced_columns),
        6 => of_rows::<6>(rows, reduced_columns),
        8 => of_rows::<8>(rows, reduced_columns),
        10 => of_rows::<10>(rows, reduced_columns),
        12 => of_rows::<12>(rows, reduced_columns),
        14 => of_rows::<14>(rows, reduced_columns),
        16 => of_rows::<16>(rows, reduced_columns),
        _ => None,
    }
}

fn of_rows<const C: usize>(rows: &Square<f64>, reduced_columns: usize) -> Option<Spectrum> {
    let mut copy = [[0.0; C]; C];
    copy.iter_mut().zip(rows.rows()).for_each(|(copy, row)| copy.copy_from_slice(row));
    let (roots, are_certain) = of_matrix_alone::<C>(reduced_columns, copy);
    let Roots { re, im, norm } = roots;
    (are_certain && roots.are_of_one_size(C))
        .then(|| Spectrum { values: re.iter().zip(im).map(|(&re, im)| Complex::new(re, im)).collect(), norm })
}

#[inline(never)]
fn of_matrix_alone<const C: usize>(reduced_columns: usize, rows: [[f64; C]; C]) -> (Roots<f64, C>, bool) {
    of_matrix(C, reduced_columns, rows)
}
