//! Accelerations of a closed loop that was not declared, from the matrices that are printed in Meijaard, Papadopoulos, Ruina & Schwab
//! (2007), section 5: q'' = A x + M^-1 f, written out here.

mod benchmark;

use benchmark::{M, SPEED, causes, checked, numbers};

/// Accelerations in a state with a steer torque, as a file has them; states are so small that nothing but linear terms is seen.
fn accelerations(equations: &str, state: [f64; 4], torque: f64) -> String {
    let a = numbers(SPEED, |_, _, _| {});
    let determinant = M[0][0] * M[1][1] - M[0][1] * M[1][0];
    let by_torque = [-M[0][1] / determinant, M[0][0] / determinant];
    let sum = |row: usize| (0..4).map(|at| a[2 + row][at] * state[at]).sum::<f64>() + by_torque[row] * torque;
    let [phi, delta, phi_rate, delta_rate] = state;
    format!(
        "{{ equations = \"{equations}\", state = {{ phi = {phi}, delta = {delta}, phi_rate = {phi_rate}, delta_rate = {delta_rate} }}, \
         values = {{ phi = {:.6e}, delta = {:.6e} }} }}",
        sum(0),
        sum(1)
    )
}

const STATES: [[f64; 4]; 3] = [[1e-5, 2e-5, 3e-5, -1e-5], [-2e-5, 1e-5, 2e-5, 3e-5], [3e-5, -1e-5, -2e-5, 2e-5]];

#[test]
fn a_law_that_was_not_declared_is_told_of_accelerations() {
    for equations in ["linear", "nonlinear"] {
        let with = |law: &dyn Fn([f64; 4]) -> f64| {
            let all = STATES.map(|state| accelerations(equations, state, law(state)));
            checked(&format!("speed = {SPEED}\naccelerations = [{}]", all.join(", ")))
        };
        let one = with(&|[_, _, phi_rate, _]| -10.0 * phi_rate);
        assert!(causes(&one)[0].contains("by what --feedback 'Tdelta = -10*phi_rate' declares"), "{one}");
        let two = with(&|[_, delta, phi_rate, _]| -12.0 * phi_rate + 3.0 * delta);
        assert!(causes(&two)[0].contains("--feedback 'Tdelta = 3*delta - 12*phi_rate'"), "{two}");
    }
}

/// A torque that is the same in all states, or in the only one, is named; of one state alone any other cause would be made up.
#[test]
fn a_force_that_was_not_declared_is_told() {
    let one = accelerations("linear", [0.1, 0.02, 0.5, -0.3], 1.5);
    let two = [one.clone(), accelerations("linear", [-0.05, 0.04, 0.2, 0.1], 1.5)].join(", ");
    let told = |all: &str| causes(&checked(&format!("speed = {SPEED}\naccelerations = [{all}]")));
    for all in [&one, &two] {
        assert_eq!(told(all), ["there is a force on delta that is not declared, forces = { delta = 1.5 }"]);
    }
    let with = |force: &str| one.replace("values", &format!("forces = {{ delta = {force} }}, values"));
    assert!(checked(&format!("speed = {SPEED}\naccelerations = [{}]", with("1.5"))).agrees);
    assert_eq!(told(&with("0.7")), ["the force on delta is 1.5 in the place of 0.7"]);
    assert!(told(&with("-1.5")).contains(&"the force on delta has the other sign".to_owned()));
    // A torque of more digits than anybody means is told beside what differs, and nothing is made up.
    let report = checked(&format!(
        "speed = {SPEED}\naccelerations = [{}]",
        accelerations("linear", [0.1, 0.02, 0.5, -0.3], 1.234567)
    ));
    assert!(
        causes(&report).is_empty() && report.to_string().contains("that of delta, by a force of 1.23457"),
        "{report}"
    );
}

/// Basu-Mandal, Chatterjee & Papadopoulos (2007), Table 1: lean and steer, their rates and the spin of the rear wheel, 8.912989661489
/// rad/s, in a state far from upright, and the accelerations of lean and steer without a force. Lean is pi/2 - psi there, steer is -psif.
fn published(speed: &str, forces: &str) -> String {
    format!(
        "accelerations = {{ speed = {speed}, state = {{ phi = \"pi/2 - 0.9501292851472\", phi_rate = -0.6068425835418, \
         delta = -0.2311385135743, delta_rate = -0.4859824687093 }}, {forces} \
         values = {{ phi = 7.8555281128244, delta = 4.6198904039403 }} }}"
    )
}

/// Nothing is said of the equations, and by neither of them these are the accelerations with a force; and those at a speed in km/h.
#[test]
fn the_equations_are_those_by_which_fewer_forces_are_missing() {
    let report = checked(&published("\"8.9129896614890*0.3\"", "forces = { delta = 2 },"));
    assert_eq!(causes(&report), ["the force on delta is left out"], "{report}");
    assert!(report.numbers.iter().all(|own| own.name.ends_with("by the nonlinear equations")), "{report}");
    let report = checked(&published("\"8.9129896614890*0.3*3.6\"", "equations = \"nonlinear\","));
    assert_eq!(causes(&report), ["speeds are in km/h in the place of m/s"], "{report}");
}

/// Torques that follow from no law.
#[test]
fn the_equation_that_is_off_is_told() {
    let torques = [2e-4, 5e-4, 4e-4];
    let all = [0, 1, 2].map(|at| accelerations("linear", STATES[at], torques[at]));
    let report = checked(&format!("speed = {SPEED}\naccelerations = [{}]", all.join(", ")));
    let text = report.to_string();
    assert!(causes(&report).is_empty(), "{text}");
    let start = "in state 1 at 5 m/s that of delta, by a force of ";
    let off = text.lines().find_map(|line| line.trim().strip_prefix(start)).expect(&text);
    let (force, rest) = off.split_once("; ").expect(&text);
    assert!((force.parse::<f64>().expect("a force") - 2e-4).abs() < 2e-8, "{text}");
    assert_eq!(rest, "that of phi holds", "{text}");
}

/// A bicycle that lies flat, and equations with C-1/v at rest.
#[test]
fn where_there_are_none_the_reason_is_told() {
    let flat = "accelerations = { speed = 5, equations = \"nonlinear\", state = { phi = \"pi/2\", delta = 0.1 }, values = { phi = 1, delta = 2 } }";
    let reasons = checked(flat).reasons;
    assert!(
        reasons.len() == 1
            && reasons[0].starts_with("in state 1 at 5 m/s: no position was found in which all wheels touch"),
        "{reasons:?}"
    );
    let report = checked("model = \"CarTrailer\"\nspeed = 0\neigenvalues = [-1.2]");
    assert!(
        report
            .to_string()
            .contains("  None of ours at 0 m/s: the speed is 0 m/s, and the damping C-1/v has no value there"),
        "{report}"
    );
}
