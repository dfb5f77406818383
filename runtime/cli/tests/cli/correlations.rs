//! Parameters whose measurements vary together.

use serde_json::Value;

use crate::{BENCHMARK, Directory};

/// The benchmark with a deviation of two masses and the trail, and these correlations.
fn file(correlations: &str) -> String {
    let text = BENCHMARK
        .replace("mB = 85\n", "mB = { value = 85, std = 2 }\n")
        .replace("mH = 4\n", "mH = { value = 4, std = 0.5 }\n")
        .replace("c = 0.08\n", "c = { value = 0.08, std = 0.01 }\n");
    format!("{text}\n[correlations]\n{correlations}")
}

fn weave(json: &Value) -> &Value {
    json["critical_speeds"].as_array().unwrap().iter().find(|critical| critical["kind"] == "weave").unwrap()
}

/// The standard deviation of the weave speed, and its derivatives by each of the three times the deviation of that.
fn of_weave(json: &Value) -> (f64, [f64; 3]) {
    let weave = weave(json);
    let of = |(name, deviation): (&str, f64)| weave["derivatives"][name].as_f64().unwrap() * deviation;
    (weave["standard_deviation"].as_f64().unwrap(), [("mB", 2.0), ("mH", 0.5), ("c", 0.01)].map(of))
}

/// Of a sum of three, var = a^2 + b^2 + c^2 + 2 r ab + 2 s bc.
#[test]
fn variances_have_their_mixed_terms() {
    let directory = Directory::of_this_test();
    directory.write("both.toml", file("mH = { mB = 0.6, c = -0.5 }\n"));
    directory.write("all.toml", file("mH = { mB = 1 }\n"));
    directory.write("against.toml", file("mB = { mH = -1.0 }\n"));
    let run = |name: &str| of_weave(&directory.run(&["sensitivity", name, "--format", "json"]).json());
    let assert_close =
        |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    let (found, [a, b, c]) = run("both.toml");
    assert_close(found, (a * a + b * b + c * c + 2.0 * 0.6 * a * b - 2.0 * 0.5 * b * c).sqrt());
    assert_close(run("all.toml").0, (a + b).hypot(c));
    assert_close(run("against.toml").0, (a - b).hypot(c));
    let json = directory.run(&["sensitivity", "both.toml", "--format", "json"]).json();
    let shares = weave(&json)["variance_shares"].as_object().unwrap();
    assert_close(shares["mB"].as_f64().unwrap(), (a * a + 0.6 * a * b) / (found * found));
    assert_close(shares.values().map(|share| share.as_f64().unwrap()).sum(), 1.0);
    // mT zT is K0[0][0] = zB mB + zH mH + …; of the mass matrix, M[0][0] = … + mB zB^2 + mH zH^2.
    let of_mass = json["matrix_standard_deviations"]["M"][0][0].as_f64().unwrap();
    let [p, q]: [f64; 2] = [0.81 * 2.0, 0.49 * 0.5];
    assert_close(of_mass, (p * p + q * q + 2.0 * 0.6 * p * q).sqrt());
    let table = directory.run(&["sensitivity", "both.toml"]).ok();
    assert!(table.contains("from those of 3 of 26 parameters, with their correlations"), "{table}");
}

#[test]
fn files_are_written_with_them() {
    let directory = Directory::of_this_test();
    directory.write("both.toml", file("mH = { mB = 0.6, c = -0.5 }\n"));
    let shown = directory.run(&["show", "both.toml"]).ok();
    assert!(shown.ends_with("\n[correlations]\nmH = { c = -0.5, mB = 0.6 }\n"), "{shown}");
    directory.write("shown.toml", shown);
    let [given, again] = ["both.toml", "shown.toml"].map(|name| {
        let json = directory.run(&["sensitivity", name, "--format", "json"]);
        of_weave(&json.json()).0
    });
    assert_eq!(given, again);
    let json = directory.run(&["sensitivity", "both.toml", "--format", "json"]).ok();
    directory.write("result.json", &json);
    let again = directory.run(&["sensitivity", "result.json", "--format", "json"]).json();
    assert_eq!(again["correlations"], serde_json::from_str::<Value>(&json).unwrap()["correlations"]);
    assert_eq!(of_weave(&again).0, given);
}

/// What replaces a measurement does not vary with others as that did.
#[test]
fn settings_are_by_themselves() {
    let directory = Directory::of_this_test();
    directory.write("both.toml", file("mH = { mB = 0.6, c = -0.5 }\n"));
    let shown = directory.run(&["show", "both.toml", "--set", "mB=90+-2"]).ok();
    assert!(shown.ends_with("\n[correlations]\nmH = { c = -0.5 }\n"), "{shown}");
    let shown = directory.run(&["show", "both.toml", "--set", "mH=5"]).ok();
    assert!(!shown.contains("[correlations]"), "{shown}");
}

/// Of 4,000 bicycles that are drawn as they were measured, the critical speeds are as far apart as propagation says to first order:
/// within five standard errors, and 2 % for what is beyond.
#[test]
fn measured_bicycles_are_drawn_with_them() {
    let directory = Directory::of_this_test();
    directory.write("mine.toml", directory.run(&["measure", "--example"]).ok());
    directory.write("bicycle.toml", directory.run(&["measure", "mine.toml"]).stdout);
    let json = directory.run(&["sensitivity", "bicycle.toml", "--format", "json"]).stdout;
    let json: Value = serde_json::from_str(&json).unwrap();
    let sweep = directory.run(&["sweep", "bicycle.toml", "--random", "measured", "--samples", "4000"]).stdout;
    let mut rows = sweep.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let column = rows.next().unwrap().iter().position(|name| *name == "weave_1").unwrap();
    let speeds: Vec<f64> = rows.map(|row| row[column].parse().unwrap()).collect();
    let count: f64 = 4000.0;
    assert_eq!(speeds.len(), 4000);
    let mean = speeds.iter().sum::<f64>() / count;
    let deviation = (speeds.iter().map(|speed| (speed - mean).powi(2)).sum::<f64>() / count).sqrt();
    let expected = weave(&json)["standard_deviation"].as_f64().unwrap();
    assert!((mean - weave(&json)["speed"].as_f64().unwrap()).abs() < 5.0 * expected / count.sqrt() + 0.02 * expected);
    assert!((deviation / expected - 1.0).abs() < 5.0 / (2.0 * count).sqrt() + 0.02, "{deviation}, not {expected}");
    let none = directory.run(&["sweep", "--random", "measured", "--samples", "10"]);
    assert_eq!(none.code, Some(2));
    let message = "error: --random measured: none of the parameters of benchmark has a standard deviation\n";
    assert_eq!(none.stderr, message);
}

#[test]
fn mistakes_are_told_at_their_place() {
    let directory = Directory::of_this_test();
    let assert_error = |correlations: &str, message: &str| {
        directory.write("wrong.toml", file(correlations));
        let run = directory.run(&["show", "wrong.toml"]);
        assert_eq!(run.code, Some(2), "{}", run.stdout);
        assert!(run.stderr.contains(message), "{}", run.stderr);
    };
    let line = file("").lines().count() + 1;
    let at = |message: &str| format!("error: wrong.toml:{line}: {message}");
    assert_error("mB = { mH = 1.5 }", &at("the correlation of `mB` and `mH` is 1.5; it must be between -1 and 1"));
    assert_error(
        "mB = { mH = \"much\" }",
        &at("the correlation of `mB` and `mH` is `much`; expected a number between -1"),
    );
    assert_error("mB = 0.5", &at("`mB` has no correlations with others, such as `mB = { w = 0.5 }`"));
    assert_error("mB = { IBxy = 0.5 }", &at("`IBxy` is not a parameter of Whipple; did you mean `IBxx`?"));
    assert_error("mB = { mB = 0.5 }", &at("the correlation of `mB` and `mB` is 0.5; only that with another"));
    assert_error("mB = { mH = 0.9 }\nmH = { mB = 0.8 }", "the correlation of `mH` and `mB` is 0.8, and elsewhere 0.9");
    assert_error(
        "mB = { mH = 0.9, c = 0.9 }\nmH = { c = -0.9 }",
        &format!("wrong.toml:{}: `mH` cannot be correlated so with others", line + 1),
    );
}
