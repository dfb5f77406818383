//! `mechanism { … }`: which of its parts is declared.

use proc_macro2::Ident;
use syn::parse::ParseStream;

use super::blocks::parse_block;
use super::docs::reject_docs;
use super::feedback::parse_feedback;
use super::freedoms::{parse_ball, parse_planar};
use super::names::parse_used;
use super::parts::{parse_body, parse_force, parse_free, parse_joint, parse_link, parse_wheel};
use super::tokens::{expected, parse_semicolon, parse_word};
use crate::nearest::{ask_for, find_nearest};
use crate::report::{Report, error};
use crate::syntax::tree::{Declaration, Feedback, JointKind, Mechanism};

/// `mechanism { … }`, behind its first word.
pub fn parse_mechanism(
    input: ParseStream<'_>,
    keyword: &syn::Ident,
    model: &mut Declaration,
    report: &mut Report,
) -> syn::Result<()> {
    let mut mechanism = Mechanism::new(keyword.span());
    let read = parse_block(input, "the parts of the mechanism", report, starts_part, |input, report| {
        reject_docs(input, "what it is about", report)?;
        let name = second_word(input);
        // One that cannot be read leaves its name, which others may use.
        parse_part(input, &mut mechanism, &mut model.feedback, report).inspect_err(|_| mechanism.unread.push(name))
    });
    if read.is_err() {
        mechanism.unread.push(None);
    }
    if model.mechanism.is_some() {
        report.error(keyword, "a second `mechanism`: expected one");
    }
    model.mechanism.get_or_insert(mechanism);
    read
}

/// What is said to be expected where no part starts.
const PARTS: &str = "a part of the mechanism: `body`, `wheel`, `revolute`, `prismatic`, `ball`, `planar`, `fix`, `free`, \
                     `link`, `force`, `feedback` or `hold`";

/// What may begin a part.
const KEYWORDS: [&str; 12] =
    ["body", "wheel", "revolute", "prismatic", "ball", "planar", "fix", "free", "link", "force", "feedback", "hold"];

/// Whether a part starts here.
fn starts_part(input: ParseStream<'_>) -> bool {
    let word = input.cursor().ident();
    word.is_some_and(|(word, _)| KEYWORDS.iter().any(|keyword| word == keyword)) && input.peek2(syn::Ident)
}

/// What the part that starts here is called.
fn second_word(input: ParseStream<'_>) -> Option<Ident> {
    let (_, behind) = input.cursor().ident()?;
    behind.ident().map(|(name, _)| name)
}

/// One part; what acts by feedback is no part of the mechanism, but may be told among its forces.
fn parse_part(
    input: ParseStream<'_>,
    mechanism: &mut Mechanism,
    feedback: &mut Vec<Feedback>,
    report: &mut Report,
) -> syn::Result<()> {
    if !input.peek(syn::Ident) {
        return Err(expected(input, PARTS));
    }
    let keyword: Ident = input.parse()?;
    let word = keyword.to_string();
    let word = match KEYWORDS.into_iter().find(|known| *known == word) {
        Some(known) => known,
        None => match find_nearest(&word, KEYWORDS.into_iter()) {
            Some(meant) => {
                report.error(&keyword, format!("found `{word}`: expected {PARTS}{}", ask_for(meant)));
                meant
            }
            None => return Err(error(&keyword, format!("found `{word}`: expected {PARTS}"))),
        },
    };
    match word {
        "body" => mechanism.bodies.push(parse_body(input)?),
        "wheel" => mechanism.wheels.push(parse_wheel(input)?),
        "revolute" => mechanism.joints.push(parse_joint(input, JointKind::Revolute)?),
        "prismatic" => mechanism.joints.push(parse_joint(input, JointKind::Prismatic)?),
        "ball" => mechanism.joints.extend(parse_ball(input)?),
        "planar" => mechanism.joints.extend(parse_planar(input)?),
        "fix" => {
            let body = parse_used(input, "the name of a body")?;
            parse_word(input, "to", "`to` and the body that it is fixed to")?;
            mechanism.fixed.push((body, parse_used(input, "the name of the body that it is fixed to")?));
            parse_semicolon(input, "`;`", "the attachment")?;
        }
        "free" => mechanism.free.push(parse_free(input)?),
        "link" => mechanism.links.push(parse_link(input)?),
        "hold" => {
            parse_word(input, "forward", "`forward`: the forward speed is what can be held")?;
            if mechanism.held.replace(keyword.span()).is_some() {
                report.error(&keyword, "a second `hold forward`: expected one");
            }
            parse_semicolon(input, "`;`", "`hold forward`")?;
        }
        "feedback" => feedback.push(parse_feedback(input)?),
        _ => mechanism.forces.push(parse_force(input)?),
    }
    Ok(())
}
