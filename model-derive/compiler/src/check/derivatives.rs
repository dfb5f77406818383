//! Which derivatives of the matrices are asked for.

use std::collections::HashSet;

use proc_macro2::Ident;

use super::names::{Meaning, Scope};
use crate::model::AskedDerivatives;
use crate::report::Report;
use crate::syntax::Declaration;

/// What is asked for. Unknown names, and what is named twice, are reported; of mechanisms it is not known yet which matrices
/// there are.
pub fn read_derivatives(declaration: &Declaration, scope: &mut Scope, report: &mut Report) -> Option<AskedDerivatives> {
    let asked = declaration.derivatives.as_ref()?;
    let mut seen = HashSet::new();
    for (matrix, span) in asked.matrices.iter().flatten() {
        if !seen.insert(matrix) {
            report.error(*span, format!("`{}` is asked for twice: expected each matrix once", matrix.name()));
        }
    }
    let mut parameters = HashSet::new();
    for name in asked.parameters.iter().flatten() {
        if let Some(index) = find_parameter(name, scope, report)
            && !parameters.insert(index)
        {
            report.error(name, format!("`{name}` is asked for twice: expected each parameter once"));
        }
    }
    Some(AskedDerivatives {
        span: asked.span,
        matrices: asked.matrices.as_ref().map(|matrices| matrices.iter().map(|(name, _)| *name).collect()),
        parameters: (0..declaration.parameters.len())
            .map(|index| asked.parameters.is_none() || parameters.contains(&index))
            .collect(),
    })
}

fn find_parameter(name: &Ident, scope: &mut Scope, report: &mut Report) -> Option<usize> {
    let what = match scope.get(name) {
        Some(Meaning::Parameter(index)) => return Some(index),
        Some(Meaning::Refused) => return None,
        Some(Meaning::Definition(_)) => "a definition",
        Some(Meaning::Coordinate) => "a coordinate",
        Some(Meaning::Speed(_)) => "the speed",
        None => {
            let hint = scope.suggest(name);
            report.error(name, format!("unknown parameter `{name}`: expected a parameter of the model{hint}"));
            return None;
        }
    };
    report.error(name, format!("`{name}` is {what}: expected a parameter, with respect to which to derive"));
    None
}
