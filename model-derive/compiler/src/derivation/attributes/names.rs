//! What the attributes of a mechanism are called.

use proc_macro2::Ident;

use crate::syntax::{Body, Declaration, Inertia, Joint, Link, Mechanism, Wheel};

/// An attribute of a mechanism.
#[derive(Clone, Debug)]
pub struct NamedAttribute {
    /// For formulas, such as `H_x`.
    pub name: String,
    /// In words: `x of the centre of mass of the front frame H`.
    pub what: String,
    /// The position of another one that it is by symmetry.
    pub same: Option<usize>,
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// All attributes, in the order of [`Declaration::attributes`].
pub fn name_attributes(declaration: &Declaration, mechanism: &Mechanism) -> Vec<NamedAttribute> {
    let mut list = List(Vec::new());
    mechanism.bodies.iter().for_each(|body| list.body(body));
    mechanism.wheels.iter().for_each(|wheel| list.wheel(wheel));
    mechanism.joints.iter().for_each(|joint| list.joint(joint));
    for body in mechanism.bodies.iter().filter(|body| body.momentum.is_some()) {
        let owner = owner(&body.name, body.label.as_ref(), "body");
        list.vector(&format!("{}_momentum", body.name), &format!("the momentum in {owner}"));
    }
    mechanism.links.iter().for_each(|link| list.link(link));
    for matrix in &declaration.added {
        for (row, (_, entries)) in matrix.rows.iter().enumerate() {
            for column in 0..entries.len() {
                let comma = if row.max(column) > 8 { "," } else { "" };
                let entry = format!("{}_{}{comma}{}", matrix.name.name(), row + 1, column + 1);
                let name = format!("added_{}_{}_{}", matrix.name.identifier(), row + 1, column + 1);
                list.push(&name, &format!("what is added to {entry}"));
            }
        }
    }
    list.0
}

/// `the front frame H`, or `the body H`.
fn owner(name: &Ident, label: Option<&String>, kind: &str) -> String {
    format!("the {} {name}", label.map_or(kind, String::as_str))
}

struct List(Vec<NamedAttribute>);

impl List {
    fn push(&mut self, name: &str, what: &str) {
        self.0.push(NamedAttribute { name: name.into(), what: what.into(), same: None });
    }

    fn vector(&mut self, name: &str, what: &str) {
        AXES.iter().for_each(|axis| self.push(&format!("{name}_{axis}"), &format!("{axis} of {what}")));
    }

    fn body(&mut self, Body { name, label, mass, .. }: &Body) {
        let Some((_, _, inertia)) = mass else { return };
        let owner = owner(name, label.as_ref(), "body");
        self.push(&format!("{name}_mass"), &format!("the mass of {owner}"));
        self.vector(&name.to_string(), &format!("the centre of mass of {owner}"));
        let mut moment = |row: usize, column: usize| {
            let axes = format!("{}{}", AXES[row.min(column)], AXES[row.max(column)]);
            self.push(&format!("{name}_I{axes}"), &format!("the inertia {axes} of {owner}"));
            self.0.len() - 1
        };
        match inertia {
            Inertia::None => {}
            Inertia::Principal(_) => (0..3).for_each(|axis| {
                moment(axis, axis);
            }),
            Inertia::Full(_) => {
                let places: Vec<usize> = (0..9).map(|place| moment(place / 3, place % 3)).collect();
                for (row, column) in [(1, 0), (2, 0), (2, 1)] {
                    self.0[places[3 * row + column]].same = Some(places[3 * column + row]);
                }
            }
        }
    }

    fn wheel(&mut self, Wheel { name, label, tyre, slip, .. }: &Wheel) {
        let owner = owner(name, label.as_ref(), "wheel");
        let mut push = |word: &str, what: &str| self.push(&format!("{name}_{word}"), &format!("{what} of {owner}"));
        push("mass", "the mass");
        push("radius", "the radius");
        push("axial", "the axial inertia");
        push("radial", "the radial inertia");
        self.vector(&name.to_string(), &format!("the centre of {owner}"));
        let slip = slip.as_ref();
        let others = [
            (tyre.is_some(), "tyre", "the radius of the tyre"),
            (slip.is_some(), "cornering", "the cornering stiffness"),
            (slip.is_some_and(|slip| slip.camber.is_some()), "camber", "the camber stiffness"),
            (slip.is_some_and(|slip| slip.trail.is_some()), "trail", "the trail of the tyre"),
            (slip.is_some_and(|slip| slip.relaxation.is_some()), "relaxation", "the relaxation length"),
        ];
        for (_, word, what) in others.into_iter().filter(|(is_there, ..)| *is_there) {
            self.push(&format!("{name}_{word}"), &format!("{what} of {owner}"));
        }
    }

    fn joint(&mut self, Joint { name, through, axis, spring, damper, .. }: &Joint) {
        if through.is_some() {
            self.vector(&format!("{name}_through"), &format!("the point of the joint {name}"));
        }
        if axis.along().is_some() {
            self.vector(&format!("{name}_along"), &format!("the axis of the joint {name}"));
        }
        self.held(name, "joint", spring.is_some(), damper.is_some());
    }

    fn link(&mut self, Link { name, ends, spring, damper }: &Link) {
        for ((body, _), word) in ends.iter().zip(["from", "to"]) {
            self.vector(&format!("{name}_{word}"), &format!("the end of the link {name} on {body}"));
        }
        self.held(name, "link", spring.is_some(), damper.is_some());
    }

    fn held(&mut self, name: &Ident, kind: &str, spring: bool, damper: bool) {
        for (_, word) in [(spring, "spring"), (damper, "damper")].into_iter().filter(|(is_there, _)| *is_there) {
            self.push(&format!("{name}_{word}"), &format!("the {word} of the {kind} {name}"));
        }
    }
}
