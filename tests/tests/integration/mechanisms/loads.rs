//! Tyres whose side forces go with the steady loads of their wheels, against the loads of the textbook.

use carvallo::Coefficients;
use carvallo_compiler::compile;
use nalgebra::Matrix2;

use super::{assert_close, interpreted};

/// A car on one wheel in front and two at the rear, with its centre of mass beside the middle, and what its tyres have.
fn car<const N: usize>(tyres: [&str; 3], parameters: &str, values: &[f64]) -> Coefficients<f64, N> {
    let [front, left, right] = tyres;
    let declaration = format!(
        "model Car {{
            parameters {{
                m: kg, > 0; I: kg*m^2, > 0; a: m, > 0; b: m, > 0; s: m, > 0; y0: m; h: m, > 0, unused; r: m, > 0; mW: kg, > 0;
                g: N/kg, >= 0, gravity; {parameters}
            }}
            mechanism {{
                body B: mass m, at (0, y0, -h), inertia [I, I, I];
                wheel F on B: mass mW, at (a, 0, -r), radius r, axial 0, radial 0, {front};
                wheel L on B: mass mW, at (-b, -s, -r), radius r, axial 0, radial 0, {left};
                wheel R on B: mass mW, at (-b, s, -r), radius r, axial 0, radial 0, {right};
                free B: lateral y, yaw psi;
                hold forward;
            }}
            coordinates {{ y: m; psi: rad; }}
        }}"
    );
    let compiled = compile(declaration.parse().expect("tokens")).unwrap_or_else(|error| panic!("{error}"));
    interpreted(&compiled, &[DESIGN.as_slice(), values].concat())
}

const DESIGN: [f64; 10] = [1200.0, 1500.0, 1.1, 1.4, 0.7, 0.2, 0.5, 0.3, 20.0, 9.81];

/// The forces on the wheels F, L and R: their sum is the weight, and about no axis is there a moment.
fn loads() -> [f64; 3] {
    let [m, _, a, b, s, y0, _, _, wheel, g] = DESIGN;
    let front = m * g * b / (a + b);
    let rear = m * g - front;
    let more = m * g * y0 / s;
    [front, (rear - more) / 2.0, (rear + more) / 2.0].map(|load| load + wheel * g)
}

/// The tyres of the side that bears more take more of the side force. That a car which rolls in a curve shifts its weight
/// changes nothing in the first order, as no tyre slips while it runs straight.
#[test]
fn side_forces_go_with_the_loads() {
    let tyres = ["cornering c*load(F)", "cornering c*load(L)", "cornering c*load(R)"];
    let c = 8.5;
    let found = car::<2>(tyres, "c: 1, > 0;", &[c]);
    let [front, left, right] = loads();
    let given = ["cornering cF", "cornering cL", "cornering cR"];
    let expected = car::<2>(given, "cF: N; cL: N; cR: N;", &[c * front, c * left, c * right]);
    assert_close(&found, &expected, 1e-14, "loads");
    // The textbook, again: side forces and their moments about the origin, which is on the middle line.
    let [_, _, a, b, ..] = DESIGN;
    let [cf, cr] = [c * front, c * (left + right)];
    assert_close(
        &found,
        &Coefficients {
            m: found.m,
            c1: found.c1,
            cm1: Matrix2::new(cf + cr, a * cf - b * cr, a * cf - b * cr, a * a * cf + b * b * cr),
            ..Default::default()
        },
        1e-14,
        "by hand",
    );
    // Side forces in proportion to the loads balance about the centre of mass of the whole.
    let [m, _, a, b, .., wheel, _] = DESIGN;
    let moment = wheel * (a - 2.0 * b) / (m + 3.0 * wheel);
    assert!((found.cm1[(0, 1)] / found.cm1[(0, 0)] - moment).abs() < 1e-14);
}

/// A tyre takes less than in proportion to its load: so two that are loaded unequally take less than two that are not.
#[test]
fn unequal_loads_weaken_an_axle() {
    let law = |wheel: &str| format!("cornering c*load({wheel}) - e*load({wheel})^2");
    let [of_f, of_l, of_r] = ["F", "L", "R"].map(law);
    let [c, e] = [12.0, 4e-4];
    let found = car::<2>([&of_f, &of_l, &of_r], "c: 1; e: 1/N;", &[c, e]);
    let loads = loads();
    let values = loads.map(|load| c * load - e * load * load);
    let expected = car::<2>(["cornering cF", "cornering cL", "cornering cR"], "cF: N; cL: N; cR: N;", &values);
    assert_close(&found, &expected, 1e-14, "weaker");
    let [_, left, right] = loads;
    let even = 2.0 * (c * (left + right) / 2.0 - e * ((left + right) / 2.0).powi(2));
    assert!(values[1] + values[2] < even - 0.01 * even);
}

/// A bicycle leans, and its tyres are pushed by camber in proportion to their loads, which relax.
#[test]
fn camber_and_relaxation_go_with_the_loads() {
    let bicycle = |[rear, front]: [&str; 2], parameters: &str, values: &[f64]| {
        let declaration = format!(
            "model Bicycle {{
                parameters {{ m: kg, > 0; I: kg*m^2, > 0; x: m; w: m, > 0; h: m, > 0; s: m, > 0; g: N/kg, >= 0, gravity; {parameters} }}
                mechanism {{
                    body B: mass m, at (x, 0, -h), inertia [I, 0, I];
                    wheel R on B: mass 2 [kg], at (0, 0, -0.3 [m]), radius 0.3 [m], axial 0, radial 0, {rear};
                    wheel F on B: mass 1 [kg], at (w, 0, -0.3 [m]), radius 0.3 [m], axial 0, radial 0, {front}, relaxation s, deflection e;
                    free B: lateral y, yaw psi, lean phi;
                }}
                coordinates {{ y: m; psi: rad; phi: rad; e: m; }}
            }}"
        );
        let compiled = compile(declaration.parse().expect("tokens")).unwrap_or_else(|error| panic!("{error}"));
        let [m, i, x, w, h, s, g] = [85.0, 9.0, 0.4, 1.1, 1.0, 0.2, 9.81];
        (
            interpreted::<4>(&compiled, &[[m, i, x, w, h, s, g].as_slice(), values].concat()),
            [m * g * (w - x) / w, m * g * x / w],
        )
    };
    let [c, q] = [6.5, 0.95];
    let law = |wheel: &str| format!("cornering c*load({wheel}), camber q*load({wheel})");
    let [rear, front] = ["R", "F"].map(law);
    let (found, [on_rear, on_front]) = bicycle([&rear, &front], "c: 1; q: 1;", &[c, q]);
    let loads = [on_rear + 2.0 * 9.81, on_front + 9.81];
    let values = [c * loads[0], c * loads[1], q * loads[0], q * loads[1]];
    let given = ["cornering cR, camber qR", "cornering cF, camber qF"];
    let (expected, _) = bicycle(given, "cR: N; cF: N; qR: N; qF: N;", &values);
    assert_close(&found, &expected, 1e-13, "camber");
}
