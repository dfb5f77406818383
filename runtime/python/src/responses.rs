//! Responses of one design in time.

use carvallo_control::{Ports, StateSpace};
use carvallo_design::{Design, Failure};
use carvallo_plot::analysis::excitation::Excitation;
use carvallo_plot::analysis::response::Responses;
use carvallo_plot::picture::draw_response;
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::prelude::*;

use crate::designs::Designs;
use crate::loaded::raise;
use crate::one::About;
use crate::ports;
use crate::words::in_python;

/// What is asked of a response.
#[derive(FromPyObject)]
pub struct Asked {
    #[pyo3(item)]
    ports: ports::Asked,
    /// `step`, `impulse` or `initial`.
    #[pyo3(item)]
    kind: String,
    /// The size of a step or of an impulse, or `phi_rate=0.5` and so on.
    #[pyo3(item)]
    given: Vec<String>,
    /// In s, from 0.
    #[pyo3(item)]
    times: Vec<f64>,
}

/// How many rows a picture is drawn from, but one.
const DRAWN: u32 = 800;

impl Asked {
    /// The design in the units that are asked for, and what it responds to in the same.
    fn space(&self, design: &Design) -> Result<(StateSpace, Excitation), Failure> {
        let ports::Asked { speed, names } = &self.ports;
        let units = names.units()?;
        let shown = |declared: &str| units.of(declared);
        let space = names.space(design, *speed, Ports::coordinates)?;
        let excitation = match (self.kind.as_str(), &self.given[..]) {
            ("step", [size]) => Excitation::step(size, &space),
            ("impulse", [size]) => Excitation::impulse(size, &space),
            (_, given) => Excitation::initial(given, design, &space),
        }?;
        Ok((space.in_units(&shown), excitation.in_units(&space, &shown)))
    }
}

/// A response as arrays.
#[derive(IntoPyObject)]
pub struct Told<'py> {
    /// Names and units of the outputs.
    outputs: Vec<(String, String)>,
    t: Bound<'py, PyArray1<f64>>,
    /// By time and output.
    values: Bound<'py, PyArray2<f64>>,
    end: Option<String>,
    title: String,
}

#[pymethods]
impl Designs {
    /// The response of one design at a speed.
    fn respond<'py>(&self, py: Python<'py>, about: About, asked: Asked) -> PyResult<Told<'py>> {
        let described = self.described(py, about)?;
        let find = || {
            let design = described.build()?;
            let (space, excitation) = asked.space(&design)?;
            let found = Responses::new(&design, &space, excitation, &asked.times)?;
            let outputs = space.outputs.iter().map(|signal| (signal.name.clone(), signal.unit.clone()));
            let end = found.end.as_deref().map(in_python);
            let title = found.title();
            Ok((outputs.collect::<Vec<_>>(), found.response, end, title))
        };
        let (outputs, response, end, title) = py.detach(find).map_err(raise)?;
        // Adding zero turns -0 into 0.
        let values: Vec<f64> = response.outputs.iter().flatten().map(|value| value + 0.0).collect();
        let shape = [response.times.len(), outputs.len()];
        let values = PyArray1::from_vec(py, values).reshape(shape)?;
        Ok(Told { outputs, t: PyArray1::from_vec(py, response.times), values, end, title })
    }

    /// The picture of a response, as SVG.
    fn response_svg(&self, py: Python<'_>, about: About, asked: Asked) -> PyResult<String> {
        let described = self.described(py, about)?;
        let draw = || {
            let design = described.build()?;
            let (space, excitation) = asked.space(&design)?;
            let told = Responses::new(&design, &space, excitation.clone(), &asked.times)?;
            let end = told.response.times.last().copied().unwrap_or(0.0);
            let fine: Vec<f64> = (0..=DRAWN).map(|row| end * f64::from(row) / f64::from(DRAWN)).collect();
            Ok(draw_response(&Responses::new(&design, &space, excitation, &fine)?).svg())
        };
        py.detach(draw).map_err(raise)
    }
}
