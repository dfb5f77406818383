//! The syntax tree to a [`Model`]: the last stage that reports the user's mistakes.

mod constants;
mod definitions;
mod domains;
mod matrices;
mod names;
mod resolve;
mod sets;
mod unused;

use crate::model::{Coordinate, Model, Parameter, Requirement};
use crate::report::Report;
use crate::syntax::{Declaration, MatrixName};

/// Checks a declaration. All mistakes are noted in the report; only if there are none is the result of use.
pub fn check(declaration: Declaration, report: &mut Report) -> Model {
    let unread = !report.is_empty();
    if declaration.parameters.is_empty() && !unread {
        report.error(&declaration.name, "no parameters: expected `parameters { … }` with at least one");
    }
    let mut scope = names::Scope::new(&declaration, report);
    let resolved = definitions::resolve(&declaration, &mut scope, report);
    let requirements: Vec<Requirement> = declaration
        .requirements
        .iter()
        .map(|requirement| Requirement {
            text: resolve::text(&requirement.value),
            region: requirement.value.region,
            value: resolve::expression(&requirement.value, &mut scope, report),
            domain: domains::domain(std::slice::from_ref(&requirement.bound), report).to_model(),
        })
        .collect();
    let (matrices, entries) = matrices::matrices(&declaration, unread, &mut scope, report);
    let used = unused::parameters(&declaration, &resolved, &requirements, &matrices);
    // Without a mass matrix or a row formulas are missing, and what they would use is no mistake.
    let complete = matrices.iter().any(|(name, _)| *name == MatrixName::M)
        && matrices.iter().all(|(_, rows)| !rows.is_empty() && rows.iter().all(|row| !row.is_empty()));
    if !unread && complete {
        unused::report(&declaration, &resolved, &requirements, &matrices, &scope, report);
    }

    let new = resolved.new_positions();
    let requirements: Vec<Requirement> = requirements
        .into_iter()
        .map(|requirement| Requirement { value: requirement.value.renumbered(&new), ..requirement })
        .collect();
    let matrices = matrices
        .into_iter()
        .map(|(name, rows)| (name, rows.iter().map(|row| row.iter().map(|e| e.renumbered(&new)).collect()).collect()))
        .collect();

    let domains: Vec<_> = declaration.parameters.iter().map(|p| domains::domain(&p.bounds, report)).collect();
    let sets = sets::sets(&declaration, &domains, report);
    let gravity = gravity(&declaration, report);
    let definitions = resolved.in_order(&declaration);
    if report.is_empty() {
        sets::check_requirements(&sets, &definitions, &requirements, report);
    }
    let parameters = declaration.parameters.into_iter().zip(domains).zip(used).enumerate();
    let parameters = parameters.map(|(index, ((parameter, domain), used))| Parameter {
        symbol: parameter.symbol.unwrap_or_else(|| parameter.name.to_string()),
        name: parameter.name,
        docs: parameter.docs,
        unit: parameter.unit,
        domain: domain.to_model(),
        used: used || gravity == Some(index),
    });
    Model {
        definitions,
        parameters: parameters.collect(),
        name: declaration.name,
        visibility: declaration.visibility,
        docs: declaration.docs,
        source: declaration.source.unwrap_or_default(),
        gravity,
        requirements,
        sets,
        coordinates: declaration
            .coordinates
            .into_iter()
            .map(|coordinate| Coordinate {
                label: coordinate.label.unwrap_or_else(|| coordinate.name.to_string()),
                name: coordinate.name.to_string(),
                docs: coordinate.docs,
                unit: coordinate.unit,
            })
            .collect(),
        matrices,
        entries,
    }
}

fn gravity(declaration: &Declaration, report: &mut Report) -> Option<usize> {
    let mut found = None;
    for (index, parameter) in declaration.parameters.iter().enumerate() {
        let Some(span) = parameter.gravity else { continue };
        if found.is_some() {
            report.error(span, "a second `gravity`: expected one parameter that is the gravitational field strength");
        }
        found.get_or_insert(index);
    }
    found
}
