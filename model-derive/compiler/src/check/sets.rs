//! Named parameter sets: complete, known, inside the domains.

use std::collections::HashMap;

use proc_macro2::Ident;

use super::constants::Constant;
use super::domains::Domain;
use super::units::Dimension;
use crate::formula::Formula;
use crate::model::{Origin, ParameterSet, Requirement};
use crate::nearest::nearest;
use crate::report::Report;
use crate::syntax::{self, Declaration};

/// What is declared of the parameters, by their position.
#[derive(Debug)]
pub struct Parameters<'a> {
    pub domains: &'a [Domain],
    pub dimensions: &'a [Option<Dimension>],
}

pub fn sets(declaration: &Declaration, parameters: &Parameters<'_>, report: &mut Report) -> Vec<ParameterSet> {
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
        sets.push(ParameterSet {
            name: set.name.clone(),
            docs: set.docs.clone(),
            source: set.source.clone().unwrap_or_default(),
            values: values(declaration, set, parameters, report),
        });
    }
    sets
}

/// Whether every set fulfils every requirement; only for a declaration without mistakes.
pub fn check_requirements(
    sets: &[ParameterSet],
    definitions: &[(Ident, Formula)],
    requirements: &[Requirement],
    report: &mut Report,
) {
    for set in sets {
        let mut values = Vec::with_capacity(definitions.len());
        for (_, definition) in definitions {
            values.push(definition.evaluate(&set.values, &values));
        }
        for requirement in requirements {
            let value = requirement.value.evaluate(&set.values, &values);
            if !requirement.domain.contains(value) {
                let Requirement { text, domain, origin, .. } = requirement;
                let why = match (origin, domain.nonzero) {
                    (Origin::Declared, _) => "",
                    (_, true) => ", and a formula divides by it",
                    (_, false) => ", and a formula takes its root",
                };
                let message = format!("`{text}` is {value} in the set `{}`{why}: expected {domain}", set.name);
                report.error(&set.name, message);
            }
        }
    }
}

/// The values in declared order of the parameters.
fn values(
    declaration: &Declaration,
    set: &syntax::ParameterSet,
    parameters: &Parameters<'_>,
    report: &mut Report,
) -> Vec<f64> {
    let Parameters { domains, dimensions } = parameters;
    let mut given: HashMap<String, f64> = HashMap::new();
    let known = || declaration.parameters.iter().map(|p| p.name.to_string());
    for entry in &set.values {
        let name = entry.name.to_string();
        let parameter = known().position(|known| known == name);
        if parameter.is_none() && !declaration.unread.iter().any(|unread| *unread == name) {
            let names: Vec<String> = known().collect();
            let hint = nearest(&name, names.iter().map(String::as_str)).map(|near| format!("; did you mean `{near}`?"));
            let message =
                format!("unknown parameter `{name}`: expected a parameter of the model{}", hint.unwrap_or_default());
            report.error(&entry.name, message);
        }
        let Some(written) = &entry.value else {
            given.entry(name).or_insert(0.0);
            continue;
        };
        let own = parameter.and_then(|index| dimensions[index]);
        let value = Constant::in_unit(written, own).and_then(|constant| {
            let value = constant.to_f64().map_err(|message| crate::report::error(written.region(), message))?;
            match parameter {
                Some(index) if !domains[index].contains(&constant) => Err(crate::report::error(
                    written.region(),
                    format!("`{name}` is {value} in the set `{}`: expected {}", set.name, domains[index].to_model()),
                )),
                _ => Ok(value),
            }
        });
        let value = value.unwrap_or_else(|error| {
            report.push(error);
            0.0
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
    known().map(|name| given.get(&name).copied().unwrap_or(0.0)).collect()
}
