//! The matrices by the attributes of a mechanism, each under a name of its own: what they are if one of them is another.

mod names;

use proc_macro2::Ident;

use self::names::{NamedAttribute, name_attributes};
use super::{renumber, taken_names};
use crate::check::{Assembly, Checked, assemble};
use crate::equations::Equations;
use crate::formula::Formula;
use crate::free_name::take_free_name;
use crate::mechanics::{self, Apart, Declared};
use crate::model::Matrices;
use crate::report::Report;
use crate::symbolic::Failure;
use crate::syntax::Mechanism;

/// Matrices in definitions of which some are attributes of the mechanism.
#[derive(Debug)]
pub struct Attributes {
    /// The definitions of the declaration, behind them the attributes, and behind these what is derived from them: those that
    /// the matrices depend on.
    pub definitions: Vec<Formula>,
    /// What the definitions are called.
    pub names: Vec<Ident>,
    /// What the attributes are, in words, in the order of their definitions.
    pub whats: Vec<String>,
    /// In the order of the equation of motion.
    pub matrices: Matrices,
}

/// A mechanism in which parameters stand for its attributes, in their order behind all others.
pub struct Standing {
    pub mechanism: mechanics::Mechanism<Formula>,
    /// How many parameters there are in all.
    pub parameters: usize,
}

/// Derives the matrices by attributes, and tells the mechanism that they are of. What feeds back on `mechanism` stays as it is, and so do attributes that have the load of a
/// wheel in them, and numbers.
///
/// # Errors
/// If the engine fails.
pub fn derive_by_attributes(
    checked: &Checked<'_>,
    declared: &Mechanism,
    assembly: &Assembly,
    mechanism: &mechanics::Mechanism<Formula>,
) -> Result<(Attributes, Standing), Failure> {
    let declaration = checked.declaration;
    let first_load = declaration.parameters.len();
    let parameters = first_load + mechanism.loads.map_or(0, |_| declared.wheels.len());
    let named = name_attributes(declaration, declared);
    // For each formula of the declaration which attribute it is, if it is one.
    let mut chosen: Vec<usize> = Vec::new();
    let mut standing = assembly.attributes.clone();
    for (index, formula) in assembly.attributes.iter().enumerate() {
        let stand_in = |chosen: usize| Formula::Parameter(parameters + chosen);
        if let Some(same) = named[index].same.and_then(|same| chosen.iter().position(|known| *known == same)) {
            standing[index] = stand_in(same);
        } else if is_attribute(formula, first_load) {
            standing[index] = stand_in(chosen.len());
            chosen.push(index);
        }
    }
    let tree = Some(assembly.tree.clone());
    let assembled = assemble(declaration, declared, tree, &standing, mechanism.loads, &mut Report::default());
    let assembled = assembled.map_or_else(|| mechanism.clone(), |assembly| assembly.mechanism);
    let assembled = mechanics::Mechanism { fed: mechanism.fed.clone(), ..assembled };
    let attributes: Vec<Formula> = chosen.iter().map(|index| assembly.attributes[*index].clone()).collect();
    let standing = Standing { mechanism: assembled.clone(), parameters: parameters + chosen.len() };
    let apart = mechanics::derive_apart(
        assembled,
        Declared {
            parameters: standing.parameters,
            definitions: checked.definitions.clone(),
            attributes: attributes.clone(),
        },
    )?;
    let derived = Derivation { apart, parameters, attributes };
    Ok((derived.adopt(checked, declared, chosen.iter().map(|index| &named[*index])), standing))
}

/// What was derived, with the attributes as parameters behind all others.
struct Derivation {
    apart: Apart,
    parameters: usize,
    attributes: Vec<Formula>,
}

impl Derivation {
    /// With the attributes as definitions, and of all definitions those that the matrices depend on; of the attributes all where the
    /// nonlinear equations depend on others.
    fn adopt<'a>(
        self,
        checked: &Checked<'_>,
        declared: &Mechanism,
        named: impl Iterator<Item = &'a NamedAttribute>,
    ) -> Attributes {
        let Self { apart, parameters, attributes } = self;
        let (first, count) = (checked.definitions.len(), attributes.len());
        let with_definitions = |formula: &Formula| {
            formula.with_leaves(&|leaf| match leaf {
                Formula::Parameter(index) if *index >= parameters => Formula::Definition(first + index - parameters),
                Formula::Definition(index) if *index >= first => Formula::Definition(count + index),
                other => other.clone(),
            })
        };
        let mut taken = taken_names(checked);
        let mut name = |name: &str| Ident::new(&take_free_name(name, &mut taken), declared.span);
        let mut names: Vec<Ident> = (0..first).map(|index| checked.definition(index).clone()).collect();
        let whats = named.map(|own| {
            names.push(name(&own.name));
            own.what.clone()
        });
        let whats: Vec<String> = whats.collect();
        names.extend(apart.definitions.iter().map(|(own, _)| name(own)));
        let derived = apart.definitions.iter().map(|(_, formula)| with_definitions(formula));
        let definitions: Vec<Formula> = checked.definitions.iter().cloned().chain(attributes).chain(derived).collect();
        let matrices = apart.matrices.iter().map(|(name, rows)| {
            let rows = rows.iter().map(|row| row.iter().map(with_definitions).collect());
            (*name, rows.collect::<Vec<Vec<Formula>>>())
        });
        let matrices: Matrices = matrices.collect();
        let entries = matrices.iter().flat_map(|(_, rows)| rows.iter().flatten()).cloned().collect();
        let needed = Equations::of_formulas(parameters, &definitions, entries).origins;
        // Those of the declaration stay, which units are known of.
        let all = first + if checked.declaration.nonlinear.is_some() { count } else { 0 };
        let kept: Vec<usize> = (0..all).chain(needed.into_iter().filter(|index| *index >= all)).collect();
        let mut new = vec![0; definitions.len()];
        kept.iter().enumerate().for_each(|(position, index)| new[*index] = position);
        Attributes {
            definitions: kept.iter().map(|index| definitions[*index].renumbered(&new)).collect(),
            names: kept.iter().map(|index| names[*index].clone()).collect(),
            whats: kept.iter().filter_map(|index| whats.get(index.checked_sub(first)?).cloned()).collect(),
            matrices: renumber(&matrices, &new),
        }
    }
}

/// Whether a formula is one with a parameter in it, and without the load of a wheel, which is derived itself.
fn is_attribute(formula: &Formula, first_load: usize) -> bool {
    let (mut has_name, mut has_load) = (false, false);
    formula.walk(&mut |part| match part {
        Formula::Parameter(index) if *index >= first_load => has_load = true,
        Formula::Parameter(_) | Formula::Definition(_) => has_name = true,
        _ => {}
    });
    has_name && !has_load
}
