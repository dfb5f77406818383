//! What keeps a mechanism from having nonlinear equations.

use proc_macro2::Span;

use crate::report::Report;
use crate::syntax::{Declaration, Freedom};

/// Reports what a declaration has that nonlinear equations cannot; they are asked for at `span`.
pub fn check_nonlinear(declaration: &Declaration, span: Span, report: &mut Report) {
    let Some(mechanism) = &declaration.mechanism else {
        let message = "`nonlinear` without a mechanism: expected a `mechanism { … }`, since formulas of matrices are only \
                       those of small motions";
        report.error(span, message);
        return;
    };
    if let Some(wheel) = mechanism.wheels.iter().find(|wheel| wheel.slip.is_some()) {
        let message = format!(
            "the wheel `{}` slips, and `nonlinear` is for wheels that roll: expected no `cornering`, or no `nonlinear`",
            wheel.name
        );
        report.error(&wheel.name, message);
    }
    if let Some(matrix) = declaration.added.first() {
        let message = format!(
            "`add {}` beside `nonlinear`: what is added to a matrix is only known for small motions; expected it as a part \
             of the mechanism",
            matrix.name.name()
        );
        report.error(matrix.span, message);
    }
    if let Some(feedback) = declaration.feedback.first() {
        let message = format!(
            "`feedback {0}` beside `nonlinear`, which has no speed that it could be given at: expected a `force {0} on {1};`, to \
             which the one who simulates gives its value",
            feedback.name, feedback.on
        );
        report.error(&feedback.name, message);
    }
    if let Some(held) = mechanism.held {
        let message =
            "`hold forward` beside `nonlinear`, whose motion may speed up and slow down: expected one of both";
        report.error(held, message);
    }
    for force in &mechanism.forces {
        let mut freedoms = mechanism.free.iter().flat_map(|free| &free.names);
        let freedom = freedoms.find(|(_, name)| *name == force.on).map(|(freedom, _)| *freedom);
        if let Some(freedom @ (Freedom::Forward | Freedom::Lateral | Freedom::Vertical)) = freedom {
            let message = format!(
                "the force `{}` is on the {} of the machine, of which `nonlinear` does not know where it acts: expected a \
                 force or torque on a rotation, a joint or a wheel",
                force.name,
                freedom.noun()
            );
            report.error(&force.on, message);
        }
    }
    if mechanism.free.is_empty() {
        return;
    }
    if mechanism.wheels.is_empty() {
        let message = "`nonlinear` for a free body without a wheel: expected a wheel, on which the machine rolls";
        report.error(span, message);
    }
    for link in &mechanism.links {
        if let Some((ground, _)) = link.ends.iter().find(|(name, _)| name == "ground") {
            let message = format!(
                "the link `{}` ties the machine to the ground, over which `nonlinear` lets it roll away: expected two bodies",
                link.name
            );
            report.error(ground, message);
        }
    }
}
