//! Models larger than anyone writes: they compile, or are refused, without exhausting the stack.

use carvallo_compiler::{check, compile};
use proc_macro2::TokenStream;

/// A model of one coordinate, unless the statements have others, by its parameters, statements and mass matrix.
fn model(parameters: &str, statements: &str, mass: &str) -> TokenStream {
    let coordinates = if statements.contains("coordinates") { "" } else { "coordinates { q: m; }" };
    let text = format!("model X {{ parameters {{ {parameters} }} {statements} {coordinates} M = {mass}; }}");
    text.parse().expect("tokens")
}

/// The only entry of the mass matrix.
fn entry(parameters: &str, statements: &str, formula: &str, values: &[f64]) -> f64 {
    let compiled = compile(model(parameters, statements, &format!("[[{formula}]]"))).expect("it has no mistakes");
    compiled.programs.matrices.interpret(values)[0]
}

fn mistakes(declaration: TokenStream) -> Vec<String> {
    let error = check(declaration).expect_err("it has mistakes");
    error.into_iter().map(|error| error.to_string()).collect()
}

#[test]
fn deep_nesting_compiles_up_to_a_limit_and_is_refused_beyond() {
    let nested = |open: &str, depth| format!("{}m{}", open.repeat(depth), ")".repeat(depth));
    assert_eq!(entry("m: kg;", "", &nested("(", 128), &[3.0]), 3.0);
    assert_eq!(entry("m: 1;", "", &format!("{}*1 [kg]", nested("sqrt(", 100)), &[1.0]), 1.0);
    for (open, depth) in [("(", 129), ("sin(", 200)] {
        let found = mistakes(model("m: kg;", "", &format!("[[{}]]", nested(open, depth))));
        assert_eq!(found, ["nested too deeply: expected at most 128 levels"], "{depth} {open}");
    }
    for (open, close) in [("(", ")"), ("[", "]"), ("{", "}")] {
        let found = mistakes(model("m: kg;", "", &format!("{}m{}", open.repeat(20_000), close.repeat(20_000))));
        assert_eq!(found, ["brackets nested too deeply: expected at most 256 levels"], "{open}");
    }
}

#[test]
fn long_formulas_compile() {
    assert_eq!(entry("m: kg;", "", &vec!["m"; 20_000].join(" + "), &[3.0]), 60_000.0);
    assert_eq!(entry("m: kg;", "", &format!("{}m", "-".repeat(100_001)), &[3.0]), -3.0);
    assert!(check(model("m: kg;", "", &format!("[[{}]]", vec!["m"; 100_000].join(" + ")))).is_ok());
}

/// The cube of a tangent of sums has 360,000 terms by the addition theorems.
#[test]
fn tangents_of_tangents_end() {
    let definitions = "let a = 3*x + 3.001 + x^2; let b = 4*a + 1/(2*a); let c = 4*x + x^2 + tan(b);";
    let found = entry("x: 1, < 1;", definitions, "1 [kg]*tan(c^3*x)", &[0.5]);
    let a: f64 = 1.5 + 3.001 + 0.25;
    let c = 2.25 + (4.0 * a + 0.5 / a).tan();
    let expected = (c.powi(3) * 0.5).tan();
    assert!((found - expected).abs() < 1e-9 * expected.abs(), "{found} instead of {expected}");
}

#[test]
fn many_parameters_definitions_and_coordinates_compile() {
    let names: Vec<String> = (0..1_000).map(|index| format!("p{index}")).collect();
    let parameters: String = names.iter().map(|name| format!("{name}: kg, >= 0; ")).collect();
    let values: Vec<f64> = (0..1_000).map(f64::from).collect();
    assert_eq!(entry(&parameters, "", &names.join(" + "), &values), 499_500.0);

    let definitions: String = (1..500).map(|index| format!("let d{index} = d{}/2 + m; ", index - 1)).collect();
    let expected = (1..500).fold(2.0, |value, _| value / 2.0 + 2.0);
    let found = entry("m: kg;", &format!("let d0 = m; {definitions}"), "d499", &[2.0]);
    assert!((found - expected).abs() < 1e-12, "{found} instead of {expected}");

    let coordinates: String = (0..64).map(|index| format!("q{index}: m; ")).collect();
    let row = |row| (0..64).map(|column| if row == column { "m" } else { "0" }).collect::<Vec<_>>().join(", ");
    let rows: Vec<String> = (0..64).map(|index| format!("[{}]", row(index))).collect();
    let mass = format!("[{}]", rows.join(", "));
    let compiled = compile(model("m: kg;", &format!("coordinates {{ {coordinates} }}"), &mass)).expect("no mistakes");
    let identity = nalgebra::DMatrix::<f64>::identity(64, 64);
    assert_eq!(compiled.programs.matrices.interpret(&[1.0]), identity.as_slice());
}

#[test]
fn thousands_of_mistakes_are_all_reported() {
    let found = mistakes(model("m: kg;", "", &format!("[[m + {}]]", vec!["length"; 3_000].join(" + "))));
    assert!(found.iter().all(|text| text == "unknown name `length`: expected a parameter or a definition"));
    assert_eq!(found.len(), 3_000);
}
