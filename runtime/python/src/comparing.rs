//! Several designs, and what makes them differ; and the best of many.

use carvallo_design::units::Units;
use carvallo_design::{Design, Failure};
use carvallo_optimize::{Goal, Measure, Problem, Range, Settings, optimize};
use carvallo_plot::analysis::Analysis;
use carvallo_plot::analysis::compare::{Compared, Comparison};
use carvallo_plot::{data, picture};
use pyo3::prelude::*;

use crate::designs::Designs;
use crate::loaded::raise;
use crate::one::{About, Described};
use crate::signals::{Signals, listening};

/// Each design with what is known of it and what it is called.
type Labelled<'py> = Vec<(PyRef<'py, Designs>, About, String)>;

/// What makes designs differ from the first one, as JSON.
#[pyfunction]
pub fn compare(py: Python<'_>, designs: Labelled<'_>) -> PyResult<String> {
    json(|output| {
        data::compare::write_json(&comparison(py, designs)?, &Units::default(), output)
            .map_err(|error| Failure::Run(error.to_string()))
    })
}

/// A picture of them, as SVG: of `eigenvalues`, `side views` or else of contributions; none where there is nothing to draw.
#[pyfunction]
pub fn compare_svg(py: Python<'_>, designs: Labelled<'_>, of: &str) -> PyResult<Option<String>> {
    let comparison = comparison(py, designs).map_err(raise)?;
    let units = Units::default();
    let scene = match of {
        "eigenvalues" => Some(picture::draw_overlay(&comparison, None, None, &units).map_err(raise)?),
        "side views" => picture::draw_side_views(&comparison, &units),
        _ => {
            let last = comparison.differences.len();
            let difference = &comparison.differences[last - 1];
            picture::draw_contributions(&comparison.designs[0], &comparison.designs[last], difference, &units)
        }
    };
    Ok(scene.map(|scene| scene.svg()))
}

fn comparison(py: Python<'_>, designs: Labelled<'_>) -> Result<Comparison, Failure> {
    let one = |(designs, about, label): (PyRef<'_, Designs>, About, String)| {
        let described = designs.described(py, about).map_err(|error| Failure::usage(error.to_string()))?;
        Ok(Compared { label, analysis: Analysis::new(described.build()?)? })
    };
    Comparison::new(designs.into_iter().map(one).collect::<Result<_, Failure>>()?)
}

/// What is searched for, as the command line has it.
#[derive(FromPyObject)]
pub struct Search {
    /// `NAME=LOW:HIGH`.
    #[pyo3(item)]
    vary: Vec<String>,
    #[pyo3(item)]
    measure: String,
    #[pyo3(item)]
    maximize: bool,
    #[pyo3(item)]
    keep: Vec<String>,
    #[pyo3(item)]
    speeds: (f64, f64),
    #[pyo3(item)]
    starts: u32,
    #[pyo3(item)]
    seed: u64,
}

#[pymethods]
impl Designs {
    /// The best design within ranges: the optimum as JSON, and all its parameters.
    fn optimize(&self, py: Python<'_>, about: About, search: Search) -> PyResult<(String, Vec<f64>)> {
        let described: Described = self.described(py, about)?;
        listening(py, |signals| best(&described.build()?, &search, signals))
    }
}

fn best(design: &Design, search: &Search, signals: &Signals) -> Result<(String, Vec<f64>), Failure> {
    let Search { vary, measure, maximize, keep, speeds: (low, high), starts, seed } = search;
    let info = design.info();
    let ranges = Range::parse(vary, info)?;
    let measure = Measure::called(measure, info).map_err(Failure::usage)?;
    let settings = Settings { speeds: [*low, *high], starts: *starts, seed: *seed };
    let problem = Problem::new(design, ranges, Goal { measure, maximize: *maximize }, keep)?.with(settings)?;
    let optimum = optimize(&problem, &|_| signals.look())?;
    let analysis = Analysis::new(optimum.design(&problem)?)?;
    let mut output = Vec::new();
    let written = data::optimum::write_json(&problem, &optimum, &analysis, &Units::default(), &mut output);
    written.map_err(|error| Failure::Run(error.to_string()))?;
    Ok((String::from_utf8_lossy(&output).into_owned(), optimum.values))
}

fn json(write: impl FnOnce(&mut Vec<u8>) -> Result<(), Failure>) -> PyResult<String> {
    let mut output = Vec::new();
    write(&mut output).map_err(raise)?;
    Ok(String::from_utf8_lossy(&output).into_owned())
}
