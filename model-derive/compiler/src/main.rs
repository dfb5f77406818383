//! `carvallo-compiler`: writes the Rust of models ahead of time, or checks it.

use std::path::Path;
use std::process::ExitCode;

use carvallo_compiler::files::{self, MODELS, WRITTEN};
use carvallo_compiler::{Kept, with_answers};

const HELP: &str = "\
Compiles models ahead of time: each file with a `carvallo::model! { … }` to a file of Rust,
which needs the crate `carvallo` without its feature `derive`, and no compiler of models.

Usage: carvallo-compiler expand [--check] [MODELS [FOLDER]]
       cargo regenerate [--check]

`expand` writes FOLDER/NAME.rs for each MODELS/NAME.rs, and FOLDER/mod.rs with all of them;
`regenerate` does it in the workspace of Carvallo, from generated/models/.

Arguments:
  MODELS    A folder with the declarations [default: models]
  FOLDER    Where the Rust goes [default: src/models]

Options:
  --check   Write nothing; fail if a file is stale, missing or left over
  --help    Print this

What was derived is kept for the next time; CARVALLO_CACHE=off in the environment keeps nothing.";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    if words.iter().any(|word| ["--help", "-h"].contains(word)) {
        println!("{HELP}");
        return ExitCode::SUCCESS;
    }
    let all = words.len();
    words.retain(|word| *word != "--check");
    let check = words.len() < all;
    let result = match words[..] {
        _ if words.iter().any(|word| word.starts_with('-')) => None,
        // The sources are part of the workspace that this program was built in.
        ["regenerate"] => {
            let generated = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../generated");
            Some(keeping_answers(|| files::regenerate(&generated, check)))
        }
        ["expand"] => Some(expand(MODELS, WRITTEN, check)),
        ["expand", models] => Some(expand(models, WRITTEN, check)),
        ["expand", models, written] => Some(expand(models, written, check)),
        _ => None,
    };
    match result {
        Some(Ok(done)) => {
            println!("{done}");
            ExitCode::SUCCESS
        }
        Some(Err(message)) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
        None => {
            eprintln!("error: unexpected arguments `{}`\n\n{HELP}", arguments.join(" "));
            ExitCode::from(2)
        }
    }
}

fn expand(models: &str, written: &str, check: bool) -> Result<String, String> {
    keeping_answers(|| files::expand(Path::new(models), Path::new(written), check))
}

fn keeping_answers<T>(work: impl FnOnce() -> T) -> T {
    with_answers(Kept::of_this_build(), work)
}
