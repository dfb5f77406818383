//! What was probably meant by an option or a subcommand that there is not: an option of other subcommands.

use carvallo_design::{Failure, Place};
use clap::Command;
use clap::error::{ContextKind, ContextValue, ErrorKind};

/// Options of more commands than this tell nothing.
const MOST: usize = 6;

/// What an error means that is known better here than where the command line is read.
pub fn hint(error: &clap::Error, command: &Command) -> Option<Failure> {
    let text = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.as_str()),
        _ => None,
    };
    match error.kind() {
        ErrorKind::UnknownArgument => {
            let option = text(ContextKind::InvalidArg)?;
            let message = match option {
                // What stands behind the design that was given.
                design if !design.starts_with('-') => {
                    let usage = error.get(ContextKind::Usage)?.to_string();
                    return usage.contains("[DESIGN|FILE]").then(|| {
                        let one = "this command takes one design; `carvallo compare` takes several";
                        Failure::usage(format!("unexpected `{design}`: {one}, and lists have commas without spaces"))
                    });
                }
                "--format" => {
                    "this command writes TOML; `carvallo convert --to paper --format json` writes designs in other forms".to_owned()
                }
                "--output" => {
                    "the result of this command goes to the standard output: write `> FILE` behind it".to_owned()
                }
                _ => format!(
                    "this command has no such option; it is one of {}",
                    with_option(command, option.strip_prefix("--")?)?
                ),
            };
            Some(Failure::at(Place::Option(option.to_owned()), message))
        }
        ErrorKind::InvalidSubcommand => {
            let word = text(ContextKind::InvalidSubcommand)?;
            let others = with_option(command, word)?;
            Some(Failure::usage(format!("there is no command `{word}`; --{word} is an option of {others}")))
        }
        _ => None,
    }
}

/// The subcommands that have an option, in words; `None` if there are none.
fn with_option(command: &Command, long: &str) -> Option<String> {
    let has = |own: &&Command| own.get_arguments().any(|argument| argument.get_long() == Some(long));
    let names: Vec<String> = command.get_subcommands().filter(has).map(|own| format!("`{}`", own.get_name())).collect();
    match &names[..] {
        [] => None,
        [name] => Some(name.clone()),
        // Nearly all have it.
        names if names.len() > MOST => None,
        [others @ .., last] => Some(format!("{} and {last}", others.join(", "))),
    }
}
