//! `carvallo-compiler`: writes the Rust of models ahead of time, or checks it.

use std::path::Path;
use std::process::ExitCode;

use carvallo_compiler::files::{self, Language, MODELS};
use carvallo_compiler::{Kept, with_answers};

const HELP: &str = "\
Compiles models ahead of time: each file with a `carvallo::model! { … }` to a file of Rust,
which needs the crate `carvallo` without its feature `derive`, and no compiler of models;
or to a header and a source of C99, which need nothing but libm.

Usage: carvallo-compiler expand [--check] [--language LANGUAGE] [MODELS [FOLDER]]
       cargo regenerate [--check]

`expand` writes FOLDER/NAME.rs for each MODELS/NAME.rs, and FOLDER/mod.rs with all of them; in C
FOLDER/NAME.h and FOLDER/NAME.c, and carvallo_system.{h,c} and carvallo_trig.{h,c} beside them.
What is public in C begins with NAME. `regenerate` does both in the workspace of Carvallo, from
generated/models/.

Arguments:
  MODELS    A folder with the declarations [default: models]
  FOLDER    Where the files go [default: src/models, or c]

Options:
  --language LANGUAGE   `rust` or `c` [default: rust]
  --check               Write nothing; fail if a file is stale, missing or left over
  --help                Print this

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
    let language = take_language(&mut words);
    let result = match (&words[..], language) {
        _ if words.iter().any(|word| word.starts_with('-')) => None,
        // The sources are part of the workspace that this program was built in.
        (["regenerate"], Some(None)) => {
            let generated = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../generated");
            Some(keeping_answers(|| files::regenerate(&generated, check)))
        }
        (["expand", folders @ ..], Some(language)) if folders.len() <= 2 => {
            let language = language.unwrap_or(Language::Rust);
            let models = folders.first().unwrap_or(&MODELS);
            let written = folders.get(1).copied().unwrap_or(language.folder());
            let work = || files::expand(Path::new(models), Path::new(written), language, check);
            Some(keeping_answers(work))
        }
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

/// The language that is asked for, if one is, which is none of the words then; nothing if it is no language.
fn take_language(words: &mut Vec<&str>) -> Option<Option<Language>> {
    let Some(position) = words.iter().position(|word| word.split('=').next() == Some("--language")) else {
        return Some(None);
    };
    let name = match words[position].split_once('=') {
        Some((_, name)) => name,
        None if position + 1 < words.len() => words.remove(position + 1),
        None => return None,
    };
    words.remove(position);
    Language::from_name(&name.to_lowercase()).map(Some)
}

fn keeping_answers<T>(work: impl FnOnce() -> T) -> T {
    with_answers(Kept::of_this_build(), work)
}
