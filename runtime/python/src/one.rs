//! One design with what is known of it, as analyses and pictures take it.

use carvallo::Covariance;
use carvallo_design::number::shortest;
use carvallo_design::{Design, Deviation, Failure, Given, Shipped, feedback};
use pyo3::prelude::*;

use crate::columns::{Held, gather};
use crate::designs::Designs;

/// What a design is called, what it is, where it comes from, the standard deviations of its parameters with their correlations,
/// and its laws of feedback.
#[derive(FromPyObject)]
pub struct About {
    #[pyo3(item)]
    name: String,
    #[pyo3(item)]
    kind: Option<String>,
    #[pyo3(item)]
    source: Option<String>,
    #[pyo3(item)]
    deviations: Vec<f64>,
    #[pyo3(item)]
    correlations: Vec<(usize, usize, f64)>,
    #[pyo3(item)]
    feedback: Vec<String>,
}

/// One design before its equations of motion, which belong to the thread that makes them.
pub struct Described {
    model: &'static Shipped,
    values: Vec<f64>,
    about: About,
}

impl Designs {
    /// The first of the designs, with what is known of it.
    ///
    /// # Errors
    /// If a column cannot be read.
    pub(crate) fn described(&self, py: Python<'_>, about: About) -> PyResult<Described> {
        let held = Held::new(py, &self.columns)?;
        let mut values = Vec::new();
        gather(&held.values()?, 0, &mut values);
        Ok(Described { model: self.model, values, about })
    }
}

impl Described {
    /// With its equations of motion.
    ///
    /// # Errors
    /// The first of its parameters, or of the model's requirements, that does not hold.
    pub fn build(&self) -> Result<Design, Failure> {
        let Self { model, values, about } = self;
        let deviation = |value: f64| (value > 0.0).then(|| Deviation { written: shortest(value), value });
        let given =
            |(&value, &spread): (&f64, &f64)| Given { written: shortest(value), value, deviation: deviation(spread) };
        let covariance = (!about.correlations.is_empty())
            .then(|| Covariance::of_correlations(&about.deviations, &about.correlations))
            .transpose()
            .map_err(|error| Failure::usage(error.to_string()))?;
        Ok(Design {
            name: about.name.clone(),
            kind: about.kind.clone(),
            source: about.source.clone(),
            model,
            parameters: values.iter().zip(&about.deviations).map(given).collect(),
            feedback: feedback::laws(&about.feedback, model.info)?,
            covariance,
            equations: model.equations(values).map_err(Failure::usage)?,
            reading: None,
            set: Vec::new(),
            notes: Vec::new(),
            warnings: Vec::new(),
        })
    }
}
