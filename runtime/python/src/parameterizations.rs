//! One design in the names and axes of others.

use carvallo_design::conventions::{Convention, convert};
use pyo3::prelude::*;

use crate::designs::Designs;
use crate::loaded::raise;
use crate::one::About;

#[pymethods]
impl Designs {
    /// The names of the parameters in a parameterization, with their values in SI units.
    fn parameterized(&self, py: Python<'_>, about: About, name: &str) -> PyResult<Vec<(&'static str, f64)>> {
        let convention = Convention::called(name).map_err(raise)?;
        let design = self.described(py, about)?.build().map_err(raise)?;
        let converted = convert(&design, convention).map_err(raise)?;
        Ok(converted.parameters.iter().map(|parameter| (parameter.name.name, parameter.given.value)).collect())
    }
}
