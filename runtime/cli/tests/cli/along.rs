//! Stability along another parameter than the speed.

use serde_json::Value;

use crate::Directory;

/// The critical values of an analysis: kind, value and the imaginary part of the eigenvalue.
fn critical(analysis: &Value) -> Vec<(String, f64, f64)> {
    let event = |event: &Value| {
        let number = |value: &Value| value.as_f64().unwrap();
        (event["kind"].as_str().unwrap().to_owned(), number(&event["value"]), number(&event["eigenvalue"]["im"]))
    };
    analysis["critical_values"].as_array().unwrap().iter().map(event).collect()
}

/// At a critical value of any parameter the speed is a critical one, which two coordinates have from exact polynomials.
#[test]
fn a_critical_value_makes_the_speed_critical() {
    let directory = Directory::new("along-speed");
    for (along, count) in [("g=1:20", 2), ("lam=5 deg:40 deg", 2), ("mF=0.5:30", 1), ("w=0.8:3", 1)] {
        let analysis = directory.run(&["analyze", "--along", along, "--speed", "5", "--format", "json"]).json();
        let found = critical(&analysis);
        assert!(found.len() >= count, "{along}: {found:?}");
        let name = along.split('=').next().unwrap();
        for (kind, value, _) in found {
            let set = format!("{name}={value:?}");
            let at_speed = directory.run(&["analyze", "--set", &set, "--format", "json"]).json();
            let speeds = at_speed["critical_speeds"].as_array().unwrap();
            let is_there =
                |event: &Value| event["kind"] == kind.as_str() && (event["speed"].as_f64().unwrap() - 5.0).abs() < 1e-9;
            assert!(speeds.iter().any(is_there), "{set}: {kind} in {speeds:?}");
        }
    }
}

/// Unstable beyond `(1 + c_e / c_i) sqrt(k / m)`, at a speed of the surface of R times that: for the stiffness `k` and the
/// internal damping in closed form.
#[test]
fn the_threshold_of_a_rotor_is_that_of_the_closed_form() {
    let directory = Directory::new("along-rotor");
    let rotor = |along: &str| {
        let arguments = ["analyze", "--model", "JeffcottRotor", "--speed", "9", "--along", along, "--format", "json"];
        critical(&directory.run(&arguments).json())
    };
    let (m, k, external, internal, speed) = (1.0, 1e4, 3.0, 2.0, 9.0 / 0.03);
    let natural: f64 = speed / (1.0 + external / internal);
    let [stiffness] = &rotor("k=5000:50000")[..] else { panic!("one") };
    assert_eq!(stiffness.0, "flutter");
    let expected = m * natural * natural;
    assert!((stiffness.1 - expected).abs() < 1e-10 * expected, "{stiffness:?}, expected {expected}");
    assert!((stiffness.2 - natural).abs() < 1e-9 * natural);
    let [damping] = &rotor("ci=0.1:10")[..] else { panic!("one") };
    let expected = external / (speed / f64::sqrt(k / m) - 1.0);
    assert!((damping.1 - expected).abs() < 1e-10 * expected, "{damping:?}, expected {expected}");
}

#[test]
fn the_table_the_numbers_and_the_picture_agree() {
    let directory = Directory::new("along-formats");
    let run = |arguments: &[&str]| {
        directory.run(&[&["analyze", "--along", "g=1:20", "--speed", "18 km/h"], arguments].concat())
    };
    let analysis = run(&["--format", "json"]).json();
    assert_eq!((analysis["along"]["name"].as_str(), analysis["along"]["unit"].as_str()), (Some("g"), Some("N/kg")));
    assert_eq!(analysis["speed"].as_f64(), Some(5.0));
    let found = critical(&analysis);
    let ranges = &analysis["stable_ranges"];
    assert_eq!((ranges[0][0].as_f64(), ranges[0][1].as_f64()), (Some(found[0].1), Some(found[1].1)));
    let table = run(&[]).ok();
    for (kind, value, _) in &found {
        assert!(table.contains(&format!("{kind:<13}{value}")), "{table}");
    }
    let rows = analysis["eigenvalues"].as_array().unwrap();
    assert_eq!(rows.len(), 101);
    let csv = run(&["--format", "csv"]).ok();
    assert_eq!(csv.lines().count(), 102);
    assert!(csv.starts_with("g (N/kg),eigenvalue 1 re (1/s),eigenvalue 1 im (1/s),"), "{csv}");
    // Stable in the range, by the eigenvalues themselves.
    for row in rows {
        let is_inside = (found[0].1..found[1].1).contains(&row["value"].as_f64().unwrap());
        let is_stable = row["values"].as_array().unwrap().iter().all(|value| value["re"].as_f64().unwrap() < 0.0);
        assert!(is_inside == is_stable && is_stable == (row["verdict"] == "stable"), "{row}");
    }
    let drawn = run(&["--plot", "along.svg"]);
    assert_eq!((drawn.code, drawn.stderr.as_str()), (Some(0), "wrote: along.svg\n"));
    let picture = std::fs::read_to_string(directory.0.join("along.svg")).unwrap();
    assert!(picture.starts_with("<svg "), "{picture}");
}

#[test]
fn mistakes_are_named() {
    let directory = Directory::new("along-mistakes");
    let fails = |along: &str, rest: &[&str], message: &str| {
        let arguments = [&["analyze", "--along", along], rest].concat();
        directory.run(&arguments).fails(2, &format!("error: --along {along}: {message}\n"));
    };
    let at_speed = ["--speed", "5"];
    fails("mB=60:120", &[], "--speed is missing, the speed in m/s at which the parameter changes");
    fails("mB=-5:120", &at_speed, "`mB` is -5 kg; it must be >= 0");
    fails("mB=120:60", &at_speed, "the range is from 120 kg to 60 kg; it must ascend");
    fails("mBB=1:2", &at_speed, "`mBB` is not a parameter of Whipple; did you mean `mB`?");
    let message = "a value of `mB` is `a`; expected a number, or an expression such as `pi/10`: `a` is not known";
    fails("mB=a:2", &at_speed, message);
    // By definition the wheel base is w, and the head angle 90° - λ, here from 60° to 80°.
    fails("w=0.9:1.2", &["--set", "w=1"], "`w` is set, but varies; leave one of them out");
    fails("wheelbase=0.9:1.2", &["--set", "w=1"], "`w` is set, but varies as `wheelbase`; leave one of them out");
    fails("lam=0.2:0.4", &["--set", "lambda=0.3"], "`lambda` is set, but varies as `lam`; leave one of them out");
    fails("g=1:20", &["--gravity", "5"], "`g` is set, but varies; leave one of them out");
    let range = "it must be > 0 and < 3.141592653589793";
    fails("hta=60:80", &[], &format!("`head_angle` is 60 rad; {range} (for degrees write `60 deg`)"));
    fails("hta=600:800", &[], &format!("`head_angle` is 600 rad; {range}"));
    fails("v=1:2", &[], "`v` is the speed: without --along everything is along it");
    directory.write("matrices.json", "{\"M\": [[1]], \"C0\": [[1]], \"Kc\": [[4]]}");
    let message = "matrices that are given themselves have no parameters but their entries, which `carvallo sweep --vary` goes along";
    fails("M_11=1:2", &["matrices.json"], message);
}

/// At its weave speed (Meijaard et al. 2007, Table 2) the benchmark is critical along any parameter, at its own value: its head
/// angle is 72 degrees, and its fork offset rF sin λ - c cos λ.
#[test]
fn parameters_may_be_those_of_others() {
    let directory = Directory::new("along-others");
    let lam = std::f64::consts::PI / 10.0;
    for (along, expected) in [
        ("head_angle=60 deg:80 deg", 0.4 * std::f64::consts::PI),
        ("fork_offset=0:60 mm", 0.35 * lam.sin() - 0.08 * lam.cos()),
        ("d3=0:0.06", 0.35 * lam.sin() - 0.08 * lam.cos()),
    ] {
        let run = directory.run(&["analyze", "--along", along, "--speed", "4.29238253634111", "--format", "json"]);
        assert!(
            run.stderr.starts_with("note: benchmark: `") && run.stderr.contains(" stay as they are"),
            "{}",
            run.stderr
        );
        let found = critical(&serde_json::from_str(&run.stdout).unwrap());
        assert!(found.iter().any(|(_, value, _)| (value - expected).abs() < 1e-11), "{along}: {found:?}");
    }
}

/// The trail that is set stays while the head angle changes, as along the tilt with the trail of the paper.
#[test]
fn what_is_set_is_held() {
    let directory = Directory::of_this_test();
    let run = |along: &str, set: &str| {
        let arguments = ["analyze", "--along", along, "--set", set, "--speed", "4.5", "--format", "json"];
        let run = directory.run(&arguments);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        critical(&serde_json::from_str(&run.stdout).unwrap())
    };
    let printed = run("head_angle=60 deg:80 deg", "trail=5 cm");
    let mut own = run("lam=10 deg:30 deg", "c=5 cm");
    own.reverse();
    assert!(!own.is_empty() && own.len() == printed.len(), "{own:?}, {printed:?}");
    for ((_, lam, _), (_, head, _)) in own.iter().zip(&printed) {
        assert!((lam + head - std::f64::consts::FRAC_PI_2).abs() < 1e-11, "{own:?}, {printed:?}");
    }
}

/// In other units: the same critical values, and rows at round values of the unit that is shown.
#[test]
fn units_are_those_that_are_asked_for() {
    let directory = Directory::new("along-units");
    let arguments = ["analyze", "--along", "lam=10 deg:30 deg", "--speed", "18 km/h", "--format"];
    let run = |format: &str, units: &[&str]| directory.run(&[&arguments[..], &[format], units].concat());
    let own = run("json", &[]).json();
    let units = ["--units", "deg,km/h"];
    let shown = run("json", &units).json();
    assert_eq!((shown["along"]["unit"].as_str(), shown["speed_unit"].as_str()), (Some("deg"), Some("km/h")));
    assert_eq!((shown["speed"].as_f64(), own["speed"].as_f64()), (Some(18.0), Some(5.0)));
    assert!(own["speed_unit"].is_null());
    assert_eq!(shown["range"], serde_json::json!([10.0, 30.0]));
    let (own, shown) = (critical(&own), critical(&shown));
    assert!(!own.is_empty() && own.len() == shown.len());
    for ((_, radians, _), (_, degrees, _)) in own.iter().zip(&shown) {
        assert!((radians.to_degrees() - degrees).abs() < 1e-12, "{radians}, {degrees}");
    }
    let csv = run("csv", &units).ok();
    assert!(
        csv.starts_with("lam (deg),eigenvalue 1 re (1/s),") && csv.lines().nth(2).unwrap().starts_with("10.2,"),
        "{csv}"
    );
    let table = run("table", &units).ok();
    assert!(
        table.contains("Along lam from 10 deg to 30 deg, at 18 km/h") && table.contains("\n         12  "),
        "{table}"
    );
    let markdown = run("markdown", &units).ok();
    assert!(markdown.contains("| lam (deg) |"), "{markdown}");
    directory.run(&[&arguments[..5], &["--plot", "along.svg"], &units].concat());
    let picture = std::fs::read_to_string(directory.0.join("along.svg")).unwrap();
    assert!(picture.contains("lam (deg)") && picture.contains("at 18 km/h"), "{picture}");
}
