//! What forces do is what the energy gains, in motions far from upright; energy knows of no accelerations.

use carvallo_tests::bicycles;
use carvallo_tests::multibody::bicycle::{Bicycle, Extras, Rider};
use carvallo_tests::multibody::dynamics::Drive;
use carvallo_tests::multibody::{Body, Joint, Mechanism};
use nalgebra::{Matrix3, Vector3};

use super::RIDER;

fn check<const N: usize>(mechanism: &Mechanism, independent: [usize; N], [q, qd, qdd]: [[f64; N]; 3]) {
    let drive = Drive { gravity: 9.81, ..Drive::new(independent, None) };
    let after = |time: f64| {
        let position = std::array::from_fn(|i| q[i] + time * qd[i] + time * time / 2.0 * qdd[i]);
        let rate = std::array::from_fn(|i| qd[i] + time * qdd[i]);
        mechanism.energy(&drive, [position, rate, qdd])
    };
    let step = 1e-4;
    let gain = (after(step) - after(-step)) / (2.0 * step);
    let forces = mechanism.forces(&drive, [q, qd, qdd]);
    let power: f64 = forces.iter().zip(qd).map(|(force, rate)| force * rate).sum();
    assert!((power - gain).abs() <= 1e-6 * gain.abs(), "{power} W, and a gain of {gain} W");
}

#[test]
fn a_bicycle_with_everything_keeps_its_energy() {
    let rider = Some(Rider { damping: 0.0, ..RIDER });
    let extras = Extras { rear_tyre: 0.03, front_tyre: 0.06, steer_stiffness: 5.0, steer_damping: 0.0, rider };
    let bicycle = Bicycle::new(&bicycles::named("benchmark"), &extras);
    // Not the forward displacement: its direction would stay while the bicycle turns.
    let independent = [bicycle.root.lean, bicycle.steer, bicycle.rider.unwrap(), bicycle.rear_wheel];
    let motion = [[0.4, -0.3, 0.2, 0.0], [0.7, 1.1, -0.8, -9.0], [-2.0, 5.0, 3.0, 4.0]];
    check(&bicycle.mechanism, independent, motion);
}

#[test]
fn an_arm_with_a_slide_keeps_its_energy() {
    let mut arm = Mechanism::default();
    let swivel = arm.joint(Joint::revolute(None, Vector3::new(0.1, 0.2, 0.0), Vector3::new(1.0, 2.0, 3.0)));
    let slide = arm.joint(Joint::prismatic(Some(swivel), Vector3::new(1.0, 0.0, 0.5)).sprung(20.0, 0.0));
    let hinge = arm.joint(Joint::revolute(Some(slide), Vector3::new(0.5, 0.0, 0.3), Vector3::new(0.0, 1.0, -0.4)));
    for (joint, mass) in [(swivel, 1.0), (slide, 2.0), (hinge, 3.0)] {
        let inertia = Matrix3::new(0.4, 0.1, -0.05, 0.1, 0.5, 0.02, -0.05, 0.02, 0.3);
        arm.body(Body { joint, mass, centre: Vector3::new(0.7, -0.2, 0.4), inertia });
    }
    check(&arm, [swivel, slide, hinge], [[0.5, 0.2, -0.7], [1.3, -2.0, 0.9], [0.4, 3.0, -1.6]]);
}
