//! Assertions about whole matrices to assertions about their entries.

use super::matrices::check_shape;
use crate::formula::Decimal;
use crate::report::Report;
use crate::syntax::{Assertion, Declaration, Expression, Kind, Matrix};

/// Puts what is asserted of each entry of a matrix among the assertions; a matrix that the model does not have is zero.
pub fn expand(declaration: &mut Declaration, report: &mut Report) {
    let n = declaration.coordinates.len();
    let mut assertions = Vec::new();
    for matrix in &declaration.asserted {
        let is_square = n == 0 || check_shape(matrix.name.name(), &matrix.rows, matrix.region, n, report);
        for (row, (_, entries)) in matrix.rows.iter().enumerate() {
            for (column, written) in entries.iter().enumerate() {
                // Beside other mistakes there may be no matrices: then what is written is looked at alone.
                let entry = if declaration.matrices.is_empty() || !is_square {
                    written.clone()
                } else {
                    entry(&declaration.matrices, matrix, row, column, written)
                };
                let name = format!("{}, row {}, column {}", matrix.name.name(), row + 1, column + 1);
                assertions.push(Assertion { left: entry, right: written.clone(), entry: Some(name) });
            }
        }
    }
    declaration.assertions.append(&mut assertions);
}

/// The formula of an entry as if it stood where another one is written.
fn entry(matrices: &[Matrix], asserted: &Matrix, row: usize, column: usize, written: &Expression) -> Expression {
    let declared = matrices.iter().find(|matrix| matrix.name == asserted.name);
    let entry = declared.and_then(|matrix| matrix.rows.get(row)?.1.get(column));
    let zero = || Kind::Number(Decimal { digits: "0".into(), exponent: 0 });
    Expression { kind: entry.map_or_else(zero, |entry| entry.kind.clone()), region: written.region }
}
