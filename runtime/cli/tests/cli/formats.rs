//! The same bicycle from every format gives the same numbers, to the last bit.

use crate::{BENCHMARK, Directory};

/// Text as BicycleParameters 1.5 writes it, with names that are not needed here.
const TEXT: &str = "\
w = 1.02+/-0.0
c = 0.08+/-0.001
lam = 0.314159265358979323846+/-0.0
g = 9.81+/-0.0
rR = 0.3+/-0.0
mR = 2.0+/-0.0
IRxx = 0.0603+/-0.0
IRyy = 0.12+/-0.0
IRzz = 0.0603+/-0.0
xB = 0.3+/-0.0
yB = 0.0+/-0.0
zB = -0.9+/-0.0
mB = 85.0+/-0.0
IBxx = 9.2+/-0.0
IBxz = 2.4+/-0.0
IByy = 11.0+/-0.0
IBzz = 2.8+/-0.0
xH = 0.9+/-0.0
zH = -0.7+/-0.0
mH = 4.0+/-0.0
IHxx = 0.05892+/-0.0
IHxz = -0.00756+/-0.0
IHyy = 0.06+/-0.0
IHzz = 0.00708+/-0.0
rF = 0.35+/-0.0
mF = 3.0+/-0.0
IFxx = 0.1405+/-0.0
IFyy = 0.28+/-0.0
";

/// The shipped file as `name: value` lines.
fn yaml() -> String {
    let lines = BENCHMARK.lines().skip_while(|line| *line != "[parameters]").skip(1);
    lines.map(|line| line.replacen(" = ", ": ", 1) + "\n").collect()
}

/// The shipped file as a flat JSON object.
fn json() -> String {
    let yaml = yaml();
    let members = yaml.lines().filter_map(|line| line.split_once(": "));
    let members: Vec<String> = members.map(|(name, value)| format!("\"{name}\": {value}")).collect();
    format!("{{{}}}", members.join(",\n"))
}

/// The numbers of an analysis, without the name of the file.
#[track_caller]
fn numbers(directory: &Directory, file: &str, notes: &str) -> serde_json::Value {
    let run = directory.run(&["analyze", file, "--format", "json"]);
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), notes));
    let mut json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    json.as_object_mut().unwrap().remove("bicycle");
    json
}

#[test]
fn every_format_gives_the_same_numbers() {
    let directory = Directory::new("formats");
    let expected = numbers(&directory, "benchmark", "");
    let indented: String = yaml().lines().map(|line| format!("  {line}\n")).collect();
    let nested_yaml = format!("# note\nrider: True\ndescription: |\n  free: text\n\nvalues:\n{indented}");
    let members: Vec<String> = json()
        .trim_matches(['{', '}'])
        .split(",\n")
        .map(|member| {
            let (name, value) = member.split_once(": ").unwrap();
            format!(
                "{name}: {{\"value\": {}, \"std\": \"0.01\"}}",
                if value.starts_with('"') { value.to_owned() } else { format!("\"{value}\"") }
            )
        })
        .collect();
    let nested_json = format!("{{\"source\": \"a paper\", \"parameters\": {{{}}}}}", members.join(", "));
    let flat_toml: String =
        BENCHMARK.lines().filter(|line| *line != "[parameters]").map(|line| format!("{line}\n")).collect();
    for (file, text) in [
        ("bike.toml", BENCHMARK.to_owned()),
        ("flat.toml", flat_toml.clone()),
        ("toml-by-content", BENCHMARK.to_owned()),
        ("flat-by-content.txt", flat_toml),
        ("windows.toml", BENCHMARK.replace('\n', "\r\n")),
        ("marked.toml", format!("\u{feff}{BENCHMARK}")),
        ("bike.yml", yaml()),
        ("nested.yaml", nested_yaml.clone()),
        ("nested-by-content", nested_yaml),
        ("windows.yml", yaml().replace('\n', "\r\n")),
        ("yaml-by-content", yaml()),
        ("marked.yml", format!("\u{feff}{}", yaml())),
        ("marked.json", format!("\u{feff}{}", json())),
        ("flat.json", json()),
        ("nested.json", nested_json.clone()),
        ("json-by-content", nested_json),
    ] {
        directory.write(file, text);
        assert_eq!(numbers(&directory, file, ""), expected, "{file}");
    }
}

#[test]
fn text_of_bicycle_parameters_is_read_with_notes() {
    let directory = Directory::new("text");
    directory.write("BenchmarkBenchmark.txt", TEXT);
    let notes = "\
note: BenchmarkBenchmark.txt:9: `IRzz` is ignored: wheels are axisymmetric, so it equals IRxx
note: BenchmarkBenchmark.txt:11: `yB` is ignored: the bicycle is laterally symmetric
";
    assert_eq!(numbers(&directory, "BenchmarkBenchmark.txt", notes), numbers(&directory, "benchmark", ""));
}

#[test]
fn a_speed_in_a_file_is_ignored_with_a_note() {
    let directory = Directory::new("speed-in-file");
    directory.write("bike.yml", format!("v: 3.0\n{}", yaml()));
    let note = "note: bike.yml:1: `v` is ignored: the speeds come from --speeds\n";
    assert_eq!(numbers(&directory, "bike.yml", note), numbers(&directory, "benchmark", ""));
}

/// Every number of the output reads back to itself, and the output is a file that gives the same output.
#[test]
fn json_output_reads_back_bit_for_bit() {
    let directory = Directory::new("read-back");
    for bicycle in ["benchmark", "pista-rider", "crescendo", "balanceassistv1"] {
        let first = directory.run(&["analyze", bicycle, "--format", "json"]).ok();
        directory.write("result.json", &first);
        assert_eq!(directory.run(&["analyze", "result.json", "--format", "json"]).ok(), first);
        let from_stdin = directory.run_with_input(&["analyze", "-", "--format", "json"], &first).ok();
        assert_eq!(from_stdin, first);
    }
}

#[test]
fn what_show_prints_is_a_file_that_gives_the_same_numbers() {
    let directory = Directory::new("show-read-back");
    for bicycle in ["benchmark", "benchmark-2005", "fisher", "silver"] {
        let text = directory.run(&["show", bicycle]).ok();
        directory.write("shown.toml", &text);
        assert_eq!(directory.run(&["show", "shown.toml"]).ok(), text);
        let [expected, found] =
            [bicycle, "shown.toml"].map(|file| directory.run(&["analyze", file, "--format", "json"]).ok());
        assert_eq!(found, expected);
    }
}

/// The doubles nearest to pi/10 and atan(1/3), from mpmath at 50 digits.
#[test]
fn expressions_are_the_nearest_doubles() {
    let directory = Directory::new("expressions");
    for (value, bits) in [
        ("pi/10", 0.314_159_265_358_979_3_f64),
        ("18 deg", 0.314_159_265_358_979_3),
        ("atan(1/3)", 0.321_750_554_396_642_2),
    ] {
        let setting = format!("lam={value}");
        let json = directory.run(&["analyze", "--format", "json", "--set", &setting]).json();
        assert_eq!(json["parameters"]["lam"].as_f64().map(f64::to_bits), Some(bits.to_bits()), "{value}");
    }
}

/// The same bicycle, whatever its file is called.
#[test]
fn a_wrong_ending_is_no_mistake() {
    let directory = Directory::new("formats-endings");
    let json = directory.run(&["convert", "benchmark", "--to", "paper", "--format", "json"]).ok();
    let expected = directory.run(&["analyze", "--format", "csv"]).ok();
    for (name, text) in [("a.toml", json.as_str()), ("b.yaml", &json), ("c.json", BENCHMARK)] {
        directory.write(name, text);
        let run = directory.run(&["analyze", name, "--format", "csv"]);
        assert_eq!((run.code, run.stdout.as_str()), (Some(0), expected.as_str()), "{name}: {}", run.stderr);
    }
}

/// The ending of a name may be another's: tables of TOML in `.json`, also in one line or in several, and JSON behind comments in
/// `.toml`.
#[test]
fn what_is_in_a_file_counts_more_than_its_ending() {
    let directory = Directory::new("formats-endings");
    let toml = directory.run(&["show", "benchmark"]).ok();
    let plain: Vec<&str> = toml.lines().skip_while(|line| !line.starts_with("[parameters]")).skip(1).collect();
    let values = plain.iter().filter(|line| line.contains('=')).map(|line| line.split('#').next().unwrap().trim());
    let members = values.map(|line| format!("    {line},\n")).collect::<String>();
    let json = directory.run(&["analyze", "--format", "json"]).ok();
    let deviation = plain.join("\n").replace("mB = 85 ", "mB = { value = 85, std = 5 } ");
    assert!(deviation.contains("std"));
    for (name, text) in [
        ("tables.json", toml.clone()),
        ("comment.json", format!("# a bicycle {{\n{toml}")),
        ("values.json", plain.join("\n")),
        ("inline.json", deviation),
        ("lines.json", format!("parameters = {{\n{members}}}\n")),
        ("lines.toml", format!("parameters = {{\n{members}}}\n")),
        ("object.toml", json.clone()),
        ("slashes.toml", format!("// of an analysis\n/* in\nJSON */ {json}")),
        ("slashes.json", format!("// w = 1\n{json}")),
    ] {
        directory.write(name, text);
        let found = directory.run(&["analyze", name, "--format", "json"]);
        assert_eq!(found.code, Some(0), "{name}: {}", found.stderr);
        assert_eq!(
            found.json()["critical_speeds"],
            directory.run(&["analyze", "--format", "json"]).json()["critical_speeds"]
        );
    }
    for (name, text) in [
        ("matrices.json", "M = [[1, 0], [0, 1]]\nK0 = [[1, 0], [0, 1]]\n"),
        ("grouped.json", "[matrices]\nM = [[1, 0], [0, 1]]\nK0 = [[1, 0], [0, 1]]\n"),
        ("matrices.toml", "{\"M\": [[1, 0], [0, 1]], \"K0\": [[1, 0], [0, 1]]}"),
    ] {
        directory.write(name, text);
        directory.run(&["analyze", name, "--gravity", "9.81"]).ok();
    }
}

/// As of `statespace`; any text may be in a file of text.
#[test]
fn the_ending_of_a_file_names_the_format() {
    let directory = Directory::of_this_test();
    let commands = [
        &["simulate", "--speed", "5", "--duration", "1", "--step", "0.5"][..],
        &["turns", "--steer", "5 deg"],
        &["lqr", "--inputs", "Tdelta", "--speeds", "5"],
    ];
    for command in commands {
        for (name, format) in
            [("a.csv", "csv"), ("a.json", "json"), ("a.md", "markdown"), ("a.tex", "latex"), ("a.txt", "table")]
        {
            let run = directory.run(&[command, &["--output", name]].concat());
            assert_eq!(run.code, Some(0), "{}", run.stderr);
            let asked = directory.run(&[command, &["--format", format]].concat()).ok();
            assert_eq!(std::fs::read_to_string(directory.0.join(name)).unwrap(), asked, "{command:?} {format}");
        }
        let run = directory.run(&[command, &["--output", "other.txt", "--format", "latex"]].concat());
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        assert_eq!(directory.run(&[command, &["--output", "a.dat", "--format", "csv"]].concat()).code, Some(0));
        let message = "error: --output a.dat: the name must end in .json, .csv, .md, .tex or .txt\n";
        directory.run(&[command, &["--output", "a.dat"]].concat()).fails(2, message);
        let message =
            "error: --output a.csv: the ending of its name is that of another format than --format; it must be .json\n";
        directory.run(&[command, &["--output", "a.csv", "--format", "json"]].concat()).fails(2, message);
    }
    let emit = ["lqr", "--inputs", "Tdelta", "--speeds", "5", "--emit", "c", "--output", "gains.csv"];
    let message = "error: --output gains.csv: the name of this source text must end in .c or .h\n";
    directory.run(&emit).fails(2, message);
    // No table is a picture, whatever it is asked for.
    let picture = ["turns", "--format", "markdown", "--output", "a.png"];
    let message = "error: --output a.png: the ending of its name is that of another format than --format; it must be .md or .txt\n";
    directory.run(&picture).fails(2, message);
}

/// A controller by hand is no result of this program, and gains of a previous run are.
#[test]
fn source_text_takes_the_place_of_its_own_kind_alone() {
    let directory = Directory::of_this_test();
    let emit = ["lqr", "--inputs", "Tdelta", "--speeds", "5", "--emit", "c", "--output", "gains.c"];
    directory.write("gains.c", "int main(void) { return 0; }\n");
    let message = "error: --output gains.c: this file is there, and is nothing that this program wrote: give another name, or remove it\n";
    directory.run(&emit).fails(2, message);
    assert_eq!(std::fs::read_to_string(directory.0.join("gains.c")).unwrap(), "int main(void) { return 0; }\n");
    std::fs::remove_file(directory.0.join("gains.c")).unwrap();
    for _ in 0..2 {
        assert_eq!(directory.run(&emit).code, Some(0));
    }
}
