//! Modal controllability and observability along the speed.

use serde_json::Value;

use crate::Directory;

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// Lost speeds by resultants (sympy), and cosines by eigenvectors of the state matrix (scipy 1.17), of the benchmark.
#[test]
fn every_format_has_the_same_numbers() {
    let directory = Directory::of_this_test();
    let asked = ["controllability", "--inputs", "Tdelta", "--outputs", "phi"];
    let json = directory.run(&[&asked[..], &["--speeds", "3,5", "--format", "json"]].concat()).json();
    let lost = json["lost"].as_array().expect("a list");
    let expected = [("input", 0.0250778535121912), ("input", 1.41102435675689), ("output", 0.333929039134733)];
    assert_eq!(lost.len(), expected.len(), "up to 5 m/s: {lost:?}");
    for (lost, (kind, speed)) in lost.iter().zip(expected) {
        assert!(lost[kind].is_string() && (number(&lost["speed"]) - speed).abs() < 1e-11, "{lost} is not at {speed}");
    }
    let castering = &json["rows"][4];
    assert_eq!((&castering["mode"], &castering["speed"]), (&Value::from("castering"), &Value::from(5.0)));
    assert!((number(&castering["controllability"]["Tdelta"]) - 0.5409197960071368).abs() < 1e-12);
    assert!((number(&castering["observability"]["phi"]) - 0.00016186740605523482).abs() < 1e-12);

    let csv = directory.run(&[&asked[..], &["--speeds", "5", "--format", "csv"]].concat()).ok();
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "speed (m/s),mode,re (1/s),im (1/s),controllability Tdelta,observability phi");
    assert!(lines.len() == 5 && lines[1].starts_with("5.0,castering,-14.07838969279823,0.0,0.5409197960071"), "{csv}");

    let table = directory.run(&asked).ok();
    for text in [
        "lost, up to 10 m/s\n",
        "  out of reach of  Tdelta\n",
        "  out of sight of  phi\n",
        "           5  castering              -14.0784      0.5409    1.619e-4\n",
    ] {
        assert!(table.contains(text), "{text} is not in {table}");
    }
}

#[test]
fn models_without_a_speed_have_their_modes() {
    let directory = Directory::of_this_test();
    let table = directory.run(&["controllability", "--model", "Pendulum"]).ok();
    assert!(table.contains("Ttheta") && !table.contains("lost"), "{table}");
}

#[test]
fn cosines_are_drawn_and_mistakes_told() {
    let directory = Directory::of_this_test();
    let run = directory.run(&["controllability", "pista", "--plot", "c.svg", "--format", "csv"]);
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), "wrote: c.svg\n"));
    let svg = std::fs::read_to_string(directory.0.join("c.svg")).expect("a picture");
    for text in ["controllability by steer torque Tdelta", "observability in lean phi", "castering", "cosine"] {
        assert!(svg.contains(text), "{text}");
    }
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    directory
        .run(&["controllability", "--speeds", "5", "--plot", "c.svg"])
        .fails(2, "error: --plot c.svg: a picture needs a range of speeds, such as --speeds 0:10:0.1\n");
    let message =
        "error: --plot c.svg: nothing in the model Pendulum depends on the speed, so there is no graph against it\n";
    directory.run(&["controllability", "--model", "Pendulum", "--plot", "c.svg"]).fails(2, message);
    directory
        .run(&["controllability", "--outputs", "psi"])
        .fails(2, "error: --outputs psi: `psi` is an integral, which no mode is of; its rate is `psi_rate`\n");
}
