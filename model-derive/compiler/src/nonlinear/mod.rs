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

mod equations;
mod forces;
mod frames;
mod inertia;
mod layout;
mod movement;
mod quantity;
mod rolling;
mod solve;
mod split;
mod vectors;
mod wheels;

pub use self::layout::{Layout, Undetermined};

use self::equations::Equations;
use self::quantity::{Arithmetic, Quantity};
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
}

impl MotionPrograms {
    /// All of them.
    pub fn all(&self) -> [&Program; 7] {
        let Self { constants, closure, rates, derivatives, accelerations, energy, contact_forces } = self;
        [constants, closure, rates, derivatives, accelerations, energy, contact_forces]
    }
}

/// Derives the programs.
pub fn compile(machine: &Machine, layout: &Layout) -> MotionPrograms {
    let arithmetic = Arithmetic::new(
        machine.parameters
            + layout.positions.len()
            + layout.conditions.independent.len()
            + machine.mechanism.forces.len(),
    );
    let outputs = Equations::new(machine, layout, &arithmetic).outputs();
    let all: Vec<Value> = outputs.iter().flatten().copied().collect();
    let Split { constants, programs } = split(&arithmetic.program(&all), machine.parameters, &outputs);
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
    }
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
