//! Where wheels touch the ground: the lowest points of circles, or of tyres with a circular cross-section.

use super::frames::Frames;
use super::quantity::Quantity;
use super::vectors::{Vector, add, scale, subtract};
use crate::mechanics::{Mechanism, Motion};

/// A wheel on the ground.
///
/// In the axes of its `frame` the axle is along y; `heading` is horizontal in the plane of the wheel, and `down` is across
/// both, toward the ground. There is a division by the sine of the angle between axle and vertical alone, and none where
/// the heading is an axis of the frame.
pub struct Contact<'a> {
    /// The frame of the body that carries it.
    pub carrier: usize,
    /// The centre from the origin of that, in its axes.
    pub centre: Vector<'a>,
    pub spin: usize,
    pub axial: Quantity<'a>,
    pub tyre: Quantity<'a>,
    /// The outermost one that differs from the carrier only by what turns about the axle.
    pub frame: usize,
    /// The joints between, each with whether it turns the other way, and the spin.
    pub about_axle: Vec<(usize, bool)>,
    /// Of `heading` and `down`, which have no y component, the components x and z.
    pub heading: [Quantity<'a>; 2],
    pub down: [Quantity<'a>; 2],
    /// The sine and cosine of the lean, of which the one is the y component of the vertical.
    pub sin: Quantity<'a>,
    pub cos: Quantity<'a>,
    /// Whether the heading stays where it is in the frame.
    pub is_steady: bool,
    /// From the centre to the lowest point, in the axes of the frame.
    pub arm: Vector<'a>,
    /// The distance from the axle to the lowest point.
    pub radius: Quantity<'a>,
    /// The same without that of the cross-section of the tyre.
    pub rim: Quantity<'a>,
    /// The heading along the axes x and y of the base.
    pub course: [Quantity<'a>; 2],
    /// The lowest point from the origin of the base, in its axes.
    pub place: Vector<'a>,
}

impl<'a> Contact<'a> {
    pub fn new(mechanism: &Mechanism<Quantity<'a>>, frames: &Frames<'a>, wheel: usize, vertical: Vector<'a>) -> Self {
        let wheel = &mechanism.wheels[wheel];
        let carrier = frames.of_joint(mechanism.joints[wheel.spin].parent);
        let centre = frames.all[carrier].point(&wheel.centre);
        let (mut frame, mut about_axle) = (carrier, vec![(wheel.spin, false)]);
        while let Some((parent, joint)) = frames.all[frame].parent.zip(frames.all[frame].joint) {
            let [x, y, z] = frames.all[frame].axis;
            if frames.all[frame].motion == Motion::Slides || !(x.is_zero() && z.is_zero()) {
                break;
            }
            about_axle.push((joint, !y.is_one()));
            frame = parent;
        }
        let [x, sin, z] = frames.inner(0, frame, vertical);
        let [zero, one] = [0.0, 1.0].map(|number| sin.number(number));
        let is_steady = x.is_zero();
        let (heading, down, cos) = match is_steady {
            true => ([one, zero], [zero, one], z),
            false => {
                let cos = (x.square() + z.square()).sqrt();
                let [x, z] = [x, z].map(|component| component * (one / cos));
                ([z, -x], [x, z], cos)
            }
        };
        let tyre = wheel.tyre.unwrap_or(zero);
        let rim = wheel.radius - tyre;
        let [x, z] = down.map(|component| component * (rim + tyre * cos));
        let arm = [x, tyre * sin, z];
        let [along, beside, _] = frames.outer(frame, 0, [heading[0], zero, heading[1]]);
        // The vertical part of the arm is that of the rim and the tyre.
        let arm_in_base = [rim * sin * beside, -(rim * sin * along), rim * cos + tyre];
        Self {
            carrier,
            centre,
            spin: wheel.spin,
            axial: wheel.axial,
            tyre,
            frame,
            about_axle,
            heading,
            down,
            sin,
            cos,
            is_steady,
            arm,
            radius: rim + tyre * cos,
            rim,
            course: [along, beside],
            place: add(frames.place(carrier, centre), arm_in_base),
        }
    }

    /// The heading in the axes of the frame.
    pub fn heading(&self) -> Vector<'a> {
        [self.heading[0], self.sin.number(0.0), self.heading[1]]
    }

    /// A vector of the frame along the heading, horizontally to the right of it, and downward.
    pub fn on_the_ground(&self, vector: Vector<'a>) -> [Quantity<'a>; 3] {
        let along = vector[0] * self.heading[0] + vector[2] * self.heading[1];
        let down = vector[0] * self.down[0] + vector[2] * self.down[1];
        [along, self.cos * vector[1] - self.sin * down, self.sin * vector[1] + self.cos * down]
    }

    /// A sum over the joints that turn the wheel about its axle, in the sense of the spin.
    pub fn sum_about_axle(&self, by_joint: &[Quantity<'a>]) -> Quantity<'a> {
        let signed = |&(joint, opposite): &(usize, bool)| if opposite { -by_joint[joint] } else { by_joint[joint] };
        self.about_axle.iter().map(signed).fold(self.sin.number(0.0), |sum, value| sum + value)
    }

    /// A horizontal vector along the heading and to the right of it, in the axes of the base.
    pub fn in_base(&self, along: Quantity<'a>, beside: Quantity<'a>, down: Quantity<'a>) -> Vector<'a> {
        let [x, y] = self.course;
        [along * x - beside * y, along * y + beside * x, down]
    }

    /// From the contact of another wheel to this one, in the axes of the base.
    pub fn from(&self, other: &Self) -> Vector<'a> {
        subtract(self.place, other.place)
    }

    /// The rate at which the heading turns in the plane of the wheel, of the angular velocity of the frame.
    pub fn roll(&self, spin: Vector<'a>) -> Quantity<'a> {
        match self.is_steady {
            true => self.sin.number(0.0),
            false => spin[1] - self.sin / self.cos * self.along_down(spin),
        }
    }

    /// The component of a vector of the frame toward the ground in the plane of the wheel.
    pub fn along_down(&self, vector: Vector<'a>) -> Quantity<'a> {
        vector[0] * self.down[0] + vector[2] * self.down[1]
    }

    /// That along the heading.
    pub fn along_heading(&self, vector: Vector<'a>) -> Quantity<'a> {
        vector[0] * self.heading[0] + vector[2] * self.heading[1]
    }

    /// The rate of the arm, of the angular velocity of the frame.
    pub fn arm_rate(&self, spin: Vector<'a>) -> Vector<'a> {
        // The triad of heading, axle and down turns with the frame but about the axle.
        let [x, z] = self.down;
        let about_axle = match self.is_steady {
            true => spin[1],
            false => self.sin / self.cos * self.along_down(spin),
        };
        let turned = [about_axle * z, spin[2] * x - spin[0] * z, -(about_axle * x)];
        scale(self.rim, turned)
    }
}
