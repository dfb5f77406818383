//! The equations of motion of a machine at a state, step by step.

use super::forces::{Moved, Stretched, Taken, find_applied, find_links, find_spring_energy, find_taken};
use super::frames::Frames;
use super::inertia::{Composites, Load, find_loads};
use super::layout::Layout;
use super::movement::{Movement, find_accelerations, find_velocities};
use super::quantity::{Arithmetic, Quantity};
use super::rolling::{
    find_contact_acceleration, find_contact_velocity, find_progress, find_progress_rate, find_rows, find_shares,
};
use super::solve::{Matrix, solve, solve_definite};
use super::vectors::{Vector, add, dot, negative, scale, subtract, unit, zero};
use super::wheels::Contact;
use super::{Machine, instantiate};
use crate::mechanics::{Ground, Mechanism};
use crate::program::Value;

/// A machine at a state, as far as its velocities.
pub struct Equations<'a, 'm> {
    pub(super) layout: &'m Layout,
    pub(super) mechanism: Mechanism<Quantity<'a>>,
    pub(super) frames: Frames<'a>,
    pub(super) contacts: Vec<Contact<'a>>,
    loads: Vec<Load<'a>>,
    links: Vec<Stretched<'a>>,
    pub(super) zero: Quantity<'a>,
    gravity: Quantity<'a>,
    /// By joint.
    pub(super) positions: Vec<Quantity<'a>>,
    pub(super) forces: Vec<Quantity<'a>>,
    /// The rate of each joint by the speeds.
    shares: Matrix<'a>,
    pub(super) speeds: Vec<Quantity<'a>>,
    /// By joint.
    rates: Vec<Quantity<'a>>,
    /// The frame of the root whose axes the whole machine is seen in.
    axes: usize,
    /// From the origin of the root to where the first wheel touches the ground, in these axes.
    point: Vector<'a>,
    velocities: Movement<'a>,
}

impl<'a, 'm> Equations<'a, 'm> {
    pub fn new(machine: &Machine, layout: &'m Layout, arithmetic: &'a Arithmetic) -> Self {
        let mechanism = instantiate(machine, arithmetic);
        let nothing = arithmetic.number(0.0);
        let none = zero(nothing);
        let mut next = machine.parameters..;
        let mut input = || next.next().map_or(nothing, |index| arithmetic.input(index));
        let mut positions = vec![nothing; mechanism.joints.len()];
        layout.positions.iter().for_each(|joint| positions[*joint] = input());
        let speeds: Vec<Quantity<'a>> = layout.conditions.independent.iter().map(|_| input()).collect();
        let forces: Vec<Quantity<'a>> = mechanism.forces.iter().map(|_| input()).collect();

        let frames = Frames::new(&mechanism, &positions, mechanism.wheels.first().map(|wheel| wheel.centre));
        let vertical = unit(nothing, 2);
        let contacts: Vec<Contact<'a>> =
            (0..mechanism.wheels.len()).map(|wheel| Contact::new(&mechanism, &frames, wheel, vertical)).collect();
        let shares = find_shares(&mechanism, &frames, &contacts, &layout.conditions, nothing);
        let rate = |share: &Vec<Quantity<'a>>| {
            share.iter().zip(&speeds).fold(nothing, |sum, (share, speed)| sum + *share * *speed)
        };
        let rates: Vec<Quantity<'a>> = shares.iter().map(rate).collect();
        let axes = contacts.first().map_or(0, |first| if frames.in_root(first.frame) { first.frame } else { 0 });
        let point = match contacts.first() {
            None => none,
            Some(first) if frames.in_root(first.carrier) => frames.outer(first.frame, axes, first.arm),
            Some(first) => frames.inner(0, axes, first.place),
        };
        let mut velocities = find_velocities(&frames, &rates, axes, none);
        if let Some(first) = contacts.first() {
            let centre = velocities.centre_velocity(&frames, first);
            let spin = velocities.spins[first.frame];
            let slip = find_contact_velocity(first, centre, spin, first.sum_about_axle(&rates));
            let start = negative(frames.outer(first.frame, axes, slip));
            velocities = find_velocities(&frames, &rates, axes, start);
        }
        let loads = find_loads(&mechanism, &frames, nothing);
        let links = find_links(&mechanism, &frames, nothing);
        let gravity = machine.gravity.map_or(nothing, |index| arithmetic.input(index));
        Self {
            layout,
            mechanism,
            frames,
            contacts,
            loads,
            links,
            zero: nothing,
            gravity,
            positions,
            forces,
            shares,
            speeds,
            rates,
            axes,
            point,
            velocities,
        }
    }

    /// What the programs compute, in their order.
    pub fn outputs(&self) -> [Vec<Value>; 6] {
        let values = |quantities: Vec<Quantity<'a>>| quantities.iter().map(|quantity| quantity.value).collect();
        let rates = self.position_rates();
        let drift = self.find_drift();
        let speed_rates = self.find_speed_rates(&drift);
        let second = self.find_second(&drift, &speed_rates);
        let derivatives = rates.iter().chain(&speed_rates).copied().collect();
        [
            values(self.find_closure()),
            values(rates),
            values(derivatives),
            values(self.position_accelerations(&second)),
            values(self.find_energy()),
            values(self.find_contact_forces(&second)),
        ]
    }

    /// How far the wheels behind the first are below it.
    pub(super) fn find_below(&self) -> Vec<Quantity<'a>> {
        let Some(first) = self.contacts.first() else { return Vec::new() };
        self.contacts[1..].iter().map(|contact| contact.from(first)[2]).collect()
    }

    fn find_closure(&self) -> Vec<Quantity<'a>> {
        let Layout { heights, standing, .. } = self.layout;
        let below = self.find_below();
        let rows = find_rows(&self.mechanism, &self.frames, &self.contacts, heights, standing);
        let sides = vec![below.iter().map(|below| -*below).collect()];
        let steps = solve(&rows, &sides).into_iter().flatten();
        below.into_iter().chain(steps).collect()
    }

    /// The accelerations of joints where the speeds do not change.
    pub(super) fn find_drift(&self) -> Vec<Quantity<'a>> {
        let mut drift = vec![self.zero; self.mechanism.joints.len()];
        if self.contacts.is_empty() {
            return drift;
        }
        let accelerations = self.accelerate(&drift, zero(self.zero));
        let slip_rates: Vec<[Quantity<'a>; 3]> = self
            .contacts
            .iter()
            .map(|contact| contact.on_the_ground(self.contact_acceleration(contact, &accelerations, &drift)))
            .collect();
        let side = self.layout.conditions.kept.iter().map(|condition| -match *condition {
            Ground::Along(wheel) => slip_rates[wheel][0],
            Ground::Sideways(wheel) => slip_rates[wheel][1],
            Ground::Height(wheel) => slip_rates[wheel][2],
        });
        let sides = vec![side.collect()];
        let dependent = &self.layout.conditions.dependent;
        let rows = find_rows(&self.mechanism, &self.frames, &self.contacts, &self.layout.conditions.kept, dependent);
        for (joint, value) in dependent.iter().zip(solve(&rows, &sides).into_iter().flatten()) {
            drift[*joint] = value;
        }
        drift
    }

    fn contact_acceleration(
        &self,
        contact: &Contact<'a>,
        accelerations: &Movement<'a>,
        second: &[Quantity<'a>],
    ) -> Vector<'a> {
        let centre = accelerations.centre_acceleration(&self.velocities, &self.frames, contact);
        let spins = [self.velocities.spins[contact.frame], accelerations.spins[contact.frame]];
        let about_axle = [contact.sum_about_axle(&self.rates), contact.sum_about_axle(second)];
        find_contact_acceleration(contact, centre, spins, about_axle)
    }

    /// The accelerations of all frames, of those of the joints, with that of a field.
    fn accelerate(&self, second: &[Quantity<'a>], field: Vector<'a>) -> Movement<'a> {
        let find = |start| find_accelerations(&self.frames, &self.velocities, [&self.rates, second], self.axes, start);
        let field = self.frames.inner(0, self.axes, field);
        let Some(first) = self.contacts.first() else { return find(field) };
        let slip_rate = self.contact_acceleration(first, &find(zero(self.zero)), second);
        find(subtract(field, self.frames.outer(first.frame, self.axes, slip_rate)))
    }

    /// What a motion takes: gravity is an acceleration upward.
    fn take(&self, second: &[Quantity<'a>]) -> Taken<'a> {
        let upward = scale(-self.gravity, unit(self.zero, 2));
        let accelerations = self.accelerate(second, upward);
        let moved = Moved { velocities: &self.velocities, accelerations: &accelerations, rates: &self.rates, second };
        find_taken(&self.mechanism, &self.frames, &self.loads, &self.contacts, &moved, (self.axes, self.point))
    }

    fn applied(&self) -> Vec<Quantity<'a>> {
        find_applied(&self.mechanism, &self.links, &self.positions, &self.rates, &self.forces)
    }

    fn composites(&self) -> Composites<'a, '_> {
        Composites::new(&self.mechanism, &self.frames, &self.loads, self.axes, self.point)
    }

    /// What is left of the forces that drive each speed in a motion with accelerations of the joints.
    pub(super) fn find_unbalanced(&self, second: &[Quantity<'a>]) -> Vec<Quantity<'a>> {
        let composites = self.composites();
        let Taken { by_joint, moment, .. } = self.take(second);
        let applied = self.applied();
        let side = |speed: usize| {
            // The joints of the root together turn the machine about its point of contact.
            let turning = composites.turning(&self.shares, speed);
            let start = -dot(turning, moment);
            (0..by_joint.len()).fold(start, |sum, joint| {
                let is_root = self.mechanism.root.is_some_and(|root| joint < root.count);
                let taken = if is_root { self.zero } else { by_joint[joint] };
                sum + self.shares[joint][speed] * (applied[joint] - taken)
            })
        };
        (0..self.speeds.len()).map(side).collect()
    }

    pub(super) fn find_mass(&self) -> Matrix<'a> {
        self.composites().mass(&self.shares, &self.contacts)
    }

    fn find_speed_rates(&self, drift: &[Quantity<'a>]) -> Vec<Quantity<'a>> {
        solve_definite(&self.find_mass(), &self.find_unbalanced(drift))
    }

    /// The accelerations of all joints.
    pub(super) fn find_second(&self, drift: &[Quantity<'a>], speed_rates: &[Quantity<'a>]) -> Vec<Quantity<'a>> {
        let second = |(share, drift): (&Vec<Quantity<'a>>, &Quantity<'a>)| {
            share.iter().zip(speed_rates).fold(*drift, |sum, (share, rate)| sum + *share * *rate)
        };
        self.shares.iter().zip(drift).map(second).collect()
    }

    /// A horizontal vector along the heading of the first wheel and to the right, along the axes of the ground.
    fn on_ground(&self, horizontal: Vector<'a>) -> Vector<'a> {
        let Some(root) = self.mechanism.root else { return horizontal };
        let yaw = self.positions[root.yaw];
        let [sin, cos] = [yaw.sin(), yaw.cos()];
        let [x, y, z] = horizontal;
        [cos * x - sin * y, sin * x + cos * y, z]
    }

    /// By position, of what joints have, but for the place on the ground.
    fn by_position(&self, by_joint: &[Quantity<'a>], [along, beside]: [Quantity<'a>; 2]) -> Vec<Quantity<'a>> {
        let all = self.layout.positions.iter();
        let Some((first, root)) = self.contacts.first().zip(self.mechanism.root) else {
            return all.map(|joint| by_joint[*joint]).collect();
        };
        let [x, y, _] = self.on_ground(first.in_base(along, beside, self.zero));
        let value = |joint: &usize| match *joint {
            joint if joint == root.forward => x,
            joint if joint == root.lateral => y,
            joint => by_joint[joint],
        };
        all.map(value).collect()
    }

    pub(super) fn position_rates(&self) -> Vec<Quantity<'a>> {
        let progress = self.contacts.first().map_or([self.zero; 2], |first| {
            find_progress(first, self.velocities.spins[first.frame], first.sum_about_axle(&self.rates))
        });
        self.by_position(&self.rates, progress)
    }

    fn position_accelerations(&self, second: &[Quantity<'a>]) -> Vec<Quantity<'a>> {
        let Some((first, root)) = self.contacts.first().zip(self.mechanism.root) else {
            return self.by_position(second, [self.zero; 2]);
        };
        let accelerations = self.accelerate(second, zero(self.zero));
        let spins = [self.velocities.spins[first.frame], accelerations.spins[first.frame]];
        let about_axle = [first.sum_about_axle(&self.rates), first.sum_about_axle(second)];
        let progress_rate = find_progress_rate(first, spins, about_axle, self.rates[root.yaw]);
        self.by_position(second, progress_rate)
    }

    fn find_energy(&self) -> Vec<Quantity<'a>> {
        let composites = self.composites();
        let mass = composites.mass(&self.shares, &self.contacts);
        let twice = mass.iter().zip(&self.speeds).fold(self.zero, |sum, (row, speed)| {
            let momentum = row.iter().zip(&self.speeds).fold(self.zero, |sum, (entry, other)| sum + *entry * *other);
            sum + *speed * momentum
        });
        let vertical = self.frames.inner(0, self.axes, unit(self.zero, 2));
        let weight = self.gravity * dot(vertical, composites.whole().moment);
        let springs = find_spring_energy(&self.mechanism, &self.links, &self.positions, self.zero);
        vec![self.zero.number(0.5) * twice, springs - weight]
    }

    fn find_contact_forces(&self, second: &[Quantity<'a>]) -> Vec<Quantity<'a>> {
        if self.contacts.is_empty() {
            return Vec::new();
        }
        let Taken { by_joint, whole, .. } = self.take(second);
        let applied = self.applied();
        let conditions = &self.layout.conditions;
        let rows = find_rows(&self.mechanism, &self.frames, &self.contacts, &conditions.kept, &conditions.dependent);
        let count = conditions.dependent.len();
        let transposed: Matrix<'a> = (0..count).map(|joint| rows.iter().map(|row| row[joint]).collect()).collect();
        let sides = vec![conditions.dependent.iter().map(|joint| by_joint[*joint] - applied[*joint]).collect()];
        let multipliers: Vec<Quantity<'a>> = solve(&transposed, &sides).into_iter().flatten().collect();
        let mut on_wheels = vec![zero(self.zero); self.contacts.len()];
        for (wheel, force) in on_wheels.iter_mut().enumerate().skip(1) {
            let find = |condition: Ground| {
                let place = conditions.kept.iter().position(|kept| *kept == condition);
                place.map_or(self.zero, |place| multipliers[place])
            };
            let [along, beside, down] =
                [find(Ground::Along(wheel)), find(Ground::Sideways(wheel)), find(Ground::Height(wheel))];
            *force = self.contacts[wheel].in_base(along, beside, down);
        }
        let others = on_wheels.iter().fold(zero(self.zero), |sum, force| add(sum, *force));
        on_wheels[0] = subtract(self.frames.outer(self.axes, 0, whole), others);
        on_wheels.into_iter().flat_map(|force| self.on_ground(force)).collect()
    }
}
