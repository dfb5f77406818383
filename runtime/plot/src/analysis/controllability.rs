//! Modal controllability and observability along the speed.

use carvallo::{Complex, ModeValue};
use carvallo_control::{Lost, ModalAnalysis, ModalMeasures, Output, Port, Ports, Signal, lost};
use carvallo_design::Failure;

use crate::analysis::Analysis;

/// Speeds of a picture.
const DRAWN: u32 = 250;

/// The modes of a design along the speed, between inputs and outputs.
pub struct Controllability {
    /// The design, with its modes.
    pub analysis: Analysis,
    /// What the inputs are.
    pub inputs: Vec<Signal>,
    /// What the outputs are.
    pub outputs: Vec<Signal>,
    /// The places of the inputs.
    input_places: Vec<usize>,
    /// The outputs themselves.
    output_ports: Vec<Output>,
}

/// The modes at one speed.
pub struct AtSpeed {
    /// In m/s.
    pub speed: f64,
    /// Each with its name.
    pub modes: Vec<(ModeValue, ModalMeasures)>,
}

/// Where the modes get lost to an input or an output.
pub struct LostTo {
    /// Its name.
    pub name: String,
    /// Whether it is an input.
    pub is_input: bool,
    /// Ascending in speed.
    pub lost: Vec<Lost>,
}

impl Controllability {
    /// Between some of the inputs of a design, by their places, and outputs.
    pub fn new(analysis: Analysis, inputs: Vec<usize>, outputs: Vec<Output>) -> Self {
        let ports = Ports::of(&analysis.design);
        Self {
            inputs: inputs.iter().map(|&input| ports.inputs[input].clone()).collect(),
            outputs: outputs.iter().map(|&output| ports.signal(output)).collect(),
            input_places: inputs,
            output_ports: outputs,
            analysis,
        }
    }

    /// The modes at each of some speeds in m/s; none at rest where there are no equations of motion.
    ///
    /// # Errors
    /// If an output is an integral, or if an eigenvector leaves the range of doubles.
    pub fn rows(&self, speeds: &[f64]) -> Result<Vec<AtSpeed>, Failure> {
        let modal = ModalAnalysis::new(&self.analysis.design, self.input_places.clone(), self.output_ports.clone());
        let at = |(speed, values): (f64, &[ModeValue])| {
            let eigenvalues: Vec<Complex<f64>> = values.iter().map(|value| value.value).collect();
            let measures = modal.at(speed, &eigenvalues)?;
            Ok(AtSpeed { speed, modes: values.iter().copied().zip(measures).collect() })
        };
        self.analysis.rows(speeds)?.values().into_iter().map(at).collect()
    }

    /// Where modes get lost to each input and output, up to a speed in m/s; nothing where nothing depends on the speed.
    ///
    /// # Errors
    /// If there are no equations of motion at some speed.
    pub fn lost(&self, up_to: f64) -> Result<Vec<LostTo>, Failure> {
        if !self.analysis.design.model.depends_on_speed() {
            return Ok(Vec::new());
        }
        let inputs =
            self.input_places.iter().zip(&self.inputs).map(|(&place, signal)| (Port::Input(place), signal, true));
        let outputs = self.output_ports.iter().zip(&self.outputs);
        let outputs = outputs.map(|(&output, signal)| (Port::Output(output), signal, false));
        let of = |(port, signal, is_input): (Port, &Signal, bool)| {
            let lost = lost(&self.analysis.design, port, up_to)?;
            Ok(LostTo { name: signal.name.clone(), is_input, lost })
        };
        inputs.chain(outputs).map(of).collect()
    }
}

/// The speeds of a picture, in m/s: evenly from the least to the most, and closer and closer to where a mode is lost.
pub fn drawn(least: f64, most: f64, lost: &[LostTo]) -> Vec<f64> {
    let step = (most - least) / f64::from(DRAWN);
    let mut speeds: Vec<f64> = (0..DRAWN).map(|index| least + f64::from(index) * step).chain([most]).collect();
    for lost in lost.iter().flat_map(|of| &of.lost) {
        let around = (0..6).map(|power| step / 3_f64.powi(power)).flat_map(|shift| [-shift, shift]);
        speeds.extend(around.chain([0.0]).map(|shift| lost.speed + shift));
    }
    speeds.retain(|speed| (least..=most).contains(speed));
    speeds.sort_by(f64::total_cmp);
    speeds
}
