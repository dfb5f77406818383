//! The programs of accelerations at a state alone, without what a simulation needs beside them.

use super::equations::Equations;
use super::quantity::Arithmetic;
use super::split::{Split, split};
use super::{Layout, Machine, count_inputs};
use crate::program::Program;

/// Each reads what the first computes from the parameters, and behind it positions, speeds and applied forces.
#[derive(Debug)]
pub struct AccelerationPrograms {
    /// What does not depend on the state.
    pub constants: Program,
    /// As [`MotionPrograms::closure`](super::MotionPrograms::closure).
    pub closure: Program,
    /// The rates of all positions, and then their second derivatives.
    pub accelerations: Program,
}

/// Derives them.
pub fn compile_accelerations(machine: &Machine, layout: &Layout) -> AccelerationPrograms {
    let inputs = count_inputs(machine, layout);
    let arithmetic = Arithmetic::new(inputs);
    let [closure, mut rates, _, accelerations, ..] = Equations::new(machine, layout, &arithmetic).outputs();
    rates.extend(accelerations);
    let program = Program { parameters: inputs, ..arithmetic.program(&[]) };
    let Split { constants, programs } = split(&program, machine.parameters, &[closure, rates], 0);
    let [closure, accelerations] =
        <[Program; 2]>::try_from(programs).unwrap_or_else(|_| unreachable!("a program for each"));
    AccelerationPrograms { constants, closure, accelerations }
}
