//! What follows from the motion to terms of the equation of motion, by powers of the speed.

use proc_macro2::Ident;

use super::Derived;
use super::by_speed::{describe_power, describe_powers, speed_name};
use crate::check::{Checked, Law, Term};
use crate::equations::Equations;
use crate::formula::{self, Formula};
use crate::matrix_name::{MatrixName, Whole};
use crate::report::{Region, Report};
use crate::symbolic::{self, Failure, Place, PowerTerm, Sorted};

/// What feedback adds to an entry of a matrix.
#[derive(Debug)]
pub struct Fed<'a> {
    /// What it acts on.
    pub on: &'a Ident,
    /// The coordinate or joint that it multiplies.
    pub of: &'a Ident,
    pub matrix: MatrixName,
    /// On the side of the equation where the matrices are.
    pub formula: Formula,
    pub region: Region,
}

/// Sorts what is fed back exactly by powers of the speed, and what multiplies positions by gravity; reports what the equation
/// of motion does not have.
pub fn sort_feedback<'a>(checked: &'a Checked<'_>, report: &mut Report) -> Vec<Fed<'a>> {
    let terms = || checked.feedback.iter().flat_map(|law| law.terms.iter().map(move |term| (law, term)));
    let mut fed = Vec::new();
    for whole in [Whole::Damping, Whole::Stiffness] {
        let own: Vec<(&Law, &Term)> = terms().filter(|(_, term)| term.is_rate == (whole == Whole::Damping)).collect();
        if own.is_empty() {
            continue;
        }
        // A force stands on the other side of the equation.
        let outputs = own.iter().map(|(_, term)| Formula::Sum(vec![formula::Term::minus(term.factor.clone())]));
        let definitions: Vec<Formula> = checked.definitions.iter().chain(&checked.unsteady).cloned().collect();
        let equations = Equations {
            parameters: checked.domains.len() + 1,
            origins: (0..definitions.len()).collect(),
            definitions,
            outputs: outputs.collect(),
        };
        let gravity = checked.gravity.filter(|_| whole == Whole::Stiffness);
        let sorted = match symbolic::sort_by_powers(equations, checked.definitions.len(), gravity) {
            Ok(sorted) => sorted,
            Err(failure) => {
                report.error(find_region(checked, &own, &failure), failure);
                continue;
            }
        };
        for ((law, term), sorted) in own.into_iter().zip(&sorted) {
            match place(whole, sorted) {
                Ok(parts) => fed.extend(parts.into_iter().map(|(matrix, formula)| Fed {
                    on: &law.on,
                    of: &term.of,
                    matrix,
                    formula: formula.clone(),
                    region: term.region,
                })),
                Err(why) => {
                    let speed = speed_name(checked.declaration);
                    let what = if term.is_rate { format!("rate({})", term.of) } else { term.of.to_string() };
                    let message = match why {
                        Misplaced::Power(exponent) => format!(
                            "what multiplies `{what}` here has a term with {}: expected {}",
                            describe_power(exponent, &speed),
                            describe_powers(whole, &speed)
                        ),
                        Misplaced::TooLong => format!(
                            "what multiplies `{what}` here grows too long where definitions that depend on `{speed}` are put \
                             into it: expected shorter ones"
                        ),
                        Misplaced::OtherThanPowers => format!(
                            "what multiplies `{what}` here depends on `{speed}` otherwise than by powers: expected {}",
                            describe_powers(whole, &speed)
                        ),
                    };
                    report.error(term.region, message);
                }
            }
        }
    }
    fed
}

/// Why no matrix has a term.
enum Misplaced {
    Power((i64, i64)),
    OtherThanPowers,
    TooLong,
}

/// The matrices that the terms of a factor belong to.
fn place(whole: Whole, sorted: &Sorted) -> Result<Vec<(MatrixName, &Formula)>, Misplaced> {
    let terms = match sorted {
        Sorted::Terms(terms) => terms,
        Sorted::OtherThanPowers => return Err(Misplaced::OtherThanPowers),
        Sorted::TooLong => return Err(Misplaced::TooLong),
    };
    let place = |term: &PowerTerm| {
        let part = (term.exponent.1 == 1).then(|| whole.part(term.exponent.0)).flatten();
        let part = part.ok_or(Misplaced::Power(term.exponent))?;
        Ok(if term.has_factor { MatrixName::K0 } else { part })
    };
    terms.iter().map(|term| Ok((place(term)?, &term.coefficient))).collect()
}

/// Where in the declaration a failure of the engine belongs.
fn find_region(checked: &Checked<'_>, terms: &[(&Law, &Term)], failure: &Failure) -> Region {
    let name = Region::from(&checked.declaration.name);
    match failure {
        Failure::Undefined { place: Place::Definition(index), .. } => checked.definition(*index).into(),
        Failure::Undefined { place: Place::Output(index), .. } => {
            terms.get(*index).map_or(name, |(_, term)| term.region)
        }
        Failure::Engine(_) => name,
    }
}

/// Adds what is fed back to matrices that are written.
pub fn add_feedback(checked: &Checked<'_>, fed: Vec<Fed<'_>>, mut derived: Derived) -> Derived {
    let coordinates = &checked.declaration.coordinates;
    let n = coordinates.len();
    let mut regions: Vec<Vec<Region>> = derived.entries.chunks(n * n).map(<[Region]>::to_vec).collect();
    for Fed { on, of, matrix, formula, region } in fed {
        let [row, column] = [on, of].map(|name| coordinates.iter().position(|known| known.name == *name));
        let (Some(row), Some(column)) = (row, column) else { continue };
        let position = derived.matrices.iter().position(|(name, _)| *name >= matrix);
        let position = match position.unwrap_or(derived.matrices.len()) {
            known if derived.matrices.get(known).is_some_and(|(name, _)| *name == matrix) => known,
            new => {
                derived.matrices.insert(new, (matrix, vec![vec![Formula::zero(); n]; n]));
                regions.insert(new, vec![region; n * n]);
                new
            }
        };
        let entry = &mut derived.matrices[position].1[row][column];
        if entry.is_zero() {
            *entry = formula;
            regions[position][row * n + column] = region;
        } else {
            *entry = Formula::Sum(vec![formula::Term::plus(entry.clone()), formula::Term::plus(formula)]);
        }
        derived.fed.push((matrix, row, column));
    }
    derived.entries = regions.concat();
    derived
}
