//! `carvallo convert`: the parameters of a bicycle in the names and axes of others.

use carvallo_design::conventions::{Convention, Form, convert, left_out, write};
use carvallo_design::{Failure, Place};
use clap::{Args, ValueEnum};

use crate::destination::Destination;
use crate::endings::Endings;
use crate::options::{DesignOptions, UnitOptions};
use crate::output;
use crate::terminal::{WARNING, deliver, note};

const HELP: &str = "\
Parameterizations:
  paper       The 26 parameters of Meijaard, Papadopoulos, Ruina & Schwab (2007)
  moore       d1, l1, ic11, … of Moore's thesis (2012), HumanControl and DynamicistToolKit
  pydy        WRrad, framecg1, … of PyDy's bicycle and of the tests of SymPy
  principal   Principal radii of gyration and angles, as Moore & Hubbard (2019)
  gyrostats   Each wheel with its frame as one body (Peterson): rr, lr, IDxx, …
  libbicycle  The same as Peterson's newer library has them: rear_Ixx, …, front_Ixx, …, ls
  jbike6      The seven bodies of JBike6, y upward; as a script of MATLAB, its own form
  geometry    Head angle, fork offset, wheel base and wheel sizes, as manufacturers print them

A file in any of them is recognised by its names, by this and by all other commands, or by parameterization = \"…\" in it.
Numbers are computed to the last digits of a double; standard deviations and correlations are carried to first order.

Forms: toml, json, yaml, csv, python, matlab, or text as BicycleParameters has it. All are read again.

Examples:
  carvallo convert pista --to moore
  carvallo convert benchmark --to jbike6 --output JBini_Benchmark.m
  carvallo convert mine.m --to paper --format json
  carvallo convert browser --to geometry --units in,deg

Exit codes: 0 done; 1 a file cannot be read or written; 2 wrong usage or input, or the bicycle cannot be expressed so.";

/// The parameters in the names and axes of others
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    #[command(flatten)]
    design: DesignOptions,
    /// The parameterization: paper, moore, pydy, principal, gyrostats, libbicycle, jbike6 or geometry
    #[arg(long, value_name = "NAME")]
    to: Option<String>,
    /// toml, json, yaml, csv, python, matlab or text [default: by the ending of --output, or toml; matlab for jbike6]
    #[arg(long, value_enum, hide_possible_values = true)]
    format: Option<Format>,
    #[command(flatten)]
    units: UnitOptions,
    /// Writes to a file: .toml, .json, .yaml, .csv, .py, .m or .txt [default: stdout]
    #[arg(long, value_name = "FILE")]
    output: Option<Destination>,
}

/// The form of the file.
#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Format {
    Toml,
    Json,
    #[value(alias = "yml")]
    Yaml,
    Csv,
    #[value(alias = "py")]
    Python,
    #[value(alias = "m")]
    Matlab,
    #[value(alias = "txt")]
    Text,
}

const ENDINGS: Endings<Format> = Endings(&[
    ("toml", Format::Toml),
    ("json", Format::Json),
    ("yaml", Format::Yaml),
    ("yml", Format::Yaml),
    ("csv", Format::Csv),
    ("py", Format::Python),
    ("m", Format::Matlab),
    ("txt", Format::Text),
]);

impl Format {
    fn form(self) -> Form {
        match self {
            Self::Toml => Form::Toml,
            Self::Json => Form::Json,
            Self::Yaml => Form::Yaml,
            Self::Csv => Form::Csv,
            Self::Python => Form::Python,
            Self::Matlab => Form::Matlab,
            Self::Text => Form::Text,
        }
    }
}

pub fn run(options: &Options) -> Result<(), Failure> {
    let Some(to) = &options.to else {
        let names: Vec<&str> = Convention::all().map(|convention| convention.name).collect();
        return Err(Failure::usage(format!("expected --to NAME, with one of {}", names.join(", "))));
    };
    let place = || Place::Option(format!("--to {to}"));
    let convention = Convention::called(to).map_err(|failure| Failure::at(place(), failure.to_string()))?;
    let units = options.units.units();
    let usual = if convention.name == "jbike6" { Format::Matlab } else { Format::Toml };
    let format = match &options.output {
        Some(output) => {
            let fail = |message| Failure::at(output.place(), message);
            if options.design.request().reads(output) {
                return Err(fail("the parameters are read from this file".to_owned()));
            }
            let format = ENDINGS.kind(output, options.format).map_err(fail)?;
            output.replaces_parameters()?;
            format
        }
        None => options.format.unwrap_or(usual),
    };
    let form = format.form();
    if !form.has_units() && !units.is_si() {
        let place = Place::Option("--units".to_owned());
        return Err(Failure::at(place, "this form has no place for units; toml, json, yaml and csv have"));
    }
    let design = options.design.load()?;
    let converted = convert(&design, convention)?;
    for text in left_out(&design, &converted, form) {
        note(WARNING, "note", &format!("{}: {text}", converted.name));
    }
    let text = write(&converted, form, &units, &output::faint);
    deliver(options.output.as_deref(), |output| output.write_all(text.as_bytes()))
}
