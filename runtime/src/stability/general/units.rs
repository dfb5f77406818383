//! Units of rows, columns, time and speed for coordinates of any order, powers of two, in which the numbers are about one.

use nalgebra::Complex;

use super::equations::Matrices;
use crate::characteristic::units::{ldexp_complex, time_unit};
use crate::numeric::{Square, exponent, ldexp};
use crate::system::{States, SystemError};

/// The exponents of the units.
pub(super) struct Units {
    rows: Vec<i32>,
    columns: Vec<i32>,
    time: i32,
    speed: i32,
    gravity: i32,
}

impl Units {
    /// Rows and columns bring the largest entry of what each column is solved for, M or the damping of a coordinate of
    /// first order, to about one; then time brings damping and stiffness to at most one, and speed what depends on it.
    pub(super) fn new(Matrices { all, states }: &Matrices, gravity: f64) -> Result<Self, SystemError> {
        let ([m, cm1, c0, c1, kc, k0, k1, k2], size) = (all, states.len());
        let is_first_order = |j: usize| states[j] == States::Position;
        let leading = |i: usize, j: usize| {
            let matrices = if is_first_order(j) { [cm1, c0, c1] } else { [m; 3] };
            matrices.into_iter().filter_map(|matrix| exponent(matrix[i][j])).max()
        };
        let (rows, columns) = (vec![0; size], vec![0; size]);
        let mut units = Self { rows, columns, time: 0, speed: 0, gravity: exponent(gravity).unwrap_or(0) };
        for i in 0..size {
            units.rows[i] = -(0..size).filter_map(|j| leading(i, j)).max().ok_or(SystemError::SingularMass)?;
        }
        for j in 0..size {
            let largest = (0..size).filter_map(|i| Some(leading(i, j)? + units.rows[i])).max();
            units.columns[j] = -largest.ok_or(SystemError::SingularMass)?;
        }
        for j in (0..size).filter(|&j| is_first_order(j)) {
            units.balance_first_order(j, all, states);
        }
        let largest = |matrix: &Square<f64>, first_order: bool| {
            let columns = (0..size).filter(|&j| is_first_order(j) == first_order);
            let places = columns.flat_map(|j| (0..size).map(move |i| (i, j)));
            places.filter_map(|(i, j)| Some(exponent(matrix[i][j])? + units.rows[i] + units.columns[j])).max()
        };
        let weight = |first_order: bool| match gravity {
            0.0 => None,
            _ => largest(k0, first_order).map(|e| e + units.gravity),
        };
        // What a coordinate of first order returns with, in the unit of the others.
        let relaxation = largest(kc, true).max(weight(true)).max(largest(k1, true)).max(largest(k2, true));
        let damping = largest(c0, false).max(relaxation).or_else(|| largest(cm1, false));
        let time = time_unit(damping, largest(kc, false).max(weight(false)));
        let half = |e: i32| (e + 1).div_euclid(2);
        let rising = [largest(c1, false), largest(k1, false).map(|e| e - time), largest(k2, false).map(half)];
        let per_speed = rising.into_iter().max().flatten().or_else(|| largest(cm1, false).map(|e| 2 * time - e));
        // Columns of first order are solved for a rate, not an acceleration.
        for j in (0..size).filter(|&j| is_first_order(j)) {
            units.columns[j] += time;
        }
        Ok(Self { time, speed: time - per_speed.unwrap_or(time), ..units })
    }

    /// Brings what drives a coordinate of first order, and what it drives, to about the same size: it may be in a unit that
    /// makes one of them large, as a force is among angles.
    fn balance_first_order(
        &mut self,
        j: usize,
        [m, cm1, c0, c1, kc, k0, k1, k2]: &[Square<f64>; 8],
        states: &[States],
    ) {
        let size = states.len();
        let is_own = |i: usize| [cm1, c0, c1].into_iter().any(|c| c[i][j] != 0.0) && (0..size).all(|l| m[i][l] == 0.0);
        let others = |l: usize| states[l] != States::Position;
        let largest = |matrices: &[&Square<f64>], places: &mut dyn Iterator<Item = (usize, usize)>| {
            let exponents = places.flat_map(|(i, l)| {
                let unit = self.rows[i] + self.columns[l];
                matrices.iter().filter_map(move |matrix| Some(exponent(matrix[i][l])? + unit))
            });
            exponents.max()
        };
        let own: Vec<usize> = (0..size).filter(|&i| is_own(i)).collect();
        let driven = largest(&[kc, k0, k1, k2], &mut (0..size).filter(|i| !own.contains(i)).map(|i| (i, j)));
        let driving = largest(
            &[cm1, c0, c1, kc, k0, k1, k2],
            &mut own.iter().flat_map(|&i| (0..size).filter(|&l| others(l)).map(move |l| (i, l))),
        );
        if let (Some(driving), Some(driven)) = (driving, driven) {
            let shift = (driving - driven).div_euclid(2);
            self.columns[j] += shift;
            own.into_iter().for_each(|i| self.rows[i] -= shift);
        }
    }

    /// The coefficient matrices in these units.
    pub(super) fn scale(&self, [m, cm1, c0, c1, kc, k0, k1, k2]: &[Square<f64>; 8]) -> [Square<f64>; 8] {
        let scale = |matrix: &Square<f64>, [s, v]: [i32; 2], rest: i32| {
            let power = v * self.speed - (2 - s) * self.time + rest;
            let entry = |i: usize, j: usize| ldexp(matrix[i][j], self.rows[i] + self.columns[j] + power);
            Square::from_fn(matrix.size(), entry)
        };
        [
            scale(m, [2, 0], 0),
            scale(cm1, [1, -1], 0),
            scale(c0, [1, 0], 0),
            scale(c1, [1, 1], 0),
            scale(kc, [0, 0], 0),
            scale(k0, [0, 0], self.gravity),
            scale(k1, [0, 1], 0),
            scale(k2, [0, 2], 0),
        ]
    }

    /// A matrix that is multiplied by a power of s, and does not depend on the speed.
    pub(super) fn scale_matrix(&self, matrix: &Square<f64>, power: i32) -> Square<f64> {
        let time = -(2 - power) * self.time;
        Square::from_fn(matrix.size(), |i, j| ldexp(matrix[i][j], self.rows[i] + self.columns[j] + time))
    }

    /// A gravitational field strength in these units.
    pub(super) fn scale_gravity(&self, gravity: f64) -> f64 {
        ldexp(gravity, -self.gravity)
    }

    /// A scaled speed in m/s.
    pub(super) fn speed(&self, scaled: f64) -> f64 {
        ldexp(scaled, self.speed)
    }

    /// A scaled eigenvalue in 1/s.
    pub(super) fn eigenvalue(&self, scaled: Complex<f64>) -> Complex<f64> {
        ldexp_complex(scaled, self.time)
    }
}
