//! Two slips in the formulas that together make the matrices.
//!
//! Ten thousand slips have fifty million pairs. Only those are evaluated that may be it by the numbers in which each of them is
//! seen: what is wrong beside one slip the other one must change, and the other way round.

use std::collections::BTreeMap;

use carvallo_slips::FormulaSlip;

use super::beside::{self, Condition, Group, Left};
use super::curve::Curve;
use super::set::Set;
use super::{Cause, DoubleSlip, Found, double};
use crate::machine::Machine;
use crate::predict::Predictor;
use crate::relation::{Relation, Term};

/// So many pairs are compared at most, so many evaluated, and so many that fit are kept, the likeliest.
const COMPARED: usize = 20_000_000;
const EVALUATED: usize = 2_000_000;
const KEPT: usize = 100;

/// An entry that is the same but for rounding, relative to it.
const SAME: f64 = 1e-12;

/// All pairs of slips in two formulas, or in that of one entry, with which everything fits: of those that make sense by their
/// units where there are any, else of all. None where no relation of entries of matrices is wrong: these themselves, C and K at a
/// speed, or what stands behind a state matrix.
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

/// Slips in the same formulas that are seen in the same relations.
struct Class<'a> {
    formulas: &'a [usize],
    /// The relations that they change, and those that are wrong with one of them alone.
    changed: Set,
    wrong: Set,
    slips: Vec<&'a FormulaSlip>,
}

/// A relation that is tried with each pair.
struct Pivot<'a> {
    relation: &'a Relation,
    gravity: f64,
}

impl Condition for Pivot<'_> {
    fn curve(&self, here: f64, nodes: &[Vec<f64>; 4]) -> Option<Box<dyn Fn(f64) -> bool>> {
        let of = |entries: &Vec<f64>| {
            let [off, allowed] = self.relation.off(entries, self.gravity);
            [off, allowed, self.relation.size(entries, self.gravity)]
        };
        let curve = Curve::new(here, nodes.each_ref().map(of));
        curve.map(|curve| Box::new(move |value| curve.may_hold(value)) as Box<_>)
    }
}

struct Search<'a, 'b> {
    machine: &'a Machine,
    predictor: &'b Predictor<'b>,
    /// Those of the open loop.
    relations: Vec<Relation>,
    gravity: f64,
    /// The relations that are wrong.
    wrong: Set,
    classes: Vec<Class<'a>>,
}

impl<'a, 'b> Search<'a, 'b> {
    fn new(machine: &'a Machine, predictor: &'b Predictor<'b>) -> Option<Self> {
        let relations = predictor.relations_of_open_loop(&machine.world());
        let (gravity, wrong, classes) = (machine.gravity(&machine.parameters), Set::default(), Vec::new());
        let mut own = Self { machine, predictor, relations, gravity, wrong, classes };
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

    fn set(&self, is_in: impl Fn(&Relation) -> bool) -> Set {
        let mut set = Set::default();
        let all = self.relations.iter().enumerate();
        all.filter(|(_, own)| is_in(own)).for_each(|(at, _)| set.insert(at));
        set
    }

    fn wrong(&self, entries: &[f64]) -> Set {
        self.set(|own| !own.holds(entries, self.gravity))
    }

    fn changed(&self, entries: &[f64]) -> Set {
        let here = &self.machine.values.entries;
        let differs = |&Term { place, .. }: &Term| {
            let difference = (entries[place] - here[place]).abs();
            difference.is_nan() || difference > SAME * here[place].abs()
        };
        self.set(|own| own.terms.iter().any(differs))
    }

    /// Whether a term is of one of these formulas.
    fn is_of(&self, term: &Term, formulas: &[usize]) -> bool {
        self.machine.formula(term.place).is_some_and(|own| formulas.contains(&own))
    }

    /// Slips in two formulas, the first of which does not depend on the second.
    fn pairs(&self, has_sense: bool) -> Vec<Found<'a>> {
        let mut found = Vec::new();
        let mut left = Left { compared: COMPARED, evaluated: EVALUATED };
        let of_formulas: Vec<&[Class]> = self.classes.chunk_by(|a, b| a.formulas == b.formulas).collect();
        let is_of_mechanism = |class: &Class| self.machine.formulas.formulas[class.formulas[0]].is_of_mechanism;
        let may_follow = |first: &Class, second: &Class| {
            first.formulas[0] < second.formulas[0]
                && is_of_mechanism(first) == is_of_mechanism(second)
                && first.formulas.iter().all(|formula| !second.formulas.contains(formula))
        };
        for seconds in &of_formulas {
            for firsts in of_formulas.iter().filter(|firsts| may_follow(&firsts[0], &seconds[0])) {
                self.of_formulas([firsts, seconds], has_sense, &mut left, &mut found);
            }
        }
        found
    }

    fn of_formulas(
        &self,
        [firsts, seconds]: [&[Class<'a>]; 2],
        has_sense: bool,
        left: &mut Left,
        found: &mut Vec<Found<'a>>,
    ) {
        let slips: Vec<&FormulaSlip> = seconds.iter().flat_map(|class| class.slips.iter().copied()).collect();
        let group = |first: &Class<'a>| {
            let is_beside =
                |second: &Class| second.wrong.is_within(&first.changed) && first.wrong.is_within(&second.changed);
            let mut places = 0..;
            let mut own = Vec::new();
            for second in seconds {
                let of_class = places.by_ref().take(second.slips.len());
                if is_beside(second) { own.extend(of_class) } else { of_class.for_each(drop) }
            }
            Group { firsts: first.slips.clone(), seconds: own }
        };
        let groups: Vec<Group> = firsts.iter().map(group).filter(|group| !group.seconds.is_empty()).collect();
        if groups.is_empty() {
            return;
        }
        // The relations that both change, and then those that one of them does.
        let changes = |at: usize| {
            [firsts, seconds].iter().filter(|classes| classes.iter().any(|own| own.changed.contains(at))).count()
        };
        let mut pivots: Vec<usize> = (0..self.relations.len()).filter(|at| changes(*at) > 0).collect();
        pivots.sort_by_key(|at| std::cmp::Reverse(changes(*at)));
        let pivot = |at: usize| Pivot { relation: &self.relations[at], gravity: self.gravity };
        let pivots: Vec<Pivot> = pivots.into_iter().map(pivot).collect();
        let conditions: Vec<&dyn Condition> = pivots.iter().map(|own| own as _).collect();
        let is_meant = |a: &FormulaSlip, b: &FormulaSlip| (a.makes_sense && b.makes_sense) == has_sense;
        beside::pairs(self.machine, &conditions, &groups, &slips, &is_meant, left, &mut |a, b, values| {
            let world = self.machine.world_from(values.clone(), &self.machine.parameters);
            if self.predictor.fits(&world) {
                found.push(Found { causes: vec![Cause::Slip(a), Cause::Slip(b)], world });
            }
        });
    }

    /// Two slips in the formula of one entry, or of several that have the same.
    fn doubles(&self, has_sense: bool) -> Vec<Found<'a>> {
        let formulas = &self.machine.formulas;
        let has = |relation: &Relation, own: &[usize]| {
            relation.terms.iter().any(|term| term.is_seen() && self.is_of(term, own))
        };
        // Those whose change makes all wrong relations other ones, and no right ones.
        let explains = |own: &[usize]| !own.is_empty() && self.set(|relation| has(relation, own)) == self.wrong;
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for shared in formulas.formulas.iter().map(|formula| &formula.shared) {
            let is_wrong = |at: &usize| self.set(|relation| has(relation, &[*at])).is_within(&self.wrong);
            let is_given = |at: &usize| self.relations.iter().any(|relation| has(relation, &[*at]));
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
            let Some(relation) = self.relations.iter().find(|relation| has(relation, &meant)) else { continue };
            let own: Vec<&Term> = relation.terms.iter().filter(|term| self.is_of(term, &meant)).collect();
            let Some(now) = own.first().map(|term| self.machine.values.entries[term.place]) else { continue };
            let factor: f64 = own.iter().map(|term| term.factor(self.gravity)).sum();
            let [off, allowed] = relation.off(&self.machine.values.entries, self.gravity);
            let value = (now - off / factor, (allowed / factor).abs());
            found.extend(double::find(self.machine, self.predictor, &meant, value));
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
