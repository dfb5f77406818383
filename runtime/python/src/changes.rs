//! How the critical speeds and matrices of one design change with its parameters.

use carvallo::{Complex, MatrixName};
use carvallo_design::Failure;
use carvallo_plot::analysis::name;
use carvallo_plot::analysis::sensitivity::{Changes, Critical};
use carvallo_plot::picture::draw_tornado;
use pyo3::prelude::*;

use crate::designs::Designs;
use crate::loaded::raise;
use crate::one::About;

/// The derivatives of a critical speed with respect to each parameter, or why it has none.
#[derive(IntoPyObject)]
pub struct Derivatives {
    name: &'static str,
    speed: f64,
    eigenvalue: Complex<f64>,
    /// In m/s per unit of each parameter.
    by: Vec<f64>,
    /// Of the eigenvalue, in 1/s per unit of each parameter.
    eigenvalue_by: Vec<Complex<f64>>,
    /// In m/s.
    deviation: Option<f64>,
    /// Of the variance, from each parameter.
    shares: Option<Vec<f64>>,
    reason: Option<String>,
}

impl Derivatives {
    fn of(critical: &Critical, name: &'static str) -> Self {
        let (speed, eigenvalue) = (critical.speed.speed, critical.speed.eigenvalue);
        match &critical.derivatives {
            Ok(found) => Self {
                name,
                speed,
                eigenvalue,
                by: found.speed.clone(),
                eigenvalue_by: found.eigenvalue.clone(),
                deviation: found.deviation,
                shares: found.variance_shares.clone(),
                reason: None,
            },
            Err(reason) => Self {
                name,
                speed,
                eigenvalue,
                by: Vec::new(),
                eigenvalue_by: Vec::new(),
                deviation: None,
                shares: None,
                reason: Some(reason.to_string()),
            },
        }
    }
}

/// A matrix by its name, row by row.
type Named = (&'static str, Vec<Vec<f64>>);

/// Of all critical speeds; what 1 % of each parameter is; and the standard deviations of the entries of the matrices.
type Told = (Vec<Derivatives>, Vec<Option<f64>>, Option<Vec<Named>>);

#[pymethods]
impl Designs {
    /// The derivatives of all critical speeds, what 1 % of each parameter is if that is known, and the standard deviations of
    /// the entries of the matrices if parameters have any.
    fn sensitivity(&self, py: Python<'_>, about: About) -> PyResult<Told> {
        let changes = Changes::new(self.described(py, about)?.build().map_err(raise)?).map_err(raise)?;
        let critical = changes.critical_speeds.iter();
        let derivatives = critical.map(|critical| Derivatives::of(critical, name(&critical.speed, self.model.info)));
        let named = |(name, rows): (MatrixName, Vec<Vec<f64>>)| (name.name(), rows);
        let deviations = changes.matrix_deviations.as_ref();
        let deviations = deviations.map(|deviations| deviations.matrices().into_iter().map(named).collect());
        Ok((derivatives.collect(), changes.steps.iter().map(|step| step.size()).collect(), deviations))
    }

    /// What 1 % of each parameter does to the critical speeds, as SVG.
    fn sensitivity_svg(&self, py: Python<'_>, about: About) -> PyResult<String> {
        let changes = Changes::new(self.described(py, about)?.build().map_err(raise)?).map_err(raise)?;
        let nothing = || raise(Failure::usage("no critical speed has derivatives, and there is nothing to draw"));
        Ok(draw_tornado(&changes).ok_or_else(nothing)?.svg())
    }
}
