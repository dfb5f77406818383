//! Matrices before which a power of the speed is forgotten, or is another one.

use carvallo::{MatrixName, ModelInfo};
use carvallo_slips::index;

use super::{Assignment, Convention};

/// All of them, of what is at speeds, where no matrix of the model has that power already.
pub fn powers(info: &ModelInfo) -> Vec<Convention> {
    use MatrixName::{C0, C1, Cm1, K1, K2, Kc};
    let all = [
        (C1, "v*C1", C0, "C1"),
        (Cm1, "C-1/v", C0, "C-1"),
        (Cm1, "C-1/v", C1, "v*C-1"),
        (K1, "v*K1", Kc, "K1"),
        (K1, "v*K1", K2, "v^2*K1"),
        (K2, "v^2*K2", K1, "v*K2"),
        (K2, "v^2*K2", Kc, "K2"),
    ];
    let count = info.coordinates.len();
    let has = |matrix: &MatrixName| info.matrices.contains(matrix);
    let seen = all.into_iter().filter(|(from, _, to, _)| has(from) && !has(to));
    let convention = |(from, right, to, wrong): (MatrixName, &str, MatrixName, &str)| {
        let places = (0..count * count).map(|at| (at / count, at % count));
        let move_entry = |(row, column): (usize, usize)| {
            let [from, to] = [from, to].map(|matrix| index(matrix, row, column, count));
            [Assignment::times(to, from, 1.0), Assignment::constant(from, 0.0)]
        };
        let what = format!("{wrong} stands in the place of {right}");
        Convention::of_entries(what, places.flat_map(move_entry).collect())
    };
    seen.map(convention).collect()
}
