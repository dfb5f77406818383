//! What is said where model and parameters do not fit together.

use carvallo::Model;

use crate::mistakes::{check_file, check_options};
use crate::{BENCHMARK, Directory};

const PIPES: &str = "model = \"TwoPipes\"\n[parameters]\nl = 0.5\nm = 0.2\nf = 0.3\nk = 0.5\nc = 0.01\ng = 9.81\n";

fn known() -> String {
    const fn name<const N: usize, M: Model<N, Scalar = f64>>() -> &'static str {
        M::INFO.name
    }
    format!("\nthe models are {}", carvallo_models::each_model!(name).join(", "))
}

#[test]
fn models_that_are_not_there() {
    let known = known();
    let message = format!("--model Pendulm: there is no model `Pendulm`; did you mean `Pendulum`?{known}");
    check_options(&["--model", "Pendulm"], &message);
    check_options(&["--model", "qqq"], &format!("--model qqq: there is no model `qqq`{known}"));
    let message = format!("bike.toml: there is no model `Whippel`; did you mean `Whipple`?{known}");
    check_file("bike.toml", BENCHMARK.replace("[parameters]", "model = \"Whippel\"\n[parameters]"), &message);
}

#[test]
fn parameter_sets_that_are_not_there() {
    let list = "\n`carvallo models` lists the parameter sets";
    let neither = "there is neither a parameter set of TwoPipes nor a file";
    check_options(&["--model", "TwoPipes", "hoes"], &format!("{neither} `hoes`; did you mean `hose`?{list}"));
    check_options(&["--model", "TwoPipes", "qqq"], &format!("{neither} `qqq`{list}"));
    check_options(&["--model", "TwoPipes", "mine.toml"], "there is no file mine.toml");
}

#[test]
fn parameter_sets_of_another_model() {
    let list = "\n`carvallo models` lists the parameter sets";
    let message = "there is neither a parameter set of TwoPipes nor a file `pista`; it belongs to `--model Whipple`";
    check_options(&["--model", "TwoPipes", "pista"], &format!("{message}{list}"));
    let list = "\n`carvallo bicycles` lists the bicycles";
    let message = "there is neither a bicycle nor a file `seconds`; it belongs to `--model Pendulum`";
    check_options(&["seconds"], &format!("{message}{list}"));
    let message = "there is neither a bicycle nor a file `pendulum`; it is a model: `--model Pendulum`";
    check_options(&["pendulum"], &format!("{message}{list}"));
}

#[test]
fn files_for_another_model() {
    let directory = Directory::new("mistake-other-model");
    directory.write("hose.toml", PIPES).write("bike.toml", BENCHMARK);
    let message = "hose.toml: the parameters are for the model `TwoPipes`, but --model is Pendulum";
    for command in ["analyze", "show"] {
        directory.run(&[command, "hose.toml", "--model", "pendulum"]).fails(2, &format!("error: {message}\n"));
    }
    let json = directory.run(&["analyze", "--format", "json"]).ok();
    let message = "error: <stdin>: the parameters are for the model `Whipple`, but --model is TwoPipes\n";
    directory.run_with_input(&["analyze", "-", "--model", "TwoPipes"], &json).fails(2, message);
    // Without a model of its own, a file is held against the one that was asked for.
    let run = directory.run(&["analyze", "bike.toml", "--model", "TwoPipes"]);
    assert_eq!((run.code, run.stdout.as_str()), (Some(2), ""));
    assert!(run.stderr.contains("\nbike.toml:7: `w` is not a parameter of TwoPipes\n"), "{}", run.stderr);
    assert!(run.stderr.contains("\nbike.toml: missing: `l`, `m`, `f`, `k` (of 6 parameters)\n"), "{}", run.stderr);
}

#[test]
fn parameters_of_another_model() {
    let change = |from: &str, to: &str| PIPES.replace(from, to);
    check_file("a.toml", change("l = 0.5", "l = 0"), "a.toml:3: `l` is 0 m; it must be > 0");
    check_file("a.toml", change("k = 0.5\n", ""), "a.toml: missing: `k` (of 6 parameters)");
    let unit = "`mN` is no unit for it: `k` is in N m/rad";
    check_file("a.toml", change("k = 0.5", "k = \"5 mN\""), &format!("a.toml:6: `k` is `5 mN`; {unit}"));
    let both = "2 problems\na.toml:6: `IRzz` is not a parameter of TwoPipes\na.toml: missing: `k` (of 6 parameters)";
    check_file("a.toml", change("k = 0.5", "IRzz = 1"), both);
    let start = "it has no parameters; `carvallo show --model TwoPipes` prints a file to start from";
    check_file("a.toml", "model = \"TwoPipes\"", &format!("a.toml: {start}"));
    check_options(&["--model", "TwoPipes", "--set", "rR=1"], "--set rR=1: `rR` is not a parameter of TwoPipes");
    check_options(&["--model", "TwoPipes", "--gravity", "-1"], "--gravity -1: `g` is -1 N/kg; it must be >= 0");
}

#[test]
fn wheels_that_there_cannot_be() {
    let options = ["--model", "WhippleTyres", "--set", "rF=0.25", "--set", "rhoF=0.5"];
    check_options(&options, "benchmark: `rF - rhoF` is -0.25 m; it must be >= 0");
}

#[test]
fn pictures_that_there_cannot_be() {
    let message = "--plot x.svg: nothing in the model Pendulum depends on the speed, so there is no graph against it";
    check_options(&["--model", "Pendulum", "--plot", "x.svg"], message);
    let directory = Directory::new("mistake-side-view");
    let run = directory.run(&["show", "--model", "TwoPipes", "--plot", "x.svg"]);
    run.fails(1, "error: the model TwoPipes has no side view\n");
    assert_eq!(std::fs::read_dir(&directory.0).unwrap().count(), 0);
}
