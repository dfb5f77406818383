//! What a declaration claims of itself: symmetric matrices and equal formulas. Both are proved, or refused.

use std::collections::HashSet;

use proc_macro2::Ident;

use super::counterexample::{Counterexample, FEW, MANY, Space};
use crate::derivation::Derived;
use crate::equations::Equations;
use crate::formula::{Formula, Names};
use crate::matrix_name::MatrixName;
use crate::report::{Region, Report, number};
use crate::symbolic::{self, Depth, Place, Proof};

/// Two formulas that are claimed to be equal for all parameters.
#[derive(Debug)]
pub struct Claim {
    /// Each side with where it stands.
    sides: [(Formula, Region); 2],
    kind: Kind,
}

#[derive(Debug)]
enum Kind {
    /// Two entries of a matrix: the one above the diagonal at a row and a column, and its mirror image.
    Mirrored(MatrixName, usize, usize),
    /// The texts of the two sides of an assertion.
    Asserted([String; 2]),
}

impl Claim {
    /// The claim of an assertion.
    pub fn asserted(texts: [String; 2], sides: [(Formula, Region); 2]) -> Self {
        Self { sides, kind: Kind::Asserted(texts) }
    }

    /// Where an error about both sides belongs.
    fn region(&self) -> Region {
        let [(_, left), (_, right)] = self.sides;
        match self.kind {
            Kind::Mirrored(..) => right,
            Kind::Asserted(_) => left.to(right),
        }
    }
}

/// The claims of a symmetric matrix, whose entries stand at `regions`, row by row: a pair of entries each.
pub fn of_symmetry(name: MatrixName, rows: &[Vec<Formula>], regions: &[Region]) -> impl Iterator<Item = Claim> {
    let n = rows.len();
    let side = move |row: usize, column: usize| (rows[row][column].clone(), regions[row * n + column]);
    let pairs = (0..n).flat_map(move |row| (row + 1..n).map(move |column| (row, column)));
    pairs.map(move |(row, column)| Claim {
        sides: [side(row, column), side(column, row)],
        kind: Kind::Mirrored(name, row + 1, column + 1),
    })
}

/// Proves claims; those that are wrong or cannot be proved are reported.
pub fn check_claims(claims: &[Claim], derived: &Derived, space: &Space<'_>, report: &mut Report) {
    let Derived { definitions, names: Names { parameters, definitions: names }, .. } = derived;
    let Some(first) = claims.first() else { return };
    let pairs: Vec<Equations> = claims
        .iter()
        .map(|claim| {
            Equations::of_formulas(parameters.len(), definitions, claim.sides.iter().map(|(e, _)| e.clone()).collect())
        })
        .collect();
    let proofs = match symbolic::prove_equal(pairs.clone(), Depth::Names) {
        Ok(proofs) => proofs,
        Err(failure) => return report.error(first.region(), failure),
    };
    let mut undefined = HashSet::new();
    for ((claim, pair), proof) in claims.iter().zip(pairs).zip(proofs) {
        let mut refuse_undefined = |proof, report: &mut Report| match proof {
            Proof::Undefined(Place::Output(side), why) => report.error(claim.sides[side].1, why),
            Proof::Undefined(Place::Definition(index), why) if undefined.insert(index) => {
                report.error(&names[index], why);
            }
            _ => {}
        };
        if !matches!(proof, Proof::NotFound | Proof::TooLong) {
            refuse_undefined(proof, report);
            continue;
        }
        let [(left, _), (right, _)] = &claim.sides;
        let refute = |most, report: &mut Report| {
            let found = space.find_counterexample(most, definitions, &pair, left, right);
            found.map(|found| report.error(claim.region(), describe_refuted(claim, &found, parameters)))
        };
        if refute(FEW, report).is_ok() {
            continue;
        }
        let proof = symbolic::prove_equal(vec![pair.clone()], Depth::Formulas);
        if let Ok([Proof::Found]) = proof.as_deref() {
            continue;
        }
        let Err(tried) = refute(MANY, report) else { continue };
        match proof.as_deref() {
            Ok([proof @ Proof::Undefined(..)]) => refuse_undefined(*proof, report),
            Ok(proof) => {
                let why = match proof {
                    [Proof::TooLong] => "the formulas grow too long when they are expanded; expected a shorter claim",
                    _ => {
                        "they are not the same under the rules of fractions, roots, sin² + cos² = 1 and the addition \
                         theorems; expected formulas that are"
                    }
                };
                report.error(
                    claim.region(),
                    format!("{}, and {}: {why}", describe_unproved(claim), describe_tried(tried)),
                );
            }
            Err(failure) => report.error(claim.region(), failure),
        }
    }
}

fn describe_refuted(claim: &Claim, counterexample: &Counterexample, parameters: &[Ident]) -> String {
    let Counterexample { set, values, left, right } = counterexample;
    let [left, right] = set_apart(*left, *right);
    let values: Vec<String> =
        values.iter().map(|(index, value)| format!("{} = {}", parameters[*index], number(*value))).collect();
    let place = match (set, values.is_empty()) {
        (_, true) => String::new(),
        (Some(set), false) => format!(" in the set `{set}`, at {}", values.join(", ")),
        (None, false) => format!(" at {}", values.join(", ")),
    };
    match &claim.kind {
        Kind::Mirrored(name, row, column) => format!(
            "`{}` is not symmetric: row {column}, column {row} is {right} and row {row}, column {column} is {left}\
             {place}; expected the same value in both",
            name.name(),
        ),
        Kind::Asserted([left_text, right_text]) => format!(
            "the sides differ: `{left_text}` is {left} and `{right_text}` is {right}{place}; expected the same value \
             for all parameters",
        ),
    }
}

fn describe_unproved(claim: &Claim) -> String {
    match &claim.kind {
        Kind::Mirrored(name, row, column) => format!(
            "`{}` could not be proved symmetric in row {column}, column {row} and row {row}, column {column}",
            name.name(),
        ),
        Kind::Asserted(_) => "the sides could not be proved equal".into(),
    }
}

fn describe_tried(tried: usize) -> String {
    match tried {
        0 => "no values were found that the domains and requirements allow".into(),
        1 => "one set of values that was tried shows no difference".into(),
        tried => format!("{tried} sets of values that were tried show no difference"),
    }
}

/// Two different numbers with no more digits than it takes to see that.
fn set_apart(left: f64, right: f64) -> [String; 2] {
    let short = |value: f64, digits: usize| {
        let rounded = format!("{value:.digits$e}").parse().unwrap_or(value);
        number(rounded)
    };
    let texts = [5, 9, 13].map(|digits| [left, right].map(|value| short(value, digits)));
    let different = texts.into_iter().find(|[left, right]| left != right);
    different.unwrap_or_else(|| [left, right].map(number))
}
