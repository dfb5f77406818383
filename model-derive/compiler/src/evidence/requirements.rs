//! What formulas need to have a value, and a mechanism to be one of bodies: what nobody has excluded becomes a requirement.

use super::divisors::{Need, Subject, find_needs};
use super::intervals::Interval;
use super::physical::{Demand, find_demands};
use super::ranges::{Ranges, Reading};
use super::samples::{Samples, maybe_multiples};
use super::sourced::Sourced;
use super::zero::is_zero;
use crate::check::Checked;
use crate::derivation::Derived;
use crate::domain::{Bound, Domain};
use crate::equations::Equations;
use crate::formula::Formula;
use crate::model::{Origin, Requirement};
use crate::report::{Region, Report};
use crate::symbolic::{self, Sign};

/// The formulas of a model, each with where it comes from.
#[derive(Debug)]
pub struct SourcedFormulas<'a> {
    pub definitions: Vec<Sourced<'a>>,
    /// Of the mechanism.
    pub attributes: Vec<Sourced<'a>>,
    /// Of the matrices, and what else is computed.
    pub entries: Vec<Sourced<'a>>,
    pub requirements: Vec<Sourced<'a>>,
    /// Both sides of claims.
    pub claims: Vec<Sourced<'a>>,
}

/// Finds the requirements that formulas need to have a value and a mechanism to have bodies and wheels, and that the domains
/// and other requirements do not imply; each has a value itself if those before it hold.
pub fn find_requirements(
    checked: &Checked<'_>,
    derived: &Derived,
    formulas: &SourcedFormulas<'_>,
    report: &mut Report,
) -> Vec<Requirement> {
    let mut search = Search::new(checked, derived, formulas, report);
    let SourcedFormulas { attributes, entries, requirements, claims, .. } = formulas;
    // What is derived from a mechanism needs what that does, but in other words.
    search.settle(Origin::Matrices, attributes.to_vec());
    if let Some(mechanism) = &checked.declaration.mechanism {
        find_demands(mechanism, formulas, &derived.names).into_iter().for_each(|demand| search.meet(demand));
    }
    search.settle(Origin::Matrices, search.with_definitions(entries));
    if checked.declaration.derivatives.is_some() {
        search.refuse_roots_of_zero();
    }
    search.settle(Origin::Requirements, search.with_definitions(requirements));
    // At run time nothing depends on a claim, so only what never has a value is a mistake there.
    let needed = search.found.len();
    search.settle(Origin::Requirements, search.with_definitions(claims));
    search.found.truncate(needed);
    search.found
}

struct Search<'a> {
    checked: &'a Checked<'a>,
    derived: &'a Derived,
    formulas: &'a SourcedFormulas<'a>,
    report: &'a mut Report,
    ranges: Ranges,
    samples: Samples,
    /// The values at the samples of what requirements bound, the declared ones first.
    known: Vec<Vec<Interval>>,
    found: Vec<Requirement>,
    /// What the matrices take the root of, with where they do.
    radicands: Vec<(Region, Subject<'a>)>,
}

impl<'a> Search<'a> {
    fn new(
        checked: &'a Checked<'a>,
        derived: &'a Derived,
        formulas: &'a SourcedFormulas<'a>,
        report: &'a mut Report,
    ) -> Self {
        let mut ranges = Ranges::new(Reading::Nearest, checked.domains.iter().copied().map(Interval::from).collect());
        for Requirement { value, domain, .. } in &checked.requirements {
            add_facts(&mut ranges, value, *domain, derived);
        }
        derived.definitions.iter().for_each(|definition| ranges.push_definition(definition));
        let samples = Samples::new(&checked.domains, &derived.definitions);
        let known = checked.requirements.iter().map(|requirement| samples.of(&requirement.value)).collect();
        let (found, radicands) = (Vec::new(), Vec::new());
        Self { checked, derived, formulas, report, ranges, samples, known, found, radicands }
    }

    /// Formulas behind the definitions that they depend on.
    fn with_definitions(&self, formulas: &[Sourced<'a>]) -> Vec<Sourced<'a>> {
        let outputs = formulas.iter().map(|sourced| sourced.formula.clone()).collect();
        let definitions = self.equations(outputs).origins;
        definitions.into_iter().map(|index| self.formulas.definitions[index]).chain(formulas.iter().copied()).collect()
    }

    /// Takes up what formulas need.
    fn settle(&mut self, origin: Origin, formulas: Vec<Sourced<'a>>) {
        for Need { subject, region, domain } in find_needs(formulas, &self.formulas.definitions) {
            let value = subject.formula();
            let values = self.ranges.of(&value);
            if !domain.nonzero && origin == Origin::Matrices {
                self.radicands.push((region, subject));
            }
            if meets(values, domain) {
                continue;
            }
            if domain.nonzero && is_zero(&value, &self.samples, self.derived) {
                self.report.error(region, symbolic::Undefined::DivisionByZero);
            } else if !domain.nonzero && values.is_negative() {
                self.report.error(region, symbolic::Undefined::RootOfNegative);
            } else {
                self.require(value, domain, subject.text(&self.derived.names), region, origin.clone());
            }
        }
    }

    /// Takes up what a part of the mechanism has to be.
    fn meet(&mut self, Demand { what, value, text, region, domain, whole, refusal }: Demand) {
        let values = self.ranges.of(&value);
        let sign = whole.and_then(|whole| self.find_sign(&value, &whole));
        if meets(values, domain)
            || sign == Some(Sign::Positive)
            || !domain.excludes_zero() && is_zero(&value, &self.samples, self.derived)
        {
            return;
        }
        if values.is_negative() || sign == Some(Sign::Negative) {
            self.report.error(region, refusal);
        } else {
            self.require(value, domain, text, region, Origin::Mechanism(what));
        }
    }

    /// Makes a requirement of it that a formula has values of a domain, unless others imply it.
    fn require(&mut self, value: Formula, domain: Domain, text: String, region: Region, origin: Origin) {
        if self.is_implied(&value, domain) {
            return;
        }
        add_facts(&mut self.ranges, &value, domain, self.derived);
        self.known.push(self.samples.of(&value));
        self.found.push(Requirement { text, unit: String::new(), region, value, domain, origin });
    }

    /// The sign of a formula that is a multiple of a positive one.
    fn find_sign(&self, value: &Formula, positive: &Formula) -> Option<Sign> {
        let is_positive = meets(self.ranges.of(positive), Domain::POSITIVE);
        if !is_positive || !maybe_multiples(&self.samples.of(value), &self.samples.of(positive)) {
            return None;
        }
        // A failure of the engine is reported where it compiles the model.
        let signs = symbolic::find_multiples(self.equations(vec![value.clone(), positive.clone()]));
        signs.ok()?.into_iter().next()?
    }

    /// Reports roots of what nothing keeps from zero: they have no derivative there.
    fn refuse_roots_of_zero(&mut self) {
        for (region, subject) in std::mem::take(&mut self.radicands) {
            let value = subject.formula();
            if !self.ranges.of(&value).excludes_zero() && !self.is_implied(&value, Domain::NONZERO) {
                let text = subject.text(&self.derived.names);
                let message = format!(
                    "the root of `{text}` has no derivative where that is 0: expected a domain or `require {text} > 0;`, \
                     since the model asks for `derivatives`"
                );
                self.report.error(region, message);
            }
        }
    }

    /// Whether a formula is a multiple of one that a requirement bounds, and so has no values outside a domain.
    fn is_implied(&self, value: &Formula, domain: Domain) -> bool {
        let values = self.samples.of(value);
        let known = self.checked.requirements.iter().chain(&self.found).zip(&self.known);
        let known: Vec<&Requirement> =
            known.filter(|(_, at)| maybe_multiples(&values, at)).map(|(known, _)| known).collect();
        if known.is_empty() {
            return false;
        }
        let outputs = [value].into_iter().chain(known.iter().map(|known| &known.value)).cloned().collect();
        // A failure of the engine is reported where it compiles the model.
        let signs = symbolic::find_multiples(self.equations(outputs)).unwrap_or_default();
        known.into_iter().zip(signs).any(|(known, sign)| match sign {
            Some(Sign::Positive) => meets(known.domain.into(), domain),
            Some(Sign::Negative) => meets(-Interval::from(known.domain), domain),
            None => false,
        })
    }

    fn equations(&self, outputs: Vec<Formula>) -> Equations {
        Equations::of_formulas(self.checked.domains.len(), &self.derived.definitions, outputs)
    }
}

/// Notes that a formula has values of a domain only, and so have the formulas of definitions that it stands for.
fn add_facts<'a>(ranges: &mut Ranges, mut value: &'a Formula, domain: Domain, derived: &'a Derived) {
    ranges.add_fact(value, domain.into());
    while let Formula::Definition(index) = value {
        value = &derived.definitions[*index];
        ranges.add_fact(value, domain.into());
    }
}

/// Whether values are inside a domain that leaves out zero, negative numbers or both.
fn meets(values: Interval, domain: Domain) -> bool {
    (domain.lower == Bound::Unbounded || values.is_nonnegative()) && (!domain.excludes_zero() || values.excludes_zero())
}
