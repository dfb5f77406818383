//! The states of a model, and the orders in which people have them.

use carvallo::{ModelInfo, States};

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

/// What a state matrix has rows and columns for, in which order, and why for nothing else.
pub fn words(info: &ModelInfo) -> String {
    let without = |states: States, suffix: &str| -> Option<String> {
        let own = info.coordinates.iter().filter(|own| own.states == states);
        let names: Vec<String> = own.map(|own| format!("{}{suffix}", own.name)).collect();
        let is = if names.len() == 1 { "is no state" } else { "are no states" };
        (!names.is_empty()).then(|| format!("; {} {is}", names.join(" and ")))
    };
    let mut text = names(info).join(", ");
    text += " in this order, rates before positions, or each position with its rate";
    if let Some(positions) = without(States::Rate, "") {
        text += &format!("{positions}, since nothing depends on where that is");
    }
    if let Some(rates) = without(States::Position, "_rate") {
        text += &format!("{rates}, since its equation is of first order");
    }
    text
}

/// The usual orders: positions before rates, rates before positions, and each position with its rate, before it or behind it.
pub fn orders(info: &ModelInfo) -> [Vec<usize>; 4] {
    let states = states(info);
    let natural: Vec<usize> = (0..states.len()).collect();
    let (positions, rates): (Vec<usize>, Vec<usize>) = natural.iter().partition(|&&at| !states[at].0);
    let mut pairs = natural.clone();
    pairs.sort_by_key(|&at| (states[at].1, states[at].0));
    let mut backwards = pairs.clone();
    backwards.sort_by_key(|&at| (states[at].1, !states[at].0));
    [natural, [rates, positions].concat(), pairs, backwards]
}
