//! The states of a model, and the orders in which people have them.

use carvallo::{ModelInfo, States};

use crate::given::StateMatrix;

/// The states in the order of the library, positions before rates: whether each is a rate, and of which coordinate.
pub fn states(info: &ModelInfo) -> Vec<(bool, usize)> {
    let of = |is_rate: bool, without: States| {
        let coordinates = info.coordinates.iter().enumerate();
        coordinates.filter(move |(_, own)| own.states != without).map(move |(at, _)| (is_rate, at))
    };
    of(false, States::Rate).chain(of(true, States::Position)).collect()
}

/// What they are called, in this order: `phi`, `phi_rate`.
pub fn names(info: &ModelInfo) -> Vec<String> {
    let name = |(is_rate, of): (bool, usize)| {
        let own = info.coordinates[of].name;
        if is_rate { format!("{own}_rate") } else { own.to_owned() }
    };
    states(info).into_iter().map(name).collect()
}

/// Which of the usual orders of states a matrix is in: positions before rates, rates before positions, or each position with
/// its rate. Its rows that say what a rate is tell, and where they do not, it is the first.
pub fn order(matrix: &StateMatrix, info: &ModelInfo) -> Vec<usize> {
    let states = states(info);
    let natural: Vec<usize> = (0..states.len()).collect();
    let (positions, rates): (Vec<usize>, Vec<usize>) = natural.iter().partition(|&&at| !states[at].0);
    let mut pairs = natural.clone();
    pairs.sort_by_key(|&at| (states[at].1, states[at].0));
    let mut backwards = pairs.clone();
    backwards.sort_by_key(|&at| (states[at].1, !states[at].0));
    let orders = [natural, [rates, positions].concat(), pairs, backwards];
    let rank = |order: &Vec<usize>| {
        let is_known = |row: usize, column: usize| {
            let ((is_rate, of), (is_other_rate, other)) = (states[order[row]], states[order[column]]);
            let entry = matrix.rows.get(row).and_then(|row| row.get(column)).and_then(Option::as_ref);
            let expected = f64::from(is_other_rate && of == other);
            is_rate || entry.is_none_or(|entry| (entry.value - expected).abs() < 1e-9)
        };
        (0..order.len()).map(|row| (0..order.len()).filter(|&column| is_known(row, column)).count()).sum::<usize>()
    };
    // Of equals the first.
    orders.into_iter().rev().max_by_key(rank).unwrap_or_default()
}
