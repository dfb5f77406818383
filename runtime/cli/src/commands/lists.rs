//! `carvallo bicycles` and `carvallo models`: what ships.

use carvallo_design::input::{self, Request};
use carvallo_design::{Failure, MODELS};
use carvallo_models::BICYCLES;
use carvallo_plot::analysis::Analysis;
use clap::Args;

use crate::options::{ListFormat, UnitOptions};
use crate::output::{self, documents};
use crate::terminal::print;

/// How a list is printed.
#[derive(Args, Debug)]
pub struct Options {
    /// table, markdown or latex
    #[arg(long, value_enum, default_value = "table", hide_possible_values = true)]
    format: ListFormat,
}

/// How bicycles are printed.
#[derive(Args, Debug)]
pub struct BicycleOptions {
    #[command(flatten)]
    list: Options,
    #[command(flatten)]
    units: UnitOptions,
}

pub fn bicycles(options: &BicycleOptions) -> Result<(), Failure> {
    let unit = options.units.of_speeds();
    let analyses = BICYCLES.iter().map(|bicycle| {
        let request = Request { parameters: Some(bicycle.name.to_owned()), ..Request::default() };
        input::load(&request).and_then(Analysis::new)
    });
    let analyses = analyses.collect::<Result<Vec<_>, _>>()?;
    match options.list.format {
        ListFormat::Table => print(&output::render_bicycles(&analyses, &unit)),
        ListFormat::Document(language) => print(&documents::of_bicycles(&analyses, &unit).write(language)),
    }
}

pub fn models(options: &Options) -> Result<(), Failure> {
    match options.format {
        ListFormat::Table => print(&output::render_models(MODELS)),
        ListFormat::Document(language) => print(&documents::of_models(MODELS).write(language)),
    }
}
