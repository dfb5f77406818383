//! What formulas divide by and take roots of: what they need to have a value.

use std::collections::HashSet;

use super::sourced::Sourced;
use crate::domain::Domain;
use crate::formula::{Formula, Function, Names};
use crate::report::Region;

/// What a formula needs to have a value.
#[derive(Clone, Copy, Debug)]
pub struct Need<'a> {
    pub subject: Subject<'a>,
    /// Where it divides or is under a root.
    pub region: Region,
    /// Other values than zero, or for a root those that are not negative.
    pub domain: Domain,
}

/// What must have values inside a domain.
#[derive(Clone, Copy, Debug)]
pub enum Subject<'a> {
    Formula(Sourced<'a>),
    /// The cosine of a formula, by which its tangent divides.
    Cosine(Sourced<'a>),
}

impl Subject<'_> {
    pub fn formula(self) -> Formula {
        match self {
            Self::Formula(Sourced { formula, .. }) => formula.clone(),
            Self::Cosine(Sourced { formula, .. }) => Formula::Call(Function::Cos, Box::new(formula.clone())),
        }
    }

    pub fn text(self, names: &Names) -> String {
        match self {
            Self::Formula(sourced) => sourced.text(names),
            Self::Cosine(sourced) => format!("cos({})", sourced.text(names)),
        }
    }
}

/// Finds what formulas need, each need once, by the parts that decide; `definitions` are those of the model.
pub fn find_needs<'a>(formulas: Vec<Sourced<'a>>, definitions: &[Sourced<'a>]) -> Vec<Need<'a>> {
    let mut needs = Vec::new();
    formulas.into_iter().for_each(|formula| collect_needs(formula, &mut needs));
    let mut visited = HashSet::new();
    needs.into_iter().flat_map(|need| open(need, definitions, &mut visited)).collect()
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

/// The same need of the parts that decide: a product is not zero if no factor is. Definitions are opened, since
/// what a user of the model sees are the parameters; each once.
fn open<'a>(need: Need<'a>, definitions: &[Sourced<'a>], visited: &mut HashSet<(usize, bool)>) -> Vec<Need<'a>> {
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
                    open.push(definitions[*index]);
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
