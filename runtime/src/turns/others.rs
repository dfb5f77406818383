//! Curves of turns that begin at no capsize speed.

use nalgebra::DVector;

use super::balance::Balance;
use super::follow::{Condition, Curve, unit_vector};
use super::{Turn, Turns, TurnsEnd, TurnsError};
use crate::motion::MotionError;
use crate::simulation::Machine;

/// Curves are looked for at these steers, or what else is the last free position, between these leans, in degrees.
const STEERS: [f64; 18] =
    [5.0, 15.0, 25.0, 35.0, 45.0, 55.0, 65.0, 75.0, 85.0, 95.0, 105.0, 115.0, 125.0, 135.0, 145.0, 155.0, 165.0, 175.0];
const LEANS: core::ops::RangeInclusive<i32> = -79..=79;

/// A turn that is as close as this to a curve, in rad, is one of it.
const CLOSE: f64 = 0.02;

/// Halvings from a degree to rounding.
const HALVINGS: usize = 50;

impl Turns {
    /// The curves of a machine with two free positions, as lean and steer, that none of some known ones goes through, to the
    /// side to which the last free position is positive; none for other machines.
    ///
    /// At given positions the accelerations are a part without speed and one that grows with its square, so in a turn the
    /// two are opposite to each other. Such leans are looked for at steers from 5 to 175 degrees; curves that stay between two
    /// of these are not found.
    ///
    /// # Errors
    /// If the machine does not run on wheels.
    pub fn others(machine: &dyn Machine, known: &[Self]) -> Result<Vec<Self>, TurnsError> {
        let balance = Balance::new(machine)?;
        if balance.free.len() != 2 {
            return Ok(Vec::new());
        }
        let free = balance.free.clone();
        let steers = STEERS.map(f64::to_radians).into_iter();
        let starts = steers.flat_map(|steer| leans(&balance, steer).into_iter().map(move |start| (steer, start)));
        let starts: Vec<([f64; 2], f64)> =
            starts.map(|(steer, (lean, square))| ([lean, steer], square.sqrt())).collect();
        let units = units(&balance, &starts);
        let mut found: Vec<Self> = Vec::new();
        for (point, speed) in starts {
            let is_known = |turns: &Self| is_close(&turns.turns, &free, point);
            if !known.iter().chain(&found).any(is_known) {
                found.extend(through(machine, point, speed, units));
            }
        }
        Ok(found)
    }
}

/// What speeds and yaw rates are measured by: the medians of those of some turns. One turn itself may be next to a standstill, beside
/// which every speed is large.
fn units(balance: &Balance, turns: &[([f64; 2], f64)]) -> [f64; 2] {
    let yaw_rates = turns.iter().filter_map(|(point, speed)| yaw_rate(balance, *point, *speed)).map(f64::abs);
    let middle = |mut sizes: Vec<f64>| {
        sizes.sort_by(f64::total_cmp);
        sizes.get(sizes.len() / 2).copied().filter(|size| *size > 0.0).unwrap_or(1.0)
    };
    [middle(turns.iter().map(|turn| turn.1).collect()), middle(yaw_rates.collect())]
}

/// The yaw rate at free positions and a speed; `None` for what has no yaw.
fn yaw_rate(balance: &Balance, free: [f64; 2], speed: f64) -> Option<f64> {
    let yaw = balance.machine.info().position("psi")?;
    let at = balance.at(&free, speed).ok()?;
    balance.rates(&at).ok().map(|rates| rates[yaw]).filter(|rate| rate.is_finite())
}

/// The leans, each with the square of its speed, at which a steer is in balance.
fn leans(balance: &Balance, steer: f64) -> Vec<(f64, f64)> {
    let at = |degrees: f64| imbalance(balance, [degrees.to_radians(), steer]).ok().filter(|found| found.0.is_finite());
    let mut found = Vec::new();
    let mut last: Option<(f64, (f64, f64))> = None;
    for degrees in LEANS.map(f64::from) {
        let here = at(degrees);
        if let (Some((from, before)), Some(after)) = (last, here)
            && before.0 * after.0 < 0.0
        {
            let (mut from, mut to) = (from, degrees);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (from + to);
                match at(middle) {
                    Some(value) if value.0 * before.0 > 0.0 => from = middle,
                    _ => to = middle,
                }
            }
            // Where the sign changes at a pole there is no turn, and none at an imaginary speed.
            if let Some((_, square)) = at(to).filter(|(rest, square)| rest.abs() < 1e-6 && *square > 0.0) {
                found.push((to.to_radians(), square));
            }
        }
        last = here.map(|here| (degrees, here));
    }
    found
}

/// The sine of the angle between the accelerations at rest and what a speed adds to them, and the square of the speed at which
/// they are as large: in a turn the first is zero and the second positive.
fn imbalance(balance: &Balance, free: [f64; 2]) -> Result<(f64, f64), MotionError> {
    let still = balance.accelerations(&free, 0.0)?;
    let rolling = balance.accelerations(&free, 1.0)?;
    let added = [rolling[0] - still[0], rolling[1] - still[1]];
    let sizes = still[0].hypot(still[1]) * added[0].hypot(added[1]);
    let square = -(still[0] * added[0] + still[1] * added[1]) / (added[0] * added[0] + added[1] * added[1]);
    Ok(((still[0] * added[1] - still[1] * added[0]) / sizes, square))
}

/// Whether a point is on a curve or on its mirror image.
fn is_close(turns: &[Turn], free: &[usize], point: [f64; 2]) -> bool {
    let of = |turn: &Turn| [turn.positions[free[0]], turn.positions[free[1]]];
    turns.windows(2).any(|pair| {
        let [from, to] = [of(&pair[0]), of(&pair[1])];
        [1.0, -1.0].into_iter().any(|sign| {
            let [x, y] = [sign * point[0] - from[0], sign * point[1] - from[1]];
            let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
            let share = ((x * dx + y * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
            (x - share * dx).hypot(y - share * dy) < CLOSE
        })
    })
}

/// The curve through a turn, to both sides: by speeds, or by yaw rates if that goes further. Where a machine pivots about a wheel that
/// does not roll it has a yaw rate and no speed, so that by speeds it comes there in ever smaller steps, and never beyond.
fn through(machine: &dyn Machine, free: [f64; 2], speed: f64, [of_speed, of_yaw]: [f64; 2]) -> Option<Turns> {
    let by_speed = Balance::new(machine).ok()?;
    let yaw_rate = yaw_rate(&by_speed, free, speed).filter(|rate| *rate != 0.0);
    let curve = both_ways(Curve { balance: by_speed, unit: of_speed }, free, speed / of_speed, false);
    let lost = |turns: &Turns| [turns.begin, turns.end].iter().filter(|end| matches!(end, TurnsEnd::Lost(_))).count();
    if curve.as_ref().is_some_and(|curve| lost(curve) == 0) {
        return curve;
    }
    let Some(rate) = yaw_rate else { return curve };
    let by_yaw = Curve { balance: Balance::new(machine).ok()?.by_yaw()?, unit: of_yaw.copysign(rate) };
    let other = both_ways(by_yaw, free, rate.abs() / of_yaw, true);
    match (curve, other) {
        (Some(curve), Some(other)) => {
            let further =
                lost(&other) < lost(&curve) || lost(&other) == lost(&curve) && length(&other) > length(&curve);
            Some(if further { other } else { curve })
        }
        (curve, other) => curve.or(other),
    }
}

/// How far positions change along a curve, in rad.
fn length(turns: &Turns) -> f64 {
    let steps = turns.turns.windows(2).map(|pair| {
        let moved = pair[0].positions.iter().zip(&pair[1].positions).map(|(from, to)| (to - from) * (to - from));
        moved.sum::<f64>().sqrt()
    });
    steps.sum()
}

fn both_ways(curve: Curve, free: [f64; 2], share: f64, by_yaw: bool) -> Option<Turns> {
    let guess = DVector::from_vec(vec![free[0], free[1], share]);
    let condition = Condition { factors: unit_vector(3, 1), value: free[1] };
    let (point, _) = curve.correct(guess, &condition).ok().flatten()?;
    let turn = curve.turn(&point).ok()?;
    // Toward less steer first.
    let tangent = curve.tangent(&point, &-unit_vector(3, 1)).ok()?;
    let (mut turns, begin) = curve.follow(point.clone(), tangent.clone());
    turns.reverse();
    turns.push(turn);
    let (others, end) = curve.follow(point, -tangent);
    turns.extend(others);
    Some(Turns { begin, turns, end, by_yaw })
}
