//! State spaces with inputs and outputs, and transfer functions.

use carvallo::nalgebra::DMatrix;
use carvallo::{Complex, SystemError, Verdict};
use carvallo_control::{FrequencyResponse, Margins, Ports, Signal, StateSpace, TransferFunction, transmission_zeros};
use carvallo_design::number::shortest;
use carvallo_design::{Design, Failure};
use numpy::{PyArray1, PyArray3, PyArrayMethods as _};
use pyo3::prelude::*;

use crate::designs::Designs;
use crate::loaded::raise;
use crate::one::About;
use crate::ports::{Asked, Names};

/// A, B, C and D at each of several speeds, and the names of states, inputs and outputs.
type Spaces<'py> = (Vec<Bound<'py, PyArray3<f64>>>, [Vec<String>; 3]);

/// Zeros, poles and gain of a transfer function.
type Roots<'py> = (Bound<'py, PyArray1<Complex<f64>>>, Bound<'py, PyArray1<Complex<f64>>>, f64);

/// Frequencies with factors of gain or angles of phase.
type Crossings = Vec<(f64, f64)>;

fn named(signals: &[Signal]) -> Vec<String> {
    signals.iter().map(|signal| signal.name.clone()).collect()
}

fn fail(design: &Design, speed: f64, error: SystemError) -> Failure {
    Failure::Run(format!("{} at {} m/s: {error}", design.title(), shortest(speed)))
}

#[pymethods]
impl Designs {
    /// The state spaces of one design at speeds.
    fn state_spaces<'py>(
        &self,
        py: Python<'py>,
        about: About,
        speeds: Vec<f64>,
        names: Names,
    ) -> PyResult<Spaces<'py>> {
        let design = self.described(py, about)?;
        let found = py.detach(|| {
            let design = design.build()?;
            let at = |speed: &f64| names.shown(&design, *speed, Ports::states);
            // What there is is the same at every speed.
            let any = at(speeds.first().unwrap_or(&1.0))?;
            let each = speeds.iter().map(at).collect::<Result<Vec<_>, _>>()?;
            Ok((any, each))
        });
        let (any, each) = found.map_err(raise)?;
        let stacked = |of: fn(&StateSpace) -> &DMatrix<f64>| {
            let numbers: Vec<f64> = each.iter().flat_map(|space| of(space).transpose().as_slice().to_vec()).collect();
            PyArray1::from_vec(py, numbers).reshape([each.len(), of(&any).nrows(), of(&any).ncols()])
        };
        let arrays = [
            stacked(|space| &space.a),
            stacked(|space| &space.b),
            stacked(|space| &space.c),
            stacked(|space| &space.d),
        ];
        let arrays = arrays.into_iter().collect::<PyResult<_>>()?;
        Ok((arrays, [&any.states, &any.inputs, &any.outputs].map(|signals| named(signals))))
    }

    /// The transfer function of one design at a speed.
    fn transfer_function<'py>(&self, py: Python<'py>, about: About, asked: Asked) -> PyResult<Roots<'py>> {
        let design = self.described(py, about)?;
        let found = py.detach(|| {
            let design = design.build()?;
            let space = asked.shown(&design, Ports::states)?;
            TransferFunction::new(&space, 0, 0).map_err(|error| fail(&design, asked.speed, error))
        });
        let TransferFunction { zeros, poles, gain, .. } = found.map_err(raise)?;
        Ok((PyArray1::from_vec(py, zeros), PyArray1::from_vec(py, poles), gain))
    }

    /// The transmission zeros of one design at a speed between inputs and outputs, if there are as many of both.
    fn transmission_zeros<'py>(
        &self,
        py: Python<'py>,
        about: About,
        asked: Asked,
    ) -> PyResult<Option<Bound<'py, PyArray1<Complex<f64>>>>> {
        let design = self.described(py, about)?;
        let found = py.detach(|| {
            let design = design.build()?;
            let space = asked.shown(&design, Ports::coordinates)?;
            transmission_zeros(&space).map_err(|error| fail(&design, asked.speed, error))
        });
        Ok(found.map_err(raise)?.map(|zeros| PyArray1::from_vec(py, zeros)))
    }

    /// The gain and phase margins of one design at a speed, and whether the loop is stable.
    fn margins(&self, py: Python<'_>, about: About, asked: Asked) -> PyResult<(Crossings, Crossings, bool)> {
        let design = self.described(py, about)?;
        let found = py.detach(|| {
            let design = design.build()?;
            let space = asked.shown(&design, Ports::states)?;
            Margins::new(&space, 0, 0).map_err(|error| fail(&design, asked.speed, error))
        });
        let Margins { gain, phase, closed_loop } = found.map_err(raise)?;
        let gain = gain.iter().map(|margin| (margin.frequency, margin.factor)).collect();
        let phase = phase.iter().map(|margin| (margin.frequency, margin.angle)).collect();
        Ok((gain, phase, closed_loop == Verdict::Stable))
    }
}

/// Zeros, poles, and the value at zero.
type Minimal<'py> = (Bound<'py, PyArray1<Complex<f64>>>, Bound<'py, PyArray1<Complex<f64>>>, Option<f64>);

/// A transfer function of which only numbers are known.
fn known(zeros: Vec<Complex<f64>>, poles: Vec<Complex<f64>>, gain: f64) -> TransferFunction {
    let signal = || Signal { name: String::new(), label: String::new(), unit: "1".to_owned() };
    TransferFunction { input: signal(), output: signal(), zeros, poles, gain }
}

/// Gains and phases of a transfer function at frequencies in rad/s, or at those that show all of it.
#[pyfunction]
pub fn frequency_response<'py>(
    py: Python<'py>,
    zeros: Vec<Complex<f64>>,
    poles: Vec<Complex<f64>>,
    gain: f64,
    frequencies: Option<Vec<f64>>,
) -> [Bound<'py, PyArray1<f64>>; 3] {
    let function = known(zeros, poles, gain);
    let frequencies = frequencies.unwrap_or_else(|| function.frequencies(None));
    let response = function.frequency_response(&frequencies);
    let part = |of: fn(&FrequencyResponse) -> f64| PyArray1::from_vec(py, response.iter().map(of).collect());
    [part(|point| point.frequency), part(|point| point.gain), part(|point| point.phase)]
}

/// The zeros and poles of a transfer function that do not cancel each other, and its value at zero, unless a pole is there.
#[pyfunction]
pub fn minimal<'py>(py: Python<'py>, zeros: Vec<Complex<f64>>, poles: Vec<Complex<f64>>, gain: f64) -> Minimal<'py> {
    let function = known(zeros, poles, gain).minimal();
    let at_rest = function.static_gain();
    (PyArray1::from_vec(py, function.zeros), PyArray1::from_vec(py, function.poles), at_rest)
}
