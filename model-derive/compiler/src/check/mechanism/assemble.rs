//! The parts of a mechanism, resolved and in the order of its tree.

use proc_macro2::Ident;

use super::named::{direction, named};
use super::tree::{Role, Tree};
use crate::check::names::Scope;
use crate::check::resolve;
use crate::formula::Formula;
use crate::mechanics::{self, Motion, Root};
use crate::report::Report;
use crate::syntax::{Declaration, Freedom, Inertia, JointKind, Mechanism, Vector};

const AXES: [&str; 3] = ["x", "y", "z"];

/// The mechanism that the derivation takes, if there is a tree; formulas are resolved in any case, for their mistakes.
pub fn assemble(
    declaration: &Declaration,
    mechanism: &Mechanism,
    tree: Option<&Tree>,
    new: &[usize],
    scope: &mut Scope,
    report: &mut Report,
) -> Option<mechanics::Mechanism<Formula>> {
    let mut formulas = Formulas { new, scope, report };
    let joints: Vec<_> = mechanism
        .joints
        .iter()
        .map(|joint| Held {
            point: joint.through.as_ref().map_or(origin(), |point| formulas.vector(point)),
            axis: formulas.vector(&joint.along),
            stiffness: joint.spring.as_ref().map(|spring| formulas.of(spring)),
            damping: joint.damper.as_ref().map(|damper| formulas.of(damper)),
        })
        .collect();
    let masses: Vec<_> = mechanism
        .bodies
        .iter()
        .map(|body| {
            let (mass, centre, inertia) = body.mass.as_ref()?;
            Some((formulas.of(mass), formulas.vector(centre), formulas.inertia(inertia, &body.name)))
        })
        .collect();
    let wheels: Vec<_> = mechanism
        .wheels
        .iter()
        .map(|wheel| Rolling {
            mass: formulas.of(&wheel.mass),
            centre: formulas.vector(&wheel.centre),
            radius: formulas.of(&wheel.radius),
            tyre: wheel.tyre.as_ref().map(|tyre| formulas.of(tyre)),
            axial: formulas.of(&wheel.axial),
            radial: formulas.of(&wheel.radial),
        })
        .collect();
    let named = named(declaration, mechanism, tree.is_some(), report);
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
            Role::Forward => joint("forward".into(), Motion::Slides, Held::at_origin(0)),
            Role::Freedom(freedom) => {
                let (motion, axis) = direction(freedom);
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
    let root = position(Role::Forward).zip(position(Role::Freedom(Freedom::Yaw)));
    let find = |name: &Ident| {
        let (_, role) = named.iter().find(|(known, _)| *known == name)?;
        position(*role)
    };
    let coordinates = declaration.coordinates.iter().map(|coordinate| find(&coordinate.name)).collect::<Option<_>>()?;
    let forces = mechanism.forces.iter().map(|force| find(&force.on)).collect::<Option<_>>()?;
    Some(mechanics::Mechanism {
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
            })
            .collect(),
        root: root.map(|(forward, yaw)| Root { count: tree.root(), forward, yaw }),
        coordinates,
        forces,
        has_weight: declaration.parameters.iter().any(|parameter| parameter.gravity.is_some()),
    })
}

fn freedom_name(mechanism: &Mechanism, freedom: Freedom) -> String {
    let names = mechanism.free.iter().flat_map(|free| &free.names);
    let mut names = names.filter(|(known, _)| *known == freedom);
    names.next().map_or(freedom.word().to_string(), |(_, name)| name.to_string())
}

fn origin() -> [Formula; 3] {
    [(); 3].map(|()| Formula::zero())
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
        let axis = [0, 1, 2].map(|other| if other == axis { Formula::one() } else { Formula::zero() });
        Self { point: origin(), axis, stiffness: None, damping: None }
    }
}

struct Rolling {
    mass: Formula,
    centre: [Formula; 3],
    radius: Formula,
    tyre: Option<Formula>,
    axial: Formula,
    radial: Formula,
}

struct Formulas<'a> {
    /// For each definition of the declaration its place in the order of definitions.
    new: &'a [usize],
    scope: &'a mut Scope,
    report: &'a mut Report,
}

impl Formulas<'_> {
    fn of(&mut self, formula: &crate::syntax::Expression) -> Formula {
        resolve::expression(formula, self.scope, self.report).renumbered(self.new)
    }

    fn vector(&mut self, vector: &Vector) -> [Formula; 3] {
        vector.components.each_ref().map(|component| self.of(component))
    }

    fn inertia(&mut self, inertia: &Inertia, body: &Ident) -> [[Formula; 3]; 3] {
        match inertia {
            Inertia::None => diagonal(origin()),
            Inertia::Principal(moments) => diagonal(moments.each_ref().map(|moment| self.of(moment))),
            Inertia::Full(written) => {
                let rows = written.each_ref().map(|row| row.each_ref().map(|entry| self.of(entry)));
                for (row, column) in [(0, 1), (0, 2), (1, 2)] {
                    if rows[row][column] == rows[column][row] {
                        continue;
                    }
                    let name = |row: usize, column: usize| format!("{}{}", AXES[row], AXES[column]);
                    let (above, below) = (&written[row][column], &written[column][row]);
                    let message = format!(
                        "the inertia of `{body}` is not symmetric: its entry {} is `{}`, and {} is `{}`; expected the same \
                         formula",
                        name(row, column),
                        above.to_string(),
                        name(column, row),
                        below.to_string(),
                    );
                    self.report.error(below.region, message);
                }
                rows
            }
        }
    }
}
