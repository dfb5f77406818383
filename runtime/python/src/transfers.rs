//! Frequency responses of one design: pictures of them, and singular values.

use carvallo_control::Ports;
use carvallo_design::Failure;
use carvallo_plot::analysis::transfer::{Frequencies, Transfers};
use carvallo_plot::picture::{draw_bode, draw_nyquist, draw_sigma};
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::prelude::*;

use crate::designs::Designs;
use crate::loaded::raise;
use crate::one::About;
use crate::ports;

/// Between what, at which speed, and over which frequencies.
#[derive(FromPyObject)]
pub struct Asked {
    #[pyo3(item)]
    ports: ports::Asked,
    /// In rad/s: a list, or from one to another; without them as far as there is something to see.
    #[pyo3(item)]
    omega: Option<Omega>,
}

/// Frequencies in rad/s.
#[derive(FromPyObject)]
enum Omega {
    Range((f64, f64)),
    List(Vec<f64>),
}

impl Asked {
    fn frequencies(&self) -> Result<Option<Frequencies>, Failure> {
        match &self.omega {
            None => Ok(None),
            Some(Omega::List(list)) => match list.iter().find(|omega| !(omega.is_finite() && **omega > 0.0)) {
                Some(omega) => Err(Failure::usage(format!("`omega` has {omega} rad/s; it must be finite and above 0"))),
                None => Ok(Some(Frequencies::List(list.clone()))),
            },
            Some(Omega::Range((low, high))) if 0.0 < *low && low < high && high.is_finite() => {
                Ok(Some(Frequencies::Range([*low, *high])))
            }
            Some(Omega::Range((low, high))) => Err(Failure::usage(format!(
                "`omega` is from {low} to {high} rad/s; it must be from less to more, and above 0"
            ))),
        }
    }
}

/// Frequencies in rad/s, and singular values by frequency, descending.
type SingularValues<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>);

#[pymethods]
impl Designs {
    /// The frequency responses of one design at a speed, as SVG: `bode`, `nyquist` or else the singular values.
    fn transfer_svg(&self, py: Python<'_>, about: About, asked: Asked, of: &str) -> PyResult<String> {
        let described = self.described(py, about)?;
        let draw = || {
            let design = described.build()?;
            let space = asked.ports.shown(&design, Ports::coordinates)?;
            let transfers = Transfers::new(&design, &space, asked.frequencies()?.as_ref())?;
            let picture = match of {
                "bode" => draw_bode(&transfers),
                "nyquist" => draw_nyquist(&transfers),
                _ => draw_sigma(&transfers),
            };
            Ok(picture.svg())
        };
        py.detach(draw).map_err(raise)
    }

    /// The singular values of all transfer functions of one design at a speed together.
    fn singular_values<'py>(&self, py: Python<'py>, about: About, asked: Asked) -> PyResult<SingularValues<'py>> {
        let described = self.described(py, about)?;
        let find = || {
            let design = described.build()?;
            let space = asked.ports.shown(&design, Ports::coordinates)?;
            let transfers = Transfers::new(&design, &space, asked.frequencies()?.as_ref())?;
            Ok((transfers.singular_values, space.inputs.len().min(space.outputs.len())))
        };
        let (found, count) = py.detach(find).map_err(raise)?;
        let frequencies = found.iter().map(|at| at.frequency).collect();
        let values = found.iter().flat_map(|at| at.values.iter().copied()).collect();
        let values = PyArray1::from_vec(py, values).reshape([found.len(), count])?;
        Ok((PyArray1::from_vec(py, frequencies), values))
    }
}
