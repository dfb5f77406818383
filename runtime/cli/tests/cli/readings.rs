//! What would be read in another way than it was meant, silently: it is read as it was meant, or refused.

use crate::mistakes::{check, check_file, check_options};
use crate::{BENCHMARK, Directory};

const MEMBERS: &str = "expected `value`, `std` and `unit`";
const ONE_UNIT: &str = "one part has a unit and the other has none: write it behind both, or `(27 +/- 1) deg`";

/// The lines of `name = value` of the benchmark, joined in another form.
fn lines(form: fn(&str, &str) -> String) -> Vec<String> {
    let all = BENCHMARK.lines().skip_while(|line| *line != "[parameters]").skip(1);
    all.filter_map(|line| line.split_once(" = ")).map(|(name, value)| form(name, value)).collect()
}

fn shown(test: &str, file: &str, text: &str) -> String {
    Directory::new(&format!("readings-{test}")).write(file, text).run(&["show", file]).ok()
}

#[test]
fn members_have_the_unit_that_they_are_given() {
    let toml = BENCHMARK.replace("w = 1.02", "w = { value = 102, std = 0.5, unit = \"cm\" }");
    let expected = "\nw = { value = \"102 cm\", std = \"0.5 cm\" }";
    assert!(shown("unit-toml", "bike.toml", &toml).contains(expected));
    let json = format!("{{{}}}", lines(|name, value| format!("\"{name}\": {value}")).join(",\n"));
    let measured = json.replace("\"w\": 1.02", "\"w\": {\"value\": \"102 +/- 0.5\", \"unit\": \"cm\"}");
    assert!(shown("unit-json", "bike.json", &measured).contains("\nw = { value = \"102 cm\", std = \"0.5 cm\" }"));
}

#[test]
fn other_members_are_refused() {
    for (members, message) in [
        ("std_dev = 1", format!("`w` has a member `std_dev`; {MEMBERS}; did you mean `std`?")),
        ("sigma = 1", format!("`w` has a member `sigma`; {MEMBERS}; did you mean `std`?")),
        ("comment = \"tape\"", format!("`w` has a member `comment`; {MEMBERS}")),
        ("unit = \"+ 3\"", "the unit of `w` is `+ 3`; expected a unit such as `m` or `kg*m^2`".to_owned()),
        ("unit = \"kg\"", "`w` is `1.02 kg`; `kg` is no unit for it: `w` is in m".to_owned()),
    ] {
        let by = format!("w = {{ value = 1.02, {members} }}");
        check("members", "w = 1.02", &by, &format!("bike.toml:7: {message}"));
    }
    let json = lines(|name, value| match name {
        "w" => "\"w\": {\"value\": 1.02, \"uncertainty\": 0.01}".to_owned(),
        _ => format!("\"{name}\": {value}"),
    });
    let message = format!("bike.json:1: `w` has a member `uncertainty`; {MEMBERS}; did you mean `std`?");
    check_file("bike.json", format!("{{{}}}", json.join(",\n")), &message);
}

#[test]
fn a_value_and_its_deviation_are_in_one_unit() {
    let by = "lam = { value = \"18 deg\", std = 1 }";
    let message = format!("bike.toml:9: `lam` is `18 deg` with the standard deviation `1`; {ONE_UNIT}");
    check("one-unit", "lam = \"pi/10\"", by, &message);
}

#[test]
fn near_misses_of_matrices_are_refused() {
    let matrices = r#""M": [[1, 0], [0, 1]], "K0": [[1, 0], [0, 1]], "K2": [[0, 1], [0, 1]], "g": 9.81"#;
    let expected = "expected `M`, `C-1`, `C0`, `C1`, `Kc`, `K0`, `K1`, `K2`";
    for (other, message) in [
        (r#""G": [[0, 1], [1, 0]]"#, format!("`G` is no matrix; {expected}")),
        (r#""Kcc": [[0, 1], [1, 0]]"#, format!("`Kcc` is no matrix; {expected}; did you mean `Kc`?")),
        (r#""C1": 3"#, "`C1` has 1 row; expected 2 rows of 2 numbers, as `M` has".to_owned()),
    ] {
        check_file("a.json", format!("{{{matrices}, {other}}}"), &format!("a.json:1: {message}"));
        let nested = format!("{{\"matrices\": {{{matrices}, {other}}}}}");
        check_file("a.json", nested, &format!("a.json:1: {message}"));
    }
    let toml = "M = [[1, 0], [0, 1]]\nK0 = [[1, 0], [0, 1]]\ng = 9.81\nG = [[0, 1], [1, 0]]\n";
    check_file("a.toml", toml, &format!("a.toml:4: `G` is no matrix; {expected}"));
}

#[test]
fn comments_of_scripts_are_not_executed() {
    let script = lines(|name, value| format!("{name} = {};", value.trim_matches('"'))).join("\n");
    let plain = shown("script", "bike.m", &script);
    let commented = format!("%{{\nw = 3;\n%{{\nmB = 4;\n%}}\nc = 5;\n%}}\n{script}");
    assert_eq!(shown("script", "bike.m", &commented), plain);
    let open = format!("{script}\n%{{\nw = 3;");
    let at = open.lines().count();
    check_file("bike.m", open, &format!("bike.m:{at}: a comment that begins with `%{{` has no end `%}}`"));
}

#[test]
fn changes_of_values_are_refused() {
    let script = lines(|name, value| format!("{name} = {}", value.trim_matches('"'))).join("\n");
    let at = script.lines().count() + 1;
    for change in ["mB += 5", "mB -= 5", "mB *= 2", "mB /= 2"] {
        let message = format!("bike.py:{at}: `{change}` computes with an earlier value; expected `name = value`");
        check_file("bike.py", format!("{script}\n{change}\n"), &message);
    }
}

#[test]
fn values_of_yaml_stand_in_one_group() {
    let values = lines(|name, value| format!("  {name}: {}", value.trim_matches('"'))).join("\n");
    let nested = values.replace("  g: 9.81", "  rear:\n    g: 3");
    let at = 1 + nested.lines().position(|line| line == "  rear:").unwrap();
    let run = Directory::of_this_test().write("a.yml", format!("values:\n{nested}\n")).run(&["analyze", "a.yml"]);
    let message = format!("a.yml:{}: `rear` holds others; only `values:` can", at + 1);
    assert!(run.code == Some(2) && run.stderr.contains(&message), "{}", run.stderr);
    let outside = "a.yml:1: `g` stands outside of `values:`";
    check_file("a.yml", format!("g: 1.62\nvalues:\n{values}\n"), outside);
    let units = "a.yml:1: `units` is not read: values are in SI units, or have their own behind them, as in `102 cm`";
    check_file("a.yml", format!("units: mm\nvalues:\n{values}\n"), units);
}

#[test]
fn limits_of_pictures_have_a_unit_each() {
    let message = "`1` has no unit, but others have: write it behind each";
    let run = Directory::of_this_test().run(&["analyze", "--plot", "x.svg", "--xlim", "1:36 km/h"]);
    assert!(run.code == Some(2) && run.stderr.contains(message), "{}", run.stderr);
}

#[test]
fn decimals_behind_a_comma_are_no_list() {
    let message = "`02` stands behind a comma; decimals are written with a point, and a list as 1, 2";
    check_options(&["--speeds", "1,02"], &format!("--speeds 1,02: {message}"));
    let run = Directory::of_this_test().run(&["sweep", "--vary", "w=1,02"]);
    run.fails(2, &format!("error: --vary w=1,02: {message}\n"));
}

#[test]
fn sweeps_know_the_names_of_files() {
    let directory = Directory::of_this_test();
    let expected = directory.run(&["sweep", "--vary", "IBxz=2.3,2.4"]).stdout;
    assert_eq!(expected.lines().count(), 3);
    assert_eq!(directory.run(&["sweep", "--vary", "I_Bzx=2.3,2.4"]).stdout, expected);
    directory.write("a.csv", "IBzx\n2.3\n2.4\n");
    let read = directory.run(&["sweep", "--designs", "a.csv"]).stdout;
    assert_eq!(read.replace("IBzx", "IBxz"), expected);
    let run = directory.run(&["sweep", "--vary", "IBzx=2,3", "--set", "IBxz=2"]);
    run.fails(2, "error: --vary IBzx=2,3: `IBzx` is given twice; first as `IBxz` at --set IBxz=2\n");
    directory.write("a.csv", "IBzx,IBxz\n2.3,2.3\n");
    let run = directory.run(&["sweep", "--designs", "a.csv"]);
    run.fails(2, "error: a.csv: columns `IBzx` and `IBxz` are the same parameter\n");
}

/// What documentation says of values is no value, in whatever quotes and however many lines.
#[test]
fn texts_of_scripts_are_not_executed() {
    let values = lines(|name, value| format!("    self.{name} = {}\n", value.trim_matches('"'))).concat();
    let script = |text: &str| format!("class Bike:\n{text}{values}");
    let plain = shown("text", "bike.py", &script(""));
    for text in [
        "    \"\"\"A bicycle.\n\n    w = 3\n    mB = 4; c = 5\n    \"\"\"\n",
        "    r'''w = 3\n    # w = 4\n    c = 5'''\n",
        "    \"\"\"w = 3\"\"\"\n    'c = 5'\n    \"mB = 4\"\n",
        "    # one quote \"\"\" more\n",
        "    def __init__(self):\n        \"\"\"Made by: me\n        c = 5\"\"\"  # c = 6\n",
    ] {
        assert_eq!(shown("text", "bike.py", &script(text)), plain, "{text}");
        assert_eq!(shown("text", "bike.txt", &script(text)).replace("bike.txt", "bike.py"), plain, "{text}");
    }
    let headed = shown("text", "bike.py", &script("source = \"\"\"My own,\n  w = 3\"\"\"\n"));
    assert!(headed.contains("My own, w = 3") && headed.contains("\nw = 1.02 "), "{headed}");
    let open = script("    \"\"\"A bicycle.\n");
    check_file("bike.py", open, "bike.py:2: a text that begins with `\"\"\"` has no end");
}

#[test]
fn texts_of_yaml_are_not_read_as_values() {
    let values = lines(|name, value| format!("{name}: {}\n", value.trim_matches('"'))).concat();
    let plain = shown("text-yaml", "bike.yml", &format!("name: mine\n{values}"));
    for text in ["source: \"mine\n  w: 3\"\n", "source: 'it''s\n  w: 3\n  c: 4'\n"] {
        let found = shown("text-yaml", "bike.yml", &format!("name: mine\n{text}{values}"));
        let values = |text: &str| text.split_once("[parameters]").map(|(_, values)| values.to_owned());
        assert_eq!(values(&found), values(&plain), "{text}");
    }
}

/// Columns as spreadsheets write them where decimals stand after a comma; beside points, commas may be of thousands.
#[test]
fn columns_between_semicolons_may_have_decimal_commas() {
    let directory = Directory::of_this_test();
    let csv = directory.run(&["convert", "pista", "--to", "paper", "--format", "csv"]).stdout;
    directory.write("a.csv", &csv);
    directory.write("b.csv", csv.replace(',', ";").replace('.', ","));
    let json = |file: &str| directory.run(&["convert", file, "--to", "paper", "--format", "json"]).stdout;
    let parameters = |file: &str| -> serde_json::Value { serde_json::from_str(&json(file)).unwrap() };
    assert_eq!(parameters("b.csv")["parameters"], parameters("a.csv")["parameters"]);
    directory.write("c.csv", "name;value\nw;1,020\nc;0.08\n");
    let run = directory.run(&["analyze", "c.csv"]);
    assert!(run.code == Some(2) && run.stderr.contains("`w` is `1,020`; expected a number"), "{}", run.stderr);
}
