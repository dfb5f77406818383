//! Responses to steps, impulses and initial states.

use serde_json::Value;

use crate::Directory;

/// At 0.5 s of the benchmark at 5 m/s, by the exponential of mpmath with 40 digits: lean and steer after a step and an impulse of 1 N m
/// on steer, and from a lean rate of 0.5 rad/s.
const AFTER: [(&[&str], [f64; 2]); 3] = [
    (&["--step"], [-0.10159927638763946, 0.010749509473709241]),
    (&["--impulse"], [-0.44634914238806933, -0.27101716123855557]),
    (&["--initial", "phi_rate=0.5"], [0.08975928206055264, 0.10449836237157073]),
];

#[test]
fn every_format_has_the_exact_motion() {
    let directory = Directory::of_this_test();
    for (asked, expected) in AFTER {
        let all = [&["respond", "--speed", "5", "--input", "Tdelta", "--duration", "0.5"], asked].concat();
        let json = directory.run(&[&all[..], &["--format", "json"]].concat()).json();
        let last = json["rows"].as_array().expect("rows").last().expect("a row").clone();
        for (name, expected) in ["phi", "delta"].into_iter().zip(expected) {
            let found = last["outputs"][name].as_f64().expect("a number");
            assert!((found - expected).abs() < 1e-13, "{asked:?} {name}: {found} is not {expected}");
        }
        let csv = directory.run(&[&all[..], &["--format", "csv"]].concat()).ok();
        assert!(csv.starts_with("t (s),phi (rad),delta (rad)\n0.0,"), "{csv}");
        let line = csv.lines().last().expect("a line");
        assert_eq!(line, format!("0.5,{},{}", last["outputs"]["phi"], last["outputs"]["delta"]));
        let table = directory.run(&all).ok();
        let degrees = expected.map(|value| format!("{:.6}", value.to_degrees()));
        let row: Vec<&str> = table.lines().last().expect("a line").split_whitespace().collect();
        assert_eq!(row, ["0.5", &degrees[0], &degrees[1]], "{table}");
    }
}

#[test]
fn sizes_and_states_have_units() {
    let directory = Directory::of_this_test();
    let json = |more: &[&str]| -> Value {
        directory.run(&[&["respond", "--speed", "5", "--input", "Tdelta", "--format", "json"], more].concat()).json()
    };
    assert_eq!(json(&["--step=-2 N m"])["excitation"], serde_json::json!({"step": {"input": "Tdelta", "size": -2.0}}));
    assert_eq!(json(&["--impulse=3 N m s"])["excitation"]["impulse"]["size"], 3.0);
    let initial = json(&["--initial", "lean rate=18 deg/s", "--initial", "y=10 cm", "--outputs", "y"]);
    let initial = &initial["excitation"]["initial"];
    assert_eq!((&initial["y"], &initial["delta"]), (&Value::from(0.1), &Value::from(0.0)));
    assert!((initial["phi_rate"].as_f64().expect("a number") - 0.3141592653589793).abs() < 1e-15);
}

#[test]
fn responses_are_drawn() {
    let directory = Directory::of_this_test();
    let asked =
        ["respond", "--speed", "5", "--input", "Tdelta", "--step", "--outputs", "phi,psi_rate,y", "--plot", "r.svg"];
    let run = directory.run(&asked);
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), "wrote: r.svg\n"));
    let svg = std::fs::read_to_string(directory.0.join("r.svg")).expect("a picture");
    for text in [
        "benchmark at 5 m/s: response to a step of 1 N m in Tdelta",
        "angles (°)",
        "rates (°/s)",
        "positions (m)",
        "yaw rate psi_rate",
    ] {
        assert!(svg.contains(text), "{text}");
    }
}

#[test]
fn what_ends_early_is_told() {
    let directory = Directory::of_this_test();
    let run = directory.run(&[
        "respond",
        "--speed",
        "0",
        "--input",
        "Tphi",
        "--step",
        "--duration",
        "1000",
        "--format",
        "csv",
    ]);
    assert_eq!(run.code, Some(0));
    assert_eq!(
        run.stderr,
        "note: it ends before 130 s: the response then leaves the range of floating-point numbers\n"
    );
    assert!(run.stdout.lines().count() > 20 && !run.stdout.contains("inf"));
}

#[test]
fn mistakes_are_told() {
    let directory = Directory::of_this_test();
    let fails = |more: &[&str], message: &str| {
        directory.run(&[&["respond", "--speed", "5"], more].concat()).fails(2, &format!("error: {message}\n"));
    };
    fails(&[], "expected --step, --impulse or --initial NAME=VALUE, such as --initial phi_rate=0.5");
    fails(&["--step"], "--step: of which input? Name one by --input: Tphi, Tdelta");
    fails(&["--input", "Tdelta", "--step=2 kg"], "--step=2 kg: `2 kg`: `kg` is no unit for it; it is in N m");
    fails(
        &["--initial", "phi_rat=3", "--initial", "phi=2", "--initial", "lean=3"],
        "2 problems\n--initial phi_rat=3: `phi_rat` is no state; did you mean `phi_rate`?\nthey are phi, delta, phi_rate, \
         delta_rate\n--initial lean=3: it is given twice",
    );
}

/// Steps whose squares are no doubles end as others do that are too long.
#[test]
fn the_longest_duration_ends() {
    let directory = Directory::of_this_test();
    for duration in ["1e200", "1e300"] {
        let run = directory.run(&["respond", "--speed", "5", "--input", "Tdelta", "--step", "--duration", duration]);
        let is_told = run.stderr.contains("the steps to it are too long for floating-point numbers");
        assert!(run.code == Some(0) && is_told, "{}", run.stderr);
    }
}

/// At a step of so many times what the fastest motion takes, which is no growth of a motion that dies away.
#[test]
fn times_that_doubles_do_not_tell_end_a_response_for_their_own_reason() {
    let directory = Directory::of_this_test();
    let run = directory.run(&["respond", "--speed", "5", "--input", "Tdelta", "--step", "--duration", "1e20"]);
    let note = "note: it ends before 5e18 s: the steps to it are too long for floating-point numbers to tell what moves fastest in \
                them\n";
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), note));
    let grown = directory.run(&["respond", "--speed", "7", "--input", "Tdelta", "--step", "--duration", "1e8"]);
    assert!(grown.stderr.contains("the response then leaves the range of floating-point numbers"), "{}", grown.stderr);
}

/// What is zero throughout has an axis of plain numbers.
#[test]
fn a_response_that_is_zero_is_drawn() {
    let directory = Directory::of_this_test();
    directory.run(&["respond", "--model", "Pendulum", "--initial", "theta=0", "--duration", "2", "--plot", "zero.svg"]);
    let svg = std::fs::read_to_string(directory.0.join("zero.svg")).expect("a picture");
    assert!(svg.contains("aria-label=\"−1.0\"") && !svg.contains("e−"));
}

#[test]
fn a_missing_name_is_told() {
    let directory = Directory::of_this_test();
    let message = "error: --inputs : there is no name; expected an input such as Tphi\nthey are Tphi, Tdelta\n";
    directory.run(&["transfer", "--speed", "5", "--inputs", ""]).fails(2, message);
}
