//! Bodies that are fixed to each other are one body.

use carvallo_compiler::compile;
use carvallo_models::Whipple;
use carvallo_tests::bicycles;

use super::bicycles::{by_hand, rigid};

/// The bicycle with a leaning rider, whose hip is locked instead: lines with a part of the hip are left out.
fn locked() -> String {
    let source = include_str!("../../../../generated/models/whipple_leaning.rs");
    let (_, body) = source.split_once('{').expect("an opening brace");
    let (body, _) = body.rsplit_once('}').expect("a closing brace");
    let is_hip = |line: &str| {
        ["zP: m", "kU: N*m", "dU: N*m", "theta", "hip axis, ", "of the hip."].iter().any(|part| line.contains(part))
    };
    let mut text: String = body.lines().filter(|line| !is_hip(line)).flat_map(|line| [line, "\n"]).collect();
    for set in [
        "zP = -0.85; ",
        "kU = 600; dU = 60;",
        "/// Lean of the upper body relative to the rear frame, positive to the right.",
    ] {
        assert!(text.contains(set), "{set}");
        text = text.replace(set, "");
    }
    text.replace("free B: lean phi;", "fix U to B;\nfree B: lean phi;")
}

#[test]
fn a_rider_who_is_fixed_to_the_frame_is_part_of_it() {
    let compiled = compile(locked().parse().expect("tokens")).expect("a model");
    let names: Vec<String> = compiled.model.parameters.iter().map(|parameter| parameter.name.to_string()).collect();
    assert_eq!(names[26..], ["mU", "xU", "zU", "IUxx", "IUyy", "IUzz", "IUxz"]);
    let upper = [40.0, 0.35, -1.125, 1.6, 1.7, 0.6, 0.1];
    for (name, design) in bicycles::all() {
        let values: Vec<f64> = design.to_array().into_iter().chain(upper).collect();
        let found = compiled.programs.matrices.interpret(&values);
        let whole: Whipple = rigid(&design, upper);
        let expected = by_hand(&whole);
        let expected = [expected.m, expected.c1, expected.k0, expected.k2].map(|matrix| matrix.transpose());
        let expected: Vec<f64> = expected.iter().flat_map(|matrix| matrix.iter().copied()).collect();
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).abs() <= 1e-11 * expected.abs().max(1.0), "{name}: {found} {expected}");
        }
        assert_eq!(found.len(), expected.len());
    }
}
