//! Named parameter sets: complete, known, inside the domains.

use std::collections::HashMap;

use super::constants::evaluate_in;
use super::domains::ExactDomain;
use super::units::dimension::Dimension;
use crate::constant::Constant;
use crate::model::ParameterSet;
use crate::nearest::{ask_for, find_nearest};
use crate::report::Report;
use crate::syntax::{self, Declaration};

/// What is declared of the parameters, by their position.
#[derive(Debug)]
pub struct Parameters<'a> {
    pub domains: &'a [ExactDomain],
    pub dimensions: &'a [Option<Dimension>],
}

/// A parameter set, with its values as they are written.
#[derive(Debug)]
pub struct CheckedSet {
    /// With the nearest values in `f64`.
    pub set: ParameterSet,
    /// For each parameter.
    pub exact: Vec<Constant>,
}

/// Reads the parameter sets.
pub fn read_sets(declaration: &Declaration, parameters: &Parameters<'_>, report: &mut Report) -> Vec<CheckedSet> {
    let mut constants: Vec<String> = Vec::new();
    let mut sets = Vec::new();
    for set in &declaration.sets {
        let constant = set.name.to_string().to_uppercase();
        if constant == "INFO" {
            report.error(&set.name, "`INFO` is the model's description: expected another name for the set");
        } else if constants.contains(&constant) {
            let message = format!("a second set for the constant `{constant}`: expected one set of each name");
            report.error(&set.name, message);
        }
        constants.push(constant);
        for (position, matrix) in set.published.iter().enumerate() {
            if set.published[..position].iter().any(|known| known.name == matrix.name) {
                let name = matrix.name.name();
                report.error(matrix.span, format!("`{name}` is published twice: expected one of each matrix"));
            }
        }
        let (values, exact) = read_values(declaration, set, parameters, report).into_iter().unzip();
        let (docs, source) = (set.docs.clone(), set.source.clone().unwrap_or_default());
        sets.push(CheckedSet {
            set: ParameterSet { name: set.name.clone(), is_default: !set.defaults.is_empty(), docs, source, values },
            exact,
        });
    }
    sets
}

/// The values in declared order of the parameters.
fn read_values(
    declaration: &Declaration,
    set: &syntax::ParameterSet,
    parameters: &Parameters<'_>,
    report: &mut Report,
) -> Vec<(f64, Constant)> {
    let Parameters { domains, dimensions } = parameters;
    let mut given: HashMap<String, (f64, Constant)> = HashMap::new();
    let zero = || (0.0, Constant::zero());
    let known = || declaration.parameters.iter().map(|p| p.name.to_string());
    for entry in &set.values {
        let name = entry.name.to_string();
        let parameter = known().position(|known| known == name);
        let is_speed = declaration.speed.as_ref().is_some_and(|speed| speed.name == name);
        if is_speed {
            let message =
                format!("`{name}` is the speed, at which eigenvalues are asked for: expected no value of it in a set");
            report.error(&entry.name, message);
            continue;
        }
        if parameter.is_none() && !declaration.unread.iter().any(|unread| *unread == name) {
            let names: Vec<String> = known().collect();
            let near = find_nearest(&name, names.iter().map(String::as_str));
            let hint = near.map(ask_for).unwrap_or_default();
            let message = format!("unknown parameter `{name}`: expected a parameter of the model{hint}");
            report.error(&entry.name, message);
        }
        let Some(written) = &entry.value else {
            given.entry(name).or_insert_with(zero);
            continue;
        };
        let own = parameter.and_then(|index| dimensions[index]);
        let value = evaluate_in(written, own).and_then(|constant| {
            let value = constant.to_f64().map_err(|message| crate::report::error(written.region(), message))?;
            match parameter {
                Some(index) if !domains[index].contains(&constant) => Err(crate::report::error(
                    written.region(),
                    format!(
                        "`{name}` is {} in the set `{}`: expected {}",
                        crate::report::number(value),
                        set.name,
                        domains[index].to_model()
                    ),
                )),
                _ => Ok((value, constant)),
            }
        });
        let value = value.unwrap_or_else(|error| {
            report.push(error);
            zero()
        });
        if given.insert(name.clone(), value).is_some() {
            report.error(&entry.name, format!("`{name}` is given twice: expected one value for each parameter"));
        }
    }
    let missing: Vec<String> =
        known().filter(|name| !given.contains_key(name)).map(|name| format!("`{name}`")).collect();
    if !missing.is_empty() {
        let message = format!(
            "the set `{}` has no value for {}: expected a value for each parameter",
            set.name,
            missing.join(", ")
        );
        report.error(&set.name, message);
    }
    known().map(|name| given.remove(&name).unwrap_or_else(zero)).collect()
}
