//! Bicycles in the names and axes of others: held against what their programs make of them, there and back.

use std::collections::BTreeMap;

use crate::Directory;

/// The same bicycles in two conventions each, by the programs that have them; `conventions.py` beside it says which.
const PAIRS: &str = include_str!("../../../../tests/data/conventions.tsv");

/// The values of a side of a pair.
fn side(pair: &str, side: &str) -> BTreeMap<String, f64> {
    let rows = PAIRS.lines().filter(|line| !line.starts_with('#')).map(|line| line.split('\t').collect::<Vec<_>>());
    let rows = rows.filter(|row| row[0] == pair && row[1] == side);
    let values: BTreeMap<_, _> = rows.map(|row| (row[2].to_owned(), row[3].parse().unwrap())).collect();
    assert!(!values.is_empty(), "{pair} has no {side}");
    values
}

/// As BicycleParameters has it.
fn text(values: &BTreeMap<String, f64>) -> String {
    values.iter().map(|(name, value)| format!("{name} = {value:?}\n")).collect()
}

/// The parameters of a file, converted.
fn converted(directory: &Directory, file: &str, to: &str) -> BTreeMap<String, f64> {
    let run = directory.run(&["convert", file, "--to", to, "--format", "json"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    let values = json["parameters"].as_object().unwrap().iter();
    let number = |value: &serde_json::Value| value.as_f64().or_else(|| value["value"].as_f64()).unwrap();
    values.map(|(name, value)| (name.clone(), number(value))).collect()
}

/// Every value of `expected` is there, to so many parts of the largest.
#[track_caller]
fn close(found: &BTreeMap<String, f64>, expected: &BTreeMap<String, f64>, tolerance: f64) {
    for (name, value) in expected {
        let found = found.get(name).unwrap_or_else(|| panic!("{name} is missing in {found:?}"));
        assert!((found - value).abs() <= tolerance * value.abs().max(1.0), "{name} is {found}, not {value}");
    }
}

/// Both ways, to the digits that the sources have.
#[test]
fn pairs_of_other_programs_come_out() {
    let directory = Directory::new("convert-pairs");
    for (pair, convention, tolerance) in [
        ("moore benchmark", "moore", 4e-15),
        // The sources have 12 digits.
        ("moore legs", "moore", 1e-11),
        ("pydy benchmark", "pydy", 4e-15),
        ("gyrostats benchmark", "gyrostats", 4e-15),
    ] {
        directory.write("paper.txt", text(&side(pair, "paper")));
        close(&converted(&directory, "paper.txt", convention), &side(pair, convention), tolerance);
    }
    for (pair, tolerance) in [
        ("moore benchmark", 4e-15),
        ("moore legs", 1e-11),
        ("pydy benchmark", 4e-15),
        ("principal browserjason", 4e-15),
        ("principal extendedoptf", 4e-14),
        ("principal moore2019", 4e-15),
    ] {
        directory.write("other.txt", text(&side(pair, pair.split(' ').next().unwrap())));
        close(&converted(&directory, "other.txt", "paper"), &side(pair, "paper"), tolerance);
    }
}

/// The front frame is one body in both, and its radii and angle are those of the published set.
#[test]
fn principal_axes_are_the_published_ones() {
    let directory = Directory::new("convert-principal");
    for (pair, tolerance) in [("principal browserjason", 4e-15), ("principal moore2019", 4e-15)] {
        let mut expected = side(pair, "principal");
        expected
            .retain(|name, _| name.starts_with("kH") || name == "alphaH" || name.starts_with("kR") && name != "kRbb");
        assert!(expected.len() > 5);
        directory.write("paper.txt", text(&side(pair, "paper")));
        close(&converted(&directory, "paper.txt", "principal"), &expected, tolerance);
    }
}

/// JBike6 computes matrices from its seven bodies, and so does the paper's bicycle that they are read as.
#[test]
fn seven_bodies_have_the_matrices_of_jbike6() {
    let directory = Directory::new("convert-jbike6");
    directory.write("bodies.txt", text(&side("jbike6 bodies", "jbike6")));
    let json: serde_json::Value = {
        let run = directory.run(&["analyze", "bodies.txt", "--format", "json"]);
        assert_eq!(run.code, Some(0), "{}", run.stderr);
        assert!(run.stderr.starts_with("note: bodies.txt: in the names of JBike6"), "{}", run.stderr);
        serde_json::from_str(&run.stdout).unwrap()
    };
    for (name, value) in side("jbike6 bodies", "matrices") {
        let (matrix, place) = name.split_at(name.len() - 2);
        let [row, column] = [0, 1].map(|at| place[at..=at].parse::<usize>().unwrap() - 1);
        let found = json["matrices"][matrix][row][column].as_f64().unwrap();
        assert!((found - value).abs() <= 1e-14 * value.abs().max(100.0), "{name} is {found}, not {value}");
    }
}

/// A script as JBike6 has them: in Latin-1, with lists of moments, expressions and settings.
const SCRIPT: &str = "% JBini_City.m\n% Created \u{a9} 2015\napp_name = 'JBike6';\ngravity = 9.80665; % gravity\n\
    weave_speed_color = [0 1 0]; % green\n\t% bike name\n\tname = 'City bike';\n\twheelbase = 1.03; %meters\n\
    \tlambda =  0.2967; %radians\n\thead_angle = pi/2-lambda;\n  offset=0.044;\n\tDrearwheel = 0.6858;\n\
    \tmrearwheel = 8.5;\n\tIrearwheel =  [0.095625 0.095625  0.19125];\n\talphaIrearwheel = 0;\n\
    \tDfrontwheel =  0.6858;\n\tmfrontwheel = 1.84;\n\ttrail = (Dfrontwheel/2*sin(lambda)-offset)/cos(lambda);\n\
    \tIfrontwheel = 0.8*mfrontwheel*Dfrontwheel^2/4.*[1/2 1/2 1];\n\talphaIfrontwheel = 0;\n\tmrider = 80;\n\
    \txcmrider = 0.3;\n\tycmrider = 1.2;\n\tIrider = [10.5 2.5 12];\n\talphaIrider = -0.26;\n\tmframe = 2.5;\n\
    \txcmframe = 0.4;\n\tycmframe = 0.6;\n\tIframe = [0.06, 0.34, 0.4];\n\talphaIframe = 0.39;\n\tmfork = 1.5;\n\
    \tucmfork = 0;\n\tvcmfork = Dfrontwheel;\n\tIfork = [0.096 0.0006 0.096];\n\talphaIfork = lambda;\n\
    \tmbasket = 0;\n\tucmbasket = 0;\n\tvcmbasket = 0;\n\tIbasket = [0.00 0.00 0.00];\n\talphaIbasket = 0;\n\
    \tmrack = 4;\n\txcmrack = 0.4;\n\tycmrack = 0.55;\n\tIrack = [0.02 0.02 0.02];\n\talphaIrack = 0;\n";

#[test]
fn scripts_of_jbike6_are_read_as_they_are() {
    let directory = Directory::new("convert-script");
    let latin: Vec<u8> = SCRIPT.chars().map(|sign| u8::try_from(u32::from(sign)).unwrap()).collect();
    assert!(std::str::from_utf8(&latin).is_err());
    directory.write("JBini_City.m", latin);
    let paper = converted(&directory, "JBini_City.m", "paper");
    let (sin, cos) = 0.2967_f64.sin_cos();
    let expected = [
        ("c", (0.3429 * sin - 0.044) / cos),
        ("lam", 0.2967),
        ("mB", 86.5),
        ("xB", (80.0 * 0.3 + 2.5 * 0.4 + 4.0 * 0.4) / 86.5),
        ("zB", -(80.0 * 1.2 + 2.5 * 0.6 + 4.0 * 0.55) / 86.5),
        ("IFxx", 0.8 * 1.84 * 0.6858 * 0.6858 / 8.0),
        ("zH", -0.6858 * cos),
        ("g", 9.80665),
    ];
    close(&paper, &expected.map(|(name, value)| (name.to_owned(), value)).into(), 4e-15);
    let text = directory.run(&["show", "JBini_City.m"]);
    assert!(text.stdout.starts_with("name = \"City bike\"\n"), "{}", text.stdout);
    assert!(text.stderr.contains("not used: `app_name`, `weave_speed_color`\n"), "{}", text.stderr);
}

/// Every form of every convention reads back to the bicycle that it was written from.
#[test]
fn every_form_is_read_again() {
    let directory = Directory::new("convert-forms");
    let run = directory.run(&["convert", "browser-jason", "--to", "paper", "--format", "json"]);
    directory.write("paper.json", run.ok());
    let paper = converted(&directory, "paper.json", "paper");
    for convention in ["paper", "moore", "pydy", "principal", "gyrostats", "jbike6", "geometry"] {
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
            if convention == "gyrostats" {
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
