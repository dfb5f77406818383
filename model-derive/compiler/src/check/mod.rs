//! The syntax tree to a [`Model`]: the last stage that reports the user's mistakes.

mod asserted;
mod constants;
mod definitions;
mod domains;
mod evidence;
mod matrices;
mod mechanism;
mod names;
mod references;
mod resolve;
mod sets;
mod units;
mod unused;

use self::evidence::Evidence;
use crate::formula::Formula;
use crate::model::{Coordinate, Domain, Matrices, Model, Origin, Parameter, Requirement};
use crate::report::Report;
use crate::syntax::{Declaration, MatrixName, Unit};

/// Checks a declaration. All mistakes are noted in the report; only if there are none is the result of use.
pub fn check(mut declaration: Declaration, report: &mut Report) -> Model {
    let unread = !report.is_empty();
    if declaration.parameters.is_empty() && !unread {
        report.error(&declaration.name, "no parameters: expected `parameters { … }` with at least one");
    }
    let mut scope = names::Scope::new(&declaration, report);
    let dimensions = units::Dimensions::new(&declaration, report);
    mechanism::lower(&mut declaration, &mut scope, &dimensions, report);
    asserted::expand(&mut declaration, report);
    let resolved = definitions::resolve(&declaration, &mut scope, report);
    let requirements: Vec<Requirement> = declaration
        .requirements
        .iter()
        .map(|requirement| Requirement {
            text: requirement.value.to_string(),
            region: requirement.value.region,
            value: resolve::expression(&requirement.value, &mut scope, report),
            domain: domains::domain(std::slice::from_ref(&requirement.bound), None, report).to_model(),
            origin: Origin::Declared,
        })
        .collect();
    let assertions: Vec<[Formula; 2]> = declaration
        .assertions
        .iter()
        .map(|assertion| [&assertion.left, &assertion.right].map(|side| resolve::expression(side, &mut scope, report)))
        .collect();
    let (matrices, entries) = matrices::matrices(&declaration, unread, &mut scope, report);
    let kinematics = declaration
        .kinematics
        .as_ref()
        .map(|kinematics| kinematics.map(|formula| resolve::expression(formula, &mut scope, report)));
    let outputs: Vec<&Formula> = matrices.iter().flat_map(|(_, rows)| rows.iter().flatten()).collect();
    let outputs: Vec<&Formula> = outputs.into_iter().chain(kinematics.iter().flat_map(|k| k.formulas())).collect();
    let used = unused::parameters(&declaration, &resolved, &requirements, &outputs);
    // Without a mass matrix or a row formulas are missing, and what they would use is no mistake.
    let complete = matrices.iter().any(|(name, _)| *name == MatrixName::M)
        && matrices.iter().all(|(_, rows)| !rows.is_empty() && rows.iter().all(|row| !row.is_empty()));
    if !unread && complete {
        unused::report(&declaration, &resolved, &requirements, &assertions, &outputs, &scope, report);
    }

    // Of definitions in a cycle the first mistake is the cycle.
    let order = if resolved.cyclic { &[] } else { &resolved.order[..] };
    let defined = units::check(&declaration, &dimensions, &scope, order, report);

    let new = resolved.new_positions();
    let assertions: Vec<[Formula; 2]> =
        assertions.iter().map(|sides| sides.each_ref().map(|s| s.renumbered(&new))).collect();
    let mut requirements: Vec<Requirement> = requirements
        .into_iter()
        .map(|requirement| Requirement { value: requirement.value.renumbered(&new), ..requirement })
        .collect();
    let matrices: Matrices = matrices
        .into_iter()
        .map(|(name, rows)| (name, rows.iter().map(|row| row.iter().map(|e| e.renumbered(&new)).collect()).collect()))
        .collect();

    let kinematics = kinematics.map(|kinematics| kinematics.map(|formula| formula.renumbered(&new)));

    let own = declaration.parameters.iter().zip(&dimensions.parameters);
    let domains: Vec<_> = own.map(|(parameter, own)| domains::domain(&parameter.bounds, *own, report)).collect();
    let parameters = sets::Parameters { domains: &domains, dimensions: &dimensions.parameters };
    let sets = sets::sets(&declaration, &parameters, report);
    let gravity = gravity(&declaration, report);
    let definitions = resolved.in_order(&declaration);
    let symmetric = evidence::symmetric(&declaration);
    let references = references::references(&declaration, &scope, &defined);
    if report.is_empty() {
        let domains: Vec<Domain> = domains.iter().map(|domain| domain.to_model()).collect();
        let evidence = Evidence {
            declaration: &declaration,
            resolved: &resolved,
            dimensions: &dimensions,
            domains: &domains,
            matrices: &matrices,
            kinematics: kinematics.as_ref(),
            entries: &entries,
            assertions: &assertions,
            sets: &sets,
        };
        requirements = evidence.check(requirements, &mut scope, report);
    }
    let parameters = declaration.parameters.into_iter().zip(domains).zip(used).enumerate();
    let parameters = parameters.map(|(index, ((parameter, domain), used))| Parameter {
        symbol: parameter.symbol.unwrap_or_else(|| parameter.name.to_string()),
        name: parameter.name,
        docs: parameter.docs,
        unit: unit_text(parameter.unit),
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
                unit: unit_text(coordinate.unit),
            })
            .collect(),
        matrices,
        entries,
        symmetric,
        kinematics,
        derivatives: declaration.derivatives,
        references,
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

/// The unit as it was written; with one that could not be read nothing is compiled.
fn unit_text(unit: Option<Unit>) -> String {
    unit.map_or("1".into(), |unit| unit.text)
}
