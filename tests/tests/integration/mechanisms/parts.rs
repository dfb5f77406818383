//! Rotors, links and forward motion in mechanisms, against closed forms and against parts that are the same.

use carvallo::{Coefficients, States};
use carvallo_compiler::compile;
use nalgebra::{Matrix2, SMatrix};

use super::interpreted;

fn matrices<const N: usize>(declaration: &str, values: &[f64]) -> Coefficients<f64, N> {
    let compiled = compile(declaration.parse().expect("tokens")).unwrap_or_else(|error| panic!("{error}"));
    interpreted(&compiled, values)
}

fn assert_close<const N: usize>(found: &SMatrix<f64, N, N>, expected: &SMatrix<f64, N, N>) {
    assert!((found - expected).norm() <= 1e-12 * expected.norm().max(1.0), "{found} is not {expected}");
}

/// A wheel that rolls at a speed turns with it: at one speed it is a wheel that does not, and a rotor of the same momentum.
#[test]
fn a_rotor_is_what_makes_a_wheel_resist() {
    let bicycle = |axial: &str, momentum: &str| {
        format!(
            "model Bicycle {{
                parameters {{ A: kg*m^2; H: N*m*s; lam: rad; g: N/kg, gravity; }}
                mechanism {{
                    body B: mass 85 [kg], at (0.3 [m], 0, -0.9 [m]), inertia [9.2 [kg*m^2], 11 [kg*m^2], 2.8 [kg*m^2]];
                    body H: mass 4 [kg], at (0.9 [m], 0, -0.7 [m]), inertia 0 {momentum};
                    wheel R on B: mass 2 [kg], at (0, 0, -0.3 [m]), radius 0.3 [m], axial 0, radial 0;
                    wheel F on H: mass 3 [kg], at (1 [m], 0, -0.35 [m]), radius 0.35 [m], axial {axial}, radial 0;
                    free B: lean phi;
                    revolute delta: B to H, through (1.1 [m], 0, 0), along (sin(lam), 0, cos(lam));
                }}
                coordinates {{ phi: rad; delta: rad; }}
            }}"
        )
    };
    let (inertia, speed, radius) = (0.28, 7.0, 0.35);
    let momentum = inertia * speed / radius;
    let rolling = bicycle("A", "").replace("H: N*m*s;", "");
    let rolling = matrices::<2>(&rolling, &[inertia, 0.3, 9.81]);
    // Rolling forward turns it about -y.
    let turning = bicycle("0", ", momentum (0, -H, 0)").replace("A: kg*m^2;", "");
    let turning = matrices::<2>(&turning, &[momentum, 0.3, 9.81]);
    assert!(turning.c0.norm() > 1.0 && turning.k1.norm() > 1.0, "{turning:?}");
    let [rolling, turning] = [rolling, turning].map(|matrices| matrices.at(speed, 9.81).expect("a regular system"));
    // The rotor is no mass that the wheel would have to speed up, which is no matter of lean and steer.
    assert_close(&rolling.m, &turning.m);
    assert_close(&rolling.c, &turning.c);
    assert_close(&rolling.k, &turning.k);
}

/// Two pendulums side by side, joined by a spring and a damper at a height: `k h²` against each other; of an inclined link the
/// part along it, squared.
#[test]
fn a_link_joins_two_bodies() {
    let pendulums = |to: &str| {
        format!(
            "model Pendulums {{
                parameters {{ m: kg, > 0; l: m, > 0; h: m, > 0; k: N/m; d: N*s/m; g: N/kg, gravity; }}
                mechanism {{
                    body A: mass m, at (0, 0, l), inertia 0;
                    body B: mass m, at (0, 1 [m], l), inertia 0;
                    revolute a: ground to A, through (0, 0, 0), along (1, 0, 0);
                    revolute b: ground to B, through (0, 1 [m], 0), along (1, 0, 0);
                    link S: A to B, from (0, 0, h), to {to}, spring k, damper d;
                }}
                coordinates {{ a: rad; b: rad; }}
            }}"
        )
    };
    let values = [2.0, 0.8, 0.5, 30.0, 4.0, 9.81];
    let level = matrices::<2>(&pendulums("(0, 1 [m], h)"), &values);
    let against = Matrix2::new(1.0, -1.0, -1.0, 1.0) * 0.25;
    assert_close(&level.kc, &(against * 30.0));
    assert_close(&level.c0, &(against * 4.0));
    // Both turn to -y below their hinges. With the end of the second one as much lower as it is apart: 45 degrees.
    let inclined = matrices::<2>(&pendulums("(0, 1 [m], h + 1 [m])"), &values);
    let grows = nalgebra::Vector2::new(0.5, -1.5) * 0.5_f64.sqrt();
    assert_close(&inclined.kc, &(grows * grows.transpose() * 30.0));
    // To the ground only one end moves.
    let held = matrices::<2>(&pendulums("(0, 1 [m], h)").replace("A to B", "A to ground"), &values);
    assert_close(&held.kc, &(Matrix2::new(1.0, 0.0, 0.0, 0.0) * 0.25 * 30.0));
}

/// A pendulum on two wheels that roll: about its axle, with the displacement X of that,
/// `(m + w + J/r²) X'' - m l theta'' = -T/r` and `(I + m l²) theta'' - m l X'' - m g l theta = T`; the coordinate of the
/// mechanism is that of the point on the ground, X + r theta.
#[test]
fn forward_motion_takes_part_as_a_coordinate() {
    let found = matrices::<3>(
        "model Segway {
            parameters { m: kg; l: m; I: kg*m^2; w: kg; J: kg*m^2; r: m, > 0; g: N/kg, gravity; }
            mechanism {
                body B: mass m, at (0, 0, -r - l), inertia [I, I, I];
                wheel L on B: mass w/2, at (0, -0.3 [m], -r), radius r, axial J/2, radial 0;
                wheel R on B: mass w/2, at (0, 0.3 [m], -r), radius r, axial J/2, radial 0;
                free B: forward x, pitch theta, yaw psi;
                force T on L;
            }
            coordinates { x: m; theta: rad; psi: rad; }
        }",
        &[60.0, 0.9, 5.0, 8.0, 0.2, 0.25, 9.81],
    );
    let [m, l, i, w, j, r] = [60.0, 0.9, 5.0, 8.0, 0.2, 0.25];
    let about_axle = Matrix2::new(m + w + j / (r * r), -m * l, -m * l, i + m * l * l);
    let to_axle = Matrix2::new(1.0, -r, 0.0, 1.0);
    // The yaw, in which it moves as well, is on its own.
    let block = |matrix: SMatrix<f64, 3, 3>| {
        assert_eq!([matrix[(0, 2)], matrix[(1, 2)], matrix[(2, 0)], matrix[(2, 1)]], [0.0; 4]);
        matrix.fixed_view::<2, 2>(0, 0).into_owned()
    };
    assert_close(&block(found.m), &(to_axle.transpose() * about_axle * to_axle));
    assert_close(&block(found.k0), &Matrix2::new(0.0, 0.0, 0.0, -m * l));
    assert_eq!([found.c0, found.c1, found.kc, found.k1, found.k2].map(block), [Matrix2::zeros(); 5]);
    assert_eq!(found.states[..2], [States::Rate, States::Both]);
}

/// A frame that pitches on a spring speeds the machine up and slows it down; with the speed held it only swings.
#[test]
fn a_held_speed_leaves_the_rest() {
    let found = matrices::<1>(
        "model Nodding {
            parameters { m: kg; k: N*m; g: N/kg, gravity; }
            mechanism {
                body A: mass 10 [kg], at (0, 0, -0.3 [m]), inertia [1 [kg*m^2], 1 [kg*m^2], 1 [kg*m^2]];
                body B: mass m, at (0, 0, -1.3 [m]), inertia 0;
                wheel F on A: mass 0, at (1 [m], 0, -0.3 [m]), radius 0.3 [m], axial 0, radial 0;
                wheel L on A: mass 0, at (-1 [m], -1 [m], -0.3 [m]), radius 0.3 [m], axial 0, radial 0;
                wheel R on A: mass 0, at (-1 [m], 1 [m], -0.3 [m]), radius 0.3 [m], axial 0, radial 0;
                free A;
                revolute q: A to B, through (0, 0, -0.3 [m]), along (0, 1, 0), spring k;
                hold forward;
            }
            coordinates { q: rad; }
        }",
        &[20.0, 500.0, 9.81],
    );
    assert_eq!([found.m[0], found.kc[0], found.k0[0]], [20.0, 500.0, -20.0]);
}

/// A body that hangs on a ball joint, with a rotor in it: about the joint its moments of inertia are in M, and its angular
/// momentum h makes `e · (f x h)` of the rates about axes e and f.
#[test]
fn a_ball_joint_lets_a_body_turn_about_every_axis() {
    let [m, l] = [3.0, 0.7];
    let [xx, yy, zz, xy, xz, yz] = [0.4, 0.5, 0.2, 0.05, -0.03, 0.02];
    let momentum = nalgebra::Vector3::new(0.3, -0.2, 1.5);
    let found = matrices::<3>(
        "model Hanging {
            parameters {
                m: kg, > 0; l: m, > 0; xx: kg*m^2; yy: kg*m^2; zz: kg*m^2; xy: kg*m^2; xz: kg*m^2; yz: kg*m^2;
                hx: N*m*s; hy: N*m*s; hz: N*m*s; k: N*m; d: N*m*s; g: N/kg, gravity;
            }
            mechanism {
                body B: mass m, at (1 [m], 2 [m], 3 [m] + l), inertia [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], momentum (hx, hy, hz);
                ball N: ground to B, through (1 [m], 2 [m], 3 [m]), pitch c, yaw a, spring k, lean b, damper d, spring 2*k;
            }
            coordinates { b: rad; c: rad; a: rad; }
        }",
        &[m, l, xx, yy, zz, xy, xz, yz, momentum.x, momentum.y, momentum.z, 8.0, 0.5, 9.81],
    );
    let steiner = m * l * l;
    let inertia = nalgebra::Matrix3::new(xx + steiner, xy, xz, xy, yy + steiner, yz, xz, yz, zz);
    assert_close(&found.m, &inertia);
    let gyroscopic = -momentum.cross_matrix();
    let damping = nalgebra::Matrix3::from_diagonal(&nalgebra::Vector3::new(0.5, 0.0, 0.0));
    assert_close(&found.c0, &(gyroscopic + damping));
    let diagonal = |x, y, z| nalgebra::Matrix3::from_diagonal(&nalgebra::Vector3::new(x, y, z));
    assert_close(&found.kc, &diagonal(16.0, 0.0, 8.0));
    assert_close(&found.k0, &diagonal(m * l, m * l, 0.0));
}

/// Bounce and pitch of a car body on two springs, of the textbooks: `(kf + kr) w + (a kf - b kr) c` and
/// `(a kf - b kr) w + (a² kf + b² kr) c`, with c about the normal of x and z, so with the front down.
#[test]
fn a_planar_body_slides_two_ways_and_turns() {
    let [m, i, a, b, kf, kr, k] = [900.0, 1100.0, 1.2, 1.5, 3e4, 2.5e4, 4e3];
    let found = matrices::<3>(
        "model Bouncing {
            parameters { m: kg, > 0; I: kg*m^2, > 0; a: m; b: m; kf: N/m; kr: N/m; k: N/m; }
            mechanism {
                body B: mass m, at (0, 0, -1 [m]), inertia [0, I, 0];
                planar P: ground to B, through (0, 0, -1 [m]), slides u along (2, 0, 0), spring k, slides w along (0, 0, 1), turns c;
                link F: ground to B, from (a, 0, 0), to (a, 0, -1 [m]), spring kf;
                link R: ground to B, from (-b, 0, 0), to (-b, 0, -1 [m]), spring kr;
            }
            coordinates { u: m; w: m; c: rad; }
        }",
        &[m, i, a, b, kf, kr, k],
    );
    assert_close(&found.m, &nalgebra::Matrix3::from_diagonal(&nalgebra::Vector3::new(m, m, i)));
    let coupled = a * kf - b * kr;
    let expected = nalgebra::Matrix3::new(k, 0.0, 0.0, 0.0, kf + kr, coupled, 0.0, coupled, a * a * kf + b * b * kr);
    assert_close(&found.kc, &expected);
}
