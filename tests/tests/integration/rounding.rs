//! Rounding errors of generated matrices, against exact arithmetic and against Appendix A by hand.
//!
//! The optimizer chooses among arrangements of the formulas that differ in how their errors add up. Of 10,000 designs the
//! benchmark `summary` prints the same figures.

use carvallo_compare::Limits;
use carvallo_tests::designs;
use carvallo_tests::rounding::four_ways;

/// As many as take a few seconds without optimization. Design 1295, among them, has the largest error of Appendix A by
/// hand among the first 10,000.
const DESIGNS: std::ops::Range<u64> = 1_000..1_600;

#[test]
fn generated_matrices_are_no_less_accurate_than_appendix_a_by_hand() {
    let report = four_ways(DESIGNS.map(designs::numbered)).report().expect("designs");
    let [formulas, bodies, by_hand, _] = &report.sides[..] else { panic!("four ways") };
    let single = |side: &carvallo_compare::SideReport| side.single.as_ref().expect("single precision").ulps_of_matrix;
    for generated in [formulas, bodies] {
        assert!(generated.double.ulps_of_matrix <= by_hand.double.ulps_of_matrix, "{report}");
        assert!(single(generated) <= single(by_hand), "{report}");
    }
    // Of its terms, each entry is off by what the head of `designs.rs` derives, in a unit that may be half as large.
    report.assert(Limits { ulps: 32.0, ..Limits::default() });
}

/// Counted as they are done, operations are those that are counted in the source.
#[test]
fn operations_are_those_of_the_source() {
    let report = four_ways([carvallo_models::Whipple::BENCHMARK]).report().expect("a design");
    let sources = [
        include_str!("../../../generated/src/models/whipple.rs"),
        include_str!("../../../generated/src/models/whipple_mechanism.rs"),
        include_str!("../../src/hand_written.rs"),
    ];
    for (side, source) in report.sides.iter().zip(sources) {
        assert_eq!(side.operations, Some(carvallo_tests::operations::count(source, "matrices")), "{}", side.name);
    }
    assert_eq!(report.sides[3].operations, None);
}
