//! Results in other units: numbers, and headings that tell the truth about them.

use crate::Directory;

/// The weave and capsize speeds of the benchmark as the paper prints them, in m/s.
const PRINTED: [f64; 2] = [4.292_382_536_341_11, 6.024_262_015_388_37];

#[track_caller]
fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-13 * expected.abs(), "{found}, not {expected}");
}

/// The line that begins so, and the number behind that.
#[track_caller]
fn number(text: &str, start: &str) -> f64 {
    let line = text.lines().find_map(|line| line.trim_start().strip_prefix(start)).unwrap_or_else(|| panic!("{text}"));
    line.split_whitespace().next().unwrap().parse().unwrap()
}

#[test]
fn speeds_are_in_the_unit_of_their_headings() {
    let directory = Directory::new("units");
    for (unit, factor) in [("km/h", 3.6), ("mph", 3600.0 / 1609.344), ("ft/s", 1.0 / 0.3048), ("cm/s", 100.0)] {
        let run = |format: &str| {
            let arguments = ["analyze", "--units", unit, "--speeds", "0,4.5,9", "--format", format];
            directory.run(&arguments).ok()
        };
        let table = run("table");
        assert!(
            table.contains(&format!("Critical speeds ({unit})\n")) && table.contains(&format!("v ({unit})")),
            "{table}"
        );
        assert!(table.contains(&format!(" {unit}\n")) && !table.contains("(m/s)"), "{table}");
        close(number(&table, "weave "), factor * PRINTED[0]);
        close(number(&table, "capsize "), factor * PRINTED[1]);
        close(number(&table, "self-stable from "), factor * PRINTED[0]);

        let csv = run("csv");
        let mut lines = csv.lines().map(|line| line.split(',').next().unwrap());
        assert_eq!(lines.next(), Some(format!("speed ({unit})").as_str()));
        lines.zip([0.0, 4.5, 9.0]).for_each(|(found, speed)| close(found.parse().unwrap(), factor * speed));

        let json: serde_json::Value = serde_json::from_str(&run("json")).unwrap();
        assert_eq!(json["speed_unit"], unit);
        close(json["critical_speeds"][1]["speed"].as_f64().unwrap(), factor * PRINTED[0]);
        close(json["stable_ranges"][0][1].as_f64().unwrap(), factor * PRINTED[1]);
        close(json["eigenvalues"][2]["speed"].as_f64().unwrap(), factor * 9.0);
        // Parameters stay as they are, and are read again.
        assert_eq!(json["parameters"]["w"], 1.02);
        directory.write("result.json", run("json")).run(&["analyze", "result.json"]).ok();

        let markdown = run("markdown");
        assert!(markdown.contains(&format!("v ({unit}) |")) && !markdown.contains("(m/s)"), "{markdown}");
    }
    let json = directory.run(&["analyze", "--format", "json"]).json();
    assert!(json.get("speed_unit").is_none());
}

/// Eigenvalues do not change, whatever the speeds are written in; and tables have round speeds of that unit.
#[test]
fn round_speeds_of_a_unit_have_the_eigenvalues_of_these_speeds() {
    let directory = Directory::new("units-round");
    let shown = directory.run(&["analyze", "--units", "km/h"]).ok();
    let speeds: Vec<String> = [0, 5, 10, 15, 20, 25, 30, 35].map(|speed| format!("{speed} km/h")).into();
    let given = directory.run(&["analyze", "--units", "km/h", "--speeds", &speeds.join(",")]).ok();
    let rows = |text: &str| -> Vec<String> {
        text.lines().skip_while(|line| !line.contains("v (km/h)")).skip(1).map(str::to_owned).collect()
    };
    assert!(rows(&shown).len() >= 8);
    assert_eq!(rows(&shown)[..8], rows(&given)[..]);
    assert!(rows(&given)[3].starts_with("       15 "), "{given}");
}

#[test]
fn pictures_and_lists_say_their_unit() {
    let directory = Directory::new("units-pictures");
    let run = directory.run(&["analyze", "--units", "km/h", "--plot", "a.svg", "--speeds", "0:10:1"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let svg = std::fs::read_to_string(directory.0.join("a.svg")).unwrap();
    assert!(svg.contains("forward speed v (km/h)") && svg.contains("weave 15.4526"), "{svg}");
    let list = directory.run(&["bicycles", "--units", "km/h"]).ok();
    assert!(list.starts_with("bicycle          weave (km/h)     capsize (km/h)   stable (km/h)"), "{list}");
    assert!(list.contains("benchmark        15.4526          21.6873          15.4526 to 21.6873"), "{list}");
}

/// What is shown in other units reads back to the same bicycle.
#[test]
fn parameters_in_other_units_are_read_again() {
    let directory = Directory::new("units-show");
    let plain = directory.run(&["convert", "pista", "--to", "paper", "--format", "json"]).json();
    for units in ["mm,deg,g", "imperial", "cm,kg*cm^2"] {
        directory.write("other.toml", directory.run(&["show", "pista", "--units", units]).ok());
        let run = directory.run(&["convert", "other.toml", "--to", "paper", "--format", "json"]);
        let other: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        for (name, value) in plain["parameters"].as_object().unwrap() {
            for member in ["value", "std"] {
                let [a, b] = [value, &other["parameters"][name]].map(|value| value[member].as_f64());
                let (a, b) = (a.unwrap(), b.unwrap());
                assert!((a - b).abs() <= 4e-16 * a.abs(), "{units}: {name} {member} is {b}, not {a}");
            }
        }
    }
    let text = directory.run(&["show", "--units", "in,lb"]).ok();
    assert!(text.contains("w = \"40.15748031496063 in\"") && text.contains("mB = \"187.39292285714595 lb\""), "{text}");
}

#[test]
fn mistakes_in_units_are_told() {
    let directory = Directory::new("units-mistakes");
    let run = |units: &str| directory.run(&["analyze", "--units", units]);
    run("furlong").fails(
        2,
        "error: --units furlong: `furlong` is no unit; expected such as mm, in, deg, kg, lb, km/h, mph or kg*cm^2\n",
    );
    run("mm,cm").fails(2, "error: --units mm,cm: `mm` and `cm` are units of the same quantity\n");
    run("").fails(2, "error: --units : expected units such as mm,deg,km/h, or imperial\n");
    let run = directory.run(&["convert", "--to", "moore", "--format", "python", "--units", "mm"]);
    run.fails(2, "error: --units: this form has no place for units; toml, json, yaml and csv have\n");
}
