//! Every kind of bad input, with its exact message; all of them end with exit code 2.

use crate::{BENCHMARK, Directory};

const EXPECTED: &str = "expected a number, or an expression such as `pi/10`";

/// The shipped benchmark with one line replaced, and the message about it.
#[track_caller]
pub fn check(test: &str, line: &str, by: &str, message: &str) {
    assert!(BENCHMARK.contains(line));
    let directory = Directory::new(&format!("mistake-{test}"));
    directory.write("bike.toml", BENCHMARK.replace(&format!("\n{line}\n"), &format!("\n{by}\n")));
    directory.run(&["analyze", "bike.toml"]).fails(2, &format!("error: {message}\n"));
    directory.run(&["show", "bike.toml"]).fails(2, &format!("error: {message}\n"));
}

/// A file, and everything that is said about it.
#[track_caller]
pub fn check_file(name: &str, text: impl AsRef<[u8]>, message: &str) {
    let directory = Directory::of_this_test();
    directory.write(name, text);
    directory.run(&["analyze", name]).fails(2, &format!("error: {message}\n"));
}

/// The benchmark with options of the command line.
#[track_caller]
pub fn check_options(options: &[&str], message: &str) {
    let directory = Directory::of_this_test();
    directory.run(&[&["analyze"], options].concat()).fails(2, &format!("error: {message}\n"));
}

#[test]
fn an_unknown_parameter_with_the_one_that_was_meant() {
    let missing = |name: &str| format!("bike.toml: missing: `{name}` (of 26 parameters)");
    let typo = "bike.toml:20: `IBx` is not a parameter of Whipple; did you mean `IBxx`?";
    check("typo", "IBxx = 9.2", "IBx = 9.2", &format!("2 problems\n{typo}\n{}", missing("IBxx")));
    let case = "bike.toml:34: `MF` is not a parameter of Whipple; did you mean `mF`?";
    check("case", "mF = 3", "MF = 3", &format!("2 problems\n{case}\n{}", missing("mF")));
    let none = "bike.toml:33: `qqq` is not a parameter of Whipple";
    check("none", "rF = 0.35", "qqq = 0.35", &format!("2 problems\n{none}\n{}", missing("rF")));
    check_options(&["--set", "MF=3"], "--set MF=3: `MF` is not a parameter of Whipple; did you mean `mF`?");
    check_options(&["--set", "qqq=3"], "--set qqq=3: `qqq` is not a parameter of Whipple");
}

#[test]
fn missing_parameters_all_at_once() {
    check("missing", "mB = 85", "", "bike.toml: missing: `mB` (of 26 parameters)");
    let few = "bike.toml: missing: `mR`, `xB`, `zB`, `mB`, `IBxx`, `IByy`, `IBzz`, `IBxz`, `xH`, `zH`, `mH`, `IHxx`, \
               `IHyy`, `IHzz`, `IHxz`, `rF`, `mF`, `IFxx`, `IFyy` (of 26 parameters)";
    let text =
        BENCHMARK.lines().take_while(|line| !line.starts_with("# Rear frame")).filter(|line| !line.starts_with("mR"));
    check_file("bike.toml", text.collect::<Vec<_>>().join("\n"), few);
}

#[test]
fn values_that_are_no_numbers() {
    check(
        "word",
        "mB = 85",
        "mB = \"heavy\"",
        &format!("bike.toml:19: `mB` is `heavy`; {EXPECTED}: `heavy` is not known"),
    );
    check(
        "cut",
        "lam = \"pi/10\"",
        "lam = \"pi/\"",
        &format!("bike.toml:9: `lam` is `pi/`; {EXPECTED}: a value is missing at the end"),
    );
    check("empty", "mB = 85", "mB = \"\"", &format!("bike.toml:19: `mB` is empty; {EXPECTED}"));
    check("array", "mB = 85", "mB = [85]", &format!("bike.toml:19: `mB` is an array; {EXPECTED}"));
    check("boolean", "mB = 85", "mB = true", &format!("bike.toml:19: `mB` is a boolean; {EXPECTED}"));
    check(
        "table",
        "mB = 85",
        "mB = { mass = 85 }",
        &format!("bike.toml:19: `mB` is a table without `value`; {EXPECTED}"),
    );
}

#[test]
fn values_that_are_not_finite() {
    check("nan", "mB = 85", "mB = nan", "bike.toml:19: `mB` is `nan`; expected a finite number");
    check("inf", "mB = 85", "mB = -inf", "bike.toml:19: `mB` is `-inf`; expected a finite number");
    check(
        "huge",
        "mB = 85",
        "mB = \"1/0\"",
        &format!("bike.toml:19: `mB` is `1/0`; {EXPECTED}: the value is not finite"),
    );
}

#[test]
fn values_outside_of_their_domain() {
    check("negative", "w = 1.02", "w = -1.02", "bike.toml:7: `w` is -1.02 m; it must be > 0");
    check("zero", "rF = 0.35", "rF = 0", "bike.toml:33: `rF` is 0 m; it must be > 0");
    check("mass", "mB = 85", "mB = -85", "bike.toml:19: `mB` is -85 kg; it must be >= 0");
    let degrees = "bike.toml:9: `lam` is 18 rad; it must be > -1.5707963267948966 and < 1.5707963267948966 (for degrees \
                   write `18 deg`)";
    check("degrees", "lam = \"pi/10\"", "lam = 18", degrees);
    let deviation = "bike.toml:19: the standard deviation of `mB` is -1; it must be >= 0";
    check("deviation", "mB = 85", "mB = { value = 85, std = -1 }", deviation);
}

#[test]
fn requirements_on_several_parameters() {
    let directory = Directory::new("mistake-requirement");
    directory.write("light.toml", BENCHMARK.replace("mH = 4", "mH = 0").replace("mF = 3", "mF = 0"));
    let run = directory.run(&["analyze", "light.toml"]);
    assert_eq!((run.code, run.stdout.as_str()), (Some(2), ""));
    assert!(run.stderr.starts_with("error: light.toml: `mH + mF` is 0"), "{}", run.stderr);
    assert!(run.stderr.ends_with("; it must be > 0\n"), "{}", run.stderr);
}

#[test]
fn parameters_given_twice() {
    check("twice", "w = 1.02", "w = 1.02\nw = 1.03", "bike.toml:8: this is not TOML: duplicate key");
    let yaml = "w: 1.02\nw: 1.03\n";
    let directory = Directory::new("mistake-twice-yaml");
    directory.write("bike.yml", yaml);
    let run = directory.run(&["analyze", "bike.yml"]);
    assert!(run.stderr.contains("\nbike.yml:2: `w` is given twice; first at bike.yml:1\n"), "{}", run.stderr);
    directory.write("bike.json", "{\n\"w\": 1,\n\"w\": 2}");
    let run = directory.run(&["analyze", "bike.json"]);
    assert!(run.stderr.contains("\nbike.json:3: `w` is given twice; first at bike.json:2\n"), "{}", run.stderr);
}

#[test]
fn everything_wrong_with_a_file_at_once() {
    let text = BENCHMARK.replace("w = 1.02", "w = -1").replace("mB = 85", "mB = nan").replace("IHxx = ", "IHx = ");
    let message = "\
4 problems
bike.toml:7: `w` is -1 m; it must be > 0
bike.toml:19: `mB` is `nan`; expected a finite number
bike.toml:28: `IHx` is not a parameter of Whipple; did you mean `IHxx`?
bike.toml: missing: `IHxx` (of 26 parameters)";
    check_file("bike.toml", text, message);
}

#[test]
fn files_that_are_not_in_their_format() {
    check_file("bike.json", "{\n  \"w\": 1,,\n}", "bike.json:2: this is not JSON: Unexpected token in object");
    check_file("list.json", "[1, 2]", "list.json:1: this is not a JSON object of parameters");
    check_file("binary.toml", b"w = 1\n\xff\xfe", "binary.toml:2: this is not UTF-8 text");
    let yaml = BENCHMARK.lines().skip(6).map(|line| line.replacen(" = ", ": ", 1) + "\n").collect::<String>();
    check_file("bike.yml", yaml.replace("mB: 85", "mB 85"), "bike.yml:13: `mB 85` is not of the form `name: value`");
    check_file("bike.txt", "w 1.02\n", "bike.txt:1: `w 1.02` is not of the form `name = value`");
    let unknown = "bike.yml:1: there is no parameterization `principle`; there are paper, moore, pydy, principal, \
                   gyrostats, libbicycle, jbike6, geometry; did you mean `principal`?";
    let indented = yaml.lines().map(|line| format!("  {line}\n")).collect::<String>();
    check_file("bike.yml", format!("parameterization: principle\nvalues:\n{indented}"), unknown);
    let outside = BENCHMARK.replace("[parameters]", "mass = 3\n[parameters]");
    check_file("bike.toml", outside, "bike.toml:5: `mass` stands outside of [parameters]");
}

#[test]
fn hostile_files_do_no_harm() {
    check_file("deep.json", "[".repeat(100_000), "deep.json:1: this is not JSON: Maximum nesting depth exceeded");
    for (name, text) in
        [("deep.toml", format!("a = {}", "[".repeat(100_000))), ("deep.txt", format!("w = {}", "(".repeat(100_000)))]
    {
        let directory = Directory::new("mistake-hostile");
        directory.write(name, text);
        assert_eq!(directory.run(&["analyze", name]).code, Some(2));
    }
}

#[test]
fn bicycles_that_are_not_there() {
    let list = "\n`carvallo bicycles` lists the bicycles";
    let message = format!("there is neither a bicycle nor a file `benchmrk`; did you mean `benchmark`?{list}");
    check_options(&["benchmrk"], &message);
    check_options(&["qqq"], &format!("there is neither a bicycle nor a file `qqq`{list}"));
    check_options(&["my-bike.toml"], "there is no file my-bike.toml");
}

#[test]
fn options_that_make_no_sense() {
    check_options(&["--speeds", "0:10:0"], "--speeds 0:10:0: the step is `0`; it must be a finite number > 0");
    check_options(&["--speeds", "5:1:1"], "--speeds 5:1:1: the range ends at 1, before it begins at 5; it must ascend");
    check_options(&["--speeds", "0:10:1e-9"], "--speeds 0:10:1e-9: the range has more than 100000 points");
    check_options(&["--speeds", "nan"], "--speeds nan: a speed is `nan`; it must be a finite number");
    check_options(&["--speeds", "-1:2:1"], "--speeds -1:2:1: a speed is -1; it must be >= 0");
    check_options(&["--gravity", "-9.81"], "--gravity -9.81: `g` is -9.81 N/kg; it must be >= 0");
    check_options(&["--set", "mB"], "--set mB: expected NAME=VALUE, such as mB=90");
    check_options(&["--set", "mb=90"], "--set mb=90: `mb` is not a parameter of Whipple; did you mean `mB`?");
    check_options(&["--set", "g=1", "--gravity", "2"], "--gravity 2: `g` is given twice; first at --set g=1");
    check_options(&["--plot", "picture.pdf"], "--plot picture.pdf: the name must end in .svg or .png");
}

#[test]
fn wrong_usage_is_told_by_its_exit_code() {
    let directory = Directory::new("mistake-usage");
    for arguments in
        [&["analyse"][..], &["analyze", "--sped", "1"], &["analyze", "--format", "xml"], &["show", "a", "b"]]
    {
        let run = directory.run(arguments);
        assert_eq!((run.code, run.stdout.as_str()), (Some(2), ""), "{}", run.stderr);
        assert!(run.stderr.starts_with("error: "), "{}", run.stderr);
    }
}
