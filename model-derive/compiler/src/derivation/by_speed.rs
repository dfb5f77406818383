//! Matrices with the speed in them to the coefficient matrices, by its powers.

use super::Derived;
use crate::check::Checked;
use crate::equations::Equations;
use crate::formula::Formula;
use crate::matrix_name::{MatrixName, Whole};
use crate::model::Matrices;
use crate::report::{Region, Report};
use crate::symbolic::{self, Failure, Place, PowerTerm, Sorted};
use crate::syntax::{Declaration, Matrix};

/// Sorts the matrices with the speed in them, exactly, and puts their parts among the others.
pub fn sort_wholes(checked: &Checked<'_>, derived: Derived, report: &mut Report) -> Derived {
    if checked.written.wholes.is_empty() || !report.is_empty() {
        return derived;
    }
    let definitions: Vec<Formula> = checked.definitions.iter().chain(&checked.unsteady).cloned().collect();
    let mut matrices = derived.matrices;
    let mut symmetric = derived.symmetric;
    let speed = speed_name(checked.declaration);
    for ((whole, rows), (_, written)) in checked.written.wholes.iter().zip(&checked.declaration.wholes) {
        let equations = Equations {
            parameters: checked.domains.len() + 1,
            origins: (0..definitions.len()).collect(),
            definitions: definitions.clone(),
            outputs: rows.iter().flatten().cloned().collect(),
        };
        let gravity = checked.gravity.filter(|_| *whole == Whole::Stiffness);
        let entries = match symbolic::sort_by_powers(equations, checked.definitions.len(), gravity) {
            Ok(entries) => entries,
            Err(failure) => {
                report.error(find_region(checked, written, &failure), failure);
                continue;
            }
        };
        let parts = find_parts(*whole, written, &entries, &speed, report);
        symmetric.extend(parts.iter().map(|(name, _)| *name).filter(|_| written.symmetric));
        matrices.extend(parts);
    }
    matrices.sort_by_key(|(name, _)| *name);
    symmetric.sort_unstable();
    let declared = matrices.iter().filter_map(|(name, _)| checked.declaration.find_declared(*name));
    let entries = declared.flat_map(Matrix::entries).map(|entry| entry.region).collect();
    Derived { matrices, symmetric, entries, ..derived }
}

/// What the speed is called.
pub fn speed_name(declaration: &Declaration) -> String {
    declaration.speed.as_ref().map_or_else(|| "v".into(), |speed| speed.name.to_string())
}

/// Where in the declaration a failure of the engine belongs.
fn find_region(checked: &Checked<'_>, whole: &Matrix, failure: &Failure) -> Region {
    let name = Region::from(&checked.declaration.name);
    match failure {
        Failure::Undefined { place: Place::Definition(index), .. } => checked.definition(*index).into(),
        Failure::Undefined { place: Place::Output(index), .. } => {
            whole.entries().nth(*index).map_or(name, |entry| entry.region)
        }
        Failure::Engine(_) => name,
    }
}

/// The coefficient matrices that are not zero; reports what is in none of them.
fn find_parts(whole: Whole, written: &Matrix, entries: &[Sorted], speed: &str, report: &mut Report) -> Matrices {
    let n = written.rows.len();
    let mut parts: Matrices = Vec::new();
    let mut put = |name: MatrixName, index: usize, formula: &Formula| {
        if formula.is_zero() {
            return;
        }
        let known = parts.iter().position(|(known, _)| *known == name);
        let position = known.unwrap_or_else(|| {
            parts.push((name, vec![vec![Formula::zero(); n]; n]));
            parts.len() - 1
        });
        parts[position].1[index / n][index % n] = formula.clone();
    };
    for (index, (entry, written)) in entries.iter().zip(written.entries()).enumerate() {
        let terms = match entry {
            Sorted::Terms(terms) => terms,
            other => {
                report.error(written.region, describe_not_sorted(other, whole, speed));
                continue;
            }
        };
        for PowerTerm { exponent, has_factor, coefficient } in terms {
            match (exponent.1 == 1).then(|| whole.part(exponent.0)).flatten() {
                Some(_) if *has_factor => put(MatrixName::K0, index, coefficient),
                Some(part) => put(part, index, coefficient),
                None => {
                    let message = format!(
                        "this entry of `{}` has a term with {}: expected {}",
                        whole.name(),
                        describe_power(*exponent, speed),
                        describe_powers(whole, speed)
                    );
                    report.error(written.region, message);
                }
            }
        }
    }
    parts
}

fn describe_not_sorted(sorted: &Sorted, whole: Whole, speed: &str) -> String {
    let name = whole.name();
    match sorted {
        Sorted::TooLong => format!(
            "this entry of `{name}` grows too long where definitions that depend on `{speed}` are put into it: expected \
             shorter ones"
        ),
        _ => {
            let expected = describe_powers(whole, speed);
            format!("this entry of `{name}` depends on `{speed}` otherwise than by powers: expected {expected}")
        }
    }
}

/// The terms that a matrix may have.
pub fn describe_powers(whole: Whole, speed: &str) -> String {
    match whole {
        Whole::Damping => format!("formulas without `{speed}`, times `1/{speed}`, 1 or `{speed}`"),
        Whole::Stiffness => format!("formulas without `{speed}`, times 1, `{speed}` or `{speed}^2`"),
    }
}

/// A power as it would be written: `1/v^2`, `sqrt(v)`.
pub fn describe_power((above, below): (i64, i64), speed: &str) -> String {
    let power = match (above.abs(), below) {
        (1, 1) => speed.to_string(),
        (1, 2) => format!("sqrt({speed})"),
        (n, 1) => format!("{speed}^{n}"),
        (n, 2) => format!("sqrt({speed})^{n}"),
        (n, m) => format!("{speed}^({n}/{m})"),
    };
    if above < 0 { format!("`1/{power}`") } else { format!("`{power}`") }
}
