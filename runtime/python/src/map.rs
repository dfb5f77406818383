//! Maps of the stable range over two parameters.

use carvallo_design::units::Units;
use carvallo_design::{Equations, Failure};
use carvallo_plot::picture::{MOST_CELLS, MapAxis, MapCell, draw_map};
use pyo3::prelude::*;

use crate::columns::Held;
use crate::designs::Designs;
use crate::loaded::raise;
use crate::parts::{Threads, in_parts, threads};

/// Designs in a part, where one takes some microseconds.
const PART: usize = 512;

/// A parameter that varies: its place, its values, and that of the design that was varied, if there is one.
type Varied = (usize, Vec<f64>, Option<f64>);

#[pymethods]
impl Designs {
    /// Where the stable range of designs is, of which the first axis varies one parameter and the second another, as SVG.
    fn map_svg(&self, py: Python<'_>, name: &str, varied: [Varied; 2], asked: Option<Threads>) -> PyResult<String> {
        let [rows, columns] = varied.each_ref().map(|(_, values, _)| values.len());
        if rows * columns > MOST_CELLS {
            return Err(raise(Failure::usage(format!("a map shows at most {MOST_CELLS} designs"))));
        }
        let held = Held::new(py, &self.columns)?;
        let values = held.values()?;
        let work = |range: std::ops::Range<usize>| {
            let mut row = Vec::new();
            let mut cell = |index: usize| {
                let mut found = MapCell::Unstable;
                let look = &mut |equations: &dyn Equations, gravity: f64| {
                    let stability = equations.stability(gravity).map_err(|error| error.to_string())?;
                    found = stability.stable_ranges.first().map_or(MapCell::Unstable, |range| MapCell::Stable(*range));
                    Ok(())
                };
                match self.visit(&values, index, &mut row, look) {
                    Ok(()) => found,
                    Err(_) => MapCell::Error,
                }
            };
            // The cells of a column of the map stand together.
            Ok(range.map(|place| cell(place % rows * columns + place / rows)).collect::<Vec<_>>())
        };
        let cells = in_parts(py, rows * columns, PART, threads(asked), work)?.concat();
        let units = Units::default();
        let axis = |(position, values, base): &Varied| {
            let info = &self.model.info.parameters[*position];
            MapAxis::new(info, values, *base, &units.or(info.unit, (info.unit == "rad").then_some("deg")))
        };
        let [upward, across] = varied.each_ref().map(axis);
        let model = if self.model.is_whipple() { String::new() } else { format!("{} ", self.model.info.name) };
        Ok(draw_map(&format!("{model}{name}"), &[across, upward], &cells, &units.of("m/s")).svg())
    }
}
