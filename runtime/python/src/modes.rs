//! The eigenvalues of one design with the names of their modes.

use carvallo::Complex;
use carvallo_plot::analysis::{Analysis, Rows};
use numpy::{PyArray1, PyArrayMethods as _};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::designs::{Array, Designs};
use crate::loaded::raise;
use crate::one::About;
use crate::speeds::Speeds;

#[pymethods]
impl Designs {
    /// The eigenvalues at speeds in the order of their modes, and what each is called.
    fn modes<'py>(
        &self,
        py: Python<'py>,
        about: About,
        v: Speeds,
    ) -> PyResult<(Array<'py, Complex<f64>>, Vec<String>)> {
        let described = self.described(py, about)?;
        let found = py.detach(|| {
            let analysis = Analysis::new(described.build()?)?;
            let rows = analysis.rows(&v.values)?;
            let repeated = if matches!(rows, Rows::Sorted(_)) { v.values.len() } else { 1 };
            let values = rows.values().into_iter().flat_map(|(_, values)| values.to_vec());
            Ok(values.collect::<Vec<_>>().repeat(repeated))
        });
        let found = found.map_err(raise)?;
        let states = self.model.eigenvalues();
        if found.len() != states * v.values.len() {
            return Err(PyValueError::new_err("at rest there are no equations of motion"));
        }
        let shape: Vec<usize> = v.shape.into_iter().chain([states]).collect();
        let values = PyArray1::from_vec(py, found.iter().map(|mode| mode.value).collect()).reshape(shape)?;
        Ok((values, found.iter().map(|mode| mode.mode.to_string()).collect()))
    }
}
