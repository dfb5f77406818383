//! One piece of a motion, in which forces are smooth: steps, what is told between them, and events.
//!
//! The steps are those of the crate `ivp`, a port of Hairer's DOP853. Of the crates that were tried on a Kepler orbit at
//! tolerances of 1e-8 to 1e-13, its dense output is as accurate as its steps and it is the fastest: 0.23 ms for 285 steps, with
//! 1.6e-7 at both. `differential-equations` has the same steps, but 9.5e-7 between them, in 8 ms; `ode_solvers` brings a
//! second nalgebra, and `diffsol` 116 crates and methods of order 5 at most.

use std::cell::RefCell;

use ivp::dense::StepInterpolant;
use ivp::ivp::FirstOrderSystem;
use ivp::methods::{DOP853, Tolerance};
use ivp::solout::{ControlFlag, SolOut};
use ivp::status::Status;

use super::chart::Chart;
use super::error::SimulationError;
use super::events::happened;
use super::nonlinear::{End, Happening, Ride, Simulation};
use crate::motion::MotionError;

/// More steps than these, and those of each second that was reached in a piece, are taken for a motion that does not go on. A
/// bicycle takes a hundred in a second.
const MOST_STEPS: f64 = 100_000.0;
const MOST_PER_SECOND: f64 = 10_000.0;

/// Steps that become so much shorter in a chart are those of rounding in it.
const SHORTENED: f64 = 0.01;
/// More than this no step may err.
const ROUGHEST: f64 = 1e-9;

/// A part of a motion between two times.
pub(super) struct Piece<'a> {
    pub simulation: &'a Simulation<'a>,
    pub from: f64,
    pub to: f64,
    /// The times behind the first that are asked for.
    pub asked: &'a [f64],
    pub derivative: &'a Derivative<'a>,
}

/// The derivative, at a time, of positions and of the rates that a chart chooses.
pub(super) type Derivative<'a> = dyn Fn(&Chart, f64, &[f64], &mut [f64]) -> Result<(), MotionError> + 'a;

/// Takes the state to the end of a piece, and adds to the ride what is asked for; whether the ride goes on.
///
/// # Errors
/// If the equations have no value at the beginning.
pub(super) fn integrate(piece: Piece, state: &mut Vec<f64>, ride: &mut Ride) -> Result<bool, SimulationError> {
    if piece.to <= piece.from {
        return Ok(true);
    }
    let (simulation, from, to) = (piece.simulation, piece.from, piece.to);
    let at_start = |error| SimulationError::Motion { time: from, error };
    let values = simulation.event_functions(from, state).map_err(at_start)?;
    let own = Chart::of_speeds(simulation.machine());
    let chart = own.renewed(simulation.machine(), simulation.split(state).0).map_err(at_start)?.unwrap_or(own);
    let reason = RefCell::new(None);
    let mut steps = Steps {
        piece: &piece,
        chart,
        renewed: None,
        reason: &reason,
        next: 0,
        reached: from,
        state,
        values,
        ride,
        taken: 0,
        longest: 0.0,
        tolerance: simulation.allowed_error(),
        end: None,
    };
    let end = loop {
        let equations = Equations { derivative: piece.derivative, chart: steps.chart.clone(), error: &reason };
        let begin = steps.integrated().map_err(at_start)?;
        // What is stiff is integrated as well, if in small steps; how many they are is the matter of `Steps`.
        let method = DOP853::builder().max_steps(usize::MAX).stiff_test(usize::MAX).build();
        let tolerance = Tolerance::Scalar(steps.tolerance);
        let done = method.solve(&equations, steps.reached, &begin, to, tolerance.clone(), tolerance, Some(&mut steps));
        break match done.map(|done| done.status) {
            Ok(Status::Success) => return Ok(true),
            Ok(Status::UserInterrupt) => {
                if let Some((chart, tolerance)) = steps.renewed.take() {
                    (steps.chart, steps.tolerance, steps.longest) = (chart, tolerance, 0.0);
                    continue;
                }
                steps.end.take().unwrap_or(End::Reached)
            }
            Ok(Status::StepSizeTooSmall) => {
                let error = reason.take().unwrap_or(MotionError::Singular { quantity: "the motion" });
                End::Singular { time: steps.reached, error }
            }
            _ => End::Stalled { time: steps.reached, steps: steps.taken },
        };
    };
    let Steps { reached, .. } = steps;
    if ride.rows.last().is_none_or(|row| row.time < reached)
        && let Ok(row) = simulation.row(reached, state)
    {
        ride.rows.push(row);
    }
    ride.end = end;
    Ok(false)
}

/// The equations as the integrator asks for them. Where they have no value it is told so by what is no number, and tries a
/// smaller step.
struct Equations<'a> {
    derivative: &'a Derivative<'a>,
    chart: Chart,
    /// The last reason for which there was no value.
    error: &'a RefCell<Option<MotionError>>,
}

impl FirstOrderSystem for Equations<'_> {
    fn derivative(&self, time: f64, state: &[f64], rates: &mut [f64]) {
        // Behind a stage without a value the others of the step have none, for no reason of their own.
        if state.iter().any(|value| !value.is_finite()) {
            return rates.fill(f64::NAN);
        }
        if let Err(error) = (self.derivative)(&self.chart, time, state, rates) {
            *self.error.borrow_mut() = Some(error);
            rates.fill(f64::NAN);
        }
    }
}

/// What is done after each step.
struct Steps<'a, 'b> {
    piece: &'a Piece<'a>,
    /// What is integrated.
    chart: Chart,
    /// What is to be integrated from here on, and how much a step may err, if that is to change.
    renewed: Option<(Chart, f64)>,
    /// Why the equations had no value in this step, if they had none.
    reason: &'a RefCell<Option<MotionError>>,
    /// The place of the next time that is asked for.
    next: usize,
    reached: f64,
    /// The state that was reached: positions and speeds.
    state: &'b mut Vec<f64>,
    /// The values of the events' functions there.
    values: Vec<f64>,
    ride: &'b mut Ride,
    /// How many steps there were.
    taken: usize,
    /// The longest since what is integrated changed, in s.
    longest: f64,
    /// How much a step may err.
    tolerance: f64,
    /// What ends the motion, if something does.
    end: Option<End>,
}

impl SolOut for Steps<'_, '_> {
    fn solout(
        &mut self,
        _: f64,
        time: &mut f64,
        state: &mut [f64],
        interpolant: Option<&StepInterpolant<'_>>,
    ) -> ControlFlag {
        // The first call is before the first step.
        let Some(interpolant) = interpolant else { return ControlFlag::Continue };
        match self.step(*time, state, interpolant) {
            Ok(flag) => {
                *self.reason.borrow_mut() = None;
                flag
            }
            // At the end of the step, or between its stages.
            Err(error) => {
                let error = self.reason.take().unwrap_or(error);
                self.end = Some(End::Singular { time: self.reached, error });
                ControlFlag::Interrupt
            }
        }
    }
}

impl Steps<'_, '_> {
    /// What the integrator begins with.
    fn integrated(&self) -> Result<Vec<f64>, MotionError> {
        let machine = self.piece.simulation.machine();
        let (positions, speeds) = self.piece.simulation.split(self.state);
        let mut rates = vec![0.0; positions.len()];
        machine.rates(positions, speeds, &mut rates)?;
        Ok(positions.iter().copied().chain(self.chart.choose(&rates)).collect())
    }

    fn step(
        &mut self,
        time: f64,
        integrated: &mut [f64],
        interpolant: &StepInterpolant,
    ) -> Result<ControlFlag, MotionError> {
        let simulation = self.piece.simulation;
        let moved = simulation.close(integrated)?;
        self.ride.drift = self.ride.drift.max(moved);
        let at = |moment: f64| -> Result<Vec<f64>, MotionError> {
            let mut between = integrated.to_vec();
            if moment < time {
                interpolant.interpolate(moment, &mut between);
                simulation.close(&mut between)?;
            }
            let (positions, rates) = simulation.split(&between);
            let speeds = self.chart.speeds(simulation.machine(), positions, rates)?;
            Ok([positions, &speeds].concat())
        };
        let (happened, ends) = happened(simulation, (self.reached, time), &mut self.values, &self.ride.events, &at)?;
        let last = happened.last().filter(|_| ends).map(|(moment, _)| *moment);
        let end = last.unwrap_or(time);
        while let Some(&asked) = self.piece.asked.get(self.next).filter(|asked| **asked <= end) {
            self.ride.rows.push(simulation.row(asked, &at(asked)?)?);
            self.next += 1;
        }
        for (moment, event) in happened {
            let row = simulation.row(moment, &at(moment)?)?;
            self.ride.events.push(Happening { name: simulation.watched(event).name.to_owned(), row });
        }
        *self.state = at(end)?;
        let length = time - self.reached;
        self.reached = end;
        if last.is_some() {
            let name = self.ride.events.last().map(|last| last.name.clone()).unwrap_or_default();
            self.end = Some(End::Event { name, time: end });
            return Ok(ControlFlag::Interrupt);
        }
        if simulation.observe(time).is_break() {
            self.end = Some(End::Interrupted { time });
            return Ok(ControlFlag::Interrupt);
        }
        self.taken += 1;
        if self.taken as f64 > MOST_STEPS + MOST_PER_SECOND * (time - self.piece.from) {
            self.end = Some(End::Stalled { time, steps: self.taken });
            return Ok(ControlFlag::Interrupt);
        }
        if time < self.piece.to {
            self.longest = self.longest.max(length);
            self.renewed = self.renew(simulation.split(integrated).0, length)?;
        }
        Ok(match (&self.renewed, moved > 0.0) {
            (Some(_), _) => ControlFlag::Interrupt,
            (None, true) => ControlFlag::ModifiedSolution,
            (None, false) => ControlFlag::Continue,
        })
    }

    /// What is to be integrated behind a step of a length, and how much a step may err, if that is to change.
    fn renew(&self, positions: &[f64], length: f64) -> Result<Option<(Chart, f64)>, MotionError> {
        let simulation = self.piece.simulation;
        if let Some(chart) = self.chart.renewed(simulation.machine(), positions)? {
            return Ok(Some((chart, simulation.allowed_error())));
        }
        // Where rates by the speeds are nearly infinite, there is rounding in what is integrated instead, and no step is short
        // enough to be without it.
        let is_in_rounding = length < SHORTENED * self.longest && !self.chart.is_of_speeds(simulation.machine());
        let tolerance = 10.0 * self.tolerance;
        Ok((is_in_rounding && tolerance <= ROUGHEST).then(|| (self.chart.clone(), tolerance)))
    }
}
