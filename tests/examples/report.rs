//! Prints operations and rounding errors of generated code, of Appendix A by hand and of a peer's code.
//!
//! Two models come out of the compiler: from the formulas of Appendix A, and from the bodies of the mechanism. What they
//! take in time is in the benchmark `summary`.
//!
//! `cargo run --release -p carvallo-tests --example report`

use carvallo::Scalar;
use carvallo_models::{Whipple, WhippleMechanism};
use carvallo_tests::designs;
use carvallo_tests::exact::{Matrices, matrices};
use carvallo_tests::hand_written::{self, Float};
use carvallo_tests::operations::count;
use carvallo_tests::peers::symplex::{self, Symplex};
use carvallo_tests::real::Real;

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

fn mechanism<T: Scalar>(design: &Whipple<T>) -> WhippleMechanism<T> {
    WhippleMechanism::from_array(design.to_array())
}

/// The largest error of an entry, in units of the last place of the largest entry of its matrix.
fn errors<T: Float + Symplex>(scalar: &str, epsilon: f64, design: fn(u64) -> Whipple<T>) {
    let mut largest = [0f64; 4];
    for number in 0..DESIGNS {
        let design = design(number);
        let exact: Matrices<Real> = matrices(&design);
        let (formulas, bodies) = (design.matrices(), mechanism(&design).matrices());
        let (by_hand, peer) = (hand_written::matrices(&design), symplex::matrices(&design));
        let ways = [
            [formulas.m, formulas.c1, formulas.k0, formulas.k2],
            [bodies.m, bodies.c1, bodies.k0, bodies.k2],
            [by_hand.m, by_hand.c1, by_hand.k0, by_hand.k2],
            [peer.m, peer.c1, peer.k0, peer.k2],
        ];
        for (largest, computed) in largest.iter_mut().zip(ways) {
            for (computed, exact) in computed.iter().zip(&exact) {
                let entries = || [(0, 0), (0, 1), (1, 0), (1, 1)].into_iter();
                let entry = |(row, column): (usize, usize)| exact[row][column];
                let largest_entry = entries().map(|at| entry(at).abs().to_f64()).fold(0.0, f64::max);
                let unit = epsilon * 2f64.powf(largest_entry.log2().floor());
                let error = entries().map(|at| (Real::from(computed[at.0][at.1].to_f64()) - entry(at)).abs().to_f64());
                *largest = largest.max(error.fold(0.0, f64::max) / unit);
            }
        }
    }
    let label = format!("largest error in ulp, {DESIGNS} designs, {scalar}");
    row(&label, largest.map(|error| format!("{error:.2}")));
}
