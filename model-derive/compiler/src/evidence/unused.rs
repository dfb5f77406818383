//! Names that nothing depends on.

use crate::check::Checked;
use crate::formula::Formula;
use crate::report::Report;
use crate::syntax::{Declaration, Parameter};

/// For each parameter whether one of the outputs or a requirement depends on it, directly or through definitions.
pub fn find_used(checked: &Checked<'_>, definitions: &[Formula], outputs: &[&Formula]) -> Vec<bool> {
    let roots = || outputs.iter().copied().chain(checked.requirements.iter().map(|requirement| &requirement.value));
    let reached = reach(definitions, roots());
    let mut used = vec![false; checked.declaration.parameters.len()];
    let live = definitions.iter().zip(reached).filter(|(_, reached)| *reached).map(|(definition, _)| definition);
    mark_parameters(live.chain(outputs.iter().copied()), &mut used);
    used
}

/// Reports definitions and parameters that nothing depends on, and parameters marked `unused` that are used.
pub fn report_unused(checked: &Checked<'_>, definitions: &[Formula], outputs: &[&Formula], report: &mut Report) {
    let Checked { declaration, excused, attributes, assertions, asserted, unsteady, written, .. } = checked;
    // What depends on the speed is there as it is written, too: if a mistake keeps it from being sorted, and if terms cancel.
    // It stands behind the definitions of a derivation.
    let steady = checked.definitions.len();
    let positions: Vec<usize> = (0..steady).chain((0..unsteady.len()).map(|index| definitions.len() + index)).collect();
    let unsteady = unsteady.iter().map(|definition| definition.renumbered(&positions));
    let definitions = &definitions.iter().cloned().chain(unsteady).collect::<Vec<Formula>>();
    let wholes = written.wholes.iter().filter(|_| declaration.mechanism.is_none());
    let renumbered = |formula: &Formula| formula.renumbered(&positions);
    let mut in_speed: Vec<Formula> = wholes.flat_map(|(_, rows)| rows.iter().flatten()).map(renumbered).collect();
    let mut attributes = attributes.clone();
    let fed = checked.feedback.iter().flat_map(|law| &law.terms).map(|term| renumbered(&term.factor));
    match declaration.mechanism {
        None => in_speed.extend(fed),
        // What the wheels determine, and feedback multiplies, may be nothing in the first order.
        Some(_) => attributes.extend(fed),
    }
    let in_speed = || in_speed.iter();
    let requirements = || checked.requirements.iter().map(|requirement| &requirement.value);
    let roots = || outputs.iter().copied().chain(requirements()).chain(in_speed());
    let claims = || assertions.iter().flatten().chain(asserted.iter().flatten().flatten());
    let used = reach(definitions, roots());
    // A definition may serve claims alone, or what a mechanism is given and no matrix depends on. A parameter may not: no
    // value of it would change anything.
    let in_mechanism = reach(definitions, attributes.iter());
    // Behind the parameters stands the speed.
    let mut parameters_of_mechanism = vec![false; declaration.parameters.len() + 1];
    let inside =
        definitions.iter().zip(&in_mechanism).filter(|(_, reached)| **reached).map(|(definition, _)| definition);
    mark_parameters(attributes.iter().chain(inside), &mut parameters_of_mechanism);
    let claimed = reach(definitions, claims());
    // Those of a derivation are there because they are used.
    for (declared, &index) in positions.iter().enumerate() {
        let definition = checked.definition(declared);
        let name = definition.to_string();
        if !used[index] && !claimed[index] && !in_mechanism[index] && !excused.contains(&name) {
            report.error(
                definition,
                format!("`{name}` is never used: expected a matrix or a requirement that depends on it"),
            );
        }
    }
    // What only an unused definition mentions needs no second error.
    let mut mentioned = vec![false; declaration.parameters.len() + 1];
    let mut in_claims = mentioned.clone();
    let (used, claimed, in_mechanism) = (&used, &claimed, &in_mechanism);
    let of_definitions = |for_claims: bool| {
        let all = definitions.iter().enumerate();
        let serves = move |index: usize| !used[index] && (claimed[index] || in_mechanism[index]);
        all.filter(move |(index, _)| serves(*index) == for_claims).map(|(_, definition)| definition)
    };
    mark_parameters(roots().chain(of_definitions(false)), &mut mentioned);
    mark_parameters(claims().chain(of_definitions(true)), &mut in_claims);
    if let Some(speed) = declaration.speed.as_ref().filter(|speed| !excused.contains(&speed.name.to_string()))
        && !mentioned[declaration.parameters.len()]
        && !parameters_of_mechanism[declaration.parameters.len()]
    {
        let name = &speed.name;
        let places = match declaration.mechanism {
            None => "`C = …;`, `K = …;` or a `feedback`",
            Some(_) => "a `feedback`",
        };
        report.error(name, format!("`{name}` is never used: expected {places} with the speed in it"));
    }
    for (index, parameter) in declaration.parameters.iter().enumerate() {
        let name = parameter.name.to_string();
        match (parameter.unused, mentioned[index]) {
            (Some(span), true) => {
                report.error(span, format!("`{name}` is used: expected no `unused` here"));
            }
            (None, false) if parameter.gravity.is_none() && !excused.contains(&name) => {
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

/// Whether a parameter is probably the gravity of a mechanism that says of none what it is.
fn is_gravity(declaration: &Declaration, parameter: &Parameter) -> bool {
    declaration.mechanism.is_some()
        && declaration.parameters.iter().all(|parameter| parameter.gravity.is_none())
        && parameter.unit.as_ref().is_some_and(|unit| ["N/kg", "m/s^2"].contains(&unit.text.as_str()))
}

/// For each definition whether a root depends on it.
fn reach<'a>(definitions: &[Formula], roots: impl Iterator<Item = &'a Formula>) -> Vec<bool> {
    let mut reached = vec![false; definitions.len()];
    let mut open: Vec<usize> = roots.flat_map(Formula::find_definitions).collect();
    while let Some(index) = open.pop() {
        if !std::mem::replace(&mut reached[index], true) {
            open.extend(definitions[index].find_definitions());
        }
    }
    reached
}

fn mark_parameters<'a>(formulas: impl Iterator<Item = &'a Formula>, used: &mut [bool]) {
    for formula in formulas {
        formula.walk(&mut |part| {
            if let Formula::Parameter(index) = part {
                used[*index] = true;
            }
        });
    }
}
