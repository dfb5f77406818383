//! Parameter sets against the requirements.

use crate::formula::Formula;
use crate::model::{Origin, ParameterSet, Requirement};
use crate::report::{Report, number};

/// Reports sets that do not fulfil a requirement; only for a declaration without mistakes.
pub fn check_sets(sets: &[&ParameterSet], definitions: &[Formula], requirements: &[Requirement], report: &mut Report) {
    for set in sets {
        let mut values = Vec::with_capacity(definitions.len());
        for definition in definitions {
            values.push(definition.evaluate(&set.values, &values));
        }
        let mut holds = true;
        for requirement in requirements {
            let value = requirement.value.evaluate(&set.values, &values);
            // Each has a value if those before it hold.
            let is_known = holds || value.is_finite();
            if is_known && !requirement.domain.contains(value) {
                holds = false;
                let Requirement { text, domain, origin, .. } = requirement;
                let subject = match origin {
                    Origin::Mechanism(what) => format!("{what}, `{text}`,"),
                    _ => format!("`{text}`"),
                };
                let why = match (origin, domain.nonzero) {
                    (Origin::Declared | Origin::Mechanism(_), _) => "",
                    (_, true) => ", and a formula divides by it",
                    (_, false) => ", and a formula takes its root",
                };
                let (name, value) = (&set.name, number(value));
                let message = format!("{subject} is {value} in the set `{name}`{why}: expected {domain}");
                report.error(&set.name, message);
            }
        }
    }
}
