//! What a motion begins with, what acts on it and what follows from it, beyond what can be computed with.

use carvallo_design::number::{self, shortest};
use carvallo_design::{Failure, Place, Problem};
use carvallo_plot::analysis::simulation::{Given, Motion, Row, Solver};

/// Squares and products of what is larger leave the range of doubles.
const LARGEST: f64 = 1e100;

/// Forces are only divided by masses.
const LARGEST_FORCE: f64 = 1e300;

/// A thousandth of the largest double, for units that are smaller than those of the SI.
const LARGEST_TOLD: f64 = f64::MAX / 1e3;

/// Angles that are larger, 2^53 rad, are not known to a radian.
const LARGEST_ANGLE: f64 = 9_007_199_254_740_992.0;

/// The motion as far as all that follows from it, such as accelerations and the forces of laws, can be told in any unit.
///
/// # Errors
/// If that is not at all.
pub fn within_range(mut motion: Motion) -> Result<Motion, Failure> {
    let is_within = |row: &Row| {
        let vectors = [&row.positions, &row.rates, &row.accelerations, &row.feedback].into_iter().flatten();
        let mut all = vectors.chain(row.energy.iter().flatten()).chain(row.contact_forces.iter().flatten());
        all.all(|number| number.abs() <= LARGEST_TOLD)
    };
    let Some(beyond) = motion.rows.iter().position(|row| !is_within(row)) else { return Ok(motion) };
    let time = shortest(motion.rows[beyond].t);
    if beyond == 0 {
        let message = format!("forces or accelerations at {time} s leave the range of floating-point numbers");
        return Err(Failure::Run(message));
    }
    motion.rows.truncate(beyond);
    let end = format!("the motion ends before {time} s: it then leaves the range of floating-point numbers");
    motion.end.get_or_insert(end);
    Ok(motion)
}

/// Everything that is too large: positions and rates at the beginning, the speed, and forces at the times of a motion. An angle
/// `is_turned` by where equations have its sine and cosine.
pub fn problems(
    solver: &dyn Solver,
    given: &Given,
    speed: Option<f64>,
    times: &[f64],
    is_turned: bool,
) -> Vec<Problem> {
    let mut problems = Vec::new();
    let mut require = |option: String, what: &str, [value, most]: [f64; 2], unit: &str, why: &str| {
        if value.abs() > most {
            let [value, most] = [value, most].map(shortest);
            let message =
                format!("the {what} is {value} {}; it must be at most {most} in size, {why}", number::unit(unit));
            problems.push(Problem { place: Place::Option(option), message });
        }
    };
    let range = "or what is computed of it leaves the range of floating-point numbers";
    let initial = &given.initial;
    for (givable, (position, rate)) in solver.givable().iter().zip(initial.positions.iter().zip(&initial.rates)) {
        let quantity = &givable.quantity;
        let (name, label) = (quantity.name, quantity.label);
        let option = format!("--initial {name}={}", shortest(*position));
        if is_turned && quantity.unit == "rad" {
            let why = "beyond which floating-point numbers tell no angle";
            require(option, label, [*position, LARGEST_ANGLE], quantity.unit, why);
        } else {
            require(option, label, [*position, LARGEST], quantity.unit, range);
        }
        let option = format!("--initial {name}_rate={}", shortest(*rate));
        require(option, &format!("rate of {label}"), [*rate, LARGEST], &quantity.unit_per_time(1), range);
    }
    let speed = speed.unwrap_or(0.0);
    require(format!("--speed {}", shortest(speed)), "speed", [speed, LARGEST], "m/s", range);
    for (channel, force) in solver.channels().iter().zip(&given.forces) {
        let larger = |most: f64, own: f64| if own.abs() > most.abs() { own } else { most };
        let largest = times.iter().map(|time| force.at(*time)).fold(0.0, larger);
        let name = &channel.names[0];
        require(
            format!("--force {name}={}", shortest(largest)),
            "force",
            [largest, LARGEST_FORCE],
            channel.unit,
            range,
        );
    }
    problems
}
