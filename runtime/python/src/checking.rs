//! Somebody's numbers, and the slip that makes them.

use carvallo_check::read;
use carvallo_design::input::Request;
use carvallo_design::units::Units;
use carvallo_design::{Failure, Place};
use pyo3::prelude::*;

use crate::loaded::raise;

/// What stands for the file of what is given as a dict.
const GIVEN: &str = "given.json";

/// What is wrong with a dict is at no line of a file.
fn without_file(mut failure: Failure) -> Failure {
    if let Failure::Input(problems) = &mut failure {
        problems
            .iter_mut()
            .filter(|problem| problem.place.file() == GIVEN)
            .for_each(|problem| problem.place = Place::Nowhere);
    }
    failure
}

/// What a file, or the JSON of numbers, comes to: the report as JSON, and as text for people, both in these units.
#[pyfunction]
pub fn check(
    py: Python<'_>,
    path: Option<String>,
    json: Option<String>,
    bicycle: Option<String>,
    model: Option<String>,
    feedback: Vec<String>,
    units: &str,
) -> PyResult<(String, String)> {
    let is_dict = path.is_none();
    let find = || {
        let file = match (path, json) {
            (Some(path), _) => read::load(&path)?,
            (None, json) => read::read(GIVEN, json.unwrap_or_default().into_bytes())?,
        };
        let units = Units::parse(units)?;
        let feedback = feedback.into_iter().map(|law| (format!("feedback '{law}'"), law)).collect();
        let request = Request { model, parameters: bicycle, feedback, ..Request::default() };
        let design = file.design(&request)?;
        let report = carvallo_check::check_in(&file.given(&design)?, &design, units).map_err(Failure::usage)?;
        Ok((report.json(), report.to_string()))
    };
    py.detach(find).map_err(|failure| raise(if is_dict { without_file(failure) } else { failure }))
}
