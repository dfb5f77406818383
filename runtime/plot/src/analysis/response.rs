//! Responses of a state space in time.

use carvallo::simulation::SimulationError;
use carvallo_control::{Response, StateSpace};
use carvallo_design::number::{shortest, unit};
use carvallo_design::{Design, Failure};

use crate::analysis::excitation::Excitation;
use crate::analysis::{TOO_LONG, extremes};

/// A response of a design at a speed.
pub struct Responses<'a> {
    /// What responds.
    pub design: &'a Design,
    /// With its inputs and outputs.
    pub space: &'a StateSpace,
    /// To what.
    pub excitation: Excitation,
    /// How.
    pub response: Response,
    /// Why it ends before its time, if it does.
    pub end: Option<String>,
}

impl<'a> Responses<'a> {
    /// The response at times in s that ascend from zero; as far as it stays in the range of doubles.
    ///
    /// # Errors
    /// If there is none.
    pub fn new(
        design: &'a Design,
        space: &'a StateSpace,
        excitation: Excitation,
        times: &[f64],
    ) -> Result<Self, Failure> {
        let run = |times: &[f64]| match &excitation {
            Excitation::Step { input, size } => space.step_response(*input, *size, times),
            Excitation::Impulse { input, size } => space.impulse_response(*input, *size, times),
            Excitation::Initial(state) => space.respond(state, &vec![0.0; space.inputs.len()], times),
        };
        let fail = |error: SimulationError| Failure::Run(format!("{}: {error}{}", design.title(), extremes(design)));
        let (response, end) = match run(times) {
            Ok(response) => (response, None),
            // What there is until then.
            Err(error @ (SimulationError::OutOfRange { time } | SimulationError::TooLong { time })) => {
                let reached = times.partition_point(|before| *before < time);
                let reason = match error {
                    SimulationError::TooLong { .. } => TOO_LONG,
                    _ => "the response then leaves the range of floating-point numbers",
                };
                let end = format!("it ends before {} s: {reason}", shortest(time));
                (run(&times[..reached]).map_err(fail)?, Some(end))
            }
            Err(error) => return Err(fail(error)),
        };
        Ok(Self { design, space, excitation, response, end })
    }

    /// What it is: `Response to a step of 1 N m in Tdelta`.
    pub fn title(&self) -> String {
        let what = |article: &str, kind: &str, input: usize, size: f64, per: &str| {
            let input = &self.space.inputs[input];
            let of = [shortest(size), unit(&input.unit), per.to_owned()];
            let of = of.iter().filter(|part| !part.is_empty()).cloned().collect::<Vec<_>>().join(" ");
            format!("Response to {article} {kind} of {of} in {}", input.name)
        };
        match &self.excitation {
            Excitation::Step { input, size } => what("a", "step", *input, *size, ""),
            Excitation::Impulse { input, size } => what("an", "impulse", *input, *size, "s"),
            Excitation::Initial(state) => {
                let given = self.space.states.iter().zip(state).filter(|(_, value)| **value != 0.0);
                let given: Vec<String> = given
                    .map(|(state, value)| {
                        let shown = format!("{} = {} {}", state.name, six_digits(*value), unit(&state.unit));
                        shown.trim_end().to_owned()
                    })
                    .collect();
                format!("Response from {}", if given.is_empty() { "rest".to_owned() } else { given.join(", ") })
            }
        }
    }
}

/// A value as far as anyone reads it in a title.
fn six_digits(value: f64) -> String {
    shortest(format!("{value:.5e}").parse().unwrap_or(value))
}
