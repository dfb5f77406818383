//! Single entries that are lost, have the other sign, or stand at another place.

use carvallo::{MatrixName, ModelInfo};

use super::{Assignment, Convention};
use carvallo_slips::entry_name;
use carvallo_slips::index;

/// All of them, for matrices with these entries.
pub fn entries(info: &ModelInfo, entries: &[f64]) -> Vec<Convention> {
    let count = info.coordinates.len();
    let places = |matrix: MatrixName| (0..count * count).map(move |at| (matrix, at / count, at % count));
    let at = |(matrix, row, column): (MatrixName, usize, usize)| index(matrix, row, column, count);
    let name = |(matrix, row, column): (MatrixName, usize, usize)| entry_name(matrix, row, column);
    let all: Vec<_> = info.matrices.iter().flat_map(|&matrix| places(matrix)).collect();
    let mut found = Vec::new();
    for &own in all.iter().filter(|&&own| entries[at(own)] != 0.0) {
        for (what, factor) in [
            ("is lost", 0.0),
            ("has the other sign", -1.0),
            ("is twice what it is here", 2.0),
            ("is half of what it is here", 0.5),
        ] {
            let assignment = Assignment::times(at(own), at(own), factor);
            found.push(Convention::of_entries(format!("{} {what}", name(own)), vec![assignment]).ranked(1));
        }
    }
    for &own in &all {
        // In other matrices only where there are few: others would fit by chance.
        let is_near = |other: &(MatrixName, usize, usize)| count == 2 || other.0 == own.0;
        for &other in all.iter().filter(|&&other| other != own && is_near(&other) && entries[at(other)] != 0.0) {
            // In a matrix of two rows that is told of its halves.
            let is_transposed = other.0 == own.0 && (other.1, other.2) == (own.2, own.1);
            for (sign, factor) in [("", 1.0), ("-", -1.0)] {
                if !(is_transposed && count == 2) {
                    let what = format!("{} has the value of {sign}{}", name(own), name(other));
                    found.push(
                        Convention::of_entries(what, vec![Assignment::times(at(own), at(other), factor)]).ranked(3),
                    );
                }
            }
            if at(own) < at(other) && !is_transposed {
                let what = format!("{} and {} are exchanged", name(own), name(other));
                let both = [(own, other), (other, own)];
                let both = both.map(|(to, from)| Assignment::times(at(to), at(from), 1.0));
                found.push(Convention::of_entries(what, both.to_vec()).ranked(2));
            }
        }
    }
    found
}
