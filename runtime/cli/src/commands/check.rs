//! `carvallo check`: whether somebody's numbers are right, and what slip makes them if not.

use std::io::Write;
use std::process::ExitCode;

use carvallo_check::{Comparison, Report, read};
use carvallo_design::input::Request;
use carvallo_design::number::shortest;
use carvallo_design::{Failure, Place};
use clap::{Args, ValueEnum};

use crate::options::{Setting, UnitOptions};
use crate::terminal::{WARNING, note, print, write};

const HELP: &str = "\
FILE, in TOML or JSON, has any of these, from your program, a paper or a thesis:
  M, C1, K0, K2, …       matrices, as a list of rows, or as MATLAB and Python print them
  A and speed            a state matrix, in any of the usual orders of states
  eigenvalues and speed  a list such as [-14.1, \"-0.78+4.46i\"], or several: { \"4\" = […], \"5\" = […] }
  critical_speeds        such as { weave = 4.292, capsize = 6.024 }, in m/s
  accelerations          at a speed, a state and forces
and bicycle, or model and parameters, if they are not of the benchmark bicycle; and feedback, if they are of a closed loop.
They are in SI units, whatever the report is in (--units). Numbers agree if they do to the digits that
are given: 2.32 stands for all from 2.315 to 2.325, and \"2.32 +/- 0.02\" says otherwise.

Where they do not agree, everything is tried that could make them: all single slips of the formulas (signs, operators,
exponents, names, functions, numbers, terms and factors lost), conventions (axes, signs and order of coordinates, degrees, g
inside K0, half the trail, …), other values of a parameter, and a convention together with a slip or another of these. What
reproduces every number is told. The form of files and of JSON is in docs/check.md, beside the source of this program.

Examples:
  carvallo check mine.toml                      Your matrices of the benchmark bicycle
  carvallo check mine.json --bicycle browser    … of another one that ships, or of a file
  carvallo check speeds.toml --model Motorcycle … of another model
  carvallo check mine.toml --feedback 'Tdelta = -10*phi_rate'
                                                … of a closed loop
  carvallo analyze --format json | carvallo check -
                                                What this program says itself, which agrees

Exit codes: 0 all numbers agree; 1 some do not, or a file cannot be read; 2 wrong usage or input.";

/// Whether your numbers are right, and which slip makes them if not
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    /// Your numbers, in TOML or JSON; - reads stdin
    #[arg(value_name = "FILE")]
    file: String,
    /// What they are of: a shipped bicycle or parameter set, or a file [default: what FILE says, or the benchmark]
    #[arg(long, visible_alias = "design", value_name = "DESIGN|FILE")]
    bicycle: Option<String>,
    #[arg(long, value_name = "MODEL", help = "A model that `carvallo models` lists [default: the file's, or Whipple]")]
    model: Option<String>,
    /// Replaces a parameter; may be given several times
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<Setting>,
    /// A force that follows from the motion, if the numbers are of a closed loop: 'Tdelta = -10*phi_rate'; may be given several times
    #[arg(long, value_name = "FORCE=LAW", allow_hyphen_values = true)]
    feedback: Vec<String>,
    #[command(flatten)]
    units: UnitOptions,
    /// table, json, or csv of the numbers
    #[arg(long, value_enum, default_value = "table", hide_possible_values = true)]
    format: Format,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    Table,
    Json,
    Csv,
}

pub fn run(options: &Options) -> Result<ExitCode, Failure> {
    let units = options.units.units();
    if !units.is_si() && !matches!(options.format, Format::Table) {
        // Numbers stand there with the digits that they were given with.
        let place = Place::Option("--units".to_owned());
        return Err(Failure::at(place, "JSON and CSV of this command are in units of the SI"));
    }
    let file = read::load(&options.file)?;
    let request = Request {
        model: options.model.clone(),
        parameters: options.bicycle.clone(),
        overrides: options.set.iter().map(Setting::replacement).collect(),
        feedback: options.feedback.iter().map(|law| (format!("--feedback '{law}'"), law.clone())).collect(),
        ..Request::default()
    };
    let design = file.design(&request)?;
    design.notes.iter().for_each(|text| note(WARNING, "note", text));
    let given = file.given(&design)?;
    let report = carvallo_check::check_in(&given, &design, units).map_err(Failure::usage)?;
    match options.format {
        Format::Table => print(&report.to_string())?,
        Format::Json => write(|output| output.write_all(report.json().as_bytes()))?,
        Format::Csv => write(|output| write_csv(&report, output))?,
    }
    Ok(ExitCode::from(u8::from(!report.agrees)))
}

/// The numbers, a line for each.
fn write_csv(report: &Report, output: &mut dyn Write) -> std::io::Result<()> {
    let mut csv = csv::Writer::from_writer(output);
    csv.write_record(["number", "unit", "yours", "ours", "digits", "agrees"])?;
    for Comparison { name, unit, yours, ours, digits, agrees, cut_off: _ } in &report.numbers {
        let ours = ours.map(shortest).unwrap_or_default();
        csv.write_record([
            name.as_str(),
            unit.as_str(),
            yours.as_str(),
            ours.as_str(),
            &digits.to_string(),
            &agrees.to_string(),
        ])?;
    }
    csv.flush()
}
