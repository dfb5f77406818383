//! The pencil at one speed.

use super::{Square, dot};
use crate::numeric::{ComplexDoubleDouble, DoubleDouble};
use crate::system::States;

/// K, C and M at one speed, or derivatives of them, row by row.
pub(crate) struct Matrices {
    by_power: [Vec<DoubleDouble>; 3],
    /// The sizes of the terms that the entries are summed from.
    sizes: [Vec<f64>; 3],
    /// The power of s that each column of the pencil is divided by.
    lowered: Vec<usize>,
}

impl Matrices {
    /// Of a coordinate of which only the rate is a state the column of the pencil is `M s + C`.
    pub(super) fn new(by_power: [Vec<DoubleDouble>; 3], sizes: [Vec<f64>; 3], states: &[States]) -> Self {
        let lowered = states.iter().map(|states| usize::from(*states == States::Rate)).collect();
        Self { by_power, sizes, lowered }
    }

    /// The same with other columns divided by powers of s.
    pub(crate) fn lowered(self, lowered: &[usize]) -> Self {
        Self { lowered: lowered.to_vec(), ..self }
    }

    pub(crate) fn count(&self) -> usize {
        self.lowered.len()
    }

    /// Q(s), or its derivative of an order by s.
    pub(crate) fn at(&self, s: ComplexDoubleDouble, order: usize) -> Square {
        let entry = |place: usize| {
            let coefficients = self.by_power[self.lowered[place % self.count()]..].iter().map(|matrix| matrix[place]);
            let zero = ComplexDoubleDouble::ZERO;
            let terms: Vec<DoubleDouble> = coefficients.collect();
            // Of the derivative each coefficient has its falling factorial for a factor.
            let falling = |power: usize| (power + 1 - order..=power).map(|factor| factor as f64).product::<f64>();
            let powers = (order..terms.len()).rev();
            powers.fold(zero, |sum, power| sum * s + ComplexDoubleDouble::real(terms[power].times(falling(power))))
        };
        Square { size: self.count(), entries: (0..self.count() * self.count()).map(entry).collect() }
    }

    /// The sizes of the terms of the entries of Q(s) for |s|, or of its derivative.
    pub(crate) fn sizes(&self, s: f64, order: usize) -> Vec<f64> {
        let entry = |place: usize| {
            let terms = &self.sizes[self.lowered[place % self.count()]..];
            let falling = |power: usize| (power + 1 - order..=power).map(|factor| factor as f64).product::<f64>();
            (order..terms.len()).rev().fold(0.0, |sum, power| sum * s + terms[power][place] * falling(power))
        };
        (0..self.count() * self.count()).map(entry).collect()
    }

    /// `y^T Q x` of Q or its derivative.
    pub(crate) fn form(
        &self,
        [y, x]: [&[ComplexDoubleDouble]; 2],
        s: ComplexDoubleDouble,
        order: usize,
    ) -> ComplexDoubleDouble {
        dot(y, &self.at(s, order).times(x))
    }

    /// The same for sizes.
    pub(crate) fn form_of_sizes(
        &self,
        [y, x]: [&[ComplexDoubleDouble]; 2],
        s: ComplexDoubleDouble,
        order: usize,
    ) -> f64 {
        let sizes = self.sizes(s.norm(), order);
        let places = (0..sizes.len()).map(|place| (place / self.count(), place % self.count()));
        places.zip(&sizes).map(|((row, column), size)| y[row].norm() * size * x[column].norm()).sum()
    }
}
