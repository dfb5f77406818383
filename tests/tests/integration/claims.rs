//! What declarations claim, what their divisors and roots need, and what becomes of both.

use carvallo::Model;
use carvallo_compiler::{Driver, compile, expand};

/// A model of two coordinates with the given statements; its parameters are numbers a, b > 0 and c, angles t and s, the
/// latter less than a right angle.
fn model(statements: &str) -> String {
    let parameters = "a: 1, > 0; b: 1, > 0; c: 1; t: rad; s: rad, in (-pi/2, pi/2);";
    let used = "C0 = [[a + b + c, t], [s, 0]];";
    let mass = if statements.contains("M =") { "" } else { "M = [[1, 0], [0, 1]];" };
    let statements = in_units(&format!("{used} {mass} {statements}"));
    format!("model Sample {{ parameters {{ {parameters} }} coordinates {{ x: m; y: m; }} {statements} }}")
}

/// The statements with the entries of the matrices, which are numbers, in the units that they must have.
fn in_units(statements: &str) -> String {
    let units = [("M", "kg"), ("C0", "kg/s"), ("Kc", "N/m"), ("K0", "kg/m"), ("K2", "kg/m^2")];
    let statements = statements.split_inclusive(';').map(|statement| {
        let matrix = statement.split_once(" = [[").and_then(|(name, rest)| Some((name, rest.strip_suffix("]];")?)));
        let Some((before, rows)) = matrix else { return statement.to_string() };
        let (_, unit) = units.iter().find(|(name, _)| before.ends_with(name)).expect("a matrix");
        let entry = |entry: &str| format!("({entry})*1 [{unit}]");
        let row = |row: &str| format!("[{}]", row.split(", ").map(entry).collect::<Vec<_>>().join(", "));
        format!("{before} = [{}];", rows.split("], [").map(row).collect::<Vec<_>>().join(", "))
    });
    statements.collect()
}

fn mistakes(statements: &str) -> Vec<String> {
    match compile(model(statements).parse().expect("tokens")) {
        Ok(_) => Vec::new(),
        Err(errors) => errors.into_iter().map(|error| error.to_string()).collect(),
    }
}

/// The requirements of the model, as text and as what they ask for.
fn requirements(statements: &str) -> Vec<String> {
    let compiled = compile(model(statements).parse().expect("tokens")).expect("no mistakes");
    compiled.model.requirements.iter().map(|r| format!("{}: {}", r.text, r.domain)).collect()
}

#[test]
fn claims_that_hold_are_proved() {
    for claims in [
        "assert (a + b)^2 == a^2 + 2*a*b + b^2;",
        "assert 0.1*3 == 0.3; assert a/2 == 0.5*a;",
        "assert 1/a + 1/b == (a + b)/(a*b);",
        "assert tan(t)*cos(t) == sin(t); assert 1/cos(s)^2 == 1 + tan(s)^2;",
        "assert sin(2*t) == 2*sin(t)*cos(t); assert cos(3*t) == 4*cos(t)^3 - 3*cos(t);",
        "assert cos(t - s) == cos(t)*cos(s) + sin(t)*sin(s); assert sin(t/2)*cos(t/2) == sin(t)/2; assert cos(t/3 + t/6)^2 == (1 + cos(t))/2;",
        "assert sin(s + t/2 + s) == sin(2*s)*cos(t/2) + cos(2*s)*sin(t/2);",
        "assert sin(t + pi/2) == cos(t); assert tan(pi - t) == -tan(t);",
        "assert sqrt(a)^2 == a; assert sqrt(a + b)^3 == (a + b)*sqrt(a + b);",
        "let mu = (c/a)*cos(t); let nu = mu^2; assert mu*a == c*cos(t); assert nu*a^2 == c^2*(1 - sin(t)^2);",
        "symmetric M = [[a, c + t/2], [0.5*t + c, b]];",
        "symmetric M = [[a, tan(t)], [sin(t)/cos(t), b]]; symmetric K2 = [[0, c], [c, 0]];",
    ] {
        assert_eq!(mistakes(claims), [""; 0], "{claims}");
    }
}

#[test]
fn what_is_nearly_an_identity_is_refuted() {
    for claim in [
        "sin(t + s) == sin(t)*cos(s) - cos(t)*sin(s)",
        "cos(t + s) == cos(t)*cos(s) + sin(t)*sin(s)",
        "cos(2*t) == 2*cos(t)^2",
        "sin(-t) == sin(t)",
        "sin(3*t) == 3*sin(t) + 4*sin(t)^3",
        "sin(t + pi) == sin(t)",
        "cos(t - pi/2) == -sin(t)",
        "tan(pi/2 + t) == 1/tan(t)",
        "sin(t/2)*cos(t/2) == sin(t)",
        "sqrt(a)^3 == a",
        "sqrt(a + b) == sqrt(a) + sqrt(b)",
        "0.1 + 0.2 == 0.300000000001",
    ] {
        let found = mistakes(&format!("assert {claim};"));
        assert!(found.len() == 1 && found[0].starts_with("the sides differ: "), "{claim}: {found:?}");
    }
}

#[test]
fn every_wrong_claim_is_refuted_with_values_for_which_it_is_wrong() {
    let found = mistakes("assert c*a == c; assert a + b == b + a; symmetric M = [[a, c], [2*c, b]]; assert a == 2*a;");
    assert_eq!(found.len(), 3, "{found:?}");
    let at = |text: &str, name: &str| -> f64 {
        let (_, values) = text.split_once(" at ").expect("values of parameters");
        let (values, _) = values.split_once("; expected").expect("what is expected");
        let value = values.split(", ").find_map(|pair| pair.strip_prefix(name)?.strip_prefix(" = "));
        value.expect("a value of the parameter").parse().expect("a number")
    };
    // In the order of the source.
    let (a, c) = (at(&found[0], "a"), at(&found[0], "c"));
    assert!(found[0].contains(&format!("`c*a` is {} and `c` is {c}", c * a)), "{found:?}");
    assert!(a * c != c && a > 0.0, "{found:?}");
    let c = at(&found[1], "c");
    let [above, below] = [c, 2.0 * c];
    let entries = format!("row 2, column 1 is {below} and row 1, column 2 is {above} at c = {c};");
    assert!(found[1].contains(&entries), "{found:?}");
    assert!(found[2].contains(&format!("`2*a` is {}", 2.0 * at(&found[2], "a"))), "{found:?}");
    assert!(!found[2].contains("b ="), "{found:?}");

    let found = mistakes("require c - 10 > 0; require c - b < 1; assert c == 10 + b;");
    let (b, c) = (at(&found[0], "b"), at(&found[0], "c"));
    assert!(c > 10.0 && b > 0.0 && c - b < 1.0 && c != 10.0 + b, "{found:?}");

    let set = "set known { a = 3; b = 4; c = 0.25; t = 0; s = 0; }";
    let found = mistakes(&format!("{set} assert a + c == b;"));
    assert_eq!(
        found,
        ["the sides differ: `a + c` is 3.25 and `b` is 4 in the set `known`, at a = 3, b = 4, c = 0.25; expected the \
          same value for all parameters"]
    );
}

#[test]
fn claims_that_are_true_beyond_the_known_rules_are_not_called_wrong() {
    for claim in ["assert sqrt(a^2) == a;", "assert sqrt(a*b) == sqrt(a)*sqrt(b);"] {
        let found = mistakes(claim);
        assert_eq!(found.len(), 1, "{claim}: {found:?}");
        let tried = "the sides could not be proved equal, and 1000 sets of values that were tried show no difference";
        assert!(found[0].starts_with(tried), "{claim}: {found:?}");
    }
    // Of the same kind, and wrong for some parameters.
    assert!(mistakes("assert sqrt(c^2) == c;")[0].starts_with("the sides differ: `sqrt(c^2)` is 1 and `c` is -1"));
}

#[test]
fn claims_about_deep_definitions_come_to_an_end() {
    let chain = |name: &str| {
        let step = |n: usize| format!("let {name}{n} = ({name}{0} + {name}{0}^2)/(2 + a);", n - 1);
        let rest: String = (1..60).map(step).collect();
        format!("let {name}0 = c*sin(t); {rest}")
    };
    let both = format!("{}{}", chain("d"), chain("e"));
    assert_eq!(
        mistakes(&format!("{both} assert d59*(2 + a) == d58*(1 + d58); assert e59*(2 + a) == e58 + e58^2;")),
        [""; 0]
    );
    let found = mistakes(&format!("{both} assert d59 == e59;"));
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(
        found[0].ends_with("the formulas grow too long when they are expanded; expected a shorter claim"),
        "{found:?}"
    );
}

#[test]
fn names_in_assertions_are_not_used() {
    let parameters = "m: kg, > 0; spare: kg, > 0, unused;";
    let text = format!(
        "model Sample {{ parameters {{ {parameters} }} coordinates {{ x: m; }} let twice = 2*spare; M = [[m]]; \
         assert twice/2 == spare; }}"
    );
    let compiled = compile(text.parse().expect("tokens")).expect("no mistakes");
    assert_eq!(compiled.model.parameters.iter().map(|p| p.used).collect::<Vec<_>>(), [true, false]);
}

#[test]
fn what_domains_and_requirements_exclude_needs_nothing_more() {
    for statements in [
        "M = [[1/a, 1/(a*b)], [1/(a + b), 1/(a^2 + c^2)]];",
        "M = [[1/(1 + c*c), tan(s)], [1/cos(s), 1/(2 + sin(s))]];",
        "M = [[sqrt(a), sqrt(a + c^2)], [1/sqrt(a), 1/sqrt(1 + t^2)]];",
        "let d = a + b; let e = d*a^2; M = [[1/d, 1/e^3], [1/(e*d), sqrt(e)]];",
    ] {
        assert_eq!(requirements(statements), [""; 0], "{statements}");
    }
    for (requirement, matrix) in [
        ("a - b: > 0", "[[1/(a - b), sqrt(a - b)], [1/(b - a), 1/(2*a - 2*b)^2]]"),
        ("a - b: not 0", "[[1/(a - b), 1/(2*(b - a))], [1/((a - b)*a), 1/(4*a - b*4)]]"),
        ("c: not 0", "[[1/c, 1/c^2], [1/-c, c^(-3)]]"),
        ("b - a: <= 0", "[[sqrt(a - b), sqrt(2*a - b*2)], [1, 1]]"),
    ] {
        let written = requirement.replace(": not 0", " != 0").replace(':', "");
        let statements = format!("require {written}; M = {matrix};");
        assert_eq!(requirements(&statements), [requirement], "{statements}");
    }
}

#[test]
fn what_nobody_excludes_is_required_once_and_before_what_depends_on_it() {
    let cases = [
        ("M = [[1/(a - b), 2/(b - a)], [c/(a - b)^2, 1]];", vec!["a - b: not 0"]),
        // Not zero inside the domain, but in f64 it is, at the last angles before the right one.
        ("M = [[1/(1 + sin(s)), 0], [0, 1]];", vec!["1 + sin(s): not 0"]),
        // A third of what is not zero can be in f64.
        ("require a - b != 0; M = [[1/(3*a - 3*b), 0], [0, 1]];", vec!["3*a - 3*b: not 0", "a - b: not 0"]),
        ("M = [[1/(1 - 1/c), tan(t)], [1, 1]];", vec!["c: not 0", "1 - 1/c: not 0", "cos(t): not 0"]),
        ("let d = a - 0.5; M = [[1/(d*c), sqrt(d)], [1, 1]];", vec!["a - 0.5: not 0", "c: not 0", "a - 0.5: >= 0"]),
        ("require 1/(a - b) > 0; M = [[1/c, 0], [0, 1]];", vec!["c: not 0", "a - b: not 0", "1/(a - b): > 0"]),
        ("M = [[1/sin(t), 0], [0, 1/(1 + cos(t))]];", vec!["sin(t): not 0", "1 + cos(t): not 0"]),
    ];
    for (statements, expected) in cases {
        assert_eq!(requirements(statements), expected, "{statements}");
    }
}

#[test]
fn a_root_of_what_is_always_negative_is_a_mistake() {
    let found = mistakes("M = [[sqrt(-1 - c^2), 0], [0, 1]];");
    assert_eq!(found, ["the square root of a negative number here: expected one of a number >= 0"]);
    assert_eq!(requirements("M = [[sqrt(1 - c^2), 0], [0, 1]];"), ["1 - c^2: >= 0"]);
}

#[test]
fn a_divisor_that_is_always_zero_is_a_mistake_however_deep_it_hides() {
    for statements in [
        "let d = sin(t)^2 + cos(t)^2 - 1; M = [[c/d, 0], [0, 1]];",
        "let d = a - b; let e = d*(a + b); let f = e - a^2 + b^2; M = [[1, 0], [c/(f*a), 1]];",
        "require c/(sin(2*t) - 2*sin(t)*cos(t)) > 0;",
    ] {
        let expected = "a division by zero here: expected divisors that are not zero for all parameters";
        assert_eq!(mistakes(statements), [expected], "{statements}");
    }
}

carvallo::model! {
    /// A mass on a lever between two springs.
    model Lever {
        parameters {
            m: kg, > 0;
            a: m, > 0;
            b: m, > 0;
            k: N/m, != 0;
            turn: rad, in [-1, 1], != 0;
        }
        let arm = a - b;
        coordinates { x: m; y: m; }
        symmetric M = [[2*m, arm*m/b], [(m*a - m*b)/b, m]];
        Kc = [[k*b/arm, k*sqrt(b - a/2)/sqrt(b)], [1 [N^2/m^2]/k, k/sin(turn)]];
        assert arm + b == a;
        assert sin(2*turn) == 2*sin(turn)*cos(turn);
        set level { m = 1; a = 2; b = 1; k = -3; turn = 0.5; }
    }
}

#[test]
fn validation_refuses_what_has_no_value() {
    let error = |lever: Lever| lever.validate().expect_err("it is refused").to_string();
    let lever = Lever::LEVEL;
    assert_eq!(lever.validate(), Ok(()));
    assert_eq!(lever.matrices().kc, [[-3.0, 0.0], [-1.0 / 3.0, -3.0 / f64::sin(0.5)]]);
    assert_eq!(error(Lever { b: 2.0, ..lever }), "Lever: `a - b` is 0 m; it must not be 0");
    assert_eq!(error(Lever { b: 0.5, ..lever }), "Lever: `b - a/2` is -0.5 m; it must be >= 0");
    assert_eq!(error(Lever { k: 0.0, ..lever }), "Lever: `k` is 0 N/m; it must not be 0");
    assert_eq!(error(Lever { k: f64::INFINITY, ..lever }), "Lever: `k` is inf N/m; it must be finite and not 0");
    assert_eq!(error(Lever { turn: 0.0, ..lever }), "Lever: `turn` is 0 rad; it must be >= -1 and <= 1 and not 0");
}

#[test]
fn the_documentation_says_what_is_proved_and_what_is_refused() {
    let statements = "symmetric M = [[a, c], [c, b]]; K0 = [[1/(a - b), sqrt(c)], [0, 1/a]]; require 1/t > 0;";
    let code = expand(model(statements).parse().expect("tokens"), &Driver::File).expect("no mistakes").to_string();
    for text in [
        "Mass matrix M, the coefficient of q''. Symmetric, proved.",
        "Stiffness K0, a coefficient of g q.\"",
        "- divides by `a - b`, which the declared domains do not keep from zero;",
        "- takes the root of `c`, which the declared domains do not keep from being negative.",
    ] {
        assert!(code.contains(text), "{text}");
    }
    // Only a requirement divides by it.
    assert!(!code.contains("divides by `t`"));
}
