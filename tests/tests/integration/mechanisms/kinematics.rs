//! Rates and forces that follow from the coordinates.

use carvallo_models::{RollingDisc, Skateboard, Whipple, WhippleLeaning, WhippleMechanism};
use carvallo_tests::{bicycles, designs};

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-14 * expected.abs().max(1.0), "{found} {expected}");
}

#[test]
fn yaw_lateral_and_wheel_rates_of_the_bicycle_are_the_papers() {
    let all = bicycles::all().into_iter().map(|(_, design)| design);
    for (number, design) in all.chain((0..100).map(designs::numbered)).enumerate() {
        let Whipple { w, c, lam, rR, rF, .. } = design;
        let found = WhippleMechanism::from_array(design.to_array()).kinematics();
        let [v, phi, delta, psi] = [4.6, 0.03, -0.05, 0.2 + number as f64 / 100.0];
        let (q, q_dot) = ([phi, delta], [0.7, -0.4]);
        let at = |rate: carvallo::Rate<f64, 2>| rate.at(v, &q, &q_dot, psi);
        // Meijaard et al. (2007): psi' = (v delta + c delta') cos lam/w, y' = v psi, wheels roll.
        close(at(found.yaw), (v * delta + c * q_dot[1]) * lam.cos() / w);
        close(at(found.lateral), v * psi);
        close(at(found.wheel_R), -v / rR);
        close(at(found.wheel_F), -v / rF);
        assert_eq!(found.forces, [[1.0, 0.0], [0.0, 1.0]], "lean torque and steer torque");
    }
}

#[test]
fn a_leaning_rider_does_not_steer() {
    let found = WhippleLeaning::EXAMPLE.kinematics();
    assert_eq!((found.yaw.rates[2], found.yaw.coordinates[2]), (0.0, 0.0));
    assert_eq!(found.forces[2], [0.0, 0.0, 1.0]);
}

#[test]
fn a_disc_goes_where_it_heads() {
    let RollingDisc { r, .. } = RollingDisc::UNIFORM;
    let found = RollingDisc::UNIFORM.kinematics();
    // Its yaw is a coordinate.
    close(found.lateral.at(2.0, &[0.1, 0.3], &[0.5, 0.7], 0.0), 2.0 * 0.3);
    close(found.wheel_D.at(2.0, &[0.1, 0.3], &[0.5, 0.7], 0.0), -2.0 / r);
}

#[test]
fn a_tilted_skateboard_turns_about_the_point_where_its_axles_meet() {
    let board = Skateboard { lamF: 0.9, lamR: 0.6, ..Skateboard::EXAMPLE };
    let Skateboard { L, b, r, lamF, lamR, .. } = board;
    let found = board.kinematics();
    let (v, gamma) = (3.0, 0.02);
    let at = |rate: carvallo::Rate<f64, 1>| rate.at(v, &[gamma], &[0.0], 0.0);
    // The axles steer by tan(lamF) gamma and -tan(lamR) gamma.
    let yaw = v * gamma * (lamF.tan() + lamR.tan()) / L;
    close(at(found.yaw), yaw);
    close(at(found.deltaF) * 0.0 + found.deltaF.rates[0], -1.0 / lamF.cos());
    // The middle of the rear axle goes where that points, and the wheels on the inside of the turn are slower.
    close(at(found.lateral), -v * gamma * lamR.tan());
    close(at(found.wheel_RR), -(v - b * yaw) / r);
    close(at(found.wheel_RL), -(v + b * yaw) / r);
    close(at(found.wheel_FR), -(v - b * yaw) / r);
}
