//! The inputs and outputs of a design at a speed, as options.

use carvallo_control::{Output, Ports, StateSpace};
use carvallo_design::{Design, Failure, Place, Problem};
use clap::Args;

use crate::options::{DesignOptions, Speed, UnitOptions};
use crate::terminal::{WARNING, note};

/// A design at a speed, with inputs and outputs.
#[derive(Args, Clone, Debug)]
pub struct PortOptions {
    #[command(flatten)]
    pub design: DesignOptions,
    /// Forward speed in m/s
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    pub speed: Option<Speed>,
    #[command(flatten)]
    pub names: PortNames,
    #[command(flatten)]
    pub units: UnitOptions,
}

/// Inputs and outputs by their names.
#[derive(Args, Clone, Debug)]
pub struct PortNames {
    #[arg(
        long,
        value_name = "NAMES",
        alias = "input",
        value_delimiter = ',',
        help = "Forces and torques that are inputs, such as Tdelta [default: all]"
    )]
    pub inputs: Vec<String>,
    #[arg(
        long,
        value_name = "NAMES",
        value_delimiter = ',',
        allow_hyphen_values = true,
        help = "What comes out, such as phi,delta,phi_rate [default: all states or coordinates]"
    )]
    pub outputs: Vec<String>,
}

impl PortOptions {
    /// The design, and its state space at the speed; what comes out where no outputs are named, is given.
    ///
    /// # Errors
    /// Everything that is wrong with what was asked for; or that there are no equations of motion.
    pub fn load(&self, usual: fn(&Ports) -> Vec<Output>) -> Result<(Design, StateSpace), Failure> {
        let design = self.design.load()?;
        let (inputs, outputs) = self.names.ports(&design, usual)?;
        let speed = self.speed(&design)?;
        let space = StateSpace::new(&design, speed, &inputs, &outputs)?;
        Ok((design, space))
    }

    /// The speed in m/s of what has one.
    ///
    /// # Errors
    /// If there is none, and the equations depend on it.
    fn speed(&self, design: &Design) -> Result<f64, Failure> {
        match (self.speed, design.model.depends_on_speed()) {
            (Some(Speed(speed)), true) => Ok(speed),
            (None, true) => {
                Err(Failure::usage("expected --speed V, which the equations of motion depend on, such as --speed 5"))
            }
            (None, false) => Ok(0.0),
            (Some(_), false) => {
                let model = design.info().name;
                note(
                    WARNING,
                    "note",
                    &format!("nothing in the model {model} depends on the speed: --speed is ignored"),
                );
                Ok(0.0)
            }
        }
    }
}

/// The inputs that are named, by their places; without names all of them.
///
/// # Errors
/// All names that there are none of, or that stand twice.
pub fn inputs(ports: &Ports, names: &[String]) -> Result<Vec<usize>, Failure> {
    let mut problems = Vec::new();
    let inputs = named("--inputs", names, |name| ports.input(name), &mut problems);
    match (problems.is_empty(), inputs.is_empty()) {
        (false, _) => Err(Failure::Input(problems)),
        (true, true) => Ok(ports.all_inputs()),
        (true, false) => Ok(inputs),
    }
}

impl PortNames {
    /// The inputs, by their places, and the outputs.
    ///
    /// # Errors
    /// All names that there are none of, or that stand twice.
    pub fn ports(
        &self,
        design: &Design,
        usual: fn(&Ports) -> Vec<Output>,
    ) -> Result<(Vec<usize>, Vec<Output>), Failure> {
        let ports = Ports::of(design);
        let mut problems = Vec::new();
        let inputs = named("--inputs", &self.inputs, |name| ports.input(name), &mut problems);
        let outputs = named("--outputs", &self.outputs, |name| ports.output(name), &mut problems);
        if !problems.is_empty() {
            return Err(Failure::Input(problems));
        }
        let inputs = if inputs.is_empty() { ports.all_inputs() } else { inputs };
        Ok((inputs, if outputs.is_empty() { usual(&ports) } else { outputs }))
    }
}

/// What names stand for, each once.
fn named<T: PartialEq>(
    option: &str,
    names: &[String],
    find: impl Fn(&str) -> Result<T, String>,
    problems: &mut Vec<Problem>,
) -> Vec<T> {
    let mut found = Vec::new();
    for name in names.iter().map(|name| name.trim()) {
        match find(name) {
            Ok(port) if found.contains(&port) => {
                problems.push(Problem {
                    place: Place::Option(format!("{option} {name}")),
                    message: "it is named twice".into(),
                });
            }
            Ok(port) => found.push(port),
            Err(message) => problems.push(Problem { place: Place::Option(format!("{option} {name}")), message }),
        }
    }
    found
}
