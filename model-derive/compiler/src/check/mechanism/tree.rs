//! Which body hangs on which: a tree, whose root is the ground or a free body.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use proc_macro2::Ident;

use crate::nearest::nearest;
use crate::report::Report;
use crate::syntax::{Freedom, Mechanism};

/// The joints of a mechanism in an order in which each hangs on an earlier one, and what they move.
#[derive(Debug, Default)]
pub struct Tree {
    pub joints: Vec<Node>,
    /// For each body the joint that moves it, and behind them for each wheel its spin.
    pub moved_by: Vec<usize>,
}

impl Tree {
    /// How many joints are freedoms of the free body.
    pub fn root(&self) -> usize {
        self.joints.iter().filter(|node| matches!(node.role, Role::Forward | Role::Freedom(_))).count()
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
    /// The motion of a free body along x.
    Forward,
    Freedom(Freedom),
    /// At a position of the declaration.
    Joint(usize),
    /// The axle of the wheel at a position.
    Spin(usize),
}

/// What holds a body.
#[derive(Clone, Copy, Debug)]
enum Hold {
    Free,
    /// A joint, on a body or on the ground.
    Joint(usize, Option<usize>),
    /// Another body, or the ground.
    Fixed(Option<usize>),
}

const GROUND: &str = "ground";

/// The tree, unless there are mistakes in it, which are reported.
pub fn tree(mechanism: &Mechanism, report: &mut Report) -> Option<Tree> {
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
    attachments.grow(report)
}

struct Attachments<'a> {
    mechanism: &'a Mechanism,
    /// The bodies, and behind them the wheels.
    names: &'a [&'a Ident],
    /// How many of them are bodies.
    bodies: usize,
    known: HashMap<String, usize>,
    /// What holds each, with the word of the statement that says so.
    holds: Vec<Option<(Hold, &'a Ident)>>,
}

impl<'a> Attachments<'a> {
    fn new(mechanism: &'a Mechanism, names: &'a [&'a Ident], report: &mut Report) -> Self {
        let mut known = HashMap::new();
        for (index, name) in names.iter().enumerate() {
            if *name == GROUND {
                report.error(*name, "`ground` is what everything stands on: expected another name");
                continue;
            }
            match known.entry(name.to_string()) {
                Entry::Vacant(entry) => {
                    entry.insert(index);
                }
                Entry::Occupied(_) => {
                    let message = format!("`{name}` is declared twice: expected one body or wheel of each name");
                    report.error(*name, message);
                }
            }
        }
        Self { mechanism, names, bodies: mechanism.bodies.len(), known, holds: vec![None; names.len()] }
    }

    fn read(&mut self, report: &mut Report) {
        let mechanism = self.mechanism;
        if let [first, second, ..] = &mechanism.free[..] {
            let message = format!("a second free body beside `{}`: expected one, on which all others hang", first.body);
            report.error(&second.body, message);
        }
        for free in &mechanism.free {
            let Some(body) = self.find(&free.body, report) else { continue };
            if body >= self.bodies && mechanism.wheels[body - self.bodies].carrier.is_some() {
                let message = format!("the wheel `{}` is free, and is on a body: expected one of both", free.body);
                report.error(&free.body, message);
                continue;
            }
            let pitch = free.names.iter().find(|(freedom, _)| *freedom == Freedom::Pitch);
            if let Some((_, name)) = pitch.filter(|_| body >= self.bodies) {
                let message = format!(
                    "`{}` is a wheel, which turns about its axle as it rolls: expected `lateral`, `vertical`, `yaw` or \
                     `lean`, and no `pitch`",
                    free.body
                );
                report.error(name, message);
            }
            self.hold(body, Hold::Free, &free.body, report);
        }
        for (index, joint) in mechanism.joints.iter().enumerate() {
            let parent = self.base(&joint.parent, report);
            let Some(child) = self.movable(&joint.child, report) else { continue };
            let Some(parent) = parent else { continue };
            self.hold(child, Hold::Joint(index, parent), &joint.name, report);
        }
        for (body, base) in &mechanism.fixed {
            let to = self.base(base, report);
            let Some(fixed) = self.movable(body, report) else { continue };
            let Some(to) = to else { continue };
            if to.is_none() {
                report.error(base, format!("`{body}` would never move: expected no body that is fixed to the ground"));
                continue;
            }
            self.hold(fixed, Hold::Fixed(to), body, report);
        }
        for wheel in &mechanism.wheels {
            let Some(carrier) = &wheel.carrier else { continue };
            if self.base(carrier, report) == Some(None) {
                let name = &wheel.name;
                let message = format!(
                    "the wheel `{name}` is carried by the ground: expected the body that carries it, or `free {name};` for \
                     a wheel alone"
                );
                report.error(carrier, message);
            }
        }
    }

    /// A body or a wheel.
    fn find(&self, name: &Ident, report: &mut Report) -> Option<usize> {
        let found = self.known.get(&name.to_string()).copied();
        if found.is_none() && !self.is_refused(name) {
            let names = || self.names[..self.bodies].iter().map(ToString::to_string);
            let candidates: Vec<String> = names().chain([GROUND.to_string()]).collect();
            let hint = match nearest(&name.to_string(), candidates.iter().map(String::as_str)) {
                Some(near) => format!("; did you mean `{near}`?"),
                None => format!(": {}", names().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")),
            };
            report.error(name, format!("unknown body `{name}`: expected one of the mechanism{hint}"));
        }
        found
    }

    /// Whether a part of this name is there, but as a mistake that is reported already.
    fn is_refused(&self, name: &Ident) -> bool {
        self.mechanism.unread.iter().flatten().any(|unread| unread == name)
    }

    /// A body that another one may hang on; the inner none is the ground.
    fn base(&self, name: &Ident, report: &mut Report) -> Option<Option<usize>> {
        if name == GROUND {
            return Some(None);
        }
        let found = self.find(name, report)?;
        if found >= self.bodies {
            report.error(name, format!("`{name}` is a wheel, whose only joint is its axle: expected a body"));
            return None;
        }
        Some(Some(found))
    }

    /// A body that hangs on another one.
    fn movable(&self, name: &Ident, report: &mut Report) -> Option<usize> {
        match self.base(name, report)? {
            Some(found) => Some(found),
            // A body of this name is reported already.
            None if self.names.iter().any(|body| *body == GROUND) => None,
            None => {
                report.error(name, "the ground does not move: expected the body that moves");
                None
            }
        }
    }

    fn hold(&mut self, body: usize, hold: Hold, by: &'a Ident, report: &mut Report) {
        let Some((first, _)) = self.holds[body] else {
            self.holds[body] = Some((hold, by));
            return;
        };
        // Several freedoms between two bodies need a body between each two of their joints.
        let between = match (first, hold) {
            (Hold::Joint(_, one), Hold::Joint(_, other)) if one == other => {
                "; for two freedoms put a massless body between their joints"
            }
            _ => "",
        };
        let message = format!(
            "a loop of joints: `{}` {}, and {}; expected a tree, in which each body hangs on one other{between}",
            self.names[body],
            self.describe(first),
            self.describe(hold),
        );
        report.error(by, message);
    }

    /// As the end of a sentence "the body …".
    fn describe(&self, hold: Hold) -> String {
        let name = |base: Option<usize>| base.map_or(GROUND.to_string(), |body| self.names[body].to_string());
        match hold {
            Hold::Free => "is free".into(),
            Hold::Joint(joint, base) => format!("hangs on `{}` by `{}`", name(base), self.mechanism.joints[joint].name),
            Hold::Fixed(base) => format!("is fixed to `{}`", name(base)),
        }
    }

    /// Joints from the root outward.
    fn grow(&self, report: &mut Report) -> Option<Tree> {
        let mechanism = self.mechanism;
        let mut tree = Tree::default();
        let mut moved_by: Vec<Option<Option<usize>>> = vec![None; self.bodies];
        let is_free = |name: &Ident| mechanism.free.first().is_some_and(|free| free.body == *name);
        let mut last = None;
        if let Some(free) = mechanism.free.first() {
            let wheel = mechanism.wheels.iter().any(|wheel| wheel.name == free.body);
            // A wheel that is free itself turns about its axle instead of pitching.
            let freedoms = Freedom::ALL.into_iter().filter(|freedom| !wheel || *freedom != Freedom::Pitch);
            for role in [Role::Forward].into_iter().chain(freedoms.map(Role::Freedom)) {
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
                        tree.joints.push(Node { role: Role::Joint(joint), parent });
                        Some(tree.joints.len() - 1)
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
            if !above.any(|joint| tree.joints[joint].role == Role::Forward) {
                let message = format!(
                    "the wheel `{}` is on what joints hold to the ground: expected it on a free body that rolls over the \
                     ground, or on what hangs on that",
                    wheel.name
                );
                report.error(&wheel.name, message);
            }
            tree.joints.push(Node { role: Role::Spin(index), parent });
        }
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
