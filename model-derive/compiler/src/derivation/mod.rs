//! The equations of motion of a checked declaration: what its mechanism has, or the matrices that are written.

mod attributes;
mod by_speed;
mod faults;
mod feedback;
mod motion;
mod rates;

use std::collections::HashSet;

use proc_macro2::Ident;

pub use self::attributes::Attributes;
use self::faults::Faulty;
use crate::check::{Assembly, Checked};
use crate::equations::Equations;
use crate::formula::{Formula, Names};
use crate::free_name::take_free_name;
use crate::kinematics::Kinematics;
use crate::matrix_name::MatrixName;
use crate::mechanics::{self, Declared, Derivation};
use crate::model::Matrices;
use crate::motion::MotionModel;
use crate::report::{Region, Report};
use crate::states::States;
use crate::symbolic::{Failure, Place};
use crate::syntax::Mechanism;

/// Matrices, and what else follows from a mechanism, in formulas of the parameters.
#[derive(Debug)]
pub struct Derived {
    /// The definitions of the declaration in their order, then those of the derivation: each uses only earlier ones.
    pub definitions: Vec<Formula>,
    /// What parameters and definitions are called.
    pub names: Names,
    /// In the order of the equation of motion; none if the derivation failed.
    pub matrices: Matrices,
    /// The same matrices summed over bodies, if they are derived so as well.
    pub by_bodies: Option<ByBodies>,
    /// Where the entries of the matrices stand, row by row: those that are derived stand at the mechanism.
    pub entries: Vec<Region>,
    /// Entries of written matrices, by rows and columns, that are not as they are written: feedback is a part of them.
    pub fed: Vec<(MatrixName, usize, usize)>,
    /// The matrices that are said to be symmetric, or are derived so.
    pub symmetric: Vec<MatrixName>,
    /// For each coordinate which of its position and its rate are states.
    pub states: Vec<States>,
    /// Rates and forces, of a mechanism.
    pub kinematics: Option<Kinematics<Formula>>,
    /// What is free of its motion, if the nonlinear equations are asked for.
    pub motion: Option<MotionModel>,
    /// The matrices by the attributes of the mechanism, of one.
    pub attributes: Option<Attributes>,
}

/// Matrices in the definitions of the model, and in more of their own behind them.
#[derive(Debug)]
pub struct ByBodies {
    pub definitions: Vec<(Ident, Formula)>,
    pub matrices: Matrices,
}

impl Derived {
    /// The formulas that the model computes: the entries of the matrices, row by row, then rates and forces.
    pub fn outputs(&self) -> impl Iterator<Item = &Formula> {
        let entries = self.matrices.iter().flat_map(|(_, rows)| rows.iter().flatten());
        entries.chain(self.kinematics.iter().flat_map(|kinematics| kinematics.formulas()))
    }
}

/// Derives the equations of motion. Faults of the mechanism are reported, and then there are no matrices.
pub fn derive(checked: &Checked<'_>, report: &mut Report) -> Derived {
    let declaration = checked.declaration;
    let names = Names {
        parameters: declaration.parameters.iter().map(|parameter| parameter.name.clone()).collect(),
        definitions: (0..checked.definitions.len()).map(|index| checked.definition(index).clone()).collect(),
    };
    let symmetric = declaration.matrices.iter().filter(|matrix| matrix.symmetric).map(|matrix| matrix.name).collect();
    let written = Derived {
        definitions: checked.definitions.clone(),
        names,
        matrices: checked.written.matrices.clone(),
        by_bodies: None,
        entries: checked.written.regions.clone(),
        fed: Vec::new(),
        symmetric,
        states: declaration.states().map(Option::unwrap_or_default).collect(),
        kinematics: None,
        motion: None,
        attributes: None,
    };
    let fed = if report.is_empty() { feedback::sort_feedback(checked, report) } else { Vec::new() };
    let Some(mechanism) = &declaration.mechanism else {
        let sorted = by_speed::sort_wholes(checked, written, report);
        return if report.is_empty() { feedback::add_feedback(checked, fed, sorted) } else { sorted };
    };
    // Declared matrices beside a mechanism are a mistake.
    let nothing = Derived {
        matrices: Vec::new(),
        entries: Vec::new(),
        symmetric: Vec::new(),
        kinematics: Some(rates::outline_rates(declaration, mechanism)),
        ..written
    };
    let Some(assembly) = checked.assembly.as_ref().filter(|_| report.is_empty()) else { return nothing };
    let declared = Declared {
        parameters: declaration.parameters.len() + assembly.mechanism.loads.map_or(0, |_| mechanism.wheels.len()),
        definitions: checked.definitions.clone(),
        attributes: checked.attributes.clone(),
    };
    let joint = |name: &Ident| assembly.tree.find_joint(mechanism, name);
    let fed = fed.into_iter().filter_map(|fed| {
        Some(mechanics::Fed { on: joint(fed.on)?, of: joint(fed.of)?, matrix: fed.matrix, formula: fed.formula })
    });
    let assembled = mechanics::Mechanism { fed: fed.collect(), ..assembly.mechanism.clone() };
    match mechanics::derive(assembled.clone(), declared) {
        Err(failure) => report.error(find_region(checked, mechanism, &failure), failure),
        Ok(Err(faults)) => {
            let (tree, names) = (&assembly.tree, &nothing.names);
            Faulty { declaration, mechanism, tree, names }.report(&faults, report);
        }
        Ok(Ok(derivation)) => {
            let motion = motion::describe_motion(&derivation, checked, assembly, report);
            let mut derived = Derived { motion, ..adopt(derivation, nothing, checked, mechanism, assembly) };
            report_numbers_out_of_range(&derived, mechanism, report);
            if report.is_empty() {
                match attributes::derive_by_attributes(checked, mechanism, assembly, &assembled) {
                    Ok((attributes, standing)) => {
                        derived.attributes = Some(attributes);
                        derived.motion = derived.motion.map(|motion| motion::with_attributes(motion, standing));
                    }
                    Err(failure) => report.error(mechanism.span, failure),
                }
            }
            return derived;
        }
    }
    nothing
}

/// Where in the declaration a failure of the engine belongs.
fn find_region(checked: &Checked<'_>, mechanism: &Mechanism, failure: &Failure) -> Region {
    match failure {
        Failure::Undefined { place: Place::Definition(index), .. } => checked.definition(*index).into(),
        Failure::Undefined { place: Place::Output(index), .. } => {
            checked.declaration.attributes().nth(*index).map_or(mechanism.span.into(), |formula| formula.region)
        }
        Failure::Engine(_) => mechanism.span.into(),
    }
}

/// What was derived, as a part of the model: with those of the derivation's definitions that a result depends on.
fn adopt(
    derivation: Derivation,
    declared: Derived,
    checked: &Checked<'_>,
    mechanism: &Mechanism,
    Assembly { tree, .. }: &Assembly,
) -> Derived {
    let first = declared.definitions.len();
    let kinematics = rates::name_rates(&derivation, mechanism, tree);
    let entries = derivation.matrices.iter().flat_map(|(_, rows)| rows.iter().flatten());
    let results = entries.chain(kinematics.formulas()).cloned().collect();
    let mut definitions = declared.definitions;
    let mut names = declared.names;
    names.definitions.extend(find_names(&derivation, checked, mechanism));
    definitions.extend(derivation.definitions.into_iter().map(|(_, value)| value));
    let needed = Equations::of_formulas(names.parameters.len(), &definitions, results).origins;
    let kept: Vec<usize> = (0..first).chain(needed.into_iter().filter(|index| *index >= first)).collect();
    let mut new = vec![0; definitions.len()];
    kept.iter().enumerate().for_each(|(position, index)| new[*index] = position);
    let by_bodies = derivation.by_bodies.as_ref().map(|matrices| {
        let entries = matrices.iter().flat_map(|(_, rows)| rows.iter().flatten()).cloned().collect();
        let mut more = Equations::of_formulas(names.parameters.len(), &definitions, entries).origins;
        more.retain(|index| !kept.contains(index));
        more.iter().enumerate().for_each(|(position, index)| new[*index] = kept.len() + position);
        let named = |index: &usize| (names.definitions[*index].clone(), definitions[*index].renumbered(&new));
        ByBodies { definitions: more.iter().map(named).collect(), matrices: renumber(matrices, &new) }
    });
    let matrices = renumber(&derivation.matrices, &new);
    let is_symmetric = |rows: &[Vec<Formula>]| {
        rows.len() > 1 && (0..rows.len()).all(|row| (0..row).all(|column| rows[row][column] == rows[column][row]))
    };
    Derived {
        definitions: kept.iter().map(|index| definitions[*index].renumbered(&new)).collect(),
        names: Names { definitions: kept.iter().map(|index| names.definitions[*index].clone()).collect(), ..names },
        fed: Vec::new(),
        entries: vec![mechanism.span.into(); matrices.iter().flat_map(|(_, rows)| rows.iter().flatten()).count()],
        symmetric: matrices.iter().filter(|(_, rows)| is_symmetric(rows)).map(|(name, _)| *name).collect(),
        states: complete_states(checked, &derivation.states),
        kinematics: Some(kinematics.map(|formula| formula.renumbered(&new))),
        motion: None,
        attributes: None,
        matrices,
        by_bodies,
    }
}

/// The same with other positions of the definitions.
fn renumber(matrices: &Matrices, new: &[usize]) -> Matrices {
    let rows_of = |rows: &[Vec<Formula>]| -> Vec<Vec<Formula>> {
        rows.iter().map(|row| row.iter().map(|entry| entry.renumbered(new)).collect()).collect()
    };
    matrices.iter().map(|(name, rows)| (*name, rows_of(rows))).collect()
}

/// What is said of the states of the coordinates, and of the others what was derived.
fn complete_states(checked: &Checked<'_>, derived: &[States]) -> Vec<States> {
    let declared = checked.declaration.states().zip(derived);
    declared.map(|(declared, derived)| declared.unwrap_or(*derived)).collect()
}

/// Reports the first number beyond the range of `f64`: numbers that are in it can have a product that is not.
fn report_numbers_out_of_range(derived: &Derived, mechanism: &Mechanism, report: &mut Report) {
    let mut found = None;
    let mut note = |formula: &Formula| {
        if let Formula::Number(number) = formula {
            let nearest = number.to_f64();
            if !nearest.is_finite() || nearest == 0.0 && !number.is_zero() {
                found.get_or_insert_with(|| number.to_string());
            }
        }
    };
    derived.definitions.iter().chain(derived.outputs()).for_each(|formula| formula.walk(&mut note));
    if let Some(number) = found {
        let message = format!(
            "the equations of motion have the factor {number}, beyond the range of f64: expected numbers whose products are \
             between 1e-300 and 1e300"
        );
        report.error(mechanism.span, message);
    }
}

/// Names for the definitions of the derivation that nothing else in the declaration has.
fn find_names(derivation: &Derivation, checked: &Checked<'_>, mechanism: &Mechanism) -> Vec<Ident> {
    let mut taken = taken_names(checked);
    let name = |(name, _): &(String, Formula)| Ident::new(&take_free_name(name, &mut taken), mechanism.span);
    derivation.definitions.iter().map(name).collect()
}

/// The names that a declaration has.
fn taken_names(checked: &Checked<'_>) -> HashSet<String> {
    let declaration = checked.declaration;
    let parameters = declaration.parameters.iter().map(|parameter| &parameter.name);
    let definitions = declaration.definitions.iter().map(|definition| &definition.name);
    let coordinates = declaration.coordinates.iter().map(|coordinate| &coordinate.name);
    parameters.chain(definitions).chain(coordinates).map(Ident::to_string).collect()
}
