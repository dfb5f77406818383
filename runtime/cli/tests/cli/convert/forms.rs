//! There and back in every form, with deviations and correlations.

use super::converted;
use crate::Directory;

/// Every form of every convention reads back to the bicycle that it was written from.
#[test]
fn every_form_is_read_again() {
    let directory = Directory::new("convert-forms");
    let run = directory.run(&["convert", "browser-jason", "--to", "paper", "--format", "json"]);
    directory.write("paper.json", run.ok());
    let paper = converted(&directory, "paper.json", "paper");
    for convention in ["paper", "moore", "pydy", "principal", "gyrostats", "libbicycle", "jbike6", "geometry"] {
        for (format, ending) in [
            ("toml", "toml"),
            ("json", "json"),
            ("yaml", "yaml"),
            ("csv", "csv"),
            ("python", "py"),
            ("matlab", "m"),
            ("text", "txt"),
        ] {
            let file = format!("{convention}.{ending}");
            let run = directory.run(&["convert", "browser-jason", "--to", convention, "--output", &file]);
            assert_eq!((run.code, run.stdout.as_str()), (Some(0), ""), "{file}: {}", run.stderr);
            let split = ["mR", "IRxx", "mF", "IFxx"].map(|name| format!("{name}={:?}", paper[name]));
            let mut arguments = vec!["convert", &file, "--to", "paper", "--format", "json"];
            if matches!(convention, "gyrostats" | "libbicycle") {
                split.iter().for_each(|setting| arguments.extend(["--set", setting.as_str()]));
            }
            let run = directory.run(&arguments);
            assert_eq!(run.code, Some(0), "{file} ({format}): {}", run.stderr);
            let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
            for (name, value) in &paper {
                let found = json["parameters"][name].as_f64().unwrap_or_else(|| panic!("{file}: {name}"));
                assert!(
                    (found - value).abs() <= 1e-14 * value.abs().max(1.0),
                    "{file}: {name} is {found}, not {value}"
                );
            }
        }
    }
}

/// Deviations of independent measurements become correlated ones in other parameters, and on the way back independent again.
#[test]
fn deviations_and_correlations_lead_back() {
    let directory = Directory::new("convert-deviations");
    let paper = directory.run(&["convert", "pista", "--to", "paper", "--format", "json"]).json();
    for convention in ["moore", "pydy", "principal", "geometry"] {
        for file in ["there.toml", "there.json"] {
            let run = directory.run(&["convert", "pista", "--to", convention, "--output", file]);
            assert_eq!(run.code, Some(0), "{}", run.stderr);
            let text = std::fs::read_to_string(directory.0.join(file)).unwrap();
            assert!(text.contains("correlations"), "{convention}: {text}");
            let run = directory.run(&["convert", file, "--to", "paper", "--format", "json"]);
            let back: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
            for (name, value) in paper["parameters"].as_object().unwrap() {
                let [a, b] = [value, &back["parameters"][name]].map(|value| value["std"].as_f64());
                let (Some(a), Some(b)) = (a, b) else { panic!("{convention}: {name}") };
                assert!((a - b).abs() <= 1e-9 * a, "{convention}: {name} +/- {b}, not {a}");
            }
            let correlations = back["correlations"].as_object().into_iter().flatten();
            for (name, others) in correlations {
                for (other, value) in others.as_object().unwrap() {
                    assert!(value.as_f64().unwrap().abs() < 1e-9, "{convention}: {name} and {other}: {value}");
                }
            }
        }
    }
}

/// What was set is exact: on the way back deviations cancel, and rounding is none.
#[test]
fn what_is_exact_stays_exact() {
    let directory = Directory::new("convert-exact");
    for (convention, setting, exact) in
        [("moore", ["head_angle=72 deg", "trail=0.06"], ["lam", "c"]), ("pydy", ["lam=0.3", "w=1"], ["lam", "w"])]
    {
        let [first, second] = setting;
        let to = ["convert", "pista", "--to", convention, "--set", first, "--set", second, "--output", "there.json"];
        assert_eq!(directory.run(&to).code, Some(0), "{convention}");
        let run = directory.run(&["convert", "there.json", "--to", "paper", "--format", "json"]);
        let back: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        for name in exact {
            assert!(back["parameters"][name].is_number(), "{convention}: {name} is {}", back["parameters"][name]);
            assert!(back["correlations"].get(name).is_none(), "{convention}: {}", back["correlations"]);
        }
        assert!(back["parameters"]["mB"]["std"].is_number(), "{convention}: {}", back["parameters"]["mB"]);
    }
}
