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
        for requirement in requirements {
            let value = requirement.value.evaluate(&set.values, &values);
            if !requirement.domain.contains(value) {
                let Requirement { text, domain, origin, .. } = requirement;
                let why = match (origin, domain.nonzero) {
                    (Origin::Declared, _) => "",
                    (_, true) => ", and a formula divides by it",
                    (_, false) => ", and a formula takes its root",
                };
                let message =
                    format!("`{text}` is {} in the set `{}`{why}: expected {domain}", number(value), set.name);
                report.error(&set.name, message);
            }
        }
    }
}
