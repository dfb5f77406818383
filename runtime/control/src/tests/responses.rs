//! Responses in time: of the matrices that `carvallo statespace` prints, by the exponential of mpmath with 40 digits.
//! (python-control 0.10.2 has the same steps to 1e-13.)

use carvallo::simulation::SimulationError;

use super::{benchmark, design, state_space};
use crate::StateSpace;

/// Time, and the outputs after a step, after an impulse, and from a lean rate of 0.5 rad/s.
type Row = (f64, [[f64; 3]; 3]);

const BICYCLE: [Row; 3] = [
    (
        0.1,
        [
            [-0.001719327689143007, 0.012897388122064682, 0.0032507927389347304],
            [-0.04449552873297376, 0.19224760885195852, 0.07446842389671764],
            [0.047079030310417005, 0.02836540515184267, 0.007092760873452265],
        ],
    ),
    (
        0.5,
        [
            [-0.10159927638763946, 0.010749509473709241, 0.05745379995845156],
            [-0.44634914238806933, -0.27101716123855557, 0.029898768805724407],
            [0.08975928206055264, 0.10449836237157073, 0.18192292663279283],
        ],
    ),
    (
        2.0,
        [
            [-0.49697539363603765, -0.19242968185732975, -0.9214740535234947],
            [-0.2514520989556354, -0.1551491265139746, -0.9086881973691892],
            [0.02841829174606995, 0.029522720898934648, 0.23138476272929462],
        ],
    ),
];

const MOTORCYCLE: [Row; 3] = [
    (
        0.1,
        [
            [-0.0005241604351533501, 0.0005851484768232087, 0.009666599519311165],
            [-0.012141906980487607, -0.02584249740292205, -0.07513263154562365],
            [0.03903236942525774, 0.012691450005553225, 0.2776160923598065],
        ],
    ),
    (
        0.5,
        [
            [-0.00887808407980305, 2.3158609746846104e-05, -0.002850548865639937],
            [-0.020100251140061635, 6.765583470902991e-05, -0.011579151457529689],
            [0.03775316872435656, 0.0032253156608432797, 0.04976413873711181],
        ],
    ),
    (
        2.0,
        [
            [-0.042684603189441485, -0.0012251689701236691, -0.019903436471469374],
            [-0.0239398875478909, -0.0008310843444566409, -0.011300285828428075],
            [0.04129251301689117, 0.0014363919802876143, 0.01953923244573647],
        ],
    ),
];

fn hold(space: &StateSpace, expected: &[Row]) {
    let times: Vec<f64> = expected.iter().map(|row| row.0).collect();
    let pushed: Vec<f64> = space.states.iter().map(|state| if state.name == "phi_rate" { 0.5 } else { 0.0 }).collect();
    let found = [
        space.step_response(0, 1.0, &times),
        space.impulse_response(0, 1.0, &times),
        space.respond(&pushed, &[0.0], &times),
    ];
    for (kind, response) in found.into_iter().enumerate() {
        let response = response.expect("a response");
        for (values, (time, expected)) in response.outputs.iter().zip(expected) {
            for (found, expected) in values.iter().zip(expected[kind]) {
                // Of what the outputs are at other times, 0.5 and less.
                assert!((found - expected).abs() < 1e-14, "{kind} at {time}: {found} is not {expected}");
            }
        }
    }
}

#[test]
fn steps_impulses_and_pushes_are_exact() {
    hold(&state_space(&benchmark(), 5.0, &["Tdelta"], &["phi", "delta", "psi"]), &BICYCLE);
    let motorcycle = design("Motorcycle", "standard");
    hold(&state_space(&motorcycle, 20.0, &["Tdelta"], &["phi", "delta", "psi_rate"]), &MOTORCYCLE);
}

/// What an input passes at once is there at time zero, and a step of any size is that many times the step of one.
#[test]
fn what_passes_at_once_is_there_at_once() {
    let space = state_space(&design("Pendulum", "seconds"), 0.0, &["Ttheta"], &["theta", "theta_acceleration"]);
    let passed = space.d[(1, 0)];
    assert!(passed > 0.0);
    let response = space.step_response(0, -3.0, &[0.0, 0.25]).expect("a response");
    assert_eq!(response.outputs[0], [0.0, -3.0 * passed]);
    let one = space.step_response(0, 1.0, &[0.25]).expect("a response");
    assert!((response.outputs[1][0] + 3.0 * one.outputs[0][0]).abs() < 1e-17);
}

#[test]
fn what_cannot_be_is_refused() {
    let space = state_space(&benchmark(), 5.0, &["Tdelta"], &["phi"]);
    let of = |state: &[f64], times: &[f64]| space.respond(state, &[0.0], times).map(|_| ());
    assert_eq!(of(&[0.0; 3], &[]), Err(SimulationError::Length { quantity: "initial states", expected: 4, found: 3 }));
    assert_eq!(of(&[0.0; 4], &[1.0, 0.5]), Err(SimulationError::Unsorted { time: 1.0, next: 0.5 }));
    let infinite = of(&[f64::INFINITY, 0.0, 0.0, 0.0], &[1.0]);
    assert_eq!(infinite, Err(SimulationError::NotFinite { quantity: "initial states", value: f64::INFINITY }));
    let falling = state_space(&benchmark(), 0.0, &["Tdelta"], &["phi"]);
    assert_eq!(
        falling.step_response(0, 1.0, &[1.0, 1000.0]).map(|_| ()),
        Err(SimulationError::OutOfRange { time: 1000.0 })
    );
}
