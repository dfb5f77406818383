//! Prints operations and rounding errors of generated code, of Appendix A by hand and of a peer's code.
//!
//! Two models come out of the compiler: from the formulas of Appendix A, and from the bodies of the mechanism. What they
//! take in time is in the benchmark `summary`.
//!
//! `cargo run --profile bench -p carvallo-tools --no-default-features --bin report`

use carvallo_models::Whipple;
use carvallo_tests::designs;
use carvallo_tests::hand_written::Float;
use carvallo_tests::operations::count;
use carvallo_tests::peers::symplex::Symplex;
use carvallo_tests::rounding::{Ways, largest};

const DESIGNS: u64 = 10_000;

fn main() {
    row("Whipple bicycle, 4 matrices", ["from formulas", "from bodies", "by hand", "symplex-build"]);
    let sources = [
        include_str!("../../generated/src/models/whipple.rs"),
        include_str!("../../generated/src/models/whipple_mechanism.rs"),
        include_str!("../src/hand_written.rs"),
        include_str!("../src/peers/symplex/f64.rs"),
    ];
    row("operations", sources.map(|source| count(source, "matrices").total()));
    errors("f64", f64::EPSILON, designs::numbered);
    errors("f32", f32::EPSILON.into(), |number| designs::narrowed(&designs::numbered(number)));
}

fn row<T: std::fmt::Display>(label: &str, columns: [T; 4]) {
    let [formulas, bodies, by_hand, peer] = columns.map(|column| column.to_string());
    println!("{label:<42} {formulas:>14} {bodies:>14} {by_hand:>14} {peer:>14}");
}

fn errors<T: Float + Symplex>(scalar: &str, epsilon: f64, design: fn(u64) -> Whipple<T>) {
    let Ways { formulas, bodies, by_hand, symplex } = largest((0..DESIGNS).map(design), epsilon);
    let label = format!("largest error in ulp, {DESIGNS} designs, {scalar}");
    row(&label, [formulas, bodies, by_hand, symplex].map(|error| format!("{error:.2}")));
}
