//! `mechanism { … }`: bodies, wheels, joints and forces.

use proc_macro2::Ident;
use syn::Token;
use syn::parse::ParseStream;

use super::attributes::{Attributes, Shape};
use super::parts::{Body, Force, Free, Freedom, Joint, JointKind, Mechanism, Wheel};
use super::tokens::{expected, name, semicolon, text, used};
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

/// One statement of the block. One that cannot be read leaves its name, which others may use.
pub fn statement(input: ParseStream<'_>, mechanism: &mut Mechanism, report: &mut Report) -> syn::Result<()> {
    let name = second_word(input);
    part(input, mechanism, report).inspect_err(|_| mechanism.unread.push(name))
}

fn second_word(input: ParseStream<'_>) -> Option<Ident> {
    let (_, behind) = input.cursor().ident()?;
    behind.ident().map(|(name, _)| name)
}

fn part(input: ParseStream<'_>, mechanism: &mut Mechanism, report: &mut Report) -> syn::Result<()> {
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
            let body = used(input, "the name of a body")?;
            word_of(input, "to", "`to` and the body that it is fixed to")?;
            mechanism.fixed.push((body, used(input, "the name of the body that it is fixed to")?));
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
    let mut found = Attributes::after_colon(input, &name, &KNOWN)?;
    if found.word("massless") {
        return match found.first() {
            Some(other) => Err(error(other, format!("`{name}` is `massless`: expected no `{other}`"))),
            None => Ok(Body { name, label, mass: None }),
        };
    }
    let mass = found.formula("mass", "`mass` and its formula, or `massless`")?;
    let centre = found.vector("at", "`at (x, y, z)`, its centre of mass")?;
    let inertia = found
        .inertia("inertia", "`inertia` and, about the centre of mass, `[[…], […], […]]`, `[Ixx, Iyy, Izz]` or `0`")?;
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
            Some(used(input, "the name of the body that carries the wheel")?)
        }
        None => None,
    };
    let mut found = Attributes::after_colon(input, &name, &KNOWN)?;
    Ok(Wheel {
        mass: found.formula("mass", "`mass` and its formula, which may be 0")?,
        centre: found.vector("at", "`at (x, y, z)`, its centre")?,
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
    let parent = used(input, "the name of a body, or `ground`")?;
    word_of(input, "to", "`to` and the body that moves")?;
    let child = used(input, "the name of the body that moves")?;
    let known = if kind == JointKind::Revolute { &REVOLUTE[..] } else { &REVOLUTE[1..] };
    let mut found = Attributes::after_comma(input, &name, known)?;
    let through = match kind {
        JointKind::Revolute => Some(found.vector("through", "`through (x, y, z)`, a point of its axis")?),
        JointKind::Prismatic => None,
    };
    let along = found.vector("along", "`along (x, y, z)`, the direction of its axis")?;
    let [spring, damper] = ["spring", "damper"].map(|word| found.optional(word));
    Ok(Joint { kind, name, parent, child, through, along, spring, damper })
}

/// `free B: lean phi, yaw psi;`
fn free(input: ParseStream<'_>) -> syn::Result<Free> {
    let body = used(input, "the name of a body or a wheel")?;
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
    let on = used(input, "the coordinate of a joint")?;
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
