//! The motion of the nonlinear equations.

use std::fmt::Display;
use std::ops::ControlFlow;

use carvallo::motion::{MotionInfo, PositionKind};
use carvallo::simulation::{Drive, End, Happening, Machine, Moment, Ride, RideRow, Simulation, State};
use carvallo::sort_by;
use carvallo_design::number::shortest;
use carvallo_design::{Design, Failure};

use super::force::Channel;
use super::initial::Givable;
use super::linear::OF_SPEED;
use super::motion::{Motion, Quantity, Row, fed_back, order, time};
use super::solver::{Given, Solver};
use super::watch::{Happened, Watch};
use crate::analysis::OUT_OF_RANGE;

/// A machine whose lean has a cosine below this lies on the ground.
const FLAT: f64 = 1e-6;

/// A force that would hold a wheel down, in N; less is rounding.
const HOLDS: f64 = 1e-6;

const FALL: Ending =
    Ending { name: "it falls: it leans", position: "phi", degrees: 80.0, beyond: "beyond a fall: it leans" };
const TURN: Ending = Ending {
    name: "its front turns around: it is steered",
    position: "delta",
    degrees: 180.0,
    beyond: "with its front turned around: it is steered",
};
const STOP: &str = "stop";
/// Before the place of what is watched for.
const WATCHED: &str = "watched ";

/// More stops than these are told by their number.
const MOST_STOPS: usize = 3;
/// Accelerations beyond this are those of forces in other units than were meant.
const ENORMOUS: f64 = 1e9;
/// And what is computed of these in a step leaves the range of doubles.
const OVERFLOWING: f64 = 1e100;

/// A position that ends a motion.
struct Ending {
    /// What happens, as the beginning of a sentence that goes on with the degrees.
    name: &'static str,
    position: &'static str,
    degrees: f64,
    /// How a motion begins that is beyond it, likewise.
    beyond: &'static str,
}

/// The nonlinear equations of a design, with what may be given of their motion.
pub struct Nonlinear<'a> {
    machine: &'a dyn Machine,
    givable: Vec<Givable>,
    channels: Vec<Channel>,
    drive: Option<Drive>,
    tolerance: Option<f64>,
}

impl<'a> Nonlinear<'a> {
    /// The nonlinear equations of a machine.
    pub fn new(machine: &'a dyn Machine) -> Self {
        let info = machine.info();
        let drive = Drive::of(machine);
        let givable = info.positions.iter().enumerate().map(|(place, position)| Givable {
            quantity: Quantity::new(position.name, position.label, position.unit),
            position: match position.kind {
                PositionKind::Dependent => Err("it follows, since every wheel is on the ground"),
                PositionKind::Free | PositionKind::Ignorable => Ok(()),
            },
            rate: match (drive, info.speed_of(place)) {
                (Some(drive), _) if drive.position() == place => Err(OF_SPEED),
                (_, Some(_)) => Ok(()),
                (_, None) => Err("it follows, since wheels roll"),
            },
        });
        let channels = info.forces.iter().map(|force| {
            let short = force.name.strip_prefix(['T', 'F']).filter(|short| !short.is_empty());
            let position = info.positions.iter().find(|position| position.name == force.position);
            let own = [Some(force.name), short, Some(force.label), Some(force.position)];
            let names = own.into_iter().chain([position.map(|position| position.label)]).flatten();
            // As the linear equations have it on a coordinate.
            let on_coordinate = ["T", "F"].map(|letter| format!("{letter}{}", force.position));
            Channel { names: names.map(str::to_owned).chain(on_coordinate).collect(), unit: force.unit }
        });
        Self { machine, givable: givable.collect(), channels: channels.collect(), drive, tolerance: None }
    }

    /// Solved with another [tolerance](Simulation::tolerance) than that of a simulation.
    #[must_use]
    pub fn tolerance(self, tolerance: f64) -> Self {
        Self { tolerance: Some(tolerance), ..self }
    }

    fn state(&self, given: &Given, speed: f64) -> Result<State, String> {
        let names = || self.machine.info().positions.iter().map(|position| position.name);
        let positions: Vec<(&str, f64)> = names().zip(given.initial.positions.iter().copied()).collect();
        let mut rates = given.initial.rates.clone();
        if let Some(drive) = self.drive {
            rates[drive.position()] = drive.rate(speed);
        }
        let free = |place: &usize| self.machine.info().speed_of(*place).is_some();
        let rates: Vec<(&str, f64)> =
            names().zip(rates).enumerate().filter(|(place, _)| free(place)).map(|(_, rate)| rate).collect();
        State::new(self.machine, &positions, &rates).map_err(|error| error.to_string())
    }
}

impl Solver for Nonlinear<'_> {
    fn givable(&self) -> &[Givable] {
        &self.givable
    }

    fn channels(&self) -> &[Channel] {
        &self.channels
    }

    fn takes_speed(&self, _: &Design) -> bool {
        self.drive.is_some()
    }

    fn run<'a>(
        &self,
        design: &'a Design,
        given: &Given,
        speed: f64,
        times: &[f64],
        reach: &dyn Fn(f64) -> ControlFlow<()>,
    ) -> Result<Motion<'a>, Failure> {
        let fail = |message: String| Failure::Run(format!("{}: {message}", design.title()));
        let info = self.machine.info();
        let lean = info.position("phi").filter(|_| !info.wheels.is_empty()).map(|place| given.initial.positions[place]);
        if let Some(lean) = lean.filter(|lean| lean.cos().abs() < FLAT) {
            let degrees = shortest(lean.to_degrees().round());
            return Err(fail(format!(
                "it lies flat on the ground at a lean of {degrees} degrees, where no wheel can roll"
            )));
        }
        let start = self.state(given, speed).map_err(fail)?;
        let mut notes = given.initial.doubts.clone();
        let names: Vec<String> = (0..given.watches.len())
            .filter(|_| cfg!(feature = "events"))
            .map(|place| format!("{WATCHED}{place}"))
            .collect();
        let mut simulation = Simulation::new(self.machine);
        if let Some(tolerance) = self.tolerance {
            simulation = simulation.tolerance(tolerance);
        }
        for (force, given) in info.forces.iter().zip(&given.forces) {
            simulation = simulation.force(force.name, given.clone()).map_err(|error| fail(error.to_string()))?;
        }
        for Ending { name, position, degrees, beyond } in [FALL, TURN] {
            let limit = degrees.to_radians();
            let Some(place) = info.position(position) else { continue };
            let begins = start.positions[place];
            if begins.abs() < limit {
                simulation = simulation.until(name, move |moment: &Moment| limit - moment.positions[place].abs());
            } else if times.len() > 1 {
                let begins = shortest((begins.to_degrees().abs() * 1e6).round() / 1e6);
                notes.push(format!(
                    "it begins {beyond} by {begins} degrees; a motion ends at {degrees}, and this one is told as if nothing but \
                     the wheels touched the ground"
                ));
            }
        }
        if let Some(drive) = self.drive {
            simulation = simulation.noting(STOP, move |moment: &Moment| drive.speed(moment.rates));
        }
        if cfg!(feature = "events") {
            for (name, watch) in names.iter().zip(&given.watches) {
                simulation = simulation.watching(name, watch.crossing, watch.ends, &watch.function);
            }
        }
        let simulation = simulation.observed_by(reach);
        let ride = simulation.run(&start, times).map_err(|error| fail(error.to_string()))?;
        Ok(told(design, info, self.drive, ride, &given.watches, notes))
    }
}

/// The place of what is watched for, by its name in the simulation.
fn watched(name: &str) -> Option<usize> {
    name.strip_prefix(WATCHED)?.parse().ok()
}

/// The motion as it is told.
fn told<'a>(
    design: &'a Design,
    info: &MotionInfo,
    drive: Option<Drive>,
    ride: Ride,
    watches: &[Watch],
    mut notes: Vec<String>,
) -> Motion<'a> {
    let quantities: Vec<Quantity> =
        info.positions.iter().map(|position| Quantity::new(position.name, position.label, position.unit)).collect();
    let order = order(&quantities);
    let arranged = |values: &[f64]| order.iter().map(|&place| values[place]).collect();
    let most = ride.rows.last().map_or(0.0, |row| row.accelerations.iter().fold(0.0_f64, |most, a| most.max(a.abs())));
    let enormous =
        if most > ENORMOUS { format!("; accelerations are up to {most:.1e}: see the forces") } else { String::new() };
    let end = match &ride.end {
        End::Event { time: end, name } => {
            let degrees = if name == FALL.name { FALL.degrees } else { TURN.degrees };
            let watched = watched(name).filter(|_| cfg!(feature = "events")).map(|place| watches[place].end());
            let what = watched.unwrap_or_else(|| format!("{name} by {degrees} degrees"));
            Some(format!("the motion ends at {} s: {what}", time(*end)))
        }
        End::Singular { time: end, error } => {
            let error: &dyn Display = if most > OVERFLOWING { &OUT_OF_RANGE } else { error };
            Some(format!("the motion ends at {} s: {error}{enormous}", time(*end)))
        }
        End::Stalled { time: end, steps } => {
            let hint = "what moves so fast takes steps as short; linear equations need none (--linear)";
            Some(format!(
                "the motion ends at {} s: it hardly goes on, after {steps} steps; {hint}{enormous}",
                time(*end)
            ))
        }
        End::Interrupted { time: end } => Some(format!("the motion ends at {} s: it was interrupted", time(*end))),
        _ => None,
    };
    let stops: Vec<f64> = ride.events.iter().filter(|event| event.name == STOP).map(|event| event.row.time).collect();
    // By their times.
    let mut happened: Vec<(f64, String)> = Vec::new();
    let stop = |stop: &f64| (*stop, format!("at {} s it stops, and turns back", time(*stop)));
    happened.extend(stops.iter().take(MOST_STOPS).map(stop));
    if let Some(last) = stops.get(MOST_STOPS..).and_then(<[f64]>::last) {
        let more = stops.len() - MOST_STOPS;
        happened.push((*last, format!("it stops {more} times more, the last time at {} s", time(*last))));
    }
    for (place, wheel) in info.wheels.iter().enumerate() {
        // z is downward: what would hold the wheel down.
        // Where the equations end, forces may be anything.
        let is_end = |row: &RideRow| matches!(ride.end, End::Singular { time, .. } if row.time >= time);
        let mut rows = ride.rows.iter().filter(|row| !is_end(row));
        let pulled = rows.find(|row| row.contact_forces.get(place).is_some_and(|force| force[2] > HOLDS));
        if let Some(row) = pulled {
            let (name, at) = (wheel.label, time(row.time));
            let lifts = format!("at {at} s the ground would have to hold the {name} down: a real one would lift off");
            happened.push((row.time, lifts));
        }
    }
    sort_by(&mut happened, |a, b| a.0.total_cmp(&b.0));
    notes.extend(happened.into_iter().map(|(_, note)| note));
    let forward = |row: &RideRow| drive.map_or(0.0, |drive| drive.speed(&row.rates));
    let told = |row: RideRow| Row {
        t: row.time,
        feedback: fed_back(design, forward(&row), &quantities, &row.positions, &row.rates),
        positions: arranged(&row.positions),
        rates: arranged(&row.rates),
        accelerations: arranged(&row.accelerations),
        energy: Some([row.energy.kinetic, row.energy.potential]),
        contact_forces: row.contact_forces,
    };
    let mut events = Vec::new();
    if cfg!(feature = "events") {
        let happened = |event: Happening| Some(Happened { watch: watched(&event.name)?, row: told(event.row) });
        events.extend(ride.events.into_iter().filter_map(happened));
    }
    Motion {
        design,
        is_linear: false,
        quantities: order.iter().map(|&place| quantities[place]).collect(),
        wheels: info.wheels.iter().map(|wheel| wheel.name).collect(),
        events,
        rows: ride.rows.into_iter().map(told).collect(),
        end,
        notes,
    }
}
