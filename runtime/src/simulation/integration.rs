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

use super::error::SimulationError;
use super::nonlinear::{End, Ride, Simulation};
use crate::motion::MotionError;

/// More steps than these in one piece, and in a second of it, are taken for a motion that does not go on. A bicycle takes a
/// hundred in a second.
const MOST_STEPS: f64 = 100_000.0;
const MOST_PER_SECOND: f64 = 10_000.0;

/// Into how many parts a step is divided, to see changes of sign that would hide in it.
const PARTS: usize = 4;

/// A part of a motion between two times.
pub(super) struct Piece<'a> {
    pub simulation: &'a Simulation<'a>,
    pub from: f64,
    pub to: f64,
    /// The times behind the first that are asked for.
    pub asked: &'a [f64],
    pub derivative: &'a Derivative<'a>,
}

/// The derivative of a state at a time.
pub(super) type Derivative<'a> = dyn Fn(f64, &[f64], &mut [f64]) -> Result<(), MotionError> + 'a;

/// Takes the state to the end of a piece, and adds to the ride what is asked for; whether the ride goes on.
///
/// # Errors
/// If the equations have no value at the beginning.
pub(super) fn integrate(piece: Piece, state: &mut Vec<f64>, ride: &mut Ride) -> Result<bool, SimulationError> {
    if piece.to <= piece.from {
        return Ok(true);
    }
    let most = (MOST_STEPS + MOST_PER_SECOND * (piece.to - piece.from)).min(1e9) as usize;
    let (simulation, from, to) = (piece.simulation, piece.from, piece.to);
    let signs =
        simulation.event_functions(from, state).map_err(|error| SimulationError::Motion { time: from, error })?;
    let equations = Equations { derivative: piece.derivative, error: RefCell::new(None) };
    let mut steps = Steps {
        piece: &piece,
        reason: &equations.error,
        next: 0,
        reached: from,
        state: state.clone(),
        values: signs,
        ride,
        is_over: false,
    };
    // What is stiff is integrated as well, if in small steps.
    let method = DOP853::builder().max_steps(most).stiff_test(usize::MAX).build();
    let tolerance = || Tolerance::Scalar(simulation.allowed_error());
    let done = method.solve(&equations, from, state, to, tolerance(), tolerance(), Some(&mut steps));
    let (reached, is_over) = (steps.reached, steps.is_over);
    *state = std::mem::take(&mut steps.state);
    match done.map(|result| result.status) {
        Ok(Status::Success | Status::UserInterrupt) => Ok(!is_over),
        other => {
            if ride.rows.last().is_none_or(|row| row.time < reached)
                && let Ok(row) = simulation.row(reached, state)
            {
                ride.rows.push(row);
            }
            ride.end = if let Ok(Status::StepSizeTooSmall) = other {
                let error = equations.error.take().unwrap_or(MotionError::Singular { quantity: "the motion" });
                End::Singular { time: reached, error }
            } else {
                End::Stalled { time: reached, steps: most }
            };
            Ok(false)
        }
    }
}

/// The equations as the integrator asks for them. Where they have no value it is told so by what is no number, and tries a
/// smaller step.
struct Equations<'a> {
    derivative: &'a Derivative<'a>,
    /// The last reason for which there was no value.
    error: RefCell<Option<MotionError>>,
}

impl FirstOrderSystem for Equations<'_> {
    fn derivative(&self, time: f64, state: &[f64], rates: &mut [f64]) {
        // Behind a stage without a value the others of the step have none, for no reason of their own.
        if state.iter().any(|value| !value.is_finite()) {
            return rates.fill(f64::NAN);
        }
        if let Err(error) = (self.derivative)(time, state, rates) {
            *self.error.borrow_mut() = Some(error);
            rates.fill(f64::NAN);
        }
    }
}

/// What is done after each step.
struct Steps<'a, 'b> {
    piece: &'a Piece<'a>,
    /// Why the equations had no value in this step, if they had none.
    reason: &'a RefCell<Option<MotionError>>,
    /// The place of the next time that is asked for.
    next: usize,
    reached: f64,
    /// The state that was reached.
    state: Vec<f64>,
    /// The values of the events' functions there.
    values: Vec<f64>,
    ride: &'b mut Ride,
    is_over: bool,
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
                self.ride.end = End::Singular { time: self.reached, error };
                self.is_over = true;
                ControlFlag::Interrupt
            }
        }
    }
}

impl Steps<'_, '_> {
    fn step(
        &mut self,
        time: f64,
        state: &mut [f64],
        interpolant: &StepInterpolant,
    ) -> Result<ControlFlag, MotionError> {
        let simulation = self.piece.simulation;
        let moved = simulation.close(state)?;
        self.ride.drift = self.ride.drift.max(moved);
        let at = |moment: f64| -> Result<Vec<f64>, MotionError> {
            let mut between = state.to_vec();
            if moment < time {
                interpolant.interpolate(moment, &mut between);
                simulation.close(&mut between)?;
            }
            Ok(between)
        };
        let happened = self.happened(time, &at)?;
        let last = happened.last().filter(|(_, event)| simulation.named(*event).1).map(|(moment, _)| *moment);
        let end = last.unwrap_or(time);
        while let Some(&asked) = self.piece.asked.get(self.next).filter(|asked| **asked <= end) {
            self.ride.rows.push(simulation.row(asked, &at(asked)?)?);
            self.next += 1;
        }
        for (moment, event) in happened {
            self.ride.events.push((moment, simulation.named(event).0.to_owned()));
        }
        if let Some(moment) = last {
            let state = at(moment)?;
            if self.ride.rows.last().is_none_or(|row| row.time < moment) {
                self.ride.rows.push(simulation.row(moment, &state)?);
            }
            let name = self.ride.events.last().map(|(_, name)| name.clone()).unwrap_or_default();
            self.ride.end = End::Event { name, time: moment };
            (self.reached, self.state, self.is_over) = (moment, state, true);
            return Ok(ControlFlag::Interrupt);
        }
        self.reached = time;
        self.state.copy_from_slice(state);
        simulation.observe(time);
        Ok(if moved > 0.0 { ControlFlag::ModifiedSolution } else { ControlFlag::Continue })
    }

    /// The events in a step, in their order and up to one that ends the simulation.
    fn happened(
        &mut self,
        end: f64,
        at: &dyn Fn(f64) -> Result<Vec<f64>, MotionError>,
    ) -> Result<Vec<(f64, usize)>, MotionError> {
        let simulation = self.piece.simulation;
        let mut happened = Vec::new();
        if self.values.is_empty() {
            return Ok(happened);
        }
        let begin = self.reached;
        for part in 1..=PARTS {
            let moment = if part == PARTS { end } else { begin + (end - begin) * part as f64 / PARTS as f64 };
            let from = begin + (end - begin) * (part - 1) as f64 / PARTS as f64;
            let values = simulation.event_functions(moment, &at(moment)?)?;
            let mut found = Vec::new();
            for (event, (before, after)) in self.values.iter().zip(&values).enumerate() {
                if before * after < 0.0 || *after == 0.0 && *before != 0.0 {
                    found.push((
                        change_of_sign(
                            (from, *before),
                            moment,
                            |t| Ok(simulation.event_functions(t, &at(t)?)?[event]),
                        )?,
                        event,
                    ));
                }
            }
            found.sort_by(|a, b| a.0.total_cmp(&b.0));
            self.values = values;
            for (moment, event) in found {
                happened.push((moment, event));
                if simulation.named(event).1 {
                    return Ok(happened);
                }
            }
        }
        Ok(happened)
    }
}

/// The time between two at which a function changes its sign, to rounding: the latter of two neighbours.
fn change_of_sign(
    (mut from, before): (f64, f64),
    mut to: f64,
    value: impl Fn(f64) -> Result<f64, MotionError>,
) -> Result<f64, MotionError> {
    // As often as a double can be halved.
    for _ in 0..100 {
        let middle = from + 0.5 * (to - from);
        if middle <= from || middle >= to {
            break;
        }
        if value(middle)? * before > 0.0 {
            from = middle;
        } else {
            to = middle;
        }
    }
    Ok(to)
}
