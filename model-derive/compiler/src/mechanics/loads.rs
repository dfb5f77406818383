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
/// At every joint the loads balance the weight of what it moves, which acts along z. Only a spring at a coordinate may
/// have a force of its own: whatever it holds in the reference configuration, a constant force at a joint makes no
/// stiffness there. Beside them the forces that nothing balances.
pub fn find_loads(
    mechanism: &Mechanism<Form>,
    contacts: &[Contact<'_>],
    composites: &Composites<'_>,
    formulas: &mut Formulas<'_>,
) -> (Vec<Form>, Vec<Fault>) {
    let wheels: Vec<usize> = (0..contacts.len()).collect();
    let heights: Vec<Vec<Form>> = contacts.iter().map(|contact| contact.height().rates).collect();
    let holds = |joint: &usize| mechanism.joints[*joint].stiffness.is_some() && mechanism.coordinates.contains(joint);
    let joints: Vec<usize> = (0..mechanism.joints.len()).filter(|joint| !holds(joint)).collect();
    let row = |joint: &usize| {
        let lifted = heights.iter().map(|height| height[*joint].clone());
        let row = lifted.chain([composites.moved(*joint).momentum[2].clone()]).collect();
        (row, &wheels[..])
    };
    let name = |wheel: usize, _| format!("load_{}", mechanism.joints[mechanism.wheels[wheel].spin].name);
    let mut solved = Solved::default();
    let left = solved.add(joints.iter().map(row).collect(), formulas, name);
    let force = |(row, left): &(usize, Vec<Form>)| {
        let force = left.last().filter(|force| !formulas.is_zero(force))?;
        Some(Fault::Unbalanced { joint: joints[*row], force: formulas.inserted(force) })
    };
    let load = |wheel: &usize| solved.get(*wheel).and_then(|row| row.last()).cloned().unwrap_or(Form::number(0));
    (wheels.iter().map(load).collect(), left.iter().filter_map(force).collect())
}
