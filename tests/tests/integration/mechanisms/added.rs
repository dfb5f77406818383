//! What is added to the matrices of a mechanism, against the same at a joint and against a textbook.

use carvallo::Model;
use carvallo_compiler::{Compiled, compile};
use carvallo_models::WhippleSprung;

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
