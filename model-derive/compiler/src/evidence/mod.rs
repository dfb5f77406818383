//! What a declaration says of itself, against what its formulas give: the last stage that reports the user's mistakes.

mod asked;
mod claims;
mod counterexample;
mod definite;
mod divisors;
mod intervals;
mod physical;
mod published;
mod ranges;
mod requirements;
mod samples;
mod sets;
mod sourced;
mod states;
mod unused;
mod zero;

use self::claims::Claim;
use self::counterexample::Space;
use self::requirements::SourcedFormulas;
use self::sourced::{Source, Sourced};
use crate::check::{Checked, CheckedSet, Units};
use crate::derivation::{ByBodies, Derived};
use crate::equations::Equations;
use crate::formula::Formula;
use crate::matrix_name::MatrixName;
use crate::model::{self, Coordinate, Matrices, Model, Parameter, ParameterSet, Requirement};
use crate::report::{Region, Report};
use crate::syntax::{self, Declaration, Feedback, Matrix, Unit};
use crate::written::{write_attributes, write_formulas};

/// Holds a declaration against its formulas, and makes the model of both. Mistakes are reported; with none it is complete.
pub fn weigh(checked: Checked<'_>, mut derived: Derived, report: &mut Report) -> Model {
    let outputs: Vec<&Formula> = derived.outputs().collect();
    let used = unused::find_used(&checked, &derived.definitions, &outputs);
    // Without a mass matrix or a row formulas are missing, and what they would use is no mistake.
    let has_all = derived.matrices.iter().any(|(name, _)| *name == MatrixName::M)
        && derived.matrices.iter().all(|(_, rows)| !rows.is_empty() && rows.iter().all(|row| !row.is_empty()));
    if checked.is_complete && has_all {
        unused::report_unused(&checked, &derived.definitions, &outputs, report);
    }
    if has_all {
        asked::check_asked(&checked, &derived, report);
    }
    let (formulas, attributes, requirements) = match report.is_empty() {
        true => {
            derived = states::settle_states(&checked, derived, report);
            let units = checked.units.with_derived(&derived.definitions);
            let attributes = derived.attributes.as_ref();
            let attributes = attributes.map(|attributes| write_attributes(&checked, attributes, &derived.states));
            let formulas = write_formulas(&checked, &derived, &units);
            (formulas, attributes.unwrap_or_default(), prove(&checked, &derived, &units, report))
        }
        false => (Vec::new(), Vec::new(), checked.requirements),
    };
    let declaration = checked.declaration;
    let parameters = declaration
        .parameters
        .iter()
        .zip(checked.rust_attributes.parameters)
        .zip(checked.domains)
        .zip(used)
        .enumerate();
    let parameters = parameters.map(|(index, (((parameter, rust_attributes), domain), used))| Parameter {
        symbol: parameter.symbol.clone().unwrap_or_else(|| parameter.name.to_string()),
        name: parameter.name.clone(),
        rust_attributes,
        docs: parameter.docs.clone(),
        unit: unit_text(parameter.unit.as_ref()),
        domain,
        used: used || checked.gravity == Some(index),
    });
    let coordinates =
        declaration.coordinates.iter().zip(derived.states.clone()).map(|(coordinate, states)| Coordinate {
            states,
            label: coordinate.label.clone().unwrap_or_else(|| coordinate.name.to_string()),
            name: coordinate.name.to_string(),
            docs: coordinate.docs.clone(),
            unit: unit_text(coordinate.unit.as_ref()),
        });
    let (more, by_bodies) = match derived.by_bodies {
        Some(ByBodies { definitions, matrices }) => (definitions, Some(with_zeros(matrices, &derived.matrices))),
        None => (Vec::new(), None),
    };
    Model {
        name: declaration.name.clone(),
        visibility: declaration.visibility.clone(),
        rust_attributes: checked.rust_attributes.model,
        docs: declaration.docs.clone(),
        source: declaration.source.clone().unwrap_or_default(),
        parameters: parameters.collect(),
        gravity: checked.gravity,
        definitions: derived.names.definitions.into_iter().zip(derived.definitions).chain(more).collect(),
        requirements,
        sets: checked.sets.into_iter().map(|set| set.set).collect(),
        coordinates: coordinates.collect(),
        by_bodies,
        matrices: derived.matrices,
        entries: derived.entries,
        symmetric: derived.symmetric,
        formulas,
        attributes,
        feedback: declaration.feedback.iter().map(|feedback| tell(declaration, feedback)).collect(),
        kinematics: derived.kinematics,
        motion: derived.motion,
        compared: declaration.compared.clone(),
        derivatives: checked.derivatives,
        references: checked.references,
    }
}

/// With zeros where those of equal matrices were proved to be zero.
fn with_zeros(mut matrices: Matrices, equal: &Matrices) -> Matrices {
    let known = equal.iter().flat_map(|(_, rows)| rows.iter().flatten());
    let entries = matrices.iter_mut().flat_map(|(_, rows)| rows.iter_mut().flatten());
    entries
        .zip(known)
        .filter(|(_, known)| **known == Formula::zero())
        .for_each(|(entry, known)| *entry = known.clone());
    matrices
}

/// What is told of a feedback.
fn tell(declaration: &Declaration, Feedback { name, label, on, law }: &Feedback) -> model::Feedback {
    let unit_of = |coordinate: &syntax::Coordinate| coordinate.unit.as_ref().map(|unit| unit.text.clone());
    let coordinate = declaration.coordinates.iter().find(|coordinate| coordinate.name == *on);
    let unit = match coordinate.and_then(unit_of).as_deref() {
        Some("m") => Some("N"),
        Some("rad") => Some("N*m"),
        Some(_) => None,
        None => declaration.mechanism.as_ref().map(|mechanism| mechanism.force_unit(on)),
    };
    let name = name.to_string();
    model::Feedback {
        label: label.clone().unwrap_or_else(|| name.clone()),
        name,
        on: on.to_string(),
        unit,
        law: law.to_string(),
    }
}

/// The unit as it was written; with one that could not be read nothing is compiled.
fn unit_text(unit: Option<&Unit>) -> String {
    unit.map_or("1".into(), |unit| unit.text.clone())
}

/// Puts the requirements that the formulas have of themselves before the declared ones, and reports what is not as it is
/// said to be.
fn prove(checked: &Checked<'_>, derived: &Derived, units: &Units, report: &mut Report) -> Vec<Requirement> {
    let declaration = checked.declaration;
    // Whatever is needed for a requirement to have a value comes before it.
    let formulas = gather(checked, derived);
    let mut requirements = requirements::find_requirements(checked, derived, &formulas, report);
    requirements.iter_mut().for_each(|requirement| requirement.unit = units.of(&requirement.value));
    requirements.extend(checked.requirements.iter().cloned());
    let formulas_have_values = report.is_empty();
    let sets: Vec<&ParameterSet> = checked.sets.iter().map(|CheckedSet { set, .. }| set).collect();
    sets::check_sets(&sets, &derived.definitions, &requirements, report);
    let sets_have_values = report.is_empty();
    let space = Space { domains: &checked.domains, requirements: &requirements, sets: &sets };
    if formulas_have_values {
        claims::check_claims(&claim(checked, derived), derived, &space, report);
    }
    if sets_have_values {
        for (set, CheckedSet { exact, .. }) in declaration.sets.iter().zip(&checked.sets) {
            published::check_set(set, exact, checked, derived, report);
        }
    }
    requirements
}

/// The formulas of a model, each with where it comes from.
fn gather<'a>(checked: &'a Checked<'_>, derived: &'a Derived) -> SourcedFormulas<'a> {
    let declaration = checked.declaration;
    let sourced = |formula: &'a Formula, source: Source<'a>| Sourced { formula, source };
    let mechanism = declaration.mechanism.as_ref();
    // Definitions behind those of the declaration are there only if it has a mechanism.
    let place = Source::Derived(mechanism.map_or(Region::from(&declaration.name), |mechanism| mechanism.span.into()));
    let written = checked.order.iter().map(|declared| Source::Written(&declaration.definitions[*declared].value));
    let definitions = derived.definitions.iter().zip(written.chain(std::iter::repeat(place)));
    let entries = match mechanism {
        Some(_) => derived.outputs().map(|formula| sourced(formula, place)).collect(),
        None => {
            let places = derived.matrices.iter().flat_map(|(name, rows)| {
                let n = rows.len();
                (0..n).flat_map(move |row| (0..n).map(move |column| (*name, row, column)))
            });
            // What is a part of an entry, or has feedback in it, does not read as that does.
            let written = |place: (MatrixName, usize, usize)| {
                let matrix = declaration.matrices.iter().find(|matrix| matrix.name == place.0)?;
                matrix.rows.get(place.1)?.1.get(place.2).filter(|_| !derived.fed.contains(&place))
            };
            let sources = places.zip(&derived.entries);
            let sources =
                sources.map(|(place, region)| written(place).map_or(Source::Derived(*region), Source::Written));
            derived.outputs().zip(sources).map(|(formula, source)| sourced(formula, source)).collect()
        }
    };
    let attributes = checked.attributes.iter().zip(declaration.attributes());
    let requirements = checked.requirements.iter().zip(&declaration.requirements);
    let sides = declaration.assertions.iter().flat_map(|assertion| [&assertion.left, &assertion.right]);
    let sides = checked.assertions.iter().flatten().zip(sides);
    let asserted = declaration.asserted.iter().flat_map(Matrix::entries);
    let asserted = checked.asserted.iter().flatten().flatten().zip(asserted);
    SourcedFormulas {
        definitions: definitions.map(|(formula, source)| sourced(formula, source)).collect(),
        attributes: attributes.map(|(formula, written)| sourced(formula, Source::Written(written))).collect(),
        entries,
        requirements: requirements.map(|(r, written)| sourced(&r.value, Source::Written(&written.value))).collect(),
        claims: sides.chain(asserted).map(|(formula, side)| sourced(formula, Source::Written(side))).collect(),
    }
}

/// The claims of symmetric matrices, and of what is added to those of a mechanism.
fn claim_symmetry(checked: &Checked<'_>, Derived { matrices, entries, symmetric, .. }: &Derived) -> Vec<Claim> {
    let mut claims = Vec::new();
    let mut entries = entries.iter().copied();
    for (name, rows) in matrices {
        let regions: Vec<Region> = entries.by_ref().take(rows.len().pow(2)).collect();
        if symmetric.contains(name) {
            claims.extend(claims::of_symmetry(*name, rows, &regions));
        }
    }
    let added = checked.assembly.iter().flat_map(|assembly| &assembly.mechanism.added);
    for (written, (name, rows)) in checked.declaration.added.iter().zip(added).filter(|(written, _)| written.symmetric)
    {
        let regions: Vec<Region> = written.entries().map(|entry| entry.region).collect();
        claims.extend(claims::of_symmetry(*name, rows, &regions));
    }
    claims
}

/// A derived formula as text, with what the names stand for that the derivation made.
fn describe_derived(formula: &Formula, checked: &Checked<'_>, derived: &Derived) -> String {
    let Derived { definitions, names, .. } = derived;
    let needed = Equations::of_formulas(names.parameters.len(), definitions, vec![formula.clone()]).origins;
    let made = needed.into_iter().filter(|index| *index >= checked.definitions.len()).rev();
    let made =
        made.map(|index| format!(", {} = {}", names.definitions[index], names.text_in_order(&definitions[index])));
    format!("{}{}", names.text_in_order(formula), made.collect::<String>())
}

/// What the declaration claims: matrices that are symmetric, and assertions.
fn claim(checked: &Checked<'_>, derived: &Derived) -> Vec<Claim> {
    let declaration = checked.declaration;
    let mut claims = claim_symmetry(checked, derived);
    claims.extend(declaration.assertions.iter().zip(&checked.assertions).map(|(written, [left, right])| {
        let sides = [(left.clone(), written.left.region), (right.clone(), written.right.region)];
        Claim::asserted([&written.left, &written.right].map(ToString::to_string), sides)
    }));
    for (matrix, rows) in declaration.asserted.iter().zip(&checked.asserted) {
        let known = derived.matrices.iter().find(|(name, _)| *name == matrix.name).map(|(_, rows)| rows);
        for (row, entries) in rows.iter().enumerate() {
            for (column, entry) in entries.iter().enumerate() {
                let written = &matrix.rows[row].1[column];
                // A matrix that the model does not have is zero.
                let own = known.map_or_else(Formula::zero, |rows| rows[row][column].clone());
                let place = format!("{}, row {}, column {}", matrix.name.name(), row + 1, column + 1);
                let name = format!("{place}, = {}", describe_derived(&own, checked, derived));
                let sides = [(own, written.region), (entry.clone(), written.region)];
                claims.push(Claim::asserted([name, written.to_string()], sides));
            }
        }
    }
    claims
}
