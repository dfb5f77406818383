//! The axes of the bodies: one frame for each joint, each turned by its joint against the frame that it hangs on.
//!
//! The frame at the base is the ground, or, of a machine that rolls over it, turns with its heading: the place and the
//! heading make no difference to the motion, and occur nowhere.

use super::quantity::Quantity;
use super::vectors::{Tensor, Vector, add, dot, scale, subtract, times, unit};
use crate::mechanics::{Mechanism, Motion};

/// What a joint carries.
pub struct Frame<'a> {
    /// The frame that it hangs on; none for the base.
    pub parent: Option<usize>,
    /// None for the base of a mechanism that is held to the ground.
    pub joint: Option<usize>,
    pub motion: Motion,
    /// How its axes are turned about y against those of the model, by a constant angle, as sine and cosine: so that the
    /// axis of a joint beyond it is one of them.
    tilt: Option<[Quantity<'a>; 2]>,
    rotation: Rotation<'a>,
    /// The axis of the joint, in its axes.
    pub axis: Vector<'a>,
    /// The point of the model that is its origin.
    origin: Vector<'a>,
    /// From the origin of the frame that it hangs on, in the axes of that.
    pub offset: Vector<'a>,
}

/// From the axes of the frame that one hangs on to its own.
enum Rotation<'a> {
    None,
    /// About an axis that both have, by an angle whose sine and cosine these are.
    About(usize, Quantity<'a>, Quantity<'a>),
    /// By rows: what is made of the frame's own vectors.
    Any(Box<Tensor<'a>>),
}

pub struct Frames<'a> {
    pub all: Vec<Frame<'a>>,
    /// For each joint its frame; none for displacements of the root, and for axles.
    of_joints: Vec<Option<usize>>,
    /// The last frame of the root.
    pub body: usize,
}

impl<'a> Frames<'a> {
    /// The frames at given positions, by joint; axes of joints have unit length. Those of the root have their origin at
    /// `centre`.
    pub fn new(mechanism: &Mechanism<Quantity<'a>>, positions: &[Quantity<'a>], centre: Option<Vector<'a>>) -> Self {
        let some = positions[0];
        let origin = centre.unwrap_or([some.number(0.0); 3]);
        let base = Frame {
            parent: None,
            joint: mechanism.root.map(|root| root.yaw),
            motion: Motion::Turns,
            tilt: None,
            rotation: Rotation::None,
            axis: unit(some, 2),
            origin,
            offset: [some.number(0.0); 3],
        };
        let mut frames = Self { all: vec![base], of_joints: vec![None; mechanism.joints.len()], body: 0 };
        for (joint, position) in positions.iter().enumerate() {
            if mechanism.wheels.iter().any(|wheel| wheel.spin == joint) {
                continue;
            }
            match mechanism.root {
                Some(root) if joint < root.yaw => continue,
                Some(root) if joint == root.yaw => frames.of_joints[joint] = Some(0),
                _ => frames.grow(mechanism, joint, *position),
            }
        }
        frames
    }

    fn grow(&mut self, mechanism: &Mechanism<Quantity<'a>>, index: usize, position: Quantity<'a>) {
        let joint = &mechanism.joints[index];
        let in_root = mechanism.root.is_some_and(|root| index < root.count);
        let parent = joint.parent.and_then(|parent| self.of_joints[parent]).unwrap_or(0);
        let before = &self.all[parent];
        let origin = if in_root || joint.motion == Motion::Slides { before.origin } else { joint.point };
        let arm = before.local(subtract(origin, before.origin));
        let axis = match before.tilt {
            // The axis that the frame was tilted for.
            Some(tilt) if is_tilt(tilt, joint.axis) => unit(position, 2),
            _ => before.local(joint.axis),
        };
        let tilt = before.tilt.or_else(|| find_tilt(mechanism, index));
        let frame = Frame {
            parent: Some(parent),
            joint: Some(index),
            motion: joint.motion,
            rotation: match joint.motion {
                Motion::Slides => Rotation::None,
                Motion::Turns if before.tilt.is_none() && tilt.is_some() => {
                    let [sin, cos] = signed(axis[1], position);
                    let [tilted, upright] = tilt.unwrap_or([sin, cos]);
                    Rotation::About(1, sin * upright + cos * tilted, cos * upright - sin * tilted)
                }
                Motion::Turns => Rotation::new(axis, position),
            },
            offset: if joint.motion == Motion::Slides { add(arm, scale(position, axis)) } else { arm },
            axis: if tilt.is_some() && before.tilt.is_none() { joint.axis } else { axis },
            tilt,
            origin,
        };
        self.all.push(frame);
        self.of_joints[index] = Some(self.all.len() - 1);
        if in_root {
            self.body = self.all.len() - 1;
        }
    }

    /// The frame of what a joint moves.
    pub fn of_joint(&self, joint: Option<usize>) -> usize {
        joint.and_then(|joint| self.of_joints[joint]).unwrap_or(0)
    }

    /// A frame and those that it hangs on.
    pub fn path(&self, frame: usize) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(Some(frame), |frame| self.all[*frame].parent)
    }

    /// Whether a frame is one of the root.
    pub fn in_root(&self, frame: usize) -> bool {
        frame <= self.body
    }

    /// A vector of a frame in the axes of one that it hangs on.
    pub fn outer(&self, frame: usize, to: usize, vector: Vector<'a>) -> Vector<'a> {
        self.path(frame).take_while(|frame| *frame != to).fold(vector, |vector, frame| self.all[frame].out(vector))
    }

    /// A vector of a frame in the axes of one that hangs on it.
    pub fn inner(&self, frame: usize, to: usize, vector: Vector<'a>) -> Vector<'a> {
        match self.all[to].parent {
            Some(parent) if to != frame => self.all[to].own(self.inner(frame, parent, vector)),
            _ => vector,
        }
    }

    /// A vector of a frame in the axes of any frame on one path with it.
    pub fn change(&self, frame: usize, to: usize, vector: Vector<'a>) -> Vector<'a> {
        if to <= frame { self.outer(frame, to, vector) } else { self.inner(frame, to, vector) }
    }

    /// From the origin of the base to a point of a frame, which is given from the frame's origin, in the axes of the base.
    pub fn place(&self, frame: usize, point: Vector<'a>) -> Vector<'a> {
        self.path(frame).fold(point, |point, frame| match self.all[frame].parent {
            Some(_) => add(self.all[frame].offset, self.all[frame].out(point)),
            None => point,
        })
    }
}

impl<'a> Frame<'a> {
    /// A vector of this frame in the axes of the one that it hangs on.
    pub fn out(&self, v: Vector<'a>) -> Vector<'a> {
        match &self.rotation {
            Rotation::None => v,
            Rotation::About(axis, sin, cos) => {
                let [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
                let mut out = v;
                (out[i], out[j]) = (*cos * v[i] - *sin * v[j], *sin * v[i] + *cos * v[j]);
                out
            }
            Rotation::Any(rows) => times(rows, v),
        }
    }

    /// A vector of the frame that this one hangs on, in its own axes.
    pub fn own(&self, v: Vector<'a>) -> Vector<'a> {
        match &self.rotation {
            Rotation::None => v,
            Rotation::About(axis, sin, cos) => {
                let [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
                let mut own = v;
                (own[i], own[j]) = (*cos * v[i] + *sin * v[j], *cos * v[j] - *sin * v[i]);
                own
            }
            Rotation::Any(rows) => [0, 1, 2].map(|column| dot([0, 1, 2].map(|row| rows[row][column]), v)),
        }
    }

    /// A symmetric tensor of this frame in the axes of the one that it hangs on.
    pub fn out_tensor(&self, tensor: &Tensor<'a>) -> Tensor<'a> {
        match &self.rotation {
            Rotation::None => *tensor,
            Rotation::About(axis, sin, cos) => {
                let [i, j, k] = [(axis + 1) % 3, (axis + 2) % 3, *axis];
                let [a, b, d] = [tensor[i][i], tensor[j][j], tensor[i][j]];
                let (difference, squares, both) = (a - b, sin.square(), *sin * *cos);
                let moved = squares * difference + both * (d + d);
                let mut out = *tensor;
                (out[i][i], out[j][j]) = (a - moved, b + moved);
                out[i][j] = both * difference + (d - squares * (d + d));
                out[i][k] = *cos * tensor[i][k] - *sin * tensor[j][k];
                out[j][k] = *sin * tensor[i][k] + *cos * tensor[j][k];
                (out[j][i], out[k][i], out[k][j]) = (out[i][j], out[i][k], out[j][k]);
                out
            }
            Rotation::Any(rows) => {
                let half = tensor.map(|row| times(rows, row));
                let entry = |row: usize, column: usize| dot(rows[row], [0, 1, 2].map(|inner| half[inner][column]));
                symmetric(entry)
            }
        }
    }

    /// A vector of the model in the axes of this frame.
    fn local(&self, v: Vector<'a>) -> Vector<'a> {
        match self.tilt {
            None => v,
            Some([sin, cos]) => [cos * v[0] - sin * v[2], v[1], sin * v[0] + cos * v[2]],
        }
    }

    /// A point of the model from the origin of this frame, in its axes.
    pub fn point(&self, point: &Vector<'a>) -> Vector<'a> {
        self.local(subtract(*point, self.origin))
    }

    /// A constant vector of the model in the axes of this frame.
    pub fn vector(&self, vector: &Vector<'a>) -> Vector<'a> {
        self.local(*vector)
    }

    /// A symmetric tensor of the model in the axes of this frame.
    pub fn tensor(&self, tensor: &Tensor<'a>) -> Tensor<'a> {
        // Its columns, and then its rows.
        let half = tensor.map(|row| self.local(row));
        let columns = [0, 1, 2].map(|column| self.local([0, 1, 2].map(|row| half[row][column])));
        symmetric(|row, column| columns[column][row])
    }
}

impl<'a> Rotation<'a> {
    /// About a unit vector by an angle (Rodrigues).
    fn new(axis: Vector<'a>, angle: Quantity<'a>) -> Self {
        for (k, [i, j]) in [[1, 2], [2, 0], [0, 1]].into_iter().enumerate() {
            if axis[i].is_zero() && axis[j].is_zero() {
                let [sin, cos] = signed(axis[k], angle);
                return Self::About(k, sin, cos);
            }
        }
        let (sin, cos) = (angle.sin(), angle.cos());
        let rest = angle.number(1.0) - cos;
        let [x, y, z] = axis.map(|component| component * sin);
        let zero = angle.number(0.0);
        let crossed = [[zero, -z, y], [z, zero, -x], [-y, x, zero]];
        Self::Any(Box::new([0, 1, 2].map(|row| {
            [0, 1, 2].map(|column| {
                let projected = axis[row] * axis[column] * rest + crossed[row][column];
                if row == column { projected + cos } else { projected }
            })
        })))
    }
}

fn symmetric<'a>(entry: impl Fn(usize, usize) -> Quantity<'a>) -> Tensor<'a> {
    [0, 1, 2].map(|row: usize| [0, 1, 2].map(|column: usize| entry(row.min(column), row.max(column))))
}

/// Sine and cosine of an angle about an axis, or about its opposite.
fn signed<'a>(along: Quantity<'a>, angle: Quantity<'a>) -> [Quantity<'a>; 2] {
    // Of a unit vector the one component is 1 or -1.
    [if along.is_one() { angle.sin() } else { along * angle.sin() }, angle.cos()]
}

/// The tilt of a frame that a joint along y carries: that which the axis of a joint beyond it has.
fn find_tilt<'a>(mechanism: &Mechanism<Quantity<'a>>, joint: usize) -> Option<[Quantity<'a>; 2]> {
    let own = &mechanism.joints[joint];
    if own.motion == Motion::Slides || !(own.axis[0].is_zero() && own.axis[2].is_zero()) {
        return None;
    }
    let beyond = mechanism.joints.iter().filter(|other| other.parent == Some(joint) && other.motion == Motion::Turns);
    let mut axes = beyond.map(|other| other.axis);
    let axis = axes.find(|[x, y, z]| y.is_zero() && !x.is_zero() && !z.is_zero())?;
    Some([axis[0], axis[2]])
}

fn is_tilt(tilt: [Quantity<'_>; 2], axis: Vector<'_>) -> bool {
    axis[1].is_zero() && axis[0].value == tilt[0].value && axis[2].value == tilt[1].value
}
