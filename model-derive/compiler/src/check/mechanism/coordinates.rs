//! The names of joints and freedoms, which coordinates and forces refer to.

use proc_macro2::Ident;

use super::tree::Role;
use crate::mechanics::Motion;
use crate::nearest::{ask_for, find_nearest};
use crate::report::Report;
use crate::syntax::{Declaration, Freedom, JointKind, Mechanism, Wheel};

/// Finds the names of joints and of freedoms. Coordinates and forces that are of none are reported, unless what is missing may
/// be among other mistakes: if the mechanism is not `complete`.
pub fn find_joints<'a>(
    declaration: &Declaration,
    mechanism: &'a Mechanism,
    complete: bool,
    report: &mut Report,
) -> Vec<(&'a Ident, Role)> {
    let joints = mechanism.joints.iter().enumerate().map(|(index, joint)| (&joint.name, Role::Joint(index)));
    let freedoms = mechanism.free.iter().flat_map(|free| &free.names);
    let freedoms = freedoms.map(|(freedom, name)| (name, Role::Freedom(*freedom)));
    let deflections = mechanism.wheels.iter().enumerate();
    let deflections = deflections.filter_map(|(index, wheel)| Some((wheel.deflection()?, Role::Deflection(index))));
    let mut named: Vec<(&Ident, Role)> = Vec::new();
    let mut complete = complete;
    for (name, role) in joints.chain(freedoms).chain(deflections) {
        if named.iter().any(|(known, _)| *known == name) {
            // The one that it should have been may be a coordinate.
            complete = false;
            report.error(name, format!("`{name}` is the coordinate of two joints: expected one of each name"));
        } else if named.iter().any(|(_, known)| *known == role) {
            report.error(name, format!("a second name, `{name}`, of one freedom: expected one"));
        } else {
            named.push((name, role));
        }
    }
    let hint = |name: &Ident| {
        let known: Vec<String> = named.iter().map(|(known, _)| known.to_string()).collect();
        let near = find_nearest(&name.to_string(), known.iter().map(String::as_str));
        near.map(ask_for).unwrap_or_default()
    };
    for coordinate in &declaration.coordinates {
        let name = &coordinate.name;
        let Some((_, role)) = named.iter().find(|(known, _)| *known == name) else {
            if !complete {
                continue;
            }
            let message = format!(
                "`{name}` is no joint of the mechanism: expected the name of a joint, or of a freedom in `free`{}",
                hint(name)
            );
            report.error(name, message);
            continue;
        };
        let turns = match role {
            Role::Joint(index) => mechanism.joints[*index].kind == JointKind::Revolute,
            Role::Freedom(freedom) => freedom.turns(),
            Role::Deflection(_) => false,
            Role::Spin(_) => continue,
        };
        let (what, expected) = if turns { ("turns", "rad") } else { ("slides", "m") };
        if let Some(unit) = coordinate.unit.as_ref().filter(|unit| unit.text != expected) {
            report.error(unit.region, format!("`{name}` {what}: expected `{expected}`"));
        }
        if coordinate.direction.is_some() {
            let message = format!("the mechanism says how `{name}` {what}: expected no direction here");
            report.error(name, message);
        }
    }
    for deflection in mechanism.wheels.iter().filter_map(Wheel::deflection) {
        if complete && !declaration.coordinates.iter().any(|coordinate| coordinate.name == *deflection) {
            let message = format!(
                "`{deflection}`, the deflection of a tyre, is a coordinate of first order: expected it among the coordinates, \
                 `{deflection}: m;`"
            );
            report.error(deflection, message);
        }
    }
    for force in &mechanism.forces {
        // A coordinate that is no joint is reported already.
        let wheels = mechanism.wheels.iter().map(|wheel| &wheel.name);
        let known =
            named.iter().map(|(name, _)| *name).chain(declaration.coordinates.iter().map(|q| &q.name)).chain(wheels);
        if complete && !known.into_iter().any(|known| *known == force.on) {
            let message = format!(
                "`{}` is no joint of the mechanism: expected the coordinate of one, or a wheel{}",
                force.on,
                hint(&force.on)
            );
            report.error(&force.on, message);
        }
    }
    for (index, force) in mechanism.forces.iter().enumerate() {
        if mechanism.forces[..index].iter().any(|known| known.name == force.name) {
            report.error(&force.name, format!("`{}` is declared twice: expected one force of each name", force.name));
        }
    }
    named
}

/// How a freedom moves, and along or about which axis.
pub fn axis_of(freedom: Freedom) -> (Motion, usize) {
    match freedom {
        Freedom::Forward => (Motion::Slides, 0),
        Freedom::Lateral => (Motion::Slides, 1),
        Freedom::Vertical => (Motion::Slides, 2),
        Freedom::Yaw => (Motion::Turns, 2),
        Freedom::Lean => (Motion::Turns, 0),
        Freedom::Pitch => (Motion::Turns, 1),
    }
}
