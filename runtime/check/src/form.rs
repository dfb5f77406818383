//! How a state matrix was written as a whole: in which order of states, whether it is transposed, and what it is multiplied by.
//!
//! Its rows that say what a rate is tell that: there is a 1 in each, and nothing else.

use carvallo::{ModelInfo, States};

use crate::given::{Given, Rows, StateMatrix};
use crate::states::{orders, states};

/// More than rounding leaves of a 1 or a 0.
const ROUNDING: f64 = 1e-9;

/// Of a speed in km/h that in m/s.
const KMH: f64 = 3.6;

/// What all entries of a matrix may be multiplied by.
const FACTORS: [f64; 4] = [1.0, -1.0, KMH, 1.0 / KMH];

/// What was done to all of a matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Form {
    is_transposed: bool,
    factor: f64,
}

/// A matrix as it should be.
const RIGHT: Form = Form { is_transposed: false, factor: 1.0 };

/// All of them, the likeliest first.
fn forms() -> impl Iterator<Item = Form> {
    FACTORS.into_iter().flat_map(|factor| [false, true].map(|is_transposed| Form { is_transposed, factor }))
}

impl Form {
    /// Of a matrix that has as many rows and columns as there are states.
    fn mend(self, rows: &Rows) -> Rows {
        let mut own = rows.clone();
        if self.is_transposed {
            (0..own.len()).for_each(|row| (0..own.len()).for_each(|at| own[row][at].clone_from(&rows[at][row])));
        }
        for entry in own.iter_mut().flatten().flatten() {
            entry.value /= self.factor;
            entry.tolerance /= self.factor.abs();
        }
        own
    }

    /// Whether all rows of a matrix that say what a rate is do so then, in some order.
    fn is_told(self, matrix: &StateMatrix, info: &ModelInfo) -> bool {
        let rows = self.mend(&matrix.rows);
        orders(info).iter().any(|order| known(&rows, order, info).all(|agrees| agrees))
    }

    fn words(self) -> String {
        let factor = match self.factor {
            1.0 => String::new(),
            -1.0 => "has the other sign".to_owned(),
            KMH => format!("is multiplied by {KMH}"),
            _ => format!("is divided by {KMH}"),
        };
        match (self.is_transposed, self.factor == 1.0) {
            (true, true) => "was filled row by column: it is transposed".to_owned(),
            (true, false) if self.factor == -1.0 => {
                "was filled row by column and has the other sign: it is transposed and negative".to_owned()
            }
            (true, false) => format!("was filled row by column and {factor}"),
            (false, _) => factor,
        }
    }
}

/// Which of the usual orders of states a matrix is in; where its rows do not tell, the first.
pub fn order(matrix: &StateMatrix, info: &ModelInfo) -> Vec<usize> {
    let rows = form(matrix, info).mend(&matrix.rows);
    let rank = |order: &Vec<usize>| known(&rows, order, info).filter(|agrees| *agrees).count();
    // Of equals the first.
    orders(info).into_iter().rev().max_by_key(rank).unwrap_or_default()
}

/// With state matrices that are those of a machine, where some are otherwise as a whole, and what was told to be so.
pub fn mended(given: &Given, info: &ModelInfo) -> Option<(Given, Vec<String>)> {
    let forms: Vec<Form> = given.state_matrices.iter().map(|own| form(own, info)).collect();
    with(given, &forms)
}

/// The same in all forms that may be those of all state matrices: without damping, as at rest, a matrix and its transpose both have rows
/// that say what a rate is, in two orders.
pub fn others(given: &Given, info: &ModelInfo) -> impl Iterator<Item = (Given, Vec<String>)> {
    let is_told = |form: &Form| given.state_matrices.iter().all(|own| form.is_told(own, info));
    forms().filter(is_told).filter_map(|form| with(given, &vec![form; given.state_matrices.len()]))
}

fn with(given: &Given, forms: &[Form]) -> Option<(Given, Vec<String>)> {
    let is_one = forms.windows(2).all(|both| both[0] == both[1]);
    let mut own = given.clone();
    let mut told = Vec::new();
    for (at, (matrix, form)) in own.state_matrices.iter_mut().zip(forms).enumerate() {
        if *form != RIGHT {
            matrix.rows = form.mend(&matrix.rows);
            let name = if is_one { "A".to_owned() } else { given.state_name(at) };
            told.push(format!("{name} {}", form.words()));
        }
    }
    told.dedup();
    (!told.is_empty()).then_some((own, told))
}

/// The first with which all rows that say what a rate is do so, in some order; the matrix as it is where there is none.
fn form(matrix: &StateMatrix, info: &ModelInfo) -> Form {
    let has_any = info.coordinates.iter().any(|own| own.states == States::Both);
    forms().filter(|_| has_any).find(|form| form.is_told(matrix, info)).unwrap_or(RIGHT)
}

/// Of each entry in a row that says what a rate is whether it is a 1 or a 0, as it should; entries that are not known are.
fn known(rows: &Rows, order: &[usize], info: &ModelInfo) -> impl Iterator<Item = bool> {
    let states = states(info);
    let is_of_rate = |state: &usize| !states[*state].0 && info.coordinates[states[*state].1].states == States::Both;
    let own: Vec<(usize, &usize)> = order.iter().enumerate().filter(|(_, state)| is_of_rate(state)).collect();
    let agrees = |row: usize, of: usize| -> Vec<bool> {
        let entries = rows[row].iter().zip(order);
        let agrees = entries.map(|(entry, column)| {
            let expected = f64::from(u8::from(states[*column] == (true, of)));
            entry.as_ref().is_none_or(|entry| {
                let off = (entry.value - expected).abs();
                // Of a factor with few digits a 1 has a few as well.
                off < ROUNDING || expected != 0.0 && entry.digits > 1 && off <= entry.tolerance
            })
        });
        agrees.collect()
    };
    let all: Vec<bool> = own.into_iter().flat_map(|(row, state)| agrees(row, states[*state].1)).collect();
    all.into_iter()
}
