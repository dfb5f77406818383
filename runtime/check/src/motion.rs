//! Accelerations by the nonlinear equations.

use carvallo::ModelInfo;
use carvallo::simulation::{Drive, Machine, State};
use carvallo_design::feedback::{Closed, Law};
use carvallo_design::{Shipped, WHIPPLE};

use crate::given::Accelerations;

/// The model whose nonlinear equations those of another one are the linear ones of.
#[derive(Clone, Debug)]
pub struct Nonlinear {
    model: &'static Shipped,
    /// The linear one.
    info: &'static ModelInfo,
    /// Of each parameter of the model its place among those of the linear one.
    parameters: Vec<usize>,
}

impl Nonlinear {
    /// Those of a model, which has all of their parameters: of the bicycle they are of its four bodies.
    pub fn new(info: &'static ModelInfo) -> Option<Self> {
        let is_whipple = info.name == WHIPPLE.info.name;
        let model = Shipped::called(if is_whipple { "WhippleMechanism" } else { info.name }).ok()?;
        let parameters = model.info.parameters.iter().map(|own| info.position(own.name)).collect::<Option<_>>()?;
        let own = Self { model, info, parameters };
        let mut has_all = false;
        let set = model.info.sets.first()?;
        let found = model.with_machine(set.values, &mut |machine| {
            let positions = info.coordinates.iter().map(|own| machine.info().position(own.name));
            has_all = positions.into_iter().all(|place| place.is_some_and(|at| machine.info().speed_of(at).is_some()));
        });
        (found == Ok(true) && has_all).then_some(own)
    }

    /// The accelerations of all coordinates of the linear equations; `None` where there are none, as where the wheels cannot all
    /// touch the ground.
    pub fn accelerations(&self, given: &Accelerations, parameters: &[f64], feedback: &[Law]) -> Option<Vec<f64>> {
        let own: Vec<f64> = self.parameters.iter().map(|&at| parameters[at]).collect();
        let mut found = None;
        let mut of = |machine: &dyn Machine| {
            found = match feedback.is_empty() {
                true => self.of(machine, given),
                false => Closed::new(machine, self.info, feedback).ok().and_then(|closed| self.of(&closed, given)),
            };
        };
        self.model.with_machine(&own, &mut of).ok()?;
        found
    }

    fn of(&self, machine: &dyn Machine, given: &Accelerations) -> Option<Vec<f64>> {
        let (info, names) = (machine.info(), self.info.coordinates.iter().map(|own| own.name));
        let positions: Vec<(&str, f64)> = names.clone().zip(given.positions.iter().copied()).collect();
        let mut rates: Vec<(&str, f64)> = names.clone().zip(given.rates.iter().copied()).collect();
        match Drive::of(machine) {
            Some(drive) => rates.push((info.positions[drive.position()].name, drive.rate(given.speed))),
            None if given.speed != 0.0 => return None,
            None => {}
        }
        let State { positions, speeds } = State::new(machine, &positions, &rates).ok()?;
        let mut forces = vec![0.0; info.forces.len()];
        for (name, value) in names.clone().zip(&given.forces).filter(|(_, value)| **value != 0.0) {
            let place = ["T", "F", ""].iter().find_map(|letter| info.force(&format!("{letter}{name}")))?;
            forces[place] = *value;
        }
        let mut accelerations = vec![0.0; positions.len()];
        machine.accelerations(&positions, &speeds, &forces, &mut accelerations).ok()?;
        names.map(|name| Some(accelerations[info.position(name)?])).collect()
    }
}
