//! Two slips in the formulas that together make the matrices.
//!
//! Ten thousand slips have fifty million pairs. Only those are evaluated that may be it by the entries in which each of them is
//! seen: what is wrong beside one slip the other one must change, and the other way round.

use std::collections::BTreeMap;

use carvallo_slips::{FormulaSlip, Values, index};

use super::{Cause, DoubleSlip, Found, double};
use crate::given::Quantity;
use crate::machine::Machine;
use crate::predict::Predictor;

/// So many pairs are evaluated at most, and so many that fit are kept, the likeliest.
const EVALUATED: usize = 2_000_000;
const KEPT: usize = 100;

/// An entry that is the same but for rounding, relative to it.
const SAME: f64 = 1e-12;

/// All pairs of slips in two formulas, or in that of one entry, with which everything fits: of those that make sense by their
/// units where there are any, else of all. None where no entry of a matrix is given that does not agree.
pub fn find<'a>(machine: &'a Machine, predictor: &Predictor) -> Vec<Found<'a>> {
    let Some(search) = Search::new(machine, predictor) else { return Vec::new() };
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

/// Some of the entries that are given.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
struct Set(Vec<u64>);

impl Set {
    fn insert(&mut self, at: usize) {
        self.0.resize(self.0.len().max(at / 64 + 1), 0);
        self.0[at / 64] |= 1 << (at % 64);
    }

    fn contains(&self, at: usize) -> bool {
        self.0.get(at / 64).is_some_and(|word| word >> (at % 64) & 1 == 1)
    }

    fn is_within(&self, other: &Self) -> bool {
        self.0.iter().enumerate().all(|(at, word)| word & !other.0.get(at).copied().unwrap_or(0) == 0)
    }
}

/// Slips in the same formulas that are seen in the same entries.
struct Class<'a> {
    formulas: &'a [usize],
    /// The entries that they change, and those that are wrong with one of them alone.
    changed: Set,
    wrong: Set,
    slips: Vec<&'a FormulaSlip>,
}

struct Search<'a, 'b> {
    machine: &'a Machine,
    predictor: &'b Predictor<'b>,
    /// The entries that are given: of which formula, at which place among all, and by which number.
    entries: Vec<(usize, usize, usize)>,
    /// Those that are wrong.
    wrong: Set,
    classes: Vec<Class<'a>>,
}

impl<'a, 'b> Search<'a, 'b> {
    fn new(machine: &'a Machine, predictor: &'b Predictor<'b>) -> Option<Self> {
        let count = machine.formulas.count;
        let numbers = predictor.numbers().iter().enumerate();
        let entries: Vec<(usize, usize, usize)> = numbers
            .filter_map(|(number, (quantity, _))| {
                let Quantity::Entry(matrix, row, column) = *quantity else { return None };
                Some((machine.formulas.entry(matrix, row, column)?, index(matrix, row, column, count), number))
            })
            .collect();
        let mut own = Self { machine, predictor, entries, wrong: Set::default(), classes: Vec::new() };
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

    fn set(&self, is_in: impl Fn(usize, usize) -> bool) -> Set {
        let mut set = Set::default();
        let all = self.entries.iter().enumerate();
        all.filter(|(_, (_, place, number))| is_in(*place, *number)).for_each(|(at, _)| set.insert(at));
        set
    }

    fn wrong(&self, entries: &[f64]) -> Set {
        // The feedback is in what is given, and not in the formulas.
        let here = &self.machine.world();
        let closed = |place: usize, number: usize| {
            let quantity = self.predictor.numbers()[number].0;
            self.predictor.entry(quantity, here).unwrap_or_default() - here.entries[place] + entries[place]
        };
        self.set(|place, number| !self.predictor.agrees(number, closed(place, number)))
    }

    fn changed(&self, entries: &[f64]) -> Set {
        let here = &self.machine.values.entries;
        let differs = |place: usize| {
            let difference = (entries[place] - here[place]).abs();
            difference.is_nan() || difference > SAME * here[place].abs()
        };
        self.set(|place, _| differs(place))
    }

    /// Slips in two formulas, the first of which does not depend on the second.
    fn pairs(&self, has_sense: bool) -> Vec<Found<'a>> {
        let mut found = Vec::new();
        let mut left = EVALUATED;
        for second in &self.classes {
            let firsts = self.classes.iter().filter(|first| {
                first.formulas[0] < second.formulas[0]
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
        // One entry first, that is made of the fewest formulas, of those that both change, or else of those that are wrong.
        let made_of =
            |entry: usize| -> Vec<usize> { all.iter().copied().filter(|&own| formulas.feeds(own, entry)).collect() };
        let is_in = |at: &usize, both: bool| {
            let [a, b] = [&first.changed, &second.changed].map(|own| own.contains(*at));
            if both { a && b } else { a || b }
        };
        let pivot = |both: bool| {
            let entries = (0..self.entries.len()).filter(move |at| is_in(at, both));
            entries.map(|at| (at, made_of(self.entries[at].0))).min_by_key(|(_, made_of)| made_of.len())
        };
        let Some((pivot, made_of)) = pivot(true).or_else(|| pivot(false)) else { return };
        let (_, place, number) = self.entries[pivot];
        let closed = {
            let here = self.machine.world();
            self.predictor.entry(self.predictor.numbers()[number].0, &here).unwrap_or_default() - here.entries[place]
        };
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
                if !self.predictor.agrees(number, values.entries[place] + closed) || (uses(a, b) && uses(b, a)) {
                    continue;
                }
                values.clone_from(base);
                formulas.change_both(both, &all, parameters, &mut values);
                let world = self.machine.world_from(values.entries.clone(), parameters);
                if self.predictor.fits(&world) {
                    found.push(Found { causes: vec![Cause::Slip(a), Cause::Slip(b)], world });
                }
            }
        }
    }

    /// Two slips in the formula of one entry, or of several that have the same.
    fn doubles(&self, has_sense: bool) -> Vec<Found<'a>> {
        let formulas = &self.machine.formulas;
        let wrong: Vec<usize> = (0..self.entries.len()).filter(|at| self.wrong.contains(*at)).collect();
        let own: Vec<usize> = wrong.iter().map(|&at| self.entries[at].0).collect();
        let shared = &formulas.formulas[own[0]].shared;
        let is_one = own.iter().all(|formula| shared.contains(formula));
        if !is_one {
            return Vec::new();
        }
        // Also where the others of them are not given.
        let given: Vec<usize> = self.entries.iter().map(|(formula, ..)| *formula).collect();
        let is_shared = shared.iter().all(|formula| own.contains(formula) || !given.contains(formula));
        let meant = if is_shared { shared.clone() } else { own };
        let (_, place, number) = self.entries[wrong[0]];
        let here = self.machine.world();
        let (quantity, reading) = self.predictor.numbers()[number];
        let closed = self.predictor.entry(quantity, &here).unwrap_or_default() - here.entries[place];
        let (value, tolerance) = (reading.value - closed, self.predictor.tolerances()[number]);
        let found = double::find(self.machine, self.predictor, &meant, (value, tolerance));
        found.into_iter().filter(|own| !has_sense || double_has_sense(self.machine, own)).collect()
    }
}

/// Whether two slips in one formula leave one that makes sense by its units.
fn double_has_sense(machine: &Machine, found: &Found) -> bool {
    let has_sense = |double: &DoubleSlip| {
        let text = double.apply(machine.formulas.formulas[double.formulas[0]].text);
        let changed = machine.formulas.parse(&text);
        changed.is_some_and(|changed| machine.formulas.makes_sense(double.formulas[0], &changed))
    };
    found.causes.iter().all(|cause| match cause {
        Cause::Slips(double) => has_sense(double),
        _ => true,
    })
}
