//! Somebody's numbers, and the slip that makes them.

use carvallo_check::read;
use carvallo_design::Failure;
use carvallo_design::input::Request;
use pyo3::prelude::*;

use crate::loaded::raise;

/// What a file, or the JSON of numbers, comes to: the report as JSON, and as text for people.
#[pyfunction]
pub fn check(
    py: Python<'_>,
    path: Option<String>,
    json: Option<String>,
    bicycle: Option<String>,
    model: Option<String>,
) -> PyResult<(String, String)> {
    let find = || {
        let file = match (path, json) {
            (Some(path), _) => read::load(&path)?,
            (None, json) => read::read("given.json", json.unwrap_or_default().into_bytes())?,
        };
        let request = Request { model, parameters: bicycle, ..Request::default() };
        let design = file.design(&request)?;
        let report = carvallo_check::check(&file.given(&design)?, &design).map_err(Failure::usage)?;
        Ok((report.json(), report.to_string()))
    };
    py.detach(find).map_err(raise)
}
