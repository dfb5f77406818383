//! Matrices: complete, of the right shape, each once.

use std::collections::HashSet;

use super::names::Scope;
use super::resolve;
use crate::formula::Formula;
use crate::matrix_name::MatrixName;
use crate::model::Matrices;
use crate::report::{Region, Report};
use crate::syntax::Declaration;

/// The declared matrices, in the order of the equation of motion, and where their entries stand, row by row.
///
/// Unless all statements of the declaration could be read, those that are missing are probably among them.
pub fn resolve_matrices(
    declaration: &Declaration,
    is_complete: bool,
    scope: &mut Scope,
    report: &mut Report,
) -> (Matrices, Vec<Region>) {
    let n = declaration.coordinates.len();
    let distinct: HashSet<String> =
        declaration.coordinates.iter().map(|coordinate| coordinate.name.to_string()).collect();
    if n == 0 && is_complete {
        report.error(&declaration.name, "no coordinates: expected `coordinates { … }` with at least one");
    }
    // Without coordinates, or with one declared twice, it is not known what shape is right.
    let is_known = n > 0 && n == distinct.len();
    for asserted in declaration.asserted.iter().filter(|_| is_known) {
        check_shape(asserted.name.name(), &asserted.rows, asserted.region, n, report);
    }
    for published in declaration.sets.iter().flat_map(|set| &set.published).filter(|_| is_known) {
        check_shape(published.name.name(), &published.rows, published.region, n, report);
    }
    let mut matrices: Vec<(MatrixName, Vec<Vec<Formula>>, Vec<Region>)> = Vec::new();
    for matrix in &declaration.matrices {
        let name = matrix.name.name();
        if matrices.iter().any(|(known, ..)| *known == matrix.name) {
            report.error(matrix.span, format!("`{name}` is declared twice: expected one of each matrix"));
            continue;
        }
        if is_known {
            check_shape(name, &matrix.rows, matrix.region, n, report);
        }
        let mut resolve = |row: &Vec<_>| row.iter().map(|entry| resolve::resolve(entry, scope, report)).collect();
        let rows = matrix.rows.iter().map(|(_, row)| resolve(row)).collect();
        let regions = matrix.rows.iter().flat_map(|(_, row)| row.iter().map(|entry| entry.region)).collect();
        matrices.push((matrix.name, rows, regions));
    }
    if !matrices.iter().any(|(name, ..)| *name == MatrixName::M) && is_complete && declaration.mechanism.is_none() {
        let message = "no mass matrix: expected `M = [[…], …];`, or a `mechanism { … }` that it is derived from";
        report.error(Region::from(&declaration.name), message);
    }
    matrices.sort_by_key(|(name, ..)| *name);
    let regions = matrices.iter().flat_map(|(_, _, regions)| regions).copied().collect();
    (matrices.into_iter().map(|(name, rows, _)| (name, rows)).collect(), regions)
}

/// Whether rows are n x n; reports those that are not.
fn check_shape<T>(name: &str, rows: &[(Region, Vec<T>)], region: Region, n: usize, report: &mut Report) -> bool {
    let shape = format!("expected {n} x {n}, a row and a column for each coordinate");
    if rows.len() != n {
        let found = count(rows.len(), "row");
        report.error(region, format!("`{name}` has {found}: {shape}"));
    }
    let wrong = || rows.iter().filter(|(_, row)| row.len() != n);
    for (region, row) in wrong() {
        let found = count(row.len(), "entry");
        report.error(*region, format!("a row of `{name}` has {found}: {shape}"));
    }
    rows.len() == n && wrong().next().is_none()
}

fn count(number: usize, what: &str) -> String {
    match (number, what) {
        (1, _) => format!("1 {what}"),
        (_, "entry") => format!("{number} entries"),
        _ => format!("{number} {what}s"),
    }
}
