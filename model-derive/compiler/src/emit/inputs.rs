//! What the programs of the nonlinear equations of motion read.

use crate::model::Model;
use crate::motion::MotionModel;

/// The names of what a program of a state reads, for the names of its values: constants, positions, speeds and applied forces,
/// in the order of its inputs.
pub fn names_of_inputs(model: &Model, motion: &MotionModel, constants: usize) -> [Vec<String>; 4] {
    let positions = &motion.positions;
    [
        (0..constants).map(|index| format!("constant_{index}")).collect(),
        positions.iter().map(|position| position.name.clone()).collect(),
        motion.speeds().into_iter().map(|place| format!("{}_rate", positions[place].name)).collect(),
        model
            .kinematics
            .iter()
            .flat_map(|kinematics| &kinematics.applied)
            .map(|applied| applied.name.clone())
            .collect(),
    ]
}
