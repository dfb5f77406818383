//! The extension module of the Python package `carvallo`, and what Python modules of other models are made with.
//!
//! Here are numbers and columns; what users see is in `python/carvallo/`, which is documented there.

mod along;
mod at_speeds;
mod changes;
mod checking;
mod columns;
mod comparing;
mod control;
mod controllability;
mod critical;
mod designs;
mod events;
mod kernel;
mod loaded;
mod map;
mod measured;
mod modes;
mod motion;
mod one;
mod parameterizations;
mod parts;
mod pictures;
mod ports;
mod regulators;
mod responses;
mod sheet;
mod signals;
mod speeds;
mod transfers;
mod turning;
mod words;

use carvallo::Model;
use carvallo_design::{MODELS, Shipped};
use pyo3::prelude::*;

pub use self::kernel::Kernel;

/// Adds a model of one's own to a Python module, under the name of its type.
///
/// # Errors
/// If Python cannot.
pub fn add_model<const N: usize, M: Model<N, Scalar = f64> + 'static>(module: &Bound<'_, PyModule>) -> PyResult<()> {
    // As long as the program: a module is added once.
    module.add(M::INFO.name, Kernel::new(Box::leak(Box::new(Shipped::of::<N, M>()))))
}

#[pymodule]
fn _carvallo(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Kernel>()?;
    module.add_class::<designs::Designs>()?;
    module.add("MODELS", MODELS.iter().map(Kernel::new).collect::<Vec<_>>())?;
    module.add_function(wrap_pyfunction!(loaded::read, module)?)?;
    module.add_function(wrap_pyfunction!(measured::measure, module)?)?;
    module.add_function(wrap_pyfunction!(measured::rider, module)?)?;
    module.add_function(wrap_pyfunction!(measured::example, module)?)?;
    module.add_function(wrap_pyfunction!(checking::check, module)?)?;
    module.add_function(wrap_pyfunction!(comparing::compare, module)?)?;
    module.add_function(wrap_pyfunction!(comparing::compare_svg, module)?)?;
    module.add_function(wrap_pyfunction!(control::frequency_response, module)?)?;
    module.add_function(wrap_pyfunction!(control::minimal, module)?)?;
    module.add("VERDICTS", carvallo_plot::analysis::columns::VERDICTS)?;
    module.add("__version__", env!("CARGO_PKG_VERSION"))
}
