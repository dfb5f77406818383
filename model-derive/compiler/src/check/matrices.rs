//! Matrices: complete, of the right shape, each once.

use std::collections::HashSet;

use super::names::Scope;
use super::resolve;
use crate::formula::Formula;
use crate::matrix_name::{MatrixName, Whole};
use crate::model::Matrices;
use crate::report::{Region, Report};
use crate::syntax::Declaration;

/// What is written of the matrices.
#[derive(Debug)]
pub struct WrittenMatrices {
    /// In the order of the equation of motion.
    pub matrices: Matrices,
    /// Where their entries stand, row by row.
    pub regions: Vec<Region>,
    /// Those with the speed in them.
    pub wholes: Wholes,
}

/// Matrices with the speed in them, each as rows of formulas.
pub type Wholes = Vec<(Whole, Vec<Vec<Formula>>)>;

/// Reports what is added to matrices where there is no mechanism that has them, twice, or in another shape.
pub fn check_added(declaration: &Declaration, scope: &mut Scope, report: &mut Report) {
    let size = find_size(declaration);
    for (index, matrix) in declaration.added.iter().enumerate() {
        let name = matrix.name.name();
        if declaration.mechanism.is_none() {
            let message = format!(
                "`add {name}` without a mechanism, whose matrix it could be added to: expected `{name} = …`, which declares \
                 it, or a `mechanism {{ … }}`"
            );
            report.error(matrix.span, message);
            // They are meant, so it is no second mistake that nothing depends on them.
            matrix.entries().for_each(|entry| {
                entry.names(&mut |name| {
                    scope.excused.insert(name.to_string());
                });
            });
        } else if declaration.added[..index].iter().any(|known| known.name == matrix.name) {
            report.error(matrix.span, format!("`add {name}` twice: expected the sum of both in one"));
        } else if let Some(n) = size {
            check_shape(name, &matrix.rows, matrix.region, n, report);
        }
    }
}

/// The number of coordinates; without them, or with one declared twice, it is not known what shape is right.
fn find_size(declaration: &Declaration) -> Option<usize> {
    let n = declaration.coordinates.len();
    let distinct: HashSet<String> =
        declaration.coordinates.iter().map(|coordinate| coordinate.name.to_string()).collect();
    (n > 0 && n == distinct.len()).then_some(n)
}

/// Whether all matrices are square and of one size, which is not the number `n` of coordinates; reports that once, as one
/// mistake in the coordinates, unless one of them may be missing because it could not be read.
fn miss_coordinates(declaration: &Declaration, n: usize, is_complete: bool, report: &mut Report) -> bool {
    let wholes = declaration.wholes.iter().map(|(_, matrix)| &matrix.rows);
    let matrices: Vec<_> = declaration.matrices.iter().map(|matrix| &matrix.rows).chain(wholes).collect();
    let [first, _, ..] = matrices[..] else { return false };
    let size = first.len();
    let agree = matrices.iter().all(|rows| rows.len() == size && rows.iter().all(|(_, row)| row.len() == size));
    let Some(last) = declaration.coordinates.last().filter(|_| agree && size > 0 && size != n) else { return false };
    if is_complete {
        let found = count(n, "coordinate");
        let message = format!(
            "{found}, the last of which is `{}`: expected {size}, since all matrices are {size} x {size}",
            last.name
        );
        report.error(&last.name, message);
    }
    true
}

/// What is written of the matrices.
///
/// Unless all statements of the declaration could be read, those that are missing are probably among them.
pub fn resolve_matrices(
    declaration: &Declaration,
    is_complete: bool,
    scope: &mut Scope,
    report: &mut Report,
) -> WrittenMatrices {
    if declaration.coordinates.is_empty() && is_complete {
        report.error(&declaration.name, "no coordinates: expected `coordinates { … }` with at least one");
    }
    let size = find_size(declaration).filter(|n| !miss_coordinates(declaration, *n, is_complete, report));
    if let Some(n) = size {
        for asserted in &declaration.asserted {
            check_shape(asserted.name.name(), &asserted.rows, asserted.region, n, report);
        }
        for published in declaration.sets.iter().flat_map(|set| &set.published) {
            check_shape(published.name.name(), &published.rows, published.region, n, report);
        }
    }
    let mut matrices: Vec<(MatrixName, Vec<Vec<Formula>>, Vec<Region>)> = Vec::new();
    for matrix in &declaration.matrices {
        let name = matrix.name.name();
        if matrices.iter().any(|(known, ..)| *known == matrix.name) {
            report.error(matrix.span, format!("`{name}` is declared twice: expected one of each matrix"));
            continue;
        }
        if let Some(n) = size {
            check_shape(name, &matrix.rows, matrix.region, n, report);
        }
        let mut resolve = |row: &Vec<_>| row.iter().map(|entry| resolve::resolve(entry, scope, report)).collect();
        let rows = matrix.rows.iter().map(|(_, row)| resolve(row)).collect();
        let regions = matrix.entries().map(|entry| entry.region).collect();
        matrices.push((matrix.name, rows, regions));
    }
    let wholes = resolve_wholes(declaration, size, scope, report);
    if !matrices.iter().any(|(name, ..)| *name == MatrixName::M) && is_complete && declaration.mechanism.is_none() {
        let message = "no mass matrix: expected `M = [[…], …];`, or a `mechanism { … }` that it is derived from";
        report.error(Region::from(&declaration.name), message);
    }
    matrices.sort_by_key(|(name, ..)| *name);
    let regions = matrices.iter().flat_map(|(_, _, regions)| regions).copied().collect();
    let matrices = matrices.into_iter().map(|(name, rows, _)| (name, rows)).collect();
    WrittenMatrices { matrices, regions, wholes }
}

/// The matrices with the speed in them.
fn resolve_wholes(declaration: &Declaration, size: Option<usize>, scope: &mut Scope, report: &mut Report) -> Wholes {
    let mut wholes: Wholes = Vec::new();
    for (whole, matrix) in &declaration.wholes {
        let name = whole.name();
        if wholes.iter().any(|(known, _)| known == whole) {
            report.error(matrix.span, format!("`{name}` is declared twice: expected one of each matrix"));
            continue;
        }
        if let Some(part) = declaration.matrices.iter().find(|matrix| whole.parts().contains(&matrix.name)) {
            let part = part.name.name();
            let message =
                format!("`{name}` beside `{part}`, which is a part of it: expected `{name}`, or its parts alone");
            report.error(matrix.span, message);
        }
        if let Some(n) = size {
            check_shape(name, &matrix.rows, matrix.region, n, report);
        }
        let mut resolve =
            |row: &Vec<_>| row.iter().map(|entry| resolve::resolve_in_speed(entry, scope, report)).collect();
        wholes.push((*whole, matrix.rows.iter().map(|(_, row)| resolve(row)).collect()));
    }
    wholes
}

/// Whether rows are n x n; reports those that are not.
fn check_shape<T>(name: &str, rows: &[(Region, Vec<T>)], region: Region, n: usize, report: &mut Report) -> bool {
    let shape = format!("expected {n} x {n}, a row and a column for each coordinate");
    let size = rows.len();
    if size > 1 && size != n && rows.iter().all(|(_, row)| row.len() == size) {
        report.error(region, format!("`{name}` is {size} x {size}: {shape}"));
        return false;
    }
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
