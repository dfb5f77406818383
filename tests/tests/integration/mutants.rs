//! Slips in the formulas of the Whipple bicycle, and the share of them that the compiler catches.
//!
//! A sample, the same on every run; all of them take some minutes: `cargo run -p carvallo-tests --example mutants`.

use carvallo_tests::designs;
use carvallo_tests::mutants::{Evidence, Kind, Original, Tally, all, whipple};

/// For each kind of slip every how many are tried, and the least share of them that must be caught: the measured one,
/// rounded down to whole percents, with units and symmetry alone and with directions too. Raise it when a check catches
/// more.
const LEAST_CAUGHT: [(Kind, usize, [f64; 2]); 11] = [
    (Kind::SignOfTerm, 11, [0.0, 0.0]),
    (Kind::ProductOrQuotient, 11, [0.0, 0.0]),
    (Kind::SumOrProduct, 23, [0.0, 0.0]),
    (Kind::Minus, 2, [0.0, 0.0]),
    (Kind::Exponent, 5, [0.0, 0.0]),
    (Kind::SimilarName, 97, [0.11, 0.0]),
    (Kind::OtherName, 397, [0.05, 0.0]),
    (Kind::Factor, 13, [0.0, 0.0]),
    (Kind::Term, 11, [0.0, 0.0]),
    (Kind::Function, 5, [0.0, 0.0]),
    (Kind::Number, 3, [0.0, 0.0]),
];

fn sample(evidence: Evidence) -> Tally {
    let declaration = whipple(evidence);
    let original =
        Original::new(&declaration, (0..8).map(|number| designs::numbered(number).to_array().into()).collect());
    let mutants = all(&declaration);
    let mut tally = Tally::default();
    for (kind, every, _) in LEAST_CAUGHT {
        for mutant in mutants.iter().filter(|mutant| mutant.kind == kind).step_by(every) {
            tally.add(mutant, original.judge(mutant));
        }
    }
    tally
}

#[test]
fn units_symmetry_and_directions_catch_slips() {
    for (column, evidence) in [Evidence::Units, Evidence::Directions].into_iter().enumerate() {
        let tally = sample(evidence);
        for (kind, _, least) in LEAST_CAUGHT {
            let (caught, least) = (tally.caught(&[kind]), least[column]);
            assert!(caught >= least, "{evidence}: {kind}: {caught:.3} caught instead of {least}\n{tally}");
        }
    }
}

#[test]
fn published_matrices_let_no_slip_through() {
    let tally = sample(Evidence::Sets);
    assert_eq!(tally.caught(&Kind::ALL), 1.0, "{tally}");
}
