//! `carvallo equations`: the formulas of a model.

use carvallo::Notation;
use carvallo_design::{Failure, Shipped, WHIPPLE};
use clap::{Args, ValueEnum};

use crate::terminal::print;

const HELP: &str = "\
The formulas are those of the declaration, or what was derived from its mechanism: definitions, each in those before it,
and behind them the entries of the matrices that are not zero, with their units in kg, m and s. M_12 stands in the first
row and the second column of M.

LaTeX needs the package amsmath. What is printed can be included in a document; that in Typst is one by itself.

Examples:
  carvallo equations                                     The benchmark bicycle, as Meijaard et al. (2007) have it
  carvallo equations RollingDisc --format latex          For a paper
  carvallo equations WhippleMechanism --format typst > bicycle.typ
                                                         What is derived from bodies, joints and wheels

Exit codes: 0 done; 2 wrong usage or input.";

/// The equations of motion of a model as text, LaTeX or Typst
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub struct Options {
    #[arg(value_name = "MODEL", help = "A model that `carvallo models` lists [default: Whipple]")]
    model: Option<String>,
    /// text, latex or typst
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    format: Format,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    Text,
    Latex,
    Typst,
}

pub fn run(options: &Options) -> Result<(), Failure> {
    let model = match &options.model {
        Some(name) => Shipped::called(name).map_err(Failure::usage)?,
        None => &WHIPPLE,
    };
    let notation = match options.format {
        Format::Text => Notation::Text,
        Format::Latex => Notation::Latex,
        Format::Typst => Notation::Typst,
    };
    print(&model.info.equations(notation))
}
