//! The side forces of tyres that slip, on the motions of all joints.
//!
//! The rim of a wheel slips sideways with the velocity `w = rates · z' - v positions · z`; the side force of its tyre is
//! `-cornering w/v + camber lean`, and acts `trail` behind the contact point. Where it relaxes it is `-k e`, with the
//! deflection e of a tyre of the stiffness `k = cornering/relaxation`:
//!
//! ```text
//! k e' + v (k/relaxation) e = k w - v k (camber/cornering) lean
//! ```

use super::contact::{Condition, Contact};
use super::formulas::Formulas;
use super::matrix::{self, Matrix};
use super::mechanism::{Mechanism, Slip, Wheel};
use crate::symbolic::Form;

/// What tyres add to the matrices of all joints: what multiplies rates over the speed, rates, positions, and positions times
/// the speed.
pub struct SideForces {
    pub over_speed: Matrix,
    pub damping: Matrix,
    pub stiffness: Matrix,
    pub by_speed: Matrix,
}

impl SideForces {
    /// `loads` are those of the wheels along z, divided by gravity.
    pub fn new(mechanism: &Mechanism<Form>, contacts: &[Contact<'_>], loads: &[Form], formulas: &Formulas<'_>) -> Self {
        let count = mechanism.joints.len();
        let zeros = || matrix::new(count, count, |_, _| Form::number(0));
        let mut forces = Self { over_speed: zeros(), damping: zeros(), stiffness: zeros(), by_speed: zeros() };
        for (Wheel { slip, .. }, contact) in mechanism.wheels.iter().zip(contacts) {
            if let Some(slip) = slip {
                forces.add(&with_loads(slip, mechanism, loads, formulas), contact);
            }
        }
        forces
    }

    fn add(&mut self, Slip { cornering, camber, trail, relaxation }: &Slip<Form>, contact: &Contact<'_>) {
        let Condition { rates, positions } = contact.sideways();
        let lean = contact.lean();
        let moved: Vec<Form> = match trail {
            // What turns the wheel about the vertical moves the point behind it to the left.
            Some(trail) => rates.iter().zip(&positions).map(|(rate, turn)| rate - &(trail * turn)).collect(),
            None => rates.clone(),
        };
        let Some((length, deflection)) = relaxation else {
            add_products(&mut self.over_speed, &moved, &rates, cornering);
            add_products(&mut self.stiffness, &moved, &positions, &-cornering);
            if let Some(camber) = camber {
                add_products(&mut self.stiffness, &moved, &lean, &-camber);
            }
            return;
        };
        let stiffness = cornering.over(length);
        let add = |matrix: &mut Matrix, column: usize, form: &Form| {
            let entry = &mut matrix[*deflection][column];
            *entry = &*entry + form;
        };
        add(&mut self.damping, *deflection, &stiffness);
        add(&mut self.by_speed, *deflection, &stiffness.over(length));
        for joint in 0..rates.len() {
            add(&mut self.damping, joint, &-&(&stiffness * &rates[joint]));
            add(&mut self.by_speed, joint, &(&stiffness * &positions[joint]));
            if let Some(camber) = camber {
                add(&mut self.by_speed, joint, &(&camber.over(length) * &lean[joint]));
            }
        }
        for (joint, moved) in moved.iter().enumerate() {
            let entry = &mut self.stiffness[joint][*deflection];
            *entry = &*entry + &(&stiffness * moved);
        }
    }
}

/// The same with the loads in the place of the parameters that stand for them. In the reference motion no tyre slips or leans,
/// so what changes a load changes no side force in the first order.
fn with_loads(slip: &Slip<Form>, mechanism: &Mechanism<Form>, loads: &[Form], formulas: &Formulas<'_>) -> Slip<Form> {
    let (Some(first), Some(gravity)) = (mechanism.loads, mechanism.gravity) else { return slip.clone() };
    let gravity = formulas.parameter(gravity);
    let settled = |form: &Form| {
        loads.iter().enumerate().fold(form.clone(), |form, (wheel, load)| {
            form.replace(&formulas.parameter(first + wheel), &-&(&gravity * load))
        })
    };
    Slip { cornering: settled(&slip.cornering), camber: slip.camber.as_ref().map(settled), ..slip.clone() }
}

/// Adds the products of the entries of a column and a row, times a factor.
fn add_products(matrix: &mut Matrix, column: &[Form], row: &[Form], factor: &Form) {
    for (entries, left) in matrix.iter_mut().zip(column).filter(|(_, left)| !left.is_nothing()) {
        for (entry, right) in entries.iter_mut().zip(row).filter(|(_, right)| !right.is_nothing()) {
            *entry = &*entry + &(&(factor * left) * right);
        }
    }
}
