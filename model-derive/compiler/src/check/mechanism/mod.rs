//! A mechanism: its tree of bodies, and the joints that coordinates and forces name.

mod assemble;
mod attachments;
mod coordinates;
mod nonlinear;
mod tree;

pub use self::assemble::{Assembly, assemble};
pub use self::coordinates::axis_of;
pub use self::nonlinear::check_nonlinear;
pub use self::tree::{Role, Tree};

use crate::report::Report;
use crate::syntax::{Declaration, Mechanism};

/// The tree of a mechanism; what is wrong with it, or beside it in the declaration, is reported.
pub fn find_tree(declaration: &Declaration, mechanism: &Mechanism, report: &mut Report) -> Option<Tree> {
    if let Some(matrix) = declaration.matrices.first() {
        let message = format!(
            "`{0}` beside a mechanism, from which it follows: expected `assert {0} == …` to have both compared, or \
             `add {0} = …` for what the mechanism does not have",
            matrix.name.name()
        );
        report.error(matrix.span, message);
    }
    if let Some((whole, matrix)) = declaration.wholes.first() {
        let message = format!(
            "`{}` beside a mechanism, from which it follows: expected `add {} = …`, or another of its parts, for what the \
             mechanism does not have",
            whole.name(),
            whole.plain().name()
        );
        report.error(matrix.span, message);
    }
    let is_light = declaration.parameters.iter().all(|parameter| parameter.gravity.is_none());
    if let Some(wheel) = mechanism.wheels.first().filter(|_| is_light) {
        let message = format!(
            "nothing presses the wheel `{}` onto the ground: expected a parameter that is the field strength, `g: N/kg, \
             >= 0, gravity;`",
            wheel.name
        );
        report.error(&wheel.name, message);
    }
    tree::grow(mechanism, report)
}
