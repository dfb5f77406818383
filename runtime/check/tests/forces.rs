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
