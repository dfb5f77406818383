//! Linear quadratic regulators of one design.

use carvallo::Complex;
use carvallo_control::{Ports, Schedule, Weights};
use carvallo_design::Failure;
use numpy::{PyArray1, PyArrayMethods as _};
use pyo3::prelude::*;

use crate::designs::{Array, Designs};
use crate::loaded::raise;
use crate::one::About;

/// Regulators along speeds: gains and eigenvalues are arrays that run over the speeds first.
#[derive(IntoPyObject)]
pub struct Told<'py> {
    /// In m/s; none where nothing depends on the speed.
    speeds: Option<Vec<f64>>,
    inputs: Vec<String>,
    states: Vec<String>,
    gains: Array<'py, f64>,
    eigenvalues: Array<'py, Complex<f64>>,
    unstable: Vec<[f64; 2]>,
}

#[pymethods]
impl Designs {
    /// Regulators at speeds in m/s, by the names of inputs, or all of them, and weights as `NAME=VALUE`.
    fn lqr<'py>(
        &self,
        py: Python<'py>,
        about: About,
        speeds: Vec<f64>,
        inputs: Option<Vec<String>>,
        weights: Vec<String>,
    ) -> PyResult<Told<'py>> {
        let described = self.described(py, about)?;
        let find = || {
            let design = described.build()?;
            let ports = Ports::of(&design);
            let inputs = match inputs {
                None => ports.all_inputs(),
                Some(names) => {
                    let found = names.iter().map(|name| ports.input(name)).collect::<Result<_, _>>();
                    found.map_err(Failure::usage)?
                }
            };
            Schedule::new(&design, &speeds, &Weights::read(&weights, &ports, &inputs)?)
        };
        let schedule = py.detach(find).map_err(raise)?;
        let all = &schedule.regulators;
        let space = &all[0].space;
        let [count, inputs, states] = [all.len(), space.inputs.len(), space.states.len()];
        let gains =
            all.iter().flat_map(|own| own.gains.row_iter().flat_map(|row| row.iter().copied().collect::<Vec<_>>()));
        let values = all.iter().flat_map(|own| own.eigenvalues.iter().copied());
        let names = |signals: &[carvallo_control::Signal]| signals.iter().map(|signal| signal.name.clone()).collect();
        Ok(Told {
            speeds: all.iter().map(|own| own.space.speed).collect(),
            inputs: names(&space.inputs),
            states: names(&space.states),
            gains: PyArray1::from_iter(py, gains).reshape([count, inputs, states])?.to_dyn().clone(),
            eigenvalues: PyArray1::from_iter(py, values).reshape([count, states])?.to_dyn().clone(),
            unstable: schedule.unstable,
        })
    }
}
