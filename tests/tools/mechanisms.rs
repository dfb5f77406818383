//! What it takes to derive mechanisms: time by phase, and operations of the programs that come out.
//!
//! ```text
//! cargo run -p carvallo-tools --bin mechanisms [LINKS…]
//! ```
//!
//! With numbers behind it, chains of so many links alone, with inertia and of point masses, once each.
//!
//! The derivation holds the checks of the declaration, the proofs and the published matrices in it; the code generation
//! the search for the shortest programs, and writing them. Each in one thread, the shortest of several runs. Times are those
//! of the profile that this program is built in: `dev` is what a user's build expands macros with.

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use carvallo_compiler::program::Counts;
use carvallo_compiler::{Driver, check, compile, expand};
use carvallo_tests::chain;
use proc_macro2::TokenStream;

/// Runs of each phase.
const RUNS: usize = 5;

fn main() {
    println!("{:<24} {:>4} {:>14} {:>16} {:>11}", "model", "N", "derivation (s)", "generation (s)", "operations");
    let long: Vec<usize> = std::env::args().skip(1).map(|n| n.parse().expect("a number of links")).collect();
    if !long.is_empty() {
        for n in long {
            measure(&format!("chain of {n}"), &chain::declaration(n), 1);
            measure(&format!("chain of {n} points"), &chain::hanging_points(n), 1);
        }
        return;
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../generated/models");
    let mut sources: Vec<_> =
        fs::read_dir(folder).expect("the models").map(|entry| entry.expect("an entry").path()).collect();
    sources.sort();
    for path in sources {
        let text = fs::read_to_string(&path).expect("a source");
        let (_, body) = text.split_once('{').expect("an opening brace");
        let (body, _) = body.rsplit_once('}').expect("a closing brace");
        let stem = path.file_stem().expect("a name").to_string_lossy();
        measure(&stem, body, RUNS);
    }
    let mut last: Option<(f64, f64)> = None;
    for n in 1..=8 {
        let (seconds, operations) = measure(&format!("chain of {n}"), &chain::declaration(n), RUNS);
        if let Some((before, fewer)) = last {
            let power = |now: f64, before: f64| (now / before).ln() / (n as f64 / (n as f64 - 1.0)).ln();
            println!(
                "{:<24} time grew as n^{:.1}, operations as n^{:.1}",
                "",
                power(seconds, before),
                power(operations, fewer)
            );
        }
        last = Some((seconds, operations));
    }
}

/// Prints a line, and returns the time of both phases in seconds and the number of operations.
fn measure(name: &str, declaration: &str, runs: usize) -> (f64, f64) {
    let tokens = || declaration.parse::<TokenStream>().expect("tokens");
    let derivation = shortest(runs, || drop(check(tokens()).expect("a model")));
    let all = shortest(runs, || drop(expand(tokens(), &Driver::File).expect("a model")));
    let compiled = compile(tokens()).expect("a model");
    let operations = Counts::of(&compiled.programs.matrices).total();
    let n = compiled.model.coordinates.len();
    let generation = all.saturating_sub(derivation);
    println!(
        "{name:<24} {n:>4} {:>14.3} {:>16.3} {operations:>11}",
        derivation.as_secs_f64(),
        generation.as_secs_f64()
    );
    (all.as_secs_f64(), operations as f64)
}

fn shortest(runs: usize, run: impl Fn()) -> Duration {
    let time = |_| {
        let start = Instant::now();
        run();
        start.elapsed()
    };
    (0..runs).map(time).min().unwrap_or_default()
}
