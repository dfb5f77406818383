//! Matrices of formulas, most entries of which are zero.

use crate::symbolic::Form;

/// By rows.
pub type Matrix = Vec<Vec<Form>>;

pub fn new(rows: usize, columns: usize, mut entry: impl FnMut(usize, usize) -> Form) -> Matrix {
    (0..rows).map(|row| (0..columns).map(|column| entry(row, column)).collect()).collect()
}

/// A symmetric matrix, of which only entries on and above the diagonal are asked for.
pub fn symmetric(size: usize, mut entry: impl FnMut(usize, usize) -> Form) -> Matrix {
    let above = new(size, size, |row, column| if row <= column { entry(row, column) } else { Form::number(0) });
    new(size, size, |row, column| above[row.min(column)][row.max(column)].clone())
}

pub fn transposed(matrix: &Matrix) -> Matrix {
    let columns = matrix.first().map_or(0, Vec::len);
    new(columns, matrix.len(), |row, column| matrix[column][row].clone())
}

pub fn times(left: &Matrix, right: &Matrix) -> Matrix {
    left.iter().map(|row| times_row(row, right)).collect()
}

pub fn times_row(row: &[Form], right: &Matrix) -> Vec<Form> {
    let columns = right.first().map_or(0, Vec::len);
    let entry = |column: usize| {
        let terms = row.iter().zip(right).map(|(factor, other)| (factor, &other[column]));
        let terms = terms.filter(|(factor, other)| !factor.is_nothing() && !other.is_nothing());
        terms.fold(Form::number(0), |sum, (factor, other)| &sum + &(factor * other))
    };
    (0..columns).map(entry).collect()
}

pub fn plus(left: &Matrix, right: &Matrix) -> Matrix {
    let sum = |(a, b): (&Vec<Form>, &Vec<Form>)| a.iter().zip(b).map(|(a, b)| a + b).collect();
    left.iter().zip(right).map(sum).collect()
}

/// By the entries of the first row; for small matrices.
pub fn determinant(matrix: &Matrix) -> Form {
    let Some((first, rest)) = matrix.split_first() else { return Form::number(1) };
    let without =
        |column: usize| -> Matrix { rest.iter().map(|row| [&row[..column], &row[column + 1..]].concat()).collect() };
    let terms = first.iter().enumerate().filter(|(_, entry)| !entry.is_nothing()).map(|(column, entry)| {
        let term = entry * &determinant(&without(column));
        if column % 2 == 0 { term } else { -&term }
    });
    terms.fold(Form::number(0), |sum, term| &sum + &term)
}
