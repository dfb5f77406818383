//! `carvallo measure`: the parameters of a bicycle from what was measured of it.

use carvallo_design::Failure;
use carvallo_plot::data;
use clap::{Args, ValueEnum};

use crate::options::UnitOptions;
use crate::output;
use crate::terminal::{WARNING, note, print, write};

const HELP: &str = "\
Makes the parameters of a bicycle from wheel revolutions, lengths, hanging angles, masses and periods of compound and
torsional pendulums, as BicycleParameters does, each with its standard deviation. These propagate exactly to first order: to
standard deviations and correlations of all parameters, which `carvallo sensitivity` makes those of matrices and critical
speeds.

FILE is a NAMEMeasured.txt of BicycleParameters, or TOML or JSON with the same names; - reads stdin. What is printed is a file
of parameters, for `carvallo analyze` and all others. In the place of a period may stand a file with the recorded oscillation:
TtB1 = 'frame.csv', with a time and a value in each line. All names are in docs/measure.md, beside the source of this program.

Examples:
  carvallo measure --example > mine.toml        What was measured of a Batavus Browser: edit it, and
  carvallo measure mine.toml > bicycle.toml     make a bicycle of it
  carvallo sensitivity bicycle.toml             How well its critical speeds are known
  carvallo sweep bicycle.toml --random measured --samples 1000
                                                The same by drawing bicycles that could be it
  carvallo measure BrowserMeasured.txt --format json

Exit codes: 0 done; 1 a file cannot be read; 2 wrong usage or input.";

/// A bicycle's parameters from measurements, with deviations and correlations
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    /// What was measured; - reads stdin
    #[arg(required_unless_present = "example")]
    file: Option<String>,
    /// toml or json
    #[arg(long, value_enum, default_value = "toml", hide_possible_values = true)]
    format: Format,
    #[command(flatten)]
    units: UnitOptions,
    /// Prints a file of measurements to start from
    #[arg(long, conflicts_with_all = ["file", "format"])]
    example: bool,
}

/// A form of files of parameters.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    Toml,
    Json,
}

pub fn run(options: &Options) -> Result<(), Failure> {
    let Some(file) = &options.file else { return print(carvallo_measure::EXAMPLE) };
    let units = options.units.units();
    let design = carvallo_measure::load(file)?;
    for text in &design.notes {
        note(WARNING, "note", text);
    }
    for text in &design.warnings {
        note(WARNING, "warning", &format!("{}: {text}", design.name));
    }
    match options.format {
        Format::Toml => print(&output::render_parameters(&design, &units)),
        Format::Json => write(|output| data::parameters::write_json(&design, &options.units.shown(), output)),
    }
}
