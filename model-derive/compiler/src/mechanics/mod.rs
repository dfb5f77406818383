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
use self::projection::{Projected, Projection};
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

/// Matrices by the attributes of a mechanism: formulas in the parameters, the definitions of the model, and behind these in
/// those of the derivation.
#[derive(Debug, DeBin, SerBin)]
pub struct Apart {
    /// Names and formulas; names may occur twice.
    pub definitions: Vec<(String, Formula)>,
    pub matrices: Matrices<Formula>,
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

/// Derives the matrices of a mechanism whose attributes are parameters: the last ones, which stand for the formulas of
/// `declared.attributes` in the others. No relation between them is used. So what holds because of these, as that wheels
/// touch the ground where they are declared, that weight is balanced, or that two wheels of an axle say the same, is taken to
/// hold: the matrices are also those of a mechanism with another attribute, as far as one of it can be derived.
///
/// # Errors
/// If the engine fails.
pub fn derive_apart(mechanism: Mechanism<Formula>, declared: Declared) -> Result<Apart, Failure> {
    let derive = |engine: &Engine, (mechanism, declared): &(Mechanism<Formula>, Declared)| {
        let Declared { parameters, definitions, attributes } = declared;
        let mut resolved = Resolved::new(engine, *parameters, definitions)?;
        resolved.formulas = resolved.formulas.standing_for(attributes);
        let mechanism = resolved.mechanism(mechanism)?;
        let mut formulas = resolved.formulas;
        let matrices = without_engine(&linearize_apart(mechanism, &mut formulas), *parameters);
        Ok(Apart { definitions: formulas.export(), matrices })
    };
    symbolic::ask("equations of motion by attributes", (mechanism, declared), derive)
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
    let mut resolved = Resolved::new(engine, *parameters, definitions)?;
    for (index, formula) in attributes.iter().enumerate() {
        resolved.form(formula, Place::Output(index))?;
    }
    let mechanism = resolved.mechanism(mechanism)?;
    let linearized = linearize(mechanism, &mut resolved.formulas);
    Ok(linearized.map(|linearized| linearized.export(resolved.formulas, *parameters)))
}

/// The definitions of a declaration, with the engine.
struct Resolved<'e> {
    engine: &'e Engine,
    /// What stands for each.
    names: Vec<Form>,
    formulas: Formulas<'e>,
}

impl<'e> Resolved<'e> {
    fn new(engine: &'e Engine, parameters: usize, definitions: &[Formula]) -> Result<Self, Failure> {
        let names = (0..definitions.len()).map(|index| engine.definition(parameters, index)).collect();
        let mut resolved = Self { engine, names, formulas: Formulas::new(engine, parameters, Vec::new()) };
        let values = definitions.iter().enumerate();
        let values = values.map(|(index, formula)| resolved.form(formula, Place::Definition(index)));
        let values = values.collect::<Result<_, _>>()?;
        resolved.formulas = Formulas::new(engine, parameters, values);
        Ok(resolved)
    }

    fn form(&self, formula: &Formula, place: Place) -> Result<Form, Failure> {
        self.engine.form(formula, &self.names).map_err(|why| Failure::Undefined { equations: 0, place, why })
    }

    fn mechanism(&self, mechanism: &Mechanism<Formula>) -> Result<Mechanism<Form>, Failure> {
        mechanism.map(|formula| {
            let form = self.engine.form(formula, &self.names);
            form.map_err(|why| Failure::Engine(EngineFailure::Stopped(why.to_string())))
        })
    }
}

struct Linearized {
    mechanism: Mechanism<Form>,
    motions: Motions,
    matrices: Matrices,
    by_bodies: Option<Matrices>,
    unit_axes: Vec<bool>,
}

fn linearize(mut mechanism: Mechanism<Form>, formulas: &mut Formulas<'_>) -> Result<Linearized, Vec<Fault>> {
    let (unit_axes, mut faults) = make_unit_axes(&mut mechanism, formulas);
    for (wheel, Wheel { centre, radius, .. }) in mechanism.wheels.iter().enumerate() {
        let below = &centre[2] + radius;
        if !formulas.is_zero(&below) {
            faults.push(Fault::OffGround { wheel, below: formulas.inserted(&below) });
        }
    }
    faults.extend(links::find_short_links(&mechanism, formulas).into_iter().map(|link| Fault::Short { link }));
    let without = |faults: Vec<Fault>| if faults.is_empty() { Ok(()) } else { Err(faults) };
    without(faults)?;
    let contacts: Vec<Contact<'_>> = mechanism.wheels.iter().map(|wheel| Contact::new(&mechanism, wheel)).collect();
    let (motions, faults) = Motions::new(&mechanism, &contacts, formulas);
    without(faults)?;
    let (unreduced, faults) = Unreduced::new(&mechanism, &contacts, formulas);
    without(faults)?;
    let projection = Projection::new(&mechanism, &unreduced, &motions, formulas);
    without(projection.faults(formulas))?;
    let matrices = projection.matrices(formulas);
    let by_bodies = sum_over_bodies(&mechanism, &contacts, &unreduced, &motions, &matrices, formulas);
    Ok(Linearized { motions, matrices, by_bodies, unit_axes, mechanism })
}

/// The matrices, whatever is wrong with the mechanism.
fn linearize_apart(mut mechanism: Mechanism<Form>, formulas: &mut Formulas<'_>) -> Matrices {
    make_unit_axes(&mut mechanism, formulas);
    let contacts: Vec<Contact<'_>> = mechanism.wheels.iter().map(|wheel| Contact::below(&mechanism, wheel)).collect();
    let (motions, _) = Motions::new(&mechanism, &contacts, formulas);
    let (unreduced, _) = Unreduced::new(&mechanism, &contacts, formulas);
    let projected = Projected::new(&mechanism, &unreduced, &motions, formulas);
    projection::settle(&projected.complete(&mechanism, &motions), formulas)
}

/// Gives the axes of joints unit length; for each whether it is proved to have it as it is declared, and those of no length.
fn make_unit_axes(mechanism: &mut Mechanism<Form>, formulas: &mut Formulas<'_>) -> (Vec<bool>, Vec<Fault>) {
    let (mut unit_axes, mut faults) = (Vec::new(), Vec::new());
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
    (unit_axes, faults)
}

fn without_engine(matrices: &Matrices, parameters: usize) -> Matrices<Formula> {
    let row = |row: &Vec<Form>| row.iter().map(|form| form.to_formula(parameters)).collect();
    matrices.iter().map(|(name, rows)| (*name, rows.iter().map(row).collect())).collect()
}

impl Linearized {
    /// The formulas without the engine; of the definitions all that are used by others or by results.
    fn export(self, formulas: Formulas<'_>, parameters: usize) -> Derivation {
        let Self { mechanism, motions, matrices, by_bodies, unit_axes } = self;
        let to_formula = |form: &Form| form.to_formula(parameters);
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
        let by_bodies = by_bodies.as_ref().map(|matrices| without_engine(matrices, parameters));
        let matrices = without_engine(&matrices, parameters);
        Derivation { definitions: formulas.export(), matrices, by_bodies, states, rates, forces, unit_axes }
    }
}
