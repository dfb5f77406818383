//! Models beside the Whipple bicycle, with one, two and three coordinates.
//!
//! Eigenvalues of the pipes are the roots of characteristic polynomials at 60 digits, from matrices that were assembled in
//! fractions from the pipes' positions, independently of the declarations.

use std::fmt::Display;

use carvallo::{MatrixName, Model, ModelInfo, States};
use serde_json::Value;

use crate::Directory;

const fn info<const N: usize, M: Model<N, Scalar = f64>>() -> &'static ModelInfo {
    M::INFO
}

const MODELS: &[&ModelInfo] = &carvallo_models::each_model!(info);

#[track_caller]
fn assert_near(value: &Value, expected: f64, tolerance: f64) {
    let value = value.as_f64().expect("a number");
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected}");
}

#[track_caller]
fn assert_eigenvalues(row: &Value, verdict: &str, expected: &[(f64, f64)]) {
    assert_eq!(row["verdict"], verdict);
    let values = row["values"].as_array().unwrap();
    assert_eq!(values.len(), expected.len(), "{values:?}");
    let part = |value: &Value, part: &str| value[part].as_f64().unwrap();
    for (re, im) in expected {
        let is_it = |value: &&Value| (part(value, "re") - re).abs() <= 1e-12 && (part(value, "im") - im).abs() <= 1e-12;
        assert_eq!(values.iter().filter(is_it).count(), 1, "{re} {im}: {values:?}");
    }
}

/// The modes of the eigenvalues at a speed, in their order.
fn modes(row: &Value) -> Vec<&str> {
    row["values"].as_array().unwrap().iter().map(|value| value["mode"].as_str().unwrap()).collect()
}

#[test]
fn three_coordinates_have_their_eigenvalues_and_verdicts() {
    let arguments = ["analyze", "--model", "ThreePipes", "--format", "json", "--speeds", "3,8"];
    let json = Directory::new("three").run(&arguments).json();
    let slow = [(-3.4987097133201472, 17.291833422413987), (-3.0488117079946875, 7.384451806347004)];
    let slow = [slow[0], slow[1], (-2.1017093479159343, 2.3179837839970916)];
    let slow: Vec<(f64, f64)> = slow.into_iter().flat_map(|(re, im)| [(re, -im), (re, im)]).collect();
    assert_eigenvalues(&json["eigenvalues"][0], "stable", &slow);
    let fast = [-25.938299903659164, -18.844657207913365, -11.288773671350647, -1.2536203743825618];
    let fast = fast.into_iter().chain([8.50118992375718, 10.756468925856252]);
    assert_eigenvalues(&json["eigenvalues"][1], "unstable", &fast.map(|re| (re, 0.0)).collect::<Vec<_>>());
    let oscillatory = ["flutter", "flutter", "oscillatory", "oscillatory", "oscillatory", "oscillatory"];
    assert_eq!(modes(&json["eigenvalues"][0]), oscillatory);
    assert_eq!(modes(&json["eigenvalues"][1]), ["flutter", "flutter", "real", "real", "real", "real"]);
    assert_eq!((&json["model"], &json["name"]), (&"ThreePipes".into(), &"hose".into()));
    // By bisection of the rightmost eigenvalue at 40 digits, with mpmath.
    let [flutter] = &json["critical_speeds"].as_array().unwrap()[..] else { panic!("{json}") };
    assert_eq!((&flutter["kind"], &flutter["change"]), (&"flutter".into(), &"destabilizes".into()));
    assert_near(&flutter["speed"], 5.639_495_351_347_755, 1e-14);
    assert_near(&flutter["eigenvalue"]["im"], 3.393_701_772_102_35, 1e-13);
    assert_eq!(json["stable_ranges"].as_array().unwrap().len(), 1);
    assert_eq!(json["stable_ranges"][0][1], flutter["speed"]);
    let matrices: Vec<&String> = json["matrices"].as_object().unwrap().keys().collect();
    assert_eq!(matrices, ["C0", "C1", "K0", "K2", "Kc", "M"]);
    // m + f = 0.5 kg/m and l = 0.5 m.
    assert_near(&json["matrices"]["M"][0][1], 1.5 * 0.5 * 0.125, 1e-15);
    assert_near(&json["matrices"]["K2"][1][2], 0.3 * 0.5, 1e-15);
}

/// Buckling, where the determinant of the stiffness is zero, which is linear in v² here.
#[test]
fn two_coordinates_have_critical_speeds_whatever_they_are() {
    let arguments = ["analyze", "--model", "twopipes", "--format", "json", "--speeds", "0,8"];
    let json = Directory::new("two").run(&arguments).json();
    let (l, f, k, weight) = (0.5_f64, 0.3, 0.5, 0.5 * 0.25 * 9.81);
    let critical = (((2.0 * k + 1.5 * weight) * (k + 0.5 * weight) - k * k) / (f * l * 0.5 * weight)).sqrt();
    let buckling =
        json["critical_speeds"].as_array().unwrap().iter().find(|found| found["kind"] == "divergence").unwrap();
    assert_near(&buckling["speed"], critical, 1e-14);
    assert_eq!(json["stable_ranges"][0][0], 0.0);
    assert_near(&json["stable_ranges"][0][1], critical, 1e-14);
    let rest = [(-1.2069705992475517, 14.919380358063888), (-0.027315115038162554, 4.13556767528038)];
    let rest: Vec<(f64, f64)> = rest.into_iter().flat_map(|(re, im)| [(re, -im), (re, im)]).collect();
    assert_eigenvalues(&json["eigenvalues"][0], "stable", &rest);
    let fast = [-27.089238239143555, -15.820096001763442, -1.0640610117476597, 8.590538109797512];
    assert_eigenvalues(&json["eigenvalues"][1], "unstable", &fast.map(|re| (re, 0.0)));
}

/// s² + c/(m l²) s + g/l = 0, whatever the speed.
#[test]
fn what_does_not_depend_on_the_speed_has_one_row() {
    let directory = Directory::new("one");
    let arguments = ["analyze", "--model", "PENDULUM", "--set", "c=3", "--set", "l=0.5"];
    let json = directory.run(&[&arguments[..], &["--format", "json"]].concat()).json();
    let half = 3.0_f64 / (2.0 * 0.25) / 2.0;
    let im = (9.81_f64 / 0.5 - half * half).sqrt();
    assert_eq!(json["eigenvalues"].as_array().unwrap().len(), 1);
    assert_eq!(json["eigenvalues"][0]["speed"], Value::Null);
    assert_eigenvalues(&json["eigenvalues"][0], "stable", &[(-half, -im), (-half, im)]);
    let csv = directory.run(&[&arguments[..], &["--format", "csv"]].concat()).ok();
    assert!(csv.starts_with("eigenvalue 1 re (1/s),eigenvalue 1 im (1/s),eigenvalue 2 re"), "{csv}");
    assert_eq!((csv.lines().count(), csv.ends_with(",stable\n")), (2, true));
    let table = directory.run(&arguments).ok();
    assert!(table.contains("M q'' + C0 q' + g K0 q = f\n  with q = (swing theta) and g = 9.81 N/kg\n"), "{table}");
    assert!(table.contains("(1/s) at every speed: nothing depends on v\n  stable "), "{table}");
    assert!(!table.contains("Critical speeds") && !table.contains("v (m/s)"), "{table}");
    let run = directory.run(&[&arguments[..], &["--speeds", "1,2"]].concat());
    let note = "note: nothing in the model Pendulum depends on the speed: --speeds is ignored\n";
    assert_eq!((run.code, run.stdout, run.stderr.as_str()), (Some(0), table, note));
}

/// Without damping and fluid all real parts are zero, up to rounding that must not decide about the order.
#[test]
fn undamped_motion_is_marginal_and_in_order() {
    let directory = Directory::new("undamped");
    for (model, count) in [("ThreePipes", 6), ("TwoPipes", 4)] {
        let arguments = ["analyze", "--model", model, "--set", "c=0", "--set", "f=0", "--format", "json"];
        let json = directory.run(&arguments).json();
        for row in json["eigenvalues"].as_array().unwrap() {
            assert_eq!(row["verdict"], "marginal");
            let im: Vec<f64> = row["values"].as_array().unwrap().iter().map(|v| v["im"].as_f64().unwrap()).collect();
            assert_eq!(im.len(), count);
            assert!(im.chunks(2).all(|pair| pair[0] < 0.0 && pair[0] == -pair[1]), "{im:?}");
            assert!(im.windows(3).all(|im| im[0].abs() < im[2].abs()), "{im:?}");
        }
    }
}

#[test]
fn a_disc_that_stays_up_is_marginal() {
    let text = Directory::new("disc").run(&["analyze", "--model", "RollingDisc", "uniform"]).ok();
    // From the square root of g r/3 on.
    assert!(text.contains("\n  marginal above 0.99045444115315"), "{text}");
    assert!(text.contains("is unstable no longer") && !text.contains("at no speed"), "{text}");
}

#[test]
fn tables_say_what_there_is() {
    let directory = Directory::new("tables");
    let text = directory.run(&["analyze", "--model", "ThreePipes"]).ok();
    assert!(text.starts_with("ThreePipes hose\n"), "{text}");
    assert!(text.contains("M q'' + (C0 + v C1) q' + (Kc + g K0 + v² K2) q = f\n"), "{text}");
    assert!(text.contains("\n  flutter      5.6394953513477"), "{text}");
    assert!(text.contains("\n  self-stable from 0 to 5.6394953513477"), "{text}");
    // Kinds are those of bicycles where there are lean and steer: to 40 digits, as above.
    let leaning = directory.run(&["analyze", "--model", "WhippleLeaning"]).ok();
    for expected in ["\n  weave        4.1176982482860", "\n  capsize      6.018303669117"] {
        assert!(leaning.contains(expected), "{expected} is not in {leaning}");
    }
    // Each mode in a column of its own.
    let row = "        3  stable     -3.048812 ± 7.384452 i   -2.101709 ± 2.317984 i   -3.498710 ± 17.291833 i\n";
    assert!(text.contains(row), "{text}");
    let title = text.lines().find(|line| line.contains("v (m/s)")).unwrap_or_default();
    assert_eq!(title.split_whitespace().collect::<Vec<_>>(), ["v", "(m/s)", "flutter", "mode", "2", "mode", "3"]);
    for unit in ["M  kg m² ", "C0 N m s ", "C1 kg m ", "Kc N m ", "K0 kg m ", "K2 kg "] {
        assert!(text.contains(&format!("\n  {unit}")), "{unit} is not in {text}");
    }
    let text = directory.run(&["analyze", "--model", "TwoPipes"]).ok();
    assert!(text.contains("\n  divergence   5.62560941690647"), "{text}");
    assert!(text.contains("  unstable  "), "{text}");
    assert!(!text.contains("weave     "), "{text}");
}

#[test]
fn csv_has_the_same_numbers_as_json() {
    let directory = Directory::new("models-csv");
    let arguments = ["analyze", "--model", "ThreePipes", "--format"];
    let text = directory.run(&[&arguments[..], &["csv"]].concat()).ok();
    let json = directory.run(&[&arguments[..], &["json"]].concat()).json();
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!((header[0], header[12], header[13]), ("speed (m/s)", "eigenvalue 6 im (1/s)", "verdict"));
    // To 8 m/s, by 0.1 m/s: beyond the flutter at 5.64.
    assert_eq!(text.lines().count(), 82);
    for (line, expected) in lines.zip(json["eigenvalues"].as_array().unwrap()) {
        let (numbers, verdict) = line.rsplit_once(',').unwrap();
        assert_eq!(verdict, expected["verdict"]);
        let numbers: Vec<f64> = numbers.split(',').map(|number| number.parse().unwrap()).collect();
        assert_eq!(Some(numbers[0]), expected["speed"].as_f64());
        let values = expected["values"].as_array().unwrap().iter();
        let values: Vec<f64> =
            values.flat_map(|value| [&value["re"], &value["im"]]).filter_map(Value::as_f64).collect();
        assert_eq!(numbers[1..], values);
    }
}

#[test]
fn the_list_has_every_model() {
    let text = Directory::new("models-list").run(&["models"]).ok();
    for info in MODELS {
        let mut lines = text.lines().skip_while(|line| !line.starts_with(&format!("{} ", info.name)));
        let columns: Vec<&str> = lines.next().unwrap().split_whitespace().collect();
        assert_eq!(columns[1], info.coordinates.len().to_string(), "{text}");
        assert_eq!(columns[2], info.parameters.len().to_string(), "{text}");
        let sets = columns[3..].join(" ");
        assert!(info.name == "Whipple" || info.sets.iter().all(|set| sets.contains(set.name)), "{text}");
        let about = lines.take_while(|line| line.starts_with("  ")).collect::<Vec<_>>().join("\n");
        let first_words: Vec<&str> = info.docs.split_whitespace().take(4).collect();
        assert!(about.contains(&first_words.join(" ")) && about.contains(info.source), "{about}");
        assert!(info.coordinates.iter().all(|coordinate| about.contains(coordinate.label)), "{about}");
    }
    assert!(text.contains("  q = (lean phi, steer delta)\n"), "{text}");
}

/// Speeds for a model that has no equations of motion at rest, of which a note is given where rest is among the speeds.
fn speeds_of(info: &ModelInfo) -> &'static [&'static str] {
    if info.matrices.contains(&MatrixName::Cm1) { &["--speeds", "1:10:1"] } else { &[] }
}

/// Whatever ships: each of its sets in every format; files choose the model by themselves.
#[test]
fn every_model_goes_through_every_format() {
    let directory = Directory::new("every-model");
    for info in MODELS {
        let sets = if info.name == "Whipple" { &[] } else { info.sets };
        let names = sets.iter().map(|set| set.name).chain((info.name == "Whipple").then_some("benchmark"));
        for name in names {
            let arguments = ["--model", info.name, name];
            let speeds = speeds_of(info);
            let run = |command: &[&str]| directory.run(&[command, &arguments].concat()).ok();
            let analyze = |options: &[&str]| run(&[&["analyze"], options, speeds].concat());
            let json = analyze(&["--format", "json"]);
            directory.write("result.json", &json).write("shown.toml", run(&["show"]));
            for file in ["result.json", "shown.toml"] {
                let again = directory.run(&[&["analyze", file, "--format", "json"], speeds].concat()).ok();
                assert_eq!(again, json, "{file} of {} {name}", info.name);
            }
            let json: Value = serde_json::from_str(&json).unwrap();
            let of_one = |states| if states == States::Both { 2 } else { 1 };
            let states: usize = info.coordinates.iter().map(|coordinate| of_one(coordinate.states)).sum();
            for row in json["eigenvalues"].as_array().unwrap() {
                assert_eq!(row["values"].as_array().unwrap().len(), states);
            }
            let table = analyze(&[]);
            let numbers = table.lines().skip_while(|line| !line.starts_with("  with q = ")).skip(1);
            let longest = numbers.map(|line| line.chars().count()).max().unwrap();
            assert!(info.coordinates.len() > 8 || longest <= 124, "{table}");
            assert!(!table.contains("NaN") && !table.contains("inf"), "{table}");
            analyze(&["--format", "csv"]);
            if info.depends_on_speed() {
                let plot = directory.run(&[&["analyze", "--plot", "picture.svg"], &arguments[..], speeds].concat());
                assert_eq!((plot.code, plot.stderr.as_str()), (Some(0), "wrote: picture.svg\n"));
            }
        }
    }
}

/// What a model displays is a file that is read back to the last bit.
#[test]
fn parameters_as_text_are_read_back() {
    fn texts<const N: usize, M: Model<N, Scalar = f64> + Display>() -> (&'static ModelInfo, Vec<[String; 2]>) {
        let sets = M::INFO.sets.iter().map(|set| M::from_slice(set.values).unwrap());
        (M::INFO, sets.map(|model| [format!("{model}"), format!("{model:#}")]).collect())
    }
    let directory = Directory::new("as-text");
    for (info, texts) in carvallo_models::each_model!(texts) {
        for (set, text) in
            info.sets.iter().zip(&texts).flat_map(|(set, texts)| texts.iter().map(move |text| (set, text)))
        {
            directory.write("parameters.txt", text);
            let arguments = ["analyze", "--model", info.name, "parameters.txt", "--format", "json"];
            let run = directory.run(&[&arguments[..], speeds_of(info)].concat());
            let json: Value = serde_json::from_str(&run.ok()).unwrap();
            for (parameter, value) in info.parameters.iter().zip(set.values) {
                assert_eq!(json["parameters"][parameter.name], *value, "{} of {}\n{text}", parameter.name, info.name);
            }
        }
    }
}

#[test]
fn a_set_may_be_spelt_in_any_case() {
    let directory = Directory::new("spelling");
    let [spelt, written] =
        ["UNI-form", "uniform"].map(|set| directory.run(&["show", "--model", "RollingDisc", set]).ok());
    assert_eq!(spelt, written);
}

#[test]
fn without_a_name_it_is_the_first_set() {
    let directory = Directory::new("first-set");
    for command in ["analyze", "show"] {
        let named = directory.run(&[command, "--model", "TwoPipes", "hose"]).ok();
        assert_eq!(directory.run(&[command, "--model", "TwoPipes"]).ok(), named);
        let bicycle = directory.run(&[command, "benchmark"]).ok();
        assert_eq!(directory.run(&[command, "--model", "whipple"]).ok(), bicycle);
    }
}

#[test]
fn files_without_a_model_are_for_the_one_that_is_named() {
    let directory = Directory::new("named-model");
    let text = "l: 0.5\nm: 0.2\nf: 0.3\nk: 1/2\nc: 0.01\ng: 9.81\n";
    directory.write("hose.yml", text).write("mine.txt", format!("model = TwoPipes\n{}", text.replace(':', " =")));
    let csv = |arguments: &[&str]| directory.run(&[&["analyze", "--format", "csv"], arguments].concat()).ok();
    assert_eq!(csv(&["--model", "TwoPipes", "hose.yml"]), csv(&["--model", "TwoPipes"]));
    assert_eq!(csv(&["--model", "ThreePipes", "hose.yml"]), csv(&["--model", "ThreePipes"]));
    assert_eq!(csv(&["mine.txt"]), csv(&["--model", "TwoPipes"]));
}
