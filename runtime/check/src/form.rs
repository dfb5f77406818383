//! How a state matrix was written as a whole: in which order of states, and whether it is transposed or has the other sign.
//!
//! Its rows that say what a rate is tell that: there is a 1 in each, and nothing else.

use carvallo::{ModelInfo, States};

use crate::given::{Given, Rows, StateMatrix};
use crate::states::{orders, states};

/// More than rounding leaves of a 1 or a 0.
const ROUNDING: f64 = 1e-9;

/// What becomes of a matrix before its rows are those of a state matrix.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Form {
    is_transposed: bool,
    is_negative: bool,
}

const FORMS: [Form; 4] = [
    Form { is_transposed: false, is_negative: false },
    Form { is_transposed: true, is_negative: false },
    Form { is_transposed: false, is_negative: true },
    Form { is_transposed: true, is_negative: true },
];

impl Form {
    /// Of a matrix that has as many rows and columns as there are states.
    fn mend(self, rows: &Rows) -> Rows {
        let mut own = rows.clone();
        if self.is_transposed {
            (0..own.len()).for_each(|row| (0..own.len()).for_each(|at| own[row][at].clone_from(&rows[at][row])));
        }
        if self.is_negative {
            own.iter_mut().flatten().flatten().for_each(|entry| entry.value = -entry.value);
        }
        own
    }

    fn words(self) -> &'static str {
        match (self.is_transposed, self.is_negative) {
            (true, true) => "was filled row by column and has the other sign: it is transposed and negative",
            (true, false) => "was filled row by column: it is transposed",
            _ => "has the other sign",
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

/// With state matrices that are those of a machine, where some are transposed or negative as a whole, and what was told to be so.
pub fn mended(given: &Given, info: &ModelInfo) -> Option<(Given, Vec<String>)> {
    let forms: Vec<Form> = given.state_matrices.iter().map(|own| form(own, info)).collect();
    let is_one = forms.windows(2).all(|both| both[0] == both[1]);
    let mut own = given.clone();
    let mut told = Vec::new();
    for (at, (matrix, form)) in own.state_matrices.iter_mut().zip(forms).enumerate() {
        if form != Form::default() {
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
    let is_told = |form: &Form| {
        let rows = form.mend(&matrix.rows);
        orders(info).iter().any(|order| known(&rows, order, info).all(|agrees| agrees))
    };
    FORMS.into_iter().filter(|_| has_any).find(is_told).unwrap_or_default()
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
            entry.as_ref().is_none_or(|entry| (entry.value - expected).abs() < ROUNDING)
        });
        agrees.collect()
    };
    let all: Vec<bool> = own.into_iter().flat_map(|(row, state)| agrees(row, states[*state].1)).collect();
    all.into_iter()
}
