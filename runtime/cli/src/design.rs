//! A machine as it was given, with its equations of motion: what everything is computed from.

use carvallo::ModelInfo;

use crate::model::{Equations, Shipped};

/// A machine as it was given by its parameters, with its equations of motion.
#[derive(Debug)]
pub struct Design {
    /// The name of the machine, or of the file.
    pub name: String,
    /// What it is.
    pub kind: Option<String>,
    /// Where the parameters come from.
    pub source: Option<String>,
    /// The model that the parameters are for.
    pub model: &'static Shipped,
    /// The parameters in the order of the model.
    pub parameters: Vec<Given>,
    /// What the model makes of them.
    pub equations: Box<dyn Equations>,
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

impl Design {
    /// What the model tells about itself.
    pub fn info(&self) -> &'static ModelInfo {
        self.model.info
    }

    /// Its name; for other models than that of the bicycles, after the name of the model.
    pub fn title(&self) -> String {
        if self.model.is_whipple() { self.name.clone() } else { format!("{} {}", self.info().name, self.name) }
    }

    /// The value of the parameter called `name`.
    pub fn value(&self, name: &str) -> Option<f64> {
        self.parameters.get(self.info().position(name)?).map(|given| given.value)
    }

    /// The values of all parameters.
    pub fn values(&self) -> Vec<f64> {
        self.parameters.iter().map(|given| given.value).collect()
    }

    /// The gravitational field strength in N/kg, if it is a parameter.
    pub fn gravity(&self) -> Option<f64> {
        self.parameters.get(self.info().gravity?).map(|given| given.value)
    }
}
