//! The equations of motion along the speed.

use super::matrices::Matrices;
use crate::numeric::DoubleDouble;
use crate::system::{Coefficients, MatrixName, States, System};

/// The coefficient matrices, or derivatives of them, row by row.
#[derive(Clone, Debug)]
pub(crate) struct Equations {
    /// By the place in [`MatrixName::ALL`].
    matrices: [Vec<f64>; 8],
    gravity: f64,
    states: Vec<States>,
}

impl Equations {
    pub(crate) fn new<const N: usize>(coefficients: &Coefficients<f64, N>, gravity: f64) -> Self {
        Self::from_columns(&|name| coefficients.matrix(name).as_slice(), gravity, &coefficients.states)
    }

    /// Not generic, so that it is compiled once.
    fn from_columns<'a>(matrix: &dyn Fn(MatrixName) -> &'a [f64], gravity: f64, states: &[States]) -> Self {
        let matrices = MatrixName::ALL.map(|name| by_rows(matrix(name), states.len()));
        Self { matrices, gravity, states: states.to_vec() }
    }

    /// The matrices at a speed.
    pub(crate) fn at(&self, speed: DoubleDouble) -> Matrices {
        let over = self.over(|| DoubleDouble::from(1.0) / speed);
        let gravity = self.gravity.into();
        let one = DoubleDouble::from(1.0);
        self.sum([one, over, one, speed, one, gravity, speed, speed * speed])
    }

    /// Their derivatives by the speed.
    pub(crate) fn by_speed(&self, speed: DoubleDouble) -> Matrices {
        let over = self.over(|| -(DoubleDouble::from(1.0) / (speed * speed)));
        let (zero, one) = (DoubleDouble::ZERO, DoubleDouble::from(1.0));
        self.sum([zero, over, zero, one, zero, zero, one, speed + speed])
    }

    /// Columns that are zero in all stiffness matrices, though positions are states: of each an eigenvalue is zero at all
    /// speeds.
    pub(crate) fn is_loose(&self, column: usize) -> bool {
        let [_, _, _, _, kc, k0, k1, k2] = &self.matrices;
        let count = self.states.len();
        let is_zero = |matrix: &[f64]| matrix.iter().skip(column).step_by(count).all(|&entry| entry == 0.0);
        is_zero(kc) && is_zero(k1) && is_zero(k2) && (self.gravity == 0.0 || is_zero(k0))
    }

    pub(crate) fn states(&self) -> &[States] {
        &self.states
    }

    /// Without C-1 nothing is divided by a speed of zero.
    fn over(&self, over: impl Fn() -> DoubleDouble) -> DoubleDouble {
        let is_there = self.matrices[1].iter().any(|&entry| entry != 0.0);
        if is_there { over() } else { DoubleDouble::ZERO }
    }

    /// The matrices in the order of their names, each with its factor.
    fn sum(&self, [m, cm1, c0, c1, kc, k0, k1, k2]: [DoubleDouble; 8]) -> Matrices {
        let of = |terms: &[(usize, DoubleDouble)]| -> Vec<DoubleDouble> {
            let entries = 0..self.matrices[0].len();
            let term =
                |entry: usize, &(matrix, factor): &(usize, DoubleDouble)| factor.times(self.matrices[matrix][entry]);
            entries.map(|entry| terms.iter().fold(DoubleDouble::ZERO, |sum, of| sum + term(entry, of))).collect()
        };
        let size_of = |terms: &[(usize, DoubleDouble)]| -> Vec<f64> {
            let entries = 0..self.matrices[0].len();
            let term = |entry: usize, &(matrix, factor): &(usize, DoubleDouble)| {
                (factor.to_f64() * self.matrices[matrix][entry]).abs()
            };
            entries.map(|entry| terms.iter().map(|of| term(entry, of)).sum()).collect()
        };
        let [stiffness, damping, mass] =
            [&[(4, kc), (5, k0), (6, k1), (7, k2)][..], &[(1, cm1), (2, c0), (3, c1)], &[(0, m)]];
        Matrices::new(
            [of(stiffness), of(damping), of(mass)],
            [size_of(stiffness), size_of(damping), size_of(mass)],
            &self.states,
        )
    }
}

impl Matrices {
    /// Those of a system.
    pub(crate) fn of_system<const N: usize>(system: &System<N>) -> Self {
        Self::from_columns([system.k.as_slice(), system.c.as_slice(), system.m.as_slice()], &system.states)
    }

    fn from_columns(matrices: [&[f64]; 3], states: &[States]) -> Self {
        let rows = matrices.map(|columns| by_rows(columns, states.len()));
        Self::of_rows(rows.each_ref().map(Vec::as_slice), states)
    }

    /// Those of K, C and M, row by row.
    pub(crate) fn of_rows(rows: [&[f64]; 3], states: &[States]) -> Self {
        let wide = rows.map(|rows| rows.iter().copied().map(DoubleDouble::from).collect());
        Self::new(wide, rows.map(|rows| rows.iter().copied().map(f64::abs).collect()), states)
    }
}

fn by_rows(columns: &[f64], count: usize) -> Vec<f64> {
    (0..count).flat_map(|row| columns.iter().skip(row).step_by(count).copied()).collect()
}
