//! Accelerations by the nonlinear equations.

mod attributes;
pub mod forms;
mod program;

use std::fmt::Display;

use carvallo::motion::MotionInfo;
use carvallo::simulation::{Drive, Machine, Moving, SimulationError, State};
use carvallo::{FormulaInfo, ModelInfo};
use carvallo_design::feedback::{Closing, Law};
use carvallo_design::{Shipped, WHIPPLE};

use self::attributes::ByAttributes;
use crate::given::Accelerations;

/// The model whose nonlinear equations those of another one are the linear ones of.
#[derive(Clone, Debug)]
pub struct Nonlinear {
    model: &'static Shipped,
    motion: &'static MotionInfo,
    /// The linear one.
    info: &'static ModelInfo,
    /// Of each parameter of the model its place among those of the linear one.
    parameters: Vec<usize>,
    by_attributes: ByAttributes,
}

impl Nonlinear {
    /// Those of a model, which has all of their parameters: of the bicycle they are of its four bodies.
    pub fn new(info: &'static ModelInfo) -> Option<Self> {
        let is_whipple = info.name == WHIPPLE.info.name;
        let model = Shipped::called(if is_whipple { "WhippleMechanism" } else { info.name }).ok()?;
        let parameters = model.info.parameters.iter().map(|own| info.position(own.name)).collect::<Option<_>>()?;
        let mut motion = None;
        let set = model.info.sets.first()?;
        model.with_machine(set.values, &mut |machine| motion = Some(machine.info())).ok()?;
        let motion = motion?;
        let mut positions = info.coordinates.iter().map(|own| motion.position(own.name));
        let has_all = positions.all(|place| place.is_some_and(|at| motion.speed_of(at).is_some()));
        let by_attributes = ByAttributes::new(model.info, motion)?;
        has_all.then_some(Self { model, motion, info, parameters, by_attributes })
    }

    /// The attributes of the mechanism, and what they are made of and make.
    pub fn attributes(&self) -> &'static [FormulaInfo] {
        self.model.info.attributes
    }

    /// Whether they depend on an attribute, by its place.
    pub fn depend_on(&self, attribute: usize) -> bool {
        self.by_attributes.depend_on(attribute)
    }

    /// The accelerations of all coordinates of the linear equations.
    ///
    /// # Errors
    /// Why there are none, as where the wheels cannot all touch the ground.
    pub fn accelerations(
        &self,
        given: &Accelerations,
        parameters: &[f64],
        feedback: &[Law],
    ) -> Result<Vec<f64>, String> {
        let mut found = Err("the model has no nonlinear equations".to_owned());
        let mut of = |machine: &dyn Machine| found = self.of(machine, given, feedback);
        self.model.with_machine(&self.own(parameters), &mut of)?;
        found
    }

    /// The same of a mechanism with these attributes; `None` where there are none.
    pub fn with_attributes(
        &self,
        given: &Accelerations,
        attributes: &[f64],
        parameters: &[f64],
        feedback: &[Law],
    ) -> Option<Vec<f64>> {
        let machine = self.by_attributes.machine(self.motion, attributes, &self.own(parameters));
        self.of(&machine, given, feedback).ok()
    }

    fn own(&self, parameters: &[f64]) -> Vec<f64> {
        self.parameters.iter().map(|&at| parameters[at]).collect()
    }

    fn of(&self, machine: &dyn Moving, given: &Accelerations, feedback: &[Law]) -> Result<Vec<f64>, String> {
        let (info, names) = (machine.info(), self.info.coordinates.iter().map(|own| own.name));
        let positions: Vec<(&str, f64)> = names.clone().zip(given.positions.iter().copied()).collect();
        let mut rates: Vec<(&str, f64)> = names.clone().zip(given.rates.iter().copied()).collect();
        match Drive::of(machine) {
            Some(drive) => rates.push((info.positions[drive.position()].name, drive.rate(given.speed))),
            None if given.speed != 0.0 => return Err("nothing of it moves at a speed".to_owned()),
            None => {}
        }
        let State { positions, speeds } = State::new(machine, &positions, &rates).map_err(|error| match error {
            // No time passes.
            SimulationError::Motion { error, .. } => told(error),
            error => told(error),
        })?;
        let mut forces = vec![0.0; info.forces.len()];
        for (name, value) in names.clone().zip(&given.forces).filter(|(_, value)| **value != 0.0) {
            let place = info.forces.iter().position(|force| force.position == name);
            forces[place.ok_or_else(|| format!("nothing applies a force to {name}"))?] = *value;
        }
        if !feedback.is_empty() {
            let closing = Closing::new(machine, self.info, feedback)
                .map_err(|_| "the feedback cannot be a part of its nonlinear equations".to_owned())?;
            forces = closing.forces(machine, &positions, &speeds, &forces).map_err(told)?;
        }
        let mut accelerations = vec![0.0; positions.len()];
        machine.accelerations(&positions, &speeds, &forces, &mut accelerations).map_err(told)?;
        let place = |name: &str| info.position(name).ok_or_else(|| format!("there is no {name}"));
        names.map(|name| Ok(accelerations[place(name)?])).collect()
    }
}

fn told(error: impl Display) -> String {
    error.to_string()
}
