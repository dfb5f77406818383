//! Guesses at what was done to coordinates and to their equations, in all matrices.

use super::factor::Factor;
use super::{Evidence, Guess, Place};

pub fn guesses(evidence: &Evidence<'_>) -> Vec<Guess<'static>> {
    let n = evidence.n();
    let alone = (0..n).flat_map(|one| of_one(evidence, one));
    let pairs = (0..n).flat_map(|one| (one + 1..n).map(move |other| (one, other)));
    alone.chain(pairs.flat_map(|(one, other)| of_two(evidence, one, other))).collect()
}

/// Its equation or its column with a factor, or both with a sign: counted in the other sense.
fn of_one(evidence: &Evidence<'_>, one: usize) -> Vec<Guess<'static>> {
    let (info, n) = (evidence.info, evidence.n());
    let name = info.coordinates[one].name;
    let sense = move |place: Place| ((place.1 == one) != (place.2 == one)).then_some(place);
    let mut all = vec![Guess::moved(n, format!("`{name}` is counted in the other sense"), Factor::MINUS, sense)];
    for factor in [-1.0, 2.0, 0.5].map(Factor::Number) {
        let says = factor.says(info);
        let row = move |place: Place| (place.1 == one).then_some(place);
        all.push(Guess::moved(n, format!("the equation of `{name}` {says}"), factor, row));
        let column = move |place: Place| (place.2 == one).then_some(place);
        all.push(Guess::moved(n, format!("the column of `{name}` {says} in each matrix"), factor, column));
    }
    all
}

fn of_two(evidence: &Evidence<'_>, one: usize, other: usize) -> [Guess<'static>; 3] {
    let [name, second] = [one, other].map(|index| evidence.info.coordinates[index].name);
    let turn = move |index: usize| match index {
        _ if index == one => other,
        _ if index == other => one,
        _ => index,
    };
    let guess = |what: &str, from: fn(Place, Place) -> Place| {
        let what = format!("the {what} `{name}` and `{second}` are exchanged");
        Guess::moved(evidence.n(), what, Factor::ONE, move |place| {
            Some(from(place, (place.0, turn(place.1), turn(place.2))))
        })
    };
    [
        guess("coordinates", |_, turned| turned),
        guess("equations of", |place, turned| (place.0, turned.1, place.2)),
        guess("columns of", |place, turned| (place.0, place.1, turned.2)),
    ]
}
