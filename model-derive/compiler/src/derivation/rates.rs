//! What the rates and forces of a mechanism are called in generated code.

use proc_macro2::Ident;

use super::motion::spin_name;
use crate::check::{Role, Tree};
use crate::formula::Formula;
use crate::kinematics::{Applied, Kinematics, Rate};
use crate::mechanics::{self, Derivation};
use crate::syntax::{Declaration, Freedom, JointKind, Mechanism};

/// The rates and forces of a derivation, with names and documentation for generated code.
pub fn name_rates(derivation: &Derivation, mechanism: &Mechanism, tree: &Tree) -> Kinematics<Formula> {
    let rates = derivation.rates.iter().filter_map(|rate| {
        let (name, docs) = name_rate(tree.joints[rate.joint].role, mechanism)?;
        let mechanics::Rate { speed, rates, coordinates, heading, .. } = rate.clone();
        Some(Rate { name, docs, speed, rates, coordinates, heading })
    });
    Kinematics {
        parts: name_parts(mechanism),
        rates: rates.collect(),
        applied: name_forces(mechanism),
        forces: derivation.forces.clone(),
    }
}

/// The same of a mechanism from which nothing was derived, for the types that the rest of a file uses: rates of all that is no
/// coordinate, in which every formula is zero.
pub fn outline_rates(declaration: &Declaration, mechanism: &Mechanism) -> Kinematics<Formula> {
    let zeros = |count: usize| vec![Formula::zero(); count];
    let n = declaration.coordinates.len();
    let is_coordinate = |name: &Ident| declaration.coordinates.iter().any(|coordinate| coordinate.name == *name);
    let joints = (0..mechanism.joints.len()).filter(|joint| !is_coordinate(&mechanism.joints[*joint].name));
    let spins = (0..mechanism.wheels.len()).filter(|wheel| mechanism.wheels[*wheel].carrier.is_some());
    let named = |freedom: &Freedom| {
        let mut names = mechanism.free.iter().flat_map(|free| &free.names);
        names.any(|(known, name)| known == freedom && is_coordinate(name))
    };
    let freedoms = Freedom::ALL.into_iter().filter(|freedom| !mechanism.free.is_empty() && !named(freedom));
    let roles = freedoms.map(Role::Freedom).chain(joints.map(Role::Joint)).chain(spins.map(Role::Spin));
    let rates = roles.filter_map(|role| {
        let (name, docs) = name_rate(role, mechanism)?;
        let zero = Formula::zero();
        Some(Rate { name, docs, speed: zero.clone(), rates: zeros(n), coordinates: zeros(n), heading: zero })
    });
    Kinematics {
        parts: name_parts(mechanism),
        rates: rates.collect(),
        applied: name_forces(mechanism),
        forces: vec![zeros(mechanism.forces.len()); n],
    }
}

/// The forces that are applied.
fn name_forces(mechanism: &Mechanism) -> Vec<Applied> {
    let applied = mechanism.forces.iter().map(|force| {
        let is_wheel = mechanism.wheels.iter().any(|wheel| wheel.name == force.on);
        Applied {
            name: force.name.to_string(),
            label: force.label.clone().unwrap_or_else(|| force.name.to_string()),
            unit: mechanism.force_unit(&force.on).into(),
            position: if is_wheel { spin_name(&force.on) } else { force.on.to_string() },
        }
    });
    applied.collect()
}

/// The bodies and wheels, each with what it is.
fn name_parts(mechanism: &Mechanism) -> Vec<String> {
    let labelled = |name: &Ident, label: &Option<String>| match label {
        Some(label) => format!("`{name}` ({label})"),
        None => format!("`{name}`"),
    };
    let bodies = mechanism.bodies.iter().map(|body| format!("body {}", labelled(&body.name, &body.label)));
    let wheels = mechanism.wheels.iter().map(|wheel| format!("wheel {}", labelled(&wheel.name, &wheel.label)));
    bodies.chain(wheels).collect()
}

/// The name of a rate in generated code, and what it is; none for what does not move in the first order.
fn name_rate(role: Role, mechanism: &Mechanism) -> Option<(String, String)> {
    match role {
        Role::Deflection(_) | Role::Freedom(Freedom::Forward | Freedom::Vertical | Freedom::Pitch) => None,
        Role::Freedom(freedom) => {
            let body = mechanism.free.first().map(|free| free.body.to_string()).unwrap_or_default();
            let (name, what) = match freedom {
                Freedom::Lateral => ("lateral", "Lateral velocity, to the right, in `m/s`: of the point of"),
                Freedom::Yaw => ("yaw", "Yaw rate, to the right, in `rad/s`: of"),
                _ => (freedom.word(), "Rate, in `rad/s`: of"),
            };
            let at = if freedom == Freedom::Lateral { " that is at the origin" } else { "" };
            Some((name.into(), format!("{what} `{body}`{at}.")))
        }
        Role::Joint(index) => {
            let joint = &mechanism.joints[index];
            let unit = if joint.kind == JointKind::Revolute { "rad/s" } else { "m/s" };
            Some((joint.name.to_string(), format!("Rate of `{}`, in `{unit}`.", joint.name)))
        }
        Role::Spin(index) => {
            let wheel = &mechanism.wheels[index];
            let label = wheel.label.clone().map(|label| format!(", {label}")).unwrap_or_default();
            let what = "about the y axis, so negative in forward motion, in `rad/s`";
            Some((format!("wheel_{}", wheel.name), format!("Spin of the wheel `{}`{label}: {what}.", wheel.name)))
        }
    }
}
