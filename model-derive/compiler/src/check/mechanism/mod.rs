//! A mechanism to definitions, matrices and rates, as if these were written in the declaration.

mod assemble;
mod attachments;
mod faults;
mod named;
mod tree;
mod written;

use std::collections::HashSet;

use proc_macro2::Ident;

use self::tree::{Role, Tree};
use self::written::Names;
use super::definitions;
use super::names::Scope;
use super::resolve;
use super::units::{self, Dimensions};
use crate::equations::Equations;
use crate::formula::Formula;
use crate::kinematics::{Kinematics, Rate};
use crate::mechanics::{self, Derived, Written};
use crate::report::{Region, Report};
use crate::symbolic::{Failure, Place};
use crate::syntax::{Declaration, Definition, Expression, Freedom, JointKind, Matrix, Mechanism};

/// Puts what follows from the mechanism of a declaration into it. Mistakes are reported.
pub fn lower(declaration: &mut Declaration, scope: &mut Scope, dimensions: &Dimensions, report: &mut Report) {
    let Some(mechanism) = declaration.mechanism.take() else { return };
    // What is asserted of the matrices can wait until they are there.
    let asserted = std::mem::take(&mut declaration.asserted);
    lower_mechanism(declaration, &mechanism, scope, dimensions, report);
    declaration.asserted = asserted;
    declaration.mechanism = Some(mechanism);
}

fn lower_mechanism(
    declaration: &mut Declaration,
    mechanism: &Mechanism,
    scope: &mut Scope,
    dimensions: &Dimensions,
    report: &mut Report,
) {
    if let Some(matrix) = declaration.matrices.first() {
        let message = format!(
            "`{0}` beside a mechanism, from which it follows: expected `assert {0} == …` to have both compared",
            matrix.name.name()
        );
        report.error(matrix.span, message);
    }
    let is_light = declaration.parameters.iter().all(|parameter| parameter.gravity.is_none());
    if let Some(wheel) = mechanism.wheels.first().filter(|_| is_light) {
        let message = format!(
            "nothing presses the wheel `{}` onto the ground: expected a parameter that is the field strength, `g: N/kg, \
             >= 0, gravity;`",
            wheel.name
        );
        report.error(&wheel.name, message);
    }
    let tree = tree::tree(mechanism, report);
    // Mistakes of the definitions are reported where all definitions are checked.
    let mut elsewhere = Report::default();
    let resolved = definitions::resolve(declaration, scope, &mut elsewhere);
    let order = if resolved.cyclic { &[] } else { &resolved.order[..] };
    let defined = units::check(declaration, dimensions, scope, order, &mut elsewhere);
    units::check_mechanism(declaration, mechanism, dimensions, scope, defined, report);
    let new = resolved.new_positions();
    let assembled = assemble::assemble(declaration, mechanism, tree.as_ref(), &new, scope, report);
    let (Some(tree), Some(assembled)) = (tree, assembled) else { return };
    // Without coordinates it is not known what is determined by others.
    if declaration.coordinates.is_empty() || !report.is_empty() || !elsewhere.is_empty() {
        return;
    }
    let known = resolved.in_order(declaration);
    let (known_names, known_values): (Vec<Ident>, Vec<Formula>) = known.into_iter().unzip();
    let parameters: Vec<Ident> = declaration.parameters.iter().map(|parameter| parameter.name.clone()).collect();
    let mut names = Names { parameters, definitions: known_names, span: mechanism.span };
    let attributes = mechanism.formulas().map(|formula| resolve::expression(formula, scope, &mut elsewhere));
    let attributes = attributes.map(|expr| expr.renumbered(&new)).collect();
    let written = Written { parameters: names.parameters.len(), definitions: known_values.clone(), attributes };
    match mechanics::derive(assembled, written) {
        Err(failure) => report.error(region(mechanism, &names, &failure), failure),
        Ok(Err(faults)) => {
            faults::Place { declaration, mechanism, tree: &tree, names: &names }.report(&faults, report);
        }
        Ok(Ok(derived)) => {
            let taken = declared(declaration);
            let first = names.definitions.len();
            names.definitions.extend(unique(&derived, taken, mechanism));
            let values = known_values.into_iter().chain(derived.definitions.iter().map(|(_, value)| value.clone()));
            let all: Vec<(Ident, Formula)> = names.definitions.iter().cloned().zip(values).collect();
            let results = results(&derived, mechanism, &tree);
            let needed = Equations::of_formulas(names.parameters.len(), &all, results).origins;
            let definitions = needed.into_iter().filter(|index| *index >= first).map(|index| Definition {
                name: all[index].0.clone(),
                value: names.expression(&all[index].1),
                derived: true,
            });
            for definition in definitions {
                scope.derived(&definition.name, declaration.definitions.len());
                declaration.definitions.push(definition);
            }
            declaration.matrices = matrices(&derived, mechanism, &names);
            declaration.kinematics = Some(kinematics(&derived, mechanism, &tree, &names));
        }
    }
}

/// Where in the declaration a failure belongs.
fn region(mechanism: &Mechanism, names: &Names, failure: &Failure) -> Region {
    match failure {
        Failure::Undefined { place: Place::Definition(index), .. } => Region::from(&names.definitions[*index]),
        Failure::Undefined { place: Place::Output(index), .. } => {
            mechanism.formulas().nth(*index).map_or(mechanism.span.into(), |formula| formula.region)
        }
        Failure::Engine(_) => mechanism.span.into(),
    }
}

/// The formulas of the results that become a part of the model.
fn results(derived: &Derived, mechanism: &Mechanism, tree: &Tree) -> Vec<Formula> {
    let entries = derived.matrices.iter().flat_map(|(_, rows)| rows.iter().flatten());
    let told = derived.rates.iter().filter(|rate| called(tree.joints[rate.joint].role, mechanism).is_some());
    let rates =
        told.flat_map(|rate| [&rate.speed, &rate.heading].into_iter().chain(&rate.rates).chain(&rate.coordinates));
    entries.chain(rates).chain(derived.forces.iter().flatten()).cloned().collect()
}

/// All names of a declaration.
fn declared(declaration: &Declaration) -> HashSet<String> {
    let Declaration { parameters, definitions, coordinates, .. } = declaration;
    let names = parameters.iter().map(|parameter| &parameter.name);
    let names = names.chain(definitions.iter().map(|definition| &definition.name));
    names.chain(coordinates.iter().map(|coordinate| &coordinate.name)).map(Ident::to_string).collect()
}

/// Names for the definitions of the derivation that no other has.
fn unique(derived: &Derived, mut taken: HashSet<String>, mechanism: &Mechanism) -> Vec<Ident> {
    let name = |(name, _): &(String, Formula)| {
        let mut unique = name.clone();
        while !taken.insert(unique.clone()) {
            unique.push('_');
        }
        Ident::new(&unique, mechanism.span)
    };
    derived.definitions.iter().map(name).collect()
}

fn matrices(derived: &Derived, mechanism: &Mechanism, names: &Names) -> Vec<Matrix> {
    let region = Region::from(mechanism.span);
    let matrices = derived.matrices.iter().map(|(name, rows)| Matrix {
        name: *name,
        symmetric: rows.len() > 1
            && (0..rows.len()).all(|row| (0..row).all(|column| rows[row][column] == rows[column][row])),
        span: mechanism.span,
        rows: rows.iter().map(|row| (region, row.iter().map(|entry| names.expression(entry)).collect())).collect(),
        region,
    });
    matrices.collect()
}

fn kinematics(derived: &Derived, mechanism: &Mechanism, tree: &Tree, names: &Names) -> Kinematics<Expression> {
    let formula = |expr: &Formula| names.expression(expr);
    let all = |row: &[Formula]| row.iter().map(formula).collect();
    let rates = derived.rates.iter().filter_map(|rate| {
        let (name, docs) = called(tree.joints[rate.joint].role, mechanism)?;
        Some(Rate {
            name,
            docs,
            speed: formula(&rate.speed),
            rates: all(&rate.rates),
            coordinates: all(&rate.coordinates),
            heading: formula(&rate.heading),
        })
    });
    let applied = mechanism.forces.iter().map(|force| {
        let label = force.label.clone().unwrap_or_else(|| force.name.to_string());
        [force.name.to_string(), label, force_unit(mechanism, &force.on).into()]
    });
    let called = |name: &Ident, label: &Option<String>| match label {
        Some(label) => format!("`{name}` ({label})"),
        None => format!("`{name}`"),
    };
    let bodies = mechanism.bodies.iter().map(|body| format!("body {}", called(&body.name, &body.label)));
    let wheels = mechanism.wheels.iter().map(|wheel| format!("wheel {}", called(&wheel.name, &wheel.label)));
    Kinematics {
        parts: bodies.chain(wheels).collect(),
        rates: rates.collect(),
        applied: applied.collect(),
        forces: derived.forces.iter().map(|row| all(row)).collect(),
    }
}

/// The unit of a force or torque on a joint.
fn force_unit(mechanism: &Mechanism, on: &Ident) -> &'static str {
    let slides = mechanism.joints.iter().any(|joint| joint.name == *on && joint.kind == JointKind::Prismatic);
    let mut freedoms = mechanism.free.iter().flat_map(|free| &free.names);
    let moves = freedoms.any(|(freedom, name)| name == on && matches!(freedom, Freedom::Lateral | Freedom::Vertical));
    if slides || moves { "N" } else { "N*m" }
}

/// The name of a rate in generated code, and what it is; none for what does not move in the first order.
fn called(role: Role, mechanism: &Mechanism) -> Option<(String, String)> {
    match role {
        Role::Forward | Role::Freedom(Freedom::Vertical | Freedom::Pitch) => None,
        Role::Freedom(freedom) => {
            let body = mechanism.free.first().map(|free| free.body.to_string()).unwrap_or_default();
            let (name, what) = match freedom {
                Freedom::Lateral => ("lateral", "Lateral velocity, to the right, in m/s: of the point of"),
                Freedom::Yaw => ("yaw", "Yaw rate, to the right, in rad/s: of"),
                _ => (freedom.word(), "Rate, in rad/s: of"),
            };
            let at = if freedom == Freedom::Lateral { " that is at the origin" } else { "" };
            Some((name.into(), format!("{what} `{body}`{at}.")))
        }
        Role::Joint(index) => {
            let joint = &mechanism.joints[index];
            let unit = if joint.kind == JointKind::Revolute { "rad/s" } else { "m/s" };
            Some((joint.name.to_string(), format!("Rate of `{}`, in {unit}.", joint.name)))
        }
        Role::Spin(index) => {
            let wheel = &mechanism.wheels[index];
            let label = wheel.label.clone().map(|label| format!(", {label}")).unwrap_or_default();
            let what = "about the y axis, so negative in forward motion, in rad/s";
            Some((format!("wheel_{}", wheel.name), format!("Spin of the wheel `{}`{label}: {what}.", wheel.name)))
        }
    }
}

/// What a freedom is, as a noun.
fn noun(freedom: Freedom) -> &'static str {
    match freedom {
        Freedom::Lateral => "lateral motion",
        Freedom::Vertical => "vertical motion",
        other => other.word(),
    }
}
