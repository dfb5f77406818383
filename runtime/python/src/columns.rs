//! The parameters of many designs: a column for each parameter, as numpy has it.

use numpy::{PyArray1, PyArrayMethods as _, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// The values of one parameter.
#[derive(Debug)]
pub enum Column {
    /// Of all designs.
    Same(f64),
    /// One for each design.
    Each(Py<PyArray1<f64>>),
}

impl Column {
    /// A number, or an array of one dimension whose numbers lie one behind the other.
    ///
    /// # Errors
    /// If it is neither.
    pub fn of(value: &Bound<'_, PyAny>) -> PyResult<Self> {
        match value.cast::<PyArray1<f64>>() {
            Ok(array) => Ok(Self::Each(array.clone().unbind())),
            Err(_) => Ok(Self::Same(value.extract()?)),
        }
    }

    /// How many designs it is for, unless it is for any number.
    fn count(&self, py: Python<'_>) -> Option<usize> {
        match self {
            Self::Same(_) => None,
            Self::Each(array) => Some(array.bind(py).len().unwrap_or(0)),
        }
    }
}

/// How many designs there are, each column having a value for each.
///
/// # Errors
/// If two columns differ.
pub fn count(py: Python<'_>, columns: &[Column]) -> PyResult<Option<usize>> {
    let mut counts = columns.iter().filter_map(|column| column.count(py));
    let Some(count) = counts.next() else { return Ok(None) };
    match counts.find(|other| *other != count) {
        Some(other) => Err(PyValueError::new_err(format!("there are columns of {count} and of {other} values"))),
        None => Ok(Some(count)),
    }
}

/// The columns while they are looked at.
pub struct Held<'py>(Vec<HeldColumn<'py>>);

enum HeldColumn<'py> {
    Same(f64),
    Each(PyReadonlyArray1<'py, f64>),
}

impl<'py> Held<'py> {
    /// # Errors
    /// If the numbers of a column do not lie one behind the other, or if it is being written.
    pub fn new(py: Python<'py>, columns: &[Column]) -> PyResult<Self> {
        let hold = |column: &Column| match column {
            Column::Same(value) => Ok(HeldColumn::Same(*value)),
            Column::Each(array) => Ok(HeldColumn::Each(array.bind(py).try_readonly()?)),
        };
        Ok(Self(columns.iter().map(hold).collect::<PyResult<_>>()?))
    }

    /// What threads can look at.
    ///
    /// # Errors
    /// If the numbers of a column do not lie one behind the other.
    pub fn values(&self) -> PyResult<Vec<Values<'_>>> {
        self.0.iter().map(HeldColumn::values).collect()
    }
}

impl HeldColumn<'_> {
    fn values(&self) -> PyResult<Values<'_>> {
        Ok(match self {
            Self::Same(value) => Values::Same(*value),
            Self::Each(array) => Values::Each(array.as_slice()?),
        })
    }
}

/// The values of one parameter, without Python.
#[derive(Clone, Copy, Debug)]
pub enum Values<'a> {
    /// Of all designs.
    Same(f64),
    /// One for each design.
    Each(&'a [f64]),
}

impl Values<'_> {
    fn at(&self, index: usize) -> f64 {
        match self {
            Self::Same(value) => *value,
            Self::Each(values) => values[index],
        }
    }
}

/// Writes the parameters of one design into a row that is used again and again.
pub fn gather(columns: &[Values], index: usize, row: &mut Vec<f64>) {
    row.clear();
    row.extend(columns.iter().map(|column| column.at(index)));
}
