//! `carvallo bicycles` and `carvallo models`: what ships.

use carvallo_design::input::{self, Request};
use carvallo_design::{Failure, MODELS};
use carvallo_models::BICYCLES;
use carvallo_plot::analysis::Analysis;

use crate::output;
use crate::terminal::print;

pub fn bicycles() -> Result<(), Failure> {
    let analyses = BICYCLES.iter().map(|bicycle| {
        let request = Request { parameters: Some(bicycle.name.to_owned()), ..Request::default() };
        input::load(&request).and_then(Analysis::new)
    });
    print(&output::render_bicycles(&analyses.collect::<Result<Vec<_>, _>>()?))
}

pub fn models() -> Result<(), Failure> {
    print(&output::render_models(MODELS))
}
