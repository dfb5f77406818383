//! Nonlinear motions of mechanisms with one wrong attribute: accelerations are those of dynamics that share no code, and `carvallo
//! check` names the attribute.

use carvallo::ModelInfo;
use carvallo_check::check_machine;
use carvallo_check::given::{Accelerations, Given, Reading};
use carvallo_check::machine::Machine;
use carvallo_models::{DoublePendulum, RollingDisc, Whipple, WhippleMechanism};
use carvallo_slips::Subject;
use carvallo_tests::multibody::bicycle::{Bicycle, Extras};
use carvallo_tests::multibody::dynamics::Drive;
use carvallo_tests::multibody::{Body, Joint, Mechanism, Root, Wheel};
use nalgebra::{Matrix3, Vector3};

use super::wrong_attributes::scale;

/// A state of two coordinates and forces on them, with the speed.
#[derive(Clone, Copy)]
struct State {
    speed: f64,
    positions: [f64; 2],
    rates: [f64; 2],
    forces: [f64; 2],
}

/// Far from upright.
const STATES: [State; 2] = [
    State { speed: 4.2, positions: [0.3, -0.4], rates: [-0.5, 0.7], forces: [0.0, 3.0] },
    State { speed: 6.5, positions: [-0.2, 0.25], rates: [0.9, -0.3], forces: [12.0, 0.0] },
];

fn given(State { speed, positions, rates, forces }: State) -> Accelerations {
    let [positions, rates, forces] = [positions, rates, forces].map(|own| own.to_vec());
    Accelerations { equations: None, speed, positions, rates, forces, values: Vec::new() }
}

/// The benchmark bicycle on level ground, with something about its mechanism changed.
fn bicycle(State { speed, positions, rates, forces }: State, change: &dyn Fn(&mut Mechanism, usize)) -> [f64; 2] {
    let Bicycle { mut mechanism, root, steer, rear_wheel, .. } = Bicycle::new(&Whipple::BENCHMARK, &Extras::default());
    change(&mut mechanism, steer);
    let drive = Drive { gravity: Whipple::<f64>::BENCHMARK.g, ..Drive::new([root.lean, steer, rear_wheel], None) };
    let spin = -speed / mechanism.contacts[0].radius;
    let state = [[positions[0], positions[1], 0.0], [rates[0], rates[1], spin]];
    let found = mechanism.accelerations(&drive, state, [forces[0], forces[1], 0.0]);
    [found[0], found[1]]
}

/// Every attribute, a tenth larger: also where that wheel is no longer on the ground as it is declared, so that the bicycle pitches.
#[test]
fn the_accelerations_with_any_other_attribute_are_those_of_that_bicycle() {
    let parameters = WhippleMechanism::<f64>::BENCHMARK.to_array();
    let machine = Machine::with(WhippleMechanism::<f64>::INFO, &parameters).expect("formulas that can be read");
    let motion = machine.motion.as_ref().expect("nonlinear equations");
    let mut attributes = 0;
    for (at, formula) in machine.formulas.formulas.iter().enumerate() {
        let Subject::Attribute(what) = formula.subject else { continue };
        let changed = machine.formulas.parse(at, &format!("1.1*({})", formula.text)).expect("a formula");
        let mut values = machine.values.clone();
        machine.formulas.change(&[at], &changed, &parameters, &mut values);
        for state in STATES {
            let found = motion.with_attributes(&given(state), &machine.attributes(&values), &parameters, &[]);
            let found = found.expect("accelerations");
            let expected = bicycle(state, &|mechanism, steer| scale(mechanism, steer, what, 1.1));
            let largest = expected.iter().fold(1.0, |largest: f64, value| largest.max(value.abs()));
            let is_same = found.iter().zip(&expected).all(|(a, b)| (a - b).abs() <= 1e-10 * largest);
            assert!(is_same, "{what}: {found:?}, not {expected:?}");
        }
        attributes += 1;
    }
    assert_eq!(attributes, 28);
}

/// Whether a check of accelerations in both states, with nine digits, tells in its first group that this is the cause.
#[track_caller]
fn assert_named(
    (info, parameters): (&'static ModelInfo, &[f64]),
    states: [State; 2],
    found: &dyn Fn(State) -> [f64; 2],
    cause: &str,
) {
    let own = |state: State| {
        let values = found(state).map(|value| Some(Reading::rounded(value, 9))).to_vec();
        Accelerations { values, ..given(state) }
    };
    let given = Given { accelerations: states.map(own).to_vec(), ..Given::default() };
    let machine = Machine::with(info, parameters).expect("formulas that can be read");
    let report = check_machine(&given, &machine).expect("a check");
    let first = report.explanations.first().unwrap_or_else(|| panic!("nothing explains {cause}:\n{report}"));
    assert!(first.explanations.iter().any(|own| own.causes == [cause]), "{cause} is not first:\n{report}");
}

#[test]
fn a_wrong_attribute_of_the_bicycle_is_named_by_its_accelerations() {
    let parameters = WhippleMechanism::<f64>::BENCHMARK.to_array();
    let Whipple { w, c, lam, IHyy, IRxx, xB, rR, rF, .. } = Whipple::BENCHMARK;
    let named = |cause: &str, change: &dyn Fn(&mut Mechanism, usize)| {
        let found = |state: State| bicycle(state, change);
        assert_named((WhippleMechanism::<f64>::INFO, &parameters), STATES, &found, cause);
        // By the paper's formulas no attribute is known, but these are their nonlinear equations.
        assert_named((Whipple::<f64>::INFO, &Whipple::<f64>::BENCHMARK.to_array()), STATES, &found, cause);
    };
    named("\"w + c\" in x of the point of the joint delta is \"w - c\"", &|own, steer| {
        own.joints[steer].point.x = w - c;
    });
    named("\"sin(lam)\" in x of the axis of the joint delta is \"cos(lam)\"", &|own, steer| {
        own.joints[steer].axis = Vector3::new(lam.cos(), 0.0, lam.cos()).normalize();
    });
    named("\"IRyy\" in the axial inertia of the rear wheel R is \"IRxx\"", &|own, _| {
        own.bodies[2].inertia[(1, 1)] = IRxx
    });
    named("\"xH\" in x of the centre of mass of the front frame H is \"xB\"", &|own, _| own.bodies[1].centre.x = xB);
    // No matrix depends on it.
    named("\"IByy\" in the inertia yy of the rear frame and rider B is \"IHyy\"", &|own, _| {
        own.bodies[0].inertia[(1, 1)] = IHyy
    });
    // The front wheel is too small for the height of its axle: the bicycle pitches until both wheels touch the ground.
    named("\"rF\" in the radius of the front wheel F is \"rR\"", &|own, _| own.contacts[1].radius = rR);
    named("\"-rF\" in z of the centre of the front wheel F is \"-rR\"", &|own, _| {
        own.contacts[1].centre.z = -rR;
        let joint = own.contacts[1].joint;
        (own.joints[joint].point.z, own.bodies[3].centre.z) = (-rR, -rR);
    });
    named("\"rR\" in the radius of the rear wheel R is \"rF\"", &|own, _| own.contacts[0].radius = rF);
}

/// With matrices of the same bicycle beside them.
#[test]
fn a_wrong_attribute_is_named_by_matrices_and_accelerations_together() {
    let parameters = WhippleMechanism::<f64>::BENCHMARK.to_array();
    let Whipple { w, c, .. } = Whipple::BENCHMARK;
    let change = |own: &mut Mechanism, steer: usize| own.joints[steer].point.x = w - c;
    let mut numeric = Bicycle::new(&Whipple::BENCHMARK, &Extras::default());
    change(&mut numeric.mechanism, numeric.steer);
    let matrices = numeric.mechanism.linearized([numeric.root.lean, numeric.steer], Some(numeric.root.x));
    let rows = |matrix: &carvallo::Matrix<f64, 2>| {
        let entry = |row, column| Some(Reading::rounded(matrix[(row, column)], 7));
        (0..2).map(|row| (0..2).map(|column| entry(row, column)).collect()).collect()
    };
    let own = |state: State| {
        let values = bicycle(state, &change).map(|value| Some(Reading::rounded(value, 7))).to_vec();
        Accelerations { values, ..given(state) }
    };
    let given = Given {
        matrices: vec![(carvallo::MatrixName::M, rows(&matrices.m))],
        accelerations: STATES.map(own).to_vec(),
        ..Given::default()
    };
    for (info, parameters) in
        [(WhippleMechanism::<f64>::INFO, parameters), (Whipple::<f64>::INFO, Whipple::<f64>::BENCHMARK.to_array())]
    {
        let machine = Machine::with(info, &parameters).expect("formulas that can be read");
        let report = check_machine(&given, &machine).expect("a check");
        let cause = "\"w + c\" in x of the point of the joint delta is \"w - c\"";
        assert!(report.explanations[0].explanations.iter().any(|own| own.causes == [cause]), "{report}");
    }
}

/// The radius of the disc alone: it touches the ground by it.
#[test]
fn a_wrong_radius_of_a_disc_is_named_by_its_accelerations() {
    let RollingDisc { r, m, Ia, It, g } = RollingDisc::<f64>::UNIFORM;
    let found = |State { speed, positions, rates, forces: _ }: State| {
        let mut disc = Mechanism::default();
        let Root { yaw, lean, .. } = disc.free_root();
        // Its pitch is the angle of the wheel.
        disc.joints.pop();
        let wheel = Wheel { carrier: lean, x: 0.0, y: 0.0, radius: r, tyre: 0.0, mass: m, axial: Ia, transverse: It };
        let spin = disc.wheel(wheel);
        disc.contacts[0].radius = 2.0 * r;
        let drive = Drive { gravity: g, ..Drive::new([lean, yaw, spin], None) };
        let state = [[positions[0], positions[1], 0.0], [rates[0], rates[1], -speed / (2.0 * r)]];
        let found = disc.accelerations(&drive, state, [0.0; 3]);
        [found[0], found[1]]
    };
    let parameters = RollingDisc::<f64>::UNIFORM.to_array();
    let cause = "\"r\" in the radius of the disc D is \"2*r\"";
    // Nothing acts on it.
    let states = STATES.map(|state| State { forces: [0.0; 2], ..state });
    assert_named((RollingDisc::<f64>::INFO, &parameters), states, &found, cause);
}

/// The upper hinge at the centre of mass of the lower link, and not at its end.
#[test]
fn a_wrong_hinge_of_a_pendulum_is_named_by_its_accelerations() {
    let rods = DoublePendulum::<f64> { a1: 0.4, ..DoublePendulum::RODS };
    let DoublePendulum { l1, a1, m1, I1, a2, m2, I2, g } = rods;
    let found = |State { positions, rates, forces, .. }: State| {
        let mut pendulum = Mechanism::default();
        let lower = pendulum.joint(Joint::revolute(None, Vector3::zeros(), Vector3::x()));
        let upper = pendulum.joint(Joint::revolute(Some(lower), Vector3::new(0.0, 0.0, -a1), Vector3::x()));
        for (joint, mass, z, inertia) in [(lower, m1, -a1, I1), (upper, m2, -l1 - a2, I2)] {
            let inertia = Matrix3::from_diagonal(&Vector3::new(inertia, 0.0, 0.0));
            pendulum.body(Body { joint, mass, centre: Vector3::new(0.0, 0.0, z), inertia });
        }
        let drive = Drive { gravity: g, ..Drive::new([lower, upper], None) };
        pendulum.accelerations(&drive, [positions, rates], forces).into()
    };
    let cause = "\"-l1\" in z of the point of the joint theta2 is \"-a1\"";
    // It does not run.
    let states = STATES.map(|state| State { speed: 0.0, ..state });
    assert_named((DoublePendulum::<f64>::INFO, &rods.to_array()), states, &found, cause);
}
