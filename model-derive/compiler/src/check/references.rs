//! Where names are used, so that editors lead from a use to its declaration.

use std::collections::HashSet;

use proc_macro2::Ident;

use super::names::{Meaning, Scope};
use super::units::dimension::Dimension;
use crate::model::{References, Target};
use crate::syntax::{Declaration, Definition, Matrix};

/// All uses of parameters and definitions, in formulas and in parameter sets; `dimensions` are those of the definitions.
pub fn find_references(declaration: &Declaration, scope: &Scope, dimensions: &[Option<Dimension>]) -> References {
    let mut uses = Vec::new();
    let mut note = |name: &Ident| match scope.get(name) {
        Some(Meaning::Parameter(_)) => uses.push((Target::Parameter, name.clone())),
        Some(Meaning::Definition(_)) => uses.push((Target::Definition, name.clone())),
        Some(Meaning::Coordinate | Meaning::Speed(_) | Meaning::Refused) | None => {}
    };
    declaration.attributes().for_each(|formula| formula.names(&mut note));
    let Declaration { definitions, requirements, assertions, asserted, matrices, added, sets, .. } = declaration;
    let formulas = definitions.iter().map(|definition| &definition.value);
    let formulas = formulas.chain(requirements.iter().map(|requirement| &requirement.value));
    let sides = assertions.iter().flat_map(|assertion| [&assertion.left, &assertion.right]);
    // Matrices beside a mechanism are a mistake.
    let matrices = if declaration.mechanism.is_some() { &[] } else { &matrices[..] };
    let wholes = declaration.wholes.iter().map(|(_, matrix)| matrix);
    let entries = asserted.iter().chain(matrices).chain(wholes).flat_map(Matrix::entries);
    formulas.chain(sides).chain(entries).for_each(|formula| formula.names(&mut note));
    for entry in sets.iter().flat_map(|set| &set.values) {
        // In a set a name is a parameter's.
        if matches!(scope.get(&entry.name), Some(Meaning::Parameter(_))) {
            note(&entry.name);
        }
    }
    // A second definition of one name is a mistake, and reported.
    let mut known = HashSet::new();
    let first = definitions.iter().filter(|definition| known.insert(definition.name.to_string()));
    let definition = |definition: &Definition| {
        let dimension = match scope.get(&definition.name) {
            Some(Meaning::Definition(position)) => dimensions[position],
            _ => return None,
        };
        let unit = dimension.map(|dimension| format!(", {}", dimension.place())).unwrap_or_default();
        Some((definition.name.clone(), format!("`{}`{unit}", definition.value)))
    };
    let parts =
        declaration.wholes.iter().flat_map(|(whole, matrix)| whole.parts().iter().map(|part| (*part, matrix.span)));
    References {
        definitions: first.filter_map(definition).collect(),
        uses,
        matrices: matrices.iter().chain(added).map(|matrix| (matrix.name, matrix.span)).chain(parts).collect(),
    }
}
