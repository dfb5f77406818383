//! Joints with several freedoms, each behind its first word: they are as many joints, one on the other.

use proc_macro2::Ident;
use syn::Token;
use syn::parse::ParseStream;

use super::expressions::parse_expression;
use super::names::{parse_name, parse_used};
use super::tokens::{expected, parse_colon, parse_semicolon, parse_word};
use super::vectors::parse_vector;
use crate::nearest::{ask_for, find_nearest};
use crate::report::error;
use crate::syntax::tree::{Axis, Expression, Freedom, Joint, JointKind, Vector};

/// `ball hip: B to U, through (x, y, z), yaw a, lean b, pitch c, spring k, damper d;`
pub fn parse_ball(input: ParseStream<'_>) -> syn::Result<Vec<Joint>> {
    const WORDS: [&str; 6] = ["through", "yaw", "lean", "pitch", "spring", "damper"];
    let (joint, held) = parse_held(input, &WORDS)?;
    let mut through =
        Some(joint.through.ok_or_else(|| missing(&joint.name, "through", "`through (x, y, z)`, its centre"))?);
    // As those of a free body: each about an axis that is turned by those before.
    let rotations = [(Freedom::Yaw, 2), (Freedom::Lean, 0), (Freedom::Pitch, 1)];
    let mut held: Vec<Held> = held;
    let joints = rotations.into_iter().enumerate().map(|(rank, (rotation, axis))| {
        let word = rotation.word();
        let position = held.iter().position(|held| held.word == word);
        let what = format!("`{word}` and the name of that coordinate, beside those of the two other rotations");
        let held = held.remove(position.ok_or_else(|| missing(&joint.name, word, &what))?);
        Ok(Joint {
            kind: JointKind::Revolute,
            name: held.name,
            parent: joint.parent.clone(),
            child: joint.child.clone(),
            rank,
            through: through.take(),
            axis: Axis::Own(axis),
            spring: held.spring,
            damper: held.damper,
        })
    });
    joints.collect()
}

/// `planar P: A to B, through (x, y, z), slides a along (1, 0, 0), slides b along (0, 0, 1), turns c;`
pub fn parse_planar(input: ParseStream<'_>) -> syn::Result<Vec<Joint>> {
    const WORDS: [&str; 5] = ["through", "slides", "turns", "spring", "damper"];
    let (joint, held) = parse_held(input, &WORDS)?;
    let through = joint
        .through
        .ok_or_else(|| missing(&joint.name, "through", "`through (x, y, z)`, the point that it turns about"))?;
    let (slides, turns): (Vec<Held>, Vec<Held>) = held.into_iter().partition(|held| held.word == "slides");
    let count = slides.len();
    let [first, second] = <[Held; 2]>::try_from(slides).map_err(|_| {
        let message = format!(
            "`{}` has {count} of its `slides`: expected two, `slides a along (x, y, z)`, which are the plane",
            joint.name
        );
        error(&joint.name, message)
    })?;
    let Some(turns) = turns.into_iter().next() else {
        return Err(missing(&joint.name, "turns", "`turns` and the name of the angle in the plane"));
    };
    let joints = [first, second, turns].into_iter().enumerate().map(|(rank, held)| Joint {
        kind: if held.along.is_some() { JointKind::Prismatic } else { JointKind::Revolute },
        name: held.name,
        parent: joint.parent.clone(),
        child: joint.child.clone(),
        rank,
        through: held.along.is_none().then(|| through.clone()),
        axis: held.along.map_or(Axis::Normal, |along| Axis::Along(Box::new(along))),
        spring: held.spring,
        damper: held.damper,
    });
    Ok(joints.collect())
}

/// A joint but for its freedoms.
struct Whole {
    name: Ident,
    parent: Ident,
    child: Ident,
    through: Option<Vector>,
}

/// A freedom, and what holds it.
struct Held {
    /// As it is written: `yaw`.
    word: String,
    name: Ident,
    along: Option<Vector>,
    spring: Option<Expression>,
    damper: Option<Expression>,
}

/// What stands behind the first word of a joint with several freedoms; springs and dampers are of the freedom before them.
fn parse_held(input: ParseStream<'_>, words: &[&str]) -> syn::Result<(Whole, Vec<Held>)> {
    let name = parse_name(input, "the name of the joint")?;
    parse_colon(input, "`:` and the two bodies that it joins, as in `B to H`")?;
    let parent = parse_used(input, "the name of a body, or `ground`")?;
    parse_word(input, "to", "`to` and the body that moves")?;
    let child = parse_used(input, "the name of the body that moves")?;
    let mut whole = Whole { name, parent, child, through: None };
    let mut held: Vec<Held> = Vec::new();
    let known: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    let what = format!("one of {}", known.join(", "));
    while input.parse::<Option<Token![,]>>()?.is_some() {
        let word: Ident = if input.peek(syn::Ident) { input.parse()? } else { return Err(expected(input, &what)) };
        let text = word.to_string();
        if !words.contains(&text.as_str()) {
            // Another word for it.
            let meant = Some("lean").filter(|lean| text == "roll" && words.contains(lean));
            let meant = meant.or_else(|| find_nearest(&text, words.iter().copied()));
            let hint = meant.map(ask_for).unwrap_or_default();
            return Err(error(&word, format!("found `{word}`: expected {what}{hint}")));
        }
        let again = || error(&word, format!("a second `{word}` of `{}`: expected one", whole.name));
        match text.as_str() {
            "through" => {
                let point = parse_vector(input, &word)?;
                if whole.through.is_some() {
                    return Err(again());
                }
                whole.through = Some(point);
            }
            "spring" | "damper" => {
                let value = parse_expression(input)?;
                let Some(last) = held.last_mut() else {
                    let message = format!("`{word}` before the freedom that it holds: expected it behind that");
                    return Err(error(&word, message));
                };
                let place = if text == "spring" { &mut last.spring } else { &mut last.damper };
                if place.replace(value).is_some() {
                    return Err(error(&word, format!("a second `{word}` of `{}`: expected one", last.name)));
                }
            }
            _ => {
                if text != "slides" && held.iter().any(|known| known.word == text) {
                    return Err(again());
                }
                let name = parse_name(input, "the name of a coordinate")?;
                let along = if text == "slides" { Some(parse_direction(input)?) } else { None };
                held.push(Held { word: text, name, along, spring: None, damper: None });
            }
        }
    }
    parse_semicolon(input, "`,` or `;`", &format!("what `{}` has", whole.name))?;
    Ok((whole, held))
}

/// `along (x, y, z)`
fn parse_direction(input: ParseStream<'_>) -> syn::Result<Vector> {
    match input.cursor().ident() {
        Some((word, _)) if word == "along" => {
            input.parse::<Ident>()?;
            parse_vector(input, &word)
        }
        _ => Err(expected(input, "`along (x, y, z)`, the direction in which it slides")),
    }
}

fn missing(name: &Ident, word: &str, what: &str) -> syn::Error {
    error(name, format!("`{name}` has no `{word}`: expected {what}"))
}
