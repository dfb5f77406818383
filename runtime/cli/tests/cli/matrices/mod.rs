//! Files that give matrices in the place of parameters.

mod critical;
mod mistakes;
mod scripts;

use serde_json::Value;

use crate::{Directory, Run};

/// A chain of masses of 1 kg between walls, with springs of 1 N/m between neighbours, and dampers of as many tenths.
fn chain(count: usize) -> String {
    let matrix = |entry: &dyn Fn(usize, usize) -> f64| {
        (0..count).map(|row| (0..count).map(|column| entry(row, column)).collect()).collect::<Vec<Vec<f64>>>()
    };
    let stiffness = |row: usize, column: usize| match row.abs_diff(column) {
        0 => 2.0,
        1 => -1.0,
        _ => 0.0,
    };
    let m = matrix(&|row, column| if row == column { 1.0 } else { 0.0 });
    let c1 = matrix(&|row, column| 0.1 * stiffness(row, column));
    format!("{{\"M\": {m:?}, \"C1\": {c1:?}, \"Kc\": {:?}}}", matrix(&stiffness))
}

fn part(value: &Value, part: &str) -> f64 {
    value[part].as_f64().unwrap()
}

/// The stiffness of mode k is 2 - 2 cos(k pi / (N + 1)), and with the damping of a tenth of it at 1 m/s its eigenvalues
/// solve s^2 + stiffness s / 10 + stiffness = 0.
#[test]
fn any_number_of_coordinates_up_to_twelve() {
    let directory = Directory::new("matrices-any");
    for count in 1..=12 {
        directory.write("chain.json", chain(count));
        let arguments = ["analyze", "chain.json", "--format", "json", "--speeds", "1"];
        let json = directory.run(&arguments).json();
        let values = json["eigenvalues"][0]["values"].as_array().unwrap();
        assert_eq!(values.len(), 2 * count);
        for mode in 1..=count {
            let angle = mode as f64 * std::f64::consts::PI / (count as f64 + 1.0);
            let stiffness = 2.0 - 2.0 * angle.cos();
            let (re, im) = (-stiffness / 20.0, (stiffness - stiffness * stiffness / 400.0).sqrt());
            let near = |value: &&Value| (part(value, "re") - re).abs() + (part(value, "im").abs() - im).abs() < 1e-12;
            assert_eq!(values.iter().filter(near).count(), 2, "{count}: {re} {im}");
        }
        directory.write("result.json", directory.run(&arguments).ok());
        let mut again = directory.run(&["analyze", "result.json", "--format", "json", "--speeds", "1"]).json();
        again["name"] = json["name"].clone();
        assert_eq!(again, json);
        directory.write("shown.toml", directory.run(&["show", "chain.json"]).ok());
        let mut again = directory.run(&["analyze", "shown.toml", "--format", "json", "--speeds", "1"]).json();
        again["name"] = json["name"].clone();
        assert_eq!(again, json);
    }
    directory.write("chain.json", chain(13));
    let message = "error: chain.json:1: there are 13 coordinates; there may be at most 12\n";
    directory.run(&["analyze", "chain.json"]).fails(2, message);
}

/// A towed wheel whose tyre has a relaxation length: y' is a state and y is not, of the force F only the value is one.
///
/// With m = 2 kg, the stiffness 6 N/m and the relaxation length 0.5 m, m y'' = F and 0.5 F' + v F = -6 y', so that
/// s = 0 is left out and 2 s (0.5 s + v) + 6 = 0.
const RELAXATION: &str = r#"
M = [[2, 0], [0, 0]]
C0 = [[0, 0], [6, 0.5]]
Kc = [[0, -1], [0, 0]]
K1 = [[0, 0], [0, 1]]
"#;

#[test]
fn coordinates_of_which_only_one_is_a_state() {
    let directory = Directory::new("matrices-states");
    let lists = [
        "coordinates = [{ name = \"y\", only = \"rate\" }, { name = \"F\", only = \"position\" }]\n",
        "coordinates = { y = \"rate\", F = \"position\" }\n",
        "coordinates = { y = { only = \"rate\" }, F = { only = \"position\" } }\n",
        "coordinates = { names = [\"y\", \"F\"], only = { y = \"rate\", F = \"position\" } }\n",
    ];
    for coordinates in lists {
        directory.write("tyre.toml", format!("{coordinates}{RELAXATION}"));
        let text = directory.run(&["analyze", "tyre.toml", "--speeds", "1,4"]).ok();
        assert!(
            text.contains("with q = (y, F)\n  of y only the rate is a state\n  of F only the position is a state\n")
        );
        let json = directory.run(&["analyze", "tyre.toml", "--speeds", "1,4", "--format", "json"]).json();
        // s^2 + 2 v s + 6 = 0.
        let [oscillating, creeping] = [0, 1].map(|row| json["eigenvalues"][row]["values"].as_array().unwrap().clone());
        assert_eq!((oscillating.len(), creeping.len()), (2, 2));
        assert!((part(&oscillating[1], "re") + 1.0).abs() < 1e-14);
        assert!((part(&oscillating[1], "im") - 5_f64.sqrt()).abs() < 1e-14);
        assert!(creeping.iter().any(|value| (part(value, "re") + 4.0 - 10_f64.sqrt()).abs() < 1e-14));
    }
    let header = directory.run(&["analyze", "tyre.toml", "--speeds", "1", "--format", "csv"]).ok();
    assert_eq!(header.lines().next().map(|line| line.split(',').count()), Some(6));
}

/// y'' + (1/v + 1) y' + 4 y = 0 is at 2 m/s s^2 + 1.5 s + 4 = 0.
#[test]
fn what_is_divided_by_the_speed_has_nothing_at_rest() {
    let directory = Directory::new("matrices-rest");
    directory.write("slip.json", r#"{"M": [[1]], "C-1": [[1]], "C0": 1, "Kc": [4]}"#);
    let nothing = "Matrices slip.json: at 0 m/s there are no equations of motion, since C-1 is divided by the speed";
    let Run { code, stdout, stderr } = directory.run(&["analyze", "slip.json", "--speeds", "0,2", "--format", "csv"]);
    assert_eq!((code, stderr), (Some(0), format!("note: {nothing}: left out\n")));
    let rows: Vec<&str> = stdout.lines().skip(1).collect();
    let [row] = rows[..] else { panic!("{stdout}") };
    assert!(row.starts_with("2.0,-0.75,-1.8540496217739157,-0.75,1.8540496217739157,"), "{row}");
    directory.run(&["analyze", "slip.json", "--speeds", "0"]).fails(1, &format!("error: {nothing}\n"));
    let sweep = directory.run(&["sweep", "slip.json", "--vary", "Kc_11=1:3:1", "--eigenvalues", "0,2"]);
    let message = "error: --eigenvalues 0,2: at 0 m/s Matrices has no eigenvalues, since C-1 is divided by the speed\n";
    sweep.fails(2, message);
}

/// v F' + F = 0 has the eigenvalue -1/v.
#[test]
fn what_moves_with_the_speed_alone_has_nothing_at_rest() {
    let directory = Directory::new("matrices-rest-first-order");
    directory.write("slip.json", r#"{"M": [[0]], "C1": [[1]], "Kc": [[1]], "coordinates": {"F": "position"}}"#);
    let Run { code, stdout, stderr } = directory.run(&["analyze", "slip.json", "--speeds", "0,2", "--format", "csv"]);
    let nothing = "note: Matrices slip.json: at 0 m/s there are no equations of motion, since the rate of a coordinate of \
                   first order is multiplied by the speed alone: left out\n";
    assert_eq!((code, stderr.as_str()), (Some(0), nothing));
    assert_eq!(stdout.lines().nth(1), Some("2.0,-0.5,0.0,stable"));
}

#[test]
fn names_of_matrices_are_read_as_people_write_them() {
    let directory = Directory::new("matrices-names");
    let plain = |name: &str| match name {
        "C" | "D" => {
            format!("note: a.json:1: `{name}` is taken for `C0`, which depends on neither gravity nor speed\n")
        }
        "K" => "note: a.json:1: `K` is taken for `Kc`, which depends on neither gravity nor speed\n".to_owned(),
        _ => String::new(),
    };
    for (matrix, names) in [
        ("C-1", &["C-1", "C_-1", "Cm1", "Cminus1", "C_{-1}", "C₋₁"][..]),
        ("C0", &["C0", "C_0", "C₀", "C", "D"]),
        ("C1", &["C1", "C_1", "C₁"]),
        ("Kc", &["Kc", "K_c", "K"]),
        ("K0", &["K0", "K_0"]),
        ("K1", &["K1"]),
        ("K2", &["K2", "K_2", "K₂"]),
    ] {
        for name in names {
            directory
                .write("a.json", format!("{{\"M\": [[1, 0], [0, 1]], \"{name}\": [[1, 2], [3, 4]], \"g\": 9.81}}"));
            let run = directory.run(&["analyze", "a.json", "--speeds", "1", "--format", "json"]);
            let notes: Vec<&str> = run.stderr.lines().filter(|line| line.contains("taken for")).collect();
            assert_eq!(notes.join("\n"), plain(name).trim_end(), "{name}");
            let json: Value = serde_json::from_str(&run.stdout).unwrap();
            assert_eq!(json["matrices"][matrix], serde_json::json!([[1.0, 2.0], [3.0, 4.0]]), "{name}");
        }
    }
}

/// A mass without a spring goes on wherever it is: 0 is an eigenvalue, unless only its rate is asked for.
#[test]
fn positions_on_which_nothing_depends_are_told() {
    let directory = Directory::new("matrices-free");
    directory.write("free.toml", "M = [[1]]\nC1 = [[1]]\n");
    let Run { code, stderr, stdout } = directory.run(&["analyze", "free.toml", "--speeds", "2"]);
    let note = "note: free.toml: no force depends on the position of `q1`, so that 0 is an eigenvalue at every speed; \
                `only = \"rate\"` in `coordinates` leaves it out\n";
    assert_eq!((code, stderr.as_str()), (Some(0), note));
    assert!(stdout.contains("marginal"), "{stdout}");
    directory.write("free.toml", "coordinates = { q1 = \"rate\" }\nM = [[1]]\nC1 = [[1]]\n");
    let json = directory.run(&["analyze", "free.toml", "--speeds", "2", "--format", "json"]).json();
    assert_eq!(json["eigenvalues"][0]["verdict"], "stable");
    assert_eq!(json["eigenvalues"][0]["values"], serde_json::json!([{"re": -2.0, "im": 0.0, "mode": "real"}]));
}
