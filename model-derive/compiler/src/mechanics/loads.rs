//! The steady motion: what the wheels bear, and whether every force is balanced.

use super::Fault;
use super::composite::Composites;
use super::contact::Contact;
use super::elimination::Solved;
use super::formulas::Formulas;
use super::mechanism::Mechanism;
use crate::symbolic::Form;

/// The load of each wheel, upward and divided by gravity.
///
/// At every joint the loads balance the weight of what it moves, which acts along z.
pub fn loads(
    mechanism: &Mechanism<Form>,
    contacts: &[Contact<'_>],
    composites: &Composites<'_>,
    formulas: &mut Formulas<'_>,
) -> Result<Vec<Form>, Vec<Fault>> {
    let wheels: Vec<usize> = (0..contacts.len()).collect();
    let heights: Vec<Vec<Form>> = contacts.iter().map(|contact| contact.height().rates).collect();
    let mut solved = Solved::default();
    let mut faults = Vec::new();
    for joint in 0..mechanism.joints.len() {
        let lifted = heights.iter().map(|height| height[joint].clone());
        let row = lifted.chain([composites.moved(joint).momentum[2].clone()]).collect();
        let name = |wheel: usize, _| format!("load_{}", mechanism.joints[mechanism.wheels[wheel].spin].name);
        if let Err(left) = solved.add(row, &wheels, formulas, name)
            && let Some(force) = left.last().filter(|force| !formulas.is_zero(force))
        {
            faults.push(Fault::Unbalanced { joint, force: formulas.inserted(force) });
        }
    }
    let load = |wheel: &usize| {
        let row = solved.rows.iter().find(|(unknown, _)| unknown == wheel).map(|(_, row)| row);
        row.and_then(|row| row.last()).cloned().unwrap_or(Form::number(0))
    };
    if faults.is_empty() { Ok(wheels.iter().map(load).collect()) } else { Err(faults) }
}
