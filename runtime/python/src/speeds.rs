//! Speeds as Python gives them: a number, an array of any shape, or anything that numpy makes one of.

use numpy::{PyArrayDyn, PyArrayMethods as _, PyUntypedArrayMethods as _};
use pyo3::prelude::*;
use pyo3::types::PyFloat;

/// Speeds in m/s, and the shape that they were given in: none for one number.
pub struct Speeds {
    pub values: Vec<f64>,
    pub shape: Vec<usize>,
}

impl<'py> FromPyObject<'_, 'py> for Speeds {
    type Error = PyErr;

    fn extract(value: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(number) = value.cast::<PyFloat>() {
            return Ok(Self { values: vec![number.value()], shape: Vec::new() });
        }
        if let Ok(array) = value.cast::<PyArrayDyn<f64>>() {
            let array = array.try_readonly()?;
            let shape = array.shape().to_vec();
            let values = array.as_slice().map_or_else(|_| array.as_array().iter().copied().collect(), <[f64]>::to_vec);
            return Ok(Self { values, shape });
        }
        let converted = value.py().import("numpy")?.call_method1("asarray", (value, "float64"))?;
        let array = converted.cast::<PyArrayDyn<f64>>()?.try_readonly()?;
        Ok(Self { values: array.as_array().iter().copied().collect(), shape: array.shape().to_vec() })
    }
}
