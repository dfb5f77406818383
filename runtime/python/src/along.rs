//! The stability of one design along one of its parameters.

use carvallo::{Complex, CriticalValue, ParameterRange};
use carvallo_design::Failure;
use carvallo_plot::analysis::along::{Along, AlongAnalysis};
use carvallo_plot::picture::draw_along;
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::prelude::*;

use crate::designs::Designs;
use crate::loaded::raise;
use crate::one::{About, Described};
use crate::pictures::limited;

/// A parameter, its ends and the speed in m/s.
#[derive(FromPyObject)]
pub struct Asked {
    /// `NAME=LOW:HIGH`.
    #[pyo3(item)]
    range: String,
    #[pyo3(item)]
    speed: Option<f64>,
}

/// What it is called, the value and its error, the eigenvalue in 1/s, what changes, and the verdicts below and above.
type Value = (&'static str, f64, f64, Complex<f64>, String, String, String);

/// Everything along a parameter.
#[derive(IntoPyObject)]
pub struct Told<'py> {
    parameter: &'static str,
    unit: &'static str,
    /// None where nothing depends on it.
    speed: Option<f64>,
    critical_values: Vec<Value>,
    stable: Vec<(f64, f64)>,
    undecided: Vec<(f64, f64)>,
    values: Bound<'py, PyArray1<f64>>,
    verdicts: Vec<String>,
    /// By value of the parameter.
    eigenvalues: Bound<'py, PyArray2<Complex<f64>>>,
}

impl Asked {
    fn analysis(&self, described: &Described) -> Result<AlongAnalysis, Failure> {
        let along: Along = self.range.parse().map_err(|problem| Failure::Input(vec![problem]))?;
        AlongAnalysis::new(described.build()?, &along, self.speed)
    }
}

fn ends(ranges: &[ParameterRange]) -> Vec<(f64, f64)> {
    ranges.iter().map(|ParameterRange { from, to }| (*from, *to)).collect()
}

#[pymethods]
impl Designs {
    /// One design along one of its parameters, with eigenvalues at so many values of it.
    fn along<'py>(&self, py: Python<'py>, about: About, asked: Asked, count: u32) -> PyResult<Told<'py>> {
        let described = self.described(py, about)?;
        let find = || {
            let found = asked.analysis(&described)?;
            let critical = |critical: &CriticalValue| {
                let [below, above] = found.stability.verdicts_around(critical).map(|verdict| verdict.to_string());
                let CriticalValue { value, error, eigenvalue, change, .. } = *critical;
                (found.name(critical), value, error, eigenvalue, change.to_string(), below, above)
            };
            let critical: Vec<Value> = found.stability.critical_values.iter().map(critical).collect();
            let ranges = (ends(&found.stability.stable_ranges), ends(&found.stability.undecided));
            Ok(((found.parameter, found.speed), critical, ranges, found.rows(count)?))
        };
        let ((parameter, speed), critical_values, (stable, undecided), rows) = py.detach(find).map_err(raise)?;
        let values: Vec<Complex<f64>> = rows.iter().flat_map(|row| row.eigenvalues.iter().copied()).collect();
        Ok(Told {
            parameter: parameter.name,
            unit: parameter.unit,
            speed,
            critical_values,
            stable,
            undecided,
            values: PyArray1::from_iter(py, rows.iter().map(|row| row.value)),
            verdicts: rows.iter().map(|row| row.verdict.to_string()).collect(),
            eigenvalues: PyArray1::from_vec(py, values).reshape([rows.len(), self.model.eigenvalues()])?,
        })
    }

    /// The eigenvalues against the parameter, as SVG; between two of them in 1/s.
    fn along_svg(&self, py: Python<'_>, about: About, asked: Asked, values: Option<(f64, f64)>) -> PyResult<String> {
        let described = self.described(py, about)?;
        let draw = || {
            values.map_or(Ok(()), |values| limited("values", values))?;
            Ok(draw_along(&asked.analysis(&described)?, values)?.svg())
        };
        py.detach(draw).map_err(raise)
    }
}
