//! What the derivation finds wrong with a mechanism, in the words of the declaration.

use super::tree::{Role, Tree};
use super::written::Names;
use crate::check::resolve;
use crate::mechanics::{Fault, Ground};
use crate::report::{Region, Report};
use crate::syntax::{Declaration, Mechanism};

pub struct Place<'a> {
    pub declaration: &'a Declaration,
    pub mechanism: &'a Mechanism,
    pub tree: &'a Tree,
    pub names: &'a Names,
}

impl Place<'_> {
    pub fn report(&self, fault: &Fault, report: &mut Report) {
        let (region, message) = self.message(fault);
        report.error(region, message);
    }

    fn message(&self, fault: &Fault) -> (Region, String) {
        match fault {
            Fault::NoAxis { joint } => {
                let message = format!("the axis of {} has no length: expected a direction", self.joint(*joint));
                let along = match self.tree.joints[*joint].role {
                    Role::Joint(index) => self.mechanism.joints[index].along.region,
                    _ => self.region(*joint),
                };
                (along, message)
            }
            Fault::OffGround { wheel, below } => {
                let wheel = &self.mechanism.wheels[*wheel];
                let [_, _, height] = &wheel.centre.components;
                let message = format!(
                    "the wheel `{}` is not on the ground, z = 0: its lowest point is at z = {}; expected a centre at z = -{}",
                    wheel.name,
                    resolve::text(&self.names.expression(below)),
                    enclosed(&resolve::text(&wheel.radius)),
                );
                (height.region, message)
            }
            Fault::Tied { ground, joints } => self.tied(*ground, joints),
            Fault::Undetermined(joints) => {
                let message = format!(
                    "more freedoms than coordinates: nothing determines {}; expected coordinates for them, or wheels",
                    self.list(joints)
                );
                (joints.first().map_or(self.model(), |joint| self.region(*joint)), message)
            }
            Fault::Unbalanced { joint, force } => {
                let what = match self.tree.joints[*joint].role {
                    Role::Forward | Role::Freedom(crate::syntax::Freedom::Lateral) => "the force",
                    Role::Freedom(crate::syntax::Freedom::Vertical) => "the weight",
                    _ => "gravity, which would move it,",
                };
                let message = format!(
                    "the reference state is no steady motion: {what} at {} is g*{}, and nothing balances it; expected 0",
                    self.joint(*joint),
                    enclosed(&resolve::text(&self.names.expression(force))),
                );
                (self.region(*joint), message)
            }
            Fault::Coupled { joint } => {
                let message = format!(
                    "{} speeds the mechanism up or slows it down, and the speed v is a constant: expected coordinates that \
                     leave the forward motion alone",
                    self.joint(*joint)
                );
                (self.region(*joint), message)
            }
            Fault::Remains { joint } => {
                let message = format!(
                    "the motion depends on {}, which the coordinates do not determine: expected it among the coordinates",
                    self.joint(*joint)
                );
                (self.region(*joint), message)
            }
            Fault::Massless { joint } => {
                let message = format!(
                    "a singular mass matrix: {} can move without moving any mass; expected masses or moments of inertia \
                     behind every coordinate",
                    self.joint(*joint)
                );
                (self.region(*joint), message)
            }
            Fault::Dragged { joint } => {
                let message = format!(
                    "a damper at a joint that the wheels turn makes a force proportional to v times {}, which the equations \
                     of motion have no place for: expected dampers at joints that are coordinates",
                    self.joint(*joint)
                );
                (self.region(*joint), message)
            }
        }
    }

    fn tied(&self, ground: Ground, joints: &[usize]) -> (Region, String) {
        let (Ground::Height(index) | Ground::Sideways(index) | Ground::Along(index)) = ground;
        let name = &self.mechanism.wheels[index].name;
        let condition = match ground {
            Ground::Height(_) => format!("that the wheel `{name}` stays on the ground"),
            Ground::Sideways(_) => format!("that the wheel `{name}` does not slip sideways"),
            Ground::Along(_) => format!("that the wheel `{name}` rolls"),
        };
        let message = match joints {
            [] => format!(
                "{condition} follows from the other wheels: its load cannot be determined; expected a suspension, or fewer \
                 wheels"
            ),
            _ => format!(
                "{condition} leaves {} no freedom: expected coordinates that are independent, and no more wheels than \
                 joints let move",
                self.list(joints)
            ),
        };
        (Region::from(name), message)
    }

    fn list(&self, joints: &[usize]) -> String {
        joints.iter().map(|joint| self.joint(*joint)).collect::<Vec<_>>().join(", ")
    }

    /// What a joint is called in a message.
    fn joint(&self, joint: usize) -> String {
        match self.tree.joints[joint].role {
            Role::Forward => "the forward motion".into(),
            Role::Spin(wheel) => format!("the spin of `{}`", self.mechanism.wheels[wheel].name),
            Role::Joint(index) => format!("`{}`", self.mechanism.joints[index].name),
            Role::Freedom(freedom) => {
                let free = self.mechanism.free.first();
                let body = free.map(|free| free.body.to_string()).unwrap_or_default();
                match free.and_then(|free| free.names.iter().find(|(known, _)| *known == freedom)) {
                    Some((_, name)) => format!("`{name}`, the {} of `{body}`", super::noun(freedom)),
                    None => format!("the {} of `{body}`", super::noun(freedom)),
                }
            }
        }
    }

    fn region(&self, joint: usize) -> Region {
        match self.tree.joints[joint].role {
            Role::Spin(wheel) => Region::from(&self.mechanism.wheels[wheel].name),
            Role::Joint(index) => Region::from(&self.mechanism.joints[index].name),
            Role::Forward | Role::Freedom(_) => {
                self.mechanism.free.first().map_or(self.model(), |free| Region::from(&free.body))
            }
        }
    }

    fn model(&self) -> Region {
        Region::from(&self.declaration.name)
    }
}

fn enclosed(text: &str) -> String {
    let plain = text.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '.');
    if plain { text.to_string() } else { format!("({text})") }
}
