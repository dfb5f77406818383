//! Many motions in lanes: one in each, and the next one where one has ended.

use fearless_simd::Simd;
use fearless_simd::prelude::*;

use super::super::transpose::MOST;
use super::super::{Blocks, InLanes, Lanes};
use super::ensemble::{Arrival, Ensemble, Outcome};
use super::start::{Start, close};
use super::states::{InLanesOf, States, info, motion};
use super::steps::{Path, Point, Step};
use crate::model::Nonlinear;
use crate::motion::{Unchecked, Vector};
use crate::number::real::Real;
use crate::number::{Number, Scalar};

/// Into how many parts a step is divided, to see a position leave its limits and come back.
const PARTS: u32 = 4;
/// More steps than these are taken for a motion that does not go on.
const MOST_STEPS: u32 = 100_000;
/// A step is made so much shorter than its error asks for.
const SAFETY: f64 = 0.9;
/// It grows and shrinks by no more than these.
const GROWTH: f64 = 5.0;
const SHRINKAGE: f64 = 0.2;

/// The motion in a lane.
#[derive(Clone, Copy, Default)]
struct Ride {
    /// Its place among all, if there is one.
    place: Option<usize>,
    /// How many steps were tried.
    steps: u32,
}

/// Simulates the motions of states, with the parameters of one design, or of those from one on.
#[inline(always)]
pub(super) fn run<S: Simd, const N: usize, M: Nonlinear<N, Scalar: InLanes>>(
    simd: S,
    ensemble: &Ensemble,
    (parameters, first): (&Blocks<M::Scalar>, usize),
    states: &mut [M::Scalar],
    outcomes: &mut [Outcome],
) {
    let lanes = Lanes::<S, M::Scalar>::COUNT;
    let splat = |value: f64| Lanes::<S, M::Scalar>::splat(simd, M::Scalar::from_f64(value));
    let tolerance = ensemble.tolerance.max(8.0 * M::Scalar::EPSILON.to_f64());
    let [one, duration] = [1.0, ensemble.duration].map(splat);
    let design = |place: usize| if parameters.len() == 1 { 0 } else { first + place };
    let mut states = States::<N, M>::new(states);
    let mut rides = [Ride::default(); MOST];
    let mut next = 0;
    let mut designs = M::array(|_| one);
    let mut equations = None;
    let mut forces = <InLanesOf<S, N, M> as Unchecked>::Forces::from_fn(|_| one);
    let [mut point, mut slope] = [Point::<InLanesOf<S, N, M>>::splat(one); 2];
    let [mut time, mut size] = [one; 2];
    loop {
        for (lane, ride) in rides[..lanes].iter_mut().enumerate() {
            while ride.place.is_none() && next < outcomes.len() {
                let place = next;
                next += 1;
                let design = design(place);
                let found = Start::<N, M>::new(ensemble, (parameters, design), &states, place);
                outcomes[place] = found.as_ref().map_or_else(|error| Err(*error), |start| Ok(start.arrival));
                let Ok(start) = found else { continue };
                states.set(place, start.point.numbers().copied());
                if start.arrival != Arrival::Reached {
                    continue;
                }
                *ride = Ride { place: Some(place), steps: 0 };
                time.set_lane(lane, M::Scalar::from_f64(0.0));
                size.set_lane(lane, M::Scalar::from_f64(start.size));
                point.set_lane(lane, &start.point);
                slope.set_lane(lane, &start.slope);
                for (numbers, force) in forces.as_mut().iter_mut().zip(start.forces.as_ref()) {
                    numbers.set_lane(lane, *force);
                }
                for (position, numbers) in designs.as_mut().iter_mut().enumerate() {
                    numbers.set_lane(lane, parameters.get(design, position));
                }
                equations = None;
            }
        }
        if rides.iter().all(|ride| ride.place.is_none()) {
            return;
        }
        let equations = equations.get_or_insert_with(
            #[inline(always)]
            || {
                motion::<S, N, M>(
                    #[inline(always)]
                    |position| designs.as_ref()[position],
                )
            },
        );
        let remaining = duration - time;
        let is_last = remaining.less_or_equal(size);
        let length = Lanes::select(is_last, remaining, size);
        let step = Step::new(equations, &forces, point, slope, length);
        let error = step.error(tolerance);
        let is_good = error.less_or_equal(one);
        size = length * growth(error);

        let mut end = step.end;
        let (_, closing) = equations.closure_unchecked(&end.positions);
        for (position, step) in info::<N, M>().dependent.iter().zip(closing.as_ref()) {
            end.positions.as_mut()[*position] = end.positions.as_ref()[*position] + *step;
        }
        let is_out = leaves(ensemble, &step).to_bitmask();
        let (good, last) = (is_good.to_bitmask(), is_last.to_bitmask());
        for (lane, ride) in rides[..lanes].iter_mut().enumerate() {
            let Some(place) = ride.place else { continue };
            let is = |mask: u64| mask >> lane & 1 != 0;
            let begun = time.lane(lane).to_f64();
            ride.steps += 1;
            let left = if is(good) && is(is_out) { leave(ensemble, &step, lane) } else { None };
            let arrival = match left {
                Some((limit, part)) => Arrival::Left { limit, time: begun + part * length.lane(lane).to_f64() },
                None if is(good) && is(last) => Arrival::Reached,
                None if ride.steps > MOST_STEPS || begun + size.lane(lane).to_f64() <= begun => {
                    Arrival::Stopped { time: begun }
                }
                None => continue,
            };
            ride.place = None;
            match arrival {
                Arrival::Left { .. } => {
                    let part = left.map_or(1.0, |(_, part)| part);
                    states.set(place, step.lane_at(lane, part).map(M::Scalar::from_f64));
                }
                Arrival::Reached => states.set(place, end.lane(lane)),
                Arrival::Stopped { .. } => states.set(place, point.lane(lane)),
            }
            outcomes[place] = match arrival {
                Arrival::Stopped { .. } => Ok(arrival),
                _ => close::<N, M>((parameters, design(place)), &mut states, place).map(|()| arrival),
            };
        }
        point = Point::select(is_good, end, &point);
        slope = Point::select(is_good, step.slope(), &slope);
        time = Lanes::select(is_good, time + length, time);
    }
}

/// How much longer the next step is, by the square of the error of this one: its inverse to the power of 1/8 where it is large
/// and of 1/16 where it is small, in the place of 1/10, which roots alone do not make.
#[inline(always)]
fn growth<S: Simd, T: InLanes>(error: Lanes<S, T>) -> Lanes<S, T> {
    let [one, least, most, safety] = [1.0, SHRINKAGE, GROWTH, SAFETY].map(|value| Number::like(error, value));
    let eighth = Number::sqrt(Number::sqrt(Number::sqrt(error)));
    let power = Lanes::select(error.less(one), Number::sqrt(eighth), eighth);
    let growth = safety / power;
    let growth = Lanes::select(growth.less(most), growth, most);
    // What has no value is tried again in a small step.
    Lanes::select(error.less_or_equal(error) & least.less(growth), growth, least)
}

/// Whether a position leaves a limit in a step.
#[inline(always)]
fn leaves<S: Simd, T: InLanes, U: Unchecked<Scalar = Lanes<S, T>>>(
    ensemble: &Ensemble,
    step: &Step<U>,
) -> <Lanes<S, T> as Real>::Mask {
    let mut leaves = step.size.less(step.size);
    for limit in ensemble.limits {
        let path = step.path(limit.position);
        let [low, high] = [limit.low, limit.high].map(|value| Number::like(step.size, value));
        for part in 1..=PARTS {
            let there = path.at(f64::from(part) / f64::from(PARTS));
            leaves = leaves | there.less(low) | high.less(there);
        }
    }
    leaves
}

/// The limit that is left first in a step of a lane, if one is, and at which part of it.
fn leave<S: Simd, T: InLanes, U: Unchecked<Scalar = Lanes<S, T>>>(
    ensemble: &Ensemble,
    step: &Step<U>,
    lane: usize,
) -> Option<(usize, f64)> {
    let paths = || ensemble.limits.iter().map(|limit| (limit, step.path(limit.position).lane(lane)));
    let part = |number: u32| f64::from(number) / f64::from(PARTS);
    let is_out = |number: u32| paths().any(|(limit, path)| limit.excludes(path.at(part(number))));
    let number = (1..=PARTS).find(|number| is_out(*number))?;
    let left = |(place, (limit, path)): (usize, (&super::limits::Limit, Path<f64>))| {
        let (mut inside, mut outside) = (part(number - 1), part(number));
        if !limit.excludes(path.at(outside)) {
            return None;
        }
        // As often as a double can be halved.
        for _ in 0..64 {
            let middle = 0.5 * (inside + outside);
            *(if limit.excludes(path.at(middle)) { &mut outside } else { &mut inside }) = middle;
        }
        Some((place, outside))
    };
    paths().enumerate().filter_map(left).min_by(|(_, x), (_, y)| x.total_cmp(y))
}
