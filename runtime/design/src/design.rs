//! A machine as it was given, with its equations of motion: what everything is computed from.

use carvallo::simulation::Machine;
use carvallo::{Covariance, Model as _, ModelInfo};
use carvallo_models::{WhippleMechanism, WhippleMechanismKinematics};

use crate::feedback::{Closed, Law, Unclosed};
use crate::model::{Equations, MachineVisitor, Shipped};
use crate::number::shortest;

/// A machine as it was given by its parameters, with its equations of motion.
#[derive(Debug)]
pub struct Design {
    /// The name of the machine, or of the file.
    pub name: String,
    /// What it is.
    pub kind: Option<String>,
    /// Where the parameters come from.
    pub source: Option<String>,
    /// The model that the parameters are for, with the feedback.
    pub model: &'static Shipped,
    /// The parameters in the order of the model.
    pub parameters: Vec<Given>,
    /// How the measurements of the parameters vary together; `None` if they are taken to be independent.
    pub covariance: Option<Covariance>,
    /// The forces that follow from the motion besides those of the model.
    pub feedback: Vec<Law>,
    /// What the model makes of them, with the loops of feedback closed.
    pub equations: Box<dyn Equations>,
    /// How the file was read, if it is not in the names of the paper.
    #[cfg(feature = "full")]
    pub reading: Option<crate::conventions::Reading>,
    /// The names of values that options gave in the place of others.
    #[cfg(feature = "full")]
    pub set: Vec<String>,
    /// What was read but not used, or taken because it was not given.
    pub notes: Vec<String>,
    /// What the parameters of a real machine would hardly be.
    pub warnings: Vec<String>,
}

/// One parameter that was given.
#[derive(Clone, Debug)]
pub struct Given {
    /// As it was written: a number, or an expression.
    pub written: String,
    /// In the unit of the parameter.
    pub value: f64,
    /// The standard deviation of its measurement, unless it is 0.
    pub deviation: Option<Deviation>,
}

/// A standard deviation above 0.
#[derive(Clone, Debug)]
pub struct Deviation {
    /// As it was written: a number, or an expression.
    pub written: String,
    /// In the unit of the parameter.
    pub value: f64,
}

/// Why there is no machine whose nonlinear motion could be computed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WithoutMachine {
    /// The model has no nonlinear equations.
    Equations,
    /// It has, but the feedback cannot be part of them.
    Feedback(Unclosed),
}

impl Design {
    /// Why there is no machine, as a sentence.
    pub fn explain(&self, without: &WithoutMachine) -> String {
        let model = self.info().name;
        let force = |law: &usize| self.feedback[*law].force(self.info()).0;
        match without {
            WithoutMachine::Equations => format!("the model {model} has no nonlinear equations"),
            WithoutMachine::Feedback(Unclosed::Force(law)) => {
                let all: Vec<&str> = self.info().forces.iter().map(|force| force.name).collect();
                let there =
                    if all.is_empty() { "there is none".to_owned() } else { format!("they have {}", all.join(", ")) };
                format!("the nonlinear equations of {model} have no force `{}`, which is fed back; {there}", force(law))
            }
            WithoutMachine::Feedback(Unclosed::Position(law)) => {
                format!("the nonlinear equations of {model} have no position that `{}` follows from", force(law))
            }
            WithoutMachine::Feedback(Unclosed::Speed(law)) => {
                format!(
                    "the feedback of `{}` depends on v, and in the nonlinear equations of {model} nothing runs",
                    force(law)
                )
            }
        }
    }

    /// What the model tells about itself.
    pub fn info(&self) -> &'static ModelInfo {
        self.model.info
    }

    /// Its name; for other models than that of the bicycles, after the name of the model.
    pub fn title(&self) -> String {
        let feedback = if self.feedback.is_empty() { "" } else { " with feedback" };
        let model = if self.model.is_whipple() { String::new() } else { format!("{} ", self.info().name) };
        format!("{model}{}{feedback}", self.name)
    }

    /// The value of the parameter called `name`.
    pub fn value(&self, name: &str) -> Option<f64> {
        self.parameters.get(self.info().position(name)?).map(|given| given.value)
    }

    /// The values of all parameters.
    pub fn values(&self) -> Vec<f64> {
        self.parameters.iter().map(|given| given.value).collect()
    }

    /// The same machine with other values of its parameters, in the order of the model: those that change lose their standard
    /// deviations, and all of them their correlations.
    ///
    /// # Errors
    /// The first of them, or of the model's requirements, that does not hold.
    pub fn with_values(&self, values: &[f64]) -> Result<Self, String> {
        let given = |(given, &value): (&Given, &f64)| match given.value == value {
            true => given.clone(),
            false => Given { written: shortest(value), value, deviation: None },
        };
        Ok(Self {
            name: self.name.clone(),
            kind: self.kind.clone(),
            source: self.source.clone(),
            model: self.model,
            parameters: self.parameters.iter().zip(values).map(given).collect(),
            covariance: None,
            feedback: self.feedback.clone(),
            equations: self.model.equations(values)?,
            #[cfg(feature = "full")]
            reading: None,
            #[cfg(feature = "full")]
            set: self.set.clone(),
            notes: Vec::new(),
            warnings: Vec::new(),
        })
    }

    /// Hands the machine that the nonlinear equations of motion are of to a visitor, with the loops of feedback closed. The
    /// parameters of a shipped bicycle are those of the four bodies.
    ///
    /// # Errors
    /// If there are none, or none with the feedback.
    pub fn with_machine(&self, visitor: MachineVisitor) -> Result<(), WithoutMachine> {
        let bodies = WhippleMechanism::INFO;
        let model = if self.model.is_whipple() { Shipped::called(bodies.name).ok() } else { Some(self.model) };
        let model = model.ok_or(WithoutMachine::Equations)?;
        let values: Option<Vec<f64>> =
            model.info.parameters.iter().map(|parameter| self.value(parameter.name)).collect();
        let values = values.ok_or(WithoutMachine::Equations)?;
        if self.feedback.is_empty() {
            let found = model.with_machine(&values, visitor).unwrap_or(false);
            return if found { Ok(()) } else { Err(WithoutMachine::Equations) };
        }
        let mut closed = Err(WithoutMachine::Equations);
        let mut close = |machine: &dyn Machine| {
            let found = Closed::new(machine, self.info(), &self.feedback);
            closed = found.map(|machine| visitor(&machine)).map_err(WithoutMachine::Feedback);
        };
        // What is wrong with parameters was told when they were read.
        let _ = model.with_machine(&values, &mut close);
        closed
    }

    /// What follows from lean and steer, of the models whose parameters are those of the shipped bicycles.
    pub fn kinematics(&self) -> Option<WhippleMechanismKinematics> {
        let bicycle = WhippleMechanism::INFO;
        if !(self.model.is_whipple() || self.model.is_called(bicycle.name)) {
            return None;
        }
        let values: Option<Vec<f64>> = bicycle.parameters.iter().map(|parameter| self.value(parameter.name)).collect();
        Some(WhippleMechanism::from_slice(&values?).ok()?.kinematics())
    }

    /// The gravitational field strength in N/kg, if it is a parameter.
    pub fn gravity(&self) -> Option<f64> {
        self.parameters.get(self.info().gravity?).map(|given| given.value)
    }
}
