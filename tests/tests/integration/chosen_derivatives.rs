//! The bicycle that asks for a few of its derivatives, which benchmarks read without the compiler: that it is what the compiler
//! writes, and that its derivatives are those in exact arithmetic.

use std::fs;
use std::path::Path;

use carvallo::MatrixName;
use carvallo_compare::Real;
use carvallo_compiler::files::{Language, expand};
use carvallo_tests::chosen::WhippleChosen;
use carvallo_tests::designs;
use carvallo_tests::exact::{Matrices, derivative_sizes, derivatives};

/// The shipped declaration by formulas, but for its name and for what it asks for.
fn declaration() -> String {
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated/models/whipple.rs");
    let text = fs::read_to_string(shipped).expect("a source can be read");
    let [all, name] = ["        derivatives;\n", "pub model Whipple {"];
    assert_eq!([all, name].map(|part| text.matches(part).count()), [1, 1], "the source has another form");
    text.replace(all, "        derivatives of M, K0 with respect to w, c;\n").replace(name, "pub model WhippleChosen {")
}

#[test]
fn what_is_checked_in_is_what_the_compiler_writes() {
    let folder = std::env::temp_dir().join(format!("carvallo-chosen-{}", std::process::id()));
    let [models, written] = ["models", "written"].map(|name| folder.join(name));
    fs::create_dir_all(&models).expect("a folder for the test");
    fs::write(models.join("chosen.rs"), declaration()).expect("a file can be written");
    let done = expand(&models, &written, Language::Rust, false);
    let code = fs::read_to_string(written.join("chosen.rs"));
    // Nothing depends on it any more.
    let _ = fs::remove_dir_all(&folder);
    done.expect("a model that compiles");
    let code = code.expect("it has just been written");
    // The first two lines name the folder of this test.
    let rest = code.splitn(3, '\n').nth(2).expect("a file with a header");
    let command = "UPDATE=1 cargo test --workspace --test integration chosen_derivatives";
    let code = format!(
        "// @generated from generated/models/whipple.rs, with fewer derivatives; do not edit.\n// To write it anew: \
         {command}\n{rest}"
    );
    let place = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/chosen.rs");
    if std::env::var_os("UPDATE").is_some_and(|value| value == "1") {
        fs::write(&place, &code).expect("a file can be written");
    }
    let found = fs::read_to_string(&place).expect("a file can be read");
    assert!(found == code, "tests/src/chosen.rs is stale: {command}");
}

#[test]
fn derivatives_that_are_asked_for_are_those_in_exact_arithmetic() {
    let positions = ["w", "c"].map(|name| {
        let parameters = WhippleChosen::INFO.parameters.iter();
        parameters.enumerate().find(|(_, parameter)| parameter.name == name).expect("a parameter").0
    });
    for number in 0..100 {
        let design = designs::numbered(number);
        let (_, found) = WhippleChosen::from_array(design.to_array()).matrices_and_derivatives();
        for parameter in positions {
            let exact: Matrices<Real> = derivatives(&design, parameter);
            let sizes = derivative_sizes(&design, parameter);
            for (matrix, which) in [(MatrixName::M, 0), (MatrixName::K0, 2)] {
                let found = found.matrix_with_respect_to(matrix, parameter).expect("asked for");
                let exact = exact[which].as_flattened();
                let largest = exact.iter().map(|exact| exact.abs().to_f64()).fold(sizes[which], f64::max);
                for (found, exact) in found.as_flattened().iter().zip(exact) {
                    let error = (Real::from(*found) - *exact).abs().to_f64();
                    assert!(error <= 64.0 * f64::EPSILON * largest, "{matrix:?} by {parameter} of {number}: {error:e}");
                }
            }
            for matrix in [MatrixName::C1, MatrixName::K2] {
                assert_eq!(found.matrix_with_respect_to(matrix, parameter), None);
            }
        }
        assert_eq!(found.matrix_with_respect_to(MatrixName::M, positions[1] + 1), None);
    }
}
