//! What is watched for on the way: where functions of a motion change their signs.

use std::f64::consts::TAU;
use std::ops::ControlFlow;

use carvallo::simulation::{Crossing, Moment, SimulationError, Snapshot, change_of_sign};

use carvallo::sort_by;

use super::motion::Row;

/// A function of a motion that changes its sign where something happens.
pub struct Watch<'a> {
    /// What happens there.
    pub name: String,
    /// Which changes of sign count.
    pub crossing: Crossing,
    /// The motion ends when it has happened so often.
    pub ends: Option<usize>,
    /// Of the time, and of positions and rates in the order of what a [`Solver`](super::Solver) can be given.
    pub function: Box<dyn Fn(&Moment) -> f64 + 'a>,
}

/// Something that happened.
#[derive(Clone, Debug)]
pub struct Happened {
    /// The place of what was watched for.
    pub watch: usize,
    /// When, and the motion there.
    pub row: Row,
}

impl Watch<'_> {
    /// How a motion is said to end.
    pub(super) fn end(&self) -> String {
        format!("the event `{}`", self.name)
    }
}

/// Between two times it is looked at so many places at least, and at so many in a period of the fastest oscillation, but not at
/// more than the last.
const PARTS: [f64; 3] = [4.0, 8.0, 10_000.0];

/// The times at which a linear motion is looked at, those that are asked for among them, where its fastest oscillation has a
/// frequency in rad/s.
pub(super) fn looked_at(times: &[f64], fastest: f64) -> Vec<f64> {
    let [least, in_a_period, most] = PARTS;
    let mut all: Vec<f64> = times.first().copied().into_iter().collect();
    for pair in times.windows(2) {
        let length = pair[1] - pair[0];
        let count = (length * fastest * in_a_period / TAU).ceil().clamp(least, most);
        let parts = (1..count as u32).map(|part| pair[0] + length * f64::from(part) / count);
        all.extend(parts.filter(|time| *time > pair[0] && *time < pair[1]));
        all.push(pair[1]);
    }
    all
}

/// What happens in an exact motion, in its order, each by the place of what is watched for, and whether the last of it ends the
/// motion. `after` gives the motion at a time behind a moment of it.
///
/// # Errors
/// If the motion leaves the range of `f64`.
pub(super) fn happened(
    moments: &[Snapshot],
    watches: &[Watch],
    after: &dyn Fn(&Snapshot, f64) -> Result<Snapshot, SimulationError>,
    reach: &dyn Fn(f64) -> ControlFlow<()>,
) -> Result<(Vec<(usize, Snapshot)>, bool), SimulationError> {
    let value = |watch: &Watch, Snapshot { time, positions, rates, .. }: &Snapshot| {
        (watch.function)(&Moment { time: *time, positions, rates })
    };
    let values = |moment: &Snapshot| watches.iter().map(|watch| value(watch, moment)).collect::<Vec<f64>>();
    let mut happened: Vec<(usize, Snapshot)> = Vec::new();
    let Some(first) = moments.first() else { return Ok((happened, false)) };
    let mut before = values(first);
    for pair in moments.windows(2) {
        if reach(pair[1].time).is_break() {
            break;
        }
        let next = values(&pair[1]);
        let mut found = Vec::new();
        for (place, watch) in watches.iter().enumerate() {
            if watch.crossing.is_between(before[place], next[place]) {
                let at = |time: f64| after(&pair[0], time);
                let time = change_of_sign((pair[0].time, before[place]), pair[1].time, |time| {
                    at(time).map(|moment| value(watch, &moment))
                })?;
                found.push((place, at(time)?));
            }
        }
        sort_by(&mut found, |a, b| a.1.time.total_cmp(&b.1.time));
        for (place, moment) in found {
            happened.push((place, moment));
            let count = happened.iter().filter(|(other, _)| *other == place).count();
            if watches[place].ends.is_some_and(|ends| count >= ends) {
                return Ok((happened, true));
            }
        }
        before = next;
    }
    Ok((happened, false))
}
