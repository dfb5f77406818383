//! What is free of the motion of a mechanism, and what positions are called.

use std::collections::HashSet;

use super::attributes::Standing;
use crate::check::{Assembly, Checked, Role};
use crate::formula::Formula;
use crate::free_name::take_free_name;
use crate::mechanics::{Derivation, Motion};
use crate::motion::{MotionModel, Position, PositionKind};
use crate::nonlinear::{Layout, Machine, Undetermined};
use crate::report::Report;
use crate::syntax::{Freedom, Mechanism};

/// The motion of a mechanism, if it is asked for. That it is none of which the equations can be derived is reported.
pub fn describe_motion(
    derivation: &Derivation,
    checked: &Checked<'_>,
    assembly: &Assembly,
    report: &mut Report,
) -> Option<MotionModel> {
    let declaration = checked.declaration;
    let (span, declared) = declaration.nonlinear.zip(declaration.mechanism.as_ref())?;
    let machine = Machine {
        mechanism: assembly.mechanism.clone(),
        unit_axes: derivation.unit_axes.clone(),
        gravity: checked.gravity,
        parameters: declaration.parameters.len(),
        definitions: checked.definitions.clone(),
    };
    if !report.is_empty() {
        return None;
    }
    let layout = match Layout::new(&machine) {
        Ok(layout) => layout,
        Err(Undetermined) => {
            report.error(
                span,
                "the heights of the wheels do not determine what is no coordinate, so that there are no nonlinear equations: \
                 expected a joint for each wheel behind the first that lets it stand on the ground",
            );
            return None;
        }
    };
    Some(MotionModel {
        positions: name_positions(checked, declared, assembly, &layout),
        wheels: declared
            .wheels
            .iter()
            .map(|wheel| [wheel.name.to_string(), wheel.label.clone().unwrap_or_else(|| wheel.name.to_string())])
            .collect(),
        machine,
        layout,
        by_attributes: None,
    })
}

/// The same motion, with the machine by its attributes beside it.
pub fn with_attributes(motion: MotionModel, Standing { mechanism, parameters }: Standing) -> MotionModel {
    let Machine { unit_axes, gravity, parameters: first, definitions, .. } = &motion.machine;
    // An axis by attributes has any length.
    let is_attribute = |part: &Formula| matches!(part, Formula::Parameter(index) if index >= first);
    let is_declared = |axis: &[Formula; 3]| !axis.iter().any(is_attribute);
    let unit_axes = mechanism.joints.iter().zip(unit_axes).map(|(joint, is_unit)| *is_unit && is_declared(&joint.axis));
    let by_attributes = Machine {
        unit_axes: unit_axes.collect(),
        gravity: *gravity,
        parameters,
        definitions: definitions.clone(),
        mechanism,
    };
    MotionModel { by_attributes: Some(by_attributes), ..motion }
}

/// The positions by the names of the coordinates, and what has none as the paper calls it.
fn name_positions(
    checked: &Checked<'_>,
    declared: &Mechanism,
    Assembly { mechanism, tree, .. }: &Assembly,
    layout: &Layout,
) -> Vec<Position> {
    let named = |joint: usize| match tree.joints[joint].role {
        Role::Freedom(freedom) => {
            let mut names = declared.free.iter().flat_map(|free| &free.names);
            names.find(|(known, _)| *known == freedom).map(|(_, name)| name.to_string())
        }
        Role::Joint(index) => Some(declared.joints[index].name.to_string()),
        Role::Spin(_) | Role::Deflection(_) => None,
    };
    let mut taken: HashSet<String> = layout.positions.iter().filter_map(|joint| named(*joint)).collect();
    let describe = |joint: &usize| {
        let role = tree.joints[*joint].role;
        let (default, label) = describe_role(role, declared);
        let name = named(*joint).unwrap_or_else(|| take_free_name(&default, &mut taken));
        let place = mechanism.coordinates.iter().position(|coordinate| coordinate == joint);
        let declared = place.and_then(|place| checked.declaration.coordinates[place].label.clone());
        let is_ignorable =
            matches!(role, Role::Spin(_) | Role::Freedom(Freedom::Forward | Freedom::Lateral | Freedom::Yaw));
        Position {
            label: declared.unwrap_or(if label.is_empty() { name.clone() } else { label }),
            name,
            unit: if mechanism.joints[*joint].motion == Motion::Turns { "rad" } else { "m" },
            kind: match () {
                () if is_ignorable => PositionKind::Ignorable,
                () if layout.standing.contains(joint) => PositionKind::Dependent,
                () => PositionKind::Free,
            },
        }
    };
    layout.positions.iter().map(describe).collect()
}

/// What a position is called that has no name, and what it is.
fn describe_role(role: Role, declared: &Mechanism) -> (String, String) {
    let first = declared.wheels.first();
    let of_contact = |axis: &str| match first.map(|wheel| wheel.label.clone().unwrap_or_else(|| wheel.name.to_string()))
    {
        Some(wheel) => format!("{axis} of the contact point of the {wheel}"),
        None => String::new(),
    };
    match role {
        Role::Freedom(Freedom::Forward) => ("x".into(), of_contact("x")),
        Role::Freedom(Freedom::Lateral) => ("y".into(), of_contact("y")),
        Role::Freedom(Freedom::Vertical) => ("z".into(), String::new()),
        Role::Freedom(Freedom::Yaw) => ("psi".into(), "yaw".into()),
        Role::Freedom(Freedom::Lean) => ("phi".into(), "lean".into()),
        Role::Freedom(Freedom::Pitch) => ("pitch".into(), "pitch".into()),
        Role::Joint(_) | Role::Deflection(_) => (String::new(), String::new()),
        Role::Spin(index) => {
            let wheel = &declared.wheels[index];
            let label = wheel.label.clone().unwrap_or_else(|| format!("wheel {}", wheel.name));
            (spin_name(&wheel.name), format!("angle of the {label}"))
        }
    }
}

/// The name of the angle of a wheel.
pub fn spin_name(wheel: &proc_macro2::Ident) -> String {
    format!("theta{wheel}")
}
