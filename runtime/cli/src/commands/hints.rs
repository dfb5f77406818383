//! What was probably meant by an option or a subcommand that there is not: an option of other subcommands.

use carvallo_design::{Failure, Place};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{ArgMatches, Command};

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
                "--format" if error.get(ContextKind::Usage)?.to_string().contains("carvallo sweep") => {
                    "the format is that of --output, .csv or .parquet".to_owned()
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

/// That lists of names end with a name: behind a comma and a space stands another argument.
///
/// # Errors
/// The first that does not.
pub fn check_lists(matches: &ArgMatches) -> Result<(), Failure> {
    let Some((_, matches)) = matches.subcommand() else { return Ok(()) };
    for id in ["inputs", "outputs"] {
        let names = matches.try_get_many::<String>(id).ok().flatten();
        let names: Vec<&str> = names.into_iter().flatten().map(String::as_str).collect();
        if let [.., _, ""] = names[..] {
            let place = Place::Option(format!("--{id} {}", names.join(",")));
            return Err(Failure::at(place, "a list ends with a comma: lists have commas without spaces"));
        }
    }
    Ok(())
}
