//! Counts of operations, counted in the source.

use std::collections::BTreeMap;

use carvallo_compare::Operations;
use carvallo_tests::operations::{COLUMNS, count, shipped};

#[test]
fn every_kind_is_counted() {
    let source = "impl A { fn f(a: f64, b: f64) -> f64 { let c = (a + b) * a - 2.0 / -b; c.sin() + f64::sin_cos(c).0 * -1.0 + f64::sqrt(a) } }";
    let expected =
        Operations { additions: 4, multiplications: 2, divisions: 1, negations: 1, roots: 1, trigonometric: 3 };
    assert_eq!(count(source, "f"), expected);
    assert_eq!(expected.total(), 12);
}

#[test]
fn a_power_is_multiplications_and_perhaps_a_division() {
    let source = "fn f(a: f64) -> f64 { a.powi(2) + a.powi(3) + a.powi(-1) + a.powi(-2) }";
    let expected = Operations { additions: 3, multiplications: 4, divisions: 2, ..Operations::default() };
    assert_eq!(count(source, "f"), expected);
}

#[test]
fn appendix_a_by_hand_takes_175() {
    assert_eq!(count(include_str!("../../src/hand_written.rs"), "matrices").total(), 175);
}

/// The counts stated in the documentation of a generated function, in the order in which it states them; last their sum.
fn stated(source: &str, function: &str) -> Vec<usize> {
    let (documentation, _) = source.split_once(&format!("pub fn {function}(")).expect("the function");
    let line = documentation.lines().rfind(|line| line.contains("operation")).expect("a line that states the counts");
    line.split(|c: char| !c.is_ascii_digit()).filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn generated_code_states_its_operations() {
    let sources = [
        (include_str!("../../../generated/src/models/whipple.rs"), "matrices"),
        (include_str!("../../../generated/src/models/whipple_mechanism.rs"), "matrices"),
        (include_str!("../../../generated/src/models/whipple_leaning.rs"), "kinematics"),
        (include_str!("../../../generated/src/models/skateboard.rs"), "matrices"),
        (include_str!("../../../generated/src/models/skateboard.rs"), "kinematics"),
    ];
    for (source, function) in sources {
        let counted = count(source, function);
        // Kinds of which there are none are not stated.
        let counts: Vec<usize> = counted.kinds().into_iter().filter(|count| *count > 0).collect();
        assert_eq!(stated(source, function), [counts, vec![counted.total()]].concat(), "{function}");
    }
}

/// Every program of every shipped model has a row, and takes what the row says: more is a step back, and what is less is
/// written down, so that it stays.
#[test]
fn no_program_of_a_shipped_model_takes_more_operations_than_before() {
    const COMMAND: &str =
        "cargo run -p carvallo-tools --no-default-features --bin operations > tests/data/operations.tsv";
    let table = include_str!("../../data/operations.tsv");
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some(COLUMNS));
    let mut before: BTreeMap<&str, &str> = BTreeMap::new();
    for line in lines {
        let at = line.match_indices('\t').nth(1).expect("a model and a program").0;
        before.insert(&line[..at], &line[at + 1..]);
    }
    let total = |counts: &str| counts.rsplit('\t').next().and_then(|total| total.parse().ok()).unwrap_or(0usize);
    for (program, counted) in shipped() {
        let name = program.replace('\t', ": ");
        let before = before.remove(&*program).unwrap_or_else(|| panic!("{name} has no row: `{COMMAND}` writes it"));
        let most = total(before);
        assert!(counted.total() <= most, "{name} takes {} operations, more than the {most} of before", counted.total());
        assert_eq!(
            counted.to_string(),
            before,
            "{name} takes other operations than before: `{COMMAND}` writes them down"
        );
    }
    assert!(before.is_empty(), "no longer there: {before:?}; `{COMMAND}` writes the others");
}

#[test]
fn the_bicycle_takes_no_more_than_a_person_needs() {
    // What a person got by simplifying Appendix A.
    const BY_A_PERSON: usize = 113;
    for (name, counted) in shipped() {
        if ["whipple\tmatrices", "whipple_mechanism\tmatrices"].contains(&&*name) {
            assert!(counted.total() <= BY_A_PERSON, "{name}: {}", counted.total());
        }
    }
}
