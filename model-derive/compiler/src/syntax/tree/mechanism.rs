//! The syntax tree of a mechanism.

use std::ops::Range;

use proc_macro2::{Ident, Span};

use super::expression::Expression;
use crate::report::Region;

/// `mechanism { … }`
#[derive(Debug)]
pub struct Mechanism {
    /// Its first word.
    pub span: Span,
    pub bodies: Vec<Body>,
    pub wheels: Vec<Wheel>,
    pub joints: Vec<Joint>,
    /// Each body with the one that it is fixed to.
    pub fixed: Vec<(Ident, Ident)>,
    pub free: Vec<Free>,
    pub links: Vec<Link>,
    pub forces: Vec<Force>,
    /// The word `forward` behind `hold`, where the forward speed is held constant.
    pub held: Option<Span>,
    /// The parts that could not be read, each with its name if it has one.
    pub unread: Vec<Option<Ident>>,
}

impl Mechanism {
    /// Without parts.
    pub fn new(span: Span) -> Self {
        let (bodies, wheels, joints) = (Vec::new(), Vec::new(), Vec::new());
        let (fixed, free, links, forces) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Self { span, bodies, wheels, joints, fixed, free, links, forces, held: None, unread: Vec::new() }
    }

    /// The names of joints, freedoms and deflections of tyres, each with whether it turns.
    pub fn named(&self) -> impl Iterator<Item = (&Ident, bool)> {
        let joints = self.joints.iter().map(|joint| (&joint.name, joint.kind == JointKind::Revolute));
        let freedoms = self.free.iter().flat_map(|free| &free.names);
        let freedoms = freedoms.map(|(freedom, name)| (name, freedom.turns()));
        joints.chain(freedoms).chain(self.wheels.iter().filter_map(Wheel::deflection).map(|name| (name, false)))
    }

    /// The joints of one statement, from the parent to the child: one, or those of a joint with several freedoms.
    pub fn chain(&self, joint: usize) -> Range<usize> {
        let first = joint - self.joints[joint].rank;
        let others = self.joints[first + 1..].iter().take_while(|joint| joint.rank > 0).count();
        first..first + 1 + others
    }

    /// The unit of a force or torque on what has a name; what is no joint is a wheel, which is turned.
    pub fn force_unit(&self, on: &Ident) -> &'static str {
        if self.named().any(|(name, turns)| name == on && !turns) { "N" } else { "N*m" }
    }

    /// All formulas in it.
    pub fn formulas(&self) -> impl Iterator<Item = &Expression> {
        let bodies = self.bodies.iter().filter_map(|body| body.mass.as_ref()).flat_map(|(mass, centre, inertia)| {
            let moments = match inertia {
                Inertia::None => Vec::new(),
                Inertia::Principal(moments) => moments.iter().collect(),
                Inertia::Full(rows) => rows.iter().flatten().collect(),
            };
            [mass].into_iter().chain(&centre.components).chain(moments)
        });
        let wheels = self.wheels.iter().flat_map(|wheel| {
            let moments = [&wheel.mass, &wheel.radius, &wheel.axial, &wheel.radial];
            let slip = wheel.slip.iter().flat_map(Slip::formulas);
            moments.into_iter().chain(&wheel.centre.components).chain(&wheel.tyre).chain(slip)
        });
        let joints = self.joints.iter().flat_map(|joint| {
            let vectors = joint.through.iter().chain(joint.axis.along());
            vectors.flat_map(|vector| &vector.components).chain(&joint.spring).chain(&joint.damper)
        });
        let momenta = self.bodies.iter().flat_map(|body| &body.momentum).flat_map(|momentum| &momentum.components);
        let links = self.links.iter().flat_map(|link| {
            let ends = link.ends.iter().flat_map(|(_, point)| &point.components);
            ends.chain(&link.spring).chain(&link.damper)
        });
        bodies.chain(wheels).chain(joints).chain(momenta).chain(links)
    }
}

/// `(x, y, z)`
#[derive(Clone, Debug)]
pub struct Vector {
    pub components: [Expression; 3],
    pub region: Region,
}

/// A moment of inertia about the centre of mass.
#[derive(Clone, Debug)]
pub enum Inertia {
    /// Of a point mass.
    None,
    Principal(Box<[Expression; 3]>),
    Full(Box<[[Expression; 3]; 3]>),
}

/// `body B "rear frame": mass mB, at (xB, 0, zB), inertia [[…], […], […]];`
#[derive(Debug)]
pub struct Body {
    pub name: Ident,
    pub label: Option<String>,
    /// The mass, its centre and the inertia about it, of a body that is not massless.
    pub mass: Option<(Expression, Vector, Inertia)>,
    /// The angular momentum of what spins in it at a constant rate.
    pub momentum: Option<Vector>,
}

/// `wheel R "rear wheel" on B: mass mR, at (0, 0, -rR), radius rR, axial IRyy, radial IRxx;`
#[derive(Debug)]
pub struct Wheel {
    pub name: Ident,
    pub label: Option<String>,
    /// None for a wheel that is free itself.
    pub carrier: Option<Ident>,
    pub mass: Expression,
    pub centre: Vector,
    pub radius: Expression,
    pub tyre: Option<Expression>,
    pub axial: Expression,
    pub radial: Expression,
    /// Of a wheel that slips sideways.
    pub slip: Option<Slip>,
}

/// `cornering C, camber G, trail t, relaxation s, deflection e`: the side force of a tyre that slips.
#[derive(Debug)]
pub struct Slip {
    /// Side force by slip angle.
    pub cornering: Expression,
    /// Side force by camber angle.
    pub camber: Option<Expression>,
    /// How far behind the contact point the side force acts.
    pub trail: Option<Expression>,
    /// Over what length the force follows, and the coordinate of first order that is the deflection of the tyre.
    pub relaxation: Option<(Expression, Ident)>,
}

impl Slip {
    /// The formulas in it.
    pub fn formulas(&self) -> impl Iterator<Item = &Expression> {
        let relaxation = self.relaxation.iter().map(|(length, _)| length);
        [&self.cornering].into_iter().chain(&self.camber).chain(&self.trail).chain(relaxation)
    }
}

impl Wheel {
    /// The coordinate that is the deflection of its tyre, if its side force relaxes.
    pub fn deflection(&self) -> Option<&Ident> {
        self.slip.as_ref()?.relaxation.as_ref().map(|(_, deflection)| deflection)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointKind {
    Revolute,
    Prismatic,
}

/// `revolute delta: B to H, through (w + c, 0, 0), along (sin(lam), 0, cos(lam));`
#[derive(Debug)]
pub struct Joint {
    pub kind: JointKind,
    /// The coordinate.
    pub name: Ident,
    pub parent: Ident,
    pub child: Ident,
    /// How many joints are between it and the parent: those before it of a joint with several freedoms.
    pub rank: usize,
    /// Of a revolute joint; none for one that is at the point of the joint before it.
    pub through: Option<Vector>,
    pub axis: Axis,
    pub spring: Option<Expression>,
    pub damper: Option<Expression>,
}

/// The direction of the axis of a joint.
#[derive(Clone, Debug)]
pub enum Axis {
    Along(Box<Vector>),
    /// One of the axes of the model.
    Own(usize),
    /// Across those of the two joints before it.
    Normal,
}

impl Axis {
    /// Where it is written, if it is.
    pub fn along(&self) -> Option<&Vector> {
        match self {
            Self::Along(vector) => Some(vector),
            Self::Own(_) | Self::Normal => None,
        }
    }
}

/// `free B: lean phi, yaw psi;`
#[derive(Debug)]
pub struct Free {
    pub body: Ident,
    pub names: Vec<(Freedom, Ident)>,
}

/// The freedoms of a body on the ground: displacements, of which the first is beside the motion at the speed v, then rotations about the vertical, the
/// forward and the lateral axis, each turned by those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Freedom {
    Forward,
    Lateral,
    Vertical,
    Yaw,
    Lean,
    Pitch,
}

impl Freedom {
    /// In the order in which each turns the axes of the next.
    pub const ALL: [Self; 6] = [Self::Forward, Self::Lateral, Self::Vertical, Self::Yaw, Self::Lean, Self::Pitch];

    /// As it is written.
    pub fn word(self) -> &'static str {
        match self {
            Self::Forward => "forward",
            Self::Lateral => "lateral",
            Self::Vertical => "vertical",
            Self::Yaw => "yaw",
            Self::Lean => "lean",
            Self::Pitch => "pitch",
        }
    }

    /// What it is, as a noun.
    pub fn noun(self) -> &'static str {
        match self {
            Self::Forward => "forward motion",
            Self::Lateral => "lateral motion",
            Self::Vertical => "vertical motion",
            other => other.word(),
        }
    }

    /// Whether it is a rotation.
    pub fn turns(self) -> bool {
        matches!(self, Self::Yaw | Self::Lean | Self::Pitch)
    }

    /// The freedom called `word`.
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|freedom| freedom.word() == word)
    }
}

/// `link S: A to B, from (x, y, z), to (x, y, z), spring k, damper d;`: between points of two bodies.
#[derive(Debug)]
pub struct Link {
    pub name: Ident,
    /// Two bodies, or the ground, each with the point that it is fastened at.
    pub ends: [(Ident, Vector); 2],
    pub spring: Option<Expression>,
    pub damper: Option<Expression>,
}

/// `force T "steer torque" on delta;`
#[derive(Debug)]
pub struct Force {
    pub name: Ident,
    pub label: Option<String>,
    /// The coordinate of the joint that it acts on, or the wheel whose spin it drives.
    pub on: Ident,
}
