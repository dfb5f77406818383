//! Equations of motion of any number of coordinates along the speed, in units in which their numbers are about one.

use nalgebra::Complex;

use super::field::{ComplexField, RealField};
use super::units::Units;
use crate::eigenvalues::eigenvalues_of_rows;
use crate::numeric::DoubleDouble;
use crate::system::{Coefficients, Matrix, States, System, SystemError, require_finite};

/// What of a coordinate is a state, and by which power of s its column of the pencil is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Column {
    /// Position and rate: `s^2 M + s C + K`.
    Both,
    /// The position alone, of a coordinate of first order: `s C + K`.
    Position,
    /// The rate alone: `s M + C`.
    Rate,
    /// Neither, of a coordinate whose rate does not matter either: `M`.
    Neither,
}

/// `M q'' + (C_-1/v + C_0 + v C_1) q' + (K_0 + v K_1 + v^2 K_2) q = 0`, in scaled units.
pub(super) struct Equations<const N: usize> {
    mass: Matrix<f64, N>,
    /// By the powers -1, 0 and 1 of the speed.
    damping: [Matrix<f64, N>; 3],
    /// By the powers 0, 1 and 2 of the speed, the first without gravity.
    stiffness: [Matrix<f64, N>; 3],
    /// What is multiplied by gravity, and gravity.
    weight: (Matrix<f64, N>, f64),
    columns: [Column; N],
    /// `-M^-1` times damping and stiffness, where all rates are states: then no speed needs an elimination.
    solved: Option<[[Matrix<f64, N>; 3]; 2]>,
    /// Eigenvalues that are zero at all speeds, of coordinates that nothing holds and that are not declared as such.
    pub(super) zeros: usize,
    pub(super) units: Units<N>,
}

/// The pencil at an eigenvalue and a speed: a matrix that is singular where the eigenvalue is one, and its derivatives.
pub(super) struct Pencil<C, const N: usize> {
    pub(super) value: [[C; N]; N],
    pub(super) by_s: [[C; N]; N],
    pub(super) by_v: [[C; N]; N],
    pub(super) by_ss: [[C; N]; N],
    pub(super) by_sv: [[C; N]; N],
}

/// The eigenvalues at a speed, of the states alone.
pub(super) struct Spectrum<const N: usize> {
    values: [[Complex<f64>; 2]; N],
    count: usize,
    /// The norm of the balanced state matrix, by whose rounding eigenvalues err.
    pub(super) norm: f64,
}

impl<const N: usize> Spectrum<N> {
    pub(super) fn values(&self) -> &[Complex<f64>] {
        &self.values.as_flattened()[..self.count]
    }
}

impl<const N: usize> Equations<N> {
    pub(super) fn new(coefficients: &Coefficients<f64, N>, gravity: f64) -> Result<Self, SystemError> {
        require_finite("gravity", gravity)?;
        coefficients.require_finite()?;
        let units = Units::new(coefficients, gravity)?;
        let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, states } = units.scale(coefficients);
        let (damping, stiffness) = ([cm1, c0, c1], [kc, k1, k2]);
        let weight = (k0, units.scale_gravity(gravity));
        let is_zero =
            |matrices: &[Matrix<f64, N>], j: usize| matrices.iter().all(|m| m.column(j).iter().all(|&e| e == 0.0));
        let is_loose = |j: usize| is_zero(&stiffness, j) && (weight.1 == 0.0 || is_zero(&[k0], j));
        let mut zeros = 0;
        let columns = core::array::from_fn(|j| match states[j] {
            States::Position => Column::Position,
            declared => {
                zeros += usize::from(declared == States::Both && is_loose(j));
                if !is_loose(j) {
                    Column::Both
                } else if is_zero(&damping, j) {
                    zeros += 1;
                    Column::Neither
                } else {
                    Column::Rate
                }
            }
        });
        let mut equations = Self { mass: m, damping, stiffness, weight, columns, solved: None, zeros, units };
        if !columns.contains(&Column::Position) {
            let [damping0, damping1, damping2] = damping;
            let [_, stiffness1, stiffness2] = stiffness;
            let all = [damping0, damping1, damping2, equations.static_stiffness(), stiffness1, stiffness2];
            let [d0, d1, d2, k0, k1, k2] = System::new(m, m, m).solve(all.map(|matrix| -matrix))?;
            equations.solved = Some([[d0, d1, d2], [k0, k1, k2]]);
        }
        Ok(equations)
    }

    /// Whether damping is divided by the speed.
    pub(super) fn excludes_rest(&self) -> bool {
        self.damping[0].iter().any(|&entry| entry != 0.0)
    }

    /// Whether eigenvalues are algebraic in nothing but the coefficients: then what is made of them symmetrically is a
    /// polynomial in v and 1/v.
    pub(super) fn is_polynomial(&self) -> bool {
        self.solved.is_some()
    }

    fn static_stiffness(&self) -> Matrix<f64, N> {
        self.stiffness[0] + self.weight.0 * self.weight.1
    }

    /// The number of states.
    pub(super) fn states(&self) -> usize {
        let states = |column: &Column| match column {
            Column::Both => 2,
            Column::Position | Column::Rate => 1,
            Column::Neither => 0,
        };
        self.columns.iter().map(states).sum()
    }

    /// The eigenvalues at a scaled speed, by the QR algorithm.
    ///
    /// The state matrix is set up transposed, each position next to its rate, so that with a first coordinate that has
    /// both its first column is in Hessenberg form.
    pub(super) fn spectrum(&self, v: f64) -> Result<Spectrum<N>, SystemError> {
        let over = if self.excludes_rest() { 1.0 / v } else { 0.0 };
        let [damping, stiffness] = match &self.solved {
            Some([d, k]) => [d[0] * over + d[1] + d[2] * v, k[0] + (k[1] + k[2] * v) * v],
            None => {
                let c = self.damping[0] * over + self.damping[1] + self.damping[2] * v;
                let k = self.static_stiffness() + (self.stiffness[1] + self.stiffness[2] * v) * v;
                let mut leading = self.mass;
                for (j, _) in self.columns.iter().enumerate().filter(|(_, column)| **column == Column::Position) {
                    leading.set_column(j, &c.column(j));
                }
                System::new(leading, c, k).solve([-c, -k])?
            }
        };
        let mut rows = [[[[0.0; 2]; N]; 2]; N];
        let rows = rows.as_flattened_mut();
        // The places of the position, of the rate and of what the equations are solved for.
        let mut next = 0;
        let places: [[Option<usize>; 3]; N] = core::array::from_fn(|j| {
            let mut place = |is_there: bool| {
                next += usize::from(is_there);
                is_there.then(|| next - 1)
            };
            let position = place(matches!(self.columns[j], Column::Both | Column::Position));
            let rate = place(matches!(self.columns[j], Column::Both | Column::Rate));
            [position, rate, if self.columns[j] == Column::Position { position } else { rate }]
        });
        for (i, &[position, rate, _]) in places.iter().enumerate() {
            if let (Some(position), Some(rate), Column::Both) = (position, rate, self.columns[i]) {
                rows[rate].as_flattened_mut()[position] = 1.0;
            }
            for (state, matrix) in [(position, &stiffness), (rate, &damping)] {
                let Some(state) = state else { continue };
                for (j, &[_, _, solved]) in places.iter().enumerate() {
                    if let Some(solved) = solved {
                        rows[state].as_flattened_mut()[solved] = matrix[(j, i)];
                    }
                }
            }
        }
        let mut values = [[Complex::new(0.0, 0.0); 2]; N];
        let found = &mut values.as_flattened_mut()[..next];
        let first = usize::from(self.columns[0] == Column::Both);
        let norm = eigenvalues_of_rows(&mut rows[..next], first, found)?;
        if found.iter().any(|value| !value.re.is_finite() || !value.im.is_finite()) {
            return Err(SystemError::OutOfRange { quantity: "an eigenvalue" });
        }
        Ok(Spectrum { values, count: next, norm })
    }

    /// The pencil and its derivatives.
    pub(super) fn pencil<C: ComplexField>(&self, s: C, v: C::Real) -> Pencil<C, N> {
        let zero = C::Real::from(0.0);
        let square = s * s;
        let over = if self.excludes_rest() { C::Real::from(1.0) / v } else { zero };
        let zeros = [[C::real(zero); N]; N];
        let mut pencil = Pencil { value: zeros, by_s: zeros, by_v: zeros, by_ss: zeros, by_sv: zeros };
        for i in 0..N {
            for j in 0..N {
                let at = |matrix: &Matrix<f64, N>| C::Real::from(matrix[(i, j)]);
                let m = at(&self.mass);
                let (over_c, c1) = (at(&self.damping[0]) * over, at(&self.damping[2]));
                let c = over_c + at(&self.damping[1]) + c1 * v;
                let c_by_v = c1 - over_c * over;
                let weight = C::Real::product(self.weight.0[(i, j)], self.weight.1);
                let (k1, k2) = (at(&self.stiffness[1]), at(&self.stiffness[2]) * v);
                let k = at(&self.stiffness[0]) + weight + (k1 + k2) * v;
                let k_by_v = k1 + k2 + k2;
                match self.columns[j] {
                    Column::Both | Column::Position => {
                        pencil.value[i][j] = square.times(m) + s.times(c) + C::real(k);
                        pencil.by_s[i][j] = s.times(m + m) + C::real(c);
                        pencil.by_v[i][j] = s.times(c_by_v) + C::real(k_by_v);
                        pencil.by_ss[i][j] = C::real(m + m);
                        pencil.by_sv[i][j] = C::real(c_by_v);
                    }
                    Column::Rate => {
                        pencil.value[i][j] = s.times(m) + C::real(c);
                        pencil.by_s[i][j] = C::real(m);
                        pencil.by_v[i][j] = C::real(c_by_v);
                    }
                    Column::Neither => pencil.value[i][j] = C::real(m),
                }
            }
        }
        pencil
    }

    /// The magnitudes of the terms of the pencil: what rounding of the coefficients is relative to.
    pub(super) fn magnitudes(&self, s: f64, v: f64) -> [[f64; N]; N] {
        let over = if self.excludes_rest() { 1.0 / v } else { 0.0 };
        let powers = [over, 1.0, v];
        core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                let sum = |matrices: &[Matrix<f64, N>; 3], powers: [f64; 3]| -> f64 {
                    matrices.iter().zip(powers).map(|(matrix, power)| matrix[(i, j)].abs() * power).sum()
                };
                let m = self.mass[(i, j)].abs();
                let c = sum(&self.damping, powers);
                let k = sum(&self.stiffness, [1.0, v, v * v]) + (self.weight.0[(i, j)] * self.weight.1).abs();
                match self.columns[j] {
                    Column::Both | Column::Position => s * s * m + s * c + k,
                    Column::Rate => s * m + c,
                    Column::Neither => m,
                }
            })
        })
    }

    /// A scaled speed in m/s.
    pub(super) fn speed(&self, scaled: DoubleDouble) -> f64 {
        self.units.speed(scaled.to_f64())
    }
}
