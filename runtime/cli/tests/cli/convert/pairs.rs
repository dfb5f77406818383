//! Bicycles that other programs have in two conventions each.

use super::{close, converted, side, text};
use crate::Directory;

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
