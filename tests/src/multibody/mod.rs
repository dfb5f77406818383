//! The linearized equations of motion by a way of their own: a nonlinear mechanism of rigid bodies, differenced.
//!
//! Nothing here is derived by hand or by algebra. A [`Mechanism`] says what is joined to what and which wheels roll; its
//! exact [`kinematics`] and [`dynamics`] are computed in floating point at given coordinates, rates and accelerations,
//! and [`Mechanism::linearized`] takes their differences about upright straight running. It is what the authors of the
//! benchmark did with two simulation programs to confirm their formulas.
//!
//! Axes: x forward, y to the right, z down, and the ground is z = 0. Points, axes and moments of inertia are given in the
//! reference configuration, in which every coordinate is zero.

pub mod bicycle;
pub mod dynamics;
pub mod kinematics;
mod linearize;
mod loads;

use nalgebra::{Matrix3, Vector3};

/// Rigid bodies in a tree of joints, with wheels that roll on the ground or slip sideways on it.
#[derive(Clone, Debug, Default)]
pub struct Mechanism {
    /// One joint for each coordinate, in its order; a parent comes before its children.
    pub joints: Vec<Joint>,
    /// Bodies, each carried by a joint.
    pub bodies: Vec<Body>,
    /// Where wheels touch the ground.
    pub contacts: Vec<Contact>,
    /// Springs and dampers between points of bodies.
    pub struts: Vec<Strut>,
    /// What spins in bodies: the joint that carries it and its angular momentum, which is constant in the body.
    pub rotors: Vec<(usize, Vector3<f64>)>,
}

/// A linear spring and damper between two points, relaxed in the reference configuration.
#[derive(Clone, Debug)]
pub struct Strut {
    /// The joints that carry its ends, with the points in the reference configuration; `None` is the ground.
    pub ends: [(Option<usize>, Vector3<f64>); 2],
    /// Stiffness.
    pub stiffness: f64,
    /// Coefficient of the damper.
    pub damping: f64,
}

/// A joint with one freedom, whose coordinate is an angle in rad or a displacement in m.
#[derive(Clone, Debug)]
pub struct Joint {
    /// The joint that carries this one; `None` is the ground.
    pub parent: Option<usize>,
    /// What the joint lets its bodies do.
    pub freedom: Freedom,
    /// A point on the axis.
    pub point: Vector3<f64>,
    /// Direction of the axis, a unit vector.
    pub axis: Vector3<f64>,
    /// Stiffness of a linear spring, relaxed at coordinate zero.
    pub stiffness: f64,
    /// Coefficient of a linear damper.
    pub damping: f64,
}

/// What a joint lets its bodies do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Freedom {
    /// Turn about the axis.
    Revolute,
    /// Slide along the axis.
    Prismatic,
}

impl Joint {
    /// A hinge with its axis through a point.
    pub fn revolute(parent: Option<usize>, point: Vector3<f64>, axis: Vector3<f64>) -> Self {
        Self::new(parent, Freedom::Revolute, point, axis)
    }

    /// A slide along an axis.
    pub fn prismatic(parent: Option<usize>, axis: Vector3<f64>) -> Self {
        Self::new(parent, Freedom::Prismatic, Vector3::zeros(), axis)
    }

    fn new(parent: Option<usize>, freedom: Freedom, point: Vector3<f64>, axis: Vector3<f64>) -> Self {
        Self { parent, freedom, point, axis: axis.normalize(), stiffness: 0.0, damping: 0.0 }
    }

    /// The same joint with a spring and a damper.
    pub fn sprung(self, stiffness: f64, damping: f64) -> Self {
        Self { stiffness, damping, ..self }
    }
}

/// A rigid body.
#[derive(Clone, Debug)]
pub struct Body {
    /// The joint that carries it.
    pub joint: usize,
    /// Its mass.
    pub mass: f64,
    /// Its centre of mass.
    pub centre: Vector3<f64>,
    /// Its tensor of inertia about the centre of mass.
    pub inertia: Matrix3<f64>,
}

/// A wheel that rolls without slip, carried by a joint and turning on an axle of its own along y.
#[derive(Clone, Copy, Debug)]
pub struct Wheel {
    /// The joint that carries the axle.
    pub carrier: usize,
    /// Where the wheel touches the ground, forward of the origin.
    pub x: f64,
    /// The same to the right of the origin.
    pub y: f64,
    /// Radius to the outside of the tyre.
    pub radius: f64,
    /// Radius of the tyre's circular cross-section; zero is a knife edge.
    pub tyre: f64,
    /// Mass.
    pub mass: f64,
    /// Moment of inertia about the axle.
    pub axial: f64,
    /// Moment of inertia about a diameter.
    pub transverse: f64,
}

/// The contact of a wheel: a torus about the axis of the joint that carries it, on the ground.
#[derive(Clone, Debug)]
pub struct Contact {
    /// The joint that the wheel turns on.
    pub joint: usize,
    /// The centre of the wheel.
    pub centre: Vector3<f64>,
    /// Radius to the outside of the tyre.
    pub radius: f64,
    /// Radius of the tyre's circular cross-section.
    pub tyre: f64,
    /// How deep the level ground below it lies: other wheels may roll on another step.
    pub ground: f64,
    /// How it slips sideways; a wheel that does not, rolls.
    pub slip: Option<Slip>,
}

/// A tyre with a side force that is linear in the slip angle and in the lean of the wheel.
#[derive(Clone, Copy, Debug)]
pub struct Slip {
    /// Force by slip angle, against the slip.
    pub cornering: f64,
    /// Force by lean, to the side of the lean.
    pub camber: f64,
    /// How far behind the contact the force acts.
    pub trail: f64,
    /// The length over which the force follows, and the place of the tyre's deflection among the coordinates.
    pub relaxation: Option<(f64, usize)>,
}

/// The coordinates of a free root, by their places in [`Mechanism::joints`].
#[derive(Clone, Copy, Debug)]
pub struct Root {
    /// Forward displacement of the point that is at the origin in the reference configuration.
    pub x: usize,
    /// Its displacement to the right.
    pub y: usize,
    /// Its displacement downward.
    pub z: usize,
    /// First rotation, about the vertical.
    pub yaw: usize,
    /// Second rotation, about the x axis that yaw has turned.
    pub lean: usize,
    /// Third rotation, about the y axis that yaw and lean have turned; it carries the bodies.
    pub pitch: usize,
}

impl Mechanism {
    /// Adds the six freedoms of a body that nothing holds.
    pub fn free_root(&mut self) -> Root {
        let x = self.joint(Joint::prismatic(None, Vector3::x()));
        let y = self.joint(Joint::prismatic(Some(x), Vector3::y()));
        let z = self.joint(Joint::prismatic(Some(y), Vector3::z()));
        let yaw = self.joint(Joint::revolute(Some(z), Vector3::zeros(), Vector3::z()));
        let lean = self.joint(Joint::revolute(Some(yaw), Vector3::zeros(), Vector3::x()));
        let pitch = self.joint(Joint::revolute(Some(lean), Vector3::zeros(), Vector3::y()));
        Root { x, y, z, yaw, lean, pitch }
    }

    /// Adds a joint, and returns the place of its coordinate.
    pub fn joint(&mut self, joint: Joint) -> usize {
        let place = self.joints.len();
        assert!(joint.parent.is_none_or(|parent| parent < place), "a joint's parent comes before it");
        self.joints.push(joint);
        place
    }

    /// Adds a body.
    pub fn body(&mut self, body: Body) {
        self.bodies.push(body);
    }

    /// Adds a wheel with its axle, and returns the place of its angle.
    pub fn wheel(&mut self, wheel: Wheel) -> usize {
        let centre = Vector3::new(wheel.x, wheel.y, -wheel.radius);
        let joint = self.joint(Joint::revolute(Some(wheel.carrier), centre, Vector3::y()));
        let inertia = Matrix3::from_diagonal(&Vector3::new(wheel.transverse, wheel.axial, wheel.transverse));
        self.body(Body { joint, mass: wheel.mass, centre, inertia });
        self.contacts.push(Contact { joint, centre, radius: wheel.radius, tyre: wheel.tyre, ground: 0.0, slip: None });
        joint
    }

    /// Adds a coordinate that moves nothing: the deflection of a tyre, to the right.
    pub fn deflection(&mut self) -> usize {
        self.joint(Joint::prismatic(None, Vector3::y()))
    }

    /// Lets the wheel that was added last slip.
    pub fn slip(&mut self, slip: Slip) {
        self.contacts.last_mut().expect("a wheel").slip = Some(slip);
    }
}
