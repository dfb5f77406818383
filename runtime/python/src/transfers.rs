//! Pictures of transfer functions of one design.

use carvallo_control::Ports;
use carvallo_design::Failure;
use carvallo_plot::analysis::transfer::{Frequencies, Transfers};
use carvallo_plot::picture::{draw_bode, draw_nyquist};
use pyo3::prelude::*;

use crate::control::space;
use crate::designs::Designs;
use crate::loaded::raise;
use crate::one::About;

/// Between what, at which speed, and over which frequencies.
#[derive(FromPyObject)]
pub struct Asked {
    /// In m/s.
    #[pyo3(item)]
    speed: f64,
    /// By their names; without names all of them.
    #[pyo3(item)]
    inputs: Option<Vec<String>>,
    /// By their names; without names the coordinates.
    #[pyo3(item)]
    outputs: Option<Vec<String>>,
    /// In rad/s, from one to another; without them as far as there is something to see.
    #[pyo3(item)]
    omega: Option<(f64, f64)>,
}

impl Asked {
    fn frequencies(&self) -> Result<Option<Frequencies>, Failure> {
        match self.omega {
            None => Ok(None),
            Some((low, high)) if 0.0 < low && low < high && high.is_finite() => {
                Ok(Some(Frequencies::Range([low, high])))
            }
            Some((low, high)) => Err(Failure::usage(format!(
                "`omega` is from {low} to {high} rad/s; it must be from less to more, and above 0"
            ))),
        }
    }
}

#[pymethods]
impl Designs {
    /// The frequency responses of one design at a speed, as SVG: `bode` or else `nyquist`.
    fn transfer_svg(&self, py: Python<'_>, about: About, asked: Asked, of: &str) -> PyResult<String> {
        let described = self.described(py, about)?;
        let draw = || {
            let design = described.build()?;
            let Asked { speed, inputs, outputs, .. } = &asked;
            let space = space(&design, *speed, inputs.as_deref(), outputs.as_deref(), Ports::coordinates)?;
            let transfers = Transfers::new(&design, &space, asked.frequencies()?.as_ref())?;
            Ok(if of == "bode" { draw_bode(&transfers) } else { draw_nyquist(&transfers) }.svg())
        };
        py.detach(draw).map_err(raise)
    }
}
