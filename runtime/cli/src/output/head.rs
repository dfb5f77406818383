//! What every JSON output begins with.

use serde::Serialize;

use crate::design::Design;

/// The model, and what the design is called.
#[derive(Serialize)]
pub struct Head<'a> {
    model: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    bicycle: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<&'a str>,
}

impl<'a> Head<'a> {
    pub fn of(design: &'a Design) -> Self {
        let is_bicycle = design.model.is_whipple();
        let name = design.name.as_str();
        Self { model: design.info().name, bicycle: is_bicycle.then_some(name), name: (!is_bicycle).then_some(name) }
    }
}
