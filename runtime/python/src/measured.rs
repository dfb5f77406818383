//! Parameters from measurements, and bodies joined to frames.

use carvallo_design::joined;
use carvallo_measure::rider::Rider;
use pyo3::prelude::*;

use crate::designs::Designs;
use crate::loaded::{Loaded, raise};
use crate::one::About;

/// Makes the parameters of a bicycle from a file of measurements.
#[pyfunction]
pub fn measure(path: &str) -> PyResult<Loaded> {
    carvallo_measure::load(path).map(Loaded::from).map_err(raise)
}

/// Makes a rider from a file of measures: a body in TOML.
#[pyfunction]
pub fn rider(path: &str) -> PyResult<String> {
    Rider::load(path).map(|rider| rider.to_toml(&carvallo_design::DisplayUnit::declared)).map_err(raise)
}

/// A file to start from: of what is measured of a `rider`, or else of a bicycle.
#[pyfunction]
pub fn example(of: &str) -> &'static str {
    if of == "rider" { carvallo_measure::rider::EXAMPLE } else { carvallo_measure::EXAMPLE }
}

#[pymethods]
impl Designs {
    /// The one design with bodies joined to it: files, or what is in them in one line.
    fn add(&self, py: Python<'_>, about: About, bodies: Vec<String>) -> PyResult<Loaded> {
        let design = self.described(py, about)?.build().map_err(raise)?;
        joined::add(design, &bodies).map(Loaded::from).map_err(raise)
    }
}
