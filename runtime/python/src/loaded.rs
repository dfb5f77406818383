//! Designs by the names of what ships, by files and by values, as the command line reads them.

use carvallo_design::{Design, Failure, Given, input};
use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::{IntoPyObject, PyErr};

use crate::kernel::Kernel;
use crate::words::in_python;

/// A design that was read, with what there is to say of it.
#[derive(IntoPyObject)]
pub struct Loaded {
    kernel: Kernel,
    name: String,
    kind: Option<String>,
    source: Option<String>,
    /// In the order of the model.
    values: Vec<f64>,
    /// The standard deviations; 0 where there is none.
    deviations: Vec<f64>,
    /// Of pairs of parameters that vary together, by their positions.
    correlations: Vec<(usize, usize, f64)>,
    /// The laws of feedback.
    feedback: Vec<String>,
    notes: Vec<String>,
    warnings: Vec<String>,
}

impl From<Design> for Loaded {
    fn from(design: Design) -> Self {
        let deviation = |given: &Given| given.deviation.as_ref().map_or(0.0, |deviation| deviation.value);
        Self {
            kernel: Kernel::new(design.model),
            values: design.values(),
            deviations: design.parameters.iter().map(deviation).collect(),
            correlations: design.covariance.map_or(Vec::new(), |covariance| covariance.correlations()),
            feedback: design.feedback.iter().map(|law| law.written.clone()).collect(),
            name: design.name,
            kind: design.kind,
            source: design.source,
            notes: design.notes.iter().map(|note| in_python(note)).collect(),
            warnings: design.warnings.iter().map(|warning| in_python(warning)).collect(),
        }
    }
}

/// What is wrong with input is a ValueError, and what cannot be read an OSError; there the message of the command line stands, in the
/// words of Python.
pub fn raise(failure: Failure) -> PyErr {
    match failure {
        Failure::Input(_) => PyValueError::new_err(in_python(&failure.to_string())),
        Failure::Run(message) if message.starts_with("cannot read") => PyOSError::new_err(in_python(&message)),
        Failure::Run(message) => PyValueError::new_err(in_python(&message)),
    }
}

/// Reads a file, which may name its model.
#[pyfunction]
pub fn read(path: String) -> PyResult<Loaded> {
    if !std::path::Path::new(&path).exists() {
        return Err(raise(Failure::usage(format!("there is no file {path}"))));
    }
    let request = input::Request { parameters: Some(path), ..Default::default() };
    input::load(&request).map(Loaded::from).map_err(raise)
}
