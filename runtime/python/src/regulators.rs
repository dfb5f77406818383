//! Linear quadratic regulators of one design.

use carvallo::Complex;
use carvallo_control::{Code, Ports, Schedule, Signal, Weights};
use carvallo_design::units::Units;
use carvallo_design::{Design, Failure};
use numpy::{PyArray1, PyArrayMethods as _};
use pyo3::prelude::*;

use crate::designs::{Array, Designs};
use crate::loaded::raise;
use crate::one::About;
use crate::ports::ports;

/// What regulators are asked for.
#[derive(FromPyObject)]
pub struct Asked {
    /// In m/s.
    #[pyo3(item)]
    speeds: Vec<f64>,
    /// By their names; without names all of them.
    #[pyo3(item)]
    inputs: Option<Vec<String>>,
    /// `NAME=VALUE`.
    #[pyo3(item)]
    weights: Vec<String>,
    /// As `deg,km/h`, or `si`.
    #[pyo3(item)]
    units: String,
}

impl Asked {
    fn schedule(&self, design: &Design) -> Result<(Schedule, Weights), Failure> {
        let (inputs, _) = ports(design, self.inputs.as_deref(), None, Ports::states)?;
        let weights = Weights::read(&self.weights, &Ports::of(design), &inputs)?;
        Ok((Schedule::new(design, &self.speeds, &weights)?, weights))
    }
}

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
    /// Regulators at speeds.
    fn lqr<'py>(&self, py: Python<'py>, about: About, asked: Asked) -> PyResult<Told<'py>> {
        let described = self.described(py, about)?;
        let find = || {
            let units = Units::parse(&asked.units)?;
            Ok(asked.schedule(&described.build()?)?.0.in_units(&|declared| units.of(declared)))
        };
        let schedule = py.detach(find).map_err(raise)?;
        let all = &schedule.regulators;
        let space = &all[0].space;
        let [count, inputs, states] = [all.len(), space.inputs.len(), space.states.len()];
        let gains =
            all.iter().flat_map(|own| own.gains.row_iter().flat_map(|row| row.iter().copied().collect::<Vec<_>>()));
        let values = all.iter().flat_map(|own| own.eigenvalues.iter().copied());
        let names = |signals: &[Signal]| signals.iter().map(|signal| signal.name.clone()).collect();
        Ok(Told {
            speeds: all.iter().map(|own| own.space.speed).collect(),
            inputs: names(&space.inputs),
            states: names(&space.states),
            gains: PyArray1::from_iter(py, gains).reshape([count, inputs, states])?.to_dyn().clone(),
            eigenvalues: PyArray1::from_iter(py, values).reshape([count, states])?.to_dyn().clone(),
            unstable: schedule.unstable,
        })
    }

    /// The derivatives of the gains by each parameter: an array that runs over the speeds, the parameters, the inputs and the states.
    fn lqr_sensitivities<'py>(&self, py: Python<'py>, about: About, asked: Asked) -> PyResult<Array<'py, f64>> {
        let described = self.described(py, about)?;
        let find = || {
            let units = Units::parse(&asked.units)?;
            let design = described.build()?;
            let (schedule, weights) = asked.schedule(&design)?;
            let mut shape = vec![schedule.regulators.len(), design.info().parameters.len()];
            let gains = &schedule.regulators[0].gains;
            shape.extend([gains.nrows(), gains.ncols()]);
            let mut numbers = Vec::with_capacity(shape.iter().product());
            for regulator in &schedule.regulators {
                for gains in regulator.sensitivities(&design, &weights)? {
                    let gains = regulator.gains_in_units(&gains, &|declared| units.of(declared));
                    numbers.extend_from_slice(gains.transpose().as_slice());
                }
            }
            Ok((numbers, shape))
        };
        let (numbers, shape) = py.detach(find).map_err(raise)?;
        PyArray1::from_vec(py, numbers).reshape(shape)
    }

    /// The same as a module of `rust`, or else of C99.
    fn lqr_code(&self, py: Python<'_>, about: About, asked: Asked, language: &str) -> PyResult<String> {
        let described = self.described(py, about)?;
        let code = if language == "rust" { Code::Rust } else { Code::C };
        let write = || {
            let design = described.build()?;
            let (schedule, weights) = asked.schedule(&design)?;
            Ok(schedule.code(code, &design, &weights))
        };
        py.detach(write).map_err(raise)
    }
}
