//! From a design to any convention.

use super::carried::{Carried, deviations};
use super::name::{Name, Values};
use super::read::has_paper;
use super::{Convention, SPLIT};
use carvallo::Covariance;

use crate::design::{Design, Deviation, Given};
use crate::failure::Failure;
use crate::model::WHIPPLE;
use crate::number::shortest;

/// A design in the parameters of a convention.
#[derive(Debug)]
pub struct Converted {
    /// Which one.
    pub convention: &'static Convention,
    /// The model that the parameters of the paper are for.
    pub model: &'static str,
    /// The name of the machine, or of the file.
    pub name: String,
    /// What it is.
    pub kind: Option<String>,
    /// Where the parameters come from.
    pub source: Option<String>,
    /// In the order in which the convention has them.
    pub parameters: Vec<Parameter>,
    /// How they vary together, if any do.
    pub covariance: Option<Covariance>,
    /// What was lost, or assumed.
    pub notes: Vec<String>,
}

/// A parameter with its value.
#[derive(Debug)]
pub struct Parameter {
    /// What it is.
    pub name: Name,
    /// Its value.
    pub given: Given,
}

/// How far a value may be off that has been there and back, in parts of the largest of its kind.
const TOLERANCE: f64 = 1e-9;

/// A design in another convention.
///
/// # Errors
/// If its model has other parameters than a bicycle; or the convention cannot express it: what is wrong, or what is missing.
pub fn convert(design: &Design, convention: &'static Convention) -> Result<Converted, Failure> {
    let info = design.info();
    let label = design.title();
    let fail = |message: String| Failure::usage(format!("{label}: {message}"));
    if !has_paper(info) {
        return Err(fail(format!("the model {} has other parameters than a bicycle", info.name)));
    }
    let is_more = |name: &&str| WHIPPLE.info.position(name).is_none();
    let more: Vec<&str> = info.parameters.iter().map(|parameter| parameter.name).filter(is_more).collect();
    if !more.is_empty() && !convention.is_paper() {
        let more = more.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        return Err(fail(format!("{} have no place for {more} of the model {}", convention.title, info.name)));
    }
    if let Some(reading) = &design.reading
        && !reading.assumed.is_empty()
        && !convention.is_of_gyrostats()
    {
        let settings: Vec<String> = reading.assumed.iter().map(|name| format!("--set {name}=…")).collect();
        return Err(fail(format!(
            "two gyrostats do not tell how much of them the wheels are, which {} need; give {}",
            convention.title,
            settings.join(" ")
        )));
    }
    let values: Vec<Given> = design.parameters.clone();
    let mut paper = Values::default();
    info.parameters.iter().zip(&values).for_each(|(info, given)| paper.push(info.name, given.value.into()));
    let result = (convention.from_paper)(&paper).map_err(fail)?;
    check_way_back(convention, &paper, &result).map_err(fail)?;
    let own = || Covariance::independent(&deviations(&values)).map_err(|error| fail(error.to_string()));
    let covariance = design.covariance.clone().map_or_else(own, Ok)?;
    let carried = Carried::new(&paper, &covariance, convention.from_paper);
    let computed = |name: &Name| {
        let value = result.get(name.name)?.value;
        let deviation = carried.deviation(name.name);
        let deviation = (deviation > 0.0).then(|| Deviation { written: shortest(deviation), value: deviation });
        Some(Given { written: shortest(value), value, deviation })
    };
    let parameters: Vec<Parameter> = if convention.is_paper() {
        let name = |info: &carvallo::ParameterInfo| Name::new(info.name, info.unit, info.docs.trim());
        info.parameters.iter().zip(values).map(|(info, given)| Parameter { name: name(info), given }).collect()
    } else {
        let is_kept = |name: &&Name| !convention.is_of_gyrostats() || !SPLIT.contains(&name.name);
        let parameter = |name: &Name| Some(Parameter { given: computed(name)?, name: *name });
        convention.names.iter().filter(is_kept).filter_map(parameter).collect()
    };
    let covariance = if convention.is_paper() {
        design.covariance.clone()
    } else {
        carried.covariance(parameters.iter().map(|parameter| parameter.name.name))
    };
    let feedback = (!design.feedback.is_empty()).then_some("laws of feedback are no parameters: left out");
    Ok(Converted {
        convention,
        model: info.name,
        name: design.name.clone(),
        kind: design.kind.clone(),
        source: design.source.clone(),
        parameters,
        covariance,
        notes: loss(convention, design).into_iter().chain(feedback).map(str::to_owned).collect(),
    })
}

/// What is said of what the convention does not keep.
fn loss(convention: &Convention, design: &Design) -> Option<&'static str> {
    match convention.name {
        "principal" => Some(
            "rear frame and person are one body in the paper: all of it is the frame D, and the person P has no mass",
        ),
        "gyrostats" | "libbicycle" if design.reading.as_ref().is_none_or(|reading| reading.assumed.is_empty()) => Some(
            "two gyrostats do not tell `mR`, `IRxx`, `mF` and `IFxx`, on which no motion depends: with them the way back is open",
        ),
        "jbike6" => Some(
            "rear frame and rider are one body in the paper: all of it is the frame, and rider, rack and basket have no mass",
        ),
        _ => None,
    }
}

/// Whether the parameters of the paper come out again.
fn check_way_back(convention: &Convention, paper: &Values, result: &Values) -> Result<(), String> {
    let back = (convention.to_paper)(result)?;
    for parameter in WHIPPLE.info.parameters {
        let [there, here] = [paper.get(parameter.name), back.get(parameter.name)].map(|value| value.map(|it| it.value));
        let (Some(there), Some(here)) = (there, here) else { continue };
        let of_kind = WHIPPLE.info.parameters.iter().filter(|other| other.unit == parameter.unit);
        let size =
            of_kind.filter_map(|other| paper.get(other.name)).fold(0.0, |size: f64, it| size.max(it.value.abs()));
        if (there - here).abs() > TOLERANCE * size.max(1.0) {
            let [there, here] = [there, here].map(|value| crate::number::with_unit(value, parameter.unit));
            let name = parameter.name;
            return Err(format!("{} cannot express it: `{name}` is {there}, and would be {here}", convention.title));
        }
    }
    Ok(())
}
