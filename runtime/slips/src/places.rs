//! Where the entries of matrices stand among all of them, and what they are called.

use carvallo::MatrixName;

/// Where an entry is among those of all matrices, matrix by matrix in the order of [`MatrixName::ALL`] and row by row.
pub fn index(matrix: MatrixName, row: usize, column: usize, count: usize) -> usize {
    let at = MatrixName::ALL.iter().position(|name| *name == matrix).unwrap_or_default();
    (at * count + row) * count + column
}

/// The matrix, the row and the column of the entry at a place.
pub fn place(at: usize, count: usize) -> (MatrixName, usize, usize) {
    (MatrixName::ALL[at / (count * count)], at / count % count, at % count)
}

/// `M_12`, with row and column from one; they come from zero.
pub fn entry_name(matrix: MatrixName, row: usize, column: usize) -> String {
    format!("{matrix}{}", indices(row, column))
}

/// `_12` of the first row and the second column.
pub fn indices(row: usize, column: usize) -> String {
    let comma = if row.max(column) > 8 { "," } else { "" };
    format!("_{}{comma}{}", row + 1, column + 1)
}
