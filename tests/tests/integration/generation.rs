//! The two drivers of the compiler, the macro and the files that are checked in, and the program behind both.

use carvallo::{Model, Number};
use carvallo_compiler::{Driver, compile, expand};
use carvallo_models::Whipple;
use carvallo_tests::designs;
use proc_macro2::TokenStream;
use quote::quote;

/// The model, compiled here by the macro from the source of the one that is checked in.
mod by_macro {
    include!("../../../generated/models/whipple.rs");
}

/// What stands between the braces of the source.
fn declaration() -> TokenStream {
    let source = include_str!("../../../generated/models/whipple.rs");
    let (_, body) = source.split_once('{').expect("an opening brace");
    let (body, _) = body.rsplit_once('}').expect("a closing brace");
    body.parse().expect("tokens")
}

#[test]
fn macro_and_file_give_the_same_bits() {
    for number in 0..2_000 {
        let design = designs::numbered(number);
        let same = by_macro::Whipple::from_array(design.to_array());
        assert_eq!(bits(same.coefficients()), bits(design.coefficients()), "design {number}");
        assert_eq!(derivative_bits(same), derivative_bits(design), "derivatives of design {number}");
        let (same, design) = (same.cast::<f32>(), design.cast::<f32>());
        assert_eq!(bits(same.coefficients()), bits(design.coefficients()), "design {number} as f32");
    }
    assert_eq!(by_macro::Whipple::BENCHMARK.to_array(), Whipple::BENCHMARK.to_array());
    assert_eq!(by_macro::Whipple::BENCHMARK_2005.to_array(), Whipple::BENCHMARK_2005.to_array());
    assert_eq!(<by_macro::Whipple as Model<2>>::INFO, <Whipple as Model<2>>::INFO);
}

fn bits<T: carvallo::Scalar>(matrices: carvallo::Coefficients<T, 2>) -> Vec<u64> {
    let carvallo::Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, .. } = matrices;
    [m, cm1, c0, c1, kc, k0, k1, k2]
        .iter()
        .flat_map(|matrix| matrix.iter().map(|entry| entry.to_f64().to_bits()))
        .collect()
}

fn derivative_bits(design: impl carvallo::Differentiable<2, Scalar = f64>) -> Vec<u64> {
    let (values, derivatives) = design.coefficients_and_derivatives();
    [values].iter().chain(derivatives.as_ref()).flat_map(|coefficients| bits(*coefficients)).collect()
}

#[test]
fn generated_code_does_what_its_program_says() {
    let program = compile(declaration()).expect("the model compiles").programs.matrices;
    for number in 0..200 {
        let design = designs::numbered(number);
        let matrices = design.matrices();
        let rows = [matrices.m, matrices.c1, matrices.k0, matrices.k2];
        let expected: Vec<f64> = rows.into_iter().flatten().flatten().collect();
        let interpreted = program.interpret_with(&design.to_array(), Number::sin_cos);
        assert_eq!(interpreted, expected, "design {number}");
    }
}

#[test]
fn every_run_gives_the_same_code() {
    let drivers = [Driver::Macro { runtime: quote!(::carvallo) }, Driver::File];
    let expand = |driver| expand(declaration(), driver).expect("the model compiles").to_string();
    let first = drivers.each_ref().map(expand);
    // Another model in between changes nothing.
    let other =
        "model Other { parameters { lam: rad, > 0; } coordinates { x: m; } M = [[lam^2*1 [kg] + tan(lam)*2 [kg]]]; }";
    assert!(compile(other.parse().expect("tokens")).is_ok());
    assert_eq!(drivers.each_ref().map(expand), first);
}

#[test]
fn matrices_that_are_left_out_are_zero_and_not_stored() {
    assert_eq!(size_of::<carvallo_models::WhippleMatrices>(), 4 * 4 * size_of::<f64>());
    let coefficients = Whipple::BENCHMARK.coefficients();
    assert_eq!(coefficients.c0, nalgebra::Matrix2::zeros());
    assert_eq!(coefficients.kc, nalgebra::Matrix2::zeros());
}

#[test]
fn parameters_go_to_slices_and_back_in_declared_order() {
    let mut values = [0.0; 26];
    Whipple::BENCHMARK.write_to(&mut values).expect("room for all");
    let info = <Whipple as Model<2>>::INFO;
    let at = |name| values[info.position(name).expect("a parameter")];
    assert_eq!((at("w"), at("lam"), at("mB"), at("IFyy")), (1.02, 0.314_159_265_358_979_3, 85.0, 0.28));
    assert_eq!(Whipple::from_slice(&values), Ok(Whipple::BENCHMARK));
    let error = Whipple::<f64>::from_slice(&values[..3]).expect_err("too short");
    assert_eq!(error.to_string(), "Whipple: 3 values given; it has 26 parameters");
}

#[test]
fn validation_names_parameter_value_and_requirement() {
    let error = |design: Whipple| design.validate().expect_err("it is invalid").to_string();
    let bike = Whipple::BENCHMARK;
    assert_eq!(bike.validate(), Ok(()));
    assert_eq!(error(Whipple { w: -1.0, ..bike }), "Whipple: `w` is -1 m; it must be > 0");
    assert_eq!(error(Whipple { mR: -0.5, ..bike }), "Whipple: `mR` is -0.5 kg; it must be >= 0");
    assert_eq!(error(Whipple { xB: f64::NAN, ..bike }), "Whipple: `xB` is NaN m; it must be finite");
    assert_eq!(error(Whipple { w: f64::INFINITY, ..bike }), "Whipple: `w` is inf m; it must be finite and > 0");
    assert_eq!(
        error(Whipple { lam: 2.0, ..bike }),
        "Whipple: `lam` is 2 rad; it must be > -1.5707963267948966 and < 1.5707963267948966"
    );
    assert_eq!(error(Whipple { mH: 0.0, mF: 0.0, ..bike }), "Whipple: `mH + mF` is 0 kg; it must be > 0");
}

/// The documentation that is generated for a declaration, line by line.
fn documentation(declaration: &str) -> Vec<String> {
    let code = expand(declaration.parse().expect("tokens"), &Driver::File).expect("the model compiles");
    let file = syn::parse2::<syn::File>(code).expect("items");
    let mut found = Documentation::default();
    syn::visit::visit_file(&mut found, &file);
    found.0
}

#[derive(Default)]
struct Documentation(Vec<String>);

impl syn::visit::Visit<'_> for Documentation {
    fn visit_attribute(&mut self, attribute: &syn::Attribute) {
        if let syn::Meta::NameValue(syn::MetaNameValue { path, value, .. }) = &attribute.meta
            && let syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) = value
            && path.is_ident("doc")
        {
            self.0.push(text.value().trim().into());
        }
    }
}

/// Between asterisks and underscores Markdown would emphasize what stands there.
#[test]
fn documentation_has_units_requirements_and_sets_as_code() {
    let found = documentation(
        "model Arm { parameters { I: kg*m^2, > 0; c: N*m*s, >= 0; b: N*m*s; f: 1, in [0.5, 2]; } \
         require c + b > 0; coordinates { q \"swing\": rad; } \
         M = [[I/f]]; C0 = [[c + b]]; set light { I = 1e-9; c = 0.25; b = -1/8; f = 1; } }",
    );
    let expected = [
        "The fields are the parameters. The coordinates are `q` (swing) in `rad`, of which only the rate is a state.",
        "- `c + b` in `kg*m^2/s`: `> 0`.",
        "`I` in `kg*m^2`: `> 0`.",
        "`b` in `N*m*s`: any finite value.",
        "`f` a pure number: `>= 0.5 and <= 2`.",
        "| `I` | 1e-9 | `kg*m^2` |",
        "| `c` | 0.25 | `N*m*s` |",
        "| `b` | -0.125 | `N*m*s` |",
        "| `f` | 1 |  |",
        "M_11 = I/f [kg*m^2]",
        "C0_11 = c + b [kg*m^2/s]",
    ];
    for line in expected {
        assert!(found.iter().any(|known| known == line), "no line reads {line}: {found:#?}");
    }
    let mut fenced = false;
    for line in &found {
        fenced ^= line.starts_with("```");
        let outside: String = line.split('`').step_by(2).collect();
        assert!(fenced || !outside.contains(['*', '_']), "{line}");
    }
}

/// What the program of a formula in one parameter gives at 256.
fn at_256(formula: &str) -> f64 {
    let text =
        format!("model Any {{ parameters {{ x: 1, > 0; }} coordinates {{ q: m; }} M = [[1 [kg]*x*({formula})]]; }}");
    compile(text.parse().expect("tokens")).expect(formula).programs.matrices.interpret(&[256.0])[0] / 256.0
}

/// The values are from arithmetic with 25 digits and more.
#[test]
fn functions_of_numbers_have_their_values() {
    let cases = [
        ("sqrt(sqrt(2))", 1.189_207_115_002_721),
        ("sqrt(3)*sqrt(sqrt(3))", 2.279_507_056_954_777_5),
        ("1/sqrt(sqrt(0.1))", 1.778_279_410_038_922_8),
        ("1/(sqrt(2)*sqrt(sqrt(sqrt(2))))", 0.648_419_777_325_504_8),
        ("sqrt(sqrt(x))", 4.0),
        ("tan(0.3)", 0.309_336_249_609_623_25),
        ("1/tan(2)", -0.457_657_554_360_285_77),
        ("tan((x + 1)^2 - x^2 - 2*x)", 1.557_407_724_654_902_3),
        ("tan(tan(0.3))", 0.319_595_802_917_375_16),
    ];
    for (formula, expected) in cases {
        let computed = at_256(formula);
        assert!((computed - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(), "{formula} is {computed}");
    }
}

#[test]
fn the_documented_declarations_compile() {
    let docs = include_str!("../../../runtime/src/model/declare.rs");
    let blocks = docs.split("```text\n").skip(1).filter_map(|rest| rest.split("/// ```").next());
    // Others are statements alone.
    let compiled = blocks.filter(|block| block.contains("pub model ")).map(|block| {
        let text: Vec<&str> = block.lines().map(|line| line.strip_prefix("/// ").unwrap_or_default()).collect();
        let tokens: TokenStream = text.join("\n").parse().expect("tokens");
        compile(tokens).map_err(|error| error.to_string()).expect("the example is right")
    });
    let shapes = compiled.map(|compiled| (compiled.model.parameters.len(), compiled.model.coordinates.len()));
    assert_eq!(shapes.collect::<Vec<_>>(), [(5, 1), (15, 3), (1, 1)]);
}
