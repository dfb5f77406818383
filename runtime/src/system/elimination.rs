//! Systems of linear equations, whatever the order of their entries in memory.

use super::error::SystemError;
use crate::number::Scalar;

/// The solutions X of `M X = B` for several B, in their place, by elimination with pivots that are the largest relative to
/// their rows. M is overwritten, and so is a second matrix, whatever it is.
///
/// All matrices are of one size, with their entries at the place that a function gives for row and column.
///
/// # Errors
/// M is singular if a pivot is no more than the rounding of the terms that were subtracted to form it, whatever the scale
/// of its rows and columns.
#[inline]
pub(crate) fn solve_in_place<T: Scalar>(
    size: usize,
    at: impl Fn(usize, usize) -> usize,
    [m, terms]: [&mut [T]; 2],
    x: &mut [impl AsMut<[T]>],
) -> Result<(), SystemError> {
    if size == 2 {
        return solve_two(at, m, x);
    }
    let zero = T::from_f64(0.0);
    terms.iter_mut().zip(&*m).for_each(|(term, entry)| *term = entry.abs());
    for step in 0..size {
        let relative = |row: usize| {
            let sizes = (step..size).map(|column| entry(m, at(row, column)).abs());
            let largest = sizes.fold(zero, |largest, size| if size > largest { size } else { largest });
            if largest > zero { entry(m, at(row, step)).abs() / largest } else { zero }
        };
        let (mut pivot, mut pivot_size) = (step, relative(step));
        for row in step + 1..size {
            let candidate = relative(row);
            if candidate >= pivot_size {
                (pivot, pivot_size) = (row, candidate);
            }
        }
        for column in 0..size {
            let (from, to) = (at(pivot, column), at(step, column));
            swap(m, from, to);
            swap(terms, from, to);
            x.iter_mut().for_each(|x| swap(x.as_mut(), from, to));
        }
        let divisor = entry(m, at(step, step));
        if divisor.abs() <= T::from_f64(8.0) * T::EPSILON * entry(terms, at(step, step)) {
            return Err(SystemError::SingularMass);
        }
        for row in (0..size).filter(|&row| row != step) {
            let factor = entry(m, at(row, step)) / divisor;
            for column in step + 1..size {
                let product = factor * entry(m, at(step, column));
                change(m, at(row, column), |entry| entry - product);
                change(terms, at(row, column), |term| term + product.abs());
            }
            for x in &mut *x {
                let x = x.as_mut();
                for column in 0..size {
                    let product = factor * entry(x, at(step, column));
                    change(x, at(row, column), |entry| entry - product);
                }
            }
        }
    }
    for x in x {
        let x = x.as_mut();
        for row in 0..size {
            let divisor = entry(m, at(row, row));
            for column in 0..size {
                change(x, at(row, column), |entry| entry / divisor);
            }
        }
    }
    Ok(())
}

/// The same of two by two, operation by operation, without loops: a controller computes it at every sample.
#[inline]
fn solve_two<T: Scalar>(
    at: impl Fn(usize, usize) -> usize,
    m: &[T],
    x: &mut [impl AsMut<[T]>],
) -> Result<(), SystemError> {
    let zero = T::from_f64(0.0);
    let rounding = T::from_f64(8.0) * T::EPSILON;
    let relative = |[first, second]: [T; 2]| {
        let (first, second) = (first.abs(), second.abs());
        let largest = if second > first { second } else { first };
        if largest > zero { first / largest } else { zero }
    };
    let row = |row: usize| [entry(m, at(row, 0)), entry(m, at(row, 1))];
    let is_second = relative(row(1)) >= relative(row(0));
    let ([a, b], [c, d]) = if is_second { (row(1), row(0)) } else { (row(0), row(1)) };
    if a.abs() <= rounding * a.abs() {
        return Err(SystemError::SingularMass);
    }
    let below = c / a;
    let product = below * b;
    let last = d - product;
    if last.abs() <= rounding * (d.abs() + product.abs()) {
        return Err(SystemError::SingularMass);
    }
    let above = b / last;
    let solve = |first: &mut T, second: &mut T| {
        let (upper, lower) = if is_second { (*second, *first) } else { (*first, *second) };
        let lower = lower - below * upper;
        *first = (upper - above * lower) / a;
        *second = lower / last;
    };
    for x in x {
        let [first, between, beside, last] = x.as_mut() else { continue };
        let (above_last, below_first) = if at(0, 1) == 1 { (between, beside) } else { (beside, between) };
        solve(first, below_first);
        solve(above_last, last);
    }
    Ok(())
}

// Places are always inside. Indexing would link a panic into the programs of microcontrollers, which these do not.

#[inline(always)]
fn entry<T: Scalar>(matrix: &[T], place: usize) -> T {
    matrix.get(place).copied().unwrap_or(T::from_f64(0.0))
}

#[inline(always)]
fn change<T: Scalar>(matrix: &mut [T], place: usize, to: impl FnOnce(T) -> T) {
    if let Some(entry) = matrix.get_mut(place) {
        *entry = to(*entry);
    }
}

#[inline(always)]
fn swap<T: Scalar>(matrix: &mut [T], from: usize, to: usize) {
    let (first, second) = (entry(matrix, from), entry(matrix, to));
    change(matrix, from, |_| second);
    change(matrix, to, |_| first);
}
