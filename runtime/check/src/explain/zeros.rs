//! Two slips in the formulas that together make eigenvalues at speeds.
//!
//! Eigenvalues are not linear in the entries, but each is a zero of the determinant of `s^2 M + s C + K`, whose entries are parabolas in
//! the value of one formula: that tells of nearly all pairs that they do not make it, by a few products.

use std::collections::BTreeMap;

use carvallo::Complex;
use carvallo_slips::FormulaSlip;

use super::beside::{self, Condition, Left};
use super::curve::{NODES, parabola, step};
use super::{Cause, Found};
use crate::machine::Machine;
use crate::predict::Predictor;
use crate::zero::{ROUNDING, Square, Zero, determinant, size};

/// So many pairs are compared at most, so many evaluated, and so many that fit are kept, the likeliest.
const COMPARED: usize = 10_000_000;
const EVALUATED: usize = 1_000_000;
const KEPT: usize = 100;

/// All pairs of slips in two formulas that make sense by their units, with which everything fits, where nothing but eigenvalues and
/// critical speeds is given.
pub fn find<'a>(machine: &'a Machine, predictor: &Predictor) -> Vec<Found<'a>> {
    if !predictor.relations().is_empty() {
        return Vec::new();
    }
    // What is the farthest off tells the most.
    let Some(zero) = predictor.zeros().first() else { return Vec::new() };
    let closing: Vec<(usize, f64)> = predictor.closed(&machine.world()).collect();
    let pivot = Pivot { zero, closing, gravity: machine.gravity(&machine.parameters), count: machine.formulas.count };
    let mut all: BTreeMap<&[usize], Vec<&FormulaSlip>> = BTreeMap::new();
    let slips = machine.slips().iter().filter(|own| own.makes_sense && !own.is_circular);
    slips.for_each(|own| all.entry(&own.formulas).or_default().push(own));
    let is_of_mechanism = |formulas: &[usize]| machine.formulas.formulas[formulas[0]].is_of_mechanism;
    let mut left = Left { compared: COMPARED, evaluated: EVALUATED };
    let mut found = Vec::new();
    for (second, seconds) in &all {
        let is_before = |first: &&[usize]| {
            first[0] < second[0]
                && is_of_mechanism(first) == is_of_mechanism(second)
                && first.iter().all(|own| !second.contains(own))
        };
        for (first, firsts) in all.iter().filter(|(first, _)| is_before(first)) {
            let affected = machine.formulas.affected(first.iter().chain(*second).copied());
            beside::pairs(machine, &pivot, &affected, [firsts, seconds], &|_, _| true, &mut left, &mut |a, b| {
                let world = machine.world_of_both(a, b, &affected);
                if predictor.fits(&world) {
                    found.push(Found { causes: vec![Cause::Slip(a), Cause::Slip(b)], world });
                }
            });
        }
    }
    found.sort_by_key(|own| own.causes.iter().map(Cause::rank_of_slips).sum::<u32>());
    found.truncate(KEPT);
    found
}

/// The eigenvalue that is tried first.
struct Pivot<'a> {
    zero: &'a Zero,
    /// What feedback takes from entries.
    closing: Vec<(usize, f64)>,
    gravity: f64,
    count: usize,
}

impl Pivot<'_> {
    fn closed(&self, entries: &[f64]) -> Vec<f64> {
        let mut own = entries.to_vec();
        self.closing.iter().for_each(|(at, value)| own[*at] -= value);
        own
    }
}

impl Condition for Pivot<'_> {
    fn holds(&self, entries: &[f64]) -> bool {
        self.zero.holds(&self.closed(entries), self.gravity)
    }

    fn curve(&self, here: f64, entries: &mut dyn FnMut(f64) -> Vec<f64>) -> Option<Box<dyn Fn(f64) -> bool>> {
        let (step, count) = (step(here), self.count);
        let nodes = NODES.map(|node| self.zero.matrices(&self.closed(&entries(here + node * step)), self.gravity));
        let allowed = nodes.iter().map(|own| self.zero.off(own)[1]).fold(0.0, f64::max);
        let [middle, right, left, far] = nodes.map(|[own, ..]| own);
        let entry = |at: usize| parabola(middle[at], right[at], left[at]);
        let parabolas: Vec<[Complex<f64>; 3]> = (0..count * count).map(entry).collect();
        let at =
            move |steps: f64| -> Square { parabolas.iter().map(|[a, b, c]| a + (b + c * steps) * steps).collect() };
        let largest = far.iter().chain(&middle).fold(0.0, |largest: f64, own| largest.max(own.norm()));
        let is_parabola = at(NODES[3]).iter().zip(&far).all(|(own, far)| (own - far).norm() <= ROUNDING * largest);
        if !is_parabola {
            return None;
        }
        Some(Box::new(move |value| {
            let steps = (value - here) / step;
            let own = at(steps);
            let rounding = 10.0 * ROUNDING * size(&own, count);
            determinant(own, count).norm() <= 4.0 * allowed * (1.0 + steps * steps).powi(count as i32) + rounding
        }))
    }
}
