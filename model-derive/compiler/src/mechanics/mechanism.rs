//! A mechanism in its reference configuration: what is derived from.

use nanoserde::SerBin;

use crate::matrix_name::{MatrixName, Whole};

/// Bodies in a tree of joints, with formulas of type `V`. The axes are x forward, y to the right, z down; the ground is
/// at z = 0.
#[derive(Clone, Debug, SerBin)]
pub struct Mechanism<V> {
    /// Each behind the one that it hangs on.
    pub joints: Vec<Joint<V>>,
    pub bodies: Vec<Body<V>>,
    pub wheels: Vec<Wheel<V>>,
    /// Of a mechanism that moves over the ground.
    pub root: Option<Root>,
    /// The joints whose motions are the coordinates q, in their order.
    pub coordinates: Vec<usize>,
    /// Those of the coordinates whose motion the wheels determine, so that only their positions are states.
    pub following: Vec<usize>,
    /// The joints that an applied force or torque acts on.
    pub forces: Vec<usize>,
    /// What spins at a constant rate in bodies: the joint that moves it, and its angular momentum, in N m s.
    pub gyrostats: Vec<(usize, [V; 3])>,
    pub links: Vec<Link<V>>,
    /// Whether the forward speed is held, whatever the coordinates do.
    pub holds_speed: bool,
    /// What is added to the matrices of the coordinates, in rows of theirs.
    pub added: Vec<(MatrixName, Vec<Vec<V>>)>,
    /// What follows from the motion.
    pub fed: Vec<Fed<V>>,
    /// The parameter that is the gravity, if there is one.
    pub gravity: Option<usize>,
    /// The parameter that stands for the steady load of the first wheel, before those of the others, where formulas of side
    /// forces have loads in them.
    pub loads: Option<usize>,
}

/// What feedback adds to a matrix of all joints.
#[derive(Clone, Debug, SerBin)]
pub struct Fed<V> {
    /// The joint that it acts on.
    pub on: usize,
    /// The joint whose rate or position it multiplies.
    pub of: usize,
    /// By the power of the speed.
    pub matrix: MatrixName,
    pub formula: V,
}

/// One freedom between two bodies, or between a body and the ground.
#[derive(Clone, Debug, SerBin)]
pub struct Joint<V> {
    /// The name of the coordinate.
    pub name: String,
    /// The joint that it hangs on; none for one that begins at the ground.
    pub parent: Option<usize>,
    pub motion: Motion,
    /// A point of the axis, in m.
    pub point: [V; 3],
    /// The direction of the axis, of any length.
    pub axis: [V; 3],
    /// In N m/rad or N/m.
    pub stiffness: Option<V>,
    /// In N m s/rad or N s/m.
    pub damping: Option<V>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, SerBin)]
pub enum Motion {
    Turns,
    Slides,
}

/// A rigid body, or a part of one.
#[derive(Clone, Debug, SerBin)]
pub struct Body<V> {
    /// The joint that moves it.
    pub joint: usize,
    pub mass: V,
    pub centre: [V; 3],
    /// About the centre of mass.
    pub inertia: [[V; 3]; 3],
}

/// What rolls, without slip unless it is said to slip sideways: a disc about an axle along y, with a rim that is a knife edge or a part of a torus. Its mass
/// is that of the body on its spin joint.
#[derive(Clone, Debug, SerBin)]
pub struct Wheel<V> {
    /// The joint that is its axle.
    pub spin: usize,
    pub centre: [V; 3],
    /// From the centre to the ground.
    pub radius: V,
    /// The radius of the circle that is the cross-section of the tyre.
    pub tyre: Option<V>,
    /// The moment of inertia about the axle.
    pub axial: V,
    /// Of a tyre that slips sideways.
    pub slip: Option<Slip<V>>,
}

/// A spring and a damper between points of two bodies, unloaded in the reference configuration.
#[derive(Clone, Debug, SerBin)]
pub struct Link<V> {
    /// The joints that move its ends; none for the ground.
    pub joints: [Option<usize>; 2],
    pub points: [[V; 3]; 2],
    /// In N/m.
    pub stiffness: Option<V>,
    /// In N s/m.
    pub damping: Option<V>,
}

/// The side force of a tyre, linear in slip and camber.
#[derive(Clone, Debug, SerBin)]
pub struct Slip<V> {
    /// Against the slip angle, in N by rad.
    pub cornering: V,
    /// To the side to which the wheel leans, in N by rad.
    pub camber: Option<V>,
    /// How far behind the contact point it acts, in m.
    pub trail: Option<V>,
    /// The length over which it follows, in m, and the joint that stands for the deflection of the tyre.
    pub relaxation: Option<(V, usize)>,
}

/// The freedoms of a body that nothing holds to the ground: the first joints, each on the one before.
#[derive(Clone, Copy, Debug, SerBin)]
pub struct Root {
    pub count: usize,
    /// The displacement along x, whose rate is the speed v.
    pub forward: usize,
    /// The displacement along y.
    pub lateral: usize,
    /// The rotation about z, by which the path turns.
    pub yaw: usize,
}

impl<V> Slip<V> {
    fn map<W, E>(&self, f: &mut impl FnMut(&V) -> Result<W, E>) -> Result<Slip<W>, E> {
        Ok(Slip {
            cornering: f(&self.cornering)?,
            camber: self.camber.as_ref().map(&mut *f).transpose()?,
            trail: self.trail.as_ref().map(&mut *f).transpose()?,
            relaxation: match &self.relaxation {
                Some((length, joint)) => Some((f(length)?, *joint)),
                None => None,
            },
        })
    }
}

impl<V> Mechanism<V> {
    /// The same with other formulas.
    pub fn map<W, E>(&self, mut f: impl FnMut(&V) -> Result<W, E>) -> Result<Mechanism<W>, E> {
        let f = &mut f;
        let joints = self.joints.iter().map(|joint| {
            Ok(Joint {
                name: joint.name.clone(),
                parent: joint.parent,
                motion: joint.motion,
                point: each(&joint.point, f)?,
                axis: each(&joint.axis, f)?,
                stiffness: joint.stiffness.as_ref().map(&mut *f).transpose()?,
                damping: joint.damping.as_ref().map(&mut *f).transpose()?,
            })
        });
        let joints = joints.collect::<Result<_, E>>()?;
        let bodies = self.bodies.iter().map(|body| {
            let [x, y, z] = &body.inertia;
            let inertia = [each(x, f)?, each(y, f)?, each(z, f)?];
            Ok(Body { joint: body.joint, mass: f(&body.mass)?, centre: each(&body.centre, f)?, inertia })
        });
        let bodies = bodies.collect::<Result<_, E>>()?;
        let wheels = self.wheels.iter().map(|wheel| {
            Ok(Wheel {
                spin: wheel.spin,
                centre: each(&wheel.centre, f)?,
                radius: f(&wheel.radius)?,
                tyre: wheel.tyre.as_ref().map(&mut *f).transpose()?,
                axial: f(&wheel.axial)?,
                slip: wheel.slip.as_ref().map(|slip| slip.map(f)).transpose()?,
            })
        });
        let wheels = wheels.collect::<Result<_, E>>()?;
        let gyrostats = self.gyrostats.iter().map(|(joint, momentum)| Ok((*joint, each(momentum, f)?)));
        let gyrostats = gyrostats.collect::<Result<_, E>>()?;
        let links = self.links.iter().map(|link| {
            let [from, to] = &link.points;
            Ok(Link {
                joints: link.joints,
                points: [each(from, f)?, each(to, f)?],
                stiffness: link.stiffness.as_ref().map(&mut *f).transpose()?,
                damping: link.damping.as_ref().map(&mut *f).transpose()?,
            })
        });
        let links = links.collect::<Result<_, E>>()?;
        let added = self.added.iter().map(|(name, rows)| {
            let rows = rows.iter().map(|row| row.iter().map(&mut *f).collect::<Result<_, E>>());
            Ok((*name, rows.collect::<Result<_, E>>()?))
        });
        let added = added.collect::<Result<_, E>>()?;
        let fed = self
            .fed
            .iter()
            .map(|Fed { on, of, matrix, formula }| Ok(Fed { on: *on, of: *of, matrix: *matrix, formula: f(formula)? }));
        let fed = fed.collect::<Result<_, E>>()?;
        Ok(Mechanism {
            joints,
            bodies,
            wheels,
            root: self.root,
            coordinates: self.coordinates.clone(),
            following: self.following.clone(),
            forces: self.forces.clone(),
            gyrostats,
            links,
            holds_speed: self.holds_speed,
            added,
            fed,
            gravity: self.gravity,
            loads: self.loads,
        })
    }

    /// Whether a wheel slips sideways.
    pub fn slips(&self) -> bool {
        self.wheels.iter().any(|wheel| wheel.slip.is_some())
    }

    /// Whether a force follows from the position of a joint.
    pub fn feeds_back(&self, joint: usize) -> bool {
        let positions = self.fed.iter().filter(|fed| Whole::Stiffness.parts().contains(&fed.matrix));
        positions.into_iter().any(|fed| fed.of == joint)
    }

    /// Whether a joint stands for the deflection of a tyre.
    pub fn is_deflection(&self, joint: usize) -> bool {
        let mut slips = self.wheels.iter().filter_map(|wheel| wheel.slip.as_ref());
        slips.any(|slip| slip.relaxation.as_ref().is_some_and(|(_, deflection)| *deflection == joint))
    }

    /// What a joint moves, in names of definitions.
    pub fn moved(&self, joint: usize) -> &str {
        if self.root.is_some_and(|root| joint < root.count) { "all" } else { &self.joints[joint].name }
    }

    /// A joint and those that it hangs on, the nearest first.
    pub fn path(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(Some(joint), |joint| self.joints[*joint].parent)
    }

    /// The one of two joints that is farther from the ground, if it hangs on the other.
    pub fn farther(&self, one: usize, other: usize) -> Option<usize> {
        let (near, far) = (one.min(other), one.max(other));
        self.path(far).any(|joint| joint == near).then_some(far)
    }
}

fn each<V, W, E>(vector: &[V; 3], f: &mut impl FnMut(&V) -> Result<W, E>) -> Result<[W; 3], E> {
    let [x, y, z] = vector;
    Ok([f(x)?, f(y)?, f(z)?])
}
