//! Masses, moments of inertia and radii that no body has: refused where that is proved for all parameters.

use super::intervals::Interval;
use super::ranges::{Ranges, Reading};
use super::sourced::Sourced;
use crate::check::Checked;
use crate::derivation::Derived;
use crate::equations::Equations;
use crate::formula::{Formula, Term};
use crate::report::Report;
use crate::symbolic::{self, Sign};
use crate::syntax::{Inertia, Mechanism};

/// Reports what is negative and cannot be, and tyres that are rounder than their wheel; `attributes` are the formulas in
/// the mechanism, in their order.
pub fn check_physical(
    mechanism: &Mechanism,
    attributes: &[Sourced<'_>],
    checked: &Checked<'_>,
    derived: &Derived,
    report: &mut Report,
) {
    let mut ranges = Ranges::new(Reading::Nearest, checked.domains.iter().copied().map(Interval::from).collect());
    derived.definitions.iter().for_each(|definition| ranges.push_definition(definition));
    let mut refuse_negative = |what: &str, name: &dyn std::fmt::Display, attribute: Sourced<'_>| {
        if ranges.of(attribute.formula).is_negative() {
            let text = attribute.text(&derived.names);
            let message = format!("{what} of `{name}`, `{text}`, is negative for all parameters: expected >= 0");
            report.error(attribute.region(), message);
        }
    };
    let mut attributes = attributes.iter().copied();
    let mut tyres = Vec::new();
    for body in &mechanism.bodies {
        let Some((_, _, inertia)) = &body.mass else { continue };
        let Some(mass) = attributes.next() else { return };
        refuse_negative("the mass", &body.name, mass);
        attributes.by_ref().take(3).for_each(drop);
        let (count, step) = match inertia {
            Inertia::None => (0, 1),
            Inertia::Principal(_) => (3, 1),
            Inertia::Full(_) => (9, 4),
        };
        for moment in attributes.by_ref().take(count).step_by(step) {
            refuse_negative("the moment of inertia", &body.name, moment);
        }
    }
    for wheel in &mechanism.wheels {
        let taken: Vec<Sourced<'_>> = attributes.by_ref().take(4).collect();
        let [mass, radius, axial, radial] = taken[..] else { return };
        for (what, attribute) in [
            ("the mass", mass),
            ("the radius", radius),
            ("the axial moment of inertia", axial),
            ("the radial moment of inertia", radial),
        ] {
            refuse_negative(what, &wheel.name, attribute);
        }
        attributes.by_ref().take(3).for_each(drop);
        if let Some(tyre) = wheel.tyre.as_ref().and_then(|_| attributes.next()) {
            refuse_negative("the tyre", &wheel.name, tyre);
            tyres.push((wheel, radius, tyre));
        }
    }
    for (wheel, radius, tyre) in tyres {
        let rest = Formula::Sum(vec![Term::plus(radius.formula.clone()), Term::minus(tyre.formula.clone())]);
        let is_positive = (-ranges.of(radius.formula)).is_negative();
        let pair = vec![rest.clone(), radius.formula.clone()];
        let is_opposite = || {
            let equations = Equations::of_formulas(checked.domains.len(), &derived.definitions, pair);
            // A failure of the engine is reported where it compiles the model.
            symbolic::find_multiples(equations).is_ok_and(|signs| signs.contains(&Some(Sign::Negative)))
        };
        if ranges.of(&rest).is_negative() || is_positive && is_opposite() {
            let [tyre_text, radius_text] = [tyre, radius].map(|attribute| attribute.text(&derived.names));
            let message = format!(
                "the tyre of `{}`, `{tyre_text}`, is larger than its radius, `{radius_text}`, for all parameters: expected \
                 the radius of its cross-section, at most that of the wheel",
                wheel.name
            );
            report.error(tyre.region(), message);
        }
    }
}
