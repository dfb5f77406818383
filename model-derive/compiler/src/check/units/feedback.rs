//! Units and mirrors of what is fed back.

use super::analysis::{Analysis, short};
use super::dimension::Dimension;
use super::{ENERGY, RowFactors};
use crate::report::Report;
use crate::syntax::{Expression, Feedback, Kind, Term};

/// Each term of a feedback is the force that does work, an energy, on what it acts on. In a row of first order, which may
/// be in any unit, it is what the entries of that row make of it.
pub fn check_feedback(analysis: &Analysis<'_>, factors: &mut RowFactors, report: &mut Report) {
    for feedback in &analysis.declaration.feedback {
        let on = analysis.motions.iter().find(|(name, _)| feedback.on == name);
        let expected = on.and_then(|(_, dimension)| ENERGY.times(dimension.as_ref()?.power(-1)?));
        let single = [Term { negative: false, operator: None, value: feedback.law.clone() }];
        let terms = match &feedback.law.kind {
            Kind::Sum(terms) => terms,
            _ => &single[..],
        };
        for term in terms {
            let Some(found) = analysis.dimension(&term.value, report) else { continue };
            let Some(expected) = expected else { continue };
            let coordinates = &analysis.declaration.coordinates;
            let row = coordinates.iter().position(|coordinate| coordinate.name == feedback.on);
            let row = row.filter(|_| analysis.declaration.mechanism.is_none());
            let factor = row.map_or(Some(Dimension::NUMBER), |row| factors.find(row, found, expected));
            let Some(expected) = factor.and_then(|factor| expected.times(factor)) else { continue };
            check_term(&term.value, found, expected, feedback, analysis, report);
        }
    }
}

fn check_term(
    term: &Expression,
    found: Dimension,
    expected: Dimension,
    Feedback { name, on, .. }: &Feedback,
    analysis: &Analysis<'_>,
    report: &mut Report,
) {
    let what = format!("`{}`, which `{name}` feeds back to `{on}`,", short(term));
    if !found.same_unit(expected) {
        let unit = describe(expected);
        report.error(term.region, format!("{what} is {}: expected {unit}", found.place()));
    } else if analysis.dimensions.mirrored && found != expected {
        report.error(term.region, format!("{what} {}: expected what {}", found.sign(), expected.sign()));
    }
}

/// Forces and torques in the units in which they are mostly written.
fn describe(expected: Dimension) -> String {
    match () {
        () if expected.same_unit(ENERGY) => "N*m, a torque".into(),
        () if expected.same_unit(Dimension::new([1, 1, -2])) => "N, a force".into(),
        () if expected.is_number() => "a pure number".into(),
        () => expected.to_string(),
    }
}
