//! The syntax tree of a declaration.

use proc_macro2::{Ident, Span, TokenStream};

use super::expression::Expression;
use super::unit::Unit;
use crate::report::Region;

/// Documentation lines, joined.
pub type Doc = String;

/// A whole `model!` declaration.
#[derive(Debug)]
pub struct Declaration {
    pub docs: Doc,
    pub visibility: TokenStream,
    pub name: Ident,
    /// Where the model comes from.
    pub source: Option<String>,
    pub parameters: Vec<Parameter>,
    pub definitions: Vec<Definition>,
    pub requirements: Vec<Requirement>,
    pub assertions: Vec<Assertion>,
    /// Matrices whose entries are asserted.
    pub asserted: Vec<Matrix>,
    pub sets: Vec<ParameterSet>,
    pub coordinates: Vec<Coordinate>,
    pub matrices: Vec<Matrix>,
    /// What the matrices are derived from, unless they are written.
    pub mechanism: Option<Mechanism>,
    /// What else is derived from it.
    pub kinematics: Option<Kinematics>,
    /// Names of statements that could not be read: they exist, so using them is no further mistake.
    pub unread: Vec<Ident>,
}

/// `lam "λ": rad, in (-pi/2, pi/2);`
#[derive(Debug)]
pub struct Parameter {
    pub docs: Doc,
    pub name: Ident,
    pub symbol: Option<String>,
    /// Nothing if it could not be read.
    pub unit: Option<Unit>,
    pub bounds: Vec<Bound>,
    pub direction: Option<Direction>,
    /// The span of the word `gravity`, for the parameter that is the gravitational field strength.
    pub gravity: Option<Span>,
    /// The span of the word `unused`, for a parameter that no matrix depends on.
    pub unused: Option<Span>,
}

/// `along x`, `along x*z`, `about y`: how a quantity lies in the axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// A component of a vector, or of a tensor: for each axis whether it occurs an odd number of times.
    Along([bool; 3]),
    /// An angle about an axis, x, y or z.
    About(usize),
}

/// A constant, in the unit that is written behind it or in that of what it belongs to.
#[derive(Clone, Debug)]
pub struct Value {
    pub number: Expression,
    pub unit: Option<Unit>,
}

impl Value {
    pub fn region(&self) -> Region {
        self.unit.as_ref().map_or(self.number.region, |unit| self.number.region.to(unit.region))
    }
}

/// One end of a domain: `> 0`.
#[derive(Debug)]
pub struct Bound {
    pub relation: Relation,
    pub value: Value,
    pub region: Region,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    Greater,
    GreaterEqual,
    Less,
    LessEqual,
    NotEqual,
}

/// `let mT = mR + mB;`
#[derive(Debug)]
pub struct Definition {
    pub name: Ident,
    pub value: Expression,
    /// Whether it comes from a mechanism.
    pub derived: bool,
}

/// `require mH + mF > 0;`
#[derive(Debug)]
pub struct Requirement {
    pub value: Expression,
    pub bound: Bound,
}

/// `assert mu*w == c*cos(lam);`
#[derive(Debug)]
pub struct Assertion {
    pub left: Expression,
    pub right: Expression,
    /// What the left side is called, if it is the entry of a matrix.
    pub entry: Option<String>,
}

/// `set benchmark "source" { w = 1.02; }`
#[derive(Debug)]
pub struct ParameterSet {
    pub docs: Doc,
    pub name: Ident,
    pub source: Option<String>,
    pub values: Vec<SetValue>,
    /// Matrices that the source of the set publishes for it.
    pub published: Vec<Published>,
}

/// `w = 1.02;`
#[derive(Debug)]
pub struct SetValue {
    pub name: Ident,
    /// Nothing if it could not be read.
    pub value: Option<Value>,
}

/// `M = [[80.81722, 2.31941332208709], …];` in a set: results as they were printed.
#[derive(Debug)]
pub struct Published {
    pub name: MatrixName,
    pub span: Span,
    /// The rows, each with its region.
    pub rows: Vec<(Region, Vec<Printed>)>,
    pub region: Region,
}

/// A printed number, with all its digits.
#[derive(Clone, Debug)]
pub struct Printed {
    pub text: String,
    pub region: Region,
}

/// `phi "lean": rad;`
#[derive(Debug)]
pub struct Coordinate {
    pub docs: Doc,
    pub name: Ident,
    pub label: Option<String>,
    /// Nothing if it could not be read.
    pub unit: Option<Unit>,
    pub direction: Option<Direction>,
}

/// `M = [[a, b], [b, c]];`
#[derive(Debug)]
pub struct Matrix {
    pub name: MatrixName,
    /// Whether the word `symmetric` stands before it.
    pub symmetric: bool,
    pub span: Span,
    /// The rows, each with its region.
    pub rows: Vec<(Region, Vec<Expression>)>,
    /// The brackets and all between.
    pub region: Region,
}

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
    pub forces: Vec<Force>,
    /// The parts that could not be read, each with its name if it has one.
    pub unread: Vec<Option<Ident>>,
}

impl Mechanism {
    /// Without parts.
    pub fn new(span: Span) -> Self {
        let (bodies, wheels, joints) = (Vec::new(), Vec::new(), Vec::new());
        let (fixed, free, forces) = (Vec::new(), Vec::new(), Vec::new());
        Self { span, bodies, wheels, joints, fixed, free, forces, unread: Vec::new() }
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
            moments.into_iter().chain(&wheel.centre.components).chain(&wheel.tyre)
        });
        let joints = self.joints.iter().flat_map(|joint| {
            let point = joint.through.iter().flat_map(|through| &through.components);
            point.chain(&joint.along.components).chain(&joint.spring).chain(&joint.damper)
        });
        bodies.chain(wheels).chain(joints)
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
    /// Of a revolute joint.
    pub through: Option<Vector>,
    pub along: Vector,
    pub spring: Option<Expression>,
    pub damper: Option<Expression>,
}

/// `free B: lean phi, yaw psi;`
#[derive(Debug)]
pub struct Free {
    pub body: Ident,
    pub names: Vec<(Freedom, Ident)>,
}

/// The freedoms of a body on the ground, beside the forward motion: displacements, then rotations about the vertical, the
/// forward and the lateral axis, each turned by those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Freedom {
    Lateral,
    Vertical,
    Yaw,
    Lean,
    Pitch,
}

impl Freedom {
    /// In the order in which each turns the axes of the next.
    pub const ALL: [Self; 5] = [Self::Lateral, Self::Vertical, Self::Yaw, Self::Lean, Self::Pitch];

    /// As it is written.
    pub fn word(self) -> &'static str {
        match self {
            Self::Lateral => "lateral",
            Self::Vertical => "vertical",
            Self::Yaw => "yaw",
            Self::Lean => "lean",
            Self::Pitch => "pitch",
        }
    }

    /// The freedom called `word`.
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|freedom| freedom.word() == word)
    }
}

/// `force T "steer torque" on delta;`
#[derive(Debug)]
pub struct Force {
    pub name: Ident,
    pub label: Option<String>,
    /// The coordinate of the joint that it acts on.
    pub on: Ident,
}

/// Rates and forces that are derived from a mechanism beside the matrices.
#[derive(Debug)]
pub struct Kinematics<V = Expression> {
    /// The bodies and wheels, each with what it is.
    pub parts: Vec<String>,
    pub rates: Vec<Rate<V>>,
    /// The names of applied forces, each with what it is and its unit.
    pub applied: Vec<[String; 3]>,
    /// For each coordinate, by applied force.
    pub forces: Vec<Vec<V>>,
}

/// The rate of a joint that is no coordinate: `v speed + rates · q' + v (coordinates · q + heading psi)`, with the yaw psi
/// where that is no coordinate.
#[derive(Debug)]
pub struct Rate<V = Expression> {
    pub name: String,
    /// What it is.
    pub docs: String,
    pub speed: V,
    pub rates: Vec<V>,
    pub coordinates: Vec<V>,
    pub heading: V,
}

impl<V> Kinematics<V> {
    /// The same with other formulas, taken one by one in a fixed order.
    pub fn map<W>(&self, mut f: impl FnMut(&V) -> W) -> Kinematics<W> {
        let rates = self.rates.iter().map(|rate| Rate {
            name: rate.name.clone(),
            docs: rate.docs.clone(),
            speed: f(&rate.speed),
            rates: rate.rates.iter().map(&mut f).collect(),
            coordinates: rate.coordinates.iter().map(&mut f).collect(),
            heading: f(&rate.heading),
        });
        let rates = rates.collect();
        let forces = self.forces.iter().map(|row| row.iter().map(&mut f).collect()).collect();
        Kinematics { parts: self.parts.clone(), rates, applied: self.applied.clone(), forces }
    }

    /// All formulas, in the order of [`Kinematics::map`].
    pub fn formulas(&self) -> impl Iterator<Item = &V> {
        let rates = self.rates.iter().flat_map(|rate| {
            [&rate.speed].into_iter().chain(&rate.rates).chain(&rate.coordinates).chain([&rate.heading])
        });
        rates.chain(self.forces.iter().flatten())
    }
}

/// The six coefficient matrices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum MatrixName {
    M,
    C0,
    C1,
    Kc,
    K0,
    K2,
}

impl MatrixName {
    /// All of them, in the order of the equation of motion.
    pub const ALL: [Self; 6] = [Self::M, Self::C0, Self::C1, Self::Kc, Self::K0, Self::K2];

    /// As it is written in a declaration.
    pub fn name(self) -> &'static str {
        match self {
            Self::M => "M",
            Self::C0 => "C0",
            Self::C1 => "C1",
            Self::Kc => "Kc",
            Self::K0 => "K0",
            Self::K2 => "K2",
        }
    }

    /// The matrix called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|matrix| matrix.name() == name)
    }

    /// The field that holds it in generated code.
    pub fn field(self) -> &'static str {
        match self {
            Self::M => "m",
            Self::C0 => "c0",
            Self::C1 => "c1",
            Self::Kc => "kc",
            Self::K0 => "k0",
            Self::K2 => "k2",
        }
    }

    /// What it is, with its place in the equation of motion.
    pub fn docs(self) -> &'static str {
        match self {
            Self::M => "Mass matrix M, the coefficient of q''.",
            Self::C0 => "Damping C0, a coefficient of q'.",
            Self::C1 => "Damping C1, a coefficient of v q'.",
            Self::Kc => "Stiffness Kc, a coefficient of q.",
            Self::K0 => "Stiffness K0, a coefficient of g q.",
            Self::K2 => "Stiffness K2, a coefficient of v^2 q.",
        }
    }
}
