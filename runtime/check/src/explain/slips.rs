//! Two slips in the formulas that together make the matrices.
//!
//! Ten thousand slips have fifty million pairs. Only those are evaluated that may be it by the numbers in which each of them is
//! seen: what is wrong beside one slip the other one must change, and the other way round.

use std::collections::BTreeMap;

use carvallo_slips::{FormulaSlip, Values};

use super::linear::{Linear, Term, terms};
use super::set::Set;
use super::{Cause, DoubleSlip, Found, double};
use crate::behind;
use crate::machine::Machine;
use crate::predict::Predictor;

/// So many pairs are evaluated at most, and so many that fit are kept, the likeliest.
const EVALUATED: usize = 2_000_000;
const KEPT: usize = 100;

/// An entry that is the same but for rounding, relative to it.
const SAME: f64 = 1e-12;

/// All pairs of slips in two formulas, or in that of one entry, with which everything fits: of those that make sense by their
/// units where there are any, else of all. None where nothing is given that does not agree and is linear in the entries of
/// matrices: these themselves, C and K at a speed, or what stands behind a state matrix with the mass matrix as it is.
pub fn find<'a>(machine: &'a Machine, predictor: &Predictor) -> Vec<Found<'a>> {
    let given = behind::state_matrices(machine, predictor).unwrap_or_default();
    let behind = Predictor::new(&given, machine);
    let search = [predictor, &behind].into_iter().find_map(|linear| Search::new(machine, linear, predictor));
    let Some(search) = search else { return Vec::new() };
    let mut found = Vec::new();
    for has_sense in [true, false] {
        found = search.pairs(has_sense);
        found.extend(search.doubles(has_sense));
        if !found.is_empty() {
            break;
        }
    }
    found.sort_by_key(|own| own.causes.iter().map(Cause::rank_of_slips).sum::<u32>());
    found.truncate(KEPT);
    found
}

/// Slips in the same formulas that are seen in the same numbers.
struct Class<'a> {
    formulas: &'a [usize],
    /// The numbers that they change, and those that are wrong with one of them alone.
    changed: Set,
    wrong: Set,
    slips: Vec<&'a FormulaSlip>,
}

struct Search<'a, 'b> {
    machine: &'a Machine,
    /// Of the linear numbers, and of all that must fit.
    predictor: &'b Predictor<'b>,
    whole: &'b Predictor<'b>,
    numbers: Vec<Linear>,
    /// What the feedback adds to each entry: it is in what is given, and not in the formulas.
    closing: Vec<f64>,
    /// The numbers that are wrong.
    wrong: Set,
    classes: Vec<Class<'a>>,
}

impl<'a, 'b> Search<'a, 'b> {
    fn new(machine: &'a Machine, predictor: &'b Predictor<'b>, whole: &'b Predictor<'b>) -> Option<Self> {
        let here = machine.world();
        let closed = predictor.closed_entries(&here);
        let closing = closed.iter().zip(&here.entries).map(|(closed, open)| closed - open).collect();
        let all = predictor.numbers().iter().enumerate();
        let numbers = all.filter_map(|(number, (quantity, _))| {
            let terms = terms(machine, predictor, *quantity, here.gravity);
            (!terms.is_empty()).then_some(Linear { number, terms })
        });
        let (numbers, wrong, classes) = (numbers.collect(), Set::default(), Vec::new());
        let mut own = Self { machine, predictor, whole, numbers, closing, wrong, classes };
        own.wrong = own.wrong(&machine.values.entries);
        if own.wrong == Set::default() {
            return None;
        }
        let mut classes: BTreeMap<(&[usize], Set, Set), Vec<&FormulaSlip>> = BTreeMap::new();
        machine.singles(&mut |cause, world| {
            if let Cause::Slip(slip) = cause {
                let key = (&slip.formulas[..], own.changed(&world.entries), own.wrong(&world.entries));
                classes.entry(key).or_default().push(slip);
            }
        });
        let class = |((formulas, changed, wrong), slips)| Class { formulas, changed, wrong, slips };
        own.classes = classes.into_iter().map(class).collect();
        Some(own)
    }

    fn set(&self, is_in: impl Fn(&Linear) -> bool) -> Set {
        let mut set = Set::default();
        let all = self.numbers.iter().enumerate();
        all.filter(|(_, number)| is_in(number)).for_each(|(at, _)| set.insert(at));
        set
    }

    /// What a number is with these entries of the open loop.
    fn value(&self, number: &Linear, entries: &[f64]) -> f64 {
        number.terms.iter().map(|own| own.factor * (entries[own.place] + self.closing[own.place])).sum()
    }

    fn wrong(&self, entries: &[f64]) -> Set {
        self.set(|number| !self.predictor.agrees(number.number, self.value(number, entries)))
    }

    fn changed(&self, entries: &[f64]) -> Set {
        let here = &self.machine.values.entries;
        let differs = |&Term { place, .. }: &Term| {
            let difference = (entries[place] - here[place]).abs();
            difference.is_nan() || difference > SAME * here[place].abs()
        };
        self.set(|number| number.terms.iter().any(differs))
    }

    /// Slips in two formulas, the first of which does not depend on the second.
    fn pairs(&self, has_sense: bool) -> Vec<Found<'a>> {
        let mut found = Vec::new();
        let mut left = EVALUATED;
        for second in &self.classes {
            let is_of_mechanism = |class: &Class| self.machine.formulas.formulas[class.formulas[0]].is_of_mechanism;
            let firsts = self.classes.iter().filter(|first| {
                first.formulas[0] < second.formulas[0]
                    && is_of_mechanism(first) == is_of_mechanism(second)
                    && first.formulas.iter().all(|formula| !second.formulas.contains(formula))
                    && second.wrong.is_within(&first.changed)
                    && first.wrong.is_within(&second.changed)
            });
            for first in firsts {
                self.of_classes(first, second, has_sense, &mut left, &mut found);
            }
        }
        found
    }

    fn of_classes(
        &self,
        first: &Class<'a>,
        second: &Class<'a>,
        has_sense: bool,
        left: &mut usize,
        found: &mut Vec<Found<'a>>,
    ) {
        let Machine { formulas, parameters, values: base, .. } = self.machine;
        let all = formulas.affected(first.formulas.iter().chain(second.formulas).copied());
        // One number first, that is made of the fewest formulas, of those that both change, or else of those that are wrong.
        let made_of = |number: &Linear| -> Vec<usize> {
            let feeds =
                |own: &usize| number.terms.iter().any(|term| term.formula.is_some_and(|at| formulas.feeds(*own, at)));
            all.iter().copied().filter(feeds).collect()
        };
        let is_in = |at: &usize, both: bool| {
            let [a, b] = [&first.changed, &second.changed].map(|own| own.contains(*at));
            if both { a && b } else { a || b }
        };
        let pivot = |both: bool| {
            let numbers = (0..self.numbers.len()).filter(move |at| is_in(at, both));
            numbers.map(|at| (at, made_of(&self.numbers[at]))).min_by_key(|(_, made_of)| made_of.len())
        };
        let Some((pivot, made_of)) = pivot(true).or_else(|| pivot(false)) else { return };
        let pivot = &self.numbers[pivot];
        let is_meant = |slip: &&&FormulaSlip| slip.makes_sense || !has_sense;
        let mut values: Values = base.clone();
        for b in second.slips.iter().filter(is_meant) {
            for a in first.slips.iter().filter(is_meant) {
                let uses = |slip: &FormulaSlip, other: &FormulaSlip| {
                    other.formulas.iter().any(|formula| formulas.uses(&slip.changed, *formula))
                };
                if *left == 0 {
                    return;
                }
                *left -= 1;
                let both = [(&a.formulas[..], &a.changed), (&b.formulas[..], &b.changed)];
                values.clone_from(base);
                formulas.change_both(both, &made_of, parameters, &mut values);
                let value = self.value(pivot, &values.entries);
                if !self.predictor.agrees(pivot.number, value) || (uses(a, b) && uses(b, a)) {
                    continue;
                }
                values.clone_from(base);
                formulas.change_both(both, &all, parameters, &mut values);
                let world = self.machine.world_from(values.entries.clone(), parameters);
                if self.whole.fits(&world) {
                    found.push(Found { causes: vec![Cause::Slip(a), Cause::Slip(b)], world });
                }
            }
        }
    }

    /// Two slips in the formula of one entry, or of several that have the same.
    fn doubles(&self, has_sense: bool) -> Vec<Found<'a>> {
        let formulas = &self.machine.formulas;
        let has = |number: &Linear, own: &[usize]| number.terms.iter().any(|term| term.is_of(own));
        // Those whose change makes all wrong numbers other ones, and no right ones.
        let explains = |own: &[usize]| !own.is_empty() && self.set(|number| has(number, own)) == self.wrong;
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for shared in formulas.formulas.iter().map(|formula| &formula.shared) {
            let is_wrong = |at: &usize| self.set(|number| has(number, &[*at])).is_within(&self.wrong);
            let is_given = |at: &usize| self.numbers.iter().any(|number| has(number, &[*at]));
            // Also where the others of them are not given.
            let wrong: Vec<usize> = shared.iter().copied().filter(|at| is_wrong(at) && is_given(at)).collect();
            let is_shared = shared.iter().all(|at| wrong.contains(at) || !is_given(at));
            let meant = if is_shared { shared.clone() } else { wrong };
            if explains(&meant) && !groups.contains(&meant) {
                groups.push(meant);
            }
        }
        let mut found = Vec::new();
        for meant in groups {
            let Some(number) = self.numbers.iter().find(|number| has(number, &meant)) else { continue };
            let own = || number.terms.iter().filter(|term| term.is_of(&meant));
            let factor: f64 = own().map(|term| term.factor).sum();
            let here = self.value(number, &self.machine.values.entries);
            let now: f64 = own().map(|term| term.factor * self.machine.values.entries[term.place]).sum();
            let wanted = self.predictor.numbers()[number.number].1.value - (here - now);
            let tolerance = self.predictor.tolerances()[number.number];
            let value = (wanted / factor, (tolerance / factor).abs());
            found.extend(double::find(self.machine, self.whole, &meant, value));
        }
        found.into_iter().filter(|own| !has_sense || double_has_sense(self.machine, own)).collect()
    }
}

/// Whether two slips in one formula leave one that makes sense by its units.
fn double_has_sense(machine: &Machine, found: &Found) -> bool {
    let has_sense = |double: &DoubleSlip| {
        let text = double.apply(machine.formulas.formulas[double.formulas[0]].text);
        let changed = machine.formulas.parse(double.formulas[0], &text);
        changed.is_some_and(|changed| machine.formulas.makes_sense(double.formulas[0], &changed))
    };
    found.causes.iter().all(|cause| match cause {
        Cause::Slips(double) => has_sense(double),
        _ => true,
    })
}
