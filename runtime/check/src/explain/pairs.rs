//! A convention with a slip, or with another convention; and two entries that are mistaken.

use super::acting::Acting;
use super::{Cause, Found};
use crate::conventions::{Convention, Effect};
use crate::machine::Machine;
use crate::predict::{Predictor, World};
use carvallo_slips::FormulaSlip;

/// All pairs of one of these conventions with another of them, or with a slip, or of an entry that is mistaken with a slip or
/// with another one, with which everything fits.
pub fn find<'a>(machine: &'a Machine, predictor: &Predictor, conventions: &[&'a Convention]) -> Vec<Found<'a>> {
    if predictor.has_few_digits() {
        return Vec::new();
    }
    predictor.begin();
    let mut found = of_conventions(machine, predictor, conventions);
    let (of_parameters, of_matrices): (Vec<&Convention>, Vec<&Convention>) =
        conventions.iter().partition(|own| matches!(own.effect, Effect::Parameters(_)));
    let acting = |convention: &'a Convention| Acting::new(machine, predictor, convention);
    let entries: Vec<Acting> = mending(machine, predictor).into_iter().map(acting).collect();
    let of_matrices: Vec<Acting> = of_matrices.into_iter().map(acting).collect();
    machine.singles(&mut |cause, old| {
        let Cause::Slip(slip) = cause else { return };
        for own in of_matrices.iter().chain(&entries) {
            if let Some(world) = own.fitting(old, predictor) {
                found.push(Found { causes: vec![Cause::Convention(own.convention), Cause::Slip(slip)], world });
            }
        }
    });
    found.extend(of_entries(machine, predictor, &entries));
    for convention in of_parameters {
        found.extend(of_parameters_and_slips(machine, predictor, convention));
    }
    found
}

/// The mistaken entries with which some relations come out that do not as they are: there may be hundreds, and all others mend
/// nothing.
fn mending<'a>(machine: &'a Machine, predictor: &Predictor) -> Vec<&'a Convention> {
    let holding = |world: &World| -> usize {
        let entries = predictor.closed_entries(world);
        predictor.relations().iter().filter(|own| own.holds(&entries, world.gravity)).count()
    };
    let here = holding(&machine.world());
    let mends =
        |own: &&Convention| matches!(own.effect, Effect::Entries(_)) && holding(&machine.world_with(own)) > here;
    machine.single.iter().filter(mends).collect()
}

/// Two entries that are lost, have the other sign, are twice or half.
fn of_entries<'a>(machine: &Machine, predictor: &Predictor, entries: &[Acting<'a>]) -> Vec<Found<'a>> {
    let likely: Vec<&Acting> = entries.iter().filter(|own| own.convention.rank <= 1).collect();
    let mut found = Vec::new();
    for (at, first) in likely.iter().enumerate() {
        let world = machine.world_with(first.convention);
        for second in likely[at + 1..].iter().filter(|own| own.is_beside(first)) {
            if let Some(world) = second.fitting(&world, predictor) {
                let causes = [first, second].map(|own| Cause::Convention(own.convention)).to_vec();
                found.push(Found { causes, world });
            }
        }
    }
    found
}

/// What acts on matrices acts on those of the parameters of the other one, and after them.
fn of_conventions<'a>(machine: &Machine, predictor: &Predictor, conventions: &[&'a Convention]) -> Vec<Found<'a>> {
    let count = machine.formulas.count;
    let mut found = Vec::new();
    for (at, &first) in conventions.iter().enumerate() {
        let mut parameters = machine.parameters.clone();
        first.change_parameters(&mut parameters);
        for &second in &conventions[at + 1..] {
            let mut both = parameters.clone();
            second.change_parameters(&mut both);
            let (mut one, mut two) = (World::default(), World::default());
            first.change_matrices(&machine.world_of(&both), &mut one, count);
            second.change_matrices(&one, &mut two, count);
            if predictor.fits_if_tried(&two) {
                found.push(Found { causes: vec![Cause::Convention(first), Cause::Convention(second)], world: two });
            }
        }
    }
    found
}

fn of_parameters_and_slips<'a>(
    machine: &'a Machine,
    predictor: &Predictor,
    convention: &'a Convention,
) -> Vec<Found<'a>> {
    let formulas = &machine.formulas;
    let mut parameters = machine.parameters.clone();
    convention.change_parameters(&mut parameters);
    let base = formulas.values(&parameters);
    let mut own = base.clone();
    let mut world = machine.world_from(base.clone(), &parameters);
    let wrong = wrong(machine, predictor, &world);
    let here = predictor.predict(&world);
    let is_of_mechanism = (0..here.len()).any(|at| predictor.is_nonlinear(at) && !predictor.agrees(at, here[at]));
    // A slip does not mend what does not depend on it.
    let feeds = |formula: usize| -> Vec<bool> {
        wrong.iter().map(|entries| entries.iter().any(|&entry| formulas.feeds(formula, entry))).collect()
    };
    let feeds: Vec<Vec<bool>> = (0..formulas.formulas.len()).map(feeds).collect();
    let may_mend = |slip: &FormulaSlip| {
        (formulas.formulas[slip.formulas[0]].is_of_mechanism || !is_of_mechanism)
            && (0..wrong.len()).all(|at| slip.formulas.iter().any(|&formula| feeds[formula][at]))
    };
    let mut found = Vec::new();
    for slip in machine.slips().iter().filter(|slip| may_mend(slip)) {
        if predictor.has_left() && slip.apply(formulas, &parameters, &base, &mut own) {
            world.attributes = machine.attributes(&own);
            std::mem::swap(&mut world.entries, &mut own.entries);
            if predictor.fits_if_tried(&world) {
                let causes = vec![Cause::Convention(convention), Cause::Slip(slip)];
                found.push(Found { causes, world: world.clone() });
            }
            std::mem::swap(&mut world.entries, &mut own.entries);
        }
    }
    found
}

/// Of each relation that is wrong the formulas of its entries.
fn wrong(machine: &Machine, predictor: &Predictor, world: &World) -> Vec<Vec<usize>> {
    let entries = predictor.closed_entries(world);
    let wrong = predictor.relations().iter().filter(|own| !own.holds(&entries, world.gravity));
    wrong.map(|own| own.terms.iter().filter_map(|term| machine.formula(term.place)).collect()).collect()
}
