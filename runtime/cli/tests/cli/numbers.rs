//! Numbers as people write them, in every way into the program.

use crate::mistakes::check_options;
use crate::{BENCHMARK, Directory};

/// What every number of the sensitivity is, with the propagated standard deviations.
fn sensitivity(directory: &Directory, arguments: &[&str]) -> serde_json::Value {
    let mut json = directory.run(&[&["sensitivity", "--format", "json"], arguments].concat()).json();
    json.as_object_mut().unwrap().remove("bicycle");
    json
}

/// A sum instead of a mean and its standard deviation would be the worst of mistakes.
#[test]
fn a_plus_before_a_minus_is_a_standard_deviation_everywhere() {
    let directory = Directory::new("numbers-deviations");
    directory.write("clean.toml", BENCHMARK.replace("mB = 85", "mB = { value = 85, std = 5 }"));
    let expected = sensitivity(&directory, &["clean.toml"]);
    assert_ne!(expected, sensitivity(&directory, &["benchmark"]));
    let clean = directory.run(&["sweep", "--vary", "mB=85"]).stdout;
    assert!(clean.lines().count() == 2 && clean.contains(",4.29238"), "{clean}");
    let parameters: Vec<(&str, &str)> = BENCHMARK.lines().filter_map(|line| line.split_once(" = ")).skip(3).collect();
    for spelling in ["85+-5", "85.0 + - 5.0", "85+/-5", "85 ± 5", "85(5)", "85 kg +/- 5 kg", "(8.5+/-0.5)e1"] {
        let lines = |form: fn(&str, &str) -> String| {
            let line = |&(name, value): &(&str, &str)| {
                form(name, if name == "mB" { spelling } else { value.trim_matches('"') })
            };
            parameters.iter().map(line).collect::<Vec<_>>()
        };
        let [toml, yaml, text, json]: [fn(&str, &str) -> String; 4] = [
            |name, value| format!("{name} = \"{value}\""),
            |name, value| format!("{name}: {value}"),
            |name, value| format!("{name} = {value}"),
            |name, value| format!("\"{name}\": \"{value}\""),
        ];
        directory.write("bike.toml", lines(toml).join("\n")).write("bike.yml", lines(yaml).join("\n"));
        directory.write("bike.txt", lines(text).join("\n"));
        directory.write("bike.json", format!("{{{}}}", lines(json).join(",\n")));
        for file in ["bike.toml", "bike.yml", "bike.txt", "bike.json"] {
            assert_eq!(sensitivity(&directory, &[file]), expected, "{file} with {spelling}");
        }
        directory.write("shown.toml", directory.run(&["show", "bike.txt"]).ok());
        assert_eq!(sensitivity(&directory, &["shown.toml"]), expected, "show with {spelling}");
        let set = format!("mB={spelling}");
        assert_eq!(sensitivity(&directory, &["benchmark", "--set", &set]), expected, "{set}");
        // A design is a point.
        directory.write("designs.csv", format!("mB\n{spelling}\n"));
        assert_eq!(directory.run(&["sweep", "--designs", "designs.csv"]).stdout, clean, "{spelling}");
    }
}

#[test]
fn signs_that_could_mean_something_else_are_refused() {
    let expected = "expected a number, or an expression such as `pi/10`";
    let signs = "a sign after a sign; a difference has one sign, and a standard deviation `+/-` behind the whole value";
    for text in ["0.08-+0.001", "2*(0.04+-0.001)", "0.08--0.001", "--0.08"] {
        check_options(
            &["--set", &format!("c={text}")],
            &format!("--set c={text}: `c` is `{text}`; {expected}: {signs}"),
        );
    }
    let message = "--set c=0,08: `c` is `0,08`; expected a number, or an expression such as `pi/10`: decimals are written \
                   with a point, and a list has measurements such as `1.02+/-0.01, 1.03+/-0.01`";
    check_options(&["--set", "c=0,08"], message);
}

/// 20 km/h are 20/3.6 m/s.
#[test]
fn speeds_are_values_like_others() {
    let directory = Directory::new("numbers-speeds");
    let csv = |speeds: &str| directory.run(&["analyze", "--format", "csv", "--speeds", speeds]).ok();
    assert_eq!(csv("18 km/h:36 km/h:9 km/h"), csv("5:10:2.5"));
    assert_eq!(csv("18/3.6:36/3.6:9/3.6"), csv("5:10:2.5"));
    assert_eq!(csv("20 km/h:220 km/h:5 km/h").lines().count(), 42);
}
