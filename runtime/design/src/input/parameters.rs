//! From what was written to the parameters of a model: every name and every value is judged, all at once.

use std::collections::HashMap;

#[cfg(feature = "full")]
use carvallo::Covariance;
use carvallo::{ModelInfo, sort_by};

#[cfg(feature = "full")]
use super::correlations::Names;
use super::document::{Document, Entry};
use super::entries::{Entries, Missing, Remarks, unknown_settings};
use super::scope::Scope;
use super::shipped::{DEFAULT_BICYCLE, default_name};
use super::value::{self, validate};
use super::{Changes, magnitude, names, neutral, plausible};
use crate::design::{Design, Given};
use crate::failure::{Place, Problem};
use crate::feedback::{self, Law};
#[cfg(feature = "full")]
use crate::joined::Body;
use crate::matrices::{NAME, free};
use crate::model::{Equations, Shipped, WHIPPLE};
use crate::number::shortest;
#[cfg(feature = "full")]
use crate::parameter::find;

/// What would change the meaning of all values.
const UNITS: [&str; 2] = ["unit", "units"];

/// Judges a file together with the values of the command line, which replace those of the file.
///
/// # Errors
/// Everything that is wrong.
pub fn resolve(
    mut document: Document,
    label: &str,
    model: &'static Shipped,
    changes: Changes,
) -> Result<Design, Vec<Problem>> {
    let Changes { mut overrides, laws, .. } = changes;
    #[cfg(feature = "full")]
    let set = overrides.iter().map(|entry| entry.name.clone()).collect();
    let info = model.info;
    #[cfg(feature = "full")]
    crate::conventions::unfold(&mut document.entries, info);
    #[cfg(feature = "full")]
    let reading = crate::conventions::read(&mut document, label, info, &mut overrides);
    #[cfg(not(feature = "full"))]
    only_paper(&mut document, &mut overrides);
    let file = || Place::File(label.to_owned());
    let is_unreadable = !document.problems.is_empty();
    let mut remarks = Remarks::new(document.problems);
    remarks.notes.extend(document.notes);
    let entries = Entries::new(&document.entries, info, &mut remarks.problems);
    let scope = Scope::new(&document.entries, HashMap::new(), info);
    entries.check(&scope, info, &mut remarks);
    let settings = Entries::new(&overrides, info, &mut remarks.problems);
    let setting_scope = Scope::new(&overrides, values_of(&document.entries, info), info);
    settings.check(&setting_scope, info, &mut remarks);
    remarks.problems.extend(unknown_settings(&settings.unknown, info));

    check_outside(&document.outside, info, &mut remarks);
    let laws = resolve_laws(&document.feedback, &laws, info, &mut remarks.problems);

    let mut zero_radii = Vec::new();
    let mut missing = Vec::new();
    let mut parameters = Vec::new();
    for (position, parameter) in info.parameters.iter().enumerate() {
        let (entry, scope) = match (settings.given.get(&position), entries.given.get(&position)) {
            (Some(entry), _) => (entry, &setting_scope),
            (None, Some(entry)) => (entry, &scope),
            (None, None) => {
                missing.push(position);
                parameters.push(constant(neutral::default(position, info).unwrap_or(0.0)));
                continue;
            }
        };
        let names = |name: &str| scope.value(name);
        parameters.push(validate(entry, parameter, &names).unwrap_or_else(|mut problems| {
            let is_zero = value::number(entry, parameter, &names) == Ok(0.0);
            match &problems[..] {
                [problem] if is_zero && parameter.name.starts_with('r') => zero_radii.push((position, problem.clone())),
                _ => remarks.problems.append(&mut problems),
            }
            constant(0.0)
        }));
    }

    let values: Vec<f64> = parameters.iter().map(|parameter| parameter.value).collect();
    let (defaults, required): (Vec<usize>, Vec<usize>) =
        missing.iter().partition(|position| neutral::default(**position, info).is_some());
    let is_for_whipple = document.model.as_ref().is_none_or(|name| WHIPPLE.is_called(name));
    let is_narrow = is_for_whipple && !required.is_empty() && neutral::is_whipple_without(model, &required, &values);
    let is_serious = !required.is_empty() && !is_narrow;
    let names = missing.iter().map(|position| info.parameters[*position].name).collect();
    entries.check_unknown(&scope, info, &Missing { names, is_serious }, &mut remarks);
    // What cannot be read may hold what seems to be missing.
    if is_serious && !is_unreadable {
        let message = match document.entries.is_empty() {
            true => format!("it has no parameters{}", start(model)),
            false => format!("missing: {} (of {} parameters)", neutral::names(&missing, info), info.parameters.len()),
        };
        remarks.problems.push(Problem { place: file(), message });
    } else if is_narrow {
        let (names, name) = (neutral::names(&required, info), info.name);
        let (are, they) = if required.len() == 1 { ("is", "it is") } else { ("are", "they are") };
        let same = format!("with which {name} is the model {}", WHIPPLE.info.name);
        remarks.notes.push(format!("{label}: {names} {are} not given: {they} 0, {same}"));
    }
    remarks.notes.extend(neutral::note(label, &defaults, info));
    if !remarks.problems.is_empty() {
        remarks.problems.extend(zero_radii.into_iter().map(|(_, problem)| problem));
        sort_by(&mut remarks.problems, |a, b| a.place.cmp(&b.place));
        // A parser that recovers may meet the same mistake again.
        remarks.problems.dedup();
        return Err(remarks.problems);
    }

    remarks.notes.extend(neutral::replace_radii(label, model, &mut parameters, zero_radii)?);
    #[cfg(feature = "full")]
    let alone: Vec<f64> = parameters.iter().map(|parameter| parameter.value).collect();
    #[cfg(feature = "full")]
    let covariance = {
        let is_set = |position: usize| settings.given.contains_key(&position);
        let carried = reading.as_ref().and_then(|reading| reading.covariance.as_ref());
        let mut covariance = match carried {
            Some(covariance) => without(covariance, &parameters, &is_set),
            None => {
                let names =
                    Names { find: &|name| find(name, info), name: &|position: usize| info.parameters[position].name };
                let parameters: Vec<&Given> = parameters.iter().collect();
                super::correlations::resolve(document.correlations, &names, &parameters, &is_set)?
            }
        };
        if !changes.bodies.is_empty() {
            crate::joined::join(&changes.bodies, info, &mut parameters, &mut covariance)?;
        }
        covariance
    };
    #[cfg(not(feature = "full"))]
    let covariance = None;
    let model = model.with_feedback(&laws);
    let values: Vec<f64> = parameters.iter().map(|parameter| parameter.value).collect();
    let equations = model.equations(&values).map_err(|message: String| vec![Problem { place: file(), message }])?;
    if info.name == NAME {
        remarks.notes.extend(note_on_free(label, &*equations, info));
    }
    let name = document.name.unwrap_or_else(|| label.to_owned());
    #[cfg(feature = "full")]
    let name = crate::joined::name(name, &changes.bodies);
    let notes = remarks.all_notes();
    let mut warnings = remarks.warnings;
    #[cfg(feature = "full")]
    {
        let of_bodies: Vec<String> = changes.bodies.iter().flat_map(Body::warnings).collect();
        let sizes = if of_bodies.is_empty() { &values } else { &alone };
        warnings.extend(match &reading {
            Some(reading) => magnitude::warnings_by(reading, info, sizes),
            None => magnitude::warnings(info, sizes),
        });
        warnings.extend(of_bodies);
    }
    #[cfg(not(feature = "full"))]
    warnings.extend(magnitude::warnings(info, &values));
    warnings.extend(plausible::warnings(info, &values));
    let (kind, source) = (document.kind, document.source);
    #[cfg(feature = "full")]
    let kind = crate::joined::kind(kind, &changes.bodies);
    Ok(Design {
        name,
        kind,
        source,
        model,
        parameters,
        covariance,
        feedback: laws,
        equations,
        #[cfg(feature = "full")]
        reading,
        #[cfg(feature = "full")]
        set,
        notes,
        warnings,
    })
}

/// The laws of a file, and those of the command line in their place where both are of one force.
fn resolve_laws(
    of_file: &[(Place, String)],
    of_options: &[(Place, String)],
    info: &ModelInfo,
    problems: &mut Vec<Problem>,
) -> Vec<Law> {
    let [mut laws, others] = [of_file, of_options].map(|laws| {
        feedback::read(laws, info).unwrap_or_else(|found| {
            problems.extend(found);
            Vec::new()
        })
    });
    laws.retain(|law| others.iter().all(|other| other.input != law.input));
    laws.extend(others);
    laws
}

/// The covariance of parameters of which some have a value of their own from elsewhere; `None` if no others are correlated.
#[cfg(feature = "full")]
fn without(covariance: &Covariance, parameters: &[Given], is_set: &dyn Fn(usize) -> bool) -> Option<Covariance> {
    let sources = covariance.parts().iter().map(Vec::len).max().unwrap_or(0);
    let own = |(position, parts): (usize, &Vec<f64>)| {
        if !is_set(position) {
            return parts.clone();
        }
        let mut own = vec![0.0; sources + position + 1];
        own[sources + position] = parameters[position].deviation.as_ref().map_or(0.0, |deviation| deviation.value);
        own
    };
    let parts = covariance.parts().iter().enumerate().map(own).collect();
    Covariance::of_parts(parts).ok().filter(|covariance| !covariance.correlations().is_empty())
}

/// Other parameterizations than that of the paper are not read.
#[cfg(not(feature = "full"))]
fn only_paper(document: &mut Document, _: &mut Vec<Entry>) {
    if let Some((place, name)) = document.parameterization.take().filter(|(_, name)| name != "benchmark") {
        document.problem(place, format!("the parameterization is `{name}`; only `benchmark` can be read"));
    }
}

/// What stands outside of the group of the parameters may have been meant for one.
fn check_outside(outside: &[Entry], info: &ModelInfo, remarks: &mut Remarks) {
    for Entry { name, place, .. } in outside {
        let message = if UNITS.contains(&name.as_str()) {
            format!("`{name}` is not read: values are in SI units, or have their own behind them, as in `102 cm`")
        } else if names::position(name, info).is_some() {
            format!("`{name}` stands outside of `values:`")
        } else {
            continue;
        };
        remarks.problems.push(Problem { place: place.clone(), message });
    }
}

/// The values of everything in a file that has one.
fn values_of(entries: &[Entry], info: &'static ModelInfo) -> HashMap<String, f64> {
    let scope = Scope::new(entries, HashMap::new(), info);
    entries.iter().filter_map(|entry| Some((scope.key(&entry.name), scope.value(&entry.name)?.ok()?))).collect()
}

/// That positions on which no force depends make eigenvalues of zero, if there are any.
fn note_on_free(label: &str, equations: &dyn Equations, info: &ModelInfo) -> Option<String> {
    let names: Vec<String> = free(equations, info).iter().map(|name| format!("`{name}`")).collect();
    let names = Some(names.join(", ")).filter(|names| !names.is_empty())?;
    let zero = "so that 0 is an eigenvalue at every speed";
    Some(format!(
        "{label}: no force depends on the position of {names}, {zero}; `only = \"rate\"` in `coordinates` leaves it out"
    ))
}

fn constant(value: f64) -> Given {
    Given { written: shortest(value), value, deviation: None }
}

/// How to get a file to start from, if there is one for the model.
fn start(model: &Shipped) -> String {
    let arguments = match default_name(model) {
        None => return String::new(),
        Some(_) if model.is_whipple() => DEFAULT_BICYCLE.to_owned(),
        Some(_) => format!("--model {}", model.info.name),
    };
    format!("; `carvallo show {arguments}` prints a file to start from")
}
