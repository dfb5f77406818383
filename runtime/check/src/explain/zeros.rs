//! Two slips in the formulas that together make eigenvalues at speeds.
//!
//! Eigenvalues are not linear in the entries, but each is a zero of the determinant of `s^2 M + s C + K`, whose entries are parabolas in
//! the value of one formula: that tells of nearly all pairs that they do not make it, by a few products.

use std::collections::BTreeMap;

use carvallo::Complex;
use carvallo_slips::FormulaSlip;

use super::beside::{self, Condition, Group, Left};
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
    let closing: Vec<(usize, f64)> = predictor.closed(&machine.world()).collect();
    let (gravity, count) = (machine.gravity(&machine.parameters), machine.formulas.count);
    let pivot = |zero| Pivot { zero, closing: &closing, gravity, count };
    let pivots: Vec<Pivot> = predictor.zeros().iter().map(pivot).collect();
    let conditions: Vec<&dyn Condition> = pivots.iter().map(|own| own as _).collect();
    if conditions.is_empty() {
        return Vec::new();
    }
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
        for (_, firsts) in all.iter().filter(|(first, _)| is_before(first)) {
            let groups = [Group { firsts: firsts.clone(), seconds: (0..seconds.len()).collect() }];
            beside::pairs(machine, &conditions, &groups, seconds, &|_, _| true, &mut left, &mut |a, b, values| {
                let world = machine.world_from(values.clone(), &machine.parameters);
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
    closing: &'a [(usize, f64)],
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
    fn curve(&self, here: f64, nodes: &[Vec<f64>; 4]) -> Option<Box<dyn Fn(f64) -> bool>> {
        let (step, count) = (step(here), self.count);
        let nodes = nodes.each_ref().map(|entries| self.zero.matrices(&self.closed(entries), self.gravity));
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
        let rounding = 10.0
            * ROUNDING
            * [&middle, &right, &left, &far].map(|own| size(own, count)).into_iter().fold(0.0, f64::max);
        let curve = Newton::new(2 * count, |steps| determinant(&at(steps), count));
        Some(Box::new(move |value| {
            let steps = (value - here) / step;
            let most = (4.0 * allowed + rounding) * (1.0 + steps * steps).powi(count as i32);
            curve.squared(steps) <= most * most
        }))
    }
}

/// A complex polynomial in a real variable, as Newton has it: by divided differences at the whole numbers around zero.
struct Newton {
    nodes: Vec<f64>,
    parts: [Vec<f64>; 2],
}

impl Newton {
    /// The one of a degree through these values.
    fn new(degree: usize, value: impl Fn(f64) -> Complex<f64>) -> Self {
        let nodes: Vec<f64> = (0..=degree).map(|at| at as f64 - (degree / 2) as f64).collect();
        let mut differences: Vec<Complex<f64>> = nodes.iter().map(|node| value(*node)).collect();
        for order in 1..=degree {
            for at in (order..=degree).rev() {
                differences[at] = (differences[at] - differences[at - 1]) / (nodes[at] - nodes[at - order]);
            }
        }
        let parts = [differences.iter().map(|own| own.re).collect(), differences.iter().map(|own| own.im).collect()];
        Self { nodes, parts }
    }

    /// The square of its absolute value.
    fn squared(&self, x: f64) -> f64 {
        let mut sum = 0.0;
        for part in &self.parts {
            let mut value = 0.0;
            for at in (0..part.len()).rev() {
                value = value * (x - self.nodes[at]) + part[at];
            }
            sum += value * value;
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use carvallo::Complex;

    use super::Newton;

    /// (x - 2i)(x + 3)(x^2 + 1) at 0.7: |(0.7 - 2i) 3.7 * 1.49|^2 = 4.49 (3.7 * 1.49)^2.
    #[test]
    fn a_polynomial_is_known_by_its_values() {
        let polynomial = |x: f64| Complex::new(x, -2.0) * (x + 3.0) * (x * x + 1.0);
        let own = Newton::new(4, polynomial);
        let expected = 4.49 * (3.7_f64 * 1.49).powi(2);
        assert!((own.squared(0.7) - expected).abs() < 1e-12 * expected);
    }
}
