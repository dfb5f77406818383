//! Names that nothing depends on.

use proc_macro2::Ident;

use super::definitions::{Resolved, uses};
use super::names::{Meaning, Scope};
use crate::formula::Formula;
use crate::model::Requirement;
use crate::report::Report;
use crate::syntax::{Declaration, Parameter};

/// For each parameter whether a matrix depends on it, directly or through definitions.
pub fn parameters(
    declaration: &Declaration,
    resolved: &Resolved,
    requirements: &[Requirement],
    outputs: &[&Formula],
) -> Vec<bool> {
    let reached = reached(resolved, outputs.iter().copied().chain(requirements.iter().map(|r| &r.value)));
    let live = resolved.definitions.iter().enumerate().filter(|(index, _)| reached[*index]).map(|(_, expr)| expr);
    let mut used = vec![false; declaration.parameters.len()];
    mark(live.chain(outputs.iter().copied()), &mut used);
    used
}

/// Reports definitions and parameters that nothing depends on, and parameters marked `unused` that are used.
pub fn report(
    declaration: &Declaration,
    resolved: &Resolved,
    requirements: &[Requirement],
    assertions: &[[Formula; 2]],
    outputs: &[&Formula],
    scope: &Scope,
    report: &mut Report,
) {
    let roots = || outputs.iter().copied().chain(requirements.iter().map(|r| &r.value));
    let used = reached(resolved, roots());
    // A definition may serve claims alone, or what a mechanism is given and no matrix depends on. A parameter may not: no
    // value of it would change anything.
    let (in_mechanism, parameters_of_mechanism) = in_mechanism(declaration, resolved, scope);
    let claimed = reached(resolved, assertions.iter().flatten());
    for (index, definition) in declaration.definitions.iter().enumerate() {
        let name = definition.name.to_string();
        if !used[index] && !claimed[index] && !in_mechanism[index] && !scope.excused.contains(&name) {
            report.error(
                &definition.name,
                format!("`{name}` is never used: expected a matrix or a requirement that depends on it"),
            );
        }
    }
    // What only an unused definition mentions needs no second error.
    let mut mentioned = vec![false; declaration.parameters.len()];
    let mut in_claims = mentioned.clone();
    let (used, claimed, in_mechanism) = (&used, &claimed, &in_mechanism);
    let definitions = |for_claims: bool| {
        let all = resolved.definitions.iter().enumerate();
        let serves = move |index: usize| !used[index] && (claimed[index] || in_mechanism[index]);
        all.filter(move |(index, _)| serves(*index) == for_claims).map(|(_, expr)| expr)
    };
    mark(roots().chain(definitions(false)), &mut mentioned);
    mark(assertions.iter().flatten().chain(definitions(true)), &mut in_claims);
    for (index, parameter) in declaration.parameters.iter().enumerate() {
        let name = parameter.name.to_string();
        match (parameter.unused, mentioned[index]) {
            (Some(span), true) => {
                report.error(span, format!("`{name}` is used: expected no `unused` here"));
            }
            (None, false) if parameter.gravity.is_none() && !scope.excused.contains(&name) => {
                let message = if parameters_of_mechanism[index] {
                    format!("no matrix depends on `{name}`: expected the word `unused` after its unit")
                } else {
                    let found = if in_claims[index] { "used in assertions only" } else { "never used" };
                    let meant = if is_gravity(declaration, parameter) { "`gravity` or " } else { "" };
                    format!(
                        "`{name}` is {found}: expected a formula that depends on it, or the word {meant}`unused` after its \
                         unit"
                    )
                };
                report.error(&parameter.name, message);
            }
            _ => {}
        }
    }
}

/// For each definition and each parameter whether the mechanism depends on it.
fn in_mechanism(declaration: &Declaration, resolved: &Resolved, scope: &Scope) -> (Vec<bool>, Vec<bool>) {
    let mut roots = Vec::new();
    let mut note = |name: &Ident| match scope.get(name) {
        Some(Meaning::Parameter(index)) => roots.push(Formula::Parameter(index)),
        Some(Meaning::Definition(index)) => roots.push(Formula::Definition(index)),
        Some(Meaning::Coordinate | Meaning::Refused) | None => {}
    };
    let formulas = declaration.mechanism.iter().flat_map(|mechanism| mechanism.formulas());
    formulas.for_each(|formula| formula.names(&mut note));
    let definitions = reached(resolved, roots.iter());
    let mut parameters = vec![false; declaration.parameters.len()];
    let inside = resolved.definitions.iter().zip(&definitions).filter(|(_, reached)| **reached).map(|(expr, _)| expr);
    mark(roots.iter().chain(inside), &mut parameters);
    (definitions, parameters)
}

/// Whether a parameter is probably the gravity of a mechanism that says of none what it is.
fn is_gravity(declaration: &Declaration, parameter: &Parameter) -> bool {
    declaration.mechanism.is_some()
        && declaration.parameters.iter().all(|parameter| parameter.gravity.is_none())
        && parameter.unit.as_ref().is_some_and(|unit| ["N/kg", "m/s^2"].contains(&unit.text.as_str()))
}

/// For each definition whether a root depends on it.
fn reached<'a>(resolved: &Resolved, roots: impl Iterator<Item = &'a Formula>) -> Vec<bool> {
    let mut reached = vec![false; resolved.definitions.len()];
    let mut open: Vec<usize> = roots.flat_map(uses).collect();
    while let Some(index) = open.pop() {
        if !std::mem::replace(&mut reached[index], true) {
            open.extend(uses(&resolved.definitions[index]));
        }
    }
    reached
}

fn mark<'a>(expressions: impl Iterator<Item = &'a Formula>, used: &mut [bool]) {
    for expression in expressions {
        expression.walk(&mut |part| {
            if let Formula::Parameter(index) = part {
                used[*index] = true;
            }
        });
    }
}
