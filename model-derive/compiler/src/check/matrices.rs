//! The shapes of the matrices.

use super::names::Scope;
use super::resolve;
use crate::model::Expr;
use crate::report::{Region, Report};
use crate::syntax::{Declaration, Matrix, MatrixName};

/// The declared matrices, in the order of the equation of motion.
pub fn matrices(
    declaration: &Declaration,
    scope: &mut Scope,
    report: &mut Report,
) -> Vec<(MatrixName, Vec<Vec<Expr>>)> {
    let n = declaration.coordinates.len();
    if n == 0 && report.is_empty() {
        report.error(&declaration.name, "no coordinates: expected `coordinates { … }` with at least one");
    }
    let mut matrices: Vec<(MatrixName, Vec<Vec<Expr>>)> = Vec::new();
    for matrix in &declaration.matrices {
        let name = matrix.name.name();
        if matrices.iter().any(|(known, _)| *known == matrix.name) {
            report.error(matrix.span, format!("`{name}` is declared twice: expected one of each matrix"));
            continue;
        }
        // Without coordinates no shape is right, and the one mistake is that there are none.
        if n > 0 {
            check_shape(matrix, n, report);
        }
        let mut resolve = |row: &Vec<_>| row.iter().map(|entry| resolve::expression(entry, scope, report)).collect();
        matrices.push((matrix.name, matrix.rows.iter().map(|(_, row)| resolve(row)).collect()));
    }
    if !matrices.iter().any(|(name, _)| *name == MatrixName::M) && report.is_empty() {
        report.error(Region::from(&declaration.name), "no mass matrix: expected `M = [[…], …];`");
    }
    matrices.sort_by_key(|(name, _)| *name);
    matrices
}

fn check_shape(matrix: &Matrix, n: usize, report: &mut Report) {
    let name = matrix.name.name();
    let shape = format!("expected {n} x {n}, a row and a column for each coordinate");
    if matrix.rows.len() != n {
        let found = count(matrix.rows.len(), "row");
        report.error(matrix.region, format!("`{name}` has {found}: {shape}"));
    }
    for (region, row) in &matrix.rows {
        if row.len() != n {
            let found = count(row.len(), "entry");
            report.error(*region, format!("a row of `{name}` has {found}: {shape}"));
        }
    }
}

fn count(number: usize, what: &str) -> String {
    match (number, what) {
        (1, _) => format!("1 {what}"),
        (_, "entry") => format!("{number} entries"),
        _ => format!("{number} {what}s"),
    }
}
