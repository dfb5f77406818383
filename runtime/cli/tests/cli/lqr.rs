//! Gains of linear quadratic regulators, and the source text that they are written as.

use std::process::Command;

use serde_json::{Value, json};

use crate::Directory;

const ASKED: [&str; 5] = ["lqr", "--inputs", "Tdelta", "--speeds", "1:8:0.5"];

/// `scipy.linalg.solve_continuous_are` of the benchmark at 2 m/s, with all weights 1.
const AT_2: [f64; 4] = [-48.193886319443095, 16.95776104501121, -14.631875451334958, 2.2678181395740706];

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|entry| entry.as_f64().expect("a number")).collect()
}

#[test]
fn every_format_has_the_same_gains() {
    let directory = Directory::of_this_test();
    let in_format = |format: &str| directory.run(&[&ASKED[..], &["--format", format]].concat());
    let json = in_format("json").json();
    let at_2 = &json["regulators"][2];
    assert_eq!(at_2["speed"], json!(2.0));
    let gains = numbers(&at_2["gains"][0]);
    assert!(gains.iter().zip(AT_2).all(|(found, expected)| (found - expected).abs() < 1e-9 * 48.0), "{gains:?}");
    assert_eq!(json["states"][2], json!({"name": "phi_rate", "label": "lean rate", "unit": "rad/s"}));
    assert_eq!(json["weights"][4], json!({"of": "Tdelta", "value": 1.0}));
    let csv = in_format("csv").ok();
    let mut lines = csv.lines();
    let heading = "speed (m/s),Tdelta by phi (N*m/rad),Tdelta by delta (N*m/rad),Tdelta by phi_rate (N*m*s/rad),";
    assert!(lines.next().expect("a heading").starts_with(heading), "{csv}");
    let row: Vec<f64> = lines.nth(2).expect("a row").split(',').map(|cell| cell.parse().expect("a number")).collect();
    assert_eq!(row[1..5], gains);
    let table = in_format("table").ok();
    assert!(table.contains("\nGains K of Tdelta = -K x\n     v (m/s)  phi (N m/rad)"), "{table}");
    assert!(
        table.contains("           2     -48.193886        16.957761            -14.631875                2.267818\n"),
        "{table}"
    );
    assert!(table.contains("           2  -9.6492, -3.0432, -2.6549 ± 1.4735 i\n"), "{table}");
    // The same, of the loop that the gains close.
    let gain = |index: usize| -gains[index];
    let law =
        format!("Tdelta = {:?}*phi + {:?}*delta + {:?}*phi_rate + {:?}*delta_rate", gain(0), gain(1), gain(2), gain(3));
    let closed = directory.run(&["analyze", "--speeds", "2", "--feedback", &law, "--format", "json"]).json();
    let mut found: Vec<f64> = closed["eigenvalues"][0]["values"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|value| value["re"].as_f64().expect("a number"))
        .collect();
    found.sort_by(f64::total_cmp);
    let own =
        at_2["eigenvalues"].as_array().expect("a list").iter().map(|value| value["re"].as_f64().expect("a number"));
    assert!(found.iter().zip(own).all(|(found, own)| (found - own).abs() < 1e-12 * 10.0), "{found:?}");
}

/// Against differences of the gains of two bicycles with other masses; in the table 1 % of the mass.
#[test]
fn sensitivities_are_slopes_of_gains() {
    let directory = Directory::of_this_test();
    let asked = ["lqr", "--inputs", "Tdelta", "--speeds", "2,4", "--format", "json"];
    let json = directory.run(&[&asked[..], &["--sensitivity"]].concat()).json();
    let gains = |mass: &str| {
        numbers(&directory.run(&[&asked[..], &["--set", mass]].concat()).json()["regulators"][1]["gains"][0])
    };
    let (low, high) = (gains("mB=84.99"), gains("mB=85.01"));
    let found = numbers(&json["regulators"][1]["sensitivities"]["mB"][0]);
    for (found, slope) in found.iter().zip(low.iter().zip(&high).map(|(low, high)| (high - low) / 0.02)) {
        assert!((found - slope).abs() < 1e-6 * slope.abs(), "{found}, expected {slope}");
    }
    assert!(directory.run(&asked).json()["regulators"][0].get("sensitivities").is_none());
    let table = directory.run(&[&asked[..5], &["--sensitivity"]].concat()).ok();
    assert!(table.contains("\nWhat 1 % of each parameter changes about the gains K of Tdelta, at 4 m/s\n"), "{table}");
    let cell = format!("{:+.6}", 0.85 * found[0]);
    assert!(table.lines().any(|line| line.starts_with("  mB ") && line.contains(&cell)), "{cell} {table}");
    let csv = ["lqr", "--inputs", "Tdelta", "--speeds", "2", "--sensitivity", "--format", "csv"];
    let message = "error: --sensitivity: CSV has no place for it; table, markdown, latex and json have\n";
    directory.run(&csv).fails(2, message);
}

/// What a program of the source text prints: for each speed the gains, and the inputs for the state (1, 2, 3, 4), as bits.
const RUST: &str = r#"
#[path = "regulator.rs"]
mod regulator;

fn main() {
    for speed in [@speeds] {
        let gains = regulator::gains(speed)[0].map(|gain| gain.to_bits());
        println!("{gains:?} {:?}", regulator::inputs(speed, &[1.0, 2.0, 3.0, 4.0])[0].to_bits());
    }
}
"#;

const C: &str = r#"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "regulator.c"

static unsigned long long bits(double value)
{
    unsigned long long bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

int main(void)
{
    const double speeds[] = {@speeds};
    const double states[] = {1.0, 2.0, 3.0, 4.0};
    unsigned int i;
    for (i = 0; i < sizeof speeds / sizeof speeds[0]; ++i) {
        double k[1][4];
        double input[1];
        regulator_gains(speeds[i], k);
        regulator_inputs(speeds[i], states, input);
        printf("[%llu, %llu, %llu, %llu] %llu\n", bits(k[0][0]), bits(k[0][1]), bits(k[0][2]), bits(k[0][3]), bits(input[0]));
    }
    return 0;
}
"#;

fn compiled(directory: &Directory, command: &mut Command) -> Option<Vec<String>> {
    let built = match command.current_dir(&directory.0).output() {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return None,
        built => built.expect("a compiler that runs"),
    };
    assert!(built.status.success() && built.stderr.is_empty(), "{}", String::from_utf8_lossy(&built.stderr));
    let run = Command::new(directory.0.join("program")).output().expect("the program");
    assert!(run.status.success());
    Some(String::from_utf8(run.stdout).expect("text").lines().map(str::to_owned).collect())
}

#[test]
fn source_text_has_the_gains_of_the_table_and_interpolates_them() {
    let directory = Directory::of_this_test();
    for (language, path) in [("rust", "regulator.rs"), ("c", "regulator.c")] {
        let run = directory.run(&[&ASKED[..], &["--emit", language, "--output", path]].concat());
        assert_eq!((run.code, run.stdout.as_str(), run.stderr), (Some(0), "", format!("wrote: {path}\n")));
    }
    let json = directory.run(&[&ASKED[..], &["--format", "json"]].concat()).json();
    let table: Vec<(f64, Vec<f64>)> = json["regulators"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|own| (own["speed"].as_f64().expect("a speed"), numbers(&own["gains"][0])))
        .collect();
    let mut asked: Vec<f64> = table.iter().map(|(speed, _)| *speed).collect();
    asked.extend([1.25, 3.9, 7.999, 0.0, -3.0, 8.5, 1e300]);
    let mut expected: Vec<String> = Vec::new();
    for speed in asked.iter().map(|speed| speed.clamp(1.0, 8.0)) {
        let upper = table.iter().position(|(own, _)| *own > speed).unwrap_or(table.len() - 1);
        let [(low, before), (high, after)] = [&table[upper - 1], &table[upper]];
        let part = (speed - low) / (high - low);
        let gains: Vec<f64> = match table.iter().find(|(own, _)| *own == speed) {
            Some((_, gains)) => gains.clone(),
            None => before.iter().zip(after).map(|(before, after)| before + part * (after - before)).collect(),
        };
        let input = gains.iter().zip([1.0, 2.0, 3.0, 4.0]).fold(0.0, |sum, (gain, state)| sum - gain * state);
        expected.push(format!(
            "{:?} {}",
            gains.iter().map(|gain| gain.to_bits()).collect::<Vec<u64>>(),
            input.to_bits()
        ));
    }
    // What is no number is held at the lower end.
    expected.push(format!(
        "{:?} {}",
        table[0].1.iter().map(|gain| gain.to_bits()).collect::<Vec<u64>>(),
        expected[0].rsplit(' ').next().expect("an input")
    ));
    let speeds: Vec<String> = asked.iter().map(|speed| format!("{speed:?}")).collect();
    directory.write("main.rs", RUST.replace("@speeds", &format!("{}, f64::NAN", speeds.join(", "))));
    directory.write("main.c", C.replace("@speeds", &format!("{}, NAN", speeds.join(", "))));
    let rustc = |arguments: &[&str]| {
        let mut command = Command::new(std::env::var_os("RUSTC").unwrap_or("rustc".into()));
        command.args(["--edition", "2021", "-D", "warnings"]).args(arguments);
        command
    };
    let found = compiled(&directory, &mut rustc(&["-o", "program", "main.rs"])).expect("rustc, which built this");
    assert_eq!(found, expected);
    directory.write("bare.rs", "#![no_std]\n#![deny(missing_docs)]\n//! Without a standard library.\n#[path = \"regulator.rs\"]\npub mod regulator;\n");
    let bare = rustc(&["--crate-type", "lib", "bare.rs"]).current_dir(&directory.0).output().expect("rustc");
    assert!(bare.status.success(), "{}", String::from_utf8_lossy(&bare.stderr));
    let strict = [
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Wpedantic",
        "-Wconversion",
        "-Wmissing-prototypes",
        "-Werror",
        "-ffp-contract=off",
    ];
    if let Some(found) = compiled(&directory, Command::new("cc").args(strict).args(["-o", "program", "main.c", "-lm"]))
    {
        assert_eq!(found, expected);
    }
    // What is written is the same in every run.
    let again = directory.run(&[&ASKED[..], &["--emit", "c"]].concat()).ok();
    assert_eq!(again, std::fs::read_to_string(directory.0.join("regulator.c")).expect("a file"));
    assert!(again.starts_with("/* Gains of a linear quadratic regulator for benchmark, scheduled along the speed.\n *\n * Inputs: Tdelta (N*m)\n"));
}

/// Where nothing depends on the speed there is none to give; and a name has no end of a comment in it.
#[test]
fn source_text_of_one_regulator_has_no_schedule() {
    let directory = Directory::of_this_test();
    directory.write("m.json", r#"{"name": "a */ b", "M": [[1]], "Kc": [[-1]]}"#);
    for language in ["rust", "c"] {
        let text = directory.run(&["lqr", "m.json", "--emit", language]).ok();
        // `k + sqrt(k^2 + q)`, and the square root of twice that and 1.
        let [first, second] = [1.0 + f64::sqrt(2.0), f64::sqrt(3.0 + 2.0 * f64::sqrt(2.0))];
        assert!(!text.contains("speed") && text.contains("for Matrices a * / b."), "{text}");
        let gains = text.lines().find(|line| line.contains("] = [[") || line.contains("] = {{")).expect("gains");
        let cells: Vec<f64> = gains
            .rsplit(" = ")
            .next()
            .expect("numbers")
            .trim_matches(|c| "[]{};".contains(c))
            .split(", ")
            .map(|cell| cell.parse().expect("a number"))
            .collect();
        assert!((cells[0] - first).abs() < 1e-14 && (cells[1] - second).abs() < 1e-14, "{cells:?}");
    }
    directory.write("main.c", "#include <stdio.h>\n#include \"m.c\"\nint main(void) { const double x[] = {1.0, 0.0}; double u[1]; regulator_inputs(x, u); printf(\"%d\\n\", (int)(u[0] * 1000.0)); return 0; }\n");
    directory.run(&["lqr", "m.json", "--emit", "c", "--output", "m.c"]);
    if let Some(found) = compiled(
        &directory,
        Command::new("cc").args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-o", "program", "main.c"]),
    ) {
        assert_eq!(found, ["-2414"]);
    }
}

#[test]
fn mistakes_and_machines_that_no_gains_hold() {
    let directory = Directory::of_this_test();
    directory
        .run(&["lqr"])
        .fails(2, "error: expected --speeds, which the equations of motion depend on, such as --speeds 1:8:0.5\n");
    directory
        .run(&["lqr", "--speeds", "5", "--weight", "Tdelta=0", "--weight", "ph_rate=1", "--inputs", "Tdelt"])
        .fails(
            2,
            "error: --inputs Tdelt: `Tdelt` is no input of Whipple; did you mean `Tdelta`?\nthey are Tphi, Tdelta\n",
        );
    directory.write("two.json", r#"{"M": [[1, 0], [0, 1]], "Kc": [[-1, 0], [0, -4]]}"#);
    directory.run(&["lqr", "two.json", "--inputs", "q1"]).fails(
        1,
        "error: Matrices two.json: Fq1 does not reach the mode with the eigenvalue 2.0000/s, which does not die away by itself: no \
         gains stabilize it\n",
    );
    let run = directory.run(&["lqr", "--inputs", "Tdelta", "--speeds", "0:1:0.5", "--format", "csv"]);
    let note = "note: between 0 and 0.5 m/s the interpolated gains do not hold it: more speeds are needed there\n";
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), note));
}

/// What is stable by itself costs least if it is left alone, where nothing but the input has a weight.
#[test]
fn without_weights_what_is_stable_is_left_alone() {
    let directory = Directory::of_this_test();
    let table = directory.run(&["lqr", "--inputs", "Tdelta", "--speeds", "5", "--weight", "phi=0"]).ok();
    let zeros = table.lines().find(|line| line.trim_start().starts_with("5 ")).expect("gains");
    assert_eq!(zeros.split_whitespace().collect::<Vec<_>>(), ["5", "0.000000", "0.000000", "0.000000", "0.000000"]);
}

#[test]
fn gains_without_units_have_no_brackets() {
    let directory = Directory::of_this_test();
    directory.write("m.json", r#"{"M": [[1]], "Kc": [[-1]]}"#);
    let table = directory.run(&["lqr", "m.json"]).ok();
    assert_eq!(
        table.lines().nth(3).map(|line| line.split("  ").filter(|name| !name.is_empty()).map(str::trim).collect()),
        Some(vec!["q1", "q1_rate (s)"]),
        "{table}"
    );
}

#[test]
fn weights_beyond_all_numbers_are_to_blame_themselves() {
    let directory = Directory::of_this_test();
    let message = "error: benchmark at 4 m/s: weights of these sizes lead beyond the range of floating-point numbers; expected ones \
                   that are nearer to 1\n";
    directory.run(&["lqr", "--inputs", "Tdelta", "--speeds", "4", "--weight", "phi=1e300"]).fails(1, message);
}
