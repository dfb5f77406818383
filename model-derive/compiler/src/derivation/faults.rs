//! What the derivation finds wrong with a mechanism, in the words of the declaration.

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::check::{Role, Tree};
use crate::formula::{Factor, Formula, Names};
use crate::mechanics::{Fault, Ground};
use crate::report::{Region, Report};
use crate::syntax::{Axis, Declaration, Freedom, JointKind, Mechanism};

/// The declaration that faults are told of.
pub struct Faulty<'a> {
    pub declaration: &'a Declaration,
    pub mechanism: &'a Mechanism,
    pub tree: &'a Tree,
    pub names: &'a Names,
}

impl Faulty<'_> {
    /// Reports faults, but of those that follow from one mistake only the first.
    pub fn report(&self, faults: &[Fault], report: &mut Report) {
        let mut told = HashSet::new();
        for fault in faults.iter().filter(|fault| !self.follows(fault, faults)) {
            if joint_of(fault).is_none_or(|joint| told.insert(joint)) {
                let (region, message) = self.message(fault);
                report.error(region, message);
            }
        }
    }

    /// Whether a force is unbalanced because another one is: what moves a joint also moves those that it hangs on, and a
    /// body that nothing bears falls before it turns.
    fn follows(&self, fault: &Fault, faults: &[Fault]) -> bool {
        let Fault::Unbalanced { joint, .. } = fault else { return false };
        let falls = |joint: usize| self.tree.joints[joint].role == Role::Freedom(Freedom::Vertical);
        let all = || faults.iter().filter_map(joint_of);
        if all().any(falls) {
            return !falls(*joint);
        }
        all().filter(|other| other != joint).any(|other| {
            let mut above = std::iter::successors(Some(other), |other| self.tree.joints[*other].parent);
            above.any(|above| above == *joint)
        })
    }

    fn message(&self, fault: &Fault) -> (Region, String) {
        match fault {
            Fault::NoAxis { joint } => {
                let axis = match self.tree.joints[*joint].role {
                    Role::Joint(index) => Some(&self.mechanism.joints[index].axis),
                    _ => None,
                };
                let name = self.joint(*joint);
                match axis {
                    Some(Axis::Normal) => {
                        let message = format!(
                            "{name} turns in no plane, as both of the slides before it are along one line: expected two \
                             directions that span one"
                        );
                        (self.region(*joint), message)
                    }
                    _ => {
                        let region = axis.and_then(Axis::along).map_or(self.region(*joint), |along| along.region);
                        (region, format!("the axis of {name} has no length: expected a direction"))
                    }
                }
            }
            Fault::OffGround { wheel, below } => {
                let wheel = &self.mechanism.wheels[*wheel];
                let [_, _, height] = &wheel.centre.components;
                let message = format!(
                    "the wheel `{}` is not on the ground, z = 0: its lowest point is at z = `{}`; expected its centre at \
                     z = `-{}`",
                    wheel.name,
                    self.text(below),
                    enclosed(&wheel.radius.to_string()),
                );
                (height.region, message)
            }
            Fault::Short { link } => {
                let link = &self.mechanism.links[*link];
                let message = format!(
                    "the link `{}` is between two points that are one, so it has no direction: expected points apart in the \
                     reference configuration",
                    link.name
                );
                (Region::from(&link.name), message)
            }
            Fault::Tied { ground, joints } => self.tied(*ground, joints),
            Fault::Undecided { ground } => {
                let (Ground::Height(index) | Ground::Sideways(index) | Ground::Along(index)) = *ground;
                let name = &self.mechanism.wheels[index].name;
                let message = format!(
                    "it could not be decided whether the wheel `{name}` adds a constraint to those of the other wheels: \
                     formulas in their places differ by what is not proved to be zero; expected the same formula for \
                     equal lengths and angles"
                );
                (Region::from(name), message)
            }
            Fault::Undetermined(joints) => {
                let is_sprung = |joint: &usize| match self.tree.joints[*joint].role {
                    Role::Joint(index) => self.mechanism.joints[index].spring.is_some(),
                    _ => false,
                };
                let slips = self.mechanism.wheels.iter().any(|wheel| wheel.slip.is_some());
                let is_carried = |joint: &usize| {
                    matches!(self.tree.joints[*joint].role, Role::Freedom(Freedom::Lateral | Freedom::Yaw))
                };
                let hint = if joints.iter().any(is_sprung) {
                    "; as a coordinate of its own a joint has its weight carried by its spring"
                } else if slips && joints.iter().any(is_carried) {
                    "; on tyres that slip, lateral motion and yaw are coordinates, `free …: lateral y, yaw psi`"
                } else {
                    ""
                };
                let expected = match joints.len() {
                    1 => "a coordinate for it, or a wheel that determines it",
                    _ => "coordinates for them, or wheels that determine them",
                };
                let message = format!(
                    "more freedoms than coordinates: nothing determines {}; expected {expected}{hint}",
                    self.list(joints)
                );
                (joints.first().map_or(self.model(), |joint| self.region(*joint)), message)
            }
            Fault::Unbalanced { joint, force } => {
                let (kind, of) = if self.turns(*joint) { ("moment", "about") } else { ("force", "along") };
                let balance = match self.mechanism.wheels.is_empty() {
                    true => "and nothing balances it",
                    false => "which the loads of the wheels do not balance",
                };
                let message = format!(
                    "the reference state is no steady motion: gravity makes the {kind} `{}` {of} {}, {balance}; expected \
                     0{}",
                    self.times_gravity(force),
                    self.joint(*joint),
                    self.as_carried(),
                );
                (self.region(*joint), message)
            }
            Fault::Coupled { joint } => {
                let message = format!(
                    "{} speeds the mechanism up or slows it down, and the speed v is a constant: expected coordinates that \
                     leave the forward motion alone, that motion among the coordinates, `free …: forward x`, or the \
                     statement `hold forward;`",
                    self.joint(*joint)
                );
                (self.region(*joint), message)
            }
            Fault::Remains { joint } => {
                let message = format!(
                    "the motion depends on {}, which the coordinates do not determine: expected it among the coordinates{}",
                    self.joint(*joint),
                    self.as_first_order(*joint)
                );
                (self.region(*joint), message)
            }
            Fault::Massless { joint, along } => {
                let message = format!(
                    "a singular mass matrix: {} can move{} without moving any mass; expected masses or moments of \
                     inertia that every motion of the coordinates moves",
                    self.joint(*joint),
                    self.moving_along(along),
                );
                (self.region(*joint), message)
            }
            Fault::PerhapsMassless { joint, along } => {
                let message = format!(
                    "it could not be decided whether {} can move{} without moving any mass: the mass matrix is singular \
                     for all values that were tried, which is not proved for all others; expected masses or moments of \
                     inertia that every motion of the coordinates moves",
                    self.joint(*joint),
                    self.moving_along(along),
                );
                (self.region(*joint), message)
            }
        }
    }

    fn tied(&self, ground: Ground, joints: &[usize]) -> (Region, String) {
        let (Ground::Height(index) | Ground::Sideways(index) | Ground::Along(index)) = ground;
        let wheel = &self.mechanism.wheels[index];
        let name = &wheel.name;
        let condition = match ground {
            Ground::Height(_) => "stays on the ground",
            Ground::Sideways(_) => "does not slip sideways",
            // Nothing else keeps its spin from following.
            Ground::Along(_) => {
                let message =
                    format!("the wheel `{name}` has no radius, so it cannot roll: expected one that is not 0");
                return (wheel.radius.region, message);
            }
        };
        let message = match joints {
            [] => format!(
                "too many constraints: that the wheel `{name}` {condition} follows from the other wheels, so its load \
                 cannot be determined; expected a suspension, or fewer wheels"
            ),
            _ => format!(
                "too many constraints: as the wheel `{name}` {condition}, {} cannot move{}; expected independent \
                 coordinates, or fewer wheels{}",
                self.list(joints),
                if joints.len() == 1 { "" } else { " independently" },
                self.leave_out(joints),
            ),
        };
        (Region::from(name), message)
    }

    /// What to say of joints whose springs would carry weight if they were coordinates.
    fn as_carried(&self) -> String {
        let is_coordinate = |name: &Ident| self.declaration.coordinates.iter().any(|known| known.name == *name);
        let sprung = self.mechanism.joints.iter().filter(|joint| joint.spring.is_some() && !is_coordinate(&joint.name));
        let names: Vec<String> = sprung.map(|joint| format!("`{}`", joint.name)).collect();
        match &names[..] {
            [] => String::new(),
            [name] => format!("; as a coordinate {name} has the weight on it carried by its spring"),
            _ => format!("; as coordinates {} have the weight on them carried by their springs", names.join(", ")),
        }
    }

    /// How a joint that the wheels turn can be a coordinate.
    fn as_first_order(&self, joint: usize) -> String {
        let unit = if self.turns(joint) { "rad" } else { "m" };
        match (self.tree.joints[joint].role, self.coordinate(joint)) {
            (Role::Spin(_), _) => String::new(),
            (_, Some(name)) => format!(", `{name}: {unit}, only position;`, as the wheels determine how it moves"),
            (_, None) => format!(", by a name, and with `{unit}, only position`, as the wheels determine how it moves"),
        }
    }

    /// What is said of joints that move with another one, if there are any.
    fn moving_along(&self, joints: &[usize]) -> String {
        if joints.is_empty() { String::new() } else { format!(", with {} moving along,", self.list(joints)) }
    }

    /// What to say of motions of a free body among joints that a wheel holds.
    fn leave_out(&self, joints: &[usize]) -> String {
        let is_free = |joint: &&usize| matches!(self.tree.joints[**joint].role, Role::Freedom(_));
        match (joints.iter().find(is_free), self.mechanism.free.first()) {
            (Some(_), Some(free)) => {
                format!("; leave out of `free {}` what the wheels determine", free.body)
            }
            _ => String::new(),
        }
    }

    fn list(&self, joints: &[usize]) -> String {
        let names: Vec<String> = joints.iter().map(|joint| self.joint(*joint)).collect();
        match names.split_last() {
            Some((last, others)) if !others.is_empty() => format!("{} and {last}", others.join(", ")),
            _ => names.concat(),
        }
    }

    /// A force over gravity, with that.
    fn times_gravity(&self, force: &Formula) -> String {
        let gravity = self.declaration.parameters.iter().position(|parameter| parameter.gravity.is_some());
        let mut factors = vec![Factor::times(gravity.map_or(Formula::one(), Formula::Parameter))];
        match force {
            Formula::Product(others) => factors.extend(others.iter().cloned()),
            other => factors.push(Factor::times(other.clone())),
        }
        self.text(&Formula::Product(factors))
    }

    fn text(&self, formula: &Formula) -> String {
        self.names.text_in_order(formula).to_string()
    }

    /// The name of the coordinate that is the motion of a joint.
    fn coordinate(&self, joint: usize) -> Option<&Ident> {
        let is_spin = matches!(self.tree.joints[joint].role, Role::Spin(_));
        self.tree.name(self.mechanism, joint).filter(|_| !is_spin)
    }

    fn turns(&self, joint: usize) -> bool {
        match self.tree.joints[joint].role {
            Role::Joint(index) => self.mechanism.joints[index].kind == JointKind::Revolute,
            Role::Deflection(_) | Role::Freedom(Freedom::Forward | Freedom::Lateral | Freedom::Vertical) => false,
            Role::Freedom(_) | Role::Spin(_) => true,
        }
    }

    /// What a joint is called in a message.
    fn joint(&self, joint: usize) -> String {
        match self.tree.joints[joint].role {
            Role::Spin(wheel) => format!("the spin of `{}`", self.mechanism.wheels[wheel].name),
            Role::Deflection(wheel) => format!("the deflection of the tyre of `{}`", self.mechanism.wheels[wheel].name),
            Role::Joint(index) => format!("`{}`", self.mechanism.joints[index].name),
            Role::Freedom(freedom) => {
                let body = self.mechanism.free.first().map(|free| free.body.to_string()).unwrap_or_default();
                let noun = freedom.noun();
                match self.coordinate(joint) {
                    Some(name) => format!("`{name}` (the {noun} of `{body}`)"),
                    None => format!("the {noun} of `{body}`"),
                }
            }
        }
    }

    fn region(&self, joint: usize) -> Region {
        if let Some(name) = self.coordinate(joint) {
            return Region::from(name);
        }
        let free = self.mechanism.free.first();
        match self.tree.joints[joint].role {
            Role::Spin(wheel) => Region::from(&self.mechanism.wheels[wheel].name),
            _ => free.map_or(self.model(), |free| Region::from(&free.body)),
        }
    }

    fn model(&self) -> Region {
        Region::from(&self.declaration.name)
    }
}

/// The joint that a fault is of, if it is of one.
fn joint_of(fault: &Fault) -> Option<usize> {
    match fault {
        Fault::NoAxis { joint }
        | Fault::Unbalanced { joint, .. }
        | Fault::Coupled { joint }
        | Fault::Remains { joint }
        | Fault::Massless { joint, .. }
        | Fault::PerhapsMassless { joint, .. } => Some(*joint),
        Fault::Short { .. }
        | Fault::OffGround { .. }
        | Fault::Tied { .. }
        | Fault::Undecided { .. }
        | Fault::Undetermined(_) => None,
    }
}

fn enclosed(text: &str) -> String {
    let plain = text.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '.');
    if plain { text.to_string() } else { format!("({text})") }
}
