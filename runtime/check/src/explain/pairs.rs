//! A convention with a slip, or with another convention.

use super::{Cause, Found};
use crate::conventions::{Convention, Effect};
use crate::given::Quantity;
use crate::machine::Machine;
use crate::predict::{Predictor, World};
use carvallo_slips::{FormulaSlip, Formulas};

/// All pairs of one of these conventions with another of them, or with a slip, or of an entry that is mistaken with a slip, with
/// which everything fits.
pub fn find<'a>(machine: &'a Machine, predictor: &Predictor, conventions: &[&'a Convention]) -> Vec<Found<'a>> {
    let mut found = of_conventions(machine, predictor, conventions);
    let (of_parameters, of_matrices): (Vec<&Convention>, Vec<&Convention>) =
        conventions.iter().partition(|own| matches!(own.effect, Effect::Parameters(_)));
    let of_entries = of_entries(machine, predictor);
    let mut own = World::default();
    machine.singles(&mut |cause, old| {
        let Cause::Slip(slip) = cause else { return };
        for &convention in of_matrices.iter().chain(&of_entries) {
            convention.change_matrices(old, &mut own, machine.formulas.count);
            if predictor.fits(&own) {
                let causes = vec![Cause::Convention(convention), Cause::Slip(slip)];
                found.push(Found { causes, world: own.clone() });
            }
        }
    });
    for convention in of_parameters {
        found.extend(of_parameters_and_slips(machine, predictor, convention));
    }
    found
}

/// The mistaken entries with which some that are given come out that do not as they are: there may be hundreds, and all others
/// mend nothing.
fn of_entries<'a>(machine: &'a Machine, predictor: &Predictor) -> Vec<&'a Convention> {
    let agreeing = |world: &World| -> usize {
        let numbers = predictor.numbers().iter().enumerate();
        let entries = numbers.filter_map(|(at, number)| Some((at, predictor.entry(number.0, world)?)));
        entries.filter(|(at, value)| predictor.agrees(*at, *value)).count()
    };
    let here = agreeing(&machine.world());
    let mends =
        |own: &&Convention| matches!(own.effect, Effect::Entries(_)) && agreeing(&machine.world_with(own)) > here;
    machine.single.iter().filter(mends).collect()
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
            if predictor.fits(&two) {
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
    let mut world = machine.world_from(base.entries.clone(), &parameters);
    let wrong = wrong_entries(formulas, predictor, &world);
    // A slip does not mend what does not depend on it.
    let may_mend = |slip: &FormulaSlip| {
        let feeds = |entry: usize| slip.formulas.iter().any(|&formula| formulas.feeds(formula, entry));
        wrong.iter().all(|&entry| feeds(entry))
    };
    let mut found = Vec::new();
    for slip in machine.slips().iter().filter(|slip| may_mend(slip)) {
        if slip.apply(formulas, &parameters, &base, &mut own) {
            std::mem::swap(&mut world.entries, &mut own.entries);
            if predictor.fits(&world) {
                let causes = vec![Cause::Convention(convention), Cause::Slip(slip)];
                found.push(Found { causes, world: world.clone() });
            }
            std::mem::swap(&mut world.entries, &mut own.entries);
        }
    }
    found
}

/// The formulas of the entries that were given otherwise.
fn wrong_entries(formulas: &Formulas, predictor: &Predictor, world: &World) -> Vec<usize> {
    let numbers = predictor.numbers().iter().enumerate();
    let wrong = numbers.filter_map(|(at, (quantity, _))| {
        let Quantity::Entry(matrix, row, column) = *quantity else { return None };
        let agrees = predictor.agrees(at, predictor.entry(*quantity, world)?);
        if agrees { None } else { formulas.entry(matrix, row, column) }
    });
    wrong.collect()
}
