//! Slips in the formulas of the Whipple bicycle, and the share of them that the compiler catches.
//!
//! A sample, the same on every run; all of them take some minutes: `cargo run -p carvallo-tests --example mutants`.

use carvallo_tests::designs;
use carvallo_tests::mutants::{Kind, Original, Tally, all, whipple};

/// For each kind of slip every how many are tried, and the share of those caught that is the least: the measured one,
/// rounded down to whole percents. Raise it when a check catches more.
const LEAST_CAUGHT: [(Kind, usize, f64); 11] = [
    (Kind::SignOfTerm, 11, 0.0),
    (Kind::ProductOrQuotient, 11, 0.0),
    (Kind::SumOrProduct, 23, 0.0),
    (Kind::Minus, 2, 0.0),
    (Kind::Exponent, 5, 0.0),
    (Kind::SimilarName, 97, 0.11),
    (Kind::OtherName, 397, 0.05),
    (Kind::Factor, 13, 0.0),
    (Kind::Term, 11, 0.0),
    (Kind::Function, 5, 0.0),
    (Kind::Number, 3, 0.0),
];

#[test]
fn slips_are_caught() {
    let declaration = whipple();
    let original =
        Original::new(declaration, (0..8).map(|number| designs::numbered(number).to_array().into()).collect());
    let mutants = all(declaration);
    let mut tally = Tally::default();
    for (kind, every, _) in LEAST_CAUGHT {
        for mutant in mutants.iter().filter(|mutant| mutant.kind == kind).step_by(every) {
            tally.add(mutant, original.judge(mutant));
        }
    }
    for (kind, _, least) in LEAST_CAUGHT {
        let caught = tally.caught(&[kind]);
        assert!(caught >= least, "{kind}: {caught:.3} caught instead of {least}\n{tally}");
    }
}
