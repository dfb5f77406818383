//! Responses in time.

use carvallo::simulation::{Propagator, SimulationError};
use nalgebra::DVector;

use crate::state_space::StateSpace;

/// What comes out of a state space in time.
#[derive(Clone, Debug, PartialEq)]
pub struct Response {
    /// In s.
    pub times: Vec<f64>,
    /// The outputs at each time.
    pub outputs: Vec<Vec<f64>>,
}

impl StateSpace {
    /// The response to an input that is so large from time zero on, with the other ones zero; the motion begins at rest.
    ///
    /// ```
    /// use carvallo_control::{Ports, StateSpace};
    /// use carvallo_design::input::{self, Request};
    ///
    /// let bicycle = input::load(&Request::default())?;
    /// let ports = Ports::of(&bicycle);
    /// let (torque, lean) = (ports.input("Tdelta").unwrap(), ports.output("phi").unwrap());
    /// let steered = StateSpace::new(&bicycle, 5.0, &[torque], &[lean])?;
    /// let response = steered.step_response(0, 1.0, &[0.0, 0.5]).unwrap();
    /// // A torque to the right leans it to the left.
    /// assert!(response.outputs[1][0] < 0.0);
    /// # Ok::<(), carvallo_design::Failure>(())
    /// ```
    ///
    /// # Errors
    /// As for [`respond`](Self::respond).
    ///
    /// # Panics
    /// If there is no such input.
    pub fn step_response(&self, input: usize, size: f64, times: &[f64]) -> Result<Response, SimulationError> {
        let mut inputs = vec![0.0; self.inputs.len()];
        inputs[input] = size;
        self.respond(&vec![0.0; self.states.len()], &inputs, times)
    }

    /// The response to an impulse of an input, of which `size` is the integral over time; the motion begins at rest. What follows
    /// the input at once, by D, is over when it is told.
    ///
    /// # Errors
    /// As for [`respond`](Self::respond).
    ///
    /// # Panics
    /// If there is no such input.
    pub fn impulse_response(&self, input: usize, size: f64, times: &[f64]) -> Result<Response, SimulationError> {
        let state: Vec<f64> = self.b.column(input).iter().map(|entry| size * entry).collect();
        self.respond(&state, &vec![0.0; self.inputs.len()], times)
    }

    /// The response from a state at time zero with constant inputs, exact by the matrix exponential, at times in s that ascend from
    /// zero or more.
    ///
    /// # Errors
    /// If there are too many or too few numbers, if one is not finite, if the times do not ascend from zero, or if the motion leaves
    /// the range of `f64`.
    pub fn respond(&self, state: &[f64], inputs: &[f64], times: &[f64]) -> Result<Response, SimulationError> {
        for (quantity, expected, found) in
            [("initial states", self.states.len(), state.len()), ("inputs", self.inputs.len(), inputs.len())]
        {
            if found != expected {
                return Err(SimulationError::Length { quantity, expected, found });
            }
        }
        for (quantity, values) in [("initial states", state), ("inputs", inputs), ("times", times)] {
            if let Some(&value) = values.iter().find(|value| !value.is_finite()) {
                return Err(SimulationError::NotFinite { quantity, value });
            }
        }
        let (mut state, inputs) = (DVector::from_column_slice(state), DVector::from_column_slice(inputs));
        let (driven, without_growth) = (&self.b * &inputs, DVector::zeros(self.states.len()));
        let (mut before, mut last): (f64, Option<(f64, Propagator)>) = (0.0, None);
        let mut outputs = Vec::with_capacity(times.len());
        for &time in times {
            let step = time - before;
            if step < 0.0 {
                return Err(SimulationError::Unsorted { time: before, next: time });
            }
            let out_of_range = || SimulationError::OutOfRange { time };
            if step > 0.0 {
                // Steps that differ by the rounding of the times are one.
                let is_last = |last: &f64| (last - step).abs() <= 4.0 * f64::EPSILON * time;
                let taken = match last.take() {
                    Some((of, propagator)) if is_last(&of) => (of, propagator),
                    _ => (step, Propagator::new(&self.a, step).map_err(|error| error.at(time))?),
                };
                state = taken.1.advance(&state, &driven, &without_growth);
                last = Some(taken);
            }
            let values = &self.c * &state + &self.d * &inputs;
            if values.iter().chain(state.iter()).any(|value| !value.is_finite()) {
                return Err(out_of_range());
            }
            outputs.push(values.as_slice().to_vec());
            before = time;
        }
        Ok(Response { times: times.to_vec(), outputs })
    }
}
