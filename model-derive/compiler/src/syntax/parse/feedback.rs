//! Forces and torques that follow from the motion.

use syn::parse::ParseStream;

use super::expressions::parse_expression;
use super::names::{parse_name, parse_used};
use super::statements::AFTER_FORMULA;
use super::tokens::{expected, parse_equals, parse_semicolon, parse_text, parse_word};
use crate::syntax::tree::Feedback;

/// `feedback T "steer torque" on delta = -k*rate(phi);`, behind its first word.
pub fn parse_feedback(input: ParseStream<'_>) -> syn::Result<Feedback> {
    let name = parse_name(input, "the name of a force or torque")?;
    let label = parse_text(input)?;
    parse_word(input, "on", "`on` and the coordinate that it acts on")?;
    let on = parse_used(input, "the name of the coordinate that it acts on")?;
    parse_equals(input, "`=` and what it is, such as `-k*rate(phi)`")?;
    let law = parse_expression(input)?;
    if input.peek(syn::Lifetime) {
        return Err(expected(input, "an operator; the rate of a coordinate `q` is written `rate(q)`"));
    }
    parse_semicolon(input, AFTER_FORMULA, "the feedback")?;
    Ok(Feedback { name, label, on, law })
}
