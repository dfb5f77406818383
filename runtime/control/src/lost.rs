//! Speeds at which a mode gets out of reach of an input, or out of sight of an output.

use carvallo::Complex;
use carvallo_design::{Design, Failure};

use crate::modal::{ModalAnalysis, ModalMeasures};
use crate::ports::Output;

/// A speed at which an input does not excite a mode, or an output does not show it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lost {
    /// In m/s.
    pub speed: f64,
    /// Of the mode, in 1/s.
    pub eigenvalue: Complex<f64>,
}

/// What is followed along the speed: of an input the excitation, of an output the share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Port {
    /// One of the inputs of a design, by its place.
    Input(usize),
    /// An output.
    Output(Output),
}

/// Speeds at which it is looked, evenly, and closer and closer to rest.
const SAMPLES: u32 = 400;
/// A measure that is larger is no zero: two modes were taken for one.
const ZERO: f64 = 1e-6;

/// The speeds above zero up to one, in m/s, at which a mode is lost, ascending.
///
/// That asks for one condition of a real mode and for two of an oscillation, which no single parameter meets but by chance; so it is
/// where the excitation or the share of a real mode changes its sign. It is looked for between 400 speeds, and found to rounding: two
/// of one mode that are closer than a four-hundredth of the range are not seen.
///
/// # Errors
/// If there are no equations of motion at some speed.
pub fn lost(design: &Design, port: Port, up_to: f64) -> Result<Vec<Lost>, Failure> {
    let (inputs, outputs) = match port {
        Port::Input(input) => (vec![input], Vec::new()),
        Port::Output(output) => (Vec::new(), vec![output]),
    };
    let follower = Follower { analysis: ModalAnalysis::new(design, inputs, outputs), design, port };
    let step = up_to / f64::from(SAMPLES);
    let near_rest = (1..12).rev().map(|halvings| step / 2_f64.powi(halvings));
    let speeds = near_rest.chain((1..=SAMPLES).map(|index| f64::from(index) * step));
    let mut found = Vec::new();
    let mut before: Option<(f64, Vec<Mode>)> = None;
    for speed in speeds {
        let modes = follower.real_modes(speed)?;
        if let Some((from, at)) = &before
            && at.len() == modes.len()
        {
            for place in 0..modes.len() {
                if at[place].value_beside(&modes[place]) * modes[place].value < 0.0 {
                    found.extend(follower.between(*from, speed, place)?);
                }
            }
        }
        before = Some((speed, modes));
    }
    found.sort_by(|a, b| a.speed.total_cmp(&b.speed));
    Ok(found)
}

struct Follower<'a> {
    analysis: ModalAnalysis<'a>,
    design: &'a Design,
    port: Port,
}

/// A real mode.
struct Mode {
    eigenvalue: f64,
    /// Whose sign is that of the vector.
    value: f64,
    measure: f64,
    shape: Vec<f64>,
}

impl Mode {
    /// The value where the vector has the direction that it has in another mode.
    fn value_beside(&self, other: &Self) -> f64 {
        let along: f64 = self.shape.iter().zip(&other.shape).map(|(a, b)| a * b).sum();
        if along < 0.0 { -self.value } else { self.value }
    }
}

impl Follower<'_> {
    /// Ascending.
    fn real_modes(&self, speed: f64) -> Result<Vec<Mode>, Failure> {
        let gravity = self.design.gravity().unwrap_or(0.0);
        let fail = |error| Failure::Run(format!("{}: {error}", self.design.title()));
        let values = self.design.equations.eigenvalues(speed, gravity).map_err(fail)?;
        let real: Vec<Complex<f64>> = values.into_iter().filter(|value| value.im == 0.0).collect();
        let shapes = self.design.equations.eigenvectors(speed, gravity, &real).map_err(fail)?;
        let modes = self.analysis.at(speed, &real)?.into_iter().zip(shapes);
        Ok(modes
            .map(|(ModalMeasures { eigenvalue, controllability, observability, excitation, share }, shape)| {
                let (value, measure, vector) = match self.port {
                    Port::Input(_) => (excitation[0].re, controllability[0], &shape.left),
                    Port::Output(_) => (share[0].re, observability[0], &shape.right),
                };
                Mode { eigenvalue: eigenvalue.re, value, measure, shape: vector.iter().map(|part| part.re).collect() }
            })
            .collect())
    }

    /// Where the value of a mode changes its sign between two speeds, if it is one mode.
    fn between(&self, mut low: f64, mut high: f64, place: usize) -> Result<Option<Lost>, Failure> {
        let mut below = self.real_modes(low)?;
        loop {
            let middle = low + 0.5 * (high - low);
            let mut modes = self.real_modes(middle)?;
            if modes.len() != below.len() {
                return Ok(None);
            }
            let is_done = middle <= low || middle >= high;
            if is_done || modes[place].value == 0.0 {
                let Mode { eigenvalue, measure, .. } = modes.swap_remove(place);
                let lost = Lost { speed: middle, eigenvalue: Complex::new(eigenvalue, 0.0) };
                return Ok((measure <= ZERO).then_some(lost));
            }
            if below[place].value_beside(&modes[place]) * modes[place].value < 0.0 {
                high = middle;
            } else {
                (low, below) = (middle, modes);
            }
        }
    }
}
