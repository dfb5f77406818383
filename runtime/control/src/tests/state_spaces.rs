//! State spaces with inputs and outputs.

use super::{assert_rows, benchmark, design, state_space};
use crate::{Ports, StateSpace};

/// Rows of A and B of the benchmark at 5 m/s: numpy, of the matrices that Meijaard et al. (2007) print with 14 decimals, which
/// leaves an error of [`PRINTED`].
const LEAN: [&[f64]; 2] = [
    &[9.489774446773556, -22.85146662520648, -0.527612249028441, -1.6525769949615603],
    &[0.015934978917913466, -0.12409202541157413],
];
const STEER: [&[f64]; 2] = [
    &[11.719476871963272, -18.38412373175199, 18.384026166607164, -15.424327637165348],
    &[-0.12409202541157413, 4.323840180804228],
];

const PRINTED: f64 = 1e-13;

#[test]
fn states_are_positions_then_rates() {
    let bicycle = benchmark();
    let ports = Ports::of(&bicycle);
    let space = StateSpace::new(&bicycle, 5.0, &ports.all_inputs(), &ports.states()).expect("a state space");
    assert_rows(&space.a, &[&[0.0, 0.0, 1.0, 0.0], &[0.0, 0.0, 0.0, 1.0], LEAN[0], STEER[0]], PRINTED);
    assert_rows(&space.b, &[&[0.0; 2], &[0.0; 2], LEAN[1], STEER[1]], PRINTED);
    assert!(space.c.is_identity(0.0) && space.c.is_square() && space.d.iter().all(|entry| *entry == 0.0));
    let names = |signals: &[crate::Signal]| -> Vec<String> {
        signals.iter().map(|signal| format!("{}, {}, {}", signal.name, signal.label, signal.unit)).collect()
    };
    assert_eq!(names(&space.inputs), ["Tphi, lean torque, N*m", "Tdelta, steer torque, N*m"]);
    let states = ["phi, lean, rad", "delta, steer, rad", "phi_rate, lean rate, rad/s", "delta_rate, steer rate, rad/s"];
    assert_eq!(
        (names(&space.states), names(&space.outputs)),
        (states.map(str::to_owned).to_vec(), names(&space.states))
    );
}

/// The yaw rate is (v delta + c delta') cos(lambda) / w, and the lateral velocity v psi (ibid., eq. B.1 and B.2).
#[test]
fn outputs_may_be_accelerations_and_what_follows_from_lean_and_steer() {
    let bicycle = benchmark();
    let yaw_rate = [0.0, 4.66204174654487, 0.0, 0.07459266794471793];
    let space = state_space(&bicycle, 5.0, &["Tphi", "steer"], &["yaw rate", "lean_acceleration", "psi''", "y_ddot"]);
    assert_eq!(space.states.len(), 4, "no integral is needed");
    let yaw_acceleration = [0.8741870467961579, -1.371320836977185, 1.371313559332734, 3.5114999968352594];
    assert_rows(&space.c, &[&yaw_rate, LEAN[0], &yaw_acceleration, &yaw_rate.map(|entry| 5.0 * entry)], PRINTED);
    assert_rows(&space.d, &[&[0.0; 2], LEAN[1], &[-0.00925635524611305, 0.32252677485275894], &[0.0; 2]], PRINTED);
}

#[test]
fn integrals_are_states_where_an_output_asks_for_them() {
    let bicycle = benchmark();
    let yaw_rate = [0.0, 4.66204174654487, 0.0, 0.07459266794471793];
    let headed = state_space(&bicycle, 5.0, &["Tdelta"], &["psi", "y_rate"]);
    assert_eq!(headed.states[4].name, "psi");
    assert_rows(&headed.c, &[&[0.0, 0.0, 0.0, 0.0, 1.0], &[0.0, 0.0, 0.0, 0.0, 5.0]], 0.0);
    let extended: Vec<f64> = yaw_rate.into_iter().chain([0.0]).collect();
    assert_rows(&headed.a.rows(4, 1).into_owned(), &[&extended], 1e-14);
    let placed = state_space(&bicycle, 5.0, &["Tdelta"], &["y"]);
    assert_eq!(placed.states.iter().map(|state| state.name.as_str()).collect::<Vec<_>>()[4..], ["psi", "y"]);
    assert_rows(&placed.a.rows(5, 1).into_owned(), &[&[0.0, 0.0, 0.0, 0.0, 5.0, 0.0]], 0.0);
    assert_rows(&placed.c, &[&[0.0, 0.0, 0.0, 0.0, 0.0, 1.0]], 0.0);
}

/// m y'' + (Cf + Cr)/v y' + ((a Cf - b Cr)/v + m v) psi' = F, and I psi'' the like, by hand: 46000, 28500 - 27930 = 570, and
/// 25000 · 1.2996 + 21000 · 1.7689 = 69636.9 over v, at 20 m/s.
#[test]
fn a_car_has_rates_for_states() {
    let car = design("Car", "oversteering");
    let space = state_space(&car, 20.0, &["Fy", "yaw torque"], &["y_rate", "psi_rate", "y_acceleration"]);
    let lateral: [f64; 2] = [-46000.0 / 20.0 / 1400.0, -(570.0 / 20.0 + 28000.0) / 1400.0];
    let yaw: [f64; 2] = [-570.0 / 20.0 / 2420.0, -69636.9 / 20.0 / 2420.0];
    assert_rows(&space.a, &[&lateral, &yaw], 1e-14);
    assert_rows(&space.b, &[&[1.0 / 1400.0, 0.0], &[0.0, 1.0 / 2420.0]], 1e-14);
    assert_rows(&space.c, &[&[1.0, 0.0], &[0.0, 1.0], &lateral], 1e-14);
    let turned = state_space(&car, 20.0, &["Tpsi"], &["psi"]);
    assert_rows(&turned.a, &[&[lateral[0], lateral[1], 0.0], &[yaw[0], yaw[1], 0.0], &[0.0, 1.0, 0.0]], 1e-14);
}

/// y' = v psi + f of the constraint, and (I + m a²) psi'' = T - m a v psi' - k l² psi - k l y: 2.3, 2.5 v, 1.5 and 1.5.
#[test]
fn a_towed_wheel_has_a_place_of_first_order() {
    let wheel = design("TowedWheel", "example");
    let space = state_space(&wheel, 2.0, &["Tpsi"], &["y", "y_rate", "y_acceleration"]);
    let states: Vec<&str> = space.states.iter().map(|state| state.name.as_str()).collect();
    assert_eq!(states, ["psi", "y", "psi_rate"]);
    let yaw = [-1.5, -1.5, -5.0].map(|entry| entry / 2.3);
    assert_rows(&space.a, &[&[0.0, 0.0, 1.0], &[2.0, 0.0, 0.0], &yaw], 1e-14);
    assert_rows(&space.c, &[&[0.0, 1.0, 0.0], &[2.0, 0.0, 0.0], &[0.0, 0.0, 2.0]], 0.0);
    let ports = Ports::of(&wheel);
    let inputs = ports.all_inputs();
    let rate = StateSpace::new(&wheel, 2.0, &inputs, &[ports.output("y'").unwrap()]).expect("a state space");
    assert_rows(&rate.d, &[&[0.0, 1.0]], 0.0);
    let failure = StateSpace::new(&wheel, 2.0, &inputs, &[ports.output("y''").unwrap()]).unwrap_err();
    assert_eq!(
        failure.to_string(),
        "TowedWheel example at 2 m/s: `y_acceleration` follows the inputs with their derivatives, since `y` is of first order; \
         it can be no output of a state space"
    );
}

#[test]
fn unknown_names_are_told_with_those_that_there_are() {
    let ports = Ports::of(&benchmark());
    assert_eq!(
        ports.input("Tdelt").unwrap_err(),
        "`Tdelt` is no input of Whipple; did you mean `Tdelta`?\nthey are Tphi, Tdelta"
    );
    assert_eq!(
        ports.output("rolling").unwrap_err(),
        "`rolling` is no output of Whipple\nthey are phi, delta, psi, y, phi_rate, delta_rate, psi_rate, y_rate, \
         phi_acceleration, delta_acceleration, psi_acceleration, y_acceleration"
    );
}
