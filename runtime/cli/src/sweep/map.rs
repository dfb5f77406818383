//! The stable range over two parameters that vary.

use carvallo::{ParameterInfo, StableRange};

use super::evaluate::Results;
use super::plan::{Plan, Source};
use crate::input::Design;
use crate::plot::{self, MapAxis, MapCell, Scene};

/// More designs than this show nothing that fewer would not.
pub const MAX_CELLS: usize = 1_000_000;

/// What a map shows of each design, in their order.
pub struct Map {
    cells: Vec<MapCell>,
    /// Where the first stable range stands among the columns of the results.
    range: usize,
}

impl Map {
    pub fn new(plan: &Plan) -> Self {
        Self { cells: Vec::new(), range: plan.task.layout.first_range().unwrap_or_default() }
    }

    /// Adds the next designs.
    pub fn add(&mut self, results: &Results) {
        let [from, to] = [self.range, self.range + 1].map(|index| &results.columns[index]);
        let cell = |(row, error): (usize, &Option<String>)| match (error, from.number(row)) {
            (Some(_), _) => MapCell::Error,
            (None, None) => MapCell::Unstable,
            (None, Some(from)) => MapCell::Stable(StableRange { from, to: to.number(row) }),
        };
        self.cells.extend(results.errors.iter().enumerate().map(cell));
    }

    /// The map, with the design that was varied where it belongs.
    pub fn draw(&self, design: &Design, plan: &Plan) -> Scene {
        let axes = match &plan.source {
            Source::Generated(generator) => generator.vary.as_slice(),
            Source::File(_) => &[],
        };
        let values = design.values();
        let axes: Vec<MapAxis> = axes
            .iter()
            .map(|axis| {
                let info = &design.info().parameters[axis.position];
                MapAxis::new(label(info), info.unit, &axis.values, values[axis.position])
            })
            .collect();
        plot::map(&design.title(), &axes, &self.cells)
    }
}

/// What the parameter is, as far as its documentation says so in a few words, and its symbol.
fn label(info: &ParameterInfo) -> String {
    let docs = info.docs.trim().split([':', '.', ',', ';', '\n']).next().unwrap_or_default();
    let mut chars = docs.chars();
    match chars.next() {
        Some(first) if docs.chars().count() <= 50 => {
            format!("{}{} {}", first.to_lowercase(), chars.as_str(), info.symbol)
        }
        _ => info.symbol.to_owned(),
    }
}
