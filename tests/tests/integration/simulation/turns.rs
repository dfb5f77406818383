//! Steady turns of the nonlinear bicycle, against those of other equations at 25 digits.

use carvallo::turns::{Turn, Turns, TurnsEnd, TurnsError};
use carvallo::{CriticalKind, Model, Stability};
use carvallo_models::WhippleMechanism;
use carvallo_tests::bicycles;
use carvallo_tests::multibody::bicycle::{Bicycle, Extras};
use carvallo_tests::multibody::dynamics::Drive;

use super::table;

const LEAN: usize = 3;
const PITCH: usize = 4;
const STEER: usize = 5;
const REAR_WHEEL: usize = 6;
const FRONT_WHEEL: usize = 7;

fn capsize(bicycle: &WhippleMechanism) -> f64 {
    let stability = Stability::new(&bicycle.coefficients(), bicycle.g).expect("finite numbers");
    let mut capsizes = stability.critical_speeds.iter().filter(|critical| critical.kind == CriticalKind::Capsize);
    capsizes.next_back().expect("a capsize speed").speed
}

#[test]
fn circles_are_those_of_twenty_five_digits() {
    let bicycle = WhippleMechanism::BENCHMARK;
    let speed = capsize(&bicycle);
    assert!((speed - 6.024_262_015_388_359).abs() < 1e-12, "{speed}");
    let turns = Turns::from_capsize(&bicycle.motion(), speed).expect("turns");
    for sample in table(include_str!("../../../data/steady_turns.tsv")) {
        let [steer, lean, pitch, rear, speed, yaw_rate, front, largest] = sample[..] else { panic!("eight columns") };
        let found = turns.where_position(&bicycle.motion(), STEER, steer.to_radians()).expect("turns");
        let [turn] = &found[..] else { panic!("one circle at {steer} degrees, not {}", found.len()) };
        let (q, rates) = (&turn.positions, &turn.rates);
        let pairs = [
            (q[LEAN], lean),
            (q[PITCH], pitch),
            (rates[REAR_WHEEL], rear),
            (turn.speed, speed),
            (turn.yaw_rate, yaw_rate),
            (rates[FRONT_WHEEL], front),
            (turn.radius, speed / yaw_rate),
        ];
        for (found, expected) in pairs {
            assert!((found - expected).abs() < 1e-11 * expected.abs().max(1.0), "{steer}: {found} is not {expected}");
        }
        let real_parts = turn.eigenvalues.iter().map(|eigenvalue| eigenvalue.re);
        let found = real_parts.fold(f64::NEG_INFINITY, f64::max);
        assert!((found - largest).abs() < 1e-8, "{steer}: {found} is not {largest}");
        assert!(!turn.is_stable());
    }
}

/// From straight running to rest, upright with the front wheel almost perpendicular.
#[test]
fn the_family_goes_from_the_capsize_speed_to_rest() {
    let bicycle = WhippleMechanism::BENCHMARK;
    let Turns { turns, end, .. } = Turns::from_capsize(&bicycle.motion(), capsize(&bicycle)).expect("turns");
    assert_eq!(end, TurnsEnd::Rest);
    let (first, last) = (&turns[0], &turns[turns.len() - 1]);
    assert!(first.radius.is_infinite() && first.positions.iter().all(|position| position.abs() < 1e-12), "{first:?}");
    assert!((last.positions[STEER] - 1.339_739_91).abs() < 1e-8, "{}", last.positions[STEER]);
    assert!(last.positions[LEAN].abs() < 1e-9 && last.speed.abs() < 1e-9, "{last:?}");
    for pair in turns.windows(2) {
        assert!((pair[1].positions[STEER] - pair[0].positions[STEER]).abs() < 0.05);
    }
}

/// The three families of Basu-Mandal, Chatterjee & Papadopoulos (2007), Hands-free circular motions of a benchmark bicycle:
/// from capsize to rest, as above; one from lying flat with the handlebar forward, through pivoting about the rear wheel, which
/// does not roll then, with the bicycle nearly upright, to circles that become ever faster, nearly upright and with the front
/// wheel almost perpendicular; and one from the capsize of the reversed bicycle to lying flat. In each of their circles the
/// forces of other dynamics of the same mechanism are in balance.
#[test]
fn the_benchmark_bicycle_has_three_families() {
    let bicycle = WhippleMechanism::BENCHMARK.motion();
    let known = Turns::from_capsize(&bicycle, capsize(&WhippleMechanism::BENCHMARK)).expect("turns");
    let others = Turns::others(&bicycle, &[known]).expect("turns");
    let [pivoting, reversed] = &others[..] else { panic!("{} families", others.len()) };
    let degrees = |turn: &Turn| [turn.positions[LEAN], turn.positions[STEER]].map(f64::to_degrees);
    let ends = |family: &Turns| [&family.turns[0], &family.turns[family.turns.len() - 1]].map(degrees);

    assert_eq!((pivoting.begin, pivoting.end), (TurnsEnd::Fallen, TurnsEnd::Fast));
    let [flat, fast] = ends(pivoting);
    assert!(flat[0] > 80.0 && (0.0..5.0).contains(&flat[1]), "{flat:?}");
    assert!(fast[0].abs() < 10.0 && (fast[1] - 90.0).abs() < 10.0, "{fast:?}");
    let rolls_back = pivoting.turns.iter().position(|turn| turn.speed < 0.0).expect("a rear wheel that turns back");
    let [lean, steer] = degrees(&pivoting.turns[rolls_back]);
    assert!(lean.abs() < 2.0 && (steer - 92.0).abs() < 4.0, "{lean} {steer}");

    assert_eq!((reversed.begin, reversed.end), (TurnsEnd::Fallen, TurnsEnd::Fallen));
    let [straight, flat] = ends(reversed);
    assert!((straight[1] - 180.0).abs() < 2.0 && straight[0].abs() < 10.0, "{straight:?}");
    assert!(flat[0] < -80.0 && flat[1] > 175.0, "{flat:?}");
    assert!(reversed.turns.iter().any(Turn::is_stable));

    let peer = Bicycle::new(&bicycles::named("benchmark"), &Extras::default());
    let independent = [peer.root.lean, peer.steer, peer.rear_wheel];
    let drive = Drive { gravity: 9.81, ..Drive::new(independent, None) };
    for turn in others.iter().flat_map(|family| family.turns.iter().step_by(7)) {
        let (q, u) = ([turn.positions[LEAN], turn.positions[STEER], 0.0], [0.0, 0.0, turn.rates[REAR_WHEEL]]);
        let left = peer.mechanism.forces(&drive, [q, u, [0.0; 3]]);
        let (left, size) = (left.amax(), 94.0 * (9.81 + turn.yaw_rate.powi(2)));
        // Near pivoting the rates of all else by that of the rear wheel are large, and so is their rounding.
        assert!(left < 1e-9 * size / turn.speed.abs().min(1.0), "{:?}: {left} of {size}", degrees(turn));
    }
}

/// Of every shipped bicycle that has a capsize speed the family is followed to an end, and each of its circles is steady.
#[test]
fn every_bicycle_has_its_circles() {
    for (name, design) in bicycles::all() {
        let bicycle = WhippleMechanism::from_slice(design.parameters().as_ref()).expect("the same parameters");
        let stability = Stability::new(&bicycle.coefficients(), bicycle.g).expect("finite numbers");
        for critical in stability.critical_speeds.iter().filter(|critical| critical.kind == CriticalKind::Capsize) {
            let turns = Turns::from_capsize(&bicycle.motion(), critical.speed).expect(name);
            assert!(!matches!(turns.end, TurnsEnd::Lost(_)), "{name}: {:?} after {}", turns.end, turns.turns.len());
        }
    }
}

#[test]
fn what_has_no_turns_is_told() {
    let bicycle = WhippleMechanism::BENCHMARK.motion();
    assert_eq!(Turns::from_capsize(&bicycle, 0.0), Err(TurnsError::Speed { speed: 0.0 }));
    assert_eq!(Turns::from_capsize(&bicycle, 3.0), Err(TurnsError::NoBalance { speed: 3.0 }));
    let swing = super::pendulums::Swing { gravity: 9.81 };
    assert_eq!(Turns::from_capsize(&swing, 1.0), Err(TurnsError::NoTurns));
}
