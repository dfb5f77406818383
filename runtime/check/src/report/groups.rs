//! Explanations that make the same numbers, and what would tell the others apart.

use carvallo::{Expression, MatrixName};
use carvallo_design::number::shortest;

use super::words::words;
use super::{Explanation, Group};
use crate::conventions::{Convention, Effect};
use crate::explain::{Cause, Found, digits, relation};
use crate::given::Quantity;
use crate::machine::Machine;
use crate::predict::{Predictor, World};
use carvallo_slips::{Subject, entry_name};

/// The same numbers, but for rounding, relative to the largest of their matrix.
const SAME: f64 = 1e-11;

/// How much unlikelier a slip is in a formula that was derived from a mechanism: what is declared is its attributes.
const DERIVED: u32 = 5;

/// Groups explanations, the likeliest first.
pub fn groups(machine: &Machine, predictor: &Predictor, mut found: Vec<Found>) -> Vec<Group> {
    found.sort_by_key(|found| found.rank(machine));
    let has_nonlinear = predictor.has_nonlinear();
    let mut sorted: Vec<Vec<Found>> = Vec::new();
    for own in found {
        match sorted.iter_mut().find(|group| are_same(machine, has_nonlinear, &group[0].world, &own.world)) {
            Some(group) => group.push(own),
            None => sorted.push(vec![own]),
        }
    }
    sorted.iter_mut().for_each(|group| drop_copies(machine, group));
    let first = sorted.first().map(|group| group[0].world.clone());
    let mut groups = Vec::new();
    for (at, group) in sorted.into_iter().enumerate() {
        let apart =
            first.as_ref().filter(|_| at > 0).and_then(|first| apart(machine, predictor, first, &group[0].world));
        let elsewhere: Vec<Vec<Option<World>>> = group
            .iter()
            .map(|found| machine.others().iter().map(|other| world(other, machine, found)).collect())
            .collect();
        let mut classes: Vec<usize> = Vec::new();
        let mut explanations = Vec::new();
        for (at, found) in group.iter().enumerate() {
            let is_same = |&class: &usize| {
                !elsewhere[at].is_empty()
                    && elsewhere[class].iter().zip(&elsewhere[at]).all(|pair| match pair {
                        (Some(a), Some(b)) => are_same(machine, has_nonlinear, a, b),
                        _ => false,
                    })
            };
            let class = classes.iter().copied().find(is_same).unwrap_or_else(|| {
                classes.push(at);
                at
            });
            let causes = found.causes.iter().map(|cause| words(machine, cause)).collect();
            let class = classes.iter().position(|own| *own == class).unwrap_or_default();
            explanations.push(Explanation { causes, class });
        }
        groups.push(Group { explanations, apart });
    }
    groups
}

/// Drops what is told already: another value of a parameter that is the same one, and slips in definitions that attributes of a
/// mechanism use, where the same slip in formulas that were derived from it makes the same matrices.
fn drop_copies(machine: &Machine, group: &mut Vec<Found>) {
    let mut told: Vec<Vec<Changed>> = Vec::new();
    group.retain(|found| {
        let mut own: Vec<Changed> = found.causes.iter().map(|cause| Changed::new(machine, cause)).collect();
        own.sort();
        let is_new = !told.contains(&own);
        told.push(own);
        is_new
    });
    let subject = |found: &Found| match found.causes[..] {
        [Cause::Slip(own)] => Some((machine.formulas.formulas[own.formulas[0]].subject, own.slip.clone())),
        _ => None,
    };
    let all: Vec<_> = group.iter().filter_map(subject).collect();
    group.retain(|found| match subject(found) {
        Some((Subject::OfMechanism(name), slip)) => !all.contains(&(Subject::Definition(name), slip)),
        _ => true,
    });
}

/// What a cause changes: parameters, with the digits in which values differ that are not the same, or something else, in words.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Changed {
    Parameters(Vec<(usize, String)>),
    Other(String),
}

impl Changed {
    fn new(machine: &Machine, cause: &Cause) -> Self {
        let digits = |&(at, value): &(usize, f64)| (at, format!("{value:.11e}"));
        match cause {
            Cause::Convention(Convention { effect: Effect::Parameters(values), .. }) => {
                let mut values: Vec<_> = values.iter().map(digits).collect();
                values.sort();
                Self::Parameters(values)
            }
            Cause::Parameter(at, value) => Self::Parameters(vec![digits(&(*at, *value))]),
            other => Self::Other(words(machine, other)),
        }
    }
}

/// How unlikely a cause is.
pub fn rank(machine: &Machine, cause: &Cause) -> u32 {
    let derived = |formulas: &[usize]| if machine.formulas.is_derived(formulas[0]) { DERIVED } else { 0 };
    match cause {
        Cause::Convention(own) => u32::from(own.rank),
        Cause::Slip(own) => own.rank() + derived(&own.formulas),
        Cause::Slips(double) => double.rank() + derived(&double.formulas),
        Cause::Parameter(at, value) => match relation(machine.parameters[*at], *value) {
            Some(_) => 1,
            // A value of few digits may be what stood there.
            None if digits(*value) <= 3 => 3,
            None => 7,
        },
        Cause::Definition(..) => 8,
        Cause::Speed(_) | Cause::Scaled(_) => 3,
        Cause::CutOff(rank, _) => *rank,
        Cause::Force(own) if own.is_of_declared() => 0,
        Cause::Written(_) | Cause::Feedback(_) | Cause::Force(_) => 4,
    }
}

/// Whether two make the same matrices, and, where nonlinear equations are meant, the same motion.
fn are_same(machine: &Machine, has_nonlinear: bool, a: &World, b: &World) -> bool {
    let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME * a.abs();
    let square = machine.formulas.count * machine.formulas.count;
    let mut matrices = a.entries.chunks_exact(square).zip(b.entries.chunks_exact(square));
    let is_same = |(a, b): (&[f64], &[f64])| {
        let largest = a.iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
        a.iter().zip(b).all(|(a, b)| (a - b).abs() <= SAME * largest)
    };
    let matters = |attribute: usize| machine.motion.as_ref().is_some_and(|motion| motion.depend_on(attribute));
    let mut attributes = a.attributes.iter().zip(&b.attributes).enumerate();
    is_near((&a.gravity, &b.gravity))
        && a.gains.iter().zip(&b.gains).all(is_near)
        && matrices.all(is_same)
        && (!has_nonlinear || attributes.all(|(at, both)| is_near(both) || !matters(at)))
}

/// The first entry, or another number, in which matrices differ that was not given, with both values.
fn apart(machine: &Machine, predictor: &Predictor, first: &World, other: &World) -> Option<String> {
    let count = machine.formulas.count;
    let is_given = |own: (MatrixName, usize, usize)| {
        predictor.numbers().iter().any(|(quantity, _)| *quantity == Quantity::Entry(own.0, own.1, own.2))
    };
    let mut largest: Option<(f64, String)> = None;
    let [first, other] = [first, other].map(|world| predictor.closed_entries(world));
    for (at, (a, b)) in first.iter().zip(other.iter()).enumerate() {
        let own = (MatrixName::ALL[at / (count * count)], at / count % count, at % count);
        let differs = (a - b).abs() / a.abs().max(b.abs());
        if differs > 1e-9 && largest.as_ref().is_none_or(|(known, _)| differs > *known) {
            let more = if is_given(own) { " with more digits" } else { "" };
            let shown = machine.units.of(super::unit(Quantity::Entry(own.0, own.1, own.2), machine.info));
            let [a, b] = apart_in_digits([a, b].map(|value| shown.value(*value)));
            let text = format!("{}{more}: {b} by this, {a} by the first", entry_name(own.0, own.1, own.2));
            largest = Some((differs, text));
        }
    }
    largest.map(|(_, text)| text)
}

/// Six digits, or more where it takes more to tell two numbers apart; or fewer that are all.
fn apart_in_digits(both: [f64; 2]) -> [String; 2] {
    let with = |digits: usize| both.map(|value| shortest(format!("{value:.digits$e}").parse().unwrap_or(value)));
    (5..16).map(with).find(|[a, b]| a != b).unwrap_or_else(|| both.map(shortest))
}

/// What an explanation makes of another machine; `None` where that is not told.
fn world(other: &Machine, machine: &Machine, found: &Found) -> Option<World> {
    let mut parameters = other.parameters.clone();
    let mut of_matrices: Vec<&Convention> = Vec::new();
    let mut slips: Vec<(Vec<usize>, Expression)> = Vec::new();
    for cause in &found.causes {
        match cause {
            Cause::Convention(own) => {
                // What depends on the parameters each machine has its own of.
                let mut all = other.usual.iter().chain(&other.single);
                let own = match (&own.effect, all.find(|known| known.what == own.what)) {
                    (_, Some(own)) => own,
                    (Effect::Parameters(_), None) => return None,
                    _ => own,
                };
                own.change_parameters(&mut parameters);
                if !matches!(own.effect, Effect::Parameters(_)) {
                    of_matrices.push(own);
                }
            }
            Cause::Slip(own) => slips.push((own.formulas.clone(), own.changed.clone())),
            Cause::Slips(double) => {
                let text = double.apply(machine.formulas.formulas[double.formulas[0]].text);
                slips.push((double.formulas.clone(), machine.formulas.parse(double.formulas[0], &text)?));
            }
            // No matrices change with it.
            Cause::CutOff(..) => {}
            Cause::Parameter(..)
            | Cause::Definition(..)
            | Cause::Speed(_)
            | Cause::Scaled(_)
            | Cause::Feedback(_)
            | Cause::Force(_)
            | Cause::Written(_) => return None,
        }
    }
    let mut values = other.formulas.values(&parameters);
    match &slips[..] {
        [] => {}
        [(formulas, changed)] => other.formulas.change(formulas, changed, &parameters, &mut values),
        [(first, a), (second, b), ..] => {
            let affected = other.formulas.affected(first.iter().chain(second).copied());
            other.formulas.change_both([(first, a), (second, b)], &affected, &parameters, &mut values);
        }
    }
    let old = other.world_from(values, &parameters);
    Some(of_matrices.into_iter().fold(old, |old, convention| {
        let mut own = World::default();
        convention.change_matrices(&old, &mut own, other.formulas.count);
        own
    }))
}
