//! The parts of a mechanism, each behind its first word: bodies, wheels, joints and forces.

use proc_macro2::Ident;
use syn::Token;
use syn::parse::ParseStream;

use super::attributes::{Attributes, Shape};
use super::names::{parse_name, parse_used};
use super::tokens::{expected, parse_colon, parse_semicolon, parse_text, parse_word};
use crate::report::error;
use crate::syntax::tree::{Axis, Body, Force, Free, Freedom, Joint, JointKind, Link, Slip, Wheel};

/// `body B "rear frame": mass mB, at (xB, 0, zB), inertia [[…], […], […]];`
pub fn parse_body(input: ParseStream<'_>) -> syn::Result<Body> {
    const KNOWN: [(&str, Shape); 5] = [
        ("mass", Shape::Formula),
        ("massless", Shape::Word),
        ("at", Shape::Vector),
        ("inertia", Shape::Inertia),
        ("momentum", Shape::Vector),
    ];
    let name = parse_name(input, "the name of a body")?;
    let label = parse_text(input)?;
    let mut found = Attributes::after_colon(input, &name, &KNOWN)?;
    let momentum = found.optional_vector("momentum");
    if found.word("massless") {
        return match found.first() {
            Some(other) => Err(error(other, format!("`{name}` is `massless`: expected no `{other}`"))),
            None => Ok(Body { name, label, mass: None, momentum }),
        };
    }
    let mass = found.formula("mass", "`mass` and its formula, or `massless`")?;
    let centre = found.vector("at", "`at (x, y, z)`, its centre of mass")?;
    let inertia = found
        .inertia("inertia", "`inertia` and, about the centre of mass, `[[…], […], […]]`, `[Ixx, Iyy, Izz]` or `0`")?;
    Ok(Body { name, label, mass: Some((mass, centre, inertia)), momentum })
}

/// `wheel R "rear wheel" on B: mass mR, at (0, 0, -rR), radius rR, axial IRyy, radial IRxx;`
pub fn parse_wheel(input: ParseStream<'_>) -> syn::Result<Wheel> {
    const KNOWN: [(&str, Shape); 11] = [
        ("mass", Shape::Formula),
        ("at", Shape::Vector),
        ("radius", Shape::Formula),
        ("tyre", Shape::Formula),
        ("axial", Shape::Formula),
        ("radial", Shape::Formula),
        ("cornering", Shape::Formula),
        ("camber", Shape::Formula),
        ("trail", Shape::Formula),
        ("relaxation", Shape::Formula),
        ("deflection", Shape::Name),
    ];
    let name = parse_name(input, "the name of a wheel")?;
    let label = parse_text(input)?;
    let carrier = match input.cursor().ident().filter(|(word, _)| word == "on") {
        Some(_) => {
            input.parse::<Ident>()?;
            Some(parse_used(input, "the name of the body that carries the wheel")?)
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
        slip: parse_slip(&mut found)?,
        name,
        label,
        carrier,
    })
}

/// What of a tyre's side force is given, if it slips.
fn parse_slip(found: &mut Attributes) -> syn::Result<Option<Slip>> {
    let cornering = found.optional("cornering");
    let [camber, trail, length] = ["camber", "trail", "relaxation"].map(|word| found.optional(word));
    let deflection = found.name("deflection");
    let relaxation = match (length, deflection) {
        (Some(length), Some(deflection)) => Some((length, deflection)),
        (Some(_), None) => {
            let what = "beside `relaxation` the name of the coordinate that is the tyre's deflection, `deflection e`, with \
                        `e: m;` among the coordinates";
            return Err(found.missing("deflection", what));
        }
        (None, Some(_)) => {
            return Err(found.missing("relaxation", "it beside `deflection`: the length over which it follows"));
        }
        (None, None) => None,
    };
    match cornering {
        Some(cornering) => Ok(Some(Slip { cornering, camber, trail, relaxation })),
        None if camber.is_some() || trail.is_some() || relaxation.is_some() => {
            let what = "its side force by slip angle, in N (by rad), beside `camber`, `trail` and `relaxation`: without it the \
                        wheel does not slip";
            Err(found.missing("cornering", what))
        }
        None => Ok(None),
    }
}

/// `revolute delta: B to H, through (w + c, 0, 0), along (sin(lam), 0, cos(lam)), spring k, damper d;`
pub fn parse_joint(input: ParseStream<'_>, kind: JointKind) -> syn::Result<Joint> {
    const REVOLUTE: [(&str, Shape); 4] =
        [("through", Shape::Vector), ("along", Shape::Vector), ("spring", Shape::Formula), ("damper", Shape::Formula)];
    let name = parse_name(input, "the name of the joint's coordinate")?;
    parse_colon(input, "`:` and the two bodies that it joins, as in `B to H`")?;
    let parent = parse_used(input, "the name of a body, or `ground`")?;
    parse_word(input, "to", "`to` and the body that moves")?;
    let child = parse_used(input, "the name of the body that moves")?;
    let known = if kind == JointKind::Revolute { &REVOLUTE[..] } else { &REVOLUTE[1..] };
    let mut found = Attributes::after_comma(input, &name, known)?;
    let through = match kind {
        JointKind::Revolute => Some(found.vector("through", "`through (x, y, z)`, a point of its axis")?),
        JointKind::Prismatic => None,
    };
    let axis = Axis::Along(Box::new(found.vector("along", "`along (x, y, z)`, the direction of its axis")?));
    let [spring, damper] = ["spring", "damper"].map(|word| found.optional(word));
    Ok(Joint { kind, name, parent, child, rank: 0, through, axis, spring, damper })
}

/// `free B: lean phi, yaw psi;`
pub fn parse_free(input: ParseStream<'_>) -> syn::Result<Free> {
    let body = parse_used(input, "the name of a body or a wheel")?;
    let mut names = Vec::new();
    if input.peek(Token![:]) {
        input.parse::<Token![:]>()?;
        loop {
            let what = "a freedom: `forward`, `lateral`, `vertical`, `yaw`, `lean` or `pitch`";
            let word: Ident = if input.peek(syn::Ident) { input.parse()? } else { return Err(expected(input, what)) };
            let Some(freedom) = Freedom::from_word(&word.to_string()) else {
                return Err(error(&word, format!("found `{word}`: expected {what}")));
            };
            names.push((
                freedom,
                parse_name(input, "the name of the coordinate; what the wheels determine is left out")?,
            ));
            if input.parse::<Option<Token![,]>>()?.is_none() {
                break;
            }
        }
    }
    parse_semicolon(input, if names.is_empty() { "`:` or `;`" } else { "`,` or `;`" }, "the free body")?;
    Ok(Free { body, names })
}

/// `link S: A to B, from (x, y, z), to (x, y, z), spring k, damper d;`
pub fn parse_link(input: ParseStream<'_>) -> syn::Result<Link> {
    const KNOWN: [(&str, Shape); 4] =
        [("from", Shape::Vector), ("to", Shape::Vector), ("spring", Shape::Formula), ("damper", Shape::Formula)];
    let name = parse_name(input, "the name of the link")?;
    parse_colon(input, "`:` and the two bodies between which it acts, as in `B to H`")?;
    let first = parse_used(input, "the name of a body, or `ground`")?;
    parse_word(input, "to", "`to` and the other body")?;
    let second = parse_used(input, "the name of the other body, or `ground`")?;
    let mut found = Attributes::after_comma(input, &name, &KNOWN)?;
    let from = found.vector("from", "`from (x, y, z)`, the point of the first body")?;
    let to = found.vector("to", "`to (x, y, z)`, the point of the second body")?;
    let [spring, damper] = ["spring", "damper"].map(|word| found.optional(word));
    if spring.is_none() && damper.is_none() {
        return Err(found
            .missing("spring", "`spring` and its stiffness in N/m, `damper` and its coefficient in N*s/m, or both"));
    }
    Ok(Link { name, ends: [(first, from), (second, to)], spring, damper })
}

/// `force T "steer torque" on delta;`
pub fn parse_force(input: ParseStream<'_>) -> syn::Result<Force> {
    let name = parse_name(input, "the name of a force or torque")?;
    let label = parse_text(input)?;
    parse_word(input, "on", "`on` and the joint that it acts on")?;
    let on = parse_used(input, "the coordinate of a joint, or a wheel")?;
    parse_semicolon(input, "`;`", "the force")?;
    Ok(Force { name, label, on })
}
