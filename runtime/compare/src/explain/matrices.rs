//! Guesses at what was done to whole matrices.

use carvallo::MatrixName;

use super::factor::{Factor, factors};
use super::{AtDesign, Evidence, Guess, Place, position};

/// Those of the matrices that have wrong entries: only they can be it.
pub fn guesses(evidence: &Evidence<'_>, wrong: &[MatrixName]) -> Vec<Guess<'static>> {
    let (info, n) = (evidence.info, evidence.n());
    let mut all: Vec<Guess<'static>> = wrong.iter().flat_map(|name| of_one(evidence, *name)).collect();
    all.extend(factors(info).map(|factor| Guess::moved(n, format!("each matrix {}", factor.says(info)), factor, Some)));
    all.extend(wrong.iter().map(|name| {
        let what = format!("{name} is transposed and has the opposite sign");
        Guess { is_another: false, ..Guess::moved(n, what, Factor::MINUS, transposed(*name)) }
    }));
    for (index, one) in wrong.iter().enumerate() {
        all.extend(wrong[index + 1..].iter().map(|other| exchanged(n, *one, *other)));
        let others = wrong.iter().filter(|other| *other != one);
        all.extend(others.map(|other| written_into(evidence, *one, *other)));
    }
    all
}

/// Transposed, or with a factor.
fn of_one(evidence: &Evidence<'_>, name: MatrixName) -> Vec<Guess<'static>> {
    let (info, n) = (evidence.info, evidence.n());
    let mut all = Vec::new();
    if n > 1 {
        all.push(Guess::moved(n, format!("{name} is transposed"), Factor::ONE, transposed(name)));
    }
    all.extend(factors(info).map(|factor| {
        let same = move |place: Place| (place.0 == name).then_some(place);
        Guess::moved(n, format!("{name} {}", factor.says(info)), factor, same)
    }));
    all
}

fn transposed(name: MatrixName) -> impl Fn(Place) -> Option<Place> {
    move |(matrix, row, column)| (matrix == name).then_some((name, column, row))
}

fn exchanged(n: usize, one: MatrixName, other: MatrixName) -> Guess<'static> {
    let from = move |(matrix, row, column)| match matrix {
        _ if matrix == one => Some((other, row, column)),
        _ if matrix == other => Some((one, row, column)),
        _ => None,
    };
    Guess::moved(n, format!("{one} and {other} are exchanged"), Factor::ONE, from)
}

/// A matrix was added to another: `g K0` to Kc.
fn written_into(evidence: &Evidence<'_>, from: MatrixName, to: MatrixName) -> Guess<'static> {
    let (info, n) = (evidence.info, evidence.n());
    let gravity = info.gravity.filter(|_| (from, to) == (MatrixName::K0, MatrixName::Kc));
    let factor = gravity.map_or(Factor::ONE, Factor::Parameter);
    let with = gravity.map_or(String::new(), |index| format!(", with `{}` in it", info.parameters[index].name));
    let entries = move |at: &AtDesign| {
        let mut entries = at.exact.clone();
        for (row, column) in (0..n * n).map(|index| (index / n, index % n)) {
            let [from, to] = [from, to].map(|name| position(n, (name, row, column)));
            entries[to] += factor.at(at) * at.exact[from];
            entries[from] = 0.0;
        }
        Some(entries)
    };
    let what = format!("what belongs into {from} stands in {to}{with}");
    Guess { what, of_entries: false, is_another: true, entries: Box::new(entries) }
}
