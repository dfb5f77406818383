//! State spaces with inputs and outputs.

use serde_json::{Value, json};

use crate::Directory;

/// Of the matrices that Meijaard et al. (2007) print, at 5 m/s, by numpy.
const LEAN: [f64; 5] =
    [9.489774446773556, -22.85146662520648, -0.527612249028441, -1.6525769949615603, -0.12409202541157413];

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|entry| entry.as_f64().expect("a number")).collect()
}

#[test]
fn every_format_has_the_same_numbers() {
    let directory = Directory::of_this_test();
    let asked = ["statespace", "--speed", "5", "--inputs", "Tdelta", "--outputs", "phi,yaw rate", "--format"];
    let json = directory.run(&[&asked[..], &["json"]].concat()).json();
    assert_eq!((&json["bicycle"], &json["speed"]), (&json!("benchmark"), &json!(5.0)));
    assert_eq!(json["inputs"], json!([{"name": "Tdelta", "label": "steer torque", "unit": "N*m"}]));
    assert_eq!(json["outputs"][1], json!({"name": "psi_rate", "label": "yaw rate", "unit": "rad/s"}));
    let lean: Vec<f64> = numbers(&json["A"][2]).into_iter().chain(numbers(&json["B"][2])).collect();
    assert!(lean.iter().zip(LEAN).all(|(found, expected)| (found - expected).abs() < 1e-12), "{lean:?}");
    assert_eq!((numbers(&json["C"][0]), numbers(&json["D"][0])), (vec![1.0, 0.0, 0.0, 0.0], vec![0.0]));

    let csv = directory.run(&[&asked[..], &["csv"]].concat()).ok();
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "of,phi (rad),delta (rad),phi_rate (rad/s),delta_rate (rad/s),Tdelta (N*m)");
    let row: Vec<&str> = lines[3].split(',').collect();
    assert_eq!((lines.len(), row[0]), (7, "phi_rate' (rad/s^2)"));
    assert_eq!(row[1..].iter().map(|cell| cell.parse().expect("a number")).collect::<Vec<f64>>(), lean);

    let table = directory.run(&[&asked[..], &["table"]].concat()).ok();
    assert!(table.contains("  phi_rate'      9.489774  -22.851467   -0.527612   -1.652577\n"), "{table}");
    assert!(table.contains("  output y    psi_rate    yaw rate      rad/s\n"), "{table}");
}

#[test]
fn the_ending_of_a_file_tells_its_format() {
    let directory = Directory::of_this_test();
    for (name, beginning) in [
        ("x.npz", &b"PK\x03\x04"[..]),
        ("x.MAT", b"MATLAB 5.0 MAT-file"),
        ("x.json", b"{\n  \"model\": \"Pendulum\""),
        ("x.csv", b"of,theta (rad),"),
        ("x.txt", b"Pendulum seconds\n"),
    ] {
        let run = directory.run(&["statespace", "--model", "Pendulum", "--output", name]);
        assert_eq!((run.code, run.stdout, run.stderr), (Some(0), String::new(), format!("wrote: {name}\n")));
        assert!(std::fs::read(directory.0.join(name)).expect("a file").starts_with(beginning), "{name}");
    }
    let formats = ["statespace", "--model", "Pendulum", "--format", "csv", "--output", "x.npz"];
    let message =
        "error: --output x.npz: the ending of its name is that of another format than --format; it must be .csv\n";
    directory.run(&formats).fails(2, message);
    // Any text may be in a file of text.
    let text = ["statespace", "--model", "Pendulum", "--format", "latex", "--output", "y.txt"];
    assert_eq!(directory.run(&text).code, Some(0));
}

#[test]
fn mistakes_are_told_at_once() {
    let directory = Directory::of_this_test();
    directory.run(&["statespace", "--speed", "5", "--inputs", "Tdelt", "--outputs", "phi, lean"]).fails(
        2,
        "error: 2 problems\n--inputs Tdelt: `Tdelt` is no input of Whipple; did you mean `Tdelta`?\nthey are Tphi, Tdelta\n\
         --outputs lean: it is named twice\n",
    );
    directory
        .run(&["statespace"])
        .fails(2, "error: expected --speed V, which the equations of motion depend on, such as --speed 5\n");
    directory.run(&["statespace", "--speed", "5", "--output", "phi"]).fails(
        2,
        "error: --output phi: the name must end in .npz, .mat, .json, .csv, .md, .tex or .txt; an output of the state space is --outputs \
         phi\n",
    );
    directory.run(&["statespace", "--model", "Car", "--speed", "0"]).fails(
        1,
        "error: Car oversteering at 0 m/s: the speed is 0 m/s, and the damping C-1/v has no value there; it must not be 0\n",
    );
    let run = directory.run(&["statespace", "--model", "Pendulum", "--speed", "3"]);
    let ignored = "note: nothing in the model Pendulum depends on the speed: --speed is ignored\n";
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), ignored));
}
