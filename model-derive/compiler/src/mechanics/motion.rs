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
    /// A row for each joint, a column for each freedom.
    pub rates: Matrix,
    pub positions: Matrix,
    /// Columns of joints that the heights of wheels determine are zero.
    pub places: Matrix,
    /// The joints that only roll: no position of theirs is determined by the coordinates.
    pub rolling: Vec<usize>,
    /// The joints that move freely: the coordinates but for those that follow by rolling, and behind them the forward motion
    /// if there is one.
    pub freedoms: Vec<usize>,
}

impl Motions {
    /// Beside them what the conditions of the wheels leave undetermined, or cannot say of joints that are not coordinates.
    pub fn new(
        mechanism: &Mechanism<Form>,
        contacts: &[Contact<'_>],
        formulas: &mut Formulas<'_>,
    ) -> (Self, Vec<Fault>) {
        let count = mechanism.joints.len();
        let forward = mechanism.root.map(|root| root.forward);
        let is_free = |joint: &usize| !mechanism.following.contains(joint);
        let freedoms: Vec<usize> = mechanism.coordinates.iter().copied().filter(is_free).chain(forward).collect();
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
        let mut solved = Solved::default();
        // A coordinate has a position of its own, even where the wheels determine its rate.
        let standing: Vec<usize> =
            dependent.iter().copied().filter(|joint| !mechanism.following.contains(joint)).collect();
        let rows = contacts.iter().map(|contact| (row(contact.height()), &standing[..])).collect();
        let left = solved.add(rows, formulas, name);
        let mut faults: Vec<Fault> =
            left.iter().map(|(wheel, left)| tied(left, mechanism, formulas, Ground::Height(*wheel))).collect();
        let can_stand = faults.is_empty();
        let heights = solved.clone();
        let held: Vec<usize> = (0..contacts.len()).filter(|wheel| mechanism.wheels[*wheel].slip.is_none()).collect();
        let sideways = held.iter().map(|wheel| (row(contacts[*wheel].sideways()), &dependent[..])).collect();
        let sideways = solved.add(sideways, formulas, name).into_iter();
        let sideways = sideways.map(|(index, left)| (Ground::Sideways(held[index]), left));
        let spins: Vec<[usize; 1]> = mechanism.wheels.iter().map(|wheel| [wheel.spin]).collect();
        let along = contacts.iter().zip(&spins).map(|(contact, spin)| (row(contact.along()), &spin[..])).collect();
        let along = solved.add(along, formulas, name).into_iter().map(|(wheel, left)| (Ground::Along(wheel), left));
        // Two wheels on one axle cannot slip sideways one without the other.
        let tie = |(ground, left): &(Ground, Row)| {
            left.iter().any(|entry| !formulas.is_zero(entry)).then(|| tied(left, mechanism, formulas, *ground))
        };
        // What the heights say wrongly goes before all that follows from it.
        if can_stand {
            faults.extend(sideways.chain(along).collect::<Vec<_>>().iter().filter_map(tie));
        }
        let free = dependent.iter().filter(|joint| solved.get(**joint).is_none());
        let free: Vec<usize> = free.copied().collect();
        if !free.is_empty() && faults.is_empty() {
            faults.push(Fault::Undetermined(free));
        }

        let by_height: Vec<usize> = heights.rows.iter().map(|(unknown, _)| *unknown).collect();
        let one = |is: bool| Form::number(i64::from(is));
        let places: Matrix = (0..count)
            .map(|joint| match heights.get(joint) {
                Some(row) => {
                    (0..count).map(|other| if other == joint { one(false) } else { row[other].clone() }).collect()
                }
                None => (0..count).map(|other| one(other == joint)).collect(),
            })
            .collect();
        let mut rates = Matrix::new();
        let mut positions = Matrix::new();
        for joint in 0..count {
            let Some(row) = solved.get(joint) else {
                rates.push(freedoms.iter().map(|freedom| one(*freedom == joint)).collect());
                positions.push(vec![one(false); count]);
                continue;
            };
            rates.push(freedoms.iter().map(|freedom| row[*freedom].clone()).collect());
            positions.push(matrix::times_row(&row[count..], &places));
        }
        if let Some(root) = mechanism.root.filter(|root| mechanism.slips() && !mechanism.feeds_back(root.lateral))
            && let Some(lateral) = freedoms.iter().position(|joint| *joint == root.lateral)
        {
            // The rate of this coordinate is along the axes of the body, which yaws: so neither its position nor that of the
            // yaw matters.
            for (rates, positions) in rates.iter().zip(&mut positions) {
                positions[root.yaw] = &positions[root.yaw] + &rates[lateral];
            }
        }
        let rolling = (0..count).filter(|joint| !by_height.contains(joint) && !mechanism.coordinates.contains(joint));
        (Self { rates, positions, places, rolling: rolling.collect(), freedoms }, faults)
    }
}

/// What is left of a condition that no dependent joint could satisfy.
fn tied(left: &Row, mechanism: &Mechanism<Form>, formulas: &Formulas<'_>, ground: Ground) -> Fault {
    let count = mechanism.joints.len();
    let at = |joint: usize| [&left[joint], &left[count + joint]];
    let joints = |is: &dyn Fn(&Form) -> bool| (0..count).filter(|joint| at(*joint).into_iter().any(is)).collect();
    let moved: Vec<usize> = joints(&|entry| formulas.at_sample(entry).is_not_zero());
    let open: Vec<usize> = joints(&|entry| !formulas.is_zero(entry));
    match moved.is_empty() && !open.is_empty() {
        true => Fault::Undecided { ground },
        false => Fault::Tied { ground, joints: moved },
    }
}
