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
fn a_power_is_multiplications_and_perhaps_a_division() {
    let source = "fn f(a: f64) -> f64 { a.powi(2) + a.powi(3) + a.powi(-1) + a.powi(-2) }";
    let expected = Operations { additions: 3, multiplications: 4, divisions: 2, ..Operations::default() };
    assert_eq!(count(source, "f"), expected);
}

#[test]
fn appendix_a_by_hand_takes_175() {
    assert_eq!(count(include_str!("../../src/hand_written.rs"), "matrices").total(), 175);
}

/// The counts stated in the documentation of generated code, in the order in which it states them; last their sum.
fn stated(source: &str) -> Vec<usize> {
    let line = source.lines().find(|line| line.contains("operations.")).expect("a line that states the counts");
    line.split(|c: char| !c.is_ascii_digit()).filter_map(|word| word.parse().ok()).collect()
}

/// The operations of each shipped model that must never become more; lower a number when the compiler finds a shorter
/// program.
const MOST: [(&str, &str, usize); 9] = [
    ("whipple", include_str!("../../../generated/src/models/whipple.rs"), 134),
    ("whipple_mechanism", include_str!("../../../generated/src/models/whipple_mechanism.rs"), 107),
    ("whipple_sprung", include_str!("../../../generated/src/models/whipple_sprung.rs"), 108),
    ("whipple_tyres", include_str!("../../../generated/src/models/whipple_tyres.rs"), 122),
    ("whipple_leaning", include_str!("../../../generated/src/models/whipple_leaning.rs"), 141),
    ("rear_steered", include_str!("../../../generated/src/models/rear_steered.rs"), 109),
    ("rolling_disc", include_str!("../../../generated/src/models/rolling_disc.rs"), 8),
    ("skateboard", include_str!("../../../generated/src/models/skateboard.rs"), 35),
    ("double_pendulum", include_str!("../../../generated/src/models/double_pendulum.rs"), 21),
];

#[test]
fn generated_code_states_its_operations_and_never_takes_more_than_before() {
    for (model, source, most) in MOST {
        let counted = count(source, "matrices");
        let Operations { additions, multiplications, divisions, negations, functions } = counted;
        let stated = stated(source);
        // Kinds of which there are none are not stated.
        let counts = [additions, multiplications, divisions, negations, functions];
        let counts: Vec<usize> = counts.into_iter().filter(|count| *count > 0).chain([counted.total()]).collect();
        assert_eq!(stated, counts, "{model}");
        assert!(counted.total() <= most, "{model}: {counted}");
    }
}
