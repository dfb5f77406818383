//! What is added to the matrices of a mechanism, against the same at a joint and against a textbook.

#![allow(non_snake_case)] // Names of the field.

use carvallo::{Coefficients, Model};
use carvallo_compiler::{Compiled, compile};
use carvallo_models::WhippleSprung;
use nalgebra::Matrix2;

use super::{assert_close, declaration, interpreted};

const SPRUNG: &str = include_str!("../../../../generated/models/whipple_sprung.rs");

fn compiled(source: &str) -> Compiled {
    compile(source.parse().expect("tokens")).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn a_steering_damper_that_is_added_is_that_at_the_joint() {
    let (joint, none) = (", spring k, damper d;", ";");
    let source = declaration(SPRUNG);
    assert!(source.contains(joint));
    let added = source.replacen(joint, none, 1).replacen(
        "derivatives;",
        "add C0 = [[0, 0], [0, d]]; add symmetric Kc = [[0, 0], [0, k]]; derivatives;",
        1,
    );
    let added = compiled(&added);
    let names: Vec<&str> = added.model.matrices.iter().map(|(name, _)| name.name()).collect();
    assert_eq!(names, ["M", "C0", "C1", "Kc", "K0", "K2"]);
    for (k, d) in [(0.0, 0.0), (3.5, 0.75), (0.2, 12.0)] {
        let design = WhippleSprung { k, d, ..WhippleSprung::BENCHMARK };
        let found = interpreted::<2>(&added, &design.to_array());
        assert_close(&found, &design.coefficients(), 1e-14, "steering damper");
    }
    let partials =
        |compiled: &Compiled| compiled.programs.derivatives.as_ref().expect("asked for").program.outputs.len();
    assert_eq!(partials(&added), partials(&compiled(source)));
}

/// Two parameters for each matrix, in the units and with the mirrors of its entries on the diagonal and beside it: the lean
/// is about x, and the steer about z.
const TERMS: [(&str, &str, &str); 8] = [
    ("M", "kg*m^2", "kg*m^2, along x*z"),
    ("C-1", "kg*m^3/s^2, along x", "kg*m^3/s^2, along z"),
    ("C0", "N*m*s", "N*m*s, along x*z"),
    ("C1", "kg*m, along x", "kg*m, along z"),
    ("Kc", "N*m", "N*m, along x*z"),
    ("K0", "kg*m, along z", "kg*m, along x"),
    ("K1", "kg*m/s, along x", "kg*m/s, along z"),
    ("K2", "kg", "kg, along x*z"),
];

#[test]
fn every_matrix_can_be_added_to() {
    let (mut parameters, mut added) = (String::new(), String::new());
    for (index, (name, of_p, of_q)) in TERMS.into_iter().enumerate() {
        parameters += &format!("p{index}: {of_p}; q{index}: {of_q}; ");
        added += &format!("add {name} = [[p{index}, q{index}], [2*q{index}, 3*p{index}]]; ");
    }
    let last = "d: N*m*s, >= 0;";
    let (model, _sets) = declaration(SPRUNG).split_once("#[default]").expect("it has sets");
    let source = model.replacen(last, &format!("{last} {parameters}"), 1).replacen("derivatives;", &added, 1);
    let compiled = compiled(&format!("{source}}}"));
    let names: Vec<&str> = compiled.model.matrices.iter().map(|(name, _)| name.name()).collect();
    assert_eq!(names, TERMS.map(|(name, ..)| name));
    // Parts of two, so that each sum is told from every other.
    let terms: [[f64; 2]; 8] = std::array::from_fn(|index| [1.0, -0.375].map(|size| size * (index as f64 + 0.5)));
    let mut expected = WhippleSprung::BENCHMARK.coefficients();
    let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, .. } = &mut expected;
    for (matrix, [p, q]) in [m, cm1, c0, c1, kc, k0, k1, k2].into_iter().zip(terms) {
        *matrix += Matrix2::new(p, q, 2.0 * q, 3.0 * p);
    }
    let values = [WhippleSprung::BENCHMARK.to_array().as_slice(), terms.as_flattened()].concat();
    assert_close(&interpreted::<2>(&compiled, &values), &expected, 1e-14, "with every term");
}

/// A pendulum that stands on its pivot, with statements of its own: M = m l² and K0 = -m l, from the textbook.
fn standing(statements: &str) -> String {
    format!(
        "model Standing {{
            parameters {{
                m: kg, > 0; l: m, > 0, along z; J: kg*m^2, >= 0; k: N*m; a: m; b: m; g: N/kg, >= 0, gravity;
            }}
            mechanism {{
                body B: mass m, at (0, 0, -l), inertia 0;
                revolute theta: ground to B, through (0, 0, 0), along (1, 0, 0);
            }}
            coordinates {{ theta: rad; }}
            add M = [[J]];
            {statements}
            set example {{ m = 2; l = 0.5; J = 0.25; k = 12; a = 3; b = 1; g = 10;
                M = [[0.75]]; Kc = [[6.0]]; K0 = [[-1.0]];
            }}
        }}"
    )
}

fn refusal(source: &str) -> String {
    compile(source.parse().expect("tokens")).expect_err("a refusal").to_string()
}

#[test]
fn claims_and_published_matrices_are_of_the_sum() {
    let added = "add Kc = [[k*b/(a - b)]];";
    compiled(&standing(&format!("{added} assert M == [[m*l^2 + J]]; assert K0 == [[-m*l]];")));
    // What the mechanism has alone is not what the model has.
    let message = refusal(&standing(&format!("{added} assert M == [[m*l^2]];")));
    let values = "`M, row 1, column 1, = J + Jxx_theta, Jxx_theta = m*l^2` is 0.75 and `m*l^2` is 0.5";
    assert!(message.contains(values), "{message}");
    let message = refusal(&standing(added).replace("M = [[0.75]]", "M = [[0.5]]"));
    assert!(message.contains("0.75") && message.contains("0.5"), "{message}");
}

#[test]
fn what_an_added_entry_divides_by_is_required() {
    let compiled = compiled(&standing("add Kc = [[k*b/(a - b)]];"));
    let requirements = compiled.model.requirements.iter();
    let requirements: Vec<_> = requirements.map(|known| (known.text.as_str(), known.domain.to_string())).collect();
    assert_eq!(requirements, [("a - b", "not 0".to_string())]);
    let message = refusal(&standing("add Kc = [[k*b/(a - b)]];").replace("a = 3", "a = 1"));
    assert!(message.starts_with("`a - b` is 0 in the set `example`"), "{message}");
}

carvallo::model! {
    /// A pendulum that stands on its pivot, held by a spring that is no part of the mechanism.
    model Standing {
        parameters { m: kg, > 0; l: m, > 0, along z; J: kg*m^2, >= 0; k: N*m, >= 0; g: N/kg, >= 0, gravity; }
        mechanism {
            body B: mass m, at (0, 0, -l), inertia 0;
            revolute theta: ground to B, through (0, 0, 0), along (1, 0, 0);
        }
        coordinates { theta: rad; }
        add M = [[J]];
        add Kc = [[k]];
    }
}

/// (m l² + J) θ'' + (k - m g l) θ = 0.
#[test]
fn a_spring_that_is_added_changes_the_verdict() {
    let eigenvalues = |k| {
        let design = Standing { m: 2.0, l: 0.5, J: 0.25, k, g: 10.0 };
        let system = design.coefficients().at(0.0, design.g).expect("a mass");
        system.eigenvalues().expect("they converge")
    };
    let falls = eigenvalues(7.0);
    assert!(falls.iter().any(|s| (s.re - 2.0).abs() < 1e-15 && s.im == 0.0), "{falls:?}");
    let stands = eigenvalues(13.0);
    assert!(stands.iter().all(|s| s.re == 0.0 && (s.im.abs() - 2.0).abs() < 1e-15), "{stands:?}");
}
