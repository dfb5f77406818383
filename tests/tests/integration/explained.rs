//! What `carvallo check` makes of slips in the formulas of the Whipple bicycle: each is named, of those whose numbers differ.
//!
//! A sample, the same on every run; all of them take some minutes:
//! `cargo run --release -p carvallo-tools --no-default-features --bin explained`.

use carvallo_slips::{Kind, slips};
use carvallo_tests::explained::{Evidence, FULL, Outcome, benchmark, count, measure, measure_attributes, mechanism};
use carvallo_tests::mutants::{self, all, whipple};

/// The slips that are made when the program runs, of what `carvallo equations` prints, are those that the compiler is measured
/// on, of the declaration: as many of each kind.
#[test]
fn slips_are_those_of_the_declaration() {
    let machine = benchmark();
    let mutants = all(&whipple(mutants::Evidence::Sets));
    let formulas = machine.formulas.formulas.iter();
    let own: Vec<Kind> = formulas
        .flat_map(|formula| slips(formula.text, &machine.formulas.names))
        .map(|slip| slip.kind)
        .collect::<Vec<_>>();
    assert_eq!((count(&machine), mutants.len()), (9297, 9297));
    for kind in Kind::PLAIN {
        let of_declaration = mutants.iter().filter(|mutant| mutant.kind == kind).count();
        assert_eq!(own.iter().filter(|own| **own == kind).count(), of_declaration, "{kind}");
    }
}

#[test]
fn slips_are_named_from_matrices() {
    let machine = benchmark();
    // How many are the only explanation, as measured: that may not fall.
    for (digits, alone) in [(FULL, 76), (4, 56)] {
        let tally = measure(&machine, Evidence::Matrices(digits), 97);
        let [named, of] = tally.named();
        assert!(of > 80 && named == of, "{tally:?}");
        assert!(tally.count(Outcome::Alone) >= alone, "{tally:?}");
    }
}

/// Of the bicycle as a mechanism.
#[test]
fn slips_of_attributes_are_named_from_matrices() {
    let machine = mechanism();
    for digits in [FULL, 4] {
        let tally = measure_attributes(&machine, Evidence::Matrices(digits), 23);
        let [named, of] = tally.named();
        assert!(of > 20 && named == of, "{tally:?}");
    }
}

/// By the nonlinear equations.
#[test]
fn slips_of_attributes_are_named_from_accelerations() {
    let machine = mechanism();
    for evidence in Evidence::OF_MOTION {
        let tally = measure_attributes(&machine, evidence, 23);
        let [named, of] = tally.named();
        assert!(of > 20 && named == of, "{tally:?}");
    }
}

#[test]
fn slips_are_named_from_critical_speeds() {
    let [named, of] = measure(&benchmark(), Evidence::CriticalSpeeds(FULL), 397).named();
    assert!(of > 10 && named == of);
}

/// Also where a slip changes no more than what cutting digits off would.
#[test]
fn slips_are_named_from_rounded_eigenvalues() {
    let [named, of] = measure(&benchmark(), Evidence::Eigenvalues(4), 41).named();
    assert!(of > 200 && named == of, "{named} of {of}");
}
