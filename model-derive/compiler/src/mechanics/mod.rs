//! The linearized equations of motion of a mechanism about upright straight running, exact to first order.
//!
//! Each joint, and each of the six freedoms of a body on the ground, has a coordinate. In the reference motion nothing
//! accelerates, so velocities to first order give the inertial forces; of second order only the heights of the centres of
//! mass and of the contact points are needed, which gravity and the steady loads of the wheels multiply. The conditions
//! of rolling without slip are solved for the rates of all joints that are no coordinates, and the equations of motion
//! are projected on the motions that are left.

mod by_bodies;
mod composite;
mod contact;
mod elimination;
mod feedback;
mod formulas;
mod links;
mod loads;
mod massless;
mod matrix;
mod mechanism;
mod motion;
mod projection;
mod slip;
mod unreduced;
mod vectors;

pub use self::mechanism::{Body, Fed, Joint, Link, Mechanism, Motion, Root, Slip, Wheel};

use nanoserde::{DeBin, SerBin};

use self::by_bodies::sum_over_bodies;
use self::contact::Contact;
use self::formulas::Formulas;
use self::motion::Motions;
use self::projection::Projection;
use self::unreduced::Unreduced;
use crate::formula::Formula;
use crate::matrix_name::MatrixName;
use crate::states::States;
use crate::symbolic::{self, Engine, EngineFailure, Failure, Form, Place};

/// Square matrices of formulas, those that are not zero, in the order of the equation of motion.
type Matrices<V = Form> = Vec<(MatrixName, Vec<Vec<V>>)>;

/// What is derived from a mechanism: formulas in the parameters, the definitions of the model, and behind these in those
/// of the derivation.
#[derive(Debug, DeBin, SerBin)]
pub struct Derivation {
    /// Names and formulas; names may occur twice.
    pub definitions: Vec<(String, Formula)>,
    pub matrices: Matrices<Formula>,
    /// The same matrices in formulas that are summed over the bodies, if they are proved to be the same.
    pub by_bodies: Option<Matrices<Formula>>,
    /// For each coordinate which of its position and its rate are states.
    pub states: Vec<States>,
    /// For each joint that is no coordinate, and whose rate follows from these.
    pub rates: Vec<Rate>,
    /// For each coordinate and each applied force: the force on the coordinate that it makes.
    pub forces: Vec<Vec<Formula>>,
    /// For each joint whether its axis is proved to have unit length as it is declared.
    pub unit_axes: Vec<bool>,
}

/// The rate of a joint, `v speed + rates · q' + v (coordinates · q + heading psi)`.
#[derive(Clone, Debug, DeBin, SerBin)]
pub struct Rate {
    pub joint: usize,
    pub speed: Formula,
    pub rates: Vec<Formula>,
    pub coordinates: Vec<Formula>,
    /// Of the yaw, where that is no coordinate.
    pub heading: Formula,
}

/// Why a mechanism has no equations of motion.
#[derive(Debug)]
pub enum Fault {
    /// A link of no length.
    Short { link: usize },
    /// An axis of no length.
    NoAxis { joint: usize },
    /// A wheel that does not touch the ground, and how far its lowest point is below.
    OffGround { wheel: usize, below: Formula },
    /// A condition of rolling that only coordinates, at these joints, could satisfy; none for one that says nothing new.
    Tied { ground: Ground, joints: Vec<usize> },
    /// A condition of rolling of which it could not be proved that it follows from others, nor that it does not.
    Undecided { ground: Ground },
    /// Joints that neither are coordinates nor are determined by wheels.
    Undetermined(Vec<usize>),
    /// A force of gravity that nothing balances, divided by gravity.
    Unbalanced { joint: usize, force: Formula },
    /// A coordinate that speeds the mechanism up or slows it down.
    Coupled { joint: usize },
    /// A joint that rolls, and on whose position the motion of the coordinates depends.
    Remains { joint: usize },
    /// A coordinate that moves no mass, where others move along.
    Massless { joint: usize, along: Vec<usize> },
    /// A coordinate of which it could not be proved that it moves no mass, where others move along, nor that it does.
    PerhapsMassless { joint: usize, along: Vec<usize> },
}

/// A condition that a wheel on the ground makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    Height(usize),
    Sideways(usize),
    Along(usize),
}

/// The formulas of a declaration.
#[derive(SerBin)]
pub struct Declared {
    /// The number of parameters.
    pub parameters: usize,
    /// The definitions, each in those before it.
    pub definitions: Vec<Formula>,
    /// The formulas that the mechanism is made of, one by one.
    pub attributes: Vec<Formula>,
}

/// Derives the equations of motion.
///
/// # Errors
/// If a formula that is written has no value, with attributes as the outputs; if the engine fails; and if the mechanism
/// has faults.
pub fn derive(mechanism: Mechanism<Formula>, declared: Declared) -> Result<Result<Derivation, Vec<Fault>>, Failure> {
    let derive = |engine: &Engine, (mechanism, declared): &(Mechanism<Formula>, Declared)| {
        derive_with(engine, mechanism, declared)?.map_err(Obstacle::Faults)
    };
    match symbolic::ask("equations of motion", (mechanism, declared), derive) {
        Ok(derivation) => Ok(Ok(derivation)),
        Err(Obstacle::Faults(faults)) => Ok(Err(faults)),
        Err(Obstacle::Failure(failure)) => Err(failure),
    }
}

/// Why nothing is derived.
enum Obstacle {
    Faults(Vec<Fault>),
    Failure(Failure),
}

impl<E: Into<Failure>> From<E> for Obstacle {
    fn from(failure: E) -> Self {
        Self::Failure(failure.into())
    }
}

fn derive_with(
    engine: &Engine,
    mechanism: &Mechanism<Formula>,
    Declared { parameters, definitions, attributes }: &Declared,
) -> Result<Result<Derivation, Vec<Fault>>, Failure> {
    let parameters = *parameters;
    let names: Vec<Form> = (0..definitions.len()).map(|index| engine.definition(parameters, index)).collect();
    let form = |formula: &Formula, place: Place| {
        engine.form(formula, &names).map_err(|why| Failure::Undefined { equations: 0, place, why })
    };
    let values = definitions.iter().enumerate().map(|(index, formula)| form(formula, Place::Definition(index)));
    let values = values.collect::<Result<_, _>>()?;
    for (index, formula) in attributes.iter().enumerate() {
        form(formula, Place::Output(index))?;
    }
    let mut formulas = Formulas::new(engine, parameters, values);
    let mechanism = mechanism.map(|formula| {
        engine.form(formula, &names).map_err(|why| Failure::Engine(EngineFailure::Stopped(why.to_string())))
    })?;
    Ok(linearize(mechanism, &mut formulas).map(|linearized| linearized.export(formulas, parameters)))
}

struct Linearized {
    mechanism: Mechanism<Form>,
    motions: Motions,
    matrices: Matrices,
    by_bodies: Option<Matrices>,
    unit_axes: Vec<bool>,
}

fn linearize(mut mechanism: Mechanism<Form>, formulas: &mut Formulas<'_>) -> Result<Linearized, Vec<Fault>> {
    let mut faults = Vec::new();
    let mut unit_axes = Vec::new();
    for (index, joint) in mechanism.joints.iter_mut().enumerate() {
        let square = vectors::dot(&joint.axis, &joint.axis);
        unit_axes.push(formulas.is_zero(&(&square - &Form::number(1))));
        if formulas.is_zero(&square) {
            faults.push(Fault::NoAxis { joint: index });
        } else if !unit_axes[index] {
            let length = formulas.name(format!("length_{}", joint.name), &square.in_sines().root());
            joint.axis = joint.axis.each_ref().map(|component| component.over(&length));
        }
    }
    for (wheel, Wheel { centre, radius, .. }) in mechanism.wheels.iter().enumerate() {
        let below = &centre[2] + radius;
        if !formulas.is_zero(&below) {
            faults.push(Fault::OffGround { wheel, below: formulas.inserted(&below) });
        }
    }
    faults.extend(links::find_short_links(&mechanism, formulas).into_iter().map(|link| Fault::Short { link }));
    if !faults.is_empty() {
        return Err(faults);
    }
    let contacts: Vec<Contact<'_>> = mechanism.wheels.iter().map(|wheel| Contact::new(&mechanism, wheel)).collect();
    let motions = Motions::new(&mechanism, &contacts, formulas)?;
    let unreduced = Unreduced::new(&mechanism, &contacts, formulas)?;
    let projection = Projection::new(&mechanism, &unreduced, &motions, formulas);
    let faults = projection.faults(formulas);
    if !faults.is_empty() {
        return Err(faults);
    }
    let matrices = projection.matrices(formulas);
    let by_bodies = sum_over_bodies(&mechanism, &contacts, &unreduced, &motions, &matrices, formulas);
    Ok(Linearized { motions, matrices, by_bodies, unit_axes, mechanism })
}

impl Linearized {
    /// The formulas without the engine; of the definitions all that are used by others or by results.
    fn export(self, formulas: Formulas<'_>, parameters: usize) -> Derivation {
        let Self { mechanism, motions, matrices, by_bodies, unit_axes } = self;
        let to_formula = |form: &Form| form.to_formula(parameters);
        let all = |row: &[Form]| row.iter().map(to_formula).collect();
        let freedom = |joint: usize| motions.freedoms.iter().position(|free| *free == joint);
        let forward = mechanism.root.and_then(|root| freedom(root.forward));
        let yaw = mechanism.root.map(|root| root.yaw);
        // A rate that depends on its own position, as that of a caster does, does not follow from the coordinates.
        let follows = |joint: &usize| {
            let others = motions.rolling.iter().filter(|other| Some(**other) != yaw);
            !mechanism.coordinates.contains(joint)
                && others.into_iter().all(|other| motions.positions[*joint][*other].is_nothing())
        };
        let by_coordinates = |joint: usize| -> Vec<Formula> {
            let rate = |q: &usize| freedom(*q).map_or(Formula::zero(), |q| to_formula(&motions.rates[joint][q]));
            mechanism.coordinates.iter().map(rate).collect()
        };
        let rates = (0..mechanism.joints.len()).filter(follows).map(|joint| {
            let positions = &motions.positions[joint];
            Rate {
                joint,
                // The forward rate of all is the speed.
                speed: forward.map_or(Formula::zero(), |forward| to_formula(&motions.rates[joint][forward])),
                rates: by_coordinates(joint),
                coordinates: mechanism.coordinates.iter().map(|q| to_formula(&positions[*q])).collect(),
                heading: match mechanism.root {
                    Some(root) if !mechanism.coordinates.contains(&root.yaw) => to_formula(&positions[root.yaw]),
                    _ => Formula::zero(),
                },
            }
        });
        let rates = rates.collect();
        let by_forces: Vec<Vec<Formula>> = mechanism.forces.iter().map(|joint| by_coordinates(*joint)).collect();
        let forces = (0..mechanism.coordinates.len()).map(|q| by_forces.iter().map(|force| force[q].clone()).collect());
        let forces = forces.collect();
        let states = Projection::states(&mechanism, &matrices);
        let without_engine = |matrices: &Matrices| -> Matrices<Formula> {
            matrices.iter().map(|(name, rows)| (*name, rows.iter().map(|row| all(row)).collect())).collect()
        };
        let (matrices, by_bodies) = (without_engine(&matrices), by_bodies.as_ref().map(without_engine));
        let definitions = formulas.made().iter().map(|(name, form)| (name.clone(), to_formula(form))).collect();
        Derivation { definitions, matrices, by_bodies, states, rates, forces, unit_axes }
    }
}
