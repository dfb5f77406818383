//! The motions that the wheels leave free: rates and positions of all joints in those of the coordinates.

use super::contact::{Condition, Contact};
use super::elimination::{Row, Solved};
use super::formulas::Formulas;
use super::matrix::{self, Matrix};
use super::mechanism::Mechanism;
use super::{Fault, Ground};
use crate::symbolic::Form;

/// How all joints move: `z' = rates q' + v positions z`, where heights of wheels make `z = places z`. Square matrices have a
/// row and a column for each joint.
pub struct Motions {
    /// A row for each joint, a column for each freedom: the coordinates, and behind them the forward motion if there is one.
    pub rates: Matrix,
    pub positions: Matrix,
    /// Columns of joints that the heights of wheels determine are zero.
    pub places: Matrix,
    /// The joints that only roll: no position of theirs is determined by the coordinates.
    pub rolling: Vec<usize>,
}

impl Motions {
    pub fn new(
        mechanism: &Mechanism<Form>,
        contacts: &[Contact<'_>],
        formulas: &mut Formulas<'_>,
    ) -> Result<Self, Vec<Fault>> {
        let count = mechanism.joints.len();
        let forward = mechanism.root.map(|root| root.forward);
        let freedoms: Vec<usize> = mechanism.coordinates.iter().copied().chain(forward).collect();
        let dependent: Vec<usize> = (0..count).filter(|joint| !freedoms.contains(joint)).collect();
        // The positions stand behind the rates, as further unknowns.
        let row = |condition: Condition| -> Row {
            condition.rates.into_iter().chain(condition.positions.iter().map(|position| -position)).collect()
        };
        let name = |unknown: usize, column: usize| {
            let of = |joint: usize| &mechanism.joints[joint].name;
            match column < count {
                true => format!("{}_by_{}", of(unknown), of(column)),
                false => format!("{}_per_v_{}", of(unknown), of(column - count)),
            }
        };
        let mut faults = Vec::new();
        let mut solved = Solved::default();
        for (wheel, contact) in contacts.iter().enumerate() {
            if let Err(left) = solved.add(row(contact.height()), &dependent, formulas, name) {
                faults.push(tied(&left, mechanism, formulas, Ground::Height(wheel)));
            }
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        let heights = solved.clone();
        for (wheel, contact) in contacts.iter().enumerate() {
            let spin = [mechanism.wheels[wheel].spin];
            let conditions = [
                (contact.sideways(), Ground::Sideways(wheel), &dependent[..]),
                (contact.along(), Ground::Along(wheel), &spin),
            ];
            for (condition, ground, may) in conditions {
                let Err(left) = solved.add(row(condition), may, formulas, name) else { continue };
                // Two wheels on one axle cannot slip sideways one without the other.
                if left.iter().any(|entry| !formulas.is_zero(entry)) {
                    faults.push(tied(&left, mechanism, formulas, ground));
                }
            }
        }
        let free = dependent.iter().filter(|joint| !solved.rows.iter().any(|(unknown, _)| unknown == *joint));
        let free: Vec<usize> = free.copied().collect();
        if !free.is_empty() && faults.is_empty() {
            faults.push(Fault::Undetermined(free));
        }
        if !faults.is_empty() {
            return Err(faults);
        }

        let by_height: Vec<usize> = heights.rows.iter().map(|(unknown, _)| *unknown).collect();
        let one = |is: bool| Form::number(i64::from(is));
        let places: Matrix = (0..count)
            .map(|joint| match heights.rows.iter().find(|(unknown, _)| *unknown == joint) {
                Some((_, row)) => {
                    (0..count).map(|other| if other == joint { one(false) } else { row[other].clone() }).collect()
                }
                None => (0..count).map(|other| one(other == joint)).collect(),
            })
            .collect();
        let mut rates = Matrix::new();
        let mut positions = Matrix::new();
        for joint in 0..count {
            let Some((_, row)) = solved.rows.iter().find(|(unknown, _)| *unknown == joint) else {
                rates.push(freedoms.iter().map(|freedom| one(*freedom == joint)).collect());
                positions.push(vec![one(false); count]);
                continue;
            };
            rates.push(freedoms.iter().map(|freedom| row[*freedom].clone()).collect());
            positions.push(matrix::times_row(&row[count..], &places));
        }
        let rolling = (0..count).filter(|joint| !by_height.contains(joint) && !mechanism.coordinates.contains(joint));
        Ok(Self { rates, positions, places, rolling: rolling.collect() })
    }
}

/// What is left of a condition that no dependent joint could satisfy.
fn tied(left: &Row, mechanism: &Mechanism<Form>, formulas: &Formulas<'_>, ground: Ground) -> Fault {
    let count = mechanism.joints.len();
    let joints = (0..count).filter(|joint| !formulas.is_zero(&left[*joint]) || !formulas.is_zero(&left[count + joint]));
    Fault::Tied { ground, joints: joints.collect() }
}
