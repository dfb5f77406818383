//! Transfer functions between all inputs and outputs of a state space.

use carvallo::{Complex, SystemError};
use carvallo_control::{FrequencyResponse, Margins, StateSpace, TransferFunction, singular_values, transmission_zeros};
use carvallo_design::{Design, Failure};

use crate::analysis::extremes;

/// The transfer functions of a design at a speed.
pub struct Transfers<'a> {
    /// What they are of.
    pub design: &'a Design,
    /// Where they come from.
    pub space: &'a StateSpace,
    /// Of the whole state space, in 1/s.
    pub poles: Vec<Complex<f64>>,
    /// From each input to each output, those of one input one after the other.
    pub channels: Vec<Transfer>,
    /// The transmission zeros in 1/s of all inputs and outputs together; `None` where there are not as many of both, or where outputs
    /// depend on each other.
    pub transmission_zeros: Option<Vec<Complex<f64>>>,
    /// At the frequencies of the responses; none at a pole.
    pub singular_values: Vec<AtFrequency>,
}

/// The singular values of all transfer functions together at a frequency.
pub struct AtFrequency {
    /// In rad/s.
    pub frequency: f64,
    /// Descending, in the units of outputs by those of inputs.
    pub values: Vec<f64>,
}

/// One of them.
pub struct Transfer {
    /// Its zeros, poles and gain.
    pub function: TransferFunction,
    /// How far it is from -1.
    pub margins: Margins,
    /// Ascending in frequency, at the same frequencies as all others.
    pub response: Vec<FrequencyResponse>,
}

/// At which frequencies a response is told, in rad/s.
#[derive(Clone, Debug, PartialEq)]
pub enum Frequencies {
    /// At these.
    List(Vec<f64>),
    /// Between two, as densely as the poles and zeros ask for.
    Range([f64; 2]),
}

impl<'a> Transfers<'a> {
    /// From all inputs to all outputs of a state space; without frequencies over all at which there is something to see.
    ///
    /// # Errors
    /// If eigenvalues cannot be computed.
    pub fn new(design: &'a Design, space: &'a StateSpace, frequencies: Option<&Frequencies>) -> Result<Self, Failure> {
        let fail = |error: SystemError| Failure::Run(format!("{}: {error}{}", design.title(), extremes(design)));
        let places =
            (0..space.inputs.len()).flat_map(|input| (0..space.outputs.len()).map(move |output| (input, output)));
        let channel = |(input, output)| {
            Ok(Transfer {
                function: TransferFunction::new(space, input, output)?,
                margins: Margins::new(space, input, output)?,
                response: Vec::new(),
            })
        };
        let mut channels: Vec<Transfer> = places.map(channel).collect::<Result<_, _>>().map_err(fail)?;
        let frequencies = match frequencies {
            Some(Frequencies::List(list)) => list.clone(),
            Some(Frequencies::Range(range)) => common(&channels, *range),
            None => {
                let own = channels.iter().map(|channel| channel.function.frequencies(None));
                let extremes = own.filter_map(|own| Some((*own.first()?, *own.last()?)));
                let (low, high) = extremes.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1))).unwrap_or((0.1, 10.0));
                common(&channels, [low, high])
            }
        };
        for channel in &mut channels {
            channel.response = channel.function.frequency_response(&frequencies);
        }
        let functions: Vec<TransferFunction> = channels.iter().map(|channel| channel.function.minimal()).collect();
        let at = |frequency: f64| {
            let values = singular_values(&functions, space.inputs.len(), frequency)?;
            Some(AtFrequency { frequency, values })
        };
        Ok(Self {
            design,
            space,
            poles: space.poles().map_err(fail)?,
            singular_values: frequencies.into_iter().filter_map(at).collect(),
            transmission_zeros: transmission_zeros(space).map_err(fail)?,
            channels,
        })
    }

    /// Whether there is more than one transfer function.
    pub fn are_several(&self) -> bool {
        self.channels.len() > 1
    }
}

impl Transfer {
    /// From what to what: `Tdelta to phi`.
    pub fn title(&self) -> String {
        format!("{} to {}", self.function.input.name, self.function.output.name)
    }

    /// The unit of its gain: that of the output by that of the input, as in `rad/(N*m)`.
    pub fn unit(&self) -> String {
        let (input, output) = (&self.function.input.unit, &self.function.output.unit);
        match input.as_str() {
            "1" => output.clone(),
            input if input.contains(['*', '/']) => format!("{output}/({input})"),
            input => format!("{output}/{input}"),
        }
    }
}

/// Frequencies in a range that show all of each response.
fn common(channels: &[Transfer], range: [f64; 2]) -> Vec<f64> {
    let mut all: Vec<f64> = channels.iter().flat_map(|channel| channel.function.frequencies(Some(range))).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}
