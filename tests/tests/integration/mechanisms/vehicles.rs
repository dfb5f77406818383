//! Vehicles of more than two wheels, or whose wheels do not hang on the frame as a bicycle's do, against nonlinear dynamics.

use carvallo::Coefficients;
use carvallo_compiler::compile;
use carvallo_tests::multibody::{Body, Joint, Mechanism, Wheel};
use nalgebra::{Matrix2, Matrix3, Vector3};

use super::{assert_close, interpreted};

/// What the differences of the nonlinear dynamics may be off.
const DIFFERENCES: f64 = 1e-6;

/// The matrices of a mechanism whose parameters have these units, with what may stand behind them, and values.
fn compiled<const N: usize>(
    parameters: &[(&str, &str, f64)],
    mechanism: &str,
    coordinates: &str,
) -> Coefficients<f64, N> {
    let declared: Vec<String> = parameters.iter().map(|(name, unit, _)| format!("{name}: {unit};")).collect();
    let text = format!(
        "model Vehicle {{ parameters {{ {} }} mechanism {{ {mechanism} }} coordinates {{ {coordinates} }} }}",
        declared.join(" ")
    );
    let compiled = compile(text.parse().expect("tokens")).unwrap_or_else(|error| panic!("{error}"));
    let values: Vec<f64> = parameters.iter().map(|(.., value)| *value).collect();
    interpreted(&compiled, &values)
}

fn body(joint: usize, mass: f64, centre: Vector3<f64>, moments: Vector3<f64>) -> Body {
    Body { joint, mass, centre, inertia: Matrix3::from_diagonal(&moments) }
}

/// A tricycle whose frame tilts on the rear axle about an inclined hinge, and is steered in front.
const TRICYCLE: [(&str, &str, f64); 26] = [
    ("w", "m", 1.02),
    ("c", "m", 0.08),
    ("b", "m", 0.3),
    ("h", "m", 0.2),
    ("lam", "rad", 0.31),
    ("tilt", "rad", 0.1),
    ("mB", "kg", 85.0),
    ("xB", "m", 0.3),
    ("zB", "m", -0.6),
    ("Bx", "kg*m^2", 9.2),
    ("Bz", "kg*m^2", 2.8),
    ("mT", "kg", 12.0),
    ("xT", "m", 0.1),
    ("Tz", "kg*m^2", 0.5),
    ("mH", "kg", 4.0),
    ("xH", "m", 0.9),
    ("zH", "m", -0.7),
    ("H", "kg*m^2", 0.06),
    ("r", "m", 0.25),
    ("m", "kg", 1.5),
    ("a", "kg*m^2", 0.05),
    ("t", "kg*m^2", 0.03),
    ("k", "N*m", 30.0),
    ("d", "N*m*s", 4.0),
    ("rho", "m", 0.04),
    ("g", "N/kg, gravity", 9.81),
];

const TRICYCLE_BODIES: &str = "
    body B: mass mB, at (xB, 0, zB), inertia [Bx, 0, Bz];
    body T: mass mT, at (xT, 0, -r), inertia [0, 0, Tz];
    body H: mass mH, at (xH, 0, zH), inertia [H, H, H];
    wheel L on T: mass m, at (0, -b, -r), radius r, axial a, radial t;
    wheel R on T: mass m, at (0, b, -r), radius r, axial a, radial t;
    wheel F on H: mass m, at (w, 0, -r), radius r, tyre rho, axial a, radial t;
    revolute delta: B to H, through (w + c, 0, 0), along (sin(lam), 0, cos(lam));";

/// The same for the nonlinear dynamics: its tilt and its steer are the coordinates.
fn tricycle() -> (Mechanism, [usize; 2], usize) {
    let value = |name: &str| TRICYCLE.iter().find(|(known, ..)| *known == name).expect("a parameter").2;
    let [w, c, b, h, lam, tilt, r] = ["w", "c", "b", "h", "lam", "tilt", "r"].map(value);
    let mut tricycle = Mechanism::default();
    let root = tricycle.free_root();
    let axle = root.pitch;
    let hinge = Joint::revolute(Some(axle), Vector3::new(0.0, 0.0, -h), Vector3::new(tilt.cos(), 0.0, tilt.sin()));
    let frame = tricycle.joint(hinge.sprung(value("k"), value("d")));
    let steer = Vector3::new(lam.sin(), 0.0, lam.cos());
    let fork = tricycle.joint(Joint::revolute(Some(frame), Vector3::new(w + c, 0.0, 0.0), steer));
    let frame_centre = Vector3::new(value("xB"), 0.0, value("zB"));
    tricycle.body(body(frame, value("mB"), frame_centre, Vector3::new(value("Bx"), 0.0, value("Bz"))));
    tricycle.body(body(axle, value("mT"), Vector3::new(value("xT"), 0.0, -r), Vector3::new(0.0, 0.0, value("Tz"))));
    tricycle.body(body(fork, value("mH"), Vector3::new(value("xH"), 0.0, value("zH")), Vector3::repeat(value("H"))));
    for (carrier, x, y, tyre) in [(axle, 0.0, -b, 0.0), (axle, 0.0, b, 0.0), (fork, w, 0.0, value("rho"))] {
        let [mass, axial, transverse] = ["m", "a", "t"].map(value);
        tricycle.wheel(Wheel { carrier, x, y, radius: r, tyre, mass, axial, transverse });
    }
    (tricycle, [frame, fork], root.x)
}

#[test]
fn a_tricycle_tilts_on_its_axle() {
    let (numeric, coordinates, forward) = tricycle();
    let expected = numeric.linearized(coordinates, Some(forward));
    let hinge = "through (0, 0, -h), along (cos(tilt), 0, sin(tilt)), spring k, damper d;";
    let mechanism = format!("{TRICYCLE_BODIES} revolute phi: T to B, {hinge} free T;");
    let found = compiled(&TRICYCLE, &mechanism, "phi: rad; delta: rad;");
    assert_close(&found, &expected, DIFFERENCES, "tricycle");
    // From the frame outward the axle tilts the other way, and its spring and damper are at a joint that follows.
    let mechanism = format!("{TRICYCLE_BODIES} revolute q: B to T, {hinge} free B: lean phi;");
    let found = compiled(&TRICYCLE, &mechanism, "phi: rad; delta: rad;");
    // The frame's lean is the part of the tilt that is not a yaw.
    let lean = Matrix2::new(1.0 / 0.1_f64.cos(), 0.0, 0.0, 1.0);
    let seen = |matrix: Matrix2<f64>| lean * matrix * lean;
    let Coefficients { m, c0, c1, kc, k0, k2, .. } = expected;
    let [m, c0, c1, kc, k0, k2] = [m, c0, c1, kc, k0, k2].map(seen);
    assert_close(
        &found,
        &Coefficients { m, c0, c1, kc, k0, k2, ..Default::default() },
        DIFFERENCES,
        "tricycle, from its frame",
    );
}

#[test]
fn a_caster_shimmies_on_a_springy_mount() {
    // A cart of two wheels on one axle that yaws as its caster, which slides and swivels, makes it.
    let (x, b, r, w, c, rc) = (0.5, 0.3, 0.2, 1.0, 0.1, 0.08);
    let (m, iz, mw, a, t) = (75.0, 3.0, 2.0, 0.03, 0.02);
    let (ms, mk, iy, k, d, ky, dy) = (1.3, 1.0, 0.02, 500.0, 3.0, 4.0, 0.1);
    let parameters = [
        ("x", "m", x),
        ("b", "m", b),
        ("r", "m", r),
        ("w", "m", w),
        ("c", "m", c),
        ("rc", "m", rc),
        ("m", "kg", m),
        ("iz", "kg*m^2", iz),
        ("mw", "kg", mw),
        ("a", "kg*m^2", a),
        ("t", "kg*m^2", t),
        ("ms", "kg", ms),
        ("mk", "kg", mk),
        ("iy", "kg*m^2", iy),
        ("k", "N/m", k),
        ("d", "N*s/m", d),
        ("ky", "N*m", ky),
        ("dy", "N*m*s", dy),
        ("g", "N/kg, gravity", 9.81),
    ];
    let found = compiled(
        &parameters,
        "body B: mass m, at (x, 0, -r), inertia [0, 0, iz];
         body S: mass ms, at (w, 0, -r), inertia [0, 0, iy];
         body K: mass mk, at (w - c, 0, -r), inertia [0, 0, iy];
         wheel L on B: mass mw, at (0, -b, -r), radius r, axial a, radial t;
         wheel R on B: mass mw, at (0, b, -r), radius r, axial a, radial t;
         wheel C on K: mass mw, at (w - c, 0, -rc), radius rc, axial a, radial t;
         prismatic y: B to S, along (0, 1, 0), spring k, damper d;
         revolute q: S to K, through (w, 0, 0), along (0, 0, 1), spring ky, damper dy;
         free B;",
        "q: rad; y: m;",
    );
    let mut cart = Mechanism::default();
    let root = cart.free_root();
    let slide = cart.joint(Joint::prismatic(Some(root.pitch), Vector3::y()).sprung(k, d));
    let swivel = cart.joint(Joint::revolute(Some(slide), Vector3::new(w, 0.0, 0.0), Vector3::z()).sprung(ky, dy));
    cart.body(body(root.pitch, m, Vector3::new(x, 0.0, -r), Vector3::new(0.0, 0.0, iz)));
    cart.body(body(slide, ms, Vector3::new(w, 0.0, -r), Vector3::new(0.0, 0.0, iy)));
    cart.body(body(swivel, mk, Vector3::new(w - c, 0.0, -r), Vector3::new(0.0, 0.0, iy)));
    for (carrier, x, y, radius) in [(root.pitch, 0.0, -b, r), (root.pitch, 0.0, b, r), (swivel, w - c, 0.0, rc)] {
        cart.wheel(Wheel { carrier, x, y, radius, tyre: 0.0, mass: mw, axial: a, transverse: t });
    }
    assert_close(&found, &cart.linearized([swivel, slide], Some(root.x)), DIFFERENCES, "caster");
}

#[test]
fn a_wheel_may_hang_on_any_joints() {
    // The rear wheel leans, steers and slides on its frame, by joints without bodies of their own.
    let (w, c, lam, r, xb, zb, mb, i, m, a, t) = (1.02, 0.08, 0.31, 0.3, 0.3, -0.9, 85.0, 5.0, 2.0, 0.12, 0.06);
    let (k, d, ky, dy) = (900.0, 50.0, 800.0, 40.0);
    let parameters = [
        ("g", "N/kg, gravity", 9.81),
        ("w", "m", w),
        ("c", "m", c),
        ("lam", "rad", lam),
        ("r", "m", r),
        ("xb", "m", xb),
        ("zb", "m", zb),
        ("mb", "kg", mb),
        ("i", "kg*m^2", i),
        ("m", "kg", m),
        ("a", "kg*m^2", a),
        ("t", "kg*m^2", t),
        ("k", "N*m", k),
        ("d", "N*m*s", d),
        ("ky", "N/m", ky),
        ("dy", "N*s/m", dy),
    ];
    let found = compiled(
        &parameters,
        // Joints may stand before those that carry them.
        "prismatic s3: N2 to N3, along (0, 1, 0), spring ky, damper dy;
         revolute s2: N1 to N2, through (c, 0, 0), along (0, 0, 1), spring k, damper d;
         revolute s1: B to N1, through (0, 0, zb), along (1, 0, 0), spring k, damper d;
         body N3: massless; body N2: massless; body N1: massless;
         body B: mass mb, at (xb, 0, zb), inertia [i, 0, i];
         body H: massless;
         wheel R on N3: mass m, at (0, 0, -r), radius r, axial a, radial t;
         wheel F on H: mass m, at (w, 0, -r), radius r, axial a, radial t;
         revolute delta: B to H, through (w + c, 0, 0), along (sin(lam), 0, cos(lam));
         free B: lean phi;",
        "s3: m; delta: rad; s1: rad; phi: rad; s2: rad;",
    );
    let mut bicycle = Mechanism::default();
    let root = bicycle.free_root();
    let lean = bicycle.joint(Joint::revolute(Some(root.pitch), Vector3::new(0.0, 0.0, zb), Vector3::x()).sprung(k, d));
    let steer = bicycle.joint(Joint::revolute(Some(lean), Vector3::new(c, 0.0, 0.0), Vector3::z()).sprung(k, d));
    let slide = bicycle.joint(Joint::prismatic(Some(steer), Vector3::y()).sprung(ky, dy));
    let axis = Vector3::new(lam.sin(), 0.0, lam.cos());
    let front = bicycle.joint(Joint::revolute(Some(root.pitch), Vector3::new(w + c, 0.0, 0.0), axis));
    bicycle.body(body(root.pitch, mb, Vector3::new(xb, 0.0, zb), Vector3::new(i, 0.0, i)));
    for (carrier, x) in [(slide, 0.0), (front, w)] {
        bicycle.wheel(Wheel { carrier, x, y: 0.0, radius: r, tyre: 0.0, mass: m, axial: a, transverse: t });
    }
    let coordinates = [slide, front, lean, root.lean, steer];
    assert_close(&found, &bicycle.linearized(coordinates, Some(root.x)), DIFFERENCES, "bicycle");
}

#[test]
fn a_spring_at_a_coordinate_carries_what_rests_on_it() {
    // The hanging mass: its weight stretches the spring, and changes nothing else.
    let parameters = [("m", "kg", 2.0), ("k", "N/m", 50.0), ("g", "N/kg, gravity", 9.81)];
    let parts = "body B: mass m, at (0, 0, 0), inertia 0; prismatic z: ground to B, along (0, 0, 1), spring k;";
    let found = compiled::<1>(&parameters, parts, "z: m;");
    let expected = Coefficients::from_rows([[[2.0]], [[0.0]], [[0.0]], [[0.0]], [[50.0]], [[0.0]], [[0.0]], [[0.0]]]);
    assert_eq!(found, expected);
    // A pendulum held level by a torsion spring: of its second derivatives the one of the height is zero there.
    let parameters = [("m", "kg", 2.0), ("l", "m", 0.5), ("k", "N*m", 50.0), ("g", "N/kg, gravity", 9.81)];
    let parts = "body B: mass m, at (0, l, 0), inertia 0; \
                 revolute phi: ground to B, through (0, 0, 0), along (1, 0, 0), spring k;";
    let found = compiled::<1>(&parameters, parts, "phi: rad;");
    let expected = Coefficients::from_rows([[[0.5]], [[0.0]], [[0.0]], [[0.0]], [[50.0]], [[0.0]], [[0.0]], [[0.0]]]);
    assert_eq!(found, expected);
}

/// A cart on two wheels with a massless caster behind them, on a vertical axis.
const CASTER: &str = "body B: mass m, at (x, 0, -h), inertia [0, 0, I]; body K: massless; \
    revolute kappa: B to K, through (w, 0, 0), along (0, 0, 1); \
    wheel C on K: mass 0, at (w - c, 0, -r), radius r, axial 0, radial 0; \
    wheel L on B: mass 0, at (0, -b, -r), radius r, axial 0, radial 0; \
    wheel R on B: mass 0, at (0, b, -r), radius r, axial 0, radial 0; \
    free B: yaw psi;";

#[test]
fn what_does_not_follow_from_the_coordinates_has_no_rate() {
    let parameters = "m: kg; x: m; h: m, unused; I: kg*m^2; w: m, unused; c: m, unused; r: m; b: m; g: N/kg, gravity;";
    let text =
        format!("model Cart {{ parameters {{ {parameters} }} mechanism {{ {CASTER} }} coordinates {{ psi: rad; }} }}");
    let compiled = compile(text.parse().expect("tokens")).unwrap_or_else(|error| panic!("{error}"));
    let rates = compiled.model.kinematics.expect("it is a mechanism").rates;
    // The caster follows its own position: c kappa' = (w - c) psi' - v kappa. So does its wheel's heading, but not its spin.
    let names: Vec<&str> = rates.iter().map(|rate| rate.name.as_str()).collect();
    assert_eq!(names, ["lateral", "lean", "wheel_C", "wheel_L", "wheel_R"]);
}

#[test]
fn a_side_wheel_may_stand_beside_another_one_and_before_it() {
    // The massless wheel W hangs beside the rear wheel on an arm of its own, and changes nothing.
    let parameters = [
        ("m", "kg", 80.0),
        ("x", "m", 0.5),
        ("h", "m", 0.9),
        ("I", "kg*m^2", 8.0),
        ("w", "m", 1.0),
        ("c", "m", 0.1),
        ("r", "m", 0.3),
        ("b", "m", 0.2),
        ("a", "m", 0.4),
        ("g", "N/kg, gravity", 9.81),
    ];
    let bicycle = "body B: mass m, at (x, 0, -h), inertia [I, 0, I]; body H: massless; \
                   revolute delta: B to H, through (w + c, 0, 0), along (0, 0, 1); \
                   wheel R on B: mass m/40, at (0, 0, -r), radius r, axial m*r^2/40, radial m*r^2/80; \
                   wheel F on H: mass m/40, at (w, 0, -r), radius r, axial m*r^2/40, radial m*r^2/80; \
                   free B: lean phi;";
    let side = "body A: massless; revolute arm: B to A, through (a, 0, -r), along (0, 1, 0); \
                wheel W on A: mass 0, at (0, b, -r), radius r, axial 0, radial 0;";
    let without: Vec<_> = parameters.into_iter().filter(|(name, ..)| !["a", "b"].contains(name)).collect();
    let expected = compiled::<2>(&without, bicycle, "phi: rad; delta: rad;");
    for parts in [format!("{side} {bicycle}"), format!("{bicycle} {side}")] {
        assert_close(&compiled::<2>(&parameters, &parts, "phi: rad; delta: rad;"), &expected, 1e-12, "side wheel");
    }
}
