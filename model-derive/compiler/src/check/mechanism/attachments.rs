//! What holds each body: a joint, another body, or nothing where it is free.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use proc_macro2::Ident;

use crate::nearest::{ask_for, find_nearest};
use crate::report::Report;
use crate::syntax::{Freedom, Mechanism};

/// What holds a body.
#[derive(Clone, Copy, Debug)]
pub enum Hold {
    Free,
    /// A joint, the first one of its statement, on a body or on the ground.
    Joint(usize, Option<usize>),
    /// Another body, or the ground.
    Fixed(Option<usize>),
}

const GROUND: &str = "ground";

pub struct Attachments<'a> {
    pub mechanism: &'a Mechanism,
    /// The bodies, and behind them the wheels.
    pub names: &'a [&'a Ident],
    /// How many of them are bodies.
    pub bodies: usize,
    pub known: HashMap<String, usize>,
    /// What holds each, with the word of the statement that says so.
    pub holds: Vec<Option<(Hold, &'a Ident)>>,
}

impl<'a> Attachments<'a> {
    pub fn new(mechanism: &'a Mechanism, names: &'a [&'a Ident], report: &mut Report) -> Self {
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

    pub fn read(&mut self, report: &mut Report) {
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
                    "`{}` is a wheel, which turns about its axle as it rolls: expected `forward`, `lateral`, \
                     `vertical`, `yaw` or `lean`, and no `pitch`",
                    free.body
                );
                report.error(name, message);
            }
            self.hold(body, Hold::Free, &free.body, report);
        }
        for (index, joint) in mechanism.joints.iter().enumerate().filter(|(_, joint)| joint.rank == 0) {
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
        for link in &mechanism.links {
            let ends = link.ends.each_ref().map(|(name, _)| self.base(name, report));
            if let [Some(first), Some(second)] = ends
                && first == second
            {
                let message =
                    format!("the link `{}` is between two points of one body: expected two bodies", link.name);
                report.error(&link.name, message);
            }
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
            let hint = match find_nearest(&name.to_string(), candidates.iter().map(String::as_str)) {
                Some(near) => ask_for(near),
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
}
