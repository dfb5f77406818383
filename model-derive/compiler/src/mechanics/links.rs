//! What acts inside the mechanism beside joints: springs and dampers between points, and rotors that spin at a constant rate.

use super::formulas::Formulas;
use super::matrix::Matrix;
use super::mechanism::{Link, Mechanism, Motion};
use super::vectors::{Vector, cross, dot, subtract, tidy};
use crate::symbolic::Form;

/// Adds the stiffness and the damping of links to those of all joints.
///
/// A link of no length, which has no direction, is left out; where that is so is found by [`find_short_links`].
pub fn add_links(
    mechanism: &Mechanism<Form>,
    formulas: &mut Formulas<'_>,
    stiffness: &mut Matrix,
    damping: &mut Matrix,
) {
    for (index, link) in mechanism.links.iter().enumerate() {
        let [from, to] = &link.points;
        let direction = tidy(&subtract(to, from));
        let square = dot(&direction, &direction).simplest();
        let length = formulas.name(format!("length_{index}"), &square.in_sines().root());
        let by_joint = find_elongation(mechanism, link, &direction, &length);
        for (matrix, factor) in [(&mut *stiffness, &link.stiffness), (&mut *damping, &link.damping)] {
            let Some(factor) = factor else { continue };
            for (entries, one) in matrix.iter_mut().zip(&by_joint).filter(|(_, one)| !one.is_nothing()) {
                for (entry, other) in entries.iter_mut().zip(&by_joint).filter(|(_, other)| !other.is_nothing()) {
                    *entry = &*entry + &(&(factor * one) * other);
                }
            }
        }
    }
}

/// The links between two points that are one.
pub fn find_short_links(mechanism: &Mechanism<Form>, formulas: &Formulas<'_>) -> Vec<usize> {
    let is_short = |link: &Link<Form>| {
        let [from, to] = &link.points;
        let direction = subtract(to, from);
        formulas.is_zero(&dot(&direction, &direction))
    };
    mechanism.links.iter().enumerate().filter(|(_, link)| is_short(link)).map(|(index, _)| index).collect()
}

/// How fast a link grows at unit rate of each joint.
fn find_elongation(mechanism: &Mechanism<Form>, link: &Link<Form>, direction: &Vector, length: &Form) -> Vec<Form> {
    let mut by_joint = vec![Form::number(0); mechanism.joints.len()];
    for (end, (joint, point)) in link.joints.iter().zip(&link.points).enumerate() {
        let Some(joint) = joint else { continue };
        for index in mechanism.path(*joint) {
            let joint = &mechanism.joints[index];
            let velocity = match joint.motion {
                Motion::Slides => joint.axis.clone(),
                Motion::Turns => cross(&joint.axis, &tidy(&subtract(point, &joint.point))),
            };
            let along = dot(direction, &velocity).simplest().over(length);
            let entry = &mut by_joint[index];
            *entry = if end == 0 { &*entry - &along } else { &*entry + &along };
        }
    }
    by_joint.iter().map(Form::simplest).collect()
}

/// Adds the moments that turn rotors of constant angular momentum: of two joints that turn one, `a · (b x h)`.
pub fn add_gyrostats(mechanism: &Mechanism<Form>, damping: &mut Matrix) {
    for (joint, momentum) in &mechanism.gyrostats {
        let turns = |index: &usize| mechanism.joints[*index].motion == Motion::Turns;
        let path: Vec<usize> = mechanism.path(*joint).filter(turns).collect();
        for &one in &path {
            for &other in &path {
                let [a, b] = [one, other].map(|index| &mechanism.joints[index].axis);
                let moment = dot(a, &cross(b, momentum)).simplest();
                damping[one][other] = &damping[one][other] + &moment;
            }
        }
    }
}
