//! The command line: what can be asked for, and its help. What a subcommand does, with its options and its help, is
//! in a file here; the two that list what ships are both in `lists`, and what `sweep` does is in the folder of its name.

mod analyze;
mod check;
mod compare;
mod controllability;
mod convert;
mod demo;
mod equations;
mod groups;
mod hints;
mod lists;
mod lqr;
mod measure;
mod optimize;
mod respond;
mod rider;
mod sensitivity;
mod show;
mod statespace;
mod transfer;
mod turns;

use std::error::Error as _;
use std::ffi::OsString;
use std::process::ExitCode;

use carvallo_design::{Failure, Place, Problem};
use clap::builder::{Styles, styling::AnsiColor};
use clap::error::{ContextKind, ContextValue};
use clap::{ArgMatches, CommandFactory as _, FromArgMatches as _, Parser, Subcommand};

use crate::options::tell_unused;
use crate::terminal::{ERROR, note};
use crate::{destination, simulate, sweep};

const EXAMPLES: &str = "\
Examples:
  carvallo                                     A first look at the benchmark bicycle
  carvallo analyze pista --plot pista.svg      A measured bicycle, with its picture
  carvallo analyze --set mB=90 --set 'lam=20 deg'
                                               The benchmark bicycle, changed
  carvallo analyze my-bike.toml --format csv --speeds 0:8:0.05
  carvallo sensitivity pista --plot pista.svg  Which parameters its critical speeds depend on most
  carvallo compare pista browser               What differs, and which parameters make the difference
  carvallo show benchmark > my-bike.toml       A file to start from: edit it and analyze it
  carvallo measure measured.toml > my-bike.toml
                                               Parameters from measurements, with deviations
  carvallo show browser --plot browser.svg     Parameters, and a side view to scale
  carvallo convert pista --to moore            The same in the names and axes of others, and from there
  carvallo sweep --vary w=0.9:1.2:0.01 --vary 'lam=10 deg:30 deg:1 deg' --map map.svg --output designs.csv
                                               Many designs, with a map of their stability
  carvallo optimize --vary 'lam=10 deg:30 deg' --vary c=0.02:0.12 --minimize weave-speed
                                               The best head angle and trail
  carvallo simulate --speed 4.6 --initial phi_rate=0.5 --duration 10
                                               The motion of the benchmark bicycle after a push
  carvallo bicycles --format latex             A table for a paper, as most commands give one
  carvallo statespace --speed 5 --inputs Tdelta --output bicycle.mat
                                               A, B, C and D for MATLAB, Python and others
  carvallo lqr --inputs Tdelta --speeds 1:8:0.5 --emit c
                                               Gains that keep it upright, as C for a controller
  carvallo transfer --speed 5 --inputs Tdelta --outputs phi --bode bode.svg
                                               Steer torque to lean: poles, zeros, margins and a Bode plot
  carvallo equations --format latex            The equations of motion, with all definitions
  carvallo check mine.toml                     Whether your matrices are right, and which slip makes them if not
  carvallo analyze --model Pendulum            Another model that ships, with its first parameter set

Results go to the standard output, and everything else that is told to the standard error.
Exit codes: 0 done; 1 there is no answer, or a file cannot be read or written; 2 wrong usage or input.";

const STYLES: Styles = Styles::styled()
    .header(AnsiColor::Green.on_default().bold())
    .usage(AnsiColor::Green.on_default().bold())
    .literal(AnsiColor::Cyan.on_default().bold())
    .placeholder(AnsiColor::Cyan.on_default());

const ABOUT: &str = "Stability of bicycles and of other models: matrices, eigenvalues and critical speeds.";

#[derive(Debug, Parser)]
#[command(name = "carvallo", version, about = ABOUT, styles = STYLES, after_help = EXAMPLES)]
struct Arguments {
    /// Without one: the benchmark bicycle, as a first look.
    #[command(subcommand)]
    command: Option<Command>,
}

/// In the help they stand in the [groups].
#[derive(Debug, Subcommand)]
enum Command {
    Analyze(analyze::Options),
    Check(check::Options),
    Compare(compare::Options),
    Sensitivity(sensitivity::Options),
    /// The shipped bicycles, with their critical speeds
    Bicycles(lists::BicycleOptions),
    /// The shipped models, with their coordinates and parameter sets
    Models(lists::Options),
    Optimize(Box<optimize::Options>),
    Show(show::Options),
    Measure(measure::Options),
    Rider(rider::Options),
    Convert(convert::Options),
    Equations(equations::Options),
    Simulate(Box<simulate::Options>),
    Turns(turns::Options),
    Statespace(statespace::Options),
    Transfer(transfer::Options),
    Respond(respond::Options),
    Controllability(controllability::Options),
    Lqr(lqr::Options),
    Sweep(Box<sweep::Options>),
}

/// Runs the program with the arguments of the process.
pub fn main() -> ExitCode {
    let done = parse(std::env::args_os()).and_then(|(arguments, matches)| {
        let code = run(arguments)?;
        tell_unused(&matches);
        Ok(code)
    });
    match done {
        Ok(code) => code,
        Err(failure) => {
            note(ERROR, "error", &failure.to_string());
            // What was asked for is wrong, or there is no answer.
            ExitCode::from(if matches!(failure, Failure::Input(_)) { 2 } else { 1 })
        }
    }
}

fn run(arguments: Arguments) -> Result<ExitCode, Failure> {
    let done = match arguments.command {
        Some(Command::Check(options)) => return check::run(&options),
        None => demo::run(),
        Some(Command::Analyze(options)) => analyze::run(&options),
        Some(Command::Compare(options)) => compare::run(&options),
        Some(Command::Sensitivity(options)) => sensitivity::run(&options),
        Some(Command::Bicycles(options)) => lists::bicycles(&options),
        Some(Command::Models(options)) => lists::models(&options),
        Some(Command::Optimize(options)) => optimize::run(&options),
        Some(Command::Show(options)) => show::run(&options),
        Some(Command::Measure(options)) => measure::run(&options),
        Some(Command::Rider(options)) => rider::run(&options),
        Some(Command::Convert(options)) => convert::run(&options),
        Some(Command::Equations(options)) => equations::run(&options),
        Some(Command::Simulate(options)) => simulate::run(&options),
        Some(Command::Turns(options)) => turns::run(&options),
        Some(Command::Statespace(options)) => statespace::run(&options),
        Some(Command::Transfer(options)) => transfer::run(&options),
        Some(Command::Respond(options)) => respond::run(&options),
        Some(Command::Controllability(options)) => controllability::run(&options),
        Some(Command::Lqr(options)) => lqr::run(&options),
        Some(Command::Sweep(options)) => sweep::run(&options),
    };
    done.map(|()| ExitCode::SUCCESS)
}

/// Reads the command line. Prints help, and ends the process for it and for wrong usage.
///
/// # Errors
/// What is wrong with the value of an option; and if a file that is to be written cannot be.
fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<(Arguments, ArgMatches), Failure> {
    let mut command = groups::grouped(Arguments::command());
    let matches = command.try_get_matches_from_mut(arguments);
    let parsed = matches.and_then(|matches| Ok((Arguments::from_arg_matches(&matches)?, matches)));
    let (arguments, matches) = parsed.map_err(|error| {
        let told = problem(&error).or_else(|| hints::hint(&error, &command));
        told.unwrap_or_else(|| error.format(&mut command).exit())
    })?;
    hints::check_lists(&matches)?;
    destination::check(&matches)?;
    Ok((arguments, matches))
}

/// A problem that is told as those in files are: by the option as it was given.
fn problem(error: &clap::Error) -> Option<Failure> {
    let text = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text),
        _ => None,
    };
    let problem: &Problem = error.source()?.downcast_ref()?;
    // `--set <NAME=VALUE>`
    let (argument, value) = (text(ContextKind::InvalidArg)?, text(ContextKind::InvalidValue)?);
    let option = argument.split(' ').next()?;
    Some(Failure::at(Place::Option(format!("{option} {value}")), &problem.message))
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory as _;

    #[test]
    fn options_do_not_contradict_each_other() {
        super::Arguments::command().debug_assert();
    }
}
