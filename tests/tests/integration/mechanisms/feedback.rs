//! What is fed back, against the same terms added by hand to matrices that are held against print elsewhere.

#![allow(non_snake_case)] // Names of the field.

use carvallo::{Coefficients, Model, States};
use carvallo_compiler::{Compiled, compile};
use carvallo_models::WhippleSprung;
use nalgebra::{Matrix2, Matrix3, Matrix4, SMatrix, Vector2};

use super::{assert_close, declaration, interpreted};

fn compiled(source: &str) -> Compiled {
    compile(source.parse().expect("tokens")).unwrap_or_else(|error| panic!("{error}"))
}

/// The bicycle with a steering spring and damper, with further parameters and statements, other freedoms and coordinates.
fn bicycle(parameters: &str, statements: &str, free: &str, coordinates: &str) -> Compiled {
    let source = include_str!("../../../../generated/models/whipple_sprung.rs");
    let (model, _sets) = declaration(source).split_once("#[default]").expect("it has sets");
    let replaced = [
        ("d: N*m*s, >= 0;", format!("d: N*m*s, >= 0; {parameters}")),
        ("free B: lean phi;", format!("free B: {free};")),
        ("\"steer\": rad;", format!("\"steer\": rad; {coordinates}")),
        ("derivatives;", statements.to_string()),
    ];
    let source = replaced.iter().fold(model.to_string(), |source, (old, new)| {
        assert!(source.contains(old), "{old}");
        source.replacen(old, new, 1)
    });
    compiled(&format!("{source}}}"))
}

fn values(more: &[f64]) -> Vec<f64> {
    [WhippleSprung::BENCHMARK.to_array().as_slice(), more].concat()
}

/// A matrix with an entry.
fn entry<const N: usize>(row: usize, column: usize, value: f64) -> SMatrix<f64, N, N> {
    SMatrix::from_fn(|i, j| if (i, j) == (row, column) { value } else { 0.0 })
}

/// The bicycle's matrices as the first rows and columns of larger ones.
fn enlarged<const N: usize>(bicycle: &Coefficients<f64, 2>) -> Coefficients<f64, N> {
    let larger = |matrix: &Matrix2<f64>| {
        let mut larger = SMatrix::<f64, N, N>::zeros();
        larger.fixed_view_mut::<2, 2>(0, 0).copy_from(matrix);
        larger
    };
    let Coefficients { m, c0, c1, kc, k0, k2, .. } = bicycle;
    Coefficients {
        m: larger(m),
        c0: larger(c0),
        c1: larger(c1),
        kc: larger(kc),
        k0: larger(k0),
        k2: larger(k2),
        ..Default::default()
    }
}

/// The yaw rate of the bicycle is `(v delta + c delta') cos(lam)/w`: Meijaard, Papadopoulos, Ruina & Schwab (2007), from its
/// wheels that do not slip.
fn yaw_gain() -> f64 {
    let WhippleSprung { w, lam, .. } = WhippleSprung::BENCHMARK;
    lam.cos() / w
}

#[test]
fn every_power_of_the_speed_has_its_matrix() {
    // In units and with the mirrors of the entries: the lean is about x, and the steer about z.
    let terms = [
        ("a0: kg*m^3/s^2, along z;", "a0/v*rate(phi)"),
        ("a1: N*m*s, along x*z;", "a1*rate(phi)"),
        ("a2: N*s^2, along z;", "a2*v*rate(phi)"),
        ("a3: N*m;", "a3*delta"),
        ("a4: kg*m;", "a4*g*delta"),
        ("a5: N*s, along x;", "a5*v*delta"),
        ("a6: kg;", "a6*v^2*delta"),
    ];
    let parameters: String = terms.iter().map(|(declared, _)| *declared).collect();
    let law: Vec<&str> = terms.iter().map(|(_, term)| *term).collect();
    // Half of it is definitions with the speed in them, and what multiplies a sum.
    let more = "b: N*m*s, along x*z; e: N*m*s, along x;".replace("along x;", "along x*z;");
    let statements = format!(
        "let gain = b*v; feedback T \"steer torque of a motor\" on delta = {} - 2*gain/v*rate(phi + phi/2); \
         feedback S on phi = -e*rate(delta - 3*delta);",
        law.join(" + ")
    );
    let compiled = bicycle(&format!("{parameters} {more} v: m/s, speed;"), &statements, "lean phi", "");
    let gains = [7.0, -3.0, 0.5, 11.0, 0.25, -1.5, 0.75];
    let [b, e] = [2.0, 5.0];
    let found = interpreted::<2>(&compiled, &values(&[gains.as_slice(), &[b, e]].concat()));
    let mut expected = WhippleSprung::BENCHMARK.coefficients();
    // A torque stands on the other side of the equation.
    expected.cm1 -= entry(1, 0, gains[0]);
    expected.c0 -= entry(1, 0, gains[1] - 3.0 * b) + entry(0, 1, 2.0 * e);
    expected.c1 -= entry(1, 0, gains[2]);
    expected.kc -= entry(1, 1, gains[3]);
    expected.k0 -= entry(1, 1, gains[4]);
    expected.k1 -= entry(1, 1, gains[5]);
    expected.k2 -= entry(1, 1, gains[6]);
    assert_close(&found, &expected, 1e-14, "every power");
    let told: Vec<_> =
        compiled.model.feedback.iter().map(|fed| (fed.name.as_str(), fed.on.as_str(), fed.unit)).collect();
    assert_eq!(told, [("T", "delta", Some("N*m")), ("S", "phi", Some("N*m"))]);
}

/// What the wheels determine may be fed back as well: a gyroscope measures the yaw rate.
#[test]
fn rates_that_follow_by_rolling_are_fed_back() {
    let statements = "feedback T on delta = -k1*rate(psi) - k2*v*rate(psi) - k3/v*rate(psi);";
    let compiled = bicycle(
        "k1: N*m*s; k2: N*s^2, along x; k3: kg*m^3/s^2, along x; v: m/s, speed;",
        statements,
        "lean phi, yaw psi",
        "",
    );
    let [k1, k2, k3] = [3.0, 0.7, 40.0];
    let found = interpreted::<2>(&compiled, &values(&[k1, k2, k3]));
    let WhippleSprung { c, .. } = WhippleSprung::BENCHMARK;
    let mut expected = WhippleSprung::BENCHMARK.coefficients();
    expected.cm1 += entry(1, 1, k3 * c * yaw_gain());
    expected.c0 += entry(1, 1, k1 * c * yaw_gain());
    expected.c1 += entry(1, 1, k2 * c * yaw_gain());
    expected.kc += entry(1, 1, k3 * yaw_gain());
    expected.k1 += entry(1, 1, k1 * yaw_gain());
    expected.k2 += entry(1, 1, k2 * yaw_gain());
    assert_close(&found, &expected, 1e-14, "yaw rate");
}

/// A rider who holds a straight line feeds back heading and place, which are coordinates of first order then: the contact point
/// of the rear wheel goes where that points to.
#[test]
fn heading_and_place_are_fed_back() {
    let compiled = bicycle(
        "kp: N*m; ky: N, along x;",
        "feedback T on delta = -kp*psi - ky*y;",
        "lean phi, yaw psi, lateral y",
        "psi: rad, only position; y: m, only position;",
    );
    let [kp, ky] = [4.0, 0.3];
    let found = interpreted::<4>(&compiled, &values(&[kp, ky]));
    let WhippleSprung { c, .. } = WhippleSprung::BENCHMARK;
    let mut expected: Coefficients<f64, 4> = enlarged(&WhippleSprung::BENCHMARK.coefficients());
    expected.kc += entry::<4>(1, 2, kp) + entry(1, 3, ky);
    expected.c0 += Matrix4::from_diagonal(&nalgebra::Vector4::new(0.0, 0.0, 1.0, 1.0)) - entry(2, 1, c * yaw_gain());
    expected.k1 -= entry::<4>(2, 1, yaw_gain()) + entry(3, 2, 1.0);
    assert_close(&found, &expected, 1e-14, "heading and place");
    assert_eq!(found.states, [States::Both, States::Both, States::Position, States::Position]);
}

/// Motors between body and wheels of a pendulum on wheels. The axle is at x - r theta, with the displacement x of the point of
/// the body that was on the ground, so a wheel turns about y by `-(x - r theta)/r`, and relative to the body by `-x/r`.
#[test]
fn a_motor_balances_a_pendulum_on_wheels() {
    let source = include_str!("../../../../generated/models/wheeled_pendulum.rs");
    let (model, _sets) = declaration(source).split_once("set robot").expect("it has sets");
    let laws = "feedback FL on L = k*theta + d*rate(theta) + e*rate(x); feedback FR on R = s*x - u*rate(psi);";
    let gains = "k: N*m; d: N*m*s; e: N*s, along z; s: N, along z; u: N*m*s, along y*z; g: N/kg";
    // What is fed back has no place in nonlinear equations, which are at no speed.
    let model = model.replacen("nonlinear;", "", 1).replacen("derivatives;", laws, 1);
    let plain = compiled(&format!("{}}}", model.replacen(laws, "", 1)));
    let fed = compiled(&format!("{}}}", model.replacen("g: N/kg", gains, 1)));
    let [r, b] = [0.24, 0.28];
    let design = [110.0, 0.9, 12.0, 2.0, 5.0, 0.08, 0.045, r, b];
    let [k, d, e, s, u] = [900.0, 120.0, 35.0, 8.0, 3.0];
    let mut expected = interpreted::<3>(&plain, &[design.as_slice(), &[9.81]].concat());
    let found = interpreted::<3>(&fed, &[design.as_slice(), &[k, d, e, s, u, 9.81]].concat());
    assert_eq!(expected.states, [States::Rate, States::Both, States::Rate]);
    // The axle on the right, at y = b, goes back as the machine yaws to the right.
    let [left, right] = [1.0, -1.0].map(|side| nalgebra::Vector3::new(-1.0 / r, 0.0, -side * b / r));
    expected.kc -= left * nalgebra::RowVector3::new(0.0, k, 0.0) + right * nalgebra::RowVector3::new(s, 0.0, 0.0);
    expected.c0 -= left * nalgebra::RowVector3::new(e, d, 0.0) + right * nalgebra::RowVector3::new(0.0, 0.0, -u);
    assert_close(&found, &expected, 1e-14, "balancing");
    // Where it is matters now.
    assert_eq!(found.states, [States::Both, States::Both, States::Rate]);
}

const CAR: &str = "model Car {
    parameters {
        m: kg, > 0; I: kg*m^2, > 0; a: m, > 0; b: m, > 0; h: m, > 0, unused; s: m, > 0;
        r: m, > 0; Cf: N, > 0; Cr: N, > 0; g: N/kg, >= 0, gravity; v: m/s, speed;
        k: N/m; d: N*s/m; p: N*m; q: N*m*s; o: N*s;
    }
    mechanism {
        body B: mass m, at (0, 0, -h), inertia [I, I, I];
        wheel F on B: mass 0, at (a, 0, -r), radius r, axial 0, radial 0, cornering Cf;
        wheel L on B: mass 0, at (-b, -s, -r), radius r, axial 0, radial 0, cornering Cr/2;
        wheel R on B: mass 0, at (-b, s, -r), radius r, axial 0, radial 0, cornering Cr/2;
        free B: lateral y, yaw psi;
    }
    coordinates { y: m; psi: rad; }
    LAW
}";

/// `m (y'' + v psi') = F + R`, `I psi'' = a F - b R` in the axes of the car, with `F = -Cf (y' + a psi')/v` and the like; in
/// those of the ground y'' alone is the acceleration, and `F = -Cf ((y' + a psi')/v - psi)`.
#[test]
fn a_car_holds_its_lane() {
    let [m, i, a, b, cf, cr] = [1200.0, 1500.0, 1.1, 1.4, 9e4, 8e4];
    let [k, d, p, q, o] = [500.0, 700.0, 3e4, 2e3, 90.0];
    let values = [m, i, a, b, 0.5, 0.7, 0.3, cf, cr, 9.81, k, d, p, q, o];
    let car = |law: &str| {
        // Gains that are left out.
        let left_out = ["k: N/m", "p: N*m"].into_iter().filter(|gain| !law.contains(&format!("-{}*", &gain[..1])));
        let source = left_out.fold(CAR.replace("LAW", law), |source, gain| {
            source.replacen(&format!("{gain};"), &format!("{gain}, unused;"), 1)
        });
        interpreted::<2>(&compiled(&source), &values)
    };
    let slip = Matrix2::new(cf + cr, a * cf - b * cr, a * cf - b * cr, a * a * cf + b * b * cr);
    let m = Matrix2::from_diagonal(&Vector2::new(m, i));

    // By rates alone it stays in its own axes.
    let laws = "feedback F on y = -d*rate(y) - o*v/v*rate(psi); feedback T on psi = -q*rate(psi);";
    let expected = Coefficients {
        m,
        cm1: slip,
        c0: Matrix2::new(d, o, 0.0, q),
        c1: entry(0, 1, m[(0, 0)]),
        states: [States::Rate; 2],
        ..Default::default()
    };
    let found = car(laws);
    assert_close(&found, &expected, 1e-14, "rates");
    assert_eq!(found.states, expected.states);

    // A heading is one whatever the axes are.
    let laws = "feedback F on y = -d*rate(y) - o*v/v*rate(psi); feedback T on psi = -p*psi - q*rate(psi);";
    let heading = Coefficients { kc: entry(1, 1, p), states: [States::Rate, States::Both], ..expected };
    let found = car(laws);
    assert_close(&found, &heading, 1e-14, "heading");
    assert_eq!(found.states, heading.states);

    // Where it is on the ground: the axes are those of the ground.
    let laws = "feedback F on y = -k*y - d*rate(y) - o*v/v*rate(psi); feedback T on psi = -p*psi - q*rate(psi);";
    let mut place = Coefficients { c1: Matrix2::zeros(), states: [States::Both; 2], ..heading };
    place.kc += entry(0, 0, k) - entry(0, 1, cf + cr) - entry(1, 1, a * cf - b * cr);
    let found = car(laws);
    assert_close(&found, &place, 1e-14, "place");
    assert_eq!(found.states, place.states);
}

/// Matrices that are written have feedback as well: as parts or as wholes, and of an actuator that follows with a delay.
#[test]
fn matrices_that_are_written_are_fed_back_to() {
    let found = interpreted::<3>(
        &compiled(
            "model Actuated {
                parameters {
                    m: kg, > 0; J: kg*m^2, > 0; k: N/m; tau: s, > 0; p: N*m; d: N*s; e: kg; f: N; g: N/kg, >= 0, gravity;
                    v: m/s, speed;
                }
                coordinates { x: m; theta: rad; u: N, only position; }
                M = [[m, 0, 0], [0, J, 0], [0, 0, 0]];
                C = [[k*v*1 [s^2/m], 0, 0], [0, 0, 0], [0, 0, tau]];
                Kc = [[k, 0, -1], [0, 0, 0], [0, 0, 1]];
                feedback command on u = -f*theta - tau*f*rate(theta);
                feedback T on theta = -p*theta - e*v^2*theta - d*v*theta*1 - m*g*x + m*g*(x + 1 [m]*theta);
                feedback F on x = -d*rate(theta);
            }"
            .replace("-m*g*x", "")
            .as_str(),
        ),
        &[2.0, 3.0, 5.0, 0.1, 7.0, 11.0, 13.0, 17.0, 9.81],
    );
    let expected = Coefficients {
        m: Matrix3::from_diagonal(&nalgebra::Vector3::new(2.0, 3.0, 0.0)),
        c0: entry::<3>(2, 2, 0.1) + entry(2, 1, 0.1 * 17.0) + entry(0, 1, 11.0),
        c1: entry(0, 0, 5.0),
        kc: Matrix3::new(5.0, 0.0, -1.0, 0.0, 7.0, 0.0, 0.0, 17.0, 1.0),
        k0: entry(1, 1, -2.0),
        k1: entry(1, 1, 11.0),
        k2: entry(1, 1, 13.0),
        ..Default::default()
    };
    assert_close(&found, &expected, 1e-14, "written");
    assert_eq!(found.states, [States::Both, States::Both, States::Position]);
}

fn refusal(source: &str) -> String {
    compile(source.parse().expect("tokens")).expect_err("a refusal").to_string()
}

/// Claims, published digits, requirements and the texts of formulas are of what the model has.
#[test]
fn what_is_told_of_a_matrix_has_the_feedback_in_it() {
    let rod = |statements: &str, set: &str| {
        format!(
            "model Rod {{
                parameters {{ m: kg, > 0; l: m, > 0; k: N*m; a: m; b: m; }}
                coordinates {{ theta: rad; }}
                M = [[m*l^2]];
                Kc = [[3*k]];
                feedback T on theta = -k*b/(a - b)*theta;
                {statements}
                set example {{ m = 2; l = 0.5; k = 12; a = 3; b = 1; {set} }}
            }}"
        )
    };
    let fed = compiled(&rod("assert Kc == [[3*k + k*b/(a - b)]];", "Kc = [[42.0]];"));
    let requirements: Vec<_> = fed.model.requirements.iter().map(|known| known.text.as_str()).collect();
    assert_eq!(requirements, ["a - b"]);
    let texts: Vec<String> = fed.model.formulas.iter().map(ToString::to_string).collect();
    assert_eq!(texts[0], "M_11 = m*l^2 [kg*m^2]");
    assert!(texts[1].starts_with("Kc_11 = 3*k + ") && texts[1].contains("a - b"), "{texts:?}");
    let message = refusal(&rod("assert Kc == [[3*k]];", ""));
    assert!(message.contains("42") && message.contains("36"), "{message}");
    let message = refusal(&rod("", "Kc = [[36.0]];"));
    assert!(message.contains("42") && message.contains("36"), "{message}");
    let message = refusal(&rod("", "").replace("a = 3", "a = 1"));
    assert!(message.starts_with("`a - b` is 0 in the set `example`"), "{message}");
}
