//! What rolls without slip: the velocities of contact points, and the speeds that follow from others.

use super::frames::Frames;
use super::quantity::Quantity;
use super::solve::{Matrix, solve};
use super::vectors::{Vector, add, cross, negative, scale, subtract, unit, zero};
use super::wheels::Contact;
use crate::mechanics::{Ground, Mechanism, Motion};

/// The conditions of the wheels behind the first, whose own are those of the place of the whole machine.
#[derive(Clone, Debug)]
pub struct Conditions {
    /// Those that are not said by others.
    pub kept: Vec<Ground>,
    /// The joints whose rates follow, as many.
    pub dependent: Vec<usize>,
    /// The joints whose rates are the speeds.
    pub independent: Vec<usize>,
}

/// How the contact point of a wheel moves at unit rate of a joint, in the axes of the base, where the point at which the
/// first wheel touches the ground stands still.
fn find_slip<'a>(
    mechanism: &Mechanism<Quantity<'a>>,
    frames: &Frames<'a>,
    [first, contact]: [&Contact<'a>; 2],
    joint: usize,
) -> Vector<'a> {
    let zero = zero(contact.sin);
    let own = |contact: &Contact<'a>| match joint == contact.spin {
        true => contact.in_base(contact.radius, contact.sin.number(0.0), contact.sin.number(0.0)),
        false => zero,
    };
    if mechanism.wheels.iter().any(|wheel| wheel.spin == joint) {
        return subtract(own(contact), own(first));
    }
    let frame = frames.of_joint(Some(joint));
    let carries = |contact: &Contact<'a>| frames.path(contact.carrier).any(|above| above == frame);
    let axis = frames.outer(frame, 0, frames.all[frame].axis);
    let turns = frames.all[frame].motion == Motion::Turns;
    // On level ground the two points are at one height.
    let [x, y, _] = contact.from(first);
    let between = [x, y, zero[2]];
    let arm = |contact: &Contact<'a>| subtract(contact.place, frames.place(frame, zero));
    match (carries(contact), carries(first), turns) {
        (true, true, true) => cross(axis, between),
        (true, false, true) => cross(axis, arm(contact)),
        (false, true, true) => negative(cross(axis, arm(first))),
        (true, false, false) => axis,
        (false, true, false) => negative(axis),
        _ => zero,
    }
}

/// The conditions as equations in the rates of joints: a row for each, with an entry for each of the joints.
pub fn find_rows<'a>(
    mechanism: &Mechanism<Quantity<'a>>,
    frames: &Frames<'a>,
    contacts: &[Contact<'a>],
    conditions: &[Ground],
    joints: &[usize],
) -> Matrix<'a> {
    let entry = |condition: &Ground, joint: usize| {
        let (Ground::Height(wheel) | Ground::Sideways(wheel) | Ground::Along(wheel)) = *condition;
        let contact = &contacts[wheel];
        if joint == contact.spin {
            let across = contact.sin.number(0.0);
            return if matches!(condition, Ground::Along(_)) { contact.radius } else { across };
        }
        let [x, y, z] = find_slip(mechanism, frames, [&contacts[0], contact], joint);
        let [along, beside] = contact.course;
        match condition {
            Ground::Height(_) => z,
            Ground::Sideways(_) => along * y - beside * x,
            Ground::Along(_) => along * x + beside * y,
        }
    };
    conditions.iter().map(|condition| joints.iter().map(|joint| entry(condition, *joint)).collect()).collect()
}

/// The rates of all joints by the speeds, a row for each joint: zero for the displacements of the root.
pub fn find_shares<'a>(
    mechanism: &Mechanism<Quantity<'a>>,
    frames: &Frames<'a>,
    contacts: &[Contact<'a>],
    Conditions { kept, dependent, independent }: &Conditions,
    some: Quantity<'a>,
) -> Matrix<'a> {
    let by_dependent = find_rows(mechanism, frames, contacts, kept, dependent);
    let by_independent = find_rows(mechanism, frames, contacts, kept, independent);
    let sides: Matrix<'a> =
        (0..independent.len()).map(|speed| by_independent.iter().map(|row| -row[speed]).collect()).collect();
    let solved = solve(&by_dependent, &sides);
    let share = |joint: usize, speed: usize| match dependent.iter().position(|other| *other == joint) {
        Some(place) => solved[speed][place],
        None => some.number(if independent[speed] == joint { 1.0 } else { 0.0 }),
    };
    (0..mechanism.joints.len()).map(|joint| (0..independent.len()).map(|speed| share(joint, speed)).collect()).collect()
}

/// How the contact of the first wheel moves at unit rate of a joint that is none of the root, in the axes of a frame of the
/// root, if nothing compensates it: the root has to move against it.
pub fn find_drift<'a>(
    mechanism: &Mechanism<Quantity<'a>>,
    frames: &Frames<'a>,
    first: &Contact<'a>,
    joint: usize,
    axes: usize,
) -> Option<Vector<'a>> {
    let zero = zero(first.sin);
    if joint == first.spin {
        return Some(frames.outer(first.frame, axes, scale(first.radius, first.heading())));
    }
    let frame = frames.of_joint(Some(joint));
    if mechanism.wheels.iter().any(|wheel| wheel.spin == joint)
        || frames.in_root(frame)
        || frames.path(first.carrier).all(|above| above != frame)
    {
        return None;
    }
    let axis = frames.outer(frame, 0, frames.all[frame].axis);
    let slip = match frames.all[frame].motion {
        Motion::Turns => cross(axis, subtract(first.place, frames.place(frame, zero))),
        Motion::Slides => axis,
    };
    Some(frames.inner(0, axes, slip))
}

/// The rate at which the contact point of the first wheel runs over the ground, along its heading and to the right, of
/// the angular velocity of its frame and the rate about its axle.
pub fn find_progress<'a>(first: &Contact<'a>, spin: Vector<'a>, about_axle: Quantity<'a>) -> [Quantity<'a>; 2] {
    [-(first.radius * (first.roll(spin) + about_axle)), first.tyre * first.along_heading(spin)]
}

/// The same with its derivative in time along axes of the base that do not turn: of the angular acceleration too.
pub fn find_progress_rate<'a>(
    first: &Contact<'a>,
    [spin, spin_rate]: [Vector<'a>; 2],
    [about_axle, about_axle_rate]: [Quantity<'a>; 2],
    yaw_rate: Quantity<'a>,
) -> [Quantity<'a>; 2] {
    let [along, beside] = find_progress(first, spin, about_axle);
    let (roll, lean_rate, by_down) = (first.roll(spin), first.along_heading(spin), first.along_down(spin));
    let lean_rate_rate = first.along_heading(spin_rate) + roll * by_down;
    let (turning, roll_rate) = match first.is_steady {
        true => (yaw_rate, first.sin.number(0.0)),
        false => {
            let down_rate = first.along_down(spin_rate) - roll * lean_rate;
            let steep = lean_rate / first.cos.square();
            let roll_rate = spin_rate[1] - (steep * by_down + first.sin / first.cos * down_rate);
            (by_down / first.cos, roll_rate)
        }
    };
    let radius_rate = -(first.tyre * (first.sin * lean_rate));
    let along_rate = -(radius_rate * (roll + about_axle) + first.radius * (roll_rate + about_axle_rate));
    let beside_rate = first.tyre * lean_rate_rate;
    [along_rate - beside * turning, beside_rate + along * turning]
}

/// The velocity of the point of a wheel that touches the ground, in the axes of its frame: of the velocity of its centre,
/// of the angular velocity of its frame and the rate about its axle.
pub fn find_contact_velocity<'a>(
    contact: &Contact<'a>,
    centre: Vector<'a>,
    spin: Vector<'a>,
    about_axle: Quantity<'a>,
) -> Vector<'a> {
    add(centre, cross(add(spin, scale(about_axle, unit(about_axle, 1))), contact.arm))
}

/// The rate of that velocity, which follows the contact as it moves: of what each of its terms changes by.
pub fn find_contact_acceleration<'a>(
    contact: &Contact<'a>,
    centre: Vector<'a>,
    [spin, spin_rate]: [Vector<'a>; 2],
    [about_axle, about_axle_rate]: [Quantity<'a>; 2],
) -> Vector<'a> {
    let axle = unit(about_axle, 1);
    let wheel_rate = add(spin_rate, add(scale(about_axle_rate, axle), scale(about_axle, cross(spin, axle))));
    let wheel = add(spin, scale(about_axle, axle));
    add(centre, add(cross(wheel_rate, contact.arm), cross(wheel, contact.arm_rate(spin))))
}
