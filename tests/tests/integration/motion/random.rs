//! Random mechanisms in random states, far from upright, against nonlinear dynamics that share no code.

use carvallo_tests::designs::config;
use carvallo_tests::multibody::dynamics::Drive;
use carvallo_tests::multibody::{Mechanism, Wheel};
use nalgebra::{SVector, Vector3};
use proptest::prelude::*;

use super::interpreted::{Input, Interpreted};
use super::partials::slope;
use crate::mechanisms::random::links::{Link, link};
use crate::mechanisms::random::pair::{Carrier, Pair};

/// What accelerations may differ by, of the largest.
const DIFFERENCE: f64 = 1e-11;

/// Compares rates of speeds and energy in a state, which is given by joints with positions and rates.
fn compare<const N: usize>(
    motion: &Interpreted<'_>,
    numeric: &Mechanism,
    gravity: f64,
    state: &[(usize, f64, f64)],
) -> Result<(), TestCaseError> {
    let independent = &motion.layout().conditions.independent;
    prop_assert_eq!(independent.len(), N, "speeds at {:?}", independent);
    let joints: [usize; N] = std::array::from_fn(|speed| independent[speed]);
    let find = |joint: usize| state.iter().find(|(known, ..)| *known == joint).map_or((0.0, 0.0), |(_, q, u)| (*q, *u));
    let given: Vec<(usize, f64)> = state.iter().map(|(joint, q, _)| (*joint, *q)).collect();
    let positions = motion.close(motion.positions(&given));
    let (q, u): ([f64; N], [f64; N]) = (joints.map(|joint| find(joint).0), joints.map(|joint| find(joint).1));
    let drive = Drive { gravity, ..Drive::new(joints, None) };
    let found = SVector::<f64, N>::from_vec(motion.speed_rates(&positions, &u));
    let expected = numeric.accelerations(&drive, [q, u], [0.0; N]);
    let error = (found - expected).amax();
    prop_assert!(error <= DIFFERENCE * expected.amax().max(1.0), "{found} is not {expected}: {error:e}");
    compare_partials(motion, numeric, &drive, [q, u], &positions)?;

    let accelerations = motion.accelerations(&positions, &u);
    let size = accelerations.iter().fold(1.0_f64, |size, value| size.max(value.abs()));
    for (place, (found, expected)) in accelerations.iter().zip(motion.rates_in_time(&positions, &u)).enumerate() {
        prop_assert!((found - expected).abs() <= DIFFERENCE * size, "{place}: {found} is not {expected}");
    }

    let [kinetic, potential] = motion.energy(&positions, &u);
    let expected = numeric.energy(&drive, [q, u, [0.0; N]]);
    let size = kinetic.abs() + potential.abs();
    prop_assert!((kinetic + potential - expected).abs() <= 1e-12 * size, "{kinetic} + {potential} J, not {expected} J");
    Ok(())
}

/// Compares derivatives: all of them with those that numbers carry through the equations, and those of the rates of the
/// speeds with differences of the other dynamics.
fn compare_partials<const N: usize>(
    motion: &Interpreted<'_>,
    numeric: &Mechanism,
    drive: &Drive<N>,
    state: [[f64; N]; 2],
    positions: &[f64],
) -> Result<(), TestCaseError> {
    let all = [positions, &state[1]].concat();
    let [by_state, by_parameters] = motion.partials(&all);
    let layout = motion.layout();
    let largest = by_state.iter().flatten().fold(1.0_f64, |largest, entry| largest.max(entry.abs()));
    for input in 0..all.len() {
        let found: Vec<f64> = by_state.iter().map(|row| row[input]).collect();
        if layout.positions.get(input).is_some_and(|joint| layout.standing.contains(joint)) {
            prop_assert!(found.iter().all(|entry| *entry == 0.0), "{} follows", input);
            continue;
        }
        for (row, (found, expected)) in found.iter().zip(motion.differentiate(&all, Input::State(input))).enumerate() {
            let error = (found - expected).abs();
            prop_assert!(error <= DIFFERENCE * largest, "{row} by {input}: {found} is not {expected}: {error:e}");
        }
    }
    for input in 0..by_parameters[0].len() {
        let carried = motion.differentiate(&all, Input::Parameter(input));
        let largest = carried.iter().fold(1.0_f64, |largest, entry| largest.max(entry.abs()));
        for (row, (found, expected)) in by_parameters.iter().zip(carried).enumerate() {
            let error = (found[input] - expected).abs();
            prop_assert!(error <= 10.0 * DIFFERENCE * largest, "{row} by parameter {input}: {error:e} of {expected}");
        }
    }
    for (speed, joint) in drive.independent.iter().enumerate() {
        let place = layout.positions.iter().position(|position| position == joint).expect("a position");
        for (varied, input, step) in [(0, place, 1e-3), (1, positions.len() + speed, 1e-2)] {
            let moved = |by: f64| {
                let mut moved = state;
                moved[varied][speed] += by;
                numeric.accelerations(drive, moved, [0.0; N])
            };
            let expected = slope(step, moved);
            let found = SVector::<f64, N>::from_fn(|row, _| by_state[positions.len() + row][input]);
            let error = (found - expected).amax();
            prop_assert!(
                error <= 1e-8 * largest.max(expected.amax()),
                "by {input}: {found} is not {expected}: {error:e}"
            );
        }
    }
    Ok(())
}

fn state(size: f64) -> impl Strategy<Value = [f64; 6]> {
    [-size..size, -size..size, -size..size, -3.0..3.0, -3.0..3.0, -3.0..3.0]
}

proptest! {
    #![proptest_config(config(6))]

    #[test]
    fn trees_of_any_joints_on_a_fixed_base(links in [link(), link(), link()], [a, b, c, ad, bd, cd] in state(2.0)) {
        let mut pair = Pair::default();
        let mut carriers = vec![Carrier { name: "ground".into(), joint: None }];
        for link in &links {
            let from = link.on.get(&carriers).clone();
            let next = pair.joint(&from, link);
            carriers.push(next);
        }
        // Without gravity there is none.
        let (compiled, values) = pair.compile_with(None, "nonlinear;")?;
        let motion = Interpreted::new(&compiled, &values);
        compare::<3>(&motion, &pair.numeric, 0.0, &[(0, a, ad), (1, b, bd), (2, c, cd)])?;
    }

    #[test]
    fn trees_of_balls_and_planar_bodies(
        three in [link(), link(), link()],
        link in link(),
        is_ball in any::<bool>(),
        is_first in any::<bool>(),
        // Short of where a ball's yaw and pitch would be about one axis.
        [a, b, c, ad, bd, cd] in state(1.2),
        (d, dd) in (-2.0..2.0, -3.0..3.0),
    ) {
        prop_assume!(three[0].axis.cross(&three[1].axis).norm() > 0.1);
        let mut pair = Pair::default();
        let mut carrier = Carrier { name: "ground".into(), joint: None };
        for turn in [is_first, !is_first] {
            carrier = if turn { pair.three(&carrier, &three, is_ball) } else { pair.joint(&carrier, &link) };
        }
        let (compiled, values) = pair.compile_with(None, "nonlinear;")?;
        let motion = Interpreted::new(&compiled, &values);
        compare::<4>(&motion, &pair.numeric, 0.0, &[(0, a, ad), (1, b, bd), (2, c, cd), (3, d, dd)])?;
    }

    #[test]
    fn vehicles_on_two_wheels_with_any_joints(
        frame in link(),
        links in [link(), link()],
        front_on in any::<prop::sample::Index>(),
        (rear, front) in ([0.1..0.5, 0.0..0.1, 1.0..5.0, 0.1..0.5, 0.05..0.3], [0.1..0.5, 0.0..0.1, 1.0..5.0, 0.1..0.5, 0.05..0.3]),
        wheel_base in 0.9..2.0,
        [lean, a, b, leand, ad, bd] in state(0.3),
        spin in -30.0..30.0,
        // Whether the wheel on a link leads.
        front_leads in any::<bool>(),
    ) {
        let mut pair = Pair::default();
        let root = pair.numeric.free_root();
        pair.parts.push_str("free b: lean phi;\n");
        pair.coordinates.push_str("phi: rad;");
        let frame = frame.in_plane();
        pair.body("b", root.pitch, frame.mass, frame.centre, frame.inertia());
        let mut carriers = vec![Carrier { name: "b".into(), joint: Some(root.pitch) }];
        for link in links {
            let mut link = link.in_plane();
            // Joints near the ground leave both wheels on it.
            link.point *= 0.3;
            let from = link.on.get(&carriers).clone();
            let next = pair.joint(&from, &link);
            carriers.push(next);
        }
        let wheel = |[radius, tyre, mass, axial, transverse]: [f64; 5], x, carrier| Wheel {
            carrier, x, y: 0.0, radius, tyre, mass, axial, transverse,
        };
        let (first, last) = (carriers[0].clone(), front_on.get(&carriers).clone());
        let rear = ("r", first, wheel(rear, 0.0, root.pitch));
        let front = ("f", last.clone(), wheel(front, wheel_base, last.joint.expect("a joint")));
        for (name, carrier, wheel) in if front_leads { [front, rear] } else { [rear, front] } {
            pair.wheel(name, &carrier, wheel, None);
        }
        let (compiled, values) = pair.compile_with(Some(9.81), "nonlinear;")?;
        let motion = Interpreted::new(&compiled, &values);
        let joint = root.pitch + 1;
        let state = [(root.lean, lean, leand), (joint, a, ad), (joint + 1, b, bd), (joint + 2, 0.0, spin)];
        compare::<4>(&motion, &pair.numeric, 9.81, &state)?;

        // Of the weight alone, without springs: it is raised by what the wheels bear in excess of it.
        let mass = pair.numeric.bodies.iter().map(|body| body.mass).sum::<f64>();
        let mut weightless = values.clone();
        *weightless.last_mut().expect("gravity") = 0.0;
        let light = Interpreted::new(&compiled, &weightless);
        let given: Vec<(usize, f64)> = state.iter().map(|(joint, q, _)| (*joint, *q)).collect();
        let speeds = [leand, ad, bd, spin];
        let positions = motion.close(motion.positions(&given));
        let raised = |time: f64| {
            let (rates, second) = (motion.rates(&positions, &speeds), motion.accelerations(&positions, &speeds));
            let later = positions.iter().zip(rates.iter().zip(&second));
            let later = later.map(|(q, (rate, second))| q + time * rate + time * time / 2.0 * second).collect();
            let speed_rates = motion.speed_rates(&positions, &speeds);
            let faster: Vec<f64> = speeds.iter().zip(&speed_rates).map(|(speed, rate)| speed + time * rate).collect();
            let later = motion.close(later);
            (motion.potential_rate(&later, &faster) - light.potential_rate(&later, &faster)) / (mass * 9.81)
        };
        let step = 1e-5;
        let expected = -mass * (9.81 + (raised(step) - raised(-step)) / (2.0 * step));
        let [_, _, found] = motion.contact_force(&positions, &speeds);
        prop_assert!((found - expected).abs() <= 1e-6 * expected.abs().max(100.0), "{found} N is not {expected} N");
    }

    #[test]
    fn tricycles_of_whose_wheels_on_one_axle_one_says_all_of_sideways_motion(
        frame in link(),
        fork in link(),
        trail in -0.1..0.2,
        [angle, spin] in [-0.8..0.8, -20.0..20.0],
        rate in -2.0..2.0,
        tyres in [0.0..0.1, 0.0..0.1],
    ) {
        let mut pair = Pair::default();
        let root = pair.numeric.free_root();
        // Nothing is symmetric, so the speed changes in the first order.
        pair.parts.push_str("free b: forward x;\n");
        pair.coordinates.push_str("x: m;");
        pair.body("b", root.pitch, frame.mass, frame.centre, frame.inertia());
        let frame = Carrier { name: "b".into(), joint: Some(root.pitch) };
        let axis = Vector3::new(fork.axis.x * 0.3, 0.0, 1.0);
        let fork = Link { slides: false, point: Vector3::new(1.0 + trail, 0.0, 0.0), axis, ..fork }.in_plane();
        let fork = pair.joint(&frame, &fork);
        let steer = fork.joint.expect("a joint");
        let [rear, front] = tyres;
        for (name, x, y, tyre, carrier) in
            [("l", 0.0, -0.4, rear, &frame), ("r", 0.0, 0.4, rear, &frame), ("f", 1.0, 0.0, front, &fork)]
        {
            let on = carrier.joint.expect("a joint");
            let wheel = Wheel { carrier: on, x, y, radius: 0.3, tyre, mass: 2.0, axial: 0.12, transverse: 0.06 };
            pair.wheel(name, carrier, wheel, None);
        }
        let (compiled, values) = pair.compile_with(Some(9.81), "nonlinear;")?;
        let motion = Interpreted::new(&compiled, &values);
        compare::<2>(&motion, &pair.numeric, 9.81, &[(steer, angle, rate), (steer + 1, 0.0, spin)])?;
    }
}
