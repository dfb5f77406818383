//! The stable range over two parameters that vary.

use carvallo::StableRange;
use carvallo_design::Design;
use carvallo_design::units::Units;
use carvallo_plot::picture::{self, MapAxis, MapCell, Scene};

use super::plan::Plan;
use super::source::Source;
use super::table::Results;

/// What a map shows of each design, in their order.
#[derive(Default)]
pub struct Map {
    cells: Vec<MapCell>,
}

impl Map {
    /// Adds the next designs.
    pub fn add(&mut self, results: &Results) {
        let cell = |(error, stable): (&Option<String>, &Option<StableRange>)| match (error, stable) {
            (Some(_), _) => MapCell::Error,
            (None, None) => MapCell::Unstable,
            (None, Some(range)) => MapCell::Stable(*range),
        };
        self.cells.extend(results.errors.iter().zip(&results.stable).map(cell));
    }

    /// The map, with the design that was varied where it belongs; angles in degrees unless another unit is asked for.
    pub fn draw(&self, design: &Design, plan: &Plan, units: &Units) -> Scene {
        let axes = match &plan.source {
            Source::Generated(generator) => generator.vary.as_slice(),
            Source::File(_) => &[],
        };
        let values = design.values();
        let axes: Vec<MapAxis> = axes
            .iter()
            .enumerate()
            .map(|(column, axis)| {
                let own = axis.parameter.position().map(|at| values[at]);
                let own = own.or_else(|| plan.task.varied.start(column));
                let unit = axis.parameter.info.unit;
                let shown = units.or(unit, (unit == "rad").then_some("deg"));
                MapAxis::new(&axis.parameter.info, &axis.values, own, &shown)
            })
            .collect();
        picture::draw_map(&design.title(), &axes, &self.cells, &units.of("m/s"))
    }
}
