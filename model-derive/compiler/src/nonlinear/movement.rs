//! Velocities and accelerations from the base outward, each in the axes of its frame.

use super::frames::Frames;
use super::quantity::Quantity;
use super::vectors::{Vector, add, cross, scale, zero};
use super::wheels::Contact;
use crate::mechanics::Motion;

/// A rate for each frame.
#[derive(Clone)]
pub struct Movement<'a> {
    /// Of the rotation.
    pub spins: Vec<Vector<'a>>,
    /// Of its origin.
    pub origins: Vec<Vector<'a>>,
}

/// Velocities, of the rates of all joints; `start` is that of the origin of the frame `axes` of the root.
pub fn find_velocities<'a>(
    frames: &Frames<'a>,
    rates: &[Quantity<'a>],
    axes: usize,
    start: Vector<'a>,
) -> Movement<'a> {
    let none = zero(start[0]);
    let mut found = Movement { spins: Vec::new(), origins: Vec::new() };
    for (index, frame) in frames.all.iter().enumerate() {
        let rate = frame.joint.map(|joint| rates[joint]).unwrap_or(none[0]);
        let (before, moved) = match frame.parent {
            None => (none, none),
            Some(parent) => {
                let spin = found.spins[parent];
                let at_point = add(found.origins[parent], cross(spin, frame.offset));
                (frame.own(spin), frame.own(at_point))
            }
        };
        let along = scale(rate, frame.axis);
        let (spin, origin) = match frame.motion {
            Motion::Turns => (add(before, along), moved),
            Motion::Slides => (before, add(moved, along)),
        };
        found.spins.push(spin);
        found.origins.push(if index == axes { start } else { origin });
    }
    found
}

/// Accelerations, of those of all joints.
pub fn find_accelerations<'a>(
    frames: &Frames<'a>,
    velocities: &Movement<'a>,
    [rates, accelerations]: [&[Quantity<'a>]; 2],
    axes: usize,
    start: Vector<'a>,
) -> Movement<'a> {
    let none = zero(start[0]);
    let mut found = Movement { spins: Vec::new(), origins: Vec::new() };
    for (index, frame) in frames.all.iter().enumerate() {
        let [rate, acceleration] =
            [rates, accelerations].map(|by| frame.joint.map(|joint| by[joint]).unwrap_or(none[0]));
        let (before, moved) = match frame.parent {
            None => (none, none),
            Some(parent) => {
                let (spin, spin_rate) = (velocities.spins[parent], found.spins[parent]);
                let centripetal = cross(spin, cross(spin, frame.offset));
                let at_point = add(found.origins[parent], add(cross(spin_rate, frame.offset), centripetal));
                (frame.own(spin_rate), frame.own(at_point))
            }
        };
        let along = scale(acceleration, frame.axis);
        let turned = scale(rate, cross(velocities.spins[index], frame.axis));
        let (spin, origin) = match frame.motion {
            Motion::Turns => (add(before, add(along, turned)), moved),
            Motion::Slides => (before, add(moved, add(along, add(turned, turned)))),
        };
        found.spins.push(spin);
        found.origins.push(if index == axes { start } else { origin });
    }
    found
}

impl<'a> Movement<'a> {
    /// The velocity of the centre of a wheel, in the axes of the wheel's frame.
    pub fn centre_velocity(&self, frames: &Frames<'a>, contact: &Contact<'a>) -> Vector<'a> {
        let carrier = contact.carrier;
        let centre = add(self.origins[carrier], cross(self.spins[carrier], contact.centre));
        frames.outer(carrier, contact.frame, centre)
    }

    /// The acceleration of the centre of a wheel, in the axes of the wheel's frame.
    pub fn centre_acceleration(
        &self,
        velocities: &Movement<'a>,
        frames: &Frames<'a>,
        contact: &Contact<'a>,
    ) -> Vector<'a> {
        let carrier = contact.carrier;
        let spin = velocities.spins[carrier];
        let centripetal = cross(spin, cross(spin, contact.centre));
        let turned = add(cross(self.spins[carrier], contact.centre), centripetal);
        frames.outer(carrier, contact.frame, add(self.origins[carrier], turned))
    }
}
