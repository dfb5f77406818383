//! The derivatives that are asked for, against the matrices that there are.

use crate::check::Checked;
use crate::derivation::Derived;
use crate::equations::Equations;
use crate::formula::Formula;
use crate::report::Report;

/// Reports matrices that the model does not have, and parameters that none of the matrices depends on.
pub fn check_asked(checked: &Checked<'_>, derived: &Derived, report: &mut Report) {
    let declaration = checked.declaration;
    let (Some(written), Some(asked)) = (&declaration.derivatives, &checked.derivatives) else { return };
    let known: Vec<String> = derived.matrices.iter().map(|(name, _)| format!("`{}`", name.name())).collect();
    for (matrix, span) in written.matrices.iter().flatten() {
        if derived.matrices.iter().all(|(name, _)| name != matrix) {
            let (name, known) = (matrix.name(), known.join(", "));
            report.error(*span, format!("the model has no matrix `{name}`: expected one of its matrices, {known}"));
        }
    }
    if !report.is_empty() {
        return;
    }
    let matrices = derived.matrices.iter().filter(|(name, _)| asked.has(*name));
    let entries = matrices.flat_map(|(_, rows)| rows.iter().flatten()).cloned().collect();
    let Equations { definitions, outputs, .. } =
        Equations::of_formulas(declaration.parameters.len(), &derived.definitions, entries);
    let mut used = vec![false; declaration.parameters.len()];
    definitions.iter().chain(&outputs).for_each(|formula| {
        formula.walk(&mut |part| {
            if let Formula::Parameter(index) = part {
                used[*index] = true;
            }
        });
    });
    for name in written.parameters.iter().flatten() {
        let index = declaration.parameters.iter().position(|parameter| parameter.name == *name);
        if index.is_some_and(|index| !used[index]) {
            let of = match &written.matrices {
                None => "no matrix depends".to_string(),
                Some(matrices) => {
                    let names: Vec<String> =
                        matrices.iter().map(|(matrix, _)| format!("`{}`", matrix.name())).collect();
                    format!("no entry of {} depends", names.join(", "))
                }
            };
            report.error(name, format!("{of} on `{name}`: expected a parameter with derivatives that are not zero"));
        }
    }
}
