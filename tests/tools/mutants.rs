//! Prints how many slips in the formulas of the Whipple bicycle the compiler catches, by which check, and which not.
//!
//! `cargo run -p carvallo-tools --bin mutants [EVERY]`; with a number only every so many of them.

use std::time::Instant;

use carvallo_tests::designs;
use carvallo_tests::mutants::{Evidence, Kind, Mutant, Original, Tally, Verdict, all, whipple};

/// Of each kind that survives so many are shown, spread evenly.
const EXAMPLES: usize = 12;

fn main() {
    let every = std::env::args().nth(1).map_or(1, |every| every.parse().expect("a number: every so many mutants"));
    for evidence in Evidence::ALL {
        let start = Instant::now();
        let declaration = whipple(evidence);
        let (tally, survivors) = judge(&declaration, every);
        println!("With {evidence}, in {:.0} s:\n\n{tally}\n\nWhat survives:", start.elapsed().as_secs_f64());
        for kind in Kind::PLAIN {
            let of_kind: Vec<&Mutant> = survivors.iter().filter(|mutant| mutant.kind == kind).collect();
            println!("\n{kind}: {}", of_kind.len());
            for mutant in of_kind.iter().step_by(of_kind.len().div_ceil(EXAMPLES).max(1)) {
                println!("    {}", mutant.show(&declaration));
            }
        }
        println!();
    }
}

fn judge(declaration: &str, every: usize) -> (Tally, Vec<Mutant>) {
    let original =
        Original::new(declaration, (0..8).map(|number| designs::numbered(number).to_array().into()).collect());
    let mut tally = Tally::default();
    let mut survivors: Vec<Mutant> = Vec::new();
    for mutant in all(declaration).into_iter().step_by(every) {
        let verdict = original.judge(&mutant);
        tally.add(&mutant, verdict);
        if verdict == Verdict::Survived {
            survivors.push(mutant);
        }
    }
    (tally, survivors)
}
