//! Units and mirrors: a dimensional analysis of every formula.
//!
//! Beside its unit a quantity may have a direction in the axes of the model, x forward and z along gravity. Equations
//! of motion hold in mirrored axes as well, with the parameters mirrored, so the terms of a sum change their signs alike.
//! (Siano's orientational analysis, 1985, is the same bookkeeping.)

mod analysis;
pub mod declared;
pub mod dimension;
mod feedback;
mod formulas;
pub mod known;
mod mechanism;

pub use self::analysis::LOAD;
pub use self::formulas::Units;
pub use self::mechanism::check_mechanism;

use self::analysis::{Analysis, short};
use self::declared::{Dimensions, Quantity};
use self::dimension::Dimension;
use self::feedback::check_feedback;
use super::domains::ExactDomain;
use super::names::Scope;
use crate::matrix_name::MatrixName;
use crate::report::Report;
use crate::syntax::{Coordinate, Declaration, Direction, Matrix, Requirement};

/// The dimensions of formulas, as far as they are known.
pub struct Found {
    /// Of the definitions, in their order.
    pub definitions: Vec<Option<Dimension>>,
    /// Of the requirements, as they are declared.
    pub requirements: Vec<Option<Dimension>>,
}

/// Reports formulas whose units or mirrors do not fit, and returns what was found of them; `order` has the positions of
/// the definitions in the declaration, each behind those that it uses, and `required` the values that requirements allow.
pub fn check(
    declaration: &Declaration,
    required: &[ExactDomain],
    dimensions: &Dimensions,
    scope: &Scope,
    order: &[usize],
    report: &mut Report,
) -> Found {
    check_gravity(declaration, dimensions, report);
    let definitions = vec![None; declaration.definitions.len()];
    let mut analysis = Analysis { declaration, scope, dimensions, definitions, motions: Vec::new() };
    for (position, declared) in order.iter().enumerate() {
        analysis.definitions[position] = analysis.dimension(&declaration.definitions[*declared].value, report);
    }
    let requirements = declaration.requirements.iter().zip(required);
    let requirements =
        requirements.map(|(written, domain)| check_requirement(&analysis, written, domain, report)).collect();
    for assertion in &declaration.assertions {
        analysis.check_equal(assertion, report);
    }
    // Beside a mechanism declared matrices are a mistake, and asserted ones are held against what mirrors right.
    let declared = declaration.matrices.iter().filter(|_| declaration.mechanism.is_none());
    let mirrored = dimensions.mirrored && declaration.mechanism.is_none();
    let wholes = declaration.wholes.iter().filter(|_| declaration.mechanism.is_none());
    let wholes = wholes.map(|(whole, matrix)| (whole.name(), matrix));
    let matrices = declaration.asserted.iter().chain(declared).map(|matrix| (matrix.name.name(), matrix));
    let mut factors = RowFactors::new(declaration);
    for (name, matrix) in matrices.chain(wholes) {
        check_matrix(&analysis, name, matrix, &dimensions.coordinates, mirrored, &mut factors, report);
    }
    if declaration.mechanism.is_none() {
        let coordinates = declaration.coordinates.iter().map(|coordinate| coordinate.name.to_string());
        analysis.motions = coordinates.zip(dimensions.coordinates.iter().copied()).collect();
        check_feedback(&analysis, &mut factors, report);
    }
    Found { definitions: analysis.definitions, requirements }
}

fn check_gravity(declaration: &Declaration, dimensions: &Dimensions, report: &mut Report) {
    for (parameter, dimension) in declaration.parameters.iter().zip(&dimensions.parameters) {
        let unit = parameter.unit.as_ref().filter(|_| parameter.gravity.is_some());
        let Some((dimension, unit)) = dimension.zip(unit) else { continue };
        if !dimension.same_unit(Dimension::new([0, 1, -2])) {
            let message = format!("`{}`, the gravity, is {}: expected `N/kg`", parameter.name, dimension.place());
            report.error(unit.region, message);
        }
    }
}

fn check_requirement(
    analysis: &Analysis<'_>,
    Requirement { value, bound }: &Requirement,
    domain: &ExactDomain,
    report: &mut Report,
) -> Option<Dimension> {
    let dimension = analysis.dimension(value, report)?;
    let fits = match bound.value.unit.as_ref().map(Quantity::new) {
        None => domain.is_everything() || domain.ends_at_zero() || dimension.is_number(),
        Some(Ok(unit)) => unit.dimension.same_unit(dimension),
        Some(Err(_)) => true,
    };
    if !fits {
        let text = short(value);
        let message =
            format!("`{text}` is {}: expected a bound in its unit, such as `1 {dimension}`", dimension.place());
        report.error(bound.value.region(), message);
    }
    Some(dimension)
}

/// What the rows are multiplied by: those of coordinates of first order may be by anything, which their first entry shows.
struct RowFactors(Vec<Option<Dimension>>);

impl RowFactors {
    fn new(declaration: &Declaration) -> Self {
        let known = |is_first_order: bool| (!is_first_order).then_some(Dimension::NUMBER);
        Self(declaration.of_first_order().into_iter().map(known).collect())
    }

    /// The factor of a row, of which an entry was found where another dimension was expected.
    fn find(&mut self, row: usize, found: Dimension, expected: Dimension) -> Option<Dimension> {
        let factor = self.0.get_mut(row)?;
        if factor.is_none() {
            *factor = expected.power(-1).and_then(|inverse| found.times(inverse));
        }
        *factor
    }
}

/// An entry has the unit and, if that is `mirrored`, the mirrors that make the work of its force on the coordinate of its
/// row an energy; `dimensions` are those of the coordinates.
fn check_matrix(
    analysis: &Analysis<'_>,
    name: &str,
    matrix: &Matrix,
    dimensions: &[Option<Dimension>],
    mirrored: bool,
    factors: &mut RowFactors,
    report: &mut Report,
) {
    let coordinates = &analysis.declaration.coordinates;
    let of_first_order = analysis.declaration.of_first_order();
    // Which coordinates the rows and columns of another shape belong to is not known.
    let n = coordinates.len();
    let fits = matrix.rows.len() == n && matrix.rows.iter().all(|(_, row)| row.len() == n);
    let at = |index: usize| dimensions.get(index).copied().flatten().filter(|_| fits);
    for (row, (_, entries)) in matrix.rows.iter().enumerate() {
        for (column, entry) in entries.iter().enumerate() {
            let Some(found) = analysis.dimension(entry, report) else { continue };
            let Some(expected) =
                at(row).zip(at(column)).and_then(|(row, column)| entry_dimension(matrix.name, row, column))
            else {
                continue;
            };
            let factor = factors.find(row, found, expected);
            let Some(expected) = factor.and_then(|factor| expected.times(factor)) else { continue };
            let is_first_order = of_first_order[row];
            let (row, column) = (&coordinates[row], &coordinates[column]);
            if !found.same_unit(expected) {
                let message = format!(
                    "this entry of `{name}` is {}: expected {expected}, as its row is `{}` in {} and its column `{}` in {}{}",
                    found.place(),
                    row.name,
                    unit_text(row),
                    column.name,
                    unit_text(column),
                    if is_first_order { ", and by the entries of this row before it" } else { "" },
                );
                report.error(entry.region, message);
            } else if mirrored && found != expected {
                let message = format!(
                    "this entry of `{name}` {}: expected one that {}, as its row is `{}` and its column `{}`",
                    found.sign(),
                    expected.sign(),
                    row.name,
                    column.name,
                );
                report.error(entry.region, message);
            }
        }
    }
}

fn unit_text(coordinate: &Coordinate) -> &str {
    coordinate.unit.as_ref().map_or("", |unit| &unit.text)
}

const ENERGY: Dimension = Dimension::new([1, 2, -2]);

/// What an entry is in: the energy, by the coordinates, with the factor of the matrix taken out of it.
fn entry_dimension(matrix: MatrixName, row: Dimension, column: Dimension) -> Option<Dimension> {
    let [x, z] = [[true, false, false], [false, false, true]].map(|odd| Some(Direction::Along(odd)));
    let speed = Dimension::new([0, 1, -1]).directed(x);
    let gravity = Dimension::new([0, 1, -2]).directed(z);
    let per_second = |times: i32| Dimension::new([0, 0, -times]);
    let factor = match matrix {
        MatrixName::M => per_second(2),
        MatrixName::Cm1 => per_second(1).times(speed.power(-1)?)?,
        MatrixName::C0 => per_second(1),
        MatrixName::C1 => per_second(1).times(speed)?,
        MatrixName::Kc => Dimension::NUMBER,
        MatrixName::K0 => gravity,
        MatrixName::K1 => speed,
        MatrixName::K2 => speed.power(2)?,
    };
    let divisor = row.times(column)?.times(factor)?;
    ENERGY.times(divisor.power(-1)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_in_the_units_of_the_bicycle() {
        let rad = Dimension::NUMBER;
        let cases = [
            (MatrixName::M, "kg*m^2"),
            (MatrixName::Cm1, "kg*m^3/s^2"),
            (MatrixName::C0, "kg*m^2/s"),
            (MatrixName::C1, "kg*m"),
            (MatrixName::Kc, "kg*m^2/s^2"),
            (MatrixName::K0, "kg*m"),
            (MatrixName::K1, "kg*m/s"),
            (MatrixName::K2, "kg"),
        ];
        for (matrix, unit) in cases {
            assert_eq!(entry_dimension(matrix, rad, rad).map(|d| d.to_string()).as_deref(), Some(unit), "{matrix:?}");
        }
        let length = Dimension::new([0, 1, 0]);
        assert_eq!(entry_dimension(MatrixName::M, length, length).map(|d| d.to_string()).as_deref(), Some("kg"));
        assert_eq!(entry_dimension(MatrixName::M, length, rad).map(|d| d.to_string()).as_deref(), Some("kg*m"));
    }
}
