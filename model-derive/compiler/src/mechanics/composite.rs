//! Composite bodies: for each joint the mass of all that it moves.

use super::formulas::Formulas;
use super::mechanism::{Mechanism, Motion};
use super::vectors::{AXES, Vector, add, cross, dot, scale, subtract, tidy, zero};
use crate::symbolic::Form;

/// Mass, static moment and inertia of rigid bodies about a point.
#[derive(Clone)]
struct Composite {
    mass: Form,
    moment: Vector,
    inertia: [Vector; 3],
}

/// What a joint moves when it moves at unit rate.
pub struct Moved {
    /// The momentum.
    pub momentum: Vector,
    /// The angular momentum about the joint's point.
    angular: Vector,
}

/// The composites of a mechanism whose axes have unit length.
pub struct Composites<'a> {
    mechanism: &'a Mechanism<Form>,
    moved: Vec<Moved>,
}

impl<'a> Composites<'a> {
    pub fn new(mechanism: &'a Mechanism<Form>, formulas: &mut Formulas<'_>) -> Self {
        let count = mechanism.joints.len();
        let mut composites: Vec<Option<Composite>> = vec![None; count];
        let mut moved: Vec<Moved> = Vec::new();
        // Children come behind their parents.
        for index in (0..count).rev() {
            let composite = combine_bodies(mechanism, index, &composites, formulas);
            moved.push(find_moved(mechanism, index, &composite, formulas));
            composites[index] = Some(composite);
        }
        moved.reverse();
        Self { mechanism, moved }
    }

    pub fn moved(&self, joint: usize) -> &Moved {
        &self.moved[joint]
    }

    /// An entry of the mass matrix of all joints.
    pub fn mass(&self, one: usize, other: usize) -> Form {
        let Some(far) = self.mechanism.farther(one, other) else { return Form::number(0) };
        let near = one.min(other);
        let (joint, Moved { momentum, angular }) = (&self.mechanism.joints[near], &self.moved[far]);
        let seen = match joint.motion {
            Motion::Slides => momentum.clone(),
            Motion::Turns => {
                let arm = tidy(&subtract(&self.mechanism.joints[far].point, &joint.point));
                add(angular, &cross(&arm, momentum))
            }
        };
        dot(&joint.axis, &seen)
    }
}

/// All that a joint moves, about the joint's point.
fn combine_bodies(
    mechanism: &Mechanism<Form>,
    index: usize,
    composites: &[Option<Composite>],
    formulas: &mut Formulas<'_>,
) -> Composite {
    let point = &mechanism.joints[index].point;
    let mut parts: Vec<Composite> = Vec::new();
    for body in mechanism.bodies.iter().filter(|body| body.joint == index) {
        let own = Composite { mass: body.mass.clone(), moment: zero(), inertia: body.inertia.clone() };
        parts.push(own.about(&tidy(&subtract(&body.centre, point))));
    }
    for (child, composite) in composites.iter().enumerate().skip(index + 1) {
        if let (true, Some(composite)) = (mechanism.joints[child].parent == Some(index), composite) {
            parts.push(composite.about(&tidy(&subtract(&mechanism.joints[child].point, point))));
        }
    }
    let sum = parts.into_iter().reduce(|sum, part| Composite {
        mass: &sum.mass + &part.mass,
        moment: add(&sum.moment, &part.moment),
        inertia: [0, 1, 2].map(|row| add(&sum.inertia[row], &part.inertia[row])),
    });
    let sum =
        sum.unwrap_or_else(|| Composite { mass: Form::number(0), moment: zero(), inertia: [zero(), zero(), zero()] });
    let of = mechanism.moved(index);
    let mut entry = |row: usize, column: usize| {
        formulas.name(format!("J{}{}_{of}", AXES[row], AXES[column]), &sum.inertia[row][column])
    };
    let [xx, xy, xz, yy, yz, zz] =
        [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)].map(|(row, column)| entry(row, column));
    let inertia = [[xx, xy.clone(), xz.clone()], [xy, yy, yz.clone()], [xz, yz, zz]];
    let moment = [0, 1, 2].map(|axis| formulas.name(format!("S{}_{of}", AXES[axis]), &sum.moment[axis]));
    Composite { mass: formulas.name(format!("m_{of}"), &sum.mass), moment, inertia }
}

impl Composite {
    /// About another point, from which the present one is at `arm` (Huygens and Steiner).
    fn about(&self, arm: &Vector) -> Self {
        let moment = add(&self.moment, &scale(&self.mass, arm));
        // From r r to (r + d) (r + d) it grows by d r + r d + d d: with half of the last one on either side.
        let half = add(&self.moment, &scale(&self.mass, &arm.each_ref().map(|a| a.over(&Form::number(2)))));
        let grown = |a: usize, b: usize| &(&arm[a] * &half[b]) + &(&half[a] * &arm[b]);
        let inertia = [0, 1, 2].map(|row| {
            [0, 1, 2].map(|column| {
                let [next, last] = [(row + 1) % 3, (row + 2) % 3];
                match row == column {
                    true => &(&self.inertia[row][row] + &grown(next, next)) + &grown(last, last),
                    false => &self.inertia[row][column] - &grown(row, column),
                }
            })
        });
        Self { mass: self.mass.clone(), moment, inertia }
    }
}

/// What a joint moves at unit rate.
fn find_moved(mechanism: &Mechanism<Form>, index: usize, composite: &Composite, formulas: &mut Formulas<'_>) -> Moved {
    let joint = &mechanism.joints[index];
    let (momentum, angular) = match joint.motion {
        Motion::Slides => (scale(&composite.mass, &joint.axis), cross(&composite.moment, &joint.axis)),
        Motion::Turns => {
            let columns = [0, 1, 2].map(|axis| scale(&joint.axis[axis], &composite.inertia[axis]));
            let angular = columns.iter().fold(zero(), |sum, column| add(&sum, column));
            (cross(&joint.axis, &composite.moment), angular)
        }
    };
    let of = &joint.name;
    let momentum = [0, 1, 2].map(|axis| formulas.name(format!("p{}_{of}", AXES[axis]), &momentum[axis]));
    let angular = [0, 1, 2].map(|axis| formulas.name(format!("h{}_{of}", AXES[axis]), &angular[axis]));
    Moved { momentum, angular }
}

/// A wheel's spin momentum divided by the forward speed, for each joint that carries it: those of its wheels together.
pub fn find_spin_momenta(mechanism: &Mechanism<Form>, formulas: &mut Formulas<'_>) -> Vec<Form> {
    let of_wheels: Vec<Form> = mechanism
        .wheels
        .iter()
        .map(|wheel| {
            formulas.name(format!("h_{}", mechanism.joints[wheel.spin].name), &wheel.axial.over(&wheel.radius))
        })
        .collect();
    (0..mechanism.joints.len())
        .map(|joint| {
            let carried = mechanism.wheels.iter().zip(&of_wheels);
            let carried = carried
                .filter(|(wheel, _)| wheel.spin != joint && mechanism.path(wheel.spin).any(|above| above == joint));
            let sum = carried.fold(Form::number(0), |sum, (_, momentum)| &sum + momentum);
            formulas.name(format!("h_wheels_{}", mechanism.moved(joint)), &sum)
        })
        .collect()
}
