//! Where the bodies of a mechanism are and how they move, exactly, from the ground outward along the joints.

use nalgebra::{DVector, Isometry3, Point3, Translation3, UnitQuaternion, Vector3};

use super::{Contact, Freedom, Joint, Mechanism};

/// Every coordinate of a mechanism with its rate and acceleration, in the order of the joints.
#[derive(Clone, Debug)]
pub struct State {
    /// Coordinates.
    pub q: DVector<f64>,
    /// Their rates.
    pub qd: DVector<f64>,
    /// Their accelerations.
    pub qdd: DVector<f64>,
}

/// How the bodies that a joint carries are placed and move.
#[derive(Clone, Debug)]
pub struct Link {
    /// Takes points of the reference configuration to where they are.
    placement: Isometry3<f64>,
    /// Angular velocity.
    pub spin: Vector3<f64>,
    /// Angular acceleration.
    pub spin_rate: Vector3<f64>,
    /// Velocity of the material point that the reference configuration has at the origin.
    velocity: Vector3<f64>,
    /// Acceleration of that point.
    acceleration: Vector3<f64>,
}

impl Link {
    /// What does not move.
    fn ground() -> Self {
        let zero = Vector3::zeros();
        Self { placement: Isometry3::identity(), spin: zero, spin_rate: zero, velocity: zero, acceleration: zero }
    }

    /// Where a point of the reference configuration is.
    pub fn place(&self, reference: &Vector3<f64>) -> Vector3<f64> {
        (self.placement * Point3::from(*reference)).coords
    }

    /// Where a direction of the reference configuration points.
    pub fn turn(&self, reference: &Vector3<f64>) -> Vector3<f64> {
        self.placement * reference
    }

    /// The rotation from the reference configuration.
    pub fn rotation(&self) -> UnitQuaternion<f64> {
        self.placement.rotation
    }

    /// Velocity of the material point that is at a place.
    pub fn velocity_at(&self, place: &Vector3<f64>) -> Vector3<f64> {
        self.velocity + self.spin.cross(&(place - self.placement.translation.vector))
    }

    /// Acceleration of the material point that is at a place.
    pub fn acceleration_at(&self, place: &Vector3<f64>) -> Vector3<f64> {
        let arm = place - self.placement.translation.vector;
        self.acceleration + self.spin_rate.cross(&arm) + self.spin.cross(&self.spin.cross(&arm))
    }

    /// The link beyond a joint that this one carries, at the joint's coordinate, rate and acceleration.
    fn beyond(&self, joint: &Joint, q: f64, qd: f64, qdd: f64) -> Self {
        let axis = self.turn(&joint.axis);
        match joint.freedom {
            Freedom::Revolute => {
                let rotation = UnitQuaternion::new(joint.axis * q);
                let placement = self.placement * Isometry3::rotation_wrt_point(rotation, Point3::from(joint.point));
                let spin = self.spin + axis * qd;
                let spin_rate = self.spin_rate + axis * qdd + self.spin.cross(&axis) * qd;
                // The two links have the point on the axis in common.
                let point = self.place(&joint.point);
                let arm = placement.translation.vector - point;
                let velocity = self.velocity_at(&point) + spin.cross(&arm);
                let acceleration = self.acceleration_at(&point) + spin_rate.cross(&arm) + spin.cross(&spin.cross(&arm));
                Self { placement, spin, spin_rate, velocity, acceleration }
            }
            Freedom::Prismatic => {
                let placement = self.placement * Translation3::from(joint.axis * q);
                let origin = placement.translation.vector;
                let velocity = self.velocity_at(&origin) + axis * qd;
                let acceleration = self.acceleration_at(&origin) + axis * qdd + self.spin.cross(&axis) * (2.0 * qd);
                Self { placement, velocity, acceleration, ..*self }
            }
        }
    }
}

/// Velocities for a unit rate of one coordinate alone: Kane's partial velocities.
#[derive(Clone, Debug)]
pub struct Partial {
    /// The place of the coordinate.
    pub coordinate: usize,
    /// The angular velocity.
    pub spin: Vector3<f64>,
    /// The velocity of the point that was asked for.
    pub velocity: Vector3<f64>,
}

/// The point where a wheel touches the ground, as a material point of the wheel.
#[derive(Clone, Debug)]
pub struct Touch {
    /// The lowest point of the wheel.
    pub place: Vector3<f64>,
    /// Its slip velocity.
    pub slip: Vector3<f64>,
    /// The time derivative of the slip velocity, along the motion of the point of contact.
    pub slip_rate: Vector3<f64>,
    /// The horizontal direction in the plane of the wheel, forward.
    pub heading: Vector3<f64>,
    /// Its time derivative.
    pub heading_rate: Vector3<f64>,
    /// How far the wheel leans to the right, in rad.
    pub lean: f64,
    /// Velocity of the centre of the wheel.
    pub velocity: Vector3<f64>,
}

/// The links of a mechanism in one state.
#[derive(Clone, Debug)]
pub struct Kinematics<'a> {
    mechanism: &'a Mechanism,
    links: Vec<Link>,
}

impl<'a> Kinematics<'a> {
    /// The links of a mechanism in a state.
    pub fn new(mechanism: &'a Mechanism, state: &State) -> Self {
        let mut links: Vec<Link> = Vec::with_capacity(mechanism.joints.len());
        for (place, joint) in mechanism.joints.iter().enumerate() {
            let parent = joint.parent.map_or_else(Link::ground, |parent| links[parent].clone());
            links.push(parent.beyond(joint, state.q[place], state.qd[place], state.qdd[place]));
        }
        Self { mechanism, links }
    }

    /// The link that a joint carries.
    pub fn link(&self, joint: usize) -> &Link {
        &self.links[joint]
    }

    /// Partial velocities of a link and of its material point at `place`, by every coordinate that moves it.
    pub fn partials(&self, joint: usize, place: Vector3<f64>) -> impl Iterator<Item = Partial> {
        let joints = &self.mechanism.joints;
        std::iter::successors(Some(joint), |&joint| joints[joint].parent).map(move |coordinate| {
            let Joint { freedom, point, axis, .. } = &joints[coordinate];
            // A joint moves neither its own axis nor the points on it.
            let axis = self.links[coordinate].turn(axis);
            match freedom {
                Freedom::Revolute => {
                    let arm = place - self.links[coordinate].place(point);
                    Partial { coordinate, spin: axis, velocity: axis.cross(&arm) }
                }
                Freedom::Prismatic => Partial { coordinate, spin: Vector3::zeros(), velocity: axis },
            }
        })
    }

    /// Where a point that a joint carries is, and its velocity; the ground carries what no joint does.
    pub fn carried(&self, joint: Option<usize>, point: &Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
        let link = joint.map_or_else(Link::ground, |joint| self.links[joint].clone());
        let place = link.place(point);
        (place, link.velocity_at(&place))
    }

    /// How a wheel touches the ground.
    ///
    /// The lowest point of a torus is below the lowest point of the circle that runs inside its tube.
    pub fn touch(&self, contact: &Contact) -> Touch {
        let link = &self.links[contact.joint];
        let down = Vector3::z();
        let axle = link.turn(&self.mechanism.joints[contact.joint].axis);
        let axle_rate = link.spin.cross(&axle);
        // The steepest way down in the plane of the wheel, and how it turns.
        let slope = down - axle * axle.z;
        let slope_rate = -(axle_rate * axle.z + axle * axle_rate.z);
        let steepest = slope.normalize();
        let steepest_rate = (slope_rate - steepest * steepest.dot(&slope_rate)) / slope.norm();
        let circle = contact.radius - contact.tyre;
        let arm = steepest * circle + down * contact.tyre;
        let arm_rate = steepest_rate * circle;

        let centre = link.place(&contact.centre);
        let slip = link.velocity_at(&centre) + link.spin.cross(&arm);
        let slip_rate = link.acceleration_at(&centre) + link.spin_rate.cross(&arm) + link.spin.cross(&arm_rate);
        let across = axle.cross(&down);
        let across_rate = axle_rate.cross(&down);
        let heading = across.normalize();
        Touch {
            place: centre + arm,
            slip,
            slip_rate,
            heading,
            heading_rate: (across_rate - heading * heading.dot(&across_rate)) / across.norm(),
            lean: axle.z.asin(),
            velocity: link.velocity_at(&centre),
        }
    }
}
