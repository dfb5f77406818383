//! Files with somebody's numbers, in JSON or TOML, and which machine they are of.

mod at_speeds;
mod eigenvalues;
mod members;
mod motion;
mod numbers;

use carvallo_design::input::{self, Node, Raw, Request};
use carvallo_design::{Design, Failure, Place, Shipped, WHIPPLE};

use self::members::Reader;
use self::numbers::problem;
use crate::given::{Given, Quantity};

/// A file with somebody's numbers.
#[derive(Debug)]
pub struct File {
    label: String,
    /// The numbers but for accelerations, whose names depend on the model.
    given: Given,
    accelerations: Option<Node>,
    speed: Option<f64>,
    model: Option<String>,
    bicycle: Option<String>,
    parameters: Vec<(String, String, String)>,
    feedback: Vec<(String, String)>,
}

/// Reads a file, or with `-` the standard input.
///
/// # Errors
/// Everything that is wrong with it, or that it cannot be read.
pub fn load(path: &str) -> Result<File, Failure> {
    File::new(input::load_raw(path)?)
}

/// Reads the contents of a file; the ending of its label tells the format, or else what is in it.
///
/// # Errors
/// Everything that is wrong with it.
pub fn read(label: &str, bytes: Vec<u8>) -> Result<File, Failure> {
    File::new(input::read_raw(label, bytes)?)
}

impl File {
    fn new(raw: Raw) -> Result<Self, Failure> {
        let Reader { given, accelerations, model, bicycle, parameters, feedback, speed, mut problems, digits } =
            Reader::new(raw.members);
        let mut given = given;
        if given.numbers().is_empty() && accelerations.is_none() && problems.is_empty() {
            let message = "there are no numbers to check; expected matrices such as `M`, `A`, `eigenvalues`, \
                           `critical_speeds` or `accelerations`";
            problems.push(problem(&Place::File(raw.label.clone()), message));
        }
        if !problems.is_empty() {
            return Err(Failure::Input(problems));
        }
        if let Some(digits) = digits {
            given.each_reading(&mut |reading| reading.limit(digits));
        }
        Ok(Self { label: raw.label, given, accelerations, speed, model, bicycle, parameters, feedback })
    }

    /// The design that the numbers are of: what is asked for, or else what the file says, or else the benchmark bicycle;
    /// with the parameters and the feedback of the file.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn design(&self, asked: &Request) -> Result<Design, Failure> {
        let model = asked.model.clone().or_else(|| self.model.clone());
        let shipped = model.as_deref().map(Shipped::called).transpose().map_err(Failure::usage)?.unwrap_or(&WHIPPLE);
        let is_shipped = |name: &String| input::names(shipped).contains(&name.as_str());
        let mut parameters = asked.parameters.clone();
        if parameters.is_none() {
            // What the program prints has the name of the machine, and all of its parameters.
            parameters = self.bicycle.clone().filter(|name| self.parameters.is_empty() || is_shipped(name));
        }
        let name = |(_, name, _): &(String, String, String)| input::position(name, shipped.info);
        let given: Vec<usize> = self.parameters.iter().filter_map(name).collect();
        let is_whole = (0..shipped.info.parameters.len())
            .all(|at| given.contains(&at) || !shipped.info.parameters[at].used || shipped.info.gravity == Some(at));
        let feedback = self.laws(&asked.feedback);
        if parameters.is_none() && is_whole && asked.overrides.is_empty() && feedback.is_empty() {
            let values = self.parameters.iter().map(|(_, name, value)| (name.clone(), value.clone()));
            return input::given(shipped, &self.label, values);
        }
        let overrides = self.parameters.iter().chain(&asked.overrides).cloned().collect();
        input::load(&Request { model, parameters, overrides, feedback, ..asked.clone() })
    }

    /// The laws of feedback that are asked for, and those of the file for other forces.
    fn laws(&self, asked: &[(String, String)]) -> Vec<(String, String)> {
        let force = |law: &str| law.split('=').next().unwrap_or_default().trim().to_owned();
        let is_other = |(_, law): &&(String, String)| asked.iter().all(|(_, own)| force(own) != force(law));
        self.feedback.iter().filter(is_other).chain(asked).cloned().collect()
    }

    /// The numbers, with names that belong to a design.
    ///
    /// # Errors
    /// Everything that is wrong with accelerations.
    pub fn given(&self, design: &Design) -> Result<Given, Failure> {
        let mut given = self.given.clone();
        if let Some(node) = &self.accelerations {
            let (found, unknown) = motion::accelerations(node, design.info(), self.speed).map_err(Failure::Input)?;
            given.accelerations = found;
            let of = |(state, of)| given.name(Quantity::Acceleration(state, of), design.info());
            let unknown: Vec<String> = unknown.into_iter().map(of).collect();
            given.unknown.extend(unknown);
        }
        Ok(given)
    }

    /// What the file is called.
    pub fn label(&self) -> &str {
        &self.label
    }
}
