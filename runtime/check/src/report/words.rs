//! Causes in words.

use std::ops::Range;

use carvallo_design::number::{shortest, with_unit};

use crate::conventions::Effect;
use crate::explain::{Cause, relation};
use crate::machine::Machine;
use crate::slips::{Kind, Slip};
use crate::slips::{Token, TokenKind, tokens};

/// Formulas up to this length are shown whole.
const WHOLE: usize = 24;

/// What is otherwise, as the end of a sentence.
pub fn words(machine: &Machine, cause: &Cause) -> String {
    let parameter = |at: usize| &machine.info.parameters[at];
    match cause {
        Cause::Convention(own) => match &own.effect {
            Effect::Parameters(values) if values.len() <= 2 && !own.what.contains('=') => {
                let values: Vec<String> = values
                    .iter()
                    .map(|&(at, value)| {
                        let own = parameter(at);
                        let shown = machine.units.of(own.unit);
                        format!("{} = {}", own.name, with_unit(rounded(shown.value(value)), &shown.written))
                    })
                    .collect();
                format!("{} ({})", own.what, values.join(", "))
            }
            _ => own.what.clone(),
        },
        Cause::Slip(own) => {
            let formula = &machine.formulas.formulas[own.formulas[0]];
            slip(&machine.subject(&own.formulas), formula.text, &own.slip)
        }
        Cause::Slips(double) => {
            let formula = &machine.formulas.formulas[double.formula];
            let [first, second] = &double.slips;
            let range = first.place.start..second.place.end;
            let segment = segment(formula.text, &range);
            let grown = double.apply(formula.text).len() as isize - formula.text.len() as isize;
            let changed = &double.apply(formula.text)[segment.start..(segment.end as isize + grown) as usize];
            is_for(&machine.subject(&[double.formula]), &formula.text[segment], changed)
        }
        Cause::Parameter(at, value) => {
            let (own, old) = (parameter(*at), machine.parameters[*at]);
            let how = relation(old, *value).map(|how| format!(": {how}")).unwrap_or_default();
            let shown = machine.units.of(own.unit);
            let show = |value: f64| if shown.is_declared() { value } else { rounded(shown.value(value)) };
            let value = with_unit(show(*value), &shown.written);
            format!("{} is {value} in the place of {}{how}", own.name, shortest(show(old)))
        }
        Cause::Definition(at, value) => {
            let (name, old) = (machine.formulas.formulas[*at].subject, machine.values.definition(*at));
            let text = machine.formulas.formulas[*at].text;
            format!("{name} is {} in the place of {} = {text}", shortest(*value), shortest(rounded(old)))
        }
        Cause::Written(what) => what.clone(),
        Cause::Speed(factor) => {
            format!("the speeds are {} times what is given as the speed", shortest(*factor))
        }
    }
}

/// Without what arithmetic left behind.
fn rounded(value: f64) -> f64 {
    format!("{value:.9e}").parse::<f64>().unwrap_or(value) + 0.0
}

/// `"mF*(w - xA)^2" in IAzz is "mF*(w + xA)^2"`
fn slip(subject: &str, text: &str, slip: &Slip) -> String {
    let lost = text[slip.place.clone()].trim();
    let outer = segments(text).iter().any(|segment| segment.start == slip.place.start || segment.end == slip.place.end);
    if slip.kind == Kind::Term && outer && depth(text, slip.place.start) == 0 {
        return format!("{subject} is without \"{}\"", lost.trim_end_matches(['+', '-']).trim_end());
    }
    let segment = segment(text, &slip.place);
    let before = &text[segment.clone()];
    let inside = Slip { place: slip.place.start - segment.start..slip.place.end - segment.start, ..slip.clone() };
    is_for(subject, before, &inside.apply(before))
}

fn is_for(subject: &str, before: &str, after: &str) -> String {
    format!("\"{before}\" in {subject} is \"{}\"", after.trim())
}

/// How many parentheses are open at a place.
fn depth(text: &str, at: usize) -> i32 {
    text[..at].chars().map(|c| i32::from(c == '(') - i32::from(c == ')')).sum()
}

/// The part of a formula that shows a change: the whole of a short one; or else the term that it is in, with its sign where
/// that is changed.
fn segment(text: &str, place: &Range<usize>) -> Range<usize> {
    if text.len() <= WHOLE {
        return 0..text.len();
    }
    let touched: Vec<Range<usize>> = segments(text)
        .into_iter()
        .filter(|own| own.start < place.end.max(place.start + 1) && place.start < own.end)
        .collect();
    let (Some(first), Some(last)) = (touched.first(), touched.last()) else { return 0..text.len() };
    let mut start = first.start;
    // Its sign is left out where it is as it was.
    let sign = text[start..].find(|c: char| !matches!(c, '+' | '-' | ' ')).unwrap_or(0);
    if place.start >= start + sign && start > 0 {
        start += sign;
    }
    start..last.end
}

/// The terms of a formula, each with the sign before it.
fn segments(text: &str) -> Vec<Range<usize>> {
    let tokens = tokens(text).unwrap_or_default();
    let is_sign = |token: &Token| matches!(token.kind, TokenKind::Sign('+' | '-'));
    let mut segments: Vec<Range<usize>> = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        let between = at > 0 && is_sign(token) && !matches!(tokens[at - 1].kind, TokenKind::Sign(_));
        match segments.last_mut() {
            Some(last) if !between => last.end = token.place.end,
            _ => segments.push(token.place.clone()),
        }
    }
    segments
}

#[cfg(test)]
mod tests {
    use super::slip;
    use crate::slips::{Kind, slips};

    const TEXT: &str = "IHzz + IFxx + mH*(xH - xA)^2 + mF*(w - xA)^2";

    fn words(kind: Kind) -> Vec<String> {
        let names = ["IHzz", "IFxx", "mH", "xH", "xA", "mF", "w"];
        let found = slips(TEXT, &names).into_iter().filter(|slip| slip.kind == kind);
        found.map(|own| slip("IAzz", TEXT, &own)).collect()
    }

    #[test]
    fn slips_show_the_term_that_they_are_in() {
        assert_eq!(
            words(Kind::SignOfTerm),
            [
                "\"+ IFxx\" in IAzz is \"- IFxx\"",
                "\"+ mH*(xH - xA)^2\" in IAzz is \"- mH*(xH - xA)^2\"",
                "\"+ mF*(w - xA)^2\" in IAzz is \"- mF*(w - xA)^2\"",
                "\"mH*(xH - xA)^2\" in IAzz is \"mH*(xH + xA)^2\"",
                "\"mF*(w - xA)^2\" in IAzz is \"mF*(w + xA)^2\"",
            ]
        );
        assert_eq!(
            words(Kind::Term)[..4],
            [
                "IAzz is without \"IHzz\"",
                "IAzz is without \"+ IFxx\"",
                "IAzz is without \"+ mH*(xH - xA)^2\"",
                "IAzz is without \"+ mF*(w - xA)^2\"",
            ]
        );
        assert_eq!(words(Kind::Term)[4], "\"mH*(xH - xA)^2\" in IAzz is \"mH*(- xA)^2\"");
        assert_eq!(words(Kind::Factor)[0], "\"mH*(xH - xA)^2\" in IAzz is \"(xH - xA)^2\"");
    }
}
