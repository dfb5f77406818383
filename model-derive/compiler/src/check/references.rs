//! Where names are used, so that editors lead from a use to its declaration.

use proc_macro2::Ident;

use super::names::{Meaning, Scope};
use super::units::Dimension;
use crate::model::{References, Target};
use crate::syntax::Declaration;

/// All uses of parameters and definitions, in formulas and in parameter sets; `dimensions` are those of the definitions.
pub fn references(declaration: &Declaration, scope: &Scope, dimensions: &[Option<Dimension>]) -> References {
    let mut uses = Vec::new();
    let mut note = |name: &Ident| match scope.get(name) {
        Some(Meaning::Parameter(_)) => uses.push((Target::Parameter, name.clone())),
        Some(Meaning::Definition(_)) => uses.push((Target::Definition, name.clone())),
        Some(Meaning::Coordinate | Meaning::Refused) | None => {}
    };
    if let Some(mechanism) = &declaration.mechanism {
        mechanism.formulas().for_each(|formula| formula.names(&mut note));
    }
    let Declaration { definitions, requirements, assertions, matrices, sets, .. } = declaration;
    let written = || definitions.iter().filter(|definition| !definition.derived);
    let formulas = written().map(|definition| &definition.value);
    let formulas = formulas.chain(requirements.iter().map(|requirement| &requirement.value));
    // The entries of matrices are written elsewhere, if at all.
    let asserted = assertions.iter().flat_map(|assertion| {
        let left = Some(&assertion.left).filter(|_| assertion.entry.is_none());
        left.into_iter().chain([&assertion.right])
    });
    // Those of a mechanism are written nowhere.
    let matrices = if declaration.mechanism.is_some() { &[] } else { &matrices[..] };
    let entries = matrices.iter().flat_map(|matrix| matrix.rows.iter().flat_map(|(_, row)| row));
    formulas.chain(asserted).chain(entries).for_each(|formula| formula.names(&mut note));
    for entry in sets.iter().flat_map(|set| &set.values) {
        // In a set a name is a parameter's.
        if matches!(scope.get(&entry.name), Some(Meaning::Parameter(_))) {
            note(&entry.name);
        }
    }
    let definition = |index: usize| {
        let unit = dimensions[index].map(|dimension| format!(", {}", dimension.place())).unwrap_or_default();
        (definitions[index].name.clone(), format!("`{}`{unit}", definitions[index].value.to_string()))
    };
    // A second definition of one name is a mistake, and reported.
    let first = |index: &usize| scope.get(&definitions[*index].name) == Some(Meaning::Definition(*index));
    References {
        definitions: (0..written().count()).filter(first).map(definition).collect(),
        uses,
        matrices: matrices.iter().map(|matrix| (matrix.name, matrix.span)).collect(),
    }
}
