//! Matrices that are multiplied by a unit, or by the speed that stands before them.

use std::ops::RangeInclusive;

use carvallo::MatrixName;

use super::factor::{Scaled, unit};
use super::solve::{digits, simplest};
use super::{Cause, Found};
use crate::conventions::power;
use crate::given::Quantity;
use crate::machine::Machine;
use crate::predict::Predictor;

/// A speed by which one matrix alone is multiplied has so many digits at most.
const PLAIN: usize = 3;

/// And it is one at which such machines go, in m/s: what is larger is a factor of a unit.
const SPEEDS: RangeInclusive<f64> = 0.1..=60.0;

/// One matrix alone tells a factor by so many numbers, if it is that of a unit.
const ENOUGH: usize = 3;

/// What a factor may be, from the numbers of one matrix.
#[derive(Clone, Copy)]
struct Range {
    of: Of,
    low: f64,
    high: f64,
    /// How many numbers tell it.
    count: usize,
}

/// Which matrix: one of M, C1, …, or a C or K at a speed.
#[derive(Clone, Copy, PartialEq)]
enum Of {
    Matrix(MatrixName),
    System(usize),
}

impl Range {
    fn has_one(&self) -> bool {
        self.low <= 1.0 && 1.0 <= self.high
    }

    /// The matrix and the power of the speed that stands before it; `None` where that is none, or in it.
    fn power(&self) -> Option<(MatrixName, i32)> {
        match self.of {
            Of::Matrix(matrix) => Some((matrix, power(matrix))).filter(|(_, power)| *power != 0),
            Of::System(_) => None,
        }
    }

    /// What the speed is by it.
    fn of_speed(self) -> Option<Self> {
        let root = 1.0 / f64::from(self.power()?.1);
        let [a, b] = [self.low, self.high].map(|own| own.powf(root));
        (self.low > 0.0).then_some(Self { low: a.min(b), high: a.max(b), ..self })
    }
}

/// A factor of all matrices that are given, or a speed in them, that makes all numbers.
pub fn find<'a>(machine: &'a Machine, predictor: &Predictor, here: &[f64]) -> Option<Found<'a>> {
    let ranges = ranges(predictor, here)?;
    if !machine.feedback.is_empty() || ranges.iter().all(Range::has_one) {
        return None;
    }
    let all = middle(&ranges).and_then(|factor| fitting(machine, predictor, factor, Scaled::All));
    if let [own] = ranges[..] {
        let is_told = |found: &Found| matches!(found.causes[..], [Cause::Scaled(Scaled::All(x))] if unit(x).is_some());
        return all.filter(|found| own.count >= ENOUGH && is_told(found));
    }
    let (with_speed, others): (Vec<Range>, Vec<Range>) = ranges.iter().partition(|own| own.power().is_some());
    let is_beside = || others.iter().all(Range::has_one);
    let by_speed = || {
        let speeds: Vec<Range> = with_speed.iter().map(|own| own.of_speed()).collect::<Option<_>>()?;
        let speed = middle(&speeds).filter(|_| speeds.len() > 1 && is_beside())?;
        fitting(machine, predictor, speed, Scaled::Speed)
    };
    let by_one = || {
        let mut wrong = with_speed.iter().filter(|own| !own.has_one());
        let own = wrong.next().filter(|_| is_beside())?;
        let (matrix, _) = own.power()?;
        let speed = middle(&[own.of_speed()?]).filter(|_| wrong.next().is_none())?;
        let found = fitting(machine, predictor, speed, |speed| Scaled::One(matrix, speed))?;
        let is_speed = |speed: f64| {
            // What has g in it in error is no rarer.
            let is_gravity = (speed / machine.gravity(&machine.parameters) - 1.0).abs() < 5e-3;
            digits(speed) <= PLAIN && SPEEDS.contains(&speed) && !is_gravity
        };
        let is_plain = matches!(found.causes[..], [Cause::Scaled(Scaled::One(_, speed))] if is_speed(speed));
        is_plain.then_some(found)
    };
    all.or_else(by_speed).or_else(by_one)
}

/// By which factor the entries of each matrix may be larger than those here; `None` where that is none of one.
fn ranges(predictor: &Predictor, here: &[f64]) -> Option<Vec<Range>> {
    let mut ranges: Vec<Range> = Vec::new();
    for (at, ((quantity, reading), ours)) in predictor.numbers().iter().zip(here).enumerate() {
        let of = match *quantity {
            Quantity::Entry(matrix, ..) => Of::Matrix(matrix),
            Quantity::System(at, ..) => Of::System(at),
            _ => continue,
        };
        let tolerance = predictor.tolerances()[at];
        // What is lost in rounding tells nothing.
        if ours.abs() <= tolerance {
            continue;
        }
        let [a, b] = [reading.value - tolerance, reading.value + tolerance].map(|own| own / ours);
        let [low, high] = [a.min(b), a.max(b)];
        match ranges.iter_mut().find(|own| own.of == of) {
            Some(own) => *own = Range { of, low: own.low.max(low), high: own.high.min(high), count: own.count + 1 },
            None => ranges.push(Range { of, low, high, count: 1 }),
        }
    }
    ranges.iter().all(|own| own.low <= own.high).then_some(ranges)
}

/// The middle of what all of them allow.
fn middle(ranges: &[Range]) -> Option<f64> {
    let low = ranges.iter().fold(f64::NEG_INFINITY, |low, own| low.max(own.low));
    let high = ranges.iter().fold(f64::INFINITY, |high, own| high.min(own.high));
    (low <= high && low.is_finite() && high.is_finite()).then_some(f64::midpoint(low, high))
}

/// With the value of the fewest digits, or that of a unit, with which everything fits.
fn fitting<'a>(
    machine: &'a Machine,
    predictor: &Predictor,
    x: f64,
    scaled: impl Fn(f64) -> Scaled,
) -> Option<Found<'a>> {
    let world = |x: f64| scaled(x).world(machine);
    let fits = |x: f64| predictor.fits(&world(x));
    let of_unit = unit(x).map(|(factor, _)| factor).filter(|_| matches!(scaled(x), Scaled::All(_)));
    let plain = simplest(x, x, &fits);
    // A seventh is a division by 7.
    let inverse = simplest(1.0 / x, 1.0 / x, &|own| fits(1.0 / own));
    let inverse = inverse.filter(|own| x.abs() < 1.0 && plain.is_none_or(|plain| digits(*own) < digits(plain)));
    let x = of_unit.into_iter().chain(inverse.map(|own| 1.0 / own)).chain(plain).find(|x| fits(*x))?;
    Some(Found { causes: vec![Cause::Scaled(scaled(x))], world: world(x) })
}
