//! Which body hangs on which: a tree, whose root is the ground or a free body.

use proc_macro2::Ident;

use super::attachments::{Attachments, Hold};
use crate::report::Report;
use crate::syntax::{Freedom, Mechanism};

/// The joints of a mechanism in an order in which each hangs on an earlier one, and what they move.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    pub joints: Vec<Node>,
    /// For each body the joint that moves it, and behind them for each wheel its spin.
    pub moved_by: Vec<usize>,
}

impl Tree {
    /// What a joint is called: by its coordinate, or by the wheel whose axle it is.
    pub fn name<'a>(&self, mechanism: &'a Mechanism, joint: usize) -> Option<&'a Ident> {
        match self.joints[joint].role {
            Role::Joint(index) => Some(&mechanism.joints[index].name),
            Role::Freedom(freedom) => {
                let names = &mechanism.free.first()?.names;
                names.iter().find(|(known, _)| *known == freedom).map(|(_, name)| name)
            }
            Role::Deflection(index) => mechanism.wheels[index].deflection(),
            Role::Spin(index) => Some(&mechanism.wheels[index].name),
        }
    }

    /// The joint of a name.
    pub fn find_joint(&self, mechanism: &Mechanism, name: &Ident) -> Option<usize> {
        (0..self.joints.len()).find(|joint| self.name(mechanism, *joint) == Some(name))
    }

    /// How many joints are freedoms of the free body.
    pub fn root(&self) -> usize {
        self.joints.iter().filter(|node| matches!(node.role, Role::Freedom(_))).count()
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Node {
    pub role: Role,
    pub parent: Option<usize>,
}

/// Where a joint comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Of a free body.
    Freedom(Freedom),
    /// At a position of the declaration.
    Joint(usize),
    /// The axle of the wheel at a position.
    Spin(usize),
    /// The deflection of the tyre of the wheel at a position, which moves nothing else.
    Deflection(usize),
}

/// Grows the tree, unless there are mistakes in it, which are reported.
pub fn grow(mechanism: &Mechanism, report: &mut Report) -> Option<Tree> {
    let names: Vec<&Ident> = mechanism
        .bodies
        .iter()
        .map(|body| &body.name)
        .chain(mechanism.wheels.iter().map(|wheel| &wheel.name))
        .collect();
    if names.is_empty() && mechanism.unread.is_empty() {
        report.error(mechanism.span, "a mechanism without a `body` or a `wheel`: expected at least one");
        return None;
    }
    let mut attachments = Attachments::new(mechanism, &names, report);
    attachments.read(report);
    // What could not be read may be what seems to be missing.
    if !mechanism.unread.is_empty() || !report.is_empty() {
        return None;
    }
    attachments.grow_joints(report)
}

impl Attachments<'_> {
    /// Joints from the root outward.
    fn grow_joints(&self, report: &mut Report) -> Option<Tree> {
        let mechanism = self.mechanism;
        let mut tree = Tree::default();
        let mut moved_by: Vec<Option<Option<usize>>> = vec![None; self.bodies];
        let is_free = |name: &Ident| mechanism.free.first().is_some_and(|free| free.body == *name);
        let mut last = None;
        if let Some(free) = mechanism.free.first() {
            let wheel = mechanism.wheels.iter().any(|wheel| wheel.name == free.body);
            // A wheel that is free itself turns about its axle instead of pitching.
            let freedoms = Freedom::ALL.into_iter().filter(|freedom| !wheel || *freedom != Freedom::Pitch);
            for role in freedoms.map(Role::Freedom) {
                tree.joints.push(Node { role, parent: last });
                last = Some(tree.joints.len() - 1);
            }
        }
        loop {
            let mut grown = false;
            for body in 0..self.bodies {
                if moved_by[body].is_some() {
                    continue;
                }
                let base = |base: Option<usize>| base.map_or(Some(None), |base| moved_by[base]);
                let by = match self.holds[body] {
                    None => continue,
                    Some((Hold::Free, _)) => Some(last),
                    Some((Hold::Fixed(to), _)) => base(to),
                    Some((Hold::Joint(joint, parent), _)) => base(parent).map(|parent| {
                        mechanism.chain(joint).fold(parent, |parent, joint| {
                            tree.joints.push(Node { role: Role::Joint(joint), parent });
                            Some(tree.joints.len() - 1)
                        })
                    }),
                };
                moved_by[body] = by;
                grown |= by.is_some();
            }
            if !grown {
                break;
            }
        }
        for (body, moved) in moved_by.iter().enumerate() {
            if moved.is_none() {
                self.report_loose(body, report);
            }
        }
        for (index, wheel) in mechanism.wheels.iter().enumerate() {
            let carrier = match &wheel.carrier {
                Some(carrier) => self.known.get(&carrier.to_string()).and_then(|body| moved_by[*body]),
                None if is_free(&wheel.name) => Some(last),
                None => {
                    let name = &wheel.name;
                    let message = format!(
                        "the wheel `{name}` is not attached: expected `on` and the body that carries it{}",
                        self.or_free(name)
                    );
                    report.error(name, message);
                    None
                }
            };
            let Some(parent) = carrier else { continue };
            let mut above = std::iter::successors(parent, |joint| tree.joints[*joint].parent);
            if !above.any(|joint| tree.joints[joint].role == Role::Freedom(Freedom::Forward)) {
                let message = format!(
                    "the wheel `{}` is on what joints hold to the ground: expected it on a free body that rolls over the \
                     ground, or on what hangs on that",
                    wheel.name
                );
                report.error(&wheel.name, message);
            }
            tree.joints.push(Node { role: Role::Spin(index), parent });
        }
        let deflections = mechanism.wheels.iter().enumerate().filter(|(_, wheel)| wheel.deflection().is_some());
        tree.joints.extend(deflections.map(|(index, _)| Node { role: Role::Deflection(index), parent: None }));
        let bodies: Option<Vec<usize>> = moved_by.into_iter().flatten().collect();
        let spins = (0..tree.joints.len()).filter(|joint| matches!(tree.joints[*joint].role, Role::Spin(_)));
        let moved_by: Vec<usize> = bodies?.into_iter().chain(spins).collect();
        if moved_by.len() < self.names.len() || !report.is_empty() {
            return None;
        }
        tree.moved_by = moved_by;
        Some(tree)
    }

    /// The other way to attach something, where nothing else is free.
    fn or_free(&self, name: &Ident) -> String {
        if self.mechanism.free.is_empty() { format!(", or `free {name};`") } else { String::new() }
    }

    /// Reports a body that no chain of joints leads to.
    fn report_loose(&self, body: usize, report: &mut Report) {
        let name = self.names[body];
        let Some((_, by)) = self.holds[body] else {
            let message = format!(
                "`{name}` is not attached: expected a joint `… to {name}`, or `fix {name} to …;`{}",
                self.or_free(name)
            );
            report.error(name, message);
            return;
        };
        let base = |body: usize| match self.holds[body] {
            Some((Hold::Joint(_, Some(base)) | Hold::Fixed(Some(base)), _)) => Some(base),
            _ => None,
        };
        let chain: Vec<usize> = std::iter::successors(base(body), |body| base(*body)).take(self.bodies).collect();
        // What hangs on a body that is not attached, or on a loop, is no mistake of its own.
        if chain.contains(&body) && chain.iter().all(|other| *other >= body) {
            let length = chain.iter().position(|other| *other == body).unwrap_or(0) + 1;
            let names: Vec<String> = chain[..length].iter().map(|body| format!("`{}`", self.names[*body])).collect();
            let message = format!(
                "a loop of joints: `{name}` hangs on {}; expected a chain that ends at the ground or at a free body",
                names.join(", which hangs on ")
            );
            report.error(by, message);
        }
    }
}
