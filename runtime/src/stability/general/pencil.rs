//! The pencil `s^2 M + s C + K` of the equations of motion, without the powers of s that divide its columns.

use super::equations::{Column, Equations};
use super::field::ComplexField;
use crate::numeric::Square;

/// The pencil at an eigenvalue and a speed: a matrix that is singular where the eigenvalue is one, and its derivatives.
pub(super) struct Pencil<C> {
    pub(super) value: Square<C>,
    pub(super) by_s: Square<C>,
    pub(super) by_v: Square<C>,
    pub(super) by_ss: Square<C>,
    pub(super) by_sv: Square<C>,
}

impl Equations {
    /// The pencil and its derivatives.
    pub(super) fn pencil<C: ComplexField>(&self, s: C, v: C::Real) -> Pencil<C> {
        // Complex numbers take longer, and those of twice the precision longer still.
        self.tally(size_of::<C>() / size_of::<f64>());
        let (values, square) = (self.values(v), s * s);
        let zeros = Square::filled(self.columns.len(), C::real(0.0.into()));
        let mut pencil = Pencil {
            value: zeros.clone(),
            by_s: zeros.clone(),
            by_v: zeros.clone(),
            by_ss: zeros.clone(),
            by_sv: zeros,
        };
        for i in 0..self.columns.len() {
            for (j, column) in self.columns.iter().enumerate() {
                let [m, c, k] = [&self.mass, &self.damping, &self.stiffness].map(|sum| sum.entry([i, j], &values));
                let ([m, m_by_v], [c, c_by_v], [k, k_by_v]) = (m, c, k);
                match column {
                    Column::Both | Column::Position => {
                        pencil.value[i][j] = square.times(m) + s.times(c) + C::real(k);
                        pencil.by_s[i][j] = s.times(m + m) + C::real(c);
                        pencil.by_v[i][j] = square.times(m_by_v) + s.times(c_by_v) + C::real(k_by_v);
                        pencil.by_ss[i][j] = C::real(m + m);
                        pencil.by_sv[i][j] = s.times(m_by_v + m_by_v) + C::real(c_by_v);
                    }
                    Column::Rate => {
                        pencil.value[i][j] = s.times(m) + C::real(c);
                        pencil.by_s[i][j] = C::real(m);
                        pencil.by_v[i][j] = s.times(m_by_v) + C::real(c_by_v);
                        pencil.by_sv[i][j] = C::real(m_by_v);
                    }
                    Column::Neither => {
                        pencil.value[i][j] = C::real(m);
                        pencil.by_v[i][j] = C::real(m_by_v);
                    }
                }
            }
        }
        pencil
    }

    /// The magnitudes of the terms of the pencil: what rounding of the coefficients is relative to.
    pub(super) fn magnitudes(&self, s: f64, v: f64) -> Square<f64> {
        let values = self.values(v);
        let [m, c, k] = [&self.mass, &self.damping, &self.stiffness].map(|sum| sum.magnitudes(&values));
        Square::from_fn(self.columns.len(), |i, j| match self.columns[j] {
            Column::Both | Column::Position => s * s * m[i][j] + s * c[i][j] + k[i][j],
            Column::Rate => s * m[i][j] + c[i][j],
            Column::Neither => m[i][j],
        })
    }
}
