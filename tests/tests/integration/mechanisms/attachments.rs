//! Bodies that are fixed to each other are one body.

use carvallo_compiler::compile;
use carvallo_tests::bicycles;

use super::bicycles::{by_hand, rigid};
use super::{assert_close, declaration, interpreted};

/// The bicycle with a leaning rider, whose hip is locked instead: lines with a part of the hip are left out.
fn locked() -> String {
    let source = include_str!("../../../../generated/models/whipple_leaning.rs");
    let is_hip = |line: &str| {
        ["zP: m", "kU: N*m", "dU: N*m", "theta", "hip axis, ", "of the hip."].iter().any(|part| line.contains(part))
    };
    let mut text: String =
        declaration(source).lines().filter(|line| !is_hip(line)).flat_map(|line| [line, "\n"]).collect();
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
        assert_close(&interpreted(&compiled, &values), &by_hand(&rigid(&design, upper)), 1e-11, name);
    }
}
