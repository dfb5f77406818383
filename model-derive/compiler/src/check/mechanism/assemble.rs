//! The parts of a mechanism, resolved and in the order of its tree.

use proc_macro2::Ident;

use super::coordinates::{axis_of, find_joints};
use super::tree::{Role, Tree};
use crate::formula::{Factor, Formula, Term};
use crate::mechanics::{self, Motion, Root};
use crate::report::Report;
use crate::states::States;
use crate::syntax::{Axis, Declaration, Freedom, Inertia, JointKind, Mechanism};

const AXES: [&str; 3] = ["x", "y", "z"];

/// A mechanism as the derivation takes it, and its tree in the declaration.
#[derive(Debug)]
pub struct Assembly {
    pub mechanism: mechanics::Mechanism<Formula>,
    pub tree: Tree,
    /// The formulas that it was assembled from.
    pub attributes: Vec<Formula>,
}

/// Puts the parts of a mechanism in the order of its tree, if there is one; `attributes` are the formulas of
/// [`Declaration::attributes`], and `loads` is the first parameter in them that stands for the load of a wheel.
/// Mistakes are reported in any case.
pub fn assemble(
    declaration: &Declaration,
    mechanism: &Mechanism,
    tree: Option<Tree>,
    attributes: &[Formula],
    loads: Option<usize>,
    report: &mut Report,
) -> Option<Assembly> {
    let written = attributes;
    // In the order of `Declaration::attributes`.
    let mut attributes = Attributes(written.iter().cloned());
    let masses: Vec<_> = mechanism
        .bodies
        .iter()
        .map(|body| {
            let (_, _, inertia) = body.mass.as_ref()?;
            let (mass, centre) = (attributes.next(), attributes.vector());
            Some((mass, centre, attributes.inertia(inertia, &body.name, report)))
        })
        .collect();
    let wheels: Vec<_> = mechanism
        .wheels
        .iter()
        .map(|wheel| {
            let [mass, radius, axial, radial] = [(); 4].map(|()| attributes.next());
            let centre = attributes.vector();
            let tyre = wheel.tyre.as_ref().map(|_| attributes.next());
            let slip = wheel.slip.as_ref().map(|slip| mechanics::Slip {
                cornering: attributes.next(),
                camber: slip.camber.as_ref().map(|_| attributes.next()),
                trail: slip.trail.as_ref().map(|_| attributes.next()),
                // Where its coordinate is will be known with the tree.
                relaxation: slip.relaxation.as_ref().map(|_| (attributes.next(), 0)),
            });
            Rolling { mass, centre, radius, tyre, axial, radial, slip }
        })
        .collect();
    let mut joints: Vec<Held> = Vec::new();
    for joint in &mechanism.joints {
        let point = match (&joint.through, joints.last()) {
            (Some(_), _) => attributes.vector(),
            (None, Some(last)) if joint.rank > 0 => last.point.clone(),
            _ => origin(),
        };
        let axis = match (&joint.axis, &joints[..]) {
            (Axis::Along(_), _) => attributes.vector(),
            (Axis::Own(own), _) => unit_vector(*own),
            (Axis::Normal, [.., first, second]) => cross(&first.axis, &second.axis),
            (Axis::Normal, _) => unreachable!("two joints before it"),
        };
        let stiffness = joint.spring.as_ref().map(|_| attributes.next());
        let damping = joint.damper.as_ref().map(|_| attributes.next());
        joints.push(Held { point, axis, stiffness, damping });
    }
    let momenta: Vec<_> =
        mechanism.bodies.iter().map(|body| body.momentum.as_ref().map(|_| attributes.vector())).collect();
    let fastened: Vec<_> = mechanism
        .links
        .iter()
        .map(|link| {
            let points = [(); 2].map(|()| attributes.vector());
            let [stiffness, damping] =
                [&link.spring, &link.damper].map(|held| held.as_ref().map(|_| attributes.next()));
            (points, stiffness, damping)
        })
        .collect();
    let added = declaration.added.iter().map(|matrix| {
        let rows = matrix.rows.iter().map(|(_, row)| row.iter().map(|_| attributes.next()).collect());
        (matrix.name, rows.collect())
    });
    let added = added.collect();
    let named = find_joints(declaration, mechanism, tree.is_some(), report);
    let tree = tree?;

    let parts = tree.joints.iter().map(|node| {
        let joint = |name: String, motion, held: Held| mechanics::Joint {
            name,
            parent: node.parent,
            motion,
            point: held.point,
            axis: held.axis,
            stiffness: held.stiffness,
            damping: held.damping,
        };
        match node.role {
            Role::Freedom(freedom) => {
                let (motion, axis) = axis_of(freedom);
                joint(freedom_name(mechanism, freedom), motion, Held::at_origin(axis))
            }
            Role::Joint(index) => {
                let declared = &mechanism.joints[index];
                let motion = if declared.kind == JointKind::Revolute { Motion::Turns } else { Motion::Slides };
                joint(declared.name.to_string(), motion, joints[index].clone())
            }
            Role::Spin(index) => {
                let point = wheels[index].centre.clone();
                let name = format!("spin_{}", mechanism.wheels[index].name);
                joint(name, Motion::Turns, Held { point, ..Held::at_origin(1) })
            }
            Role::Deflection(index) => {
                let name = mechanism.wheels[index].deflection().map(Ident::to_string).unwrap_or_default();
                joint(name, Motion::Slides, Held::at_origin(1))
            }
        }
    });
    let joints: Vec<_> = parts.collect();
    let bodies = masses.into_iter().enumerate().filter_map(|(index, mass)| {
        let (mass, centre, inertia) = mass?;
        Some(mechanics::Body { joint: tree.moved_by[index], mass, centre, inertia })
    });
    let spin = |index: usize| tree.moved_by[mechanism.bodies.len() + index];
    let rims = wheels.iter().enumerate().map(|(index, wheel)| {
        let [axial, radial] = [&wheel.axial, &wheel.radial].map(Clone::clone);
        let inertia = diagonal([radial.clone(), axial, radial]);
        mechanics::Body { joint: spin(index), mass: wheel.mass.clone(), centre: wheel.centre.clone(), inertia }
    });
    let bodies = bodies.chain(rims).collect();
    let position = |role: Role| tree.joints.iter().position(|node| node.role == role);
    let freedom = |freedom: Freedom| position(Role::Freedom(freedom));
    let root = freedom(Freedom::Forward).zip(freedom(Freedom::Lateral).zip(freedom(Freedom::Yaw)));
    let find = |name: &Ident| {
        let (_, role) = named.iter().find(|(known, _)| *known == name)?;
        position(*role)
    };
    let coordinates = declaration.coordinates.iter().map(|coordinate| find(&coordinate.name));
    let coordinates: Vec<usize> = coordinates.collect::<Option<_>>()?;
    let driven = |name: &Ident| mechanism.wheels.iter().position(|wheel| wheel.name == *name).map(spin);
    let forces = mechanism.forces.iter().map(|force| find(&force.on).or_else(|| driven(&force.on)));
    let forces = forces.collect::<Option<_>>()?;
    let following = declaration.states().zip(&coordinates).filter_map(|(states, joint)| {
        let holds = matches!(tree.joints[*joint].role, Role::Deflection(_));
        (states == Some(States::Position) && !holds).then_some(*joint)
    });
    let gyrostats = momenta.into_iter().enumerate();
    let gyrostats = gyrostats.filter_map(|(body, momentum)| Some((tree.moved_by[body], momentum?))).collect();
    let body = |name: &Ident| mechanism.bodies.iter().position(|body| body.name == *name);
    let links = mechanism.links.iter().zip(fastened).map(|(link, (points, stiffness, damping))| {
        let joints = link.ends.each_ref().map(|(name, _)| body(name).map(|body| tree.moved_by[body]));
        mechanics::Link { joints, points, stiffness, damping }
    });
    let links = links.collect();
    let mechanism = mechanics::Mechanism {
        joints,
        bodies,
        wheels: wheels
            .into_iter()
            .enumerate()
            .map(|(index, wheel)| mechanics::Wheel {
                spin: spin(index),
                centre: wheel.centre,
                radius: wheel.radius,
                tyre: wheel.tyre,
                axial: wheel.axial,
                slip: wheel.slip.map(|slip| mechanics::Slip {
                    relaxation: slip
                        .relaxation
                        .zip(position(Role::Deflection(index)))
                        .map(|((length, _), joint)| (length, joint)),
                    ..slip
                }),
            })
            .collect(),
        root: root.map(|(forward, (lateral, yaw))| Root { count: tree.root(), forward, lateral, yaw }),
        following: following.collect(),
        coordinates,
        forces,
        gyrostats,
        links,
        holds_speed: mechanism.held.is_some(),
        added,
        fed: Vec::new(),
        gravity: declaration.parameters.iter().position(|parameter| parameter.gravity.is_some()),
        loads,
    };
    Some(Assembly { mechanism, tree, attributes: written.to_vec() })
}

fn freedom_name(mechanism: &Mechanism, freedom: Freedom) -> String {
    let names = mechanism.free.iter().flat_map(|free| &free.names);
    let mut names = names.filter(|(known, _)| *known == freedom);
    names.next().map_or(freedom.word().to_string(), |(_, name)| name.to_string())
}

fn origin() -> [Formula; 3] {
    [(); 3].map(|()| Formula::zero())
}

fn unit_vector(axis: usize) -> [Formula; 3] {
    [0, 1, 2].map(|other| if other == axis { Formula::one() } else { Formula::zero() })
}

fn cross(a: &[Formula; 3], b: &[Formula; 3]) -> [Formula; 3] {
    let product = |a: &Formula, b: &Formula| Formula::Product([a, b].map(|part| Factor::times(part.clone())).to_vec());
    [(1, 2), (2, 0), (0, 1)].map(|(next, last)| {
        Formula::Sum(vec![Term::plus(product(&a[next], &b[last])), Term::minus(product(&a[last], &b[next]))])
    })
}

fn diagonal([x, y, z]: [Formula; 3]) -> [[Formula; 3]; 3] {
    let zero = Formula::zero;
    [[x, zero(), zero()], [zero(), y, zero()], [zero(), zero(), z]]
}

/// Where a joint is and what holds it.
#[derive(Clone)]
struct Held {
    point: [Formula; 3],
    axis: [Formula; 3],
    stiffness: Option<Formula>,
    damping: Option<Formula>,
}

impl Held {
    fn at_origin(axis: usize) -> Self {
        Self { point: origin(), axis: unit_vector(axis), stiffness: None, damping: None }
    }
}

struct Rolling {
    mass: Formula,
    centre: [Formula; 3],
    radius: Formula,
    tyre: Option<Formula>,
    axial: Formula,
    radial: Formula,
    slip: Option<mechanics::Slip<Formula>>,
}

/// The formulas of a mechanism, which are taken one by one in a fixed order.
struct Attributes<I>(I);

impl<I: Iterator<Item = Formula>> Attributes<I> {
    fn next(&mut self) -> Formula {
        self.0.next().unwrap_or_else(|| unreachable!("one for each formula of the declaration"))
    }

    fn vector(&mut self) -> [Formula; 3] {
        [(); 3].map(|()| self.next())
    }

    fn inertia(&mut self, inertia: &Inertia, body: &Ident, report: &mut Report) -> [[Formula; 3]; 3] {
        match inertia {
            Inertia::None => diagonal(origin()),
            Inertia::Principal(_) => diagonal(self.vector()),
            Inertia::Full(written) => {
                let rows = [(); 3].map(|()| self.vector());
                for (row, column) in [(0, 1), (0, 2), (1, 2)] {
                    if rows[row][column] == rows[column][row] {
                        continue;
                    }
                    let name = |row: usize, column: usize| format!("{}{}", AXES[row], AXES[column]);
                    let (above, below) = (&written[row][column], &written[column][row]);
                    let message = format!(
                        "the inertia of `{body}` is not symmetric: its entry {} is `{above}`, and {} is `{below}`; expected \
                         the same formula",
                        name(row, column),
                        name(column, row),
                    );
                    report.error(below.region, message);
                }
                rows
            }
        }
    }
}
