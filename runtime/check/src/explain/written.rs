//! Numbers that were written wrongly, whatever they come from: a sign, a decimal point, digits, one number at the place of
//! another.

use super::relation;
use crate::given::{Quantity, Reading};
use crate::predict::Predictor;

/// How one number was written wrongly, or two that were exchanged.
#[derive(Clone, Debug, PartialEq)]
pub struct Written {
    /// By their places in what was given.
    pub numbers: Vec<usize>,
    /// In words, as the end of a sentence: `A_31 at 5 m/s has the other sign`.
    pub what: String,
}

/// All of them among numbers that should be these: those that were exchanged first.
pub fn written(predictor: &Predictor, here: &[f64]) -> Vec<Written> {
    let name = |at: usize| predictor.name(at);
    let wrong: Vec<usize> = (0..here.len()).filter(|&at| !predictor.agrees(at, here[at])).collect();
    let mut found = Vec::new();
    for (index, &one) in wrong.iter().enumerate() {
        for &other in &wrong[index + 1..] {
            if is_of_one_matrix(predictor, one, other)
                && is(predictor, one, here[other])
                && is(predictor, other, here[one])
            {
                let what = format!("{} and {} are exchanged", name(one), name(other));
                found.push(Written { numbers: vec![one, other], what });
            }
        }
    }
    for &at in &wrong {
        if let Some(what) = of_one(predictor, at, here) {
            found.push(Written { numbers: vec![at], what: format!("{} {what}", name(at)) });
        } else if let Some((other, sign)) = of_another(predictor, at, here) {
            let what = format!("{} has the value of {sign}{}", name(at), name(other));
            found.push(Written { numbers: vec![at], what });
        }
    }
    found
}

/// Whether a number is this one, which is not lost in its rounding.
fn is(predictor: &Predictor, at: usize, value: f64) -> bool {
    predictor.agrees(at, value) && value.abs() > 10.0 * predictor.tolerances()[at]
}

fn is_of_one_matrix(predictor: &Predictor, one: usize, other: usize) -> bool {
    match [one, other].map(|at| predictor.numbers()[at].0) {
        [Quantity::Entry(a, ..), Quantity::Entry(b, ..)] => a == b,
        [Quantity::State(a, ..), Quantity::State(b, ..)] | [Quantity::System(a, ..), Quantity::System(b, ..)] => a == b,
        _ => false,
    }
}

fn of_one(predictor: &Predictor, at: usize, here: &[f64]) -> Option<String> {
    let (reading, ours) = (predictor.numbers()[at].1, here[at]);
    if !ours.is_finite() || ours.abs() <= 10.0 * predictor.tolerances()[at] {
        return None;
    }
    if reading.value == 0.0 {
        return Some("is lost".to_owned());
    }
    let is = |factor: f64| is(predictor, at, factor * ours);
    let factors = [
        (-1.0, "has the other sign"),
        (2.0, "is twice what it is here"),
        (0.5, "is half of what it is here"),
        (10.0, "has its decimal point one place too far to the right"),
        (0.1, "has its decimal point one place too far to the left"),
        (100.0, "has its decimal point two places too far to the right"),
        (0.01, "has its decimal point two places too far to the left"),
        (180.0 / std::f64::consts::PI, "is in degrees"),
    ];
    if let Some((_, what)) = factors.iter().find(|(factor, _)| is(*factor)) {
        return Some((*what).to_owned());
    }
    digits(reading, ours).map(|how| format!("has {how}"))
}

/// What became of the digits, of numbers that have enough of them.
fn digits(reading: &Reading, ours: f64) -> Option<&'static str> {
    const ENOUGH: usize = 4;
    let rounded: f64 = reading.rounding(ours).parse().ok()?;
    let how = relation(rounded, reading.value).filter(|how| how.contains("digit"));
    how.filter(|_| (ENOUGH..=12).contains(&reading.digits))
}

/// Another entry of the same matrix whose value it has, and the sign before it.
fn of_another(predictor: &Predictor, at: usize, here: &[f64]) -> Option<(usize, &'static str)> {
    let others = (0..here.len()).filter(|&other| other != at && is_of_one_matrix(predictor, at, other));
    others.flat_map(|other| [(other, "", here[other]), (other, "-", -here[other])]).find_map(|(other, sign, value)| {
        // A 1 or a 0 stands in many places.
        (is(predictor, at, value) && value.abs() != 1.0).then_some((other, sign))
    })
}
