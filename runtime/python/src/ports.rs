//! Inputs and outputs of one design by their names, and the units that they are shown in.

use carvallo_control::{Output, Ports, StateSpace};
use carvallo_design::units::Units;
use carvallo_design::{Design, Failure, Place, Problem};
use pyo3::prelude::*;

/// Between what, at which speed, and in which units.
#[derive(FromPyObject)]
pub struct Asked {
    /// In m/s.
    #[pyo3(item)]
    pub speed: f64,
    #[pyo3(item)]
    pub names: Names,
}

/// Inputs and outputs, with their units.
#[derive(FromPyObject)]
pub struct Names {
    /// By their names; without names all of them.
    #[pyo3(item)]
    inputs: Option<Vec<String>>,
    /// By their names; without names those that are usual.
    #[pyo3(item)]
    outputs: Option<Vec<String>>,
    /// As `deg,km/h`, or `si`.
    #[pyo3(item)]
    units: String,
}

impl Names {
    /// The design at a speed, in units of the SI.
    ///
    /// # Errors
    /// All names that there are none of; or that there are no equations of motion.
    pub fn space(&self, design: &Design, speed: f64, usual: fn(&Ports) -> Vec<Output>) -> Result<StateSpace, Failure> {
        let (inputs, outputs) = ports(design, self.inputs.as_deref(), self.outputs.as_deref(), usual)?;
        StateSpace::new(design, speed, &inputs, &outputs)
    }

    /// What quantities are shown in.
    ///
    /// # Errors
    /// What is no unit.
    pub fn units(&self) -> Result<Units, Failure> {
        Units::parse(&self.units)
    }

    /// The design at a speed, in the units that are asked for.
    ///
    /// # Errors
    /// As for the others.
    pub fn shown(&self, design: &Design, speed: f64, usual: fn(&Ports) -> Vec<Output>) -> Result<StateSpace, Failure> {
        let units = self.units()?;
        Ok(self.space(design, speed, usual)?.in_units(&|declared| units.of(declared)))
    }
}

impl Asked {
    /// The design at the speed, in the units that are asked for.
    ///
    /// # Errors
    /// What is wrong with names or units; or that there are no equations of motion.
    pub fn shown(&self, design: &Design, usual: fn(&Ports) -> Vec<Output>) -> Result<StateSpace, Failure> {
        self.names.shown(design, self.speed, usual)
    }
}

/// The inputs by their names, or all of them, and the outputs, or those that are usual.
///
/// # Errors
/// All names that there are none of, or that stand twice.
pub fn ports(
    design: &Design,
    inputs: Option<&[String]>,
    outputs: Option<&[String]>,
    usual: fn(&Ports) -> Vec<Output>,
) -> Result<(Vec<usize>, Vec<Output>), Failure> {
    let ports = Ports::of(design);
    let mut problems = Vec::new();
    let inputs = inputs.map(|names| named(names, |name| ports.input(name), &mut problems));
    let outputs = outputs.map(|names| named(names, |name| ports.output(name), &mut problems));
    if !problems.is_empty() {
        return Err(Failure::Input(problems));
    }
    Ok((inputs.unwrap_or_else(|| ports.all_inputs()), outputs.unwrap_or_else(|| usual(&ports))))
}

/// What names stand for, each once.
fn named<T: PartialEq>(
    names: &[String],
    find: impl Fn(&str) -> Result<T, String>,
    problems: &mut Vec<Problem>,
) -> Vec<T> {
    let mut found = Vec::new();
    for name in names {
        match find(name) {
            Ok(port) if found.contains(&port) => {
                problems.push(Problem { place: Place::Nowhere, message: format!("`{}` is named twice", name.trim()) });
            }
            Ok(port) => found.push(port),
            Err(message) => problems.push(Problem { place: Place::Nowhere, message }),
        }
    }
    found
}
