//! Slips in the formulas of the Whipple bicycle, and the share of them that the compiler catches.
//!
//! A sample, the same on every run; all of them take some minutes: `cargo run -p carvallo-tools --bin mutants`.

use carvallo_tests::designs;
use carvallo_tests::mutants::{Evidence, Kind, Original, Tally, all, whipple};

/// For each kind of slip every how many are tried, and the least share of them that must be caught with each evidence: the
/// measured one, rounded down to whole percents; of those at 0 nothing is caught. Raise it when a check catches more.
const LEAST_CAUGHT: [(Kind, usize, [f64; 3]); 11] = [
    (Kind::SignOfTerm, 11, [0.0, 0.0, 0.85]),
    (Kind::ProductOrQuotient, 11, [0.87, 0.87, 1.0]),
    (Kind::SumOrProduct, 23, [1.0, 1.0, 1.0]),
    (Kind::Minus, 2, [0.33, 0.33, 1.0]),
    (Kind::Exponent, 5, [0.83, 1.0, 1.0]),
    (Kind::SimilarName, 97, [0.6, 0.6, 1.0]),
    (Kind::OtherName, 397, [0.9, 0.95, 1.0]),
    (Kind::Factor, 13, [0.84, 0.84, 1.0]),
    (Kind::Term, 11, [0.0, 0.0, 0.9]),
    (Kind::Function, 5, [0.0, 0.75, 1.0]),
    (Kind::Number, 3, [0.5, 0.5, 1.0]),
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
fn slips_are_caught() {
    for (column, evidence) in Evidence::ALL.into_iter().enumerate() {
        let tally = sample(evidence);
        for (kind, _, least) in LEAST_CAUGHT {
            let (caught, least) = (tally.caught(&[kind]), least[column]);
            assert!(caught >= least, "with {evidence}: {kind}: {caught:.3} caught instead of {least}\n{tally}");
        }
    }
}
