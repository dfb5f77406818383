//! Which conditions of rolling are independent, and which joints they determine.

use super::frames::Frames;
use super::quantity::{Arithmetic, Quantity};
use super::rolling::{Conditions, find_rows};
use super::vectors::unit;
use super::wheels::Contact;
use super::{Machine, instantiate};
use crate::mechanics::Ground;

/// What is free of the motion of a machine, by joints.
#[derive(Clone, Debug)]
pub struct Layout {
    /// All positions, in their order.
    pub positions: Vec<usize>,
    /// Those that the heights of wheels determine.
    pub standing: Vec<usize>,
    /// The heights that do, as many.
    pub heights: Vec<Ground>,
    /// What rolling says of rates.
    pub conditions: Conditions,
}

/// The conditions of rolling do not determine what is no coordinate.
pub struct Undetermined;

impl Layout {
    /// The conditions of the wheels one after the other, as far as they are independent in the reference configuration, and
    /// joints that are no coordinates.
    pub fn new(machine: &Machine) -> Result<Self, Undetermined> {
        let mechanism = &machine.mechanism;
        let joints = 0..mechanism.joints.len();
        let root = mechanism.root;
        let is_displacement = |joint: usize| root.is_some_and(|root| joint < root.yaw);
        let positions = joints.clone().filter(|joint| root.is_none_or(|root| *joint != root.lateral + 1));
        let positions = positions.collect();
        let moving: Vec<usize> = joints.filter(|joint| !is_displacement(*joint)).collect();
        let is_coordinate =
            |joint: &usize| mechanism.coordinates.contains(joint) && !mechanism.following.contains(joint);
        let first_spin = mechanism.wheels.first().map(|wheel| wheel.spin);
        let all = (1..mechanism.wheels.len()).map(Ground::Height);
        let all =
            all.chain((1..mechanism.wheels.len()).flat_map(|wheel| [Ground::Sideways(wheel), Ground::Along(wheel)]));
        let all: Vec<Ground> = all.collect();
        let rows = evaluate_rows(machine, &all, &moving).ok_or(Undetermined)?;
        // What is no coordinate comes first, and the wheel that drives it all last.
        let free = |joint: &usize| Some(*joint) == first_spin || is_coordinate(joint);
        let (mut preferred, others): (Vec<usize>, Vec<usize>) =
            (0..moving.len()).partition(|column| !free(&moving[*column]));
        preferred.extend(others);
        let heights: Vec<usize> = (0..all.len()).filter(|row| matches!(all[*row], Ground::Height(_))).collect();
        let holds = |column: &usize| !free(&moving[*column]) && !mechanism.following.contains(&moving[*column]);
        let standing: Vec<usize> = preferred.iter().copied().filter(holds).collect();
        let (heights, standing) = find_regular(&rows, &heights, &standing);
        let (kept, dependent) = find_regular(&rows, &(0..all.len()).collect::<Vec<_>>(), &preferred);
        if heights.len() + 1 < mechanism.wheels.len() {
            return Err(Undetermined);
        }
        let dependent: Vec<usize> = dependent.iter().map(|column| moving[*column]).collect();
        let independent = moving.iter().copied().filter(|joint| !dependent.contains(joint)).collect();
        Ok(Self {
            positions,
            standing: standing.iter().map(|column| moving[*column]).collect(),
            heights: heights.iter().map(|row| all[*row]).collect(),
            conditions: Conditions { kept: kept.iter().map(|row| all[*row]).collect(), dependent, independent },
        })
    }
}

/// The conditions in the reference configuration for some values of the parameters.
fn evaluate_rows(machine: &Machine, conditions: &[Ground], joints: &[usize]) -> Option<Vec<Vec<f64>>> {
    if machine.mechanism.wheels.is_empty() {
        return Some(Vec::new());
    }
    let count = machine.mechanism.joints.len();
    let arithmetic = Arithmetic::new(machine.parameters + count);
    let mechanism = instantiate(machine, &arithmetic);
    let positions: Vec<Quantity<'_>> = (0..count).map(|joint| arithmetic.input(machine.parameters + joint)).collect();
    let frames = Frames::new(&mechanism, &positions, mechanism.wheels.first().map(|wheel| wheel.centre));
    let vertical = unit(arithmetic.number(0.0), 2);
    let contacts: Vec<Contact<'_>> =
        (0..mechanism.wheels.len()).map(|wheel| Contact::new(&mechanism, &frames, wheel, vertical)).collect();
    let rows = find_rows(&mechanism, &frames, &contacts, conditions, joints);
    let outputs: Vec<usize> = rows.iter().flatten().map(|entry| entry.value).collect();
    let program = arithmetic.program(&outputs);
    // The golden ratio spreads them; where definitions have no value for some, others may have.
    let spread = |turn: usize| {
        let value = |index: usize| 0.4 + ((index * 7 + turn * 5 + 1) as f64 * 0.618_033_988_749_894_9).fract();
        let values: Vec<f64> = (0..machine.parameters).map(value).chain((0..count).map(|_| 0.0)).collect();
        program.interpret(&values)
    };
    let found = (0..20).map(spread).find(|values| values.iter().all(|value| value.is_finite()))?;
    Some(found.chunks(joints.len().max(1)).map(<[f64]>::to_vec).collect())
}

/// Rows, each that is independent of those before it, and columns, each the first that determines it.
fn find_regular(all: &[Vec<f64>], rows: &[usize], columns: &[usize]) -> (Vec<usize>, Vec<usize>) {
    let (mut kept, mut chosen): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
    let mut reduced: Vec<Vec<f64>> = Vec::new();
    let size = all.iter().flatten().fold(0.0_f64, |size, entry| size.max(entry.abs()));
    for row in rows {
        let mut rest = all[*row].clone();
        for (known, column) in reduced.iter().zip(&chosen) {
            let factor = rest[*column] / known[*column];
            rest.iter_mut().zip(known).for_each(|(entry, known)| *entry -= factor * known);
        }
        let pivot = columns.iter().find(|column| !chosen.contains(column) && rest[**column].abs() > 1e-9 * size);
        if let Some(column) = pivot {
            kept.push(*row);
            chosen.push(*column);
            reduced.push(rest);
        }
    }
    (kept, chosen)
}
