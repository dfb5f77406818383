//! Wheels that slip sideways: machines on tyres whose side force is linear in slip and camber.

use carvallo::{Coefficients, Complex, States};
use carvallo_compiler::compile;

use super::{declaration, interpreted};

/// The motorcycle that ships.
const MOTORCYCLE: &str = include_str!("../../../../generated/models/motorcycle.rs");

/// The matrices of a mechanism whose parameters have these values, with what of its coordinates are states.
fn compiled<const N: usize>(parameters: &[(&str, &str, f64)], rest: &str) -> Coefficients<f64, N> {
    let declared: Vec<String> = parameters.iter().map(|(name, unit, _)| format!("{name}: {unit};")).collect();
    let text = format!("model Vehicle {{ parameters {{ {} }} {rest} }}", declared.join(" "));
    let compiled = compile(text.parse().expect("tokens")).unwrap_or_else(|error| panic!("{error}"));
    let values: Vec<f64> = parameters.iter().map(|(.., value)| *value).collect();
    interpreted(&compiled, &values)
}

/// The matrices of a declaration at its first set.
fn of_first_set<const N: usize>(text: &str) -> Coefficients<f64, N> {
    let compiled = compile(text.parse().expect("tokens")).unwrap_or_else(|error| panic!("{error}"));
    interpreted(&compiled, &compiled.model.sets[0].values)
}

fn eigenvalues<const N: usize>(matrices: &Coefficients<f64, N>, speed: f64, gravity: f64) -> Vec<Complex<f64>> {
    matrices.at(speed, gravity).and_then(|system| system.eigenvalues()).expect("a regular system")
}

const CAR: [(&str, &str, f64); 9] = [
    ("m", "kg, > 0", 1200.0),
    ("I", "kg*m^2, > 0", 1500.0),
    ("a", "m, > 0", 1.1),
    ("b", "m, > 0", 1.5),
    ("t", "m, > 0", 0.7),
    ("r", "m, > 0", 0.3),
    ("Cf", "N, > 0", 70e3),
    ("Cr", "N, > 0", 45e3),
    ("g", "N/kg, gravity", 9.81),
];

/// Three wheels, so that the car stands by itself. About its centre of mass the textbooks have
/// `m (u' + v r) = -(Cf + Cr) u/v - (a Cf - b Cr) r/v` and `I r' = -(a Cf - b Cr) u/v - (a² Cf + b² Cr) r/v`, with the
/// lateral velocity u along the axes of the car and the yaw rate r.
#[test]
fn a_car_is_that_of_the_textbooks() {
    let car: Coefficients<f64, 2> = compiled(
        &CAR,
        "mechanism {
            body B: mass m, at (0, 0, -r), inertia [I, I, I];
            wheel F on B: mass 0, at (a, 0, -r), radius r, axial 0, radial 0, cornering Cf;
            wheel L on B: mass 0, at (-b, -t, -r), radius r, axial 0, radial 0, cornering Cr;
            wheel R on B: mass 0, at (-b, t, -r), radius r, axial 0, radial 0, cornering Cr;
            free B: lateral y, yaw psi;
        }
        coordinates { y: m; psi: rad; }",
    );
    let [m, i, a, b, f] = [1200.0, 1500.0, 1.1, 1.5, 70e3];
    // Of two wheels.
    let r = 2.0 * 45e3;
    let close = |found: nalgebra::Matrix2<f64>, expected: [[f64; 2]; 2]| {
        let expected = nalgebra::Matrix2::from_fn(|row, column| expected[row][column]);
        assert!((found - expected).norm() <= 1e-12 * expected.norm(), "{found} is not {expected}");
    };
    close(car.m, [[m, 0.0], [0.0, i]]);
    close(car.cm1, [[f + r, a * f - b * r], [a * f - b * r, a * a * f + b * b * r]]);
    close(car.c1, [[0.0, m], [0.0, 0.0]]);
    assert_eq!([car.c0, car.kc, car.k0, car.k1, car.k2], [nalgebra::Matrix2::zeros(); 5]);
    assert_eq!(car.states, [States::Rate; 2]);
}

/// The side force of the front wheel acts behind its contact point, and so at another arm than it is made.
#[test]
fn a_pneumatic_trail_shortens_the_arm_of_the_force() {
    let without = CAR.iter().filter(|(name, ..)| *name != "Cr").copied();
    let parameters: Vec<_> = without.chain([("n", "m", 0.04)]).collect();
    let car: Coefficients<f64, 2> = compiled(
        &parameters,
        "mechanism {
            body B: mass m, at (0, 0, -r), inertia [I, I, I];
            wheel F on B: mass 0, at (a, 0, -r), radius r, axial 0, radial 0, cornering Cf, trail n;
            wheel L on B: mass 0, at (-b, -t, -r), radius r, axial 0, radial 0, cornering 1 [N];
            wheel R on B: mass 0, at (-b, t, -r), radius r, axial 0, radial 0, cornering 1 [N];
            free B: lateral y, yaw psi;
        }
        coordinates { y: m; psi: rad; }",
    );
    let (arm, force, rear) = (1.1 - 0.04, 70e3, 2.0);
    let expected =
        [[force + rear, 1.1 * force - 1.5 * rear], [arm * force - 1.5 * rear, arm * 1.1 * force + 1.5 * 1.5 * rear]];
    let expected = nalgebra::Matrix2::from_fn(|row, column| expected[row][column]);
    assert!((car.cm1 - expected).norm() <= 1e-12 * expected.norm(), "{} is not {expected}", car.cm1);
}

/// The nearest of some numbers, and how far it is off, relative to the number.
fn distance(found: &[Complex<f64>], expected: Complex<f64>) -> f64 {
    let distances = found.iter().map(|found| (found - expected).norm() / expected.norm());
    distances.fold(f64::INFINITY, f64::min)
}

/// Over a relaxation length that vanishes the side forces follow at once.
#[test]
fn without_relaxation_is_the_limit_of_short_lengths() {
    let text = declaration(MOTORCYCLE);
    let without = |text: &str, part: &str| {
        assert!(text.contains(part), "{part} is not in the motorcycle");
        text.replacen(part, "", 1)
    };
    // Without the coordinates of the tyres, and the rows and columns of theirs.
    let at_once = [
        ", relaxation sigma, deflection er",
        ", relaxation sigma, deflection ef",
        "sigma \"σ\": m, > 0;",
        "sigma = 0.8*0.3048;",
        "/// Deflection of the rear tyre.\n            er \"rear tyre\": m;",
        "/// Deflection of the front tyre.\n            ef \"front tyre\": m;",
    ];
    let at_once = at_once.iter().fold(text.to_owned(), |text, part| without(&text, part));
    let (before, added) = at_once.split_once("add symmetric K0 = [").expect("what is added");
    let (_, behind) = added.split_once("];\n\n").expect("its end");
    let added = "[[0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, rest*t], [0, 0, rest*t, rest*t*s]]";
    let at_once: Coefficients<f64, 4> = of_first_set(&format!("{before} add symmetric K0 = {added}; {behind}"));
    let short: Coefficients<f64, 6> = of_first_set(&text.replace("sigma = 0.8*0.3048;", "sigma = 1e-7;"));
    for speed in [3.0, 15.0, 50.0] {
        let (expected, found) = (eigenvalues(&at_once, speed, 9.81456), eigenvalues(&short, speed, 9.81456));
        assert_eq!([expected.len(), found.len()], [6, 8]);
        for eigenvalue in expected {
            assert!(distance(&found, eigenvalue) < 1e-4, "{eigenvalue} is not among {found:?}");
        }
    }
}

const BICYCLE: &str = "mechanism {
    body B: mass 85 [kg], at (0.3 [m], 0, -0.9 [m]), inertia [[9.2 [kg*m^2], 0, 2.4 [kg*m^2]], [0, 11 [kg*m^2], 0], [2.4 [kg*m^2], 0, 2.8 [kg*m^2]]];
    body H: mass 4 [kg], at (0.9 [m], 0, -0.7 [m]), inertia [0.06 [kg*m^2], 0.06 [kg*m^2], 0.01 [kg*m^2]];
    wheel R on B: mass 2 [kg], at (0, 0, -0.3 [m]), radius 0.3 [m], tyre 0.02 [m], axial 0.12 [kg*m^2], radial 0.06 [kg*m^2];
    wheel F on H: mass 3 [kg], at (1.02 [m], 0, -0.35 [m]), radius 0.35 [m], tyre 0.03 [m], axial 0.28 [kg*m^2], radial 0.14 [kg*m^2];
    free B: lean phi;
    revolute delta: B to H, through (1.1 [m], 0, 0), along (sin(lam), 0, cos(lam));
}";

/// The stiffer the tyres, the less they slip: the eigenvalues of a bicycle whose wheels roll are the limit.
#[test]
fn rolling_is_the_limit_of_stiff_tyres() {
    let parameters = [("lam", "rad", 0.314), ("C", "N, > 0", 0.0), ("g", "N/kg, gravity", 9.81)];
    let rolling: Coefficients<f64, 2> =
        compiled(&[parameters[0], parameters[2]], &format!("{BICYCLE} coordinates {{ phi: rad; delta: rad; }}"));
    let slipping = BICYCLE.replace("radial 0.06 [kg*m^2];", "radial 0.06 [kg*m^2], cornering C;");
    let slipping = slipping.replace("radial 0.14 [kg*m^2];", "radial 0.14 [kg*m^2], cornering C;");
    let slipping = slipping.replace("free B: lean phi;", "free B: lateral y, yaw psi, lean phi;");
    let coordinates = "coordinates { phi: rad; delta: rad; y: m; psi: rad; }";
    for speed in [1.0, 4.0, 8.0] {
        let expected = eigenvalues(&rolling, speed, 9.81);
        let errors = [1e7, 1e8].map(|stiffness| {
            let parameters = [parameters[0], ("C", "N, > 0", stiffness), parameters[2]];
            let slipping: Coefficients<f64, 4> = compiled(&parameters, &format!("{slipping} {coordinates}"));
            assert_eq!(slipping.states, [States::Both, States::Both, States::Rate, States::Rate]);
            let found = eigenvalues(&slipping, speed, 9.81);
            assert_eq!(found.len(), 6);
            expected.iter().map(|eigenvalue| distance(&found, *eigenvalue)).fold(0.0, f64::max)
        });
        // The distance is of the first order in the compliance.
        assert!(errors[1] < 1e-3 && (errors[0] / errors[1] - 10.0).abs() < 0.5, "{errors:?} at {speed} m/s");
    }
}

/// A tractor with a fork whose axis is `c` before the contact of its wheel, and a trailer whose wheels roll `l` behind the hinge.
const TRAILER: &str = "mechanism {
    body B: mass 900 [kg], at (0, 0, -0.5 [m]), inertia [300 [kg*m^2], 900 [kg*m^2], 1000 [kg*m^2]];
    body H: mass 20 [kg], at (1.3 [m] + c, 0, -0.3 [m]), inertia [1 [kg*m^2], 1 [kg*m^2], 1 [kg*m^2]];
    body P: massless;
    body T: mass 500 [kg], at (-1.4 [m] - l, 0, -0.5 [m]), inertia [100 [kg*m^2], 500 [kg*m^2], 400 [kg*m^2]];
    wheel F on H: mass 0, at (1.3 [m], 0, -0.3 [m]), radius 0.3 [m], axial 0, radial 0;
    wheel L on B: mass 0, at (-1.2 [m], -0.7 [m], -0.3 [m]), radius 0.3 [m], axial 0, radial 0;
    wheel R on B: mass 0, at (-1.2 [m], 0.7 [m], -0.3 [m]), radius 0.3 [m], axial 0, radial 0;
    wheel U on T: mass 0, at (-1.4 [m] - l, 0, -0.3 [m]), radius 0.3 [m], axial 0, radial 0;
    free B;
    revolute delta: B to H, through (1.3 [m] + c, 0, 0), along (0, 0, 1), spring 50 [N*m], damper 90 [N*m*s];
    revolute pitch: B to P, through (-1.4 [m], 0, -0.3 [m]), along (0, 1, 0);
    revolute q: P to T, through (-1.4 [m], 0, 0), along (0, 0, 1), damper d;
}
coordinates { delta: rad; q: rad, only position; }";

fn trailer(trail: f64, damper: f64) -> Coefficients<f64, 2> {
    let parameters = [("l", "m, > 0", 2.5), ("c", "m", trail), ("d", "N*m*s", damper), ("g", "N/kg, gravity", 9.81)];
    compiled(&parameters, TRAILER)
}

/// Where steering itself turns nothing but the fork, the angle of the trailer is on its own: `l q' + v q = 0`.
#[test]
fn a_trailer_goes_on_by_its_own_angle() {
    let found = trailer(0.0, 40.0);
    assert_eq!(found.states, [States::Both, States::Position]);
    for speed in [3.0, 15.0] {
        let found = eigenvalues(&found, speed, 9.81);
        assert_eq!(found.len(), 3);
        assert!(distance(&found, Complex::from(-speed / 2.5)) < 1e-13, "{found:?}");
    }
}

/// With a trail c the yaw rate is `(v delta + c delta')/w`, and the hinge, b behind the rear axle, is drawn sideways by it:
/// `q' = -(1 + b/l) (v delta + c delta')/w - v q/l`. So the damper at the hinge, which rolls, damps the steering and makes
/// stiffness proportional to the speed.
#[test]
fn a_damper_at_a_joint_that_rolls_makes_stiffness_by_the_speed() {
    let (w, b, l, c, d) = (2.5, 0.2, 2.5, 0.1, 40.0);
    let [with, without] = [d, 0.0].map(|damper| trailer(c, damper));
    let by_rate = -(1.0 + b / l) * c / w;
    let by_position = [-(1.0 + b / l) / w, -1.0 / l];
    let close = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-12, "{found} is not {expected}");
    close(with.c0[(1, 0)], -by_rate);
    close(with.c0[(1, 1)], 1.0);
    let [damping, stiffness] = [with.c0 - without.c0, with.k1 - without.k1];
    close(damping[(0, 0)], d * by_rate * by_rate);
    for column in 0..2 {
        close(with.k1[(1, column)], -by_position[column]);
        close(stiffness[(0, column)], d * by_rate * by_position[column]);
    }
}

/// The cornering stiffness of the textbooks' car is `along x` where C is written with 1/v in it, and may be in a mechanism.
#[test]
fn stiffnesses_of_tyres_mirror_as_is_documented() {
    let parameters = |of_c: &str| {
        format!("a: m, > 0, along x; m: kg, > 0; I: kg*m^2, > 0; r: m, > 0; g: N/kg, gravity; C: N{of_c};")
    };
    let formulas = |of_c: &str| {
        let parameters = parameters(of_c).replace("r: m, > 0; g: N/kg, gravity;", "v: m/s, speed;");
        format!(
            "model M {{ parameters {{ {parameters} }} coordinates {{ y: m, along y; psi: rad, about z; }}
                M = [[m, 0], [0, I]]; C = [[2*C/v, m*v], [0, 2*a^2*C/v]]; }}"
        )
    };
    let mechanism = |of_c: &str| {
        let wheel = |name: char, x: &str, y: &str| {
            format!("wheel {name} on B: mass 0, at ({x}, {y}, -r), radius r, axial 0, radial 0, cornering C;")
        };
        let wheels = [wheel('F', "a", "0"), wheel('L', "-a", "-t"), wheel('R', "-a", "t")].concat();
        format!(
            "model M {{ parameters {{ t: m, > 0, along y; {} }}
                mechanism {{ body B: mass m, at (0, 0, -r), inertia [I, I, I]; {wheels} free B: lateral y, yaw psi; }}
                coordinates {{ y: m; psi: rad; }} }}",
            parameters(of_c).replace("r: m, > 0", "r: m, > 0, along z")
        )
    };
    let mistakes = |text: String| match compile(text.parse().expect("tokens")) {
        Ok(_) => Vec::new(),
        Err(errors) => errors.into_iter().map(|error| error.to_string()).collect::<Vec<_>>(),
    };
    assert_eq!(mistakes(formulas(", along x")), [""; 0]);
    assert!(mistakes(formulas("")).iter().any(|mistake| mistake.contains("this entry of `C`")));
    assert_eq!(mistakes(mechanism(", along x")), [""; 0]);
    assert_eq!(mistakes(mechanism("")), [""; 0]);
    assert!(mistakes(mechanism(", along y")).iter().all(|mistake| mistake.contains("the cornering stiffness")));
    assert_eq!(mistakes(mechanism(", along y")).len(), 3);
}
