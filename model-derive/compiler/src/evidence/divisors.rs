//! Divisors that can be zero and radicands that can be negative: what nobody has excluded becomes a requirement.

use std::collections::HashSet;

use super::intervals::Interval;
use super::ranges::{Ranges, Reading};
use super::samples::{Samples, maybe_multiples, maybe_zero};
use super::sourced::Sourced;
use crate::check::Checked;
use crate::derivation::Derived;
use crate::domain::Domain;
use crate::equations::Equations;
use crate::formula::{Formula, Function, Names};
use crate::model::{Origin, Requirement};
use crate::report::{Region, Report};
use crate::symbolic::{self, Depth, Proof, Sign};

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

/// What a formula needs to have a value.
#[derive(Clone, Copy, Debug)]
struct Need<'a> {
    subject: Subject<'a>,
    /// Where it divides or is under a root.
    region: Region,
    /// Other values than zero, or for a root those that are not negative.
    domain: Domain,
}

/// What must have values inside a domain.
#[derive(Clone, Copy, Debug)]
enum Subject<'a> {
    Formula(Sourced<'a>),
    /// The cosine of a formula, by which its tangent divides.
    Cosine(Sourced<'a>),
}

impl Subject<'_> {
    fn formula(self) -> Formula {
        match self {
            Self::Formula(Sourced { formula, .. }) => formula.clone(),
            Self::Cosine(Sourced { formula, .. }) => Formula::Call(Function::Cos, Box::new(formula.clone())),
        }
    }

    fn text(self, names: &Names) -> String {
        match self {
            Self::Formula(sourced) => sourced.text(names),
            Self::Cosine(sourced) => format!("cos({})", sourced.text(names)),
        }
    }
}

/// Finds the requirements that formulas need to have a value, and that the domains and other requirements do not imply;
/// each has a value itself if those before it hold.
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
            ranges.add_fact(value, (*domain).into());
            // The definition's own formula has the same values.
            let mut value = value;
            while let Formula::Definition(index) = value {
                value = &derived.definitions[*index];
                ranges.add_fact(value, (*domain).into());
            }
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
        let mut needs = Vec::new();
        formulas.into_iter().for_each(|formula| collect_needs(formula, &mut needs));
        let mut visited = HashSet::new();
        let parts: Vec<Need<'a>> = needs.into_iter().flat_map(|need| self.open(need, &mut visited)).collect();
        for Need { subject, region, domain } in parts {
            let value = subject.formula();
            let values = self.ranges.of(&value);
            if !domain.nonzero && origin == Origin::Matrices {
                self.radicands.push((region, subject));
            }
            if meets(values, domain) {
                continue;
            }
            if domain.nonzero && self.is_zero(&value) {
                self.report.error(region, symbolic::Undefined::DivisionByZero);
            } else if !domain.nonzero && values.is_negative() {
                self.report.error(region, symbolic::Undefined::RootOfNegative);
            } else if !self.is_implied(&value, domain) {
                self.ranges.add_fact(&value, domain.into());
                self.known.push(self.samples.of(&value));
                let text = subject.text(&self.derived.names);
                self.found.push(Requirement { text, unit: String::new(), region, value, domain, origin });
            }
        }
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

    /// The same need of the parts that decide: a product is not zero if no factor is. Definitions are opened, since
    /// what a user of the model sees are the parameters; each once.
    fn open(&self, need: Need<'a>, visited: &mut HashSet<(usize, bool)>) -> Vec<Need<'a>> {
        let Need { subject, region, domain } = need;
        let Subject::Formula(sourced) = subject else { return vec![need] };
        let nonzero = domain.nonzero;
        let mut needs = Vec::new();
        let mut open = vec![sourced];
        while let Some(sourced) = open.pop() {
            let parts = sourced.parts();
            match sourced.formula {
                Formula::Pi => {}
                Formula::Definition(index) => {
                    if visited.insert((*index, nonzero)) {
                        open.push(self.formulas.definitions[*index]);
                    }
                }
                Formula::Product(factors) if nonzero && !parts.is_empty() => {
                    let factors = factors.iter().zip(parts).rev();
                    open.extend(factors.filter(|(factor, _)| !factor.inverse).map(|(_, part)| part));
                }
                Formula::Power(_, exponent) if nonzero && *exponent <= 0 => {}
                Formula::Power(..) | Formula::Call(Function::Sqrt, _) if nonzero => open.extend(parts),
                Formula::Sum(terms) if nonzero && terms.len() == 1 => open.extend(parts),
                _ => needs.push(Need { subject: Subject::Formula(sourced), region, domain }),
            }
        }
        needs
    }

    /// Whether a formula is proved to be zero for all parameters.
    fn is_zero(&self, value: &Formula) -> bool {
        if !maybe_zero(&self.samples.of(value)) {
            return false;
        }
        let proofs = symbolic::prove_equal(vec![self.equations(vec![value.clone(), Formula::zero()])], Depth::Formulas);
        proofs.is_ok_and(|proofs| proofs.contains(&Proof::Found))
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

/// Whether values are inside the domain of a need.
fn meets(values: Interval, domain: Domain) -> bool {
    if domain.nonzero { values.excludes_zero() } else { values.is_nonnegative() }
}

/// Notes what a formula needs, the inner parts first.
fn collect_needs<'a>(sourced: Sourced<'a>, needs: &mut Vec<Need<'a>>) {
    let need = |part: Sourced<'a>, domain| Need { subject: Subject::Formula(part), region: part.region(), domain };
    let parts = sourced.parts();
    if let Formula::Product(factors) = sourced.formula {
        for (factor, part) in factors.iter().zip(parts) {
            collect_needs(part, needs);
            if factor.inverse {
                needs.push(need(part, Domain::NONZERO));
            }
        }
        return;
    }
    parts.iter().for_each(|part| collect_needs(*part, needs));
    match sourced.formula {
        Formula::Power(_, exponent) if *exponent < 0 => {
            needs.extend(parts.into_iter().map(|base| need(base, Domain::NONZERO)));
        }
        Formula::Call(Function::Tan, _) => {
            let region = sourced.region();
            let cosine = |part| Need { subject: Subject::Cosine(part), region, domain: Domain::NONZERO };
            needs.extend(parts.into_iter().map(cosine));
        }
        Formula::Call(Function::Sqrt, _) => {
            needs.extend(parts.into_iter().map(|radicand| need(radicand, Domain::NONNEGATIVE)));
        }
        _ => {}
    }
}
