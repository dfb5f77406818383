//! What names stand for and where they are used, so that editors lead from a use to its declaration.

use std::collections::HashSet;

use proc_macro2::{Ident, Span};

use super::names::{Meaning, Scope};
use super::units::dimension::Dimension;
use super::units::known;
use crate::model::{Named, References, Target};
use crate::syntax::{Declaration, Expression, Matrix, Unit, Value};

/// Everything that has a name, and all uses of names; `dimensions` are those of the definitions.
pub fn find_references(declaration: &Declaration, scope: &Scope, dimensions: &[Option<Dimension>]) -> References {
    let formulas = formulas(declaration);
    let mut uses = find_uses(declaration, &formulas, scope);
    let units = units(declaration, &formulas);
    uses.extend(units.iter().map(|name| (Target::Unit, (*name).clone())));

    let named = definitions(declaration, scope, dimensions).into_iter();
    let named = named.chain(coordinates(declaration, scope)).chain(parts(declaration));
    let named = named.chain(units.into_iter().filter_map(describe_unit));
    // A second one of a name is a mistake, and reported.
    let mut known = HashSet::new();
    let named = named.filter(|item| known.insert((item.target, item.name.to_string()))).collect();
    known.extend(declaration.parameters.iter().map(|parameter| (Target::Parameter, parameter.name.to_string())));
    let (uses, unknown) = uses.into_iter().partition(|(target, name)| known.contains(&(*target, name.to_string())));

    let Declaration { added, wholes, .. } = declaration;
    let own = own_matrices(declaration).iter().chain(added).map(|matrix| (matrix.name, matrix.span));
    let wholes = wholes.iter().flat_map(|(whole, matrix)| whole.parts().iter().map(|part| (*part, matrix.span)));
    References { named, uses, unknown, matrices: own.chain(wholes).collect() }
}

/// Matrices beside a mechanism are a mistake.
fn own_matrices(declaration: &Declaration) -> &[Matrix] {
    if declaration.mechanism.is_some() { &[] } else { &declaration.matrices }
}

fn formulas(declaration: &Declaration) -> Vec<&Expression> {
    let Declaration { definitions, requirements, assertions, asserted, wholes, feedback, .. } = declaration;
    let formulas = declaration.attributes().chain(definitions.iter().map(|definition| &definition.value));
    let formulas = formulas.chain(feedback.iter().map(|feedback| &feedback.law));
    let formulas = formulas.chain(requirements.iter().map(|requirement| &requirement.value));
    let formulas = formulas.chain(assertions.iter().flat_map(|assertion| [&assertion.left, &assertion.right]));
    let wholes = wholes.iter().map(|(_, matrix)| matrix);
    let matrices = asserted.iter().chain(own_matrices(declaration)).chain(wholes);
    formulas.chain(matrices.flat_map(Matrix::entries)).collect()
}

/// The uses of parameters and definitions in formulas and sets, and of what may be coordinates and parts in a mechanism.
fn find_uses(declaration: &Declaration, formulas: &[&Expression], scope: &Scope) -> Vec<(Target, Ident)> {
    let mut uses = Vec::new();
    let wheels = declaration.mechanism.iter().flat_map(|mechanism| &mechanism.wheels);
    let wheels: Vec<&Ident> = wheels.map(|wheel| &wheel.name).collect();
    let is_wheel = |name: &Ident| wheels.contains(&name);
    let mut note = |name: &Ident| match scope.get(name) {
        Some(Meaning::Parameter(_)) => uses.push((Target::Parameter, name.clone())),
        Some(Meaning::Definition(_) | Meaning::Speed(_)) => uses.push((Target::Definition, name.clone())),
        None if is_wheel(name) => uses.push((Target::Part, name.clone())),
        None => uses.push((Target::Definition, name.clone())),
        Some(Meaning::Coordinate) => uses.push((Target::Coordinate, name.clone())),
        Some(Meaning::Refused) => {}
    };
    formulas.iter().for_each(|formula| formula.names(&mut note));
    for entry in declaration.sets.iter().flat_map(|set| &set.values) {
        // In a set a name is a parameter's.
        uses.push((Target::Parameter, entry.name.clone()));
    }
    let derived = declaration.derivatives.iter().flat_map(|asked| asked.parameters.iter().flatten());
    uses.extend(derived.map(|name| (Target::Parameter, name.clone())));
    let fed = declaration.feedback.iter().map(|feedback| (Target::Coordinate, feedback.on.clone()));
    uses.extend(fed);
    let Some(mechanism) = &declaration.mechanism else { return uses };
    let moved = mechanism.joints.iter().map(|joint| &joint.name).chain(mechanism.forces.iter().map(|force| &force.on));
    let moved = moved.chain(mechanism.free.iter().flat_map(|free| free.names.iter().map(|(_, name)| name)));
    uses.extend(moved.map(|name| (Target::Coordinate, name.clone())));
    let joined = mechanism.joints.iter().flat_map(|joint| [&joint.parent, &joint.child]);
    let joined = joined.chain(mechanism.fixed.iter().flat_map(|(part, to)| [part, to]));
    let joined = joined.chain(mechanism.wheels.iter().filter_map(|wheel| wheel.carrier.as_ref()));
    let joined = joined.chain(mechanism.free.iter().map(|free| &free.body));
    uses.extend(joined.map(|name| (Target::Part, name.clone())));
    uses
}

/// The names of units, each where it stands.
fn units<'a>(declaration: &'a Declaration, formulas: &[&'a Expression]) -> Vec<&'a Ident> {
    let Declaration { parameters, coordinates, requirements, sets, .. } = declaration;
    let bounds = parameters.iter().flat_map(|parameter| &parameter.bounds);
    let bounds = bounds.chain(requirements.iter().map(|requirement| &requirement.bound));
    let values = bounds.map(|bound| &bound.value);
    let values = values.chain(sets.iter().flat_map(|set| &set.values).filter_map(|entry| entry.value.as_ref()));
    let of_values = values.filter_map(|Value { unit, .. }| unit.as_ref());
    let declared = parameters.iter().filter_map(|parameter| parameter.unit.as_ref());
    let declared = declared.chain(coordinates.iter().filter_map(|coordinate| coordinate.unit.as_ref()));
    let mut units: Vec<&Unit> = declared.chain(of_values).collect();
    formulas.iter().for_each(|formula| formula.units(&mut |unit| units.push(unit)));
    units.into_iter().flat_map(|unit| unit.factors.iter().map(|(name, _)| name)).collect()
}

fn describe_unit(name: &Ident) -> Option<Named> {
    let known = known::find(&name.to_string())?;
    let dimension = known.dimension.to_string();
    let docs = match (known.size, &*dimension) {
        (None, dimension) if dimension == known.name => format!("`{name}`, a base unit of the SI."),
        (None, dimension) => format!("`{name}` = `{dimension}`."),
        (Some(size), "1") => format!("`{name}` = `{size}`."),
        (Some(size), dimension) => format!("`{name}` = `{size} {dimension}`."),
    };
    Some(Named { target: Target::Unit, name: Ident::new(known.name, Span::call_site()), docs })
}

fn definitions(declaration: &Declaration, scope: &Scope, dimensions: &[Option<Dimension>]) -> Vec<Named> {
    let definitions = declaration.definitions.iter().filter_map(|definition| {
        let Some(Meaning::Definition(position)) = scope.get(&definition.name) else { return None };
        let unit = match dimensions[position] {
            Some(dimension) if dimension.is_number() => ", a pure number".to_string(),
            Some(dimension) => format!(", in `{dimension}`"),
            None => String::new(),
        };
        let docs = format!("`{}` = `{}`{unit}.", definition.name, definition.value);
        Some(Named { target: Target::Definition, name: definition.name.clone(), docs })
    });
    let speed = declaration.speed.iter().filter(|speed| matches!(scope.get(&speed.name), Some(Meaning::Speed(_))));
    let speed = speed.map(|speed| {
        let docs = format!("`{}`, the forward speed, in `m/s`.", speed.name);
        Named { target: Target::Definition, name: speed.name.clone(), docs }
    });
    definitions.chain(speed).collect()
}

fn coordinates<'a>(declaration: &'a Declaration, scope: &'a Scope) -> impl Iterator<Item = Named> + 'a {
    let coordinates = declaration.coordinates.iter();
    let coordinates = coordinates.filter(|coordinate| scope.get(&coordinate.name) == Some(Meaning::Coordinate));
    coordinates.map(|coordinate| {
        let name = &coordinate.name;
        let label = coordinate.label.iter().map(|label| format!(", {label}")).collect::<String>();
        let unit = coordinate.unit.iter().map(|unit| format!(", in `{}`", unit.text)).collect::<String>();
        let facts = format!("The coordinate `{name}`{label}{unit}.");
        let docs = if coordinate.docs.is_empty() { facts } else { format!("{}\n\n{facts}", coordinate.docs) };
        Named { target: Target::Coordinate, name: name.clone(), docs }
    })
}

fn parts(declaration: &Declaration) -> impl Iterator<Item = Named> {
    let mechanism = declaration.mechanism.as_slice().iter();
    let bodies = mechanism.clone().flat_map(|mechanism| &mechanism.bodies);
    let bodies = bodies.map(|body| ("body", &body.name, &body.label));
    let wheels = mechanism.flat_map(|mechanism| &mechanism.wheels);
    let wheels = wheels.map(|wheel| ("wheel", &wheel.name, &wheel.label));
    bodies.chain(wheels).map(|(what, name, label)| {
        let label = label.iter().map(|label| format!(", {label}")).collect::<String>();
        Named { target: Target::Part, name: name.clone(), docs: format!("The {what} `{name}`{label}.") }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pipeline;

    const DISC: &str = "model Disc {
        parameters {
            r: m, > 1 mm;
            m: kg, > 0;
            g: N/kg, >= 0, gravity;
        }
        mechanism {
            body R \"rotor\": mass 2 [kg], at (0, 0, -r), inertia 0;
            wheel D: mass m, at (0, 0, -r), radius r, axial m*r^2, radial m*r^2/2;
            fix R to D;
            free D: lean phi, yaw psi;
        }
        coordinates {
            /// To the right.
            phi \"lean\": rad;
            psi: rad;
        }
    }";

    fn references(declaration: &str) -> References {
        match pipeline::read(declaration.parse().expect("tokens")) {
            Ok(model) => model.references,
            Err(refusal) => refusal.model.expect("the rest of the model").references,
        }
    }

    fn docs(references: &References, target: Target) -> Vec<(String, &str)> {
        let named = references.named.iter().filter(|named| named.target == target);
        named.map(|named| (named.name.to_string(), named.docs.as_str())).collect()
    }

    #[test]
    fn coordinates_parts_and_units_are_described() {
        let references = references(DISC);
        let coordinates = [
            ("phi".to_string(), "To the right.\n\nThe coordinate `phi`, lean, in `rad`."),
            ("psi".to_string(), "The coordinate `psi`, in `rad`."),
        ];
        assert_eq!(docs(&references, Target::Coordinate), coordinates);
        let parts = [("R".to_string(), "The body `R`, rotor."), ("D".to_string(), "The wheel `D`.")];
        assert_eq!(docs(&references, Target::Part), parts);
        let units = docs(&references, Target::Unit);
        for unit in [("N", "`N` = `kg*m/s^2`."), ("mm", "`mm` = `0.001 m`."), ("rad", "`rad` = `1`.")] {
            assert!(units.contains(&(unit.0.to_string(), unit.1)), "{units:?}");
        }
    }

    #[test]
    fn every_use_is_noted_where_it_is() {
        let references = references(DISC);
        let lines = |target: Target, name: &str| {
            let uses = references.uses.iter().filter(|(kind, used)| *kind == target && used == name);
            let mut lines: Vec<usize> = uses.map(|(_, used)| used.span().start().line).collect();
            lines.sort_unstable();
            lines
        };
        assert_eq!(lines(Target::Coordinate, "phi"), [11]);
        assert_eq!(lines(Target::Part, "D"), [10, 11]);
        assert_eq!(lines(Target::Unit, "kg"), [4, 5, 8]);
        assert_eq!(lines(Target::Parameter, "r"), [8, 9, 9, 9, 9]);
    }

    /// Rustc would have a second message of a use of nothing.
    #[test]
    fn what_is_not_known_is_no_use() {
        let wrong = DISC.replace("m: kg", "m: kilos").replace("to D", "to X").replace("psi: rad", "type: rad");
        let references = references(&wrong);
        for (target, name) in &references.uses {
            let is_named = references.named.iter().any(|named| named.target == *target && named.name == *name);
            assert!(*target == Target::Parameter || is_named, "{target:?} {name}");
        }
        let unknown = references.unknown.iter().map(|(target, name)| (*target, name.to_string()));
        let expected = [(Target::Coordinate, "psi"), (Target::Part, "X"), (Target::Unit, "kilos")];
        assert_eq!(unknown.collect::<Vec<_>>(), expected.map(|(target, name)| (target, name.to_string())));
    }
}
