//! What is linear in the entries of the matrices, and holds wherever the numbers that were given agree.
//!
//! An entry of a matrix is what was given; C and K at a speed are sums of entries; and behind a state matrix stands
//! `M q'' + C q' + K q = 0` for each of its columns, with the accelerations `q''` that are in it.

use carvallo::{MatrixName, ModelInfo};
use carvallo_slips::index;

use crate::conventions::Assignment;
use crate::given::{Quantity, SystemMatrix};
use crate::predict::Predictor;
use crate::states::states;

/// What is left of sums where nothing is wrong, relative to their terms.
const ROUNDING: f64 = 1e-12;

/// An entry of a matrix, times a factor.
#[derive(Clone, Copy, Debug)]
pub struct Term {
    /// Its place among all entries.
    pub place: usize,
    /// Without the gravitational field strength, by which `has_weight` tells that it is multiplied.
    factor: f64,
    /// How far the factor may be from another one that was rounded to the same digits.
    slack: f64,
    has_weight: bool,
}

/// A sum of entries of the closed loop that has this value where all numbers agree.
#[derive(Clone, Debug)]
pub struct Relation {
    /// The entries that it is made of.
    pub terms: Vec<Term>,
    value: f64,
    tolerance: f64,
    rounding: f64,
}

impl Term {
    /// What it is multiplied by.
    pub fn factor(&self, gravity: f64) -> f64 {
        if self.has_weight { self.factor * gravity } else { self.factor }
    }

    /// Whether the factor is more than digits that are not known.
    pub fn is_seen(&self) -> bool {
        self.factor.abs() > self.slack
    }
}

impl Relation {
    /// Whether it holds for these entries.
    pub fn holds(&self, entries: &[f64], gravity: f64) -> bool {
        let [off, allowed] = self.off(entries, gravity);
        off.abs() <= allowed
    }

    /// By how much the sum is larger than its value, and by how much it may be.
    pub fn off(&self, entries: &[f64], gravity: f64) -> [f64; 2] {
        let (mut off, mut allowed) = (-self.value, self.tolerance);
        for term in &self.terms {
            let (entry, factor) = (entries[term.place], term.factor(gravity));
            off += factor * entry;
            allowed += (term.slack + self.rounding * factor.abs()) * entry.abs();
        }
        [off, allowed]
    }

    /// The size of what is added up.
    pub fn size(&self, entries: &[f64], gravity: f64) -> f64 {
        let terms = self.terms.iter().map(|term| (term.factor(gravity) * entries[term.place]).abs());
        terms.sum::<f64>() + self.value.abs()
    }

    /// The same of the entries before some of them get other values.
    pub fn before(&self, assignments: &[Assignment]) -> Self {
        let mut own = self.clone();
        for term in &mut own.terms {
            if let Some(&Assignment { from, factor, constant, .. }) =
                assignments.iter().rfind(|change| change.to == term.place)
            {
                own.value -= term.factor * constant;
                own.tolerance += (term.slack + self.rounding * term.factor.abs()) * constant.abs();
                *term = Term { place: from, factor: factor * term.factor, slack: factor.abs() * term.slack, ..*term };
            }
        }
        own
    }

    /// The same of the entries of the open loop, from which feedback takes these.
    pub fn of_open_loop(mut self, closing: &[(usize, f64)], gravity: f64) -> Self {
        for &(place, closing) in closing {
            for term in self.terms.iter().filter(|term| term.place == place) {
                self.value += term.factor(gravity) * closing;
                self.tolerance += term.slack * closing.abs();
            }
        }
        self
    }
}

/// All relations of numbers, with the tolerances that they have.
pub fn relations(predictor: &Predictor, info: &ModelInfo) -> Vec<Relation> {
    let count = info.coordinates.len();
    let one_by_one = predictor.numbers().iter().zip(predictor.tolerances());
    let mut found: Vec<Relation> = one_by_one
        .filter_map(|((quantity, reading), &tolerance)| {
            let (terms, rounding) = match *quantity {
                Quantity::Entry(matrix, row, column) => {
                    let place = index(matrix, row, column, count);
                    (vec![Term { place, factor: 1.0, slack: 0.0, has_weight: false }], 0.0)
                }
                Quantity::System(at, row, column) => {
                    let SystemMatrix { speed, is_stiffness, .. } = predictor.given().system_matrices[at];
                    (system(is_stiffness, speed, (row, column), count, [1.0, 0.0]).collect(), ROUNDING)
                }
                _ => return None,
            };
            Some(Relation { terms, value: reading.value, tolerance, rounding })
        })
        .collect();
    for at in 0..predictor.given().state_matrices.len() {
        found.extend(of_state_matrix(predictor, info, at));
    }
    // At rest nothing is divided by the speed.
    found.retain(|own| own.terms.iter().all(|term| term.factor.is_finite()));
    found
}

/// The equations of motion of each state in which all accelerations are given, by the linear equations.
pub fn of_accelerations(predictor: &Predictor, info: &ModelInfo) -> Vec<Relation> {
    let count = info.coordinates.len();
    let mut found = Vec::new();
    for (state, given) in predictor.given().accelerations.iter().enumerate() {
        let number = |of: usize| {
            let wanted = Quantity::Acceleration(state, of);
            let at = predictor.numbers().iter().position(|(quantity, _)| *quantity == wanted)?;
            (!predictor.is_nonlinear(at)).then(|| [predictor.numbers()[at].1.value, predictor.tolerances()[at]])
        };
        let Some(numbers) = (0..count).map(number).collect::<Option<Vec<[f64; 2]>>>() else { continue };
        for row in 0..count {
            let mut terms = Vec::new();
            for (of, [factor, slack]) in numbers.iter().copied().enumerate() {
                terms.push(Term { place: index(MatrixName::M, row, of, count), factor, slack, has_weight: false });
                terms.extend(system(false, given.speed, (row, of), count, [given.rates[of], 0.0]));
                terms.extend(system(true, given.speed, (row, of), count, [given.positions[of], 0.0]));
            }
            found.push(Relation { terms, value: given.forces[row], tolerance: 0.0, rounding: ROUNDING });
        }
    }
    found.retain(|own| own.terms.iter().all(|term| term.factor.is_finite()));
    found
}

/// The entries of which that of C or K at a speed is made, each with a factor and its slack.
fn system(
    is_stiffness: bool,
    speed: f64,
    (row, column): (usize, usize),
    count: usize,
    [factor, slack]: [f64; 2],
) -> impl Iterator<Item = Term> {
    let powers = match is_stiffness {
        false => [(MatrixName::Cm1, -1), (MatrixName::C0, 0), (MatrixName::C1, 1)].to_vec(),
        true => [(MatrixName::Kc, 0), (MatrixName::K0, 0), (MatrixName::K1, 1), (MatrixName::K2, 2)].to_vec(),
    };
    let term = move |(matrix, power): (MatrixName, i32)| {
        let of_speed = speed.powi(power);
        let (factor, slack) = (of_speed * factor, of_speed.abs() * slack);
        Term { place: index(matrix, row, column, count), factor, slack, has_weight: matrix == MatrixName::K0 }
    };
    powers.into_iter().map(term).filter(|term| term.factor != 0.0 || term.slack != 0.0)
}

/// One for each column of which everything is known, and each row of the equations of motion.
fn of_state_matrix(predictor: &Predictor, info: &ModelInfo, at: usize) -> Vec<Relation> {
    let (count, states, order) = (info.coordinates.len(), states(info), predictor.order(at));
    let speed = predictor.given().state_matrices[at].speed;
    let mut numbers = vec![None; states.len() * states.len()];
    for ((quantity, reading), tolerance) in predictor.numbers().iter().zip(predictor.tolerances()) {
        if let Quantity::State(own, row, column) = *quantity
            && own == at
        {
            numbers[order[row] * states.len() + order[column]] = Some([reading.value, *tolerance]);
        }
    }
    let state = |is_rate: bool, of: usize| states.iter().position(|own| *own == (is_rate, of));
    let relation = |row: usize, column: usize| {
        let mut terms = Vec::new();
        for of in 0..count {
            let (position, rate) = (state(false, of), state(true, of));
            let derivative = |state: usize| numbers[state * states.len() + column];
            // Of a coordinate of first order the rate is what is solved for, and there is no acceleration.
            let damping = match rate {
                Some(rate) => {
                    let [factor, slack] = derivative(rate)?;
                    let place = index(MatrixName::M, row, of, count);
                    terms.push(Term { place, factor, slack, has_weight: false });
                    [f64::from(u8::from(rate == column)), 0.0]
                }
                None => derivative(position?)?,
            };
            let stiffness = [f64::from(u8::from(position == Some(column))), 0.0];
            terms.extend(system(false, speed, (row, of), count, damping));
            terms.extend(system(true, speed, (row, of), count, stiffness));
        }
        Some(Relation { terms, value: 0.0, tolerance: 0.0, rounding: ROUNDING })
    };
    (0..count).flat_map(|row| (0..states.len()).filter_map(move |column| relation(row, column))).collect()
}
