//! Prints how many slips in the formulas of the Whipple bicycle, and in the attributes of its mechanism, `carvallo check` names,
//! from what somebody has of the benchmark bicycle who made them, one at a time and two at once.
//!
//! ```text
//! cargo run --release -p carvallo-tools --no-default-features --bin explained [EVERY [PAIRS]]
//! ```
//!
//! With a number only every so many of them, with 0 none; and so many random pairs, 500 unless it is said.

use std::time::Instant;

use carvallo_tests::explained::{
    Evidence, Outcome, Tally, benchmark, count, measure, measure_attributes, measure_pairs, mechanism,
};

fn main() {
    let every = std::env::args().nth(1).map_or(1, |every| every.parse().expect("a number: every so many slips"));
    let pairs = std::env::args().nth(2).map_or(500, |pairs| pairs.parse().expect("a number of pairs"));
    let machine = benchmark();
    println!("{} slips in {} formulas.\n", count(&machine), machine.formulas.formulas.len());
    println!(
        "| given | no such numbers | silent | alone | one formula | same matrices here | first of several | among several \
         | another named | none named | named, of those not silent | explanations: 1, 2, 3 to 5, 6 to 20, more | a check |"
    );
    println!("|{}", " ---: |".repeat(13));
    for evidence in Evidence::ALL.into_iter().filter(|_| every > 0) {
        row(&evidence.to_string(), &|| measure(&machine, evidence, every));
    }
    let bodies = mechanism();
    for evidence in Evidence::ALL.into_iter().chain(Evidence::OF_MOTION).filter(|_| every > 0) {
        row(&format!("attributes of the mechanism: {evidence}"), &|| measure_attributes(&bodies, evidence, every));
    }
    for (of, has_sense) in [("that make sense by their units", true), ("of all", false)] {
        // Of eigenvalues those alone are tried that make sense.
        let all = Evidence::ALL.into_iter().filter(|own| match own {
            Evidence::Matrices(_) | Evidence::StateMatrix(_) => true,
            Evidence::Eigenvalues(_) => has_sense,
            Evidence::CriticalSpeeds(_) | Evidence::Accelerations(_) => false,
        });
        for evidence in all {
            let what = format!("{pairs} pairs {of}: {evidence}");
            row(&what, &|| measure_pairs(&machine, evidence, pairs, has_sense));
        }
    }
}

fn row(what: &str, measure: &dyn Fn() -> Tally) {
    let start = Instant::now();
    let tally = measure();
    let all: usize = tally.outcomes.values().sum();
    let each = start.elapsed().as_secs_f64() * 1e3 / all as f64;
    let counts = Outcome::ALL.map(|outcome| tally.count(outcome).to_string()).join(" | ");
    let [named, of] = tally.named();
    let sizes = [1..=1, 2..=2, 3..=5, 6..=20, 21..=usize::MAX].map(|own| tally.of_size(own).to_string()).join(", ");
    println!("| {what} | {counts} | {:.2} % | {sizes} | {each:.1} ms |", 100.0 * named as f64 / of as f64);
}
