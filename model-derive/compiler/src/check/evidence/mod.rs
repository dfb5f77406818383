//! What a declaration without other mistakes says of itself, against what its formulas give.

mod claims;
mod counterexample;
mod definite;
mod divisors;
mod intervals;
mod published;
mod ranges;
mod samples;

pub use self::claims::symmetric;

use self::claims::Claim;
use self::counterexample::Space;
use super::definitions::Resolved;
use super::names::Scope;
use super::sets;
use super::units::Dimensions;
use crate::formula::Formula;
use crate::kinematics::Kinematics;
use crate::model::{Domain, Matrices, ParameterSet, Requirement};
use crate::report::{Region, Report};
use crate::syntax::{Assertion, Declaration};

/// A declaration, and what became of its formulas; definitions are numbered in their order.
#[derive(Debug)]
pub struct Evidence<'a> {
    pub declaration: &'a Declaration,
    pub resolved: &'a Resolved,
    pub dimensions: &'a Dimensions,
    pub domains: &'a [Domain],
    pub matrices: &'a Matrices,
    pub kinematics: Option<&'a Kinematics<Formula>>,
    /// Where the entries of the matrices stand, row by row.
    pub entries: &'a [Region],
    /// Both sides of each assertion.
    pub assertions: &'a [[Formula; 2]],
    pub sets: &'a [ParameterSet],
}

impl Evidence<'_> {
    /// Puts the requirements that the formulas have of themselves before the declared ones, and reports what is not as
    /// it is said to be.
    pub fn check(
        &self,
        mut requirements: Vec<Requirement>,
        scope: &mut Scope,
        report: &mut Report,
    ) -> Vec<Requirement> {
        let Self { declaration, resolved, domains, matrices, kinematics, assertions, sets, .. } = *self;
        let definitions = &resolved.in_order(declaration);
        let checked = divisors::Checked {
            declaration,
            resolved,
            domains,
            definitions,
            requirements: &requirements,
            matrices,
            kinematics,
            assertions,
        };
        // Whatever is needed for a requirement to have a value comes before it.
        let mut all = divisors::requirements(&checked, scope, report);
        all.append(&mut requirements);
        let formulas_have_values = report.is_empty();
        sets::check_requirements(sets, definitions, &all, report);
        let sets_have_values = report.is_empty();
        let names: Vec<String> = declaration.parameters.iter().map(|parameter| parameter.name.to_string()).collect();
        let space = Space { domains, requirements: &all, sets };
        if formulas_have_values {
            claims::check(&self.claims(), &names, definitions, &space, report);
        }
        if sets_have_values {
            published::check(declaration, self.dimensions, &resolved.order, report);
        }
        all
    }

    fn claims(&self) -> Vec<Claim> {
        let mut claims = claims::mirrored(&claims::symmetric(self.declaration), self.matrices, self.entries);
        let asserted = self.declaration.assertions.iter().zip(self.assertions);
        claims.extend(asserted.map(|(Assertion { left, right, entry }, [a, b])| {
            let sides = [(a.clone(), left.region), (b.clone(), right.region)];
            let name = entry.clone().unwrap_or_else(|| left.to_string());
            Claim::asserted([name, right.to_string()], sides)
        }));
        claims
    }
}
