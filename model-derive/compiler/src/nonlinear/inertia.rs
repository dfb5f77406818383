//! The masses that frames carry, and the mass matrix of the speeds from composite bodies.

use super::frames::{Frame, Frames};
use super::quantity::Quantity;
use super::rolling::find_drift;
use super::solve::Matrix;
use super::vectors::{Tensor, Vector, add, add_tensors, cross, dot, negative, scale, times, unit, zero};
use super::wheels::Contact;
use crate::mechanics::{Mechanism, Motion};

/// Mass, static moment and inertia about the origin of a frame, in its axes.
#[derive(Clone, Copy)]
pub struct Inertia<'a> {
    pub mass: Quantity<'a>,
    pub moment: Vector<'a>,
    pub tensor: Tensor<'a>,
}

/// What a frame carries itself. Of wheels there is all but what their spin moves about their axles.
pub struct Load<'a> {
    pub inertia: Inertia<'a>,
    /// The angular momentum of what spins at a constant rate.
    pub momentum: Vector<'a>,
}

pub fn find_loads<'a>(mechanism: &Mechanism<Quantity<'a>>, frames: &Frames<'a>, some: Quantity<'a>) -> Vec<Load<'a>> {
    let none = zero(some);
    let nothing = Inertia { mass: none[0], moment: none, tensor: [none; 3] };
    let load = |(index, frame): (usize, &Frame<'a>)| {
        let mut load = Load { inertia: nothing, momentum: none };
        for body in &mechanism.bodies {
            let spins = mechanism.wheels.iter().any(|wheel| wheel.spin == body.joint);
            let carrier = if spins { mechanism.joints[body.joint].parent } else { Some(body.joint) };
            if frames.of_joint(carrier) != index {
                continue;
            }
            let tensor = match spins {
                // A tilt about the axle changes nothing.
                true => [0, 1, 2].map(|row| if row == 1 { none } else { body.inertia[row] }),
                false => frame.tensor(&body.inertia),
            };
            let own = Inertia { mass: body.mass, moment: none, tensor };
            load.inertia = load.inertia.plus(&own.about(frame.point(&body.centre)));
        }
        for (joint, momentum) in &mechanism.gyrostats {
            if frames.of_joint(Some(*joint)) == index {
                load.momentum = add(load.momentum, frame.vector(momentum));
            }
        }
        load
    };
    frames.all.iter().enumerate().map(load).collect()
}

impl<'a> Inertia<'a> {
    pub fn plus(&self, other: &Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            moment: add(self.moment, other.moment),
            tensor: add_tensors(&self.tensor, &other.tensor),
        }
    }

    /// About another point, from which the present one is at `arm` (Huygens and Steiner).
    pub fn about(&self, arm: Vector<'a>) -> Self {
        let moved = scale(self.mass, arm);
        let entry = |a: usize, b: usize| {
            // From r r to (r + d) (r + d).
            let grown = |a: usize, b: usize| arm[a] * self.moment[b] + self.moment[a] * arm[b] + moved[a] * arm[b];
            let [next, last] = [(a + 1) % 3, (a + 2) % 3];
            match a == b {
                true => self.tensor[a][a] + (grown(next, next) + grown(last, last)),
                false => self.tensor[a][b] - grown(a, b),
            }
        };
        let tensor = [0, 1, 2].map(|row: usize| [0, 1, 2].map(|column: usize| entry(row.min(column), row.max(column))));
        Self { mass: self.mass, moment: add(self.moment, moved), tensor }
    }

    fn out(&self, frame: &Frame<'a>) -> Self {
        Self { mass: self.mass, moment: frame.out(self.moment), tensor: frame.out_tensor(&self.tensor) }
    }
}

/// Momentum, and angular momentum about a point.
#[derive(Clone, Copy)]
struct Momentum<'a> {
    linear: Vector<'a>,
    angular: Vector<'a>,
}

/// The machine about the point where its first wheel touches the ground, in the axes of a frame of the root; or, of one
/// that is held to the ground, about the origin.
pub struct Composites<'a, 'm> {
    mechanism: &'m Mechanism<Quantity<'a>>,
    frames: &'m Frames<'a>,
    /// For each frame all that it moves, about its origin.
    all: Vec<Inertia<'a>>,
    axes: usize,
    /// The point from the origin of the root.
    point: Vector<'a>,
}

impl<'a, 'm> Composites<'a, 'm> {
    pub fn new(
        mechanism: &'m Mechanism<Quantity<'a>>,
        frames: &'m Frames<'a>,
        loads: &[Load<'a>],
        axes: usize,
        point: Vector<'a>,
    ) -> Self {
        let mut all: Vec<Inertia<'a>> = loads.iter().map(|load| load.inertia).collect();
        for index in (1..all.len()).rev() {
            let frame = &frames.all[index];
            let moved = all[index].out(frame).about(frame.offset);
            if let Some(parent) = frame.parent {
                all[parent] = all[parent].plus(&moved);
            }
        }
        Self { mechanism, frames, all, axes, point }
    }

    /// The whole machine.
    pub fn whole(&self) -> Inertia<'a> {
        self.all[self.axes].about(negative(self.point))
    }

    /// The mass matrix of the speeds, of which each row of `shares` gives the rate of a joint.
    pub fn mass(&self, shares: &Matrix<'a>, contacts: &[Contact<'a>]) -> Matrix<'a> {
        let speeds = shares.first().map_or(0, Vec::len);
        let some = self.point[0];
        let whole = self.whole();
        let turning: Vec<Vector<'a>> = (0..speeds).map(|speed| self.turning(shares, speed)).collect();
        let moving: Vec<Moving<'a>> = self.find_moving(contacts, &whole);
        // The momentum of each speed: angular about the point, and that of each joint.
        let turned: Vec<Vector<'a>> = (0..speeds)
            .map(|speed| {
                let own = times(&whole.tensor, turning[speed]);
                moving
                    .iter()
                    .fold(own, |sum, joint| add(sum, scale(shares[joint.joint][speed], joint.momentum.angular)))
            })
            .collect();
        let of_joint = |joint: usize, speed: usize| {
            let by_turning = dot(turning[speed], moving[joint].momentum.angular);
            moving.iter().enumerate().fold(by_turning, |sum, (other, Moving { joint: index, .. })| {
                sum + self.mass_of_joints(&moving, joint, other, &whole) * shares[*index][speed]
            })
        };
        let rotors: Vec<(Quantity<'a>, Vec<Quantity<'a>>)> = contacts
            .iter()
            .map(|contact| {
                let axle = self.frames.outer(contact.frame, self.axes, unit(some, 1));
                let spin = |speed: usize| {
                    let turned = dot(turning[speed], axle) + shares[contact.spin][speed];
                    self.between(contact.carrier).fold(turned, |sum, frame| {
                        let Some(joint) = self.frames.all[frame].joint else { return sum };
                        if self.frames.all[frame].motion == Motion::Slides {
                            return sum;
                        }
                        // Of the frames beyond that of the wheel the axes are along the axle.
                        let along = match contact.about_axle.iter().find(|(about, _)| *about == joint) {
                            Some((_, opposite)) => some.number(if *opposite { -1.0 } else { 1.0 }),
                            None => {
                                dot(self.frames.all[frame].axis, self.frames.outer(contact.frame, frame, unit(some, 1)))
                            }
                        };
                        sum + along * shares[joint][speed]
                    })
                };
                (contact.axial, (0..speeds).map(spin).collect())
            })
            .collect();
        let entry = |row: usize, column: usize| {
            let mut sum = dot(turning[row], turned[column]);
            for (index, joint) in moving.iter().enumerate() {
                let share = shares[joint.joint][row];
                if !share.is_zero() {
                    sum = sum + share * of_joint(index, column);
                }
            }
            rotors.iter().fold(sum, |sum, (axial, spins)| sum + *axial * (spins[row] * spins[column]))
        };
        let upper = |row: usize, column: usize| entry(row.min(column), row.max(column));
        (0..speeds).map(|row| (0..speeds).map(|column| upper(row, column)).collect()).collect()
    }

    /// The angular velocity of the last frame of the root at a unit of a speed, in the axes.
    pub fn turning(&self, shares: &Matrix<'a>, speed: usize) -> Vector<'a> {
        let frames = self.frames;
        (0..=frames.body).fold(zero(self.point[0]), |sum, frame| {
            let Some(joint) = frames.all[frame].joint else { return sum };
            add(sum, scale(shares[joint][speed], frames.change(frame, self.axes, frames.all[frame].axis)))
        })
    }

    /// The frames that carry one beside those of the root.
    fn between(&self, frame: usize) -> impl Iterator<Item = usize> + '_ {
        let is_root = move |frame: &usize| self.mechanism.root.is_some() && self.frames.in_root(*frame);
        self.frames.path(frame).filter(move |frame| !is_root(frame))
    }

    /// What joints beside those of the root move.
    fn find_moving(&self, contacts: &[Contact<'a>], whole: &Inertia<'a>) -> Vec<Moving<'a>> {
        let (mechanism, frames) = (self.mechanism, self.frames);
        let none = zero(self.point[0]);
        let moving = |joint: usize| {
            let is_spin = mechanism.wheels.iter().any(|wheel| wheel.spin == joint);
            let is_root = mechanism.root.is_some_and(|root| joint < root.count);
            let drift = contacts.first().and_then(|first| find_drift(mechanism, frames, first, joint, self.axes));
            if is_root || is_spin && drift.is_none() {
                return None;
            }
            let own = match is_spin {
                true => Momentum { linear: none, angular: none },
                false => {
                    let frame = frames.of_joint(Some(joint));
                    let outer = self.carry(frame, self.moved_by(frame));
                    Momentum { angular: add(outer.angular, cross(negative(self.point), outer.linear)), ..outer }
                }
            };
            let compensation = drift.map(negative);
            let momentum = match compensation {
                None => own,
                Some(velocity) => Momentum {
                    linear: add(own.linear, scale(whole.mass, velocity)),
                    angular: add(own.angular, cross(whole.moment, velocity)),
                },
            };
            Some(Moving { joint, is_spin, own, momentum, compensation })
        };
        (0..mechanism.joints.len()).filter_map(moving).collect()
    }

    /// What a joint moves at unit rate, about the origin of its frame and in its axes.
    fn moved_by(&self, frame: usize) -> Momentum<'a> {
        let (axis, composite) = (self.frames.all[frame].axis, &self.all[frame]);
        match self.frames.all[frame].motion {
            Motion::Turns => {
                Momentum { linear: cross(axis, composite.moment), angular: times(&composite.tensor, axis) }
            }
            Motion::Slides => Momentum { linear: scale(composite.mass, axis), angular: cross(composite.moment, axis) },
        }
    }

    /// A momentum about the origin of the root, in the axes.
    fn carry(&self, frame: usize, momentum: Momentum<'a>) -> Momentum<'a> {
        self.carry_to(frame, self.axes, momentum)
    }

    fn carry_to(&self, frame: usize, to: usize, momentum: Momentum<'a>) -> Momentum<'a> {
        let way = self.frames.path(frame).take_while(|frame| *frame != to);
        way.fold(momentum, |Momentum { linear, angular }, frame| {
            let frame = &self.frames.all[frame];
            let linear = frame.out(linear);
            Momentum { linear, angular: add(frame.out(angular), cross(frame.offset, linear)) }
        })
    }

    /// An entry of the mass matrix of joints that move without the rotation of the root.
    fn mass_of_joints(&self, moving: &[Moving<'a>], one: usize, other: usize, whole: &Inertia<'a>) -> Quantity<'a> {
        let (one, other) = (&moving[one.min(other)], &moving[one.max(other)]);
        let own = match one.is_spin || other.is_spin {
            true => self.point[0].number(0.0),
            false => {
                let [near, far] = [one, other].map(|moving| self.frames.of_joint(Some(moving.joint)));
                match self.frames.path(far).any(|frame| frame == near) {
                    false => self.point[0].number(0.0),
                    true => {
                        let seen = self.carry_to(far, near, self.moved_by(far));
                        let frame = &self.frames.all[near];
                        dot(frame.axis, if frame.motion == Motion::Turns { seen.angular } else { seen.linear })
                    }
                }
            }
        };
        let mut sum = own;
        if let Some(velocity) = one.compensation {
            sum = sum + dot(velocity, other.own.linear);
        }
        if let Some(velocity) = other.compensation {
            sum = sum + dot(velocity, one.own.linear);
        }
        match (one.compensation, other.compensation) {
            (Some(a), Some(b)) => sum + whole.mass * dot(a, b),
            _ => sum,
        }
    }
}

/// What a joint moves at unit rate.
struct Moving<'a> {
    joint: usize,
    is_spin: bool,
    /// Without what the root does about it, about the point.
    own: Momentum<'a>,
    /// With it.
    momentum: Momentum<'a>,
    /// The velocity of the root.
    compensation: Option<Vector<'a>>,
}
