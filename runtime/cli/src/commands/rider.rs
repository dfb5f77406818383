//! `carvallo rider`: a rider from a few measures, as a body that is joined to a bicycle.

use carvallo_design::Failure;
use carvallo_measure::rider::{EXAMPLE, Rider};
use clap::Args;

use crate::options::UnitOptions;
use crate::terminal::print;

const HELP: &str = "\
Makes a rigid rider from a mass, lengths and girths, and from where a bicycle has pedals, saddle and hands: legs and arms are
cylinders, the torso is a box and the head a sphere, with shares of the mass by Dempster, as in Moore, Hubbard, Kooijman &
Schwab (2009). What is printed is a body for --add.

FILE is TOML, JSON or lines of `name = value`; - reads stdin. All names are in docs/bodies.md, beside the source of this program.

Examples:
  carvallo rider --example > me.toml            A rider of 72 kg on a Batavus Browser: edit it, and
  carvallo rider me.toml > rider.toml           make a body of it
  carvallo analyze browser --add rider.toml     that rides any bicycle of these dimensions

Exit codes: 0 done; 1 a file cannot be read; 2 wrong usage or input.";

/// A rider from a few measures, as a body for --add
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    /// What was measured; - reads stdin
    #[arg(required_unless_present = "example")]
    file: Option<String>,
    /// Prints a file of measures to start from
    #[arg(long, conflicts_with = "file")]
    example: bool,
    #[command(flatten)]
    units: UnitOptions,
}

pub fn run(options: &Options) -> Result<(), Failure> {
    match &options.file {
        None => print(EXAMPLE),
        Some(file) => {
            let units = options.units.shown();
            print(&Rider::load(file)?.to_toml(&units))
        }
    }
}
