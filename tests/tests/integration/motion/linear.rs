//! The derivatives of nonlinear equations about upright running are the matrices that were derived to first order by another
//! way: the engine's, from velocities and second derivatives of heights.

use std::path::Path;

use carvallo::Coefficients;
use nalgebra::{SMatrix, SVector};

use super::interpreted::{Input, Interpreted};
use crate::mechanisms::interpreted;

/// Holds a shipped mechanism against its own matrices at 20 speeds.
fn check<const N: usize>(model: &str) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated/models");
    let source = std::fs::read_to_string(folder.join(format!("{model}.rs"))).expect("a source");
    let (_, body) = source.split_once('{').expect("an opening brace");
    let (body, _) = body.rsplit_once('}').expect("a closing brace");
    let asks = body.lines().any(|line| line.trim() == "nonlinear;");
    let declaration = if asks { body.to_owned() } else { body.replacen("mechanism {", "nonlinear; mechanism {", 1) };
    let compiled = carvallo_compiler::compile(declaration.parse().expect("tokens")).expect("a model");
    let values = &compiled.model.sets.first().expect("a set").values;
    let matrices: Coefficients<f64, N> = interpreted(&compiled, values);
    let gravity = compiled.model.gravity.map_or(0.0, |index| values[index]);
    let described = compiled.model.motion.as_ref().expect("nonlinear equations");
    let layout = &described.layout;
    let mechanism = &described.machine.mechanism;
    let motion = Interpreted::new(&compiled, values);
    let (positions, speeds) = (layout.positions.len(), motion.speeds());
    let place = |joint: usize| layout.positions.iter().position(|position| *position == joint).expect("a position");
    let speed = |joint: usize| layout.conditions.independent.iter().position(|independent| *independent == joint);
    let first_spin = mechanism.wheels.first().and_then(|wheel| speed(wheel.spin));
    let origin = vec![0.0; positions];
    // How the coordinates move by the speeds: the displacement of the root by the spin of its first wheel.
    let forward = mechanism.root.map(|root| root.forward);
    let unit: Vec<f64> = (0..speeds).map(|index| f64::from(u8::from(Some(index) == first_spin))).collect();
    let progress = first_spin.map_or(0.0, |_| motion.rates(&origin, &unit)[0]);
    let beside = mechanism.wheels.first().map_or(0.0, |wheel| wheel.centre[1].evaluate(values, &[]));
    let yaw = mechanism.root.and_then(|root| speed(root.yaw));
    let by_speeds = |coordinate: usize, index: usize| -> f64 {
        match mechanism.coordinates[coordinate] {
            joint if Some(joint) == forward => match Some(index) {
                spin if spin == first_spin => progress,
                turning if turning == yaw => beside,
                _ => 0.0,
            },
            joint => f64::from(u8::from(speed(joint) == Some(index))),
        }
    };
    for step in 0..20 {
        let v = 0.5 * f64::from(step);
        let mut state = vec![0.0; positions + speeds + mechanism.forces.len()];
        if let Some(spin) = first_spin {
            state[positions + spin] = v / progress;
        }
        let Coefficients { m, c0, c1, kc, k0, k1, k2, .. } = matrices;
        let (damping, stiffness) = (c0 + c1 * v, kc + k0 * gravity + k1 * v + k2 * (v * v));
        let [partials, _] = motion.partials(&state);
        let column = |input: usize| {
            let carried = motion.differentiate(&state, Input::State(input));
            for (row, expected) in carried.iter().enumerate() {
                let error = (partials[row][input] - expected).abs();
                assert!(error <= 1e-12 * expected.abs().max(1.0), "{model} at {v} m/s: {row}, {input}: {error:e}");
            }
            let rates = |index: usize| partials[positions + index][input];
            SVector::<f64, N>::from_fn(|row, _| (0..speeds).map(|index| by_speeds(row, index) * rates(index)).sum())
        };
        let mut by_positions = SMatrix::<f64, N, N>::zeros();
        for (coordinate, joint) in mechanism.coordinates.iter().enumerate() {
            by_positions.set_column(coordinate, &column(place(*joint)));
        }
        let error = (m * by_positions + stiffness).amax();
        assert!(error <= 1e-10 * stiffness.amax().max(1.0), "{model} at {v} m/s: K is off by {error:e}");
        // By each speed, of which the forward one may be no coordinate.
        for index in 0..speeds {
            let moved = SVector::<f64, N>::from_fn(|row, _| by_speeds(row, index));
            let error = (m * column(positions + index) + damping * moved).amax();
            assert!(error <= 1e-10 * damping.amax().max(1.0), "{model} at {v} m/s: C is off by {error:e}");
        }
    }
}

#[test]
fn derivatives_about_upright_running_are_the_matrices_of_every_shipped_mechanism_without_slip() {
    check::<2>("double_pendulum");
    check::<2>("flywheel_bicycle");
    check::<2>("rear_steered");
    check::<2>("rolling_disc");
    check::<1>("skateboard");
    check::<3>("wheeled_pendulum");
    check::<3>("whipple_leaning");
    check::<2>("whipple_mechanism");
    check::<2>("whipple_sprung");
    check::<2>("whipple_tyres");
}

#[test]
fn every_shipped_mechanism_without_slip_is_among_them() {
    let text = include_str!("linear.rs");
    for entry in std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated/models")).expect("sources")
    {
        let path = entry.expect("a file").path();
        let source = std::fs::read_to_string(&path).expect("a source");
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        // Control laws are given at a speed.
        let is_refused = ["cornering", "feedback"].iter().any(|word| source.contains(word));
        if source.contains("mechanism {") && !is_refused {
            assert!(text.contains(&format!(">(\"{name}\")")), "{name} is not checked");
        }
    }
}
