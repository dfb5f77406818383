//! Angles that are counted from one another in the place of from one direction, and the other way round.

use carvallo::ModelInfo;

use super::{Convention, Effect};

/// Of angles about one axis, as those of links and of trailers are; that of a steer axis is about another one.
pub fn coordinates(info: &ModelInfo) -> Vec<Convention> {
    let all = info.coordinates;
    let count = all.len();
    let angles: Vec<usize> = (0..count).filter(|at| all[*at].unit == "rad").collect();
    if all.iter().any(|own| own.label == "steer") {
        return Vec::new();
    }
    let mut found = Vec::new();
    // Ours are theirs, and less or more of those before them.
    let mut add = |what: String, share: &dyn Fn(usize, usize) -> f64| {
        let entry = |at: usize| if at / count == at % count { 1.0 } else { share(at / count, at % count) };
        let shares = (0..count * count).map(entry).collect();
        found.push(Convention { what, effect: Effect::Coordinates(shares), rank: 0 });
    };
    for (place, &own) in angles.iter().enumerate() {
        for &before in &angles[..place] {
            let [name, other] = [own, before].map(|at| all[at].name);
            let is = move |row: usize, column: usize| (row, column) == (own, before);
            add(format!("{name} is {other} + {name} of here: it is absolute"), &|row, column| {
                if is(row, column) { -1.0 } else { 0.0 }
            });
            add(format!("{name} is {name} - {other} of here: it is relative"), &|row, column| {
                if is(row, column) { 1.0 } else { 0.0 }
            });
        }
    }
    if angles.len() > 2 {
        let place = |at: usize| angles.iter().position(|own| *own == at);
        add("angles are absolute, and relative here".to_owned(), &|row, column| match (place(row), place(column)) {
            (Some(row), Some(column)) if row == column + 1 => -1.0,
            _ => 0.0,
        });
        add("angles are relative, and absolute here".to_owned(), &|row, column| match (place(row), place(column)) {
            (Some(row), Some(column)) if row > column => 1.0,
            _ => 0.0,
        });
    }
    found
}

/// `T^T X T` of each matrix X, with our coordinates T times theirs.
pub(super) fn transform(entries: &mut [f64], shares: &[f64], count: usize) {
    for matrix in entries.chunks_exact_mut(count * count) {
        let old = matrix.to_vec();
        for (at, entry) in matrix.iter_mut().enumerate() {
            let [row, column] = [at / count, at % count];
            let terms = (0..count * count).map(|inner| {
                let [a, b] = [inner / count, inner % count];
                shares[a * count + row] * old[inner] * shares[b * count + column]
            });
            *entry = terms.sum();
        }
    }
}
