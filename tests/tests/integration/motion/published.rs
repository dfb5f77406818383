//! One state of the benchmark bicycle (Basu-Mandal, Chatterjee & Papadopoulos 2007, Table 1), in print and recomputed.

use carvallo::Motion;
use carvallo_models::{Whipple, WhippleMechanism};

/// The rows of one kind, of the table in `data/`.
fn read(what: &str) -> impl Fn(&str) -> f64 {
    const TABLE: &str = include_str!("../../../data/circular_motion.tsv");
    let rows = TABLE.lines().filter(|line| !line.starts_with('#')).map(|line| line.split('\t').collect::<Vec<_>>());
    let rows: Vec<Vec<&str>> = rows.filter(|row| row[0] == what).collect();
    let what = what.to_owned();
    move |name| {
        let row = rows.iter().find(|row| row[1] == name);
        row.unwrap_or_else(|| panic!("{what} {name}"))[2].parse().expect("a number")
    }
}

/// The second derivatives of the centre of the rear wheel from those of the point where it touches the ground.
fn centre(radius: f64, positions: &[f64; 8], rates: &[f64; 8], accelerations: &[f64; 8]) -> [f64; 3] {
    let [_, _, yaw, lean, ..] = *positions;
    let ([_, _, yawd, leand, ..], [x, y, yawdd, leandd, ..]) = (*rates, *accelerations);
    // It is at radius sin(lean) to the right, and at radius cos(lean) above.
    let side = radius * lean.sin();
    let side_rate = radius * lean.cos() * leand;
    let side_rate_rate = radius * (lean.cos() * leandd - lean.sin() * leand * leand);
    let along = -(yawdd * side + 2.0 * yawd * side_rate);
    let beside = side_rate_rate - yawd * yawd * side;
    let rise = radius * (lean.sin() * leandd + lean.cos() * leand * leand);
    [x + along * yaw.cos() - beside * yaw.sin(), y + along * yaw.sin() + beside * yaw.cos(), rise]
}

#[test]
fn the_accelerations_and_contact_forces_of_a_bicycle_that_rounds_a_corner() {
    let motion = WhippleMechanism::BENCHMARK.motion();
    let info = <carvallo_models::WhippleMechanismMotion as Motion>::INFO;
    let names: Vec<&str> = info.positions.iter().map(|position| position.name).collect();
    assert_eq!(names, ["x", "y", "psi", "phi", "pitch", "delta", "thetaR", "thetaF"]);
    let [position, rate, acceleration, force] = ["position", "rate", "acceleration", "force"].map(read);
    let positions = [0.0, 0.0, 0.0, position("roll"), 0.0, position("steer"), 0.0, 0.0];
    let positions = motion.close(&positions).expect("it stands on both wheels");
    let pitch = positions[4] - position("pitch");
    assert!(pitch.abs() < 1e-15, "pitch is off by {pitch:e}");
    let speeds = [rate("roll"), rate("steer"), rate("wheel_r")];
    let rates = motion.rates(&positions, &speeds).expect("it rolls");
    let joints = ["yaw", "roll", "pitch", "steer", "wheel_r", "wheel_f"];
    for (place, name) in joints.iter().enumerate() {
        let error = rates[place + 2] - rate(name);
        assert!(error.abs() < 1e-13, "the rate of {name} is off by {error:e}");
    }
    let accelerations = motion.accelerations(&positions, &speeds, &[0.0; 2]).expect("regular");
    let [x, y, z] = centre(Whipple::BENCHMARK.rR, &positions, &rates, &accelerations);
    let found = [x, y, z].into_iter().chain(accelerations[2..].iter().copied());
    let all = ["x", "y", "z"].into_iter().chain(joints);
    for (name, found) in all.zip(found) {
        let error = found - acceleration(name);
        assert!(error.abs() < 1e-13, "the acceleration of {name} is {found}, off by {error:e}");
    }
    let (_, speed_rates) = motion.derivatives(&positions, &speeds, &[0.0; 2]).expect("regular");
    for (place, name) in [(0, "roll"), (1, "steer"), (2, "wheel_r")] {
        let error = speed_rates[place] - acceleration(name);
        assert!(error.abs() < 1e-13, "the rate of the speed {name} is off by {error:e}");
    }

    let [rear, front] = motion.contact_forces(&positions, &speeds, &[0.0; 2]).expect("regular");
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        for (wheel, found) in [("rear", rear[axis]), ("front", front[axis])] {
            let error = found - force(&format!("{wheel}_{name}"));
            assert!(error.abs() < 2e-12 * 400.0, "the force on the {wheel} wheel along {name} is off by {error:e}");
        }
    }
}

#[test]
fn the_printed_accelerations() {
    let motion = WhippleMechanism::BENCHMARK.motion();
    let [input, output] = ["input", "output"].map(read);
    let quarter = std::f64::consts::FRAC_PI_2;
    let positions = [0.0, 0.0, 0.0, quarter - input("psi"), 0.0, -input("psif"), 0.0, 0.0];
    let positions = motion.close(&positions).expect("it stands on both wheels");
    let speeds = [-input("psid"), -input("psifd"), -input("betard")];
    let rates = motion.rates(&positions, &speeds).expect("it rolls");
    let accelerations = motion.accelerations(&positions, &speeds, &[0.0; 2]).expect("regular");
    let [x, y, z] = centre(Whipple::BENCHMARK.rR, &positions, &rates, &accelerations);
    let [_, _, yaw, lean, pitch, steer, rear, front] = accelerations;
    let names = ["xdd", "ydd", "zdd", "thetadd", "psidd", "phidd", "psifdd", "betardd", "betafdd"];
    let found = [-x, y, -z, -yaw, -lean, -pitch, -steer, -rear, -front];
    for (name, found) in names.into_iter().zip(found) {
        let error = found - output(name);
        assert!(error.abs() < 2e-12, "{name} is {found}, off by {error:e}");
    }
}
