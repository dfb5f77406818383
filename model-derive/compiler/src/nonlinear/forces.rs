//! The forces that a motion takes, from the bodies inward, and those that are applied.

use super::frames::Frames;
use super::inertia::Load;
use super::movement::Movement;
use super::quantity::Quantity;
use super::rolling::find_drift;
use super::vectors::{Vector, add, cross, dot, scale, subtract, times, zero};
use super::wheels::Contact;
use crate::mechanics::{Link, Mechanism, Motion};

/// The forces that a motion takes.
pub struct Taken<'a> {
    /// By joint: on its rate, where the rest of the machine keeps rolling.
    pub by_joint: Vec<Quantity<'a>>,
    /// On the whole machine, in the axes of the root.
    pub whole: Vector<'a>,
    /// The moment about the point where the first wheel touches the ground.
    pub moment: Vector<'a>,
}

/// A motion in all frames: velocities and accelerations, of which those of origins may have gravity in them, and the rates
/// and accelerations of all joints.
pub struct Moved<'a, 'm> {
    pub velocities: &'m Movement<'a>,
    pub accelerations: &'m Movement<'a>,
    pub rates: &'m [Quantity<'a>],
    pub second: &'m [Quantity<'a>],
}

/// From the forces on each frame to those on each joint. `point` is the point on the ground from the origin of the root.
pub fn find_taken<'a>(
    mechanism: &Mechanism<Quantity<'a>>,
    frames: &Frames<'a>,
    loads: &[Load<'a>],
    contacts: &[Contact<'a>],
    moved: &Moved<'a, '_>,
    (axes, point): (usize, Vector<'a>),
) -> Taken<'a> {
    let none = zero(point[0]);
    let Moved { velocities, accelerations, rates, second } = moved;
    let mut by_joint = vec![none[0]; mechanism.joints.len()];
    let mut wrenches: Vec<[Vector<'a>; 2]> = Vec::new();
    for (index, load) in loads.iter().enumerate() {
        let (spin, spin_rate, origin) =
            (velocities.spins[index], accelerations.spins[index], accelerations.origins[index]);
        let Load { inertia, momentum } = load;
        let force = add(
            scale(inertia.mass, origin),
            add(cross(spin_rate, inertia.moment), cross(spin, cross(spin, inertia.moment))),
        );
        let mut turned = add(times(&inertia.tensor, spin), *momentum);
        let mut moment = add(cross(inertia.moment, origin), times(&inertia.tensor, spin_rate));
        for contact in contacts.iter().filter(|contact| contact.carrier == index) {
            // What spins has the momentum that its absolute rate about the axle makes.
            turned[1] = turned[1] + contact.axial * (spin[1] + rates[contact.spin]);
            let torque = contact.axial * (spin_rate[1] + second[contact.spin]);
            moment[1] = moment[1] + torque;
            by_joint[contact.spin] = torque;
        }
        wrenches.push([force, add(moment, cross(spin, turned))]);
    }
    let last = if mechanism.root.is_some() { axes } else { 0 };
    for index in (last + 1..frames.all.len()).rev() {
        let frame = &frames.all[index];
        let [force, moment] = wrenches[index];
        if let Some(joint) = frame.joint {
            by_joint[joint] = dot(frame.axis, if frame.motion == Motion::Turns { moment } else { force });
        }
        let force = frame.out(force);
        let moment = add(frame.out(moment), cross(frame.offset, force));
        let parent = frame.parent.unwrap_or(0);
        wrenches[parent] = [add(wrenches[parent][0], force), add(wrenches[parent][1], moment)];
    }
    let [whole, moment] = wrenches[last];
    let moment = subtract(moment, cross(point, whole));
    if mechanism.root.is_some() {
        for frame in 0..=frames.body {
            if let Some(joint) = frames.all[frame].joint {
                by_joint[joint] = dot(frames.change(frame, axes, frames.all[frame].axis), moment);
            }
        }
        for (joint, taken) in by_joint.iter_mut().enumerate() {
            let drift = contacts.first().and_then(|first| find_drift(mechanism, frames, first, joint, axes));
            if let Some(drift) = drift {
                *taken = *taken - dot(drift, whole);
            }
        }
    }
    Taken { by_joint, whole, moment }
}

/// The forces of springs, dampers and of what is applied, by joint.
pub fn find_applied<'a>(
    mechanism: &Mechanism<Quantity<'a>>,
    links: &[Stretched<'a>],
    positions: &[Quantity<'a>],
    rates: &[Quantity<'a>],
    forces: &[Quantity<'a>],
) -> Vec<Quantity<'a>> {
    let mut applied: Vec<Quantity<'a>> = Vec::new();
    for (index, joint) in mechanism.joints.iter().enumerate() {
        let mut force = positions[index].number(0.0);
        if let Some(stiffness) = joint.stiffness {
            force = force - stiffness * positions[index];
        }
        if let Some(damping) = joint.damping {
            force = force - damping * rates[index];
        }
        for (on, value) in mechanism.forces.iter().zip(forces) {
            force = if *on == index { force + *value } else { force };
        }
        applied.push(force);
    }
    for link in links {
        let rate = link.by_joint.iter().map(|(joint, by)| *by * rates[*joint]);
        let rate = rate.fold(link.length.number(0.0), |sum, term| sum + term);
        let tension = link.stiffness * link.stretch + link.damping * rate;
        for (joint, by) in &link.by_joint {
            applied[*joint] = applied[*joint] - *by * tension;
        }
    }
    applied
}

/// A link with its length in a position.
pub struct Stretched<'a> {
    pub stiffness: Quantity<'a>,
    damping: Quantity<'a>,
    length: Quantity<'a>,
    /// By how much it is longer than in the reference configuration.
    pub stretch: Quantity<'a>,
    /// How fast it grows at unit rate of each joint.
    by_joint: Vec<(usize, Quantity<'a>)>,
}

pub fn find_links<'a>(
    mechanism: &Mechanism<Quantity<'a>>,
    frames: &Frames<'a>,
    some: Quantity<'a>,
) -> Vec<Stretched<'a>> {
    let none = zero(some);
    let stretched = |link: &Link<Quantity<'a>>| {
        let carriers = link.joints.map(|joint| frames.of_joint(joint));
        let points = [0, 1].map(|end| frames.all[carriers[end]].point(&link.points[end]));
        let places = [0, 1].map(|end| frames.place(carriers[end], points[end]));
        let between = subtract(places[1], places[0]);
        let at_rest = subtract(link.points[1], link.points[0]);
        let [length, at_rest] = [between, at_rest].map(|vector| dot(vector, vector).sqrt());
        let direction = scale(some.number(1.0) / length, between);
        let carries = |end: usize, frame: usize| frames.path(carriers[end]).any(|above| above == frame);
        let by_joint = (1..frames.all.len()).filter_map(|frame| {
            // What carries both moves them as one.
            let (end, sign) = match [carries(0, frame), carries(1, frame)] {
                [false, true] => (1, 1.0),
                [true, false] => (0, -1.0),
                _ => return None,
            };
            let axis = frames.outer(frame, 0, frames.all[frame].axis);
            let velocity = match frames.all[frame].motion {
                Motion::Turns => cross(axis, subtract(places[end], frames.place(frame, none))),
                Motion::Slides => axis,
            };
            Some((frames.all[frame].joint?, some.number(sign) * dot(direction, velocity)))
        });
        Stretched {
            stiffness: link.stiffness.unwrap_or(none[0]),
            damping: link.damping.unwrap_or(none[0]),
            length,
            stretch: length - at_rest,
            by_joint: by_joint.collect(),
        }
    };
    mechanism.links.iter().map(stretched).collect()
}

/// The potential energy of springs.
pub fn find_spring_energy<'a>(
    mechanism: &Mechanism<Quantity<'a>>,
    links: &[Stretched<'a>],
    positions: &[Quantity<'a>],
    some: Quantity<'a>,
) -> Quantity<'a> {
    let joints = mechanism.joints.iter().zip(positions);
    let joints = joints.filter_map(|(joint, position)| Some(joint.stiffness? * position.square()));
    let links = links.iter().map(|link| link.stiffness * link.stretch.square());
    joints.chain(links).fold(some.number(0.0), |sum, twice| sum + some.number(0.5) * twice)
}
