//! `cargo regenerate`: writes the Rust of the models that are compiled ahead of time, or checks it.

use std::path::Path;
use std::process::ExitCode;

const HELP: &str = "\
Compiles the model sources in generated/models/ to Rust in generated/src/models/.

Usage: cargo regenerate [--check]

Options:
  --check   Write nothing; fail if a file is stale, missing or left over
  --help    Print this";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let check = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => false,
        ["--check"] => true,
        ["--help" | "-h"] => {
            println!("{HELP}");
            return ExitCode::SUCCESS;
        }
        _ => {
            eprintln!("error: unexpected arguments `{}`\n\n{HELP}", arguments.join(" "));
            return ExitCode::from(2);
        }
    };
    // The sources are part of the workspace that this program was built in.
    let generated = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../generated");
    match carvallo_compiler::files::regenerate(&generated, check) {
        Ok(done) => {
            println!("{done}");
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
