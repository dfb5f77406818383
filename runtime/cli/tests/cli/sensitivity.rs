//! `carvallo sensitivity`, against differences between runs of `carvallo analyze`.

use serde_json::Value;

use crate::{BENCHMARK, Directory};

/// A bicycle with two weave speeds and a capsize speed between them.
const TWO_WEAVE_SPEEDS: [&str; 22] = [
    "w=1.7",
    "c=0.12",
    "lam=-0.21",
    "rR=0.34",
    "mR=7.8",
    "IRxx=0.24",
    "IRyy=0.3",
    "xB=0.69",
    "zB=-0.45",
    "mB=120",
    "IBxx=3.6",
    "IBzz=9.9",
    "xH=1.4",
    "zH=-1.1",
    "mH=3.3",
    "IHxx=0.053",
    "IHzz=0.11",
    "rF=0.16",
    "mF=4.7",
    "IFxx=0.2",
    "IBxz=-2",
    "IHxz=0",
];

fn with_settings<'a>(arguments: &[&'a str], settings: &[&'a str]) -> Vec<&'a str> {
    arguments.iter().copied().chain(settings.iter().flat_map(|setting| ["--set", setting])).collect()
}

/// Of each critical speed.
fn speeds(json: &Value) -> Vec<f64> {
    json["critical_speeds"].as_array().unwrap().iter().map(|critical| critical["speed"].as_f64().unwrap()).collect()
}

/// The derivatives of all critical speeds are what runs with a parameter a little up and down differ by.
#[track_caller]
fn assert_differences(settings: &[&str]) {
    const STEP: f64 = 1e-5;
    let directory = Directory::of_this_test();
    let json = directory.run(&with_settings(&["sensitivity", "--format", "json"], settings)).json();
    let critical = json["critical_speeds"].as_array().unwrap();
    assert!(critical.len() > 2, "{critical:?}");
    for (name, given) in json["parameters"].as_object().unwrap() {
        let value = given["value"].as_f64().unwrap();
        let step = if value == 0.0 { STEP } else { STEP * value.abs() };
        let is_other = |other: &&str| !other.starts_with(&format!("{name}="));
        let others: Vec<&str> = settings.iter().copied().filter(is_other).collect();
        let [above, below] = [value + step, value - step].map(|value| {
            let setting = format!("{name}={value:?}");
            let mut settings: Vec<&str> = others.clone();
            settings.push(&setting);
            let arguments = with_settings(&["analyze", "--format", "json", "--speeds", "1"], &settings);
            speeds(&directory.run(&arguments).json())
        });
        for (index, critical) in critical.iter().enumerate() {
            let expected = (above[index] - below[index]) / (2.0 * step);
            let found = critical["derivatives"][name].as_f64().unwrap();
            // What is left of a speed where a derivative is small is rounding.
            let size = expected.abs() + 1e-4 * above[index] / step.max(1e-7) * STEP;
            assert!((found - expected).abs() <= 1e-5 * size, "{critical} by {name}: {expected}");
        }
    }
}

#[test]
fn derivatives_are_what_runs_differ_by() {
    assert_differences(&[]);
    assert_differences(&TWO_WEAVE_SPEEDS);
}

#[test]
fn every_weave_speed_has_its_derivatives() {
    let directory = Directory::of_this_test();
    let text = directory.run(&with_settings(&["sensitivity"], &TWO_WEAVE_SPEEDS)).ok();
    let heads = text.lines().find(|line| line.contains("1 % is")).unwrap();
    assert_eq!(heads.matches("per unit").count(), 3, "{heads}");
    assert_eq!((heads.matches("weave").count(), heads.matches("capsize").count()), (2, 1), "{heads}");
}

#[test]
fn the_table_ranks_by_the_largest_effect() {
    let directory = Directory::of_this_test();
    let text = directory.run(&["sensitivity"]).ok();
    let json = directory.run(&["sensitivity", "--format", "json"]).json();
    // From the numbers of the JSON: 1 % of a parameter times its derivatives, of weave and capsize.
    let critical = json["critical_speeds"].as_array().unwrap();
    let effect = |name: &str| {
        let ranked = critical.iter().filter(|critical| critical["kind"] != "double_root");
        let of = |critical: &Value| {
            critical["derivatives"][name].as_f64().unwrap() * json["parameters"][name]["one_percent"].as_f64().unwrap()
        };
        ranked.map(|critical| of(critical).abs()).fold(0.0, f64::max)
    };
    let names: Vec<&str> = json["parameters"].as_object().unwrap().keys().map(String::as_str).collect();
    let start = text.lines().position(|line| line.contains("1 % is")).unwrap() + 1;
    let rows = text.lines().skip(start).map(|line| line.split_whitespace().next().unwrap_or_default());
    let ranked: Vec<&str> = rows.take_while(|name| names.contains(name)).collect();
    assert_eq!(ranked.len(), 24, "{text}");
    assert!(ranked.windows(2).all(|pair| effect(pair[0]) >= effect(pair[1])), "{ranked:?}");
    assert!(text.contains("\n  without effect: IByy, IHyy\n"), "{text}");
    assert!(effect("IByy") == 0.0 && effect("IHyy") == 0.0);
    assert!((json["parameters"]["zB"]["one_percent"].as_f64().unwrap() + 0.009).abs() < 1e-17);
    assert!(!text.contains("Standard deviations") && json["matrix_standard_deviations"].is_null());
}

#[test]
fn csv_has_the_numbers_of_the_json() {
    let directory = Directory::of_this_test();
    let arguments = ["sensitivity", "pista", "--format"];
    let csv = directory.run(&[&arguments[..], &["csv"]].concat()).ok();
    let json = directory.run(&[&arguments[..], &["json"]].concat()).json();
    let mut lines = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().unwrap();
    let critical = json["critical_speeds"].as_array().unwrap();
    assert_eq!(header.len(), 5 + 2 * critical.len());
    assert_eq!(header[..5], ["parameter", "unit", "value", "standard deviation", "1 %"]);
    assert!(header.contains(&"weave derivative (m/s per unit)"), "{header:?}");
    let lines: Vec<_> = lines.collect();
    assert_eq!(lines.len(), 26);
    for line in lines {
        let name = line[0];
        let number = |column: usize| line[column].parse::<f64>().unwrap();
        assert_eq!(Some(number(2)), json["parameters"][name]["value"].as_f64());
        let deviation = if line[3].is_empty() { 0.0 } else { number(3) };
        assert_eq!(Some(deviation), json["parameters"][name]["std"].as_f64());
        let step = json["parameters"][name]["one_percent"].as_f64().unwrap();
        assert_eq!(number(4), step);
        for (index, critical) in critical.iter().enumerate() {
            let derivative = critical["derivatives"][name].as_f64().unwrap();
            assert_eq!((number(5 + 2 * index), number(6 + 2 * index)), (derivative * step + 0.0, derivative));
        }
    }
}

/// A single deviation reaches a speed by its derivative alone; all of them add up in squares, and the shares to one.
#[test]
fn standard_deviations_propagate() {
    let directory = Directory::of_this_test();
    let line = "\nc = 0.08\n";
    assert!(BENCHMARK.contains(line));
    directory.write("bike.toml", BENCHMARK.replace(line, "\nc = { value = 0.08, std = 0.003 }\n"));
    let json = directory.run(&["sensitivity", "bike.toml", "--format", "json"]).json();
    for critical in json["critical_speeds"].as_array().unwrap() {
        let derivative = critical["derivatives"]["c"].as_f64().unwrap();
        let deviation = critical["standard_deviation"].as_f64().unwrap();
        assert!((deviation - 0.003 * derivative.abs()).abs() <= 1e-15 * deviation, "{critical}");
        let share = |name: &str| critical["variance_shares"][name].as_f64().unwrap();
        assert!((share("c") - 1.0).abs() < 1e-15 && share("w") == 0.0, "{critical}");
    }
    // K0 and K2 of Appendix A: their entries with mu = c cos(lam) / w change with c, ITxx does not.
    let deviations = &json["matrix_standard_deviations"];
    assert_eq!(deviations["M"][0][0], 0.0);
    assert!(deviations["K0"][0][1].as_f64().unwrap() > 0.0);

    let json = directory.run(&["sensitivity", "pista", "--format", "json"]).json();
    for critical in json["critical_speeds"].as_array().unwrap() {
        let terms = json["parameters"].as_object().unwrap().iter();
        let terms =
            terms.map(|(name, value)| value["std"].as_f64().unwrap() * critical["derivatives"][name].as_f64().unwrap());
        let expected = terms.map(|term| term * term).sum::<f64>().sqrt();
        let found = critical["standard_deviation"].as_f64().unwrap();
        assert!((found - expected).abs() <= 1e-12 * expected, "{found} is not {expected}");
        let shares = critical["variance_shares"].as_object().unwrap().values();
        let sum: f64 = shares.map(|share| share.as_f64().unwrap()).sum();
        assert!((sum - 1.0).abs() < 1e-12, "{sum}");
    }
    let text = directory.run(&["sensitivity", "pista"]).ok();
    assert!(text.contains("from those of 26 of 26 parameters") && text.contains("of the variance"), "{text}");
    // What is set has no deviation.
    let text = directory.run(&["sensitivity", "pista", "--set", "c=0.06"]).ok();
    assert!(text.contains("from those of 25 of 26 parameters"), "{text}");
}

#[test]
fn a_parameter_of_zero_is_changed_by_a_marked_scale() {
    let directory = Directory::of_this_test();
    let settings = ["c=0"];
    let text = directory.run(&with_settings(&["sensitivity"], &settings)).ok();
    let json = directory.run(&with_settings(&["sensitivity", "--format", "json"], &settings)).json();
    let one_percent = |name: &str| json["parameters"][name]["one_percent"].as_f64().unwrap();
    // The other lengths of the benchmark: 0.3, 0.3, 0.35, 0.7, 0.9, 0.9, 1.02.
    assert!((one_percent("c") - 0.007).abs() < 1e-17);
    assert!(text.contains("*+0.007000  m"), "{text}");
    assert!(text.contains("  * zero itself"), "{text}");
    assert!(!directory.run(&["sensitivity"]).ok().contains('*'));
    // Of the only angle a radian.
    let json = directory.run(&["sensitivity", "--set", "lam=0", "--format", "json"]).json();
    assert_eq!(json["parameters"]["lam"]["one_percent"], 0.01);
}

/// What is told of ranges of speeds is what `carvallo analyze` tells.
#[test]
fn ranges_are_told_as_those_of_an_analysis() {
    let directory = Directory::of_this_test();
    let ranges = |command: &str, arguments: &[&str]| -> Vec<String> {
        let text = directory.run(&[&[command], arguments].concat()).ok();
        let lines = text.lines().filter(|line| line.contains("self-stable ") || line.contains("marginal "));
        assert!(!text.contains("at no speed"), "{text}");
        lines.map(str::to_owned).collect()
    };
    for arguments in [&["--model", "RollingDisc"][..], &["benchmark"]] {
        let told = ranges("sensitivity", arguments);
        assert_eq!(told.len(), 1, "{told:?}");
        // A table of eigenvalues says `marginal` as well.
        let analyzed = ranges("analyze", arguments);
        assert_eq!(
            analyzed.iter().filter(|line| line.contains(" m/s")).collect::<Vec<_>>(),
            told.iter().collect::<Vec<_>>()
        );
    }
}

#[test]
fn a_bicycle_may_lack_either_speed_or_both() {
    let directory = Directory::of_this_test();
    let without = |text: &str, kind: &str| {
        text.lines().any(|line| line.trim_start().starts_with(kind) && line.ends_with("there is no such speed"))
    };
    let text = directory.run(&["sensitivity", "--set", "IFyy=0"]).ok();
    assert!(!without(&text, "weave") && without(&text, "capsize") && text.contains("1 % is"), "{text}");
    let text = directory.run(&["sensitivity", "--set", "xB=0"]).ok();
    assert!(without(&text, "weave") && !without(&text, "capsize") && text.contains("1 % is"), "{text}");
    assert!(text.contains("stable by itself at no speed"), "{text}");
    let text = directory.run(&["sensitivity", "--set", "c=-0.1"]).ok();
    assert!(without(&text, "weave") && without(&text, "capsize") && !text.contains("1 % is"), "{text}");
    let json = directory.run(&["sensitivity", "--set", "g=0", "--format", "json"]).json();
    assert!(json["critical_speeds"].as_array().unwrap().iter().all(|critical| critical["kind"] == "double_root"));
    let message = "error: benchmark has neither a weave nor a capsize speed, so there is no chart to draw\n";
    directory.run(&["sensitivity", "--set", "c=-0.1", "--plot", "chart.svg"]).fails(1, message);
    assert!(!directory.0.join("chart.svg").exists());
}

/// The critical speed of a rolling disc stays as it is if all its masses and inertias grow alike, and grows with the root of
/// gravity, and of its size.
#[test]
fn other_models_of_two_coordinates_have_theirs() {
    let directory = Directory::of_this_test();
    let json = directory.run(&["sensitivity", "--model", "RollingDisc", "--format", "json"]).json();
    let critical = json["critical_speeds"].as_array().unwrap();
    assert!(!critical.is_empty());
    for critical in critical {
        let speed = critical["speed"].as_f64().unwrap();
        // The change of the speed by a parameter that grows by its own size.
        let term = |name: &str| {
            let value = json["parameters"][name]["value"].as_f64().unwrap();
            value * critical["derivatives"][name].as_f64().unwrap()
        };
        let inertias = term("Ia") + term("It");
        assert!((term("m") + inertias).abs() <= 1e-13 * speed, "{critical}");
        assert!((term("g") - 0.5 * speed).abs() <= 1e-13 * speed, "{critical}");
        assert!((term("r") + 2.0 * inertias - 0.5 * speed).abs() <= 1e-13 * speed, "{critical}");
        assert!(inertias.abs() > 0.01 * speed, "{critical}");
    }
    let run = directory.run(&["sensitivity", "--model", "DoublePendulum"]);
    assert!(run.stdout.contains("there is no such speed"), "{}", run.stdout);
}

/// A car that oversteers diverges at the root of `L^2 Cf Cr / (m (a Cf - b Cr))` (Riekert & Schunck 1940).
#[test]
fn coordinates_by_their_rates_have_the_derivatives_of_the_closed_form() {
    let directory = Directory::of_this_test();
    let json = directory.run(&["sensitivity", "--model", "Car", "oversteering", "--format", "json"]).json();
    let value = |name: &str| json["parameters"][name]["value"].as_f64().unwrap();
    let [a, b, m, cf, cr] = ["a", "b", "m", "Cf", "Cr"].map(value);
    let critical = &json["critical_speeds"][0];
    let speed = critical["speed"].as_f64().unwrap();
    let excess = a * cf - b * cr;
    // Of the logarithm of the square.
    let relative = [
        ("m", -1.0 / m),
        ("a", 2.0 / (a + b) - cf / excess),
        ("b", 2.0 / (a + b) + cr / excess),
        ("Cf", 1.0 / cf - a / excess),
        ("Cr", 1.0 / cr + b / excess),
        ("I", 0.0),
    ];
    for (name, relative) in relative {
        let (found, expected) = (critical["derivatives"][name].as_f64().unwrap(), 0.5 * speed * relative);
        assert!((found - expected).abs() <= 1e-12 * expected.abs(), "{name}: {found} is not {expected}");
    }
}

/// The speeds of a motorcycle stay as they are if masses, inertias, stiffnesses and damping grow alike; the undamped section
/// of a wing is driven by the air, and its stiffnesses alone scale the square of the speed.
#[test]
fn any_number_of_coordinates_has_them() {
    let directory = Directory::of_this_test();
    let of = |json: &Value, index: usize, names: &[&str]| -> (f64, f64) {
        let critical = &json["critical_speeds"][index];
        let term = |name: &&str| {
            let value = json["parameters"][name]["value"].as_f64().unwrap();
            value * critical["derivatives"][name].as_f64().unwrap()
        };
        (critical["speed"].as_f64().unwrap(), names.iter().map(term).sum())
    };
    let json = directory.run(&["sensitivity", "--model", "Motorcycle", "--format", "json"]).json();
    let forces: Vec<&str> = "Mr Mf Irx Irz Crxz Ifx Ifz iry ify K Cr1 Cr2 Cf1 Cf2 Zf".split(' ').collect();
    for index in 0..4 {
        let (speed, sum) = of(&json, index, &forces);
        assert!(sum.abs() <= 1e-11 * speed, "{speed}: {sum}");
    }
    let json = directory.run(&["sensitivity", "--model", "TypicalSection", "--format", "json"]).json();
    let flutter = (0..4).find(|&index| json["critical_speeds"][index]["change"] == "destabilizes").unwrap();
    let (speed, sum) = of(&json, flutter, &["kh", "ktheta"]);
    assert!((sum - 0.5 * speed).abs() <= 1e-11 * speed, "{speed}: {sum}");
}

/// 2 q'' + q' + (9 - v^2) q = 0 diverges at the root of -Kc/K2.
#[test]
fn given_matrices_have_them_by_each_entry() {
    let directory = Directory::of_this_test();
    directory.write("one.json", r#"{"M": [[2]], "C0": [[1]], "Kc": [[9]], "K2": [[-1]], "K0": [[0]], "g": 9.81}"#);
    let critical = &directory.run(&["sensitivity", "one.json", "--format", "json"]).json()["critical_speeds"][0];
    for (name, expected) in [("Kc_11", 1.0 / 6.0), ("K2_11", 1.5), ("K0_11", 9.81 / 6.0), ("M_11", 0.0), ("g", 0.0)] {
        let found = critical["derivatives"][name].as_f64().unwrap();
        assert!((found - expected).abs() <= 1e-15, "{name}: {found} is not {expected}");
    }
    let text = directory.run(&["sensitivity", "one.json"]).ok();
    assert!(text.contains("each entry by itself") && !text.contains("without effect"), "{text}");
    assert!(text.contains("Kc_11") && !text.contains("K0_11"), "{text}");
}

#[test]
fn bodies_and_formulas_have_the_same_derivatives() {
    let directory = Directory::of_this_test();
    let mechanism = directory.run(&["sensitivity", "--model", "WhippleMechanism", "--format", "json"]).json();
    let formulas = directory.run(&["sensitivity", "--format", "json"]).json();
    let of = |json: &Value, name: &str| json["critical_speeds"][1]["derivatives"][name].as_f64().unwrap();
    for name in formulas["parameters"].as_object().unwrap().keys() {
        let (found, expected) = (of(&mechanism, name), of(&formulas, name));
        assert!((found - expected).abs() <= 1e-11 * expected.abs(), "{name}: {found} is not {expected}");
    }
}

#[test]
fn mistakes_are_told_as_elsewhere() {
    let directory = Directory::of_this_test();
    let message = "error: --plot chart.pdf: the name must end in .svg or .png\n";
    directory.run(&["sensitivity", "--plot", "chart.pdf"]).fails(2, message);
    let message = "error: --set mb=90: `mb` is not a parameter of Whipple; did you mean `mB`?\n";
    directory.run(&["sensitivity", "--set", "mb=90"]).fails(2, message);
    let message = "error: benchmark: the mass matrix M is singular; it must be invertible; parameters of extreme size: \
                   mB = 1e300\n";
    directory.run(&["sensitivity", "--set", "mB=1e300"]).fails(1, message);
}

#[test]
fn extreme_parameters_give_numbers_or_errors() {
    let directory = Directory::of_this_test();
    for setting in ["g=1e300", "g=1e-300", "zB=-1e150", "w=1e200", "IBxx=1e-300", "mH=1e-310", "mB=1e-200", "c=1e100"] {
        for format in ["table", "json", "csv"] {
            let run = directory.run(&["sensitivity", "--set", setting, "--format", format]);
            assert!(matches!(run.code, Some(0 | 1)), "{setting}: {}", run.stderr);
            assert!(!run.stdout.contains("NaN") && !run.stdout.contains("inf"), "{setting}: {}", run.stdout);
            assert!(run.code == Some(0) || run.stdout.is_empty(), "{setting}");
            if run.code == Some(0) && format == "json" {
                serde_json::from_str::<Value>(&run.stdout).unwrap();
            }
        }
    }
}

#[test]
fn json_is_a_parameter_file() {
    let directory = Directory::of_this_test();
    for bicycle in ["benchmark", "pista"] {
        let json = directory.run(&["sensitivity", bicycle, "--format", "json"]).ok();
        directory.write("result.json", &json);
        assert_eq!(directory.run(&["sensitivity", "result.json", "--format", "json"]).ok(), json);
    }
}

#[test]
fn machines_without_a_speed_are_told_to_have_nothing_to_rank_by() {
    let directory = Directory::of_this_test();
    let run = directory.run(&["sensitivity", "--model", "Pendulum"]);
    let note =
        "note: nothing in the model Pendulum depends on the speed, so that there are no critical speeds to rank by; ";
    assert!(run.code == Some(0) && run.stderr.starts_with(note), "{}", run.stderr);
    assert_eq!(directory.run(&["sensitivity"]).stderr, "");
}
