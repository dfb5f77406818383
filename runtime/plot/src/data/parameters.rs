//! The parameters of a design as JSON, which is read as a file of them.

use std::io::{Result, Write};

use carvallo::ParameterInfo;
use carvallo_design::{Design, DisplayUnit, Given};
use serde::Serialize;

use super::head::Head;
use super::layout::{Line, Members, write_document};

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    source: Option<&'a str>,
    parameters: Members<Line<Parameter>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    correlations: Option<Correlations>,
}

#[derive(Serialize)]
struct Parameter {
    value: f64,
    std: f64,
    /// Where it is not that of the SI.
    #[serde(skip_serializing_if = "Option::is_none")]
    unit: Option<String>,
}

/// The name of a unit that is not the declared one.
pub fn other(unit: &DisplayUnit) -> Option<String> {
    (!unit.is_declared()).then(|| unit.written.clone())
}

/// For each parameter that varies together with others, its correlations with those before it.
pub type Correlations = Members<Line<Members<f64>>>;

/// The correlations of the parameters of a design, if they are known not to be independent.
pub fn correlations(design: &Design) -> Option<Correlations> {
    let name = |position: usize| design.info().parameters[position].name;
    let all = design.covariance.as_ref()?.correlations();
    let of_one = |pairs: &[(usize, usize, f64)]| {
        let others = pairs.iter().map(|pair| (name(pair.1), pair.2)).collect();
        (name(pairs[0].0), Line(Members(others)))
    };
    Some(Members(all.chunk_by(|a, b| a.0 == b.0).map(of_one).collect()))
}

/// In units that are shown by those that parameters are declared in.
///
/// # Errors
/// If it cannot be written.
pub fn write_json(design: &Design, shown: &dyn Fn(&str) -> DisplayUnit, output: &mut dyn Write) -> Result<()> {
    let of_one = |(info, given): (&ParameterInfo, &Given)| {
        let std = given.deviation.as_ref().map_or(0.0, |deviation| deviation.value);
        let unit = shown(info.unit);
        let parameter = Parameter { value: unit.value(given.value), std: unit.value(std), unit: other(&unit) };
        (info.name, Line(parameter))
    };
    let all = design.info().parameters.iter().zip(&design.parameters);
    let document = Document {
        head: Head::of(design),
        source: design.source.as_deref(),
        parameters: Members(all.map(of_one).collect()),
        correlations: correlations(design),
    };
    write_document(&document, output)
}
