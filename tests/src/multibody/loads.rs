//! What acts inside a mechanism and at its wheels, beside springs at joints: side forces, struts and rotors.

use nalgebra::{DVector, Vector3};

use super::kinematics::{Kinematics, State};
use super::{Contact, Mechanism, Slip, Strut};

impl Mechanism {
    /// Adds to the generalized forces that a motion takes what side forces, struts and rotors take of them.
    pub(super) fn add_loads(&self, state: &State, kinematics: &Kinematics<'_>, forces: &mut DVector<f64>) {
        for contact in &self.contacts {
            if let Some(slip) = &contact.slip {
                add_side_force(contact, slip, state, kinematics, forces);
            }
        }
        self.struts.iter().for_each(|strut| add_strut(strut, kinematics, forces));
        for (joint, momentum) in &self.rotors {
            let link = kinematics.link(*joint);
            let moment = link.spin.cross(&link.turn(momentum));
            for partial in kinematics.partials(*joint, Vector3::zeros()) {
                forces[partial.coordinate] += partial.spin.dot(&moment);
            }
        }
    }
}

/// The side force of a tyre along the ground, across the heading of its wheel.
fn add_side_force(
    contact: &Contact,
    slip: &Slip,
    state: &State,
    kinematics: &Kinematics<'_>,
    forces: &mut DVector<f64>,
) {
    let touch = kinematics.touch(contact);
    let right = Vector3::z().cross(&touch.heading);
    let (rolling, sliding) = (touch.velocity.dot(&touch.heading), touch.slip.dot(&right));
    let force = match slip.relaxation {
        None => slip.camber * touch.lean - slip.cornering * sliding / rolling,
        Some((length, deflection)) => {
            let stiffness = slip.cornering / length;
            let (by, rate) = (state.q[deflection], state.qd[deflection]);
            // The tyre is deflected by the slip while what is deflected rolls away, with camber as a slip of its own.
            let fed = sliding - rolling * touch.lean * slip.camber / slip.cornering;
            forces[deflection] += stiffness * (rate + by * rolling / length - fed);
            -stiffness * by
        }
    };
    let acts_at = touch.place - touch.heading * slip.trail;
    for partial in kinematics.partials(contact.joint, acts_at) {
        forces[partial.coordinate] -= partial.velocity.dot(&right) * force;
    }
}

fn add_strut(strut: &Strut, kinematics: &Kinematics<'_>, forces: &mut DVector<f64>) {
    let [from, to] = &strut.ends;
    let relaxed = (to.1 - from.1).norm();
    let [(from_place, from_velocity), (to_place, to_velocity)] =
        [from, to].map(|(joint, point)| kinematics.carried(*joint, point));
    let direction = (to_place - from_place).normalize();
    let tension = strut.stiffness * ((to_place - from_place).norm() - relaxed)
        + strut.damping * direction.dot(&(to_velocity - from_velocity));
    for (end, place, sign) in [(from, from_place, -1.0), (to, to_place, 1.0)] {
        let Some(joint) = end.0 else { continue };
        for partial in kinematics.partials(joint, place) {
            forces[partial.coordinate] += sign * tension * direction.dot(&partial.velocity);
        }
    }
}
