//! The nonlinear equations of motion of a mechanism, exact, as straight-line programs.
//!
//! Positions and rates go outward along the tree of joints, forces come inward, each in the axes of its own body. Of a
//! machine on wheels the first wheel leads: the velocity of its contact point is zero, so that all motion is about that
//! point, and neither the place on the ground nor the heading occurs. The conditions of the other wheels are linear in the
//! rates; they are solved for those that are no speeds. The mass matrix of the speeds comes from composite bodies about
//! the contact point and is symmetric and positive definite.
//!
//! There is a division by what conditions and mass matrix are solved with, and by the sine of the angle between the axle of
//! a wheel and the vertical, if it is steered: nothing else, so that nothing happens at zero lean, steer or speed.

mod accelerations;
mod chain;
mod equations;
mod forces;
mod frames;
mod inertia;
mod layout;
mod linearization;
mod movement;
mod quantity;
mod rolling;
mod solve;
mod split;
mod vectors;
mod wheels;

pub use self::accelerations::{AccelerationPrograms, compile_accelerations};
pub use self::layout::{Layout, Undetermined};

use self::equations::Equations;
use self::linearization::Linearized;
use self::quantity::{Arithmetic, Quantity};
use self::solve::Matrix;
use self::split::{Split, split};
use crate::formula::Formula;
use crate::mechanics::Mechanism;
use crate::program::{Program, Value};

/// What the equations are derived from.
#[derive(Debug)]
pub struct Machine {
    /// With its parts in formulas.
    pub mechanism: Mechanism<Formula>,
    /// For each joint whether its axis is proved to have unit length.
    pub unit_axes: Vec<bool>,
    /// The field strength.
    pub gravity: Option<usize>,
    /// The number of parameters.
    pub parameters: usize,
    /// The definitions of the model that formulas refer to.
    pub definitions: Vec<Formula>,
}

/// The programs of a machine, each of what the first computes from the parameters, and behind it of positions, speeds
/// and applied forces.
#[derive(Debug)]
pub struct MotionPrograms {
    /// What does not depend on the state.
    pub constants: Program,
    /// How far the lowest points of the wheels behind the first are below the ground, and then the steps of Newton's method
    /// for the positions that they determine.
    pub closure: Program,
    /// Of all positions.
    pub rates: Program,
    /// The same, and then the rates of the speeds.
    pub derivatives: Program,
    /// Second derivatives of all positions.
    pub accelerations: Program,
    /// Kinetic and potential.
    pub energy: Program,
    /// For each wheel three components.
    pub contact_forces: Program,
    /// If they are asked for.
    pub partials: Option<PartialPrograms>,
}

impl MotionPrograms {
    /// All of them.
    pub fn all(&self) -> impl Iterator<Item = &Program> {
        let Self { constants, closure, rates, derivatives, accelerations, energy, contact_forces, partials } = self;
        let partials = partials.iter().flat_map(|partials| [&partials.by_state, &partials.by_parameters]);
        [constants, closure, rates, derivatives, accelerations, energy, contact_forces].into_iter().chain(partials)
    }
}

/// Programs of derivatives along motions that the conditions leave, for each of the values of
/// [`MotionPrograms::derivatives`].
#[derive(Debug)]
pub struct PartialPrograms {
    /// With respect to all positions, of which those that depend on others have zeros, then to speeds and forces.
    pub by_state: Program,
    /// With respect to the parameters.
    pub by_parameters: Program,
}

/// Derives the programs, and those of the derivatives if they are asked for.
pub fn compile(machine: &Machine, layout: &Layout, with_partials: bool) -> MotionPrograms {
    let speeds = layout.conditions.independent.len();
    let inputs = count_inputs(machine, layout);
    let arithmetic = Arithmetic::new(inputs);
    let equations = Equations::new(machine, layout, &arithmetic);
    let mut outputs: Vec<Vec<Value>> = equations.outputs().into();
    let speed_rates = outputs[2][layout.positions.len()..].to_vec();
    // Further inputs stand for the rates of the speeds where these are held constant.
    let held: Vec<Quantity<'_>> = (inputs..inputs + speeds).map(|index| arithmetic.input(index)).collect();
    if with_partials {
        let partials = Linearized::new(&arithmetic, &equations, &held).find_partials(machine.parameters);
        let values = |matrix: Matrix<'_>| matrix.iter().flatten().map(|entry| entry.value).collect();
        outputs.extend([partials.by_state, partials.by_parameters].map(values));
    }
    let release = |value: Value| {
        let place = held.iter().position(|held| held.value == value);
        place.map_or(value, |place| speed_rates[place])
    };
    outputs.iter_mut().flatten().for_each(|value| *value = release(*value));
    let mut program = Program { parameters: inputs, ..arithmetic.program(&[]) };
    program.instructions.iter_mut().for_each(|instruction| *instruction = instruction.map(release));
    let Split { constants, programs } = split(&program, machine.parameters, &outputs, 2 * usize::from(with_partials));
    let mut programs = programs.into_iter();
    let mut next = || programs.next().unwrap_or_else(|| unreachable!("a program for each"));
    MotionPrograms {
        constants,
        closure: next(),
        rates: next(),
        derivatives: next(),
        accelerations: next(),
        energy: next(),
        contact_forces: next(),
        partials: with_partials.then(|| PartialPrograms { by_state: next(), by_parameters: next() }),
    }
}

/// The parameters, and behind them positions, speeds and applied forces.
fn count_inputs(machine: &Machine, layout: &Layout) -> usize {
    let state = layout.positions.len() + layout.conditions.independent.len();
    machine.parameters + state + machine.mechanism.forces.len()
}

/// The mechanism in quantities, with axes of unit length.
fn instantiate<'a>(machine: &Machine, arithmetic: &'a Arithmetic) -> Mechanism<Quantity<'a>> {
    let mut definitions = Vec::new();
    for formula in &machine.definitions {
        definitions.push(arithmetic.formula(formula, &definitions));
    }
    let Ok(mut mechanism) =
        machine.mechanism.map(|formula| Ok::<_, std::convert::Infallible>(arithmetic.formula(formula, &definitions)));
    for (joint, is_unit) in mechanism.joints.iter_mut().zip(&machine.unit_axes) {
        if !is_unit {
            let length = vectors::dot(joint.axis, joint.axis).sqrt();
            joint.axis = joint.axis.map(|component| component / length);
        }
    }
    mechanism
}
