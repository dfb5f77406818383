//! Which positions and rates are states, proved of formulas and of mechanisms that say nothing of it.

use carvallo::Model as _;
use carvallo_compiler::States::{self, Both, Position, Rate};
use carvallo_compiler::check;

fn states(declaration: &str) -> Result<Vec<States>, String> {
    let model = check(declaration.parse().expect("tokens")).map_err(|error| error.to_string())?;
    Ok(model.coordinates.iter().map(|coordinate| coordinate.states).collect())
}

/// A mass on a spring whose other end is a dashpot, with the given entries of the dashpot in M and of the mass in Kc.
fn mass_and_dashpot(coordinates: &str, mass: &str, stiffness: &str) -> Result<Vec<States>, String> {
    states(&format!(
        "model M {{ parameters {{ m: kg, > 0; k: N/m, > 0; c: N*s/m, > 0; a: rad; }} coordinates {{ {coordinates} }}
            M = [[m, 0], [0, {mass}]]; C0 = [[0, 0], [0, c]]; Kc = [[{stiffness}, -k], [-{stiffness}, k*cos(a)^2]]; }}"
    ))
}

#[test]
fn zeros_are_found_where_they_are_written_and_where_they_are_proved() {
    let (said, unsaid) = ("x: m; s: m, only position;", "x: m; s: m;");
    let unity = "(sin(a)^2 + cos(a)^2 - 1)";
    for (mass, stiffness, expected) in [
        ("0".into(), "k".into(), [Both, Position]),
        (format!("m*{unity}"), "k".into(), [Both, Position]),
        ("0".into(), "(k - k)".into(), [Rate, Position]),
        ("0".into(), format!("k*{unity}"), [Rate, Position]),
        ("m".into(), format!("k*{unity}"), [Rate, Both]),
        ("m*cos(a)^2".into(), "k*sin(a)^2".into(), [Both, Both]),
    ] {
        assert_eq!(mass_and_dashpot(unsaid, &mass, &stiffness), Ok(expected.to_vec()), "{mass} {stiffness}");
        if expected == [Both, Position] {
            assert_eq!(mass_and_dashpot(said, &mass, &stiffness), Ok(expected.to_vec()), "{mass} {stiffness}");
        }
    }
    assert_eq!(mass_and_dashpot("x: m, both; s: m;", "0", "(k - k)"), Ok(vec![Both, Position]));
}

/// An actuator that follows a displacement with a lag, in newtons.
#[test]
fn a_coordinate_that_is_of_first_order_as_it_stands_may_be_in_any_unit() {
    let actuator = |unit: &str, mass: &str| {
        states(&format!(
            "model M {{ parameters {{ m: kg, > 0; k: N/m, > 0; tau: s, > 0; }} coordinates {{ x: m; F: {unit}; }}
                M = [[m, 0], [0, {mass}]]; C0 = [[0, 0], [0, tau]]; Kc = [[k, -1], [-k, 1]]; }}"
        ))
    };
    assert_eq!(actuator("N", "0"), Ok(vec![Both, Position]));
    assert!(actuator("N", "m").unwrap_err().contains("expected an angle (`rad`) or a length (`m`)"));
}

/// A cart with a pendulum: nothing holds the cart, until a spring does.
#[test]
fn mechanisms_have_the_states_that_their_matrices_show() {
    let cart = |coordinate: &str, spring: &str, added: &str| {
        states(&format!(
            "model M {{ parameters {{ m: kg, > 0; l: m, > 0; k: N/m, >= 0{}; g: N/kg, >= 0, gravity; }}
                mechanism {{
                    body C: mass m, at (0, 0, 0), inertia 0; body P: mass m, at (0, 0, l), inertia 0;
                    prismatic x: ground to C, along (1, 0, 0){spring};
                    revolute q: C to P, through (0, 0, 0), along (0, 1, 0);
                }}
                coordinates {{ {coordinate} q: rad; }} {added} }}",
            if spring.is_empty() && added.is_empty() { ", unused" } else { "" }
        ))
    };
    assert_eq!(cart("x: m;", "", ""), Ok(vec![Rate, Both]));
    assert_eq!(cart("x: m, both;", "", ""), Ok(vec![Both, Both]));
    assert_eq!(cart("x: m;", ", spring k", ""), Ok(vec![Both, Both]));
    assert_eq!(cart("x: m;", "", "add Kc = [[k, 0], [0, 0]];"), Ok(vec![Both, Both]));
}

carvallo::model! {
    /// A first-order lag alone, `tau s' + s = f`.
    model Lag {
        parameters { tau: s, > 0; }
        coordinates { s: m; }
        M = [[0]];
        C0 = [[tau]];
        Kc = [[1]];
    }
}

#[test]
fn a_lag_has_the_one_eigenvalue_of_its_time_constant() {
    let lag = Lag { tau: 0.25 };
    let found = lag.coefficients().at(0.0, 0.0).unwrap().eigenvalues().unwrap();
    assert_eq!(found, [carvallo::Complex::new(-4.0, 0.0)]);
    let stability = carvallo::Stability::new(&lag.coefficients(), 0.0).unwrap();
    assert_eq!(stability.verdict(0.0), Ok(carvallo::Verdict::Stable));
    assert_eq!(stability.critical_speeds, []);
}
