//! The matrices of all joints, before the contacts tie these to each other.

use super::Fault;
use super::composite::{Composites, find_spin_momenta};
use super::contact::{Contact, gyroscopic};
use super::formulas::Formulas;
use super::links::{add_gyrostats, add_links};
use super::loads::find_loads;
use super::matrix::{self, Matrix};
use super::mechanism::{Mechanism, Motion};
use super::slip::SideForces;
use super::vectors::cross;
use crate::symbolic::Form;

/// The matrices of all joints, as if there were no contacts but for their loads.
pub struct Unreduced {
    pub mass: Matrix,
    /// To be multiplied by the speed.
    pub spin: Matrix,
    /// To be multiplied by gravity.
    pub weight: Matrix,
    /// To be divided by the speed.
    pub slip: Matrix,
    pub damping: Matrix,
    pub stiffness: Matrix,
    /// Stiffness to be multiplied by the speed.
    pub relaxation: Matrix,
}

impl Unreduced {
    /// Beside them the forces of gravity that nothing balances.
    pub fn new(
        mechanism: &Mechanism<Form>,
        contacts: &[Contact<'_>],
        formulas: &mut Formulas<'_>,
    ) -> (Self, Vec<Fault>) {
        let count = mechanism.joints.len();
        let composites = Composites::new(mechanism, formulas);
        let (loads, unbalanced) = match mechanism.gravity {
            Some(_) => find_loads(mechanism, contacts, &composites, formulas),
            None => (vec![Form::number(0); contacts.len()], Vec::new()),
        };
        let momenta = find_spin_momenta(mechanism, formulas);
        let name = |what: &str, row: usize, column: usize| {
            format!("{what}_{}_{}", mechanism.joints[row].name, mechanism.joints[column].name)
        };
        let mass = matrix::symmetric(count, |row, column| {
            formulas.name(name("M", row, column), &composites.mass(row, column))
        });
        let weight = find_weight(mechanism, contacts, &composites, &loads, formulas);
        let spin = matrix::new(count, count, |row, column| match mechanism.farther(row, column) {
            Some(far) => (&momenta[far] * &gyroscopic(mechanism, row, column)).simplest(),
            None => Form::number(0),
        });
        let diagonal = |values: Vec<Option<&Form>>| {
            let value = |joint: usize| values[joint].cloned().unwrap_or(Form::number(0));
            matrix::new(count, count, |row, column| if row == column { value(row) } else { Form::number(0) })
        };
        let damping = diagonal(mechanism.joints.iter().map(|joint| joint.damping.as_ref()).collect());
        let stiffness = diagonal(mechanism.joints.iter().map(|joint| joint.stiffness.as_ref()).collect());
        let SideForces { over_speed, damping: by_rates, stiffness: by_positions, by_speed } =
            SideForces::new(mechanism, contacts, &loads, formulas);
        let (mut damping, mut stiffness) = (matrix::plus(&damping, &by_rates), matrix::plus(&stiffness, &by_positions));
        add_links(mechanism, formulas, &mut stiffness, &mut damping);
        add_gyrostats(mechanism, &mut damping);
        (Self { mass, spin, weight, slip: over_speed, damping, stiffness, relaxation: by_speed }, unbalanced)
    }
}

/// What is to be multiplied by gravity, with these loads of the wheels.
pub fn find_weight(
    mechanism: &Mechanism<Form>,
    contacts: &[Contact<'_>],
    composites: &Composites<'_>,
    loads: &[Form],
    formulas: &mut Formulas<'_>,
) -> Matrix {
    matrix::symmetric(mechanism.joints.len(), |row, column| {
        if mechanism.gravity.is_none() {
            return Form::number(0);
        }
        let lifted = contacts.iter().zip(loads).map(|(contact, load)| load * &contact.curvature(row, column));
        let form = lifted.fold(sinking(mechanism, composites, row, column), |sum, lifted| &sum - &lifted);
        formulas.name(format!("K_{}_{}", mechanism.joints[row].name, mechanism.joints[column].name), &form)
    })
}

/// The second derivative of the potential energy of gravity, divided by it, with respect to two joints.
fn sinking(mechanism: &Mechanism<Form>, composites: &Composites<'_>, row: usize, column: usize) -> Form {
    let near = &mechanism.joints[row.min(column)];
    match mechanism.farther(row, column) {
        Some(far) if near.motion == Motion::Turns => -&cross(&near.axis, &composites.moved(far).momentum)[2],
        _ => Form::number(0),
    }
}
