//! The nonlinear equations of motion, integrated.

use std::cell::Cell;
use std::ops::ControlFlow;

use super::chart::Chart;
use super::crossing::Crossing;
use super::error::{SimulationError, require_ascending, require_length};
use super::force::{Force, pieces};
use super::integration::{Piece, integrate};
use super::machine::Machine;
use super::state::State;
use crate::motion::{Energy, MotionError};

/// A simulation of a [`Machine`]: its forces, what controls it, and when it ends.
///
/// The equations are integrated by the method of Dormand and Prince of order 8 with steps of their own, and between steps by
/// its polynomials of order 7, so that what is told is as accurate wherever it is asked for. Integrated are all positions and
/// the free speeds; where these come to determine the other rates no more, as those of a bicycle do whose front wheel is
/// steered by a right angle, rates that do take their place for a while. So the conditions of rolling hold by themselves, to
/// rounding: the other rates are computed from these. The positions that the heights of the wheels determine are made to do so after every step and wherever the motion
/// is told; [`Ride::drift`] is by how much they had to be moved.
///
/// The [guide](crate::guide::motions) has examples, with a controller.
pub struct Simulation<'a> {
    machine: &'a dyn Machine,
    tolerance: f64,
    forces: Vec<Force>,
    control: Option<Box<Control<'a>>>,
    events: Vec<Event<'a>>,
    observe: Option<Box<dyn Fn(f64) -> ControlFlow<()> + 'a>>,
}

/// Adds to the forces what a controller does at a moment.
type Control<'a> = dyn Fn(&Moment, &mut [f64]) + 'a;

/// What a controller and an event see.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a> {
    /// The time in s.
    pub time: f64,
    /// All positions.
    pub positions: &'a [f64],
    /// The rates of all of them.
    pub rates: &'a [f64],
}

/// When something happens: where a function of the motion changes its sign.
pub(super) struct Event<'a> {
    pub(super) name: &'a str,
    pub(super) crossing: Crossing,
    /// The simulation ends when it has happened so often.
    pub(super) ends: Option<usize>,
    function: Box<dyn Fn(&Moment) -> f64 + 'a>,
}

/// A motion as it was simulated.
#[derive(Clone, Debug, PartialEq)]
pub struct Ride {
    /// The motion at the times that were asked for, as far as it went; behind them at the time at which it ended early.
    pub rows: Vec<RideRow>,
    /// How it ended.
    pub end: End,
    /// What happened, in its order.
    pub events: Vec<Happening>,
    /// The most that a position was moved after a step so that every wheel touches the ground, in its unit.
    pub drift: f64,
    /// How often the equations were evaluated.
    pub evaluations: u64,
}

/// An event that happened.
#[derive(Clone, Debug, PartialEq)]
pub struct Happening {
    /// The name that was given.
    pub name: String,
    /// When, and the motion there.
    pub row: RideRow,
}

/// The motion of a machine at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct RideRow {
    /// The time in s.
    pub time: f64,
    /// All positions, in the order of [`MotionInfo`](crate::motion::MotionInfo).
    pub positions: Vec<f64>,
    /// Their rates.
    pub rates: Vec<f64>,
    /// Their second derivatives; where a force jumps, those behind the jump.
    pub accelerations: Vec<f64>,
    /// The applied forces, with those of the controller.
    pub forces: Vec<f64>,
    /// Of motion, and of gravity and springs.
    pub energy: Energy,
    /// For each wheel the force of the ground on it, along the axes of the ground.
    pub contact_forces: Vec<[f64; 3]>,
}

/// How a motion ended.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum End {
    /// The last of the times was reached.
    Reached,
    /// What it was to be simulated until happened.
    Event {
        /// The name that was given.
        name: String,
        /// When, in s.
        time: f64,
    },
    /// The equations have no value beyond a time, as where a wheel comes to lie flat.
    Singular {
        /// The last time that was reached, in s.
        time: f64,
        /// What has no value.
        error: MotionError,
    },
    /// The motion hardly goes on: it takes ever smaller steps.
    Stalled {
        /// The last time that was reached, in s.
        time: f64,
        /// After how many steps since the start, or since a force had a knot.
        steps: usize,
    },
    /// Whoever [observed](Simulation::observed_by) it broke it off.
    Interrupted {
        /// The last time that was reached, in s.
        time: f64,
    },
}

impl<'a> Simulation<'a> {
    /// Of a machine on which no forces act but those of gravity, of the ground, and of its own springs and dampers.
    #[must_use]
    pub fn new(machine: &'a dyn Machine) -> Self {
        let forces = vec![Force::constant(0.0); machine.info().forces.len()];
        Self { machine, tolerance: 1e-12, forces, control: None, events: Vec::new(), observe: None }
    }

    /// How much each step may err in each position and speed, relative to its size or, where it is less than 1, absolutely:
    /// 1e-12 unless another one is given; no less than 1e-14 is taken.
    #[must_use]
    pub fn tolerance(self, tolerance: f64) -> Self {
        Self { tolerance: tolerance.max(1e-14), ..self }
    }

    /// Applies a force, by the name that it has in the declaration.
    ///
    /// # Errors
    /// If there is no such force.
    pub fn force(mut self, name: &str, force: Force) -> Result<Self, SimulationError> {
        let place = self.machine.info().force(name);
        let unknown = || SimulationError::Unknown { what: "force", name: name.to_owned() };
        self.forces[place.ok_or_else(unknown)?] = force;
        Ok(self)
    }

    /// Lets a controller add to the forces at every moment. It must be a smooth function of what it sees; one that decides
    /// at certain times is simulated from one of them to the next.
    #[must_use]
    pub fn controlled_by(self, control: impl Fn(&Moment, &mut [f64]) + 'a) -> Self {
        Self { control: Some(Box::new(control)), ..self }
    }

    /// Ends the simulation where a function of the motion changes its sign.
    #[must_use]
    pub fn until(self, name: &'a str, function: impl Fn(&Moment) -> f64 + 'a) -> Self {
        self.watching(name, Crossing::Any, Some(1), function)
    }

    /// Tells where a function of the motion changes its sign.
    #[must_use]
    pub fn noting(self, name: &'a str, function: impl Fn(&Moment) -> f64 + 'a) -> Self {
        self.watching(name, Crossing::Any, None, function)
    }

    /// Tells where a function of the motion changes its sign in some direction, and ends the simulation when it has done so a
    /// number of times, if there is one. A function that is zero at the beginning does not change its sign there.
    #[must_use]
    pub fn watching(
        mut self,
        name: &'a str,
        crossing: Crossing,
        ends: Option<usize>,
        function: impl Fn(&Moment) -> f64 + 'a,
    ) -> Self {
        self.events.push(Event { name, crossing, ends, function: Box::new(function) });
        self
    }

    /// Calls a function with the time that is reached, after every step; the motion ends there where it breaks.
    #[must_use]
    pub fn observed_by(self, observe: impl Fn(f64) -> ControlFlow<()> + 'a) -> Self {
        Self { observe: Some(Box::new(observe)), ..self }
    }

    /// The motion at times in s that ascend, of which the first is that of the state.
    ///
    /// # Errors
    /// If there are too many or too few numbers, if the times do not ascend, or if the equations have no value in the state.
    pub fn run(&self, start: &State, times: &[f64]) -> Result<Ride, SimulationError> {
        let info = self.machine.info();
        require_length("initial positions", info.positions.len(), start.positions.len())?;
        require_length("initial speeds", info.speeds.len(), start.speeds.len())?;
        require_ascending(times)?;
        let mut ride = Ride { rows: Vec::new(), end: End::Reached, events: Vec::new(), drift: 0.0, evaluations: 0 };
        let (Some(&first), Some(&last)) = (times.first(), times.last()) else { return Ok(ride) };
        let mut state = [start.positions.as_slice(), &start.speeds].concat();
        let row = self.row(first, &state).map_err(|error| SimulationError::Motion { time: first, error })?;
        let repeated = times.partition_point(|time| *time == first);
        ride.rows.resize(repeated, row);
        let mut from = first;
        let evaluations = Cell::new(0);
        for to in pieces(&self.forces, first, last) {
            let lines: Vec<(f64, f64)> = self.forces.iter().map(|force| force.line_from(from)).collect();
            let derivative = |chart: &Chart, time: f64, state: &[f64], rates: &mut [f64]| {
                evaluations.set(evaluations.get() + 1);
                let forces = lines.iter().map(|(force, slope)| force + (time - from) * slope).collect();
                self.derivative(chart, time, state, forces, rates)
            };
            let next = ride.rows.len();
            let asked = &times[next..times.partition_point(|time| *time <= to)];
            let piece = Piece { simulation: self, from, to, asked, derivative: &derivative };
            let goes_on = integrate(piece, &mut state, &mut ride)?;
            if !goes_on {
                break;
            }
            from = to;
        }
        ride.evaluations = evaluations.get();
        Ok(ride)
    }

    /// The derivatives of positions and of what is integrated beside them, under given forces and those of the controller.
    fn derivative(
        &self,
        chart: &Chart,
        time: f64,
        state: &[f64],
        mut forces: Vec<f64>,
        derivatives: &mut [f64],
    ) -> Result<(), MotionError> {
        let (positions, chosen) = self.split(state);
        let (rates, of_chosen) = derivatives.split_at_mut(positions.len());
        let is_of_speeds = chart.is_of_speeds(self.machine);
        let others = if is_of_speeds { Vec::new() } else { chart.speeds(self.machine, positions, chosen)? };
        let speeds = if is_of_speeds { chosen } else { &others };
        if self.control.is_some() || !is_of_speeds {
            self.machine.rates(positions, speeds, rates)?;
        }
        if let Some(control) = &self.control {
            control(&Moment { time, positions, rates }, &mut forces);
        }
        if is_of_speeds {
            return self.machine.derivatives(positions, speeds, &forces, rates, of_chosen);
        }
        let mut accelerations = vec![0.0; positions.len()];
        self.machine.accelerations(positions, speeds, &forces, &mut accelerations)?;
        of_chosen.iter_mut().zip(chart.choose(&accelerations)).for_each(|(to, from)| *to = from);
        Ok(())
    }

    /// What there is to tell of a state.
    pub(super) fn row(&self, time: f64, state: &[f64]) -> Result<RideRow, MotionError> {
        let (positions, speeds) = self.split(state);
        let mut row = RideRow {
            time,
            positions: positions.to_vec(),
            rates: vec![0.0; positions.len()],
            accelerations: vec![0.0; positions.len()],
            forces: self.forces.iter().map(|force| force.at(time)).collect(),
            energy: self.machine.energy(positions, speeds)?,
            contact_forces: Vec::new(),
        };
        self.machine.rates(positions, speeds, &mut row.rates)?;
        if let Some(control) = &self.control {
            control(&Moment { time, positions, rates: &row.rates }, &mut row.forces);
        }
        self.machine.accelerations(positions, speeds, &row.forces, &mut row.accelerations)?;
        row.contact_forces = self.machine.contact_forces(positions, speeds, &row.forces)?;
        Ok(row)
    }

    /// Moves positions so that every wheel touches the ground; by how much at most.
    pub(super) fn close(&self, state: &mut [f64]) -> Result<f64, MotionError> {
        let info = self.machine.info();
        if info.dependent.is_empty() {
            return Ok(0.0);
        }
        let positions = &mut state[..info.positions.len()];
        let before = positions.to_vec();
        self.machine.close(positions)?;
        Ok(info.dependent.iter().map(|&place| (positions[place] - before[place]).abs()).fold(0.0, f64::max))
    }

    /// The functions whose signs tell events, in their order.
    pub(super) fn event_functions(&self, time: f64, state: &[f64]) -> Result<Vec<f64>, MotionError> {
        if self.events.is_empty() {
            return Ok(Vec::new());
        }
        let (positions, speeds) = self.split(state);
        let mut rates = vec![0.0; positions.len()];
        self.machine.rates(positions, speeds, &mut rates)?;
        let moment = Moment { time, positions, rates: &rates };
        Ok(self.events.iter().map(|event| (event.function)(&moment)).collect())
    }

    /// One of the events.
    pub(super) fn watched(&self, event: usize) -> &Event<'a> {
        &self.events[event]
    }

    /// Positions, and what stands behind them.
    pub(super) fn split<'s>(&self, state: &'s [f64]) -> (&'s [f64], &'s [f64]) {
        state.split_at(self.machine.info().positions.len())
    }

    pub(super) fn machine(&self) -> &dyn Machine {
        self.machine
    }

    pub(super) fn allowed_error(&self) -> f64 {
        self.tolerance
    }

    pub(super) fn observe(&self, time: f64) -> ControlFlow<()> {
        self.observe.as_ref().map_or(ControlFlow::Continue(()), |observe| observe(time))
    }
}
