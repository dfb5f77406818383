//! `mechanism { … }`: bodies, wheels, joints and forces.

use proc_macro2::Ident;
use syn::Token;
use syn::parse::ParseStream;

use super::attributes::{Attribute, Attributes, Shape, attributes};
use super::declaration::{Body, Force, Free, Freedom, Inertia, Joint, JointKind, Mechanism, Wheel};
use super::tokens::{expected, name, semicolon, text};
use crate::nearest::nearest;
use crate::report::{Report, error};

const STATEMENTS: &str = "a part of the mechanism: `body`, `wheel`, `revolute`, `prismatic`, `fix`, `free` or `force`";

/// What may begin a statement.
const KEYWORDS: [&str; 7] = ["body", "wheel", "revolute", "prismatic", "fix", "free", "force"];

/// Whether a statement starts here.
pub fn starts(input: ParseStream<'_>) -> bool {
    let word = input.cursor().ident();
    word.is_some_and(|(word, _)| KEYWORDS.iter().any(|keyword| word == keyword)) && input.peek2(syn::Ident)
}

/// One statement of the block.
pub fn statement(input: ParseStream<'_>, mechanism: &mut Mechanism, report: &mut Report) -> syn::Result<()> {
    if !input.peek(syn::Ident) {
        return Err(expected(input, STATEMENTS));
    }
    let keyword: Ident = input.parse()?;
    let word = keyword.to_string();
    let word = match KEYWORDS.into_iter().find(|known| *known == word) {
        Some(known) => known,
        None => match nearest(&word, KEYWORDS.into_iter()) {
            Some(meant) => {
                let message = format!("found `{word}`: expected {STATEMENTS}; did you mean `{meant}`?");
                report.error(&keyword, message);
                meant
            }
            None => return Err(error(&keyword, format!("found `{word}`: expected {STATEMENTS}"))),
        },
    };
    match word {
        "body" => mechanism.bodies.push(body(input)?),
        "wheel" => mechanism.wheels.push(wheel(input)?),
        "revolute" => mechanism.joints.push(joint(input, JointKind::Revolute)?),
        "prismatic" => mechanism.joints.push(joint(input, JointKind::Prismatic)?),
        "fix" => {
            let body = name(input, "the name of a body")?;
            word_of(input, "to", "`to` and the body that it is fixed to")?;
            mechanism.fixed.push((body, name(input, "the name of the body that it is fixed to")?));
            semicolon(input, "`;`", "the attachment")?;
        }
        "free" => mechanism.free.push(free(input)?),
        _ => mechanism.forces.push(force(input)?),
    }
    Ok(())
}

/// `body B "rear frame": mass mB, at (xB, 0, zB), inertia [[…], […], […]];`
fn body(input: ParseStream<'_>) -> syn::Result<Body> {
    const KNOWN: [(&str, Shape); 4] =
        [("mass", Shape::Formula), ("massless", Shape::Word), ("at", Shape::Vector), ("inertia", Shape::Inertia)];
    let name = name(input, "the name of a body")?;
    let label = text(input)?;
    let mut found = attributes(input, &name, &KNOWN)?;
    if found.take("massless").is_some() {
        return match found.given.first() {
            Some((other, _)) => Err(error(other, format!("`{name}` is `massless`: expected no `{other}`"))),
            None => Ok(Body { name, label, mass: None }),
        };
    }
    let mass = found.formula("mass", "`mass` and its mass, or `massless`")?;
    let centre = found.vector("at", "`at` and its centre of mass `(x, y, z)`")?;
    let inertia =
        found.inertia("inertia", "`inertia` about the centre of mass: `[[…], […], […]]`, `[Ixx, Iyy, Izz]` or `0`")?;
    Ok(Body { name, label, mass: Some((mass, centre, inertia)) })
}

/// `wheel R "rear wheel" on B: mass mR, at (0, 0, -rR), radius rR, axial IRyy, radial IRxx;`
fn wheel(input: ParseStream<'_>) -> syn::Result<Wheel> {
    const KNOWN: [(&str, Shape); 6] = [
        ("mass", Shape::Formula),
        ("at", Shape::Vector),
        ("radius", Shape::Formula),
        ("tyre", Shape::Formula),
        ("axial", Shape::Formula),
        ("radial", Shape::Formula),
    ];
    let name = name(input, "the name of a wheel")?;
    let label = text(input)?;
    let carrier = match input.cursor().ident().filter(|(word, _)| word == "on") {
        Some(_) => {
            input.parse::<Ident>()?;
            Some(self::name(input, "the name of the body that carries the wheel")?)
        }
        None => None,
    };
    let mut found = attributes(input, &name, &KNOWN)?;
    Ok(Wheel {
        mass: found.formula("mass", "`mass` and its mass")?,
        centre: found.vector("at", "`at` and its centre `(x, y, z)`")?,
        radius: found.formula("radius", "`radius` and the distance from the centre to the ground")?,
        axial: found.formula("axial", "`axial` and its moment of inertia about the axle")?,
        radial: found.formula("radial", "`radial` and its moment of inertia about a diameter")?,
        tyre: found.optional("tyre"),
        name,
        label,
        carrier,
    })
}

/// `revolute delta: B to H, through (w + c, 0, 0), along (sin(lam), 0, cos(lam)), spring k, damper d;`
fn joint(input: ParseStream<'_>, kind: JointKind) -> syn::Result<Joint> {
    const REVOLUTE: [(&str, Shape); 4] =
        [("through", Shape::Vector), ("along", Shape::Vector), ("spring", Shape::Formula), ("damper", Shape::Formula)];
    let name = name(input, "the name of the joint's coordinate")?;
    colon(input, "`:` and the two bodies that it joins, as in `B to H`")?;
    let parent = self::name(input, "the name of a body, or `ground`")?;
    word_of(input, "to", "`to` and the body that moves")?;
    let child = self::name(input, "the name of the body that moves")?;
    let known = if kind == JointKind::Revolute { &REVOLUTE[..] } else { &REVOLUTE[1..] };
    let mut found = Attributes::after_comma(input, &name, known)?;
    let through = match kind {
        JointKind::Revolute => Some(found.vector("through", "`through` and a point `(x, y, z)` of its axis")?),
        JointKind::Prismatic => None,
    };
    let along = found.vector("along", "`along` and the direction `(x, y, z)` of its axis")?;
    let [spring, damper] = ["spring", "damper"].map(|word| found.optional(word));
    Ok(Joint { kind, name, parent, child, through, along, spring, damper })
}

/// `free B: lean phi, yaw psi;`
fn free(input: ParseStream<'_>) -> syn::Result<Free> {
    let body = name(input, "the name of a body or a wheel")?;
    let mut names = Vec::new();
    if input.peek(Token![:]) {
        input.parse::<Token![:]>()?;
        loop {
            let what = "a freedom: `lateral`, `vertical`, `yaw`, `lean` or `pitch`";
            let word: Ident = if input.peek(syn::Ident) { input.parse()? } else { return Err(expected(input, what)) };
            let Some(freedom) = Freedom::from_word(&word.to_string()) else {
                return Err(error(&word, format!("found `{word}`: expected {what}")));
            };
            names.push((freedom, name(input, "the name of the coordinate")?));
            if input.parse::<Option<Token![,]>>()?.is_none() {
                break;
            }
        }
    }
    semicolon(input, if names.is_empty() { "`:` or `;`" } else { "`,` or `;`" }, "the free body")?;
    Ok(Free { body, names })
}

/// `force T "steer torque" on delta;`
fn force(input: ParseStream<'_>) -> syn::Result<Force> {
    let name = name(input, "the name of a force or torque")?;
    let label = text(input)?;
    word_of(input, "on", "`on` and the joint that it acts on")?;
    let on = self::name(input, "the coordinate of a joint")?;
    semicolon(input, "`;`", "the force")?;
    Ok(Force { name, label, on })
}

fn word_of(input: ParseStream<'_>, word: &str, what: &str) -> syn::Result<()> {
    if input.cursor().ident().is_some_and(|(found, _)| found == word) {
        input.parse::<Ident>()?;
        return Ok(());
    }
    Err(expected(input, what))
}

fn colon(input: ParseStream<'_>, what: &str) -> syn::Result<()> {
    if input.peek(Token![:]) && !input.peek(Token![::]) {
        input.parse::<Token![:]>()?;
        return Ok(());
    }
    Err(expected(input, what))
}

/// What an attribute is in the tree.
impl Attributes {
    fn formula(&mut self, word: &str, what: &str) -> syn::Result<super::Expression> {
        match self.take(word) {
            Some((_, Attribute::Formula(value))) => Ok(value),
            _ => Err(self.missing(what)),
        }
    }

    fn optional(&mut self, word: &str) -> Option<super::Expression> {
        match self.take(word) {
            Some((_, Attribute::Formula(value))) => Some(value),
            _ => None,
        }
    }

    fn vector(&mut self, word: &str, what: &str) -> syn::Result<super::declaration::Vector> {
        match self.take(word) {
            Some((_, Attribute::Vector(value))) => Ok(value),
            _ => Err(self.missing(what)),
        }
    }

    fn inertia(&mut self, word: &str, what: &str) -> syn::Result<Inertia> {
        match self.take(word) {
            Some((_, Attribute::Inertia(value))) => Ok(value),
            _ => Err(self.missing(what)),
        }
    }
}
