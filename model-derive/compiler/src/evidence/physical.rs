//! What masses, moments of inertia, radii and tyres have to be: those of bodies and wheels that there can be.

use super::requirements::SourcedFormulas;
use super::sourced::{Source, Sourced};
use crate::domain::Domain;
use crate::formula::{Formula, Names, Term};
use crate::report::Region;
use crate::syntax::{Expression, Inertia, Mechanism};

/// What a formula has to be for what it is.
#[derive(Debug)]
pub struct Demand {
    /// What it is, such as "the mass of `B`".
    pub what: String,
    pub value: Formula,
    /// As people read it.
    pub text: String,
    pub region: Region,
    pub domain: Domain,
    /// What it is a part of.
    pub whole: Option<Formula>,
    /// What is said if it is negative for all parameters.
    pub refusal: String,
}

/// Finds what the formulas of a mechanism have to be, each radius before the tyre that it holds.
pub fn find_demands(mechanism: &Mechanism, formulas: &SourcedFormulas<'_>, names: &Names) -> Vec<Demand> {
    let find = |written: &Expression| {
        let is_it = |known: &&Sourced<'_>| matches!(known.source, Source::Written(own) if std::ptr::eq(own, written));
        *formulas.attributes.iter().find(is_it).unwrap_or_else(|| unreachable!("each formula of it is an attribute"))
    };
    let demand = |what: String, written: &Expression, domain: Domain| {
        let attribute = find(written);
        // What a user of the model sees are the parameters.
        let mut opened = attribute;
        while let Formula::Definition(index) = opened.formula {
            opened = formulas.definitions[*index];
        }
        Demand {
            refusal: format!("{what}, `{written}`, is negative for all parameters: expected {domain}"),
            what,
            value: attribute.formula.clone(),
            text: opened.text(names),
            region: attribute.region(),
            domain,
            whole: None,
        }
    };
    let mut demands = Vec::new();
    for body in &mechanism.bodies {
        let Some((mass, _, inertia)) = &body.mass else { continue };
        demands.push(demand(format!("the mass of `{}`", body.name), mass, Domain::NONNEGATIVE));
        let moments: Vec<&Expression> = match inertia {
            Inertia::None => Vec::new(),
            Inertia::Principal(moments) => moments.iter().collect(),
            Inertia::Full(rows) => rows.iter().enumerate().map(|(axis, row)| &row[axis]).collect(),
        };
        for moment in moments {
            let what = format!("the moment of inertia of `{}`", body.name);
            demands.push(demand(what, moment, Domain::NONNEGATIVE));
        }
    }
    for wheel in &mechanism.wheels {
        let name = &wheel.name;
        for (what, written, domain) in [
            ("the mass", &wheel.mass, Domain::NONNEGATIVE),
            ("the radius", &wheel.radius, Domain::POSITIVE),
            ("the axial moment of inertia", &wheel.axial, Domain::NONNEGATIVE),
            ("the radial moment of inertia", &wheel.radial, Domain::NONNEGATIVE),
        ] {
            demands.push(demand(format!("{what} of `{name}`"), written, domain));
        }
        let Some(tyre) = &wheel.tyre else { continue };
        demands.push(demand(format!("the tyre of `{name}`"), tyre, Domain::NONNEGATIVE));
        let [radius, section] = [&wheel.radius, tyre].map(|written| find(written).formula.clone());
        let value = Formula::Sum(vec![Term::plus(radius.clone()), Term::minus(section)]);
        demands.push(Demand {
            what: format!("the radius of `{name}` without that of its tyre"),
            text: names.text(&value).to_string(),
            value,
            region: tyre.region,
            domain: Domain::NONNEGATIVE,
            whole: Some(radius),
            refusal: format!(
                "the tyre of `{name}`, `{tyre}`, is larger than its radius, `{}`, for all parameters: expected the radius of \
                 its cross-section, at most that of the wheel",
                wheel.radius
            ),
        });
    }
    demands
}
