//! Counts of operations, counted in the source.

use carvallo_tests::operations::{Operations, count};

#[test]
fn every_kind_is_counted() {
    let source =
        "impl A { fn f(a: f64, b: f64) -> f64 { let c = (a + b) * a - 2.0 / -b; c.sin() + f64::sin_cos(c).0 * -1.0 } }";
    let expected = Operations { additions: 3, multiplications: 2, divisions: 1, negations: 1, functions: 3 };
    assert_eq!(count(source, "f"), expected);
    assert_eq!(expected.total(), 10);
}

#[test]
fn appendix_a_by_hand_takes_175() {
    assert_eq!(count(include_str!("../../src/hand_written.rs"), "matrices").total(), 175);
}

/// The counts stated in the documentation of generated code, in the order in which it states them; last their sum.
fn stated(source: &str) -> [usize; 6] {
    let line = source.lines().find(|line| line.contains("operations.")).expect("a line that states the counts");
    let numbers = line.split(|c: char| !c.is_ascii_digit()).filter_map(|word| word.parse().ok());
    numbers.collect::<Vec<_>>().try_into().expect("six numbers")
}

#[test]
fn generated_code_states_its_operations_and_never_takes_more_than_before() {
    let source = include_str!("../../../generated/src/models/whipple.rs");
    let counted = count(source, "matrices");
    let Operations { additions, multiplications, divisions, negations, functions } = counted;
    let counts = [additions, multiplications, divisions, negations, functions, counted.total()];
    assert_eq!(stated(source), counts);
    // Lower the number when the compiler finds a shorter program.
    assert!(counted.total() <= 134, "{counted}");
}
