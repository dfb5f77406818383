//! Numbers that are linear in the entries of matrices: these themselves, and C and K at a speed.

use carvallo::MatrixName;
use carvallo_slips::index;

use crate::given::{Quantity, SystemMatrix};
use crate::machine::Machine;
use crate::predict::Predictor;

/// An entry of a matrix, times a factor.
pub struct Term {
    /// Its formula, if the model has any for it.
    pub formula: Option<usize>,
    /// Its place among all entries.
    pub place: usize,
    pub factor: f64,
}

/// A number that is linear in the entries of the matrices.
pub struct Linear {
    /// Its place among those that are given.
    pub number: usize,
    /// The entries that it is made of.
    pub terms: Vec<Term>,
}

impl Term {
    /// Whether it is one of these formulas.
    pub fn is_of(&self, formulas: &[usize]) -> bool {
        self.formula.is_some_and(|own| formulas.contains(&own))
    }
}

/// The entries that a number is made of; none of what is not linear in them.
pub fn terms(machine: &Machine, predictor: &Predictor, quantity: Quantity, gravity: f64) -> Vec<Term> {
    let (row, column, factors) = match quantity {
        Quantity::Entry(matrix, row, column) => (row, column, vec![(matrix, 1.0)]),
        Quantity::System(at, row, column) => {
            let SystemMatrix { speed: v, is_stiffness, .. } = predictor.given().system_matrices[at];
            let factors = match is_stiffness {
                false => vec![(MatrixName::Cm1, 1.0 / v), (MatrixName::C0, 1.0), (MatrixName::C1, v)],
                true => {
                    vec![(MatrixName::Kc, 1.0), (MatrixName::K0, gravity), (MatrixName::K1, v), (MatrixName::K2, v * v)]
                }
            };
            (row, column, factors)
        }
        _ => return Vec::new(),
    };
    let term = |(matrix, factor): (MatrixName, f64)| Term {
        formula: machine.formulas.entry(matrix, row, column),
        place: index(matrix, row, column, machine.formulas.count),
        factor,
    };
    factors.into_iter().filter(|(_, factor)| *factor != 0.0).map(term).collect()
}
