use super::expression::Expression;
use super::formula::Formula;
use super::latex::Latex;
use super::markup::{Markup, Writer};
use super::typst::Typst;

fn write(markup: impl Markup, text: &str) -> String {
    let symbol = |name: &str| (name == "angle").then_some("λ_s");
    let formula = Formula::parse(text).unwrap_or_else(|| panic!("{text} is a formula"));
    Writer { markup, symbol: &symbol }.lines(&formula).join(" | ")
}

/// What stands behind a sign, below a line or under an exponent is all of what the declaration has there.
#[test]
fn formulas_keep_their_meaning() {
    let cases = [
        ("a - (b - c)", "a - (b - c)", "a - (b - c)"),
        ("-a*b + c", "-a b + c", "-a b + c"),
        ("a + (-b*c)", "a + (-b c)", "a + (-b c)"),
        ("a/b*c/d", "\\frac{a c}{b d}", "frac(a c, b d)"),
        ("a/(b*c)", "\\frac{a}{b c}", "frac(a, b c)"),
        ("1/(a + b)", "\\frac{1}{a + b}", "frac(1, a + b)"),
        ("(a + b)^2*c", "(a + b)^2 c", "(a + b)^2 c"),
        ("(a/b)^-2", "\\left(\\frac{a}{b}\\right)^{-2}", "(frac(a, b))^(-2)"),
        ("-a^2", "-a^2", "-a^2"),
        ("2*3*a", "2 \\cdot 3 a", "2 dot 3 a"),
        ("2*(1/2)*a", "2 \\cdot \\frac{1}{2} a", "2 dot frac(1, 2) a"),
        ("sin(a + b)^2", "\\sin^2 (a + b)", "sin^2 (a + b)"),
        ("sqrt(a/b)", "\\sqrt{\\frac{a}{b}}", "sqrt(frac(a, b))"),
        ("1.5e-7*tan(2*x)", "1.5 \\cdot 10^{-7} \\tan (2 x)", "1.5 dot 10^(-7) tan (2 x)"),
        ("0.1 [kg*m^2/s]", "0.1\\,\\mathrm{kg\\,m^{2}/s}", "0.1 thin \"kg\" thin \"m\"^2\"/\"\"s\""),
    ];
    for (text, latex, typst) in cases {
        assert_eq!(write(Latex, text), latex, "{text}");
        assert_eq!(write(Typst, text), typst, "{text}");
    }
}

#[test]
fn names_are_letters_with_indices_or_words() {
    let cases = [
        ("IBxx", "I_{Bxx}", "I_(B x x)"),
        ("angle", "\\lambda_s", "lambda_s"),
        ("mu", "\\mu", "mu"),
        ("deltaF", "\\delta_F", "delta_F"),
        ("kθ", "k_{\\theta}", "k_theta"),
        ("theta1", "\\theta_1", "theta_1"),
        ("mus", "\\mathrm{mus}", "\"mus\""),
        ("Jxz_delta", "J_{xz\\,\\delta}", "J_(x z thin delta)"),
        ("yaw_by_delta", "\\mathrm{yaw}_{\\mathrm{by}\\,\\delta}", "\"yaw\"_(\"by\" thin delta)"),
        ("l1", "l_1", "l_1"),
        ("pi", "\\pi", "pi"),
    ];
    for (name, latex, typst) in cases {
        assert_eq!(write(Latex, name), latex, "{name}");
        assert_eq!(write(Typst, name), typst, "{name}");
    }
    // A word runs into no letter beside it.
    assert_eq!(write(Latex, "3*load*a/2"), "\\frac{3\\,\\mathrm{load}\\,a}{2}");
}

#[test]
fn long_sums_have_several_lines() {
    let terms: Vec<String> = (1..=20).map(|index| format!("a{index}*b{index}")).collect();
    let lines = write(Latex, &terms.join(" - "));
    assert_eq!(lines.split(" | ").count(), 3, "{lines}");
    assert_eq!(lines.replace("| ", ""), lines.replace(" | ", " "));
    assert!(lines.split(" | ").skip(1).all(|line| line.starts_with("- ")), "{lines}");
}

#[test]
fn what_is_no_formula_is_none() {
    for text in ["", "a +", "(a", "a b", "f(a", "2 [kg", "a^b", "a)"] {
        assert_eq!(Formula::parse(text), None, "{text}");
    }
}

#[test]
fn what_is_written_is_read_as_the_same_formula() {
    let texts = [
        "a - (b - c)",
        "-a*b + c",
        "a + (-b*c)",
        "a/b*c/d",
        "a/(b*c)",
        "1/(a + b)",
        "(a + b)^2*c",
        "(a/b)^-2",
        "-a^2",
        "(-a)^2",
        "2*(1/2)*a",
        "sin(a + b)^2",
        "1.5e-7*tan(2*x)",
        "0.1 [kg*m^2/s]*a",
    ];
    for text in texts {
        let formula = Formula::parse(text).unwrap_or_else(|| panic!("{text} is a formula"));
        assert_eq!(formula.to_string(), text);
        assert_eq!(Formula::parse(&formula.to_string()), Some(formula));
    }
}

/// The value with a = 2 and b = 3 for parameters and c = 5 for a definition.
fn value(text: &str) -> Option<f64> {
    let name = |name: &str| match name {
        "a" => Some(Expression::Parameter(0)),
        "b" => Some(Expression::Parameter(1)),
        "c" => Some(Expression::Definition(0)),
        _ => None,
    };
    Expression::new(&Formula::parse(text)?, &name)?.evaluate(&[2.0, 3.0], &[5.0])
}

#[test]
fn formulas_have_the_values_of_their_text() {
    for (text, expected) in [
        ("a + b*c", 17.0),
        ("(a + b)*c", 25.0),
        ("a - b - c", -6.0),
        ("a/b/c", 2.0 / 15.0),
        ("-a^2", -4.0),
        ("a*-b^-1", -2.0 / 3.0),
        ("(a + b)^-1", 0.2),
        (" - b + 0.5", -2.5),
        ("2*a1", f64::NAN),
        ("sqrt(a*8) + sin(0) + cos(0) + tan(0)", 5.0),
        ("2e-1*a", 0.4),
        ("--a", 2.0),
        ("a^0", 1.0),
    ] {
        assert_eq!(value(text).unwrap_or(f64::NAN).to_bits(), expected.to_bits(), "{text}");
    }
    assert_eq!(value("cos(pi)"), Some(-1.0));
}

#[test]
fn what_is_no_formula_has_no_value() {
    for text in ["", "a +", "a b", "(a", "a)", "a^b", "unknown", "exp(a)", "a^0.5", "1.2.3", "a # b", "()", "*a"] {
        assert_eq!(value(text), None, "{text}");
    }
}
