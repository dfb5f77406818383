//! Slips in words.

use std::ops::Range;

use crate::slip::{Kind, Slip};
use crate::token::{Token, TokenKind, tokens};

/// Formulas up to this length are shown whole.
const WHOLE: usize = 24;

/// What a slip in the text of a formula does, as the end of a sentence: `"mF*(w - xA)^2" in IAzz is "mF*(w + xA)^2"`.
pub fn slip_words(subject: &str, text: &str, slip: &Slip) -> String {
    let lost = text[slip.place.clone()].trim();
    let outer = terms(text).iter().any(|segment| segment.start == slip.place.start || segment.end == slip.place.end);
    if slip.kind == Kind::Term && outer && depth(text, slip.place.start) == 0 {
        return format!("{subject} is without \"{}\"", lost.trim_end_matches(['+', '-']).trim_end());
    }
    let segment = segment(text, &slip.place);
    let before = &text[segment.clone()];
    let inside = Slip { place: slip.place.start - segment.start..slip.place.end - segment.start, ..slip.clone() };
    is_for(subject, before, &inside.apply(before))
}

/// The same of two slips in one formula, the first of which stands before the second.
pub fn double_words(subject: &str, text: &str, [first, second]: &[Slip; 2]) -> String {
    let changed = first.apply(&second.apply(text));
    let segment = segment(text, &(first.place.start..second.place.end));
    let behind = text.len() - segment.end;
    is_for(subject, &text[segment.clone()], &changed[segment.start..changed.len() - behind])
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
    let touched: Vec<Range<usize>> = terms(text)
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
pub fn terms(text: &str) -> Vec<Range<usize>> {
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
    use super::slip_words;
    use crate::{Kind, slips};

    const TEXT: &str = "IHzz + IFxx + mH*(xH - xA)^2 + mF*(w - xA)^2";

    fn words(kind: Kind) -> Vec<String> {
        let names = ["IHzz", "IFxx", "mH", "xH", "xA", "mF", "w"];
        let found = slips(TEXT, &names).into_iter().filter(|slip| slip.kind == kind);
        found.map(|own| slip_words("IAzz", TEXT, &own)).collect()
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
