//! Wheels on the ground: what a wheel that rolls without slip says of the rates of the joints.

use super::mechanism::{Mechanism, Motion, Wheel};
use super::vectors::{Vector, cross, subtract, tidy, zero};
use crate::symbolic::Form;

/// A condition on the rates of the joints, `rates · z' = v positions · z`, to first order.
#[derive(Clone)]
pub struct Condition {
    /// By joint.
    pub rates: Vec<Form>,
    /// By joint.
    pub positions: Vec<Form>,
}

/// A wheel's contact with the ground.
pub struct Contact<'a> {
    mechanism: &'a Mechanism<Form>,
    wheel: &'a Wheel<Form>,
    /// For each joint the velocity of what carries the wheel, at the contact point and at unit rate.
    velocities: Vec<Vector>,
    /// For each joint how what carries the wheel turns, at unit rate.
    rotations: Vec<Vector>,
}

impl<'a> Contact<'a> {
    /// On the ground below the centre of the wheel.
    pub fn new(mechanism: &'a Mechanism<Form>, wheel: &'a Wheel<Form>) -> Self {
        Self::at(Form::number(0), mechanism, wheel)
    }

    /// Below the centre of the wheel by its radius, wherever that is.
    pub fn below(mechanism: &'a Mechanism<Form>, wheel: &'a Wheel<Form>) -> Self {
        Self::at(&wheel.centre[2] + &wheel.radius, mechanism, wheel)
    }

    fn at(z: Form, mechanism: &'a Mechanism<Form>, wheel: &'a Wheel<Form>) -> Self {
        let [x, y, _] = &wheel.centre;
        let point = [x.clone(), y.clone(), z];
        let mut velocities = vec![zero(); mechanism.joints.len()];
        let mut rotations = velocities.clone();
        for index in mechanism.path(wheel.spin).skip(1) {
            let joint = &mechanism.joints[index];
            velocities[index] = match joint.motion {
                Motion::Slides => joint.axis.clone(),
                Motion::Turns => cross(&joint.axis, &tidy(&subtract(&point, &joint.point))),
            };
            if joint.motion == Motion::Turns {
                rotations[index] = joint.axis.clone();
            }
        }
        Self { mechanism, wheel, velocities: velocities.iter().map(tidy).collect(), rotations }
    }

    /// The contact point neither rises from the ground nor sinks into it.
    pub fn height(&self) -> Condition {
        Condition { rates: self.components(2), positions: self.nothing() }
    }

    /// The rim does not slip sideways. Of a wheel that is turned about the vertical the forward velocity has a part along
    /// the axle, and so has the velocity of the rim about it.
    pub fn sideways(&self) -> Condition {
        let positions = self.rotations.iter().map(|rotation| rotation[2].clone()).collect();
        Condition { rates: self.components(1), positions }
    }

    /// How the wheel leans to the right, by joint.
    pub fn lean(&self) -> Vec<Form> {
        self.rotations.iter().map(|rotation| rotation[0].clone()).collect()
    }

    /// The rim does not slip along the wheel, which is what turns it.
    pub fn along(&self) -> Condition {
        let mut rates = self.components(0);
        rates[self.wheel.spin] = self.wheel.radius.clone();
        Condition { rates, positions: self.nothing() }
    }

    /// The second derivative of the height of the contact point, which is downward, with respect to two joints.
    ///
    /// The point of the carrier that was lowest rises by r a²/2 relative to the centre where the carrier turns by a about
    /// x or y. So does the lowest point of a knife edge that is tilted about x; that of a tyre rises by (r - rho) a²/2 only,
    /// and about y, where its axle is, a wheel can turn without having another lowest point.
    pub fn curvature(&self, one: usize, other: usize) -> Form {
        let Some(far) = self.mechanism.farther(one, other) else { return Form::number(0) };
        let near = one.min(other);
        let (a, b) = (&self.rotations[near], &self.rotations[far]);
        let carried = &cross(a, &self.velocities[far])[2];
        let pitched = &self.wheel.radius * &(&a[1] * &b[1]);
        let tilted = self.wheel.tyre.as_ref().map_or(Form::number(0), |tyre| tyre * &(&a[0] * &b[0]));
        (&(carried + &pitched) + &tilted).simplest()
    }

    fn components(&self, axis: usize) -> Vec<Form> {
        self.velocities.iter().map(|velocity| velocity[axis].clone()).collect()
    }

    fn nothing(&self) -> Vec<Form> {
        vec![Form::number(0); self.mechanism.joints.len()]
    }
}

/// The moment that turns a wheel of unit spin momentum, rolling forward, about one joint while another one moves it.
pub fn gyroscopic(mechanism: &Mechanism<Form>, one: usize, other: usize) -> Form {
    let (a, b) = (&mechanism.joints[one], &mechanism.joints[other]);
    if a.motion == Motion::Slides || b.motion == Motion::Slides {
        return Form::number(0);
    }
    // The axle is along y.
    -&cross(&a.axis, &b.axis)[1]
}
