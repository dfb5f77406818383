//! Counts the instructions of the evaluators under valgrind, which no noise of the machine can move.
//!
//! Every evaluator runs in a process of its own, n times and 2 n times: the difference leaves out what a process takes to
//! start. valgrind 3.19 hides AVX-512 from programs, so batches are counted up to AVX2.
//!
//! `cargo run --profile bench -p carvallo-tools --no-default-features --bin instructions`

mod baseline;
mod batches;
mod count;
mod evaluators;

use std::process::ExitCode;

use baseline::Baseline;
use evaluators::EVALUATORS;

const COMMAND: &str = "cargo run --profile bench -p carvallo-tools --no-default-features --bin instructions";
const OPTIONS: &str = "options:
  (nothing)  counts, beside those of the baseline in tests/data/instructions.tsv
  --check    the same, and fails if one has grown by more than 2 %
  --write    makes what is counted the baseline";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match arguments[..] {
        // What valgrind runs.
        ["run", name, calls] => return evaluators::run(name, calls.parse().expect("a number of calls")),
        [] => counted().map(|(found, written)| baseline::compare(&found, &written)).map(|_| ()),
        ["--check"] => counted().and_then(|(found, written)| match baseline::compare(&found, &written) {
            grown if grown.is_empty() => Ok(()),
            grown => Err(format!(
                "not as few instructions as before: {}\nIf that is meant, make it the baseline: {COMMAND} -- --write",
                grown.join("; ")
            )),
        }),
        ["--write"] => count::all().and_then(|found| found.write()),
        ["--help" | "-h"] => {
            println!("usage: {COMMAND} [-- --check | --write]\n\n{OPTIONS}");
            return ExitCode::SUCCESS;
        }
        _ => {
            eprintln!("error: unknown arguments {arguments:?}\n\nusage: {COMMAND} [-- --check | --write]\n\n{OPTIONS}");
            return ExitCode::from(2);
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// What is counted now, and what is written in the baseline.
fn counted() -> Result<(Baseline, Baseline), String> {
    Ok((count::all()?, Baseline::read()?))
}
