//! The same matrices, summed over the bodies after these were projected.
//!
//! What all bodies of a joint move is added up first elsewhere, and projected then, which is short where there are many
//! bodies or joints. Where there are few, it is shorter to say how each body moves with each coordinate:
//!
//! ```text
//! M = Σ m V·V' + W·J W'
//! ```
//!
//! with the velocity V of its centre of mass and its rate of turning W at unit rate of a coordinate, and with what these are
//! in the accelerations `z'' = N q'' + v B N q' + v² B B z` for C1 and K2. Weight is linear in the masses, and so are the
//! loads of the wheels: what a unit of mass does where a body is, times its mass. Which of the two is shorter is counted
//! when both are programs.

use super::Matrices;
use super::composite::Composites;
use super::contact::Contact;
use super::formulas::Formulas;
use super::loads::find_loads;
use super::matrix::{self, Matrix, plus, times, transposed};
use super::mechanism::{Body, Mechanism, Motion};
use super::motion::Motions;
use super::projection::{Projected, settle};
use super::unreduced::{Unreduced, find_weight};
use super::vectors::{AXES, Vector, add, cross, dot, scale, subtract, tidy, zero};
use crate::symbolic::Form;

/// With more bodies than this it is not tried.
const MAX_BODIES: usize = 8;

/// The matrices, if there are few bodies, and if it is proved that they are the `known` ones.
pub fn sum_over_bodies(
    mechanism: &Mechanism<Form>,
    contacts: &[Contact<'_>],
    unreduced: &Unreduced,
    motions: &Motions,
    known: &Matrices,
    formulas: &mut Formulas<'_>,
) -> Option<Matrices> {
    if mechanism.bodies.len() > MAX_BODIES {
        return None;
    }
    let Motions { rates, positions, freedoms, .. } = motions;
    let freedoms: Vec<usize> = freedoms.iter().copied().filter(|joint| mechanism.coordinates.contains(joint)).collect();
    // In the rates of the coordinates, and in what their accelerations have of rates and of positions.
    let [by_rates, by_positions] = [times(positions, rates), times(positions, positions)];
    let mut projected = Projected::new(mechanism, unreduced, motions, formulas);
    let [mut mass, mut damping, mut stiffness] =
        [&projected.by_rates[0].1, &projected.by_rates[3].1, &projected.by_positions[3].1]
            .map(|known| matrix::new(known.len(), known.first().map_or(0, Vec::len), |_, _| Form::number(0)));
    let mut weight = matrix::new(stiffness.len(), mechanism.joints.len(), |_, _| Form::number(0));
    for (index, body) in mechanism.bodies.iter().enumerate() {
        let mut twists = |what: [char; 2], columns: &Matrix, chosen: &[usize], joints: &[usize]| -> Vec<Twist> {
            let twist = |(column, joint): (&usize, &usize)| {
                let of = format!("{}{}_{}", mechanism.moved(body.joint), index + 1, mechanism.joints[*joint].name);
                Twist::new(mechanism, body, |joint| &columns[joint][*column]).named(what, &of, formulas)
            };
            chosen.iter().zip(joints).map(twist).collect()
        };
        let columns: Vec<usize> = (0..freedoms.len()).collect();
        let moved = twists(['v', 'w'], rates, &columns, &freedoms);
        let turning = twists(['a', 'b'], &by_rates, &columns, &freedoms);
        let displaced = twists(['c', 'd'], &by_positions, &mechanism.coordinates, &mechanism.coordinates);
        for (row, virtual_motion) in moved.iter().enumerate() {
            for (column, (moved, turning)) in moved.iter().zip(&turning).enumerate() {
                mass[row][column] = &mass[row][column] + &virtual_motion.power(body, moved);
                damping[row][column] = &damping[row][column] + &virtual_motion.power(body, turning);
            }
            for (column, displaced) in mechanism.coordinates.iter().zip(&displaced) {
                stiffness[row][*column] = &stiffness[row][*column] + &virtual_motion.power(body, displaced);
            }
        }
        let lifted = find_lift(mechanism, contacts, index, motions, formulas)?;
        weight = plus(&weight, &lifted.iter().map(|row| row.iter().map(|lift| &body.mass * lift).collect()).collect());
    }
    let spin = times(&transposed(rates), &unreduced.spin);
    projected.by_rates[0].1 = mass;
    projected.by_rates[3].1 = plus(&damping, &times(&spin, rates));
    projected.by_positions[1].1 = weight;
    projected.by_positions[3].1 = plus(&stiffness, &times(&spin, positions));
    let matrices = settle(&projected.complete(mechanism, motions), formulas);
    let are_equal = matrices.len() == known.len()
        && matrices.iter().zip(known).all(|((name, rows), (known_name, known))| {
            let mut entries = rows.iter().flatten().zip(known.iter().flatten());
            name == known_name && entries.all(|(entry, known)| formulas.is_zero(&(entry - known)))
        });
    are_equal.then_some(matrices)
}

/// What weight does to a unit of mass where a body is, with a row for each freedom and a column for each joint; nothing if
/// that is not balanced by itself.
fn find_lift(
    mechanism: &Mechanism<Form>,
    contacts: &[Contact<'_>],
    body: usize,
    motions: &Motions,
    formulas: &mut Formulas<'_>,
) -> Option<Matrix> {
    let unit = Body { mass: Form::number(1), inertia: [zero(), zero(), zero()], ..mechanism.bodies[body].clone() };
    let alone = Mechanism { bodies: vec![unit], ..mechanism.clone() };
    let composites = Composites::new(&alone, formulas);
    let (loads, unbalanced) = match mechanism.gravity {
        Some(_) => find_loads(&alone, contacts, &composites, formulas),
        None => (vec![Form::number(0); contacts.len()], Vec::new()),
    };
    if !unbalanced.is_empty() {
        return None;
    }
    let weight = find_weight(&alone, contacts, &composites, &loads, formulas);
    let lift = times(&times(&transposed(&motions.rates), &weight), &motions.places);
    let name = |row: usize, column: usize| {
        format!("lift{}_{}_{}", body + 1, mechanism.joints[motions.freedoms[row]].name, mechanism.joints[column].name)
    };
    let mut named = |row: usize, column: usize, lift: &Form| formulas.name(name(row, column), lift);
    let rows = lift.iter().enumerate();
    let rows = rows.map(|(row, lifts)| {
        // Of the others nothing is asked.
        let is_free = mechanism.coordinates.contains(&motions.freedoms[row]);
        let entries =
            lifts.iter().enumerate().map(|(column, lift)| match is_free && mechanism.coordinates.contains(&column) {
                true => named(row, column, lift),
                false => Form::number(0),
            });
        entries.collect()
    });
    Some(rows.collect())
}

/// How a body moves.
struct Twist {
    /// Of its centre of mass.
    velocity: Vector,
    rotation: Vector,
}

impl Twist {
    /// At given rates of the joints.
    fn new<'a>(mechanism: &Mechanism<Form>, body: &Body<Form>, rate: impl Fn(usize) -> &'a Form) -> Self {
        let mut twist = Self { velocity: zero(), rotation: zero() };
        for index in mechanism.path(body.joint).filter(|joint| !rate(*joint).is_nothing()) {
            let (joint, rate) = (&mechanism.joints[index], rate(index));
            let velocity = match joint.motion {
                Motion::Slides => joint.axis.clone(),
                Motion::Turns => {
                    twist.rotation = add(&twist.rotation, &scale(rate, &joint.axis));
                    cross(&joint.axis, &tidy(&subtract(&body.centre, &joint.point)))
                }
            };
            twist.velocity = add(&twist.velocity, &scale(rate, &velocity));
        }
        twist
    }

    /// With a name for each component that needs one.
    fn named(self, what: [char; 2], of: &str, formulas: &mut Formulas<'_>) -> Self {
        let mut named = |what: char, vector: &Vector| {
            [0, 1, 2].map(|axis| formulas.name(format!("{what}{}_{of}", AXES[axis]), &vector[axis]))
        };
        Self { velocity: named(what[0], &self.velocity), rotation: named(what[1], &self.rotation) }
    }

    /// The power of what accelerates the body so, in this motion.
    fn power(&self, body: &Body<Form>, acceleration: &Self) -> Form {
        let turned = body.inertia.each_ref().map(|row| dot(row, &acceleration.rotation));
        let pushed = &body.mass * &dot(&self.velocity, &acceleration.velocity);
        &pushed + &dot(&self.rotation, &turned)
    }
}
