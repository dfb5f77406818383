//! Divisors that can be zero and radicands that can be negative: what nobody has excluded becomes a requirement.

use std::collections::HashSet;

use proc_macro2::Ident;

use super::intervals::Interval;
use super::ranges::{Constants, Ranges};
use super::samples::{Samples, maybe_multiples, maybe_zero};
use crate::check::definitions::Resolved;
use crate::check::names::{Meaning, Scope};
use crate::check::resolve;
use crate::equations::Equations;
use crate::formula::Formula;
use crate::kinematics::Kinematics;
use crate::model::{Domain, Matrices, Origin, Requirement};
use crate::report::{Region, Report};
use crate::symbolic::{self, Depth, Proof, Sign};
use crate::syntax::{Declaration, Expression, Kind};

/// A checked declaration, before it is a model.
pub struct Checked<'a> {
    pub declaration: &'a Declaration,
    pub resolved: &'a Resolved,
    pub domains: &'a [Domain],
    pub definitions: &'a [(Ident, Formula)],
    pub requirements: &'a [Requirement],
    pub matrices: &'a Matrices,
    pub kinematics: Option<&'a Kinematics<Formula>>,
    /// Both sides of each assertion.
    pub assertions: &'a [[Formula; 2]],
}

/// What a formula needs to have a value.
#[derive(Clone, Debug)]
struct Need {
    formula: Expression,
    /// Where it divides or is under a root.
    region: Region,
    /// Other values than zero, or for a root those that are not negative.
    domain: Domain,
}

impl Need {
    fn of(formula: &Expression, domain: Domain) -> Self {
        Self { formula: formula.clone(), region: formula.region, domain }
    }
}

/// The requirements that formulas need to have a value, and that the domains and other requirements do not imply; each
/// has a value itself if those before it hold.
pub fn requirements(checked: &Checked<'_>, scope: &mut Scope, report: &mut Report) -> Vec<Requirement> {
    let mut search = Search::new(checked, scope, report);
    let Checked { declaration, requirements, matrices, kinematics, .. } = *checked;
    let entries = matrices.iter().flat_map(|(_, rows)| rows.iter().flatten());
    let entries = entries.chain(kinematics.iter().flat_map(|kinematics| kinematics.formulas())).cloned().collect();
    let conditions = requirements.iter().map(|requirement| requirement.value.clone()).collect();
    // What is derived from a mechanism needs what that does, but in other words.
    let given = declaration.mechanism.iter().flat_map(|mechanism| mechanism.formulas());
    search.settle(Origin::Matrices, Vec::new(), given);
    let written = declaration.matrices.iter().flat_map(|matrix| matrix.rows.iter().flat_map(|(_, row)| row));
    let written = written.chain(declaration.kinematics.iter().flat_map(|kinematics| kinematics.formulas()));
    search.settle(Origin::Matrices, search.equations(entries).origins, written);
    if declaration.derivatives.is_some() {
        search.refuse_roots_of_zero();
    }
    let written = declaration.requirements.iter().map(|requirement| &requirement.value);
    search.settle(Origin::Requirements, search.equations(conditions).origins, written);
    // At run time nothing depends on a claim, so only what never has a value is a mistake there.
    let needed = search.found.len();
    let claimed = checked.assertions.iter().flatten().cloned().collect();
    let written = declaration.assertions.iter().flat_map(|assertion| [&assertion.left, &assertion.right]);
    search.settle(Origin::Requirements, search.equations(claimed).origins, written);
    search.found.truncate(needed);
    search.found
}

struct Search<'a> {
    checked: &'a Checked<'a>,
    scope: &'a mut Scope,
    report: &'a mut Report,
    /// For each position in the declaration the one in the order of definitions.
    new: Vec<usize>,
    /// The formulas of the definitions as written, in their order.
    sources: Vec<&'a Expression>,
    ranges: Ranges,
    samples: Samples,
    /// The values at the samples of what requirements bound, the declared ones first.
    known: Vec<Vec<Interval>>,
    found: Vec<Requirement>,
    /// What the matrices take the root of, with where they do.
    radicands: Vec<(Region, Formula, String)>,
}

impl<'a> Search<'a> {
    fn new(checked: &'a Checked<'a>, scope: &'a mut Scope, report: &'a mut Report) -> Self {
        let mut ranges = Ranges::new(Constants::Nearest, checked.domains.iter().copied().map(Interval::from).collect());
        for Requirement { value, domain, .. } in checked.requirements {
            ranges.add_fact(value, (*domain).into());
            // The definition's own formula has the same values.
            let mut value = value;
            while let Formula::Definition(index) = value {
                value = &checked.definitions[*index].1;
                ranges.add_fact(value, (*domain).into());
            }
        }
        checked.definitions.iter().for_each(|(_, expr)| ranges.push_definition(expr));
        let new = checked.resolved.new_positions();
        let sources = checked.resolved.sources(checked.declaration);
        let samples = Samples::new(checked.domains, checked.definitions);
        let known = checked.requirements.iter().map(|requirement| samples.of(&requirement.value)).collect();
        Self { checked, scope, report, new, sources, ranges, samples, known, found: Vec::new(), radicands: Vec::new() }
    }

    /// Takes up what formulas and the definitions that they use need.
    fn settle(&mut self, origin: Origin, definitions: Vec<usize>, formulas: impl Iterator<Item = &'a Expression>) {
        let mut needs = Vec::new();
        let definitions: Vec<&Expression> = definitions.into_iter().map(|index| self.sources[index]).collect();
        definitions.into_iter().chain(formulas).for_each(|formula| collect(formula, &mut needs));
        let mut visited = HashSet::new();
        let parts: Vec<Need> = needs.into_iter().flat_map(|need| self.parts(need, &mut visited)).collect();
        for Need { formula, region, domain } in parts {
            let value = resolve::expression(&formula, self.scope, self.report).renumbered(&self.new);
            let values = self.ranges.of(&value);
            if !domain.nonzero && origin == Origin::Matrices {
                self.radicands.push((region, value.clone(), formula.to_string()));
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
                self.found.push(Requirement { text: formula.to_string(), region, value, domain, origin });
            }
        }
    }

    /// Reports roots of what nothing keeps from zero: they have no derivative there.
    fn refuse_roots_of_zero(&mut self) {
        for (region, value, text) in std::mem::take(&mut self.radicands) {
            if !self.ranges.of(&value).excludes_zero() && !self.is_implied(&value, Domain::NONZERO) {
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
    fn parts(&self, need: Need, visited: &mut HashSet<(usize, bool)>) -> Vec<Need> {
        let Need { formula, region, domain } = need;
        let nonzero = domain.nonzero;
        let mut parts = Vec::new();
        let mut open = vec![&formula];
        while let Some(formula) = open.pop() {
            match &formula.kind {
                Kind::Name(name) if name == "pi" => {}
                Kind::Name(name) => match self.scope.get(name) {
                    Some(Meaning::Definition(declared)) => {
                        let index = self.new[declared];
                        if visited.insert((index, nonzero)) {
                            open.push(self.sources[index]);
                        }
                    }
                    _ => parts.push(Need { formula: formula.clone(), region, domain }),
                },
                Kind::Product(factors) if nonzero => {
                    open.extend(factors.iter().rev().filter(|factor| !factor.inverse).map(|factor| &factor.value));
                }
                Kind::Power(_, exponent) if nonzero && *exponent <= 0 => {}
                Kind::Power(base, _) if nonzero => open.push(base),
                Kind::Call(function, argument) if nonzero && function == "sqrt" => open.push(argument),
                Kind::Sum(terms) if nonzero && terms.len() == 1 => open.push(&terms[0].value),
                _ => parts.push(Need { formula: formula.clone(), region, domain }),
            }
        }
        parts
    }

    /// Whether a formula is proved to be zero for all parameters.
    fn is_zero(&self, value: &Formula) -> bool {
        if !maybe_zero(&self.samples.of(value)) {
            return false;
        }
        let proofs = symbolic::proofs(vec![self.equations(vec![value.clone(), Formula::zero()])], Depth::Formulas);
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
        let signs = symbolic::multiples(self.equations(outputs)).unwrap_or_default();
        known.into_iter().zip(signs).any(|(known, sign)| match sign {
            Some(Sign::Positive) => meets(known.domain.into(), domain),
            Some(Sign::Negative) => meets(-Interval::from(known.domain), domain),
            None => false,
        })
    }

    fn equations(&self, outputs: Vec<Formula>) -> Equations {
        Equations::of_formulas(self.checked.domains.len(), self.checked.definitions, outputs)
    }
}

/// Whether values are inside the domain of a need.
fn meets(values: Interval, domain: Domain) -> bool {
    if domain.nonzero { values.excludes_zero() } else { values.is_nonnegative() }
}

/// Notes what a formula needs, the inner parts first.
fn collect(formula: &Expression, needs: &mut Vec<Need>) {
    match &formula.kind {
        Kind::Number(_) | Kind::Quantity(..) | Kind::Name(_) => {}
        Kind::Sum(terms) => terms.iter().for_each(|term| collect(&term.value, needs)),
        Kind::Product(factors) => {
            for factor in factors {
                collect(&factor.value, needs);
                if factor.inverse {
                    needs.push(Need::of(&factor.value, Domain::NONZERO));
                }
            }
        }
        Kind::Power(base, exponent) => {
            collect(base, needs);
            if *exponent < 0 {
                needs.push(Need::of(base, Domain::NONZERO));
            }
        }
        Kind::Call(function, argument) => {
            collect(argument, needs);
            if function == "tan" {
                let kind = Kind::Call(Ident::new("cos", function.span()), argument.clone());
                needs.push(Need::of(&Expression { kind, region: formula.region }, Domain::NONZERO));
            } else if function == "sqrt" {
                needs.push(Need::of(argument, Domain::NONNEGATIVE));
            }
        }
    }
}
