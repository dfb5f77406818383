//! Nonlinear motions of many at once: equations and motions in lanes must be what they are alone, to the last bit, and motions
//! what another method makes of them.

use carvallo::batch::{Arrival, Batch, BatchError, Blocks, Ensemble, InLanes, Limit, Outcome};
use carvallo::motion::{MotionError, Unchecked, Vector};
use carvallo::simulation::{End, Simulation, State};
use carvallo::{Model, Motion, Nonlinear, Scalar};
use carvallo_models::{DoublePendulum, RollingDisc, WhippleMechanism};

/// More states than two blocks of `f32`, and lanes to spare.
const STATES: usize = 37;

/// Designs about the first parameter set of a model.
fn some<const N: usize, M: Model<N>>() -> Vec<M> {
    let set = M::INFO.sets.first().expect("a parameter set").values;
    let design = |number: usize| {
        let value = |(i, x): (usize, &f64)| M::Scalar::from_f64(x * (1.0 + 0.01 * ((number * (i + 1)) % 7) as f64));
        let values: Vec<M::Scalar> = set.iter().enumerate().map(value).collect();
        M::from_slice(&values).expect("as many values as parameters")
    };
    (0..STATES).map(design).collect()
}

/// Positions, speeds and forces of moderate size.
fn number(state: usize, place: usize) -> f64 {
    0.02 * ((state * (place + 3) + 5 * place) % 23) as f64 - 0.2
}

/// States of all numbers.
fn states<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(count: usize) -> Blocks<M::Scalar> {
    let mut states = Blocks::for_states::<N, M>(count);
    for state in 0..count {
        (0..states.width()).for_each(|place| states.set(state, place, M::Scalar::from_f64(number(state, place))));
    }
    states
}

/// Positions, speeds and forces of a state, of arrays of a motion.
fn parts<M: Motion>(state: usize) -> (M::Positions, M::Speeds, M::Forces) {
    let (positions, speeds) = (M::INFO.positions.len(), M::INFO.speeds.len());
    let of = |from: usize| move |place: usize| M::Scalar::from_f64(number(state, from + place));
    (M::Positions::from_fn(of(0)), M::Speeds::from_fn(of(positions)), M::Forces::from_fn(of(positions + speeds)))
}

fn check_equations<const N: usize, M: Nonlinear<N, Scalar: InLanes>>(designs: &[M]) {
    let bits = |numbers: &[M::Scalar]| -> Vec<u64> { numbers.iter().map(|x| x.to_f64().to_bits()).collect() };
    for batch in Batch::levels() {
        for (count, of_one) in [(0, false), (1, false), (9, false), (STATES, false), (STATES, true)] {
            let designs = if of_one { &designs[3..4] } else { &designs[..count] };
            let (parameters, states) = (Blocks::of_designs(designs), states::<N, M>(count));
            let mut accelerations = Blocks::for_accelerations::<N, M>(count);
            let mut derivatives = Blocks::for_motion_derivatives::<N, M>(count);
            batch.accelerations::<N, M>(&parameters, &states, &mut accelerations).unwrap();
            batch.motion_derivatives::<N, M>(&parameters, &states, &mut derivatives).unwrap();
            for state in 0..count {
                let motion = designs[if of_one { 0 } else { state }].motion();
                let (q, u, f) = parts::<M::Motion>(state);
                let row = |of: &Blocks<M::Scalar>| (0..of.width()).map(|i| of.get(state, i)).collect::<Vec<_>>();
                let expected = motion.accelerations_unchecked(&q, &u, &f);
                assert_eq!(bits(&row(&accelerations)), bits(expected.as_ref()), "{}, {batch}", M::INFO.name);
                let (rates, speeds) = motion.derivatives_unchecked(&q, &u, &f);
                let expected = [rates.as_ref(), speeds.as_ref()].concat();
                assert_eq!(bits(&row(&derivatives)), bits(&expected), "{}, {batch}", M::INFO.name);
            }
        }
    }
}

#[test]
fn equations_are_computed_in_lanes_as_alone() {
    check_equations::<2, WhippleMechanism>(&some());
    check_equations::<2, WhippleMechanism<f32>>(&some());
    check_equations::<2, DoublePendulum>(&some());
    check_equations::<_, RollingDisc<f32>>(&some());
}

/// Bicycles that begin upright at some speed with rates of lean and steer, some of which fall.
fn rides<T: InLanes>(designs: &[WhippleMechanism<T>]) -> Blocks<T> {
    let mut states = Blocks::for_states::<2, WhippleMechanism<T>>(designs.len());
    for (ride, design) in designs.iter().enumerate() {
        let speed = 2.0 + 0.15 * ride as f64;
        states.set(ride, 8, T::from_f64(number(ride, 0)));
        states.set(ride, 9, T::from_f64(number(ride, 1)));
        states.set(ride, 10, T::from_f64(-speed / design.rR.to_f64()));
        states.set(ride, 11, T::from_f64(if ride % 3 == 0 { 2.0 } else { 0.0 }));
    }
    states
}

/// Lean and steer.
const LIMITS: [Limit; 2] = [Limit { position: 3, low: -0.7, high: 0.7 }, Limit { position: 5, low: -1.3, high: 1.3 }];

fn simulated<T: InLanes>(
    batch: Batch,
    tolerance: f64,
    designs: &[WhippleMechanism<T>],
    mut states: Blocks<T>,
) -> (Blocks<T>, Vec<Outcome>) {
    let ensemble = Ensemble { duration: 3.0, tolerance, limits: &LIMITS };
    let mut outcomes = vec![Ok(Arrival::Reached); states.len()];
    let parameters = Blocks::of_designs(designs);
    batch.simulate::<2, WhippleMechanism<T>>(&ensemble, &parameters, &mut states, &mut outcomes).unwrap();
    (states, outcomes)
}

fn are_alone_what_they_are_together<T: InLanes>(tolerance: f64) {
    // More than twice as many as there are lanes in the widest registers of `f64`.
    let designs: Vec<WhippleMechanism<T>> = some::<2, WhippleMechanism<T>>().into_iter().step_by(2).collect();
    let (states, outcomes) = simulated(Batch::new(), tolerance, &designs, rides(&designs));
    for batch in Batch::levels() {
        assert_eq!(
            simulated(batch, tolerance, &designs, rides(&designs)),
            (states.clone(), outcomes.clone()),
            "{batch}"
        );
    }
    let all = rides(&designs);
    for ride in 0..designs.len() {
        let mut one = Blocks::for_states::<2, WhippleMechanism<T>>(1);
        (0..one.width()).for_each(|place| one.set(0, place, all.get(ride, place)));
        let (one, outcome) = simulated(Batch::new(), tolerance, &designs[ride..=ride], one);
        assert_eq!(outcome[0], outcomes[ride]);
        (0..one.width()).for_each(|place| assert_eq!(one.get(0, place), states.get(ride, place)));
    }
    let (mut states_of_all_cores, mut found) = (all, vec![Ok(Arrival::Reached); designs.len()]);
    let ensemble = Ensemble { duration: 3.0, tolerance, limits: &LIMITS };
    let parameters = Blocks::of_designs(&designs);
    let batch = Batch::new();
    batch
        .parallel_simulate::<2, WhippleMechanism<T>>(&ensemble, &parameters, &mut states_of_all_cores, &mut found)
        .unwrap();
    assert_eq!((states_of_all_cores, found), (states, outcomes));
}

#[test]
fn motions_are_alone_what_they_are_together() {
    are_alone_what_they_are_together::<f64>(1e-8);
    are_alone_what_they_are_together::<f32>(1e-5);
}

/// The method of order 8 with its polynomials, of the crate `ivp`, at a tolerance of 1e-12, and its search for events.
#[test]
fn motions_are_those_of_another_method() {
    let designs: Vec<WhippleMechanism> = some();
    let (begin, (ends, outcomes)) = (rides(&designs), simulated(Batch::new(), 1e-11, &designs, rides(&designs)));
    let mut left = [0, 0];
    for (ride, design) in designs.iter().enumerate() {
        let motion = design.motion();
        let speeds = [8, 9, 10].map(|place| begin.get(ride, place));
        let start = State { speeds: speeds.to_vec(), ..State::new(&motion, &[], &[]).unwrap() };
        let mut simulation = Simulation::new(&motion);
        let names = ["lean", "steer"];
        for (name, Limit { position, high, .. }) in names.into_iter().zip(LIMITS) {
            simulation = simulation.until(name, move |moment| moment.positions[position].abs() - high);
        }
        let torque = begin.get(ride, 11);
        let force = carvallo::simulation::Force::constant(torque);
        let found = simulation.force("Tphi", force).unwrap().run(&start, &[0.0, 3.0]).unwrap();
        let last = found.rows.last().unwrap();
        match (&found.end, outcomes[ride].unwrap()) {
            (End::Reached, Arrival::Reached) => {}
            (End::Event { name, time }, Arrival::Left { limit, time: when }) => {
                assert_eq!(names[limit], name);
                assert!((time - when).abs() < 1e-8, "{ride}: {time} {when}");
                left[limit] += 1;
            }
            ends => panic!("{ride}: {ends:?}"),
        }
        for (place, expected) in last.positions.iter().enumerate() {
            let off = (ends.get(ride, place) - expected).abs();
            assert!(off < 1e-7 * expected.abs().max(1.0), "{ride}, {place}: {off:e}");
        }
        assert_eq!(ends.get(ride, 11), torque);
    }
    assert!(left.iter().all(|count| *count > 0) && left.iter().sum::<usize>() < STATES, "{left:?}");
}

#[test]
fn what_has_no_motion_says_so_and_leaves_the_others_alone() {
    let designs = vec![WhippleMechanism::BENCHMARK; 4];
    let mut states = rides(&designs);
    states.set(1, 3, f64::NAN);
    states.set(2, 3, 0.8);
    let (ends, outcomes) = simulated(Batch::new(), 1e-8, &designs, states);
    let (_, others) = simulated(Batch::new(), 1e-8, &designs, rides(&designs));
    assert!(matches!(outcomes[1], Err(MotionError::NotFinite { name: "phi", .. })), "{:?}", outcomes[1]);
    assert_eq!(outcomes[2], Ok(Arrival::Left { limit: 0, time: 0.0 }));
    assert_eq!([outcomes[0], outcomes[3]], [others[0], others[3]]);
    assert_eq!(ends.get(2, 3), 0.8);
}

#[test]
fn what_is_no_ensemble_says_so() {
    let designs = vec![WhippleMechanism::BENCHMARK; 3];
    let parameters = Blocks::of_designs(&designs);
    let run = |ensemble: Ensemble, count: usize| {
        let mut outcomes = vec![Ok(Arrival::Reached); count];
        let mut states = Blocks::for_states::<2, WhippleMechanism>(count);
        Batch::new().simulate::<2, WhippleMechanism>(&ensemble, &parameters, &mut states, &mut outcomes)
    };
    let usual = Ensemble { duration: 1.0, tolerance: 1e-8, limits: &[] };
    let message = |found: Result<(), BatchError>| found.unwrap_err().to_string();
    assert_eq!(
        message(run(usual, 7)),
        "parameters of 3 designs are given for 7 states: expected those of one design, or as many as there are states"
    );
    let endless = Ensemble { duration: f64::INFINITY, ..usual };
    assert_eq!(message(run(endless, 3)), "the duration in s is inf: expected a positive number");
    let exact = Ensemble { tolerance: 0.0, ..usual };
    assert_eq!(message(run(exact, 3)), "the tolerance is 0: expected a positive number");
    let limits = [Limit::symmetric(8, 1.0)];
    let nowhere = Ensemble { limits: &limits, ..usual };
    assert_eq!(message(run(nowhere, 3)), "the position of a limit is 8: expected the place of one of the positions");
    let limits = [Limit::symmetric(3, -1.0)];
    let reversed = Ensemble { limits: &limits, ..usual };
    assert_eq!(message(run(reversed, 3)), "the lower end of a limit is 1: expected a number below its upper end");
}
