//! Transfer functions, their responses and margins.

use serde_json::Value;

use crate::Directory;

const TO_LEAN: [&str; 7] = ["transfer", "--speed", "5", "--inputs", "Tdelta", "--outputs", "phi"];

fn to_lean(more: &[&'static str]) -> Vec<&'static str> {
    [&TO_LEAN[..], more].concat()
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-11 * expected.abs().max(1.0), "{found} is not {expected}");
}

/// Zeros with 60 digits from exact determinants (`transfer_functions.tsv` of the crate), responses and margins by python-control
/// 0.10.2, of the benchmark at 5 m/s.
#[test]
fn every_format_has_the_same_numbers() {
    let directory = Directory::of_this_test();
    let json = directory.run(&to_lean(&["--format", "json", "--frequencies", "0.3,3"])).json();
    let function = &json["transfer_functions"][0];
    assert_eq!(
        (&function["input"], &function["output"], &function["unit"]),
        (&"Tdelta".into(), &"phi".into(), &"rad/(N*m)".into())
    );
    close(number(&function["gain"]), -0.1240920254115766);
    for (place, zero) in [-59.25992316246232, -13.746499609246897].into_iter().enumerate() {
        close(number(&function["zeros"][place]["re"]), zero);
    }
    assert_eq!(
        (function["poles"].as_array().map(Vec::len), function["zeros"].as_array().map(Vec::len)),
        (Some(4), Some(2))
    );
    // The static gain is that of -20 times it, 15.9326 at 0.3 rad/s and 3.8352 at 3 rad/s.
    for (place, (gain, degrees)) in
        [(15.932617359658188, -43.8814115275712), (3.835195804054283, -102.63967560728764)].into_iter().enumerate()
    {
        let point = &function["frequency_response"][place];
        close(number(&point["gain"]), gain / 20.0);
        close(number(&point["phase"]).to_degrees() - 180.0, degrees);
    }
    assert_eq!(function["closed_loop"], "unstable");
    let without = directory.run(&to_lean(&["--format", "json"])).json();
    assert!(without["transfer_functions"][0]["frequency_response"].is_null());

    let csv = directory.run(&to_lean(&["--format", "csv", "--frequencies", "0.3"])).ok();
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!((lines.len(), lines[0]), (2, "frequency (rad/s),gain phi/Tdelta (rad/(N*m)),phase phi/Tdelta (rad)"));
    assert_eq!(lines[1].split(',').nth(1), Some(function["frequency_response"][0]["gain"].to_string().as_str()));

    let table = directory.run(&TO_LEAN).ok();
    for line in [
        "  zeros (1/s)       -59.259923, -13.746500",
        "  static gain G(0)  -1.082932 rad/(N m)",
        "  -0.775342 ± 4.464868 i             4.5317         0.1711",
    ] {
        assert!(table.contains(line), "{line} is not in {table}");
    }
}

#[test]
fn responses_are_drawn() {
    let directory = Directory::of_this_test();
    let asked = ["transfer", "pista", "--speed", "6", "--bode", "bode.svg", "--nyquist", "nyquist.png"];
    let run = directory.run(&asked);
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), "wrote: bode.svg\nwrote: nyquist.png\n"));
    let svg = std::fs::read_to_string(directory.0.join("bode.svg")).expect("a picture");
    for text in [
        "<title>Frequency response of pista at 6 m/s</title>",
        "gain (dB)",
        "phase (°)",
        "Tdelta to delta",
        "frequency ω (rad/s)",
    ] {
        assert!(svg.contains(text), "{text}");
    }
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    assert!(std::fs::read(directory.0.join("nyquist.png")).expect("a picture").starts_with(b"\x89PNG"));
}

/// Without damping, poles are on the imaginary axis, where there is no gain.
#[test]
fn poles_on_the_axis_have_no_gain() {
    let directory = Directory::of_this_test();
    directory.write("spring.json", r#"{"M": [[1]], "Kc": [[4]]}"#);
    let asked = ["transfer", "spring.json", "--frequencies", "1,2,3", "--bode", "b.svg", "--nyquist", "n.svg"];
    let run = directory.run(&[&asked[..], &["--format", "csv"]].concat());
    let gains: Vec<&str> = run.stdout.lines().skip(1).filter_map(|line| line.split(',').nth(1)).collect();
    assert_eq!(gains[1], "", "{}", run.stdout);
    close(gains[0].parse().expect("a gain"), 1.0 / 3.0);
    close(gains[2].parse().expect("a gain"), 1.0 / 5.0);
    let json = directory.run(&["transfer", "spring.json", "--frequencies", "2", "--format", "json"]).json();
    assert_eq!(json["transfer_functions"][0]["frequency_response"][0]["gain"], Value::Null);
}

#[test]
fn mistakes_are_told() {
    let directory = Directory::of_this_test();
    for (text, message) in [
        ("0", "a frequency is 0; it must be > 0"),
        ("-1:1", "a frequency is -1; it must be > 0"),
        ("10:1", "the range goes from 10 to 1 rad/s; it must ascend"),
        ("1:2:3", "expected a list such as 1,2,5 or a range LOW:HIGH such as 0.1:100"),
        ("0.1 Hz:10", "`10` has no unit, but others are in Hz: write Hz or rad/s behind each"),
        ("1,2 Hz", "`1` has no unit, but others are in Hz: write Hz or rad/s behind each"),
        ("1 kg", "`kg` is no unit for a frequency: it is in rad/s, or in Hz"),
    ] {
        let message = format!("error: --frequencies {text}: {message}\n");
        directory.run(&["transfer", "--speed", "5", "--frequencies", text]).fails(2, &message);
    }
}

/// The quotient of these ends is no double; the response of `1/(s^2 + 4)` is its static gain at the lower one.
#[test]
fn ranges_may_go_as_far_as_numbers_do() {
    let directory = Directory::of_this_test();
    directory.write("spring.json", r#"{"M": [[1]], "Kc": [[4]]}"#);
    let csv = directory.run(&["transfer", "spring.json", "--frequencies", "1e-300:1e300", "--format", "csv"]).ok();
    let rows: Vec<&str> = csv.lines().skip(1).collect();
    let [first, last] = [rows[0], rows[rows.len() - 1]].map(|row| row.split(',').collect::<Vec<_>>());
    assert!(!csv.contains("inf,") && !csv.contains("NaN"));
    assert_eq!([first[0].parse(), first[1].parse()], [Ok(1e-300), Ok(0.25)]);
    assert_eq!([last[0].parse(), last[1].parse()], [Ok(1e300), Ok(0.0)]);
    let frequencies = rows.iter().map(|row| row.split(',').next().and_then(|cell| cell.parse::<f64>().ok()));
    assert!(frequencies.collect::<Option<Vec<f64>>>().expect("numbers").is_sorted());
}

/// What is left of the real part of undamped poles by rounding is not told, and neither is that of angles.
#[test]
fn undamped_poles_have_no_real_part() {
    let directory = Directory::of_this_test();
    directory.write("two.json", r#"{"M": [[2, 0], [0, 3]], "g": 9.81, "K0": [[1, 0.5], [0.5, 2]]}"#);
    let table = directory.run(&["transfer", "two.json"]).ok();
    assert!(table.contains("  0.000000 ± 1.886690 i             1.8867         0.0000\n"), "{table}");
    assert!(!table.contains("e-1") && !table.contains("-180.000°") && table.contains("  180.000° at"), "{table}");
}

/// Far below the poles of `k (s + z) / (s (s^2 + b s + c))` the gain is one at `k z / c`: 0.0010277 by 2.12793.
#[test]
fn slow_margins_are_told_in_pictures() {
    let directory = Directory::of_this_test();
    let asked =
        ["transfer", "--model", "Car", "--speed", "20", "--inputs", "Fy", "--outputs", "y", "--nyquist", "n.svg"];
    directory.run(&asked);
    let svg = std::fs::read_to_string(directory.0.join("n.svg")).expect("a picture");
    assert!(svg.contains("phase margin 89.98° at 4.83e−4 rad/s"), "{svg}");
}

/// The gain of a pendulum at its resonance is 3.18, so that the axes go beyond it.
#[test]
fn resonances_are_shown_whole() {
    let directory = Directory::of_this_test();
    directory.run(&["transfer", "--model", "Pendulum", "--nyquist", "n.svg"]);
    let svg = std::fs::read_to_string(directory.0.join("n.svg")).expect("a picture");
    // On both axes.
    assert_eq!(svg.matches("aria-label=\"−3\"").count(), 2, "{svg}");
}

#[test]
fn polynomials_are_formulas_in_latex() {
    let directory = Directory::of_this_test();
    let latex = directory.run(&to_lean(&["--format", "latex"])).ok();
    assert!(latex.contains("& $s^{4} + 15.9519\\,s^{3} + 47.4134\\,s^{2} + 302.796\\,s + 93.346$ "), "{latex}");
    assert!(latex.contains("& $-59.259923$, $-13.746500$ ") && !latex.contains("asciicircum"), "{latex}");
}

/// Both with 60 digits, by `transmission.py` of the crate.
#[test]
fn several_inputs_and_outputs_have_zeros_and_singular_values_together() {
    let directory = Directory::of_this_test();
    let model = ["transfer", "--model", "WhippleLeaning", "--speed", "6", "--inputs", "Tdelta,Ttheta"];
    let asked = |more: &[&str]| directory.run(&[&model[..], &["--outputs", "phi,delta"], more].concat());
    let json = asked(&["--frequencies", "0.1,3", "--format", "json"]).json();
    let zeros: Vec<f64> =
        json["transmission_zeros"].as_array().expect("zeros").iter().map(|zero| number(&zero["re"])).collect();
    assert_eq!(zeros.len(), 2);
    close(zeros[0], -2.7787849495893706);
    close(zeros[1], 2.7787849495893706);
    for (place, values) in
        [[2.579310941673995, 7.494396511444063e-05], [0.11460292180384705, 0.00014326718227811397]].iter().enumerate()
    {
        values
            .iter()
            .enumerate()
            .for_each(|(at, value)| close(number(&json["singular_values"][place]["values"][at]), *value));
    }
    asked(&["--sigma", "sigma.svg"]);
    let svg = std::fs::read_to_string(directory.0.join("sigma.svg")).expect("a picture");
    for text in
        ["Singular values of WhippleLeaning example at 6 m/s", "σ1 largest", "σ2 smallest", "singular values (dB)"]
    {
        assert!(svg.contains(&format!("aria-label=\"{text}\"")), "{text}: {svg}");
    }
    let table = asked(&[]).ok();
    assert!(table.contains("\nTransmission zeros, at 6 m/s  of all inputs and outputs\n"), "{table}");
    assert!(table.contains("\n   -2.778785             2.7788         1.0000\n"), "{table}");
    assert!(table.contains("\n                0.1      2.57931    7.4944e-5\n"), "{table}");
    let csv = asked(&["--frequencies", "0.1,3", "--format", "csv"]).ok();
    assert!(csv.lines().next().expect("a heading").ends_with(",singular value 1,singular value 2"), "{csv}");
    // A table without headings has no empty line for them.
    let latex = asked(&["--format", "latex"]).ok();
    assert!(latex.contains("\\toprule\n    gain k ") && latex.contains(" $\\sigma$1 & "), "{latex}");
    // More outputs than inputs.
    let tall = directory.run(&[&model[..], &["--outputs", "phi,delta,theta", "--format", "json"]].concat()).json();
    assert!(tall["transmission_zeros"].is_null() && tall.get("transmission_zeros").is_some());
    assert!(directory.run(&to_lean(&["--format", "json"])).json().get("transmission_zeros").is_none());
}
